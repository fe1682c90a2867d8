#include "front.h"
#ifdef FATLINE_AVX2
bool front_cubic_avx2(struct front *z)
{
    (void)z;
    return false;
}
#endif
