/*
 * Oobleck: a cornstarch strand that thickens as it flows
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, shear, fibres, rotary-inertia
 * Digest of the structure: 68635df22d05ee93b1203e960e6fe0f95594d5b46ba179d20f980239535d7b94
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
    const double c1 = p[4];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c116 = 0.9 * c1;
    const double c118 = 2.0 * p[5];
    const double c119 = 2.0 + c118;
    const double c120 = c116 / c119;
    const double c166 = 0.5 * c4;
    const double c214 = 1e-12 * c1;
    const double c215 = squared(c214);
    const double c217 = p[6];
    const double c218 = squared(c217);
    const double c219 = 1.0 / c218;
    const double c222 = squared(c1);
    const double c223 = 1e-18 * c222;
    const double c224 = c223 / c218;
    const double c227 = 0.5 / p[7];
    const double c228 = (-0.5) + c227;
    const double c230 = 1.0 / c217;
    const double c233 = p[8];
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
        const double v225 = (larger(squared(v42) + (3.0 * squared(v124)), c215) * c219) + c224;
        const double v231 = pow(v225, c228) * c230;
        const double v241 = (larger(squared(v51) + (3.0 * squared(v128)), c215) * c219) + c224;
        const double v243 = pow(v241, c228) * c230;
        const double v252 = (larger(squared(v61) + (3.0 * squared(v133)), c215) * c219) + c224;
        const double v254 = pow(v252, c228) * c230;
        const double v263 = (larger(squared(v71) + (3.0 * squared(v138)), c215) * c219) + c224;
        const double v265 = pow(v263, c228) * c230;
        const double v274 = (larger(squared(v80) + (3.0 * squared(v143)), c215) * c219) + c224;
        const double v276 = pow(v274, c228) * c230;
        const double v285 = (larger(squared(v89) + (3.0 * squared(v148)), c215) * c219) + c224;
        const double v287 = pow(v285, c228) * c230;
        const double v296 = (larger(squared(v98) + (3.0 * squared(v153)), c215) * c219) + c224;
        const double v298 = pow(v296, c228) * c230;
        const double v306 = larger(squared(v107) + (3.0 * squared(v158)), c215) * c219;
        const double v309 = pow(v306 + c224, c228) * c230;
        w3[i] = (v195 * v25) - (v161 * v31);
        w4[i] = (v195 * v31) + (v161 * v25);
        w5[i] = ((g[7 * i + 1] * c11) * (v160 - (v114 * v195))) * 0.5;
        w6[i] = -v191;
        f[22 * i + 6] = (v42 * v231) * c233;
        f[22 * i + 7] = (v51 * v243) * c233;
        f[22 * i + 8] = (v61 * v254) * c233;
        f[22 * i + 9] = (v71 * v265) * c233;
        f[22 * i + 10] = (v80 * v276) * c233;
        f[22 * i + 11] = (v89 * v287) * c233;
        f[22 * i + 12] = (v98 * v298) * c233;
        f[22 * i + 13] = (v107 * v309) * c233;
        f[22 * i + 14] = ((3.0 * v124) * v231) * c233;
        f[22 * i + 15] = ((3.0 * v128) * v243) * c233;
        f[22 * i + 16] = ((3.0 * v133) * v254) * c233;
        f[22 * i + 17] = ((3.0 * v138) * v265) * c233;
        f[22 * i + 18] = ((3.0 * v143) * v276) * c233;
        f[22 * i + 19] = ((3.0 * v148) * v287) * c233;
        f[22 * i + 20] = ((3.0 * v153) * v298) * c233;
        f[22 * i + 21] = ((3.0 * v158) * v309) * c233;
    }
}

static void rates_7(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    const double c4 = squared(p[8]);
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

static void rates_8(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w4 = w + 4 * n;
    const double c4 = squared(p[8]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    const double c15 = p[3] * c6;
    for (int i = 1; i < n - 1; i++) {
        f[22 * i + 3] = ((w4[i] - w4[i - 1]) * (c9 * g[7 * i + 6])) - c15;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w4 = w + 4 * n;
    const double c2 = squared(p[8]);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c6 = p[2] * c3;
    const double c7 = c4 / c6;
    const double c13 = p[3] * c4;
    const int i = 0;
    f[22 * i + 3] = (w4[i] * (c7 * g[7 * i + 6])) - c13;
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
    const double c1 = p[4];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c116 = 0.9 * c1;
    const double c118 = 2.0 * p[5];
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
    const double c1013 = p[8];
    const double c1020 = 1e-12 * c1;
    const double c1021 = squared(c1020);
    const double c1023 = p[6];
    const double c1024 = squared(c1023);
    const double c1025 = 1.0 / c1024;
    const double c1028 = squared(c1);
    const double c1029 = 1e-18 * c1028;
    const double c1030 = c1029 / c1024;
    const double c1033 = 0.5 / p[7];
    const double c1034 = (-0.5) + c1033;
    const double c1036 = 1.0 / c1023;
    const double c1040 = c1034 - 1.0;
    const double c1875 = 3.0 * c120;
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
        const double v1031 = (larger(v1018, c1021) * c1025) + c1030;
        const double v1037 = pow(v1031, c1034) * c1036;
        const double v1042 = c1034 * pow(v1031, c1040);
        const double v1043 = (double)(c1021 <= v1018);
        const double v1046 = v1043 / (v1043 + (double)(v1018 <= c1021));
        const double v1047 = 2.0 * v42;
        const double v1052 = (v1042 * ((v1046 * (v1047 * c1)) * c1025)) * c1036;
        const double v1059 = 2.0 * v124;
        const double v1061 = 3.0 * (v1059 * v375);
        const double v1066 = (v1042 * ((v1046 * ((v1047 * v298) - v1061)) * c1025)) * c1036;
        const double v1076 = (v1042 * ((v1046 * ((v1047 * v436) - v1061)) * c1025)) * c1036;
        const double v1085 = (v1042 * ((v1046 * (3.0 * (v1059 * c120))) * c1025)) * c1036;
        const double v1092 = 3.0 * (v1059 * v584);
        const double v1097 = (v1042 * ((v1046 * ((v1047 * v539) + v1092)) * c1025)) * c1036;
        const double v1107 = (v1042 * ((v1046 * ((v1047 * v634) - v1092)) * c1025)) * c1036;
        const double v1117 = (v1046 * ((v1047 * v698) + (3.0 * (v1059 * v740)))) * c1025;
        const double v1119 = (v1042 * v1117) * c1036;
        const double v1129 = (v1046 * ((v1047 * v791) + (3.0 * (v1059 * v824)))) * c1025;
        const double v1131 = (v1042 * v1129) * c1036;
        const double v1138 = squared(v51) + (3.0 * squared(v128));
        const double v1141 = (larger(v1138, c1021) * c1025) + c1030;
        const double v1143 = pow(v1141, c1034) * c1036;
        const double v1146 = c1034 * pow(v1141, c1040);
        const double v1147 = (double)(c1021 <= v1138);
        const double v1150 = v1147 / (v1147 + (double)(v1138 <= c1021));
        const double v1151 = 2.0 * v51;
        const double v1156 = (v1146 * ((v1150 * (v1151 * c1)) * c1025)) * c1036;
        const double v1163 = 2.0 * v128;
        const double v1165 = 3.0 * (v1163 * v375);
        const double v1170 = (v1146 * ((v1150 * ((v1151 * v306) - v1165)) * c1025)) * c1036;
        const double v1180 = (v1146 * ((v1150 * ((v1151 * v440) - v1165)) * c1025)) * c1036;
        const double v1189 = (v1146 * ((v1150 * (3.0 * (v1163 * c120))) * c1025)) * c1036;
        const double v1196 = 3.0 * (v1163 * v584);
        const double v1201 = (v1146 * ((v1150 * ((v1151 * v543) + v1196)) * c1025)) * c1036;
        const double v1211 = (v1146 * ((v1150 * ((v1151 * v637) - v1196)) * c1025)) * c1036;
        const double v1221 = (v1150 * ((v1151 * v702) + (3.0 * (v1163 * v740)))) * c1025;
        const double v1223 = (v1146 * v1221) * c1036;
        const double v1233 = (v1150 * ((v1151 * v794) + (3.0 * (v1163 * v824)))) * c1025;
        const double v1235 = (v1146 * v1233) * c1036;
        const double v1242 = squared(v61) + (3.0 * squared(v133));
        const double v1245 = (larger(v1242, c1021) * c1025) + c1030;
        const double v1247 = pow(v1245, c1034) * c1036;
        const double v1250 = c1034 * pow(v1245, c1040);
        const double v1251 = (double)(c1021 <= v1242);
        const double v1254 = v1251 / (v1251 + (double)(v1242 <= c1021));
        const double v1255 = 2.0 * v61;
        const double v1260 = (v1250 * ((v1254 * (v1255 * c1)) * c1025)) * c1036;
        const double v1267 = 2.0 * v133;
        const double v1269 = 3.0 * (v1267 * v375);
        const double v1274 = (v1250 * ((v1254 * ((v1255 * v315) - v1269)) * c1025)) * c1036;
        const double v1284 = (v1250 * ((v1254 * ((v1255 * v445) - v1269)) * c1025)) * c1036;
        const double v1293 = (v1250 * ((v1254 * (3.0 * (v1267 * c120))) * c1025)) * c1036;
        const double v1300 = 3.0 * (v1267 * v584);
        const double v1305 = (v1250 * ((v1254 * ((v1255 * v548) + v1300)) * c1025)) * c1036;
        const double v1315 = (v1250 * ((v1254 * ((v1255 * v641) - v1300)) * c1025)) * c1036;
        const double v1325 = (v1254 * ((v1255 * v707) + (3.0 * (v1267 * v740)))) * c1025;
        const double v1327 = (v1250 * v1325) * c1036;
        const double v1337 = (v1254 * ((v1255 * v798) + (3.0 * (v1267 * v824)))) * c1025;
        const double v1339 = (v1250 * v1337) * c1036;
        const double v1346 = squared(v71) + (3.0 * squared(v138));
        const double v1349 = (larger(v1346, c1021) * c1025) + c1030;
        const double v1351 = pow(v1349, c1034) * c1036;
        const double v1354 = c1034 * pow(v1349, c1040);
        const double v1355 = (double)(c1021 <= v1346);
        const double v1358 = v1355 / (v1355 + (double)(v1346 <= c1021));
        const double v1359 = 2.0 * v71;
        const double v1364 = (v1354 * ((v1358 * (v1359 * c1)) * c1025)) * c1036;
        const double v1371 = 2.0 * v138;
        const double v1373 = 3.0 * (v1371 * v375);
        const double v1378 = (v1354 * ((v1358 * ((v1359 * v324) - v1373)) * c1025)) * c1036;
        const double v1388 = (v1354 * ((v1358 * ((v1359 * v450) - v1373)) * c1025)) * c1036;
        const double v1397 = (v1354 * ((v1358 * (3.0 * (v1371 * c120))) * c1025)) * c1036;
        const double v1404 = 3.0 * (v1371 * v584);
        const double v1409 = (v1354 * ((v1358 * ((v1359 * v553) + v1404)) * c1025)) * c1036;
        const double v1419 = (v1354 * ((v1358 * ((v1359 * v645) - v1404)) * c1025)) * c1036;
        const double v1429 = (v1358 * ((v1359 * v712) + (3.0 * (v1371 * v740)))) * c1025;
        const double v1431 = (v1354 * v1429) * c1036;
        const double v1441 = (v1358 * ((v1359 * v802) + (3.0 * (v1371 * v824)))) * c1025;
        const double v1443 = (v1354 * v1441) * c1036;
        const double v1450 = squared(v80) + (3.0 * squared(v143));
        const double v1453 = (larger(v1450, c1021) * c1025) + c1030;
        const double v1455 = pow(v1453, c1034) * c1036;
        const double v1458 = c1034 * pow(v1453, c1040);
        const double v1459 = (double)(c1021 <= v1450);
        const double v1462 = v1459 / (v1459 + (double)(v1450 <= c1021));
        const double v1463 = 2.0 * v80;
        const double v1468 = (v1458 * ((v1462 * (v1463 * c1)) * c1025)) * c1036;
        const double v1475 = 2.0 * v143;
        const double v1477 = 3.0 * (v1475 * v375);
        const double v1482 = (v1458 * ((v1462 * ((v1463 * v333) - v1477)) * c1025)) * c1036;
        const double v1492 = (v1458 * ((v1462 * ((v1463 * v455) - v1477)) * c1025)) * c1036;
        const double v1501 = (v1458 * ((v1462 * (3.0 * (v1475 * c120))) * c1025)) * c1036;
        const double v1508 = 3.0 * (v1475 * v584);
        const double v1513 = (v1458 * ((v1462 * ((v1463 * v558) + v1508)) * c1025)) * c1036;
        const double v1523 = (v1458 * ((v1462 * ((v1463 * v649) - v1508)) * c1025)) * c1036;
        const double v1533 = (v1462 * ((v1463 * v717) + (3.0 * (v1475 * v740)))) * c1025;
        const double v1535 = (v1458 * v1533) * c1036;
        const double v1545 = (v1462 * ((v1463 * v806) + (3.0 * (v1475 * v824)))) * c1025;
        const double v1547 = (v1458 * v1545) * c1036;
        const double v1554 = squared(v89) + (3.0 * squared(v148));
        const double v1557 = (larger(v1554, c1021) * c1025) + c1030;
        const double v1559 = pow(v1557, c1034) * c1036;
        const double v1562 = c1034 * pow(v1557, c1040);
        const double v1563 = (double)(c1021 <= v1554);
        const double v1566 = v1563 / (v1563 + (double)(v1554 <= c1021));
        const double v1567 = 2.0 * v89;
        const double v1572 = (v1562 * ((v1566 * (v1567 * c1)) * c1025)) * c1036;
        const double v1579 = 2.0 * v148;
        const double v1581 = 3.0 * (v1579 * v375);
        const double v1586 = (v1562 * ((v1566 * ((v1567 * v342) - v1581)) * c1025)) * c1036;
        const double v1596 = (v1562 * ((v1566 * ((v1567 * v460) - v1581)) * c1025)) * c1036;
        const double v1605 = (v1562 * ((v1566 * (3.0 * (v1579 * c120))) * c1025)) * c1036;
        const double v1612 = 3.0 * (v1579 * v584);
        const double v1617 = (v1562 * ((v1566 * ((v1567 * v563) + v1612)) * c1025)) * c1036;
        const double v1627 = (v1562 * ((v1566 * ((v1567 * v653) - v1612)) * c1025)) * c1036;
        const double v1637 = (v1566 * ((v1567 * v722) + (3.0 * (v1579 * v740)))) * c1025;
        const double v1639 = (v1562 * v1637) * c1036;
        const double v1649 = (v1566 * ((v1567 * v810) + (3.0 * (v1579 * v824)))) * c1025;
        const double v1651 = (v1562 * v1649) * c1036;
        const double v1658 = squared(v98) + (3.0 * squared(v153));
        const double v1661 = (larger(v1658, c1021) * c1025) + c1030;
        const double v1663 = pow(v1661, c1034) * c1036;
        const double v1666 = c1034 * pow(v1661, c1040);
        const double v1667 = (double)(c1021 <= v1658);
        const double v1670 = v1667 / (v1667 + (double)(v1658 <= c1021));
        const double v1671 = 2.0 * v98;
        const double v1676 = (v1666 * ((v1670 * (v1671 * c1)) * c1025)) * c1036;
        const double v1683 = 2.0 * v153;
        const double v1685 = 3.0 * (v1683 * v375);
        const double v1690 = (v1666 * ((v1670 * ((v1671 * v351) - v1685)) * c1025)) * c1036;
        const double v1700 = (v1666 * ((v1670 * ((v1671 * v465) - v1685)) * c1025)) * c1036;
        const double v1709 = (v1666 * ((v1670 * (3.0 * (v1683 * c120))) * c1025)) * c1036;
        const double v1716 = 3.0 * (v1683 * v584);
        const double v1721 = (v1666 * ((v1670 * ((v1671 * v568) + v1716)) * c1025)) * c1036;
        const double v1731 = (v1666 * ((v1670 * ((v1671 * v657) - v1716)) * c1025)) * c1036;
        const double v1741 = (v1670 * ((v1671 * v727) + (3.0 * (v1683 * v740)))) * c1025;
        const double v1743 = (v1666 * v1741) * c1036;
        const double v1753 = (v1670 * ((v1671 * v814) + (3.0 * (v1683 * v824)))) * c1025;
        const double v1755 = (v1666 * v1753) * c1036;
        const double v1762 = squared(v107) + (3.0 * squared(v158));
        const double v1765 = (larger(v1762, c1021) * c1025) + c1030;
        const double v1767 = pow(v1765, c1034) * c1036;
        const double v1770 = c1034 * pow(v1765, c1040);
        const double v1771 = (double)(c1021 <= v1762);
        const double v1774 = v1771 / (v1771 + (double)(v1762 <= c1021));
        const double v1775 = 2.0 * v107;
        const double v1780 = (v1770 * ((v1774 * (v1775 * c1)) * c1025)) * c1036;
        const double v1787 = 2.0 * v158;
        const double v1789 = 3.0 * (v1787 * v375);
        const double v1794 = (v1770 * ((v1774 * ((v1775 * v360) - v1789)) * c1025)) * c1036;
        const double v1804 = (v1770 * ((v1774 * ((v1775 * v470) - v1789)) * c1025)) * c1036;
        const double v1813 = (v1770 * ((v1774 * (3.0 * (v1787 * c120))) * c1025)) * c1036;
        const double v1820 = 3.0 * (v1787 * v584);
        const double v1825 = (v1770 * ((v1774 * ((v1775 * v573) + v1820)) * c1025)) * c1036;
        const double v1835 = (v1770 * ((v1774 * ((v1775 * v661) - v1820)) * c1025)) * c1036;
        const double v1845 = (v1774 * ((v1775 * v732) + (3.0 * (v1787 * v740)))) * c1025;
        const double v1847 = (v1770 * v1845) * c1036;
        const double v1857 = (v1774 * ((v1775 * v818) + (3.0 * (v1787 * v824)))) * c1025;
        const double v1859 = (v1770 * v1857) * c1036;
        const double v1863 = 3.0 * v124;
        const double v1868 = 3.0 * v375;
        const double v1869 = v1037 * v1868;
        const double v1881 = 3.0 * v584;
        const double v1882 = v1037 * v1881;
        const double v1889 = 3.0 * v740;
        const double v1894 = 3.0 * v824;
        const double v1899 = 3.0 * v128;
        const double v1904 = v1143 * v1868;
        const double v1915 = v1143 * v1881;
        const double v1930 = 3.0 * v133;
        const double v1935 = v1247 * v1868;
        const double v1946 = v1247 * v1881;
        const double v1961 = 3.0 * v138;
        const double v1966 = v1351 * v1868;
        const double v1977 = v1351 * v1881;
        const double v1992 = 3.0 * v143;
        const double v1997 = v1455 * v1868;
        const double v2008 = v1455 * v1881;
        const double v2023 = 3.0 * v148;
        const double v2028 = v1559 * v1868;
        const double v2039 = v1559 * v1881;
        const double v2054 = 3.0 * v153;
        const double v2059 = v1663 * v1868;
        const double v2070 = v1663 * v1881;
        const double v2085 = 3.0 * v158;
        const double v2090 = v1767 * v1868;
        const double v2101 = v1767 * v1881;
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
        e[254 * i + 129] = -(c1013 * ((v1037 * c1) + (v42 * v1052)));
        e[254 * i + 128] = c1013 * ((v1037 * v298) + (v42 * v1066));
        e[254 * i + 133] = c1013 * ((v1037 * v436) + (v42 * v1076));
        e[254 * i + 130] = -(c1013 * (v42 * v1085));
        e[254 * i + 126] = c1013 * ((v1037 * v539) + (v42 * v1097));
        e[254 * i + 131] = c1013 * ((v1037 * v634) + (v42 * v1107));
        e[254 * i + 127] = c1013 * ((v1037 * v698) + (v42 * v1119));
        e[254 * i + 132] = c1013 * ((v1037 * v791) + (v42 * v1131));
        e[254 * i + 137] = -(c1013 * ((v1143 * c1) + (v51 * v1156)));
        e[254 * i + 136] = c1013 * ((v1143 * v306) + (v51 * v1170));
        e[254 * i + 141] = c1013 * ((v1143 * v440) + (v51 * v1180));
        e[254 * i + 138] = -(c1013 * (v51 * v1189));
        e[254 * i + 134] = c1013 * ((v1143 * v543) + (v51 * v1201));
        e[254 * i + 139] = c1013 * ((v1143 * v637) + (v51 * v1211));
        e[254 * i + 135] = c1013 * ((v1143 * v702) + (v51 * v1223));
        e[254 * i + 140] = c1013 * ((v1143 * v794) + (v51 * v1235));
        e[254 * i + 145] = -(c1013 * ((v1247 * c1) + (v61 * v1260)));
        e[254 * i + 144] = c1013 * ((v1247 * v315) + (v61 * v1274));
        e[254 * i + 149] = c1013 * ((v1247 * v445) + (v61 * v1284));
        e[254 * i + 146] = -(c1013 * (v61 * v1293));
        e[254 * i + 142] = c1013 * ((v1247 * v548) + (v61 * v1305));
        e[254 * i + 147] = c1013 * ((v1247 * v641) + (v61 * v1315));
        e[254 * i + 143] = c1013 * ((v1247 * v707) + (v61 * v1327));
        e[254 * i + 148] = c1013 * ((v1247 * v798) + (v61 * v1339));
        e[254 * i + 153] = -(c1013 * ((v1351 * c1) + (v71 * v1364)));
        e[254 * i + 152] = c1013 * ((v1351 * v324) + (v71 * v1378));
        e[254 * i + 157] = c1013 * ((v1351 * v450) + (v71 * v1388));
        e[254 * i + 154] = -(c1013 * (v71 * v1397));
        e[254 * i + 150] = c1013 * ((v1351 * v553) + (v71 * v1409));
        e[254 * i + 155] = c1013 * ((v1351 * v645) + (v71 * v1419));
        e[254 * i + 151] = c1013 * ((v1351 * v712) + (v71 * v1431));
        e[254 * i + 156] = c1013 * ((v1351 * v802) + (v71 * v1443));
        e[254 * i + 161] = -(c1013 * ((v1455 * c1) + (v80 * v1468)));
        e[254 * i + 160] = c1013 * ((v1455 * v333) + (v80 * v1482));
        e[254 * i + 165] = c1013 * ((v1455 * v455) + (v80 * v1492));
        e[254 * i + 162] = -(c1013 * (v80 * v1501));
        e[254 * i + 158] = c1013 * ((v1455 * v558) + (v80 * v1513));
        e[254 * i + 163] = c1013 * ((v1455 * v649) + (v80 * v1523));
        e[254 * i + 159] = c1013 * ((v1455 * v717) + (v80 * v1535));
        e[254 * i + 164] = c1013 * ((v1455 * v806) + (v80 * v1547));
        e[254 * i + 169] = -(c1013 * ((v1559 * c1) + (v89 * v1572)));
        e[254 * i + 168] = c1013 * ((v1559 * v342) + (v89 * v1586));
        e[254 * i + 173] = c1013 * ((v1559 * v460) + (v89 * v1596));
        e[254 * i + 170] = -(c1013 * (v89 * v1605));
        e[254 * i + 166] = c1013 * ((v1559 * v563) + (v89 * v1617));
        e[254 * i + 171] = c1013 * ((v1559 * v653) + (v89 * v1627));
        e[254 * i + 167] = c1013 * ((v1559 * v722) + (v89 * v1639));
        e[254 * i + 172] = c1013 * ((v1559 * v810) + (v89 * v1651));
        e[254 * i + 177] = -(c1013 * ((v1663 * c1) + (v98 * v1676)));
        e[254 * i + 176] = c1013 * ((v1663 * v351) + (v98 * v1690));
        e[254 * i + 181] = c1013 * ((v1663 * v465) + (v98 * v1700));
        e[254 * i + 178] = -(c1013 * (v98 * v1709));
        e[254 * i + 174] = c1013 * ((v1663 * v568) + (v98 * v1721));
        e[254 * i + 179] = c1013 * ((v1663 * v657) + (v98 * v1731));
        e[254 * i + 175] = c1013 * ((v1663 * v727) + (v98 * v1743));
        e[254 * i + 180] = c1013 * ((v1663 * v814) + (v98 * v1755));
        e[254 * i + 185] = -(c1013 * ((v1767 * c1) + (v107 * v1780)));
        e[254 * i + 184] = c1013 * ((v1767 * v360) + (v107 * v1794));
        e[254 * i + 189] = c1013 * ((v1767 * v470) + (v107 * v1804));
        e[254 * i + 186] = -(c1013 * (v107 * v1813));
        e[254 * i + 182] = c1013 * ((v1767 * v573) + (v107 * v1825));
        e[254 * i + 187] = c1013 * ((v1767 * v661) + (v107 * v1835));
        e[254 * i + 183] = c1013 * ((v1767 * v732) + (v107 * v1847));
        e[254 * i + 188] = c1013 * ((v1767 * v818) + (v107 * v1859));
        e[254 * i + 193] = -(c1013 * (v1863 * v1052));
        e[254 * i + 192] = c1013 * ((v1863 * v1066) - v1869);
        e[254 * i + 197] = c1013 * ((v1863 * v1076) - v1869);
        e[254 * i + 194] = -(c1013 * ((v1037 * c1875) + (v1863 * v1085)));
        e[254 * i + 190] = c1013 * (v1882 + (v1863 * v1097));
        e[254 * i + 195] = c1013 * ((v1863 * v1107) - v1882);
        e[254 * i + 191] = c1013 * ((v1037 * v1889) + (v1863 * v1119));
        e[254 * i + 196] = c1013 * ((v1037 * v1894) + (v1863 * v1131));
        e[254 * i + 201] = -(c1013 * (v1899 * v1156));
        e[254 * i + 200] = c1013 * ((v1899 * v1170) - v1904);
        e[254 * i + 205] = c1013 * ((v1899 * v1180) - v1904);
        e[254 * i + 202] = -(c1013 * ((v1143 * c1875) + (v1899 * v1189)));
        e[254 * i + 198] = c1013 * (v1915 + (v1899 * v1201));
        e[254 * i + 203] = c1013 * ((v1899 * v1211) - v1915);
        e[254 * i + 199] = c1013 * ((v1143 * v1889) + (v1899 * v1223));
        e[254 * i + 204] = c1013 * ((v1143 * v1894) + (v1899 * v1235));
        e[254 * i + 209] = -(c1013 * (v1930 * v1260));
        e[254 * i + 208] = c1013 * ((v1930 * v1274) - v1935);
        e[254 * i + 213] = c1013 * ((v1930 * v1284) - v1935);
        e[254 * i + 210] = -(c1013 * ((v1247 * c1875) + (v1930 * v1293)));
        e[254 * i + 206] = c1013 * (v1946 + (v1930 * v1305));
        e[254 * i + 211] = c1013 * ((v1930 * v1315) - v1946);
        e[254 * i + 207] = c1013 * ((v1247 * v1889) + (v1930 * v1327));
        e[254 * i + 212] = c1013 * ((v1247 * v1894) + (v1930 * v1339));
        e[254 * i + 217] = -(c1013 * (v1961 * v1364));
        e[254 * i + 216] = c1013 * ((v1961 * v1378) - v1966);
        e[254 * i + 221] = c1013 * ((v1961 * v1388) - v1966);
        e[254 * i + 218] = -(c1013 * ((v1351 * c1875) + (v1961 * v1397)));
        e[254 * i + 214] = c1013 * (v1977 + (v1961 * v1409));
        e[254 * i + 219] = c1013 * ((v1961 * v1419) - v1977);
        e[254 * i + 215] = c1013 * ((v1351 * v1889) + (v1961 * v1431));
        e[254 * i + 220] = c1013 * ((v1351 * v1894) + (v1961 * v1443));
        e[254 * i + 225] = -(c1013 * (v1992 * v1468));
        e[254 * i + 224] = c1013 * ((v1992 * v1482) - v1997);
        e[254 * i + 229] = c1013 * ((v1992 * v1492) - v1997);
        e[254 * i + 226] = -(c1013 * ((v1455 * c1875) + (v1992 * v1501)));
        e[254 * i + 222] = c1013 * (v2008 + (v1992 * v1513));
        e[254 * i + 227] = c1013 * ((v1992 * v1523) - v2008);
        e[254 * i + 223] = c1013 * ((v1455 * v1889) + (v1992 * v1535));
        e[254 * i + 228] = c1013 * ((v1455 * v1894) + (v1992 * v1547));
        e[254 * i + 233] = -(c1013 * (v2023 * v1572));
        e[254 * i + 232] = c1013 * ((v2023 * v1586) - v2028);
        e[254 * i + 237] = c1013 * ((v2023 * v1596) - v2028);
        e[254 * i + 234] = -(c1013 * ((v1559 * c1875) + (v2023 * v1605)));
        e[254 * i + 230] = c1013 * (v2039 + (v2023 * v1617));
        e[254 * i + 235] = c1013 * ((v2023 * v1627) - v2039);
        e[254 * i + 231] = c1013 * ((v1559 * v1889) + (v2023 * v1639));
        e[254 * i + 236] = c1013 * ((v1559 * v1894) + (v2023 * v1651));
        e[254 * i + 241] = -(c1013 * (v2054 * v1676));
        e[254 * i + 240] = c1013 * ((v2054 * v1690) - v2059);
        e[254 * i + 245] = c1013 * ((v2054 * v1700) - v2059);
        e[254 * i + 242] = -(c1013 * ((v1663 * c1875) + (v2054 * v1709)));
        e[254 * i + 238] = c1013 * (v2070 + (v2054 * v1721));
        e[254 * i + 243] = c1013 * ((v2054 * v1731) - v2070);
        e[254 * i + 239] = c1013 * ((v1663 * v1889) + (v2054 * v1743));
        e[254 * i + 244] = c1013 * ((v1663 * v1894) + (v2054 * v1755));
        e[254 * i + 249] = -(c1013 * (v2085 * v1780));
        e[254 * i + 248] = c1013 * ((v2085 * v1794) - v2090);
        e[254 * i + 253] = c1013 * ((v2085 * v1804) - v2090);
        e[254 * i + 250] = -(c1013 * ((v1767 * c1875) + (v2085 * v1813)));
        e[254 * i + 246] = c1013 * (v2101 + (v2085 * v1825));
        e[254 * i + 251] = c1013 * ((v2085 * v1835) - v2101);
        e[254 * i + 247] = c1013 * ((v1767 * v1889) + (v2085 * v1847));
        e[254 * i + 252] = c1013 * ((v1767 * v1894) + (v2085 * v1859));
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
    const double c1 = squared(p[8]);
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
    const double c1 = squared(p[8]);
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
    const double c1 = squared(p[8]);
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
    const double c2 = p[4];
    const double c6 = (-0.5) * p[1];
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c46 = 0.9 * c2;
    const double c48 = 2.0 * p[5];
    const double c49 = 2.0 + c48;
    const double c50 = c46 / c49;
    const double c62 = 1e-12 * c2;
    const double c63 = squared(c62);
    const double c65 = p[6];
    const double c66 = squared(c65);
    const double c67 = 1.0 / c66;
    const double c70 = squared(c2);
    const double c71 = 1e-18 * c70;
    const double c72 = c71 / c66;
    const double c75 = 0.5 / p[7];
    const double c76 = (-0.5) + c75;
    const double c78 = 1.0 / c65;
    const double c240 = p[8];
    const double c242 = c11 / c240;
    const double c243 = squared(c242);
    const double c244 = p[2] * c243;
    const double c245 = c240 / c244;
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
        const double v64 = larger(v60, c63);
        const double v81 = 0.055346757660697604 * (v64 * (pow((v64 * c67) + c72, c76) * c78));
        const double v88 = ((((-0.631771669920152) * v15) * v36) - y[22 * i + 7]) + v40;
        const double v96 = squared((c2 * v88)) + (3.0 * squared((c50 * (v54 - y[22 * i + 15]))));
        const double v97 = larger(v96, c63);
        const double v103 = 0.1559825412417957 * (v97 * (pow((v97 * c67) + c72, c76) * c78));
        const double v111 = ((((-0.3092051869716723) * v15) * v36) - y[22 * i + 8]) + v40;
        const double v119 = squared((c2 * v111)) + (3.0 * squared((c50 * (v54 - y[22 * i + 16]))));
        const double v120 = larger(v119, c63);
        const double v126 = 0.18502795280105888 * (v120 * (pow((v120 * c67) + c72, c76) * c78));
        const double v134 = ((((-0.0652237289787655) * v15) * v36) - y[22 * i + 9]) + v40;
        const double v142 = squared((c2 * v134)) + (3.0 * squared((c50 * (v54 - y[22 * i + 17]))));
        const double v143 = larger(v142, c63);
        const double v149 = 0.10364274829644775 * (v143 * (pow((v143 * c67) + c72, c76) * c78));
        const double v156 = (((0.0652237289787655 * v15) * v36) - y[22 * i + 10]) + v40;
        const double v164 = squared((c2 * v156)) + (3.0 * squared((c50 * (v54 - y[22 * i + 18]))));
        const double v165 = larger(v164, c63);
        const double v171 = 0.10364274829644775 * (v165 * (pow((v165 * c67) + c72, c76) * c78));
        const double v178 = (((0.3092051869716723 * v15) * v36) - y[22 * i + 11]) + v40;
        const double v186 = squared((c2 * v178)) + (3.0 * squared((c50 * (v54 - y[22 * i + 19]))));
        const double v187 = larger(v186, c63);
        const double v193 = 0.18502795280105888 * (v187 * (pow((v187 * c67) + c72, c76) * c78));
        const double v200 = (((0.631771669920152 * v15) * v36) - y[22 * i + 12]) + v40;
        const double v208 = squared((c2 * v200)) + (3.0 * squared((c50 * (v54 - y[22 * i + 20]))));
        const double v209 = larger(v208, c63);
        const double v215 = 0.1559825412417957 * (v209 * (pow((v209 * c67) + c72, c76) * c78));
        const double v222 = (((0.8977882908473036 * v15) * v36) - y[22 * i + 13]) + v40;
        const double v230 = squared((c2 * v222)) + (3.0 * squared((c50 * (v54 - y[22 * i + 21]))));
        const double v231 = larger(v230, c63);
        const double v237 = 0.055346757660697604 * (v231 * (pow((v231 * c67) + c72, c76) * c78));
        const double v238 = ((((((v81 + v103) + v126) + v149) + v171) + v193) + v215) + v237;
        q[0] += (g[7 * i + 1] * v238) * c245;
    }
}

static void work_slope_0(int n, const double *p, const double *g, const double *y, double *w, double *s)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c0 = p[4];
    const double c4 = (-0.5) * p[1];
    const double c10 = p[0];
    const double c11 = 1.0 / c10;
    const double c44 = 1e-12 * c0;
    const double c45 = squared(c44);
    const double c49 = 0.9 * c0;
    const double c51 = 2.0 * p[5];
    const double c52 = 2.0 + c51;
    const double c53 = c49 / c52;
    const double c70 = p[6];
    const double c71 = squared(c70);
    const double c72 = 1.0 / c71;
    const double c75 = squared(c0);
    const double c76 = 1e-18 * c75;
    const double c77 = c76 / c71;
    const double c80 = 0.5 / p[7];
    const double c81 = (-0.5) + c80;
    const double c83 = 1.0 / c70;
    const double c86 = p[8];
    const double c88 = c10 / c86;
    const double c89 = squared(c88);
    const double c90 = p[2] * c89;
    const double c91 = c86 / c90;
    const double c96 = c81 - 1.0;
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
        const double v69 = larger(v64, c45);
        const double v78 = (v69 * c72) + c77;
        const double v92 = g[7 * i + 1] * c91;
        const double v93 = 0.055346757660697604 * v92;
        const double v103 = ((pow(v78, c81) * c83) * v93) + (((c81 * pow(v78, c96)) * ((v69 * v93) * c83)) * c72);
        const double v104 = (v65 / (v65 + (double)(v64 <= c45))) * v103;
        const double v106 = c0 * ((2.0 * v41) * v104);
        const double v110 = ((-0.631771669920152) * v14) * v35;
        const double v114 = c0 * ((v110 - y[22 * i + 7]) + v39);
        const double v119 = c53 * (v58 - y[22 * i + 15]);
        const double v122 = squared(v114) + (3.0 * squared(v119));
        const double v123 = (double)(c45 <= v122);
        const double v127 = larger(v122, c45);
        const double v129 = (v127 * c72) + c77;
        const double v133 = 0.1559825412417957 * v92;
        const double v141 = ((pow(v129, c81) * c83) * v133) + (((c81 * pow(v129, c96)) * ((v127 * v133) * c83)) * c72);
        const double v142 = (v123 / (v123 + (double)(v122 <= c45))) * v141;
        const double v144 = c0 * ((2.0 * v114) * v142);
        const double v148 = ((-0.3092051869716723) * v14) * v35;
        const double v152 = c0 * ((v148 - y[22 * i + 8]) + v39);
        const double v157 = c53 * (v58 - y[22 * i + 16]);
        const double v160 = squared(v152) + (3.0 * squared(v157));
        const double v161 = (double)(c45 <= v160);
        const double v165 = larger(v160, c45);
        const double v167 = (v165 * c72) + c77;
        const double v171 = 0.18502795280105888 * v92;
        const double v179 = ((pow(v167, c81) * c83) * v171) + (((c81 * pow(v167, c96)) * ((v165 * v171) * c83)) * c72);
        const double v180 = (v161 / (v161 + (double)(v160 <= c45))) * v179;
        const double v182 = c0 * ((2.0 * v152) * v180);
        const double v186 = ((-0.0652237289787655) * v14) * v35;
        const double v190 = c0 * ((v186 - y[22 * i + 9]) + v39);
        const double v195 = c53 * (v58 - y[22 * i + 17]);
        const double v198 = squared(v190) + (3.0 * squared(v195));
        const double v199 = (double)(c45 <= v198);
        const double v203 = larger(v198, c45);
        const double v205 = (v203 * c72) + c77;
        const double v209 = 0.10364274829644775 * v92;
        const double v217 = ((pow(v205, c81) * c83) * v209) + (((c81 * pow(v205, c96)) * ((v203 * v209) * c83)) * c72);
        const double v218 = (v199 / (v199 + (double)(v198 <= c45))) * v217;
        const double v220 = c0 * ((2.0 * v190) * v218);
        const double v224 = (0.0652237289787655 * v14) * v35;
        const double v228 = c0 * ((v224 - y[22 * i + 10]) + v39);
        const double v233 = c53 * (v58 - y[22 * i + 18]);
        const double v236 = squared(v228) + (3.0 * squared(v233));
        const double v237 = (double)(c45 <= v236);
        const double v241 = larger(v236, c45);
        const double v243 = (v241 * c72) + c77;
        const double v253 = ((pow(v243, c81) * c83) * v209) + (((c81 * pow(v243, c96)) * ((v241 * v209) * c83)) * c72);
        const double v254 = (v237 / (v237 + (double)(v236 <= c45))) * v253;
        const double v256 = c0 * ((2.0 * v228) * v254);
        const double v260 = (0.3092051869716723 * v14) * v35;
        const double v264 = c0 * ((v260 - y[22 * i + 11]) + v39);
        const double v269 = c53 * (v58 - y[22 * i + 19]);
        const double v272 = squared(v264) + (3.0 * squared(v269));
        const double v273 = (double)(c45 <= v272);
        const double v277 = larger(v272, c45);
        const double v279 = (v277 * c72) + c77;
        const double v289 = ((pow(v279, c81) * c83) * v171) + (((c81 * pow(v279, c96)) * ((v277 * v171) * c83)) * c72);
        const double v290 = (v273 / (v273 + (double)(v272 <= c45))) * v289;
        const double v292 = c0 * ((2.0 * v264) * v290);
        const double v296 = (0.631771669920152 * v14) * v35;
        const double v300 = c0 * ((v296 - y[22 * i + 12]) + v39);
        const double v305 = c53 * (v58 - y[22 * i + 20]);
        const double v308 = squared(v300) + (3.0 * squared(v305));
        const double v309 = (double)(c45 <= v308);
        const double v313 = larger(v308, c45);
        const double v315 = (v313 * c72) + c77;
        const double v325 = ((pow(v315, c81) * c83) * v133) + (((c81 * pow(v315, c96)) * ((v313 * v133) * c83)) * c72);
        const double v326 = (v309 / (v309 + (double)(v308 <= c45))) * v325;
        const double v328 = c0 * ((2.0 * v300) * v326);
        const double v332 = (0.8977882908473036 * v14) * v35;
        const double v336 = c0 * ((v332 - y[22 * i + 13]) + v39);
        const double v341 = c53 * (v58 - y[22 * i + 21]);
        const double v344 = squared(v336) + (3.0 * squared(v341));
        const double v345 = (double)(c45 <= v344);
        const double v349 = larger(v344, c45);
        const double v351 = (v349 * c72) + c77;
        const double v361 = ((pow(v351, c81) * c83) * v93) + (((c81 * pow(v351, c96)) * ((v349 * v93) * c83)) * c72);
        const double v362 = (v345 / (v345 + (double)(v344 <= c45))) * v361;
        const double v364 = c0 * ((2.0 * v336) * v362);
        const double v367 = v58 * v57;
        const double v371 = c53 * ((2.0 * v341) * (3.0 * v362));
        const double v375 = (v332 * v35) * v364;
        const double v380 = 1.0 / (2.0 * v33);
        const double v382 = (((v364 * v57) - (v367 * v371)) - (v33 * v375)) - ((v32 * v375) * v380);
        const double v386 = c53 * ((2.0 * v305) * (3.0 * v326));
        const double v392 = (v296 * v35) * v328;
        const double v397 = (((v382 - (v367 * v386)) + (v328 * v57)) - (v33 * v392)) - ((v32 * v392) * v380);
        const double v401 = c53 * ((2.0 * v269) * (3.0 * v290));
        const double v407 = (v260 * v35) * v292;
        const double v412 = (((v397 - (v367 * v401)) + (v292 * v57)) - (v33 * v407)) - ((v32 * v407) * v380);
        const double v416 = c53 * ((2.0 * v233) * (3.0 * v254));
        const double v422 = (v224 * v35) * v256;
        const double v427 = (((v412 - (v367 * v416)) + (v256 * v57)) - (v33 * v422)) - ((v32 * v422) * v380);
        const double v431 = c53 * ((2.0 * v195) * (3.0 * v218));
        const double v437 = (v186 * v35) * v220;
        const double v442 = (((v427 - (v367 * v431)) + (v220 * v57)) - (v33 * v437)) - ((v32 * v437) * v380);
        const double v446 = c53 * ((2.0 * v157) * (3.0 * v180));
        const double v452 = (v148 * v35) * v182;
        const double v457 = (((v442 - (v367 * v446)) + (v182 * v57)) - (v33 * v452)) - ((v32 * v452) * v380);
        const double v461 = c53 * ((2.0 * v119) * (3.0 * v142));
        const double v467 = (v110 * v35) * v144;
        const double v472 = (((v457 - (v367 * v461)) + (v144 * v57)) - (v33 * v467)) - ((v32 * v467) * v380);
        const double v476 = c53 * ((2.0 * v61) * (3.0 * v104));
        const double v482 = (v36 * v35) * v106;
        const double v487 = (((v472 - (v367 * v476)) + (v106 * v57)) - (v33 * v482)) - ((v32 * v482) * v380);
        const double v495 = (((v371 * v57) + (v386 * v57)) + (v401 * v57)) + (v416 * v57);
        const double v503 = (((v495 + (v431 * v57)) + (v446 * v57)) + (v461 * v57)) + (v476 * v57);
        const double v511 = (v24 * ((v29 * v487) - (v19 * v503))) - (v30 * ((v29 * v503) + (v19 * v487)));
        const double v512 = 0.5 * v511;
        const double v519 = (c4 * (0.8977882908473036 * (v364 * v35))) + (c4 * (0.631771669920152 * (v328 * v35)));
        const double v527 = (v519 + (c4 * (0.3092051869716723 * (v292 * v35)))) + (c4 * (0.0652237289787655 * (v256 * v35)));
        const double v535 = (v527 + (c4 * ((-0.0652237289787655) * (v220 * v35)))) + (c4 * ((-0.3092051869716723) * (v182 * v35)));
        const double v543 = (v535 + (c4 * ((-0.631771669920152) * (v144 * v35)))) + (c4 * ((-0.8977882908473036) * (v106 * v35)));
        const double v544 = v12 * v543;
        const double v558 = ((v24 * v487) - (v30 * v503)) * v9;
        const double v563 = ((v24 * v503) + (v30 * v487)) * v9;
        s[22 * i + 6] += -v106;
        s[22 * i + 7] += -v144;
        s[22 * i + 8] += -v182;
        s[22 * i + 9] += -v220;
        s[22 * i + 10] += -v256;
        s[22 * i + 11] += -v292;
        s[22 * i + 12] += -v328;
        s[22 * i + 13] += -v364;
        s[22 * i + 4] += v512 - v544;
        s[22 * i + 26] += v512 + v544;
        s[22 * i + 14] += -v476;
        s[22 * i + 15] += -v461;
        s[22 * i + 16] += -v446;
        s[22 * i + 17] += -v431;
        s[22 * i + 18] += -v416;
        s[22 * i + 19] += -v401;
        s[22 * i + 20] += -v386;
        s[22 * i + 21] += -v371;
        s[22 * i] += -v558;
        s[22 * i + 22] += v558;
        s[22 * i + 1] += -v563;
        s[22 * i + 23] += v563;
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 22; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, f);
    rates_2(n, y, w);
    rates_3(n, y, w);
    rates_4(n, w);
    rates_5(n, g, w);
    rates_6(n, p, g, y, w, f);
    rates_7(n, p, g, w, f);
    rates_8(n, p, g, w, f);
    rates_9(n, p, g, w, f);
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
    (void)t;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, g, y, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 66; k++) s[k] = 0.0;
    work_slope_0(n, p, g, y, w, s);
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
    22, 16, 9, 7, 87, 254, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "youngs_modulus", "poisson", "viscosity",
    "index", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa", "1", "Pa*s^n", "1", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.06, 0.006, 1200.0, 9.81, 30000.0, 0.45, 236.89332233144864, 1.5, 0.0782061887005775};
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
    .title = "Oobleck: a cornstarch strand that thickens as it flows",
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
    .duration = 0.2,
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
