#include "algorithms_named.h"
#include "memory.h"

#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add(struct algorithms_named *a, const struct intersector *algorithm)
{
    for (int i = 0; i < a->count; i++)
        if (a->at[i] == algorithm)
            return;
    size_t size = (size_t)(a->count + 2) * sizeof *a->at;
    a->at = (const struct intersector **)memory_need(realloc(a->at, size));
    a->at[a->count++] = algorithm;
    a->at[a->count] = NULL;
}

/* "no algorithm NAME; there are A, B, ..." */
static const char *complain(struct algorithms_named *a, const char *name)
{
    size_t size = strlen(name) + 64, n;
    for (int i = 0; intersectors[i]; i++)
        size += strlen(intersectors[i]->name) + 2;
    free(a->error);
    a->error = (char *)memory_need(malloc(size));
    n = (size_t)snprintf(a->error, size, "no algorithm %s at precision %s; there are", name, REAL_NAME);
    for (int i = 0; intersectors[i]; i++)
        n += (size_t)snprintf(a->error + n, size - n, "%s %s", i ? "," : "", intersectors[i]->name);
    return a->error;
}

static const char *add_part(struct algorithms_named *a, const char *part)
{
    const struct intersector *exact = intersector_find(part);
    bool found = exact != NULL;
    if (exact)
        add(a, exact);
    for (int i = 0; !exact && intersectors[i]; i++)
        if (!strcmp(part, "all") || !fnmatch(part, intersectors[i]->name, 0)) {
            add(a, intersectors[i]);
            found = true;
        }
    for (int i = 0; !exact && peers[i]; i++)
        if (!strcmp(part, "peers") || !fnmatch(part, peers[i]->name, 0)) {
            add(a, peers[i]);
            found = true;
        }
    return found ? NULL : complain(a, part);
}

const char *algorithms_named_add(struct algorithms_named *a, const char *list)
{
    char *copy = (char *)memory_need(strdup(list)), *rest = copy, *part;
    const char *error = NULL;
    while (!error && (part = strsep(&rest, ",")) != NULL)
        error = add_part(a, part);
    free(copy);
    return error;
}

void algorithms_named_clear(struct algorithms_named *a)
{
    free(a->at);
    free(a->error);
    a->at = NULL;
    a->error = NULL;
    a->count = 0;
}
