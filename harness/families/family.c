#include <string.h>

#include "family.h"

const struct family families[] = {
    {"random", "control points uniform in the unit square, 20 bits", family_random, 1, 1, 32, 32},
    {"nice", "one clean crossing, proved to be the only one", family_nice, 1, 1, 32, 8},
    {"nine", "as many crossings as Bezout allows (nine for cubics), all simple", family_nine, 1, 1, 16, 0},
    {"many", "two oscillating curves with up to n m crossings", family_many, 2, 2, 16, 0},
    {"far", "boxes apart", family_far, 1, 1, 32, 32},
    {"near_disjoint", "two curves side by side, 2^-4 to 2^-20 of their size apart", family_near_disjoint, 1,
     1, 32, 32, .same_degrees = true},
    {"endpoint", "an end of one curve inside the other, one crossing", family_endpoint, 1, 1, 32, 8},
    {"shared_end", "a common end, nothing else", family_shared_end, 1, 1, 32, 32},
    {"smooth_join", "one curve goes on from the other with the same tangent", family_smooth_join, 2, 2, 32,
     32},
    {"tangent_same", "contact 2, curved to the same side", family_tangent_same, 2, 2, 8, 8},
    {"tangent_opposite", "contact 2, curved to opposite sides", family_tangent_opposite, 2, 2, 8, 8},
    {"endpoint_tangent", "contact 2 at an end of one curve or of both", family_endpoint_tangent, 2, 2, 8, 8},
    {"contact_3", "contact 3: same curvature, every third case an inflection", family_contact_3, 2, 2, 8, 8},
    {"contact_4", "contact 4", family_contact_4, 2, 3, 8, 8, .low_rational = 3},
    {"near_tangent", "a gap of 2^-5 to 2^-50 from contact 2: even cases two roots, odd ones none",
     family_near_tangent, 2, 2, 8, 8},
    {"cusp_crossed", "a cusp crossed across its tangent", family_cusp_crossed, 1, 3, 8, 8},
    {"cusp_along", "a cusp met along its tangent", family_cusp_along, 1, 3, 8, 8},
    {"two_cusps", "cusp at cusp: even cases tangents cross, odd ones they agree", family_two_cusps, 3, 3, 8,
     8},
    {"zero_end", "doubled end points: at the crossing, at a shared end, elsewhere", family_zero_end, 2, 2, 8,
     8},
    {"overlap", "a common arc: sub-arc, reversed, elevated, reparametrised", family_overlap, 1, 1, 8, 32,
     .same_degrees = true},
    {"size_mismatch", "one curve 2^-1 to 2^-40 of the size of the other", family_size_mismatch, 1, 1, 16, 16},
    {"degree_sweep", "one pair of parabolas at every degree, by elevation", family_degree_sweep, 2, 2, 32, 0,
     .any_degree_stream = true},
    {"circle_crossing", "two circular arcs through one point", family_circle_crossing, 2, 2, 6, 6,
     .own_weights = true},
    {"circle_tangent", "two circular arcs that touch, from inside or outside", family_circle_tangent, 2, 2, 6,
     6, .own_weights = true},
    {"on_cut", "random, with a crossing where both parameters are short binary fractions", family_on_cut, 1,
     1, 12, 0},
    {"sliver", "random, flattened by 2^-1 to 2^-28 in some direction", family_sliver, 1, 1, 32, 0},
    {"scaled", "random, times 2^-498 to 2^498, moved by up to 2^30 of its size", family_scaled, 1, 1, 32, 0},
    {"overlap_beside", "a common arc of a curve that may cross itself", family_overlap_beside, 1, 3, 8, 0},
    {"near_overlap", "an overlap, the one curve moved by 2^-1 to 2^-36 of a unit", family_near_overlap, 1, 1,
     8, 0},
    {"point_curve", "all control points of one curve are equal: on the other curve, or anywhere",
     family_point_curve, 1, 1, 12, 0},
    {"sizes", "coordinates of very different sizes: 0, 1, 2^-10, 2^-26, ..., 2^-500", family_sizes, 1, 1, 8,
     0},
    {NULL}};

const char *family_refuses(const struct family *a, int n, int m, bool weights, char why[160])
{
    int low = n < m ? n : m, high = n < m ? m : n, max = weights ? a->max_rational : a->max;
    int least = weights && a->low_rational ? a->low_rational : a->low;
    if (weights && !a->max_rational)
        snprintf(why, 160, "%s has no rational variant", a->name);
    else if (low < least || high < a->high)
        snprintf(why, 160, "%s exists from degrees %dx%d on%s, not at %dx%d", a->name, a->high, least,
                 weights && !a->own_weights ? " with weights" : "", n, m);
    else if (high > max)
        snprintf(why, 160, "%s is made up to degree %d%s, not at %dx%d", a->name, max,
                 weights && !a->own_weights ? " with weights" : "", n, m);
    else if (weights && a->same_degrees && n != m)
        snprintf(why, 160, "%s with weights needs equal degrees, not %dx%d", a->name, n, m);
    else
        return NULL;
    return why;
}

bool family_make(const struct family *a, const char *name, uint64_t seed, struct request *r, struct draft *d)
{
    char key[128];
    if (a->any_degree_stream)
        snprintf(key, sizeof key, "%s", name);
    else
        snprintf(key, sizeof key, "%s %dx%d", name, r->n, r->m);
    r->random = random_for(seed, key, r->index);
    for (int trial = 0; trial < 2000; trial++) {
        draft_reset(d, r->n, r->m, r->weights);
        if (a->generate(d, r) && (d->beyond || draft_fits(d)))
            return true;
    }
    return false;
}
