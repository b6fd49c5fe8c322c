"""Sizing: effect of tolerances, designs that meet requirements, parameters identified from measurements.

`tolerances`, `sobol`, `meet`, `front` and `fit` take an `Isolator`, or a mount in SI units (`Isolator.physical`);
`from_loop` takes a measured force-displacement loop.

Available answers for a mount; for a dimensionless oscillator the prefix f_ is Omega_:

    F_SN, F_cr   -- the lowest forcing with a fold, and the lowest that detaches the springs; inf if there is none.
            Under base excitation Y_SN and Y_cr, in m; with an unbalance U_SN and U_cr, in kg m
    f_rest       -- natural frequency of small motions
    break_loose, sticking -- the constant force that friction holds, and the force amplitude up to which averaging
            predicts sticking; rests_within: distance from the centre within which friction holds the mass, not under a
            load
    of_SN, of_cr -- margins: F_SN and F_cr over the forcing
    A_peak, f_peak -- the highest peak at the forcing: 0 if the mass sticks, inf if it is unbounded; if the amplitude
            increases with frequency throughout, as under base excitation, its limit, without a frequency
    f_jump_up, f_jump_down -- the lowest fold with an upward jump, the highest with a downward jump
    f_band       -- width of the bands with several stable motions, 0 if there are none
    f_sticks     -- under base excitation or unbalance: the frequency up to which the mass sticks at the forcing
    stroke       -- under a load, the largest |x| at the forcing, |B| + A
    f_isolation  -- the frequency above which less than the forcing is transmitted
    A, transmissibility -- at a forcing and a frequency, for the stable motion with the largest amplitude; 0 if the mass
                    sticks; the transmissibility is that of the first harmonic, as a ratio
    A_spectrum, transmissibility_spectrum -- the largest of these over a load spectrum
    of_SN_spectrum, of_cr_spectrum -- margins of its largest forcing
    rows_several, rows_cross, rows_detach, rows_stick -- number of its rows that have several stable motions, cross a
            fold on the way from the previous row, detach the springs, and in which the mass sticks
    A_shock, a_shock -- the largest deflection and the largest acceleration of the mass in a half sine of the base, by
            the equation of motion; of_cr_shock: the stroke over that deflection, above 1 the springs stay attached

Any parameter of the design can be varied, including static friction if specified. Static friction affects only
break_loose, rests_within and the answers in a shock; it must not be less than kinetic friction. With eta, c_2 or
contact="attached", answers take tens of microseconds per design, f_isolation some tenths of a millisecond. Structural
damping is defined at one frequency:
with it there is no answer in a shock.

A design with folds below F_SN that end at Omega = 0 has no F_SN here.

For a design under a load, A_peak and A are about the mean, and A_shock is the largest |x|. Its mass is `load`; k_v is
preloaded for m. Each answer, and each row of a spectrum, then takes tenths of a second instead of microseconds.
"""

from slowflow.sizing.fitting import fit
from slowflow.sizing.loops import from_loop
from slowflow.sizing.requirements import front, meet
from slowflow.sizing.tolerances import sobol, tolerances

__all__ = ["fit", "from_loop", "front", "meet", "sobol", "tolerances"]
