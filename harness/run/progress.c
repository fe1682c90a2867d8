#include "progress.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

enum { BAR_WIDTH = 28 };
static const double redraw_after = 0.1; /* seconds between drawings on a terminal */
static const double line_after = 10;    /* seconds between plain lines elsewhere */

static bool quiet;
static struct {
    char label[80];
    long total, done;
    double start, shown; /* times; shown: of the last drawing or line */
    bool active, terminal, colour, drawn;
} now;

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* "47s", "3m05s", "2h07m". */
static void duration_text(double s, char text[24])
{
    long n = (long)(s + 0.5);
    if (n < 60)
        snprintf(text, 24, "%lds", n);
    else if (n < 3600)
        snprintf(text, 24, "%ldm%02lds", n / 60, n % 60);
    else
        snprintf(text, 24, "%ldh%02ldm", n / 3600, n / 60 % 60);
}

/* "label 120/500 24% 812/s 1m05s left" */
static void status_text(char *text, size_t size, double elapsed)
{
    char left[24];
    double rate = elapsed > 0 ? (double)now.done / elapsed : 0;
    int n = snprintf(text, size, "%s %ld", now.label, now.done);
    if (now.total > 0)
        n += snprintf(text + n, size - (size_t)n, "/%ld %ld%%", now.total, 100 * now.done / now.total);
    n += snprintf(text + n, size - (size_t)n, " %.*f/s", rate < 10 ? 1 : 0, rate);
    if (now.total > now.done && now.done > 0) {
        duration_text((double)(now.total - now.done) / rate, left);
        snprintf(text + n, size - (size_t)n, " %s left", left);
    }
}

static void erase(void)
{
    if (now.drawn)
        fputs("\r\033[K", stderr);
    now.drawn = false;
}

static int terminal_width(void)
{
    struct winsize size;
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) || size.ws_col < 2 ? 80 : size.ws_col;
}

static void show(double time)
{
    char text[240], bar[BAR_WIDTH + 1];
    status_text(text, sizeof text, time - now.start);
    now.shown = time;
    if (!now.terminal) {
        fprintf(stderr, "%s\n", text);
        return;
    }
    erase();
    int width = terminal_width() - 1;
    if (now.total > 0 && (int)strlen(text) + BAR_WIDTH + 3 <= width) {
        int full = (int)((double)BAR_WIDTH * (double)now.done / (double)now.total);
        memset(bar, '.', BAR_WIDTH);
        memset(bar, '#', (size_t)(full < BAR_WIDTH ? full : BAR_WIDTH));
        bar[BAR_WIDTH] = 0;
        fprintf(stderr, now.colour ? "\033[32m[%s]\033[0m " : "[%s] ", bar);
    }
    fprintf(stderr, "%.*s", width, text);
    fflush(stderr);
    now.drawn = true;
}

void progress_set_quiet(bool wanted)
{
    quiet = wanted;
}

void progress_begin(const char *label, long total)
{
    const char *no_colour = getenv("NO_COLOR"), *term = getenv("TERM");
    erase();
    snprintf(now.label, sizeof now.label, "%s", label);
    now.total = total;
    now.done = 0;
    now.start = now.shown = seconds();
    now.active = true;
    now.terminal = isatty(STDERR_FILENO) && term && strcmp(term, "dumb");
    now.colour = now.terminal && !(no_colour && *no_colour);
}

void progress_step(void)
{
    if (!now.active)
        return;
    now.done++;
    if (quiet)
        return;
    double time = seconds();
    if (time - now.shown >= (now.terminal ? redraw_after : line_after))
        show(time);
}

void progress_note(const char *format, ...)
{
    va_list arguments;
    erase();
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

void progress_end(void)
{
    double time = seconds();
    if (now.active && !quiet && !now.terminal && now.shown > now.start)
        show(time);
    erase();
    now.active = false;
}
