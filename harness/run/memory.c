#include "memory.h"

#include <stdio.h>
#include <stdlib.h>

void *memory_need(void *memory)
{
    if (!memory) {
        fprintf(stderr, "fatline: out of memory\n");
        exit(2);
    }
    return memory;
}

void *memory_new(size_t count, size_t size)
{
    return memory_need(calloc(count ? count : 1, size));
}

void *memory_resized(void *old, size_t bytes)
{
    return memory_need(realloc(old, bytes ? bytes : 1));
}
