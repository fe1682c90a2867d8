# A line or a parabola raised to a cubic in the lanes: thirds of a + 2 b err by 3 u S.
# in: algorithms/intersect/certified/batch_kernel.h
# C: const double third = 1.0 / 3;
# C: wide right = wide_fma(c[1], two, wide_select(line, c[0], c[2])) * third;
# says: Elevation to degree 3: thirds of a + 2 b, three roundings: 3 u S
@rnd = float<ieee_64, ne>;

third = rnd(1 / 3);
a = S * p;
b = S * q;
sum = rnd(2 * a + b);
c rnd= sum * third;
C = S * (2 * p + q) / 3;

{ S in [1,2] /\ |p| <= 1 /\ |q| <= 1 -> |(c - C) / S| <= 3b-53 }
c - C -> (c - sum * third) + (sum - (2 * a + b)) * third + S * (2 * p + q) * (third - 1 / 3);
$ S in 8;
# control: 3b-53 2b-53
