"""Batches of mounts in SI units, made from arrays of their parameters.

Arguments have the names that a single mount uses; results are in SI units.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from operator import attrgetter
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Generic

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import frozen, same
from slowflow.answers.gradient import Gradient
from slowflow.answers.quantities import BASE, LETTERS, SHEET, SI, ManyScales, Quantities, Scales, si
from slowflow.answers.table import QUANTITIES, QUESTIONS, Found, ManyQuestions, Question
from slowflow.averaged.batches import Batch, in_dataset, in_rows, spanned
from slowflow.core import validate
from slowflow.core.mechanism import Floats
from slowflow.oscillators import range_checks
from slowflow.oscillators.arguments import PLAIN, REMARKS, TakesAmplitude, density, window
from slowflow.support.immutable import Unchanging

if TYPE_CHECKING:
    from typing import Protocol, Self, Unpack

    import xarray
    from matplotlib.axes import Axes

    from slowflow.answers.physical_answers import Amplitude, Many
    from slowflow.answers.quantities import Number, Numbers, Window
    from slowflow.grid.many import Designs
    from slowflow.oscillators.measurements import Columns
    from slowflow.second.many import SecondDesigns

    # the questions as a type checker knows them, by their arguments: `_method` makes them of the table
    #: the amplitude of the excitation, by its letter
    At = Amplitude[Numbers]

    class OfMounts(Protocol[Found]):
        def __call__(self, *, workers: int = 1) -> Found: ...

    class Several(Protocol[Found]):
        def __call__(self, *, max_count: int = ..., workers: int = 1) -> Found: ...

    class AtAmplitudes(Protocol[Found]):
        def __call__(self, amplitude: Numbers | None = None, /, *, workers: int = 1, **at: Unpack[At]) -> Found: ...

    class SeveralAtAmplitudes(Protocol[Found]):
        def __call__(
            self, amplitude: Numbers | None = None, /, *, max_count: int = ..., workers: int = 1, **at: Unpack[At]
        ) -> Found: ...

    class Levels(Protocol[Found]):
        def __call__(
            self,
            amplitude: Numbers | None = None,
            /,
            *,
            level_dB: Numbers | None = None,
            workers: int = 1,
            **at: Unpack[At],
        ) -> Found: ...

    class Proofs(Protocol[Found]):
        def __call__(
            self, amplitude: Numbers | None = None, /, *, f: Numbers | None = None, workers: int = 1, **at: Unpack[At]
        ) -> Found: ...

    class Curves(Protocol[Found]):
        def __call__(
            self,
            amplitude: Numbers | None = None,
            /,
            *,
            f: Window | None = None,
            samples: int = 1000,
            max_count: int = 6,
            workers: int = 1,
            **at: Unpack[At],
        ) -> Found: ...

    class AtTones(Protocol[Found]):
        def __call__(self, *, f: Numbers, workers: int = 1, **at: Unpack[At]) -> Found: ...

    class SeveralAtTones(Protocol[Found]):
        def __call__(self, *, f: Numbers, max_count: int = ..., workers: int = 1, **at: Unpack[At]) -> Found: ...

    class Records(Protocol[Found]):
        def __call__(
            self,
            *,
            acceleration: Numbers,
            duration: Numbers | None = None,
            t: Numbers | None = None,
            after: Number | None = None,
            workers: int = 1,
        ) -> Found: ...

    class Pulses(Protocol[Found]):
        def __call__(self, *, acceleration: Numbers, duration: Numbers, workers: int = 1) -> Found: ...

    class Vibration(Protocol[Found]):
        def __call__(
            self, *, psd: tuple[Numbers, Numbers] | Columns, unit: str = "g^2/Hz", max_count: int = 3, workers: int = 1
        ) -> Found: ...

else:  # whose columns are read by name
    Many = object

#: data that are the same for all mounts
SETTINGS = ("mounts", "contact", "force", "excitation")
#: dimensionless names in docstrings, as they are in SI units
IN_SI = {"F_0": "F", **{plain: shown for shown, plain in PLAIN.items()}}
#: a density that has no customary unit
WHITE_NOISE = "S_0"
#: of a batch's answers in SI units what is computed when it is read, and has no unit
WHEN_READ = ("phi", "transmissibility", "transmissibility_dB")


@dataclasses.dataclass(frozen=True, eq=False)
class ManyQuantities(Quantities, Many):
    """The answer to one question about many mounts in SI units; its columns are attributes of the mounts' shape.

    answer  -- the dimensionless `Batch`
    numbers -- the data of the mounts and the arguments of the question, arrays by name

    Columns with an additional axis, of entries, points or rows, and statuses are those of the `Batch`.
    """

    answer: Batch
    numbers: Mapping[str, npt.NDArray[Any]] = dataclasses.field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        self.__dict__.update(numbers=MappingProxyType(dict(self.numbers)), has_rows=True)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            return getattr(self.answer, name) if name in WHEN_READ else super().__getattr__(name)

    @property
    def remarks(self) -> npt.NDArray[np.uint16]:
        """Diagnostics of each mount's answer, flags of `slowflow.Remark` combined by bitwise or."""
        return np.asarray(self.answer.remarks)

    @property
    def untruncated(self) -> Floats:
        """The onset of the untruncated force where the onset lies on a corner due to the truncation alone; else NaN."""
        assert self.scales is not None
        return np.asarray(self.answer.untruncated * self.scales.sizes[self.scales.amplitude])

    @property
    def inner(self) -> Mapping[str, str]:
        """Which columns have an additional axis after those of the mounts, and its name."""
        return {self._shown(name): axis for name, axis in self.answer.inner.items()}

    def _shown(self, name: str) -> str:
        assert self.scales is not None
        return self.scales.symbol(name)

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """A row for each mount, or for each point of its curve: its data, then the numbers of the answer."""
        return in_rows(self.numbers, self.values, self.inner)

    def about(self) -> dict[str, Any]:
        """Return the mechanism and the shape of the mounts."""
        return dict(self.answer.about())

    def to_xarray(self) -> xarray.Dataset:
        """Make a Dataset with dimensions "design_0" and so on and units; data and arguments are coordinates."""
        return in_dataset(self.numbers, self.values, self.inner, self._units(), self.about())

    def units_of_columns(self) -> Mapping[str, str]:
        """Units of the columns, by name; entries of one column are numbered."""
        found, inner = self._units(), self.inner
        for name in self.units.keys() & inner.keys():
            if inner[name] == "place":
                found |= {f"{name}_{k}": found[name] for k in range(self.values[name].shape[-1])}
        return found

    def _units(self) -> dict[str, str]:
        """Of the columns, the data and the arguments."""
        assert self.scales is not None
        of_arguments = {self._shown(name): SI.get(self.scales.kind(name)[1], "") for name in self.answer.arguments}
        found = {name: SHEET.get(name, "") for name in self.numbers} | of_arguments
        return {name: unit for name, unit in (found | dict(self.units)).items() if unit}

    def gradient(self) -> Gradient:
        """Differentiate the numbers of each mount's answer with respect to its data, in SI units.

        `.slopes` have shape (..., numbers, parameters), after the shape of the columns. Raises ValueError as `gradient`
        of a single mount's answer.
        """
        assert isinstance(self.scales, ManyScales)
        found = self.answer.gradient()
        scales = self.scales.by_entry if found.status.ndim > np.ndim(self.status) else self.scales
        return scales.gradient(found)

    def plot_map(self, x: str, y: str, of: str, ax: Axes | None = None) -> Axes:
        """Plot a number of each mount over two of the data, in SI units; see `Batch.plot_map`."""
        from slowflow.answers import pictures

        known = tuple(name for name, value in self.values.items() if value.dtype == float)
        values = self.values[validate.choice("of", of, known)]
        return pictures.design_map(ax, *spanned(self.numbers, x, y, of, values))


class PhysicalQuestions(TakesAmplitude, Generic[Found]):
    """The questions about many mounts in SI units, with arrays as arguments."""

    detachment: OfMounts[Found]
    """Find the lowest forcing whose response reaches x_cr (34)."""
    saddle_node_onset: OfMounts[Found]
    """Find the lowest forcing that has a fold (33)."""
    at_rest: OfMounts[Found]
    """Compute data that do not depend on the forcing."""
    rest: Several[Found]
    """Find every equilibrium under a load, sorted by x."""
    saddle_nodes: SeveralAtAmplitudes[Found]
    """Find every fold at F (24), (30), sorted by f."""
    hysteresis: SeveralAtAmplitudes[Found]
    """Find the bands of f with several stable motions at F."""
    peak: AtAmplitudes[Found]
    """Find the highest peak at F, isolas included."""
    margins: AtAmplitudes[Found]
    """Compare F with F_SN and F_cr."""
    isolation: Levels[Found]
    """Find the frequency above which less than F, or a given fraction of it, is transmitted."""
    certify: Proofs[Found]
    """Prove the number of folds at F, or of states at (f, F), about the centre."""
    frequency_response: Curves[Found]
    """Compute the response curve at F (24), (30), with every fold."""
    amplitudes: SeveralAtTones[Found]
    """Find every steady state at (f, F) (24), (30), sorted by A."""
    spectrum: AtTones[Found]
    """Evaluate a load spectrum, one tone at a time."""
    transient: Records[Found]
    """Integrate the response to a shock of the base."""
    shock_spectrum: Pulses[Found]
    """Compute the shock response spectrum of half sines."""
    random: Vibration[Found]
    """Find stationary random vibration."""

    if TYPE_CHECKING:

        def _ask(self, question: str, /, **arguments: Any) -> Found:
            """The answer to a question, from arguments named as in the table, in SI units."""

    def _bound(self, question: str, /, *arguments: Any, **named: Any) -> tuple[Self, dict[str, Any]]:
        """The mounts with this excitation, and the arguments of a question, named as in the table."""
        signature = _signature(question)
        letters = LETTERS if "at" in signature.parameters else ()
        (own := validate.bound(question, signature, (self, *arguments), named, *letters)).apply_defaults()
        known = {PLAIN.get(name, name): value for name, value in own.arguments.items() if value is not None}
        mounts, amplitude, at = known.pop("self"), known.pop("amplitude", None), known.pop("at", None)
        if at is not None:
            mounts, known["F_0"] = mounts._excited(amplitude, at)
        if "psd" in known:
            known["psd"] = known["psd"], known.pop("unit")
        return mounts, known


class PhysicalDesigns(PhysicalQuestions[ManyQuantities], Unchanging):
    """Many mounts in SI units: data and arguments are arrays that broadcast, answers are `ManyQuantities`.

    Made by `mount.many(k_h=..., m=...)`. The questions are those of `Isolator.many`, with the arguments of a mount,
    each a number or an array, and with the options of a batch:

    max_count -- largest number of entries per mount, along an additional axis
    workers   -- threads that share the mounts, -1 for one per processor

    A mount without a result raises nothing: `.status` has the reason. Mounts of different m, k_v or L are evaluated
    one after another if they share a window of frequencies, a spectral density or a duration in seconds.

    values -- the data of the mounts by name, in SI units
    """

    values: Mapping[str, Any]
    _settings: Mapping[str, Any]
    second: bool
    _kind: Any

    def __init__(self, kind: Any, sheet: Mapping[str, Any], second: bool = False) -> None:
        known = {name: value for name, value in sheet.items() if value is not None}
        if "static_friction" in known:
            raise validate.NotAvailable(
                "static_friction is not available for many mounts: only exact motions of a single one use it"
            )
        settings = {name: known.pop(name) for name in SETTINGS if name in known}
        validate.count("mounts", settings.get("mounts", 1), least=1)
        values = {name: si(name, value, SHEET[name]) for name, value in known.items()}
        values = {name: _array(name, value) for name, value in values.items()}
        validate.common_shape(values)
        self.__dict__.update(_kind=kind, values=values, _settings=settings, second=second)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, PhysicalDesigns):
            return NotImplemented
        settings = attrgetter("_kind", "_settings", "second")
        return settings(self) == settings(other) and same(self.values, other.values)

    def __hash__(self) -> int:
        return hash((self._kind, self.second, *self._settings.items(), *sorted(self.values)))

    @functools.cached_property
    def dimensionless(self) -> tuple[ManyScales, dict[str, Any]]:
        """The scales, and the dimensionless numbers of the designs by name."""
        settings = {name: word for name, word in self._settings.items() if name in ("mounts", "excitation")}
        damping = "c" if "c" in self.values else "zeta"
        # under a load m is no scale: it must be a mass all the same
        sheet = {**self.values, "m": np.where(self.values["m"] > 0, self.values["m"], np.nan)}
        found: tuple[ManyScales, dict[str, Any]] = self._kind._of_sheet(sheet, ManyScales, damping=damping, **settings)
        return found

    @property
    def scales(self) -> ManyScales:
        """The scales that make numbers dimensionless (4), arrays: NaN where m, k_v or L is not > 0."""
        return self.dimensionless[0]

    @functools.cached_property
    def designs(self) -> Designs | SecondDesigns:
        """The dimensionless designs."""
        scales, numbers = self.dimensionless
        settings = {name: word for name, word in self._settings.items() if name in ("contact", "force")}
        found: Designs = self._kind.many(**numbers, **settings, excitation=scales.of_oscillator)
        return found.second_approximation if self.second else found

    def _range_checks(self) -> Iterator[str]:
        """Remarks on data that look as if they were in another unit, of isolators."""
        if "k_h" in self.values:
            zeta = self.dimensionless[1]["zeta"]
            yield from range_checks.of_mount(self.values, zeta, self._settings.get("mounts", 1))

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the mounts, to which the data broadcast."""
        return validate.common_shape(dict(self.values))

    def _with_values(self, values: Mapping[str, Any]) -> PhysicalDesigns:
        """The same kind of mounts with other data."""
        return PhysicalDesigns(self._kind, {**values, **self._settings}, self.second)

    @property
    def second_approximation(self) -> PhysicalDesigns:
        """The same questions with the higher harmonics of force and friction."""
        return PhysicalDesigns(self._kind, {**self.values, **self._settings}, second=True)

    @functools.cached_property
    def _by_other_base(self) -> PhysicalDesigns:
        sheet = {**self.values, **self._settings, "excitation": self._other_base}
        return PhysicalDesigns(self._kind, sheet, self.second)

    def _ask(self, question: str, /, **arguments: Any) -> ManyQuantities:
        arguments = {name: value for name, value in arguments.items() if value is not None}
        row = QUESTIONS[question]
        with self.scales.in_these_terms():
            method = getattr(self.designs, question)  # or the reason why there is none
            one = self._one_scale() if any(_is_of_all(row, name) for name in arguments) else self.scales
            if one is None:
                return self._quantities(self._by_scale(row, arguments), arguments)
            at = {name: self._plain(row, name, arguments, one) for name in arguments}
            return self._quantities(method(**at), arguments)

    def _one_scale(self) -> Scales | None:
        """The scales of all mounts; None where these differ."""
        base = np.array([getattr(self.scales, name) for name in BASE]).reshape(len(BASE), -1)
        allowed = base[:, ~np.isnan(base).any(axis=0)]
        if allowed.size and (allowed != allowed[:, :1]).any():
            return None
        of_each = allowed[:, 0].tolist() if allowed.size else [1.0] * len(BASE)
        return Scales(**dict(zip(BASE, of_each, strict=True)), excitation=self.scales.excitation)

    def _plain(self, row: Question, name: str, arguments: Mapping[str, Any], one: Scales) -> Any:
        """An argument, made dimensionless; by the scales of one mount where it is that of all."""
        value, (shown, kind) = arguments[name], self.scales.kind(name)
        if _is_of_all(row, name):
            if name == "psd":
                return density(one, *value)[1]
            return window(one, value) if kind == "frequency" else si(shown, value, SI[kind]) / one.sizes[kind]
        if not kind:
            return value
        axis = row.argument_axes.get(name)
        scales = self.scales.by_entry if axis == "row" or (axis and "tau" in arguments) else self.scales
        array, sizes = self._in_si(name, value), scales.sizes
        validate.common_shape({"mounts": np.asarray(sizes[kind]), shown: array})
        with np.errstate(all="ignore"):
            found = array / sizes[kind]
        if shown in REMARKS:
            range_checks.warn(REMARKS[shown](array, sizes["frequency"]))
        return found

    def _in_si(self, name: str, value: Any) -> npt.NDArray[Any]:
        """Values of an argument, in SI units."""
        shown, kind = self.scales.kind(name)
        return _array(shown, si(shown, value, SI[kind]) if kind else value)

    def _by_scale(self, row: Question, arguments: Mapping[str, Any]) -> Batch:
        """The answers of the mounts of each scale, where an argument is that of all of them in SI units."""
        own = [name for name in arguments if name in (*row.takes, *row.may)]
        records = {name for name in own if "tau" in arguments and name in row.argument_axes}
        values = {**self.values, **{name: self._in_si(name, arguments[name]) for name in own}}
        shape = validate.common_shape({name: one[..., 0] if name in records else one for name, one in values.items()})
        rows = {
            name: np.broadcast_to(one, (*shape, *one.shape[-1:]) if name in records else shape)
            for name, one in values.items()
        }
        base = np.stack([np.broadcast_to(getattr(self.scales, name), shape).ravel() for name in BASE], axis=-1)
        _, scale = np.unique(np.nan_to_num(base), axis=0, return_inverse=True)
        order = np.argsort(scale.ravel(), kind="stable")
        columns: dict[str, Any] = {}
        for some in np.split(order, np.flatnonzero(np.diff(scale.ravel()[order])) + 1):
            at = np.unravel_index(some, shape)
            mounts = self._with_values({name: rows[name][at] for name in self.values})
            found = mounts._ask(row.name, **{**arguments, **{name: rows[name][at] for name in own}}).answer
            for name, column in {**found._values, "remarks": found.remarks}.items():
                columns.setdefault(name, np.empty((*shape, *column.shape[1:]), column.dtype))[at] = column
        remarks, designs = columns.pop("remarks"), getattr(self.designs, "first", self.designs)
        plain = {name: self._plain(row, name, arguments, self.scales) for name in found.arguments}
        answer: Batch = type(found)(row.name, columns, designs, plain, found.system, remarks=remarks)
        return answer

    def _quantities(self, answer: Batch, arguments: Mapping[str, Any]) -> ManyQuantities:
        """A dimensionless answer in SI units."""
        scales, inner, values, units = self.scales, answer.inner, {}, {}
        for name, column in answer._values.items():
            shown, kind = scales.kind(name)
            values[shown] = column
            if kind:
                sizes = (scales.by_entry if name in inner else scales).sizes
                values[shown], units[shown] = frozen(column * sizes[kind]), SI[kind]
        lift: Any = (..., np.newaxis) if "row" in inner.values() else ...
        numbers = {name: value[lift] for name, value in self.values.items()}
        for name in answer.arguments:
            numbers[scales.symbol(name)] = self._in_si(name, arguments[name])
        return ManyQuantities(values, units, answer, scales=scales, numbers=numbers)


def _array(name: str, value: Any) -> npt.NDArray[Any]:
    """Numbers of any shape, as they are."""
    if validate.is_labelled(value):
        raise validate.NotAvailable(
            f"{name} has named axes, or is divided into blocks: at least one of the data in `mount.many` must too"
        )
    return validate.real_array(name, value)


def _is_of_all(row: Question, name: str) -> bool:
    """Whether an argument with a unit is the same for all mounts, as a window of frequencies is."""
    return name in row.options and (name == "psd" or (name in QUANTITIES and QUANTITIES[name].kind != ""))


def _with_unit(name: str) -> str:
    """A column as docstrings list it."""
    column = QUANTITIES[name]
    unit = SI.get("force" if column.kind == "amplitude" else column.kind, "")
    return f".{column.si or name} in {unit}" if unit else f".{column.si or name}"


@functools.cache
def _signature(name: str) -> inspect.Signature:
    """Of a question: that about dimensionless designs, with the names of arguments that a mount has."""
    first, *others = inspect.signature(getattr(ManyQuestions, name)).parameters.values()
    own, letters = [first.replace(kind=first.POSITIONAL_ONLY)], []
    for one in others:
        if one.name == "F_0":
            letters = [inspect.Parameter("at", inspect.Parameter.VAR_KEYWORD, annotation="Numbers")]
            if one.kind is one.POSITIONAL_OR_KEYWORD:
                own.append(
                    one.replace(name="amplitude", kind=one.POSITIONAL_ONLY, default=None, annotation="Numbers | None")
                )
        elif one.name == "psd":
            own.append(one.replace(default=one.empty, annotation="tuple[Numbers, Numbers] | Columns"))
            own.append(one.replace(name="unit", default="g^2/Hz", annotation="str"))
        elif one.name != WHITE_NOISE:
            one = one.replace(annotation=one.annotation.replace("Arrays", "Numbers"))
            if shown := QUANTITIES[one.name].si if one.name in QUANTITIES else "":
                one = one.replace(name=shown, default=one.empty if one.default is one.empty else None)
            own.append(one)
    return inspect.Signature([*own, *letters], return_annotation="ManyQuantities")


def _method(name: str) -> Callable[..., Any]:
    """The method of a question."""

    def ask(self: PhysicalQuestions[Found], /, *arguments: Any, **named: Any) -> Found:
        mounts, known = self._bound(name, *arguments, **named)
        return mounts._ask(name, **known)

    of_designs = getattr(ManyQuestions, name)
    functools.update_wrapper(ask, of_designs)
    columns = dict.fromkeys(one for of_system in QUESTIONS[name].columns.values() for one in of_system)
    summary, _, _ = (of_designs.__doc__ or "").partition(": .")
    in_si = re.sub(r"\w+", lambda word: IN_SI.get(word[0], word[0]), summary)
    ask.__doc__ = f"{in_si}: {', '.join(map(_with_unit, columns))}."
    ask.__qualname__ = f"{PhysicalQuestions.__qualname__}.{name}"
    ask.__dict__["__signature__"] = _signature(name)
    return ask


for _name in QUESTIONS:
    setattr(PhysicalQuestions, _name, _method(_name))
