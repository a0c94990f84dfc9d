/* Of C's mathematics what the solver calls, where there is no library of C. */
#ifndef STUB_MATH_H
#define STUB_MATH_H
#define NAN __builtin_nan("")
#define INFINITY __builtin_inf()
#define HUGE_VAL __builtin_huge_val()
#define isnan(x) __builtin_isnan(x)
#define isfinite(x) __builtin_isfinite(x)
double acos(double), asin(double), atan(double), atan2(double, double), ceil(double), copysign(double, double);
double cos(double), cosh(double), erf(double), exp(double), expm1(double), fabs(double), floor(double);
double fmax(double, double), fmin(double, double), hypot(double, double), log(double), log1p(double);
double nextafter(double, double), pow(double, double), sin(double), sinh(double), sqrt(double);
double tan(double), tanh(double);
#endif
