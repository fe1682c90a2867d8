#include <math.h>

#include "place.h"
#include "../../algorithms/core/bernstein.h"
#include "number.h"

void place_at(const struct curve *f, real t, real *x, real *y)
{
    real local = (t - f->domain.lo) / (f->domain.hi - f->domain.lo);
    local = real_max((real)0, real_min((real)1, local));
    real w = f->w ? bernstein_value(f->degree, f->w, local) : (real)1;
    *x = bernstein_value(f->degree, f->x, local) / w;
    *y = bernstein_value(f->degree, f->y, local) / w;
}

static void write_double(FILE *stream, real a)
{
    char text[64] = "null";
    if (isfinite(real_to_double(a)))
        number_text_double(real_to_double(a), text, sizeof text);
    fputs(text, stream);
}

void place_write(FILE *stream, const struct curve *f, real t)
{
    real x, y;
    place_at(f, t, &x, &y);
    fputs(",\"point\":[", stream);
    write_double(stream, x);
    fputc(',', stream);
    write_double(stream, y);
    fputc(']', stream);
}
