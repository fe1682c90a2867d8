# Past the end of a node the tangent goes on: a value errs by 14 u S and, for each unit of the way P, 80 u S more.
# in: algorithms/intersect/certified/batch_newton.h
# C: wide inside = wide_min(wide_max(t, a->lo), a->hi), beyond = t - inside;
# C: out->x = wide_fma(beyond, out->dx, sum_4(a->x, w0, w1, w2, w3));
# C: wide error = h->unit * wide_fma(past_f + past_g, wide_of(slope_error), wide_of(2 * value_error));
# in: algorithms/intersect/certified/batch_kernel.h
# C: value_error = 14, slope_error = 80;
# says: Elevation adds 3 u S, the sum with the tangent past the node u S: 14 u S will do
# says: the distance past the node and its product 12 u S: 80 u S will do
#
# The computed value is (v + P (1 + b) d) (1 + r), v = X + ev, d = D + ed, b and r of the two roundings; less X + P D this
# is a constant part and one times P.  The curve is below 1 = S, its derivative below 6; ev by lanes_value.g and ed by
# lanes_slope.g, with 3 u S and 18 u S of points that were raised.  13 and 79 leave one part in 80 to spare.

constant = ev + r * (X + ev);
slope = (1 + b) * (1 + r) * ed + (b + r + b * r) * D;

{ |X| <= 1 /\ |D| <= 6 /\ |ev| <= 11b-53 /\ |ed| <= 66b-53 /\ |b| <= 1b-53 /\ |r| <= 1b-53 ->
  |constant| <= 13b-53 /\ |slope| <= 79b-53 }
# control: 13b-53 11b-53
# control: 79b-53 77b-53
