/*
 * Plastic sheet that droops in a thermoforming oven
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, gravity-ramp, shear
 * Digest of the structure: e3ac10a586635bf957fcb9b080db48f70ecb0911e208d3f296acfc6fdaf50ed3
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
    const double c3 = p[7];
    const double c4 = squared(c3);
    const double c5 = 1.0 - c4;
    const double c6 = c1 / c5;
    const double c9 = p[1];
    const double c10 = (-0.5) * c9;
    const double c16 = p[0];
    const double c17 = 1.0 / c16;
    const double c62 = 0.8333333333333334 * c1;
    const double c63 = 2.0 * c3;
    const double c64 = 2.0 + c63;
    const double c65 = c62 / c64;
    const double c80 = 0.5 * c9;
    const double c105 = p[6];
    const double c106 = 0.75 / c105;
    const double c108 = p[8];
    const double c113 = 3.0 / c105;
    for (int i = 0; i < n - 1; i++) {
        const double v11 = w1[i + 1];
        const double v12 = w1[i];
        const double v15 = g[7 * i + 4];
        const double v19 = (v11 - v12) * (v15 * c17);
        const double v20 = c10 * v19;
        const double v25 = (w0[i + 1] - w0[i]) * v15;
        const double v28 = (v12 + v11) * 0.5;
        const double v29 = cos(v28);
        const double v34 = (w2[i + 1] - w2[i]) * v15;
        const double v35 = sin(v28);
        const double v37 = (v25 * v29) + (v34 * v35);
        const double v39 = 1.0 / squared(v37);
        const double v43 = log(v37);
        const double v44 = ((((-0.5773502691896257) * v20) * v39) - y[9 * i + 5]) + v43;
        const double v45 = c6 * v44;
        const double v53 = c6 * ((((0.5773502691896257 * v20) * v39) - y[9 * i + 6]) + v43);
        const double v56 = 1.0 / v37;
        const double v60 = (v34 * v29) - (v25 * v35);
        const double v66 = v60 * v56;
        const double v69 = c65 * (v66 - y[9 * i + 7]);
        const double v73 = c65 * (v66 - y[9 * i + 8]);
        const double v75 = (0.5 * v69) + (0.5 * v73);
        const double v76 = v75 * v56;
        const double v85 = ((-0.28867513459481287) * v45) + (0.28867513459481287 * v53);
        const double v87 = (c80 * v85) * v39;
        const double v91 = ((((0.5 * v45) + (0.5 * v53)) * v56) - ((v60 * v76) * v56)) + (((2.0 * v87) * v19) * v56);
        w3[i] = (v91 * v29) - (v76 * v35);
        w4[i] = (v91 * v35) + (v76 * v29);
        w5[i] = ((g[7 * i + 1] * c16) * (v75 - (v60 * v91))) * 0.5;
        w6[i] = -v87;
        f[9 * i + 5] = (c106 * v45) * c108;
        f[9 * i + 6] = (c106 * v53) * c108;
        f[9 * i + 7] = (c113 * v69) * c108;
        f[9 * i + 8] = (c113 * v73) * c108;
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
    const double c3 = p[8];
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
    const double c1 = p[8];
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
    const double c3 = p[7];
    const double c4 = squared(c3);
    const double c5 = 1.0 - c4;
    const double c6 = c1 / c5;
    const double c9 = p[1];
    const double c10 = (-0.5) * c9;
    const double c16 = p[0];
    const double c17 = 1.0 / c16;
    const double c62 = 0.8333333333333334 * c1;
    const double c63 = 2.0 * c3;
    const double c64 = 2.0 + c63;
    const double c65 = c62 / c64;
    const double c80 = 0.5 * c9;
    const double c95 = (-0.28867513459481287) * c6;
    const double c96 = c80 * c95;
    const double c102 = 0.5 * c6;
    const double c106 = 0.28867513459481287 * c6;
    const double c107 = c80 * c106;
    const double c216 = 0.5 * c65;
    const double c456 = p[8];
    const double c458 = p[6];
    const double c459 = 0.75 / c458;
    const double c460 = c459 * c6;
    const double c461 = c456 * c460;
    const double c462 = -c461;
    const double c488 = 3.0 / c458;
    const double c492 = c488 * c65;
    const double c493 = c456 * c492;
    const double c494 = -c493;
    for (int i = 0; i < n - 1; i++) {
        const double v11 = w1[i + 1];
        const double v12 = w1[i];
        const double v15 = g[7 * i + 4];
        const double v18 = v15 * c17;
        const double v19 = (v11 - v12) * v18;
        const double v20 = c10 * v19;
        const double v25 = (w0[i + 1] - w0[i]) * v15;
        const double v28 = (v12 + v11) * 0.5;
        const double v29 = cos(v28);
        const double v34 = (w2[i + 1] - w2[i]) * v15;
        const double v35 = sin(v28);
        const double v37 = (v25 * v29) + (v34 * v35);
        const double v39 = 1.0 / squared(v37);
        const double v40 = ((-0.5773502691896257) * v20) * v39;
        const double v43 = log(v37);
        const double v45 = c6 * ((v40 - y[9 * i + 5]) + v43);
        const double v49 = (0.5773502691896257 * v20) * v39;
        const double v53 = c6 * ((v49 - y[9 * i + 6]) + v43);
        const double v56 = 1.0 / v37;
        const double v57 = ((0.5 * v45) + (0.5 * v53)) * v56;
        const double v60 = (v34 * v29) - (v25 * v35);
        const double v66 = v60 * v56;
        const double v75 = (0.5 * (c65 * (v66 - y[9 * i + 7]))) + (0.5 * (c65 * (v66 - y[9 * i + 8])));
        const double v76 = v75 * v56;
        const double v78 = (v60 * v76) * v56;
        const double v85 = ((-0.28867513459481287) * v45) + (0.28867513459481287 * v53);
        const double v87 = (c80 * v85) * v39;
        const double v88 = 2.0 * v87;
        const double v90 = (v88 * v19) * v56;
        const double v91 = (v57 - v78) + v90;
        const double v97 = c96 * v39;
        const double v103 = c102 * v56;
        const double v104 = ((v19 * (2.0 * (-v97))) * v56) - v103;
        const double v108 = c107 * v39;
        const double v113 = ((v19 * (2.0 * (-v108))) * v56) - v103;
        const double v115 = 0.5 * v29;
        const double v117 = 0.5 * v35;
        const double v119 = (v34 * v115) - (v25 * v117);
        const double v120 = v119 * v56;
        const double v121 = c10 * v18;
        const double v123 = ((-0.5773502691896257) * v121) * v39;
        const double v124 = v40 * v39;
        const double v125 = 2.0 * v37;
        const double v126 = v125 * v119;
        const double v127 = v124 * v126;
        const double v130 = c6 * (v120 - (v123 + v127));
        const double v133 = (0.5773502691896257 * v121) * v39;
        const double v134 = v49 * v39;
        const double v135 = v134 * v126;
        const double v138 = c6 * (v120 - (v133 + v135));
        const double v142 = v57 * v56;
        const double v143 = v142 * v119;
        const double v147 = (v34 * v117) + (v25 * v115);
        const double v150 = v66 * v56;
        const double v153 = c65 * ((v147 * v56) + (v150 * v119));
        const double v155 = v76 * v56;
        const double v157 = (v153 * v56) + (v155 * v119);
        const double v161 = v78 * v56;
        const double v163 = (((v76 * v147) + (v60 * v157)) * v56) + (v161 * v119);
        const double v167 = ((-0.28867513459481287) * v130) + (0.28867513459481287 * v138);
        const double v170 = v87 * v39;
        const double v171 = v170 * v126;
        const double v172 = ((c80 * v167) * v39) - v171;
        const double v175 = v88 * v18;
        const double v178 = v90 * v56;
        const double v179 = v178 * v119;
        const double v181 = (((((0.5 * v130) + (0.5 * v138)) * v56) - v143) + v163) + ((((v19 * (2.0 * v172)) - v175) * v56) - v179);
        const double v183 = v91 * v117;
        const double v187 = (v76 * v115) - (v35 * v157);
        const double v191 = c6 * ((v123 - v127) + v120);
        const double v195 = c6 * ((v133 - v135) + v120);
        const double v203 = ((-0.28867513459481287) * v191) + (0.28867513459481287 * v195);
        const double v206 = ((c80 * v203) * v39) - v171;
        const double v212 = (((((0.5 * v191) + (0.5 * v195)) * v56) - v143) + v163) + ((((v19 * (2.0 * v206)) + v175) * v56) - v179);
        const double v217 = c216 * v56;
        const double v219 = (v60 * v217) * v56;
        const double v222 = (v29 * v219) + (v35 * v217);
        const double v223 = v29 * v15;
        const double v224 = v125 * v223;
        const double v225 = v124 * v224;
        const double v226 = v223 * v56;
        const double v228 = c6 * (v225 - v226);
        const double v230 = v134 * v224;
        const double v232 = c6 * (v230 - v226);
        const double v236 = v142 * v223;
        const double v238 = v35 * v15;
        const double v240 = v238 * v56;
        const double v243 = c65 * (v240 + (v150 * v223));
        const double v246 = (v243 * v56) + (v155 * v223);
        const double v251 = (((v76 * v238) + (v60 * v246)) * v56) + (v161 * v223);
        const double v255 = ((-0.28867513459481287) * v228) + (0.28867513459481287 * v232);
        const double v258 = v170 * v224;
        const double v259 = ((c80 * v255) * v39) + v258;
        const double v263 = v178 * v223;
        const double v265 = (((((0.5 * v228) + (0.5 * v232)) * v56) + v236) - v251) + (((v19 * (2.0 * v259)) * v56) + v263);
        const double v267 = v35 * v246;
        const double v270 = c6 * (v226 - v225);
        const double v273 = c6 * (v226 - v230);
        const double v281 = ((-0.28867513459481287) * v270) + (0.28867513459481287 * v273);
        const double v284 = ((c80 * v281) * v39) - v258;
        const double v289 = (((((0.5 * v270) + (0.5 * v273)) * v56) - v236) + v251) + (((v19 * (2.0 * v284)) * v56) - v263);
        const double v292 = v125 * v238;
        const double v293 = v124 * v292;
        const double v295 = c6 * (v293 - v240);
        const double v297 = v134 * v292;
        const double v299 = c6 * (v297 - v240);
        const double v303 = v142 * v238;
        const double v305 = v150 * v238;
        const double v307 = c65 * (v305 - v226);
        const double v309 = v155 * v238;
        const double v310 = (v307 * v56) + v309;
        const double v312 = v76 * v223;
        const double v315 = v161 * v238;
        const double v317 = ((((0.5 * v295) + (0.5 * v299)) * v56) + v303) - ((((v60 * v310) - v312) * v56) + v315);
        const double v320 = ((-0.28867513459481287) * v295) + (0.28867513459481287 * v299);
        const double v323 = v170 * v292;
        const double v324 = ((c80 * v320) * v39) + v323;
        const double v328 = v178 * v238;
        const double v330 = v317 + (((v19 * (2.0 * v324)) * v56) + v328);
        const double v335 = c6 * (v240 - v293);
        const double v338 = c6 * (v240 - v297);
        const double v344 = c65 * (v226 - v305);
        const double v346 = (v344 * v56) - v309;
        const double v351 = ((((0.5 * v335) + (0.5 * v338)) * v56) - v303) - (((v312 + (v60 * v346)) * v56) - v315);
        const double v354 = ((-0.28867513459481287) * v335) + (0.28867513459481287 * v338);
        const double v357 = ((c80 * v354) * v39) - v323;
        const double v362 = v351 + (((v19 * (2.0 * v357)) * v56) - v328);
        const double v372 = v91 * v115;
        const double v376 = (v29 * v157) + (v76 * v117);
        const double v383 = (v35 * v219) - (v29 * v217);
        const double v385 = v29 * v246;
        const double v395 = g[7 * i + 1] * c16;
        const double v409 = v91 * v147;
        const double v425 = -(0.5 * (v395 * (c216 + (v60 * v219))));
        const double v426 = v91 * v238;
        const double v439 = v91 * v223;
        const double v491 = -(c456 * (c488 * v153));
        const double v496 = c456 * (c488 * v243);
        const double v497 = -v496;
        const double v499 = c456 * (c488 * v307);
        const double v501 = c456 * (c488 * v344);
        w3[i] = (v91 * v29) - (v76 * v35);
        w7[i] = v29 * v104;
        w8[i] = v29 * v113;
        w9[i] = ((v29 * v181) - v183) - v187;
        w10[i] = ((v29 * v212) - v183) - v187;
        w11[i] = v222;
        w12[i] = v222;
        w13[i] = (v29 * v265) - v267;
        w14[i] = (v29 * v289) + v267;
        w15[i] = (v29 * v330) - (v35 * v310);
        w16[i] = (v29 * v362) - (v35 * v346);
        w4[i] = (v91 * v35) + (v76 * v29);
        w17[i] = v35 * v104;
        w18[i] = v35 * v113;
        w19[i] = ((v35 * v181) + v372) - v376;
        w20[i] = ((v35 * v212) + v372) - v376;
        w21[i] = v383;
        w22[i] = v383;
        w23[i] = (v35 * v265) + v385;
        w24[i] = (v35 * v289) - v385;
        w25[i] = (v35 * v330) + (v29 * v310);
        w26[i] = (v35 * v362) + (v29 * v346);
        w5[i] = (v395 * (v75 - (v60 * v91))) * 0.5;
        w27[i] = -(0.5 * (v395 * (v60 * v104)));
        w28[i] = -(0.5 * (v395 * (v60 * v113)));
        w29[i] = -(0.5 * (v395 * (v153 + ((v60 * v181) - v409))));
        w30[i] = -(0.5 * (v395 * (v153 + ((v60 * v212) - v409))));
        w31[i] = v425;
        w32[i] = v425;
        w33[i] = 0.5 * (v395 * (v243 - (v426 + (v60 * v265))));
        w34[i] = -(0.5 * (v395 * (v243 + ((v60 * v289) - v426))));
        w35[i] = 0.5 * (v395 * (v307 - ((v60 * v330) - v439)));
        w36[i] = 0.5 * (v395 * (v344 - (v439 + (v60 * v362))));
        w6[i] = -v87;
        w37[i] = v97;
        w38[i] = v108;
        w39[i] = -v172;
        w40[i] = -v206;
        w41[i] = -v259;
        w42[i] = -v284;
        w43[i] = -v324;
        w44[i] = -v357;
        e[81 * i + 56] = c462;
        e[81 * i + 55] = c456 * (c459 * v130);
        e[81 * i + 59] = c456 * (c459 * v191);
        e[81 * i + 53] = c456 * (c459 * v228);
        e[81 * i + 57] = c456 * (c459 * v270);
        e[81 * i + 54] = c456 * (c459 * v295);
        e[81 * i + 58] = c456 * (c459 * v335);
        e[81 * i + 63] = c462;
        e[81 * i + 62] = c456 * (c459 * v138);
        e[81 * i + 66] = c456 * (c459 * v195);
        e[81 * i + 60] = c456 * (c459 * v232);
        e[81 * i + 64] = c456 * (c459 * v273);
        e[81 * i + 61] = c456 * (c459 * v299);
        e[81 * i + 65] = c456 * (c459 * v338);
        e[81 * i + 69] = v491;
        e[81 * i + 73] = v491;
        e[81 * i + 70] = c494;
        e[81 * i + 67] = v496;
        e[81 * i + 71] = v497;
        e[81 * i + 68] = v499;
        e[81 * i + 72] = v501;
        e[81 * i + 76] = v491;
        e[81 * i + 80] = v491;
        e[81 * i + 77] = c494;
        e[81 * i + 74] = v496;
        e[81 * i + 78] = v497;
        e[81 * i + 75] = v499;
        e[81 * i + 79] = v501;
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
    const double c1 = squared(p[8]);
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
    const double c1 = squared(p[8]);
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
    const double c1 = squared(p[8]);
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
    const double c4 = p[5];
    const double c5 = 0.8333333333333334 * c4;
    const double c7 = p[7];
    const double c8 = 2.0 * c7;
    const double c9 = 2.0 + c8;
    const double c10 = c5 / c9;
    const double c40 = squared(c7);
    const double c41 = 1.0 - c40;
    const double c42 = c4 / c41;
    const double c46 = (-0.5) * p[1];
    const double c48 = p[0];
    const double c49 = 1.0 / c48;
    const double c66 = 1e-12 * c4;
    const double c67 = squared(c66);
    const double c70 = 1.0 / p[6];
    const double c93 = p[8];
    const double c95 = c48 / c93;
    const double c96 = squared(c95);
    const double c97 = p[2] * c96;
    const double c98 = c93 / c97;
    for (int i = 0; i < n - 1; i++) {
        const double v14 = g[7 * i + 4];
        const double v15 = (w2[i + 1] - w2[i]) * v14;
        const double v16 = w1[i];
        const double v17 = w1[i + 1];
        const double v19 = (v16 + v17) * 0.5;
        const double v20 = cos(v19);
        const double v25 = (w0[i + 1] - w0[i]) * v14;
        const double v26 = sin(v19);
        const double v31 = (v25 * v20) + (v15 * v26);
        const double v32 = ((v15 * v20) - (v25 * v26)) / v31;
        const double v52 = c46 * ((v17 - v16) * (v14 * c49));
        const double v55 = 1.0 / squared(v31);
        const double v59 = log(v31);
        const double v60 = ((((-0.5773502691896257) * v52) * v55) - y[9 * i + 5]) + v59;
        const double v64 = (3.0 * squared((c10 * (v32 - y[9 * i + 7])))) + (0.75 * squared((c42 * v60)));
        const double v84 = c42 * ((((0.5773502691896257 * v52) * v55) - y[9 * i + 6]) + v59);
        const double v87 = (3.0 * squared((c10 * (v32 - y[9 * i + 8])))) + (0.75 * squared(v84));
        const double v91 = (0.5 * (larger(v64, c67) * c70)) + (0.5 * (larger(v87, c67) * c70));
        q[0] += (g[7 * i + 1] * v91) * c98;
    }
}

static void work_1(int n, double t, const double *p, const double *g, double *w, double *q)
{
    double *restrict w2 = w + 2 * n;
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = 30.0 * p[3];
    const double c10 = p[8];
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
    const double c2 = p[7];
    const double c3 = squared(c2);
    const double c4 = 1.0 - c3;
    const double c5 = c0 / c4;
    const double c9 = (-0.5) * p[1];
    const double c15 = p[0];
    const double c16 = 1.0 / c15;
    const double c49 = 1e-12 * c0;
    const double c50 = squared(c49);
    const double c53 = 0.8333333333333334 * c0;
    const double c54 = 2.0 * c2;
    const double c55 = 2.0 + c54;
    const double c56 = c53 / c55;
    const double c74 = p[8];
    const double c76 = c15 / c74;
    const double c77 = squared(c76);
    const double c78 = p[2] * c77;
    const double c79 = c74 / c78;
    const double c83 = 1.0 / p[6];
    for (int i = 0; i < n - 1; i++) {
        const double v10 = w1[i + 1];
        const double v11 = w1[i];
        const double v14 = g[7 * i + 4];
        const double v17 = v14 * c16;
        const double v19 = c9 * ((v10 - v11) * v17);
        const double v24 = (w0[i + 1] - w0[i]) * v14;
        const double v28 = (v11 + v10) * 0.5;
        const double v29 = cos(v28);
        const double v34 = (w2[i + 1] - w2[i]) * v14;
        const double v35 = sin(v28);
        const double v37 = (v24 * v29) + (v34 * v35);
        const double v39 = 1.0 / squared(v37);
        const double v40 = ((-0.5773502691896257) * v19) * v39;
        const double v43 = log(v37);
        const double v45 = c5 * ((v40 - y[9 * i + 5]) + v43);
        const double v60 = 1.0 / v37;
        const double v61 = ((v34 * v29) - (v24 * v35)) * v60;
        const double v64 = c56 * (v61 - y[9 * i + 7]);
        const double v69 = (3.0 * squared(v64)) + (0.75 * squared(v45));
        const double v70 = (double)(c50 <= v69);
        const double v84 = (0.5 * (g[7 * i + 1] * c79)) * c83;
        const double v85 = (v70 / (v70 + (double)(v69 <= c50))) * v84;
        const double v88 = c5 * ((2.0 * v45) * (0.75 * v85));
        const double v92 = (0.5773502691896257 * v19) * v39;
        const double v96 = c5 * ((v92 - y[9 * i + 6]) + v43);
        const double v100 = c56 * (v61 - y[9 * i + 8]);
        const double v105 = (3.0 * squared(v100)) + (0.75 * squared(v96));
        const double v106 = (double)(c50 <= v105);
        const double v110 = (v106 / (v106 + (double)(v105 <= c50))) * v84;
        const double v113 = c5 * ((2.0 * v96) * (0.75 * v110));
        const double v116 = 2.0 * v37;
        const double v121 = v61 * v60;
        const double v125 = c56 * ((2.0 * v100) * (3.0 * v110));
        const double v127 = ((v113 * v60) - (v116 * ((v92 * v39) * v113))) - (v121 * v125);
        const double v137 = c56 * ((2.0 * v64) * (3.0 * v85));
        const double v139 = ((v127 + (v88 * v60)) - (v116 * ((v40 * v39) * v88))) - (v121 * v137);
        const double v143 = (v125 * v60) + (v137 * v60);
        const double v151 = (v29 * ((v34 * v139) - (v24 * v143))) - (v35 * ((v24 * v139) + (v34 * v143)));
        const double v152 = 0.5 * v151;
        const double v159 = (c9 * (0.5773502691896257 * (v113 * v39))) + (c9 * ((-0.5773502691896257) * (v88 * v39)));
        const double v160 = v17 * v159;
        const double v168 = ((v29 * v139) - (v35 * v143)) * v14;
        const double v173 = ((v35 * v139) + (v29 * v143)) * v14;
        s[9 * i + 5] += -v88;
        s[9 * i + 6] += -v113;
        s[9 * i + 4] += v152 - v160;
        s[9 * i + 13] += v160 + v152;
        s[9 * i + 7] += -v137;
        s[9 * i + 8] += -v125;
        s[9 * i] += -v168;
        s[9 * i + 9] += v168;
        s[9 * i + 1] += -v173;
        s[9 * i + 10] += v173;
    }
}

static void work_slope_1(int n, double t, const double *p, const double *g, double *s)
{
    const double c1 = p[0];
    const double c2 = p[2];
    const double c3 = c1 * c2;
    const double c6 = 30.0 * p[3];
    const double c10 = p[8];
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
    9, 4, 9, 7, 45, 81, 3, 1,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "ramp", "youngs_modulus", "viscosity",
    "poisson", "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "s", "Pa", "Pa*s", "1", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON,
    SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.5, 0.003, 1000.0, 9.81, 3.0, 600000.0, 3000000.0, 0.49, 0.22576182049286544};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0", "axial_1", "shear_0", "shear_1"};
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
    .title = "Plastic sheet that droops in a thermoforming oven",
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
    .duration = 30.0,
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
