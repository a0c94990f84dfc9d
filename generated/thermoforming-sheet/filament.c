/*
 * Plastic sheet that droops in a thermoforming oven
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, gravity-ramp, shear
 * Digest of the structure: 8287e2b84bd0f6177a7db81485a4e9d8cdcc63a65428ff12299c0d0a34e713e6
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES 2
#define SLOTS 9
#define ENTRIES 81
#define SCRATCH 76

/* Coordinate of each fibre, from -1 to 1 through the thickness, and its share of the section. */
static const double zeta[] = {
    (-0.5773502691896257), 0.5773502691896257};
static const double weight[] = {
    0.5, 0.5};

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
    const double c4 = p[6];
    const double c5 = 0.75 / c4;
    const double c6 = p[5];
    const double c8 = p[7];
    const double c9 = squared(c8);
    const double c10 = 1.0 - c9;
    const double c11 = c6 / c10;
    const double c14 = (-0.5) * p[1];
    const double c28 = p[8];
    const double c31 = 3.0 / c4;
    const double c33 = 0.8333333333333334 * c6;
    const double c35 = 2.0 * c8;
    const double c36 = 2.0 + c35;
    const double c37 = c33 / c36;
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v16 = c14 * w5[i];
        const double v19 = w3[i];
        const double v20 = squared(v19);
        const double v24 = log(v19);
        const double v39 = w4[i] / v19;
        for (int k = 0; k < FIBRES; k++) {
            const double v17 = zeta[k];
            const double v26 = c11 * ((((v16 * v17) / v20) - y[SLOTS * i + 5 + k]) + v24);
            const double v42 = c37 * (v39 - y[SLOTS * i + 5 + 1 * FIBRES + k]);
            const double v45 = weight[k];
            f[SLOTS * i + 5 + k] = (c5 * v26) * c28;
            f[SLOTS * i + 5 + 1 * FIBRES + k] = (c31 * v42) * c28;
            sum0 += v26 * v45;
            sum1 += v26 * (v45 * v17);
            sum2 += v42 * v45;
        }
        w6[i] = sum0;
        w7[i] = sum1;
        w8[i] = sum2;
    }
}

static void rates_8(int n, const double *p, const double *g, double *w)
{
    double *restrict w1 = w + 1 * n;
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
    const double c12 = 0.5 * p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v4 = w4[i];
        const double v5 = w8[i];
        const double v6 = v5 * v2;
        const double v16 = (c12 * w7[i]) / squared(v1);
        const double v21 = ((w6[i] * v2) - ((v4 * v6) * v2)) + (((2.0 * v16) * w5[i]) * v2);
        const double v26 = (w1[i] + w1[i + 1]) * 0.5;
        const double v27 = cos(v26);
        const double v29 = sin(v26);
        w9[i] = (v21 * v27) - (v6 * v29);
        w10[i] = (v21 * v29) + (v6 * v27);
        w11[i] = ((g[7 * i + 1] * p[0]) * (v5 - (v4 * v21))) * 0.5;
        w12[i] = -v16;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w9 = w + 9 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    const double c4 = squared(p[8]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c7 = p[2];
    const double c8 = c7 * c5;
    const double c9 = c6 / c8;
    const double c22 = 0.08333333333333333 * c7;
    const double c24 = squared(p[1]);
    const double c25 = c22 * c24;
    const double c26 = c25 * c5;
    const double c27 = c4 / c26;
    const double c32 = squared(c5);
    const double c33 = c7 * c32;
    const double c34 = c25 / c33;
    for (int i = 1; i < n - 1; i++) {
        const double v31 = (((w12[i] - w12[i - 1]) + w11[i]) + w11[i - 1]) * (c27 * g[7 * i + 5]);
        f[SLOTS * i + 2] = (w9[i] - w9[i - 1]) * (c9 * g[7 * i + 6]);
        f[SLOTS * i + 4] = v31 * c34;
    }
}

static void rates_10(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w10 = w + 10 * n;
    const double c3 = p[8];
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
        f[SLOTS * i + 3] = ((w10[i] - w10[i - 1]) * (c9 * g[7 * i + 6])) - c34;
    }
}

static void rates_11(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w10 = w + 10 * n;
    const double c1 = p[8];
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
    f[SLOTS * i + 3] = (w10[i] * (c7 * g[7 * i + 6])) - c32;
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
        w13[i] = v25;
        w14[i] = v25;
        w15[i] = v27;
        w16[i] = v26;
        w17[i] = v29;
        w18[i] = v28;
        w4[i] = (v17 * v12) - (v5 * v18);
        w19[i] = v36;
        w20[i] = v36;
        w21[i] = v28;
        w22[i] = v29;
        w23[i] = v27;
        w24[i] = v26;
        w5[i] = (v7 - v6) * v40;
        w25[i] = -v40;
        w26[i] = v40;
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
    double *restrict each0 = w + (SCRATCH) * n;
    double *restrict each1 = w + (SCRATCH + 1 * FIBRES) * n;
    double *restrict each2 = w + (SCRATCH + 2 * FIBRES) * n;
    const double c1 = p[5];
    const double c3 = p[7];
    const double c4 = squared(c3);
    const double c5 = 1.0 - c4;
    const double c6 = c1 / c5;
    const double c59 = 0.8333333333333334 * c1;
    const double c61 = 2.0 * c3;
    const double c62 = 2.0 + c61;
    const double c63 = c59 / c62;
    const double c82 = p[8];
    const double c84 = p[6];
    const double c85 = 0.75 / c84;
    const double c86 = c85 * c6;
    const double c87 = c82 * c86;
    const double c88 = -c87;
    const double c93 = (-0.5) * p[1];
    const double c123 = 3.0 / c84;
    const double c139 = c123 * c63;
    const double c140 = c82 * c139;
    const double c141 = -c140;
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
        const double v11 = w13[i];
        const double v14 = w25[i];
        const double v17 = w14[i];
        const double v19 = w26[i];
        const double v22 = w15[i];
        const double v24 = w16[i];
        const double v26 = w17[i];
        const double v28 = w18[i];
        const double v49 = w19[i];
        const double v54 = w20[i];
        const double v66 = w21[i];
        const double v70 = w22[i];
        const double v74 = w23[i];
        const double v78 = w24[i];
        const double v89 = w3[i];
        const double v90 = 1.0 / v89;
        const double v95 = c93 * w5[i];
        const double v98 = 1.0 / squared(v89);
        const double v101 = 2.0 * v89;
        const double v126 = c82 * (c123 * (c63 * v90));
        const double v129 = w4[i] * v90;
        const double v130 = v129 * v90;
        const double v133 = c82 * (c123 * (c63 * v130));
        const double v156 = log(v89);
        for (int k = 0; k < FIBRES; k++) {
            const double v7 = weight[k];
            const double v8 = c6 * v7;
            const double v31 = zeta[k];
            const double v32 = v7 * v31;
            const double v33 = c6 * v32;
            const double v64 = c63 * v7;
            const double v99 = (v95 * v31) * v98;
            const double v100 = v99 * v98;
            const double v106 = c82 * (c85 * (c6 * (v90 - (v100 * v101))));
            const double v112 = c82 * (c85 * (c6 * ((v31 * c93) * v98)));
            const double v158 = c6 * ((v99 - y[SLOTS * i + 5 + k]) + v156);
            each0[FIBRES * i + k] = -v8;
            each1[FIBRES * i + k] = -v33;
            each2[FIBRES * i + k] = -v64;
            e[ENTRIES * i + 29 + 15 * FIBRES + k] = c88;
            e[ENTRIES * i + 29 + 14 * FIBRES + k] = (v106 * v11) + (v112 * v14);
            e[ENTRIES * i + 29 + 18 * FIBRES + k] = (v106 * v17) + (v112 * v19);
            e[ENTRIES * i + 29 + 12 * FIBRES + k] = v106 * v22;
            e[ENTRIES * i + 29 + 16 * FIBRES + k] = v106 * v24;
            e[ENTRIES * i + 29 + 13 * FIBRES + k] = v106 * v26;
            e[ENTRIES * i + 29 + 17 * FIBRES + k] = v106 * v28;
            e[ENTRIES * i + 29 + 21 * FIBRES + k] = (v126 * v49) - (v133 * v11);
            e[ENTRIES * i + 29 + 25 * FIBRES + k] = (v126 * v54) - (v133 * v17);
            e[ENTRIES * i + 29 + 22 * FIBRES + k] = c141;
            e[ENTRIES * i + 29 + 19 * FIBRES + k] = (v126 * v66) - (v133 * v22);
            e[ENTRIES * i + 29 + 23 * FIBRES + k] = (v126 * v70) - (v133 * v24);
            e[ENTRIES * i + 29 + 20 * FIBRES + k] = (v126 * v74) - (v133 * v26);
            e[ENTRIES * i + 29 + 24 * FIBRES + k] = (v126 * v78) - (v133 * v28);
            sum0 += v158 * v7;
            sum1 += v158 * v32;
            sum2 += (c63 * (v129 - y[SLOTS * i + 5 + 1 * FIBRES + k])) * v7;
            sum3 += (v8 * v90) - (v101 * (v100 * v8));
            sum4 += c93 * (v31 * (v8 * v98));
            sum5 += (v33 * v90) - (v101 * (v100 * v33));
            sum6 += c93 * (v31 * (v33 * v98));
            sum7 += v64 * v90;
            sum8 += -(v130 * v64);
        }
        const double v10 = sum3;
        const double v13 = sum4;
        const double v35 = sum5;
        const double v37 = sum6;
        const double v48 = sum7;
        const double v51 = sum8;
        w6[i] = sum0;
        w27[i] = (v10 * v11) + (v13 * v14);
        w28[i] = (v10 * v17) + (v13 * v19);
        w29[i] = v10 * v22;
        w30[i] = v10 * v24;
        w31[i] = v10 * v26;
        w32[i] = v10 * v28;
        w7[i] = sum1;
        w33[i] = (v35 * v11) + (v37 * v14);
        w34[i] = (v35 * v17) + (v37 * v19);
        w35[i] = v35 * v22;
        w36[i] = v35 * v24;
        w37[i] = v35 * v26;
        w38[i] = v35 * v28;
        w8[i] = sum2;
        w39[i] = (v48 * v49) + (v51 * v11);
        w40[i] = (v48 * v54) + (v51 * v17);
        w41[i] = (v48 * v66) + (v51 * v22);
        w42[i] = (v48 * v70) + (v51 * v24);
        w43[i] = (v48 * v74) + (v51 * v26);
        w44[i] = (v48 * v78) + (v51 * v28);
    }
}

static void jacobian_8(int n, const double *p, const double *g, double *w)
{
    double *restrict w1 = w + 1 * n;
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
    const double c12 = 0.5 * p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w3[i];
        const double v2 = 1.0 / v1;
        const double v3 = w6[i] * v2;
        const double v4 = w4[i];
        const double v5 = w8[i];
        const double v6 = v5 * v2;
        const double v8 = (v4 * v6) * v2;
        const double v16 = 1.0 / squared(v1);
        const double v17 = (c12 * w7[i]) * v16;
        const double v18 = 2.0 * v17;
        const double v19 = w5[i];
        const double v21 = (v18 * v19) * v2;
        const double v22 = (v3 - v8) + v21;
        const double v27 = (w1[i] + w1[i + 1]) * 0.5;
        const double v28 = cos(v27);
        const double v30 = sin(v27);
        const double v33 = v28 * v2;
        const double v36 = c12 * v16;
        const double v39 = (v19 * (2.0 * v36)) * v2;
        const double v40 = v28 * v39;
        const double v44 = v6 * v2;
        const double v45 = v4 * v44;
        const double v53 = (v17 * v16) * (2.0 * v1);
        const double v60 = (((v45 * v2) + (v8 * v2)) - (v3 * v2)) + (((v19 * (2.0 * (-v53))) * v2) - (v21 * v2));
        const double v62 = v30 * v44;
        const double v63 = (v28 * v60) + v62;
        const double v64 = w13[i];
        const double v66 = v28 * v44;
        const double v67 = w19[i];
        const double v70 = w27[i];
        const double v73 = w33[i];
        const double v76 = v18 * v2;
        const double v77 = v28 * v76;
        const double v78 = w25[i];
        const double v80 = ((((v63 * v64) - (v66 * v67)) + (v33 * v70)) + (v40 * v73)) + (v77 * v78);
        const double v81 = 0.5 * v30;
        const double v83 = 0.5 * v28;
        const double v85 = (v22 * v81) + (v6 * v83);
        const double v87 = v4 * v2;
        const double v88 = v87 * v2;
        const double v90 = v30 * v2;
        const double v91 = (v28 * v88) + v90;
        const double v92 = w39[i];
        const double v95 = w14[i];
        const double v97 = w20[i];
        const double v100 = w28[i];
        const double v103 = w34[i];
        const double v105 = (((v63 * v95) - (v66 * v97)) + (v33 * v100)) + (v40 * v103);
        const double v106 = w26[i];
        const double v110 = w40[i];
        const double v116 = w15[i];
        const double v118 = w21[i];
        const double v121 = w29[i];
        const double v124 = w35[i];
        const double v126 = (((v63 * v116) - (v66 * v118)) + (v33 * v121)) + (v40 * v124);
        const double v127 = w41[i];
        const double v130 = w16[i];
        const double v132 = w22[i];
        const double v135 = w30[i];
        const double v138 = w36[i];
        const double v140 = (((v63 * v130) - (v66 * v132)) + (v33 * v135)) + (v40 * v138);
        const double v141 = w42[i];
        const double v144 = w17[i];
        const double v146 = w23[i];
        const double v149 = w31[i];
        const double v152 = w37[i];
        const double v154 = (((v63 * v144) - (v66 * v146)) + (v33 * v149)) + (v40 * v152);
        const double v155 = w43[i];
        const double v158 = w18[i];
        const double v160 = w24[i];
        const double v163 = w32[i];
        const double v166 = w38[i];
        const double v168 = (((v63 * v158) - (v66 * v160)) + (v33 * v163)) + (v40 * v166);
        const double v169 = w44[i];
        const double v176 = v30 * v39;
        const double v180 = (v30 * v60) - v66;
        const double v187 = (((v180 * v64) - (v62 * v67)) + (v90 * v70)) + (v176 * v73);
        const double v188 = v30 * v76;
        const double v193 = (v22 * v83) - (v6 * v81);
        const double v196 = v33 - (v30 * v88);
        const double v205 = (((v180 * v95) - (v62 * v97)) + (v90 * v100)) + (v176 * v103);
        const double v218 = (((v180 * v116) - (v62 * v118)) + (v90 * v121)) + (v176 * v124);
        const double v227 = (((v180 * v130) - (v62 * v132)) + (v90 * v135)) + (v176 * v138);
        const double v236 = (((v180 * v144) - (v62 * v146)) + (v90 * v149)) + (v176 * v152);
        const double v245 = (((v180 * v158) - (v62 * v160)) + (v90 * v163)) + (v176 * v166);
        const double v250 = g[7 * i + 1] * p[0];
        const double v256 = 0.5 * (v250 * v87);
        const double v260 = 0.5 * (v250 * (v4 * v39));
        const double v268 = 0.5 * (v250 * (1.0 + (v4 * v88)));
        const double v272 = 0.5 * (v250 * (v22 - v45));
        const double v276 = 0.5 * (v250 * (v4 * v60));
        const double v282 = (((v272 * v67) + (v276 * v64)) + (v256 * v70)) + (v260 * v73);
        const double v285 = 0.5 * (v250 * (v4 * v76));
        const double v296 = (((v272 * v97) + (v276 * v95)) + (v256 * v100)) + (v260 * v103);
        const double v308 = (((v272 * v118) + (v276 * v116)) + (v256 * v121)) + (v260 * v124);
        const double v317 = (((v272 * v132) + (v276 * v130)) + (v256 * v135)) + (v260 * v138);
        const double v326 = (((v272 * v146) + (v276 * v144)) + (v256 * v149)) + (v260 * v152);
        const double v335 = (((v272 * v160) + (v276 * v158)) + (v256 * v163)) + (v260 * v166);
        w9[i] = (v22 * v28) - (v6 * v30);
        w45[i] = (v80 - v85) - (v91 * v92);
        w46[i] = ((v105 + (v77 * v106)) - v85) - (v91 * v110);
        w47[i] = v126 - (v91 * v127);
        w48[i] = v140 - (v91 * v141);
        w49[i] = v154 - (v91 * v155);
        w50[i] = v168 - (v91 * v169);
        w10[i] = (v22 * v30) + (v6 * v28);
        w51[i] = ((v187 + (v188 * v78)) + v193) + (v196 * v92);
        w52[i] = ((v205 + (v188 * v106)) + v193) + (v196 * v110);
        w53[i] = v218 + (v196 * v127);
        w54[i] = v227 + (v196 * v141);
        w55[i] = v236 + (v196 * v155);
        w56[i] = v245 + (v196 * v169);
        w11[i] = (v250 * (v5 - (v4 * v22))) * 0.5;
        w57[i] = (v268 * v92) - (v282 + (v285 * v78));
        w58[i] = (v268 * v110) - (v296 + (v285 * v106));
        w59[i] = (v268 * v127) - v308;
        w60[i] = (v268 * v141) - v317;
        w61[i] = (v268 * v155) - v326;
        w62[i] = (v268 * v169) - v335;
        w12[i] = -v17;
        w63[i] = (v53 * v64) - (v36 * v73);
        w64[i] = (v53 * v95) - (v36 * v103);
        w65[i] = (v53 * v116) - (v36 * v124);
        w66[i] = (v53 * v130) - (v36 * v138);
        w67[i] = (v53 * v144) - (v36 * v152);
        w68[i] = (v53 * v158) - (v36 * v166);
        for (int k = 0; k < FIBRES; k++) {
            const double v34 = each0[FIBRES * i + k];
            const double v41 = each1[FIBRES * i + k];
            const double v113 = each2[FIBRES * i + k];
            each3[FIBRES * i + k] = (v33 * v34) + (v40 * v41);
            each4[FIBRES * i + k] = -(v91 * v113);
            each5[FIBRES * i + k] = (v90 * v34) + (v176 * v41);
            each6[FIBRES * i + k] = v196 * v113;
            each7[FIBRES * i + k] = -((v256 * v34) + (v260 * v41));
            each8[FIBRES * i + k] = v268 * v113;
            each9[FIBRES * i + k] = -(v36 * v41);
        }
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w45 = w + 45 * n;
    double *restrict w46 = w + 46 * n;
    double *restrict w47 = w + 47 * n;
    double *restrict w48 = w + 48 * n;
    double *restrict w49 = w + 49 * n;
    double *restrict w50 = w + 50 * n;
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
    double *restrict each3 = w + (SCRATCH + 3 * FIBRES) * n;
    double *restrict each4 = w + (SCRATCH + 4 * FIBRES) * n;
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
    double *restrict each9 = w + (SCRATCH + 9 * FIBRES) * n;
    const double c1 = squared(p[8]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c51 = 0.08333333333333333 * c4;
    const double c53 = squared(p[1]);
    const double c54 = c51 * c53;
    const double c55 = c54 * c2;
    const double c56 = c1 / c55;
    const double c60 = squared(c2);
    const double c61 = c4 * c60;
    const double c62 = c54 / c61;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v63 = (c56 * g[7 * i + 5]) * c62;
        const double v86 = ((v63 * w63[i]) - (v63 * w64[i - 1])) + (v63 * w58[i - 1]);
        const double v111 = ((v63 * w65[i]) - (v63 * w66[i - 1])) + (v63 * w60[i - 1]);
        const double v132 = ((v63 * w67[i]) - (v63 * w68[i - 1])) + (v63 * w62[i - 1]);
        e[ENTRIES * i + 4] = -(v9 * w45[i - 1]);
        e[ENTRIES * i + 7] = (v9 * w45[i]) - (v9 * w46[i - 1]);
        e[ENTRIES * i + 10] = v9 * w46[i];
        e[ENTRIES * i + 2] = -(v9 * w47[i - 1]);
        e[ENTRIES * i + 5] = (v9 * w47[i]) - (v9 * w48[i - 1]);
        e[ENTRIES * i + 8] = v9 * w48[i];
        e[ENTRIES * i + 3] = -(v9 * w49[i - 1]);
        e[ENTRIES * i + 6] = (v9 * w49[i]) - (v9 * w50[i - 1]);
        e[ENTRIES * i + 9] = v9 * w50[i];
        e[ENTRIES * i + 22] = (v63 * w57[i - 1]) - (v63 * w63[i - 1]);
        e[ENTRIES * i + 25] = v86 + (v63 * w57[i]);
        e[ENTRIES * i + 28] = (v63 * w64[i]) + (v63 * w58[i]);
        e[ENTRIES * i + 20] = (v63 * w59[i - 1]) - (v63 * w65[i - 1]);
        e[ENTRIES * i + 23] = v111 + (v63 * w59[i]);
        e[ENTRIES * i + 26] = (v63 * w66[i]) + (v63 * w60[i]);
        e[ENTRIES * i + 21] = (v63 * w61[i - 1]) - (v63 * w67[i - 1]);
        e[ENTRIES * i + 24] = v132 + (v63 * w61[i]);
        e[ENTRIES * i + 27] = (v63 * w68[i]) + (v63 * w62[i]);
        for (int k = 0; k < FIBRES; k++) {
            const double v68 = (v63 * each7[FIBRES * (i - 1) + k]) - (v63 * each9[FIBRES * (i - 1) + k]);
            const double v73 = (v63 * each9[FIBRES * i + k]) + (v63 * each7[FIBRES * i + k]);
            e[ENTRIES * i + 29 + k] = -(v9 * each3[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 2 * FIBRES + k] = v9 * each3[FIBRES * i + k];
            e[ENTRIES * i + 29 + 1 * FIBRES + k] = -(v9 * each4[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 3 * FIBRES + k] = v9 * each4[FIBRES * i + k];
            e[ENTRIES * i + 29 + 8 * FIBRES + k] = v68;
            e[ENTRIES * i + 29 + 10 * FIBRES + k] = v73;
            e[ENTRIES * i + 29 + 9 * FIBRES + k] = v63 * each8[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 11 * FIBRES + k] = v63 * each8[FIBRES * i + k];
        }
    }
}

static void jacobian_10(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w51 = w + 51 * n;
    double *restrict w52 = w + 52 * n;
    double *restrict w53 = w + 53 * n;
    double *restrict w54 = w + 54 * n;
    double *restrict w55 = w + 55 * n;
    double *restrict w56 = w + 56 * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    const double c1 = squared(p[8]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[ENTRIES * i + 13] = -(v9 * w51[i - 1]);
        e[ENTRIES * i + 16] = (v9 * w51[i]) - (v9 * w52[i - 1]);
        e[ENTRIES * i + 19] = v9 * w52[i];
        e[ENTRIES * i + 11] = -(v9 * w53[i - 1]);
        e[ENTRIES * i + 14] = (v9 * w53[i]) - (v9 * w54[i - 1]);
        e[ENTRIES * i + 17] = v9 * w54[i];
        e[ENTRIES * i + 12] = -(v9 * w55[i - 1]);
        e[ENTRIES * i + 15] = (v9 * w55[i]) - (v9 * w56[i - 1]);
        e[ENTRIES * i + 18] = v9 * w56[i];
        for (int k = 0; k < FIBRES; k++) {
            e[ENTRIES * i + 29 + 4 * FIBRES + k] = -(v9 * each5[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 6 * FIBRES + k] = v9 * each5[FIBRES * i + k];
            e[ENTRIES * i + 29 + 5 * FIBRES + k] = -(v9 * each6[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 7 * FIBRES + k] = v9 * each6[FIBRES * i + k];
        }
    }
}

static void jacobian_11(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w51 = w + 51 * n;
    double *restrict w52 = w + 52 * n;
    double *restrict w53 = w + 53 * n;
    double *restrict w54 = w + 54 * n;
    double *restrict w55 = w + 55 * n;
    double *restrict w56 = w + 56 * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    const double c1 = squared(p[8]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[ENTRIES * i + 16] = v9 * w51[i];
    e[ENTRIES * i + 19] = v9 * w52[i];
    e[ENTRIES * i + 14] = v9 * w53[i];
    e[ENTRIES * i + 17] = v9 * w54[i];
    e[ENTRIES * i + 15] = v9 * w55[i];
    e[ENTRIES * i + 18] = v9 * w56[i];
    for (int k = 0; k < FIBRES; k++) {
        e[ENTRIES * i + 29 + 6 * FIBRES + k] = v9 * each5[FIBRES * i + k];
        e[ENTRIES * i + 29 + 7 * FIBRES + k] = v9 * each6[FIBRES * i + k];
    }
    (void)n;
}

static void work_0(int n, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w69 = w + 69 * n;
    const double c3 = p[5];
    const double c4 = 0.8333333333333334 * c3;
    const double c6 = p[7];
    const double c7 = 2.0 * c6;
    const double c8 = 2.0 + c7;
    const double c9 = c4 / c8;
    const double c20 = squared(c6);
    const double c21 = 1.0 - c20;
    const double c22 = c3 / c21;
    const double c25 = (-0.5) * p[1];
    const double c41 = 1e-12 * c3;
    const double c42 = squared(c41);
    const double c45 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum9 = 0.0;
        const double v11 = w3[i];
        const double v12 = w4[i] / v11;
        const double v27 = c25 * w5[i];
        const double v30 = squared(v11);
        const double v34 = log(v11);
        for (int k = 0; k < FIBRES; k++) {
            const double v17 = 3.0 * squared((c9 * (v12 - y[SLOTS * i + 5 + 1 * FIBRES + k])));
            const double v36 = c22 * ((((v27 * zeta[k]) / v30) - y[SLOTS * i + 5 + k]) + v34);
            const double v48 = (larger(v17 + (0.75 * squared(v36)), c42) * c45) * weight[k];
            sum9 += v48;
        }
        w69[i] = sum9;
    }
}

static void work_1(int n, double t, const double *p, const double *g, double *w, double *q)
{
    double *restrict w2 = w + 2 * n;
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = 30.0 * p[3];
    const double c10 = p[8];
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
    double *restrict w69 = w + 69 * n;
    const double c3 = p[8];
    const double c6 = p[0] / c3;
    const double c7 = squared(c6);
    const double c8 = p[2] * c7;
    const double c9 = c3 / c8;
    for (int i = 0; i < n - 1; i++) {
        q[0] += (g[7 * i + 1] * w69[i]) * c9;
    }
}

static void work_slope_0(int n, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
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
    double *restrict w69 = w + 69 * n;
    double *restrict w70 = w + 70 * n;
    double *restrict w71 = w + 71 * n;
    double *restrict w72 = w + 72 * n;
    double *restrict w73 = w + 73 * n;
    double *restrict w74 = w + 74 * n;
    double *restrict w75 = w + 75 * n;
    double *restrict each10 = w + (SCRATCH + 10 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    const double c1 = p[5];
    const double c3 = p[7];
    const double c4 = squared(c3);
    const double c5 = 1.0 - c4;
    const double c6 = c1 / c5;
    const double c9 = (-0.5) * p[1];
    const double c26 = 1e-12 * c1;
    const double c27 = squared(c26);
    const double c30 = 0.8333333333333334 * c1;
    const double c32 = 2.0 * c3;
    const double c33 = 2.0 + c32;
    const double c34 = c30 / c33;
    const double c51 = p[6];
    const double c116 = 1.0 / c51;
    for (int i = 0; i < n - 1; i++) {
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum12 = 0.0;
        double sum9 = 0.0;
        const double v11 = c9 * w5[i];
        const double v14 = w3[i];
        const double v16 = 1.0 / squared(v14);
        const double v20 = log(v14);
        const double v36 = 1.0 / v14;
        const double v37 = w4[i] * v36;
        const double v104 = 2.0 * v14;
        const double v109 = v37 * v36;
        for (int k = 0; k < FIBRES; k++) {
            const double v12 = zeta[k];
            const double v17 = (v11 * v12) * v16;
            const double v22 = c6 * ((v17 - y[SLOTS * i + 5 + k]) + v20);
            const double v40 = c34 * (v37 - y[SLOTS * i + 5 + 1 * FIBRES + k]);
            const double v45 = (3.0 * squared(v40)) + (0.75 * squared(v22));
            const double v46 = (double)(c27 <= v45);
            const double v50 = weight[k];
            const double v53 = (v46 / (v46 + (double)(v45 <= c27))) * (v50 / c51);
            const double v56 = c6 * ((2.0 * v22) * (0.75 * v53));
            const double v80 = c34 * ((2.0 * v40) * (3.0 * v53));
            const double v111 = ((v56 * v36) - (v104 * ((v17 * v16) * v56))) - (v109 * v80);
            each10[FIBRES * i + k] = -v56;
            each11[FIBRES * i + k] = -v80;
            sum10 += v80 * v36;
            sum11 += v111;
            sum12 += c9 * (v12 * (v56 * v16));
            sum9 += (larger(v45, c27) * c116) * v50;
        }
        const double v58 = sum10;
        const double v61 = sum11;
        const double v65 = sum12;
        w69[i] = sum9;
        w70[i] = ((v58 * w19[i]) + (v61 * w13[i])) + (v65 * w25[i]);
        w71[i] = ((v58 * w20[i]) + (v61 * w14[i])) + (v65 * w26[i]);
        w72[i] = (v58 * w21[i]) + (v61 * w15[i]);
        w73[i] = (v58 * w22[i]) + (v61 * w16[i]);
        w74[i] = (v58 * w23[i]) + (v61 * w17[i]);
        w75[i] = (v58 * w24[i]) + (v61 * w18[i]);
    }
}

static void work_slope_1(int n, double t, const double *p, const double *g, double *s)
{
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = 30.0 * p[3];
    const double c10 = p[8];
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
    double *restrict w70 = w + 70 * n;
    double *restrict w71 = w + 71 * n;
    double *restrict w72 = w + 72 * n;
    double *restrict w73 = w + 73 * n;
    double *restrict w74 = w + 74 * n;
    double *restrict w75 = w + 75 * n;
    double *restrict each10 = w + (SCRATCH + 10 * FIBRES) * n;
    double *restrict each11 = w + (SCRATCH + 11 * FIBRES) * n;
    const double c0 = p[8];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v8 = c6 * g[7 * i + 1];
        s[SLOTS * i + 4] += v8 * w70[i];
        s[SLOTS * (i + 1) + 4] += v8 * w71[i];
        s[SLOTS * i + 0] += v8 * w72[i];
        s[SLOTS * (i + 1) + 0] += v8 * w73[i];
        s[SLOTS * i + 1] += v8 * w74[i];
        s[SLOTS * (i + 1) + 1] += v8 * w75[i];
        for (int k = 0; k < FIBRES; k++) {
            s[SLOTS * i + 5 + k] += v8 * each10[FIBRES * i + k];
            s[SLOTS * i + 5 + 1 * FIBRES + k] += v8 * each11[FIBRES * i + k];
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
    rates_10(n, t, p, g, w, f);
    rates_11(n, t, p, g, w, f);
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
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, y, w);
    work_1(n, t, p, g, w, q);
    work_2(n, p, g, w, q);
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
    return SOFTCAT_SOLVED;
}

static const int rate[] = {
    2, 3, -1, -1, -1, -1, -1, -1, -1};
static const int differential[] = {
    1, 1, 1, 1, 0, 1, 1, 1, 1};
static const int held_first[] = {
    1, 0, 1, 0, 1, 0, 0, 0, 0};
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
    9, 4, 9, 7, 100, 81, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "ramp", "youngs_modulus", "viscosity",
    "poisson", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "s", "Pa", "Pa*s", "1", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON,
    SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.5, 0.003, 1000.0, 9.81, 3.0, 600000.0, 3000000.0, 0.49, 0.22576182049286544};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0", "axial_1", "shear_0", "shear_1"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, (-0.5773502691896257), 0.5773502691896257, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Plastic sheet that droops in a thermoforming oven",
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
    .thickness = 0,
    .thickness_count = 0,
    .grading = 3.0,
    .relative = 1.2e-05,
    .absolute = 1.2000000000000002e-07,
    .towards_middle = 0,
    .duration = 30.0,
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
