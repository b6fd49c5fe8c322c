/* Gaussian averages of an odd force. Takes an oscillator; returns them, and every root mean square of u at which E[u f]
 * has a value.
 *
 * Under white noise E[u f] is E[v^2] at a stationary motion: of statistical linearization that is an equation for sigma
 * alone. With sigma from a to b the density of u is at least a/b of that at a, and at most b/a of that at b; times
 * (u/sigma)^2 at least (a/b)^3 and at most (b/a)^3. So values at both ends of a cell bound E[u f] and its slope by
 * ln(sigma), E[u^3 f]/sigma^2 - E[u f], on all of it: it holds no root, or one at most, or it is cut. */
#pragma once

#include "follow.h"
#include "linearization.h"

/* |u|/sigma up to which a motion is looked at: the rest has a share of 1e-23; sigma in a part of a piece at most, and
 * parts of a piece at least: with the rule of sides.h averages are as near as roundings */
#define SF_FARTHEST 10.0
#define SF_WIDEST 1.0
enum { SF_LEAST_PARTS = 6, SF_MOST_FORCE_PARTS = 64, SF_SAMPLED = 128, SF_MOST_SAMPLES = 1024 };
/* sqrt(2/pi), as both sides of u = 0 are alike; x^2 from which on moments up to x are taken upwards */
#define SF_DENSITY 0.79788456080286536
#define SF_UPWARDS 6.0
enum { SF_MOMENTS = 2 * SF_FORCE_DEGREE + 2 };
/* of the size of its terms: how far a coefficient may be off, by far */
#define SF_ROUNDED 0x1p-45
/* of the range of f/u: by how much it may be off between samples */
#define SF_APART 0.01
/* of the averages' sizes: how far they may be off, by far; of the sizes that there are: how far is searched; of sigma:
 * a cell that is not cut any more */
#define SF_ERROR 0x1p-42
#define SF_SEARCHED 1e8
#define SF_NARROW 0x1p-40
/* by how much more than a bound of sigma is searched, as a motion may be there */
#define SF_ASIDE 1.001
/* by how much more or less sigma is where that is not known yet */
#define SF_FURTHER 4.0
enum { SF_MOST_CELLS = 5000, SF_MOST_STEPS = 100 };

/* A part of a piece. degree: of the polynomial in u that it is, with c next to its powers; -1 of any other force. odd:
 * whether it has odd powers alone */
typedef struct {
    const sf_piece *piece;
    double low, high, c[SF_FORCE_DEGREE + 1];
    int degree, odd;
} sf_part_of_force;

typedef struct {
    double low, high;
} sf_ends;

/* The force for u > 0: its pieces, or parts of these without a change of sign, where what is summed is smooth. small,
 * large: the sizes that there are; hardens: whether f/u is known not to fall; pulls: and not to be negative. Of other
 * forces u and secants are samples by rising u, and between which ends f/u is up to there */
typedef struct {
    double small, large;
    int count, samples, hardens, pulls;
    sf_part_of_force at[SF_MOST_FORCE_PARTS];
    double u[SF_MOST_SAMPLES];
    sf_ends secants[SF_MOST_SAMPLES];
} sf_positive;

static void sf_put_piece(const sf_piece *piece, double low, double high, sf_part_of_force *to) {
    to->piece = piece, to->low = low, to->high = high, to->degree = -1, to->odd = 1;
    if (piece->law->powers != NULL)
        to->degree = piece->law->powers(piece->p[1], to->c);
    for (int k = 0; k <= to->degree; k += 2)
        to->odd &= to->c[k] == 0.0;
}

static void sf_put_pieces(const sf_system *system, sf_positive *to) {
    to->count = to->samples = 0;
    for (int i = system->about + (system->jump != 0.0); i < system->pieces && to->count < SF_MOST_FORCE_PARTS; i++)
        sf_put_piece(&system->piece[i], fmax(system->edge[i], 0.0),
                     i + 1 < system->pieces ? system->edge[i + 1] : HUGE_VAL, &to->at[to->count++]);
}

/* A piece, cut where its force changes its sign between samples. */
static void sf_add_parts(const sf_part_of_force *whole, sf_positive *to) {
    const sf_piece *const piece = whole->piece;
    const double from = fmax(whole->low, 0.01 * to->small / SF_SEARCHED);
    const double top = fmin(whole->high, 2.0 * SF_FARTHEST * to->large * SF_SEARCHED);
    const double grows = pow(top / from, 1.0 / SF_SAMPLED);
    double u = from, sign = 0.0;
    sf_part_of_force part = *whole;
    for (int i = 0; i < SF_SAMPLED && to->count < SF_MOST_FORCE_PARTS - 1; i++) {
        const double next = i + 1 < SF_SAMPLED ? u * grows : top, f = sf_value(piece, next);
        if (f * sign < 0.0) {
            double a = u, b = next;
            for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b))
                *(sf_value(piece, m) * sign > 0.0 ? &a : &b) = m;
            part.high = b;
            to->at[to->count++] = part;
            part.low = b, part.high = whole->high;
        }
        sign = f != 0.0 ? f : sign, u = next;
        if (to->samples < SF_MOST_SAMPLES) {
            const sf_ends before = to->samples ? to->secants[to->samples - 1] : (sf_ends){HUGE_VAL, -HUGE_VAL};
            to->u[to->samples] = u;
            to->secants[to->samples++] = (sf_ends){fmin(before.low, f / u), fmax(before.high, f / u)};
        }
    }
    to->at[to->count++] = part;
}

/* How often the coefficients of a polynomial change their sign about a place, -1 where rounding hides it. They are
 * left there, with the sizes of their terms, and the first and the last sign, 0 if all are 0. */
static int sf_sign_changes(double *c, double *size, int degree, double place, int sign[2]) {
    int changes = 0;
    sign[0] = sign[1] = 0;
    for (int k = 0; k <= degree; k++)
        size[k] = fabs(c[k]);
    for (int j = 0; place > 0.0 && j < degree; j++)
        for (int k = degree - 1; k >= j; k--)
            c[k] += place * c[k + 1], size[k] += place * size[k + 1];
    for (int k = 0; k <= degree; k++) {
        if (size[k] == 0.0)
            continue;
        if (!(fabs(c[k]) > SF_ROUNDED * size[k]))
            return -1;
        const int own = c[k] > 0.0 ? 1 : -1;
        changes += sign[1] == -own, sign[1] = own;
        sign[0] = sign[0] ? sign[0] : own;
    }
    return changes;
}

/* Whether f/u is known not to fall: u^2 times its slope has no negative coefficient about the begin of a piece, and the
 * force does not jump downwards. */
static int sf_hardens(const sf_positive *pieces) {
    for (int i = 0; i < pieces->count; i++) {
        const sf_part_of_force *const at = &pieces->at[i];
        double c[SF_FORCE_DEGREE + 1], size[SF_FORCE_DEGREE + 1];
        int sign[2];
        for (int k = 0; k <= at->degree; k++)
            c[k] = (k - 1) * at->c[k];
        if (at->degree < 0 || sf_sign_changes(c, size, at->degree, at->low, sign) != 0 || sign[0] < 0)
            return 0;
        const double before = i ? sf_value(at[-1].piece, at->low) : 0.0, after = sf_value(at->piece, at->low);
        if (after - before < -SF_ROUNDED * fabs(before))
            return 0;
    }
    return 1;
}

static void sf_put_parts(const sf_system *system, double small, double large, sf_positive *to) {
    sf_positive whole;
    sf_put_pieces(system, &whole);
    to->hardens = sf_hardens(&whole);
    to->pulls = to->hardens && whole.at[0].c[0] == 0.0 && whole.at[0].c[1] >= 0.0;
    to->small = small, to->large = large, to->count = to->samples = 0;
    for (int i = 0; i < whole.count; i++)
        if (whole.at[i].low > 0.0)
            to->small = fmin(to->small, whole.at[i].low), to->large = fmax(to->large, whole.at[i].low);
    for (int i = 0; i < whole.count && to->count < SF_MOST_FORCE_PARTS; i++)
        if (to->pulls)
            to->at[to->count++] = whole.at[i];
        else
            sf_add_parts(&whole.at[i], to);
}

/* of where u f is positive and of where it is negative: |E[u f]|, |E[u^3 f]|/sigma^2; square: E[f^2]. Python reads
 * this layout. */
typedef struct {
    double sigma, first[2], third[2], square;
} sf_gaussian;

static inline double sf_first(const sf_gaussian *at) { return at->first[0] - at->first[1]; }
static inline double sf_third(const sf_gaussian *at) { return at->third[0] - at->third[1]; }

/* What a piece adds from x = low to high, parts 2 h wide: exp(-x^2/2) at x = m + h t is exp(-m^2/2) exp(-m h t)
 * exp(-h^2 t^2/2), of which the second goes from part to part by products. */
static void sf_add_piece(const sf_piece *piece, double low, double high, sf_gaussian *to) {
    const int pieces = (int)fmax(SF_LEAST_PARTS, ceil((high - low) / SF_WIDEST));
    const double h = 0.5 * (high - low) / pieces, sigma = to->sigma;
    double near[SF_NODES], grows[SF_NODES], over[SF_NODES], positive[2] = {0.0}, negative[2] = {0.0}, square = 0.0;
    for (int j = 0; j < SF_NODES; j++) {
        const double step = h * sf_gauss_node[j];
        near[j] = SF_DENSITY * h * sf_gauss_weight[j] * exp(-0.5 * step * step);
        grows[j] = exp((low + h) * step), over[j] = exp(2.0 * h * step);
    }
    for (int k = 0; k < pieces; k++) {
        const double m = low + h * (2 * k + 1), there = exp(-0.5 * m * m);
        for (int j = 0; j < SF_NODES; j++) {
            const double x[2] = {m - h * sf_gauss_node[j], m + h * sf_gauss_node[j]};
            const double weight[2] = {there * near[j] * grows[j], there * near[j] / grows[j]};
            for (int side = 0; side < 2; side++) {
                const double u = sigma * x[side], f = sf_value(piece, u), of_f = weight[side] * f, of_u = u * of_f;
                const double above = of_u > 0.0 ? of_u : 0.0, below = above - of_u, xx = x[side] * x[side];
                positive[0] += above, positive[1] += xx * above;
                negative[0] += below, negative[1] += xx * below;
                square += of_f * f;
            }
            grows[j] *= over[j];
        }
    }
    to->first[0] += positive[0], to->first[1] += negative[0];
    to->third[0] += positive[1], to->third[1] += negative[1];
    to->square += square;
}

/* Between which ends f/u is up to some u, a little wider than samples have it. */
static sf_ends sf_secants_up_to(const sf_positive *force, double u) {
    int i = 0;
    if (force->pulls) {
        while (i + 1 < force->count && force->at[i].high < u)
            i++;
        return (sf_ends){force->at[0].c[1], u < HUGE_VAL ? sf_value(force->at[i].piece, u) / u : HUGE_VAL};
    }
    while (i + 1 < force->samples && force->u[i] < u)
        i++;
    if (force->samples == SF_MOST_SAMPLES)
        return (sf_ends){-HUGE_VAL, HUGE_VAL};
    const sf_ends found = force->secants[i];
    const double more = SF_APART * (found.high - found.low);
    return (sf_ends){found.low - more, found.high + more};
}

/* The moments of x^0 to x^last beyond an end: of positive terms. */
static void sf_put_moments_beyond(double low, int last, double *m) {
    const double density = SF_DENSITY * exp(-0.5 * low * low);
    double power = density;
    m[0] = erfc(low * 0.70710678118654752), m[1] = density;
    for (int n = 2; n <= last; n++)
        power *= low, m[n] = (n - 1) * m[n - 2] + power;
}

/* Those of even powers up to an end: from x^0 upwards, or where that cancels downwards from the last one's series. */
static void sf_put_moments_up_to(double high, int last, double *m) {
    const double xx = high * high, density = high < SF_FARTHEST ? SF_DENSITY * exp(-0.5 * xx) : 0.0;
    double power[SF_MOMENTS];
    power[0] = density * high;
    for (int n = 2; n <= last; n += 2)
        power[n] = power[n - 2] * xx;
    if (xx > SF_UPWARDS) {
        m[0] = density > 0.0 ? erf(high * 0.70710678118654752) : 1.0;
        for (int n = 2; n <= last; n += 2)
            m[n] = (n - 1) * m[n - 2] - power[n - 2];
        return;
    }
    double term = power[last] / (last + 1), sum = term;
    for (double n = last + 3; term > 0x1p-56 * sum; n += 2.0)
        term *= xx / n, sum += term;
    m[last] = sum;
    for (int n = last; n > 0; n -= 2)
        m[n - 2] = (m[n] + power[n - 2]) / (n - 1);
}

/* What a polynomial adds up to x = high, if it is odd, or from x = low on. */
static void sf_add_polynomial(const sf_part_of_force *part, double low, double high, sf_gaussian *to) {
    const int least = low == 0.0 && part->odd, by = 1 + least, degree = part->degree;
    const int last = 2 * degree > degree + 3 ? 2 * degree : degree + 3;
    double m[SF_MOMENTS], f[SF_FORCE_DEGREE + 1], scale = 1.0, first = 0.0, third = 0.0;
    if (least)
        sf_put_moments_up_to(high, last + (last & 1), m);
    else
        sf_put_moments_beyond(low, last, m);
    for (int k = 0; k <= degree; k++, scale *= to->sigma)
        f[k] = part->c[k] * scale;
    for (int k = least; k <= degree; k += by) {
        first += f[k] * m[k + 1], third += f[k] * m[k + 3];
        for (int j = least; j <= degree; j += by)
            to->square += f[k] * f[j] * m[k + j];
    }
    to->first[first < 0.0] += to->sigma * fabs(first), to->third[third < 0.0] += to->sigma * fabs(third);
}

static sf_gaussian sf_averages(const sf_positive *force, double sigma) {
    sf_gaussian found = {.sigma = sigma};
    for (int i = 0; i < force->count; i++) {
        const sf_part_of_force *const part = &force->at[i];
        const double low = part->low / sigma, high = fmin(part->high / sigma, SF_FARTHEST);
        if (!(high > low))
            continue;
        if (part->degree >= 0 && (high == SF_FARTHEST || (low == 0.0 && part->odd)))
            sf_add_polynomial(part, low, high, &found);
        else
            sf_add_piece(part->piece, low, high, &found);
    }
    return found;
}

/* How often u f - square changes its sign, or 2 where that may be more than once. sigma (E[u f] - square) is a Laplace
 * transform of it, at 1/(2 sigma^2): it has no more zeros than that (Laguerre). In a part the coefficients about its
 * begin do not change their sign less often (Descartes), and one change follows from the signs at both ends. */
static int sf_changes(const sf_positive *force, double square) {
    int changes = 0, before = -1;
    for (int i = 0; i < force->count; i++) {
        const sf_part_of_force *const part = &force->at[i];
        const int degree = part->degree + 1;
        const double width = part->high - part->low;
        double c[SF_FORCE_DEGREE + 2] = {-square}, size[SF_FORCE_DEGREE + 2], end = 0.0, end_size = 0.0;
        int sign[2];
        for (int k = 1; k <= degree; k++)
            c[k] = part->c[k - 1];
        const int within = sf_sign_changes(c, size, degree, part->low, sign);
        if (degree == 0 || within < 0 || within > 1)
            return 2;
        if (width < HUGE_VAL) {
            for (int k = degree; k >= 0; k--)
                end = c[k] + width * end, end_size = size[k] + width * end_size;
            if (!(fabs(end) > SF_ROUNDED * end_size))
                return 2;
            sign[1] = end > 0.0 ? 1 : -1;
        }
        changes += (sign[0] != before) + (sign[1] != sign[0]), before = sign[1];
    }
    return changes < 2 ? changes : 2;
}

/* A stationary motion: mean of u, root mean squares of u about it and of v, mean square of what the spring and the
 * damping push with, k, c, what of that is dry friction's, and the share of the time beyond the first breakpoint on
 * either side. Python reads this layout. */
typedef struct {
    double mean, u, v, square, k, c, dry, beyond;
} sf_stationary;

/* Motions that are found. max_count: room for so many; count: of all that there are; undecided: k and c next to which
 * there may be others, or 0 */
typedef struct {
    int max_count, count;
    double undecided[2];
    sf_stationary *at;
} sf_motions;

/* Damping in the mean over u at a sigma_u: friction, which may end at a displacement, and the viscous ratio, with
 * slopes by ln(sigma_u). That of the logarithm of friction falls as sigma_u rises. level: the end over sigma_u; within:
 * P(|u| < end) */
typedef struct {
    double mu, zeta, mu_slope, zeta_slope, level, within;
} sf_over_u;

/* of the piece about u = 0, on either side; infinite without another one */
static inline void sf_first_ends(const sf_system *system, double ends[2]) {
    const int width = system->jump != 0.0, below = system->about - width, above = system->about + 1 + width;
    ends[0] = below > 0 ? system->edge[below] : -HUGE_VAL;
    ends[1] = above < system->pieces ? system->edge[above] : HUGE_VAL;
}

static sf_over_u sf_damping_over_u(const sf_system *system, double sigma) {
    double ends[2] = {-HUGE_VAL, HUGE_VAL};
    if (system->released)
        sf_first_ends(system, ends);
    const double level = fmin(ends[1] / sigma, SF_FARTHEST), within = erf(level * 0.70710678118654752);
    double of[4];
    linearization_over_displacements(level, within, sigma, system->mu, system->zeta, system->zeta_2, of);
    return (sf_over_u){of[0], of[1], of[2], of[3], level, within};
}

static inline void sf_equivalent_damping(const sf_system *system, double v, double mu, double zeta, double c[3]) {
    linearization_equivalent_damping(v, mu, zeta, system->c_2, system->c_3, c);
}

/* square: of the spring's force */
static void sf_put_motion(const sf_system *system, sf_motions *to, double mean, double sigma, double square, double v,
                          double k) {
    if (to->count++ >= to->max_count)
        return;
    const sf_over_u of = sf_damping_over_u(system, sigma);
    double c[3], ends[2];
    sf_equivalent_damping(system, v, of.mu, of.zeta, c);
    const double resists = linearization_damping_force(of.level, of.within, sigma, v, system->mu, system->zeta,
                                                       system->c_2, system->c_3, system->zeta_2);
    sf_first_ends(system, ends);
    const double over = 0.70710678118654752 / sigma;
    const double beyond = 0.5 * (erfc((mean - ends[0]) * over) + erfc((ends[1] - mean) * over));
    to->at[to->count - 1] = (sf_stationary){mean, sigma, v, square + resists, k, c[0], c[2], beyond};
}

static inline sf_ends sf_ends_of_product(sf_ends a, sf_ends b) {
    const double each[4] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    sf_ends found = {each[0], each[0]};
    for (int i = 1; i < 4; i++) {
        found.low = each[i] < found.low ? each[i] : found.low;
        found.high = each[i] > found.high ? each[i] : found.high;
    }
    return found;
}

/* Between which ends the slopes of ln(c) by ln(sigma_v) and ln(sigma_u) are in a cell, for velocities v: that by
 * ln(sigma_v) rises with v, falls with friction, and is monotone in zeta. */
static void sf_damping_within(const sf_system *system, const sf_over_u *a, const sf_over_u *b, sf_ends v, sf_ends *by_v,
                              sf_ends *by_u) {
    double slow[2][3], fast[2][3];
    for (int i = 0; i < 2; i++) {
        sf_equivalent_damping(system, v.low, a->mu, (i ? b : a)->zeta, slow[i]);
        sf_equivalent_damping(system, v.high, b->mu, (i ? a : b)->zeta, fast[i]);
    }
    *by_v = (sf_ends){fmin(slow[0][1] / slow[0][0], slow[1][1] / slow[1][0]),
                      fmax(fast[0][1] / fast[0][0], fast[1][1] / fast[1][0])};
    const double least = slow[0][0] - slow[0][2] + fast[0][2], most = fast[0][0] - fast[0][2] + slow[0][2];
    const double first = a->mu > 0.0 ? a->mu_slope / a->mu : 0.0, last = b->mu > 0.0 ? b->mu_slope / b->mu : 0.0;
    const sf_ends slope = {slow[0][2] * last + 2.0 * a->zeta_slope, fast[0][2] * first + 2.0 * b->zeta_slope};
    *by_u = sf_ends_of_product(slope, (sf_ends){1.0 / most, 1.0 / least});
}

/* sigma_v under white noise of a power pi S_0 = c sigma_v^2, and c there; with friction and zeta alone in closed form.
 * The slope of ln(c) by ln(sigma_v) rises from -1 on: from the second step on Newton's iteration for that comes from
 * above. */
static double sf_velocity(const sf_system *system, double mu, double zeta, double power, double c[3]) {
    sf_equivalent_damping(system, 1.0, mu, 0.0, c);
    const double dry = c[2], resists = dry + sqrt(dry * dry + 8.0 * zeta * power);
    double v = resists > 0.0 ? 2.0 * power / resists : sqrt(power), step = 1.0;
    for (int i = 0; i < SF_MOST_STEPS && fabs(step) > 0x1p-28; i++) {
        sf_equivalent_damping(system, v, mu, zeta, c);
        step = log(power / (c[0] * v * v)) / (2.0 + c[1] / c[0]);
        v *= exp(step);
    }
    return v;
}

/* What E[u f] is to be: v^2, and its slope by ln(sigma_u). */
typedef struct {
    double v, square, slope;
} sf_level;

/* varies: whether the level depends on sigma_u; if not, at */
typedef struct {
    const sf_system *system;
    const sf_positive *force;
    double power;
    int varies;
    sf_level at;
    int cells;
    sf_motions *found;
} sf_balances;

static sf_level sf_level_at(const sf_balances *of, double sigma) {
    if (!of->varies && of->at.v > 0.0)
        return of->at;
    const sf_over_u at = sf_damping_over_u(of->system, sigma);
    double c[3];
    const double v = sf_velocity(of->system, at.mu, at.zeta, of->power, c), square = v * v;
    const double by_u = (at.mu > 0.0 ? c[2] * at.mu_slope / at.mu : 0.0) + 2.0 * at.zeta_slope;
    return (sf_level){v, square, -2.0 * square * by_u / (2.0 * c[0] + c[1])};
}

/* Between which ends the level and its slope are in a cell. */
static void sf_level_within(const sf_balances *of, double low, double high, sf_ends *square, sf_ends *slope) {
    *square = (sf_ends){of->at.square, of->at.square}, *slope = (sf_ends){0.0, 0.0};
    if (!of->varies)
        return;
    const sf_over_u a = sf_damping_over_u(of->system, low), b = sf_damping_over_u(of->system, high);
    double c[3];
    const sf_ends v = {sf_velocity(of->system, a.mu, b.zeta, of->power, c),
                       sf_velocity(of->system, b.mu, a.zeta, of->power, c)};
    sf_ends by_v, by_u;
    sf_damping_within(of->system, &a, &b, v, &by_v, &by_u);
    *square = (sf_ends){v.low * v.low, v.high * v.high};
    const sf_ends over = {-2.0 / (2.0 + by_v.low), -2.0 / (2.0 + by_v.high)};
    *slope = sf_ends_of_product(sf_ends_of_product(by_u, over), *square);
}

/* The root between two sigma where E[u f] less the level is monotone, by Newton's iteration for its logarithm. */
static sf_gaussian sf_balanced(const sf_balances *of, double low, double high, int rises, sf_gaussian at) {
    for (int i = 0; i < SF_MOST_STEPS; i++) {
        const sf_level level = sf_level_at(of, at.sigma);
        const double first = sf_first(&at), excess = log(level.square / first);
        const double step = excess / (sf_third(&at) / first - 1.0 - level.slope / level.square);
        const int below = (first < level.square) == rises;
        *(below ? &low : &high) = at.sigma;
        double next = at.sigma * exp(step);
        if (!(next > low && next < high)) {
            if (fabs(step) <= 0x1p-48 || high <= low * (1.0 + 0x1p-51))
                break;
            next = low > 0.0 && high < HUGE_VAL ? sqrt(low * high) : at.sigma * (below ? SF_FURTHER : 1.0 / SF_FURTHER);
        }
        /* as many digits come as there are: E[u f] and its logarithm are straight enough */
        const int last = fabs(step) * fmax(fabs(step), fabs(excess)) <= 0x1p-60;
        at = sf_averages(of->force, next);
        if (last)
            break;
    }
    return at;
}

static void sf_put_balanced(const sf_balances *of, double low, double high, int rises, sf_gaussian from) {
    const sf_gaussian at = sf_balanced(of, low, high, rises, from);
    const sf_level level = sf_level_at(of, at.sigma); /* E[u f] itself cancels where a spring pushes away from 0 */
    sf_put_motion(of->system, of->found, 0.0, at.sigma, at.square, level.v, level.square / (at.sigma * at.sigma));
}

/* By the ratio of the ends: those of forces beyond the range of doubles are 0, inf or NaN, and would be cut for ever.
 */
static int sf_can_be_cut(double grows) { return grows > 1.0 + SF_NARROW && grows < HUGE_VAL; }

static void sf_search_balances(sf_balances *of, const sf_gaussian *a, const sf_gaussian *b) {
    const double grows = b->sigma / a->sigma, cube = grows * grows * grows;
    const double least = a->first[0] / grows - b->first[1] * grows, most = b->first[0] * grows - a->first[1] / grows;
    const double error = SF_ERROR * (b->first[0] + b->first[1]);
    sf_ends level, slope;
    sf_level_within(of, a->sigma, b->sigma, &level, &slope);
    if (least - error > level.high || most + error < level.low)
        return;
    const double steep = SF_ERROR * (b->third[0] + b->third[1]) + error;
    if (a->third[0] / cube - b->third[1] * cube - most - slope.high > steep ||
        b->third[0] * cube - a->third[1] / cube - least - slope.low < -steep) {
        const int rises = sf_first(a) < sf_level_at(of, a->sigma).square;
        if (rises != (sf_first(b) < sf_level_at(of, b->sigma).square))
            sf_put_balanced(of, a->sigma, b->sigma, rises, rises ? *b : *a);
        return;
    }
    if (!sf_can_be_cut(grows) || of->cells++ >= SF_MOST_CELLS) {
        if (!isnan(sf_first(a)) && !isnan(sf_first(b))) { /* where the force is not known there is no motion */
            of->found->undecided[0] = level.high / (a->sigma * a->sigma);
            of->found->undecided[1] = of->power / level.high;
        }
        return;
    }
    const sf_gaussian middle = sf_averages(of->force, sqrt(a->sigma) * sqrt(b->sigma));
    if (!(isnan(sf_first(a)) && isnan(sf_first(&middle))))
        sf_search_balances(of, a, &middle);
    if (!(isnan(sf_first(&middle)) && isnan(sf_first(b))))
        sf_search_balances(of, &middle, b);
}

/* Under white noise of a power pi S_0 = c sigma_v^2: every stationary motion, by rising sigma_u. */
static void sf_white(const sf_system *system, double power, sf_motions *found) {
    sf_balances of = {.system = system, .power = power, .found = found};
    of.varies = system->released || system->zeta_2 != 0.0;
    of.at = sf_level_at(&of, 1.0);
    sf_positive force;
    of.force = &force;
    sf_put_pieces(system, &force);
    const int changes = of.varies ? 2 : sf_changes(&force, of.at.square);
    if (changes < 2) { /* from -square on */
        if (changes)
            sf_put_balanced(&of, 0.0, HUGE_VAL, 1, sf_averages(&force, of.at.v));
        return;
    }
    sf_put_parts(system, of.at.v, of.at.v, &force);
    sf_ends square, slope;
    sf_level_within(&of, force.small / SF_SEARCHED, force.large * SF_SEARCHED, &square, &slope);
    /* E[u f]/sigma^2 is between the secants: from above v over the root of the least one there is no motion, nor below
     * that of the largest one up to there */
    const double least = sf_secants_up_to(&force, HUGE_VAL).low;
    const double to = fmin(force.large * SF_SEARCHED, least > 0.0 ? SF_ASIDE * sqrt(square.high / least) : HUGE_VAL);
    const double most = sf_secants_up_to(&force, SF_FARTHEST * to).high;
    const double from = fmax(force.small / SF_SEARCHED, most > 0.0 ? sqrt(square.low / most) / SF_ASIDE : 0.0);
    const sf_gaussian a = sf_averages(&force, from), b = sf_averages(&force, to);
    sf_search_balances(&of, &a, &b);
}
