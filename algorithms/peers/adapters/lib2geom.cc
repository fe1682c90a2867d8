/* lib2geom's Bezier clipping behind the interface of ../peer.h, a shared object of its own.  It is asked for
 * 1e-12; its own limit, which it does not tell, is coarser. */
#include <2geom/basic-intersection.h>

#include <utility>
#include <vector>

#include "../peer.h"

static const double precision = 1e-12;

static std::vector<Geom::Point> points(const peer_curve &c)
{
    std::vector<Geom::Point> p;
    p.reserve(c.degree + 1);
    for (int i = 0; i <= c.degree; i++) {
        p.emplace_back(c.point[2 * i], c.point[2 * i + 1]);
    }
    return p;
}

extern "C" peer_outcome peer_intersect(const peer_curve *f, const peer_curve *g, peer_roots *out)
{
    if (f->weight || g->weight) {
        return PEER_REFUSED;
    }
    try {
        std::vector<std::pair<double, double>> found;
        Geom::find_intersections_bezier_clipping(found, points(*f), points(*g), precision);
        for (const auto &root : found) {
            peer_add(out, root.first, root.second);
        }
        return PEER_SOLVED;
    } catch (...) {
        return PEER_FAILED;
    }
}

extern "C" const char *peer_version(void)
{
    return PEER_VERSION;
}
