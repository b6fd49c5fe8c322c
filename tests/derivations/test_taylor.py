"""Taylor recurrences of every function that a force may hold: steps in C against 25 digits, and the form chosen."""

import subprocess
from types import SimpleNamespace

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from sympy.codegen.cfunctions import log1p

from derivations.codegen.compensated import copysign
from derivations.codegen.form import Law
from derivations.codegen.targets.c import taylor
from derivations.codegen.views import templates
from derivations.symbols import u
from tests.native import compiler

a, b = sp.symbols("a b", real=True)
CONSTANTS = {a: 0.7, b: 0.45}
ROOT = sp.sqrt((1 - u) * (1 + u))
#: each function alone, and together
FORCES = {
    "cube_root": sp.cbrt(1 + a * u**2) * u,
    "sine": sp.sin(a * u) + b * u * sp.cos(u),
    "tangent": sp.tan(a * u),
    "quotient": u / (1 + a * u**2) + b * u**3 / (2 + u**2) ** 2,
    "reciprocal_root": u / sp.sqrt(1 + a * u**4),
    "three_halves": u * (1 + a * u**2) ** sp.Rational(3, 2),
    "two_roots": u * sp.sqrt(1 + u**2) - b * u / sp.sqrt(2 + u**2),
    "exponential": sp.exp(a * u) - sp.exp(-b * u) + u * a**u,
    "hyperbolic": sp.sinh(a * u) * sp.cosh(u),
    "hyperbolic_tangent": sp.tanh(a * u) + b * sp.tanh(a * u) ** 2 * u,
    "logarithm": u * sp.log(1 + a * u**2) + log1p(b * u),
    "inverses": sp.asin(a * u) - sp.acos(u) * u + sp.atan(u / b),
    "inverse_hyperbolic": sp.asinh(a * u) + sp.acosh(2 + u) * u + sp.atanh(b * u),
    "broken_power": b * u**a * u + (1 + u) ** sp.Rational(7, 5) * u,
    "power_of_itself": u ** (1 + u),
    "by_size": a * copysign(sp.Abs(u), u) + b * copysign(1, u) * sp.Abs(u) ** sp.Rational(5, 3),
    "signed": a * u + b * u * copysign(sp.Integer(1), u) * u,
    "in_powers": u * (a + 2 * b * u**2 / (ROOT * (ROOT + 1))),
}
STATE = {
    "Omega": 0.9,
    "F_0": 0.11,
    "zeta": 0.03,
    "friction": -0.02,
    "quadratic": 0.3,
    "theta": 0.4,
    "u": 0.35,
    "v": -0.2,
}
STEP = 0.15


def on_positive(force):
    """The force for u > 0."""
    return force.replace(copysign, lambda size, of: size).replace(sp.Abs, lambda of: of)


def slope_of(force):
    """Its slope; of a force that is stated by the side of u = 0 by the size of u."""
    inclined = sp.diff(on_positive(force), u)
    return inclined.subs(u, sp.Abs(u)) if force.has(copysign) else inclined


def fake_module(name, force):
    """As much of a module as the recurrences take, with every root named, as kernels have it."""
    slope = slope_of(force)
    kernels = []
    for kernel, form in (("force", force), ("slope", slope)):
        broken = {p for p in form.atoms(sp.Pow) if p.exp.is_Rational and not p.exp.is_Integer}
        powers = sorted(broken, key=str)
        pairs = dict.fromkeys((p.base, p.exp.q) for p in powers)
        roots = {pair: sp.Symbol(f"{kernel}_root_{i}") for i, pair in enumerate(pairs)}
        lets = tuple((symbol, sp.Pow(base, sp.Rational(1, q))) for (base, q), symbol in roots.items())
        named = form.xreplace({p: roots[p.base, p.exp.q] ** p.exp.p for p in powers})
        branch = SimpleNamespace(lets=lets, outputs=(named,))
        kernels.append(
            SimpleNamespace(name=kernel, arguments=(u, *CONSTANTS), branches=(branch,), doc=str(form), equation="(3)")
        )
    return SimpleNamespace(
        name=name, kernels=kernels, record=SimpleNamespace(pieces=[Law("force", "slope", f"{name}.force")])
    )


@pytest.fixture(scope="module")
def stepped(tmp_path_factory):
    """u, v and their derivatives by (u, v, Omega, F_0) after a step, by name: by both expansions."""
    if compiler.COMPILER is None:
        pytest.skip("no C compiler (cc) on the path")
    folder = tmp_path_factory.mktemp("taylor")
    environment = templates(compiler.ROOT / "derivations" / "codegen" / "targets" / "c")
    modules = [fake_module(name, force) for name, force in FORCES.items()]
    (folder / "taylor.h").write_text(taylor.text(modules, environment))
    drive = ", ".join(repr(STATE[key]) for key in ("Omega", "F_0", "zeta", "friction", "quadratic"))
    state = ", ".join(repr(STATE[key]) for key in ("theta", "u", "v"))
    (folder / "main.c").write_text(
        f"""#include <stdio.h>
#include "taylor.h"
int main(void)
{{
    const double p[] = {{{", ".join(map(repr, (*CONSTANTS.values(), 1.0)))}}}, h = {STEP!r};
    const sf_drive drive = {{{drive}}};
    const sf_four flow[2] = {{sf_four_of(1.0, 0.0, 0.0, 0.0), sf_four_of(0.0, 1.0, 0.0, 0.0)}};
    for (int i = 0; i < SF_LAWS; i++) {{
        static sf_expansion x, y;
        sf_four by[2];
        sf_laws[i].expand(&sf_laws[i], p, &drive, {state}, NULL, &x);
        sf_laws[i].expand(&sf_laws[i], p, &drive, {state}, flow, &y);
        sf_four_at(y.U, h, &by[0]);
        sf_four_at(y.V, h, &by[1]);
        printf("%.17g %.17g %.17g %.17g", sf_at(x.u, h), sf_at(x.v, h), sf_at(y.u, h), sf_at(y.v, h));
        for (int k = 0; k < 8; k++)
            printf(" %.17g", sf_lane(by, k));
        printf(" %.17g %.17g\\n", exp2(log2(sf_step_of(&x, 0))), sf_laws[i].value(&sf_laws[i], p, {STATE["u"]!r}));
    }}
    return 0;
}}
"""
    )
    options = ["-std=c11", "-O2", f"-I{compiler.NATIVE / 'exact'}", f"-I{folder}"]
    main = compiler.compiled(folder / "main", folder / "main.c", options=options, compiler=compiler.COMPILER)
    lines = subprocess.run([str(main)], check=True, capture_output=True, text=True).stdout.splitlines()
    return {name: np.array(line.split(), dtype=float) for name, line in zip(FORCES, lines, strict=True)}


@pytest.mark.slow
@pytest.mark.parametrize("name", FORCES)
def test_a_step_by_every_function_against_twenty_five_digits(name, stepped):
    """The equation of motion and its variations, the slope by SymPy, integrated by mpmath."""
    positive = on_positive(FORCES[name])  # u stays positive
    with mp.workdps(25):
        values = {symbol: mp.mpf(value) for symbol, value in CONSTANTS.items()}
        force = sp.lambdify((u, *CONSTANTS), positive, "mpmath")
        slope = sp.lambdify((u, *CONSTANTS), sp.diff(positive, u), "mpmath")
        at = {key: mp.mpf(value) for key, value in STATE.items()}

        def rates(t, y):
            theta = at["theta"] + at["Omega"] * t
            push = at["F_0"] * mp.cos(theta) - force(y[0], *values.values())
            rate = push - at["friction"] - (2 * at["zeta"] + at["quadratic"] * y[1]) * y[1]
            damping = 2 * (at["zeta"] + at["quadratic"] * y[1])
            out = [y[1], rate]
            stiffness = slope(y[0], *values.values())
            extra = [(0, 0), (0, 0), (-y[1] / at["Omega"], -rate / at["Omega"]), (0, mp.cos(theta))]
            pairs = [
                (y[6 + c] + du, -stiffness * y[2 + c] - damping * y[6 + c] + dv) for c, (du, dv) in enumerate(extra)
            ]
            return out + [pair[0] for pair in pairs] + [pair[1] for pair in pairs]

        start = [at["u"], at["v"], 1, 0, 0, 0, 0, 1, 0, 0]
        expected = np.array(mp.odefun(rates, 0, start, tol=mp.mpf(10) ** -20)(mp.mpf(STEP)), dtype=float)
    found = stepped[name]
    assert np.max(np.abs(found[:2] - expected[:2])) <= 2e-16
    assert np.max(np.abs(found[2:4] - expected[:2])) <= 2e-16
    assert np.max(np.abs(found[4:12] - expected[2:])) <= 1e-15
    assert found[12] >= STEP, "a step over which the series does not hold"


def test_an_even_form_of_one_root_is_written_in_its_powers():
    """1/s - 1 = u^2/(s (s + 1)) for s^2 = 1 - u^2, by hand; forms that are no such sum are left alone."""
    assert sp.simplify(taylor.by_root(u**2 / (ROOT * (ROOT + 1))) - (1 / ROOT - 1)) == 0
    assert sp.expand(taylor.by_root(u**2 * ROOT) - (ROOT - ROOT**3)) == 0
    for other in (u * ROOT, u**2, 1 / (1 + 2 * ROOT), ROOT * sp.sqrt(2 + u**2), sp.cbrt(1 + u**2), sp.sqrt(1 + u)):
        assert taylor.by_root(other) is None, other


def test_the_shorter_form_is_taken():
    """Four products for the force that (5) states, five with its slope: as many groups of sums as can be."""
    (law,) = taylor.laws([fake_module("in_powers", FORCES["in_powers"])])
    assert (len(law.force.sums), len(law.both.sums)) == (4, 5)
    plain = taylor.recurrence("plain", tuple(CONSTANTS), [], [FORCES["in_powers"]])
    assert len(plain.sums) > len(law.force.sums)
