/* Lists that the scans fill: samples along a chart, and the zeros found on it. */
#ifndef SF_ZEROS_H
#define SF_ZEROS_H

#include "questions.h"

#ifndef SF_MOST_NODES
#define SF_MOST_NODES 1200
#endif
#define SF_MOST_ZEROS 96

/* spacing; a test builds the solvers with a finer one too */
#ifndef SF_STEP_DOWN
#define SF_STEP_DOWN 0.90483741803595957 /* exp(-1/10), of A below the first breakpoint */
#define SF_STEP_UP 1.1618342427282831    /* exp(3/20), of e above a breakpoint */
#define SF_STEP_NEAR 1.6487212707001282  /* exp(1/2), of e next to it */
#define SF_SKIP 1                        /* leave out pieces that cannot hold the onset */
#endif
#define SF_NEAR_BREAK 0.02
#define SF_DEEP 1e-9 /* amplitudes below it are left alone where no damping tells where the locus begins */
#define SF_DEEPEST 1e-100
#define SF_FIRST_ABOVE 0x1p-25 /* e of the first amplitudes above a breakpoint: A/b - 1 is of the size of an ulp */

typedef struct {
    int n;
    sf_sample at[SF_MOST_NODES];
} sf_nodes;

/* rising: whether the function goes from below zero to above it with rising A */
typedef struct {
    double A, Omega;
    sf_question question;
    int channel, rising;
} sf_zero;

typedef struct {
    int n;
    sf_status status;
    sf_zero at[SF_MOST_ZEROS];
} sf_zeros;

static inline void sf_add_zero(sf_zeros *found, double A, double Omega, sf_question question, int channel,
                               int rising) {
    sf_zero *zero;
    if (found->n == SF_MOST_ZEROS) {
        found->status = SF_TOO_MANY;
        return;
    }
    zero = &found->at[found->n++];
    zero->A = A, zero->Omega = Omega, zero->question = question, zero->channel = channel, zero->rising = rising;
}

/* By rising A; the lists are short and nearly sorted. */
static inline void sf_sort_zeros(sf_zeros *found) {
    int i, j;
    for (i = 1; i < found->n; i++) {
        const sf_zero zero = found->at[i];
        for (j = i; j > 0 && found->at[j - 1].A > zero.A; j--)
            found->at[j] = found->at[j - 1];
        found->at[j] = zero;
    }
}

#endif
