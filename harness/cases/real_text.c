#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../../algorithms/core/real.h"
#include "number.h"

#if defined(FATLINE_MULTI)

real real_from_rational(const mpq_t q)
{
    return real::by(mpfr_set_q, q);
}

void real_to_rational(real a, mpq_t q)
{
    mpfr_get_q(q, real::view(a));
}

void real_text(real a, char *text, size_t size)
{
    mpfr_snprintf(text, size, "%Ra", (mpfr_srcptr)real::view(a));
}

/* A hex float, which may lie beyond the exponents of number_parse. */
static bool read_hex(const char *text, real *a)
{
    const char *digits = text + (*text == '-' || *text == '+');
    char *end = NULL;
    real value;

    if (digits[0] != '0' || tolower((unsigned char)digits[1]) != 'x' || strpbrk(digits, "@ "))
        return false;
    value = real::by([&](mpfr_ptr r, mpfr_rnd_t rnd) { return mpfr_strtofr(r, text, &end, 16, rnd); });
    if (*end || !real_is_finite(value))
        return false;
    *a = value;
    return true;
}

#elif defined(FATLINE_QUAD)

real real_from_rational(const mpq_t q)
{
    mpz_t m, high;
    long e;
    int sign;
    real a;

    mpz_init(m);
    mpz_init(high);
    number_round(q, FLT128_MANT_DIG, FLT128_MIN_EXP - FLT128_MANT_DIG, m, &e);
    sign = mpz_sgn(m);
    mpz_abs(m, m);
    mpz_fdiv_q_2exp(high, m, 64);
    mpz_fdiv_r_2exp(m, m, 64);
    a = (real)mpz_get_ui(high) * 0x1p64 + mpz_get_ui(m);
    mpz_clear(m);
    mpz_clear(high);
    return sign * (e > FLT128_MAX_EXP ? HUGE_VALQ : ldexpq(a, (int)e));
}

void real_to_rational(real a, mpq_t q)
{
    int e;
    real m = ldexpq(frexpq(fabsq(a), &e), FLT128_MANT_DIG);
    unsigned long high = (unsigned long)(m * 0x1p-64Q);

    mpq_set_ui(q, high, 1);
    mpz_mul_2exp(mpq_numref(q), mpq_numref(q), 64);
    mpz_add_ui(mpq_numref(q), mpq_numref(q), (unsigned long)(m - (real)high * 0x1p64Q));
    if (a < 0)
        mpq_neg(q, q);
    number_scale(q, (long)e - FLT128_MANT_DIG);
}

void real_text(real a, char *text, size_t size)
{
    quadmath_snprintf(text, size, "%Qa", a);
}

#else

real real_from_rational(const mpq_t q)
{
    return number_to_double(q);
}

void real_to_rational(real a, mpq_t q)
{
    mpq_set_d(q, a);
}

void real_text(real a, char *text, size_t size)
{
    number_text_double(a, text, size);
}

#endif

void real_write(FILE *stream, real a)
{
    const char *quote = REAL_BITS > 53 ? "\"" : "";
    char text[REAL_TEXT_MAX];

    if (!real_is_finite(a)) {
        fputs("null", stream);
        return;
    }
    real_text(a, text, sizeof text);
    fprintf(stream, "%s%s%s", quote, text, quote);
}

bool real_parse(const char *text, real *a)
{
    mpq_t q;
    bool good;

#if defined(FATLINE_MULTI)
    if (read_hex(text, a))
        return true;
#endif
    mpq_init(q);
    good = number_parse(text, q);
    if (good) {
        real value = real_from_rational(q);
        good = real_is_finite(value);
        if (good)
            *a = value == 0 && *text == '-' ? -value : value;
    }
    mpq_clear(q);
    return good;
}
