/*
 * Rubber band pulled taut: swings as a string
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation, shear,
 *     rotary-inertia
 * Digest of the structure: 717a10f3cee9711f9a12ccd5e1f0e29b9de9782838b6d9ad0691f261179bfe6c
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[6 * i] = y[6 * i + 2];
        f[6 * i + 4] = y[6 * i + 5];
    }
}

static void rates_1(int n, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[6 * i + 1] = y[6 * i + 3];
    }
}

static void rates_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 4];
    }
}

static void rates_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[6 * i + 1];
    }
}

static void rates_4(int n, const double *p, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c2 = 2.0 * p[0];
    const double c3 = p[6] / c2;
    const int i = n - 1;
    w0[i] = c3;
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

static void rates_6(int n, const double *p, const double *g, double *w)
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
    const double c54 = 0.8333333333333334 * c1;
    const double c56 = 2.0 * p[5];
    const double c57 = 2.0 + c56;
    const double c58 = c54 / c57;
    const double c66 = 0.5 * c4;
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
        const double v37 = log(v32);
        const double v39 = c1 * ((((-0.5773502691896257) * v15) * v35) + v37);
        const double v45 = c1 * (((0.5773502691896257 * v15) * v35) + v37);
        const double v48 = 1.0 / v32;
        const double v52 = (v29 * v24) - (v20 * v30);
        const double v60 = c58 * (v52 * v48);
        const double v61 = v60 * v48;
        const double v71 = ((-0.28867513459481287) * v39) + (0.28867513459481287 * v45);
        const double v73 = (c66 * v71) * v35;
        const double v77 = ((((0.5 * v39) + (0.5 * v45)) * v48) - ((v52 * v61) * v48)) + (((1.5 * v73) * v14) * v48);
        w3[i] = (v77 * v24) - (v61 * v30);
        w4[i] = (v77 * v30) + (v61 * v24);
        w5[i] = ((g[7 * i + 1] * c11) * (v60 - (v52 * v77))) * 0.5;
        w6[i] = -v73;
    }
}

static void rates_7(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w3 = w + 3 * n;
    double *restrict w5 = w + 5 * n;
    double *restrict w6 = w + 6 * n;
    const double c4 = squared(p[7]);
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
    for (int i = 1; i < n - 1; i++) {
        const double v31 = (((w6[i] - w6[i - 1]) + w5[i]) + w5[i - 1]) * (c27 * g[7 * i + 5]);
        f[6 * i + 2] = (w3[i] - w3[i - 1]) * (c9 * g[7 * i + 6]);
        f[6 * i + 5] = v31;
    }
}

static void rates_8(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w4 = w + 4 * n;
    const double c4 = squared(p[7]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    const double c15 = p[3] * c6;
    for (int i = 1; i < n - 1; i++) {
        f[6 * i + 3] = ((w4[i] - w4[i - 1]) * (c9 * g[7 * i + 6])) - c15;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w4 = w + 4 * n;
    const double c2 = squared(p[7]);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c6 = p[2] * c3;
    const double c7 = c4 / c6;
    const double c13 = p[3] * c4;
    const int i = 0;
    f[6 * i + 3] = (w4[i] * (c7 * g[7 * i + 6])) - c13;
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[30 * i] = 1.0;
        e[30 * i + 20] = 1.0;
    }
}

static void jacobian_1(int n, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[30 * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 4];
    }
}

static void jacobian_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[6 * i + 1];
    }
}

static void jacobian_4(int n, const double *p, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c2 = 2.0 * p[0];
    const double c3 = p[6] / c2;
    const int i = n - 1;
    w0[i] = c3;
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

static void jacobian_6(int n, const double *p, const double *g, double *w)
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
    const double c1 = p[4];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c54 = 0.8333333333333334 * c1;
    const double c56 = 2.0 * p[5];
    const double c57 = 2.0 + c56;
    const double c58 = c54 / c57;
    const double c66 = 0.5 * c4;
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
        const double v39 = c1 * (v36 + v37);
        const double v43 = (0.5773502691896257 * v15) * v35;
        const double v45 = c1 * (v43 + v37);
        const double v48 = 1.0 / v32;
        const double v49 = ((0.5 * v39) + (0.5 * v45)) * v48;
        const double v52 = (v29 * v24) - (v20 * v30);
        const double v59 = v52 * v48;
        const double v60 = c58 * v59;
        const double v61 = v60 * v48;
        const double v63 = (v52 * v61) * v48;
        const double v71 = ((-0.28867513459481287) * v39) + (0.28867513459481287 * v45);
        const double v73 = (c66 * v71) * v35;
        const double v74 = 1.5 * v73;
        const double v76 = (v74 * v14) * v48;
        const double v77 = (v49 - v63) + v76;
        const double v81 = 0.5 * v24;
        const double v83 = 0.5 * v30;
        const double v85 = (v29 * v81) - (v20 * v83);
        const double v86 = v85 * v48;
        const double v87 = c5 * v13;
        const double v89 = ((-0.5773502691896257) * v87) * v35;
        const double v90 = v36 * v35;
        const double v92 = 1.0 / (2.0 * v33);
        const double v96 = (v32 * (v85 * v92)) + (v33 * v85);
        const double v97 = v90 * v96;
        const double v100 = c1 * (v86 - (v89 + v97));
        const double v103 = (0.5773502691896257 * v87) * v35;
        const double v104 = v43 * v35;
        const double v105 = v104 * v96;
        const double v108 = c1 * (v86 - (v103 + v105));
        const double v112 = v49 * v48;
        const double v113 = v112 * v85;
        const double v117 = (v29 * v83) + (v20 * v81);
        const double v120 = v59 * v48;
        const double v123 = c58 * ((v117 * v48) + (v120 * v85));
        const double v125 = v61 * v48;
        const double v127 = (v123 * v48) + (v125 * v85);
        const double v131 = v63 * v48;
        const double v133 = (((v61 * v117) + (v52 * v127)) * v48) + (v131 * v85);
        const double v137 = ((-0.28867513459481287) * v100) + (0.28867513459481287 * v108);
        const double v140 = v73 * v35;
        const double v141 = v140 * v96;
        const double v142 = ((c66 * v137) * v35) - v141;
        const double v145 = v74 * v13;
        const double v148 = v76 * v48;
        const double v149 = v148 * v85;
        const double v151 = (((((0.5 * v100) + (0.5 * v108)) * v48) - v113) + v133) + ((((v14 * (1.5 * v142)) - v145) * v48) - v149);
        const double v153 = v77 * v83;
        const double v157 = (v61 * v81) - (v30 * v127);
        const double v161 = c1 * ((v89 - v97) + v86);
        const double v165 = c1 * ((v103 - v105) + v86);
        const double v173 = ((-0.28867513459481287) * v161) + (0.28867513459481287 * v165);
        const double v176 = ((c66 * v173) * v35) - v141;
        const double v182 = (((((0.5 * v161) + (0.5 * v165)) * v48) - v113) + v133) + ((((v14 * (1.5 * v176)) + v145) * v48) - v149);
        const double v186 = v24 * v10;
        const double v190 = (v32 * (v186 * v92)) + (v33 * v186);
        const double v191 = v90 * v190;
        const double v192 = v186 * v48;
        const double v194 = c1 * (v191 - v192);
        const double v196 = v104 * v190;
        const double v198 = c1 * (v196 - v192);
        const double v202 = v112 * v186;
        const double v204 = v30 * v10;
        const double v206 = v204 * v48;
        const double v209 = c58 * (v206 + (v120 * v186));
        const double v212 = (v209 * v48) + (v125 * v186);
        const double v217 = (((v61 * v204) + (v52 * v212)) * v48) + (v131 * v186);
        const double v221 = ((-0.28867513459481287) * v194) + (0.28867513459481287 * v198);
        const double v224 = v140 * v190;
        const double v225 = ((c66 * v221) * v35) + v224;
        const double v229 = v148 * v186;
        const double v231 = (((((0.5 * v194) + (0.5 * v198)) * v48) + v202) - v217) + (((v14 * (1.5 * v225)) * v48) + v229);
        const double v233 = v30 * v212;
        const double v236 = c1 * (v192 - v191);
        const double v239 = c1 * (v192 - v196);
        const double v247 = ((-0.28867513459481287) * v236) + (0.28867513459481287 * v239);
        const double v250 = ((c66 * v247) * v35) - v224;
        const double v255 = (((((0.5 * v236) + (0.5 * v239)) * v48) - v202) + v217) + (((v14 * (1.5 * v250)) * v48) - v229);
        const double v261 = (v32 * (v204 * v92)) + (v33 * v204);
        const double v262 = v90 * v261;
        const double v264 = c1 * (v262 - v206);
        const double v266 = v104 * v261;
        const double v268 = c1 * (v266 - v206);
        const double v272 = v112 * v204;
        const double v274 = v120 * v204;
        const double v276 = c58 * (v274 - v192);
        const double v278 = v125 * v204;
        const double v279 = (v276 * v48) + v278;
        const double v281 = v61 * v186;
        const double v284 = v131 * v204;
        const double v286 = ((((0.5 * v264) + (0.5 * v268)) * v48) + v272) - ((((v52 * v279) - v281) * v48) + v284);
        const double v289 = ((-0.28867513459481287) * v264) + (0.28867513459481287 * v268);
        const double v292 = v140 * v261;
        const double v293 = ((c66 * v289) * v35) + v292;
        const double v297 = v148 * v204;
        const double v299 = v286 + (((v14 * (1.5 * v293)) * v48) + v297);
        const double v304 = c1 * (v206 - v262);
        const double v307 = c1 * (v206 - v266);
        const double v313 = c58 * (v192 - v274);
        const double v315 = (v313 * v48) - v278;
        const double v320 = ((((0.5 * v304) + (0.5 * v307)) * v48) - v272) - (((v281 + (v52 * v315)) * v48) - v284);
        const double v323 = ((-0.28867513459481287) * v304) + (0.28867513459481287 * v307);
        const double v326 = ((c66 * v323) * v35) - v292;
        const double v331 = v320 + (((v14 * (1.5 * v326)) * v48) - v297);
        const double v339 = v77 * v81;
        const double v343 = (v24 * v127) + (v61 * v83);
        const double v349 = v24 * v212;
        const double v359 = g[7 * i + 1] * c11;
        const double v365 = v77 * v117;
        const double v377 = v77 * v204;
        const double v390 = v77 * v186;
        w3[i] = (v77 * v24) - (v61 * v30);
        w7[i] = ((v24 * v151) - v153) - v157;
        w8[i] = ((v24 * v182) - v153) - v157;
        w9[i] = (v24 * v231) - v233;
        w10[i] = (v24 * v255) + v233;
        w11[i] = (v24 * v299) - (v30 * v279);
        w12[i] = (v24 * v331) - (v30 * v315);
        w4[i] = (v77 * v30) + (v61 * v24);
        w13[i] = ((v30 * v151) + v339) - v343;
        w14[i] = ((v30 * v182) + v339) - v343;
        w15[i] = (v30 * v231) + v349;
        w16[i] = (v30 * v255) - v349;
        w17[i] = (v30 * v299) + (v24 * v279);
        w18[i] = (v30 * v331) + (v24 * v315);
        w5[i] = (v359 * (v60 - (v52 * v77))) * 0.5;
        w19[i] = -(0.5 * (v359 * (v123 + ((v52 * v151) - v365))));
        w20[i] = -(0.5 * (v359 * (v123 + ((v52 * v182) - v365))));
        w21[i] = 0.5 * (v359 * (v209 - (v377 + (v52 * v231))));
        w22[i] = -(0.5 * (v359 * (v209 + ((v52 * v255) - v377))));
        w23[i] = 0.5 * (v359 * (v276 - ((v52 * v299) - v390)));
        w24[i] = 0.5 * (v359 * (v313 - (v390 + (v52 * v331))));
        w6[i] = -v73;
        w25[i] = -v142;
        w26[i] = -v176;
        w27[i] = -v225;
        w28[i] = -v250;
        w29[i] = -v293;
        w30[i] = -v326;
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
    const double c1 = squared(p[7]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c41 = 0.08333333333333333 * c4;
    const double c43 = squared(p[1]);
    const double c44 = c41 * c43;
    const double c45 = c44 * c2;
    const double c46 = c1 / c45;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v49 = c46 * g[7 * i + 5];
        const double v62 = ((v49 * w25[i]) - (v49 * w26[i - 1])) + (v49 * w20[i - 1]);
        const double v83 = ((v49 * w27[i]) - (v49 * w28[i - 1])) + (v49 * w22[i - 1]);
        const double v104 = ((v49 * w29[i]) - (v49 * w30[i - 1])) + (v49 * w24[i - 1]);
        e[30 * i + 4] = -(v9 * w7[i - 1]);
        e[30 * i + 7] = (v9 * w7[i]) - (v9 * w8[i - 1]);
        e[30 * i + 10] = v9 * w8[i];
        e[30 * i + 2] = -(v9 * w9[i - 1]);
        e[30 * i + 5] = (v9 * w9[i]) - (v9 * w10[i - 1]);
        e[30 * i + 8] = v9 * w10[i];
        e[30 * i + 3] = -(v9 * w11[i - 1]);
        e[30 * i + 6] = (v9 * w11[i]) - (v9 * w12[i - 1]);
        e[30 * i + 9] = v9 * w12[i];
        e[30 * i + 23] = (v49 * w19[i - 1]) - (v49 * w25[i - 1]);
        e[30 * i + 26] = v62 + (v49 * w19[i]);
        e[30 * i + 29] = (v49 * w26[i]) + (v49 * w20[i]);
        e[30 * i + 21] = (v49 * w21[i - 1]) - (v49 * w27[i - 1]);
        e[30 * i + 24] = v83 + (v49 * w21[i]);
        e[30 * i + 27] = (v49 * w28[i]) + (v49 * w22[i]);
        e[30 * i + 22] = (v49 * w23[i - 1]) - (v49 * w29[i - 1]);
        e[30 * i + 25] = v104 + (v49 * w23[i]);
        e[30 * i + 28] = (v49 * w30[i]) + (v49 * w24[i]);
    }
}

static void jacobian_8(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    const double c1 = squared(p[7]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[30 * i + 13] = -(v9 * w13[i - 1]);
        e[30 * i + 16] = (v9 * w13[i]) - (v9 * w14[i - 1]);
        e[30 * i + 19] = v9 * w14[i];
        e[30 * i + 11] = -(v9 * w15[i - 1]);
        e[30 * i + 14] = (v9 * w15[i]) - (v9 * w16[i - 1]);
        e[30 * i + 17] = v9 * w16[i];
        e[30 * i + 12] = -(v9 * w17[i - 1]);
        e[30 * i + 15] = (v9 * w17[i]) - (v9 * w18[i - 1]);
        e[30 * i + 18] = v9 * w18[i];
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w13 = w + 13 * n;
    double *restrict w14 = w + 14 * n;
    double *restrict w15 = w + 15 * n;
    double *restrict w16 = w + 16 * n;
    double *restrict w17 = w + 17 * n;
    double *restrict w18 = w + 18 * n;
    const double c1 = squared(p[7]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[30 * i + 16] = v9 * w13[i];
    e[30 * i + 19] = v9 * w14[i];
    e[30 * i + 14] = v9 * w15[i];
    e[30 * i + 17] = v9 * w16[i];
    e[30 * i + 15] = v9 * w17[i];
    e[30 * i + 18] = v9 * w18[i];
    (void)n;
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
    rates_1(n, y, f);
    rates_2(n, y, w);
    rates_3(n, y, w);
    rates_4(n, p, w);
    rates_5(n, g, w);
    rates_6(n, p, g, w);
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
    for (int k = 0; k < n * 30; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, e);
    jacobian_2(n, y, w);
    jacobian_3(n, y, w);
    jacobian_4(n, p, w);
    jacobian_5(n, g, w);
    jacobian_6(n, p, g, w);
    jacobian_7(n, p, g, w, e);
    jacobian_8(n, p, g, w, e);
    jacobian_9(n, p, g, w, e);
    return SOFTCAT_SOLVED;
}





static const int rate[] = {2, 3, -1, -1, 5, -1};
static const int differential[] = {1, 1, 1, 1, 1, 1};
static const int held_first[] = {1, 0, 1, 0, 1, 1};
static const int held_last[] = {1, 1, 1, 1, 1, 1};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5};
static const int offset[] = {0, 0, -1, -1, -1, 0, 0, 0, 1, 1, 1, -1, -1, -1, 0, 0, 0, 1, 1, 1, 0, -1, -1, -1, 0, 0, 0, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 0, 1, 4, 5, 0, 1, 4, 0, 1, 4, 0, 1, 4};

const softcat_model softcat_filament_model = {
    6, 0, 8, 7, 31, 30, 0, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, 0, 0,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "youngs_modulus", "poisson", "span",
    "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa", "1", "m", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.08, 0.001, 930.0, 9.81, 1000000.0, 0.45, 0.1, 0.10096375546923045};
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
    .title = "Rubber band pulled taut: swings as a string",
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
    .time_scale = 7,
    .gravity = 3,
    .density = 2,
    .span = 6,
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
    .absolute = 2.7315151283575664e-10,
    .towards_middle = 0,
    .duration = 0.1,
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
