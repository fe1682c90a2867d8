/* list.h turned into the tables intersectors[], peers[], intersector_variants[] and controls[]. */
#include <string.h>

#include "bezier.h"

#define INTERSECTOR(name) extern const struct intersector name;
#define PEER(name) extern const struct intersector name;
#define VARIANT(name) extern const struct intersector name;
#define CONTROL(name) extern const struct intersector name;
#include "list.h"
extern const struct intersector INTERSECTOR_FLOOR;
#undef INTERSECTOR
#undef PEER
#undef VARIANT
#undef CONTROL

#define INTERSECTOR(name) &name,
#define PEER(name)
#define VARIANT(name)
#define CONTROL(name)
extern const struct intersector *const intersectors[];
const struct intersector *const intersectors[] = {
#include "list.h"
    NULL};
#undef INTERSECTOR
#undef PEER

#define INTERSECTOR(name)
#define PEER(name) &name,
extern const struct intersector *const peers[];
const struct intersector *const peers[] = {
#include "list.h"
    NULL};
#undef PEER
#undef VARIANT

#define PEER(name)
#define VARIANT(name) &name,
extern const struct intersector *const intersector_variants[];
const struct intersector *const intersector_variants[] = {
#include "list.h"
    NULL};
#undef VARIANT
#undef CONTROL

#define VARIANT(name)
#define CONTROL(name) &name,
extern const struct intersector *const controls[];
const struct intersector *const controls[] = {
#include "list.h"
    NULL};

extern const struct intersector *const intersector_default;
const struct intersector *const intersector_default = &INTERSECTOR_DEFAULT;

extern const struct intersector *const intersector_floor;
const struct intersector *const intersector_floor = &INTERSECTOR_FLOOR;

const struct intersector *intersector_find(const char *name)
{
    const struct intersector *const *tables[] = {intersectors, peers, intersector_variants, controls};
    if (!strcmp(intersector_floor->name, name)) {
        return intersector_floor;
    }
    for (int k = 0; k < 4; k++) {
        for (const struct intersector *const *a = tables[k]; *a; a++) {
            if (!strcmp((*a)->name, name)) {
                return *a;
            }
        }
    }
    return NULL;
}
