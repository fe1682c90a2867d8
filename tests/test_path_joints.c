/* Paths: what is a crossing at a joint and what is none, of one path with itself and of squares. */
#include "paths.h"

static int records_alone(const struct loaded_path *p, struct path_record *first, int overlaps)
{
    struct path_job job;
    job_of(&job, p, NULL);
    int count = job.records.count;
    assert_int_equal(job.solver.unsolved, 0);
    assert_int_equal(job.records.overlaps, overlaps);
    for (int r = 0; r < count; r++)
        assert_true(job.records.at[job.records.order[r]].standing == UNIQUE ||
                    job.records.at[job.records.order[r]].overlap >= 0);
    if (count > 0)
        *first = job.records.at[job.records.order[0]];
    path_job_clear(&job);
    return count;
}

/* f(t1) = f(t2): with f = a t^3 + b t^2 + c t that is a (t1^2 + t1 t2 + t2^2) + b (t1 + t2) + c = 0.  All
 * numbers are multiples of 3 2^-8. */
static void loop_component(struct random_state *r, real t1, real t2, real out[4])
{
    real a = 3 * (real)(double)random_between(r, -40, 40), b = 3 * (real)(double)random_between(r, -40, 40);
    real c = -(a * (t1 * t1 + t1 * t2 + t2 * t2) + b * (t1 + t2));
    out[0] = 0;
    out[1] = c / 3;
    out[2] = (2 * c + b) / 3;
    out[3] = a + b + c;
}

static void loops_of_cubics(void **state)
{
    (void)state;
    for (int run = 0; run < 25 * RUNS; run++) {
        struct random_state r = random_for(3, "loop", (uint64_t)run);
        struct path_set set = {0, 0, NULL};
        struct path_record x;
        int k1 = (int)random_between(&r, -8, 15), k2 = (int)random_between(&r, k1 + 1, 24);
        real t1 = (real)k1 / 16, t2 = (real)k2 / 16, c[8];
        loop_component(&r, t1, t2, c);
        loop_component(&r, t1, t2, c + 4);
        bool is_flat = c[1] * c[7] == c[3] * c[5] && c[1] * c[6] == c[2] * c[5];
        bool inside = k1 >= 0 && k2 <= 16, joint = k1 == 0 && k2 == 16;
        if (is_flat)
            continue;
        pieces(&set, c, 0);
        struct path_job job;
        job_of(&job, &set.at[0], NULL);
        int count = job.records.count;
        if (count > 0)
            x = job.records.at[job.records.order[0]];
        path_job_clear(&job);
        if (count != (inside && !joint))
            fail_msg("run %d, t1 = %d/16, t2 = %d/16: %d records", run, k1, k2, count);
        if (count &&
            !(is_in(&x.a, 0, t1) && is_in(&x.b, 0, t2) && (x.standing == UNIQUE || x.standing == END)))
            fail_msg("run %d, t1 = %d/16, t2 = %d/16: the record is elsewhere", run, k1, k2);
        if (inside && !joint && k1 > 0 && k2 < 16)
            for (int cuts = 1; cuts <= 2; cuts++) { /* the loop of a path */
                pieces(&set, c, cuts);
                assert_int_equal(records_alone(&set.at[cuts], &x, 0), 1);
            }
        path_set_clear(&set);
    }
}

static void corners_are_no_crossings(void **state)
{
    static const int star[] = {0, 2, 4, 1, 3, 0}, five_x[] = {0, 19, 12, -12, -19},
                     five_y[] = {20, 6, -16, -16, 6};
    const real square_x[] = {0, 1, 1, 0, 0}, square_y[] = {0, 0, 1, 1, 0};
    const real back_x[] = {0, 4, 1}, back_y[] = {0, 0, 0}, there_x[] = {0, 4, 1},
               there_y[] = {0, 0, (real)1 / 1024};
    real x[6], y[6];
    struct path_record first;
    struct path_set set = {0, 0, NULL};
    (void)state;
    for (int k = 0; k < 6; k++) {
        x[k] = five_x[star[k]];
        y[k] = five_y[star[k]];
    }
    polyline(&set, 6, x, y);
    polyline(&set, 5, square_x, square_y);
    polyline(&set, 3, back_x, back_y);
    polyline(&set, 3, there_x, there_y);
    assert_int_equal(records_alone(&set.at[0], &first, 0), 5);
    assert_int_equal(records_alone(&set.at[1], &first, 0), 0);
    assert_int_equal(records_alone(&set.at[2], &first, 1), 1);
    assert_true(first.joint && first.overlap >= 0);
    assert_int_equal(records_alone(&set.at[3], &first, 0), 0);
    path_set_clear(&set);
}

/* Two squares, the second moved so that corners, sides or nothing agree. */
static void check_squares(int dx, int dy, int crossings, int overlaps)
{
    const real x[] = {0, 4, 4, 0, 0}, y[] = {0, 0, 4, 4, 0};
    real u[5], v[5];
    struct path_set set = {0, 0, NULL};
    struct path_job job;
    int simple = 0;
    for (int k = 0; k < 5; k++) {
        u[k] = x[k] + dx;
        v[k] = y[k] + dy;
    }
    polyline(&set, 5, x, y);
    polyline(&set, 5, u, v);
    job_of(&job, &set.at[0], &set.at[1]);
    for (int r = 0; r < job.records.count; r++)
        simple += job.records.at[job.records.order[r]].overlap < 0 &&
                  job.records.at[job.records.order[r]].chain == 0;
    if (simple != crossings || job.records.overlaps != overlaps)
        fail_msg("squares apart by (%d, %d): %d crossings and %d overlaps, expected %d and %d", dx, dy,
                 simple, job.records.overlaps, crossings, overlaps);
    path_job_clear(&job);
    path_set_clear(&set);
}

static void squares(void **state)
{
    (void)state;
    check_squares(1, 1, 2, 0);
    check_squares(4, 4, 1, 0); /* corner on corner */
    check_squares(5, 0, 0, 0);
    check_squares(0, 0, 0, 4); /* one chain */
    check_squares(2, 0, 0, 2);
    check_squares(4, 0, 0, 1);
    check_squares(4, 2, 0, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loops_of_cubics),
        cmocka_unit_test(corners_are_no_crossings),
        cmocka_unit_test(squares),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
