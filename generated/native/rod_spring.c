/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: loops for NumPy.

   Written by `make derive` from rod_spring.h, the same functions for one number each; never edit. */

#include "rod_spring.h"

#include "kernels.h"

#define REGIMES_1(loop, ...) loop(_passed_0, __VA_ARGS__) loop(_passed_1, __VA_ARGS__) loop(_passed_1_far_1, __VA_ARGS__)
#define REGIMES_2(loop, ...) loop(_force_1, __VA_ARGS__) loop(_force_2, __VA_ARGS__)

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, coefficients, 3, 4)

KERNELS(SF_NUMBER, SF_NUMBERS, rod_spring)
REGIMES_1(SF_TUPLE, rod_spring_averaged, 4, rod_spring_averaged, X(0), (const double[]){X(1), X(2), X(3), X(4)})
SF_CHOOSE(rod_spring_averaged, 5, A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2, const double A = X(0), u_cr = X(4))
REGIMES_1(SF_TUPLE, rod_spring_averaged_2, 2, rod_spring_averaged_2, X(0), (const double[]){X(1), X(2), X(3), X(4)})
REGIMES_1(SF_TUPLE, rod_spring_averaged_H, 2, rod_spring_averaged_H, X(0), (const double[]){X(1), X(2), X(3), X(4)})
REGIMES_1(SF_SCALAR, rod_spring_intercept, rod_spring_intercept, X(0), X(1), X(2), X(3), X(4))
REGIMES_1(SF_TUPLE, rod_spring_harmonics, 8, rod_spring_harmonics, X(0), (const double[]){X(1), X(2), X(3), X(4)})
SF_TUPLE(, rod_spring_breakpoints, 1, rod_spring_breakpoints, (const double[]){X(0), X(1), X(2), X(3)})
SF_TUPLE(, rod_spring_jumps, 1, rod_spring_jumps, (const double[]){X(0), X(1), X(2), X(3)})
SF_TUPLE(, rod_spring_hardening, 3, rod_spring_hardening, (const double[]){X(0), X(1), X(2), X(3)})
REGIMES_2(SF_SCALAR, rod_spring_force, rod_spring, X(0), X(1), X(2), X(3), X(4))
SF_CHOOSE(rod_spring_force, 5, fabs(u) <= u_cr ? 0 : 1, const double u = X(0), u_cr = X(4))
SF_TUPLE(, rod_spring_saddle_node_onset, 19, rod_spring_saddle_node_onset, X(0), X(1), (const double[]){X(2), X(3),
    X(4), X(5)})
SF_TUPLE(, rod_spring_saddle_nodes, 17, rod_spring_saddle_nodes, X(0), X(1), X(2), (const double[]){X(3), X(4),
    X(5), X(6)})
REGIMES_1(SF_PART, rod_spring_h, 1, 2, rod_spring_averaged_2, (X(0), (const double[]){X(1), X(2), X(3), X(4)}, all),
    values[0] = all[0];)
REGIMES_1(SF_PART, rod_spring_h_A, 1, 2, rod_spring_averaged_2, (X(0), (const double[]){X(1), X(2), X(3), X(4)},
    all), values[0] = all[1];)
REGIMES_1(SF_PART, rod_spring_h_AA, 1, 4, rod_spring_averaged, (X(0), (const double[]){X(1), X(2), X(3), X(4)},
    all), values[0] = all[2];)
REGIMES_1(SF_PART, rod_spring_h_AAA, 1, 4, rod_spring_averaged, (X(0), (const double[]){X(1), X(2), X(3), X(4)},
    all), values[0] = all[3];)
REGIMES_1(SF_PART, rod_spring_H, 1, 2, rod_spring_averaged_H, (X(0), (const double[]){X(1), X(2), X(3), X(4)}, all),
    values[0] = all[0];)
REGIMES_1(SF_PART, rod_spring_H_A, 1, 2, rod_spring_averaged_H, (X(0), (const double[]){X(1), X(2), X(3), X(4)},
    all), values[0] = all[1];)
REGIMES_1(SF_PART, rod_spring_H_AA, 1, 4, rod_spring_averaged, (X(0), (const double[]){X(1), X(2), X(3), X(4)},
    all), values[0] = all[2];)
REGIMES_1(SF_PART, rod_spring_F, 1, 2, rod_spring_averaged_2, (X(1), (const double[]){X(5), X(6), X(7), X(8)}, all),
    values[0] = slow_flow_F(X(0), X(1), X(2), slow_flow_friction(X(3)), X(4), all[0]);)
SF_CHOOSE(rod_spring_F, 9, A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2, const double A = X(1), u_cr = X(8))
REGIMES_1(SF_PART, rod_spring_F_A, 1, 2, rod_spring_averaged_2, (X(1), (const double[]){X(4), X(5), X(6), X(7)},
    all), values[0] = slow_flow_F_A(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0], all[1]);)
SF_CHOOSE(rod_spring_F_A, 8, A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2, const double A = X(1), u_cr = X(7))
REGIMES_1(SF_PART, rod_spring_level, 1, 2, rod_spring_averaged_2, (X(1), (const double[]){X(4), X(5), X(6), X(7)},
    all), values[0] = slow_flow_level(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0]);)
REGIMES_1(SF_PART, rod_spring_phase, 1, 2, rod_spring_averaged_2, (X(1), (const double[]){X(4), X(5), X(6), X(7)},
    all), values[0] = slow_flow_phase(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0]);)
REGIMES_1(SF_PART, rod_spring_jacobian, 4, 2, rod_spring_averaged_2, (X(1), (const double[]){X(4), X(5), X(6),
    X(7)}, all), slow_flow_jacobian(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0], all[1], values);)
REGIMES_1(SF_PART, rod_spring_stability, 1, 2, rod_spring_averaged_2, (X(1), (const double[]){X(4), X(5), X(6),
    X(7)}, all), values[0] = slow_flow_stability(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0], all[1]);)
REGIMES_1(SF_PART, rod_spring_transmissibility, 1, 2, rod_spring_averaged_2, (X(1), (const double[]){X(5), X(6),
    X(7), X(8)}, all), values[0] = slow_flow_transmissibility(X(0), X(1), X(2), slow_flow_friction(X(3)), X(4),
    all[0]);)
REGIMES_1(SF_PART, rod_spring_backbone, 1, 2, rod_spring_averaged_2, (X(0), (const double[]){X(1), X(2), X(3),
    X(4)}, all), values[0] = slow_flow_backbone(X(0), all[0]);)
SF_SCALAR(, rod_spring_limit_envelope, slow_flow_limit_envelope, X(0), X(1), slow_flow_friction(X(2)), X(3))
SF_SCALAR(, rod_spring_equivalent_damping, slow_flow_equivalent_damping, X(0), X(1), slow_flow_friction(X(2)), X(3))
REGIMES_1(SF_PART, rod_spring_response_quartic, 4, 2, rod_spring_averaged_2, (X(0), (const double[]){X(4), X(5),
    X(6), X(7)}, all), slow_flow_response_quartic(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0], values);)
SF_CHOOSE(rod_spring_response_quartic, 8, A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2, const double A = X(0), u_cr =
    X(7))
REGIMES_1(SF_PART, rod_spring_fold_quartic, 4, 2, rod_spring_averaged_2, (X(0), (const double[]){X(3), X(4), X(5),
    X(6)}, all), slow_flow_fold_quartic(X(0), slow_flow_friction(X(1)), X(2), all[0], all[1], values);)
SF_CHOOSE(rod_spring_fold_quartic, 7, A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2, const double A = X(0), u_cr = X(6))
REGIMES_1(SF_PART, rod_spring_peak_cubic, 3, 2, rod_spring_averaged_2, (X(0), (const double[]){X(3), X(4), X(5),
    X(6)}, all), slow_flow_peak_cubic(X(0), slow_flow_friction(X(1)), X(2), all[0], values);)
REGIMES_1(SF_PART, rod_spring_detachment, 4, 2, rod_spring_averaged_2, (X(0), (const double[]){X(3), X(4), X(5),
    X(6)}, all), slow_flow_detachment(X(0), slow_flow_friction(X(1)), X(2), all[0], values);)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, rod_spring)
    {"averaged", 5, 4, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_averaged))},
    {"averaged_2", 5, 2, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_averaged_2))},
    {"averaged_H", 5, 2, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_averaged_H))},
    {"intercept", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_intercept))},
    {"harmonics", 5, 8, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_harmonics))},
    {"breakpoints", 4, 1, SF_ONE(rod_spring_breakpoints)},
    {"jumps", 4, 1, SF_ONE(rod_spring_jumps)},
    {"hardening", 4, 3, SF_ONE(rod_spring_hardening)},
    {"force", 5, 1, SF_SEVERAL(rod_spring_force, REGIMES_2(SF_NAMED, rod_spring_force))},
    {"saddle_node_onset", 6, 19, SF_ONE(rod_spring_saddle_node_onset)},
    {"saddle_nodes", 7, 17, SF_ONE(rod_spring_saddle_nodes)},
    {"h", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_h))},
    {"h_A", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_h_A))},
    {"h_AA", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_h_AA))},
    {"h_AAA", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_h_AAA))},
    {"H", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_H))},
    {"H_A", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_H_A))},
    {"H_AA", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_H_AA))},
    {"F", 9, 1, SF_SEVERAL(rod_spring_F, REGIMES_1(SF_NAMED, rod_spring_F))},
    {"F_A", 8, 1, SF_SEVERAL(rod_spring_F_A, REGIMES_1(SF_NAMED, rod_spring_F_A))},
    {"level", 8, 1, SF_SEVERAL(rod_spring_F_A, REGIMES_1(SF_NAMED, rod_spring_level))},
    {"phase", 8, 1, SF_SEVERAL(rod_spring_F_A, REGIMES_1(SF_NAMED, rod_spring_phase))},
    {"jacobian", 8, 4, SF_SEVERAL(rod_spring_F_A, REGIMES_1(SF_NAMED, rod_spring_jacobian))},
    {"stability", 8, 1, SF_SEVERAL(rod_spring_F_A, REGIMES_1(SF_NAMED, rod_spring_stability))},
    {"transmissibility", 9, 1, SF_SEVERAL(rod_spring_F, REGIMES_1(SF_NAMED, rod_spring_transmissibility))},
    {"backbone", 5, 1, SF_SEVERAL(rod_spring_averaged, REGIMES_1(SF_NAMED, rod_spring_backbone))},
    {"limit_envelope", 4, 1, SF_ONE(rod_spring_limit_envelope)},
    {"equivalent_damping", 4, 1, SF_ONE(rod_spring_equivalent_damping)},
    {"response_quartic", 8, 4, SF_SEVERAL(rod_spring_response_quartic, REGIMES_1(SF_NAMED, rod_spring_response_quartic))},
    {"fold_quartic", 7, 4, SF_SEVERAL(rod_spring_fold_quartic, REGIMES_1(SF_NAMED, rod_spring_fold_quartic))},
    {"peak_cubic", 7, 3, SF_SEVERAL(rod_spring_fold_quartic, REGIMES_1(SF_NAMED, rod_spring_peak_cubic))},
    {"detachment", 7, 4, SF_SEVERAL(rod_spring_fold_quartic, REGIMES_1(SF_NAMED, rod_spring_detachment))},
};

const sf_module sf_module_rod_spring = {"rod_spring", kernels, sizeof kernels / sizeof kernels[0]};
