"""Sizing: tolerances, designs that meet requirements, parameter identification.

`tolerances`, `sobol`, `meet`, `front` and `fit` take an `Isolator`, or a mount in SI units (`Isolator.physical`).
`from_loop` takes a measured force-displacement loop.

Results that can be requested of a mount; for a dimensionless oscillator, the prefix f_ is Omega_:

    F_SN, F_cr   -- the lowest force with a fold, and the lowest force at which the springs detach; inf if there is
            none. Under base excitation Y_SN and Y_cr, in m; with an unbalance U_SN and U_cr, in kg m
    f_rest       -- natural frequency of small motions
    break_loose  -- the largest constant force that friction can hold
    sticking     -- the force amplitude up to which averaging predicts sticking
    rests_within -- distance from the centre within which friction holds the mass; not available under a load
    of_SN, of_cr -- margins: F_SN and F_cr divided by the force
    A_peak, f_peak -- the peak at the force; 0 if the mass sticks, inf if it is unbounded. If the amplitude increases
            with frequency throughout, as under base excitation, A_peak is its limit, and f_peak does not exist
    f_jump_up, f_jump_down -- the lowest frequency of a jump up, the highest frequency of a jump down
    f_band       -- width of the frequency bands with several stable motions, 0 if there are none
    f_sticks     -- under base excitation or unbalance: the frequency up to which the mass sticks
    stroke       -- under a load: the largest |x|, |B| + A
    f_isolation  -- the frequency above which the transmissibility is less than 1
    A, transmissibility -- amplitude and transmissibility (of the first harmonic, as a ratio) at a force and a
            frequency, for the stable motion with the largest amplitude; 0 if the mass sticks
    A_spectrum, transmissibility_spectrum -- the largest of these values in a load spectrum
    of_SN_spectrum, of_cr_spectrum -- margins of the largest force in a load spectrum
    rows_several -- number of rows of a load spectrum with several stable motions
    rows_cross   -- number of rows such that the step from the previous row crosses a fold
    rows_detach  -- number of rows in which the springs detach
    rows_stick   -- number of rows in which the mass sticks
    A_shock, a_shock -- the largest deflection and the largest acceleration of the mass under a half-sine pulse of the
            base, by the equation of motion
    of_cr_shock  -- the stroke of the attached springs divided by A_shock; above 1 the springs stay attached

Any parameter of the design can vary, including static friction if the design has it. Static friction must not be less
than kinetic friction; it affects only break_loose, rests_within and results of a shock. With eta, c_2 or
contact="attached", results take tens of microseconds per design, f_isolation some tenths of a millisecond. With eta,
results of a shock are not available.

If there are folds that end at Omega = 0 at forces below F_SN, F_SN is not available.

For a design under a load, `load` is the mass that the mount carries, m the mass that k_v is preloaded to carry. A_peak
and A are amplitudes about the mean, and A_shock is the largest |x|. Each result, and each row of a spectrum, takes
tenths of a second instead of microseconds.
"""

from slowflow.sizing.fitting import fit
from slowflow.sizing.loops import from_loop
from slowflow.sizing.requirements import front, meet
from slowflow.sizing.tolerances import sobol, tolerances

__all__ = ["fit", "from_loop", "front", "meet", "sobol", "tolerances"]
