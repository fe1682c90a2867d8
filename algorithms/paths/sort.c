/* Records in order: into buckets by the segment of the first path, each of them by the rest. */
#include "paths.h"

bool path_span_precedes(const struct path_span *p, const struct path_span *q)
{
    return p->first != q->first ? p->first < q->first : p->lo < q->lo;
}

static bool precedes(const struct path_record *p, const struct path_record *q)
{
    if (path_span_precedes(&p->a, &q->a) || path_span_precedes(&q->a, &p->a)) {
        return path_span_precedes(&p->a, &q->a);
    }
    if (path_span_precedes(&p->b, &q->b) || path_span_precedes(&q->b, &p->b)) {
        return path_span_precedes(&p->b, &q->b);
    }
    return p->a.hi != q->a.hi ? p->a.hi < q->a.hi : p->b.hi < q->b.hi;
}

static void sort_part(const struct path_record *record, int *order, int count)
{
    int gap = 1;
    while (gap < count / 3) {
        gap = 3 * gap + 1;
    }
    for (; gap > 0; gap /= 3) {
        for (int i = gap; i < count; i++) {
            int r = order[i], k = i;
            for (; k >= gap && precedes(&record[r], &record[order[k - gap]]); k -= gap) {
                order[k] = order[k - gap];
            }
            order[k] = r;
        }
    }
}

int path_records_sort(const struct path_record *record, int records, int segments, int *bucket, int *order)
{
    for (int i = 0; i <= segments; i++) {
        bucket[i] = 0;
    }
    for (int r = 0; r < records; r++) {
        bucket[record[r].a.first + 1] += record[r].link >= 0;
    }
    for (int i = 0; i < segments; i++) {
        bucket[i + 1] += bucket[i];
    }
    for (int r = 0; r < records; r++) {
        if (record[r].link >= 0) {
            order[bucket[record[r].a.first]++] = r;
        }
    }
    for (int i = 0, from = 0; i < segments; from = bucket[i++]) {
        sort_part(record, order + from, bucket[i] - from);
    }
    return segments > 0 ? bucket[segments - 1] : 0;
}
