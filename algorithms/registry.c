/* list.h turned into the tables intersectors[] and controls[]. */
#include <string.h>

#include "bezier.h"

#define INTERSECTOR(name) extern const struct intersector name;
#define CONTROL(name) extern const struct intersector name;
#include "list.h"
#undef INTERSECTOR
#undef CONTROL

#define INTERSECTOR(name) &name,
#define CONTROL(name)
extern const struct intersector *const intersectors[];
const struct intersector *const intersectors[] = {
#include "list.h"
    NULL};
#undef INTERSECTOR
#undef CONTROL

#define INTERSECTOR(name)
#define CONTROL(name) &name,
extern const struct intersector *const controls[];
const struct intersector *const controls[] = {
#include "list.h"
    NULL};

extern const struct intersector *const intersector_default;
const struct intersector *const intersector_default = &INTERSECTOR_DEFAULT;

const struct intersector *intersector_find(const char *name)
{
    const struct intersector *const *tables[] = {intersectors, controls};
    for (int k = 0; k < 2; k++) {
        for (const struct intersector *const *a = tables[k]; *a; a++) {
            if (!strcmp((*a)->name, name)) {
                return *a;
            }
        }
    }
    return NULL;
}
