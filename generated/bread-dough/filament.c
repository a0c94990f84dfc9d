/*
 * Rope of bread dough, shear-thinning
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, gravity-ramp, shear, fibres, rotary-inertia
 * Digest of the structure: cffc861c9a5e95df26f75ee624a28f3973aa002ec38b9068aeea9ead5d5ecf94
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
    const double c119 = 0.9 * c1;
    const double c121 = 2.0 * p[6];
    const double c122 = 2.0 + c121;
    const double c123 = c119 / c122;
    const double c169 = 0.5 * c4;
    const double c217 = 1e-12 * c1;
    const double c218 = squared(c217);
    const double c220 = p[7];
    const double c221 = squared(c220);
    const double c222 = 1.0 / c221;
    const double c225 = squared(c1);
    const double c226 = 1e-18 * c225;
    const double c227 = c226 / c221;
    const double c230 = 0.5 / p[8];
    const double c231 = (-0.5) + c230;
    const double c233 = 1.0 / c220;
    const double c236 = p[9];
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
        const double v41 = ((((-0.9396926207859083) * v15) * v36) - y[22 * i + 6]) + v40;
        const double v42 = c1 * v41;
        const double v50 = ((((-0.7660444431189779) * v15) * v36) - y[22 * i + 7]) + v40;
        const double v51 = c1 * v50;
        const double v53 = (0.025995061875669127 * v42) + (0.09181686914811889 * v51);
        const double v60 = ((((-0.4999999999999998) * v15) * v36) - y[22 * i + 8]) + v40;
        const double v61 = c1 * v60;
        const double v70 = ((((-0.1736481776669303) * v15) * v36) - y[22 * i + 9]) + v40;
        const double v71 = c1 * v70;
        const double v73 = (v53 + (0.16666666666666669 * v61)) + (0.21552140230954533 * v71);
        const double v79 = (((0.17364817766693041 * v15) * v36) - y[22 * i + 10]) + v40;
        const double v80 = c1 * v79;
        const double v89 = (((0.5000000000000001 * v15) * v36) - y[22 * i + 11]) + v40;
        const double v90 = c1 * v89;
        const double v92 = (v73 + (0.21552140230954533 * v80)) + (0.16666666666666663 * v90);
        const double v99 = (((0.766044443118978 * v15) * v36) - y[22 * i + 12]) + v40;
        const double v100 = c1 * v99;
        const double v109 = (((0.9396926207859084 * v15) * v36) - y[22 * i + 13]) + v40;
        const double v110 = c1 * v109;
        const double v112 = (v92 + (0.09181686914811883 * v100)) + (0.025995061875669103 * v110);
        const double v113 = 1.0 / v33;
        const double v117 = (v30 * v25) - (v20 * v31);
        const double v124 = v117 * v113;
        const double v127 = c123 * (v124 - y[22 * i + 14]);
        const double v131 = c123 * (v124 - y[22 * i + 15]);
        const double v133 = (0.025995061875669127 * v127) + (0.09181686914811889 * v131);
        const double v136 = c123 * (v124 - y[22 * i + 16]);
        const double v141 = c123 * (v124 - y[22 * i + 17]);
        const double v143 = (v133 + (0.16666666666666669 * v136)) + (0.21552140230954533 * v141);
        const double v146 = c123 * (v124 - y[22 * i + 18]);
        const double v151 = c123 * (v124 - y[22 * i + 19]);
        const double v153 = (v143 + (0.21552140230954533 * v146)) + (0.16666666666666663 * v151);
        const double v156 = c123 * (v124 - y[22 * i + 20]);
        const double v161 = c123 * (v124 - y[22 * i + 21]);
        const double v163 = (v153 + (0.09181686914811883 * v156)) + (0.025995061875669103 * v161);
        const double v164 = v163 * v113;
        const double v174 = ((-0.024427367821439373) * v42) + ((-0.07033580239549879) * v51);
        const double v180 = (v174 + ((-0.0833333333333333) * v61)) + ((-0.03742489875927389) * v71);
        const double v186 = (v180 + (0.03742489875927391 * v80)) + (0.08333333333333333 * v90);
        const double v192 = (v186 + (0.07033580239549876 * v100)) + (0.024427367821439352 * v110);
        const double v194 = (c169 * v192) * v36;
        const double v198 = ((v112 * v113) - ((v117 * v164) * v113)) + (((1.5 * v194) * v14) * v113);
        const double v228 = (larger(squared(v42) + (3.0 * squared(v127)), c218) * c222) + c227;
        const double v234 = pow(v228, c231) * c233;
        const double v244 = (larger(squared(v51) + (3.0 * squared(v131)), c218) * c222) + c227;
        const double v246 = pow(v244, c231) * c233;
        const double v255 = (larger(squared(v61) + (3.0 * squared(v136)), c218) * c222) + c227;
        const double v257 = pow(v255, c231) * c233;
        const double v266 = (larger(squared(v71) + (3.0 * squared(v141)), c218) * c222) + c227;
        const double v268 = pow(v266, c231) * c233;
        const double v277 = (larger(squared(v80) + (3.0 * squared(v146)), c218) * c222) + c227;
        const double v279 = pow(v277, c231) * c233;
        const double v288 = (larger(squared(v90) + (3.0 * squared(v151)), c218) * c222) + c227;
        const double v290 = pow(v288, c231) * c233;
        const double v298 = larger(squared(v100) + (3.0 * squared(v156)), c218) * c222;
        const double v301 = pow(v298 + c227, c231) * c233;
        const double v309 = larger(squared(v110) + (3.0 * squared(v161)), c218) * c222;
        const double v312 = pow(v309 + c227, c231) * c233;
        w3[i] = (v198 * v25) - (v164 * v31);
        w4[i] = (v198 * v31) + (v164 * v25);
        w5[i] = ((g[7 * i + 1] * c11) * (v163 - (v117 * v198))) * 0.5;
        w6[i] = -v194;
        f[22 * i + 6] = (v42 * v234) * c236;
        f[22 * i + 7] = (v51 * v246) * c236;
        f[22 * i + 8] = (v61 * v257) * c236;
        f[22 * i + 9] = (v71 * v268) * c236;
        f[22 * i + 10] = (v80 * v279) * c236;
        f[22 * i + 11] = (v90 * v290) * c236;
        f[22 * i + 12] = (v100 * v301) * c236;
        f[22 * i + 13] = (v110 * v312) * c236;
        f[22 * i + 14] = ((3.0 * v127) * v234) * c236;
        f[22 * i + 15] = ((3.0 * v131) * v246) * c236;
        f[22 * i + 16] = ((3.0 * v136) * v257) * c236;
        f[22 * i + 17] = ((3.0 * v141) * v268) * c236;
        f[22 * i + 18] = ((3.0 * v146) * v279) * c236;
        f[22 * i + 19] = ((3.0 * v151) * v290) * c236;
        f[22 * i + 20] = ((3.0 * v156) * v301) * c236;
        f[22 * i + 21] = ((3.0 * v161) * v312) * c236;
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
    const double c119 = 0.9 * c1;
    const double c121 = 2.0 * p[6];
    const double c122 = 2.0 + c121;
    const double c123 = c119 / c122;
    const double c169 = 0.5 * c4;
    const double c202 = 0.025995061875669127 * c1;
    const double c204 = (-0.024427367821439373) * c1;
    const double c205 = c169 * c204;
    const double c213 = 0.09181686914811889 * c1;
    const double c215 = (-0.07033580239549879) * c1;
    const double c216 = c169 * c215;
    const double c224 = 0.16666666666666669 * c1;
    const double c226 = (-0.0833333333333333) * c1;
    const double c227 = c169 * c226;
    const double c235 = 0.21552140230954533 * c1;
    const double c237 = (-0.03742489875927389) * c1;
    const double c238 = c169 * c237;
    const double c246 = 0.03742489875927391 * c1;
    const double c247 = c169 * c246;
    const double c255 = 0.16666666666666663 * c1;
    const double c257 = 0.08333333333333333 * c1;
    const double c258 = c169 * c257;
    const double c266 = 0.09181686914811883 * c1;
    const double c268 = 0.07033580239549876 * c1;
    const double c269 = c169 * c268;
    const double c277 = 0.025995061875669103 * c1;
    const double c279 = 0.024427367821439352 * c1;
    const double c280 = c169 * c279;
    const double c515 = 0.025995061875669127 * c123;
    const double c522 = 0.09181686914811889 * c123;
    const double c529 = 0.16666666666666669 * c123;
    const double c536 = 0.21552140230954533 * c123;
    const double c543 = 0.16666666666666663 * c123;
    const double c550 = 0.09181686914811883 * c123;
    const double c557 = 0.025995061875669103 * c123;
    const double c1079 = p[9];
    const double c1086 = 1e-12 * c1;
    const double c1087 = squared(c1086);
    const double c1089 = p[7];
    const double c1090 = squared(c1089);
    const double c1091 = 1.0 / c1090;
    const double c1094 = squared(c1);
    const double c1095 = 1e-18 * c1094;
    const double c1096 = c1095 / c1090;
    const double c1099 = 0.5 / p[8];
    const double c1100 = (-0.5) + c1099;
    const double c1102 = 1.0 / c1089;
    const double c1106 = c1100 - 1.0;
    const double c1941 = 3.0 * c123;
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
        const double v37 = ((-0.9396926207859083) * v15) * v36;
        const double v40 = log(v33);
        const double v42 = c1 * ((v37 - y[22 * i + 6]) + v40);
        const double v47 = ((-0.7660444431189779) * v15) * v36;
        const double v51 = c1 * ((v47 - y[22 * i + 7]) + v40);
        const double v53 = (0.025995061875669127 * v42) + (0.09181686914811889 * v51);
        const double v57 = ((-0.4999999999999998) * v15) * v36;
        const double v61 = c1 * ((v57 - y[22 * i + 8]) + v40);
        const double v67 = ((-0.1736481776669303) * v15) * v36;
        const double v71 = c1 * ((v67 - y[22 * i + 9]) + v40);
        const double v73 = (v53 + (0.16666666666666669 * v61)) + (0.21552140230954533 * v71);
        const double v76 = (0.17364817766693041 * v15) * v36;
        const double v80 = c1 * ((v76 - y[22 * i + 10]) + v40);
        const double v86 = (0.5000000000000001 * v15) * v36;
        const double v90 = c1 * ((v86 - y[22 * i + 11]) + v40);
        const double v92 = (v73 + (0.21552140230954533 * v80)) + (0.16666666666666663 * v90);
        const double v96 = (0.766044443118978 * v15) * v36;
        const double v100 = c1 * ((v96 - y[22 * i + 12]) + v40);
        const double v106 = (0.9396926207859084 * v15) * v36;
        const double v110 = c1 * ((v106 - y[22 * i + 13]) + v40);
        const double v112 = (v92 + (0.09181686914811883 * v100)) + (0.025995061875669103 * v110);
        const double v113 = 1.0 / v33;
        const double v114 = v112 * v113;
        const double v117 = (v30 * v25) - (v20 * v31);
        const double v124 = v117 * v113;
        const double v127 = c123 * (v124 - y[22 * i + 14]);
        const double v131 = c123 * (v124 - y[22 * i + 15]);
        const double v133 = (0.025995061875669127 * v127) + (0.09181686914811889 * v131);
        const double v136 = c123 * (v124 - y[22 * i + 16]);
        const double v141 = c123 * (v124 - y[22 * i + 17]);
        const double v143 = (v133 + (0.16666666666666669 * v136)) + (0.21552140230954533 * v141);
        const double v146 = c123 * (v124 - y[22 * i + 18]);
        const double v151 = c123 * (v124 - y[22 * i + 19]);
        const double v153 = (v143 + (0.21552140230954533 * v146)) + (0.16666666666666663 * v151);
        const double v156 = c123 * (v124 - y[22 * i + 20]);
        const double v161 = c123 * (v124 - y[22 * i + 21]);
        const double v163 = (v153 + (0.09181686914811883 * v156)) + (0.025995061875669103 * v161);
        const double v164 = v163 * v113;
        const double v166 = (v117 * v164) * v113;
        const double v174 = ((-0.024427367821439373) * v42) + ((-0.07033580239549879) * v51);
        const double v180 = (v174 + ((-0.0833333333333333) * v61)) + ((-0.03742489875927389) * v71);
        const double v186 = (v180 + (0.03742489875927391 * v80)) + (0.08333333333333333 * v90);
        const double v192 = (v186 + (0.07033580239549876 * v100)) + (0.024427367821439352 * v110);
        const double v194 = (c169 * v192) * v36;
        const double v195 = 1.5 * v194;
        const double v197 = (v195 * v14) * v113;
        const double v198 = (v114 - v166) + v197;
        const double v206 = c205 * v36;
        const double v210 = (c202 * v113) + ((v14 * (1.5 * v206)) * v113);
        const double v217 = c216 * v36;
        const double v221 = (c213 * v113) + ((v14 * (1.5 * v217)) * v113);
        const double v228 = c227 * v36;
        const double v232 = (c224 * v113) + ((v14 * (1.5 * v228)) * v113);
        const double v236 = c235 * v113;
        const double v239 = c238 * v36;
        const double v243 = v236 + ((v14 * (1.5 * v239)) * v113);
        const double v248 = c247 * v36;
        const double v252 = v236 + ((v14 * (1.5 * v248)) * v113);
        const double v259 = c258 * v36;
        const double v263 = (c255 * v113) + ((v14 * (1.5 * v259)) * v113);
        const double v270 = c269 * v36;
        const double v274 = (c266 * v113) + ((v14 * (1.5 * v270)) * v113);
        const double v281 = c280 * v36;
        const double v285 = (c277 * v113) + ((v14 * (1.5 * v281)) * v113);
        const double v288 = 0.5 * v25;
        const double v290 = 0.5 * v31;
        const double v292 = (v30 * v288) - (v20 * v290);
        const double v293 = v292 * v113;
        const double v294 = c5 * v13;
        const double v296 = ((-0.9396926207859083) * v294) * v36;
        const double v297 = v37 * v36;
        const double v299 = 1.0 / (2.0 * v34);
        const double v303 = (v33 * (v292 * v299)) + (v34 * v292);
        const double v304 = v297 * v303;
        const double v307 = c1 * (v293 - (v296 + v304));
        const double v310 = ((-0.7660444431189779) * v294) * v36;
        const double v311 = v47 * v36;
        const double v312 = v311 * v303;
        const double v315 = c1 * (v293 - (v310 + v312));
        const double v317 = (0.025995061875669127 * v307) + (0.09181686914811889 * v315);
        const double v319 = ((-0.4999999999999998) * v294) * v36;
        const double v320 = v57 * v36;
        const double v321 = v320 * v303;
        const double v324 = c1 * (v293 - (v319 + v321));
        const double v328 = ((-0.1736481776669303) * v294) * v36;
        const double v329 = v67 * v36;
        const double v330 = v329 * v303;
        const double v333 = c1 * (v293 - (v328 + v330));
        const double v335 = (v317 + (0.16666666666666669 * v324)) + (0.21552140230954533 * v333);
        const double v337 = (0.17364817766693041 * v294) * v36;
        const double v338 = v76 * v36;
        const double v339 = v338 * v303;
        const double v342 = c1 * (v293 - (v337 + v339));
        const double v346 = (0.5000000000000001 * v294) * v36;
        const double v347 = v86 * v36;
        const double v348 = v347 * v303;
        const double v351 = c1 * (v293 - (v346 + v348));
        const double v353 = (v335 + (0.21552140230954533 * v342)) + (0.16666666666666663 * v351);
        const double v355 = (0.766044443118978 * v294) * v36;
        const double v356 = v96 * v36;
        const double v357 = v356 * v303;
        const double v360 = c1 * (v293 - (v355 + v357));
        const double v364 = (0.9396926207859084 * v294) * v36;
        const double v365 = v106 * v36;
        const double v366 = v365 * v303;
        const double v369 = c1 * (v293 - (v364 + v366));
        const double v371 = (v353 + (0.09181686914811883 * v360)) + (0.025995061875669103 * v369);
        const double v373 = v114 * v113;
        const double v374 = v373 * v292;
        const double v378 = (v30 * v290) + (v20 * v288);
        const double v381 = v124 * v113;
        const double v384 = c123 * ((v378 * v113) + (v381 * v292));
        const double v387 = (0.025995061875669127 * v384) + (0.09181686914811889 * v384);
        const double v390 = 0.21552140230954533 * v384;
        const double v394 = (((v387 + (0.16666666666666669 * v384)) + v390) + v390) + (0.16666666666666663 * v384);
        const double v398 = (v394 + (0.09181686914811883 * v384)) + (0.025995061875669103 * v384);
        const double v400 = v164 * v113;
        const double v402 = (v398 * v113) + (v400 * v292);
        const double v406 = v166 * v113;
        const double v408 = (((v164 * v378) + (v117 * v402)) * v113) + (v406 * v292);
        const double v412 = ((-0.024427367821439373) * v307) + ((-0.07033580239549879) * v315);
        const double v416 = (v412 + ((-0.0833333333333333) * v324)) + ((-0.03742489875927389) * v333);
        const double v420 = (v416 + (0.03742489875927391 * v342)) + (0.08333333333333333 * v351);
        const double v424 = (v420 + (0.07033580239549876 * v360)) + (0.024427367821439352 * v369);
        const double v427 = v194 * v36;
        const double v428 = v427 * v303;
        const double v429 = ((c169 * v424) * v36) - v428;
        const double v432 = v195 * v13;
        const double v435 = v197 * v113;
        const double v436 = v435 * v292;
        const double v438 = (((v371 * v113) - v374) + v408) + ((((v14 * (1.5 * v429)) - v432) * v113) - v436);
        const double v440 = v198 * v290;
        const double v444 = (v164 * v288) - (v31 * v402);
        const double v448 = c1 * ((v296 - v304) + v293);
        const double v452 = c1 * ((v310 - v312) + v293);
        const double v454 = (0.025995061875669127 * v448) + (0.09181686914811889 * v452);
        const double v457 = c1 * ((v319 - v321) + v293);
        const double v462 = c1 * ((v328 - v330) + v293);
        const double v464 = (v454 + (0.16666666666666669 * v457)) + (0.21552140230954533 * v462);
        const double v467 = c1 * ((v337 - v339) + v293);
        const double v472 = c1 * ((v346 - v348) + v293);
        const double v474 = (v464 + (0.21552140230954533 * v467)) + (0.16666666666666663 * v472);
        const double v477 = c1 * ((v355 - v357) + v293);
        const double v482 = c1 * ((v364 - v366) + v293);
        const double v484 = (v474 + (0.09181686914811883 * v477)) + (0.025995061875669103 * v482);
        const double v490 = ((-0.024427367821439373) * v448) + ((-0.07033580239549879) * v452);
        const double v494 = (v490 + ((-0.0833333333333333) * v457)) + ((-0.03742489875927389) * v462);
        const double v498 = (v494 + (0.03742489875927391 * v467)) + (0.08333333333333333 * v472);
        const double v502 = (v498 + (0.07033580239549876 * v477)) + (0.024427367821439352 * v482);
        const double v505 = ((c169 * v502) * v36) - v428;
        const double v511 = (((v484 * v113) - v374) + v408) + ((((v14 * (1.5 * v505)) + v432) * v113) - v436);
        const double v516 = c515 * v113;
        const double v518 = (v117 * v516) * v113;
        const double v523 = c522 * v113;
        const double v525 = (v117 * v523) * v113;
        const double v530 = c529 * v113;
        const double v532 = (v117 * v530) * v113;
        const double v537 = c536 * v113;
        const double v539 = (v117 * v537) * v113;
        const double v542 = (v25 * v539) + (v31 * v537);
        const double v544 = c543 * v113;
        const double v546 = (v117 * v544) * v113;
        const double v551 = c550 * v113;
        const double v553 = (v117 * v551) * v113;
        const double v558 = c557 * v113;
        const double v560 = (v117 * v558) * v113;
        const double v564 = v25 * v10;
        const double v568 = (v33 * (v564 * v299)) + (v34 * v564);
        const double v569 = v297 * v568;
        const double v570 = v564 * v113;
        const double v572 = c1 * (v569 - v570);
        const double v574 = v311 * v568;
        const double v576 = c1 * (v574 - v570);
        const double v578 = (0.025995061875669127 * v572) + (0.09181686914811889 * v576);
        const double v579 = v320 * v568;
        const double v581 = c1 * (v579 - v570);
        const double v584 = v329 * v568;
        const double v586 = c1 * (v584 - v570);
        const double v588 = (v578 + (0.16666666666666669 * v581)) + (0.21552140230954533 * v586);
        const double v589 = v338 * v568;
        const double v591 = c1 * (v589 - v570);
        const double v594 = v347 * v568;
        const double v596 = c1 * (v594 - v570);
        const double v598 = (v588 + (0.21552140230954533 * v591)) + (0.16666666666666663 * v596);
        const double v599 = v356 * v568;
        const double v601 = c1 * (v599 - v570);
        const double v604 = v365 * v568;
        const double v606 = c1 * (v604 - v570);
        const double v608 = (v598 + (0.09181686914811883 * v601)) + (0.025995061875669103 * v606);
        const double v610 = v373 * v564;
        const double v612 = v31 * v10;
        const double v614 = v612 * v113;
        const double v617 = c123 * (v614 + (v381 * v564));
        const double v620 = (0.025995061875669127 * v617) + (0.09181686914811889 * v617);
        const double v623 = 0.21552140230954533 * v617;
        const double v627 = (((v620 + (0.16666666666666669 * v617)) + v623) + v623) + (0.16666666666666663 * v617);
        const double v631 = (v627 + (0.09181686914811883 * v617)) + (0.025995061875669103 * v617);
        const double v634 = (v631 * v113) + (v400 * v564);
        const double v639 = (((v164 * v612) + (v117 * v634)) * v113) + (v406 * v564);
        const double v643 = ((-0.024427367821439373) * v572) + ((-0.07033580239549879) * v576);
        const double v647 = (v643 + ((-0.0833333333333333) * v581)) + ((-0.03742489875927389) * v586);
        const double v651 = (v647 + (0.03742489875927391 * v591)) + (0.08333333333333333 * v596);
        const double v655 = (v651 + (0.07033580239549876 * v601)) + (0.024427367821439352 * v606);
        const double v658 = v427 * v568;
        const double v659 = ((c169 * v655) * v36) + v658;
        const double v663 = v435 * v564;
        const double v665 = (((v608 * v113) + v610) - v639) + (((v14 * (1.5 * v659)) * v113) + v663);
        const double v667 = v31 * v634;
        const double v670 = c1 * (v570 - v569);
        const double v673 = c1 * (v570 - v574);
        const double v675 = (0.025995061875669127 * v670) + (0.09181686914811889 * v673);
        const double v677 = c1 * (v570 - v579);
        const double v681 = c1 * (v570 - v584);
        const double v683 = (v675 + (0.16666666666666669 * v677)) + (0.21552140230954533 * v681);
        const double v685 = c1 * (v570 - v589);
        const double v689 = c1 * (v570 - v594);
        const double v691 = (v683 + (0.21552140230954533 * v685)) + (0.16666666666666663 * v689);
        const double v693 = c1 * (v570 - v599);
        const double v697 = c1 * (v570 - v604);
        const double v699 = (v691 + (0.09181686914811883 * v693)) + (0.025995061875669103 * v697);
        const double v705 = ((-0.024427367821439373) * v670) + ((-0.07033580239549879) * v673);
        const double v709 = (v705 + ((-0.0833333333333333) * v677)) + ((-0.03742489875927389) * v681);
        const double v713 = (v709 + (0.03742489875927391 * v685)) + (0.08333333333333333 * v689);
        const double v717 = (v713 + (0.07033580239549876 * v693)) + (0.024427367821439352 * v697);
        const double v720 = ((c169 * v717) * v36) - v658;
        const double v725 = (((v699 * v113) - v610) + v639) + (((v14 * (1.5 * v720)) * v113) - v663);
        const double v731 = (v33 * (v612 * v299)) + (v34 * v612);
        const double v732 = v297 * v731;
        const double v734 = c1 * (v732 - v614);
        const double v736 = v311 * v731;
        const double v738 = c1 * (v736 - v614);
        const double v740 = (0.025995061875669127 * v734) + (0.09181686914811889 * v738);
        const double v741 = v320 * v731;
        const double v743 = c1 * (v741 - v614);
        const double v746 = v329 * v731;
        const double v748 = c1 * (v746 - v614);
        const double v750 = (v740 + (0.16666666666666669 * v743)) + (0.21552140230954533 * v748);
        const double v751 = v338 * v731;
        const double v753 = c1 * (v751 - v614);
        const double v756 = v347 * v731;
        const double v758 = c1 * (v756 - v614);
        const double v760 = (v750 + (0.21552140230954533 * v753)) + (0.16666666666666663 * v758);
        const double v761 = v356 * v731;
        const double v763 = c1 * (v761 - v614);
        const double v766 = v365 * v731;
        const double v768 = c1 * (v766 - v614);
        const double v770 = (v760 + (0.09181686914811883 * v763)) + (0.025995061875669103 * v768);
        const double v772 = v373 * v612;
        const double v774 = v381 * v612;
        const double v776 = c123 * (v774 - v570);
        const double v779 = (0.025995061875669127 * v776) + (0.09181686914811889 * v776);
        const double v782 = 0.21552140230954533 * v776;
        const double v786 = (((v779 + (0.16666666666666669 * v776)) + v782) + v782) + (0.16666666666666663 * v776);
        const double v790 = (v786 + (0.09181686914811883 * v776)) + (0.025995061875669103 * v776);
        const double v792 = v400 * v612;
        const double v793 = (v790 * v113) + v792;
        const double v795 = v164 * v564;
        const double v798 = v406 * v612;
        const double v800 = ((v770 * v113) + v772) - ((((v117 * v793) - v795) * v113) + v798);
        const double v803 = ((-0.024427367821439373) * v734) + ((-0.07033580239549879) * v738);
        const double v807 = (v803 + ((-0.0833333333333333) * v743)) + ((-0.03742489875927389) * v748);
        const double v811 = (v807 + (0.03742489875927391 * v753)) + (0.08333333333333333 * v758);
        const double v815 = (v811 + (0.07033580239549876 * v763)) + (0.024427367821439352 * v768);
        const double v818 = v427 * v731;
        const double v819 = ((c169 * v815) * v36) + v818;
        const double v823 = v435 * v612;
        const double v825 = v800 + (((v14 * (1.5 * v819)) * v113) + v823);
        const double v830 = c1 * (v614 - v732);
        const double v833 = c1 * (v614 - v736);
        const double v835 = (0.025995061875669127 * v830) + (0.09181686914811889 * v833);
        const double v837 = c1 * (v614 - v741);
        const double v841 = c1 * (v614 - v746);
        const double v843 = (v835 + (0.16666666666666669 * v837)) + (0.21552140230954533 * v841);
        const double v845 = c1 * (v614 - v751);
        const double v849 = c1 * (v614 - v756);
        const double v851 = (v843 + (0.21552140230954533 * v845)) + (0.16666666666666663 * v849);
        const double v853 = c1 * (v614 - v761);
        const double v857 = c1 * (v614 - v766);
        const double v859 = (v851 + (0.09181686914811883 * v853)) + (0.025995061875669103 * v857);
        const double v863 = c123 * (v570 - v774);
        const double v866 = (0.025995061875669127 * v863) + (0.09181686914811889 * v863);
        const double v869 = 0.21552140230954533 * v863;
        const double v873 = (((v866 + (0.16666666666666669 * v863)) + v869) + v869) + (0.16666666666666663 * v863);
        const double v877 = (v873 + (0.09181686914811883 * v863)) + (0.025995061875669103 * v863);
        const double v879 = (v877 * v113) - v792;
        const double v884 = ((v859 * v113) - v772) - (((v795 + (v117 * v879)) * v113) - v798);
        const double v887 = ((-0.024427367821439373) * v830) + ((-0.07033580239549879) * v833);
        const double v891 = (v887 + ((-0.0833333333333333) * v837)) + ((-0.03742489875927389) * v841);
        const double v895 = (v891 + (0.03742489875927391 * v845)) + (0.08333333333333333 * v849);
        const double v899 = (v895 + (0.07033580239549876 * v853)) + (0.024427367821439352 * v857);
        const double v902 = ((c169 * v899) * v36) - v818;
        const double v907 = v884 + (((v14 * (1.5 * v902)) * v113) - v823);
        const double v931 = v198 * v288;
        const double v935 = (v25 * v402) + (v164 * v290);
        const double v951 = (v31 * v539) - (v25 * v537);
        const double v962 = v25 * v634;
        const double v972 = g[7 * i + 1] * c11;
        const double v1002 = v198 * v378;
        const double v1033 = -(0.5 * (v972 * (c536 + (v117 * v539))));
        const double v1049 = v198 * v612;
        const double v1062 = v198 * v564;
        const double v1084 = squared(v42) + (3.0 * squared(v127));
        const double v1097 = (larger(v1084, c1087) * c1091) + c1096;
        const double v1103 = pow(v1097, c1100) * c1102;
        const double v1108 = c1100 * pow(v1097, c1106);
        const double v1109 = (double)(c1087 <= v1084);
        const double v1112 = v1109 / (v1109 + (double)(v1084 <= c1087));
        const double v1113 = 2.0 * v42;
        const double v1118 = (v1108 * ((v1112 * (v1113 * c1)) * c1091)) * c1102;
        const double v1125 = 2.0 * v127;
        const double v1127 = 3.0 * (v1125 * v384);
        const double v1132 = (v1108 * ((v1112 * ((v1113 * v307) - v1127)) * c1091)) * c1102;
        const double v1142 = (v1108 * ((v1112 * ((v1113 * v448) - v1127)) * c1091)) * c1102;
        const double v1151 = (v1108 * ((v1112 * (3.0 * (v1125 * c123))) * c1091)) * c1102;
        const double v1158 = 3.0 * (v1125 * v617);
        const double v1163 = (v1108 * ((v1112 * ((v1113 * v572) + v1158)) * c1091)) * c1102;
        const double v1173 = (v1108 * ((v1112 * ((v1113 * v670) - v1158)) * c1091)) * c1102;
        const double v1183 = (v1112 * ((v1113 * v734) + (3.0 * (v1125 * v776)))) * c1091;
        const double v1185 = (v1108 * v1183) * c1102;
        const double v1195 = (v1112 * ((v1113 * v830) + (3.0 * (v1125 * v863)))) * c1091;
        const double v1197 = (v1108 * v1195) * c1102;
        const double v1204 = squared(v51) + (3.0 * squared(v131));
        const double v1207 = (larger(v1204, c1087) * c1091) + c1096;
        const double v1209 = pow(v1207, c1100) * c1102;
        const double v1212 = c1100 * pow(v1207, c1106);
        const double v1213 = (double)(c1087 <= v1204);
        const double v1216 = v1213 / (v1213 + (double)(v1204 <= c1087));
        const double v1217 = 2.0 * v51;
        const double v1222 = (v1212 * ((v1216 * (v1217 * c1)) * c1091)) * c1102;
        const double v1229 = 2.0 * v131;
        const double v1231 = 3.0 * (v1229 * v384);
        const double v1236 = (v1212 * ((v1216 * ((v1217 * v315) - v1231)) * c1091)) * c1102;
        const double v1246 = (v1212 * ((v1216 * ((v1217 * v452) - v1231)) * c1091)) * c1102;
        const double v1255 = (v1212 * ((v1216 * (3.0 * (v1229 * c123))) * c1091)) * c1102;
        const double v1262 = 3.0 * (v1229 * v617);
        const double v1267 = (v1212 * ((v1216 * ((v1217 * v576) + v1262)) * c1091)) * c1102;
        const double v1277 = (v1212 * ((v1216 * ((v1217 * v673) - v1262)) * c1091)) * c1102;
        const double v1287 = (v1216 * ((v1217 * v738) + (3.0 * (v1229 * v776)))) * c1091;
        const double v1289 = (v1212 * v1287) * c1102;
        const double v1299 = (v1216 * ((v1217 * v833) + (3.0 * (v1229 * v863)))) * c1091;
        const double v1301 = (v1212 * v1299) * c1102;
        const double v1308 = squared(v61) + (3.0 * squared(v136));
        const double v1311 = (larger(v1308, c1087) * c1091) + c1096;
        const double v1313 = pow(v1311, c1100) * c1102;
        const double v1316 = c1100 * pow(v1311, c1106);
        const double v1317 = (double)(c1087 <= v1308);
        const double v1320 = v1317 / (v1317 + (double)(v1308 <= c1087));
        const double v1321 = 2.0 * v61;
        const double v1326 = (v1316 * ((v1320 * (v1321 * c1)) * c1091)) * c1102;
        const double v1333 = 2.0 * v136;
        const double v1335 = 3.0 * (v1333 * v384);
        const double v1340 = (v1316 * ((v1320 * ((v1321 * v324) - v1335)) * c1091)) * c1102;
        const double v1350 = (v1316 * ((v1320 * ((v1321 * v457) - v1335)) * c1091)) * c1102;
        const double v1359 = (v1316 * ((v1320 * (3.0 * (v1333 * c123))) * c1091)) * c1102;
        const double v1366 = 3.0 * (v1333 * v617);
        const double v1371 = (v1316 * ((v1320 * ((v1321 * v581) + v1366)) * c1091)) * c1102;
        const double v1381 = (v1316 * ((v1320 * ((v1321 * v677) - v1366)) * c1091)) * c1102;
        const double v1391 = (v1320 * ((v1321 * v743) + (3.0 * (v1333 * v776)))) * c1091;
        const double v1393 = (v1316 * v1391) * c1102;
        const double v1403 = (v1320 * ((v1321 * v837) + (3.0 * (v1333 * v863)))) * c1091;
        const double v1405 = (v1316 * v1403) * c1102;
        const double v1412 = squared(v71) + (3.0 * squared(v141));
        const double v1415 = (larger(v1412, c1087) * c1091) + c1096;
        const double v1417 = pow(v1415, c1100) * c1102;
        const double v1420 = c1100 * pow(v1415, c1106);
        const double v1421 = (double)(c1087 <= v1412);
        const double v1424 = v1421 / (v1421 + (double)(v1412 <= c1087));
        const double v1425 = 2.0 * v71;
        const double v1430 = (v1420 * ((v1424 * (v1425 * c1)) * c1091)) * c1102;
        const double v1437 = 2.0 * v141;
        const double v1439 = 3.0 * (v1437 * v384);
        const double v1444 = (v1420 * ((v1424 * ((v1425 * v333) - v1439)) * c1091)) * c1102;
        const double v1454 = (v1420 * ((v1424 * ((v1425 * v462) - v1439)) * c1091)) * c1102;
        const double v1463 = (v1420 * ((v1424 * (3.0 * (v1437 * c123))) * c1091)) * c1102;
        const double v1470 = 3.0 * (v1437 * v617);
        const double v1475 = (v1420 * ((v1424 * ((v1425 * v586) + v1470)) * c1091)) * c1102;
        const double v1485 = (v1420 * ((v1424 * ((v1425 * v681) - v1470)) * c1091)) * c1102;
        const double v1495 = (v1424 * ((v1425 * v748) + (3.0 * (v1437 * v776)))) * c1091;
        const double v1497 = (v1420 * v1495) * c1102;
        const double v1507 = (v1424 * ((v1425 * v841) + (3.0 * (v1437 * v863)))) * c1091;
        const double v1509 = (v1420 * v1507) * c1102;
        const double v1516 = squared(v80) + (3.0 * squared(v146));
        const double v1519 = (larger(v1516, c1087) * c1091) + c1096;
        const double v1521 = pow(v1519, c1100) * c1102;
        const double v1524 = c1100 * pow(v1519, c1106);
        const double v1525 = (double)(c1087 <= v1516);
        const double v1528 = v1525 / (v1525 + (double)(v1516 <= c1087));
        const double v1529 = 2.0 * v80;
        const double v1534 = (v1524 * ((v1528 * (v1529 * c1)) * c1091)) * c1102;
        const double v1541 = 2.0 * v146;
        const double v1543 = 3.0 * (v1541 * v384);
        const double v1548 = (v1524 * ((v1528 * ((v1529 * v342) - v1543)) * c1091)) * c1102;
        const double v1558 = (v1524 * ((v1528 * ((v1529 * v467) - v1543)) * c1091)) * c1102;
        const double v1567 = (v1524 * ((v1528 * (3.0 * (v1541 * c123))) * c1091)) * c1102;
        const double v1574 = 3.0 * (v1541 * v617);
        const double v1579 = (v1524 * ((v1528 * ((v1529 * v591) + v1574)) * c1091)) * c1102;
        const double v1589 = (v1524 * ((v1528 * ((v1529 * v685) - v1574)) * c1091)) * c1102;
        const double v1599 = (v1528 * ((v1529 * v753) + (3.0 * (v1541 * v776)))) * c1091;
        const double v1601 = (v1524 * v1599) * c1102;
        const double v1611 = (v1528 * ((v1529 * v845) + (3.0 * (v1541 * v863)))) * c1091;
        const double v1613 = (v1524 * v1611) * c1102;
        const double v1620 = squared(v90) + (3.0 * squared(v151));
        const double v1623 = (larger(v1620, c1087) * c1091) + c1096;
        const double v1625 = pow(v1623, c1100) * c1102;
        const double v1628 = c1100 * pow(v1623, c1106);
        const double v1629 = (double)(c1087 <= v1620);
        const double v1632 = v1629 / (v1629 + (double)(v1620 <= c1087));
        const double v1633 = 2.0 * v90;
        const double v1638 = (v1628 * ((v1632 * (v1633 * c1)) * c1091)) * c1102;
        const double v1645 = 2.0 * v151;
        const double v1647 = 3.0 * (v1645 * v384);
        const double v1652 = (v1628 * ((v1632 * ((v1633 * v351) - v1647)) * c1091)) * c1102;
        const double v1662 = (v1628 * ((v1632 * ((v1633 * v472) - v1647)) * c1091)) * c1102;
        const double v1671 = (v1628 * ((v1632 * (3.0 * (v1645 * c123))) * c1091)) * c1102;
        const double v1678 = 3.0 * (v1645 * v617);
        const double v1683 = (v1628 * ((v1632 * ((v1633 * v596) + v1678)) * c1091)) * c1102;
        const double v1693 = (v1628 * ((v1632 * ((v1633 * v689) - v1678)) * c1091)) * c1102;
        const double v1703 = (v1632 * ((v1633 * v758) + (3.0 * (v1645 * v776)))) * c1091;
        const double v1705 = (v1628 * v1703) * c1102;
        const double v1715 = (v1632 * ((v1633 * v849) + (3.0 * (v1645 * v863)))) * c1091;
        const double v1717 = (v1628 * v1715) * c1102;
        const double v1724 = squared(v100) + (3.0 * squared(v156));
        const double v1727 = (larger(v1724, c1087) * c1091) + c1096;
        const double v1729 = pow(v1727, c1100) * c1102;
        const double v1732 = c1100 * pow(v1727, c1106);
        const double v1733 = (double)(c1087 <= v1724);
        const double v1736 = v1733 / (v1733 + (double)(v1724 <= c1087));
        const double v1737 = 2.0 * v100;
        const double v1742 = (v1732 * ((v1736 * (v1737 * c1)) * c1091)) * c1102;
        const double v1749 = 2.0 * v156;
        const double v1751 = 3.0 * (v1749 * v384);
        const double v1756 = (v1732 * ((v1736 * ((v1737 * v360) - v1751)) * c1091)) * c1102;
        const double v1766 = (v1732 * ((v1736 * ((v1737 * v477) - v1751)) * c1091)) * c1102;
        const double v1775 = (v1732 * ((v1736 * (3.0 * (v1749 * c123))) * c1091)) * c1102;
        const double v1782 = 3.0 * (v1749 * v617);
        const double v1787 = (v1732 * ((v1736 * ((v1737 * v601) + v1782)) * c1091)) * c1102;
        const double v1797 = (v1732 * ((v1736 * ((v1737 * v693) - v1782)) * c1091)) * c1102;
        const double v1807 = (v1736 * ((v1737 * v763) + (3.0 * (v1749 * v776)))) * c1091;
        const double v1809 = (v1732 * v1807) * c1102;
        const double v1819 = (v1736 * ((v1737 * v853) + (3.0 * (v1749 * v863)))) * c1091;
        const double v1821 = (v1732 * v1819) * c1102;
        const double v1828 = squared(v110) + (3.0 * squared(v161));
        const double v1831 = (larger(v1828, c1087) * c1091) + c1096;
        const double v1833 = pow(v1831, c1100) * c1102;
        const double v1836 = c1100 * pow(v1831, c1106);
        const double v1837 = (double)(c1087 <= v1828);
        const double v1840 = v1837 / (v1837 + (double)(v1828 <= c1087));
        const double v1841 = 2.0 * v110;
        const double v1846 = (v1836 * ((v1840 * (v1841 * c1)) * c1091)) * c1102;
        const double v1853 = 2.0 * v161;
        const double v1855 = 3.0 * (v1853 * v384);
        const double v1860 = (v1836 * ((v1840 * ((v1841 * v369) - v1855)) * c1091)) * c1102;
        const double v1870 = (v1836 * ((v1840 * ((v1841 * v482) - v1855)) * c1091)) * c1102;
        const double v1879 = (v1836 * ((v1840 * (3.0 * (v1853 * c123))) * c1091)) * c1102;
        const double v1886 = 3.0 * (v1853 * v617);
        const double v1891 = (v1836 * ((v1840 * ((v1841 * v606) + v1886)) * c1091)) * c1102;
        const double v1901 = (v1836 * ((v1840 * ((v1841 * v697) - v1886)) * c1091)) * c1102;
        const double v1911 = (v1840 * ((v1841 * v768) + (3.0 * (v1853 * v776)))) * c1091;
        const double v1913 = (v1836 * v1911) * c1102;
        const double v1923 = (v1840 * ((v1841 * v857) + (3.0 * (v1853 * v863)))) * c1091;
        const double v1925 = (v1836 * v1923) * c1102;
        const double v1929 = 3.0 * v127;
        const double v1934 = 3.0 * v384;
        const double v1935 = v1103 * v1934;
        const double v1947 = 3.0 * v617;
        const double v1948 = v1103 * v1947;
        const double v1955 = 3.0 * v776;
        const double v1960 = 3.0 * v863;
        const double v1965 = 3.0 * v131;
        const double v1970 = v1209 * v1934;
        const double v1981 = v1209 * v1947;
        const double v1996 = 3.0 * v136;
        const double v2001 = v1313 * v1934;
        const double v2012 = v1313 * v1947;
        const double v2027 = 3.0 * v141;
        const double v2032 = v1417 * v1934;
        const double v2043 = v1417 * v1947;
        const double v2058 = 3.0 * v146;
        const double v2063 = v1521 * v1934;
        const double v2074 = v1521 * v1947;
        const double v2089 = 3.0 * v151;
        const double v2094 = v1625 * v1934;
        const double v2105 = v1625 * v1947;
        const double v2120 = 3.0 * v156;
        const double v2125 = v1729 * v1934;
        const double v2136 = v1729 * v1947;
        const double v2151 = 3.0 * v161;
        const double v2156 = v1833 * v1934;
        const double v2167 = v1833 * v1947;
        w3[i] = (v198 * v25) - (v164 * v31);
        w7[i] = -(v25 * v210);
        w8[i] = -(v25 * v221);
        w9[i] = -(v25 * v232);
        w10[i] = -(v25 * v243);
        w11[i] = -(v25 * v252);
        w12[i] = -(v25 * v263);
        w13[i] = -(v25 * v274);
        w14[i] = -(v25 * v285);
        w15[i] = ((v25 * v438) - v440) - v444;
        w16[i] = ((v25 * v511) - v440) - v444;
        w17[i] = (v25 * v518) + (v31 * v516);
        w18[i] = (v25 * v525) + (v31 * v523);
        w19[i] = (v25 * v532) + (v31 * v530);
        w20[i] = v542;
        w21[i] = v542;
        w22[i] = (v25 * v546) + (v31 * v544);
        w23[i] = (v25 * v553) + (v31 * v551);
        w24[i] = (v25 * v560) + (v31 * v558);
        w25[i] = (v25 * v665) - v667;
        w26[i] = (v25 * v725) + v667;
        w27[i] = (v25 * v825) - (v31 * v793);
        w28[i] = (v25 * v907) - (v31 * v879);
        w4[i] = (v198 * v31) + (v164 * v25);
        w29[i] = -(v31 * v210);
        w30[i] = -(v31 * v221);
        w31[i] = -(v31 * v232);
        w32[i] = -(v31 * v243);
        w33[i] = -(v31 * v252);
        w34[i] = -(v31 * v263);
        w35[i] = -(v31 * v274);
        w36[i] = -(v31 * v285);
        w37[i] = ((v31 * v438) + v931) - v935;
        w38[i] = ((v31 * v511) + v931) - v935;
        w39[i] = (v31 * v518) - (v25 * v516);
        w40[i] = (v31 * v525) - (v25 * v523);
        w41[i] = (v31 * v532) - (v25 * v530);
        w42[i] = v951;
        w43[i] = v951;
        w44[i] = (v31 * v546) - (v25 * v544);
        w45[i] = (v31 * v553) - (v25 * v551);
        w46[i] = (v31 * v560) - (v25 * v558);
        w47[i] = (v31 * v665) + v962;
        w48[i] = (v31 * v725) - v962;
        w49[i] = (v31 * v825) + (v25 * v793);
        w50[i] = (v31 * v907) + (v25 * v879);
        w5[i] = (v972 * (v163 - (v117 * v198))) * 0.5;
        w51[i] = 0.5 * (v972 * (v117 * v210));
        w52[i] = 0.5 * (v972 * (v117 * v221));
        w53[i] = 0.5 * (v972 * (v117 * v232));
        w54[i] = 0.5 * (v972 * (v117 * v243));
        w55[i] = 0.5 * (v972 * (v117 * v252));
        w56[i] = 0.5 * (v972 * (v117 * v263));
        w57[i] = 0.5 * (v972 * (v117 * v274));
        w58[i] = 0.5 * (v972 * (v117 * v285));
        w59[i] = -(0.5 * (v972 * (v398 + ((v117 * v438) - v1002))));
        w60[i] = -(0.5 * (v972 * (v398 + ((v117 * v511) - v1002))));
        w61[i] = -(0.5 * (v972 * (c515 + (v117 * v518))));
        w62[i] = -(0.5 * (v972 * (c522 + (v117 * v525))));
        w63[i] = -(0.5 * (v972 * (c529 + (v117 * v532))));
        w64[i] = v1033;
        w65[i] = v1033;
        w66[i] = -(0.5 * (v972 * (c543 + (v117 * v546))));
        w67[i] = -(0.5 * (v972 * (c550 + (v117 * v553))));
        w68[i] = -(0.5 * (v972 * (c557 + (v117 * v560))));
        w69[i] = 0.5 * (v972 * (v631 - (v1049 + (v117 * v665))));
        w70[i] = -(0.5 * (v972 * (v631 + ((v117 * v725) - v1049))));
        w71[i] = 0.5 * (v972 * (v790 - ((v117 * v825) - v1062)));
        w72[i] = 0.5 * (v972 * (v877 - (v1062 + (v117 * v907))));
        w6[i] = -v194;
        w73[i] = v206;
        w74[i] = v217;
        w75[i] = v228;
        w76[i] = v239;
        w77[i] = v248;
        w78[i] = v259;
        w79[i] = v270;
        w80[i] = v281;
        w81[i] = -v429;
        w82[i] = -v505;
        w83[i] = -v659;
        w84[i] = -v720;
        w85[i] = -v819;
        w86[i] = -v902;
        e[254 * i + 129] = -(c1079 * ((v1103 * c1) + (v42 * v1118)));
        e[254 * i + 128] = c1079 * ((v1103 * v307) + (v42 * v1132));
        e[254 * i + 133] = c1079 * ((v1103 * v448) + (v42 * v1142));
        e[254 * i + 130] = -(c1079 * (v42 * v1151));
        e[254 * i + 126] = c1079 * ((v1103 * v572) + (v42 * v1163));
        e[254 * i + 131] = c1079 * ((v1103 * v670) + (v42 * v1173));
        e[254 * i + 127] = c1079 * ((v1103 * v734) + (v42 * v1185));
        e[254 * i + 132] = c1079 * ((v1103 * v830) + (v42 * v1197));
        e[254 * i + 137] = -(c1079 * ((v1209 * c1) + (v51 * v1222)));
        e[254 * i + 136] = c1079 * ((v1209 * v315) + (v51 * v1236));
        e[254 * i + 141] = c1079 * ((v1209 * v452) + (v51 * v1246));
        e[254 * i + 138] = -(c1079 * (v51 * v1255));
        e[254 * i + 134] = c1079 * ((v1209 * v576) + (v51 * v1267));
        e[254 * i + 139] = c1079 * ((v1209 * v673) + (v51 * v1277));
        e[254 * i + 135] = c1079 * ((v1209 * v738) + (v51 * v1289));
        e[254 * i + 140] = c1079 * ((v1209 * v833) + (v51 * v1301));
        e[254 * i + 145] = -(c1079 * ((v1313 * c1) + (v61 * v1326)));
        e[254 * i + 144] = c1079 * ((v1313 * v324) + (v61 * v1340));
        e[254 * i + 149] = c1079 * ((v1313 * v457) + (v61 * v1350));
        e[254 * i + 146] = -(c1079 * (v61 * v1359));
        e[254 * i + 142] = c1079 * ((v1313 * v581) + (v61 * v1371));
        e[254 * i + 147] = c1079 * ((v1313 * v677) + (v61 * v1381));
        e[254 * i + 143] = c1079 * ((v1313 * v743) + (v61 * v1393));
        e[254 * i + 148] = c1079 * ((v1313 * v837) + (v61 * v1405));
        e[254 * i + 153] = -(c1079 * ((v1417 * c1) + (v71 * v1430)));
        e[254 * i + 152] = c1079 * ((v1417 * v333) + (v71 * v1444));
        e[254 * i + 157] = c1079 * ((v1417 * v462) + (v71 * v1454));
        e[254 * i + 154] = -(c1079 * (v71 * v1463));
        e[254 * i + 150] = c1079 * ((v1417 * v586) + (v71 * v1475));
        e[254 * i + 155] = c1079 * ((v1417 * v681) + (v71 * v1485));
        e[254 * i + 151] = c1079 * ((v1417 * v748) + (v71 * v1497));
        e[254 * i + 156] = c1079 * ((v1417 * v841) + (v71 * v1509));
        e[254 * i + 161] = -(c1079 * ((v1521 * c1) + (v80 * v1534)));
        e[254 * i + 160] = c1079 * ((v1521 * v342) + (v80 * v1548));
        e[254 * i + 165] = c1079 * ((v1521 * v467) + (v80 * v1558));
        e[254 * i + 162] = -(c1079 * (v80 * v1567));
        e[254 * i + 158] = c1079 * ((v1521 * v591) + (v80 * v1579));
        e[254 * i + 163] = c1079 * ((v1521 * v685) + (v80 * v1589));
        e[254 * i + 159] = c1079 * ((v1521 * v753) + (v80 * v1601));
        e[254 * i + 164] = c1079 * ((v1521 * v845) + (v80 * v1613));
        e[254 * i + 169] = -(c1079 * ((v1625 * c1) + (v90 * v1638)));
        e[254 * i + 168] = c1079 * ((v1625 * v351) + (v90 * v1652));
        e[254 * i + 173] = c1079 * ((v1625 * v472) + (v90 * v1662));
        e[254 * i + 170] = -(c1079 * (v90 * v1671));
        e[254 * i + 166] = c1079 * ((v1625 * v596) + (v90 * v1683));
        e[254 * i + 171] = c1079 * ((v1625 * v689) + (v90 * v1693));
        e[254 * i + 167] = c1079 * ((v1625 * v758) + (v90 * v1705));
        e[254 * i + 172] = c1079 * ((v1625 * v849) + (v90 * v1717));
        e[254 * i + 177] = -(c1079 * ((v1729 * c1) + (v100 * v1742)));
        e[254 * i + 176] = c1079 * ((v1729 * v360) + (v100 * v1756));
        e[254 * i + 181] = c1079 * ((v1729 * v477) + (v100 * v1766));
        e[254 * i + 178] = -(c1079 * (v100 * v1775));
        e[254 * i + 174] = c1079 * ((v1729 * v601) + (v100 * v1787));
        e[254 * i + 179] = c1079 * ((v1729 * v693) + (v100 * v1797));
        e[254 * i + 175] = c1079 * ((v1729 * v763) + (v100 * v1809));
        e[254 * i + 180] = c1079 * ((v1729 * v853) + (v100 * v1821));
        e[254 * i + 185] = -(c1079 * ((v1833 * c1) + (v110 * v1846)));
        e[254 * i + 184] = c1079 * ((v1833 * v369) + (v110 * v1860));
        e[254 * i + 189] = c1079 * ((v1833 * v482) + (v110 * v1870));
        e[254 * i + 186] = -(c1079 * (v110 * v1879));
        e[254 * i + 182] = c1079 * ((v1833 * v606) + (v110 * v1891));
        e[254 * i + 187] = c1079 * ((v1833 * v697) + (v110 * v1901));
        e[254 * i + 183] = c1079 * ((v1833 * v768) + (v110 * v1913));
        e[254 * i + 188] = c1079 * ((v1833 * v857) + (v110 * v1925));
        e[254 * i + 193] = -(c1079 * (v1929 * v1118));
        e[254 * i + 192] = c1079 * ((v1929 * v1132) - v1935);
        e[254 * i + 197] = c1079 * ((v1929 * v1142) - v1935);
        e[254 * i + 194] = -(c1079 * ((v1103 * c1941) + (v1929 * v1151)));
        e[254 * i + 190] = c1079 * (v1948 + (v1929 * v1163));
        e[254 * i + 195] = c1079 * ((v1929 * v1173) - v1948);
        e[254 * i + 191] = c1079 * ((v1103 * v1955) + (v1929 * v1185));
        e[254 * i + 196] = c1079 * ((v1103 * v1960) + (v1929 * v1197));
        e[254 * i + 201] = -(c1079 * (v1965 * v1222));
        e[254 * i + 200] = c1079 * ((v1965 * v1236) - v1970);
        e[254 * i + 205] = c1079 * ((v1965 * v1246) - v1970);
        e[254 * i + 202] = -(c1079 * ((v1209 * c1941) + (v1965 * v1255)));
        e[254 * i + 198] = c1079 * (v1981 + (v1965 * v1267));
        e[254 * i + 203] = c1079 * ((v1965 * v1277) - v1981);
        e[254 * i + 199] = c1079 * ((v1209 * v1955) + (v1965 * v1289));
        e[254 * i + 204] = c1079 * ((v1209 * v1960) + (v1965 * v1301));
        e[254 * i + 209] = -(c1079 * (v1996 * v1326));
        e[254 * i + 208] = c1079 * ((v1996 * v1340) - v2001);
        e[254 * i + 213] = c1079 * ((v1996 * v1350) - v2001);
        e[254 * i + 210] = -(c1079 * ((v1313 * c1941) + (v1996 * v1359)));
        e[254 * i + 206] = c1079 * (v2012 + (v1996 * v1371));
        e[254 * i + 211] = c1079 * ((v1996 * v1381) - v2012);
        e[254 * i + 207] = c1079 * ((v1313 * v1955) + (v1996 * v1393));
        e[254 * i + 212] = c1079 * ((v1313 * v1960) + (v1996 * v1405));
        e[254 * i + 217] = -(c1079 * (v2027 * v1430));
        e[254 * i + 216] = c1079 * ((v2027 * v1444) - v2032);
        e[254 * i + 221] = c1079 * ((v2027 * v1454) - v2032);
        e[254 * i + 218] = -(c1079 * ((v1417 * c1941) + (v2027 * v1463)));
        e[254 * i + 214] = c1079 * (v2043 + (v2027 * v1475));
        e[254 * i + 219] = c1079 * ((v2027 * v1485) - v2043);
        e[254 * i + 215] = c1079 * ((v1417 * v1955) + (v2027 * v1497));
        e[254 * i + 220] = c1079 * ((v1417 * v1960) + (v2027 * v1509));
        e[254 * i + 225] = -(c1079 * (v2058 * v1534));
        e[254 * i + 224] = c1079 * ((v2058 * v1548) - v2063);
        e[254 * i + 229] = c1079 * ((v2058 * v1558) - v2063);
        e[254 * i + 226] = -(c1079 * ((v1521 * c1941) + (v2058 * v1567)));
        e[254 * i + 222] = c1079 * (v2074 + (v2058 * v1579));
        e[254 * i + 227] = c1079 * ((v2058 * v1589) - v2074);
        e[254 * i + 223] = c1079 * ((v1521 * v1955) + (v2058 * v1601));
        e[254 * i + 228] = c1079 * ((v1521 * v1960) + (v2058 * v1613));
        e[254 * i + 233] = -(c1079 * (v2089 * v1638));
        e[254 * i + 232] = c1079 * ((v2089 * v1652) - v2094);
        e[254 * i + 237] = c1079 * ((v2089 * v1662) - v2094);
        e[254 * i + 234] = -(c1079 * ((v1625 * c1941) + (v2089 * v1671)));
        e[254 * i + 230] = c1079 * (v2105 + (v2089 * v1683));
        e[254 * i + 235] = c1079 * ((v2089 * v1693) - v2105);
        e[254 * i + 231] = c1079 * ((v1625 * v1955) + (v2089 * v1705));
        e[254 * i + 236] = c1079 * ((v1625 * v1960) + (v2089 * v1717));
        e[254 * i + 241] = -(c1079 * (v2120 * v1742));
        e[254 * i + 240] = c1079 * ((v2120 * v1756) - v2125);
        e[254 * i + 245] = c1079 * ((v2120 * v1766) - v2125);
        e[254 * i + 242] = -(c1079 * ((v1729 * c1941) + (v2120 * v1775)));
        e[254 * i + 238] = c1079 * (v2136 + (v2120 * v1787));
        e[254 * i + 243] = c1079 * ((v2120 * v1797) - v2136);
        e[254 * i + 239] = c1079 * ((v1729 * v1955) + (v2120 * v1809));
        e[254 * i + 244] = c1079 * ((v1729 * v1960) + (v2120 * v1821));
        e[254 * i + 249] = -(c1079 * (v2151 * v1846));
        e[254 * i + 248] = c1079 * ((v2151 * v1860) - v2156);
        e[254 * i + 253] = c1079 * ((v2151 * v1870) - v2156);
        e[254 * i + 250] = -(c1079 * ((v1833 * c1941) + (v2151 * v1879)));
        e[254 * i + 246] = c1079 * (v2167 + (v2151 * v1891));
        e[254 * i + 251] = c1079 * ((v2151 * v1901) - v2167);
        e[254 * i + 247] = c1079 * ((v1833 * v1955) + (v2151 * v1913));
        e[254 * i + 252] = c1079 * ((v1833 * v1960) + (v2151 * v1925));
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
    const double c65 = p[7];
    const double c66 = squared(c65);
    const double c67 = 1.0 / c66;
    const double c70 = squared(c2);
    const double c71 = 1e-18 * c70;
    const double c72 = c71 / c66;
    const double c75 = 0.5 / p[8];
    const double c76 = (-0.5) + c75;
    const double c78 = 1.0 / c65;
    const double c243 = p[9];
    const double c245 = c11 / c243;
    const double c246 = squared(c245);
    const double c247 = p[2] * c246;
    const double c248 = c243 / c247;
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
        const double v41 = ((((-0.9396926207859083) * v15) * v36) - y[22 * i + 6]) + v40;
        const double v54 = ((v30 * v25) - (v20 * v31)) / v33;
        const double v60 = squared((c2 * v41)) + (3.0 * squared((c50 * (v54 - y[22 * i + 14]))));
        const double v64 = larger(v60, c63);
        const double v81 = 0.025995061875669127 * (v64 * (pow((v64 * c67) + c72, c76) * c78));
        const double v88 = ((((-0.7660444431189779) * v15) * v36) - y[22 * i + 7]) + v40;
        const double v96 = squared((c2 * v88)) + (3.0 * squared((c50 * (v54 - y[22 * i + 15]))));
        const double v97 = larger(v96, c63);
        const double v103 = 0.09181686914811889 * (v97 * (pow((v97 * c67) + c72, c76) * c78));
        const double v111 = ((((-0.4999999999999998) * v15) * v36) - y[22 * i + 8]) + v40;
        const double v119 = squared((c2 * v111)) + (3.0 * squared((c50 * (v54 - y[22 * i + 16]))));
        const double v120 = larger(v119, c63);
        const double v126 = 0.16666666666666669 * (v120 * (pow((v120 * c67) + c72, c76) * c78));
        const double v134 = ((((-0.1736481776669303) * v15) * v36) - y[22 * i + 9]) + v40;
        const double v142 = squared((c2 * v134)) + (3.0 * squared((c50 * (v54 - y[22 * i + 17]))));
        const double v143 = larger(v142, c63);
        const double v149 = 0.21552140230954533 * (v143 * (pow((v143 * c67) + c72, c76) * c78));
        const double v156 = (((0.17364817766693041 * v15) * v36) - y[22 * i + 10]) + v40;
        const double v164 = squared((c2 * v156)) + (3.0 * squared((c50 * (v54 - y[22 * i + 18]))));
        const double v165 = larger(v164, c63);
        const double v171 = 0.21552140230954533 * (v165 * (pow((v165 * c67) + c72, c76) * c78));
        const double v179 = (((0.5000000000000001 * v15) * v36) - y[22 * i + 11]) + v40;
        const double v187 = squared((c2 * v179)) + (3.0 * squared((c50 * (v54 - y[22 * i + 19]))));
        const double v188 = larger(v187, c63);
        const double v194 = 0.16666666666666663 * (v188 * (pow((v188 * c67) + c72, c76) * c78));
        const double v202 = (((0.766044443118978 * v15) * v36) - y[22 * i + 12]) + v40;
        const double v210 = squared((c2 * v202)) + (3.0 * squared((c50 * (v54 - y[22 * i + 20]))));
        const double v211 = larger(v210, c63);
        const double v217 = 0.09181686914811883 * (v211 * (pow((v211 * c67) + c72, c76) * c78));
        const double v225 = (((0.9396926207859084 * v15) * v36) - y[22 * i + 13]) + v40;
        const double v233 = squared((c2 * v225)) + (3.0 * squared((c50 * (v54 - y[22 * i + 21]))));
        const double v234 = larger(v233, c63);
        const double v240 = 0.025995061875669103 * (v234 * (pow((v234 * c67) + c72, c76) * c78));
        const double v241 = ((((((v81 + v103) + v126) + v149) + v171) + v194) + v217) + v240;
        q[0] += (g[7 * i + 1] * v241) * c248;
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
    const double c70 = p[7];
    const double c71 = squared(c70);
    const double c72 = 1.0 / c71;
    const double c75 = squared(c0);
    const double c76 = 1e-18 * c75;
    const double c77 = c76 / c71;
    const double c80 = 0.5 / p[8];
    const double c81 = (-0.5) + c80;
    const double c83 = 1.0 / c70;
    const double c86 = p[9];
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
        const double v36 = ((-0.9396926207859083) * v14) * v35;
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
        const double v93 = 0.025995061875669127 * v92;
        const double v103 = ((pow(v78, c81) * c83) * v93) + (((c81 * pow(v78, c96)) * ((v69 * v93) * c83)) * c72);
        const double v104 = (v65 / (v65 + (double)(v64 <= c45))) * v103;
        const double v106 = c0 * ((2.0 * v41) * v104);
        const double v110 = ((-0.7660444431189779) * v14) * v35;
        const double v114 = c0 * ((v110 - y[22 * i + 7]) + v39);
        const double v119 = c53 * (v58 - y[22 * i + 15]);
        const double v122 = squared(v114) + (3.0 * squared(v119));
        const double v123 = (double)(c45 <= v122);
        const double v127 = larger(v122, c45);
        const double v129 = (v127 * c72) + c77;
        const double v133 = 0.09181686914811889 * v92;
        const double v141 = ((pow(v129, c81) * c83) * v133) + (((c81 * pow(v129, c96)) * ((v127 * v133) * c83)) * c72);
        const double v142 = (v123 / (v123 + (double)(v122 <= c45))) * v141;
        const double v144 = c0 * ((2.0 * v114) * v142);
        const double v148 = ((-0.4999999999999998) * v14) * v35;
        const double v152 = c0 * ((v148 - y[22 * i + 8]) + v39);
        const double v157 = c53 * (v58 - y[22 * i + 16]);
        const double v160 = squared(v152) + (3.0 * squared(v157));
        const double v161 = (double)(c45 <= v160);
        const double v165 = larger(v160, c45);
        const double v167 = (v165 * c72) + c77;
        const double v171 = 0.16666666666666669 * v92;
        const double v179 = ((pow(v167, c81) * c83) * v171) + (((c81 * pow(v167, c96)) * ((v165 * v171) * c83)) * c72);
        const double v180 = (v161 / (v161 + (double)(v160 <= c45))) * v179;
        const double v182 = c0 * ((2.0 * v152) * v180);
        const double v186 = ((-0.1736481776669303) * v14) * v35;
        const double v190 = c0 * ((v186 - y[22 * i + 9]) + v39);
        const double v195 = c53 * (v58 - y[22 * i + 17]);
        const double v198 = squared(v190) + (3.0 * squared(v195));
        const double v199 = (double)(c45 <= v198);
        const double v203 = larger(v198, c45);
        const double v205 = (v203 * c72) + c77;
        const double v209 = 0.21552140230954533 * v92;
        const double v217 = ((pow(v205, c81) * c83) * v209) + (((c81 * pow(v205, c96)) * ((v203 * v209) * c83)) * c72);
        const double v218 = (v199 / (v199 + (double)(v198 <= c45))) * v217;
        const double v220 = c0 * ((2.0 * v190) * v218);
        const double v224 = (0.17364817766693041 * v14) * v35;
        const double v228 = c0 * ((v224 - y[22 * i + 10]) + v39);
        const double v233 = c53 * (v58 - y[22 * i + 18]);
        const double v236 = squared(v228) + (3.0 * squared(v233));
        const double v237 = (double)(c45 <= v236);
        const double v241 = larger(v236, c45);
        const double v243 = (v241 * c72) + c77;
        const double v253 = ((pow(v243, c81) * c83) * v209) + (((c81 * pow(v243, c96)) * ((v241 * v209) * c83)) * c72);
        const double v254 = (v237 / (v237 + (double)(v236 <= c45))) * v253;
        const double v256 = c0 * ((2.0 * v228) * v254);
        const double v260 = (0.5000000000000001 * v14) * v35;
        const double v264 = c0 * ((v260 - y[22 * i + 11]) + v39);
        const double v269 = c53 * (v58 - y[22 * i + 19]);
        const double v272 = squared(v264) + (3.0 * squared(v269));
        const double v273 = (double)(c45 <= v272);
        const double v277 = larger(v272, c45);
        const double v279 = (v277 * c72) + c77;
        const double v283 = 0.16666666666666663 * v92;
        const double v291 = ((pow(v279, c81) * c83) * v283) + (((c81 * pow(v279, c96)) * ((v277 * v283) * c83)) * c72);
        const double v292 = (v273 / (v273 + (double)(v272 <= c45))) * v291;
        const double v294 = c0 * ((2.0 * v264) * v292);
        const double v298 = (0.766044443118978 * v14) * v35;
        const double v302 = c0 * ((v298 - y[22 * i + 12]) + v39);
        const double v307 = c53 * (v58 - y[22 * i + 20]);
        const double v310 = squared(v302) + (3.0 * squared(v307));
        const double v311 = (double)(c45 <= v310);
        const double v315 = larger(v310, c45);
        const double v317 = (v315 * c72) + c77;
        const double v321 = 0.09181686914811883 * v92;
        const double v329 = ((pow(v317, c81) * c83) * v321) + (((c81 * pow(v317, c96)) * ((v315 * v321) * c83)) * c72);
        const double v330 = (v311 / (v311 + (double)(v310 <= c45))) * v329;
        const double v332 = c0 * ((2.0 * v302) * v330);
        const double v336 = (0.9396926207859084 * v14) * v35;
        const double v340 = c0 * ((v336 - y[22 * i + 13]) + v39);
        const double v345 = c53 * (v58 - y[22 * i + 21]);
        const double v348 = squared(v340) + (3.0 * squared(v345));
        const double v349 = (double)(c45 <= v348);
        const double v353 = larger(v348, c45);
        const double v355 = (v353 * c72) + c77;
        const double v359 = 0.025995061875669103 * v92;
        const double v367 = ((pow(v355, c81) * c83) * v359) + (((c81 * pow(v355, c96)) * ((v353 * v359) * c83)) * c72);
        const double v368 = (v349 / (v349 + (double)(v348 <= c45))) * v367;
        const double v370 = c0 * ((2.0 * v340) * v368);
        const double v373 = v58 * v57;
        const double v377 = c53 * ((2.0 * v345) * (3.0 * v368));
        const double v381 = (v336 * v35) * v370;
        const double v386 = 1.0 / (2.0 * v33);
        const double v388 = (((v370 * v57) - (v373 * v377)) - (v33 * v381)) - ((v32 * v381) * v386);
        const double v392 = c53 * ((2.0 * v307) * (3.0 * v330));
        const double v398 = (v298 * v35) * v332;
        const double v403 = (((v388 - (v373 * v392)) + (v332 * v57)) - (v33 * v398)) - ((v32 * v398) * v386);
        const double v407 = c53 * ((2.0 * v269) * (3.0 * v292));
        const double v413 = (v260 * v35) * v294;
        const double v418 = (((v403 - (v373 * v407)) + (v294 * v57)) - (v33 * v413)) - ((v32 * v413) * v386);
        const double v422 = c53 * ((2.0 * v233) * (3.0 * v254));
        const double v428 = (v224 * v35) * v256;
        const double v433 = (((v418 - (v373 * v422)) + (v256 * v57)) - (v33 * v428)) - ((v32 * v428) * v386);
        const double v437 = c53 * ((2.0 * v195) * (3.0 * v218));
        const double v443 = (v186 * v35) * v220;
        const double v448 = (((v433 - (v373 * v437)) + (v220 * v57)) - (v33 * v443)) - ((v32 * v443) * v386);
        const double v452 = c53 * ((2.0 * v157) * (3.0 * v180));
        const double v458 = (v148 * v35) * v182;
        const double v463 = (((v448 - (v373 * v452)) + (v182 * v57)) - (v33 * v458)) - ((v32 * v458) * v386);
        const double v467 = c53 * ((2.0 * v119) * (3.0 * v142));
        const double v473 = (v110 * v35) * v144;
        const double v478 = (((v463 - (v373 * v467)) + (v144 * v57)) - (v33 * v473)) - ((v32 * v473) * v386);
        const double v482 = c53 * ((2.0 * v61) * (3.0 * v104));
        const double v488 = (v36 * v35) * v106;
        const double v493 = (((v478 - (v373 * v482)) + (v106 * v57)) - (v33 * v488)) - ((v32 * v488) * v386);
        const double v501 = (((v377 * v57) + (v392 * v57)) + (v407 * v57)) + (v422 * v57);
        const double v509 = (((v501 + (v437 * v57)) + (v452 * v57)) + (v467 * v57)) + (v482 * v57);
        const double v517 = (v24 * ((v29 * v493) - (v19 * v509))) - (v30 * ((v29 * v509) + (v19 * v493)));
        const double v518 = 0.5 * v517;
        const double v525 = (c4 * (0.9396926207859084 * (v370 * v35))) + (c4 * (0.766044443118978 * (v332 * v35)));
        const double v533 = (v525 + (c4 * (0.5000000000000001 * (v294 * v35)))) + (c4 * (0.17364817766693041 * (v256 * v35)));
        const double v541 = (v533 + (c4 * ((-0.1736481776669303) * (v220 * v35)))) + (c4 * ((-0.4999999999999998) * (v182 * v35)));
        const double v549 = (v541 + (c4 * ((-0.7660444431189779) * (v144 * v35)))) + (c4 * ((-0.9396926207859083) * (v106 * v35)));
        const double v550 = v12 * v549;
        const double v564 = ((v24 * v493) - (v30 * v509)) * v9;
        const double v569 = ((v24 * v509) + (v30 * v493)) * v9;
        s[22 * i + 6] += -v106;
        s[22 * i + 7] += -v144;
        s[22 * i + 8] += -v182;
        s[22 * i + 9] += -v220;
        s[22 * i + 10] += -v256;
        s[22 * i + 11] += -v294;
        s[22 * i + 12] += -v332;
        s[22 * i + 13] += -v370;
        s[22 * i + 4] += v518 - v550;
        s[22 * i + 26] += v518 + v550;
        s[22 * i + 14] += -v482;
        s[22 * i + 15] += -v467;
        s[22 * i + 16] += -v452;
        s[22 * i + 17] += -v437;
        s[22 * i + 18] += -v422;
        s[22 * i + 19] += -v407;
        s[22 * i + 20] += -v392;
        s[22 * i + 21] += -v377;
        s[22 * i] += -v564;
        s[22 * i + 22] += v564;
        s[22 * i + 1] += -v569;
        s[22 * i + 23] += v569;
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
    "rest_length", "thickness", "density", "gravity", "ramp", "youngs_modulus", "poisson",
    "viscosity", "index", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "s", "Pa", "1", "Pa*s^n", "1", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE,
    SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.1, 0.015, 1100.0, 9.81, 0.5, 30000.0, 0.45, 10211.718159726757, 0.3, 0.10096375546923045};
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
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, (-0.9396926207859083), (-0.7660444431189779),
    (-0.4999999999999998), (-0.1736481776669303), 0.17364817766693041, 0.5000000000000001,
    0.766044443118978, 0.9396926207859084, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Rope of bread dough, shear-thinning",
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
