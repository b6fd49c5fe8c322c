/* Where points (A, R) are searched for, see points.h. */
#ifndef SF_POINTS_WORK_H
#define SF_POINTS_WORK_H

#include "laws.h"

enum { SF_MOST_POINTS = 64, SF_MOST_PENDING = 256 };

/* Omega, or under an excitation by inertia 1/Omega: w; R, or R/Omega^2 */
typedef struct {
    sf_interval R, w;
} sf_unknowns;

/* u: R, or w where by_w; off: how far the box extends that is proved to hold no other; size: of the terms of R */
typedef struct {
    double A, u, Omega, R, size, off_A, off_u;
    int by_w;
} sf_law_point;

typedef struct {
    int n, boxes, undecided;
    sf_status status;
    sf_law_point at[SF_MOST_POINTS];
} sf_law_points;

/* A sample, and what is known there. */
typedef struct {
    sf_sample at;
    sf_known known;
} sf_node;

/* by_w: whether w is the second unknown, else R */
typedef struct {
    sf_node a, b;
    sf_unknowns of;
    int by_w;
} sf_law_box;

/* base, end: of the piece */
typedef struct {
    const sf_model *model;
    double F_0, base, end;
    int far; /* whether all is over Omega^2 */
    sf_laws_within laws;
    sf_interval force;
    sf_law_points found;
    sf_law_box pending[SF_MOST_PENDING];
} sf_law_search;

#endif
