/* Records that the solvers of the second approximation fill. */
#pragma once

#include "second_conventions.h"
#include "second_lanes.h"
#include "work.h"

/* What the balance is at a state, in the order of the kernel. */
typedef union {
    double values[SF_BALANCE];
    struct {
        double u_max, A_1, phi, R, F, F_A, F_Omega, R_A, R_Omega;
    };
} sf_balance;

typedef struct {
    double Omega, A;
    sf_balance at;
    int part;
} sf_second_point;

/* How many points of the first approximation were left out, of how many, and the frequencies between which they lie. */
typedef struct {
    long lost, of;
    double low, high;
} sf_left_out;

/* branches: connected stretches of the curve */
typedef struct {
    long n, branches;
    sf_left_out left;
    sf_second_point *point;
    unsigned char *closed;
} sf_second_curve;

/* up: whether a sweep leaves it for a larger amplitude */
typedef struct {
    double Omega, A, u_max, A_1;
    int up, corner;
} sf_second_fold;

/* lost: how many of those looked for were not found, next to which the curve is lost; left: of the curve that they were
 * looked for on */
typedef struct {
    int n, lost, tried;
    sf_status status;
    sf_left_out left;
    sf_second_fold at[SF_MOST_FOLDS];
} sf_second_folds;
