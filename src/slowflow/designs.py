"""Many oscillators, asked at three depths: in go arrays of numbers, out come averaged to exact answers of each design.

The averaged questions come from `slowflow.averaged.many`; the others are loaded when asked for, as are maps.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from slowflow import validate
from slowflow.averaged import many
from slowflow.loaded import off_centre_by
from slowflow.mechanism import Mechanism
from slowflow.model import THROUGHOUT
from slowflow_kernels.domains import EXCITATIONS, RUBS

if TYPE_CHECKING:
    from slowflow.exact.shocks_many import Shocks, Transients
    from slowflow.loads_many import ManyAtRest, ManyBands, ManyIsolations, ManyMargins, ManySpectra
    from slowflow.second.many import SecondDesigns


class Designs(many.Designs):
    """Arrays of designs of one mechanism, asked at three depths; see `slowflow.averaged.many`."""

    @cached_property
    def second_approximation(self) -> SecondDesigns:
        """The same questions with the higher harmonics of force and friction."""
        from slowflow.second.many import SecondDesigns

        self.only_for_plain_damping("second_approximation")
        return SecondDesigns(self)

    def at_rest(self, *, workers: int = 1) -> ManyAtRest:
        """What holds of each design whatever the forcing: frequency, friction's hold; see `Oscillator.at_rest`."""
        from slowflow import loads_many

        return loads_many.at_rest(self, workers)

    def margins(self, F_0: Any, *, workers: int = 1) -> ManyMargins:
        """How far F_0, which broadcasts with the designs, is from F_SN and F_cr of each; see `Oscillator.margins`."""
        from slowflow import loads_many

        return loads_many.margins(self, F_0, workers)

    def hysteresis(self, F_0: Any, *, places: int = 3, workers: int = 1) -> ManyBands:
        """Bands with several stable motions at F_0, of each design; `Status.TOO_MANY` where they exceed `places`."""
        from slowflow import loads_many

        return loads_many.hysteresis(self, F_0, places, workers)

    def isolation(self, F_0: Any, *, workers: int = 1) -> ManyIsolations:
        """The frequency from which on less than F_0 is transmitted, of each design; see `Oscillator.isolation`."""
        from slowflow import loads_many

        return loads_many.isolation(self, F_0, workers)

    def spectrum(self, *, Omega: Any, F_0: Any, workers: int = 1) -> ManySpectra:
        """A load spectrum, of each design, one tone at a time; see `Oscillator.spectrum`.

        The last axis of Omega and F_0, which broadcast, is that of the rows; what they have before it broadcasts with
        the designs. Answers have the axes of the designs, then that of the rows.
        """
        from slowflow import loads_many

        return loads_many.spectrum(self, Omega, F_0, workers)

    def transient(
        self,
        *,
        acceleration: Any,
        duration: Any = None,
        tau: Any = None,
        after: float | None = None,
        workers: int = 1,
    ) -> Transients:
        """What a shock of the base does to each design: .A .a_max .detaches .rests; see `Oscillator.transient`.

        Peak and duration of a half sine broadcast with the designs; of a record the last axis of `tau` and
        `acceleration` is that of its samples, and what they have before it broadcasts with the designs. Some thirty
        thousand designs in a second; `workers` as of all batches. Raises ValueError as `shock_spectrum`.
        """
        from slowflow.exact import shocks_many
        from slowflow.off_centre.questions import OffCentre

        return shocks_many.transients(self, acceleration, duration, tau, after, workers, off_centre=OffCentre)

    def shock_spectrum(self, *, acceleration: Any, duration: Any, workers: int = 1) -> Shocks:
        """What a half sine of the base does to each design: .A .a_max .ratio .detaches; both broadcast with these.

        As `transient`. Raises ValueError for what is no real array, for shapes that do not broadcast, and for
        structural damping. Designs with other laws of damping are followed one by one, in milliseconds each.
        """
        from slowflow.exact import shocks_many
        from slowflow.off_centre.questions import OffCentre

        return shocks_many.of_designs(self, acceleration, duration, workers, off_centre=OffCentre)


def designs_of(
    mechanism: Mechanism, values: dict[str, Any], laws: dict[str, Any], rubs: str, excitation: str, load: Any
) -> Any:
    """Many designs of a mechanism from their numbers by name; what maps need is loaded where a number is labelled.

    laws -- eta and c_2: a plain 0 is none, as of load
    """
    validate.excitation(excitation, tuple(EXCITATIONS))
    validate.choice("rubs", rubs, tuple(RUBS))
    values |= {name: value for name, value in laws.items() if not _is_none(value)}
    if not mechanism.odd or not _is_none(load):
        why = off_centre_by(mechanism, 0.0) or "load"
        validate.is_plain(why, "" if rubs == THROUGHOUT else f"rubs = {rubs!r}")
        values["load"] = load
    if any(validate.is_labelled(value) for value in values.values()):
        from slowflow.grid.designs import Grid

        return Grid(mechanism, values, excitation, rubs)
    if "load" in values:
        from slowflow.off_centre.many import OffCentreDesigns

        return OffCentreDesigns(mechanism, values, excitation)
    return Designs(mechanism, values, excitation, rubs)


def _is_none(value: Any) -> bool:
    """Whether it is a plain 0."""
    return type(value) in (int, float) and value == 0
