"""Independent references: none shares a step with what it is held against; each says what it shares at its top.

averaged, conditioning    certified folds, onsets, states of an averaged oscillator, and how well-conditioned they are
certified_roots           every real root of a function in a range, enclosed: what `averaged` isolates with
answers                   exact solutions next to an answer, and its condition
errors                    what an answer is off a certified point, in u (1 + kappa)
counts                    proved numbers of states and folds at any forcing
definitions               what kernels are to give, by routes other than the derivation
kernels                   exact values of any generated kernel at any doubles
frequencies               certified roots in Omega at one amplitude, and seeded stress cases for them
by_work                   states and folds of any oscillator about the centre, counted on a grid of amplitudes
by_time                   the equation of motion by SciPy from switch to switch, the spring typed by hand
exact_reference, exact_cases    the same by other means, and oscillators to try
pieces, forces            forces of any kind, each stated once, and their averages to 40 digits
inertia                   certified answers on a base that shakes
second, stated            the second approximation, and mechanisms as their files state them
draws                     random numbers of designs
make_kernel_oracle, make_random_isolators, make_off_centre, make_off_centre_laws, make_damped, make_sided, make_stated,
make_closed, make_exact_motions        programs that write `tests/data`, as forces, inertia and second do
"""
