#include "path_options.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "../run/options.h"
#include "../run/solving.h"

enum { TOLERANCE = 256, MAX_STEPS, RANDOM, SEED, ALONE, PRINT, TIME, ROUNDS, BESIDE };
enum { SEGMENTS_MAX = 100000000 };

static const struct argp_option options[] = {
    {0, 0, 0, 0, "Which paths:", 1},
    {"random", RANDOM, "N", 0, "instead of files: two smooth random walks of N cubics", 0},
    {"seed", SEED, "S", 0, "of the random walks (1)", 0},
    {"self", ALONE, 0, 0, "with --random: the first of them with itself", 0},
    {0, 0, 0, 0, "How:", 2},
    {"tolerance", TOLERANCE, "X", 0, "width asked for in both parameters of a segment (1e-10)", 0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit of a pair (100000)", 0},
    {0, 0, 0, 0, "What is written:", 3},
    {"print", PRINT, 0, 0, "the paths as lines of JSON, instead of their crossings", 0},
    {"time", TIME, 0, 0, "one row of times for each two paths, instead of their crossings", 0},
    {"rounds", ROUNDS, "R", 0, "with --time: samples (9)", 0},
    {"beside", BESIDE, "NAME", 0,
     "with --time: in the same rounds, this algorithm on the pairs of segments whose exact boxes meet", 0},
    {"output", 'o', "FILE", 0, "instead of standard output", 0},
    {"quiet", 'q', 0, 0, "no summary", 0},
    {0, 0, 0, 0, 0, 0}};

static const char documentation[] =
    "Where two paths of many curves cross, or one crosses itself: each path of file A with each one of file "
    "B, or "
    "each path of A with itself.  Writes a line of JSON for each crossing, sorted along the first path.\v"
    "A file (- is standard input) has a path a line, {\"id\", \"segments\": [[[x, y], ...], ...]} or "
    "{\"id\", "
    "\"d\": \"M ...\"} with SVG path data, or is path data itself, or an SVG file whose path elements are "
    "taken.  "
    "datasets/README.md has the grammar, results/README.md the rows.\n\n"
    "Example: fatline paths --random 1000 --seed 1\n\n"
    "Exit status: 0, 2 on an input or output error, 64 on wrong usage, 65 on bad data or no path, 130 when "
    "interrupted.";

static void add_file(struct path_options *o, char *file, struct argp_state *state)
{
    if (o->files[1])
        argp_error(state, "\"%s\" after two files, expected A or A and B", file);
    o->files[o->files[0] ? 1 : 0] = file;
}

static void finish(const struct path_options *o, struct argp_state *state)
{
    const struct path_options_given *given = &o->given;
    if (!o->random == !o->files[0])
        argp_error(state, "expected either files or --random");
    if (o->alone && !o->random)
        argp_error(state, "--self goes with --random; of one file every path is taken with itself");
    option_needs(state, given->seed, "--seed", o->random, "--random");
    option_excludes(state, o->print, "--print", o->time, "--time");
    option_excludes(state, o->print, "--print", given->tolerance, "--tolerance");
    option_excludes(state, o->print, "--print", given->max_steps, "--max-steps");
    option_needs(state, o->beside, "--beside", o->time, "--time");
    option_needs(state, given->rounds, "--rounds", o->time, "--time");
    if (o->beside && !intersector_find(o->beside))
        argp_error(state, "--beside: no algorithm %s; `fatline list` has their names", o->beside);
    if (o->files[1] && !strcmp(o->files[0], "-") && !strcmp(o->files[1], "-"))
        argp_error(state, "standard input twice");
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct path_options *o = (struct path_options *)state->input;
    switch (key) {
    case TOLERANCE:
        o->tolerance = option_tolerance(state, text);
        o->given.tolerance = true;
        break;
    case MAX_STEPS:
        o->max_steps = option_integer(state, "--max-steps", text, 1, INT_MAX);
        o->given.max_steps = true;
        break;
    case RANDOM:
        o->random = option_integer(state, "--random", text, 1, SEGMENTS_MAX);
        break;
    case SEED:
        o->seed = option_seed(state, "--seed", text);
        o->given.seed = true;
        break;
    case ROUNDS:
        o->rounds = option_integer(state, "--rounds", text, 1, 1000);
        o->given.rounds = true;
        break;
    case BESIDE:
        o->beside = text;
        break;
    case 'o':
        o->output = text;
        break;
    case ALONE:
    case PRINT:
    case TIME:
    case 'q':
        *(key == ALONE ? &o->alone : key == PRINT ? &o->print : key == TIME ? &o->time : &o->quiet) = true;
        break;
    case ARGP_KEY_ARG:
        add_file(o, text, state);
        break;
    case ARGP_KEY_END:
        finish(o, state);
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

void path_options_read(int argc, char **argv, struct path_options *o)
{
    static const struct argp argp = {options, parse, "A [B]", documentation, 0, 0, 0};
    memset((void *)o, 0, sizeof *o);
    o->tolerance = (real)1 / 10000000000LL;
    o->max_steps = STEPS_MAX;
    o->seed = 1;
    o->rounds = 9;
    if (argp_parse(&argp, argc, argv, 0, NULL, o))
        exit(64);
}
