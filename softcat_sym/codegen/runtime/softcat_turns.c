#include "softcat_turns.h"

#include <math.h>
#include <string.h>

enum { WIDTH = 3, LEAST_CAPACITY = 8, LAST_KEPT = 64, BISECTIONS = 52 };

int softcat_turns_are_wrong(const softcat_turns *turns, int sites, int slots)
{
    return turns->site < 0 || turns->site >= sites || turns->slot < 0 || turns->slot >= slots
           || turns->capacity < LEAST_CAPACITY || !turns->rows;
}

void softcat_turns_begin(softcat_turns *turns, double t, double value)
{
    turns->count = turns->direction = 0;
    turns->rows[0] = t;
    turns->rows[1] = value;
    turns->rows[2] = 0.0;
}

/* Leave out the smallest swing but for the last ones: two turns that lie beside each other. */
static void leave_out_one(softcat_turns *turns)
{
    int last = turns->capacity / 2 < LAST_KEPT ? turns->capacity / 2 : LAST_KEPT, least = 1;
    double smallest = INFINITY;
    for (int i = 1; i + 1 < turns->count - last; i++) {
        double swing = fabs(turns->rows[WIDTH * (i + 1) + 1] - turns->rows[WIDTH * i + 1]);
        if (swing < smallest) {
            smallest = swing;
            least = i;
        }
    }
    double *gap = turns->rows + WIDTH * least;
    turns->count -= 2;
    memmove(gap, gap + 2 * WIDTH, (size_t)(turns->count + 1 - least) * WIDTH * sizeof(double));
}

/* Go on to a point to which the value only rises or only falls: where it did the opposite before,
 * it turned, or at the start. */
static void reach(softcat_turns *turns, double t, double value, double area)
{
    double *row = turns->rows + WIDTH * turns->count;
    int direction = (value > row[1]) - (value < row[1]);
    if (turns->count == 0 || (direction && direction == -turns->direction)) {
        if (turns->count + 1 == turns->capacity) leave_out_one(turns);
        row = turns->rows + WIDTH * ++turns->count;
    }
    if (direction) turns->direction = direction;
    row[0] = t;
    row[1] = value;
    row[2] = area;
}

/* c[0] + c[1] x + c[2] x^2 + ... */
static double polynomial(const double *c, int degree, double x)
{
    double sum = c[degree];
    for (int k = degree - 1; k >= 0; k--) sum = sum * x + c[k];
    return sum;
}

/* Add the root of a polynomial of degree 3 between two points if it changes sign there. */
static int add_root(const double *c, double low, double high, double *roots, int count)
{
    double below = polynomial(c, 3, low);
    if ((below > 0.0) == (polynomial(c, 3, high) > 0.0)) return count;
    for (int i = 0; i < BISECTIONS; i++) {
        double middle = 0.5 * (low + high);
        if ((polynomial(c, 3, middle) > 0.0) == (below > 0.0)) low = middle;
        else high = middle;
    }
    roots[count] = high;
    return count + 1;
}

/* Where a polynomial of degree 3 changes sign in 0 < x < 1, in order: it is monotone between the
 * roots of its derivative. */
static int sign_changes(const double *c, double *roots)
{
    double a = 3.0 * c[3], b = c[2], square = b * b - a * c[1], low = 0.0;
    double extremes[2] = {1.0, 1.0};
    int count = 0;
    if (square > 0.0) {
        double q = -(b + copysign(sqrt(square), b));
        double one = a != 0.0 ? q / a : 1.0, other = q != 0.0 ? c[1] / q : 1.0;
        extremes[0] = fmin(one, other);
        extremes[1] = fmax(one, other);
    }
    for (int i = 0; i < 2; i++)
        if (extremes[i] > low && extremes[i] < 1.0) {
            count = add_root(c, low, extremes[i], roots, count);
            low = extremes[i];
        }
    return add_root(c, low, 1.0, roots, count);
}

void softcat_turns_step(softcat_turns *turns, const softcat_method *method, double t, double end,
                        double before, double after, const double *stages)
{
    double h = end - t, begun = turns->rows[WIDTH * turns->count + 2];
    double K[SOFTCAT_MOST_DENSE] = {0.0}, roots[3];
    for (int m = 0; m < method->dense_rows; m++)
        for (int j = 0; j < method->stages; j++) K[m] += method->dense[m][j] * stages[j];
    /* (1 - x) before + x after + x (1 - x) (K_1 + x (K_2 + x K_3)), its slope and its integral */
    const double value[] = {before, after - before + K[0], K[1] - K[0], K[2] - K[1], -K[2]};
    const double slope[] = {value[1], 2.0 * value[2], 3.0 * value[3], 4.0 * value[4]};
    const double area[] = {0.0, value[0], value[1] / 2.0, value[2] / 3.0, value[3] / 4.0,
                           value[4] / 5.0};
    int count = sign_changes(slope, roots);
    reach(turns, t, before, begun); /* algebraic unknowns jump where f does */
    for (int i = 0; i < count; i++)
        reach(turns, t + roots[i] * h, polynomial(value, 4, roots[i]),
              begun + h * polynomial(area, 5, roots[i]));
    reach(turns, end, after, begun + h * polynomial(area, 5, 1.0));
}
