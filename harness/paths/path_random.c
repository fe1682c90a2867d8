/* Smooth random walks.  Only + - * / and the square root, so that every machine makes the same. */
#include <math.h>
#include <stdint.h>

#include "../cases/random.h"
#include "path_set.h"

struct walker {
    struct random_state random;
    double x, y, dx, dy, turn, step;
};

/* One step: the direction turns by about `turn`, which wanders; at a side of the square it is reflected. */
static void walk(struct walker *w)
{
    double random = random_unit(&w->random) - 0.5, bend, c, s, dx, dy;

    w->turn = 0.9 * w->turn + 0.6 * random;
    bend = w->turn / 2;
    c = (1 - bend * bend) / (1 + bend * bend);
    s = 2 * bend / (1 + bend * bend);
    dx = c * w->dx - s * w->dy;
    dy = s * w->dx + c * w->dy;
    w->dx = w->x + w->step * dx < 0 || w->x + w->step * dx > 1 ? -dx : dx;
    w->dy = w->y + w->step * dy < 0 || w->y + w->step * dy > 1 ? -dy : dy;
    w->x += w->step * w->dx;
    w->y += w->step * w->dy;
}

/* Catmull and Rom's cubic from the second to the third of four points. */
static void add_cubic(struct path_draft *d, const double x[4], const double y[4])
{
    real a[4], b[4];

    a[0] = x[1];
    a[1] = x[1] + (x[2] - x[0]) / 6;
    a[2] = x[2] - (x[3] - x[1]) / 6;
    a[3] = x[2];
    b[0] = y[1];
    b[1] = y[1] + (y[2] - y[0]) / 6;
    b[2] = y[2] - (y[3] - y[1]) / 6;
    b[3] = y[2];
    path_draft_add(d, 3, a, b, NULL);
}

void path_random(struct path_set *set, const char *id, int count, uint64_t seed, uint64_t index)
{
    struct walker w = {random_for(seed, "paths", index), 0, 0, 0.6, 0.8, 0, 1 / sqrt((double)count)};
    struct path_draft d;
    double x[4], y[4];

    path_draft_begin(&d, id);
    w.x = random_unit(&w.random);
    w.y = random_unit(&w.random);
    for (int i = 0; i < count + 3; i++) {
        int k = i < 3 ? i : 3;

        x[k] = w.x;
        y[k] = w.y;
        walk(&w);
        if (k < 3)
            continue;
        add_cubic(&d, x, y);
        for (int j = 0; j < 3; j++) {
            x[j] = x[j + 1];
            y[j] = y[j + 1];
        }
    }
    path_draft_end(&d, set);
}
