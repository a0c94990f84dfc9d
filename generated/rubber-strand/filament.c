/*
 * Rubber strand: catches, then creeps to its long-time sag
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, gravity-ramp, shear
 * Digest of the structure: 6037a6d76c91a6fcfea34d777bea6448afa4259745e16107b08931c7563904bc
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
        f[9 * i] = y[9 * i + 2];
    }
}

static void rates_1(int n, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[9 * i + 1] = y[9 * i + 3];
    }
}

static void rates_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[9 * i];
        w1[i] = y[9 * i + 4];
    }
}

static void rates_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[9 * i + 1];
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
    const double c40 = p[8];
    const double c65 = 0.8333333333333334 * c1;
    const double c67 = 2.0 * p[7];
    const double c68 = 2.0 + c67;
    const double c69 = c65 / c68;
    const double c72 = 0.8333333333333334 * c40;
    const double c73 = c72 / c68;
    const double c90 = 0.5 * c4;
    const double c114 = p[6];
    const double c115 = 1.0 / c114;
    const double c117 = p[9];
    const double c122 = 3.0 / c114;
    for (int i = 0; i < n - 1; i++) {
        const double v6 = w1[i + 1];
        const double v7 = w1[i];
        const double v10 = g[7 * i + 4];
        const double v14 = (v6 - v7) * (v10 * c12);
        const double v15 = c5 * v14;
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v23 = (v7 + v6) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w2[i + 1] - w2[i]) * v10;
        const double v30 = sin(v23);
        const double v32 = (v20 * v24) + (v29 * v30);
        const double v35 = 1.0 / (sqrt(v32) * v32);
        const double v36 = ((-0.5773502691896257) * v15) * v35;
        const double v37 = log(v32);
        const double v44 = c40 * ((v36 - y[9 * i + 5]) + v37);
        const double v45 = (c1 * (v36 + v37)) + v44;
        const double v49 = (0.5773502691896257 * v15) * v35;
        const double v55 = c40 * ((v49 - y[9 * i + 6]) + v37);
        const double v56 = (c1 * (v49 + v37)) + v55;
        const double v59 = 1.0 / v32;
        const double v63 = (v29 * v24) - (v20 * v30);
        const double v70 = v63 * v59;
        const double v71 = c69 * v70;
        const double v76 = c73 * (v70 - y[9 * i + 7]);
        const double v81 = c73 * (v70 - y[9 * i + 8]);
        const double v84 = (0.5 * (v71 + v76)) + (0.5 * (v71 + v81));
        const double v85 = v84 * v59;
        const double v95 = ((-0.28867513459481287) * v45) + (0.28867513459481287 * v56);
        const double v97 = (c90 * v95) * v35;
        const double v101 = ((((0.5 * v45) + (0.5 * v56)) * v59) - ((v63 * v85) * v59)) + (((1.5 * v97) * v14) * v59);
        w3[i] = (v101 * v24) - (v85 * v30);
        w4[i] = (v101 * v30) + (v85 * v24);
        w5[i] = ((g[7 * i + 1] * c11) * (v84 - (v63 * v101))) * 0.5;
        w6[i] = -v97;
        f[9 * i + 5] = (v44 * c115) * c117;
        f[9 * i + 6] = (v55 * c115) * c117;
        f[9 * i + 7] = (c122 * v76) * c117;
        f[9 * i + 8] = (c122 * v81) * c117;
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
    const double c22 = 0.08333333333333333 * c7;
    const double c24 = squared(p[1]);
    const double c25 = c22 * c24;
    const double c26 = c25 * c5;
    const double c27 = c4 / c26;
    const double c32 = squared(c5);
    const double c33 = c7 * c32;
    const double c34 = c25 / c33;
    for (int i = 1; i < n - 1; i++) {
        const double v31 = (((w6[i] - w6[i - 1]) + w5[i]) + w5[i - 1]) * (c27 * g[7 * i + 5]);
        f[9 * i + 2] = (w3[i] - w3[i - 1]) * (c9 * g[7 * i + 6]);
        f[9 * i + 4] = v31 * c34;
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
        f[9 * i + 3] = ((w4[i] - w4[i - 1]) * (c9 * g[7 * i + 6])) - c34;
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
    f[9 * i + 3] = (w4[i] * (c7 * g[7 * i + 6])) - c32;
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[81 * i] = 1.0;
    }
}

static void jacobian_1(int n, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[81 * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[9 * i];
        w1[i] = y[9 * i + 4];
    }
}

static void jacobian_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[9 * i + 1];
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
    const double c1 = p[5];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c40 = p[8];
    const double c65 = 0.8333333333333334 * c1;
    const double c67 = 2.0 * p[7];
    const double c68 = 2.0 + c67;
    const double c69 = c65 / c68;
    const double c72 = 0.8333333333333334 * c40;
    const double c73 = c72 / c68;
    const double c90 = 0.5 * c4;
    const double c105 = 0.5 * c40;
    const double c107 = (-0.28867513459481287) * c40;
    const double c108 = c90 * c107;
    const double c116 = 0.28867513459481287 * c40;
    const double c117 = c90 * c116;
    const double c240 = 0.5 * c73;
    const double c508 = p[9];
    const double c509 = p[6];
    const double c510 = c40 / c509;
    const double c511 = c508 * c510;
    const double c512 = -c511;
    const double c513 = 1.0 / c509;
    const double c539 = 3.0 / c509;
    const double c543 = c539 * c73;
    const double c544 = c508 * c543;
    const double c545 = -c544;
    for (int i = 0; i < n - 1; i++) {
        const double v6 = w1[i + 1];
        const double v7 = w1[i];
        const double v10 = g[7 * i + 4];
        const double v13 = v10 * c12;
        const double v14 = (v6 - v7) * v13;
        const double v15 = c5 * v14;
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v23 = (v7 + v6) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w2[i + 1] - w2[i]) * v10;
        const double v30 = sin(v23);
        const double v32 = (v20 * v24) + (v29 * v30);
        const double v33 = sqrt(v32);
        const double v35 = 1.0 / (v33 * v32);
        const double v36 = ((-0.5773502691896257) * v15) * v35;
        const double v37 = log(v32);
        const double v45 = (c1 * (v36 + v37)) + (c40 * ((v36 - y[9 * i + 5]) + v37));
        const double v49 = (0.5773502691896257 * v15) * v35;
        const double v56 = (c1 * (v49 + v37)) + (c40 * ((v49 - y[9 * i + 6]) + v37));
        const double v59 = 1.0 / v32;
        const double v60 = ((0.5 * v45) + (0.5 * v56)) * v59;
        const double v63 = (v29 * v24) - (v20 * v30);
        const double v70 = v63 * v59;
        const double v71 = c69 * v70;
        const double v84 = (0.5 * (v71 + (c73 * (v70 - y[9 * i + 7])))) + (0.5 * (v71 + (c73 * (v70 - y[9 * i + 8]))));
        const double v85 = v84 * v59;
        const double v87 = (v63 * v85) * v59;
        const double v95 = ((-0.28867513459481287) * v45) + (0.28867513459481287 * v56);
        const double v97 = (c90 * v95) * v35;
        const double v98 = 1.5 * v97;
        const double v100 = (v98 * v14) * v59;
        const double v101 = (v60 - v87) + v100;
        const double v106 = c105 * v59;
        const double v109 = c108 * v35;
        const double v113 = v106 + ((v14 * (1.5 * v109)) * v59);
        const double v118 = c117 * v35;
        const double v122 = v106 + ((v14 * (1.5 * v118)) * v59);
        const double v125 = 0.5 * v24;
        const double v127 = 0.5 * v30;
        const double v129 = (v29 * v125) - (v20 * v127);
        const double v130 = v129 * v59;
        const double v131 = c5 * v13;
        const double v133 = ((-0.5773502691896257) * v131) * v35;
        const double v134 = v36 * v35;
        const double v136 = 1.0 / (2.0 * v33);
        const double v140 = (v32 * (v129 * v136)) + (v33 * v129);
        const double v141 = v134 * v140;
        const double v143 = v130 - (v133 + v141);
        const double v145 = c40 * v143;
        const double v146 = (c1 * v143) + v145;
        const double v149 = (0.5773502691896257 * v131) * v35;
        const double v150 = v49 * v35;
        const double v151 = v150 * v140;
        const double v153 = v130 - (v149 + v151);
        const double v155 = c40 * v153;
        const double v156 = (c1 * v153) + v155;
        const double v160 = v60 * v59;
        const double v161 = v160 * v129;
        const double v165 = (v29 * v127) + (v20 * v125);
        const double v168 = v70 * v59;
        const double v170 = (v165 * v59) + (v168 * v129);
        const double v172 = c73 * v170;
        const double v173 = (c69 * v170) + v172;
        const double v175 = v85 * v59;
        const double v177 = (v173 * v59) + (v175 * v129);
        const double v181 = v87 * v59;
        const double v183 = (((v85 * v165) + (v63 * v177)) * v59) + (v181 * v129);
        const double v187 = ((-0.28867513459481287) * v146) + (0.28867513459481287 * v156);
        const double v190 = v97 * v35;
        const double v191 = v190 * v140;
        const double v192 = ((c90 * v187) * v35) - v191;
        const double v195 = v98 * v13;
        const double v198 = v100 * v59;
        const double v199 = v198 * v129;
        const double v201 = (((((0.5 * v146) + (0.5 * v156)) * v59) - v161) + v183) + ((((v14 * (1.5 * v192)) - v195) * v59) - v199);
        const double v203 = v101 * v127;
        const double v207 = (v85 * v125) - (v30 * v177);
        const double v210 = (v133 - v141) + v130;
        const double v212 = c40 * v210;
        const double v213 = (c1 * v210) + v212;
        const double v216 = (v149 - v151) + v130;
        const double v218 = c40 * v216;
        const double v219 = (c1 * v216) + v218;
        const double v227 = ((-0.28867513459481287) * v213) + (0.28867513459481287 * v219);
        const double v230 = ((c90 * v227) * v35) - v191;
        const double v236 = (((((0.5 * v213) + (0.5 * v219)) * v59) - v161) + v183) + ((((v14 * (1.5 * v230)) + v195) * v59) - v199);
        const double v241 = c240 * v59;
        const double v243 = (v63 * v241) * v59;
        const double v246 = (v24 * v243) + (v30 * v241);
        const double v247 = v24 * v10;
        const double v251 = (v32 * (v247 * v136)) + (v33 * v247);
        const double v252 = v134 * v251;
        const double v253 = v247 * v59;
        const double v254 = v252 - v253;
        const double v256 = c40 * v254;
        const double v257 = (c1 * v254) + v256;
        const double v259 = v150 * v251;
        const double v260 = v259 - v253;
        const double v262 = c40 * v260;
        const double v263 = (c1 * v260) + v262;
        const double v267 = v160 * v247;
        const double v269 = v30 * v10;
        const double v271 = v269 * v59;
        const double v273 = v271 + (v168 * v247);
        const double v275 = c73 * v273;
        const double v276 = (c69 * v273) + v275;
        const double v279 = (v276 * v59) + (v175 * v247);
        const double v284 = (((v85 * v269) + (v63 * v279)) * v59) + (v181 * v247);
        const double v288 = ((-0.28867513459481287) * v257) + (0.28867513459481287 * v263);
        const double v291 = v190 * v251;
        const double v292 = ((c90 * v288) * v35) + v291;
        const double v296 = v198 * v247;
        const double v298 = (((((0.5 * v257) + (0.5 * v263)) * v59) + v267) - v284) + (((v14 * (1.5 * v292)) * v59) + v296);
        const double v300 = v30 * v279;
        const double v302 = v253 - v252;
        const double v304 = c40 * v302;
        const double v305 = (c1 * v302) + v304;
        const double v307 = v253 - v259;
        const double v309 = c40 * v307;
        const double v310 = (c1 * v307) + v309;
        const double v318 = ((-0.28867513459481287) * v305) + (0.28867513459481287 * v310);
        const double v321 = ((c90 * v318) * v35) - v291;
        const double v326 = (((((0.5 * v305) + (0.5 * v310)) * v59) - v267) + v284) + (((v14 * (1.5 * v321)) * v59) - v296);
        const double v332 = (v32 * (v269 * v136)) + (v33 * v269);
        const double v333 = v134 * v332;
        const double v334 = v333 - v271;
        const double v336 = c40 * v334;
        const double v337 = (c1 * v334) + v336;
        const double v339 = v150 * v332;
        const double v340 = v339 - v271;
        const double v342 = c40 * v340;
        const double v343 = (c1 * v340) + v342;
        const double v347 = v160 * v269;
        const double v349 = v168 * v269;
        const double v350 = v349 - v253;
        const double v352 = c73 * v350;
        const double v353 = (c69 * v350) + v352;
        const double v355 = v175 * v269;
        const double v356 = (v353 * v59) + v355;
        const double v358 = v85 * v247;
        const double v361 = v181 * v269;
        const double v363 = ((((0.5 * v337) + (0.5 * v343)) * v59) + v347) - ((((v63 * v356) - v358) * v59) + v361);
        const double v366 = ((-0.28867513459481287) * v337) + (0.28867513459481287 * v343);
        const double v369 = v190 * v332;
        const double v370 = ((c90 * v366) * v35) + v369;
        const double v374 = v198 * v269;
        const double v376 = v363 + (((v14 * (1.5 * v370)) * v59) + v374);
        const double v380 = v271 - v333;
        const double v382 = c40 * v380;
        const double v383 = (c1 * v380) + v382;
        const double v385 = v271 - v339;
        const double v387 = c40 * v385;
        const double v388 = (c1 * v385) + v387;
        const double v393 = v253 - v349;
        const double v395 = c73 * v393;
        const double v396 = (c69 * v393) + v395;
        const double v398 = (v396 * v59) - v355;
        const double v403 = ((((0.5 * v383) + (0.5 * v388)) * v59) - v347) - (((v358 + (v63 * v398)) * v59) - v361);
        const double v406 = ((-0.28867513459481287) * v383) + (0.28867513459481287 * v388);
        const double v409 = ((c90 * v406) * v35) - v369;
        const double v414 = v403 + (((v14 * (1.5 * v409)) * v59) - v374);
        const double v426 = v101 * v125;
        const double v430 = (v24 * v177) + (v85 * v127);
        const double v437 = (v30 * v243) - (v24 * v241);
        const double v439 = v24 * v279;
        const double v449 = g[7 * i + 1] * c11;
        const double v461 = v101 * v165;
        const double v477 = -(0.5 * (v449 * (c240 + (v63 * v243))));
        const double v478 = v101 * v269;
        const double v491 = v101 * v247;
        const double v542 = -(c508 * (c539 * v172));
        const double v547 = c508 * (c539 * v275);
        const double v548 = -v547;
        const double v550 = c508 * (c539 * v352);
        const double v552 = c508 * (c539 * v395);
        w3[i] = (v101 * v24) - (v85 * v30);
        w7[i] = -(v24 * v113);
        w8[i] = -(v24 * v122);
        w9[i] = ((v24 * v201) - v203) - v207;
        w10[i] = ((v24 * v236) - v203) - v207;
        w11[i] = v246;
        w12[i] = v246;
        w13[i] = (v24 * v298) - v300;
        w14[i] = (v24 * v326) + v300;
        w15[i] = (v24 * v376) - (v30 * v356);
        w16[i] = (v24 * v414) - (v30 * v398);
        w4[i] = (v101 * v30) + (v85 * v24);
        w17[i] = -(v30 * v113);
        w18[i] = -(v30 * v122);
        w19[i] = ((v30 * v201) + v426) - v430;
        w20[i] = ((v30 * v236) + v426) - v430;
        w21[i] = v437;
        w22[i] = v437;
        w23[i] = (v30 * v298) + v439;
        w24[i] = (v30 * v326) - v439;
        w25[i] = (v30 * v376) + (v24 * v356);
        w26[i] = (v30 * v414) + (v24 * v398);
        w5[i] = (v449 * (v84 - (v63 * v101))) * 0.5;
        w27[i] = 0.5 * (v449 * (v63 * v113));
        w28[i] = 0.5 * (v449 * (v63 * v122));
        w29[i] = -(0.5 * (v449 * (v173 + ((v63 * v201) - v461))));
        w30[i] = -(0.5 * (v449 * (v173 + ((v63 * v236) - v461))));
        w31[i] = v477;
        w32[i] = v477;
        w33[i] = 0.5 * (v449 * (v276 - (v478 + (v63 * v298))));
        w34[i] = -(0.5 * (v449 * (v276 + ((v63 * v326) - v478))));
        w35[i] = 0.5 * (v449 * (v353 - ((v63 * v376) - v491)));
        w36[i] = 0.5 * (v449 * (v396 - (v491 + (v63 * v414))));
        w6[i] = -v97;
        w37[i] = v109;
        w38[i] = v118;
        w39[i] = -v192;
        w40[i] = -v230;
        w41[i] = -v292;
        w42[i] = -v321;
        w43[i] = -v370;
        w44[i] = -v409;
        e[81 * i + 56] = c512;
        e[81 * i + 55] = c508 * (v145 * c513);
        e[81 * i + 59] = c508 * (v212 * c513);
        e[81 * i + 53] = c508 * (v256 * c513);
        e[81 * i + 57] = c508 * (v304 * c513);
        e[81 * i + 54] = c508 * (v336 * c513);
        e[81 * i + 58] = c508 * (v382 * c513);
        e[81 * i + 63] = c512;
        e[81 * i + 62] = c508 * (v155 * c513);
        e[81 * i + 66] = c508 * (v218 * c513);
        e[81 * i + 60] = c508 * (v262 * c513);
        e[81 * i + 64] = c508 * (v309 * c513);
        e[81 * i + 61] = c508 * (v342 * c513);
        e[81 * i + 65] = c508 * (v387 * c513);
        e[81 * i + 69] = v542;
        e[81 * i + 73] = v542;
        e[81 * i + 70] = c545;
        e[81 * i + 67] = v547;
        e[81 * i + 71] = v548;
        e[81 * i + 68] = v550;
        e[81 * i + 72] = v552;
        e[81 * i + 76] = v542;
        e[81 * i + 80] = v542;
        e[81 * i + 77] = c545;
        e[81 * i + 74] = v547;
        e[81 * i + 78] = v548;
        e[81 * i + 75] = v550;
        e[81 * i + 79] = v552;
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c61 = 0.08333333333333333 * c4;
    const double c63 = squared(p[1]);
    const double c64 = c61 * c63;
    const double c65 = c64 * c2;
    const double c66 = c1 / c65;
    const double c70 = squared(c2);
    const double c71 = c4 * c70;
    const double c72 = c64 / c71;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v73 = (c66 * g[7 * i + 5]) * c72;
        const double v106 = ((v73 * w39[i]) - (v73 * w40[i - 1])) + (v73 * w30[i - 1]);
        const double v135 = ((v73 * w41[i]) - (v73 * w42[i - 1])) + (v73 * w34[i - 1]);
        const double v156 = ((v73 * w43[i]) - (v73 * w44[i - 1])) + (v73 * w36[i - 1]);
        e[81 * i + 5] = -(v9 * w7[i - 1]);
        e[81 * i + 12] = v9 * w7[i];
        e[81 * i + 6] = -(v9 * w8[i - 1]);
        e[81 * i + 13] = v9 * w8[i];
        e[81 * i + 4] = -(v9 * w9[i - 1]);
        e[81 * i + 11] = (v9 * w9[i]) - (v9 * w10[i - 1]);
        e[81 * i + 18] = v9 * w10[i];
        e[81 * i + 7] = -(v9 * w11[i - 1]);
        e[81 * i + 14] = v9 * w11[i];
        e[81 * i + 8] = -(v9 * w12[i - 1]);
        e[81 * i + 15] = v9 * w12[i];
        e[81 * i + 2] = -(v9 * w13[i - 1]);
        e[81 * i + 9] = (v9 * w13[i]) - (v9 * w14[i - 1]);
        e[81 * i + 16] = v9 * w14[i];
        e[81 * i + 3] = -(v9 * w15[i - 1]);
        e[81 * i + 10] = (v9 * w15[i]) - (v9 * w16[i - 1]);
        e[81 * i + 17] = v9 * w16[i];
        e[81 * i + 39] = (v73 * w27[i - 1]) - (v73 * w37[i - 1]);
        e[81 * i + 46] = (v73 * w37[i]) + (v73 * w27[i]);
        e[81 * i + 40] = (v73 * w28[i - 1]) - (v73 * w38[i - 1]);
        e[81 * i + 47] = (v73 * w38[i]) + (v73 * w28[i]);
        e[81 * i + 38] = (v73 * w29[i - 1]) - (v73 * w39[i - 1]);
        e[81 * i + 45] = v106 + (v73 * w29[i]);
        e[81 * i + 52] = (v73 * w40[i]) + (v73 * w30[i]);
        e[81 * i + 41] = v73 * w31[i - 1];
        e[81 * i + 48] = v73 * w31[i];
        e[81 * i + 42] = v73 * w32[i - 1];
        e[81 * i + 49] = v73 * w32[i];
        e[81 * i + 36] = (v73 * w33[i - 1]) - (v73 * w41[i - 1]);
        e[81 * i + 43] = v135 + (v73 * w33[i]);
        e[81 * i + 50] = (v73 * w42[i]) + (v73 * w34[i]);
        e[81 * i + 37] = (v73 * w35[i - 1]) - (v73 * w43[i - 1]);
        e[81 * i + 44] = v156 + (v73 * w35[i]);
        e[81 * i + 51] = (v73 * w44[i]) + (v73 * w36[i]);
    }
}

static void jacobian_8(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[81 * i + 22] = -(v9 * w17[i - 1]);
        e[81 * i + 29] = v9 * w17[i];
        e[81 * i + 23] = -(v9 * w18[i - 1]);
        e[81 * i + 30] = v9 * w18[i];
        e[81 * i + 21] = -(v9 * w19[i - 1]);
        e[81 * i + 28] = (v9 * w19[i]) - (v9 * w20[i - 1]);
        e[81 * i + 35] = v9 * w20[i];
        e[81 * i + 24] = -(v9 * w21[i - 1]);
        e[81 * i + 31] = v9 * w21[i];
        e[81 * i + 25] = -(v9 * w22[i - 1]);
        e[81 * i + 32] = v9 * w22[i];
        e[81 * i + 19] = -(v9 * w23[i - 1]);
        e[81 * i + 26] = (v9 * w23[i]) - (v9 * w24[i - 1]);
        e[81 * i + 33] = v9 * w24[i];
        e[81 * i + 20] = -(v9 * w25[i - 1]);
        e[81 * i + 27] = (v9 * w25[i]) - (v9 * w26[i - 1]);
        e[81 * i + 34] = v9 * w26[i];
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[81 * i + 29] = v9 * w17[i];
    e[81 * i + 30] = v9 * w18[i];
    e[81 * i + 28] = v9 * w19[i];
    e[81 * i + 35] = v9 * w20[i];
    e[81 * i + 31] = v9 * w21[i];
    e[81 * i + 32] = v9 * w22[i];
    e[81 * i + 26] = v9 * w23[i];
    e[81 * i + 33] = v9 * w24[i];
    e[81 * i + 27] = v9 * w25[i];
    e[81 * i + 34] = v9 * w26[i];
    (void)n;
}

static void work_0(int n, const double *p, const double *g, const double *y, double *w, double *q)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c2 = p[8];
    const double c6 = (-0.5) * p[1];
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c45 = 0.8333333333333334 * c2;
    const double c47 = 2.0 * p[7];
    const double c48 = 2.0 + c47;
    const double c49 = c45 / c48;
    const double c61 = 1e-12 * c2;
    const double c62 = squared(c61);
    const double c65 = 1.0 / p[6];
    const double c87 = p[9];
    const double c89 = c11 / c87;
    const double c90 = squared(c89);
    const double c91 = p[2] * c90;
    const double c92 = c87 / c91;
    for (int i = 0; i < n - 1; i++) {
        const double v7 = w1[i + 1];
        const double v8 = w1[i];
        const double v10 = g[7 * i + 4];
        const double v15 = c6 * ((v7 - v8) * (v10 * c12));
        const double v20 = (w0[i + 1] - w0[i]) * v10;
        const double v23 = (v8 + v7) * 0.5;
        const double v24 = cos(v23);
        const double v29 = (w2[i + 1] - w2[i]) * v10;
        const double v30 = sin(v23);
        const double v32 = (v20 * v24) + (v29 * v30);
        const double v35 = 1.0 / (sqrt(v32) * v32);
        const double v39 = log(v32);
        const double v40 = ((((-0.5773502691896257) * v15) * v35) - y[9 * i + 5]) + v39;
        const double v53 = ((v29 * v24) - (v20 * v30)) / v32;
        const double v59 = squared((c2 * v40)) + (3.0 * squared((c49 * (v53 - y[9 * i + 7]))));
        const double v74 = c2 * ((((0.5773502691896257 * v15) * v35) - y[9 * i + 6]) + v39);
        const double v81 = squared(v74) + (3.0 * squared((c49 * (v53 - y[9 * i + 8]))));
        const double v85 = (0.5 * (larger(v59, c62) * c65)) + (0.5 * (larger(v81, c62) * c65));
        q[0] += (g[7 * i + 1] * v85) * c92;
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
    const double c0 = p[8];
    const double c4 = (-0.5) * p[1];
    const double c10 = p[0];
    const double c11 = 1.0 / c10;
    const double c44 = 1e-12 * c0;
    const double c45 = squared(c44);
    const double c49 = 0.8333333333333334 * c0;
    const double c51 = 2.0 * p[7];
    const double c52 = 2.0 + c51;
    const double c53 = c49 / c52;
    const double c69 = p[9];
    const double c71 = c10 / c69;
    const double c72 = squared(c71);
    const double c73 = p[2] * c72;
    const double c74 = c69 / c73;
    const double c78 = 1.0 / p[6];
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
        const double v36 = ((-0.5773502691896257) * v14) * v35;
        const double v39 = log(v32);
        const double v41 = c0 * ((v36 - y[9 * i + 5]) + v39);
        const double v57 = 1.0 / v32;
        const double v58 = ((v29 * v24) - (v19 * v30)) * v57;
        const double v61 = c53 * (v58 - y[9 * i + 7]);
        const double v64 = squared(v41) + (3.0 * squared(v61));
        const double v65 = (double)(c45 <= v64);
        const double v79 = (0.5 * (g[7 * i + 1] * c74)) * c78;
        const double v80 = (v65 / (v65 + (double)(v64 <= c45))) * v79;
        const double v82 = c0 * ((2.0 * v41) * v80);
        const double v86 = (0.5773502691896257 * v14) * v35;
        const double v90 = c0 * ((v86 - y[9 * i + 6]) + v39);
        const double v95 = c53 * (v58 - y[9 * i + 8]);
        const double v98 = squared(v90) + (3.0 * squared(v95));
        const double v99 = (double)(c45 <= v98);
        const double v103 = (v99 / (v99 + (double)(v98 <= c45))) * v79;
        const double v105 = c0 * ((2.0 * v90) * v103);
        const double v108 = v58 * v57;
        const double v112 = c53 * ((2.0 * v95) * (3.0 * v103));
        const double v116 = (v86 * v35) * v105;
        const double v121 = 1.0 / (2.0 * v33);
        const double v123 = (((v105 * v57) - (v108 * v112)) - (v33 * v116)) - ((v32 * v116) * v121);
        const double v127 = c53 * ((2.0 * v61) * (3.0 * v80));
        const double v133 = (v36 * v35) * v82;
        const double v138 = (((v123 - (v108 * v127)) + (v82 * v57)) - (v33 * v133)) - ((v32 * v133) * v121);
        const double v142 = (v112 * v57) + (v127 * v57);
        const double v150 = (v24 * ((v29 * v138) - (v19 * v142))) - (v30 * ((v29 * v142) + (v19 * v138)));
        const double v151 = 0.5 * v150;
        const double v158 = (c4 * (0.5773502691896257 * (v105 * v35))) + (c4 * ((-0.5773502691896257) * (v82 * v35)));
        const double v159 = v12 * v158;
        const double v167 = ((v24 * v138) - (v30 * v142)) * v9;
        const double v172 = ((v24 * v142) + (v30 * v138)) * v9;
        s[9 * i + 5] += -v82;
        s[9 * i + 6] += -v105;
        s[9 * i + 4] += v151 - v159;
        s[9 * i + 13] += v151 + v159;
        s[9 * i + 7] += -v127;
        s[9 * i + 8] += -v112;
        s[9 * i] += -v167;
        s[9 * i + 9] += v167;
        s[9 * i + 1] += -v172;
        s[9 * i + 10] += v172;
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
        s[9 * n + 9 * i + 1] += g[7 * i + 3] * c27;
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 9; k++) f[k] = 0.0;
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
    for (int k = 0; k < n * 81; k++) e[k] = 0.0;
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
    for (int k = 0; k < n * 27; k++) s[k] = 0.0;
    work_slope_0(n, p, g, y, w, s);
    work_slope_1(n, t, p, g, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {2, 3, -1, -1, -1, -1, -1, -1, -1};
static const int differential[] = {1, 1, 1, 1, 0, 1, 1, 1, 1};
static const int held_first[] = {1, 0, 1, 0, 1, 0, 0, 0, 0};
static const int held_last[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8};
static const int offset[] = {0, 0, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 5, 6, 7, 8, 0, 1, 4, 0, 1, 4, 5, 0, 1, 4, 0, 1, 4, 6, 0, 1, 4, 0, 1, 4, 7, 0, 1, 4, 0, 1, 4, 8, 0, 1, 4};

const softcat_model softcat_filament_model = {
    9, 4, 10, 7, 45, 81, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "ramp", "youngs_modulus", "viscosity",
    "poisson", "second_modulus", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "s", "Pa", "Pa*s", "1", "Pa", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_POSITIVE,
    SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.3, 0.002, 950.0, 9.81, 1.0, 300000.0, 300000.0, 0.45, 600000.0, 0.17487435419566724};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0_mode2", "axial_1_mode2", "shear_0_mode2",
    "shear_1_mode2"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, (-0.5773502691896257), 0.5773502691896257, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Rubber strand: catches, then creeps to its long-time sag",
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
    .area_power = 1,
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
    .duration = 4.0,
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
