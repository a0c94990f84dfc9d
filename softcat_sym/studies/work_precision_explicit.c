/* A generated model without algebraic unknowns for integrators that are not the package's own: its rates with those of
 * held unknowns at zero, and the classical Runge-Kutta method of fourth order in C. */
#include "softcat_model.h"

int explicit_rates(const softcat_model *, const softcat_filament *, const int *, int, double,
                   const double *, double *, double *);
int explicit_rk4(const softcat_model *, const softcat_filament *, const int *, int, double, double,
                 long, double *, double *);

int explicit_rates(const softcat_model *model, const softcat_filament *filament, const int *held,
                   int count, double t, const double *y, double *f, double *scratch)
{
    int i, code = model->rates(filament, t, y, f, scratch);
    for (i = 0; i < count; i++) f[held[i]] = 0.0;
    return code;
}

/* Loops without calls, which a compiler vectorises. */
static void first_stage(long n, double dt, const double *restrict y, const double *restrict f,
                        double *restrict sum, double *restrict stage)
{
    long i;
    for (i = 0; i < n; i++) {
        sum[i] = y[i] + (dt / 6) * f[i];
        stage[i] = y[i] + (dt / 2) * f[i];
    }
}

static void inner_stage(long n, double third, double ahead, const double *restrict y,
                        const double *restrict f, double *restrict sum, double *restrict stage)
{
    long i;
    for (i = 0; i < n; i++) {
        sum[i] += third * f[i];
        stage[i] = y[i] + ahead * f[i];
    }
}

static void last_stage(long n, double sixth, const double *restrict f, const double *restrict sum,
                       double *restrict y)
{
    long i;
    for (i = 0; i < n; i++) y[i] = sum[i] + sixth * f[i];
}

/* From one time to another in equal steps; room[3 n + what the model scratches on]. */
int explicit_rk4(const softcat_model *model, const softcat_filament *filament, const int *held,
                 int count, double from, double to, long steps, double *y, double *room)
{
    const long n = (long)filament->sites * model->slots;
    const double dt = (to - from) / (double)steps;
    double *f = room, *sum = f + n, *stage = sum + n, *scratch = stage + n;
    long k;
    int code = SOFTCAT_SOLVED;
    for (k = 0; k < steps && code == SOFTCAT_SOLVED; k++) {
        const double t = from + (double)k * dt;
        code |= explicit_rates(model, filament, held, count, t, y, f, scratch);
        first_stage(n, dt, y, f, sum, stage);
        code |= explicit_rates(model, filament, held, count, t + dt / 2, stage, f, scratch);
        inner_stage(n, dt / 3, dt / 2, y, f, sum, stage);
        code |= explicit_rates(model, filament, held, count, t + dt / 2, stage, f, scratch);
        inner_stage(n, dt / 3, dt, y, f, sum, stage);
        code |= explicit_rates(model, filament, held, count, t + dt, stage, f, scratch);
        last_stage(n, dt / 6, f, sum, y);
    }
    return code;
}
