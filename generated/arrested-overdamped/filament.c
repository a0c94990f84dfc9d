/*
 * Yields, flows slowly and stops
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres, necking-gradient
 * Digest of the structure: 60f886bde4993992d8a87c7c868be7fb7ce3a068eb4636f3888a0aa7c2c51001
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES 8
#define SLOTS 21
#define ENTRIES 297
#define SCRATCH 112

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
    const double c27 = 1.0 / p[0];
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
        w5[i] = ((v7 - v6) * v4) * c27;
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
    const double c5 = p[5];
    const double c6 = 0.5 * c5;
    const double c27 = 0.4166666666666667 * c5;
    const double c30 = 2.0 * p[8];
    const double c31 = 2.0 + c30;
    const double c32 = c27 / c31;
    const double c43 = 1e-12 * c5;
    const double c44 = squared(c43);
    const double c50 = 1.0 / p[6];
    const double c54 = p[10];
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v9 = (-0.5) * w5[i];
        const double v14 = w3[i];
        const double v16 = sqrt(v14) * v14;
        const double v18 = log(v14);
        const double v34 = w4[i] / v14;
        for (int k = 0; k < FIBRES; k++) {
            const double v10 = zeta[k];
            const double v21 = ((((v9 * v10) * p[1]) / v16) + v18) - y[SLOTS * i + 5 + k];
            const double v23 = c6 * (2.0 * v21);
            const double v38 = c32 * (2.0 * (v34 - y[SLOTS * i + 5 + 1 * FIBRES + k]));
            const double v46 = sqrt(larger(squared(v23) + (3.0 * squared(v38)), c44));
            const double v47 = (double)(c3 < v46);
            const double v52 = ((v46 - c3) * c50) / v46;
            const double v61 = weight[k];
            f[SLOTS * i + 5 + k] = v47 != 0.0 ? ((v23 * v52) * c54) : 0.0;
            f[SLOTS * i + 5 + 1 * FIBRES + k] = v47 != 0.0 ? (((3.0 * v38) * v52) * c54) : 0.0;
            sum0 += v23 * v61;
            sum1 += v23 * (v61 * v10);
            sum2 += v38 * v61;
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
    const double c0 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v2 = w8[i];
        const double v5 = w3[i];
        const double v6 = sqrt(v5);
        const double v8 = 1.0 / (v6 * v5);
        const double v14 = 1.0 / v5;
        const double v15 = w7[i] * v14;
        const double v17 = w9[i];
        const double v31 = ((((((-0.5) * w5[i]) * v2) * c0) * v8) * v8) * ((v5 / (2.0 * v6)) + v6);
        const double v36 = g[7 * i + 4];
        const double v37 = (w2[i + 1] - w2[i]) * v36;
        const double v43 = (w1[i] + w1[i + 1]) * 0.5;
        const double v44 = cos(v43);
        const double v49 = (w0[i + 1] - w0[i]) * v36;
        const double v50 = sin(v43);
        const double v53 = ((v15 - (((w4[i] * v17) * v14) * v14)) - v31) * ((v37 * v44) - (v49 * v50));
        const double v60 = (g[7 * i + 1] * p[0]) * (v53 - ((v17 * v14) * ((v37 * v50) + (v49 * v44))));
        w10[i] = (c0 * ((-0.5) * v2)) * v8;
        w11[i] = -(v60 * 0.5);
        w12[i] = v15;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    const double c8 = squared(p[10]);
    const double c10 = p[0];
    const double c11 = squared(c10);
    const double c12 = p[2] * c11;
    const double c13 = c12 * c10;
    const double c14 = c8 / c13;
    for (int i = 1; i < n - 1; i++) {
        const double v18 = (((w10[i] + w11[i]) - w10[i - 1]) + w11[i - 1]) * (c14 * g[7 * i + 5]);
        f[SLOTS * i + 4] = v18;
    }
}

static void rates_10(int n, const double *p, const double *g, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w12 = w + 12 * n;
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
        const double v23 = ((((v0 - v1) * g[7 * i + 5]) * c7) * c10) / squared(squared(((v15 * v1) + (v18 * v0))));
        const double v37 = (v23 * c28) * larger(0.0, (v15 * w12[i - 1]) + (v18 * w12[i]));
        w13[i] = v37 * c7;
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
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v5 = w9[i];
        const double v17 = sqrt(v1);
        const double v19 = 1.0 / (v17 * v1);
        const double v25 = ((((((-0.5) * w5[i]) * w8[i]) * p[1]) * v19) * v19) * ((v1 / (2.0 * v17)) + v17);
        const double v26 = ((w7[i] * v2) - (((w4[i] * v5) * v2) * v2)) - v25;
        const double v32 = (w1[i] + w1[i + 1]) * 0.5;
        const double v33 = cos(v32);
        const double v35 = v5 * v2;
        const double v36 = sin(v32);
        const double v43 = g[7 * i + 4];
        const double v46 = ((w13[i + 1] - w13[i]) * v43) / w6[i];
        const double v52 = ((v26 * v33) - (v35 * v36)) - (v46 * ((w0[i + 1] - w0[i]) * v43));
        const double v61 = ((v26 * v36) + (v35 * v33)) - (v46 * ((w2[i + 1] - w2[i]) * v43));
        w14[i] = v52;
        w15[i] = v61;
    }
}

static void rates_14(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w14 = w + 14 * n;
    const double c4 = squared(p[10]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    for (int i = 1; i < n - 1; i++) {
        f[SLOTS * i + 2] = (w14[i] - w14[i - 1]) * (c9 * g[7 * i + 6]);
    }
}

static void rates_15(int n, double t, const double *p, const double *g, double *w, double *f)
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
        f[SLOTS * i + 3] = ((w15[i] - w15[i - 1]) * (c9 * g[7 * i + 6])) - c34;
    }
}

static void rates_16(int n, double t, const double *p, const double *g, double *w, double *f)
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
    f[SLOTS * i + 3] = (w15[i] * (c7 * g[7 * i + 6])) - c32;
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
    const double c40 = 1.0 / p[0];
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
        const double v48 = sqrt(squared(v5) + squared(v17));
        const double v52 = 1.0 / (2.0 * v48);
        const double v53 = ((2.0 * v5) * v4) * v52;
        const double v57 = ((2.0 * v17) * v4) * v52;
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
        w5[i] = ((v7 - v6) * v4) * c40;
        w28[i] = -(v4 * c40);
        w29[i] = c40 * v4;
        w6[i] = v48;
        w30[i] = -v53;
        w31[i] = v53;
        w32[i] = -v57;
        w33[i] = v57;
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
    double *restrict each1 = w + (SCRATCH + 1 * FIBRES) * n;
    double *restrict each2 = w + (SCRATCH + 2 * FIBRES) * n;
    const double c2 = p[5];
    const double c3 = 0.5 * c2;
    const double c58 = 0.4166666666666667 * c2;
    const double c61 = 2.0 * p[8];
    const double c62 = 2.0 + c61;
    const double c63 = c58 / c62;
    const double c83 = p[7];
    const double c88 = p[1];
    const double c114 = 1e-12 * c2;
    const double c115 = squared(c114);
    const double c121 = 1.0 / p[6];
    const double c125 = p[10];
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
        const double v9 = w16[i];
        const double v12 = w28[i];
        const double v15 = w17[i];
        const double v17 = w29[i];
        const double v20 = w18[i];
        const double v22 = w19[i];
        const double v24 = w20[i];
        const double v26 = w21[i];
        const double v48 = w22[i];
        const double v53 = w23[i];
        const double v67 = w24[i];
        const double v71 = w25[i];
        const double v75 = w26[i];
        const double v79 = w27[i];
        const double v86 = (-0.5) * w5[i];
        const double v90 = w3[i];
        const double v91 = sqrt(v90);
        const double v93 = 1.0 / (v91 * v90);
        const double v95 = log(v90);
        const double v104 = 1.0 / v90;
        const double v105 = w4[i] * v104;
        const double v156 = v105 * v104;
        const double v165 = 1.0 / (2.0 * v91);
        for (int k = 0; k < FIBRES; k++) {
            const double v4 = weight[k];
            const double v6 = 2.0 * (c3 * v4);
            const double v29 = zeta[k];
            const double v30 = v4 * v29;
            const double v32 = 2.0 * (c3 * v30);
            const double v65 = 2.0 * (c63 * v4);
            const double v94 = ((v86 * v29) * c88) * v93;
            const double v100 = c3 * (2.0 * ((v94 + v95) - y[SLOTS * i + 5 + k]));
            const double v109 = c63 * (2.0 * (v105 - y[SLOTS * i + 5 + 1 * FIBRES + k]));
            const double v112 = squared(v100) + (3.0 * squared(v109));
            const double v117 = sqrt(larger(v112, c115));
            const double v118 = (double)(c83 < v117);
            const double v123 = 1.0 / v117;
            const double v124 = ((v117 - c83) * c121) * v123;
            const double v126 = v124 * c125;
            const double v127 = 2.0 * v100;
            const double v128 = (double)(c115 <= v112);
            const double v131 = v128 / (v128 + (double)(v112 <= c115));
            const double v132 = v100 * c125;
            const double v135 = v124 * v123;
            const double v139 = 1.0 / (2.0 * v117);
            const double v141 = v131 * ((((v132 * v123) * c121) - (v135 * v132)) * v139);
            const double v145 = 2.0 * (c3 * (v126 + (v127 * v141)));
            const double v148 = 2.0 * v109;
            const double v152 = 2.0 * (c63 * (v148 * (3.0 * v141)));
            const double v153 = v152 * v104;
            const double v159 = v94 * v93;
            const double v160 = v159 * v145;
            const double v167 = (((v145 * v104) - (v156 * v152)) - (v91 * v160)) - ((v90 * v160) * v165);
            const double v173 = (-0.5) * (v29 * (c88 * (v145 * v93)));
            const double v176 = v118 != 0.0 ? (((v153 * v48) + (v167 * v9)) + (v173 * v12)) : 0.0;
            const double v182 = v118 != 0.0 ? (((v153 * v53) + (v167 * v15)) + (v173 * v17)) : 0.0;
            const double v202 = (3.0 * v109) * c125;
            const double v208 = v131 * ((((v202 * v123) * c121) - (v135 * v202)) * v139);
            const double v211 = 2.0 * (c3 * (v127 * v208));
            const double v219 = 2.0 * (c63 * ((3.0 * v126) + (v148 * (3.0 * v208))));
            const double v220 = v219 * v104;
            const double v225 = v159 * v211;
            const double v230 = (((v211 * v104) - (v156 * v219)) - (v91 * v225)) - ((v90 * v225) * v165);
            const double v236 = (-0.5) * (v29 * (c88 * (v211 * v93)));
            const double v239 = v118 != 0.0 ? (((v220 * v48) + (v230 * v9)) + (v236 * v12)) : 0.0;
            const double v245 = v118 != 0.0 ? (((v220 * v53) + (v230 * v15)) + (v236 * v17)) : 0.0;
            const double v268 = v159 * v6;
            const double v279 = v159 * v32;
            each0[FIBRES * i + k] = -v6;
            each1[FIBRES * i + k] = -v32;
            each2[FIBRES * i + k] = -v65;
            e[ENTRIES * i + 41 + 19 * FIBRES + k] = v118 != 0.0 ? (-v145) : 0.0;
            e[ENTRIES * i + 41 + 18 * FIBRES + k] = v176;
            e[ENTRIES * i + 41 + 23 * FIBRES + k] = v182;
            e[ENTRIES * i + 41 + 20 * FIBRES + k] = v118 != 0.0 ? (-v152) : 0.0;
            e[ENTRIES * i + 41 + 16 * FIBRES + k] = v118 != 0.0 ? ((v153 * v67) + (v167 * v20)) : 0.0;
            e[ENTRIES * i + 41 + 21 * FIBRES + k] = v118 != 0.0 ? ((v153 * v71) + (v167 * v22)) : 0.0;
            e[ENTRIES * i + 41 + 17 * FIBRES + k] = v118 != 0.0 ? ((v153 * v75) + (v167 * v24)) : 0.0;
            e[ENTRIES * i + 41 + 22 * FIBRES + k] = v118 != 0.0 ? ((v153 * v79) + (v167 * v26)) : 0.0;
            e[ENTRIES * i + 41 + 27 * FIBRES + k] = v118 != 0.0 ? (-v211) : 0.0;
            e[ENTRIES * i + 41 + 26 * FIBRES + k] = v239;
            e[ENTRIES * i + 41 + 31 * FIBRES + k] = v245;
            e[ENTRIES * i + 41 + 28 * FIBRES + k] = v118 != 0.0 ? (-v219) : 0.0;
            e[ENTRIES * i + 41 + 24 * FIBRES + k] = v118 != 0.0 ? ((v220 * v67) + (v230 * v20)) : 0.0;
            e[ENTRIES * i + 41 + 29 * FIBRES + k] = v118 != 0.0 ? ((v220 * v71) + (v230 * v22)) : 0.0;
            e[ENTRIES * i + 41 + 25 * FIBRES + k] = v118 != 0.0 ? ((v220 * v75) + (v230 * v24)) : 0.0;
            e[ENTRIES * i + 41 + 30 * FIBRES + k] = v118 != 0.0 ? ((v220 * v79) + (v230 * v26)) : 0.0;
            sum0 += v100 * v4;
            sum1 += v100 * v30;
            sum2 += v109 * v4;
            sum3 += ((v6 * v104) - (v91 * v268)) - ((v90 * v268) * v165);
            sum4 += (-0.5) * (v29 * (c88 * (v6 * v93)));
            sum5 += ((v32 * v104) - (v91 * v279)) - ((v90 * v279) * v165);
            sum6 += (-0.5) * (v29 * (c88 * (v32 * v93)));
            sum7 += v65 * v104;
            sum8 += -(v156 * v65);
        }
        const double v8 = sum3;
        const double v11 = sum4;
        const double v34 = sum5;
        const double v36 = sum6;
        const double v47 = sum7;
        const double v50 = sum8;
        w7[i] = sum0;
        w34[i] = (v8 * v9) + (v11 * v12);
        w35[i] = (v8 * v15) + (v11 * v17);
        w36[i] = v8 * v20;
        w37[i] = v8 * v22;
        w38[i] = v8 * v24;
        w39[i] = v8 * v26;
        w8[i] = sum1;
        w40[i] = (v34 * v9) + (v36 * v12);
        w41[i] = (v34 * v15) + (v36 * v17);
        w42[i] = v34 * v20;
        w43[i] = v34 * v22;
        w44[i] = v34 * v24;
        w45[i] = v34 * v26;
        w9[i] = sum2;
        w46[i] = (v47 * v48) + (v50 * v9);
        w47[i] = (v47 * v53) + (v50 * v15);
        w48[i] = (v47 * v67) + (v50 * v20);
        w49[i] = (v47 * v71) + (v50 * v22);
        w50[i] = (v47 * v75) + (v50 * v24);
        w51[i] = (v47 * v79) + (v50 * v26);
    }
}

static void jacobian_8(int n, const double *p, const double *g, double *w)
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
    double *restrict each1 = w + (SCRATCH + 1 * FIBRES) * n;
    double *restrict each2 = w + (SCRATCH + 2 * FIBRES) * n;
    double *restrict each3 = w + (SCRATCH + 3 * FIBRES) * n;
    double *restrict each4 = w + (SCRATCH + 4 * FIBRES) * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    const double c0 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v2 = w8[i];
        const double v5 = w3[i];
        const double v6 = sqrt(v5);
        const double v8 = 1.0 / (v6 * v5);
        const double v9 = (c0 * ((-0.5) * v2)) * v8;
        const double v11 = (-0.5) * (c0 * v8);
        const double v14 = w40[i];
        const double v16 = v9 * v8;
        const double v20 = 1.0 / (2.0 * v6);
        const double v22 = (v6 * v16) + ((v5 * v16) * v20);
        const double v23 = w16[i];
        const double v26 = w41[i];
        const double v28 = w17[i];
        const double v31 = w42[i];
        const double v33 = w18[i];
        const double v36 = w43[i];
        const double v38 = w19[i];
        const double v41 = w44[i];
        const double v43 = w20[i];
        const double v46 = w45[i];
        const double v48 = w21[i];
        const double v53 = g[7 * i + 1] * p[0];
        const double v55 = 1.0 / v5;
        const double v56 = w7[i] * v55;
        const double v57 = w4[i];
        const double v58 = w9[i];
        const double v61 = ((v57 * v58) * v55) * v55;
        const double v64 = (-0.5) * w5[i];
        const double v68 = (((v64 * v2) * c0) * v8) * v8;
        const double v69 = v5 * v20;
        const double v70 = v69 + v6;
        const double v72 = (v56 - v61) - (v68 * v70);
        const double v76 = g[7 * i + 4];
        const double v77 = (w2[i + 1] - w2[i]) * v76;
        const double v83 = (w1[i] + w1[i + 1]) * 0.5;
        const double v84 = cos(v83);
        const double v89 = (w0[i + 1] - w0[i]) * v76;
        const double v90 = sin(v83);
        const double v92 = (v77 * v84) - (v89 * v90);
        const double v94 = v58 * v55;
        const double v97 = (v77 * v90) + (v89 * v84);
        const double v103 = (-0.5) * v53;
        const double v104 = v92 * v103;
        const double v105 = v104 * v55;
        const double v108 = v70 * v104;
        const double v109 = v108 * v8;
        const double v111 = c0 * (v109 * v8);
        const double v112 = v64 * v111;
        const double v116 = v97 * v103;
        const double v118 = v68 * v104;
        const double v123 = (((v94 * v55) * v116) - (v118 * v20)) + ((v61 * v55) * v104);
        const double v126 = v56 * v55;
        const double v132 = ((v68 * v8) * v108) + (v68 * v109);
        const double v141 = (((2.0 * ((v69 * v20) * v118)) - v118) + (v5 * v132)) * v20;
        const double v142 = (((v123 + (v61 * v105)) - (v126 * v104)) + (v6 * v132)) + v141;
        const double v144 = v105 * v55;
        const double v145 = v58 * v144;
        const double v149 = w34[i];
        const double v153 = (((v142 * v23) - (v145 * w22[i])) + (v105 * v149)) - (v112 * v14);
        const double v155 = (-0.5) * (v2 * v111);
        const double v159 = v94 * v103;
        const double v161 = v72 * v103;
        const double v169 = (v84 * ((v77 * v159) + (v89 * v161))) + (v90 * ((v77 * v161) - (v89 * v159)));
        const double v170 = 0.5 * v169;
        const double v174 = (v116 * v55) + (v57 * v144);
        const double v182 = w35[i];
        const double v186 = (((v142 * v28) - (v145 * w23[i])) + (v105 * v182)) - (v112 * v26);
        const double v201 = w36[i];
        const double v205 = (((v142 * v33) - (v145 * w24[i])) + (v105 * v201)) - (v112 * v31);
        const double v212 = ((v84 * v159) + (v90 * v161)) * v76;
        const double v218 = w37[i];
        const double v222 = (((v142 * v38) - (v145 * w25[i])) + (v105 * v218)) - (v112 * v36);
        const double v231 = w38[i];
        const double v235 = (((v142 * v43) - (v145 * w26[i])) + (v105 * v231)) - (v112 * v41);
        const double v242 = ((v84 * v161) - (v90 * v159)) * v76;
        const double v248 = w39[i];
        const double v252 = (((v142 * v48) - (v145 * w27[i])) + (v105 * v248)) - (v112 * v46);
        w10[i] = v9;
        w52[i] = (v11 * v14) - (v22 * v23);
        w53[i] = (v11 * v26) - (v22 * v28);
        w54[i] = (v11 * v31) - (v22 * v33);
        w55[i] = (v11 * v36) - (v22 * v38);
        w56[i] = (v11 * v41) - (v22 * v43);
        w57[i] = (v11 * v46) - (v22 * v48);
        w11[i] = -((v53 * ((v72 * v92) - (v94 * v97))) * 0.5);
        w58[i] = ((v153 - (v155 * w28[i])) - v170) - (v174 * w46[i]);
        w59[i] = ((v186 - (v155 * w29[i])) - v170) - (v174 * w47[i]);
        w60[i] = (v205 - (v174 * w48[i])) + v212;
        w61[i] = (v222 - (v174 * w49[i])) - v212;
        w62[i] = (v235 - (v174 * w50[i])) - v242;
        w63[i] = (v252 - (v174 * w51[i])) + v242;
        w12[i] = v56;
        w64[i] = (v149 * v55) - (v126 * v23);
        w65[i] = (v182 * v55) - (v126 * v28);
        w66[i] = (v201 * v55) - (v126 * v33);
        w67[i] = (v218 * v55) - (v126 * v38);
        w68[i] = (v231 * v55) - (v126 * v43);
        w69[i] = (v248 * v55) - (v126 * v48);
        for (int k = 0; k < FIBRES; k++) {
            const double v12 = each1[FIBRES * i + k];
            const double v106 = each0[FIBRES * i + k];
            each3[FIBRES * i + k] = v11 * v12;
            each4[FIBRES * i + k] = (v105 * v106) - (v112 * v12);
            each5[FIBRES * i + k] = -(v174 * each2[FIBRES * i + k]);
            each6[FIBRES * i + k] = v106 * v55;
        }
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
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
    double *restrict each3 = w + (SCRATCH + 3 * FIBRES) * n;
    double *restrict each4 = w + (SCRATCH + 4 * FIBRES) * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    const double c1 = squared(p[10]);
    const double c3 = p[0];
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c5 * c3;
    const double c7 = c1 / c6;
    for (int i = 1; i < n - 1; i++) {
        const double v10 = c7 * g[7 * i + 5];
        const double v33 = ((v10 * w52[i]) - (v10 * w53[i - 1])) + (v10 * w59[i - 1]);
        const double v58 = ((v10 * w54[i]) - (v10 * w55[i - 1])) + (v10 * w61[i - 1]);
        const double v79 = ((v10 * w56[i]) - (v10 * w57[i - 1])) + (v10 * w63[i - 1]);
        e[ENTRIES * i + 34] = (v10 * w58[i - 1]) - (v10 * w52[i - 1]);
        e[ENTRIES * i + 37] = v33 + (v10 * w58[i]);
        e[ENTRIES * i + 40] = (v10 * w53[i]) + (v10 * w59[i]);
        e[ENTRIES * i + 32] = (v10 * w60[i - 1]) - (v10 * w54[i - 1]);
        e[ENTRIES * i + 35] = v58 + (v10 * w60[i]);
        e[ENTRIES * i + 38] = (v10 * w55[i]) + (v10 * w61[i]);
        e[ENTRIES * i + 33] = (v10 * w62[i - 1]) - (v10 * w56[i - 1]);
        e[ENTRIES * i + 36] = v79 + (v10 * w62[i]);
        e[ENTRIES * i + 39] = (v10 * w57[i]) + (v10 * w63[i]);
        for (int k = 0; k < FIBRES; k++) {
            const double v15 = (v10 * each4[FIBRES * (i - 1) + k]) - (v10 * each3[FIBRES * (i - 1) + k]);
            const double v20 = (v10 * each3[FIBRES * i + k]) + (v10 * each4[FIBRES * i + k]);
            e[ENTRIES * i + 41 + 12 * FIBRES + k] = v15;
            e[ENTRIES * i + 41 + 14 * FIBRES + k] = v20;
            e[ENTRIES * i + 41 + 13 * FIBRES + k] = v10 * each5[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 41 + 15 * FIBRES + k] = v10 * each5[FIBRES * i + k];
        }
    }
}

static void jacobian_10(int n, const double *p, const double *g, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w30 = w + 30 * n;
    double *restrict w31 = w + 31 * n;
    double *restrict w32 = w + 32 * n;
    double *restrict w33 = w + 33 * n;
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
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
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
        const double v20 = (v15 * v1) + (v18 * v0);
        const double v21 = squared(v20);
        const double v23 = 1.0 / squared(v21);
        const double v24 = ((((v0 - v1) * v4) * c7) * c10) * v23;
        const double v30 = v24 * c29;
        const double v36 = (v15 * w12[i - 1]) + (v18 * w12[i]);
        const double v37 = larger(0.0, v36);
        const double v40 = (double)(0.0 <= v36);
        const double v45 = (v40 / ((double)(v36 <= 0.0) + v40)) * (v30 * c7);
        const double v46 = v15 * v45;
        const double v49 = v18 * v45;
        const double v67 = c29 * (v37 * c7);
        const double v70 = (2.0 * v20) * ((2.0 * v21) * ((v24 * v23) * v67));
        const double v75 = ((c10 * (v67 * v23)) * c7) * v4;
        const double v76 = (v15 * v70) + v75;
        const double v81 = v75 - (v18 * v70);
        const double v89 = ((v81 * w30[i]) - (v76 * w31[i - 1])) + (v46 * w67[i - 1]);
        const double v110 = ((v81 * w32[i]) - (v76 * w33[i - 1])) + (v46 * w69[i - 1]);
        w13[i] = (v30 * v37) * c7;
        w70[i] = v46 * w64[i - 1];
        w71[i] = (v46 * w65[i - 1]) + (v49 * w64[i]);
        w72[i] = v49 * w65[i];
        w73[i] = (v46 * w66[i - 1]) - (v76 * w30[i - 1]);
        w74[i] = v89 + (v49 * w66[i]);
        w75[i] = (v81 * w31[i]) + (v49 * w67[i]);
        w76[i] = (v46 * w68[i - 1]) - (v76 * w32[i - 1]);
        w77[i] = v110 + (v49 * w68[i]);
        w78[i] = (v81 * w33[i]) + (v49 * w69[i]);
        for (int k = 0; k < FIBRES; k++) {
            each7[FIBRES * i + k] = v46 * each6[FIBRES * (i - 1) + k];
            each8[FIBRES * i + k] = v49 * each6[FIBRES * i + k];
        }
    }
}

static void jacobian_11(int n, double *w)
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
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
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
    for (int k = 0; k < FIBRES; k++) {
        each7[FIBRES * i + k] = 0.0;
        each8[FIBRES * i + k] = 0.0;
    }
    (void)n;
}

static void jacobian_12(int n, double *w)
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
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
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
    for (int k = 0; k < FIBRES; k++) {
        each7[FIBRES * i + k] = 0.0;
        each8[FIBRES * i + k] = 0.0;
    }
    (void)n;
}

static void jacobian_13(int n, const double *p, const double *g, double *w)
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
    double *restrict each1 = w + (SCRATCH + 1 * FIBRES) * n;
    double *restrict each2 = w + (SCRATCH + 2 * FIBRES) * n;
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
    double *restrict each9 = w + (SCRATCH + 9 * FIBRES) * n;
    double *restrict each10 = w + (SCRATCH + 10 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    double *restrict each13 = w + (SCRATCH + 13 * FIBRES) * n;
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    double *restrict each16 = w + (SCRATCH + 16 * FIBRES) * n;
    const double c15 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v3 = w7[i] * v2;
        const double v4 = w4[i];
        const double v5 = w9[i];
        const double v8 = ((v4 * v5) * v2) * v2;
        const double v12 = (-0.5) * w5[i];
        const double v13 = w8[i];
        const double v17 = sqrt(v1);
        const double v19 = 1.0 / (v17 * v1);
        const double v21 = (((v12 * v13) * c15) * v19) * v19;
        const double v23 = 1.0 / (2.0 * v17);
        const double v24 = v1 * v23;
        const double v25 = v24 + v17;
        const double v27 = (v3 - v8) - (v21 * v25);
        const double v33 = (w1[i] + w1[i + 1]) * 0.5;
        const double v34 = cos(v33);
        const double v36 = v5 * v2;
        const double v37 = sin(v33);
        const double v44 = g[7 * i + 4];
        const double v47 = 1.0 / w6[i];
        const double v48 = ((w13[i + 1] - w13[i]) * v44) * v47;
        const double v52 = (w0[i + 1] - w0[i]) * v44;
        const double v56 = (v52 * v47) * v44;
        const double v59 = v34 * v2;
        const double v62 = v25 * v34;
        const double v63 = v62 * v19;
        const double v65 = c15 * (v63 * v19);
        const double v66 = v12 * v65;
        const double v79 = w70[i];
        const double v81 = v36 * v2;
        const double v83 = v21 * v34;
        const double v86 = v21 * v19;
        const double v89 = (v86 * v62) + (v21 * v63);
        const double v92 = v24 * v23;
        const double v99 = (((v81 * v37) - (v83 * v23)) + (v17 * v89)) + ((((2.0 * (v92 * v83)) - v83) + (v1 * v89)) * v23);
        const double v100 = v8 * v2;
        const double v105 = v3 * v2;
        const double v107 = ((v99 + (v100 * v34)) + (v8 * v59)) - (v105 * v34);
        const double v108 = w16[i];
        const double v110 = v59 * v2;
        const double v111 = v5 * v110;
        const double v112 = w22[i];
        const double v115 = w34[i];
        const double v118 = w40[i];
        const double v120 = (((v107 * v108) - (v111 * v112)) + (v59 * v115)) - (v66 * v118);
        const double v121 = w71[i];
        const double v124 = w70[i + 1];
        const double v128 = (-0.5) * (v13 * v65);
        const double v129 = w28[i];
        const double v135 = 0.5 * ((v34 * v36) + (v37 * v27));
        const double v136 = (((v120 + (v56 * v121)) - (v56 * v124)) - (v128 * v129)) - v135;
        const double v137 = v37 * v2;
        const double v139 = v137 + (v4 * v110);
        const double v140 = w46[i];
        const double v143 = w17[i];
        const double v145 = w23[i];
        const double v148 = w35[i];
        const double v151 = w41[i];
        const double v153 = (((v107 * v143) - (v111 * v145)) + (v59 * v148)) - (v66 * v151);
        const double v154 = w72[i];
        const double v157 = w71[i + 1];
        const double v160 = w29[i];
        const double v163 = (((v153 + (v56 * v154)) - (v56 * v157)) - (v128 * v160)) - v135;
        const double v164 = w47[i];
        const double v167 = w72[i + 1];
        const double v173 = w73[i];
        const double v175 = w18[i];
        const double v177 = w24[i];
        const double v180 = w36[i];
        const double v183 = w42[i];
        const double v185 = (((v107 * v175) - (v111 * v177)) + (v59 * v180)) - (v66 * v183);
        const double v186 = w74[i];
        const double v189 = w73[i + 1];
        const double v192 = w48[i];
        const double v195 = v48 * v47;
        const double v196 = v195 * v52;
        const double v197 = w30[i];
        const double v199 = (((v185 + (v56 * v186)) - (v56 * v189)) - (v139 * v192)) + (v196 * v197);
        const double v200 = v48 * v44;
        const double v202 = w19[i];
        const double v204 = w25[i];
        const double v207 = w37[i];
        const double v210 = w43[i];
        const double v212 = (((v107 * v202) - (v111 * v204)) + (v59 * v207)) - (v66 * v210);
        const double v213 = w75[i];
        const double v216 = w74[i + 1];
        const double v219 = w49[i];
        const double v222 = w31[i];
        const double v224 = (((v212 + (v56 * v213)) - (v56 * v216)) - (v139 * v219)) + (v196 * v222);
        const double v226 = w75[i + 1];
        const double v229 = w76[i];
        const double v231 = w20[i];
        const double v233 = w26[i];
        const double v236 = w38[i];
        const double v239 = w44[i];
        const double v241 = (((v107 * v231) - (v111 * v233)) + (v59 * v236)) - (v66 * v239);
        const double v242 = w77[i];
        const double v245 = w76[i + 1];
        const double v248 = w50[i];
        const double v251 = w32[i];
        const double v253 = (((v241 + (v56 * v242)) - (v56 * v245)) - (v139 * v248)) + (v196 * v251);
        const double v254 = w21[i];
        const double v256 = w27[i];
        const double v259 = w39[i];
        const double v262 = w45[i];
        const double v264 = (((v107 * v254) - (v111 * v256)) + (v59 * v259)) - (v66 * v262);
        const double v265 = w78[i];
        const double v268 = w77[i + 1];
        const double v271 = w51[i];
        const double v274 = w33[i];
        const double v276 = (((v264 + (v56 * v265)) - (v56 * v268)) - (v139 * v271)) + (v196 * v274);
        const double v277 = w78[i + 1];
        const double v286 = (w2[i + 1] - w2[i]) * v44;
        const double v290 = (v286 * v47) * v44;
        const double v293 = v25 * v37;
        const double v294 = v293 * v19;
        const double v296 = c15 * (v294 * v19);
        const double v297 = v12 * v296;
        const double v309 = (v86 * v293) + (v21 * v294);
        const double v312 = v21 * v37;
        const double v322 = ((v17 * v309) - ((v81 * v34) + (v312 * v23))) + ((((2.0 * (v92 * v312)) - v312) + (v1 * v309)) * v23);
        const double v328 = ((v322 + (v100 * v37)) + (v8 * v137)) - (v105 * v37);
        const double v330 = v137 * v2;
        const double v331 = v5 * v330;
        const double v337 = (((v328 * v108) - (v331 * v112)) + (v137 * v115)) - (v297 * v118);
        const double v343 = (-0.5) * (v13 * v296);
        const double v349 = 0.5 * ((v34 * v27) - (v37 * v36));
        const double v350 = (((v337 + (v290 * v121)) - (v290 * v124)) - (v343 * v129)) + v349;
        const double v352 = v59 - (v4 * v330);
        const double v361 = (((v328 * v143) - (v331 * v145)) + (v137 * v148)) - (v297 * v151);
        const double v368 = (((v361 + (v290 * v154)) - (v290 * v157)) - (v343 * v160)) + v349;
        const double v381 = (((v328 * v175) - (v331 * v177)) + (v137 * v180)) - (v297 * v183);
        const double v388 = v195 * v286;
        const double v390 = (((v381 + (v290 * v186)) - (v290 * v189)) + (v352 * v192)) + (v388 * v197);
        const double v397 = (((v328 * v202) - (v331 * v204)) + (v137 * v207)) - (v297 * v210);
        const double v405 = (((v397 + (v290 * v213)) - (v290 * v216)) + (v352 * v219)) + (v388 * v222);
        const double v415 = (((v328 * v231) - (v331 * v233)) + (v137 * v236)) - (v297 * v239);
        const double v423 = (((v415 + (v290 * v242)) - (v290 * v245)) + (v352 * v248)) + (v388 * v251);
        const double v431 = (((v328 * v254) - (v331 * v256)) + (v137 * v259)) - (v297 * v262);
        const double v439 = (((v431 + (v290 * v265)) - (v290 * v268)) + (v352 * v271)) + (v388 * v274);
        w14[i] = ((v27 * v34) - (v36 * v37)) - (v48 * v52);
        w79[i] = v56 * v79;
        w80[i] = v136 - (v139 * v140);
        w81[i] = v163 - (v139 * v164);
        w82[i] = -(v56 * v167);
        w83[i] = v56 * v173;
        w84[i] = v199 + v200;
        w85[i] = v224 - v200;
        w86[i] = -(v56 * v226);
        w87[i] = v56 * v229;
        w88[i] = v253;
        w89[i] = v276;
        w90[i] = -(v56 * v277);
        w15[i] = ((v27 * v37) + (v36 * v34)) - (v48 * v286);
        w91[i] = v290 * v79;
        w92[i] = v350 + (v352 * v140);
        w93[i] = v368 + (v352 * v164);
        w94[i] = -(v290 * v167);
        w95[i] = v290 * v173;
        w96[i] = v390;
        w97[i] = v405;
        w98[i] = -(v290 * v226);
        w99[i] = v290 * v229;
        w100[i] = v423 + v200;
        w101[i] = v439 - v200;
        w102[i] = -(v290 * v277);
        for (int k = 0; k < FIBRES; k++) {
            const double v57 = each7[FIBRES * i + k];
            const double v60 = each0[FIBRES * i + k];
            const double v67 = each1[FIBRES * i + k];
            const double v70 = each8[FIBRES * i + k];
            const double v73 = each7[FIBRES * (i + 1) + k];
            const double v76 = each8[FIBRES * (i + 1) + k];
            const double v170 = each2[FIBRES * i + k];
            const double v303 = (((v137 * v60) - (v297 * v67)) + (v290 * v70)) - (v290 * v73);
            each9[FIBRES * i + k] = v56 * v57;
            each10[FIBRES * i + k] = (((v59 * v60) - (v66 * v67)) + (v56 * v70)) - (v56 * v73);
            each11[FIBRES * i + k] = -(v56 * v76);
            each12[FIBRES * i + k] = -(v139 * v170);
            each13[FIBRES * i + k] = v290 * v57;
            each14[FIBRES * i + k] = v303;
            each15[FIBRES * i + k] = -(v290 * v76);
            each16[FIBRES * i + k] = v352 * v170;
        }
    }
}

static void jacobian_14(int n, const double *p, const double *g, double *w, double *e)
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
    double *restrict each9 = w + (SCRATCH + 9 * FIBRES) * n;
    double *restrict each10 = w + (SCRATCH + 10 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    const double c1 = squared(p[10]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[ENTRIES * i + 4] = -(v9 * w79[i - 1]);
        e[ENTRIES * i + 7] = (v9 * w79[i]) - (v9 * w80[i - 1]);
        e[ENTRIES * i + 10] = (v9 * w80[i]) - (v9 * w81[i - 1]);
        e[ENTRIES * i + 13] = (v9 * w81[i]) - (v9 * w82[i - 1]);
        e[ENTRIES * i + 16] = v9 * w82[i];
        e[ENTRIES * i + 2] = -(v9 * w83[i - 1]);
        e[ENTRIES * i + 5] = (v9 * w83[i]) - (v9 * w84[i - 1]);
        e[ENTRIES * i + 8] = (v9 * w84[i]) - (v9 * w85[i - 1]);
        e[ENTRIES * i + 11] = (v9 * w85[i]) - (v9 * w86[i - 1]);
        e[ENTRIES * i + 14] = v9 * w86[i];
        e[ENTRIES * i + 3] = -(v9 * w87[i - 1]);
        e[ENTRIES * i + 6] = (v9 * w87[i]) - (v9 * w88[i - 1]);
        e[ENTRIES * i + 9] = (v9 * w88[i]) - (v9 * w89[i - 1]);
        e[ENTRIES * i + 12] = (v9 * w89[i]) - (v9 * w90[i - 1]);
        e[ENTRIES * i + 15] = v9 * w90[i];
        for (int k = 0; k < FIBRES; k++) {
            const double v17 = (v9 * each9[FIBRES * i + k]) - (v9 * each10[FIBRES * (i - 1) + k]);
            const double v22 = (v9 * each10[FIBRES * i + k]) - (v9 * each11[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + k] = -(v9 * each9[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 1 * FIBRES + k] = v17;
            e[ENTRIES * i + 41 + 3 * FIBRES + k] = v22;
            e[ENTRIES * i + 41 + 5 * FIBRES + k] = v9 * each11[FIBRES * i + k];
            e[ENTRIES * i + 41 + 2 * FIBRES + k] = -(v9 * each12[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 4 * FIBRES + k] = v9 * each12[FIBRES * i + k];
        }
    }
}

static void jacobian_15(int n, const double *p, const double *g, double *w, double *e)
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
        e[ENTRIES * i + 19] = -(v9 * w91[i - 1]);
        e[ENTRIES * i + 22] = (v9 * w91[i]) - (v9 * w92[i - 1]);
        e[ENTRIES * i + 25] = (v9 * w92[i]) - (v9 * w93[i - 1]);
        e[ENTRIES * i + 28] = (v9 * w93[i]) - (v9 * w94[i - 1]);
        e[ENTRIES * i + 31] = v9 * w94[i];
        e[ENTRIES * i + 17] = -(v9 * w95[i - 1]);
        e[ENTRIES * i + 20] = (v9 * w95[i]) - (v9 * w96[i - 1]);
        e[ENTRIES * i + 23] = (v9 * w96[i]) - (v9 * w97[i - 1]);
        e[ENTRIES * i + 26] = (v9 * w97[i]) - (v9 * w98[i - 1]);
        e[ENTRIES * i + 29] = v9 * w98[i];
        e[ENTRIES * i + 18] = -(v9 * w99[i - 1]);
        e[ENTRIES * i + 21] = (v9 * w99[i]) - (v9 * w100[i - 1]);
        e[ENTRIES * i + 24] = (v9 * w100[i]) - (v9 * w101[i - 1]);
        e[ENTRIES * i + 27] = (v9 * w101[i]) - (v9 * w102[i - 1]);
        e[ENTRIES * i + 30] = v9 * w102[i];
        for (int k = 0; k < FIBRES; k++) {
            const double v17 = (v9 * each13[FIBRES * i + k]) - (v9 * each14[FIBRES * (i - 1) + k]);
            const double v22 = (v9 * each14[FIBRES * i + k]) - (v9 * each15[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 6 * FIBRES + k] = -(v9 * each13[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 7 * FIBRES + k] = v17;
            e[ENTRIES * i + 41 + 9 * FIBRES + k] = v22;
            e[ENTRIES * i + 41 + 11 * FIBRES + k] = v9 * each15[FIBRES * i + k];
            e[ENTRIES * i + 41 + 8 * FIBRES + k] = -(v9 * each16[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 41 + 10 * FIBRES + k] = v9 * each16[FIBRES * i + k];
        }
    }
}

static void jacobian_16(int n, const double *p, const double *g, double *w, double *e)
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
    double *restrict each13 = w + (SCRATCH + 13 * FIBRES) * n;
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    double *restrict each16 = w + (SCRATCH + 16 * FIBRES) * n;
    const double c1 = squared(p[10]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[ENTRIES * i + 22] = v9 * w91[i];
    e[ENTRIES * i + 25] = v9 * w92[i];
    e[ENTRIES * i + 28] = v9 * w93[i];
    e[ENTRIES * i + 31] = v9 * w94[i];
    e[ENTRIES * i + 20] = v9 * w95[i];
    e[ENTRIES * i + 23] = v9 * w96[i];
    e[ENTRIES * i + 26] = v9 * w97[i];
    e[ENTRIES * i + 29] = v9 * w98[i];
    e[ENTRIES * i + 21] = v9 * w99[i];
    e[ENTRIES * i + 24] = v9 * w100[i];
    e[ENTRIES * i + 27] = v9 * w101[i];
    e[ENTRIES * i + 30] = v9 * w102[i];
    for (int k = 0; k < FIBRES; k++) {
        e[ENTRIES * i + 41 + 7 * FIBRES + k] = v9 * each13[FIBRES * i + k];
        e[ENTRIES * i + 41 + 9 * FIBRES + k] = v9 * each14[FIBRES * i + k];
        e[ENTRIES * i + 41 + 11 * FIBRES + k] = v9 * each15[FIBRES * i + k];
        e[ENTRIES * i + 41 + 10 * FIBRES + k] = v9 * each16[FIBRES * i + k];
    }
    (void)n;
}

static void work_0(int n, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w103 = w + 103 * n;
    const double c1 = p[7];
    const double c3 = p[5];
    const double c4 = 0.5 * c3;
    const double c25 = 0.4166666666666667 * c3;
    const double c28 = 2.0 * p[8];
    const double c29 = 2.0 + c28;
    const double c30 = c25 / c29;
    const double c41 = 1e-12 * c3;
    const double c42 = squared(c41);
    const double c48 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum9 = 0.0;
        const double v7 = (-0.5) * w5[i];
        const double v12 = w3[i];
        const double v14 = sqrt(v12) * v12;
        const double v16 = log(v12);
        const double v32 = w4[i] / v12;
        for (int k = 0; k < FIBRES; k++) {
            const double v19 = ((((v7 * zeta[k]) * p[1]) / v14) + v16) - y[SLOTS * i + 5 + k];
            const double v37 = squared((c30 * (2.0 * (v32 - y[SLOTS * i + 5 + 1 * FIBRES + k]))));
            const double v44 = sqrt(larger(squared((c4 * (2.0 * v19))) + (3.0 * v37), c42));
            const double v53 = (double)(c1 < v44) != 0.0 ? ((v44 * ((v44 - c1) * c48)) * weight[k]) : 0.0;
            sum9 += v53;
        }
        w103[i] = sum9;
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

static void work_3(int n, const double *y, double *w)
{
    double *restrict w104 = w + 104 * n;
    for (int i = 1; i < n - 1; i++) {
        w104[i] = y[SLOTS * i + 2];
    }
}

static void work_4(int n, const double *y, double *w)
{
    double *restrict w105 = w + 105 * n;
    for (int i = 0; i < n - 1; i++) {
        w105[i] = y[SLOTS * i + 3];
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

static void work_slope_0(int n, const double *p, const double *y, double *w)
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
    double *restrict each17 = w + (SCRATCH + 17 * FIBRES) * n;
    double *restrict each18 = w + (SCRATCH + 18 * FIBRES) * n;
    const double c1 = p[7];
    const double c3 = p[5];
    const double c4 = 0.5 * c3;
    const double c10 = p[1];
    const double c26 = 0.4166666666666667 * c3;
    const double c29 = 2.0 * p[8];
    const double c30 = 2.0 + c29;
    const double c31 = c26 / c30;
    const double c43 = 1e-12 * c3;
    const double c44 = squared(c43);
    const double c55 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum12 = 0.0;
        double sum9 = 0.0;
        const double v7 = (-0.5) * w5[i];
        const double v12 = w3[i];
        const double v13 = sqrt(v12);
        const double v15 = 1.0 / (v13 * v12);
        const double v17 = log(v12);
        const double v33 = 1.0 / v12;
        const double v34 = w4[i] * v33;
        const double v119 = v34 * v33;
        const double v127 = 2.0 * v13;
        for (int k = 0; k < FIBRES; k++) {
            const double v8 = zeta[k];
            const double v16 = ((v7 * v8) * c10) * v15;
            const double v22 = c4 * (2.0 * ((v16 + v17) - y[SLOTS * i + 5 + k]));
            const double v38 = c31 * (2.0 * (v34 - y[SLOTS * i + 5 + 1 * FIBRES + k]));
            const double v41 = squared(v22) + (3.0 * squared(v38));
            const double v46 = sqrt(larger(v41, c44));
            const double v47 = (double)(c1 < v46);
            const double v49 = (double)(c44 <= v41);
            const double v56 = (v46 - c1) * c55;
            const double v57 = weight[k];
            const double v64 = (v49 / (v49 + (double)(v41 <= c44))) * (((v56 * v57) + ((v46 * v57) * c55)) / (2.0 * v46));
            const double v67 = 2.0 * (c4 * ((2.0 * v22) * v64));
            const double v93 = 2.0 * (c31 * ((2.0 * v38) * (3.0 * v64)));
            const double v123 = (v16 * v15) * v67;
            const double v129 = (((v67 * v33) - (v119 * v93)) - (v13 * v123)) - ((v12 * v123) / v127);
            each17[FIBRES * i + k] = v47 != 0.0 ? (-v67) : 0.0;
            each18[FIBRES * i + k] = v47 != 0.0 ? (-v93) : 0.0;
            sum10 += v47 != 0.0 ? (v93 * v33) : 0.0;
            sum11 += v47 != 0.0 ? v129 : 0.0;
            sum12 += v47 != 0.0 ? ((-0.5) * (v8 * (c10 * (v67 * v15)))) : 0.0;
            sum9 += v47 != 0.0 ? ((v46 * v56) * v57) : 0.0;
        }
        const double v70 = sum10;
        const double v73 = sum11;
        const double v77 = sum12;
        w103[i] = sum9;
        w106[i] = ((v70 * w22[i]) + (v73 * w16[i])) + (v77 * w28[i]);
        w107[i] = ((v70 * w23[i]) + (v73 * w17[i])) + (v77 * w29[i]);
        w108[i] = (v70 * w24[i]) + (v73 * w18[i]);
        w109[i] = (v70 * w25[i]) + (v73 * w19[i]);
        w110[i] = (v70 * w26[i]) + (v73 * w20[i]);
        w111[i] = (v70 * w27[i]) + (v73 * w21[i]);
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
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict each17 = w + (SCRATCH + 17 * FIBRES) * n;
    double *restrict each18 = w + (SCRATCH + 18 * FIBRES) * n;
    const double c0 = p[10];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v8 = c6 * g[7 * i + 1];
        s[SLOTS * i + 4] += v8 * w106[i];
        s[SLOTS * (i + 1) + 4] += v8 * w107[i];
        s[SLOTS * i + 0] += v8 * w108[i];
        s[SLOTS * (i + 1) + 0] += v8 * w109[i];
        s[SLOTS * i + 1] += v8 * w110[i];
        s[SLOTS * (i + 1) + 1] += v8 * w111[i];
        for (int k = 0; k < FIBRES; k++) {
            s[SLOTS * i + 5 + k] += v8 * each17[FIBRES * i + k];
            s[SLOTS * i + 5 + 1 * FIBRES + k] += v8 * each18[FIBRES * i + k];
        }
    }
}

static void work_slope_3(int n, const double *y, double *w)
{
    double *restrict w104 = w + 104 * n;
    for (int i = 1; i < n - 1; i++) {
        w104[i] = y[SLOTS * i + 2];
    }
}

static void work_slope_4(int n, const double *y, double *w)
{
    double *restrict w105 = w + 105 * n;
    for (int i = 0; i < n - 1; i++) {
        w105[i] = y[SLOTS * i + 3];
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

static void work_slope_7(int n, const double *p, const double *g, double *w, double *s)
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
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
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
        const double v64 = w13[i] * c51;
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
        const double v102 = (((v52 * w74[i]) + (v82 * w31[i - 1])) - (v95 * w30[i])) - (v87 + v100);
        const double v115 = (v38 * v65) * v27;
        const double v126 = (v18 * v68) * v4;
        const double v128 = (((v52 * w77[i]) + (v82 * w33[i - 1])) - (v95 * w32[i])) - (v115 + v126);
        s[2 * SLOTS * n + SLOTS * (i - 1) + 4] += v52 * w70[i];
        s[2 * SLOTS * n + SLOTS * i + 4] += v52 * w71[i];
        s[2 * SLOTS * n + SLOTS * (i + 1) + 4] += v52 * w72[i];
        s[2 * SLOTS * n + SLOTS * (i - 1) + 2] += v67;
        s[2 * SLOTS * n + SLOTS * i + 2] += -(v67 + v70);
        s[2 * SLOTS * n + SLOTS * (i + 1) + 2] += v70;
        s[2 * SLOTS * n + SLOTS * (i - 1) + 3] += v74;
        s[2 * SLOTS * n + SLOTS * i + 3] += -(v74 + v76);
        s[2 * SLOTS * n + SLOTS * (i + 1) + 3] += v76;
        s[2 * SLOTS * n + SLOTS * (i - 1) + 0] += ((v52 * w73[i]) + (v82 * w30[i - 1])) + v87;
        s[2 * SLOTS * n + SLOTS * i + 0] += v102;
        s[2 * SLOTS * n + SLOTS * (i + 1) + 0] += ((v52 * w75[i]) - (v95 * w31[i])) + v100;
        s[2 * SLOTS * n + SLOTS * (i - 1) + 1] += ((v52 * w76[i]) + (v82 * w32[i - 1])) + v115;
        s[2 * SLOTS * n + SLOTS * i + 1] += v128;
        s[2 * SLOTS * n + SLOTS * (i + 1) + 1] += ((v52 * w78[i]) - (v95 * w33[i])) + v126;
        for (int k = 0; k < FIBRES; k++) {
            s[2 * SLOTS * n + SLOTS * (i - 1) + 5 + k] += v52 * each7[FIBRES * i + k];
            s[2 * SLOTS * n + SLOTS * i + 5 + k] += v52 * each8[FIBRES * i + k];
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
    rates_5(n, w);
    rates_6(n, p, g, w);
    rates_7(n, p, y, w, f);
    rates_8(n, p, g, w);
    rates_9(n, p, g, w, f);
    rates_10(n, p, g, w);
    rates_11(n, w);
    rates_12(n, w);
    rates_13(n, p, g, w);
    rates_14(n, p, g, w, f);
    rates_15(n, t, p, g, w, f);
    rates_16(n, t, p, g, w, f);
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
    jacobian_5(n, w);
    jacobian_6(n, p, g, w);
    jacobian_7(n, p, y, w, e);
    jacobian_8(n, p, g, w);
    jacobian_9(n, p, g, w, e);
    jacobian_10(n, p, g, w);
    jacobian_11(n, w);
    jacobian_12(n, w);
    jacobian_13(n, p, g, w);
    jacobian_14(n, p, g, w, e);
    jacobian_15(n, p, g, w, e);
    jacobian_16(n, p, g, w, e);
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
    21, 16, 11, 7, 264, 297, 3, 1,
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
