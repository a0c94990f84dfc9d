/*
 * Transient gel that flows by Eyring's law
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, gravity-ramp, shear, fibres, rotary-inertia
 * Digest of the structure: 1f0eebb3b7a3ab63d75ba08768c1aad15fb2ad9035df572702096a0f1826e2fc
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
    const double c222 = 1.0 / p[7];
    const double c226 = 1.0 / p[8];
    const double c230 = p[9];
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
        const double v220 = sqrt(larger(squared(v42) + (3.0 * squared(v127)), c218));
        const double v228 = (sinh(v220 * c222) * c226) / v220;
        const double v237 = sqrt(larger(squared(v51) + (3.0 * squared(v131)), c218));
        const double v241 = (sinh(v237 * c222) * c226) / v237;
        const double v249 = sqrt(larger(squared(v61) + (3.0 * squared(v136)), c218));
        const double v253 = (sinh(v249 * c222) * c226) / v249;
        const double v261 = sqrt(larger(squared(v71) + (3.0 * squared(v141)), c218));
        const double v265 = (sinh(v261 * c222) * c226) / v261;
        const double v273 = sqrt(larger(squared(v80) + (3.0 * squared(v146)), c218));
        const double v277 = (sinh(v273 * c222) * c226) / v273;
        const double v285 = sqrt(larger(squared(v90) + (3.0 * squared(v151)), c218));
        const double v289 = (sinh(v285 * c222) * c226) / v285;
        const double v297 = sqrt(larger(squared(v100) + (3.0 * squared(v156)), c218));
        const double v301 = (sinh(v297 * c222) * c226) / v297;
        const double v309 = sqrt(larger(squared(v110) + (3.0 * squared(v161)), c218));
        const double v313 = (sinh(v309 * c222) * c226) / v309;
        w3[i] = (v198 * v25) - (v164 * v31);
        w4[i] = (v198 * v31) + (v164 * v25);
        w5[i] = ((g[7 * i + 1] * c11) * (v163 - (v117 * v198))) * 0.5;
        w6[i] = -v194;
        f[22 * i + 6] = (v42 * v228) * c230;
        f[22 * i + 7] = (v51 * v241) * c230;
        f[22 * i + 8] = (v61 * v253) * c230;
        f[22 * i + 9] = (v71 * v265) * c230;
        f[22 * i + 10] = (v80 * v277) * c230;
        f[22 * i + 11] = (v90 * v289) * c230;
        f[22 * i + 12] = (v100 * v301) * c230;
        f[22 * i + 13] = (v110 * v313) * c230;
        f[22 * i + 14] = ((3.0 * v127) * v228) * c230;
        f[22 * i + 15] = ((3.0 * v131) * v241) * c230;
        f[22 * i + 16] = ((3.0 * v136) * v253) * c230;
        f[22 * i + 17] = ((3.0 * v141) * v265) * c230;
        f[22 * i + 18] = ((3.0 * v146) * v277) * c230;
        f[22 * i + 19] = ((3.0 * v151) * v289) * c230;
        f[22 * i + 20] = ((3.0 * v156) * v301) * c230;
        f[22 * i + 21] = ((3.0 * v161) * v313) * c230;
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
    const double c1091 = 1.0 / p[7];
    const double c1095 = 1.0 / p[8];
    const double c2204 = 3.0 * c123;
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
        const double v1089 = sqrt(larger(v1084, c1087));
        const double v1092 = v1089 * c1091;
        const double v1097 = 1.0 / v1089;
        const double v1098 = (sinh(v1092) * c1095) * v1097;
        const double v1099 = v1098 * v1097;
        const double v1100 = (double)(c1087 <= v1084);
        const double v1103 = v1100 / (v1100 + (double)(v1084 <= c1087));
        const double v1104 = 2.0 * v42;
        const double v1108 = 1.0 / (2.0 * v1089);
        const double v1109 = (v1103 * (v1104 * c1)) * v1108;
        const double v1111 = cosh(v1092);
        const double v1116 = (v1099 * v1109) - (((v1111 * (v1109 * c1091)) * c1095) * v1097);
        const double v1123 = 2.0 * v127;
        const double v1125 = 3.0 * (v1123 * v384);
        const double v1128 = (v1103 * ((v1104 * v307) - v1125)) * v1108;
        const double v1134 = (((v1111 * (v1128 * c1091)) * c1095) * v1097) - (v1099 * v1128);
        const double v1142 = (v1103 * ((v1104 * v448) - v1125)) * v1108;
        const double v1148 = (((v1111 * (v1142 * c1091)) * c1095) * v1097) - (v1099 * v1142);
        const double v1155 = (v1103 * (3.0 * (v1123 * c123))) * v1108;
        const double v1161 = (v1099 * v1155) - (((v1111 * (v1155 * c1091)) * c1095) * v1097);
        const double v1167 = 3.0 * (v1123 * v617);
        const double v1170 = (v1103 * ((v1104 * v572) + v1167)) * v1108;
        const double v1176 = (((v1111 * (v1170 * c1091)) * c1095) * v1097) - (v1099 * v1170);
        const double v1184 = (v1103 * ((v1104 * v670) - v1167)) * v1108;
        const double v1190 = (((v1111 * (v1184 * c1091)) * c1095) * v1097) - (v1099 * v1184);
        const double v1200 = (v1103 * ((v1104 * v734) + (3.0 * (v1123 * v776)))) * v1108;
        const double v1206 = (((v1111 * (v1200 * c1091)) * c1095) * v1097) - (v1099 * v1200);
        const double v1216 = (v1103 * ((v1104 * v830) + (3.0 * (v1123 * v863)))) * v1108;
        const double v1222 = (((v1111 * (v1216 * c1091)) * c1095) * v1097) - (v1099 * v1216);
        const double v1229 = squared(v51) + (3.0 * squared(v131));
        const double v1231 = sqrt(larger(v1229, c1087));
        const double v1232 = v1231 * c1091;
        const double v1235 = 1.0 / v1231;
        const double v1236 = (sinh(v1232) * c1095) * v1235;
        const double v1237 = v1236 * v1235;
        const double v1238 = (double)(c1087 <= v1229);
        const double v1241 = v1238 / (v1238 + (double)(v1229 <= c1087));
        const double v1242 = 2.0 * v51;
        const double v1246 = 1.0 / (2.0 * v1231);
        const double v1247 = (v1241 * (v1242 * c1)) * v1246;
        const double v1249 = cosh(v1232);
        const double v1254 = (v1237 * v1247) - (((v1249 * (v1247 * c1091)) * c1095) * v1235);
        const double v1261 = 2.0 * v131;
        const double v1263 = 3.0 * (v1261 * v384);
        const double v1266 = (v1241 * ((v1242 * v315) - v1263)) * v1246;
        const double v1272 = (((v1249 * (v1266 * c1091)) * c1095) * v1235) - (v1237 * v1266);
        const double v1280 = (v1241 * ((v1242 * v452) - v1263)) * v1246;
        const double v1286 = (((v1249 * (v1280 * c1091)) * c1095) * v1235) - (v1237 * v1280);
        const double v1293 = (v1241 * (3.0 * (v1261 * c123))) * v1246;
        const double v1299 = (v1237 * v1293) - (((v1249 * (v1293 * c1091)) * c1095) * v1235);
        const double v1305 = 3.0 * (v1261 * v617);
        const double v1308 = (v1241 * ((v1242 * v576) + v1305)) * v1246;
        const double v1314 = (((v1249 * (v1308 * c1091)) * c1095) * v1235) - (v1237 * v1308);
        const double v1322 = (v1241 * ((v1242 * v673) - v1305)) * v1246;
        const double v1328 = (((v1249 * (v1322 * c1091)) * c1095) * v1235) - (v1237 * v1322);
        const double v1338 = (v1241 * ((v1242 * v738) + (3.0 * (v1261 * v776)))) * v1246;
        const double v1344 = (((v1249 * (v1338 * c1091)) * c1095) * v1235) - (v1237 * v1338);
        const double v1354 = (v1241 * ((v1242 * v833) + (3.0 * (v1261 * v863)))) * v1246;
        const double v1360 = (((v1249 * (v1354 * c1091)) * c1095) * v1235) - (v1237 * v1354);
        const double v1367 = squared(v61) + (3.0 * squared(v136));
        const double v1369 = sqrt(larger(v1367, c1087));
        const double v1370 = v1369 * c1091;
        const double v1373 = 1.0 / v1369;
        const double v1374 = (sinh(v1370) * c1095) * v1373;
        const double v1375 = v1374 * v1373;
        const double v1376 = (double)(c1087 <= v1367);
        const double v1379 = v1376 / (v1376 + (double)(v1367 <= c1087));
        const double v1380 = 2.0 * v61;
        const double v1384 = 1.0 / (2.0 * v1369);
        const double v1385 = (v1379 * (v1380 * c1)) * v1384;
        const double v1387 = cosh(v1370);
        const double v1392 = (v1375 * v1385) - (((v1387 * (v1385 * c1091)) * c1095) * v1373);
        const double v1399 = 2.0 * v136;
        const double v1401 = 3.0 * (v1399 * v384);
        const double v1404 = (v1379 * ((v1380 * v324) - v1401)) * v1384;
        const double v1410 = (((v1387 * (v1404 * c1091)) * c1095) * v1373) - (v1375 * v1404);
        const double v1418 = (v1379 * ((v1380 * v457) - v1401)) * v1384;
        const double v1424 = (((v1387 * (v1418 * c1091)) * c1095) * v1373) - (v1375 * v1418);
        const double v1431 = (v1379 * (3.0 * (v1399 * c123))) * v1384;
        const double v1437 = (v1375 * v1431) - (((v1387 * (v1431 * c1091)) * c1095) * v1373);
        const double v1443 = 3.0 * (v1399 * v617);
        const double v1446 = (v1379 * ((v1380 * v581) + v1443)) * v1384;
        const double v1452 = (((v1387 * (v1446 * c1091)) * c1095) * v1373) - (v1375 * v1446);
        const double v1460 = (v1379 * ((v1380 * v677) - v1443)) * v1384;
        const double v1466 = (((v1387 * (v1460 * c1091)) * c1095) * v1373) - (v1375 * v1460);
        const double v1476 = (v1379 * ((v1380 * v743) + (3.0 * (v1399 * v776)))) * v1384;
        const double v1482 = (((v1387 * (v1476 * c1091)) * c1095) * v1373) - (v1375 * v1476);
        const double v1492 = (v1379 * ((v1380 * v837) + (3.0 * (v1399 * v863)))) * v1384;
        const double v1498 = (((v1387 * (v1492 * c1091)) * c1095) * v1373) - (v1375 * v1492);
        const double v1505 = squared(v71) + (3.0 * squared(v141));
        const double v1507 = sqrt(larger(v1505, c1087));
        const double v1508 = v1507 * c1091;
        const double v1511 = 1.0 / v1507;
        const double v1512 = (sinh(v1508) * c1095) * v1511;
        const double v1513 = v1512 * v1511;
        const double v1514 = (double)(c1087 <= v1505);
        const double v1517 = v1514 / (v1514 + (double)(v1505 <= c1087));
        const double v1518 = 2.0 * v71;
        const double v1522 = 1.0 / (2.0 * v1507);
        const double v1523 = (v1517 * (v1518 * c1)) * v1522;
        const double v1525 = cosh(v1508);
        const double v1530 = (v1513 * v1523) - (((v1525 * (v1523 * c1091)) * c1095) * v1511);
        const double v1537 = 2.0 * v141;
        const double v1539 = 3.0 * (v1537 * v384);
        const double v1542 = (v1517 * ((v1518 * v333) - v1539)) * v1522;
        const double v1548 = (((v1525 * (v1542 * c1091)) * c1095) * v1511) - (v1513 * v1542);
        const double v1556 = (v1517 * ((v1518 * v462) - v1539)) * v1522;
        const double v1562 = (((v1525 * (v1556 * c1091)) * c1095) * v1511) - (v1513 * v1556);
        const double v1569 = (v1517 * (3.0 * (v1537 * c123))) * v1522;
        const double v1575 = (v1513 * v1569) - (((v1525 * (v1569 * c1091)) * c1095) * v1511);
        const double v1581 = 3.0 * (v1537 * v617);
        const double v1584 = (v1517 * ((v1518 * v586) + v1581)) * v1522;
        const double v1590 = (((v1525 * (v1584 * c1091)) * c1095) * v1511) - (v1513 * v1584);
        const double v1598 = (v1517 * ((v1518 * v681) - v1581)) * v1522;
        const double v1604 = (((v1525 * (v1598 * c1091)) * c1095) * v1511) - (v1513 * v1598);
        const double v1614 = (v1517 * ((v1518 * v748) + (3.0 * (v1537 * v776)))) * v1522;
        const double v1620 = (((v1525 * (v1614 * c1091)) * c1095) * v1511) - (v1513 * v1614);
        const double v1630 = (v1517 * ((v1518 * v841) + (3.0 * (v1537 * v863)))) * v1522;
        const double v1636 = (((v1525 * (v1630 * c1091)) * c1095) * v1511) - (v1513 * v1630);
        const double v1643 = squared(v80) + (3.0 * squared(v146));
        const double v1645 = sqrt(larger(v1643, c1087));
        const double v1646 = v1645 * c1091;
        const double v1649 = 1.0 / v1645;
        const double v1650 = (sinh(v1646) * c1095) * v1649;
        const double v1651 = v1650 * v1649;
        const double v1652 = (double)(c1087 <= v1643);
        const double v1655 = v1652 / (v1652 + (double)(v1643 <= c1087));
        const double v1656 = 2.0 * v80;
        const double v1660 = 1.0 / (2.0 * v1645);
        const double v1661 = (v1655 * (v1656 * c1)) * v1660;
        const double v1663 = cosh(v1646);
        const double v1668 = (v1651 * v1661) - (((v1663 * (v1661 * c1091)) * c1095) * v1649);
        const double v1675 = 2.0 * v146;
        const double v1677 = 3.0 * (v1675 * v384);
        const double v1680 = (v1655 * ((v1656 * v342) - v1677)) * v1660;
        const double v1686 = (((v1663 * (v1680 * c1091)) * c1095) * v1649) - (v1651 * v1680);
        const double v1694 = (v1655 * ((v1656 * v467) - v1677)) * v1660;
        const double v1700 = (((v1663 * (v1694 * c1091)) * c1095) * v1649) - (v1651 * v1694);
        const double v1707 = (v1655 * (3.0 * (v1675 * c123))) * v1660;
        const double v1713 = (v1651 * v1707) - (((v1663 * (v1707 * c1091)) * c1095) * v1649);
        const double v1719 = 3.0 * (v1675 * v617);
        const double v1722 = (v1655 * ((v1656 * v591) + v1719)) * v1660;
        const double v1728 = (((v1663 * (v1722 * c1091)) * c1095) * v1649) - (v1651 * v1722);
        const double v1736 = (v1655 * ((v1656 * v685) - v1719)) * v1660;
        const double v1742 = (((v1663 * (v1736 * c1091)) * c1095) * v1649) - (v1651 * v1736);
        const double v1752 = (v1655 * ((v1656 * v753) + (3.0 * (v1675 * v776)))) * v1660;
        const double v1758 = (((v1663 * (v1752 * c1091)) * c1095) * v1649) - (v1651 * v1752);
        const double v1768 = (v1655 * ((v1656 * v845) + (3.0 * (v1675 * v863)))) * v1660;
        const double v1774 = (((v1663 * (v1768 * c1091)) * c1095) * v1649) - (v1651 * v1768);
        const double v1781 = squared(v90) + (3.0 * squared(v151));
        const double v1783 = sqrt(larger(v1781, c1087));
        const double v1784 = v1783 * c1091;
        const double v1787 = 1.0 / v1783;
        const double v1788 = (sinh(v1784) * c1095) * v1787;
        const double v1789 = v1788 * v1787;
        const double v1790 = (double)(c1087 <= v1781);
        const double v1793 = v1790 / (v1790 + (double)(v1781 <= c1087));
        const double v1794 = 2.0 * v90;
        const double v1798 = 1.0 / (2.0 * v1783);
        const double v1799 = (v1793 * (v1794 * c1)) * v1798;
        const double v1801 = cosh(v1784);
        const double v1806 = (v1789 * v1799) - (((v1801 * (v1799 * c1091)) * c1095) * v1787);
        const double v1813 = 2.0 * v151;
        const double v1815 = 3.0 * (v1813 * v384);
        const double v1818 = (v1793 * ((v1794 * v351) - v1815)) * v1798;
        const double v1824 = (((v1801 * (v1818 * c1091)) * c1095) * v1787) - (v1789 * v1818);
        const double v1832 = (v1793 * ((v1794 * v472) - v1815)) * v1798;
        const double v1838 = (((v1801 * (v1832 * c1091)) * c1095) * v1787) - (v1789 * v1832);
        const double v1845 = (v1793 * (3.0 * (v1813 * c123))) * v1798;
        const double v1851 = (v1789 * v1845) - (((v1801 * (v1845 * c1091)) * c1095) * v1787);
        const double v1857 = 3.0 * (v1813 * v617);
        const double v1860 = (v1793 * ((v1794 * v596) + v1857)) * v1798;
        const double v1866 = (((v1801 * (v1860 * c1091)) * c1095) * v1787) - (v1789 * v1860);
        const double v1874 = (v1793 * ((v1794 * v689) - v1857)) * v1798;
        const double v1880 = (((v1801 * (v1874 * c1091)) * c1095) * v1787) - (v1789 * v1874);
        const double v1890 = (v1793 * ((v1794 * v758) + (3.0 * (v1813 * v776)))) * v1798;
        const double v1896 = (((v1801 * (v1890 * c1091)) * c1095) * v1787) - (v1789 * v1890);
        const double v1906 = (v1793 * ((v1794 * v849) + (3.0 * (v1813 * v863)))) * v1798;
        const double v1912 = (((v1801 * (v1906 * c1091)) * c1095) * v1787) - (v1789 * v1906);
        const double v1919 = squared(v100) + (3.0 * squared(v156));
        const double v1921 = sqrt(larger(v1919, c1087));
        const double v1922 = v1921 * c1091;
        const double v1925 = 1.0 / v1921;
        const double v1926 = (sinh(v1922) * c1095) * v1925;
        const double v1927 = v1926 * v1925;
        const double v1928 = (double)(c1087 <= v1919);
        const double v1931 = v1928 / (v1928 + (double)(v1919 <= c1087));
        const double v1932 = 2.0 * v100;
        const double v1936 = 1.0 / (2.0 * v1921);
        const double v1937 = (v1931 * (v1932 * c1)) * v1936;
        const double v1939 = cosh(v1922);
        const double v1944 = (v1927 * v1937) - (((v1939 * (v1937 * c1091)) * c1095) * v1925);
        const double v1951 = 2.0 * v156;
        const double v1953 = 3.0 * (v1951 * v384);
        const double v1956 = (v1931 * ((v1932 * v360) - v1953)) * v1936;
        const double v1962 = (((v1939 * (v1956 * c1091)) * c1095) * v1925) - (v1927 * v1956);
        const double v1970 = (v1931 * ((v1932 * v477) - v1953)) * v1936;
        const double v1976 = (((v1939 * (v1970 * c1091)) * c1095) * v1925) - (v1927 * v1970);
        const double v1983 = (v1931 * (3.0 * (v1951 * c123))) * v1936;
        const double v1989 = (v1927 * v1983) - (((v1939 * (v1983 * c1091)) * c1095) * v1925);
        const double v1995 = 3.0 * (v1951 * v617);
        const double v1998 = (v1931 * ((v1932 * v601) + v1995)) * v1936;
        const double v2004 = (((v1939 * (v1998 * c1091)) * c1095) * v1925) - (v1927 * v1998);
        const double v2012 = (v1931 * ((v1932 * v693) - v1995)) * v1936;
        const double v2018 = (((v1939 * (v2012 * c1091)) * c1095) * v1925) - (v1927 * v2012);
        const double v2028 = (v1931 * ((v1932 * v763) + (3.0 * (v1951 * v776)))) * v1936;
        const double v2034 = (((v1939 * (v2028 * c1091)) * c1095) * v1925) - (v1927 * v2028);
        const double v2044 = (v1931 * ((v1932 * v853) + (3.0 * (v1951 * v863)))) * v1936;
        const double v2050 = (((v1939 * (v2044 * c1091)) * c1095) * v1925) - (v1927 * v2044);
        const double v2057 = squared(v110) + (3.0 * squared(v161));
        const double v2059 = sqrt(larger(v2057, c1087));
        const double v2060 = v2059 * c1091;
        const double v2063 = 1.0 / v2059;
        const double v2064 = (sinh(v2060) * c1095) * v2063;
        const double v2065 = v2064 * v2063;
        const double v2066 = (double)(c1087 <= v2057);
        const double v2069 = v2066 / (v2066 + (double)(v2057 <= c1087));
        const double v2070 = 2.0 * v110;
        const double v2074 = 1.0 / (2.0 * v2059);
        const double v2075 = (v2069 * (v2070 * c1)) * v2074;
        const double v2077 = cosh(v2060);
        const double v2082 = (v2065 * v2075) - (((v2077 * (v2075 * c1091)) * c1095) * v2063);
        const double v2089 = 2.0 * v161;
        const double v2091 = 3.0 * (v2089 * v384);
        const double v2094 = (v2069 * ((v2070 * v369) - v2091)) * v2074;
        const double v2100 = (((v2077 * (v2094 * c1091)) * c1095) * v2063) - (v2065 * v2094);
        const double v2108 = (v2069 * ((v2070 * v482) - v2091)) * v2074;
        const double v2114 = (((v2077 * (v2108 * c1091)) * c1095) * v2063) - (v2065 * v2108);
        const double v2121 = (v2069 * (3.0 * (v2089 * c123))) * v2074;
        const double v2127 = (v2065 * v2121) - (((v2077 * (v2121 * c1091)) * c1095) * v2063);
        const double v2133 = 3.0 * (v2089 * v617);
        const double v2136 = (v2069 * ((v2070 * v606) + v2133)) * v2074;
        const double v2142 = (((v2077 * (v2136 * c1091)) * c1095) * v2063) - (v2065 * v2136);
        const double v2150 = (v2069 * ((v2070 * v697) - v2133)) * v2074;
        const double v2156 = (((v2077 * (v2150 * c1091)) * c1095) * v2063) - (v2065 * v2150);
        const double v2166 = (v2069 * ((v2070 * v768) + (3.0 * (v2089 * v776)))) * v2074;
        const double v2172 = (((v2077 * (v2166 * c1091)) * c1095) * v2063) - (v2065 * v2166);
        const double v2182 = (v2069 * ((v2070 * v857) + (3.0 * (v2089 * v863)))) * v2074;
        const double v2188 = (((v2077 * (v2182 * c1091)) * c1095) * v2063) - (v2065 * v2182);
        const double v2192 = 3.0 * v127;
        const double v2196 = 3.0 * v384;
        const double v2197 = v1098 * v2196;
        const double v2208 = 3.0 * v617;
        const double v2209 = v1098 * v2208;
        const double v2216 = 3.0 * v776;
        const double v2221 = 3.0 * v863;
        const double v2226 = 3.0 * v131;
        const double v2230 = v1236 * v2196;
        const double v2240 = v1236 * v2208;
        const double v2255 = 3.0 * v136;
        const double v2259 = v1374 * v2196;
        const double v2269 = v1374 * v2208;
        const double v2284 = 3.0 * v141;
        const double v2288 = v1512 * v2196;
        const double v2298 = v1512 * v2208;
        const double v2313 = 3.0 * v146;
        const double v2317 = v1650 * v2196;
        const double v2327 = v1650 * v2208;
        const double v2342 = 3.0 * v151;
        const double v2346 = v1788 * v2196;
        const double v2356 = v1788 * v2208;
        const double v2371 = 3.0 * v156;
        const double v2375 = v1926 * v2196;
        const double v2385 = v1926 * v2208;
        const double v2400 = 3.0 * v161;
        const double v2404 = v2064 * v2196;
        const double v2414 = v2064 * v2208;
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
        e[254 * i + 129] = c1079 * ((v42 * v1116) - (v1098 * c1));
        e[254 * i + 128] = c1079 * ((v1098 * v307) + (v42 * v1134));
        e[254 * i + 133] = c1079 * ((v1098 * v448) + (v42 * v1148));
        e[254 * i + 130] = c1079 * (v42 * v1161);
        e[254 * i + 126] = c1079 * ((v1098 * v572) + (v42 * v1176));
        e[254 * i + 131] = c1079 * ((v1098 * v670) + (v42 * v1190));
        e[254 * i + 127] = c1079 * ((v1098 * v734) + (v42 * v1206));
        e[254 * i + 132] = c1079 * ((v1098 * v830) + (v42 * v1222));
        e[254 * i + 137] = c1079 * ((v51 * v1254) - (v1236 * c1));
        e[254 * i + 136] = c1079 * ((v1236 * v315) + (v51 * v1272));
        e[254 * i + 141] = c1079 * ((v1236 * v452) + (v51 * v1286));
        e[254 * i + 138] = c1079 * (v51 * v1299);
        e[254 * i + 134] = c1079 * ((v1236 * v576) + (v51 * v1314));
        e[254 * i + 139] = c1079 * ((v1236 * v673) + (v51 * v1328));
        e[254 * i + 135] = c1079 * ((v1236 * v738) + (v51 * v1344));
        e[254 * i + 140] = c1079 * ((v1236 * v833) + (v51 * v1360));
        e[254 * i + 145] = c1079 * ((v61 * v1392) - (v1374 * c1));
        e[254 * i + 144] = c1079 * ((v1374 * v324) + (v61 * v1410));
        e[254 * i + 149] = c1079 * ((v1374 * v457) + (v61 * v1424));
        e[254 * i + 146] = c1079 * (v61 * v1437);
        e[254 * i + 142] = c1079 * ((v1374 * v581) + (v61 * v1452));
        e[254 * i + 147] = c1079 * ((v1374 * v677) + (v61 * v1466));
        e[254 * i + 143] = c1079 * ((v1374 * v743) + (v61 * v1482));
        e[254 * i + 148] = c1079 * ((v1374 * v837) + (v61 * v1498));
        e[254 * i + 153] = c1079 * ((v71 * v1530) - (v1512 * c1));
        e[254 * i + 152] = c1079 * ((v1512 * v333) + (v71 * v1548));
        e[254 * i + 157] = c1079 * ((v1512 * v462) + (v71 * v1562));
        e[254 * i + 154] = c1079 * (v71 * v1575);
        e[254 * i + 150] = c1079 * ((v1512 * v586) + (v71 * v1590));
        e[254 * i + 155] = c1079 * ((v1512 * v681) + (v71 * v1604));
        e[254 * i + 151] = c1079 * ((v1512 * v748) + (v71 * v1620));
        e[254 * i + 156] = c1079 * ((v1512 * v841) + (v71 * v1636));
        e[254 * i + 161] = c1079 * ((v80 * v1668) - (v1650 * c1));
        e[254 * i + 160] = c1079 * ((v1650 * v342) + (v80 * v1686));
        e[254 * i + 165] = c1079 * ((v1650 * v467) + (v80 * v1700));
        e[254 * i + 162] = c1079 * (v80 * v1713);
        e[254 * i + 158] = c1079 * ((v1650 * v591) + (v80 * v1728));
        e[254 * i + 163] = c1079 * ((v1650 * v685) + (v80 * v1742));
        e[254 * i + 159] = c1079 * ((v1650 * v753) + (v80 * v1758));
        e[254 * i + 164] = c1079 * ((v1650 * v845) + (v80 * v1774));
        e[254 * i + 169] = c1079 * ((v90 * v1806) - (v1788 * c1));
        e[254 * i + 168] = c1079 * ((v1788 * v351) + (v90 * v1824));
        e[254 * i + 173] = c1079 * ((v1788 * v472) + (v90 * v1838));
        e[254 * i + 170] = c1079 * (v90 * v1851);
        e[254 * i + 166] = c1079 * ((v1788 * v596) + (v90 * v1866));
        e[254 * i + 171] = c1079 * ((v1788 * v689) + (v90 * v1880));
        e[254 * i + 167] = c1079 * ((v1788 * v758) + (v90 * v1896));
        e[254 * i + 172] = c1079 * ((v1788 * v849) + (v90 * v1912));
        e[254 * i + 177] = c1079 * ((v100 * v1944) - (v1926 * c1));
        e[254 * i + 176] = c1079 * ((v1926 * v360) + (v100 * v1962));
        e[254 * i + 181] = c1079 * ((v1926 * v477) + (v100 * v1976));
        e[254 * i + 178] = c1079 * (v100 * v1989);
        e[254 * i + 174] = c1079 * ((v1926 * v601) + (v100 * v2004));
        e[254 * i + 179] = c1079 * ((v1926 * v693) + (v100 * v2018));
        e[254 * i + 175] = c1079 * ((v1926 * v763) + (v100 * v2034));
        e[254 * i + 180] = c1079 * ((v1926 * v853) + (v100 * v2050));
        e[254 * i + 185] = c1079 * ((v110 * v2082) - (v2064 * c1));
        e[254 * i + 184] = c1079 * ((v2064 * v369) + (v110 * v2100));
        e[254 * i + 189] = c1079 * ((v2064 * v482) + (v110 * v2114));
        e[254 * i + 186] = c1079 * (v110 * v2127);
        e[254 * i + 182] = c1079 * ((v2064 * v606) + (v110 * v2142));
        e[254 * i + 187] = c1079 * ((v2064 * v697) + (v110 * v2156));
        e[254 * i + 183] = c1079 * ((v2064 * v768) + (v110 * v2172));
        e[254 * i + 188] = c1079 * ((v2064 * v857) + (v110 * v2188));
        e[254 * i + 193] = c1079 * (v2192 * v1116);
        e[254 * i + 192] = c1079 * ((v2192 * v1134) - v2197);
        e[254 * i + 197] = c1079 * ((v2192 * v1148) - v2197);
        e[254 * i + 194] = c1079 * ((v2192 * v1161) - (v1098 * c2204));
        e[254 * i + 190] = c1079 * (v2209 + (v2192 * v1176));
        e[254 * i + 195] = c1079 * ((v2192 * v1190) - v2209);
        e[254 * i + 191] = c1079 * ((v1098 * v2216) + (v2192 * v1206));
        e[254 * i + 196] = c1079 * ((v1098 * v2221) + (v2192 * v1222));
        e[254 * i + 201] = c1079 * (v2226 * v1254);
        e[254 * i + 200] = c1079 * ((v2226 * v1272) - v2230);
        e[254 * i + 205] = c1079 * ((v2226 * v1286) - v2230);
        e[254 * i + 202] = c1079 * ((v2226 * v1299) - (v1236 * c2204));
        e[254 * i + 198] = c1079 * (v2240 + (v2226 * v1314));
        e[254 * i + 203] = c1079 * ((v2226 * v1328) - v2240);
        e[254 * i + 199] = c1079 * ((v1236 * v2216) + (v2226 * v1344));
        e[254 * i + 204] = c1079 * ((v1236 * v2221) + (v2226 * v1360));
        e[254 * i + 209] = c1079 * (v2255 * v1392);
        e[254 * i + 208] = c1079 * ((v2255 * v1410) - v2259);
        e[254 * i + 213] = c1079 * ((v2255 * v1424) - v2259);
        e[254 * i + 210] = c1079 * ((v2255 * v1437) - (v1374 * c2204));
        e[254 * i + 206] = c1079 * (v2269 + (v2255 * v1452));
        e[254 * i + 211] = c1079 * ((v2255 * v1466) - v2269);
        e[254 * i + 207] = c1079 * ((v1374 * v2216) + (v2255 * v1482));
        e[254 * i + 212] = c1079 * ((v1374 * v2221) + (v2255 * v1498));
        e[254 * i + 217] = c1079 * (v2284 * v1530);
        e[254 * i + 216] = c1079 * ((v2284 * v1548) - v2288);
        e[254 * i + 221] = c1079 * ((v2284 * v1562) - v2288);
        e[254 * i + 218] = c1079 * ((v2284 * v1575) - (v1512 * c2204));
        e[254 * i + 214] = c1079 * (v2298 + (v2284 * v1590));
        e[254 * i + 219] = c1079 * ((v2284 * v1604) - v2298);
        e[254 * i + 215] = c1079 * ((v1512 * v2216) + (v2284 * v1620));
        e[254 * i + 220] = c1079 * ((v1512 * v2221) + (v2284 * v1636));
        e[254 * i + 225] = c1079 * (v2313 * v1668);
        e[254 * i + 224] = c1079 * ((v2313 * v1686) - v2317);
        e[254 * i + 229] = c1079 * ((v2313 * v1700) - v2317);
        e[254 * i + 226] = c1079 * ((v2313 * v1713) - (v1650 * c2204));
        e[254 * i + 222] = c1079 * (v2327 + (v2313 * v1728));
        e[254 * i + 227] = c1079 * ((v2313 * v1742) - v2327);
        e[254 * i + 223] = c1079 * ((v1650 * v2216) + (v2313 * v1758));
        e[254 * i + 228] = c1079 * ((v1650 * v2221) + (v2313 * v1774));
        e[254 * i + 233] = c1079 * (v2342 * v1806);
        e[254 * i + 232] = c1079 * ((v2342 * v1824) - v2346);
        e[254 * i + 237] = c1079 * ((v2342 * v1838) - v2346);
        e[254 * i + 234] = c1079 * ((v2342 * v1851) - (v1788 * c2204));
        e[254 * i + 230] = c1079 * (v2356 + (v2342 * v1866));
        e[254 * i + 235] = c1079 * ((v2342 * v1880) - v2356);
        e[254 * i + 231] = c1079 * ((v1788 * v2216) + (v2342 * v1896));
        e[254 * i + 236] = c1079 * ((v1788 * v2221) + (v2342 * v1912));
        e[254 * i + 241] = c1079 * (v2371 * v1944);
        e[254 * i + 240] = c1079 * ((v2371 * v1962) - v2375);
        e[254 * i + 245] = c1079 * ((v2371 * v1976) - v2375);
        e[254 * i + 242] = c1079 * ((v2371 * v1989) - (v1926 * c2204));
        e[254 * i + 238] = c1079 * (v2385 + (v2371 * v2004));
        e[254 * i + 243] = c1079 * ((v2371 * v2018) - v2385);
        e[254 * i + 239] = c1079 * ((v1926 * v2216) + (v2371 * v2034));
        e[254 * i + 244] = c1079 * ((v1926 * v2221) + (v2371 * v2050));
        e[254 * i + 249] = c1079 * (v2400 * v2082);
        e[254 * i + 248] = c1079 * ((v2400 * v2100) - v2404);
        e[254 * i + 253] = c1079 * ((v2400 * v2114) - v2404);
        e[254 * i + 250] = c1079 * ((v2400 * v2127) - (v2064 * c2204));
        e[254 * i + 246] = c1079 * (v2414 + (v2400 * v2142));
        e[254 * i + 251] = c1079 * ((v2400 * v2156) - v2414);
        e[254 * i + 247] = c1079 * ((v2064 * v2216) + (v2400 * v2172));
        e[254 * i + 252] = c1079 * ((v2064 * v2221) + (v2400 * v2188));
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
    const double c236 = p[9];
    const double c238 = c11 / c236;
    const double c239 = squared(c238);
    const double c240 = p[2] * c239;
    const double c241 = c236 / c240;
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
        const double v65 = sqrt(larger(v60, c63));
        const double v81 = ((((-0.7660444431189779) * v15) * v36) - y[22 * i + 7]) + v40;
        const double v89 = squared((c2 * v81)) + (3.0 * squared((c50 * (v54 - y[22 * i + 15]))));
        const double v91 = sqrt(larger(v89, c63));
        const double v97 = (0.025995061875669127 * (v65 * (sinh(v65 * c67) * c71))) + (0.09181686914811889 * (v91 * (sinh(v91 * c67) * c71)));
        const double v104 = ((((-0.4999999999999998) * v15) * v36) - y[22 * i + 8]) + v40;
        const double v112 = squared((c2 * v104)) + (3.0 * squared((c50 * (v54 - y[22 * i + 16]))));
        const double v114 = sqrt(larger(v112, c63));
        const double v120 = v97 + (0.16666666666666669 * (v114 * (sinh(v114 * c67) * c71)));
        const double v127 = ((((-0.1736481776669303) * v15) * v36) - y[22 * i + 9]) + v40;
        const double v135 = squared((c2 * v127)) + (3.0 * squared((c50 * (v54 - y[22 * i + 17]))));
        const double v137 = sqrt(larger(v135, c63));
        const double v143 = v120 + (0.21552140230954533 * (v137 * (sinh(v137 * c67) * c71)));
        const double v149 = (((0.17364817766693041 * v15) * v36) - y[22 * i + 10]) + v40;
        const double v157 = squared((c2 * v149)) + (3.0 * squared((c50 * (v54 - y[22 * i + 18]))));
        const double v159 = sqrt(larger(v157, c63));
        const double v165 = v143 + (0.21552140230954533 * (v159 * (sinh(v159 * c67) * c71)));
        const double v172 = (((0.5000000000000001 * v15) * v36) - y[22 * i + 11]) + v40;
        const double v180 = squared((c2 * v172)) + (3.0 * squared((c50 * (v54 - y[22 * i + 19]))));
        const double v182 = sqrt(larger(v180, c63));
        const double v188 = v165 + (0.16666666666666663 * (v182 * (sinh(v182 * c67) * c71)));
        const double v195 = (((0.766044443118978 * v15) * v36) - y[22 * i + 12]) + v40;
        const double v203 = squared((c2 * v195)) + (3.0 * squared((c50 * (v54 - y[22 * i + 20]))));
        const double v205 = sqrt(larger(v203, c63));
        const double v211 = v188 + (0.09181686914811883 * (v205 * (sinh(v205 * c67) * c71)));
        const double v218 = (((0.9396926207859084 * v15) * v36) - y[22 * i + 13]) + v40;
        const double v226 = squared((c2 * v218)) + (3.0 * squared((c50 * (v54 - y[22 * i + 21]))));
        const double v228 = sqrt(larger(v226, c63));
        const double v234 = v211 + (0.025995061875669103 * (v228 * (sinh(v228 * c67) * c71)));
        q[0] += (g[7 * i + 1] * v234) * c241;
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
        const double v36 = ((-0.9396926207859083) * v14) * v35;
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
        const double v86 = 0.025995061875669127 * v85;
        const double v93 = ((sinh(v73) * c76) * v86) + ((cosh(v73) * ((v70 * v86) * c76)) * c72);
        const double v96 = (v65 / (v65 + (double)(v64 <= c45))) * (v93 / (2.0 * v70));
        const double v98 = c0 * ((2.0 * v41) * v96);
        const double v102 = ((-0.7660444431189779) * v14) * v35;
        const double v106 = c0 * ((v102 - y[22 * i + 7]) + v39);
        const double v111 = c53 * (v58 - y[22 * i + 15]);
        const double v114 = squared(v106) + (3.0 * squared(v111));
        const double v115 = (double)(c45 <= v114);
        const double v120 = sqrt(larger(v114, c45));
        const double v121 = v120 * c72;
        const double v125 = 0.09181686914811889 * v85;
        const double v132 = ((sinh(v121) * c76) * v125) + ((cosh(v121) * ((v120 * v125) * c76)) * c72);
        const double v135 = (v115 / (v115 + (double)(v114 <= c45))) * (v132 / (2.0 * v120));
        const double v137 = c0 * ((2.0 * v106) * v135);
        const double v141 = ((-0.4999999999999998) * v14) * v35;
        const double v145 = c0 * ((v141 - y[22 * i + 8]) + v39);
        const double v150 = c53 * (v58 - y[22 * i + 16]);
        const double v153 = squared(v145) + (3.0 * squared(v150));
        const double v154 = (double)(c45 <= v153);
        const double v159 = sqrt(larger(v153, c45));
        const double v160 = v159 * c72;
        const double v164 = 0.16666666666666669 * v85;
        const double v171 = ((sinh(v160) * c76) * v164) + ((cosh(v160) * ((v159 * v164) * c76)) * c72);
        const double v174 = (v154 / (v154 + (double)(v153 <= c45))) * (v171 / (2.0 * v159));
        const double v176 = c0 * ((2.0 * v145) * v174);
        const double v180 = ((-0.1736481776669303) * v14) * v35;
        const double v184 = c0 * ((v180 - y[22 * i + 9]) + v39);
        const double v189 = c53 * (v58 - y[22 * i + 17]);
        const double v192 = squared(v184) + (3.0 * squared(v189));
        const double v193 = (double)(c45 <= v192);
        const double v198 = sqrt(larger(v192, c45));
        const double v199 = v198 * c72;
        const double v203 = 0.21552140230954533 * v85;
        const double v210 = ((sinh(v199) * c76) * v203) + ((cosh(v199) * ((v198 * v203) * c76)) * c72);
        const double v213 = (v193 / (v193 + (double)(v192 <= c45))) * (v210 / (2.0 * v198));
        const double v215 = c0 * ((2.0 * v184) * v213);
        const double v219 = (0.17364817766693041 * v14) * v35;
        const double v223 = c0 * ((v219 - y[22 * i + 10]) + v39);
        const double v228 = c53 * (v58 - y[22 * i + 18]);
        const double v231 = squared(v223) + (3.0 * squared(v228));
        const double v232 = (double)(c45 <= v231);
        const double v237 = sqrt(larger(v231, c45));
        const double v238 = v237 * c72;
        const double v247 = ((sinh(v238) * c76) * v203) + ((cosh(v238) * ((v237 * v203) * c76)) * c72);
        const double v250 = (v232 / (v232 + (double)(v231 <= c45))) * (v247 / (2.0 * v237));
        const double v252 = c0 * ((2.0 * v223) * v250);
        const double v256 = (0.5000000000000001 * v14) * v35;
        const double v260 = c0 * ((v256 - y[22 * i + 11]) + v39);
        const double v265 = c53 * (v58 - y[22 * i + 19]);
        const double v268 = squared(v260) + (3.0 * squared(v265));
        const double v269 = (double)(c45 <= v268);
        const double v274 = sqrt(larger(v268, c45));
        const double v275 = v274 * c72;
        const double v279 = 0.16666666666666663 * v85;
        const double v286 = ((sinh(v275) * c76) * v279) + ((cosh(v275) * ((v274 * v279) * c76)) * c72);
        const double v289 = (v269 / (v269 + (double)(v268 <= c45))) * (v286 / (2.0 * v274));
        const double v291 = c0 * ((2.0 * v260) * v289);
        const double v295 = (0.766044443118978 * v14) * v35;
        const double v299 = c0 * ((v295 - y[22 * i + 12]) + v39);
        const double v304 = c53 * (v58 - y[22 * i + 20]);
        const double v307 = squared(v299) + (3.0 * squared(v304));
        const double v308 = (double)(c45 <= v307);
        const double v313 = sqrt(larger(v307, c45));
        const double v314 = v313 * c72;
        const double v318 = 0.09181686914811883 * v85;
        const double v325 = ((sinh(v314) * c76) * v318) + ((cosh(v314) * ((v313 * v318) * c76)) * c72);
        const double v328 = (v308 / (v308 + (double)(v307 <= c45))) * (v325 / (2.0 * v313));
        const double v330 = c0 * ((2.0 * v299) * v328);
        const double v334 = (0.9396926207859084 * v14) * v35;
        const double v338 = c0 * ((v334 - y[22 * i + 13]) + v39);
        const double v343 = c53 * (v58 - y[22 * i + 21]);
        const double v346 = squared(v338) + (3.0 * squared(v343));
        const double v347 = (double)(c45 <= v346);
        const double v352 = sqrt(larger(v346, c45));
        const double v353 = v352 * c72;
        const double v357 = 0.025995061875669103 * v85;
        const double v364 = ((sinh(v353) * c76) * v357) + ((cosh(v353) * ((v352 * v357) * c76)) * c72);
        const double v367 = (v347 / (v347 + (double)(v346 <= c45))) * (v364 / (2.0 * v352));
        const double v369 = c0 * ((2.0 * v338) * v367);
        const double v372 = v58 * v57;
        const double v376 = c53 * ((2.0 * v343) * (3.0 * v367));
        const double v380 = (v334 * v35) * v369;
        const double v385 = 1.0 / (2.0 * v33);
        const double v387 = (((v369 * v57) - (v372 * v376)) - (v33 * v380)) - ((v32 * v380) * v385);
        const double v391 = c53 * ((2.0 * v304) * (3.0 * v328));
        const double v397 = (v295 * v35) * v330;
        const double v402 = (((v387 - (v372 * v391)) + (v330 * v57)) - (v33 * v397)) - ((v32 * v397) * v385);
        const double v406 = c53 * ((2.0 * v265) * (3.0 * v289));
        const double v412 = (v256 * v35) * v291;
        const double v417 = (((v402 - (v372 * v406)) + (v291 * v57)) - (v33 * v412)) - ((v32 * v412) * v385);
        const double v421 = c53 * ((2.0 * v228) * (3.0 * v250));
        const double v427 = (v219 * v35) * v252;
        const double v432 = (((v417 - (v372 * v421)) + (v252 * v57)) - (v33 * v427)) - ((v32 * v427) * v385);
        const double v436 = c53 * ((2.0 * v189) * (3.0 * v213));
        const double v442 = (v180 * v35) * v215;
        const double v447 = (((v432 - (v372 * v436)) + (v215 * v57)) - (v33 * v442)) - ((v32 * v442) * v385);
        const double v451 = c53 * ((2.0 * v150) * (3.0 * v174));
        const double v457 = (v141 * v35) * v176;
        const double v462 = (((v447 - (v372 * v451)) + (v176 * v57)) - (v33 * v457)) - ((v32 * v457) * v385);
        const double v466 = c53 * ((2.0 * v111) * (3.0 * v135));
        const double v472 = (v102 * v35) * v137;
        const double v477 = (((v462 - (v372 * v466)) + (v137 * v57)) - (v33 * v472)) - ((v32 * v472) * v385);
        const double v481 = c53 * ((2.0 * v61) * (3.0 * v96));
        const double v487 = (v36 * v35) * v98;
        const double v492 = (((v477 - (v372 * v481)) + (v98 * v57)) - (v33 * v487)) - ((v32 * v487) * v385);
        const double v500 = (((v376 * v57) + (v391 * v57)) + (v406 * v57)) + (v421 * v57);
        const double v508 = (((v500 + (v436 * v57)) + (v451 * v57)) + (v466 * v57)) + (v481 * v57);
        const double v516 = (v24 * ((v29 * v492) - (v19 * v508))) - (v30 * ((v29 * v508) + (v19 * v492)));
        const double v517 = 0.5 * v516;
        const double v524 = (c4 * (0.9396926207859084 * (v369 * v35))) + (c4 * (0.766044443118978 * (v330 * v35)));
        const double v532 = (v524 + (c4 * (0.5000000000000001 * (v291 * v35)))) + (c4 * (0.17364817766693041 * (v252 * v35)));
        const double v540 = (v532 + (c4 * ((-0.1736481776669303) * (v215 * v35)))) + (c4 * ((-0.4999999999999998) * (v176 * v35)));
        const double v548 = (v540 + (c4 * ((-0.7660444431189779) * (v137 * v35)))) + (c4 * ((-0.9396926207859083) * (v98 * v35)));
        const double v549 = v12 * v548;
        const double v563 = ((v24 * v492) - (v30 * v508)) * v9;
        const double v568 = ((v24 * v508) + (v30 * v492)) * v9;
        s[22 * i + 6] += -v98;
        s[22 * i + 7] += -v137;
        s[22 * i + 8] += -v176;
        s[22 * i + 9] += -v215;
        s[22 * i + 10] += -v252;
        s[22 * i + 11] += -v291;
        s[22 * i + 12] += -v330;
        s[22 * i + 13] += -v369;
        s[22 * i + 4] += v517 - v549;
        s[22 * i + 26] += v517 + v549;
        s[22 * i + 14] += -v481;
        s[22 * i + 15] += -v466;
        s[22 * i + 16] += -v451;
        s[22 * i + 17] += -v436;
        s[22 * i + 18] += -v421;
        s[22 * i + 19] += -v406;
        s[22 * i + 20] += -v391;
        s[22 * i + 21] += -v376;
        s[22 * i] += -v563;
        s[22 * i + 22] += v563;
        s[22 * i + 1] += -v568;
        s[22 * i + 23] += v568;
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
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, (-0.9396926207859083), (-0.7660444431189779),
    (-0.4999999999999998), (-0.1736481776669303), 0.17364817766693041, 0.5000000000000001,
    0.766044443118978, 0.9396926207859084, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

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
