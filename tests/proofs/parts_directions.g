# Directions of a part: they err by 77 u S, the largest computed 1-norm and second difference with 160 u S more are no less
# than the exact ones.
# in: algorithms/intersect/certified/avx2_parts.h
# C: a->speed = _mm_cvtsd_f64(_mm_max_sd(longest, _mm_unpackhi_pd(longest, longest))) + 160 * unit;
# says: A difference's coordinate errs by e = 2 E + 2 u S <= 77 u S, its sums by 4 E + 4 u S
#
# x is a coordinate, s the sum or difference of both, by the size of which the 1-norm is told.  S in [1, 2] as
# [1, 3/2] and [3/2, 2], each with what grows with S at its least and the largest points; units are u S / 2.
@rnd = float<ieee_64, ne>;

x0 = X0 + 74b-54 * p0;
x1 = X1 + 74b-54 * p1;
x2 = X2 + 74b-54 * p2;
s0 = Z0 + 148b-54 * q0;
s1 = Z1 + 148b-54 * q1;
d0 = rnd(x1 - x0);
d1 = rnd(x2 - x1);
turn = rnd(d1 - d0);
bend = rnd(turn + 320b-54);
size = rnd(s1 - s0);
speed = rnd(size + 320b-54);

{ |x0| <= 1.5 /\ |x1| <= 1.5 /\ |x2| <= 1.5 /\ |s0| <= 3.0 /\ |s1| <= 3.0 /\ |p0| <= 1 /\ |p1| <= 1 /\ |p2| <= 1 /\ |q0| <= 1 /\
  |q1| <= 1 ->
  |d0 - (X1 - X0)| <= 154b-54 /\ speed - (Z1 - Z0) >= 0 /\ bend - (X2 - 2 * X1 + X0) >= 0 }
d0 - (X1 - X0) -> (d0 - (x1 - x0)) + 74b-54 * (p1 - p0);
speed - (Z1 - Z0) -> (speed - (size + 320b-54)) + (size - (s1 - s0)) + 148b-54 * (q1 - q0) + 320b-54;
bend - (X2 - 2 * X1 + X0) -> (bend - (turn + 320b-54)) + (turn - (d1 - d0)) + (d1 - (x2 - x1)) - (d0 - (x1 - x0)) +
  74b-54 * (p2 - 2 * p1 + p0) + 320b-54;
# also: 1.5=2 3.0=4 74b-54=111b-54 148b-54=222b-54 154b-54=231b-54 320b-54=480b-54
# control: 154b-54 150b-54
# control: 320b-54 300b-54
