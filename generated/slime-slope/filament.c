/*
 * Slime between hands at different heights
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, shear, rotary-inertia
 * Digest of the structure: 2e11a355adb4e9deae80ba7743213b8245f8dda377fcaffdbcbe13247ad268ac
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[10 * i] = y[10 * i + 2];
        f[10 * i + 1] = y[10 * i + 3];
        f[10 * i + 4] = y[10 * i + 5];
    }
}

static void rates_1(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[10 * i];
        w1[i] = y[10 * i + 1];
        w2[i] = y[10 * i + 4];
    }
}

static void rates_2(int n, const double *p, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c1 = p[0];
    const double c2 = 2.0 * c1;
    const double c3 = p[7] / c2;
    const double c5 = p[8] / c1;
    const double c6 = -c5;
    const int i = n - 1;
    w0[i] = c3;
    w1[i] = c6;
    w2[i] = p[10];
    (void)n;
}

static void rates_3(int n, const double *p, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c2 = 2.0 * p[0];
    const double c3 = p[7] / c2;
    const double c4 = -c3;
    const int i = 0;
    w0[i] = c4;
    w1[i] = 0.0;
    w2[i] = p[9];
    (void)n;
}

static void rates_4(int n, const double *p, const double *g, const double *y, double *w, double *f)
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
    const double c59 = 0.9 * c1;
    const double c61 = 2.0 * p[6];
    const double c62 = 2.0 + c61;
    const double c63 = c59 / c62;
    const double c79 = 0.5 * c4;
    const double c103 = p[5];
    const double c104 = 1.0 / c103;
    const double c106 = p[11];
    const double c111 = 3.0 / c103;
    for (int i = 0; i < n - 1; i++) {
        const double v6 = w2[i + 1];
        const double v7 = w2[i];
        const double v10 = g[7 * i + 4];
        const double v14 = (v6 - v7) * (v10 * c12);
        const double v15 = c5 * v14;
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v23 = (v7 + v6) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w1[i + 1] - w1[i]) * v10;
        const double v30 = sin(v23);
        const double v32 = (v20 * v24) + (v29 * v30);
        const double v35 = 1.0 / (sqrt(v32) * v32);
        const double v39 = log(v32);
        const double v40 = ((((-0.4999999999999998) * v15) * v35) - y[10 * i + 6]) + v39;
        const double v41 = c1 * v40;
        const double v49 = (((0.5000000000000001 * v15) * v35) - y[10 * i + 7]) + v39;
        const double v50 = c1 * v49;
        const double v53 = 1.0 / v32;
        const double v57 = (v29 * v24) - (v20 * v30);
        const double v64 = v57 * v53;
        const double v67 = c63 * (v64 - y[10 * i + 8]);
        const double v71 = c63 * (v64 - y[10 * i + 9]);
        const double v73 = (0.5 * v67) + (0.4999999999999999 * v71);
        const double v74 = v73 * v53;
        const double v77 = (((0.5 * v41) + (0.4999999999999999 * v50)) * v53) - ((v57 * v74) * v53);
        const double v86 = (c79 * (((-0.2499999999999999) * v41) + (0.25 * v50))) * v35;
        const double v90 = v77 + (((1.5 * v86) * v14) * v53);
        w3[i] = (v90 * v24) - (v74 * v30);
        w4[i] = (v90 * v30) + (v74 * v24);
        w5[i] = ((g[7 * i + 1] * c11) * (v73 - (v57 * v90))) * 0.5;
        w6[i] = -v86;
        f[10 * i + 6] = (v41 * c104) * c106;
        f[10 * i + 7] = (v50 * c104) * c106;
        f[10 * i + 8] = (c111 * v67) * c106;
        f[10 * i + 9] = (c111 * v71) * c106;
    }
}

static void rates_5(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
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
        const double v38 = (((w6[i] - w6[i - 1]) + w5[i]) + w5[i - 1]) * (c34 * g[7 * i + 5]);
        f[10 * i + 2] = (w3[i] - w3[i - 1]) * v12;
        f[10 * i + 3] = ((w4[i] - w4[i - 1]) * v12) - c19;
        f[10 * i + 5] = v38;
    }
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[82 * i] = 1.0;
        e[82 * i + 1] = 1.0;
        e[82 * i + 36] = 1.0;
    }
}

static void jacobian_1(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[10 * i];
        w1[i] = y[10 * i + 1];
        w2[i] = y[10 * i + 4];
    }
}

static void jacobian_2(int n, const double *p, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c1 = p[0];
    const double c2 = 2.0 * c1;
    const double c3 = p[7] / c2;
    const double c5 = p[8] / c1;
    const double c6 = -c5;
    const int i = n - 1;
    w0[i] = c3;
    w1[i] = c6;
    w2[i] = p[10];
    (void)n;
}

static void jacobian_3(int n, const double *p, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c2 = 2.0 * p[0];
    const double c3 = p[7] / c2;
    const double c4 = -c3;
    const int i = 0;
    w0[i] = c4;
    w1[i] = 0.0;
    w2[i] = p[9];
    (void)n;
}

static void jacobian_4(int n, const double *p, const double *g, const double *y, double *w, double *e)
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
    const double c1 = p[4];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c59 = 0.9 * c1;
    const double c61 = 2.0 * p[6];
    const double c62 = 2.0 + c61;
    const double c63 = c59 / c62;
    const double c79 = 0.5 * c4;
    const double c94 = 0.5 * c1;
    const double c96 = (-0.2499999999999999) * c1;
    const double c97 = c79 * c96;
    const double c105 = 0.4999999999999999 * c1;
    const double c107 = 0.25 * c1;
    const double c108 = c79 * c107;
    const double c224 = 0.5 * c63;
    const double c231 = 0.4999999999999999 * c63;
    const double c494 = p[11];
    const double c495 = p[5];
    const double c496 = c1 / c495;
    const double c497 = c494 * c496;
    const double c498 = -c497;
    const double c499 = 1.0 / c495;
    const double c525 = 3.0 / c495;
    const double c529 = c525 * c63;
    const double c530 = c494 * c529;
    const double c531 = -c530;
    for (int i = 0; i < n - 1; i++) {
        const double v6 = w2[i + 1];
        const double v7 = w2[i];
        const double v10 = g[7 * i + 4];
        const double v13 = v10 * c12;
        const double v14 = (v6 - v7) * v13;
        const double v15 = c5 * v14;
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v23 = (v7 + v6) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w1[i + 1] - w1[i]) * v10;
        const double v30 = sin(v23);
        const double v32 = (v20 * v24) + (v29 * v30);
        const double v33 = sqrt(v32);
        const double v35 = 1.0 / (v33 * v32);
        const double v36 = ((-0.4999999999999998) * v15) * v35;
        const double v39 = log(v32);
        const double v41 = c1 * ((v36 - y[10 * i + 6]) + v39);
        const double v46 = (0.5000000000000001 * v15) * v35;
        const double v50 = c1 * ((v46 - y[10 * i + 7]) + v39);
        const double v53 = 1.0 / v32;
        const double v54 = ((0.5 * v41) + (0.4999999999999999 * v50)) * v53;
        const double v57 = (v29 * v24) - (v20 * v30);
        const double v64 = v57 * v53;
        const double v73 = (0.5 * (c63 * (v64 - y[10 * i + 8]))) + (0.4999999999999999 * (c63 * (v64 - y[10 * i + 9])));
        const double v74 = v73 * v53;
        const double v76 = (v57 * v74) * v53;
        const double v86 = (c79 * (((-0.2499999999999999) * v41) + (0.25 * v50))) * v35;
        const double v87 = 1.5 * v86;
        const double v89 = (v87 * v14) * v53;
        const double v90 = (v54 - v76) + v89;
        const double v98 = c97 * v35;
        const double v102 = (c94 * v53) + ((v14 * (1.5 * v98)) * v53);
        const double v109 = c108 * v35;
        const double v113 = (c105 * v53) + ((v14 * (1.5 * v109)) * v53);
        const double v116 = 0.5 * v24;
        const double v118 = 0.5 * v30;
        const double v120 = (v29 * v116) - (v20 * v118);
        const double v121 = v120 * v53;
        const double v122 = c5 * v13;
        const double v124 = ((-0.4999999999999998) * v122) * v35;
        const double v125 = v36 * v35;
        const double v127 = 1.0 / (2.0 * v33);
        const double v131 = (v32 * (v120 * v127)) + (v33 * v120);
        const double v132 = v125 * v131;
        const double v135 = c1 * (v121 - (v124 + v132));
        const double v138 = (0.5000000000000001 * v122) * v35;
        const double v139 = v46 * v35;
        const double v140 = v139 * v131;
        const double v143 = c1 * (v121 - (v138 + v140));
        const double v147 = v54 * v53;
        const double v148 = v147 * v120;
        const double v149 = (((0.5 * v135) + (0.4999999999999999 * v143)) * v53) - v148;
        const double v152 = (v29 * v118) + (v20 * v116);
        const double v155 = v64 * v53;
        const double v158 = c63 * ((v152 * v53) + (v155 * v120));
        const double v161 = (0.5 * v158) + (0.4999999999999999 * v158);
        const double v163 = v74 * v53;
        const double v165 = (v161 * v53) + (v163 * v120);
        const double v169 = v76 * v53;
        const double v171 = (((v74 * v152) + (v57 * v165)) * v53) + (v169 * v120);
        const double v177 = (c79 * (((-0.2499999999999999) * v135) + (0.25 * v143))) * v35;
        const double v178 = v86 * v35;
        const double v179 = v178 * v131;
        const double v180 = v177 - v179;
        const double v183 = v87 * v13;
        const double v186 = v89 * v53;
        const double v187 = v186 * v120;
        const double v189 = (v149 + v171) + ((((v14 * (1.5 * v180)) - v183) * v53) - v187);
        const double v191 = v90 * v118;
        const double v195 = (v74 * v116) - (v30 * v165);
        const double v199 = c1 * ((v124 - v132) + v121);
        const double v203 = c1 * ((v138 - v140) + v121);
        const double v207 = (((0.5 * v199) + (0.4999999999999999 * v203)) * v53) - v148;
        const double v213 = (c79 * (((-0.2499999999999999) * v199) + (0.25 * v203))) * v35;
        const double v214 = v213 - v179;
        const double v220 = (v207 + v171) + ((((v14 * (1.5 * v214)) + v183) * v53) - v187);
        const double v225 = c224 * v53;
        const double v227 = (v57 * v225) * v53;
        const double v232 = c231 * v53;
        const double v234 = (v57 * v232) * v53;
        const double v238 = v24 * v10;
        const double v242 = (v32 * (v238 * v127)) + (v33 * v238);
        const double v243 = v125 * v242;
        const double v244 = v238 * v53;
        const double v246 = c1 * (v243 - v244);
        const double v248 = v139 * v242;
        const double v250 = c1 * (v248 - v244);
        const double v254 = v147 * v238;
        const double v255 = (((0.5 * v246) + (0.4999999999999999 * v250)) * v53) + v254;
        const double v256 = v30 * v10;
        const double v258 = v256 * v53;
        const double v261 = c63 * (v258 + (v155 * v238));
        const double v264 = (0.5 * v261) + (0.4999999999999999 * v261);
        const double v267 = (v264 * v53) + (v163 * v238);
        const double v272 = (((v74 * v256) + (v57 * v267)) * v53) + (v169 * v238);
        const double v278 = (c79 * (((-0.2499999999999999) * v246) + (0.25 * v250))) * v35;
        const double v279 = v178 * v242;
        const double v280 = v278 + v279;
        const double v284 = v186 * v238;
        const double v286 = (v255 - v272) + (((v14 * (1.5 * v280)) * v53) + v284);
        const double v288 = v30 * v267;
        const double v291 = c1 * (v244 - v243);
        const double v294 = c1 * (v244 - v248);
        const double v298 = (((0.5 * v291) + (0.4999999999999999 * v294)) * v53) - v254;
        const double v304 = (c79 * (((-0.2499999999999999) * v291) + (0.25 * v294))) * v35;
        const double v305 = v304 - v279;
        const double v310 = (v298 + v272) + (((v14 * (1.5 * v305)) * v53) - v284);
        const double v316 = (v32 * (v256 * v127)) + (v33 * v256);
        const double v317 = v125 * v316;
        const double v319 = c1 * (v317 - v258);
        const double v321 = v139 * v316;
        const double v323 = c1 * (v321 - v258);
        const double v327 = v147 * v256;
        const double v328 = (((0.5 * v319) + (0.4999999999999999 * v323)) * v53) + v327;
        const double v329 = v155 * v256;
        const double v331 = c63 * (v329 - v244);
        const double v334 = (0.5 * v331) + (0.4999999999999999 * v331);
        const double v336 = v163 * v256;
        const double v337 = (v334 * v53) + v336;
        const double v339 = v74 * v238;
        const double v342 = v169 * v256;
        const double v349 = (c79 * (((-0.2499999999999999) * v319) + (0.25 * v323))) * v35;
        const double v350 = v178 * v316;
        const double v351 = v349 + v350;
        const double v355 = v186 * v256;
        const double v357 = (v328 - ((((v57 * v337) - v339) * v53) + v342)) + (((v14 * (1.5 * v351)) * v53) + v355);
        const double v362 = c1 * (v258 - v317);
        const double v365 = c1 * (v258 - v321);
        const double v369 = (((0.5 * v362) + (0.4999999999999999 * v365)) * v53) - v327;
        const double v371 = c63 * (v244 - v329);
        const double v374 = (0.5 * v371) + (0.4999999999999999 * v371);
        const double v376 = (v374 * v53) - v336;
        const double v386 = (c79 * (((-0.2499999999999999) * v362) + (0.25 * v365))) * v35;
        const double v387 = v386 - v350;
        const double v392 = (v369 - (((v339 + (v57 * v376)) * v53) - v342)) + (((v14 * (1.5 * v387)) * v53) - v355);
        const double v404 = v90 * v116;
        const double v408 = (v24 * v165) + (v74 * v118);
        const double v420 = v24 * v267;
        const double v430 = g[7 * i + 1] * c11;
        const double v442 = v90 * v152;
        const double v464 = v90 * v256;
        const double v477 = v90 * v238;
        const double v528 = -(c494 * (c525 * v158));
        const double v533 = c494 * (c525 * v261);
        const double v534 = -v533;
        const double v536 = c494 * (c525 * v331);
        const double v538 = c494 * (c525 * v371);
        w3[i] = (v90 * v24) - (v74 * v30);
        w7[i] = -(v24 * v102);
        w8[i] = -(v24 * v113);
        w9[i] = ((v24 * v189) - v191) - v195;
        w10[i] = ((v24 * v220) - v191) - v195;
        w11[i] = (v24 * v227) + (v30 * v225);
        w12[i] = (v24 * v234) + (v30 * v232);
        w13[i] = (v24 * v286) - v288;
        w14[i] = (v24 * v310) + v288;
        w15[i] = (v24 * v357) - (v30 * v337);
        w16[i] = (v24 * v392) - (v30 * v376);
        w4[i] = (v90 * v30) + (v74 * v24);
        w17[i] = -(v30 * v102);
        w18[i] = -(v30 * v113);
        w19[i] = ((v30 * v189) + v404) - v408;
        w20[i] = ((v30 * v220) + v404) - v408;
        w21[i] = (v30 * v227) - (v24 * v225);
        w22[i] = (v30 * v234) - (v24 * v232);
        w23[i] = (v30 * v286) + v420;
        w24[i] = (v30 * v310) - v420;
        w25[i] = (v30 * v357) + (v24 * v337);
        w26[i] = (v30 * v392) + (v24 * v376);
        w5[i] = (v430 * (v73 - (v57 * v90))) * 0.5;
        w27[i] = 0.5 * (v430 * (v57 * v102));
        w28[i] = 0.5 * (v430 * (v57 * v113));
        w29[i] = -(0.5 * (v430 * (v161 + ((v57 * v189) - v442))));
        w30[i] = -(0.5 * (v430 * (v161 + ((v57 * v220) - v442))));
        w31[i] = -(0.5 * (v430 * (c224 + (v57 * v227))));
        w32[i] = -(0.5 * (v430 * (c231 + (v57 * v234))));
        w33[i] = 0.5 * (v430 * (v264 - (v464 + (v57 * v286))));
        w34[i] = -(0.5 * (v430 * (v264 + ((v57 * v310) - v464))));
        w35[i] = 0.5 * (v430 * (v334 - ((v57 * v357) - v477)));
        w36[i] = 0.5 * (v430 * (v374 - (v477 + (v57 * v392))));
        w6[i] = -v86;
        w37[i] = v98;
        w38[i] = v109;
        w39[i] = -v180;
        w40[i] = -v214;
        w41[i] = -v280;
        w42[i] = -v305;
        w43[i] = -v351;
        w44[i] = -v387;
        e[82 * i + 57] = c498;
        e[82 * i + 56] = c494 * (v135 * c499);
        e[82 * i + 60] = c494 * (v199 * c499);
        e[82 * i + 54] = c494 * (v246 * c499);
        e[82 * i + 58] = c494 * (v291 * c499);
        e[82 * i + 55] = c494 * (v319 * c499);
        e[82 * i + 59] = c494 * (v362 * c499);
        e[82 * i + 64] = c498;
        e[82 * i + 63] = c494 * (v143 * c499);
        e[82 * i + 67] = c494 * (v203 * c499);
        e[82 * i + 61] = c494 * (v250 * c499);
        e[82 * i + 65] = c494 * (v294 * c499);
        e[82 * i + 62] = c494 * (v323 * c499);
        e[82 * i + 66] = c494 * (v365 * c499);
        e[82 * i + 70] = v528;
        e[82 * i + 74] = v528;
        e[82 * i + 71] = c531;
        e[82 * i + 68] = v533;
        e[82 * i + 72] = v534;
        e[82 * i + 69] = v536;
        e[82 * i + 73] = v538;
        e[82 * i + 77] = v528;
        e[82 * i + 81] = v528;
        e[82 * i + 78] = c531;
        e[82 * i + 75] = v533;
        e[82 * i + 79] = v534;
        e[82 * i + 76] = v536;
        e[82 * i + 80] = v538;
    }
}

static void jacobian_5(int n, const double *p, const double *g, double *w, double *e)
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
    const double c1 = squared(p[11]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c111 = 0.0625 * c4;
    const double c113 = squared(p[1]);
    const double c114 = c111 * c113;
    const double c115 = c114 * c2;
    const double c116 = c1 / c115;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v119 = c116 * g[7 * i + 5];
        const double v152 = ((v119 * w39[i]) - (v119 * w40[i - 1])) + (v119 * w30[i - 1]);
        const double v181 = ((v119 * w41[i]) - (v119 * w42[i - 1])) + (v119 * w34[i - 1]);
        const double v202 = ((v119 * w43[i]) - (v119 * w44[i - 1])) + (v119 * w36[i - 1]);
        e[82 * i + 5] = -(v9 * w7[i - 1]);
        e[82 * i + 12] = v9 * w7[i];
        e[82 * i + 6] = -(v9 * w8[i - 1]);
        e[82 * i + 13] = v9 * w8[i];
        e[82 * i + 4] = -(v9 * w9[i - 1]);
        e[82 * i + 11] = (v9 * w9[i]) - (v9 * w10[i - 1]);
        e[82 * i + 18] = v9 * w10[i];
        e[82 * i + 7] = -(v9 * w11[i - 1]);
        e[82 * i + 14] = v9 * w11[i];
        e[82 * i + 8] = -(v9 * w12[i - 1]);
        e[82 * i + 15] = v9 * w12[i];
        e[82 * i + 2] = -(v9 * w13[i - 1]);
        e[82 * i + 9] = (v9 * w13[i]) - (v9 * w14[i - 1]);
        e[82 * i + 16] = v9 * w14[i];
        e[82 * i + 3] = -(v9 * w15[i - 1]);
        e[82 * i + 10] = (v9 * w15[i]) - (v9 * w16[i - 1]);
        e[82 * i + 17] = v9 * w16[i];
        e[82 * i + 22] = -(v9 * w17[i - 1]);
        e[82 * i + 29] = v9 * w17[i];
        e[82 * i + 23] = -(v9 * w18[i - 1]);
        e[82 * i + 30] = v9 * w18[i];
        e[82 * i + 21] = -(v9 * w19[i - 1]);
        e[82 * i + 28] = (v9 * w19[i]) - (v9 * w20[i - 1]);
        e[82 * i + 35] = v9 * w20[i];
        e[82 * i + 24] = -(v9 * w21[i - 1]);
        e[82 * i + 31] = v9 * w21[i];
        e[82 * i + 25] = -(v9 * w22[i - 1]);
        e[82 * i + 32] = v9 * w22[i];
        e[82 * i + 19] = -(v9 * w23[i - 1]);
        e[82 * i + 26] = (v9 * w23[i]) - (v9 * w24[i - 1]);
        e[82 * i + 33] = v9 * w24[i];
        e[82 * i + 20] = -(v9 * w25[i - 1]);
        e[82 * i + 27] = (v9 * w25[i]) - (v9 * w26[i - 1]);
        e[82 * i + 34] = v9 * w26[i];
        e[82 * i + 40] = (v119 * w27[i - 1]) - (v119 * w37[i - 1]);
        e[82 * i + 47] = (v119 * w37[i]) + (v119 * w27[i]);
        e[82 * i + 41] = (v119 * w28[i - 1]) - (v119 * w38[i - 1]);
        e[82 * i + 48] = (v119 * w38[i]) + (v119 * w28[i]);
        e[82 * i + 39] = (v119 * w29[i - 1]) - (v119 * w39[i - 1]);
        e[82 * i + 46] = v152 + (v119 * w29[i]);
        e[82 * i + 53] = (v119 * w40[i]) + (v119 * w30[i]);
        e[82 * i + 42] = v119 * w31[i - 1];
        e[82 * i + 49] = v119 * w31[i];
        e[82 * i + 43] = v119 * w32[i - 1];
        e[82 * i + 50] = v119 * w32[i];
        e[82 * i + 37] = (v119 * w33[i - 1]) - (v119 * w41[i - 1]);
        e[82 * i + 44] = v181 + (v119 * w33[i]);
        e[82 * i + 51] = (v119 * w42[i]) + (v119 * w34[i]);
        e[82 * i + 38] = (v119 * w35[i - 1]) - (v119 * w43[i - 1]);
        e[82 * i + 45] = v202 + (v119 * w35[i]);
        e[82 * i + 52] = (v119 * w44[i]) + (v119 * w36[i]);
    }
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
    const double c45 = 0.9 * c2;
    const double c47 = 2.0 * p[6];
    const double c48 = 2.0 + c47;
    const double c49 = c45 / c48;
    const double c61 = 1e-12 * c2;
    const double c62 = squared(c61);
    const double c65 = 1.0 / p[5];
    const double c88 = p[11];
    const double c90 = c11 / c88;
    const double c91 = squared(c90);
    const double c92 = p[2] * c91;
    const double c93 = c88 / c92;
    for (int i = 0; i < n - 1; i++) {
        const double v7 = w2[i + 1];
        const double v8 = w2[i];
        const double v10 = g[7 * i + 4];
        const double v15 = c6 * ((v7 - v8) * (v10 * c12));
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v23 = (v8 + v7) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w1[i + 1] - w1[i]) * v10;
        const double v30 = sin(v23);
        const double v32 = (v20 * v24) + (v29 * v30);
        const double v35 = 1.0 / (sqrt(v32) * v32);
        const double v39 = log(v32);
        const double v40 = ((((-0.4999999999999998) * v15) * v35) - y[10 * i + 6]) + v39;
        const double v53 = ((v29 * v24) - (v20 * v30)) / v32;
        const double v59 = squared((c2 * v40)) + (3.0 * squared((c49 * (v53 - y[10 * i + 8]))));
        const double v74 = (((0.5000000000000001 * v15) * v35) - y[10 * i + 7]) + v39;
        const double v82 = squared((c2 * v74)) + (3.0 * squared((c49 * (v53 - y[10 * i + 9]))));
        const double v86 = (0.5 * (larger(v59, c62) * c65)) + (0.4999999999999999 * (larger(v82, c62) * c65));
        q[0] += (g[7 * i + 1] * v86) * c93;
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
    const double c51 = 2.0 * p[6];
    const double c52 = 2.0 + c51;
    const double c53 = c49 / c52;
    const double c69 = p[11];
    const double c71 = c10 / c69;
    const double c72 = squared(c71);
    const double c73 = p[2] * c72;
    const double c74 = c69 / c73;
    const double c78 = 1.0 / p[5];
    for (int i = 0; i < n - 1; i++) {
        const double v5 = w2[i + 1];
        const double v6 = w2[i];
        const double v9 = g[7 * i + 4];
        const double v12 = v9 * c11;
        const double v14 = c4 * ((v5 - v6) * v12);
        const double v19 = (w0[i + 1] - w0[i]) * v9;
        const double v23 = (v6 + v5) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w1[i + 1] - w1[i]) * v9;
        const double v30 = sin(v23);
        const double v32 = (v19 * v24) + (v29 * v30);
        const double v33 = sqrt(v32);
        const double v35 = 1.0 / (v33 * v32);
        const double v36 = ((-0.4999999999999998) * v14) * v35;
        const double v39 = log(v32);
        const double v41 = c0 * ((v36 - y[10 * i + 6]) + v39);
        const double v57 = 1.0 / v32;
        const double v58 = ((v29 * v24) - (v19 * v30)) * v57;
        const double v61 = c53 * (v58 - y[10 * i + 8]);
        const double v64 = squared(v41) + (3.0 * squared(v61));
        const double v65 = (double)(c45 <= v64);
        const double v75 = g[7 * i + 1] * c74;
        const double v80 = (v65 / (v65 + (double)(v64 <= c45))) * ((0.5 * v75) * c78);
        const double v82 = c0 * ((2.0 * v41) * v80);
        const double v86 = (0.5000000000000001 * v14) * v35;
        const double v90 = c0 * ((v86 - y[10 * i + 7]) + v39);
        const double v95 = c53 * (v58 - y[10 * i + 9]);
        const double v98 = squared(v90) + (3.0 * squared(v95));
        const double v99 = (double)(c45 <= v98);
        const double v106 = (v99 / (v99 + (double)(v98 <= c45))) * ((0.4999999999999999 * v75) * c78);
        const double v108 = c0 * ((2.0 * v90) * v106);
        const double v111 = v58 * v57;
        const double v115 = c53 * ((2.0 * v95) * (3.0 * v106));
        const double v119 = (v86 * v35) * v108;
        const double v124 = 1.0 / (2.0 * v33);
        const double v126 = (((v108 * v57) - (v111 * v115)) - (v33 * v119)) - ((v32 * v119) * v124);
        const double v130 = c53 * ((2.0 * v61) * (3.0 * v80));
        const double v136 = (v36 * v35) * v82;
        const double v141 = (((v126 - (v111 * v130)) + (v82 * v57)) - (v33 * v136)) - ((v32 * v136) * v124);
        const double v145 = (v115 * v57) + (v130 * v57);
        const double v153 = (v24 * ((v29 * v141) - (v19 * v145))) - (v30 * ((v29 * v145) + (v19 * v141)));
        const double v154 = 0.5 * v153;
        const double v161 = (c4 * (0.5000000000000001 * (v108 * v35))) + (c4 * ((-0.4999999999999998) * (v82 * v35)));
        const double v162 = v12 * v161;
        const double v170 = ((v24 * v141) - (v30 * v145)) * v9;
        const double v175 = ((v24 * v145) + (v30 * v141)) * v9;
        s[10 * i + 6] += -v82;
        s[10 * i + 7] += -v108;
        s[10 * i + 4] += v154 - v162;
        s[10 * i + 14] += v154 + v162;
        s[10 * i + 8] += -v130;
        s[10 * i + 9] += -v115;
        s[10 * i] += -v170;
        s[10 * i + 10] += v170;
        s[10 * i + 1] += -v175;
        s[10 * i + 11] += v175;
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 10; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, w);
    rates_2(n, p, w);
    rates_3(n, p, w);
    rates_4(n, p, g, y, w, f);
    rates_5(n, p, g, w, f);
    return SOFTCAT_SOLVED;
}

static int jacobian(const softcat_filament *filament, double t, const double *y, double *e,
                    double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 82; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, y, w);
    jacobian_2(n, p, w);
    jacobian_3(n, p, w);
    jacobian_4(n, p, g, y, w, e);
    jacobian_5(n, p, g, w, e);
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
    for (int k = 0; k < n * 30; k++) s[k] = 0.0;
    work_slope_0(n, p, g, y, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {2, 3, -1, -1, 5, -1, -1, -1, -1, -1};
static const int differential[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int held_first[] = {1, 1, 1, 1, 1, 1, 0, 0, 0, 0};
static const int held_last[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9};
static const int offset[] = {0, 0, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 4, 6, 7, 8, 9, 0, 1, 4, 6, 7, 8, 9, 0, 1, 4, 0, 1, 4, 6, 7, 8, 9, 0, 1, 4, 6, 7, 8, 9, 0, 1, 4, 5, 0, 1, 4, 6, 7, 8, 9, 0, 1, 4, 6, 7, 8, 9, 0, 1, 4, 0, 1, 4, 6, 0, 1, 4, 0, 1, 4, 7, 0, 1, 4, 0, 1, 4, 8, 0, 1, 4, 0, 1, 4, 9, 0, 1, 4};

const softcat_model softcat_filament_model = {
    10, 4, 12, 7, 45, 82, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "youngs_modulus", "viscosity", "poisson",
    "span", "drop", "left_angle", "right_angle", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa", "Pa*s", "1", "m", "m", "rad", "rad", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_POSITIVE, SOFTCAT_ANY,
    SOFTCAT_ANY, SOFTCAT_ANY, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.08544003745317531, 0.01, 1020.0, 9.81, 15000.0, 7500.0, 0.45, 0.08, 0.03, 0.0, 0.0,
    0.09030472819714618};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "omega", "axial_0", "axial_1", "shear_0", "shear_1"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, (-0.4999999999999998), 0.5000000000000001, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Slime between hands at different heights",
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
    .span = 7,
    .drop = 8,
    .left_angle = 9,
    .right_angle = 10,
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
    .duration = 0.6,
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
