# What a Newton step leaves of the linearised H, by |H|: 12 u k |H| + 2.25 u (|f'| |dt| + |g'| |ds|), k = |f'| |g'| / |det|.
# in: algorithms/intersect/certified/solve_one.c
# C: real tilt = d->df * d->dg / d->det, way = d->df * real_abs(d->dt) + d->dg * real_abs(d->ds);
# C: real left = 2 * d->error + way * (8 * REAL_EPSILON * (1 + tilt)) + f->slope_noise * real_abs(d->dt) +
# says: 12 u k |H| + 2.25 u way
# C: if (!(64 * REAL_EPSILON * (d.df * d.dg) <= d.det)) {
# in: algorithms/intersect/certified/avx2_one.h
# C: if (!(64 * DBL_EPSILON * _mm256_cvtsd_f64(area) <= _mm256_cvtsd_f64(det))) {
# in: algorithms/intersect/certified/avx2_any_one.h
# C: if (!(64 * DBL_EPSILON * (df * dg) <= det)) {
# in: algorithms/intersect/certified/batch_newton.h
# C: ended &= wide_less(64 * DBL_EPSILON * (d.df * d.dg), d.det);
#
# In units of |f'|, |g'| (1-norms) and |H| (maximum norm): x, p, q are one coordinate of H, f', g'; e, e1, e2 the
# rounding of det, H x g' and H x f', by cross.g at most 4 u.  H (f' x g') = f' (H x g') - g' (H x f'), so det times
# what is left is x e - p e1 + q e2, but for the quotients' part, by newton_quotient.g 2.25 u of f' dt and of g' ds.
@rnd = float<ieee_64, ne>;

left = x * e - p * e1 + q * e2;

{ |x| <= 1 /\ |p| <= 1 /\ |q| <= 1 /\ |e| <= 4b-53 /\ |e1| <= 4b-53 /\ |e2| <= 4b-53 -> |left| <= 12b-53 }
# control: 12b-53 11b-53
