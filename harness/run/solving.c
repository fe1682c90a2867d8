#include "solving.h"

#include <limits.h>

#include "../cases/number.h"
#include "options.h"

enum { TIMEOUT = 0x20000, MAX_STEPS, ROOM };

static const struct argp_option options[] = {
    {"algorithm", 'a', "LIST", 0,
     "names, globs, `all` or `peers` (`fatline list`), separated by commas; may be repeated", 2},
    {"external", 'x', "CMD", 0, "a program that reads case lines and writes a line of `solve` for each", 2},
    {"timeout", TIMEOUT, "S", 0, "seconds an external program or another library may take for a case (10)",
     2},
    {"max-steps", MAX_STEPS, "N", 0, "step limit (100000)", 2},
    {"room", ROOM, "N", 0, "cells that may wait at once (512)", 2},
    {0, 0, 0, 0, 0, 0}};

void solving_add(struct argp_state *state, struct algorithms_named *algorithms, const char *list)
{
    const char *error = algorithms_named_add(algorithms, list);
    if (error)
        argp_error(state, "%s", error);
}

real option_tolerance(struct argp_state *state, const char *text)
{
    real tolerance = 0;
    if (!real_parse(text, &tolerance) || !(tolerance > 0))
        argp_error(state, "--tolerance: \"%s\", expected a number > 0", text);
    return tolerance;
}

bool has_foreign(const struct algorithms_named *algorithms)
{
    for (int i = 0; i < algorithms->count; i++)
        if (algorithms->at[i]->foreign)
            return true;
    return false;
}

static void finish(struct solving *s, struct argp_state *state)
{
    bool ours = s->algorithms.count > 0 || !s->external;
    option_needs(state, s->timeout > 0, "--timeout", s->external || has_foreign(&s->algorithms),
                 "--external or another library");
    option_needs(state, s->max_steps > 0, "--max-steps beside --external", ours, "--algorithm");
    option_needs(state, s->room > 0, "--room beside --external", ours, "--algorithm");
    s->timeout = s->timeout > 0 ? s->timeout : 10;
    s->max_steps = s->max_steps > 0 ? s->max_steps : STEPS_MAX;
    s->room = s->room > 0 ? s->room : WORKSPACE_ROOM;
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct solving *s = (struct solving *)state->input;
    switch (key) {
    case 'a':
        solving_add(state, &s->algorithms, text);
        return 0;
    case 'x':
        s->external = text;
        return 0;
    case TIMEOUT:
        s->timeout = option_positive(state, "--timeout", text);
        return 0;
    case MAX_STEPS:
        s->max_steps = option_integer(state, "--max-steps", text, 1, INT_MAX);
        return 0;
    case ROOM:
        s->room = option_integer(state, "--room", text, 1, INT_MAX);
        return 0;
    case ARGP_KEY_END:
        finish(s, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

extern const struct argp solving_argp;
const struct argp solving_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};
