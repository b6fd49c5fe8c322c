/* Averages of forces of any kind between two amplitudes. Takes an interval of A; returns what h and h_AAAA are
 * there.
 *
 * The quarter cycle is divided at displacements, each piece of the force for itself: at fixed ones where the amplitude
 * exceeds the piece, at fixed shares of the last piece. The first share of a long piece is halved again and again,
 * down to displacements of the size of the spring: all that a force does lies there. On each part u, sine and the
 * angle that it takes are known on an interval of A by their values at its ends, as each is monotone in A; what is
 * under the integrals is generated. A contact's are over shares of what A exceeds its begin by, whose weight is known.
 */
#pragma once

#include <string.h>

#include "elementary.h"
#include "mechanism.h"
#include "quadrature_conventions.h"

/* SF_CONTACT_SUMS integrals of a contact follow h's and h_AAAA's: over dy/sqrt(1 - y), and their derivatives */
enum {
    SF_MOST_CONTACTS = 2 * SF_MOST_BREAKS,
    SF_MOST_BENT = 1 + SF_MOST_BREAKS + 2 + SF_CONTACT_SUMS * SF_MOST_CONTACTS + SF_MOST_PARAMETERS
};

typedef struct sf_bent sf_bent;

/* contacts, begins: the breakpoint at which each begins; at: what is under the integrals and what closes them, at
 * arguments and the parameters behind: of each piece its terms at A, the displacement beyond its begin and the sine;
 * of each contact at A and the fraction; by how many breakpoints are exceeded what closes at A, the roots of these,
 * and the sums */
struct sf_bent {
    int breakpoints, parameters, contacts;
    const int *begins;
    void (*at)(const sf_bent *of, int number, const sf_interval *arguments, sf_interval *out);
    const void *programs;
};

static inline void sf_bent_at(const sf_bent *of, int number, int inputs, const sf_interval *arguments,
                              const sf_interval *p, sf_interval *out) {
    sf_interval all[SF_MOST_BENT];
    memcpy(all, arguments, (size_t)inputs * sizeof *all);
    memcpy(all + inputs, p, (size_t)of->parameters * sizeof *all);
    of->at(of, number, all, out);
}

/* How often the first part of a piece of that length is halved. */
static inline int sf_halved(double length) { return length > 1 ? (int)fmin(ceil(log2(length)), SF_HALVED) : 0; }

/* Where part number `part` of a piece begins whose first part is halved so often. */
static inline double sf_share(int part, int halved) {
    const int whole = part - halved;
    if (whole < 1)
        return part == 0 ? 0 : ldexp(sin(0.5 * SFI_PI / SF_PARTS), whole - 1);
    return whole == SF_PARTS ? 1 : sin(whole * (0.5 * SFI_PI / SF_PARTS));
}

/* The sine at such a share at an amplitude, which exceeds the piece or ends in it. */
static inline double sf_sine_at(double start, double end, int last, double fraction, double A) {
    if (last)
        return A > 0 ? fraction + (1 - fraction) * start / A : fraction;
    return fmin((fraction == 1 ? end : start + (end - start) * fraction) / A, 1);
}

static inline sf_interval sf_wider(double lo, double hi) {
    return sfi_of(lo - SF_ANGLE * fabs(lo), hi + SF_ANGLE * fabs(hi));
}

/* A sum that is too large for a double is at least this large. */
static inline sf_interval sf_no_larger(sf_interval x) {
    return sfi_of(x.lo > SF_LARGEST_SUM ? SF_LARGEST_SUM : x.lo, x.hi < -SF_LARGEST_SUM ? -SF_LARGEST_SUM : x.hi);
}

/* One piece's integrals, added: on its parts sines and angles rise or fall with A. */
static inline void sf_add_bent(const sf_bent *of, int piece, double start, double end, int last, sf_interval A,
                               const sf_interval *p, sf_interval sums[2]) {
    sf_interval total[2] = {{0, 0}, {0, 0}}, values[2];
    const int halved = sf_halved(last ? A.hi - start : end - start), pieces = SF_PARTS + halved;
    double low_sine = sf_sine_at(start, end, last, 0, A.lo), high_sine = sf_sine_at(start, end, last, 0, A.hi);
    double low_angle = asin(fmin(low_sine, 1)), high_angle = asin(fmin(high_sine, 1));
    for (int part = 0; part < pieces; part++) {
        const double fraction = sf_share(part, halved), next = sf_share(part + 1, halved);
        const double low_next = sf_sine_at(start, end, last, next, A.lo);
        const double high_next = sf_sine_at(start, end, last, next, A.hi);
        const double low_angle_next = asin(fmin(low_next, 1)), high_angle_next = asin(fmin(high_next, 1));
        const double one = low_angle_next - low_angle, other = high_angle_next - high_angle;
        const sf_interval angle =
            sfi_of(sfi_most(sfi_least(one, other) - SF_ANGLE, 0), sfi_most(one, other) + SF_ANGLE);
        /* sines are monotone in A, and beyond a breakpoint they fall as it rises */
        const sf_interval sine = sf_wider(high_sine, fmin(low_next, 1));
        const sf_interval beyond = last ? sf_wider((A.lo - start) * fraction, (A.hi - start) * next)
                                        : sf_wider((end - start) * fraction, (end - start) * next);
        sf_bent_at(of, piece, 3, (const sf_interval[]){A, beyond, sine}, p, values);
        for (int k = 0; k < 2; k++)
            total[k] = sfi_add(total[k], sfi_mul(values[k], angle));
        low_sine = low_next, high_sine = high_next, low_angle = low_angle_next, high_angle = high_angle_next;
    }
    for (int k = 0; k < 2; k++)
        sums[k] = sf_no_larger(sfi_add(sums[k], total[k]));
}

/* A contact's integrals over dy/sqrt(1 - y). */
static inline void sf_of_contact(const sf_bent *of, int number, double start, sf_interval A, const sf_interval *p,
                                 sf_interval *sums) {
    sf_interval values[SF_CONTACT_SUMS];
    const int halved = sf_halved(A.hi - start), pieces = SF_PARTS + halved;
    for (int part = 0; part < pieces; part++) {
        const double fraction = sf_share(part, halved), next = sf_share(part + 1, halved);
        const double wide = 2 * (sqrt(1 - fraction) - sqrt(1 - next));
        const sf_interval weight = sfi_of(sfi_most(wide - SF_ANGLE, 0), wide + SF_ANGLE);
        sf_bent_at(of, of->breakpoints + 1 + number, 2, (const sf_interval[]){A, sf_wider(fraction, fmin(next, 1))}, p,
                   values);
        for (int k = 0; k < SF_CONTACT_SUMS; k++)
            sums[k] = sfi_add(sums[k], sfi_mul(values[k], weight));
    }
}

/* h and h_AAAA on amplitudes of one piece of the force, which ends at these breakpoints; infinite or NaN where not
 * known. */
static inline void sf_enclose(const sf_bent *of, const double *ends, sf_interval A, const double *inputs,
                              sf_interval *out) {
    sf_interval p[SF_MOST_PARAMETERS], known[SF_MOST_BENT] = {A};
    int passed = 0;
    while (passed < of->breakpoints && A.lo >= ends[passed])
        passed++;
    sf_interval *roots = known + 1, *sums = roots + passed;
    for (int i = 0; i < of->parameters; i++)
        p[i] = sfi_point(inputs[i]);
    for (int i = 0; i <= passed; i++) {
        const double start = i > 0 ? ends[i - 1] : 0, end = i < passed ? ends[i] : 0;
        if (i == passed || end > start)
            sf_add_bent(of, i, start, end, i == passed, A, p, sums);
        if (i < passed)
            roots[i] = sfi_root(sfi_mul(sfi_sub(A, sfi_point(end)), sfi_add(A, sfi_point(end))));
    }
    for (int i = 0; i < of->contacts; i++)
        if (of->begins[i] < passed)
            sf_of_contact(of, i, ends[of->begins[i]], A, p, sums + 2 + SF_CONTACT_SUMS * i);
    sf_bent_at(of, of->breakpoints + 1 + of->contacts + passed, 3 + passed + SF_CONTACT_SUMS * of->contacts, known, p,
               out);
}
