"""Intervals hold every result: operations against exact rationals, generated functions against 40 digits."""

import importlib
import inspect
import shutil
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from slowflow.core.intervals import Elementary, Interval
from tests.files import stored
from tests.native import intervals
from tests.sampling import fewer

#: in Python, where balls go by them, and in C
MODULES = ("slow_flow_intervals",)
IN_C = (*MODULES, "inertia_intervals", "dissipation_intervals", "sampled_intervals")
FUNCTIONS = [
    (module, name) for module in MODULES for name in importlib.import_module(f"slowflow_kernels.{module}").__all__
]
ORACLE = stored("kernel_oracle")
#: those that are evaluated at points too; the rest is there on intervals only
AT_POINTS = [
    pytest.param(how, module, name, marks=marks)
    for how, functions, marks in (("Python", FUNCTIONS, ()), ("C", intervals.prototypes(IN_C), pytest.mark.slow))
    for module, name in functions
    if name in ORACLE[module.removesuffix("_intervals")]
]


def function_of(module, name):
    return getattr(importlib.import_module(f"slowflow_kernels.{module}"), name)


def random_intervals(rng, n):
    """Of either sign, around 0, from 0 on, narrow ones and points, over many orders."""
    a = rng.choice([-1.0, 1.0], n) * 10.0 ** rng.uniform(-8, 8, n)
    width = np.abs(a) * rng.choice([0.0, 1e-15, 1e-3, 0.5, 3.0], n)
    a = np.where(rng.random(n) < 0.1, 0.0, a)
    return Interval.of(a, a + width)


def holds(interval, k, value):
    """Whether interval k holds an exact number."""
    return Fraction(float(interval.lo[k])) <= value <= Fraction(float(interval.hi[k]))


def has_sign(interval):
    """Whether each interval lies on one side of 0."""
    return (interval.lo > 0) | (interval.hi < 0)


def test_operations_enclose_the_exact_results():
    rng, n = np.random.default_rng(1), fewer(2000, 5)
    a, b = random_intervals(rng, n), random_intervals(rng, n)
    apart = has_sign(b)
    with np.errstate(all="ignore"):
        found = {"+": a + b, "-": a - b, "*": a * b, "/": a / b, "square": a.square(), "3": 3.0 * a, "1-": 1.0 - a}
        root, turned = a.square().sqrt(), -3.0 * a
    for k in range(n):
        for fraction in (0, 1, Fraction(1, 3)):
            x, y = (Fraction(float(i.lo[k])) * (1 - fraction) + Fraction(float(i.hi[k])) * fraction for i in (a, b))
            assert holds(found["+"], k, x + y) and holds(found["-"], k, x - y) and holds(found["*"], k, x * y)
            assert holds(found["square"], k, x * x) and holds(root, k, abs(x))
            assert holds(found["3"], k, 3 * x) and holds(turned, k, -3 * x) and holds(found["1-"], k, 1 - x)
            assert not apart[k] or holds(found["/"], k, x / y)


def test_what_is_not_known_has_no_sign():
    a = Interval.of(np.array([np.nan, -np.inf, -1.0]), np.array([np.nan, np.inf, 1.0]))
    one = Interval.of(np.ones(3), np.full(3, 2.0))
    with np.errstate(all="ignore"):
        for found in (a, a * one, one * a, a + one, one / a, -a, a * a):
            assert not has_sign(found).any()
        unknown = Interval.point(np.nan)
        assert not has_sign(unknown.square()).any() and not has_sign(unknown.sqrt()).any()
        assert not has_sign(Interval.of(-np.inf, np.inf) * Interval.point(0.0)).any()


def test_operations_hold_what_is_infinite_or_too_small():
    """Of any ends: none, in the wrong order, infinite, subnormal, whose products are; 0 times anything is 0."""
    sizes = [0.0, 5e-324, 3e-310, 2.0**-1022, 7e-300, 1e-154, 1 / 3, 1.0, 3.0, 1e154, 1.7e308, np.inf, np.nan]
    ends = np.array([sign * size for size in sizes for sign in (1, -1)])
    any_two = Interval(np.stack(np.meshgrid(ends, ends)).reshape(2, -1))
    with np.errstate(all="ignore"):
        squares, inverses = any_two.square(), 1 / any_two
        products = [(two, any_two * Interval(two[:, np.newaxis])) for two in any_two.ends.T]
    for k, (x, y) in enumerate(any_two.ends.T):
        if not x <= y:
            assert np.isnan(squares.ends[:, k]).all()
            assert inverses.lo[k] == -np.inf and inverses.hi[k] == np.inf
            continue
        for end in (x, y):
            assert end == np.inf or end == -np.inf or held_or_infinite(squares, k, Fraction(end) ** 2)
            assert end == 0 or np.isinf(end) or held_or_infinite(inverses, k, 1 / Fraction(end))
            for (u, v), product in products[:: len(products) // 40]:
                for other in (u, v) if u <= v else ():
                    zero = end == 0 or other == 0
                    if zero or np.isfinite((x, y, u, v)).all():
                        assert held_or_infinite(product, k, 0 if zero else Fraction(end) * Fraction(other))


def held_or_infinite(interval, k, value):
    """The same of ends that may be infinite or not known."""
    low, high = float(interval.lo[k]), float(interval.hi[k])
    known = [end if np.isfinite(end) else None for end in (low, high)]
    below, above = (
        end is None or sign * (value - Fraction(end)) >= 0 for end, sign in zip(known, (1, -1), strict=True)
    )
    return below and above and low != np.inf and high != -np.inf


@pytest.mark.parametrize("name", ["sin", "cos", "tan", "acos", "asin", "exp", "cosh", "tanh"])
def test_elementary_functions_hold_their_values(name):
    """At the ends and inside, by mpmath; across a pole of tan, and outside the domain, nothing is known."""
    rng = np.random.default_rng(3)
    centre, width = rng.uniform(-6, 6, 300), rng.choice([0.0, 1e-3, 0.5, 3.0, 7.0], 300)
    if name in ("acos", "asin"):
        centre, width = centre / 6, width / 40
    low, high = centre - width, centre + width
    with np.errstate(all="ignore"):
        found = getattr(Elementary(np.stack((low, high))), name)().ends
    wide = np.isnan(found).any(axis=0) | np.isinf(found).all(axis=0)
    if name == "tan":
        poles = np.floor(low / np.pi + 0.5) != np.floor(high / np.pi + 0.5)
        assert wide[poles].all() and not wide[~poles].any()
    elif name in ("acos", "asin"):
        assert np.array_equal(wide, (low < -1) | (high > 1))
    else:
        assert not wide.any()
    for k in np.flatnonzero(~wide):
        for fraction in (0.0, 0.3, 0.5, 1.0):
            value = getattr(mpmath, name)(mpmath.mpf(low[k]) * (1 - fraction) + mpmath.mpf(high[k]) * fraction)
            assert found[0, k] <= value <= found[1, k]
        if width[k] == 0:
            assert found[1, k] - found[0, k] <= 1e-12 * (1 + abs(found[0, k]))


class Exact:
    """A number with the methods that the generated functions call."""

    def __init__(self, value):
        self.value = mpmath.mpmathify(value)

    def square(self):
        return Exact(self.value**2)

    def sqrt(self):
        return Exact(mpmath.sqrt(self.value))

    def __neg__(self):
        return Exact(-self.value)

    def __add__(self, other):
        return Exact(self.value + getattr(other, "value", other))

    def __sub__(self, other):
        return Exact(self.value - getattr(other, "value", other))

    def __mul__(self, other):
        return Exact(self.value * getattr(other, "value", other))

    def __truediv__(self, other):
        return Exact(self.value / getattr(other, "value", other))

    def __rsub__(self, other):
        return Exact(other - self.value)

    def __rtruediv__(self, other):
        return Exact(other / self.value)

    __radd__, __rmul__ = __add__, __mul__


@pytest.mark.parametrize(("module", "name"), FUNCTIONS)
def test_a_generated_function_holds_its_values_on_intervals(module, name):
    function = function_of(module, name)
    names = list(inspect.signature(function).parameters)
    rng, n = np.random.default_rng(2), 60
    low = {argument: rng.uniform(0.05, 3, n) * rng.choice([1, -1], n) for argument in names}
    for argument in {"A", "Omega", "m", "zeta", "F_0", "X", *(("h_A",) if name == "isola" else ())} & low.keys():
        low[argument] = np.abs(low[argument])
    if name == "fold":  # inside its domain
        low["F_0"] = low["m"] + rng.uniform(0.1, 2, n)
        low["k"] = np.sign(low["k"]) * low["F_0"] * rng.uniform(1.2, 3, n)
    width = rng.choice([0.0, 1e-12, 1e-2], n)
    arguments = {key: Interval.of(value - 0.0, value + np.abs(value) * width) for key, value in low.items()}
    with np.errstate(all="ignore"):
        found = function(*arguments.values())
    found = found if isinstance(found, tuple) else (found,)
    with mpmath.workdps(40):
        for k in range(n):
            fraction = float(rng.random())
            at = [
                Exact((1 - fraction) * mpmath.mpf(i.lo[k]) + fraction * mpmath.mpf(i.hi[k])) for i in arguments.values()
            ]
            values = function(*at)
            for interval, value in zip(found, values if isinstance(values, tuple) else (values,), strict=True):
                if not isinstance(interval, Interval):  # a number, of any arguments
                    assert interval == value
                elif isinstance(value.value, mpmath.mpf) and np.isfinite([interval.lo[k], interval.hi[k]]).all():
                    assert interval.lo[k] <= value.value <= interval.hi[k], (name, k)


@pytest.fixture(scope="module")
def compiled(once):
    """The generated functions in C."""
    if shutil.which("gcc") is None:
        pytest.skip("no gcc on the path")
    return intervals.generated(once("generated intervals", lambda folder: intervals.build_generated(folder, IN_C)))


@pytest.fixture
def enclosures(request):
    """Of a function in Python or in C, at boxes (arguments, 2): its outputs, (outputs, 2)."""

    def found(how, module, kernel, boxes):
        if how == "C":
            return request.getfixturevalue("compiled")(module, kernel, boxes)
        values = function_of(module, kernel)(*(Interval.of(*box) for box in np.array(boxes)[..., np.newaxis]))
        values = values if isinstance(values, tuple) else (values,)
        return np.array([one.ends[:, 0] if isinstance(one, Interval) else (one, one) for one in values])

    return found


@pytest.mark.parametrize(("how", "module", "kernel"), AT_POINTS)
def test_the_exact_values_at_a_point_are_held(enclosures, how, module, kernel):
    for row in ORACLE[module.removesuffix("_intervals")][kernel]:
        found = enclosures(how, module, kernel, [(x, x) for x in row["at"]])
        assert np.isfinite(found[: len(row["is"])]).all()
        for (low, high), value, scale in zip(found, row["is"], row["scale"], strict=how == "Python"):
            printed = Fraction(scale) / 10**38  # the oracle has 40 digits
            assert Fraction(low) - printed <= Fraction(value) <= Fraction(high) + printed
            # and little else: as many roundings as there are operations
            assert Fraction(high) - Fraction(low) <= Fraction(1, 2**44) * Fraction(scale)


@pytest.mark.parametrize(("how", "module", "kernel"), AT_POINTS)
def test_the_values_all_over_a_box_are_held(enclosures, how, module, kernel):
    rng = np.random.default_rng(20261121)
    plain = getattr(importlib.import_module(f"slowflow_kernels.{module.removesuffix('_intervals')}"), kernel)
    for row in ORACLE[module.removesuffix("_intervals")][kernel]:
        at = np.array(row["at"])
        for width in (1e-6, 1e-2, 0.3):
            other = at * (1 + width)
            inside = at[:, np.newaxis] + (other - at)[:, np.newaxis] * rng.random((len(at), 40))
            with np.errstate(all="ignore"):  # outside of its domain a value is NaN
                found = plain(*inside)
                values = np.broadcast_arrays(*(found if isinstance(found, tuple) else np.atleast_2d(found)))
                held_in = enclosures(how, module, kernel, np.sort(np.stack((at, other), axis=1), axis=1))
            for (low, high), value, size in zip(held_in, values, row["scale"], strict=how == "Python"):
                rounding = 2.0**-48 * (np.abs(value) + float(size))
                enclosed = ~(low > value + rounding) & ~(value - rounding > high)
                assert (enclosed | np.isnan(value)).all()
