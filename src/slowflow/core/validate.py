"""The boundary. Takes a user's values; returns floats or arrays of floats, or a ValueError that names what is wrong.

Nothing a user gives is parsed or evaluated: numbers are taken as numbers, anything else is refused.
"""

from __future__ import annotations

import functools
import inspect
import math
import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from numbers import Real
from typing import Any, ParamSpec, TypeGuard, TypeVar

import numpy as np
import numpy.typing as npt

from slowflow.core.mechanism import Floats, Parameter
from slowflow.support.errors import Refused, WrongType
from slowflow.support.text import text, together
from slowflow_kernels.conventions import HIGHEST_OMEGA

P = ParamSpec("P")
R = TypeVar("R")
Kind = TypeVar("Kind", bound=type)
#: frequencies shown unless others are asked for
WINDOW = (0.0, 2.0)
OF_CONSTANT = "a base whose acceleration has a constant amplitude a is a force, {F_0 = m a/(k_v L)|F = m a}"
#: what a window is
LOW_AND_HIGH = "(low, high) with 0 <= low < high"
#: the most points that are asked for
MOST_SAMPLES = 10**6


class NotAvailable(Refused):
    """A question that an oscillator has no answer to yet, though another might: with a message."""


class NoAttribute(NotAvailable, AttributeError):
    """The same, of a question that is no attribute then: `hasattr` says so."""


def _refuse(name: str, value: Any, allowed: str) -> ValueError:
    value = value.item() if isinstance(value, np.generic) else value  # as it is written, without its type
    of, index = _symbol(name)
    return Refused(
        text(f"{{{of}}}{index} = {{{of}:r}} is not allowed: {{{of}}}{index} must be {{allowed:s}}", value, allowed)
    )


def _symbol(name: str) -> tuple[str, str]:
    """The name of a quantity, and which of several it is, in brackets."""
    of, bracket, index = name.partition("[")
    return of, bracket + index


def number(
    name: str,
    value: Any,
    *,
    above: float = -math.inf,
    least: float = -math.inf,
    below: float = math.inf,
    most: float = math.inf,
) -> float:
    """A finite real number in the given range, as a float."""
    _is_not_masked(name, value)
    try:
        result = float(value) if _is_number(value) else math.nan
    except OverflowError:
        result = math.inf
    if not (math.isfinite(result) and above < result < below and least <= result <= most):
        raise _refuse(name, value, _range(name, above, least, below, most))
    return result


def is_single(value: Any) -> TypeGuard[float]:
    """Whether a value is meant as one number, not as an array of them; not yet whether it is allowed."""
    return not isinstance(value, (list, tuple)) and getattr(value, "ndim", 0) == 0


def is_zero(value: Any) -> bool:
    """Whether a value is a plain 0, which of a damping law or of a load means that there is none."""
    return type(value) in (int, float, np.float64) and value == 0


def _is_number(value: Any) -> bool:
    if isinstance(value, (bool, np.bool_)):
        return False
    if isinstance(value, (float, int, Real, np.floating, np.integer)):
        return True
    return isinstance(value, np.ndarray) and value.ndim == 0 and value.dtype.kind in "fiu"


def _is_not_masked(name: str, value: Any) -> None:
    """What a mask hides was marked as wrong: it is no number to compute with."""
    # an array first: numpy.ma is imported when it is asked for
    if isinstance(value, np.ndarray) and isinstance(value, np.ma.MaskedArray) and np.ma.getmaskarray(value).any():
        of, index = _symbol(name)
        masked = int(np.ma.getmaskarray(value).sum())
        raise Refused(text(f"{{{of}}}{index} is not allowed: {{masked:d}} of its numbers are masked", masked))


def _range(name: str, above: float, least: float, below: float, most: float) -> str:
    limits = [
        _limit(name, sign, limit)
        for sign, limit in ((">", above), (">=", least), ("<", below), ("<=", most))
        if math.isfinite(limit)
    ]
    return "a finite real number" + (" " + together(" and ", tuple(limits)) if limits else "")


def _limit(name: str, sign: str, limit: float) -> str:
    """A bound of a quantity; 0 is the same in all units."""
    return text(f"{sign} {{{_symbol(name)[0]}:g}}", limit) if limit else f"{sign} 0"


def within(domain: Parameter, value: Any) -> float:
    """A finite real number in a parameter's domain, as a float."""
    if type(value) is float and domain.holds(value):
        return value
    return number(domain.name, value, **domain.bounds)


def count(name: str, value: Any, *, least: int, most: int | None = None) -> int:
    """An integer of at least `least` and at most `most`."""
    whole = isinstance(value, (int, np.integer)) and not isinstance(value, (bool, np.bool_))
    if not whole or value < least or (most is not None and value > most):
        raise _refuse(name, value, f"an integer >= {least}" + ("" if most is None else f" and <= {most}"))
    return int(value)


def workers(value: Any) -> int:
    """How many threads: an integer >= 1, or -1 for one for each processor; no map-like callable, as SciPy has it."""
    if callable(value):
        raise Refused(
            f"workers = {value!r} is not allowed: threads write into shared arrays, which a map over processes "
            "cannot; workers must be an integer >= 1 or -1, and a map by blocks, .store(...), is for clusters"
        )
    return os.cpu_count() or 1 if value == -1 else count("workers", value, least=1)


def has_proof(excitation: str, laws: str) -> None:
    """NotAvailable where no proof is derived: of another excitation than a force, and with other laws of damping."""
    if excitation != "force":
        raise NotAvailable(f"certify is not available with excitation = {excitation!r}, only with 'force'")
    is_plain("certify", laws)


def is_in_time(question: str, laws: Iterable[str]) -> None:
    """NotAvailable where a question about motions without a frequency is asked of structural damping."""
    if "eta" in laws:
        raise NotAvailable(
            f"{question} is not available with eta: structural damping is defined at one frequency; replace it by "
            "viscous damping that equals it at the resonance"
        )


def is_plain(question: str, laws: str, *allowed: str) -> None:
    """NotAvailable where a question is asked of an oscillator with other laws of damping, which are named.

    allowed -- laws that may be present beside mu and zeta
    """
    if laws:
        *others, last = "{mu}", "zeta", *(f"{{{law}}}" for law in allowed)
        known = f"{', '.join(others)} and {last}"
        raise NotAvailable(text(f"{{question:s}} is not available with {{laws:s}}, only with {known}", question, laws))


def choice(name: str, value: Any, allowed: tuple[str, ...]) -> str:
    """One of the words allowed."""
    if not isinstance(value, str) or value not in allowed:
        raise _refuse(name, value, " or ".join(map(repr, allowed)) + meant(value, allowed))
    return value


def excitation(value: Any, allowed: tuple[str, ...]) -> str:
    """What F_0 is the amplitude of, one of the words allowed; for an acceleration the message names what to use."""
    if isinstance(value, str) and value not in allowed:  # no nearest word: "floor" is not "force"
        meaning = "'base' is a floor or support that moves, 'unbalance' a rotating mass"
        advice = text(OF_CONSTANT) if "acceleration" in value.lower() else meaning
        raise _refuse("excitation", value, " or ".join(map(repr, allowed)) + "; " + advice)
    return choice("excitation", value, allowed)


def meant(word: Any, known: Iterable[str]) -> str:
    """The known word that is nearest to another one, as the end of a sentence; empty where none is near.

    A known letter with an index that is not known, as eta_2, is another quantity: no word is near to that.
    """
    if not isinstance(word, str):
        return ""
    import difflib  # for mistakes only: it takes a millisecond to load

    folded = {one.lower(): one for one in known}
    if "_" in word and word.lower() not in folded and word.partition("_")[0].lower() in folded:
        return ""
    near = [folded[one] for one in difflib.get_close_matches(word.lower(), folded, 1)]
    return f". Did you mean {near[0]!r}?" if near else ""


def known_arguments(called: str, named: Iterable[str], known: Sequence[str]) -> None:
    """Refuse an argument that a function does not know, with those that there are and the nearest."""
    for name in named:
        if name not in known:
            allowed = f"{', '.join(known)}{meant(name, known)}"
            raise WrongType(f"{called} has no argument {name!r}: it must be one of {allowed}")


def bound(
    called: str, signature: inspect.Signature, arguments: Sequence[Any], named: Mapping[str, Any], *others: str
) -> inspect.BoundArguments:
    """The arguments of a function by name; others -- names that it takes as further keywords, if these are known."""
    parameters = signature.parameters.values()
    own = [one.name for one in parameters if one.name not in ("self", "cls") and one.kind is not one.VAR_KEYWORD]
    known = (*own, *others)
    if known and (others or all(one.kind is not one.VAR_KEYWORD for one in parameters)):
        known_arguments(called, named, known)
    try:
        return signature.bind(*arguments, **named)
    except TypeError as error:
        raise WrongType(f"{called} takes {', '.join(known) or 'no argument'}: {error}") from None


def checks_arguments(function: Callable[P, R], *others: str) -> Callable[P, R]:
    """The same function, which refuses unknown, missing and surplus arguments as `bound` does."""
    code, called = inspect.unwrap(function).__code__, function.__qualname__.removesuffix(".__init__")
    if code.co_varnames[:1] == ("self",) and function.__name__ != "__init__":
        called = function.__name__  # the class of a method may be one that its user does not know
    known = {*code.co_varnames[: code.co_argcount + code.co_kwonlyargcount], *others}

    @functools.wraps(function)
    def checked(*arguments: P.args, **named: P.kwargs) -> R:
        if others and not known.issuperset(named):
            bound(called, inspect.signature(function), arguments, named, *others)
        try:
            return function(*arguments, **named)
        except TypeError:  # where the arguments bind it is of what the function does
            bound(called, inspect.signature(function), arguments, named, *others)
            raise

    return checked


def methods_check_arguments(*letters: str) -> Callable[[Kind], Kind]:
    """A class whose public methods are `checks_arguments`; letters -- what those take that have `**at`."""

    def checking(kind: Kind) -> Kind:
        for name, one in list(vars(kind).items()):
            if inspect.isfunction(one) and not name.startswith("_"):
                setattr(kind, name, checks_arguments(one, *(letters if "at" in one.__annotations__ else ())))
        return kind

    return checking


def _array(name: str, value: Any, allowed: str) -> npt.NDArray[Any]:
    """Real numbers of any shape, as they are."""
    _is_not_masked(name, value)
    try:
        array = np.asarray(value)
    except ValueError:
        raise _refuse(name, value, allowed) from None
    if array.dtype.kind not in "fiu":
        raise _refuse(name, value, allowed)
    return array


def finite_array(name: str, value: Any, *, positive: bool = False) -> Floats:
    """Finite real numbers, of any shape, as floats."""
    allowed = f"a finite real number{' > 0' if positive else ''}, or an array of such"
    array = _array(name, value, allowed).astype(float)
    bad = ~np.isfinite(array) | (positive & (array <= 0))
    if bad.any():
        raise _refuse(name, array[bad].flat[0] if array.ndim else value, allowed)
    return array


def positive_array(name: str, value: Any) -> Floats:
    """Finite real numbers > 0, of any shape."""
    return finite_array(name, value, positive=True)


def real_array(name: str, value: Any) -> npt.NDArray[Any]:
    """Real numbers of any shape, as they are, without a copy; whether each is allowed is told later."""
    allowed = "a real number, or an array of such"
    return _array(name, value, allowed)


def is_labelled(value: Any) -> bool:
    """Whether a value is an array of xarray or of dask, which are not imported to find out."""
    kinds = (("xarray", "DataArray"), ("xarray", "Variable"), ("dask.array", "Array"))
    loaded = ((sys.modules.get(package), name) for package, name in kinds)
    return any(isinstance(value, getattr(module, name)) for module, name in loaded if module is not None)


def common_shape(arrays: Mapping[str, npt.NDArray[Any]]) -> tuple[int, ...]:
    """The shape to which named arrays broadcast, or a ValueError that gives their shapes."""
    try:
        return np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = tuple(text(f"{{{name}}} {{shape:s}}", str(array.shape)) for name, array in arrays.items())
        raise Refused("shapes do not broadcast: " + together(", ", shapes)) from None


def mapping(name: str, value: Any, meant: str) -> Mapping[str, Any]:
    """A mapping from names, whose values are `meant`."""
    if not isinstance(value, Mapping):
        raise _refuse(name, value, f"a mapping from names to {meant}")
    return value


def two_rows(name: str, value: Any, of: str) -> tuple[Any, Any]:
    """A pair of rows, each as it is given; of: what they are."""
    try:
        first, second = value
    except (TypeError, ValueError):
        raise Refused(f"{name} must be two rows: {of}") from None
    return first, second


def pair(name: str, value: Any, meant: str) -> tuple[Any, Any]:
    """Two things that were given as one; the letters of a word, names and what has no order are none."""
    values: Any = () if isinstance(value, (str, Mapping, Set)) else value
    try:
        one, other = values
    except (TypeError, ValueError):
        raise _refuse(name, value, f"a pair {meant}") from None
    return one, other


def window(name: str, value: Any) -> tuple[float, float]:
    """A pair of frequencies 0 <= low < high <= `HIGHEST_OMEGA`."""
    low, high = pair(name, value, LOW_AND_HIGH)
    low = number(f"{name}[0]", low, least=0.0)
    return low, number(f"{name}[1]", high, above=low, most=HIGHEST_OMEGA)


def curve(samples: Any, Omega: Any) -> tuple[int, tuple[float, float]]:
    """What is asked of a response curve: how many samples, from 2 to `MOST_SAMPLES`, and a window of frequencies."""
    return count("samples", samples, least=2, most=MOST_SAMPLES), window("Omega", Omega)


def several(name: str, value: Any) -> list[float]:
    """A number > 0, or an array of at least one."""
    found: list[float] = positive_array(name, value).ravel().tolist()
    if not found:
        raise _refuse(name, value, "at least one number > 0")
    return found


def frequencies(name: str, value: Any) -> npt.NDArray[np.float64]:
    """An array of frequencies 0 < Omega <= `HIGHEST_OMEGA`."""
    array = positive_array(name, value)
    if array.size and array.max() > HIGHEST_OMEGA:
        raise _refuse(name, float(array.max()), _limit(name, "<=", HIGHEST_OMEGA))
    return array
