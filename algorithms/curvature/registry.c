/* list.h turned into the table region_methods[], and names. */
#include <string.h>

#include "../region.h"

#define INTERSECTOR(name)
#define CONTROL(name)
#define PEER(name)
#define VARIANT(name)
#define REGION_METHOD(name) extern const struct region_method name;
#include "../list.h"
#undef REGION_METHOD

#define REGION_METHOD(name) &name,
extern const struct region_method *const region_methods[];
const struct region_method *const region_methods[] = {
#include "../list.h"
    NULL};

const struct region_method *region_method_find(const char *name)
{
    for (const struct region_method *const *m = region_methods; *m; m++) {
        if (!strcmp((*m)->name, name)) {
            return *m;
        }
    }
    return NULL;
}

const char *region_kind_name(enum region_kind kind)
{
    static const char *const names[] = {"empty", "point",   "segment",   "ray",
                                        "line",  "bounded", "unbounded", "plane"};
    return names[kind];
}

const char *edge_type_name(enum edge_type type)
{
    static const char *const names[] = {"line", "arc", "chord"};
    return names[type];
}
