# A direction, the difference of two control points known to E, errs by 2.5 E: E >= 25 u S (degree 2; 37 u S at 3).
# in: algorithms/intersect/certified/nodes.c
# C: ax[i] = x[i + 1] - x[i];
# C: to->error = (real)2.5 * c->node_error;
#
# x = X + E p; E up to 2^-30, which no problem's E reaches.
@rnd = float<ieee_64, ne>;

x0 = X0 + E * p0;
x1 = X1 + E * p1;
d = rnd(x1 - x0);
D = X1 - X0;

{ |X0| <= 2 /\ |X1| <= 2 /\ |p0| <= 1 /\ |p1| <= 1 /\ E in [25b-53,1b-30] ->
  (d - D) / E in [-2.5,2.5] }
(d - D) / E -> (d - (x1 - x0)) / E + (p1 - p0) { E <> 0 };
# control: [-2.5,2.5] [-2,2]
