#include "region_check.h"

#include <jansson.h>

#include "../run/row.h"

void region_check(struct region_checker *k, const struct region_case *c, const struct region_problem *p,
                  struct region_workspace *w, const struct region_answer *a)
{
    bool expects = c && json_is_object(json_object_get(c->line, "expected"));
    const char *wrong = a->outcome != SOLVED ? outcome_name(a->outcome) : NULL;
    if (!wrong && expects)
        wrong = region_check_expected(c, p, w, a);
    if (!wrong)
        wrong = region_check_sample(p, w, a);
    if (k->exact && a->method == region_methods[0]) {
        *k->exact = *a->region;
    } else if (k->exact && a->outcome == SOLVED) {
        wrong = wrong ? wrong : region_check_agree(p, w, k->exact, a->region);
        k->compared++;
    }
    k->regions++;
    k->wrong += wrong != NULL;
    k->certified += a->region->certified;
    k->expected += expects;
    k->sampled++;
    if (k->rows)
        row_write(stdout,
                  json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s?, s:b, s:i}", "id", a->id, "method",
                            a->method->name, "precision", REAL_NAME, "outcome", outcome_name(a->outcome),
                            "kind", region_kind_name(a->region->kind), "verdict", wrong ? "WRONG" : "RIGHT",
                            "why", wrong, "certified", (int)a->region->certified, "steps", (int)a->steps));
    else if (wrong)
        printf("%s %s %s: %s\n", a->id, REAL_NAME, a->method->name, wrong);
}

void region_check_summary(const struct region_checker *k, FILE *stream)
{
    fprintf(stream,
            "%ld regions, %ld wrong, %ld certified; %ld compared with what was expected, %ld with samples, "
            "%ld with another method\n",
            k->regions, k->wrong, k->certified, k->expected, k->sampled, k->compared);
}
