/*
 * Ink strand that shrank as it dried
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres
 * Digest of the structure: 3de5d97420affbdf37ae9f3de8fc93485f194840738b887ac3990601ccccf5eb
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
    const double c3 = p[7];
    const double c4 = p[5];
    const double c7 = (-0.5) * p[1];
    const double c24 = 0.9 * c4;
    const double c27 = 2.0 * p[8];
    const double c28 = 2.0 + c27;
    const double c29 = c24 / c28;
    const double c39 = 1e-12 * c4;
    const double c40 = squared(c39);
    const double c46 = 1.0 / p[6];
    const double c50 = p[9];
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
    const double c13 = 0.5 * p[1];
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
        w9[i] = (v23 * v29) - (v6 * v31);
        w10[i] = (v23 * v31) + (v6 * v29);
        w11[i] = ((g[7 * i + 1] * p[0]) * (v5 - (v4 * v23))) * 0.5;
        w12[i] = -v18;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w9 = w + 9 * n;
    double *restrict w11 = w + 11 * n;
    double *restrict w12 = w + 12 * n;
    const double c4 = squared(p[9]);
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
        const double v31 = (((w12[i] - w12[i - 1]) + w11[i]) + w11[i - 1]) * (c27 * g[7 * i + 5]);
        f[SLOTS * i + 2] = (w9[i] - w9[i - 1]) * (c9 * g[7 * i + 6]);
        f[SLOTS * i + 4] = v31 * c34;
    }
}

static void rates_10(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w10 = w + 10 * n;
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
        f[SLOTS * i + 3] = ((w10[i] - w10[i - 1]) * (c9 * g[7 * i + 6])) - c34;
    }
}

static void rates_11(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w10 = w + 10 * n;
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
    const double c54 = 0.9 * c1;
    const double c57 = 2.0 * p[8];
    const double c58 = 2.0 + c57;
    const double c59 = c54 / c58;
    const double c78 = p[7];
    const double c81 = (-0.5) * p[1];
    const double c107 = 1e-12 * c1;
    const double c108 = squared(c107);
    const double c114 = 1.0 / p[6];
    const double c118 = p[9];
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
        const double v6 = w13[i];
        const double v9 = w25[i];
        const double v12 = w14[i];
        const double v14 = w26[i];
        const double v17 = w15[i];
        const double v19 = w16[i];
        const double v21 = w17[i];
        const double v23 = w18[i];
        const double v44 = w19[i];
        const double v49 = w20[i];
        const double v62 = w21[i];
        const double v66 = w22[i];
        const double v70 = w23[i];
        const double v74 = w24[i];
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
            e[ENTRIES * i + 29 + 15 * FIBRES + k] = v111 != 0.0 ? (-v137) : 0.0;
            e[ENTRIES * i + 29 + 14 * FIBRES + k] = v166;
            e[ENTRIES * i + 29 + 19 * FIBRES + k] = v172;
            e[ENTRIES * i + 29 + 16 * FIBRES + k] = v111 != 0.0 ? (-v143) : 0.0;
            e[ENTRIES * i + 29 + 12 * FIBRES + k] = v111 != 0.0 ? ((v144 * v62) + (v158 * v17)) : 0.0;
            e[ENTRIES * i + 29 + 17 * FIBRES + k] = v111 != 0.0 ? ((v144 * v66) + (v158 * v19)) : 0.0;
            e[ENTRIES * i + 29 + 13 * FIBRES + k] = v111 != 0.0 ? ((v144 * v70) + (v158 * v21)) : 0.0;
            e[ENTRIES * i + 29 + 18 * FIBRES + k] = v111 != 0.0 ? ((v144 * v74) + (v158 * v23)) : 0.0;
            e[ENTRIES * i + 29 + 23 * FIBRES + k] = v111 != 0.0 ? (-v200) : 0.0;
            e[ENTRIES * i + 29 + 22 * FIBRES + k] = v226;
            e[ENTRIES * i + 29 + 27 * FIBRES + k] = v232;
            e[ENTRIES * i + 29 + 24 * FIBRES + k] = v111 != 0.0 ? (-v207) : 0.0;
            e[ENTRIES * i + 29 + 20 * FIBRES + k] = v111 != 0.0 ? ((v208 * v62) + (v218 * v17)) : 0.0;
            e[ENTRIES * i + 29 + 25 * FIBRES + k] = v111 != 0.0 ? ((v208 * v66) + (v218 * v19)) : 0.0;
            e[ENTRIES * i + 29 + 21 * FIBRES + k] = v111 != 0.0 ? ((v208 * v70) + (v218 * v21)) : 0.0;
            e[ENTRIES * i + 29 + 26 * FIBRES + k] = v111 != 0.0 ? ((v208 * v74) + (v218 * v23)) : 0.0;
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
        w6[i] = sum0;
        w27[i] = (v5 * v6) + (v8 * v9);
        w28[i] = (v5 * v12) + (v8 * v14);
        w29[i] = v5 * v17;
        w30[i] = v5 * v19;
        w31[i] = v5 * v21;
        w32[i] = v5 * v23;
        w7[i] = sum1;
        w33[i] = (v30 * v6) + (v32 * v9);
        w34[i] = (v30 * v12) + (v32 * v14);
        w35[i] = v30 * v17;
        w36[i] = v30 * v19;
        w37[i] = v30 * v21;
        w38[i] = v30 * v23;
        w8[i] = sum2;
        w39[i] = (v43 * v44) + (v46 * v6);
        w40[i] = (v43 * v49) + (v46 * v12);
        w41[i] = (v43 * v62) + (v46 * v17);
        w42[i] = (v43 * v66) + (v46 * v19);
        w43[i] = (v43 * v70) + (v46 * v21);
        w44[i] = (v43 * v74) + (v46 * v23);
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
    const double c13 = 0.5 * p[1];
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
        const double v35 = v30 * v2;
        const double v38 = c13 * v18;
        const double v41 = (v21 * (1.5 * v38)) * v2;
        const double v42 = v30 * v41;
        const double v46 = v6 * v2;
        const double v47 = v4 * v46;
        const double v57 = (v19 * v18) * ((v1 / (2.0 * v16)) + v16);
        const double v63 = (((v47 * v2) + (v8 * v2)) - (v3 * v2)) - (((v21 * (1.5 * v57)) * v2) + (v23 * v2));
        const double v65 = v32 * v46;
        const double v66 = (v30 * v63) + v65;
        const double v67 = w13[i];
        const double v69 = v30 * v46;
        const double v70 = w19[i];
        const double v73 = w27[i];
        const double v76 = w33[i];
        const double v79 = v20 * v2;
        const double v80 = v30 * v79;
        const double v81 = w25[i];
        const double v83 = ((((v66 * v67) - (v69 * v70)) + (v35 * v73)) + (v42 * v76)) + (v80 * v81);
        const double v84 = 0.5 * v32;
        const double v86 = 0.5 * v30;
        const double v88 = (v24 * v84) + (v6 * v86);
        const double v90 = v4 * v2;
        const double v91 = v90 * v2;
        const double v93 = v32 * v2;
        const double v94 = (v30 * v91) + v93;
        const double v95 = w39[i];
        const double v98 = w14[i];
        const double v100 = w20[i];
        const double v103 = w28[i];
        const double v106 = w34[i];
        const double v108 = (((v66 * v98) - (v69 * v100)) + (v35 * v103)) + (v42 * v106);
        const double v109 = w26[i];
        const double v113 = w40[i];
        const double v119 = w15[i];
        const double v121 = w21[i];
        const double v124 = w29[i];
        const double v127 = w35[i];
        const double v129 = (((v66 * v119) - (v69 * v121)) + (v35 * v124)) + (v42 * v127);
        const double v130 = w41[i];
        const double v133 = w16[i];
        const double v135 = w22[i];
        const double v138 = w30[i];
        const double v141 = w36[i];
        const double v143 = (((v66 * v133) - (v69 * v135)) + (v35 * v138)) + (v42 * v141);
        const double v144 = w42[i];
        const double v147 = w17[i];
        const double v149 = w23[i];
        const double v152 = w31[i];
        const double v155 = w37[i];
        const double v157 = (((v66 * v147) - (v69 * v149)) + (v35 * v152)) + (v42 * v155);
        const double v158 = w43[i];
        const double v161 = w18[i];
        const double v163 = w24[i];
        const double v166 = w32[i];
        const double v169 = w38[i];
        const double v171 = (((v66 * v161) - (v69 * v163)) + (v35 * v166)) + (v42 * v169);
        const double v172 = w44[i];
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
        const double v253 = g[7 * i + 1] * p[0];
        const double v259 = 0.5 * (v253 * v90);
        const double v263 = 0.5 * (v253 * (v4 * v41));
        const double v271 = 0.5 * (v253 * (1.0 + (v4 * v91)));
        const double v275 = 0.5 * (v253 * (v24 - v47));
        const double v279 = 0.5 * (v253 * (v4 * v63));
        const double v285 = (((v275 * v70) + (v279 * v67)) + (v259 * v73)) + (v263 * v76);
        const double v288 = 0.5 * (v253 * (v4 * v79));
        const double v299 = (((v275 * v100) + (v279 * v98)) + (v259 * v103)) + (v263 * v106);
        const double v311 = (((v275 * v121) + (v279 * v119)) + (v259 * v124)) + (v263 * v127);
        const double v320 = (((v275 * v135) + (v279 * v133)) + (v259 * v138)) + (v263 * v141);
        const double v329 = (((v275 * v149) + (v279 * v147)) + (v259 * v152)) + (v263 * v155);
        const double v338 = (((v275 * v163) + (v279 * v161)) + (v259 * v166)) + (v263 * v169);
        w9[i] = (v24 * v30) - (v6 * v32);
        w45[i] = (v83 - v88) - (v94 * v95);
        w46[i] = ((v108 + (v80 * v109)) - v88) - (v94 * v113);
        w47[i] = v129 - (v94 * v130);
        w48[i] = v143 - (v94 * v144);
        w49[i] = v157 - (v94 * v158);
        w50[i] = v171 - (v94 * v172);
        w10[i] = (v24 * v32) + (v6 * v30);
        w51[i] = ((v190 + (v191 * v81)) + v196) + (v199 * v95);
        w52[i] = ((v208 + (v191 * v109)) + v196) + (v199 * v113);
        w53[i] = v221 + (v199 * v130);
        w54[i] = v230 + (v199 * v144);
        w55[i] = v239 + (v199 * v158);
        w56[i] = v248 + (v199 * v172);
        w11[i] = (v253 * (v5 - (v4 * v24))) * 0.5;
        w57[i] = (v271 * v95) - (v285 + (v288 * v81));
        w58[i] = (v271 * v113) - (v299 + (v288 * v109));
        w59[i] = (v271 * v130) - v311;
        w60[i] = (v271 * v144) - v320;
        w61[i] = (v271 * v158) - v329;
        w62[i] = (v271 * v172) - v338;
        w12[i] = -v19;
        w63[i] = (v57 * v67) - (v38 * v76);
        w64[i] = (v57 * v98) - (v38 * v106);
        w65[i] = (v57 * v119) - (v38 * v127);
        w66[i] = (v57 * v133) - (v38 * v141);
        w67[i] = (v57 * v147) - (v38 * v155);
        w68[i] = (v57 * v161) - (v38 * v169);
        for (int k = 0; k < FIBRES; k++) {
            const double v36 = each0[FIBRES * i + k];
            const double v43 = each1[FIBRES * i + k];
            const double v116 = each2[FIBRES * i + k];
            each3[FIBRES * i + k] = (v35 * v36) + (v42 * v43);
            each4[FIBRES * i + k] = -(v94 * v116);
            each5[FIBRES * i + k] = (v93 * v36) + (v179 * v43);
            each6[FIBRES * i + k] = v199 * v116;
            each7[FIBRES * i + k] = -((v259 * v36) + (v263 * v43));
            each8[FIBRES * i + k] = v271 * v116;
            each9[FIBRES * i + k] = -(v38 * v43);
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c51 = 0.0625 * c4;
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
    const double c1 = squared(p[9]);
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
    const double c1 = squared(p[9]);
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
    const double c1 = p[7];
    const double c2 = p[5];
    const double c5 = (-0.5) * p[1];
    const double c22 = 0.9 * c2;
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
    const double c2 = p[5];
    const double c5 = (-0.5) * p[1];
    const double c23 = 0.9 * c2;
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
            each10[FIBRES * i + k] = v43 != 0.0 ? (-v62) : 0.0;
            each11[FIBRES * i + k] = v43 != 0.0 ? (-v87) : 0.0;
            sum10 += v43 != 0.0 ? (v87 * v30) : 0.0;
            sum11 += v43 != 0.0 ? v123 : 0.0;
            sum12 += v43 != 0.0 ? (c5 * (v8 * (v62 * v13))) : 0.0;
            sum9 += v43 != 0.0 ? ((v42 * v52) * v53) : 0.0;
        }
        const double v65 = sum10;
        const double v68 = sum11;
        const double v72 = sum12;
        w69[i] = sum9;
        w70[i] = ((v65 * w19[i]) + (v68 * w13[i])) + (v72 * w25[i]);
        w71[i] = ((v65 * w20[i]) + (v68 * w14[i])) + (v72 * w26[i]);
        w72[i] = (v65 * w21[i]) + (v68 * w15[i]);
        w73[i] = (v65 * w22[i]) + (v68 * w16[i]);
        w74[i] = (v65 * w23[i]) + (v68 * w17[i]);
        w75[i] = (v65 * w24[i]) + (v68 * w18[i]);
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
