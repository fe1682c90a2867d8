/* Cases of a family, as `fatline generate` makes them. */
#ifndef FATLINE_TESTS_GENERATED_H
#define FATLINE_TESTS_GENERATED_H

#include <stdio.h>
#include <string.h>

#include "prop.h"
#include "../harness/cases/case.h"

static char generator[4096]; /* the program; found from argv[0] */

static inline void generator_find(const char *self)
{
    const char *slash = strrchr(self, '/');
    snprintf(generator, sizeof generator, "%.*s/../../double/fatline-generate",
             slash ? (int)(slash - self) : 1, slash ? self : ".");
}

/* Calls `each` for every case; returns how many there were, at least one. */
static inline int generated_each(const char *family, const char *options,
                                 void (*each)(struct test_case *c, void *context), void *context)
{
    struct case_reader reader;
    struct test_case c;
    char command[sizeof generator + 256];
    int cases = 0;
    snprintf(command, sizeof command, "'%s' %s %s", generator, family, options);
    FILE *stream = popen(command, "r");
    assert_non_null(stream);
    case_reader_init(&reader, stream, family);
    for (; case_read(&reader, &c) == CASE_READ; cases++) {
        each(&c, context);
        case_clear(&c);
    }
    case_reader_clear(&reader);
    assert_int_equal(pclose(stream), 0);
    assert_true(cases > 0);
    return cases;
}

#endif
