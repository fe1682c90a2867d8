/* splitmix64: a small generator of our own, so that a seed means the same everywhere. */
#ifndef FATLINE_RANDOM_H
#define FATLINE_RANDOM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct random_state {
    uint64_t state;
};

/* A stream of its own for each (seed, family, index): independent of order and of shards. */
struct random_state random_for(uint64_t seed, const char *family, uint64_t index);
uint64_t random_bits(struct random_state *r);
int64_t random_between(struct random_state *r, int64_t lo, int64_t hi); /* uniform in lo..hi, both included */
double random_unit(struct random_state *r);                             /* k 2^-53 in [0, 1) */

#ifdef __cplusplus
}
#endif
#endif
