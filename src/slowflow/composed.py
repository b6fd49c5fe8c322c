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
        """Compare F_0 with the lowest forcing that has a fold, F_SN, and the lowest that detaches the springs, F_cr.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.

        Returns
        -------
        Margins
            .F_SN .F_cr, and over F_0 .of_SN .of_cr: below 1 the limit is exceeded.

        Raises
        ------
        ValueError
            For F_0 <= 0.
        """
        from slowflow import checks

        return checks.margins(self._system, F_0)

    def hysteresis(self, F_0: float) -> checks.Hysteresis:
        """Find the bands of frequencies at F_0 with several stable motions: a sweep jumps at their ends.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.

        Returns
        -------
        Hysteresis
            .Omega_low .Omega_high .motions, shape (n,). Under a load a motion of a negative mean stiffness may lose its
            stability within a band too, and the message says where one takes part.

        Raises
        ------
        ValueError
            For F_0 <= 0.
        """
        from slowflow import checks

        return checks.hysteresis(self._system, F_0)

    def isolation(self, F_0: float, level_dB: float = 0.0) -> checks.Isolation:
        """Find the frequency from which on every stable motion at F_0 transmits less than F_0, or than a level of it.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.
        level_dB : float
            Transmissibility below which it stays, <= 0, in decibels: -20 for a tenth of F_0.

        Returns
        -------
        Isolation
            .Omega, and .A there. Of the transmitted force the first harmonic counts; `.measure()` has that of the
            equation of motion, and of the peak of its whole wave. For a linear spring it is sqrt(2) times the natural
            frequency at 0 dB. Under base excitation it is that from which on the mass moves less than the base.
            Friction alone transmits 4 mu/pi at any frequency: where the level is not above that there is none.
            Under a load it is found on the response curve, and that no stable motion transmits that beyond it is proved
            but for 2^-16 of it; where that is undecided the answer says so, `Remark.UNDECIDED`.

        Raises
        ------
        ValueError
            For F_0 <= 0 and level_dB > 0, and under a load where motions exceed the amplitude `A_max` of `off_centre`,
            as a hardening spring on a base that moves too much.
        """
        return self._system._isolation(F_0, level_dB)

    def spectrum(self, *, Omega: Reals, F_0: Reals) -> checks.Spectrum:
        """Find what the motion does at each row of a load spectrum, one tone at a time, in their order.

        Parameters
        ----------
        Omega, F_0 : array_like
            Frequencies and amplitudes of the excitation, > 0, that broadcast.

        Returns
        -------
        Spectrum
            Which rows have several motions, cross a fold from the one before, detach, stick; see
            `slowflow.checks.Spectrum`. Under a load rows with several forcings take some tenths of a second each, few
            rows two seconds: folds of forcings between are found, which rows share.

        Raises
        ------
        ValueError
            For numbers <= 0 and for shapes that do not broadcast.
        """
        from slowflow import checks

        return checks.spectrum(self._system, Omega, F_0)
