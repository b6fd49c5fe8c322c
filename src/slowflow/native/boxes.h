/* All solutions of a few equations in boxes: none is missed, and each that is given is proved to be there, once. Takes
 * equations that give values and slopes on boxes and at points; returns points, and where doubles do not decide.
 *
 * A box is left only when some equation has no zero in it, when Krawczyk's operator maps a slightly larger one into
 * itself (it holds just one solution then) or out of it (none). Otherwise it is cut. What is left is smaller than
 * SF_BOX_NARROWEST of its place: it is undecided.
 */
#pragma once

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "krawczyk.h"

enum { SF_BOX_STEPS = 12 };

/* by how much of its half width a box is enlarged for the proof, so that a solution on an edge is inside of one */
#define SF_BOX_AROUND 0.125
/* a box is not cut further below this share of its place, and of 1; half the width below which it is not narrowed */
#define SF_BOX_NARROWEST 0x1p-42
#define SF_BOX_THIN 0x1p-43
/* what some operations on intervals are rounded by, as these ends are not moved one by one */
#define SF_BOX_ERROR 0x1p-40

/* least, most -- the ends of all that there is, beyond which no box is made larger; error -- how nearly it is known */
typedef struct {
    double low[SF_MOST_UNKNOWNS], high[SF_MOST_UNKNOWNS], least[SF_MOST_UNKNOWNS], most[SF_MOST_UNKNOWNS],
        error[SF_MOST_UNKNOWNS];
    ptrdiff_t of;
} sf_box;

/* Where equations are evaluated: on a box and at a point of it, of one of several systems. */
typedef struct {
    double low[SF_MOST_UNKNOWNS], at[SF_MOST_UNKNOWNS], high[SF_MOST_UNKNOWNS];
    ptrdiff_t of;
} sf_box_place;

/* As many as unknowns; `on` returns 0 where they could not be evaluated. */
typedef struct {
    int unknowns;
    int (*on)(void *self, ptrdiff_t n, const sf_box_place *points, sf_values *out);
    void *self;
} sf_box_equations;

/* A solution, and the box around `middle` that holds no other; or the middle of a box that may hold some. */
typedef struct {
    double x[SF_MOST_UNKNOWNS], middle[SF_MOST_UNKNOWNS], wide[SF_MOST_UNKNOWNS];
    ptrdiff_t of;
} sf_solution;

typedef struct {
    sf_solution *found, *undecided;
    ptrdiff_t count, open;
} sf_solutions;

enum { SF_BOXES_SOLVED, SF_BOXES_TOO_MANY, SF_BOXES_NO_ROOM, SF_BOXES_NOT_EVALUATED };

/* ==== One box ==================================================================================================== */

static inline double sf_box_size(double x) { return fmax(fabs(x), 1); }

/* Between which ends an equation by itself has its zeros in an unknown, from what the others move it by. */
static sf_interval sf_by_one(sf_interval value, sf_interval slope, double others, double at) {
    const double ends[2] = {others - value.lo, -others - value.hi}, slopes[2] = {slope.lo, slope.hi};
    sf_interval each = {HUGE_VAL, -HUGE_VAL};
    if (!sfi_has_sign(slope))
        return sfi_of(-HUGE_VAL, HUGE_VAL);
    for (int k = 0; k < 4; k++) {
        const double one = ends[k & 1] / slopes[k >> 1], error = SF_BOX_ERROR * fabs(one);
        if (isnan(one))
            return sfi_of(-HUGE_VAL, HUGE_VAL);
        each = sfi_of(fmin(each.lo, one - error), fmax(each.hi, one + error));
    }
    return sfi_of(at + each.lo, at + each.hi);
}

/* By how much an equation varies with an unknown, besides others in which it varies more. */
static double sf_varies(int d, const sf_values *of, int j, double width) {
    double most = 0;
    for (int i = 0; i < d; i++) {
        const double size = sf_magnitude(of->slope[i][j]);
        double scale = 0;
        for (int k = 0; k < d; k++)
            scale = isfinite(sf_magnitude(of->slope[i][k])) ? fmax(scale, sf_magnitude(of->slope[i][k])) : scale;
        most = fmax(most, isfinite(size) ? size / (scale > 0 ? scale : 1) : 1);
    }
    return fmax(most, 1e-3) * width;
}

/* Where equations are evaluated for a box: on a slightly larger one, and in the middle of that. */
static void sf_around(int d, const sf_box *box, sf_box_place *out) {
    int i;
    for (out->of = box->of, i = 0; i < d; i++) {
        const double around = SF_BOX_AROUND * 0.5 * (box->high[i] - box->low[i]) + box->error[i];
        out->low[i] = fmax(box->low[i] - around, box->least[i]);
        out->high[i] = fmin(box->high[i] + around, box->most[i]);
        out->at[i] = 0.5 * (out->low[i] + out->high[i]);
    }
}

enum { SF_BOX_EMPTY, SF_BOX_SOLVED, SF_BOX_NARROW, SF_BOX_CUT };

/* What is known of a box: a solution, or the middle of a narrow one, in `out`; else its halves. */
static int sf_judge(int d, const sf_box *box, const sf_box_place *place, const sf_values *of, sf_solution *out,
                    sf_box *lower, sf_box *upper) {
    double wide[SF_MOST_UNKNOWNS], centre[SF_MOST_UNKNOWNS] = {0}, radius[SF_MOST_UNKNOWNS], floor_[SF_MOST_UNKNOWNS],
                                   most = -1;
    sf_box left = *box;
    int narrow = 1, across = 0;
    for (int i = 0; i < d; i++)
        wide[i] = fmax(place->high[i] - place->at[i], place->at[i] - place->low[i]);
    sf_krawczyk(d, place->at, wide, of, centre, radius, floor_);
    int none = sf_is_off(d, box->low, box->high, centre, radius);
    for (int i = 0; i < d; i++) {
        double varies = 0, x = 0.5 * (box->low[i] + box->high[i]);
        for (int j = 0; j < d; j++)
            varies += sf_magnitude(of->slope[i][j]) * wide[j] * (1 + SF_BOX_ERROR);
        none |= sfi_has_sign(of->on[i]) || of->at[i].lo - varies > 0 || of->at[i].hi + varies < 0;
        narrow &= 0.5 * (box->high[i] - box->low[i]) <= SF_BOX_NARROWEST * sf_box_size(x);
        left.low[i] = fmax(left.low[i], of->holds[i].lo), left.high[i] = fmin(left.high[i], of->holds[i].hi);
        for (int j = 0; j < d; j++) {
            const double others = varies - sf_magnitude(of->slope[i][j]) * wide[j] + SF_BOX_ERROR * varies;
            const sf_interval one = sf_by_one(of->at[i], of->slope[i][j], others, place->at[j]);
            left.low[j] = fmax(left.low[j], one.lo), left.high[j] = fmin(left.high[j], one.hi);
        }
    }
    for (int i = 0; i < d; i++)
        none |= left.low[i] > left.high[i];
    if (none)
        return SF_BOX_EMPTY;
    for (int i = 0; i < d; i++)
        out->x[i] = centre[i], out->middle[i] = place->at[i], out->wide[i] = wide[i];
    out->of = box->of;
    if (sf_is_within(d, place->low, place->high, centre, radius))
        return SF_BOX_SOLVED;
    for (int i = 0; i < d; i++) {
        const double x = 0.5 * (box->low[i] + box->high[i]);
        /* what the operator leaves of a box holds what solutions it has; in no direction is it made so narrow that
         * roundings count there while it is still wide in others */
        const double low = fmax(left.low[i], centre[i] - radius[i]), high = fmin(left.high[i], centre[i] + radius[i]);
        const double more = fmax(SF_BOX_THIN * sf_box_size(x) - 0.5 * (high - low), 0);
        out->middle[i] = narrow ? x : out->middle[i];
        left.low[i] = low - more, left.high[i] = high + more;
        /* a proof has to be wider than the roundings that it holds */
        left.error[i] = isfinite(floor_[i]) ? 2 * floor_[i] : 0;
        double at = 0.5 * (left.low[i] + left.high[i]), varies = sf_varies(d, of, i, left.high[i] - left.low[i]);
        if (!(0.5 * (left.high[i] - left.low[i]) > SF_BOX_NARROWEST * sf_box_size(at)))
            varies = 0; /* one that is not to be cut further is not cut */
        if (varies > most)
            most = varies, across = i;
    }
    if (narrow)
        return SF_BOX_NARROW;
    *lower = *upper = left;
    lower->high[across] = upper->low[across] = 0.5 * (left.low[across] + left.high[across]);
    return SF_BOX_CUT;
}

/* ==== All boxes ================================================================================================== */

/* One of Newton's steps for each solution, `last` as long as the one before; 0 where none became shorter. */
static int sf_step_solutions(int d, ptrdiff_t n, sf_solution *found, const sf_values *values, double *last) {
    int moving = 0;
    for (ptrdiff_t k = 0; k < n; k++) {
        double J[SF_MOST_UNKNOWNS][SF_MOST_UNKNOWNS], change[SF_MOST_UNKNOWNS][SF_MOST_UNKNOWNS], length = 0;
        int j;
        for (int i = 0; i < d; i++)
            for (change[i][0] = 0.5 * (values[k].on[i].lo + values[k].on[i].hi), j = 0; j < d; j++)
                J[i][j] = 0.5 * (values[k].slope[i][j].lo + values[k].slope[i][j].hi);
        if (!sf_eliminate(d, J, 1, change))
            continue;
        for (int i = 0; i < d; i++)
            length = fmax(length, fabs(change[i][0]) / found[k].wide[i]);
        for (int i = 0; i < d && length < last[k]; i++)
            found[k].x[i] -= change[i][0];
        moving |= length < last[k] && length > 0;
        last[k] = length < last[k] ? length : 0;
    }
    return moving;
}

/* Newton's steps, for each solution as long as they become shorter. */
static int sf_refine_solutions(const sf_box_equations *of, ptrdiff_t n, sf_solution *found) {
    double *last = malloc((size_t)n * sizeof *last);
    sf_box_place *points = malloc((size_t)n * sizeof *points);
    sf_values *values = malloc((size_t)n * sizeof *values);
    int state = last && points && values ? SF_BOXES_SOLVED : SF_BOXES_NO_ROOM, moving = 1;
    for (ptrdiff_t k = 0; state == SF_BOXES_SOLVED && k < n; k++)
        last[k] = HUGE_VAL;
    for (int step = 0; state == SF_BOXES_SOLVED && moving && step < SF_BOX_STEPS; step++) {
        for (ptrdiff_t k = 0; k < n; k++) {
            memcpy(points[k].low, found[k].x, sizeof found->x), memcpy(points[k].high, found[k].x, sizeof found->x);
            memcpy(points[k].at, found[k].x, sizeof found->x), points[k].of = found[k].of;
        }
        state = of->on(of->self, n, points, values) ? SF_BOXES_SOLVED : SF_BOXES_NOT_EVALUATED;
        moving = state == SF_BOXES_SOLVED && sf_step_solutions(of->unknowns, n, found, values, last);
    }
    free(last), free(points), free(values);
    return state;
}

static int sf_by_system(const void *one, const void *other) {
    const sf_solution *a = one, *b = other;
    if (a->of != b->of)
        return a->of < b->of ? -1 : 1;
    for (int i = 0; i < SF_MOST_UNKNOWNS; i++)
        if (a->x[i] != b->x[i])
            return a->x[i] < b->x[i] ? -1 : 1;
    return 0;
}

/* Whether a place lies in the share of the box around a solution that holds no other. */
static int sf_is_around(int d, const sf_solution *found, const double *x, ptrdiff_t of, double fraction) {
    int inside = found->of == of;
    for (int i = 0; i < d; i++)
        inside &= fabs(x[i] - found->middle[i]) < fraction * found->wide[i];
    return inside;
}

/* Solutions each once: one on the edge of two boxes was found in both, which hold just one each; and the undecided
 * boxes that do not lie where a solution is proved to be the only one. */
static void sf_each_once(int d, sf_solutions *all) {
    ptrdiff_t kept = 0, open = 0, k, other;
    if (all->count > 1)
        qsort(all->found, (size_t)all->count, sizeof *all->found, sf_by_system);
    for (k = 0; k < all->count; k++) {
        for (other = kept; other > 0; other--)
            if (sf_is_around(d, &all->found[other - 1], all->found[k].x, all->found[k].of, 1))
                break;
        if (other == 0)
            all->found[kept++] = all->found[k];
    }
    for (k = 0, all->count = kept; k < all->open; k++) {
        for (other = 0; other < kept; other++)
            if (sf_is_around(d, &all->found[other], all->undecided[k].middle, all->undecided[k].of, 1 - SF_BOX_AROUND))
                break;
        if (other == kept)
            all->undecided[open++] = all->undecided[k];
    }
    all->open = open;
}

/* All solutions in n boxes, of which no more than `most` are evaluated in all; takes over `boxes`, a list of malloc,
 * and leaves `out` to be freed. */
static inline int sf_solve_boxes(const sf_box_equations *of, sf_box *boxes, ptrdiff_t n, ptrdiff_t most,
                                 sf_solutions *out) {
    const int d = of->unknowns;
    ptrdiff_t evaluated = 0, next;
    int state = SF_BOXES_SOLVED;
    memset(out, 0, sizeof *out);
    for (; state == SF_BOXES_SOLVED && n > 0; n = next) {
        sf_box *halves = malloc(2 * (size_t)n * sizeof *halves);
        sf_box_place *points = malloc((size_t)n * sizeof *points);
        sf_values *values = malloc((size_t)n * sizeof *values);
        sf_solution *found = realloc(out->found, (size_t)(out->count + n) * sizeof *found);
        sf_solution *undecided = realloc(out->undecided, (size_t)(out->open + n) * sizeof *undecided);
        out->found = found != NULL ? found : out->found;
        out->undecided = undecided != NULL ? undecided : out->undecided;
        next = 0, evaluated += n;
        if (!(halves && points && values && found && undecided))
            state = SF_BOXES_NO_ROOM;
        else if (evaluated > most)
            state = SF_BOXES_TOO_MANY;
        for (ptrdiff_t k = 0; state == SF_BOXES_SOLVED && k < n; k++)
            sf_around(d, &boxes[k], &points[k]);
        if (state == SF_BOXES_SOLVED && !of->on(of->self, n, points, values))
            state = SF_BOXES_NOT_EVALUATED;
        for (ptrdiff_t k = 0; state == SF_BOXES_SOLVED && k < n; k++) {
            sf_solution one = {{0}, {0}, {0}, 0};
            switch (sf_judge(d, &boxes[k], &points[k], &values[k], &one, halves + next, halves + n + next)) {
            case SF_BOX_SOLVED:
                found[out->count++] = one;
                break;
            case SF_BOX_NARROW:
                undecided[out->open++] = one;
                break;
            case SF_BOX_CUT:
                next++;
            }
        }
        if (next > 0)
            memmove(halves + next, halves + n, (size_t)next * sizeof *halves), next *= 2;
        free(boxes), free(points), free(values), boxes = halves;
    }
    free(boxes);
    if (state == SF_BOXES_SOLVED && out->count > 0)
        state = sf_refine_solutions(of, out->count, out->found);
    sf_each_once(d, out);
    return state;
}
