"""Sizing: what tolerances do to a design, which design meets requirements, which numbers a measurement says.

In:  an `Isolator`, or a mount in SI units (`Isolator.physical`). Out: `tolerances`, `sobol`, `meet`, `fit`.

Answers that can be asked for, of a mount; frequencies of an isolator without dimensions begin with Omega_ for f_:

    F_SN, F_cr   -- the lowest forcing with a fold, and that which lifts the springs; inf where there is none
    f_rest       -- natural frequency of small motions
    A_peak, f_peak -- the highest peak at the forcing: 0 where the mass sticks, inf where it has no bound
    f_jump_up, f_jump_down -- the lowest fold that a sweep leaves upwards, the highest that it leaves downwards
    f_isolation  -- from which frequency on less than the forcing is transmitted: design by design, so only if named
"""

from slowflow.sizing.fitting import fit
from slowflow.sizing.requirements import meet
from slowflow.sizing.tolerances import sobol, tolerances

__all__ = ["fit", "meet", "sobol", "tolerances"]
