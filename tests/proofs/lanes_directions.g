# Directions in the lanes: they err by less than 26 u S, second differences by less than 60 u S; the largest computed
# 1-norm and 52 u S is no less than an exact one.
# in: algorithms/intersect/certified/batch_kernel.h
# C: way_error = 26, bend_error = 60,
# C: out->x[i] = a->x[i + 1] - a->x[i];
# C: wide bend_x = wide_max(wide_abs(out->x[1] - out->x[0]), wide_abs(out->x[2] - out->x[1]));
# C: out->speed = wide_fma(unit, wide_of(2 * way_error), speed);
# says: and 9 u S where directions are made
# says: e = 18 u S + 2 u S, 26 u S will do
#
# Points err by 9 u S: what that brings grows with S, and S is 1 here; the rounding is that of points up to 2.
@rnd = float<ieee_64, ne>;

x0 = X0 + 9b-53 * p0;
x1 = X1 + 9b-53 * p1;
x2 = X2 + 9b-53 * p2;
y0 = Y0 + 9b-53 * q0;
y1 = Y1 + 9b-53 * q1;
d0 = rnd(x1 - x0);
d1 = rnd(x2 - x1);
e0 = rnd(y1 - y0);
bend = rnd(d1 - d0);
norm = rnd(|d0| + |e0|);
speed = rnd(1b-53 * 52 + norm);

{ |x0| <= 2 /\ |x1| <= 2 /\ |x2| <= 2 /\ |y0| <= 2 /\ |y1| <= 2 /\ |p0| <= 1 /\ |p1| <= 1 /\ |p2| <= 1 /\
  |q0| <= 1 /\ |q1| <= 1 ->
  |d0 - (X1 - X0)| <= 26b-53 /\ |bend - (X2 - 2 * X1 + X0)| <= 60b-53 /\
  speed - ((|d0| + 20b-53) + (|e0| + 20b-53)) >= 0 }
d0 - (X1 - X0) -> (d0 - (x1 - x0)) + 9b-53 * (p1 - p0);
bend - (X2 - 2 * X1 + X0) -> (bend - (d1 - d0)) + (d1 - (x2 - x1)) - (d0 - (x1 - x0)) + 9b-53 * (p2 - 2 * p1 + p0);
speed - ((|d0| + 20b-53) + (|e0| + 20b-53)) ->
  (speed - (1b-53 * 52 + norm)) + (norm - (|d0| + |e0|)) + (1b-53 * 52 - 40b-53);
# control: 26b-53 19b-53
# control: 60b-53 39b-53
# control: 52 43
