# The two means that halve a quadratic: a node's control point errs by n u S.
# in: algorithms/core/bernstein.c
# C: right[i] = (right[i] + right[i + 1]) * half;
# in: algorithms/core/bernstein.h
# says: Error at most n u blossom of |c|
@rnd = float<ieee_64, ne>;

a = rnd(c0 + c1) * 0.5;
b = rnd(c1 + c2) * 0.5;
m = rnd(a + b) * 0.5;

A = (c0 + c1) * 0.5;
B = (c1 + c2) * 0.5;
M = (A + B) * 0.5;

{ |c0| <= 2 /\ |c1| <= 2 /\ |c2| <= 2 -> |a - A| <= 2b-53 /\ |b - B| <= 2b-53 /\ |m - M| <= 2b-53 }
# control: 2b-53 1b-53
