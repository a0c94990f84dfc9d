/*
 * Curled silicone rod held by one end
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-stress, shear, rotary-inertia
 * Digest of the structure: 37eb8719c808f2f67b6b3dc9934f96271327a470142c8459d6fbeafa452a6561
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n; i++) {
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
    for (int i = 1; i < n; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 1];
        w2[i] = y[6 * i + 4];
        w3[i] = y[6 * i + 2];
        w4[i] = y[6 * i + 3];
        w5[i] = y[6 * i + 5];
    }
}

static void rates_2(int n, double *w)
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

static void rates_3(int n, const double *p, const double *g, double *w)
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
    const double c4 = 0.5 * p[7];
    const double c5 = p[1];
    const double c6 = c4 * c5;
    const double c7 = (-0.4999999999999998) * c6;
    const double c9 = (-0.5) * c5;
    const double c15 = p[0];
    const double c16 = 1.0 / c15;
    const double c45 = p[5];
    const double c48 = 1.0 / p[8];
    const double c79 = (-0.4999999999999998) * c5;
    const double c95 = 0.5000000000000001 * c6;
    const double c101 = 0.5000000000000001 * c5;
    const double c113 = 0.9 * c1;
    const double c115 = 2.0 * p[6];
    const double c116 = 2.0 + c115;
    const double c117 = c113 / c116;
    const double c121 = 0.3 * c45;
    const double c141 = 0.5 * c5;
    for (int i = 0; i < n - 1; i++) {
        const double v10 = w2[i + 1];
        const double v11 = w2[i];
        const double v14 = g[7 * i + 4];
        const double v17 = v14 * c16;
        const double v18 = (v10 - v11) * v17;
        const double v19 = c9 * v18;
        const double v24 = (w0[i + 1] - w0[i]) * v14;
        const double v27 = (v11 + v10) * 0.5;
        const double v28 = cos(v27);
        const double v33 = (w1[i + 1] - w1[i]) * v14;
        const double v34 = sin(v27);
        const double v36 = (v24 * v28) + (v33 * v34);
        const double v37 = sqrt(v36);
        const double v39 = 1.0 / (v37 * v36);
        const double v42 = log(v36);
        const double v49 = w5[i] * c48;
        const double v51 = w5[i + 1] * c48;
        const double v53 = (v49 + v51) * 0.5;
        const double v56 = (v33 * v28) - (v24 * v34);
        const double v63 = ((w3[i + 1] * c48) - (w3[i] * c48)) * v14;
        const double v71 = ((w4[i + 1] * c48) - (w4[i] * c48)) * v14;
        const double v73 = ((v53 * v56) + (v63 * v28)) + (v71 * v34);
        const double v76 = squared(v36);
        const double v78 = (0.75 * v18) / (v37 * v76);
        const double v81 = 1.0 / v36;
        const double v87 = ((-0.5) * ((v51 - v49) * v17)) * v39;
        const double v91 = (c1 * ((c7 + (((-0.4999999999999998) * v19) * v39)) + v42)) + (c45 * ((v73 * ((v78 * c79) + v81)) + (v87 * c79)));
        const double v108 = (c1 * ((c95 + ((0.5000000000000001 * v19) * v39)) + v42)) + (c45 * ((v73 * ((v78 * c101) + v81)) + (v87 * c101)));
        const double v130 = ((((v71 * v28) - (v53 * v36)) - (v63 * v34)) * v81) - ((v56 * v73) / v76);
        const double v132 = (c117 * (v56 * v81)) + (c121 * v130);
        const double v135 = (0.5 * v132) + (0.4999999999999999 * v132);
        const double v136 = v135 * v81;
        const double v139 = (((0.5 * v91) + (0.4999999999999999 * v108)) * v81) - ((v56 * v136) * v81);
        const double v148 = (c141 * (((-0.2499999999999999) * v91) + (0.25 * v108))) * v39;
        const double v152 = v139 + (((1.5 * v148) * v18) * v81);
        w6[i] = (v152 * v28) - (v136 * v34);
        w7[i] = (v152 * v34) + (v136 * v28);
        w8[i] = ((g[7 * i + 1] * c15) * (v135 - (v56 * v152))) * 0.5;
        w9[i] = -v148;
    }
}

static void rates_4(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
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
    for (int i = 1; i < n - 1; i++) {
        const double v12 = c9 * g[7 * i + 6];
        const double v38 = (((w9[i] - w9[i - 1]) + w8[i]) + w8[i - 1]) * (c34 * g[7 * i + 5]);
        f[6 * i + 2] = (w6[i] - w6[i - 1]) * v12;
        f[6 * i + 3] = ((w7[i] - w7[i - 1]) * v12) - c19;
        f[6 * i + 5] = v38;
    }
}

static void rates_5(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    const double c2 = squared(p[8]);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c5 = p[2];
    const double c6 = c5 * c3;
    const double c7 = c4 / c6;
    const double c16 = p[3] * c4;
    const double c23 = 0.0625 * c5;
    const double c25 = squared(p[1]);
    const double c26 = c23 * c25;
    const double c27 = c26 * c3;
    const double c28 = c2 / c27;
    const int i = n - 1;
    const double v10 = c7 * g[7 * i + 6];
    f[6 * i + 2] = -(w6[i - 1] * v10);
    f[6 * i + 3] = -((w7[i - 1] * v10) + c16);
    f[6 * i + 5] = (w8[i - 1] - w9[i - 1]) * (c28 * g[7 * i + 5]);
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n; i++) {
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
    for (int i = 1; i < n; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 1];
        w2[i] = y[6 * i + 4];
        w3[i] = y[6 * i + 2];
        w4[i] = y[6 * i + 3];
        w5[i] = y[6 * i + 5];
    }
}

static void jacobian_2(int n, double *w)
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

static void jacobian_3(int n, const double *p, const double *g, double *w)
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
    const double c4 = 0.5 * p[7];
    const double c5 = p[1];
    const double c6 = c4 * c5;
    const double c7 = (-0.4999999999999998) * c6;
    const double c9 = (-0.5) * c5;
    const double c15 = p[0];
    const double c16 = 1.0 / c15;
    const double c45 = p[5];
    const double c48 = 1.0 / p[8];
    const double c80 = (-0.4999999999999998) * c5;
    const double c96 = 0.5000000000000001 * c6;
    const double c102 = 0.5000000000000001 * c5;
    const double c114 = 0.9 * c1;
    const double c116 = 2.0 * p[6];
    const double c117 = 2.0 + c116;
    const double c118 = c114 / c117;
    const double c122 = 0.3 * c45;
    const double c143 = 0.5 * c5;
    for (int i = 0; i < n - 1; i++) {
        const double v10 = w2[i + 1];
        const double v11 = w2[i];
        const double v14 = g[7 * i + 4];
        const double v17 = v14 * c16;
        const double v18 = (v10 - v11) * v17;
        const double v19 = c9 * v18;
        const double v24 = (w0[i + 1] - w0[i]) * v14;
        const double v27 = (v11 + v10) * 0.5;
        const double v28 = cos(v27);
        const double v33 = (w1[i + 1] - w1[i]) * v14;
        const double v34 = sin(v27);
        const double v36 = (v24 * v28) + (v33 * v34);
        const double v37 = sqrt(v36);
        const double v39 = 1.0 / (v37 * v36);
        const double v40 = ((-0.4999999999999998) * v19) * v39;
        const double v42 = log(v36);
        const double v49 = w5[i] * c48;
        const double v51 = w5[i + 1] * c48;
        const double v53 = (v49 + v51) * 0.5;
        const double v56 = (v33 * v28) - (v24 * v34);
        const double v63 = ((w3[i + 1] * c48) - (w3[i] * c48)) * v14;
        const double v71 = ((w4[i + 1] * c48) - (w4[i] * c48)) * v14;
        const double v73 = ((v53 * v56) + (v63 * v28)) + (v71 * v34);
        const double v76 = squared(v36);
        const double v78 = 1.0 / (v37 * v76);
        const double v79 = (0.75 * v18) * v78;
        const double v82 = 1.0 / v36;
        const double v83 = (v79 * c80) + v82;
        const double v88 = ((-0.5) * ((v51 - v49) * v17)) * v39;
        const double v92 = (c1 * ((c7 + v40) + v42)) + (c45 * ((v73 * v83) + (v88 * c80)));
        const double v98 = (0.5000000000000001 * v19) * v39;
        const double v104 = (v79 * c102) + v82;
        const double v109 = (c1 * ((c96 + v98) + v42)) + (c45 * ((v73 * v104) + (v88 * c102)));
        const double v112 = ((0.5 * v92) + (0.4999999999999999 * v109)) * v82;
        const double v119 = v56 * v82;
        const double v128 = (((v71 * v28) - (v53 * v36)) - (v63 * v34)) * v82;
        const double v130 = 1.0 / v76;
        const double v131 = (v56 * v73) * v130;
        const double v134 = (c118 * v119) + (c122 * (v128 - v131));
        const double v137 = (0.5 * v134) + (0.4999999999999999 * v134);
        const double v138 = v137 * v82;
        const double v140 = (v56 * v138) * v82;
        const double v150 = (c143 * (((-0.2499999999999999) * v92) + (0.25 * v109))) * v39;
        const double v151 = 1.5 * v150;
        const double v153 = (v151 * v18) * v82;
        const double v154 = (v112 - v140) + v153;
        const double v158 = v28 * v82;
        const double v160 = v34 + (v56 * v158);
        const double v161 = v160 * v82;
        const double v162 = 0.4999999999999999 * v161;
        const double v163 = c122 * v162;
        const double v165 = 0.5 * v161;
        const double v166 = c122 * v165;
        const double v168 = (v163 * v82) + (v166 * v82);
        const double v170 = v163 * v130;
        const double v172 = v166 * v130;
        const double v176 = 1.5 * (v18 * v158);
        const double v178 = c143 * (v176 * v39);
        const double v181 = (0.25 * v178) + (0.4999999999999999 * v158);
        const double v182 = c45 * v181;
        const double v187 = ((-0.2499999999999999) * v178) + (0.5 * v158);
        const double v188 = c45 * v187;
        const double v190 = (((v56 * v170) + (v56 * v172)) + (v104 * v182)) + (v83 * v188);
        const double v193 = 0.5 * ((v36 * v168) + (v56 * v190));
        const double v194 = c102 * v182;
        const double v197 = c80 * v188;
        const double v201 = v17 * (((-0.5) * (v194 * v39)) + ((-0.5) * (v197 * v39)));
        const double v207 = v53 * v168;
        const double v212 = v53 * v190;
        const double v214 = (((v63 * v168) + (v33 * v207)) + (v71 * v190)) - (v24 * v212);
        const double v226 = (((v24 * v207) - (v71 * v168)) + (v63 * v190)) + (v33 * v212);
        const double v228 = ((v28 * v214) - ((v28 * v138) + (v34 * v154))) - (v34 * v226);
        const double v229 = v140 * v82;
        const double v231 = v153 * v82;
        const double v233 = v150 * v39;
        const double v234 = v233 * v176;
        const double v239 = 1.0 / (2.0 * v37);
        const double v242 = (v229 * v28) - (((v231 * v28) + (v37 * v234)) + ((v36 * v234) * v239));
        const double v243 = v138 * v82;
        const double v246 = 2.0 * v36;
        const double v247 = v131 * v130;
        const double v251 = v128 * v82;
        const double v253 = ((v242 + (v243 * v160)) - (v246 * (v247 * v163))) + (v251 * v163);
        const double v254 = v119 * v82;
        const double v255 = c118 * v162;
        const double v262 = ((v253 + (v254 * v255)) - (v246 * (v247 * v166))) + (v251 * v166);
        const double v263 = c118 * v165;
        const double v266 = v112 * v82;
        const double v269 = v88 * v39;
        const double v270 = v269 * v194;
        const double v275 = (((v262 + (v254 * v263)) - (v266 * v28)) - (v37 * v270)) - ((v36 * v270) * v239);
        const double v276 = v82 * v82;
        const double v277 = v73 * v182;
        const double v280 = v79 * v78;
        const double v281 = c102 * v277;
        const double v282 = v280 * v281;
        const double v288 = ((v275 - (v276 * v277)) - (v246 * (v37 * v282))) - ((v76 * v282) * v239);
        const double v289 = c1 * v181;
        const double v292 = v98 * v39;
        const double v293 = v292 * v289;
        const double v298 = ((v288 + (v289 * v82)) - (v37 * v293)) - ((v36 * v293) * v239);
        const double v299 = v269 * v197;
        const double v305 = v73 * v188;
        const double v307 = ((v298 - (v37 * v299)) - ((v36 * v299) * v239)) - (v276 * v305);
        const double v308 = c80 * v305;
        const double v309 = v280 * v308;
        const double v316 = c1 * v187;
        const double v318 = ((v307 - (v246 * (v37 * v309))) - ((v76 * v309) * v239)) + (v316 * v82);
        const double v319 = v40 * v39;
        const double v320 = v319 * v316;
        const double v325 = (v318 - (v37 * v320)) - ((v36 * v320) * v239);
        const double v333 = (((v73 * v170) - (v138 * v158)) - (v255 * v82)) + (v73 * v172);
        const double v335 = v333 - (v263 * v82);
        const double v344 = (v228 + (v28 * ((v33 * v325) - (v24 * v335)))) - (v34 * ((v33 * v335) + (v24 * v325)));
        const double v345 = 0.5 * v344;
        const double v353 = ((v151 * v158) + (0.75 * (v281 * v78))) + (c9 * (0.5000000000000001 * (v289 * v39)));
        const double v360 = (v353 + (0.75 * (v308 * v78))) + (c9 * ((-0.4999999999999998) * (v316 * v39)));
        const double v361 = v17 * v360;
        const double v368 = (((v34 * v168) + (v28 * v190)) * v14) * c48;
        const double v374 = (((v34 * v190) - (v28 * v168)) * v14) * c48;
        const double v382 = (((v28 * v207) - (v34 * v335)) - (v34 * v212)) + (v28 * v325);
        const double v383 = v382 * v14;
        const double v391 = (((v34 * v207) + (v28 * v335)) + (v28 * v212)) + (v34 * v325);
        const double v392 = v391 * v14;
        const double v397 = v34 * v82;
        const double v399 = 1.5 * (v18 * v397);
        const double v401 = c143 * (v399 * v39);
        const double v404 = (0.25 * v401) + (0.4999999999999999 * v397);
        const double v405 = c45 * v404;
        const double v408 = v28 - (v56 * v397);
        const double v409 = v408 * v82;
        const double v410 = 0.4999999999999999 * v409;
        const double v411 = c122 * v410;
        const double v412 = v411 * v130;
        const double v414 = 0.5 * v409;
        const double v415 = c122 * v414;
        const double v416 = v415 * v130;
        const double v422 = ((-0.2499999999999999) * v401) + (0.5 * v397);
        const double v423 = c45 * v422;
        const double v425 = ((v104 * v405) - ((v56 * v412) + (v56 * v416))) + (v83 * v423);
        const double v429 = (v411 * v82) + (v415 * v82);
        const double v432 = 0.5 * ((v56 * v425) - (v36 * v429));
        const double v433 = c102 * v405;
        const double v436 = c80 * v423;
        const double v440 = v17 * (((-0.5) * (v433 * v39)) + ((-0.5) * (v436 * v39)));
        const double v450 = v53 * v429;
        const double v454 = v53 * v425;
        const double v456 = ((v71 * v425) - ((v63 * v429) + (v33 * v450))) - (v24 * v454);
        const double v465 = (((v71 * v429) - (v24 * v450)) + (v63 * v425)) + (v33 * v454);
        const double v467 = (((v28 * v154) - (v34 * v138)) + (v28 * v456)) - (v34 * v465);
        const double v470 = v233 * v399;
        const double v476 = (v229 * v34) - (((v231 * v34) + (v37 * v470)) + ((v36 * v470) * v239));
        const double v483 = ((v476 - (v243 * v408)) + (v246 * (v247 * v411))) - (v251 * v411);
        const double v484 = c118 * v410;
        const double v491 = ((v483 - (v254 * v484)) + (v246 * (v247 * v415))) - (v251 * v415);
        const double v492 = c118 * v414;
        const double v497 = v269 * v433;
        const double v502 = (((v491 - (v254 * v492)) - (v266 * v34)) - (v37 * v497)) - ((v36 * v497) * v239);
        const double v503 = v73 * v405;
        const double v506 = c102 * v503;
        const double v507 = v280 * v506;
        const double v513 = ((v502 - (v276 * v503)) - (v246 * (v37 * v507))) - ((v76 * v507) * v239);
        const double v514 = c1 * v404;
        const double v517 = v292 * v514;
        const double v522 = ((v513 + (v514 * v82)) - (v37 * v517)) - ((v36 * v517) * v239);
        const double v523 = v269 * v436;
        const double v529 = v73 * v423;
        const double v531 = ((v522 - (v37 * v523)) - ((v36 * v523) * v239)) - (v276 * v529);
        const double v532 = c80 * v529;
        const double v533 = v280 * v532;
        const double v540 = c1 * v422;
        const double v542 = ((v531 - (v246 * (v37 * v533))) - ((v76 * v533) * v239)) + (v540 * v82);
        const double v543 = v319 * v540;
        const double v548 = (v542 - (v37 * v543)) - ((v36 * v543) * v239);
        const double v556 = ((v484 * v82) - ((v138 * v397) + (v73 * v412))) - (v73 * v416);
        const double v558 = v556 + (v492 * v82);
        const double v567 = (v467 + (v28 * ((v33 * v548) - (v24 * v558)))) - (v34 * ((v33 * v558) + (v24 * v548)));
        const double v568 = 0.5 * v567;
        const double v576 = ((v151 * v397) + (0.75 * (v506 * v78))) + (c9 * (0.5000000000000001 * (v514 * v39)));
        const double v583 = (v576 + (0.75 * (v532 * v78))) + (c9 * ((-0.4999999999999998) * (v540 * v39)));
        const double v584 = v17 * v583;
        const double v591 = (((v28 * v425) - (v34 * v429)) * v14) * c48;
        const double v597 = (((v28 * v429) + (v34 * v425)) * v14) * c48;
        const double v605 = (v28 * v548) - (((v28 * v450) + (v34 * v558)) + (v34 * v454));
        const double v606 = v605 * v14;
        const double v614 = (((v28 * v558) - (v34 * v450)) + (v28 * v454)) + (v34 * v548);
        const double v615 = v614 * v14;
        const double v617 = g[7 * i + 1] * c15;
        const double v622 = 0.5 * v617;
        const double v623 = v56 * v622;
        const double v624 = v623 * v82;
        const double v626 = 1.5 * (v18 * v624);
        const double v628 = c143 * (v626 * v39);
        const double v631 = (0.25 * v628) + (0.4999999999999999 * v624);
        const double v632 = c45 * v631;
        const double v633 = c102 * v632;
        const double v638 = ((-0.2499999999999999) * v628) + (0.5 * v624);
        const double v639 = c45 * v638;
        const double v640 = c80 * v639;
        const double v644 = v17 * (((-0.5) * (v633 * v39)) + ((-0.5) * (v640 * v39)));
        const double v648 = v56 * v624;
        const double v650 = v622 + (v648 * v82);
        const double v651 = 0.4999999999999999 * v650;
        const double v652 = c122 * v651;
        const double v653 = v652 * v130;
        const double v656 = 0.5 * v650;
        const double v657 = c122 * v656;
        const double v658 = v657 * v130;
        const double v660 = (((v104 * v632) + (v83 * v639)) + (v56 * v653)) + (v56 * v658);
        const double v664 = (v652 * v82) + (v657 * v82);
        const double v667 = 0.5 * ((v56 * v660) + (v36 * v664));
        const double v674 = v73 * v632;
        const double v675 = c102 * v674;
        const double v679 = c1 * v631;
        const double v683 = ((v151 * v624) + (0.75 * (v675 * v78))) + (c9 * (0.5000000000000001 * (v679 * v39)));
        const double v684 = v73 * v639;
        const double v685 = c80 * v684;
        const double v689 = c1 * v638;
        const double v693 = (v683 + (0.75 * (v685 * v78))) + (c9 * ((-0.4999999999999998) * (v689 * v39)));
        const double v694 = v17 * v693;
        const double v695 = v53 * v660;
        const double v701 = v53 * v664;
        const double v703 = (((v24 * v695) - (v71 * v660)) - (v63 * v664)) - (v33 * v701);
        const double v711 = (v71 * v664) - (((v63 * v660) + (v33 * v695)) + (v24 * v701));
        const double v715 = v233 * v626;
        const double v722 = (((v231 * v623) + (v37 * v715)) + ((v36 * v715) * v239)) - (v229 * v623);
        const double v727 = v269 * v633;
        const double v732 = (((v722 - (v243 * v648)) + (v266 * v623)) + (v37 * v727)) + ((v36 * v727) * v239);
        const double v735 = v280 * v675;
        const double v741 = ((v732 + (v276 * v674)) + (v246 * (v37 * v735))) + ((v76 * v735) * v239);
        const double v744 = v292 * v679;
        const double v749 = ((v741 - (v679 * v82)) + (v37 * v744)) + ((v36 * v744) * v239);
        const double v750 = v269 * v640;
        const double v757 = ((v749 + (v37 * v750)) + ((v36 * v750) * v239)) + (v276 * v684);
        const double v758 = v280 * v685;
        const double v766 = ((v757 + (v246 * (v37 * v758))) + ((v76 * v758) * v239)) - (v689 * v82);
        const double v767 = v319 * v689;
        const double v775 = ((v766 + (v37 * v767)) + ((v36 * v767) * v239)) + (v246 * (v247 * v652));
        const double v778 = c118 * v651;
        const double v783 = ((v775 - (v251 * v652)) - (v254 * v778)) + (v246 * (v247 * v657));
        const double v786 = c118 * v656;
        const double v788 = (v783 - (v251 * v657)) - (v254 * v786);
        const double v796 = (((v138 * v624) - (v154 * v622)) - (v73 * v653)) + (v778 * v82);
        const double v800 = (v796 - (v73 * v658)) + (v786 * v82);
        const double v804 = ((v28 * v703) - (v34 * v711)) + (v28 * ((v33 * v788) - (v24 * v800)));
        const double v810 = 0.5 * (v804 - (v34 * ((v24 * v788) + (v33 * v800))));
        const double v817 = (((v28 * v660) + (v34 * v664)) * v14) * c48;
        const double v823 = (((v28 * v664) - (v34 * v660)) * v14) * c48;
        const double v831 = (((v34 * v695) - (v28 * v701)) + (v28 * v788)) - (v34 * v800);
        const double v832 = v831 * v14;
        const double v840 = ((v34 * v788) - ((v28 * v695) + (v34 * v701))) + (v28 * v800);
        const double v841 = v840 * v14;
        const double v844 = c143 * v39;
        const double v845 = 0.25 * v844;
        const double v846 = c45 * v845;
        const double v847 = c102 * v846;
        const double v850 = (-0.2499999999999999) * v844;
        const double v851 = c45 * v850;
        const double v852 = c80 * v851;
        const double v856 = v17 * (((-0.5) * (v847 * v39)) + ((-0.5) * (v852 * v39)));
        const double v859 = (v104 * v846) + (v83 * v851);
        const double v861 = 0.5 * (v56 * v859);
        const double v867 = v53 * v859;
        const double v876 = (v28 * ((v24 * v867) - (v71 * v859))) + (v34 * ((v63 * v859) + (v33 * v867)));
        const double v881 = v269 * v847;
        const double v886 = (((v37 * v233) + ((v36 * v233) * v239)) + (v37 * v881)) + ((v36 * v881) * v239);
        const double v887 = v73 * v846;
        const double v890 = c102 * v887;
        const double v891 = v280 * v890;
        const double v897 = ((v886 + (v276 * v887)) + (v246 * (v37 * v891))) + ((v76 * v891) * v239);
        const double v898 = c1 * v845;
        const double v901 = v292 * v898;
        const double v906 = ((v897 - (v898 * v82)) + (v37 * v901)) + ((v36 * v901) * v239);
        const double v907 = v269 * v852;
        const double v913 = v73 * v851;
        const double v915 = ((v906 + (v37 * v907)) + ((v36 * v907) * v239)) + (v276 * v913);
        const double v916 = c80 * v913;
        const double v917 = v280 * v916;
        const double v924 = c1 * v850;
        const double v926 = ((v915 + (v246 * (v37 * v917))) + ((v76 * v917) * v239)) - (v924 * v82);
        const double v927 = v319 * v924;
        const double v932 = (v926 + (v37 * v927)) + ((v36 * v927) * v239);
        const double v939 = 0.5 * ((v876 + (v28 * (v33 * v932))) - (v34 * (v24 * v932)));
        const double v945 = (0.75 * (v890 * v78)) + (c9 * (0.5000000000000001 * (v898 * v39)));
        const double v952 = (v945 + (0.75 * (v916 * v78))) + (c9 * ((-0.4999999999999998) * (v924 * v39)));
        const double v953 = v17 * v952;
        const double v958 = ((v28 * v859) * v14) * c48;
        const double v962 = ((v34 * v859) * v14) * c48;
        const double v967 = ((v34 * v867) + (v28 * v932)) * v14;
        const double v972 = ((v34 * v932) - (v28 * v867)) * v14;
        w6[i] = (v154 * v28) - (v138 * v34);
        w10[i] = (v193 - v201) * c48;
        w11[i] = (v201 + v193) * c48;
        w12[i] = v345 - v361;
        w13[i] = v345 + v361;
        w14[i] = -v368;
        w15[i] = v368;
        w16[i] = -v374;
        w17[i] = v374;
        w18[i] = -v383;
        w19[i] = v383;
        w20[i] = -v392;
        w21[i] = v392;
        w7[i] = (v154 * v34) + (v138 * v28);
        w22[i] = (v432 - v440) * c48;
        w23[i] = (v440 + v432) * c48;
        w24[i] = v568 - v584;
        w25[i] = v568 + v584;
        w26[i] = -v591;
        w27[i] = v591;
        w28[i] = -v597;
        w29[i] = v597;
        w30[i] = -v606;
        w31[i] = v606;
        w32[i] = -v615;
        w33[i] = v615;
        w8[i] = (v617 * (v137 - (v56 * v154))) * 0.5;
        w34[i] = (v644 - v667) * c48;
        w35[i] = -((v644 + v667) * c48);
        w36[i] = v694 + v810;
        w37[i] = v810 - v694;
        w38[i] = v817;
        w39[i] = -v817;
        w40[i] = -v823;
        w41[i] = v823;
        w42[i] = -v832;
        w43[i] = v832;
        w44[i] = -v841;
        w45[i] = v841;
        w9[i] = -v150;
        w46[i] = (v856 - v861) * c48;
        w47[i] = -((v856 + v861) * c48);
        w48[i] = v939 + v953;
        w49[i] = v939 - v953;
        w50[i] = v958;
        w51[i] = -v958;
        w52[i] = v962;
        w53[i] = -v962;
        w54[i] = -v967;
        w55[i] = v967;
        w56[i] = -v972;
        w57[i] = v972;
    }
}

static void jacobian_4(int n, const double *p, const double *g, double *w, double *e)
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
    const double c1 = squared(p[8]);
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
    const double c1 = squared(p[8]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c83 = 0.0625 * c4;
    const double c85 = squared(p[1]);
    const double c86 = c83 * c85;
    const double c87 = c86 * c2;
    const double c88 = c1 / c87;
    const int i = n - 1;
    const double v9 = c6 * g[7 * i + 6];
    const double v91 = c88 * g[7 * i + 5];
    e[57 * i + 7] = -(v9 * w10[i - 1]);
    e[57 * i + 13] = -(v9 * w11[i - 1]);
    e[57 * i + 6] = -(v9 * w12[i - 1]);
    e[57 * i + 12] = -(v9 * w13[i - 1]);
    e[57 * i + 4] = -(v9 * w14[i - 1]);
    e[57 * i + 10] = -(v9 * w15[i - 1]);
    e[57 * i + 5] = -(v9 * w16[i - 1]);
    e[57 * i + 11] = -(v9 * w17[i - 1]);
    e[57 * i + 2] = -(v9 * w18[i - 1]);
    e[57 * i + 8] = -(v9 * w19[i - 1]);
    e[57 * i + 3] = -(v9 * w20[i - 1]);
    e[57 * i + 9] = -(v9 * w21[i - 1]);
    e[57 * i + 25] = -(v9 * w22[i - 1]);
    e[57 * i + 31] = -(v9 * w23[i - 1]);
    e[57 * i + 24] = -(v9 * w24[i - 1]);
    e[57 * i + 30] = -(v9 * w25[i - 1]);
    e[57 * i + 22] = -(v9 * w26[i - 1]);
    e[57 * i + 28] = -(v9 * w27[i - 1]);
    e[57 * i + 23] = -(v9 * w28[i - 1]);
    e[57 * i + 29] = -(v9 * w29[i - 1]);
    e[57 * i + 20] = -(v9 * w30[i - 1]);
    e[57 * i + 26] = -(v9 * w31[i - 1]);
    e[57 * i + 21] = -(v9 * w32[i - 1]);
    e[57 * i + 27] = -(v9 * w33[i - 1]);
    e[57 * i + 44] = (v91 * w34[i - 1]) - (v91 * w46[i - 1]);
    e[57 * i + 50] = (v91 * w35[i - 1]) - (v91 * w47[i - 1]);
    e[57 * i + 43] = (v91 * w36[i - 1]) - (v91 * w48[i - 1]);
    e[57 * i + 49] = (v91 * w37[i - 1]) - (v91 * w49[i - 1]);
    e[57 * i + 41] = (v91 * w38[i - 1]) - (v91 * w50[i - 1]);
    e[57 * i + 47] = (v91 * w39[i - 1]) - (v91 * w51[i - 1]);
    e[57 * i + 42] = (v91 * w40[i - 1]) - (v91 * w52[i - 1]);
    e[57 * i + 48] = (v91 * w41[i - 1]) - (v91 * w53[i - 1]);
    e[57 * i + 39] = (v91 * w42[i - 1]) - (v91 * w54[i - 1]);
    e[57 * i + 45] = (v91 * w43[i - 1]) - (v91 * w55[i - 1]);
    e[57 * i + 40] = (v91 * w44[i - 1]) - (v91 * w56[i - 1]);
    e[57 * i + 46] = (v91 * w45[i - 1]) - (v91 * w57[i - 1]);
    (void)n;
}

static void work_0(int n, const double *p, const double *g, double *w, double *q)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const double c2 = p[5];
    const double c4 = p[8];
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
    const double c42 = p[5];
    const double c44 = p[8];
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

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 6; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, w);
    rates_2(n, w);
    rates_3(n, p, g, w);
    rates_4(n, p, g, w, f);
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
    for (int k = 0; k < n * 57; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, y, w);
    jacobian_2(n, w);
    jacobian_3(n, p, g, w);
    jacobian_4(n, p, g, w, e);
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
    (void)y;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, g, w, q);
    return SOFTCAT_SOLVED;
}

static int work_slope(const softcat_filament *filament, double t, const double *y, double *s,
                      double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    (void)y;
    for (int k = 0; k < n * 18; k++) s[k] = 0.0;
    work_slope_0(n, p, g, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {2, 3, -1, -1, 5, -1};
static const int differential[] = {1, 1, 1, 1, 1, 1};
static const int held_first[] = {1, 1, 1, 1, 1, 1};
static const int held_last[] = {0, 0, 0, 0, 0, 0};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
static const int offset[] = {0, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5};

const softcat_model softcat_filament_model = {
    6, 0, 9, 7, 58, 57, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "youngs_modulus", "viscosity", "poisson",
    "curvature", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa", "Pa*s", "1", "1/m", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_ANY, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.1, 0.0031, 1200.0, 9.81, 1300000.0, 20000.0, 0.45, 15.0, 0.10096375546923045};
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
    .title = "Curled silicone rod held by one end",
    .parameter_names = described_parameters,
    .parameter_units = described_units,
    .parameter_ranges = described_ranges,
    .parameter_values = described_values,
    .slot_names = described_slots,
    .on_cells = described_on_cells,
    .mean = described_mean,
    .bending = described_bending,
    .first = SOFTCAT_CLAMPED,
    .last = SOFTCAT_FREE,
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
    .curvature = 7,
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
    .relative = 3e-05,
    .absolute = 3.0000000000000004e-07,
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
