/* Den Hartog's exact solution of the linear oscillator with dry friction, without stops: loops for NumPy.

   Written by `make derive`; never edit.
   Input: den_hartog.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "den_hartog.h"

#include "kernels.h"

SF_LOOP(den_hartog_V_loop, 1,
    const double Omega = in[0][i];
    values[0] = den_hartog_V(Omega);
)

SF_LOOP(den_hartog_U_loop, 1,
    const double Omega = in[0][i];
    values[0] = den_hartog_U(Omega);
)

SF_LOOP(den_hartog_S_ratio_loop, 1,
    const double tau = in[0][i], Omega = in[1][i];
    values[0] = den_hartog_S_ratio(tau, Omega);
)

SF_LOOP(den_hartog_amplitude_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i], mu = in[2][i];
    values[0] = den_hartog_amplitude(Omega, F_0, mu);
)

SF_LOOP(den_hartog_bound_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i], S = in[2][i];
    values[0] = den_hartog_bound(Omega, F_0, S);
)

SF_LOOP(den_hartog_motion_loop, 1,
    const double tau = in[0][i], Omega = in[1][i], A = in[2][i], mu = in[3][i];
    values[0] = den_hartog_motion(tau, Omega, A, mu);
)

static const sf_kernel kernels[] = {
    {"V", 1, 1, 1, NULL, SF_ONE(den_hartog_V_loop)},
    {"U", 1, 1, 1, NULL, SF_ONE(den_hartog_U_loop)},
    {"S_ratio", 2, 1, 1, NULL, SF_ONE(den_hartog_S_ratio_loop)},
    {"amplitude", 3, 1, 1, NULL, SF_ONE(den_hartog_amplitude_loop)},
    {"bound", 3, 1, 1, NULL, SF_ONE(den_hartog_bound_loop)},
    {"motion", 4, 1, 1, NULL, SF_ONE(den_hartog_motion_loop)},
};

const sf_module sf_module_den_hartog = {"den_hartog", kernels, sizeof kernels / sizeof kernels[0]};
