/* A line of `fatline solve`: what one algorithm said of one case.  Compiled for each precision.
 *
 * {"id","algorithm","precision","tolerance","outcome","crossings":[{"t":[lo,hi],"s":[lo,hi],"standing",
 *  "at_most","multiplicity"}],"overlaps":[{"t_outer","t_inner","s_outer","s_inner","reversed","exact",
 *  "distance"}],"steps"}; doubles as numbers that read back bit for bit, quad and multi as strings. */
#ifndef FATLINE_ANSWER_H
#define FATLINE_ANSWER_H

#include <jansson.h>
#include <stdio.h>

#include "../algorithms/bezier.h"

struct answer {
    const char *id, *algorithm;
    real tolerance;
    enum outcome outcome;
    long steps;
    bool points_only; /* judged by points: the intervals are guesses */
    struct crossings *crossings;
};

void answer_write(FILE *stream, const struct answer *a, json_t *extra); /* extra: more fields, or NULL */

/* Reads a line that an external program wrote; id and algorithm are copied into the given buffers.
 * NULL on success, else a message that names the field. */
const char *answer_read(const char *text, struct answer *a, char id[256], char algorithm[128]);

#endif
