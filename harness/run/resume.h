/* Rows that are written to a file and, after an interruption, continued there.  Precision-independent:
 * compiled once, as C.
 *
 * Rows come in groups (all algorithms on one family, or on one case), each written at once.  When a file is
 * resumed, a torn last line and an incomplete last group are cut off, what is complete is not done again, and
 * the rows that follow carry the run id of the first. */
#ifndef FATLINE_RESUME_H
#define FATLINE_RESUME_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

struct resume {
    FILE *out;      /* stdout if no file was asked for */
    json_t *groups; /* name: rows, of the complete groups */
    int done;       /* how many */
    char error[512];
};

/* An option that changes no result. */
struct resume_option {
    char letter;      /* 0: none */
    const char *name; /* NULL: the end of a list */
    bool valued;
};

/* group: its name for a row, a malloc'd text; NULL: the row has none. */
struct resume_rule {
    char *(*group)(const json_t *row);
    int rows;                         /* of a complete group */
    const struct resume_option *idle; /* beside --resume and --output; NULL: none */
};

/* path NULL: standard output.  Writes the environment line unless the file is continued; continuing needs the
 * same program, precision and arguments but for idle options.  Returns 0, or an exit status with r->error: 2
 * if the file cannot be read or written, 64 if it is of another command, 65 if it is neither absent, nor
 * empty, nor of a run; where the status is not 0 the file is as it was. */
int resume_open(struct resume *r, const char *path, bool resume, const struct resume_rule *rule,
                json_t *environment);
bool resume_has(const struct resume *r, const char *group);
/* True on success; else errno says why.  Standard output is left open (standard_output.h). */
bool resume_close(struct resume *r);

#ifdef __cplusplus
}
#endif
#endif
