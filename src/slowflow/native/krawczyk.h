/* Krawczyk's operator, x - Y f(x) + (1 - Y J)(X - x), where J are the slopes on X and Y is the inverse of their middle:
 * a box X that it maps into itself holds just one zero of f, and one that it maps off itself none. Takes as many
 * functions as unknowns, by their values at x and slopes on X; returns the image.
 */
#pragma once

#include "interval.h"

enum { SF_MOST_UNKNOWNS = 3 };

/* Values at the point, values and slopes on the box, and between which ends its solutions are. */
typedef struct {
    sf_interval at[SF_MOST_UNKNOWNS], on[SF_MOST_UNKNOWNS], slope[SF_MOST_UNKNOWNS][SF_MOST_UNKNOWNS],
        holds[SF_MOST_UNKNOWNS];
} sf_values;

/* X becomes the inverse of J times X, by Gauss's method; 0 where a pivot is 0. J is lost. */
static int sf_eliminate(int d, double J[][SF_MOST_UNKNOWNS], int columns, double X[][SF_MOST_UNKNOWNS]) {
    for (int k = 0; k < d; k++) {
        int best = k;
        for (int i = k + 1; i < d; i++)
            best = fabs(J[i][k]) > fabs(J[best][k]) ? i : best;
        for (int j = 0; j < d; j++) {
            const double one = J[k][j];
            J[k][j] = J[best][j], J[best][j] = one;
        }
        for (int j = 0; j < columns; j++) {
            const double one = X[k][j];
            X[k][j] = X[best][j], X[best][j] = one;
        }
        if (!(fabs(J[k][k]) > 0 && isfinite(J[k][k])))
            return 0;
        for (int i = 0; i < d; i++) {
            const double fraction = J[i][k] / J[k][k];
            for (int j = 0; i != k && j < d; j++)
                J[i][j] -= fraction * J[k][j];
            for (int j = 0; i != k && j < columns; j++)
                X[i][j] -= fraction * X[k][j];
        }
    }
    for (int i = 0; i < d; i++)
        for (int j = 0; j < columns; j++)
            X[i][j] /= J[i][i];
    return 1;
}

/* The image of what is within `wide` of a point: its centre and radius, infinite where there is no Y; and what of the
 * radius is due to how values are known. */
static void sf_krawczyk(int d, const double *at, const double *wide, const sf_values *of, double *centre,
                        double *radius, double *floor_) {
    double J[SF_MOST_UNKNOWNS][SF_MOST_UNKNOWNS], lost[SF_MOST_UNKNOWNS][SF_MOST_UNKNOWNS];
    double Y[SF_MOST_UNKNOWNS][SF_MOST_UNKNOWNS] = {{0}};
    int j, known = 1;
    for (int i = 0; i < d; i++)
        for (Y[i][i] = 1, j = 0; j < d; j++) {
            J[i][j] = lost[i][j] = 0.5 * (of->slope[i][j].lo + of->slope[i][j].hi);
            known = known && isfinite(of->slope[i][j].lo) && isfinite(of->slope[i][j].hi);
        }
    known = known && sf_eliminate(d, lost, d, Y);
    for (int i = 0; i < d; i++) {
        double shift = 0, error = 0x1p-51 * fabs(at[i]), reach = 0;
        for (j = 0; j < d; j++) {
            /* some multiplications of doubles, each a rounding */
            double product = 0, size = i == j, spread = 0;
            const double value = 0.5 * (of->at[j].lo + of->at[j].hi),
                         most = fmax(fabs(of->at[j].lo), fabs(of->at[j].hi));
            for (int k = 0; k < d; k++) {
                product += Y[i][k] * J[k][j], size += fabs(Y[i][k] * J[k][j]);
                spread += fabs(Y[i][k]) * 0.5 * (of->slope[k][j].hi - of->slope[k][j].lo);
            }
            shift += Y[i][j] * value, error += fabs(Y[i][j]) * 0.5 * (of->at[j].hi - of->at[j].lo);
            reach += (fabs((i == j) - product) + spread + 0x1p-49 * (size + spread)) * wide[j];
            reach += 0x1p-49 * fabs(Y[i][j]) * most;
        }
        centre[i] = at[i] - shift, floor_[i] = known ? error : HUGE_VAL;
        radius[i] = known && !isnan(reach + error) ? reach + error : HUGE_VAL;
    }
}

/* Whether the image lies within a box, or off it. */
static int sf_is_within(int d, const double *low, const double *high, const double *centre, const double *radius) {
    int within = 1;
    for (int i = 0; i < d; i++)
        within &= centre[i] - radius[i] > low[i] && centre[i] + radius[i] < high[i];
    return within;
}

static int sf_is_off(int d, const double *low, const double *high, const double *centre, const double *radius) {
    int off = 0;
    for (int i = 0; i < d; i++)
        off |= centre[i] - radius[i] > high[i] || centre[i] + radius[i] < low[i];
    return off;
}
