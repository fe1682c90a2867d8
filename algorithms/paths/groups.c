/* Which records are of one solution.
 *
 * A solution at a joint of the first path lies in both segments that meet there, likewise of the second: up
 * to four pairs of segments find it.  Two records meet if on both paths they do: on a path two spans meet
 * that have a parameter of one segment in common, or that reach the same joint.  Records of different pairs
 * of segments that meet, and meet in turn, are one group; so every solution lies in records of one group. Of
 * a path against itself the two spans of a record are not told apart. */
#include "join.h"

int path_joint_reached(const struct path *path, const struct path_span *span, int end)
{
    if (end) {
        return span->hi == 1 && path->next[span->last] >= 0 ? span->last : -1;
    }
    return span->lo == 0 ? path->before[span->first] : -1;
}

bool path_spans_meet(const struct path *path, const struct path_span *p, const struct path_span *q)
{
    if (p->first == q->first && p->lo <= q->hi && q->lo <= p->hi) {
        return true;
    }
    for (int e = 0; e <= 1; e++) {
        int joint = path_joint_reached(path, p, e);
        if (joint >= 0 &&
            (joint == path_joint_reached(path, q, 0) || joint == path_joint_reached(path, q, 1))) {
            return true;
        }
    }
    return false;
}

int path_group_of(struct path_record *record, int r)
{
    while (record[r].link != r) {
        record[r].link = record[record[r].link].link;
        r = record[r].link;
    }
    return r;
}

static void unite(struct path_record *record, int p, int q)
{
    p = path_group_of(record, p);
    q = path_group_of(record, q);
    if (p < q) {
        record[q].link = p;
    } else {
        record[p].link = q;
    }
}

/* Does either end of the span lie at an end of its segment? */
static bool is_at_end(const struct path_span *s)
{
    return (s->lo == 0) | (s->hi == 1);
}

/* The records that may reach a joint go into `order`, and the lists of these joints are empty. */
static void find_reaching(struct joining *j)
{
    j->reaching = 0;
    for (int r = 0; r < j->records; r++) {
        struct path_record *p = &j->record[r];
        p->link = r;
        if (!is_at_end(&p->a) && !is_at_end(&p->b)) {
            continue;
        }
        j->order[j->reaching++] = r;
        for (int k = 0; k < 4; k++) {
            int joint = path_joint_reached(joining_path(j->z, k / 2), joining_span(p, k / 2), k % 2);
            if (joint >= 0) {
                j->head[k / 2][joint] = -1;
            }
        }
    }
}

static void list_joints(struct joining *j)
{
    find_reaching(j);
    for (int at = 0; at < j->reaching; at++) {
        int r = j->order[at];
        for (int k = 0; k < 4; k++) { /* entry 4 r + 2 side + end */
            int side = k / 2, joint = path_joint_reached(joining_path(j->z, side),
                                                         joining_span(&j->record[r], side), k % 2);
            if (joint >= 0) {
                j->next[4 * r + k] = j->head[side][joint];
                j->head[side][joint] = 4 * r + k;
            }
        }
    }
}

/* Two entries of one list: the records reach the same joint with these sides. */
static void try_to_unite(struct joining *j, int e, int f)
{
    const struct path_record *p = &j->record[e / 4], *q = &j->record[f / 4];
    int p_side = e / 2 % 2, q_side = f / 2 % 2;
    bool same_pair = p->a.first == q->a.first && p->b.first == q->b.first;
    if (!same_pair && path_spans_meet(joining_path(j->z, 1 - p_side), joining_span(p, 1 - p_side),
                                      joining_span(q, 1 - q_side))) {
        unite(j->record, e / 4, f / 4);
    }
}

void path_groups_make(struct joining *j)
{
    list_joints(j);
    for (int at = 0; at < j->reaching; at++) {
        int r = j->order[at];
        for (int e = 4 * r; e < 4 * r + 4; e++) {
            int side = e / 2 % 2;
            if (path_joint_reached(joining_path(j->z, side), joining_span(&j->record[r], side), e % 2) < 0) {
                continue;
            }
            for (int f = j->next[e]; f >= 0; f = j->next[f]) {
                try_to_unite(j, e, f);
            }
        }
    }
}
