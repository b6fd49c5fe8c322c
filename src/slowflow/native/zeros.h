/* Zeros found along the amplitude, as a list. */
#pragma once

#include "enclosures.h"

#define SF_MOST_ZEROS 96

/* level: of a cusp, as of sf_answer; rising: whether the function goes from below zero to above
 * it with rising A */
typedef struct {
    double A, Omega, level;
    sf_question question;
    int channel, rising;
} sf_zero;

/* cells: intervals looked at; undecided: whether one of them holds a number of zeros that doubles do not resolve;
 * close: of SF_FOLD_AT and SF_STATE, whether the function was seen as near to 0 as rounding may bring it */
typedef struct {
    int n, cells, undecided, close;
    sf_status status;
    sf_zero at[SF_MOST_ZEROS];
} sf_zeros;

static inline void sf_clear_zeros(sf_zeros *found) {
    found->n = found->cells = found->undecided = found->close = 0, found->status = SF_OK;
}

static inline void sf_add_zero(sf_zeros *found, sf_zero zero) {
    if (found->n == SF_MOST_ZEROS) {
        found->status = SF_TOO_MANY;
        return;
    }
    found->at[found->n++] = zero;
}

/* Whether the least level over Omega rises through the forcing at a zero of SF_PEAK or SF_REST, so that stable motions
 * end there. A maximum of F over Omega (channel 0 of SF_PEAK) is a top of the curve where F falls, and none of these.
 * Of the halves of SF_REST the upper one has h = -c: the spring pulls back, and F rises where h falls. In the lower
 * half it pushes on: that counts where it pulls nowhere, `pushes`. */
static inline int sf_is_top(const sf_zero *zero, int pushes) {
    if (zero->question == SF_REST)
        return zero->channel == 1 ? !zero->rising : pushes && zero->rising;
    return zero->channel == 1 && zero->rising;
}

/* The highest of these; NULL where there is none. */
static inline const sf_zero *sf_top(const sf_zeros *found, int pushes) {
    const sf_zero *top = NULL;
    for (int i = 0; i < found->n; i++)
        if (sf_is_top(&found->at[i], pushes) && (top == NULL || found->at[i].A > top->A))
            top = &found->at[i];
    return top;
}

/* By rising A; the lists are short and nearly sorted. */
static inline void sf_sort_zeros(sf_zeros *found) {
    int j;
    for (int i = 1; i < found->n; i++) {
        const sf_zero zero = found->at[i];
        for (j = i; j > 0 && found->at[j - 1].A > zero.A; j--)
            found->at[j] = found->at[j - 1];
        found->at[j] = zero;
    }
}
