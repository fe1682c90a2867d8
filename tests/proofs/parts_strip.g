# Offsets from a part's chord: two of them, each from a point that errs by E, err by less than 88 u S |d|, |d| the 1-norm.
# in: algorithms/intersect/certified/avx2_parts.h
# C: double pad = 96 * unit * (fabs(chord[0]) + fabs(chord[1]));
# says: by 2 u S |d| of the subtraction and 4 u S |d| of products and sum, |d| the 1-norm: two values by less than
# says: 88 u S |d|
#
# An offset is rx dx + ry dy with r = p - p0; this is what one of these products, divided by dx or dy, errs by, so that both
# together err by no more times |d|.  e0 is of the subtraction, e1 of the product, e2 of the sum; S is 1.

r = (x - b) * (1 + e0);
R = x + 37b-53 * p - b;
error = r * (1 + e1) * (1 + e2) - R;

{ |x - b| <= 2 /\ |p| <= 1 /\ |e0| <= 1b-53 /\ |e1| <= 1b-53 /\ |e2| <= 1b-53 -> |error| <= 44b-53 }
error -> (x - b) * (e0 + e1 + e2 + e0 * e1 + e0 * e2 + e1 * e2 + e0 * e1 * e2) - 37b-53 * p;
# control: 44b-53 42b-53
