/* Four pairs at a time, where the processor has AVX2 and FMA. */
#if defined(__x86_64__) && !defined(FATLINE_QUAD) && !defined(FATLINE_MULTI)

#define LANES 4
#include "batch_steps.h"

LANES_TARGET void batch_chunk_avx2(struct batch_chunk *z)
{
    settle_chunk(z);
}

#endif
