# The weights of a cut: 1 - hi is rounded once, so is lo / hi; (hi - lo) / hi errs by 2.25 u of itself.
# in: algorithms/core/bernstein.c
# C: real u = 1 - hi, v = 1, r = 0;
# C: v = (hi - lo) / hi;
# C: r = lo / hi;
# in: algorithms/core/bernstein.h
# says: restrict_weights.g,
#
# Parameters above 2^-100: smaller differences of parameters are no intervals of ours.
@rnd = float<ieee_64, ne>;

hi = rnd(hi_);
lo = rnd(lo_);
w rnd= hi - lo;
v rnd= w / hi;
r rnd= lo / hi;

{ hi in [1b-100,1] /\ lo in [1b-200,1] /\ lo / hi in [1b-200,1] /\ hi - lo in [1b-200,1] /\
  (hi - lo) / hi in [1b-200,1] ->
  v -/ ((hi - lo) / hi) in [-9b-55,9b-55] /\ r -/ (lo / hi) in [-1b-53,1b-53] }
# control: 9b-55 1b-53
