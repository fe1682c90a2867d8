/* Sums of `fatline check`, a line for each class and algorithm.  Compiled for each precision. */
#ifndef FATLINE_CHECK_TABLE_H
#define FATLINE_CHECK_TABLE_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

enum { TABLE_COLUMNS = 13 };

struct table_line {
    char *class_name, *algorithm;
    bool ambiguous;
    long sum[TABLE_COLUMNS], violated;
    double max_error; /* -1: nothing was found */
};

/* Zeroed: empty. */
struct check_table {
    int count, room;
    bool strict; /* a column `violated` */
    struct table_line *at;
};

void check_table_add(struct check_table *t, const json_t *row); /* a row of `check --rows` */
void check_table_write(const struct check_table *t, FILE *stream);
/* Something missed, extra or violated in a case that is not ambiguous, or an answer broken in any. */
bool check_table_failed(const struct check_table *t);
long check_table_unjudged(const struct check_table *t);
void check_table_clear(struct check_table *t);

#endif
