/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr; amplitudes up to u_cr only: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring_attached.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring_attached.h"

#include "kernels.h"

void slow_flow_F_AAA_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_AA_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_AOmega_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_A_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_Omega_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_I_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_R_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_backbone_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_friction_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_jacobian_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_phase_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_stability_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_transmissibility_loop(ptrdiff_t n, const double *const *in, double *const *out);

SF_WIDE void rod_spring_attached_averaged_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[4];
        rod_spring_attached_averaged(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static const sf_loop rod_spring_attached_averaged_loops[] = {
    rod_spring_attached_averaged_loop,
};

SF_WIDE void rod_spring_attached_averaged_3_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[3];
        rod_spring_attached_averaged_3(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

static const sf_loop rod_spring_attached_averaged_3_loops[] = {
    rod_spring_attached_averaged_3_loop,
};

SF_WIDE void rod_spring_attached_averaged_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_attached_averaged_2(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static const sf_loop rod_spring_attached_averaged_2_loops[] = {
    rod_spring_attached_averaged_2_loop,
};

SF_WIDE void rod_spring_attached_h_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_attached_h(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static const sf_loop rod_spring_attached_h_loops[] = {
    rod_spring_attached_h_loop,
};

SF_WIDE void rod_spring_attached_h_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_attached_h_A(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static const sf_loop rod_spring_attached_h_A_loops[] = {
    rod_spring_attached_h_A_loop,
};

SF_WIDE void rod_spring_attached_h_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_attached_h_AA(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static const sf_loop rod_spring_attached_h_AA_loops[] = {
    rod_spring_attached_h_AA_loop,
};

SF_WIDE void rod_spring_attached_h_AAA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_attached_h_AAA(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static const sf_loop rod_spring_attached_h_AAA_loops[] = {
    rod_spring_attached_h_AAA_loop,
};

SF_WIDE void rod_spring_attached_H_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_attached_H(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static const sf_loop rod_spring_attached_H_loops[] = {
    rod_spring_attached_H_loop,
};

SF_WIDE void rod_spring_attached_H_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_attached_H_A(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static const sf_loop rod_spring_attached_H_A_loops[] = {
    rod_spring_attached_H_A_loop,
};

SF_WIDE void rod_spring_attached_H_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_attached_H_AA(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static const sf_loop rod_spring_attached_H_AA_loops[] = {
    rod_spring_attached_H_AA_loop,
};

static void rod_spring_attached_R_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_attached_h_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static const sf_loop rod_spring_attached_R_loops[] = {
    rod_spring_attached_R_chain_0,
};

static void rod_spring_attached_I_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_I_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_attached_I_loops[] = {
    rod_spring_attached_I_chain_0,
};

static void rod_spring_attached_F_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_attached_h_loop(n, (const double *[]){in[1], in[5], in[6], in[7], in[8]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static const sf_loop rod_spring_attached_F_loops[] = {
    rod_spring_attached_F_chain_0,
};

static void rod_spring_attached_F_A_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_attached_averaged_2_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static const sf_loop rod_spring_attached_F_A_loops[] = {
    rod_spring_attached_F_A_chain_0,
};

static void rod_spring_attached_F_AA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_attached_averaged_3_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static const sf_loop rod_spring_attached_F_AA_loops[] = {
    rod_spring_attached_F_AA_chain_0,
};

static void rod_spring_attached_F_AAA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_attached_averaged_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static const sf_loop rod_spring_attached_F_AAA_loops[] = {
    rod_spring_attached_F_AAA_chain_0,
};

static void rod_spring_attached_F_Omega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_attached_h_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static const sf_loop rod_spring_attached_F_Omega_loops[] = {
    rod_spring_attached_F_Omega_chain_0,
};

static void rod_spring_attached_F_AOmega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_attached_averaged_2_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static const sf_loop rod_spring_attached_F_AOmega_loops[] = {
    rod_spring_attached_F_AOmega_chain_0,
};

static void rod_spring_attached_phase_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_attached_h_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static const sf_loop rod_spring_attached_phase_loops[] = {
    rod_spring_attached_phase_chain_0,
};

static void rod_spring_attached_jacobian_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_attached_averaged_2_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static const sf_loop rod_spring_attached_jacobian_loops[] = {
    rod_spring_attached_jacobian_chain_0,
};

static void rod_spring_attached_stability_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_attached_averaged_2_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static const sf_loop rod_spring_attached_stability_loops[] = {
    rod_spring_attached_stability_chain_0,
};

static void rod_spring_attached_transmissibility_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_attached_h_loop(n, (const double *[]){in[1], in[5], in[6], in[7], in[8]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static const sf_loop rod_spring_attached_transmissibility_loops[] = {
    rod_spring_attached_transmissibility_chain_0,
};

static void rod_spring_attached_backbone_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_attached_h_loop(n, (const double *[]){in[0], in[1], in[2], in[3], in[4]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static const sf_loop rod_spring_attached_backbone_loops[] = {
    rod_spring_attached_backbone_chain_0,
};

static void rod_spring_attached_limit_envelope_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_limit_envelope_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_attached_limit_envelope_loops[] = {
    rod_spring_attached_limit_envelope_chain_0,
};

static void rod_spring_attached_equivalent_damping_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_equivalent_damping_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_attached_equivalent_damping_loops[] = {
    rod_spring_attached_equivalent_damping_chain_0,
};

static const sf_kernel kernels[] = {
    {"averaged",
     "h, h_A, h_AA, h_AAA together. Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.",
     5, 4, 1, NULL, rod_spring_attached_averaged_loops},
    {"averaged_3",
     "h, h_A, h_AA together. Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.",
     5, 3, 1, NULL, rod_spring_attached_averaged_3_loops},
    {"averaged_2",
     "h, h_A together. Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.",
     5, 2, 1, NULL, rod_spring_attached_averaged_2_loops},
    {"h",
     "The averaged restoring force h = H - A. Equation (20)-(22). Domain: 0 <= A <= u_cr.",
     5, 1, 1, NULL, rod_spring_attached_h_loops},
    {"h_A",
     "d/dA of the averaged restoring force h = H - A. Equation (31). Domain: 0 <= A <= u_cr.",
     5, 1, 1, NULL, rod_spring_attached_h_A_loops},
    {"h_AA",
     "d2/dA2 of the averaged restoring force h = H - A. Equation from (31). Domain: 0 <= A <= u_cr.",
     5, 1, 1, NULL, rod_spring_attached_h_AA_loops},
    {"h_AAA",
     "d3/dA3 of the averaged restoring force h = H - A. Equation from (31). Domain: 0 <= A <= u_cr.",
     5, 1, 1, NULL, rod_spring_attached_h_AAA_loops},
    {"H",
     "The averaged force H beside the vertical spring. Equation (20)-(22). Domain: 0 <= A <= u_cr.",
     5, 1, 1, NULL, rod_spring_attached_H_loops},
    {"H_A",
     "d/dA of the averaged force H beside the vertical spring. Equation (31). Domain: 0 <= A <= u_cr.",
     5, 1, 1, NULL, rod_spring_attached_H_A_loops},
    {"H_AA",
     "d2/dA2 of the averaged force H beside the vertical spring. Equation from (31). Domain: 0 <= A <= u_cr.",
     5, 1, 1, NULL, rod_spring_attached_H_AA_loops},
    {"R",
     "Cosine balance, -F_0 cos phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_R_loops},
    {"I",
     "Sine balance, -F_0 sin phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_I_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     9, 1, 1, NULL, rod_spring_attached_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_F_A_loops},
    {"F_AA",
     "d2F/dA2. Equation (24), (33). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_F_AA_loops},
    {"F_AAA",
     "d3F/dA3. Equation (24). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_F_AAA_loops},
    {"F_Omega",
     "dF/dOmega. Equation (24), (34). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_F_Omega_loops},
    {"F_AOmega",
     "d2F/dA dOmega. Equation (24). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_F_AOmega_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_phase_loops},
    {"jacobian",
     "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22. Equation (28). Domain: Omega > 0, A "
     "> 0.",
     8, 4, 1, NULL, rod_spring_attached_jacobian_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_attached_stability_loops},
    {"transmissibility",
     "Fundamental harmonic of the force on the base over F_0, at a steady state. Equation from (23). Domain: Omega > "
     "0, A > 0, F_0 > 0.",
     9, 1, 1, NULL, rod_spring_attached_transmissibility_loops},
    {"backbone",
     "Frequency on the backbone. Equation (26). Domain: A > 0, h <= 0.",
     5, 1, 1, NULL, rod_spring_attached_backbone_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, rod_spring_attached_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, rod_spring_attached_equivalent_damping_loops},
};

const sf_module sf_module_rod_spring_attached = {"rod_spring_attached", kernels, sizeof kernels / sizeof kernels[0]};
