/* Den Hartog's exact solution of the linear oscillator with dry friction, without stops.

   Written by `make derive` from derivations/paper/den_hartog.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef DEN_HARTOG_H
#define DEN_HARTOG_H

#include <math.h>

#include "inline.h"

/* Response function.
   Equation (37). Domain: Omega > 0, Omega != 1. Operations: 3. Error / u (1 + kappa): measured 1.4. */
SF_KERNEL double den_hartog_V(double Omega) {
    return -1.0 / ((Omega - 1.0) * (Omega + 1.0));
}

/* Damping function.
   Equation (37). Domain: Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 6. Error / u (1 + kappa): measured
   1.4. */
SF_KERNEL double den_hartog_U(double Omega) {
    const double t0 = 1.0 / Omega;
    return t0 / tan(1.5707963267948966 * t0 * (Omega - 1.0));
}

/* S is the maximum of this over 0 < tau < pi/Omega.
   Equation (37). Domain: 0 < tau < pi/Omega, Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 23. Error / u
   (1 + kappa): measured 3.9. */
SF_KERNEL double den_hartog_S_ratio(double tau, double Omega) {
    const double t0 = 1.0 / Omega;
    const double t1 = Omega - 1.0;
    const double U = t0 / tan(1.5707963267948966 * t0 * t1);
    const double t2 = 0.5 * tau;
    return (-2.0 * Omega * Omega * U * sin(t1 * t2) * sin(t2 * (Omega + 1.0)) + Omega * sin(tau)) / sin(Omega *
        tau);
}

/* Amplitude of the motion.
   Equation (35). Domain: F_0 |V| > mu |U|, Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 14. Error / u (1
   + kappa): measured 1.5. */
SF_KERNEL double den_hartog_amplitude(double Omega, double F_0, double mu) {
    const double t0 = Omega - 1.0;
    const double V = -1.0 / (t0 * (Omega + 1.0));
    const double t1 = 1.0 / Omega;
    const double U = t1 / tan(1.5707963267948966 * t0 * t1);
    const double t2 = F_0 * V;
    const double t3 = U * mu;
    return sqrt((t2 - t3) * (t2 + t3));
}

/* The motion has no stops while its amplitude exceeds this.
   Equation (36). Domain: Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 20. Error / u (1 + kappa):
   measured 1.9. */
SF_KERNEL double den_hartog_bound(double Omega, double F_0, double S) {
    const double t0 = Omega - 1.0;
    const double V = -1.0 / (t0 * (Omega + 1.0));
    const double t1 = 1.0 / Omega;
    const double U = t1 / tan(1.5707963267948966 * t0 * t1);
    const double Omega2 = Omega * Omega;
    const double Omega4 = Omega2 * Omega2;
    return F_0 * fabs(S) * fabs(V) / sqrt(Omega4 * U * U + S * S);
}

/* Displacement tau after a maximum.
   Equation from (37). Domain: 0 <= tau <= pi/Omega, Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 27.
   Error / u (1 + kappa): measured 1.7. */
SF_KERNEL double den_hartog_motion(double tau, double Omega, double A, double mu) {
    const double t0 = 1.0 / Omega;
    const double t1 = Omega - 1.0;
    const double U = t0 / tan(1.5707963267948966 * t0 * t1);
    const double t2 = Omega * tau;
    const double t3 = 0.5 * tau;
    return A * cos(t2) + U * mu * (-t1 * sin(tau) + 2.0 * sin(t1 * t3) * cos(0.5 * t2 + t3)) - mu * cos(tau) +
        mu;
}

#endif
