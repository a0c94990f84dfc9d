/* Explicit dynamics of a strip of eight-node plane-stress elements, total Lagrangian.
 *
 * Units: span, Young's modulus and density are 1, so time is in units of L sqrt(rho/E). Width 1.
 * Two-component arrays are interleaved: x, y of node 0, x, y of node 1, ...
 */
#ifndef SOFTCAT_ELEMENTS_H
#define SOFTCAT_ELEMENTS_H

#define SOFTCAT_NODES 8  /* of an element */
#define SOFTCAT_POINTS 4 /* of an element: 2 x 2 Gauss points */

/* The same memory, field by field, as softcat_sym.reference.element_loop.ElementLoop. */
struct softcat_strip {
    /* mesh */
    long elements;
    long nodes;
    const int *corner;      /* (elements, NODES) nodes of an element */
    const double *size;     /* (elements, 2) reference edge lengths */
    const double *gradient; /* (2, NODES, POINTS) derivatives of the shape functions on the square of edge 2 */
    const double *mass;     /* (nodes) lumped */
    const double *mobility; /* (nodes, 2) 1/mass, 0 where held */
    long columns;           /* elements along the half span */
    const int *edge;        /* (columns, 2, 3) nodes of the lower and of the upper edge: ends, middle */
    /* clamped face that may thin: it moves as u_y = (lambda - 1) Y, one degree of freedom; none where face is 0 */
    long face;
    const int *face_node;      /* (face) */
    const double *face_height; /* (face) Y */
    double face_inertia;       /* sum of mass Y^2 */
    /* physics */
    const double *material; /* as softcat_point wants it */
    double pull;            /* of the undeformed surface, gamma (1/h0 + 1/D0) h0; 0: no surface tension */
    /* what the lower edge may come to lie on, without friction; a floor so deep and a wall so far that nothing touches */
    double half;      /* of the undeformed thickness */
    double floor;     /* level of the floor */
    double wall;      /* x of the wall of a pillar, from midspan */
    double top;       /* level of its top */
    double roundness; /* radius of its edge */
    double stiffness; /* of the penalty, force per length and depth; 0: neither */
    double gravity;
    double ramp; /* duration of the quintic step from 0 to gravity; 0: at once */
    /* stretch of time that is being marched: start + step taken, taken <= steps */
    double start;
    double step;
    long steps;
    long taken;
    /* state */
    double *displacement; /* (nodes, 2) */
    double *velocity;     /* (nodes, 2) */
    double *acceleration; /* (nodes, 2) */
    double *point;        /* (elements, POINTS, SOFTCAT_POINT_STATE) */
    double gravity_work;  /* done by gravity since the beginning */
    double plastic_work;  /* dissipated since the beginning */
    /* measured at the last step of a stretch, and by softcat_evaluate */
    double elastic_energy;
    double surface_energy; /* of the surface, less that at the beginning */
    double contact_energy;
    double *rate; /* (elements, POINTS) equivalent tensile plastic rate */
};

/* Gravity at a time: the quintic smooth step 10 u^3 - 15 u^4 + 6 u^5. */
double softcat_gravity(const struct softcat_strip *strip, double time);

/* Forces and accelerations where the strip is now, the material points flowing for `step`, at a time.
 * Returns 0, or 1 + the element in which a material point failed. */
long softcat_evaluate(struct softcat_strip *strip, double step, double time);

/* March (velocity Verlet, which is the leap-frog) until `until` or `steps` steps are taken, whichever comes first.
 * Returns as softcat_evaluate. */
long softcat_march(struct softcat_strip *strip, long until);

#endif
