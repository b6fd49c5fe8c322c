/* A record of every mechanism, as the solvers of src/slowflow/native take it.

   Written by `make derive` from the headers included below and the domains in derivations/mechanisms; never edit.

   The functions do nothing but call the headers. */

#ifndef RECORDS_H
#define RECORDS_H

#include <math.h>

#include "clones.h"
#include "mechanism.h"

#include "slow_flow.h"
#include "duffing.h"
#include "rod_spring.h"
#include "rod_spring_untruncated.h"
#include "duffing_intervals.h"
#include "duffing_pairs.h"
#include "rod_spring_intervals.h"
#include "rod_spring_pairs.h"
#include "rod_spring_untruncated_intervals.h"
#include "rod_spring_untruncated_pairs.h"
#include "rod_spring_untruncated_bounded.h"

#include "record_members.h"

/* mu, zeta -> m, zeta */
static int records_damping_of(const double *given, double *damping) {
    if (!(given[0] >= 0.0 && given[0] < INFINITY && given[1] >= 0.0 && given[1] < INFINITY))
        return 0;
    damping[0] = slow_flow_friction(given[0]);
    damping[1] = given[1];
    return 1;
}

static int records_is_forcing(double F_0) {
    return F_0 > 0.0 && F_0 < INFINITY;
}

static double records_dissipation(double Omega, double A, const double *damping) {
    return slow_flow_I(Omega, A, damping[0], damping[1]);
}

static double records_level(double Omega, double A, const double *damping, double h) {
    return slow_flow_level(Omega, A, damping[0], damping[1], h);
}

/* What every record has: functions of these names, and what no mechanism changes. */
#define IN_EVERY_RECORD(mechanism) \
    .form = SF_FORM, .name = #mechanism, .damping_size = 2, \
    .parameters_of = mechanism##_record_parameters_of, .damping_of = records_damping_of, \
    .is_forcing = records_is_forcing, .averaged = mechanism##_record_averaged, \
    .averaged_2 = mechanism##_record_averaged_2, .intercept = mechanism##_record_intercept, \
    .harmonics = mechanism##_record_harmonics, .by_parameter = mechanism##_record_by_parameter, \
    .by_design = mechanism##_record_by_design, .dissipation = records_dissipation, .level = records_level, \
    .mean_offset = records_centred

static int duffing_record_parameters_of(const sf_mechanism *self, const double *design, double *p) {
    (void)self;
    if (!(design[0] > -INFINITY && design[0] < INFINITY && design[1] > -INFINITY && design[1] < INFINITY &&
          design[2] > -INFINITY && design[2] < INFINITY))
        return 0;
    duffing_coefficients(design[0], design[1], design[2], p);
    return 1;
}

static int rod_spring_record_parameters_of(const sf_mechanism *self, const double *design, double *p) {
    (void)self;
    if (!(design[0] > 0.0 && design[0] < INFINITY && design[1] > 0.0 && design[1] < INFINITY && design[2] >= 0.0 &&
          design[2] < 1.0))
        return 0;
    rod_spring_coefficients(design[0], design[1], design[2], p);
    return 1;
}

static int rod_spring_untruncated_record_parameters_of(const sf_mechanism *self, const double *design, double *p) {
    (void)self;
    if (!(design[0] > 0.0 && design[0] < INFINITY && design[1] > 0.0 && design[1] < INFINITY && design[2] >= 0.0 &&
          design[2] < 1.0))
        return 0;
    rod_spring_untruncated_coefficients(design[0], design[1], design[2], p);
    return 1;
}

OF_DESIGN(duffing_record_by_design, double, duffing_by_design(design[0], design[1], design[2], out))
OF_DESIGN(duffing_record_parameters_within, sf_interval, duffing_intervals_given(sfi_point(design[0]), sfi_point(design[1]), sfi_point(design[2]), out))
OF_DESIGN(duffing_record_parameters_in_pairs, sf_pair, duffing_pairs_given(sfp_point(design[0]), sfp_point(design[1]), sfp_point(design[2]), out))

ROWS(duffing_record_averaged_loop, duffing_averaged, 4)
SUMS(duffing_record_averaged, duffing_record_averaged_loop(n, n, A, p, out))
ROWS(duffing_record_averaged_2_loop, duffing_averaged_2, 2)
SUMS(duffing_record_averaged_2, duffing_record_averaged_2_loop(n, n, A, p, out))
ROWS(duffing_record_harmonics_loop, duffing_harmonics, 8)
SUMS(duffing_record_harmonics, duffing_record_harmonics_loop(n, n, A, p, out))

INTERCEPT(duffing_record_intercept, duffing_intercept(A, p[0], p[1], p[2]))
BY_PARAMETER(duffing_record_by_parameter, duffing_by_parameter)
AVERAGED_WITHIN(duffing_record_averaged_within, duffing_intervals_known(A, p, out))
AVERAGED_IN_PAIRS(duffing_record_averaged_in_pairs, duffing_pairs_known(A, p, all))

/* Parameters and jumps of n designs */
IN_PAIRS(duffing_record_many_in_pairs, duffing_pairs_given(NUMBER(0), NUMBER(1), NUMBER(2), p),
         for (int k = 0; k < 3; k++) PUT(k, p[k]);)

_Static_assert(3 <= SF_MOST_DESIGN && 3 <= SF_MOST_PARAMETERS && 0 <= SF_MOST_BREAKS,
               "duffing needs higher limits in mechanism.h");
static const sf_mechanism duffing_record = {
    IN_EVERY_RECORD(duffing),
    .design_size = 3,
    .parameters = 3,
    .breakpoints = 0,
    .reach = INFINITY,
    .ends = records_no_breakpoint,
    .jumps = records_no_breakpoint,
    .harmonics_up_to = INFINITY,
    .parameters_within = duffing_record_parameters_within,
    .averaged_within = duffing_record_averaged_within,
    .parameters_in_pairs = duffing_record_parameters_in_pairs,
    .averaged_in_pairs = duffing_record_averaged_in_pairs,
    .many_in_pairs = duffing_record_many_in_pairs,
};

OF_PARAMETERS(rod_spring_record_ends, double, rod_spring_breakpoints)
OF_PARAMETERS(rod_spring_record_jumps, double, rod_spring_jumps)
OF_PARAMETERS(rod_spring_record_ends_within, sf_interval, rod_spring_intervals_breakpoints)
OF_PARAMETERS(rod_spring_record_ends_in_pairs, sf_pair, rod_spring_pairs_breakpoints)
OF_DESIGN(rod_spring_record_by_design, double, rod_spring_by_design(design[0], design[1], design[2], out))
OF_DESIGN(rod_spring_record_parameters_within, sf_interval, rod_spring_intervals_given(sfi_point(design[0]), sfi_point(design[1]), sfi_point(design[2]), out))
OF_DESIGN(rod_spring_record_parameters_in_pairs, sf_pair, rod_spring_pairs_given(sfp_point(design[0]), sfp_point(design[1]), sfp_point(design[2]), out))

static inline int rod_spring_record_averaged_regime(double A, const double *p) {
    const double u_cr = p[3];
    return A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2;
}
ROWS(rod_spring_record_averaged_loop_0, rod_spring_averaged_passed_0, 4)
ROWS(rod_spring_record_averaged_loop_1, rod_spring_averaged_passed_1, 4)
ROWS(rod_spring_record_averaged_loop_2, rod_spring_averaged_passed_1_far_1, 4)
static const rows rod_spring_record_averaged_loops[] = {rod_spring_record_averaged_loop_0, rod_spring_record_averaged_loop_1, rod_spring_record_averaged_loop_2};
SUMS(rod_spring_record_averaged, if (n == 1) rod_spring_averaged(A[0], p, out); else records_by_regime(rod_spring_record_averaged_loops, rod_spring_record_averaged_regime, n, A, p, out))
ROWS(rod_spring_record_averaged_2_loop_0, rod_spring_averaged_2_passed_0, 2)
ROWS(rod_spring_record_averaged_2_loop_1, rod_spring_averaged_2_passed_1, 2)
ROWS(rod_spring_record_averaged_2_loop_2, rod_spring_averaged_2_passed_1_far_1, 2)
static const rows rod_spring_record_averaged_2_loops[] = {rod_spring_record_averaged_2_loop_0, rod_spring_record_averaged_2_loop_1, rod_spring_record_averaged_2_loop_2};
SUMS(rod_spring_record_averaged_2, if (n == 1) rod_spring_averaged_2(A[0], p, out); else records_by_regime(rod_spring_record_averaged_2_loops, rod_spring_record_averaged_regime, n, A, p, out))
ROWS(rod_spring_record_harmonics_loop_0, rod_spring_harmonics_passed_0, 8)
ROWS(rod_spring_record_harmonics_loop_1, rod_spring_harmonics_passed_1, 8)
ROWS(rod_spring_record_harmonics_loop_2, rod_spring_harmonics_passed_1_far_1, 8)
static const rows rod_spring_record_harmonics_loops[] = {rod_spring_record_harmonics_loop_0, rod_spring_record_harmonics_loop_1, rod_spring_record_harmonics_loop_2};
SUMS(rod_spring_record_harmonics, if (n == 1) rod_spring_harmonics(A[0], p, out); else records_by_regime(rod_spring_record_harmonics_loops, rod_spring_record_averaged_regime, n, A, p, out))

INTERCEPT(rod_spring_record_intercept, rod_spring_intercept(A, p[0], p[1], p[2], p[3]))
BY_PARAMETER(rod_spring_record_by_parameter, rod_spring_by_parameter)
AVERAGED_WITHIN(rod_spring_record_averaged_within, rod_spring_intervals_known(passed, A, beyond, p, out))
AVERAGED_IN_PAIRS(rod_spring_record_averaged_in_pairs, rod_spring_pairs_known(passed, A, beyond, p, all))

/* Parameters and jumps of n designs */
IN_PAIRS(rod_spring_record_many_in_pairs, rod_spring_pairs_given(NUMBER(0), NUMBER(1), NUMBER(2), p),
         for (int k = 0; k < 5; k++) PUT(k, p[k]);)
/* The first breakpoint and h on it */
IN_PAIRS(rod_spring_record_on_first_end_in_pairs, rod_spring_pairs_given(NUMBER(0), NUMBER(1), NUMBER(2), p),
         sf_pair b[SF_MOST_BREAKS], all[5];
         rod_spring_pairs_breakpoints(p, b);
         rod_spring_pairs_known(0, b[0], b[0], p, all);
         PUT(0, b[0]);
         PUT(1, all[0]);)

_Static_assert(3 <= SF_MOST_DESIGN && 4 <= SF_MOST_PARAMETERS && 1 <= SF_MOST_BREAKS,
               "rod_spring needs higher limits in mechanism.h");
static const sf_mechanism rod_spring_record = {
    IN_EVERY_RECORD(rod_spring),
    .design_size = 3,
    .parameters = 4,
    .breakpoints = 1,
    .reach = 1.0,
    .ends = rod_spring_record_ends,
    .jumps = rod_spring_record_jumps,
    .harmonics_up_to = INFINITY,
    .parameters_within = rod_spring_record_parameters_within,
    .averaged_within = rod_spring_record_averaged_within,
    .ends_within = rod_spring_record_ends_within,
    .parameters_in_pairs = rod_spring_record_parameters_in_pairs,
    .averaged_in_pairs = rod_spring_record_averaged_in_pairs,
    .many_in_pairs = rod_spring_record_many_in_pairs,
    .ends_in_pairs = rod_spring_record_ends_in_pairs,
    .on_first_end_in_pairs = rod_spring_record_on_first_end_in_pairs,
};

OF_PARAMETERS(rod_spring_untruncated_record_ends, double, rod_spring_untruncated_breakpoints)
OF_PARAMETERS(rod_spring_untruncated_record_jumps, double, rod_spring_untruncated_jumps)
OF_PARAMETERS(rod_spring_untruncated_record_ends_within, sf_interval, rod_spring_untruncated_intervals_breakpoints)
OF_PARAMETERS(rod_spring_untruncated_record_ends_in_pairs, sf_pair, rod_spring_untruncated_pairs_breakpoints)
OF_PARAMETERS(rod_spring_untruncated_record_kinks_within, sf_interval, rod_spring_untruncated_intervals_kinks)
OF_DESIGN(rod_spring_untruncated_record_by_design, double, rod_spring_untruncated_by_design(design[0], design[1], design[2], out))
OF_DESIGN(rod_spring_untruncated_record_parameters_within, sf_interval, rod_spring_untruncated_intervals_given(sfi_point(design[0]), sfi_point(design[1]), sfi_point(design[2]), out))
OF_DESIGN(rod_spring_untruncated_record_parameters_in_pairs, sf_pair, rod_spring_untruncated_pairs_given(sfp_point(design[0]), sfp_point(design[1]), sfp_point(design[2]), out))

ROWS(rod_spring_untruncated_record_averaged_loop, rod_spring_untruncated_averaged, 4)
SUMS(rod_spring_untruncated_record_averaged, rod_spring_untruncated_record_averaged_loop(n, n, A, p, out))
ROWS(rod_spring_untruncated_record_averaged_2_loop, rod_spring_untruncated_averaged_2, 2)
SUMS(rod_spring_untruncated_record_averaged_2, rod_spring_untruncated_record_averaged_2_loop(n, n, A, p, out))
static inline int rod_spring_untruncated_record_harmonics_regime(double A, const double *p) {
    const double delta_h = p[2];
    return A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) ? 0 : 1;
}
ROWS(rod_spring_untruncated_record_harmonics_loop_0, rod_spring_untruncated_harmonics_passed_0, 8)
ROWS(rod_spring_untruncated_record_harmonics_loop_1, rod_spring_untruncated_harmonics_passed_1, 8)
static const rows rod_spring_untruncated_record_harmonics_loops[] = {rod_spring_untruncated_record_harmonics_loop_0, rod_spring_untruncated_record_harmonics_loop_1};
SUMS(rod_spring_untruncated_record_harmonics, if (n == 1) rod_spring_untruncated_harmonics(A[0], p, out); else records_by_regime(rod_spring_untruncated_record_harmonics_loops, rod_spring_untruncated_record_harmonics_regime, n, A, p, out))

INTERCEPT(rod_spring_untruncated_record_intercept, rod_spring_untruncated_intercept(A, p[0], p[1], p[2]))
BY_PARAMETER(rod_spring_untruncated_record_by_parameter, rod_spring_untruncated_by_parameter)

/* In place of its average where A exceeds the breakpoint, by so much, `parts` of them. */
static void rod_spring_untruncated_record_parts(sf_bounded beyond, const sf_bounded *p, sf_bounded *out) {
    sf_bounded ends[5];
    bounded_carlson integrals;
    rod_spring_untruncated_bounded_ends(beyond, p, ends);
    integrals = bounded_carlson_of(sfb_square(ends[3]), sfb_square(ends[1]), sfb_point(1));
    rod_spring_untruncated_bounded_parts(ends[0], ends[1], ends[2], ends[3], ends[4], integrals.R_F, integrals.R_D, out);
}

/* h, h_A, h_AA, h_AAA and h - A h_A */
static void rod_spring_untruncated_record_averaged_within(const sf_mechanism *self, int passed, sf_interval A, sf_interval beyond,
                                                           const sf_interval *p, sf_interval *out) {
    sf_bounded parts[5], parameters[SF_MOST_PARAMETERS];
    sf_interval part[5];
    int i;
    (void)self;
    if (passed == 0) {
        if (A.hi <= 0.69999999999999996)
            rod_spring_untruncated_intervals_attached(A, p, out);
        else
            rod_spring_untruncated_intervals_attached_steep(A, p, out);
        return;
    }
    for (i = 0; i < 3; i++)
        parameters[i] = sfb_within(p[i]);
    rod_spring_untruncated_record_parts(sfb_within(beyond), parameters, parts);
    for (i = 0; i < 5; i++)
        part[i] = sfb_interval(parts[i]);
    rod_spring_untruncated_intervals_detached(A, part[0], part[1], part[2], part[3], part[4], p, out);
}

/* h, h_A, h_AA, h_AAA */
static void rod_spring_untruncated_record_averaged_in_pairs(const sf_mechanism *self, int passed, int wanted, sf_pair A, sf_pair beyond,
                                                    const sf_pair *p, sf_pair *out) {
    sf_pair all[5];
    int i;
    (void)self, (void)wanted;
    if (passed == 0 && A.high < 0.69999999999999996) {
        rod_spring_untruncated_pairs_attached(A, p, all);
    } else if (passed == 0) {
        rod_spring_untruncated_pairs_attached_steep(A, p, all);
    } else {
        sf_bounded parts[5], parameters[SF_MOST_PARAMETERS];
        for (i = 0; i < 3; i++)
            parameters[i] = sfb_of(p[i], 0);
        rod_spring_untruncated_record_parts(sfb_of(beyond, 0), parameters, parts);
        rod_spring_untruncated_pairs_detached(A, parts[0].x, parts[1].x, parts[2].x, parts[3].x, parts[4].x, p, all);
    }
    for (i = 0; i < 4; i++)
        out[i] = all[i];
}

/* Parameters and jumps of n designs */
IN_PAIRS(rod_spring_untruncated_record_many_in_pairs, rod_spring_untruncated_pairs_given(NUMBER(0), NUMBER(1), NUMBER(2), p),
         for (int k = 0; k < 4; k++) PUT(k, p[k]);)
/* The first breakpoint and h on it, of h NaN where another form is needed */
IN_PAIRS(rod_spring_untruncated_record_on_first_end_in_pairs, rod_spring_untruncated_pairs_given(NUMBER(0), NUMBER(1), NUMBER(2), p),
         sf_pair b[SF_MOST_BREAKS], all[5];
         rod_spring_untruncated_pairs_breakpoints(p, b);
         rod_spring_untruncated_pairs_attached(b[0], p, all);
         all[0].high = b[0].high < 0.69999999999999996 ? all[0].high : NAN;
         PUT(0, b[0]);
         PUT(1, all[0]);)

_Static_assert(3 <= SF_MOST_DESIGN && 3 <= SF_MOST_PARAMETERS && 1 <= SF_MOST_BREAKS,
               "rod_spring_untruncated needs higher limits in mechanism.h");
static const sf_mechanism rod_spring_untruncated_record = {
    IN_EVERY_RECORD(rod_spring_untruncated),
    .design_size = 3,
    .parameters = 3,
    .breakpoints = 1,
    .reach = 1.0,
    .ends = rod_spring_untruncated_record_ends,
    .jumps = rod_spring_untruncated_record_jumps,
    .harmonics_up_to = 0.75,
    .parameters_within = rod_spring_untruncated_record_parameters_within,
    .averaged_within = rod_spring_untruncated_record_averaged_within,
    .ends_within = rod_spring_untruncated_record_ends_within,
    .kinks_within = rod_spring_untruncated_record_kinks_within,
    .parameters_in_pairs = rod_spring_untruncated_record_parameters_in_pairs,
    .averaged_in_pairs = rod_spring_untruncated_record_averaged_in_pairs,
    .many_in_pairs = rod_spring_untruncated_record_many_in_pairs,
    .ends_in_pairs = rod_spring_untruncated_record_ends_in_pairs,
    .on_first_end_in_pairs = rod_spring_untruncated_record_on_first_end_in_pairs,
};

static const sf_mechanism *const records[] = {
    &duffing_record,
    &rod_spring_record,
    &rod_spring_untruncated_record,
};

#endif
