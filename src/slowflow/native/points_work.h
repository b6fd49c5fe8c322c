/* Where points (A, R) are searched for, see points.h. */
#pragma once

#include "laws.h"

enum { SF_MOST_POINTS = 64, SF_MOST_PENDING = 256 };

/* F = F_A = 0; F = F_Omega = 0, or where the level of an excitation by inertia is stationary; F_A = F_AA = 0; F_A = 0
 * where the level is stationary; F_A = F_AOmega = 0 */
typedef enum { SF_LAW_FOLDS, SF_LAW_PEAKS, SF_LAW_CUSPS, SF_LAW_ISOLAS, SF_LAW_TURNS, SF_LAW_SYSTEMS } sf_law_system;

/* Omega, or under an excitation by inertia 1/Omega: w; R, or R/Omega^2 */
typedef struct {
    sf_interval R, w;
} sf_unknowns;

/* u: R, or w where by_w; off: how far the box extends that is proved to hold no other; size: of the terms of R */
typedef struct {
    double A, u, Omega, R, size, off_A, off_u;
    int by_w, part;
} sf_law_point;

/* doubt: amplitudes of the boxes that are undecided, as far as there are places */
typedef struct {
    int n, boxes, undecided;
    sf_status status;
    double doubt[SF_MOST_POINTS];
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

/* F_0: the forcing, or of cusps and isola points the highest level that is required; base, end: of the piece; blurred:
 * the amplitude up to which no cell is cut; far: whether all is over Omega^2; part: number of what is looked through */
typedef struct {
    const sf_model *model;
    sf_law_system system;
    double F_0, base, end, blurred;
    int far, part;
    sf_laws_within laws;
    sf_interval force;
    sf_law_points found;
    sf_law_box pending[SF_MOST_PENDING];
} sf_law_search;
