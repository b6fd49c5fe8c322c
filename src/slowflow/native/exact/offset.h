/* Stationary motions about a mean, of a force that is not odd or under a load. Takes an oscillator with white noise or
 * a table; returns every linear oscillator that is equivalent.
 *
 * With the mean m and x = (u - m)/sigma, f - load has the averages A_n = E[He_n(x) (f - load)]: A_0 is 0, A_1 = sigma
 * k. At the mean m + sigma d and the mean square sigma^2 (1 + e) the derivative sigma^n d^n A_0/dm^n is
 *
 *     sum_j h_j(d, e) A_(n+j),    exp(d t + e t^2/2) = sum_j h_j(d, e) t^j
 *
 * and as E[He_n^2] = n! what higher orders add is bounded by the mean square of the force (derivations/extensions/
 * linearization.py). So one pass over the force bounds both equations and their slopes on a box of m and ln(sigma): it
 * holds no motion, or one by the interval Newton method, or it is cut. So is one that is wide beside sigma, unless
 * f - load has one sign wherever its motions are.
 *
 * Boxes cover all motions with displacements up to SF_ABOVE times the sizes that there are: how the force pushes
 * back bounds m and sigma, its slopes and jumps bound k, and that bounds sigma from below: under white noise by
 * sigma^2 k, under a table by the least I_0 of a grid of stiffnesses. */
#pragma once

#include "linearized.h"

/* orders of averages, and of those that are bounded; panels of Gauss's rule, in sigma */
enum { SF_ORDERS = 12, SF_TAIL = 56, SF_SLOPES = 4, SF_MOST_BOXES = 200000 };
#define SF_PANEL 1.0
/* half widths of boxes in sigma and in ln(sigma), from which on they are bounded; by how much more a box is looked at,
 * as a motion may be on its border; how much of a box may be left, or it is cut */
#define SF_MOST_WIDE 0.6
#define SF_MOST_HIGH 0.15
#define SF_OVERLAP 1.02
#define SF_SHRUNK 0.6
/* by how much more than its bounds the rest of a box is, so that these can be seen to be within */
#define SF_ROOM 0x1p-20
/* one motion, of two that are found next to each other */
#define SF_ONE_MOTION 1e-7
/* cells of u on either side; any two neighbours are wider together than one of these, and some meet at 0; decades below
 * and above the sizes that there are; every so many bounds are tried */
enum { SF_FAR_CELLS = 160, SF_MOST_FAR_CELLS = 4 * SF_FAR_CELLS + 8, SF_TRIED = 15, SF_STIFFNESSES = 64 };
#define SF_SOFTER 40.0
/* of f and of the load: how far their difference may be off; over the mean: a sigma at which few digits of it are left
 */
#define SF_CANCELS 0x1p-50
#define SF_TOO_SMALL 0x1p-26
/* over the largest size that there is: the least one that cells tell from 0; of ln(sigma): where doubles end */
#define SF_TINY 1e-12
#define SF_LOWEST (-700.0)
#define SF_BELOW 1e-4
#define SF_ABOVE 1e6

/* at a mean and a sigma: A_n, the mean square of f - load, how far A_0 may be off, and the square root of what of the
 * mean square is in higher orders */
typedef struct {
    double mean, sigma, A[SF_ORDERS], square, error, rest;
} sf_about;

static void sf_add_about(const sf_piece *piece, double load, double low, double high, sf_about *to) {
    const int least = piece->law->powers != NULL ? 1 : SF_LEAST_PARTS;
    const int panels = (int)fmax(least, ceil((high - low) / SF_PANEL));
    const double h = 0.5 * (high - low) / panels;
    for (int k = 0; k < panels; k++) {
        const double m = low + h * (2 * k + 1);
        double x[SF_IN_PART], hermite[SF_IN_PART], before[SF_IN_PART];
        for (int j = 0; j < SF_IN_PART; j++) {
            const int node = j % SF_NODES;
            x[j] = m + (j < SF_NODES ? -h : h) * sf_gauss_node[node];
            const double f = sf_value(piece, to->mean + to->sigma * x[j]) - load;
            hermite[j] = 0.5 * SF_DENSITY * h * sf_gauss_weight[node] * exp(-0.5 * x[j] * x[j]) * f;
            before[j] = 0.0;
            to->square += hermite[j] * f;
        }
        for (int n = 0; n < SF_ORDERS; n++)
            for (int j = 0; j < SF_IN_PART; j++) {
                const double next = x[j] * hermite[j] - n * before[j];
                to->A[n] += hermite[j];
                before[j] = hermite[j], hermite[j] = next;
            }
    }
}

static sf_about sf_averages_about(const sf_system *system, double mean, double sigma) {
    sf_about found = {.mean = mean, .sigma = sigma};
    for (int i = 0; i < system->pieces; i++) {
        const double low = fmax(i ? (system->edge[i] - mean) / sigma : -HUGE_VAL, -SF_FARTHEST);
        const double high = fmin(i + 1 < system->pieces ? (system->edge[i + 1] - mean) / sigma : HUGE_VAL, SF_FARTHEST);
        const double centre = -mean / sigma; /* where a law may have another series */
        if (low < centre && centre < high) {
            sf_add_about(&system->piece[i], system->load, low, centre, &found);
            sf_add_about(&system->piece[i], system->load, centre, high, &found);
        } else if (low < high)
            sf_add_about(&system->piece[i], system->load, low, high, &found);
    }
    double rest = found.square, factorial = 1.0;
    for (int n = 0; n < SF_ORDERS; factorial *= ++n)
        rest -= found.A[n] * found.A[n] / factorial;
    /* of the averages, and of f - load itself */
    found.error = SF_ERROR * sqrt(found.square) + SF_CANCELS * (fabs(system->load) + fabs(found.A[1] / sigma * mean));
    found.rest = sqrt(fmax(rest, 0.0)) + found.error;
    return found;
}

/* Between which ends sigma^n d^n A_0/dm^n, n up to 3, are where |d| and |e| are at most that. */
static void sf_slopes_about(const sf_about *at, double d, double e, sf_ends G[SF_SLOPES]) {
    double h[SF_TAIL];
    h[0] = 1.0, h[1] = d;
    for (int j = 1; j + 1 < SF_TAIL; j++)
        h[j + 1] = (d * h[j] + e * h[j - 1]) / (j + 1);
    for (int n = 0; n < SF_SLOPES; n++) {
        double radius = 0.0, tail = 0.0, factorial = 1.0;
        for (int j = 1; j <= n; j++)
            factorial *= j;
        for (int j = 0; j < SF_TAIL - SF_SLOPES; factorial *= n + ++j) {
            if (n + j < SF_ORDERS)
                radius += h[j] * ((j ? fabs(at->A[n + j]) : 0.0) + at->error * sqrt(factorial));
            else
                tail += factorial * h[j] * h[j];
        }
        radius += at->rest * sqrt(tail);
        G[n] = (sf_ends){at->A[n] - radius, at->A[n] + radius};
    }
}

/* Where |u| is in a cell on one side of 0, with how much f - load pushes back there at least, and its largest slope. */
typedef struct {
    double near, far, push, slope;
} sf_far_cell;

/* Cells up to far from 0. nearest, grows: up to where from 0 one is, and by how much |u| grows in others; P: Legendre
 * polynomials, by order and node of Gauss's rule */
typedef struct {
    int count;
    double nearest, grows;
    sf_far_cell at[SF_MOST_FAR_CELLS];
    double P[SF_IN_PART][SF_IN_PART];
} sf_far_cells;

static inline double sf_in_cell(int j) { return j < SF_NODES ? -sf_gauss_node[j] : sf_gauss_node[j - SF_NODES]; }

static void sf_put_legendre(sf_far_cells *to) {
    for (int j = 0; j < SF_IN_PART; j++) {
        to->P[0][j] = 1.0, to->P[1][j] = sf_in_cell(j);
        for (int n = 1; n + 1 < SF_IN_PART; n++)
            to->P[n + 1][j] = ((2 * n + 1) * to->P[1][j] * to->P[n][j] - n * to->P[n - 1][j]) / (n + 1);
    }
}

/* What a cell is known of, where the mean of f - load and by how much it varies at most. */
typedef struct {
    double mean, varies, slope;
} sf_cell;

/* By its Legendre series, as |P_n| is at most 1 and its slope n (n + 1)/2. Polynomials have no other orders, up to a
 * degree of 7; of other forces these are taken to add as much as SF_IN_PART times the last two at most. */
static sf_cell sf_cell_of(const sf_piece *piece, double load, double low, double high, const sf_far_cells *of) {
    const double m = 0.5 * (low + high), h = 0.5 * (high - low);
    double f[SF_IN_PART], steepest = 0.0;
    sf_cell found = {0.0, 0.0, 0.0};
    for (int j = 0; j < SF_IN_PART; j++)
        f[j] = sf_gauss_weight[j % SF_NODES] * (sf_value(piece, m + h * sf_in_cell(j)) - load);
    for (int n = 0; n < SF_IN_PART; n++) {
        double of_n = 0.0;
        for (int j = 0; j < SF_IN_PART; j++)
            of_n += (n + 0.5) * f[j] * of->P[n][j];
        const double size = fabs(of_n) * (n + 2 < SF_IN_PART ? 1 : 1 + SF_IN_PART);
        if (n == 0)
            found.mean = of_n;
        else
            found.varies += size;
        steepest += n == 1 ? of_n : 0.5 * n * (n + 1) * size;
    }
    found.slope = steepest / h;
    return found;
}

static void sf_put_cell(const sf_piece *piece, double load, double low, double high, sf_far_cells *to) {
    const double side = low < 0.0 ? -1.0 : 1.0;
    const sf_cell of = sf_cell_of(piece, load, low, high, to);
    if (isnan(of.mean)) /* there is no force */
        return;
    sf_far_cell cell = {fmin(fabs(low), fabs(high)), fmax(fabs(low), fabs(high)), side * of.mean - of.varies, of.slope};
    if (to->count > 0) { /* of narrow pieces next to each other what is worst */
        const sf_far_cell *const last = &to->at[to->count - 1];
        const double near = fmin(last->near, cell.near), far = fmax(last->far, cell.far);
        if (far <= to->grows * fmax(near, to->nearest)) {
            cell = (sf_far_cell){near, far, fmin(last->push, cell.push), fmax(last->slope, cell.slope)};
            to->count--;
        }
    }
    to->at[to->count++] = cell;
}

/* Of all pieces, in steps away from 0 that grow. */
static void sf_put_cells(const sf_system *system, double nearest, double farthest, sf_far_cells *to) {
    const double grows = pow(farthest / nearest, 1.0 / SF_FAR_CELLS);
    to->nearest = nearest, to->grows = grows;
    sf_put_legendre(to);
    for (int i = 0; i < system->pieces; i++) {
        const double end = i + 1 < system->pieces ? fmin(system->edge[i + 1], farthest) : farthest;
        for (double u = i ? system->edge[i] : -farthest, next; u < end; u = next) {
            next = u < -grows * nearest ? u / grows : u < 0.0 ? 0.0 : u < nearest ? nearest : u * grows;
            if (end - next < 0.5 * (next - u)) /* in a much narrower cell a slope is rounding */
                next = end;
            sf_put_cell(&system->piece[i], system->load, u, next, to);
        }
    }
}

/* power: of white noise, or 0; square, v: of the velocity under it, else 0 and by the table; most: of sigma^2 k; soft:
 * a stiffness that is taken for lower ones */
typedef struct {
    const sf_system *system;
    const sf_far_cells *cells;
    double power, square, v, most, soft;
    sf_over_u damping;
    sf_linearized by_table;
    int boxes;
    sf_motions *found;
} sf_offset;

/* ln I_0 at p = ln k, with a damping as near as that, and between which ends its slope is up to a distance r. */
static double sf_power_at(sf_offset *of, double p, double r, double near, sf_ends *by_p) {
    if (of->square > 0.0) {
        *by_p = (sf_ends){-1.0, -1.0};
        return log(of->square) - p;
    }
    const sf_equivalent at = sf_equivalent_by(&of->by_table, &of->damping, p, sf_band_reach(r), near);
    const double slope = at.moments.by[0][0] + at.moments.by[0][1] * sf_damping_by_p(&at);
    sf_ends by_u;
    *by_p = (sf_ends){slope, slope};
    if (r > 0.0)
        sf_slope_within(of->by_table.excited, &at, &of->damping, &of->damping, (double[2]){r, 0.0}, by_p, &by_u);
    of->v = exp(0.5 * at.moments.value[1]);
    return at.moments.value[0];
}

static inline sf_ends sf_ends_over(sf_ends a, sf_ends b) {
    return sf_ends_of_product(a, (sf_ends){1.0 / b.high, 1.0 / b.low});
}

static inline sf_ends sf_ends_less(sf_ends a, sf_ends b) { return (sf_ends){a.low - b.high, a.high - b.low}; }

/* From next to a motion: its digits, by Newton's iteration in the mean over sigma and ln(sigma). */
static void sf_put_offset(sf_offset *of, double mean, double sigma) {
    sf_about at = sf_averages_about(of->system, mean, sigma);
    double steps = HUGE_VAL, p = 0.0;
    for (int i = 0; i < SF_MOST_STEPS; i++) {
        sf_ends by_p;
        p = log(at.A[1] / at.sigma);
        const double X = sf_power_at(of, p, 0.0, SF_NEAREST, &by_p) - 2.0 * log(at.sigma);
        const double by_mean = by_p.low * at.A[2] / at.A[1], by_sigma = by_p.low * at.A[3] / at.A[1] - 2.0;
        const double all = at.A[1] * by_sigma - by_mean * at.A[2];
        const double step[2] = {(X * at.A[2] - at.A[0] * by_sigma) / all, (by_mean * at.A[0] - at.A[1] * X) / all};
        const double size = fmax(fabs(step[0]), fabs(step[1]));
        if (!(size < 0.5 * steps))
            break;
        steps = size;
        at = sf_averages_about(of->system, at.mean + at.sigma * step[0], at.sigma * exp(step[1]));
    }
    sf_motions *const to = of->found;
    if (at.sigma < SF_TOO_SMALL * fabs(at.mean)) {
        to->undecided[0] = -3.0;
        return;
    }
    int place = 0;
    for (int i = 0; i < to->count && i < to->max_count; i++) {
        if (fabs(to->at[i].mean - at.mean) <= SF_ONE_MOTION * at.sigma &&
            fabs(to->at[i].u - at.sigma) <= SF_ONE_MOTION * at.sigma)
            return;
        place += to->at[i].u < at.sigma;
    }
    const double k = of->square > 0.0 ? of->square / (at.sigma * at.sigma) : exp(p); /* A_1 may cancel */
    sf_put_motion(of->system, to, at.mean, at.sigma, at.square, of->v, k);
    for (int i = to->count - 1; i > place && i < to->max_count; i--) {
        const sf_stationary last = to->at[i];
        to->at[i] = to->at[i - 1], to->at[i - 1] = last;
    }
}

/* A box: |m - mean| up to a width, |ln(sigma) - t| up to a height. */
typedef struct {
    double mean, t, width, height;
} sf_offset_box;

static void sf_search_offset(sf_offset *of, sf_offset_box box);

static void sf_cut_offset(sf_offset *of, const sf_offset_box *box, int by_mean) {
    for (int side = -1; side <= 1; side += 2) {
        sf_offset_box half = *box;
        if (by_mean)
            half.width *= 0.5, half.mean += side * half.width;
        else
            half.height *= 0.5, half.t += side * half.height;
        sf_search_offset(of, half);
    }
}

/* The part of a box in which displacements from its centre, in sigma and in ln(sigma), are between ends: whether that
 * is much less, and then what is there is found. */
static int sf_shrinks(sf_offset *of, const sf_offset_box *box, double sigma, double d, double tall, sf_ends mean,
                      sf_ends t) {
    const double low = fmax(mean.low - SF_ROOM, -d), high = fmin(mean.high + SF_ROOM, d);
    const double from = fmax(t.low - SF_ROOM, -tall), to = fmin(t.high + SF_ROOM, tall);
    if (low > high || from > to)
        return 1;
    if ((high - low) * (to - from) > SF_SHRUNK * 4.0 * d * tall)
        return 0;
    sf_search_offset(of, (sf_offset_box){box->mean + 0.5 * sigma * (low + high), box->t + 0.5 * (from + to),
                                         0.5 * sigma * (high - low), 0.5 * (to - from)});
    return 1;
}

/* Whether f - load has one sign at all displacements of the motions in a box, so that its mean is not 0: of forces
 * without powers in boxes no wider than the cells. */
static int sf_pushes_one_way(const sf_offset *of, const sf_offset_box *box) {
    const sf_system *const system = of->system;
    const double reach = SF_OVERLAP * box->width + SF_FARTHEST * exp(box->t + SF_OVERLAP * box->height);
    const double least = box->mean - reach, most = box->mean + reach;
    const int wide = 2.0 * reach > (of->cells->grows - 1.0) * fmax(fabs(box->mean) - reach, of->cells->nearest);
    int signs = 0;
    for (int i = 0; i < system->pieces; i++)
        for (int side = -1; side <= 1; side += 2) { /* at u = 0 a law may have another series */
            const double low = fmax(i ? system->edge[i] : -HUGE_VAL, fmax(least, side < 0 ? -HUGE_VAL : 0.0));
            const double high =
                fmin(i + 1 < system->pieces ? system->edge[i + 1] : HUGE_VAL, fmin(most, side < 0 ? 0.0 : HUGE_VAL));
            if (!(low < high))
                continue;
            const sf_cell at = sf_cell_of(&system->piece[i], system->load, low, high, of->cells);
            if ((wide && system->piece[i].law->powers == NULL) || !(fabs(at.mean) > at.varies))
                return 0;
            signs |= at.mean > 0.0 ? 1 : 2;
        }
    return signs != 3;
}

static void sf_search_offset(sf_offset *of, sf_offset_box box) {
    const double sigma = exp(box.t), d = SF_OVERLAP * box.width / sigma, tall = SF_OVERLAP * box.height;
    const int wide = d * SF_MOST_HIGH > tall * SF_MOST_WIDE;
    const int is_place = d > SF_MOST_WIDE && box.width < SF_NARROW * fabs(box.mean);
    if (of->boxes++ >= SF_MOST_BOXES || is_place || fmin(d, tall) < SF_NARROW) {
        of->found->undecided[0] = sigma < SF_TOO_SMALL * fabs(box.mean) ? -3.0 : of->most / (sigma * sigma);
        of->found->undecided[1] = of->square > 0.0 ? of->power / of->square : exp(of->by_table.near.q);
        return;
    }
    if (d > SF_MOST_WIDE || tall > SF_MOST_HIGH) {
        if (!sf_pushes_one_way(of, &box))
            sf_cut_offset(of, &box, wide);
        return;
    }
    const sf_about at = sf_averages_about(of->system, box.mean, sigma);
    const sf_ends square = {exp(-2.0 * tall), exp(2.0 * tall)}, height = {-tall, tall};
    sf_ends G[SF_SLOPES];
    sf_slopes_about(&at, d, square.high - 1.0, G);
    if (!(G[0].low <= 0.0 && G[0].high >= 0.0 && G[1].high > 0.0))
        return;
    const sf_ends A_0 = {at.A[0] - at.error, at.A[0] + at.error}, turns = sf_ends_of_product(square, G[2]);
    if (G[1].low > 0.0) { /* A_0 alone bounds the mean */
        const sf_ends rest = sf_ends_of_product(turns, height);
        const sf_ends mean = sf_ends_over((sf_ends){-rest.high - A_0.high, -rest.low - A_0.low}, G[1]);
        if (sf_shrinks(of, &box, sigma, d, tall, mean, height))
            return;
    }
    const double low = log(fmax(G[1].low / sigma, of->soft)), high = log(fmax(G[1].high / sigma, of->soft));
    const double p = at.A[1] > of->soft * sigma ? log(at.A[1] / sigma) : 0.5 * (low + high);
    sf_ends by_p;
    const double near = of->square > 0.0 ? SF_ERROR : SF_AS_NEAR * (d + tall);
    const double L = sf_power_at(of, p, fmax(high - p, p - low), near, &by_p);
    const sf_ends all = sf_ends_of_product(by_p, (sf_ends){low - p, high - p});
    const double error = near + (G[1].low < of->soft * sigma ? 4.0 * SF_SOFT : 0.0);
    if (L + all.high + error < 2.0 * (box.t - tall) || L + all.low - error > 2.0 * (box.t + tall))
        return;
    if (G[1].low > of->soft * sigma) {
        const sf_ends by_mean = sf_ends_of_product(by_p, sf_ends_over(G[2], G[1]));
        sf_ends by_sigma = sf_ends_of_product(by_p, sf_ends_of_product(square, sf_ends_over(G[3], G[1])));
        by_sigma.low -= 2.0, by_sigma.high -= 2.0;
        const sf_ends both = sf_ends_less(sf_ends_of_product(G[1], by_sigma), sf_ends_of_product(by_mean, turns));
        if (both.low > 0.0 || both.high < 0.0) {
            const double X = L - 2.0 * box.t;
            const sf_ends of_X = {X - error, X + error};
            const sf_ends mean =
                sf_ends_over(sf_ends_less(sf_ends_of_product(of_X, turns), sf_ends_of_product(A_0, by_sigma)), both);
            const sf_ends t =
                sf_ends_over(sf_ends_less(sf_ends_of_product(by_mean, A_0), sf_ends_of_product(G[1], of_X)), both);
            if (mean.low > -d && mean.high < d && t.low > -tall && t.high < tall) {
                sf_put_offset(of, box.mean + 0.5 * sigma * (mean.low + mean.high), sigma * exp(0.5 * (t.low + t.high)));
                return;
            }
            if (sf_shrinks(of, &box, sigma, d, tall, mean, t))
                return;
        }
    }
    sf_cut_offset(of, &box, wide);
}

/* How far m and sigma are from 0, where E[(u - m) f] is at most that: from u f >= a |u|^n - c, n = 1 or 2, follows that
 * a E|u|^n is at most c more. Infinite where far from 0 the force does not push back. */
static double sf_farthest_motion(const sf_far_cells *of, double most) {
    double found = HUGE_VAL;
    for (int i = 0; i < of->count; i += SF_TRIED)
        for (int n = 1; n <= 2; n++) {
            double a = HUGE_VAL, c = 0.0;
            for (int j = 0; j < of->count; j++)
                if (of->at[j].far > of->at[i].near)
                    a = fmin(a, of->at[j].push / (n == 1 ? 1.0 : of->at[j].far));
            for (int j = 0; a > 0.0 && j < of->count; j++)
                c = fmax(c, of->at[j].far * (a * (n == 1 ? 1.0 : of->at[j].far) - of->at[j].push));
            if (a > 0.0) /* E|u| is at least sqrt(2/pi) sigma */
                found = fmin(found, n == 1 ? (most + c) / (a * SF_DENSITY) : sqrt((most + c) / a));
        }
    return found;
}

/* The largest stiffness at a sigma, E[f'], by slopes up to some |u|, and the height of jumps upwards. */
static double sf_stiffest(const sf_system *system, const sf_far_cells *of, double farthest, double sigma) {
    double slope = 0.0, rises = 0.0;
    for (int i = 0; i < of->count; i++)
        if (of->at[i].near <= farthest)
            slope = fmax(slope, of->at[i].slope);
    for (int i = 1; i < system->pieces; i++)
        rises +=
            fmax(sf_value(&system->piece[i], system->edge[i]) - sf_value(&system->piece[i - 1], system->edge[i]), 0.0);
    return slope + 0.5 * SF_DENSITY * rises / sigma;
}

/* ln(sigma) from which on, in steps, a motion may be: its sigma^2 is at least the least I_0 of stiffnesses up to the
 * largest one. Under a table that is looked up at samples, as I_0 has minima between its resonances. */
static double sf_lowest_motion(sf_offset *of, const sf_far_cells *cells, double farthest, double step) {
    const double top = log(farthest);
    const double stiffest = log(sf_stiffest(of->system, cells, (1.0 + SF_FARTHEST) * farthest, farthest / SF_SEARCHED));
    const double softest = fmax(log(of->soft), stiffest - SF_SOFTER);
    const double wide = (stiffest - softest) / (SF_STIFFNESSES - 1);
    double least[SF_STIFFNESSES], found = top;
    for (int i = 0; of->square == 0.0 && i < SF_STIFFNESSES; i++) {
        sf_ends by_p;
        const double L = sf_power_at(of, softest + wide * i, 0.0, SF_NEAREST, &by_p);
        least[i] = i ? fmin(least[i - 1], L) : L;
    }
    for (; found > SF_LOWEST; found -= step) {
        const double sigma = exp(found);
        const double p = log(sf_stiffest(of->system, cells, farthest + SF_FARTHEST * sigma, sigma));
        const double up_to = fmax(ceil((p - softest) / wide), 0.0);
        if (2.0 * found < (of->square > 0.0 ? log(of->square) - p : least[(int)fmin(up_to, SF_STIFFNESSES - 1)]))
            break;
    }
    return found;
}

/* Every stationary motion, by rising sigma; under white noise of a power c sigma_v^2, or a table where that is 0. The
 * outcome is 0 where friction holds the mass nearly all of the time, -1 where far from 0 the force does not push back.
 */
static int sf_offset_motions(const sf_system *system, double power, const sf_table *table, sf_motions *found) {
    const sf_under_table excited = {table, system};
    sf_offset of = {
        .system = system, .power = power, .soft = 0x1p-900, .damping = sf_damping_over_u(system, 1.0), .found = found};
    if (power > 0.0) {
        double c[3];
        of.v = sf_velocity(system, system->mu, system->zeta, power, c);
        of.most = of.square = of.v * of.v;
        if (of.square == 0.0)
            return 0; /* friction holds the mass: its velocity is below the range of doubles */
    } else {
        const double least = sf_least_damping(&excited, system->mu, system->zeta);
        if (least == HUGE_VAL)
            return 0;
        of.most = sf_most(table, least);
        of.soft = SF_SOFT * exp(2.0 * table->band[0].low);
        of.by_table = (sf_linearized){.excited = &excited, .near = {.q = -HUGE_VAL}, .found = found};
    }
    double small = sqrt(of.most), large = small;
    for (int i = 1; i < system->pieces; i++)
        if (system->edge[i] != 0.0)
            small = fmin(small, fabs(system->edge[i])), large = fmax(large, fabs(system->edge[i]));
    large = fmax(large, fabs(system->load));
    sf_far_cells cells = {0};
    sf_put_cells(system, fmax(small, SF_TINY * large) * SF_BELOW, large * SF_ABOVE, &cells);
    const double farthest = sf_farthest_motion(&cells, of.most);
    if (!(farthest < HUGE_VAL))
        return -1;
    of.cells = &cells;
    const double top = log(farthest), step = 2.0 * SF_MOST_HIGH / SF_OVERLAP;
    const double lowest = sf_lowest_motion(&of, &cells, farthest, step);
    for (double t = top; t > lowest; t -= step)
        sf_search_offset(&of, (sf_offset_box){0.0, t - 0.5 * step, farthest, 0.5 * step});
    return 1;
}

/* Every stationary motion, as `sf_offset_motions` of any force and load. */
static int sf_motions_of(const sf_system *system, double power, const sf_table *table, sf_motions *found) {
    if (!system->odd || system->load != 0.0)
        return sf_offset_motions(system, power, table, found);
    if (!(power > 0.0))
        return sf_tabulated(system, table, found);
    sf_white(system, power, found);
    return 1;
}
