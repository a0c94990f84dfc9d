/*
 * Staggered scheme of a Bingham filament with the kinematics of Kamrin & Mahadevan (2012): stretch,
 * tension and a_0 on cells; turning, moment and a_1 on nodes. Loops without calls are written so
 * that a compiler vectorises them; logarithms and arc tangents have loops of their own.
 */
#include "kirchhoff.h"

#include <math.h>

/* Ternaries, not fmax and fmin: those must care for NaN, and are calls or branches. */
static double larger(double a, double b) { return a > b ? a : b; }
static double smaller(double a, double b) { return a < b ? a : b; }

/*
 * Overstress over a rectangle that carries sigma_0 + sigma_1 zeta, of sizes S and B (2.26, 2.27):
 * from an edge stressed by u beyond yield the yielded zone reaches l = u/B deep, at most 2, and the
 * integral of the overstress over it is l (u - B l/2). At the far edge, where S counts against B,
 * l < 1. B = 0 needs no case: either u = 0 or l = 2.
 */
static double per_slope(double B) { return 1.0 / (B + 1e-200); }

/* <overstress>, with the sign of sigma_0. */
static double mean_overstress(double S, double B, double yield)
{
    double per = per_slope(B);
    double u = larger(S + B - yield, 0.0), w = larger(B - S - yield, 0.0);
    double l = smaller(u * per, 2.0), m = w * per;
    return 0.5 * (l * (u - 0.5 * B * l) - 0.5 * w * m);
}

/* 3 <overstress zeta>, with the sign of sigma_1: the arm of a fibre at the depth l' is 1 - l'. */
static double bending_overstress(double S, double B, double yield)
{
    double per = per_slope(B);
    double u = larger(S + B - yield, 0.0), w = larger(B - S - yield, 0.0);
    double l = smaller(u * per, 2.0), m = w * per, Bl = B * l;
    double near = l * (u - 0.5 * Bl - l * (0.5 * u - (1.0 / 3.0) * Bl));
    return 1.5 * near + w * m * (0.75 - 0.25 * m);
}

/* Quintic smooth step (section 3). */
static double gravity_at(const kirchhoff *k, double t)
{
    double q = k->ramp > 0.0 ? smaller(larger(t / k->ramp, 0.0), 1.0) : 1.0;
    return k->gravity * q * q * q * (10.0 + q * (6.0 * q - 15.0));
}

/* Slopes, stretch and its square root, sigma_0 and tension of every cell; arrays begin at ghosts. */
static void stretch_cells(const kirchhoff *k, const double *restrict x, const double *restrict y,
                          const double *restrict a0, double *restrict gx, double *restrict gy,
                          double *restrict s, double *restrict per_s, double *restrict S0,
                          double *restrict T)
{
    const int n = k->cells;
    const double *restrict per = k->per_cell;
    int i;
    for (i = 0; i < n; i++) {
        double a = (x[i + 1] - x[i]) * per[i], b = (y[i + 1] - y[i]) * per[i];
        double square = a * a + b * b, root = sqrt(square);
        gx[i + 1] = a;
        gy[i + 1] = b;
        s[i + 1] = root;
        per_s[i + 1] = 1.0 / root;
        S0[i + 1] = square;
    }
    for (i = 1; i <= n; i++) S0[i] = log(S0[i]);
    for (i = 1; i <= n; i++) {
        S0[i] = 0.5 * S0[i] - a0[i - 1];
        T[i] = S0[i] * per_s[i];
    }
    gx[0] = gx[n + 1] = s[0] = s[n + 1] = 1.0;
    gy[0] = gy[n + 1] = T[0] = T[n + 1] = 0.0;
}

/* Moment of every node, its share of the axial force, and the rate of a_1. */
static void bend_nodes(const kirchhoff *k, const double *restrict gx, const double *restrict gy,
                       const double *restrict s, const double *restrict T,
                       const double *restrict a1, double *restrict turn, double *restrict dot,
                       double *restrict M, double *restrict m, double *restrict a1_rate)
{
    const int n = k->cells;
    const double half = k->half_thickness, yield = k->yield_strain, flow = k->flow;
    const double *restrict before = k->before, *restrict behind = k->behind;
    const double *restrict per = k->per_node;
    int i;
    for (i = 0; i <= n; i++) {
        turn[i] = gx[i] * gy[i + 1] - gy[i] * gx[i + 1];
        dot[i] = gx[i] * gx[i + 1] + gy[i] * gy[i + 1];
    }
    for (i = 0; i <= n; i++)
        turn[i] = dot[i] > 0.0 ? atan(turn[i] / dot[i]) : atan2(turn[i], dot[i]);
    for (i = 0; i <= n; i++) {
        double theta = turn[i] * per[i], sn = before[i] * s[i] + behind[i] * s[i + 1];
        double per_root = 1.0 / sqrt(sn), per_sn = per_root * per_root;
        double lever = half * per_sn * per_root;
        double S1 = -(lever * theta + a1[i]), moment = lever * S1 * (1.0 / 3.0);
        double S0 = (before[i] * T[i] + behind[i] * T[i + 1]) * sn;
        double rate = flow * bending_overstress(fabs(S0), fabs(S1), yield);
        M[i] = moment;
        m[i] = 0.75 * moment * theta * per_sn;
        a1_rate[i] = S1 < 0.0 ? -rate : rate;
    }
}

/* Internal force of every cell, and the rate of a_0. */
static void load_cells(const kirchhoff *k, const double *restrict gx, const double *restrict gy,
                       const double *restrict s, const double *restrict per_s,
                       const double *restrict S0, const double *restrict T,
                       const double *restrict M, const double *restrict m, double *restrict fx,
                       double *restrict fy, double *restrict a0_rate)
{
    const int n = k->cells;
    const double per_moment = 1.5 / k->half_thickness, yield = k->yield_strain, flow = k->flow;
    const double *restrict per = k->per_cell;
    int i;
    for (i = 0; i < n; i++) {
        double c = s[i + 1], d = per_s[i + 1], S = S0[i + 1];
        double S1 = (M[i] + M[i + 1]) * per_moment * c * sqrt(c);
        double Q = (T[i + 1] + m[i] + m[i + 1]) * d, N = (M[i + 1] - M[i]) * per[i] * d * d;
        double rate = flow * mean_overstress(fabs(S), fabs(S1), yield);
        fx[i + 1] = Q * gx[i + 1] - N * gy[i + 1];
        fy[i + 1] = Q * gy[i + 1] + N * gx[i + 1];
        a0_rate[i] = S < 0.0 ? -rate : rate;
    }
    fx[0] = fx[n + 1] = fy[0] = fy[n + 1] = 0.0;
}

/* Newton's second law of every node, but for what the ends hold. */
static void accelerate_nodes(const kirchhoff *k, double gravity, const double *restrict fx,
                             const double *restrict fy, double *restrict u_rate,
                             double *restrict v_rate)
{
    const int n = k->cells;
    const double *restrict per = k->per_mass;
    int i;
    for (i = 0; i < n; i++) {
        u_rate[i] = (fx[i + 1] - fx[i]) * per[i];
        v_rate[i] = (fy[i + 1] - fy[i]) * per[i] - gravity;
    }
    u_rate[0] = u_rate[n] = v_rate[n] = 0.0;
}

void kirchhoff_rates(const kirchhoff *k, double t, const double *state, double *rates,
                     double *scratch)
{
    const int nodes = k->cells + 1, row = k->cells + 2;
    double *gx = scratch, *gy = gx + row, *s = gy + row, *per_s = s + row, *S0 = per_s + row;
    double *T = S0 + row, *turn = T + row, *dot = turn + row, *M = dot + row, *m = M + row;
    double *fx = m + row, *fy = fx + row;
    int i;
    for (i = 0; i < 2 * nodes; i++) rates[i] = state[2 * nodes + i];
    stretch_cells(k, state, state + nodes, state + 5 * nodes, gx, gy, s, per_s, S0, T);
    bend_nodes(k, gx, gy, s, T, state + 4 * nodes, turn, dot, M, m, rates + 4 * nodes);
    load_cells(k, gx, gy, s, per_s, S0, T, M, m, fx, fy, rates + 5 * nodes);
    accelerate_nodes(k, gravity_at(k, t), fx, fy, rates + 2 * nodes, rates + 3 * nodes);
}

void kirchhoff_repeat(const kirchhoff *k, double t, const double *state, double *rates,
                      double *scratch, int count)
{
    for (; count > 0; count--) kirchhoff_rates(k, t, state, rates, scratch);
}
