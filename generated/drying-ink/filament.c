/*
 * Ink strand that shrank as it dried
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres
 * Digest of the structure: 3b96fb7cb3f859ad79e60c6974c712c276e742180b0f090a86b79e7d65fd119d
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

#define FIBRES (filament->fibres)
#define SCRATCH 76
#define SLOTS (5 + 2 * FIBRES)
#define ENTRIES (29 + 28 * FIBRES)
#define fibre_zeta (filament->points + 0 * FIBRES)
#define fibre_weight (filament->points + 1 * FIBRES)

static inline double smaller(double a, double b) { return a < b ? a : b; }
static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double squared(double a) { return a * a; }

static void rates_0(int n, int slots, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[slots * i + 0] = y[slots * i + 2];
    }
}

static void rates_1(int n, int slots, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[slots * i + 1] = y[slots * i + 3];
    }
}

static void rates_2(int n, int slots, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[slots * i + 0];
        w1[i] = y[slots * i + 4];
    }
}

static void rates_3(int n, int slots, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[slots * i + 1];
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
        w5[i] = (v7 - v6) / (g[7 * i + 1] * p[0]);
    }
}

static void rates_7(int n, int fibres, int slots, const double *zeta, const double *weight, const double *p, const double *y, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    const double c3 = p[7];
    const double c4 = p[5];
    const double c42 = 1.0 + p[8];
    const double c43 = c4 / c42;
    const double c51 = 1e-12 * c4;
    const double c52 = squared(c51);
    const double c58 = 1.0 / p[6];
    const double c63 = p[9];
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum2 = 0.0;
        const double v7 = (-0.5) * w5[i];
        const double v12 = w3[i];
        const double v14 = sqrt(v12) * v12;
        const double v16 = log(v12);
        const double v24 = (0.9486832980505138 * w4[i]) / v12;
        for (int k = 0; k < fibres; k++) {
            const double v8 = zeta[k];
            const double v19 = ((((v7 * v8) * p[1]) / v14) + v16) - y[slots * i + 5 + k];
            const double v25 = y[slots * i + 5 + 1 * fibres + k];
            const double v28 = exp((-1.5) * v19);
            const double v30 = v24 - (v25 * v28);
            const double v34 = c4 * (v19 + (0.25 * squared(v30)));
            const double v38 = 0.5 * v30;
            const double v45 = (v34 * v38) + (c43 * v38);
            const double v46 = v45 * v28;
            const double v54 = sqrt(larger(squared(v34) + (3.0 * squared(v46)), c52));
            const double v55 = (double)(c3 < v54);
            const double v77 = v34 + ((1.5 * v25) * v46);
            const double v78 = weight[k];
            if (v55 != 0.0) {
                const double v59 = (v54 - c3) * c58;
                const double v61 = 1.0 / v54;
                const double v62 = (v34 * v59) * v61;
                f[slots * i + 5 + k] = v62 * c63;
                const double v72 = ((((-1.5) * v25) * v62) + (((3.0 * v46) * v59) * v61)) * c63;
                f[slots * i + 5 + 1 * fibres + k] = v72;
            }
            sum0 += v77 * v78;
            sum1 += v77 * (v78 * v8);
            sum2 += v45 * v78;
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
    const double c16 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v5 = (w1[i] + w1[i + 1]) * 0.5;
        const double v6 = cos(v5);
        const double v8 = w3[i];
        const double v9 = 1.0 / v8;
        const double v14 = w7[i];
        const double v18 = sqrt(v8);
        const double v20 = 1.0 / (v18 * v8);
        const double v26 = ((((((-0.5) * w5[i]) * v14) * c16) * v20) * v20) * ((v8 / (2.0 * v18)) + v18);
        const double v31 = w8[i];
        const double v35 = ((w6[i] * v9) - v26) - ((((0.9486832980505138 * w4[i]) * v31) * v9) * v9);
        const double v37 = sin(v5);
        const double v39 = (0.9486832980505138 * v31) * v9;
        const double v47 = g[7 * i + 1] * p[0];
        const double v51 = g[7 * i + 4];
        const double v52 = (w2[i + 1] - w2[i]) * v51;
        const double v58 = (w0[i + 1] - w0[i]) * v51;
        const double v64 = (v6 * (v52 * v35)) - ((v6 * (v58 * v39)) + (v37 * (v52 * v39)));
        const double v68 = 0.5 * (v64 - (v37 * (v58 * v35)));
        const double v72 = ((c16 * ((-0.5) * v14)) * v20) / v47;
        w9[i] = (v6 * v35) - (v37 * v39);
        w10[i] = (v6 * v39) + (v37 * v35);
        w11[i] = -(v47 * (v68 - v72));
        w12[i] = -(v47 * (v72 + v68));
    }
}

static void rates_9(int n, int slots, const double *p, const double *g, double *w, double *f)
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
    const double c17 = squared(c5);
    const double c18 = c7 * c17;
    const double c19 = c18 * c5;
    const double c20 = c4 / c19;
    for (int i = 1; i < n - 1; i++) {
        f[slots * i + 2] = (w9[i] - w9[i - 1]) * (c9 * g[7 * i + 6]);
        f[slots * i + 4] = (w11[i] + w12[i - 1]) * (c20 * g[7 * i + 5]);
    }
}

static void rates_10(int n, int slots, double t, const double *p, const double *g, double *w, double *f)
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
        f[slots * i + 3] = ((w10[i] - w10[i - 1]) * (c9 * g[7 * i + 6])) - c34;
    }
}

static void rates_11(int n, int slots, double t, const double *p, const double *g, double *w, double *f)
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
    f[slots * i + 3] = (w10[i] * (c7 * g[7 * i + 6])) - c32;
    (void)n;
}

static void jacobian_0(int n, int entries, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[entries * i + 0] = 1.0;
    }
}

static void jacobian_1(int n, int entries, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[entries * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, int slots, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[slots * i + 0];
        w1[i] = y[slots * i + 4];
    }
}

static void jacobian_3(int n, int slots, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[slots * i + 1];
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
        const double v40 = 1.0 / (g[7 * i + 1] * p[0]);
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

static void jacobian_7(int n, int fibres, int slots, int entries, const double *zeta, const double *weight, const double *p, const double *y, double *w, double *e)
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
    double *restrict each1 = w + (SCRATCH + 1 * fibres) * n;
    double *restrict each2 = w + (SCRATCH + 2 * fibres) * n;
    double *restrict each3 = w + (SCRATCH + 3 * fibres) * n;
    double *restrict each4 = w + (SCRATCH + 4 * fibres) * n;
    double *restrict each5 = w + (SCRATCH + 5 * fibres) * n;
    const double c7 = p[1];
    const double c20 = p[5];
    const double c39 = 1.0 + p[8];
    const double c40 = c20 / c39;
    const double c206 = p[7];
    const double c213 = 1e-12 * c20;
    const double c214 = squared(c213);
    const double c223 = p[9];
    const double c228 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum0 = 0.0;
        double sum1 = 0.0;
        double sum10 = 0.0;
        double sum11 = 0.0;
        double sum2 = 0.0;
        double sum3 = 0.0;
        double sum4 = 0.0;
        double sum5 = 0.0;
        double sum6 = 0.0;
        double sum7 = 0.0;
        double sum8 = 0.0;
        double sum9 = 0.0;
        const double v4 = (-0.5) * w5[i];
        const double v9 = w3[i];
        const double v10 = sqrt(v9);
        const double v12 = 1.0 / (v10 * v9);
        const double v14 = log(v9);
        const double v25 = 1.0 / v9;
        const double v26 = (0.9486832980505138 * w4[i]) * v25;
        const double v69 = w13[i];
        const double v72 = w19[i];
        const double v76 = w25[i];
        const double v79 = w14[i];
        const double v81 = w20[i];
        const double v84 = w26[i];
        const double v92 = w15[i];
        const double v94 = w21[i];
        const double v97 = w16[i];
        const double v99 = w22[i];
        const double v102 = w17[i];
        const double v104 = w23[i];
        const double v107 = w18[i];
        const double v109 = w24[i];
        const double v269 = v26 * v25;
        const double v278 = 1.0 / (2.0 * v10);
        for (int k = 0; k < fibres; k++) {
            const double v5 = zeta[k];
            const double v13 = ((v4 * v5) * c7) * v12;
            const double v17 = (v13 + v14) - y[slots * i + 5 + k];
            const double v19 = exp((-1.5) * v17);
            const double v27 = y[slots * i + 5 + 1 * fibres + k];
            const double v29 = v26 - (v27 * v19);
            const double v33 = c20 * (v17 + (0.25 * squared(v29)));
            const double v35 = 0.5 * v29;
            const double v42 = (v33 * v35) + (c40 * v35);
            const double v44 = 1.5 * v27;
            const double v45 = weight[k];
            const double v46 = v44 * v45;
            const double v50 = v19 * v46;
            const double v53 = c20 * (v45 + (v35 * v50));
            const double v59 = 2.0 * v29;
            const double v62 = (0.5 * ((c40 * v50) + (v33 * v50))) + (v59 * (0.25 * v53));
            const double v66 = (((-1.5) * (v19 * (v42 * v46))) + v53) - ((-1.5) * (v19 * (v27 * v62)));
            const double v87 = v42 * v19;
            const double v113 = v45 * v5;
            const double v114 = v44 * v113;
            const double v118 = v19 * v114;
            const double v121 = c20 * (v113 + (v35 * v118));
            const double v129 = (0.5 * ((c40 * v118) + (v33 * v118))) + (v59 * (0.25 * v121));
            const double v133 = (((-1.5) * (v19 * (v42 * v114))) + v121) - ((-1.5) * (v19 * (v27 * v129)));
            const double v166 = c20 * (v35 * v45);
            const double v173 = (0.5 * ((c40 * v45) + (v33 * v45))) + (v59 * (0.25 * v166));
            const double v177 = v166 - ((-1.5) * (v19 * (v27 * v173)));
            const double v211 = squared(v33) + (3.0 * squared(v87));
            const double v216 = sqrt(larger(v211, c214));
            const double v217 = (double)(c206 < v216);
            const double v272 = v13 * v12;
            const double v412 = v33 + (v44 * v87);
            const double v425 = v272 * v66;
            const double v430 = (((v66 * v25) - (v269 * v62)) - (v10 * v425)) - ((v9 * v425) * v278);
            const double v440 = v272 * v133;
            const double v445 = (((v133 * v25) - (v269 * v129)) - (v10 * v440)) - ((v9 * v440) * v278);
            const double v455 = v272 * v177;
            const double v460 = (((v177 * v25) - (v269 * v173)) - (v10 * v455)) - ((v9 * v455) * v278);
            if (v217 != 0.0) {
                const double v218 = 2.0 * v87;
                const double v219 = (double)(c214 <= v211);
                const double v222 = v219 / (v219 + (double)(v211 <= c214));
                const double v224 = 1.0 / v216;
                const double v225 = c223 * v224;
                const double v231 = (v216 - c206) * c228;
                const double v233 = (v33 * v231) * v224;
                const double v234 = v233 * v224;
                const double v238 = 1.0 / (2.0 * v216);
                const double v240 = v222 * ((((v33 * v225) * c228) - (v234 * c223)) * v238);
                const double v242 = v218 * (3.0 * v240);
                const double v246 = v231 * v225;
                const double v247 = v19 * v242;
                const double v250 = 2.0 * v33;
                const double v253 = c20 * ((v246 + (v35 * v247)) + (v250 * v240));
                const double v261 = (0.5 * ((c40 * v247) + (v33 * v247))) + (v59 * (0.25 * v253));
                const double v265 = (((-1.5) * (v19 * (v42 * v242))) + v253) - ((-1.5) * (v19 * (v27 * v261)));
                e[entries * i + 29 + 15 * fibres + k] = -v265;
                const double v273 = v272 * v265;
                const double v280 = (((v265 * v25) - (v269 * v261)) - (v10 * v273)) - ((v9 * v273) * v278);
                const double v283 = 0.9486832980505138 * (v261 * v25);
                const double v289 = (-0.5) * (v5 * (c7 * (v265 * v12)));
                e[entries * i + 29 + 14 * fibres + k] = ((v280 * v69) + (v283 * v72)) + (v289 * v76);
                e[entries * i + 29 + 19 * fibres + k] = ((v280 * v79) + (v283 * v81)) + (v289 * v84);
                e[entries * i + 29 + 16 * fibres + k] = -(v19 * v261);
                e[entries * i + 29 + 12 * fibres + k] = (v280 * v92) + (v283 * v94);
                e[entries * i + 29 + 17 * fibres + k] = (v280 * v97) + (v283 * v99);
                e[entries * i + 29 + 13 * fibres + k] = (v280 * v102) + (v283 * v104);
                e[entries * i + 29 + 18 * fibres + k] = (v280 * v107) + (v283 * v109);
                const double v319 = 3.0 * v87;
                const double v322 = ((-1.5) * v27) * c223;
                const double v323 = v322 * v224;
                const double v333 = (((v319 * v225) + (v33 * v323)) * c228) - (((((v319 * v231) * v224) * v224) * c223) + (v234 * v322));
                const double v335 = v222 * (v333 * v238);
                const double v338 = (3.0 * v246) + (v218 * (3.0 * v335));
                const double v343 = v19 * v338;
                const double v348 = c20 * (((v231 * v323) + (v35 * v343)) + (v250 * v335));
                const double v356 = (0.5 * ((c40 * v343) + (v33 * v343))) + (v59 * (0.25 * v348));
                const double v360 = (((-1.5) * (v19 * (v42 * v338))) + v348) - ((-1.5) * (v19 * (v27 * v356)));
                e[entries * i + 29 + 23 * fibres + k] = -v360;
                const double v366 = v272 * v360;
                const double v371 = (((v360 * v25) - (v269 * v356)) - (v10 * v366)) - ((v9 * v366) * v278);
                const double v374 = 0.9486832980505138 * (v356 * v25);
                const double v380 = (-0.5) * (v5 * (c7 * (v360 * v12)));
                e[entries * i + 29 + 22 * fibres + k] = ((v371 * v69) + (v374 * v72)) + (v380 * v76);
                e[entries * i + 29 + 27 * fibres + k] = ((v371 * v79) + (v374 * v81)) + (v380 * v84);
                e[entries * i + 29 + 24 * fibres + k] = ((-1.5) * (v233 * c223)) - (v19 * v356);
                e[entries * i + 29 + 20 * fibres + k] = (v371 * v92) + (v374 * v94);
                e[entries * i + 29 + 25 * fibres + k] = (v371 * v97) + (v374 * v99);
                e[entries * i + 29 + 21 * fibres + k] = (v371 * v102) + (v374 * v104);
                e[entries * i + 29 + 26 * fibres + k] = (v371 * v107) + (v374 * v109);
            }
            each0[fibres * i + k] = -v66;
            each1[fibres * i + k] = (1.5 * (v87 * v45)) - (v19 * v62);
            each2[fibres * i + k] = -v133;
            each3[fibres * i + k] = (1.5 * (v87 * v113)) - (v19 * v129);
            each4[fibres * i + k] = -v177;
            each5[fibres * i + k] = -(v19 * v173);
            sum0 += v412 * v45;
            sum1 += v412 * v113;
            sum10 += 0.9486832980505138 * (v173 * v25);
            sum11 += (-0.5) * (v5 * (c7 * (v177 * v12)));
            sum2 += v42 * v45;
            sum3 += v430;
            sum4 += 0.9486832980505138 * (v62 * v25);
            sum5 += (-0.5) * (v5 * (c7 * (v66 * v12)));
            sum6 += v445;
            sum7 += 0.9486832980505138 * (v129 * v25);
            sum8 += (-0.5) * (v5 * (c7 * (v133 * v12)));
            sum9 += v460;
        }
        const double v68 = sum3;
        const double v71 = sum4;
        const double v75 = sum5;
        const double v135 = sum6;
        const double v137 = sum7;
        const double v140 = sum8;
        const double v179 = sum9;
        const double v181 = sum10;
        const double v184 = sum11;
        w6[i] = sum0;
        w27[i] = ((v68 * v69) + (v71 * v72)) + (v75 * v76);
        w28[i] = ((v68 * v79) + (v71 * v81)) + (v75 * v84);
        w29[i] = (v68 * v92) + (v71 * v94);
        w30[i] = (v68 * v97) + (v71 * v99);
        w31[i] = (v68 * v102) + (v71 * v104);
        w32[i] = (v68 * v107) + (v71 * v109);
        w7[i] = sum1;
        w33[i] = ((v135 * v69) + (v137 * v72)) + (v140 * v76);
        w34[i] = ((v135 * v79) + (v137 * v81)) + (v140 * v84);
        w35[i] = (v135 * v92) + (v137 * v94);
        w36[i] = (v135 * v97) + (v137 * v99);
        w37[i] = (v135 * v102) + (v137 * v104);
        w38[i] = (v135 * v107) + (v137 * v109);
        w8[i] = sum2;
        w39[i] = ((v179 * v69) + (v181 * v72)) + (v184 * v76);
        w40[i] = ((v179 * v79) + (v181 * v81)) + (v184 * v84);
        w41[i] = (v179 * v92) + (v181 * v94);
        w42[i] = (v179 * v97) + (v181 * v99);
        w43[i] = (v179 * v102) + (v181 * v104);
        w44[i] = (v179 * v107) + (v181 * v109);
    }
}

static void jacobian_8(int n, int fibres, const double *p, const double *g, double *w)
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
    double *restrict each1 = w + (SCRATCH + 1 * fibres) * n;
    double *restrict each2 = w + (SCRATCH + 2 * fibres) * n;
    double *restrict each3 = w + (SCRATCH + 3 * fibres) * n;
    double *restrict each4 = w + (SCRATCH + 4 * fibres) * n;
    double *restrict each5 = w + (SCRATCH + 5 * fibres) * n;
    double *restrict each6 = w + (SCRATCH + 6 * fibres) * n;
    double *restrict each7 = w + (SCRATCH + 7 * fibres) * n;
    double *restrict each8 = w + (SCRATCH + 8 * fibres) * n;
    double *restrict each9 = w + (SCRATCH + 9 * fibres) * n;
    double *restrict each10 = w + (SCRATCH + 10 * fibres) * n;
    double *restrict each11 = w + (SCRATCH + 11 * fibres) * n;
    double *restrict each12 = w + (SCRATCH + 12 * fibres) * n;
    double *restrict each13 = w + (SCRATCH + 13 * fibres) * n;
    const double c16 = p[1];
    for (int i = 0; i < n - 1; i++) {
        const double v5 = (w1[i] + w1[i + 1]) * 0.5;
        const double v6 = cos(v5);
        const double v8 = w3[i];
        const double v9 = 1.0 / v8;
        const double v10 = w6[i] * v9;
        const double v13 = (-0.5) * w5[i];
        const double v14 = w7[i];
        const double v18 = sqrt(v8);
        const double v20 = 1.0 / (v18 * v8);
        const double v22 = (((v13 * v14) * c16) * v20) * v20;
        const double v24 = 1.0 / (2.0 * v18);
        const double v25 = v8 * v24;
        const double v26 = v25 + v18;
        const double v31 = 0.9486832980505138 * w4[i];
        const double v32 = w8[i];
        const double v35 = ((v31 * v32) * v9) * v9;
        const double v36 = (v10 - (v22 * v26)) - v35;
        const double v38 = sin(v5);
        const double v40 = (0.9486832980505138 * v32) * v9;
        const double v42 = (v6 * v36) - (v38 * v40);
        const double v43 = v6 * v9;
        const double v46 = v26 * v6;
        const double v47 = v46 * v20;
        const double v49 = c16 * (v47 * v20);
        const double v50 = v13 * v49;
        const double v54 = v38 * v9;
        const double v56 = v43 * v9;
        const double v58 = (0.9486832980505138 * v54) + (v31 * v56);
        const double v62 = w27[i];
        const double v64 = w33[i];
        const double v69 = (v6 * v40) + (v38 * v36);
        const double v70 = 0.5 * v69;
        const double v72 = w39[i];
        const double v75 = v40 * v9;
        const double v77 = v35 * v9;
        const double v82 = v22 * v6;
        const double v85 = v22 * v20;
        const double v88 = (v85 * v46) + (v22 * v47);
        const double v90 = ((((v75 * v38) + (v77 * v6)) + (v35 * v43)) - (v82 * v24)) + (v18 * v88);
        const double v91 = v25 * v24;
        const double v99 = v10 * v9;
        const double v101 = (v90 + ((((2.0 * (v91 * v82)) - v82) + (v8 * v88)) * v24)) - (v99 * v6);
        const double v102 = w13[i];
        const double v104 = ((((v43 * v62) - (v50 * v64)) - v70) - (v58 * v72)) + (v101 * v102);
        const double v106 = 0.9486832980505138 * (v32 * v56);
        const double v107 = w19[i];
        const double v111 = (-0.5) * (v14 * v49);
        const double v112 = w25[i];
        const double v115 = w28[i];
        const double v117 = w34[i];
        const double v121 = w40[i];
        const double v124 = w14[i];
        const double v126 = ((((v43 * v115) - (v50 * v117)) - v70) - (v58 * v121)) + (v101 * v124);
        const double v127 = w20[i];
        const double v130 = w26[i];
        const double v141 = w29[i];
        const double v143 = w35[i];
        const double v146 = w41[i];
        const double v149 = w15[i];
        const double v151 = (((v43 * v141) - (v50 * v143)) - (v58 * v146)) + (v101 * v149);
        const double v152 = w21[i];
        const double v155 = w30[i];
        const double v157 = w36[i];
        const double v160 = w42[i];
        const double v163 = w16[i];
        const double v165 = (((v43 * v155) - (v50 * v157)) - (v58 * v160)) + (v101 * v163);
        const double v166 = w22[i];
        const double v169 = w31[i];
        const double v171 = w37[i];
        const double v174 = w43[i];
        const double v177 = w17[i];
        const double v179 = (((v43 * v169) - (v50 * v171)) - (v58 * v174)) + (v101 * v177);
        const double v180 = w23[i];
        const double v183 = w32[i];
        const double v185 = w38[i];
        const double v188 = w44[i];
        const double v191 = w18[i];
        const double v193 = (((v43 * v183) - (v50 * v185)) - (v58 * v188)) + (v101 * v191);
        const double v194 = w24[i];
        const double v198 = v26 * v38;
        const double v199 = v198 * v20;
        const double v201 = c16 * (v199 * v20);
        const double v202 = v13 * v201;
        const double v206 = v54 * v9;
        const double v208 = (0.9486832980505138 * v43) - (v31 * v206);
        const double v214 = 0.5 * v42;
        const double v223 = v22 * v38;
        const double v228 = (v85 * v198) + (v22 * v199);
        const double v230 = ((((v77 * v38) - (v75 * v6)) + (v35 * v54)) - (v223 * v24)) + (v18 * v228);
        const double v237 = v230 + ((((2.0 * (v91 * v223)) - v223) + (v8 * v228)) * v24);
        const double v239 = v237 - (v99 * v38);
        const double v241 = ((((v54 * v62) - (v202 * v64)) + v214) + (v208 * v72)) + (v239 * v102);
        const double v243 = 0.9486832980505138 * (v32 * v206);
        const double v247 = (-0.5) * (v14 * v201);
        const double v257 = ((((v54 * v115) - (v202 * v117)) + v214) + (v208 * v121)) + (v239 * v124);
        const double v273 = (((v54 * v141) - (v202 * v143)) + (v208 * v146)) + (v239 * v149);
        const double v282 = (((v54 * v155) - (v202 * v157)) + (v208 * v160)) + (v239 * v163);
        const double v291 = (((v54 * v169) - (v202 * v171)) + (v208 * v174)) + (v239 * v177);
        const double v300 = (((v54 * v183) - (v202 * v185)) + (v208 * v188)) + (v239 * v191);
        const double v305 = g[7 * i + 1] * p[0];
        const double v309 = g[7 * i + 4];
        const double v310 = (w2[i + 1] - w2[i]) * v309;
        const double v311 = v310 * v36;
        const double v316 = (w0[i + 1] - w0[i]) * v309;
        const double v317 = v316 * v40;
        const double v319 = v310 * v40;
        const double v323 = v316 * v36;
        const double v325 = ((v6 * v311) - ((v6 * v317) + (v38 * v319))) - (v38 * v323);
        const double v326 = 0.5 * v325;
        const double v329 = (c16 * ((-0.5) * v14)) * v20;
        const double v330 = v329 / v305;
        const double v334 = 0.5 * v305;
        const double v335 = v38 * v334;
        const double v337 = v6 * v334;
        const double v339 = (v316 * v335) - (v310 * v337);
        const double v340 = v339 * v9;
        const double v343 = (-0.5) * (c16 * v20);
        const double v344 = v26 * v339;
        const double v345 = v344 * v20;
        const double v347 = c16 * (v345 * v20);
        const double v348 = v13 * v347;
        const double v349 = v343 - v348;
        const double v354 = (v310 * v335) + (v316 * v337);
        const double v357 = v340 * v9;
        const double v359 = (0.9486832980505138 * (v354 * v9)) - (v31 * v357);
        const double v362 = v340 * v62;
        const double v372 = ((v6 * (v323 * v334)) + (v6 * (v319 * v334))) - (v38 * (v317 * v334));
        const double v376 = 0.5 * (v372 + (v38 * (v311 * v334)));
        const double v378 = v359 * v72;
        const double v385 = v22 * v339;
        const double v387 = (((v77 * v339) - (v75 * v354)) + (v35 * v340)) - (v385 * v24);
        const double v388 = v85 * v344;
        const double v389 = v329 * v20;
        const double v391 = v22 * v345;
        const double v392 = (v388 - v389) + v391;
        const double v397 = (2.0 * (v91 * v385)) - v385;
        const double v402 = v99 * v339;
        const double v403 = ((v387 + (v18 * v392)) + ((v397 + (v8 * v392)) * v24)) - v402;
        const double v407 = 0.9486832980505138 * (v32 * v357);
        const double v408 = v407 * v107;
        const double v409 = ((((v362 + (v349 * v64)) + v376) + v378) + (v403 * v102)) - v408;
        const double v411 = (-0.5) * (v14 * v347);
        const double v412 = v411 * v112;
        const double v414 = v340 * v115;
        const double v418 = v359 * v121;
        const double v422 = v407 * v127;
        const double v423 = ((((v414 + (v349 * v117)) + v376) + v418) + (v403 * v124)) - v422;
        const double v424 = v411 * v130;
        const double v431 = v340 * v141;
        const double v434 = v359 * v146;
        const double v438 = v407 * v152;
        const double v443 = ((v36 * v335) + (v40 * v337)) * v309;
        const double v444 = ((((v431 + (v349 * v143)) + v434) + (v403 * v149)) - v438) - v443;
        const double v445 = v340 * v155;
        const double v448 = v359 * v160;
        const double v452 = v407 * v166;
        const double v454 = ((((v445 + (v349 * v157)) + v448) + (v403 * v163)) - v452) + v443;
        const double v455 = v340 * v169;
        const double v458 = v359 * v174;
        const double v462 = v407 * v180;
        const double v467 = ((v40 * v335) - (v36 * v337)) * v309;
        const double v468 = ((((v455 + (v349 * v171)) + v458) + (v403 * v177)) - v462) - v467;
        const double v469 = v340 * v183;
        const double v472 = v359 * v188;
        const double v476 = v407 * v194;
        const double v478 = ((((v469 + (v349 * v185)) + v472) + (v403 * v191)) - v476) + v467;
        const double v482 = v343 + v348;
        const double v491 = (v389 + v388) + v391;
        const double v498 = ((v387 + (v18 * v491)) + ((v397 + (v8 * v491)) * v24)) - v402;
        const double v501 = ((((v362 - (v482 * v64)) + v376) + v378) + (v498 * v102)) - v408;
        const double v509 = ((((v414 - (v482 * v117)) + v376) + v418) + (v498 * v124)) - v422;
        const double v520 = ((((v431 - (v482 * v143)) + v434) + (v498 * v149)) - v438) - v443;
        const double v527 = ((((v445 - (v482 * v157)) + v448) + (v498 * v163)) - v452) + v443;
        const double v534 = ((((v455 - (v482 * v171)) + v458) + (v498 * v177)) - v462) - v467;
        const double v541 = ((((v469 - (v482 * v185)) + v472) + (v498 * v191)) - v476) + v467;
        w9[i] = v42;
        w45[i] = (v104 - (v106 * v107)) - (v111 * v112);
        w46[i] = (v126 - (v106 * v127)) - (v111 * v130);
        w47[i] = v151 - (v106 * v152);
        w48[i] = v165 - (v106 * v166);
        w49[i] = v179 - (v106 * v180);
        w50[i] = v193 - (v106 * v194);
        w10[i] = v69;
        w51[i] = (v241 - (v243 * v107)) - (v247 * v112);
        w52[i] = (v257 - (v243 * v127)) - (v247 * v130);
        w53[i] = v273 - (v243 * v152);
        w54[i] = v282 - (v243 * v166);
        w55[i] = v291 - (v243 * v180);
        w56[i] = v300 - (v243 * v194);
        w11[i] = -(v305 * (v326 - v330));
        w57[i] = v409 - v412;
        w58[i] = v423 - v424;
        w59[i] = v444;
        w60[i] = v454;
        w61[i] = v468;
        w62[i] = v478;
        w12[i] = -(v305 * (v330 + v326));
        w63[i] = v501 - v412;
        w64[i] = v509 - v424;
        w65[i] = v520;
        w66[i] = v527;
        w67[i] = v534;
        w68[i] = v541;
        for (int k = 0; k < fibres; k++) {
            const double v44 = each0[fibres * i + k];
            const double v51 = each2[fibres * i + k];
            const double v59 = each4[fibres * i + k];
            const double v133 = each1[fibres * i + k];
            const double v135 = each3[fibres * i + k];
            const double v138 = each5[fibres * i + k];
            const double v341 = v340 * v44;
            const double v360 = v359 * v59;
            const double v426 = v340 * v133;
            const double v429 = v359 * v138;
            each6[fibres * i + k] = ((v43 * v44) - (v50 * v51)) - (v58 * v59);
            each7[fibres * i + k] = ((v43 * v133) - (v50 * v135)) - (v58 * v138);
            each8[fibres * i + k] = ((v54 * v44) - (v202 * v51)) + (v208 * v59);
            each9[fibres * i + k] = ((v54 * v133) - (v202 * v135)) + (v208 * v138);
            each10[fibres * i + k] = (v341 + (v349 * v51)) + v360;
            each11[fibres * i + k] = (v426 + (v349 * v135)) + v429;
            each12[fibres * i + k] = (v341 - (v482 * v51)) + v360;
            each13[fibres * i + k] = (v426 - (v482 * v135)) + v429;
        }
    }
}

static void jacobian_9(int n, int fibres, int entries, const double *p, const double *g, double *w, double *e)
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
    double *restrict each6 = w + (SCRATCH + 6 * fibres) * n;
    double *restrict each7 = w + (SCRATCH + 7 * fibres) * n;
    double *restrict each10 = w + (SCRATCH + 10 * fibres) * n;
    double *restrict each11 = w + (SCRATCH + 11 * fibres) * n;
    double *restrict each12 = w + (SCRATCH + 12 * fibres) * n;
    double *restrict each13 = w + (SCRATCH + 13 * fibres) * n;
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
        e[entries * i + 4] = -(v9 * w45[i - 1]);
        e[entries * i + 7] = (v9 * w45[i]) - (v9 * w46[i - 1]);
        e[entries * i + 10] = v9 * w46[i];
        e[entries * i + 2] = -(v9 * w47[i - 1]);
        e[entries * i + 5] = (v9 * w47[i]) - (v9 * w48[i - 1]);
        e[entries * i + 8] = v9 * w48[i];
        e[entries * i + 3] = -(v9 * w49[i - 1]);
        e[entries * i + 6] = (v9 * w49[i]) - (v9 * w50[i - 1]);
        e[entries * i + 9] = v9 * w50[i];
        e[entries * i + 22] = v56 * w63[i - 1];
        e[entries * i + 25] = (v56 * w57[i]) + (v56 * w64[i - 1]);
        e[entries * i + 28] = v56 * w58[i];
        e[entries * i + 20] = v56 * w65[i - 1];
        e[entries * i + 23] = (v56 * w59[i]) + (v56 * w66[i - 1]);
        e[entries * i + 26] = v56 * w60[i];
        e[entries * i + 21] = v56 * w67[i - 1];
        e[entries * i + 24] = (v56 * w61[i]) + (v56 * w68[i - 1]);
        e[entries * i + 27] = v56 * w62[i];
        for (int k = 0; k < fibres; k++) {
            e[entries * i + 29 + k] = -(v9 * each6[fibres * (i - 1) + k]);
            e[entries * i + 29 + 2 * fibres + k] = v9 * each6[fibres * i + k];
            e[entries * i + 29 + 1 * fibres + k] = -(v9 * each7[fibres * (i - 1) + k]);
            e[entries * i + 29 + 3 * fibres + k] = v9 * each7[fibres * i + k];
            e[entries * i + 29 + 8 * fibres + k] = v56 * each12[fibres * (i - 1) + k];
            e[entries * i + 29 + 10 * fibres + k] = v56 * each10[fibres * i + k];
            e[entries * i + 29 + 9 * fibres + k] = v56 * each13[fibres * (i - 1) + k];
            e[entries * i + 29 + 11 * fibres + k] = v56 * each11[fibres * i + k];
        }
    }
}

static void jacobian_10(int n, int fibres, int entries, const double *p, const double *g, double *w, double *e)
{
    double *restrict w51 = w + 51 * n;
    double *restrict w52 = w + 52 * n;
    double *restrict w53 = w + 53 * n;
    double *restrict w54 = w + 54 * n;
    double *restrict w55 = w + 55 * n;
    double *restrict w56 = w + 56 * n;
    double *restrict each8 = w + (SCRATCH + 8 * fibres) * n;
    double *restrict each9 = w + (SCRATCH + 9 * fibres) * n;
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[entries * i + 13] = -(v9 * w51[i - 1]);
        e[entries * i + 16] = (v9 * w51[i]) - (v9 * w52[i - 1]);
        e[entries * i + 19] = v9 * w52[i];
        e[entries * i + 11] = -(v9 * w53[i - 1]);
        e[entries * i + 14] = (v9 * w53[i]) - (v9 * w54[i - 1]);
        e[entries * i + 17] = v9 * w54[i];
        e[entries * i + 12] = -(v9 * w55[i - 1]);
        e[entries * i + 15] = (v9 * w55[i]) - (v9 * w56[i - 1]);
        e[entries * i + 18] = v9 * w56[i];
        for (int k = 0; k < fibres; k++) {
            e[entries * i + 29 + 4 * fibres + k] = -(v9 * each8[fibres * (i - 1) + k]);
            e[entries * i + 29 + 6 * fibres + k] = v9 * each8[fibres * i + k];
            e[entries * i + 29 + 5 * fibres + k] = -(v9 * each9[fibres * (i - 1) + k]);
            e[entries * i + 29 + 7 * fibres + k] = v9 * each9[fibres * i + k];
        }
    }
}

static void jacobian_11(int n, int fibres, int entries, const double *p, const double *g, double *w, double *e)
{
    double *restrict w51 = w + 51 * n;
    double *restrict w52 = w + 52 * n;
    double *restrict w53 = w + 53 * n;
    double *restrict w54 = w + 54 * n;
    double *restrict w55 = w + 55 * n;
    double *restrict w56 = w + 56 * n;
    double *restrict each8 = w + (SCRATCH + 8 * fibres) * n;
    double *restrict each9 = w + (SCRATCH + 9 * fibres) * n;
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[entries * i + 16] = v9 * w51[i];
    e[entries * i + 19] = v9 * w52[i];
    e[entries * i + 14] = v9 * w53[i];
    e[entries * i + 17] = v9 * w54[i];
    e[entries * i + 15] = v9 * w55[i];
    e[entries * i + 18] = v9 * w56[i];
    for (int k = 0; k < fibres; k++) {
        e[entries * i + 29 + 6 * fibres + k] = v9 * each8[fibres * i + k];
        e[entries * i + 29 + 7 * fibres + k] = v9 * each9[fibres * i + k];
    }
    (void)n;
}

static void rates_in_time_10(int n, int slots, double t, const double *p, double *f)
{
    const double c0 = p[9];
    const double c1 = squared(c0);
    const double c3 = c1 / p[0];
    const double c10 = t * c0;
    const double c11 = p[4];
    const double c12 = c10 / c11;
    const double c13 = larger(0.0, c12);
    const double c14 = smaller(1.0, c13);
    const double c15 = 6.0 * c14;
    const double c16 = (-15.0) + c15;
    const double c17 = c16 * c14;
    const double c18 = 10.0 + c17;
    const double c19 = p[3];
    const double c20 = 2.0 * c14;
    const double c21 = (double)(c13 <= 1.0);
    const double c22 = (double)(1.0 <= c13);
    const double c23 = c22 + c21;
    const double c24 = c21 / c23;
    const double c25 = (double)(0.0 <= c12);
    const double c26 = (double)(c12 <= 0.0);
    const double c27 = c26 + c25;
    const double c28 = c25 / c27;
    const double c29 = c0 / c11;
    const double c30 = c28 * c29;
    const double c31 = c24 * c30;
    const double c32 = c20 * c31;
    const double c33 = c14 * c32;
    const double c34 = squared(c14);
    const double c35 = c34 * c31;
    const double c36 = c33 + c35;
    const double c37 = c19 * c36;
    const double c38 = c18 * c37;
    const double c39 = c34 * c14;
    const double c40 = c19 * c39;
    const double c41 = 6.0 * c31;
    const double c42 = c14 * c41;
    const double c43 = c16 * c31;
    const double c44 = c42 + c43;
    const double c45 = c40 * c44;
    const double c46 = c38 + c45;
    const double c47 = c3 * c46;
    const double c48 = -c47;
    for (int i = 1; i < n - 1; i++) {
        f[slots * i + 3] = c48;
    }
}

static void rates_in_time_11(int n, int slots, double t, const double *p, double *f)
{
    const double c0 = p[9];
    const double c1 = squared(c0);
    const double c3 = c1 / p[0];
    const double c10 = t * c0;
    const double c11 = p[4];
    const double c12 = c10 / c11;
    const double c13 = larger(0.0, c12);
    const double c14 = smaller(1.0, c13);
    const double c15 = 6.0 * c14;
    const double c16 = (-15.0) + c15;
    const double c17 = c16 * c14;
    const double c18 = 10.0 + c17;
    const double c19 = p[3];
    const double c20 = 2.0 * c14;
    const double c21 = (double)(c13 <= 1.0);
    const double c22 = (double)(1.0 <= c13);
    const double c23 = c22 + c21;
    const double c24 = c21 / c23;
    const double c25 = (double)(0.0 <= c12);
    const double c26 = (double)(c12 <= 0.0);
    const double c27 = c26 + c25;
    const double c28 = c25 / c27;
    const double c29 = c0 / c11;
    const double c30 = c28 * c29;
    const double c31 = c24 * c30;
    const double c32 = c20 * c31;
    const double c33 = c14 * c32;
    const double c34 = squared(c14);
    const double c35 = c34 * c31;
    const double c36 = c33 + c35;
    const double c37 = c19 * c36;
    const double c38 = c18 * c37;
    const double c39 = c34 * c14;
    const double c40 = c19 * c39;
    const double c41 = 6.0 * c31;
    const double c42 = c14 * c41;
    const double c43 = c16 * c31;
    const double c44 = c42 + c43;
    const double c45 = c40 * c44;
    const double c46 = c38 + c45;
    const double c47 = c3 * c46;
    const double c48 = -c47;
    const int i = 0;
    f[slots * i + 3] = c48;
    (void)n;
}

static void work_0(int n, int fibres, int slots, const double *zeta, const double *weight, const double *p, const double *y, double *w)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w69 = w + 69 * n;
    const double c1 = p[7];
    const double c2 = p[5];
    const double c40 = 1.0 + p[8];
    const double c41 = c2 / c40;
    const double c49 = 1e-12 * c2;
    const double c50 = squared(c49);
    const double c56 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum12 = 0.0;
        const double v5 = (-0.5) * w5[i];
        const double v10 = w3[i];
        const double v12 = sqrt(v10) * v10;
        const double v14 = log(v10);
        const double v22 = (0.9486832980505138 * w4[i]) / v10;
        for (int k = 0; k < fibres; k++) {
            const double v17 = ((((v5 * zeta[k]) * p[1]) / v12) + v14) - y[slots * i + 5 + k];
            const double v26 = exp((-1.5) * v17);
            const double v28 = v22 - (y[slots * i + 5 + 1 * fibres + k] * v26);
            const double v32 = c2 * (v17 + (0.25 * squared(v28)));
            const double v36 = 0.5 * v28;
            const double v47 = squared(v32) + (3.0 * squared((((v32 * v36) + (c41 * v36)) * v26)));
            const double v52 = sqrt(larger(v47, c50));
            const double v61 = (double)(c1 < v52) != 0.0 ? ((v52 * ((v52 - c1) * c56)) * weight[k]) : 0.0;
            sum12 += v61;
        }
        w69[i] = sum12;
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
        q[1] += g[7 * i + 3] * (c27 * w2[i]);
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

static void work_slope_0(int n, int fibres, int slots, const double *zeta, const double *weight, const double *p, const double *y, double *w)
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
    double *restrict each14 = w + (SCRATCH + 14 * fibres) * n;
    double *restrict each15 = w + (SCRATCH + 15 * fibres) * n;
    const double c1 = p[7];
    const double c2 = p[5];
    const double c8 = p[1];
    const double c42 = 1.0 + p[8];
    const double c43 = c2 / c42;
    const double c51 = 1e-12 * c2;
    const double c52 = squared(c51);
    const double c63 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        double sum12 = 0.0;
        double sum13 = 0.0;
        double sum14 = 0.0;
        double sum15 = 0.0;
        const double v5 = (-0.5) * w5[i];
        const double v10 = w3[i];
        const double v11 = sqrt(v10);
        const double v13 = 1.0 / (v11 * v10);
        const double v15 = log(v10);
        const double v23 = 1.0 / v10;
        const double v24 = (0.9486832980505138 * w4[i]) * v23;
        const double v145 = v24 * v23;
        const double v153 = 2.0 * v11;
        for (int k = 0; k < fibres; k++) {
            const double v6 = zeta[k];
            const double v14 = ((v5 * v6) * c8) * v13;
            const double v18 = (v14 + v15) - y[slots * i + 5 + k];
            const double v25 = y[slots * i + 5 + 1 * fibres + k];
            const double v28 = exp((-1.5) * v18);
            const double v30 = v24 - (v25 * v28);
            const double v34 = c2 * (v18 + (0.25 * squared(v30)));
            const double v38 = 0.5 * v30;
            const double v45 = (v34 * v38) + (c43 * v38);
            const double v46 = v45 * v28;
            const double v49 = squared(v34) + (3.0 * squared(v46));
            const double v54 = sqrt(larger(v49, c52));
            const double v55 = (double)(c1 < v54);
            const double v65 = weight[k];
            double v98 = 0.0;
            double v120 = 0.0;
            if (v55 != 0.0) {
                const double v57 = (double)(c52 <= v49);
                const double v64 = (v54 - c1) * c63;
                const double v72 = (v57 / (v57 + (double)(v49 <= c52))) * (((v64 * v65) + ((v54 * v65) * c63)) / (2.0 * v54));
                const double v74 = (2.0 * v46) * (3.0 * v72);
                const double v78 = v28 * v74;
                const double v83 = c2 * ((v38 * v78) + ((2.0 * v34) * v72));
                const double v92 = (0.5 * ((c43 * v78) + (v34 * v78))) + ((2.0 * v30) * (0.25 * v83));
                const double v96 = (((-1.5) * (v28 * (v45 * v74))) + v83) - ((-1.5) * (v28 * (v25 * v92)));
                v98 = -v96;
                v120 = -(v28 * v92);
                sum12 += (v54 * v64) * v65;
                const double v149 = (v14 * v13) * v96;
                const double v155 = (((v96 * v23) - (v145 * v92)) - (v11 * v149)) - ((v10 * v149) / v153);
                sum13 += v155;
                sum14 += 0.9486832980505138 * (v92 * v23);
                sum15 += (-0.5) * (v6 * (c8 * (v96 * v13)));
            }
            each14[fibres * i + k] = v98;
            each15[fibres * i + k] = v120;
        }
        const double v99 = sum13;
        const double v102 = sum14;
        const double v106 = sum15;
        w69[i] = sum12;
        w70[i] = ((v99 * w13[i]) + (v102 * w19[i])) + (v106 * w25[i]);
        w71[i] = ((v99 * w14[i]) + (v102 * w20[i])) + (v106 * w26[i]);
        w72[i] = (v99 * w15[i]) + (v102 * w21[i]);
        w73[i] = (v99 * w16[i]) + (v102 * w22[i]);
        w74[i] = (v99 * w17[i]) + (v102 * w23[i]);
        w75[i] = (v99 * w18[i]) + (v102 * w24[i]);
    }
}

static void work_slope_1(int n, int slots, double t, const double *p, const double *g, double *s)
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
        s[slots * n + slots * i + 1] += g[7 * i + 3] * c27;
    }
}

static void work_slope_2(int n, int fibres, int slots, const double *p, const double *g, double *w, double *s)
{
    double *restrict w70 = w + 70 * n;
    double *restrict w71 = w + 71 * n;
    double *restrict w72 = w + 72 * n;
    double *restrict w73 = w + 73 * n;
    double *restrict w74 = w + 74 * n;
    double *restrict w75 = w + 75 * n;
    double *restrict each14 = w + (SCRATCH + 14 * fibres) * n;
    double *restrict each15 = w + (SCRATCH + 15 * fibres) * n;
    const double c0 = p[9];
    const double c3 = p[0] / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    for (int i = 0; i < n - 1; i++) {
        const double v8 = c6 * g[7 * i + 1];
        s[slots * i + 4] += v8 * w70[i];
        s[slots * (i + 1) + 4] += v8 * w71[i];
        s[slots * i + 0] += v8 * w72[i];
        s[slots * (i + 1) + 0] += v8 * w73[i];
        s[slots * i + 1] += v8 * w74[i];
        s[slots * (i + 1) + 1] += v8 * w75[i];
        for (int k = 0; k < fibres; k++) {
            s[slots * i + 5 + k] += v8 * each14[fibres * i + k];
            s[slots * i + 5 + 1 * fibres + k] += v8 * each15[fibres * i + k];
        }
    }
}

static void work_in_time_1(int n, double t, const double *p, const double *g, double *w, double *q)
{
    double *restrict w2 = w + 2 * n;
    const double c2 = p[9];
    const double c3 = p[2];
    const double c4 = p[0];
    const double c5 = c4 / c2;
    const double c6 = squared(c5);
    const double c7 = c3 * c6;
    const double c8 = c2 / c7;
    const double c9 = c4 * c3;
    const double c12 = 30.0 * p[3];
    const double c16 = t * c2;
    const double c17 = p[4];
    const double c18 = c16 / c17;
    const double c19 = larger(0.0, c18);
    const double c20 = smaller(1.0, c19);
    const double c21 = 1.0 - c20;
    const double c22 = squared(c21);
    const double c23 = c12 * c22;
    const double c24 = 2.0 * c20;
    const double c25 = (double)(c19 <= 1.0);
    const double c26 = (double)(1.0 <= c19);
    const double c27 = c26 + c25;
    const double c28 = c25 / c27;
    const double c29 = (double)(0.0 <= c18);
    const double c30 = (double)(c18 <= 0.0);
    const double c31 = c30 + c29;
    const double c32 = c29 / c31;
    const double c33 = c2 / c17;
    const double c34 = c32 * c33;
    const double c35 = c28 * c34;
    const double c36 = c24 * c35;
    const double c37 = c23 * c36;
    const double c38 = squared(c20);
    const double c39 = 2.0 * c21;
    const double c40 = c39 * c35;
    const double c41 = c12 * c40;
    const double c42 = c38 * c41;
    const double c43 = c37 - c42;
    const double c44 = c43 / c17;
    const double c45 = c9 * c44;
    const double c46 = c8 * c45;
    for (int i = 0; i < n; i++) {
        q[1] += g[7 * i + 3] * (w2[i] * c46);
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const int fibres = FIBRES;
    const int slots = SLOTS;
    const double *zeta = fibre_zeta;
    const double *weight = fibre_weight;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * slots; k++) f[k] = 0.0;
    rates_0(n, slots, y, f);
    rates_1(n, slots, y, f);
    rates_2(n, slots, y, w);
    rates_3(n, slots, y, w);
    rates_4(n, w);
    rates_5(n, w);
    rates_6(n, p, g, w);
    rates_7(n, fibres, slots, zeta, weight, p, y, w, f);
    rates_8(n, p, g, w);
    rates_9(n, slots, p, g, w, f);
    rates_10(n, slots, t, p, g, w, f);
    rates_11(n, slots, t, p, g, w, f);
    return SOFTCAT_SOLVED;
}

static int jacobian(const softcat_filament *filament, double t, const double *y, double *e,
                    double *w)
{
    const int n = filament->sites;
    const int fibres = FIBRES;
    const int slots = SLOTS;
    const int entries = ENTRIES;
    const double *zeta = fibre_zeta;
    const double *weight = fibre_weight;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * entries; k++) e[k] = 0.0;
    jacobian_0(n, entries, e);
    jacobian_1(n, entries, e);
    jacobian_2(n, slots, y, w);
    jacobian_3(n, slots, y, w);
    jacobian_4(n, w);
    jacobian_5(n, w);
    jacobian_6(n, p, g, w);
    jacobian_7(n, fibres, slots, entries, zeta, weight, p, y, w, e);
    jacobian_8(n, fibres, p, g, w);
    jacobian_9(n, fibres, entries, p, g, w, e);
    jacobian_10(n, fibres, entries, p, g, w, e);
    jacobian_11(n, fibres, entries, p, g, w, e);
    return SOFTCAT_SOLVED;
}

static int work(const softcat_filament *filament, double t, const double *y, double *q,
                double *w)
{
    const int n = filament->sites;
    const int fibres = FIBRES;
    const int slots = SLOTS;
    const double *zeta = fibre_zeta;
    const double *weight = fibre_weight;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, fibres, slots, zeta, weight, p, y, w);
    work_1(n, t, p, g, w, q);
    work_2(n, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const int fibres = FIBRES;
    const int slots = SLOTS;
    const double *zeta = fibre_zeta;
    const double *weight = fibre_weight;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 3 * slots; k++) s[k] = 0.0;
    work_slope_0(n, fibres, slots, zeta, weight, p, y, w);
    work_slope_1(n, slots, t, p, g, s);
    work_slope_2(n, fibres, slots, p, g, w, s);
    return SOFTCAT_SOLVED;
}

static int rates_in_time(const softcat_filament *filament, double t, const double *y, double *f,
                         double *w)
{
    const int n = filament->sites;
    const int slots = SLOTS;
    const double *p = filament->parameters;
    (void)y;
    (void)w;
    for (int k = 0; k < n * slots; k++) f[k] = 0.0;
    rates_in_time_10(n, slots, t, p, f);
    rates_in_time_11(n, slots, t, p, f);
    return SOFTCAT_SOLVED;
}

static int work_in_time(const softcat_filament *filament, double t, const double *y, double *q,
                        double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)y;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_in_time_1(n, t, p, g, w, q);
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
    37, 32, 10, 7, 332, 477, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope, rates_in_time, work_in_time,
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
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0};
static const double described_absolutes[] = {
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07, 1.0097667724851204e-07, 1.0097667724851204e-07,
    1.0097667724851204e-07};
static const double described_nodes[] = {
    0.0, 0.031039722597093384, 0.060345960398367905, 0.08801552385462369, 0.11413981681407237,
    0.13880513846651063, 0.16209296842472587, 0.18408023588487415, 0.20483957375497708,
    0.22443955859102746, 0.2429449371333104, 0.26041684019128203, 0.2769129845835544,
    0.29248786380007696, 0.3071929280163493, 0.32107675405432573, 0.33418520585146144,
    0.34656158596799563, 0.3582467786329611, 0.36927938480146, 0.37969584966935516,
    0.3895305830666099, 0.39881607312698425, 0.40758299360958483, 0.4158603052267968,
    0.4236753513133228, 0.43105394815236464, 0.4380204702573316, 0.4445979308907947,
    0.45080805808667507, 0.4566713664267978, 0.46220722480891885, 0.46743392043009074,
    0.4723687191967294, 0.477027922760942, 0.4814269223715297, 0.4855802497175565,
    0.48950162493244315, 0.4932040019171606, 0.49669961113224603, 0.5};
static const double described_initial_mean[] = {
    (-0.003)};
static const double described_initial_bending[] = {
    (-0.0004)};
static const double described_section_points[] = {
    (-0.9686578935148324), (-0.8784890847806422), (-0.7406139298699932), (-0.5721146443791073),
    (-0.394041993763766), (-0.2289535525667885), (-0.09821234188930718),
    (-0.019199555780713324), 0.019199555780713324, 0.09821234188930718, 0.2289535525667885,
    0.394041993763766, 0.5721146443791073, 0.7406139298699932, 0.8784890847806422,
    0.9686578935148324, 0.009809717052572466, 0.03541208817516074, 0.06691987890833648,
    0.0924224995935702, 0.1025893691493575, 0.09372308379650839, 0.06797964202358955,
    0.031143721300904526, 0.031143721300904526, 0.06797964202358955, 0.09372308379650839,
    0.1025893691493575, 0.0924224995935702, 0.06691987890833648, 0.03541208817516074,
    0.009809717052572466};

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
    .z = -1,
    .psi = 4,
    .q = -1,
    .rest_length = 0,
    .time_scale = 9,
    .gravity = 3,
    .density = 2,
    .span = -1,
    .drop = -1,
    .left_angle = -1,
    .right_angle = -1,
    .curvature = -1,
    .twist = -1,
    .motion = -1,
    .motion_rows = 0,
    .motion_width = 3,
    .turn = -1,
    .turn_rows = 0,
    .stretch = 1.0,
    .aspect = -1,
    .width = 1.0,
    .section = SOFTCAT_CIRCLE_IN_HALVES,
    .fibres = 16,
    .points = 16,
    .nodes = described_nodes,
    .plain_slots = 5,
    .plain_entries = 29,
    .plain_scratch = 76,
    .initial_mean = described_initial_mean,
    .initial_mean_count = 1,
    .initial_bending = described_initial_bending,
    .initial_bending_count = 1,
    .section_points = described_section_points,
    .grading = 9.404868286995688,
    .relative = 0.0002,
    .absolute = 1.0097667724851204e-07,
    .absolutes = described_absolutes,
    .largest_step = 0.001430007385655168,
    .method = 1,
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

size_t softcat_workspace_size(int cells, int n, const softcat_settings *settings)
{
    return softcat_structure_workspace_size(&softcat_filament_structure, cells, n, settings);
}

int softcat_solve_with(const double *params, int cells, const double *times, int n,
    const softcat_settings *settings, const softcat_results *results, softcat_workspace workspace,
    softcat_status *status)
{
    return softcat_structure_solve(&softcat_filament_structure, params, cells, times, n, settings,
        results, workspace, status);
}

int softcat_solve(const double *params, int cells, const double *times, int n, double *out,
    softcat_workspace workspace, softcat_status *status)
{
    const softcat_results results = {.positions = out};
    return softcat_solve_with(params, cells, times, n, 0, &results, workspace, status);
}

int softcat_midpoint(const double *params, int cells, const double *times, int n, double *out,
    softcat_workspace workspace, softcat_status *status)
{
    const softcat_results results = {.midpoint = out};
    return softcat_solve_with(params, cells, times, n, 0, &results, workspace, status);
}

int softcat_solve_sensitivities(const double *params, int cells, const double *times, int n,
    const int *by, int by_count, double *out, double *derivatives, softcat_workspace workspace,
    softcat_status *status)
{
    const softcat_settings settings = {.by = by, .by_count = by_count};
    const softcat_results results = {.positions = out, .derivatives = derivatives};
    return softcat_solve_with(params, cells, times, n, &settings, &results, workspace, status);
}
