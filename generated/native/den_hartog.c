/* Den Hartog's exact solution of the linear oscillator with dry friction, without stops: loops for NumPy.

   Written by `make derive`; never edit.
   Input: den_hartog.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "den_hartog.h"

#include "kernels.h"

static SF_WIDE void den_hartog_V_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i];
        out[0][i] = den_hartog_V(Omega);
    }
}

static const sf_loop den_hartog_V_loops[] = {den_hartog_V_loop};

static SF_WIDE void den_hartog_U_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i];
        out[0][i] = den_hartog_U(Omega);
    }
}

static const sf_loop den_hartog_U_loops[] = {den_hartog_U_loop};

static SF_WIDE void den_hartog_S_ratio_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double tau = in[0][i], Omega = in[1][i];
        out[0][i] = den_hartog_S_ratio(tau, Omega);
    }
}

static const sf_loop den_hartog_S_ratio_loops[] = {den_hartog_S_ratio_loop};

static SF_WIDE void den_hartog_amplitude_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], mu = in[2][i];
        out[0][i] = den_hartog_amplitude(Omega, F_0, mu);
    }
}

static const sf_loop den_hartog_amplitude_loops[] = {den_hartog_amplitude_loop};

static SF_WIDE void den_hartog_bound_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], S = in[2][i];
        out[0][i] = den_hartog_bound(Omega, F_0, S);
    }
}

static const sf_loop den_hartog_bound_loops[] = {den_hartog_bound_loop};

static SF_WIDE void den_hartog_motion_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double tau = in[0][i], Omega = in[1][i], A = in[2][i], mu = in[3][i];
        out[0][i] = den_hartog_motion(tau, Omega, A, mu);
    }
}

static const sf_loop den_hartog_motion_loops[] = {den_hartog_motion_loop};

static const sf_kernel kernels[] = {
    {"V",
     "Response function. Equation (37). Domain: Omega > 0, Omega != 1.",
     1, 1, 1, NULL, den_hartog_V_loops},
    {"U",
     "Damping function. Equation (37). Domain: Omega > 0, Omega not 1, 1/3, 1/5 and so on.",
     1, 1, 1, NULL, den_hartog_U_loops},
    {"S_ratio",
     "S is the maximum of this over 0 < tau < pi/Omega. Equation (37). Domain: 0 < tau < pi/Omega, Omega > 0, Omega "
     "not 1, 1/3, 1/5 and so on.",
     2, 1, 1, NULL, den_hartog_S_ratio_loops},
    {"amplitude",
     "Amplitude of the motion. Equation (35). Domain: F_0 |V| > mu |U|, Omega > 0, Omega not 1, 1/3, 1/5 and so on.",
     3, 1, 1, NULL, den_hartog_amplitude_loops},
    {"bound",
     "The motion has no stops while its amplitude exceeds this. Equation (36). Domain: Omega > 0, Omega not 1, 1/3, "
     "1/5 and so on.",
     3, 1, 1, NULL, den_hartog_bound_loops},
    {"motion",
     "Displacement tau after a maximum. Equation from (37). Domain: 0 <= tau <= pi/Omega, Omega > 0, Omega not 1, "
     "1/3, 1/5 and so on.",
     4, 1, 1, NULL, den_hartog_motion_loops},
};

const sf_module sf_module_den_hartog = {"den_hartog", kernels, sizeof kernels / sizeof kernels[0]};
