"""Functions of one oscillator that all averaged systems share.

The systems are averaging about the centre (`averaged.questions`), averaging with a mean displacement B
(`off_centre.questions`), and the second approximation (`second.questions`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, TypeVar

from slowflow.core import validate

if TYPE_CHECKING:
    from slowflow.answers.certificate import ProvedFolds
    from slowflow.answers.results import Detachment, Peak, SaddleNodeOnset
    from slowflow.core.mechanism import Reals

States = TypeVar("States")
Response = TypeVar("Response")
Folds = TypeVar("Folds")


@validate.methods_check_arguments()
class Questions(Generic[States, Response, Folds]):
    """The questions about the averaged motions of one oscillator, dimensionless as in (4).

    F_0 is the amplitude of the excitation: a force over k_v L, the displacement of a base over L, or an unbalance over
    m L. A system answers each question by the method of the same name with an underscore; its class documents how
    complete the answers are.
    """

    @property
    def _system(self) -> Any:
        """What answers: itself, or of an oscillator under a load what knows its mean displacement."""
        return self

    def frequency_response(
        self, F_0: float, *, samples: int = 1000, Omega: tuple[float, float] = validate.WINDOW
    ) -> Response:
        """Compute the response curve at one forcing, every branch and isolated curve.

        Its points satisfy (A Omega^2 + h)^2 + (2 zeta A Omega + 4 mu/pi)^2 = F_0^2 (24); stability follows from (30).

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.
        samples : int
            Approximate number of points, 2 to 10^6; folds, peaks and corners are among them exactly.
        Omega : tuple of float
            Window of frequencies, 0 <= low < high <= 1e40, over sqrt(k_v/m).

        Returns
        -------
        FrequencyResponse
            .Omega .A .phi .stable .branch .isola, shape (n,); under a load also the mean displacement .B. With base
            excitation or unbalance the curve begins where the mass begins to move, or at 2^-10 of the window's end. F_0
            <= 4 mu/pi gives no point and a message.

        Raises
        ------
        ValueError
            For an invalid number, and under a load if no damping grows with the amplitude.
        ArithmeticError
            If it is undecided which states belong to the same curve.
        """
        F_0 = validate.number("F_0", F_0, above=0.0)
        samples, window = validate.curve(samples, Omega)
        return self._system._frequency_response(F_0, samples, window)

    def amplitudes(self, *, Omega: Reals, F_0: Reals) -> States:
        """Find every steady state at one frequency or at each of an array of frequencies (24), (30).

        Parameters
        ----------
        Omega : array_like
            Frequencies, > 0 and <= 1e40, over sqrt(k_v/m).
        F_0 : array_like
            Amplitude of the excitation, > 0, dimensionless; an array that broadcasts with Omega makes pairs, each of
            which is a single tone.

        Returns
        -------
        SteadyStates
            .Omega .A .phi .stable, shape (n,), in the order of the points, then in ascending order of A; under a load
            also the mean displacement .B. Where the force does not exceed 4 mu/pi friction holds the mass: A = 0 is a
            steady state, which transmits the whole force, or moves with the base. Where double precision is
            inconclusive, ball arithmetic resolves the number of states, as for `saddle_nodes`, at 200 points at most;
            .Omega_undecided has the frequencies at which ball arithmetic is inconclusive too.

        Raises
        ------
        ValueError
            For a number that is not allowed, for shapes that do not broadcast, and under a load without damping that
            grows with the amplitude.
        """
        system = self._system
        if not validate.is_single(F_0):
            return system._at_pairs(Omega, F_0)
        at = validate.frequencies("Omega", Omega).ravel()
        return system._amplitudes(at, validate.number("F_0", F_0, above=0.0))

    def saddle_nodes(self, F_0: float, *, certify: bool = False) -> Folds:
        """Find every fold of the response curve at one forcing, in ascending order of Omega, then of A.

        At a fold F = 0 (24) and F_A = 0 (30): a stable and an unstable steady state merge, and a sweep jumps.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.
        certify : bool
            Whether to compute .proof: an enclosure of each fold, and whether it is proved that there are no others. Not
            under a load. If the proof finds a different number of folds, its message reports that.

        Returns
        -------
        SaddleNodes
            .Omega .A .kind .corner, shape (n,). Under a load also the mean displacement .B, and every fold up to the
            amplitude `A_max(F_0)` of `off_centre`. Where double precision is inconclusive, ball arithmetic resolves
            the number, in hundredths of a second, with python-flint (`pip install 'slowflow[proofs]'`);
            `Remark.UNDECIDED` marks a result for which it is inconclusive too.

        Raises
        ------
        ValueError
            For F_0 <= 0, with certify=True if no proof is available, and under a load without damping that grows with
            the amplitude.
        """
        system = self._system
        if certify:
            system._check_proof()
        found: Folds = system._saddle_nodes(validate.number("F_0", F_0, above=0.0))
        if certify:
            proof: ProvedFolds = system._proved_folds(found)
            found.__dict__["proof"] = proof
        return found

    def saddle_node_onset(self) -> SaddleNodeOnset:
        """Find the lowest forcing F_SN that has a fold, with its Omega and A (33).

        Returns
        -------
        SaddleNodeOnset
            .F_SN .Omega .A .kind; `.untruncated` is the onset of the untruncated force if the onset lies on a corner
            due to the truncation alone. Where double precision is inconclusive, ball arithmetic resolves it, as for
            `saddle_nodes`, in some seconds. Under a load it is the lowest forcing for which a stable motion ends at a
            fold, with its mean displacement .B; it is proved that there is none below (1 - 2^-16) F_SN, and F_SN is a
            local minimum.

        Raises
        ------
        ArithmeticError
            If it is undecided, or if python-flint, which is not installed, is needed to resolve it.
        ValueError
            Under a load if no damping grows with the amplitude.
        """
        return self._system._saddle_node_onset()

    def detachment(self) -> Detachment:
        """Find the lowest forcing F_cr whose response reaches u_cr, where the springs detach (34).

        Returns
        -------
        Detachment
            .F_cr .Omega_cr .u_cr. Under a load it is the lowest forcing whose motion reaches the first breakpoint, |B|
            + A = u_cr, on either side, with .A and .B; under an asymmetric force, the lowest forcing whose motion
            reaches an end of the piece about u = 0, such as a stop.
        """
        return self._system._detachment()

    def peak(self, F_0: float) -> Peak:
        """Find the highest peak of the response at one forcing, isolated curves included.

        A peak is a maximum of A over Omega on a stable branch, where F of (24) increases with A. If there is none
        because A decreases with Omega throughout, the static amplitude at Omega = 0 is returned.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.

        Returns
        -------
        Peak
            .A .Omega; None and a message if there is no viscous damping, if the response passes the top of a potential
            well, or if the response to base excitation or unbalance has no peak: it is unbounded, or its amplitude
            increases towards F_0 throughout. For a softening spring with a potential well, such as alpha u + beta u^3
            with beta < 0, whose top is at |u| = sqrt(-alpha/beta), it is the highest peak of motions that turn within
            the well. Averaging also has states beyond the well, all of them unstable; `Remark.BEYOND_WELL` marks
            `amplitudes` and `frequency_response` that contain them. Under a load, motions with a positive mean
            stiffness count: .A is their largest amplitude, with the mean .B, and .u_max at .Omega_max their largest |u|
            = |B| + A. It is proved, up to the amplitude `A_max(F_0)` of `off_centre`, that no motion exceeds these by
            more than a relative 2^-24.

        Raises
        ------
        ValueError
            For F_0 <= 0, and under a load if no damping grows with the amplitude.
        ArithmeticError
            Under a load, if too many boxes stay undecided.
        """
        return self._system._peak(validate.number("F_0", F_0, above=0.0))
