/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene zeta = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow_zeta0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow_zeta0.h"

#include "kernels.h"

SF_LOOP(slow_flow_zeta0_limit_envelope_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_zeta0_limit_envelope(Omega, F_0, m, zeta);
)

SF_LOOP(slow_flow_zeta0_detachment_loop, 3,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
    slow_flow_zeta0_detachment(A, m, zeta, h, values);
)

SF_LOOP(slow_flow_zeta0_undamped_Omega_loop, 1,
    const double h_A = in[0][i];
    values[0] = slow_flow_zeta0_undamped_Omega(h_A);
)

SF_LOOP(slow_flow_zeta0_fold_loop, 2,
    const double F_0 = in[0][i], m = in[1][i], k = in[2][i], k_A = in[3][i];
    slow_flow_zeta0_fold(F_0, m, k, k_A, values);
)

SF_LOOP(slow_flow_zeta0_undamped_level_loop, 1,
    const double m = in[0][i], k = in[1][i];
    values[0] = slow_flow_zeta0_undamped_level(m, k);
)

SF_LOOP(slow_flow_zeta0_undamped_rises_loop, 2,
    const double h_AA = in[0][i], h_AAA = in[1][i], k = in[2][i];
    slow_flow_zeta0_undamped_rises(h_AA, h_AAA, k, values);
)

SF_LOOP(slow_flow_zeta0_undamped_loop, 4,
    const double A = in[0][i], h = in[1][i], h_A = in[2][i], h_AA = in[3][i], h_AAA = in[4][i];
    slow_flow_zeta0_undamped(A, h, h_A, h_AA, h_AAA, values);
)

static const sf_kernel kernels[] = {
    {"limit_envelope", 4, 1, 1, NULL, SF_ONE(slow_flow_zeta0_limit_envelope_loop)},
    {"detachment", 4, 3, 1, NULL, SF_ONE(slow_flow_zeta0_detachment_loop)},
    {"undamped_Omega", 1, 1, 1, NULL, SF_ONE(slow_flow_zeta0_undamped_Omega_loop)},
    {"fold", 4, 2, 1, NULL, SF_ONE(slow_flow_zeta0_fold_loop)},
    {"undamped_level", 2, 1, 1, NULL, SF_ONE(slow_flow_zeta0_undamped_level_loop)},
    {"undamped_rises", 3, 2, 1, NULL, SF_ONE(slow_flow_zeta0_undamped_rises_loop)},
    {"undamped", 5, 4, 1, NULL, SF_ONE(slow_flow_zeta0_undamped_loop)},
};

const sf_module sf_module_slow_flow_zeta0 = {"slow_flow_zeta0", kernels, sizeof kernels / sizeof kernels[0]};
