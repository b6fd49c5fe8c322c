/* A record that the package has not: a cubic spring with its parameters the other way round, beta, alpha, and an end b
 * of its first piece behind which the force goes on as it was; b = 0 is no end.  A test may build it with other answers
 * in its slots: FORM, OFFSET, LEVEL and THRESHOLD. */
#include <math.h>

#include "mechanism.h"
#include "slow_flow.h"

#ifndef FORM
#define FORM SF_FORM
#endif
#ifndef OFFSET
#define OFFSET 0.0
#endif
#ifndef LEVEL
#define LEVEL 1.0
#endif
#ifndef THRESHOLD
#define THRESHOLD 1.0
#endif

static int parameters_of(const sf_mechanism *self, const double *design, double *p) {
    int i;
    (void)self;
    for (i = 0; i < 3; i++) {
        if (!(fabs(design[i]) < HUGE_VAL))
            return 0;
        p[i] = design[i];
    }
    return p[2] >= 0;
}

static int damping_of(const double *inputs, double *damping) {
    damping[0] = slow_flow_friction(inputs[0]), damping[1] = inputs[1];
    return inputs[0] >= 0 && inputs[1] >= 0;
}

static int is_forcing(double F_0) { return F_0 > 0 && F_0 < HUGE_VAL; }

static void ends(const sf_mechanism *self, const double *p, double *b) {
    (void)self;
    b[0] = p[2];
}

static void jumps(const sf_mechanism *self, const double *p, double *jump) {
    (void)self, (void)p;
    jump[0] = 0;
}

static void averaged(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out) {
    ptrdiff_t i;
    (void)self;
    for (i = 0; i < n; i++) {
        const double t0 = A[i] * A[i] * p[0], t1 = 4.5 * p[0];
        out[i] = A[i] * (-p[1] - 0.75 * t0);
        out[n + i] = -p[1] - 2.25 * t0;
        out[2 * n + i] = -A[i] * t1;
        out[3 * n + i] = -t1;
    }
}

static void averaged_2(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out) {
    ptrdiff_t i;
    (void)self;
    for (i = 0; i < n; i++) {
        const double t0 = A[i] * A[i] * p[0];
        out[i] = A[i] * (-p[1] - 0.75 * t0);
        out[n + i] = -p[1] - 2.25 * t0;
    }
}

static double intercept(const sf_mechanism *self, double A, const double *p) {
    (void)self;
    return 1.5 * (A * (A * A)) * p[0];
}

static double dissipation(double Omega, double A, const double *damping) {
    return slow_flow_I(Omega, A, THRESHOLD * damping[0], damping[1]);
}

static double level(double Omega, double A, const double *damping, double h) {
    return LEVEL * slow_flow_level(Omega, A, damping[0], damping[1], h);
}

static double mean_offset(double A, const double *p) {
    (void)A;
    (void)p;
    return OFFSET;
}

extern const sf_mechanism own_record;
const sf_mechanism own_record = {
    .form = FORM,
    .name = "own",
    .design_size = 3,
    .damping_size = 2,
    .parameters = 3,
    .breakpoints = 1,
    .reach = HUGE_VAL,
    .parameters_of = parameters_of,
    .damping_of = damping_of,
    .is_forcing = is_forcing,
    .ends = ends,
    .jumps = jumps,
    .averaged = averaged,
    .averaged_2 = averaged_2,
    .intercept = intercept,
    .dissipation = dissipation,
    .level = level,
    .mean_offset = mean_offset,
};
