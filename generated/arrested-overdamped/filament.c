/*
 * Yields, flows slowly and stops
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres, necking-gradient
 * Digest of the structure: a920ebcfddf630b0f0356432d36beb7d2f50be09f8016929771c9379a2959e6b
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES (filament->fibres)
#define SCRATCH 112
#define SLOTS (5 + 2 * FIBRES)
#define ENTRIES (41 + 36 * FIBRES)
#define fibre_zeta (filament->points + 0 * FIBRES)
#define fibre_weight (filament->points + 1 * FIBRES)

static inline double smaller(double a, double b) { return a < b ? a : b; }
static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double squared(double a) { return a * a; }

static void rates_0(int n, int slots, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[slots * i + 0] = y[slots * i + 2];
    }
}

static void rates_1(int n, int slots, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[slots * i + 1] = y[slots * i + 3];
    }
}

static void rates_2(int n, int slots, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[slots * i + 0];
        w1[i] = y[slots * i + 4];
    }
}

static void rates_3(int n, int slots, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[slots * i + 1];
    }
}

static void rates_4(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w2[i] = 0.0;
    w1[i] = 0.0;
    (void)n;
}

static void rates_5(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    const int i = 0;
    w0[i] = 0.0;
    w1[i] = 0.0;
    (void)n;
}

static void rates_6(int n, const double *p, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    for (int i = 0; i < n - 1; i++) {
        const double v4 = g[7 * i + 4];
        const double v5 = (w0[i + 1] - w0[i]) * v4;
        const double v6 = w1[i];
        const double v7 = w1[i + 1];
        const double v11 = (v6 + v7) * 0.5;
        const double v12 = cos(v11);
        const double v17 = (w2[i + 1] - w2[i]) * v4;
        const double v18 = sin(v11);
        w3[i] = (v5 * v12) + (v17 * v18);
        w4[i] = (v17 * v12) - (v5 * v18);
        w5[i] = (v7 - v6) / (g[7 * i + 1] * p[0]);
        w6[i] = sqrt(squared(v5) + squared(v17));
    }
}

static void rates_7(int n, int fibres, int slots, const double *zeta, const double *weight, const double *p, const double *y, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    const double c3 = p[7];
    const double c4 = p[5];
    const double c42 = 1.0 + p[8];
    const double c43 = c4 / c42;
    const double c51 = 1e-12 * c4;
    const double c52 = squared(c51);
    const double c58 = 1.0 / p[6];
    const double c63 = p[10];
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v7 = (-0.5) * w5[i];
        const double v12 = w3[i];
        const double v14 = sqrt(v12) * v12;
        const double v16 = log(v12);
        const double v24 = (0.9128709291752768 * w4[i]) / v12;
        for (int k = 0; k < fibres; k++) {
            const double v8 = zeta[k];
            const double v19 = ((((v7 * v8) * p[1]) / v14) + v16) - y[slots * i + 5 + k];
            const double v25 = y[slots * i + 5 + 1 * fibres + k];
            const double v28 = exp((-1.5) * v19);
            const double v30 = v24 - (v25 * v28);
            const double v34 = c4 * (v19 + (0.25 * squared(v30)));
            const double v38 = 0.5 * v30;
            const double v45 = (v34 * v38) + (c43 * v38);
            const double v46 = v45 * v28;
            const double v54 = sqrt(larger(squared(v34) + (3.0 * squared(v46)), c52));
            const double v55 = (double)(c3 < v54);
            const double v77 = v34 + ((1.5 * v25) * v46);
            const double v78 = weight[k];
            if (v55 != 0.0) {
                const double v59 = (v54 - c3) * c58;
                const double v61 = 1.0 / v54;
                const double v62 = (v34 * v59) * v61;
                f[slots * i + 5 + k] = v62 * c63;
                const double v72 = ((((-1.5) * v25) * v62) + (((3.0 * v46) * v59) * v61)) * c63;
                f[slots * i + 5 + 1 * fibres + k] = v72;
            }
            sum0 += v77 * v78;
            sum1 += v77 * (v78 * v8);
            sum2 += v45 * v78;
        }
        w7[i] = sum0;
        w8[i] = sum1;
        w9[i] = sum2;
    }
}

static void rates_8(int n, const double *p, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    const double c24 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v3 = w7[i] * v2;
        const double v6 = g[7 * i + 1] * p[0];
        const double v12 = (w1[i] + w1[i + 1]) * 0.5;
        const double v13 = cos(v12);
        const double v17 = g[7 * i + 4];
        const double v18 = (w2[i + 1] - w2[i]) * v17;
        const double v22 = w8[i];
        const double v26 = sqrt(v1);
        const double v28 = 1.0 / (v26 * v1);
        const double v34 = ((((((-0.5) * w5[i]) * v22) * c24) * v28) * v28) * ((v1 / (2.0 * v26)) + v26);
        const double v39 = w9[i];
        const double v43 = (v3 - v34) - ((((0.9128709291752768 * w4[i]) * v39) * v2) * v2);
        const double v49 = (w0[i + 1] - w0[i]) * v17;
        const double v51 = (0.9128709291752768 * v39) * v2;
        const double v54 = sin(v12);
        const double v58 = (v13 * (v18 * v43)) - ((v13 * (v49 * v51)) + (v54 * (v18 * v51)));
        const double v62 = 0.5 * (v58 - (v54 * (v49 * v43)));
        const double v66 = ((c24 * ((-0.5) * v22)) * v28) / v6;
        w10[i] = v3;
        w11[i] = -(v6 * (v62 - v66));
        w12[i] = -(v6 * (v66 + v62));
    }
}

static void rates_9(int n, int slots, const double *p, const double *g, double *w, double *f)
{
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    const double c4 = squared(p[10]);
    const double c6 = p[0];
    const double c7 = squared(c6);
    const double c8 = p[2] * c7;
    const double c9 = c8 * c6;
    const double c10 = c4 / c9;
    for (int i = 1; i < n - 1; i++) {
        f[slots * i + 4] = (w11[i] + w12[i - 1]) * (c10 * g[7 * i + 5]);
    }
}

static void rates_10(int n, const double *p, const double *g, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w13 = w + 13 * n;
    const double c7 = 1.0 / p[0];
    const double c10 = squared(p[1]);
    const double c26 = squared(p[9]);
    const double c27 = 0.020833333333333332 * c26;
    const double c28 = 0.020833333333333332 + c27;
    for (int i = 1; i < n - 1; i++) {
        const double v0 = w6[i];
        const double v1 = w6[i - 1];
        const double v14 = 1.0 / (2.0 * g[7 * i + 2]);
        const double v15 = g[7 * i - 6] * v14;
        const double v18 = g[7 * i + 1] * v14;
        const double v36 = larger(0.0, (v15 * w10[i - 1]) + (v18 * w10[i]));
        double v38 = 0.0;
        if (v36 != 0.0) {
            const double v23 = ((((v0 - v1) * g[7 * i + 5]) * c7) * c10) / squared(squared(((v15 * v1) + (v18 * v0))));
            v38 = ((v23 * c28) * v36) * c7;
        }
        w13[i] = v38;
    }
}

static void rates_11(int n, double *w)
{
    double *restrict w13 = w + 13 * n;
    const int i = n - 1;
    w13[i] = 0.0;
    (void)n;
}

static void rates_12(int n, double *w)
{
    double *restrict w13 = w + 13 * n;
    const int i = 0;
    w13[i] = 0.0;
    (void)n;
}

static void rates_13(int n, const double *p, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    double *restrict w15 = w + 15 * n;
    for (int i = 0; i < n - 1; i++) {
        const double v5 = (w1[i] + w1[i + 1]) * 0.5;
        const double v6 = cos(v5);
        const double v8 = w3[i];
        const double v9 = 1.0 / v8;
        const double v18 = sqrt(v8);
        const double v20 = 1.0 / (v18 * v8);
        const double v26 = ((((((-0.5) * w5[i]) * w8[i]) * p[1]) * v20) * v20) * ((v8 / (2.0 * v18)) + v18);
        const double v31 = w9[i];
        const double v35 = ((w7[i] * v9) - v26) - ((((0.9128709291752768 * w4[i]) * v31) * v9) * v9);
        const double v37 = sin(v5);
        const double v39 = (0.9128709291752768 * v31) * v9;
        const double v46 = g[7 * i + 4];
        const double v49 = ((w13[i + 1] - w13[i]) * v46) / w6[i];
        const double v55 = ((v6 * v35) - (v37 * v39)) - (v49 * ((w0[i + 1] - w0[i]) * v46));
        const double v64 = ((v6 * v39) + (v37 * v35)) - (v49 * ((w2[i + 1] - w2[i]) * v46));
        w14[i] = v55;
        w15[i] = v64;
    }
}

static void rates_14(int n, int slots, const double *p, const double *g, double *w, double *f)
{
    double *restrict w14 = w + 14 * n;
    const double c4 = squared(p[10]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    for (int i = 1; i < n - 1; i++) {
        f[slots * i + 2] = (w14[i] - w14[i - 1]) * (c9 * g[7 * i + 6]);
    }
}

static void rates_15(int n, int slots, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w15 = w + 15 * n;
    const double c3 = p[10];
    const double c4 = squared(c3);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    const double c18 = t * c3;
    const double c20 = c18 / p[4];
    const double c21 = larger(0.0, c20);
    const double c22 = smaller(1.0, c21);
    const double c23 = squared(c22);
    const double c24 = c23 * c22;
    const double c25 = p[3] * c24;
    const double c29 = 6.0 * c22;
    const double c30 = (-15.0) + c29;
    const double c31 = c30 * c22;
    const double c32 = 10.0 + c31;
    const double c33 = c25 * c32;
    const double c34 = c33 * c6;
    for (int i = 1; i < n - 1; i++) {
        f[slots * i + 3] = ((w15[i] - w15[i - 1]) * (c9 * g[7 * i + 6])) - c34;
    }
}

static void rates_16(int n, int slots, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w15 = w + 15 * n;
    const double c1 = p[10];
    const double c2 = squared(c1);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c6 = p[2] * c3;
    const double c7 = c4 / c6;
    const double c16 = t * c1;
    const double c18 = c16 / p[4];
    const double c19 = larger(0.0, c18);
    const double c20 = smaller(1.0, c19);
    const double c21 = squared(c20);
    const double c22 = c21 * c20;
    const double c23 = p[3] * c22;
    const double c27 = 6.0 * c20;
    const double c28 = (-15.0) + c27;
    const double c29 = c28 * c20;
    const double c30 = 10.0 + c29;
    const double c31 = c23 * c30;
    const double c32 = c31 * c4;
    const int i = 0;
    f[slots * i + 3] = (w15[i] * (c7 * g[7 * i + 6])) - c32;
    (void)n;
}

static void jacobian_0(int n, int entries, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[entries * i + 0] = 1.0;
    }
}

static void jacobian_1(int n, int entries, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[entries * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, int slots, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[slots * i + 0];
        w1[i] = y[slots * i + 4];
    }
}

static void jacobian_3(int n, int slots, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[slots * i + 1];
    }
}

static void jacobian_4(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w2[i] = 0.0;
    w1[i] = 0.0;
    (void)n;
}

static void jacobian_5(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    const int i = 0;
    w0[i] = 0.0;
    w1[i] = 0.0;
    (void)n;
}

static void jacobian_6(int n, const double *p, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    double *restrict w19 = w + 19 * n;
    double *restrict w20 = w + 20 * n;
    double *restrict w21 = w + 21 * n;
    double *restrict w22 = w + 22 * n;
    double *restrict w23 = w + 23 * n;
    double *restrict w24 = w + 24 * n;
    double *restrict w25 = w + 25 * n;
    double *restrict w26 = w + 26 * n;
    double *restrict w27 = w + 27 * n;
    double *restrict w28 = w + 28 * n;
    double *restrict w29 = w + 29 * n;
    double *restrict w30 = w + 30 * n;
    double *restrict w31 = w + 31 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    for (int i = 0; i < n - 1; i++) {
        const double v4 = g[7 * i + 4];
        const double v5 = (w0[i + 1] - w0[i]) * v4;
        const double v6 = w1[i];
        const double v7 = w1[i + 1];
        const double v11 = (v6 + v7) * 0.5;
        const double v12 = cos(v11);
        const double v17 = (w2[i + 1] - w2[i]) * v4;
        const double v18 = sin(v11);
        const double v21 = 0.5 * v12;
        const double v23 = 0.5 * v18;
        const double v25 = (v17 * v21) - (v5 * v23);
        const double v26 = v12 * v4;
        const double v27 = -v26;
        const double v28 = v18 * v4;
        const double v29 = -v28;
        const double v36 = -((v17 * v23) + (v5 * v21));
        const double v40 = 1.0 / (g[7 * i + 1] * p[0]);
        const double v46 = sqrt(squared(v5) + squared(v17));
        const double v50 = 1.0 / (2.0 * v46);
        const double v51 = ((2.0 * v5) * v4) * v50;
        const double v55 = ((2.0 * v17) * v4) * v50;
        w3[i] = (v5 * v12) + (v17 * v18);
        w16[i] = v25;
        w17[i] = v25;
        w18[i] = v27;
        w19[i] = v26;
        w20[i] = v29;
        w21[i] = v28;
        w4[i] = (v17 * v12) - (v5 * v18);
        w22[i] = v36;
        w23[i] = v36;
        w24[i] = v28;
        w25[i] = v29;
        w26[i] = v27;
        w27[i] = v26;
        w5[i] = (v7 - v6) * v40;
        w28[i] = -v40;
        w29[i] = v40;
        w6[i] = v46;
        w30[i] = -v51;
        w31[i] = v51;
        w32[i] = -v55;
        w33[i] = v55;
    }
}

static void jacobian_7(int n, int fibres, int slots, int entries, const double *zeta, const double *weight, const double *p, const double *y, double *w, double *e)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    double *restrict w19 = w + 19 * n;
    double *restrict w20 = w + 20 * n;
    double *restrict w21 = w + 21 * n;
    double *restrict w22 = w + 22 * n;
    double *restrict w23 = w + 23 * n;
    double *restrict w24 = w + 24 * n;
    double *restrict w25 = w + 25 * n;
    double *restrict w26 = w + 26 * n;
    double *restrict w27 = w + 27 * n;
    double *restrict w28 = w + 28 * n;
    double *restrict w29 = w + 29 * n;
    double *restrict w34 = w + 34 * n;
    double *restrict w35 = w + 35 * n;
    double *restrict w36 = w + 36 * n;
    double *restrict w37 = w + 37 * n;
    double *restrict w38 = w + 38 * n;
    double *restrict w39 = w + 39 * n;
    double *restrict w40 = w + 40 * n;
    double *restrict w41 = w + 41 * n;
    double *restrict w42 = w + 42 * n;
    double *restrict w43 = w + 43 * n;
    double *restrict w44 = w + 44 * n;
    double *restrict w45 = w + 45 * n;
    double *restrict w46 = w + 46 * n;
    double *restrict w47 = w + 47 * n;
    double *restrict w48 = w + 48 * n;
    double *restrict w49 = w + 49 * n;
    double *restrict w50 = w + 50 * n;
    double *restrict w51 = w + 51 * n;
    double *restrict each0 = w + (SCRATCH) * n;
    double *restrict each1 = w + (SCRATCH + 1 * fibres) * n;
    double *restrict each2 = w + (SCRATCH + 2 * fibres) * n;
    double *restrict each3 = w + (SCRATCH + 3 * fibres) * n;
    double *restrict each4 = w + (SCRATCH + 4 * fibres) * n;
    double *restrict each5 = w + (SCRATCH + 5 * fibres) * n;
    const double c7 = p[1];
    const double c20 = p[5];
    const double c39 = 1.0 + p[8];
    const double c40 = c20 / c39;
    const double c206 = p[7];
    const double c213 = 1e-12 * c20;
    const double c214 = squared(c213);
    const double c223 = p[10];
    const double c228 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum2 = 0.0;
        double sum3 = 0.0;
        double sum4 = 0.0;
        double sum5 = 0.0;
        double sum6 = 0.0;
        double sum7 = 0.0;
        double sum8 = 0.0;
        double sum9 = 0.0;
        const double v4 = (-0.5) * w5[i];
        const double v9 = w3[i];
        const double v10 = sqrt(v9);
        const double v12 = 1.0 / (v10 * v9);
        const double v14 = log(v9);
        const double v25 = 1.0 / v9;
        const double v26 = (0.9128709291752768 * w4[i]) * v25;
        const double v69 = w16[i];
        const double v72 = w22[i];
        const double v76 = w28[i];
        const double v79 = w17[i];
        const double v81 = w23[i];
        const double v84 = w29[i];
        const double v92 = w18[i];
        const double v94 = w24[i];
        const double v97 = w19[i];
        const double v99 = w25[i];
        const double v102 = w20[i];
        const double v104 = w26[i];
        const double v107 = w21[i];
        const double v109 = w27[i];
        const double v269 = v26 * v25;
        const double v278 = 1.0 / (2.0 * v10);
        for (int k = 0; k < fibres; k++) {
            const double v5 = zeta[k];
            const double v13 = ((v4 * v5) * c7) * v12;
            const double v17 = (v13 + v14) - y[slots * i + 5 + k];
            const double v19 = exp((-1.5) * v17);
            const double v27 = y[slots * i + 5 + 1 * fibres + k];
            const double v29 = v26 - (v27 * v19);
            const double v33 = c20 * (v17 + (0.25 * squared(v29)));
            const double v35 = 0.5 * v29;
            const double v42 = (v33 * v35) + (c40 * v35);
            const double v44 = 1.5 * v27;
            const double v45 = weight[k];
            const double v46 = v44 * v45;
            const double v50 = v19 * v46;
            const double v53 = c20 * (v45 + (v35 * v50));
            const double v59 = 2.0 * v29;
            const double v62 = (0.5 * ((c40 * v50) + (v33 * v50))) + (v59 * (0.25 * v53));
            const double v66 = (((-1.5) * (v19 * (v42 * v46))) + v53) - ((-1.5) * (v19 * (v27 * v62)));
            const double v87 = v42 * v19;
            const double v113 = v45 * v5;
            const double v114 = v44 * v113;
            const double v118 = v19 * v114;
            const double v121 = c20 * (v113 + (v35 * v118));
            const double v129 = (0.5 * ((c40 * v118) + (v33 * v118))) + (v59 * (0.25 * v121));
            const double v133 = (((-1.5) * (v19 * (v42 * v114))) + v121) - ((-1.5) * (v19 * (v27 * v129)));
            const double v166 = c20 * (v35 * v45);
            const double v173 = (0.5 * ((c40 * v45) + (v33 * v45))) + (v59 * (0.25 * v166));
            const double v177 = v166 - ((-1.5) * (v19 * (v27 * v173)));
            const double v211 = squared(v33) + (3.0 * squared(v87));
            const double v216 = sqrt(larger(v211, c214));
            const double v217 = (double)(c206 < v216);
            const double v272 = v13 * v12;
            const double v412 = v33 + (v44 * v87);
            const double v425 = v272 * v66;
            const double v430 = (((v66 * v25) - (v269 * v62)) - (v10 * v425)) - ((v9 * v425) * v278);
            const double v440 = v272 * v133;
            const double v445 = (((v133 * v25) - (v269 * v129)) - (v10 * v440)) - ((v9 * v440) * v278);
            const double v455 = v272 * v177;
            const double v460 = (((v177 * v25) - (v269 * v173)) - (v10 * v455)) - ((v9 * v455) * v278);
            if (v217 != 0.0) {
                const double v218 = 2.0 * v87;
                const double v219 = (double)(c214 <= v211);
                const double v222 = v219 / (v219 + (double)(v211 <= c214));
                const double v224 = 1.0 / v216;
                const double v225 = c223 * v224;
                const double v231 = (v216 - c206) * c228;
                const double v233 = (v33 * v231) * v224;
                const double v234 = v233 * v224;
                const double v238 = 1.0 / (2.0 * v216);
                const double v240 = v222 * ((((v33 * v225) * c228) - (v234 * c223)) * v238);
                const double v242 = v218 * (3.0 * v240);
                const double v246 = v231 * v225;
                const double v247 = v19 * v242;
                const double v250 = 2.0 * v33;
                const double v253 = c20 * ((v246 + (v35 * v247)) + (v250 * v240));
                const double v261 = (0.5 * ((c40 * v247) + (v33 * v247))) + (v59 * (0.25 * v253));
                const double v265 = (((-1.5) * (v19 * (v42 * v242))) + v253) - ((-1.5) * (v19 * (v27 * v261)));
                e[entries * i + 41 + 23 * fibres + k] = -v265;
                const double v273 = v272 * v265;
                const double v280 = (((v265 * v25) - (v269 * v261)) - (v10 * v273)) - ((v9 * v273) * v278);
                const double v283 = 0.9128709291752768 * (v261 * v25);
                const double v289 = (-0.5) * (v5 * (c7 * (v265 * v12)));
                e[entries * i + 41 + 22 * fibres + k] = ((v280 * v69) + (v283 * v72)) + (v289 * v76);
                e[entries * i + 41 + 27 * fibres + k] = ((v280 * v79) + (v283 * v81)) + (v289 * v84);
                e[entries * i + 41 + 24 * fibres + k] = -(v19 * v261);
                e[entries * i + 41 + 20 * fibres + k] = (v280 * v92) + (v283 * v94);
                e[entries * i + 41 + 25 * fibres + k] = (v280 * v97) + (v283 * v99);
                e[entries * i + 41 + 21 * fibres + k] = (v280 * v102) + (v283 * v104);
                e[entries * i + 41 + 26 * fibres + k] = (v280 * v107) + (v283 * v109);
                const double v319 = 3.0 * v87;
                const double v322 = ((-1.5) * v27) * c223;
                const double v323 = v322 * v224;
                const double v333 = (((v319 * v225) + (v33 * v323)) * c228) - (((((v319 * v231) * v224) * v224) * c223) + (v234 * v322));
                const double v335 = v222 * (v333 * v238);
                const double v338 = (3.0 * v246) + (v218 * (3.0 * v335));
                const double v343 = v19 * v338;
                const double v348 = c20 * (((v231 * v323) + (v35 * v343)) + (v250 * v335));
                const double v356 = (0.5 * ((c40 * v343) + (v33 * v343))) + (v59 * (0.25 * v348));
                const double v360 = (((-1.5) * (v19 * (v42 * v338))) + v348) - ((-1.5) * (v19 * (v27 * v356)));
                e[entries * i + 41 + 31 * fibres + k] = -v360;
                const double v366 = v272 * v360;
                const double v371 = (((v360 * v25) - (v269 * v356)) - (v10 * v366)) - ((v9 * v366) * v278);
                const double v374 = 0.9128709291752768 * (v356 * v25);
                const double v380 = (-0.5) * (v5 * (c7 * (v360 * v12)));
                e[entries * i + 41 + 30 * fibres + k] = ((v371 * v69) + (v374 * v72)) + (v380 * v76);
                e[entries * i + 41 + 35 * fibres + k] = ((v371 * v79) + (v374 * v81)) + (v380 * v84);
                e[entries * i + 41 + 32 * fibres + k] = ((-1.5) * (v233 * c223)) - (v19 * v356);
                e[entries * i + 41 + 28 * fibres + k] = (v371 * v92) + (v374 * v94);
                e[entries * i + 41 + 33 * fibres + k] = (v371 * v97) + (v374 * v99);
                e[entries * i + 41 + 29 * fibres + k] = (v371 * v102) + (v374 * v104);
                e[entries * i + 41 + 34 * fibres + k] = (v371 * v107) + (v374 * v109);
            }
            each0[fibres * i + k] = -v66;
            each1[fibres * i + k] = (1.5 * (v87 * v45)) - (v19 * v62);
            each2[fibres * i + k] = -v133;
            each3[fibres * i + k] = (1.5 * (v87 * v113)) - (v19 * v129);
            each4[fibres * i + k] = -v177;
            each5[fibres * i + k] = -(v19 * v173);
            sum0 += v412 * v45;
            sum1 += v412 * v113;
            sum10 += 0.9128709291752768 * (v173 * v25);
            sum11 += (-0.5) * (v5 * (c7 * (v177 * v12)));
            sum2 += v42 * v45;
            sum3 += v430;
            sum4 += 0.9128709291752768 * (v62 * v25);
            sum5 += (-0.5) * (v5 * (c7 * (v66 * v12)));
            sum6 += v445;
            sum7 += 0.9128709291752768 * (v129 * v25);
            sum8 += (-0.5) * (v5 * (c7 * (v133 * v12)));
            sum9 += v460;
        }
        const double v68 = sum3;
        const double v71 = sum4;
        const double v75 = sum5;
        const double v135 = sum6;
        const double v137 = sum7;
        const double v140 = sum8;
        const double v179 = sum9;
        const double v181 = sum10;
        const double v184 = sum11;
        w7[i] = sum0;
        w34[i] = ((v68 * v69) + (v71 * v72)) + (v75 * v76);
        w35[i] = ((v68 * v79) + (v71 * v81)) + (v75 * v84);
        w36[i] = (v68 * v92) + (v71 * v94);
        w37[i] = (v68 * v97) + (v71 * v99);
        w38[i] = (v68 * v102) + (v71 * v104);
        w39[i] = (v68 * v107) + (v71 * v109);
        w8[i] = sum1;
        w40[i] = ((v135 * v69) + (v137 * v72)) + (v140 * v76);
        w41[i] = ((v135 * v79) + (v137 * v81)) + (v140 * v84);
        w42[i] = (v135 * v92) + (v137 * v94);
        w43[i] = (v135 * v97) + (v137 * v99);
        w44[i] = (v135 * v102) + (v137 * v104);
        w45[i] = (v135 * v107) + (v137 * v109);
        w9[i] = sum2;
        w46[i] = ((v179 * v69) + (v181 * v72)) + (v184 * v76);
        w47[i] = ((v179 * v79) + (v181 * v81)) + (v184 * v84);
        w48[i] = (v179 * v92) + (v181 * v94);
        w49[i] = (v179 * v97) + (v181 * v99);
        w50[i] = (v179 * v102) + (v181 * v104);
        w51[i] = (v179 * v107) + (v181 * v109);
    }
}

static void jacobian_8(int n, int fibres, const double *p, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    double *restrict w19 = w + 19 * n;
    double *restrict w20 = w + 20 * n;
    double *restrict w21 = w + 21 * n;
    double *restrict w22 = w + 22 * n;
    double *restrict w23 = w + 23 * n;
    double *restrict w24 = w + 24 * n;
    double *restrict w25 = w + 25 * n;
    double *restrict w26 = w + 26 * n;
    double *restrict w27 = w + 27 * n;
    double *restrict w28 = w + 28 * n;
    double *restrict w29 = w + 29 * n;
    double *restrict w34 = w + 34 * n;
    double *restrict w35 = w + 35 * n;
    double *restrict w36 = w + 36 * n;
    double *restrict w37 = w + 37 * n;
    double *restrict w38 = w + 38 * n;
    double *restrict w39 = w + 39 * n;
    double *restrict w40 = w + 40 * n;
    double *restrict w41 = w + 41 * n;
    double *restrict w42 = w + 42 * n;
    double *restrict w43 = w + 43 * n;
    double *restrict w44 = w + 44 * n;
    double *restrict w45 = w + 45 * n;
    double *restrict w46 = w + 46 * n;
    double *restrict w47 = w + 47 * n;
    double *restrict w48 = w + 48 * n;
    double *restrict w49 = w + 49 * n;
    double *restrict w50 = w + 50 * n;
    double *restrict w51 = w + 51 * n;
    double *restrict w52 = w + 52 * n;
    double *restrict w53 = w + 53 * n;
    double *restrict w54 = w + 54 * n;
    double *restrict w55 = w + 55 * n;
    double *restrict w56 = w + 56 * n;
    double *restrict w57 = w + 57 * n;
    double *restrict w58 = w + 58 * n;
    double *restrict w59 = w + 59 * n;
    double *restrict w60 = w + 60 * n;
    double *restrict w61 = w + 61 * n;
    double *restrict w62 = w + 62 * n;
    double *restrict w63 = w + 63 * n;
    double *restrict w64 = w + 64 * n;
    double *restrict w65 = w + 65 * n;
    double *restrict w66 = w + 66 * n;
    double *restrict w67 = w + 67 * n;
    double *restrict w68 = w + 68 * n;
    double *restrict w69 = w + 69 * n;
    double *restrict each0 = w + (SCRATCH) * n;
    double *restrict each1 = w + (SCRATCH + 1 * fibres) * n;
    double *restrict each2 = w + (SCRATCH + 2 * fibres) * n;
    double *restrict each3 = w + (SCRATCH + 3 * fibres) * n;
    double *restrict each4 = w + (SCRATCH + 4 * fibres) * n;
    double *restrict each5 = w + (SCRATCH + 5 * fibres) * n;
    double *restrict each6 = w + (SCRATCH + 6 * fibres) * n;
    double *restrict each7 = w + (SCRATCH + 7 * fibres) * n;
    double *restrict each8 = w + (SCRATCH + 8 * fibres) * n;
    double *restrict each9 = w + (SCRATCH + 9 * fibres) * n;
    double *restrict each10 = w + (SCRATCH + 10 * fibres) * n;
    double *restrict each11 = w + (SCRATCH + 11 * fibres) * n;
    const double c59 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v3 = w7[i] * v2;
        const double v6 = w34[i];
        const double v8 = v3 * v2;
        const double v9 = w16[i];
        const double v12 = w35[i];
        const double v14 = w17[i];
        const double v19 = w36[i];
        const double v21 = w18[i];
        const double v24 = w37[i];
        const double v26 = w19[i];
        const double v29 = w38[i];
        const double v31 = w20[i];
        const double v34 = w39[i];
        const double v36 = w21[i];
        const double v41 = g[7 * i + 1] * p[0];
        const double v47 = (w1[i] + w1[i + 1]) * 0.5;
        const double v48 = cos(v47);
        const double v52 = g[7 * i + 4];
        const double v53 = (w2[i + 1] - w2[i]) * v52;
        const double v56 = (-0.5) * w5[i];
        const double v57 = w8[i];
        const double v61 = sqrt(v1);
        const double v63 = 1.0 / (v61 * v1);
        const double v65 = (((v56 * v57) * c59) * v63) * v63;
        const double v67 = 1.0 / (2.0 * v61);
        const double v68 = v1 * v67;
        const double v69 = v68 + v61;
        const double v74 = 0.9128709291752768 * w4[i];
        const double v75 = w9[i];
        const double v78 = ((v74 * v75) * v2) * v2;
        const double v79 = (v3 - (v65 * v69)) - v78;
        const double v80 = v53 * v79;
        const double v85 = (w0[i + 1] - w0[i]) * v52;
        const double v87 = (0.9128709291752768 * v75) * v2;
        const double v88 = v85 * v87;
        const double v90 = sin(v47);
        const double v91 = v53 * v87;
        const double v95 = v85 * v79;
        const double v98 = 0.5 * (((v48 * v80) - ((v48 * v88) + (v90 * v91))) - (v90 * v95));
        const double v101 = (c59 * ((-0.5) * v57)) * v63;
        const double v102 = v101 / v41;
        const double v106 = 0.5 * v41;
        const double v107 = v90 * v106;
        const double v109 = v48 * v106;
        const double v111 = (v85 * v107) - (v53 * v109);
        const double v112 = v111 * v2;
        const double v115 = (-0.5) * (c59 * v63);
        const double v116 = v69 * v111;
        const double v117 = v116 * v63;
        const double v119 = c59 * (v117 * v63);
        const double v120 = v56 * v119;
        const double v121 = v115 - v120;
        const double v127 = (v53 * v107) + (v85 * v109);
        const double v130 = v112 * v2;
        const double v132 = (0.9128709291752768 * (v127 * v2)) - (v74 * v130);
        const double v136 = v112 * v6;
        const double v137 = w40[i];
        const double v147 = ((v48 * (v95 * v106)) + (v48 * (v91 * v106))) - (v90 * (v88 * v106));
        const double v151 = 0.5 * (v147 + (v90 * (v80 * v106)));
        const double v154 = v132 * w46[i];
        const double v162 = (((v78 * v2) * v111) - ((v87 * v2) * v127)) + (v78 * v112);
        const double v163 = v65 * v111;
        const double v165 = v162 - (v163 * v67);
        const double v167 = (v65 * v63) * v116;
        const double v168 = v101 * v63;
        const double v170 = v65 * v117;
        const double v171 = (v167 - v168) + v170;
        const double v177 = (2.0 * ((v68 * v67) * v163)) - v163;
        const double v182 = v8 * v111;
        const double v183 = ((v165 + (v61 * v171)) + ((v177 + (v1 * v171)) * v67)) - v182;
        const double v187 = 0.9128709291752768 * (v75 * v130);
        const double v189 = v187 * w22[i];
        const double v190 = ((((v136 + (v121 * v137)) + v151) + v154) + (v183 * v9)) - v189;
        const double v192 = (-0.5) * (v57 * v119);
        const double v194 = v192 * w28[i];
        const double v196 = v112 * v12;
        const double v197 = w41[i];
        const double v202 = v132 * w47[i];
        const double v207 = v187 * w23[i];
        const double v208 = ((((v196 + (v121 * v197)) + v151) + v202) + (v183 * v14)) - v207;
        const double v210 = v192 * w29[i];
        const double v219 = v112 * v19;
        const double v220 = w42[i];
        const double v224 = v132 * w48[i];
        const double v229 = v187 * w24[i];
        const double v234 = ((v79 * v107) + (v87 * v109)) * v52;
        const double v235 = ((((v219 + (v121 * v220)) + v224) + (v183 * v21)) - v229) - v234;
        const double v236 = v112 * v24;
        const double v237 = w43[i];
        const double v241 = v132 * w49[i];
        const double v246 = v187 * w25[i];
        const double v248 = ((((v236 + (v121 * v237)) + v241) + (v183 * v26)) - v246) + v234;
        const double v249 = v112 * v29;
        const double v250 = w44[i];
        const double v254 = v132 * w50[i];
        const double v259 = v187 * w26[i];
        const double v264 = ((v87 * v107) - (v79 * v109)) * v52;
        const double v265 = ((((v249 + (v121 * v250)) + v254) + (v183 * v31)) - v259) - v264;
        const double v266 = v112 * v34;
        const double v267 = w45[i];
        const double v271 = v132 * w51[i];
        const double v276 = v187 * w27[i];
        const double v278 = ((((v266 + (v121 * v267)) + v271) + (v183 * v36)) - v276) + v264;
        const double v282 = v115 + v120;
        const double v291 = (v168 + v167) + v170;
        const double v298 = ((v165 + (v61 * v291)) + ((v177 + (v1 * v291)) * v67)) - v182;
        const double v301 = ((((v136 - (v282 * v137)) + v151) + v154) + (v298 * v9)) - v189;
        const double v309 = ((((v196 - (v282 * v197)) + v151) + v202) + (v298 * v14)) - v207;
        const double v320 = ((((v219 - (v282 * v220)) + v224) + (v298 * v21)) - v229) - v234;
        const double v327 = ((((v236 - (v282 * v237)) + v241) + (v298 * v26)) - v246) + v234;
        const double v334 = ((((v249 - (v282 * v250)) + v254) + (v298 * v31)) - v259) - v264;
        const double v341 = ((((v266 - (v282 * v267)) + v271) + (v298 * v36)) - v276) + v264;
        w10[i] = v3;
        w52[i] = (v6 * v2) - (v8 * v9);
        w53[i] = (v12 * v2) - (v8 * v14);
        w54[i] = (v19 * v2) - (v8 * v21);
        w55[i] = (v24 * v2) - (v8 * v26);
        w56[i] = (v29 * v2) - (v8 * v31);
        w57[i] = (v34 * v2) - (v8 * v36);
        w11[i] = -(v41 * (v98 - v102));
        w58[i] = v190 - v194;
        w59[i] = v208 - v210;
        w60[i] = v235;
        w61[i] = v248;
        w62[i] = v265;
        w63[i] = v278;
        w12[i] = -(v41 * (v102 + v98));
        w64[i] = v301 - v194;
        w65[i] = v309 - v210;
        w66[i] = v320;
        w67[i] = v327;
        w68[i] = v334;
        w69[i] = v341;
        for (int k = 0; k < fibres; k++) {
            const double v4 = each0[fibres * i + k];
            const double v17 = each1[fibres * i + k];
            const double v113 = v112 * v4;
            const double v122 = each2[fibres * i + k];
            const double v134 = v132 * each4[fibres * i + k];
            const double v212 = v112 * v17;
            const double v213 = each3[fibres * i + k];
            const double v217 = v132 * each5[fibres * i + k];
            each6[fibres * i + k] = v4 * v2;
            each7[fibres * i + k] = v17 * v2;
            each8[fibres * i + k] = (v113 + (v121 * v122)) + v134;
            each9[fibres * i + k] = (v212 + (v121 * v213)) + v217;
            each10[fibres * i + k] = (v113 - (v282 * v122)) + v134;
            each11[fibres * i + k] = (v212 - (v282 * v213)) + v217;
        }
    }
}

static void jacobian_9(int n, int fibres, int entries, const double *p, const double *g, double *w, double *e)
{
    double *restrict w58 = w + 58 * n;
    double *restrict w59 = w + 59 * n;
    double *restrict w60 = w + 60 * n;
    double *restrict w61 = w + 61 * n;
    double *restrict w62 = w + 62 * n;
    double *restrict w63 = w + 63 * n;
    double *restrict w64 = w + 64 * n;
    double *restrict w65 = w + 65 * n;
    double *restrict w66 = w + 66 * n;
    double *restrict w67 = w + 67 * n;
    double *restrict w68 = w + 68 * n;
    double *restrict w69 = w + 69 * n;
    double *restrict each8 = w + (SCRATCH + 8 * fibres) * n;
    double *restrict each9 = w + (SCRATCH + 9 * fibres) * n;
    double *restrict each10 = w + (SCRATCH + 10 * fibres) * n;
    double *restrict each11 = w + (SCRATCH + 11 * fibres) * n;
    const double c1 = squared(p[10]);
    const double c3 = p[0];
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c5 * c3;
    const double c7 = c1 / c6;
    for (int i = 1; i < n - 1; i++) {
        const double v10 = c7 * g[7 * i + 5];
        e[entries * i + 34] = v10 * w64[i - 1];
        e[entries * i + 37] = (v10 * w58[i]) + (v10 * w65[i - 1]);
        e[entries * i + 40] = v10 * w59[i];
        e[entries * i + 32] = v10 * w66[i - 1];
        e[entries * i + 35] = (v10 * w60[i]) + (v10 * w67[i - 1]);
        e[entries * i + 38] = v10 * w61[i];
        e[entries * i + 33] = v10 * w68[i - 1];
        e[entries * i + 36] = (v10 * w62[i]) + (v10 * w69[i - 1]);
        e[entries * i + 39] = v10 * w63[i];
        for (int k = 0; k < fibres; k++) {
            e[entries * i + 41 + 16 * fibres + k] = v10 * each10[fibres * (i - 1) + k];
            e[entries * i + 41 + 18 * fibres + k] = v10 * each8[fibres * i + k];
            e[entries * i + 41 + 17 * fibres + k] = v10 * each11[fibres * (i - 1) + k];
            e[entries * i + 41 + 19 * fibres + k] = v10 * each9[fibres * i + k];
        }
    }
}

static void jacobian_10(int n, int fibres, const double *p, const double *g, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w30 = w + 30 * n;
    double *restrict w31 = w + 31 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    double *restrict w52 = w + 52 * n;
    double *restrict w53 = w + 53 * n;
    double *restrict w54 = w + 54 * n;
    double *restrict w55 = w + 55 * n;
    double *restrict w56 = w + 56 * n;
    double *restrict w57 = w + 57 * n;
    double *restrict w70 = w + 70 * n;
    double *restrict w71 = w + 71 * n;
    double *restrict w72 = w + 72 * n;
    double *restrict w73 = w + 73 * n;
    double *restrict w74 = w + 74 * n;
    double *restrict w75 = w + 75 * n;
    double *restrict w76 = w + 76 * n;
    double *restrict w77 = w + 77 * n;
    double *restrict w78 = w + 78 * n;
    double *restrict each6 = w + (SCRATCH + 6 * fibres) * n;
    double *restrict each7 = w + (SCRATCH + 7 * fibres) * n;
    double *restrict each12 = w + (SCRATCH + 12 * fibres) * n;
    double *restrict each13 = w + (SCRATCH + 13 * fibres) * n;
    double *restrict each14 = w + (SCRATCH + 14 * fibres) * n;
    double *restrict each15 = w + (SCRATCH + 15 * fibres) * n;
    const double c7 = 1.0 / p[0];
    const double c10 = squared(p[1]);
    const double c27 = squared(p[9]);
    const double c28 = 0.020833333333333332 * c27;
    const double c29 = 0.020833333333333332 + c28;
    for (int i = 1; i < n - 1; i++) {
        const double v0 = w6[i];
        const double v1 = w6[i - 1];
        const double v4 = g[7 * i + 5];
        const double v14 = 1.0 / (2.0 * g[7 * i + 2]);
        const double v15 = g[7 * i - 6] * v14;
        const double v18 = g[7 * i + 1] * v14;
        const double v36 = (v15 * w10[i - 1]) + (v18 * w10[i]);
        const double v40 = (double)(0.0 <= v36);
        double v39 = 0.0;
        double v46 = 0.0;
        double v49 = 0.0;
        double v53 = 0.0;
        double v58 = 0.0;
        double v60 = 0.0;
        double v83 = 0.0;
        double v96 = 0.0;
        double v101 = 0.0;
        double v106 = 0.0;
        double v117 = 0.0;
        double v122 = 0.0;
        if (v40 != 0.0) {
            const double v20 = (v15 * v1) + (v18 * v0);
            const double v21 = squared(v20);
            const double v23 = 1.0 / squared(v21);
            const double v24 = ((((v0 - v1) * v4) * c7) * c10) * v23;
            const double v30 = v24 * c29;
            const double v37 = larger(0.0, v36);
            v39 = (v30 * v37) * c7;
            const double v45 = (v40 / ((double)(v36 <= 0.0) + v40)) * (v30 * c7);
            v46 = v15 * v45;
            v49 = v18 * v45;
            v53 = v46 * w52[i - 1];
            v58 = (v46 * w53[i - 1]) + (v49 * w52[i]);
            v60 = v49 * w53[i];
            const double v71 = c29 * (v37 * c7);
            const double v74 = (2.0 * v20) * ((2.0 * v21) * ((v24 * v23) * v71));
            const double v79 = ((c10 * (v71 * v23)) * c7) * v4;
            const double v80 = (v15 * v74) + v79;
            v83 = (v46 * w54[i - 1]) - (v80 * w30[i - 1]);
            const double v85 = v79 - (v18 * v74);
            const double v93 = ((v85 * w30[i]) - (v80 * w31[i - 1])) + (v46 * w55[i - 1]);
            v96 = v93 + (v49 * w54[i]);
            v101 = (v85 * w31[i]) + (v49 * w55[i]);
            v106 = (v46 * w56[i - 1]) - (v80 * w32[i - 1]);
            const double v114 = ((v85 * w32[i]) - (v80 * w33[i - 1])) + (v46 * w57[i - 1]);
            v117 = v114 + (v49 * w56[i]);
            v122 = (v85 * w33[i]) + (v49 * w57[i]);
        }
        w13[i] = v39;
        w70[i] = v53;
        w71[i] = v58;
        w72[i] = v60;
        w73[i] = v83;
        w74[i] = v96;
        w75[i] = v101;
        w76[i] = v106;
        w77[i] = v117;
        w78[i] = v122;
        for (int k = 0; k < fibres; k++) {
            double v48 = 0.0;
            double v51 = 0.0;
            double v62 = 0.0;
            double v64 = 0.0;
            if (v40 != 0.0) {
                v48 = v46 * each6[fibres * (i - 1) + k];
                v51 = v49 * each6[fibres * i + k];
                v62 = v46 * each7[fibres * (i - 1) + k];
                v64 = v49 * each7[fibres * i + k];
            }
            each12[fibres * i + k] = v48;
            each13[fibres * i + k] = v51;
            each14[fibres * i + k] = v62;
            each15[fibres * i + k] = v64;
        }
    }
}

static void jacobian_11(int n, int fibres, double *w)
{
    double *restrict w13 = w + 13 * n;
    double *restrict w70 = w + 70 * n;
    double *restrict w71 = w + 71 * n;
    double *restrict w72 = w + 72 * n;
    double *restrict w73 = w + 73 * n;
    double *restrict w74 = w + 74 * n;
    double *restrict w75 = w + 75 * n;
    double *restrict w76 = w + 76 * n;
    double *restrict w77 = w + 77 * n;
    double *restrict w78 = w + 78 * n;
    double *restrict each12 = w + (SCRATCH + 12 * fibres) * n;
    double *restrict each13 = w + (SCRATCH + 13 * fibres) * n;
    double *restrict each14 = w + (SCRATCH + 14 * fibres) * n;
    double *restrict each15 = w + (SCRATCH + 15 * fibres) * n;
    const int i = n - 1;
    w13[i] = 0.0;
    w70[i] = 0.0;
    w71[i] = 0.0;
    w72[i] = 0.0;
    w73[i] = 0.0;
    w74[i] = 0.0;
    w75[i] = 0.0;
    w76[i] = 0.0;
    w77[i] = 0.0;
    w78[i] = 0.0;
    for (int k = 0; k < fibres; k++) {
        each12[fibres * i + k] = 0.0;
        each13[fibres * i + k] = 0.0;
        each14[fibres * i + k] = 0.0;
        each15[fibres * i + k] = 0.0;
    }
    (void)n;
}

static void jacobian_12(int n, int fibres, double *w)
{
    double *restrict w13 = w + 13 * n;
    double *restrict w70 = w + 70 * n;
    double *restrict w71 = w + 71 * n;
    double *restrict w72 = w + 72 * n;
    double *restrict w73 = w + 73 * n;
    double *restrict w74 = w + 74 * n;
    double *restrict w75 = w + 75 * n;
    double *restrict w76 = w + 76 * n;
    double *restrict w77 = w + 77 * n;
    double *restrict w78 = w + 78 * n;
    double *restrict each12 = w + (SCRATCH + 12 * fibres) * n;
    double *restrict each13 = w + (SCRATCH + 13 * fibres) * n;
    double *restrict each14 = w + (SCRATCH + 14 * fibres) * n;
    double *restrict each15 = w + (SCRATCH + 15 * fibres) * n;
    const int i = 0;
    w13[i] = 0.0;
    w70[i] = 0.0;
    w71[i] = 0.0;
    w72[i] = 0.0;
    w73[i] = 0.0;
    w74[i] = 0.0;
    w75[i] = 0.0;
    w76[i] = 0.0;
    w77[i] = 0.0;
    w78[i] = 0.0;
    for (int k = 0; k < fibres; k++) {
        each12[fibres * i + k] = 0.0;
        each13[fibres * i + k] = 0.0;
        each14[fibres * i + k] = 0.0;
        each15[fibres * i + k] = 0.0;
    }
    (void)n;
}

static void jacobian_13(int n, int fibres, const double *p, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    double *restrict w19 = w + 19 * n;
    double *restrict w20 = w + 20 * n;
    double *restrict w21 = w + 21 * n;
    double *restrict w22 = w + 22 * n;
    double *restrict w23 = w + 23 * n;
    double *restrict w24 = w + 24 * n;
    double *restrict w25 = w + 25 * n;
    double *restrict w26 = w + 26 * n;
    double *restrict w27 = w + 27 * n;
    double *restrict w28 = w + 28 * n;
    double *restrict w29 = w + 29 * n;
    double *restrict w30 = w + 30 * n;
    double *restrict w31 = w + 31 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    double *restrict w34 = w + 34 * n;
    double *restrict w35 = w + 35 * n;
    double *restrict w36 = w + 36 * n;
    double *restrict w37 = w + 37 * n;
    double *restrict w38 = w + 38 * n;
    double *restrict w39 = w + 39 * n;
    double *restrict w40 = w + 40 * n;
    double *restrict w41 = w + 41 * n;
    double *restrict w42 = w + 42 * n;
    double *restrict w43 = w + 43 * n;
    double *restrict w44 = w + 44 * n;
    double *restrict w45 = w + 45 * n;
    double *restrict w46 = w + 46 * n;
    double *restrict w47 = w + 47 * n;
    double *restrict w48 = w + 48 * n;
    double *restrict w49 = w + 49 * n;
    double *restrict w50 = w + 50 * n;
    double *restrict w51 = w + 51 * n;
    double *restrict w70 = w + 70 * n;
    double *restrict w71 = w + 71 * n;
    double *restrict w72 = w + 72 * n;
    double *restrict w73 = w + 73 * n;
    double *restrict w74 = w + 74 * n;
    double *restrict w75 = w + 75 * n;
    double *restrict w76 = w + 76 * n;
    double *restrict w77 = w + 77 * n;
    double *restrict w78 = w + 78 * n;
    double *restrict w79 = w + 79 * n;
    double *restrict w80 = w + 80 * n;
    double *restrict w81 = w + 81 * n;
    double *restrict w82 = w + 82 * n;
    double *restrict w83 = w + 83 * n;
    double *restrict w84 = w + 84 * n;
    double *restrict w85 = w + 85 * n;
    double *restrict w86 = w + 86 * n;
    double *restrict w87 = w + 87 * n;
    double *restrict w88 = w + 88 * n;
    double *restrict w89 = w + 89 * n;
    double *restrict w90 = w + 90 * n;
    double *restrict w91 = w + 91 * n;
    double *restrict w92 = w + 92 * n;
    double *restrict w93 = w + 93 * n;
    double *restrict w94 = w + 94 * n;
    double *restrict w95 = w + 95 * n;
    double *restrict w96 = w + 96 * n;
    double *restrict w97 = w + 97 * n;
    double *restrict w98 = w + 98 * n;
    double *restrict w99 = w + 99 * n;
    double *restrict w100 = w + 100 * n;
    double *restrict w101 = w + 101 * n;
    double *restrict w102 = w + 102 * n;
    double *restrict each0 = w + (SCRATCH) * n;
    double *restrict each1 = w + (SCRATCH + 1 * fibres) * n;
    double *restrict each2 = w + (SCRATCH + 2 * fibres) * n;
    double *restrict each3 = w + (SCRATCH + 3 * fibres) * n;
    double *restrict each4 = w + (SCRATCH + 4 * fibres) * n;
    double *restrict each5 = w + (SCRATCH + 5 * fibres) * n;
    double *restrict each12 = w + (SCRATCH + 12 * fibres) * n;
    double *restrict each13 = w + (SCRATCH + 13 * fibres) * n;
    double *restrict each14 = w + (SCRATCH + 14 * fibres) * n;
    double *restrict each15 = w + (SCRATCH + 15 * fibres) * n;
    double *restrict each16 = w + (SCRATCH + 16 * fibres) * n;
    double *restrict each17 = w + (SCRATCH + 17 * fibres) * n;
    double *restrict each18 = w + (SCRATCH + 18 * fibres) * n;
    double *restrict each19 = w + (SCRATCH + 19 * fibres) * n;
    double *restrict each20 = w + (SCRATCH + 20 * fibres) * n;
    double *restrict each21 = w + (SCRATCH + 21 * fibres) * n;
    double *restrict each22 = w + (SCRATCH + 22 * fibres) * n;
    double *restrict each23 = w + (SCRATCH + 23 * fibres) * n;
    double *restrict each24 = w + (SCRATCH + 24 * fibres) * n;
    double *restrict each25 = w + (SCRATCH + 25 * fibres) * n;
    double *restrict each26 = w + (SCRATCH + 26 * fibres) * n;
    double *restrict each27 = w + (SCRATCH + 27 * fibres) * n;
    const double c16 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v5 = (w1[i] + w1[i + 1]) * 0.5;
        const double v6 = cos(v5);
        const double v8 = w3[i];
        const double v9 = 1.0 / v8;
        const double v10 = w7[i] * v9;
        const double v13 = (-0.5) * w5[i];
        const double v14 = w8[i];
        const double v18 = sqrt(v8);
        const double v20 = 1.0 / (v18 * v8);
        const double v22 = (((v13 * v14) * c16) * v20) * v20;
        const double v24 = 1.0 / (2.0 * v18);
        const double v25 = v8 * v24;
        const double v26 = v25 + v18;
        const double v31 = 0.9128709291752768 * w4[i];
        const double v32 = w9[i];
        const double v35 = ((v31 * v32) * v9) * v9;
        const double v36 = (v10 - (v22 * v26)) - v35;
        const double v38 = sin(v5);
        const double v40 = (0.9128709291752768 * v32) * v9;
        const double v42 = (v6 * v36) - (v38 * v40);
        const double v47 = g[7 * i + 4];
        const double v50 = 1.0 / w6[i];
        const double v51 = ((w13[i + 1] - w13[i]) * v47) * v50;
        const double v55 = (w0[i + 1] - w0[i]) * v47;
        const double v59 = (v55 * v50) * v47;
        const double v62 = v6 * v9;
        const double v65 = v26 * v6;
        const double v66 = v65 * v20;
        const double v68 = c16 * (v66 * v20);
        const double v69 = v13 * v68;
        const double v79 = v38 * v9;
        const double v81 = v62 * v9;
        const double v83 = (0.9128709291752768 * v79) + (v31 * v81);
        const double v90 = w70[i];
        const double v92 = w34[i];
        const double v94 = w40[i];
        const double v97 = w71[i];
        const double v100 = w70[i + 1];
        const double v102 = (((v62 * v92) - (v69 * v94)) + (v59 * v97)) - (v59 * v100);
        const double v105 = (v6 * v40) + (v38 * v36);
        const double v106 = 0.5 * v105;
        const double v108 = w46[i];
        const double v111 = v40 * v9;
        const double v113 = v35 * v9;
        const double v118 = v22 * v6;
        const double v120 = (((v111 * v38) + (v113 * v6)) + (v35 * v62)) - (v118 * v24);
        const double v121 = v22 * v20;
        const double v124 = (v121 * v65) + (v22 * v66);
        const double v127 = v25 * v24;
        const double v134 = (v120 + (v18 * v124)) + ((((2.0 * (v127 * v118)) - v118) + (v8 * v124)) * v24);
        const double v135 = v10 * v9;
        const double v137 = v134 - (v135 * v6);
        const double v138 = w16[i];
        const double v142 = 0.9128709291752768 * (v32 * v81);
        const double v143 = w22[i];
        const double v145 = (((v102 - v106) - (v83 * v108)) + (v137 * v138)) - (v142 * v143);
        const double v147 = (-0.5) * (v14 * v68);
        const double v148 = w28[i];
        const double v151 = w35[i];
        const double v153 = w41[i];
        const double v156 = w72[i];
        const double v159 = w71[i + 1];
        const double v161 = (((v62 * v151) - (v69 * v153)) + (v59 * v156)) - (v59 * v159);
        const double v163 = w47[i];
        const double v166 = w17[i];
        const double v169 = w23[i];
        const double v171 = (((v161 - v106) - (v83 * v163)) + (v137 * v166)) - (v142 * v169);
        const double v172 = w29[i];
        const double v175 = w72[i + 1];
        const double v197 = w73[i];
        const double v199 = w36[i];
        const double v201 = w42[i];
        const double v204 = w74[i];
        const double v207 = w73[i + 1];
        const double v209 = (((v62 * v199) - (v69 * v201)) + (v59 * v204)) - (v59 * v207);
        const double v210 = w48[i];
        const double v213 = w18[i];
        const double v216 = w24[i];
        const double v219 = v51 * v50;
        const double v220 = v219 * v55;
        const double v221 = w30[i];
        const double v223 = (((v209 - (v83 * v210)) + (v137 * v213)) - (v142 * v216)) + (v220 * v221);
        const double v224 = v51 * v47;
        const double v226 = w37[i];
        const double v228 = w43[i];
        const double v231 = w75[i];
        const double v234 = w74[i + 1];
        const double v236 = (((v62 * v226) - (v69 * v228)) + (v59 * v231)) - (v59 * v234);
        const double v237 = w49[i];
        const double v240 = w19[i];
        const double v243 = w25[i];
        const double v246 = w31[i];
        const double v248 = (((v236 - (v83 * v237)) + (v137 * v240)) - (v142 * v243)) + (v220 * v246);
        const double v250 = w75[i + 1];
        const double v253 = w76[i];
        const double v255 = w38[i];
        const double v257 = w44[i];
        const double v260 = w77[i];
        const double v263 = w76[i + 1];
        const double v265 = (((v62 * v255) - (v69 * v257)) + (v59 * v260)) - (v59 * v263);
        const double v266 = w50[i];
        const double v269 = w20[i];
        const double v272 = w26[i];
        const double v275 = w32[i];
        const double v277 = (((v265 - (v83 * v266)) + (v137 * v269)) - (v142 * v272)) + (v220 * v275);
        const double v278 = w39[i];
        const double v280 = w45[i];
        const double v283 = w78[i];
        const double v286 = w77[i + 1];
        const double v288 = (((v62 * v278) - (v69 * v280)) + (v59 * v283)) - (v59 * v286);
        const double v289 = w51[i];
        const double v292 = w21[i];
        const double v295 = w27[i];
        const double v298 = w33[i];
        const double v300 = (((v288 - (v83 * v289)) + (v137 * v292)) - (v142 * v295)) + (v220 * v298);
        const double v301 = w78[i + 1];
        const double v307 = (w2[i + 1] - w2[i]) * v47;
        const double v311 = (v307 * v50) * v47;
        const double v314 = v26 * v38;
        const double v315 = v314 * v20;
        const double v317 = c16 * (v315 * v20);
        const double v318 = v13 * v317;
        const double v326 = v79 * v9;
        const double v328 = (0.9128709291752768 * v62) - (v31 * v326);
        const double v340 = (((v79 * v92) - (v318 * v94)) + (v311 * v97)) - (v311 * v100);
        const double v341 = 0.5 * v42;
        const double v350 = v22 * v38;
        const double v352 = (((v113 * v38) - (v111 * v6)) + (v35 * v79)) - (v350 * v24);
        const double v355 = (v121 * v314) + (v22 * v315);
        const double v364 = (v352 + (v18 * v355)) + ((((2.0 * (v127 * v350)) - v350) + (v8 * v355)) * v24);
        const double v366 = v364 - (v135 * v38);
        const double v370 = 0.9128709291752768 * (v32 * v326);
        const double v372 = (((v340 + v341) + (v328 * v108)) + (v366 * v138)) - (v370 * v143);
        const double v374 = (-0.5) * (v14 * v317);
        const double v383 = (((v79 * v151) - (v318 * v153)) + (v311 * v156)) - (v311 * v159);
        const double v390 = (((v383 + v341) + (v328 * v163)) + (v366 * v166)) - (v370 * v169);
        const double v414 = (((v79 * v199) - (v318 * v201)) + (v311 * v204)) - (v311 * v207);
        const double v421 = v219 * v307;
        const double v423 = (((v414 + (v328 * v210)) + (v366 * v213)) - (v370 * v216)) + (v421 * v221);
        const double v430 = (((v79 * v226) - (v318 * v228)) + (v311 * v231)) - (v311 * v234);
        const double v438 = (((v430 + (v328 * v237)) + (v366 * v240)) - (v370 * v243)) + (v421 * v246);
        const double v448 = (((v79 * v255) - (v318 * v257)) + (v311 * v260)) - (v311 * v263);
        const double v456 = (((v448 + (v328 * v266)) + (v366 * v269)) - (v370 * v272)) + (v421 * v275);
        const double v464 = (((v79 * v278) - (v318 * v280)) + (v311 * v283)) - (v311 * v286);
        const double v472 = (((v464 + (v328 * v289)) + (v366 * v292)) - (v370 * v295)) + (v421 * v298);
        w14[i] = v42 - (v51 * v55);
        w79[i] = v59 * v90;
        w80[i] = v145 - (v147 * v148);
        w81[i] = v171 - (v147 * v172);
        w82[i] = -(v59 * v175);
        w83[i] = v59 * v197;
        w84[i] = v223 + v224;
        w85[i] = v248 - v224;
        w86[i] = -(v59 * v250);
        w87[i] = v59 * v253;
        w88[i] = v277;
        w89[i] = v300;
        w90[i] = -(v59 * v301);
        w15[i] = v105 - (v51 * v307);
        w91[i] = v311 * v90;
        w92[i] = v372 - (v374 * v148);
        w93[i] = v390 - (v374 * v172);
        w94[i] = -(v311 * v175);
        w95[i] = v311 * v197;
        w96[i] = v423;
        w97[i] = v438;
        w98[i] = -(v311 * v250);
        w99[i] = v311 * v253;
        w100[i] = v456 + v224;
        w101[i] = v472 - v224;
        w102[i] = -(v311 * v301);
        for (int k = 0; k < fibres; k++) {
            const double v60 = each12[fibres * i + k];
            const double v63 = each0[fibres * i + k];
            const double v70 = each2[fibres * i + k];
            const double v73 = each13[fibres * i + k];
            const double v76 = each12[fibres * (i + 1) + k];
            const double v84 = each4[fibres * i + k];
            const double v86 = ((((v62 * v63) - (v69 * v70)) + (v59 * v73)) - (v59 * v76)) - (v83 * v84);
            const double v87 = each13[fibres * (i + 1) + k];
            const double v178 = each14[fibres * i + k];
            const double v180 = each1[fibres * i + k];
            const double v182 = each3[fibres * i + k];
            const double v185 = each15[fibres * i + k];
            const double v188 = each14[fibres * (i + 1) + k];
            const double v190 = (((v62 * v180) - (v69 * v182)) + (v59 * v185)) - (v59 * v188);
            const double v191 = each5[fibres * i + k];
            const double v194 = each15[fibres * (i + 1) + k];
            const double v324 = (((v79 * v63) - (v318 * v70)) + (v311 * v73)) - (v311 * v76);
            const double v402 = (((v79 * v180) - (v318 * v182)) + (v311 * v185)) - (v311 * v188);
            each16[fibres * i + k] = v59 * v60;
            each17[fibres * i + k] = v86;
            each18[fibres * i + k] = -(v59 * v87);
            each19[fibres * i + k] = v59 * v178;
            each20[fibres * i + k] = v190 - (v83 * v191);
            each21[fibres * i + k] = -(v59 * v194);
            each22[fibres * i + k] = v311 * v60;
            each23[fibres * i + k] = v324 + (v328 * v84);
            each24[fibres * i + k] = -(v311 * v87);
            each25[fibres * i + k] = v311 * v178;
            each26[fibres * i + k] = v402 + (v328 * v191);
            each27[fibres * i + k] = -(v311 * v194);
        }
    }
}

static void jacobian_14(int n, int fibres, int entries, const double *p, const double *g, double *w, double *e)
{
    double *restrict w79 = w + 79 * n;
    double *restrict w80 = w + 80 * n;
    double *restrict w81 = w + 81 * n;
    double *restrict w82 = w + 82 * n;
    double *restrict w83 = w + 83 * n;
    double *restrict w84 = w + 84 * n;
    double *restrict w85 = w + 85 * n;
    double *restrict w86 = w + 86 * n;
    double *restrict w87 = w + 87 * n;
    double *restrict w88 = w + 88 * n;
    double *restrict w89 = w + 89 * n;
    double *restrict w90 = w + 90 * n;
    double *restrict each16 = w + (SCRATCH + 16 * fibres) * n;
    double *restrict each17 = w + (SCRATCH + 17 * fibres) * n;
    double *restrict each18 = w + (SCRATCH + 18 * fibres) * n;
    double *restrict each19 = w + (SCRATCH + 19 * fibres) * n;
    double *restrict each20 = w + (SCRATCH + 20 * fibres) * n;
    double *restrict each21 = w + (SCRATCH + 21 * fibres) * n;
    const double c1 = squared(p[10]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[entries * i + 4] = -(v9 * w79[i - 1]);
        e[entries * i + 7] = (v9 * w79[i]) - (v9 * w80[i - 1]);
        e[entries * i + 10] = (v9 * w80[i]) - (v9 * w81[i - 1]);
        e[entries * i + 13] = (v9 * w81[i]) - (v9 * w82[i - 1]);
        e[entries * i + 16] = v9 * w82[i];
        e[entries * i + 2] = -(v9 * w83[i - 1]);
        e[entries * i + 5] = (v9 * w83[i]) - (v9 * w84[i - 1]);
        e[entries * i + 8] = (v9 * w84[i]) - (v9 * w85[i - 1]);
        e[entries * i + 11] = (v9 * w85[i]) - (v9 * w86[i - 1]);
        e[entries * i + 14] = v9 * w86[i];
        e[entries * i + 3] = -(v9 * w87[i - 1]);
        e[entries * i + 6] = (v9 * w87[i]) - (v9 * w88[i - 1]);
        e[entries * i + 9] = (v9 * w88[i]) - (v9 * w89[i - 1]);
        e[entries * i + 12] = (v9 * w89[i]) - (v9 * w90[i - 1]);
        e[entries * i + 15] = v9 * w90[i];
        for (int k = 0; k < fibres; k++) {
            const double v17 = (v9 * each16[fibres * i + k]) - (v9 * each17[fibres * (i - 1) + k]);
            const double v22 = (v9 * each17[fibres * i + k]) - (v9 * each18[fibres * (i - 1) + k]);
            const double v52 = (v9 * each19[fibres * i + k]) - (v9 * each20[fibres * (i - 1) + k]);
            const double v57 = (v9 * each20[fibres * i + k]) - (v9 * each21[fibres * (i - 1) + k]);
            e[entries * i + 41 + k] = -(v9 * each16[fibres * (i - 1) + k]);
            e[entries * i + 41 + 2 * fibres + k] = v17;
            e[entries * i + 41 + 4 * fibres + k] = v22;
            e[entries * i + 41 + 6 * fibres + k] = v9 * each18[fibres * i + k];
            e[entries * i + 41 + 1 * fibres + k] = -(v9 * each19[fibres * (i - 1) + k]);
            e[entries * i + 41 + 3 * fibres + k] = v52;
            e[entries * i + 41 + 5 * fibres + k] = v57;
            e[entries * i + 41 + 7 * fibres + k] = v9 * each21[fibres * i + k];
        }
    }
}

static void jacobian_15(int n, int fibres, int entries, const double *p, const double *g, double *w, double *e)
{
    double *restrict w91 = w + 91 * n;
    double *restrict w92 = w + 92 * n;
    double *restrict w93 = w + 93 * n;
    double *restrict w94 = w + 94 * n;
    double *restrict w95 = w + 95 * n;
    double *restrict w96 = w + 96 * n;
    double *restrict w97 = w + 97 * n;
    double *restrict w98 = w + 98 * n;
    double *restrict w99 = w + 99 * n;
    double *restrict w100 = w + 100 * n;
    double *restrict w101 = w + 101 * n;
    double *restrict w102 = w + 102 * n;
    double *restrict each22 = w + (SCRATCH + 22 * fibres) * n;
    double *restrict each23 = w + (SCRATCH + 23 * fibres) * n;
    double *restrict each24 = w + (SCRATCH + 24 * fibres) * n;
    double *restrict each25 = w + (SCRATCH + 25 * fibres) * n;
    double *restrict each26 = w + (SCRATCH + 26 * fibres) * n;
    double *restrict each27 = w + (SCRATCH + 27 * fibres) * n;
    const double c1 = squared(p[10]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[entries * i + 19] = -(v9 * w91[i - 1]);
        e[entries * i + 22] = (v9 * w91[i]) - (v9 * w92[i - 1]);
        e[entries * i + 25] = (v9 * w92[i]) - (v9 * w93[i - 1]);
        e[entries * i + 28] = (v9 * w93[i]) - (v9 * w94[i - 1]);
        e[entries * i + 31] = v9 * w94[i];
        e[entries * i + 17] = -(v9 * w95[i - 1]);
        e[entries * i + 20] = (v9 * w95[i]) - (v9 * w96[i - 1]);
        e[entries * i + 23] = (v9 * w96[i]) - (v9 * w97[i - 1]);
        e[entries * i + 26] = (v9 * w97[i]) - (v9 * w98[i - 1]);
        e[entries * i + 29] = v9 * w98[i];
        e[entries * i + 18] = -(v9 * w99[i - 1]);
        e[entries * i + 21] = (v9 * w99[i]) - (v9 * w100[i - 1]);
        e[entries * i + 24] = (v9 * w100[i]) - (v9 * w101[i - 1]);
        e[entries * i + 27] = (v9 * w101[i]) - (v9 * w102[i - 1]);
        e[entries * i + 30] = v9 * w102[i];
        for (int k = 0; k < fibres; k++) {
            const double v17 = (v9 * each22[fibres * i + k]) - (v9 * each23[fibres * (i - 1) + k]);
            const double v22 = (v9 * each23[fibres * i + k]) - (v9 * each24[fibres * (i - 1) + k]);
            const double v52 = (v9 * each25[fibres * i + k]) - (v9 * each26[fibres * (i - 1) + k]);
            const double v57 = (v9 * each26[fibres * i + k]) - (v9 * each27[fibres * (i - 1) + k]);
            e[entries * i + 41 + 8 * fibres + k] = -(v9 * each22[fibres * (i - 1) + k]);
            e[entries * i + 41 + 10 * fibres + k] = v17;
            e[entries * i + 41 + 12 * fibres + k] = v22;
            e[entries * i + 41 + 14 * fibres + k] = v9 * each24[fibres * i + k];
            e[entries * i + 41 + 9 * fibres + k] = -(v9 * each25[fibres * (i - 1) + k]);
            e[entries * i + 41 + 11 * fibres + k] = v52;
            e[entries * i + 41 + 13 * fibres + k] = v57;
            e[entries * i + 41 + 15 * fibres + k] = v9 * each27[fibres * i + k];
        }
    }
}

static void jacobian_16(int n, int fibres, int entries, const double *p, const double *g, double *w, double *e)
{
    double *restrict w91 = w + 91 * n;
    double *restrict w92 = w + 92 * n;
    double *restrict w93 = w + 93 * n;
    double *restrict w94 = w + 94 * n;
    double *restrict w95 = w + 95 * n;
    double *restrict w96 = w + 96 * n;
    double *restrict w97 = w + 97 * n;
    double *restrict w98 = w + 98 * n;
    double *restrict w99 = w + 99 * n;
    double *restrict w100 = w + 100 * n;
    double *restrict w101 = w + 101 * n;
    double *restrict w102 = w + 102 * n;
    double *restrict each22 = w + (SCRATCH + 22 * fibres) * n;
    double *restrict each23 = w + (SCRATCH + 23 * fibres) * n;
    double *restrict each24 = w + (SCRATCH + 24 * fibres) * n;
    double *restrict each25 = w + (SCRATCH + 25 * fibres) * n;
    double *restrict each26 = w + (SCRATCH + 26 * fibres) * n;
    double *restrict each27 = w + (SCRATCH + 27 * fibres) * n;
    const double c1 = squared(p[10]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[entries * i + 22] = v9 * w91[i];
    e[entries * i + 25] = v9 * w92[i];
    e[entries * i + 28] = v9 * w93[i];
    e[entries * i + 31] = v9 * w94[i];
    e[entries * i + 20] = v9 * w95[i];
    e[entries * i + 23] = v9 * w96[i];
    e[entries * i + 26] = v9 * w97[i];
    e[entries * i + 29] = v9 * w98[i];
    e[entries * i + 21] = v9 * w99[i];
    e[entries * i + 24] = v9 * w100[i];
    e[entries * i + 27] = v9 * w101[i];
    e[entries * i + 30] = v9 * w102[i];
    for (int k = 0; k < fibres; k++) {
        e[entries * i + 41 + 10 * fibres + k] = v9 * each22[fibres * i + k];
        e[entries * i + 41 + 12 * fibres + k] = v9 * each23[fibres * i + k];
        e[entries * i + 41 + 14 * fibres + k] = v9 * each24[fibres * i + k];
        e[entries * i + 41 + 11 * fibres + k] = v9 * each25[fibres * i + k];
        e[entries * i + 41 + 13 * fibres + k] = v9 * each26[fibres * i + k];
        e[entries * i + 41 + 15 * fibres + k] = v9 * each27[fibres * i + k];
    }
    (void)n;
}

static void rates_in_time_15(int n, int slots, double t, const double *p, double *f)
{
    const double c0 = p[10];
    const double c1 = squared(c0);
    const double c3 = c1 / p[0];
    const double c10 = t * c0;
    const double c11 = p[4];
    const double c12 = c10 / c11;
    const double c13 = larger(0.0, c12);
    const double c14 = smaller(1.0, c13);
    const double c15 = 6.0 * c14;
    const double c16 = (-15.0) + c15;
    const double c17 = c16 * c14;
    const double c18 = 10.0 + c17;
    const double c19 = p[3];
    const double c20 = 2.0 * c14;
    const double c21 = (double)(c13 <= 1.0);
    const double c22 = (double)(1.0 <= c13);
    const double c23 = c22 + c21;
    const double c24 = c21 / c23;
    const double c25 = (double)(0.0 <= c12);
    const double c26 = (double)(c12 <= 0.0);
    const double c27 = c26 + c25;
    const double c28 = c25 / c27;
    const double c29 = c0 / c11;
    const double c30 = c28 * c29;
    const double c31 = c24 * c30;
    const double c32 = c20 * c31;
    const double c33 = c14 * c32;
    const double c34 = squared(c14);
    const double c35 = c34 * c31;
    const double c36 = c33 + c35;
    const double c37 = c19 * c36;
    const double c38 = c18 * c37;
    const double c39 = c34 * c14;
    const double c40 = c19 * c39;
    const double c41 = 6.0 * c31;
    const double c42 = c14 * c41;
    const double c43 = c16 * c31;
    const double c44 = c42 + c43;
    const double c45 = c40 * c44;
    const double c46 = c38 + c45;
    const double c47 = c3 * c46;
    const double c48 = -c47;
    for (int i = 1; i < n - 1; i++) {
        f[slots * i + 3] = c48;
    }
}

static void rates_in_time_16(int n, int slots, double t, const double *p, double *f)
{
    const double c0 = p[10];
    const double c1 = squared(c0);
    const double c3 = c1 / p[0];
    const double c10 = t * c0;
    const double c11 = p[4];
    const double c12 = c10 / c11;
    const double c13 = larger(0.0, c12);
    const double c14 = smaller(1.0, c13);
    const double c15 = 6.0 * c14;
    const double c16 = (-15.0) + c15;
    const double c17 = c16 * c14;
    const double c18 = 10.0 + c17;
    const double c19 = p[3];
    const double c20 = 2.0 * c14;
    const double c21 = (double)(c13 <= 1.0);
    const double c22 = (double)(1.0 <= c13);
    const double c23 = c22 + c21;
    const double c24 = c21 / c23;
    const double c25 = (double)(0.0 <= c12);
    const double c26 = (double)(c12 <= 0.0);
    const double c27 = c26 + c25;
    const double c28 = c25 / c27;
    const double c29 = c0 / c11;
    const double c30 = c28 * c29;
    const double c31 = c24 * c30;
    const double c32 = c20 * c31;
    const double c33 = c14 * c32;
    const double c34 = squared(c14);
    const double c35 = c34 * c31;
    const double c36 = c33 + c35;
    const double c37 = c19 * c36;
    const double c38 = c18 * c37;
    const double c39 = c34 * c14;
    const double c40 = c19 * c39;
    const double c41 = 6.0 * c31;
    const double c42 = c14 * c41;
    const double c43 = c16 * c31;
    const double c44 = c42 + c43;
    const double c45 = c40 * c44;
    const double c46 = c38 + c45;
    const double c47 = c3 * c46;
    const double c48 = -c47;
    const int i = 0;
    f[slots * i + 3] = c48;
    (void)n;
}

static void work_0(int n, int fibres, int slots, const double *zeta, const double *weight, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w103 = w + 103 * n;
    const double c1 = p[7];
    const double c2 = p[5];
    const double c40 = 1.0 + p[8];
    const double c41 = c2 / c40;
    const double c49 = 1e-12 * c2;
    const double c50 = squared(c49);
    const double c56 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum12 = 0.0;
        const double v5 = (-0.5) * w5[i];
        const double v10 = w3[i];
        const double v12 = sqrt(v10) * v10;
        const double v14 = log(v10);
        const double v22 = (0.9128709291752768 * w4[i]) / v10;
        for (int k = 0; k < fibres; k++) {
            const double v17 = ((((v5 * zeta[k]) * p[1]) / v12) + v14) - y[slots * i + 5 + k];
            const double v26 = exp((-1.5) * v17);
            const double v28 = v22 - (y[slots * i + 5 + 1 * fibres + k] * v26);
            const double v32 = c2 * (v17 + (0.25 * squared(v28)));
            const double v36 = 0.5 * v28;
            const double v47 = squared(v32) + (3.0 * squared((((v32 * v36) + (c41 * v36)) * v26)));
            const double v52 = sqrt(larger(v47, c50));
            const double v61 = (double)(c1 < v52) != 0.0 ? ((v52 * ((v52 - c1) * c56)) * weight[k]) : 0.0;
            sum12 += v61;
        }
        w103[i] = sum12;
    }
}

static void work_1(int n, double t, const double *p, const double *g, double *w, double *q)
{
    double *restrict w2 = w + 2 * n;
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = 30.0 * p[3];
    const double c10 = p[10];
    const double c11 = t * c10;
    const double c12 = p[4];
    const double c13 = c11 / c12;
    const double c14 = larger(0.0, c13);
    const double c15 = smaller(1.0, c14);
    const double c16 = 1.0 - c15;
    const double c17 = squared(c16);
    const double c18 = c6 * c17;
    const double c19 = squared(c15);
    const double c20 = c18 * c19;
    const double c21 = c20 / c12;
    const double c22 = c3 * c21;
    const double c23 = c1 / c10;
    const double c24 = squared(c23);
    const double c25 = c2 * c24;
    const double c26 = c10 / c25;
    const double c27 = c22 * c26;
    for (int i = 0; i < n; i++) {
        q[1] += g[7 * i + 3] * (c27 * w2[i]);
    }
}

static void work_2(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w103 = w + 103 * n;
    const double c3 = p[10];
    const double c6 = p[0] / c3;
    const double c7 = squared(c6);
    const double c8 = p[2] * c7;
    const double c9 = c3 / c8;
    for (int i = 0; i < n - 1; i++) {
        q[0] += (g[7 * i + 1] * w103[i]) * c9;
    }
}

static void work_3(int n, int slots, const double *y, double *w)
{
    double *restrict w104 = w + 104 * n;
    for (int i = 1; i < n - 1; i++) {
        w104[i] = y[slots * i + 2];
    }
}

static void work_4(int n, int slots, const double *y, double *w)
{
    double *restrict w105 = w + 105 * n;
    for (int i = 0; i < n - 1; i++) {
        w105[i] = y[slots * i + 3];
    }
}

static void work_5(int n, double *w)
{
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    const int i = n - 1;
    w104[i] = 0.0;
    w105[i] = 0.0;
    (void)n;
}

static void work_6(int n, double *w)
{
    double *restrict w104 = w + 104 * n;
    const int i = 0;
    w104[i] = 0.0;
    (void)n;
}

static void work_7(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    const double c48 = p[0] / p[10];
    const double c49 = squared(c48);
    const double c50 = p[2] * c49;
    const double c51 = 1.0 / c50;
    for (int i = 1; i < n - 1; i++) {
        const double v2 = w0[i];
        const double v5 = g[7 * i + 4];
        const double v8 = w104[i];
        const double v13 = w2[i];
        const double v17 = w105[i];
        const double v21 = (((w0[i + 1] - v2) * v5) * ((w104[i + 1] - v8) * v5)) + (((w2[i + 1] - v13) * v5) * ((w105[i + 1] - v17) * v5));
        const double v27 = g[7 * i - 3];
        const double v40 = (((v2 - w0[i - 1]) * v27) * ((v8 - w104[i - 1]) * v27)) + (((v13 - w2[i - 1]) * v27) * ((v17 - w105[i - 1]) * v27));
        q[2] += (w13[i] * ((v21 / w6[i]) - (v40 / w6[i - 1]))) * c51;
    }
}

static void work_slope_0(int n, int fibres, int slots, const double *zeta, const double *weight, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    double *restrict w19 = w + 19 * n;
    double *restrict w20 = w + 20 * n;
    double *restrict w21 = w + 21 * n;
    double *restrict w22 = w + 22 * n;
    double *restrict w23 = w + 23 * n;
    double *restrict w24 = w + 24 * n;
    double *restrict w25 = w + 25 * n;
    double *restrict w26 = w + 26 * n;
    double *restrict w27 = w + 27 * n;
    double *restrict w28 = w + 28 * n;
    double *restrict w29 = w + 29 * n;
    double *restrict w103 = w + 103 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict each28 = w + (SCRATCH + 28 * fibres) * n;
    double *restrict each29 = w + (SCRATCH + 29 * fibres) * n;
    const double c1 = p[7];
    const double c2 = p[5];
    const double c8 = p[1];
    const double c42 = 1.0 + p[8];
    const double c43 = c2 / c42;
    const double c51 = 1e-12 * c2;
    const double c52 = squared(c51);
    const double c63 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum12 = 0.0;
        double sum13 = 0.0;
        double sum14 = 0.0;
        double sum15 = 0.0;
        const double v5 = (-0.5) * w5[i];
        const double v10 = w3[i];
        const double v11 = sqrt(v10);
        const double v13 = 1.0 / (v11 * v10);
        const double v15 = log(v10);
        const double v23 = 1.0 / v10;
        const double v24 = (0.9128709291752768 * w4[i]) * v23;
        const double v145 = v24 * v23;
        const double v153 = 2.0 * v11;
        for (int k = 0; k < fibres; k++) {
            const double v6 = zeta[k];
            const double v14 = ((v5 * v6) * c8) * v13;
            const double v18 = (v14 + v15) - y[slots * i + 5 + k];
            const double v25 = y[slots * i + 5 + 1 * fibres + k];
            const double v28 = exp((-1.5) * v18);
            const double v30 = v24 - (v25 * v28);
            const double v34 = c2 * (v18 + (0.25 * squared(v30)));
            const double v38 = 0.5 * v30;
            const double v45 = (v34 * v38) + (c43 * v38);
            const double v46 = v45 * v28;
            const double v49 = squared(v34) + (3.0 * squared(v46));
            const double v54 = sqrt(larger(v49, c52));
            const double v55 = (double)(c1 < v54);
            const double v65 = weight[k];
            double v98 = 0.0;
            double v120 = 0.0;
            if (v55 != 0.0) {
                const double v57 = (double)(c52 <= v49);
                const double v64 = (v54 - c1) * c63;
                const double v72 = (v57 / (v57 + (double)(v49 <= c52))) * (((v64 * v65) + ((v54 * v65) * c63)) / (2.0 * v54));
                const double v74 = (2.0 * v46) * (3.0 * v72);
                const double v78 = v28 * v74;
                const double v83 = c2 * ((v38 * v78) + ((2.0 * v34) * v72));
                const double v92 = (0.5 * ((c43 * v78) + (v34 * v78))) + ((2.0 * v30) * (0.25 * v83));
                const double v96 = (((-1.5) * (v28 * (v45 * v74))) + v83) - ((-1.5) * (v28 * (v25 * v92)));
                v98 = -v96;
                v120 = -(v28 * v92);
                sum12 += (v54 * v64) * v65;
                const double v149 = (v14 * v13) * v96;
                const double v155 = (((v96 * v23) - (v145 * v92)) - (v11 * v149)) - ((v10 * v149) / v153);
                sum13 += v155;
                sum14 += 0.9128709291752768 * (v92 * v23);
                sum15 += (-0.5) * (v6 * (c8 * (v96 * v13)));
            }
            each28[fibres * i + k] = v98;
            each29[fibres * i + k] = v120;
        }
        const double v99 = sum13;
        const double v102 = sum14;
        const double v106 = sum15;
        w103[i] = sum12;
        w106[i] = ((v99 * w16[i]) + (v102 * w22[i])) + (v106 * w28[i]);
        w107[i] = ((v99 * w17[i]) + (v102 * w23[i])) + (v106 * w29[i]);
        w108[i] = (v99 * w18[i]) + (v102 * w24[i]);
        w109[i] = (v99 * w19[i]) + (v102 * w25[i]);
        w110[i] = (v99 * w20[i]) + (v102 * w26[i]);
        w111[i] = (v99 * w21[i]) + (v102 * w27[i]);
    }
}

static void work_slope_1(int n, int slots, double t, const double *p, const double *g, double *s)
{
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = 30.0 * p[3];
    const double c10 = p[10];
    const double c11 = t * c10;
    const double c12 = p[4];
    const double c13 = c11 / c12;
    const double c14 = larger(0.0, c13);
    const double c15 = smaller(1.0, c14);
    const double c16 = 1.0 - c15;
    const double c17 = squared(c16);
    const double c18 = c6 * c17;
    const double c19 = squared(c15);
    const double c20 = c18 * c19;
    const double c21 = c20 / c12;
    const double c22 = c3 * c21;
    const double c23 = c1 / c10;
    const double c24 = squared(c23);
    const double c25 = c2 * c24;
    const double c26 = c10 / c25;
    const double c27 = c22 * c26;
    for (int i = 0; i < n; i++) {
        s[slots * n + slots * i + 1] += g[7 * i + 3] * c27;
    }
}

static void work_slope_2(int n, int fibres, int slots, const double *p, const double *g, double *w, double *s)
{
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict each28 = w + (SCRATCH + 28 * fibres) * n;
    double *restrict each29 = w + (SCRATCH + 29 * fibres) * n;
    const double c0 = p[10];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v8 = c6 * g[7 * i + 1];
        s[slots * i + 4] += v8 * w106[i];
        s[slots * (i + 1) + 4] += v8 * w107[i];
        s[slots * i + 0] += v8 * w108[i];
        s[slots * (i + 1) + 0] += v8 * w109[i];
        s[slots * i + 1] += v8 * w110[i];
        s[slots * (i + 1) + 1] += v8 * w111[i];
        for (int k = 0; k < fibres; k++) {
            s[slots * i + 5 + k] += v8 * each28[fibres * i + k];
            s[slots * i + 5 + 1 * fibres + k] += v8 * each29[fibres * i + k];
        }
    }
}

static void work_slope_3(int n, int slots, const double *y, double *w)
{
    double *restrict w104 = w + 104 * n;
    for (int i = 1; i < n - 1; i++) {
        w104[i] = y[slots * i + 2];
    }
}

static void work_slope_4(int n, int slots, const double *y, double *w)
{
    double *restrict w105 = w + 105 * n;
    for (int i = 0; i < n - 1; i++) {
        w105[i] = y[slots * i + 3];
    }
}

static void work_slope_5(int n, double *w)
{
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    const int i = n - 1;
    w104[i] = 0.0;
    w105[i] = 0.0;
    (void)n;
}

static void work_slope_6(int n, double *w)
{
    double *restrict w104 = w + 104 * n;
    const int i = 0;
    w104[i] = 0.0;
    (void)n;
}

static void work_slope_7(int n, int fibres, int slots, const double *p, const double *g, double *w, double *s)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w30 = w + 30 * n;
    double *restrict w31 = w + 31 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    double *restrict w70 = w + 70 * n;
    double *restrict w71 = w + 71 * n;
    double *restrict w72 = w + 72 * n;
    double *restrict w73 = w + 73 * n;
    double *restrict w74 = w + 74 * n;
    double *restrict w75 = w + 75 * n;
    double *restrict w76 = w + 76 * n;
    double *restrict w77 = w + 77 * n;
    double *restrict w78 = w + 78 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    double *restrict each12 = w + (SCRATCH + 12 * fibres) * n;
    double *restrict each13 = w + (SCRATCH + 13 * fibres) * n;
    double *restrict each14 = w + (SCRATCH + 14 * fibres) * n;
    double *restrict each15 = w + (SCRATCH + 15 * fibres) * n;
    const double c48 = p[0] / p[10];
    const double c49 = squared(c48);
    const double c50 = p[2] * c49;
    const double c51 = 1.0 / c50;
    for (int i = 1; i < n - 1; i++) {
        const double v1 = w0[i];
        const double v4 = g[7 * i + 4];
        const double v5 = (w0[i + 1] - v1) * v4;
        const double v7 = w104[i];
        const double v9 = (w104[i + 1] - v7) * v4;
        const double v12 = w2[i];
        const double v14 = (w2[i + 1] - v12) * v4;
        const double v16 = w105[i];
        const double v18 = (w105[i + 1] - v16) * v4;
        const double v22 = 1.0 / w6[i];
        const double v23 = ((v5 * v9) + (v14 * v18)) * v22;
        const double v27 = g[7 * i - 3];
        const double v28 = (v1 - w0[i - 1]) * v27;
        const double v31 = (v7 - w104[i - 1]) * v27;
        const double v35 = (v12 - w2[i - 1]) * v27;
        const double v38 = (v16 - w105[i - 1]) * v27;
        const double v42 = 1.0 / w6[i - 1];
        const double v43 = ((v28 * v31) + (v35 * v38)) * v42;
        const double v52 = (v23 - v43) * c51;
        const double v68 = w13[i] * c51;
        const double v69 = v68 * v42;
        const double v71 = (v28 * v69) * v27;
        const double v72 = v68 * v22;
        const double v74 = (v5 * v72) * v4;
        const double v78 = (v35 * v69) * v27;
        const double v80 = (v14 * v72) * v4;
        const double v86 = (v43 * v42) * v68;
        const double v91 = (v31 * v69) * v27;
        const double v99 = (v23 * v22) * v68;
        const double v104 = (v9 * v72) * v4;
        const double v106 = (((v52 * w74[i]) + (v86 * w31[i - 1])) - (v99 * w30[i])) - (v91 + v104);
        const double v119 = (v38 * v69) * v27;
        const double v130 = (v18 * v72) * v4;
        const double v132 = (((v52 * w77[i]) + (v86 * w33[i - 1])) - (v99 * w32[i])) - (v119 + v130);
        s[2 * slots * n + slots * (i - 1) + 4] += v52 * w70[i];
        s[2 * slots * n + slots * i + 4] += v52 * w71[i];
        s[2 * slots * n + slots * (i + 1) + 4] += v52 * w72[i];
        s[2 * slots * n + slots * (i - 1) + 2] += v71;
        s[2 * slots * n + slots * i + 2] += -(v71 + v74);
        s[2 * slots * n + slots * (i + 1) + 2] += v74;
        s[2 * slots * n + slots * (i - 1) + 3] += v78;
        s[2 * slots * n + slots * i + 3] += -(v78 + v80);
        s[2 * slots * n + slots * (i + 1) + 3] += v80;
        s[2 * slots * n + slots * (i - 1) + 0] += ((v52 * w73[i]) + (v86 * w30[i - 1])) + v91;
        s[2 * slots * n + slots * i + 0] += v106;
        s[2 * slots * n + slots * (i + 1) + 0] += ((v52 * w75[i]) - (v99 * w31[i])) + v104;
        s[2 * slots * n + slots * (i - 1) + 1] += ((v52 * w76[i]) + (v86 * w32[i - 1])) + v119;
        s[2 * slots * n + slots * i + 1] += v132;
        s[2 * slots * n + slots * (i + 1) + 1] += ((v52 * w78[i]) - (v99 * w33[i])) + v130;
        for (int k = 0; k < fibres; k++) {
            s[2 * slots * n + slots * (i - 1) + 5 + k] += v52 * each12[fibres * i + k];
            s[2 * slots * n + slots * i + 5 + k] += v52 * each13[fibres * i + k];
            s[2 * slots * n + slots * (i - 1) + 5 + 1 * fibres + k] += v52 * each14[fibres * i + k];
            s[2 * slots * n + slots * i + 5 + 1 * fibres + k] += v52 * each15[fibres * i + k];
        }
    }
}

static void work_in_time_1(int n, double t, const double *p, const double *g, double *w, double *q)
{
    double *restrict w2 = w + 2 * n;
    const double c2 = p[10];
    const double c3 = p[2];
    const double c4 = p[0];
    const double c5 = c4 / c2;
    const double c6 = squared(c5);
    const double c7 = c3 * c6;
    const double c8 = c2 / c7;
    const double c9 = c4 * c3;
    const double c12 = 30.0 * p[3];
    const double c16 = t * c2;
    const double c17 = p[4];
    const double c18 = c16 / c17;
    const double c19 = larger(0.0, c18);
    const double c20 = smaller(1.0, c19);
    const double c21 = 1.0 - c20;
    const double c22 = squared(c21);
    const double c23 = c12 * c22;
    const double c24 = 2.0 * c20;
    const double c25 = (double)(c19 <= 1.0);
    const double c26 = (double)(1.0 <= c19);
    const double c27 = c26 + c25;
    const double c28 = c25 / c27;
    const double c29 = (double)(0.0 <= c18);
    const double c30 = (double)(c18 <= 0.0);
    const double c31 = c30 + c29;
    const double c32 = c29 / c31;
    const double c33 = c2 / c17;
    const double c34 = c32 * c33;
    const double c35 = c28 * c34;
    const double c36 = c24 * c35;
    const double c37 = c23 * c36;
    const double c38 = squared(c20);
    const double c39 = 2.0 * c21;
    const double c40 = c39 * c35;
    const double c41 = c12 * c40;
    const double c42 = c38 * c41;
    const double c43 = c37 - c42;
    const double c44 = c43 / c17;
    const double c45 = c9 * c44;
    const double c46 = c8 * c45;
    for (int i = 0; i < n; i++) {
        q[1] += g[7 * i + 3] * (w2[i] * c46);
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const int fibres = FIBRES;
    const int slots = SLOTS;
    const double *zeta = fibre_zeta;
    const double *weight = fibre_weight;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * slots; k++) f[k] = 0.0;
    rates_0(n, slots, y, f);
    rates_1(n, slots, y, f);
    rates_2(n, slots, y, w);
    rates_3(n, slots, y, w);
    rates_4(n, w);
    rates_5(n, w);
    rates_6(n, p, g, w);
    rates_7(n, fibres, slots, zeta, weight, p, y, w, f);
    rates_8(n, p, g, w);
    rates_9(n, slots, p, g, w, f);
    rates_10(n, p, g, w);
    rates_11(n, w);
    rates_12(n, w);
    rates_13(n, p, g, w);
    rates_14(n, slots, p, g, w, f);
    rates_15(n, slots, t, p, g, w, f);
    rates_16(n, slots, t, p, g, w, f);
    return SOFTCAT_SOLVED;
}

static int jacobian(const softcat_filament *filament, double t, const double *y, double *e,
                    double *w)
{
    const int n = filament->sites;
    const int fibres = FIBRES;
    const int slots = SLOTS;
    const int entries = ENTRIES;
    const double *zeta = fibre_zeta;
    const double *weight = fibre_weight;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * entries; k++) e[k] = 0.0;
    jacobian_0(n, entries, e);
    jacobian_1(n, entries, e);
    jacobian_2(n, slots, y, w);
    jacobian_3(n, slots, y, w);
    jacobian_4(n, w);
    jacobian_5(n, w);
    jacobian_6(n, p, g, w);
    jacobian_7(n, fibres, slots, entries, zeta, weight, p, y, w, e);
    jacobian_8(n, fibres, p, g, w);
    jacobian_9(n, fibres, entries, p, g, w, e);
    jacobian_10(n, fibres, p, g, w);
    jacobian_11(n, fibres, w);
    jacobian_12(n, fibres, w);
    jacobian_13(n, fibres, p, g, w);
    jacobian_14(n, fibres, entries, p, g, w, e);
    jacobian_15(n, fibres, entries, p, g, w, e);
    jacobian_16(n, fibres, entries, p, g, w, e);
    return SOFTCAT_SOLVED;
}

static int work(const softcat_filament *filament, double t, const double *y, double *q,
                double *w)
{
    const int n = filament->sites;
    const int fibres = FIBRES;
    const int slots = SLOTS;
    const double *zeta = fibre_zeta;
    const double *weight = fibre_weight;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, fibres, slots, zeta, weight, p, y, w);
    work_1(n, t, p, g, w, q);
    work_2(n, p, g, w, q);
    work_3(n, slots, y, w);
    work_4(n, slots, y, w);
    work_5(n, w);
    work_6(n, w);
    work_7(n, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const int fibres = FIBRES;
    const int slots = SLOTS;
    const double *zeta = fibre_zeta;
    const double *weight = fibre_weight;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 3 * slots; k++) s[k] = 0.0;
    work_slope_0(n, fibres, slots, zeta, weight, p, y, w);
    work_slope_1(n, slots, t, p, g, s);
    work_slope_2(n, fibres, slots, p, g, w, s);
    work_slope_3(n, slots, y, w);
    work_slope_4(n, slots, y, w);
    work_slope_5(n, w);
    work_slope_6(n, w);
    work_slope_7(n, fibres, slots, p, g, w, s);
    return SOFTCAT_SOLVED;
}

static int rates_in_time(const softcat_filament *filament, double t, const double *y, double *f,
                         double *w)
{
    const int n = filament->sites;
    const int slots = SLOTS;
    const double *p = filament->parameters;
    (void)y;
    (void)w;
    for (int k = 0; k < n * slots; k++) f[k] = 0.0;
    rates_in_time_15(n, slots, t, p, f);
    rates_in_time_16(n, slots, t, p, f);
    return SOFTCAT_SOLVED;
}

static int work_in_time(const softcat_filament *filament, double t, const double *y, double *q,
                        double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)y;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_in_time_1(n, t, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {
    2, 3, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
static const int differential[] = {
    1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int held_first[] = {
    1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
static const int held_last[] = {
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int row[] = {
    0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2,
    2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2,
    2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10,
    11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 5,
    6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,
    16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20, 13, 14,
    15, 16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20, 13,
    14, 15, 16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20};
static const int offset[] = {
    0, 0, -2, -2, -2, -1, -1, -1, 0, 0, 0, 1, 1, 1, 2, 2, 2, -2, -2, -2, -1, -1, -1, 0, 0, 0, 1,
    1, 1, 2, 2, 2, -1, -1, -1, 0, 0, 0, 1, 1, 1, -2, -2, -2, -2, -2, -2, -2, -2, -2, -2, -2, -2,
    -2, -2, -2, -2, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, -2, -2,
    -2, -2, -2, -2, -2, -2, -2, -2, -2, -2, -2, -2, -2, -2, -1, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int column[] = {
    2, 3, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1,
    4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5,
    6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14,
    15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7,
    8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16,
    17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9,
    10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17,
    18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 0, 0, 0, 0, 0, 0,
    0, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,
    16, 17, 18, 19, 20, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4, 4, 4, 4, 4, 4, 4,
    0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 7, 8, 9, 10,
    11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 4,
    4, 4, 4, 4, 4, 4, 4};

const softcat_model softcat_filament_model = {
    21, 16, 11, 7, 352, 329, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope, rates_in_time, work_in_time,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "ramp", "youngs_modulus", "viscosity",
    "yield_stress", "poisson", "aspect", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "s", "Pa", "Pa*s", "Pa", "1", "1", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON,
    SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.2, 0.006, 1900.0, 9.81, 0.04358898943540673, 4000000.0, 13839.05534348353, 9319.5, 0.45,
    1.0, 0.14278431229270644};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0", "axial_1", "axial_2", "axial_3", "axial_4", "axial_5",
    "axial_6", "axial_7", "shear_0", "shear_1", "shear_2", "shear_3", "shear_4", "shear_5",
    "shear_6", "shear_7"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0};
static const double described_absolutes[] = {
    4.6597500000000004e-08, 4.6597500000000004e-08, 4.65975e-07, 4.65975e-07,
    4.6597500000000004e-08, 4.65975e-07, 4.65975e-07, 4.65975e-07, 4.65975e-07, 4.65975e-07,
    4.65975e-07, 4.65975e-07, 4.65975e-07, 4.65975e-07, 4.65975e-07, 4.65975e-07, 4.65975e-07,
    4.65975e-07, 4.65975e-07, 4.65975e-07, 4.65975e-07};
static const double described_nodes[] = {
    0.0, 0.03854997226637474, 0.07426826546348428, 0.1073628799057234, 0.13802653729372794,
    0.16643780300132474, 0.1927621259251596, 0.21715280195241757, 0.23975186665725032,
    0.2606909224243993, 0.2800919048166491, 0.29806779264894157, 0.31472326590416416,
    0.33015531532189, 0.34445380720992197, 0.3577020067677384, 0.3699770629693392,
    0.381350457829138, 0.3918884226671344, 0.40165232379742655, 0.4106990198860658,
    0.4190811930592749, 0.4268476556901904, 0.4340436346506578, 0.4407110346833784,
    0.44688868242811775, 0.4526125525230264, 0.4579159770977425, 0.46282983987822746,
    0.4673827560336774, 0.47160123881282245, 0.47550985393999556, 0.47913136267007583,
    0.48248685433536365, 0.48559586915625763, 0.4884765120309014, 0.49114555796644,
    0.4936185497658472, 0.49590988853919105, 0.4980329175664152, 0.5};
static const double described_section_points[] = {
    (-0.9602898564975362), (-0.7966664774136267), (-0.525532409916329), (-0.18343464249564978),
    0.18343464249564978, 0.525532409916329, 0.7966664774136267, 0.9602898564975362,
    0.05061426814518853, 0.11119051722668721, 0.15685332293894344, 0.18134189168918083,
    0.18134189168918083, 0.15685332293894344, 0.11119051722668721, 0.05061426814518853};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Yields, flows slowly and stops",
    .parameter_names = described_parameters,
    .parameter_units = described_units,
    .parameter_ranges = described_ranges,
    .parameter_values = described_values,
    .slot_names = described_slots,
    .on_cells = described_on_cells,
    .mean = described_mean,
    .bending = described_bending,
    .first = SOFTCAT_SYMMETRY,
    .last = SOFTCAT_CLAMPED,
    .least_cells = 4,
    .area_power = 1,
    .profiled = 0,
    .places = described_places,
    .x = 0,
    .y = 1,
    .z = -1,
    .psi = 4,
    .q = -1,
    .rest_length = 0,
    .time_scale = 10,
    .gravity = 3,
    .density = 2,
    .span = -1,
    .drop = -1,
    .left_angle = -1,
    .right_angle = -1,
    .curvature = -1,
    .twist = -1,
    .motion = -1,
    .motion_rows = 0,
    .motion_width = 3,
    .turn = -1,
    .turn_rows = 0,
    .stretch = 1.0,
    .aspect = 9,
    .width = 1.0,
    .section = SOFTCAT_RECTANGLE,
    .fibres = 8,
    .points = 8,
    .nodes = described_nodes,
    .plain_slots = 5,
    .plain_entries = 41,
    .plain_scratch = 112,
    .section_points = described_section_points,
    .grading = 19.597537758558094,
    .relative = 0.001,
    .absolute = 4.6597500000000004e-08,
    .absolutes = described_absolutes,
    .largest_step = 0.0,
    .method = 2,
    .towards_middle = 0,
    .duration = 2.00509351402871,
    .cells = 40,
    .frames = 201,
};

int softcat_row(int cells)
{
    return softcat_structure_row(&softcat_filament_structure, cells);
}

void softcat_defaults(double *params)
{
    const int count = softcat_filament_structure.model->parameters;
    for (int k = 0; k < count; k++) params[k] = described_values[k];
}

size_t softcat_workspace_size(int cells, int n, const softcat_settings *settings)
{
    return softcat_structure_workspace_size(&softcat_filament_structure, cells, n, settings);
}

int softcat_solve_with(const double *params, int cells, const double *times, int n,
    const softcat_settings *settings, const softcat_results *results, softcat_workspace workspace,
    softcat_status *status)
{
    return softcat_structure_solve(&softcat_filament_structure, params, cells, times, n, settings,
        results, workspace, status);
}

int softcat_solve(const double *params, int cells, const double *times, int n, double *out,
    softcat_workspace workspace, softcat_status *status)
{
    const softcat_results results = {.positions = out};
    return softcat_solve_with(params, cells, times, n, 0, &results, workspace, status);
}

int softcat_midpoint(const double *params, int cells, const double *times, int n, double *out,
    softcat_workspace workspace, softcat_status *status)
{
    const softcat_results results = {.midpoint = out};
    return softcat_solve_with(params, cells, times, n, 0, &results, workspace, status);
}

int softcat_solve_sensitivities(const double *params, int cells, const double *times, int n,
    const int *by, int by_count, double *out, double *derivatives, softcat_workspace workspace,
    softcat_status *status)
{
    const softcat_settings settings = {.by = by, .by_count = by_count};
    const softcat_results results = {.positions = out, .derivatives = derivatives};
    return softcat_solve_with(params, cells, times, n, &settings, &results, workspace, status);
}
