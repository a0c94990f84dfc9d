/* The order in which softcat_linear.c eliminates, found once from the pattern of the Jacobian. */
#ifndef SOFTCAT_PLAN_H
#define SOFTCAT_PLAN_H

#include "softcat_band.h"
#include "softcat_linear.h"
#include "softcat_memory.h"

enum { SOFTCAT_FEW = 5 }; /* slots of a site all of whose orders are tried */

/* An entry of the Jacobian, and where the elimination puts it, the same way at every site. */
typedef struct softcat_link {
    int entry, row, offset, column;
    int via;      /* rate u of a column x, in whose column the entry is put, times 1 / s; else -1 */
    int target;   /* place in the store, relative to that of the site */
    int distance; /* from the site's first unknown to the column's */
} softcat_link;

typedef struct softcat_links {
    int count;
    int first_via; /* those with a rate come last */
    softcat_link *links;
} softcat_links;

/* Section states that see each other: positions first .. first + size - 1, numbers from start. */
typedef struct softcat_block {
    int first, size, start;
} softcat_block;

/* A kept row, and the distance to a site whose section states it sees. */
typedef struct softcat_group {
    int row, offset;
} softcat_group;

struct softcat_linear {
    const softcat_model *model;
    int sites, slots, kept;
    unsigned char *free_unknowns;  /* [sites * slots] */
    int held_count;
    int *held;                     /* [held_count] unknowns that are not free */
    int first_plain, last_plain;   /* sites whose entries need no look at the ends */
    int back, ahead;               /* reach of the entries, in sites */

    int eliminated, remaining;     /* kept slots: those with a rate, and the others */
    int *eliminated_slot, *remaining_slot;
    int *place;                    /* [slots] position of a remaining or eliminated slot among
                                      those of its site; of a section slot: in section_slot */

    int *section_slot;             /* [sections] block by block */
    int *diagonal;                 /* [sections] where their diagonal stands in the blocks */
    int block_count, block_doubles;
    int link_count;                /* of all lists below */
    softcat_block *block;
    double *blocks;                /* [sites * block_doubles] inverted */

    unsigned char *at_rest;        /* [sites] no kept unknown moves their section states */

    int padded;                    /* sections, rounded up to fours */
    int answer_columns;            /* kept unknowns that section states see, at which sites */
    int *answer_offset, *answer_slot;
    double *answers;               /* [sites * answer_columns * padded] (W_ss)^-1 W_sk */
    double *drags;                 /* [sites * x_columns * padded] J_sx */

    int lanes;                     /* remaining slots, rounded up to fours */
    int x_columns;                 /* eliminated x of a site and of those within reach */
    double *x;                     /* [(back + sites + ahead) * eliminated], zero outside */
    double *moves;                 /* [sites * x_columns * lanes] J of remaining rows by x */

    int group_count;
    softcat_group *group;
    double *weights;               /* [sites * groups * padded] J of kept rows by section states */
    int *group_target;             /* [groups * answer_columns] places of answers in the band */

    softcat_links direct;          /* kept row, kept column: into the band */
    softcat_links within;          /* section row, section column: into the blocks */
    softcat_links driven;          /* section row, kept column: into the coupling */
    softcat_links dragged;         /* section row, column of an eliminated x: into the drags */
    softcat_links seen;            /* kept row, section column: into the weights */
    softcat_links moved;           /* kept row, column of an eliminated x: into the moves */

    double *coupling;              /* [answer_columns * padded] of one site */
    double *gathered, *solved;     /* [padded] */
    double *known;                 /* [answer_columns] */
    int *pivots;                   /* [sections] */
    int order[SOFTCAT_FEW];        /* of the remaining slots, where they are few */
    softcat_band band;
    double inverse_shift;
};

/* What softcat_sections.c does of softcat_linear.h: eliminate a site's section states, whose band
 * rows are `rows`; then, in a right-hand side, solve for them alone, take what the rows in the band
 * see of them and, last, add what they answer to the kept unknowns. */
int softcat_sections_eliminate(softcat_linear *, int site, const double *entries, double shift);
void softcat_sections_answer(const softcat_linear *, int site, double *rows);
void softcat_sections_first(const softcat_linear *, double *k);
void softcat_sections_last(const softcat_linear *, double *k);

/* Add -J to a store at a site; the column of an x stands in that of its rate u, times 1 / s. */
void softcat_linear_scatter(const softcat_linear *, const softcat_links *, int site,
                            const double *entries, double *store);

/* How far, in sites, rows of the remaining slots reach to columns of these. */
enum { SOFTCAT_MOST_REMAINING = 24 };
typedef struct softcat_reach {
    signed char least[SOFTCAT_MOST_REMAINING][SOFTCAT_MOST_REMAINING];
    signed char most[SOFTCAT_MOST_REMAINING][SOFTCAT_MOST_REMAINING]; /* below least: to none */
} softcat_reach;

/* Order the remaining slots of a site so that the band is narrow: its width, and linear->order. */
void softcat_plan_order(softcat_linear *, const softcat_reach *);

/* Count what the pattern of a model asks for (softcat_count.c): 0 or a code. */
int softcat_plan_count(softcat_linear *, const softcat_view *);

/* In which lists an entry stands: how many, two at most. */
int softcat_plan_lists(softcat_linear *, const softcat_view *, int entry, softcat_links *to[2]);

/* x' = u is eliminated unless u is somebody's rate of change itself. */
int softcat_is_eliminated(const softcat_linear *, int slot);

/* Count, take the memory and, if there is any, fill it: 0 or a code. */
int softcat_plan_make(softcat_linear *, const softcat_view *, softcat_memory *);

#endif
