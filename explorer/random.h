/* Random vibration beside explorer.c. */
#pragma once

/* the force of the oscillator that was chosen */
double sf_explored_force(double u);

/* Stationary motions of an oscillator with breakpoints b, by rising sigma_u, under white noise of a power c sigma_v^2,
 * or of 0 under a density by points, frequency and density of each. out: sigma_u, sigma_v, stiffness, and which share
 * of the equivalent damping is dry friction's; returns their number, at most `room`, -1 where it is not decided, -2
 * where friction holds the mass. */
int sf_explored_random(const double *b, int breaks, double mu, double zeta, double power, const double (*points)[2],
                       int count, int room, double *const out[4]);
