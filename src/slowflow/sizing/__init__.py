"""Sizing: what tolerances do to a design, which design meets requirements, which numbers a measurement says.

In:  an `Isolator`, or a mount in SI units (`Isolator.physical`). Out: `tolerances`, `sobol`, `meet`, `front`, `fit`;
     of a measured force-displacement loop `from_loop`.

Answers that can be asked for, of a mount; frequencies of an oscillator without dimensions begin with Omega_ for f_:

    F_SN, F_cr   -- the lowest forcing with a fold, and that which lifts the springs; inf where there is none. Of a
                    mount on a base that shakes Y_SN and Y_cr, in m; with an unbalance U_SN and U_cr, in kg m
    f_rest       -- natural frequency of small motions
    break_loose, sticking -- the constant force that friction holds, and the amplitude of a force up to which averaging
                    has the mass at rest; rests_within: how far from the centre it rests, not under a load
    of_SN, of_cr -- margins: F_SN and F_cr over the forcing
    A_peak, f_peak -- the highest peak at the forcing: 0 where the mass sticks, inf where it has no bound; where the
                    amplitude only rises, as it may on a base that shakes, what it tends to, without a frequency
    f_jump_up, f_jump_down -- the lowest fold that a sweep leaves upwards, the highest that it leaves downwards
    f_band       -- how wide the bands with several stable motions are, 0 where there are none
    f_sticks     -- of a base that shakes and of an unbalance: the frequency up to which the mass sticks at the forcing
    stroke       -- under a load, the largest |x| at the forcing, |B| + A
    f_isolation  -- from which frequency on less than the forcing is transmitted
    A, transmissibility -- at a forcing and a frequency, of the stable motion with the largest amplitude: 0 where the
                    mass sticks, and the share of the first harmonic that is transmitted, as a ratio
    A_spectrum, transmissibility_spectrum -- the largest of these over a load spectrum
    of_SN_spectrum, of_cr_spectrum -- margins of its largest forcing
    rows_several, rows_cross, rows_detach, rows_stick -- how many of its rows have several stable motions, cross a fold
                    on the way from the row before, detach the springs, and have the mass stick
    A_shock, a_shock -- the largest deflection and the largest acceleration of the mass in a half sine of the base, by
                    the equation of motion; of_cr_shock: the stroke over that deflection, above 1 the springs stay

Numbers that can be varied are those that a design is made from, static friction where it is given. It changes no
averaged answer, but break_loose, rests_within and those in a shock; a design with less of it than of the kinetic one is
none. With eta, c_2 or rubs="attached", or where eta or c_2 is varied, answers take tens of microseconds a design,
f_isolation some tenths of a millisecond. Structural damping is stated at one frequency: with it there is no answer in a
shock.

F_SN does not tell of folds below it that end at Omega = 0, where a design has such: it has no F_SN here then.

Of a design under a load A_peak and A are about the mean, A_shock is the largest |x|. Its mass is `load`, and m what k_v
is preset for. Each answer takes tenths of a second then, not microseconds, and a row of a spectrum too.
"""

from slowflow.sizing.fitting import fit
from slowflow.sizing.loops import from_loop
from slowflow.sizing.requirements import front, meet
from slowflow.sizing.tolerances import sobol, tolerances

__all__ = ["fit", "from_loop", "front", "meet", "sobol", "tolerances"]
