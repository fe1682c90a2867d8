# Octagons in the lanes: gaps between bounds of x and y err by less than 30 u S, of x + y and x - y by less than 60 u S.
# in: algorithms/intersect/certified/batch_kernel.h
# C: static const double octagon_gap = 60,
# C: wide a = wide_max(f->low[k] - g->high[k], g->low[k] - f->high[k]);
# C: span(x[0] + y[0], x[1] + y[1], x[2] + y[2], x[3] + y[3], &out->low[2], &out->high[2]);
# C: return wide_less(unit * (octagon_gap / 2), gap_between(f, g, 0));
# says: |P - exact| <= E = 12 u S
# says: 30 u S will do.
#
# Points err by 12 u S: what that brings grows with S, and S is 1 here; the rounding is that of points up to 2.
@rnd = float<ieee_64, ne>;

x1 = X1 + 12b-53 * p1;
y1 = Y1 + 12b-53 * q1;
x2 = X2 + 12b-53 * p2;
y2 = Y2 + 12b-53 * q2;
gap = rnd(x1 - x2);
sum1 = rnd(x1 + y1);
sum2 = rnd(x2 + y2);
wide = rnd(sum1 - sum2);
Wide = (X1 + Y1) - (X2 + Y2);

{ |x1| <= 2 /\ |y1| <= 2 /\ |x2| <= 2 /\ |y2| <= 2 /\ |p1| <= 1 /\ |q1| <= 1 /\ |p2| <= 1 /\ |q2| <= 1 ->
  |gap - (X1 - X2)| <= 30b-53 /\ |wide - Wide| <= 60b-53 }
gap - (X1 - X2) -> (gap - (x1 - x2)) + 12b-53 * (p1 - p2);
wide - Wide -> (wide - (sum1 - sum2)) + (sum1 - (x1 + y1)) - (sum2 - (x2 + y2)) + 12b-53 * (p1 + q1 - p2 - q2);
# control: 30b-53 25b-53
# control: 60b-53 51b-53
