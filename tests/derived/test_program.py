"""Programs of derived forces: what is refused of their data, their bits beside those of compiled C, their values."""

from __future__ import annotations

import ctypes
import json
import math
import zlib
from array import array
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from slowflow import derive
from slowflow.core import backend
from slowflow_kernels.program_conventions import MOST_REGISTERS, Operation
from tests.derived.test_forces import FORCES
from tests.native.compiler import COMPILER
from tests.native.records import Doubles, Interval, Self, doubles, opened
from tests.sampling import fewer, slow

u, k, c, gap = sp.symbols("u k c gap")
ABOVE_0 = {"above": 0}
#: averages in closed form: one piece, three, a jump of the force, one whose h_AAA is not shown to be monotone; and the
#: library's
CLOSED = {
    "stop": [(u, gap), (u + k * (u - gap), None)],
    "softening": [(u - k * u**3 / 5 + u**5, None)],
    "two_stops": [(u, gap), (u + k * (u - gap), 2 * gap), (u + k * gap + c * (u - 2 * gap), None)],
    "jump": [(u - c * u**3, gap), (k * u, None)],
    "preload": [(c + k * u, None)],
}
#: and sums
SUMMED = ("pendulum", "preload", "two_stops", "hertz", "wave", "numbers")
LIBRARY = ("bilinear", "cam_roller", "dead_zone", "elastic_stop", "three_spring")


def made(name, compile=False):
    """A mechanism, with its program or compiled."""
    if name in LIBRARY:
        return derive.library(name, compile=compile)
    if name in CLOSED:
        names = {
            symbol.name for piece in CLOSED[name] for part in piece if part is not None for symbol in part.free_symbols
        }
        numbers = dict.fromkeys(sorted(names - {"u"}), ABOVE_0)
        return derive.mechanism(f"program_{name}", CLOSED[name], numbers, compile=compile)
    pieces, numbers = FORCES[name.removeprefix("summed_")]
    reach = {"reach": 3.1} if "pendulum" in name else {}
    return derive.mechanism(f"program_{name}", pieces, dict.fromkeys(numbers, ABOVE_0), compile=compile, **reach)


EVERY = (*CLOSED, *(f"summed_{name}" for name in SUMMED), *LIBRARY)


def data(mechanism):
    """Words and numbers of a program."""
    both = json.loads((mechanism.folder / f"{mechanism.record.name}.json").read_text())
    return both["words"], both["numbers"]


def read(integers, numbers):
    """The record of a program."""
    return backend.SOLVER.record(False, "any", array("i", integers).tobytes(), array("d", numbers).tobytes())


def refused(integers, numbers):
    """Whether a program is refused."""
    try:
        read(integers, numbers)
    except ValueError:
        return True
    return False


@pytest.fixture(scope="module", params=slow("summed_hertz", "two_stops", "jump"))
def valid(request):
    """A program, and where each operation and each list of outputs begins in its integers."""
    from slowflow.derivation.codegen.targets.program import Recorder
    from slowflow.derivation.codegen.views import programs

    class Located(Recorder):
        def program(self, one):
            begin = len(self.integers)
            sizes.append((begin, one))
            codes.extend((begin + 5 + 4 * number, one) for number in range(len(one.code)))
            outputs.extend((begin + 5 + 4 * len(one.code) + number, one) for number in range(len(one.outputs)))
            super().program(one)

    mechanism = made(request.param)
    sizes, codes, outputs = [], [], []
    solved = derive._derivation().sources(mechanism._stated).solved
    encoder = Located(solved, programs(solved))
    encoder.record()
    integers, numbers = data(mechanism)
    assert (encoder.integers, encoder.numbers) == (integers, numbers)
    assert read(integers, numbers) is not None
    return integers, numbers, sizes, codes, outputs


def changed(values, place, value):
    return [*values[:place], value, *values[place + 1 :]]


NO_WORDS = st.integers(-(2**31), -1) | st.integers(2**16, 2**31 - 1)


@pytest.mark.slow
@given(st.data())
@settings(max_examples=fewer(60, 5))
def test_words_or_numbers_too_few_or_too_many_are_refused(valid, data):
    integers, numbers, *_ = valid
    assert refused(integers[: data.draw(st.integers(0, len(integers) - 1))], numbers)
    assert refused(integers, numbers[: data.draw(st.integers(0, len(numbers) - 1))])
    assert refused([*integers, data.draw(st.integers(-5, 5))], numbers)
    assert refused(integers, [*numbers, data.draw(st.floats())])


@pytest.mark.slow
@given(st.data())
@settings(max_examples=fewer(200, 5))
def test_unknown_operation_or_register_is_refused(valid, data):
    integers, numbers, _, codes, outputs = valid
    place, program = data.draw(st.sampled_from(codes))
    none = NO_WORDS | st.integers(len(Operation), 300)
    assert refused(changed(integers, place, data.draw(none)), numbers)
    outside = NO_WORDS | st.integers(program.registers, MOST_REGISTERS)
    assert refused(changed(integers, place + data.draw(st.integers(1, 3)), data.draw(outside)), numbers)
    read_only = program.arguments + len(program.constants)
    if read_only:  # an argument or a constant would be overwritten
        assert refused(changed(integers, place + 1, data.draw(st.integers(0, read_only - 1))), numbers)
    place, program = data.draw(st.sampled_from(outputs))
    assert refused(
        changed(integers, place, data.draw(NO_WORDS | st.integers(program.registers, MOST_REGISTERS))), numbers
    )


@pytest.mark.slow
@given(st.data())
@settings(max_examples=fewer(200, 5))
def test_what_holds_nothing_yet_is_not_read(valid, data):
    integers, numbers, sizes, *_ = valid
    begin, program = data.draw(st.sampled_from([one for one in sizes if one[1].code]))
    number = data.draw(st.integers(0, len(program.code) - 1))
    written = {result for _, result, _, _ in program.code[:number]}
    empty = [one for one in range(program.arguments + len(program.constants), program.registers) if one not in written]
    if empty:
        place = begin + 5 + 4 * number + data.draw(st.integers(2, 3))
        assert refused(changed(integers, place, data.draw(st.sampled_from(empty))), numbers)


@pytest.mark.slow
@given(st.data())
@settings(max_examples=fewer(200, 5))
def test_other_sizes_than_a_function_takes_and_gives_are_refused(valid, data):
    integers, numbers, sizes, *_ = valid
    begin, _ = data.draw(st.sampled_from(sizes))
    for place in (begin, begin + 4):
        other = data.draw(st.integers(-3, 100).filter(lambda size, place=place: size != integers[place]))
        assert refused(changed(integers, place, other), numbers)


@given(st.data())
@settings(max_examples=fewer(60, 5))
def test_a_constant_that_is_not_finite_is_refused(valid, data):
    integers, numbers, sizes, *_ = valid
    constants = sum(len(program.constants) for _, program in sizes)
    assert constants
    place = data.draw(st.integers(len(numbers) - 2, len(numbers) - 1))
    for wrong in (math.nan, math.inf, -math.inf):
        assert refused(integers, changed(numbers, place, wrong))
    # bounds and the reach may be infinite, and are numbers
    assert refused(integers, changed(numbers, data.draw(st.integers(0, len(numbers) - 1)), math.nan))


@given(st.data())
@settings(max_examples=fewer(300, 5))
def test_words_that_are_any_integers_are_refused_or_run(valid, data):
    """A program that is accepted may compute anything, but only in its registers."""
    integers, numbers, *_ = valid
    other = list(integers)
    for _ in range(data.draw(st.integers(1, 4))):
        place = data.draw(st.integers(0, len(integers) - 1))
        other[place] = data.draw(st.integers(-2, 40) | st.integers(-(2**31), 2**31 - 1))
    try:
        record = read(other, numbers)
    except ValueError:
        return
    if record is not None:
        record = opened(record)
        p, h = doubles([0.5] * 16), doubles([0.0] * 36)
        record.ask("averaged", 9, doubles([0.1 * one for one in range(9)]), p, h)
        record.ask("ends", p, h)


@pytest.mark.slow
def test_a_force_beyond_what_a_record_has_room_for_is_refused():
    """Thirty-three numbers of a design."""
    names = sp.symbols(f"a0:{33}")
    pieces = [(u + sum(names) * u**3, None)]
    with pytest.raises(
        ValueError, match=r"crowded_\w+ is not allowed: its force has 33 design parameters \(at most 32\)"
    ):
        derive.mechanism("crowded", pieces, {a.name: ABOVE_0 for a in names})


def test_a_design_outside_its_domain_is_none():
    mechanism = derive.mechanism(
        "bounded",
        [(k * u + c * u**3 + gap * u**5, None)],
        {"k": {"least": 1, "below": 2}, "c": {"above": 0}, "gap": {"most": 3}},
    )
    record, p = opened(backend.record_of(mechanism.record)), doubles([0.0] * 16)
    for design, inside in (
        ((1.0, 0.1, 3.0), True),
        ((1.0, 0.1, -5.0), True),
        ((math.nextafter(1.0, 0), 0.1, 3.0), False),
        ((2.0, 0.1, 3.0), False),
        ((1.5, 0.0, 3.0), False),
        ((1.5, 0.1, math.nextafter(3.0, 4)), False),
        ((1.5, math.inf, 1.0), False),
        ((1.5, 1.0, -math.inf), False),
        ((1.5, math.nan, 1.0), False),
    ):
        assert bool(record.ask("parameters_of", doubles(design), p)) is inside, design


class Pair(ctypes.Structure):
    """sf_pair"""

    _fields_ = (("high", ctypes.c_double), ("low", ctypes.c_double))


Intervals, Pairs = ctypes.POINTER(Interval), ctypes.POINTER(Pair)
#: functions that a record may have beside those with a prototype of their own
OTHERS = {
    "harmonics": (None, ctypes.c_ssize_t, Doubles, Doubles, Doubles),
    "intercept": (ctypes.c_double, ctypes.c_double, Doubles),
    "by_parameter": (None, ctypes.c_double, Doubles, Doubles, Doubles),
    "by_design": (None, Doubles, Doubles),
    "parameters_within": (None, Doubles, Intervals),
    "ends_within": (None, Intervals, Intervals),
    "averaged_within": (None, ctypes.c_int, Interval, Interval, Intervals, Intervals),
    "parameters_in_pairs": (None, Doubles, Pairs),
    "ends_in_pairs": (None, Pairs, Pairs),
    "averaged_in_pairs": (None, ctypes.c_int, ctypes.c_int, Pair, Pair, Pairs, Pairs),
    "many_in_pairs": (None, ctypes.c_ssize_t, ctypes.c_ssize_t, Doubles, Doubles),
    "on_first_end_in_pairs": (None, ctypes.c_ssize_t, ctypes.c_ssize_t, Doubles, Doubles),
}


def bits(values):
    """As bytes, of which every NaN is one."""
    flat = np.frombuffer(values, dtype=float)
    return np.where(np.isnan(flat), np.nan, flat).tobytes()


class Calls:
    """Every function of a record, its results as bits."""

    def __init__(self, record):
        self.record = opened(record)

    def has(self, name):
        value = getattr(self.record, name)
        return bool(ctypes.cast(value, ctypes.c_void_p).value if name not in OTHERS else value)

    def ask(self, name, *arguments):
        if name not in OTHERS:
            return self.record.ask(name, *arguments)
        result, *takes = OTHERS[name]
        function = ctypes.CFUNCTYPE(result, Self, *takes)(getattr(self.record, name))
        return function(ctypes.addressof(self.record), *arguments)

    def everything(self, design, A):
        """Results for a design at amplitudes A."""
        found = {}
        p, b = doubles([0.0] * 16), doubles([0.0] * 8)
        values, n = doubles(design), len(A)
        found["inside"] = self.ask("parameters_of", values, p)
        found["p"] = bits(p)
        for name in ("ends", "jumps", *(["kinks"] if self.has("kinks") else [])):
            self.ask(name, p, b)
            found[name] = bits(b)
        amplitudes = doubles(A)
        for name, width in (("averaged", 4), ("averaged_2", 2), ("harmonics", 8)):
            for count in (n, 1):
                out = doubles([0.0] * (width * count))
                self.ask(name, count, amplitudes, p, out)
                found[name, count] = bits(out)
        out = doubles([0.0] * 200)
        self.ask("by_design", values, out)
        found["by_design"] = bits(out)
        for one in A[:3]:
            found["intercept", one] = bits(doubles([self.ask("intercept", one, p)]))
            self.ask("by_parameter", one, doubles([-0.5, -1.0, 0.2]), p, out)
            found["by_parameter", one] = bits(out)
        if self.has("bent"):
            for low, high in pairwise(A):
                enclosures = (Interval * 2)()
                self.ask("bent", Interval(low, high), p, enclosures)
                found["bent", low] = bits(enclosures)
        found |= self.exactly(values, A)
        return found

    def exactly(self, design, A):
        """Results in double-double and on intervals, where the record has them."""
        record, found = self.record, {}
        if self.has("parameters_in_pairs"):
            p, b, h = (Pair * 20)(), (Pair * 4)(), (Pair * 5)()
            self.ask("parameters_in_pairs", design, p)
            found["parameters_in_pairs"] = bits(p)
            if record.breakpoints:
                self.ask("ends_in_pairs", p, b)
                found["ends_in_pairs"] = bits(b)
            for one in A:
                passed = sum(one > end.high for end in b[: record.breakpoints])
                beyond = one - b[passed - 1].high if passed else one
                for size in (2, 4):
                    self.ask("averaged_in_pairs", passed, size, Pair(one, one * 2.0**-55), Pair(beyond, 0), p, h)
                    found["averaged_in_pairs", one, size] = bits(h)
            apart = 3
            designs = doubles([value * (1 + 0.01 * i) for value in design for i in range(apart)])
            for name in ("many_in_pairs", *(["on_first_end_in_pairs"] if record.breakpoints else [])):
                out = doubles([0.0] * (2 * apart * 20))
                self.ask(name, apart, apart, designs, out)
                found[name] = bits(out)
        if self.has("parameters_within"):
            p, b, h = (Interval * 20)(), (Interval * 4)(), (Interval * 5)()
            self.ask("parameters_within", design, p)
            found["parameters_within"] = bits(p)
            if record.breakpoints:
                self.ask("ends_within", p, b)
                found["ends_within"] = bits(b)
            for one in A:
                passed = sum(one > end.hi for end in b[: record.breakpoints])
                beyond = one - b[passed - 1].hi if passed else one
                wide = Interval(one, one * 1.01), Interval(beyond, beyond + one * 0.01)
                self.ask("averaged_within", passed, *wide, p, h)
                found["averaged_within", one] = bits(h)
        return found


@pytest.mark.slow
@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
@pytest.mark.parametrize("name", EVERY)
@pytest.mark.part(5)
def test_a_program_gives_the_bits_of_compiled_C(name):
    """Every function of the record, and batches, at random designs; next to breakpoints too."""
    mechanism = made(name)
    before = backend.SOLVER.RECORDS.pop(mechanism.record.name, None)
    program = backend.record_of(mechanism.record)
    assert opened(program).program
    assert made(name, compile=True).record is mechanism.record
    compiled = backend.record_of(mechanism.record)
    if opened(compiled).program:  # another test has compiled it, which is done once
        compiled = before
    assert compiled and not opened(compiled).program
    backend.SOLVER.RECORDS[mechanism.record.name] = program
    one, other = Calls(program), Calls(compiled)
    assert [one.has(each) for each in (*OTHERS, "bent", "kinks")] == [
        other.has(each) for each in (*OTHERS, "bent", "kinks")
    ]
    for field in ("design_size", "damping_size", "parameters", "breakpoints", "reach", "harmonics_up_to", "inertial"):
        assert getattr(one.record, field) == getattr(other.record, field), field
    rng = np.random.default_rng(zlib.crc32(name.encode()))
    count = one.record.design_size
    for _ in range(12 if name.startswith("summed") else 40):
        design = list(rng.uniform(0.05, 1.6, count))
        p, b = doubles([0.0] * 16), doubles([0.0] * 4)
        one.ask("parameters_of", doubles(design), p), one.ask("ends", p, b)
        ends = [end for end in b[: one.record.breakpoints] if 0 < end < 3]
        neighbours = [math.nextafter(end, place) for end in ends for place in (0.0, 9.0)]
        A = sorted(
            [*rng.uniform(1e-6, 3.0, 9), *ends, *neighbours, *(1.05 * end for end in ends), *(64 * end for end in ends)]
        )
        here, there = one.everything(design, A), other.everything(design, A)
        assert here.keys() == there.keys()
        assert [key for key in here if here[key] != there[key]] == [], design
    designs = [rng.uniform(0.05, 1.6, 20) for _ in range(count)]
    damping = rng.uniform(0, 0.03, 20), rng.uniform(0.01, 0.2, 20)
    for question, arguments in (("many_onset", ()), ("many_detachment", ()), ("many_peak", (0.3,))):
        ask = getattr(backend.SOLVER, question)
        for here, there in zip(
            *(ask(record)(*designs, *damping, *arguments) for record in (program, compiled)), strict=True
        ):
            np.testing.assert_array_equal(here, there)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["stop", "softening", "two_stops", "jump", "summed_hertz", "summed_wave"])
def test_an_interpreted_average_is_that_of_its_force(name):
    """By mpmath's quadrature of the force as written: to a few roundings of the terms."""
    mechanism = made(name)
    pieces = CLOSED.get(name) or FORCES[name.removeprefix("summed_")][0]
    record, found = backend.record_of(mechanism.record), np.empty((4, 1))
    names = mechanism.record.design_names
    numbers = dict(zip(names, (0.7, 0.3, 1.3), strict=False))
    parameters = mechanism.record.coefficients(*numbers.values())
    symbols = {sp.Symbol(one): sp.Rational(value) for one, value in numbers.items()}
    laws = [sp.lambdify(u, sp.sympify(force).subs(symbols), "mpmath") for force, _ in pieces]
    ends = [float(end.subs(symbols)) for _, end in pieces[:-1]]
    with mp.workdps(30):
        for A in (0.2, 0.31, 0.9, 2.2):
            edges = [mp.mpf(0), *(mp.asin(mp.mpf(end) / A) for end in ends if end < A), mp.pi / 2]
            integrals = [
                [
                    mp.quad(lambda t, A=A, law=law, of=of: of(law(A * mp.sin(t)) * mp.sin(t)), side)
                    for of in (mp.mpf, abs)
                ]
                for law, side in zip(laws, pairwise(edges), strict=False)
            ]
            expected, size = (4 / mp.pi * sum(values) for values in zip(*integrals, strict=True))
            backend.SOLVER.averages(record, tuple(map(float, parameters)), np.array([A]), found)
            assert abs(found[0, 0] + expected) < 8 * 2.0**-53 * size, A
