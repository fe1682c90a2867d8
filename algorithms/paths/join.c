/* Records of one solution at a joint (groups.c) become one, and all are sorted.
 *
 * What a group without overlaps holds: as many solutions at most as its members together.  If all of them
 * hold no more than one, and all reach the same joint of both paths, which is one point exactly, then that is
 * it: one. If not, it may be proved (joint.c). */
#include "join.h"

/* ---- one group ---- */

/* Of a path against itself: turns the spans of q so that they go with those of p, if they do. */
static bool turn_to(const struct path *path, const struct path_record *p, struct path_record *q)
{
    if (path_spans_meet(path, &p->a, &q->a) && path_spans_meet(path, &p->b, &q->b)) {
        return true;
    }
    if (!path_spans_meet(path, &p->a, &q->b) || !path_spans_meet(path, &p->b, &q->a)) {
        return false;
    }
    struct path_span s = q->a;
    q->a = q->b;
    q->b = s;
    return true;
}

/* Members of the group are linked by next[4 r], from its root on.  Puts them in an order where each goes with
 * one before it; `chain`, 0 so far, marks those that have their place. */
static void turn_members(struct joining *j, int root)
{
    struct path_record *record = j->record;
    bool more = true;
    for (int r = root; r >= 0; r = j->next[4 * r]) {
        record[r].chain = r == root;
    }
    while (more) {
        more = false;
        for (int r = root; r >= 0; r = j->next[4 * r]) {
            for (int q = root; record[r].chain && q >= 0; q = j->next[4 * q]) {
                if (!record[q].chain && turn_to(j->z->a, &record[r], &record[q])) {
                    record[q].chain = 1;
                    more = true;
                }
            }
        }
    }
}

/* A member whose span is on `segment` and reaches its end (0 or 1; 2: any); lo, hi grow to its span. */
static bool reach(const struct joining *j, int root, int side, int segment, int end, struct path_span *s)
{
    bool found = false;
    for (int r = root; r >= 0; r = j->next[4 * r]) {
        const struct path_span *p = joining_span(&j->record[r], side);
        if (p->first == segment && (end == 2 || (end == 0 ? p->lo == 0 : p->hi == 1))) {
            s->lo = found ? real_min(s->lo, p->lo) : p->lo;
            s->hi = found ? real_max(s->hi, p->hi) : p->hi;
            found = true;
        }
    }
    return found;
}

static struct path_span hull_of(const struct joining *j, int root, int side)
{
    const struct path *path = joining_path(j->z, side);
    int home = joining_span(&j->record[root], side)->first;
    struct path_span s = {home, home, 0, 1}, ends;
    for (int k = path->before[home]; k >= 0 && k != home && reach(j, root, side, k, 1, &ends);
         k = path->before[k]) {
        s.first = k;
    }
    for (int k = path->next[home]; k >= 0 && k != s.first && reach(j, root, side, k, 0, &ends);
         k = path->next[k]) {
        s.last = k;
    }
    if (s.first == s.last) {
        reach(j, root, side, home, 2, &s);
        return s;
    }
    reach(j, root, side, s.first, 1, &ends);
    s.lo = ends.lo;
    reach(j, root, side, s.last, 0, &ends);
    s.hi = ends.hi;
    return s;
}

/* Does every member reach the joints x and y, and are these one point? */
static bool is_at_joints(const struct joining *j, int root, int x, int y)
{
    const struct path *a = j->z->a, *b = j->z->b;
    for (int r = root; r >= 0; r = j->next[4 * r]) {
        const struct path_span *p = &j->record[r].a, *q = &j->record[r].b;
        if ((path_joint_reached(a, p, 0) != x && path_joint_reached(a, p, 1) != x) ||
            (path_joint_reached(b, q, 0) != y && path_joint_reached(b, q, 1) != y)) {
            return false;
        }
    }
    return path_same_point(&a->segment[x], a->segment[x].degree, &b->segment[y], b->segment[y].degree);
}

static bool meets_at_joints(const struct joining *j, int root)
{
    const struct path_record *r = &j->record[root];
    for (int k = 0; k < 4; k++) {
        int x = path_joint_reached(j->z->a, &r->a, k & 1), y = path_joint_reached(j->z->b, &r->b, k >> 1);
        if (x >= 0 && y >= 0 && is_at_joints(j, root, x, y)) {
            return true;
        }
    }
    return false;
}

/* The members become one record, the root's. */
static void merge_group(struct joining *j, int root)
{
    struct path_record *to = &j->record[root];
    int at_most = 0, members = 0;
    bool known = true, single = true, joint = false;
    if (j->z->self) {
        turn_members(j, root);
        to->chain = 0;
    }
    struct path_span a = hull_of(j, root, 0), b = hull_of(j, root, 1);
    for (int r = root; r >= 0; r = j->next[4 * r]) {
        const struct path_record *m = &j->record[r];
        single = single && (m->standing == UNIQUE || m->standing == END);
        known = known && m->at_most > 0;
        joint = joint || m->joint;
        at_most += m->at_most;
        members++;
    }
    if (members == 1 && (to->standing == UNIQUE || !single)) {
        return;
    }
    bool exact = single && meets_at_joints(j, root);
    bool one = exact || (single && path_joint_prove(j->z->a, j->z->b, &a, &b));
    for (int r = j->next[4 * root]; r >= 0; r = j->next[4 * r]) {
        j->record[r].link = -1; /* gone */
    }
    to->a = a;
    to->b = b;
    to->joint = joint;
    to->proved = one && !exact;
    if (one || members > 1) {
        to->standing = one ? UNIQUE : known ? CLUSTER : CANDIDATE;
        to->at_most = one ? 1 : known ? at_most : 0;
    }
}

static void settle_group(struct joining *j, int root)
{
    bool overlaps = false;
    for (int r = root; r >= 0; r = j->next[4 * r]) {
        overlaps = overlaps || j->record[r].overlap >= 0;
    }
    if (!overlaps) {
        merge_group(j, root);
    } else if (j->next[4 * root] >= 0) {
        j->chains++;
        for (int r = root; r >= 0; r = j->next[4 * r]) {
            j->record[r].chain = j->chains;
        }
    }
}

static void settle_groups(struct joining *j)
{
    for (int at = 0; at < j->reaching; at++) {
        j->next[4 * j->order[at]] = -1;
    }
    for (int at = j->reaching - 1; at >= 0; at--) {
        int r = j->order[at], root = path_group_of(j->record, r);
        if (root != r) { /* a root has the least number of its group, and comes last */
            j->next[4 * r] = j->next[4 * root];
            j->next[4 * root] = r;
        }
    }
    for (int at = 0; at < j->reaching; at++) {
        if (j->record[j->order[at]].link == j->order[at]) {
            settle_group(j, j->order[at]);
        }
    }
}

/* ---- what was found twice ---- */

/* Records of the bucket of a segment that hold nothing but r's solution are gone. */
static void drop_others(struct joining *j, int r, int segment)
{
    for (int k = segment > 0 ? j->bucket[segment - 1] : 0; k < j->bucket[segment]; k++) {
        struct path_record *q = &j->record[j->order[k]];
        if (j->order[k] != r && q->link >= 0 && q->overlap < 0 && q->chain == 0 &&
            path_joint_holds(&j->record[r], q, j->z->self)) {
            q->link = -1;
        }
    }
}

/* A solution proved beside a joint may also have a record that does not reach the joint.  Returns the records
 * left. */
static int drop_doubles(struct joining *j, int count)
{
    int kept = 0;
    for (int k = 0; k < count; k++) {
        int r = j->order[k];
        const struct path_record *p = &j->record[r];
        if (!p->proved || p->link < 0) {
            continue;
        }
        drop_others(j, r, p->a.first);
        drop_others(j, r, p->a.last);
        if (j->z->self) {
            drop_others(j, r, p->b.first);
            drop_others(j, r, p->b.last);
        }
    }
    for (int k = 0; k < count; k++) {
        if (j->record[j->order[k]].link >= 0) {
            j->order[kept++] = j->order[k];
        }
    }
    return kept;
}

/* ---- all ---- */

/* Of a path against itself the earlier span comes first. */
static void turn_spans(const struct joining *j)
{
    for (int r = 0; j->z->self && r < j->records; r++) {
        struct path_record *p = &j->record[r];
        if (p->overlap < 0 && path_span_precedes(&p->b, &p->a)) {
            struct path_span s = p->a;
            p->a = p->b;
            p->b = s;
        }
    }
}

size_t path_join_size(int count_a, int count_b, int records)
{
    return (2 * (size_t)count_a + 1 + (size_t)count_b + 5 * (size_t)records) * sizeof(int);
}

void path_records_join(const struct path_solver *z, struct path_records *all, void *numbers)
{
    struct joining j;
    int records = all->count;
    j.z = z;
    j.record = all->at;
    j.records = records;
    j.bucket = (int *)numbers;
    j.head[0] = j.bucket + z->a->count + 1;
    j.head[1] = z->self ? j.head[0] : j.head[0] + z->a->count;
    int joints = z->a->count + (z->self ? 0 : z->b->count);
    j.next = j.head[0] + joints;
    j.order = j.next + 4 * (size_t)records;
    j.chains = 0;
    path_groups_make(&j);
    settle_groups(&j);
    turn_spans(&j);
    all->count = drop_doubles(&j, path_records_sort(j.record, j.records, z->a->count, j.bucket, j.order));
    all->order = j.order;
}
