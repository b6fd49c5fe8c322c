"""The questions about one oscillator: each stands here once, with what it takes and what is refused before any work.

A system answers it: averaging about the centre (`averaged.questions`), averaging with a mean displacement B
(`off_centre.questions`), or the second approximation (`second.questions`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, TypeVar

from slowflow import validate

if TYPE_CHECKING:
    from slowflow.certificate import ProvedFolds
    from slowflow.mechanism import Reals
    from slowflow.results import Detachment, Peak, SaddleNodeOnset

States = TypeVar("States")
Response = TypeVar("Response")
Folds = TypeVar("Folds")


class Questions(Generic[States, Response, Folds]):
    """What is asked of the averaged motions of one oscillator, dimensionless as in (4).

    F_0 is the amplitude of the excitation: a force over k_v L, the displacement of a base over L, or an unbalance over
    m L. A system answers each question by the method of the same name with an underscore. Its class says how complete
    its answers are.
    """

    @property
    def _system(self) -> Any:
        """What answers: itself, or of an oscillator under a load what knows its mean displacement."""
        return self

    def frequency_response(
        self, F_0: float, *, samples: int = 1000, Omega: tuple[float, float] = validate.WINDOW
    ) -> Response:
        """The response curve at F_0, every branch and isolated curve, for frequencies in the window `Omega` (24), (30).

        About `samples` points; folds, peaks and corners are among them exactly. Under a load each point has its mean
        displacement, `.B`; with an excitation by inertia the curve begins where the mass has begun to move then, or at
        2^-10 of the window's end. F_0 <= 4 mu/pi gives no point and a message.

        Raises ValueError for F_0 <= 0, samples < 2 or > 10^6, a window that is not 0 <= low < high <= 1e40, and under a
        load without damping that grows with the amplitude; ArithmeticError where it is undecided which states are on
        one curve.
        """
        F_0 = validate.number("F_0", F_0, above=0.0)
        samples, window = validate.curve(samples, Omega)
        found: Response = self._system._frequency_response(F_0, samples, window)
        return found

    def amplitudes(self, *, Omega: Reals, F_0: Reals) -> States:
        """Every steady state at the frequency Omega, or at each of an array of frequencies (24), (30).

        F_0 may be an array that broadcasts with Omega: then the points are the pairs, each a single tone. Flat arrays
        .Omega, .A, .phi, .stable, in the order of the points, then by rising A; under a load each has its mean
        displacement, `.B`. Where the force does not exceed 4 mu/pi friction holds the mass: A = 0 is a steady state,
        which transmits all that drives it, and on a base that shakes moves with it.

        Where doubles do not tell how many there are balls of more digits do, as for `saddle_nodes`, at 200 points at
        most; `.Omega_undecided` has the frequencies at which neither does.

        Raises ValueError for Omega <= 0 or > 1e40, for F_0 <= 0, for shapes that do not broadcast, and under a load
        without damping that grows with the amplitude.
        """
        system = self._system
        if not validate.is_single(F_0):
            pairs: States = system._at_pairs(Omega, F_0)
            return pairs
        at = validate.frequencies("Omega", Omega).ravel()
        found: States = system._amplitudes(at, validate.number("F_0", F_0, above=0.0))
        return found

    def saddle_nodes(self, F_0: float, *, certify: bool = False) -> Folds:
        """Every fold of the response curve at F_0, by rising Omega, of one Omega by rising A (24), (30).

        Under a load each has its mean displacement, `.B`, they are looked for up to the amplitude `A_max(F_0)` of
        `off_centre`, and there is no proof.

        Where doubles do not tell how many there are balls of more digits do, with python-flint
        (`pip install 'slowflow[proofs]'`), in hundredths of a second; `Remark.UNDECIDED` says where neither does.

        With `certify`, `.proof` holds an enclosure of each and whether there are proved to be no others; a proof that
        finds another number of folds than the answer has says so in its message.

        Raises ValueError for F_0 <= 0, where there is no proof to certify it, and under a load without damping that
        grows with the amplitude.
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
        """The lowest forcing F_SN that has a fold, wherever it lies, with its Omega and A (33).

        Where it lies on a corner that the truncation makes, `.untruncated` is the onset of the untruncated force. Where
        doubles do not tell which it is balls of more digits do, as for `saddle_nodes`, in some seconds; without
        python-flint that is refused.

        Under a load it is the lowest forcing for which a stable motion ends at a fold, with its mean displacement B:
        that none is below it is proved up to 2^-16 of F_SN; nearer to it, it is the least of its surroundings.

        Raises ArithmeticError where neither tells, and under a load ValueError without damping that grows with the
        amplitude.
        """
        found: SaddleNodeOnset = self._system._saddle_node_onset()
        return found

    def detachment(self) -> Detachment:
        """The lowest forcing F_cr that reaches u_cr, and its frequency Omega_cr (34).

        Under a load that for which the motion reaches the first breakpoint, |B| + A = u_cr, on either side, with A and
        B. Of a force that is not odd it is that which comes to an end of the piece about u = 0: to a stop, say.
        """
        found: Detachment = self._system._detachment()
        return found

    def peak(self, F_0: float) -> Peak:
        """The highest peak of the response at F_0, isolas included: .A .Omega.

        A peak is a top of the curve over Omega at which stable motions end, so that F of (24) rises with A there. Where
        the curve has none, as its amplitude only falls with Omega, it is the static amplitude, with Omega = 0.

        Where the spring gives way, as alpha u + beta u^3 with beta < 0 does at |u| = sqrt(-alpha/beta), it is the
        highest peak within the well: of motions that turn where the spring pulls back. Averaging has states beyond, the
        highest of them towards Omega = 0; none of these is stable, none is a peak, and `Remark.BEYOND_WELL` says that
        `amplitudes` and `frequency_response` have them.

        There is none, and `.message` says why, where the response passes the top of the well, so that it ends nowhere
        in it; without viscous damping; and where an excitation by inertia has a response that does not close, or whose
        amplitude only rises, towards F_0.

        Under a load it is the largest amplitude of motions with a positive mean stiffness, with its mean displacement
        `.B`, and the largest |u| = |B| + A of all of them, `.u_max` at `.Omega_max`: that none goes farther is proved
        but for 2^-24 of it, up to the amplitude `A_max(F_0)` of `off_centre`.

        Raises ValueError for F_0 <= 0, and under a load without damping that grows with the amplitude; ArithmeticError
        there where too many boxes stay undecided.
        """
        found: Peak = self._system._peak(validate.number("F_0", F_0, above=0.0))
        return found
