# A point of a cubic: noise is (3 n + 4) u S = 13 u S.
# in: algorithms/intersect/certified/evaluate.h
# C: real v = 1 - t, vv = v * v, tt = t * t, w0 = vv * v, w1 = vv * t, w2 = v * tt, w3 = tt * t;
# C: *x = (w0 * a[0] + w1 * a[1]) + (w2 * a[2] + w3 * a[3]);
# in: algorithms/intersect/certified/source.c
# C: value[1] = 3 * c[1];
# C: value[2] = 3 * c[2];
# C: real relative = (3 * n + 4) * u;
@rnd = float<ieee_64, ne>;

t = rnd(t_);
v rnd= 1 - t;
vv rnd= v * v;
tt rnd= t * t;
w0 rnd= vv * v;
w1 rnd= vv * t;
w2 rnd= v * tt;
w3 rnd= tt * t;
a1 rnd= 3 * c1;
a2 rnd= 3 * c2;
x rnd= (w0 * c0 + w1 * a1) + (w2 * a2 + w3 * c3);

V = 1 - t;
X = ((V * V * V) * c0 + (V * V * t) * (3 * c1)) + ((V * (t * t)) * (3 * c2) + (t * t * t) * c3);

{ t in [0,1] /\ |c0| <= 2 /\ |c1| <= 2 /\ |c2| <= 2 /\ |c3| <= 2 -> |x - X| <= 13b-53 }
$ t in 64;
# control: 13b-53 2b-53
