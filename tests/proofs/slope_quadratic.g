# The derivative of a quadratic: slope_noise is n (3 n + 6) u L = 24 u L, L the longest difference; L in [1, 2).
# in: algorithms/intersect/certified/source.c
# C: real step = c[i + 1] - c[i];
# C: slope[i] = below * (n * step);
# C: c->slope_noise = n * ((relative + 2 * u) * longest + 2 * c->error);
# in: algorithms/intersect/certified/evaluate.h
# C: real v = 1 - t, power = t, sum = a[0], also = b[0];
# C: sum = sum * v + a[i] * power;
@rnd = float<ieee_64, ne>;

t = rnd(t_);
v rnd= 1 - t;
a = rnd(A);
b = rnd(B);
s0 rnd= 2 * a;
s1 rnd= 2 * b;
x rnd= s0 * v + s1 * t;

X = (2 * A) * (1 - t) + (2 * B) * t;

{ t in [0,1] /\ |A| <= 2 /\ |B| <= 2 -> |x - X| <= 24b-53 }
$ t in 16;
# control: 24b-53 3b-53
