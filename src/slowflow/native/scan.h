/* Zeros along the amplitude: in go a range of A and a question, out come all its zeros.
 *
 * A chart spaces the samples as the force varies: evenly in log A below the first breakpoint, and above a breakpoint b
 * by A = b (y + 1/y)/2, y = 1 + e, evenly in log e: the averaged force is analytic in sqrt(A^2 - b^2), not in A.
 */
#ifndef SF_SCAN_H
#define SF_SCAN_H

#include "zeros.h"

static void sf_sample_at(const sf_model *model, double A, sf_sample *at) {
    at->A = A;
    model->mechanism->averaged(1, &at->A, model->p, at->averages);
}

/* Whether h, h_A and h_AA have the signs that they have far below, where the lowest power of A rules. */
static int sf_has_first_signs(const sf_model *model, const sf_sample *at) {
    sf_sample below;
    sf_sample_at(model, 0x1p-10 * at->A, &below);
    return !sf_opposite(at->h, below.h) && !sf_opposite(at->h_A, below.h_A) && !sf_opposite(at->h_AA, below.h_AA);
}

/* Whether nothing but the response's upper end is left at this amplitude of the first piece and below: F_AA > 0 for all
 * Omega, because h_A or damping outweighs terms that vanish with A^2. Then F_A > 0, there is no fold, and each extremum
 * of F over Omega rises with A; below F_0 (if it is given, > 0) it stays below. */
static int sf_quiet_below(const sf_model *model, double F_0, const sf_sample *at) {
    const double zz = 4 * model->zeta * model->zeta, h_A = at->h_A, bend = fabs(at->A * at->h_AA);
    const double along = fabs(at->h_AA * (at->A * h_A - at->h));
    const int steady = bend < 0.25 * fabs(h_A); /* h is nearly linear from here down */
    /* F_AA/2 = X^2 + c_1 X + c_0 in X = Omega^2 has no real root; or c_1 > 0 and c_0 > 0 */
    const int no_root = steady && 0.25 * bend * (bend + 2 * zz) + along < -0.25 * zz * (h_A + 0.25 * zz);
    const int positive = fabs(at->h * at->h_AA) < 0.25 * h_A * h_A;
    const int negative = steady && positive && bend < 0.5 * (h_A + 0.5 * zz);
    const int damped = fabs(h_A) + bend < 0.25 * zz && at->h * at->h_AA >= 0 && sf_has_first_signs(model, at);
    sf_answer peak;
    if (!(no_root || negative || damped || (model->zeta == 0 && at->A < SF_DEEP)))
        return 0;
    if (!(F_0 > 0))
        return 1;
    sf_ask(SF_PEAK, model, F_0, at, &peak);
    return peak.merge < 0 && !(peak.exists[0] && peak.y[0] >= 0) && !(peak.exists[1] && peak.y[1] >= 0);
}

/* Samples from the lowest amplitude that matters, at F_0 or, with F_0 = 0, to the fold locus, up to `end`, within (0, b]
 * of the first piece. */
static sf_status sf_nodes_from_zero(const sf_model *model, double F_0, double end, sf_nodes *nodes) {
    double A = end;
    int n = 0, i;
    for (;;) {
        sf_sample *at = &nodes->at[n++];
        sf_sample_at(model, A, at);
        if (n == SF_MOST_NODES)
            return SF_NO_BOUND;
        if (n > 1 && (sf_quiet_below(model, F_0, at) || A < SF_DEEPEST))
            break;
        A *= SF_STEP_DOWN;
    }
    for (i = 0; i < n / 2; i++) {
        const sf_sample swap = nodes->at[i];
        nodes->at[i] = nodes->at[n - 1 - i];
        nodes->at[n - 1 - i] = swap;
    }
    nodes->n = n;
    return SF_OK;
}

/* Samples from just above the breakpoint up to `end`. Next to it the force is a power series in e, and its samples lie
 * further apart. */
static sf_status sf_nodes_above(const sf_model *model, double b, double end, sf_nodes *nodes) {
    const double first = nextafter(b, HUGE_VAL);
    double e = SF_FIRST_ABOVE, A = first;
    int n = 0;
    while (A < end) {
        if (n == SF_MOST_NODES - 1)
            return SF_NO_BOUND;
        sf_sample_at(model, A, &nodes->at[n++]);
        do {
            e *= e < SF_NEAR_BREAK ? SF_STEP_NEAR : SF_STEP_UP;
            A = b + b * e * e / (2 * (1 + e));
        } while (!(A > nodes->at[n - 1].A));
    }
    sf_sample_at(model, end, &nodes->at[n++]);
    nodes->n = n;
    return SF_OK;
}

typedef struct {
    const sf_model *model;
    sf_question question;
    int channel;
    double F_0;
    sf_zeros *found;
} sf_search;

typedef struct {
    sf_sample at;
    sf_answer answer;
} sf_probe;

static void sf_probe_at(const sf_search *search, double A, sf_probe *probe) {
    sf_sample_at(search->model, A, &probe->at);
    sf_ask(search->question, search->model, search->F_0, &probe->at, &probe->answer);
}

/* The zero between two probes with values on either side of it: Newton's steps, kept in the bracket. */
static void sf_bracketed_zero(const sf_search *search, const sf_probe *a, const sf_probe *b) {
    const int c = search->channel, rising = a->answer.y[c] < 0;
    double lo = a->at.A, hi = b->at.A, last = hi - lo;
    sf_probe probe = fabs(a->answer.y[c]) < fabs(b->answer.y[c]) ? *a : *b;
    int i;
    for (i = 0; i < 200; i++) {
        double next = probe.at.A - probe.answer.y[c] / probe.answer.dy[c];
        double moved = fabs(next - probe.at.A);
        if (i > 0 && moved <= 0x1p-52 * probe.at.A)
            break;
        if (!(next > lo && next < hi) || moved > 0.6 * last) {
            next = 0.5 * (lo + hi);
            moved = 0.5 * (hi - lo);
            if (!(next > lo && next < hi))
                break;
        }
        last = moved;
        sf_probe_at(search, next, &probe);
        if (!probe.answer.exists[c])
            break;
        if ((probe.answer.y[c] < 0) == rising)
            lo = next;
        else
            hi = next;
    }
    if (sf_belongs(search->question, &probe.at))
        sf_add_zero(search->found, probe.at.A, probe.answer.Omega[c], search->question, c, rising);
}

/* Whether the interval between two probes has to be looked at more closely. */
static int sf_suspicious(const sf_search *search, const sf_probe *a, const sf_probe *b, int depth) {
    const sf_answer *x = &a->answer, *y = &b->answer;
    const int c = search->channel;
    if (x->exists[c] && y->exists[c]) {
        if (sf_opposite(x->y[c], y->y[c])) { /* one zero, if the slopes agree */
            const double sign = x->y[c] < 0 ? 1 : -1;
            return depth < 6 && (sign * x->dy[c] < 0 || sign * y->dy[c] < 0);
        }
        if (depth < 2) /* an extremum towards zero is looked at, whatever its estimate */
            return sf_may_touch(x->y[c], x->dy[c], y->y[c], y->dy[c], HUGE_VAL);
        return depth < 40 && sf_may_touch(x->y[c], x->dy[c], y->y[c], y->dy[c], b->at.A - a->at.A);
    }
    if (x->exists[c])
        return !sf_settled(search->question, c, x, y, b->at.A - a->at.A);
    if (y->exists[c])
        return !sf_settled(search->question, c, y, x, a->at.A - b->at.A);
    return depth < 40 && sf_may_exist(c, x, y, b->at.A - a->at.A);
}

static void sf_between(const sf_search *search, const sf_probe *a, const sf_probe *b, int depth) {
    const int c = search->channel;
    if (depth < 60 && sf_suspicious(search, a, b, depth)) {
        const double A = 0.5 * (a->at.A + b->at.A);
        if (A > a->at.A && A < b->at.A) {
            sf_probe middle;
            sf_probe_at(search, A, &middle);
            sf_between(search, a, &middle, depth + 1);
            sf_between(search, &middle, b, depth + 1);
            return;
        }
    }
    if (a->answer.exists[c] && b->answer.exists[c] && sf_opposite(a->answer.y[c], b->answer.y[c]))
        sf_bracketed_zero(search, a, b);
}

/* All zeros of a question's channels between the first and the last of the nodes. */
static void sf_find_zeros(const sf_model *model, sf_question question, double F_0, const sf_nodes *nodes,
                        sf_zeros *found) {
    sf_search search;
    sf_probe low, high;
    int i;
    search.model = model, search.question = question, search.F_0 = F_0, search.found = found;
    for (i = 0; i < nodes->n; i++) {
        high.at = nodes->at[i];
        sf_ask(question, model, F_0, &high.at, &high.answer);
        if (i > 0)
            for (search.channel = 0; search.channel < sf_channels(question); search.channel++)
                sf_between(&search, &low, &high, 0);
        low = high;
    }
}

#endif
