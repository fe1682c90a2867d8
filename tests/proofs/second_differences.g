# A difference of two directions errs by 5 E: for the bound on f'' / (n (n - 1)).
# in: algorithms/intersect/certified/nodes.c
# C: bend = real_max(bend, real_max(real_abs(ax[i + 1] - ax[i]), real_abs(ay[i + 1] - ay[i])));
# C: to->bend = n > 1 ? n * (n - 1) * (bend + 5 * c->node_error) : (real)0;
@rnd = float<ieee_64, ne>;

x0 = X0 + E * p0;
x1 = X1 + E * p1;
x2 = X2 + E * p2;
d0 = rnd(x1 - x0);
d1 = rnd(x2 - x1);
b = rnd(d1 - d0);
B = X2 - 2 * X1 + X0;

{ |X0| <= 2 /\ |X1| <= 2 /\ |X2| <= 2 /\ |p0| <= 1 /\ |p1| <= 1 /\ |p2| <= 1 /\ E in [25b-53,1b-30] ->
  (b - B) / E in [-5,5] }
(b - B) / E -> (b - (d1 - d0)) / E + (d1 - (x2 - x1)) / E - (d0 - (x1 - x0)) / E + (p2 - 2 * p1 + p0) { E <> 0 };
# control: [-5,5] [-4,4]
