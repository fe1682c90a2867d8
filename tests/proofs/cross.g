# A cross product of directions: rounding of at most 4 u V W, where 1-norms of one are at most V, of the other W; both
# in [1, 2], as scaling by powers of two changes no rounding.
# in: algorithms/intersect/certified/evaluate.h
# C: return ax * by - ay * bx;
# in: algorithms/intersect/certified/cone.c
# says: rounding adds at most 4 u V_f V_g
# in: algorithms/intersect/certified/avx2_one.h
# C: out->det = _mm256_hsub_pd(products, products);
@rnd = float<ieee_64, ne>;

ax = V * a;
ay = V * b;
bx = W * p;
by = W * q;
c rnd= ax * by - ay * bx;
C = V * W * (a * q - b * p);

{ V in [1,2] /\ W in [1,2] /\ |a| <= 1 /\ |b| <= 1 /\ |p| <= 1 /\ |q| <= 1 /\ |a * q - b * p| <= 1 ->
  |(c - C) / (V * W)| <= 4b-53 }
c - C -> c - (ax * by - ay * bx);
ax * by - ay * bx -> V * W * (a * q - b * p);
$ V in 8, W in 8;
# control: 4b-53 1b-53
