/* What the members of a mechanism's record are made of: macros that pass on the functions of its headers, and loops
 * over amplitudes and designs. records.h, which the derivation prints, uses them.
 */
#pragma once

#include <stddef.h>

#include "clones.h"
#include "mechanism.h"

/* Motions of an odd force are about its centre. */
static double records_centred(double A, const double *p) {
    (void)(A);
    (void)(p);
    return 0.0;
}

/* For a force of one piece. */
static void records_no_breakpoint(const sf_mechanism *self, const double *p, double *out) {
    (void)(self);
    (void)(p);
    (void)(out);
}

/* Functions of a record that pass a function of a header on. */
#define PASSES_ON(result, member, arguments, call)                                                                     \
    static result member arguments {                                                                                   \
        (void)self;                                                                                                    \
        call;                                                                                                          \
    }
#define OF_PARAMETERS(member, number, function)                                                                        \
    PASSES_ON(void, member, (const sf_mechanism *self, const number *p, number *out), function(p, out))
#define OF_DESIGN(member, number, call)                                                                                \
    PASSES_ON(void, member, (const sf_mechanism *self, const double *design, number *out), call)
#define INTERCEPT(member, call)                                                                                        \
    PASSES_ON(double, member, (const sf_mechanism *self, double A, const double *p), return call)
/* d/dp of h, h_A, h_AA, which are given, for each parameter p in turn */
#define BY_PARAMETER(member, function)                                                                                 \
    PASSES_ON(void, member, (const sf_mechanism *self, double A, const double *h, const double *p, double *out),       \
              function(A, h[0], h[1], h[2], p, out))
/* h, h_A, h_AA, h_AAA and h - A h_A */
#define AVERAGED_WITHIN(member, call)                                                                                  \
    PASSES_ON(void, member,                                                                                            \
              (const sf_mechanism *self, int passed, sf_interval A, sf_interval beyond, const sf_interval *p,          \
               sf_interval *out),                                                                                      \
              (void)passed;                                                                                            \
              (void)beyond; call)
/* h, h_A, h_AA, h_AAA, the first `count`: fewer take less time */
#define AVERAGED_IN_PAIRS(member, call)                                                                                \
    static void member(const sf_mechanism *self, int passed, int count, sf_pair A, sf_pair beyond, const sf_pair *p,   \
                       sf_pair *out) {                                                                                 \
        sf_pair all[5];                                                                                                \
        (void)self, (void)passed, (void)beyond;                                                                        \
        if (count <= 2) {                                                                                              \
            call;                                                                                                      \
            out[0] = all[0], out[1] = all[1];                                                                          \
            return;                                                                                                    \
        }                                                                                                              \
        call;                                                                                                          \
        for (int i = 0; i < 4; i++)                                                                                    \
            out[i] = all[i];                                                                                           \
    }

/* Sums over the force, `width` of them in one regime, at n amplitudes: each sum into a row of its own. */
#define ROWS(member, function, width)                                                                                  \
    static SF_FLAT void member(ptrdiff_t n, ptrdiff_t apart, const double *A, const double *p, double *out) {          \
        SF_INDEPENDENT                                                                                                 \
        for (ptrdiff_t i = 0; i < n; i++) {                                                                            \
            double h[width];                                                                                           \
            function(A[i], p, h);                                                                                      \
            for (int k = 0; k < (width); k++)                                                                          \
                out[k * apart + i] = h[k];                                                                             \
        }                                                                                                              \
    }

/* The same in any regime: all amplitudes by one loop, or those of one regime in a row by that regime's. */
#define SUMS(member, all)                                                                                              \
    static void member(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out) {         \
        (void)self;                                                                                                    \
        all;                                                                                                           \
    }

typedef void (*rows)(ptrdiff_t n, ptrdiff_t apart, const double *A, const double *p, double *out);

SF_ALWAYS void records_by_regime(const rows *loops, int (*regime_of)(double A, const double *p), ptrdiff_t n,
                                 const double *A, const double *p, double *out) {
    for (ptrdiff_t first = 0, end; first < n; first = end) {
        const int regime = regime_of(A[first], p);
        for (end = first + 1; end < n && regime_of(A[end], p) == regime; end++)
            ;
        loops[regime](end - first, n, A + first, p, out + first);
    }
}

/* Designs in pairs: what is made of their parameters p, each into rows of two doubles. */
#define IN_PAIRS(member, inputs, ...)                                                                                  \
    static SF_FLAT void member(const sf_mechanism *self, ptrdiff_t n, ptrdiff_t apart, const double *design,           \
                               double *out) {                                                                          \
        (void)self;                                                                                                    \
        SF_INDEPENDENT                                                                                                 \
        for (ptrdiff_t i = 0; i < n; i++) {                                                                            \
            sf_pair p[SF_MOST_PARAMETERS + SF_MOST_BREAKS];                                                            \
            inputs;                                                                                                    \
            __VA_ARGS__                                                                                                \
        }                                                                                                              \
    }
#define NUMBER(k) sfp_point(design[(k) * apart + i])
#define PUT(k, pair) out[2 * (k) * apart + i] = (pair).high, out[(2 * (k) + 1) * apart + i] = (pair).low
