#include "random.h"

/* Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014: increment and finaliser. */
static const uint64_t golden = 0x9e3779b97f4a7c15u;

static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* FNV-1a, 64 bits. */
static uint64_t hash(const char *text)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (; *text; text++)
        h = (h ^ (unsigned char)*text) * 0x100000001b3u;
    return h;
}

struct random_state random_for(uint64_t seed, const char *family, uint64_t index)
{
    struct random_state r;
    r.state = mix(mix(mix(seed + golden) ^ hash(family)) + index * golden);
    return r;
}

uint64_t random_bits(struct random_state *r)
{
    return mix(r->state += golden);
}

int64_t random_between(struct random_state *r, int64_t lo, int64_t hi)
{
    uint64_t span = (uint64_t)hi - (uint64_t)lo + 1; /* 0: all 2^64 values */
    uint64_t bits = random_bits(r);
    if (span != 0) {
        uint64_t uneven = -span % span; /* 2^64 mod span: so many values would make some results likelier */
        while (bits < uneven)
            bits = random_bits(r);
        bits %= span;
    }
    return (int64_t)((uint64_t)lo + bits);
}

double random_unit(struct random_state *r)
{
    return (double)(random_bits(r) >> 11) * 0x1p-53;
}
