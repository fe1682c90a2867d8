# A point of a quadratic: noise is (3 n + 4) u S = 10 u S.
# in: algorithms/intersect/certified/evaluate.h
# C: real v = 1 - t, w0 = v * v, w1 = v * t, w2 = t * t;
# C: *x = w0 * a[0] + w1 * a[1] + w2 * a[2];
# in: algorithms/intersect/certified/source.c
# C: value[i] = above * c[i];
# C: real relative = (3 * n + 4) * u;
@rnd = float<ieee_64, ne>;

t = rnd(t_);
v rnd= 1 - t;
w0 rnd= v * v;
w1 rnd= v * t;
w2 rnd= t * t;
a1 rnd= 2 * c1;
x rnd= w0 * c0 + w1 * a1 + w2 * c2;

V = 1 - t;
X = (V * V) * c0 + (V * t) * (2 * c1) + (t * t) * c2;

{ t in [0,1] /\ |c0| <= 2 /\ |c1| <= 2 /\ |c2| <= 2 -> |x - X| <= 10b-53 }
$ t in 64;
# control: 10b-53 1b-53
