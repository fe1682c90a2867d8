/* An answer for people: where, how sure, how wide.  Compiled for each precision. */
#ifndef FATLINE_ANSWER_TABLE_H
#define FATLINE_ANSWER_TABLE_H

#include "answer.h"

/* p: the problem that was solved, for the points of f; message: what went wrong, or NULL. */
void answer_table_write(FILE *stream, const struct answer *a, const struct problem *p, const char *message);

#endif
