/*
 * Ink strand that shrank as it dried
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres
 * Digest of the structure: 80b265cc58f9181a8d1f32ff12a4f7b21a87ce03bd569f95984262ed7c9974ae
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
    const double c21 = p[5];
    const double c22 = 0.5 * c21;
    const double c32 = 0.45 * c21;
    const double c35 = 2.0 * p[8];
    const double c36 = 2.0 + c35;
    const double c37 = c32 / c36;
    const double c43 = 1e-12 * c21;
    const double c44 = squared(c43);
    const double c50 = 1.0 / p[6];
    const double c54 = p[9];
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v6 = (-0.5) * w5[i];
        const double v11 = w3[i];
        const double v13 = sqrt(v11) * v11;
        const double v15 = log(v11);
        const double v27 = w4[i] / v11;
        for (int k = 0; k < FIBRES; k++) {
            const double v7 = zeta[k];
            const double v19 = 2.0 * (((((v6 * v7) * p[1]) / v13) + v15) - y[SLOTS * i + 5 + k]);
            const double v23 = v19 * c22;
            const double v38 = (2.0 * (v27 - y[SLOTS * i + 5 + 1 * FIBRES + k])) * c37;
            const double v46 = sqrt(larger(squared(v23) + (3.0 * squared(v38)), c44));
            const double v47 = (double)(c3 < v46);
            const double v52 = ((v46 - c3) * c50) / v46;
            const double v61 = weight[k];
            f[SLOTS * i + 5 + k] = v47 != 0.0 ? ((v23 * v52) * c54) : 0.0;
            f[SLOTS * i + 5 + 1 * FIBRES + k] = v47 != 0.0 ? (((3.0 * v38) * v52) * c54) : 0.0;
            sum0 += v23 * v61;
            sum1 += v23 * (v61 * v7);
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
    const double c2 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w7[i];
        const double v3 = w3[i];
        const double v4 = sqrt(v3);
        const double v6 = 1.0 / (v4 * v3);
        const double v18 = (w1[i] + w1[i + 1]) * 0.5;
        const double v19 = cos(v18);
        const double v23 = g[7 * i + 4];
        const double v24 = (w2[i + 1] - w2[i]) * v23;
        const double v26 = 1.0 / v3;
        const double v33 = (((((-0.5) * w5[i]) * v1) * c2) * v6) * v6;
        const double v40 = w8[i];
        const double v44 = ((v4 * v33) + ((v3 * v33) / (2.0 * v4))) + (((w4[i] * v40) * v26) * v26);
        const double v45 = (w6[i] * v26) - v44;
        const double v50 = (w0[i + 1] - w0[i]) * v23;
        const double v51 = v40 * v26;
        const double v55 = sin(v18);
        const double v60 = (v19 * ((v24 * v45) - (v50 * v51))) - (v55 * ((v24 * v51) + (v50 * v45)));
        w9[i] = (-0.5) * (v1 * (c2 * v6));
        w10[i] = -(((g[7 * i + 1] * p[0]) * v60) * 0.5);
        w11[i] = (v19 * v45) - (v55 * v51);
        w12[i] = (v19 * v51) + (v55 * v45);
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
            const double v100 = (2.0 * ((v94 + v95) - y[SLOTS * i + 5 + k])) * c3;
            const double v109 = (2.0 * (v105 - y[SLOTS * i + 5 + 1 * FIBRES + k])) * c63;
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
    const double c2 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v1 = w7[i];
        const double v3 = w3[i];
        const double v4 = sqrt(v3);
        const double v6 = 1.0 / (v4 * v3);
        const double v7 = c2 * v6;
        const double v10 = (-0.5) * v7;
        const double v13 = w33[i];
        const double v17 = (v7 * v6) * ((-0.5) * v1);
        const double v21 = 1.0 / (2.0 * v4);
        const double v23 = (v4 * v17) + ((v3 * v17) * v21);
        const double v24 = w13[i];
        const double v27 = w34[i];
        const double v29 = w14[i];
        const double v32 = w35[i];
        const double v34 = w15[i];
        const double v37 = w36[i];
        const double v39 = w16[i];
        const double v42 = w37[i];
        const double v44 = w17[i];
        const double v47 = w38[i];
        const double v49 = w18[i];
        const double v54 = g[7 * i + 1] * p[0];
        const double v60 = (w1[i] + w1[i + 1]) * 0.5;
        const double v61 = cos(v60);
        const double v65 = g[7 * i + 4];
        const double v66 = (w2[i + 1] - w2[i]) * v65;
        const double v68 = 1.0 / v3;
        const double v69 = w6[i] * v68;
        const double v71 = (-0.5) * w5[i];
        const double v75 = (((v71 * v1) * c2) * v6) * v6;
        const double v78 = (v3 * v75) * v21;
        const double v80 = w4[i];
        const double v81 = w8[i];
        const double v84 = ((v80 * v81) * v68) * v68;
        const double v86 = v69 - (((v4 * v75) + v78) + v84);
        const double v91 = (w0[i + 1] - w0[i]) * v65;
        const double v92 = v81 * v68;
        const double v94 = (v66 * v86) - (v91 * v92);
        const double v96 = sin(v60);
        const double v99 = (v66 * v92) + (v91 * v86);
        const double v105 = (-0.5) * v54;
        const double v106 = v61 * v105;
        const double v108 = v96 * v105;
        const double v110 = (v66 * v106) - (v91 * v108);
        const double v111 = v110 * v68;
        const double v114 = v110 * v21;
        const double v117 = (v3 * v114) + (v4 * v110);
        const double v118 = v117 * v6;
        const double v120 = c2 * (v118 * v6);
        const double v121 = v71 * v120;
        const double v124 = v92 * v68;
        const double v127 = (v66 * v108) + (v91 * v106);
        const double v129 = v84 * v68;
        const double v135 = (((v124 * v127) + (v129 * v110)) + (v84 * v111)) - (v75 * v114);
        const double v136 = v69 * v68;
        const double v139 = v75 * v6;
        const double v142 = (v139 * v117) + (v75 * v118);
        const double v145 = v78 * v21;
        const double v152 = (((2.0 * (v145 * v110)) - (v75 * v110)) + (v3 * v142)) * v21;
        const double v153 = ((v135 - (v136 * v110)) + (v4 * v142)) + v152;
        const double v155 = v111 * v68;
        const double v156 = v81 * v155;
        const double v157 = w19[i];
        const double v160 = w27[i];
        const double v164 = (((v153 * v24) - (v156 * v157)) + (v111 * v160)) - (v121 * v13);
        const double v166 = (-0.5) * (v1 * v120);
        const double v167 = w25[i];
        const double v175 = 0.5 * ((v61 * (v99 * v105)) + (v96 * (v94 * v105)));
        const double v179 = (v127 * v68) + (v80 * v155);
        const double v180 = w39[i];
        const double v184 = w20[i];
        const double v187 = w28[i];
        const double v191 = (((v153 * v29) - (v156 * v184)) + (v111 * v187)) - (v121 * v27);
        const double v192 = w26[i];
        const double v196 = w40[i];
        const double v203 = w21[i];
        const double v206 = w29[i];
        const double v210 = (((v153 * v34) - (v156 * v203)) + (v111 * v206)) - (v121 * v32);
        const double v211 = w41[i];
        const double v217 = ((v86 * v108) + (v92 * v106)) * v65;
        const double v220 = w22[i];
        const double v223 = w30[i];
        const double v227 = (((v153 * v39) - (v156 * v220)) + (v111 * v223)) - (v121 * v37);
        const double v228 = w42[i];
        const double v233 = w23[i];
        const double v236 = w31[i];
        const double v240 = (((v153 * v44) - (v156 * v233)) + (v111 * v236)) - (v121 * v42);
        const double v241 = w43[i];
        const double v247 = ((v86 * v106) - (v92 * v108)) * v65;
        const double v250 = w24[i];
        const double v253 = w32[i];
        const double v257 = (((v153 * v49) - (v156 * v250)) + (v111 * v253)) - (v121 * v47);
        const double v258 = w44[i];
        const double v264 = (v61 * v86) - (v96 * v92);
        const double v265 = v61 * v68;
        const double v267 = v61 * v21;
        const double v270 = (v3 * v267) + (v4 * v61);
        const double v271 = v270 * v6;
        const double v273 = c2 * (v271 * v6);
        const double v274 = v71 * v273;
        const double v283 = (((v124 * v96) + (v129 * v61)) + (v84 * v265)) - (v75 * v267);
        const double v288 = (v139 * v270) + (v75 * v271);
        const double v297 = (((2.0 * (v145 * v61)) - (v75 * v61)) + (v3 * v288)) * v21;
        const double v298 = ((v283 - (v136 * v61)) + (v4 * v288)) + v297;
        const double v300 = v265 * v68;
        const double v301 = v81 * v300;
        const double v307 = (((v298 * v24) - (v301 * v157)) + (v265 * v160)) - (v274 * v13);
        const double v309 = (-0.5) * (v1 * v273);
        const double v314 = (v61 * v92) + (v96 * v86);
        const double v315 = 0.5 * v314;
        const double v317 = v96 * v68;
        const double v319 = v317 + (v80 * v300);
        const double v328 = (((v298 * v29) - (v301 * v184)) + (v265 * v187)) - (v274 * v27);
        const double v342 = (((v298 * v34) - (v301 * v203)) + (v265 * v206)) - (v274 * v32);
        const double v351 = (((v298 * v39) - (v301 * v220)) + (v265 * v223)) - (v274 * v37);
        const double v360 = (((v298 * v44) - (v301 * v233)) + (v265 * v236)) - (v274 * v42);
        const double v369 = (((v298 * v49) - (v301 * v250)) + (v265 * v253)) - (v274 * v47);
        const double v373 = v96 * v21;
        const double v376 = (v3 * v373) + (v4 * v96);
        const double v377 = v376 * v6;
        const double v379 = c2 * (v377 * v6);
        const double v380 = v71 * v379;
        const double v389 = (((v129 * v96) - (v124 * v61)) + (v84 * v317)) - (v75 * v373);
        const double v394 = (v139 * v376) + (v75 * v377);
        const double v403 = (((2.0 * (v145 * v96)) - (v75 * v96)) + (v3 * v394)) * v21;
        const double v404 = ((v389 - (v136 * v96)) + (v4 * v394)) + v403;
        const double v406 = v317 * v68;
        const double v407 = v81 * v406;
        const double v413 = (((v404 * v24) - (v407 * v157)) + (v317 * v160)) - (v380 * v13);
        const double v415 = (-0.5) * (v1 * v379);
        const double v418 = 0.5 * v264;
        const double v421 = v265 - (v80 * v406);
        const double v430 = (((v404 * v29) - (v407 * v184)) + (v317 * v187)) - (v380 * v27);
        const double v443 = (((v404 * v34) - (v407 * v203)) + (v317 * v206)) - (v380 * v32);
        const double v452 = (((v404 * v39) - (v407 * v220)) + (v317 * v223)) - (v380 * v37);
        const double v461 = (((v404 * v44) - (v407 * v233)) + (v317 * v236)) - (v380 * v42);
        const double v470 = (((v404 * v49) - (v407 * v250)) + (v317 * v253)) - (v380 * v47);
        w9[i] = (-0.5) * (v1 * v7);
        w45[i] = (v10 * v13) - (v23 * v24);
        w46[i] = (v10 * v27) - (v23 * v29);
        w47[i] = (v10 * v32) - (v23 * v34);
        w48[i] = (v10 * v37) - (v23 * v39);
        w49[i] = (v10 * v42) - (v23 * v44);
        w50[i] = (v10 * v47) - (v23 * v49);
        w10[i] = -((v54 * ((v61 * v94) - (v96 * v99))) * 0.5);
        w51[i] = ((v164 - (v166 * v167)) - v175) - (v179 * v180);
        w52[i] = ((v191 - (v166 * v192)) - v175) - (v179 * v196);
        w53[i] = (v210 - (v179 * v211)) + v217;
        w54[i] = (v227 - (v179 * v228)) - v217;
        w55[i] = (v240 - (v179 * v241)) - v247;
        w56[i] = (v257 - (v179 * v258)) + v247;
        w11[i] = v264;
        w57[i] = ((v307 - (v309 * v167)) - v315) - (v319 * v180);
        w58[i] = ((v328 - (v309 * v192)) - v315) - (v319 * v196);
        w59[i] = v342 - (v319 * v211);
        w60[i] = v351 - (v319 * v228);
        w61[i] = v360 - (v319 * v241);
        w62[i] = v369 - (v319 * v258);
        w12[i] = v314;
        w63[i] = ((v413 - (v415 * v167)) + v418) + (v421 * v180);
        w64[i] = ((v430 - (v415 * v192)) + v418) + (v421 * v196);
        w65[i] = v443 + (v421 * v211);
        w66[i] = v452 + (v421 * v228);
        w67[i] = v461 + (v421 * v241);
        w68[i] = v470 + (v421 * v258);
        for (int k = 0; k < FIBRES; k++) {
            const double v11 = each1[FIBRES * i + k];
            const double v112 = each0[FIBRES * i + k];
            const double v199 = each2[FIBRES * i + k];
            each3[FIBRES * i + k] = v10 * v11;
            each4[FIBRES * i + k] = (v111 * v112) - (v121 * v11);
            each5[FIBRES * i + k] = -(v179 * v199);
            each6[FIBRES * i + k] = (v265 * v112) - (v274 * v11);
            each7[FIBRES * i + k] = -(v319 * v199);
            each8[FIBRES * i + k] = (v317 * v112) - (v380 * v11);
            each9[FIBRES * i + k] = v421 * v199;
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
    const double c19 = p[5];
    const double c20 = 0.5 * c19;
    const double c30 = 0.45 * c19;
    const double c33 = 2.0 * p[8];
    const double c34 = 2.0 + c33;
    const double c35 = c30 / c34;
    const double c41 = 1e-12 * c19;
    const double c42 = squared(c41);
    const double c48 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum9 = 0.0;
        const double v4 = (-0.5) * w5[i];
        const double v9 = w3[i];
        const double v11 = sqrt(v9) * v9;
        const double v13 = log(v9);
        const double v25 = w4[i] / v9;
        for (int k = 0; k < FIBRES; k++) {
            const double v16 = ((((v4 * zeta[k]) * p[1]) / v11) + v13) - y[SLOTS * i + 5 + k];
            const double v37 = squared(((2.0 * (v25 - y[SLOTS * i + 5 + 1 * FIBRES + k])) * c35));
            const double v44 = sqrt(larger(squared(((2.0 * v16) * c20)) + (3.0 * v37), c42));
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
    const double c7 = p[1];
    const double c20 = p[5];
    const double c21 = 0.5 * c20;
    const double c32 = 0.45 * c20;
    const double c35 = 2.0 * p[8];
    const double c36 = 2.0 + c35;
    const double c37 = c32 / c36;
    const double c43 = 1e-12 * c20;
    const double c44 = squared(c43);
    const double c55 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum12 = 0.0;
        double sum9 = 0.0;
        const double v4 = (-0.5) * w5[i];
        const double v9 = w3[i];
        const double v10 = sqrt(v9);
        const double v12 = 1.0 / (v10 * v9);
        const double v14 = log(v9);
        const double v26 = 1.0 / v9;
        const double v27 = w4[i] * v26;
        const double v119 = v27 * v26;
        const double v127 = 2.0 * v10;
        for (int k = 0; k < FIBRES; k++) {
            const double v5 = zeta[k];
            const double v13 = ((v4 * v5) * c7) * v12;
            const double v22 = (2.0 * ((v13 + v14) - y[SLOTS * i + 5 + k])) * c21;
            const double v38 = (2.0 * (v27 - y[SLOTS * i + 5 + 1 * FIBRES + k])) * c37;
            const double v41 = squared(v22) + (3.0 * squared(v38));
            const double v46 = sqrt(larger(v41, c44));
            const double v47 = (double)(c1 < v46);
            const double v49 = (double)(c44 <= v41);
            const double v56 = (v46 - c1) * c55;
            const double v57 = weight[k];
            const double v64 = (v49 / (v49 + (double)(v41 <= c44))) * (((v56 * v57) + ((v46 * v57) * c55)) / (2.0 * v46));
            const double v67 = 2.0 * (c21 * ((2.0 * v22) * v64));
            const double v93 = 2.0 * (c37 * ((2.0 * v38) * (3.0 * v64)));
            const double v123 = (v13 * v12) * v67;
            const double v129 = (((v67 * v26) - (v119 * v93)) - (v10 * v123)) - ((v9 * v123) / v127);
            each10[FIBRES * i + k] = v47 != 0.0 ? (-v67) : 0.0;
            each11[FIBRES * i + k] = v47 != 0.0 ? (-v93) : 0.0;
            sum10 += v47 != 0.0 ? (v93 * v26) : 0.0;
            sum11 += v47 != 0.0 ? v129 : 0.0;
            sum12 += v47 != 0.0 ? ((-0.5) * (v5 * (c7 * (v67 * v12)))) : 0.0;
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
