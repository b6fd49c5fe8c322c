"""The questions that are put together from others: margins, hysteresis, isolation and load spectra."""

from __future__ import annotations

from typing import TYPE_CHECKING

from slowflow.questions import Questions
from slowflow.results import FrequencyResponse, SaddleNodes, SteadyStates

if TYPE_CHECKING:
    from slowflow import checks
    from slowflow.mechanism import Reals


class ComposedQuestions(Questions[SteadyStates, FrequencyResponse, SaddleNodes]):
    """What is put together from the averaged answers about one oscillator, whatever system gives these."""

    def _check_margins(self) -> None:
        """Raises NotAvailable where it is not known which forcing detaches; of most systems it always is."""

    def _detaches(self, F_0: float) -> bool:
        """Whether a stable motion passes the first breakpoint."""
        from slowflow import checks

        return checks.passes_first_end(self, F_0)

    def _isolation(self, F_0: float, level_dB: float) -> checks.Isolation:
        from slowflow import checks

        return checks.isolation(self, F_0, level_dB)

    def margins(self, F_0: float) -> checks.Margins:
        """How far F_0 is from the lowest forcing that has a fold, F_SN, and from that which lifts the springs, F_cr.

        `.of_SN` and `.of_cr` are these over F_0. Raises ValueError for F_0 <= 0.
        """
        from slowflow import checks

        return checks.margins(self._system, F_0)

    def hysteresis(self, F_0: float) -> checks.Hysteresis:
        """The bands of frequencies at F_0 with several stable motions: .Omega_low .Omega_high .motions.

        A sweep jumps at their ends, see `saddle_nodes`. Under a load a motion of a negative mean stiffness may lose its
        stability within a band too, and the message says where one takes part. Raises ValueError for F_0 <= 0.
        """
        from slowflow import checks

        return checks.hysteresis(self._system, F_0)

    def isolation(self, F_0: float, level_dB: float = 0.0) -> checks.Isolation:
        """The frequency from which on every stable motion at F_0 transmits less than F_0, .Omega, and .A there.

        level_dB -- the transmissibility below which it stays, in decibels: -20 for a tenth of F_0, 0 for all of it

        Of the transmitted force the fundamental harmonic counts; `.measure()` has that of the equation of motion, and
        of the peak of its whole wave. For a linear spring it is sqrt(2) times the natural frequency at 0 dB. On a base
        that shakes it is that from which on the mass moves less than the base. Friction alone passes on 4 mu/pi of a
        force at any frequency: where the level is not above that there is none.

        Under a load it is found on the response curve, and that no stable motion transmits that beyond it is proved but
        for 2^-16 of it; where that is undecided the answer says so, `Remark.UNDECIDED`.

        Raises ValueError for F_0 <= 0 and level_dB > 0, and under a load where motions go beyond the amplitude `A_max`
        of `off_centre`, as on a base that shakes too much for a hardening spring.
        """
        found: checks.Isolation = self._system._isolation(F_0, level_dB)
        return found

    def spectrum(self, *, Omega: Reals, F_0: Reals) -> checks.Spectrum:
        """A load spectrum, one tone at a time: what the motion at each pair (Omega, F_0) does, in their order.

        Which have several motions, cross a fold from the one before, detach, stick; see `slowflow.checks.Spectrum`.
        Under a load rows with several forcings take some tenths of a second each, few rows two seconds: folds of
        forcings between are found, which rows share.
        Raises ValueError for numbers <= 0 and for shapes that do not broadcast.
        """
        from slowflow import checks

        return checks.spectrum(self._system, Omega, F_0)
