#include "order_estimate.h"

#include <math.h>
#include <stdlib.h>

#include "regression.h"

/* No method here has an order between 1 and 5/4; a linear one that is misread as 1.1 is a measuring error. */
static const double ORDER_LEAST = 1.15;

enum {
    POINTS_LEAST = 4,  /* boxes */
    STEPS_LEAST = 12,  /* narrowings, for blocks */
    EXACT_FACTOR = 16, /* no order known gains so much in a round */
    EXACT_BITS = 2
};
static const double BITS_LEAST = 0.01; /* a round, or it is stalled */
static const double WIDEST = 0.15;     /* interval over order: what is wider tells two orders apart no more */

const char *law_name(enum law law)
{
    static const char *const names[] = {"superlinear", "linear", "stalled", "exact", "too_few"};
    return names[law];
}

static struct order_estimate nothing(int n)
{
    struct order_estimate e = {TOO_FEW, NAN, NAN, NAN, n, 0, NAN};
    return e;
}

/* What is above the floor. */
struct widths {
    int steps, rounds;
    double *step;  /* bits after each narrowing, the start included */
    double *round; /* bits at the ends of rounds, the start included */
    int *clips;    /* narrowings in each round; clips[0] = 0 */
    double beyond; /* bits at the end of the first round that passed the floor; 0: none */
};

static void gather(int n, const double *bits_t, const double *bits_s, double floor, struct widths *w)
{
    int last = 0;
    for (int i = 0; i < n; i++) {
        bool ended = i == 0 || (bits_t[i] > bits_t[last] && bits_s[i] > bits_s[last]);
        double bits = (bits_t[i] + bits_s[i]) / 2;
        bool below = bits_t[i] > floor || bits_s[i] > floor;
        if (!below)
            w->step[w->steps++] = bits;
        if (ended && below) {
            w->beyond = bits;
            return;
        }
        if (ended) {
            w->clips[w->rounds] = i - last;
            w->round[w->rounds++] = bits;
            last = i;
        }
    }
}

static bool estimate_superlinear(const struct widths *w, struct order_estimate *e)
{
    if (w->rounds < 4)
        return false;
    const double *end = w->round + w->rounds - 1;
    const int *clips = w->clips + w->rounds - 1;
    double gain = end[0] - end[-1];
    double order = gain / (end[-1] - end[-2]), before = (end[-1] - end[-2]) / (end[-2] - end[-3]);
    double reach = fabs(order - before);
    if (!(order > ORDER_LEAST && before > ORDER_LEAST && gain > 0.1 * end[0]) || clips[0] != clips[-1] ||
        clips[0] != clips[-2])
        return false;
    *e = (struct order_estimate){SUPERLINEAR, order, order - reach, order + reach, w->rounds, clips[0], NAN};
    return true;
}

static struct order_estimate estimate_by_blocks(const struct widths *w)
{
    struct order_estimate e = nothing(w->steps);
    int block = (w->steps - 1) / 3;
    double most = -INFINITY, least = INFINITY;
    for (int shift = 0; shift < block; shift++) {
        const double *end = w->step + w->steps - 1 - shift;
        double order = pow((end[0] - end[-block]) / (end[-block] - end[-2 * block]), 2.0 / block);
        least = fmin(least, order);
        most = fmax(most, order);
        if (shift == 0)
            e.per_round = order;
    }
    e.lo = least;
    e.hi = most;
    if (least > ORDER_LEAST) {
        e.law = SUPERLINEAR;
    } else if (e.per_round <= ORDER_LEAST) {
        const double *end = w->step + w->steps - 1;
        e.bits_per_round = 2 * (end[0] - end[-2 * block]) / (2 * block);
        e.law = e.bits_per_round < BITS_LEAST ? STALLED : LINEAR;
    } else {
        e.per_round = e.lo = e.hi = NAN;
    }
    return e;
}

struct order_estimate order_of_widths(int n, const double *bits_t, const double *bits_s, double floor)
{
    struct widths w = {0, 0, NULL, NULL, NULL, 0};
    struct order_estimate e;
    w.step = malloc(((size_t)n + 1) * sizeof *w.step);
    w.round = malloc(((size_t)n + 1) * sizeof *w.round);
    w.clips = malloc(((size_t)n + 1) * sizeof *w.clips);
    if (!w.step || !w.round || !w.clips)
        exit(2);
    gather(n, bits_t, bits_s, floor, &w);
    e = nothing(w.rounds);
    if (!estimate_superlinear(&w, &e)) {
        if (w.rounds > 0 && w.beyond >= EXACT_FACTOR * (w.round[w.rounds - 1] + EXACT_BITS))
            e.law = EXACT;
        else if (w.steps >= STEPS_LEAST)
            e = estimate_by_blocks(&w);
    }
    free(w.step);
    free(w.round);
    free(w.clips);
    return e;
}

struct order_estimate order_of_boxes(int n, const double *before, const double *after, int below)
{
    struct order_estimate e = nothing(n);
    if (n < POINTS_LEAST) {
        e.law = below > 2 * POINTS_LEAST && n == 0 ? EXACT : TOO_FEW;
        return e;
    }
    struct line_fit all = line_fit(n, before, after);
    struct line_fit small = line_fit(n - n / 2, before + n / 2, after + n / 2);
    e.per_round = small.slope;
    e.lo = fmin(small.lo, all.slope);
    e.hi = fmax(small.hi, all.slope);
    e.law = SUPERLINEAR;
    if (small.slope <= ORDER_LEAST) {
        double gain = 0;
        for (int i = n / 2; i < n; i++)
            gain += (after[i] - before[i]) / (n - n / 2);
        e.bits_per_round = gain;
        e.law = gain < BITS_LEAST ? STALLED : LINEAR;
    } else if (e.hi - e.lo > WIDEST * e.per_round) {
        e = nothing(n);
    }
    return e;
}
