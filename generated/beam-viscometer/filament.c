/*
 * Glass bar with a weight in a beam-bending viscometer
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: bending, extensibility, finite-stretch, thinning, large-rotation, viscous-stress, shear
 * Digest of the structure: 9a71cea3c026ae4257048749ef459e0058201189fda3d98d5eae5fb9ab062e8f
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES 2
#define SLOTS 6
#define ENTRIES 57
#define SCRATCH 156

/* Coordinate of each fibre, from -1 to 1 through the thickness, and its share of the section. */
static const double zeta[] = {
    (-0.5773502691896257), 0.5773502691896257};
static const double weight[] = {
    0.5, 0.5};

static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[6 * i] = y[6 * i + 3];
    }
}

static void rates_1(int n, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[6 * i + 1] = y[6 * i + 4];
    }
}

static void rates_2(int n, const double *y, double *f)
{
    for (int i = 1; i < n; i++) {
        f[6 * i + 2] = y[6 * i + 5];
    }
}

static void rates_3(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 3];
    }
}

static void rates_4(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[6 * i + 1];
        w3[i] = y[6 * i + 4];
    }
}

static void rates_5(int n, const double *y, double *w)
{
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    for (int i = 1; i < n; i++) {
        w4[i] = y[6 * i + 2];
        w5[i] = y[6 * i + 5];
    }
}

static void rates_6(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w2[i] = 0.0;
    w1[i] = 0.0;
    w3[i] = 0.0;
    (void)n;
}

static void rates_7(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const int i = 0;
    w0[i] = g[8 * i];
    w4[i] = 0.0;
    w1[i] = 0.0;
    w5[i] = 0.0;
    (void)n;
}

static void rates_8(int n, const double *p, const double *g, double *w)
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
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    const double c2 = 1.0 / p[6];
    const double c56 = 1.0 / p[0];
    for (int i = 0; i < n - 1; i++) {
        const double v3 = w5[i] * c2;
        const double v5 = w5[i + 1] * c2;
        const double v9 = (v3 + v5) * 0.5;
        const double v14 = g[8 * i + 4];
        const double v15 = (w2[i + 1] - w2[i]) * v14;
        const double v16 = w4[i];
        const double v17 = w4[i + 1];
        const double v19 = (v16 + v17) * 0.5;
        const double v20 = cos(v19);
        const double v25 = (w0[i + 1] - w0[i]) * v14;
        const double v26 = sin(v19);
        const double v28 = (v15 * v20) - (v25 * v26);
        const double v35 = ((w1[i + 1] * c2) - (w1[i] * c2)) * v14;
        const double v43 = ((w3[i + 1] * c2) - (w3[i] * c2)) * v14;
        const double v49 = (v25 * v20) + (v15 * v26);
        const double v57 = v14 * c56;
        w6[i] = ((v9 * v28) + (v35 * v20)) + (v43 * v26);
        w7[i] = ((v43 * v20) - (v9 * v49)) - (v35 * v26);
        w8[i] = (v5 - v3) * v57;
        w9[i] = v49;
        w10[i] = v28;
        w11[i] = (v17 - v16) * v57;
    }
}

static void rates_9(int n, const double *p, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    const double c3 = p[4];
    const double c33 = 0.2777777777777778 * c3;
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v4 = w6[i];
        const double v8 = w9[i];
        const double v9 = sqrt(v8);
        const double v10 = squared(v8);
        const double v12 = (0.75 * w11[i]) / (v9 * v10);
        const double v17 = 1.0 / v8;
        const double v24 = ((-0.5) * w8[i]) / (v9 * v8);
        const double v40 = c33 * ((w7[i] * v17) - ((w10[i] * v4) / v10));
        for (int k = 0; k < FIBRES; k++) {
            const double v14 = zeta[k];
            const double v15 = p[1] * v14;
            const double v27 = c3 * ((v4 * ((v12 * v15) + v17)) + (v24 * v15));
            const double v28 = weight[k];
            sum0 += v27 * v28;
            sum1 += v27 * (v28 * v14);
            sum2 += v40 * v28;
        }
        w12[i] = sum0;
        w13[i] = sum1;
        w14[i] = sum2;
    }
}

static void rates_10(int n, const double *p, const double *g, double *w)
{
    double *restrict w4 = w + 4 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    const double c13 = 0.5 * p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w9[i];
        const double v2 = 1.0 / v1;
        const double v4 = w10[i];
        const double v5 = w14[i];
        const double v6 = v5 * v2;
        const double v18 = (c13 * w13[i]) / (sqrt(v1) * v1);
        const double v23 = ((w12[i] * v2) - ((v4 * v6) * v2)) + (((1.5 * v18) * w11[i]) * v2);
        const double v28 = (w4[i] + w4[i + 1]) * 0.5;
        const double v29 = cos(v28);
        const double v31 = sin(v28);
        w15[i] = (v23 * v29) - (v6 * v31);
        w16[i] = (v23 * v31) + (v6 * v29);
        w17[i] = ((g[8 * i + 1] * p[0]) * (v5 - (v4 * v23))) * 0.5;
        w18[i] = -v18;
    }
}

static void rates_11(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w15 = w + 15 * n;
    const double c4 = squared(p[6]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    const double c13 = p[5] / c8;
    for (int i = 1; i < n - 1; i++) {
        const double v17 = (w15[i] - w15[i - 1]) * (c9 / (g[8 * i + 3] + (g[8 * i + 7] * c13)));
        f[6 * i + 3] = v17;
    }
}

static void rates_12(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    const double c4 = squared(p[6]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c7 = p[2];
    const double c8 = c7 * c5;
    const double c9 = c6 / c8;
    const double c13 = p[5] / c8;
    const double c19 = p[3] * c6;
    const double c29 = 0.08333333333333333 * c7;
    const double c31 = squared(p[1]);
    const double c32 = c29 * c31;
    const double c33 = c32 * c5;
    const double c34 = c4 / c33;
    const double c39 = squared(c5);
    const double c40 = c7 * c39;
    const double c41 = c32 / c40;
    for (int i = 1; i < n - 1; i++) {
        const double v17 = (w16[i] - w16[i - 1]) * (c9 / (g[8 * i + 3] + (g[8 * i + 7] * c13)));
        const double v38 = (((w18[i] - w18[i - 1]) + w17[i]) + w17[i - 1]) * (c34 * g[8 * i + 5]);
        f[6 * i + 4] = v17 - c19;
        f[6 * i + 5] = v38 * c41;
    }
}

static void rates_13(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    const double c4 = squared(p[6]);
    const double c6 = p[2];
    const double c7 = 0.08333333333333333 * c6;
    const double c9 = squared(p[1]);
    const double c10 = c7 * c9;
    const double c11 = p[0];
    const double c12 = c10 * c11;
    const double c13 = c4 / c12;
    const double c18 = squared(c11);
    const double c19 = c6 * c18;
    const double c20 = c10 / c19;
    const int i = n - 1;
    f[6 * i + 5] = ((w17[i - 1] - w18[i - 1]) * (c13 * g[8 * i + 5])) * c20;
    (void)n;
}

static void rates_14(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w16 = w + 16 * n;
    const double c2 = squared(p[6]);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c6 = p[2] * c3;
    const double c7 = c4 / c6;
    const double c11 = p[5] / c6;
    const double c17 = p[3] * c4;
    const int i = 0;
    const double v18 = (w16[i] * (c7 / (g[8 * i + 3] + (g[8 * i + 7] * c11)))) - c17;
    f[6 * i + 4] = v18;
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[57 * i] = 1.0;
    }
}

static void jacobian_1(int n, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[57 * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, double *e)
{
    for (int i = 1; i < n; i++) {
        e[57 * i + 2] = 1.0;
    }
}

static void jacobian_3(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 3];
    }
}

static void jacobian_4(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[6 * i + 1];
        w3[i] = y[6 * i + 4];
    }
}

static void jacobian_5(int n, const double *y, double *w)
{
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    for (int i = 1; i < n; i++) {
        w4[i] = y[6 * i + 2];
        w5[i] = y[6 * i + 5];
    }
}

static void jacobian_6(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w2[i] = 0.0;
    w1[i] = 0.0;
    w3[i] = 0.0;
    (void)n;
}

static void jacobian_7(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const int i = 0;
    w0[i] = g[8 * i];
    w4[i] = 0.0;
    w1[i] = 0.0;
    w5[i] = 0.0;
    (void)n;
}

static void jacobian_8(int n, const double *p, const double *g, double *w)
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
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
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
    double *restrict w52 = w + 52 * n;
    double *restrict w53 = w + 53 * n;
    double *restrict w54 = w + 54 * n;
    double *restrict w55 = w + 55 * n;
    double *restrict w56 = w + 56 * n;
    double *restrict w57 = w + 57 * n;
    double *restrict w58 = w + 58 * n;
    const double c2 = 1.0 / p[6];
    const double c86 = 1.0 / p[0];
    for (int i = 0; i < n - 1; i++) {
        const double v3 = w5[i] * c2;
        const double v5 = w5[i + 1] * c2;
        const double v9 = (v3 + v5) * 0.5;
        const double v14 = g[8 * i + 4];
        const double v15 = (w2[i + 1] - w2[i]) * v14;
        const double v16 = w4[i];
        const double v17 = w4[i + 1];
        const double v19 = (v16 + v17) * 0.5;
        const double v20 = cos(v19);
        const double v25 = (w0[i + 1] - w0[i]) * v14;
        const double v26 = sin(v19);
        const double v28 = (v15 * v20) - (v25 * v26);
        const double v35 = ((w1[i + 1] * c2) - (w1[i] * c2)) * v14;
        const double v43 = ((w3[i + 1] * c2) - (w3[i] * c2)) * v14;
        const double v47 = (0.5 * v28) * c2;
        const double v49 = v43 - (v25 * v9);
        const double v52 = v35 + (v15 * v9);
        const double v55 = 0.5 * ((v20 * v49) - (v26 * v52));
        const double v56 = v20 * v14;
        const double v57 = v56 * c2;
        const double v58 = -v57;
        const double v59 = v26 * v14;
        const double v60 = v59 * c2;
        const double v61 = -v60;
        const double v63 = (v26 * v9) * v14;
        const double v64 = -v63;
        const double v66 = (v20 * v9) * v14;
        const double v67 = -v66;
        const double v71 = (v25 * v20) + (v15 * v26);
        const double v78 = -((0.5 * v71) * c2);
        const double v83 = -(0.5 * ((v20 * v52) + (v26 * v49)));
        const double v87 = v14 * c86;
        const double v89 = v87 * c2;
        const double v94 = 0.5 * ((v20 * v15) - (v26 * v25));
        const double v95 = -v56;
        const double v96 = -v59;
        const double v101 = -(0.5 * ((v20 * v25) + (v26 * v15)));
        w6[i] = ((v9 * v28) + (v35 * v20)) + (v43 * v26);
        w19[i] = v47;
        w20[i] = v47;
        w21[i] = v55;
        w22[i] = v55;
        w23[i] = v58;
        w24[i] = v57;
        w25[i] = v61;
        w26[i] = v60;
        w27[i] = v63;
        w28[i] = v64;
        w29[i] = v67;
        w30[i] = v66;
        w7[i] = ((v43 * v20) - (v9 * v71)) - (v35 * v26);
        w31[i] = v78;
        w32[i] = v78;
        w33[i] = v83;
        w34[i] = v83;
        w35[i] = v60;
        w36[i] = v61;
        w37[i] = v58;
        w38[i] = v57;
        w39[i] = v66;
        w40[i] = v67;
        w41[i] = v63;
        w42[i] = v64;
        w8[i] = (v5 - v3) * v87;
        w43[i] = -v89;
        w44[i] = v89;
        w9[i] = v71;
        w45[i] = v94;
        w46[i] = v94;
        w47[i] = v95;
        w48[i] = v56;
        w49[i] = v96;
        w50[i] = v59;
        w10[i] = v28;
        w51[i] = v101;
        w52[i] = v101;
        w53[i] = v59;
        w54[i] = v96;
        w55[i] = v95;
        w56[i] = v56;
        w11[i] = (v17 - v16) * v87;
        w57[i] = -v87;
        w58[i] = v87;
    }
}

static void jacobian_9(int n, const double *p, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
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
    const double c179 = p[4];
    const double c215 = 0.2777777777777778 * c179;
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum12 = 0.0;
        double sum13 = 0.0;
        double sum14 = 0.0;
        double sum2 = 0.0;
        double sum3 = 0.0;
        double sum4 = 0.0;
        double sum5 = 0.0;
        double sum6 = 0.0;
        double sum7 = 0.0;
        double sum8 = 0.0;
        double sum9 = 0.0;
        const double v2 = w19[i];
        const double v5 = w43[i];
        const double v8 = w20[i];
        const double v10 = w44[i];
        const double v14 = w45[i];
        const double v16 = w21[i];
        const double v20 = w57[i];
        const double v23 = w46[i];
        const double v25 = w22[i];
        const double v28 = w58[i];
        const double v31 = w23[i];
        const double v33 = w24[i];
        const double v35 = w25[i];
        const double v37 = w26[i];
        const double v39 = w47[i];
        const double v41 = w27[i];
        const double v44 = w48[i];
        const double v46 = w28[i];
        const double v49 = w49[i];
        const double v51 = w29[i];
        const double v54 = w50[i];
        const double v56 = w30[i];
        const double v180 = w6[i];
        const double v184 = w9[i];
        const double v185 = sqrt(v184);
        const double v186 = squared(v184);
        const double v188 = 1.0 / (v185 * v186);
        const double v189 = (0.75 * w11[i]) * v188;
        const double v194 = 1.0 / v184;
        const double v201 = 1.0 / (v185 * v184);
        const double v202 = ((-0.5) * w8[i]) * v201;
        const double v217 = 1.0 / v186;
        const double v222 = 2.0 * v184;
        const double v223 = w10[i];
        const double v225 = (v223 * v180) * v217;
        const double v226 = v225 * v217;
        const double v230 = w7[i] * v194;
        const double v231 = v230 * v194;
        const double v237 = c215 * (v230 - v225);
        const double v239 = v202 * v201;
        const double v246 = 1.0 / (2.0 * v185);
        const double v249 = v194 * v194;
        const double v253 = v189 * v188;
        for (int k = 0; k < FIBRES; k++) {
            const double v191 = zeta[k];
            const double v192 = p[1] * v191;
            const double v195 = (v189 * v192) + v194;
            const double v205 = c179 * ((v180 * v195) + (v202 * v192));
            const double v206 = weight[k];
            const double v208 = v206 * v191;
            const double v210 = c179 * v208;
            const double v211 = v192 * v210;
            const double v216 = c215 * v206;
            const double v218 = v216 * v217;
            const double v240 = c179 * v206;
            const double v241 = v192 * v240;
            const double v242 = v239 * v241;
            const double v250 = v180 * v240;
            const double v254 = v192 * v250;
            const double v255 = v253 * v254;
            const double v258 = (((v185 * v242) + ((v184 * v242) * v246)) + (v249 * v250)) + (v222 * (v185 * v255));
            const double v268 = v239 * v211;
            const double v273 = v180 * v210;
            const double v276 = v192 * v273;
            const double v277 = v253 * v276;
            const double v280 = (((v185 * v268) + ((v184 * v268) * v246)) + (v249 * v273)) + (v222 * (v185 * v277));
            sum0 += v205 * v206;
            sum1 += v205 * v208;
            sum10 += (-0.5) * (v211 * v201);
            sum11 += -(v180 * v218);
            sum12 += v216 * v194;
            sum13 += (v222 * (v226 * v216)) - (v231 * v216);
            sum14 += -(v223 * v218);
            sum2 += v237 * v206;
            sum3 += -(v258 + ((v186 * v255) * v246));
            sum4 += v195 * v240;
            sum5 += 0.75 * (v254 * v188);
            sum6 += (-0.5) * (v241 * v201);
            sum7 += -(v280 + ((v186 * v277) * v246));
            sum8 += v195 * v210;
            sum9 += 0.75 * (v276 * v188);
        }
        const double v1 = sum4;
        const double v4 = sum6;
        const double v13 = sum3;
        const double v19 = sum5;
        const double v60 = sum8;
        const double v62 = sum10;
        const double v68 = sum7;
        const double v72 = sum9;
        const double v97 = sum12;
        const double v100 = sum14;
        const double v107 = sum11;
        const double v113 = sum13;
        const double v117 = (((v107 * w51[i]) + (v97 * w33[i])) + (v113 * v14)) + (v100 * v16);
        const double v126 = (((v107 * w52[i]) + (v97 * w34[i])) + (v113 * v23)) + (v100 * v25);
        const double v151 = (((v107 * w53[i]) + (v97 * w39[i])) + (v113 * v39)) + (v100 * v41);
        const double v160 = (((v107 * w54[i]) + (v97 * w40[i])) + (v113 * v44)) + (v100 * v46);
        const double v169 = (((v107 * w55[i]) + (v97 * w41[i])) + (v113 * v49)) + (v100 * v51);
        const double v178 = (((v107 * w56[i]) + (v97 * w42[i])) + (v113 * v54)) + (v100 * v56);
        w12[i] = sum0;
        w59[i] = (v1 * v2) + (v4 * v5);
        w60[i] = (v1 * v8) + (v4 * v10);
        w61[i] = ((v13 * v14) + (v1 * v16)) + (v19 * v20);
        w62[i] = ((v13 * v23) + (v1 * v25)) + (v19 * v28);
        w63[i] = v1 * v31;
        w64[i] = v1 * v33;
        w65[i] = v1 * v35;
        w66[i] = v1 * v37;
        w67[i] = (v13 * v39) + (v1 * v41);
        w68[i] = (v13 * v44) + (v1 * v46);
        w69[i] = (v13 * v49) + (v1 * v51);
        w70[i] = (v13 * v54) + (v1 * v56);
        w13[i] = sum1;
        w71[i] = (v60 * v2) + (v62 * v5);
        w72[i] = (v60 * v8) + (v62 * v10);
        w73[i] = ((v68 * v14) + (v60 * v16)) + (v72 * v20);
        w74[i] = ((v68 * v23) + (v60 * v25)) + (v72 * v28);
        w75[i] = v60 * v31;
        w76[i] = v60 * v33;
        w77[i] = v60 * v35;
        w78[i] = v60 * v37;
        w79[i] = (v68 * v39) + (v60 * v41);
        w80[i] = (v68 * v44) + (v60 * v46);
        w81[i] = (v68 * v49) + (v60 * v51);
        w82[i] = (v68 * v54) + (v60 * v56);
        w14[i] = sum2;
        w83[i] = (v97 * w31[i]) + (v100 * v2);
        w84[i] = (v97 * w32[i]) + (v100 * v8);
        w85[i] = v117;
        w86[i] = v126;
        w87[i] = (v97 * w35[i]) + (v100 * v31);
        w88[i] = (v97 * w36[i]) + (v100 * v33);
        w89[i] = (v97 * w37[i]) + (v100 * v35);
        w90[i] = (v97 * w38[i]) + (v100 * v37);
        w91[i] = v151;
        w92[i] = v160;
        w93[i] = v169;
        w94[i] = v178;
    }
}

static void jacobian_10(int n, const double *p, const double *g, double *w)
{
    double *restrict w4 = w + 4 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
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
    double *restrict w117 = w + 117 * n;
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    double *restrict w120 = w + 120 * n;
    double *restrict w121 = w + 121 * n;
    double *restrict w122 = w + 122 * n;
    double *restrict w123 = w + 123 * n;
    double *restrict w124 = w + 124 * n;
    double *restrict w125 = w + 125 * n;
    double *restrict w126 = w + 126 * n;
    double *restrict w127 = w + 127 * n;
    double *restrict w128 = w + 128 * n;
    double *restrict w129 = w + 129 * n;
    double *restrict w130 = w + 130 * n;
    double *restrict w131 = w + 131 * n;
    double *restrict w132 = w + 132 * n;
    double *restrict w133 = w + 133 * n;
    double *restrict w134 = w + 134 * n;
    double *restrict w135 = w + 135 * n;
    double *restrict w136 = w + 136 * n;
    double *restrict w137 = w + 137 * n;
    double *restrict w138 = w + 138 * n;
    double *restrict w139 = w + 139 * n;
    double *restrict w140 = w + 140 * n;
    double *restrict w141 = w + 141 * n;
    double *restrict w142 = w + 142 * n;
    const double c13 = 0.5 * p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w9[i];
        const double v2 = 1.0 / v1;
        const double v3 = w12[i] * v2;
        const double v4 = w10[i];
        const double v5 = w14[i];
        const double v6 = v5 * v2;
        const double v8 = (v4 * v6) * v2;
        const double v16 = sqrt(v1);
        const double v18 = 1.0 / (v16 * v1);
        const double v19 = (c13 * w13[i]) * v18;
        const double v20 = 1.5 * v19;
        const double v21 = w11[i];
        const double v23 = (v20 * v21) * v2;
        const double v24 = (v3 - v8) + v23;
        const double v29 = (w4[i] + w4[i + 1]) * 0.5;
        const double v30 = cos(v29);
        const double v32 = sin(v29);
        const double v35 = v30 * v2;
        const double v36 = w59[i];
        const double v38 = c13 * v18;
        const double v41 = (v21 * (1.5 * v38)) * v2;
        const double v42 = v30 * v41;
        const double v43 = w71[i];
        const double v46 = v4 * v2;
        const double v47 = v46 * v2;
        const double v49 = v32 * v2;
        const double v50 = (v30 * v47) + v49;
        const double v51 = w83[i];
        const double v54 = w60[i];
        const double v56 = w72[i];
        const double v59 = w84[i];
        const double v62 = v6 * v2;
        const double v63 = v4 * v62;
        const double v73 = (v19 * v18) * ((v1 / (2.0 * v16)) + v16);
        const double v79 = (((v63 * v2) + (v8 * v2)) - (v3 * v2)) - (((v21 * (1.5 * v73)) * v2) + (v23 * v2));
        const double v81 = v32 * v62;
        const double v82 = (v30 * v79) + v81;
        const double v83 = w45[i];
        const double v85 = v30 * v62;
        const double v86 = w51[i];
        const double v89 = w61[i];
        const double v92 = w73[i];
        const double v95 = v20 * v2;
        const double v96 = v30 * v95;
        const double v97 = w57[i];
        const double v99 = ((((v82 * v83) - (v85 * v86)) + (v35 * v89)) + (v42 * v92)) + (v96 * v97);
        const double v100 = 0.5 * v32;
        const double v102 = 0.5 * v30;
        const double v104 = (v24 * v100) + (v6 * v102);
        const double v106 = w85[i];
        const double v109 = w46[i];
        const double v111 = w52[i];
        const double v114 = w62[i];
        const double v117 = w74[i];
        const double v119 = (((v82 * v109) - (v85 * v111)) + (v35 * v114)) + (v42 * v117);
        const double v120 = w58[i];
        const double v124 = w86[i];
        const double v127 = w63[i];
        const double v129 = w75[i];
        const double v132 = w87[i];
        const double v135 = w64[i];
        const double v137 = w76[i];
        const double v140 = w88[i];
        const double v143 = w65[i];
        const double v145 = w77[i];
        const double v148 = w89[i];
        const double v151 = w66[i];
        const double v153 = w78[i];
        const double v156 = w90[i];
        const double v159 = w47[i];
        const double v161 = w53[i];
        const double v164 = w67[i];
        const double v167 = w79[i];
        const double v169 = (((v82 * v159) - (v85 * v161)) + (v35 * v164)) + (v42 * v167);
        const double v170 = w91[i];
        const double v173 = w48[i];
        const double v175 = w54[i];
        const double v178 = w68[i];
        const double v181 = w80[i];
        const double v183 = (((v82 * v173) - (v85 * v175)) + (v35 * v178)) + (v42 * v181);
        const double v184 = w92[i];
        const double v187 = w49[i];
        const double v189 = w55[i];
        const double v192 = w69[i];
        const double v195 = w81[i];
        const double v197 = (((v82 * v187) - (v85 * v189)) + (v35 * v192)) + (v42 * v195);
        const double v198 = w93[i];
        const double v201 = w50[i];
        const double v203 = w56[i];
        const double v206 = w70[i];
        const double v209 = w82[i];
        const double v211 = (((v82 * v201) - (v85 * v203)) + (v35 * v206)) + (v42 * v209);
        const double v212 = w94[i];
        const double v219 = v32 * v41;
        const double v223 = v35 - (v32 * v47);
        const double v232 = (v32 * v79) - v85;
        const double v239 = (((v232 * v83) - (v81 * v86)) + (v49 * v89)) + (v219 * v92);
        const double v240 = v32 * v95;
        const double v245 = (v24 * v102) - (v6 * v100);
        const double v255 = (((v232 * v109) - (v81 * v111)) + (v49 * v114)) + (v219 * v117);
        const double v287 = (((v232 * v159) - (v81 * v161)) + (v49 * v164)) + (v219 * v167);
        const double v296 = (((v232 * v173) - (v81 * v175)) + (v49 * v178)) + (v219 * v181);
        const double v305 = (((v232 * v187) - (v81 * v189)) + (v49 * v192)) + (v219 * v195);
        const double v314 = (((v232 * v201) - (v81 * v203)) + (v49 * v206)) + (v219 * v209);
        const double v319 = g[8 * i + 1] * p[0];
        const double v328 = 0.5 * (v319 * (1.0 + (v4 * v47)));
        const double v331 = 0.5 * (v319 * v46);
        const double v335 = 0.5 * (v319 * (v4 * v41));
        const double v347 = 0.5 * (v319 * (v24 - v63));
        const double v351 = 0.5 * (v319 * (v4 * v79));
        const double v357 = (((v347 * v86) + (v351 * v83)) + (v331 * v89)) + (v335 * v92);
        const double v360 = 0.5 * (v319 * (v4 * v95));
        const double v371 = (((v347 * v111) + (v351 * v109)) + (v331 * v114)) + (v335 * v117);
        const double v402 = (((v347 * v161) + (v351 * v159)) + (v331 * v164)) + (v335 * v167);
        const double v411 = (((v347 * v175) + (v351 * v173)) + (v331 * v178)) + (v335 * v181);
        const double v420 = (((v347 * v189) + (v351 * v187)) + (v331 * v192)) + (v335 * v195);
        const double v429 = (((v347 * v203) + (v351 * v201)) + (v331 * v206)) + (v335 * v209);
        w15[i] = (v24 * v30) - (v6 * v32);
        w95[i] = ((v35 * v36) + (v42 * v43)) - (v50 * v51);
        w96[i] = ((v35 * v54) + (v42 * v56)) - (v50 * v59);
        w97[i] = (v99 - v104) - (v50 * v106);
        w98[i] = ((v119 + (v96 * v120)) - v104) - (v50 * v124);
        w99[i] = ((v35 * v127) + (v42 * v129)) - (v50 * v132);
        w100[i] = ((v35 * v135) + (v42 * v137)) - (v50 * v140);
        w101[i] = ((v35 * v143) + (v42 * v145)) - (v50 * v148);
        w102[i] = ((v35 * v151) + (v42 * v153)) - (v50 * v156);
        w103[i] = v169 - (v50 * v170);
        w104[i] = v183 - (v50 * v184);
        w105[i] = v197 - (v50 * v198);
        w106[i] = v211 - (v50 * v212);
        w16[i] = (v24 * v32) + (v6 * v30);
        w107[i] = ((v49 * v36) + (v219 * v43)) + (v223 * v51);
        w108[i] = ((v49 * v54) + (v219 * v56)) + (v223 * v59);
        w109[i] = ((v239 + (v240 * v97)) + v245) + (v223 * v106);
        w110[i] = ((v255 + (v240 * v120)) + v245) + (v223 * v124);
        w111[i] = ((v49 * v127) + (v219 * v129)) + (v223 * v132);
        w112[i] = ((v49 * v135) + (v219 * v137)) + (v223 * v140);
        w113[i] = ((v49 * v143) + (v219 * v145)) + (v223 * v148);
        w114[i] = ((v49 * v151) + (v219 * v153)) + (v223 * v156);
        w115[i] = v287 + (v223 * v170);
        w116[i] = v296 + (v223 * v184);
        w117[i] = v305 + (v223 * v198);
        w118[i] = v314 + (v223 * v212);
        w17[i] = (v319 * (v5 - (v4 * v24))) * 0.5;
        w119[i] = (v328 * v51) - ((v331 * v36) + (v335 * v43));
        w120[i] = (v328 * v59) - ((v331 * v54) + (v335 * v56));
        w121[i] = (v328 * v106) - (v357 + (v360 * v97));
        w122[i] = (v328 * v124) - (v371 + (v360 * v120));
        w123[i] = (v328 * v132) - ((v331 * v127) + (v335 * v129));
        w124[i] = (v328 * v140) - ((v331 * v135) + (v335 * v137));
        w125[i] = (v328 * v148) - ((v331 * v143) + (v335 * v145));
        w126[i] = (v328 * v156) - ((v331 * v151) + (v335 * v153));
        w127[i] = (v328 * v170) - v402;
        w128[i] = (v328 * v184) - v411;
        w129[i] = (v328 * v198) - v420;
        w130[i] = (v328 * v212) - v429;
        w18[i] = -v19;
        w131[i] = -(v38 * v43);
        w132[i] = -(v38 * v56);
        w133[i] = (v73 * v83) - (v38 * v92);
        w134[i] = (v73 * v109) - (v38 * v117);
        w135[i] = -(v38 * v129);
        w136[i] = -(v38 * v137);
        w137[i] = -(v38 * v145);
        w138[i] = -(v38 * v153);
        w139[i] = (v73 * v159) - (v38 * v167);
        w140[i] = (v73 * v173) - (v38 * v181);
        w141[i] = (v73 * v187) - (v38 * v195);
        w142[i] = (v73 * v201) - (v38 * v209);
    }
}

static void jacobian_11(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[6]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const double c10 = p[5] / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v13 = c6 / (g[8 * i + 3] + (g[8 * i + 7] * c10));
        e[57 * i + 8] = -(v13 * w95[i - 1]);
        e[57 * i + 14] = (v13 * w95[i]) - (v13 * w96[i - 1]);
        e[57 * i + 20] = v13 * w96[i];
        e[57 * i + 5] = -(v13 * w97[i - 1]);
        e[57 * i + 11] = (v13 * w97[i]) - (v13 * w98[i - 1]);
        e[57 * i + 17] = v13 * w98[i];
        e[57 * i + 6] = -(v13 * w99[i - 1]);
        e[57 * i + 12] = (v13 * w99[i]) - (v13 * w100[i - 1]);
        e[57 * i + 18] = v13 * w100[i];
        e[57 * i + 7] = -(v13 * w101[i - 1]);
        e[57 * i + 13] = (v13 * w101[i]) - (v13 * w102[i - 1]);
        e[57 * i + 19] = v13 * w102[i];
        e[57 * i + 3] = -(v13 * w103[i - 1]);
        e[57 * i + 9] = (v13 * w103[i]) - (v13 * w104[i - 1]);
        e[57 * i + 15] = v13 * w104[i];
        e[57 * i + 4] = -(v13 * w105[i - 1]);
        e[57 * i + 10] = (v13 * w105[i]) - (v13 * w106[i - 1]);
        e[57 * i + 16] = v13 * w106[i];
    }
}

static void jacobian_12(int n, const double *p, const double *g, double *w, double *e)
{
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
    double *restrict w117 = w + 117 * n;
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    double *restrict w120 = w + 120 * n;
    double *restrict w121 = w + 121 * n;
    double *restrict w122 = w + 122 * n;
    double *restrict w123 = w + 123 * n;
    double *restrict w124 = w + 124 * n;
    double *restrict w125 = w + 125 * n;
    double *restrict w126 = w + 126 * n;
    double *restrict w127 = w + 127 * n;
    double *restrict w128 = w + 128 * n;
    double *restrict w129 = w + 129 * n;
    double *restrict w130 = w + 130 * n;
    double *restrict w131 = w + 131 * n;
    double *restrict w132 = w + 132 * n;
    double *restrict w133 = w + 133 * n;
    double *restrict w134 = w + 134 * n;
    double *restrict w135 = w + 135 * n;
    double *restrict w136 = w + 136 * n;
    double *restrict w137 = w + 137 * n;
    double *restrict w138 = w + 138 * n;
    double *restrict w139 = w + 139 * n;
    double *restrict w140 = w + 140 * n;
    double *restrict w141 = w + 141 * n;
    double *restrict w142 = w + 142 * n;
    const double c1 = squared(p[6]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c10 = p[5] / c5;
    const double c75 = 0.08333333333333333 * c4;
    const double c77 = squared(p[1]);
    const double c78 = c75 * c77;
    const double c79 = c78 * c2;
    const double c80 = c1 / c79;
    const double c84 = squared(c2);
    const double c85 = c4 * c84;
    const double c86 = c78 / c85;
    for (int i = 1; i < n - 1; i++) {
        const double v13 = c6 / (g[8 * i + 3] + (g[8 * i + 7] * c10));
        const double v87 = (c80 * g[8 * i + 5]) * c86;
        const double v100 = ((v87 * w131[i]) - (v87 * w132[i - 1])) + (v87 * w120[i - 1]);
        const double v121 = ((v87 * w133[i]) - (v87 * w134[i - 1])) + (v87 * w122[i - 1]);
        const double v142 = ((v87 * w135[i]) - (v87 * w136[i - 1])) + (v87 * w124[i - 1]);
        const double v163 = ((v87 * w137[i]) - (v87 * w138[i - 1])) + (v87 * w126[i - 1]);
        const double v184 = ((v87 * w139[i]) - (v87 * w140[i - 1])) + (v87 * w128[i - 1]);
        const double v205 = ((v87 * w141[i]) - (v87 * w142[i - 1])) + (v87 * w130[i - 1]);
        e[57 * i + 26] = -(v13 * w107[i - 1]);
        e[57 * i + 32] = (v13 * w107[i]) - (v13 * w108[i - 1]);
        e[57 * i + 38] = v13 * w108[i];
        e[57 * i + 23] = -(v13 * w109[i - 1]);
        e[57 * i + 29] = (v13 * w109[i]) - (v13 * w110[i - 1]);
        e[57 * i + 35] = v13 * w110[i];
        e[57 * i + 24] = -(v13 * w111[i - 1]);
        e[57 * i + 30] = (v13 * w111[i]) - (v13 * w112[i - 1]);
        e[57 * i + 36] = v13 * w112[i];
        e[57 * i + 25] = -(v13 * w113[i - 1]);
        e[57 * i + 31] = (v13 * w113[i]) - (v13 * w114[i - 1]);
        e[57 * i + 37] = v13 * w114[i];
        e[57 * i + 21] = -(v13 * w115[i - 1]);
        e[57 * i + 27] = (v13 * w115[i]) - (v13 * w116[i - 1]);
        e[57 * i + 33] = v13 * w116[i];
        e[57 * i + 22] = -(v13 * w117[i - 1]);
        e[57 * i + 28] = (v13 * w117[i]) - (v13 * w118[i - 1]);
        e[57 * i + 34] = v13 * w118[i];
        e[57 * i + 44] = (v87 * w119[i - 1]) - (v87 * w131[i - 1]);
        e[57 * i + 50] = v100 + (v87 * w119[i]);
        e[57 * i + 56] = (v87 * w132[i]) + (v87 * w120[i]);
        e[57 * i + 41] = (v87 * w121[i - 1]) - (v87 * w133[i - 1]);
        e[57 * i + 47] = v121 + (v87 * w121[i]);
        e[57 * i + 53] = (v87 * w134[i]) + (v87 * w122[i]);
        e[57 * i + 42] = (v87 * w123[i - 1]) - (v87 * w135[i - 1]);
        e[57 * i + 48] = v142 + (v87 * w123[i]);
        e[57 * i + 54] = (v87 * w136[i]) + (v87 * w124[i]);
        e[57 * i + 43] = (v87 * w125[i - 1]) - (v87 * w137[i - 1]);
        e[57 * i + 49] = v163 + (v87 * w125[i]);
        e[57 * i + 55] = (v87 * w138[i]) + (v87 * w126[i]);
        e[57 * i + 39] = (v87 * w127[i - 1]) - (v87 * w139[i - 1]);
        e[57 * i + 45] = v184 + (v87 * w127[i]);
        e[57 * i + 51] = (v87 * w140[i]) + (v87 * w128[i]);
        e[57 * i + 40] = (v87 * w129[i - 1]) - (v87 * w141[i - 1]);
        e[57 * i + 46] = v205 + (v87 * w129[i]);
        e[57 * i + 52] = (v87 * w142[i]) + (v87 * w130[i]);
    }
}

static void jacobian_13(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w119 = w + 119 * n;
    double *restrict w120 = w + 120 * n;
    double *restrict w121 = w + 121 * n;
    double *restrict w122 = w + 122 * n;
    double *restrict w123 = w + 123 * n;
    double *restrict w124 = w + 124 * n;
    double *restrict w125 = w + 125 * n;
    double *restrict w126 = w + 126 * n;
    double *restrict w127 = w + 127 * n;
    double *restrict w128 = w + 128 * n;
    double *restrict w129 = w + 129 * n;
    double *restrict w130 = w + 130 * n;
    double *restrict w131 = w + 131 * n;
    double *restrict w132 = w + 132 * n;
    double *restrict w133 = w + 133 * n;
    double *restrict w134 = w + 134 * n;
    double *restrict w135 = w + 135 * n;
    double *restrict w136 = w + 136 * n;
    double *restrict w137 = w + 137 * n;
    double *restrict w138 = w + 138 * n;
    double *restrict w139 = w + 139 * n;
    double *restrict w140 = w + 140 * n;
    double *restrict w141 = w + 141 * n;
    double *restrict w142 = w + 142 * n;
    const double c1 = p[2];
    const double c2 = 0.08333333333333333 * c1;
    const double c4 = squared(p[1]);
    const double c5 = c2 * c4;
    const double c6 = p[0];
    const double c7 = squared(c6);
    const double c8 = c1 * c7;
    const double c9 = c5 / c8;
    const double c11 = squared(p[6]);
    const double c12 = c5 * c6;
    const double c13 = c11 / c12;
    const int i = n - 1;
    const double v17 = c9 * (c13 * g[8 * i + 5]);
    e[57 * i + 44] = (v17 * w119[i - 1]) - (v17 * w131[i - 1]);
    e[57 * i + 50] = (v17 * w120[i - 1]) - (v17 * w132[i - 1]);
    e[57 * i + 41] = (v17 * w121[i - 1]) - (v17 * w133[i - 1]);
    e[57 * i + 47] = (v17 * w122[i - 1]) - (v17 * w134[i - 1]);
    e[57 * i + 42] = (v17 * w123[i - 1]) - (v17 * w135[i - 1]);
    e[57 * i + 48] = (v17 * w124[i - 1]) - (v17 * w136[i - 1]);
    e[57 * i + 43] = (v17 * w125[i - 1]) - (v17 * w137[i - 1]);
    e[57 * i + 49] = (v17 * w126[i - 1]) - (v17 * w138[i - 1]);
    e[57 * i + 39] = (v17 * w127[i - 1]) - (v17 * w139[i - 1]);
    e[57 * i + 45] = (v17 * w128[i - 1]) - (v17 * w140[i - 1]);
    e[57 * i + 40] = (v17 * w129[i - 1]) - (v17 * w141[i - 1]);
    e[57 * i + 46] = (v17 * w130[i - 1]) - (v17 * w142[i - 1]);
    (void)n;
}

static void jacobian_14(int n, const double *p, const double *g, double *w, double *e)
{
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
    double *restrict w117 = w + 117 * n;
    double *restrict w118 = w + 118 * n;
    const double c1 = squared(p[6]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const double c10 = p[5] / c5;
    const int i = 0;
    const double v13 = c6 / (g[8 * i + 3] + (g[8 * i + 7] * c10));
    e[57 * i + 32] = v13 * w107[i];
    e[57 * i + 38] = v13 * w108[i];
    e[57 * i + 29] = v13 * w109[i];
    e[57 * i + 35] = v13 * w110[i];
    e[57 * i + 30] = v13 * w111[i];
    e[57 * i + 36] = v13 * w112[i];
    e[57 * i + 31] = v13 * w113[i];
    e[57 * i + 37] = v13 * w114[i];
    e[57 * i + 27] = v13 * w115[i];
    e[57 * i + 33] = v13 * w116[i];
    e[57 * i + 28] = v13 * w117[i];
    e[57 * i + 34] = v13 * w118[i];
    (void)n;
}

static void work_0(int n, const double *p, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w143 = w + 143 * n;
    const double c1 = p[4];
    const double c27 = 1.0 / c1;
    const double c30 = 3.6 / c1;
    const double c32 = 0.2777777777777778 * c1;
    for (int i = 0; i < n - 1; i++) {
        double sum15 = 0.0;
        const double v2 = w6[i];
        const double v6 = w9[i];
        const double v7 = sqrt(v6);
        const double v8 = squared(v6);
        const double v10 = (0.75 * w11[i]) / (v7 * v8);
        const double v15 = 1.0 / v6;
        const double v22 = ((-0.5) * w8[i]) / (v7 * v6);
        const double v41 = c30 * squared((c32 * ((w7[i] * v15) - ((w10[i] * v2) / v8))));
        for (int k = 0; k < FIBRES; k++) {
            const double v13 = p[1] * zeta[k];
            const double v28 = squared((c1 * ((v2 * ((v10 * v13) + v15)) + (v22 * v13)))) * c27;
            sum15 += (v28 + v41) * weight[k];
        }
        w143[i] = sum15;
    }
}

static void work_1(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w143 = w + 143 * n;
    const double c3 = p[6];
    const double c6 = p[0] / c3;
    const double c7 = squared(c6);
    const double c8 = p[2] * c7;
    const double c9 = c3 / c8;
    for (int i = 0; i < n - 1; i++) {
        q[0] += (g[8 * i + 1] * w143[i]) * c9;
    }
}

static void work_slope_0(int n, const double *p, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
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
    double *restrict w52 = w + 52 * n;
    double *restrict w53 = w + 53 * n;
    double *restrict w54 = w + 54 * n;
    double *restrict w55 = w + 55 * n;
    double *restrict w56 = w + 56 * n;
    double *restrict w57 = w + 57 * n;
    double *restrict w58 = w + 58 * n;
    double *restrict w143 = w + 143 * n;
    double *restrict w144 = w + 144 * n;
    double *restrict w145 = w + 145 * n;
    double *restrict w146 = w + 146 * n;
    double *restrict w147 = w + 147 * n;
    double *restrict w148 = w + 148 * n;
    double *restrict w149 = w + 149 * n;
    double *restrict w150 = w + 150 * n;
    double *restrict w151 = w + 151 * n;
    double *restrict w152 = w + 152 * n;
    double *restrict w153 = w + 153 * n;
    double *restrict w154 = w + 154 * n;
    double *restrict w155 = w + 155 * n;
    const double c115 = p[4];
    const double c143 = 1.0 / c115;
    const double c146 = 3.6 / c115;
    const double c148 = 0.2777777777777778 * c115;
    for (int i = 0; i < n - 1; i++) {
        double sum15 = 0.0;
        double sum16 = 0.0;
        double sum17 = 0.0;
        double sum18 = 0.0;
        double sum19 = 0.0;
        double sum20 = 0.0;
        double sum21 = 0.0;
        const double v116 = w6[i];
        const double v120 = w9[i];
        const double v121 = sqrt(v120);
        const double v122 = squared(v120);
        const double v124 = 1.0 / (v121 * v122);
        const double v125 = (0.75 * w11[i]) * v124;
        const double v130 = 1.0 / v120;
        const double v137 = 1.0 / (v121 * v120);
        const double v138 = ((-0.5) * w8[i]) * v137;
        const double v150 = w7[i] * v130;
        const double v151 = w10[i];
        const double v153 = 1.0 / v122;
        const double v154 = (v151 * v116) * v153;
        const double v156 = c148 * (v150 - v154);
        const double v158 = c146 * squared(v156);
        const double v162 = 2.0 * v156;
        const double v170 = 2.0 * v120;
        const double v171 = v154 * v153;
        const double v174 = v150 * v130;
        const double v177 = v138 * v137;
        const double v188 = 1.0 / (2.0 * v121);
        const double v191 = v130 * v130;
        const double v195 = v125 * v124;
        for (int k = 0; k < FIBRES; k++) {
            const double v128 = p[1] * zeta[k];
            const double v131 = (v125 * v128) + v130;
            const double v141 = c115 * ((v116 * v131) + (v138 * v128));
            const double v160 = weight[k];
            const double v165 = c148 * (v162 * (c146 * v160));
            const double v166 = v165 * v153;
            const double v181 = c115 * ((2.0 * v141) * (v160 / c115));
            const double v182 = v128 * v181;
            const double v183 = v177 * v182;
            const double v190 = (((v170 * (v171 * v165)) - (v174 * v165)) - (v121 * v183)) - ((v120 * v183) * v188);
            const double v192 = v116 * v181;
            const double v196 = v128 * v192;
            const double v197 = v195 * v196;
            const double v203 = ((v190 - (v191 * v192)) - (v170 * (v121 * v197))) - ((v122 * v197) * v188);
            sum15 += ((squared(v141) * c143) + v158) * v160;
            sum16 += -(v116 * v166);
            sum17 += v165 * v130;
            sum18 += v203;
            sum19 += (v131 * v181) - (v151 * v166);
            sum20 += 0.75 * (v196 * v124);
            sum21 += (-0.5) * (v182 * v137);
        }
        const double v1 = sum17;
        const double v4 = sum19;
        const double v8 = sum21;
        const double v20 = sum16;
        const double v26 = sum18;
        const double v32 = (((v20 * w51[i]) + (v1 * w33[i])) + (v26 * w45[i])) + (v4 * w21[i]);
        const double v33 = sum20;
        const double v47 = (((v20 * w52[i]) + (v1 * w34[i])) + (v26 * w46[i])) + (v4 * w22[i]);
        const double v81 = (((v20 * w53[i]) + (v1 * w39[i])) + (v26 * w47[i])) + (v4 * w27[i]);
        const double v92 = (((v20 * w54[i]) + (v1 * w40[i])) + (v26 * w48[i])) + (v4 * w28[i]);
        const double v103 = (((v20 * w55[i]) + (v1 * w41[i])) + (v26 * w49[i])) + (v4 * w29[i]);
        const double v114 = (((v20 * w56[i]) + (v1 * w42[i])) + (v26 * w50[i])) + (v4 * w30[i]);
        w143[i] = sum15;
        w144[i] = ((v1 * w31[i]) + (v4 * w19[i])) + (v8 * w43[i]);
        w145[i] = ((v1 * w32[i]) + (v4 * w20[i])) + (v8 * w44[i]);
        w146[i] = v32 + (v33 * w57[i]);
        w147[i] = v47 + (v33 * w58[i]);
        w148[i] = (v1 * w35[i]) + (v4 * w23[i]);
        w149[i] = (v1 * w36[i]) + (v4 * w24[i]);
        w150[i] = (v1 * w37[i]) + (v4 * w25[i]);
        w151[i] = (v1 * w38[i]) + (v4 * w26[i]);
        w152[i] = v81;
        w153[i] = v92;
        w154[i] = v103;
        w155[i] = v114;
    }
}

static void work_slope_1(int n, const double *p, const double *g, double *w, double *s)
{
    double *restrict w144 = w + 144 * n;
    double *restrict w145 = w + 145 * n;
    double *restrict w146 = w + 146 * n;
    double *restrict w147 = w + 147 * n;
    double *restrict w148 = w + 148 * n;
    double *restrict w149 = w + 149 * n;
    double *restrict w150 = w + 150 * n;
    double *restrict w151 = w + 151 * n;
    double *restrict w152 = w + 152 * n;
    double *restrict w153 = w + 153 * n;
    double *restrict w154 = w + 154 * n;
    double *restrict w155 = w + 155 * n;
    const double c0 = p[6];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v8 = c6 * g[8 * i + 1];
        s[6 * i + 5] += v8 * w144[i];
        s[6 * i + 11] += v8 * w145[i];
        s[6 * i + 2] += v8 * w146[i];
        s[6 * i + 8] += v8 * w147[i];
        s[6 * i + 3] += v8 * w148[i];
        s[6 * i + 9] += v8 * w149[i];
        s[6 * i + 4] += v8 * w150[i];
        s[6 * i + 10] += v8 * w151[i];
        s[6 * i] += v8 * w152[i];
        s[6 * i + 6] += v8 * w153[i];
        s[6 * i + 1] += v8 * w154[i];
        s[6 * i + 7] += v8 * w155[i];
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 6; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, f);
    rates_2(n, y, f);
    rates_3(n, y, w);
    rates_4(n, y, w);
    rates_5(n, y, w);
    rates_6(n, w);
    rates_7(n, g, w);
    rates_8(n, p, g, w);
    rates_9(n, p, w);
    rates_10(n, p, g, w);
    rates_11(n, p, g, w, f);
    rates_12(n, p, g, w, f);
    rates_13(n, p, g, w, f);
    rates_14(n, p, g, w, f);
    return SOFTCAT_SOLVED;
}

static int jacobian(const softcat_filament *filament, double t, const double *y, double *e,
                    double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 57; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, e);
    jacobian_2(n, e);
    jacobian_3(n, y, w);
    jacobian_4(n, y, w);
    jacobian_5(n, y, w);
    jacobian_6(n, w);
    jacobian_7(n, g, w);
    jacobian_8(n, p, g, w);
    jacobian_9(n, p, w);
    jacobian_10(n, p, g, w);
    jacobian_11(n, p, g, w, e);
    jacobian_12(n, p, g, w, e);
    jacobian_13(n, p, g, w, e);
    jacobian_14(n, p, g, w, e);
    return SOFTCAT_SOLVED;
}

static int work(const softcat_filament *filament, double t, const double *y, double *q,
                double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    (void)y;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, w);
    work_1(n, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    (void)y;
    for (int k = 0; k < n * 3 * 6; k++) s[k] = 0.0;
    work_slope_0(n, p, w);
    work_slope_1(n, p, g, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {
    3, 4, 5, -1, -1, -1};
static const int differential[] = {
    1, 1, 1, 0, 0, 0};
static const int held_first[] = {
    1, 0, 1, 1, 0, 1};
static const int held_last[] = {
    1, 1, 0, 1, 1, 0};
static const int row[] = {
    0, 1, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
static const int offset[] = {
    0, 0, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1,
    1};
static const int column[] = {
    3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3,
    4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5};

const softcat_model softcat_filament_model = {
    6, 0, 7, 8, 156, 57, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "viscosity", "point_mass_per_area",
    "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa*s", "kg/m^2", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.05, 0.003, 2500.0, 9.81, 9600000000000.0, 2222.222222222222, 0.07139215614635322};
static const char *const described_slots[] = {
    "x", "y", "psi", "u", "v", "omega"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS, SOFTCAT_PLACE_HUNG};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 0};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Glass bar with a weight in a beam-bending viscometer",
    .parameter_names = described_parameters,
    .parameter_units = described_units,
    .parameter_ranges = described_ranges,
    .parameter_values = described_values,
    .slot_names = described_slots,
    .on_cells = described_on_cells,
    .mean = described_mean,
    .bending = described_bending,
    .first = SOFTCAT_SYMMETRY,
    .last = SOFTCAT_PINNED,
    .least_cells = 4,
    .area_power = 1,
    .profiled = 0,
    .places = described_places,
    .x = 0,
    .y = 1,
    .psi = 2,
    .rest_length = 0,
    .time_scale = 6,
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
    .grading = 1.0,
    .relative = 3e-05,
    .absolute = 5.251312949582929e-09,
    .towards_middle = 0,
    .duration = 3600.0,
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
