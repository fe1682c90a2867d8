/* Result rows: one JSON object a line, after one line that says under which circumstances they were measured.
 * Precision-independent: compiled once, as C. */
#ifndef FATLINE_ROW_H
#define FATLINE_ROW_H

#include <jansson.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { ROW_SCHEMA = 1 };

/* The environment line: {"environment":{...}} with schema, run id, program, arguments, precision, CPU,
 * kernel, compiler and flags, libraries as resolved, commit and dirty flag, governor or "unknown", load,
 * time. */
json_t *row_environment(int argc, char **argv, const char *precision);
const char *row_run_id(void); /* of this process; every row carries it as "run" */
void row_continue_run(
    const char *id); /* from here on this is the id: rows go on that another process began */
/* Writes `row` (stolen) on one line with "run" added. */
void row_write(FILE *stream, json_t *row);

#ifdef __cplusplus
}
#endif
#endif
