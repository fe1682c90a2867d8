/* The cross-product test: do all directions of f cross all directions of g the same way?
 *
 * Theorem.  Let f over its node have directions A_i and pace between p and P, that is f'(t) = pace(t) sum
 * l_i(t) A_i with l_i >= 0 of sum 1; g likewise B_j and q, Q; V_f, V_g the largest 1-norms of A_i, B_j.  Let
 * cross(A_i, B_j) >= c > 0 for all i, j (or <= -c), and f~, g~ be f and g extended past their ends by their
 * tangents.  Then H(t, s) = f~(t) - g~(s) is a homeomorphism of the plane, so it has one zero, and for all x
 * = (t, s), x' = (t', s')
 *
 *     |t - t'| <= V_g |H(x) - H(x')| / (p c),    |s - s'| <= V_f |H(x) - H(x')| / (q c),    |.| the maximum
 * norm.
 *
 * Proof.  f~' is f' at the nearest parameter of the node, so f~(t) - f~(t') is the integral of pace sum l_i
 * A_i = (t - t') a U, where a >= p is the mean of the pace and U, a mean of the A_i with the weights pace
 * l_i, lies in their convex hull; g~(s) - g~(s') = (s - s') b W likewise.  By bilinearity cross(U, W) >= c.
 * With r = H(x) - H(x') = (t - t') a U - (s - s') b W,
 *
 *     cross(r, W) = (t - t') a cross(U, W),    cross(r, U) = (s - s') b cross(U, W),
 *
 * and |cross(r, W)| <= |r| |W|_1 <= |r| V_g.  So H is injective and proper, and continuous: onto by
 * invariance of domain.
 *
 * Polynomial curves: A_i the differences of the control points, pace = n.  Rational curves: f' = n N / W^2
 * with N the polynomial of degree 2n - 2 whose Bernstein coefficients are the directions, so pace = n / W^2,
 * between n / max W^2 and n / min W^2 over the node's weights; p and q are all that enters, the largest
 * weights squared.
 *
 * Hence n m cross products (or (2n-1)(2m-1)) give existence, uniqueness and an error bound at once: a
 * solution lies in the nodes if and only if the zero of H does.
 *
 * Rounding.  A coordinate of A_i errs by e_f, of B_j by e_g; V_f and V_g cover the exact and the computed
 * directions.  So a cross product errs by e_f V_g + e_g V_f, and rounding adds at most 4 u V_f V_g
 * (tests/proofs/cross.g), with u V_f <= 4 u S w^2 + 2 u e_f <= e_f / 8 less than half of e_f V_g + e_g V_f:
 * 1.5 (e_f V_g + e_g V_f), computed to 4 u of itself (cross_bound.g), covers all. */
#include "evaluate.h"

struct range {
    real lo, hi;
};

static inline void include(struct range *r, real a)
{
    r->lo = real_min(r->lo, a);
    r->hi = real_max(r->hi, a);
}

static inline real certain(const struct range *r, const struct node *f, const struct node *g)
{
    real bound = (real)1.5 * (f->error * g->speed + g->error * f->speed);
    real c = (r->lo > 0 ? r->lo : -r->hi) - bound;
    return c > 0 ? c : (real)0;
}

static inline real gap_of(const int k, const int l, const struct node *f, const struct node *g)
{
    const real *ax = f->way, *ay = ax + k, *bx = g->way, *by = bx + l;
    real first = cross(ax[0], ay[0], bx[0], by[0]);
    struct range r = {first, first};
    /* the outermost directions mostly come first and last */
    include(&r, cross(ax[k - 1], ay[k - 1], bx[l - 1], by[l - 1]));
    include(&r, cross(ax[k - 1], ay[k - 1], bx[0], by[0]));
    include(&r, cross(ax[0], ay[0], bx[l - 1], by[l - 1]));
    if (r.lo <= 0 && r.hi >= 0) {
        return 0;
    }
    for (int i = 0; i < k; i++) {
        for (int j = 0; j < l; j++) {
            include(&r, cross(ax[i], ay[i], bx[j], by[j]));
        }
        if (r.lo <= 0 && r.hi >= 0) {
            return 0;
        }
    }
    return certain(&r, f, g);
}

real cone_gap(const struct node *f, const struct node *g)
{
    if (f->ways == 3 && g->ways == 3) {
        return gap_of(3, 3, f, g);
    }
    if (f->ways == 2 && g->ways == 2) {
        return gap_of(2, 2, f, g);
    }
    return gap_of(f->ways, g->ways, f, g);
}
