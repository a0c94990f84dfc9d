/* Memory of the caller, taken piece by piece from its beginning. */
#ifndef SOFTCAT_MEMORY_H
#define SOFTCAT_MEMORY_H

#include "softcat_model.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

typedef struct softcat_memory {
    unsigned char *base; /* NULL: only count */
    size_t used, size;
} softcat_memory;

enum { SOFTCAT_ALIGNMENT = 16 };

/* Zeroed room for so many things; NULL where there is no such room, or none at all. What was taken
 * too much shows in `used`, which goes on counting. */
static inline void *softcat_take(softcat_memory *memory, size_t count, size_t each)
{
    size_t at = memory->used, most = SIZE_MAX - at - SOFTCAT_ALIGNMENT;
    if (at > SIZE_MAX - SOFTCAT_ALIGNMENT || (each && count > most / each)) {
        memory->used = SIZE_MAX;
        return NULL;
    }
    size_t bytes = (count * each + SOFTCAT_ALIGNMENT - 1) / SOFTCAT_ALIGNMENT * SOFTCAT_ALIGNMENT;
    memory->used = at + bytes;
    if (!memory->base || memory->used > memory->size) return NULL;
    return memset(memory->base + at, 0, bytes);
}

static inline double *softcat_take_doubles(softcat_memory *memory, size_t count)
{
    return softcat_take(memory, count, sizeof(double));
}

static inline int *softcat_take_ints(softcat_memory *memory, size_t count)
{
    return softcat_take(memory, count, sizeof(int));
}

/* Whether all that was asked for has its room. */
static inline int softcat_fits(const softcat_memory *memory)
{
    return memory->base && memory->used <= memory->size;
}

/* What a caller gives, from where it is aligned; without base if that is nothing. */
static inline softcat_memory softcat_memory_of(softcat_workspace given)
{
    softcat_memory memory = {NULL, 0, 0};
    uintptr_t at = (uintptr_t)given.memory;
    size_t lost = (SOFTCAT_ALIGNMENT - at % SOFTCAT_ALIGNMENT) % SOFTCAT_ALIGNMENT;
    if (!given.memory || given.bytes < lost) return memory;
    memory.base = (unsigned char *)given.memory + lost;
    memory.size = given.bytes - lost;
    return memory;
}

/* Bytes to ask a caller for, wherever his memory begins; 0 if there cannot be so many. */
static inline size_t softcat_bytes(const softcat_memory *memory)
{
    return memory->used > SIZE_MAX - SOFTCAT_ALIGNMENT ? 0 : memory->used + SOFTCAT_ALIGNMENT;
}

#endif
