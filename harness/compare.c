/* `fatline compare`. */
#include "timing/compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cases/case_set.h"
#include "run/options.h"
#include "run/row.h"
#include "run/solving.h"
#include "run/standard_output.h"
#include "timing/noise.h"

const char *argp_program_version = "fatline 0.1";

static const char documentation[] =
    "Compare two builds (--builds A B, their folders, as build/), timed in turn on the cases of FILEs; or "
    "the rows of two "
    "earlier runs of `fatline time`.\v"
    "Builds: processes of both alternate whole-set passes over the pairs that both get right; a second "
    "process of the "
    "first build shows what chance does. Rows: each time is divided by that of the reference in the same "
    "rounds, `floor` unless another is named, which cannot be compared itself; --instructions compares the "
    "counts of --count instructions instead.\n\n"
    "A difference is called if the 99 percent interval of the ratio lies wholly beyond the noise floor: of "
    "builds the "
    "largest of 1 percent, what `fatline doctor` found, and chance in this run; of rows that of both runs "
    "together, 5 "
    "percent each where unknown.\n\n"
    "Exit status: 0, 3 if something is slower, 1 if there was nothing to compare, 2 on failure, 64 on wrong "
    "usage, 65 on bad data or no case.";

enum { BUILDS = 256, REFERENCE, GENERATIONS, ROUNDS, SEED, FLOOR, INSTRUCTIONS, ROWS, TOLERANCE };

static const struct argp_option options[] = {
    {"builds", BUILDS, "A", 0, "compare the builds A and B (the argument that follows)", 0},
    {"algorithm", 'a', "LIST", 0, "of builds: names, globs or `all` (the default), separated by commas", 0},
    {"tolerance", TOLERANCE, "X", 0, "of builds: width asked for in both parameters (1e-9)", 0},
    {"generations", GENERATIONS, "N", 0, "of builds: how often the processes are started (11)", 0},
    {"rounds", ROUNDS, "N", 0, "of builds: rounds in each generation (15)", 0},
    {"seed", SEED, "N", 0, "of the order and the bootstrap (1)", 0},
    {"reference", REFERENCE, "NAME", 0,
     "of rows: the algorithm that divides the others (floor, if both files have it)", 0},
    {"instructions", INSTRUCTIONS, 0, 0, "of rows: decide by instruction counts", 0},
    {"noise-floor", FLOOR, "X", 0, "call no relative difference below X, whatever is known", 0},
    {"rows", ROWS, 0, 0, "a row of JSON for each comparison", 0},
    {0, 0, 0, 0, 0, 0}};

enum change comparison_change(const struct comparison *c)
{
    return c->lo > 1 + c->floor ? SLOWER : c->hi < 1 / (1 + c->floor) ? FASTER : SAME;
}

void comparison_write(const struct compare_settings *s, const struct comparison *c)
{
    static const char *const names[] = {"same", "SLOWER", "faster"};
    const char *change = names[comparison_change(c)];
    if (s->json) {
        json_t *row =
            json_pack("{s:s, s:s, s:s, s:i, s:f, s:f, s:f, s:f, s:s}", "family", c->family, "algorithm",
                      c->algorithm, "compared", c->what, "pairs", c->pairs, "ratio", c->ratio, "ratio_lo",
                      c->lo, "ratio_hi", c->hi, "noise_floor", c->floor, "change", change);
        if (s->reference)
            json_object_set_new(row, "reference", json_string(s->reference));
        row_write(stdout, row);
    } else {
        printf("%-32s %-26s %6d pairs  %7.4f [%.4f, %.4f]  noise floor %4.1f%%  %s\n", c->family,
               c->algorithm, c->pairs, c->ratio, c->lo, c->hi, 100 * c->floor, change);
    }
    fflush(stdout);
}

static void finish(struct argp_state *state, struct compare_settings *s)
{
    const bool builds = s->build[0];
    if (builds && !s->build[1])
        argp_error(state, "--builds A needs B");
    if (builds && !s->files)
        argp_error(state, "no FILE of cases");
    for (int i = 0; builds && i < s->files; i++)
        if (!strcmp(s->file[i], "-"))
            argp_error(state, "each build reads the cases for itself: a file, not standard input");
    if (!builds && s->files != 2)
        argp_error(state, "two files of rows are needed, or --builds A B FILE...");
    option_needs(state, s->algorithms.count, "--algorithm", builds, "--builds");
    option_needs(state, s->tolerance, "--tolerance", builds, "--builds");
    option_needs(state, s->generations, "--generations", builds, "--builds");
    option_needs(state, s->rounds, "--rounds", builds, "--builds");
    option_excludes(state, s->reference, "--reference", builds, "--builds");
    option_excludes(state, s->instructions, "--instructions", builds, "--builds");
    option_excludes(state, s->reference, "--reference", s->instructions, "--instructions");
    s->tolerance = s->tolerance ? s->tolerance : "1e-9";
    s->generations = s->generations ? s->generations : 11;
    s->rounds = s->rounds ? s->rounds : 15;
    if (builds && !s->algorithms.count)
        solving_add(state, &s->algorithms, "all");
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct compare_settings *s = (struct compare_settings *)state->input;
    switch (key) {
    case BUILDS:
        s->build[0] = text;
        if (state->next < state->argc)
            s->build[1] = state->argv[state->next++];
        return 0;
    case 'a':
        solving_add(state, &s->algorithms, text);
        return 0;
    case TOLERANCE:
        option_tolerance(state, text);
        s->tolerance = text;
        return 0;
    case GENERATIONS:
        s->generations = option_integer(state, "--generations", text, 3, 100000);
        return 0;
    case ROUNDS:
        s->rounds = option_integer(state, "--rounds", text, 3, 100000);
        return 0;
    case SEED:
        s->seed = (uint64_t)option_integer(state, "--seed", text, 0, 100000);
        return 0;
    case REFERENCE:
        s->reference = text;
        return 0;
    case FLOOR:
        s->floor = option_number(state, "--noise-floor", text, 0, 100);
        return 0;
    case INSTRUCTIONS:
        s->instructions = true;
        return 0;
    case ROWS:
        s->json = true;
        return 0;
    case ARGP_KEY_ARGS:
        s->file = state->argv + state->next;
        s->files = state->argc - state->next;
        return 0;
    case ARGP_KEY_END:
        finish(state, s);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* Are all files of cases in order?  0 or an exit status. */
static int check_cases(const struct compare_settings *s)
{
    int worst = 0;
    for (int i = 0; i < s->files && worst != 2; i++) {
        struct case_set set;
        memset((void *)&set, 0, sizeof set);
        int status = case_set_read(&set, s->file[i], (real)1, 1);
        if (!status && !set.count) {
            fprintf(stderr, "fatline compare: no case in %s\n", s->file[i]);
            status = 65;
        }
        worst = status ? status : worst;
        case_set_clear(&set);
    }
    return worst;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp parser = {options, parse, "FILE...", documentation, NULL, NULL, NULL};
    struct compare_settings s;
    struct noise noise;
    int compared = 0, slower = 0, status;
    memset((void *)&s, 0, sizeof s);
    s.max_steps = "10000";
    s.seed = 1;
    s.floor = NAN;
    argp_parse(&parser, argc, argv, 0, NULL, &s);
    status = s.build[0] ? check_cases(&s) : 0;
    if (status)
        return status;
    if (s.build[0] && isnan(s.floor))
        s.floor = noise_floor();
    if (s.json) {
        json_t *environment = row_environment(argc, argv, REAL_NAME);
        noise_floor_note(environment);
        row_write(stdout, environment);
    }
    noise_begin(&noise);
    status = s.build[0] ? compare_builds(&s, &compared, &slower) : compare_files(&s, &compared, &slower);
    if (s.build[0])
        noise_warn(&noise, stderr);
    if (!status && !s.json && s.reference)
        printf("divided by %s, which is not compared\n", s.reference);
    if (!status && !s.json)
        printf("%d compared, %d slower\n", compared, slower);
    algorithms_named_clear(&s.algorithms);
    return status ? status : !compared ? 1 : slower ? 3 : 0;
}
