/*
 * Viscous blob drawn out into a bridge that sags
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-stress, shear, rotary-inertia, surface-tension
 * Digest of the structure: 7b81edd6451ba7504fd509cb245cc6c14e67b371d398e87cc028e61d504ad34d
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES 2
#define SLOTS 6
#define ENTRIES 57
#define SCRATCH 182

/* Coordinate of each fibre, from -1 to 1 through the thickness, and its share of the section. */
static const double zeta[] = {
    (-0.4999999999999998), 0.5000000000000001};
static const double weight[] = {
    0.5, 0.4999999999999999};

static inline double smaller(double a, double b) { return a < b ? a : b; }
static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[6 * i] = y[6 * i + 2];
        f[6 * i + 1] = y[6 * i + 3];
        f[6 * i + 4] = y[6 * i + 5];
    }
}

static void rates_1(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 1];
        w2[i] = y[6 * i + 4];
        w3[i] = y[6 * i + 2];
        w4[i] = y[6 * i + 3];
        w5[i] = y[6 * i + 5];
    }
}

static void rates_2(int n, double t, const double *p, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const double c1 = p[7];
    const double c3 = p[12];
    const double c4 = t * c3;
    const double c5 = p[6];
    const double c7 = larger(c5, 1e-300);
    const double c8 = c4 / c7;
    const double c10 = larger(c8, 0.0);
    const double c12 = smaller(c10, 1.0);
    const double c13 = c1 * c12;
    const double c15 = p[10] - c1;
    const double c16 = c4 - c5;
    const double c17 = p[9];
    const double c18 = c17 - c5;
    const double c19 = larger(c18, 1e-300);
    const double c20 = c16 / c19;
    const double c21 = larger(c20, 0.0);
    const double c22 = smaller(c21, 1.0);
    const double c23 = c15 * c22;
    const double c24 = c13 + c23;
    const double c25 = p[0];
    const double c26 = c24 / c25;
    const double c27 = 0.5 + c26;
    const double c28 = p[8];
    const double c29 = c28 * c12;
    const double c31 = p[11] - c28;
    const double c32 = c31 * c22;
    const double c33 = c29 + c32;
    const double c34 = c33 / c25;
    const double c35 = (double)(0.0 <= c4);
    const double c36 = (double)(c4 < c5);
    const double c37 = (double)((c35 != 0.0) && (c36 != 0.0));
    const double c38 = c37 * c1;
    const double c39 = c38 / c7;
    const double c40 = (double)(c5 <= c4);
    const double c41 = (double)(c4 < c17);
    const double c42 = (double)((c40 != 0.0) && (c41 != 0.0));
    const double c43 = c42 * c15;
    const double c44 = c43 / c19;
    const double c45 = c39 + c44;
    const double c46 = c45 / c25;
    const double c47 = c46 * c3;
    const double c48 = c37 * c28;
    const double c49 = c48 / c7;
    const double c50 = c42 * c31;
    const double c51 = c50 / c19;
    const double c52 = c49 + c51;
    const double c53 = c52 / c25;
    const double c54 = c53 * c3;
    const int i = n - 1;
    w0[i] = c27;
    w1[i] = c34;
    w2[i] = 0.0;
    w3[i] = c47;
    w4[i] = c54;
    w5[i] = 0.0;
    (void)n;
}

static void rates_3(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const int i = 0;
    w0[i] = -0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
    w3[i] = 0.0;
    w4[i] = 0.0;
    w5[i] = 0.0;
    (void)n;
}

static void rates_4(int n, const double *p, const double *g, double *w)
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
    const double c2 = 1.0 / p[12];
    const double c56 = 1.0 / p[0];
    for (int i = 0; i < n - 1; i++) {
        const double v3 = w5[i] * c2;
        const double v5 = w5[i + 1] * c2;
        const double v9 = (v3 + v5) * 0.5;
        const double v14 = g[7 * i + 4];
        const double v15 = (w1[i + 1] - w1[i]) * v14;
        const double v16 = w2[i];
        const double v17 = w2[i + 1];
        const double v19 = (v16 + v17) * 0.5;
        const double v20 = cos(v19);
        const double v25 = (w0[i + 1] - w0[i]) * v14;
        const double v26 = sin(v19);
        const double v28 = (v15 * v20) - (v25 * v26);
        const double v35 = ((w3[i + 1] * c2) - (w3[i] * c2)) * v14;
        const double v43 = ((w4[i + 1] * c2) - (w4[i] * c2)) * v14;
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

static void rates_5(int n, const double *p, double *w)
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
    const double c33 = 0.3 * c3;
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

static void rates_6(int n, const double *p, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
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
    double *restrict w19 = w + 19 * n;
    double *restrict w20 = w + 20 * n;
    const double c12 = p[1];
    const double c13 = 0.5 * c12;
    const double c38 = p[5] / c12;
    const double c39 = 2.0 * c38;
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w9[i];
        const double v2 = 1.0 / v1;
        const double v4 = w10[i];
        const double v5 = w14[i];
        const double v6 = v5 * v2;
        const double v18 = (c13 * w13[i]) / (sqrt(v1) * v1);
        const double v23 = ((w12[i] * v2) - ((v4 * v6) * v2)) + (((1.5 * v18) * w11[i]) * v2);
        const double v28 = (w2[i] + w2[i + 1]) * 0.5;
        const double v29 = cos(v28);
        const double v31 = sin(v28);
        const double v33 = (v23 * v29) - (v6 * v31);
        const double v36 = (v23 * v31) + (v6 * v29);
        const double v44 = g[7 * i + 4];
        const double v45 = (w0[i + 1] - w0[i]) * v44;
        const double v50 = (w1[i + 1] - w1[i]) * v44;
        const double v53 = sqrt(squared(v45) + squared(v50));
        const double v56 = (c39 / sqrt(v53)) / v53;
        w15[i] = v33;
        w16[i] = v36;
        w17[i] = v33 + (v56 * v45);
        w18[i] = v36 + (v56 * v50);
        w19[i] = ((g[7 * i + 1] * p[0]) * (v5 - (v4 * v23))) * 0.5;
        w20[i] = -v18;
    }
}

static void rates_7(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    double *restrict w19 = w + 19 * n;
    double *restrict w20 = w + 20 * n;
    const double c4 = squared(p[12]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c7 = p[2];
    const double c8 = c7 * c5;
    const double c9 = c6 / c8;
    const double c19 = p[3] * c6;
    const double c29 = 0.0625 * c7;
    const double c31 = squared(p[1]);
    const double c32 = c29 * c31;
    const double c33 = c32 * c5;
    const double c34 = c4 / c33;
    for (int i = 1; i < n - 1; i++) {
        const double v12 = c9 * g[7 * i + 6];
        const double v38 = (((w20[i] - w20[i - 1]) + w19[i]) + w19[i - 1]) * (c34 * g[7 * i + 5]);
        f[6 * i + 2] = (w17[i] - w17[i - 1]) * v12;
        f[6 * i + 3] = ((w18[i] - w18[i - 1]) * v12) - c19;
        f[6 * i + 5] = v38;
    }
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[57 * i] = 1.0;
        e[57 * i + 1] = 1.0;
        e[57 * i + 38] = 1.0;
    }
}

static void jacobian_1(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 1];
        w2[i] = y[6 * i + 4];
        w3[i] = y[6 * i + 2];
        w4[i] = y[6 * i + 3];
        w5[i] = y[6 * i + 5];
    }
}

static void jacobian_2(int n, double t, const double *p, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const double c1 = p[7];
    const double c3 = p[12];
    const double c4 = t * c3;
    const double c5 = p[6];
    const double c7 = larger(c5, 1e-300);
    const double c8 = c4 / c7;
    const double c10 = larger(c8, 0.0);
    const double c12 = smaller(c10, 1.0);
    const double c13 = c1 * c12;
    const double c15 = p[10] - c1;
    const double c16 = c4 - c5;
    const double c17 = p[9];
    const double c18 = c17 - c5;
    const double c19 = larger(c18, 1e-300);
    const double c20 = c16 / c19;
    const double c21 = larger(c20, 0.0);
    const double c22 = smaller(c21, 1.0);
    const double c23 = c15 * c22;
    const double c24 = c13 + c23;
    const double c25 = p[0];
    const double c26 = c24 / c25;
    const double c27 = 0.5 + c26;
    const double c28 = p[8];
    const double c29 = c28 * c12;
    const double c31 = p[11] - c28;
    const double c32 = c31 * c22;
    const double c33 = c29 + c32;
    const double c34 = c33 / c25;
    const double c35 = (double)(0.0 <= c4);
    const double c36 = (double)(c4 < c5);
    const double c37 = (double)((c35 != 0.0) && (c36 != 0.0));
    const double c38 = c37 * c1;
    const double c39 = c38 / c7;
    const double c40 = (double)(c5 <= c4);
    const double c41 = (double)(c4 < c17);
    const double c42 = (double)((c40 != 0.0) && (c41 != 0.0));
    const double c43 = c42 * c15;
    const double c44 = c43 / c19;
    const double c45 = c39 + c44;
    const double c46 = c45 / c25;
    const double c47 = c46 * c3;
    const double c48 = c37 * c28;
    const double c49 = c48 / c7;
    const double c50 = c42 * c31;
    const double c51 = c50 / c19;
    const double c52 = c49 + c51;
    const double c53 = c52 / c25;
    const double c54 = c53 * c3;
    const int i = n - 1;
    w0[i] = c27;
    w1[i] = c34;
    w2[i] = 0.0;
    w3[i] = c47;
    w4[i] = c54;
    w5[i] = 0.0;
    (void)n;
}

static void jacobian_3(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const int i = 0;
    w0[i] = -0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
    w3[i] = 0.0;
    w4[i] = 0.0;
    w5[i] = 0.0;
    (void)n;
}

static void jacobian_4(int n, const double *p, const double *g, double *w)
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
    const double c2 = 1.0 / p[12];
    const double c86 = 1.0 / p[0];
    for (int i = 0; i < n - 1; i++) {
        const double v3 = w5[i] * c2;
        const double v5 = w5[i + 1] * c2;
        const double v9 = (v3 + v5) * 0.5;
        const double v14 = g[7 * i + 4];
        const double v15 = (w1[i + 1] - w1[i]) * v14;
        const double v16 = w2[i];
        const double v17 = w2[i + 1];
        const double v19 = (v16 + v17) * 0.5;
        const double v20 = cos(v19);
        const double v25 = (w0[i + 1] - w0[i]) * v14;
        const double v26 = sin(v19);
        const double v28 = (v15 * v20) - (v25 * v26);
        const double v35 = ((w3[i + 1] * c2) - (w3[i] * c2)) * v14;
        const double v43 = ((w4[i + 1] * c2) - (w4[i] * c2)) * v14;
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
        w21[i] = v47;
        w22[i] = v47;
        w23[i] = v55;
        w24[i] = v55;
        w25[i] = v58;
        w26[i] = v57;
        w27[i] = v61;
        w28[i] = v60;
        w29[i] = v63;
        w30[i] = v64;
        w31[i] = v67;
        w32[i] = v66;
        w7[i] = ((v43 * v20) - (v9 * v71)) - (v35 * v26);
        w33[i] = v78;
        w34[i] = v78;
        w35[i] = v83;
        w36[i] = v83;
        w37[i] = v60;
        w38[i] = v61;
        w39[i] = v58;
        w40[i] = v57;
        w41[i] = v66;
        w42[i] = v67;
        w43[i] = v63;
        w44[i] = v64;
        w8[i] = (v5 - v3) * v87;
        w45[i] = -v89;
        w46[i] = v89;
        w9[i] = v71;
        w47[i] = v94;
        w48[i] = v94;
        w49[i] = v95;
        w50[i] = v56;
        w51[i] = v96;
        w52[i] = v59;
        w10[i] = v28;
        w53[i] = v101;
        w54[i] = v101;
        w55[i] = v59;
        w56[i] = v96;
        w57[i] = v95;
        w58[i] = v56;
        w11[i] = (v17 - v16) * v87;
        w59[i] = -v87;
        w60[i] = v87;
    }
}

static void jacobian_5(int n, const double *p, double *w)
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
    double *restrict w95 = w + 95 * n;
    double *restrict w96 = w + 96 * n;
    const double c179 = p[4];
    const double c215 = 0.3 * c179;
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
        const double v2 = w21[i];
        const double v5 = w45[i];
        const double v8 = w22[i];
        const double v10 = w46[i];
        const double v14 = w47[i];
        const double v16 = w23[i];
        const double v20 = w59[i];
        const double v23 = w48[i];
        const double v25 = w24[i];
        const double v28 = w60[i];
        const double v31 = w25[i];
        const double v33 = w26[i];
        const double v35 = w27[i];
        const double v37 = w28[i];
        const double v39 = w49[i];
        const double v41 = w29[i];
        const double v44 = w50[i];
        const double v46 = w30[i];
        const double v49 = w51[i];
        const double v51 = w31[i];
        const double v54 = w52[i];
        const double v56 = w32[i];
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
        const double v117 = (((v107 * w53[i]) + (v97 * w35[i])) + (v113 * v14)) + (v100 * v16);
        const double v126 = (((v107 * w54[i]) + (v97 * w36[i])) + (v113 * v23)) + (v100 * v25);
        const double v151 = (((v107 * w55[i]) + (v97 * w41[i])) + (v113 * v39)) + (v100 * v41);
        const double v160 = (((v107 * w56[i]) + (v97 * w42[i])) + (v113 * v44)) + (v100 * v46);
        const double v169 = (((v107 * w57[i]) + (v97 * w43[i])) + (v113 * v49)) + (v100 * v51);
        const double v178 = (((v107 * w58[i]) + (v97 * w44[i])) + (v113 * v54)) + (v100 * v56);
        w12[i] = sum0;
        w61[i] = (v1 * v2) + (v4 * v5);
        w62[i] = (v1 * v8) + (v4 * v10);
        w63[i] = ((v13 * v14) + (v1 * v16)) + (v19 * v20);
        w64[i] = ((v13 * v23) + (v1 * v25)) + (v19 * v28);
        w65[i] = v1 * v31;
        w66[i] = v1 * v33;
        w67[i] = v1 * v35;
        w68[i] = v1 * v37;
        w69[i] = (v13 * v39) + (v1 * v41);
        w70[i] = (v13 * v44) + (v1 * v46);
        w71[i] = (v13 * v49) + (v1 * v51);
        w72[i] = (v13 * v54) + (v1 * v56);
        w13[i] = sum1;
        w73[i] = (v60 * v2) + (v62 * v5);
        w74[i] = (v60 * v8) + (v62 * v10);
        w75[i] = ((v68 * v14) + (v60 * v16)) + (v72 * v20);
        w76[i] = ((v68 * v23) + (v60 * v25)) + (v72 * v28);
        w77[i] = v60 * v31;
        w78[i] = v60 * v33;
        w79[i] = v60 * v35;
        w80[i] = v60 * v37;
        w81[i] = (v68 * v39) + (v60 * v41);
        w82[i] = (v68 * v44) + (v60 * v46);
        w83[i] = (v68 * v49) + (v60 * v51);
        w84[i] = (v68 * v54) + (v60 * v56);
        w14[i] = sum2;
        w85[i] = (v97 * w33[i]) + (v100 * v2);
        w86[i] = (v97 * w34[i]) + (v100 * v8);
        w87[i] = v117;
        w88[i] = v126;
        w89[i] = (v97 * w37[i]) + (v100 * v31);
        w90[i] = (v97 * w38[i]) + (v100 * v33);
        w91[i] = (v97 * w39[i]) + (v100 * v35);
        w92[i] = (v97 * w40[i]) + (v100 * v37);
        w93[i] = v151;
        w94[i] = v160;
        w95[i] = v169;
        w96[i] = v178;
    }
}

static void jacobian_6(int n, const double *p, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
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
    double *restrict w19 = w + 19 * n;
    double *restrict w20 = w + 20 * n;
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
    double *restrict w156 = w + 156 * n;
    double *restrict w157 = w + 157 * n;
    double *restrict w158 = w + 158 * n;
    double *restrict w159 = w + 159 * n;
    double *restrict w160 = w + 160 * n;
    double *restrict w161 = w + 161 * n;
    double *restrict w162 = w + 162 * n;
    double *restrict w163 = w + 163 * n;
    double *restrict w164 = w + 164 * n;
    double *restrict w165 = w + 165 * n;
    double *restrict w166 = w + 166 * n;
    double *restrict w167 = w + 167 * n;
    double *restrict w168 = w + 168 * n;
    const double c12 = p[1];
    const double c13 = 0.5 * c12;
    const double c318 = p[5] / c12;
    const double c319 = 2.0 * c318;
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
        const double v29 = (w2[i] + w2[i + 1]) * 0.5;
        const double v30 = cos(v29);
        const double v32 = sin(v29);
        const double v34 = (v24 * v30) - (v6 * v32);
        const double v35 = v30 * v2;
        const double v36 = w61[i];
        const double v38 = c13 * v18;
        const double v41 = (v21 * (1.5 * v38)) * v2;
        const double v42 = v30 * v41;
        const double v43 = w73[i];
        const double v46 = v4 * v2;
        const double v47 = v46 * v2;
        const double v49 = v32 * v2;
        const double v50 = (v30 * v47) + v49;
        const double v51 = w85[i];
        const double v53 = ((v35 * v36) + (v42 * v43)) - (v50 * v51);
        const double v54 = w62[i];
        const double v56 = w74[i];
        const double v59 = w86[i];
        const double v61 = ((v35 * v54) + (v42 * v56)) - (v50 * v59);
        const double v62 = v6 * v2;
        const double v63 = v4 * v62;
        const double v73 = (v19 * v18) * ((v1 / (2.0 * v16)) + v16);
        const double v79 = (((v63 * v2) + (v8 * v2)) - (v3 * v2)) - (((v21 * (1.5 * v73)) * v2) + (v23 * v2));
        const double v81 = v32 * v62;
        const double v82 = (v30 * v79) + v81;
        const double v83 = w47[i];
        const double v85 = v30 * v62;
        const double v86 = w53[i];
        const double v89 = w63[i];
        const double v92 = w75[i];
        const double v95 = v20 * v2;
        const double v96 = v30 * v95;
        const double v97 = w59[i];
        const double v99 = ((((v82 * v83) - (v85 * v86)) + (v35 * v89)) + (v42 * v92)) + (v96 * v97);
        const double v100 = 0.5 * v32;
        const double v102 = 0.5 * v30;
        const double v104 = (v24 * v100) + (v6 * v102);
        const double v106 = w87[i];
        const double v108 = (v99 - v104) - (v50 * v106);
        const double v109 = w48[i];
        const double v111 = w54[i];
        const double v114 = w64[i];
        const double v117 = w76[i];
        const double v119 = (((v82 * v109) - (v85 * v111)) + (v35 * v114)) + (v42 * v117);
        const double v120 = w60[i];
        const double v124 = w88[i];
        const double v126 = ((v119 + (v96 * v120)) - v104) - (v50 * v124);
        const double v127 = w65[i];
        const double v129 = w77[i];
        const double v132 = w89[i];
        const double v134 = ((v35 * v127) + (v42 * v129)) - (v50 * v132);
        const double v135 = w66[i];
        const double v137 = w78[i];
        const double v140 = w90[i];
        const double v142 = ((v35 * v135) + (v42 * v137)) - (v50 * v140);
        const double v143 = w67[i];
        const double v145 = w79[i];
        const double v148 = w91[i];
        const double v150 = ((v35 * v143) + (v42 * v145)) - (v50 * v148);
        const double v151 = w68[i];
        const double v153 = w80[i];
        const double v156 = w92[i];
        const double v158 = ((v35 * v151) + (v42 * v153)) - (v50 * v156);
        const double v159 = w49[i];
        const double v161 = w55[i];
        const double v164 = w69[i];
        const double v167 = w81[i];
        const double v169 = (((v82 * v159) - (v85 * v161)) + (v35 * v164)) + (v42 * v167);
        const double v170 = w93[i];
        const double v172 = v169 - (v50 * v170);
        const double v173 = w50[i];
        const double v175 = w56[i];
        const double v178 = w70[i];
        const double v181 = w82[i];
        const double v183 = (((v82 * v173) - (v85 * v175)) + (v35 * v178)) + (v42 * v181);
        const double v184 = w94[i];
        const double v186 = v183 - (v50 * v184);
        const double v187 = w51[i];
        const double v189 = w57[i];
        const double v192 = w71[i];
        const double v195 = w83[i];
        const double v197 = (((v82 * v187) - (v85 * v189)) + (v35 * v192)) + (v42 * v195);
        const double v198 = w95[i];
        const double v200 = v197 - (v50 * v198);
        const double v201 = w52[i];
        const double v203 = w58[i];
        const double v206 = w72[i];
        const double v209 = w84[i];
        const double v211 = (((v82 * v201) - (v85 * v203)) + (v35 * v206)) + (v42 * v209);
        const double v212 = w96[i];
        const double v214 = v211 - (v50 * v212);
        const double v217 = (v24 * v32) + (v6 * v30);
        const double v219 = v32 * v41;
        const double v223 = v35 - (v32 * v47);
        const double v225 = ((v49 * v36) + (v219 * v43)) + (v223 * v51);
        const double v230 = ((v49 * v54) + (v219 * v56)) + (v223 * v59);
        const double v232 = (v32 * v79) - v85;
        const double v239 = (((v232 * v83) - (v81 * v86)) + (v49 * v89)) + (v219 * v92);
        const double v240 = v32 * v95;
        const double v245 = (v24 * v102) - (v6 * v100);
        const double v248 = ((v239 + (v240 * v97)) + v245) + (v223 * v106);
        const double v255 = (((v232 * v109) - (v81 * v111)) + (v49 * v114)) + (v219 * v117);
        const double v260 = ((v255 + (v240 * v120)) + v245) + (v223 * v124);
        const double v265 = ((v49 * v127) + (v219 * v129)) + (v223 * v132);
        const double v270 = ((v49 * v135) + (v219 * v137)) + (v223 * v140);
        const double v275 = ((v49 * v143) + (v219 * v145)) + (v223 * v148);
        const double v280 = ((v49 * v151) + (v219 * v153)) + (v223 * v156);
        const double v287 = (((v232 * v159) - (v81 * v161)) + (v49 * v164)) + (v219 * v167);
        const double v289 = v287 + (v223 * v170);
        const double v296 = (((v232 * v173) - (v81 * v175)) + (v49 * v178)) + (v219 * v181);
        const double v298 = v296 + (v223 * v184);
        const double v305 = (((v232 * v187) - (v81 * v189)) + (v49 * v192)) + (v219 * v195);
        const double v307 = v305 + (v223 * v198);
        const double v314 = (((v232 * v201) - (v81 * v203)) + (v49 * v206)) + (v219 * v209);
        const double v316 = v314 + (v223 * v212);
        const double v324 = g[7 * i + 4];
        const double v325 = (w0[i + 1] - w0[i]) * v324;
        const double v330 = (w1[i + 1] - w1[i]) * v324;
        const double v333 = sqrt(squared(v325) + squared(v330));
        const double v334 = sqrt(v333);
        const double v335 = 1.0 / v334;
        const double v336 = c319 * v335;
        const double v337 = 1.0 / v333;
        const double v338 = v336 * v337;
        const double v341 = v336 * v335;
        const double v345 = 1.0 / (2.0 * v333);
        const double v346 = ((2.0 * v325) * v324) * v345;
        const double v348 = 1.0 / (2.0 * v334);
        const double v352 = v338 * v337;
        const double v354 = ((v341 * (v346 * v348)) * v337) + (v352 * v346);
        const double v355 = v325 * v354;
        const double v356 = v338 * v324;
        const double v363 = ((2.0 * v330) * v324) * v345;
        const double v368 = ((v341 * (v363 * v348)) * v337) + (v352 * v363);
        const double v369 = v325 * v368;
        const double v374 = v330 * v354;
        const double v377 = v330 * v368;
        const double v383 = g[7 * i + 1] * p[0];
        const double v392 = 0.5 * (v383 * (1.0 + (v4 * v47)));
        const double v395 = 0.5 * (v383 * v46);
        const double v399 = 0.5 * (v383 * (v4 * v41));
        const double v411 = 0.5 * (v383 * (v24 - v63));
        const double v415 = 0.5 * (v383 * (v4 * v79));
        const double v421 = (((v411 * v86) + (v415 * v83)) + (v395 * v89)) + (v399 * v92);
        const double v424 = 0.5 * (v383 * (v4 * v95));
        const double v435 = (((v411 * v111) + (v415 * v109)) + (v395 * v114)) + (v399 * v117);
        const double v466 = (((v411 * v161) + (v415 * v159)) + (v395 * v164)) + (v399 * v167);
        const double v475 = (((v411 * v175) + (v415 * v173)) + (v395 * v178)) + (v399 * v181);
        const double v484 = (((v411 * v189) + (v415 * v187)) + (v395 * v192)) + (v399 * v195);
        const double v493 = (((v411 * v203) + (v415 * v201)) + (v395 * v206)) + (v399 * v209);
        w15[i] = v34;
        w97[i] = v53;
        w98[i] = v61;
        w99[i] = v108;
        w100[i] = v126;
        w101[i] = v134;
        w102[i] = v142;
        w103[i] = v150;
        w104[i] = v158;
        w105[i] = v172;
        w106[i] = v186;
        w107[i] = v200;
        w108[i] = v214;
        w16[i] = v217;
        w109[i] = v225;
        w110[i] = v230;
        w111[i] = v248;
        w112[i] = v260;
        w113[i] = v265;
        w114[i] = v270;
        w115[i] = v275;
        w116[i] = v280;
        w117[i] = v289;
        w118[i] = v298;
        w119[i] = v307;
        w120[i] = v316;
        w17[i] = v34 + (v338 * v325);
        w121[i] = v53;
        w122[i] = v61;
        w123[i] = v108;
        w124[i] = v126;
        w125[i] = v134;
        w126[i] = v142;
        w127[i] = v150;
        w128[i] = v158;
        w129[i] = v172 + (v355 - v356);
        w130[i] = v186 + (v356 - v355);
        w131[i] = v200 + v369;
        w132[i] = v214 - v369;
        w18[i] = v217 + (v338 * v330);
        w133[i] = v225;
        w134[i] = v230;
        w135[i] = v248;
        w136[i] = v260;
        w137[i] = v265;
        w138[i] = v270;
        w139[i] = v275;
        w140[i] = v280;
        w141[i] = v289 + v374;
        w142[i] = v298 - v374;
        w143[i] = v307 + (v377 - v356);
        w144[i] = v316 + (v356 - v377);
        w19[i] = (v383 * (v5 - (v4 * v24))) * 0.5;
        w145[i] = (v392 * v51) - ((v395 * v36) + (v399 * v43));
        w146[i] = (v392 * v59) - ((v395 * v54) + (v399 * v56));
        w147[i] = (v392 * v106) - (v421 + (v424 * v97));
        w148[i] = (v392 * v124) - (v435 + (v424 * v120));
        w149[i] = (v392 * v132) - ((v395 * v127) + (v399 * v129));
        w150[i] = (v392 * v140) - ((v395 * v135) + (v399 * v137));
        w151[i] = (v392 * v148) - ((v395 * v143) + (v399 * v145));
        w152[i] = (v392 * v156) - ((v395 * v151) + (v399 * v153));
        w153[i] = (v392 * v170) - v466;
        w154[i] = (v392 * v184) - v475;
        w155[i] = (v392 * v198) - v484;
        w156[i] = (v392 * v212) - v493;
        w20[i] = -v19;
        w157[i] = -(v38 * v43);
        w158[i] = -(v38 * v56);
        w159[i] = (v73 * v83) - (v38 * v92);
        w160[i] = (v73 * v109) - (v38 * v117);
        w161[i] = -(v38 * v129);
        w162[i] = -(v38 * v137);
        w163[i] = -(v38 * v145);
        w164[i] = -(v38 * v153);
        w165[i] = (v73 * v159) - (v38 * v167);
        w166[i] = (v73 * v173) - (v38 * v181);
        w167[i] = (v73 * v187) - (v38 * v195);
        w168[i] = (v73 * v201) - (v38 * v209);
    }
}

static void jacobian_7(int n, const double *p, const double *g, double *w, double *e)
{
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
    double *restrict w156 = w + 156 * n;
    double *restrict w157 = w + 157 * n;
    double *restrict w158 = w + 158 * n;
    double *restrict w159 = w + 159 * n;
    double *restrict w160 = w + 160 * n;
    double *restrict w161 = w + 161 * n;
    double *restrict w162 = w + 162 * n;
    double *restrict w163 = w + 163 * n;
    double *restrict w164 = w + 164 * n;
    double *restrict w165 = w + 165 * n;
    double *restrict w166 = w + 166 * n;
    double *restrict w167 = w + 167 * n;
    double *restrict w168 = w + 168 * n;
    const double c1 = squared(p[12]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c131 = 0.0625 * c4;
    const double c133 = squared(p[1]);
    const double c134 = c131 * c133;
    const double c135 = c134 * c2;
    const double c136 = c1 / c135;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v139 = c136 * g[7 * i + 5];
        const double v152 = ((v139 * w157[i]) - (v139 * w158[i - 1])) + (v139 * w146[i - 1]);
        const double v173 = ((v139 * w159[i]) - (v139 * w160[i - 1])) + (v139 * w148[i - 1]);
        const double v194 = ((v139 * w161[i]) - (v139 * w162[i - 1])) + (v139 * w150[i - 1]);
        const double v215 = ((v139 * w163[i]) - (v139 * w164[i - 1])) + (v139 * w152[i - 1]);
        const double v236 = ((v139 * w165[i]) - (v139 * w166[i - 1])) + (v139 * w154[i - 1]);
        const double v257 = ((v139 * w167[i]) - (v139 * w168[i - 1])) + (v139 * w156[i - 1]);
        e[57 * i + 7] = -(v9 * w121[i - 1]);
        e[57 * i + 13] = (v9 * w121[i]) - (v9 * w122[i - 1]);
        e[57 * i + 19] = v9 * w122[i];
        e[57 * i + 6] = -(v9 * w123[i - 1]);
        e[57 * i + 12] = (v9 * w123[i]) - (v9 * w124[i - 1]);
        e[57 * i + 18] = v9 * w124[i];
        e[57 * i + 4] = -(v9 * w125[i - 1]);
        e[57 * i + 10] = (v9 * w125[i]) - (v9 * w126[i - 1]);
        e[57 * i + 16] = v9 * w126[i];
        e[57 * i + 5] = -(v9 * w127[i - 1]);
        e[57 * i + 11] = (v9 * w127[i]) - (v9 * w128[i - 1]);
        e[57 * i + 17] = v9 * w128[i];
        e[57 * i + 2] = -(v9 * w129[i - 1]);
        e[57 * i + 8] = (v9 * w129[i]) - (v9 * w130[i - 1]);
        e[57 * i + 14] = v9 * w130[i];
        e[57 * i + 3] = -(v9 * w131[i - 1]);
        e[57 * i + 9] = (v9 * w131[i]) - (v9 * w132[i - 1]);
        e[57 * i + 15] = v9 * w132[i];
        e[57 * i + 25] = -(v9 * w133[i - 1]);
        e[57 * i + 31] = (v9 * w133[i]) - (v9 * w134[i - 1]);
        e[57 * i + 37] = v9 * w134[i];
        e[57 * i + 24] = -(v9 * w135[i - 1]);
        e[57 * i + 30] = (v9 * w135[i]) - (v9 * w136[i - 1]);
        e[57 * i + 36] = v9 * w136[i];
        e[57 * i + 22] = -(v9 * w137[i - 1]);
        e[57 * i + 28] = (v9 * w137[i]) - (v9 * w138[i - 1]);
        e[57 * i + 34] = v9 * w138[i];
        e[57 * i + 23] = -(v9 * w139[i - 1]);
        e[57 * i + 29] = (v9 * w139[i]) - (v9 * w140[i - 1]);
        e[57 * i + 35] = v9 * w140[i];
        e[57 * i + 20] = -(v9 * w141[i - 1]);
        e[57 * i + 26] = (v9 * w141[i]) - (v9 * w142[i - 1]);
        e[57 * i + 32] = v9 * w142[i];
        e[57 * i + 21] = -(v9 * w143[i - 1]);
        e[57 * i + 27] = (v9 * w143[i]) - (v9 * w144[i - 1]);
        e[57 * i + 33] = v9 * w144[i];
        e[57 * i + 44] = (v139 * w145[i - 1]) - (v139 * w157[i - 1]);
        e[57 * i + 50] = v152 + (v139 * w145[i]);
        e[57 * i + 56] = (v139 * w158[i]) + (v139 * w146[i]);
        e[57 * i + 43] = (v139 * w147[i - 1]) - (v139 * w159[i - 1]);
        e[57 * i + 49] = v173 + (v139 * w147[i]);
        e[57 * i + 55] = (v139 * w160[i]) + (v139 * w148[i]);
        e[57 * i + 41] = (v139 * w149[i - 1]) - (v139 * w161[i - 1]);
        e[57 * i + 47] = v194 + (v139 * w149[i]);
        e[57 * i + 53] = (v139 * w162[i]) + (v139 * w150[i]);
        e[57 * i + 42] = (v139 * w151[i - 1]) - (v139 * w163[i - 1]);
        e[57 * i + 48] = v215 + (v139 * w151[i]);
        e[57 * i + 54] = (v139 * w164[i]) + (v139 * w152[i]);
        e[57 * i + 39] = (v139 * w153[i - 1]) - (v139 * w165[i - 1]);
        e[57 * i + 45] = v236 + (v139 * w153[i]);
        e[57 * i + 51] = (v139 * w166[i]) + (v139 * w154[i]);
        e[57 * i + 40] = (v139 * w155[i - 1]) - (v139 * w167[i - 1]);
        e[57 * i + 46] = v257 + (v139 * w155[i]);
        e[57 * i + 52] = (v139 * w168[i]) + (v139 * w156[i]);
    }
}

static void work_0(int n, const double *p, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w169 = w + 169 * n;
    const double c1 = p[4];
    const double c27 = 1.0 / c1;
    const double c30 = 3.3333333333333335 / c1;
    const double c32 = 0.3 * c1;
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
        w169[i] = sum15;
    }
}

static void work_1(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w169 = w + 169 * n;
    const double c3 = p[12];
    const double c6 = p[0] / c3;
    const double c7 = squared(c6);
    const double c8 = p[2] * c7;
    const double c9 = c3 / c8;
    for (int i = 0; i < n - 1; i++) {
        q[0] += (g[7 * i + 1] * w169[i]) * c9;
    }
}

static void work_2(int n, double *q)
{
    for (int i = 0; i < n - 1; i++) {
        q[1] += 0.0;
    }
}

static void work_3(int n, double t, const double *p, const double *g, double *w, double *q)
{
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    const double c3 = p[12];
    const double c4 = t * c3;
    const double c5 = (double)(0.0 <= c4);
    const double c6 = p[6];
    const double c7 = (double)(c4 < c6);
    const double c8 = (double)((c5 != 0.0) && (c7 != 0.0));
    const double c9 = p[7];
    const double c10 = c8 * c9;
    const double c12 = larger(c6, 1e-300);
    const double c13 = c10 / c12;
    const double c14 = (double)(c6 <= c4);
    const double c15 = p[9];
    const double c16 = (double)(c4 < c15);
    const double c17 = (double)((c14 != 0.0) && (c16 != 0.0));
    const double c19 = p[10] - c9;
    const double c20 = c17 * c19;
    const double c21 = c15 - c6;
    const double c22 = larger(c21, 1e-300);
    const double c23 = c20 / c22;
    const double c24 = c13 + c23;
    const double c25 = p[0];
    const double c26 = c24 / c25;
    const double c30 = p[2];
    const double c36 = p[8];
    const double c37 = c8 * c36;
    const double c38 = c37 / c12;
    const double c40 = p[11] - c36;
    const double c41 = c17 * c40;
    const double c42 = c41 / c22;
    const double c43 = c38 + c42;
    const double c44 = c43 / c25;
    const double c47 = c25 / c3;
    const double c48 = squared(c47);
    const double c49 = c30 * c48;
    const double c50 = c3 / c49;
    const int i = n - 1;
    const double v45 = (w18[i - 1] + (((g[7 * i + 3] * c30) * p[3]) * c25)) * c44;
    q[1] += ((w17[i - 1] * c26) + v45) * c50;
    (void)n;
}

static void work_slope_0(int n, const double *p, double *w)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
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
    double *restrict w169 = w + 169 * n;
    double *restrict w170 = w + 170 * n;
    double *restrict w171 = w + 171 * n;
    double *restrict w172 = w + 172 * n;
    double *restrict w173 = w + 173 * n;
    double *restrict w174 = w + 174 * n;
    double *restrict w175 = w + 175 * n;
    double *restrict w176 = w + 176 * n;
    double *restrict w177 = w + 177 * n;
    double *restrict w178 = w + 178 * n;
    double *restrict w179 = w + 179 * n;
    double *restrict w180 = w + 180 * n;
    double *restrict w181 = w + 181 * n;
    const double c115 = p[4];
    const double c143 = 1.0 / c115;
    const double c146 = 3.3333333333333335 / c115;
    const double c148 = 0.3 * c115;
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
        const double v32 = (((v20 * w53[i]) + (v1 * w35[i])) + (v26 * w47[i])) + (v4 * w23[i]);
        const double v33 = sum20;
        const double v47 = (((v20 * w54[i]) + (v1 * w36[i])) + (v26 * w48[i])) + (v4 * w24[i]);
        const double v81 = (((v20 * w55[i]) + (v1 * w41[i])) + (v26 * w49[i])) + (v4 * w29[i]);
        const double v92 = (((v20 * w56[i]) + (v1 * w42[i])) + (v26 * w50[i])) + (v4 * w30[i]);
        const double v103 = (((v20 * w57[i]) + (v1 * w43[i])) + (v26 * w51[i])) + (v4 * w31[i]);
        const double v114 = (((v20 * w58[i]) + (v1 * w44[i])) + (v26 * w52[i])) + (v4 * w32[i]);
        w169[i] = sum15;
        w170[i] = ((v1 * w33[i]) + (v4 * w21[i])) + (v8 * w45[i]);
        w171[i] = ((v1 * w34[i]) + (v4 * w22[i])) + (v8 * w46[i]);
        w172[i] = v32 + (v33 * w59[i]);
        w173[i] = v47 + (v33 * w60[i]);
        w174[i] = (v1 * w37[i]) + (v4 * w25[i]);
        w175[i] = (v1 * w38[i]) + (v4 * w26[i]);
        w176[i] = (v1 * w39[i]) + (v4 * w27[i]);
        w177[i] = (v1 * w40[i]) + (v4 * w28[i]);
        w178[i] = v81;
        w179[i] = v92;
        w180[i] = v103;
        w181[i] = v114;
    }
}

static void work_slope_1(int n, const double *p, const double *g, double *w, double *s)
{
    double *restrict w170 = w + 170 * n;
    double *restrict w171 = w + 171 * n;
    double *restrict w172 = w + 172 * n;
    double *restrict w173 = w + 173 * n;
    double *restrict w174 = w + 174 * n;
    double *restrict w175 = w + 175 * n;
    double *restrict w176 = w + 176 * n;
    double *restrict w177 = w + 177 * n;
    double *restrict w178 = w + 178 * n;
    double *restrict w179 = w + 179 * n;
    double *restrict w180 = w + 180 * n;
    double *restrict w181 = w + 181 * n;
    const double c0 = p[12];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v8 = c6 * g[7 * i + 1];
        s[6 * i + 5] += v8 * w170[i];
        s[6 * i + 11] += v8 * w171[i];
        s[6 * i + 4] += v8 * w172[i];
        s[6 * i + 10] += v8 * w173[i];
        s[6 * i + 2] += v8 * w174[i];
        s[6 * i + 8] += v8 * w175[i];
        s[6 * i + 3] += v8 * w176[i];
        s[6 * i + 9] += v8 * w177[i];
        s[6 * i] += v8 * w178[i];
        s[6 * i + 6] += v8 * w179[i];
        s[6 * i + 1] += v8 * w180[i];
        s[6 * i + 7] += v8 * w181[i];
    }
}

static void work_slope_3(int n, double t, const double *p, double *w, double *s)
{
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
    double *restrict w143 = w + 143 * n;
    double *restrict w144 = w + 144 * n;
    const double c0 = p[12];
    const double c2 = p[0];
    const double c3 = c2 / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    const double c9 = t * c0;
    const double c10 = (double)(0.0 <= c9);
    const double c11 = p[6];
    const double c12 = (double)(c9 < c11);
    const double c13 = (double)((c10 != 0.0) && (c12 != 0.0));
    const double c14 = p[7];
    const double c15 = c13 * c14;
    const double c17 = larger(c11, 1e-300);
    const double c18 = c15 / c17;
    const double c19 = (double)(c11 <= c9);
    const double c20 = p[9];
    const double c21 = (double)(c9 < c20);
    const double c22 = (double)((c19 != 0.0) && (c21 != 0.0));
    const double c24 = p[10] - c14;
    const double c25 = c22 * c24;
    const double c26 = c20 - c11;
    const double c27 = larger(c26, 1e-300);
    const double c28 = c25 / c27;
    const double c29 = c18 + c28;
    const double c30 = c29 / c2;
    const double c31 = c6 * c30;
    const double c34 = p[8];
    const double c35 = c13 * c34;
    const double c36 = c35 / c17;
    const double c38 = p[11] - c34;
    const double c39 = c22 * c38;
    const double c40 = c39 / c27;
    const double c41 = c36 + c40;
    const double c42 = c41 / c2;
    const double c43 = c6 * c42;
    const int i = n - 1;
    s[6 * n + 6 * i - 1] += (c31 * w121[i - 1]) + (c43 * w133[i - 1]);
    s[6 * n + 6 * i + 5] += (c31 * w122[i - 1]) + (c43 * w134[i - 1]);
    s[6 * n + 6 * i - 2] += (c31 * w123[i - 1]) + (c43 * w135[i - 1]);
    s[6 * n + 6 * i + 4] += (c31 * w124[i - 1]) + (c43 * w136[i - 1]);
    s[6 * n + 6 * i - 4] += (c31 * w125[i - 1]) + (c43 * w137[i - 1]);
    s[6 * n + 6 * i + 2] += (c31 * w126[i - 1]) + (c43 * w138[i - 1]);
    s[6 * n + 6 * i - 3] += (c31 * w127[i - 1]) + (c43 * w139[i - 1]);
    s[6 * n + 6 * i + 3] += (c31 * w128[i - 1]) + (c43 * w140[i - 1]);
    s[6 * n + 6 * i - 6] += (c31 * w129[i - 1]) + (c43 * w141[i - 1]);
    s[6 * n + 6 * i] += (c31 * w130[i - 1]) + (c43 * w142[i - 1]);
    s[6 * n + 6 * i - 5] += (c31 * w131[i - 1]) + (c43 * w143[i - 1]);
    s[6 * n + 6 * i + 1] += (c31 * w132[i - 1]) + (c43 * w144[i - 1]);
    (void)n;
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 6; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, w);
    rates_2(n, t, p, w);
    rates_3(n, w);
    rates_4(n, p, g, w);
    rates_5(n, p, w);
    rates_6(n, p, g, w);
    rates_7(n, p, g, w, f);
    return SOFTCAT_SOLVED;
}

static int jacobian(const softcat_filament *filament, double t, const double *y, double *e,
                    double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 57; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, y, w);
    jacobian_2(n, t, p, w);
    jacobian_3(n, w);
    jacobian_4(n, p, g, w);
    jacobian_5(n, p, w);
    jacobian_6(n, p, g, w);
    jacobian_7(n, p, g, w, e);
    return SOFTCAT_SOLVED;
}

static int work(const softcat_filament *filament, double t, const double *y, double *q,
                double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)y;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, w);
    work_1(n, p, g, w, q);
    work_2(n, q);
    work_3(n, t, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)y;
    for (int k = 0; k < n * 3 * 6; k++) s[k] = 0.0;
    work_slope_0(n, p, w);
    work_slope_1(n, p, g, w, s);
    work_slope_3(n, t, p, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {
    2, 3, -1, -1, 5, -1};
static const int differential[] = {
    1, 1, 1, 1, 1, 1};
static const int held_first[] = {
    1, 1, 1, 1, 1, 1};
static const int held_last[] = {
    1, 1, 1, 1, 1, 1};
static const int row[] = {
    0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 3, 3, 3, 3, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
static const int offset[] = {
    0, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, 0,
    0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1,
    1};
static const int column[] = {
    2, 3, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4,
    5, 0, 1, 2, 3, 4, 5, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5};

const softcat_model softcat_filament_model = {
    6, 0, 13, 7, 182, 57, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "viscosity", "surface_tension",
    "motion_0_time", "motion_0_dx", "motion_0_dy", "motion_1_time", "motion_1_dx",
    "motion_1_dy", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa*s", "N/m", "s", "m", "m", "s", "m", "m", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE, SOFTCAT_NOT_NEGATIVE, SOFTCAT_ANY, SOFTCAT_ANY,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_ANY, SOFTCAT_ANY, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.01, 0.004, 970.0, 9.81, 1470.0, 0.021, 0.0, 0.0, 0.0, 0.5, 0.04, 0.0, 0.031927542840705044};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "omega"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 0};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Viscous blob drawn out into a bridge that sags",
    .parameter_names = described_parameters,
    .parameter_units = described_units,
    .parameter_ranges = described_ranges,
    .parameter_values = described_values,
    .slot_names = described_slots,
    .on_cells = described_on_cells,
    .mean = described_mean,
    .bending = described_bending,
    .first = SOFTCAT_CLAMPED,
    .last = SOFTCAT_CLAMPED,
    .least_cells = 4,
    .area_power = 2,
    .profiled = 0,
    .places = described_places,
    .x = 0,
    .y = 1,
    .psi = 4,
    .rest_length = 0,
    .time_scale = 12,
    .gravity = 3,
    .density = 2,
    .span = -1,
    .drop = -1,
    .left_angle = -1,
    .right_angle = -1,
    .curvature = -1,
    .motion = 6,
    .motion_rows = 2,
    .stretch = 1.0,
    .initial_mean = 0,
    .initial_mean_count = 0,
    .initial_bending = 0,
    .initial_bending_count = 0,
    .thickness = 0,
    .thickness_count = 0,
    .grading = 3.0,
    .relative = 3e-05,
    .absolute = 3.0000000000000004e-07,
    .towards_middle = 0,
    .duration = 1.2,
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
