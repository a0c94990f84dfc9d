/*
 * Transient gel that flows by Eyring's law
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, gravity-ramp, shear, fibres, rotary-inertia
 * Digest of the structure: 076ca95ae85724abf4b9a9b8456671072cdebe145cca4365ba89a0e48de8cd33
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
        f[22 * i] = y[22 * i + 2];
        f[22 * i + 4] = y[22 * i + 5];
    }
}

static void rates_1(int n, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[22 * i + 1] = y[22 * i + 3];
    }
}

static void rates_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[22 * i];
        w1[i] = y[22 * i + 4];
    }
}

static void rates_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[22 * i + 1];
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

static void rates_6(int n, const double *p, const double *g, const double *y, double *w, double *f)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    const double c1 = p[5];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c116 = 0.9 * c1;
    const double c118 = 2.0 * p[6];
    const double c119 = 2.0 + c118;
    const double c120 = c116 / c119;
    const double c166 = 0.5 * c4;
    const double c214 = 1e-12 * c1;
    const double c215 = squared(c214);
    const double c219 = 1.0 / p[7];
    const double c223 = 1.0 / p[8];
    const double c227 = p[9];
    for (int i = 0; i < n - 1; i++) {
        const double v6 = w1[i + 1];
        const double v7 = w1[i];
        const double v10 = g[7 * i + 4];
        const double v14 = (v6 - v7) * (v10 * c12);
        const double v15 = c5 * v14;
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v24 = (v7 + v6) * 0.5;
        const double v25 = cos(v24);
        const double v30 = (w2[i + 1] - w2[i]) * v10;
        const double v31 = sin(v24);
        const double v33 = (v20 * v25) + (v30 * v31);
        const double v36 = 1.0 / (sqrt(v33) * v33);
        const double v40 = log(v33);
        const double v41 = ((((-0.8977882908473036) * v15) * v36) - y[22 * i + 6]) + v40;
        const double v42 = c1 * v41;
        const double v50 = ((((-0.631771669920152) * v15) * v36) - y[22 * i + 7]) + v40;
        const double v51 = c1 * v50;
        const double v60 = ((((-0.3092051869716723) * v15) * v36) - y[22 * i + 8]) + v40;
        const double v61 = c1 * v60;
        const double v63 = ((0.055346757660697604 * v42) + (0.1559825412417957 * v51)) + (0.18502795280105888 * v61);
        const double v70 = ((((-0.0652237289787655) * v15) * v36) - y[22 * i + 9]) + v40;
        const double v71 = c1 * v70;
        const double v79 = (((0.0652237289787655 * v15) * v36) - y[22 * i + 10]) + v40;
        const double v80 = c1 * v79;
        const double v82 = (v63 + (0.10364274829644775 * v71)) + (0.10364274829644775 * v80);
        const double v88 = (((0.3092051869716723 * v15) * v36) - y[22 * i + 11]) + v40;
        const double v89 = c1 * v88;
        const double v97 = (((0.631771669920152 * v15) * v36) - y[22 * i + 12]) + v40;
        const double v98 = c1 * v97;
        const double v100 = (v82 + (0.18502795280105888 * v89)) + (0.1559825412417957 * v98);
        const double v106 = (((0.8977882908473036 * v15) * v36) - y[22 * i + 13]) + v40;
        const double v107 = c1 * v106;
        const double v110 = 1.0 / v33;
        const double v114 = (v30 * v25) - (v20 * v31);
        const double v121 = v114 * v110;
        const double v124 = c120 * (v121 - y[22 * i + 14]);
        const double v128 = c120 * (v121 - y[22 * i + 15]);
        const double v130 = (0.055346757660697604 * v124) + (0.1559825412417957 * v128);
        const double v133 = c120 * (v121 - y[22 * i + 16]);
        const double v138 = c120 * (v121 - y[22 * i + 17]);
        const double v140 = (v130 + (0.18502795280105888 * v133)) + (0.10364274829644775 * v138);
        const double v143 = c120 * (v121 - y[22 * i + 18]);
        const double v148 = c120 * (v121 - y[22 * i + 19]);
        const double v150 = (v140 + (0.10364274829644775 * v143)) + (0.18502795280105888 * v148);
        const double v153 = c120 * (v121 - y[22 * i + 20]);
        const double v158 = c120 * (v121 - y[22 * i + 21]);
        const double v160 = (v150 + (0.1559825412417957 * v153)) + (0.055346757660697604 * v158);
        const double v161 = v160 * v110;
        const double v164 = ((v100 + (0.055346757660697604 * v107)) * v110) - ((v114 * v161) * v110);
        const double v171 = ((-0.04968967096413761) * v42) + ((-0.09854535055871824) * v51);
        const double v177 = (v171 + ((-0.05721160274083717) * v61)) + ((-0.006759966525501917) * v71);
        const double v183 = (v177 + (0.006759966525501917 * v80)) + (0.05721160274083717 * v89);
        const double v189 = (v183 + (0.09854535055871824 * v98)) + (0.04968967096413761 * v107);
        const double v191 = (c166 * v189) * v36;
        const double v195 = v164 + (((1.5 * v191) * v14) * v110);
        const double v217 = sqrt(larger(squared(v42) + (3.0 * squared(v124)), c215));
        const double v225 = (sinh(v217 * c219) * c223) / v217;
        const double v234 = sqrt(larger(squared(v51) + (3.0 * squared(v128)), c215));
        const double v238 = (sinh(v234 * c219) * c223) / v234;
        const double v246 = sqrt(larger(squared(v61) + (3.0 * squared(v133)), c215));
        const double v250 = (sinh(v246 * c219) * c223) / v246;
        const double v258 = sqrt(larger(squared(v71) + (3.0 * squared(v138)), c215));
        const double v262 = (sinh(v258 * c219) * c223) / v258;
        const double v270 = sqrt(larger(squared(v80) + (3.0 * squared(v143)), c215));
        const double v274 = (sinh(v270 * c219) * c223) / v270;
        const double v282 = sqrt(larger(squared(v89) + (3.0 * squared(v148)), c215));
        const double v286 = (sinh(v282 * c219) * c223) / v282;
        const double v294 = sqrt(larger(squared(v98) + (3.0 * squared(v153)), c215));
        const double v298 = (sinh(v294 * c219) * c223) / v294;
        const double v306 = sqrt(larger(squared(v107) + (3.0 * squared(v158)), c215));
        const double v310 = (sinh(v306 * c219) * c223) / v306;
        w3[i] = (v195 * v25) - (v161 * v31);
        w4[i] = (v195 * v31) + (v161 * v25);
        w5[i] = ((g[7 * i + 1] * c11) * (v160 - (v114 * v195))) * 0.5;
        w6[i] = -v191;
        f[22 * i + 6] = (v42 * v225) * c227;
        f[22 * i + 7] = (v51 * v238) * c227;
        f[22 * i + 8] = (v61 * v250) * c227;
        f[22 * i + 9] = (v71 * v262) * c227;
        f[22 * i + 10] = (v80 * v274) * c227;
        f[22 * i + 11] = (v89 * v286) * c227;
        f[22 * i + 12] = (v98 * v298) * c227;
        f[22 * i + 13] = (v107 * v310) * c227;
        f[22 * i + 14] = ((3.0 * v124) * v225) * c227;
        f[22 * i + 15] = ((3.0 * v128) * v238) * c227;
        f[22 * i + 16] = ((3.0 * v133) * v250) * c227;
        f[22 * i + 17] = ((3.0 * v138) * v262) * c227;
        f[22 * i + 18] = ((3.0 * v143) * v274) * c227;
        f[22 * i + 19] = ((3.0 * v148) * v286) * c227;
        f[22 * i + 20] = ((3.0 * v153) * v298) * c227;
        f[22 * i + 21] = ((3.0 * v158) * v310) * c227;
    }
}

static void rates_7(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
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
    for (int i = 1; i < n - 1; i++) {
        const double v31 = (((w6[i] - w6[i - 1]) + w5[i]) + w5[i - 1]) * (c27 * g[7 * i + 5]);
        f[22 * i + 2] = (w3[i] - w3[i - 1]) * (c9 * g[7 * i + 6]);
        f[22 * i + 5] = v31;
    }
}

static void rates_8(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w4 = w + 4 * n;
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
        f[22 * i + 3] = ((w4[i] - w4[i - 1]) * (c9 * g[7 * i + 6])) - c34;
    }
}

static void rates_9(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w4 = w + 4 * n;
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
    f[22 * i + 3] = (w4[i] * (c7 * g[7 * i + 6])) - c32;
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[254 * i] = 1.0;
        e[254 * i + 84] = 1.0;
    }
}

static void jacobian_1(int n, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[254 * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[22 * i];
        w1[i] = y[22 * i + 4];
    }
}

static void jacobian_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[22 * i + 1];
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

static void jacobian_6(int n, const double *p, const double *g, const double *y, double *w, double *e)
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
    double *restrict w84 = w + 84 * n;
    double *restrict w85 = w + 85 * n;
    double *restrict w86 = w + 86 * n;
    const double c1 = p[5];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c116 = 0.9 * c1;
    const double c118 = 2.0 * p[6];
    const double c119 = 2.0 + c118;
    const double c120 = c116 / c119;
    const double c166 = 0.5 * c4;
    const double c199 = 0.055346757660697604 * c1;
    const double c201 = (-0.04968967096413761) * c1;
    const double c202 = c166 * c201;
    const double c210 = 0.1559825412417957 * c1;
    const double c212 = (-0.09854535055871824) * c1;
    const double c213 = c166 * c212;
    const double c221 = 0.18502795280105888 * c1;
    const double c223 = (-0.05721160274083717) * c1;
    const double c224 = c166 * c223;
    const double c232 = 0.10364274829644775 * c1;
    const double c234 = (-0.006759966525501917) * c1;
    const double c235 = c166 * c234;
    const double c243 = 0.006759966525501917 * c1;
    const double c244 = c166 * c243;
    const double c252 = 0.05721160274083717 * c1;
    const double c253 = c166 * c252;
    const double c261 = 0.09854535055871824 * c1;
    const double c262 = c166 * c261;
    const double c270 = 0.04968967096413761 * c1;
    const double c271 = c166 * c270;
    const double c503 = 0.055346757660697604 * c120;
    const double c510 = 0.1559825412417957 * c120;
    const double c517 = 0.18502795280105888 * c120;
    const double c524 = 0.10364274829644775 * c120;
    const double c1013 = p[9];
    const double c1020 = 1e-12 * c1;
    const double c1021 = squared(c1020);
    const double c1025 = 1.0 / p[7];
    const double c1029 = 1.0 / p[8];
    const double c2138 = 3.0 * c120;
    for (int i = 0; i < n - 1; i++) {
        const double v6 = w1[i + 1];
        const double v7 = w1[i];
        const double v10 = g[7 * i + 4];
        const double v13 = v10 * c12;
        const double v14 = (v6 - v7) * v13;
        const double v15 = c5 * v14;
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v24 = (v7 + v6) * 0.5;
        const double v25 = cos(v24);
        const double v30 = (w2[i + 1] - w2[i]) * v10;
        const double v31 = sin(v24);
        const double v33 = (v20 * v25) + (v30 * v31);
        const double v34 = sqrt(v33);
        const double v36 = 1.0 / (v34 * v33);
        const double v37 = ((-0.8977882908473036) * v15) * v36;
        const double v40 = log(v33);
        const double v42 = c1 * ((v37 - y[22 * i + 6]) + v40);
        const double v47 = ((-0.631771669920152) * v15) * v36;
        const double v51 = c1 * ((v47 - y[22 * i + 7]) + v40);
        const double v57 = ((-0.3092051869716723) * v15) * v36;
        const double v61 = c1 * ((v57 - y[22 * i + 8]) + v40);
        const double v63 = ((0.055346757660697604 * v42) + (0.1559825412417957 * v51)) + (0.18502795280105888 * v61);
        const double v67 = ((-0.0652237289787655) * v15) * v36;
        const double v71 = c1 * ((v67 - y[22 * i + 9]) + v40);
        const double v76 = (0.0652237289787655 * v15) * v36;
        const double v80 = c1 * ((v76 - y[22 * i + 10]) + v40);
        const double v82 = (v63 + (0.10364274829644775 * v71)) + (0.10364274829644775 * v80);
        const double v85 = (0.3092051869716723 * v15) * v36;
        const double v89 = c1 * ((v85 - y[22 * i + 11]) + v40);
        const double v94 = (0.631771669920152 * v15) * v36;
        const double v98 = c1 * ((v94 - y[22 * i + 12]) + v40);
        const double v100 = (v82 + (0.18502795280105888 * v89)) + (0.1559825412417957 * v98);
        const double v103 = (0.8977882908473036 * v15) * v36;
        const double v107 = c1 * ((v103 - y[22 * i + 13]) + v40);
        const double v110 = 1.0 / v33;
        const double v111 = (v100 + (0.055346757660697604 * v107)) * v110;
        const double v114 = (v30 * v25) - (v20 * v31);
        const double v121 = v114 * v110;
        const double v124 = c120 * (v121 - y[22 * i + 14]);
        const double v128 = c120 * (v121 - y[22 * i + 15]);
        const double v130 = (0.055346757660697604 * v124) + (0.1559825412417957 * v128);
        const double v133 = c120 * (v121 - y[22 * i + 16]);
        const double v138 = c120 * (v121 - y[22 * i + 17]);
        const double v140 = (v130 + (0.18502795280105888 * v133)) + (0.10364274829644775 * v138);
        const double v143 = c120 * (v121 - y[22 * i + 18]);
        const double v148 = c120 * (v121 - y[22 * i + 19]);
        const double v150 = (v140 + (0.10364274829644775 * v143)) + (0.18502795280105888 * v148);
        const double v153 = c120 * (v121 - y[22 * i + 20]);
        const double v158 = c120 * (v121 - y[22 * i + 21]);
        const double v160 = (v150 + (0.1559825412417957 * v153)) + (0.055346757660697604 * v158);
        const double v161 = v160 * v110;
        const double v163 = (v114 * v161) * v110;
        const double v171 = ((-0.04968967096413761) * v42) + ((-0.09854535055871824) * v51);
        const double v177 = (v171 + ((-0.05721160274083717) * v61)) + ((-0.006759966525501917) * v71);
        const double v183 = (v177 + (0.006759966525501917 * v80)) + (0.05721160274083717 * v89);
        const double v189 = (v183 + (0.09854535055871824 * v98)) + (0.04968967096413761 * v107);
        const double v191 = (c166 * v189) * v36;
        const double v192 = 1.5 * v191;
        const double v194 = (v192 * v14) * v110;
        const double v195 = (v111 - v163) + v194;
        const double v200 = c199 * v110;
        const double v203 = c202 * v36;
        const double v207 = v200 + ((v14 * (1.5 * v203)) * v110);
        const double v211 = c210 * v110;
        const double v214 = c213 * v36;
        const double v218 = v211 + ((v14 * (1.5 * v214)) * v110);
        const double v222 = c221 * v110;
        const double v225 = c224 * v36;
        const double v229 = v222 + ((v14 * (1.5 * v225)) * v110);
        const double v233 = c232 * v110;
        const double v236 = c235 * v36;
        const double v240 = v233 + ((v14 * (1.5 * v236)) * v110);
        const double v245 = c244 * v36;
        const double v249 = v233 + ((v14 * (1.5 * v245)) * v110);
        const double v254 = c253 * v36;
        const double v258 = v222 + ((v14 * (1.5 * v254)) * v110);
        const double v263 = c262 * v36;
        const double v267 = v211 + ((v14 * (1.5 * v263)) * v110);
        const double v272 = c271 * v36;
        const double v276 = v200 + ((v14 * (1.5 * v272)) * v110);
        const double v279 = 0.5 * v25;
        const double v281 = 0.5 * v31;
        const double v283 = (v30 * v279) - (v20 * v281);
        const double v284 = v283 * v110;
        const double v285 = c5 * v13;
        const double v287 = ((-0.8977882908473036) * v285) * v36;
        const double v288 = v37 * v36;
        const double v290 = 1.0 / (2.0 * v34);
        const double v294 = (v33 * (v283 * v290)) + (v34 * v283);
        const double v295 = v288 * v294;
        const double v298 = c1 * (v284 - (v287 + v295));
        const double v301 = ((-0.631771669920152) * v285) * v36;
        const double v302 = v47 * v36;
        const double v303 = v302 * v294;
        const double v306 = c1 * (v284 - (v301 + v303));
        const double v308 = (0.055346757660697604 * v298) + (0.1559825412417957 * v306);
        const double v310 = ((-0.3092051869716723) * v285) * v36;
        const double v311 = v57 * v36;
        const double v312 = v311 * v294;
        const double v315 = c1 * (v284 - (v310 + v312));
        const double v319 = ((-0.0652237289787655) * v285) * v36;
        const double v320 = v67 * v36;
        const double v321 = v320 * v294;
        const double v324 = c1 * (v284 - (v319 + v321));
        const double v326 = (v308 + (0.18502795280105888 * v315)) + (0.10364274829644775 * v324);
        const double v328 = (0.0652237289787655 * v285) * v36;
        const double v329 = v76 * v36;
        const double v330 = v329 * v294;
        const double v333 = c1 * (v284 - (v328 + v330));
        const double v337 = (0.3092051869716723 * v285) * v36;
        const double v338 = v85 * v36;
        const double v339 = v338 * v294;
        const double v342 = c1 * (v284 - (v337 + v339));
        const double v344 = (v326 + (0.10364274829644775 * v333)) + (0.18502795280105888 * v342);
        const double v346 = (0.631771669920152 * v285) * v36;
        const double v347 = v94 * v36;
        const double v348 = v347 * v294;
        const double v351 = c1 * (v284 - (v346 + v348));
        const double v355 = (0.8977882908473036 * v285) * v36;
        const double v356 = v103 * v36;
        const double v357 = v356 * v294;
        const double v360 = c1 * (v284 - (v355 + v357));
        const double v362 = (v344 + (0.1559825412417957 * v351)) + (0.055346757660697604 * v360);
        const double v364 = v111 * v110;
        const double v365 = v364 * v283;
        const double v369 = (v30 * v281) + (v20 * v279);
        const double v372 = v121 * v110;
        const double v375 = c120 * ((v369 * v110) + (v372 * v283));
        const double v376 = 0.055346757660697604 * v375;
        const double v377 = 0.1559825412417957 * v375;
        const double v379 = 0.18502795280105888 * v375;
        const double v381 = 0.10364274829644775 * v375;
        const double v386 = ((((((v376 + v377) + v379) + v381) + v381) + v379) + v377) + v376;
        const double v388 = v161 * v110;
        const double v390 = (v386 * v110) + (v388 * v283);
        const double v394 = v163 * v110;
        const double v396 = (((v161 * v369) + (v114 * v390)) * v110) + (v394 * v283);
        const double v400 = ((-0.04968967096413761) * v298) + ((-0.09854535055871824) * v306);
        const double v404 = (v400 + ((-0.05721160274083717) * v315)) + ((-0.006759966525501917) * v324);
        const double v408 = (v404 + (0.006759966525501917 * v333)) + (0.05721160274083717 * v342);
        const double v412 = (v408 + (0.09854535055871824 * v351)) + (0.04968967096413761 * v360);
        const double v415 = v191 * v36;
        const double v416 = v415 * v294;
        const double v417 = ((c166 * v412) * v36) - v416;
        const double v420 = v192 * v13;
        const double v423 = v194 * v110;
        const double v424 = v423 * v283;
        const double v426 = (((v362 * v110) - v365) + v396) + ((((v14 * (1.5 * v417)) - v420) * v110) - v424);
        const double v428 = v195 * v281;
        const double v432 = (v161 * v279) - (v31 * v390);
        const double v436 = c1 * ((v287 - v295) + v284);
        const double v440 = c1 * ((v301 - v303) + v284);
        const double v442 = (0.055346757660697604 * v436) + (0.1559825412417957 * v440);
        const double v445 = c1 * ((v310 - v312) + v284);
        const double v450 = c1 * ((v319 - v321) + v284);
        const double v452 = (v442 + (0.18502795280105888 * v445)) + (0.10364274829644775 * v450);
        const double v455 = c1 * ((v328 - v330) + v284);
        const double v460 = c1 * ((v337 - v339) + v284);
        const double v462 = (v452 + (0.10364274829644775 * v455)) + (0.18502795280105888 * v460);
        const double v465 = c1 * ((v346 - v348) + v284);
        const double v470 = c1 * ((v355 - v357) + v284);
        const double v472 = (v462 + (0.1559825412417957 * v465)) + (0.055346757660697604 * v470);
        const double v478 = ((-0.04968967096413761) * v436) + ((-0.09854535055871824) * v440);
        const double v482 = (v478 + ((-0.05721160274083717) * v445)) + ((-0.006759966525501917) * v450);
        const double v486 = (v482 + (0.006759966525501917 * v455)) + (0.05721160274083717 * v460);
        const double v490 = (v486 + (0.09854535055871824 * v465)) + (0.04968967096413761 * v470);
        const double v493 = ((c166 * v490) * v36) - v416;
        const double v499 = (((v472 * v110) - v365) + v396) + ((((v14 * (1.5 * v493)) + v420) * v110) - v424);
        const double v504 = c503 * v110;
        const double v506 = (v114 * v504) * v110;
        const double v509 = (v25 * v506) + (v31 * v504);
        const double v511 = c510 * v110;
        const double v513 = (v114 * v511) * v110;
        const double v516 = (v25 * v513) + (v31 * v511);
        const double v518 = c517 * v110;
        const double v520 = (v114 * v518) * v110;
        const double v523 = (v25 * v520) + (v31 * v518);
        const double v525 = c524 * v110;
        const double v527 = (v114 * v525) * v110;
        const double v530 = (v25 * v527) + (v31 * v525);
        const double v531 = v25 * v10;
        const double v535 = (v33 * (v531 * v290)) + (v34 * v531);
        const double v536 = v288 * v535;
        const double v537 = v531 * v110;
        const double v539 = c1 * (v536 - v537);
        const double v541 = v302 * v535;
        const double v543 = c1 * (v541 - v537);
        const double v545 = (0.055346757660697604 * v539) + (0.1559825412417957 * v543);
        const double v546 = v311 * v535;
        const double v548 = c1 * (v546 - v537);
        const double v551 = v320 * v535;
        const double v553 = c1 * (v551 - v537);
        const double v555 = (v545 + (0.18502795280105888 * v548)) + (0.10364274829644775 * v553);
        const double v556 = v329 * v535;
        const double v558 = c1 * (v556 - v537);
        const double v561 = v338 * v535;
        const double v563 = c1 * (v561 - v537);
        const double v565 = (v555 + (0.10364274829644775 * v558)) + (0.18502795280105888 * v563);
        const double v566 = v347 * v535;
        const double v568 = c1 * (v566 - v537);
        const double v571 = v356 * v535;
        const double v573 = c1 * (v571 - v537);
        const double v575 = (v565 + (0.1559825412417957 * v568)) + (0.055346757660697604 * v573);
        const double v577 = v364 * v531;
        const double v579 = v31 * v10;
        const double v581 = v579 * v110;
        const double v584 = c120 * (v581 + (v372 * v531));
        const double v585 = 0.055346757660697604 * v584;
        const double v586 = 0.1559825412417957 * v584;
        const double v588 = 0.18502795280105888 * v584;
        const double v590 = 0.10364274829644775 * v584;
        const double v595 = ((((((v585 + v586) + v588) + v590) + v590) + v588) + v586) + v585;
        const double v598 = (v595 * v110) + (v388 * v531);
        const double v603 = (((v161 * v579) + (v114 * v598)) * v110) + (v394 * v531);
        const double v607 = ((-0.04968967096413761) * v539) + ((-0.09854535055871824) * v543);
        const double v611 = (v607 + ((-0.05721160274083717) * v548)) + ((-0.006759966525501917) * v553);
        const double v615 = (v611 + (0.006759966525501917 * v558)) + (0.05721160274083717 * v563);
        const double v619 = (v615 + (0.09854535055871824 * v568)) + (0.04968967096413761 * v573);
        const double v622 = v415 * v535;
        const double v623 = ((c166 * v619) * v36) + v622;
        const double v627 = v423 * v531;
        const double v629 = (((v575 * v110) + v577) - v603) + (((v14 * (1.5 * v623)) * v110) + v627);
        const double v631 = v31 * v598;
        const double v634 = c1 * (v537 - v536);
        const double v637 = c1 * (v537 - v541);
        const double v639 = (0.055346757660697604 * v634) + (0.1559825412417957 * v637);
        const double v641 = c1 * (v537 - v546);
        const double v645 = c1 * (v537 - v551);
        const double v647 = (v639 + (0.18502795280105888 * v641)) + (0.10364274829644775 * v645);
        const double v649 = c1 * (v537 - v556);
        const double v653 = c1 * (v537 - v561);
        const double v655 = (v647 + (0.10364274829644775 * v649)) + (0.18502795280105888 * v653);
        const double v657 = c1 * (v537 - v566);
        const double v661 = c1 * (v537 - v571);
        const double v663 = (v655 + (0.1559825412417957 * v657)) + (0.055346757660697604 * v661);
        const double v669 = ((-0.04968967096413761) * v634) + ((-0.09854535055871824) * v637);
        const double v673 = (v669 + ((-0.05721160274083717) * v641)) + ((-0.006759966525501917) * v645);
        const double v677 = (v673 + (0.006759966525501917 * v649)) + (0.05721160274083717 * v653);
        const double v681 = (v677 + (0.09854535055871824 * v657)) + (0.04968967096413761 * v661);
        const double v684 = ((c166 * v681) * v36) - v622;
        const double v689 = (((v663 * v110) - v577) + v603) + (((v14 * (1.5 * v684)) * v110) - v627);
        const double v695 = (v33 * (v579 * v290)) + (v34 * v579);
        const double v696 = v288 * v695;
        const double v698 = c1 * (v696 - v581);
        const double v700 = v302 * v695;
        const double v702 = c1 * (v700 - v581);
        const double v704 = (0.055346757660697604 * v698) + (0.1559825412417957 * v702);
        const double v705 = v311 * v695;
        const double v707 = c1 * (v705 - v581);
        const double v710 = v320 * v695;
        const double v712 = c1 * (v710 - v581);
        const double v714 = (v704 + (0.18502795280105888 * v707)) + (0.10364274829644775 * v712);
        const double v715 = v329 * v695;
        const double v717 = c1 * (v715 - v581);
        const double v720 = v338 * v695;
        const double v722 = c1 * (v720 - v581);
        const double v724 = (v714 + (0.10364274829644775 * v717)) + (0.18502795280105888 * v722);
        const double v725 = v347 * v695;
        const double v727 = c1 * (v725 - v581);
        const double v730 = v356 * v695;
        const double v732 = c1 * (v730 - v581);
        const double v734 = (v724 + (0.1559825412417957 * v727)) + (0.055346757660697604 * v732);
        const double v736 = v364 * v579;
        const double v738 = v372 * v579;
        const double v740 = c120 * (v738 - v537);
        const double v741 = 0.055346757660697604 * v740;
        const double v742 = 0.1559825412417957 * v740;
        const double v744 = 0.18502795280105888 * v740;
        const double v746 = 0.10364274829644775 * v740;
        const double v751 = ((((((v741 + v742) + v744) + v746) + v746) + v744) + v742) + v741;
        const double v753 = v388 * v579;
        const double v754 = (v751 * v110) + v753;
        const double v756 = v161 * v531;
        const double v759 = v394 * v579;
        const double v761 = ((v734 * v110) + v736) - ((((v114 * v754) - v756) * v110) + v759);
        const double v764 = ((-0.04968967096413761) * v698) + ((-0.09854535055871824) * v702);
        const double v768 = (v764 + ((-0.05721160274083717) * v707)) + ((-0.006759966525501917) * v712);
        const double v772 = (v768 + (0.006759966525501917 * v717)) + (0.05721160274083717 * v722);
        const double v776 = (v772 + (0.09854535055871824 * v727)) + (0.04968967096413761 * v732);
        const double v779 = v415 * v695;
        const double v780 = ((c166 * v776) * v36) + v779;
        const double v784 = v423 * v579;
        const double v786 = v761 + (((v14 * (1.5 * v780)) * v110) + v784);
        const double v791 = c1 * (v581 - v696);
        const double v794 = c1 * (v581 - v700);
        const double v796 = (0.055346757660697604 * v791) + (0.1559825412417957 * v794);
        const double v798 = c1 * (v581 - v705);
        const double v802 = c1 * (v581 - v710);
        const double v804 = (v796 + (0.18502795280105888 * v798)) + (0.10364274829644775 * v802);
        const double v806 = c1 * (v581 - v715);
        const double v810 = c1 * (v581 - v720);
        const double v812 = (v804 + (0.10364274829644775 * v806)) + (0.18502795280105888 * v810);
        const double v814 = c1 * (v581 - v725);
        const double v818 = c1 * (v581 - v730);
        const double v820 = (v812 + (0.1559825412417957 * v814)) + (0.055346757660697604 * v818);
        const double v824 = c120 * (v537 - v738);
        const double v825 = 0.055346757660697604 * v824;
        const double v826 = 0.1559825412417957 * v824;
        const double v828 = 0.18502795280105888 * v824;
        const double v830 = 0.10364274829644775 * v824;
        const double v835 = ((((((v825 + v826) + v828) + v830) + v830) + v828) + v826) + v825;
        const double v837 = (v835 * v110) - v753;
        const double v842 = ((v820 * v110) - v736) - (((v756 + (v114 * v837)) * v110) - v759);
        const double v845 = ((-0.04968967096413761) * v791) + ((-0.09854535055871824) * v794);
        const double v849 = (v845 + ((-0.05721160274083717) * v798)) + ((-0.006759966525501917) * v802);
        const double v853 = (v849 + (0.006759966525501917 * v806)) + (0.05721160274083717 * v810);
        const double v857 = (v853 + (0.09854535055871824 * v814)) + (0.04968967096413761 * v818);
        const double v860 = ((c166 * v857) * v36) - v779;
        const double v865 = v842 + (((v14 * (1.5 * v860)) * v110) - v784);
        const double v889 = v195 * v279;
        const double v893 = (v25 * v390) + (v161 * v281);
        const double v900 = (v31 * v506) - (v25 * v504);
        const double v903 = (v31 * v513) - (v25 * v511);
        const double v906 = (v31 * v520) - (v25 * v518);
        const double v909 = (v31 * v527) - (v25 * v525);
        const double v911 = v25 * v598;
        const double v921 = g[7 * i + 1] * c11;
        const double v951 = v195 * v369;
        const double v967 = -(0.5 * (v921 * (c503 + (v114 * v506))));
        const double v972 = -(0.5 * (v921 * (c510 + (v114 * v513))));
        const double v977 = -(0.5 * (v921 * (c517 + (v114 * v520))));
        const double v982 = -(0.5 * (v921 * (c524 + (v114 * v527))));
        const double v983 = v195 * v579;
        const double v996 = v195 * v531;
        const double v1018 = squared(v42) + (3.0 * squared(v124));
        const double v1023 = sqrt(larger(v1018, c1021));
        const double v1026 = v1023 * c1025;
        const double v1031 = 1.0 / v1023;
        const double v1032 = (sinh(v1026) * c1029) * v1031;
        const double v1033 = v1032 * v1031;
        const double v1034 = (double)(c1021 <= v1018);
        const double v1037 = v1034 / (v1034 + (double)(v1018 <= c1021));
        const double v1038 = 2.0 * v42;
        const double v1042 = 1.0 / (2.0 * v1023);
        const double v1043 = (v1037 * (v1038 * c1)) * v1042;
        const double v1045 = cosh(v1026);
        const double v1050 = (v1033 * v1043) - (((v1045 * (v1043 * c1025)) * c1029) * v1031);
        const double v1057 = 2.0 * v124;
        const double v1059 = 3.0 * (v1057 * v375);
        const double v1062 = (v1037 * ((v1038 * v298) - v1059)) * v1042;
        const double v1068 = (((v1045 * (v1062 * c1025)) * c1029) * v1031) - (v1033 * v1062);
        const double v1076 = (v1037 * ((v1038 * v436) - v1059)) * v1042;
        const double v1082 = (((v1045 * (v1076 * c1025)) * c1029) * v1031) - (v1033 * v1076);
        const double v1089 = (v1037 * (3.0 * (v1057 * c120))) * v1042;
        const double v1095 = (v1033 * v1089) - (((v1045 * (v1089 * c1025)) * c1029) * v1031);
        const double v1101 = 3.0 * (v1057 * v584);
        const double v1104 = (v1037 * ((v1038 * v539) + v1101)) * v1042;
        const double v1110 = (((v1045 * (v1104 * c1025)) * c1029) * v1031) - (v1033 * v1104);
        const double v1118 = (v1037 * ((v1038 * v634) - v1101)) * v1042;
        const double v1124 = (((v1045 * (v1118 * c1025)) * c1029) * v1031) - (v1033 * v1118);
        const double v1134 = (v1037 * ((v1038 * v698) + (3.0 * (v1057 * v740)))) * v1042;
        const double v1140 = (((v1045 * (v1134 * c1025)) * c1029) * v1031) - (v1033 * v1134);
        const double v1150 = (v1037 * ((v1038 * v791) + (3.0 * (v1057 * v824)))) * v1042;
        const double v1156 = (((v1045 * (v1150 * c1025)) * c1029) * v1031) - (v1033 * v1150);
        const double v1163 = squared(v51) + (3.0 * squared(v128));
        const double v1165 = sqrt(larger(v1163, c1021));
        const double v1166 = v1165 * c1025;
        const double v1169 = 1.0 / v1165;
        const double v1170 = (sinh(v1166) * c1029) * v1169;
        const double v1171 = v1170 * v1169;
        const double v1172 = (double)(c1021 <= v1163);
        const double v1175 = v1172 / (v1172 + (double)(v1163 <= c1021));
        const double v1176 = 2.0 * v51;
        const double v1180 = 1.0 / (2.0 * v1165);
        const double v1181 = (v1175 * (v1176 * c1)) * v1180;
        const double v1183 = cosh(v1166);
        const double v1188 = (v1171 * v1181) - (((v1183 * (v1181 * c1025)) * c1029) * v1169);
        const double v1195 = 2.0 * v128;
        const double v1197 = 3.0 * (v1195 * v375);
        const double v1200 = (v1175 * ((v1176 * v306) - v1197)) * v1180;
        const double v1206 = (((v1183 * (v1200 * c1025)) * c1029) * v1169) - (v1171 * v1200);
        const double v1214 = (v1175 * ((v1176 * v440) - v1197)) * v1180;
        const double v1220 = (((v1183 * (v1214 * c1025)) * c1029) * v1169) - (v1171 * v1214);
        const double v1227 = (v1175 * (3.0 * (v1195 * c120))) * v1180;
        const double v1233 = (v1171 * v1227) - (((v1183 * (v1227 * c1025)) * c1029) * v1169);
        const double v1239 = 3.0 * (v1195 * v584);
        const double v1242 = (v1175 * ((v1176 * v543) + v1239)) * v1180;
        const double v1248 = (((v1183 * (v1242 * c1025)) * c1029) * v1169) - (v1171 * v1242);
        const double v1256 = (v1175 * ((v1176 * v637) - v1239)) * v1180;
        const double v1262 = (((v1183 * (v1256 * c1025)) * c1029) * v1169) - (v1171 * v1256);
        const double v1272 = (v1175 * ((v1176 * v702) + (3.0 * (v1195 * v740)))) * v1180;
        const double v1278 = (((v1183 * (v1272 * c1025)) * c1029) * v1169) - (v1171 * v1272);
        const double v1288 = (v1175 * ((v1176 * v794) + (3.0 * (v1195 * v824)))) * v1180;
        const double v1294 = (((v1183 * (v1288 * c1025)) * c1029) * v1169) - (v1171 * v1288);
        const double v1301 = squared(v61) + (3.0 * squared(v133));
        const double v1303 = sqrt(larger(v1301, c1021));
        const double v1304 = v1303 * c1025;
        const double v1307 = 1.0 / v1303;
        const double v1308 = (sinh(v1304) * c1029) * v1307;
        const double v1309 = v1308 * v1307;
        const double v1310 = (double)(c1021 <= v1301);
        const double v1313 = v1310 / (v1310 + (double)(v1301 <= c1021));
        const double v1314 = 2.0 * v61;
        const double v1318 = 1.0 / (2.0 * v1303);
        const double v1319 = (v1313 * (v1314 * c1)) * v1318;
        const double v1321 = cosh(v1304);
        const double v1326 = (v1309 * v1319) - (((v1321 * (v1319 * c1025)) * c1029) * v1307);
        const double v1333 = 2.0 * v133;
        const double v1335 = 3.0 * (v1333 * v375);
        const double v1338 = (v1313 * ((v1314 * v315) - v1335)) * v1318;
        const double v1344 = (((v1321 * (v1338 * c1025)) * c1029) * v1307) - (v1309 * v1338);
        const double v1352 = (v1313 * ((v1314 * v445) - v1335)) * v1318;
        const double v1358 = (((v1321 * (v1352 * c1025)) * c1029) * v1307) - (v1309 * v1352);
        const double v1365 = (v1313 * (3.0 * (v1333 * c120))) * v1318;
        const double v1371 = (v1309 * v1365) - (((v1321 * (v1365 * c1025)) * c1029) * v1307);
        const double v1377 = 3.0 * (v1333 * v584);
        const double v1380 = (v1313 * ((v1314 * v548) + v1377)) * v1318;
        const double v1386 = (((v1321 * (v1380 * c1025)) * c1029) * v1307) - (v1309 * v1380);
        const double v1394 = (v1313 * ((v1314 * v641) - v1377)) * v1318;
        const double v1400 = (((v1321 * (v1394 * c1025)) * c1029) * v1307) - (v1309 * v1394);
        const double v1410 = (v1313 * ((v1314 * v707) + (3.0 * (v1333 * v740)))) * v1318;
        const double v1416 = (((v1321 * (v1410 * c1025)) * c1029) * v1307) - (v1309 * v1410);
        const double v1426 = (v1313 * ((v1314 * v798) + (3.0 * (v1333 * v824)))) * v1318;
        const double v1432 = (((v1321 * (v1426 * c1025)) * c1029) * v1307) - (v1309 * v1426);
        const double v1439 = squared(v71) + (3.0 * squared(v138));
        const double v1441 = sqrt(larger(v1439, c1021));
        const double v1442 = v1441 * c1025;
        const double v1445 = 1.0 / v1441;
        const double v1446 = (sinh(v1442) * c1029) * v1445;
        const double v1447 = v1446 * v1445;
        const double v1448 = (double)(c1021 <= v1439);
        const double v1451 = v1448 / (v1448 + (double)(v1439 <= c1021));
        const double v1452 = 2.0 * v71;
        const double v1456 = 1.0 / (2.0 * v1441);
        const double v1457 = (v1451 * (v1452 * c1)) * v1456;
        const double v1459 = cosh(v1442);
        const double v1464 = (v1447 * v1457) - (((v1459 * (v1457 * c1025)) * c1029) * v1445);
        const double v1471 = 2.0 * v138;
        const double v1473 = 3.0 * (v1471 * v375);
        const double v1476 = (v1451 * ((v1452 * v324) - v1473)) * v1456;
        const double v1482 = (((v1459 * (v1476 * c1025)) * c1029) * v1445) - (v1447 * v1476);
        const double v1490 = (v1451 * ((v1452 * v450) - v1473)) * v1456;
        const double v1496 = (((v1459 * (v1490 * c1025)) * c1029) * v1445) - (v1447 * v1490);
        const double v1503 = (v1451 * (3.0 * (v1471 * c120))) * v1456;
        const double v1509 = (v1447 * v1503) - (((v1459 * (v1503 * c1025)) * c1029) * v1445);
        const double v1515 = 3.0 * (v1471 * v584);
        const double v1518 = (v1451 * ((v1452 * v553) + v1515)) * v1456;
        const double v1524 = (((v1459 * (v1518 * c1025)) * c1029) * v1445) - (v1447 * v1518);
        const double v1532 = (v1451 * ((v1452 * v645) - v1515)) * v1456;
        const double v1538 = (((v1459 * (v1532 * c1025)) * c1029) * v1445) - (v1447 * v1532);
        const double v1548 = (v1451 * ((v1452 * v712) + (3.0 * (v1471 * v740)))) * v1456;
        const double v1554 = (((v1459 * (v1548 * c1025)) * c1029) * v1445) - (v1447 * v1548);
        const double v1564 = (v1451 * ((v1452 * v802) + (3.0 * (v1471 * v824)))) * v1456;
        const double v1570 = (((v1459 * (v1564 * c1025)) * c1029) * v1445) - (v1447 * v1564);
        const double v1577 = squared(v80) + (3.0 * squared(v143));
        const double v1579 = sqrt(larger(v1577, c1021));
        const double v1580 = v1579 * c1025;
        const double v1583 = 1.0 / v1579;
        const double v1584 = (sinh(v1580) * c1029) * v1583;
        const double v1585 = v1584 * v1583;
        const double v1586 = (double)(c1021 <= v1577);
        const double v1589 = v1586 / (v1586 + (double)(v1577 <= c1021));
        const double v1590 = 2.0 * v80;
        const double v1594 = 1.0 / (2.0 * v1579);
        const double v1595 = (v1589 * (v1590 * c1)) * v1594;
        const double v1597 = cosh(v1580);
        const double v1602 = (v1585 * v1595) - (((v1597 * (v1595 * c1025)) * c1029) * v1583);
        const double v1609 = 2.0 * v143;
        const double v1611 = 3.0 * (v1609 * v375);
        const double v1614 = (v1589 * ((v1590 * v333) - v1611)) * v1594;
        const double v1620 = (((v1597 * (v1614 * c1025)) * c1029) * v1583) - (v1585 * v1614);
        const double v1628 = (v1589 * ((v1590 * v455) - v1611)) * v1594;
        const double v1634 = (((v1597 * (v1628 * c1025)) * c1029) * v1583) - (v1585 * v1628);
        const double v1641 = (v1589 * (3.0 * (v1609 * c120))) * v1594;
        const double v1647 = (v1585 * v1641) - (((v1597 * (v1641 * c1025)) * c1029) * v1583);
        const double v1653 = 3.0 * (v1609 * v584);
        const double v1656 = (v1589 * ((v1590 * v558) + v1653)) * v1594;
        const double v1662 = (((v1597 * (v1656 * c1025)) * c1029) * v1583) - (v1585 * v1656);
        const double v1670 = (v1589 * ((v1590 * v649) - v1653)) * v1594;
        const double v1676 = (((v1597 * (v1670 * c1025)) * c1029) * v1583) - (v1585 * v1670);
        const double v1686 = (v1589 * ((v1590 * v717) + (3.0 * (v1609 * v740)))) * v1594;
        const double v1692 = (((v1597 * (v1686 * c1025)) * c1029) * v1583) - (v1585 * v1686);
        const double v1702 = (v1589 * ((v1590 * v806) + (3.0 * (v1609 * v824)))) * v1594;
        const double v1708 = (((v1597 * (v1702 * c1025)) * c1029) * v1583) - (v1585 * v1702);
        const double v1715 = squared(v89) + (3.0 * squared(v148));
        const double v1717 = sqrt(larger(v1715, c1021));
        const double v1718 = v1717 * c1025;
        const double v1721 = 1.0 / v1717;
        const double v1722 = (sinh(v1718) * c1029) * v1721;
        const double v1723 = v1722 * v1721;
        const double v1724 = (double)(c1021 <= v1715);
        const double v1727 = v1724 / (v1724 + (double)(v1715 <= c1021));
        const double v1728 = 2.0 * v89;
        const double v1732 = 1.0 / (2.0 * v1717);
        const double v1733 = (v1727 * (v1728 * c1)) * v1732;
        const double v1735 = cosh(v1718);
        const double v1740 = (v1723 * v1733) - (((v1735 * (v1733 * c1025)) * c1029) * v1721);
        const double v1747 = 2.0 * v148;
        const double v1749 = 3.0 * (v1747 * v375);
        const double v1752 = (v1727 * ((v1728 * v342) - v1749)) * v1732;
        const double v1758 = (((v1735 * (v1752 * c1025)) * c1029) * v1721) - (v1723 * v1752);
        const double v1766 = (v1727 * ((v1728 * v460) - v1749)) * v1732;
        const double v1772 = (((v1735 * (v1766 * c1025)) * c1029) * v1721) - (v1723 * v1766);
        const double v1779 = (v1727 * (3.0 * (v1747 * c120))) * v1732;
        const double v1785 = (v1723 * v1779) - (((v1735 * (v1779 * c1025)) * c1029) * v1721);
        const double v1791 = 3.0 * (v1747 * v584);
        const double v1794 = (v1727 * ((v1728 * v563) + v1791)) * v1732;
        const double v1800 = (((v1735 * (v1794 * c1025)) * c1029) * v1721) - (v1723 * v1794);
        const double v1808 = (v1727 * ((v1728 * v653) - v1791)) * v1732;
        const double v1814 = (((v1735 * (v1808 * c1025)) * c1029) * v1721) - (v1723 * v1808);
        const double v1824 = (v1727 * ((v1728 * v722) + (3.0 * (v1747 * v740)))) * v1732;
        const double v1830 = (((v1735 * (v1824 * c1025)) * c1029) * v1721) - (v1723 * v1824);
        const double v1840 = (v1727 * ((v1728 * v810) + (3.0 * (v1747 * v824)))) * v1732;
        const double v1846 = (((v1735 * (v1840 * c1025)) * c1029) * v1721) - (v1723 * v1840);
        const double v1853 = squared(v98) + (3.0 * squared(v153));
        const double v1855 = sqrt(larger(v1853, c1021));
        const double v1856 = v1855 * c1025;
        const double v1859 = 1.0 / v1855;
        const double v1860 = (sinh(v1856) * c1029) * v1859;
        const double v1861 = v1860 * v1859;
        const double v1862 = (double)(c1021 <= v1853);
        const double v1865 = v1862 / (v1862 + (double)(v1853 <= c1021));
        const double v1866 = 2.0 * v98;
        const double v1870 = 1.0 / (2.0 * v1855);
        const double v1871 = (v1865 * (v1866 * c1)) * v1870;
        const double v1873 = cosh(v1856);
        const double v1878 = (v1861 * v1871) - (((v1873 * (v1871 * c1025)) * c1029) * v1859);
        const double v1885 = 2.0 * v153;
        const double v1887 = 3.0 * (v1885 * v375);
        const double v1890 = (v1865 * ((v1866 * v351) - v1887)) * v1870;
        const double v1896 = (((v1873 * (v1890 * c1025)) * c1029) * v1859) - (v1861 * v1890);
        const double v1904 = (v1865 * ((v1866 * v465) - v1887)) * v1870;
        const double v1910 = (((v1873 * (v1904 * c1025)) * c1029) * v1859) - (v1861 * v1904);
        const double v1917 = (v1865 * (3.0 * (v1885 * c120))) * v1870;
        const double v1923 = (v1861 * v1917) - (((v1873 * (v1917 * c1025)) * c1029) * v1859);
        const double v1929 = 3.0 * (v1885 * v584);
        const double v1932 = (v1865 * ((v1866 * v568) + v1929)) * v1870;
        const double v1938 = (((v1873 * (v1932 * c1025)) * c1029) * v1859) - (v1861 * v1932);
        const double v1946 = (v1865 * ((v1866 * v657) - v1929)) * v1870;
        const double v1952 = (((v1873 * (v1946 * c1025)) * c1029) * v1859) - (v1861 * v1946);
        const double v1962 = (v1865 * ((v1866 * v727) + (3.0 * (v1885 * v740)))) * v1870;
        const double v1968 = (((v1873 * (v1962 * c1025)) * c1029) * v1859) - (v1861 * v1962);
        const double v1978 = (v1865 * ((v1866 * v814) + (3.0 * (v1885 * v824)))) * v1870;
        const double v1984 = (((v1873 * (v1978 * c1025)) * c1029) * v1859) - (v1861 * v1978);
        const double v1991 = squared(v107) + (3.0 * squared(v158));
        const double v1993 = sqrt(larger(v1991, c1021));
        const double v1994 = v1993 * c1025;
        const double v1997 = 1.0 / v1993;
        const double v1998 = (sinh(v1994) * c1029) * v1997;
        const double v1999 = v1998 * v1997;
        const double v2000 = (double)(c1021 <= v1991);
        const double v2003 = v2000 / (v2000 + (double)(v1991 <= c1021));
        const double v2004 = 2.0 * v107;
        const double v2008 = 1.0 / (2.0 * v1993);
        const double v2009 = (v2003 * (v2004 * c1)) * v2008;
        const double v2011 = cosh(v1994);
        const double v2016 = (v1999 * v2009) - (((v2011 * (v2009 * c1025)) * c1029) * v1997);
        const double v2023 = 2.0 * v158;
        const double v2025 = 3.0 * (v2023 * v375);
        const double v2028 = (v2003 * ((v2004 * v360) - v2025)) * v2008;
        const double v2034 = (((v2011 * (v2028 * c1025)) * c1029) * v1997) - (v1999 * v2028);
        const double v2042 = (v2003 * ((v2004 * v470) - v2025)) * v2008;
        const double v2048 = (((v2011 * (v2042 * c1025)) * c1029) * v1997) - (v1999 * v2042);
        const double v2055 = (v2003 * (3.0 * (v2023 * c120))) * v2008;
        const double v2061 = (v1999 * v2055) - (((v2011 * (v2055 * c1025)) * c1029) * v1997);
        const double v2067 = 3.0 * (v2023 * v584);
        const double v2070 = (v2003 * ((v2004 * v573) + v2067)) * v2008;
        const double v2076 = (((v2011 * (v2070 * c1025)) * c1029) * v1997) - (v1999 * v2070);
        const double v2084 = (v2003 * ((v2004 * v661) - v2067)) * v2008;
        const double v2090 = (((v2011 * (v2084 * c1025)) * c1029) * v1997) - (v1999 * v2084);
        const double v2100 = (v2003 * ((v2004 * v732) + (3.0 * (v2023 * v740)))) * v2008;
        const double v2106 = (((v2011 * (v2100 * c1025)) * c1029) * v1997) - (v1999 * v2100);
        const double v2116 = (v2003 * ((v2004 * v818) + (3.0 * (v2023 * v824)))) * v2008;
        const double v2122 = (((v2011 * (v2116 * c1025)) * c1029) * v1997) - (v1999 * v2116);
        const double v2126 = 3.0 * v124;
        const double v2130 = 3.0 * v375;
        const double v2131 = v1032 * v2130;
        const double v2142 = 3.0 * v584;
        const double v2143 = v1032 * v2142;
        const double v2150 = 3.0 * v740;
        const double v2155 = 3.0 * v824;
        const double v2160 = 3.0 * v128;
        const double v2164 = v1170 * v2130;
        const double v2174 = v1170 * v2142;
        const double v2189 = 3.0 * v133;
        const double v2193 = v1308 * v2130;
        const double v2203 = v1308 * v2142;
        const double v2218 = 3.0 * v138;
        const double v2222 = v1446 * v2130;
        const double v2232 = v1446 * v2142;
        const double v2247 = 3.0 * v143;
        const double v2251 = v1584 * v2130;
        const double v2261 = v1584 * v2142;
        const double v2276 = 3.0 * v148;
        const double v2280 = v1722 * v2130;
        const double v2290 = v1722 * v2142;
        const double v2305 = 3.0 * v153;
        const double v2309 = v1860 * v2130;
        const double v2319 = v1860 * v2142;
        const double v2334 = 3.0 * v158;
        const double v2338 = v1998 * v2130;
        const double v2348 = v1998 * v2142;
        w3[i] = (v195 * v25) - (v161 * v31);
        w7[i] = -(v25 * v207);
        w8[i] = -(v25 * v218);
        w9[i] = -(v25 * v229);
        w10[i] = -(v25 * v240);
        w11[i] = -(v25 * v249);
        w12[i] = -(v25 * v258);
        w13[i] = -(v25 * v267);
        w14[i] = -(v25 * v276);
        w15[i] = ((v25 * v426) - v428) - v432;
        w16[i] = ((v25 * v499) - v428) - v432;
        w17[i] = v509;
        w18[i] = v516;
        w19[i] = v523;
        w20[i] = v530;
        w21[i] = v530;
        w22[i] = v523;
        w23[i] = v516;
        w24[i] = v509;
        w25[i] = (v25 * v629) - v631;
        w26[i] = (v25 * v689) + v631;
        w27[i] = (v25 * v786) - (v31 * v754);
        w28[i] = (v25 * v865) - (v31 * v837);
        w4[i] = (v195 * v31) + (v161 * v25);
        w29[i] = -(v31 * v207);
        w30[i] = -(v31 * v218);
        w31[i] = -(v31 * v229);
        w32[i] = -(v31 * v240);
        w33[i] = -(v31 * v249);
        w34[i] = -(v31 * v258);
        w35[i] = -(v31 * v267);
        w36[i] = -(v31 * v276);
        w37[i] = ((v31 * v426) + v889) - v893;
        w38[i] = ((v31 * v499) + v889) - v893;
        w39[i] = v900;
        w40[i] = v903;
        w41[i] = v906;
        w42[i] = v909;
        w43[i] = v909;
        w44[i] = v906;
        w45[i] = v903;
        w46[i] = v900;
        w47[i] = (v31 * v629) + v911;
        w48[i] = (v31 * v689) - v911;
        w49[i] = (v31 * v786) + (v25 * v754);
        w50[i] = (v31 * v865) + (v25 * v837);
        w5[i] = (v921 * (v160 - (v114 * v195))) * 0.5;
        w51[i] = 0.5 * (v921 * (v114 * v207));
        w52[i] = 0.5 * (v921 * (v114 * v218));
        w53[i] = 0.5 * (v921 * (v114 * v229));
        w54[i] = 0.5 * (v921 * (v114 * v240));
        w55[i] = 0.5 * (v921 * (v114 * v249));
        w56[i] = 0.5 * (v921 * (v114 * v258));
        w57[i] = 0.5 * (v921 * (v114 * v267));
        w58[i] = 0.5 * (v921 * (v114 * v276));
        w59[i] = -(0.5 * (v921 * (v386 + ((v114 * v426) - v951))));
        w60[i] = -(0.5 * (v921 * (v386 + ((v114 * v499) - v951))));
        w61[i] = v967;
        w62[i] = v972;
        w63[i] = v977;
        w64[i] = v982;
        w65[i] = v982;
        w66[i] = v977;
        w67[i] = v972;
        w68[i] = v967;
        w69[i] = 0.5 * (v921 * (v595 - (v983 + (v114 * v629))));
        w70[i] = -(0.5 * (v921 * (v595 + ((v114 * v689) - v983))));
        w71[i] = 0.5 * (v921 * (v751 - ((v114 * v786) - v996)));
        w72[i] = 0.5 * (v921 * (v835 - (v996 + (v114 * v865))));
        w6[i] = -v191;
        w73[i] = v203;
        w74[i] = v214;
        w75[i] = v225;
        w76[i] = v236;
        w77[i] = v245;
        w78[i] = v254;
        w79[i] = v263;
        w80[i] = v272;
        w81[i] = -v417;
        w82[i] = -v493;
        w83[i] = -v623;
        w84[i] = -v684;
        w85[i] = -v780;
        w86[i] = -v860;
        e[254 * i + 129] = c1013 * ((v42 * v1050) - (v1032 * c1));
        e[254 * i + 128] = c1013 * ((v1032 * v298) + (v42 * v1068));
        e[254 * i + 133] = c1013 * ((v1032 * v436) + (v42 * v1082));
        e[254 * i + 130] = c1013 * (v42 * v1095);
        e[254 * i + 126] = c1013 * ((v1032 * v539) + (v42 * v1110));
        e[254 * i + 131] = c1013 * ((v1032 * v634) + (v42 * v1124));
        e[254 * i + 127] = c1013 * ((v1032 * v698) + (v42 * v1140));
        e[254 * i + 132] = c1013 * ((v1032 * v791) + (v42 * v1156));
        e[254 * i + 137] = c1013 * ((v51 * v1188) - (v1170 * c1));
        e[254 * i + 136] = c1013 * ((v1170 * v306) + (v51 * v1206));
        e[254 * i + 141] = c1013 * ((v1170 * v440) + (v51 * v1220));
        e[254 * i + 138] = c1013 * (v51 * v1233);
        e[254 * i + 134] = c1013 * ((v1170 * v543) + (v51 * v1248));
        e[254 * i + 139] = c1013 * ((v1170 * v637) + (v51 * v1262));
        e[254 * i + 135] = c1013 * ((v1170 * v702) + (v51 * v1278));
        e[254 * i + 140] = c1013 * ((v1170 * v794) + (v51 * v1294));
        e[254 * i + 145] = c1013 * ((v61 * v1326) - (v1308 * c1));
        e[254 * i + 144] = c1013 * ((v1308 * v315) + (v61 * v1344));
        e[254 * i + 149] = c1013 * ((v1308 * v445) + (v61 * v1358));
        e[254 * i + 146] = c1013 * (v61 * v1371);
        e[254 * i + 142] = c1013 * ((v1308 * v548) + (v61 * v1386));
        e[254 * i + 147] = c1013 * ((v1308 * v641) + (v61 * v1400));
        e[254 * i + 143] = c1013 * ((v1308 * v707) + (v61 * v1416));
        e[254 * i + 148] = c1013 * ((v1308 * v798) + (v61 * v1432));
        e[254 * i + 153] = c1013 * ((v71 * v1464) - (v1446 * c1));
        e[254 * i + 152] = c1013 * ((v1446 * v324) + (v71 * v1482));
        e[254 * i + 157] = c1013 * ((v1446 * v450) + (v71 * v1496));
        e[254 * i + 154] = c1013 * (v71 * v1509);
        e[254 * i + 150] = c1013 * ((v1446 * v553) + (v71 * v1524));
        e[254 * i + 155] = c1013 * ((v1446 * v645) + (v71 * v1538));
        e[254 * i + 151] = c1013 * ((v1446 * v712) + (v71 * v1554));
        e[254 * i + 156] = c1013 * ((v1446 * v802) + (v71 * v1570));
        e[254 * i + 161] = c1013 * ((v80 * v1602) - (v1584 * c1));
        e[254 * i + 160] = c1013 * ((v1584 * v333) + (v80 * v1620));
        e[254 * i + 165] = c1013 * ((v1584 * v455) + (v80 * v1634));
        e[254 * i + 162] = c1013 * (v80 * v1647);
        e[254 * i + 158] = c1013 * ((v1584 * v558) + (v80 * v1662));
        e[254 * i + 163] = c1013 * ((v1584 * v649) + (v80 * v1676));
        e[254 * i + 159] = c1013 * ((v1584 * v717) + (v80 * v1692));
        e[254 * i + 164] = c1013 * ((v1584 * v806) + (v80 * v1708));
        e[254 * i + 169] = c1013 * ((v89 * v1740) - (v1722 * c1));
        e[254 * i + 168] = c1013 * ((v1722 * v342) + (v89 * v1758));
        e[254 * i + 173] = c1013 * ((v1722 * v460) + (v89 * v1772));
        e[254 * i + 170] = c1013 * (v89 * v1785);
        e[254 * i + 166] = c1013 * ((v1722 * v563) + (v89 * v1800));
        e[254 * i + 171] = c1013 * ((v1722 * v653) + (v89 * v1814));
        e[254 * i + 167] = c1013 * ((v1722 * v722) + (v89 * v1830));
        e[254 * i + 172] = c1013 * ((v1722 * v810) + (v89 * v1846));
        e[254 * i + 177] = c1013 * ((v98 * v1878) - (v1860 * c1));
        e[254 * i + 176] = c1013 * ((v1860 * v351) + (v98 * v1896));
        e[254 * i + 181] = c1013 * ((v1860 * v465) + (v98 * v1910));
        e[254 * i + 178] = c1013 * (v98 * v1923);
        e[254 * i + 174] = c1013 * ((v1860 * v568) + (v98 * v1938));
        e[254 * i + 179] = c1013 * ((v1860 * v657) + (v98 * v1952));
        e[254 * i + 175] = c1013 * ((v1860 * v727) + (v98 * v1968));
        e[254 * i + 180] = c1013 * ((v1860 * v814) + (v98 * v1984));
        e[254 * i + 185] = c1013 * ((v107 * v2016) - (v1998 * c1));
        e[254 * i + 184] = c1013 * ((v1998 * v360) + (v107 * v2034));
        e[254 * i + 189] = c1013 * ((v1998 * v470) + (v107 * v2048));
        e[254 * i + 186] = c1013 * (v107 * v2061);
        e[254 * i + 182] = c1013 * ((v1998 * v573) + (v107 * v2076));
        e[254 * i + 187] = c1013 * ((v1998 * v661) + (v107 * v2090));
        e[254 * i + 183] = c1013 * ((v1998 * v732) + (v107 * v2106));
        e[254 * i + 188] = c1013 * ((v1998 * v818) + (v107 * v2122));
        e[254 * i + 193] = c1013 * (v2126 * v1050);
        e[254 * i + 192] = c1013 * ((v2126 * v1068) - v2131);
        e[254 * i + 197] = c1013 * ((v2126 * v1082) - v2131);
        e[254 * i + 194] = c1013 * ((v2126 * v1095) - (v1032 * c2138));
        e[254 * i + 190] = c1013 * (v2143 + (v2126 * v1110));
        e[254 * i + 195] = c1013 * ((v2126 * v1124) - v2143);
        e[254 * i + 191] = c1013 * ((v1032 * v2150) + (v2126 * v1140));
        e[254 * i + 196] = c1013 * ((v1032 * v2155) + (v2126 * v1156));
        e[254 * i + 201] = c1013 * (v2160 * v1188);
        e[254 * i + 200] = c1013 * ((v2160 * v1206) - v2164);
        e[254 * i + 205] = c1013 * ((v2160 * v1220) - v2164);
        e[254 * i + 202] = c1013 * ((v2160 * v1233) - (v1170 * c2138));
        e[254 * i + 198] = c1013 * (v2174 + (v2160 * v1248));
        e[254 * i + 203] = c1013 * ((v2160 * v1262) - v2174);
        e[254 * i + 199] = c1013 * ((v1170 * v2150) + (v2160 * v1278));
        e[254 * i + 204] = c1013 * ((v1170 * v2155) + (v2160 * v1294));
        e[254 * i + 209] = c1013 * (v2189 * v1326);
        e[254 * i + 208] = c1013 * ((v2189 * v1344) - v2193);
        e[254 * i + 213] = c1013 * ((v2189 * v1358) - v2193);
        e[254 * i + 210] = c1013 * ((v2189 * v1371) - (v1308 * c2138));
        e[254 * i + 206] = c1013 * (v2203 + (v2189 * v1386));
        e[254 * i + 211] = c1013 * ((v2189 * v1400) - v2203);
        e[254 * i + 207] = c1013 * ((v1308 * v2150) + (v2189 * v1416));
        e[254 * i + 212] = c1013 * ((v1308 * v2155) + (v2189 * v1432));
        e[254 * i + 217] = c1013 * (v2218 * v1464);
        e[254 * i + 216] = c1013 * ((v2218 * v1482) - v2222);
        e[254 * i + 221] = c1013 * ((v2218 * v1496) - v2222);
        e[254 * i + 218] = c1013 * ((v2218 * v1509) - (v1446 * c2138));
        e[254 * i + 214] = c1013 * (v2232 + (v2218 * v1524));
        e[254 * i + 219] = c1013 * ((v2218 * v1538) - v2232);
        e[254 * i + 215] = c1013 * ((v1446 * v2150) + (v2218 * v1554));
        e[254 * i + 220] = c1013 * ((v1446 * v2155) + (v2218 * v1570));
        e[254 * i + 225] = c1013 * (v2247 * v1602);
        e[254 * i + 224] = c1013 * ((v2247 * v1620) - v2251);
        e[254 * i + 229] = c1013 * ((v2247 * v1634) - v2251);
        e[254 * i + 226] = c1013 * ((v2247 * v1647) - (v1584 * c2138));
        e[254 * i + 222] = c1013 * (v2261 + (v2247 * v1662));
        e[254 * i + 227] = c1013 * ((v2247 * v1676) - v2261);
        e[254 * i + 223] = c1013 * ((v1584 * v2150) + (v2247 * v1692));
        e[254 * i + 228] = c1013 * ((v1584 * v2155) + (v2247 * v1708));
        e[254 * i + 233] = c1013 * (v2276 * v1740);
        e[254 * i + 232] = c1013 * ((v2276 * v1758) - v2280);
        e[254 * i + 237] = c1013 * ((v2276 * v1772) - v2280);
        e[254 * i + 234] = c1013 * ((v2276 * v1785) - (v1722 * c2138));
        e[254 * i + 230] = c1013 * (v2290 + (v2276 * v1800));
        e[254 * i + 235] = c1013 * ((v2276 * v1814) - v2290);
        e[254 * i + 231] = c1013 * ((v1722 * v2150) + (v2276 * v1830));
        e[254 * i + 236] = c1013 * ((v1722 * v2155) + (v2276 * v1846));
        e[254 * i + 241] = c1013 * (v2305 * v1878);
        e[254 * i + 240] = c1013 * ((v2305 * v1896) - v2309);
        e[254 * i + 245] = c1013 * ((v2305 * v1910) - v2309);
        e[254 * i + 242] = c1013 * ((v2305 * v1923) - (v1860 * c2138));
        e[254 * i + 238] = c1013 * (v2319 + (v2305 * v1938));
        e[254 * i + 243] = c1013 * ((v2305 * v1952) - v2319);
        e[254 * i + 239] = c1013 * ((v1860 * v2150) + (v2305 * v1968));
        e[254 * i + 244] = c1013 * ((v1860 * v2155) + (v2305 * v1984));
        e[254 * i + 249] = c1013 * (v2334 * v2016);
        e[254 * i + 248] = c1013 * ((v2334 * v2034) - v2338);
        e[254 * i + 253] = c1013 * ((v2334 * v2048) - v2338);
        e[254 * i + 250] = c1013 * ((v2334 * v2061) - (v1998 * c2138));
        e[254 * i + 246] = c1013 * (v2348 + (v2334 * v2076));
        e[254 * i + 251] = c1013 * ((v2334 * v2090) - v2348);
        e[254 * i + 247] = c1013 * ((v1998 * v2150) + (v2334 * v2106));
        e[254 * i + 252] = c1013 * ((v1998 * v2155) + (v2334 * v2122));
    }
}

static void jacobian_7(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c121 = 0.0625 * c4;
    const double c123 = squared(p[1]);
    const double c124 = c121 * c123;
    const double c125 = c124 * c2;
    const double c126 = c1 / c125;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v129 = c126 * g[7 * i + 5];
        const double v222 = ((v129 * w81[i]) - (v129 * w82[i - 1])) + (v129 * w60[i - 1]);
        const double v275 = ((v129 * w83[i]) - (v129 * w84[i - 1])) + (v129 * w70[i - 1]);
        const double v296 = ((v129 * w85[i]) - (v129 * w86[i - 1])) + (v129 * w72[i - 1]);
        e[254 * i + 5] = -(v9 * w7[i - 1]);
        e[254 * i + 24] = v9 * w7[i];
        e[254 * i + 6] = -(v9 * w8[i - 1]);
        e[254 * i + 25] = v9 * w8[i];
        e[254 * i + 7] = -(v9 * w9[i - 1]);
        e[254 * i + 26] = v9 * w9[i];
        e[254 * i + 8] = -(v9 * w10[i - 1]);
        e[254 * i + 27] = v9 * w10[i];
        e[254 * i + 9] = -(v9 * w11[i - 1]);
        e[254 * i + 28] = v9 * w11[i];
        e[254 * i + 10] = -(v9 * w12[i - 1]);
        e[254 * i + 29] = v9 * w12[i];
        e[254 * i + 11] = -(v9 * w13[i - 1]);
        e[254 * i + 30] = v9 * w13[i];
        e[254 * i + 12] = -(v9 * w14[i - 1]);
        e[254 * i + 31] = v9 * w14[i];
        e[254 * i + 4] = -(v9 * w15[i - 1]);
        e[254 * i + 23] = (v9 * w15[i]) - (v9 * w16[i - 1]);
        e[254 * i + 42] = v9 * w16[i];
        e[254 * i + 13] = -(v9 * w17[i - 1]);
        e[254 * i + 32] = v9 * w17[i];
        e[254 * i + 14] = -(v9 * w18[i - 1]);
        e[254 * i + 33] = v9 * w18[i];
        e[254 * i + 15] = -(v9 * w19[i - 1]);
        e[254 * i + 34] = v9 * w19[i];
        e[254 * i + 16] = -(v9 * w20[i - 1]);
        e[254 * i + 35] = v9 * w20[i];
        e[254 * i + 17] = -(v9 * w21[i - 1]);
        e[254 * i + 36] = v9 * w21[i];
        e[254 * i + 18] = -(v9 * w22[i - 1]);
        e[254 * i + 37] = v9 * w22[i];
        e[254 * i + 19] = -(v9 * w23[i - 1]);
        e[254 * i + 38] = v9 * w23[i];
        e[254 * i + 20] = -(v9 * w24[i - 1]);
        e[254 * i + 39] = v9 * w24[i];
        e[254 * i + 2] = -(v9 * w25[i - 1]);
        e[254 * i + 21] = (v9 * w25[i]) - (v9 * w26[i - 1]);
        e[254 * i + 40] = v9 * w26[i];
        e[254 * i + 3] = -(v9 * w27[i - 1]);
        e[254 * i + 22] = (v9 * w27[i]) - (v9 * w28[i - 1]);
        e[254 * i + 41] = v9 * w28[i];
        e[254 * i + 88] = (v129 * w51[i - 1]) - (v129 * w73[i - 1]);
        e[254 * i + 107] = (v129 * w73[i]) + (v129 * w51[i]);
        e[254 * i + 89] = (v129 * w52[i - 1]) - (v129 * w74[i - 1]);
        e[254 * i + 108] = (v129 * w74[i]) + (v129 * w52[i]);
        e[254 * i + 90] = (v129 * w53[i - 1]) - (v129 * w75[i - 1]);
        e[254 * i + 109] = (v129 * w75[i]) + (v129 * w53[i]);
        e[254 * i + 91] = (v129 * w54[i - 1]) - (v129 * w76[i - 1]);
        e[254 * i + 110] = (v129 * w76[i]) + (v129 * w54[i]);
        e[254 * i + 92] = (v129 * w55[i - 1]) - (v129 * w77[i - 1]);
        e[254 * i + 111] = (v129 * w77[i]) + (v129 * w55[i]);
        e[254 * i + 93] = (v129 * w56[i - 1]) - (v129 * w78[i - 1]);
        e[254 * i + 112] = (v129 * w78[i]) + (v129 * w56[i]);
        e[254 * i + 94] = (v129 * w57[i - 1]) - (v129 * w79[i - 1]);
        e[254 * i + 113] = (v129 * w79[i]) + (v129 * w57[i]);
        e[254 * i + 95] = (v129 * w58[i - 1]) - (v129 * w80[i - 1]);
        e[254 * i + 114] = (v129 * w80[i]) + (v129 * w58[i]);
        e[254 * i + 87] = (v129 * w59[i - 1]) - (v129 * w81[i - 1]);
        e[254 * i + 106] = v222 + (v129 * w59[i]);
        e[254 * i + 125] = (v129 * w82[i]) + (v129 * w60[i]);
        e[254 * i + 96] = v129 * w61[i - 1];
        e[254 * i + 115] = v129 * w61[i];
        e[254 * i + 97] = v129 * w62[i - 1];
        e[254 * i + 116] = v129 * w62[i];
        e[254 * i + 98] = v129 * w63[i - 1];
        e[254 * i + 117] = v129 * w63[i];
        e[254 * i + 99] = v129 * w64[i - 1];
        e[254 * i + 118] = v129 * w64[i];
        e[254 * i + 100] = v129 * w65[i - 1];
        e[254 * i + 119] = v129 * w65[i];
        e[254 * i + 101] = v129 * w66[i - 1];
        e[254 * i + 120] = v129 * w66[i];
        e[254 * i + 102] = v129 * w67[i - 1];
        e[254 * i + 121] = v129 * w67[i];
        e[254 * i + 103] = v129 * w68[i - 1];
        e[254 * i + 122] = v129 * w68[i];
        e[254 * i + 85] = (v129 * w69[i - 1]) - (v129 * w83[i - 1]);
        e[254 * i + 104] = v275 + (v129 * w69[i]);
        e[254 * i + 123] = (v129 * w84[i]) + (v129 * w70[i]);
        e[254 * i + 86] = (v129 * w71[i - 1]) - (v129 * w85[i - 1]);
        e[254 * i + 105] = v296 + (v129 * w71[i]);
        e[254 * i + 124] = (v129 * w86[i]) + (v129 * w72[i]);
    }
}

static void jacobian_8(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[254 * i + 46] = -(v9 * w29[i - 1]);
        e[254 * i + 65] = v9 * w29[i];
        e[254 * i + 47] = -(v9 * w30[i - 1]);
        e[254 * i + 66] = v9 * w30[i];
        e[254 * i + 48] = -(v9 * w31[i - 1]);
        e[254 * i + 67] = v9 * w31[i];
        e[254 * i + 49] = -(v9 * w32[i - 1]);
        e[254 * i + 68] = v9 * w32[i];
        e[254 * i + 50] = -(v9 * w33[i - 1]);
        e[254 * i + 69] = v9 * w33[i];
        e[254 * i + 51] = -(v9 * w34[i - 1]);
        e[254 * i + 70] = v9 * w34[i];
        e[254 * i + 52] = -(v9 * w35[i - 1]);
        e[254 * i + 71] = v9 * w35[i];
        e[254 * i + 53] = -(v9 * w36[i - 1]);
        e[254 * i + 72] = v9 * w36[i];
        e[254 * i + 45] = -(v9 * w37[i - 1]);
        e[254 * i + 64] = (v9 * w37[i]) - (v9 * w38[i - 1]);
        e[254 * i + 83] = v9 * w38[i];
        e[254 * i + 54] = -(v9 * w39[i - 1]);
        e[254 * i + 73] = v9 * w39[i];
        e[254 * i + 55] = -(v9 * w40[i - 1]);
        e[254 * i + 74] = v9 * w40[i];
        e[254 * i + 56] = -(v9 * w41[i - 1]);
        e[254 * i + 75] = v9 * w41[i];
        e[254 * i + 57] = -(v9 * w42[i - 1]);
        e[254 * i + 76] = v9 * w42[i];
        e[254 * i + 58] = -(v9 * w43[i - 1]);
        e[254 * i + 77] = v9 * w43[i];
        e[254 * i + 59] = -(v9 * w44[i - 1]);
        e[254 * i + 78] = v9 * w44[i];
        e[254 * i + 60] = -(v9 * w45[i - 1]);
        e[254 * i + 79] = v9 * w45[i];
        e[254 * i + 61] = -(v9 * w46[i - 1]);
        e[254 * i + 80] = v9 * w46[i];
        e[254 * i + 43] = -(v9 * w47[i - 1]);
        e[254 * i + 62] = (v9 * w47[i]) - (v9 * w48[i - 1]);
        e[254 * i + 81] = v9 * w48[i];
        e[254 * i + 44] = -(v9 * w49[i - 1]);
        e[254 * i + 63] = (v9 * w49[i]) - (v9 * w50[i - 1]);
        e[254 * i + 82] = v9 * w50[i];
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[254 * i + 65] = v9 * w29[i];
    e[254 * i + 66] = v9 * w30[i];
    e[254 * i + 67] = v9 * w31[i];
    e[254 * i + 68] = v9 * w32[i];
    e[254 * i + 69] = v9 * w33[i];
    e[254 * i + 70] = v9 * w34[i];
    e[254 * i + 71] = v9 * w35[i];
    e[254 * i + 72] = v9 * w36[i];
    e[254 * i + 64] = v9 * w37[i];
    e[254 * i + 83] = v9 * w38[i];
    e[254 * i + 73] = v9 * w39[i];
    e[254 * i + 74] = v9 * w40[i];
    e[254 * i + 75] = v9 * w41[i];
    e[254 * i + 76] = v9 * w42[i];
    e[254 * i + 77] = v9 * w43[i];
    e[254 * i + 78] = v9 * w44[i];
    e[254 * i + 79] = v9 * w45[i];
    e[254 * i + 80] = v9 * w46[i];
    e[254 * i + 62] = v9 * w47[i];
    e[254 * i + 81] = v9 * w48[i];
    e[254 * i + 63] = v9 * w49[i];
    e[254 * i + 82] = v9 * w50[i];
    (void)n;
}

static void work_0(int n, const double *p, const double *g, const double *y, double *w, double *q)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c2 = p[5];
    const double c6 = (-0.5) * p[1];
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c46 = 0.9 * c2;
    const double c48 = 2.0 * p[6];
    const double c49 = 2.0 + c48;
    const double c50 = c46 / c49;
    const double c62 = 1e-12 * c2;
    const double c63 = squared(c62);
    const double c67 = 1.0 / p[7];
    const double c71 = 1.0 / p[8];
    const double c233 = p[9];
    const double c235 = c11 / c233;
    const double c236 = squared(c235);
    const double c237 = p[2] * c236;
    const double c238 = c233 / c237;
    for (int i = 0; i < n - 1; i++) {
        const double v7 = w1[i + 1];
        const double v8 = w1[i];
        const double v10 = g[7 * i + 4];
        const double v15 = c6 * ((v7 - v8) * (v10 * c12));
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v24 = (v8 + v7) * 0.5;
        const double v25 = cos(v24);
        const double v30 = (w2[i + 1] - w2[i]) * v10;
        const double v31 = sin(v24);
        const double v33 = (v20 * v25) + (v30 * v31);
        const double v36 = 1.0 / (sqrt(v33) * v33);
        const double v40 = log(v33);
        const double v41 = ((((-0.8977882908473036) * v15) * v36) - y[22 * i + 6]) + v40;
        const double v54 = ((v30 * v25) - (v20 * v31)) / v33;
        const double v60 = squared((c2 * v41)) + (3.0 * squared((c50 * (v54 - y[22 * i + 14]))));
        const double v65 = sqrt(larger(v60, c63));
        const double v81 = ((((-0.631771669920152) * v15) * v36) - y[22 * i + 7]) + v40;
        const double v89 = squared((c2 * v81)) + (3.0 * squared((c50 * (v54 - y[22 * i + 15]))));
        const double v91 = sqrt(larger(v89, c63));
        const double v97 = (0.055346757660697604 * (v65 * (sinh(v65 * c67) * c71))) + (0.1559825412417957 * (v91 * (sinh(v91 * c67) * c71)));
        const double v104 = ((((-0.3092051869716723) * v15) * v36) - y[22 * i + 8]) + v40;
        const double v112 = squared((c2 * v104)) + (3.0 * squared((c50 * (v54 - y[22 * i + 16]))));
        const double v114 = sqrt(larger(v112, c63));
        const double v120 = v97 + (0.18502795280105888 * (v114 * (sinh(v114 * c67) * c71)));
        const double v127 = ((((-0.0652237289787655) * v15) * v36) - y[22 * i + 9]) + v40;
        const double v135 = squared((c2 * v127)) + (3.0 * squared((c50 * (v54 - y[22 * i + 17]))));
        const double v137 = sqrt(larger(v135, c63));
        const double v143 = v120 + (0.10364274829644775 * (v137 * (sinh(v137 * c67) * c71)));
        const double v149 = (((0.0652237289787655 * v15) * v36) - y[22 * i + 10]) + v40;
        const double v157 = squared((c2 * v149)) + (3.0 * squared((c50 * (v54 - y[22 * i + 18]))));
        const double v159 = sqrt(larger(v157, c63));
        const double v165 = v143 + (0.10364274829644775 * (v159 * (sinh(v159 * c67) * c71)));
        const double v171 = (((0.3092051869716723 * v15) * v36) - y[22 * i + 11]) + v40;
        const double v179 = squared((c2 * v171)) + (3.0 * squared((c50 * (v54 - y[22 * i + 19]))));
        const double v181 = sqrt(larger(v179, c63));
        const double v187 = v165 + (0.18502795280105888 * (v181 * (sinh(v181 * c67) * c71)));
        const double v193 = (((0.631771669920152 * v15) * v36) - y[22 * i + 12]) + v40;
        const double v201 = squared((c2 * v193)) + (3.0 * squared((c50 * (v54 - y[22 * i + 20]))));
        const double v203 = sqrt(larger(v201, c63));
        const double v209 = v187 + (0.1559825412417957 * (v203 * (sinh(v203 * c67) * c71)));
        const double v215 = (((0.8977882908473036 * v15) * v36) - y[22 * i + 13]) + v40;
        const double v223 = squared((c2 * v215)) + (3.0 * squared((c50 * (v54 - y[22 * i + 21]))));
        const double v225 = sqrt(larger(v223, c63));
        const double v231 = v209 + (0.055346757660697604 * (v225 * (sinh(v225 * c67) * c71)));
        q[0] += (g[7 * i + 1] * v231) * c238;
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

static void work_slope_0(int n, const double *p, const double *g, const double *y, double *w, double *s)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c0 = p[5];
    const double c4 = (-0.5) * p[1];
    const double c10 = p[0];
    const double c11 = 1.0 / c10;
    const double c44 = 1e-12 * c0;
    const double c45 = squared(c44);
    const double c49 = 0.9 * c0;
    const double c51 = 2.0 * p[6];
    const double c52 = 2.0 + c51;
    const double c53 = c49 / c52;
    const double c72 = 1.0 / p[7];
    const double c76 = 1.0 / p[8];
    const double c79 = p[9];
    const double c81 = c10 / c79;
    const double c82 = squared(c81);
    const double c83 = p[2] * c82;
    const double c84 = c79 / c83;
    for (int i = 0; i < n - 1; i++) {
        const double v5 = w1[i + 1];
        const double v6 = w1[i];
        const double v9 = g[7 * i + 4];
        const double v12 = v9 * c11;
        const double v14 = c4 * ((v5 - v6) * v12);
        const double v19 = (w0[i + 1] - w0[i]) * v9;
        const double v23 = (v6 + v5) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w2[i + 1] - w2[i]) * v9;
        const double v30 = sin(v23);
        const double v32 = (v19 * v24) + (v29 * v30);
        const double v33 = sqrt(v32);
        const double v35 = 1.0 / (v33 * v32);
        const double v36 = ((-0.8977882908473036) * v14) * v35;
        const double v39 = log(v32);
        const double v41 = c0 * ((v36 - y[22 * i + 6]) + v39);
        const double v57 = 1.0 / v32;
        const double v58 = ((v29 * v24) - (v19 * v30)) * v57;
        const double v61 = c53 * (v58 - y[22 * i + 14]);
        const double v64 = squared(v41) + (3.0 * squared(v61));
        const double v65 = (double)(c45 <= v64);
        const double v70 = sqrt(larger(v64, c45));
        const double v73 = v70 * c72;
        const double v85 = g[7 * i + 1] * c84;
        const double v86 = 0.055346757660697604 * v85;
        const double v93 = ((sinh(v73) * c76) * v86) + ((cosh(v73) * ((v70 * v86) * c76)) * c72);
        const double v96 = (v65 / (v65 + (double)(v64 <= c45))) * (v93 / (2.0 * v70));
        const double v98 = c0 * ((2.0 * v41) * v96);
        const double v102 = ((-0.631771669920152) * v14) * v35;
        const double v106 = c0 * ((v102 - y[22 * i + 7]) + v39);
        const double v111 = c53 * (v58 - y[22 * i + 15]);
        const double v114 = squared(v106) + (3.0 * squared(v111));
        const double v115 = (double)(c45 <= v114);
        const double v120 = sqrt(larger(v114, c45));
        const double v121 = v120 * c72;
        const double v125 = 0.1559825412417957 * v85;
        const double v132 = ((sinh(v121) * c76) * v125) + ((cosh(v121) * ((v120 * v125) * c76)) * c72);
        const double v135 = (v115 / (v115 + (double)(v114 <= c45))) * (v132 / (2.0 * v120));
        const double v137 = c0 * ((2.0 * v106) * v135);
        const double v141 = ((-0.3092051869716723) * v14) * v35;
        const double v145 = c0 * ((v141 - y[22 * i + 8]) + v39);
        const double v150 = c53 * (v58 - y[22 * i + 16]);
        const double v153 = squared(v145) + (3.0 * squared(v150));
        const double v154 = (double)(c45 <= v153);
        const double v159 = sqrt(larger(v153, c45));
        const double v160 = v159 * c72;
        const double v164 = 0.18502795280105888 * v85;
        const double v171 = ((sinh(v160) * c76) * v164) + ((cosh(v160) * ((v159 * v164) * c76)) * c72);
        const double v174 = (v154 / (v154 + (double)(v153 <= c45))) * (v171 / (2.0 * v159));
        const double v176 = c0 * ((2.0 * v145) * v174);
        const double v180 = ((-0.0652237289787655) * v14) * v35;
        const double v184 = c0 * ((v180 - y[22 * i + 9]) + v39);
        const double v189 = c53 * (v58 - y[22 * i + 17]);
        const double v192 = squared(v184) + (3.0 * squared(v189));
        const double v193 = (double)(c45 <= v192);
        const double v198 = sqrt(larger(v192, c45));
        const double v199 = v198 * c72;
        const double v203 = 0.10364274829644775 * v85;
        const double v210 = ((sinh(v199) * c76) * v203) + ((cosh(v199) * ((v198 * v203) * c76)) * c72);
        const double v213 = (v193 / (v193 + (double)(v192 <= c45))) * (v210 / (2.0 * v198));
        const double v215 = c0 * ((2.0 * v184) * v213);
        const double v219 = (0.0652237289787655 * v14) * v35;
        const double v223 = c0 * ((v219 - y[22 * i + 10]) + v39);
        const double v228 = c53 * (v58 - y[22 * i + 18]);
        const double v231 = squared(v223) + (3.0 * squared(v228));
        const double v232 = (double)(c45 <= v231);
        const double v237 = sqrt(larger(v231, c45));
        const double v238 = v237 * c72;
        const double v247 = ((sinh(v238) * c76) * v203) + ((cosh(v238) * ((v237 * v203) * c76)) * c72);
        const double v250 = (v232 / (v232 + (double)(v231 <= c45))) * (v247 / (2.0 * v237));
        const double v252 = c0 * ((2.0 * v223) * v250);
        const double v256 = (0.3092051869716723 * v14) * v35;
        const double v260 = c0 * ((v256 - y[22 * i + 11]) + v39);
        const double v265 = c53 * (v58 - y[22 * i + 19]);
        const double v268 = squared(v260) + (3.0 * squared(v265));
        const double v269 = (double)(c45 <= v268);
        const double v274 = sqrt(larger(v268, c45));
        const double v275 = v274 * c72;
        const double v284 = ((sinh(v275) * c76) * v164) + ((cosh(v275) * ((v274 * v164) * c76)) * c72);
        const double v287 = (v269 / (v269 + (double)(v268 <= c45))) * (v284 / (2.0 * v274));
        const double v289 = c0 * ((2.0 * v260) * v287);
        const double v293 = (0.631771669920152 * v14) * v35;
        const double v297 = c0 * ((v293 - y[22 * i + 12]) + v39);
        const double v302 = c53 * (v58 - y[22 * i + 20]);
        const double v305 = squared(v297) + (3.0 * squared(v302));
        const double v306 = (double)(c45 <= v305);
        const double v311 = sqrt(larger(v305, c45));
        const double v312 = v311 * c72;
        const double v321 = ((sinh(v312) * c76) * v125) + ((cosh(v312) * ((v311 * v125) * c76)) * c72);
        const double v324 = (v306 / (v306 + (double)(v305 <= c45))) * (v321 / (2.0 * v311));
        const double v326 = c0 * ((2.0 * v297) * v324);
        const double v330 = (0.8977882908473036 * v14) * v35;
        const double v334 = c0 * ((v330 - y[22 * i + 13]) + v39);
        const double v339 = c53 * (v58 - y[22 * i + 21]);
        const double v342 = squared(v334) + (3.0 * squared(v339));
        const double v343 = (double)(c45 <= v342);
        const double v348 = sqrt(larger(v342, c45));
        const double v349 = v348 * c72;
        const double v358 = ((sinh(v349) * c76) * v86) + ((cosh(v349) * ((v348 * v86) * c76)) * c72);
        const double v361 = (v343 / (v343 + (double)(v342 <= c45))) * (v358 / (2.0 * v348));
        const double v363 = c0 * ((2.0 * v334) * v361);
        const double v366 = v58 * v57;
        const double v370 = c53 * ((2.0 * v339) * (3.0 * v361));
        const double v374 = (v330 * v35) * v363;
        const double v379 = 1.0 / (2.0 * v33);
        const double v381 = (((v363 * v57) - (v366 * v370)) - (v33 * v374)) - ((v32 * v374) * v379);
        const double v385 = c53 * ((2.0 * v302) * (3.0 * v324));
        const double v391 = (v293 * v35) * v326;
        const double v396 = (((v381 - (v366 * v385)) + (v326 * v57)) - (v33 * v391)) - ((v32 * v391) * v379);
        const double v400 = c53 * ((2.0 * v265) * (3.0 * v287));
        const double v406 = (v256 * v35) * v289;
        const double v411 = (((v396 - (v366 * v400)) + (v289 * v57)) - (v33 * v406)) - ((v32 * v406) * v379);
        const double v415 = c53 * ((2.0 * v228) * (3.0 * v250));
        const double v421 = (v219 * v35) * v252;
        const double v426 = (((v411 - (v366 * v415)) + (v252 * v57)) - (v33 * v421)) - ((v32 * v421) * v379);
        const double v430 = c53 * ((2.0 * v189) * (3.0 * v213));
        const double v436 = (v180 * v35) * v215;
        const double v441 = (((v426 - (v366 * v430)) + (v215 * v57)) - (v33 * v436)) - ((v32 * v436) * v379);
        const double v445 = c53 * ((2.0 * v150) * (3.0 * v174));
        const double v451 = (v141 * v35) * v176;
        const double v456 = (((v441 - (v366 * v445)) + (v176 * v57)) - (v33 * v451)) - ((v32 * v451) * v379);
        const double v460 = c53 * ((2.0 * v111) * (3.0 * v135));
        const double v466 = (v102 * v35) * v137;
        const double v471 = (((v456 - (v366 * v460)) + (v137 * v57)) - (v33 * v466)) - ((v32 * v466) * v379);
        const double v475 = c53 * ((2.0 * v61) * (3.0 * v96));
        const double v481 = (v36 * v35) * v98;
        const double v486 = (((v471 - (v366 * v475)) + (v98 * v57)) - (v33 * v481)) - ((v32 * v481) * v379);
        const double v494 = (((v370 * v57) + (v385 * v57)) + (v400 * v57)) + (v415 * v57);
        const double v502 = (((v494 + (v430 * v57)) + (v445 * v57)) + (v460 * v57)) + (v475 * v57);
        const double v510 = (v24 * ((v29 * v486) - (v19 * v502))) - (v30 * ((v29 * v502) + (v19 * v486)));
        const double v511 = 0.5 * v510;
        const double v518 = (c4 * (0.8977882908473036 * (v363 * v35))) + (c4 * (0.631771669920152 * (v326 * v35)));
        const double v526 = (v518 + (c4 * (0.3092051869716723 * (v289 * v35)))) + (c4 * (0.0652237289787655 * (v252 * v35)));
        const double v534 = (v526 + (c4 * ((-0.0652237289787655) * (v215 * v35)))) + (c4 * ((-0.3092051869716723) * (v176 * v35)));
        const double v542 = (v534 + (c4 * ((-0.631771669920152) * (v137 * v35)))) + (c4 * ((-0.8977882908473036) * (v98 * v35)));
        const double v543 = v12 * v542;
        const double v557 = ((v24 * v486) - (v30 * v502)) * v9;
        const double v562 = ((v24 * v502) + (v30 * v486)) * v9;
        s[22 * i + 6] += -v98;
        s[22 * i + 7] += -v137;
        s[22 * i + 8] += -v176;
        s[22 * i + 9] += -v215;
        s[22 * i + 10] += -v252;
        s[22 * i + 11] += -v289;
        s[22 * i + 12] += -v326;
        s[22 * i + 13] += -v363;
        s[22 * i + 4] += v511 - v543;
        s[22 * i + 26] += v511 + v543;
        s[22 * i + 14] += -v475;
        s[22 * i + 15] += -v460;
        s[22 * i + 16] += -v445;
        s[22 * i + 17] += -v430;
        s[22 * i + 18] += -v415;
        s[22 * i + 19] += -v400;
        s[22 * i + 20] += -v385;
        s[22 * i + 21] += -v370;
        s[22 * i] += -v557;
        s[22 * i + 22] += v557;
        s[22 * i + 1] += -v562;
        s[22 * i + 23] += v562;
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
        s[22 * n + 22 * i + 1] += g[7 * i + 3] * c27;
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 22; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, f);
    rates_2(n, y, w);
    rates_3(n, y, w);
    rates_4(n, w);
    rates_5(n, g, w);
    rates_6(n, p, g, y, w, f);
    rates_7(n, p, g, w, f);
    rates_8(n, t, p, g, w, f);
    rates_9(n, t, p, g, w, f);
    return SOFTCAT_SOLVED;
}

static int jacobian(const softcat_filament *filament, double t, const double *y, double *e,
                    double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 254; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, e);
    jacobian_2(n, y, w);
    jacobian_3(n, y, w);
    jacobian_4(n, w);
    jacobian_5(n, g, w);
    jacobian_6(n, p, g, y, w, e);
    jacobian_7(n, p, g, w, e);
    jacobian_8(n, p, g, w, e);
    jacobian_9(n, p, g, w, e);
    return SOFTCAT_SOLVED;
}

static int work(const softcat_filament *filament, double t, const double *y, double *q,
                double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, g, y, w, q);
    work_1(n, t, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 66; k++) s[k] = 0.0;
    work_slope_0(n, p, g, y, w, s);
    work_slope_1(n, t, p, g, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {2, 3, -1, -1, 5, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
static const int differential[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int held_first[] = {1, 0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
static const int held_last[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 9, 10, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 11, 11, 11, 11, 11, 12, 12, 12, 12, 12, 12, 12, 12, 13, 13, 13, 13, 13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15, 15, 15, 16, 16, 16, 16, 16, 16, 16, 16, 17, 17, 17, 17, 17, 17, 17, 17, 18, 18, 18, 18, 18, 18, 18, 18, 19, 19, 19, 19, 19, 19, 19, 19, 20, 20, 20, 20, 20, 20, 20, 20, 21, 21, 21, 21, 21, 21, 21, 21};
static const int offset[] = {0, 0, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 0, 1, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 0, 1, 4, 0, 1, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 0, 1, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 0, 1, 4, 5, 0, 1, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 0, 1, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 0, 1, 4, 0, 1, 4, 6, 14, 0, 1, 4, 0, 1, 4, 7, 15, 0, 1, 4, 0, 1, 4, 8, 16, 0, 1, 4, 0, 1, 4, 9, 17, 0, 1, 4, 0, 1, 4, 10, 18, 0, 1, 4, 0, 1, 4, 11, 19, 0, 1, 4, 0, 1, 4, 12, 20, 0, 1, 4, 0, 1, 4, 13, 21, 0, 1, 4, 0, 1, 4, 6, 14, 0, 1, 4, 0, 1, 4, 7, 15, 0, 1, 4, 0, 1, 4, 8, 16, 0, 1, 4, 0, 1, 4, 9, 17, 0, 1, 4, 0, 1, 4, 10, 18, 0, 1, 4, 0, 1, 4, 11, 19, 0, 1, 4, 0, 1, 4, 12, 20, 0, 1, 4, 0, 1, 4, 13, 21, 0, 1, 4};

const softcat_model softcat_filament_model = {
    22, 16, 10, 7, 87, 254, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "ramp", "youngs_modulus", "poisson", "s0",
    "t0", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "s", "Pa", "1", "Pa", "s", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_ANY, SOFTCAT_ANY,
    SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.04, 0.003, 1100.0, 9.81, 0.05, 60000.0, 0.45, 500.0, 60.0, 0.06385508568141009};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "omega", "axial_0", "axial_1", "axial_2", "axial_3", "axial_4",
    "axial_5", "axial_6", "axial_7", "shear_0", "shear_1", "shear_2", "shear_3", "shear_4",
    "shear_5", "shear_6", "shear_7"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, (-0.8977882908473036), (-0.631771669920152),
    (-0.3092051869716723), (-0.0652237289787655), 0.0652237289787655, 0.3092051869716723,
    0.631771669920152, 0.8977882908473036, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Transient gel that flows by Eyring's law",
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
    .duration = 2.0,
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
