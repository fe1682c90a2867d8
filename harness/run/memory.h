/* Memory that is there: without it the program ends with 2. */
#ifndef FATLINE_MEMORY_H
#define FATLINE_MEMORY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

void *memory_need(void *memory);               /* memory, which is not NULL */
void *memory_new(size_t count, size_t size);   /* zeroed; the caller's to free */
void *memory_resized(void *old, size_t bytes); /* as realloc; 0 bytes are 1 */

#ifdef __cplusplus
}
#endif

#endif
