#include "elements.h"

#include <math.h>
#include <string.h>

/* In this translation unit, so that the compiler can inline it. */
#define SOFTCAT_POINT_API static inline
#include "point.c"

#define NODES SOFTCAT_NODES
#define POINTS SOFTCAT_POINTS
#define STATE SOFTCAT_POINT_STATE
#define EDGE 3 /* nodes of an edge */

double softcat_gravity(const struct softcat_strip *strip, double time)
{
    const double u = strip->ramp > 0.0 ? time / strip->ramp : 1.0;
    if (u >= 1.0) return strip->gravity;
    if (u <= 0.0) return 0.0;
    return strip->gravity * u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

/* Displacement gradients, row-major, at the points of one element. Points innermost: they fill a vector register. */
static inline void gradients(const double *restrict table, double u[2][NODES], const double scale[2],
                             double H[4][POINTS])
{
    double sums[4][POINTS] = {{0.0}};
    for (int a = 0; a < NODES; ++a) {
        const double *along = table + a * POINTS, *across = table + (NODES + a) * POINTS;
        const double x = u[0][a], y = u[1][a];
        for (int p = 0; p < POINTS; ++p) {
            sums[0][p] += x * along[p];
            sums[1][p] += x * across[p];
            sums[2][p] += y * along[p];
            sums[3][p] += y * across[p];
        }
    }
    for (int i = 0; i < 4; ++i)
        for (int p = 0; p < POINTS; ++p) H[i][p] = sums[i][p] * scale[i % 2];
}

/* Nodal forces that stress leaves, from first Piola stresses that are already multiplied by weight and scale. */
static inline void nodal_forces(const double *restrict table, double stress[4][POINTS], double force[2][NODES])
{
    for (int a = 0; a < NODES; ++a) {
        const double *along = table + a * POINTS, *across = table + (NODES + a) * POINTS;
        double x = 0.0, y = 0.0;
        for (int p = 0; p < POINTS; ++p) {
            x += stress[0][p] * along[p] + stress[1][p] * across[p];
            y += stress[2][p] * along[p] + stress[3][p] * across[p];
        }
        force[0][a] = x;
        force[1][a] = y;
    }
}

/* Minus the internal forces, into the place of the accelerations. `measure` is a constant where this is inlined. */
static inline long internal_forces(struct softcat_strip *strip, double step, int measure)
{
    const double *restrict displacement = strip->displacement;
    double *restrict force = strip->acceleration;
    double plastic = 0.0, elastic = 0.0;
    memset(force, 0, 2 * (size_t)strip->nodes * sizeof *force);
    for (long e = 0; e < strip->elements; ++e) {
        const int *corner = strip->corner + e * NODES;
        const double *size = strip->size + 2 * e;
        const double scale[2] = {2.0 / size[0], 2.0 / size[1]}, weight = 0.25 * size[0] * size[1];
        double u[2][NODES], H[4][POINTS], stress[4][POINTS], nodal[2][NODES];
        for (int a = 0; a < NODES; ++a) {
            u[0][a] = displacement[2 * corner[a]];
            u[1][a] = displacement[2 * corner[a] + 1];
        }
        gradients(strip->gradient, u, scale, H);
        for (int p = 0; p < POINTS; ++p) {
            const double F[4] = {1.0 + H[0][p], H[1][p], H[2][p], 1.0 + H[3][p]};
            double P[4], record[SOFTCAT_POINT_RECORD];
            if (softcat_point(F, strip->point + (e * POINTS + p) * STATE, step, strip->material, P, record) != 0)
                return e + 1;
            for (int i = 0; i < 4; ++i) stress[i][p] = weight * scale[i % 2] * P[i];
            plastic += weight * record[1];
            if (measure) {
                elastic += weight * record[0];
                strip->rate[e * POINTS + p] = record[2];
            }
        }
        nodal_forces(strip->gradient, stress, nodal);
        for (int a = 0; a < NODES; ++a) {
            force[2 * corner[a]] -= nodal[0][a];
            force[2 * corner[a] + 1] -= nodal[1][a];
        }
    }
    strip->plastic_work += plastic;
    if (measure) strip->elastic_energy = elastic;
    return 0;
}

/* Minus the forces of the surface, onto those that stress leaves.
 *
 * Of sections that shrink alike in height and depth, as the filament's do, the outline is s^-1/2 of what it was, and
 * the lateral surface of a filament, however bent, is the outline times the length of its centreline (Pappus). So the
 * energy gamma (area) is 2 pull s^1/2 per undeformed length and depth, both edges and both faces counted: s is the mean
 * stretch of the two edges at the same X. With it goes the axial force pull s^-1/2, half of it along either edge.
 */
static void surface_forces(struct softcat_strip *strip)
{
    const double root = sqrt(1.0 / 3.0), slope[2][EDGE] = {{-root - 0.5, 0.5 - root, 2.0 * root},
                                                           {root - 0.5, 0.5 + root, -2.0 * root}};
    const long through = strip->elements / strip->columns;
    double energy = 0.0;
    for (long c = 0; c < strip->columns; ++c) {
        const int *edge = strip->edge + c * 2 * EDGE;
        const double length = strip->size[2 * c * through];
        for (int p = 0; p < 2; ++p) {
            double tangent[2][2], stretch[2];
            for (int side = 0; side < 2; ++side) {
                double *t = tangent[side];
                t[0] = 0.5 * length, t[1] = 0.0;
                for (int a = 0; a < EDGE; ++a)
                    for (int i = 0; i < 2; ++i)
                        t[i] += slope[p][a] * strip->displacement[2 * edge[side * EDGE + a] + i];
                stretch[side] = sqrt(t[0] * t[0] + t[1] * t[1]) / (0.5 * length);
            }
            const double shrunk = sqrt(0.5 * (stretch[0] + stretch[1]));
            energy += strip->pull * length * (shrunk - 1.0);
            for (int side = 0; side < 2; ++side)
                for (int a = 0; a < EDGE; ++a)
                    for (int i = 0; i < 2; ++i)
                        strip->acceleration[2 * edge[side * EDGE + a] + i] -=
                            strip->pull / (length * shrunk * stretch[side]) * slope[p][a] * tangent[side][i];
        }
    }
    strip->surface_energy = energy;
}

/* Minus the depth in a body, where that is positive, and the normal out of it. */
static double penetration(const struct softcat_strip *strip, const double at[2], double normal[2])
{
    const double inwards = strip->wall + strip->roundness - at[0], upwards = at[1] - strip->top + strip->roundness;
    const double x = inwards > 0.0 ? inwards : 0.0, y = upwards > 0.0 ? upwards : 0.0, r = sqrt(x * x + y * y);
    const double floor = strip->floor - at[1], pillar = strip->roundness - r;
    if (floor >= pillar || r == 0.0) {
        normal[0] = 0.0, normal[1] = 1.0;
        return floor;
    }
    normal[0] = -x / r, normal[1] = y / r;
    return pillar;
}

/* Forces of floor and pillar on the nodes of the lower edge, which share its length as Simpson's rule has it. */
static void contact_forces(struct softcat_strip *strip)
{
    const double share[EDGE] = {1.0 / 6.0, 1.0 / 6.0, 2.0 / 3.0};
    const long through = strip->elements / strip->columns;
    double energy = 0.0, start = 0.0;
    for (long c = 0; c < strip->columns; ++c) {
        const double length = strip->size[2 * c * through], at_rest[EDGE] = {start, start + length, start + length / 2};
        for (int a = 0; a < EDGE; ++a) {
            const int node = strip->edge[c * 2 * EDGE + a];
            const double *moved = strip->displacement + 2 * node;
            const double at[2] = {at_rest[a] + moved[0], moved[1] - strip->half};
            double normal[2];
            const double deep = penetration(strip, at, normal), force = strip->stiffness * length * share[a] * deep;
            if (deep <= 0.0) continue;
            energy += 0.5 * force * deep;
            for (int i = 0; i < 2; ++i) strip->acceleration[2 * node + i] += force * normal[i];
        }
        start += length;
    }
    strip->contact_energy = energy;
}

/* From forces to accelerations: surface, gravity, supports, and the face that thins uniformly. */
static void accelerate(struct softcat_strip *strip, double gravity)
{
    double *restrict acceleration = strip->acceleration;
    double moment = 0.0;
    if (strip->pull > 0.0) surface_forces(strip);
    if (strip->stiffness > 0.0) contact_forces(strip);
    for (long k = 0; k < strip->face; ++k)
        moment += strip->face_height[k] * acceleration[2 * strip->face_node[k] + 1];
    for (long i = 0; i < strip->nodes; ++i) {
        acceleration[2 * i] *= strip->mobility[2 * i];
        acceleration[2 * i + 1] = (acceleration[2 * i + 1] - strip->mass[i] * gravity) * strip->mobility[2 * i + 1];
    }
    for (long k = 0; k < strip->face; ++k)
        acceleration[2 * strip->face_node[k] + 1] = strip->face_height[k] * moment / strip->face_inertia;
}

long softcat_evaluate(struct softcat_strip *strip, double step, double time)
{
    const long failed = internal_forces(strip, step, 1);
    if (failed == 0) accelerate(strip, softcat_gravity(strip, time));
    return failed;
}

/* Kick by half a step; then drift by a whole one. Returns the work done by gravity over the drift, per gravity. */
static double kick_and_drift(struct softcat_strip *strip)
{
    const double step = strip->step;
    double *restrict displacement = strip->displacement, *restrict velocity = strip->velocity;
    const double *restrict acceleration = strip->acceleration;
    double descent = 0.0;
    for (long i = 0; i < 2 * strip->nodes; ++i) {
        velocity[i] += 0.5 * step * acceleration[i];
        displacement[i] += step * velocity[i];
    }
    for (long i = 0; i < strip->nodes; ++i) descent -= strip->mass[i] * velocity[2 * i + 1];
    return step * descent;
}

long softcat_march(struct softcat_strip *strip, long until)
{
    const double step = strip->step;
    while (strip->taken < until && strip->taken < strip->steps) {
        const double now = softcat_gravity(strip, strip->start + step * (double)strip->taken);
        const double next = softcat_gravity(strip, strip->start + step * (double)(strip->taken + 1));
        const double descent = kick_and_drift(strip);
        const int last = strip->taken + 1 == strip->steps;
        const long failed = last ? internal_forces(strip, step, 1) : internal_forces(strip, step, 0);
        if (failed != 0) return failed;
        accelerate(strip, next);
        for (long i = 0; i < 2 * strip->nodes; ++i) strip->velocity[i] += 0.5 * step * strip->acceleration[i];
        /* The trapezoidal rule: with it the balance of a linear system closes to round-off at any step. */
        strip->gravity_work += 0.5 * (now + next) * descent;
        ++strip->taken;
    }
    return 0;
}
