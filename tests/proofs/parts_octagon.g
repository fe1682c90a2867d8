# The octagon of a part: what is taken off the least form, 40 u S or 80 u S, covers its error, E or 2 E, and rounding.
# in: algorithms/intersect/certified/avx2_parts.h
# C: 40 * unit, 40 * unit, 80 * unit, 80 * unit
# says: E + u S of rounding for x and y, twice that for the sums: 40 u S and 80 u S.
# says: u S <= E = 37 u S
#
# S is 1 for what grows with S, the data's error and the pad; the rounding is that of points up to 2.
@rnd = float<ieee_64, ne>;

x = X + 37b-53 * p;
s = Z + 74b-53 * q;
low = rnd(x - 40b-53);
least = rnd(s - 80b-53);

{ |x| <= 2 /\ |s| <= 4 /\ |p| <= 1 /\ |q| <= 1 -> low - X <= 0 /\ least - Z <= 0 }
low - X -> (low - (x - 40b-53)) + 37b-53 * p - 40b-53;
least - Z -> (least - (s - 80b-53)) + 74b-53 * q - 80b-53;
# control: 40b-53 37b-53
# control: 80b-53 75b-53
