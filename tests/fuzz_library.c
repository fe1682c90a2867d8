/* libFuzzer on the library's entries: bit patterns as control points, weights, degrees.  `make fuzz` runs it.
 *
 * Whatever the numbers are: the call ends within its steps and writes nowhere else; what is no problem is
 * INVALID and nothing else is; records are sorted and within [0, 1]; exchanging the curves exchanges the
 * records bit for bit.  And the records are true of the curves of the given doubles, evaluated with 113 bits
 * (fuzz_referee.h): a UNIQUE holds the solution that Newton's method finds from its middle, and no other;
 * every solution found from anywhere is in some record, and in no two that claim one; a CLUSTER holds no more
 * than it says.  So of a pair of curves; fuzz_batch.h and fuzz_paths.h say it of many. */
#include "fuzz_batch.h"
#include "fuzz_paths.h"

/* ---- a pair ---- */

/* The same control points and, up to a factor, weights: then there is nothing to exchange. */
static bool is_same_curve(const struct fatline_curve *f, const struct fatline_curve *g)
{
    bool same = f->degree == g->degree && !f->weights == !g->weights;
    for (int i = 0; same && i <= f->degree; i++) {
        same = f->points[2 * i] == g->points[2 * i] && f->points[2 * i + 1] == g->points[2 * i + 1];
        same = same &&
               (!f->weights || (quad)f->weights[i] * g->weights[0] == (quad)g->weights[i] * f->weights[0]);
    }
    return same;
}

static void check_exchanged(const struct fatline_answer *a, const struct fatline_answer *b)
{
    require(a->outcome == b->outcome && a->count == b->count && a->overlaps == b->overlaps);
    for (int i = 0; i < a->count && i < SEEN; i++) {
        const struct fatline_crossing *c = &a->crossing[i];
        bool found = false;
        for (int j = 0; j < b->count && !found; j++) {
            const struct fatline_crossing *d = &b->crossing[j];
            found = c->t_lo == d->s_lo && c->t_hi == d->s_hi && c->s_lo == d->t_lo && c->s_hi == d->t_hi &&
                    c->standing == d->standing && c->at_most == d->at_most;
        }
        require(found);
    }
}

static void try_pair(struct input *in, const uint8_t *data, size_t length)
{
    static struct kept one, other;
    struct drawn f, g;
    int n = take(in) % LENGTH, m = take(in) % LENGTH;
    if (take(in) < 200) {
        n = n % 5;
        m = m % 5;
    }
    uint8_t kinds = take(in), like = take(in);
    draw(in, &f, n, kinds % 4 == 3, kinds >= 240);
    if (like < 192)
        draw(in, &g, m, kinds / 4 % 4 == 3, false);
    else
        draw_like(in, &f, like & 1, like & 2, &g);
    struct fatline_options o = draw_options(in);
    int degree = n > g.curve.degree ? n : g.curve.degree, most = degree < 1 ? 1 : degree > 32 ? 32 : degree;
    solve(most, &f.curve, &g.curve, &o, &one);
    solve(most, &g.curve, &f.curve, &o, &other);
    bool valid = is_valid(&f.curve, most) && is_valid(&g.curve, most);
    require(valid == (one.answer.outcome != FATLINE_INVALID));
    check_form(&one.answer);
    if (!PLANTED && !is_same_curve(&f.curve, &g.curve))
        check_exchanged(&one.answer, &other.answer);
    if (valid)
        require(referee_agrees(&f.curve, &g.curve, &one.answer, data, length));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length)
{
    struct input in = {data, length};
    uint8_t which = take(&in) % 4;
    if (which < 2)
        try_pair(&in, data, length);
    else if (which == 2)
        try_batch(&in, data, length);
    else
        try_paths(&in);
    return 0;
}
