/* The number type at 2,048 bits: class real, a plain value over MPFR's custom interface.
 *
 * A real stores MPFR's kind (with the sign), its exponent and its limbs; the mpfr_t header is rebuilt at each
 * operation.  So it is copied as plain bytes, is never constructed or destroyed, owns nothing, and zeroed
 * memory reads as NaN.  Every operation is rounded to nearest, ties to even, within MPFR's exponent range. */
#ifndef FATLINE_REAL_MULTI_HPP
#define FATLINE_REAL_MULTI_HPP

#include <climits>
#include <compare>
#include <concepts>
#include <cstring>
#include <type_traits>

#include <mpfr.h>

/* Integers that MPFR takes as they are. */
template <class I>
concept long_integer = std::integral<I> &&(std::signed_integral<I> || sizeof(I) < sizeof(long));

class real
{
    enum { bits = 2048, limbs = bits / GMP_NUMB_BITS };

    int kind; /* of mpfr_custom_get_kind: 0 NaN, else sign times MPFR_INF_KIND, _ZERO_KIND or _REGULAR_KIND */
    mpfr_exp_t exponent; /* of a regular number: 2^(exponent - 1) <= |value| < 2^exponent */
    mp_limb_t limb[limbs];

    bool is_regular() const
    {
        return kind == MPFR_REGULAR_KIND || kind == -MPFR_REGULAR_KIND;
    }

  public:
    /* A real as MPFR reads it, for as long as the real lives. */
    class view
    {
        mpfr_t header;

      public:
        view(const real &a)
        {
            mpfr_custom_init_set(header, a.kind, a.exponent, bits, const_cast<mp_limb_t *>(a.limb));
        }
        operator mpfr_srcptr() const
        {
            return header;
        }
    };

    /* The rounded result of an MPFR function op(rop, a..., rnd). */
    template <class Op, class... A> static real by(Op op, const A &...a)
    {
        real r;
        mpfr_t header;
        mpfr_custom_init_set(header, MPFR_ZERO_KIND, 0, bits, r.limb);
        op(header, a..., MPFR_RNDN);
        r.kind = mpfr_custom_get_kind(header);
        r.exponent = mpfr_custom_get_exp(header);
        return r;
    }
    static real power_of_two(int e)
    {
        real r;
        r.kind = MPFR_REGULAR_KIND;
        r.exponent = (mpfr_exp_t)e + 1;
        memset(r.limb, 0, sizeof r.limb);
        r.limb[limbs - 1] = (mp_limb_t)1 << (GMP_NUMB_BITS - 1);
        return r;
    }
    /* The largest finite number. */
    static real huge()
    {
        real r;
        r.kind = MPFR_REGULAR_KIND;
        r.exponent = mpfr_get_emax();
        memset(r.limb, 0xff, sizeof r.limb);
        return r;
    }

    real() = default;
    real(std::signed_integral auto a) : real(by(mpfr_set_si, (long)a))
    {
    }
    real(std::unsigned_integral auto a) : real(by(mpfr_set_ui, (unsigned long)a))
    {
    }
    real(double a) : real(by(mpfr_set_d, a))
    {
    }

    /* As C converts a double: to nearest for a floating type, towards zero for an integer. */
    template <std::floating_point T> explicit operator T() const
    {
        return (T)mpfr_get_d(view(*this), MPFR_RNDN);
    }
    template <std::integral T> explicit operator T() const
    {
        if constexpr (std::same_as<T, bool>)
            return *this != 0;
        else if constexpr (std::signed_integral<T>)
            return (T)mpfr_get_si(view(*this), MPFR_RNDZ);
        else
            return (T)mpfr_get_ui(view(*this), MPFR_RNDZ);
    }

    real operator+() const
    {
        return *this;
    }
    real operator-() const
    {
        real r = *this;
        r.kind = -kind;
        return r;
    }
    friend real operator+(const real &a, const real &b)
    {
        return by(mpfr_add, view(a), view(b));
    }
    friend real operator-(const real &a, const real &b)
    {
        return by(mpfr_sub, view(a), view(b));
    }
    friend real operator*(const real &a, const real &b)
    {
        return by(mpfr_mul, view(a), view(b));
    }
    friend real operator/(const real &a, const real &b)
    {
        return by(mpfr_div, view(a), view(b));
    }
    friend real operator*(const real &a, long_integer auto b)
    {
        return by(mpfr_mul_si, view(a), (long)b);
    }
    friend real operator*(long_integer auto a, const real &b)
    {
        return by(mpfr_mul_si, view(b), (long)a);
    }
    friend real operator/(const real &a, long_integer auto b)
    {
        return by(mpfr_div_si, view(a), (long)b);
    }
    real &operator+=(const real &b)
    {
        return *this = *this + b;
    }
    real &operator-=(const real &b)
    {
        return *this = *this - b;
    }
    real &operator*=(const real &b)
    {
        return *this = *this * b;
    }
    real &operator/=(const real &b)
    {
        return *this = *this / b;
    }

    /* C++ derives the other comparisons, and those with the number on the left, from these. */
    friend bool operator==(const real &a, const real &b)
    {
        return mpfr_equal_p(view(a), view(b));
    }
    friend std::partial_ordering operator<=>(const real &a, const real &b)
    {
        if (!a.kind || !b.kind)
            return std::partial_ordering::unordered;
        return mpfr_cmp(view(a), view(b)) <=> 0;
    }
    friend bool operator==(const real &a, long_integer auto b)
    {
        return a.kind && mpfr_cmp_si(view(a), (long)b) == 0;
    }
    friend std::partial_ordering operator<=>(const real &a, long_integer auto b)
    {
        if (!a.kind)
            return std::partial_ordering::unordered;
        return mpfr_cmp_si(view(a), (long)b) <=> 0;
    }

    friend real real_ldexp(const real &a, int e)
    {
        if (!a.is_regular())
            return a;
        mpfr_exp_t moved = a.exponent + e;
        if (moved < mpfr_get_emin() || moved > mpfr_get_emax())
            return by(mpfr_mul_2si, view(a), (long)e);
        real r = a;
        r.exponent = moved;
        return r;
    }
    /* e with 2^(e-1) <= |a| < 2^e; a is finite and not 0. */
    friend int real_exponent(const real &a)
    {
        return (int)a.exponent;
    }
    friend int real_is_finite(const real &a)
    {
        return a.is_regular() || a.kind == MPFR_ZERO_KIND || a.kind == -MPFR_ZERO_KIND;
    }
};

static_assert(std::is_trivial_v<real> && std::is_standard_layout_v<real>);

static inline real real_abs(const real &a)
{
    return a < 0 ? -a : a;
}
static inline real real_sqrt(const real &a)
{
    return real::by(mpfr_sqrt, real::view(a));
}
static inline double real_to_double(const real &a)
{
    return (double)a;
}
/* Found by argument-dependent lookup for reals; declared here also for plain numbers. */
real real_ldexp(const real &a, int e);
int real_exponent(const real &a);
int real_is_finite(const real &a);

#define REAL_EPSILON (real::power_of_two(-2047))
#define REAL_HUGE (real::huge())
#define REAL_LEAST (real::power_of_two(-(1 << 29)))

#endif
