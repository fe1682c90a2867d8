/* fatline [--precision P] COMMAND ...: runs the program build/P/fatline-COMMAND beside this one. */
#include <argp.h>
#include <errno.h>
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "run/standard_output.h"

static const struct command {
    const char *name, *summary;
    bool once; /* does not depend on the precision: in build/double only */
} commands[] = {
    {"list", "the algorithms, what they claim, and where they come from", false},
    {"generate", "write cases of a family", true},
    {"truth", "solve cases in exact arithmetic", true},
    {"solve", "intersect the curves of cases, or two curves of your own", false},
    {"check", "compare answers with the truth", false},
    {"time", "measure how long algorithms take", false},
    {"trace", "write every step of an algorithm", false},
    {"order", "measure orders of convergence", false},
    {"lemma", "measure the exponents and constants behind hybrid clipping", false},
    {"cost", "measure how steps grow as the tolerance falls", false},
    {"paths", "where paths of many curves cross each other, or themselves", false},
    {"region", "where a control point may go without changing the sign of curvature", false},
    {"doctor", "the same code against itself: how small a difference means something here", false},
    {"compare", "two builds, or the rows of two runs: is anything slower?", false},
    {"repeat", "solve cases many times over, for profilers", false},
    {"roots", "measure the root finders of one variable", false},
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static const char *const precisions[] = {"double", "quad", "multi", NULL};

struct request {
    const char *precision;
    char **arguments; /* the command and what follows it, NULL-terminated; NULL: none */
};

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

/* Insertions, deletions and replacements that turn a into b, both cut at 31 letters. */
static int edit_distance(const char *a, const char *b)
{
    enum { LETTERS = 31 };
    int row[LETTERS + 1], n = smaller((int)strlen(a), LETTERS), m = smaller((int)strlen(b), LETTERS);
    for (int j = 0; j <= m; j++)
        row[j] = j;
    for (int i = 1; i <= n; i++) {
        int diagonal = row[0];
        row[0] = i;
        for (int j = 1; j <= m; j++) {
            int replaced = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = smaller(replaced, 1 + smaller(row[j], row[j - 1]));
        }
    }
    return row[m];
}

static const struct command *find(const char *name)
{
    for (int i = 0; i < COMMANDS; i++)
        if (!strcmp(commands[i].name, name))
            return &commands[i];
    return NULL;
}

static void complain_unknown(struct argp_state *state, const char *name)
{
    enum { CLOSE = 2 };
    char close[200] = "";
    for (int i = 0; i < COMMANDS; i++)
        if (edit_distance(name, commands[i].name) <= CLOSE ||
            (*name && !strncmp(name, commands[i].name, strlen(name)))) {
            strcat(close, close[0] ? " or " : "; did you mean ");
            strcat(close, commands[i].name);
        }
    argp_error(state, "no command %s%s%s", name, close, close[0] ? "?" : "");
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    struct request *r = state->input;
    switch (key) {
    case 'p':
        for (int i = 0; precisions[i]; i++)
            if (!strcmp(argument, precisions[i])) {
                r->precision = precisions[i];
                return 0;
            }
        argp_error(state, "no precision %s; expected double, quad or multi", argument);
        return EINVAL;
    case ARGP_KEY_ARG:
        if (!find(argument))
            complain_unknown(state, argument);
        r->arguments = &state->argv[state->next - 1];
        state->next = state->argc;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "no command");
        return EINVAL;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* The list of commands, below the options in --help. */
static char *help_filter(int key, const char *text, void *input)
{
    (void)input;
    if (key != ARGP_KEY_HELP_POST_DOC)
        return (char *)text;
    size_t size = 2000, n;
    char *help = malloc(size);
    if (!help)
        return NULL;
    n = (size_t)snprintf(help, size, "Commands:\n");
    for (int i = 0; i < COMMANDS; i++)
        n += (size_t)snprintf(help + n, size - n, "  %-10s %s\n", commands[i].name, commands[i].summary);
    snprintf(help + n, size - n, "\n`fatline COMMAND --help` explains a command.");
    return help;
}

/* The folder of this program, without a slash at its end; false if it cannot be told. */
static bool own_folder(char folder[PATH_MAX])
{
    ssize_t n = readlink("/proc/self/exe", folder, PATH_MAX - 1);
    if (n <= 0)
        return false;
    folder[n] = 0;
    char *end = strrchr(folder, '/');
    *end = 0;
    return true;
}

/* The precision among the arguments of a command, where it does not belong; NULL: there is none. */
static const char *misplaced_precision(char *const *argument)
{
    for (; *argument && strcmp(*argument, "--"); argument++)
        if (!strncmp(*argument, "--precision=", 12))
            return *argument + 12;
        else if (!strcmp(*argument, "--precision"))
            return argument[1] ? argument[1] : "P";
    return NULL;
}

static int run(const struct request *r)
{
    char folder[PATH_MAX], path[PATH_MAX + 64], shown[64];
    const struct command *c = find(r->arguments[0]);
    const char *precision = c->once ? "double" : r->precision;
    const char *misplaced = misplaced_precision(r->arguments + 1);
    if (misplaced) {
        fprintf(stderr, "fatline: --precision goes before the command: fatline --precision %s %s ...\n",
                misplaced, c->name);
        return 64;
    }
    if (!own_folder(folder)) {
        fprintf(stderr, "fatline: /proc/self/exe cannot be read: %s\n", strerror(errno));
        return 2;
    }
    snprintf(path, sizeof path, "%s/%s/fatline-%s", folder, precision, c->name);
    snprintf(shown, sizeof shown, "fatline %s", c->name);
    r->arguments[0] = shown;
    execv(path, r->arguments);
    if (errno == ENOENT)
        fprintf(stderr, "fatline: %s is not built at precision %s; build it with: make build/%s/fatline-%s\n",
                c->name, precision, precision, c->name);
    else
        fprintf(stderr, "fatline: %s: %s\n", path, strerror(errno));
    return 2;
}

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp_option options[] = {
        {"precision", 'p', "P", 0, "double (the default), quad (binary128) or multi (2,048 bits)", 0}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "COMMAND [ARGUMENT...]",
        "Intersect planar Bezier curves, and measure how well algorithms do it.\v",
        NULL,
        help_filter,
        NULL};
    struct request r = {precisions[0], NULL};
    if (argp_parse(&argp, argc, argv, ARGP_IN_ORDER, NULL, &r))
        return 64;
    return run(&r);
}
