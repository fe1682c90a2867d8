/* Eight boxes against boxes: in vectors of two doubles, of four where the processor has AVX2, of eight with
 * AVX-512. */
#include "paths.h"

/* path_boxes, so many boxes in a vector; unrolled, or the loops would take longer than the comparisons. */
#define BOXES_AGAINST(name, attributes, vector, mask, lanes, bits_of)                                        \
    attributes static uint64_t name(const struct path_node *from, unsigned which,                            \
                                    const struct path_node *to)                                              \
                                                                                                             \
    {                                                                                                        \
        uint64_t met = 0;                                                                                    \
        for (; which; which &= which - 1) {                                                                  \
            int i = __builtin_ctz(which);                                                                    \
            unsigned apart = 0;                                                                              \
            mask out[PATH_FAN / lanes] = {{0}};                                                              \
            _Pragma("GCC unroll 4") for (int h = 0; h < 4; h++)                                              \
            {                                                                                                \
                const vector zero = {0}, low = from->low[h][i] + zero, high = from->high[h][i] + zero;       \
                _Pragma("GCC unroll 4") for (int k = 0; k < PATH_FAN / lanes; k++)                           \
                {                                                                                            \
                    out[k] |= (mask)(((const vector *)(const void *)to->high[h])[k] < low);                  \
                    out[k] |= (mask)(((const vector *)(const void *)to->low[h])[k] > high);                  \
                }                                                                                            \
            }                                                                                                \
            _Pragma("GCC unroll 4") for (int k = 0; k < PATH_FAN / lanes; k++)                               \
            {                                                                                                \
                apart |= (unsigned)bits_of((vector)out[k]) << (k * lanes);                                   \
            }                                                                                                \
            met |= (uint64_t)(~apart & 255) << PATH_FAN * i;                                                 \
        }                                                                                                    \
        return met;                                                                                          \
    }

#if defined(__x86_64__)

/* typedefs: there is no other way to name a vector type */
typedef double two __attribute__((vector_size(16), aligned(8), may_alias));
typedef long long two_bits __attribute__((vector_size(16)));
typedef double four __attribute__((vector_size(32), aligned(8), may_alias));
typedef long long four_bits __attribute__((vector_size(32)));

BOXES_AGAINST(against_2, , two, two_bits, 2, __builtin_ia32_movmskpd)
BOXES_AGAINST(against_4, __attribute__((target("avx2"))), four, four_bits, 4, __builtin_ia32_movmskpd256)

typedef double eight __attribute__((vector_size(64), aligned(8), may_alias));

/* A comparison gives one bit a box: here those that are not apart. */
__attribute__((target("avx512f"))) static uint64_t against_8(const struct path_node *from, unsigned which,
                                                             const struct path_node *to)
{
    enum { NOT_LESS = 0x15, NOT_GREATER = 0x1a, ROUNDING_AS_IT_IS = 4 };
    uint64_t met = 0;
    for (; which; which &= which - 1) {
        int i = __builtin_ctz(which);
        unsigned char above = 255, below = 255;
#pragma GCC unroll 4
        for (int h = 0; h < 4; h++) {
            const eight zero = {0}, low = from->low[h][i] + zero, high = from->high[h][i] + zero;
            above = __builtin_ia32_cmppd512_mask(*(const eight *)(const void *)to->high[h], low, NOT_LESS,
                                                 above, ROUNDING_AS_IT_IS);
            below = __builtin_ia32_cmppd512_mask(*(const eight *)(const void *)to->low[h], high, NOT_GREATER,
                                                 below, ROUNDING_AS_IT_IS);
        }
        met |= (uint64_t)(above & below) << PATH_FAN * i;
    }
    return met;
}

path_boxes *path_boxes_choose(void)
{
    return __builtin_cpu_supports("avx512f") ? against_8
           : __builtin_cpu_supports("avx2")  ? against_4
                                             : against_2;
}

#else

static uint64_t against_1(const struct path_node *from, unsigned which, const struct path_node *to)
{
    uint64_t met = 0;
    for (; which; which &= which - 1) {
        int i = __builtin_ctz(which);
        for (int k = 0; k < PATH_FAN; k++) {
            int apart = 0;
            for (int h = 0; h < 4; h++) {
                apart |= (to->high[h][k] < from->low[h][i]) | (to->low[h][k] > from->high[h][i]);
            }
            met |= (uint64_t)!apart << (PATH_FAN * i + k);
        }
    }
    return met;
}

path_boxes *path_boxes_choose(void)
{
    return against_1;
}

#endif
