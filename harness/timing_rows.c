/* See timing_rows.h. */
#include "timing_rows.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "row.h"
#include "statistics.h"

static const double level = 0.95;

struct ratio {
    bool asked, known;
    double median;
    struct range range;
};

/* Of the times of two contenders in the same rounds. */
static struct ratio find_ratio(const struct contender *contender, const struct timing *timing, int k,
                               int baseline, uint64_t seed)
{
    struct ratio ratio = {baseline >= 0, false, 0, {0, 0}};
    const struct clock_samples *a, *b;
    double *q;

    if (baseline < 0 || !timing[k].pairs || !timing[baseline].pairs ||
        !contender[k].algorithm != !contender[baseline].algorithm)
        return ratio;
    a = &timing[k].samples;
    b = &timing[baseline].samples;
    q = (double *)calloc(a->count, sizeof *q);
    if (!q)
        return ratio;
    for (int i = 0; i < a->count; i++)
        q[i] = a->ns[i] / b->ns[i];
    ratio.known = true;
    ratio.median = statistics_median(a->count, q);
    ratio.range = statistics_bootstrap_median(a->count, q, level, seed);
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
    struct range range = statistics_bootstrap_median(n, t->samples.ns, level, seed);
    json_t *samples = json_array();

    set_real(row, "ns_min", statistics_min(n, t->samples.ns));
    set_real(row, "ns_median", statistics_median(n, t->samples.ns));
    set_real(row, "ns_lo", range.lo);
    set_real(row, "ns_hi", range.hi);
    set_real(row, "ns_mad", statistics_mad(n, t->samples.ns));
    set_real(row, "ns_max", t->ns_max);
    json_object_set_new(row, "worst_id", json_string(t->worst_id));
    set_real(row, "steps", t->steps);
    set_count(row, "passes", t->samples.passes);
    for (int i = 0; i < n; i++)
        json_array_append_new(samples, json_real(t->samples.ns[i]));
    json_object_set_new(row, "samples", samples);
}

static json_t *make_row(const char *family, int pairs, int left_out, const struct contender *contender,
                        const struct timing *t, const struct timing_plan *plan)
{
    json_t *row = json_object();

    json_object_set_new(row, "family", json_string(family));
    json_object_set_new(row, "algorithm", json_string(contender->name));
    json_object_set_new(row, "precision", json_string(REAL_NAME));
    json_object_set_new(row, "protocol", json_string(contender->algorithm ? "stream" : "pipe"));
    set_count(row, "pairs", t->pairs);
    set_count(row, "family_pairs", pairs);
    set_count(row, "left_out", left_out);
    set_count(row, "right", t->right);
    set_count(row, "missing", t->missing);
    set_count(row, "wrong", t->wrong);
    set_count(row, "stopped", t->stopped);
    set_count(row, "not_taken", t->not_taken);
    set_real(row, "tolerance", real_to_double(plan->tolerance));
    if (plan->unchecked)
        json_object_set_new(row, "unchecked", json_true());
    if (t->pairs)
        set_times(row, t, plan->clock.seed);
    else
        json_object_set_new(row, "not_timed", json_string(t->why_not));
    return row;
}

void timing_rows_write(FILE *stream, const char *family, int pairs, int left_out, int n,
                       const struct contender *contender, const struct timing *timing,
                       const struct timing_plan *plan, int baseline)
{
    for (int k = 0; k < n; k++) {
        json_t *row = make_row(family, pairs, left_out, &contender[k], &timing[k], plan);
        struct ratio ratio = find_ratio(contender, timing, k, baseline, plan->clock.seed);

        if (ratio.known) {
            json_object_set_new(row, "baseline", json_string(contender[baseline].name));
            set_real(row, "ratio", ratio.median);
            set_real(row, "ratio_lo", ratio.range.lo);
            set_real(row, "ratio_hi", ratio.range.hi);
        }
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

static void write_table_line(FILE *stream, const struct contender *contender, const struct timing *t,
                             const struct ratio *ratio, uint64_t seed)
{
    int n = t->samples.count;
    struct range range;
    char median[16], lo[16], hi[16], slowest[16], compared[80] = "";

    fprintf(stream, "%-24s ", contender->name);
    if (!t->pairs) {
        fprintf(stream, "not timed: %s\n", t->why_not);
        return;
    }
    range = statistics_bootstrap_median(n, t->samples.ns, level, seed);
    fprintf(stream, "%6d %11s  %11s .. %-11s %6.1f%% %9.1f %11s", t->right,
            time_text(statistics_median(n, t->samples.ns), median), time_text(range.lo, lo),
            time_text(range.hi, hi),
            100 * statistics_mad(n, t->samples.ns) / statistics_median(n, t->samples.ns), t->steps,
            time_text(t->ns_max, slowest));
    if (ratio->known)
        snprintf(compared, sizeof compared, "%7.3f [%.3f, %.3f]", ratio->median, ratio->range.lo,
                 ratio->range.hi);
    if (ratio->asked)
        fprintf(stream, "  %-28s", compared);
    fprintf(stream, "  %s%s\n", t->worst_id, contender->algorithm ? "" : " (over a pipe)");
}

void timing_table_write(FILE *stream, const char *family, int pairs, int left_out, int n,
                        const struct contender *contender, const struct timing *timing,
                        const struct timing_plan *plan, int baseline)
{
    int timed = 0, rounds = 0;

    for (int k = 0; k < n; k++) {
        if (timing[k].pairs) {
            timed = timing[k].pairs;
            rounds = timing[k].samples.count;
        }
    }
    fprintf(stream, "%s: %s, tolerance %g; %d of %d pairs timed in %d rounds", family, REAL_NAME,
            real_to_double(plan->tolerance), timed, pairs, rounds);
    if (left_out)
        fprintf(stream, "; %d ambiguous or without a known answer", left_out);
    fprintf(stream, "\n%-24s %6s %11s  %26s %7s %9s %11s", "algorithm", "right", "median",
            "95% interval      ", "MAD", "steps", "slowest");
    if (baseline >= 0)
        fprintf(stream, "  ratio to %-19s", contender[baseline].name);
    fprintf(stream, "  slowest pair\n");
    for (int k = 0; k < n; k++) {
        struct ratio ratio = find_ratio(contender, timing, k, baseline, plan->clock.seed);

        write_table_line(stream, &contender[k], &timing[k], &ratio, plan->clock.seed);
    }
    fprintf(stream, "\n");
    fflush(stream);
}
