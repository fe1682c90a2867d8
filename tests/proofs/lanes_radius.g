# The radius of the lanes is computed to 17 u of itself; 1 + 8 DBL_EPSILON makes up for 16 u, and lanes_past.g leaves more
# than the rest.
# in: algorithms/intersect/certified/batch_nodes.h
# C: const double up = 1 + 8 * DBL_EPSILON;
# C: wide both = 1.0 / (det * thrice), one = both * thrice, k = both * det * up;
# C: out->reach_t = c->g.speed * width_f * k;
# in: algorithms/intersect/certified/batch_newton.h
# C: wide tilt = d->df * d->dg * d->one, way = wide_fma(d->df, dt, d->dg * ds);
# C: wide left = 2.0 * d->error + way * (8 * eps * (1.0 + tilt)) + noise * (dt + ds);
# C: wide rt = f->reach * left, rs = g->reach * left;
# says: A radius is computed to 17 u of itself
#
# Widths of nodes and 8 DBL_EPSILON are powers of two: products with them are exact.
@rnd = float<ieee_64, ne>;

thrice rnd= 3 * gap;
both rnd= 1 / rnd(chords * thrice);
k rnd= (both * chords) * (1 + 1b-49);
reach rnd= speed * k;
one rnd= 1 / det;
tilt rnd= 1 + df * dg * one;
way = rnd(df * dt + rnd(dg * ds));
left = rnd(rnd(2 * error + rnd(way * (1b-49 * tilt))) + rnd(noise * rnd(dt + ds)));
rt rnd= reach * left;

Left = 2 * error + (df * dt + dg * ds) * (1b-49 * (1 + df * dg * (1 / det))) + noise * (dt + ds);
Reach = speed * ((1 / (chords * (3 * gap))) * chords * (1 + 1b-49));

{ df in [1b-60,1b10] /\ dg in [1b-60,1b10] /\ det in [1b-130,1b20] /\ dt in [1b-60,1b10] /\ ds in [1b-60,1b10] /\
  error in [1b-60,1] /\ noise in [1b-60,1] /\ speed in [1b-60,1b10] /\ gap in [1b-120,1b10] /\ chords in [1b-120,1b10] ->
  rt -/ (Reach * Left) in [-17b-53,17b-53] }
# control: [-17b-53,17b-53] [-8b-53,8b-53]
