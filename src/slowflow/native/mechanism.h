/* One equation of motion as the solvers take it: a record of all that they know of it.
 *
 * The derivation writes the records of its mechanisms (records.h among the generated headers). A record compiled
 * elsewhere is as good: the solvers know none by name.
 *
 * Functions of the force take the record, `self`, by which one text serves many forces.
 *
 * Numbers are dimensionless. `p` holds the mechanism's parameters, `damping` what the slow flow needs of the damping.
 */
#pragma once

#include <stddef.h>

#include "interval.h"
#include "pair.h"

enum {
    SF_FORM = 13, /* of the record below; one of another form is refused */
    SF_MOST_DESIGN = 32,
    SF_MOST_DAMPING = 7,
    SF_MOST_PARAMETERS = 64,
    SF_MOST_BREAKS = 16
};

typedef struct sf_mechanism sf_mechanism;

/* What the record of a force that is interpreted is made from, see program.h. */
typedef struct sf_program sf_program;

/* What the record of a force that is known by its values is made from, see sampled.h. */
typedef struct sf_sampled sf_sampled;

struct sf_mechanism {
    int form;
    const char *name;
    /* how many: numbers that a user gives for the spring and for the damping, parameters, breakpoints */
    int design_size, damping_size, parameters, breakpoints;
    double reach; /* largest amplitude that it can take, or infinite */

    /* From what a user gives to what the solvers take; 0 where a number lies outside its domain. Parameters are
     * computed in doubles, see sf_take_design. */
    int (*parameters_of)(const sf_mechanism *self, const double *design, double *p);
    int (*damping_of)(const double *inputs, double *damping);
    int (*is_forcing)(double F_0);

    /* The |u| at which a piece of the force ends, by rising size, and the force just below less the force just
     * above. */
    void (*ends)(const sf_mechanism *self, const double *p, double *b);
    void (*jumps)(const sf_mechanism *self, const double *p, double *jump);
    /* What the slope and the curvature of the force lose at each breakpoint in turn; NULL where the force or its slope
     * jumps at all of them. */
    void (*kinks)(const sf_mechanism *self, const double *p, double *kink);

    /* Spring: h and its derivatives along A at n amplitudes; derivative k at amplitude i goes to out[k*n + i].
     * averaged gives h, h_A, h_AA, h_AAA, averaged_2 the first two. */
    void (*averaged)(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out);
    void (*averaged_2)(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out);
    /* h - A h_A without what cancels in it. */
    double (*intercept)(const sf_mechanism *self, double A, const double *p);
    /* What holds h and h_AAAA on amplitudes of one piece of the force; NULL where h_AAA is monotone on each. An average
     * may be NaN then, where its sums do not settle. */
    void (*bent)(const sf_mechanism *self, sf_interval A, const double *p, sf_interval *out);

    /* The spring's higher harmonics, as averaged gives h: h_3 with three derivatives, then h_5, for breakpoints up to
     * harmonics_up_to; NULL where they are not known. */
    void (*harmonics)(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out);
    double harmonics_up_to;

    /* How they change with the parameters: d/dp of h, h_A and h_AA at A, which are given, for each parameter p in turn;
     * and these with the design: d/d of each of its numbers, of each parameter in turn, then of each breakpoint. NULL
     * where that is not known: there are no gradients. */
    void (*by_parameter)(const sf_mechanism *self, double A, const double *averaged, const double *p, double *out);
    void (*by_design)(const sf_mechanism *self, const double *design, double *out);

    /* Damping: I, the sine balance (23). At Omega = A = 0 it is the forcing that leaves the mass at rest. */
    double (*dissipation)(double Omega, double A, const double *damping);

    /* Excitation: the amplitude F_0 for which (Omega, A) is a steady state (24), and whether that means a force
     * F_0 Omega^2, of inertia. */
    double (*level)(double Omega, double A, const double *damping, double h);
    int inertial;

    /* Mean B of the motion u = B + A cos psi; |B| + A is the largest displacement. */
    double (*mean_offset)(double A, const double *p);

    /* The same on intervals, for proofs; NULL where no such form is known. The excitation is a force there, and the
     * motion is about u = 0. p holds the parameters that follow from a design, then the jumps at its breakpoints.
     * ends_within is NULL where there are no breakpoints. averaged_within gives h, h_A, h_AA, h_AAA and h - A h_A on
     * the piece that begins at breakpoint number `passed`, which A exceeds by `beyond`; by its formula, which may be
     * needed above its end too. kinks_within gives what the slope of the force loses at each breakpoint; NULL where the
     * force jumps at all of them. */
    void (*parameters_within)(const sf_mechanism *self, const double *design, sf_interval *p);
    void (*ends_within)(const sf_mechanism *self, const sf_interval *p, sf_interval *b);
    void (*kinks_within)(const sf_mechanism *self, const sf_interval *p, sf_interval *kink);
    void (*averaged_within)(const sf_mechanism *self, int passed, sf_interval A, sf_interval beyond,
                            const sf_interval *p, sf_interval *out);

    /* The same in double-double, for the last digits of an answer; NULL where no such form is known. averaged_in_pairs
     * gives h, h_A and, if more than two are wanted, h_AA and h_AAA. */
    void (*parameters_in_pairs)(const sf_mechanism *self, const double *design, sf_pair *p);
    void (*ends_in_pairs)(const sf_mechanism *self, const sf_pair *p, sf_pair *b);
    void (*averaged_in_pairs)(const sf_mechanism *self, int passed, int count, sf_pair A, sf_pair beyond,
                              const sf_pair *p, sf_pair *out);

    /* Of n designs at once what parameters_in_pairs gives, of each number the high and then the low part: number i of
     * design k is at design[i*apart + k], part i at out[i*apart + k]. */
    void (*many_in_pairs)(const sf_mechanism *self, ptrdiff_t n, ptrdiff_t apart, const double *design, double *out);

    /* Of n designs at once the first breakpoint and h on it as its lower side has it, of each the high and the low
     * part:
     * number i of design k is at design[i*apart + k], part i at out[i*apart + k]. The parts of h are NaN where that
     * takes a form of its own; NULL where such a loop is not known. */
    void (*on_first_end_in_pairs)(const sf_mechanism *self, ptrdiff_t n, ptrdiff_t apart, const double *design,
                                  double *out);

    /* what the functions read; NULL where they are compiled ones of this very force */
    const sf_program *program;
    const sf_sampled *sampled;
};

/* What a record has that no force changes, from another one of an odd force. */
static inline void sf_take_surroundings(const sf_mechanism *like, sf_mechanism *record) {
    record->form = SF_FORM, record->damping_size = like->damping_size, record->damping_of = like->damping_of;
    record->is_forcing = like->is_forcing, record->dissipation = like->dissipation, record->level = like->level;
    record->mean_offset = like->mean_offset;
}

/* A parameter that is a difference of nearly equal numbers, as a stiffness next to 0, has few digits in doubles: such
 * ones are what pairs give, of which number i has its high part at high[i*apart]. One that is 0 to rounding, or whose
 * sign rounding decides, stays as everyone has it: quasi-zero stiffness is meant by 1/(lam r) = delta_h, which doubles
 * seldom are. */
static inline void sf_keep_digits(int n, const double *high, ptrdiff_t apart, double *p) {
    for (int i = 0; i < n; i++, high += apart)
        if (p[i] * *high > 0 && fabs(p[i] - *high) > 0x1p-49 * fabs(p[i]))
            p[i] = *high;
}

/* The parameters of a design; 0 where a number lies outside its domain. */
static inline int sf_take_design(const sf_mechanism *mechanism, const double *design, double *p) {
    sf_pair pairs[SF_MOST_PARAMETERS + SF_MOST_BREAKS];
    if (!mechanism->parameters_of(mechanism, design, p))
        return 0;
    if (mechanism->parameters_in_pairs != NULL) {
        mechanism->parameters_in_pairs(mechanism, design, pairs);
        sf_keep_digits(mechanism->parameters, &pairs->high, 2, p);
    }
    return 1;
}
