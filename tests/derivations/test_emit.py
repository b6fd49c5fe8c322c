"""Passes and printers: what they must survive, what they must refuse, what they must not do to an expression."""

from __future__ import annotations

import importlib.util
import itertools
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from mpmath import mp, mpf
from sympy.codegen.cfunctions import hypot

from derivations.codegen.bytecode import kept_beside
from derivations.codegen.common import with_calls
from derivations.codegen.passes import operations, straight_line
from derivations.codegen.targets.c import PRINTER
from derivations.codegen.targets.c.printer import CPrinter
from derivations.codegen.targets.numpy.printer import NumpyPrinter
from derivations.codegen.targets.printing import Unprintable, literal
from derivations.codegen.views import printed
from derivations.forces.repeated import TURNS, Output, Repeated
from derivations.kernels import Branch, Kernel
from derivations.paper.averaging import averaged
from derivations.paper.slow_flow import slow_flow
from derivations.symbols import A
from tests.native.compiler import COMPILER, WARNINGS, compiled
from tests.sampling import part

x, y = sp.symbols("x y", positive=True)
z, w = sp.symbols("z w", real=True)
PRINTERS = {"c": CPrinter(), "numpy": NumpyPrinter()}
AT = {x: 0.7, y: 1.8, z: -1.5, w: -0.2}

#: every printer must survive these, after the passes
SURVIVES = [
    sp.Integer(0),
    sp.Integer(-3),
    sp.Rational(2, 3),
    sp.pi,
    sp.pi / 2 - 1,
    4 / sp.pi,
    sp.sqrt(2) / 3,
    x,
    -x,
    x + y - z,
    x - (y - z),
    -(x + y) * z,
    2 * (x + y) / 3,
    -sp.Rational(5, 8) * x * (y - z),
    x * y / z,
    x / (y * z),
    -x / (y + z),
    1 / x,
    -1 / (x * y),
    1 / (x + y) ** 2,
    x**2,
    (x + y) ** 2 + z,
    x**7 + x**4 * y**3,
    x**-3 * y**5,
    (x - y) ** 6 / (x + y) ** 5,
    sp.sqrt(x),
    1 / sp.sqrt(x + y),
    sp.sqrt((y - x) * (y + x)),
    sp.cbrt(x) / y - 1 / sp.cbrt(x + y),
    sp.sin(x) + sp.cos(y) * sp.tan(z),
    sp.sin(x * y) ** 2,
    sp.atan2(x - y, z),
    sp.atan2(-z, w),
    sp.Abs(z) * x,
    4 * x * (sp.Rational(1, 3) + y * (sp.Rational(1, 7) - z)) / sp.pi,
]

#: and must refuse these
REFUSED = [
    sp.gamma(x),
    sp.erf(x),
    sp.Function("f")(x),
    sp.Derivative(sp.Function("f")(x), x),
    sp.Integral(sp.sin(x), (x, 0, y)),
    sp.Integral(sp.sin(x), (x, 0, 1)),
    sp.Sum(x, (x, 1, 3)),
    sp.Piecewise((x, x < y), (y, True)),
    sp.Max(x, y),
    x**9,
    (x + y) ** 12,
    sp.Float("0.1") * x,
    sp.Float("0.1"),
    x + sp.I,
    sp.nan,
    sp.zoo,
    x < y,
    sp.Matrix([x, y]),
]


def program_of(expression):
    """The passes' result for one expression."""
    return straight_line([], [expression], (x, y, z, w))


def numpy_source(programs) -> str:
    lines = ["import numpy as np", ""]
    for k, program in enumerate(programs):
        lines += ["", f"def f{k}(x, y, z, w):"]
        lines += [f"    {symbol} = {PRINTERS['numpy'].doprint(value)}" for symbol, value in program.lets]
        lines += [f"    return {PRINTERS['numpy'].doprint(program.outputs[0])}", ""]
    return "\n".join(lines)


def c_source(programs) -> str:
    lines = ["#include <math.h>", '#include "angles.h"', "#include <stdio.h>"]
    for k, program in enumerate(programs):
        lines.append(
            f"static double f{k}(double x, double y, double z, double w)\n{{\n    (void)x; (void)y; (void)z; (void)w;"
        )
        lines += [f"    const double {symbol} = {PRINTERS['c'].doprint(value)};" for symbol, value in program.lets]
        lines += [f"    return {PRINTERS['c'].doprint(program.outputs[0])};", "}"]
    lines += ["int main(void)", "{"]
    lines += [f'    printf("%.17g\\n", f{k}({", ".join(map(repr, AT.values()))}));' for k in range(len(programs))]
    return "\n".join([*lines, "    return 0;", "}", ""])


@pytest.fixture(scope="module")
def expected():
    with mp.workdps(40):
        exact = {symbol: sp.Rational(value) for symbol, value in AT.items()}
        return [float(sp.N(expression.subs(exact), 40)) for expression in SURVIVES]


def test_numpy_survives(expected, tmp_path):
    path = tmp_path / "survives.py"
    path.write_text(numpy_source([program_of(expression) for expression in SURVIVES]))
    specification = importlib.util.spec_from_file_location("survives", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    for k, value in enumerate(expected):
        found = getattr(module, f"f{k}")(*AT.values())
        np.testing.assert_allclose(found, value, rtol=2e-15, err_msg=str(SURVIVES[k]))


@pytest.mark.skipif(COMPILER is None, reason="no C compiler (cc) on the path")
def test_c_survives(expected, tmp_path):
    source = tmp_path / "survives.c"
    source.write_text(c_source([program_of(expression) for expression in SURVIVES]))
    program = compiled(tmp_path / "survives", source, options=WARNINGS, compiler=COMPILER)
    printed = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout.split()
    for expression, text, value in zip(SURVIVES, printed, expected, strict=True):
        np.testing.assert_allclose(float(text), value, rtol=2e-15, err_msg=str(expression))


@pytest.mark.parametrize("language", PRINTERS)
@pytest.mark.parametrize("expression", REFUSED, ids=str)
def test_printer_refuses(language, expression):
    with pytest.raises(Unprintable):
        PRINTERS[language].doprint(expression)


@pytest.mark.parametrize(
    ("expression", "numpy", "c"),
    [
        (sp.exp(x), "np.exp(x)", "exp(x)"),
        (x**y, "np.power(x, y)", "pow(x, y)"),
        (x ** sp.Rational(2, 3), "np.power(x, 0.66666666666666663)", "pow(x, 0.66666666666666663)"),
        (sp.sin(1) * x, "0.8414709848078965 * x", "0.8414709848078965 * x"),
    ],
)
def test_forces_of_any_kind_are_printed(expression, numpy, c):
    assert PRINTERS["numpy"].doprint(expression) == numpy
    assert PRINTERS["c"].doprint(expression) == c


def test_c_leaves_the_name_I_to_complex_h():
    assert CPrinter().doprint(sp.Symbol("I") + x) == "I_ + x"


def test_no_call_of_pow():
    for expression in SURVIVES:
        program = program_of(expression)
        for value in (*(value for _, value in program.lets), *program.outputs):
            for printer in PRINTERS.values():
                assert "pow" not in printer.doprint(value) and "**" not in printer.doprint(value)


@pytest.mark.parametrize("number", [sp.pi, 4 / sp.pi, sp.Rational(1, 3), sp.Rational(5, 24), sp.sqrt(2), sp.Integer(7)])
def test_literals_are_the_nearest_doubles(number):
    with mp.workdps(60):
        value = mpf(sp.N(number, 60)._to_mpmath(200))
        printed = float(literal(number))
        assert abs(printed - value) <= min(abs(math.nextafter(printed, end) - value) for end in (math.inf, -math.inf))


@pytest.mark.parametrize(
    ("expression", "count"),
    [
        (x, 0),
        (-x, 0),
        (4 * x / sp.pi, 1),
        (1 / x, 1),
        (1 / (x + y), 2),
        (x / (y * z), 2),
        (-x * y**3, 3),
        (x / y**2 - 1, 3),
        (sp.sqrt(x + y), 2),
        (1 / sp.sqrt(x), 2),
        (sp.sin(x * y) ** 2, 3),
    ],
    ids=str,
)
def test_count_of_operations(expression, count):
    assert operations(expression) == count


def test_numbers_are_not_multiplied_out():
    program = straight_line([], [2 * x * (y + z), sp.Mul(3, y + z, evaluate=False)], (x, y, z))
    assert not any(operations(output) > 2 for output in program.outputs)


@pytest.mark.slow
def test_structured_forms_stay():
    """F keeps its product (I - F_0)(I + F_0), and F_A its R (Omega^2 + h_A)."""
    flow = slow_flow(averaged())
    I, R = sp.symbols("I R", real=True)
    program = straight_line([(R, flow.R), (I, flow.I)], [flow.F], flow.F.free_symbols | flow.R.free_symbols)
    factors = [node for node in sp.preorder_traversal(program.outputs[0]) if node.is_Mul]
    assert any(sum(factor.is_Add for factor in node.args) == 2 for node in factors)
    assert program.operations <= sum(map(operations, (flow.R, flow.I, flow.F)))


@pytest.mark.slow
def test_passes_change_no_value(modules, code):
    """Putting the lets back gives the value of the expression that went in, for every kernel."""
    mp.dps = 50
    rng = np.random.default_rng(7)
    kernels = [(one.name, kernel) for one in modules for kernel in one.kernels]
    for module, kernel in part(kernels, 5):
        for branch, program in zip(kernel.branches, code[module][kernel.name], strict=True):
            at = {argument: mpf(float(rng.uniform(0.1, 0.4))) for argument in kernel.arguments}
            at |= {symbol: mpf(float(rng.uniform(0.5, 0.9))) for symbol in at if symbol == A}
            # u_cr below A follows from it
            at |= {symbol: mpf(float(rng.uniform(0.02, 0.09))) for symbol in at if symbol.name == "delta_h"}
            before = evaluated(branch.lets, branch.outputs, at)
            after = evaluated(program.lets, program.outputs, at)
            for one, other in zip(before, after, strict=True):
                assert abs(one - other) <= mpf(10) ** -40 * (1 + abs(one)), (module, kernel.name)


#: what expressions are made of, with mpmath
EVALUATED = {
    sp.Add: lambda *terms: mp.fsum(terms),
    sp.Mul: lambda *factors: mp.fprod(factors),
    sp.Pow: mp.power,
    sp.sin: mp.sin,
    sp.cos: mp.cos,
    sp.tan: mp.tan,
    sp.exp: mp.exp,
    # at the numbers that are drawn a root may be imaginary, which mp.hypot and mp.atan2 do not take
    sp.atan2: lambda y, x: -1j * mp.log((x + 1j * y) / mp.sqrt(x**2 + y**2)),
    hypot: lambda x, y: mp.sqrt(x**2 + y**2),
    sp.Abs: abs,
    sp.sign: mp.sign,
    sp.UnevaluatedExpr: lambda value: value,
}


def evaluated(lets, outputs, at):
    """Values of the outputs to 50 digits; infinite ones as 0."""
    values = {symbol.name: value for symbol, value in at.items()}

    def value_of(expression):
        if expression.is_Symbol:
            return values[expression.name]
        if expression in (sp.oo, -sp.oo):
            return mpf(0)
        if expression.is_Rational:
            return mpf(expression.p) / expression.q
        if expression is sp.pi:
            return +mp.pi
        if isinstance(expression, Output):
            one = expression.repeated
            arguments = dict(zip(one.arguments, map(value_of, expression.args), strict=True))
            for _ in range(int(arguments.get(TURNS, 1))):
                found = evaluated(one.lets, [value for _, value in one.outputs], arguments)
                arguments.update(zip(one.state, found[: len(one.state)], strict=True))
            return found[expression.number]
        return EVALUATED[expression.func](*map(value_of, expression.args))

    needed = set().union(*(output.free_symbols for output in outputs))
    for symbol, expression in reversed(lets):
        needed |= expression.free_symbols if symbol in needed else set()
    for symbol, expression in lets:
        if symbol in needed:
            values[symbol.name] = value_of(expression)
    return [value_of(output) for output in outputs]


def test_a_name_that_is_taken_by_an_argument_is_left_to_it():
    """Of a common subexpression, and of a power."""
    t0, x2 = sp.symbols("t0 x2")
    program = straight_line([], [(x + t0) ** 2 + (x + t0) + x**2 + x**3 + x2], (x, t0, x2))
    names = [symbol.name for symbol, _ in program.lets]
    assert not {"x", "t0", "x2"} & set(names)
    assert len(names) == len(set(names)) >= 2


def differences():
    """Two numbers less their sum."""
    total, one, other = sp.symbols("total one other", real=True)
    return Repeated("beside", "Less the sum.", (z, w), ((total, z + w),), ((one, z - total), (other, w - total)))


def test_what_is_repeated_is_a_call_that_stands_for_its_lets():
    a, b, c, d = sp.symbols("a b c d", real=True)
    lets = [*differences().at((x, sp.Integer(3)), (a, b)), *differences().at((b, y), (c, d))]
    program = straight_line(lets, [a + d, c], (x, y))
    first, second = printed(program.lets, PRINTER)
    assert (first.name, first.value, first.function) == ("a, b", "x, 3.0", "beside")
    assert (second.name, second.value) == ("c, d", "b, y")
    # a sum and two differences in each call, and a + d
    assert program.operations == 2 * 3 + 1
    # of 5 and 3: -3 and -5; of -5 and 7: -7 and 5
    assert evaluated(program.lets, program.outputs, {x: mpf(5), y: mpf(7)}) == [-3 + 5, -7]


def test_a_loop_goes_on_from_what_its_last_turn_gave():
    """Of Fibonacci's numbers: an addition a turn, and one after."""
    a, b = sp.symbols("a b", real=True)
    following = (sp.Symbol("next_z"), w), (sp.Symbol("next_w"), z + w)
    step = Repeated("fibonacci", "Two numbers in a row.", (z, w, TURNS), (), following)
    program = straight_line(step.at((x, y, sp.Integer(10)), (a, b)), [a + b], (x, y))
    assert program.operations == 10 + 1
    assert evaluated(program.lets, program.outputs, {x: mpf(0), y: mpf(1)}) == [144]
    (line,) = printed(program.lets, PRINTER)
    assert (line.name, line.function, line.state, line.value) == ("a, b", "fibonacci", ("x", "y"), "10")


def test_what_kernels_have_in_common_is_one_function():
    """Of two kernels with one chain of names; a third, whose chain begins otherwise, keeps its own."""
    names = sp.symbols("s_0:40", real=True)

    def chain(begin):
        steps = ((name, earlier * (earlier + x) / y) for earlier, name in itertools.pairwise(names))
        return ((names[0], begin), *steps)

    def kernel(name, begin, output):
        return Kernel(name, (x, y, z), (Branch("", (), chain(begin), (output,)),), "", "", "")

    kernels = [
        kernel("sum", x + z, names[-1] + y),
        kernel("product", x + z, names[-1] * z),
        kernel("other", x - z, names[-1]),
    ]
    code = {one.name: (straight_line(one.branches[0].lets, one.branches[0].outputs, one.arguments),) for one in kernels}
    found = with_calls(kernels, code, PRINTER)
    calls = {
        name: [value.repeated for _, value in one.lets if isinstance(value, Output)] for name, (one,) in found.items()
    }
    assert calls["sum"] == calls["product"] and len(calls["sum"]) == 1 and not calls["other"]
    assert [name for name, _ in calls["sum"][0].outputs] == [sp.Symbol("s_39_out")]
    at = {x: mpf(2), y: mpf(7), z: mpf(-1)}
    for name, (program,) in code.items():
        shared = found[name][0]
        assert evaluated(shared.lets, shared.outputs, at) == evaluated(program.lets, program.outputs, at)
        assert len(shared.lets) == (1 if calls[name] else len(program.lets))


def test_regimes_that_end_alike_share_their_end():
    """From a named quantity on, which each regime computes in its own way; a third regime has other outputs."""
    names = sp.symbols("s_0:30", real=True)

    def branch(name, begin, last):
        steps = ((name, earlier * (earlier + x) / y) for earlier, name in itertools.pairwise(names))
        return Branch(name, (), ((names[0], begin), *steps), (names[-1] + last, names[-1] * x))

    branches = (branch("low", x + z, y), branch("high", x - z, y), branch("other", x + z, z))
    kernel = Kernel("ends", (x, y, z), branches, "", "", "", "tuple")
    code = {"ends": tuple(straight_line(one.lets, one.outputs, kernel.arguments) for one in branches)}
    found = with_calls([kernel], code, PRINTER)["ends"]
    low, high, other = ([value.repeated for _, value in one.lets if isinstance(value, Output)] for one in found)
    assert {one.doc for one in low} == {one.doc for one in high} == {"The outputs of ends_low, ends_high."}
    assert not {one.name for one in other} & {one.name for one in low}
    at = {x: mpf(2), y: mpf(7), z: mpf(-1)}
    for shared, program in zip(found, code["ends"], strict=True):
        assert evaluated(shared.lets, shared.outputs, at) == evaluated(program.lets, program.outputs, at)


def test_repeats_are_refused_where_a_language_cannot_print_them():
    a, b = sp.symbols("a b", real=True)
    with pytest.raises(ArithmeticError, match="symbols or numbers"):
        differences().at((x + 1, y), (a, b))
    with pytest.raises(ArithmeticError, match="not every output"):
        printed(straight_line(differences().at((x, y), (a, b)), [a], (x, y)).lets, PRINTER)
    with pytest.raises(ArithmeticError, match="one name"):
        Repeated("twice", "", (x,), ((x, x + 1),), ((y, x),))


def test_template_bytecode_is_kept_where_python_keeps_its_own(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "pycache_prefix", None)
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    assert kept_beside(tmp_path, Path(__file__)) is not None
    assert [path.name for path in tmp_path.iterdir()] == ["__pycache__"]
    (tmp_path / "file").touch()
    assert kept_beside(tmp_path / "file", Path(__file__)) is None
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert kept_beside(tmp_path, Path(__file__)) is None
