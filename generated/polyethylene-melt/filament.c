/*
 * Thread of molten polyethylene with six relaxation times
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, shear, surface-tension
 * Digest of the structure: 17b33c03ad249078c486b1fd2449ee77b7cd82a1bd27d5f0dd6b67997baba0d7
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES 2
#define SLOTS 29
#define ENTRIES 341
#define SCRATCH 90

/* Coordinate of each fibre, from -1 to 1 through the thickness, and its share of the section. */
static const double zeta[] = {
    (-0.4999999999999998), 0.5000000000000001};
static const double weight[] = {
    0.5, 0.4999999999999999};

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
    }
}

static void rates_7(int n, const double *p, const double *y, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    const double c3 = p[6];
    const double c6 = (-0.5) * p[1];
    const double c20 = p[7];
    const double c21 = 1.0 / c20;
    const double c23 = p[18];
    const double c25 = p[8];
    const double c30 = p[9];
    const double c31 = 1.0 / c30;
    const double c34 = p[10];
    const double c39 = p[11];
    const double c40 = 1.0 / c39;
    const double c43 = p[12];
    const double c48 = p[13];
    const double c49 = 1.0 / c48;
    const double c52 = p[14];
    const double c57 = p[15];
    const double c58 = 1.0 / c57;
    const double c61 = p[16];
    const double c66 = p[17];
    const double c67 = 1.0 / c66;
    const double c71 = 3.0 / c20;
    const double c73 = 0.9 * c3;
    const double c76 = 2.0 * p[4];
    const double c77 = 2.0 + c76;
    const double c78 = c73 / c77;
    const double c86 = 3.0 / c30;
    const double c87 = 0.9 * c25;
    const double c88 = c87 / c77;
    const double c94 = 3.0 / c39;
    const double c95 = 0.9 * c34;
    const double c96 = c95 / c77;
    const double c102 = 3.0 / c48;
    const double c103 = 0.9 * c43;
    const double c104 = c103 / c77;
    const double c110 = 3.0 / c57;
    const double c111 = 0.9 * c52;
    const double c112 = c111 / c77;
    const double c118 = 3.0 / c66;
    const double c119 = 0.9 * c61;
    const double c120 = c119 / c77;
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v8 = c6 * w5[i];
        const double v11 = w3[i];
        const double v13 = sqrt(v11) * v11;
        const double v17 = log(v11);
        const double v80 = w4[i] / v11;
        for (int k = 0; k < FIBRES; k++) {
            const double v9 = zeta[k];
            const double v14 = (v8 * v9) / v13;
            const double v19 = c3 * ((v14 - y[SLOTS * i + 5 + k]) + v17);
            const double v29 = c25 * ((v14 - y[SLOTS * i + 5 + 1 * FIBRES + k]) + v17);
            const double v38 = c34 * ((v14 - y[SLOTS * i + 5 + 2 * FIBRES + k]) + v17);
            const double v47 = c43 * ((v14 - y[SLOTS * i + 5 + 3 * FIBRES + k]) + v17);
            const double v56 = c52 * ((v14 - y[SLOTS * i + 5 + 4 * FIBRES + k]) + v17);
            const double v65 = c61 * ((v14 - y[SLOTS * i + 5 + 5 * FIBRES + k]) + v17);
            const double v83 = c78 * (v80 - y[SLOTS * i + 5 + 6 * FIBRES + k]);
            const double v91 = c88 * (v80 - y[SLOTS * i + 5 + 7 * FIBRES + k]);
            const double v99 = c96 * (v80 - y[SLOTS * i + 5 + 8 * FIBRES + k]);
            const double v107 = c104 * (v80 - y[SLOTS * i + 5 + 9 * FIBRES + k]);
            const double v115 = c112 * (v80 - y[SLOTS * i + 5 + 10 * FIBRES + k]);
            const double v123 = c120 * (v80 - y[SLOTS * i + 5 + 11 * FIBRES + k]);
            const double v130 = ((((v19 + v29) + v38) + v47) + v56) + v65;
            const double v131 = weight[k];
            f[SLOTS * i + 5 + k] = (v19 * c21) * c23;
            f[SLOTS * i + 5 + 1 * FIBRES + k] = (v29 * c31) * c23;
            f[SLOTS * i + 5 + 2 * FIBRES + k] = (v38 * c40) * c23;
            f[SLOTS * i + 5 + 3 * FIBRES + k] = (v47 * c49) * c23;
            f[SLOTS * i + 5 + 4 * FIBRES + k] = (v56 * c58) * c23;
            f[SLOTS * i + 5 + 5 * FIBRES + k] = (v65 * c67) * c23;
            f[SLOTS * i + 5 + 6 * FIBRES + k] = (c71 * v83) * c23;
            f[SLOTS * i + 5 + 7 * FIBRES + k] = (c86 * v91) * c23;
            f[SLOTS * i + 5 + 8 * FIBRES + k] = (c94 * v99) * c23;
            f[SLOTS * i + 5 + 9 * FIBRES + k] = (c102 * v107) * c23;
            f[SLOTS * i + 5 + 10 * FIBRES + k] = (c110 * v115) * c23;
            f[SLOTS * i + 5 + 11 * FIBRES + k] = (c118 * v123) * c23;
            sum0 += v130 * v131;
            sum1 += v130 * (v131 * v9);
            sum2 += (((((v83 + v91) + v99) + v107) + v115) + v123) * v131;
        }
        w6[i] = sum0;
        w7[i] = sum1;
        w8[i] = sum2;
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
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    const double c12 = p[1];
    const double c13 = 0.5 * c12;
    const double c38 = p[5] / c12;
    const double c39 = 2.0 * c38;
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v4 = w4[i];
        const double v5 = w8[i];
        const double v6 = v5 * v2;
        const double v18 = (c13 * w7[i]) / (sqrt(v1) * v1);
        const double v23 = ((w6[i] * v2) - ((v4 * v6) * v2)) + (((1.5 * v18) * w5[i]) * v2);
        const double v28 = (w1[i] + w1[i + 1]) * 0.5;
        const double v29 = cos(v28);
        const double v31 = sin(v28);
        const double v33 = (v23 * v29) - (v6 * v31);
        const double v36 = (v23 * v31) + (v6 * v29);
        const double v44 = g[7 * i + 4];
        const double v45 = (w0[i + 1] - w0[i]) * v44;
        const double v50 = (w2[i + 1] - w2[i]) * v44;
        const double v53 = sqrt(squared(v45) + squared(v50));
        const double v56 = (c39 / sqrt(v53)) / v53;
        w9[i] = v33;
        w10[i] = v36;
        w11[i] = v33 + (v56 * v45);
        w12[i] = v36 + (v56 * v50);
        w13[i] = ((g[7 * i + 1] * p[0]) * (v5 - (v4 * v23))) * 0.5;
        w14[i] = -v18;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w11 = w + 11 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    const double c4 = squared(p[18]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c7 = p[2];
    const double c8 = c7 * c5;
    const double c9 = c6 / c8;
    const double c22 = 0.0625 * c7;
    const double c24 = squared(p[1]);
    const double c25 = c22 * c24;
    const double c26 = c25 * c5;
    const double c27 = c4 / c26;
    const double c32 = squared(c5);
    const double c33 = c7 * c32;
    const double c34 = c25 / c33;
    for (int i = 1; i < n - 1; i++) {
        const double v31 = (((w14[i] - w14[i - 1]) + w13[i]) + w13[i - 1]) * (c27 * g[7 * i + 5]);
        f[SLOTS * i + 2] = (w11[i] - w11[i - 1]) * (c9 * g[7 * i + 6]);
        f[SLOTS * i + 4] = v31 * c34;
    }
}

static void rates_10(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w12 = w + 12 * n;
    const double c4 = squared(p[18]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    const double c15 = p[3] * c6;
    for (int i = 1; i < n - 1; i++) {
        f[SLOTS * i + 3] = ((w12[i] - w12[i - 1]) * (c9 * g[7 * i + 6])) - c15;
    }
}

static void rates_11(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w12 = w + 12 * n;
    const double c2 = squared(p[18]);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c6 = p[2] * c3;
    const double c7 = c4 / c6;
    const double c13 = p[3] * c4;
    const int i = 0;
    f[SLOTS * i + 3] = (w12[i] * (c7 * g[7 * i + 6])) - c13;
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
        w3[i] = (v5 * v12) + (v17 * v18);
        w15[i] = v25;
        w16[i] = v25;
        w17[i] = v27;
        w18[i] = v26;
        w19[i] = v29;
        w20[i] = v28;
        w4[i] = (v17 * v12) - (v5 * v18);
        w21[i] = v36;
        w22[i] = v36;
        w23[i] = v28;
        w24[i] = v29;
        w25[i] = v27;
        w26[i] = v26;
        w5[i] = (v7 - v6) * v40;
        w27[i] = -v40;
        w28[i] = v40;
    }
}

static void jacobian_7(int n, const double *p, const double *y, double *w, double *e)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
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
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    double *restrict each13 = w + (SCRATCH + 13 * FIBRES) * n;
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    double *restrict each16 = w + (SCRATCH + 16 * FIBRES) * n;
    double *restrict each17 = w + (SCRATCH + 17 * FIBRES) * n;
    const double c1 = p[6];
    const double c5 = p[8];
    const double c8 = p[10];
    const double c11 = p[12];
    const double c14 = p[14];
    const double c17 = p[16];
    const double c79 = 0.9 * c1;
    const double c82 = 2.0 * p[4];
    const double c83 = 2.0 + c82;
    const double c84 = c79 / c83;
    const double c87 = 0.9 * c5;
    const double c88 = c87 / c83;
    const double c91 = 0.9 * c8;
    const double c92 = c91 / c83;
    const double c95 = 0.9 * c11;
    const double c96 = c95 / c83;
    const double c99 = 0.9 * c14;
    const double c100 = c99 / c83;
    const double c103 = 0.9 * c17;
    const double c104 = c103 / c83;
    const double c123 = p[18];
    const double c124 = p[7];
    const double c125 = c1 / c124;
    const double c126 = c123 * c125;
    const double c127 = -c126;
    const double c132 = (-0.5) * p[1];
    const double c148 = 1.0 / c124;
    const double c166 = p[9];
    const double c167 = c5 / c166;
    const double c168 = c123 * c167;
    const double c169 = -c168;
    const double c171 = 1.0 / c166;
    const double c187 = p[11];
    const double c188 = c8 / c187;
    const double c189 = c123 * c188;
    const double c190 = -c189;
    const double c192 = 1.0 / c187;
    const double c208 = p[13];
    const double c209 = c11 / c208;
    const double c210 = c123 * c209;
    const double c211 = -c210;
    const double c213 = 1.0 / c208;
    const double c229 = p[15];
    const double c230 = c14 / c229;
    const double c231 = c123 * c230;
    const double c232 = -c231;
    const double c234 = 1.0 / c229;
    const double c250 = p[17];
    const double c251 = c17 / c250;
    const double c252 = c123 * c251;
    const double c253 = -c252;
    const double c255 = 1.0 / c250;
    const double c272 = 3.0 / c124;
    const double c288 = c272 * c84;
    const double c289 = c123 * c288;
    const double c290 = -c289;
    const double c303 = 3.0 / c166;
    const double c316 = c303 * c88;
    const double c317 = c123 * c316;
    const double c318 = -c317;
    const double c331 = 3.0 / c187;
    const double c344 = c331 * c92;
    const double c345 = c123 * c344;
    const double c346 = -c345;
    const double c359 = 3.0 / c208;
    const double c372 = c359 * c96;
    const double c373 = c123 * c372;
    const double c374 = -c373;
    const double c387 = 3.0 / c229;
    const double c400 = c387 * c100;
    const double c401 = c123 * c400;
    const double c402 = -c401;
    const double c415 = 3.0 / c250;
    const double c428 = c415 * c104;
    const double c429 = c123 * c428;
    const double c430 = -c429;
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
        const double v21 = w15[i];
        const double v24 = w27[i];
        const double v27 = w16[i];
        const double v29 = w28[i];
        const double v32 = w17[i];
        const double v34 = w18[i];
        const double v36 = w19[i];
        const double v38 = w20[i];
        const double v69 = w21[i];
        const double v74 = w22[i];
        const double v107 = w23[i];
        const double v111 = w24[i];
        const double v115 = w25[i];
        const double v119 = w26[i];
        const double v128 = w3[i];
        const double v129 = 1.0 / v128;
        const double v134 = c132 * w5[i];
        const double v136 = sqrt(v128);
        const double v138 = 1.0 / (v136 * v128);
        const double v142 = 1.0 / (2.0 * v136);
        const double v144 = (v128 * v142) + v136;
        const double v275 = c123 * (c272 * (c84 * v129));
        const double v278 = w4[i] * v129;
        const double v279 = v278 * v129;
        const double v282 = c123 * (c272 * (c84 * v279));
        const double v306 = c123 * (c303 * (c88 * v129));
        const double v310 = c123 * (c303 * (c88 * v279));
        const double v334 = c123 * (c331 * (c92 * v129));
        const double v338 = c123 * (c331 * (c92 * v279));
        const double v362 = c123 * (c359 * (c96 * v129));
        const double v366 = c123 * (c359 * (c96 * v279));
        const double v390 = c123 * (c387 * (c100 * v129));
        const double v394 = c123 * (c387 * (c100 * v279));
        const double v418 = c123 * (c415 * (c104 * v129));
        const double v422 = c123 * (c415 * (c104 * v279));
        const double v445 = log(v128);
        for (int k = 0; k < FIBRES; k++) {
            const double v2 = weight[k];
            const double v3 = c1 * v2;
            const double v6 = c5 * v2;
            const double v9 = c8 * v2;
            const double v12 = c11 * v2;
            const double v15 = c14 * v2;
            const double v18 = c17 * v2;
            const double v41 = zeta[k];
            const double v42 = v2 * v41;
            const double v43 = c1 * v42;
            const double v45 = c5 * v42;
            const double v47 = c8 * v42;
            const double v49 = c11 * v42;
            const double v51 = c14 * v42;
            const double v53 = c17 * v42;
            const double v85 = c84 * v2;
            const double v89 = c88 * v2;
            const double v93 = c92 * v2;
            const double v97 = c96 * v2;
            const double v101 = c100 * v2;
            const double v105 = c104 * v2;
            const double v139 = (v134 * v41) * v138;
            const double v140 = v139 * v138;
            const double v146 = v129 - (v140 * v144);
            const double v150 = c123 * ((c1 * v146) * c148);
            const double v153 = (v41 * c132) * v138;
            const double v156 = c123 * ((c1 * v153) * c148);
            const double v173 = c123 * ((c5 * v146) * c171);
            const double v177 = c123 * ((c5 * v153) * c171);
            const double v194 = c123 * ((c8 * v146) * c192);
            const double v198 = c123 * ((c8 * v153) * c192);
            const double v215 = c123 * ((c11 * v146) * c213);
            const double v219 = c123 * ((c11 * v153) * c213);
            const double v236 = c123 * ((c14 * v146) * c234);
            const double v240 = c123 * ((c14 * v153) * c234);
            const double v257 = c123 * ((c17 * v146) * c255);
            const double v261 = c123 * ((c17 * v153) * c255);
            const double v452 = (c1 * ((v139 - y[SLOTS * i + 5 + k]) + v445)) + (c5 * ((v139 - y[SLOTS * i + 5 + 1 * FIBRES + k]) + v445));
            const double v457 = v452 + (c8 * ((v139 - y[SLOTS * i + 5 + 2 * FIBRES + k]) + v445));
            const double v462 = v457 + (c11 * ((v139 - y[SLOTS * i + 5 + 3 * FIBRES + k]) + v445));
            const double v467 = v462 + (c14 * ((v139 - y[SLOTS * i + 5 + 4 * FIBRES + k]) + v445));
            const double v472 = v467 + (c17 * ((v139 - y[SLOTS * i + 5 + 5 * FIBRES + k]) + v445));
            const double v481 = (c84 * (v278 - y[SLOTS * i + 5 + 6 * FIBRES + k])) + (c88 * (v278 - y[SLOTS * i + 5 + 7 * FIBRES + k]));
            const double v489 = (v481 + (c92 * (v278 - y[SLOTS * i + 5 + 8 * FIBRES + k]))) + (c96 * (v278 - y[SLOTS * i + 5 + 9 * FIBRES + k]));
            const double v493 = v489 + (c100 * (v278 - y[SLOTS * i + 5 + 10 * FIBRES + k]));
            const double v497 = v493 + (c104 * (v278 - y[SLOTS * i + 5 + 11 * FIBRES + k]));
            const double v500 = v140 * v18;
            const double v507 = (((v18 * v129) - (v136 * v500)) - ((v128 * v500) * v142)) + (v15 * v129);
            const double v508 = v140 * v15;
            const double v515 = ((v507 - (v136 * v508)) - ((v128 * v508) * v142)) + (v12 * v129);
            const double v516 = v140 * v12;
            const double v523 = ((v515 - (v136 * v516)) - ((v128 * v516) * v142)) + (v9 * v129);
            const double v524 = v140 * v9;
            const double v531 = ((v523 - (v136 * v524)) - ((v128 * v524) * v142)) + (v6 * v129);
            const double v532 = v140 * v6;
            const double v539 = ((v531 - (v136 * v532)) - ((v128 * v532) * v142)) + (v3 * v129);
            const double v540 = v140 * v3;
            const double v552 = (c132 * (v41 * (v18 * v138))) + (c132 * (v41 * (v15 * v138)));
            const double v560 = (v552 + (c132 * (v41 * (v12 * v138)))) + (c132 * (v41 * (v9 * v138)));
            const double v568 = (v560 + (c132 * (v41 * (v6 * v138)))) + (c132 * (v41 * (v3 * v138)));
            const double v570 = v140 * v53;
            const double v577 = (((v53 * v129) - (v136 * v570)) - ((v128 * v570) * v142)) + (v51 * v129);
            const double v578 = v140 * v51;
            const double v585 = ((v577 - (v136 * v578)) - ((v128 * v578) * v142)) + (v49 * v129);
            const double v586 = v140 * v49;
            const double v593 = ((v585 - (v136 * v586)) - ((v128 * v586) * v142)) + (v47 * v129);
            const double v594 = v140 * v47;
            const double v601 = ((v593 - (v136 * v594)) - ((v128 * v594) * v142)) + (v45 * v129);
            const double v602 = v140 * v45;
            const double v609 = ((v601 - (v136 * v602)) - ((v128 * v602) * v142)) + (v43 * v129);
            const double v610 = v140 * v43;
            const double v622 = (c132 * (v41 * (v53 * v138))) + (c132 * (v41 * (v51 * v138)));
            const double v630 = (v622 + (c132 * (v41 * (v49 * v138)))) + (c132 * (v41 * (v47 * v138)));
            const double v638 = (v630 + (c132 * (v41 * (v45 * v138)))) + (c132 * (v41 * (v43 * v138)));
            const double v645 = (((v105 * v129) + (v101 * v129)) + (v97 * v129)) + (v93 * v129);
            const double v656 = (((v279 * v105) + (v279 * v101)) + (v279 * v97)) + (v279 * v93);
            each0[FIBRES * i + k] = -v3;
            each1[FIBRES * i + k] = -v6;
            each2[FIBRES * i + k] = -v9;
            each3[FIBRES * i + k] = -v12;
            each4[FIBRES * i + k] = -v15;
            each5[FIBRES * i + k] = -v18;
            each6[FIBRES * i + k] = -v43;
            each7[FIBRES * i + k] = -v45;
            each8[FIBRES * i + k] = -v47;
            each9[FIBRES * i + k] = -v49;
            each10[FIBRES * i + k] = -v51;
            each11[FIBRES * i + k] = -v53;
            each12[FIBRES * i + k] = -v85;
            each13[FIBRES * i + k] = -v89;
            each14[FIBRES * i + k] = -v93;
            each15[FIBRES * i + k] = -v97;
            each16[FIBRES * i + k] = -v101;
            each17[FIBRES * i + k] = -v105;
            e[ENTRIES * i + 29 + 75 * FIBRES + k] = c127;
            e[ENTRIES * i + 29 + 74 * FIBRES + k] = (v150 * v21) + (v156 * v24);
            e[ENTRIES * i + 29 + 78 * FIBRES + k] = (v150 * v27) + (v156 * v29);
            e[ENTRIES * i + 29 + 72 * FIBRES + k] = v150 * v32;
            e[ENTRIES * i + 29 + 76 * FIBRES + k] = v150 * v34;
            e[ENTRIES * i + 29 + 73 * FIBRES + k] = v150 * v36;
            e[ENTRIES * i + 29 + 77 * FIBRES + k] = v150 * v38;
            e[ENTRIES * i + 29 + 82 * FIBRES + k] = c169;
            e[ENTRIES * i + 29 + 81 * FIBRES + k] = (v173 * v21) + (v177 * v24);
            e[ENTRIES * i + 29 + 85 * FIBRES + k] = (v173 * v27) + (v177 * v29);
            e[ENTRIES * i + 29 + 79 * FIBRES + k] = v173 * v32;
            e[ENTRIES * i + 29 + 83 * FIBRES + k] = v173 * v34;
            e[ENTRIES * i + 29 + 80 * FIBRES + k] = v173 * v36;
            e[ENTRIES * i + 29 + 84 * FIBRES + k] = v173 * v38;
            e[ENTRIES * i + 29 + 89 * FIBRES + k] = c190;
            e[ENTRIES * i + 29 + 88 * FIBRES + k] = (v194 * v21) + (v198 * v24);
            e[ENTRIES * i + 29 + 92 * FIBRES + k] = (v194 * v27) + (v198 * v29);
            e[ENTRIES * i + 29 + 86 * FIBRES + k] = v194 * v32;
            e[ENTRIES * i + 29 + 90 * FIBRES + k] = v194 * v34;
            e[ENTRIES * i + 29 + 87 * FIBRES + k] = v194 * v36;
            e[ENTRIES * i + 29 + 91 * FIBRES + k] = v194 * v38;
            e[ENTRIES * i + 29 + 96 * FIBRES + k] = c211;
            e[ENTRIES * i + 29 + 95 * FIBRES + k] = (v215 * v21) + (v219 * v24);
            e[ENTRIES * i + 29 + 99 * FIBRES + k] = (v215 * v27) + (v219 * v29);
            e[ENTRIES * i + 29 + 93 * FIBRES + k] = v215 * v32;
            e[ENTRIES * i + 29 + 97 * FIBRES + k] = v215 * v34;
            e[ENTRIES * i + 29 + 94 * FIBRES + k] = v215 * v36;
            e[ENTRIES * i + 29 + 98 * FIBRES + k] = v215 * v38;
            e[ENTRIES * i + 29 + 103 * FIBRES + k] = c232;
            e[ENTRIES * i + 29 + 102 * FIBRES + k] = (v236 * v21) + (v240 * v24);
            e[ENTRIES * i + 29 + 106 * FIBRES + k] = (v236 * v27) + (v240 * v29);
            e[ENTRIES * i + 29 + 100 * FIBRES + k] = v236 * v32;
            e[ENTRIES * i + 29 + 104 * FIBRES + k] = v236 * v34;
            e[ENTRIES * i + 29 + 101 * FIBRES + k] = v236 * v36;
            e[ENTRIES * i + 29 + 105 * FIBRES + k] = v236 * v38;
            e[ENTRIES * i + 29 + 110 * FIBRES + k] = c253;
            e[ENTRIES * i + 29 + 109 * FIBRES + k] = (v257 * v21) + (v261 * v24);
            e[ENTRIES * i + 29 + 113 * FIBRES + k] = (v257 * v27) + (v261 * v29);
            e[ENTRIES * i + 29 + 107 * FIBRES + k] = v257 * v32;
            e[ENTRIES * i + 29 + 111 * FIBRES + k] = v257 * v34;
            e[ENTRIES * i + 29 + 108 * FIBRES + k] = v257 * v36;
            e[ENTRIES * i + 29 + 112 * FIBRES + k] = v257 * v38;
            e[ENTRIES * i + 29 + 116 * FIBRES + k] = (v275 * v69) - (v282 * v21);
            e[ENTRIES * i + 29 + 120 * FIBRES + k] = (v275 * v74) - (v282 * v27);
            e[ENTRIES * i + 29 + 117 * FIBRES + k] = c290;
            e[ENTRIES * i + 29 + 114 * FIBRES + k] = (v275 * v107) - (v282 * v32);
            e[ENTRIES * i + 29 + 118 * FIBRES + k] = (v275 * v111) - (v282 * v34);
            e[ENTRIES * i + 29 + 115 * FIBRES + k] = (v275 * v115) - (v282 * v36);
            e[ENTRIES * i + 29 + 119 * FIBRES + k] = (v275 * v119) - (v282 * v38);
            e[ENTRIES * i + 29 + 123 * FIBRES + k] = (v306 * v69) - (v310 * v21);
            e[ENTRIES * i + 29 + 127 * FIBRES + k] = (v306 * v74) - (v310 * v27);
            e[ENTRIES * i + 29 + 124 * FIBRES + k] = c318;
            e[ENTRIES * i + 29 + 121 * FIBRES + k] = (v306 * v107) - (v310 * v32);
            e[ENTRIES * i + 29 + 125 * FIBRES + k] = (v306 * v111) - (v310 * v34);
            e[ENTRIES * i + 29 + 122 * FIBRES + k] = (v306 * v115) - (v310 * v36);
            e[ENTRIES * i + 29 + 126 * FIBRES + k] = (v306 * v119) - (v310 * v38);
            e[ENTRIES * i + 29 + 130 * FIBRES + k] = (v334 * v69) - (v338 * v21);
            e[ENTRIES * i + 29 + 134 * FIBRES + k] = (v334 * v74) - (v338 * v27);
            e[ENTRIES * i + 29 + 131 * FIBRES + k] = c346;
            e[ENTRIES * i + 29 + 128 * FIBRES + k] = (v334 * v107) - (v338 * v32);
            e[ENTRIES * i + 29 + 132 * FIBRES + k] = (v334 * v111) - (v338 * v34);
            e[ENTRIES * i + 29 + 129 * FIBRES + k] = (v334 * v115) - (v338 * v36);
            e[ENTRIES * i + 29 + 133 * FIBRES + k] = (v334 * v119) - (v338 * v38);
            e[ENTRIES * i + 29 + 137 * FIBRES + k] = (v362 * v69) - (v366 * v21);
            e[ENTRIES * i + 29 + 141 * FIBRES + k] = (v362 * v74) - (v366 * v27);
            e[ENTRIES * i + 29 + 138 * FIBRES + k] = c374;
            e[ENTRIES * i + 29 + 135 * FIBRES + k] = (v362 * v107) - (v366 * v32);
            e[ENTRIES * i + 29 + 139 * FIBRES + k] = (v362 * v111) - (v366 * v34);
            e[ENTRIES * i + 29 + 136 * FIBRES + k] = (v362 * v115) - (v366 * v36);
            e[ENTRIES * i + 29 + 140 * FIBRES + k] = (v362 * v119) - (v366 * v38);
            e[ENTRIES * i + 29 + 144 * FIBRES + k] = (v390 * v69) - (v394 * v21);
            e[ENTRIES * i + 29 + 148 * FIBRES + k] = (v390 * v74) - (v394 * v27);
            e[ENTRIES * i + 29 + 145 * FIBRES + k] = c402;
            e[ENTRIES * i + 29 + 142 * FIBRES + k] = (v390 * v107) - (v394 * v32);
            e[ENTRIES * i + 29 + 146 * FIBRES + k] = (v390 * v111) - (v394 * v34);
            e[ENTRIES * i + 29 + 143 * FIBRES + k] = (v390 * v115) - (v394 * v36);
            e[ENTRIES * i + 29 + 147 * FIBRES + k] = (v390 * v119) - (v394 * v38);
            e[ENTRIES * i + 29 + 151 * FIBRES + k] = (v418 * v69) - (v422 * v21);
            e[ENTRIES * i + 29 + 155 * FIBRES + k] = (v418 * v74) - (v422 * v27);
            e[ENTRIES * i + 29 + 152 * FIBRES + k] = c430;
            e[ENTRIES * i + 29 + 149 * FIBRES + k] = (v418 * v107) - (v422 * v32);
            e[ENTRIES * i + 29 + 153 * FIBRES + k] = (v418 * v111) - (v422 * v34);
            e[ENTRIES * i + 29 + 150 * FIBRES + k] = (v418 * v115) - (v422 * v36);
            e[ENTRIES * i + 29 + 154 * FIBRES + k] = (v418 * v119) - (v422 * v38);
            sum0 += v472 * v2;
            sum1 += v472 * v42;
            sum2 += v497 * v2;
            sum3 += (v539 - (v136 * v540)) - ((v128 * v540) * v142);
            sum4 += v568;
            sum5 += (v609 - (v136 * v610)) - ((v128 * v610) * v142);
            sum6 += v638;
            sum7 += (v645 + (v89 * v129)) + (v85 * v129);
            sum8 += -((v656 + (v279 * v89)) + (v279 * v85));
        }
        const double v20 = sum3;
        const double v23 = sum4;
        const double v55 = sum5;
        const double v57 = sum6;
        const double v68 = sum7;
        const double v71 = sum8;
        w6[i] = sum0;
        w29[i] = (v20 * v21) + (v23 * v24);
        w30[i] = (v20 * v27) + (v23 * v29);
        w31[i] = v20 * v32;
        w32[i] = v20 * v34;
        w33[i] = v20 * v36;
        w34[i] = v20 * v38;
        w7[i] = sum1;
        w35[i] = (v55 * v21) + (v57 * v24);
        w36[i] = (v55 * v27) + (v57 * v29);
        w37[i] = v55 * v32;
        w38[i] = v55 * v34;
        w39[i] = v55 * v36;
        w40[i] = v55 * v38;
        w8[i] = sum2;
        w41[i] = (v68 * v69) + (v71 * v21);
        w42[i] = (v68 * v74) + (v71 * v27);
        w43[i] = (v68 * v107) + (v71 * v32);
        w44[i] = (v68 * v111) + (v71 * v34);
        w45[i] = (v68 * v115) + (v71 * v36);
        w46[i] = (v68 * v119) + (v71 * v38);
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
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
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
    double *restrict each21 = w + (SCRATCH + 21 * FIBRES) * n;
    double *restrict each22 = w + (SCRATCH + 22 * FIBRES) * n;
    double *restrict each23 = w + (SCRATCH + 23 * FIBRES) * n;
    double *restrict each24 = w + (SCRATCH + 24 * FIBRES) * n;
    double *restrict each25 = w + (SCRATCH + 25 * FIBRES) * n;
    double *restrict each26 = w + (SCRATCH + 26 * FIBRES) * n;
    double *restrict each27 = w + (SCRATCH + 27 * FIBRES) * n;
    double *restrict each28 = w + (SCRATCH + 28 * FIBRES) * n;
    double *restrict each29 = w + (SCRATCH + 29 * FIBRES) * n;
    double *restrict each30 = w + (SCRATCH + 30 * FIBRES) * n;
    double *restrict each31 = w + (SCRATCH + 31 * FIBRES) * n;
    double *restrict each32 = w + (SCRATCH + 32 * FIBRES) * n;
    double *restrict each33 = w + (SCRATCH + 33 * FIBRES) * n;
    double *restrict each34 = w + (SCRATCH + 34 * FIBRES) * n;
    double *restrict each35 = w + (SCRATCH + 35 * FIBRES) * n;
    double *restrict each36 = w + (SCRATCH + 36 * FIBRES) * n;
    double *restrict each37 = w + (SCRATCH + 37 * FIBRES) * n;
    double *restrict each38 = w + (SCRATCH + 38 * FIBRES) * n;
    double *restrict each39 = w + (SCRATCH + 39 * FIBRES) * n;
    double *restrict each40 = w + (SCRATCH + 40 * FIBRES) * n;
    double *restrict each41 = w + (SCRATCH + 41 * FIBRES) * n;
    double *restrict each42 = w + (SCRATCH + 42 * FIBRES) * n;
    double *restrict each43 = w + (SCRATCH + 43 * FIBRES) * n;
    double *restrict each44 = w + (SCRATCH + 44 * FIBRES) * n;
    double *restrict each45 = w + (SCRATCH + 45 * FIBRES) * n;
    double *restrict each46 = w + (SCRATCH + 46 * FIBRES) * n;
    double *restrict each47 = w + (SCRATCH + 47 * FIBRES) * n;
    double *restrict each48 = w + (SCRATCH + 48 * FIBRES) * n;
    double *restrict each49 = w + (SCRATCH + 49 * FIBRES) * n;
    double *restrict each50 = w + (SCRATCH + 50 * FIBRES) * n;
    double *restrict each51 = w + (SCRATCH + 51 * FIBRES) * n;
    double *restrict each52 = w + (SCRATCH + 52 * FIBRES) * n;
    double *restrict each53 = w + (SCRATCH + 53 * FIBRES) * n;
    double *restrict each54 = w + (SCRATCH + 54 * FIBRES) * n;
    double *restrict each55 = w + (SCRATCH + 55 * FIBRES) * n;
    double *restrict each56 = w + (SCRATCH + 56 * FIBRES) * n;
    double *restrict each57 = w + (SCRATCH + 57 * FIBRES) * n;
    double *restrict each58 = w + (SCRATCH + 58 * FIBRES) * n;
    double *restrict each59 = w + (SCRATCH + 59 * FIBRES) * n;
    double *restrict each60 = w + (SCRATCH + 60 * FIBRES) * n;
    double *restrict each61 = w + (SCRATCH + 61 * FIBRES) * n;
    double *restrict each62 = w + (SCRATCH + 62 * FIBRES) * n;
    double *restrict each63 = w + (SCRATCH + 63 * FIBRES) * n;
    double *restrict each64 = w + (SCRATCH + 64 * FIBRES) * n;
    double *restrict each65 = w + (SCRATCH + 65 * FIBRES) * n;
    double *restrict each66 = w + (SCRATCH + 66 * FIBRES) * n;
    double *restrict each67 = w + (SCRATCH + 67 * FIBRES) * n;
    double *restrict each68 = w + (SCRATCH + 68 * FIBRES) * n;
    double *restrict each69 = w + (SCRATCH + 69 * FIBRES) * n;
    double *restrict each70 = w + (SCRATCH + 70 * FIBRES) * n;
    double *restrict each71 = w + (SCRATCH + 71 * FIBRES) * n;
    double *restrict each72 = w + (SCRATCH + 72 * FIBRES) * n;
    double *restrict each73 = w + (SCRATCH + 73 * FIBRES) * n;
    double *restrict each74 = w + (SCRATCH + 74 * FIBRES) * n;
    double *restrict each75 = w + (SCRATCH + 75 * FIBRES) * n;
    double *restrict each76 = w + (SCRATCH + 76 * FIBRES) * n;
    double *restrict each77 = w + (SCRATCH + 77 * FIBRES) * n;
    double *restrict each78 = w + (SCRATCH + 78 * FIBRES) * n;
    double *restrict each79 = w + (SCRATCH + 79 * FIBRES) * n;
    double *restrict each80 = w + (SCRATCH + 80 * FIBRES) * n;
    double *restrict each81 = w + (SCRATCH + 81 * FIBRES) * n;
    double *restrict each82 = w + (SCRATCH + 82 * FIBRES) * n;
    double *restrict each83 = w + (SCRATCH + 83 * FIBRES) * n;
    const double c12 = p[1];
    const double c13 = 0.5 * c12;
    const double c312 = p[5] / c12;
    const double c313 = 2.0 * c312;
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v3 = w6[i] * v2;
        const double v4 = w4[i];
        const double v5 = w8[i];
        const double v6 = v5 * v2;
        const double v8 = (v4 * v6) * v2;
        const double v16 = sqrt(v1);
        const double v18 = 1.0 / (v16 * v1);
        const double v19 = (c13 * w7[i]) * v18;
        const double v20 = 1.5 * v19;
        const double v21 = w5[i];
        const double v23 = (v20 * v21) * v2;
        const double v24 = (v3 - v8) + v23;
        const double v29 = (w1[i] + w1[i + 1]) * 0.5;
        const double v30 = cos(v29);
        const double v32 = sin(v29);
        const double v34 = (v24 * v30) - (v6 * v32);
        const double v35 = v30 * v2;
        const double v38 = c13 * v18;
        const double v41 = (v21 * (1.5 * v38)) * v2;
        const double v42 = v30 * v41;
        const double v71 = v6 * v2;
        const double v72 = v4 * v71;
        const double v82 = (v19 * v18) * ((v1 / (2.0 * v16)) + v16);
        const double v88 = (((v72 * v2) + (v8 * v2)) - (v3 * v2)) - (((v21 * (1.5 * v82)) * v2) + (v23 * v2));
        const double v90 = v32 * v71;
        const double v91 = (v30 * v88) + v90;
        const double v92 = w15[i];
        const double v94 = v30 * v71;
        const double v95 = w21[i];
        const double v98 = w29[i];
        const double v101 = w35[i];
        const double v103 = (((v91 * v92) - (v94 * v95)) + (v35 * v98)) + (v42 * v101);
        const double v104 = v20 * v2;
        const double v105 = v30 * v104;
        const double v106 = w27[i];
        const double v109 = 0.5 * v32;
        const double v111 = 0.5 * v30;
        const double v113 = (v24 * v109) + (v6 * v111);
        const double v115 = v4 * v2;
        const double v116 = v115 * v2;
        const double v118 = v32 * v2;
        const double v119 = (v30 * v116) + v118;
        const double v120 = w41[i];
        const double v122 = ((v103 + (v105 * v106)) - v113) - (v119 * v120);
        const double v123 = w16[i];
        const double v125 = w22[i];
        const double v128 = w30[i];
        const double v131 = w36[i];
        const double v133 = (((v91 * v123) - (v94 * v125)) + (v35 * v128)) + (v42 * v131);
        const double v134 = w28[i];
        const double v138 = w42[i];
        const double v140 = ((v133 + (v105 * v134)) - v113) - (v119 * v138);
        const double v159 = w17[i];
        const double v161 = w23[i];
        const double v164 = w31[i];
        const double v167 = w37[i];
        const double v169 = (((v91 * v159) - (v94 * v161)) + (v35 * v164)) + (v42 * v167);
        const double v170 = w43[i];
        const double v172 = v169 - (v119 * v170);
        const double v173 = w18[i];
        const double v175 = w24[i];
        const double v178 = w32[i];
        const double v181 = w38[i];
        const double v183 = (((v91 * v173) - (v94 * v175)) + (v35 * v178)) + (v42 * v181);
        const double v184 = w44[i];
        const double v186 = v183 - (v119 * v184);
        const double v187 = w19[i];
        const double v189 = w25[i];
        const double v192 = w33[i];
        const double v195 = w39[i];
        const double v197 = (((v91 * v187) - (v94 * v189)) + (v35 * v192)) + (v42 * v195);
        const double v198 = w45[i];
        const double v200 = v197 - (v119 * v198);
        const double v201 = w20[i];
        const double v203 = w26[i];
        const double v206 = w34[i];
        const double v209 = w40[i];
        const double v211 = (((v91 * v201) - (v94 * v203)) + (v35 * v206)) + (v42 * v209);
        const double v212 = w46[i];
        const double v214 = v211 - (v119 * v212);
        const double v217 = (v24 * v32) + (v6 * v30);
        const double v219 = v32 * v41;
        const double v238 = (v32 * v88) - v94;
        const double v245 = (((v238 * v92) - (v90 * v95)) + (v118 * v98)) + (v219 * v101);
        const double v246 = v32 * v104;
        const double v251 = (v24 * v111) - (v6 * v109);
        const double v254 = v35 - (v32 * v116);
        const double v256 = ((v245 + (v246 * v106)) + v251) + (v254 * v120);
        const double v263 = (((v238 * v123) - (v90 * v125)) + (v118 * v128)) + (v219 * v131);
        const double v268 = ((v263 + (v246 * v134)) + v251) + (v254 * v138);
        const double v281 = (((v238 * v159) - (v90 * v161)) + (v118 * v164)) + (v219 * v167);
        const double v283 = v281 + (v254 * v170);
        const double v290 = (((v238 * v173) - (v90 * v175)) + (v118 * v178)) + (v219 * v181);
        const double v292 = v290 + (v254 * v184);
        const double v299 = (((v238 * v187) - (v90 * v189)) + (v118 * v192)) + (v219 * v195);
        const double v301 = v299 + (v254 * v198);
        const double v308 = (((v238 * v201) - (v90 * v203)) + (v118 * v206)) + (v219 * v209);
        const double v310 = v308 + (v254 * v212);
        const double v318 = g[7 * i + 4];
        const double v319 = (w0[i + 1] - w0[i]) * v318;
        const double v324 = (w2[i + 1] - w2[i]) * v318;
        const double v327 = sqrt(squared(v319) + squared(v324));
        const double v328 = sqrt(v327);
        const double v329 = 1.0 / v328;
        const double v330 = c313 * v329;
        const double v331 = 1.0 / v327;
        const double v332 = v330 * v331;
        const double v335 = v330 * v329;
        const double v339 = 1.0 / (2.0 * v327);
        const double v340 = ((2.0 * v319) * v318) * v339;
        const double v342 = 1.0 / (2.0 * v328);
        const double v346 = v332 * v331;
        const double v348 = ((v335 * (v340 * v342)) * v331) + (v346 * v340);
        const double v349 = v319 * v348;
        const double v350 = v332 * v318;
        const double v357 = ((2.0 * v324) * v318) * v339;
        const double v362 = ((v335 * (v357 * v342)) * v331) + (v346 * v357);
        const double v363 = v319 * v362;
        const double v368 = v324 * v348;
        const double v371 = v324 * v362;
        const double v377 = g[7 * i + 1] * p[0];
        const double v383 = 0.5 * (v377 * v115);
        const double v387 = 0.5 * (v377 * (v4 * v41));
        const double v415 = 0.5 * (v377 * (1.0 + (v4 * v116)));
        const double v419 = 0.5 * (v377 * (v24 - v72));
        const double v423 = 0.5 * (v377 * (v4 * v88));
        const double v429 = (((v419 * v95) + (v423 * v92)) + (v383 * v98)) + (v387 * v101);
        const double v432 = 0.5 * (v377 * (v4 * v104));
        const double v443 = (((v419 * v125) + (v423 * v123)) + (v383 * v128)) + (v387 * v131);
        const double v460 = (((v419 * v161) + (v423 * v159)) + (v383 * v164)) + (v387 * v167);
        const double v469 = (((v419 * v175) + (v423 * v173)) + (v383 * v178)) + (v387 * v181);
        const double v478 = (((v419 * v189) + (v423 * v187)) + (v383 * v192)) + (v387 * v195);
        const double v487 = (((v419 * v203) + (v423 * v201)) + (v383 * v206)) + (v387 * v209);
        w9[i] = v34;
        w47[i] = v122;
        w48[i] = v140;
        w49[i] = v172;
        w50[i] = v186;
        w51[i] = v200;
        w52[i] = v214;
        w10[i] = v217;
        w53[i] = v256;
        w54[i] = v268;
        w55[i] = v283;
        w56[i] = v292;
        w57[i] = v301;
        w58[i] = v310;
        w11[i] = v34 + (v332 * v319);
        w59[i] = v122;
        w60[i] = v140;
        w61[i] = v172 + (v349 - v350);
        w62[i] = v186 + (v350 - v349);
        w63[i] = v200 + v363;
        w64[i] = v214 - v363;
        w12[i] = v217 + (v332 * v324);
        w65[i] = v256;
        w66[i] = v268;
        w67[i] = v283 + v368;
        w68[i] = v292 - v368;
        w69[i] = v301 + (v371 - v350);
        w70[i] = v310 + (v350 - v371);
        w13[i] = (v377 * (v5 - (v4 * v24))) * 0.5;
        w71[i] = (v415 * v120) - (v429 + (v432 * v106));
        w72[i] = (v415 * v138) - (v443 + (v432 * v134));
        w73[i] = (v415 * v170) - v460;
        w74[i] = (v415 * v184) - v469;
        w75[i] = (v415 * v198) - v478;
        w76[i] = (v415 * v212) - v487;
        w14[i] = -v19;
        w77[i] = (v82 * v92) - (v38 * v101);
        w78[i] = (v82 * v123) - (v38 * v131);
        w79[i] = (v82 * v159) - (v38 * v167);
        w80[i] = (v82 * v173) - (v38 * v181);
        w81[i] = (v82 * v187) - (v38 * v195);
        w82[i] = (v82 * v201) - (v38 * v209);
        for (int k = 0; k < FIBRES; k++) {
            const double v36 = each0[FIBRES * i + k];
            const double v43 = each6[FIBRES * i + k];
            const double v45 = (v35 * v36) + (v42 * v43);
            const double v46 = each1[FIBRES * i + k];
            const double v48 = each7[FIBRES * i + k];
            const double v50 = (v35 * v46) + (v42 * v48);
            const double v51 = each2[FIBRES * i + k];
            const double v53 = each8[FIBRES * i + k];
            const double v55 = (v35 * v51) + (v42 * v53);
            const double v56 = each3[FIBRES * i + k];
            const double v58 = each9[FIBRES * i + k];
            const double v60 = (v35 * v56) + (v42 * v58);
            const double v61 = each4[FIBRES * i + k];
            const double v63 = each10[FIBRES * i + k];
            const double v65 = (v35 * v61) + (v42 * v63);
            const double v66 = each5[FIBRES * i + k];
            const double v68 = each11[FIBRES * i + k];
            const double v70 = (v35 * v66) + (v42 * v68);
            const double v141 = each12[FIBRES * i + k];
            const double v143 = -(v119 * v141);
            const double v144 = each13[FIBRES * i + k];
            const double v146 = -(v119 * v144);
            const double v147 = each14[FIBRES * i + k];
            const double v149 = -(v119 * v147);
            const double v150 = each15[FIBRES * i + k];
            const double v152 = -(v119 * v150);
            const double v153 = each16[FIBRES * i + k];
            const double v155 = -(v119 * v153);
            const double v156 = each17[FIBRES * i + k];
            const double v158 = -(v119 * v156);
            const double v221 = (v118 * v36) + (v219 * v43);
            const double v224 = (v118 * v46) + (v219 * v48);
            const double v227 = (v118 * v51) + (v219 * v53);
            const double v230 = (v118 * v56) + (v219 * v58);
            const double v233 = (v118 * v61) + (v219 * v63);
            const double v236 = (v118 * v66) + (v219 * v68);
            const double v269 = v254 * v141;
            const double v270 = v254 * v144;
            const double v271 = v254 * v147;
            const double v272 = v254 * v150;
            const double v273 = v254 * v153;
            const double v274 = v254 * v156;
            each18[FIBRES * i + k] = v45;
            each19[FIBRES * i + k] = v50;
            each20[FIBRES * i + k] = v55;
            each21[FIBRES * i + k] = v60;
            each22[FIBRES * i + k] = v65;
            each23[FIBRES * i + k] = v70;
            each24[FIBRES * i + k] = v143;
            each25[FIBRES * i + k] = v146;
            each26[FIBRES * i + k] = v149;
            each27[FIBRES * i + k] = v152;
            each28[FIBRES * i + k] = v155;
            each29[FIBRES * i + k] = v158;
            each30[FIBRES * i + k] = v221;
            each31[FIBRES * i + k] = v224;
            each32[FIBRES * i + k] = v227;
            each33[FIBRES * i + k] = v230;
            each34[FIBRES * i + k] = v233;
            each35[FIBRES * i + k] = v236;
            each36[FIBRES * i + k] = v269;
            each37[FIBRES * i + k] = v270;
            each38[FIBRES * i + k] = v271;
            each39[FIBRES * i + k] = v272;
            each40[FIBRES * i + k] = v273;
            each41[FIBRES * i + k] = v274;
            each42[FIBRES * i + k] = v45;
            each43[FIBRES * i + k] = v50;
            each44[FIBRES * i + k] = v55;
            each45[FIBRES * i + k] = v60;
            each46[FIBRES * i + k] = v65;
            each47[FIBRES * i + k] = v70;
            each48[FIBRES * i + k] = v143;
            each49[FIBRES * i + k] = v146;
            each50[FIBRES * i + k] = v149;
            each51[FIBRES * i + k] = v152;
            each52[FIBRES * i + k] = v155;
            each53[FIBRES * i + k] = v158;
            each54[FIBRES * i + k] = v221;
            each55[FIBRES * i + k] = v224;
            each56[FIBRES * i + k] = v227;
            each57[FIBRES * i + k] = v230;
            each58[FIBRES * i + k] = v233;
            each59[FIBRES * i + k] = v236;
            each60[FIBRES * i + k] = v269;
            each61[FIBRES * i + k] = v270;
            each62[FIBRES * i + k] = v271;
            each63[FIBRES * i + k] = v272;
            each64[FIBRES * i + k] = v273;
            each65[FIBRES * i + k] = v274;
            each66[FIBRES * i + k] = -((v383 * v36) + (v387 * v43));
            each67[FIBRES * i + k] = -((v383 * v46) + (v387 * v48));
            each68[FIBRES * i + k] = -((v383 * v51) + (v387 * v53));
            each69[FIBRES * i + k] = -((v383 * v56) + (v387 * v58));
            each70[FIBRES * i + k] = -((v383 * v61) + (v387 * v63));
            each71[FIBRES * i + k] = -((v383 * v66) + (v387 * v68));
            each72[FIBRES * i + k] = v415 * v141;
            each73[FIBRES * i + k] = v415 * v144;
            each74[FIBRES * i + k] = v415 * v147;
            each75[FIBRES * i + k] = v415 * v150;
            each76[FIBRES * i + k] = v415 * v153;
            each77[FIBRES * i + k] = v415 * v156;
            each78[FIBRES * i + k] = -(v38 * v43);
            each79[FIBRES * i + k] = -(v38 * v48);
            each80[FIBRES * i + k] = -(v38 * v53);
            each81[FIBRES * i + k] = -(v38 * v58);
            each82[FIBRES * i + k] = -(v38 * v63);
            each83[FIBRES * i + k] = -(v38 * v68);
        }
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w59 = w + 59 * n;
    double *restrict w60 = w + 60 * n;
    double *restrict w61 = w + 61 * n;
    double *restrict w62 = w + 62 * n;
    double *restrict w63 = w + 63 * n;
    double *restrict w64 = w + 64 * n;
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
    double *restrict each42 = w + (SCRATCH + 42 * FIBRES) * n;
    double *restrict each43 = w + (SCRATCH + 43 * FIBRES) * n;
    double *restrict each44 = w + (SCRATCH + 44 * FIBRES) * n;
    double *restrict each45 = w + (SCRATCH + 45 * FIBRES) * n;
    double *restrict each46 = w + (SCRATCH + 46 * FIBRES) * n;
    double *restrict each47 = w + (SCRATCH + 47 * FIBRES) * n;
    double *restrict each48 = w + (SCRATCH + 48 * FIBRES) * n;
    double *restrict each49 = w + (SCRATCH + 49 * FIBRES) * n;
    double *restrict each50 = w + (SCRATCH + 50 * FIBRES) * n;
    double *restrict each51 = w + (SCRATCH + 51 * FIBRES) * n;
    double *restrict each52 = w + (SCRATCH + 52 * FIBRES) * n;
    double *restrict each53 = w + (SCRATCH + 53 * FIBRES) * n;
    double *restrict each66 = w + (SCRATCH + 66 * FIBRES) * n;
    double *restrict each67 = w + (SCRATCH + 67 * FIBRES) * n;
    double *restrict each68 = w + (SCRATCH + 68 * FIBRES) * n;
    double *restrict each69 = w + (SCRATCH + 69 * FIBRES) * n;
    double *restrict each70 = w + (SCRATCH + 70 * FIBRES) * n;
    double *restrict each71 = w + (SCRATCH + 71 * FIBRES) * n;
    double *restrict each72 = w + (SCRATCH + 72 * FIBRES) * n;
    double *restrict each73 = w + (SCRATCH + 73 * FIBRES) * n;
    double *restrict each74 = w + (SCRATCH + 74 * FIBRES) * n;
    double *restrict each75 = w + (SCRATCH + 75 * FIBRES) * n;
    double *restrict each76 = w + (SCRATCH + 76 * FIBRES) * n;
    double *restrict each77 = w + (SCRATCH + 77 * FIBRES) * n;
    double *restrict each78 = w + (SCRATCH + 78 * FIBRES) * n;
    double *restrict each79 = w + (SCRATCH + 79 * FIBRES) * n;
    double *restrict each80 = w + (SCRATCH + 80 * FIBRES) * n;
    double *restrict each81 = w + (SCRATCH + 81 * FIBRES) * n;
    double *restrict each82 = w + (SCRATCH + 82 * FIBRES) * n;
    double *restrict each83 = w + (SCRATCH + 83 * FIBRES) * n;
    const double c1 = squared(p[18]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c101 = 0.0625 * c4;
    const double c103 = squared(p[1]);
    const double c104 = c101 * c103;
    const double c105 = c104 * c2;
    const double c106 = c1 / c105;
    const double c110 = squared(c2);
    const double c111 = c4 * c110;
    const double c112 = c104 / c111;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v113 = (c106 * g[7 * i + 5]) * c112;
        const double v186 = ((v113 * w77[i]) - (v113 * w78[i - 1])) + (v113 * w72[i - 1]);
        const double v231 = ((v113 * w79[i]) - (v113 * w80[i - 1])) + (v113 * w74[i - 1]);
        const double v252 = ((v113 * w81[i]) - (v113 * w82[i - 1])) + (v113 * w76[i - 1]);
        e[ENTRIES * i + 4] = -(v9 * w59[i - 1]);
        e[ENTRIES * i + 7] = (v9 * w59[i]) - (v9 * w60[i - 1]);
        e[ENTRIES * i + 10] = v9 * w60[i];
        e[ENTRIES * i + 2] = -(v9 * w61[i - 1]);
        e[ENTRIES * i + 5] = (v9 * w61[i]) - (v9 * w62[i - 1]);
        e[ENTRIES * i + 8] = v9 * w62[i];
        e[ENTRIES * i + 3] = -(v9 * w63[i - 1]);
        e[ENTRIES * i + 6] = (v9 * w63[i]) - (v9 * w64[i - 1]);
        e[ENTRIES * i + 9] = v9 * w64[i];
        e[ENTRIES * i + 22] = (v113 * w71[i - 1]) - (v113 * w77[i - 1]);
        e[ENTRIES * i + 25] = v186 + (v113 * w71[i]);
        e[ENTRIES * i + 28] = (v113 * w78[i]) + (v113 * w72[i]);
        e[ENTRIES * i + 20] = (v113 * w73[i - 1]) - (v113 * w79[i - 1]);
        e[ENTRIES * i + 23] = v231 + (v113 * w73[i]);
        e[ENTRIES * i + 26] = (v113 * w80[i]) + (v113 * w74[i]);
        e[ENTRIES * i + 21] = (v113 * w75[i - 1]) - (v113 * w81[i - 1]);
        e[ENTRIES * i + 24] = v252 + (v113 * w75[i]);
        e[ENTRIES * i + 27] = (v113 * w82[i]) + (v113 * w76[i]);
        for (int k = 0; k < FIBRES; k++) {
            const double v118 = (v113 * each66[FIBRES * (i - 1) + k]) - (v113 * each78[FIBRES * (i - 1) + k]);
            const double v123 = (v113 * each78[FIBRES * i + k]) + (v113 * each66[FIBRES * i + k]);
            const double v128 = (v113 * each67[FIBRES * (i - 1) + k]) - (v113 * each79[FIBRES * (i - 1) + k]);
            const double v133 = (v113 * each79[FIBRES * i + k]) + (v113 * each67[FIBRES * i + k]);
            const double v138 = (v113 * each68[FIBRES * (i - 1) + k]) - (v113 * each80[FIBRES * (i - 1) + k]);
            const double v143 = (v113 * each80[FIBRES * i + k]) + (v113 * each68[FIBRES * i + k]);
            const double v148 = (v113 * each69[FIBRES * (i - 1) + k]) - (v113 * each81[FIBRES * (i - 1) + k]);
            const double v153 = (v113 * each81[FIBRES * i + k]) + (v113 * each69[FIBRES * i + k]);
            const double v158 = (v113 * each70[FIBRES * (i - 1) + k]) - (v113 * each82[FIBRES * (i - 1) + k]);
            const double v163 = (v113 * each82[FIBRES * i + k]) + (v113 * each70[FIBRES * i + k]);
            const double v168 = (v113 * each71[FIBRES * (i - 1) + k]) - (v113 * each83[FIBRES * (i - 1) + k]);
            const double v173 = (v113 * each83[FIBRES * i + k]) + (v113 * each71[FIBRES * i + k]);
            e[ENTRIES * i + 29 + k] = -(v9 * each42[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 12 * FIBRES + k] = v9 * each42[FIBRES * i + k];
            e[ENTRIES * i + 29 + 1 * FIBRES + k] = -(v9 * each43[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 13 * FIBRES + k] = v9 * each43[FIBRES * i + k];
            e[ENTRIES * i + 29 + 2 * FIBRES + k] = -(v9 * each44[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 14 * FIBRES + k] = v9 * each44[FIBRES * i + k];
            e[ENTRIES * i + 29 + 3 * FIBRES + k] = -(v9 * each45[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 15 * FIBRES + k] = v9 * each45[FIBRES * i + k];
            e[ENTRIES * i + 29 + 4 * FIBRES + k] = -(v9 * each46[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 16 * FIBRES + k] = v9 * each46[FIBRES * i + k];
            e[ENTRIES * i + 29 + 5 * FIBRES + k] = -(v9 * each47[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 17 * FIBRES + k] = v9 * each47[FIBRES * i + k];
            e[ENTRIES * i + 29 + 6 * FIBRES + k] = -(v9 * each48[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 18 * FIBRES + k] = v9 * each48[FIBRES * i + k];
            e[ENTRIES * i + 29 + 7 * FIBRES + k] = -(v9 * each49[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 19 * FIBRES + k] = v9 * each49[FIBRES * i + k];
            e[ENTRIES * i + 29 + 8 * FIBRES + k] = -(v9 * each50[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 20 * FIBRES + k] = v9 * each50[FIBRES * i + k];
            e[ENTRIES * i + 29 + 9 * FIBRES + k] = -(v9 * each51[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 21 * FIBRES + k] = v9 * each51[FIBRES * i + k];
            e[ENTRIES * i + 29 + 10 * FIBRES + k] = -(v9 * each52[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 22 * FIBRES + k] = v9 * each52[FIBRES * i + k];
            e[ENTRIES * i + 29 + 11 * FIBRES + k] = -(v9 * each53[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 23 * FIBRES + k] = v9 * each53[FIBRES * i + k];
            e[ENTRIES * i + 29 + 48 * FIBRES + k] = v118;
            e[ENTRIES * i + 29 + 60 * FIBRES + k] = v123;
            e[ENTRIES * i + 29 + 49 * FIBRES + k] = v128;
            e[ENTRIES * i + 29 + 61 * FIBRES + k] = v133;
            e[ENTRIES * i + 29 + 50 * FIBRES + k] = v138;
            e[ENTRIES * i + 29 + 62 * FIBRES + k] = v143;
            e[ENTRIES * i + 29 + 51 * FIBRES + k] = v148;
            e[ENTRIES * i + 29 + 63 * FIBRES + k] = v153;
            e[ENTRIES * i + 29 + 52 * FIBRES + k] = v158;
            e[ENTRIES * i + 29 + 64 * FIBRES + k] = v163;
            e[ENTRIES * i + 29 + 53 * FIBRES + k] = v168;
            e[ENTRIES * i + 29 + 65 * FIBRES + k] = v173;
            e[ENTRIES * i + 29 + 54 * FIBRES + k] = v113 * each72[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 66 * FIBRES + k] = v113 * each72[FIBRES * i + k];
            e[ENTRIES * i + 29 + 55 * FIBRES + k] = v113 * each73[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 67 * FIBRES + k] = v113 * each73[FIBRES * i + k];
            e[ENTRIES * i + 29 + 56 * FIBRES + k] = v113 * each74[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 68 * FIBRES + k] = v113 * each74[FIBRES * i + k];
            e[ENTRIES * i + 29 + 57 * FIBRES + k] = v113 * each75[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 69 * FIBRES + k] = v113 * each75[FIBRES * i + k];
            e[ENTRIES * i + 29 + 58 * FIBRES + k] = v113 * each76[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 70 * FIBRES + k] = v113 * each76[FIBRES * i + k];
            e[ENTRIES * i + 29 + 59 * FIBRES + k] = v113 * each77[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 71 * FIBRES + k] = v113 * each77[FIBRES * i + k];
        }
    }
}

static void jacobian_10(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w65 = w + 65 * n;
    double *restrict w66 = w + 66 * n;
    double *restrict w67 = w + 67 * n;
    double *restrict w68 = w + 68 * n;
    double *restrict w69 = w + 69 * n;
    double *restrict w70 = w + 70 * n;
    double *restrict each54 = w + (SCRATCH + 54 * FIBRES) * n;
    double *restrict each55 = w + (SCRATCH + 55 * FIBRES) * n;
    double *restrict each56 = w + (SCRATCH + 56 * FIBRES) * n;
    double *restrict each57 = w + (SCRATCH + 57 * FIBRES) * n;
    double *restrict each58 = w + (SCRATCH + 58 * FIBRES) * n;
    double *restrict each59 = w + (SCRATCH + 59 * FIBRES) * n;
    double *restrict each60 = w + (SCRATCH + 60 * FIBRES) * n;
    double *restrict each61 = w + (SCRATCH + 61 * FIBRES) * n;
    double *restrict each62 = w + (SCRATCH + 62 * FIBRES) * n;
    double *restrict each63 = w + (SCRATCH + 63 * FIBRES) * n;
    double *restrict each64 = w + (SCRATCH + 64 * FIBRES) * n;
    double *restrict each65 = w + (SCRATCH + 65 * FIBRES) * n;
    const double c1 = squared(p[18]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[ENTRIES * i + 13] = -(v9 * w65[i - 1]);
        e[ENTRIES * i + 16] = (v9 * w65[i]) - (v9 * w66[i - 1]);
        e[ENTRIES * i + 19] = v9 * w66[i];
        e[ENTRIES * i + 11] = -(v9 * w67[i - 1]);
        e[ENTRIES * i + 14] = (v9 * w67[i]) - (v9 * w68[i - 1]);
        e[ENTRIES * i + 17] = v9 * w68[i];
        e[ENTRIES * i + 12] = -(v9 * w69[i - 1]);
        e[ENTRIES * i + 15] = (v9 * w69[i]) - (v9 * w70[i - 1]);
        e[ENTRIES * i + 18] = v9 * w70[i];
        for (int k = 0; k < FIBRES; k++) {
            e[ENTRIES * i + 29 + 24 * FIBRES + k] = -(v9 * each54[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 36 * FIBRES + k] = v9 * each54[FIBRES * i + k];
            e[ENTRIES * i + 29 + 25 * FIBRES + k] = -(v9 * each55[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 37 * FIBRES + k] = v9 * each55[FIBRES * i + k];
            e[ENTRIES * i + 29 + 26 * FIBRES + k] = -(v9 * each56[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 38 * FIBRES + k] = v9 * each56[FIBRES * i + k];
            e[ENTRIES * i + 29 + 27 * FIBRES + k] = -(v9 * each57[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 39 * FIBRES + k] = v9 * each57[FIBRES * i + k];
            e[ENTRIES * i + 29 + 28 * FIBRES + k] = -(v9 * each58[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 40 * FIBRES + k] = v9 * each58[FIBRES * i + k];
            e[ENTRIES * i + 29 + 29 * FIBRES + k] = -(v9 * each59[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 41 * FIBRES + k] = v9 * each59[FIBRES * i + k];
            e[ENTRIES * i + 29 + 30 * FIBRES + k] = -(v9 * each60[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 42 * FIBRES + k] = v9 * each60[FIBRES * i + k];
            e[ENTRIES * i + 29 + 31 * FIBRES + k] = -(v9 * each61[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 43 * FIBRES + k] = v9 * each61[FIBRES * i + k];
            e[ENTRIES * i + 29 + 32 * FIBRES + k] = -(v9 * each62[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 44 * FIBRES + k] = v9 * each62[FIBRES * i + k];
            e[ENTRIES * i + 29 + 33 * FIBRES + k] = -(v9 * each63[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 45 * FIBRES + k] = v9 * each63[FIBRES * i + k];
            e[ENTRIES * i + 29 + 34 * FIBRES + k] = -(v9 * each64[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 46 * FIBRES + k] = v9 * each64[FIBRES * i + k];
            e[ENTRIES * i + 29 + 35 * FIBRES + k] = -(v9 * each65[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 47 * FIBRES + k] = v9 * each65[FIBRES * i + k];
        }
    }
}

static void jacobian_11(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w65 = w + 65 * n;
    double *restrict w66 = w + 66 * n;
    double *restrict w67 = w + 67 * n;
    double *restrict w68 = w + 68 * n;
    double *restrict w69 = w + 69 * n;
    double *restrict w70 = w + 70 * n;
    double *restrict each54 = w + (SCRATCH + 54 * FIBRES) * n;
    double *restrict each55 = w + (SCRATCH + 55 * FIBRES) * n;
    double *restrict each56 = w + (SCRATCH + 56 * FIBRES) * n;
    double *restrict each57 = w + (SCRATCH + 57 * FIBRES) * n;
    double *restrict each58 = w + (SCRATCH + 58 * FIBRES) * n;
    double *restrict each59 = w + (SCRATCH + 59 * FIBRES) * n;
    double *restrict each60 = w + (SCRATCH + 60 * FIBRES) * n;
    double *restrict each61 = w + (SCRATCH + 61 * FIBRES) * n;
    double *restrict each62 = w + (SCRATCH + 62 * FIBRES) * n;
    double *restrict each63 = w + (SCRATCH + 63 * FIBRES) * n;
    double *restrict each64 = w + (SCRATCH + 64 * FIBRES) * n;
    double *restrict each65 = w + (SCRATCH + 65 * FIBRES) * n;
    const double c1 = squared(p[18]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[ENTRIES * i + 16] = v9 * w65[i];
    e[ENTRIES * i + 19] = v9 * w66[i];
    e[ENTRIES * i + 14] = v9 * w67[i];
    e[ENTRIES * i + 17] = v9 * w68[i];
    e[ENTRIES * i + 15] = v9 * w69[i];
    e[ENTRIES * i + 18] = v9 * w70[i];
    for (int k = 0; k < FIBRES; k++) {
        e[ENTRIES * i + 29 + 36 * FIBRES + k] = v9 * each54[FIBRES * i + k];
        e[ENTRIES * i + 29 + 37 * FIBRES + k] = v9 * each55[FIBRES * i + k];
        e[ENTRIES * i + 29 + 38 * FIBRES + k] = v9 * each56[FIBRES * i + k];
        e[ENTRIES * i + 29 + 39 * FIBRES + k] = v9 * each57[FIBRES * i + k];
        e[ENTRIES * i + 29 + 40 * FIBRES + k] = v9 * each58[FIBRES * i + k];
        e[ENTRIES * i + 29 + 41 * FIBRES + k] = v9 * each59[FIBRES * i + k];
        e[ENTRIES * i + 29 + 42 * FIBRES + k] = v9 * each60[FIBRES * i + k];
        e[ENTRIES * i + 29 + 43 * FIBRES + k] = v9 * each61[FIBRES * i + k];
        e[ENTRIES * i + 29 + 44 * FIBRES + k] = v9 * each62[FIBRES * i + k];
        e[ENTRIES * i + 29 + 45 * FIBRES + k] = v9 * each63[FIBRES * i + k];
        e[ENTRIES * i + 29 + 46 * FIBRES + k] = v9 * each64[FIBRES * i + k];
        e[ENTRIES * i + 29 + 47 * FIBRES + k] = v9 * each65[FIBRES * i + k];
    }
    (void)n;
}

static void work_0(int n, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w83 = w + 83 * n;
    const double c1 = p[6];
    const double c4 = (-0.5) * p[1];
    const double c21 = 0.9 * c1;
    const double c24 = 2.0 * p[4];
    const double c25 = 2.0 + c24;
    const double c26 = c21 / c25;
    const double c36 = 1e-12 * c1;
    const double c37 = squared(c36);
    const double c40 = 1.0 / p[7];
    const double c42 = p[8];
    const double c48 = 0.9 * c42;
    const double c49 = c48 / c25;
    const double c56 = 1e-12 * c42;
    const double c57 = squared(c56);
    const double c60 = 1.0 / p[9];
    const double c63 = p[10];
    const double c69 = 0.9 * c63;
    const double c70 = c69 / c25;
    const double c77 = 1e-12 * c63;
    const double c78 = squared(c77);
    const double c81 = 1.0 / p[11];
    const double c84 = p[12];
    const double c90 = 0.9 * c84;
    const double c91 = c90 / c25;
    const double c98 = 1e-12 * c84;
    const double c99 = squared(c98);
    const double c102 = 1.0 / p[13];
    const double c105 = p[14];
    const double c111 = 0.9 * c105;
    const double c112 = c111 / c25;
    const double c119 = 1e-12 * c105;
    const double c120 = squared(c119);
    const double c123 = 1.0 / p[15];
    const double c126 = p[16];
    const double c132 = 0.9 * c126;
    const double c133 = c132 / c25;
    const double c140 = 1e-12 * c126;
    const double c141 = squared(c140);
    const double c144 = 1.0 / p[17];
    for (int i = 0; i < n - 1; i++) {
        double sum9 = 0.0;
        const double v6 = c4 * w5[i];
        const double v9 = w3[i];
        const double v11 = sqrt(v9) * v9;
        const double v15 = log(v9);
        const double v28 = w4[i] / v9;
        for (int k = 0; k < FIBRES; k++) {
            const double v12 = (v6 * zeta[k]) / v11;
            const double v33 = 3.0 * squared((c26 * (v28 - y[SLOTS * i + 5 + 6 * FIBRES + k])));
            const double v34 = squared((c1 * ((v12 - y[SLOTS * i + 5 + k]) + v15))) + v33;
            const double v47 = squared((c42 * ((v12 - y[SLOTS * i + 5 + 1 * FIBRES + k]) + v15)));
            const double v54 = 3.0 * squared((c49 * (v28 - y[SLOTS * i + 5 + 7 * FIBRES + k])));
            const double v68 = squared((c63 * ((v12 - y[SLOTS * i + 5 + 2 * FIBRES + k]) + v15)));
            const double v75 = 3.0 * squared((c70 * (v28 - y[SLOTS * i + 5 + 8 * FIBRES + k])));
            const double v83 = ((larger(v34, c37) * c40) + (larger(v47 + v54, c57) * c60)) + (larger(v68 + v75, c78) * c81);
            const double v89 = squared((c84 * ((v12 - y[SLOTS * i + 5 + 3 * FIBRES + k]) + v15)));
            const double v96 = 3.0 * squared((c91 * (v28 - y[SLOTS * i + 5 + 9 * FIBRES + k])));
            const double v110 = squared((c105 * ((v12 - y[SLOTS * i + 5 + 4 * FIBRES + k]) + v15)));
            const double v116 = squared((c112 * (v28 - y[SLOTS * i + 5 + 10 * FIBRES + k])));
            const double v125 = (v83 + (larger(v89 + v96, c99) * c102)) + (larger(v110 + (3.0 * v116), c120) * c123);
            const double v131 = squared((c126 * ((v12 - y[SLOTS * i + 5 + 5 * FIBRES + k]) + v15)));
            const double v137 = squared((c133 * (v28 - y[SLOTS * i + 5 + 11 * FIBRES + k])));
            const double v148 = (v125 + (larger(v131 + (3.0 * v137), c141) * c144)) * weight[k];
            sum9 += v148;
        }
        w83[i] = sum9;
    }
}

static void work_1(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w83 = w + 83 * n;
    const double c3 = p[18];
    const double c6 = p[0] / c3;
    const double c7 = squared(c6);
    const double c8 = p[2] * c7;
    const double c9 = c3 / c8;
    for (int i = 0; i < n - 1; i++) {
        q[0] += (g[7 * i + 1] * w83[i]) * c9;
    }
}

static void work_slope_0(int n, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
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
    double *restrict w83 = w + 83 * n;
    double *restrict w84 = w + 84 * n;
    double *restrict w85 = w + 85 * n;
    double *restrict w86 = w + 86 * n;
    double *restrict w87 = w + 87 * n;
    double *restrict w88 = w + 88 * n;
    double *restrict w89 = w + 89 * n;
    double *restrict each84 = w + (SCRATCH + 84 * FIBRES) * n;
    double *restrict each85 = w + (SCRATCH + 85 * FIBRES) * n;
    double *restrict each86 = w + (SCRATCH + 86 * FIBRES) * n;
    double *restrict each87 = w + (SCRATCH + 87 * FIBRES) * n;
    double *restrict each88 = w + (SCRATCH + 88 * FIBRES) * n;
    double *restrict each89 = w + (SCRATCH + 89 * FIBRES) * n;
    double *restrict each90 = w + (SCRATCH + 90 * FIBRES) * n;
    double *restrict each91 = w + (SCRATCH + 91 * FIBRES) * n;
    double *restrict each92 = w + (SCRATCH + 92 * FIBRES) * n;
    double *restrict each93 = w + (SCRATCH + 93 * FIBRES) * n;
    double *restrict each94 = w + (SCRATCH + 94 * FIBRES) * n;
    double *restrict each95 = w + (SCRATCH + 95 * FIBRES) * n;
    const double c1 = p[6];
    const double c4 = (-0.5) * p[1];
    const double c21 = 1e-12 * c1;
    const double c22 = squared(c21);
    const double c26 = 0.9 * c1;
    const double c29 = 2.0 * p[4];
    const double c30 = 2.0 + c29;
    const double c31 = c26 / c30;
    const double c46 = p[7];
    const double c52 = p[8];
    const double c58 = 1e-12 * c52;
    const double c59 = squared(c58);
    const double c61 = 0.9 * c52;
    const double c62 = c61 / c30;
    const double c73 = p[9];
    const double c79 = p[10];
    const double c85 = 1e-12 * c79;
    const double c86 = squared(c85);
    const double c88 = 0.9 * c79;
    const double c89 = c88 / c30;
    const double c100 = p[11];
    const double c106 = p[12];
    const double c112 = 1e-12 * c106;
    const double c113 = squared(c112);
    const double c115 = 0.9 * c106;
    const double c116 = c115 / c30;
    const double c127 = p[13];
    const double c133 = p[14];
    const double c139 = 1e-12 * c133;
    const double c140 = squared(c139);
    const double c142 = 0.9 * c133;
    const double c143 = c142 / c30;
    const double c154 = p[15];
    const double c160 = p[16];
    const double c166 = 1e-12 * c160;
    const double c167 = squared(c166);
    const double c169 = 0.9 * c160;
    const double c170 = c169 / c30;
    const double c181 = p[17];
    const double c354 = 1.0 / c46;
    const double c357 = 1.0 / c73;
    const double c361 = 1.0 / c100;
    const double c365 = 1.0 / c127;
    const double c369 = 1.0 / c154;
    const double c373 = 1.0 / c181;
    for (int i = 0; i < n - 1; i++) {
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum12 = 0.0;
        double sum9 = 0.0;
        const double v6 = c4 * w5[i];
        const double v9 = w3[i];
        const double v10 = sqrt(v9);
        const double v12 = 1.0 / (v10 * v9);
        const double v16 = log(v9);
        const double v33 = 1.0 / v9;
        const double v34 = w4[i] * v33;
        const double v268 = v34 * v33;
        const double v277 = 1.0 / (2.0 * v10);
        for (int k = 0; k < FIBRES; k++) {
            const double v7 = zeta[k];
            const double v13 = (v6 * v7) * v12;
            const double v18 = c1 * ((v13 - y[SLOTS * i + 5 + k]) + v16);
            const double v37 = c31 * (v34 - y[SLOTS * i + 5 + 6 * FIBRES + k]);
            const double v40 = squared(v18) + (3.0 * squared(v37));
            const double v41 = (double)(c22 <= v40);
            const double v45 = weight[k];
            const double v48 = (v41 / (v41 + (double)(v40 <= c22))) * (v45 / c46);
            const double v50 = c1 * ((2.0 * v18) * v48);
            const double v56 = c52 * ((v13 - y[SLOTS * i + 5 + 1 * FIBRES + k]) + v16);
            const double v65 = c62 * (v34 - y[SLOTS * i + 5 + 7 * FIBRES + k]);
            const double v68 = squared(v56) + (3.0 * squared(v65));
            const double v69 = (double)(c59 <= v68);
            const double v75 = (v69 / (v69 + (double)(v68 <= c59))) * (v45 / c73);
            const double v77 = c52 * ((2.0 * v56) * v75);
            const double v83 = c79 * ((v13 - y[SLOTS * i + 5 + 2 * FIBRES + k]) + v16);
            const double v92 = c89 * (v34 - y[SLOTS * i + 5 + 8 * FIBRES + k]);
            const double v95 = squared(v83) + (3.0 * squared(v92));
            const double v96 = (double)(c86 <= v95);
            const double v102 = (v96 / (v96 + (double)(v95 <= c86))) * (v45 / c100);
            const double v104 = c79 * ((2.0 * v83) * v102);
            const double v110 = c106 * ((v13 - y[SLOTS * i + 5 + 3 * FIBRES + k]) + v16);
            const double v119 = c116 * (v34 - y[SLOTS * i + 5 + 9 * FIBRES + k]);
            const double v122 = squared(v110) + (3.0 * squared(v119));
            const double v123 = (double)(c113 <= v122);
            const double v129 = (v123 / (v123 + (double)(v122 <= c113))) * (v45 / c127);
            const double v131 = c106 * ((2.0 * v110) * v129);
            const double v137 = c133 * ((v13 - y[SLOTS * i + 5 + 4 * FIBRES + k]) + v16);
            const double v146 = c143 * (v34 - y[SLOTS * i + 5 + 10 * FIBRES + k]);
            const double v149 = squared(v137) + (3.0 * squared(v146));
            const double v150 = (double)(c140 <= v149);
            const double v156 = (v150 / (v150 + (double)(v149 <= c140))) * (v45 / c154);
            const double v158 = c133 * ((2.0 * v137) * v156);
            const double v164 = c160 * ((v13 - y[SLOTS * i + 5 + 5 * FIBRES + k]) + v16);
            const double v173 = c170 * (v34 - y[SLOTS * i + 5 + 11 * FIBRES + k]);
            const double v176 = squared(v164) + (3.0 * squared(v173));
            const double v177 = (double)(c167 <= v176);
            const double v183 = (v177 / (v177 + (double)(v176 <= c167))) * (v45 / c181);
            const double v185 = c160 * ((2.0 * v164) * v183);
            const double v209 = c31 * ((2.0 * v37) * (3.0 * v48));
            const double v214 = c62 * ((2.0 * v65) * (3.0 * v75));
            const double v219 = c89 * ((2.0 * v92) * (3.0 * v102));
            const double v224 = c116 * ((2.0 * v119) * (3.0 * v129));
            const double v229 = c143 * ((2.0 * v146) * (3.0 * v156));
            const double v234 = c170 * ((2.0 * v173) * (3.0 * v183));
            const double v262 = (((v234 * v33) + (v229 * v33)) + (v224 * v33)) + (v219 * v33);
            const double v271 = v13 * v12;
            const double v272 = v271 * v185;
            const double v279 = (((v185 * v33) - (v268 * v234)) - (v10 * v272)) - ((v9 * v272) * v277);
            const double v284 = v271 * v158;
            const double v289 = (((v279 - (v268 * v229)) + (v158 * v33)) - (v10 * v284)) - ((v9 * v284) * v277);
            const double v294 = v271 * v131;
            const double v299 = (((v289 - (v268 * v224)) + (v131 * v33)) - (v10 * v294)) - ((v9 * v294) * v277);
            const double v304 = v271 * v104;
            const double v309 = (((v299 - (v268 * v219)) + (v104 * v33)) - (v10 * v304)) - ((v9 * v304) * v277);
            const double v314 = v271 * v77;
            const double v319 = (((v309 - (v268 * v214)) + (v77 * v33)) - (v10 * v314)) - ((v9 * v314) * v277);
            const double v324 = v271 * v50;
            const double v329 = (((v319 - (v268 * v209)) + (v50 * v33)) - (v10 * v324)) - ((v9 * v324) * v277);
            const double v340 = ((c4 * (v7 * (v185 * v12))) + (c4 * (v7 * (v158 * v12)))) + (c4 * (v7 * (v131 * v12)));
            const double v348 = (v340 + (c4 * (v7 * (v104 * v12)))) + (c4 * (v7 * (v77 * v12)));
            const double v363 = ((larger(v40, c22) * c354) + (larger(v68, c59) * c357)) + (larger(v95, c86) * c361);
            const double v371 = (v363 + (larger(v122, c113) * c365)) + (larger(v149, c140) * c369);
            each84[FIBRES * i + k] = -v50;
            each85[FIBRES * i + k] = -v77;
            each86[FIBRES * i + k] = -v104;
            each87[FIBRES * i + k] = -v131;
            each88[FIBRES * i + k] = -v158;
            each89[FIBRES * i + k] = -v185;
            each90[FIBRES * i + k] = -v209;
            each91[FIBRES * i + k] = -v214;
            each92[FIBRES * i + k] = -v219;
            each93[FIBRES * i + k] = -v224;
            each94[FIBRES * i + k] = -v229;
            each95[FIBRES * i + k] = -v234;
            sum10 += (v262 + (v214 * v33)) + (v209 * v33);
            sum11 += v329;
            sum12 += v348 + (c4 * (v7 * (v50 * v12)));
            sum9 += (v371 + (larger(v176, c167) * c373)) * v45;
        }
        const double v187 = sum10;
        const double v190 = sum11;
        const double v194 = sum12;
        w83[i] = sum9;
        w84[i] = ((v187 * w21[i]) + (v190 * w15[i])) + (v194 * w27[i]);
        w85[i] = ((v187 * w22[i]) + (v190 * w16[i])) + (v194 * w28[i]);
        w86[i] = (v187 * w23[i]) + (v190 * w17[i]);
        w87[i] = (v187 * w24[i]) + (v190 * w18[i]);
        w88[i] = (v187 * w25[i]) + (v190 * w19[i]);
        w89[i] = (v187 * w26[i]) + (v190 * w20[i]);
    }
}

static void work_slope_1(int n, const double *p, const double *g, double *w, double *s)
{
    double *restrict w84 = w + 84 * n;
    double *restrict w85 = w + 85 * n;
    double *restrict w86 = w + 86 * n;
    double *restrict w87 = w + 87 * n;
    double *restrict w88 = w + 88 * n;
    double *restrict w89 = w + 89 * n;
    double *restrict each84 = w + (SCRATCH + 84 * FIBRES) * n;
    double *restrict each85 = w + (SCRATCH + 85 * FIBRES) * n;
    double *restrict each86 = w + (SCRATCH + 86 * FIBRES) * n;
    double *restrict each87 = w + (SCRATCH + 87 * FIBRES) * n;
    double *restrict each88 = w + (SCRATCH + 88 * FIBRES) * n;
    double *restrict each89 = w + (SCRATCH + 89 * FIBRES) * n;
    double *restrict each90 = w + (SCRATCH + 90 * FIBRES) * n;
    double *restrict each91 = w + (SCRATCH + 91 * FIBRES) * n;
    double *restrict each92 = w + (SCRATCH + 92 * FIBRES) * n;
    double *restrict each93 = w + (SCRATCH + 93 * FIBRES) * n;
    double *restrict each94 = w + (SCRATCH + 94 * FIBRES) * n;
    double *restrict each95 = w + (SCRATCH + 95 * FIBRES) * n;
    const double c0 = p[18];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v8 = c6 * g[7 * i + 1];
        s[SLOTS * i + 4] += v8 * w84[i];
        s[SLOTS * (i + 1) + 4] += v8 * w85[i];
        s[SLOTS * i + 0] += v8 * w86[i];
        s[SLOTS * (i + 1) + 0] += v8 * w87[i];
        s[SLOTS * i + 1] += v8 * w88[i];
        s[SLOTS * (i + 1) + 1] += v8 * w89[i];
        for (int k = 0; k < FIBRES; k++) {
            s[SLOTS * i + 5 + k] += v8 * each84[FIBRES * i + k];
            s[SLOTS * i + 5 + 1 * FIBRES + k] += v8 * each85[FIBRES * i + k];
            s[SLOTS * i + 5 + 2 * FIBRES + k] += v8 * each86[FIBRES * i + k];
            s[SLOTS * i + 5 + 3 * FIBRES + k] += v8 * each87[FIBRES * i + k];
            s[SLOTS * i + 5 + 4 * FIBRES + k] += v8 * each88[FIBRES * i + k];
            s[SLOTS * i + 5 + 5 * FIBRES + k] += v8 * each89[FIBRES * i + k];
            s[SLOTS * i + 5 + 6 * FIBRES + k] += v8 * each90[FIBRES * i + k];
            s[SLOTS * i + 5 + 7 * FIBRES + k] += v8 * each91[FIBRES * i + k];
            s[SLOTS * i + 5 + 8 * FIBRES + k] += v8 * each92[FIBRES * i + k];
            s[SLOTS * i + 5 + 9 * FIBRES + k] += v8 * each93[FIBRES * i + k];
            s[SLOTS * i + 5 + 10 * FIBRES + k] += v8 * each94[FIBRES * i + k];
            s[SLOTS * i + 5 + 11 * FIBRES + k] += v8 * each95[FIBRES * i + k];
        }
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
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
    rates_10(n, p, g, w, f);
    rates_11(n, p, g, w, f);
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
    jacobian_10(n, p, g, w, e);
    jacobian_11(n, p, g, w, e);
    return SOFTCAT_SOLVED;
}

static int work(const softcat_filament *filament, double t, const double *y, double *q,
                double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, y, w);
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
    for (int k = 0; k < n * 3 * SLOTS; k++) s[k] = 0.0;
    work_slope_0(n, p, y, w);
    work_slope_1(n, p, g, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {
    2, 3, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1};
static const int differential[] = {
    1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int held_first[] = {
    1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
static const int held_last[] = {
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int row[] = {
    0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 2, 2,
    2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2,
    2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 5, 6, 5, 6, 5, 6, 5, 6, 5, 6, 5,
    6, 7, 8, 7, 8, 7, 8, 7, 8, 7, 8, 7, 8, 7, 8, 9, 10, 9, 10, 9, 10, 9, 10, 9, 10, 9, 10, 9,
    10, 11, 12, 11, 12, 11, 12, 11, 12, 11, 12, 11, 12, 11, 12, 13, 14, 13, 14, 13, 14, 13, 14,
    13, 14, 13, 14, 13, 14, 15, 16, 15, 16, 15, 16, 15, 16, 15, 16, 15, 16, 15, 16, 17, 18, 17,
    18, 17, 18, 17, 18, 17, 18, 17, 18, 17, 18, 19, 20, 19, 20, 19, 20, 19, 20, 19, 20, 19, 20,
    19, 20, 21, 22, 21, 22, 21, 22, 21, 22, 21, 22, 21, 22, 21, 22, 23, 24, 23, 24, 23, 24, 23,
    24, 23, 24, 23, 24, 23, 24, 25, 26, 25, 26, 25, 26, 25, 26, 25, 26, 25, 26, 25, 26, 27, 28,
    27, 28, 27, 28, 27, 28, 27, 28, 27, 28, 27, 28};
static const int offset[] = {
    0, 0, -1, -1, -1, 0, 0, 0, 1, 1, 1, -1, -1, -1, 0, 0, 0, 1, 1, 1, -1, -1, -1, 0, 0, 0, 1, 1,
    1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0,
    0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0,
    0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1,
    1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
static const int column[] = {
    2, 3, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 5, 6,
    7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 5, 6,
    7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 5, 6,
    7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 5, 6,
    7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 5, 6,
    7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 5, 6,
    7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 0, 0,
    1, 1, 4, 4, 5, 6, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 7, 8, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4,
    4, 9, 10, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 11, 12, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4,
    13, 14, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 15, 16, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 17,
    18, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 19, 20, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 21, 22,
    0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 23, 24, 0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 25, 26, 0,
    0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 27, 28, 0, 0, 1, 1, 4, 4};

const softcat_model softcat_filament_model = {
    29, 24, 19, 7, 282, 341, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "poisson", "surface_tension",
    "mode_1_youngs_modulus", "mode_1_viscosity", "mode_2_youngs_modulus", "mode_2_viscosity",
    "mode_3_youngs_modulus", "mode_3_viscosity", "mode_4_youngs_modulus", "mode_4_viscosity",
    "mode_5_youngs_modulus", "mode_5_viscosity", "mode_6_youngs_modulus", "mode_6_viscosity",
    "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "1", "N/m", "Pa", "Pa*s", "Pa", "Pa*s", "Pa", "Pa*s", "Pa",
    "Pa*s", "Pa", "Pa*s", "Pa", "Pa*s", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE, SOFTCAT_POISSON,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.1, 0.004, 780.0, 9.81, 0.45, 0.028, 176000.0, 1760.0, 80100.0, 8010.0, 29400.0, 29400.0,
    5670.0, 56700.0, 540.0, 54000.0, 3.0, 3000.0, 0.10096375546923045};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0", "axial_1", "axial_0_mode2", "axial_1_mode2",
    "axial_0_mode3", "axial_1_mode3", "axial_0_mode4", "axial_1_mode4", "axial_0_mode5",
    "axial_1_mode5", "axial_0_mode6", "axial_1_mode6", "shear_0", "shear_1", "shear_0_mode2",
    "shear_1_mode2", "shear_0_mode3", "shear_1_mode3", "shear_0_mode4", "shear_1_mode4",
    "shear_0_mode5", "shear_1_mode5", "shear_0_mode6", "shear_1_mode6"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, (-0.4999999999999998), 0.5000000000000001, (-0.4999999999999998),
    0.5000000000000001, (-0.4999999999999998), 0.5000000000000001, (-0.4999999999999998),
    0.5000000000000001, (-0.4999999999999998), 0.5000000000000001, (-0.4999999999999998),
    0.5000000000000001, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Thread of molten polyethylene with six relaxation times",
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
    .area_power = 2,
    .profiled = 0,
    .places = described_places,
    .x = 0,
    .y = 1,
    .psi = 4,
    .rest_length = 0,
    .time_scale = 18,
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
    .grading = 3.0,
    .relative = 1.2e-05,
    .absolute = 1.2000000000000002e-07,
    .towards_middle = 0,
    .duration = 10.0,
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
