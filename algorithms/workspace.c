/* Memory of one solve, laid out in one block of the caller's. */
#include "bezier.h"

enum { COMPONENTS = 3 }; /* w x, w y, w */

static size_t pool_length(int n, int m, int room)
{
    return (size_t)room * COMPONENTS * (size_t)(n + m + 2);
}

static size_t cells_bytes(int room)
{
    size_t bytes = (size_t)room * sizeof(struct cell);
    return (bytes + 63) / 64 * 64;
}

size_t workspace_size(int n, int m, int room, size_t scratch)
{
    size_t numbers = pool_length(n, m, room) + COMPONENTS * (size_t)(n + m + 2) + scratch;
    return cells_bytes(room) + numbers * sizeof(real);
}

void workspace_init(struct workspace *w, void *memory, int n, int m, int room, size_t scratch)
{
    w->room = room;
    w->used = w->steps = 0;
    w->cell = (struct cell *)memory;
    w->pool = (real *)(void *)((char *)memory + cells_bytes(room));
    w->prepared = w->pool + pool_length(n, m, room);
    w->scratch = w->prepared + COMPONENTS * (n + m + 2);
    w->scratch_length = scratch;
    w->planned = false;
    w->plan = NULL;
    w->plan_n = w->plan_m = 0;
    w->watch = NULL;
    w->ignore = NULL;
    w->swapped = false;
    w->log = NULL;
}
