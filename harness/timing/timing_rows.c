/* See timing_rows.h. */
#include "timing_rows.h"

#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../run/row.h"
#include "statistics.h"

static const double level = 0.95;

struct ratio {
    bool known;
    double median;
    struct range range;
};

/* Of the times of contender k and of another in the same rounds. */
static struct ratio find_ratio(const struct timing_report *r, int k, int other)
{
    struct ratio ratio = {false, 0, {0, 0}};
    const struct clock_samples *a, *b;
    double *q;

    if (other < 0 || !r->timing[k].pairs || !r->timing[other].pairs ||
        !r->contender[k].algorithm != !r->contender[other].algorithm)
        return ratio;
    a = &r->timing[k].samples;
    b = &r->timing[other].samples;
    q = (double *)calloc(a->count, sizeof *q);
    if (!q)
        return ratio;
    for (int i = 0; i < a->count; i++)
        q[i] = a->ns[i] / b->ns[i];
    ratio.known = true;
    ratio.median = statistics_median(a->count, q);
    ratio.range = statistics_bootstrap_median(a->count, q, level, r->plan->clock.seed);
    free(q);
    return ratio;
}

static void set_real(json_t *row, const char *key, double value)
{
    json_object_set_new(row, key, json_real(value));
}

static void set_count(json_t *row, const char *key, int value)
{
    json_object_set_new(row, key, json_integer(value));
}

static void set_times(json_t *row, const struct timing *t, uint64_t seed)
{
    int n = t->samples.count;
    const double *ns = t->samples.ns;
    struct range range = statistics_bootstrap_median(n, ns, level, seed);
    struct outliers outliers = statistics_outliers(n, ns);
    json_t *samples = json_array();

    set_real(row, "ns_min", statistics_min(n, ns));
    set_real(row, "ns_q1", statistics_quantile(n, ns, 0.25));
    set_real(row, "ns_median", statistics_median(n, ns));
    set_real(row, "ns_q3", statistics_quantile(n, ns, 0.75));
    set_real(row, "ns_lo", range.lo);
    set_real(row, "ns_hi", range.hi);
    set_real(row, "ns_mad", statistics_mad(n, ns));
    set_real(row, "ns_max", t->ns_max);
    json_object_set_new(row, "worst_id", json_string(t->worst_id));
    set_count(row, "outliers_mild", outliers.mild);
    set_count(row, "outliers_severe", outliers.severe);
    set_real(row, "steps", t->steps);
    if (!isnan(t->roots))
        set_real(row, "roots", t->roots);
    set_count(row, "passes", t->samples.passes);
    for (int i = 0; i < n; i++)
        json_array_append_new(samples, json_real(ns[i]));
    json_object_set_new(row, "samples", samples);
}

static void set_counts(json_t *row, const struct timing_report *r, int k)
{
    const struct timing *t = &r->timing[k];

    set_count(row, "pairs", t->pairs);
    set_count(row, "family_pairs", r->pairs);
    set_count(row, "left_out", r->left_out);
    if (r->contender[k].limit)
        return;
    set_count(row, "right", t->right);
    set_count(row, "missing", t->missing);
    set_count(row, "wrong", t->wrong);
    set_count(row, "stopped", t->stopped);
    set_count(row, "not_taken", t->not_taken);
    set_count(row, "broken", t->broken);
}

static json_t *make_row(const struct timing_report *r, int k)
{
    const struct timing *t = &r->timing[k];
    json_t *row = json_object();

    json_object_set_new(row, "family", json_string(r->family));
    json_object_set_new(row, "algorithm", json_string(r->contender[k].name));
    json_object_set_new(row, "precision", json_string(REAL_NAME));
    json_object_set_new(row, "protocol",
                        json_string(r->single ? "single" : contender_protocol(&r->contender[k])));
    set_counts(row, r, k);
    set_real(row, "tolerance", real_to_double(r->plan->tolerance));
    if (r->plan->unchecked)
        json_object_set_new(row, "unchecked", json_true());
    if (r->plan->points > 0)
        set_real(row, "points", r->plan->points);
    if (t->pairs)
        set_times(row, t, r->plan->clock.seed);
    else
        json_object_set_new(row, "not_timed", json_string(t->why_not));
    if (r->instructions)
        json_object_set_new(row, "instructions",
                            isnan(r->instructions[k]) ? json_null() : json_real(r->instructions[k]));
    return row;
}

static void set_ratio(json_t *row, const struct ratio *ratio, const char *prefix)
{
    char key[32];

    if (!ratio->known)
        return;
    set_real(row, prefix, ratio->median);
    snprintf(key, sizeof key, "%s_lo", prefix);
    set_real(row, key, ratio->range.lo);
    snprintf(key, sizeof key, "%s_hi", prefix);
    set_real(row, key, ratio->range.hi);
}

void timing_rows_write(FILE *stream, const struct timing_report *r)
{
    for (int k = 0; k < r->contenders; k++) {
        json_t *row = make_row(r, k);
        struct ratio ratio = find_ratio(r, k, r->baseline), from_floor = find_ratio(r, k, r->limit);

        if (ratio.known)
            json_object_set_new(row, "baseline", json_string(r->contender[r->baseline].name));
        set_ratio(row, &ratio, "ratio");
        set_ratio(row, &from_floor, "floor_ratio");
        row_write(stream, row);
    }
    fflush(stream);
}

/* Four significant digits and a unit, as wide as a column. */
static const char *time_text(double ns, char text[16])
{
    static const char *const units[] = {"ns", "us", "ms", "s "};
    int unit = 0;

    while (ns >= 9999.5 && unit < 3) {
        ns /= 1000;
        unit++;
    }
    snprintf(text, 16, "%.4g %s", ns, units[unit]);
    return text;
}

static void write_ratios(FILE *stream, const struct timing_report *r, int k)
{
    struct ratio ratio = find_ratio(r, k, r->baseline), from_floor = find_ratio(r, k, r->limit);
    char text[80] = "";

    if (r->limit >= 0 && from_floor.known)
        snprintf(text, sizeof text, "%.2f", from_floor.median);
    if (r->limit >= 0)
        fprintf(stream, " %10s", text);
    if (r->instructions && !isnan(r->instructions[k]))
        fprintf(stream, " %12.0f", r->instructions[k]);
    else if (r->instructions)
        fprintf(stream, " %12s", "");
    text[0] = '\0';
    if (ratio.known)
        snprintf(text, sizeof text, "%7.3f [%.3f, %.3f]", ratio.median, ratio.range.lo, ratio.range.hi);
    if (r->baseline >= 0)
        fprintf(stream, "  %-28s", text);
}

static void write_table_line(FILE *stream, const struct timing_report *r, int k)
{
    const struct timing *t = &r->timing[k];
    const char *protocol = contender_protocol(&r->contender[k]);
    int n = t->samples.count;
    struct range range;
    struct outliers outliers;
    char median[16], lo[16], hi[16], slowest[16];

    fprintf(stream, "%-26s ", r->contender[k].name);
    if (!t->pairs) {
        fprintf(stream, "not timed: %s\n", t->why_not);
        return;
    }
    range = statistics_bootstrap_median(n, t->samples.ns, level, r->plan->clock.seed);
    outliers = statistics_outliers(n, t->samples.ns);
    fprintf(stream, "%6d %11s  %11s .. %-11s %6.1f%% %8d %9.1f %11s", t->right,
            time_text(statistics_median(n, t->samples.ns), median), time_text(range.lo, lo),
            time_text(range.hi, hi),
            100 * statistics_mad(n, t->samples.ns) / statistics_median(n, t->samples.ns),
            outliers.mild + outliers.severe, t->steps, time_text(t->ns_max, slowest));
    write_ratios(stream, r, k);
    fprintf(stream, "  %s%s\n", t->worst_id,
            !strcmp(protocol, "stream")  ? ""
            : !strcmp(protocol, "pipe")  ? " (over a pipe)"
            : !strcmp(protocol, "batch") ? " (in a batch of its own)"
                                         : " (by its own clock)");
}

void timing_table_write(FILE *stream, const struct timing_report *r)
{
    int timed = 0, rounds = 0;

    for (int k = 0; k < r->contenders; k++) {
        if (r->timing[k].pairs) {
            timed = r->timing[k].pairs;
            rounds = r->timing[k].samples.count;
        }
    }
    fprintf(stream, "%s: %s, tolerance %g; %d of %d pairs timed in %d rounds", r->family, REAL_NAME,
            real_to_double(r->plan->tolerance), timed, r->pairs, rounds);
    if (r->left_out)
        fprintf(stream, "; %d ambiguous or without a known answer", r->left_out);
    fprintf(stream, "\n%-26s %6s %11s  %26s %7s %8s %9s %11s", "algorithm", "right", "median",
            "95% interval      ", "MAD", "outliers", "steps", "slowest");
    if (r->limit >= 0)
        fprintf(stream, " %10s", "from floor");
    if (r->instructions)
        fprintf(stream, " %12s", "instructions");
    if (r->baseline >= 0)
        fprintf(stream, "  ratio to %-19s", r->contender[r->baseline].name);
    fprintf(stream, "  slowest pair\n");
    for (int k = 0; k < r->contenders; k++)
        write_table_line(stream, r, k);
    fprintf(stream, "\n");
    fflush(stream);
}
