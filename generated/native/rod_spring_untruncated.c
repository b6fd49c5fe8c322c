/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: loops for NumPy.

   Written by `make derive` from rod_spring_untruncated.h, the same functions for one number each; never edit. */

#include "rod_spring_untruncated.h"

#include "kernels.h"

#define REGIMES_1(loop, ...) loop(_passed_0_end, __VA_ARGS__) loop(_passed_0, __VA_ARGS__) loop(_passed_0_steep, __VA_ARGS__) loop(_passed_1_far, __VA_ARGS__) loop(_passed_1, __VA_ARGS__) loop(_passed_1_steeper_far, __VA_ARGS__) loop(_passed_1_steeper, __VA_ARGS__) loop(_passed_1_steep_far, __VA_ARGS__) loop(_passed_1_steep_away, __VA_ARGS__) loop(_passed_1_steep, __VA_ARGS__)
#define REGIMES_2(loop, ...) loop(_passed_0, __VA_ARGS__) loop(_passed_1, __VA_ARGS__)
#define REGIMES_3(loop, ...) loop(_force_2, __VA_ARGS__) loop(_force_1, __VA_ARGS__)

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, coefficients, 3, 3)

KERNELS(SF_NUMBER, SF_NUMBERS, rod_spring_untruncated)
REGIMES_1(SF_TUPLE, rod_spring_untruncated_averaged_all, 7, rod_spring_untruncated_averaged_all, X(0), (const
    double[]){X(1), X(2), X(3)})
SF_CHOOSE(rod_spring_untruncated_averaged_all, 4, A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) && sqrt(-delta_h *
    delta_h + 2.0 * delta_h) <= A ? 0 : A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) && A <= 0.69999999999999996 ?
    1 : A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) ? 2 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75 && 1.05
    * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 3 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75 ? 4 :
    sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004 && 1.05 * sqrt(-delta_h * delta_h + 2.0 *
    delta_h) <= A ? 5 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004 ? 6 : 1.05 * sqrt(-delta_h *
    delta_h + 2.0 * delta_h) <= A ? 7 : sqrt(-0.75 * delta_h * delta_h + 1.5 * delta_h + 0.25) <= A ? 8 : 9, const
    double A = X(0), delta_h = X(3))
REGIMES_2(SF_TUPLE, rod_spring_untruncated_harmonics, 8, rod_spring_untruncated_harmonics, X(0), (const
    double[]){X(1), X(2), X(3)})
SF_CHOOSE(rod_spring_untruncated_harmonics, 4, A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) ? 0 : 1, const double A
    = X(0), delta_h = X(3))
SF_TUPLE(, rod_spring_untruncated_breakpoints, 1, rod_spring_untruncated_breakpoints, (const double[]){X(0), X(1),
    X(2)})
SF_TUPLE(, rod_spring_untruncated_jumps, 1, rod_spring_untruncated_jumps, (const double[]){X(0), X(1), X(2)})
SF_TUPLE(, rod_spring_untruncated_hardening, 1, rod_spring_untruncated_hardening, (const double[]){X(0), X(1),
    X(2)})
REGIMES_3(SF_SCALAR, rod_spring_untruncated_force, rod_spring_untruncated, X(0), X(1), X(2), X(3))
SF_CHOOSE(rod_spring_untruncated_force, 4, sqrt(-delta_h * delta_h + 2.0 * delta_h) <= fabs(u) ? 0 : 1, const double
    u = X(0), delta_h = X(3))
SF_SCALAR(, rod_spring_untruncated_limit_envelope, slow_flow_limit_envelope, X(0), X(1), slow_flow_friction(X(2)),
    X(3))
SF_SCALAR(, rod_spring_untruncated_equivalent_damping, slow_flow_equivalent_damping, X(0), X(1),
    slow_flow_friction(X(2)), X(3))

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, rod_spring_untruncated)
    {"averaged_all", 4, 7, SF_SEVERAL(rod_spring_untruncated_averaged_all, REGIMES_1(SF_NAMED, rod_spring_untruncated_averaged_all))},
    {"harmonics", 4, 8, SF_SEVERAL(rod_spring_untruncated_harmonics, REGIMES_2(SF_NAMED, rod_spring_untruncated_harmonics))},
    {"breakpoints", 3, 1, SF_ONE(rod_spring_untruncated_breakpoints)},
    {"jumps", 3, 1, SF_ONE(rod_spring_untruncated_jumps)},
    {"hardening", 3, 1, SF_ONE(rod_spring_untruncated_hardening)},
    {"force", 4, 1, SF_SEVERAL(rod_spring_untruncated_force, REGIMES_3(SF_NAMED, rod_spring_untruncated_force))},
    {"limit_envelope", 4, 1, SF_ONE(rod_spring_untruncated_limit_envelope)},
    {"equivalent_damping", 4, 1, SF_ONE(rod_spring_untruncated_equivalent_damping)},
};

const sf_module sf_module_rod_spring_untruncated = {"rod_spring_untruncated", kernels, sizeof kernels / sizeof kernels[0]};
