/* Lists that the scans fill: samples along a chart, and the zeros found on it. */
#ifndef SF_ZEROS_H
#define SF_ZEROS_H

#include "questions.h"

enum { SF_MOST_NODES = 1200, SF_MOST_ZEROS = 96 };

#define SF_STEP_DOWN 0.90483741803595957 /* exp(-1/10): spacing below the first breakpoint */
#define SF_STEP_UP 1.1618342427282831    /* exp(3/20): spacing of e above a breakpoint */
#define SF_DEEP 1e-9                     /* the part of a chart's end where it begins, unless something lies below */
#define SF_DEEPEST 1e-40
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
