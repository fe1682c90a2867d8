# A cut in the lanes: each of its three means adds 2 u S.
# in: algorithms/intersect/certified/batch_kernel.h
# C: return wide_fma(t, b, wide_fnma(t, a, a));
# C: wide a0 = mean(c[0], c[1], lo), a1 = mean(c[1], c[2], lo), a2 = mean(c[2], c[3], lo);
# C: out[0] = mean(aa0, aa1, lo);
# says: u ((1 - t) |a| + |mean|) <= 2 u S; t = m 2^-d is exact.  A point is three means deep: 6 u S.
#
# S times p and q are the points; the exact mean of two points is below S like them, and a mean by exact weights of two
# numbers that err errs by no more than they do.
@rnd = float<ieee_64, ne>;

t = rnd(t_);
a = S * p;
b = S * q;
rest = rnd(a - t * a);
c = rnd(t * b + rest);
C = S * ((1 - t) * p + t * q);

{ S in [1,2] /\ t in [0,1] /\ |p| <= 1 /\ |q| <= 1 /\ |(1 - t) * p + t * q| <= 1 -> |(c - C) / S| <= 2b-53 }
a - t * a -> S * ((1 - t) * p);
c - C -> (c - (t * b + rest)) + (rest - (a - t * a));
t * b + rest -> C + (rest - (a - t * a));
$ S in 8;
# control: 2b-53 3b-54
