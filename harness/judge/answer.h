/* A line of `fatline solve`: what one algorithm said of one case.  Compiled for each precision.
 *
 * {"id","algorithm","precision","tolerance","outcome","crossings":[{"t":[lo,hi],"s":[lo,hi],"standing",
 *  "at_most","multiplicity","point":[x,y]}],"overlaps":[{"t_outer","t_inner","s_outer","s_inner","reversed","exact",
 *  "distance"}],"steps"}; doubles as numbers that read back bit for bit, quad and multi as strings. */
#ifndef FATLINE_ANSWER_H
#define FATLINE_ANSWER_H

#include <jansson.h>
#include <stdio.h>

#include "../../algorithms/bezier.h"

struct answer {
    const char *id, *algorithm;
    real tolerance;
    enum outcome outcome;
    long steps;
    bool points_only; /* judged by points: the intervals are guesses */
    struct crossings *crossings;
};

/* f: of the case, for the points, or NULL: they are not written.  extra: an object whose members follow those
 * above, or NULL; it stays the caller's. */
void answer_write(FILE *stream, const struct answer *a, const struct curve *f, json_t *extra);

/* Reads a line that an external program wrote; id and algorithm are copied into the given buffers, the
 * records into a->crossings, which the caller supplies.  Beside the fields above it may have
 * "points_only":true.  Only id, outcome and, when SOLVED, crossings are needed: the tolerance, the steps and
 * counts are else 0, the algorithm "", the standing CANDIDATE.  Numbers may be texts at every precision
 * (number.h). NULL on success, else a message that names the field. */
const char *answer_read(const char *text, struct answer *a, char id[256], char algorithm[128]);

#endif
