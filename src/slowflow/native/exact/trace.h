/* The response curve within one order of switches, as slowflow.exact.continuation follows it point by point. Takes a
 * point; returns the points after it, up to the first step with which anything is to be decided. */
#pragma once

#include "cycle.h"

/* Where the curve may go, and with what steps; steps of u_0 are a share of its size, of `least` at least: off the
 * centre it may pass 0. `first` is the point where it began, with its tangent, NULL where it
 * cannot come back to it in this order of switches. */
typedef struct {
    double low, high, step, straight, largest, least;
    int starts_from_rest;
    const double *first, *first_tangent;
} sf_course;

/* the numbers of a point: unknowns, tangent, A, its derivative along the curve, the monodromy matrix row by row */
static inline size_t sf_numbers_of_point(long k) { return (size_t)(2 * (k + 3) + 6); }

/* spans count too: where phases are about to vanish, the curve is smooth in them and in nothing else */
static inline double sf_weight(const sf_course *course, const double *z, long j, long size)
{
    const double u = fmax(fabs(z[0]), course->least);
    return j == 0 ? 1.0 / (u * u) : j == 1 ? 1.0 : j == size - 1 ? 4.0 : 0.1;
}

static double sf_inner(const sf_course *course, const double *z, const double *a, const double *b, long size)
{
    double sum = 0.0;
    for (long j = 0; j < size; j++)
        sum += sf_weight(course, z, j, size) * a[j] * b[j];
    return sum;
}

/* Whether the motion from z's start really switches in the order of the cycle, every switch at its time. */
static int sf_holds(sf_forced *forced, const sf_cycle *cycle, int starts_from_rest, const double *z, sf_phases *phases)
{
    const long k = cycle->k;
    for (long i = 0; i < k; i++)
        if (!(z[2 + i] > 0.0))
            return 0;
    forced->Omega = z[k + 2];
    const double end = z[1] + 0.5 * SF_TURN * cycle->half_turns;
    const sf_outcome outcome =
        sf_follow(forced, z[1], z[0], 0.0, end + SF_OVER_END, starts_from_rest ? cycle->phase : NULL, phases);
    if (outcome != SF_GOOD || phases->count < k)
        return 0;
    double at = z[1];
    for (long i = 0; i < k; i++) {
        const sf_phase *const phase = &phases->at[i];
        at += z[2 + i];
        if (phase->slip != cycle->phase[2 * i] || phase->region != cycle->phase[2 * i + 1] ||
            !(fabs(phase->end - at) < SF_ON_TIME))
            return 0;
    }
    return 1;
}

/* Where the curve is thought to be at a distance by `row`: along its tangent, bent as it was before. `before` is the
 * unknowns, the tangent and the row of the point before, NULL where there is none. */
static void sf_ahead(const double *z, const double *tangent, const double *before, const double *row, double distance,
                     long size, double *out)
{
    if (before == NULL) {
        for (long j = 0; j < size; j++)
            out[j] = z[j] + distance * tangent[j];
        return;
    }
    const double *const from = before, *const left = before + size, *const measure = before + 2 * size;
    double rate = 0.0, far = 0.0, passed = 0.0;
    for (long j = 0; j < size; j++)
        rate += measure[j] * tangent[j], far += measure[j] * (z[j] - from[j]);
    /* the cubic through both points along both tangents, over the distance as measured at the first */
    const double x = distance * rate / far;
    for (long j = 0; j < size; j++) {
        const double chord = z[j] - from[j];
        const double here = far / rate * tangent[j] - chord, there = far * left[j] - chord;
        const double bent = distance * tangent[j] + x * x * ((2.0 + x) * here + (1.0 + x) * there);
        out[j] = bent, passed += row[j] * bent;
    }
    for (long j = 0; j < size; j++)
        out[j] = z[j] + out[j] + (distance - passed) * tangent[j];
}

/* Points after the one with unknowns z and `tangent`, in the order of the curve, up to `room` of them: their number. It
 * stops short of the first step that turns, bends, leaves the range, loses the order of switches, meets the first point
 * or fails. `before` has 3 (k + 3) numbers, see sf_ahead; `has_before`, `step`, the next step's length, and `travelled`
 * are brought up to date. `work`: numbers for sf_newton and 5 (k + 3) more. */
static long sf_trace(sf_forced *forced, const sf_cycle *cycle, const sf_course *course, const double *z,
                     const double *tangent, double *before, int *has_before, double *step, double *travelled,
                     double *rows, long room, sf_equations *found, sf_phases *phases, double *work)
{
    const long k = cycle->k, size = k + 3;
    double *const row = work, *const next = row + size, *const direction = next + size, *const rest = direction + size;
    long count = 0;
    while (count < room) {
        double value = *step;
        for (long j = 0; j < size; j++) {
            row[j] = sf_weight(course, z, j, size) * tangent[j];
            value += row[j] * z[j];
        }
        sf_ahead(z, tangent, *has_before ? before : NULL, row, *step, size, next);
        const sf_extra extra = {SF_ROW, row, value, 0};
        if (sf_newton(forced, cycle, next, &extra, SF_ALONG, SF_TOLERANCE, found, direction, rest) != SF_GOOD)
            break;
        const double length = sqrt(sf_inner(course, next, direction, direction, size));
        double *const way = rest; /* which is free again */
        for (long j = 0; j < size; j++)
            direction[j] /= length, way[j] = next[j] - z[j];
        const int usable = sf_inner(course, z, tangent, direction, size) > course->straight &&
                           sqrt(sf_inner(course, z, way, way, size)) < 2.0 * *step;
        const int inside = course->low < next[size - 1] && next[size - 1] < course->high;
        if (!usable || !inside || direction[size - 1] * tangent[size - 1] < 0.0 || found->A > course->largest)
            break;
        if (course->first != NULL && *travelled + *step > 10.0 * course->step) {
            double from = 0.0, to = 0.0;
            for (long j = 0; j < size; j++) {
                const double weight = sf_weight(course, course->first, j, size) * course->first_tangent[j];
                from += weight * (z[j] - course->first[j]), to += weight * (next[j] - course->first[j]);
            }
            if (from < 0.0 && to >= 0.0)
                break;
        }
        if (!sf_holds(forced, cycle, course->starts_from_rest, next, phases))
            break;
        memcpy(before, z, (size_t)size * sizeof *before);
        memcpy(before + size, tangent, (size_t)size * sizeof *before);
        memcpy(before + 2 * size, row, (size_t)size * sizeof *before);
        *has_before = 1;
        double *const out = rows + (size_t)count * sf_numbers_of_point(k);
        memcpy(out, next, (size_t)size * sizeof *out);
        memcpy(out + size, direction, (size_t)size * sizeof *out);
        double rise = 0.0;
        for (long j = 0; j < size; j++)
            rise += found->of_A[j] * direction[j];
        out[2 * size] = found->A, out[2 * size + 1] = rise;
        memcpy(out + 2 * size + 2, found->monodromy, sizeof found->monodromy);
        z = out, tangent = out + size;
        count++;
        *travelled += *step;
        *step = fmin(1.5 * *step, course->step);
    }
    return count;
}
