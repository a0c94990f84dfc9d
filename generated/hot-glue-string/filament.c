/*
 * String of hot glue, thin at one end
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, shear, surface-tension
 * Digest of the structure: 7dafb472a6989bdd7e8bcf801279da68ef2c05c702b55d24fe0f729281a8ea29
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[9 * i] = y[9 * i + 2];
        f[9 * i + 1] = y[9 * i + 3];
    }
}

static void rates_1(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[9 * i];
        w1[i] = y[9 * i + 1];
        w2[i] = y[9 * i + 4];
    }
}

static void rates_2(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
    (void)n;
}

static void rates_3(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = 0;
    w0[i] = -0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
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
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    const double c3 = p[4];
    const double c10 = p[0];
    const double c11 = 1.0 / c10;
    const double c62 = 0.9 * c3;
    const double c64 = 2.0 * p[6];
    const double c65 = 2.0 + c64;
    const double c66 = c62 / c65;
    const double c124 = p[5];
    const double c125 = 1.0 / c124;
    const double c127 = p[8];
    const double c132 = 3.0 / c124;
    for (int i = 0; i < n - 1; i++) {
        const double v0 = g[9 * i + 8];
        const double v1 = squared(v0);
        const double v5 = w2[i + 1];
        const double v6 = w2[i];
        const double v9 = g[9 * i + 4];
        const double v13 = (v5 - v6) * (v9 * c11);
        const double v16 = p[1] * v0;
        const double v21 = (w0[i + 1] - w0[i]) * v9;
        const double v24 = (v6 + v5) * 0.5;
        const double v25 = cos(v24);
        const double v30 = (w1[i + 1] - w1[i]) * v9;
        const double v31 = sin(v24);
        const double v33 = (v21 * v25) + (v30 * v31);
        const double v36 = 1.0 / (sqrt(v33) * v33);
        const double v40 = log(v33);
        const double v41 = ((((0.2499999999999999 * v13) * v16) * v36) - y[9 * i + 5]) + v40;
        const double v42 = c3 * v41;
        const double v50 = ((((-0.25000000000000006) * v13) * v16) * v36) - y[9 * i + 6];
        const double v52 = c3 * (v50 + v40);
        const double v55 = 1.0 / v33;
        const double v60 = (v30 * v25) - (v21 * v31);
        const double v67 = v60 * v55;
        const double v70 = c66 * (v67 - y[9 * i + 7]);
        const double v74 = c66 * (v67 - y[9 * i + 8]);
        const double v78 = v1 * (((0.5 * v70) + (0.4999999999999999 * v74)) * v55);
        const double v81 = (v1 * (((0.5 * v42) + (0.4999999999999999 * v52)) * v55)) - ((v60 * v78) * v55);
        const double v89 = (0.5 * (((-0.2499999999999999) * v42) + (0.25 * v52))) * v16;
        const double v91 = v1 * (v89 * v36);
        const double v95 = v81 + (((1.5 * v91) * v13) * v55);
        const double v98 = (v95 * v25) - (v78 * v31);
        const double v101 = (v95 * v31) + (v78 * v25);
        const double v105 = sqrt(squared(v21) + squared(v30));
        const double v112 = (((2.0 / sqrt(v105)) * (p[7] / v16)) * v1) / v105;
        const double v122 = ((g[9 * i + 1] * c10) * ((v78 * v33) - (v60 * v95))) * 0.5;
        w3[i] = v98;
        w4[i] = v101;
        w5[i] = v98 + (v112 * v21);
        w6[i] = v101 + (v112 * v30);
        w7[i] = v122;
        w8[i] = -v91;
        f[9 * i + 5] = (v42 * c125) * c127;
        f[9 * i + 6] = (v52 * c125) * c127;
        f[9 * i + 7] = (c132 * v70) * c127;
        f[9 * i + 8] = (c132 * v74) * c127;
    }
}

static void rates_5(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    const double c4 = squared(p[8]);
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
    const double c39 = squared(c5);
    const double c40 = c7 * c39;
    const double c41 = c32 / c40;
    for (int i = 1; i < n - 1; i++) {
        const double v12 = c9 * g[9 * i + 6];
        const double v38 = (((w8[i] - w8[i - 1]) + w7[i]) + w7[i - 1]) * (c34 * g[9 * i + 5]);
        f[9 * i + 2] = (w5[i] - w5[i - 1]) * v12;
        f[9 * i + 3] = ((w6[i] - w6[i - 1]) * v12) - c19;
        f[9 * i + 4] = v38 * c41;
    }
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[81 * i] = 1.0;
        e[81 * i + 1] = 1.0;
    }
}

static void jacobian_1(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[9 * i];
        w1[i] = y[9 * i + 1];
        w2[i] = y[9 * i + 4];
    }
}

static void jacobian_2(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
    (void)n;
}

static void jacobian_3(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const int i = 0;
    w0[i] = -0.5;
    w1[i] = 0.0;
    w2[i] = 0.0;
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
    const double c3 = p[4];
    const double c10 = p[0];
    const double c11 = 1.0 / c10;
    const double c62 = 0.9 * c3;
    const double c64 = 2.0 * p[6];
    const double c65 = 2.0 + c64;
    const double c66 = c62 / c65;
    const double c99 = 0.5 * c3;
    const double c103 = (-0.12499999999999994) * c3;
    const double c113 = 0.4999999999999999 * c3;
    const double c117 = 0.125 * c3;
    const double c243 = 0.5 * c66;
    const double c251 = 0.4999999999999999 * c66;
    const double c600 = p[8];
    const double c601 = p[5];
    const double c602 = c3 / c601;
    const double c603 = c600 * c602;
    const double c604 = -c603;
    const double c605 = 1.0 / c601;
    const double c631 = 3.0 / c601;
    const double c635 = c631 * c66;
    const double c636 = c600 * c635;
    const double c637 = -c636;
    for (int i = 0; i < n - 1; i++) {
        const double v0 = g[9 * i + 8];
        const double v1 = squared(v0);
        const double v5 = w2[i + 1];
        const double v6 = w2[i];
        const double v9 = g[9 * i + 4];
        const double v12 = v9 * c11;
        const double v13 = (v5 - v6) * v12;
        const double v16 = p[1] * v0;
        const double v21 = (w0[i + 1] - w0[i]) * v9;
        const double v24 = (v6 + v5) * 0.5;
        const double v25 = cos(v24);
        const double v30 = (w1[i + 1] - w1[i]) * v9;
        const double v31 = sin(v24);
        const double v33 = (v21 * v25) + (v30 * v31);
        const double v34 = sqrt(v33);
        const double v36 = 1.0 / (v34 * v33);
        const double v37 = ((0.2499999999999999 * v13) * v16) * v36;
        const double v40 = log(v33);
        const double v42 = c3 * ((v37 - y[9 * i + 5]) + v40);
        const double v48 = (((-0.25000000000000006) * v13) * v16) * v36;
        const double v52 = c3 * ((v48 - y[9 * i + 6]) + v40);
        const double v55 = 1.0 / v33;
        const double v56 = ((0.5 * v42) + (0.4999999999999999 * v52)) * v55;
        const double v60 = (v30 * v25) - (v21 * v31);
        const double v67 = v60 * v55;
        const double v76 = (0.5 * (c66 * (v67 - y[9 * i + 7]))) + (0.4999999999999999 * (c66 * (v67 - y[9 * i + 8])));
        const double v77 = v76 * v55;
        const double v78 = v1 * v77;
        const double v80 = (v60 * v78) * v55;
        const double v89 = (0.5 * (((-0.2499999999999999) * v42) + (0.25 * v52))) * v16;
        const double v90 = v89 * v36;
        const double v91 = v1 * v90;
        const double v92 = 1.5 * v91;
        const double v94 = (v92 * v13) * v55;
        const double v95 = ((v1 * v56) - v80) + v94;
        const double v98 = (v95 * v25) - (v78 * v31);
        const double v106 = v1 * ((v16 * c103) * v36);
        const double v110 = (v1 * (c99 * v55)) + ((v13 * (1.5 * v106)) * v55);
        const double v112 = -(v25 * v110);
        const double v120 = v1 * ((v16 * c117) * v36);
        const double v124 = (v1 * (c113 * v55)) + ((v13 * (1.5 * v120)) * v55);
        const double v126 = -(v25 * v124);
        const double v127 = 0.5 * v25;
        const double v129 = 0.5 * v31;
        const double v131 = (v30 * v127) - (v21 * v129);
        const double v132 = v131 * v55;
        const double v135 = (v16 * (0.2499999999999999 * v12)) * v36;
        const double v136 = v37 * v36;
        const double v138 = 1.0 / (2.0 * v34);
        const double v142 = (v33 * (v131 * v138)) + (v34 * v131);
        const double v143 = v136 * v142;
        const double v146 = c3 * (v132 - (v135 + v143));
        const double v150 = (v16 * ((-0.25000000000000006) * v12)) * v36;
        const double v151 = v48 * v36;
        const double v152 = v151 * v142;
        const double v155 = c3 * (v132 - (v150 + v152));
        const double v159 = v56 * v55;
        const double v160 = v159 * v131;
        const double v161 = (((0.5 * v146) + (0.4999999999999999 * v155)) * v55) - v160;
        const double v165 = (v30 * v129) + (v21 * v127);
        const double v168 = v67 * v55;
        const double v171 = c66 * ((v165 * v55) + (v168 * v131));
        const double v176 = v77 * v55;
        const double v178 = (((0.5 * v171) + (0.4999999999999999 * v171)) * v55) + (v176 * v131);
        const double v179 = v1 * v178;
        const double v183 = v80 * v55;
        const double v185 = (((v78 * v165) + (v60 * v179)) * v55) + (v183 * v131);
        const double v191 = v16 * (0.5 * (((-0.2499999999999999) * v146) + (0.25 * v155)));
        const double v193 = v90 * v36;
        const double v194 = v193 * v142;
        const double v196 = v1 * ((v191 * v36) - v194);
        const double v199 = v92 * v12;
        const double v202 = v94 * v55;
        const double v203 = v202 * v131;
        const double v205 = ((v1 * v161) + v185) + ((((v13 * (1.5 * v196)) - v199) * v55) - v203);
        const double v207 = v95 * v129;
        const double v211 = (v78 * v127) - (v31 * v179);
        const double v212 = ((v25 * v205) - v207) - v211;
        const double v215 = c3 * ((v135 - v143) + v132);
        const double v219 = c3 * ((v150 - v152) + v132);
        const double v223 = (((0.5 * v215) + (0.4999999999999999 * v219)) * v55) - v160;
        const double v230 = v16 * (0.5 * (((-0.2499999999999999) * v215) + (0.25 * v219)));
        const double v233 = v1 * ((v230 * v36) - v194);
        const double v239 = ((v1 * v223) + v185) + ((((v13 * (1.5 * v233)) + v199) * v55) - v203);
        const double v242 = ((v25 * v239) - v207) - v211;
        const double v245 = v1 * (c243 * v55);
        const double v247 = (v60 * v245) * v55;
        const double v250 = (v25 * v247) + (v31 * v245);
        const double v253 = v1 * (c251 * v55);
        const double v255 = (v60 * v253) * v55;
        const double v258 = (v25 * v255) + (v31 * v253);
        const double v259 = v25 * v9;
        const double v263 = (v33 * (v259 * v138)) + (v34 * v259);
        const double v264 = v136 * v263;
        const double v265 = v259 * v55;
        const double v267 = c3 * (v264 - v265);
        const double v269 = v151 * v263;
        const double v271 = c3 * (v269 - v265);
        const double v275 = v159 * v259;
        const double v276 = (((0.5 * v267) + (0.4999999999999999 * v271)) * v55) + v275;
        const double v278 = v31 * v9;
        const double v279 = v78 * v278;
        const double v280 = v278 * v55;
        const double v283 = c66 * (v280 + (v168 * v259));
        const double v289 = (((0.5 * v283) + (0.4999999999999999 * v283)) * v55) + (v176 * v259);
        const double v290 = v1 * v289;
        const double v295 = ((v279 + (v60 * v290)) * v55) + (v183 * v259);
        const double v301 = v16 * (0.5 * (((-0.2499999999999999) * v267) + (0.25 * v271)));
        const double v303 = v193 * v263;
        const double v305 = v1 * ((v301 * v36) + v303);
        const double v309 = v202 * v259;
        const double v311 = ((v1 * v276) - v295) + (((v13 * (1.5 * v305)) * v55) + v309);
        const double v313 = v31 * v290;
        const double v314 = (v25 * v311) - v313;
        const double v316 = c3 * (v265 - v264);
        const double v319 = c3 * (v265 - v269);
        const double v323 = (((0.5 * v316) + (0.4999999999999999 * v319)) * v55) - v275;
        const double v330 = v16 * (0.5 * (((-0.2499999999999999) * v316) + (0.25 * v319)));
        const double v333 = v1 * ((v330 * v36) - v303);
        const double v338 = ((v1 * v323) + v295) + (((v13 * (1.5 * v333)) * v55) - v309);
        const double v340 = (v25 * v338) + v313;
        const double v344 = (v33 * (v278 * v138)) + (v34 * v278);
        const double v345 = v136 * v344;
        const double v347 = c3 * (v345 - v280);
        const double v349 = v151 * v344;
        const double v351 = c3 * (v349 - v280);
        const double v355 = v159 * v278;
        const double v356 = (((0.5 * v347) + (0.4999999999999999 * v351)) * v55) + v355;
        const double v358 = v168 * v278;
        const double v360 = c66 * (v358 - v265);
        const double v365 = v176 * v278;
        const double v366 = (((0.5 * v360) + (0.4999999999999999 * v360)) * v55) + v365;
        const double v367 = v1 * v366;
        const double v369 = v78 * v259;
        const double v372 = v183 * v278;
        const double v379 = v16 * (0.5 * (((-0.2499999999999999) * v347) + (0.25 * v351)));
        const double v381 = v193 * v344;
        const double v383 = v1 * ((v379 * v36) + v381);
        const double v387 = v202 * v278;
        const double v389 = ((v1 * v356) - ((((v60 * v367) - v369) * v55) + v372)) + (((v13 * (1.5 * v383)) * v55) + v387);
        const double v392 = (v25 * v389) - (v31 * v367);
        const double v394 = c3 * (v280 - v345);
        const double v397 = c3 * (v280 - v349);
        const double v401 = (((0.5 * v394) + (0.4999999999999999 * v397)) * v55) - v355;
        const double v404 = c66 * (v265 - v358);
        const double v409 = (((0.5 * v404) + (0.4999999999999999 * v404)) * v55) - v365;
        const double v410 = v1 * v409;
        const double v420 = v16 * (0.5 * (((-0.2499999999999999) * v394) + (0.25 * v397)));
        const double v423 = v1 * ((v420 * v36) - v381);
        const double v428 = ((v1 * v401) - (((v369 + (v60 * v410)) * v55) - v372)) + (((v13 * (1.5 * v423)) * v55) - v387);
        const double v431 = (v25 * v428) - (v31 * v410);
        const double v434 = (v95 * v31) + (v78 * v25);
        const double v436 = -(v31 * v110);
        const double v438 = -(v31 * v124);
        const double v440 = v95 * v127;
        const double v444 = (v25 * v179) + (v78 * v129);
        const double v445 = ((v31 * v205) + v440) - v444;
        const double v448 = ((v31 * v239) + v440) - v444;
        const double v451 = (v31 * v247) - (v25 * v245);
        const double v454 = (v31 * v255) - (v25 * v253);
        const double v456 = v25 * v290;
        const double v457 = (v31 * v311) + v456;
        const double v459 = (v31 * v338) - v456;
        const double v462 = (v31 * v389) + (v25 * v367);
        const double v465 = (v31 * v428) + (v25 * v410);
        const double v469 = sqrt(squared(v21) + squared(v30));
        const double v470 = sqrt(v469);
        const double v471 = 1.0 / v470;
        const double v472 = 2.0 * v471;
        const double v474 = p[7] / v16;
        const double v477 = 1.0 / v469;
        const double v478 = ((v472 * v474) * v1) * v477;
        const double v481 = v472 * v471;
        const double v485 = 1.0 / (2.0 * v469);
        const double v486 = ((2.0 * v21) * v9) * v485;
        const double v488 = 1.0 / (2.0 * v470);
        const double v494 = v478 * v477;
        const double v496 = ((v1 * (v474 * (v481 * (v486 * v488)))) * v477) + (v494 * v486);
        const double v497 = v21 * v496;
        const double v498 = v478 * v9;
        const double v505 = ((2.0 * v30) * v9) * v485;
        const double v512 = ((v1 * (v474 * (v481 * (v505 * v488)))) * v477) + (v494 * v505);
        const double v513 = v21 * v512;
        const double v518 = v30 * v496;
        const double v521 = v30 * v512;
        const double v526 = g[9 * i + 1] * c10;
        const double v540 = (v78 * v131) - (v33 * v179);
        const double v542 = v95 * v165;
        const double v564 = v33 * v290;
        const double v566 = v95 * v278;
        const double v581 = v95 * v259;
        const double v585 = 0.5 * (v526 * (((v33 * v367) - v279) - ((v60 * v389) - v581)));
        const double v592 = 0.5 * (v526 * (((v33 * v410) + v279) - (v581 + (v60 * v428))));
        const double v634 = -(c600 * (c631 * v171));
        const double v639 = c600 * (c631 * v283);
        const double v640 = -v639;
        const double v642 = c600 * (c631 * v360);
        const double v644 = c600 * (c631 * v404);
        w3[i] = v98;
        w9[i] = v112;
        w10[i] = v126;
        w11[i] = v212;
        w12[i] = v242;
        w13[i] = v250;
        w14[i] = v258;
        w15[i] = v314;
        w16[i] = v340;
        w17[i] = v392;
        w18[i] = v431;
        w4[i] = v434;
        w19[i] = v436;
        w20[i] = v438;
        w21[i] = v445;
        w22[i] = v448;
        w23[i] = v451;
        w24[i] = v454;
        w25[i] = v457;
        w26[i] = v459;
        w27[i] = v462;
        w28[i] = v465;
        w5[i] = v98 + (v478 * v21);
        w29[i] = v112;
        w30[i] = v126;
        w31[i] = v212;
        w32[i] = v242;
        w33[i] = v250;
        w34[i] = v258;
        w35[i] = v314 + (v497 - v498);
        w36[i] = v340 + (v498 - v497);
        w37[i] = v392 + v513;
        w38[i] = v431 - v513;
        w6[i] = v434 + (v478 * v30);
        w39[i] = v436;
        w40[i] = v438;
        w41[i] = v445;
        w42[i] = v448;
        w43[i] = v451;
        w44[i] = v454;
        w45[i] = v457 + v518;
        w46[i] = v459 - v518;
        w47[i] = v462 + (v521 - v498);
        w48[i] = v465 + (v498 - v521);
        w7[i] = (v526 * ((v78 * v33) - (v60 * v95))) * 0.5;
        w49[i] = 0.5 * (v526 * (v60 * v110));
        w50[i] = 0.5 * (v526 * (v60 * v124));
        w51[i] = 0.5 * (v526 * (v540 - ((v60 * v205) - v542)));
        w52[i] = 0.5 * (v526 * (v540 - ((v60 * v239) - v542)));
        w53[i] = -(0.5 * (v526 * ((v33 * v245) + (v60 * v247))));
        w54[i] = -(0.5 * (v526 * ((v33 * v253) + (v60 * v255))));
        w55[i] = 0.5 * (v526 * ((v564 - v369) - (v566 + (v60 * v311))));
        w56[i] = 0.5 * (v526 * ((v369 - v564) - ((v60 * v338) - v566)));
        w57[i] = v585;
        w58[i] = v592;
        w8[i] = -v91;
        w59[i] = v106;
        w60[i] = v120;
        w61[i] = -v196;
        w62[i] = -v233;
        w63[i] = -v305;
        w64[i] = -v333;
        w65[i] = -v383;
        w66[i] = -v423;
        e[81 * i + 56] = c604;
        e[81 * i + 55] = c600 * (v146 * c605);
        e[81 * i + 59] = c600 * (v215 * c605);
        e[81 * i + 53] = c600 * (v267 * c605);
        e[81 * i + 57] = c600 * (v316 * c605);
        e[81 * i + 54] = c600 * (v347 * c605);
        e[81 * i + 58] = c600 * (v394 * c605);
        e[81 * i + 63] = c604;
        e[81 * i + 62] = c600 * (v155 * c605);
        e[81 * i + 66] = c600 * (v219 * c605);
        e[81 * i + 60] = c600 * (v271 * c605);
        e[81 * i + 64] = c600 * (v319 * c605);
        e[81 * i + 61] = c600 * (v351 * c605);
        e[81 * i + 65] = c600 * (v397 * c605);
        e[81 * i + 69] = v634;
        e[81 * i + 73] = v634;
        e[81 * i + 70] = c637;
        e[81 * i + 67] = v639;
        e[81 * i + 71] = v640;
        e[81 * i + 68] = v642;
        e[81 * i + 72] = v644;
        e[81 * i + 76] = v634;
        e[81 * i + 80] = v634;
        e[81 * i + 77] = c637;
        e[81 * i + 74] = v639;
        e[81 * i + 78] = v640;
        e[81 * i + 75] = v642;
        e[81 * i + 79] = v644;
    }
}

static void jacobian_5(int n, const double *p, const double *g, double *w, double *e)
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
    const double c1 = squared(p[8]);
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
    const double c120 = squared(c2);
    const double c121 = c4 * c120;
    const double c122 = c114 / c121;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[9 * i + 6];
        const double v123 = (c116 * g[9 * i + 5]) * c122;
        const double v156 = ((v123 * w61[i]) - (v123 * w62[i - 1])) + (v123 * w52[i - 1]);
        const double v185 = ((v123 * w63[i]) - (v123 * w64[i - 1])) + (v123 * w56[i - 1]);
        const double v206 = ((v123 * w65[i]) - (v123 * w66[i - 1])) + (v123 * w58[i - 1]);
        e[81 * i + 5] = -(v9 * w29[i - 1]);
        e[81 * i + 12] = v9 * w29[i];
        e[81 * i + 6] = -(v9 * w30[i - 1]);
        e[81 * i + 13] = v9 * w30[i];
        e[81 * i + 4] = -(v9 * w31[i - 1]);
        e[81 * i + 11] = (v9 * w31[i]) - (v9 * w32[i - 1]);
        e[81 * i + 18] = v9 * w32[i];
        e[81 * i + 7] = -(v9 * w33[i - 1]);
        e[81 * i + 14] = v9 * w33[i];
        e[81 * i + 8] = -(v9 * w34[i - 1]);
        e[81 * i + 15] = v9 * w34[i];
        e[81 * i + 2] = -(v9 * w35[i - 1]);
        e[81 * i + 9] = (v9 * w35[i]) - (v9 * w36[i - 1]);
        e[81 * i + 16] = v9 * w36[i];
        e[81 * i + 3] = -(v9 * w37[i - 1]);
        e[81 * i + 10] = (v9 * w37[i]) - (v9 * w38[i - 1]);
        e[81 * i + 17] = v9 * w38[i];
        e[81 * i + 22] = -(v9 * w39[i - 1]);
        e[81 * i + 29] = v9 * w39[i];
        e[81 * i + 23] = -(v9 * w40[i - 1]);
        e[81 * i + 30] = v9 * w40[i];
        e[81 * i + 21] = -(v9 * w41[i - 1]);
        e[81 * i + 28] = (v9 * w41[i]) - (v9 * w42[i - 1]);
        e[81 * i + 35] = v9 * w42[i];
        e[81 * i + 24] = -(v9 * w43[i - 1]);
        e[81 * i + 31] = v9 * w43[i];
        e[81 * i + 25] = -(v9 * w44[i - 1]);
        e[81 * i + 32] = v9 * w44[i];
        e[81 * i + 19] = -(v9 * w45[i - 1]);
        e[81 * i + 26] = (v9 * w45[i]) - (v9 * w46[i - 1]);
        e[81 * i + 33] = v9 * w46[i];
        e[81 * i + 20] = -(v9 * w47[i - 1]);
        e[81 * i + 27] = (v9 * w47[i]) - (v9 * w48[i - 1]);
        e[81 * i + 34] = v9 * w48[i];
        e[81 * i + 39] = (v123 * w49[i - 1]) - (v123 * w59[i - 1]);
        e[81 * i + 46] = (v123 * w59[i]) + (v123 * w49[i]);
        e[81 * i + 40] = (v123 * w50[i - 1]) - (v123 * w60[i - 1]);
        e[81 * i + 47] = (v123 * w60[i]) + (v123 * w50[i]);
        e[81 * i + 38] = (v123 * w51[i - 1]) - (v123 * w61[i - 1]);
        e[81 * i + 45] = v156 + (v123 * w51[i]);
        e[81 * i + 52] = (v123 * w62[i]) + (v123 * w52[i]);
        e[81 * i + 41] = v123 * w53[i - 1];
        e[81 * i + 48] = v123 * w53[i];
        e[81 * i + 42] = v123 * w54[i - 1];
        e[81 * i + 49] = v123 * w54[i];
        e[81 * i + 36] = (v123 * w55[i - 1]) - (v123 * w63[i - 1]);
        e[81 * i + 43] = v185 + (v123 * w55[i]);
        e[81 * i + 50] = (v123 * w64[i]) + (v123 * w56[i]);
        e[81 * i + 37] = (v123 * w57[i - 1]) - (v123 * w65[i - 1]);
        e[81 * i + 44] = v206 + (v123 * w57[i]);
        e[81 * i + 51] = (v123 * w66[i]) + (v123 * w58[i]);
    }
}

static void work_0(int n, const double *p, const double *g, const double *y, double *w, double *q)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c5 = p[4];
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c47 = 0.9 * c5;
    const double c49 = 2.0 * p[6];
    const double c50 = 2.0 + c49;
    const double c51 = c47 / c50;
    const double c63 = 1e-12 * c5;
    const double c64 = squared(c63);
    const double c67 = 1.0 / p[5];
    const double c91 = p[8];
    const double c93 = c11 / c91;
    const double c94 = squared(c93);
    const double c95 = p[2] * c94;
    const double c96 = c91 / c95;
    for (int i = 0; i < n - 1; i++) {
        const double v1 = g[9 * i + 8];
        const double v7 = w2[i + 1];
        const double v8 = w2[i];
        const double v10 = g[9 * i + 4];
        const double v14 = (v7 - v8) * (v10 * c12);
        const double v17 = p[1] * v1;
        const double v22 = (w0[i + 1] - w0[i]) * v10;
        const double v25 = (v8 + v7) * 0.5;
        const double v26 = cos(v25);
        const double v31 = (w1[i + 1] - w1[i]) * v10;
        const double v32 = sin(v25);
        const double v34 = (v22 * v26) + (v31 * v32);
        const double v37 = 1.0 / (sqrt(v34) * v34);
        const double v41 = log(v34);
        const double v42 = ((((0.2499999999999999 * v14) * v17) * v37) - y[9 * i + 5]) + v41;
        const double v55 = ((v31 * v26) - (v22 * v32)) / v34;
        const double v61 = squared((c5 * v42)) + (3.0 * squared((c51 * (v55 - y[9 * i + 7]))));
        const double v76 = ((((-0.25000000000000006) * v14) * v17) * v37) - y[9 * i + 6];
        const double v85 = squared((c5 * (v76 + v41))) + (3.0 * squared((c51 * (v55 - y[9 * i + 8]))));
        const double v89 = (0.5 * (larger(v61, c64) * c67)) + (0.4999999999999999 * (larger(v85, c64) * c67));
        q[0] += ((g[9 * i + 1] * squared(v1)) * v89) * c96;
    }
}

static void work_slope_0(int n, const double *p, const double *g, const double *y, double *w, double *s)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c0 = p[4];
    const double c7 = p[0];
    const double c8 = 1.0 / c7;
    const double c44 = 1e-12 * c0;
    const double c45 = squared(c44);
    const double c49 = 0.9 * c0;
    const double c51 = 2.0 * p[6];
    const double c52 = 2.0 + c51;
    const double c53 = c49 / c52;
    const double c71 = p[8];
    const double c73 = c7 / c71;
    const double c74 = squared(c73);
    const double c75 = p[2] * c74;
    const double c76 = c71 / c75;
    const double c80 = 1.0 / p[5];
    for (int i = 0; i < n - 1; i++) {
        const double v2 = w2[i + 1];
        const double v3 = w2[i];
        const double v6 = g[9 * i + 4];
        const double v9 = v6 * c8;
        const double v10 = (v2 - v3) * v9;
        const double v13 = g[9 * i + 8];
        const double v14 = p[1] * v13;
        const double v19 = (w0[i + 1] - w0[i]) * v6;
        const double v23 = (v3 + v2) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w1[i + 1] - w1[i]) * v6;
        const double v30 = sin(v23);
        const double v32 = (v19 * v24) + (v29 * v30);
        const double v33 = sqrt(v32);
        const double v35 = 1.0 / (v33 * v32);
        const double v36 = ((0.2499999999999999 * v10) * v14) * v35;
        const double v39 = log(v32);
        const double v41 = c0 * ((v36 - y[9 * i + 5]) + v39);
        const double v57 = 1.0 / v32;
        const double v58 = ((v29 * v24) - (v19 * v30)) * v57;
        const double v61 = c53 * (v58 - y[9 * i + 7]);
        const double v64 = squared(v41) + (3.0 * squared(v61));
        const double v65 = (double)(c45 <= v64);
        const double v77 = (g[9 * i + 1] * squared(v13)) * c76;
        const double v82 = (v65 / (v65 + (double)(v64 <= c45))) * ((0.5 * v77) * c80);
        const double v84 = c0 * ((2.0 * v41) * v82);
        const double v89 = (((-0.25000000000000006) * v10) * v14) * v35;
        const double v93 = c0 * ((v89 - y[9 * i + 6]) + v39);
        const double v98 = c53 * (v58 - y[9 * i + 8]);
        const double v101 = squared(v93) + (3.0 * squared(v98));
        const double v102 = (double)(c45 <= v101);
        const double v109 = (v102 / (v102 + (double)(v101 <= c45))) * ((0.4999999999999999 * v77) * c80);
        const double v111 = c0 * ((2.0 * v93) * v109);
        const double v114 = v58 * v57;
        const double v118 = c53 * ((2.0 * v98) * (3.0 * v109));
        const double v122 = (v89 * v35) * v111;
        const double v127 = 1.0 / (2.0 * v33);
        const double v129 = (((v111 * v57) - (v114 * v118)) - (v33 * v122)) - ((v32 * v122) * v127);
        const double v133 = c53 * ((2.0 * v61) * (3.0 * v82));
        const double v139 = (v36 * v35) * v84;
        const double v144 = (((v129 - (v114 * v133)) + (v84 * v57)) - (v33 * v139)) - ((v32 * v139) * v127);
        const double v148 = (v118 * v57) + (v133 * v57);
        const double v156 = (v24 * ((v29 * v144) - (v19 * v148))) - (v30 * ((v29 * v148) + (v19 * v144)));
        const double v157 = 0.5 * v156;
        const double v164 = ((-0.25000000000000006) * (v14 * (v111 * v35))) + (0.2499999999999999 * (v14 * (v84 * v35)));
        const double v165 = v9 * v164;
        const double v173 = ((v24 * v144) - (v30 * v148)) * v6;
        const double v178 = ((v24 * v148) + (v30 * v144)) * v6;
        s[9 * i + 5] += -v84;
        s[9 * i + 6] += -v111;
        s[9 * i + 4] += v157 - v165;
        s[9 * i + 13] += v157 + v165;
        s[9 * i + 7] += -v133;
        s[9 * i + 8] += -v118;
        s[9 * i] += -v173;
        s[9 * i + 9] += v173;
        s[9 * i + 1] += -v178;
        s[9 * i + 10] += v178;
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 9; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, w);
    rates_2(n, w);
    rates_3(n, w);
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
    for (int k = 0; k < n * 81; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, y, w);
    jacobian_2(n, w);
    jacobian_3(n, w);
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
    for (int k = 0; k < n * 27; k++) s[k] = 0.0;
    work_slope_0(n, p, g, y, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {2, 3, -1, -1, -1, -1, -1, -1, -1};
static const int differential[] = {1, 1, 1, 1, 0, 1, 1, 1, 1};
static const int held_first[] = {1, 1, 1, 1, 1, 0, 0, 0, 0};
static const int held_last[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8};
static const int offset[] = {0, 0, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 0, 1, 4, 5, 0, 1, 4, 0, 1, 4, 6, 0, 1, 4, 0, 1, 4, 7, 0, 1, 4, 0, 1, 4, 8, 0, 1, 4};

const softcat_model softcat_filament_model = {
    9, 4, 9, 9, 67, 81, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "youngs_modulus", "viscosity", "poisson",
    "surface_tension", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa", "Pa*s", "1", "N/m", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.08, 0.003, 950.0, 9.81, 300000.0, 3000.0, 0.45, 0.03, 0.09030472819714618};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0", "axial_1", "shear_0", "shear_1"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS,
    SOFTCAT_PLACE_H_NODE, SOFTCAT_PLACE_H_CELL};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, (-0.4999999999999998), 0.5000000000000001, 0.0, 0.0};
static const double described_thickness[] = {
    1.0, 0.9, 0.8, 0.7, 0.6};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "String of hot glue, thin at one end",
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
    .profiled = 1,
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
    .thickness = described_thickness,
    .thickness_count = 5,
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
