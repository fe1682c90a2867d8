# A cross product with one fused operation: rounding of at most 2.5 u V W; V, W as in cross.g.  With V, W <= 4.1 S that
# is at most 5.2 u S (V + W), and 77 u S (V + W) of data leave 25 of the 102.
# in: algorithms/intersect/certified/avx2_parts.h
# C: __m256d back = _mm256_mul_pd(_mm256_broadcast_sd(&f->ay[i]), x);
# C: return _mm256_fmsub_pd(_mm256_broadcast_sd(&f->ax[i]), y, back);
# says: in all less than 102 u S (V_f + V_g)
# in: algorithms/intersect/certified/batch_kernel.h
# C: return wide_fms(ax, by, ay * bx);
@rnd = float<ieee_64, ne>;

ax = V * a;
ay = V * b;
bx = W * p;
by = W * q;
back rnd= ay * bx;
c = rnd(ax * by - back);
C = V * W * (a * q - b * p);

{ V in [1,2] /\ W in [1,2] /\ |a| <= 1 /\ |b| <= 1 /\ |p| <= 1 /\ |q| <= 1 /\ |a * q - b * p| <= 1 ->
  |(c - C) / (V * W)| <= 5b-54 }
c - C -> (c - (ax * by - back)) - (back - ay * bx);
ax * by - back -> C - (back - ay * bx);
$ V in 8, W in 8;
# control: 5b-54 1b-54
