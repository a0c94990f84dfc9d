/*
 * Viscous blob drawn out into a bridge that sags
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-stress, shear, rotary-inertia
 * Digest of the structure: 035b7bf5dca9aac38b03ac47592e31134d2c1f5b218275a9f81490e53e6e2381
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

static inline double smaller(double a, double b) { return a < b ? a : b; }
static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double sign_of(double a) { return a > 0 ? 1.0 : a < 0 ? -1.0 : a; }
/* atan2, by the quicker atan where that is the same. */
static inline double angle_of(double y, double x) { return x > 0 ? atan(y / x) : atan2(y, x); }
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
    const double c1 = p[6];
    const double c3 = p[11];
    const double c4 = t * c3;
    const double c5 = p[5];
    const double c7 = larger(c5, 1e-300);
    const double c8 = c4 / c7;
    const double c10 = larger(c8, 0.0);
    const double c12 = smaller(c10, 1.0);
    const double c13 = c1 * c12;
    const double c15 = p[9] - c1;
    const double c16 = c4 - c5;
    const double c17 = p[8];
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
    const double c28 = p[7];
    const double c29 = c28 * c12;
    const double c31 = p[10] - c28;
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
    const double c1 = p[4];
    const double c4 = 1.0 / p[11];
    const double c49 = p[0];
    const double c50 = 1.0 / c49;
    const double c62 = p[1];
    const double c63 = (-0.4999999999999998) * c62;
    const double c81 = 0.5000000000000001 * c62;
    const double c92 = 0.3 * c1;
    const double c111 = 0.5 * c62;
    for (int i = 0; i < n - 1; i++) {
        const double v5 = w5[i] * c4;
        const double v7 = w5[i + 1] * c4;
        const double v10 = (v5 + v7) * 0.5;
        const double v15 = g[7 * i + 4];
        const double v16 = (w1[i + 1] - w1[i]) * v15;
        const double v17 = w2[i];
        const double v18 = w2[i + 1];
        const double v20 = (v17 + v18) * 0.5;
        const double v21 = cos(v20);
        const double v26 = (w0[i + 1] - w0[i]) * v15;
        const double v27 = sin(v20);
        const double v29 = (v16 * v21) - (v26 * v27);
        const double v36 = ((w3[i + 1] * c4) - (w3[i] * c4)) * v15;
        const double v44 = ((w4[i + 1] * c4) - (w4[i] * c4)) * v15;
        const double v46 = ((v10 * v29) + (v36 * v21)) + (v44 * v27);
        const double v51 = v15 * c50;
        const double v52 = (v18 - v17) * v51;
        const double v56 = (v26 * v21) + (v16 * v27);
        const double v57 = sqrt(v56);
        const double v58 = squared(v56);
        const double v60 = (0.75 * v52) / (v57 * v58);
        const double v65 = 1.0 / v56;
        const double v73 = 1.0 / (v57 * v56);
        const double v74 = ((-0.5) * ((v7 - v5) * v51)) * v73;
        const double v77 = c1 * ((v46 * ((v60 * c63) + v65)) + (v74 * c63));
        const double v87 = c1 * ((v46 * ((v60 * c81) + v65)) + (v74 * c81));
        const double v101 = ((((v44 * v21) - (v10 * v56)) - (v36 * v27)) * v65) - ((v29 * v46) / v58);
        const double v102 = c92 * v101;
        const double v105 = (0.5 * v102) + (0.4999999999999999 * v102);
        const double v106 = v105 * v65;
        const double v109 = (((0.5 * v77) + (0.4999999999999999 * v87)) * v65) - ((v29 * v106) * v65);
        const double v118 = (c111 * (((-0.2499999999999999) * v77) + (0.25 * v87))) * v73;
        const double v122 = v109 + (((1.5 * v118) * v52) * v65);
        w6[i] = (v122 * v21) - (v106 * v27);
        w7[i] = (v122 * v27) + (v106 * v21);
        w8[i] = ((g[7 * i + 1] * c49) * (v105 - (v29 * v122))) * 0.5;
        w9[i] = -v118;
    }
}

static void rates_5(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    const double c4 = squared(p[11]);
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
        const double v38 = (((w9[i] - w9[i - 1]) + w8[i]) + w8[i - 1]) * (c34 * g[7 * i + 5]);
        f[6 * i + 2] = (w6[i] - w6[i - 1]) * v12;
        f[6 * i + 3] = ((w7[i] - w7[i - 1]) * v12) - c19;
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
    const double c1 = p[6];
    const double c3 = p[11];
    const double c4 = t * c3;
    const double c5 = p[5];
    const double c7 = larger(c5, 1e-300);
    const double c8 = c4 / c7;
    const double c10 = larger(c8, 0.0);
    const double c12 = smaller(c10, 1.0);
    const double c13 = c1 * c12;
    const double c15 = p[9] - c1;
    const double c16 = c4 - c5;
    const double c17 = p[8];
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
    const double c28 = p[7];
    const double c29 = c28 * c12;
    const double c31 = p[10] - c28;
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
    const double c1 = p[4];
    const double c4 = 1.0 / p[11];
    const double c49 = p[0];
    const double c50 = 1.0 / c49;
    const double c63 = p[1];
    const double c64 = (-0.4999999999999998) * c63;
    const double c82 = 0.5000000000000001 * c63;
    const double c93 = 0.3 * c1;
    const double c113 = 0.5 * c63;
    for (int i = 0; i < n - 1; i++) {
        const double v5 = w5[i] * c4;
        const double v7 = w5[i + 1] * c4;
        const double v10 = (v5 + v7) * 0.5;
        const double v15 = g[7 * i + 4];
        const double v16 = (w1[i + 1] - w1[i]) * v15;
        const double v17 = w2[i];
        const double v18 = w2[i + 1];
        const double v20 = (v17 + v18) * 0.5;
        const double v21 = cos(v20);
        const double v26 = (w0[i + 1] - w0[i]) * v15;
        const double v27 = sin(v20);
        const double v29 = (v16 * v21) - (v26 * v27);
        const double v36 = ((w3[i + 1] * c4) - (w3[i] * c4)) * v15;
        const double v44 = ((w4[i + 1] * c4) - (w4[i] * c4)) * v15;
        const double v46 = ((v10 * v29) + (v36 * v21)) + (v44 * v27);
        const double v51 = v15 * c50;
        const double v52 = (v18 - v17) * v51;
        const double v56 = (v26 * v21) + (v16 * v27);
        const double v57 = sqrt(v56);
        const double v58 = squared(v56);
        const double v60 = 1.0 / (v57 * v58);
        const double v61 = (0.75 * v52) * v60;
        const double v66 = 1.0 / v56;
        const double v67 = (v61 * c64) + v66;
        const double v74 = 1.0 / (v57 * v56);
        const double v75 = ((-0.5) * ((v7 - v5) * v51)) * v74;
        const double v78 = c1 * ((v46 * v67) + (v75 * c64));
        const double v84 = (v61 * c82) + v66;
        const double v88 = c1 * ((v46 * v84) + (v75 * c82));
        const double v91 = ((0.5 * v78) + (0.4999999999999999 * v88)) * v66;
        const double v99 = (((v44 * v21) - (v10 * v56)) - (v36 * v27)) * v66;
        const double v101 = 1.0 / v58;
        const double v102 = (v29 * v46) * v101;
        const double v104 = c93 * (v99 - v102);
        const double v107 = (0.5 * v104) + (0.4999999999999999 * v104);
        const double v108 = v107 * v66;
        const double v110 = (v29 * v108) * v66;
        const double v120 = (c113 * (((-0.2499999999999999) * v78) + (0.25 * v88))) * v74;
        const double v121 = 1.5 * v120;
        const double v123 = (v121 * v52) * v66;
        const double v124 = (v91 - v110) + v123;
        const double v128 = v21 * v66;
        const double v130 = v27 + (v29 * v128);
        const double v131 = v130 * v66;
        const double v133 = c93 * (0.4999999999999999 * v131);
        const double v136 = c93 * (0.5 * v131);
        const double v138 = (v133 * v66) + (v136 * v66);
        const double v140 = v133 * v101;
        const double v142 = v136 * v101;
        const double v146 = 1.5 * (v52 * v128);
        const double v148 = c113 * (v146 * v74);
        const double v152 = c1 * ((0.25 * v148) + (0.4999999999999999 * v128));
        const double v158 = c1 * (((-0.2499999999999999) * v148) + (0.5 * v128));
        const double v160 = (((v29 * v140) + (v29 * v142)) + (v84 * v152)) + (v67 * v158);
        const double v163 = 0.5 * ((v56 * v138) + (v29 * v160));
        const double v164 = c82 * v152;
        const double v167 = c64 * v158;
        const double v171 = v51 * (((-0.5) * (v164 * v74)) + ((-0.5) * (v167 * v74)));
        const double v176 = v110 * v66;
        const double v178 = v123 * v66;
        const double v180 = v120 * v74;
        const double v181 = v180 * v146;
        const double v186 = 1.0 / (2.0 * v57);
        const double v189 = (v176 * v21) - (((v178 * v21) + (v57 * v181)) + ((v56 * v181) * v186));
        const double v190 = v108 * v66;
        const double v193 = 2.0 * v56;
        const double v194 = v102 * v101;
        const double v198 = v99 * v66;
        const double v200 = ((v189 + (v190 * v130)) - (v193 * (v194 * v133))) + (v198 * v133);
        const double v206 = v91 * v66;
        const double v208 = ((v200 - (v193 * (v194 * v136))) + (v198 * v136)) - (v206 * v21);
        const double v209 = v75 * v74;
        const double v210 = v209 * v164;
        const double v216 = v66 * v66;
        const double v217 = v46 * v152;
        const double v219 = ((v208 - (v57 * v210)) - ((v56 * v210) * v186)) - (v216 * v217);
        const double v220 = v61 * v60;
        const double v221 = c82 * v217;
        const double v222 = v220 * v221;
        const double v229 = v209 * v167;
        const double v231 = ((v219 - (v193 * (v57 * v222))) - ((v58 * v222) * v186)) - (v57 * v229);
        const double v235 = v46 * v158;
        const double v238 = c64 * v235;
        const double v239 = v220 * v238;
        const double v242 = ((v231 - ((v56 * v229) * v186)) - (v216 * v235)) - (v193 * (v57 * v239));
        const double v245 = v242 - ((v58 * v239) * v186);
        const double v251 = ((v46 * v140) - (v108 * v128)) + (v46 * v142);
        const double v258 = (v21 * ((v16 * v245) - (v26 * v251))) - ((v21 * v108) + (v27 * v124));
        const double v265 = v10 * v138;
        const double v270 = v10 * v160;
        const double v272 = (((v36 * v138) + (v16 * v265)) + (v44 * v160)) - (v26 * v270);
        const double v274 = (v258 - (v27 * ((v16 * v251) + (v26 * v245)))) + (v21 * v272);
        const double v281 = (((v26 * v265) - (v44 * v138)) + (v36 * v160)) + (v16 * v270);
        const double v284 = 0.5 * (v274 - (v27 * v281));
        const double v291 = ((v121 * v128) + (0.75 * (v221 * v60))) + (0.75 * (v238 * v60));
        const double v292 = v51 * v291;
        const double v299 = (((v27 * v138) + (v21 * v160)) * v15) * c4;
        const double v305 = (((v27 * v160) - (v21 * v138)) * v15) * c4;
        const double v313 = (((v21 * v265) - (v27 * v251)) + (v21 * v245)) - (v27 * v270);
        const double v314 = v313 * v15;
        const double v322 = (((v27 * v265) + (v21 * v251)) + (v27 * v245)) + (v21 * v270);
        const double v323 = v322 * v15;
        const double v328 = v27 * v66;
        const double v330 = 1.5 * (v52 * v328);
        const double v332 = c113 * (v330 * v74);
        const double v336 = c1 * ((0.25 * v332) + (0.4999999999999999 * v328));
        const double v339 = v21 - (v29 * v328);
        const double v340 = v339 * v66;
        const double v342 = c93 * (0.4999999999999999 * v340);
        const double v343 = v342 * v101;
        const double v346 = c93 * (0.5 * v340);
        const double v347 = v346 * v101;
        const double v354 = c1 * (((-0.2499999999999999) * v332) + (0.5 * v328));
        const double v356 = ((v84 * v336) - ((v29 * v343) + (v29 * v347))) + (v67 * v354);
        const double v360 = (v342 * v66) + (v346 * v66);
        const double v363 = 0.5 * ((v29 * v356) - (v56 * v360));
        const double v364 = c82 * v336;
        const double v367 = c64 * v354;
        const double v371 = v51 * (((-0.5) * (v364 * v74)) + ((-0.5) * (v367 * v74)));
        const double v383 = ((v108 * v328) + (v46 * v343)) + (v46 * v347);
        const double v387 = v180 * v330;
        const double v393 = (v176 * v27) - (((v178 * v27) + (v57 * v387)) + ((v56 * v387) * v186));
        const double v400 = ((v393 - (v190 * v339)) + (v193 * (v194 * v342))) - (v198 * v342);
        const double v407 = ((v400 + (v193 * (v194 * v346))) - (v198 * v346)) - (v206 * v27);
        const double v408 = v209 * v364;
        const double v414 = v46 * v336;
        const double v416 = ((v407 - (v57 * v408)) - ((v56 * v408) * v186)) - (v216 * v414);
        const double v417 = c82 * v414;
        const double v418 = v220 * v417;
        const double v425 = v209 * v367;
        const double v427 = ((v416 - (v193 * (v57 * v418))) - ((v58 * v418) * v186)) - (v57 * v425);
        const double v431 = v46 * v354;
        const double v434 = c64 * v431;
        const double v435 = v220 * v434;
        const double v438 = ((v427 - ((v56 * v425) * v186)) - (v216 * v431)) - (v193 * (v57 * v435));
        const double v441 = v438 - ((v58 * v435) * v186);
        const double v445 = ((v21 * v124) - (v27 * v108)) + (v21 * ((v26 * v383) + (v16 * v441)));
        const double v453 = v10 * v360;
        const double v457 = v10 * v356;
        const double v459 = ((v44 * v356) - ((v36 * v360) + (v16 * v453))) - (v26 * v457);
        const double v461 = (v445 - (v27 * ((v26 * v441) - (v16 * v383)))) + (v21 * v459);
        const double v468 = (((v44 * v360) - (v26 * v453)) + (v36 * v356)) + (v16 * v457);
        const double v471 = 0.5 * (v461 - (v27 * v468));
        const double v478 = ((v121 * v328) + (0.75 * (v417 * v60))) + (0.75 * (v434 * v60));
        const double v479 = v51 * v478;
        const double v486 = (((v21 * v356) - (v27 * v360)) * v15) * c4;
        const double v492 = (((v21 * v360) + (v27 * v356)) * v15) * c4;
        const double v500 = (((v27 * v383) - (v21 * v453)) + (v21 * v441)) - (v27 * v457);
        const double v501 = v500 * v15;
        const double v509 = ((v27 * v441) - ((v27 * v453) + (v21 * v383))) + (v21 * v457);
        const double v510 = v509 * v15;
        const double v512 = g[7 * i + 1] * c49;
        const double v517 = 0.5 * v512;
        const double v518 = v29 * v517;
        const double v519 = v518 * v66;
        const double v521 = 1.5 * (v52 * v519);
        const double v523 = c113 * (v521 * v74);
        const double v527 = c1 * ((0.25 * v523) + (0.4999999999999999 * v519));
        const double v528 = c82 * v527;
        const double v534 = c1 * (((-0.2499999999999999) * v523) + (0.5 * v519));
        const double v535 = c64 * v534;
        const double v539 = v51 * (((-0.5) * (v528 * v74)) + ((-0.5) * (v535 * v74)));
        const double v543 = v29 * v519;
        const double v545 = v517 + (v543 * v66);
        const double v547 = c93 * (0.4999999999999999 * v545);
        const double v548 = v547 * v101;
        const double v552 = c93 * (0.5 * v545);
        const double v553 = v552 * v101;
        const double v555 = (((v84 * v527) + (v67 * v534)) + (v29 * v548)) + (v29 * v553);
        const double v559 = (v547 * v66) + (v552 * v66);
        const double v562 = 0.5 * ((v29 * v555) + (v56 * v559));
        const double v569 = v46 * v527;
        const double v570 = c82 * v569;
        const double v574 = v46 * v534;
        const double v575 = c64 * v574;
        const double v578 = ((v121 * v519) + (0.75 * (v570 * v60))) + (0.75 * (v575 * v60));
        const double v579 = v51 * v578;
        const double v581 = v180 * v521;
        const double v588 = (((v178 * v518) + (v57 * v581)) + ((v56 * v581) * v186)) - (v176 * v518);
        const double v593 = v209 * v528;
        const double v598 = (((v588 - (v190 * v543)) + (v206 * v518)) + (v57 * v593)) + ((v56 * v593) * v186);
        const double v601 = v220 * v570;
        const double v607 = ((v598 + (v216 * v569)) + (v193 * (v57 * v601))) + ((v58 * v601) * v186);
        const double v608 = v209 * v535;
        const double v615 = ((v607 + (v57 * v608)) + ((v56 * v608) * v186)) + (v216 * v574);
        const double v616 = v220 * v575;
        const double v625 = ((v615 + (v193 * (v57 * v616))) + ((v58 * v616) * v186)) + (v193 * (v194 * v547));
        const double v632 = ((v625 - (v198 * v547)) + (v193 * (v194 * v552))) - (v198 * v552);
        const double v640 = (((v108 * v519) - (v124 * v517)) - (v46 * v548)) - (v46 * v553);
        const double v648 = (v21 * ((v16 * v632) - (v26 * v640))) - (v27 * ((v16 * v640) + (v26 * v632)));
        const double v649 = v10 * v555;
        const double v655 = v10 * v559;
        const double v657 = (((v26 * v649) - (v44 * v555)) - (v36 * v559)) - (v16 * v655);
        const double v666 = (v44 * v559) - (((v36 * v555) + (v16 * v649)) + (v26 * v655));
        const double v669 = 0.5 * ((v648 + (v21 * v657)) - (v27 * v666));
        const double v676 = (((v21 * v555) + (v27 * v559)) * v15) * c4;
        const double v682 = (((v21 * v559) - (v27 * v555)) * v15) * c4;
        const double v690 = (((v27 * v649) - (v27 * v640)) + (v21 * v632)) - (v21 * v655);
        const double v691 = v690 * v15;
        const double v699 = (((v21 * v640) - (v21 * v649)) + (v27 * v632)) - (v27 * v655);
        const double v700 = v699 * v15;
        const double v703 = c113 * v74;
        const double v705 = c1 * (0.25 * v703);
        const double v706 = c82 * v705;
        const double v710 = c1 * ((-0.2499999999999999) * v703);
        const double v711 = c64 * v710;
        const double v715 = v51 * (((-0.5) * (v706 * v74)) + ((-0.5) * (v711 * v74)));
        const double v718 = (v84 * v705) + (v67 * v710);
        const double v720 = 0.5 * (v29 * v718);
        const double v726 = v46 * v705;
        const double v727 = c82 * v726;
        const double v730 = v46 * v710;
        const double v731 = c64 * v730;
        const double v735 = v51 * ((0.75 * (v727 * v60)) + (0.75 * (v731 * v60)));
        const double v740 = v209 * v706;
        const double v745 = (((v57 * v180) + ((v56 * v180) * v186)) + (v57 * v740)) + ((v56 * v740) * v186);
        const double v748 = v220 * v727;
        const double v754 = ((v745 + (v216 * v726)) + (v193 * (v57 * v748))) + ((v58 * v748) * v186);
        const double v755 = v209 * v711;
        const double v762 = ((v754 + (v57 * v755)) + ((v56 * v755) * v186)) + (v216 * v730);
        const double v763 = v220 * v731;
        const double v769 = (v762 + (v193 * (v57 * v763))) + ((v58 * v763) * v186);
        const double v775 = v10 * v718;
        const double v780 = ((v21 * (v16 * v769)) - (v27 * (v26 * v769))) + (v21 * ((v26 * v775) - (v44 * v718)));
        const double v786 = 0.5 * (v780 + (v27 * ((v36 * v718) + (v16 * v775))));
        const double v791 = ((v21 * v718) * v15) * c4;
        const double v795 = ((v27 * v718) * v15) * c4;
        const double v800 = ((v21 * v769) + (v27 * v775)) * v15;
        const double v805 = ((v27 * v769) - (v21 * v775)) * v15;
        w6[i] = (v124 * v21) - (v108 * v27);
        w10[i] = (v163 - v171) * c4;
        w11[i] = (v171 + v163) * c4;
        w12[i] = v284 - v292;
        w13[i] = v292 + v284;
        w14[i] = -v299;
        w15[i] = v299;
        w16[i] = -v305;
        w17[i] = v305;
        w18[i] = -v314;
        w19[i] = v314;
        w20[i] = -v323;
        w21[i] = v323;
        w7[i] = (v124 * v27) + (v108 * v21);
        w22[i] = (v363 - v371) * c4;
        w23[i] = (v371 + v363) * c4;
        w24[i] = v471 - v479;
        w25[i] = v479 + v471;
        w26[i] = -v486;
        w27[i] = v486;
        w28[i] = -v492;
        w29[i] = v492;
        w30[i] = -v501;
        w31[i] = v501;
        w32[i] = -v510;
        w33[i] = v510;
        w8[i] = (v512 * (v107 - (v29 * v124))) * 0.5;
        w34[i] = (v539 - v562) * c4;
        w35[i] = -((v539 + v562) * c4);
        w36[i] = v579 + v669;
        w37[i] = v669 - v579;
        w38[i] = v676;
        w39[i] = -v676;
        w40[i] = -v682;
        w41[i] = v682;
        w42[i] = -v691;
        w43[i] = v691;
        w44[i] = -v700;
        w45[i] = v700;
        w9[i] = -v120;
        w46[i] = (v715 - v720) * c4;
        w47[i] = -((v715 + v720) * c4);
        w48[i] = v735 + v786;
        w49[i] = v786 - v735;
        w50[i] = v791;
        w51[i] = -v791;
        w52[i] = v795;
        w53[i] = -v795;
        w54[i] = -v800;
        w55[i] = v800;
        w56[i] = -v805;
        w57[i] = v805;
    }
}

static void jacobian_5(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[11]);
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
        const double v152 = ((v139 * w46[i]) - (v139 * w47[i - 1])) + (v139 * w35[i - 1]);
        const double v173 = ((v139 * w48[i]) - (v139 * w49[i - 1])) + (v139 * w37[i - 1]);
        const double v194 = ((v139 * w50[i]) - (v139 * w51[i - 1])) + (v139 * w39[i - 1]);
        const double v215 = ((v139 * w52[i]) - (v139 * w53[i - 1])) + (v139 * w41[i - 1]);
        const double v236 = ((v139 * w54[i]) - (v139 * w55[i - 1])) + (v139 * w43[i - 1]);
        const double v257 = ((v139 * w56[i]) - (v139 * w57[i - 1])) + (v139 * w45[i - 1]);
        e[57 * i + 7] = -(v9 * w10[i - 1]);
        e[57 * i + 13] = (v9 * w10[i]) - (v9 * w11[i - 1]);
        e[57 * i + 19] = v9 * w11[i];
        e[57 * i + 6] = -(v9 * w12[i - 1]);
        e[57 * i + 12] = (v9 * w12[i]) - (v9 * w13[i - 1]);
        e[57 * i + 18] = v9 * w13[i];
        e[57 * i + 4] = -(v9 * w14[i - 1]);
        e[57 * i + 10] = (v9 * w14[i]) - (v9 * w15[i - 1]);
        e[57 * i + 16] = v9 * w15[i];
        e[57 * i + 5] = -(v9 * w16[i - 1]);
        e[57 * i + 11] = (v9 * w16[i]) - (v9 * w17[i - 1]);
        e[57 * i + 17] = v9 * w17[i];
        e[57 * i + 2] = -(v9 * w18[i - 1]);
        e[57 * i + 8] = (v9 * w18[i]) - (v9 * w19[i - 1]);
        e[57 * i + 14] = v9 * w19[i];
        e[57 * i + 3] = -(v9 * w20[i - 1]);
        e[57 * i + 9] = (v9 * w20[i]) - (v9 * w21[i - 1]);
        e[57 * i + 15] = v9 * w21[i];
        e[57 * i + 25] = -(v9 * w22[i - 1]);
        e[57 * i + 31] = (v9 * w22[i]) - (v9 * w23[i - 1]);
        e[57 * i + 37] = v9 * w23[i];
        e[57 * i + 24] = -(v9 * w24[i - 1]);
        e[57 * i + 30] = (v9 * w24[i]) - (v9 * w25[i - 1]);
        e[57 * i + 36] = v9 * w25[i];
        e[57 * i + 22] = -(v9 * w26[i - 1]);
        e[57 * i + 28] = (v9 * w26[i]) - (v9 * w27[i - 1]);
        e[57 * i + 34] = v9 * w27[i];
        e[57 * i + 23] = -(v9 * w28[i - 1]);
        e[57 * i + 29] = (v9 * w28[i]) - (v9 * w29[i - 1]);
        e[57 * i + 35] = v9 * w29[i];
        e[57 * i + 20] = -(v9 * w30[i - 1]);
        e[57 * i + 26] = (v9 * w30[i]) - (v9 * w31[i - 1]);
        e[57 * i + 32] = v9 * w31[i];
        e[57 * i + 21] = -(v9 * w32[i - 1]);
        e[57 * i + 27] = (v9 * w32[i]) - (v9 * w33[i - 1]);
        e[57 * i + 33] = v9 * w33[i];
        e[57 * i + 44] = (v139 * w34[i - 1]) - (v139 * w46[i - 1]);
        e[57 * i + 50] = v152 + (v139 * w34[i]);
        e[57 * i + 56] = (v139 * w47[i]) + (v139 * w35[i]);
        e[57 * i + 43] = (v139 * w36[i - 1]) - (v139 * w48[i - 1]);
        e[57 * i + 49] = v173 + (v139 * w36[i]);
        e[57 * i + 55] = (v139 * w49[i]) + (v139 * w37[i]);
        e[57 * i + 41] = (v139 * w38[i - 1]) - (v139 * w50[i - 1]);
        e[57 * i + 47] = v194 + (v139 * w38[i]);
        e[57 * i + 53] = (v139 * w51[i]) + (v139 * w39[i]);
        e[57 * i + 42] = (v139 * w40[i - 1]) - (v139 * w52[i - 1]);
        e[57 * i + 48] = v215 + (v139 * w40[i]);
        e[57 * i + 54] = (v139 * w53[i]) + (v139 * w41[i]);
        e[57 * i + 39] = (v139 * w42[i - 1]) - (v139 * w54[i - 1]);
        e[57 * i + 45] = v236 + (v139 * w42[i]);
        e[57 * i + 51] = (v139 * w55[i]) + (v139 * w43[i]);
        e[57 * i + 40] = (v139 * w44[i - 1]) - (v139 * w56[i - 1]);
        e[57 * i + 46] = v257 + (v139 * w44[i]);
        e[57 * i + 52] = (v139 * w57[i]) + (v139 * w45[i]);
    }
}

static void work_0(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const double c2 = p[4];
    const double c4 = p[11];
    const double c5 = 1.0 / c4;
    const double c49 = p[0];
    const double c50 = 1.0 / c49;
    const double c62 = p[1];
    const double c63 = (-0.4999999999999998) * c62;
    const double c78 = 1.0 / c2;
    const double c81 = 3.3333333333333335 / c2;
    const double c83 = 0.3 * c2;
    const double c100 = 0.5000000000000001 * c62;
    const double c114 = c49 / c4;
    const double c115 = squared(c114);
    const double c116 = p[2] * c115;
    const double c117 = c4 / c116;
    for (int i = 0; i < n - 1; i++) {
        const double v6 = w5[i] * c5;
        const double v8 = w5[i + 1] * c5;
        const double v11 = (v6 + v8) * 0.5;
        const double v15 = g[7 * i + 4];
        const double v16 = (w1[i + 1] - w1[i]) * v15;
        const double v17 = w2[i];
        const double v18 = w2[i + 1];
        const double v20 = (v17 + v18) * 0.5;
        const double v21 = cos(v20);
        const double v26 = (w0[i + 1] - w0[i]) * v15;
        const double v27 = sin(v20);
        const double v29 = (v16 * v21) - (v26 * v27);
        const double v36 = ((w3[i + 1] * c5) - (w3[i] * c5)) * v15;
        const double v44 = ((w4[i + 1] * c5) - (w4[i] * c5)) * v15;
        const double v46 = ((v11 * v29) + (v36 * v21)) + (v44 * v27);
        const double v51 = v15 * c50;
        const double v56 = (v26 * v21) + (v16 * v27);
        const double v57 = sqrt(v56);
        const double v58 = squared(v56);
        const double v60 = (0.75 * ((v18 - v17) * v51)) / (v57 * v58);
        const double v65 = 1.0 / v56;
        const double v73 = ((-0.5) * ((v8 - v6) * v51)) / (v57 * v56);
        const double v79 = squared((c2 * ((v46 * ((v60 * c63) + v65)) + (v73 * c63)))) * c78;
        const double v92 = ((((v44 * v21) - (v11 * v56)) - (v36 * v27)) * v65) - ((v29 * v46) / v58);
        const double v95 = c81 * squared((c83 * v92));
        const double v107 = squared((c2 * ((v46 * ((v60 * c100) + v65)) + (v73 * c100))));
        const double v111 = (0.5 * (v79 + v95)) + (0.4999999999999999 * ((v107 * c78) + v95));
        q[0] += (g[7 * i + 1] * v111) * c117;
    }
}

static void work_1(int n, double *q)
{
    for (int i = 0; i < n - 1; i++) {
        q[1] += 0.0;
    }
}

static void work_2(int n, double t, const double *p, const double *g, double *w, double *q)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    const double c3 = p[11];
    const double c4 = t * c3;
    const double c5 = (double)(0.0 <= c4);
    const double c6 = p[5];
    const double c7 = (double)(c4 < c6);
    const double c8 = (double)((c5 != 0.0) && (c7 != 0.0));
    const double c9 = p[6];
    const double c10 = c8 * c9;
    const double c12 = larger(c6, 1e-300);
    const double c13 = c10 / c12;
    const double c14 = (double)(c6 <= c4);
    const double c15 = p[8];
    const double c16 = (double)(c4 < c15);
    const double c17 = (double)((c14 != 0.0) && (c16 != 0.0));
    const double c19 = p[9] - c9;
    const double c20 = c17 * c19;
    const double c21 = c15 - c6;
    const double c22 = larger(c21, 1e-300);
    const double c23 = c20 / c22;
    const double c24 = c13 + c23;
    const double c25 = p[0];
    const double c26 = c24 / c25;
    const double c30 = p[2];
    const double c36 = p[7];
    const double c37 = c8 * c36;
    const double c38 = c37 / c12;
    const double c40 = p[10] - c36;
    const double c41 = c17 * c40;
    const double c42 = c41 / c22;
    const double c43 = c38 + c42;
    const double c44 = c43 / c25;
    const double c47 = c25 / c3;
    const double c48 = squared(c47);
    const double c49 = c30 * c48;
    const double c50 = c3 / c49;
    const int i = n - 1;
    const double v46 = (w6[i - 1] * c26) + ((w7[i - 1] + (((g[7 * i + 3] * c30) * p[3]) * c25)) * c44);
    q[1] += v46 * c50;
    (void)n;
}

static void work_slope_0(int n, const double *p, const double *g, double *w, double *s)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const double c23 = p[0];
    const double c24 = 1.0 / c23;
    const double c37 = p[1];
    const double c38 = 0.5000000000000001 * c37;
    const double c42 = p[4];
    const double c44 = p[11];
    const double c45 = 1.0 / c44;
    const double c82 = c23 / c44;
    const double c83 = squared(c82);
    const double c84 = p[2] * c83;
    const double c85 = c44 / c84;
    const double c88 = 1.0 / c42;
    const double c94 = 0.3 * c42;
    const double c108 = 3.3333333333333335 / c42;
    const double c123 = (-0.4999999999999998) * c37;
    for (int i = 0; i < n - 1; i++) {
        const double v5 = g[7 * i + 4];
        const double v6 = (w1[i + 1] - w1[i]) * v5;
        const double v7 = w2[i];
        const double v8 = w2[i + 1];
        const double v11 = (v7 + v8) * 0.5;
        const double v12 = cos(v11);
        const double v17 = (w0[i + 1] - w0[i]) * v5;
        const double v18 = sin(v11);
        const double v20 = (v6 * v12) - (v17 * v18);
        const double v25 = v5 * c24;
        const double v30 = (v17 * v12) + (v6 * v18);
        const double v31 = sqrt(v30);
        const double v32 = squared(v30);
        const double v34 = 1.0 / (v31 * v32);
        const double v35 = (0.75 * ((v8 - v7) * v25)) * v34;
        const double v40 = 1.0 / v30;
        const double v41 = (v35 * c38) + v40;
        const double v46 = w5[i] * c45;
        const double v48 = w5[i + 1] * c45;
        const double v50 = (v46 + v48) * 0.5;
        const double v57 = ((w3[i + 1] * c45) - (w3[i] * c45)) * v5;
        const double v65 = ((w4[i + 1] * c45) - (w4[i] * c45)) * v5;
        const double v67 = ((v50 * v20) + (v57 * v12)) + (v65 * v18);
        const double v74 = 1.0 / (v31 * v30);
        const double v75 = ((-0.5) * ((v48 - v46) * v25)) * v74;
        const double v86 = g[7 * i + 1] * c85;
        const double v87 = 0.4999999999999999 * v86;
        const double v91 = c42 * ((2.0 * (c42 * ((v67 * v41) + (v75 * c38)))) * (v87 * c88));
        const double v100 = (((v65 * v12) - (v50 * v30)) - (v57 * v18)) * v40;
        const double v102 = 1.0 / v32;
        const double v103 = (v20 * v67) * v102;
        const double v106 = 2.0 * (c94 * (v100 - v103));
        const double v111 = c94 * (v106 * (c108 * v87));
        const double v112 = v111 * v102;
        const double v115 = 0.5 * v86;
        const double v118 = c94 * (v106 * (c108 * v115));
        const double v119 = v118 * v102;
        const double v125 = (v35 * c123) + v40;
        const double v132 = (2.0 * (c42 * ((v67 * v125) + (v75 * c123)))) * (v115 * c88);
        const double v133 = c42 * v132;
        const double v135 = (((v41 * v91) - (v20 * v112)) - (v20 * v119)) + (v125 * v133);
        const double v139 = (v111 * v40) + (v118 * v40);
        const double v142 = 0.5 * ((v20 * v135) - (v30 * v139));
        const double v143 = c38 * v91;
        const double v146 = c123 * v133;
        const double v150 = v25 * (((-0.5) * (v143 * v74)) + ((-0.5) * (v146 * v74)));
        const double v157 = (v67 * v112) + (v67 * v119);
        const double v159 = 2.0 * v30;
        const double v160 = v103 * v102;
        const double v163 = v100 * v40;
        const double v166 = v75 * v74;
        const double v167 = v166 * v143;
        const double v172 = 1.0 / (2.0 * v31);
        const double v174 = (((v159 * (v160 * v111)) - (v163 * v111)) - (v31 * v167)) - ((v30 * v167) * v172);
        const double v175 = v40 * v40;
        const double v176 = v67 * v91;
        const double v179 = v35 * v34;
        const double v180 = c38 * v176;
        const double v181 = v179 * v180;
        const double v187 = ((v174 - (v175 * v176)) - (v159 * (v31 * v181))) - ((v32 * v181) * v172);
        const double v193 = v166 * v146;
        const double v195 = ((v187 + (v159 * (v160 * v118))) - (v163 * v118)) - (v31 * v193);
        const double v199 = v67 * v133;
        const double v202 = c123 * v199;
        const double v203 = v179 * v202;
        const double v206 = ((v195 - ((v30 * v193) * v172)) - (v175 * v199)) - (v159 * (v31 * v203));
        const double v209 = v206 - ((v32 * v203) * v172);
        const double v217 = (v12 * ((v17 * v157) + (v6 * v209))) - (v18 * ((v17 * v209) - (v6 * v157)));
        const double v220 = v50 * v139;
        const double v224 = v50 * v135;
        const double v226 = ((v65 * v135) - ((v57 * v139) + (v6 * v220))) - (v17 * v224);
        const double v235 = (((v65 * v139) - (v17 * v220)) + (v57 * v135)) + (v6 * v224);
        const double v238 = 0.5 * ((v217 + (v12 * v226)) - (v18 * v235));
        const double v244 = v25 * ((0.75 * (v180 * v34)) + (0.75 * (v202 * v34)));
        const double v251 = (((v12 * v135) - (v18 * v139)) * v5) * c45;
        const double v257 = (((v12 * v139) + (v18 * v135)) * v5) * c45;
        const double v265 = (((v18 * v157) - (v12 * v220)) + (v12 * v209)) - (v18 * v224);
        const double v266 = v265 * v5;
        const double v274 = ((v18 * v209) - ((v12 * v157) + (v18 * v220))) + (v12 * v224);
        const double v275 = v274 * v5;
        s[6 * i + 5] += (v142 - v150) * c45;
        s[6 * i + 11] += (v150 + v142) * c45;
        s[6 * i + 4] += v238 - v244;
        s[6 * i + 10] += v244 + v238;
        s[6 * i + 2] += -v251;
        s[6 * i + 8] += v251;
        s[6 * i + 3] += -v257;
        s[6 * i + 9] += v257;
        s[6 * i] += -v266;
        s[6 * i + 6] += v266;
        s[6 * i + 1] += -v275;
        s[6 * i + 7] += v275;
    }
}

static void work_slope_2(int n, double t, const double *p, double *w, double *s)
{
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
    const double c0 = p[11];
    const double c2 = p[0];
    const double c3 = c2 / c0;
    const double c4 = squared(c3);
    const double c5 = p[2] * c4;
    const double c6 = c0 / c5;
    const double c9 = t * c0;
    const double c10 = (double)(0.0 <= c9);
    const double c11 = p[5];
    const double c12 = (double)(c9 < c11);
    const double c13 = (double)((c10 != 0.0) && (c12 != 0.0));
    const double c14 = p[6];
    const double c15 = c13 * c14;
    const double c17 = larger(c11, 1e-300);
    const double c18 = c15 / c17;
    const double c19 = (double)(c11 <= c9);
    const double c20 = p[8];
    const double c21 = (double)(c9 < c20);
    const double c22 = (double)((c19 != 0.0) && (c21 != 0.0));
    const double c24 = p[9] - c14;
    const double c25 = c22 * c24;
    const double c26 = c20 - c11;
    const double c27 = larger(c26, 1e-300);
    const double c28 = c25 / c27;
    const double c29 = c18 + c28;
    const double c30 = c29 / c2;
    const double c31 = c6 * c30;
    const double c34 = p[7];
    const double c35 = c13 * c34;
    const double c36 = c35 / c17;
    const double c38 = p[10] - c34;
    const double c39 = c22 * c38;
    const double c40 = c39 / c27;
    const double c41 = c36 + c40;
    const double c42 = c41 / c2;
    const double c43 = c6 * c42;
    const int i = n - 1;
    s[6 * n + 6 * i - 1] += (c31 * w10[i - 1]) + (c43 * w22[i - 1]);
    s[6 * n + 6 * i + 5] += (c31 * w11[i - 1]) + (c43 * w23[i - 1]);
    s[6 * n + 6 * i - 2] += (c31 * w12[i - 1]) + (c43 * w24[i - 1]);
    s[6 * n + 6 * i + 4] += (c31 * w13[i - 1]) + (c43 * w25[i - 1]);
    s[6 * n + 6 * i - 4] += (c31 * w14[i - 1]) + (c43 * w26[i - 1]);
    s[6 * n + 6 * i + 2] += (c31 * w15[i - 1]) + (c43 * w27[i - 1]);
    s[6 * n + 6 * i - 3] += (c31 * w16[i - 1]) + (c43 * w28[i - 1]);
    s[6 * n + 6 * i + 3] += (c31 * w17[i - 1]) + (c43 * w29[i - 1]);
    s[6 * n + 6 * i - 6] += (c31 * w18[i - 1]) + (c43 * w30[i - 1]);
    s[6 * n + 6 * i] += (c31 * w19[i - 1]) + (c43 * w31[i - 1]);
    s[6 * n + 6 * i - 5] += (c31 * w20[i - 1]) + (c43 * w32[i - 1]);
    s[6 * n + 6 * i + 1] += (c31 * w21[i - 1]) + (c43 * w33[i - 1]);
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
    rates_5(n, p, g, w, f);
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
    jacobian_5(n, p, g, w, e);
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
    work_0(n, p, g, w, q);
    work_1(n, q);
    work_2(n, t, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)y;
    for (int k = 0; k < n * 18; k++) s[k] = 0.0;
    work_slope_0(n, p, g, w, s);
    work_slope_2(n, t, p, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {2, 3, -1, -1, 5, -1};
static const int differential[] = {1, 1, 1, 1, 1, 1};
static const int held_first[] = {1, 1, 1, 1, 1, 1};
static const int held_last[] = {1, 1, 1, 1, 1, 1};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
static const int offset[] = {0, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5};

const softcat_model softcat_filament_model = {
    6, 0, 12, 7, 58, 57, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "viscosity", "motion_0_time",
    "motion_0_dx", "motion_0_dy", "motion_1_time", "motion_1_dx", "motion_1_dy", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa*s", "s", "m", "m", "s", "m", "m", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE, SOFTCAT_ANY, SOFTCAT_ANY, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_ANY, SOFTCAT_ANY, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.01, 0.004, 970.0, 9.81, 1470.0, 0.0, 0.0, 0.0, 0.5, 0.04, 0.0, 0.031927542840705044};
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
    .time_scale = 11,
    .gravity = 3,
    .density = 2,
    .span = -1,
    .drop = -1,
    .left_angle = -1,
    .right_angle = -1,
    .curvature = -1,
    .motion = 5,
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
