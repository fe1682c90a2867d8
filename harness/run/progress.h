/* How far a long command has come, on stderr: a bar with rate and time left if stderr is a terminal, else a
 * line now and then; nothing when quiet.  Precision-independent: compiled once, as C.
 *
 * One progress at a time: it owns the last line of the terminal. */
#ifndef FATLINE_PROGRESS_H
#define FATLINE_PROGRESS_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

void progress_set_quiet(bool quiet);                /* --quiet: nothing is shown until further notice */
void progress_begin(const char *label, long total); /* total 0: not known; the label is copied */
void progress_step(void);                           /* one of total is done */
void progress_note(const char *format, ...)         /* a message line above the bar, shown even when quiet */
    __attribute__((format(printf, 1, 2)));
void progress_end(void); /* takes the bar away; a last plain line if lines were shown */

#ifdef __cplusplus
}
#endif
#endif
