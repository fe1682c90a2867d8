/* CGAL's exact traits of Bezier curves (CORE numbers) as a program of its own (program.h).  That part of CGAL
 * is under the GPL: this program is built apart, linked to nothing of ours, and not shipped. */
#include <CGAL/Arr_Bezier_curve_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>
#include <CGAL/version.h>

#include <boost/variant.hpp>
#include <utility>
#include <vector>

#include "program.h"

namespace
{

using Numbers = CGAL::CORE_algebraic_number_traits;
using Exact = CGAL::Cartesian<Numbers::Rational>;
using Traits = CGAL::Arr_Bezier_curve_traits_2<Exact, CGAL::Cartesian<Numbers::Algebraic>, Numbers>;
using Curve = Traits::Curve_2;
using Piece = Traits::X_monotone_curve_2;
using Point = Traits::Point_2;

Curve curve(const peer_curve &c)
{
    std::vector<Exact::Point_2> points;
    for (int i = 0; i <= c.degree; i++) {
        points.emplace_back(Numbers::Rational(c.point[2 * i]), Numbers::Rational(c.point[2 * i + 1]));
    }
    return Curve(points.begin(), points.end());
}

std::vector<Piece> monotone_pieces(const Traits &traits, const Curve &c)
{
    std::vector<boost::variant<Point, Piece>> parts;
    std::vector<Piece> pieces;
    traits.make_x_monotone_2_object()(c, std::back_inserter(parts));
    for (const auto &part : parts) {
        if (const Piece *piece = boost::get<Piece>(&part)) {
            pieces.push_back(*piece);
        }
    }
    return pieces;
}

/* Every point that two pieces share, once; false if they share more. */
bool meet(const Traits &traits, const std::vector<Piece> &f, const std::vector<Piece> &g,
          std::vector<Point> &points)
{
    using Shared = boost::variant<std::pair<Point, unsigned>, Piece>;
    auto equal = traits.equal_2_object();
    bool isolated = true;
    for (const Piece &a : f) {
        for (const Piece &b : g) {
            std::vector<Shared> shared;
            traits.intersect_2_object()(a, b, std::back_inserter(shared));
            for (const Shared &part : shared) {
                const auto *found = boost::get<std::pair<Point, unsigned>>(&part);
                bool old = !found;
                isolated = isolated && found;
                for (size_t i = 0; !old && i < points.size(); i++) {
                    old = equal(points[i], found->first);
                }
                if (!old) {
                    points.push_back(found->first);
                }
            }
        }
    }
    return isolated;
}

/* The parameters of the point on c: exact ones rounded, else the middle of the rational bounds that CGAL
 * stopped at. */
std::vector<std::pair<double, bool>> parameters(const Point &p, const Curve &c)
{
    std::vector<std::pair<double, bool>> t;
    for (auto o = p.originators_begin(); o != p.originators_end(); ++o) {
        if (!o->curve().is_same(c)) {
            continue;
        }
        if (o->has_parameter()) {
            t.emplace_back(CGAL::to_double(o->parameter()), true);
        } else {
            const auto &bound = o->point_bound();
            t.emplace_back((CGAL::to_double(bound.t_min) + CGAL::to_double(bound.t_max)) / 2, false);
        }
    }
    return t;
}

/* Reads the exact answer: Newton's method carries a middle of bounds to the root inside. */
void add(const peer_curve &f, const peer_curve &g, std::pair<double, bool> t, std::pair<double, bool> s,
         peer_roots *out)
{
    enum { READING = 8 };
    double root[2] = {t.first, s.first};
    for (int k = 0; k < READING && !(t.second && s.second) && newton_step(&f, &g, 1, root); k++) {
    }
    for (int i = 0; i < out->count && i < PEER_ROOTS; i++) {
        if (out->root[i][0] == root[0] && out->root[i][1] == root[1]) {
            return;
        }
    }
    peer_add(out, root[0], root[1]);
}

} // namespace

extern "C" peer_outcome peer_intersect(const peer_curve *f, const peer_curve *g, peer_roots *out)
{
    if (f->weight || g->weight) {
        return PEER_REFUSED;
    }
    try {
        const Curve a = curve(*f), b = curve(*g);
        Traits traits;
        std::vector<Point> points;
        if (!meet(traits, monotone_pieces(traits, a), monotone_pieces(traits, b), points)) {
            out->coincident = 1;
        }
        for (const Point &p : points) {
            for (const auto &t : parameters(p, a)) {
                for (const auto &s : parameters(p, b)) {
                    add(*f, *g, t, s, out);
                }
            }
        }
        return PEER_SOLVED;
    } catch (...) {
        return PEER_FAILED;
    }
}

extern "C" const char *peer_version(void)
{
    return CGAL_VERSION_STR;
}

int main()
{
    return program_run("cgal");
}
