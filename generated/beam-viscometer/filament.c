/*
 * Glass bar with a weight in a beam-bending viscometer
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: bending, extensibility, finite-stretch, thinning, large-rotation, viscous-stress, shear
 * Digest of the structure: a2e5921fe537224c9d86ef1ea80e99fe0597bfa0a8a598191ed385c139e738e0
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[6 * i] = y[6 * i + 3];
    }
}

static void rates_1(int n, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[6 * i + 1] = y[6 * i + 4];
    }
}

static void rates_2(int n, const double *y, double *f)
{
    for (int i = 1; i < n; i++) {
        f[6 * i + 2] = y[6 * i + 5];
    }
}

static void rates_3(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 3];
    }
}

static void rates_4(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[6 * i + 1];
        w3[i] = y[6 * i + 4];
    }
}

static void rates_5(int n, const double *y, double *w)
{
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    for (int i = 1; i < n; i++) {
        w4[i] = y[6 * i + 2];
        w5[i] = y[6 * i + 5];
    }
}

static void rates_6(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w2[i] = 0.0;
    w1[i] = 0.0;
    w3[i] = 0.0;
    (void)n;
}

static void rates_7(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const int i = 0;
    w0[i] = g[8 * i];
    w4[i] = 0.0;
    w1[i] = 0.0;
    w5[i] = 0.0;
    (void)n;
}

static void rates_8(int n, const double *p, const double *g, double *w)
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
    const double c4 = 1.0 / p[6];
    const double c49 = p[0];
    const double c50 = 1.0 / c49;
    const double c62 = p[1];
    const double c63 = (-0.5773502691896257) * c62;
    const double c80 = 0.5773502691896257 * c62;
    const double c91 = 0.2777777777777778 * c1;
    const double c107 = 0.5 * c62;
    for (int i = 0; i < n - 1; i++) {
        const double v5 = w5[i] * c4;
        const double v7 = w5[i + 1] * c4;
        const double v10 = (v5 + v7) * 0.5;
        const double v15 = g[8 * i + 4];
        const double v16 = (w2[i + 1] - w2[i]) * v15;
        const double v17 = w4[i];
        const double v18 = w4[i + 1];
        const double v20 = (v17 + v18) * 0.5;
        const double v21 = cos(v20);
        const double v26 = (w0[i + 1] - w0[i]) * v15;
        const double v27 = sin(v20);
        const double v29 = (v16 * v21) - (v26 * v27);
        const double v36 = ((w1[i + 1] * c4) - (w1[i] * c4)) * v15;
        const double v44 = ((w3[i + 1] * c4) - (w3[i] * c4)) * v15;
        const double v46 = ((v10 * v29) + (v36 * v21)) + (v44 * v27);
        const double v51 = v15 * c50;
        const double v52 = (v18 - v17) * v51;
        const double v56 = (v26 * v21) + (v16 * v27);
        const double v57 = sqrt(v56);
        const double v58 = squared(v56);
        const double v60 = (0.75 * v52) / (v57 * v58);
        const double v65 = 1.0 / v56;
        const double v73 = 1.0 / (v57 * v56);
        const double v74 = ((-0.5) * ((v7 - v5) * v51)) * v73;
        const double v77 = c1 * ((v46 * ((v60 * c63) + v65)) + (v74 * c63));
        const double v86 = c1 * ((v46 * ((v60 * c80) + v65)) + (v74 * c80));
        const double v100 = ((((v44 * v21) - (v10 * v56)) - (v36 * v27)) * v65) - ((v29 * v46) / v58);
        const double v101 = c91 * v100;
        const double v102 = v101 * v65;
        const double v105 = (((0.5 * v77) + (0.5 * v86)) * v65) - ((v29 * v102) * v65);
        const double v112 = ((-0.28867513459481287) * v77) + (0.28867513459481287 * v86);
        const double v114 = (c107 * v112) * v73;
        const double v118 = v105 + (((1.5 * v114) * v52) * v65);
        w6[i] = (v118 * v21) - (v102 * v27);
        w7[i] = (v118 * v27) + (v102 * v21);
        w8[i] = ((g[8 * i + 1] * c49) * (v101 - (v29 * v118))) * 0.5;
        w9[i] = -v114;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w6 = w + 6 * n;
    const double c4 = squared(p[6]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    const double c13 = p[5] / c8;
    for (int i = 1; i < n - 1; i++) {
        const double v17 = (w6[i] - w6[i - 1]) * (c9 / (g[8 * i + 3] + (g[8 * i + 7] * c13)));
        f[6 * i + 3] = v17;
    }
}

static void rates_10(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    const double c4 = squared(p[6]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c7 = p[2];
    const double c8 = c7 * c5;
    const double c9 = c6 / c8;
    const double c13 = p[5] / c8;
    const double c19 = p[3] * c6;
    const double c29 = 0.08333333333333333 * c7;
    const double c31 = squared(p[1]);
    const double c32 = c29 * c31;
    const double c33 = c32 * c5;
    const double c34 = c4 / c33;
    const double c39 = squared(c5);
    const double c40 = c7 * c39;
    const double c41 = c32 / c40;
    for (int i = 1; i < n - 1; i++) {
        const double v17 = (w7[i] - w7[i - 1]) * (c9 / (g[8 * i + 3] + (g[8 * i + 7] * c13)));
        const double v38 = (((w9[i] - w9[i - 1]) + w8[i]) + w8[i - 1]) * (c34 * g[8 * i + 5]);
        f[6 * i + 4] = v17 - c19;
        f[6 * i + 5] = v38 * c41;
    }
}

static void rates_11(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w8 = w + 8 * n;
    double *restrict w9 = w + 9 * n;
    const double c4 = squared(p[6]);
    const double c6 = p[2];
    const double c7 = 0.08333333333333333 * c6;
    const double c9 = squared(p[1]);
    const double c10 = c7 * c9;
    const double c11 = p[0];
    const double c12 = c10 * c11;
    const double c13 = c4 / c12;
    const double c18 = squared(c11);
    const double c19 = c6 * c18;
    const double c20 = c10 / c19;
    const int i = n - 1;
    f[6 * i + 5] = ((w8[i - 1] - w9[i - 1]) * (c13 * g[8 * i + 5])) * c20;
    (void)n;
}

static void rates_12(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w7 = w + 7 * n;
    const double c2 = squared(p[6]);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c6 = p[2] * c3;
    const double c7 = c4 / c6;
    const double c11 = p[5] / c6;
    const double c17 = p[3] * c4;
    const int i = 0;
    const double v18 = (w7[i] * (c7 / (g[8 * i + 3] + (g[8 * i + 7] * c11)))) - c17;
    f[6 * i + 4] = v18;
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[57 * i] = 1.0;
    }
}

static void jacobian_1(int n, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[57 * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, double *e)
{
    for (int i = 1; i < n; i++) {
        e[57 * i + 2] = 1.0;
    }
}

static void jacobian_3(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[6 * i];
        w1[i] = y[6 * i + 3];
    }
}

static void jacobian_4(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[6 * i + 1];
        w3[i] = y[6 * i + 4];
    }
}

static void jacobian_5(int n, const double *y, double *w)
{
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    for (int i = 1; i < n; i++) {
        w4[i] = y[6 * i + 2];
        w5[i] = y[6 * i + 5];
    }
}

static void jacobian_6(int n, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    double *restrict w3 = w + 3 * n;
    const int i = n - 1;
    w0[i] = 0.5;
    w2[i] = 0.0;
    w1[i] = 0.0;
    w3[i] = 0.0;
    (void)n;
}

static void jacobian_7(int n, const double *g, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w4 = w + 4 * n;
    double *restrict w5 = w + 5 * n;
    const int i = 0;
    w0[i] = g[8 * i];
    w4[i] = 0.0;
    w1[i] = 0.0;
    w5[i] = 0.0;
    (void)n;
}

static void jacobian_8(int n, const double *p, const double *g, double *w)
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
    const double c4 = 1.0 / p[6];
    const double c49 = p[0];
    const double c50 = 1.0 / c49;
    const double c63 = p[1];
    const double c64 = (-0.5773502691896257) * c63;
    const double c81 = 0.5773502691896257 * c63;
    const double c92 = 0.2777777777777778 * c1;
    const double c109 = 0.5 * c63;
    for (int i = 0; i < n - 1; i++) {
        const double v5 = w5[i] * c4;
        const double v7 = w5[i + 1] * c4;
        const double v10 = (v5 + v7) * 0.5;
        const double v15 = g[8 * i + 4];
        const double v16 = (w2[i + 1] - w2[i]) * v15;
        const double v17 = w4[i];
        const double v18 = w4[i + 1];
        const double v20 = (v17 + v18) * 0.5;
        const double v21 = cos(v20);
        const double v26 = (w0[i + 1] - w0[i]) * v15;
        const double v27 = sin(v20);
        const double v29 = (v16 * v21) - (v26 * v27);
        const double v36 = ((w1[i + 1] * c4) - (w1[i] * c4)) * v15;
        const double v44 = ((w3[i + 1] * c4) - (w3[i] * c4)) * v15;
        const double v46 = ((v10 * v29) + (v36 * v21)) + (v44 * v27);
        const double v51 = v15 * c50;
        const double v52 = (v18 - v17) * v51;
        const double v56 = (v26 * v21) + (v16 * v27);
        const double v57 = sqrt(v56);
        const double v58 = squared(v56);
        const double v60 = 1.0 / (v57 * v58);
        const double v61 = (0.75 * v52) * v60;
        const double v66 = 1.0 / v56;
        const double v67 = (v61 * c64) + v66;
        const double v74 = 1.0 / (v57 * v56);
        const double v75 = ((-0.5) * ((v7 - v5) * v51)) * v74;
        const double v78 = c1 * ((v46 * v67) + (v75 * c64));
        const double v83 = (v61 * c81) + v66;
        const double v87 = c1 * ((v46 * v83) + (v75 * c81));
        const double v90 = ((0.5 * v78) + (0.5 * v87)) * v66;
        const double v98 = (((v44 * v21) - (v10 * v56)) - (v36 * v27)) * v66;
        const double v100 = 1.0 / v58;
        const double v101 = (v29 * v46) * v100;
        const double v103 = c92 * (v98 - v101);
        const double v104 = v103 * v66;
        const double v106 = (v29 * v104) * v66;
        const double v114 = ((-0.28867513459481287) * v78) + (0.28867513459481287 * v87);
        const double v116 = (c109 * v114) * v74;
        const double v117 = 1.5 * v116;
        const double v119 = (v117 * v52) * v66;
        const double v120 = (v90 - v106) + v119;
        const double v124 = v21 * v66;
        const double v126 = v27 + (v29 * v124);
        const double v129 = c92 * (0.5 * (v126 * v66));
        const double v131 = 2.0 * (v129 * v66);
        const double v133 = v129 * v100;
        const double v137 = 1.5 * (v52 * v124);
        const double v139 = c109 * (v137 * v74);
        const double v141 = 0.5 * v124;
        const double v143 = c1 * ((0.28867513459481287 * v139) + v141);
        const double v148 = c1 * (((-0.28867513459481287) * v139) + v141);
        const double v150 = ((2.0 * (v29 * v133)) + (v83 * v143)) + (v67 * v148);
        const double v153 = 0.5 * ((v56 * v131) + (v29 * v150));
        const double v154 = c81 * v143;
        const double v157 = c64 * v148;
        const double v161 = v51 * (((-0.5) * (v154 * v74)) + ((-0.5) * (v157 * v74)));
        const double v166 = v106 * v66;
        const double v168 = v119 * v66;
        const double v170 = v116 * v74;
        const double v171 = v170 * v137;
        const double v176 = 1.0 / (2.0 * v57);
        const double v179 = (v166 * v21) - (((v168 * v21) + (v57 * v171)) + ((v56 * v171) * v176));
        const double v180 = v104 * v66;
        const double v183 = 2.0 * v56;
        const double v184 = v101 * v100;
        const double v186 = v183 * (v184 * v129);
        const double v188 = v98 * v66;
        const double v189 = v188 * v129;
        const double v193 = v90 * v66;
        const double v195 = (((((v179 + (v180 * v126)) - v186) + v189) - v186) + v189) - (v193 * v21);
        const double v196 = v75 * v74;
        const double v197 = v196 * v154;
        const double v203 = v66 * v66;
        const double v204 = v46 * v143;
        const double v206 = ((v195 - (v57 * v197)) - ((v56 * v197) * v176)) - (v203 * v204);
        const double v207 = v61 * v60;
        const double v208 = c81 * v204;
        const double v209 = v207 * v208;
        const double v216 = v196 * v157;
        const double v218 = ((v206 - (v183 * (v57 * v209))) - ((v58 * v209) * v176)) - (v57 * v216);
        const double v222 = v46 * v148;
        const double v225 = c64 * v222;
        const double v226 = v207 * v225;
        const double v229 = ((v218 - ((v56 * v216) * v176)) - (v203 * v222)) - (v183 * (v57 * v226));
        const double v232 = v229 - ((v58 * v226) * v176);
        const double v234 = v46 * v133;
        const double v237 = (v234 - (v104 * v124)) + v234;
        const double v244 = (v21 * ((v16 * v232) - (v26 * v237))) - ((v21 * v104) + (v27 * v120));
        const double v251 = v10 * v131;
        const double v256 = v10 * v150;
        const double v258 = (((v36 * v131) + (v16 * v251)) + (v44 * v150)) - (v26 * v256);
        const double v260 = (v244 - (v27 * ((v16 * v237) + (v26 * v232)))) + (v21 * v258);
        const double v267 = (((v26 * v251) - (v44 * v131)) + (v36 * v150)) + (v16 * v256);
        const double v270 = 0.5 * (v260 - (v27 * v267));
        const double v277 = ((v117 * v124) + (0.75 * (v208 * v60))) + (0.75 * (v225 * v60));
        const double v278 = v51 * v277;
        const double v285 = (((v27 * v131) + (v21 * v150)) * v15) * c4;
        const double v291 = (((v27 * v150) - (v21 * v131)) * v15) * c4;
        const double v299 = (((v21 * v251) - (v27 * v237)) + (v21 * v232)) - (v27 * v256);
        const double v300 = v299 * v15;
        const double v308 = (((v27 * v251) + (v21 * v237)) + (v27 * v232)) + (v21 * v256);
        const double v309 = v308 * v15;
        const double v314 = v27 * v66;
        const double v316 = 1.5 * (v52 * v314);
        const double v318 = c109 * (v316 * v74);
        const double v320 = 0.5 * v314;
        const double v322 = c1 * ((0.28867513459481287 * v318) + v320);
        const double v325 = v21 - (v29 * v314);
        const double v328 = c92 * (0.5 * (v325 * v66));
        const double v329 = v328 * v100;
        const double v335 = c1 * (((-0.28867513459481287) * v318) + v320);
        const double v337 = ((v83 * v322) - (2.0 * (v29 * v329))) + (v67 * v335);
        const double v340 = 2.0 * (v328 * v66);
        const double v343 = 0.5 * ((v29 * v337) - (v56 * v340));
        const double v344 = c81 * v322;
        const double v347 = c64 * v335;
        const double v351 = v51 * (((-0.5) * (v344 * v74)) + ((-0.5) * (v347 * v74)));
        const double v360 = v46 * v329;
        const double v362 = ((v104 * v314) + v360) + v360;
        const double v366 = v170 * v316;
        const double v372 = (v166 * v27) - (((v168 * v27) + (v57 * v366)) + ((v56 * v366) * v176));
        const double v376 = v183 * (v184 * v328);
        const double v378 = v188 * v328;
        const double v383 = (((((v372 - (v180 * v325)) + v376) - v378) + v376) - v378) - (v193 * v27);
        const double v384 = v196 * v344;
        const double v390 = v46 * v322;
        const double v392 = ((v383 - (v57 * v384)) - ((v56 * v384) * v176)) - (v203 * v390);
        const double v393 = c81 * v390;
        const double v394 = v207 * v393;
        const double v401 = v196 * v347;
        const double v403 = ((v392 - (v183 * (v57 * v394))) - ((v58 * v394) * v176)) - (v57 * v401);
        const double v407 = v46 * v335;
        const double v410 = c64 * v407;
        const double v411 = v207 * v410;
        const double v414 = ((v403 - ((v56 * v401) * v176)) - (v203 * v407)) - (v183 * (v57 * v411));
        const double v417 = v414 - ((v58 * v411) * v176);
        const double v421 = ((v21 * v120) - (v27 * v104)) + (v21 * ((v26 * v362) + (v16 * v417)));
        const double v429 = v10 * v340;
        const double v433 = v10 * v337;
        const double v435 = ((v44 * v337) - ((v36 * v340) + (v16 * v429))) - (v26 * v433);
        const double v437 = (v421 - (v27 * ((v26 * v417) - (v16 * v362)))) + (v21 * v435);
        const double v444 = (((v44 * v340) - (v26 * v429)) + (v36 * v337)) + (v16 * v433);
        const double v447 = 0.5 * (v437 - (v27 * v444));
        const double v454 = ((v117 * v314) + (0.75 * (v393 * v60))) + (0.75 * (v410 * v60));
        const double v455 = v51 * v454;
        const double v462 = (((v21 * v337) - (v27 * v340)) * v15) * c4;
        const double v468 = (((v21 * v340) + (v27 * v337)) * v15) * c4;
        const double v476 = (((v27 * v362) - (v21 * v429)) + (v21 * v417)) - (v27 * v433);
        const double v477 = v476 * v15;
        const double v485 = ((v27 * v417) - ((v27 * v429) + (v21 * v362))) + (v21 * v433);
        const double v486 = v485 * v15;
        const double v488 = g[8 * i + 1] * c49;
        const double v493 = 0.5 * v488;
        const double v494 = v29 * v493;
        const double v495 = v494 * v66;
        const double v497 = 1.5 * (v52 * v495);
        const double v499 = c109 * (v497 * v74);
        const double v501 = 0.5 * v495;
        const double v503 = c1 * ((0.28867513459481287 * v499) + v501);
        const double v504 = c81 * v503;
        const double v509 = c1 * (((-0.28867513459481287) * v499) + v501);
        const double v510 = c64 * v509;
        const double v514 = v51 * (((-0.5) * (v504 * v74)) + ((-0.5) * (v510 * v74)));
        const double v518 = v29 * v495;
        const double v522 = c92 * (0.5 * (v493 + (v518 * v66)));
        const double v523 = v522 * v100;
        const double v524 = v29 * v523;
        const double v526 = (((v83 * v503) + (v67 * v509)) + v524) + v524;
        const double v529 = 2.0 * (v522 * v66);
        const double v532 = 0.5 * ((v29 * v526) + (v56 * v529));
        const double v539 = v46 * v503;
        const double v540 = c81 * v539;
        const double v544 = v46 * v509;
        const double v545 = c64 * v544;
        const double v548 = ((v117 * v495) + (0.75 * (v540 * v60))) + (0.75 * (v545 * v60));
        const double v549 = v51 * v548;
        const double v551 = v170 * v497;
        const double v558 = (((v168 * v494) + (v57 * v551)) + ((v56 * v551) * v176)) - (v166 * v494);
        const double v563 = v196 * v504;
        const double v568 = (((v558 - (v180 * v518)) + (v193 * v494)) + (v57 * v563)) + ((v56 * v563) * v176);
        const double v571 = v207 * v540;
        const double v577 = ((v568 + (v203 * v539)) + (v183 * (v57 * v571))) + ((v58 * v571) * v176);
        const double v578 = v196 * v510;
        const double v585 = ((v577 + (v57 * v578)) + ((v56 * v578) * v176)) + (v203 * v544);
        const double v586 = v207 * v545;
        const double v594 = v183 * (v184 * v522);
        const double v595 = ((v585 + (v183 * (v57 * v586))) + ((v58 * v586) * v176)) + v594;
        const double v596 = v188 * v522;
        const double v599 = ((v595 - v596) + v594) - v596;
        const double v604 = v46 * v523;
        const double v606 = (((v104 * v495) - (v120 * v493)) - v604) - v604;
        const double v614 = (v21 * ((v16 * v599) - (v26 * v606))) - (v27 * ((v16 * v606) + (v26 * v599)));
        const double v615 = v10 * v526;
        const double v621 = v10 * v529;
        const double v623 = (((v26 * v615) - (v44 * v526)) - (v36 * v529)) - (v16 * v621);
        const double v632 = (v44 * v529) - (((v36 * v526) + (v16 * v615)) + (v26 * v621));
        const double v635 = 0.5 * ((v614 + (v21 * v623)) - (v27 * v632));
        const double v642 = (((v21 * v526) + (v27 * v529)) * v15) * c4;
        const double v648 = (((v21 * v529) - (v27 * v526)) * v15) * c4;
        const double v656 = (((v27 * v615) - (v27 * v606)) + (v21 * v599)) - (v21 * v621);
        const double v657 = v656 * v15;
        const double v665 = (((v21 * v606) - (v21 * v615)) + (v27 * v599)) - (v27 * v621);
        const double v666 = v665 * v15;
        const double v669 = c109 * v74;
        const double v671 = c1 * (0.28867513459481287 * v669);
        const double v672 = c81 * v671;
        const double v676 = c1 * ((-0.28867513459481287) * v669);
        const double v677 = c64 * v676;
        const double v681 = v51 * (((-0.5) * (v672 * v74)) + ((-0.5) * (v677 * v74)));
        const double v684 = (v83 * v671) + (v67 * v676);
        const double v686 = 0.5 * (v29 * v684);
        const double v692 = v46 * v671;
        const double v693 = c81 * v692;
        const double v696 = v46 * v676;
        const double v697 = c64 * v696;
        const double v701 = v51 * ((0.75 * (v693 * v60)) + (0.75 * (v697 * v60)));
        const double v706 = v196 * v672;
        const double v711 = (((v57 * v170) + ((v56 * v170) * v176)) + (v57 * v706)) + ((v56 * v706) * v176);
        const double v714 = v207 * v693;
        const double v720 = ((v711 + (v203 * v692)) + (v183 * (v57 * v714))) + ((v58 * v714) * v176);
        const double v721 = v196 * v677;
        const double v728 = ((v720 + (v57 * v721)) + ((v56 * v721) * v176)) + (v203 * v696);
        const double v729 = v207 * v697;
        const double v735 = (v728 + (v183 * (v57 * v729))) + ((v58 * v729) * v176);
        const double v741 = v10 * v684;
        const double v746 = ((v21 * (v16 * v735)) - (v27 * (v26 * v735))) + (v21 * ((v26 * v741) - (v44 * v684)));
        const double v752 = 0.5 * (v746 + (v27 * ((v36 * v684) + (v16 * v741))));
        const double v757 = ((v21 * v684) * v15) * c4;
        const double v761 = ((v27 * v684) * v15) * c4;
        const double v766 = ((v21 * v735) + (v27 * v741)) * v15;
        const double v771 = ((v27 * v735) - (v21 * v741)) * v15;
        w6[i] = (v120 * v21) - (v104 * v27);
        w10[i] = (v153 - v161) * c4;
        w11[i] = (v161 + v153) * c4;
        w12[i] = v270 - v278;
        w13[i] = v278 + v270;
        w14[i] = -v285;
        w15[i] = v285;
        w16[i] = -v291;
        w17[i] = v291;
        w18[i] = -v300;
        w19[i] = v300;
        w20[i] = -v309;
        w21[i] = v309;
        w7[i] = (v120 * v27) + (v104 * v21);
        w22[i] = (v343 - v351) * c4;
        w23[i] = (v351 + v343) * c4;
        w24[i] = v447 - v455;
        w25[i] = v455 + v447;
        w26[i] = -v462;
        w27[i] = v462;
        w28[i] = -v468;
        w29[i] = v468;
        w30[i] = -v477;
        w31[i] = v477;
        w32[i] = -v486;
        w33[i] = v486;
        w8[i] = (v488 * (v103 - (v29 * v120))) * 0.5;
        w34[i] = (v514 - v532) * c4;
        w35[i] = -((v514 + v532) * c4);
        w36[i] = v549 + v635;
        w37[i] = v635 - v549;
        w38[i] = v642;
        w39[i] = -v642;
        w40[i] = -v648;
        w41[i] = v648;
        w42[i] = -v657;
        w43[i] = v657;
        w44[i] = -v666;
        w45[i] = v666;
        w9[i] = -v116;
        w46[i] = (v681 - v686) * c4;
        w47[i] = -((v681 + v686) * c4);
        w48[i] = v701 + v752;
        w49[i] = v752 - v701;
        w50[i] = v757;
        w51[i] = -v757;
        w52[i] = v761;
        w53[i] = -v761;
        w54[i] = -v766;
        w55[i] = v766;
        w56[i] = -v771;
        w57[i] = v771;
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
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
    const double c1 = squared(p[6]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const double c10 = p[5] / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v13 = c6 / (g[8 * i + 3] + (g[8 * i + 7] * c10));
        e[57 * i + 8] = -(v13 * w10[i - 1]);
        e[57 * i + 14] = (v13 * w10[i]) - (v13 * w11[i - 1]);
        e[57 * i + 20] = v13 * w11[i];
        e[57 * i + 5] = -(v13 * w12[i - 1]);
        e[57 * i + 11] = (v13 * w12[i]) - (v13 * w13[i - 1]);
        e[57 * i + 17] = v13 * w13[i];
        e[57 * i + 6] = -(v13 * w14[i - 1]);
        e[57 * i + 12] = (v13 * w14[i]) - (v13 * w15[i - 1]);
        e[57 * i + 18] = v13 * w15[i];
        e[57 * i + 7] = -(v13 * w16[i - 1]);
        e[57 * i + 13] = (v13 * w16[i]) - (v13 * w17[i - 1]);
        e[57 * i + 19] = v13 * w17[i];
        e[57 * i + 3] = -(v13 * w18[i - 1]);
        e[57 * i + 9] = (v13 * w18[i]) - (v13 * w19[i - 1]);
        e[57 * i + 15] = v13 * w19[i];
        e[57 * i + 4] = -(v13 * w20[i - 1]);
        e[57 * i + 10] = (v13 * w20[i]) - (v13 * w21[i - 1]);
        e[57 * i + 16] = v13 * w21[i];
    }
}

static void jacobian_10(int n, const double *p, const double *g, double *w, double *e)
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
    const double c1 = squared(p[6]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c10 = p[5] / c5;
    const double c75 = 0.08333333333333333 * c4;
    const double c77 = squared(p[1]);
    const double c78 = c75 * c77;
    const double c79 = c78 * c2;
    const double c80 = c1 / c79;
    const double c84 = squared(c2);
    const double c85 = c4 * c84;
    const double c86 = c78 / c85;
    for (int i = 1; i < n - 1; i++) {
        const double v13 = c6 / (g[8 * i + 3] + (g[8 * i + 7] * c10));
        const double v87 = (c80 * g[8 * i + 5]) * c86;
        const double v100 = ((v87 * w46[i]) - (v87 * w47[i - 1])) + (v87 * w35[i - 1]);
        const double v121 = ((v87 * w48[i]) - (v87 * w49[i - 1])) + (v87 * w37[i - 1]);
        const double v142 = ((v87 * w50[i]) - (v87 * w51[i - 1])) + (v87 * w39[i - 1]);
        const double v163 = ((v87 * w52[i]) - (v87 * w53[i - 1])) + (v87 * w41[i - 1]);
        const double v184 = ((v87 * w54[i]) - (v87 * w55[i - 1])) + (v87 * w43[i - 1]);
        const double v205 = ((v87 * w56[i]) - (v87 * w57[i - 1])) + (v87 * w45[i - 1]);
        e[57 * i + 26] = -(v13 * w22[i - 1]);
        e[57 * i + 32] = (v13 * w22[i]) - (v13 * w23[i - 1]);
        e[57 * i + 38] = v13 * w23[i];
        e[57 * i + 23] = -(v13 * w24[i - 1]);
        e[57 * i + 29] = (v13 * w24[i]) - (v13 * w25[i - 1]);
        e[57 * i + 35] = v13 * w25[i];
        e[57 * i + 24] = -(v13 * w26[i - 1]);
        e[57 * i + 30] = (v13 * w26[i]) - (v13 * w27[i - 1]);
        e[57 * i + 36] = v13 * w27[i];
        e[57 * i + 25] = -(v13 * w28[i - 1]);
        e[57 * i + 31] = (v13 * w28[i]) - (v13 * w29[i - 1]);
        e[57 * i + 37] = v13 * w29[i];
        e[57 * i + 21] = -(v13 * w30[i - 1]);
        e[57 * i + 27] = (v13 * w30[i]) - (v13 * w31[i - 1]);
        e[57 * i + 33] = v13 * w31[i];
        e[57 * i + 22] = -(v13 * w32[i - 1]);
        e[57 * i + 28] = (v13 * w32[i]) - (v13 * w33[i - 1]);
        e[57 * i + 34] = v13 * w33[i];
        e[57 * i + 44] = (v87 * w34[i - 1]) - (v87 * w46[i - 1]);
        e[57 * i + 50] = v100 + (v87 * w34[i]);
        e[57 * i + 56] = (v87 * w47[i]) + (v87 * w35[i]);
        e[57 * i + 41] = (v87 * w36[i - 1]) - (v87 * w48[i - 1]);
        e[57 * i + 47] = v121 + (v87 * w36[i]);
        e[57 * i + 53] = (v87 * w49[i]) + (v87 * w37[i]);
        e[57 * i + 42] = (v87 * w38[i - 1]) - (v87 * w50[i - 1]);
        e[57 * i + 48] = v142 + (v87 * w38[i]);
        e[57 * i + 54] = (v87 * w51[i]) + (v87 * w39[i]);
        e[57 * i + 43] = (v87 * w40[i - 1]) - (v87 * w52[i - 1]);
        e[57 * i + 49] = v163 + (v87 * w40[i]);
        e[57 * i + 55] = (v87 * w53[i]) + (v87 * w41[i]);
        e[57 * i + 39] = (v87 * w42[i - 1]) - (v87 * w54[i - 1]);
        e[57 * i + 45] = v184 + (v87 * w42[i]);
        e[57 * i + 51] = (v87 * w55[i]) + (v87 * w43[i]);
        e[57 * i + 40] = (v87 * w44[i - 1]) - (v87 * w56[i - 1]);
        e[57 * i + 46] = v205 + (v87 * w44[i]);
        e[57 * i + 52] = (v87 * w57[i]) + (v87 * w45[i]);
    }
}

static void jacobian_11(int n, const double *p, const double *g, double *w, double *e)
{
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
    const double c1 = p[2];
    const double c2 = 0.08333333333333333 * c1;
    const double c4 = squared(p[1]);
    const double c5 = c2 * c4;
    const double c6 = p[0];
    const double c7 = squared(c6);
    const double c8 = c1 * c7;
    const double c9 = c5 / c8;
    const double c11 = squared(p[6]);
    const double c12 = c5 * c6;
    const double c13 = c11 / c12;
    const int i = n - 1;
    const double v17 = c9 * (c13 * g[8 * i + 5]);
    e[57 * i + 44] = (v17 * w34[i - 1]) - (v17 * w46[i - 1]);
    e[57 * i + 50] = (v17 * w35[i - 1]) - (v17 * w47[i - 1]);
    e[57 * i + 41] = (v17 * w36[i - 1]) - (v17 * w48[i - 1]);
    e[57 * i + 47] = (v17 * w37[i - 1]) - (v17 * w49[i - 1]);
    e[57 * i + 42] = (v17 * w38[i - 1]) - (v17 * w50[i - 1]);
    e[57 * i + 48] = (v17 * w39[i - 1]) - (v17 * w51[i - 1]);
    e[57 * i + 43] = (v17 * w40[i - 1]) - (v17 * w52[i - 1]);
    e[57 * i + 49] = (v17 * w41[i - 1]) - (v17 * w53[i - 1]);
    e[57 * i + 39] = (v17 * w42[i - 1]) - (v17 * w54[i - 1]);
    e[57 * i + 45] = (v17 * w43[i - 1]) - (v17 * w55[i - 1]);
    e[57 * i + 40] = (v17 * w44[i - 1]) - (v17 * w56[i - 1]);
    e[57 * i + 46] = (v17 * w45[i - 1]) - (v17 * w57[i - 1]);
    (void)n;
}

static void jacobian_12(int n, const double *p, const double *g, double *w, double *e)
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
    const double c1 = squared(p[6]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const double c10 = p[5] / c5;
    const int i = 0;
    const double v13 = c6 / (g[8 * i + 3] + (g[8 * i + 7] * c10));
    e[57 * i + 32] = v13 * w22[i];
    e[57 * i + 38] = v13 * w23[i];
    e[57 * i + 29] = v13 * w24[i];
    e[57 * i + 35] = v13 * w25[i];
    e[57 * i + 30] = v13 * w26[i];
    e[57 * i + 36] = v13 * w27[i];
    e[57 * i + 31] = v13 * w28[i];
    e[57 * i + 37] = v13 * w29[i];
    e[57 * i + 27] = v13 * w30[i];
    e[57 * i + 33] = v13 * w31[i];
    e[57 * i + 28] = v13 * w32[i];
    e[57 * i + 34] = v13 * w33[i];
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
    const double c2 = p[4];
    const double c4 = p[6];
    const double c5 = 1.0 / c4;
    const double c49 = p[0];
    const double c50 = 1.0 / c49;
    const double c62 = p[1];
    const double c63 = (-0.5773502691896257) * c62;
    const double c78 = 1.0 / c2;
    const double c81 = 3.6 / c2;
    const double c83 = 0.2777777777777778 * c2;
    const double c99 = 0.5773502691896257 * c62;
    const double c113 = c49 / c4;
    const double c114 = squared(c113);
    const double c115 = p[2] * c114;
    const double c116 = c4 / c115;
    for (int i = 0; i < n - 1; i++) {
        const double v6 = w5[i] * c5;
        const double v8 = w5[i + 1] * c5;
        const double v11 = (v6 + v8) * 0.5;
        const double v15 = g[8 * i + 4];
        const double v16 = (w2[i + 1] - w2[i]) * v15;
        const double v17 = w4[i];
        const double v18 = w4[i + 1];
        const double v20 = (v17 + v18) * 0.5;
        const double v21 = cos(v20);
        const double v26 = (w0[i + 1] - w0[i]) * v15;
        const double v27 = sin(v20);
        const double v29 = (v16 * v21) - (v26 * v27);
        const double v36 = ((w1[i + 1] * c5) - (w1[i] * c5)) * v15;
        const double v44 = ((w3[i + 1] * c5) - (w3[i] * c5)) * v15;
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
        const double v107 = squared((c2 * ((v46 * ((v60 * c99) + v65)) + (v73 * c99)))) * c78;
        const double v111 = g[8 * i + 1] * ((0.5 * (v79 + v95)) + (0.5 * (v107 + v95)));
        q[0] += v111 * c116;
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
    const double c38 = 0.5773502691896257 * c37;
    const double c42 = p[4];
    const double c44 = p[6];
    const double c45 = 1.0 / c44;
    const double c81 = c23 / c44;
    const double c82 = squared(c81);
    const double c83 = p[2] * c82;
    const double c84 = c44 / c83;
    const double c87 = 1.0 / c42;
    const double c93 = 0.2777777777777778 * c42;
    const double c107 = 3.6 / c42;
    const double c116 = (-0.5773502691896257) * c37;
    for (int i = 0; i < n - 1; i++) {
        const double v5 = g[8 * i + 4];
        const double v6 = (w2[i + 1] - w2[i]) * v5;
        const double v7 = w4[i];
        const double v8 = w4[i + 1];
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
        const double v57 = ((w1[i + 1] * c45) - (w1[i] * c45)) * v5;
        const double v65 = ((w3[i + 1] * c45) - (w3[i] * c45)) * v5;
        const double v67 = ((v50 * v20) + (v57 * v12)) + (v65 * v18);
        const double v74 = 1.0 / (v31 * v30);
        const double v75 = ((-0.5) * ((v48 - v46) * v25)) * v74;
        const double v86 = 0.5 * (g[8 * i + 1] * c84);
        const double v88 = v86 * c87;
        const double v90 = c42 * ((2.0 * (c42 * ((v67 * v41) + (v75 * c38)))) * v88);
        const double v99 = (((v65 * v12) - (v50 * v30)) - (v57 * v18)) * v40;
        const double v101 = 1.0 / v32;
        const double v102 = (v20 * v67) * v101;
        const double v110 = c93 * ((2.0 * (c93 * (v99 - v102))) * (c107 * v86));
        const double v111 = v110 * v101;
        const double v112 = v20 * v111;
        const double v118 = (v35 * c116) + v40;
        const double v125 = c42 * ((2.0 * (c42 * ((v67 * v118) + (v75 * c116)))) * v88);
        const double v127 = (((v41 * v90) - v112) - v112) + (v118 * v125);
        const double v130 = 2.0 * (v110 * v40);
        const double v133 = 0.5 * ((v20 * v127) - (v30 * v130));
        const double v134 = c38 * v90;
        const double v137 = c116 * v125;
        const double v141 = v25 * (((-0.5) * (v134 * v74)) + ((-0.5) * (v137 * v74)));
        const double v147 = 2.0 * (v67 * v111);
        const double v149 = 2.0 * v30;
        const double v152 = v149 * ((v102 * v101) * v110);
        const double v154 = (v99 * v40) * v110;
        const double v156 = v75 * v74;
        const double v157 = v156 * v134;
        const double v162 = 1.0 / (2.0 * v31);
        const double v165 = v40 * v40;
        const double v166 = v67 * v90;
        const double v168 = (((v152 - v154) - (v31 * v157)) - ((v30 * v157) * v162)) - (v165 * v166);
        const double v169 = v35 * v34;
        const double v170 = c38 * v166;
        const double v171 = v169 * v170;
        const double v178 = ((v168 - (v149 * (v31 * v171))) - ((v32 * v171) * v162)) + v152;
        const double v180 = v156 * v137;
        const double v186 = v67 * v125;
        const double v188 = (((v178 - v154) - (v31 * v180)) - ((v30 * v180) * v162)) - (v165 * v186);
        const double v189 = c116 * v186;
        const double v190 = v169 * v189;
        const double v196 = (v188 - (v149 * (v31 * v190))) - ((v32 * v190) * v162);
        const double v204 = (v12 * ((v17 * v147) + (v6 * v196))) - (v18 * ((v17 * v196) - (v6 * v147)));
        const double v207 = v50 * v130;
        const double v211 = v50 * v127;
        const double v213 = ((v65 * v127) - ((v57 * v130) + (v6 * v207))) - (v17 * v211);
        const double v222 = (((v65 * v130) - (v17 * v207)) + (v57 * v127)) + (v6 * v211);
        const double v225 = 0.5 * ((v204 + (v12 * v213)) - (v18 * v222));
        const double v231 = v25 * ((0.75 * (v170 * v34)) + (0.75 * (v189 * v34)));
        const double v238 = (((v12 * v127) - (v18 * v130)) * v5) * c45;
        const double v244 = (((v12 * v130) + (v18 * v127)) * v5) * c45;
        const double v252 = (((v18 * v147) - (v12 * v207)) + (v12 * v196)) - (v18 * v211);
        const double v253 = v252 * v5;
        const double v261 = ((v18 * v196) - ((v12 * v147) + (v18 * v207))) + (v12 * v211);
        const double v262 = v261 * v5;
        s[6 * i + 5] += (v133 - v141) * c45;
        s[6 * i + 11] += (v141 + v133) * c45;
        s[6 * i + 2] += v225 - v231;
        s[6 * i + 8] += v231 + v225;
        s[6 * i + 3] += -v238;
        s[6 * i + 9] += v238;
        s[6 * i + 4] += -v244;
        s[6 * i + 10] += v244;
        s[6 * i] += -v253;
        s[6 * i + 6] += v253;
        s[6 * i + 1] += -v262;
        s[6 * i + 7] += v262;
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
    rates_1(n, y, f);
    rates_2(n, y, f);
    rates_3(n, y, w);
    rates_4(n, y, w);
    rates_5(n, y, w);
    rates_6(n, w);
    rates_7(n, g, w);
    rates_8(n, p, g, w);
    rates_9(n, p, g, w, f);
    rates_10(n, p, g, w, f);
    rates_11(n, p, g, w, f);
    rates_12(n, p, g, w, f);
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
    jacobian_2(n, e);
    jacobian_3(n, y, w);
    jacobian_4(n, y, w);
    jacobian_5(n, y, w);
    jacobian_6(n, w);
    jacobian_7(n, g, w);
    jacobian_8(n, p, g, w);
    jacobian_9(n, p, g, w, e);
    jacobian_10(n, p, g, w, e);
    jacobian_11(n, p, g, w, e);
    jacobian_12(n, p, g, w, e);
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

static const int rate[] = {3, 4, 5, -1, -1, -1};
static const int differential[] = {1, 1, 1, 0, 0, 0};
static const int held_first[] = {1, 0, 1, 1, 0, 1};
static const int held_last[] = {1, 1, 0, 1, 1, 0};
static const int row[] = {0, 1, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
static const int offset[] = {0, 0, 0, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
static const int column[] = {3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5};

const softcat_model softcat_filament_model = {
    6, 0, 7, 8, 58, 57, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "viscosity", "point_mass_per_area",
    "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "Pa*s", "kg/m^2", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.05, 0.003, 2500.0, 9.81, 9600000000000.0, 2222.222222222222, 0.07139215614635322};
static const char *const described_slots[] = {
    "x", "y", "psi", "u", "v", "omega"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS, SOFTCAT_PLACE_HUNG};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 0};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Glass bar with a weight in a beam-bending viscometer",
    .parameter_names = described_parameters,
    .parameter_units = described_units,
    .parameter_ranges = described_ranges,
    .parameter_values = described_values,
    .slot_names = described_slots,
    .on_cells = described_on_cells,
    .mean = described_mean,
    .bending = described_bending,
    .first = SOFTCAT_SYMMETRY,
    .last = SOFTCAT_PINNED,
    .least_cells = 4,
    .area_power = 1,
    .profiled = 0,
    .places = described_places,
    .x = 0,
    .y = 1,
    .psi = 2,
    .rest_length = 0,
    .time_scale = 6,
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
    .grading = 1.0,
    .relative = 3e-05,
    .absolute = 5.251312949582929e-09,
    .towards_middle = 0,
    .duration = 3600.0,
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
