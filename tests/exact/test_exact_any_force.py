"""Exact motions under forces of any kind: compiled series against 30 digits and closed forms, not against our own."""

import ctypes
import json
from array import array

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from derivations.codegen.compensated import copysign
from derivations.codegen.targets.c import taylor
from derivations.codegen.targets.program import motion
from derivations.codegen.views import templates
from derivations.symbols import u
from slowflow import derive, include
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import Force, Law, Piece
from slowflow.exact import EquationOfMotion, exact_response, steady_state
from slowflow_kernels.exact_conventions import Event
from tests.derivations.test_taylor import CONSTANTS, a, b, fake_module, slope_of
from tests.derivations.test_taylor import FORCES as EVERY
from tests.native.compiler import COMPILER, ROOT, compiled
from tests.oracles import by_time
from tests.oracles.exact_reference import Compiled, Drive, again

pytestmark = [pytest.mark.skipif(COMPILER is None, reason="no C compiler (cc) on the path")]

#: a hardening spring, three springs of which two lie flat at rest, a contact: in u, a, b
FORCES = {
    "sinh": u / 2 + b * sp.sinh(a * u),
    "three_springs": u * (1 + a * (1 - 1 / sp.sqrt(u**2 + b**2))),
    "contact": a * copysign(1, u) * sp.Abs(u) ** (1 + b),
}
A, B = CONSTANTS.values()
MODULES = [{"copysign": np.copysign}, "numpy"]
STATES = [(0.4, 0.35, -0.2, 1.9), (1.0, 0.8, 0.4, 0.3), (0.2, 0.1, 0.0, 2.2), (0.0, 0.0, 0.3, 0.6)]


@pytest.fixture(scope="module")
def pieces(tmp_path_factory):
    """(a, b) -> a piece of each force, by name."""
    folder = tmp_path_factory.mktemp("laws")
    environment = templates(ROOT / "derivations" / "codegen" / "targets" / "c")
    modules = [fake_module(name, force) for name, force in {**EVERY, **FORCES}.items()]
    text = taylor.text(modules, environment)
    (folder / "laws.c").write_text(f"{text}\nconst sf_law *const slowflow_laws = sf_laws;\n")
    options = [*derive.FLAGS, *(f"-I{place}" for place in include())]
    library = compiled(folder / "laws.so", folder / "laws.c", options=options, compiler=COMPILER)
    table = derive._capsule(ctypes.CDLL(str(library)), "slowflow_laws", derive.LAWS)
    with pytest.MonkeyPatch.context() as patched:
        for name, law in EXACT.laws(table).items():
            patched.setitem(EXACT.LAWS, name, law)
        for module in modules:
            ((name, data),) = json.loads(motion.text(module)).items()
            lists = array("i", data["words"]).tobytes(), array("d", data["numbers"]).tobytes()
            patched.setitem(EXACT.LAWS, f"interpreted {name}", EXACT.interpreted(name, *lists))

        def piece(name, *constants, how=""):
            force = {**EVERY, **FORCES}[name]
            on_floats = (sp.lambdify((u, *CONSTANTS), form, MODULES) for form in (force, slope_of(force)))
            return Piece(Law(*on_floats, f"{how}{name}.force"), constants)

        yield piece


@pytest.mark.slow
@pytest.mark.parametrize("name", [*EVERY, *FORCES])
def test_interpreted_series_have_the_bits_of_printed_ones(pieces, name):
    """States and derivatives, forwards and backwards, and the first stop; of forces with every function."""
    drive = Drive(0.9, 0.11, 0.03, -0.02, 0.3)
    for theta, at, v, end in STATES:
        for way in ((theta, at, v, end), (theta, -at, v, end)):
            one, other = (pieces(name, A, B, how=how) for how in ("", "interpreted "))
            try:
                there, v_there, flow = Compiled().advance(one, drive, *way)
            except ArithmeticError:  # beyond where it is defined
                with pytest.raises(ArithmeticError):
                    Compiled().advance(other, drive, *way)
                continue
            found, v_found, of_found = Compiled().advance(other, drive, *way)
            assert (there, v_there, flow.tolist()) == (found, v_found, of_found.tolist())


def test_data_that_is_no_program_is_refused():
    """One instruction or number more or less, an empty register, another size, and too many series are refused."""
    ((name, data),) = json.loads(motion.text(fake_module("sinh", FORCES["sinh"]))).items()

    def law(instructions, numbers):
        return EXACT.interpreted(name, array("i", instructions).tobytes(), array("d", numbers).tobytes())

    program, numbers = data["words"], data["numbers"]
    assert law(program, numbers) is not None
    assert law([10**6, *program[1:]], numbers) is None
    spoilt = [(program[:-1], numbers), ([*program, 0], numbers), (program, numbers[:-1]), (program, [*numbers, 1.0])]
    spoilt += [([*program[:k], -1, *program[k + 1 :]], numbers) for k in range(len(program))]
    spoilt += [(program, [*numbers[:k], float("nan"), *numbers[k + 1 :]]) for k in range(len(numbers))]
    for one in spoilt:
        with pytest.raises(ValueError, match=r"sinh.force: its force is no program"):
            law(*one)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "Omega"), [("sinh", 0.9), ("three_springs", 0.9)])
@pytest.mark.part(2)
def test_periodic_motion_and_variations_have_thirty_digits(pieces, name, Omega):
    """From its turning point mpmath comes to the mirror image half a period later, and deviations to ours."""
    F_0, zeta = 0.2, 0.03
    system = EquationOfMotion(Force((pieces(name, A, B),), ()), 0.0, zeta)
    found = steady_state(system, Omega=Omega, F_0=F_0)
    assert found.symmetric
    with mp.workdps(30):
        coefficients = mp.mpf(A), mp.mpf(B)
        f, slope = (sp.lambdify((u, a, b), form, "mpmath") for form in (FORCES[name], sp.diff(FORCES[name], u)))
        theta, Om, damping = mp.mpf(found.unknowns[1]), mp.mpf(Omega), 2 * mp.mpf(zeta)

        def rates(t, y):
            push = mp.mpf(F_0) * mp.cos(theta + Om * t) - f(y[0], *coefficients)
            stiffness = slope(y[0], *coefficients)
            bent = [-stiffness * y[2 + c] - damping * y[4 + c] for c in range(2)]
            return [y[1], push - damping * y[1], y[4], y[5], *bent]

        end = mp.odefun(rates, 0, [mp.mpf(found.unknowns[0]), 0, 1, 0, 0, 1])(mp.pi / Om)
        assert max(abs(end[0] + found.unknowns[0]), abs(end[1])) <= 2e-15 * found.A
        monodromy = -np.array(end[2:], dtype=float).reshape(2, 2)
    assert np.max(np.abs(found.cycle.equations(found.unknowns, F_0).monodromy - monodromy)) <= 1e-14
    # those of the motion before Newton's last step, which moved it by less than 1e-13
    there, here = (np.sort_complex(one) for one in (np.linalg.eigvals(monodromy), found.half_multipliers))
    assert np.max(np.abs(there - here)) <= 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("power", [1.1, 1.5, 2.0, 2.5, 3.3])
def test_a_free_contact_swings_as_long_as_its_closed_form(pieces, power):
    """u'' = -a |u|^p sign(u), which has no series at u = 0, comes to rest at the other side after a Beta function.

    By the time as a function of the amplitude its map over that time is known too: a shear, turned by half a turn.
    """
    Omega, start = 0.7, 0.4
    piece, drive = pieces("contact", A, power - 1), Drive(Omega, 0.0, 0.0, 0.0)
    with mp.workdps(30):
        P = 1 + mp.mpf(power - 1)
        scale = mp.sqrt((P + 1) / (2 * mp.mpf(A))) * mp.beta(1 / (P + 1), mp.mpf(1) / 2) / (P + 1)
        half = 2 * scale * mp.mpf(start) ** ((1 - P) / 2)
        later = half * (1 - P) / 2 / mp.mpf(start)  # d half / d start
        push = mp.mpf(A) * mp.mpf(start) ** P
    at, there, _, event = Compiled().until(piece, drive, -1, -1e6, 0.0, start, 0.0, 100.0)
    assert event == Event.STOP
    assert abs(at / Omega - half) <= 4e-16 * half and abs(there + start) <= 4e-16
    over, v, flow = Compiled().advance(piece, drive, 0.0, start, 0.0, float(half) * Omega)
    assert max(abs(over + start), abs(v)) <= 4e-16
    # a start farther out is at its turn earlier or later: by then it has gained a velocity
    assert np.max(np.abs(flow[:, :2] - [[-1.0, 0.0], [float(-push * later), -1.0]])) <= 1e-13


@pytest.mark.slow  # its forces are derived
def test_a_curve_at_a_contact(pieces):
    """A contact at rest, with friction: 300 points and more, folds, stops and borders; one point by SciPy."""
    system = EquationOfMotion(Force((pieces("contact", A, 0.5),), ()), 0.004, 0.01)
    curve = exact_response(system, 0.02, Omega=(0.2, 1.2))
    assert len(curve.folds) == 2 and not curve.stable.all()
    state = curve.steady_state(len(curve) // 2)
    assert state.residual <= 1e-14
    other = again(state)
    assert other.A == pytest.approx(state.A, rel=1e-10)
    assert np.max(np.abs(other.multipliers - state.multipliers)) <= 1e-9


@pytest.mark.slow
def test_motions_through_a_contact_behind_a_gap_are_complete():
    """What they pass on, and shocks, against SciPy: at the gap itself there is no series, and nothing was answered."""
    k, gap = sp.symbols("k gap")
    pieces = [(u, gap), (u + k * (u - gap) ** sp.Rational(3, 2), None)]
    made = derive.mechanism("contact", pieces, {"k": {"above": 0}, "gap": {"above": 0}}, compile=True)
    one, mu, zeta = made(k=20.0, gap=0.2, mu=0.01, zeta=0.03), 0.01, 0.03

    def force(x):
        return x + np.sign(x) * 20.0 * np.maximum(np.abs(x) - 0.2, 0.0) ** 1.5

    state = one.steady_state(Omega=1.5, F_0=0.08, A=0.3)
    assert len(state.phases) > 2
    _, x, v = state.series(20000)
    passed = force(x) + 2 * zeta * v + mu * np.sign(v)
    found = state.transmitted()
    assert found.rms == pytest.approx(np.sqrt(np.mean(passed**2)) / 0.08, rel=1e-6)
    assert found.peak == pytest.approx(np.abs(passed).max() / 0.08, rel=1e-6)
    shock, peak, span = one.transient(acceleration=0.5, duration=2.0), 0.5, 2.0
    (pulse,) = one.shock_spectrum(acceleration=peak, duration=span)

    assert shock.A == pulse.A
    assert (shock.A, shock.a_max) == pytest.approx(by_time.shock(one, force, peak, span, 8.0, 2e-3), rel=1e-5)
    assert pulse.a_max == pytest.approx(shock.a_max, rel=1e-12)
