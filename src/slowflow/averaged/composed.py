"""Functions that combine several results: margins, hysteresis, isolation and load spectra."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from slowflow.answers.questions import Questions
from slowflow.answers.results import FrequencyResponse, SaddleNodes, SteadyStates
from slowflow.core import validate

if TYPE_CHECKING:
    from slowflow.averaged import checks
    from slowflow.core.mechanism import Reals


@validate.methods_check_arguments()
class ComposedQuestions(Questions[SteadyStates, FrequencyResponse, SaddleNodes]):
    """Questions that combine the averaged answers about one oscillator, from any system."""

    def _lowest_detaching(self) -> float | None:
        """F_cr, or under base excitation or unbalance the limit above which motions detach as Omega tends to inf."""
        F_cr, model = self.detachment().F_cr, self._system.model
        if F_cr is None and model.inertial and self._system.breakpoints:
            return float(model.full_level(self._system.breakpoints[0]))
        return F_cr

    def _composed(self, question: str, *arguments: Any) -> Any:
        """The answer of the function of that name in `checks`, which is imported on first use."""
        from slowflow.averaged import checks

        return getattr(checks, question)(self, *arguments)

    def _detaches(self, F_0: float) -> bool:
        """Whether a stable motion passes the first breakpoint."""
        return self._composed("passes_first_end", F_0)

    def _isolation(self, F_0: float, level_dB: float) -> checks.Isolation:
        return self._composed("isolation", F_0, level_dB)

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
        return self._system._composed("margins", F_0)

    def hysteresis(self, F_0: float) -> checks.Hysteresis:
        """Find the bands of frequencies at F_0 with several stable motions: a sweep jumps at their ends.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.

        Returns
        -------
        Hysteresis
            .Omega_low .Omega_high .motions, shape (n,). Under a load a motion with negative mean stiffness may also
            lose its stability within a band; the message reports such motions.

        Raises
        ------
        ValueError
            For F_0 <= 0.
        """
        return self._system._composed("hysteresis", F_0)

    def isolation(self, F_0: float, level_dB: float = 0.0) -> checks.Isolation:
        """Find the frequency above which every stable motion at F_0 transmits less than F_0, or a given fraction of it.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.
        level_dB : float
            Transmissibility below which it stays, <= 0, in decibels: -20 for a tenth of F_0.

        Returns
        -------
        Isolation
            .Omega, and .A there, by the first harmonic of the transmitted force; `.measure()` gives the frequency for
            the equation of motion, by first harmonic or peak. For a linear spring at 0 dB it is sqrt(2) times the
            natural frequency. Under base excitation the mass moves less than the base above this frequency. Friction
            alone transmits 4 mu/pi at any frequency: for levels below that there is no result. Under a load it is
            proved, to a relative 2^-16, that no stable motion transmits more at higher frequencies. An undecided result
            is marked `Remark.UNDECIDED`.

        Raises
        ------
        ValueError
            For F_0 <= 0 and level_dB > 0, and under a load if motions exceed the amplitude `A_max` of `off_centre`, as
            those of a hardening spring under large base motion.
        """
        return self._system._isolation(F_0, level_dB)

    def spectrum(self, *, Omega: Reals, F_0: Reals) -> checks.Spectrum:
        """Evaluate each row of a load spectrum, one tone at a time, in order.

        Parameters
        ----------
        Omega, F_0 : array_like
            Frequencies and amplitudes of the excitation, > 0, that broadcast.

        Returns
        -------
        Spectrum
            Which rows have several motions, cross a fold on the way from the previous row, detach, stick; see
            `slowflow.averaged.checks.Spectrum`. Under a load, rows with different forcings take some tenths of a second
            each, at least two seconds in all, because the folds of intermediate forcings are needed.

        Raises
        ------
        ValueError
            For numbers <= 0 and for shapes that do not broadcast.
        """
        return self._system._composed("spectrum", Omega, F_0)
