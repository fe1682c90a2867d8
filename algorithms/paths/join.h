/* Records on their way to be joined; for groups.c and join.c only. */
#ifndef FATLINE_JOIN_H
#define FATLINE_JOIN_H

#include "paths.h"

struct joining {
    const struct path_solver *z;
    struct path_record *record;
    int records;
    int *bucket;  /* of sorting: count_a + 1 */
    int *head[2]; /* of the lists of records that reach a joint, by the segment that ends there */
    int *next;    /* of entries: 4 r + 2 side + end */
    int *order;
    int reaching; /* so many records reach a joint */
    int chains;
};

static inline const struct path *joining_path(const struct path_solver *z, int side)
{
    return side ? z->b : z->a;
}

static inline const struct path_span *joining_span(const struct path_record *r, int side)
{
    return side ? &r->b : &r->a;
}

/* The joint that a span reaches with its lower end (end 0) or its upper one, by the segment that ends there;
 * or -1. */
int path_joint_reached(const struct path *path, const struct path_span *span, int end);
bool path_spans_meet(const struct path *path, const struct path_span *p, const struct path_span *q);

/* Of the records, `order` has those that may reach a joint, `reaching` of them, and `link` leads to the root
 * of each one's group, its member with the least number. */
void path_groups_make(struct joining *j);
int path_group_of(struct path_record *record, int r); /* the root */

#endif
