/* fatline generate: case lines of a family, from a seed. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "families/family.h"
#include "families/glyphs.h"
#include "run/options.h"
#include "run/standard_output.h"

enum { EXIT_BROKEN = 2, DEGREES_MAX = 64 };

const char *argp_program_version = "fatline 0.1";

static const char default_fonts[] = "DejaVu Sans,DejaVu Serif,Latin Modern Roman";
static const char default_letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789&";

struct arguments {
    const char *family, *fonts, *letters;
    int degrees, n[DEGREES_MAX], m[DEGREES_MAX];
    uint64_t count, seed, first;
    bool weights, list;
    int gap, gaps;
};

static const struct argp_option options[] = {
    {"degree", 'd', "N[xM],...", 0, "Degrees of f and g, one or several (default 3)", 0},
    {"count", 'c', "C", 0, "Cases of each pair of degrees (default 1)", 0},
    {"seed", 's', "S", 0, "Seed; the same seed gives the same cases everywhere (default 1)", 0},
    {"first", 'f', "I", 0, "Number of the first case (default 0)", 0},
    {"weights", 'w', NULL, 0, "Rational curves; the same as FAMILY_rational", 0},
    {"gap", 'g', "J[-K]", 0,
     "near_tangent: every gap 2^-J, or those from 2^-J to 2^-K in turn, 5 <= J <= K <= 100 (default: from "
     "case "
     "to case others, down to 2^-50); beyond 2^-50 coordinates need more than a double and come as fractions "
     "only",
     0},
    {"fonts", 'F', "A,B,...", 0,
     "glyphs: families to overlay (default DejaVu Sans,DejaVu Serif,Latin Modern Roman)", 1},
    {"letters", 'L', "TEXT", 0, "glyphs: letters to take (default a-z, A-Z, 0-9 and &)", 1},
    {"list", 'l', NULL, 0, "List the families", 2},
    {0}};

static void parse_degrees(struct argp_state *state, const char *text, struct arguments *a)
{
    const char *whole = text;
    for (;;) {
        char *end;
        long n = strtol(text, &end, 10), m = n;
        if (end > text && *end == 'x')
            m = strtol(text = end + 1, &end, 10);
        if (end == text || (*end && *end != ',') || n < 1 || m < 1 || n > DRAFT_DEGREE_MAX ||
            m > DRAFT_DEGREE_MAX || a->degrees == DEGREES_MAX)
            argp_error(
                state,
                "--degree: '%s', expected N or NxM with 1 <= N, M <= %d, or up to %d of them and commas",
                whole, DRAFT_DEGREE_MAX, DEGREES_MAX);
        a->n[a->degrees] = (int)n;
        a->m[a->degrees++] = (int)m;
        if (!*end)
            return;
        text = end + 1;
    }
}

static void parse_gaps(struct argp_state *state, const char *text, struct arguments *a)
{
    char *end;
    long lo = strtol(text, &end, 10), hi = lo;
    bool good = end > text;
    if (good && *end == '-')
        hi = strtol(text = end + 1, &end, 10), good = end > text;
    if (!good || *end || lo < 5 || hi < lo || hi > 100)
        argp_error(state, "--gap: expected J or J-K with 5 <= J <= K <= 100");
    a->gap = (int)lo;
    a->gaps = (int)(hi - lo) + 1;
}

static void complete(struct argp_state *state, const struct arguments *a)
{
    const bool glyphs = a->family && !strcmp(a->family, "glyphs");
    if (!a->family && !a->list)
        argp_error(state, "which family?  --list shows them");
    if (a->list && state->argc > 2)
        argp_error(state, "--list goes alone");
    option_needs(state, a->fonts, "--fonts", glyphs, "the family glyphs");
    option_needs(state, a->letters, "--letters", glyphs, "the family glyphs");
    option_excludes(state, glyphs, "glyphs", a->degrees, "--degree");
    option_excludes(state, glyphs, "glyphs", a->weights, "--weights");
    option_excludes(state, glyphs, "glyphs", a->gap, "--gap");
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct arguments *a = state->input;
    switch (key) {
    case 'd':
        parse_degrees(state, text, a);
        break;
    case 'c':
        a->count = option_seed(state, "--count", text);
        if (!a->count)
            argp_error(state, "--count: \"%s\", expected 1 or more", text);
        break;
    case 's':
        a->seed = option_seed(state, "--seed", text);
        break;
    case 'f':
        a->first = option_seed(state, "--first", text);
        break;
    case 'g':
        parse_gaps(state, text, a);
        break;
    case 'w':
        a->weights = true;
        break;
    case 'F':
        a->fonts = text;
        break;
    case 'L':
        a->letters = text;
        break;
    case 'l':
        a->list = true;
        break;
    case ARGP_KEY_ARG:
        if (a->family)
            argp_error(state, "one family at a time: '%s' after '%s'", text, a->family);
        a->family = text;
        break;
    case ARGP_KEY_END:
        complete(state, a);
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static void list_families(void)
{
    for (const struct family *a = families; a->name; a++)
        printf("%-17s %2d-%-3d%s %s\n", a->name, a->high, a->max,
               a->own_weights    ? "always w."
               : a->max_rational ? "weights  "
                                 : "         ",
               a->summary);
    printf("%-17s %2d-%-3d%s %s\n", "glyphs", 1, 3, "         ", "outlines of two fonts laid on each other");
}

/* The family called `name`, or `name` without _rational, which sets *weights. */
static const struct family *find_family(const char *name, bool *weights)
{
    static const char suffix[] = "_rational";
    size_t length = strlen(name), cut = sizeof suffix - 1;
    bool ends = length > cut && !strcmp(name + length - cut, suffix);
    for (const struct family *a = families; a->name; a++) {
        if (!strcmp(a->name, name))
            return a;
        if (ends && strlen(a->name) == length - cut && !strncmp(a->name, name, length - cut)) {
            *weights = true;
            return a;
        }
    }
    return NULL;
}

/* The cases of one pair of degrees; 0 or an exit status. */
static int generate(const struct family *family, const struct arguments *a, int n, int m, struct draft *d)
{
    char why[160], name[96];
    struct request r = {
        .n = n, .m = m, .weights = a->weights || family->own_weights, .gap = a->gap, .gaps = a->gaps};
    snprintf(name, sizeof name, "%s%s", family->name, a->weights && !family->own_weights ? "_rational" : "");
    if (family_refuses(family, n, m, r.weights, why)) {
        fprintf(stderr, "fatline generate: %s\n", why);
        return argp_err_exit_status;
    }
    for (uint64_t i = 0; i < a->count; i++) {
        r.index = a->first + i;
        if (!family_make(family, name, a->seed, &r, d)) {
            fprintf(stderr,
                    "fatline generate: %s %dx%d, seed %" PRIu64 ", case %" PRIu64
                    ": no pair that fits in doubles was found\n",
                    name, n, m, a->seed, r.index);
            return EXIT_BROKEN;
        }
        family_write(stdout, d, name, a->seed, r.index);
    }
    return 0;
}

static int generate_all(struct arguments *a)
{
    const struct family *family = find_family(a->family, &a->weights);
    struct draft d;
    int status = 0;
    if (!family) {
        fprintf(stderr, "fatline generate: no family '%s'; fatline generate --list shows them\n", a->family);
        return argp_err_exit_status;
    }
    if (a->gap && family->generate != family_near_tangent) {
        fprintf(stderr, "fatline generate: --gap belongs to near_tangent\n");
        return argp_err_exit_status;
    }
    if (a->degrees == 0)
        a->n[a->degrees] = a->m[a->degrees] = 3, a->degrees = 1;
    draft_init(&d);
    for (int k = 0; k < a->degrees && !status; k++)
        status = generate(family, a, a->n[k], a->m[k], &d);
    draft_clear(&d);
    flint_cleanup();
    return status;
}

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp argp = {options,
                                     parse_option,
                                     "FAMILY",
                                     "Write case lines of a family, one JSON object a line.\v"
                                     "Every coordinate is a double exactly, but for gaps beyond 2^-50.  "
                                     "datasets/README.md has the grammar of a "
                                     "line and the construction of each family.",
                                     NULL,
                                     NULL,
                                     NULL};
    struct arguments a = {.count = 1, .seed = 1};
    char why[512];
    int status = 0;
    argp_parse(&argp, argc, argv, 0, NULL, &a);
    if (a.list) {
        list_families();
    } else if (!strcmp(a.family, "glyphs")) {
        status = glyphs_write(stdout, a.fonts ? a.fonts : default_fonts,
                              a.letters ? a.letters : default_letters, a.seed, a.first, a.count, why);
        if (status)
            fprintf(stderr, "fatline generate: %s\n", why);
    } else {
        status = generate_all(&a);
    }
    return status;
}
