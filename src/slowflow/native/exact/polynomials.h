/* A piece of a force that is known by its values: polynomials in what |u| exceeds the piece's begin by, one after the
 * other, each v^power times a sum of Chebyshev's polynomials (slowflow.sampled.polynomial). */
#pragma once

#include <stdlib.h>

#include "chebyshev.h"
#include "exact_conventions.h"
#include "step.h"

enum { SF_MOST_POWER = 4, SF_SUMMED = SF_MOST_DEGREE + 1 };

/* On one side of 0, from `begin` over `length`. sums: of f and of its slope next to the power, of degrees 0 to
 * `degree`, 0 beyond. */
typedef struct {
    double side, begin, length, power, degree, sums[2][SF_SUMMED];
} sf_polynomial;

/* law: first, so that a pointer to it is one to all. side: those for u < 0 and those for u > 0, so many of each, by
 * rising begin; where the force is not known any more the last one is NaN. */
typedef struct {
    sf_law law;
    int count[2];
    sf_polynomial *side[2];
} sf_polynomials;

/* The one that holds from v on in a direction: at a seam the one ahead. */
static const sf_polynomial *sf_polynomial_from(const sf_polynomials *of, int above, double v, double direction) {
    const sf_polynomial *const each = of->side[above];
    int k = 0;
    while (k + 1 < of->count[above] && (direction > 0.0 ? v >= each[k + 1].begin : v > each[k + 1].begin))
        k++;
    return &each[k];
}

static const double *sf_polynomial_at(const sf_law *self, double side, double u, double direction) {
    const sf_polynomials *const of = (const sf_polynomials *)self;
    return (const double *)sf_polynomial_from(of, side > 0.0, side * u, side * direction);
}

static double sf_polynomial_seam(const sf_law *self, double u, double direction, int both) {
    const sf_polynomials *const of = (const sf_polynomials *)self;
    const double side = u != 0.0 ? copysign(1.0, u) : copysign(1.0, direction), v = side * u;
    const int outward = side * direction > 0.0, above = side > 0.0, count = of->count[above];
    for (int i = 1; i < count; i++) {
        const double place = of->side[above][outward ? i : count - i].begin;
        if (outward ? place > v : place < v)
            return side * place;
    }
    return both && !outward ? 0.0 : HUGE_VAL;
}

/* f or its slope at u, by the rule of Horner for the power */
static double sf_polynomial_of(const sf_law *self, const double *p, double u, int slope) {
    const sf_polynomials *const of = (const sf_polynomials *)self;
    const double v = p[0] * u;
    const sf_polynomial *const here = sf_polynomial_from(of, p[0] > 0.0, v, 0.0);
    const double from = v - here->begin, x = 2.0 * from / here->length - 1.0;
    double value = sf_chebyshev(here->sums[0], (int)here->degree, x);
    double gradient = sf_chebyshev(here->sums[1], (int)here->degree, x);
    for (int i = 0; i < (int)here->power; i++)
        gradient = value + from * gradient, value *= from;
    return slope ? gradient : p[0] * value;
}

static double sf_polynomial_value(const sf_law *self, const double *p, double u) {
    return sf_polynomial_of(self, p, u, 0);
}

static double sf_polynomial_slope(const sf_law *self, const double *p, double u) {
    return sf_polynomial_of(self, p, u, 1);
}

/* Series: u, Chebyshev's polynomials 1 to `degree` (of 1 the argument itself), from u on, f and f' as they are
 * multiplied by v once more. Where f' is linear it is no less a series. */
typedef struct {
    int degree, power, from, force, slope, series, fours;
} sf_places;

static sf_places sf_places_of(const sf_polynomial *of) {
    const int degree = of->degree > 1.0 ? (int)of->degree : 1, power = (int)of->power, from = degree + 1;
    const int force = from + 1 + power, slope = force + 1 + power;
    return (sf_places){degree, power, from, force, slope, slope + 1, (degree + 2 * power + 2) / 4};
}

static void sf_polynomial_begin(const double *p, double *first, double *over) {
    const sf_polynomial *const of = (const sf_polynomial *)p;
    const sf_places at = sf_places_of(of);
    const double v = of->side * first[0] - of->begin;
    first[1] = 2.0 * v / of->length - 1.0;
    for (int k = 2; k <= at.degree; k++)
        first[k] = 2.0 * first[1] * first[k - 1] - (k > 2 ? first[k - 2] : 1.0);
    first[at.from] = v;
    double force = of->sums[0][0], slope = of->sums[1][0];
    for (int k = 1; k <= at.degree; k++)
        force += of->sums[0][k] * first[k], slope += of->sums[1][k] * first[k];
    for (int i = 0;; i++) {
        first[at.force - at.power + i] = force, first[at.slope - at.power + i] = slope;
        if (i == at.power)
            break;
        slope = force + v * slope, force *= v;
    }
    first[at.force] *= of->side;
    (void)over;
}

static void sf_polynomial_next(const sf_coefficients *c, const double *p, double *w, sf_four *left, sf_four *right) {
    const sf_polynomial *const of = (const sf_polynomial *)p;
    const sf_places at = sf_places_of(of);
    double pairs[2][4 * SF_MOST_FOURS];
    int sum = 0, force = at.force - at.power, slope = at.slope - at.power;
    w[1] = 2.0 / of->length * of->side * w[0];
    w[at.from] = of->side * w[0];
    for (int k = 2; k <= at.degree; k++, sum++) {
        w[k] = 2.0 * sf_product(c, 1, k - 1, sum) - (k > 2 ? w[k - 2] : 0.0);
        pairs[0][sum] = w[1], pairs[1][sum] = w[k - 1];
    }
    w[force] = w[slope] = 0.0;
    for (int k = 1; k <= at.degree; k++)
        w[force] += of->sums[0][k] * w[k], w[slope] += of->sums[1][k] * w[k];
    for (int i = 0; i < at.power; i++, force++, slope++) {
        w[slope + 1] = w[force] + sf_product(c, at.from, slope, sum);
        pairs[0][sum] = w[at.from], pairs[1][sum++] = w[slope];
        w[force + 1] = sf_product(c, at.from, force, sum);
        pairs[0][sum] = w[at.from], pairs[1][sum++] = w[force];
    }
    while (sum % 4 != 0)
        pairs[0][sum] = pairs[1][sum] = 0.0, sum++;
    for (int i = 0; i < sum / 4; i++) {
        left[i] = sf_four_of(pairs[0][4 * i], pairs[0][4 * i + 1], pairs[0][4 * i + 2], pairs[0][4 * i + 3]);
        right[i] = sf_four_of(pairs[1][4 * i], pairs[1][4 * i + 1], pairs[1][4 * i + 2], pairs[1][4 * i + 3]);
    }
    w[at.force] *= of->side;
}

SF_FMA static void sf_polynomial_expand(const sf_law *self, const double *p, const sf_drive *drive, double theta,
                                        double u, double v, const sf_four *flow, sf_expansion *x) {
    const sf_places at = sf_places_of((const sf_polynomial *)p);
    double over[SF_MOST_SERIES], w[4 * SF_MOST_SERIES];
    sf_four left[SF_MOST_FOURS * SF_TERMS], right[SF_MOST_FOURS * SF_TERMS];
    sf_expand(sf_polynomial_begin, sf_polynomial_next, p, drive, theta, u, v, flow, at.series, at.fours, at.force,
              at.slope, 0, over, w, left, right, x);
    (void)self;
}

/* The law of a piece from rows for u < 0 and for u > 0, so many of each, each begin, length, power, degree, then both
 * sums; NULL where memory is out. free() lets it go. */
static sf_law *sf_polynomial_law(const double (*const rows[2])[4 + 2 * SF_SUMMED], const int count[2]) {
    sf_polynomials *const made = calloc(1, sizeof *made + (size_t)(count[0] + count[1]) * sizeof(sf_polynomial));
    if (made == NULL)
        return NULL;
    made->law = (sf_law){"polynomials",        0,    SF_SEAMS,           sf_polynomial_value, sf_polynomial_slope,
                         sf_polynomial_expand, NULL, sf_polynomial_seam, sf_polynomial_at,    NULL};
    for (int s = 0; s < 2; s++) {
        made->count[s] = count[s];
        made->side[s] = (sf_polynomial *)(made + 1) + s * count[0];
        for (int k = 0; k < count[s]; k++) {
            const double *const row = rows[s][k];
            sf_polynomial *const to = &made->side[s][k];
            *to = (sf_polynomial){s ? 1.0 : -1.0, row[0], row[1], row[2], row[3], {{0.0}}};
            memcpy(to->sums, row + 4, sizeof to->sums);
        }
    }
    return &made->law;
}
