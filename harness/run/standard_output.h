/* Standard output is closed at the end, and it is said if something of it was lost.  Precision-independent:
 * compiled once, as C. */
#ifndef FATLINE_STANDARD_OUTPUT_H
#define FATLINE_STANDARD_OUTPUT_H

#ifdef __cplusplus
extern "C" {
#endif

/* To be called first.  However the program then ends of itself (--help too): where standard output could not
 * be written, "PROGRAM: standard output: REASON" and status 2; where nobody reads it any more, the silent
 * end by SIGPIPE that is usual, also if that signal was ignored meanwhile. */
void standard_output_watch(void);

#ifdef __cplusplus
}
#endif
#endif
