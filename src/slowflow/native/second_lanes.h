/* The balance of the second approximation at many states at once, built for wide vectors. */
#ifndef SF_SECOND_LANES_H
#define SF_SECOND_LANES_H

#include <stddef.h>

enum {
    SF_VECTOR = 8,   /* a number of states is a multiple of it */
    SF_KNOWN = 12,   /* rows of averages: h, h_3 and h_5, each with three derivatives */
    SF_BALANCE = 9   /* rows of the balance: u_max, A_1, phi, R, F, F_A, F_Omega, R_A, R_Omega */
};

/* Row k of the n states begins at known[k * n], and at out[k * n]; no row of phi is written by the first. */
void sf_second_balances(ptrdiff_t n, const double *Omega, const double *A, double F_0, double m, double zeta,
                        const double *known, double *out);
void sf_second_answers(ptrdiff_t n, const double *Omega, const double *A, double F_0, double m, double zeta,
                       const double *known, double *out);

#endif
