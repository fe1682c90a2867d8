/* The line of a generated case; its grammar is in datasets/README.md. */
#include <stdlib.h>
#include <string.h>

#include "family.h"
#include "../cases/number.h"

static void put_exact(FILE *stream, const fmpq_t a)
{
    char *text = fmpq_get_str(NULL, 10, a);
    fprintf(stream, "\"%s\"", text);
    flint_free(text);
}

/* Draft coordinates are doubles exactly, unless the draft is beyond them; parameters are rounded. */
static void put_double(FILE *stream, const fmpq_t a)
{
    char text[64];
    mpq_t q;
    mpq_init(q);
    fmpq_get_mpq(q, a);
    number_text_double(number_to_double(q), text, sizeof text);
    fputs(text, stream);
    mpq_clear(q);
}

static void put_pairs(FILE *stream, const char *name, const struct points *p,
                      void (*put)(FILE *, const fmpq_t))
{
    fprintf(stream, ", \"%s\": [", name);
    for (int i = 0; i <= p->degree; i++) {
        fputs(i ? ", [" : "[", stream);
        put(stream, p->x[i]);
        fputs(", ", stream);
        put(stream, p->y[i]);
        fputc(']', stream);
    }
    fputc(']', stream);
}

static void put_weights(FILE *stream, const char *name, const struct points *p,
                        void (*put)(FILE *, const fmpq_t))
{
    fprintf(stream, ", \"%s\": [", name);
    for (int i = 0; i <= p->degree; i++) {
        fputs(i ? ", " : "", stream);
        put(stream, p->w[i]);
    }
    fputc(']', stream);
}

static void put_curve(FILE *stream, const char *name, const struct points *p, bool doubles)
{
    fprintf(stream, ", \"%s\": {\"degree\": %d", name, p->degree);
    put_pairs(stream, "points", p, put_exact);
    if (p->rational)
        put_weights(stream, "weights", p, put_exact);
    if (doubles)
        put_pairs(stream, "f64", p, put_double);
    if (doubles && p->rational)
        put_weights(stream, "w64", p, put_double);
    fputc('}', stream);
}

static void put_planted(FILE *stream, const struct draft *d)
{
    fputs(", \"planted\": [", stream);
    for (int i = 0; i < d->planted; i++) {
        fputs(i ? ", {\"t\": " : "{\"t\": ", stream);
        put_exact(stream, d->at[i].t);
        fputs(", \"s\": ", stream);
        put_exact(stream, d->at[i].s);
        if (d->at[i].multiplicity)
            fprintf(stream, ", \"mult\": %d", d->at[i].multiplicity);
        fputc('}', stream);
    }
    fputc(']', stream);
}

static void put_list(FILE *stream, const char *name, const struct draft *d, void (*put)(FILE *, const fmpq_t))
{
    fprintf(stream, ", \"%s\": [", name);
    for (int i = 0; i < d->planted; i++) {
        fputs(i ? ", [" : "[", stream);
        put(stream, d->at[i].t);
        fputs(", ", stream);
        put(stream, d->at[i].s);
        fputc(']', stream);
    }
    fputc(']', stream);
}

/* Solutions are planted in increasing order of t. */
static void put_expected(FILE *stream, const struct draft *d)
{
    fprintf(stream, ", \"expected\": {\"count\": %d", d->planted);
    put_list(stream, "params", d, put_double);
    put_list(stream, "exact", d, put_exact);
    fputs(", \"mult\": [", stream);
    for (int i = 0; i < d->planted; i++)
        fprintf(stream, "%s%d", i ? ", " : "", d->at[i].multiplicity);
    fputs("]}", stream);
}

static void put_overlap(FILE *stream, const struct draft *d)
{
    fputs(", \"planted_overlap\": [", stream);
    for (int k = 0; k < 4; k++) {
        fputs(k ? ", " : "", stream);
        put_exact(stream, d->overlap[k]);
    }
    fputc(']', stream);
}

void family_write(FILE *stream, const struct draft *d, const char *family, uint64_t seed, uint64_t index)
{
    fprintf(stream, "{\"id\": \"%s-%dx%d-%llu-%llu\", \"family\": \"%s\"", family, d->f.degree, d->g.degree,
            (unsigned long long)seed, (unsigned long long)index, family);
    fprintf(stream, ", \"source\": \"generated, seed %llu\"", (unsigned long long)seed);
    if (d->note[0])
        fprintf(stream, ", \"note\": \"%s\"", d->note);
    if (d->class_name[0])
        fprintf(stream, ", \"class\": \"%s\"", d->class_name);
    put_curve(stream, "f", &d->f, !d->beyond);
    put_curve(stream, "g", &d->g, !d->beyond);
    if (d->planted)
        put_planted(stream, d);
    if (d->overlaps)
        put_overlap(stream, d);
    if (d->count >= 0)
        fprintf(stream, ", \"planted_count\": %d", d->count);
    if (!fmpq_is_zero(d->gap)) {
        fputs(", \"gap\": ", stream);
        put_exact(stream, d->gap);
        fputs(", \"contact\": [", stream);
        put_exact(stream, d->at[0].t);
        fputs(", ", stream);
        put_exact(stream, d->at[0].s);
        fputc(']', stream);
    }
    if (d->complete)
        put_expected(stream, d);
    fputs("}\n", stream);
}
