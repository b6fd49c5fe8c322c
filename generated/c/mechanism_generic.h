/* What every mechanism has of its averaged force: one output each, and the functions of the slow flow.

   Written by `make derive`; never edit.

   Included where OF makes the names of functions. Rounding errors are in each module of slowflow_kernels. */

/* The averaged restoring force h = H - A.
   Equation (20)-(22). Domain: A >= 0. */
KERNEL double OF(h)(double A, const double *p) {
    double values[2];
    OF(averaged_2)(A, p, values);
    return values[0];
}

/* d/dA of the averaged restoring force h = H - A.
   Equation (31). Domain: A >= 0. */
KERNEL double OF(h_A)(double A, const double *p) {
    double values[2];
    OF(averaged_2)(A, p, values);
    return values[1];
}

/* d2/dA2 of the averaged restoring force h = H - A.
   Equation from (31). Domain: A >= 0. */
KERNEL double OF(h_AA)(double A, const double *p) {
    double values[4];
    OF(averaged)(A, p, values);
    return values[2];
}

/* d3/dA3 of the averaged restoring force h = H - A.
   Equation from (31). Domain: A >= 0. */
KERNEL double OF(h_AAA)(double A, const double *p) {
    double values[4];
    OF(averaged)(A, p, values);
    return values[3];
}

/* The averaged force H beside the vertical spring.
   Equation (20)-(22). Domain: A >= 0. */
KERNEL double OF(H)(double A, const double *p) {
    double values[2];
    OF(averaged_H)(A, p, values);
    return values[0];
}

/* d/dA of the averaged force H beside the vertical spring.
   Equation (31). Domain: A >= 0. */
KERNEL double OF(H_A)(double A, const double *p) {
    double values[2];
    OF(averaged_H)(A, p, values);
    return values[1];
}

/* d2/dA2 of the averaged force H beside the vertical spring.
   Equation from (31). Domain: A >= 0. */
KERNEL double OF(H_AA)(double A, const double *p) {
    double values[4];
    OF(averaged)(A, p, values);
    return values[2];
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. */
KERNEL double OF(F)(double Omega, double A, double F_0, double mu, double zeta, const double *p) {
    double average[2];
    OF(averaged_2)(A, p, average);
    return slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. */
KERNEL double OF(F_A)(double Omega, double A, double mu, double zeta, const double *p) {
    double average[2];
    OF(averaged_2)(A, p, average);
    return slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* The forcing F_0 for which (Omega, A) is a steady state.
   Equation (24). Domain: Omega >= 0, A > 0. */
KERNEL double OF(level)(double Omega, double A, double mu, double zeta, const double *p) {
    double average[2];
    OF(averaged_2)(A, p, average);
    return slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. */
KERNEL double OF(phase)(double Omega, double A, double mu, double zeta, const double *p) {
    double average[2];
    OF(averaged_2)(A, p, average);
    return slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. */
KERNEL void OF(jacobian)(double Omega, double A, double mu, double zeta, const double *p, double *out) {
    double average[2];
    OF(averaged_2)(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], out);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. */
KERNEL double OF(stability)(double Omega, double A, double mu, double zeta, const double *p) {
    double average[2];
    OF(averaged_2)(A, p, average);
    return slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. */
KERNEL double OF(transmissibility)(double Omega, double A, double F_0, double mu, double zeta, const double *p) {
    double average[2];
    OF(averaged_2)(A, p, average);
    return slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. */
KERNEL double OF(backbone)(double A, const double *p) {
    double average[2];
    OF(averaged_2)(A, p, average);
    return slow_flow_backbone(A, average[0]);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. */
KERNEL double OF(limit_envelope)(double Omega, double F_0, double mu, double zeta) {
    return slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. */
KERNEL double OF(equivalent_damping)(double Omega, double A, double mu, double zeta) {
    return slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
}

/* F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24). Domain: A > 0. */
KERNEL void OF(response_quartic)(double A, double F_0, double mu, double zeta, const double *p, double *out) {
    double average[2];
    OF(averaged_2)(A, p, average);
    slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], out);
}

/* F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24), (30). Domain: A > 0. */
KERNEL void OF(fold_quartic)(double A, double mu, double zeta, const double *p, double *out) {
    double average[2];
    OF(averaged_2)(A, p, average);
    slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], out);
}

/* F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.
   Equation (34). Domain: A > 0. */
KERNEL void OF(peak_cubic)(double A, double mu, double zeta, const double *p, double *out) {
    double average[2];
    OF(averaged_2)(A, p, average);
    slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], out);
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: A > 0. */
KERNEL void OF(detachment)(double A, double mu, double zeta, const double *p, double *out) {
    double average[2];
    OF(averaged_2)(A, p, average);
    slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], out);
}
