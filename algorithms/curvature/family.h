/* From the curve to its spans: half-planes, envelope and torsion in normalised coordinates. */
#ifndef FATLINE_FAMILY_H
#define FATLINE_FAMILY_H

#include "work.h"

/* Number of knot spans that meet the interval along more than a point. */
int family_spans(const struct control_family *f, const struct interval *i);

/* Fills k->span and what describes the coordinates; p is valid and k has room. */
void family_prepare(const struct region_problem *p, struct region_work *k);

/* Normalised coordinates of a point, as a homogeneous triple of length 1, and back. */
void family_point_in(const struct region_work *k, struct point d, real *v);
struct point family_point_out(const struct region_work *k, const real *v);

/* (A, B, C) of a half-plane in the curve's coordinates, A^2 + B^2 = 1. */
void family_line_out(const struct region_work *k, const real *l, real *line);

#endif
