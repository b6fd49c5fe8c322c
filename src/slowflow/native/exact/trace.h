/* The response curve within one order of switches, as slowflow.exact.continuation follows it point by point. Takes a
 * point; returns the points after it, up to the first step with which anything is to be decided. */
#pragma once

#include "cycle.h"

/* over the last step, for the curve to be extrapolated by it */
#define SF_NO_LONGER 2.0

/* A point, unknowns and tangent. */
typedef struct {
    const double *z, *tangent;
} sf_curve_point;

/* Where the curve may go, and with what steps; steps of u_0 are a share of its size, of `least` at least: off the
 * centre it may pass 0. `first` is the point where it began, NULL where it cannot come back to it in this order of
 * switches. */
typedef struct {
    double low, high, step, straight, largest, least;
    int starts_from_rest;
    sf_curve_point first;
} sf_course;

/* The last point, and the one before, NULL where there is none; the length of the step that was tried last, and how far
 * it is from the first point. */
typedef struct {
    sf_curve_point last, before;
    double step, travelled;
} sf_trail;

/* the numbers of a point: unknowns, tangent, A, its derivative along the curve, the monodromy matrix row by row, and
 * whether the motion switches in the order of the cycle */
static inline size_t sf_numbers_of_point(long k) { return (size_t)(2 * (k + 3) + 7); }

/* spans count too: where phases are about to vanish, the curve is smooth in them and in nothing else */
static inline double sf_weight(const sf_course *course, const double *z, long j, long size) {
    const double u = fmax(fabs(z[0]), course->least);
    return j == 0 ? 1.0 / (u * u) : j == 1 ? 1.0 : j == size - 1 ? 4.0 : 0.1;
}

/* The square of a length is the inner product with itself, by the weights at z. */
static double sf_inner(const sf_course *course, const double *z, const double *a, const double *b, long size) {
    double sum = 0.0;
    for (long j = 0; j < size; j++)
        sum += sf_weight(course, z, j, size) * a[j] * b[j];
    return sum;
}

/* Whether the motion from z's start really switches in the order of the cycle, every switch at its time. */
static int sf_holds(sf_forced *forced, const sf_cycle *cycle, int starts_from_rest, const double *z,
                    sf_phases *phases) {
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

/* Where the curve is expected at a distance by `row`: along its tangent, bent as it was on the way from the point
 * before if that is not much shorter. */
static void sf_ahead(const sf_course *course, const sf_trail *trail, const double *row, double distance, long size,
                     double *out) {
    const double *const z = trail->last.z, *const tangent = trail->last.tangent;
    const sf_curve_point before = trail->before;
    double rate = 0.0, far = 0.0, passed = 0.0;
    for (long j = 0; before.z != NULL && j < size; j++) {
        const double measure = sf_weight(course, before.z, j, size) * before.tangent[j];
        rate += measure * tangent[j], far += measure * (z[j] - before.z[j]);
    }
    /* the cubic through both points along both tangents, over the distance as measured at the first */
    const double x = distance * rate / far;
    const int bends = before.z != NULL && fabs(x) <= SF_NO_LONGER;
    for (long j = 0; j < size; j++) {
        out[j] = distance * tangent[j];
        if (bends) {
            const double chord = z[j] - before.z[j];
            const double here = far / rate * tangent[j] - chord, there = far * before.tangent[j] - chord;
            out[j] += x * x * ((2.0 + x) * here + (1.0 + x) * there);
        }
        passed += row[j] * out[j];
    }
    for (long j = 0; j < size; j++)
        out[j] = z[j] + (bends ? out[j] + (distance - passed) * tangent[j] : out[j]);
}

/* Whether the curve passes its first point between z and `next`, not on another branch that is near in its tangent. */
static int sf_closes(const sf_course *course, const double *z, const double *next, long size, double *way) {
    double from = 0.0, to = 0.0, apart[2];
    for (int i = 0; i < 2; i++) {
        for (long j = 0; j < size; j++)
            way[j] = (i ? next : z)[j] - course->first.z[j];
        *(i ? &to : &from) = sf_inner(course, course->first.z, way, course->first.tangent, size);
        apart[i] = sf_inner(course, course->first.z, way, way, size);
    }
    return from < 0.0 && to >= 0.0 && sqrt(fmin(apart[0], apart[1])) <= 2.0 * course->step;
}

/* Points after the trail's in the order of the curve, up to `room` of them: their number. It pauses where anything is
 * to be decided; of a step that is not taken, but for SF_LOST, the point that it leads to is put down behind them.
 * `work`: numbers for sf_newton and 3 (k + 3) more. */
static long sf_trace(sf_forced *forced, const sf_cycle *cycle, const sf_course *course, sf_trail *trail, double *rows,
                     long room, sf_equations *found, sf_phases *phases, double *work, sf_pause *pause) {
    const long k = cycle->k, size = k + 3;
    double *const row = work, *const next = row + size, *const direction = next + size, *const rest = direction + size;
    for (long count = 0;;) {
        const double *const z = trail->last.z, *const tangent = trail->last.tangent;
        double value = trail->step;
        for (long j = 0; j < size; j++) {
            row[j] = sf_weight(course, z, j, size) * tangent[j];
            value += row[j] * z[j];
        }
        sf_ahead(course, trail, row, trail->step, size, next);
        const sf_extra extra = {SF_ROW, row, value, 0};
        *pause = SF_LOST;
        if (sf_newton(forced, cycle, next, &extra, SF_ALONG, SF_TOLERANCE, found, direction, rest) != SF_GOOD)
            return count;
        const double length = sqrt(sf_inner(course, next, direction, direction, size));
        double *const way = rest; /* which is free again */
        for (long j = 0; j < size; j++)
            direction[j] /= length, way[j] = next[j] - z[j];
        double *const out = rows + (size_t)count * sf_numbers_of_point(k);
        memcpy(out, next, (size_t)size * sizeof *out);
        memcpy(out + size, direction, (size_t)size * sizeof *out);
        double rise = 0.0;
        for (long j = 0; j < size; j++)
            rise += found->of_A[j] * direction[j];
        out[2 * size] = found->A, out[2 * size + 1] = rise;
        memcpy(out + 2 * size + 2, found->monodromy, sizeof found->monodromy);
        /* nearly straight between the points, and not much longer than the step */
        const int near = sf_inner(course, z, tangent, direction, size) > course->straight &&
                         sqrt(sf_inner(course, z, way, way, size)) < 2.0 * trail->step;
        const int inside = course->low < next[size - 1] && next[size - 1] < course->high;
        const int holds = sf_holds(forced, cycle, course->starts_from_rest, next, phases);
        out[2 * size + 6] = holds;
        *pause = !near ? SF_BENDS : !inside ? SF_LEAVES : SF_SWITCHES;
        if (!(near && inside && holds))
            return count;
        trail->travelled += trail->step;
        const int closes =
            course->first.z != NULL && trail->travelled > 10.0 * course->step && sf_closes(course, z, next, size, way);
        const int turns = direction[size - 1] * tangent[size - 1] < 0.0 || found->A > course->largest;
        trail->before = trail->last, trail->last = (sf_curve_point){out, out + size};
        *pause = closes ? SF_CLOSES : turns ? SF_TURNS : SF_FULL;
        if (++count == room || closes || turns)
            return count;
        trail->step = fmin(1.5 * trail->step, course->step);
    }
}
