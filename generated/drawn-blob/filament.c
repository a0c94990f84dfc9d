/*
 * Viscous blob drawn out into a bridge that sags
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-stress, shear, rotary-inertia, surface-tension
 * Digest of the structure: 343788a79e5deaff189b1f599b4bf98a5c5762da7f8b213854cfd5f71a62f2a9
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

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
    const double c1 = p[4];
    const double c4 = 1.0 / p[12];
    const double c49 = p[0];
    const double c50 = 1.0 / c49;
    const double c62 = p[1];
    const double c63 = (-0.4999999999999998) * c62;
    const double c81 = 0.5000000000000001 * c62;
    const double c92 = 0.3 * c1;
    const double c111 = 0.5 * c62;
    const double c130 = p[5] / c62;
    const double c131 = 2.0 * c130;
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
        const double v125 = (v122 * v21) - (v106 * v27);
        const double v128 = (v122 * v27) + (v106 * v21);
        const double v135 = sqrt(squared(v26) + squared(v16));
        const double v138 = (c131 / sqrt(v135)) / v135;
        w6[i] = v125;
        w7[i] = v128;
        w8[i] = v125 + (v138 * v26);
        w9[i] = v128 + (v138 * v16);
        w10[i] = ((g[7 * i + 1] * c49) * (v105 - (v29 * v122))) * 0.5;
        w11[i] = -v118;
    }
}

static void rates_5(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    double *restrict w10 = w + 10 * n;
    double *restrict w11 = w + 11 * n;
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
        const double v38 = (((w11[i] - w11[i - 1]) + w10[i]) + w10[i - 1]) * (c34 * g[7 * i + 5]);
        f[6 * i + 2] = (w8[i] - w8[i - 1]) * v12;
        f[6 * i + 3] = ((w9[i] - w9[i - 1]) * v12) - c19;
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
    double *restrict w83 = w + 83 * n;
    const double c1 = p[4];
    const double c3 = p[12];
    const double c4 = 1.0 / c3;
    const double c49 = p[0];
    const double c50 = 1.0 / c49;
    const double c63 = p[1];
    const double c64 = (-0.4999999999999998) * c63;
    const double c82 = 0.5000000000000001 * c63;
    const double c93 = 0.3 * c1;
    const double c113 = 0.5 * c63;
    const double c128 = 0.5 / c3;
    const double c719 = p[5] / c63;
    const double c720 = 2.0 * c719;
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
        const double v127 = (v124 * v21) - (v108 * v27);
        const double v129 = v29 * c128;
        const double v130 = v67 * v129;
        const double v133 = ((-0.5) * (v51 * c4)) * v74;
        const double v134 = c64 * v133;
        const double v136 = c1 * (v130 - v134);
        const double v138 = v84 * v129;
        const double v139 = c82 * v133;
        const double v141 = c1 * (v138 - v139);
        const double v148 = c93 * (c128 + ((v29 * v129) * v101));
        const double v151 = (0.5 * v148) + (0.4999999999999999 * v148);
        const double v152 = v151 * v66;
        const double v154 = (v29 * v152) * v66;
        const double v155 = (((0.5 * v136) + (0.4999999999999999 * v141)) * v66) + v154;
        const double v160 = (c113 * (((-0.2499999999999999) * v136) + (0.25 * v141))) * v74;
        const double v164 = v155 + ((v52 * (1.5 * v160)) * v66);
        const double v166 = v27 * v152;
        const double v167 = (v21 * v164) + v166;
        const double v169 = c1 * (v130 + v134);
        const double v172 = c1 * (v138 + v139);
        const double v176 = (((0.5 * v169) + (0.4999999999999999 * v172)) * v66) + v154;
        const double v181 = (c113 * (((-0.2499999999999999) * v169) + (0.25 * v172))) * v74;
        const double v185 = v176 + ((v52 * (1.5 * v181)) * v66);
        const double v187 = (v21 * v185) + v166;
        const double v188 = 0.5 * v21;
        const double v190 = 0.5 * v27;
        const double v193 = (v16 * v190) + (v26 * v188);
        const double v197 = (v44 * v188) - ((v10 * v193) + (v36 * v190));
        const double v198 = v67 * v197;
        const double v200 = (0.75 * v51) * v60;
        const double v201 = v61 * v60;
        const double v204 = (v16 * v188) - (v26 * v190);
        const double v206 = 1.0 / (2.0 * v57);
        const double v207 = v204 * v206;
        const double v209 = 2.0 * v56;
        const double v210 = v209 * v204;
        const double v213 = v201 * ((v58 * v207) + (v57 * v210));
        const double v214 = v200 + v213;
        const double v216 = v66 * v66;
        const double v217 = v216 * v204;
        const double v221 = v75 * v74;
        const double v224 = (v56 * v207) + (v57 * v204);
        const double v225 = v221 * v224;
        const double v226 = c64 * v225;
        const double v228 = c1 * ((v198 - (v46 * ((c64 * v214) + v217))) - v226);
        const double v230 = v84 * v197;
        const double v235 = c82 * v225;
        const double v237 = c1 * ((v230 - (v46 * ((c82 * v214) + v217))) - v235);
        const double v241 = v91 * v66;
        const double v242 = v241 * v204;
        const double v243 = (((0.5 * v228) + (0.4999999999999999 * v237)) * v66) - v242;
        const double v251 = v99 * v66;
        const double v253 = ((((v44 * v190) + (v10 * v204)) + (v36 * v188)) * v66) + (v251 * v204);
        const double v258 = v102 * v101;
        const double v261 = v253 + ((((v29 * v197) - (v46 * v193)) * v101) - (v258 * v210));
        const double v262 = c93 * v261;
        const double v265 = (0.5 * v262) + (0.4999999999999999 * v262);
        const double v267 = v108 * v66;
        const double v269 = (v265 * v66) + (v267 * v204);
        const double v273 = v110 * v66;
        const double v275 = (((v108 * v193) + (v29 * v269)) * v66) + (v273 * v204);
        const double v281 = (c113 * (((-0.2499999999999999) * v228) + (0.25 * v237))) * v74;
        const double v282 = v120 * v74;
        const double v283 = v282 * v224;
        const double v284 = v281 - v283;
        const double v287 = v121 * v51;
        const double v290 = v123 * v66;
        const double v291 = v290 * v204;
        const double v293 = (v243 + v275) + ((((v52 * (1.5 * v284)) - v287) * v66) - v291);
        const double v295 = v124 * v190;
        const double v299 = (v108 * v188) - (v27 * v269);
        const double v300 = ((v21 * v293) - v295) - v299;
        const double v301 = v200 - v213;
        const double v307 = c1 * ((v198 + (v46 * ((c64 * v301) - v217))) - v226);
        const double v314 = c1 * ((v230 + (v46 * ((c82 * v301) - v217))) - v235);
        const double v318 = (((0.5 * v307) + (0.4999999999999999 * v314)) * v66) - v242;
        const double v324 = (c113 * (((-0.2499999999999999) * v307) + (0.25 * v314))) * v74;
        const double v325 = v324 - v283;
        const double v331 = (v318 + v275) + ((((v52 * (1.5 * v325)) + v287) * v66) - v291);
        const double v334 = ((v21 * v331) - v295) - v299;
        const double v335 = c4 * v15;
        const double v336 = v21 * v335;
        const double v338 = c1 * (v67 * v336);
        const double v341 = c1 * (v84 * v336);
        const double v345 = v27 * v335;
        const double v350 = c93 * ((v345 * v66) + ((v29 * v336) * v101));
        const double v353 = (0.5 * v350) + (0.4999999999999999 * v350);
        const double v354 = v353 * v66;
        const double v357 = (((0.5 * v338) + (0.4999999999999999 * v341)) * v66) + ((v29 * v354) * v66);
        const double v362 = (c113 * (((-0.2499999999999999) * v338) + (0.25 * v341))) * v74;
        const double v366 = v357 + ((v52 * (1.5 * v362)) * v66);
        const double v370 = -((v21 * v366) + (v27 * v354));
        const double v371 = v15 * c4;
        const double v372 = v21 * v371;
        const double v374 = c1 * (v67 * v372);
        const double v377 = c1 * (v84 * v372);
        const double v381 = v27 * v371;
        const double v386 = c93 * ((v381 * v66) + ((v29 * v372) * v101));
        const double v389 = (0.5 * v386) + (0.4999999999999999 * v386);
        const double v390 = v389 * v66;
        const double v393 = (((0.5 * v374) + (0.4999999999999999 * v377)) * v66) + ((v29 * v390) * v66);
        const double v398 = (c113 * (((-0.2499999999999999) * v374) + (0.25 * v377))) * v74;
        const double v402 = v393 + ((v52 * (1.5 * v398)) * v66);
        const double v405 = (v21 * v402) + (v27 * v390);
        const double v407 = c1 * (v67 * v345);
        const double v410 = c1 * (v84 * v345);
        const double v418 = c93 * (((v29 * v345) * v101) - (v336 * v66));
        const double v421 = (0.5 * v418) + (0.4999999999999999 * v418);
        const double v422 = v421 * v66;
        const double v425 = (((0.5 * v407) + (0.4999999999999999 * v410)) * v66) + ((v29 * v422) * v66);
        const double v430 = (c113 * (((-0.2499999999999999) * v407) + (0.25 * v410))) * v74;
        const double v434 = v425 + ((v52 * (1.5 * v430)) * v66);
        const double v438 = -((v21 * v434) + (v27 * v422));
        const double v440 = c1 * (v67 * v381);
        const double v443 = c1 * (v84 * v381);
        const double v451 = c93 * ((v372 * v66) - ((v29 * v381) * v101));
        const double v454 = (0.5 * v451) + (0.4999999999999999 * v451);
        const double v455 = v454 * v66;
        const double v458 = (((0.5 * v440) + (0.4999999999999999 * v443)) * v66) - ((v29 * v455) * v66);
        const double v463 = (c113 * (((-0.2499999999999999) * v440) + (0.25 * v443))) * v74;
        const double v467 = v458 + ((v52 * (1.5 * v463)) * v66);
        const double v470 = (v21 * v467) - (v27 * v455);
        const double v471 = v27 * v15;
        const double v472 = v10 * v471;
        const double v474 = v21 * v15;
        const double v475 = v474 * v206;
        const double v477 = v209 * v474;
        const double v480 = v201 * ((v58 * v475) + (v57 * v477));
        const double v482 = v216 * v474;
        const double v488 = (v56 * v475) + (v57 * v474);
        const double v489 = v221 * v488;
        const double v491 = ((v67 * v472) + (v46 * ((c64 * v480) + v482))) + (c64 * v489);
        const double v492 = c1 * v491;
        const double v500 = ((v84 * v472) + (v46 * ((c82 * v480) + v482))) + (c82 * v489);
        const double v501 = c1 * v500;
        const double v506 = (((0.5 * v492) + (0.4999999999999999 * v501)) * v66) + (v241 * v474);
        const double v507 = v108 * v471;
        const double v508 = v10 * v474;
        const double v511 = (v508 * v66) + (v251 * v474);
        const double v517 = (((v46 * v471) + (v29 * v472)) * v101) + (v258 * v477);
        const double v519 = c93 * (v511 - v517);
        const double v522 = (0.5 * v519) + (0.4999999999999999 * v519);
        const double v524 = v267 * v474;
        const double v525 = (v522 * v66) + v524;
        const double v529 = v273 * v474;
        const double v536 = (c113 * (((-0.2499999999999999) * v492) + (0.25 * v501))) * v74;
        const double v538 = v536 + (v282 * v488);
        const double v543 = ((v52 * (1.5 * v538)) * v66) + (v290 * v474);
        const double v544 = (v506 - (((v507 + (v29 * v525)) * v66) + v529)) + v543;
        const double v547 = (v21 * v544) - (v27 * v525);
        const double v549 = c93 * (v517 - v511);
        const double v552 = (0.5 * v549) + (0.4999999999999999 * v549);
        const double v554 = (v552 * v66) - v524;
        const double v560 = (v506 + ((((v29 * v554) - v507) * v66) - v529)) + v543;
        const double v563 = (v21 * v560) + (v27 * v554);
        const double v565 = v471 * v206;
        const double v567 = v209 * v471;
        const double v570 = v201 * ((v58 * v565) + (v57 * v567));
        const double v572 = v216 * v471;
        const double v574 = v46 * ((c64 * v570) + v572);
        const double v575 = v67 * v508;
        const double v579 = (v56 * v565) + (v57 * v471);
        const double v580 = v221 * v579;
        const double v581 = c64 * v580;
        const double v583 = c1 * ((v574 - v575) + v581);
        const double v587 = v46 * ((c82 * v570) + v572);
        const double v588 = v84 * v508;
        const double v590 = c82 * v580;
        const double v592 = c1 * ((v587 - v588) + v590);
        const double v596 = v241 * v471;
        const double v597 = (((0.5 * v583) + (0.4999999999999999 * v592)) * v66) + v596;
        const double v600 = (v472 * v66) + (v251 * v471);
        const double v601 = v258 * v567;
        const double v605 = ((v46 * v474) + (v29 * v508)) * v101;
        const double v608 = c93 * (v600 - (v601 - v605));
        const double v611 = (0.5 * v608) + (0.4999999999999999 * v608);
        const double v613 = v267 * v471;
        const double v614 = (v611 * v66) + v613;
        const double v616 = v108 * v474;
        const double v619 = v273 * v471;
        const double v626 = (c113 * (((-0.2499999999999999) * v583) + (0.25 * v592))) * v74;
        const double v627 = v282 * v579;
        const double v628 = v626 + v627;
        const double v632 = v290 * v471;
        const double v634 = (v597 - ((((v29 * v614) - v616) * v66) + v619)) + (((v52 * (1.5 * v628)) * v66) + v632);
        const double v637 = (v21 * v634) - (v27 * v614);
        const double v640 = c1 * ((v575 - v574) - v581);
        const double v644 = c1 * ((v588 - v587) - v590);
        const double v648 = (((0.5 * v640) + (0.4999999999999999 * v644)) * v66) - v596;
        const double v651 = c93 * (v600 + (v605 - v601));
        const double v654 = (0.5 * v651) + (0.4999999999999999 * v651);
        const double v656 = (v654 * v66) + v613;
        const double v666 = (c113 * (((-0.2499999999999999) * v640) + (0.25 * v644))) * v74;
        const double v667 = v666 - v627;
        const double v672 = (v648 - (((v616 - (v29 * v656)) * v66) - v619)) + (((v52 * (1.5 * v667)) * v66) - v632);
        const double v675 = (v21 * v672) + (v27 * v656);
        const double v678 = (v124 * v27) + (v108 * v21);
        const double v680 = v21 * v152;
        const double v681 = (v27 * v164) - v680;
        const double v683 = (v27 * v185) - v680;
        const double v685 = v124 * v188;
        const double v689 = (v21 * v269) + (v108 * v190);
        const double v690 = ((v27 * v293) + v685) - v689;
        const double v693 = ((v27 * v331) + v685) - v689;
        const double v696 = (v21 * v354) - (v27 * v366);
        const double v699 = (v27 * v402) - (v21 * v390);
        const double v702 = (v21 * v422) - (v27 * v434);
        const double v705 = (v27 * v467) + (v21 * v455);
        const double v708 = (v27 * v544) + (v21 * v525);
        const double v711 = (v21 * v554) - (v27 * v560);
        const double v714 = (v27 * v634) + (v21 * v614);
        const double v717 = (v27 * v672) - (v21 * v656);
        const double v724 = sqrt(squared(v26) + squared(v16));
        const double v725 = sqrt(v724);
        const double v726 = 1.0 / v725;
        const double v727 = c720 * v726;
        const double v728 = 1.0 / v724;
        const double v729 = v727 * v728;
        const double v732 = v727 * v726;
        const double v736 = 1.0 / (2.0 * v724);
        const double v737 = ((2.0 * v26) * v15) * v736;
        const double v739 = 1.0 / (2.0 * v725);
        const double v743 = v729 * v728;
        const double v745 = ((v732 * (v737 * v739)) * v728) + (v743 * v737);
        const double v746 = v26 * v745;
        const double v747 = v729 * v15;
        const double v754 = ((2.0 * v16) * v15) * v736;
        const double v759 = ((v732 * (v754 * v739)) * v728) + (v743 * v754);
        const double v760 = v26 * v759;
        const double v765 = v16 * v745;
        const double v768 = v16 * v759;
        const double v773 = g[7 * i + 1] * c49;
        const double v789 = v124 * v193;
        const double v818 = v124 * v471;
        const double v830 = v124 * v474;
        w6[i] = v127;
        w12[i] = v167;
        w13[i] = v187;
        w14[i] = v300;
        w15[i] = v334;
        w16[i] = v370;
        w17[i] = v405;
        w18[i] = v438;
        w19[i] = v470;
        w20[i] = v547;
        w21[i] = -v563;
        w22[i] = v637;
        w23[i] = v675;
        w7[i] = v678;
        w24[i] = v681;
        w25[i] = v683;
        w26[i] = v690;
        w27[i] = v693;
        w28[i] = v696;
        w29[i] = v699;
        w30[i] = v702;
        w31[i] = v705;
        w32[i] = v708;
        w33[i] = v711;
        w34[i] = v714;
        w35[i] = v717;
        w8[i] = v127 + (v729 * v26);
        w36[i] = v167;
        w37[i] = v187;
        w38[i] = v300;
        w39[i] = v334;
        w40[i] = v370;
        w41[i] = v405;
        w42[i] = v438;
        w43[i] = v470;
        w44[i] = v547 + (v746 - v747);
        w45[i] = (v747 - v746) - v563;
        w46[i] = v637 + v760;
        w47[i] = v675 - v760;
        w9[i] = v678 + (v729 * v16);
        w48[i] = v681;
        w49[i] = v683;
        w50[i] = v690;
        w51[i] = v693;
        w52[i] = v696;
        w53[i] = v699;
        w54[i] = v702;
        w55[i] = v705;
        w56[i] = v708 + v765;
        w57[i] = v711 - v765;
        w58[i] = v714 + (v768 - v747);
        w59[i] = v717 + (v747 - v768);
        w10[i] = (v773 * (v107 - (v29 * v124))) * 0.5;
        w60[i] = -(0.5 * (v773 * (v151 + (v29 * v164))));
        w61[i] = -(0.5 * (v773 * (v151 + (v29 * v185))));
        w62[i] = -(0.5 * (v773 * (v265 + ((v29 * v293) - v789))));
        w63[i] = -(0.5 * (v773 * (v265 + ((v29 * v331) - v789))));
        w64[i] = 0.5 * (v773 * (v353 + (v29 * v366)));
        w65[i] = -(0.5 * (v773 * (v389 + (v29 * v402))));
        w66[i] = 0.5 * (v773 * (v421 + (v29 * v434)));
        w67[i] = 0.5 * (v773 * (v454 - (v29 * v467)));
        w68[i] = 0.5 * (v773 * (v522 - (v818 + (v29 * v544))));
        w69[i] = 0.5 * (v773 * (v552 + (v818 + (v29 * v560))));
        w70[i] = 0.5 * (v773 * (v611 - ((v29 * v634) - v830)));
        w71[i] = -(0.5 * (v773 * (v654 + (v830 + (v29 * v672)))));
        w11[i] = -v120;
        w72[i] = -v160;
        w73[i] = -v181;
        w74[i] = -v284;
        w75[i] = -v325;
        w76[i] = v362;
        w77[i] = -v398;
        w78[i] = v430;
        w79[i] = -v463;
        w80[i] = -v538;
        w81[i] = v538;
        w82[i] = -v628;
        w83[i] = -v667;
    }
}

static void jacobian_5(int n, const double *p, const double *g, double *w, double *e)
{
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
        const double v152 = ((v139 * w72[i]) - (v139 * w73[i - 1])) + (v139 * w61[i - 1]);
        const double v173 = ((v139 * w74[i]) - (v139 * w75[i - 1])) + (v139 * w63[i - 1]);
        const double v194 = ((v139 * w76[i]) - (v139 * w77[i - 1])) + (v139 * w65[i - 1]);
        const double v215 = ((v139 * w78[i]) - (v139 * w79[i - 1])) + (v139 * w67[i - 1]);
        const double v236 = ((v139 * w80[i]) - (v139 * w81[i - 1])) + (v139 * w69[i - 1]);
        const double v257 = ((v139 * w82[i]) - (v139 * w83[i - 1])) + (v139 * w71[i - 1]);
        e[57 * i + 7] = -(v9 * w36[i - 1]);
        e[57 * i + 13] = (v9 * w36[i]) - (v9 * w37[i - 1]);
        e[57 * i + 19] = v9 * w37[i];
        e[57 * i + 6] = -(v9 * w38[i - 1]);
        e[57 * i + 12] = (v9 * w38[i]) - (v9 * w39[i - 1]);
        e[57 * i + 18] = v9 * w39[i];
        e[57 * i + 4] = -(v9 * w40[i - 1]);
        e[57 * i + 10] = (v9 * w40[i]) - (v9 * w41[i - 1]);
        e[57 * i + 16] = v9 * w41[i];
        e[57 * i + 5] = -(v9 * w42[i - 1]);
        e[57 * i + 11] = (v9 * w42[i]) - (v9 * w43[i - 1]);
        e[57 * i + 17] = v9 * w43[i];
        e[57 * i + 2] = -(v9 * w44[i - 1]);
        e[57 * i + 8] = (v9 * w44[i]) - (v9 * w45[i - 1]);
        e[57 * i + 14] = v9 * w45[i];
        e[57 * i + 3] = -(v9 * w46[i - 1]);
        e[57 * i + 9] = (v9 * w46[i]) - (v9 * w47[i - 1]);
        e[57 * i + 15] = v9 * w47[i];
        e[57 * i + 25] = -(v9 * w48[i - 1]);
        e[57 * i + 31] = (v9 * w48[i]) - (v9 * w49[i - 1]);
        e[57 * i + 37] = v9 * w49[i];
        e[57 * i + 24] = -(v9 * w50[i - 1]);
        e[57 * i + 30] = (v9 * w50[i]) - (v9 * w51[i - 1]);
        e[57 * i + 36] = v9 * w51[i];
        e[57 * i + 22] = -(v9 * w52[i - 1]);
        e[57 * i + 28] = (v9 * w52[i]) - (v9 * w53[i - 1]);
        e[57 * i + 34] = v9 * w53[i];
        e[57 * i + 23] = -(v9 * w54[i - 1]);
        e[57 * i + 29] = (v9 * w54[i]) - (v9 * w55[i - 1]);
        e[57 * i + 35] = v9 * w55[i];
        e[57 * i + 20] = -(v9 * w56[i - 1]);
        e[57 * i + 26] = (v9 * w56[i]) - (v9 * w57[i - 1]);
        e[57 * i + 32] = v9 * w57[i];
        e[57 * i + 21] = -(v9 * w58[i - 1]);
        e[57 * i + 27] = (v9 * w58[i]) - (v9 * w59[i - 1]);
        e[57 * i + 33] = v9 * w59[i];
        e[57 * i + 44] = (v139 * w60[i - 1]) - (v139 * w72[i - 1]);
        e[57 * i + 50] = v152 + (v139 * w60[i]);
        e[57 * i + 56] = (v139 * w73[i]) + (v139 * w61[i]);
        e[57 * i + 43] = (v139 * w62[i - 1]) - (v139 * w74[i - 1]);
        e[57 * i + 49] = v173 + (v139 * w62[i]);
        e[57 * i + 55] = (v139 * w75[i]) + (v139 * w63[i]);
        e[57 * i + 41] = (v139 * w64[i - 1]) - (v139 * w76[i - 1]);
        e[57 * i + 47] = v194 + (v139 * w64[i]);
        e[57 * i + 53] = (v139 * w77[i]) + (v139 * w65[i]);
        e[57 * i + 42] = (v139 * w66[i - 1]) - (v139 * w78[i - 1]);
        e[57 * i + 48] = v215 + (v139 * w66[i]);
        e[57 * i + 54] = (v139 * w79[i]) + (v139 * w67[i]);
        e[57 * i + 39] = (v139 * w68[i - 1]) - (v139 * w80[i - 1]);
        e[57 * i + 45] = v236 + (v139 * w68[i]);
        e[57 * i + 51] = (v139 * w81[i]) + (v139 * w69[i]);
        e[57 * i + 40] = (v139 * w70[i - 1]) - (v139 * w82[i - 1]);
        e[57 * i + 46] = v257 + (v139 * w70[i]);
        e[57 * i + 52] = (v139 * w83[i]) + (v139 * w71[i]);
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
    const double c4 = p[12];
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
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
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
    const double v46 = (w8[i - 1] * c26) + ((w9[i - 1] + (((g[7 * i + 3] * c30) * p[3]) * c25)) * c44);
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
    const double c44 = p[12];
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
    s[6 * n + 6 * i - 1] += (c31 * w36[i - 1]) + (c43 * w48[i - 1]);
    s[6 * n + 6 * i + 5] += (c31 * w37[i - 1]) + (c43 * w49[i - 1]);
    s[6 * n + 6 * i - 2] += (c31 * w38[i - 1]) + (c43 * w50[i - 1]);
    s[6 * n + 6 * i + 4] += (c31 * w39[i - 1]) + (c43 * w51[i - 1]);
    s[6 * n + 6 * i - 4] += (c31 * w40[i - 1]) + (c43 * w52[i - 1]);
    s[6 * n + 6 * i + 2] += (c31 * w41[i - 1]) + (c43 * w53[i - 1]);
    s[6 * n + 6 * i - 3] += (c31 * w42[i - 1]) + (c43 * w54[i - 1]);
    s[6 * n + 6 * i + 3] += (c31 * w43[i - 1]) + (c43 * w55[i - 1]);
    s[6 * n + 6 * i - 6] += (c31 * w44[i - 1]) + (c43 * w56[i - 1]);
    s[6 * n + 6 * i] += (c31 * w45[i - 1]) + (c43 * w57[i - 1]);
    s[6 * n + 6 * i - 5] += (c31 * w46[i - 1]) + (c43 * w58[i - 1]);
    s[6 * n + 6 * i + 1] += (c31 * w47[i - 1]) + (c43 * w59[i - 1]);
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
    6, 0, 13, 7, 84, 57, 3, 1,
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
