# What is taken off the least cross product of the lanes, 1.5 e (V + W), covers e (V + W) + e^2 of data and 2.5 u V W of
# rounding (fma_cross.g), and its own rounding.
# in: algorithms/intersect/certified/batch_kernel.h
# C: return wide_fms(ax, by, ay * bx);
# C: out->gap = wide_max(low, -high) - unit * (1.5 * way_error) * (out->f.speed + out->g.speed);
# says: e <= V / 2 and u V <= e / 6, so that 1.5 e (V_f + V_g) covers all
#
# In parts of e (V + W): V = P e, W = Q e; 2.5 u V W / (e (V + W)) = 2.5 / (1 / (u W / e) + 1 / (u V / e)), where both
# inverses, A and B, are at least 6.
@rnd = float<ieee_64, ne>;

sum rnd= vf + vg;
bound rnd= k * sum;
least = 1 + 1 / (P + Q) + 2.5 / (A + B);

{ vf in [1b-300,1b300] /\ vg in [1b-300,1b300] /\ k in [1b-300,1b300] /\ P in [2,1b60] /\ Q in [2,1b60] /\ A in [6,1b60] /\
  B in [6,1b60] ->
  least in [0,1.46] /\ bound -/ (k * (vf + vg)) in [-3b-53,3b-53] }
# control: [0,1.46] [0,1.4]
# control: [-3b-53,3b-53] [-1b-53,1b-53]
