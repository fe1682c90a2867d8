/* Eight boxes against boxes: in vectors of two doubles, or of four where the processor has AVX2. */
#include "paths.h"

/* Bit k of met[i], for the i of `which`: box i of `from` meets box k of `to`. */
#define BOXES_AGAINST(name, attributes, vector, mask, lanes, bits_of)                                        \
    attributes static void name(const struct path_node *from, unsigned which, const struct path_node *to,    \
                                unsigned char met[PATH_FAN])                                                 \
    {                                                                                                        \
        for (; which; which &= which - 1) {                                                                  \
            int i = __builtin_ctz(which);                                                                    \
            unsigned apart = 0;                                                                              \
            for (int k = 0; k < PATH_FAN; k += lanes) {                                                      \
                mask out = {0};                                                                              \
                for (int h = 0; h < 4; h++) {                                                                \
                    const vector low = *(const vector *)(const void *)&to->low[h][k],                        \
                                 high = *(const vector *)(const void *)&to->high[h][k];                      \
                    out |= (mask)((high < from->low[h][i]) | (low > from->high[h][i]));                      \
                }                                                                                            \
                apart |= (unsigned)bits_of((vector)out) << k;                                                \
            }                                                                                                \
            met[i] = (unsigned char)~apart;                                                                  \
        }                                                                                                    \
    }

#if defined(__x86_64__)

/* typedefs: there is no other way to name a vector type */
typedef double two __attribute__((vector_size(16), aligned(8), may_alias));
typedef long long two_bits __attribute__((vector_size(16)));
typedef double four __attribute__((vector_size(32), aligned(8), may_alias));
typedef long long four_bits __attribute__((vector_size(32)));

BOXES_AGAINST(against_2, , two, two_bits, 2, __builtin_ia32_movmskpd)
BOXES_AGAINST(against_4, __attribute__((target("avx2"))), four, four_bits, 4, __builtin_ia32_movmskpd256)

path_boxes *path_boxes_choose(void)
{
    return __builtin_cpu_supports("avx2") ? against_4 : against_2;
}

#else

static void against_1(const struct path_node *from, unsigned which, const struct path_node *to,
                      unsigned char met[PATH_FAN])
{
    for (; which; which &= which - 1) {
        int i = __builtin_ctz(which);
        met[i] = 0;
        for (int k = 0; k < PATH_FAN; k++) {
            int apart = 0;
            for (int h = 0; h < 4; h++) {
                apart |= (to->high[h][k] < from->low[h][i]) | (to->low[h][k] > from->high[h][i]);
            }
            met[i] = (unsigned char)(met[i] | !apart << k);
        }
    }
}

path_boxes *path_boxes_choose(void)
{
    return against_1;
}

#endif
