# A quotient by way of 1 / det errs by 2 u of itself, and a little.
# in: algorithms/intersect/certified/solve_one.c
# C: real det = cross(p.dx, p.dy, q.dx, q.dy), one = 1 / det;
# C: d.dt = cross(x, y, q.dx, q.dy) * one;
# C: d.ds = cross(x, y, p.dx, p.dy) * one;
# in: algorithms/intersect/certified/batch_newton.h
# C: wide det = cross(p.dx, p.dy, q.dx, q.dy), one = 1.0 / det;
# C: wide dt = cross(x, y, q.dx, q.dy) * one, ds = cross(x, y, p.dx, p.dy) * one;
@rnd = float<ieee_64, ne>;

one rnd= 1 / det;
dt rnd= top * one;

{ det in [1b-200,1b200] /\ top in [1b-200,1b200] -> dt -/ (top * (1 / det)) in [-9b-55,9b-55] }
# control: 9b-55 1b-53
