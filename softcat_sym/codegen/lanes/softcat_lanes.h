/* Vectors whose lanes are one filament each, in the language extensions of gcc and clang: the
 * generated functions with `real` for double, and the functions of math.h on all lanes at once. */
#ifndef SOFTCAT_LANES_H
#define SOFTCAT_LANES_H

#include <math.h>

#if defined(__AVX__)
#include <immintrin.h>
#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#define LANES 8
#else
#define LANES 4
#endif

typedef double real __attribute__((vector_size(8 * LANES)));
typedef long long lanes_mask __attribute__((vector_size(8 * LANES))); /* a lane: -1 or 0 */

/* A number, or a vector, as a vector: x - 0 is x, whatever its sign. */
#define REAL(a) ((a) - (real){0.0})

static inline real lanes_choose(lanes_mask m, real a, real b)
{
    return (real)((m & (lanes_mask)a) | (~m & (lanes_mask)b));
}

static inline lanes_mask lanes_choose_integer(lanes_mask m, lanes_mask a, lanes_mask b)
{
    return (m & a) | (~m & b);
}

static inline int lanes_any(lanes_mask m)
{
#if defined(__AVX512F__) && defined(__AVX512DQ__)
    return _mm512_movepi64_mask((__m512i)m) != 0;
#elif defined(__AVX__)
    return !_mm256_testz_si256((__m256i)m, (__m256i)m);
#else
    long long found = 0;
    for (int l = 0; l < LANES; l++) found |= m[l];
    return found != 0;
#endif
}

static inline lanes_mask lanes_finite(real a)
{
    return (lanes_mask)((a - a) == 0.0);
}

static inline real lanes_fabs(real a)
{
    return (real)((lanes_mask)a & ~(lanes_mask)REAL(-0.0));
}

static inline real lanes_larger(real a, real b)
{
    return lanes_choose((lanes_mask)(a > b), a, b);
}

static inline real lanes_sqrt(real a)
{
#if defined(__AVX512F__) && defined(__AVX512DQ__)
    return (real)_mm512_sqrt_pd((__m512d)a);
#elif defined(__AVX__)
    return (real)_mm256_sqrt_pd((__m256d)a);
#else
    for (int l = 0; l < LANES; l++) a[l] = sqrt(a[l]);
    return a;
#endif
}

#endif
