"""The kernels: which functions each generated module holds, with their arguments, equation numbers and domains.

In:  `Results`.
Out: `Module`s of `Kernel`s (expressions to print) and `Composition`s (calls of other kernels).

Arguments come in one order everywhere: Omega, A, F_0, m or mu, zeta, h, h_A, h_AA, h_AAA, the mechanism's parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import sympy as sp

from derivations import den_hartog as dh
from derivations.elliptic import evaluable
from derivations.loci import Along, Damped, Undamped, p, p_A, q, root
from derivations.mechanisms import Mechanism
from derivations.oscillator import without_cancellation
from derivations.restoring import Case, Restoring, forms
from derivations.resultants import Elimination
from derivations.results import OfMechanism, Results
from derivations.second_approximation import OF_HARMONIC, RESONANCE
from derivations.slow_flow import SCENES, I, R, SlowFlow, m
from derivations.symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, mu, tau, u, zeta

Let = tuple[sp.Symbol, sp.Expr]

S = dh.S


@dataclass(frozen=True)
class Branch:
    """One regime of a kernel.

    name    -- for the generated code
    guards  -- pairs (left, right): the branch holds where every left <= right and no earlier branch does
    lets    -- intermediate quantities in order
    outputs -- expressions in the arguments and the lets
    """

    name: str
    guards: tuple[tuple[sp.Expr, sp.Expr], ...]
    lets: tuple[Let, ...]
    outputs: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Kernel:
    """A generated function of real numbers.

    parameters -- how many of the last arguments are the mechanism's parameters
    returns    -- "scalar", "tuple" or "stack" (one array, coefficients along its first axis)
    equation   -- number in the paper, or what it is derived from
    domain     -- where it holds
    """

    name: str
    arguments: tuple[sp.Symbol, ...]
    branches: tuple[Branch, ...]
    doc: str
    equation: str
    domain: str
    parameters: int = 0
    returns: str = "scalar"

    @property
    def width(self) -> int:
        return len(self.branches[0].outputs)


@dataclass(frozen=True)
class Composition:
    """A function that calls `inner` of the slow flow with m = friction(mu) and h, h_A, ... of the mechanism put in."""

    name: str
    arguments: tuple[sp.Symbol, ...]
    inner: Kernel
    doc: str
    parameters: int = 0

    @property
    def derivatives(self) -> int:
        """How many of h, h_A, h_AA, h_AAA the inner kernel takes: 0, or up to the highest one."""
        return max((k + 1 for k, symbol in enumerate(AVERAGED) if symbol in self.inner.arguments), default=0)

    @property
    def unused(self) -> tuple[sp.Symbol, ...]:
        """Arguments that do not enter."""
        parameters = self.arguments[len(self.arguments) - self.parameters :] if self.derivatives else ()
        used = {*self.inner.arguments, *parameters, *((mu,) if m in self.inner.arguments else ())}
        return tuple(argument for argument in self.arguments if argument not in used)


@dataclass(frozen=True)
class Module:
    """One generated module.

    inputs     -- file names below `derivations/` that it is derived from
    flow       -- name of the slow-flow module that compositions call
    family     -- name of the module whose h they call
    reexports  -- names taken over from another module of the same mechanism, as (module, names)
    constants  -- Python constants (name, value)
    """

    name: str
    title: str
    inputs: tuple[str, ...]
    kernels: tuple[Kernel, ...]
    compositions: tuple[Composition, ...] = ()
    flow: str = ""
    family: str = ""
    reexports: tuple[str, tuple[str, ...]] = ("", ())
    constants: dict[str, object] = field(default_factory=dict)
    mechanism: Mechanism | None = None


AVERAGED = (h, h_A, h_AA, h_AAA)


def plain(
    name: str,
    arguments: Sequence[sp.Symbol],
    outputs: sp.Expr | Sequence[sp.Expr],
    doc: str,
    equation: str,
    domain: str = "Omega > 0, A > 0",
    lets: Sequence[Let] = (),
    **keywords: object,
) -> Kernel:
    """A kernel with one branch."""
    single = isinstance(outputs, sp.Expr)
    if not single:
        keywords.setdefault("returns", "tuple")
    branch = Branch("", (), tuple(lets), (outputs,) if single else tuple(outputs))
    return Kernel(name, tuple(arguments), (branch,), doc, equation, domain, **keywords)


# --- slow flow ---


def slow_flow_module(results: Results, scene: str) -> Module:
    """The mechanism-free functions in one scene."""
    flow = results.flows[scene]
    kernels = (*slow_flow_kernels(flow, results.detachment[scene]), *locus_kernels(flow, results.loci[scene]))
    return Module(
        name="slow_flow" + suffix(scene),
        title="Slow flow of any mechanism, in h = H - A and its derivatives" + in_words(scene),
        inputs=("averaging.py", "slow_flow.py", "loci.py", "resultants.py"),
        kernels=kernels,
    )


def of_R_and_I(
    flow: SlowFlow, name: str, arguments: Sequence[sp.Symbol], value: sp.Expr, doc: str, *texts: str
) -> Kernel:
    """A kernel of an expression in R and I. They are lets unless they are numbers."""
    named = [(symbol, value) for symbol, value in ((R, flow.R), (I, flow.I)) if not value.is_number]
    numbers = {symbol: value for symbol, value in ((R, flow.R), (I, flow.I)) if value.is_number}
    return plain(name, arguments, value.subs(numbers), doc, *texts, lets=named)


def slow_flow_kernels(flow: SlowFlow, detachment: Elimination) -> list[Kernel]:
    """Every function of the slow flow."""
    of_flow = partial(of_R_and_I, flow)
    amplitude = "A > 0"
    quartic = flow.response_quartic
    fold, peak = flow.fold_quartic, flow.peak_cubic
    damped = (m, zeta)
    return [
        plain("friction", (mu,), flow.m, "Dry friction's share of I.", "(23)", "mu >= 0"),
        plain("R", (Omega, A, h), flow.R, "Cosine balance, -F_0 cos phi at a fixed point.", "(23)"),
        plain("I", (Omega, A, m, zeta), flow.I, "Sine balance, -F_0 sin phi at a fixed point.", "(23)"),
        of_flow("F", (Omega, A, F_0, m, zeta, h), flow.F, "Frequency response; zero at a steady state.", "(24)"),
        of_flow("F_A", (Omega, A, m, zeta, h, h_A), flow.F_A, "dF/dA; positive where stable.", "(24), (30)"),
        of_flow("F_AA", (Omega, A, m, zeta, h, h_A, h_AA), flow.F_AA, "d2F/dA2.", "(24), (33)"),
        of_flow("F_AAA", (Omega, A, m, zeta, h, h_A, h_AA, h_AAA), flow.F_AAA, "d3F/dA3.", "(24)"),
        of_flow("F_Omega", (Omega, A, m, zeta, h), flow.F_Omega, "dF/dOmega.", "(24), (34)"),
        of_flow("F_AOmega", (Omega, A, m, zeta, h, h_A), flow.F_AOmega, "d2F/dA dOmega.", "(24)"),
        # I stays a name here even where it is zero: the sign of that zero keeps phi in [-pi, 0]
        plain(
            "phase",
            (Omega, A, m, zeta, h),
            flow.phase,
            "Phase phi of a steady state, from -pi to 0.",
            "(25)",
            lets=[(R, flow.R), (I, flow.I)],
        ),
        plain("backbone", (A, h), flow.backbone, "Frequency on the backbone.", "(26)", "A > 0, h <= 0"),
        plain(
            "limit_envelope",
            (Omega, F_0, m, zeta),
            flow.limit_envelope,
            "Largest amplitude that the forcing can hold at this frequency.",
            "(27)",
            "Omega > 0, F_0 > m; sticks otherwise",
        ),
        plain(
            "equivalent_damping",
            (Omega, A, m, zeta),
            flow.equivalent_damping,
            "Viscous damping ratio that dissipates as much as zeta and friction together.",
            "(38)",
        ),
        of_flow(
            "transmissibility",
            (Omega, A, F_0, m, zeta, h),
            flow.transmissibility,
            "Fundamental harmonic of the force on the base over F_0, at a steady state.",
            "from (23)",
            "Omega > 0, A > 0, F_0 > 0",
        ),
        plain(
            "jacobian",
            (Omega, A, m, zeta, h, h_A),
            tuple(flow.jacobian),
            "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.",
            "(28)",
        ),
        of_flow(
            "stability",
            (Omega, A, m, zeta, h, h_A),
            flow.stability,
            "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.",
            "(30)",
        ),
        plain(
            "response_quartic",
            (A, F_0, *damped, h),
            without_forcing(quartic),
            "F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.",
            "(24)",
            amplitude,
        ),
        plain(
            "fold_quartic",
            (A, *damped, h, h_A),
            depressed(fold),
            "F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.",
            "(24), (30)",
            amplitude,
        ),
        plain(
            "peak_cubic",
            (A, *damped, h),
            depressed(peak),
            "F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.",
            "(34)",
            amplitude,
        ),
        plain(
            "detachment",
            (A, *damped, h),
            by_even_power(detachment),
            "Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.",
            "(34)",
            amplitude,
            returns="stack",
        ),
    ]


def locus_kernels(flow: SlowFlow, loci: Along) -> list[Kernel]:
    """What the solvers along the amplitude ask: second derivatives, and what vanishes where a curve changes."""
    of_flow = partial(of_R_and_I, flow)
    common = [
        of_flow("F_AAOmega", (Omega, A, zeta, h_A, h_AA), flow.F_AAOmega, "d3F/dA2 dOmega.", "(24)"),
        of_flow("F_OmegaOmega", (Omega, A, zeta, h), flow.F_OmegaOmega, "d2F/dOmega2.", "(24)"),
        of_flow(
            "level",
            (Omega, A, m, zeta, h),
            loci.level,
            "The forcing F_0 for which (Omega, A) is a steady state.",
            "(24)",
            "Omega >= 0, A > 0",
        ),
        plain(
            "rest",
            (F_0, m, h, h_A),
            loci.rest,
            "F at Omega = 0 as a product: h - c, h + c, and the slope of both along A.",
            "from (24)",
            "F_0 >= m",
            lets=loci.rest_lets,
        ),
    ]
    damped = damped_kernels(loci.damped) if loci.damped else []
    return [*common, *damped, *(undamped_kernels(loci.undamped) if loci.undamped else [])]


def damped_kernels(loci: Damped) -> list[Kernel]:
    """Cusps, isola points and extrema over Omega for zeta > 0."""
    return [
        plain("isola_Omega", (h_A,), loci.isola_Omega, "Omega at an isola point.", "from (30), (34)", "h_A >= 0"),
        plain(
            "isola",
            (A, m, zeta, h, h_A, h_AA),
            loci.isola,
            "Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A.",
            "from (30), (34)",
            "A > 0, h_A > 0; for m = 0 any h_A",
            lets=loci.isola_lets,
        ),
        plain(
            "cusps",
            (A, zeta, h, h_A, h_AA, h_AAA),
            loci.cusps,
            "F_AA/2 = X^2 + c_1 X + c_0, X = Omega^2: -c_1/2, c_0, (c_1/2)^2 - c_0, and the last two's slopes along A.",
            "from (33)",
            "A > 0",
            lets=loci.cusps_lets,
        ),
        plain(
            "cusp_F_AAOmega",
            (Omega, root),
            loci.cusp_F_AAOmega,
            "d3F/dA2 dOmega where F_AA = 0: Omega^2 is -c_1/2 + root, root^2 = (c_1/2)^2 - c_0 (see `cusps`).",
            "from (33)",
            "Omega > 0",
        ),
        plain(
            "turn_p_A",
            (A, zeta, h_A, h_AA),
            loci.turn_p_A,
            "Slope along A of p in F_AOmega/8 = A Omega^3 + p Omega + q.",
            "from (30)",
            "A > 0",
        ),
        plain(
            "peak_p_A",
            (zeta, h_A),
            loci.peak_p_A,
            "Slope along A of p in F_Omega/(4 A) = A Omega^3 + p Omega + q.",
            "from (34)",
            "any h_A",
        ),
        plain(
            "critical",
            (A, p, q, p_A),
            loci.critical,
            "Positive where A Omega^3 + p Omega + q has two positive roots, and its slope along A.",
            "from (30), (34)",
            "A > 0, q >= 0",
            lets=loci.critical_lets,
        ),
    ]


def undamped_kernels(loci: Undamped) -> list[Kernel]:
    """The fold locus for zeta = 0."""
    return [
        plain("undamped_Omega", (h_A,), loci.Omega, "Omega of the folds.", "from (30)", "h_A <= 0"),
        plain(
            "undamped",
            (A, h, h_A, h_AA, h_AAA),
            loci.factors,
            "The factors of F_AA/2 at the folds, each with its slope along A: h_AA, R.",
            "from (30), (33)",
            "A > 0",
        ),
    ]


def depressed(coefficients: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """Without the second-highest coefficient, which vanishes."""
    return (*coefficients[:-2], coefficients[-1])


def without_forcing(quartic: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """The response quartic with its forcing put in: h^2 + (m - F_0)(m + F_0) loses no digits where m is near F_0."""
    constant = quartic[0]
    friction = constant.coeff(h, 0)
    if friction == 0:
        return depressed(((h - F_0) * (h + F_0), *quartic[1:]))
    root = sp.sqrt(friction)
    return depressed((constant - friction + (root - F_0) * (root + F_0), *quartic[1:]))


def by_even_power(elimination: Elimination) -> tuple[sp.Expr, ...]:
    """Coefficients of the reduced resultant by even power of its unknown, constant first, zeros included."""
    odd = [power for power in elimination.reduced if power % 2]
    if odd:
        raise ArithmeticError(f"odd powers {odd} of {elimination.unknown} in a resultant that should be even")
    top = max(elimination.reduced)
    return tuple(elimination.reduced.get(power, sp.Integer(0)) for power in range(0, top + 1, 2))


def suffix(scene: str) -> str:
    """Of a module's name."""
    return f"_{scene}" if scene else ""


def in_words(scene: str) -> str:
    """What vanishes in a scene."""
    vanishing = [f"{symbol} = 0" for symbol in SCENES[scene]]
    return f", in the scene {' and '.join(vanishing)}" if vanishing else ""


# --- second approximation ---


def second_approximation_module(results: Results) -> Module:
    """The mechanism-free functions of the second approximation."""
    second = results.second
    families = (AVERAGED, *OF_HARMONIC.values())

    def kernel(name: str, forcing: Sequence[sp.Symbol], derivatives: int, outputs: Sequence[str], doc: str) -> Kernel:
        averages = (symbol for family in families for symbol in family[: derivatives + 1])
        values = [second.outputs[output] for output in outputs]
        domain = f"Omega > 0, A > 0, |h| < {RESONANCE} A Omega^2"
        arguments = (Omega, A, *forcing, m, zeta, *averages)
        return plain(name, arguments, values, doc, "beyond (23)", domain, lets=second.lets)

    return Module(
        name="second_approximation",
        title="Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5",
        inputs=("averaging.py", "slow_flow.py", "second_approximation.py"),
        kernels=(
            kernel(
                "response",
                (F_0,),
                2,
                ("u_max", "A_1", "phi", "R", "F", "F_A", "F_Omega", "R_A", "R_Omega"),
                "Largest displacement, A_1 and phase, R, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega.",
            ),
            kernel(
                "detachment",
                (),
                2,
                ("R", "I", "u_max", "turning"),
                "R, I, largest displacement, and what vanishes where the forcing that reaches it is least.",
            ),
            kernel(
                "folds",
                (F_0,),
                3,
                ("F", "F_A", "F_AA"),
                "F and its derivatives: a fold has F = F_A = 0, a cusp all three.",
            ),
        ),
        constants={"RESONANCE": sp.Integer(RESONANCE)},
    )


# --- Den Hartog ---


def den_hartog_module(results: Results) -> Module:
    """The linear oscillator with dry friction."""
    exact = dh.without_cancellation(results.den_hartog)
    named = [(dh.V, exact.response), (dh.U, exact.damping)]
    away = "Omega > 0, Omega not 1, 1/3, 1/5 and so on"
    return Module(
        name="den_hartog",
        title="Den Hartog's exact solution of the linear oscillator with dry friction, without stops",
        inputs=("den_hartog.py",),
        kernels=(
            plain("V", (Omega,), exact.response, "Response function.", "(37)", "Omega > 0, Omega != 1"),
            plain("U", (Omega,), exact.damping, "Damping function.", "(37)", away),
            plain(
                "S_ratio",
                (tau, Omega),
                exact.slope_ratio,
                "S is the maximum of this over 0 < tau < pi/Omega.",
                "(37)",
                f"0 < tau < pi/Omega, {away}",
                lets=named,
            ),
            plain(
                "amplitude",
                (Omega, F_0, mu),
                exact.amplitude,
                "Amplitude of the motion.",
                "(35)",
                f"F_0 |V| > mu |U|, {away}",
                lets=named,
            ),
            plain(
                "bound",
                (Omega, F_0, S),
                exact.bound,
                "The motion has no stops while its amplitude exceeds this.",
                "(36)",
                away,
                lets=named,
            ),
            plain(
                "motion",
                (tau, Omega, A, mu),
                exact.motion,
                "Displacement tau after a maximum.",
                "from (37)",
                f"0 <= tau <= pi/Omega, {away}",
                lets=named,
            ),
        ),
    )


# --- mechanisms ---


def regime_branches(restoring: Restoring, orders: Sequence[int], attached_only: bool) -> tuple[Branch, ...]:
    """The regimes of an average as branches; at a breakpoint the lower regime holds."""
    cases = restoring.cases or tuple(
        Case(name, guards, restoring.far_regimes[count, far] if far else restoring.regimes[count])
        for name, guards, count, far in forms(restoring.breakpoints)
    )
    if attached_only:
        cases = (replace(cases[0], guards=()),)
    return tuple(
        Branch(c.name, c.guards, c.regime.lets, tuple(c.regime.derivatives[order] for order in orders)) for c in cases
    )


NAMES = ("", "_A", "_AA", "_AAA")


def averaged_kernels(derived: OfMechanism, attached_only: bool = False) -> list[Kernel]:
    """h, H and their derivatives, singly and together."""
    parameters = derived.oscillator.mechanism.parameters
    kernels = []
    domain = "A >= 0"
    if attached_only:
        domain = f"0 <= A <= {derived.whole.breakpoints[0]}"

    def kernel(name: str, restoring: Restoring, orders: Sequence[int], doc: str, equation: str) -> Kernel:
        return Kernel(
            name,
            (A, *parameters),
            regime_branches(restoring, orders, attached_only),
            doc,
            equation,
            domain,
            parameters=len(parameters),
            returns="scalar" if len(orders) == 1 else "tuple",
        )

    for count in (4, 3, 2):
        listed = ", ".join("h" + name for name in NAMES[:count])
        name = "averaged" if count == 4 else f"averaged_{count}"
        kernels.append(kernel(name, derived.whole, range(count), f"{listed} together.", "(20)-(22), (31)"))
    slope = ("", "d/dA of ", "d2/dA2 of ", "d3/dA3 of ")
    for letter, restoring, orders, what in (
        ("h", derived.whole, range(4), "the averaged restoring force h = H - A"),
        ("H", derived.beside_vertical, range(3), "the averaged force H beside the vertical spring"),
    ):
        for order in orders:
            text = slope[order] + what + "." if order else what[0].upper() + what[1:] + "."
            equation = "(20)-(22)" if order == 0 else "(31)" if order == 1 else "from (31)"
            kernels.append(kernel(letter + NAMES[order], restoring, (order,), text, equation))
    return kernels


def harmonics_kernel(derived: OfMechanism) -> Kernel:
    """The higher harmonics of the force and their derivatives, together."""
    parameters = derived.oscillator.mechanism.parameters
    listed = ", ".join(str(symbol) for family in OF_HARMONIC.values() for symbol in family)
    return Kernel(
        "harmonics",
        (A, *parameters),
        tuple(Branch(c.name, c.guards, c.regime.lets, c.regime.derivatives) for c in derived.harmonics.cases),
        f"Higher harmonics of the force, as h is its first: {listed}.",
        "beyond (20)",
        derived.harmonics.domain,
        parameters=len(parameters),
        returns="tuple",
    )


def force_branches(pieces: Sequence[sp.Expr], ends: Sequence[sp.Expr]) -> tuple[Branch, ...]:
    """A piecewise force; at a breakpoint the lower piece holds."""
    guards = [*(((sp.Abs(u), end),) for end in ends), ()]
    numbered = enumerate(zip(guards, pieces, strict=True), start=1)
    return tuple(Branch(f"piece_{k}", guard, (), (piece,)) for k, (guard, piece) in numbered)


def data_kernels(derived: OfMechanism) -> list[Kernel]:
    """Parameters from ratios, breakpoints, jumps, and the force itself."""
    dimensionless = derived.oscillator
    mechanism = dimensionless.mechanism
    parameters, ratios = mechanism.parameters, tuple(mechanism.ratios)
    count = len(parameters)
    whole = derived.whole
    kernels = []
    if ratios:
        kernels.append(
            plain(
                "coefficients",
                ratios,
                tuple(dimensionless.definitions[name] for name in parameters),
                f"The parameters {', '.join(map(str, parameters))} from the design ratios.",
                "(5), (7)",
                "any ratios",
            )
        )
    for name, values, doc, equation in (
        ("breakpoints", whole.breakpoints, "The |u| at which a piece of the force ends.", "(5)"),
        (
            "jumps",
            whole.jumps,
            "What the force loses at each breakpoint: f below less f above.",
            "(5)" if whole.cases else "(6)",
        ),
    ):
        kernels.append(plain(name, parameters, values, doc, equation, "any parameters", parameters=count))
    kernels.append(
        Kernel(
            "force",
            (u, *parameters),
            force_branches(
                [evaluable(piece) if whole.cases else sp.horner(piece, u) for piece in whole.pieces], whole.breakpoints
            ),
            f"Whole dimensionless restoring force u + F_k(u), {'un' if whole.cases else ''}truncated.",
            "(3), (5)" if whole.cases else "(3), (6)",
            f"|u| < {mechanism.reach}" if whole.cases else "any u",
            parameters=count,
        )
    )
    if ratios:
        kernels.append(
            Kernel(
                "untruncated_force",
                (u, *ratios),
                force_branches(
                    [u + without_cancellation(force) for force in dimensionless.exact], dimensionless.exact_ends
                ),
                "Whole dimensionless restoring force u + F_k(u), untruncated.",
                "(3), (5)",
                f"|u| < {mechanism.reach}" if mechanism.reach != sp.oo else "any u",
            )
        )
    return kernels


def resultant_kernels(derived: OfMechanism, scene: str) -> list[Kernel]:
    """Coefficients of the resultants of one scene, where there are any."""
    if not derived.saddle_nodes:
        return []
    parameters = derived.oscillator.mechanism.parameters
    first = derived.whole.breakpoints[:1]
    # the resultants hold for the first regime: its breakpoint does not enter
    domain = f"roots with 0 < A <= {first[0]}" if first else "roots with A > 0"
    return [
        plain(
            "saddle_node_onset",
            (m, zeta, *parameters),
            by_even_power(derived.saddle_node_onset[scene]),
            "Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.",
            "(33)",
            domain,
            parameters=len(parameters),
            returns="stack",
        ),
        plain(
            "saddle_nodes",
            (F_0, m, zeta, *parameters),
            by_even_power(derived.saddle_nodes[scene]),
            "Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.",
            "from (24), (30)",
            domain,
            parameters=len(parameters),
            returns="stack",
        ),
    ]


#: functions of the slow flow that every mechanism composes with its own h
COMPOSED = (
    *("R", "I", "F", "F_A", "F_AA", "F_AAA", "F_Omega", "F_AOmega"),
    *("phase", "jacobian", "stability", "transmissibility"),
)
#: those whose arguments say all: no mechanism enters, or nothing but A and the mechanism
BARE = ("backbone", "limit_envelope", "equivalent_damping")


def compositions(flow: Module, mechanism: Mechanism) -> list[Composition]:
    """The slow flow's functions of Omega, A, F_0, mu, zeta and the mechanism's parameters."""
    by_name = {kernel.name: kernel for kernel in flow.kernels}
    parameters = mechanism.parameters
    result = []
    for name in COMPOSED:
        inner = by_name[name]
        forcing = (F_0,) if F_0 in inner.arguments else ()
        arguments = (Omega, A, *forcing, mu, zeta, *parameters)
        result.append(Composition(name, arguments, inner, inner.doc, len(parameters)))
    for name in BARE:
        inner = by_name[name]
        own = [mu if argument == m else argument for argument in inner.arguments if argument not in AVERAGED]
        needs = parameters if h in inner.arguments else ()
        result.append(Composition(name, (*own, *needs), inner, inner.doc, len(needs)))
    return result


def mechanism_modules(results: Results, name: str, flows: dict[str, Module]) -> list[Module]:
    """The modules of one mechanism: general, one for each damping scene, and attached-only for polynomials."""
    derived = results.mechanisms[name]
    mechanism = derived.oscillator.mechanism
    title = mechanism.title[0].upper() + mechanism.title[1:]
    inputs = (f"mechanisms/{name}.py",)
    family = (*averaged_kernels(derived), harmonics_kernel(derived), *data_kernels(derived))
    if not mechanism.reach.is_extended_real or mechanism.reach.free_symbols:
        raise ArithmeticError(f"{name}: the reach has to be a number in the dimensionless displacement")
    constants = {
        "PARAMETERS": tuple(map(str, mechanism.parameters)),
        "RATIOS": tuple(map(str, mechanism.ratios)),
        "REACH": mechanism.reach,
        "REACH_REASON": mechanism.reach_reason,
        "HARMONICS_UP_TO": derived.harmonics.most,
    }
    modules = []
    for scene in SCENES:
        modules.append(
            Module(
                name=name + suffix(scene),
                title=title + in_words(scene),
                inputs=inputs,
                kernels=(*(() if scene else family), *resultant_kernels(derived, scene)),
                compositions=tuple(compositions(flows[scene], mechanism)),
                flow=flows[scene].name,
                family=name,
                reexports=(name, (*constants, *(kernel.name for kernel in family))) if scene else ("", ()),
                constants={} if scene else constants,
                mechanism=mechanism,
            )
        )
    # an untruncated force ends at the reach: its first piece alone has no average beyond
    if mechanism.breakpoints and not derived.whole.cases:
        data = tuple(kernel.name for kernel in data_kernels(derived))
        modules.append(
            Module(
                name=f"{name}_attached",
                title=f"{title}; amplitudes up to {mechanism.breakpoints[0]} only",
                inputs=inputs,
                kernels=tuple(averaged_kernels(derived, attached_only=True)),
                compositions=tuple(compositions(flows[""], mechanism)),
                flow=flows[""].name,
                family=f"{name}_attached",
                reexports=(name, (*constants, *data, "saddle_node_onset", "saddle_nodes")),
                mechanism=mechanism,
            )
        )
    return modules


def all_modules(results: Results) -> list[Module]:
    """Every generated module, in the order in which they depend on one another."""
    flows = {scene: slow_flow_module(results, scene) for scene in SCENES}
    modules = [*flows.values(), second_approximation_module(results), den_hartog_module(results)]
    for name in results.mechanisms:
        modules.extend(mechanism_modules(results, name, flows))
    return modules
