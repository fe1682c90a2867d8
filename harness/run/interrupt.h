/* An interruption (SIGINT or SIGTERM) is taken note of, so that what was begun is ended in order; the second
 * one ends the program at once.  Precision-independent: compiled once, as C. */
#ifndef FATLINE_INTERRUPT_H
#define FATLINE_INTERRUPT_H

#include <signal.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { INTERRUPTED = 130 }; /* the exit status */

extern volatile sig_atomic_t interrupted;

/* also: called by the handler, or NULL. */
void interrupt_watch(void (*also)(void));

#ifdef __cplusplus
}
#endif
#endif
