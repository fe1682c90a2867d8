# What is taken off a cross product is computed to 4 u of itself.
# in: algorithms/intersect/certified/cone.c
# C: real bound = (real)1.5 * (f->error * g->speed + g->error * f->speed);
# C: real c = (r->lo > 0 ? r->lo : -r->hi) - bound;
# says: 4 u of itself
@rnd = float<ieee_64, ne>;

s rnd= ef * vg + eg * vf;
bound rnd= 1.5 * s;
B = 1.5 * (ef * vg + eg * vf);

{ vf in [1,2] /\ vg in [1,2] /\ ef in [8b-53,1b-20] /\ eg in [8b-53,1b-20] -> bound -/ B in [-4b-53,4b-53] }
# control: 4b-53 1b-53
