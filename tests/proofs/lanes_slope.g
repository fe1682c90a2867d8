# A slope of a cubic in the lanes errs by 48 u S, with points as they were given.
# in: algorithms/intersect/certified/batch_newton.h
# C: slope[0] = 3.0 * (c[1] - c[0]);
# C: slope[1] = 6.0 * (c[2] - c[1]);
# C: slope[2] = 3.0 * (c[3] - c[2]);
# C: wide v = 1.0 - inside, vv = v * v, vt = v * inside, tt = inside * inside;
# C: return wide_fma(c[2], w2, wide_fma(c[1], w1, c[0] * w0));
# in: algorithms/intersect/certified/batch_kernel.h
# says: sums by 3 u, of at most 6 S: 48 u S
#
# S as in lanes_value.g.
@rnd = float<ieee_64, ne>;

t = rnd(t_);
v rnd= 1 - t;
vv rnd= v * v;
vt rnd= v * t;
tt rnd= t * t;
h0 rnd= c1 - c0;
h1 rnd= c2 - c1;
h2 rnd= c3 - c2;
s0 rnd= 3 * h0;
s1 rnd= 6 * h1;
s2 rnd= 3 * h2;
p rnd= s0 * vv;
q = rnd(s1 * vt + p);
x = rnd(s2 * tt + q);

V = 1 - t;
X = (3 * (c3 - c2)) * (t * t) + ((6 * (c2 - c1)) * (V * t) + (3 * (c1 - c0)) * (V * V));

{ t in [0,1] /\ |c0| <= 1.25 /\ |c1| <= 1.25 /\ |c2| <= 1.25 /\ |c3| <= 1.25 -> |x - X| <= 48b-53 }
$ t in 64;
# also: 1.25=1.5 48b-53=60b-53
# also: 1.25=1.75 48b-53=72b-53
# also: 1.25=2 48b-53=84b-53
# control: 48b-53 12b-53
