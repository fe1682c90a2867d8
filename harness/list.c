/* fatline list: the algorithms of this precision. */
#include <argp.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../algorithms/peers/foreign.h"
#include "run/algorithms_named.h"
#include "run/guard.h"
#include "run/standard_output.h"

struct request {
    bool json;
    struct algorithms_named algorithms;
};

/* "2", "1.5", or "-" for none. */
static void order_text(double order, char text[16])
{
    if (order > 0)
        snprintf(text, 16, "%.3g", order);
    else
        snprintf(text, 16, "-");
}

/* Version and licence of other people's code, or why it is absent. */
static void print_origin(const struct intersector *a, int indent)
{
    if (!a->foreign)
        return;
    if (guard_absent(a))
        printf("%*sABSENT: %s; licence %s\n", indent, "", guard_absent(a), a->foreign->licence);
    else
        printf("%*sversion %s, licence %s, %s\n", indent, "", a->foreign->kind->version(a->foreign),
               a->foreign->licence, a->foreign->kind->in_process ? "in process" : "a program over a pipe");
}

static void print_table(const struct intersector *const *a)
{
    bool starred = false;
    if (!a[0])
        return;
    int width = 9;
    for (int i = 0; a[i]; i++)
        if ((int)strlen(a[i]->name) > width)
            width = (int)strlen(a[i]->name);
    printf("%-*s  order per round at contact\n%-*s     1    2    3  cusp\n", width, "", width, "algorithm");
    for (int i = 0; a[i]; i++) {
        const double order[4] = {a[i]->claimed.contact_1, a[i]->claimed.contact_2, a[i]->claimed.contact_3,
                                 a[i]->claimed.cusp};
        bool is_default = a[i] == intersector_default;
        printf("%-*s%c", width, a[i]->name, is_default ? '*' : ' ');
        starred = starred || is_default;
        for (int k = 0; k < 4; k++) {
            char text[16];
            order_text(order[k], text);
            printf(" %*s", k == 3 ? 5 : 4, text);
        }
        printf("  %s\n%*s%s\n", a[i]->summary, width + 25, "", a[i]->reference);
        print_origin(a[i], width + 25);
    }
    if (starred)
        printf("%-*s* unless another is asked for\n", width, "");
}

static json_t *order_json(double order)
{
    return order > 0 ? json_real(order) : json_null();
}

static json_t *origin_json(const struct intersector *a)
{
    const char *absent = guard_absent(a);
    return json_pack("{s:s?, s:s, s:s, s:b, s:b, s:s?}", "version",
                     absent ? NULL : a->foreign->kind->version(a->foreign), "licence", a->foreign->licence,
                     "needs", a->foreign->needs, "in_process", (int)a->foreign->kind->in_process, "polished",
                     (int)a->foreign->polished, "absent", absent);
}

static void print_rows(const struct intersector *const *a)
{
    for (int i = 0; a[i]; i++) {
        const struct order *o = &a[i]->claimed;
        json_t *row =
            json_pack("{s:s, s:s, s:{s:o, s:o, s:o, s:o}, s:s, s:s, s:b, s:b}", "algorithm", a[i]->name,
                      "precision", REAL_NAME, "claimed", "contact_1", order_json(o->contact_1), "contact_2",
                      order_json(o->contact_2), "contact_3", order_json(o->contact_3), "cusp",
                      order_json(o->cusp), "summary", a[i]->summary, "reference", a[i]->reference, "default",
                      (int)(a[i] == intersector_default), "points_only", (int)a[i]->points_only);
        if (a[i]->foreign)
            json_object_set_new(row, "foreign", origin_json(a[i]));
        json_dumpf(row, stdout, JSON_COMPACT);
        putchar('\n');
        json_decref(row);
    }
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    struct request *r = (struct request *)state->input;
    const char *error;
    switch (key) {
    case 'j':
        r->json = true;
        return 0;
    case 'a':
    case ARGP_KEY_ARG:
        error = algorithms_named_add(&r->algorithms, argument);
        if (error)
            argp_error(state, "%s", error);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const char *argp_program_version = "fatline 0.1";

int main(int argc, char **argv)
{
    standard_output_watch();
    static const struct argp_option options[] = {
        {"json", 'j', 0, 0, "a row of JSON an algorithm", 0},
        {"algorithm", 'a', "LIST", 0, "only these: names, globs, `all`, `peers`, separated by commas", 0},
        {0, 0, 0, 0, 0, 0}};
    static const struct argp argp = {
        options,
        parse,
        "[ALGORITHM...]",
        "List the algorithms of this precision: name, the order of convergence per round that the reference "
        "claims "
        "at contact 1, 2, 3 and at a cusp (-: no claim), what it does, and where it comes from.",
        0,
        0,
        0};
    struct request r = {false, {NULL, 0, NULL}};
    if (argp_parse(&argp, argc, argv, 0, NULL, &r))
        return 64;
    if (r.json) {
        print_rows(r.algorithms.count ? r.algorithms.at : intersectors);
    } else if (r.algorithms.count) {
        print_table(r.algorithms.at);
    } else {
        print_table(intersectors);
        if (peers[0])
            printf("\nother people's, not among `all`; `peers` names them together\n");
        print_table(peers);
    }
    algorithms_named_clear(&r.algorithms);
    return 0;
}
