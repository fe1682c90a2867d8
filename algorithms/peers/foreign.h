/* Other people's intersection code behind our interface: what is known of each, and what can be asked of it
 * beside `intersect`.  Only builds for doubles have any. */
#ifndef FATLINE_FOREIGN_H
#define FATLINE_FOREIGN_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct foreign;

/* How one is reached: a shared object in this process, or a program over a pipe. */
struct foreign_kind {
    bool in_process; /* a crash, a hang or a lost stack is this process's own */
    /* NULL: it is absent. */
    const char *(*version)(const struct foreign *x);
    /* Why it is absent; NULL: it is not. */
    const char *(*absent)(const struct foreign *x);
    /* Over a pipe only: from here on problem_solve merely hands the problem over (SOLVED, no records), until
     * `collected` says how many arrived. */
    void (*collect)(const struct foreign *x);
    int (*collected)(const struct foreign *x);
    /* CPU nanoseconds of so many passes over what was collected, or the shortest of so
     * many passes for each; measured in the program itself.  False: it failed. */
    bool (*time)(const struct foreign *x, int passes, double *ns);
    bool (*each)(const struct foreign *x, int passes, int count, double *ns);
    /* Seconds that a program may take for one pair (10). */
    void (*set_timeout)(double seconds);
};

struct foreign {
    const struct foreign_kind *kind;
    const char *file;    /* in build/peers */
    const char *solver;  /* the name that the program knows it by; NULL: not a program */
    const char *licence; /* SPDX */
    const char *needs;   /* what to install for it */
    bool polished;       /* two Newton steps on each root are part of it */
};

#ifdef __cplusplus
}
#endif
#endif
