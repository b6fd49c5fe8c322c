"""Arguments in SI units. Takes numbers of a mount or of many, and their scales; returns dimensionless ones."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from slowflow.answers.quantities import DENSITIES, EXCITED, OF_A_BASE, SI, Scales, si
from slowflow.answers.table import QUANTITIES
from slowflow.core import validate
from slowflow.core.mechanism import Floats
from slowflow.oscillators import range_checks
from slowflow.oscillators.measurements import Columns
from slowflow.support.errors import Refused, WrongType

#: dimensionless names by those in SI units, where these differ
PLAIN = {column.si: column.name for column in QUANTITIES.values() if column.si}
#: warnings of numbers that look as if they were in another unit
REMARKS = {"f": range_checks.of_frequency, "duration": range_checks.of_duration}


def window_in_hertz(f: Any) -> tuple[float, float]:
    """A window of frequencies in Hz."""
    low, high = validate.pair("f", f, "of frequencies (low, high)")
    return validate.window("f", (si("f[0]", low, "Hz"), si("f[1]", high, "Hz")))


def window(scales: Scales, f: Any) -> tuple[float, float]:
    """Make a window of frequencies dimensionless."""
    low, high = window_in_hertz(f)
    return low / scales.sizes["frequency"], high / scales.sizes["frequency"]


def measured_density(psd: Any, unit: str) -> tuple[tuple[Floats, Floats], str]:
    """The frequencies of a spectral density in Hz and its values, and their unit."""
    if isinstance(psd, Columns):
        if missing := {"f", "G"} - psd.keys():
            raise Refused(f"psd needs the columns f and G: {min(missing)} is missing")
        unit, psd = psd.units.get("G", unit), (psd["f"], psd["G"])
    validate.choice("unit", unit, tuple(DENSITIES))
    f, G = validate.two_rows("psd", psd, "frequencies in Hz and densities")
    return (validate.positive_array("f", si("f", f, "Hz")), validate.positive_array("G", G)), unit


def density(scales: Scales, psd: Any, unit: str) -> tuple[str, tuple[Floats, Floats]]:
    """The excitation that a spectral density is of, and it made dimensionless, its frequencies too."""
    (f, G), unit = measured_density(psd, unit)
    of_unit, kind = DENSITIES[unit]
    sizes = scales.sizes
    return kind, (f / sizes["frequency"], G * (of_unit / sizes[kind]) ** 2 * sizes["frequency"])


class TakesAmplitude:
    """In SI units: the amplitude of the excitation is given once, first or by its letter."""

    scales: Any
    _by_other_base: Any

    @property
    def _other_base(self) -> str:
        """The other kind of base excitation: by acceleration in place of displacement, or the other way round."""
        return next(one for one in OF_A_BASE if one != self.scales.excitation)

    def _excited(self, amplitude: Any, at: Mapping[str, Any]) -> tuple[Any, Any]:
        """The mount whose excitation an amplitude is of, and that amplitude; base excitation takes a or Y."""
        if amplitude is not None and not at:
            return self, amplitude
        own = self.scales.excitation
        allowed = OF_A_BASE if own in OF_A_BASE else (own,)
        for one in allowed:
            if amplitude is None and at.keys() == {letter := EXCITED[one][0]}:
                return (self if one == own else self._by_other_base), at[letter]
        known = " or ".join(f"{letter} in {SI[kind]}" for letter, kind in map(EXCITED.__getitem__, allowed))
        found = ", ".join((*([] if amplitude is None else [EXCITED[own][0]]), *at)) or "none"
        raise WrongType(f"the amplitude of the excitation is needed once, {known}: got {found}")
