/* What a line says of its intersections against what exact algebra says. */
#ifndef FATLINE_TRUTH_COMPARE_H
#define FATLINE_TRUTH_COMPARE_H

#include "../cases/case.h"

/* `said` is as the line stood, `found` the same case after exact_solve; parameters may differ by `within`.
 * Compares "class" and "expected" where they were given, and "planted", "planted_overlap" and
 * "planted_count", which a generator knows by construction.  Writes a line a difference, "file:line: id:
 * ...", and returns their number. */
int truth_compare(FILE *stream, const struct test_case *said, const struct test_case *found, double within);

#endif
