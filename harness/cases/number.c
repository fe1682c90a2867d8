#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"

static int digit_value(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return 16;
}

/* Digits of the base, with at most one point if places != NULL (which then counts those behind it), into m.
 * The text behind them, or NULL if there is no digit. */
static const char *read_digits(const char *text, int base, mpz_t m, long *places)
{
    int digits = 0;
    bool point = false;

    mpz_set_ui(m, 0);
    if (places)
        *places = 0;
    for (; digit_value(*text) < base || (*text == '.' && places && !point); text++) {
        if (*text == '.') {
            point = true;
            continue;
        }
        mpz_mul_ui(m, m, base);
        mpz_add_ui(m, m, digit_value(*text));
        digits++;
        if (point)
            ++*places;
    }
    return digits ? text : NULL;
}

/* An optional exponent after `letter`, at most max in magnitude.  The text behind it, or NULL. */
static const char *read_exponent(const char *text, char letter, long max, long *e)
{
    bool negative;

    *e = 0;
    if (tolower((unsigned char)*text) != letter)
        return text;
    text++;
    negative = *text == '-';
    if (*text == '-' || *text == '+')
        text++;
    if (digit_value(*text) > 9)
        return NULL;
    for (; digit_value(*text) <= 9; text++) {
        *e = 10 * *e + digit_value(*text);
        if (*e > max)
            return NULL;
    }
    if (negative)
        *e = -*e;
    return text;
}

static bool parse_hex(const char *text, mpq_t q)
{
    long places, e;

    text = read_digits(text, 16, mpq_numref(q), &places);
    if (!text || !(text = read_exponent(text, 'p', NUMBER_EXPONENT_2, &e)) || *text)
        return false;
    mpz_set_ui(mpq_denref(q), 1);
    number_scale(q, e - 4 * places);
    return true;
}

static bool parse_fraction(const char *text, mpq_t q)
{
    text = read_digits(text, 10, mpq_numref(q), NULL);
    if (!text || *text != '/')
        return false;
    text = read_digits(text + 1, 10, mpq_denref(q), NULL);
    if (!text || *text || mpz_sgn(mpq_denref(q)) == 0)
        return false;
    mpq_canonicalize(q);
    return true;
}

/* False if the nearest float32 is infinite. */
static bool round_to_float32(mpq_t q)
{
    long e;

    number_round(q, FLT_MANT_DIG, FLT_MIN_EXP - FLT_MANT_DIG, mpq_numref(q), &e);
    mpz_set_ui(mpq_denref(q), 1);
    if (mpz_sgn(mpq_numref(q)) && (long)mpz_sizeinbase(mpq_numref(q), 2) + e > FLT_MAX_EXP)
        return false;
    number_scale(q, e);
    return true;
}

static bool parse_decimal(const char *text, mpq_t q)
{
    long places, e;
    mpz_t power;

    text = read_digits(text, 10, mpq_numref(q), &places);
    if (!text || !(text = read_exponent(text, 'e', NUMBER_EXPONENT_10, &e)))
        return false;
    mpz_set_ui(mpq_denref(q), 1);
    e -= places;
    mpz_init(power);
    mpz_ui_pow_ui(power, 10, labs(e));
    if (e < 0)
        mpz_set(mpq_denref(q), power);
    else
        mpz_mul(mpq_numref(q), mpq_numref(q), power);
    mpz_clear(power);
    mpq_canonicalize(q);
    if (*text == 'f' || *text == 'F')
        return !text[1] && round_to_float32(q);
    return !*text;
}

bool number_parse(const char *text, mpq_t q)
{
    bool negative = *text == '-', good;
    mpq_t value;

    if (strlen(text) > NUMBER_LENGTH_MAX)
        return false;
    if (*text == '-' || *text == '+')
        text++;
    mpq_init(value);
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X'))
        good = parse_hex(text + 2, value);
    else if (strchr(text, '/'))
        good = parse_fraction(text, value);
    else
        good = parse_decimal(text, value);
    if (good) {
        if (negative)
            mpq_neg(value, value);
        mpq_swap(q, value);
    }
    mpq_clear(value);
    return good;
}

void number_text_double(double a, char *text, size_t size)
{
    /* A normal double that some decimal of at most 15 digits denotes is printed as that decimal by %.15g. */
    int digits = fabs(a) < DBL_MIN ? 1 : DBL_DIG;

    if (a == 0) {
        snprintf(text, size, signbit(a) ? "-0.0" : "0");
        return;
    }
    do
        snprintf(text, size, "%.*g", digits, a);
    while (digits++ < DBL_DECIMAL_DIG && strtod(text, NULL) != a);
}

double number_to_double(const mpq_t q)
{
    mpz_t m;
    long e;
    double a;

    mpz_init(m);
    number_round(q, DBL_MANT_DIG, DBL_MIN_EXP - DBL_MANT_DIG, m, &e);
    a = e > DBL_MAX_EXP ? mpz_sgn(m) * HUGE_VAL : ldexp(mpz_get_d(m), (int)e);
    mpz_clear(m);
    return a;
}

void number_round(const mpq_t q, int bits, long exponent_min, mpz_t m, long *e)
{
    mpz_t rest, divisor, limit;
    int sign = mpq_sgn(q), half;

    mpz_init(rest);
    mpz_init_set(divisor, mpq_denref(q));
    mpz_init(limit);
    mpz_abs(rest, mpq_numref(q));
    *e = (long)mpz_sizeinbase(rest, 2) - (long)mpz_sizeinbase(divisor, 2) - bits;
    if (*e < exponent_min)
        *e = exponent_min;
    if (*e < 0)
        mpz_mul_2exp(rest, rest, -*e);
    else
        mpz_mul_2exp(divisor, divisor, *e);
    /* Now |q| / 2^e < 2^(bits + 1), and above 2^(bits - 1) unless e = exponent_min. */
    mpz_mul_2exp(limit, divisor, bits);
    if (mpz_cmp(rest, limit) >= 0) {
        mpz_mul_2exp(divisor, divisor, 1);
        ++*e;
    }
    mpz_fdiv_qr(m, rest, rest, divisor);
    mpz_mul_2exp(rest, rest, 1);
    half = mpz_cmp(rest, divisor);
    if (half > 0 || (half == 0 && mpz_odd_p(m)))
        mpz_add_ui(m, m, 1);
    if (sign < 0)
        mpz_neg(m, m);
    mpz_clear(rest);
    mpz_clear(divisor);
    mpz_clear(limit);
}

void number_scale(mpq_t q, long e)
{
    if (e < 0)
        mpq_div_2exp(q, q, -e);
    else
        mpq_mul_2exp(q, q, e);
}
