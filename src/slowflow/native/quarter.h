/* Integrals over the quarter cycle by Gauss's rule, piece by piece. Takes integrands of a generated header; returns
 * sums.
 *
 * A piece that ends at |u| = b ends at t = asin(b/A), 0 <= t <= pi/2. Its part of the quarter is divided into 1, 2, 4,
 * ... equal panels until twice as many change no sum by more than SF_AGREED of the integral of its size. As halving the
 * panels divides a rule's error by 2^12 at least, what is left then is below 2^-58 of that integral: less than
 * rounding. Where the force is a difference rounding changes more than that; it may change as much as some roundings of
 * A and of the parameters do.
 */
#pragma once

#include <math.h>
#include <stddef.h>

#include "quadrature_conventions.h"
#include "twofold.h"

enum { SF_MOST_SUMS = 256 };
#define SF_QUARTER 1.57079632679489662

/* At u less where the piece begins, and at the sine and the cosine of the angle, u = A sine. */
typedef void (*sf_integrand)(double beyond, double sine, double cosine, const double *p, double *out);

typedef struct sf_quarter sf_quarter;

/* All integrands of a piece at the nodes of a panel: of node j they go to out[j*width + k]. */
typedef void (*sf_interpreted)(const sf_quarter *of, int piece, int nodes, const double *beyond, const double *sine,
                               const double *cosine, const double *p, double *out);

/* width, parameters: how many integrands and parameters; integrands: of each piece, then of each contact, which goes on
 * from where it begins up to A, or what interprets `programs`, as many; graded: of each of these the power of what is
 * divided into panels that its angle, from where it begins, is; rule: positive nodes on [-1, 1], which stand for their
 * negatives too, and weights, so many of them; begins: the breakpoint at which each contact begins */
struct sf_quarter {
    int pieces, width, parameters;
    const sf_integrand *integrands;
    const int *graded;
    int nodes;
    const double (*rule)[2];
    int contacts;
    const int *begins;
    sf_interpreted interpreted;
    const void *programs;
    const double *rough; /* the error of each integrand, wherever it is; NULL where rounding is relative to it */
};

/* A piece's part of the quarter: its span, and the sine and the cosine of where it begins. */
typedef struct {
    int piece;
    double span, sine, cosine;
} sf_part;

/* The first `count` integrals, by that many panels, and those of the integrands' sizes. */
static inline void sf_panels(const sf_quarter *of, int count, const sf_part *on, double A, const double *p, int panels,
                             double *sums, double *sizes) {
    const int graded = of->graded[on->piece];
    double beyond[SF_NODES], sine[SF_NODES], cosine[SF_NODES], w[SF_NODES];
    double values[SF_NODES * SF_MOST_SUMS], beneath[SF_MOST_SUMS];
    for (int k = 0; k < count; k++)
        sums[k] = sizes[k] = beneath[k] = 0;
    for (int i = 0; i < panels; i++) {
        for (int j = 0; j < 2 * of->nodes; j++) {
            const double *node = of->rule[j / 2];
            const double at = (i + 0.5 * (1 + (j % 2 ? node[0] : -node[0]))) / panels;
            double x = at;
            w[j] = 0.5 * node[1] / panels * graded;
            for (int k = 1; k < graded; k++)
                x *= at, w[j] *= at;
            /* the angle is twice this one beyond where the piece begins, and u less that a difference of sines */
            const double half = 0.5 * on->span * x, s = sin(half), c = cos(half);
            const double twice_s = 2 * s * c, twice_c = 1 - 2 * s * s;
            beyond[j] = 2 * A * (on->cosine * c - on->sine * s) * s;
            sine[j] = on->sine * twice_c + on->cosine * twice_s;
            cosine[j] = on->cosine * twice_c - on->sine * twice_s;
        }
        if (of->interpreted != NULL)
            of->interpreted(of, on->piece, 2 * of->nodes, beyond, sine, cosine, p, values);
        else
            for (int j = 0; j < 2 * of->nodes; j++)
                of->integrands[on->piece](beyond[j], sine[j], cosine[j], p, values + j * of->width);
        for (int j = 0; j < 2 * of->nodes; j++)
            for (int k = 0; k < count; k++) {
                const double value = values[j * of->width + k] * w[j];
                double low_part;
                sums[k] = twofold_two_sum(sums[k], value, &low_part);
                beneath[k] += low_part, sizes[k] += fabs(value);
            }
    }
    for (int k = 0; k < count; k++) {
        if (isfinite(sums[k]))
            sums[k] += beneath[k];
        sums[k] *= on->span, sizes[k] *= on->span;
    }
}

/* Whether a sum moved by more than the error of its integrand. */
static inline int sf_is_apart(const sf_quarter *of, int k, double span, double shift, double size) {
    return shift > SF_AGREED * size + (of->rough != NULL ? of->rough[k] * span : 0);
}

/* Whether sums differ from those by half as many panels by no more than roundings of A and of the parameters make of
 * them. */
static inline int sf_varies_by_rounding(const sf_quarter *of, int count, const sf_part *on, double A, const double *p,
                                        int panels, const double *sums, const double *before, const double *sizes) {
    double there[SF_MOST_SUMS], sizes_there[SF_MOST_SUMS], changes[SF_MOST_SUMS], shifted[SF_MOST_SUMS];
    for (int k = 0; k < count; k++)
        changes[k] = 0;
    for (int number = -1; number < of->parameters; number++) {
        for (int k = 0; k < of->parameters; k++)
            shifted[k] = k == number ? p[k] * (1 + SF_MOVED_BY) : p[k];
        sf_panels(of, count, on, number < 0 ? A * (1 + SF_MOVED_BY) : A, shifted, panels, there, sizes_there);
        for (int k = 0; k < count; k++)
            changes[k] += fabs(there[k] - sums[k]);
    }
    for (int k = 0; k < count; k++) {
        const double shift = fabs(sums[k] - before[k]);
        if (sf_is_apart(of, k, on->span, shift, sizes[k]) && !(shift <= changes[k]))
            return 0;
    }
    return 1;
}

/* One piece's integrals; 0 where they do not settle. An infinite sum stays so. */
static inline int sf_settled_part(const sf_quarter *of, int count, const sf_part *on, double A, const double *p,
                                  double *sums) {
    double before[SF_MOST_SUMS], sizes[SF_MOST_SUMS];
    for (int k = 0; k < count; k++)
        before[k] = 0;
    for (int panels = 1; panels <= SF_MOST_PANELS; panels *= 2) {
        int apart = panels == 1;
        sf_panels(of, count, on, A, p, panels, sums, sizes);
        for (int k = 0; k < count && panels > 1 && !(on->span <= SF_SHORT_PART); k++)
            apart |= sf_is_apart(of, k, on->span, fabs(sums[k] - before[k]), sizes[k]);
        if (!apart ||
            (panels >= SF_FEWEST_PANELS && sf_varies_by_rounding(of, count, on, A, p, panels, sums, before, sizes)))
            return 1;
        for (int k = 0; k < count; k++)
            before[k] = sums[k];
    }
    return 0;
}

/* The sums over the pieces; 0 where one does not settle. */
static inline int sf_sums_at(const sf_quarter *of, int count, double A, const double *p, const double *ends,
                             double *sums) {
    double of_part[SF_MOST_SUMS], low = 0;
    for (int k = 0; k < count; k++)
        sums[k] = 0;
    for (int piece = 0; piece < of->pieces; piece++) {
        const double end = piece + 1 < of->pieces ? ends[piece] : INFINITY;
        const double high = A > end ? atan2(end, sqrt((A - end) * (A + end))) : SF_QUARTER;
        sf_part on = {piece, high - low, sin(low), cos(low)};
        if (piece > 0 && !(A > end)) {
            /* where the cycle ends in a piece its beginning is known by what it leaves of the quarter, which keeps its
             * digits next to it */
            const double begin = ends[piece - 1], span = A > begin ? atan2(sqrt((A - begin) * (A + begin)), begin) : 0;
            on = (sf_part){piece, span, cos(span), sin(span)};
        }
        if (on.span > 0) {
            if (!sf_settled_part(of, count, &on, A, p, of_part))
                return 0;
            for (int k = 0; k < count; k++)
                sums[k] += of_part[k];
        }
        low = high;
    }
    for (int piece = of->pieces; piece < of->pieces + of->contacts; piece++) {
        const double end = ends[of->begins[piece - of->pieces]];
        if (A > end) {
            const double span = atan2(sqrt((A - end) * (A + end)), end);
            const sf_part on = {piece, span, cos(span), sin(span)};
            if (!sf_settled_part(of, count, &on, A, p, of_part))
                return 0;
            for (int k = 0; k < count; k++)
                sums[k] += of_part[k];
        }
    }
    return 1;
}

/* The first `count` integrals, at A >= 0; NaN where one does not settle: the force is all but singular
 * there. */
static inline void sf_over_quarter(const sf_quarter *of, int count, double A, const double *p, const double *ends,
                                   double *sums) {
    double nearby[SF_MOST_SUMS];
    int lost = 0, settled = sf_sums_at(of, count, A, p, ends, sums);
    /* a slope at rest that is a quotient of zeros, as of a broken power, is what it is next to it */
    for (int k = 0; k < count; k++)
        lost |= A == 0 && isnan(sums[k]);
    if (settled && lost) {
        settled = sf_sums_at(of, count, SF_NEXT_TO_ZERO, p, ends, nearby);
        for (int k = 0; k < count; k++)
            sums[k] = isnan(sums[k]) ? nearby[k] : sums[k];
    }
    for (int k = 0; k < count && !settled; k++)
        sums[k] = NAN;
}
