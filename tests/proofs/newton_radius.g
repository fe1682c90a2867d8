# What follows the residual: the radius is computed to 16 u of itself, which its factor 1 + 8 REAL_EPSILON makes up for.
# in: algorithms/intersect/certified/solve_one.c
# C: out->reach = other->speed * out->width / (a->pace_lo * gap) * (1 + 8 * REAL_EPSILON);
# C: real tilt = d->df * d->dg / d->det, way = d->df * real_abs(d->dt) + d->dg * real_abs(d->ds);
# C: real left = 2 * d->error + way * (8 * REAL_EPSILON * (1 + tilt)) + f->slope_noise * real_abs(d->dt) +
# C: g->slope_noise * real_abs(d->ds);
# C: real rt = f->reach * left, rs = g->reach * left;
# says: 16 u of itself
@rnd = float<ieee_64, ne>;

tilt rnd= df * dg / det;
way rnd= df * dt + dg * ds;
left rnd= 2 * error + way * (1b-49 * (1 + tilt)) + nf * dt + ng * ds;
reach rnd= speed * width / (pace * gap) * (1 + 1b-49);
rt rnd= reach * left;

Left = 2 * error + (df * dt + dg * ds) * (1b-49 * (1 + df * dg / det)) + nf * dt + ng * ds;
Reach = speed * width / (pace * gap) * (1 + 1b-49);

{ df in [1b-60,1b10] /\ dg in [1b-60,1b10] /\ det in [1b-130,1b20] /\ dt in [1b-60,1b10] /\ ds in [1b-60,1b10] /\
  error in [1b-60,1] /\ nf in [1b-60,1] /\ ng in [1b-60,1] /\ speed in [1b-60,1b10] /\ width in [1b-60,1] /\
  pace in [1b-60,1b10] /\ gap in [1b-120,1b10] ->
  rt -/ (Reach * Left) in [-15b-53,15b-53] }
# control: 15b-53 8b-53
