# A point of a cubic in the lanes errs by 8 u S, with points as they were given.
# in: algorithms/intersect/certified/batch_newton.h
# C: value[1] = 3.0 * c[1];
# C: wide v = 1.0 - inside, vv = v * v, vt = v * inside, tt = inside * inside;
# C: wide w0 = vv * v, w1 = vv * inside, w2 = v * tt, w3 = tt * inside;
# C: return wide_fma(c[1], w1, c[0] * w0) + wide_fma(c[3], w3, c[2] * w2);
# in: algorithms/intersect/certified/batch_kernel.h
# says: and all terms together are at most S: 8 u S
#
# S in [1, 2] as [1, 5/4], [5/4, 3/2], [3/2, 7/4], [7/4, 2], each with its least bound and its largest points.
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
p rnd= c0 * w0;
q rnd= a2 * w2;
x = rnd(rnd(a1 * w1 + p) + rnd(c3 * w3 + q));

V = 1 - t;
X = ((3 * c1) * (V * V * t) + c0 * (V * V * V)) + (c3 * (t * t * t) + (3 * c2) * (V * (t * t)));

{ t in [0,1] /\ |c0| <= 1.25 /\ |c1| <= 1.25 /\ |c2| <= 1.25 /\ |c3| <= 1.25 -> |x - X| <= 8b-53 }
$ t in 64;
# also: 1.25=1.5 8b-53=10b-53
# also: 1.25=1.75 8b-53=12b-53
# also: 1.25=2 8b-53=14b-53
# control: 8b-53 2b-53
