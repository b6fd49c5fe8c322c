/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow_mu0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow_mu0.h"

#include "kernels.h"

SF_LOOP(slow_flow_mu0_response_quartic_loop, 4,
    const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    slow_flow_mu0_response_quartic(A, F_0, m, zeta, h, values);
)

SF_LOOP(slow_flow_mu0_detachment_loop, 3,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
    slow_flow_mu0_detachment(A, m, zeta, h, values);
)

SF_LOOP(slow_flow_mu0_fold_loop, 3,
    const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], k =
        in[6][i], k_A = in[7][i];
    slow_flow_mu0_fold(A, F_0, m, zeta, h, h_A, k, k_A, values);
)

SF_LOOP(slow_flow_mu0_isola_loop, 2,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i], h_AA = in[5][i];
    slow_flow_mu0_isola(A, m, zeta, h, h_A, h_AA, values);
)

static const sf_kernel kernels[] = {
    {"response_quartic", 5, 4, 1, NULL, SF_ONE(slow_flow_mu0_response_quartic_loop)},
    {"detachment", 4, 3, 1, NULL, SF_ONE(slow_flow_mu0_detachment_loop)},
    {"fold", 8, 3, 1, NULL, SF_ONE(slow_flow_mu0_fold_loop)},
    {"isola", 6, 2, 1, NULL, SF_ONE(slow_flow_mu0_isola_loop)},
};

const sf_module sf_module_slow_flow_mu0 = {"slow_flow_mu0", kernels, sizeof kernels / sizeof kernels[0]};
