# A line or a parabola raised to a cubic for parts: a third of a + 2 b errs by 2 u S.
# in: algorithms/intersect/certified/cubic_avx2.c
# C: (c[0] + 2 * c[1]) / 3
# says: Raised: the sum, 3 S at most, is rounded, and the quotient: 2 u S.
@rnd = float<ieee_64, ne>;

a = S * p;
b = S * q;
sum = rnd(a + 2 * b);
c rnd= sum / 3;
C = S * (p + 2 * q) / 3;

{ S in [1,2] /\ |p| <= 1 /\ |q| <= 1 -> |(c - C) / S| <= 2b-53 }
c - C -> (c - sum / 3) + (sum - (a + 2 * b)) / 3;
$ S in 8;
# control: 2b-53 1b-53
