/*
 * Ink strand that shrank as it dried
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres
 * Digest of the structure: 99ecfac5c900f5eae35ff0e8438d47d1d3074089bc99fdc993cdf7f35fadeb73
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES 16
#define SLOTS 37
#define ENTRIES 477
#define SCRATCH 76

/* Coordinate of each fibre, from -1 to 1 through the thickness, and its share of the section. */
static const double zeta[] = {
    (-0.9686578935148324), (-0.8784890847806422), (-0.7406139298699932), (-0.5721146443791073),
    (-0.394041993763766), (-0.2289535525667885), (-0.09821234188930718),
    (-0.019199555780713324), 0.019199555780713324, 0.09821234188930718, 0.2289535525667885,
    0.394041993763766, 0.5721146443791073, 0.7406139298699932, 0.8784890847806422,
    0.9686578935148324};
static const double weight[] = {
    0.009809717052572466, 0.03541208817516074, 0.06691987890833648, 0.0924224995935702,
    0.1025893691493575, 0.09372308379650839, 0.06797964202358955, 0.031143721300904526,
    0.031143721300904526, 0.06797964202358955, 0.09372308379650839, 0.1025893691493575,
    0.0924224995935702, 0.06691987890833648, 0.03541208817516074, 0.009809717052572466};

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
    const double c3 = p[7];
    const double c5 = p[5];
    const double c6 = 0.5 * c5;
    const double c27 = 0.45 * c5;
    const double c30 = 2.0 * p[8];
    const double c31 = 2.0 + c30;
    const double c32 = c27 / c31;
    const double c43 = 1e-12 * c5;
    const double c44 = squared(c43);
    const double c50 = 1.0 / p[6];
    const double c54 = p[9];
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
    const double c0 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v2 = w7[i];
        const double v5 = w3[i];
        const double v6 = sqrt(v5);
        const double v8 = 1.0 / (v6 * v5);
        const double v14 = 1.0 / v5;
        const double v17 = w8[i];
        const double v31 = ((((((-0.5) * w5[i]) * v2) * c0) * v8) * v8) * ((v5 / (2.0 * v6)) + v6);
        const double v32 = ((w6[i] * v14) - (((w4[i] * v17) * v14) * v14)) - v31;
        const double v36 = g[7 * i + 4];
        const double v37 = (w2[i + 1] - w2[i]) * v36;
        const double v43 = (w1[i] + w1[i + 1]) * 0.5;
        const double v44 = cos(v43);
        const double v49 = (w0[i + 1] - w0[i]) * v36;
        const double v50 = sin(v43);
        const double v54 = v17 * v14;
        const double v59 = (v32 * ((v37 * v44) - (v49 * v50))) - (v54 * ((v37 * v50) + (v49 * v44)));
        w9[i] = (c0 * ((-0.5) * v2)) * v8;
        w10[i] = -(((g[7 * i + 1] * p[0]) * v59) * 0.5);
        w11[i] = (v32 * v44) - (v54 * v50);
        w12[i] = (v32 * v50) + (v54 * v44);
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
    const double c4 = squared(p[9]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c7 = p[2];
    const double c8 = c7 * c5;
    const double c9 = c6 / c8;
    const double c21 = squared(c5);
    const double c22 = c7 * c21;
    const double c23 = c22 * c5;
    const double c24 = c4 / c23;
    for (int i = 1; i < n - 1; i++) {
        const double v28 = (((w9[i] + w10[i]) - w9[i - 1]) + w10[i - 1]) * (c24 * g[7 * i + 5]);
        f[SLOTS * i + 2] = (w11[i] - w11[i - 1]) * (c9 * g[7 * i + 6]);
        f[SLOTS * i + 4] = v28;
    }
}

static void rates_10(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w12 = w + 12 * n;
    const double c3 = p[9];
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
        f[SLOTS * i + 3] = ((w12[i] - w12[i - 1]) * (c9 * g[7 * i + 6])) - c34;
    }
}

static void rates_11(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w12 = w + 12 * n;
    const double c1 = p[9];
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
    f[SLOTS * i + 3] = (w12[i] * (c7 * g[7 * i + 6])) - c32;
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
        w5[i] = ((v7 - v6) * v4) * c40;
        w25[i] = -(v4 * c40);
        w26[i] = c40 * v4;
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
    const double c2 = p[5];
    const double c3 = 0.5 * c2;
    const double c58 = 0.45 * c2;
    const double c61 = 2.0 * p[8];
    const double c62 = 2.0 + c61;
    const double c63 = c58 / c62;
    const double c83 = p[7];
    const double c88 = p[1];
    const double c114 = 1e-12 * c2;
    const double c115 = squared(c114);
    const double c121 = 1.0 / p[6];
    const double c125 = p[9];
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
        const double v9 = w13[i];
        const double v12 = w25[i];
        const double v15 = w14[i];
        const double v17 = w26[i];
        const double v20 = w15[i];
        const double v22 = w16[i];
        const double v24 = w17[i];
        const double v26 = w18[i];
        const double v48 = w19[i];
        const double v53 = w20[i];
        const double v67 = w21[i];
        const double v71 = w22[i];
        const double v75 = w23[i];
        const double v79 = w24[i];
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
            e[ENTRIES * i + 29 + 15 * FIBRES + k] = v118 != 0.0 ? (-v145) : 0.0;
            e[ENTRIES * i + 29 + 14 * FIBRES + k] = v176;
            e[ENTRIES * i + 29 + 19 * FIBRES + k] = v182;
            e[ENTRIES * i + 29 + 16 * FIBRES + k] = v118 != 0.0 ? (-v152) : 0.0;
            e[ENTRIES * i + 29 + 12 * FIBRES + k] = v118 != 0.0 ? ((v153 * v67) + (v167 * v20)) : 0.0;
            e[ENTRIES * i + 29 + 17 * FIBRES + k] = v118 != 0.0 ? ((v153 * v71) + (v167 * v22)) : 0.0;
            e[ENTRIES * i + 29 + 13 * FIBRES + k] = v118 != 0.0 ? ((v153 * v75) + (v167 * v24)) : 0.0;
            e[ENTRIES * i + 29 + 18 * FIBRES + k] = v118 != 0.0 ? ((v153 * v79) + (v167 * v26)) : 0.0;
            e[ENTRIES * i + 29 + 23 * FIBRES + k] = v118 != 0.0 ? (-v211) : 0.0;
            e[ENTRIES * i + 29 + 22 * FIBRES + k] = v239;
            e[ENTRIES * i + 29 + 27 * FIBRES + k] = v245;
            e[ENTRIES * i + 29 + 24 * FIBRES + k] = v118 != 0.0 ? (-v219) : 0.0;
            e[ENTRIES * i + 29 + 20 * FIBRES + k] = v118 != 0.0 ? ((v220 * v67) + (v230 * v20)) : 0.0;
            e[ENTRIES * i + 29 + 25 * FIBRES + k] = v118 != 0.0 ? ((v220 * v71) + (v230 * v22)) : 0.0;
            e[ENTRIES * i + 29 + 21 * FIBRES + k] = v118 != 0.0 ? ((v220 * v75) + (v230 * v24)) : 0.0;
            e[ENTRIES * i + 29 + 26 * FIBRES + k] = v118 != 0.0 ? ((v220 * v79) + (v230 * v26)) : 0.0;
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
        w6[i] = sum0;
        w27[i] = (v8 * v9) + (v11 * v12);
        w28[i] = (v8 * v15) + (v11 * v17);
        w29[i] = v8 * v20;
        w30[i] = v8 * v22;
        w31[i] = v8 * v24;
        w32[i] = v8 * v26;
        w7[i] = sum1;
        w33[i] = (v34 * v9) + (v36 * v12);
        w34[i] = (v34 * v15) + (v36 * v17);
        w35[i] = v34 * v20;
        w36[i] = v34 * v22;
        w37[i] = v34 * v24;
        w38[i] = v34 * v26;
        w8[i] = sum2;
        w39[i] = (v47 * v48) + (v50 * v9);
        w40[i] = (v47 * v53) + (v50 * v15);
        w41[i] = (v47 * v67) + (v50 * v20);
        w42[i] = (v47 * v71) + (v50 * v22);
        w43[i] = (v47 * v75) + (v50 * v24);
        w44[i] = (v47 * v79) + (v50 * v26);
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
    const double c0 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v2 = w7[i];
        const double v5 = w3[i];
        const double v6 = sqrt(v5);
        const double v8 = 1.0 / (v6 * v5);
        const double v9 = (c0 * ((-0.5) * v2)) * v8;
        const double v11 = (-0.5) * (c0 * v8);
        const double v14 = w33[i];
        const double v16 = v9 * v8;
        const double v20 = 1.0 / (2.0 * v6);
        const double v22 = (v6 * v16) + ((v5 * v16) * v20);
        const double v23 = w13[i];
        const double v26 = w34[i];
        const double v28 = w14[i];
        const double v31 = w35[i];
        const double v33 = w15[i];
        const double v36 = w36[i];
        const double v38 = w16[i];
        const double v41 = w37[i];
        const double v43 = w17[i];
        const double v46 = w38[i];
        const double v48 = w18[i];
        const double v53 = g[7 * i + 1] * p[0];
        const double v55 = 1.0 / v5;
        const double v56 = w6[i] * v55;
        const double v57 = w4[i];
        const double v58 = w8[i];
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
        const double v115 = v94 * v55;
        const double v116 = v97 * v103;
        const double v118 = v68 * v104;
        const double v121 = v61 * v55;
        const double v125 = (((v115 * v116) - (v118 * v20)) + (v121 * v104)) + (v61 * v105);
        const double v126 = v56 * v55;
        const double v129 = v68 * v8;
        const double v132 = (v129 * v108) + (v68 * v109);
        const double v135 = v69 * v20;
        const double v142 = ((v125 - (v126 * v104)) + (v6 * v132)) + ((((2.0 * (v135 * v118)) - v118) + (v5 * v132)) * v20);
        const double v144 = v105 * v55;
        const double v145 = v58 * v144;
        const double v146 = w19[i];
        const double v149 = w27[i];
        const double v153 = (((v142 * v23) - (v145 * v146)) + (v105 * v149)) - (v112 * v14);
        const double v155 = (-0.5) * (v2 * v111);
        const double v156 = w25[i];
        const double v159 = v94 * v103;
        const double v161 = v72 * v103;
        const double v169 = (v84 * ((v77 * v159) + (v89 * v161))) + (v90 * ((v77 * v161) - (v89 * v159)));
        const double v170 = 0.5 * v169;
        const double v174 = (v116 * v55) + (v57 * v144);
        const double v175 = w39[i];
        const double v179 = w20[i];
        const double v182 = w28[i];
        const double v186 = (((v142 * v28) - (v145 * v179)) + (v105 * v182)) - (v112 * v26);
        const double v187 = w26[i];
        const double v191 = w40[i];
        const double v198 = w21[i];
        const double v201 = w29[i];
        const double v205 = (((v142 * v33) - (v145 * v198)) + (v105 * v201)) - (v112 * v31);
        const double v206 = w41[i];
        const double v212 = ((v84 * v159) + (v90 * v161)) * v76;
        const double v215 = w22[i];
        const double v218 = w30[i];
        const double v222 = (((v142 * v38) - (v145 * v215)) + (v105 * v218)) - (v112 * v36);
        const double v223 = w42[i];
        const double v228 = w23[i];
        const double v231 = w31[i];
        const double v235 = (((v142 * v43) - (v145 * v228)) + (v105 * v231)) - (v112 * v41);
        const double v236 = w43[i];
        const double v242 = ((v84 * v161) - (v90 * v159)) * v76;
        const double v245 = w24[i];
        const double v248 = w32[i];
        const double v252 = (((v142 * v48) - (v145 * v245)) + (v105 * v248)) - (v112 * v46);
        const double v253 = w44[i];
        const double v260 = v84 * v55;
        const double v262 = v70 * v84;
        const double v263 = v262 * v8;
        const double v265 = c0 * (v263 * v8);
        const double v266 = v64 * v265;
        const double v270 = v68 * v84;
        const double v276 = (((v115 * v90) - (v270 * v20)) + (v121 * v84)) + (v61 * v260);
        const double v281 = (v129 * v262) + (v68 * v263);
        const double v290 = ((v276 - (v126 * v84)) + (v6 * v281)) + ((((2.0 * (v135 * v270)) - v270) + (v5 * v281)) * v20);
        const double v292 = v260 * v55;
        const double v293 = v58 * v292;
        const double v299 = (((v290 * v23) - (v293 * v146)) + (v260 * v149)) - (v266 * v14);
        const double v301 = (-0.5) * (v2 * v265);
        const double v307 = 0.5 * ((v84 * v94) + (v90 * v72));
        const double v309 = v90 * v55;
        const double v311 = v309 + (v57 * v292);
        const double v320 = (((v290 * v28) - (v293 * v179)) + (v260 * v182)) - (v266 * v26);
        const double v334 = (((v290 * v33) - (v293 * v198)) + (v260 * v201)) - (v266 * v31);
        const double v343 = (((v290 * v38) - (v293 * v215)) + (v260 * v218)) - (v266 * v36);
        const double v352 = (((v290 * v43) - (v293 * v228)) + (v260 * v231)) - (v266 * v41);
        const double v361 = (((v290 * v48) - (v293 * v245)) + (v260 * v248)) - (v266 * v46);
        const double v368 = v70 * v90;
        const double v369 = v368 * v8;
        const double v371 = c0 * (v369 * v8);
        const double v372 = v64 * v371;
        const double v377 = v68 * v90;
        const double v382 = ((v121 * v90) - ((v115 * v84) + (v377 * v20))) + (v61 * v309);
        const double v387 = (v129 * v368) + (v68 * v369);
        const double v396 = ((v382 - (v126 * v90)) + (v6 * v387)) + ((((2.0 * (v135 * v377)) - v377) + (v5 * v387)) * v20);
        const double v398 = v309 * v55;
        const double v399 = v58 * v398;
        const double v405 = (((v396 * v23) - (v399 * v146)) + (v309 * v149)) - (v372 * v14);
        const double v407 = (-0.5) * (v2 * v371);
        const double v413 = 0.5 * ((v84 * v72) - (v90 * v94));
        const double v416 = v260 - (v57 * v398);
        const double v425 = (((v396 * v28) - (v399 * v179)) + (v309 * v182)) - (v372 * v26);
        const double v438 = (((v396 * v33) - (v399 * v198)) + (v309 * v201)) - (v372 * v31);
        const double v447 = (((v396 * v38) - (v399 * v215)) + (v309 * v218)) - (v372 * v36);
        const double v456 = (((v396 * v43) - (v399 * v228)) + (v309 * v231)) - (v372 * v41);
        const double v465 = (((v396 * v48) - (v399 * v245)) + (v309 * v248)) - (v372 * v46);
        w9[i] = v9;
        w45[i] = (v11 * v14) - (v22 * v23);
        w46[i] = (v11 * v26) - (v22 * v28);
        w47[i] = (v11 * v31) - (v22 * v33);
        w48[i] = (v11 * v36) - (v22 * v38);
        w49[i] = (v11 * v41) - (v22 * v43);
        w50[i] = (v11 * v46) - (v22 * v48);
        w10[i] = -((v53 * ((v72 * v92) - (v94 * v97))) * 0.5);
        w51[i] = ((v153 - (v155 * v156)) - v170) - (v174 * v175);
        w52[i] = ((v186 - (v155 * v187)) - v170) - (v174 * v191);
        w53[i] = (v205 - (v174 * v206)) + v212;
        w54[i] = (v222 - (v174 * v223)) - v212;
        w55[i] = (v235 - (v174 * v236)) - v242;
        w56[i] = (v252 - (v174 * v253)) + v242;
        w11[i] = (v72 * v84) - (v94 * v90);
        w57[i] = ((v299 - (v301 * v156)) - v307) - (v311 * v175);
        w58[i] = ((v320 - (v301 * v187)) - v307) - (v311 * v191);
        w59[i] = v334 - (v311 * v206);
        w60[i] = v343 - (v311 * v223);
        w61[i] = v352 - (v311 * v236);
        w62[i] = v361 - (v311 * v253);
        w12[i] = (v72 * v90) + (v94 * v84);
        w63[i] = ((v405 - (v407 * v156)) + v413) + (v416 * v175);
        w64[i] = ((v425 - (v407 * v187)) + v413) + (v416 * v191);
        w65[i] = v438 + (v416 * v206);
        w66[i] = v447 + (v416 * v223);
        w67[i] = v456 + (v416 * v236);
        w68[i] = v465 + (v416 * v253);
        for (int k = 0; k < FIBRES; k++) {
            const double v12 = each1[FIBRES * i + k];
            const double v106 = each0[FIBRES * i + k];
            const double v194 = each2[FIBRES * i + k];
            each3[FIBRES * i + k] = v11 * v12;
            each4[FIBRES * i + k] = (v105 * v106) - (v112 * v12);
            each5[FIBRES * i + k] = -(v174 * v194);
            each6[FIBRES * i + k] = (v260 * v106) - (v266 * v12);
            each7[FIBRES * i + k] = -(v311 * v194);
            each8[FIBRES * i + k] = (v309 * v106) - (v372 * v12);
            each9[FIBRES * i + k] = v416 * v194;
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
    double *restrict each3 = w + (SCRATCH + 3 * FIBRES) * n;
    double *restrict each4 = w + (SCRATCH + 4 * FIBRES) * n;
    double *restrict each5 = w + (SCRATCH + 5 * FIBRES) * n;
    double *restrict each6 = w + (SCRATCH + 6 * FIBRES) * n;
    double *restrict each7 = w + (SCRATCH + 7 * FIBRES) * n;
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c50 = squared(c2);
    const double c51 = c4 * c50;
    const double c52 = c51 * c2;
    const double c53 = c1 / c52;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v56 = c53 * g[7 * i + 5];
        const double v79 = ((v56 * w45[i]) - (v56 * w46[i - 1])) + (v56 * w52[i - 1]);
        const double v104 = ((v56 * w47[i]) - (v56 * w48[i - 1])) + (v56 * w54[i - 1]);
        const double v125 = ((v56 * w49[i]) - (v56 * w50[i - 1])) + (v56 * w56[i - 1]);
        e[ENTRIES * i + 4] = -(v9 * w57[i - 1]);
        e[ENTRIES * i + 7] = (v9 * w57[i]) - (v9 * w58[i - 1]);
        e[ENTRIES * i + 10] = v9 * w58[i];
        e[ENTRIES * i + 2] = -(v9 * w59[i - 1]);
        e[ENTRIES * i + 5] = (v9 * w59[i]) - (v9 * w60[i - 1]);
        e[ENTRIES * i + 8] = v9 * w60[i];
        e[ENTRIES * i + 3] = -(v9 * w61[i - 1]);
        e[ENTRIES * i + 6] = (v9 * w61[i]) - (v9 * w62[i - 1]);
        e[ENTRIES * i + 9] = v9 * w62[i];
        e[ENTRIES * i + 22] = (v56 * w51[i - 1]) - (v56 * w45[i - 1]);
        e[ENTRIES * i + 25] = v79 + (v56 * w51[i]);
        e[ENTRIES * i + 28] = (v56 * w46[i]) + (v56 * w52[i]);
        e[ENTRIES * i + 20] = (v56 * w53[i - 1]) - (v56 * w47[i - 1]);
        e[ENTRIES * i + 23] = v104 + (v56 * w53[i]);
        e[ENTRIES * i + 26] = (v56 * w48[i]) + (v56 * w54[i]);
        e[ENTRIES * i + 21] = (v56 * w55[i - 1]) - (v56 * w49[i - 1]);
        e[ENTRIES * i + 24] = v125 + (v56 * w55[i]);
        e[ENTRIES * i + 27] = (v56 * w50[i]) + (v56 * w56[i]);
        for (int k = 0; k < FIBRES; k++) {
            const double v61 = (v56 * each4[FIBRES * (i - 1) + k]) - (v56 * each3[FIBRES * (i - 1) + k]);
            const double v66 = (v56 * each3[FIBRES * i + k]) + (v56 * each4[FIBRES * i + k]);
            e[ENTRIES * i + 29 + k] = -(v9 * each6[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 2 * FIBRES + k] = v9 * each6[FIBRES * i + k];
            e[ENTRIES * i + 29 + 1 * FIBRES + k] = -(v9 * each7[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 3 * FIBRES + k] = v9 * each7[FIBRES * i + k];
            e[ENTRIES * i + 29 + 8 * FIBRES + k] = v61;
            e[ENTRIES * i + 29 + 10 * FIBRES + k] = v66;
            e[ENTRIES * i + 29 + 9 * FIBRES + k] = v56 * each5[FIBRES * (i - 1) + k];
            e[ENTRIES * i + 29 + 11 * FIBRES + k] = v56 * each5[FIBRES * i + k];
        }
    }
}

static void jacobian_10(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w63 = w + 63 * n;
    double *restrict w64 = w + 64 * n;
    double *restrict w65 = w + 65 * n;
    double *restrict w66 = w + 66 * n;
    double *restrict w67 = w + 67 * n;
    double *restrict w68 = w + 68 * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
    double *restrict each9 = w + (SCRATCH + 9 * FIBRES) * n;
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[ENTRIES * i + 13] = -(v9 * w63[i - 1]);
        e[ENTRIES * i + 16] = (v9 * w63[i]) - (v9 * w64[i - 1]);
        e[ENTRIES * i + 19] = v9 * w64[i];
        e[ENTRIES * i + 11] = -(v9 * w65[i - 1]);
        e[ENTRIES * i + 14] = (v9 * w65[i]) - (v9 * w66[i - 1]);
        e[ENTRIES * i + 17] = v9 * w66[i];
        e[ENTRIES * i + 12] = -(v9 * w67[i - 1]);
        e[ENTRIES * i + 15] = (v9 * w67[i]) - (v9 * w68[i - 1]);
        e[ENTRIES * i + 18] = v9 * w68[i];
        for (int k = 0; k < FIBRES; k++) {
            e[ENTRIES * i + 29 + 4 * FIBRES + k] = -(v9 * each8[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 6 * FIBRES + k] = v9 * each8[FIBRES * i + k];
            e[ENTRIES * i + 29 + 5 * FIBRES + k] = -(v9 * each9[FIBRES * (i - 1) + k]);
            e[ENTRIES * i + 29 + 7 * FIBRES + k] = v9 * each9[FIBRES * i + k];
        }
    }
}

static void jacobian_11(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w63 = w + 63 * n;
    double *restrict w64 = w + 64 * n;
    double *restrict w65 = w + 65 * n;
    double *restrict w66 = w + 66 * n;
    double *restrict w67 = w + 67 * n;
    double *restrict w68 = w + 68 * n;
    double *restrict each8 = w + (SCRATCH + 8 * FIBRES) * n;
    double *restrict each9 = w + (SCRATCH + 9 * FIBRES) * n;
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[ENTRIES * i + 16] = v9 * w63[i];
    e[ENTRIES * i + 19] = v9 * w64[i];
    e[ENTRIES * i + 14] = v9 * w65[i];
    e[ENTRIES * i + 17] = v9 * w66[i];
    e[ENTRIES * i + 15] = v9 * w67[i];
    e[ENTRIES * i + 18] = v9 * w68[i];
    for (int k = 0; k < FIBRES; k++) {
        e[ENTRIES * i + 29 + 6 * FIBRES + k] = v9 * each8[FIBRES * i + k];
        e[ENTRIES * i + 29 + 7 * FIBRES + k] = v9 * each9[FIBRES * i + k];
    }
    (void)n;
}

static void work_0(int n, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w69 = w + 69 * n;
    const double c1 = p[7];
    const double c3 = p[5];
    const double c4 = 0.5 * c3;
    const double c25 = 0.45 * c3;
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
    const double c10 = p[9];
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
    const double c3 = p[9];
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
    const double c1 = p[7];
    const double c3 = p[5];
    const double c4 = 0.5 * c3;
    const double c10 = p[1];
    const double c26 = 0.45 * c3;
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
            each10[FIBRES * i + k] = v47 != 0.0 ? (-v67) : 0.0;
            each11[FIBRES * i + k] = v47 != 0.0 ? (-v93) : 0.0;
            sum10 += v47 != 0.0 ? (v93 * v33) : 0.0;
            sum11 += v47 != 0.0 ? v129 : 0.0;
            sum12 += v47 != 0.0 ? ((-0.5) * (v8 * (c10 * (v67 * v15)))) : 0.0;
            sum9 += v47 != 0.0 ? ((v46 * v56) * v57) : 0.0;
        }
        const double v70 = sum10;
        const double v73 = sum11;
        const double v77 = sum12;
        w69[i] = sum9;
        w70[i] = ((v70 * w19[i]) + (v73 * w13[i])) + (v77 * w25[i]);
        w71[i] = ((v70 * w20[i]) + (v73 * w14[i])) + (v77 * w26[i]);
        w72[i] = (v70 * w21[i]) + (v73 * w15[i]);
        w73[i] = (v70 * w22[i]) + (v73 * w16[i]);
        w74[i] = (v70 * w23[i]) + (v73 * w17[i]);
        w75[i] = (v70 * w24[i]) + (v73 * w18[i]);
    }
}

static void work_slope_1(int n, double t, const double *p, const double *g, double *s)
{
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = 30.0 * p[3];
    const double c10 = p[9];
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
    const double c0 = p[9];
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
    rates_5(n, w);
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
    jacobian_5(n, w);
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
    2, 3, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
static const int differential[] = {
    1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1};
static const int held_first[] = {
    1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0};
static const int held_last[] = {
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1};
static const int row[] = {
    0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 2, 2,
    2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2,
    2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    4, 4, 4, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10,
    11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,
    19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11,
    12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
    20, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 5, 6, 7, 8, 9, 10, 11, 12,
    13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35,
    36, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 21, 22, 23, 24, 25, 26,
    27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33,
    34, 35, 36, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 21, 22, 23, 24,
    25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31,
    32, 33, 34, 35, 36, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36};
static const int offset[] = {
    0, 0, -1, -1, -1, 0, 0, 0, 1, 1, 1, -1, -1, -1, 0, 0, 0, 1, 1, 1, -1, -1, -1, 0, 0, 0, 1, 1,
    1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
    -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int column[] = {
    2, 3, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 5, 6,
    7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30,
    31, 32, 33, 34, 35, 36, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22,
    23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14,
    15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 5,
    6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,
    30, 31, 32, 33, 34, 35, 36, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
    22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 5, 6, 7, 8, 9, 10, 11, 12, 13,
    14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,
    16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4,
    4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28,
    29, 30, 31, 32, 33, 34, 35, 36, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4};

const softcat_model softcat_filament_model = {
    37, 32, 10, 7, 268, 477, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "ramp", "youngs_modulus", "viscosity",
    "yield_stress", "poisson", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "s", "Pa", "Pa*s", "Pa", "1", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON,
    SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.01, 0.0005, 2200.0, 9.81, 0.02, 1000000.0, 300.0, 3464.1016151377544, 0.45,
    0.031927542840705044};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0", "axial_1", "axial_2", "axial_3", "axial_4", "axial_5",
    "axial_6", "axial_7", "axial_8", "axial_9", "axial_10", "axial_11", "axial_12", "axial_13",
    "axial_14", "axial_15", "shear_0", "shear_1", "shear_2", "shear_3", "shear_4", "shear_5",
    "shear_6", "shear_7", "shear_8", "shear_9", "shear_10", "shear_11", "shear_12", "shear_13",
    "shear_14", "shear_15"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, (-0.9686578935148324), (-0.8784890847806422),
    (-0.7406139298699932), (-0.5721146443791073), (-0.394041993763766), (-0.2289535525667885),
    (-0.09821234188930718), (-0.019199555780713324), 0.019199555780713324, 0.09821234188930718,
    0.2289535525667885, 0.394041993763766, 0.5721146443791073, 0.7406139298699932,
    0.8784890847806422, 0.9686578935148324, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double described_initial_mean[] = {
    (-0.003)};
static const double described_initial_bending[] = {
    (-0.0004)};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Ink strand that shrank as it dried",
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
    .time_scale = 9,
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
    .initial_mean = described_initial_mean,
    .initial_mean_count = 1,
    .initial_bending = described_initial_bending,
    .initial_bending_count = 1,
    .thickness = 0,
    .thickness_count = 0,
    .grading = 9.404868286995688,
    .relative = 0.00012,
    .absolute = 6.058600634910723e-08,
    .towards_middle = 0,
    .duration = 0.5,
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
