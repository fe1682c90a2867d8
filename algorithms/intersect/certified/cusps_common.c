/* Two cusps with a common tangent: how many solutions there are at most, and where, by Rouche's theorem.
 *
 * Models.  x is along a direction e near both tangents, y across it; z and v are the level's parameters
 * less the centres, v scaled.  Take x without its powers 0 and 1, which vanish but for rounding, and the
 * coefficients as they are computed: so f has the model x = z^2 p(z) / A(z) = a z^2 (1 + ...), y = Y_f(z), g
 * x = c v^2 (1 + ...), y = Y_g(v), |c| = |a| (1 + d).  What was left out and rounding make the exact
 * coordinates differ from the model's by at most sums of powers of |z| with coefficients >= 0; all this holds
 * beyond the nodes too.
 *
 * Parameters.  For |z| <= r let p(z) / A(z) differ from a by at most q |a|, q <= 1/2.  Then T(z) = z sqrt(1 +
 * ...) differs from z by at most (1 - sqrt(1 - q)) |z|, for |sqrt(1 + w) - 1| <= 1 - sqrt(1 - |w|); so by
 * Rouche's theorem T takes each value |T| < R = r sqrt(1 - q) at one z, |z| < r.  By T, the model of f is x =
 * a T^2, y = sum of B_k T^k with |B_k| <= M R^-k, M >= |Y_f| for |z| <= r (Cauchy); B_0 to B_6 come from
 * power series in balls.  And |z| sqrt(1 - q) <= |T| <= |z| sqrt(1 + q).  That of g likewise: x = +-a (1 + d)
 * V^2, y = sum of D_k V^k.
 *
 * Counting.  Let rho <= R / 2 of both, and in D: |T| <= rho, |V| <= 9/8 rho, the exact x_f - x_g over a
 * differ from T^2 -+ V^2 by at most h, y_f - y_g from the models' by at most k.  Let h <= rho^2 / 4.  On the
 * way from the models to the exact curves x_f - x_g does not vanish where |V| = 9/8 rho: 81/64 - 1 > 1/4.
 * Where it vanishes with |T| = rho, +-V^2 = T^2 (1 + w) with |w| <= h / rho^2, so V is within h / rho of j T,
 * j one of the two roots of j^2 = +-1, for |sqrt(1 + w) - 1| <= |w|.  There y_f - y_g is nearer to
 *
 *     G_j(T) = Y_f(T) - Y_g(j T) = sum of (B_k - D_k j^k) T^k
 *
 * than k + L h / rho, L >= |Y_g'| on |V| <= 9/8 rho.  If in G_j the term of order p_j has a larger modulus
 * than all others and this together, there is no zero on the way on the border of D, so (Rouche, several
 * variables) D has as many solutions as the models have, which are the zeros of G_j for both j: the sum of
 * both p_j, with multiplicity, real or not.  That is 3 + 3 for two cusps, 3 + 4 if they agree to third order,
 * and so on.
 *
 * Where.  Over rho^2, rho^p_j, what has to be small are sums of powers of rho with coefficients >= 0, convex
 * in log rho: if it holds for the same p_j at two rho, it holds between, and no border there has a solution.
 * So all solutions in the larger D are in the smaller one.  Whatever has |z|, |v| <= rho / sqrt(1 + q) is in
 * D, and what is in D has |z| <= rho / sqrt(1 - q), |v| <= 9/8 of that: less than the former for half the
 * rho.
 *
 * Rounding.  All sums are of terms that are not negative, and err relatively by less than 8 (n + m + 32) eps;
 * what underflows is nothing against the errors of control points, at least eps. */
#include "cusps_model.h"

/* G_j for both j: of the coefficients the least and the largest modulus. */
struct sums {
    const struct model *f, *g;
    real least[2][SERIES + 1], most[2][SERIES + 1];
    real rho; /* the largest */
    real mismatch, slack;
};

static real power_of(real a, int k)
{
    real power = 1;
    for (int i = 0; i < k; i++) {
        power = power * a;
    }
    return power;
}

/* ---- the sums ---- */

/* |B_k - D_k j^k|: j = +-1, or +-i with the same modulus for both. */
static void sums_term(struct sums *c, int k, bool same)
{
    struct ball b = c->f->height.c[k], d = c->g->height.c[k];
    bool odd = k % 2;
    for (int i = 0; i < 2; i++) {
        bool plus = same ? i == 1 && odd : k % 4 == 2; /* -j^k = 1 */
        struct ball g = plus ? ball_add(b, d) : ball_subtract(b, d);
        c->least[i][k] = ball_least(g);
        c->most[i][k] = ball_most(g);
        if (!same && odd) {
            real lb = ball_least(b), ld = ball_least(d), mb = ball_most(b), md = ball_most(d);
            c->least[i][k] = real_sqrt(lb * lb + ld * ld) * (1 - 4 * REAL_EPSILON);
            c->most[i][k] = real_sqrt(mb * mb + md * md) * (1 + 4 * REAL_EPSILON);
        }
    }
}

static void sums_make(const struct model *f, const struct model *g, struct sums *out)
{
    real a = real_abs(f->bend);
    out->f = f;
    out->g = g;
    for (int k = 0; k <= SERIES; k++) {
        sums_term(out, k, f->bend * g->bend > 0);
    }
    out->rho = real_min(f->in, g->in) / 2;
    out->mismatch = real_abs(a - real_abs(g->bend)) / a + 16 * REAL_EPSILON;
    out->slack = 1 + 16 * (f->n + g->n + 32) * REAL_EPSILON;
}

/* k + L h / rho; or no finite one, where h is too large.  The terms of Y_g' past D_6 are at most M / R times
 * the sum of k x^(k-1), k > 6, for x = 9/8 rho / R <= 9/16: less than 7 x^6 / (1 - x)^2 < 37 x^6. */
static real sums_noise(const struct sums *c, real rho)
{
    const struct model *f = c->f, *g = c->g;
    real wide = rho * 9 / 8, s = f->out * rho, v = g->out * wide;
    real h = (model_away_x(f, s) + model_away_x(g, v)) / real_abs(f->bend) + c->mismatch * wide * wide;
    if (!(4 * h * c->slack <= rho * rho)) {
        return REAL_HUGE;
    }
    real steep = 37 * (g->most / g->in) * power_of(wide / g->in, SERIES);
    for (int k = 1; k <= SERIES; k++) {
        steep += k * ball_most(g->height.c[k]) * power_of(wide, k - 1);
    }
    return model_away_y(f, s) + model_away_y(g, v) + steep * (h / rho);
}

/* Does in both sums one term exceed all others and the noise?  Its order: p.  Terms past the sixth are at
 * most M (rho / R)^7 (1 + 1/2 + ...). */
static bool sums_dominated(const struct sums *c, real rho, real noise, int p[2])
{
    const struct model *f = c->f, *g = c->g;
    real past =
        2 * (f->most * power_of(rho / f->in, SERIES + 1) + g->most * power_of(rho / g->in, SERIES + 1));
    for (int i = 0; i < 2; i++) {
        real rest = noise + past, power = 1, size[SERIES + 1], lead = 0;
        for (int k = 0; k <= SERIES; k++, power = power * rho) {
            size[k] = c->most[i][k] * power;
            if (k == 0 || c->least[i][k] * power > lead) {
                lead = c->least[i][k] * power;
                p[i] = k;
            }
        }
        for (int k = 0; k <= SERIES; k++) {
            rest += k == p[i] ? (real)0 : size[k];
        }
        if (!(lead > rest * c->slack)) {
            return false;
        }
    }
    return true;
}

/* The largest rho over 2^(step / 4), about. */
static real rho_at(const struct sums *c, int step)
{
    static const int parts[4] = {64, 54, 45, 38}; /* of 64 */
    return real_ldexp(c->rho * parts[step % 4] / 64, -(step / 4));
}

static bool holds_at(const struct sums *c, int step, int p[2])
{
    real rho = rho_at(c, step);
    return sums_dominated(c, rho, sums_noise(c, rho), p);
}

static bool holds_too(const struct sums *c, int step, const int p[2])
{
    int other[2];
    return step >= 0 && step <= 4 * REAL_BITS && holds_at(c, step, other) && other[0] == p[0] &&
           other[1] == p[1];
}

/* The last of the steps, from `from` on, up or down, where it holds with the same p: they are an interval. */
static int last_of(const struct sums *c, int from, int way, const int p[2])
{
    int last = from, step = 4;
    for (; holds_too(c, last + way * step, p); step = 2 * step) {
        last += way * step;
    }
    for (; step > 0; step = step / 2) {
        if (holds_too(c, last + way * step, p)) {
            last += way * step;
        }
    }
    return last;
}

/* ---- two cusps ---- */

static void rescale(struct germ *a, real by)
{
    real power = 1;
    for (int k = 0; k <= a->n; k++) {
        real *part[5] = {&a->x[k], &a->y[k], &a->w[k], &a->error[k], &a->error_w[k]};
        for (int i = 0; i < 5; i++) {
            *part[i] = *part[i] * power;
        }
        a->error[k] += 2 * (k + 2) * REAL_EPSILON * (real_abs(a->x[k]) + real_abs(a->y[k]));
        a->error_w[k] += 2 * (k + 2) * REAL_EPSILON * real_abs(a->w[k]);
        power = power * by;
    }
    a->reach = a->reach / by * (1 + 4 * REAL_EPSILON);
}

/* From rho to own parameters; by: v's scale. */
static struct box box_out(const struct sums *c, real rho, real by)
{
    const real up = 1 + 16 * REAL_EPSILON;
    struct box b = {rho * c->f->out * up, rho * 9 / 8 * c->g->out * by * up};
    return b;
}

static struct box box_in(const struct sums *c, real rho, real by)
{
    const real down = 1 - 16 * REAL_EPSILON;
    struct box b = {rho / real_sqrt(1 + c->f->q) * down, rho / real_sqrt(1 + c->g->q) * by * down};
    return b;
}

static void ring_make(const struct sums *c, real by, int first, int last, const int p[2],
                      struct common_ring *out)
{
    real rho = rho_at(c, last);
    out->at_most = p[0] + p[1];
    out->clear = box_in(c, rho_at(c, first), by);
    out->core = box_out(c, rho, by);
}

/* From the outermost; if there are too many, without some before the last. */
static bool rings_find(const struct sums *c, real by, struct common *out)
{
    enum { OCTAVE = 4, STEPS_MAX = 64 * OCTAVE };
    out->rings = 0;
    for (int step = 0; step < STEPS_MAX; step += OCTAVE) {
        int p[2];
        if (!holds_at(c, step, p)) {
            continue;
        }
        int first = last_of(c, step, -1, p), last = last_of(c, step, 1, p);
        if (last >= first + OCTAVE || p[0] + p[1] == 0) {
            out->rings -= out->rings == COMMON_RINGS;
            ring_make(c, by, first, last, p, &out->ring[out->rings++]);
        }
        step = last;
    }
    return out->rings > 0;
}

bool cusps_common(const struct germ *f, const struct germ *g, struct common *out)
{
    struct germ b = *g;
    struct model of_f, of_g;
    struct sums sums;
    real ex = f->x[2], ey = f->y[2], length = real_sqrt(ex * ex + ey * ey);
    ex = ex / length;
    ey = ey / length;
    real a = (ex * f->x[2] + ey * f->y[2]) * g->w[0], c = (ex * g->x[2] + ey * g->y[2]) * f->w[0];
    if (!(real_abs(a) > 0) || !(real_abs(c) > 0)) {
        return false;
    }
    real by = real_sqrt(real_abs(a / c));
    rescale(&b, by);
    if (!model_make(f, ex, ey, &of_f) || !model_make(&b, ex, ey, &of_g)) {
        return false;
    }
    sums_make(&of_f, &of_g, &sums);
    return rings_find(&sums, by, out);
}
