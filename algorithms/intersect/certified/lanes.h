/* Several doubles at once, by one set of names for two widths: LANES is 8 (AVX-512) or 4 (AVX2), defined by
 * who includes this.
 *
 * `wide` has LANES doubles, on which + - * / work as they are; `wide_mask` a truth value for each, on which &
 * | ~ do.  Every function of such a file bears LANES_TARGET, so that it is compiled for these instructions
 * whatever the rest is compiled for.  Rounding is to nearest; wide_fma rounds once. */
#ifndef FATLINE_LANES_H
#define FATLINE_LANES_H

#include <immintrin.h>
#include <stdint.h>

#if LANES == 8
#define LANES_TARGET __attribute__((target("avx2,fma,avx512f,avx512dq,avx512vl")))
#define wide __m512d
#define wide_mask unsigned
#else
#define LANES_TARGET __attribute__((target("avx2,fma")))
#define wide __m256d
#define wide_mask __m256i
#endif
#define LANES_INLINE static inline LANES_TARGET __attribute__((always_inline))

#if LANES == 8

LANES_INLINE wide wide_of(double a)
{
    return _mm512_set1_pd(a);
}
LANES_INLINE wide wide_load(const double *a)
{
    return _mm512_loadu_pd(a);
}
LANES_INLINE void wide_store(double *to, wide a)
{
    _mm512_storeu_pd(to, a);
}
LANES_INLINE wide wide_min(wide a, wide b)
{
    return _mm512_min_pd(a, b);
}
LANES_INLINE wide wide_max(wide a, wide b)
{
    return _mm512_max_pd(a, b);
}
LANES_INLINE wide wide_abs(wide a)
{
    return _mm512_abs_pd(a);
}
/* a b + c; c - a b; a b - c */
LANES_INLINE wide wide_fma(wide a, wide b, wide c)
{
    return _mm512_fmadd_pd(a, b, c);
}
LANES_INLINE wide wide_fnma(wide a, wide b, wide c)
{
    return _mm512_fnmadd_pd(a, b, c);
}
LANES_INLINE wide wide_fms(wide a, wide b, wide c)
{
    return _mm512_fmsub_pd(a, b, c);
}
/* False where one is not a number. */
LANES_INLINE wide_mask wide_less(wide a, wide b)
{
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
LANES_INLINE wide wide_select(wide_mask m, wide yes, wide no)
{
    return _mm512_mask_blend_pd((__mmask8)m, no, yes);
}
/* Bit i for lane i. */
LANES_INLINE unsigned wide_bits(wide_mask m)
{
    return m & 0xff;
}
LANES_INLINE wide_mask wide_first(int count)
{
    return count >= LANES ? 0xffu : count > 0 ? (1u << count) - 1 : 0;
}
/* The lanes of m, one after the other; the rest is anything. */
LANES_INLINE wide wide_pack(wide_mask m, wide a)
{
    return _mm512_maskz_compress_pd((__mmask8)m, a);
}
/* 1 / a to some 14 bits, or better. */
LANES_INLINE wide wide_inverse_about(wide a)
{
    return _mm512_rcp14_pd(a);
}
/* Lanes 0 2 4 .. and 1 3 5 .. of a and b, in turn. */
LANES_INLINE wide wide_evens(wide a, wide b)
{
    return _mm512_unpacklo_pd(a, b);
}
LANES_INLINE wide wide_odds(wide a, wide b)
{
    return _mm512_unpackhi_pd(a, b);
}
LANES_INLINE wide wide_gather(const double *base, wide index)
{
    return _mm512_i32gather_pd(_mm512_cvttpd_epi32(index), base, 8);
}

LANES_INLINE wide wide_load_whole(const int *a)
{
    return _mm512_cvtepi32_pd(_mm256_loadu_si256((const __m256i *)(const void *)a));
}
LANES_INLINE void wide_store_whole(int *to, wide a)
{
    _mm256_storeu_si256((__m256i *)(void *)to, _mm512_cvttpd_epi32(a));
}

/* out[i] has number i of each row. */
LANES_INLINE void wide_transpose(const double *const row[LANES], wide out[8])
{
    wide r0 = wide_load(row[0]), r1 = wide_load(row[1]), r2 = wide_load(row[2]), r3 = wide_load(row[3]);
    wide r4 = wide_load(row[4]), r5 = wide_load(row[5]), r6 = wide_load(row[6]), r7 = wide_load(row[7]);
    /* numbers 0 2 4 6 and 1 3 5 7 of two rows */
    wide e01 = _mm512_unpacklo_pd(r0, r1), o01 = _mm512_unpackhi_pd(r0, r1);
    wide e23 = _mm512_unpacklo_pd(r2, r3), o23 = _mm512_unpackhi_pd(r2, r3);
    wide e45 = _mm512_unpacklo_pd(r4, r5), o45 = _mm512_unpackhi_pd(r4, r5);
    wide e67 = _mm512_unpacklo_pd(r6, r7), o67 = _mm512_unpackhi_pd(r6, r7);
    /* numbers 0 4 and 2 6, 1 5 and 3 7 of four */
    wide a = _mm512_shuffle_f64x2(e01, e23, 0x88), b = _mm512_shuffle_f64x2(e45, e67, 0x88);
    wide c = _mm512_shuffle_f64x2(e01, e23, 0xdd), d = _mm512_shuffle_f64x2(e45, e67, 0xdd);
    out[0] = _mm512_shuffle_f64x2(a, b, 0x88);
    out[4] = _mm512_shuffle_f64x2(a, b, 0xdd);
    out[2] = _mm512_shuffle_f64x2(c, d, 0x88);
    out[6] = _mm512_shuffle_f64x2(c, d, 0xdd);
    a = _mm512_shuffle_f64x2(o01, o23, 0x88);
    b = _mm512_shuffle_f64x2(o45, o67, 0x88);
    c = _mm512_shuffle_f64x2(o01, o23, 0xdd);
    d = _mm512_shuffle_f64x2(o45, o67, 0xdd);
    out[1] = _mm512_shuffle_f64x2(a, b, 0x88);
    out[5] = _mm512_shuffle_f64x2(a, b, 0xdd);
    out[3] = _mm512_shuffle_f64x2(c, d, 0x88);
    out[7] = _mm512_shuffle_f64x2(c, d, 0xdd);
}

#else

LANES_INLINE wide wide_of(double a)
{
    return _mm256_set1_pd(a);
}
LANES_INLINE wide wide_load(const double *a)
{
    return _mm256_loadu_pd(a);
}
LANES_INLINE void wide_store(double *to, wide a)
{
    _mm256_storeu_pd(to, a);
}
LANES_INLINE wide wide_min(wide a, wide b)
{
    return _mm256_min_pd(a, b);
}
LANES_INLINE wide wide_max(wide a, wide b)
{
    return _mm256_max_pd(a, b);
}
LANES_INLINE wide wide_abs(wide a)
{
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
}
LANES_INLINE wide wide_fma(wide a, wide b, wide c)
{
    return _mm256_fmadd_pd(a, b, c);
}
LANES_INLINE wide wide_fnma(wide a, wide b, wide c)
{
    return _mm256_fnmadd_pd(a, b, c);
}
LANES_INLINE wide wide_fms(wide a, wide b, wide c)
{
    return _mm256_fmsub_pd(a, b, c);
}
LANES_INLINE wide_mask wide_less(wide a, wide b)
{
    return _mm256_castpd_si256(_mm256_cmp_pd(a, b, _CMP_LT_OQ));
}
LANES_INLINE wide wide_select(wide_mask m, wide yes, wide no)
{
    return _mm256_blendv_pd(no, yes, _mm256_castsi256_pd(m));
}
LANES_INLINE unsigned wide_bits(wide_mask m)
{
    return (unsigned)_mm256_movemask_pd(_mm256_castsi256_pd(m));
}
LANES_INLINE wide_mask wide_first(int count)
{
    return _mm256_cmpgt_epi64(_mm256_set1_epi64x(count), _mm256_setr_epi64x(0, 1, 2, 3));
}
LANES_INLINE wide wide_pack(wide_mask m, wide a)
{
    /* of mask b: lane i comes from lane (order >> 2 i) & 3 */
    static const unsigned char order[16] = {0x00, 0x00, 0x01, 0x04, 0x02, 0x08, 0x09, 0x24,
                                            0x03, 0x0c, 0x0d, 0x34, 0x0e, 0x38, 0x39, 0xe4};
    long long from = order[wide_bits(m)];
    __m256i lane = _mm256_and_si256(
        _mm256_srlv_epi64(_mm256_set1_epi64x(from), _mm256_setr_epi64x(0, 2, 4, 6)), _mm256_set1_epi64x(3));
    __m256i low = _mm256_slli_epi64(lane, 1), high = _mm256_add_epi64(low, _mm256_set1_epi64x(1));
    __m256i halves = _mm256_or_si256(low, _mm256_slli_epi64(high, 32));
    return _mm256_castsi256_pd(_mm256_permutevar8x32_epi32(_mm256_castpd_si256(a), halves));
}
LANES_INLINE wide wide_inverse_about(wide a)
{
    return 1.0 / a;
}
LANES_INLINE wide wide_evens(wide a, wide b)
{
    return _mm256_unpacklo_pd(a, b);
}
LANES_INLINE wide wide_odds(wide a, wide b)
{
    return _mm256_unpackhi_pd(a, b);
}
LANES_INLINE wide wide_gather(const double *base, wide index)
{
    return _mm256_i32gather_pd(base, _mm256_cvttpd_epi32(index), 8);
}

LANES_INLINE wide wide_load_whole(const int *a)
{
    return _mm256_cvtepi32_pd(_mm_loadu_si128((const __m128i *)(const void *)a));
}
LANES_INLINE void wide_store_whole(int *to, wide a)
{
    _mm_storeu_si128((__m128i *)(void *)to, _mm256_cvttpd_epi32(a));
}

LANES_INLINE void transpose_four(const double *const row[LANES], int from, wide out[4])
{
    wide a = wide_load(row[0] + from), b = wide_load(row[1] + from), c = wide_load(row[2] + from),
         d = wide_load(row[3] + from);
    wide ab = _mm256_unpacklo_pd(a, b), cd = _mm256_unpacklo_pd(c, d);
    out[0] = _mm256_permute2f128_pd(ab, cd, 0x20);
    out[2] = _mm256_permute2f128_pd(ab, cd, 0x31);
    ab = _mm256_unpackhi_pd(a, b);
    cd = _mm256_unpackhi_pd(c, d);
    out[1] = _mm256_permute2f128_pd(ab, cd, 0x20);
    out[3] = _mm256_permute2f128_pd(ab, cd, 0x31);
}
LANES_INLINE void wide_transpose(const double *const row[LANES], wide out[8])
{
    transpose_four(row, 0, out);
    transpose_four(row, 4, out + 4);
}

#endif

/* Of 2^d (1 + a), 0 <= a < 1, d >= 0: a, 2^d and 2^-d, exactly. */
LANES_INLINE wide code_times(wide code)
{
#if LANES == 8
    return _mm512_and_pd(code, _mm512_castsi512_pd(_mm512_set1_epi64(0x7ff0000000000000LL)));
#else
    return _mm256_and_pd(code, _mm256_castsi256_pd(_mm256_set1_epi64x(0x7ff0000000000000LL)));
#endif
}
LANES_INLINE wide code_start(wide code)
{
#if LANES == 8
    return _mm512_getmant_pd(code, _MM_MANT_NORM_1_2, _MM_MANT_SIGN_zero) - 1.0;
#else
    const __m256i digits = _mm256_set1_epi64x(0x000fffffffffffffLL),
                  one = _mm256_set1_epi64x(0x3ff0000000000000LL);
    return _mm256_castsi256_pd((_mm256_castpd_si256(code) & digits) | one) - 1.0;
#endif
}
LANES_INLINE wide code_width(wide code)
{
#if LANES == 8
    const __m512i exponent = _mm512_set1_epi64(0x7ff0000000000000LL),
                  twice = _mm512_set1_epi64(0x7fe0000000000000LL);
    return _mm512_castsi512_pd(
        _mm512_sub_epi64(twice, _mm512_and_si512(_mm512_castpd_si512(code), exponent)));
#else
    const __m256i exponent = _mm256_set1_epi64x(0x7ff0000000000000LL),
                  twice = _mm256_set1_epi64x(0x7fe0000000000000LL);
    return _mm256_castsi256_pd(_mm256_sub_epi64(twice, _mm256_castpd_si256(code) & exponent));
#endif
}

#endif
