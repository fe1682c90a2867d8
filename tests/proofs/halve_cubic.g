# The three means that halve a cubic: a node's control point errs by n u S.
# in: algorithms/intersect/certified/nodes.c
# C: real a = (c[0] + c[1]) * half, b = (c[1] + c[2]) * half, d = (c[2] + c[3]) * half;
# C: real e = (a + b) * half, f = (b + d) * half, m = (e + f) * half;
# in: algorithms/core/bernstein.h
# says: Error at most n u blossom of |c|
# in: algorithms/intersect/certified/batch_kernel.h
# C: wide a = (c[0] + c[1]) * 0.5, b = (c[1] + c[2]) * 0.5, d = (c[2] + c[3]) * 0.5;
# C: wide e = (a + b) * 0.5, f = (b + d) * 0.5, m = (e + f) * 0.5;
# says: Halving: (a + b) / 2 errs by u S; three deep: 3 u S.
# in: algorithms/intersect/certified/avx2_parts.h
# says: one halving adds at most 3 u S
#
# A half of a number is exact.
@rnd = float<ieee_64, ne>;

a = rnd(c0 + c1) * 0.5;
b = rnd(c1 + c2) * 0.5;
d = rnd(c2 + c3) * 0.5;
e = rnd(a + b) * 0.5;
f = rnd(b + d) * 0.5;
m = rnd(e + f) * 0.5;

A = (c0 + c1) * 0.5;
B = (c1 + c2) * 0.5;
D = (c2 + c3) * 0.5;
E = (A + B) * 0.5;
F = (B + D) * 0.5;
M = (E + F) * 0.5;

{ |c0| <= 2 /\ |c1| <= 2 /\ |c2| <= 2 /\ |c3| <= 2 ->
  |a - A| <= 3b-53 /\ |b - B| <= 3b-53 /\ |d - D| <= 3b-53 /\ |e - E| <= 3b-53 /\ |f - F| <= 3b-53 /\
  |m - M| <= 3b-53 }
# control: 3b-53 2b-53
