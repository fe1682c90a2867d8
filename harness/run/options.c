#include "options.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>

int option_integer(struct argp_state *state, const char *name, const char *text, int lo, int hi)
{
    char *end;
    errno = 0;
    long n = strtol(text, &end, 10);
    if (end == text || *end || errno || n < lo || n > hi)
        argp_error(state, "%s: \"%s\", expected an integer from %d to %d", name, text, lo, hi);
    return (int)n;
}

uint64_t option_seed(struct argp_state *state, const char *name, const char *text)
{
    char *end;
    errno = 0;
    uint64_t seed = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end || errno)
        argp_error(state, "%s: \"%s\", expected an integer from 0 to 18446744073709551615", name, text);
    return seed;
}

double option_number(struct argp_state *state, const char *name, const char *text, double lo, double hi)
{
    char *end;
    double a = strtod(text, &end);
    if (end == text || *end || !(lo <= a && a <= hi))
        argp_error(state, "%s: \"%s\", expected a number from %g to %g", name, text, lo, hi);
    return a;
}

double option_positive(struct argp_state *state, const char *name, const char *text)
{
    char *end;
    double a = strtod(text, &end);
    if (end == text || *end || !(a > 0) || isinf(a))
        argp_error(state, "%s: \"%s\", expected a number > 0", name, text);
    return a;
}

void option_needs(struct argp_state *state, bool given, const char *name, bool there, const char *what)
{
    if (given && !there)
        argp_error(state, "%s needs %s", name, what);
}

void option_excludes(struct argp_state *state, bool given, const char *name, bool there, const char *what)
{
    if (given && there)
        argp_error(state, "%s does not go with %s", name, what);
}
