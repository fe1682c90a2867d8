/* See time_options.h. */
#include "time_options.h"

#include <argp.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../run/memory.h"
#include "../run/options.h"
#include "../run/solving.h"

static const char documentation[] =
    "Times intersection algorithms on the case lines of FILEs (- or none: standard input).\v"
    "Every algorithm is first judged on every pair. One that misses a root is not timed on that "
    "family, nor is one that is right on fewer than half of its pairs, and the row says so; the "
    "others are timed on the pairs that all of them got right. Ambiguous pairs and pairs without "
    "a known answer are left out.\n\n"
    "A sample is a number of passes over all these pairs, long enough for the clock, in ns a pair "
    "(CPU time). In each round every algorithm gives one sample, in an order drawn anew, so that "
    "ratios are taken between neighbours in time. ns_min, ns_median and ns_mad (median absolute "
    "deviation, unscaled) are over samples, ns_lo and ns_hi bound a 95 percent bootstrap interval "
    "of the median; ns_max is the shortest time of the slowest single pair, worst_id, by the wall clock. "
    "External "
    "programs are timed in wall-clock time around their pipe, one line after the other (protocol "
    "\"pipe\"); no ratio is taken between that and the others. Other people's libraries that are "
    "programs of their own time themselves over the whole set, in the same rounds (protocol "
    "\"inside\").\n\n"
    "`floor` takes part in every family: told the first three digits of each root, it merely takes "
    "Newton steps; the column \"from floor\" is how many times as long the others take.\n\n"
    "Each family is timed in a process of its own. Whoever crashes or hangs there is left out, and "
    "the family is timed again without it.\n\n"
    "The branch predictor learns a set of few pairs by heart: compare times of sets of similar "
    "size.\n\n"
    "Rows are JSON, one a line, after one line on the circumstances; on a terminal, or with "
    "--human, a table. Exit status: 0, 1 if nothing could be timed, 2 on an input or output "
    "error, 64 on wrong usage, 65 on bad data or no case.";

enum {
    TOLERANCE = 256,
    MAX_STEPS,
    ROUNDS,
    SECONDS,
    PIN,
    FAMILY_BY,
    UNCHECKED,
    HUMAN,
    ROWS,
    SEED,
    TIMEOUT,
    POINTS,
    FORGIVE,
    SINGLE,
    RESUME,
    DRY_RUN,
    COUNT,
    BATCH,
    NO_FLOOR
};

static const struct argp_option options[] = {
    {"algorithm", 'a', "LIST", 0, "names or globs, separated by commas, `peers`, or `all` (the default)", 0},
    {"baseline", 'b', "NAME", 0,
     "give ratios to this algorithm (of --batch: as its rows name it), or program, from the same rounds", 0},
    {"external", 'x', "CMD", 0, "also time a program that reads case lines and writes `solve` lines", 0},
    {"timeout", TIMEOUT, "S", 0, "seconds an external program or another library may take for a pair (10)",
     0},
    {"points", POINTS, "REACH", 0,
     "judge answers as points, each paired with one solution within REACH in both parameters", 0},
    {"forgive", FORGIVE, 0, 0, "time who misses roots too, on the pairs that it gets right", 0},
    {"single", SINGLE, 0, 0, "time each pair by itself, as a family of its own (protocol \"single\")", 0},
    {"count", COUNT, "WHAT", 0, "count `instructions` too, with valgrind, on 24 of the pairs", 0},
    {"batch", BATCH, "VARIANT", OPTION_ARG_OPTIONAL,
     "time `certified_batch` too: all pairs of a family in one call of the batch interface (polynomial "
     "curves of "
     "degree 1 to 3 over [0, 1]; protocol \"batch\"); VARIANT is portable, avx2 or avx512, else the best "
     "that "
     "the machine has",
     0},
    {"no-floor", NO_FLOOR, 0, 0, "without the yardstick", 0},
    {"dry-run", DRY_RUN, 0, 0, "say what would be timed and about how long it would take", 0},
    {"output", 'o', "FILE", 0, "write there instead of to standard output", 0},
    {"resume", RESUME, 0, 0, "go on where the interrupted run that began FILE (--output) stopped", 0},
    {"tolerance", TOLERANCE, "X", 0,
     "width asked for in both parameters (1e-12); in double each pair is solved at the larger of this and "
     "its own",
     0},
    {"max-steps", MAX_STEPS, "N", 0, "step limit (100000)", 0},
    {"rounds", ROUNDS, "N", 0, "samples of each algorithm, at most (51)", 0},
    {"seconds", SECONDS, "S", 0,
     "time allowed for the rounds of a family (10; 0: no limit); 5 rounds at least, on fewer pairs if "
     "need be",
     0},
    {"seed", SEED, "N", 0, "of the order within the rounds and of the bootstrap (1)", 0},
    {"pin", PIN, "CPU", 0,
     "run on this processor only; `auto`: on the last one allowed; `none` (the default): wherever the system "
     "likes",
     0},
    {"family-by", FAMILY_BY, "WHAT", 0,
     "what makes a family: `file` (the default), `class`, or any text field of the case lines", 0},
    {"unchecked", UNCHECKED, 0, 0, "time whatever was SOLVED, right or wrong or not known", 0},
    {"human", HUMAN, 0, 0, "a table instead of rows", 0},
    {"rows", ROWS, 0, 0, "rows even on a terminal", 0},
    {0, 0, 0, 0, 0, 0}};

/* The last processor that this process may run on. */
static int last_cpu(void)
{
    cpu_set_t cpus;
    int last = 0;

    if (!sched_getaffinity(0, sizeof cpus, &cpus))
        for (int i = 0; i < CPU_SETSIZE; i++)
            if (CPU_ISSET(i, &cpus))
                last = i;
    return last;
}

static void choose_variant(struct argp_state *state, struct time_settings *s, const char *text)
{
    static const char *const names[] = {"", "portable", "avx2", "avx512"};
    int k = 0;

    while (text && k < 4 && (k == 0 || strcmp(text, names[k])))
        k++;
    if (k == 4)
        argp_error(state, "--batch: \"%s\", expected portable, avx2 or avx512", text);
    if (!batch_has((enum batch_variant)k))
        argp_error(state, "--batch: this machine, or precision, has no %s", text);
    s->batch = true;
    s->variant = (enum batch_variant)k;
    snprintf(s->batch_name, sizeof s->batch_name, "%s_batch%s%s", batch_algorithm->name, k ? "_" : "",
             names[k]);
}

/* An algorithm, the batch, or (to be seen) one of the external programs. */
static void choose_baseline(struct argp_state *state, struct time_settings *s)
{
    bool batch = s->batch && !strcmp(s->baseline, s->batch_name);
    bool yardstick = !s->no_floor && !strcmp(s->baseline, intersector_floor->name); /* takes part anyway */
    size_t n = batch_algorithm ? strlen(batch_algorithm->name) : 0;

    if (yardstick)
        return;
    if (intersector_find(s->baseline))
        solving_add(state, &s->algorithms, s->baseline);
    else if (!batch && n && !strncmp(s->baseline, batch_algorithm->name, n) &&
             !strncmp(s->baseline + n, "_batch", 6))
        argp_error(state, "--baseline: %s takes part with --batch%s only", s->baseline,
                   s->baseline[n + 6] ? "=VARIANT" : "");
    else if (!batch && !s->externals)
        argp_error(state, "--baseline: no algorithm %s; `fatline list` has their names", s->baseline);
}

/* Asked for by name, the floor takes part once: beside others as the yardstick it is anyway, alone as any
 * algorithm. */
static void keep_one_floor(struct time_settings *s)
{
    struct algorithms_named *a = &s->algorithms;
    int kept = 0;

    if (s->no_floor)
        return;
    if (a->count == 1 && a->at[0] == intersector_floor && !s->batch && !s->externals) {
        s->no_floor = true;
        return;
    }
    for (int i = 0; i < a->count; i++)
        if (a->at[i] != intersector_floor)
            a->at[kept++] = a->at[i];
    if (kept < a->count)
        a->at[kept] = NULL;
    a->count = kept;
}

static void finish(struct argp_state *state, struct time_settings *s)
{
    bool ours = s->algorithms.count || s->batch || !s->externals;

    option_excludes(state, s->single, "--single", s->family_by, "--family-by");
    option_excludes(state, s->human, "--human", s->rows, "--rows");
    option_excludes(state, s->human, "--human", s->output, "--output");
    option_excludes(state, s->plan.unchecked, "--unchecked", s->plan.points > 0, "--points");
    option_needs(state, s->resume, "--resume", s->output, "--output FILE");
    option_excludes(state, s->resume, "--resume", s->dry_run, "--dry-run");
    option_needs(state, s->max_steps, "--max-steps beside --external", ours, "--algorithm");
    option_needs(state, s->count_instructions && s->externals, "--count beside --external",
                 s->algorithms.count, "--algorithm");
    if (ours && !s->algorithms.count && !s->batch)
        solving_add(state, &s->algorithms, "all");
    if (s->baseline)
        choose_baseline(state, s);
    keep_one_floor(s);
    s->human = s->human || (!s->rows && !s->output && isatty(STDOUT_FILENO));
    s->family_by = s->single ? "id" : s->family_by ? s->family_by : "file";
    s->max_steps = s->max_steps ? s->max_steps : STEPS_MAX;
}

static bool parse_flag(int key, struct time_settings *s)
{
    bool *flag = key == FORGIVE     ? &s->plan.forgive
                 : key == UNCHECKED ? &s->plan.unchecked
                 : key == RESUME    ? &s->resume
                 : key == DRY_RUN   ? &s->dry_run
                 : key == NO_FLOOR  ? &s->no_floor
                 : key == SINGLE    ? &s->single
                 : key == HUMAN     ? &s->human
                 : key == ROWS      ? &s->rows
                                    : NULL;

    if (flag)
        *flag = true;
    return flag;
}

static bool parse_number(int key, const char *text, struct argp_state *state, struct time_settings *s)
{
    switch (key) {
    case TIMEOUT:
        s->timeout = option_number(state, "--timeout", text, 1e-3, 1e9);
        return true;
    case TOLERANCE:
        s->plan.tolerance = option_tolerance(state, text);
        return true;
    case MAX_STEPS:
        s->max_steps = option_integer(state, "--max-steps", text, 1, 1000000000);
        return true;
    case ROUNDS:
        s->plan.clock.rounds = option_integer(state, "--rounds", text, 1, 1000000);
        return true;
    case SECONDS:
        s->plan.clock.seconds = option_number(state, "--seconds", text, 0, 1e9);
        return true;
    case SEED:
        s->plan.clock.seed = (uint64_t)option_integer(state, "--seed", text, 0, 2147483647);
        return true;
    case POINTS:
        s->plan.points = option_number(state, "--points", text, 1e-15, 1);
        return true;
    case PIN:
        s->cpu = !strcmp(text, "auto")  ? last_cpu()
                 : strcmp(text, "none") ? option_integer(state, "--pin", text, 0, CPU_SETSIZE - 1)
                                        : -1;
        return true;
    default:
        return false;
    }
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct time_settings *s = (struct time_settings *)state->input;

    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &s->cases;
        return 0;
    case 'a':
        solving_add(state, &s->algorithms, text);
        return 0;
    case 'b':
        s->baseline = text;
        return 0;
    case 'x':
        s->external = (char **)memory_resized(s->external, (s->externals + 1) * sizeof *s->external);
        s->external[s->externals++] = text;
        return 0;
    case 'o':
        s->output = text;
        return 0;
    case COUNT:
        if (strcmp(text, "instructions"))
            argp_error(state, "--count: \"%s\", expected instructions", text);
        s->count_instructions = true;
        return 0;
    case BATCH:
        choose_variant(state, s, text);
        return 0;
    case FAMILY_BY:
        s->family_by = text;
        return 0;
    case ARGP_KEY_END:
        finish(state, s);
        return 0;
    default:
        return parse_flag(key, s) || parse_number(key, text, state, s) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

void time_settings_read(int argc, char **argv, struct time_settings *s)
{
    static const struct argp_child children[] = {{&selection_argp, 0, 0, 0}, {0, 0, 0, 0}};
    static const struct argp parser = {options, parse, "[FILE...]", documentation, children, NULL, NULL};

    memset((void *)s, 0, sizeof *s);
    s->plan.tolerance = (real)1 / 1000000000000LL;
    s->plan.clock.rounds = 51;
    s->plan.clock.seconds = 10;
    s->plan.clock.sample_ns = 2e6;
    s->plan.clock.seed = 1;
    s->cpu = -1;
    s->timeout = 10;
    argp_parse(&parser, argc, argv, 0, NULL, s);
}

void time_settings_clear(struct time_settings *s)
{
    algorithms_named_clear(&s->algorithms);
    selection_clear(&s->cases);
    free(s->external);
}
