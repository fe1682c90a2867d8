# The derivative of a cubic: slope_noise is n (3 n + 6) u L = 45 u L, L the longest difference; L in [1, 2).
# in: algorithms/intersect/certified/source.c
# C: real a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2];
# C: slope[0] = 3 * a;
# C: slope[1] = 6 * b;
# C: slope[2] = 3 * d;
# C: c->slope_noise = n * ((relative + 2 * u) * longest + 2 * c->error);
# in: algorithms/intersect/certified/evaluate.h
# C: real v = 1 - t, w0 = v * v, w1 = v * t, w2 = t * t;
# C: *x = w0 * a[0] + w1 * a[1] + w2 * a[2];
@rnd = float<ieee_64, ne>;

t = rnd(t_);
v rnd= 1 - t;
w0 rnd= v * v;
w1 rnd= v * t;
w2 rnd= t * t;
a = rnd(A);
b = rnd(B);
d = rnd(D);
s0 rnd= 3 * a;
s1 rnd= 6 * b;
s2 rnd= 3 * d;
x rnd= w0 * s0 + w1 * s1 + w2 * s2;

V = 1 - t;
X = (V * V) * (3 * A) + (V * t) * (6 * B) + (t * t) * (3 * D);

{ t in [0,1] /\ |A| <= 2 /\ |B| <= 2 /\ |D| <= 2 -> |x - X| <= 45b-53 }
$ t in 64;
# control: 45b-53 6b-53
