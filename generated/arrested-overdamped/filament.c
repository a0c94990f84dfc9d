/*
 * Yields, flows slowly and stops
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres, necking-gradient
 * Digest of the structure: ed1ee47ce43f37f0ccf244f2706890bc2f7c6f2dd0e4ac0fe4c2ac6ed05bd2b6
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES 8
#define SLOTS 21
#define ENTRIES 297
#define SCRATCH 126

/* Coordinate of each fibre, from -1 to 1 through the thickness, and its share of the section. */
static const double zeta[] = {
    (-0.9602898564975362), (-0.7966664774136267), (-0.525532409916329), (-0.18343464249564978),
    0.18343464249564978, 0.525532409916329, 0.7966664774136267, 0.9602898564975362};
static const double weight[] = {
    0.05061426814518853, 0.11119051722668721, 0.15685332293894344, 0.18134189168918083,
    0.18134189168918083, 0.15685332293894344, 0.11119051722668721, 0.05061426814518853};

static inline double smaller(double a, double b) { return a < b ? a : b; }
static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[SLOTS * i + 0] = y[SLOTS * i + 2];
    }
}

static void rates_1(int n, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[SLOTS * i + 1] = y[SLOTS * i + 3];
    }
}

static void rates_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[SLOTS * i + 0];
        w1[i] = y[SLOTS * i + 4];
    }
}

static void rates_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[SLOTS * i + 1];
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

static void rates_5(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    const int i = 0;
    w0[i] = g[7 * i];
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
    const double c26 = 1.0 / p[0];
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
        w5[i] = (v7 - v6) * (v4 * c26);
        w6[i] = sqrt(squared(v5) + squared(v17));
    }
}

static void rates_7(int n, const double *p, const double *y, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    const double c3 = p[7];
    const double c4 = p[5];
    const double c7 = (-0.5) * p[1];
    const double c24 = 0.8333333333333334 * c4;
    const double c27 = 2.0 * p[8];
    const double c28 = 2.0 + c27;
    const double c29 = c24 / c28;
    const double c39 = 1e-12 * c4;
    const double c40 = squared(c39);
    const double c46 = 1.0 / p[6];
    const double c50 = p[10];
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v9 = c7 * w5[i];
        const double v12 = w3[i];
        const double v14 = sqrt(v12) * v12;
        const double v18 = log(v12);
        const double v31 = w4[i] / v12;
        for (int k = 0; k < FIBRES; k++) {
            const double v10 = zeta[k];
            const double v20 = c4 * ((((v9 * v10) / v14) - y[SLOTS * i + 5 + k]) + v18);
            const double v34 = c29 * (v31 - y[SLOTS * i + 5 + 1 * FIBRES + k]);
            const double v42 = sqrt(larger(squared(v20) + (3.0 * squared(v34)), c40));
            const double v43 = (double)(c3 < v42);
            const double v48 = ((v42 - c3) * c46) / v42;
            const double v57 = weight[k];
            f[SLOTS * i + 5 + k] = v43 != 0.0 ? ((v20 * v48) * c50) : 0.0;
            f[SLOTS * i + 5 + 1 * FIBRES + k] = v43 != 0.0 ? (((3.0 * v34) * v48) * c50) : 0.0;
            sum0 += v20 * v57;
            sum1 += v20 * (v57 * v10);
            sum2 += v34 * v57;
        }
        w7[i] = sum0;
        w8[i] = sum1;
        w9[i] = sum2;
    }
}

static void rates_8(int n, const double *p, const double *g, double *w)
{
    double *restrict w1 = w + 1 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    const double c13 = 0.5 * p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v3 = w7[i] * v2;
        const double v4 = w4[i];
        const double v5 = w9[i];
        const double v6 = v5 * v2;
        const double v18 = (c13 * w8[i]) / (sqrt(v1) * v1);
        const double v23 = (v3 - ((v4 * v6) * v2)) + (((1.5 * v18) * w5[i]) * v2);
        const double v28 = (w1[i] + w1[i + 1]) * 0.5;
        const double v29 = cos(v28);
        const double v31 = sin(v28);
        w10[i] = (v23 * v29) - (v6 * v31);
        w11[i] = (v23 * v31) + (v6 * v29);
        w12[i] = v3;
        w13[i] = ((g[7 * i + 1] * p[0]) * (v5 - (v4 * v23))) * 0.5;
        w14[i] = -v18;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    double *restrict w15 = w + 15 * n;
    const double c1 = squared(p[1]);
    const double c4 = squared(p[9]);
    const double c5 = 0.020833333333333332 * c4;
    const double c6 = 0.020833333333333332 + c5;
    const double c7 = c1 * c6;
    const double c14 = p[0];
    const double c15 = 1.0 / c14;
    const double c49 = squared(p[10]);
    const double c51 = p[2];
    const double c52 = 0.08333333333333333 * c51;
    const double c53 = c52 * c1;
    const double c54 = c53 * c14;
    const double c55 = c49 / c54;
    const double c58 = squared(c14);
    const double c59 = c51 * c58;
    const double c60 = c53 / c59;
    for (int i = 1; i < n - 1; i++) {
        const double v8 = w6[i];
        const double v9 = w6[i - 1];
        const double v12 = g[7 * i + 5];
        const double v22 = (g[7 * i + 1] * 0.5) * v12;
        const double v26 = (g[7 * i - 6] * 0.5) * v12;
        const double v31 = (c7 * (((v8 - v9) * v12) * c15)) / squared(squared(((v22 * v8) + (v26 * v9))));
        const double v40 = (v31 * larger(0.0, (v22 * w12[i]) + (v26 * w12[i - 1]))) * c15;
        const double v57 = (((w14[i] - w14[i - 1]) + w13[i]) + w13[i - 1]) * (c55 * v12);
        w15[i] = v40;
        f[SLOTS * i + 4] = v57 * c60;
    }
}

static void rates_10(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    for (int i = 1; i < n - 2; i++) {
        const double v5 = g[7 * i + 4];
        const double v8 = ((w15[i + 1] - w15[i]) * v5) / w6[i];
        w16[i] = w10[i] - (v8 * ((w0[i + 1] - w0[i]) * v5));
        w17[i] = w11[i] - (v8 * ((w2[i + 1] - w2[i]) * v5));
    }
}

static void rates_11(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    const int i = n - 2;
    const double v3 = g[7 * i + 4];
    const double v6 = (w15[i] * v3) / w6[i];
    w16[i] = w10[i] + (v6 * ((w0[i + 1] - w0[i]) * v3));
    w17[i] = w11[i] + (v6 * ((w2[i + 1] - w2[i]) * v3));
    (void)n;
}

static void rates_12(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    const int i = 0;
    const double v3 = g[7 * i + 4];
    const double v6 = (w15[i + 1] * v3) / w6[i];
    w16[i] = w10[i] - (v6 * ((w0[i + 1] - w0[i]) * v3));
    w17[i] = w11[i] - (v6 * ((w2[i + 1] - w2[i]) * v3));
    (void)n;
}

static void rates_13(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w16 = w + 16 * n;
    const double c4 = squared(p[10]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    for (int i = 1; i < n - 1; i++) {
        f[SLOTS * i + 2] = (w16[i] - w16[i - 1]) * (c9 * g[7 * i + 6]);
    }
}

static void rates_14(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w17 = w + 17 * n;
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
        f[SLOTS * i + 3] = ((w17[i] - w17[i - 1]) * (c9 * g[7 * i + 6])) - c34;
    }
}

static void rates_15(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w17 = w + 17 * n;
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
    f[SLOTS * i + 3] = (w17[i] * (c7 * g[7 * i + 6])) - c32;
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[ENTRIES * i + 0] = 1.0;
    }
}

static void jacobian_1(int n, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[ENTRIES * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[SLOTS * i + 0];
        w1[i] = y[SLOTS * i + 4];
    }
}

static void jacobian_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[SLOTS * i + 1];
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

static void jacobian_5(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    const int i = 0;
    w0[i] = g[7 * i];
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
    const double c39 = 1.0 / p[0];
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
        const double v40 = v4 * c39;
        const double v46 = sqrt(squared(v5) + squared(v17));
        const double v50 = 1.0 / (2.0 * v46);
        const double v51 = ((2.0 * v5) * v4) * v50;
        const double v55 = ((2.0 * v17) * v4) * v50;
        w3[i] = (v5 * v12) + (v17 * v18);
        w18[i] = v25;
        w19[i] = v25;
        w20[i] = v27;
        w21[i] = v26;
        w22[i] = v29;
        w23[i] = v28;
        w4[i] = (v17 * v12) - (v5 * v18);
        w24[i] = v36;
        w25[i] = v36;
        w26[i] = v28;
        w27[i] = v29;
        w28[i] = v27;
        w29[i] = v26;
        w5[i] = (v7 - v6) * v40;
        w30[i] = -v40;
        w31[i] = v40;
        w6[i] = v46;
        w32[i] = -v51;
        w33[i] = v51;
        w34[i] = -v55;
        w35[i] = v55;
    }
}

static void jacobian_7(int n, const double *p, const double *y, double *w, double *e)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
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
    double *restrict each0 = w + (SCRATCH) * n;
    double *restrict each1 = w + (SCRATCH + 1 * FIBRES) * n;
    double *restrict each2 = w + (SCRATCH + 2 * FIBRES) * n;
    const double c1 = p[5];
    const double c54 = 0.8333333333333334 * c1;
    const double c57 = 2.0 * p[8];
    const double c58 = 2.0 + c57;
    const double c59 = c54 / c58;
    const double c78 = p[7];
    const double c81 = (-0.5) * p[1];
    const double c107 = 1e-12 * c1;
    const double c108 = squared(c107);
    const double c114 = 1.0 / p[6];
    const double c118 = p[10];
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        double sum3 = 0.0;
        double sum4 = 0.0;
        double sum5 = 0.0;
        double sum6 = 0.0;
        double sum7 = 0.0;
        double sum8 = 0.0;
        const double v6 = w18[i];
        const double v9 = w30[i];
        const double v12 = w19[i];
        const double v14 = w31[i];
        const double v17 = w20[i];
        const double v19 = w21[i];
        const double v21 = w22[i];
        const double v23 = w23[i];
        const double v44 = w24[i];
        const double v49 = w25[i];
        const double v62 = w26[i];
        const double v66 = w27[i];
        const double v70 = w28[i];
        const double v74 = w29[i];
        const double v83 = c81 * w5[i];
        const double v85 = w3[i];
        const double v86 = sqrt(v85);
        const double v88 = 1.0 / (v86 * v85);
        const double v92 = log(v85);
        const double v98 = 1.0 / v85;
        const double v99 = w4[i] * v98;
        const double v147 = v99 * v98;
        const double v156 = 1.0 / (2.0 * v86);
        for (int k = 0; k < FIBRES; k++) {
            const double v2 = weight[k];
            const double v3 = c1 * v2;
            const double v26 = zeta[k];
            const double v27 = v2 * v26;
            const double v28 = c1 * v27;
            const double v60 = c59 * v2;
            const double v89 = (v83 * v26) * v88;
            const double v94 = c1 * ((v89 - y[SLOTS * i + 5 + k]) + v92);
            const double v102 = c59 * (v99 - y[SLOTS * i + 5 + 1 * FIBRES + k]);
            const double v105 = squared(v94) + (3.0 * squared(v102));
            const double v110 = sqrt(larger(v105, c108));
            const double v111 = (double)(c78 < v110);
            const double v116 = 1.0 / v110;
            const double v117 = ((v110 - c78) * c114) * v116;
            const double v119 = v117 * c118;
            const double v120 = 2.0 * v94;
            const double v121 = (double)(c108 <= v105);
            const double v124 = v121 / (v121 + (double)(v105 <= c108));
            const double v125 = v94 * c118;
            const double v128 = v117 * v116;
            const double v132 = 1.0 / (2.0 * v110);
            const double v134 = v124 * ((((v125 * v116) * c114) - (v128 * v125)) * v132);
            const double v137 = c1 * (v119 + (v120 * v134));
            const double v140 = 2.0 * v102;
            const double v143 = c59 * (v140 * (3.0 * v134));
            const double v144 = v143 * v98;
            const double v150 = v89 * v88;
            const double v151 = v150 * v137;
            const double v158 = (((v137 * v98) - (v147 * v143)) - (v86 * v151)) - ((v85 * v151) * v156);
            const double v163 = c81 * (v26 * (v137 * v88));
            const double v166 = v111 != 0.0 ? (((v144 * v44) + (v158 * v6)) + (v163 * v9)) : 0.0;
            const double v172 = v111 != 0.0 ? (((v144 * v49) + (v158 * v12)) + (v163 * v14)) : 0.0;
            const double v192 = (3.0 * v102) * c118;
            const double v198 = v124 * ((((v192 * v116) * c114) - (v128 * v192)) * v132);
            const double v200 = c1 * (v120 * v198);
            const double v207 = c59 * ((3.0 * v119) + (v140 * (3.0 * v198)));
            const double v208 = v207 * v98;
            const double v213 = v150 * v200;
            const double v218 = (((v200 * v98) - (v147 * v207)) - (v86 * v213)) - ((v85 * v213) * v156);
            const double v223 = c81 * (v26 * (v200 * v88));
            const double v226 = v111 != 0.0 ? (((v208 * v44) + (v218 * v6)) + (v223 * v9)) : 0.0;
            const double v232 = v111 != 0.0 ? (((v208 * v49) + (v218 * v12)) + (v223 * v14)) : 0.0;
            const double v255 = v150 * v3;
            const double v265 = v150 * v28;
            each0[FIBRES * i + k] = -v3;
            each1[FIBRES * i + k] = -v28;
            each2[FIBRES * i + k] = -v60;
            e[ENTRIES * i + 41 + 19 * FIBRES + k] = v111 != 0.0 ? (-v137) : 0.0;
            e[ENTRIES * i + 41 + 18 * FIBRES + k] = v166;
            e[ENTRIES * i + 41 + 23 * FIBRES + k] = v172;
            e[ENTRIES * i + 41 + 20 * FIBRES + k] = v111 != 0.0 ? (-v143) : 0.0;
            e[ENTRIES * i + 41 + 16 * FIBRES + k] = v111 != 0.0 ? ((v144 * v62) + (v158 * v17)) : 0.0;
            e[ENTRIES * i + 41 + 21 * FIBRES + k] = v111 != 0.0 ? ((v144 * v66) + (v158 * v19)) : 0.0;
            e[ENTRIES * i + 41 + 17 * FIBRES + k] = v111 != 0.0 ? ((v144 * v70) + (v158 * v21)) : 0.0;
            e[ENTRIES * i + 41 + 22 * FIBRES + k] = v111 != 0.0 ? ((v144 * v74) + (v158 * v23)) : 0.0;
            e[ENTRIES * i + 41 + 27 * FIBRES + k] = v111 != 0.0 ? (-v200) : 0.0;
            e[ENTRIES * i + 41 + 26 * FIBRES + k] = v226;
            e[ENTRIES * i + 41 + 31 * FIBRES + k] = v232;
            e[ENTRIES * i + 41 + 28 * FIBRES + k] = v111 != 0.0 ? (-v207) : 0.0;
            e[ENTRIES * i + 41 + 24 * FIBRES + k] = v111 != 0.0 ? ((v208 * v62) + (v218 * v17)) : 0.0;
            e[ENTRIES * i + 41 + 29 * FIBRES + k] = v111 != 0.0 ? ((v208 * v66) + (v218 * v19)) : 0.0;
            e[ENTRIES * i + 41 + 25 * FIBRES + k] = v111 != 0.0 ? ((v208 * v70) + (v218 * v21)) : 0.0;
            e[ENTRIES * i + 41 + 30 * FIBRES + k] = v111 != 0.0 ? ((v208 * v74) + (v218 * v23)) : 0.0;
            sum0 += v94 * v2;
            sum1 += v94 * v27;
            sum2 += v102 * v2;
            sum3 += ((v3 * v98) - (v86 * v255)) - ((v85 * v255) * v156);
            sum4 += c81 * (v26 * (v3 * v88));
            sum5 += ((v28 * v98) - (v86 * v265)) - ((v85 * v265) * v156);
            sum6 += c81 * (v26 * (v28 * v88));
            sum7 += v60 * v98;
            sum8 += -(v147 * v60);
        }
        const double v5 = sum3;
        const double v8 = sum4;
        const double v30 = sum5;
        const double v32 = sum6;
        const double v43 = sum7;
        const double v46 = sum8;
        w7[i] = sum0;
        w36[i] = (v5 * v6) + (v8 * v9);
        w37[i] = (v5 * v12) + (v8 * v14);
        w38[i] = v5 * v17;
        w39[i] = v5 * v19;
        w40[i] = v5 * v21;
        w41[i] = v5 * v23;
        w8[i] = sum1;
        w42[i] = (v30 * v6) + (v32 * v9);
        w43[i] = (v30 * v12) + (v32 * v14);
        w44[i] = v30 * v17;
        w45[i] = v30 * v19;
        w46[i] = v30 * v21;
        w47[i] = v30 * v23;
        w9[i] = sum2;
        w48[i] = (v43 * v44) + (v46 * v6);
        w49[i] = (v43 * v49) + (v46 * v12);
        w50[i] = (v43 * v62) + (v46 * v17);
        w51[i] = (v43 * v66) + (v46 * v19);
        w52[i] = (v43 * v70) + (v46 * v21);
        w53[i] = (v43 * v74) + (v46 * v23);
    }
}

static void jacobian_8(int n, const double *p, const double *g, double *w)
{
    double *restrict w1 = w + 1 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
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
    double *restrict each0 = w + (SCRATCH) * n;
    double *restrict each1 = w + (SCRATCH + 1 * FIBRES) * n;
    double *restrict each2 = w + (SCRATCH + 2 * FIBRES) * n;
    double *restrict each3 = w + (SCRATCH + 3 * FIBRES) * n;
    double *restrict each4 = w + (SCRATCH + 4 * FIBRES) * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
    double *restrict each9 = w + (SCRATCH + 9 * FIBRES) * n;
    double *restrict each10 = w + (SCRATCH + 10 * FIBRES) * n;
    const double c13 = 0.5 * p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v3 = w7[i] * v2;
        const double v4 = w4[i];
        const double v5 = w9[i];
        const double v6 = v5 * v2;
        const double v8 = (v4 * v6) * v2;
        const double v16 = sqrt(v1);
        const double v18 = 1.0 / (v16 * v1);
        const double v19 = (c13 * w8[i]) * v18;
        const double v20 = 1.5 * v19;
        const double v21 = w5[i];
        const double v23 = (v20 * v21) * v2;
        const double v24 = (v3 - v8) + v23;
        const double v29 = (w1[i] + w1[i + 1]) * 0.5;
        const double v30 = cos(v29);
        const double v32 = sin(v29);
        const double v35 = v30 * v2;
        const double v38 = c13 * v18;
        const double v41 = (v21 * (1.5 * v38)) * v2;
        const double v42 = v30 * v41;
        const double v46 = v6 * v2;
        const double v47 = v4 * v46;
        const double v51 = v3 * v2;
        const double v57 = (v19 * v18) * ((v1 / (2.0 * v16)) + v16);
        const double v63 = (((v47 * v2) + (v8 * v2)) - v51) - (((v21 * (1.5 * v57)) * v2) + (v23 * v2));
        const double v65 = v32 * v46;
        const double v66 = (v30 * v63) + v65;
        const double v67 = w18[i];
        const double v69 = v30 * v46;
        const double v70 = w24[i];
        const double v73 = w36[i];
        const double v76 = w42[i];
        const double v79 = v20 * v2;
        const double v80 = v30 * v79;
        const double v81 = w30[i];
        const double v83 = ((((v66 * v67) - (v69 * v70)) + (v35 * v73)) + (v42 * v76)) + (v80 * v81);
        const double v84 = 0.5 * v32;
        const double v86 = 0.5 * v30;
        const double v88 = (v24 * v84) + (v6 * v86);
        const double v90 = v4 * v2;
        const double v91 = v90 * v2;
        const double v93 = v32 * v2;
        const double v94 = (v30 * v91) + v93;
        const double v95 = w48[i];
        const double v98 = w19[i];
        const double v100 = w25[i];
        const double v103 = w37[i];
        const double v106 = w43[i];
        const double v108 = (((v66 * v98) - (v69 * v100)) + (v35 * v103)) + (v42 * v106);
        const double v109 = w31[i];
        const double v113 = w49[i];
        const double v119 = w20[i];
        const double v121 = w26[i];
        const double v124 = w38[i];
        const double v127 = w44[i];
        const double v129 = (((v66 * v119) - (v69 * v121)) + (v35 * v124)) + (v42 * v127);
        const double v130 = w50[i];
        const double v133 = w21[i];
        const double v135 = w27[i];
        const double v138 = w39[i];
        const double v141 = w45[i];
        const double v143 = (((v66 * v133) - (v69 * v135)) + (v35 * v138)) + (v42 * v141);
        const double v144 = w51[i];
        const double v147 = w22[i];
        const double v149 = w28[i];
        const double v152 = w40[i];
        const double v155 = w46[i];
        const double v157 = (((v66 * v147) - (v69 * v149)) + (v35 * v152)) + (v42 * v155);
        const double v158 = w52[i];
        const double v161 = w23[i];
        const double v163 = w29[i];
        const double v166 = w41[i];
        const double v169 = w47[i];
        const double v171 = (((v66 * v161) - (v69 * v163)) + (v35 * v166)) + (v42 * v169);
        const double v172 = w53[i];
        const double v179 = v32 * v41;
        const double v183 = (v32 * v63) - v69;
        const double v190 = (((v183 * v67) - (v65 * v70)) + (v93 * v73)) + (v179 * v76);
        const double v191 = v32 * v79;
        const double v196 = (v24 * v86) - (v6 * v84);
        const double v199 = v35 - (v32 * v91);
        const double v208 = (((v183 * v98) - (v65 * v100)) + (v93 * v103)) + (v179 * v106);
        const double v221 = (((v183 * v119) - (v65 * v121)) + (v93 * v124)) + (v179 * v127);
        const double v230 = (((v183 * v133) - (v65 * v135)) + (v93 * v138)) + (v179 * v141);
        const double v239 = (((v183 * v147) - (v65 * v149)) + (v93 * v152)) + (v179 * v155);
        const double v248 = (((v183 * v161) - (v65 * v163)) + (v93 * v166)) + (v179 * v169);
        const double v272 = g[7 * i + 1] * p[0];
        const double v278 = 0.5 * (v272 * v90);
        const double v282 = 0.5 * (v272 * (v4 * v41));
        const double v290 = 0.5 * (v272 * (1.0 + (v4 * v91)));
        const double v294 = 0.5 * (v272 * (v24 - v47));
        const double v298 = 0.5 * (v272 * (v4 * v63));
        const double v304 = (((v294 * v70) + (v298 * v67)) + (v278 * v73)) + (v282 * v76);
        const double v307 = 0.5 * (v272 * (v4 * v79));
        const double v318 = (((v294 * v100) + (v298 * v98)) + (v278 * v103)) + (v282 * v106);
        const double v330 = (((v294 * v121) + (v298 * v119)) + (v278 * v124)) + (v282 * v127);
        const double v339 = (((v294 * v135) + (v298 * v133)) + (v278 * v138)) + (v282 * v141);
        const double v348 = (((v294 * v149) + (v298 * v147)) + (v278 * v152)) + (v282 * v155);
        const double v357 = (((v294 * v163) + (v298 * v161)) + (v278 * v166)) + (v282 * v169);
        w10[i] = (v24 * v30) - (v6 * v32);
        w54[i] = (v83 - v88) - (v94 * v95);
        w55[i] = ((v108 + (v80 * v109)) - v88) - (v94 * v113);
        w56[i] = v129 - (v94 * v130);
        w57[i] = v143 - (v94 * v144);
        w58[i] = v157 - (v94 * v158);
        w59[i] = v171 - (v94 * v172);
        w11[i] = (v24 * v32) + (v6 * v30);
        w60[i] = ((v190 + (v191 * v81)) + v196) + (v199 * v95);
        w61[i] = ((v208 + (v191 * v109)) + v196) + (v199 * v113);
        w62[i] = v221 + (v199 * v130);
        w63[i] = v230 + (v199 * v144);
        w64[i] = v239 + (v199 * v158);
        w65[i] = v248 + (v199 * v172);
        w12[i] = v3;
        w66[i] = (v73 * v2) - (v51 * v67);
        w67[i] = (v103 * v2) - (v51 * v98);
        w68[i] = (v124 * v2) - (v51 * v119);
        w69[i] = (v138 * v2) - (v51 * v133);
        w70[i] = (v152 * v2) - (v51 * v147);
        w71[i] = (v166 * v2) - (v51 * v161);
        w13[i] = (v272 * (v5 - (v4 * v24))) * 0.5;
        w72[i] = (v290 * v95) - (v304 + (v307 * v81));
        w73[i] = (v290 * v113) - (v318 + (v307 * v109));
        w74[i] = (v290 * v130) - v330;
        w75[i] = (v290 * v144) - v339;
        w76[i] = (v290 * v158) - v348;
        w77[i] = (v290 * v172) - v357;
        w14[i] = -v19;
        w78[i] = (v57 * v67) - (v38 * v76);
        w79[i] = (v57 * v98) - (v38 * v106);
        w80[i] = (v57 * v119) - (v38 * v127);
        w81[i] = (v57 * v133) - (v38 * v141);
        w82[i] = (v57 * v147) - (v38 * v155);
        w83[i] = (v57 * v161) - (v38 * v169);
        for (int k = 0; k < FIBRES; k++) {
            const double v36 = each0[FIBRES * i + k];
            const double v43 = each1[FIBRES * i + k];
            const double v116 = each2[FIBRES * i + k];
            each3[FIBRES * i + k] = (v35 * v36) + (v42 * v43);
            each4[FIBRES * i + k] = -(v94 * v116);
            each5[FIBRES * i + k] = (v93 * v36) + (v179 * v43);
            each6[FIBRES * i + k] = v199 * v116;
            each7[FIBRES * i + k] = v36 * v2;
            each8[FIBRES * i + k] = -((v278 * v36) + (v282 * v43));
            each9[FIBRES * i + k] = v290 * v116;
            each10[FIBRES * i + k] = -(v38 * v43);
        }
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    double *restrict w34 = w + 34 * n;
    double *restrict w35 = w + 35 * n;
    double *restrict w66 = w + 66 * n;
    double *restrict w67 = w + 67 * n;
    double *restrict w68 = w + 68 * n;
    double *restrict w69 = w + 69 * n;
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
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
    double *restrict each9 = w + (SCRATCH + 9 * FIBRES) * n;
    double *restrict each10 = w + (SCRATCH + 10 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    const double c1 = squared(p[1]);
    const double c4 = squared(p[9]);
    const double c5 = 0.020833333333333332 * c4;
    const double c6 = 0.020833333333333332 + c5;
    const double c7 = c1 * c6;
    const double c14 = p[0];
    const double c15 = 1.0 / c14;
    const double c121 = squared(p[10]);
    const double c123 = p[2];
    const double c124 = 0.08333333333333333 * c123;
    const double c125 = c124 * c1;
    const double c126 = c125 * c14;
    const double c127 = c121 / c126;
    const double c129 = squared(c14);
    const double c130 = c123 * c129;
    const double c131 = c125 / c130;
    for (int i = 1; i < n - 1; i++) {
        const double v8 = w6[i];
        const double v9 = w6[i - 1];
        const double v12 = g[7 * i + 5];
        const double v22 = (g[7 * i + 1] * 0.5) * v12;
        const double v26 = (g[7 * i - 6] * 0.5) * v12;
        const double v28 = (v22 * v8) + (v26 * v9);
        const double v29 = squared(v28);
        const double v31 = 1.0 / squared(v29);
        const double v32 = (c7 * (((v8 - v9) * v12) * c15)) * v31;
        const double v38 = (v22 * w12[i]) + (v26 * w12[i - 1]);
        const double v39 = larger(0.0, v38);
        const double v42 = (double)(0.0 <= v38);
        const double v47 = (v42 / ((double)(v38 <= 0.0) + v42)) * (v32 * c15);
        const double v48 = v26 * v47;
        const double v51 = v22 * v47;
        const double v68 = v39 * c15;
        const double v71 = (2.0 * v28) * ((2.0 * v29) * ((v32 * v31) * v68));
        const double v76 = ((c7 * (v68 * v31)) * c15) * v12;
        const double v77 = (v26 * v71) + v76;
        const double v82 = v76 - (v22 * v71);
        const double v90 = ((v82 * w32[i]) - (v77 * w33[i - 1])) + (v48 * w69[i - 1]);
        const double v111 = ((v82 * w34[i]) - (v77 * w35[i - 1])) + (v48 * w71[i - 1]);
        const double v132 = (c127 * v12) * c131;
        const double v155 = ((v132 * w78[i]) - (v132 * w79[i - 1])) + (v132 * w73[i - 1]);
        const double v180 = ((v132 * w80[i]) - (v132 * w81[i - 1])) + (v132 * w75[i - 1]);
        const double v201 = ((v132 * w82[i]) - (v132 * w83[i - 1])) + (v132 * w77[i - 1]);
        w15[i] = (v32 * v39) * c15;
        w84[i] = v48 * w66[i - 1];
        w85[i] = (v48 * w67[i - 1]) + (v51 * w66[i]);
        w86[i] = v51 * w67[i];
        w87[i] = (v48 * w68[i - 1]) - (v77 * w32[i - 1]);
        w88[i] = v90 + (v51 * w68[i]);
        w89[i] = (v82 * w33[i]) + (v51 * w69[i]);
        w90[i] = (v48 * w70[i - 1]) - (v77 * w34[i - 1]);
        w91[i] = v111 + (v51 * w70[i]);
        w92[i] = (v82 * w35[i]) + (v51 * w71[i]);
        e[ENTRIES * i + 34] = (v132 * w72[i - 1]) - (v132 * w78[i - 1]);
        e[ENTRIES * i + 37] = v155 + (v132 * w72[i]);
        e[ENTRIES * i + 40] = (v132 * w79[i]) + (v132 * w73[i]);
        e[ENTRIES * i + 32] = (v132 * w74[i - 1]) - (v132 * w80[i - 1]);
        e[ENTRIES * i + 35] = v180 + (v132 * w74[i]);
        e[ENTRIES * i + 38] = (v132 * w81[i]) + (v132 * w75[i]);
        e[ENTRIES * i + 33] = (v132 * w76[i - 1]) - (v132 * w82[i - 1]);
        e[ENTRIES * i + 36] = v201 + (v132 * w76[i]);
        e[ENTRIES * i + 39] = (v132 * w83[i]) + (v132 * w77[i]);
        for (int k = 0; k < FIBRES; k++) {
            const double v137 = (v132 * each8[FIBRES * (i - 1) + k]) - (v132 * each10[FIBRES * (i - 1) + k]);
            const double v142 = (v132 * each10[FIBRES * i + k]) + (v132 * each8[FIBRES * i + k]);
            each11[FIBRES * i + k] = v48 * each7[FIBRES * (i - 1) + k];
            each12[FIBRES * i + k] = v51 * each7[FIBRES * i + k];
            e[ENTRIES * i + 41 + 12 * FIBRES + k] = v137;
            e[ENTRIES * i + 41 + 14 * FIBRES + k] = v142;
            e[ENTRIES * i + 41 + 13 * FIBRES + k] = v132 * each9[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 41 + 15 * FIBRES + k] = v132 * each9[FIBRES * i + k];
        }
    }
}

static void jacobian_10(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    double *restrict w34 = w + 34 * n;
    double *restrict w35 = w + 35 * n;
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
    double *restrict w103 = w + 103 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict w112 = w + 112 * n;
    double *restrict w113 = w + 113 * n;
    double *restrict w114 = w + 114 * n;
    double *restrict w115 = w + 115 * n;
    double *restrict w116 = w + 116 * n;
    double *restrict each3 = w + (SCRATCH + 3 * FIBRES) * n;
    double *restrict each4 = w + (SCRATCH + 4 * FIBRES) * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    double *restrict each13 = w + (SCRATCH + 13 * FIBRES) * n;
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    double *restrict each16 = w + (SCRATCH + 16 * FIBRES) * n;
    double *restrict each17 = w + (SCRATCH + 17 * FIBRES) * n;
    double *restrict each18 = w + (SCRATCH + 18 * FIBRES) * n;
    double *restrict each19 = w + (SCRATCH + 19 * FIBRES) * n;
    double *restrict each20 = w + (SCRATCH + 20 * FIBRES) * n;
    for (int i = 1; i < n - 2; i++) {
        const double v5 = g[7 * i + 4];
        const double v8 = 1.0 / w6[i];
        const double v9 = ((w15[i + 1] - w15[i]) * v5) * v8;
        const double v13 = (w0[i + 1] - w0[i]) * v5;
        const double v17 = (v13 * v8) * v5;
        const double v30 = w84[i];
        const double v32 = w85[i];
        const double v34 = w84[i + 1];
        const double v39 = w86[i];
        const double v41 = w85[i + 1];
        const double v46 = w86[i + 1];
        const double v50 = w87[i];
        const double v52 = w88[i];
        const double v54 = w87[i + 1];
        const double v59 = v9 * v8;
        const double v60 = v59 * v13;
        const double v61 = w32[i];
        const double v64 = v9 * v5;
        const double v65 = ((((v17 * v52) - (v17 * v54)) + w56[i]) + (v60 * v61)) + v64;
        const double v66 = w89[i];
        const double v68 = w88[i + 1];
        const double v73 = w33[i];
        const double v76 = ((((v17 * v66) - (v17 * v68)) + w57[i]) + (v60 * v73)) - v64;
        const double v77 = w89[i + 1];
        const double v80 = w90[i];
        const double v82 = w91[i];
        const double v84 = w90[i + 1];
        const double v89 = w34[i];
        const double v92 = w92[i];
        const double v94 = w91[i + 1];
        const double v99 = w35[i];
        const double v102 = w92[i + 1];
        const double v109 = (w2[i + 1] - w2[i]) * v5;
        const double v113 = (v109 * v8) * v5;
        const double v142 = v59 * v109;
        const double v162 = ((((v113 * v82) - (v113 * v84)) + w64[i]) + (v142 * v89)) + v64;
        const double v170 = ((((v113 * v92) - (v113 * v94)) + w65[i]) + (v142 * v99)) - v64;
        w16[i] = w10[i] - (v9 * v13);
        w93[i] = v17 * v30;
        w94[i] = ((v17 * v32) - (v17 * v34)) + w54[i];
        w95[i] = ((v17 * v39) - (v17 * v41)) + w55[i];
        w96[i] = -(v17 * v46);
        w97[i] = v17 * v50;
        w98[i] = v65;
        w99[i] = v76;
        w100[i] = -(v17 * v77);
        w101[i] = v17 * v80;
        w102[i] = (((v17 * v82) - (v17 * v84)) + w58[i]) + (v60 * v89);
        w103[i] = (((v17 * v92) - (v17 * v94)) + w59[i]) + (v60 * v99);
        w104[i] = -(v17 * v102);
        w17[i] = w11[i] - (v9 * v109);
        w105[i] = v113 * v30;
        w106[i] = ((v113 * v32) - (v113 * v34)) + w60[i];
        w107[i] = ((v113 * v39) - (v113 * v41)) + w61[i];
        w108[i] = -(v113 * v46);
        w109[i] = v113 * v50;
        w110[i] = (((v113 * v52) - (v113 * v54)) + w62[i]) + (v142 * v61);
        w111[i] = (((v113 * v66) - (v113 * v68)) + w63[i]) + (v142 * v73);
        w112[i] = -(v113 * v77);
        w113[i] = v113 * v80;
        w114[i] = v162;
        w115[i] = v170;
        w116[i] = -(v113 * v102);
        for (int k = 0; k < FIBRES; k++) {
            const double v18 = each11[FIBRES * i + k];
            const double v20 = each12[FIBRES * i + k];
            const double v22 = each11[FIBRES * (i + 1) + k];
            const double v27 = each12[FIBRES * (i + 1) + k];
            each13[FIBRES * i + k] = v17 * v18;
            each14[FIBRES * i + k] = ((v17 * v20) - (v17 * v22)) + each3[FIBRES * i + k];
            each15[FIBRES * i + k] = -(v17 * v27);
            each16[FIBRES * i + k] = each4[FIBRES * i + k];
            each17[FIBRES * i + k] = v113 * v18;
            each18[FIBRES * i + k] = ((v113 * v20) - (v113 * v22)) + each5[FIBRES * i + k];
            each19[FIBRES * i + k] = -(v113 * v27);
            each20[FIBRES * i + k] = each6[FIBRES * i + k];
        }
    }
}

static void jacobian_11(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    double *restrict w34 = w + 34 * n;
    double *restrict w35 = w + 35 * n;
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
    double *restrict w103 = w + 103 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict w112 = w + 112 * n;
    double *restrict w113 = w + 113 * n;
    double *restrict w114 = w + 114 * n;
    double *restrict w115 = w + 115 * n;
    double *restrict w116 = w + 116 * n;
    double *restrict each3 = w + (SCRATCH + 3 * FIBRES) * n;
    double *restrict each4 = w + (SCRATCH + 4 * FIBRES) * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    double *restrict each13 = w + (SCRATCH + 13 * FIBRES) * n;
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    double *restrict each16 = w + (SCRATCH + 16 * FIBRES) * n;
    double *restrict each17 = w + (SCRATCH + 17 * FIBRES) * n;
    double *restrict each18 = w + (SCRATCH + 18 * FIBRES) * n;
    double *restrict each19 = w + (SCRATCH + 19 * FIBRES) * n;
    double *restrict each20 = w + (SCRATCH + 20 * FIBRES) * n;
    const int i = n - 2;
    const double v3 = g[7 * i + 4];
    const double v6 = 1.0 / w6[i];
    const double v7 = (w15[i] * v3) * v6;
    const double v11 = (w0[i + 1] - w0[i]) * v3;
    const double v15 = (v11 * v6) * v3;
    const double v23 = w84[i];
    const double v25 = w85[i];
    const double v29 = w86[i];
    const double v34 = w87[i];
    const double v36 = w88[i];
    const double v40 = v7 * v6;
    const double v41 = v40 * v11;
    const double v42 = w32[i];
    const double v45 = v7 * v3;
    const double v47 = w89[i];
    const double v51 = w33[i];
    const double v55 = w90[i];
    const double v57 = w91[i];
    const double v61 = w34[i];
    const double v64 = w92[i];
    const double v68 = w35[i];
    const double v75 = (w2[i + 1] - w2[i]) * v3;
    const double v79 = (v75 * v6) * v3;
    const double v96 = v40 * v75;
    w16[i] = w10[i] + (v7 * v11);
    w93[i] = v15 * v23;
    w94[i] = (v15 * v25) + w54[i];
    w95[i] = (v15 * v29) + w55[i];
    w96[i] = 0.0;
    w97[i] = v15 * v34;
    w98[i] = (((v15 * v36) + w56[i]) - (v41 * v42)) - v45;
    w99[i] = (((v15 * v47) + w57[i]) - (v41 * v51)) + v45;
    w100[i] = 0.0;
    w101[i] = v15 * v55;
    w102[i] = ((v15 * v57) + w58[i]) - (v41 * v61);
    w103[i] = ((v15 * v64) + w59[i]) - (v41 * v68);
    w104[i] = 0.0;
    w17[i] = w11[i] + (v7 * v75);
    w105[i] = v79 * v23;
    w106[i] = (v79 * v25) + w60[i];
    w107[i] = (v79 * v29) + w61[i];
    w108[i] = 0.0;
    w109[i] = v79 * v34;
    w110[i] = ((v79 * v36) + w62[i]) - (v96 * v42);
    w111[i] = ((v79 * v47) + w63[i]) - (v96 * v51);
    w112[i] = 0.0;
    w113[i] = v79 * v55;
    w114[i] = (((v79 * v57) + w64[i]) - (v96 * v61)) - v45;
    w115[i] = (((v79 * v64) + w65[i]) - (v96 * v68)) + v45;
    w116[i] = 0.0;
    for (int k = 0; k < FIBRES; k++) {
        const double v16 = each11[FIBRES * i + k];
        const double v18 = each12[FIBRES * i + k];
        each13[FIBRES * i + k] = v15 * v16;
        each14[FIBRES * i + k] = (v15 * v18) + each3[FIBRES * i + k];
        each15[FIBRES * i + k] = 0.0;
        each16[FIBRES * i + k] = each4[FIBRES * i + k];
        each17[FIBRES * i + k] = v79 * v16;
        each18[FIBRES * i + k] = (v79 * v18) + each5[FIBRES * i + k];
        each19[FIBRES * i + k] = 0.0;
        each20[FIBRES * i + k] = each6[FIBRES * i + k];
    }
    (void)n;
}

static void jacobian_12(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    double *restrict w34 = w + 34 * n;
    double *restrict w35 = w + 35 * n;
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
    double *restrict w103 = w + 103 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict w112 = w + 112 * n;
    double *restrict w113 = w + 113 * n;
    double *restrict w114 = w + 114 * n;
    double *restrict w115 = w + 115 * n;
    double *restrict w116 = w + 116 * n;
    double *restrict each3 = w + (SCRATCH + 3 * FIBRES) * n;
    double *restrict each4 = w + (SCRATCH + 4 * FIBRES) * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    double *restrict each13 = w + (SCRATCH + 13 * FIBRES) * n;
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    double *restrict each16 = w + (SCRATCH + 16 * FIBRES) * n;
    double *restrict each17 = w + (SCRATCH + 17 * FIBRES) * n;
    double *restrict each18 = w + (SCRATCH + 18 * FIBRES) * n;
    double *restrict each19 = w + (SCRATCH + 19 * FIBRES) * n;
    double *restrict each20 = w + (SCRATCH + 20 * FIBRES) * n;
    const int i = 0;
    const double v3 = g[7 * i + 4];
    const double v6 = 1.0 / w6[i];
    const double v7 = (w15[i + 1] * v3) * v6;
    const double v11 = (w0[i + 1] - w0[i]) * v3;
    const double v17 = (v11 * v6) * v3;
    const double v25 = w84[i + 1];
    const double v29 = w85[i + 1];
    const double v32 = w86[i + 1];
    const double v37 = w87[i + 1];
    const double v40 = v7 * v6;
    const double v41 = v40 * v11;
    const double v42 = w32[i];
    const double v45 = v7 * v3;
    const double v48 = w88[i + 1];
    const double v51 = w33[i];
    const double v55 = w89[i + 1];
    const double v59 = w90[i + 1];
    const double v62 = w34[i];
    const double v66 = w91[i + 1];
    const double v69 = w35[i];
    const double v72 = w92[i + 1];
    const double v79 = (w2[i + 1] - w2[i]) * v3;
    const double v84 = (v79 * v6) * v3;
    const double v101 = v40 * v79;
    w16[i] = w10[i] - (v7 * v11);
    w93[i] = 0.0;
    w94[i] = w54[i] - (v17 * v25);
    w95[i] = w55[i] - (v17 * v29);
    w96[i] = -(v17 * v32);
    w97[i] = 0.0;
    w98[i] = ((w56[i] - (v17 * v37)) + (v41 * v42)) + v45;
    w99[i] = ((w57[i] - (v17 * v48)) + (v41 * v51)) - v45;
    w100[i] = -(v17 * v55);
    w101[i] = 0.0;
    w102[i] = (w58[i] - (v17 * v59)) + (v41 * v62);
    w103[i] = (w59[i] - (v17 * v66)) + (v41 * v69);
    w104[i] = -(v17 * v72);
    w17[i] = w11[i] - (v7 * v79);
    w105[i] = 0.0;
    w106[i] = w60[i] - (v84 * v25);
    w107[i] = w61[i] - (v84 * v29);
    w108[i] = -(v84 * v32);
    w109[i] = 0.0;
    w110[i] = (w62[i] - (v84 * v37)) + (v101 * v42);
    w111[i] = (w63[i] - (v84 * v48)) + (v101 * v51);
    w112[i] = -(v84 * v55);
    w113[i] = 0.0;
    w114[i] = ((w64[i] - (v84 * v59)) + (v101 * v62)) + v45;
    w115[i] = ((w65[i] - (v84 * v66)) + (v101 * v69)) - v45;
    w116[i] = -(v84 * v72);
    for (int k = 0; k < FIBRES; k++) {
        const double v18 = each11[FIBRES * (i + 1) + k];
        const double v21 = each12[FIBRES * (i + 1) + k];
        each13[FIBRES * i + k] = 0.0;
        each14[FIBRES * i + k] = each3[FIBRES * i + k] - (v17 * v18);
        each15[FIBRES * i + k] = -(v17 * v21);
        each16[FIBRES * i + k] = each4[FIBRES * i + k];
        each17[FIBRES * i + k] = 0.0;
        each18[FIBRES * i + k] = each5[FIBRES * i + k] - (v84 * v18);
        each19[FIBRES * i + k] = -(v84 * v21);
        each20[FIBRES * i + k] = each6[FIBRES * i + k];
    }
    (void)n;
}

static void jacobian_13(int n, const double *p, const double *g, double *w, double *e)
{
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
    double *restrict w103 = w + 103 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict each13 = w + (SCRATCH + 13 * FIBRES) * n;
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    double *restrict each16 = w + (SCRATCH + 16 * FIBRES) * n;
    const double c1 = squared(p[10]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[ENTRIES * i + 4] = -(v9 * w93[i - 1]);
        e[ENTRIES * i + 7] = (v9 * w93[i]) - (v9 * w94[i - 1]);
        e[ENTRIES * i + 10] = (v9 * w94[i]) - (v9 * w95[i - 1]);
        e[ENTRIES * i + 13] = (v9 * w95[i]) - (v9 * w96[i - 1]);
        e[ENTRIES * i + 16] = v9 * w96[i];
        e[ENTRIES * i + 2] = -(v9 * w97[i - 1]);
        e[ENTRIES * i + 5] = (v9 * w97[i]) - (v9 * w98[i - 1]);
        e[ENTRIES * i + 8] = (v9 * w98[i]) - (v9 * w99[i - 1]);
        e[ENTRIES * i + 11] = (v9 * w99[i]) - (v9 * w100[i - 1]);
        e[ENTRIES * i + 14] = v9 * w100[i];
        e[ENTRIES * i + 3] = -(v9 * w101[i - 1]);
        e[ENTRIES * i + 6] = (v9 * w101[i]) - (v9 * w102[i - 1]);
        e[ENTRIES * i + 9] = (v9 * w102[i]) - (v9 * w103[i - 1]);
        e[ENTRIES * i + 12] = (v9 * w103[i]) - (v9 * w104[i - 1]);
        e[ENTRIES * i + 15] = v9 * w104[i];
        for (int k = 0; k < FIBRES; k++) {
            const double v17 = (v9 * each13[FIBRES * i + k]) - (v9 * each14[FIBRES * (i - 1) + k]);
            const double v22 = (v9 * each14[FIBRES * i + k]) - (v9 * each15[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + k] = -(v9 * each13[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 1 * FIBRES + k] = v17;
            e[ENTRIES * i + 41 + 3 * FIBRES + k] = v22;
            e[ENTRIES * i + 41 + 5 * FIBRES + k] = v9 * each15[FIBRES * i + k];
            e[ENTRIES * i + 41 + 2 * FIBRES + k] = -(v9 * each16[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 4 * FIBRES + k] = v9 * each16[FIBRES * i + k];
        }
    }
}

static void jacobian_14(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w105 = w + 105 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict w112 = w + 112 * n;
    double *restrict w113 = w + 113 * n;
    double *restrict w114 = w + 114 * n;
    double *restrict w115 = w + 115 * n;
    double *restrict w116 = w + 116 * n;
    double *restrict each17 = w + (SCRATCH + 17 * FIBRES) * n;
    double *restrict each18 = w + (SCRATCH + 18 * FIBRES) * n;
    double *restrict each19 = w + (SCRATCH + 19 * FIBRES) * n;
    double *restrict each20 = w + (SCRATCH + 20 * FIBRES) * n;
    const double c1 = squared(p[10]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[ENTRIES * i + 19] = -(v9 * w105[i - 1]);
        e[ENTRIES * i + 22] = (v9 * w105[i]) - (v9 * w106[i - 1]);
        e[ENTRIES * i + 25] = (v9 * w106[i]) - (v9 * w107[i - 1]);
        e[ENTRIES * i + 28] = (v9 * w107[i]) - (v9 * w108[i - 1]);
        e[ENTRIES * i + 31] = v9 * w108[i];
        e[ENTRIES * i + 17] = -(v9 * w109[i - 1]);
        e[ENTRIES * i + 20] = (v9 * w109[i]) - (v9 * w110[i - 1]);
        e[ENTRIES * i + 23] = (v9 * w110[i]) - (v9 * w111[i - 1]);
        e[ENTRIES * i + 26] = (v9 * w111[i]) - (v9 * w112[i - 1]);
        e[ENTRIES * i + 29] = v9 * w112[i];
        e[ENTRIES * i + 18] = -(v9 * w113[i - 1]);
        e[ENTRIES * i + 21] = (v9 * w113[i]) - (v9 * w114[i - 1]);
        e[ENTRIES * i + 24] = (v9 * w114[i]) - (v9 * w115[i - 1]);
        e[ENTRIES * i + 27] = (v9 * w115[i]) - (v9 * w116[i - 1]);
        e[ENTRIES * i + 30] = v9 * w116[i];
        for (int k = 0; k < FIBRES; k++) {
            const double v17 = (v9 * each17[FIBRES * i + k]) - (v9 * each18[FIBRES * (i - 1) + k]);
            const double v22 = (v9 * each18[FIBRES * i + k]) - (v9 * each19[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 6 * FIBRES + k] = -(v9 * each17[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 7 * FIBRES + k] = v17;
            e[ENTRIES * i + 41 + 9 * FIBRES + k] = v22;
            e[ENTRIES * i + 41 + 11 * FIBRES + k] = v9 * each19[FIBRES * i + k];
            e[ENTRIES * i + 41 + 8 * FIBRES + k] = -(v9 * each20[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 10 * FIBRES + k] = v9 * each20[FIBRES * i + k];
        }
    }
}

static void jacobian_15(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w105 = w + 105 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict w112 = w + 112 * n;
    double *restrict w113 = w + 113 * n;
    double *restrict w114 = w + 114 * n;
    double *restrict w115 = w + 115 * n;
    double *restrict w116 = w + 116 * n;
    double *restrict each17 = w + (SCRATCH + 17 * FIBRES) * n;
    double *restrict each18 = w + (SCRATCH + 18 * FIBRES) * n;
    double *restrict each19 = w + (SCRATCH + 19 * FIBRES) * n;
    double *restrict each20 = w + (SCRATCH + 20 * FIBRES) * n;
    const double c1 = squared(p[10]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[ENTRIES * i + 22] = v9 * w105[i];
    e[ENTRIES * i + 25] = v9 * w106[i];
    e[ENTRIES * i + 28] = v9 * w107[i];
    e[ENTRIES * i + 31] = v9 * w108[i];
    e[ENTRIES * i + 20] = v9 * w109[i];
    e[ENTRIES * i + 23] = v9 * w110[i];
    e[ENTRIES * i + 26] = v9 * w111[i];
    e[ENTRIES * i + 29] = v9 * w112[i];
    e[ENTRIES * i + 21] = v9 * w113[i];
    e[ENTRIES * i + 24] = v9 * w114[i];
    e[ENTRIES * i + 27] = v9 * w115[i];
    e[ENTRIES * i + 30] = v9 * w116[i];
    for (int k = 0; k < FIBRES; k++) {
        e[ENTRIES * i + 41 + 7 * FIBRES + k] = v9 * each17[FIBRES * i + k];
        e[ENTRIES * i + 41 + 9 * FIBRES + k] = v9 * each18[FIBRES * i + k];
        e[ENTRIES * i + 41 + 11 * FIBRES + k] = v9 * each19[FIBRES * i + k];
        e[ENTRIES * i + 41 + 10 * FIBRES + k] = v9 * each20[FIBRES * i + k];
    }
    (void)n;
}

static void work_0(int n, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w117 = w + 117 * n;
    const double c1 = p[7];
    const double c2 = p[5];
    const double c5 = (-0.5) * p[1];
    const double c22 = 0.8333333333333334 * c2;
    const double c25 = 2.0 * p[8];
    const double c26 = 2.0 + c25;
    const double c27 = c22 / c26;
    const double c37 = 1e-12 * c2;
    const double c38 = squared(c37);
    const double c44 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum9 = 0.0;
        const double v7 = c5 * w5[i];
        const double v10 = w3[i];
        const double v12 = sqrt(v10) * v10;
        const double v16 = log(v10);
        const double v29 = w4[i] / v10;
        for (int k = 0; k < FIBRES; k++) {
            const double v18 = c2 * ((((v7 * zeta[k]) / v12) - y[SLOTS * i + 5 + k]) + v16);
            const double v34 = 3.0 * squared((c27 * (v29 - y[SLOTS * i + 5 + 1 * FIBRES + k])));
            const double v40 = sqrt(larger(squared(v18) + v34, c38));
            const double v49 = (double)(c1 < v40) != 0.0 ? ((v40 * ((v40 - c1) * c44)) * weight[k]) : 0.0;
            sum9 += v49;
        }
        w117[i] = sum9;
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
        q[1] += (g[7 * i + 3] * c27) * w2[i];
    }
}

static void work_2(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w117 = w + 117 * n;
    const double c3 = p[10];
    const double c6 = p[0] / c3;
    const double c7 = squared(c6);
    const double c8 = p[2] * c7;
    const double c9 = c3 / c8;
    for (int i = 0; i < n - 1; i++) {
        q[0] += (g[7 * i + 1] * w117[i]) * c9;
    }
}

static void work_3(int n, const double *y, double *w)
{
    double *restrict w118 = w + 118 * n;
    for (int i = 1; i < n - 1; i++) {
        w118[i] = y[SLOTS * i + 2];
    }
}

static void work_4(int n, const double *y, double *w)
{
    double *restrict w119 = w + 119 * n;
    for (int i = 0; i < n - 1; i++) {
        w119[i] = y[SLOTS * i + 3];
    }
}

static void work_5(int n, double *w)
{
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    const int i = n - 1;
    w118[i] = 0.0;
    w119[i] = 0.0;
    (void)n;
}

static void work_6(int n, double *w)
{
    double *restrict w118 = w + 118 * n;
    const int i = 0;
    w118[i] = 0.0;
    (void)n;
}

static void work_7(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    const double c48 = p[0] / p[10];
    const double c49 = squared(c48);
    const double c50 = p[2] * c49;
    const double c51 = 1.0 / c50;
    for (int i = 1; i < n - 1; i++) {
        const double v2 = w0[i];
        const double v5 = g[7 * i + 4];
        const double v8 = w118[i];
        const double v13 = w2[i];
        const double v17 = w119[i];
        const double v21 = (((w0[i + 1] - v2) * v5) * ((w118[i + 1] - v8) * v5)) + (((w2[i + 1] - v13) * v5) * ((w119[i + 1] - v17) * v5));
        const double v27 = g[7 * i - 3];
        const double v40 = (((v2 - w0[i - 1]) * v27) * ((v8 - w118[i - 1]) * v27)) + (((v13 - w2[i - 1]) * v27) * ((v17 - w119[i - 1]) * v27));
        q[2] += (w15[i] * ((v21 / w6[i]) - (v40 / w6[i - 1]))) * c51;
    }
}

static void work_slope_0(int n, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
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
    double *restrict w117 = w + 117 * n;
    double *restrict w120 = w + 120 * n;
    double *restrict w121 = w + 121 * n;
    double *restrict w122 = w + 122 * n;
    double *restrict w123 = w + 123 * n;
    double *restrict w124 = w + 124 * n;
    double *restrict w125 = w + 125 * n;
    double *restrict each21 = w + (SCRATCH + 21 * FIBRES) * n;
    double *restrict each22 = w + (SCRATCH + 22 * FIBRES) * n;
    const double c1 = p[7];
    const double c2 = p[5];
    const double c5 = (-0.5) * p[1];
    const double c23 = 0.8333333333333334 * c2;
    const double c26 = 2.0 * p[8];
    const double c27 = 2.0 + c26;
    const double c28 = c23 / c27;
    const double c39 = 1e-12 * c2;
    const double c40 = squared(c39);
    const double c51 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum12 = 0.0;
        double sum9 = 0.0;
        const double v7 = c5 * w5[i];
        const double v10 = w3[i];
        const double v11 = sqrt(v10);
        const double v13 = 1.0 / (v11 * v10);
        const double v17 = log(v10);
        const double v30 = 1.0 / v10;
        const double v31 = w4[i] * v30;
        const double v113 = v31 * v30;
        const double v121 = 2.0 * v11;
        for (int k = 0; k < FIBRES; k++) {
            const double v8 = zeta[k];
            const double v14 = (v7 * v8) * v13;
            const double v19 = c2 * ((v14 - y[SLOTS * i + 5 + k]) + v17);
            const double v34 = c28 * (v31 - y[SLOTS * i + 5 + 1 * FIBRES + k]);
            const double v37 = squared(v19) + (3.0 * squared(v34));
            const double v42 = sqrt(larger(v37, c40));
            const double v43 = (double)(c1 < v42);
            const double v45 = (double)(c40 <= v37);
            const double v52 = (v42 - c1) * c51;
            const double v53 = weight[k];
            const double v60 = (v45 / (v45 + (double)(v37 <= c40))) * (((v52 * v53) + ((v42 * v53) * c51)) / (2.0 * v42));
            const double v62 = c2 * ((2.0 * v19) * v60);
            const double v87 = c28 * ((2.0 * v34) * (3.0 * v60));
            const double v117 = (v14 * v13) * v62;
            const double v123 = (((v62 * v30) - (v113 * v87)) - (v11 * v117)) - ((v10 * v117) / v121);
            each21[FIBRES * i + k] = v43 != 0.0 ? (-v62) : 0.0;
            each22[FIBRES * i + k] = v43 != 0.0 ? (-v87) : 0.0;
            sum10 += v43 != 0.0 ? (v87 * v30) : 0.0;
            sum11 += v43 != 0.0 ? v123 : 0.0;
            sum12 += v43 != 0.0 ? (c5 * (v8 * (v62 * v13))) : 0.0;
            sum9 += v43 != 0.0 ? ((v42 * v52) * v53) : 0.0;
        }
        const double v65 = sum10;
        const double v68 = sum11;
        const double v72 = sum12;
        w117[i] = sum9;
        w120[i] = ((v65 * w24[i]) + (v68 * w18[i])) + (v72 * w30[i]);
        w121[i] = ((v65 * w25[i]) + (v68 * w19[i])) + (v72 * w31[i]);
        w122[i] = (v65 * w26[i]) + (v68 * w20[i]);
        w123[i] = (v65 * w27[i]) + (v68 * w21[i]);
        w124[i] = (v65 * w28[i]) + (v68 * w22[i]);
        w125[i] = (v65 * w29[i]) + (v68 * w23[i]);
    }
}

static void work_slope_1(int n, double t, const double *p, const double *g, double *s)
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
        s[SLOTS * n + SLOTS * i + 1] += g[7 * i + 3] * c27;
    }
}

static void work_slope_2(int n, const double *p, const double *g, double *w, double *s)
{
    double *restrict w120 = w + 120 * n;
    double *restrict w121 = w + 121 * n;
    double *restrict w122 = w + 122 * n;
    double *restrict w123 = w + 123 * n;
    double *restrict w124 = w + 124 * n;
    double *restrict w125 = w + 125 * n;
    double *restrict each21 = w + (SCRATCH + 21 * FIBRES) * n;
    double *restrict each22 = w + (SCRATCH + 22 * FIBRES) * n;
    const double c0 = p[10];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v8 = c6 * g[7 * i + 1];
        s[SLOTS * i + 4] += v8 * w120[i];
        s[SLOTS * (i + 1) + 4] += v8 * w121[i];
        s[SLOTS * i + 0] += v8 * w122[i];
        s[SLOTS * (i + 1) + 0] += v8 * w123[i];
        s[SLOTS * i + 1] += v8 * w124[i];
        s[SLOTS * (i + 1) + 1] += v8 * w125[i];
        for (int k = 0; k < FIBRES; k++) {
            s[SLOTS * i + 5 + k] += v8 * each21[FIBRES * i + k];
            s[SLOTS * i + 5 + 1 * FIBRES + k] += v8 * each22[FIBRES * i + k];
        }
    }
}

static void work_slope_3(int n, const double *y, double *w)
{
    double *restrict w118 = w + 118 * n;
    for (int i = 1; i < n - 1; i++) {
        w118[i] = y[SLOTS * i + 2];
    }
}

static void work_slope_4(int n, const double *y, double *w)
{
    double *restrict w119 = w + 119 * n;
    for (int i = 0; i < n - 1; i++) {
        w119[i] = y[SLOTS * i + 3];
    }
}

static void work_slope_5(int n, double *w)
{
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    const int i = n - 1;
    w118[i] = 0.0;
    w119[i] = 0.0;
    (void)n;
}

static void work_slope_6(int n, double *w)
{
    double *restrict w118 = w + 118 * n;
    const int i = 0;
    w118[i] = 0.0;
    (void)n;
}

static void work_slope_7(int n, const double *p, const double *g, double *w, double *s)
{
    double *restrict w0 = w;
    double *restrict w2 = w + 2 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
    double *restrict w34 = w + 34 * n;
    double *restrict w35 = w + 35 * n;
    double *restrict w84 = w + 84 * n;
    double *restrict w85 = w + 85 * n;
    double *restrict w86 = w + 86 * n;
    double *restrict w87 = w + 87 * n;
    double *restrict w88 = w + 88 * n;
    double *restrict w89 = w + 89 * n;
    double *restrict w90 = w + 90 * n;
    double *restrict w91 = w + 91 * n;
    double *restrict w92 = w + 92 * n;
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    const double c48 = p[0] / p[10];
    const double c49 = squared(c48);
    const double c50 = p[2] * c49;
    const double c51 = 1.0 / c50;
    for (int i = 1; i < n - 1; i++) {
        const double v1 = w0[i];
        const double v4 = g[7 * i + 4];
        const double v5 = (w0[i + 1] - v1) * v4;
        const double v7 = w118[i];
        const double v9 = (w118[i + 1] - v7) * v4;
        const double v12 = w2[i];
        const double v14 = (w2[i + 1] - v12) * v4;
        const double v16 = w119[i];
        const double v18 = (w119[i + 1] - v16) * v4;
        const double v22 = 1.0 / w6[i];
        const double v23 = ((v5 * v9) + (v14 * v18)) * v22;
        const double v27 = g[7 * i - 3];
        const double v28 = (v1 - w0[i - 1]) * v27;
        const double v31 = (v7 - w118[i - 1]) * v27;
        const double v35 = (v12 - w2[i - 1]) * v27;
        const double v38 = (v16 - w119[i - 1]) * v27;
        const double v42 = 1.0 / w6[i - 1];
        const double v43 = ((v28 * v31) + (v35 * v38)) * v42;
        const double v52 = (v23 - v43) * c51;
        const double v64 = w15[i] * c51;
        const double v65 = v64 * v42;
        const double v67 = (v28 * v65) * v27;
        const double v68 = v64 * v22;
        const double v70 = (v5 * v68) * v4;
        const double v74 = (v35 * v65) * v27;
        const double v76 = (v14 * v68) * v4;
        const double v82 = (v43 * v42) * v64;
        const double v87 = (v31 * v65) * v27;
        const double v95 = (v23 * v22) * v64;
        const double v100 = (v9 * v68) * v4;
        const double v102 = (((v52 * w88[i]) + (v82 * w33[i - 1])) - (v95 * w32[i])) - (v87 + v100);
        const double v115 = (v38 * v65) * v27;
        const double v126 = (v18 * v68) * v4;
        const double v128 = (((v52 * w91[i]) + (v82 * w35[i - 1])) - (v95 * w34[i])) - (v115 + v126);
        s[2 * SLOTS * n + SLOTS * (i - 1) + 4] += v52 * w84[i];
        s[2 * SLOTS * n + SLOTS * i + 4] += v52 * w85[i];
        s[2 * SLOTS * n + SLOTS * (i + 1) + 4] += v52 * w86[i];
        s[2 * SLOTS * n + SLOTS * (i - 1) + 2] += v67;
        s[2 * SLOTS * n + SLOTS * i + 2] += -(v67 + v70);
        s[2 * SLOTS * n + SLOTS * (i + 1) + 2] += v70;
        s[2 * SLOTS * n + SLOTS * (i - 1) + 3] += v74;
        s[2 * SLOTS * n + SLOTS * i + 3] += -(v74 + v76);
        s[2 * SLOTS * n + SLOTS * (i + 1) + 3] += v76;
        s[2 * SLOTS * n + SLOTS * (i - 1) + 0] += ((v52 * w87[i]) + (v82 * w32[i - 1])) + v87;
        s[2 * SLOTS * n + SLOTS * i + 0] += v102;
        s[2 * SLOTS * n + SLOTS * (i + 1) + 0] += ((v52 * w89[i]) - (v95 * w33[i])) + v100;
        s[2 * SLOTS * n + SLOTS * (i - 1) + 1] += ((v52 * w90[i]) + (v82 * w34[i - 1])) + v115;
        s[2 * SLOTS * n + SLOTS * i + 1] += v128;
        s[2 * SLOTS * n + SLOTS * (i + 1) + 1] += ((v52 * w92[i]) - (v95 * w35[i])) + v126;
        for (int k = 0; k < FIBRES; k++) {
            s[2 * SLOTS * n + SLOTS * (i - 1) + 5 + k] += v52 * each11[FIBRES * i + k];
            s[2 * SLOTS * n + SLOTS * i + 5 + k] += v52 * each12[FIBRES * i + k];
        }
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * SLOTS; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, f);
    rates_2(n, y, w);
    rates_3(n, y, w);
    rates_4(n, w);
    rates_5(n, g, w);
    rates_6(n, p, g, w);
    rates_7(n, p, y, w, f);
    rates_8(n, p, g, w);
    rates_9(n, p, g, w, f);
    rates_10(n, g, w);
    rates_11(n, g, w);
    rates_12(n, g, w);
    rates_13(n, p, g, w, f);
    rates_14(n, t, p, g, w, f);
    rates_15(n, t, p, g, w, f);
    return SOFTCAT_SOLVED;
}

static int jacobian(const softcat_filament *filament, double t, const double *y, double *e,
                    double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * ENTRIES; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, e);
    jacobian_2(n, y, w);
    jacobian_3(n, y, w);
    jacobian_4(n, w);
    jacobian_5(n, g, w);
    jacobian_6(n, p, g, w);
    jacobian_7(n, p, y, w, e);
    jacobian_8(n, p, g, w);
    jacobian_9(n, p, g, w, e);
    jacobian_10(n, g, w);
    jacobian_11(n, g, w);
    jacobian_12(n, g, w);
    jacobian_13(n, p, g, w, e);
    jacobian_14(n, p, g, w, e);
    jacobian_15(n, p, g, w, e);
    return SOFTCAT_SOLVED;
}

static int work(const softcat_filament *filament, double t, const double *y, double *q,
                double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, y, w);
    work_1(n, t, p, g, w, q);
    work_2(n, p, g, w, q);
    work_3(n, y, w);
    work_4(n, y, w);
    work_5(n, w);
    work_6(n, w);
    work_7(n, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 3 * SLOTS; k++) s[k] = 0.0;
    work_slope_0(n, p, y, w);
    work_slope_1(n, t, p, g, s);
    work_slope_2(n, p, g, w, s);
    work_slope_3(n, y, w);
    work_slope_4(n, y, w);
    work_slope_5(n, w);
    work_slope_6(n, w);
    work_slope_7(n, p, g, w, s);
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
    2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11,
    12, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6,
    7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16,
    17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20, 13, 14, 15,
    16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20, 13, 14,
    15, 16, 17, 18, 19, 20, 13, 14, 15, 16, 17, 18, 19, 20};
static const int offset[] = {
    0, 0, -2, -2, -2, -1, -1, -1, 0, 0, 0, 1, 1, 1, 2, 2, 2, -2, -2, -2, -1, -1, -1, 0, 0, 0, 1,
    1, 1, 2, 2, 2, -1, -1, -1, 0, 0, 0, 1, 1, 1, -2, -2, -2, -2, -2, -2, -2, -2, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 1, 1, 1, 1, 1, 1, 1, 1, -2, -2, -2, -2, -2, -2, -2, -2, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1,
    1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int column[] = {
    2, 3, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1,
    4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14,
    15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7,
    8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17,
    18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10,
    11, 12, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11,
    12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4, 4,
    4, 4, 4, 4, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 0, 0, 0, 0, 0,
    0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4, 4, 4, 4, 4, 4, 4, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1,
    1, 1, 1, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20,
    0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4, 4, 4, 4, 4, 4, 4};

const softcat_model softcat_filament_model = {
    21, 16, 11, 7, 310, 297, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
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
    0.0, 0.0, 0.0, 0.0, 0.0, (-0.9602898564975362), (-0.7966664774136267), (-0.525532409916329),
    (-0.18343464249564978), 0.18343464249564978, 0.525532409916329, 0.7966664774136267,
    0.9602898564975362, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

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
    .psi = 4,
    .rest_length = 0,
    .time_scale = 10,
    .gravity = 3,
    .density = 2,
    .span = -1,
    .drop = -1,
    .left_angle = -1,
    .right_angle = -1,
    .curvature = -1,
    .motion = -1,
    .motion_rows = 0,
    .stretch = 1.0,
    .initial_mean = 0,
    .initial_mean_count = 0,
    .initial_bending = 0,
    .initial_bending_count = 0,
    .thickness = 0,
    .thickness_count = 0,
    .grading = 19.597537758558094,
    .relative = 0.001,
    .absolute = 4.6597500000000004e-08,
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

int softcat_solve_with(const double *params, int cells, const double *times, int n,
    const softcat_settings *settings, const softcat_results *results, softcat_status *status)
{
    return softcat_structure_solve(&softcat_filament_structure, params, cells, times, n, settings,
        results, status);
}

int softcat_solve(const double *params, int cells, const double *times, int n, double *out,
    softcat_status *status)
{
    const softcat_results results = {.positions = out};
    return softcat_solve_with(params, cells, times, n, 0, &results, status);
}

int softcat_midpoint(const double *params, int cells, const double *times, int n, double *out,
    softcat_status *status)
{
    const softcat_results results = {.midpoint = out};
    return softcat_solve_with(params, cells, times, n, 0, &results, status);
}

int softcat_solve_sensitivities(const double *params, int cells, const double *times, int n,
    const int *by, int by_count, double *out, double *derivatives, softcat_status *status)
{
    const softcat_settings settings = {.by = by, .by_count = by_count};
    const softcat_results results = {.positions = out, .derivatives = derivatives};
    return softcat_solve_with(params, cells, times, n, &settings, &results, status);
}
