/*
 * String of hot glue, thin at one end
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, shear, surface-tension
 * Digest of the structure: 28388dff5a55659a304206b079ffb4a83daa08ea79de93c0f2732e684545a45b
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES 2
#define SLOTS 9
#define ENTRIES 81
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
        f[SLOTS * i + 1] = y[SLOTS * i + 3];
    }
}

static void rates_1(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[SLOTS * i + 0];
        w1[i] = y[SLOTS * i + 1];
        w2[i] = y[SLOTS * i + 4];
    }
}

static void rates_2(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
    (void)n;
}

static void rates_3(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = 0;
    w0[i] = -0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
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
    const double c26 = 1.0 / p[0];
    for (int i = 0; i < n - 1; i++) {
        const double v4 = g[9 * i + 4];
        const double v5 = (w0[i + 1] - w0[i]) * v4;
        const double v6 = w2[i];
        const double v7 = w2[i + 1];
        const double v11 = (v6 + v7) * 0.5;
        const double v12 = cos(v11);
        const double v17 = (w1[i + 1] - w1[i]) * v4;
        const double v18 = sin(v11);
        w3[i] = (v5 * v12) + (v17 * v18);
        w4[i] = (v17 * v12) - (v5 * v18);
        w5[i] = (v7 - v6) * (v4 * c26);
    }
}

static void rates_5(int n, const double *p, const double *g, const double *y, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    const double c3 = p[4];
    const double c22 = p[5];
    const double c23 = 1.0 / c22;
    const double c25 = p[8];
    const double c28 = 3.0 / c22;
    const double c30 = 0.9 * c3;
    const double c33 = 2.0 * p[6];
    const double c34 = 2.0 + c33;
    const double c35 = c30 / c34;
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v6 = (-0.5) * w5[i];
        const double v11 = p[1] * g[9 * i + 8];
        const double v13 = w3[i];
        const double v15 = sqrt(v13) * v13;
        const double v19 = log(v13);
        const double v37 = w4[i] / v13;
        for (int k = 0; k < FIBRES; k++) {
            const double v7 = zeta[k];
            const double v21 = c3 * (((((v6 * v7) * v11) / v15) - y[SLOTS * i + 5 + k]) + v19);
            const double v40 = c35 * (v37 - y[SLOTS * i + 5 + 1 * FIBRES + k]);
            const double v43 = weight[k];
            f[SLOTS * i + 5 + k] = (v21 * c23) * c25;
            f[SLOTS * i + 5 + 1 * FIBRES + k] = (c28 * v40) * c25;
            sum0 += v21 * v43;
            sum1 += v21 * (v43 * v7);
            sum2 += v40 * v43;
        }
        w6[i] = sum0;
        w7[i] = sum1;
        w8[i] = sum2;
    }
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
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    for (int i = 0; i < n - 1; i++) {
        const double v0 = g[9 * i + 8];
        const double v1 = squared(v0);
        const double v3 = w3[i];
        const double v4 = 1.0 / v3;
        const double v7 = w4[i];
        const double v10 = v1 * (w8[i] * v4);
        const double v19 = p[1] * v0;
        const double v24 = v1 * (((0.5 * w7[i]) * v19) / (sqrt(v3) * v3));
        const double v29 = ((v1 * (w6[i] * v4)) - ((v7 * v10) * v4)) + (((1.5 * v24) * w5[i]) * v4);
        const double v34 = (w2[i] + w2[i + 1]) * 0.5;
        const double v35 = cos(v34);
        const double v37 = sin(v34);
        const double v39 = (v29 * v35) - (v10 * v37);
        const double v42 = (v29 * v37) + (v10 * v35);
        const double v47 = g[9 * i + 4];
        const double v48 = (w0[i + 1] - w0[i]) * v47;
        const double v53 = (w1[i + 1] - w1[i]) * v47;
        const double v56 = sqrt(squared(v48) + squared(v53));
        const double v63 = (((2.0 / sqrt(v56)) * (p[7] / v19)) * v1) / v56;
        w9[i] = v39;
        w10[i] = v42;
        w11[i] = v39 + (v63 * v48);
        w12[i] = v42 + (v63 * v53);
        w13[i] = ((g[9 * i + 1] * p[0]) * ((v10 * v3) - (v7 * v29))) * 0.5;
        w14[i] = -v24;
    }
}

static void rates_7(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    const double c4 = squared(p[8]);
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
    const double c39 = squared(c5);
    const double c40 = c7 * c39;
    const double c41 = c32 / c40;
    for (int i = 1; i < n - 1; i++) {
        const double v12 = c9 * g[9 * i + 6];
        const double v38 = (((w14[i] - w14[i - 1]) + w13[i]) + w13[i - 1]) * (c34 * g[9 * i + 5]);
        f[SLOTS * i + 2] = (w11[i] - w11[i - 1]) * v12;
        f[SLOTS * i + 3] = ((w12[i] - w12[i - 1]) * v12) - c19;
        f[SLOTS * i + 4] = v38 * c41;
    }
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[ENTRIES * i + 0] = 1.0;
        e[ENTRIES * i + 1] = 1.0;
    }
}

static void jacobian_1(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[SLOTS * i + 0];
        w1[i] = y[SLOTS * i + 1];
        w2[i] = y[SLOTS * i + 4];
    }
}

static void jacobian_2(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
    (void)n;
}

static void jacobian_3(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = 0;
    w0[i] = -0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
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
        const double v4 = g[9 * i + 4];
        const double v5 = (w0[i + 1] - w0[i]) * v4;
        const double v6 = w2[i];
        const double v7 = w2[i + 1];
        const double v11 = (v6 + v7) * 0.5;
        const double v12 = cos(v11);
        const double v17 = (w1[i + 1] - w1[i]) * v4;
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

static void jacobian_5(int n, const double *p, const double *g, const double *y, double *w, double *e)
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
    const double c1 = p[4];
    const double c54 = 0.9 * c1;
    const double c57 = 2.0 * p[6];
    const double c58 = 2.0 + c57;
    const double c59 = c54 / c58;
    const double c78 = p[8];
    const double c79 = p[5];
    const double c80 = c1 / c79;
    const double c81 = c78 * c80;
    const double c82 = -c81;
    const double c105 = 1.0 / c79;
    const double c125 = 3.0 / c79;
    const double c141 = c125 * c59;
    const double c142 = c78 * c141;
    const double c143 = -c142;
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
        const double v6 = w15[i];
        const double v9 = w27[i];
        const double v12 = w16[i];
        const double v14 = w28[i];
        const double v17 = w17[i];
        const double v19 = w18[i];
        const double v21 = w19[i];
        const double v23 = w20[i];
        const double v44 = w21[i];
        const double v49 = w22[i];
        const double v62 = w23[i];
        const double v66 = w24[i];
        const double v70 = w25[i];
        const double v74 = w26[i];
        const double v83 = w3[i];
        const double v84 = 1.0 / v83;
        const double v87 = (-0.5) * w5[i];
        const double v91 = p[1] * g[9 * i + 8];
        const double v93 = sqrt(v83);
        const double v95 = 1.0 / (v93 * v83);
        const double v99 = 1.0 / (2.0 * v93);
        const double v101 = (v83 * v99) + v93;
        const double v128 = c78 * (c125 * (c59 * v84));
        const double v131 = w4[i] * v84;
        const double v132 = v131 * v84;
        const double v135 = c78 * (c125 * (c59 * v132));
        const double v158 = log(v83);
        for (int k = 0; k < FIBRES; k++) {
            const double v2 = weight[k];
            const double v3 = c1 * v2;
            const double v26 = zeta[k];
            const double v27 = v2 * v26;
            const double v28 = c1 * v27;
            const double v60 = c59 * v2;
            const double v96 = ((v87 * v26) * v91) * v95;
            const double v97 = v96 * v95;
            const double v107 = c78 * ((c1 * (v84 - (v97 * v101))) * c105);
            const double v114 = c78 * ((c1 * ((v91 * ((-0.5) * v26)) * v95)) * c105);
            const double v160 = c1 * ((v96 - y[SLOTS * i + 5 + k]) + v158);
            const double v168 = v97 * v3;
            const double v179 = v97 * v28;
            each0[FIBRES * i + k] = -v3;
            each1[FIBRES * i + k] = -v28;
            each2[FIBRES * i + k] = -v60;
            e[ENTRIES * i + 29 + 15 * FIBRES + k] = c82;
            e[ENTRIES * i + 29 + 14 * FIBRES + k] = (v107 * v6) + (v114 * v9);
            e[ENTRIES * i + 29 + 18 * FIBRES + k] = (v107 * v12) + (v114 * v14);
            e[ENTRIES * i + 29 + 12 * FIBRES + k] = v107 * v17;
            e[ENTRIES * i + 29 + 16 * FIBRES + k] = v107 * v19;
            e[ENTRIES * i + 29 + 13 * FIBRES + k] = v107 * v21;
            e[ENTRIES * i + 29 + 17 * FIBRES + k] = v107 * v23;
            e[ENTRIES * i + 29 + 21 * FIBRES + k] = (v128 * v44) - (v135 * v6);
            e[ENTRIES * i + 29 + 25 * FIBRES + k] = (v128 * v49) - (v135 * v12);
            e[ENTRIES * i + 29 + 22 * FIBRES + k] = c143;
            e[ENTRIES * i + 29 + 19 * FIBRES + k] = (v128 * v62) - (v135 * v17);
            e[ENTRIES * i + 29 + 23 * FIBRES + k] = (v128 * v66) - (v135 * v19);
            e[ENTRIES * i + 29 + 20 * FIBRES + k] = (v128 * v70) - (v135 * v21);
            e[ENTRIES * i + 29 + 24 * FIBRES + k] = (v128 * v74) - (v135 * v23);
            sum0 += v160 * v2;
            sum1 += v160 * v27;
            sum2 += (c59 * (v131 - y[SLOTS * i + 5 + 1 * FIBRES + k])) * v2;
            sum3 += ((v3 * v84) - (v93 * v168)) - ((v83 * v168) * v99);
            sum4 += (-0.5) * (v26 * (v91 * (v3 * v95)));
            sum5 += ((v28 * v84) - (v93 * v179)) - ((v83 * v179) * v99);
            sum6 += (-0.5) * (v26 * (v91 * (v28 * v95)));
            sum7 += v60 * v84;
            sum8 += -(v132 * v60);
        }
        const double v5 = sum3;
        const double v8 = sum4;
        const double v30 = sum5;
        const double v32 = sum6;
        const double v43 = sum7;
        const double v46 = sum8;
        w6[i] = sum0;
        w29[i] = (v5 * v6) + (v8 * v9);
        w30[i] = (v5 * v12) + (v8 * v14);
        w31[i] = v5 * v17;
        w32[i] = v5 * v19;
        w33[i] = v5 * v21;
        w34[i] = v5 * v23;
        w7[i] = sum1;
        w35[i] = (v30 * v6) + (v32 * v9);
        w36[i] = (v30 * v12) + (v32 * v14);
        w37[i] = v30 * v17;
        w38[i] = v30 * v19;
        w39[i] = v30 * v21;
        w40[i] = v30 * v23;
        w8[i] = sum2;
        w41[i] = (v43 * v44) + (v46 * v6);
        w42[i] = (v43 * v49) + (v46 * v12);
        w43[i] = (v43 * v62) + (v46 * v17);
        w44[i] = (v43 * v66) + (v46 * v19);
        w45[i] = (v43 * v70) + (v46 * v21);
        w46[i] = (v43 * v74) + (v46 * v23);
    }
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
    for (int i = 0; i < n - 1; i++) {
        const double v0 = g[9 * i + 8];
        const double v1 = squared(v0);
        const double v3 = w3[i];
        const double v4 = 1.0 / v3;
        const double v5 = w6[i] * v4;
        const double v7 = w4[i];
        const double v9 = w8[i] * v4;
        const double v10 = v1 * v9;
        const double v12 = (v7 * v10) * v4;
        const double v19 = p[1] * v0;
        const double v21 = sqrt(v3);
        const double v23 = 1.0 / (v21 * v3);
        const double v24 = ((0.5 * w7[i]) * v19) * v23;
        const double v25 = v1 * v24;
        const double v26 = 1.5 * v25;
        const double v27 = w5[i];
        const double v29 = (v26 * v27) * v4;
        const double v30 = ((v1 * v5) - v12) + v29;
        const double v35 = (w2[i] + w2[i + 1]) * 0.5;
        const double v36 = cos(v35);
        const double v38 = sin(v35);
        const double v40 = (v30 * v36) - (v10 * v38);
        const double v41 = v1 * v4;
        const double v42 = v36 * v41;
        const double v47 = v1 * ((0.5 * v19) * v23);
        const double v50 = (v27 * (1.5 * v47)) * v4;
        const double v51 = v36 * v50;
        const double v56 = v1 * (v9 * v4);
        const double v69 = v1 * ((v24 * v23) * ((v3 / (2.0 * v21)) + v21));
        const double v75 = ((((v7 * v56) * v4) + (v12 * v4)) - (v1 * (v5 * v4))) - (((v27 * (1.5 * v69)) * v4) + (v29 * v4));
        const double v78 = (v36 * v75) + (v38 * v56);
        const double v79 = w15[i];
        const double v81 = v10 * v4;
        const double v82 = v36 * v81;
        const double v83 = w21[i];
        const double v86 = w29[i];
        const double v89 = w35[i];
        const double v92 = v26 * v4;
        const double v93 = v36 * v92;
        const double v94 = w27[i];
        const double v96 = ((((v78 * v79) - (v82 * v83)) + (v42 * v86)) + (v51 * v89)) + (v93 * v94);
        const double v97 = 0.5 * v38;
        const double v99 = 0.5 * v36;
        const double v101 = (v30 * v97) + (v10 * v99);
        const double v103 = v7 * v41;
        const double v104 = v103 * v4;
        const double v106 = v38 * v41;
        const double v107 = (v36 * v104) + v106;
        const double v108 = w41[i];
        const double v110 = (v96 - v101) - (v107 * v108);
        const double v111 = w16[i];
        const double v113 = w22[i];
        const double v116 = w30[i];
        const double v119 = w36[i];
        const double v121 = (((v78 * v111) - (v82 * v113)) + (v42 * v116)) + (v51 * v119);
        const double v122 = w28[i];
        const double v126 = w42[i];
        const double v128 = ((v121 + (v93 * v122)) - v101) - (v107 * v126);
        const double v132 = w17[i];
        const double v134 = w23[i];
        const double v137 = w31[i];
        const double v140 = w37[i];
        const double v142 = (((v78 * v132) - (v82 * v134)) + (v42 * v137)) + (v51 * v140);
        const double v143 = w43[i];
        const double v145 = v142 - (v107 * v143);
        const double v146 = w18[i];
        const double v148 = w24[i];
        const double v151 = w32[i];
        const double v154 = w38[i];
        const double v156 = (((v78 * v146) - (v82 * v148)) + (v42 * v151)) + (v51 * v154);
        const double v157 = w44[i];
        const double v159 = v156 - (v107 * v157);
        const double v160 = w19[i];
        const double v162 = w25[i];
        const double v165 = w33[i];
        const double v168 = w39[i];
        const double v170 = (((v78 * v160) - (v82 * v162)) + (v42 * v165)) + (v51 * v168);
        const double v171 = w45[i];
        const double v173 = v170 - (v107 * v171);
        const double v174 = w20[i];
        const double v176 = w26[i];
        const double v179 = w34[i];
        const double v182 = w40[i];
        const double v184 = (((v78 * v174) - (v82 * v176)) + (v42 * v179)) + (v51 * v182);
        const double v185 = w46[i];
        const double v187 = v184 - (v107 * v185);
        const double v190 = (v30 * v38) + (v10 * v36);
        const double v192 = v38 * v50;
        const double v197 = (v38 * v75) - (v36 * v56);
        const double v199 = v38 * v81;
        const double v205 = (((v197 * v79) - (v199 * v83)) + (v106 * v86)) + (v192 * v89);
        const double v206 = v38 * v92;
        const double v211 = (v30 * v99) - (v10 * v97);
        const double v214 = v42 - (v38 * v104);
        const double v216 = ((v205 + (v206 * v94)) + v211) + (v214 * v108);
        const double v223 = (((v197 * v111) - (v199 * v113)) + (v106 * v116)) + (v192 * v119);
        const double v228 = ((v223 + (v206 * v122)) + v211) + (v214 * v126);
        const double v236 = (((v197 * v132) - (v199 * v134)) + (v106 * v137)) + (v192 * v140);
        const double v238 = v236 + (v214 * v143);
        const double v245 = (((v197 * v146) - (v199 * v148)) + (v106 * v151)) + (v192 * v154);
        const double v247 = v245 + (v214 * v157);
        const double v254 = (((v197 * v160) - (v199 * v162)) + (v106 * v165)) + (v192 * v168);
        const double v256 = v254 + (v214 * v171);
        const double v263 = (((v197 * v174) - (v199 * v176)) + (v106 * v179)) + (v192 * v182);
        const double v265 = v263 + (v214 * v185);
        const double v270 = g[9 * i + 4];
        const double v271 = (w0[i + 1] - w0[i]) * v270;
        const double v276 = (w1[i + 1] - w1[i]) * v270;
        const double v279 = sqrt(squared(v271) + squared(v276));
        const double v280 = sqrt(v279);
        const double v281 = 1.0 / v280;
        const double v282 = 2.0 * v281;
        const double v284 = p[7] / v19;
        const double v287 = 1.0 / v279;
        const double v288 = ((v282 * v284) * v1) * v287;
        const double v291 = v282 * v281;
        const double v295 = 1.0 / (2.0 * v279);
        const double v296 = ((2.0 * v271) * v270) * v295;
        const double v298 = 1.0 / (2.0 * v280);
        const double v304 = v288 * v287;
        const double v306 = ((v1 * (v284 * (v291 * (v296 * v298)))) * v287) + (v304 * v296);
        const double v307 = v271 * v306;
        const double v308 = v288 * v270;
        const double v315 = ((2.0 * v276) * v270) * v295;
        const double v322 = ((v1 * (v284 * (v291 * (v315 * v298)))) * v287) + (v304 * v315);
        const double v323 = v271 * v322;
        const double v328 = v276 * v306;
        const double v331 = v276 * v322;
        const double v337 = g[9 * i + 1] * p[0];
        const double v344 = 0.5 * (v337 * v103);
        const double v348 = 0.5 * (v337 * (v7 * v50));
        const double v357 = 0.5 * (v337 * ((v10 - (v3 * v56)) - (v7 * v75)));
        const double v362 = 0.5 * (v337 * (v30 - (v7 * v81)));
        const double v368 = (((v357 * v79) - (v362 * v83)) - (v344 * v86)) - (v348 * v89);
        const double v371 = 0.5 * (v337 * (v7 * v92));
        const double v377 = 0.5 * (v337 * (v1 + (v7 * v104)));
        const double v386 = (((v357 * v111) - (v362 * v113)) - (v344 * v116)) - (v348 * v119);
        const double v398 = (((v357 * v132) - (v362 * v134)) - (v344 * v137)) - (v348 * v140);
        const double v407 = (((v357 * v146) - (v362 * v148)) - (v344 * v151)) - (v348 * v154);
        const double v416 = (((v357 * v160) - (v362 * v162)) - (v344 * v165)) - (v348 * v168);
        const double v425 = (((v357 * v174) - (v362 * v176)) - (v344 * v179)) - (v348 * v182);
        w9[i] = v40;
        w47[i] = v110;
        w48[i] = v128;
        w49[i] = v145;
        w50[i] = v159;
        w51[i] = v173;
        w52[i] = v187;
        w10[i] = v190;
        w53[i] = v216;
        w54[i] = v228;
        w55[i] = v238;
        w56[i] = v247;
        w57[i] = v256;
        w58[i] = v265;
        w11[i] = v40 + (v288 * v271);
        w59[i] = v110;
        w60[i] = v128;
        w61[i] = v145 + (v307 - v308);
        w62[i] = v159 + (v308 - v307);
        w63[i] = v173 + v323;
        w64[i] = v187 - v323;
        w12[i] = v190 + (v288 * v276);
        w65[i] = v216;
        w66[i] = v228;
        w67[i] = v238 + v328;
        w68[i] = v247 - v328;
        w69[i] = v256 + (v331 - v308);
        w70[i] = v265 + (v308 - v331);
        w13[i] = (v337 * ((v10 * v3) - (v7 * v30))) * 0.5;
        w71[i] = (v368 - (v371 * v94)) + (v377 * v108);
        w72[i] = (v386 - (v371 * v122)) + (v377 * v126);
        w73[i] = v398 + (v377 * v143);
        w74[i] = v407 + (v377 * v157);
        w75[i] = v416 + (v377 * v171);
        w76[i] = v425 + (v377 * v185);
        w14[i] = -v25;
        w77[i] = (v69 * v79) - (v47 * v89);
        w78[i] = (v69 * v111) - (v47 * v119);
        w79[i] = (v69 * v132) - (v47 * v140);
        w80[i] = (v69 * v146) - (v47 * v154);
        w81[i] = (v69 * v160) - (v47 * v168);
        w82[i] = (v69 * v174) - (v47 * v182);
        for (int k = 0; k < FIBRES; k++) {
            const double v43 = each0[FIBRES * i + k];
            const double v52 = each1[FIBRES * i + k];
            const double v54 = (v42 * v43) + (v51 * v52);
            const double v129 = each2[FIBRES * i + k];
            const double v131 = -(v107 * v129);
            const double v194 = (v106 * v43) + (v192 * v52);
            const double v229 = v214 * v129;
            each3[FIBRES * i + k] = v54;
            each4[FIBRES * i + k] = v131;
            each5[FIBRES * i + k] = v194;
            each6[FIBRES * i + k] = v229;
            each7[FIBRES * i + k] = v54;
            each8[FIBRES * i + k] = v131;
            each9[FIBRES * i + k] = v194;
            each10[FIBRES * i + k] = v229;
            each11[FIBRES * i + k] = -((v344 * v43) + (v348 * v52));
            each12[FIBRES * i + k] = v377 * v129;
            each13[FIBRES * i + k] = -(v47 * v52);
        }
    }
}

static void jacobian_7(int n, const double *p, const double *g, double *w, double *e)
{
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
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
    double *restrict each9 = w + (SCRATCH + 9 * FIBRES) * n;
    double *restrict each10 = w + (SCRATCH + 10 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    double *restrict each12 = w + (SCRATCH + 12 * FIBRES) * n;
    double *restrict each13 = w + (SCRATCH + 13 * FIBRES) * n;
    const double c1 = squared(p[8]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c91 = 0.0625 * c4;
    const double c93 = squared(p[1]);
    const double c94 = c91 * c93;
    const double c95 = c94 * c2;
    const double c96 = c1 / c95;
    const double c100 = squared(c2);
    const double c101 = c4 * c100;
    const double c102 = c94 / c101;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[9 * i + 6];
        const double v103 = (c96 * g[9 * i + 5]) * c102;
        const double v126 = ((v103 * w77[i]) - (v103 * w78[i - 1])) + (v103 * w72[i - 1]);
        const double v151 = ((v103 * w79[i]) - (v103 * w80[i - 1])) + (v103 * w74[i - 1]);
        const double v172 = ((v103 * w81[i]) - (v103 * w82[i - 1])) + (v103 * w76[i - 1]);
        e[ENTRIES * i + 4] = -(v9 * w59[i - 1]);
        e[ENTRIES * i + 7] = (v9 * w59[i]) - (v9 * w60[i - 1]);
        e[ENTRIES * i + 10] = v9 * w60[i];
        e[ENTRIES * i + 2] = -(v9 * w61[i - 1]);
        e[ENTRIES * i + 5] = (v9 * w61[i]) - (v9 * w62[i - 1]);
        e[ENTRIES * i + 8] = v9 * w62[i];
        e[ENTRIES * i + 3] = -(v9 * w63[i - 1]);
        e[ENTRIES * i + 6] = (v9 * w63[i]) - (v9 * w64[i - 1]);
        e[ENTRIES * i + 9] = v9 * w64[i];
        e[ENTRIES * i + 13] = -(v9 * w65[i - 1]);
        e[ENTRIES * i + 16] = (v9 * w65[i]) - (v9 * w66[i - 1]);
        e[ENTRIES * i + 19] = v9 * w66[i];
        e[ENTRIES * i + 11] = -(v9 * w67[i - 1]);
        e[ENTRIES * i + 14] = (v9 * w67[i]) - (v9 * w68[i - 1]);
        e[ENTRIES * i + 17] = v9 * w68[i];
        e[ENTRIES * i + 12] = -(v9 * w69[i - 1]);
        e[ENTRIES * i + 15] = (v9 * w69[i]) - (v9 * w70[i - 1]);
        e[ENTRIES * i + 18] = v9 * w70[i];
        e[ENTRIES * i + 22] = (v103 * w71[i - 1]) - (v103 * w77[i - 1]);
        e[ENTRIES * i + 25] = v126 + (v103 * w71[i]);
        e[ENTRIES * i + 28] = (v103 * w78[i]) + (v103 * w72[i]);
        e[ENTRIES * i + 20] = (v103 * w73[i - 1]) - (v103 * w79[i - 1]);
        e[ENTRIES * i + 23] = v151 + (v103 * w73[i]);
        e[ENTRIES * i + 26] = (v103 * w80[i]) + (v103 * w74[i]);
        e[ENTRIES * i + 21] = (v103 * w75[i - 1]) - (v103 * w81[i - 1]);
        e[ENTRIES * i + 24] = v172 + (v103 * w75[i]);
        e[ENTRIES * i + 27] = (v103 * w82[i]) + (v103 * w76[i]);
        for (int k = 0; k < FIBRES; k++) {
            const double v108 = (v103 * each11[FIBRES * (i - 1) + k]) - (v103 * each13[FIBRES * (i - 1) + k]);
            const double v113 = (v103 * each13[FIBRES * i + k]) + (v103 * each11[FIBRES * i + k]);
            e[ENTRIES * i + 29 + k] = -(v9 * each7[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 2 * FIBRES + k] = v9 * each7[FIBRES * i + k];
            e[ENTRIES * i + 29 + 1 * FIBRES + k] = -(v9 * each8[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 3 * FIBRES + k] = v9 * each8[FIBRES * i + k];
            e[ENTRIES * i + 29 + 4 * FIBRES + k] = -(v9 * each9[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 6 * FIBRES + k] = v9 * each9[FIBRES * i + k];
            e[ENTRIES * i + 29 + 5 * FIBRES + k] = -(v9 * each10[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 7 * FIBRES + k] = v9 * each10[FIBRES * i + k];
            e[ENTRIES * i + 29 + 8 * FIBRES + k] = v108;
            e[ENTRIES * i + 29 + 10 * FIBRES + k] = v113;
            e[ENTRIES * i + 29 + 9 * FIBRES + k] = v103 * each12[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 11 * FIBRES + k] = v103 * each12[FIBRES * i + k];
        }
    }
}

static void work_0(int n, const double *p, const double *g, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w83 = w + 83 * n;
    const double c1 = p[4];
    const double c23 = 0.9 * c1;
    const double c26 = 2.0 * p[6];
    const double c27 = 2.0 + c26;
    const double c28 = c23 / c27;
    const double c38 = 1e-12 * c1;
    const double c39 = squared(c38);
    const double c42 = 1.0 / p[5];
    for (int i = 0; i < n - 1; i++) {
        double sum9 = 0.0;
        const double v4 = (-0.5) * w5[i];
        const double v9 = p[1] * g[9 * i + 8];
        const double v11 = w3[i];
        const double v13 = sqrt(v11) * v11;
        const double v17 = log(v11);
        const double v30 = w4[i] / v11;
        for (int k = 0; k < FIBRES; k++) {
            const double v18 = ((((v4 * zeta[k]) * v9) / v13) - y[SLOTS * i + 5 + k]) + v17;
            const double v35 = 3.0 * squared((c28 * (v30 - y[SLOTS * i + 5 + 1 * FIBRES + k])));
            const double v45 = (larger(squared((c1 * v18)) + v35, c39) * c42) * weight[k];
            sum9 += v45;
        }
        w83[i] = sum9;
    }
}

static void work_1(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w83 = w + 83 * n;
    const double c6 = p[8];
    const double c9 = p[0] / c6;
    const double c10 = squared(c9);
    const double c11 = p[2] * c10;
    const double c12 = c6 / c11;
    for (int i = 0; i < n - 1; i++) {
        q[0] += ((g[9 * i + 1] * squared(g[9 * i + 8])) * w83[i]) * c12;
    }
}

static void work_slope_0(int n, const double *p, const double *g, const double *y, double *w)
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
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    const double c1 = p[4];
    const double c23 = 1e-12 * c1;
    const double c24 = squared(c23);
    const double c28 = 0.9 * c1;
    const double c31 = 2.0 * p[6];
    const double c32 = 2.0 + c31;
    const double c33 = c28 / c32;
    const double c48 = p[5];
    const double c116 = 1.0 / c48;
    for (int i = 0; i < n - 1; i++) {
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum12 = 0.0;
        double sum9 = 0.0;
        const double v4 = (-0.5) * w5[i];
        const double v9 = p[1] * g[9 * i + 8];
        const double v11 = w3[i];
        const double v12 = sqrt(v11);
        const double v14 = 1.0 / (v12 * v11);
        const double v18 = log(v11);
        const double v35 = 1.0 / v11;
        const double v36 = w4[i] * v35;
        const double v100 = v36 * v35;
        const double v108 = 2.0 * v12;
        for (int k = 0; k < FIBRES; k++) {
            const double v5 = zeta[k];
            const double v15 = ((v4 * v5) * v9) * v14;
            const double v20 = c1 * ((v15 - y[SLOTS * i + 5 + k]) + v18);
            const double v39 = c33 * (v36 - y[SLOTS * i + 5 + 1 * FIBRES + k]);
            const double v42 = squared(v20) + (3.0 * squared(v39));
            const double v43 = (double)(c24 <= v42);
            const double v47 = weight[k];
            const double v50 = (v43 / (v43 + (double)(v42 <= c24))) * (v47 / c48);
            const double v52 = c1 * ((2.0 * v20) * v50);
            const double v76 = c33 * ((2.0 * v39) * (3.0 * v50));
            const double v104 = (v15 * v14) * v52;
            const double v110 = (((v52 * v35) - (v100 * v76)) - (v12 * v104)) - ((v11 * v104) / v108);
            each14[FIBRES * i + k] = -v52;
            each15[FIBRES * i + k] = -v76;
            sum10 += v76 * v35;
            sum11 += v110;
            sum12 += (-0.5) * (v5 * (v9 * (v52 * v14)));
            sum9 += (larger(v42, c24) * c116) * v47;
        }
        const double v54 = sum10;
        const double v57 = sum11;
        const double v61 = sum12;
        w83[i] = sum9;
        w84[i] = ((v54 * w21[i]) + (v57 * w15[i])) + (v61 * w27[i]);
        w85[i] = ((v54 * w22[i]) + (v57 * w16[i])) + (v61 * w28[i]);
        w86[i] = (v54 * w23[i]) + (v57 * w17[i]);
        w87[i] = (v54 * w24[i]) + (v57 * w18[i]);
        w88[i] = (v54 * w25[i]) + (v57 * w19[i]);
        w89[i] = (v54 * w26[i]) + (v57 * w20[i]);
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
    double *restrict each14 = w + (SCRATCH + 14 * FIBRES) * n;
    double *restrict each15 = w + (SCRATCH + 15 * FIBRES) * n;
    const double c0 = p[8];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v11 = c6 * (g[9 * i + 1] * squared(g[9 * i + 8]));
        s[SLOTS * i + 4] += v11 * w84[i];
        s[SLOTS * (i + 1) + 4] += v11 * w85[i];
        s[SLOTS * i + 0] += v11 * w86[i];
        s[SLOTS * (i + 1) + 0] += v11 * w87[i];
        s[SLOTS * i + 1] += v11 * w88[i];
        s[SLOTS * (i + 1) + 1] += v11 * w89[i];
        for (int k = 0; k < FIBRES; k++) {
            s[SLOTS * i + 5 + k] += v11 * each14[FIBRES * i + k];
            s[SLOTS * i + 5 + 1 * FIBRES + k] += v11 * each15[FIBRES * i + k];
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
    rates_1(n, y, w);
    rates_2(n, w);
    rates_3(n, w);
    rates_4(n, p, g, w);
    rates_5(n, p, g, y, w, f);
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
    (void)t;
    for (int k = 0; k < n * ENTRIES; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, y, w);
    jacobian_2(n, w);
    jacobian_3(n, w);
    jacobian_4(n, p, g, w);
    jacobian_5(n, p, g, y, w, e);
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
    (void)t;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, g, y, w);
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
    work_slope_0(n, p, g, y, w);
    work_slope_1(n, p, g, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {
    2, 3, -1, -1, -1, -1, -1, -1, -1};
static const int differential[] = {
    1, 1, 1, 1, 0, 1, 1, 1, 1};
static const int held_first[] = {
    1, 1, 1, 1, 1, 0, 0, 0, 0};
static const int held_last[] = {
    1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int row[] = {
    0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 2, 2,
    2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 5, 6, 5, 6, 5, 6, 5,
    6, 5, 6, 5, 6, 7, 8, 7, 8, 7, 8, 7, 8, 7, 8, 7, 8, 7, 8};
static const int offset[] = {
    0, 0, -1, -1, -1, 0, 0, 0, 1, 1, 1, -1, -1, -1, 0, 0, 0, 1, 1, 1, -1, -1, -1, 0, 0, 0, 1, 1,
    1, -1, -1, -1, -1, 0, 0, 0, 0, -1, -1, -1, -1, 0, 0, 0, 0, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
static const int column[] = {
    2, 3, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 5, 6,
    7, 8, 5, 6, 7, 8, 5, 6, 7, 8, 5, 6, 7, 8, 5, 6, 7, 8, 5, 6, 7, 8, 0, 0, 1, 1, 4, 4, 5, 6, 0,
    0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4, 7, 8, 0, 0, 1, 1, 4, 4};

const softcat_model softcat_filament_model = {
    9, 4, 9, 9, 122, 81, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "youngs_modulus", "viscosity", "poisson",
    "surface_tension", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa", "Pa*s", "1", "N/m", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.08, 0.003, 950.0, 9.81, 300000.0, 3000.0, 0.45, 0.03, 0.09030472819714618};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0", "axial_1", "shear_0", "shear_1"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS,
    SOFTCAT_PLACE_H_NODE, SOFTCAT_PLACE_H_CELL};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, (-0.4999999999999998), 0.5000000000000001, 0.0, 0.0};
static const double described_thickness[] = {
    1.0, 0.9, 0.8, 0.7, 0.6};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "String of hot glue, thin at one end",
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
    .profiled = 1,
    .places = described_places,
    .x = 0,
    .y = 1,
    .psi = 4,
    .rest_length = 0,
    .time_scale = 8,
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
    .thickness = described_thickness,
    .thickness_count = 5,
    .grading = 3.0,
    .relative = 1.2e-05,
    .absolute = 1.2000000000000002e-07,
    .towards_middle = 0,
    .duration = 0.6,
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
