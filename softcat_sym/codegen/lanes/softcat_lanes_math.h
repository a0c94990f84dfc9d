/* What the text of a generated function means where its numbers are vectors of lanes. */
#ifndef SOFTCAT_LANES_MATH_H
#define SOFTCAT_LANES_MATH_H

#include "softcat_lanes_model.h"

/* Numbers stand for vectors of equal lanes wherever a function is called. */
#define truth(m) lanes_truth((lanes_mask)(m))
#define where(a, b) lanes_choose((lanes_mask)(REAL(a) != 0.0), REAL(b), REAL(0.0))
#define smaller(a, b) lanes_smaller(REAL(a), REAL(b))
#define larger(a, b) lanes_larger(REAL(a), REAL(b))
#define fabs(a) lanes_fabs(REAL(a))
#define sqrt(a) lanes_sqrt(REAL(a))
#define squared(a) lanes_squared(REAL(a))
#define sign_of(a) lanes_sign(REAL(a))
#define angle_of(y, x) lanes_atan2(REAL(y), REAL(x))

static inline real lanes_truth(lanes_mask m)
{
    return (real)(m & (lanes_mask)REAL(1.0));
}

static inline real lanes_smaller(real a, real b)
{
    return lanes_choose((lanes_mask)(a < b), a, b);
}

static inline real lanes_squared(real a)
{
    return a * a;
}

static inline real lanes_sign(real a)
{
    real below = lanes_choose((lanes_mask)(a < 0.0), REAL(-1.0), a);
    return lanes_choose((lanes_mask)(a > 0.0), REAL(1.0), below);
}

/* Lane by lane, for what the C library has no vectors of. */
#define LANES_ONE(name)                                                                            \
    static inline real lanes_##name(real a)                                                        \
    {                                                                                              \
        for (int l = 0; l < LANES; l++) a[l] = (name)(a[l]);                                       \
        return a;                                                                                  \
    }
#define LANES_TWO(name)                                                                            \
    static inline real lanes_##name(real a, real b)                                                \
    {                                                                                              \
        for (int l = 0; l < LANES; l++) a[l] = (name)(a[l], b[l]);                                 \
        return a;                                                                                  \
    }

/* glibc has vectors of these since 2.35, in libmvec, to four units in the last place. */
#if defined(__x86_64__) && defined(__AVX2__) && defined(__GLIBC__) && __GLIBC_PREREQ(2, 35)
#if LANES == 8
#define LANES_LIBRARY(kind, name) _ZGVeN8##kind##_##name
#else
#define LANES_LIBRARY(kind, name) _ZGVdN4##kind##_##name
#endif
#define LANES_FAST_ONE(name)                                                                       \
    real LANES_LIBRARY(v, name)(real);                                                             \
    static inline real lanes_##name(real a) { return LANES_LIBRARY(v, name)(a); }
#define LANES_FAST_TWO(name)                                                                       \
    real LANES_LIBRARY(vv, name)(real, real);                                                      \
    static inline real lanes_##name(real a, real b) { return LANES_LIBRARY(vv, name)(a, b); }
#else
#define LANES_FAST_ONE LANES_ONE
#define LANES_FAST_TWO LANES_TWO
#endif

LANES_FAST_ONE(exp)
LANES_FAST_ONE(log)
LANES_FAST_ONE(sin)
LANES_FAST_ONE(cos)
LANES_FAST_ONE(tan)
LANES_FAST_ONE(asin)
LANES_FAST_ONE(acos)
LANES_FAST_ONE(atan)
LANES_FAST_ONE(sinh)
LANES_FAST_ONE(cosh)
LANES_FAST_ONE(tanh)
LANES_FAST_ONE(log1p)
LANES_FAST_ONE(expm1)
LANES_FAST_TWO(pow)
LANES_FAST_TWO(atan2)
LANES_FAST_TWO(hypot)
LANES_TWO(copysign)

#define exp(a) lanes_exp(REAL(a))
#define log(a) lanes_log(REAL(a))
#define sin(a) lanes_sin(REAL(a))
#define cos(a) lanes_cos(REAL(a))
#define tan(a) lanes_tan(REAL(a))
#define asin(a) lanes_asin(REAL(a))
#define acos(a) lanes_acos(REAL(a))
#define atan(a) lanes_atan(REAL(a))
#define sinh(a) lanes_sinh(REAL(a))
#define cosh(a) lanes_cosh(REAL(a))
#define tanh(a) lanes_tanh(REAL(a))
#define log1p(a) lanes_log1p(REAL(a))
#define expm1(a) lanes_expm1(REAL(a))
#define pow(a, b) lanes_pow(REAL(a), REAL(b))
#define hypot(a, b) lanes_hypot(REAL(a), REAL(b))
#define copysign(a, b) lanes_copysign(REAL(a), REAL(b))

#endif
