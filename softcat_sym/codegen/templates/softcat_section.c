#include "softcat_section.h"

#include <math.h>
#include <string.h>

enum { MOST_FIBRES = 1000, LEAST_IN_HALVES = 6, OF_SUMS = 200, OF_PRANDTL = 60 };

static const double pi = 3.14159265358979323846;

static double squared(double x)
{
    return x * x;
}

/* Gauss and Legendre on -1 ... 1, by Newton's method; the weights sum to `sum`. */
static void legendre(int count, double sum, double *nodes, double *weights)
{
    for (int i = 0; i < (count + 1) / 2; i++) {
        double x = 2 * i + 1 == count ? 0.0 : cos(pi * (i + 0.75) / (count + 0.5)), slope = 1.0;
        for (int pass = 0, near = 0; pass < 50 && near < 2; pass++) {
            double before = 1.0, now = x;
            for (int k = 2; k <= count; k++) {
                double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
                before = now;
                now = next;
            }
            slope = count * (before - x * now) / (1.0 - x * x);
            near += fabs(now / slope) < 1e-14;
            if (2 * i + 1 != count) x -= now / slope;
        }
        nodes[i] = -x;
        nodes[count - 1 - i] = x;
        weights[i] = weights[count - 1 - i] = sum / ((1.0 - x * x) * squared(slope));
    }
}

/* Chebyshev's second kind: the width of a circle. */
static void chebyshev(int count, double *nodes, double *weights)
{
    for (int i = 0; i < count; i++) {
        double angle = pi * (count - i) / (count + 1);
        nodes[i] = cos(angle);
        weights[i] = 2.0 / (count + 1) * squared(sin(angle));
    }
}

/* Value of the last polynomial of a three-term recurrence at x; how many of all change their sign
 * between neighbours, and their squares' sum when all have the same norm. */
typedef struct polynomial {
    double sum;
    int below; /* zeros below x */
} polynomial;

static polynomial look(int count, const double *centre, const double *spread, double x)
{
    polynomial found = {0.0, 0};
    double ratio = 1.0, value = 1.0;
    for (int k = 0; k < count; k++) {
        found.sum += squared(value);
        ratio = x - centre[k] - (k ? spread[k] / ratio : 0.0);
        if (ratio == 0.0) ratio = 1e-300;
        found.below += ratio > 0.0;
        if (k + 1 < count) value *= ratio / sqrt(spread[k + 1]);
    }
    return found;
}

/* Gauss's rule on 0 ... 1 of the width of half a circle, which is OF_SUMS masses: its recurrence
 * (Stieltjes), zeros by bisection, weights by Christoffel. `room` [4 * OF_SUMS + 2 * count]. */
static void half_circle(int count, double *nodes, double *weights, double *room)
{
    double *places = room, *masses = places + OF_SUMS, *before = masses + OF_SUMS;
    double *now = before + OF_SUMS, *centre = now + OF_SUMS, *spread = centre + count, norm = 0.0;
    legendre(OF_SUMS, 1.0, places, masses);
    for (int i = 0; i < OF_SUMS; i++) {
        double angle = (places[i] + 1.0) * pi / 4.0;
        places[i] = cos(angle);
        masses[i] *= squared(sin(angle));
        norm += masses[i];
        before[i] = 0.0;
        now[i] = 1.0;
    }
    spread[0] = 0.0;
    for (int k = 0; k < count; k++) {
        double square = 0.0, moment = 0.0, next = 0.0;
        for (int i = 0; i < OF_SUMS; i++) {
            square += masses[i] * squared(now[i]);
            moment += masses[i] * places[i] * squared(now[i]);
        }
        centre[k] = moment / square;
        for (int i = 0; i < OF_SUMS; i++) {
            double following = (places[i] - centre[k]) * now[i] - spread[k] * before[i];
            next += masses[i] * squared(following);
            before[i] = now[i];
            now[i] = following;
        }
        if (k + 1 < count) spread[k + 1] = next / square;
    }
    for (int i = 0; i < count; i++) {
        double low = 0.0, high = 1.0, middle = 0.5;
        while (middle > low && middle < high) {
            if (look(count, centre, spread, middle).below > i) high = middle;
            else low = middle;
            middle = 0.5 * (low + high);
        }
        nodes[i] = middle;
        weights[i] = norm / look(count, centre, spread, middle).sum;
    }
}

/* A rule in either half of the section. */
static void in_halves(int circle, int count, double *nodes, double *weights, double *room)
{
    int half = count / 2;
    if (circle) {
        half_circle(half, nodes + half, weights + half, room);
    } else {
        legendre(half, 0.5, nodes + half, weights + half);
        for (int i = half; i < count; i++) nodes[i] = 0.5 * (nodes[i] + 1.0);
    }
    for (int i = 0; i < half; i++) {
        nodes[i] = -nodes[count - 1 - i];
        weights[i] = weights[count - 1 - i];
    }
}

/* Rings of a circle with as many points each, every second one turned by half a step. */
static void rings(int count, int points, double *tables)
{
    double *Y = tables, *Z = Y + points, *W_2 = Z + points, *W_3 = W_2 + points;
    double *weight = W_3 + points;
    int angles = points / count;
    legendre(count, 1.0, Y, weight);
    for (int i = points - 1; i >= 0; i--) { /* from behind: rings stand where points will */
        int ring = i / angles;
        double radius = sqrt(0.5 * (Y[ring] + 1.0));
        double angle = 2.0 * pi / angles * (i % angles + 0.5 * (ring % 2));
        weight[i] = weight[ring] / angles;
        W_2[i] = -radius * sin(angle);
        W_3[i] = radius * cos(angle);
    }
    for (int i = 0; i < points; i++) {
        Y[i] = W_3[i];
        Z[i] = -W_2[i];
    }
}

/* What a twist shears at a point of a rectangle: the slope of Prandtl's function. */
static void prandtl(double Y, double Z, double width, double *W_2, double *W_3)
{
    *W_2 = 0.0;
    *W_3 = 2.0 * Y;
    for (int n = 0; n < OF_PRANDTL; n++) {
        double odd = 2 * n + 1, k = 0.5 * odd * pi;
        double ak = (n % 2 ? -32.0 : 32.0) / (odd * pi * squared(odd * pi)) * k;
        double grown = exp(k * (fabs(Z) - width)), faded = exp(-k * (fabs(Z) + width));
        double below = 1.0 + exp(-2.0 * k * width), sign = Z > 0.0 ? 1.0 : Z < 0.0 ? -1.0 : 0.0;
        *W_2 -= ak * cos(k * Y) * sign * (grown - faded) / below;
        *W_3 -= ak * sin(k * Y) * (grown + faded) / below;
    }
}

/* A rectangle, scaled so that its torsional stiffness is exact. */
static void warping(int points, double width, double *tables, double *room)
{
    double *Y = tables, *Z = Y + points, *W_2 = Z + points, *W_3 = W_2 + points;
    double *weight = W_3 + points, sum = 0.0, series = 0.0;
    int count = (int)(sqrt(points) + 0.5);
    double *nodes = room, *share = nodes + count;
    legendre(count, 1.0, nodes, share);
    for (int i = 0; i < points; i++) {
        Y[i] = nodes[i / count];
        Z[i] = width * nodes[i % count];
        weight[i] = share[i / count] * share[i % count];
        prandtl(Y[i], Z[i], width, W_2 + i, W_3 + i);
        sum += weight[i] * (squared(W_2[i]) + squared(W_3[i]));
    }
    for (int n = 0; n < OF_PRANDTL; n++) {
        double k = (n + 0.5) * pi;
        series += tanh(k * width) / pow(k, 5.0);
    }
    double scale = sqrt(4.0 / 3.0 * (1.0 - 6.0 / width * series) / sum);
    for (int i = 0; i < points; i++) {
        W_2[i] *= scale;
        W_3[i] *= scale;
    }
}

static int rings_of(int fibres)
{
    int count = (int)(sqrt(0.6 * fibres) + 0.5);
    return count > 1 ? count : 1;
}

size_t softcat_rule_room(softcat_section section, int points)
{
    if (section == SOFTCAT_WARPING) return 2 * (size_t)points;
    return section == SOFTCAT_CIRCLE_IN_HALVES ? 4 * OF_SUMS + (size_t)points : 0;
}

void softcat_rule(softcat_section section, int fibres, int points, double width, double *tables,
                  double *room)
{
    int split = points >= LEAST_IN_HALVES && points % 2 == 0;
    int circle = section == SOFTCAT_CIRCLE || section == SOFTCAT_CIRCLE_IN_HALVES;
    int halves = section == SOFTCAT_RECTANGLE_IN_HALVES || section == SOFTCAT_CIRCLE_IN_HALVES;
    if (section == SOFTCAT_WARPING) warping(points, width, tables, room);
    else if (section == SOFTCAT_RINGS) rings(rings_of(fibres), points, tables);
    else if (halves && split) in_halves(circle, points, tables, tables + points, room);
    else if (circle) chebyshev(points, tables, tables + points);
    else legendre(points, 1.0, tables, tables + points);
}

static int is_spatial(const softcat_structure *s)
{
    return s->section == SOFTCAT_RINGS || s->section == SOFTCAT_WARPING;
}

int softcat_tables(const softcat_structure *s)
{
    return is_spatial(s) ? 5 : 2;
}

int softcat_points(const softcat_structure *s, int fibres)
{
    if (fibres == 0) fibres = s->fibres;
    else if (fibres < 2 || fibres > MOST_FIBRES || !s->points) return 0;
    if (s->section == SOFTCAT_RINGS) {
        int count = rings_of(fibres), angles = (fibres + count - 1) / count;
        return count * (angles > 3 ? angles : 3);
    }
    int side = (int)ceil(sqrt(fibres));
    return s->section != SOFTCAT_WARPING ? fibres : side > 2 ? side * side : 4;
}

int softcat_structure_slots(const softcat_structure *s, int fibres)
{
    if (!s->points) return fibres ? 0 : s->model->slots;
    int points = softcat_points(s, fibres), each = s->model->slots - s->plain_slots;
    return points ? s->plain_slots + each / s->points * points : 0;
}

static int grown(int size, int plain, int from, int to)
{
    return plain + (size - plain) / from * to;
}

softcat_view softcat_view_of(const softcat_structure *s, const softcat_sized *sized)
{
    int points = sized->structure.points;
    return (softcat_view){s->model, s->plain_slots, s->plain_entries, points ? s->points : 1,
                          points ? points : 1};
}

/* Tables of slots and entries. */
static void fill(const softcat_structure *s, softcat_sized *to, double *numbers, int *integers)
{
    const softcat_model *old = s->model;
    softcat_model *m = &to->model;
    int from = s->points, now = to->structure.points, slots = m->slots, entries = m->entries;
    int plain = s->plain_slots;
    double *mean = numbers, *bending = mean + slots, *absolutes = bending + slots;
    int *rate = integers, *differential = rate + slots, *first = differential + slots;
    int *last = first + slots, *on_cells = last + slots, *row = on_cells + slots;
    int *offset = row + entries, *column = offset + entries;
    for (int k = 0; k < slots; k++) {
        int at = softcat_source(k, plain, from, now), each = k >= plain;
        int point = each ? (k - plain) % now : 0;
        rate[k] = softcat_target(old->rate[at], plain, from, now, point);
        differential[k] = old->differential[at];
        first[k] = old->held_first[at];
        last[k] = old->held_last[at];
        on_cells[k] = s->on_cells[at];
        mean[k] = s->mean[at];
        bending[k] = s->bending[at] * (each ? to->points[point] : 1.0);
        absolutes[k] = s->absolutes[at];
    }
    for (int e = 0; e < entries; e++) {
        int at = softcat_source(e, s->plain_entries, from, now);
        int point = e >= s->plain_entries ? (e - s->plain_entries) % now : 0;
        row[e] = softcat_target(old->row[at], plain, from, now, point);
        offset[e] = old->offset[at];
        column[e] = softcat_target(old->column[at], plain, from, now, point);
    }
    m->rate = rate;
    m->differential = differential;
    m->held_first = first;
    m->held_last = last;
    m->row = row;
    m->offset = offset;
    m->column = column;
    to->structure.on_cells = on_cells;
    to->structure.mean = mean;
    to->structure.bending = bending;
    to->structure.absolutes = absolutes;
}

int softcat_size(const softcat_structure *s, const double *params, int fibres,
                 softcat_memory *memory, softcat_sized *to)
{
    *to = (softcat_sized){.structure = *s, .model = *s->model};
    if (!s->points) return fibres ? SOFTCAT_BAD_FIBRES : SOFTCAT_SOLVED;
    int points = softcat_points(s, fibres), from = s->points;
    if (!points) return SOFTCAT_BAD_FIBRES;
    softcat_model *m = &to->model;
    m->slots = grown(m->slots, s->plain_slots, from, points);
    m->sections += m->slots - s->model->slots;
    m->entries = grown(m->entries, s->plain_entries, from, points);
    m->scratch = grown(m->scratch, s->plain_scratch, from, points);
    to->structure.points = points;
    size_t slots = (size_t)m->slots;
    to->points = softcat_take_doubles(memory, (size_t)(softcat_tables(s) * points));
    double *room = softcat_take_doubles(memory, softcat_rule_room(s->section, points));
    double *numbers = softcat_take_doubles(memory, 3 * slots);
    int *integers = softcat_take_ints(memory, 5 * slots + 3 * (size_t)m->entries);
    if (!memory->base) return SOFTCAT_SOLVED;
    if (!softcat_fits(memory)) return SOFTCAT_MEMORY;
    double width = s->aspect >= 0 ? params[s->aspect] : s->width;
    int as_scene = points == from && (!fibres || fibres == s->fibres)
                   && (s->aspect < 0 || width == s->parameter_values[s->aspect]);
    if (as_scene && s->section_points)
        memcpy(to->points, s->section_points,
               (size_t)(softcat_tables(s) * points) * sizeof(double));
    else softcat_rule(s->section, fibres ? fibres : s->fibres, points, width, to->points, room);
    fill(s, to, numbers, integers);
    return SOFTCAT_SOLVED;
}

int softcat_slot_of_scene(const softcat_structure *s, const softcat_sized *sized, int slot)
{
    int points = sized->structure.points;
    return points == s->points ? slot : softcat_source(slot, s->plain_slots, s->points, points);
}
