/* A pair of curves while it is made, in exact rational arithmetic (FLINT). */
#ifndef FATLINE_DRAFT_H
#define FATLINE_DRAFT_H

#include <stdbool.h>
#include <stdio.h>

#include <fmpq.h>
#include <fmpq_poly.h>

enum { DRAFT_DEGREE_MAX = 32, PLANTED_MAX = 4 };

/* Euclidean control points and weights, i = 0..degree; all weights are 1 if !rational. */
struct points {
    int degree;
    bool rational;
    fmpq_t x[DRAFT_DEGREE_MAX + 1], y[DRAFT_DEGREE_MAX + 1], w[DRAFT_DEGREE_MAX + 1];
};

/* The same curve as polynomials: (x/w, y/w). */
struct shape {
    fmpq_poly_t x, y, w;
};

/* A solution known by construction; multiplicity 0: not known. */
struct planted {
    fmpq_t t, s;
    int multiplicity;
};

struct draft {
    struct points f, g;
    const char *class_name; /* what the construction makes; "" if that is left to the truth */
    char note[160];
    struct planted at[PLANTED_MAX]; /* planted of them */
    int planted;
    bool complete;     /* what is planted is all there is, proved by the construction */
    bool overlaps;     /* f over [overlap[0], overlap[1]] is g over [overlap[2], overlap[3]] */
    fmpq_t overlap[4]; /* t0, t1, s0, s1; s0 > s1 when reversed */
    int count;         /* number of solutions, all simple, proved by the construction; -1: not known */
    fmpq_t gap;        /* g was moved so far from contact at[0] along one axis; 0: it was not */
    bool beyond;       /* that takes more digits than a double has, and is the curve nevertheless */
};

void draft_init(struct draft *d);
void draft_clear(struct draft *d);
void draft_reset(struct draft *d, int n, int m, bool rational); /* weights 1, nothing planted */

void shape_init(struct shape *s);
void shape_clear(struct shape *s);
/* Control points of degree `degree` >= the degrees of s; the weights are taken as they are. */
void points_from_shape(struct points *p, int degree, const struct shape *s);
void shape_from_points(struct shape *s, const struct points *p);

void points_set(struct points *p, int i, slong x, slong y); /* control point i */
void points_copy(struct points *p, const struct points *q);
void points_elevate(struct points *p, int degree);
void points_reverse(struct points *p);
void points_value(fmpq_t x, fmpq_t y, const struct points *p, const fmpq_t t);
void points_move(struct points *p, const fmpq_t x, const fmpq_t y);
void points_turn(struct points *p, slong a, slong b); /* (x, y) -> (a x - b y, b x + a y) */

void draft_plant(struct draft *d, const fmpq_t t, const fmpq_t s, int multiplicity);
void draft_reverse_g(struct draft *d); /* what is planted follows */
/* Moves g so that f(t) = g(s). */
void draft_join(struct draft *d, const fmpq_t t, const fmpq_t s);
/* Multiplies all coordinates by one number, so that they are dyadic and the largest lies in [1/2, 1); the
 * weights of each curve likewise.  False if one does not fit in a double. */
bool draft_scale(struct draft *d);
bool draft_fits(const struct draft *d); /* every coordinate and weight is a double */

/* The two curves about a common point as functions of one coordinate, y or x: f's value less g's begins with
 * bend (coordinate)^order; dt, ds: rates of the parameters. */
struct contact {
    bool over_y;
    fmpq_t bend, dt, ds;
};

void contact_init(struct contact *c);
void contact_clear(struct contact *c);
/* Multiplicity of the solution (t, s) of the two curves extended, at most `limit`, by power series over the
 * coordinate in which f runs faster there.  0 if f(t) != g(s) or a derivative vanishes.  c, if not NULL, is
 * set when the tangents are parallel. */
int contact_order(const struct draft *d, const fmpq_t t, const fmpq_t s, int limit, struct contact *c);
/* Every leg of f's control polygon turns the same way to every leg of g's (legs of length 0 apart).  Chords
 * of a curve with positive weights are positive combinations of legs, so none of f is parallel to one of g:
 * the curves meet at most once, and transversally unless a derivative vanishes. */
bool meet_at_most_once(const struct draft *d);
/* The smallest boxes around the control points have no point in common. */
bool boxes_apart(const struct draft *d);

#endif
