/* fatline: where two planar Bezier curves meet, proved; and where a control point may go.
 *
 * This header says all there is to know of the library: link with `pkg-config --cflags --libs fatline`.  It
 * is C (C99 or later) and C++.  The library needs the C library and libm, and nothing else.
 *
 * MEMORY.  No call allocates, opens, prints or exits.  All memory is a workspace: the caller asks for its
 * size, provides the bytes and releases them when they are no longer needed; there is nothing else to
 * release. Answers lie in the workspace and are good until its next use; those of fatline_batch and
 * fatline_paths lie in arrays and memory of the caller's.  Input arrays are read during a call only, unless
 * it is said otherwise.  A workspace may be used for any number of problems, in any order: the answer depends
 * on the problem alone, bit for bit.
 *
 * THREADS.  There is no global state.  Calls may run at the same time if each has a workspace and an answer
 * of its own.
 *
 * NUMBERS.  IEEE doubles, rounded to nearest, with subnormal numbers: a program that has changed the rounding
 * mode, or lets the processor flush subnormal numbers to zero, has to undo that around a call, else nothing
 * is proved.  Coordinates have any unit, from 1e-150 to 1e150 or beyond, and are taken as they are;
 * parameters run from 0 to 1 over each curve.  Bounds on rounding are part of every statement below, so
 * "proved" is meant of the curves whose control points are exactly the given doubles.
 *
 * ERRORS.  An input that is no problem is answered by FATLINE_INVALID, and `error` says in a sentence what is
 * wrong with it.  An outcome other than FATLINE_SOLVED never means that something was lost in silence. */
#ifndef FATLINE_H
#define FATLINE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define FATLINE_VERSION "0.1.0"
#define FATLINE_VERSION_NUMBER 100 /* 10000 major + 100 minor + patch */

#if defined(_WIN32) || !defined(__GNUC__)
#define FATLINE_API
#else
#define FATLINE_API __attribute__((visibility("default")))
#endif

/* FATLINE_VERSION of the library that runs; programs may compare it with that of the header. */
FATLINE_API const char *fatline_version(void);

enum { FATLINE_DEGREE_MAX = 32, FATLINE_CROSSINGS_MAX = 2048, FATLINE_OVERLAPS_MAX = 16 };

/* SOLVED: every record is as narrow as asked and the precision allows, or carries its own proof.
 * OUT_OF_STEPS, OUT_OF_ROOM: stopped early.  Every solution still lies in some record; what is undecided is
 * among the records, wider than asked.  (Of a region: there is no answer.)
 * OUT_OF_STEPS also, with steps left: rounding hides what would have to be seen for a narrower record.
 * UNSUPPORTED: of regions only, see there.
 * INVALID: the input is not a problem; there are no records. */
enum fatline_outcome {
    FATLINE_SOLVED,
    FATLINE_OUT_OF_STEPS,
    FATLINE_OUT_OF_ROOM,
    FATLINE_UNSUPPORTED,
    FATLINE_INVALID
};

/* In a few words: "solved", ... */
FATLINE_API const char *fatline_outcome_text(enum fatline_outcome outcome);

/* ---- two curves
 * -------------------------------------------------------------------------------------------- */

/* Control points (points[2 i], points[2 i + 1]), i = 0..degree, 1 <= degree <= FATLINE_DEGREE_MAX, finite;
 * weights[i] > 0, the largest at most 2^256 times the least, or NULL for a polynomial curve. */
struct fatline_curve {
    int degree;
    const double *points;
    const double *weights;
};

/* 0 stands for what is written behind. */
struct fatline_options {
    double tolerance; /* 1e-12: width in t and s below which what is not decided may stay so */
    int max_steps;    /* 100000: a step looks at two arcs and takes microseconds at most; bounds the time */
};

/* UNIQUE: the rectangle holds exactly one solution.
 * END: the curves, each continued past its ends by its tangents, have exactly one solution in the rectangle,
 * and it is so near an end of a curve that rounding cannot tell on which side.
 * CLUSTER: the rectangle holds at most at_most solutions, counted with multiplicity; for instance a tangency
 * (2), which doubles cannot tell from two crossings or none.
 * CANDIDATE: could not be excluded; may hold no solution, one, or many. */
enum fatline_standing { FATLINE_CANDIDATE, FATLINE_UNIQUE, FATLINE_END, FATLINE_CLUSTER };

/* "candidate", "unique", "end", "cluster". */
FATLINE_API const char *fatline_standing_text(enum fatline_standing standing);

/* A solution is (t, s) in [0, 1]^2 with f(t) = g(s).  t_lo <= t <= t_hi and s_lo <= s <= s_hi is the
 * rectangle; for UNIQUE its middle is the best estimate, a few units in the last place of the conditioning
 * wide. */
struct fatline_crossing {
    double t_lo, t_hi, s_lo, s_hi;
    enum fatline_standing standing;
    int at_most; /* 1 of UNIQUE and END; 0 of CANDIDATE: not known */
};

/* A shared arc: over t_inner, within s_inner, the curves are no farther from each other than `distance`, in
 * the unit of the coordinates and the maximum norm.  All solutions that belong to it lie in the rectangle
 * t_outer x s_outer.  reversed: s falls while t rises. */
struct fatline_overlap {
    double t_outer_lo, t_outer_hi, s_outer_lo, s_outer_hi;
    double t_inner_lo, t_inner_hi, s_inner_lo, s_inner_hi;
    double distance;
    int reversed;
};

/* Every solution lies in the rectangle of some crossing or in t_outer x s_outer of some overlap.  Crossings
 * are sorted by (t_lo, s_lo).  Two solutions at one point, where a curve crosses itself, are two.  Exchanging
 * two different curves, and multiplying all coordinates by a power of two (short of overflow and underflow),
 * changes no bit but what that changes. */
struct fatline_answer {
    enum fatline_outcome outcome;
    const char *error; /* NULL unless INVALID */
    int count, overlaps;
    const struct fatline_crossing *crossing; /* in the workspace */
    const struct fatline_overlap *overlap;
    int steps;
};

/* For curves of degree <= degree: less than half a megabyte for cubics, less than two for any degree.  0:
 * there is no such degree. */
FATLINE_API size_t fatline_workspace_size(int degree);

struct fatline_workspace;
/* Makes a workspace in `memory`: at least fatline_workspace_size(degree) bytes, aligned as malloc aligns.
 * NULL: memory is NULL or not aligned, size too small, or there is no such degree. */
FATLINE_API struct fatline_workspace *fatline_workspace_init(void *memory, size_t size, int degree);

/* Where do f and g meet?  options may be NULL.  Returns out->outcome; *out is written whatever it is. */
FATLINE_API enum fatline_outcome fatline_intersect(struct fatline_workspace *w, const struct fatline_curve *f,
                                                   const struct fatline_curve *g,
                                                   const struct fatline_options *options,
                                                   struct fatline_answer *out);

/* The point of a valid curve at t in [0, 1]; each coordinate errs by at most (6 degree + 4) 2^-53 times the
 * largest |coordinate|. */
FATLINE_API void fatline_point(const struct fatline_curve *c, double t, double point[2]);

/* ---- many pairs of curves
 * ------------------------------------------------------------------------------------ */

/* Polynomial curves of degree 1 to 3.  Curve i has its control points in points[8 i ..]: x at 0..degree[i], y
 * at 4..4 + degree[i]; the rest of the eight is not looked at.  degree NULL: all are cubics. */
struct fatline_table {
    int count;
    const double *points; /* fastest where 64 divides the address */
    const unsigned char *degree;
};

/* Pair k is curve f_index[k] of f with curve g_index[k] of g; NULL: k.  f and g may be one table, and a curve
 * may be in many pairs. */
struct fatline_pairs {
    struct fatline_table f, g;
    const int *f_index, *g_index;
    int count;
};

struct fatline_batch_crossing {
    int pair;
    struct fatline_crossing at;
};

struct fatline_batch_overlap {
    int pair;
    struct fatline_overlap at;
};

/* Before the call: the caller's arrays and their room; outcome has an element for each pair.  After it:
 * outcome[k], an enum fatline_outcome, for the pairs first..done-1, and all their records; those of one pair
 * need not be next to each other, nor pairs in order. */
struct fatline_batch_answer {
    struct fatline_batch_crossing *crossing;
    struct fatline_batch_overlap *overlap;
    unsigned char *outcome;
    int room, overlap_room;
    int count, overlaps;
    int done;
    const char *error; /* NULL unless INVALID */
};

/* Less than a megabyte. */
FATLINE_API size_t fatline_batch_workspace_size(void);

struct fatline_batch_workspace;
FATLINE_API struct fatline_batch_workspace *fatline_batch_workspace_init(void *memory, size_t size);

/* Settles the pairs first..count-1; options may be NULL.  Where the processor has AVX-512 or AVX2 eight or
 * four are taken at a time.  Each gets what fatline_intersect says of it: the same outcome, and the same
 * records with the same standings, whose rectangles hold the same solutions; bits differ, with the processor
 * and with the company of a pair, and max_steps bounds only what is not decided at once.  Where rounding is
 * not small against the curves (far from the origin, and tiny) one of the two may prove that nothing is there
 * while the other reports an END, whose solution is beyond the end, or a CANDIDATE.
 *
 * SOLVED: all are settled, each with its own outcome; it is FATLINE_INVALID, without records, where there is
 * no such degree or a coordinate is not finite.  OUT_OF_ROOM: an array was full; a call with first = done
 * goes on.  FATLINE_CROSSINGS_MAX and FATLINE_OVERLAPS_MAX are room enough for any pair.  INVALID: see
 * `error`; where an index of pair `done` is not within its table, the pairs before are settled. */
FATLINE_API enum fatline_outcome fatline_batch(struct fatline_batch_workspace *w,
                                               const struct fatline_pairs *pairs,
                                               const struct fatline_options *options, int first,
                                               struct fatline_batch_answer *out);

/* ---- paths of many curves
 * ---------------------------------------------------------------------------------- */

/* Segments one after the other.  Segment i has the degree[i] + 1 control points that follow those of segment
 * i - 1: point k is (points[2 k], points[2 k + 1]), its weight weights[k].  Where a segment begins at the end
 * of the one before, that point stands there twice.  degree NULL: all are cubics; weights NULL: all 1.  What
 * is said of the numbers of struct fatline_curve holds of each segment's; besides, the largest |coordinate|
 * of a segment with unequal weights is 0 or between 2^-700 and 2^1000.
 *
 * Subpath j has the segments subpath[j]..subpath[j + 1] - 1, the last one up to the end: subpath[0] is 0, and
 * they increase.  subpath NULL: one subpath.  Within a subpath two neighbours are joined, and so are the last
 * segment and the first, if the end of one is exactly the beginning of the other; of rational segments weight
 * times coordinate is compared, as rounded.  A segment that is one point is passed over if a neighbour ends
 * or begins there. */
struct fatline_path {
    int count; /* segments, 0 to 2^30 */
    const double *points;
    const unsigned char *degree;
    const double *weights;
    int subpaths; /* of no meaning without `subpath` */
    const int *subpath;
};

/* From parameter lo of segment `first` along the path to parameter hi of segment `last`: mostly one and the
 * same; else `last` follows `first`, with or without others between them. */
struct fatline_path_span {
    int first, last;
    double lo, hi;
};

/* Solutions on both spans.  UNIQUE: exactly one.  END: at most one, the one solution of two segments extended
 * past their ends.  CLUSTER: at most at_most.  CANDIDATE: may hold none, one, or many.
 * overlap >= 0: overlap[overlap] of the answer is a shared arc, and the spans are its outer ranges; standing
 * is CANDIDATE.
 * joint: of neighbours in one path, it holds the point where they join, which is no crossing but counts in
 * at_most.
 * chain > 0: of those with the same number, overlaps that go on from one segment to the next, and crossings
 * that touch them there, whose solution may be an overlap's own end. */
struct fatline_path_crossing {
    struct fatline_path_span a, b;
    enum fatline_standing standing;
    int at_most; /* 1 of UNIQUE and END; 0: not known */
    int overlap; /* or -1 */
    int joint, chain;
};

/* Of two segments, a.first and b.first of its record: over a_inner and b_inner the curves are no farther from
 * each other than `distance`, as of struct fatline_overlap. */
struct fatline_path_overlap {
    double a_inner_lo, a_inner_hi, b_inner_lo, b_inner_hi;
    double distance;
    int reversed;
};

/* Before the call: memory has `size` bytes, aligned as malloc aligns.  After it, crossing and overlap lie
 * there. */
struct fatline_paths_answer {
    void *memory;
    size_t size;
    int count, overlaps; /* 0 unless SOLVED or OUT_OF_STEPS */
    const struct fatline_path_crossing *crossing;
    const struct fatline_path_overlap *overlap;
    long long done;    /* pairs of segments, and single ones, that were looked at so far */
    long long open;    /* of these, not SOLVED: what is undecided is among the records */
    const char *error; /* NULL unless INVALID */
    int segment;       /* that `error` speaks of, or -1 */
};

/* Of a workspace for these two paths, or for one (b NULL): one and a half megabytes, three of any degree, and
 * of cubics without weights less than 200 bytes a segment.  Of memory for so many records, as they are found:
 * what has up to four of them at a joint is one in the answer; two megabytes, 12 bytes a segment and 200 a
 * record.  Points and weights are not looked at.  0: a count, a degree or a subpath is none. */
FATLINE_API size_t fatline_paths_workspace_size(const struct fatline_path *a, const struct fatline_path *b);
FATLINE_API size_t fatline_paths_memory_size(const struct fatline_path *a, const struct fatline_path *b,
                                             int records);

struct fatline_paths_workspace;
/* NULL: memory is NULL or not aligned, or the size is that of no workspace. */
FATLINE_API struct fatline_paths_workspace *fatline_paths_workspace_init(void *memory, size_t size);

/* Where do paths a and b cross, or, if b is NULL, where does a cross itself?  Every common point (of one
 * path: every point at two parameters, but joints) lies on both spans of some record; each pair of segments
 * is solved as by fatline_intersect or fatline_batch, and records of one solution at joints are made one.
 * Records are sorted by the place on a, (a.first, a.lo), then on b; of one path a is the earlier span, but of
 * an overlap.  An arc that one segment runs over twice remains as CANDIDATE.
 *
 * options may be NULL; here 0 as a tolerance stands for 1e-10, since a segment of length L in a path of size
 * S is known to about S / L roundings; max_steps is of each pair.  first is 0.
 *
 * SOLVED: all has been found.  OUT_OF_STEPS: likewise, but for the `open` pairs or segments, of which some
 * records are wider than asked, or candidates.
 * OUT_OF_ROOM: the memory is full, and there are no records yet.  A call with first = done, the same
 * workspace, and memory that is larger and begins with the same bytes (realloc) goes on; paths and options
 * are then those of the first call, whatever is given.
 * INVALID: see `error`.  The workspace was made for less, for instance, or `first` is neither 0 nor where the
 * last call ended for want of room. */
FATLINE_API enum fatline_outcome fatline_paths(struct fatline_paths_workspace *w,
                                               const struct fatline_path *a, const struct fatline_path *b,
                                               const struct fatline_options *options, long long first,
                                               struct fatline_paths_answer *out);

/* ---- where a control point may go
 * ---------------------------------------------------------------------------- */

/* The places of one control point for which the curve is regular with curvature of one sign on an interval
 * are an open convex region of the plane, bounded by lines and arcs of an envelope. */

/* A B-spline curve (NURBS with weights): degree 2 to 32 (with weights 17), `count` control points, knots[0 ..
 * count + degree] not decreasing, an inner knot at most `degree` times.  Its parameter runs from
 * knots[degree] to knots[count].  knots == NULL: one Bezier curve over [0, 1], count = degree + 1. */
struct fatline_spline {
    int degree, count;
    const double *knots, *points, *weights;
};

/* The curve is to keep curvature of the given sign (+1: turns left, -1: right) for parameters from..to; from
 * == to == 0: all of the curve.  The arrays must stay until the last question about the region. */
struct fatline_region_problem {
    struct fatline_spline curve;
    int free;            /* control point that moves */
    const double *share; /* NULL; else control point j moves by share[j] times what the place moves that
                            stands for `free`: share[free] = 1 */
    double from, to;
    int sign;
    int loop_free;    /* besides, the tangent shall turn by less than half a turn */
    double tolerance; /* of areas, discs and distances to arcs, as a part of the curve's size; 0: finest */
    int max_steps;    /* 0: 1000000 */
};

/* EMPTY: there is no such place.  PLANE: everywhere. */
enum fatline_kind { FATLINE_EMPTY, FATLINE_BOUNDED, FATLINE_UNBOUNDED, FATLINE_PLANE };

/* "empty", ... */
FATLINE_API const char *fatline_kind_text(enum fatline_kind kind);

/* Edges run counter-clockwise, the region on their left.  (a, b, c), a^2 + b^2 = 1: the line a x + b y + c =
 * 0 of an edge, or the tangent of an arc at its parameter t; positive inside.  from, to: the vertices,
 * meaningless where an end is at infinity.  An arc lies on the envelope of the lines of parameters t to t1.
 */
enum fatline_edge_type { FATLINE_LINE, FATLINE_ARC, FATLINE_CHORD };
struct fatline_edge {
    enum fatline_edge_type type;
    int from_infinity, to_infinity;
    double from[2], to[2];
    double line[3];
    double t, t1;
};

/* certified: verified after the fact, up to rounding: each edge is on a line or on the envelope, the edges
 * close up, and every vertex and arc fulfils all conditions; an empty region is proved empty. */
struct fatline_region {
    enum fatline_outcome outcome;
    const char *error; /* NULL unless INVALID or UNSUPPORTED */
    enum fatline_kind kind;
    int certified;
    int count;
    const struct fatline_edge *edge; /* in the workspace */
    double area;                     /* of a bounded region */
    double disc[3];                  /* centre and radius of a largest disc in a bounded region */
};

/* For curves of degree <= degree with at most `count` control points: less than two megabytes for a cubic
 * with 100, less than four for a Bezier curve of any degree.  0: there is no such degree, or count <= degree.
 */
FATLINE_API size_t fatline_region_workspace_size(int degree, int count);

struct fatline_region_workspace;
FATLINE_API struct fatline_region_workspace *fatline_region_workspace_init(void *memory, size_t size,
                                                                           int degree, int count);

/* UNSUPPORTED: weights and a degree above 17.  OUT_OF_ROOM: also where the curve is beyond what the workspace
 * was made for. */
FATLINE_API enum fatline_outcome fatline_region_solve(struct fatline_region_workspace *w,
                                                      const struct fatline_region_problem *p,
                                                      struct fatline_region *out);

/* Questions about the region that w solved last; FATLINE_OUTSIDE, 0 and (x, y) itself if there is none.
 *
 * contains: is the disc of radius margin >= 0 about (x, y) inside?  OUTSIDE and INSIDE are proved; BOUNDARY:
 * nearer to the boundary than rounding can tell.
 * safe_radius: a disc about (x, y) of this radius is inside, proved by `contains`: the distance to the
 * boundary, less what rounding and the tolerance of arcs take; 0: it is not proved that (x, y) is inside.  Of
 * the plane: HUGE_VAL. nearest: the nearest point of the closed region, to rounding for lines, to the
 * tolerance for arcs. */
enum fatline_side { FATLINE_OUTSIDE, FATLINE_BOUNDARY, FATLINE_INSIDE };
FATLINE_API enum fatline_side fatline_region_contains(struct fatline_region_workspace *w, double x, double y,
                                                      double margin);
FATLINE_API double fatline_region_safe_radius(struct fatline_region_workspace *w, double x, double y);
FATLINE_API void fatline_region_nearest(struct fatline_region_workspace *w, double x, double y,
                                        double nearest[2]);

#ifdef __cplusplus
}
#endif

#endif
