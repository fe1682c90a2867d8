#include "family.h"

#include "../core/bernstein.h"
#include "cone.h"
#include "form.h"

enum { COLUMNS = 4 }; /* S1, S2, W, eta */

/* ---- handles ---- */

static void clear_shares(const struct control_family *f, real *share)
{
    for (int j = 0; j < f->count; j++) {
        share[j] = 0;
    }
}

void family_of_point(struct control_family *f, int i, real *share)
{
    family_of_group(f, 1, &i, share);
}

void family_of_group(struct control_family *f, int members, const int *member, real *share)
{
    clear_shares(f, share);
    for (int k = 0; k < members; k++) {
        share[member[k]] = 1;
    }
    f->share = share;
    f->at.x = f->x[member[0]];
    f->at.y = f->y[member[0]];
}

/* Largest k with knots[k] <= t < knots[k + 1], or the last span. */
static int span_at(const struct control_family *f, real t)
{
    int k = f->count - 1;
    while (k > f->degree && (t < f->knots[k] || !(f->knots[k] < f->knots[k + 1]))) {
        k--;
    }
    return k;
}

/* The degree + 1 basis functions that do not vanish on span k, by Cox and de Boor. */
static void basis(const struct control_family *f, int k, real t, real *b)
{
    b[0] = 1;
    for (int n = 1; n <= f->degree; n++) {
        b[n] = 0;
        for (int j = n; j >= 0; j--) {
            real left = 0, right = 0;
            if (j > 0) {
                real lo = f->knots[k - n + j], hi = f->knots[k + j];
                left = b[j - 1] * ((t - lo) / (hi - lo));
            }
            if (j < n) {
                real lo = f->knots[k - n + j + 1], hi = f->knots[k + j + 1];
                right = b[j] * ((hi - t) / (hi - lo));
            }
            b[j] = left + right;
        }
    }
}

void family_of_drag(struct control_family *f, real t, real *share)
{
    real b[DEGREE_MAX + 1], sum = 0, squares = 0;
    int k = span_at(f, t);
    clear_shares(f, share);
    basis(f, k, t, b);
    for (int i = 0; i <= f->degree; i++) {
        b[i] = b[i] * (f->weight ? f->weight[k - f->degree + i] : (real)1);
        sum += b[i];
    }
    f->at.x = f->at.y = 0;
    for (int i = 0; i <= f->degree; i++) {
        int j = k - f->degree + i;
        b[i] = b[i] / sum;
        f->at.x += b[i] * f->x[j];
        f->at.y += b[i] * f->y[j];
        squares += b[i] * b[i];
    }
    for (int i = 0; i <= f->degree; i++) {
        share[k - f->degree + i] = b[i] / squares;
    }
    f->share = share;
}

/* ---- coordinates ---- */

/* Box of the control points that do not move, or of all if all do: (lo, hi) of x and of y. */
static void find_box(const struct control_family *f, real box[2][2])
{
    bool any = false;
    for (int j = 0; j < f->count; j++) {
        any = any || f->share[j] == 0;
    }
    bool first = true;
    for (int j = 0; j < f->count; j++) {
        if (any && f->share[j] != 0) {
            continue;
        }
        const real p[2] = {f->x[j], f->y[j]};
        for (int c = 0; c < 2; c++) {
            box[c][0] = first ? p[c] : real_min(box[c][0], p[c]);
            box[c][1] = first ? p[c] : real_max(box[c][1], p[c]);
        }
        first = false;
    }
}

static void normalise(const struct control_family *f, struct region_work *k)
{
    real box[2][2] = {{0, 0}, {0, 0}};
    find_box(f, box);
    k->centre_x = box[0][0] + (box[0][1] - box[0][0]) / 2;
    k->centre_y = box[1][0] + (box[1][1] - box[1][0]) / 2;
    real size = real_max(box[0][1] - box[0][0], box[1][1] - box[1][0]) / 2;
    if (!(size > 0)) { /* all in one place: the distance of the handle gives the scale */
        size = real_max(real_abs(f->at.x - k->centre_x), real_abs(f->at.y - k->centre_y));
    }
    k->scale = size > 0 ? real_ldexp(1, real_exponent(size)) : (real)1;
}

void family_point_in(const struct region_work *k, struct point d, real *v)
{
    v[0] = (d.x - k->centre_x) / k->scale;
    v[1] = (d.y - k->centre_y) / k->scale;
    v[2] = 1;
    triple_normalise(v);
}

struct point family_point_out(const struct region_work *k, const real *v)
{
    struct point d = {k->centre_x + k->scale * (v[0] / v[2]), k->centre_y + k->scale * (v[1] / v[2])};
    return d;
}

void family_line_out(const struct region_work *k, const real *l, real *line)
{
    real length = real_sqrt(l[0] * l[0] + l[1] * l[1]);
    line[0] = l[0] / length;
    line[1] = l[1] / length;
    line[2] = k->scale * (l[2] / length) - (line[0] * k->centre_x + line[1] * k->centre_y);
}

/* ---- spans ---- */

int family_spans(const struct control_family *f, const struct interval *i)
{
    int spans = 0;
    for (int k = f->degree; k < f->count; k++) {
        spans += real_max(f->knots[k], i->lo) < real_min(f->knots[k + 1], i->hi);
    }
    return spans;
}

/* S1, S2, W, eta of control point j in normalised coordinates. */
static void control_column(const struct control_family *f, const struct region_work *k, int j, real *column)
{
    real w = f->weight ? f->weight[j] : (real)1, share = f->share[j];
    column[0] = (w / k->scale) * ((f->x[j] - k->centre_x) - share * (f->at.x - k->centre_x));
    column[1] = (w / k->scale) * ((f->y[j] - k->centre_y) - share * (f->at.y - k->centre_y));
    column[2] = w;
    column[3] = w * share;
}

/* Bernstein coefficients over [a, b] inside the knot span k: coefficient i is the blossom at (a^(n-i), b^i).
 * d holds the control points k-n..k of each column.  First a is inserted until it stands n times to the left
 * of the knots k+1..k+n, then b; every step is a convex combination. */
static void extract(const struct control_family *f, int k, real a, real b, real (*d)[DEGREE_MAX + 1])
{
    int n = f->degree;
    const real *knots = f->knots;
    real q[COLUMNS][DEGREE_MAX + 1];
    for (int c = 0; c < COLUMNS; c++) {
        q[c][n] = d[c][n];
    }
    for (int round = 1; round <= n; round++) {
        for (int j = n; j >= round; j--) {
            real left = knots[k - n + j], right = knots[k + 1 + j - round];
            real v = (a - left) / (right - left), u = (right - a) / (right - left);
            for (int c = 0; c < COLUMNS; c++) {
                d[c][j] = u * d[c][j - 1] + v * d[c][j];
            }
        }
        for (int c = 0; c < COLUMNS; c++) {
            q[c][n - round] = d[c][n];
        }
    }
    for (int round = 1; round <= n; round++) {
        for (int j = n; j >= round; j--) {
            real right = knots[k + 1 + j - round];
            real v = (b - a) / (right - a), u = (right - b) / (right - a);
            for (int c = 0; c < COLUMNS; c++) {
                q[c][j] = u * q[c][j - 1] + v * q[c][j];
            }
        }
    }
    for (int c = 0; c < COLUMNS; c++) {
        for (int i = 0; i <= n; i++) {
            d[c][i] = q[c][i];
        }
    }
}

/* The sign of the problem goes into L. */
static void finish_span(struct span *s, int sign)
{
    const struct span_forms *f = &s->form;
    int length = f->l + 1;
    for (int i = 0; sign < 0 && i < 3 * length; i++) {
        f->L[i] = -f->L[i];
    }
    s->error = 0;
    for (int i = 3 * length; i < 4 * length; i++) {
        s->error = real_max(s->error, f->L[i]);
    }
    s->error = s->error * REAL_EPSILON;
}

static void make_span(const struct region_problem *p, int knot, struct region_work *k, struct span *s)
{
    const struct control_family *f = &p->family;
    real d[COLUMNS][DEGREE_MAX + 1], column[COLUMNS];
    int n = f->degree;
    s->lo = real_max(f->knots[knot], p->interval.lo);
    s->hi = real_min(f->knots[knot + 1], p->interval.hi);
    for (int j = 0; j <= n; j++) {
        control_column(f, k, knot - n + j, column);
        for (int c = 0; c < COLUMNS; c++) {
            d[c][j] = column[c];
        }
    }
    extract(f, knot, s->lo, s->hi, d);
    struct span_input input = {n, d[0], d[1], d[3], f->weight ? d[2] : NULL};
    span_forms_make(&input, k->pascal, &s->form);
    finish_span(s, p->sign);
}

/* L vanishes at a span's end: inside the interval no d is regular there; at an end of it only that end is
 * not. */
static void note_bare_ends(struct region_work *k)
{
    for (int i = 0; i < k->spans; i++) {
        const struct span_forms *f = &k->span[i].form;
        bool still = f->still || (f->l == 0 && f->L[0] == 0 && f->L[1] == 0 && f->L[2] == 0);
        k->singular = k->singular || still || (f->bare_start && i > 0) || (f->bare_end && i + 1 < k->spans);
        k->strict = k->strict && !(f->bare_start && i == 0) && !(f->bare_end && i + 1 == k->spans);
    }
}

void family_prepare(const struct region_problem *p, struct region_work *k)
{
    const struct control_family *f = &p->family;
    k->sign = p->sign;
    k->degree = f->degree;
    k->rational = f->weight != NULL;
    k->loop_free = p->loop_free;
    k->spans = 0;
    k->strict = true;
    k->singular = false;
    normalise(f, k);
    for (int knot = f->degree; knot < f->count; knot++) {
        if (real_max(f->knots[knot], p->interval.lo) < real_min(f->knots[knot + 1], p->interval.hi)) {
            make_span(p, knot, k, &k->span[k->spans++]);
        }
    }
    note_bare_ends(k);
}
