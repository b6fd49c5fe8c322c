/* Duffing oscillator: one polynomial of degree five, no breakpoint: loops for NumPy.

   Written by `make derive` from duffing.h, the same functions for one number each; never edit. */

#include "duffing.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBER(of, intercept, 4) NUMBERS(of, coefficients, 3, 3)

KERNELS(SF_NUMBER, SF_NUMBERS, duffing)
SF_TUPLE(, duffing_averaged, 4, duffing_averaged, X(0), (const double[]){X(1), X(2), X(3)})
SF_TUPLE(, duffing_averaged_2, 2, duffing_averaged_2, X(0), (const double[]){X(1), X(2), X(3)})
SF_TUPLE(, duffing_averaged_H, 2, duffing_averaged_H, X(0), (const double[]){X(1), X(2), X(3)})
SF_TUPLE(, duffing_harmonics, 8, duffing_harmonics, X(0), (const double[]){X(1), X(2), X(3)})
SF_TUPLE(, duffing_hardening, 2, duffing_hardening, (const double[]){X(0), X(1), X(2)})
SF_SCALAR(, duffing_force, duffing_force_1, X(0), X(1), X(2), X(3))
SF_TUPLE(, duffing_saddle_node_onset, 19, duffing_saddle_node_onset, X(0), X(1), (const double[]){X(2), X(3), X(4)})
SF_TUPLE(, duffing_saddle_nodes, 17, duffing_saddle_nodes, X(0), X(1), X(2), (const double[]){X(3), X(4), X(5)})
SF_PART(, duffing_h, 1, 2, duffing_averaged_2, (X(0), (const double[]){X(1), X(2), X(3)}, all), values[0] = all[0];)
SF_PART(, duffing_h_A, 1, 2, duffing_averaged_2, (X(0), (const double[]){X(1), X(2), X(3)}, all), values[0] =
    all[1];)
SF_PART(, duffing_h_AA, 1, 4, duffing_averaged, (X(0), (const double[]){X(1), X(2), X(3)}, all), values[0] =
    all[2];)
SF_PART(, duffing_h_AAA, 1, 4, duffing_averaged, (X(0), (const double[]){X(1), X(2), X(3)}, all), values[0] =
    all[3];)
SF_PART(, duffing_H, 1, 2, duffing_averaged_H, (X(0), (const double[]){X(1), X(2), X(3)}, all), values[0] = all[0];)
SF_PART(, duffing_H_A, 1, 2, duffing_averaged_H, (X(0), (const double[]){X(1), X(2), X(3)}, all), values[0] =
    all[1];)
SF_PART(, duffing_H_AA, 1, 4, duffing_averaged, (X(0), (const double[]){X(1), X(2), X(3)}, all), values[0] =
    all[2];)
SF_PART(, duffing_F, 1, 2, duffing_averaged_2, (X(1), (const double[]){X(5), X(6), X(7)}, all), values[0] =
    slow_flow_F(X(0), X(1), X(2), slow_flow_friction(X(3)), X(4), all[0]);)
SF_PART(, duffing_F_A, 1, 2, duffing_averaged_2, (X(1), (const double[]){X(4), X(5), X(6)}, all), values[0] =
    slow_flow_F_A(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0], all[1]);)
SF_PART(, duffing_level, 1, 2, duffing_averaged_2, (X(1), (const double[]){X(4), X(5), X(6)}, all), values[0] =
    slow_flow_level(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0]);)
SF_PART(, duffing_phase, 1, 2, duffing_averaged_2, (X(1), (const double[]){X(4), X(5), X(6)}, all), values[0] =
    slow_flow_phase(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0]);)
SF_PART(, duffing_jacobian, 4, 2, duffing_averaged_2, (X(1), (const double[]){X(4), X(5), X(6)}, all),
    slow_flow_jacobian(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0], all[1], values);)
SF_PART(, duffing_stability, 1, 2, duffing_averaged_2, (X(1), (const double[]){X(4), X(5), X(6)}, all), values[0] =
    slow_flow_stability(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0], all[1]);)
SF_PART(, duffing_transmissibility, 1, 2, duffing_averaged_2, (X(1), (const double[]){X(5), X(6), X(7)}, all),
    values[0] = slow_flow_transmissibility(X(0), X(1), X(2), slow_flow_friction(X(3)), X(4), all[0]);)
SF_PART(, duffing_backbone, 1, 2, duffing_averaged_2, (X(0), (const double[]){X(1), X(2), X(3)}, all), values[0] =
    slow_flow_backbone(X(0), all[0]);)
SF_SCALAR(, duffing_limit_envelope, slow_flow_limit_envelope, X(0), X(1), slow_flow_friction(X(2)), X(3))
SF_SCALAR(, duffing_equivalent_damping, slow_flow_equivalent_damping, X(0), X(1), slow_flow_friction(X(2)), X(3))
SF_PART(, duffing_response_quartic, 4, 2, duffing_averaged_2, (X(0), (const double[]){X(4), X(5), X(6)}, all),
    slow_flow_response_quartic(X(0), X(1), slow_flow_friction(X(2)), X(3), all[0], values);)
SF_PART(, duffing_fold_quartic, 4, 2, duffing_averaged_2, (X(0), (const double[]){X(3), X(4), X(5)}, all),
    slow_flow_fold_quartic(X(0), slow_flow_friction(X(1)), X(2), all[0], all[1], values);)
SF_PART(, duffing_peak_cubic, 3, 2, duffing_averaged_2, (X(0), (const double[]){X(3), X(4), X(5)}, all),
    slow_flow_peak_cubic(X(0), slow_flow_friction(X(1)), X(2), all[0], values);)
SF_PART(, duffing_detachment, 4, 2, duffing_averaged_2, (X(0), (const double[]){X(3), X(4), X(5)}, all),
    slow_flow_detachment(X(0), slow_flow_friction(X(1)), X(2), all[0], values);)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, duffing)
    {"averaged", 4, 4, SF_ONE(duffing_averaged)},
    {"averaged_2", 4, 2, SF_ONE(duffing_averaged_2)},
    {"averaged_H", 4, 2, SF_ONE(duffing_averaged_H)},
    {"harmonics", 4, 8, SF_ONE(duffing_harmonics)},
    {"hardening", 3, 2, SF_ONE(duffing_hardening)},
    {"force", 4, 1, SF_ONE(duffing_force)},
    {"saddle_node_onset", 5, 19, SF_ONE(duffing_saddle_node_onset)},
    {"saddle_nodes", 6, 17, SF_ONE(duffing_saddle_nodes)},
    {"h", 4, 1, SF_ONE(duffing_h)},
    {"h_A", 4, 1, SF_ONE(duffing_h_A)},
    {"h_AA", 4, 1, SF_ONE(duffing_h_AA)},
    {"h_AAA", 4, 1, SF_ONE(duffing_h_AAA)},
    {"H", 4, 1, SF_ONE(duffing_H)},
    {"H_A", 4, 1, SF_ONE(duffing_H_A)},
    {"H_AA", 4, 1, SF_ONE(duffing_H_AA)},
    {"F", 8, 1, SF_ONE(duffing_F)},
    {"F_A", 7, 1, SF_ONE(duffing_F_A)},
    {"level", 7, 1, SF_ONE(duffing_level)},
    {"phase", 7, 1, SF_ONE(duffing_phase)},
    {"jacobian", 7, 4, SF_ONE(duffing_jacobian)},
    {"stability", 7, 1, SF_ONE(duffing_stability)},
    {"transmissibility", 8, 1, SF_ONE(duffing_transmissibility)},
    {"backbone", 4, 1, SF_ONE(duffing_backbone)},
    {"limit_envelope", 4, 1, SF_ONE(duffing_limit_envelope)},
    {"equivalent_damping", 4, 1, SF_ONE(duffing_equivalent_damping)},
    {"response_quartic", 7, 4, SF_ONE(duffing_response_quartic)},
    {"fold_quartic", 6, 4, SF_ONE(duffing_fold_quartic)},
    {"peak_cubic", 6, 3, SF_ONE(duffing_peak_cubic)},
    {"detachment", 6, 4, SF_ONE(duffing_detachment)},
};

const sf_module sf_module_duffing = {"duffing", kernels, sizeof kernels / sizeof kernels[0]};
