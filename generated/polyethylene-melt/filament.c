/*
 * Thread of molten polyethylene with six relaxation times
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, shear, surface-tension
 * Digest of the structure: b34c3ff1d07360f88ffc1f6427c53aba1eb7a0d1069c00813ddc554d6c5f6f0d
 */
#include "filament.h"

#include <math.h>

#include "softcat_model.h"

static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double squared(double a) { return a * a; }

static void rates_0(int n, const double *y, double *f)
{
    for (int i = 1; i < n - 1; i++) {
        f[29 * i] = y[29 * i + 2];
    }
}

static void rates_1(int n, const double *y, double *f)
{
    for (int i = 0; i < n - 1; i++) {
        f[29 * i + 1] = y[29 * i + 3];
    }
}

static void rates_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[29 * i];
        w1[i] = y[29 * i + 4];
    }
}

static void rates_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[29 * i + 1];
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
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    const double c1 = p[6];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c42 = p[8];
    const double c48 = p[10];
    const double c54 = p[12];
    const double c60 = p[14];
    const double c66 = p[16];
    const double c114 = 0.9 * c1;
    const double c116 = 2.0 * p[4];
    const double c117 = 2.0 + c116;
    const double c118 = c114 / c117;
    const double c123 = 0.9 * c42;
    const double c124 = c123 / c117;
    const double c129 = 0.9 * c48;
    const double c130 = c129 / c117;
    const double c135 = 0.9 * c54;
    const double c136 = c135 / c117;
    const double c141 = 0.9 * c60;
    const double c142 = c141 / c117;
    const double c147 = 0.9 * c66;
    const double c148 = c147 / c117;
    const double c184 = 0.5 * c4;
    const double c203 = p[5] / c4;
    const double c204 = 2.0 * c203;
    const double c222 = p[7];
    const double c223 = 1.0 / c222;
    const double c225 = p[18];
    const double c229 = p[9];
    const double c230 = 1.0 / c229;
    const double c235 = p[11];
    const double c236 = 1.0 / c235;
    const double c241 = p[13];
    const double c242 = 1.0 / c241;
    const double c247 = p[15];
    const double c248 = 1.0 / c247;
    const double c253 = p[17];
    const double c254 = 1.0 / c253;
    const double c260 = 3.0 / c222;
    const double c265 = 3.0 / c229;
    const double c270 = 3.0 / c235;
    const double c275 = 3.0 / c241;
    const double c280 = 3.0 / c247;
    const double c285 = 3.0 / c253;
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
        const double v36 = ((-0.4999999999999998) * v15) * v35;
        const double v39 = log(v32);
        const double v41 = c1 * ((v36 - y[29 * i + 5]) + v39);
        const double v46 = c42 * ((v36 - y[29 * i + 7]) + v39);
        const double v52 = c48 * ((v36 - y[29 * i + 9]) + v39);
        const double v58 = c54 * ((v36 - y[29 * i + 11]) + v39);
        const double v64 = c60 * ((v36 - y[29 * i + 13]) + v39);
        const double v70 = c66 * ((v36 - y[29 * i + 15]) + v39);
        const double v71 = ((((v41 + v46) + v52) + v58) + v64) + v70;
        const double v76 = (0.5000000000000001 * v15) * v35;
        const double v80 = c1 * ((v76 - y[29 * i + 6]) + v39);
        const double v84 = c42 * ((v76 - y[29 * i + 8]) + v39);
        const double v89 = c48 * ((v76 - y[29 * i + 10]) + v39);
        const double v94 = c54 * ((v76 - y[29 * i + 12]) + v39);
        const double v99 = c60 * ((v76 - y[29 * i + 14]) + v39);
        const double v104 = c66 * ((v76 - y[29 * i + 16]) + v39);
        const double v105 = ((((v80 + v84) + v89) + v94) + v99) + v104;
        const double v108 = 1.0 / v32;
        const double v112 = (v29 * v24) - (v20 * v30);
        const double v119 = v112 * v108;
        const double v122 = c118 * (v119 - y[29 * i + 17]);
        const double v127 = c124 * (v119 - y[29 * i + 19]);
        const double v133 = c130 * (v119 - y[29 * i + 21]);
        const double v139 = c136 * (v119 - y[29 * i + 23]);
        const double v145 = c142 * (v119 - y[29 * i + 25]);
        const double v151 = c148 * (v119 - y[29 * i + 27]);
        const double v156 = c118 * (v119 - y[29 * i + 18]);
        const double v159 = c124 * (v119 - y[29 * i + 20]);
        const double v163 = c130 * (v119 - y[29 * i + 22]);
        const double v167 = c136 * (v119 - y[29 * i + 24]);
        const double v171 = c142 * (v119 - y[29 * i + 26]);
        const double v175 = c148 * (v119 - y[29 * i + 28]);
        const double v177 = 0.4999999999999999 * (((((v156 + v159) + v163) + v167) + v171) + v175);
        const double v178 = (0.5 * (((((v122 + v127) + v133) + v139) + v145) + v151)) + v177;
        const double v179 = v178 * v108;
        const double v182 = (((0.5 * v71) + (0.4999999999999999 * v105)) * v108) - ((v112 * v179) * v108);
        const double v191 = (c184 * (((-0.2499999999999999) * v71) + (0.25 * v105))) * v35;
        const double v195 = v182 + (((1.5 * v191) * v14) * v108);
        const double v198 = (v195 * v24) - (v179 * v30);
        const double v201 = (v195 * v30) + (v179 * v24);
        const double v208 = sqrt(squared(v20) + squared(v29));
        const double v211 = (c204 / sqrt(v208)) / v208;
        w3[i] = v198;
        w4[i] = v201;
        w5[i] = v198 + (v211 * v20);
        w6[i] = v201 + (v211 * v29);
        w7[i] = ((g[7 * i + 1] * c11) * (v178 - (v112 * v195))) * 0.5;
        w8[i] = -v191;
        f[29 * i + 5] = (v41 * c223) * c225;
        f[29 * i + 6] = (v80 * c223) * c225;
        f[29 * i + 7] = (v46 * c230) * c225;
        f[29 * i + 8] = (v84 * c230) * c225;
        f[29 * i + 9] = (v52 * c236) * c225;
        f[29 * i + 10] = (v89 * c236) * c225;
        f[29 * i + 11] = (v58 * c242) * c225;
        f[29 * i + 12] = (v94 * c242) * c225;
        f[29 * i + 13] = (v64 * c248) * c225;
        f[29 * i + 14] = (v99 * c248) * c225;
        f[29 * i + 15] = (v70 * c254) * c225;
        f[29 * i + 16] = (v104 * c254) * c225;
        f[29 * i + 17] = (c260 * v122) * c225;
        f[29 * i + 18] = (c260 * v156) * c225;
        f[29 * i + 19] = (c265 * v127) * c225;
        f[29 * i + 20] = (c265 * v159) * c225;
        f[29 * i + 21] = (c270 * v133) * c225;
        f[29 * i + 22] = (c270 * v163) * c225;
        f[29 * i + 23] = (c275 * v139) * c225;
        f[29 * i + 24] = (c275 * v167) * c225;
        f[29 * i + 25] = (c280 * v145) * c225;
        f[29 * i + 26] = (c280 * v171) * c225;
        f[29 * i + 27] = (c285 * v151) * c225;
        f[29 * i + 28] = (c285 * v175) * c225;
    }
}

static void rates_7(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w5 = w + 5 * n;
    double *restrict w7 = w + 7 * n;
    double *restrict w8 = w + 8 * n;
    const double c4 = squared(p[18]);
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
    const double c32 = squared(c5);
    const double c33 = c7 * c32;
    const double c34 = c25 / c33;
    for (int i = 1; i < n - 1; i++) {
        const double v31 = (((w8[i] - w8[i - 1]) + w7[i]) + w7[i - 1]) * (c27 * g[7 * i + 5]);
        f[29 * i + 2] = (w5[i] - w5[i - 1]) * (c9 * g[7 * i + 6]);
        f[29 * i + 4] = v31 * c34;
    }
}

static void rates_8(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w6 = w + 6 * n;
    const double c4 = squared(p[18]);
    const double c5 = p[0];
    const double c6 = c4 / c5;
    const double c8 = p[2] * c5;
    const double c9 = c6 / c8;
    const double c15 = p[3] * c6;
    for (int i = 1; i < n - 1; i++) {
        f[29 * i + 3] = ((w6[i] - w6[i - 1]) * (c9 * g[7 * i + 6])) - c15;
    }
}

static void rates_9(int n, const double *p, const double *g, double *w, double *f)
{
    double *restrict w6 = w + 6 * n;
    const double c2 = squared(p[18]);
    const double c3 = p[0];
    const double c4 = c2 / c3;
    const double c6 = p[2] * c3;
    const double c7 = c4 / c6;
    const double c13 = p[3] * c4;
    const int i = 0;
    f[29 * i + 3] = (w6[i] * (c7 * g[7 * i + 6])) - c13;
    (void)n;
}

static void jacobian_0(int n, double *e)
{
    for (int i = 1; i < n - 1; i++) {
        e[341 * i] = 1.0;
    }
}

static void jacobian_1(int n, double *e)
{
    for (int i = 0; i < n - 1; i++) {
        e[341 * i + 1] = 1.0;
    }
}

static void jacobian_2(int n, const double *y, double *w)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    for (int i = 1; i < n - 1; i++) {
        w0[i] = y[29 * i];
        w1[i] = y[29 * i + 4];
    }
}

static void jacobian_3(int n, const double *y, double *w)
{
    double *restrict w2 = w + 2 * n;
    for (int i = 0; i < n - 1; i++) {
        w2[i] = y[29 * i + 1];
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
    double *restrict w87 = w + 87 * n;
    double *restrict w88 = w + 88 * n;
    double *restrict w89 = w + 89 * n;
    double *restrict w90 = w + 90 * n;
    double *restrict w91 = w + 91 * n;
    double *restrict w92 = w + 92 * n;
    double *restrict w93 = w + 93 * n;
    double *restrict w94 = w + 94 * n;
    double *restrict w95 = w + 95 * n;
    double *restrict w96 = w + 96 * n;
    double *restrict w97 = w + 97 * n;
    double *restrict w98 = w + 98 * n;
    double *restrict w99 = w + 99 * n;
    double *restrict w100 = w + 100 * n;
    double *restrict w101 = w + 101 * n;
    double *restrict w102 = w + 102 * n;
    double *restrict w103 = w + 103 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict w112 = w + 112 * n;
    double *restrict w113 = w + 113 * n;
    double *restrict w114 = w + 114 * n;
    double *restrict w115 = w + 115 * n;
    double *restrict w116 = w + 116 * n;
    double *restrict w117 = w + 117 * n;
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    double *restrict w120 = w + 120 * n;
    double *restrict w121 = w + 121 * n;
    double *restrict w122 = w + 122 * n;
    double *restrict w123 = w + 123 * n;
    double *restrict w124 = w + 124 * n;
    double *restrict w125 = w + 125 * n;
    double *restrict w126 = w + 126 * n;
    double *restrict w127 = w + 127 * n;
    double *restrict w128 = w + 128 * n;
    double *restrict w129 = w + 129 * n;
    double *restrict w130 = w + 130 * n;
    double *restrict w131 = w + 131 * n;
    double *restrict w132 = w + 132 * n;
    double *restrict w133 = w + 133 * n;
    double *restrict w134 = w + 134 * n;
    double *restrict w135 = w + 135 * n;
    double *restrict w136 = w + 136 * n;
    double *restrict w137 = w + 137 * n;
    double *restrict w138 = w + 138 * n;
    double *restrict w139 = w + 139 * n;
    double *restrict w140 = w + 140 * n;
    double *restrict w141 = w + 141 * n;
    double *restrict w142 = w + 142 * n;
    double *restrict w143 = w + 143 * n;
    double *restrict w144 = w + 144 * n;
    double *restrict w145 = w + 145 * n;
    double *restrict w146 = w + 146 * n;
    double *restrict w147 = w + 147 * n;
    double *restrict w148 = w + 148 * n;
    double *restrict w149 = w + 149 * n;
    double *restrict w150 = w + 150 * n;
    double *restrict w151 = w + 151 * n;
    double *restrict w152 = w + 152 * n;
    double *restrict w153 = w + 153 * n;
    double *restrict w154 = w + 154 * n;
    double *restrict w155 = w + 155 * n;
    double *restrict w156 = w + 156 * n;
    double *restrict w157 = w + 157 * n;
    double *restrict w158 = w + 158 * n;
    double *restrict w159 = w + 159 * n;
    double *restrict w160 = w + 160 * n;
    double *restrict w161 = w + 161 * n;
    double *restrict w162 = w + 162 * n;
    double *restrict w163 = w + 163 * n;
    double *restrict w164 = w + 164 * n;
    double *restrict w165 = w + 165 * n;
    double *restrict w166 = w + 166 * n;
    double *restrict w167 = w + 167 * n;
    double *restrict w168 = w + 168 * n;
    double *restrict w169 = w + 169 * n;
    double *restrict w170 = w + 170 * n;
    double *restrict w171 = w + 171 * n;
    double *restrict w172 = w + 172 * n;
    double *restrict w173 = w + 173 * n;
    double *restrict w174 = w + 174 * n;
    double *restrict w175 = w + 175 * n;
    double *restrict w176 = w + 176 * n;
    const double c1 = p[6];
    const double c4 = p[1];
    const double c5 = (-0.5) * c4;
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c42 = p[8];
    const double c48 = p[10];
    const double c54 = p[12];
    const double c60 = p[14];
    const double c66 = p[16];
    const double c114 = 0.9 * c1;
    const double c116 = 2.0 * p[4];
    const double c117 = 2.0 + c116;
    const double c118 = c114 / c117;
    const double c123 = 0.9 * c42;
    const double c124 = c123 / c117;
    const double c129 = 0.9 * c48;
    const double c130 = c129 / c117;
    const double c135 = 0.9 * c54;
    const double c136 = c135 / c117;
    const double c141 = 0.9 * c60;
    const double c142 = c141 / c117;
    const double c147 = 0.9 * c66;
    const double c148 = c147 / c117;
    const double c184 = 0.5 * c4;
    const double c199 = 0.5 * c1;
    const double c201 = (-0.2499999999999999) * c1;
    const double c202 = c184 * c201;
    const double c210 = 0.5 * c42;
    const double c212 = (-0.2499999999999999) * c42;
    const double c213 = c184 * c212;
    const double c221 = 0.5 * c48;
    const double c223 = (-0.2499999999999999) * c48;
    const double c224 = c184 * c223;
    const double c232 = 0.5 * c54;
    const double c234 = (-0.2499999999999999) * c54;
    const double c235 = c184 * c234;
    const double c243 = 0.5 * c60;
    const double c245 = (-0.2499999999999999) * c60;
    const double c246 = c184 * c245;
    const double c254 = 0.5 * c66;
    const double c256 = (-0.2499999999999999) * c66;
    const double c257 = c184 * c256;
    const double c265 = 0.4999999999999999 * c1;
    const double c267 = 0.25 * c1;
    const double c268 = c184 * c267;
    const double c276 = 0.4999999999999999 * c42;
    const double c278 = 0.25 * c42;
    const double c279 = c184 * c278;
    const double c287 = 0.4999999999999999 * c48;
    const double c289 = 0.25 * c48;
    const double c290 = c184 * c289;
    const double c298 = 0.4999999999999999 * c54;
    const double c300 = 0.25 * c54;
    const double c301 = c184 * c300;
    const double c309 = 0.4999999999999999 * c60;
    const double c311 = 0.25 * c60;
    const double c312 = c184 * c311;
    const double c320 = 0.4999999999999999 * c66;
    const double c322 = 0.25 * c66;
    const double c323 = c184 * c322;
    const double c489 = 0.5 * c118;
    const double c496 = 0.5 * c124;
    const double c503 = 0.5 * c130;
    const double c510 = 0.5 * c136;
    const double c517 = 0.5 * c142;
    const double c524 = 0.5 * c148;
    const double c531 = 0.4999999999999999 * c118;
    const double c538 = 0.4999999999999999 * c124;
    const double c545 = 0.4999999999999999 * c130;
    const double c552 = 0.4999999999999999 * c136;
    const double c559 = 0.4999999999999999 * c142;
    const double c566 = 0.4999999999999999 * c148;
    const double c926 = p[5] / c4;
    const double c927 = 2.0 * c926;
    const double c1124 = p[18];
    const double c1125 = p[7];
    const double c1126 = c1 / c1125;
    const double c1127 = c1124 * c1126;
    const double c1128 = -c1127;
    const double c1129 = 1.0 / c1125;
    const double c1154 = p[9];
    const double c1155 = c42 / c1154;
    const double c1156 = c1124 * c1155;
    const double c1157 = -c1156;
    const double c1158 = 1.0 / c1154;
    const double c1183 = p[11];
    const double c1184 = c48 / c1183;
    const double c1185 = c1124 * c1184;
    const double c1186 = -c1185;
    const double c1187 = 1.0 / c1183;
    const double c1212 = p[13];
    const double c1213 = c54 / c1212;
    const double c1214 = c1124 * c1213;
    const double c1215 = -c1214;
    const double c1216 = 1.0 / c1212;
    const double c1241 = p[15];
    const double c1242 = c60 / c1241;
    const double c1243 = c1124 * c1242;
    const double c1244 = -c1243;
    const double c1245 = 1.0 / c1241;
    const double c1270 = p[17];
    const double c1271 = c66 / c1270;
    const double c1272 = c1124 * c1271;
    const double c1273 = -c1272;
    const double c1274 = 1.0 / c1270;
    const double c1300 = 3.0 / c1125;
    const double c1304 = c1300 * c118;
    const double c1305 = c1124 * c1304;
    const double c1306 = -c1305;
    const double c1314 = 3.0 / c1154;
    const double c1318 = c1314 * c124;
    const double c1319 = c1124 * c1318;
    const double c1320 = -c1319;
    const double c1328 = 3.0 / c1183;
    const double c1332 = c1328 * c130;
    const double c1333 = c1124 * c1332;
    const double c1334 = -c1333;
    const double c1342 = 3.0 / c1212;
    const double c1346 = c1342 * c136;
    const double c1347 = c1124 * c1346;
    const double c1348 = -c1347;
    const double c1356 = 3.0 / c1241;
    const double c1360 = c1356 * c142;
    const double c1361 = c1124 * c1360;
    const double c1362 = -c1361;
    const double c1370 = 3.0 / c1270;
    const double c1374 = c1370 * c148;
    const double c1375 = c1124 * c1374;
    const double c1376 = -c1375;
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
        const double v36 = ((-0.4999999999999998) * v15) * v35;
        const double v39 = log(v32);
        const double v47 = (c1 * ((v36 - y[29 * i + 5]) + v39)) + (c42 * ((v36 - y[29 * i + 7]) + v39));
        const double v59 = (v47 + (c48 * ((v36 - y[29 * i + 9]) + v39))) + (c54 * ((v36 - y[29 * i + 11]) + v39));
        const double v71 = (v59 + (c60 * ((v36 - y[29 * i + 13]) + v39))) + (c66 * ((v36 - y[29 * i + 15]) + v39));
        const double v76 = (0.5000000000000001 * v15) * v35;
        const double v85 = (c1 * ((v76 - y[29 * i + 6]) + v39)) + (c42 * ((v76 - y[29 * i + 8]) + v39));
        const double v95 = (v85 + (c48 * ((v76 - y[29 * i + 10]) + v39))) + (c54 * ((v76 - y[29 * i + 12]) + v39));
        const double v105 = (v95 + (c60 * ((v76 - y[29 * i + 14]) + v39))) + (c66 * ((v76 - y[29 * i + 16]) + v39));
        const double v108 = 1.0 / v32;
        const double v109 = ((0.5 * v71) + (0.4999999999999999 * v105)) * v108;
        const double v112 = (v29 * v24) - (v20 * v30);
        const double v119 = v112 * v108;
        const double v128 = (c118 * (v119 - y[29 * i + 17])) + (c124 * (v119 - y[29 * i + 19]));
        const double v140 = (v128 + (c130 * (v119 - y[29 * i + 21]))) + (c136 * (v119 - y[29 * i + 23]));
        const double v152 = (v140 + (c142 * (v119 - y[29 * i + 25]))) + (c148 * (v119 - y[29 * i + 27]));
        const double v160 = (c118 * (v119 - y[29 * i + 18])) + (c124 * (v119 - y[29 * i + 20]));
        const double v168 = (v160 + (c130 * (v119 - y[29 * i + 22]))) + (c136 * (v119 - y[29 * i + 24]));
        const double v176 = (v168 + (c142 * (v119 - y[29 * i + 26]))) + (c148 * (v119 - y[29 * i + 28]));
        const double v178 = (0.5 * v152) + (0.4999999999999999 * v176);
        const double v179 = v178 * v108;
        const double v181 = (v112 * v179) * v108;
        const double v191 = (c184 * (((-0.2499999999999999) * v71) + (0.25 * v105))) * v35;
        const double v192 = 1.5 * v191;
        const double v194 = (v192 * v14) * v108;
        const double v195 = (v109 - v181) + v194;
        const double v198 = (v195 * v24) - (v179 * v30);
        const double v203 = c202 * v35;
        const double v207 = (c199 * v108) + ((v14 * (1.5 * v203)) * v108);
        const double v209 = -(v24 * v207);
        const double v214 = c213 * v35;
        const double v218 = (c210 * v108) + ((v14 * (1.5 * v214)) * v108);
        const double v220 = -(v24 * v218);
        const double v225 = c224 * v35;
        const double v229 = (c221 * v108) + ((v14 * (1.5 * v225)) * v108);
        const double v231 = -(v24 * v229);
        const double v236 = c235 * v35;
        const double v240 = (c232 * v108) + ((v14 * (1.5 * v236)) * v108);
        const double v242 = -(v24 * v240);
        const double v247 = c246 * v35;
        const double v251 = (c243 * v108) + ((v14 * (1.5 * v247)) * v108);
        const double v253 = -(v24 * v251);
        const double v258 = c257 * v35;
        const double v262 = (c254 * v108) + ((v14 * (1.5 * v258)) * v108);
        const double v264 = -(v24 * v262);
        const double v269 = c268 * v35;
        const double v273 = (c265 * v108) + ((v14 * (1.5 * v269)) * v108);
        const double v275 = -(v24 * v273);
        const double v280 = c279 * v35;
        const double v284 = (c276 * v108) + ((v14 * (1.5 * v280)) * v108);
        const double v286 = -(v24 * v284);
        const double v291 = c290 * v35;
        const double v295 = (c287 * v108) + ((v14 * (1.5 * v291)) * v108);
        const double v297 = -(v24 * v295);
        const double v302 = c301 * v35;
        const double v306 = (c298 * v108) + ((v14 * (1.5 * v302)) * v108);
        const double v308 = -(v24 * v306);
        const double v313 = c312 * v35;
        const double v317 = (c309 * v108) + ((v14 * (1.5 * v313)) * v108);
        const double v319 = -(v24 * v317);
        const double v324 = c323 * v35;
        const double v328 = (c320 * v108) + ((v14 * (1.5 * v324)) * v108);
        const double v330 = -(v24 * v328);
        const double v331 = 0.5 * v24;
        const double v333 = 0.5 * v30;
        const double v335 = (v29 * v331) - (v20 * v333);
        const double v336 = v335 * v108;
        const double v337 = c5 * v13;
        const double v339 = ((-0.4999999999999998) * v337) * v35;
        const double v340 = v36 * v35;
        const double v342 = 1.0 / (2.0 * v33);
        const double v346 = (v32 * (v335 * v342)) + (v33 * v335);
        const double v347 = v340 * v346;
        const double v349 = v336 - (v339 + v347);
        const double v350 = c1 * v349;
        const double v351 = c42 * v349;
        const double v353 = c48 * v349;
        const double v355 = c54 * v349;
        const double v357 = c60 * v349;
        const double v359 = c66 * v349;
        const double v360 = ((((v350 + v351) + v353) + v355) + v357) + v359;
        const double v363 = (0.5000000000000001 * v337) * v35;
        const double v364 = v76 * v35;
        const double v365 = v364 * v346;
        const double v367 = v336 - (v363 + v365);
        const double v368 = c1 * v367;
        const double v369 = c42 * v367;
        const double v371 = c48 * v367;
        const double v373 = c54 * v367;
        const double v375 = c60 * v367;
        const double v377 = c66 * v367;
        const double v378 = ((((v368 + v369) + v371) + v373) + v375) + v377;
        const double v382 = v109 * v108;
        const double v383 = v382 * v335;
        const double v384 = (((0.5 * v360) + (0.4999999999999999 * v378)) * v108) - v383;
        const double v387 = (v29 * v333) + (v20 * v331);
        const double v390 = v119 * v108;
        const double v392 = (v387 * v108) + (v390 * v335);
        const double v393 = c118 * v392;
        const double v394 = c124 * v392;
        const double v396 = c130 * v392;
        const double v398 = c136 * v392;
        const double v400 = c142 * v392;
        const double v402 = c148 * v392;
        const double v403 = ((((v393 + v394) + v396) + v398) + v400) + v402;
        const double v406 = (0.5 * v403) + (0.4999999999999999 * v403);
        const double v408 = v179 * v108;
        const double v410 = (v406 * v108) + (v408 * v335);
        const double v414 = v181 * v108;
        const double v416 = (((v179 * v387) + (v112 * v410)) * v108) + (v414 * v335);
        const double v422 = (c184 * (((-0.2499999999999999) * v360) + (0.25 * v378))) * v35;
        const double v423 = v191 * v35;
        const double v424 = v423 * v346;
        const double v425 = v422 - v424;
        const double v428 = v192 * v13;
        const double v431 = v194 * v108;
        const double v432 = v431 * v335;
        const double v434 = (v384 + v416) + ((((v14 * (1.5 * v425)) - v428) * v108) - v432);
        const double v436 = v195 * v333;
        const double v440 = (v179 * v331) - (v30 * v410);
        const double v441 = ((v24 * v434) - v436) - v440;
        const double v443 = (v339 - v347) + v336;
        const double v444 = c1 * v443;
        const double v445 = c42 * v443;
        const double v447 = c48 * v443;
        const double v449 = c54 * v443;
        const double v451 = c60 * v443;
        const double v453 = c66 * v443;
        const double v454 = ((((v444 + v445) + v447) + v449) + v451) + v453;
        const double v457 = (v363 - v365) + v336;
        const double v458 = c1 * v457;
        const double v459 = c42 * v457;
        const double v461 = c48 * v457;
        const double v463 = c54 * v457;
        const double v465 = c60 * v457;
        const double v467 = c66 * v457;
        const double v468 = ((((v458 + v459) + v461) + v463) + v465) + v467;
        const double v472 = (((0.5 * v454) + (0.4999999999999999 * v468)) * v108) - v383;
        const double v478 = (c184 * (((-0.2499999999999999) * v454) + (0.25 * v468))) * v35;
        const double v479 = v478 - v424;
        const double v485 = (v472 + v416) + ((((v14 * (1.5 * v479)) + v428) * v108) - v432);
        const double v488 = ((v24 * v485) - v436) - v440;
        const double v490 = c489 * v108;
        const double v492 = (v112 * v490) * v108;
        const double v495 = (v24 * v492) + (v30 * v490);
        const double v497 = c496 * v108;
        const double v499 = (v112 * v497) * v108;
        const double v502 = (v24 * v499) + (v30 * v497);
        const double v504 = c503 * v108;
        const double v506 = (v112 * v504) * v108;
        const double v509 = (v24 * v506) + (v30 * v504);
        const double v511 = c510 * v108;
        const double v513 = (v112 * v511) * v108;
        const double v516 = (v24 * v513) + (v30 * v511);
        const double v518 = c517 * v108;
        const double v520 = (v112 * v518) * v108;
        const double v523 = (v24 * v520) + (v30 * v518);
        const double v525 = c524 * v108;
        const double v527 = (v112 * v525) * v108;
        const double v530 = (v24 * v527) + (v30 * v525);
        const double v532 = c531 * v108;
        const double v534 = (v112 * v532) * v108;
        const double v537 = (v24 * v534) + (v30 * v532);
        const double v539 = c538 * v108;
        const double v541 = (v112 * v539) * v108;
        const double v544 = (v24 * v541) + (v30 * v539);
        const double v546 = c545 * v108;
        const double v548 = (v112 * v546) * v108;
        const double v551 = (v24 * v548) + (v30 * v546);
        const double v553 = c552 * v108;
        const double v555 = (v112 * v553) * v108;
        const double v558 = (v24 * v555) + (v30 * v553);
        const double v560 = c559 * v108;
        const double v562 = (v112 * v560) * v108;
        const double v565 = (v24 * v562) + (v30 * v560);
        const double v567 = c566 * v108;
        const double v569 = (v112 * v567) * v108;
        const double v572 = (v24 * v569) + (v30 * v567);
        const double v573 = v24 * v10;
        const double v577 = (v32 * (v573 * v342)) + (v33 * v573);
        const double v578 = v340 * v577;
        const double v579 = v573 * v108;
        const double v580 = v578 - v579;
        const double v581 = c1 * v580;
        const double v582 = c42 * v580;
        const double v584 = c48 * v580;
        const double v586 = c54 * v580;
        const double v588 = c60 * v580;
        const double v590 = c66 * v580;
        const double v591 = ((((v581 + v582) + v584) + v586) + v588) + v590;
        const double v593 = v364 * v577;
        const double v594 = v593 - v579;
        const double v595 = c1 * v594;
        const double v596 = c42 * v594;
        const double v598 = c48 * v594;
        const double v600 = c54 * v594;
        const double v602 = c60 * v594;
        const double v604 = c66 * v594;
        const double v605 = ((((v595 + v596) + v598) + v600) + v602) + v604;
        const double v609 = v382 * v573;
        const double v610 = (((0.5 * v591) + (0.4999999999999999 * v605)) * v108) + v609;
        const double v611 = v30 * v10;
        const double v613 = v611 * v108;
        const double v615 = v613 + (v390 * v573);
        const double v616 = c118 * v615;
        const double v617 = c124 * v615;
        const double v619 = c130 * v615;
        const double v621 = c136 * v615;
        const double v623 = c142 * v615;
        const double v625 = c148 * v615;
        const double v626 = ((((v616 + v617) + v619) + v621) + v623) + v625;
        const double v629 = (0.5 * v626) + (0.4999999999999999 * v626);
        const double v632 = (v629 * v108) + (v408 * v573);
        const double v637 = (((v179 * v611) + (v112 * v632)) * v108) + (v414 * v573);
        const double v643 = (c184 * (((-0.2499999999999999) * v591) + (0.25 * v605))) * v35;
        const double v644 = v423 * v577;
        const double v645 = v643 + v644;
        const double v649 = v431 * v573;
        const double v651 = (v610 - v637) + (((v14 * (1.5 * v645)) * v108) + v649);
        const double v653 = v30 * v632;
        const double v654 = (v24 * v651) - v653;
        const double v655 = v579 - v578;
        const double v656 = c1 * v655;
        const double v657 = c42 * v655;
        const double v659 = c48 * v655;
        const double v661 = c54 * v655;
        const double v663 = c60 * v655;
        const double v665 = c66 * v655;
        const double v666 = ((((v656 + v657) + v659) + v661) + v663) + v665;
        const double v668 = v579 - v593;
        const double v669 = c1 * v668;
        const double v670 = c42 * v668;
        const double v672 = c48 * v668;
        const double v674 = c54 * v668;
        const double v676 = c60 * v668;
        const double v678 = c66 * v668;
        const double v679 = ((((v669 + v670) + v672) + v674) + v676) + v678;
        const double v683 = (((0.5 * v666) + (0.4999999999999999 * v679)) * v108) - v609;
        const double v689 = (c184 * (((-0.2499999999999999) * v666) + (0.25 * v679))) * v35;
        const double v690 = v689 - v644;
        const double v695 = (v683 + v637) + (((v14 * (1.5 * v690)) * v108) - v649);
        const double v697 = (v24 * v695) + v653;
        const double v701 = (v32 * (v611 * v342)) + (v33 * v611);
        const double v702 = v340 * v701;
        const double v703 = v702 - v613;
        const double v704 = c1 * v703;
        const double v705 = c42 * v703;
        const double v707 = c48 * v703;
        const double v709 = c54 * v703;
        const double v711 = c60 * v703;
        const double v713 = c66 * v703;
        const double v714 = ((((v704 + v705) + v707) + v709) + v711) + v713;
        const double v716 = v364 * v701;
        const double v717 = v716 - v613;
        const double v718 = c1 * v717;
        const double v719 = c42 * v717;
        const double v721 = c48 * v717;
        const double v723 = c54 * v717;
        const double v725 = c60 * v717;
        const double v727 = c66 * v717;
        const double v728 = ((((v718 + v719) + v721) + v723) + v725) + v727;
        const double v732 = v382 * v611;
        const double v733 = (((0.5 * v714) + (0.4999999999999999 * v728)) * v108) + v732;
        const double v734 = v390 * v611;
        const double v735 = v734 - v579;
        const double v736 = c118 * v735;
        const double v737 = c124 * v735;
        const double v739 = c130 * v735;
        const double v741 = c136 * v735;
        const double v743 = c142 * v735;
        const double v745 = c148 * v735;
        const double v746 = ((((v736 + v737) + v739) + v741) + v743) + v745;
        const double v749 = (0.5 * v746) + (0.4999999999999999 * v746);
        const double v751 = v408 * v611;
        const double v752 = (v749 * v108) + v751;
        const double v754 = v179 * v573;
        const double v757 = v414 * v611;
        const double v764 = (c184 * (((-0.2499999999999999) * v714) + (0.25 * v728))) * v35;
        const double v765 = v423 * v701;
        const double v766 = v764 + v765;
        const double v770 = v431 * v611;
        const double v772 = (v733 - ((((v112 * v752) - v754) * v108) + v757)) + (((v14 * (1.5 * v766)) * v108) + v770);
        const double v775 = (v24 * v772) - (v30 * v752);
        const double v776 = v613 - v702;
        const double v777 = c1 * v776;
        const double v778 = c42 * v776;
        const double v780 = c48 * v776;
        const double v782 = c54 * v776;
        const double v784 = c60 * v776;
        const double v786 = c66 * v776;
        const double v787 = ((((v777 + v778) + v780) + v782) + v784) + v786;
        const double v789 = v613 - v716;
        const double v790 = c1 * v789;
        const double v791 = c42 * v789;
        const double v793 = c48 * v789;
        const double v795 = c54 * v789;
        const double v797 = c60 * v789;
        const double v799 = c66 * v789;
        const double v800 = ((((v790 + v791) + v793) + v795) + v797) + v799;
        const double v804 = (((0.5 * v787) + (0.4999999999999999 * v800)) * v108) - v732;
        const double v805 = v579 - v734;
        const double v806 = c118 * v805;
        const double v807 = c124 * v805;
        const double v809 = c130 * v805;
        const double v811 = c136 * v805;
        const double v813 = c142 * v805;
        const double v815 = c148 * v805;
        const double v816 = ((((v806 + v807) + v809) + v811) + v813) + v815;
        const double v819 = (0.5 * v816) + (0.4999999999999999 * v816);
        const double v821 = (v819 * v108) - v751;
        const double v831 = (c184 * (((-0.2499999999999999) * v787) + (0.25 * v800))) * v35;
        const double v832 = v831 - v765;
        const double v837 = (v804 - (((v754 + (v112 * v821)) * v108) - v757)) + (((v14 * (1.5 * v832)) * v108) - v770);
        const double v840 = (v24 * v837) - (v30 * v821);
        const double v843 = (v195 * v30) + (v179 * v24);
        const double v845 = -(v30 * v207);
        const double v847 = -(v30 * v218);
        const double v849 = -(v30 * v229);
        const double v851 = -(v30 * v240);
        const double v853 = -(v30 * v251);
        const double v855 = -(v30 * v262);
        const double v857 = -(v30 * v273);
        const double v859 = -(v30 * v284);
        const double v861 = -(v30 * v295);
        const double v863 = -(v30 * v306);
        const double v865 = -(v30 * v317);
        const double v867 = -(v30 * v328);
        const double v869 = v195 * v331;
        const double v873 = (v24 * v410) + (v179 * v333);
        const double v874 = ((v30 * v434) + v869) - v873;
        const double v877 = ((v30 * v485) + v869) - v873;
        const double v880 = (v30 * v492) - (v24 * v490);
        const double v883 = (v30 * v499) - (v24 * v497);
        const double v886 = (v30 * v506) - (v24 * v504);
        const double v889 = (v30 * v513) - (v24 * v511);
        const double v892 = (v30 * v520) - (v24 * v518);
        const double v895 = (v30 * v527) - (v24 * v525);
        const double v898 = (v30 * v534) - (v24 * v532);
        const double v901 = (v30 * v541) - (v24 * v539);
        const double v904 = (v30 * v548) - (v24 * v546);
        const double v907 = (v30 * v555) - (v24 * v553);
        const double v910 = (v30 * v562) - (v24 * v560);
        const double v913 = (v30 * v569) - (v24 * v567);
        const double v915 = v24 * v632;
        const double v916 = (v30 * v651) + v915;
        const double v918 = (v30 * v695) - v915;
        const double v921 = (v30 * v772) + (v24 * v752);
        const double v924 = (v30 * v837) + (v24 * v821);
        const double v931 = sqrt(squared(v20) + squared(v29));
        const double v932 = sqrt(v931);
        const double v933 = 1.0 / v932;
        const double v934 = c927 * v933;
        const double v935 = 1.0 / v931;
        const double v936 = v934 * v935;
        const double v939 = v934 * v933;
        const double v943 = 1.0 / (2.0 * v931);
        const double v944 = ((2.0 * v20) * v10) * v943;
        const double v946 = 1.0 / (2.0 * v932);
        const double v950 = v936 * v935;
        const double v952 = ((v939 * (v944 * v946)) * v935) + (v950 * v944);
        const double v953 = v20 * v952;
        const double v954 = v936 * v10;
        const double v961 = ((2.0 * v29) * v10) * v943;
        const double v966 = ((v939 * (v961 * v946)) * v935) + (v950 * v961);
        const double v967 = v20 * v966;
        const double v972 = v29 * v952;
        const double v975 = v29 * v966;
        const double v980 = g[7 * i + 1] * c11;
        const double v1022 = v195 * v387;
        const double v1094 = v195 * v611;
        const double v1107 = v195 * v573;
        const double v1303 = -(c1124 * (c1300 * v393));
        const double v1308 = c1124 * (c1300 * v616);
        const double v1309 = -v1308;
        const double v1311 = c1124 * (c1300 * v736);
        const double v1313 = c1124 * (c1300 * v806);
        const double v1317 = -(c1124 * (c1314 * v394));
        const double v1322 = c1124 * (c1314 * v617);
        const double v1323 = -v1322;
        const double v1325 = c1124 * (c1314 * v737);
        const double v1327 = c1124 * (c1314 * v807);
        const double v1331 = -(c1124 * (c1328 * v396));
        const double v1336 = c1124 * (c1328 * v619);
        const double v1337 = -v1336;
        const double v1339 = c1124 * (c1328 * v739);
        const double v1341 = c1124 * (c1328 * v809);
        const double v1345 = -(c1124 * (c1342 * v398));
        const double v1350 = c1124 * (c1342 * v621);
        const double v1351 = -v1350;
        const double v1353 = c1124 * (c1342 * v741);
        const double v1355 = c1124 * (c1342 * v811);
        const double v1359 = -(c1124 * (c1356 * v400));
        const double v1364 = c1124 * (c1356 * v623);
        const double v1365 = -v1364;
        const double v1367 = c1124 * (c1356 * v743);
        const double v1369 = c1124 * (c1356 * v813);
        const double v1373 = -(c1124 * (c1370 * v402));
        const double v1378 = c1124 * (c1370 * v625);
        const double v1379 = -v1378;
        const double v1381 = c1124 * (c1370 * v745);
        const double v1383 = c1124 * (c1370 * v815);
        w3[i] = v198;
        w9[i] = v209;
        w10[i] = v220;
        w11[i] = v231;
        w12[i] = v242;
        w13[i] = v253;
        w14[i] = v264;
        w15[i] = v275;
        w16[i] = v286;
        w17[i] = v297;
        w18[i] = v308;
        w19[i] = v319;
        w20[i] = v330;
        w21[i] = v441;
        w22[i] = v488;
        w23[i] = v495;
        w24[i] = v502;
        w25[i] = v509;
        w26[i] = v516;
        w27[i] = v523;
        w28[i] = v530;
        w29[i] = v537;
        w30[i] = v544;
        w31[i] = v551;
        w32[i] = v558;
        w33[i] = v565;
        w34[i] = v572;
        w35[i] = v654;
        w36[i] = v697;
        w37[i] = v775;
        w38[i] = v840;
        w4[i] = v843;
        w39[i] = v845;
        w40[i] = v847;
        w41[i] = v849;
        w42[i] = v851;
        w43[i] = v853;
        w44[i] = v855;
        w45[i] = v857;
        w46[i] = v859;
        w47[i] = v861;
        w48[i] = v863;
        w49[i] = v865;
        w50[i] = v867;
        w51[i] = v874;
        w52[i] = v877;
        w53[i] = v880;
        w54[i] = v883;
        w55[i] = v886;
        w56[i] = v889;
        w57[i] = v892;
        w58[i] = v895;
        w59[i] = v898;
        w60[i] = v901;
        w61[i] = v904;
        w62[i] = v907;
        w63[i] = v910;
        w64[i] = v913;
        w65[i] = v916;
        w66[i] = v918;
        w67[i] = v921;
        w68[i] = v924;
        w5[i] = v198 + (v936 * v20);
        w69[i] = v209;
        w70[i] = v220;
        w71[i] = v231;
        w72[i] = v242;
        w73[i] = v253;
        w74[i] = v264;
        w75[i] = v275;
        w76[i] = v286;
        w77[i] = v297;
        w78[i] = v308;
        w79[i] = v319;
        w80[i] = v330;
        w81[i] = v441;
        w82[i] = v488;
        w83[i] = v495;
        w84[i] = v502;
        w85[i] = v509;
        w86[i] = v516;
        w87[i] = v523;
        w88[i] = v530;
        w89[i] = v537;
        w90[i] = v544;
        w91[i] = v551;
        w92[i] = v558;
        w93[i] = v565;
        w94[i] = v572;
        w95[i] = v654 + (v953 - v954);
        w96[i] = v697 + (v954 - v953);
        w97[i] = v775 + v967;
        w98[i] = v840 - v967;
        w6[i] = v843 + (v936 * v29);
        w99[i] = v845;
        w100[i] = v847;
        w101[i] = v849;
        w102[i] = v851;
        w103[i] = v853;
        w104[i] = v855;
        w105[i] = v857;
        w106[i] = v859;
        w107[i] = v861;
        w108[i] = v863;
        w109[i] = v865;
        w110[i] = v867;
        w111[i] = v874;
        w112[i] = v877;
        w113[i] = v880;
        w114[i] = v883;
        w115[i] = v886;
        w116[i] = v889;
        w117[i] = v892;
        w118[i] = v895;
        w119[i] = v898;
        w120[i] = v901;
        w121[i] = v904;
        w122[i] = v907;
        w123[i] = v910;
        w124[i] = v913;
        w125[i] = v916 + v972;
        w126[i] = v918 - v972;
        w127[i] = v921 + (v975 - v954);
        w128[i] = v924 + (v954 - v975);
        w7[i] = (v980 * (v178 - (v112 * v195))) * 0.5;
        w129[i] = 0.5 * (v980 * (v112 * v207));
        w130[i] = 0.5 * (v980 * (v112 * v218));
        w131[i] = 0.5 * (v980 * (v112 * v229));
        w132[i] = 0.5 * (v980 * (v112 * v240));
        w133[i] = 0.5 * (v980 * (v112 * v251));
        w134[i] = 0.5 * (v980 * (v112 * v262));
        w135[i] = 0.5 * (v980 * (v112 * v273));
        w136[i] = 0.5 * (v980 * (v112 * v284));
        w137[i] = 0.5 * (v980 * (v112 * v295));
        w138[i] = 0.5 * (v980 * (v112 * v306));
        w139[i] = 0.5 * (v980 * (v112 * v317));
        w140[i] = 0.5 * (v980 * (v112 * v328));
        w141[i] = -(0.5 * (v980 * (v406 + ((v112 * v434) - v1022))));
        w142[i] = -(0.5 * (v980 * (v406 + ((v112 * v485) - v1022))));
        w143[i] = -(0.5 * (v980 * (c489 + (v112 * v492))));
        w144[i] = -(0.5 * (v980 * (c496 + (v112 * v499))));
        w145[i] = -(0.5 * (v980 * (c503 + (v112 * v506))));
        w146[i] = -(0.5 * (v980 * (c510 + (v112 * v513))));
        w147[i] = -(0.5 * (v980 * (c517 + (v112 * v520))));
        w148[i] = -(0.5 * (v980 * (c524 + (v112 * v527))));
        w149[i] = -(0.5 * (v980 * (c531 + (v112 * v534))));
        w150[i] = -(0.5 * (v980 * (c538 + (v112 * v541))));
        w151[i] = -(0.5 * (v980 * (c545 + (v112 * v548))));
        w152[i] = -(0.5 * (v980 * (c552 + (v112 * v555))));
        w153[i] = -(0.5 * (v980 * (c559 + (v112 * v562))));
        w154[i] = -(0.5 * (v980 * (c566 + (v112 * v569))));
        w155[i] = 0.5 * (v980 * (v629 - (v1094 + (v112 * v651))));
        w156[i] = -(0.5 * (v980 * (v629 + ((v112 * v695) - v1094))));
        w157[i] = 0.5 * (v980 * (v749 - ((v112 * v772) - v1107)));
        w158[i] = 0.5 * (v980 * (v819 - (v1107 + (v112 * v837))));
        w8[i] = -v191;
        w159[i] = v203;
        w160[i] = v214;
        w161[i] = v225;
        w162[i] = v236;
        w163[i] = v247;
        w164[i] = v258;
        w165[i] = v269;
        w166[i] = v280;
        w167[i] = v291;
        w168[i] = v302;
        w169[i] = v313;
        w170[i] = v324;
        w171[i] = -v425;
        w172[i] = -v479;
        w173[i] = -v645;
        w174[i] = -v690;
        w175[i] = -v766;
        w176[i] = -v832;
        e[341 * i + 176] = c1128;
        e[341 * i + 175] = c1124 * (v350 * c1129);
        e[341 * i + 179] = c1124 * (v444 * c1129);
        e[341 * i + 173] = c1124 * (v581 * c1129);
        e[341 * i + 177] = c1124 * (v656 * c1129);
        e[341 * i + 174] = c1124 * (v704 * c1129);
        e[341 * i + 178] = c1124 * (v777 * c1129);
        e[341 * i + 183] = c1128;
        e[341 * i + 182] = c1124 * (v368 * c1129);
        e[341 * i + 186] = c1124 * (v458 * c1129);
        e[341 * i + 180] = c1124 * (v595 * c1129);
        e[341 * i + 184] = c1124 * (v669 * c1129);
        e[341 * i + 181] = c1124 * (v718 * c1129);
        e[341 * i + 185] = c1124 * (v790 * c1129);
        e[341 * i + 190] = c1157;
        e[341 * i + 189] = c1124 * (v351 * c1158);
        e[341 * i + 193] = c1124 * (v445 * c1158);
        e[341 * i + 187] = c1124 * (v582 * c1158);
        e[341 * i + 191] = c1124 * (v657 * c1158);
        e[341 * i + 188] = c1124 * (v705 * c1158);
        e[341 * i + 192] = c1124 * (v778 * c1158);
        e[341 * i + 197] = c1157;
        e[341 * i + 196] = c1124 * (v369 * c1158);
        e[341 * i + 200] = c1124 * (v459 * c1158);
        e[341 * i + 194] = c1124 * (v596 * c1158);
        e[341 * i + 198] = c1124 * (v670 * c1158);
        e[341 * i + 195] = c1124 * (v719 * c1158);
        e[341 * i + 199] = c1124 * (v791 * c1158);
        e[341 * i + 204] = c1186;
        e[341 * i + 203] = c1124 * (v353 * c1187);
        e[341 * i + 207] = c1124 * (v447 * c1187);
        e[341 * i + 201] = c1124 * (v584 * c1187);
        e[341 * i + 205] = c1124 * (v659 * c1187);
        e[341 * i + 202] = c1124 * (v707 * c1187);
        e[341 * i + 206] = c1124 * (v780 * c1187);
        e[341 * i + 211] = c1186;
        e[341 * i + 210] = c1124 * (v371 * c1187);
        e[341 * i + 214] = c1124 * (v461 * c1187);
        e[341 * i + 208] = c1124 * (v598 * c1187);
        e[341 * i + 212] = c1124 * (v672 * c1187);
        e[341 * i + 209] = c1124 * (v721 * c1187);
        e[341 * i + 213] = c1124 * (v793 * c1187);
        e[341 * i + 218] = c1215;
        e[341 * i + 217] = c1124 * (v355 * c1216);
        e[341 * i + 221] = c1124 * (v449 * c1216);
        e[341 * i + 215] = c1124 * (v586 * c1216);
        e[341 * i + 219] = c1124 * (v661 * c1216);
        e[341 * i + 216] = c1124 * (v709 * c1216);
        e[341 * i + 220] = c1124 * (v782 * c1216);
        e[341 * i + 225] = c1215;
        e[341 * i + 224] = c1124 * (v373 * c1216);
        e[341 * i + 228] = c1124 * (v463 * c1216);
        e[341 * i + 222] = c1124 * (v600 * c1216);
        e[341 * i + 226] = c1124 * (v674 * c1216);
        e[341 * i + 223] = c1124 * (v723 * c1216);
        e[341 * i + 227] = c1124 * (v795 * c1216);
        e[341 * i + 232] = c1244;
        e[341 * i + 231] = c1124 * (v357 * c1245);
        e[341 * i + 235] = c1124 * (v451 * c1245);
        e[341 * i + 229] = c1124 * (v588 * c1245);
        e[341 * i + 233] = c1124 * (v663 * c1245);
        e[341 * i + 230] = c1124 * (v711 * c1245);
        e[341 * i + 234] = c1124 * (v784 * c1245);
        e[341 * i + 239] = c1244;
        e[341 * i + 238] = c1124 * (v375 * c1245);
        e[341 * i + 242] = c1124 * (v465 * c1245);
        e[341 * i + 236] = c1124 * (v602 * c1245);
        e[341 * i + 240] = c1124 * (v676 * c1245);
        e[341 * i + 237] = c1124 * (v725 * c1245);
        e[341 * i + 241] = c1124 * (v797 * c1245);
        e[341 * i + 246] = c1273;
        e[341 * i + 245] = c1124 * (v359 * c1274);
        e[341 * i + 249] = c1124 * (v453 * c1274);
        e[341 * i + 243] = c1124 * (v590 * c1274);
        e[341 * i + 247] = c1124 * (v665 * c1274);
        e[341 * i + 244] = c1124 * (v713 * c1274);
        e[341 * i + 248] = c1124 * (v786 * c1274);
        e[341 * i + 253] = c1273;
        e[341 * i + 252] = c1124 * (v377 * c1274);
        e[341 * i + 256] = c1124 * (v467 * c1274);
        e[341 * i + 250] = c1124 * (v604 * c1274);
        e[341 * i + 254] = c1124 * (v678 * c1274);
        e[341 * i + 251] = c1124 * (v727 * c1274);
        e[341 * i + 255] = c1124 * (v799 * c1274);
        e[341 * i + 259] = v1303;
        e[341 * i + 263] = v1303;
        e[341 * i + 260] = c1306;
        e[341 * i + 257] = v1308;
        e[341 * i + 261] = v1309;
        e[341 * i + 258] = v1311;
        e[341 * i + 262] = v1313;
        e[341 * i + 266] = v1303;
        e[341 * i + 270] = v1303;
        e[341 * i + 267] = c1306;
        e[341 * i + 264] = v1308;
        e[341 * i + 268] = v1309;
        e[341 * i + 265] = v1311;
        e[341 * i + 269] = v1313;
        e[341 * i + 273] = v1317;
        e[341 * i + 277] = v1317;
        e[341 * i + 274] = c1320;
        e[341 * i + 271] = v1322;
        e[341 * i + 275] = v1323;
        e[341 * i + 272] = v1325;
        e[341 * i + 276] = v1327;
        e[341 * i + 280] = v1317;
        e[341 * i + 284] = v1317;
        e[341 * i + 281] = c1320;
        e[341 * i + 278] = v1322;
        e[341 * i + 282] = v1323;
        e[341 * i + 279] = v1325;
        e[341 * i + 283] = v1327;
        e[341 * i + 287] = v1331;
        e[341 * i + 291] = v1331;
        e[341 * i + 288] = c1334;
        e[341 * i + 285] = v1336;
        e[341 * i + 289] = v1337;
        e[341 * i + 286] = v1339;
        e[341 * i + 290] = v1341;
        e[341 * i + 294] = v1331;
        e[341 * i + 298] = v1331;
        e[341 * i + 295] = c1334;
        e[341 * i + 292] = v1336;
        e[341 * i + 296] = v1337;
        e[341 * i + 293] = v1339;
        e[341 * i + 297] = v1341;
        e[341 * i + 301] = v1345;
        e[341 * i + 305] = v1345;
        e[341 * i + 302] = c1348;
        e[341 * i + 299] = v1350;
        e[341 * i + 303] = v1351;
        e[341 * i + 300] = v1353;
        e[341 * i + 304] = v1355;
        e[341 * i + 308] = v1345;
        e[341 * i + 312] = v1345;
        e[341 * i + 309] = c1348;
        e[341 * i + 306] = v1350;
        e[341 * i + 310] = v1351;
        e[341 * i + 307] = v1353;
        e[341 * i + 311] = v1355;
        e[341 * i + 315] = v1359;
        e[341 * i + 319] = v1359;
        e[341 * i + 316] = c1362;
        e[341 * i + 313] = v1364;
        e[341 * i + 317] = v1365;
        e[341 * i + 314] = v1367;
        e[341 * i + 318] = v1369;
        e[341 * i + 322] = v1359;
        e[341 * i + 326] = v1359;
        e[341 * i + 323] = c1362;
        e[341 * i + 320] = v1364;
        e[341 * i + 324] = v1365;
        e[341 * i + 321] = v1367;
        e[341 * i + 325] = v1369;
        e[341 * i + 329] = v1373;
        e[341 * i + 333] = v1373;
        e[341 * i + 330] = c1376;
        e[341 * i + 327] = v1378;
        e[341 * i + 331] = v1379;
        e[341 * i + 328] = v1381;
        e[341 * i + 332] = v1383;
        e[341 * i + 336] = v1373;
        e[341 * i + 340] = v1373;
        e[341 * i + 337] = c1376;
        e[341 * i + 334] = v1378;
        e[341 * i + 338] = v1379;
        e[341 * i + 335] = v1381;
        e[341 * i + 339] = v1383;
    }
}

static void jacobian_7(int n, const double *p, const double *g, double *w, double *e)
{
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
    double *restrict w87 = w + 87 * n;
    double *restrict w88 = w + 88 * n;
    double *restrict w89 = w + 89 * n;
    double *restrict w90 = w + 90 * n;
    double *restrict w91 = w + 91 * n;
    double *restrict w92 = w + 92 * n;
    double *restrict w93 = w + 93 * n;
    double *restrict w94 = w + 94 * n;
    double *restrict w95 = w + 95 * n;
    double *restrict w96 = w + 96 * n;
    double *restrict w97 = w + 97 * n;
    double *restrict w98 = w + 98 * n;
    double *restrict w129 = w + 129 * n;
    double *restrict w130 = w + 130 * n;
    double *restrict w131 = w + 131 * n;
    double *restrict w132 = w + 132 * n;
    double *restrict w133 = w + 133 * n;
    double *restrict w134 = w + 134 * n;
    double *restrict w135 = w + 135 * n;
    double *restrict w136 = w + 136 * n;
    double *restrict w137 = w + 137 * n;
    double *restrict w138 = w + 138 * n;
    double *restrict w139 = w + 139 * n;
    double *restrict w140 = w + 140 * n;
    double *restrict w141 = w + 141 * n;
    double *restrict w142 = w + 142 * n;
    double *restrict w143 = w + 143 * n;
    double *restrict w144 = w + 144 * n;
    double *restrict w145 = w + 145 * n;
    double *restrict w146 = w + 146 * n;
    double *restrict w147 = w + 147 * n;
    double *restrict w148 = w + 148 * n;
    double *restrict w149 = w + 149 * n;
    double *restrict w150 = w + 150 * n;
    double *restrict w151 = w + 151 * n;
    double *restrict w152 = w + 152 * n;
    double *restrict w153 = w + 153 * n;
    double *restrict w154 = w + 154 * n;
    double *restrict w155 = w + 155 * n;
    double *restrict w156 = w + 156 * n;
    double *restrict w157 = w + 157 * n;
    double *restrict w158 = w + 158 * n;
    double *restrict w159 = w + 159 * n;
    double *restrict w160 = w + 160 * n;
    double *restrict w161 = w + 161 * n;
    double *restrict w162 = w + 162 * n;
    double *restrict w163 = w + 163 * n;
    double *restrict w164 = w + 164 * n;
    double *restrict w165 = w + 165 * n;
    double *restrict w166 = w + 166 * n;
    double *restrict w167 = w + 167 * n;
    double *restrict w168 = w + 168 * n;
    double *restrict w169 = w + 169 * n;
    double *restrict w170 = w + 170 * n;
    double *restrict w171 = w + 171 * n;
    double *restrict w172 = w + 172 * n;
    double *restrict w173 = w + 173 * n;
    double *restrict w174 = w + 174 * n;
    double *restrict w175 = w + 175 * n;
    double *restrict w176 = w + 176 * n;
    const double c1 = squared(p[18]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c4 = p[2];
    const double c5 = c4 * c2;
    const double c6 = c3 / c5;
    const double c161 = 0.0625 * c4;
    const double c163 = squared(p[1]);
    const double c164 = c161 * c163;
    const double c165 = c164 * c2;
    const double c166 = c1 / c165;
    const double c170 = squared(c2);
    const double c171 = c4 * c170;
    const double c172 = c164 / c171;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        const double v173 = (c166 * g[7 * i + 5]) * c172;
        const double v306 = ((v173 * w171[i]) - (v173 * w172[i - 1])) + (v173 * w142[i - 1]);
        const double v375 = ((v173 * w173[i]) - (v173 * w174[i - 1])) + (v173 * w156[i - 1]);
        const double v396 = ((v173 * w175[i]) - (v173 * w176[i - 1])) + (v173 * w158[i - 1]);
        e[341 * i + 5] = -(v9 * w69[i - 1]);
        e[341 * i + 32] = v9 * w69[i];
        e[341 * i + 7] = -(v9 * w70[i - 1]);
        e[341 * i + 34] = v9 * w70[i];
        e[341 * i + 9] = -(v9 * w71[i - 1]);
        e[341 * i + 36] = v9 * w71[i];
        e[341 * i + 11] = -(v9 * w72[i - 1]);
        e[341 * i + 38] = v9 * w72[i];
        e[341 * i + 13] = -(v9 * w73[i - 1]);
        e[341 * i + 40] = v9 * w73[i];
        e[341 * i + 15] = -(v9 * w74[i - 1]);
        e[341 * i + 42] = v9 * w74[i];
        e[341 * i + 6] = -(v9 * w75[i - 1]);
        e[341 * i + 33] = v9 * w75[i];
        e[341 * i + 8] = -(v9 * w76[i - 1]);
        e[341 * i + 35] = v9 * w76[i];
        e[341 * i + 10] = -(v9 * w77[i - 1]);
        e[341 * i + 37] = v9 * w77[i];
        e[341 * i + 12] = -(v9 * w78[i - 1]);
        e[341 * i + 39] = v9 * w78[i];
        e[341 * i + 14] = -(v9 * w79[i - 1]);
        e[341 * i + 41] = v9 * w79[i];
        e[341 * i + 16] = -(v9 * w80[i - 1]);
        e[341 * i + 43] = v9 * w80[i];
        e[341 * i + 4] = -(v9 * w81[i - 1]);
        e[341 * i + 31] = (v9 * w81[i]) - (v9 * w82[i - 1]);
        e[341 * i + 58] = v9 * w82[i];
        e[341 * i + 17] = -(v9 * w83[i - 1]);
        e[341 * i + 44] = v9 * w83[i];
        e[341 * i + 19] = -(v9 * w84[i - 1]);
        e[341 * i + 46] = v9 * w84[i];
        e[341 * i + 21] = -(v9 * w85[i - 1]);
        e[341 * i + 48] = v9 * w85[i];
        e[341 * i + 23] = -(v9 * w86[i - 1]);
        e[341 * i + 50] = v9 * w86[i];
        e[341 * i + 25] = -(v9 * w87[i - 1]);
        e[341 * i + 52] = v9 * w87[i];
        e[341 * i + 27] = -(v9 * w88[i - 1]);
        e[341 * i + 54] = v9 * w88[i];
        e[341 * i + 18] = -(v9 * w89[i - 1]);
        e[341 * i + 45] = v9 * w89[i];
        e[341 * i + 20] = -(v9 * w90[i - 1]);
        e[341 * i + 47] = v9 * w90[i];
        e[341 * i + 22] = -(v9 * w91[i - 1]);
        e[341 * i + 49] = v9 * w91[i];
        e[341 * i + 24] = -(v9 * w92[i - 1]);
        e[341 * i + 51] = v9 * w92[i];
        e[341 * i + 26] = -(v9 * w93[i - 1]);
        e[341 * i + 53] = v9 * w93[i];
        e[341 * i + 28] = -(v9 * w94[i - 1]);
        e[341 * i + 55] = v9 * w94[i];
        e[341 * i + 2] = -(v9 * w95[i - 1]);
        e[341 * i + 29] = (v9 * w95[i]) - (v9 * w96[i - 1]);
        e[341 * i + 56] = v9 * w96[i];
        e[341 * i + 3] = -(v9 * w97[i - 1]);
        e[341 * i + 30] = (v9 * w97[i]) - (v9 * w98[i - 1]);
        e[341 * i + 57] = v9 * w98[i];
        e[341 * i + 119] = (v173 * w129[i - 1]) - (v173 * w159[i - 1]);
        e[341 * i + 146] = (v173 * w159[i]) + (v173 * w129[i]);
        e[341 * i + 121] = (v173 * w130[i - 1]) - (v173 * w160[i - 1]);
        e[341 * i + 148] = (v173 * w160[i]) + (v173 * w130[i]);
        e[341 * i + 123] = (v173 * w131[i - 1]) - (v173 * w161[i - 1]);
        e[341 * i + 150] = (v173 * w161[i]) + (v173 * w131[i]);
        e[341 * i + 125] = (v173 * w132[i - 1]) - (v173 * w162[i - 1]);
        e[341 * i + 152] = (v173 * w162[i]) + (v173 * w132[i]);
        e[341 * i + 127] = (v173 * w133[i - 1]) - (v173 * w163[i - 1]);
        e[341 * i + 154] = (v173 * w163[i]) + (v173 * w133[i]);
        e[341 * i + 129] = (v173 * w134[i - 1]) - (v173 * w164[i - 1]);
        e[341 * i + 156] = (v173 * w164[i]) + (v173 * w134[i]);
        e[341 * i + 120] = (v173 * w135[i - 1]) - (v173 * w165[i - 1]);
        e[341 * i + 147] = (v173 * w165[i]) + (v173 * w135[i]);
        e[341 * i + 122] = (v173 * w136[i - 1]) - (v173 * w166[i - 1]);
        e[341 * i + 149] = (v173 * w166[i]) + (v173 * w136[i]);
        e[341 * i + 124] = (v173 * w137[i - 1]) - (v173 * w167[i - 1]);
        e[341 * i + 151] = (v173 * w167[i]) + (v173 * w137[i]);
        e[341 * i + 126] = (v173 * w138[i - 1]) - (v173 * w168[i - 1]);
        e[341 * i + 153] = (v173 * w168[i]) + (v173 * w138[i]);
        e[341 * i + 128] = (v173 * w139[i - 1]) - (v173 * w169[i - 1]);
        e[341 * i + 155] = (v173 * w169[i]) + (v173 * w139[i]);
        e[341 * i + 130] = (v173 * w140[i - 1]) - (v173 * w170[i - 1]);
        e[341 * i + 157] = (v173 * w170[i]) + (v173 * w140[i]);
        e[341 * i + 118] = (v173 * w141[i - 1]) - (v173 * w171[i - 1]);
        e[341 * i + 145] = v306 + (v173 * w141[i]);
        e[341 * i + 172] = (v173 * w172[i]) + (v173 * w142[i]);
        e[341 * i + 131] = v173 * w143[i - 1];
        e[341 * i + 158] = v173 * w143[i];
        e[341 * i + 133] = v173 * w144[i - 1];
        e[341 * i + 160] = v173 * w144[i];
        e[341 * i + 135] = v173 * w145[i - 1];
        e[341 * i + 162] = v173 * w145[i];
        e[341 * i + 137] = v173 * w146[i - 1];
        e[341 * i + 164] = v173 * w146[i];
        e[341 * i + 139] = v173 * w147[i - 1];
        e[341 * i + 166] = v173 * w147[i];
        e[341 * i + 141] = v173 * w148[i - 1];
        e[341 * i + 168] = v173 * w148[i];
        e[341 * i + 132] = v173 * w149[i - 1];
        e[341 * i + 159] = v173 * w149[i];
        e[341 * i + 134] = v173 * w150[i - 1];
        e[341 * i + 161] = v173 * w150[i];
        e[341 * i + 136] = v173 * w151[i - 1];
        e[341 * i + 163] = v173 * w151[i];
        e[341 * i + 138] = v173 * w152[i - 1];
        e[341 * i + 165] = v173 * w152[i];
        e[341 * i + 140] = v173 * w153[i - 1];
        e[341 * i + 167] = v173 * w153[i];
        e[341 * i + 142] = v173 * w154[i - 1];
        e[341 * i + 169] = v173 * w154[i];
        e[341 * i + 116] = (v173 * w155[i - 1]) - (v173 * w173[i - 1]);
        e[341 * i + 143] = v375 + (v173 * w155[i]);
        e[341 * i + 170] = (v173 * w174[i]) + (v173 * w156[i]);
        e[341 * i + 117] = (v173 * w157[i - 1]) - (v173 * w175[i - 1]);
        e[341 * i + 144] = v396 + (v173 * w157[i]);
        e[341 * i + 171] = (v173 * w176[i]) + (v173 * w158[i]);
    }
}

static void jacobian_8(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w99 = w + 99 * n;
    double *restrict w100 = w + 100 * n;
    double *restrict w101 = w + 101 * n;
    double *restrict w102 = w + 102 * n;
    double *restrict w103 = w + 103 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict w112 = w + 112 * n;
    double *restrict w113 = w + 113 * n;
    double *restrict w114 = w + 114 * n;
    double *restrict w115 = w + 115 * n;
    double *restrict w116 = w + 116 * n;
    double *restrict w117 = w + 117 * n;
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    double *restrict w120 = w + 120 * n;
    double *restrict w121 = w + 121 * n;
    double *restrict w122 = w + 122 * n;
    double *restrict w123 = w + 123 * n;
    double *restrict w124 = w + 124 * n;
    double *restrict w125 = w + 125 * n;
    double *restrict w126 = w + 126 * n;
    double *restrict w127 = w + 127 * n;
    double *restrict w128 = w + 128 * n;
    const double c1 = squared(p[18]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    for (int i = 1; i < n - 1; i++) {
        const double v9 = c6 * g[7 * i + 6];
        e[341 * i + 62] = -(v9 * w99[i - 1]);
        e[341 * i + 89] = v9 * w99[i];
        e[341 * i + 64] = -(v9 * w100[i - 1]);
        e[341 * i + 91] = v9 * w100[i];
        e[341 * i + 66] = -(v9 * w101[i - 1]);
        e[341 * i + 93] = v9 * w101[i];
        e[341 * i + 68] = -(v9 * w102[i - 1]);
        e[341 * i + 95] = v9 * w102[i];
        e[341 * i + 70] = -(v9 * w103[i - 1]);
        e[341 * i + 97] = v9 * w103[i];
        e[341 * i + 72] = -(v9 * w104[i - 1]);
        e[341 * i + 99] = v9 * w104[i];
        e[341 * i + 63] = -(v9 * w105[i - 1]);
        e[341 * i + 90] = v9 * w105[i];
        e[341 * i + 65] = -(v9 * w106[i - 1]);
        e[341 * i + 92] = v9 * w106[i];
        e[341 * i + 67] = -(v9 * w107[i - 1]);
        e[341 * i + 94] = v9 * w107[i];
        e[341 * i + 69] = -(v9 * w108[i - 1]);
        e[341 * i + 96] = v9 * w108[i];
        e[341 * i + 71] = -(v9 * w109[i - 1]);
        e[341 * i + 98] = v9 * w109[i];
        e[341 * i + 73] = -(v9 * w110[i - 1]);
        e[341 * i + 100] = v9 * w110[i];
        e[341 * i + 61] = -(v9 * w111[i - 1]);
        e[341 * i + 88] = (v9 * w111[i]) - (v9 * w112[i - 1]);
        e[341 * i + 115] = v9 * w112[i];
        e[341 * i + 74] = -(v9 * w113[i - 1]);
        e[341 * i + 101] = v9 * w113[i];
        e[341 * i + 76] = -(v9 * w114[i - 1]);
        e[341 * i + 103] = v9 * w114[i];
        e[341 * i + 78] = -(v9 * w115[i - 1]);
        e[341 * i + 105] = v9 * w115[i];
        e[341 * i + 80] = -(v9 * w116[i - 1]);
        e[341 * i + 107] = v9 * w116[i];
        e[341 * i + 82] = -(v9 * w117[i - 1]);
        e[341 * i + 109] = v9 * w117[i];
        e[341 * i + 84] = -(v9 * w118[i - 1]);
        e[341 * i + 111] = v9 * w118[i];
        e[341 * i + 75] = -(v9 * w119[i - 1]);
        e[341 * i + 102] = v9 * w119[i];
        e[341 * i + 77] = -(v9 * w120[i - 1]);
        e[341 * i + 104] = v9 * w120[i];
        e[341 * i + 79] = -(v9 * w121[i - 1]);
        e[341 * i + 106] = v9 * w121[i];
        e[341 * i + 81] = -(v9 * w122[i - 1]);
        e[341 * i + 108] = v9 * w122[i];
        e[341 * i + 83] = -(v9 * w123[i - 1]);
        e[341 * i + 110] = v9 * w123[i];
        e[341 * i + 85] = -(v9 * w124[i - 1]);
        e[341 * i + 112] = v9 * w124[i];
        e[341 * i + 59] = -(v9 * w125[i - 1]);
        e[341 * i + 86] = (v9 * w125[i]) - (v9 * w126[i - 1]);
        e[341 * i + 113] = v9 * w126[i];
        e[341 * i + 60] = -(v9 * w127[i - 1]);
        e[341 * i + 87] = (v9 * w127[i]) - (v9 * w128[i - 1]);
        e[341 * i + 114] = v9 * w128[i];
    }
}

static void jacobian_9(int n, const double *p, const double *g, double *w, double *e)
{
    double *restrict w99 = w + 99 * n;
    double *restrict w100 = w + 100 * n;
    double *restrict w101 = w + 101 * n;
    double *restrict w102 = w + 102 * n;
    double *restrict w103 = w + 103 * n;
    double *restrict w104 = w + 104 * n;
    double *restrict w105 = w + 105 * n;
    double *restrict w106 = w + 106 * n;
    double *restrict w107 = w + 107 * n;
    double *restrict w108 = w + 108 * n;
    double *restrict w109 = w + 109 * n;
    double *restrict w110 = w + 110 * n;
    double *restrict w111 = w + 111 * n;
    double *restrict w112 = w + 112 * n;
    double *restrict w113 = w + 113 * n;
    double *restrict w114 = w + 114 * n;
    double *restrict w115 = w + 115 * n;
    double *restrict w116 = w + 116 * n;
    double *restrict w117 = w + 117 * n;
    double *restrict w118 = w + 118 * n;
    double *restrict w119 = w + 119 * n;
    double *restrict w120 = w + 120 * n;
    double *restrict w121 = w + 121 * n;
    double *restrict w122 = w + 122 * n;
    double *restrict w123 = w + 123 * n;
    double *restrict w124 = w + 124 * n;
    double *restrict w125 = w + 125 * n;
    double *restrict w126 = w + 126 * n;
    double *restrict w127 = w + 127 * n;
    double *restrict w128 = w + 128 * n;
    const double c1 = squared(p[18]);
    const double c2 = p[0];
    const double c3 = c1 / c2;
    const double c5 = p[2] * c2;
    const double c6 = c3 / c5;
    const int i = 0;
    const double v9 = c6 * g[7 * i + 6];
    e[341 * i + 89] = v9 * w99[i];
    e[341 * i + 91] = v9 * w100[i];
    e[341 * i + 93] = v9 * w101[i];
    e[341 * i + 95] = v9 * w102[i];
    e[341 * i + 97] = v9 * w103[i];
    e[341 * i + 99] = v9 * w104[i];
    e[341 * i + 90] = v9 * w105[i];
    e[341 * i + 92] = v9 * w106[i];
    e[341 * i + 94] = v9 * w107[i];
    e[341 * i + 96] = v9 * w108[i];
    e[341 * i + 98] = v9 * w109[i];
    e[341 * i + 100] = v9 * w110[i];
    e[341 * i + 88] = v9 * w111[i];
    e[341 * i + 115] = v9 * w112[i];
    e[341 * i + 101] = v9 * w113[i];
    e[341 * i + 103] = v9 * w114[i];
    e[341 * i + 105] = v9 * w115[i];
    e[341 * i + 107] = v9 * w116[i];
    e[341 * i + 109] = v9 * w117[i];
    e[341 * i + 111] = v9 * w118[i];
    e[341 * i + 102] = v9 * w119[i];
    e[341 * i + 104] = v9 * w120[i];
    e[341 * i + 106] = v9 * w121[i];
    e[341 * i + 108] = v9 * w122[i];
    e[341 * i + 110] = v9 * w123[i];
    e[341 * i + 112] = v9 * w124[i];
    e[341 * i + 86] = v9 * w125[i];
    e[341 * i + 113] = v9 * w126[i];
    e[341 * i + 87] = v9 * w127[i];
    e[341 * i + 114] = v9 * w128[i];
    (void)n;
}

static void work_0(int n, const double *p, const double *g, const double *y, double *w, double *q)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c2 = p[6];
    const double c6 = (-0.5) * p[1];
    const double c11 = p[0];
    const double c12 = 1.0 / c11;
    const double c45 = 0.9 * c2;
    const double c47 = 2.0 * p[4];
    const double c48 = 2.0 + c47;
    const double c49 = c45 / c48;
    const double c61 = 1e-12 * c2;
    const double c62 = squared(c61);
    const double c65 = 1.0 / p[7];
    const double c67 = p[8];
    const double c73 = 0.9 * c67;
    const double c74 = c73 / c48;
    const double c81 = 1e-12 * c67;
    const double c82 = squared(c81);
    const double c85 = 1.0 / p[9];
    const double c88 = p[10];
    const double c94 = 0.9 * c88;
    const double c95 = c94 / c48;
    const double c102 = 1e-12 * c88;
    const double c103 = squared(c102);
    const double c106 = 1.0 / p[11];
    const double c109 = p[12];
    const double c115 = 0.9 * c109;
    const double c116 = c115 / c48;
    const double c123 = 1e-12 * c109;
    const double c124 = squared(c123);
    const double c127 = 1.0 / p[13];
    const double c130 = p[14];
    const double c136 = 0.9 * c130;
    const double c137 = c136 / c48;
    const double c144 = 1e-12 * c130;
    const double c145 = squared(c144);
    const double c148 = 1.0 / p[15];
    const double c151 = p[16];
    const double c157 = 0.9 * c151;
    const double c158 = c157 / c48;
    const double c165 = 1e-12 * c151;
    const double c166 = squared(c165);
    const double c169 = 1.0 / p[17];
    const double c263 = p[18];
    const double c265 = c11 / c263;
    const double c266 = squared(c265);
    const double c267 = p[2] * c266;
    const double c268 = c263 / c267;
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
        const double v36 = ((-0.4999999999999998) * v15) * v35;
        const double v39 = log(v32);
        const double v53 = ((v29 * v24) - (v20 * v30)) / v32;
        const double v59 = squared((c2 * ((v36 - y[29 * i + 5]) + v39))) + (3.0 * squared((c49 * (v53 - y[29 * i + 17]))));
        const double v80 = squared((c67 * ((v36 - y[29 * i + 7]) + v39))) + (3.0 * squared((c74 * (v53 - y[29 * i + 19]))));
        const double v101 = squared((c88 * ((v36 - y[29 * i + 9]) + v39))) + (3.0 * squared((c95 * (v53 - y[29 * i + 21]))));
        const double v108 = ((larger(v59, c62) * c65) + (larger(v80, c82) * c85)) + (larger(v101, c103) * c106);
        const double v122 = squared((c109 * ((v36 - y[29 * i + 11]) + v39))) + (3.0 * squared((c116 * (v53 - y[29 * i + 23]))));
        const double v143 = squared((c130 * ((v36 - y[29 * i + 13]) + v39))) + (3.0 * squared((c137 * (v53 - y[29 * i + 25]))));
        const double v150 = (v108 + (larger(v122, c124) * c127)) + (larger(v143, c145) * c148);
        const double v164 = squared((c151 * ((v36 - y[29 * i + 15]) + v39))) + (3.0 * squared((c158 * (v53 - y[29 * i + 27]))));
        const double v176 = (0.5000000000000001 * v15) * v35;
        const double v187 = squared((c2 * ((v176 - y[29 * i + 6]) + v39))) + (3.0 * squared((c49 * (v53 - y[29 * i + 18]))));
        const double v200 = squared((c67 * ((v176 - y[29 * i + 8]) + v39))) + (3.0 * squared((c74 * (v53 - y[29 * i + 20]))));
        const double v214 = squared((c88 * ((v176 - y[29 * i + 10]) + v39))) + (3.0 * squared((c95 * (v53 - y[29 * i + 22]))));
        const double v217 = ((larger(v187, c62) * c65) + (larger(v200, c82) * c85)) + (larger(v214, c103) * c106);
        const double v228 = squared((c109 * ((v176 - y[29 * i + 12]) + v39))) + (3.0 * squared((c116 * (v53 - y[29 * i + 24]))));
        const double v242 = squared((c130 * ((v176 - y[29 * i + 14]) + v39))) + (3.0 * squared((c137 * (v53 - y[29 * i + 26]))));
        const double v245 = (v217 + (larger(v228, c124) * c127)) + (larger(v242, c145) * c148);
        const double v256 = squared((c151 * ((v176 - y[29 * i + 16]) + v39))) + (3.0 * squared((c158 * (v53 - y[29 * i + 28]))));
        const double v261 = (0.5 * (v150 + (larger(v164, c166) * c169))) + (0.4999999999999999 * (v245 + (larger(v256, c166) * c169)));
        q[0] += (g[7 * i + 1] * v261) * c268;
    }
}

static void work_slope_0(int n, const double *p, const double *g, const double *y, double *w, double *s)
{
    double *restrict w0 = w;
    double *restrict w1 = w + 1 * n;
    double *restrict w2 = w + 2 * n;
    const double c0 = p[6];
    const double c4 = (-0.5) * p[1];
    const double c10 = p[0];
    const double c11 = 1.0 / c10;
    const double c44 = 1e-12 * c0;
    const double c45 = squared(c44);
    const double c49 = 0.9 * c0;
    const double c51 = 2.0 * p[4];
    const double c52 = 2.0 + c51;
    const double c53 = c49 / c52;
    const double c69 = p[18];
    const double c71 = c10 / c69;
    const double c72 = squared(c71);
    const double c73 = p[2] * c72;
    const double c74 = c69 / c73;
    const double c78 = 1.0 / p[7];
    const double c84 = p[8];
    const double c90 = 1e-12 * c84;
    const double c91 = squared(c90);
    const double c93 = 0.9 * c84;
    const double c94 = c93 / c52;
    const double c106 = 1.0 / p[9];
    const double c112 = p[10];
    const double c118 = 1e-12 * c112;
    const double c119 = squared(c118);
    const double c121 = 0.9 * c112;
    const double c122 = c121 / c52;
    const double c134 = 1.0 / p[11];
    const double c140 = p[12];
    const double c146 = 1e-12 * c140;
    const double c147 = squared(c146);
    const double c149 = 0.9 * c140;
    const double c150 = c149 / c52;
    const double c162 = 1.0 / p[13];
    const double c168 = p[14];
    const double c174 = 1e-12 * c168;
    const double c175 = squared(c174);
    const double c177 = 0.9 * c168;
    const double c178 = c177 / c52;
    const double c190 = 1.0 / p[15];
    const double c196 = p[16];
    const double c202 = 1e-12 * c196;
    const double c203 = squared(c202);
    const double c205 = 0.9 * c196;
    const double c206 = c205 / c52;
    const double c218 = 1.0 / p[17];
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
        const double v36 = ((-0.4999999999999998) * v14) * v35;
        const double v39 = log(v32);
        const double v41 = c0 * ((v36 - y[29 * i + 5]) + v39);
        const double v57 = 1.0 / v32;
        const double v58 = ((v29 * v24) - (v19 * v30)) * v57;
        const double v61 = c53 * (v58 - y[29 * i + 17]);
        const double v64 = squared(v41) + (3.0 * squared(v61));
        const double v65 = (double)(c45 <= v64);
        const double v75 = g[7 * i + 1] * c74;
        const double v76 = 0.5 * v75;
        const double v80 = (v65 / (v65 + (double)(v64 <= c45))) * (v76 * c78);
        const double v82 = c0 * ((2.0 * v41) * v80);
        const double v88 = c84 * ((v36 - y[29 * i + 7]) + v39);
        const double v97 = c94 * (v58 - y[29 * i + 19]);
        const double v100 = squared(v88) + (3.0 * squared(v97));
        const double v101 = (double)(c91 <= v100);
        const double v108 = (v101 / (v101 + (double)(v100 <= c91))) * (v76 * c106);
        const double v110 = c84 * ((2.0 * v88) * v108);
        const double v116 = c112 * ((v36 - y[29 * i + 9]) + v39);
        const double v125 = c122 * (v58 - y[29 * i + 21]);
        const double v128 = squared(v116) + (3.0 * squared(v125));
        const double v129 = (double)(c119 <= v128);
        const double v136 = (v129 / (v129 + (double)(v128 <= c119))) * (v76 * c134);
        const double v138 = c112 * ((2.0 * v116) * v136);
        const double v144 = c140 * ((v36 - y[29 * i + 11]) + v39);
        const double v153 = c150 * (v58 - y[29 * i + 23]);
        const double v156 = squared(v144) + (3.0 * squared(v153));
        const double v157 = (double)(c147 <= v156);
        const double v164 = (v157 / (v157 + (double)(v156 <= c147))) * (v76 * c162);
        const double v166 = c140 * ((2.0 * v144) * v164);
        const double v172 = c168 * ((v36 - y[29 * i + 13]) + v39);
        const double v181 = c178 * (v58 - y[29 * i + 25]);
        const double v184 = squared(v172) + (3.0 * squared(v181));
        const double v185 = (double)(c175 <= v184);
        const double v192 = (v185 / (v185 + (double)(v184 <= c175))) * (v76 * c190);
        const double v194 = c168 * ((2.0 * v172) * v192);
        const double v200 = c196 * ((v36 - y[29 * i + 15]) + v39);
        const double v209 = c206 * (v58 - y[29 * i + 27]);
        const double v212 = squared(v200) + (3.0 * squared(v209));
        const double v213 = (double)(c203 <= v212);
        const double v220 = (v213 / (v213 + (double)(v212 <= c203))) * (v76 * c218);
        const double v222 = c196 * ((2.0 * v200) * v220);
        const double v226 = (0.5000000000000001 * v14) * v35;
        const double v230 = c0 * ((v226 - y[29 * i + 6]) + v39);
        const double v235 = c53 * (v58 - y[29 * i + 18]);
        const double v238 = squared(v230) + (3.0 * squared(v235));
        const double v239 = (double)(c45 <= v238);
        const double v244 = 0.4999999999999999 * v75;
        const double v246 = (v239 / (v239 + (double)(v238 <= c45))) * (v244 * c78);
        const double v248 = c0 * ((2.0 * v230) * v246);
        const double v253 = c84 * ((v226 - y[29 * i + 8]) + v39);
        const double v258 = c94 * (v58 - y[29 * i + 20]);
        const double v261 = squared(v253) + (3.0 * squared(v258));
        const double v262 = (double)(c91 <= v261);
        const double v267 = (v262 / (v262 + (double)(v261 <= c91))) * (v244 * c106);
        const double v269 = c84 * ((2.0 * v253) * v267);
        const double v274 = c112 * ((v226 - y[29 * i + 10]) + v39);
        const double v279 = c122 * (v58 - y[29 * i + 22]);
        const double v282 = squared(v274) + (3.0 * squared(v279));
        const double v283 = (double)(c119 <= v282);
        const double v288 = (v283 / (v283 + (double)(v282 <= c119))) * (v244 * c134);
        const double v290 = c112 * ((2.0 * v274) * v288);
        const double v295 = c140 * ((v226 - y[29 * i + 12]) + v39);
        const double v300 = c150 * (v58 - y[29 * i + 24]);
        const double v303 = squared(v295) + (3.0 * squared(v300));
        const double v304 = (double)(c147 <= v303);
        const double v309 = (v304 / (v304 + (double)(v303 <= c147))) * (v244 * c162);
        const double v311 = c140 * ((2.0 * v295) * v309);
        const double v316 = c168 * ((v226 - y[29 * i + 14]) + v39);
        const double v321 = c178 * (v58 - y[29 * i + 26]);
        const double v324 = squared(v316) + (3.0 * squared(v321));
        const double v325 = (double)(c175 <= v324);
        const double v330 = (v325 / (v325 + (double)(v324 <= c175))) * (v244 * c190);
        const double v332 = c168 * ((2.0 * v316) * v330);
        const double v337 = c196 * ((v226 - y[29 * i + 16]) + v39);
        const double v342 = c206 * (v58 - y[29 * i + 28]);
        const double v345 = squared(v337) + (3.0 * squared(v342));
        const double v346 = (double)(c203 <= v345);
        const double v351 = (v346 / (v346 + (double)(v345 <= c203))) * (v244 * c218);
        const double v353 = c196 * ((2.0 * v337) * v351);
        const double v356 = v58 * v57;
        const double v360 = c206 * ((2.0 * v342) * (3.0 * v351));
        const double v363 = v226 * v35;
        const double v364 = v363 * v353;
        const double v369 = 1.0 / (2.0 * v33);
        const double v371 = (((v353 * v57) - (v356 * v360)) - (v33 * v364)) - ((v32 * v364) * v369);
        const double v375 = c178 * ((2.0 * v321) * (3.0 * v330));
        const double v380 = v363 * v332;
        const double v385 = (((v371 - (v356 * v375)) + (v332 * v57)) - (v33 * v380)) - ((v32 * v380) * v369);
        const double v389 = c150 * ((2.0 * v300) * (3.0 * v309));
        const double v394 = v363 * v311;
        const double v399 = (((v385 - (v356 * v389)) + (v311 * v57)) - (v33 * v394)) - ((v32 * v394) * v369);
        const double v403 = c122 * ((2.0 * v279) * (3.0 * v288));
        const double v408 = v363 * v290;
        const double v413 = (((v399 - (v356 * v403)) + (v290 * v57)) - (v33 * v408)) - ((v32 * v408) * v369);
        const double v417 = c94 * ((2.0 * v258) * (3.0 * v267));
        const double v422 = v363 * v269;
        const double v427 = (((v413 - (v356 * v417)) + (v269 * v57)) - (v33 * v422)) - ((v32 * v422) * v369);
        const double v431 = c53 * ((2.0 * v235) * (3.0 * v246));
        const double v436 = v363 * v248;
        const double v441 = (((v427 - (v356 * v431)) + (v248 * v57)) - (v33 * v436)) - ((v32 * v436) * v369);
        const double v445 = c206 * ((2.0 * v209) * (3.0 * v220));
        const double v450 = v36 * v35;
        const double v451 = v450 * v222;
        const double v456 = (((v441 - (v356 * v445)) + (v222 * v57)) - (v33 * v451)) - ((v32 * v451) * v369);
        const double v460 = c178 * ((2.0 * v181) * (3.0 * v192));
        const double v465 = v450 * v194;
        const double v470 = (((v456 - (v356 * v460)) + (v194 * v57)) - (v33 * v465)) - ((v32 * v465) * v369);
        const double v474 = c150 * ((2.0 * v153) * (3.0 * v164));
        const double v479 = v450 * v166;
        const double v484 = (((v470 - (v356 * v474)) + (v166 * v57)) - (v33 * v479)) - ((v32 * v479) * v369);
        const double v488 = c122 * ((2.0 * v125) * (3.0 * v136));
        const double v493 = v450 * v138;
        const double v498 = (((v484 - (v356 * v488)) + (v138 * v57)) - (v33 * v493)) - ((v32 * v493) * v369);
        const double v502 = c94 * ((2.0 * v97) * (3.0 * v108));
        const double v507 = v450 * v110;
        const double v512 = (((v498 - (v356 * v502)) + (v110 * v57)) - (v33 * v507)) - ((v32 * v507) * v369);
        const double v516 = c53 * ((2.0 * v61) * (3.0 * v80));
        const double v521 = v450 * v82;
        const double v526 = (((v512 - (v356 * v516)) + (v82 * v57)) - (v33 * v521)) - ((v32 * v521) * v369);
        const double v534 = (((v360 * v57) + (v375 * v57)) + (v389 * v57)) + (v403 * v57);
        const double v542 = (((v534 + (v417 * v57)) + (v431 * v57)) + (v445 * v57)) + (v460 * v57);
        const double v550 = (((v542 + (v474 * v57)) + (v488 * v57)) + (v502 * v57)) + (v516 * v57);
        const double v558 = (v24 * ((v29 * v526) - (v19 * v550))) - (v30 * ((v29 * v550) + (v19 * v526)));
        const double v559 = 0.5 * v558;
        const double v566 = (c4 * (0.5000000000000001 * (v353 * v35))) + (c4 * (0.5000000000000001 * (v332 * v35)));
        const double v574 = (v566 + (c4 * (0.5000000000000001 * (v311 * v35)))) + (c4 * (0.5000000000000001 * (v290 * v35)));
        const double v582 = (v574 + (c4 * (0.5000000000000001 * (v269 * v35)))) + (c4 * (0.5000000000000001 * (v248 * v35)));
        const double v590 = (v582 + (c4 * ((-0.4999999999999998) * (v222 * v35)))) + (c4 * ((-0.4999999999999998) * (v194 * v35)));
        const double v598 = (v590 + (c4 * ((-0.4999999999999998) * (v166 * v35)))) + (c4 * ((-0.4999999999999998) * (v138 * v35)));
        const double v606 = (v598 + (c4 * ((-0.4999999999999998) * (v110 * v35)))) + (c4 * ((-0.4999999999999998) * (v82 * v35)));
        const double v607 = v12 * v606;
        const double v625 = ((v24 * v526) - (v30 * v550)) * v9;
        const double v630 = ((v24 * v550) + (v30 * v526)) * v9;
        s[29 * i + 5] += -v82;
        s[29 * i + 7] += -v110;
        s[29 * i + 9] += -v138;
        s[29 * i + 11] += -v166;
        s[29 * i + 13] += -v194;
        s[29 * i + 15] += -v222;
        s[29 * i + 6] += -v248;
        s[29 * i + 8] += -v269;
        s[29 * i + 10] += -v290;
        s[29 * i + 12] += -v311;
        s[29 * i + 14] += -v332;
        s[29 * i + 16] += -v353;
        s[29 * i + 4] += v559 - v607;
        s[29 * i + 33] += v559 + v607;
        s[29 * i + 17] += -v516;
        s[29 * i + 19] += -v502;
        s[29 * i + 21] += -v488;
        s[29 * i + 23] += -v474;
        s[29 * i + 25] += -v460;
        s[29 * i + 27] += -v445;
        s[29 * i + 18] += -v431;
        s[29 * i + 20] += -v417;
        s[29 * i + 22] += -v403;
        s[29 * i + 24] += -v389;
        s[29 * i + 26] += -v375;
        s[29 * i + 28] += -v360;
        s[29 * i] += -v625;
        s[29 * i + 29] += v625;
        s[29 * i + 1] += -v630;
        s[29 * i + 30] += v630;
    }
}

static int rates(const softcat_filament *filament, double t, const double *y, double *f,
                 double *w)
{
    const int n = filament->sites;
    const double *p = filament->parameters;
    const double *g = filament->places;
    (void)t;
    for (int k = 0; k < n * 29; k++) f[k] = 0.0;
    rates_0(n, y, f);
    rates_1(n, y, f);
    rates_2(n, y, w);
    rates_3(n, y, w);
    rates_4(n, w);
    rates_5(n, g, w);
    rates_6(n, p, g, y, w, f);
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
    for (int k = 0; k < n * 341; k++) e[k] = 0.0;
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
    for (int k = 0; k < n * 87; k++) s[k] = 0.0;
    work_slope_0(n, p, g, y, w, s);
    return SOFTCAT_SOLVED;
}

static const int rate[] = {2, 3, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
static const int differential[] = {1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int held_first[] = {1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
static const int held_last[] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int row[] = {0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 11, 11, 11, 11, 12, 12, 12, 12, 12, 12, 12, 13, 13, 13, 13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15, 15, 16, 16, 16, 16, 16, 16, 16, 17, 17, 17, 17, 17, 17, 17, 18, 18, 18, 18, 18, 18, 18, 19, 19, 19, 19, 19, 19, 19, 20, 20, 20, 20, 20, 20, 20, 21, 21, 21, 21, 21, 21, 21, 22, 22, 22, 22, 22, 22, 22, 23, 23, 23, 23, 23, 23, 23, 24, 24, 24, 24, 24, 24, 24, 25, 25, 25, 25, 25, 25, 25, 26, 26, 26, 26, 26, 26, 26, 27, 27, 27, 27, 27, 27, 27, 28, 28, 28, 28, 28, 28, 28};
static const int offset[] = {0, 0, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1};
static const int column[] = {2, 3, 0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 0, 1, 4, 0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 0, 1, 4, 0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 0, 1, 4, 0, 1, 4, 5, 0, 1, 4, 0, 1, 4, 6, 0, 1, 4, 0, 1, 4, 7, 0, 1, 4, 0, 1, 4, 8, 0, 1, 4, 0, 1, 4, 9, 0, 1, 4, 0, 1, 4, 10, 0, 1, 4, 0, 1, 4, 11, 0, 1, 4, 0, 1, 4, 12, 0, 1, 4, 0, 1, 4, 13, 0, 1, 4, 0, 1, 4, 14, 0, 1, 4, 0, 1, 4, 15, 0, 1, 4, 0, 1, 4, 16, 0, 1, 4, 0, 1, 4, 17, 0, 1, 4, 0, 1, 4, 18, 0, 1, 4, 0, 1, 4, 19, 0, 1, 4, 0, 1, 4, 20, 0, 1, 4, 0, 1, 4, 21, 0, 1, 4, 0, 1, 4, 22, 0, 1, 4, 0, 1, 4, 23, 0, 1, 4, 0, 1, 4, 24, 0, 1, 4, 0, 1, 4, 25, 0, 1, 4, 0, 1, 4, 26, 0, 1, 4, 0, 1, 4, 27, 0, 1, 4, 0, 1, 4, 28, 0, 1, 4};

const softcat_model softcat_filament_model = {
    29, 24, 19, 7, 177, 341, 3, 0,
    rate, differential, held_first, held_last, row, offset, column,
    rates, jacobian, work, work_slope,
};

static const char *const described_parameters[] = {
    "rest_length", "thickness", "density", "gravity", "poisson", "surface_tension",
    "mode_1_youngs_modulus", "mode_1_viscosity", "mode_2_youngs_modulus", "mode_2_viscosity",
    "mode_3_youngs_modulus", "mode_3_viscosity", "mode_4_youngs_modulus", "mode_4_viscosity",
    "mode_5_youngs_modulus", "mode_5_viscosity", "mode_6_youngs_modulus", "mode_6_viscosity",
    "time_scale"};
static const char *const described_units[] = {
    "m", "m", "kg/m^3", "m/s^2", "1", "N/m", "Pa", "Pa*s", "Pa", "Pa*s", "Pa", "Pa*s", "Pa",
    "Pa*s", "Pa", "Pa*s", "Pa", "Pa*s", "s"};
static const softcat_range described_ranges[] = {
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE, SOFTCAT_POISSON,
    SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE,
    SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_POSITIVE, SOFTCAT_NOT_NEGATIVE};
static const double described_values[] = {
    0.1, 0.004, 780.0, 9.81, 0.45, 0.028, 176000.0, 1760.0, 80100.0, 8010.0, 29400.0, 29400.0,
    5670.0, 56700.0, 540.0, 54000.0, 3.0, 3000.0, 0.10096375546923045};
static const char *const described_slots[] = {
    "x", "y", "u", "v", "psi", "axial_0", "axial_1", "axial_0_mode2", "axial_1_mode2",
    "axial_0_mode3", "axial_1_mode3", "axial_0_mode4", "axial_1_mode4", "axial_0_mode5",
    "axial_1_mode5", "axial_0_mode6", "axial_1_mode6", "shear_0", "shear_1", "shear_0_mode2",
    "shear_1_mode2", "shear_0_mode3", "shear_1_mode3", "shear_0_mode4", "shear_1_mode4",
    "shear_0_mode5", "shear_1_mode5", "shear_0_mode6", "shear_1_mode6"};
static const softcat_place described_places[] = {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS};
static const int described_on_cells[] = {
    0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const double described_mean[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double described_bending[] = {
    0.0, 0.0, 0.0, 0.0, 0.0, (-0.4999999999999998), 0.5000000000000001, (-0.4999999999999998),
    0.5000000000000001, (-0.4999999999999998), 0.5000000000000001, (-0.4999999999999998),
    0.5000000000000001, (-0.4999999999999998), 0.5000000000000001, (-0.4999999999999998),
    0.5000000000000001, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

const softcat_structure softcat_filament_structure = {
    .model = &softcat_filament_model,
    .title = "Thread of molten polyethylene with six relaxation times",
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
    .time_scale = 18,
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
    .duration = 10.0,
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
