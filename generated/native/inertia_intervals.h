/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance: on whole intervals.

   Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/paper/averaging.py,
   derivations/paper/slow_flow.py, derivations/extensions/inertia.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of inertia.h. */

#ifndef INERTIA_INTERVALS_H
#define INERTIA_INTERVALS_H

#include "interval.h"

/* What the least level of an amplitude follows from; it has one where the first, fall, is positive. */
static inline void inertia_intervals_terms(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval *out)
{
    out[0] = sfi_neg(sfi_mul(A, sfi_add(sfi_times(2.0, sfi_mul(A, sfi_square(zeta))), h)));
    out[1] = sfi_times(12.0, sfi_mul(sfi_mul(A, m), zeta));
    out[2] = sfi_add(sfi_square(h), sfi_square(m));
}

/* The least level of an amplitude less F_0, and its slope along A. */
static inline void inertia_intervals_peak(sf_interval x, sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, zeta);
    const sf_interval t1 = sfi_mul(m, x);
    const sf_interval drag = sfi_add(t0, t1);
    const sf_interval share = sfi_div(drag, h);
    const sf_interval t2 = sfi_square(x);
    const sf_interval root = sfi_sqrt(sfi_add(sfi_square(share), t2));
    out[0] = sfi_add(sfi_neg(F_0), sfi_mul(root, sfi_add(sfi_times(2.0, t0), t1)));
    out[1] = sfi_div(sfi_add(sfi_neg(sfi_mul(share, sfi_add(sfi_mul(h_A, t2), sfi_point(1.0)))), sfi_times(2.0,
        sfi_mul(t2, zeta))), root);
}

/* Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A. */
static inline void inertia_intervals_isola(sf_interval x, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, zeta);
    const sf_interval t1 = sfi_mul(m, x);
    const sf_interval t2 = sfi_add(t0, t1);
    const sf_interval t3 = sfi_square(x);
    const sf_interval t4 = sfi_mul(h, t3);
    const sf_interval t5 = sfi_times(2.0, zeta);
    const sf_interval t6 = sfi_mul(h_A, t3);
    const sf_interval t7 = sfi_add(t6, sfi_point(1.0));
    const sf_interval t8 = sfi_times(8.0, x);
    const sf_interval t9 = sfi_times(4.0, h);
    out[0] = sfi_sub(sfi_mul(t2, t7), sfi_mul(t4, t5));
    out[1] = sfi_add(sfi_add(sfi_sub(sfi_mul(sfi_mul(h_AA, t2), t3), sfi_mul(t5, t6)), sfi_mul(t7, zeta)),
        sfi_div(sfi_mul(sfi_sub(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(h_A, t2), x)), sfi_mul(m, t7)),
        sfi_mul(sfi_mul(t9, x), zeta)), sfi_add(sfi_add(sfi_sub(sfi_times(16.0, sfi_mul(A, sfi_square(zeta))),
        sfi_mul(h_A, sfi_sub(sfi_neg(sfi_times(4.0, A)), sfi_times(8.0, t4)))), sfi_times(12.0, sfi_mul(t1, zeta))),
        t9)), sfi_sub(sfi_sub(sfi_neg(sfi_mul(sfi_square(h), t8)), sfi_mul(sfi_square(m), t8)), sfi_times(12.0,
        sfi_mul(m, t0)))));
}

/* The same without its slope by k = h - A h_A and cubic = 3 h - A h_A, small where h is like A^3. */
static inline sf_interval inertia_intervals_isola_apart(sf_interval x, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval k, sf_interval cubic)
{
    const sf_interval t0 = sfi_mul(A, zeta);
    const sf_interval t1 = sfi_mul(m, x);
    const sf_interval drag = sfi_add(t0, t1);
    const sf_interval x2 = sfi_square(x);
    const sf_interval x3 = sfi_mul(x, x2);
    return sfi_div(sfi_sub(sfi_add(sfi_neg(sfi_mul(sfi_mul(cubic, t0), x2)), sfi_div(sfi_mul(sfi_square(drag),
        sfi_sub(sfi_neg(sfi_times(2.0, t0)), t1)), h)), sfi_mul(sfi_mul(k, m), x3)), A);
}

#endif
