/* Eight pairs at a time, where the processor has AVX-512. */
#if defined(__x86_64__) && !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)

#define LANES 8
#include "batch_steps.h"

LANES_TARGET void batch_chunk_avx512(struct batch_chunk *z)
{
    settle_chunk(z);
}

#endif
