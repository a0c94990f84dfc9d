/*
 * Shaken strand: swings beyond statics near its first frequency
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-stress, shear, rotary-inertia, gravity-shaking
 * Digest of the structure: 6a9ce407b013197b89f5fd13706ac6eef0106d9cf8bc36d3a8d4125994d382f9
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
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 4];
        w2[i] = y[6 * i + 2];
        w3[i] = y[6 * i + 5];
    }
}

static void rates_3(int n, const double *y, double *w)
{
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    for (int i = 0; i < n - 1; i++) {
        w4[i] = y[6 * i + 1];
        w5[i] = y[6 * i + 3];
    }
}

static void rates_4(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w4[i] = 0.0;
    w1[i] = 0.0;
    w2[i] = 0.0;
    w5[i] = 0.0;
    w3[i] = 0.0;
    (void)n;
}

static void rates_5(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    const int i = 0;
    w0[i] = g[7 * i];
    w1[i] = 0.0;
    w2[i] = 0.0;
    w3[i] = 0.0;
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
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    const double c1 = p[4];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c40 = p[5];
    const double c43 = 1.0 / p[9];
    const double c74 = (-0.4999999999999998) * c4;
    const double c94 = 0.5000000000000001 * c4;
    const double c106 = 0.9 * c1;
    const double c108 = 2.0 * p[6];
    const double c109 = 2.0 + c108;
    const double c110 = c106 / c109;
    const double c114 = 0.3 * c40;
    const double c134 = 0.5 * c4;
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
        const double v29 = (w4[i + 1] - w4[i]) * v10;
        const double v30 = sin(v23);
        const double v32 = (v20 * v24) + (v29 * v30);
        const double v33 = sqrt(v32);
        const double v35 = 1.0 / (v33 * v32);
        const double v37 = log(v32);
        const double v44 = w3[i] * c43;
        const double v46 = w3[i + 1] * c43;
        const double v48 = (v44 + v46) * 0.5;
        const double v51 = (v29 * v24) - (v20 * v30);
        const double v58 = ((w2[i + 1] * c43) - (w2[i] * c43)) * v10;
        const double v66 = ((w5[i + 1] * c43) - (w5[i] * c43)) * v10;
        const double v68 = ((v48 * v51) + (v58 * v24)) + (v66 * v30);
        const double v71 = squared(v32);
        const double v73 = (0.75 * v14) / (v33 * v71);
        const double v76 = 1.0 / v32;
        const double v82 = ((-0.5) * ((v46 - v44) * v13)) * v35;
        const double v86 = (c1 * ((((-0.4999999999999998) * v15) * v35) + v37)) + (c40 * ((v68 * ((v73 * c74) + v76)) + (v82 * c74)));
        const double v101 = (c1 * (((0.5000000000000001 * v15) * v35) + v37)) + (c40 * ((v68 * ((v73 * c94) + v76)) + (v82 * c94)));
        const double v123 = ((((v66 * v24) - (v48 * v32)) - (v58 * v30)) * v76) - ((v51 * v68) / v71);
        const double v125 = (c110 * (v51 * v76)) + (c114 * v123);
        const double v128 = (0.5 * v125) + (0.4999999999999999 * v125);
        const double v129 = v128 * v76;
        const double v132 = (((0.5 * v86) + (0.4999999999999999 * v101)) * v76) - ((v51 * v129) * v76);
        const double v141 = (c134 * (((-0.2499999999999999) * v86) + (0.25 * v101))) * v35;
        const double v145 = v132 + (((1.5 * v141) * v14) * v76);
        w6[i] = (v145 * v24) - (v129 * v30);
        w7[i] = (v145 * v30) + (v129 * v24);
        w8[i] = ((g[7 * i + 1] * c11) * (v128 - (v51 * v145))) * 0.5;
        w9[i] = -v141;
    }
}

static void rates_7(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w6 = w + 6 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
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
        const double v31 = (((w9[i] - w9[i - 1]) + w8[i]) + w8[i - 1]) * (c27 * g[7 * i + 5]);
        f[6 * i + 2] = (w6[i] - w6[i - 1]) * (c9 * g[7 * i + 6]);
        f[6 * i + 5] = v31;
    }
}

static void rates_8(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w7 = w + 7 * n;
    const double c3 = p[9];
    const double c4 = squared(c3);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    const double c18 = t * c3;
    const double c21 = 6.283185307179586 * p[8];
    const double c22 = c18 * c21;
    const double c23 = sin(c22);
    const double c24 = p[7] * c23;
    const double c25 = 1.0 + c24;
    const double c26 = p[3] * c25;
    const double c27 = c26 * c6;
    for (int i = 1; i < n - 1; i++) {
        f[6 * i + 3] = ((w7[i] - w7[i - 1]) * (c9 * g[7 * i + 6])) - c27;
    }
}

static void rates_9(int n, double t, const double *p, const double *g, double *w, double *f)
{
    double *restrict w7 = w + 7 * n;
    const double c1 = p[9];
    const double c2 = squared(c1);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c6 = p[2] * c3;
    const double c7 = c4 / c6;
    const double c16 = t * c1;
    const double c19 = 6.283185307179586 * p[8];
    const double c20 = c16 * c19;
    const double c21 = sin(c20);
    const double c22 = p[7] * c21;
    const double c23 = 1.0 + c22;
    const double c24 = p[3] * c23;
    const double c25 = c24 * c4;
    const int i = 0;
    f[6 * i + 3] = (w7[i] * (c7 * g[7 * i + 6])) - c25;
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[57 * i] = 1.0;
        e[57 * i + 38] = 1.0;
    }
}

static void jacobian_1(int n, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[57 * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 4];
        w2[i] = y[6 * i + 2];
        w3[i] = y[6 * i + 5];
    }
}

static void jacobian_3(int n, const double *y, double *w)
{
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    for (int i = 0; i < n - 1; i++) {
        w4[i] = y[6 * i + 1];
        w5[i] = y[6 * i + 3];
    }
}

static void jacobian_4(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w4[i] = 0.0;
    w1[i] = 0.0;
    w2[i] = 0.0;
    w5[i] = 0.0;
    w3[i] = 0.0;
    (void)n;
}

static void jacobian_5(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    const int i = 0;
    w0[i] = g[7 * i];
    w1[i] = 0.0;
    w2[i] = 0.0;
    w3[i] = 0.0;
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
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c40 = p[5];
    const double c43 = 1.0 / p[9];
    const double c75 = (-0.4999999999999998) * c4;
    const double c95 = 0.5000000000000001 * c4;
    const double c107 = 0.9 * c1;
    const double c109 = 2.0 * p[6];
    const double c110 = 2.0 + c109;
    const double c111 = c107 / c110;
    const double c115 = 0.3 * c40;
    const double c136 = 0.5 * c4;
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
        const double v29 = (w4[i + 1] - w4[i]) * v10;
        const double v30 = sin(v23);
        const double v32 = (v20 * v24) + (v29 * v30);
        const double v33 = sqrt(v32);
        const double v35 = 1.0 / (v33 * v32);
        const double v36 = ((-0.4999999999999998) * v15) * v35;
        const double v37 = log(v32);
        const double v44 = w3[i] * c43;
        const double v46 = w3[i + 1] * c43;
        const double v48 = (v44 + v46) * 0.5;
        const double v51 = (v29 * v24) - (v20 * v30);
        const double v58 = ((w2[i + 1] * c43) - (w2[i] * c43)) * v10;
        const double v66 = ((w5[i + 1] * c43) - (w5[i] * c43)) * v10;
        const double v68 = ((v48 * v51) + (v58 * v24)) + (v66 * v30);
        const double v71 = squared(v32);
        const double v73 = 1.0 / (v33 * v71);
        const double v74 = (0.75 * v14) * v73;
        const double v77 = 1.0 / v32;
        const double v78 = (v74 * c75) + v77;
        const double v83 = ((-0.5) * ((v46 - v44) * v13)) * v35;
        const double v87 = (c1 * (v36 + v37)) + (c40 * ((v68 * v78) + (v83 * c75)));
        const double v92 = (0.5000000000000001 * v15) * v35;
        const double v97 = (v74 * c95) + v77;
        const double v102 = (c1 * (v92 + v37)) + (c40 * ((v68 * v97) + (v83 * c95)));
        const double v105 = ((0.5 * v87) + (0.4999999999999999 * v102)) * v77;
        const double v112 = v51 * v77;
        const double v121 = (((v66 * v24) - (v48 * v32)) - (v58 * v30)) * v77;
        const double v123 = 1.0 / v71;
        const double v124 = (v51 * v68) * v123;
        const double v127 = (c111 * v112) + (c115 * (v121 - v124));
        const double v130 = (0.5 * v127) + (0.4999999999999999 * v127);
        const double v131 = v130 * v77;
        const double v133 = (v51 * v131) * v77;
        const double v143 = (c136 * (((-0.2499999999999999) * v87) + (0.25 * v102))) * v35;
        const double v144 = 1.5 * v143;
        const double v146 = (v144 * v14) * v77;
        const double v147 = (v105 - v133) + v146;
        const double v151 = v24 * v77;
        const double v153 = v30 + (v51 * v151);
        const double v154 = v153 * v77;
        const double v155 = 0.4999999999999999 * v154;
        const double v156 = c115 * v155;
        const double v158 = 0.5 * v154;
        const double v159 = c115 * v158;
        const double v161 = (v156 * v77) + (v159 * v77);
        const double v163 = v156 * v123;
        const double v165 = v159 * v123;
        const double v169 = 1.5 * (v14 * v151);
        const double v171 = c136 * (v169 * v35);
        const double v174 = (0.25 * v171) + (0.4999999999999999 * v151);
        const double v175 = c40 * v174;
        const double v180 = ((-0.2499999999999999) * v171) + (0.5 * v151);
        const double v181 = c40 * v180;
        const double v183 = (((v51 * v163) + (v51 * v165)) + (v97 * v175)) + (v78 * v181);
        const double v186 = 0.5 * ((v32 * v161) + (v51 * v183));
        const double v187 = c95 * v175;
        const double v190 = c75 * v181;
        const double v194 = v13 * (((-0.5) * (v187 * v35)) + ((-0.5) * (v190 * v35)));
        const double v200 = v48 * v161;
        const double v205 = v48 * v183;
        const double v207 = (((v58 * v161) + (v29 * v200)) + (v66 * v183)) - (v20 * v205);
        const double v219 = (((v20 * v200) - (v66 * v161)) + (v58 * v183)) + (v29 * v205);
        const double v221 = ((v24 * v207) - ((v24 * v131) + (v30 * v147))) - (v30 * v219);
        const double v222 = v133 * v77;
        const double v224 = v146 * v77;
        const double v226 = v143 * v35;
        const double v227 = v226 * v169;
        const double v232 = 1.0 / (2.0 * v33);
        const double v235 = (v222 * v24) - (((v224 * v24) + (v33 * v227)) + ((v32 * v227) * v232));
        const double v236 = v131 * v77;
        const double v239 = 2.0 * v32;
        const double v240 = v124 * v123;
        const double v244 = v121 * v77;
        const double v246 = ((v235 + (v236 * v153)) - (v239 * (v240 * v156))) + (v244 * v156);
        const double v247 = v112 * v77;
        const double v248 = c111 * v155;
        const double v255 = ((v246 + (v247 * v248)) - (v239 * (v240 * v159))) + (v244 * v159);
        const double v256 = c111 * v158;
        const double v259 = v105 * v77;
        const double v262 = v83 * v35;
        const double v263 = v262 * v187;
        const double v268 = (((v255 + (v247 * v256)) - (v259 * v24)) - (v33 * v263)) - ((v32 * v263) * v232);
        const double v269 = v77 * v77;
        const double v270 = v68 * v175;
        const double v273 = v74 * v73;
        const double v274 = c95 * v270;
        const double v275 = v273 * v274;
        const double v281 = ((v268 - (v269 * v270)) - (v239 * (v33 * v275))) - ((v71 * v275) * v232);
        const double v282 = c1 * v174;
        const double v285 = v92 * v35;
        const double v286 = v285 * v282;
        const double v291 = ((v281 + (v282 * v77)) - (v33 * v286)) - ((v32 * v286) * v232);
        const double v292 = v262 * v190;
        const double v298 = v68 * v181;
        const double v300 = ((v291 - (v33 * v292)) - ((v32 * v292) * v232)) - (v269 * v298);
        const double v301 = c75 * v298;
        const double v302 = v273 * v301;
        const double v309 = c1 * v180;
        const double v311 = ((v300 - (v239 * (v33 * v302))) - ((v71 * v302) * v232)) + (v309 * v77);
        const double v312 = v36 * v35;
        const double v313 = v312 * v309;
        const double v318 = (v311 - (v33 * v313)) - ((v32 * v313) * v232);
        const double v326 = (((v68 * v163) - (v131 * v151)) - (v248 * v77)) + (v68 * v165);
        const double v328 = v326 - (v256 * v77);
        const double v337 = (v221 + (v24 * ((v29 * v318) - (v20 * v328)))) - (v30 * ((v29 * v328) + (v20 * v318)));
        const double v338 = 0.5 * v337;
        const double v346 = ((v144 * v151) + (0.75 * (v274 * v73))) + (c5 * (0.5000000000000001 * (v282 * v35)));
        const double v353 = (v346 + (0.75 * (v301 * v73))) + (c5 * ((-0.4999999999999998) * (v309 * v35)));
        const double v354 = v13 * v353;
        const double v361 = (((v30 * v161) + (v24 * v183)) * v10) * c43;
        const double v367 = (((v30 * v183) - (v24 * v161)) * v10) * c43;
        const double v375 = (((v24 * v200) - (v30 * v328)) - (v30 * v205)) + (v24 * v318);
        const double v376 = v375 * v10;
        const double v384 = (((v30 * v200) + (v24 * v328)) + (v24 * v205)) + (v30 * v318);
        const double v385 = v384 * v10;
        const double v390 = v30 * v77;
        const double v392 = 1.5 * (v14 * v390);
        const double v394 = c136 * (v392 * v35);
        const double v397 = (0.25 * v394) + (0.4999999999999999 * v390);
        const double v398 = c40 * v397;
        const double v401 = v24 - (v51 * v390);
        const double v402 = v401 * v77;
        const double v403 = 0.4999999999999999 * v402;
        const double v404 = c115 * v403;
        const double v405 = v404 * v123;
        const double v407 = 0.5 * v402;
        const double v408 = c115 * v407;
        const double v409 = v408 * v123;
        const double v415 = ((-0.2499999999999999) * v394) + (0.5 * v390);
        const double v416 = c40 * v415;
        const double v418 = ((v97 * v398) - ((v51 * v405) + (v51 * v409))) + (v78 * v416);
        const double v422 = (v404 * v77) + (v408 * v77);
        const double v425 = 0.5 * ((v51 * v418) - (v32 * v422));
        const double v426 = c95 * v398;
        const double v429 = c75 * v416;
        const double v433 = v13 * (((-0.5) * (v426 * v35)) + ((-0.5) * (v429 * v35)));
        const double v443 = v48 * v422;
        const double v447 = v48 * v418;
        const double v449 = ((v66 * v418) - ((v58 * v422) + (v29 * v443))) - (v20 * v447);
        const double v458 = (((v66 * v422) - (v20 * v443)) + (v58 * v418)) + (v29 * v447);
        const double v460 = (((v24 * v147) - (v30 * v131)) + (v24 * v449)) - (v30 * v458);
        const double v463 = v226 * v392;
        const double v469 = (v222 * v30) - (((v224 * v30) + (v33 * v463)) + ((v32 * v463) * v232));
        const double v476 = ((v469 - (v236 * v401)) + (v239 * (v240 * v404))) - (v244 * v404);
        const double v477 = c111 * v403;
        const double v484 = ((v476 - (v247 * v477)) + (v239 * (v240 * v408))) - (v244 * v408);
        const double v485 = c111 * v407;
        const double v490 = v262 * v426;
        const double v495 = (((v484 - (v247 * v485)) - (v259 * v30)) - (v33 * v490)) - ((v32 * v490) * v232);
        const double v496 = v68 * v398;
        const double v499 = c95 * v496;
        const double v500 = v273 * v499;
        const double v506 = ((v495 - (v269 * v496)) - (v239 * (v33 * v500))) - ((v71 * v500) * v232);
        const double v507 = c1 * v397;
        const double v510 = v285 * v507;
        const double v515 = ((v506 + (v507 * v77)) - (v33 * v510)) - ((v32 * v510) * v232);
        const double v516 = v262 * v429;
        const double v522 = v68 * v416;
        const double v524 = ((v515 - (v33 * v516)) - ((v32 * v516) * v232)) - (v269 * v522);
        const double v525 = c75 * v522;
        const double v526 = v273 * v525;
        const double v533 = c1 * v415;
        const double v535 = ((v524 - (v239 * (v33 * v526))) - ((v71 * v526) * v232)) + (v533 * v77);
        const double v536 = v312 * v533;
        const double v541 = (v535 - (v33 * v536)) - ((v32 * v536) * v232);
        const double v549 = ((v477 * v77) - ((v131 * v390) + (v68 * v405))) - (v68 * v409);
        const double v551 = v549 + (v485 * v77);
        const double v560 = (v460 + (v24 * ((v29 * v541) - (v20 * v551)))) - (v30 * ((v29 * v551) + (v20 * v541)));
        const double v561 = 0.5 * v560;
        const double v569 = ((v144 * v390) + (0.75 * (v499 * v73))) + (c5 * (0.5000000000000001 * (v507 * v35)));
        const double v576 = (v569 + (0.75 * (v525 * v73))) + (c5 * ((-0.4999999999999998) * (v533 * v35)));
        const double v577 = v13 * v576;
        const double v584 = (((v24 * v418) - (v30 * v422)) * v10) * c43;
        const double v590 = (((v24 * v422) + (v30 * v418)) * v10) * c43;
        const double v598 = (v24 * v541) - (((v24 * v443) + (v30 * v551)) + (v30 * v447));
        const double v599 = v598 * v10;
        const double v607 = (((v24 * v551) - (v30 * v443)) + (v24 * v447)) + (v30 * v541);
        const double v608 = v607 * v10;
        const double v610 = g[7 * i + 1] * c11;
        const double v615 = 0.5 * v610;
        const double v616 = v51 * v615;
        const double v617 = v616 * v77;
        const double v619 = 1.5 * (v14 * v617);
        const double v621 = c136 * (v619 * v35);
        const double v624 = (0.25 * v621) + (0.4999999999999999 * v617);
        const double v625 = c40 * v624;
        const double v626 = c95 * v625;
        const double v631 = ((-0.2499999999999999) * v621) + (0.5 * v617);
        const double v632 = c40 * v631;
        const double v633 = c75 * v632;
        const double v637 = v13 * (((-0.5) * (v626 * v35)) + ((-0.5) * (v633 * v35)));
        const double v641 = v51 * v617;
        const double v643 = v615 + (v641 * v77);
        const double v644 = 0.4999999999999999 * v643;
        const double v645 = c115 * v644;
        const double v646 = v645 * v123;
        const double v649 = 0.5 * v643;
        const double v650 = c115 * v649;
        const double v651 = v650 * v123;
        const double v653 = (((v97 * v625) + (v78 * v632)) + (v51 * v646)) + (v51 * v651);
        const double v657 = (v645 * v77) + (v650 * v77);
        const double v660 = 0.5 * ((v51 * v653) + (v32 * v657));
        const double v667 = v68 * v625;
        const double v668 = c95 * v667;
        const double v672 = c1 * v624;
        const double v676 = ((v144 * v617) + (0.75 * (v668 * v73))) + (c5 * (0.5000000000000001 * (v672 * v35)));
        const double v677 = v68 * v632;
        const double v678 = c75 * v677;
        const double v682 = c1 * v631;
        const double v686 = (v676 + (0.75 * (v678 * v73))) + (c5 * ((-0.4999999999999998) * (v682 * v35)));
        const double v687 = v13 * v686;
        const double v688 = v48 * v653;
        const double v694 = v48 * v657;
        const double v696 = (((v20 * v688) - (v66 * v653)) - (v58 * v657)) - (v29 * v694);
        const double v704 = (v66 * v657) - (((v58 * v653) + (v29 * v688)) + (v20 * v694));
        const double v708 = v226 * v619;
        const double v715 = (((v224 * v616) + (v33 * v708)) + ((v32 * v708) * v232)) - (v222 * v616);
        const double v720 = v262 * v626;
        const double v725 = (((v715 - (v236 * v641)) + (v259 * v616)) + (v33 * v720)) + ((v32 * v720) * v232);
        const double v728 = v273 * v668;
        const double v734 = ((v725 + (v269 * v667)) + (v239 * (v33 * v728))) + ((v71 * v728) * v232);
        const double v737 = v285 * v672;
        const double v742 = ((v734 - (v672 * v77)) + (v33 * v737)) + ((v32 * v737) * v232);
        const double v743 = v262 * v633;
        const double v750 = ((v742 + (v33 * v743)) + ((v32 * v743) * v232)) + (v269 * v677);
        const double v751 = v273 * v678;
        const double v759 = ((v750 + (v239 * (v33 * v751))) + ((v71 * v751) * v232)) - (v682 * v77);
        const double v760 = v312 * v682;
        const double v768 = ((v759 + (v33 * v760)) + ((v32 * v760) * v232)) + (v239 * (v240 * v645));
        const double v771 = c111 * v644;
        const double v776 = ((v768 - (v244 * v645)) - (v247 * v771)) + (v239 * (v240 * v650));
        const double v779 = c111 * v649;
        const double v781 = (v776 - (v244 * v650)) - (v247 * v779);
        const double v789 = (((v131 * v617) - (v147 * v615)) - (v68 * v646)) + (v771 * v77);
        const double v793 = (v789 - (v68 * v651)) + (v779 * v77);
        const double v797 = ((v24 * v696) - (v30 * v704)) + (v24 * ((v29 * v781) - (v20 * v793)));
        const double v803 = 0.5 * (v797 - (v30 * ((v20 * v781) + (v29 * v793))));
        const double v810 = (((v24 * v653) + (v30 * v657)) * v10) * c43;
        const double v816 = (((v24 * v657) - (v30 * v653)) * v10) * c43;
        const double v824 = (((v30 * v688) - (v24 * v694)) + (v24 * v781)) - (v30 * v793);
        const double v825 = v824 * v10;
        const double v833 = ((v30 * v781) - ((v24 * v688) + (v30 * v694))) + (v24 * v793);
        const double v834 = v833 * v10;
        const double v837 = c136 * v35;
        const double v838 = 0.25 * v837;
        const double v839 = c40 * v838;
        const double v840 = c95 * v839;
        const double v843 = (-0.2499999999999999) * v837;
        const double v844 = c40 * v843;
        const double v845 = c75 * v844;
        const double v849 = v13 * (((-0.5) * (v840 * v35)) + ((-0.5) * (v845 * v35)));
        const double v852 = (v97 * v839) + (v78 * v844);
        const double v854 = 0.5 * (v51 * v852);
        const double v860 = v48 * v852;
        const double v869 = (v24 * ((v20 * v860) - (v66 * v852))) + (v30 * ((v58 * v852) + (v29 * v860)));
        const double v874 = v262 * v840;
        const double v879 = (((v33 * v226) + ((v32 * v226) * v232)) + (v33 * v874)) + ((v32 * v874) * v232);
        const double v880 = v68 * v839;
        const double v883 = c95 * v880;
        const double v884 = v273 * v883;
        const double v890 = ((v879 + (v269 * v880)) + (v239 * (v33 * v884))) + ((v71 * v884) * v232);
        const double v891 = c1 * v838;
        const double v894 = v285 * v891;
        const double v899 = ((v890 - (v891 * v77)) + (v33 * v894)) + ((v32 * v894) * v232);
        const double v900 = v262 * v845;
        const double v906 = v68 * v844;
        const double v908 = ((v899 + (v33 * v900)) + ((v32 * v900) * v232)) + (v269 * v906);
        const double v909 = c75 * v906;
        const double v910 = v273 * v909;
        const double v917 = c1 * v843;
        const double v919 = ((v908 + (v239 * (v33 * v910))) + ((v71 * v910) * v232)) - (v917 * v77);
        const double v920 = v312 * v917;
        const double v925 = (v919 + (v33 * v920)) + ((v32 * v920) * v232);
        const double v932 = 0.5 * ((v869 + (v24 * (v29 * v925))) - (v30 * (v20 * v925)));
        const double v938 = (0.75 * (v883 * v73)) + (c5 * (0.5000000000000001 * (v891 * v35)));
        const double v945 = (v938 + (0.75 * (v909 * v73))) + (c5 * ((-0.4999999999999998) * (v917 * v35)));
        const double v946 = v13 * v945;
        const double v951 = ((v24 * v852) * v10) * c43;
        const double v955 = ((v30 * v852) * v10) * c43;
        const double v960 = ((v30 * v860) + (v24 * v925)) * v10;
        const double v965 = ((v30 * v925) - (v24 * v860)) * v10;
        w6[i] = (v147 * v24) - (v131 * v30);
        w10[i] = (v186 - v194) * c43;
        w11[i] = (v194 + v186) * c43;
        w12[i] = v338 - v354;
        w13[i] = v338 + v354;
        w14[i] = -v361;
        w15[i] = v361;
        w16[i] = -v367;
        w17[i] = v367;
        w18[i] = -v376;
        w19[i] = v376;
        w20[i] = -v385;
        w21[i] = v385;
        w7[i] = (v147 * v30) + (v131 * v24);
        w22[i] = (v425 - v433) * c43;
        w23[i] = (v433 + v425) * c43;
        w24[i] = v561 - v577;
        w25[i] = v561 + v577;
        w26[i] = -v584;
        w27[i] = v584;
        w28[i] = -v590;
        w29[i] = v590;
        w30[i] = -v599;
        w31[i] = v599;
        w32[i] = -v608;
        w33[i] = v608;
        w8[i] = (v610 * (v130 - (v51 * v147))) * 0.5;
        w34[i] = (v637 - v660) * c43;
        w35[i] = -((v637 + v660) * c43);
        w36[i] = v687 + v803;
        w37[i] = v803 - v687;
        w38[i] = v810;
        w39[i] = -v810;
        w40[i] = -v816;
        w41[i] = v816;
        w42[i] = -v825;
        w43[i] = v825;
        w44[i] = -v834;
        w45[i] = v834;
        w9[i] = -v143;
        w46[i] = (v849 - v854) * c43;
        w47[i] = -((v849 + v854) * c43);
        w48[i] = v932 + v946;
        w49[i] = v932 - v946;
        w50[i] = v951;
        w51[i] = -v951;
        w52[i] = v955;
        w53[i] = -v955;
        w54[i] = -v960;
        w55[i] = v960;
        w56[i] = -v965;
        w57[i] = v965;
    }
}

static void jacobian_7(int n, const double *p, const double *g, double *w, double *e)
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c71 = 0.0625 * c4;
    const double c73 = squared(p[1]);
    const double c74 = c71 * c73;
    const double c75 = c74 * c2;
    const double c76 = c1 / c75;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v79 = c76 * g[7 * i + 5];
        const double v92 = ((v79 * w46[i]) - (v79 * w47[i - 1])) + (v79 * w35[i - 1]);
        const double v113 = ((v79 * w48[i]) - (v79 * w49[i - 1])) + (v79 * w37[i - 1]);
        const double v134 = ((v79 * w50[i]) - (v79 * w51[i - 1])) + (v79 * w39[i - 1]);
        const double v155 = ((v79 * w52[i]) - (v79 * w53[i - 1])) + (v79 * w41[i - 1]);
        const double v176 = ((v79 * w54[i]) - (v79 * w55[i - 1])) + (v79 * w43[i - 1]);
        const double v197 = ((v79 * w56[i]) - (v79 * w57[i - 1])) + (v79 * w45[i - 1]);
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
        e[57 * i + 44] = (v79 * w34[i - 1]) - (v79 * w46[i - 1]);
        e[57 * i + 50] = v92 + (v79 * w34[i]);
        e[57 * i + 56] = (v79 * w47[i]) + (v79 * w35[i]);
        e[57 * i + 43] = (v79 * w36[i - 1]) - (v79 * w48[i - 1]);
        e[57 * i + 49] = v113 + (v79 * w36[i]);
        e[57 * i + 55] = (v79 * w49[i]) + (v79 * w37[i]);
        e[57 * i + 41] = (v79 * w38[i - 1]) - (v79 * w50[i - 1]);
        e[57 * i + 47] = v134 + (v79 * w38[i]);
        e[57 * i + 53] = (v79 * w51[i]) + (v79 * w39[i]);
        e[57 * i + 42] = (v79 * w40[i - 1]) - (v79 * w52[i - 1]);
        e[57 * i + 48] = v155 + (v79 * w40[i]);
        e[57 * i + 54] = (v79 * w53[i]) + (v79 * w41[i]);
        e[57 * i + 39] = (v79 * w42[i - 1]) - (v79 * w54[i - 1]);
        e[57 * i + 45] = v176 + (v79 * w42[i]);
        e[57 * i + 51] = (v79 * w55[i]) + (v79 * w43[i]);
        e[57 * i + 40] = (v79 * w44[i - 1]) - (v79 * w56[i - 1]);
        e[57 * i + 46] = v197 + (v79 * w44[i]);
        e[57 * i + 52] = (v79 * w57[i]) + (v79 * w45[i]);
    }
}

static void jacobian_8(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
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
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = squared(p[9]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[57 * i + 31] = v9 * w22[i];
    e[57 * i + 37] = v9 * w23[i];
    e[57 * i + 30] = v9 * w24[i];
    e[57 * i + 36] = v9 * w25[i];
    e[57 * i + 28] = v9 * w26[i];
    e[57 * i + 34] = v9 * w27[i];
    e[57 * i + 29] = v9 * w28[i];
    e[57 * i + 35] = v9 * w29[i];
    e[57 * i + 26] = v9 * w30[i];
    e[57 * i + 32] = v9 * w31[i];
    e[57 * i + 27] = v9 * w32[i];
    e[57 * i + 33] = v9 * w33[i];
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
    const double c4 = p[9];
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
        const double v6 = w3[i] * c5;
        const double v8 = w3[i + 1] * c5;
        const double v11 = (v6 + v8) * 0.5;
        const double v15 = g[7 * i + 4];
        const double v16 = (w4[i + 1] - w4[i]) * v15;
        const double v17 = w1[i];
        const double v18 = w1[i + 1];
        const double v20 = (v17 + v18) * 0.5;
        const double v21 = cos(v20);
        const double v26 = (w0[i + 1] - w0[i]) * v15;
        const double v27 = sin(v20);
        const double v29 = (v16 * v21) - (v26 * v27);
        const double v36 = ((w2[i + 1] * c5) - (w2[i] * c5)) * v15;
        const double v44 = ((w5[i + 1] * c5) - (w5[i] * c5)) * v15;
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

static void work_1(int n, double t, const double *p, const double *g, double *w, double *q)
{
    double *restrict w4 = w + 4 * n;
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = p[7] * p[3];
    const double c9 = 6.283185307179586 * p[8];
    const double c10 = c6 * c9;
    const double c12 = p[9];
    const double c13 = t * c12;
    const double c14 = c13 * c9;
    const double c15 = cos(c14);
    const double c16 = c10 * c15;
    const double c17 = c3 * c16;
    const double c18 = c1 / c12;
    const double c19 = squared(c18);
    const double c20 = c2 * c19;
    const double c21 = c12 / c20;
    const double c22 = c17 * c21;
    for (int i = 0; i < n; i++) {
        q[1] += (g[7 * i + 3] * c22) * w4[i];
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
    const double c44 = p[9];
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
        const double v6 = (w4[i + 1] - w4[i]) * v5;
        const double v7 = w1[i];
        const double v8 = w1[i + 1];
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
        const double v46 = w3[i] * c45;
        const double v48 = w3[i + 1] * c45;
        const double v50 = (v46 + v48) * 0.5;
        const double v57 = ((w2[i + 1] * c45) - (w2[i] * c45)) * v5;
        const double v65 = ((w5[i + 1] * c45) - (w5[i] * c45)) * v5;
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

static void work_slope_1(int n, double t, const double *p, const double *g, double *s)
{
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = p[7] * p[3];
    const double c9 = 6.283185307179586 * p[8];
    const double c10 = c6 * c9;
    const double c12 = p[9];
    const double c13 = t * c12;
    const double c14 = c13 * c9;
    const double c15 = cos(c14);
    const double c16 = c10 * c15;
    const double c17 = c3 * c16;
    const double c18 = c1 / c12;
    const double c19 = squared(c18);
    const double c20 = c2 * c19;
    const double c21 = c12 / c20;
    const double c22 = c17 * c21;
    for (int i = 0; i < n; i++) {
        s[6 * n + 6 * i + 1] += g[7 * i + 3] * c22;
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    for (int k = 0; k < n * 6; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, f);
    rates_2(n, y, w);
    rates_3(n, y, w);
    rates_4(n, w);
    rates_5(n, g, w);
    rates_6(n, p, g, w);
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
    for (int k = 0; k < n * 57; k++) e[k] = 0.0;
    jacobian_0(n, e);
    jacobian_1(n, e);
    jacobian_2(n, y, w);
    jacobian_3(n, y, w);
    jacobian_4(n, w);
    jacobian_5(n, g, w);
    jacobian_6(n, p, g, w);
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
    (void)y;
    for (int k = 0; k < 3; k++) q[k] = 0.0;
    work_0(n, p, g, w, q);
    work_1(n, t, p, g, w, q);
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
    work_slope_1(n, t, p, g, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {2, 3, -1, -1, 5, -1};
static const int differential[] = {1, 1, 1, 1, 1, 1};
static const int held_first[] = {1, 0, 1, 0, 1, 1};
static const int held_last[] = {1, 1, 1, 1, 1, 1};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
static const int offset[] = {0, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5};

const softcat_model softcat_filament_model = {
    6, 0, 10, 7, 58, 57, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "youngs_modulus", "viscosity", "poisson",
    "shake", "shake_frequency", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa", "Pa*s", "1", "1", "Hz", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.12, 0.008, 1100.0, 9.81, 500000.0, 800.0, 0.45, 0.5, 9.0, 0.1106002527218662};
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
    .title = "Shaken strand: swings beyond statics near its first frequency",
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
    .relative = 3e-05,
    .absolute = 2.6419415079876277e-07,
    .towards_middle = 0,
    .duration = 1.0,
    .cells = 40,
    .frames = 181,
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
