/* Small problems on which the integrator is measured, each a filament of one site. */
#include "softcat_model.h"

#include <math.h>
#include <stddef.h>

static const int none[] = {-1, -1, -1, -1, -1, -1, -1, -1};
static const int yes[] = {1, 1, 1, 1, 1, 1, 1, 1};
static const int zero[64] = {0};

static const int row1[] = {0}, column1[] = {0};
static const int row2[] = {0, 0, 1, 1}, column2[] = {0, 1, 0, 1};
static const int row3[] = {0, 0, 0, 1, 1, 1, 2, 2, 2}, column3[] = {0, 1, 2, 0, 1, 2, 0, 1, 2};

#define PROBLEM(name, slots, parameters, powers, moves, differential, row, column, work, slope)   \
    const softcat_model name = {slots, 0, parameters, 0, 0, (int)(sizeof row / sizeof *row),      \
                                powers, moves, none, differential, zero, zero, row, zero, column, \
                                name##_rates, name##_jacobian, work, slope, NULL, NULL};

#define RATES(name) \
    static int name##_rates(const softcat_filament *filament, double t, const double *y, double *f, double *scratch)
#define JACOBIAN(name) \
    static int name##_jacobian(const softcat_filament *filament, double t, const double *y, double *j, double *scratch)
#define UNUSED (void)filament, (void)t, (void)y, (void)scratch

/* y' = -y^2 / 2 + cos(t) y, u' = -u y: smooth, nonlinear, moving in time. With power y u. */
RATES(smooth)
{
    UNUSED;
    f[0] = -0.5 * y[0] * y[0] + cos(t) * y[0];
    f[1] = -y[1] * y[0];
    return 0;
}
JACOBIAN(smooth)
{
    UNUSED;
    j[0] = -y[0] + cos(t);
    j[1] = 0.0;
    j[2] = -y[1];
    j[3] = -y[0];
    return 0;
}
static int smooth_work(const softcat_filament *filament, double t, const double *y, double *powers, double *scratch)
{
    UNUSED;
    powers[0] = y[1] * y[0]; /* = -u' */
    return 0;
}
static int smooth_slope(const softcat_filament *filament, double t, const double *y, double *slope, double *scratch)
{
    UNUSED;
    slope[0] = y[1];
    slope[1] = y[0];
    return 0;
}
PROBLEM(smooth, 2, 0, 1, 1, yes, row2, column2, smooth_work, smooth_slope)

/* z' = lambda z with lambda = (a, b) complex. */
RATES(dahlquist)
{
    UNUSED;
    const double *p = filament->parameters;
    f[0] = p[0] * y[0] - p[1] * y[1];
    f[1] = p[1] * y[0] + p[0] * y[1];
    return 0;
}
JACOBIAN(dahlquist)
{
    UNUSED;
    const double *p = filament->parameters;
    j[0] = p[0];
    j[1] = -p[1];
    j[2] = p[1];
    j[3] = p[0];
    return 0;
}
PROBLEM(dahlquist, 2, 2, 0, 0, yes, row2, column2, NULL, NULL)

/* Prothero & Robinson (1974): y' = -lambda (y - g) + g', g = sin(t + pi / 4). */
RATES(prothero)
{
    UNUSED;
    double phase = t + 0.25 * 3.14159265358979323846;
    f[0] = -filament->parameters[0] * (y[0] - sin(phase)) + cos(phase);
    return 0;
}
JACOBIAN(prothero)
{
    UNUSED;
    j[0] = -filament->parameters[0];
    return 0;
}
PROBLEM(prothero, 1, 1, 0, 1, yes, row1, column1, NULL, NULL)

/* Robertson (1966). */
RATES(robertson)
{
    UNUSED;
    f[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
    f[2] = 3e7 * y[1] * y[1];
    f[1] = -f[0] - f[2];
    return 0;
}
JACOBIAN(robertson)
{
    UNUSED;
    j[0] = -0.04;
    j[1] = 1e4 * y[2];
    j[2] = 1e4 * y[1];
    j[6] = 0.0;
    j[7] = 6e7 * y[1];
    j[8] = 0.0;
    for (int c = 0; c < 3; c++) j[3 + c] = -j[c] - j[6 + c];
    return 0;
}
PROBLEM(robertson, 3, 0, 0, 0, yes, row3, column3, NULL, NULL)

/* Van der Pol: y' = z, z' = ((1 - y^2) z - y) / epsilon. */
RATES(oscillator)
{
    UNUSED;
    f[0] = y[1];
    f[1] = ((1.0 - y[0] * y[0]) * y[1] - y[0]) / filament->parameters[0];
    return 0;
}
JACOBIAN(oscillator)
{
    UNUSED;
    double epsilon = filament->parameters[0];
    j[0] = 0.0;
    j[1] = 1.0;
    j[2] = (-2.0 * y[0] * y[1] - 1.0) / epsilon;
    j[3] = (1.0 - y[0] * y[0]) / epsilon;
    return 0;
}
PROBLEM(oscillator, 2, 1, 0, 0, yes, row2, column2, NULL, NULL)

/* HIRES: Schaefer (1975). */
static const int hires_row[] = {0, 0, 0, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5, 5, 5, 6, 6, 6, 7, 7, 7};
static const int hires_column[] = {0, 1, 2, 0, 1, 2, 3, 4, 1, 2, 3, 4, 5, 6, 3, 4, 5, 6, 7, 5, 6, 7, 5, 6, 7};
RATES(hires)
{
    UNUSED;
    double bound = 280.0 * y[5] * y[7];
    f[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
    f[1] = 1.71 * y[0] - 8.75 * y[1];
    f[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
    f[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
    f[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
    f[5] = -bound + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
    f[6] = bound - 1.81 * y[6];
    f[7] = -f[6];
    return 0;
}
JACOBIAN(hires)
{
    UNUSED;
    double by6 = 280.0 * y[7], by8 = 280.0 * y[5];
    const double entries[] = {-1.71, 0.43, 8.32, 1.71, -8.75, -10.03, 0.43, 0.035, 8.32, 1.71, -1.12, -1.745,
                              0.43, 0.43, 0.69, 1.71, -by6 - 0.43, 0.69, -by8, by6, -1.81, by8, -by6, 1.81, -by8};
    for (int e = 0; e < 25; e++) j[e] = entries[e];
    return 0;
}
PROBLEM(hires, 8, 0, 0, 0, yes, hires_row, hires_column, NULL, NULL)

/* Index 1, y = exp(-t) + sin(t), z = log(y): y' = cos(t) + sin(t) - exp(z), 0 = exp(z) - y. */
static const int one_of_two[] = {1, 0};
RATES(algebraic)
{
    UNUSED;
    f[0] = cos(t) + sin(t) - exp(y[1]);
    f[1] = filament->parameters[0] * (exp(y[1]) - y[0]);
    return 0;
}
JACOBIAN(algebraic)
{
    UNUSED;
    j[0] = 0.0;
    j[1] = -exp(y[1]);
    j[2] = -filament->parameters[0];
    j[3] = filament->parameters[0] * exp(y[1]);
    return 0;
}
PROBLEM(algebraic, 2, 1, 0, 1, one_of_two, row2, column2, NULL, NULL)

/* y' = pace, which changes from 1 to -2 at t = parameters[0]; `late` says whether at that time. */
RATES(jump)
{
    UNUSED;
    const double *p = filament->parameters;
    f[0] = (p[1] != 0.0 ? t > p[0] : t >= p[0]) ? -2.0 : 1.0;
    return 0;
}
JACOBIAN(jump)
{
    UNUSED;
    j[0] = 0.0;
    return 0;
}
PROBLEM(jump, 1, 2, 0, 1, yes, row1, column1, NULL, NULL)

/* y' = sqrt(1 - t) - y: no number after t = 1. */
RATES(root)
{
    UNUSED;
    f[0] = sqrt(1.0 - t) - y[0];
    return 0;
}
JACOBIAN(root)
{
    UNUSED;
    j[0] = -1.0;
    return 0;
}
PROBLEM(root, 1, 0, 0, 1, yes, row1, column1, NULL, NULL)

/* y' = y^2 is unbounded at t = 1 / y(0). */
RATES(explosion)
{
    UNUSED;
    f[0] = y[0] * y[0];
    return 0;
}
JACOBIAN(explosion)
{
    UNUSED;
    j[0] = 2.0 * y[0];
    return 0;
}
PROBLEM(explosion, 1, 0, 0, 0, yes, row1, column1, NULL, NULL)

/* y' = -y, 0 = y + z - z: nothing says what z is. */
RATES(undetermined)
{
    UNUSED;
    f[0] = -y[0];
    f[1] = y[0] - 1.0;
    return 0;
}
JACOBIAN(undetermined)
{
    UNUSED;
    j[0] = -1.0;
    j[1] = 0.0;
    j[2] = 1.0;
    j[3] = 0.0;
    return 0;
}
PROBLEM(undetermined, 2, 0, 0, 0, one_of_two, row2, column2, NULL, NULL)
