/* against_lib2geom TOLERANCE FILE...: Bezier clipping and hybrid clipping beside lib2geom's own clipping
 * (find_intersections_bezier_clipping), in one interleaved run for each file of cases.
 *
 * Each gets its curves ready-made, in its own form, before the clock starts, and writes its answers into
 * memory that it keeps between calls.  A ratio is the time of ours over lib2geom's in the same round.  Every
 * answer is compared apart: pairs where the number of crossings differs from the known one, or between
 * the programs if none is known, are counted, and said.  Status 0; 1 if bezier_clipping is not the faster one
 * on some file (upper end of the interval below 1); 2 on an input or output error. */
#include <cmath>
#include <cfloat>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmp.h>
#include <jansson.h>
#include <math.h>

#include <2geom/basic-intersection.h>

extern "C" {
#include "../harness/cases/case_set.h"
#include "../harness/timing/clock.h"
#include "../harness/timing/statistics.h"
}

namespace
{

const char *const names[] = {"bezier_clipping", "hybrid_clipping_1", "hybrid_clipping_2",
                             "hybrid_clipping_3"};
const int OURS = sizeof names / sizeof *names;
const double level = 0.95;
const uint64_t seed = 1;

/* The pairs of one file in the form of both. */
struct pairs {
    case_set set{};
    double tolerance;
    std::vector<std::vector<Geom::Point>> f, g;
};

bool touch(const interval &a, const interval &b, double tolerance)
{
    return a.lo - tolerance <= b.hi + tolerance && b.lo - tolerance <= a.hi + tolerance;
}

/* Records that touch when widened by the tolerance count once: a crossing where a curve was split has two. */
int distinct(const std::vector<crossing> &boxes, double tolerance)
{
    int count = 0;

    for (size_t i = 0; i < boxes.size(); i++) {
        bool seen = false;

        for (size_t j = 0; j < i; j++)
            seen = seen ||
                   (touch(boxes[i].t, boxes[j].t, tolerance) && touch(boxes[i].s, boxes[j].s, tolerance));
        count += !seen;
    }
    return count;
}

struct ours {
    const pairs *p;
    const intersector *algorithm;
    workspace memory;
    std::unique_ptr<crossings> found{new crossings};

    void solve(int i)
    {
        problem_solve(&p->set.at[i].owned.problem, algorithm, &memory, found.get());
        clock_keep(found.get());
    }

    int count() const
    {
        std::vector<crossing> boxes(found->at, found->at + found->count);

        return distinct(boxes, p->tolerance);
    }
};

struct theirs {
    const pairs *p;
    std::vector<std::pair<double, double>> found;

    void solve(int i)
    {
        found.clear();
        Geom::find_intersections_bezier_clipping(found, p->f[i], p->g[i], p->tolerance);
        clock_keep(found.data());
    }

    int count() const
    {
        std::vector<crossing> boxes;

        for (const auto &at : found)
            boxes.push_back({{at.first, at.first}, {at.second, at.second}, CANDIDATE, 0, 0});
        return distinct(boxes, p->tolerance);
    }
};

template <class solver> void run(void *context, int first, int last)
{
    for (int i = first; i < last; i++)
        static_cast<solver *>(context)->solve(i);
}

std::vector<Geom::Point> points_of(const curve &c)
{
    std::vector<Geom::Point> points;

    for (int i = 0; i <= c.degree; i++)
        points.emplace_back(c.x[i], c.y[i]);
    return points;
}

bool read_pairs(const char *path, pairs &p)
{
    if (case_set_read(&p.set, path, p.tolerance, STEPS_MAX) || !p.set.count)
        return false;
    for (int i = 0; i < p.set.count; i++) {
        const problem &q = p.set.at[i].owned.problem;

        if (q.f.w || q.g.w) {
            std::fprintf(stderr, "%s: %s is rational; lib2geom's clipping takes polynomial curves\n", path,
                         p.set.at[i].c.id);
            return false;
        }
        p.f.push_back(points_of(q.f));
        p.g.push_back(points_of(q.g));
    }
    return true;
}

/* Pairs where a solver finds another number of crossings than is known (than bezier_clipping, if nothing is).
 */
template <class solver> int differing(solver &s, const std::vector<int> &count)
{
    int different = 0;

    for (size_t i = 0; i < count.size(); i++) {
        s.solve((int)i);
        different += s.count() != count[i];
    }
    return different;
}

std::vector<int> known_counts(const pairs &p, ours &reference)
{
    std::vector<int> count;

    for (int i = 0; i < p.set.count; i++) {
        const case_expected &e = p.set.at[i].c.expected;

        if (!e.known)
            reference.solve(i);
        count.push_back(e.known ? e.count : reference.count());
    }
    return count;
}

void print_line(const char *name, const clock_samples &s, const clock_samples &yardstick, int different,
                double *hi)
{
    range times = statistics_bootstrap_median(s.count, s.ns, level, seed), ratios;
    std::vector<double> q;

    for (int r = 0; r < s.count; r++)
        q.push_back(s.ns[r] / yardstick.ns[r]);
    ratios = statistics_bootstrap_median(s.count, q.data(), level, seed);
    *hi = ratios.hi;
    std::printf("  %-20s %8.0f ns [%.0f, %.0f]   ratio %6.3f [%.3f, %.3f]   other count on %d\n", name,
                statistics_median(s.count, s.ns), times.lo, times.hi, statistics_median(s.count, q.data()),
                ratios.lo, ratios.hi, different);
}

/* True if bezier_clipping is faster. */
bool compare(const char *path, pairs &p)
{
    std::vector<ours> mine(OURS);
    theirs other{&p, {}};
    clock_task task[OURS + 1];
    clock_samples samples[OURS + 1];
    clock_plan plan = {101, 20, 2e6, seed};
    double hi, first = INFINITY;

    for (int k = 0; k < OURS; k++) {
        mine[k].p = &p;
        mine[k].algorithm = intersector_find(names[k]);
        workspace_make(&mine[k].memory, intersectors, p.set.degree_f, p.set.degree_g, WORKSPACE_ROOM);
        task[k] = {p.set.count, run<ours>, &mine[k], false};
    }
    task[OURS] = {p.set.count, run<theirs>, &other, false};
    std::vector<int> count = known_counts(p, mine[0]);
    clock_interleave(OURS + 1, task, &plan, samples);
    std::printf("%s: %d pairs, tolerance %g, %d rounds; ns a pair, 95%% intervals\n", basename(path),
                p.set.count, p.tolerance, samples[0].count);
    print_line("lib2geom clipping", samples[OURS], samples[OURS], differing(other, count), &hi);
    for (int k = 0; k < OURS; k++) {
        print_line(names[k], samples[k], samples[OURS], differing(mine[k], count), &hi);
        first = k == 0 ? hi : first;
        workspace_clear(&mine[k].memory);
        clock_samples_clear(&samples[k]);
    }
    clock_samples_clear(&samples[OURS]);
    return first < 1;
}

} // namespace

int main(int argc, char **argv)
{
    bool faster = true;

    if (argc < 3) {
        std::fprintf(stderr, "usage: against_lib2geom TOLERANCE FILE...\n");
        return 64;
    }
    for (int k = 0; k < OURS; k++) {
        if (!intersector_find(names[k])) {
            std::fprintf(stderr, "against_lib2geom: no algorithm %s\n", names[k]);
            return 2;
        }
    }
    for (int i = 2; i < argc; i++) {
        pairs p;

        p.tolerance = std::atof(argv[1]);
        if (!read_pairs(argv[i], p))
            return 2;
        faster = compare(argv[i], p) && faster;
        std::fflush(stdout);
        case_set_clear(&p.set);
    }
    std::printf("bezier_clipping is %s lib2geom's clipping\n",
                faster ? "faster than" : "NOT faster on every file than");
    return faster ? 0 : 1;
}
