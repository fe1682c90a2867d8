# The radius of the cubic kernel is computed to 16 u of itself, which the factor of its reach, 1 + 8 DBL_EPSILON, makes up
# for.
# in: algorithms/intersect/certified/avx2_one.h
# C: const double up = 1 + 8 * DBL_EPSILON, k = up / (3 * c);
# C: out->reach = _mm256_mul_pd(halves(g->speed * k, f->speed * k), width);
# C: __m256d way = _mm256_mul_pd(step, _mm256_fmadd_pd(own, solving, p->slope_noise));
# C: __m256d left = _mm256_add_pd(_mm256_add_pd(noise, noise), both_halves(way));
# C: __m256d radius = _mm256_mul_pd(a->reach, left);
# in: algorithms/intersect/certified/solve_one.c
# says: 16 u of itself
#
# Widths of parts and 8 DBL_EPSILON are powers of two: products with them are exact.
@rnd = float<ieee_64, ne>;

k = rnd((1 + 1b-49) / rnd(3 * gap));
reach rnd= speed * k;
area rnd= df * dg;
tilt rnd= 1 + area / det;
wf = rnd(dt * rnd(df * (1b-49 * tilt) + nf));
wg = rnd(ds * rnd(dg * (1b-49 * tilt) + ng));
left = rnd(2 * noise + rnd(wf + wg));
rt rnd= reach * left;

Tilt = 1 + df * dg / det;
Left = 2 * noise + (dt * (df * (1b-49 * Tilt) + nf) + ds * (dg * (1b-49 * Tilt) + ng));
Reach = speed * ((1 + 1b-49) / (3 * gap));

{ df in [1b-60,1b10] /\ dg in [1b-60,1b10] /\ det in [1b-130,1b20] /\ dt in [1b-60,1b10] /\ ds in [1b-60,1b10] /\
  noise in [1b-60,1] /\ nf in [1b-60,1] /\ ng in [1b-60,1] /\ speed in [1b-60,1b10] /\ gap in [1b-120,1b10] ->
  rt -/ (Reach * Left) in [-15b-53,15b-53] }
# control: 15b-53 8b-53
