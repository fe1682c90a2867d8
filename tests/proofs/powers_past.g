# Past the end of a part the tangent goes on: beside what fma_powers.g says of value and slope, a value errs by 2 u S, and,
# for each unit of the way P, by 160 u L.
# in: algorithms/intersect/certified/avx2_one.h
# C: value = _mm256_fmadd_pd(past, slope, value);
# C: _mm256_set1_pd((raised ? 11 : 5) * unit)
# C: _mm256_fmadd_pd(_mm256_set1_pd(160), size,
# says: and 6 u L of rounding, whence 160 u L, and by another u S: of both curves 5 u S will do.
#
# The computed value is (v (1 + e) + P (1 + b) d) (1 + r), v = X + ev, d = D + ed; e, b, r are of the last operation on v,
# of P, and of the sum.  Less X + P D and less ev, which is below 60 u L, this is a constant part and one times P.  S and L
# are 1: the curve is below S, its derivative below 3 L; ev is below 2^-40, or there is nothing that it could decide.

constant = (X + ev) * ((1 + e) * (1 + r) - 1);
slope = (1 + b) * (1 + r) * ed + (b + r + b * r) * D;

{ |X| <= 1 /\ |D| <= 3 /\ |ev| <= 1b-40 /\ |ed| <= 141b-53 /\ |e| <= 1b-53 /\ |b| <= 1b-53 /\ |r| <= 1b-53 ->
  |constant| <= 5b-54 /\ |slope| <= 160b-53 }
(1 + e) * (1 + r) - 1 -> e + r + e * r;
# control: 5b-54 3b-54
# control: 160b-53 146b-53
