# A cut: each of n steps with weights 1 - h, h adds 3.5 u S to the error, each of n steps with weights 1 - R, R, as
# restrict_weights.g has them, 4.5 u S; together 8 n u S.
# in: algorithms/core/bernstein.c
# C: real u = 1 - hi, v = 1, r = 0;
# C: c3 = u * c2 + h * c3;
# C: c0 = v * c0 + r * c1;
# C: c[i] = u * c[i - 1] + h * c[i];
# C: c[i] = v * c[i] + r * c[i + 1];
# in: algorithms/core/bernstein.h
# says: the error is at most 8n u
#
# The exact mean of two points is below S like them, and the exact mean of their errors is no larger than these.
@rnd = float<ieee_64, ne>;

h = rnd(h_);
u rnd= 1 - h;
x = S * a;
y = S * b;
first rnd= u * x + h * y;
F = S * ((1 - h) * a + h * b);

v = (1 - R) * (1 + dv);
r = R * (1 + dr);
second rnd= v * x + r * y;
G = S * ((1 - R) * a + R * b);

{ S in [1,2] /\ h in [0,1] /\ R in [0,1] /\ |dv| <= 9b-55 /\ |dr| <= 1b-53 /\ |a| <= 1 /\ |b| <= 1 /\
  |(1 - h) * a + h * b| <= 1 /\ |(1 - R) * a + R * b| <= 1 ->
  |(first - F) / S| <= 7b-54 /\ |(second - G) / S| <= 9b-54 }
first - F -> (first - (u * x + h * y)) + S * (u - (1 - h)) * a;
second - G -> (second - (v * x + r * y)) + S * ((1 - R) * dv * a + R * dr * b);
$ S in 8, h in 16;
$ S in 8, R in 16;
# control: 7b-54 1b-53
# control: 9b-54 5b-54
