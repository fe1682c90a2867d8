#include "path_options.h"

#include <argp.h>
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "../cases/number.h"

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
    "Exit status: 0, 2 on an input or output error, 64 on wrong usage, 65 on bad data, 130 when interrupted.";

static long read_count(struct argp_state *state, const char *name, const char *text, long most)
{
    char *end;
    errno = 0;
    long n = strtol(text, &end, 10);
    if (end == text || *end || errno || n < 1 || n > most)
        argp_error(state, "%s: \"%s\", expected an integer from 1 to %ld", name, text, most);
    return n;
}

static uint64_t read_seed(struct argp_state *state, const char *text)
{
    char *end;
    errno = 0;
    uint64_t seed = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end || errno)
        argp_error(state, "--seed: \"%s\", expected an integer from 0 to 18446744073709551615", text);
    return seed;
}

static void add_file(struct path_options *o, char *file, struct argp_state *state)
{
    if (o->files[1])
        argp_error(state, "\"%s\" after two files, expected A or A and B", file);
    o->files[o->files[0] ? 1 : 0] = file;
}

static void finish(const struct path_options *o, struct argp_state *state)
{
    if (!o->random == !o->files[0])
        argp_error(state, "expected either files or --random");
    if (o->alone && !o->random)
        argp_error(state, "--self goes with --random; of one file every path is taken with itself");
    if (o->print && o->time)
        argp_error(state, "either --print or --time");
    if (!o->time && (o->beside || o->rounds != 9))
        argp_error(state, "--beside and --rounds go with --time");
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
        if (!real_parse(text, &o->tolerance) || !(o->tolerance > 0))
            argp_error(state, "--tolerance: \"%s\", expected a number > 0", text);
        break;
    case MAX_STEPS:
        o->max_steps = (int)read_count(state, "--max-steps", text, INT_MAX);
        break;
    case RANDOM:
        o->random = (int)read_count(state, "--random", text, SEGMENTS_MAX);
        break;
    case SEED:
        o->seed = read_seed(state, text);
        break;
    case ROUNDS:
        o->rounds = (int)read_count(state, "--rounds", text, 1000);
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
    real_parse("1e-10", &o->tolerance);
    o->max_steps = STEPS_MAX;
    o->seed = 1;
    o->rounds = 9;
    if (argp_parse(&argp, argc, argv, 0, NULL, o))
        exit(64);
}
