# A cubic in powers: coefficients from differences h, and Horner's rule with fused operations.  L is the largest |h| as
# computed: v2 t + c0 is off by 60 u L before it is rounded, the derivative by 141 u L.  L in [1, 2] as [1, 5/4],
# [5/4, 3/2], [3/2, 2], each with its least bound and its largest h.
# in: algorithms/intersect/certified/avx2_one.h
# C: out->c1 = _mm256_mul_pd(three, h0);
# C: out->c2 = _mm256_mul_pd(three, k0);
# C: out->c3 = _mm256_sub_pd(k1, k0);
# C: out->d2 = _mm256_add_pd(out->c2, out->c2);
# C: out->d3 = _mm256_mul_pd(three, out->c3);
# C: *slope = _mm256_fmadd_pd(_mm256_fmadd_pd(p->d3, t, p->d2), t, p->c1);
# C: *value = _mm256_fmadd_pd(_mm256_fmadd_pd(_mm256_fmadd_pd(p->c3, t, p->c2), t, p->c1), t, p->c0);
# says: noise  60 u L + u S
# says: slope 141 u L
@rnd = float<ieee_64, ne>;

h0 = rnd(H0);
h1 = rnd(H1);
h2 = rnd(H2);
t = rnd(t_);
k0 = rnd(h1 - h0);
k1 = rnd(h2 - h1);
c1 = rnd(3 * h0);
c2 = rnd(3 * k0);
c3 = rnd(k1 - k0);
d2 = 2 * c2;
d3 = rnd(3 * c3);
v1 = rnd(c3 * t + c2);
v2 = rnd(v1 * t + c1);
s1 = rnd(d3 * t + d2);
s2 = rnd(s1 * t + c1);

C1 = 3 * H0;
C2 = 3 * (H1 - H0);
C3 = (H2 - H1) - (H1 - H0);
V = (C3 * t + C2) * t + C1;
D = (3 * C3 * t + 2 * C2) * t + C1;

{ t in [0,1] /\ |h0| <= 1.25 /\ |h1| <= 1.25 /\ |h2| <= 1.25 /\ |H0| <= 1.2501 /\ |H1| <= 1.2501 /\ |H2| <= 1.2501 ->
  |v2 - V| <= 60b-53 /\ |s2 - D| <= 141b-53 }
# also: 1.25=1.5 1.2501=1.5001 60b-53=75b-53 141b-53=176b-53
# also: 1.25=2 1.2501=2.0001 60b-53=90b-53 141b-53=211b-53
# control: 60b-53 30b-53
# control: 141b-53 70b-53
