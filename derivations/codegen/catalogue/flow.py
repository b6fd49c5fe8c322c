"""The kernels of the slow flow: functions of Omega, A, damping and h that know no mechanism, one module for each scene.

In:  `Results`.
Out: `slow_flow_modules`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import sympy as sp

from ...asymmetric.offset import mean_stiffness, offset_stiffness
from ...kernels import Branch, Kernel, plain
from ...paper.critical_forcings import Elimination
from ...paper.slow_flow import SCENES, I, R, SlowFlow, m, preload, reduction
from ...results import Results
from ...symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, mu, zeta
from ...systems.along import (
    R_,
    X_,
    Along,
    Damped,
    T,
    Undamped,
    apart,
    k,
    k_A,
    kappa,
    lacks,
    over_A,
    rho,
    root,
    scaled_root,
    t,
)
from ...systems.newton import EQUATIONS
from ...systems.slopes import Slopes
from ..form import GENERAL, Module, by_even_power, in_words, suffix

#: of a frequency
square = sp.Symbol("square", real=True)

#: what a scene has of its own: where the mathematics changes. Elsewhere the general form divides by what vanishes, has
#: more coefficients, or a sum for a product
OWN = {
    "mu0": ("response_quartic", "detachment", "isola", "fold"),
    "zeta0": ("limit_envelope", "detachment", "fold", "undamped_Omega", "undamped_level", "undamped_rises", "undamped"),
    "mu0_zeta0": ("detachment",),
}
#: what else is asked in a scene, of a module in which less vanishes: `no_other` proves that it is the same there
IN_SCENES = (
    *("R", "I", "F", "F_A", "F_AA", "F_Omega", "F_AOmega", "level", "stability", "phase"),
    *("backbone", "limit_envelope", "equivalent_damping", "isola_Omega"),
    *("response_quartic", "fold_quartic", "peak_cubic"),
)

#: what the solvers and their proofs ask on whole intervals, by scene: the general form where it holds for zeros too
SEARCHED = {
    "": (
        "F_A",
        "F_AA",
        "fold_quartic",
        "peak_cubic",
        "fold",
        "isola",
        "cusps",
        "cusp_R",
        "cusp",
        "turn",
        "peak",
        "intercept",
    ),
    "mu0": ("isola",),
    "zeta0": ("fold",),
}
#: beside these, what proofs at run time ask
PROVED = {
    "": (
        *("friction", "R", "F", "F_Omega", "F_OmegaOmega", "F_AOmega", "level", "backbone", "least_restoring"),
        *("most_restoring", "isola_Omega", "level_rise", "cusp_bend", "isola_bend"),
    ),
    "zeta0": ("undamped_Omega", "undamped_rises"),
}


def slow_flow_modules(results: Results) -> list[Module]:
    """The mechanism-free functions, in general and in each scene."""
    kernels = {scene: {kernel.name: kernel for kernel in kernels_of(results, scene)} for scene in SCENES}
    modules = []
    for scene in SCENES:
        enclosed = (*SEARCHED.get(scene, ()), *PROVED.get(scene, ()))
        wanted = OWN[scene] if scene else kernels[scene]
        modules.append(
            Module(
                name=GENERAL + suffix(scene),
                title="Slow flow of any mechanism, in h = H - A and its derivatives" + in_words(scene),
                inputs=(
                    "paper/averaging.py",
                    "paper/slow_flow.py",
                    "asymmetric/offset.py",
                    "systems/along.py",
                    "systems/slopes.py",
                    "systems/bounds.py",
                    "systems/newton.py",
                    "paper/critical_forcings.py",
                ),
                kernels=tuple(
                    replace(
                        kernel,
                        enclosed=kernel.name in enclosed,
                        # friction's number is no double: balls have it
                        searched=kernel.name in enclosed and kernel.name != "friction",
                        paired=not scene and kernel.name == "friction",
                    )
                    for kernel in kernels[scene].values()
                    if kernel.name in wanted
                ),
                borrowed=borrowed(kernels, scene) if scene else {},
                cells=cell_kernels(results.along[scene], scene),
                settled=() if scene else step_kernels(results),
                constants={"SCENE": told(results.flows[scene], scene)},
            )
        )
    return modules


def borrowed(kernels: Mapping[str, Mapping[str, Kernel]], scene: str) -> dict[str, tuple[str, ...]]:
    """What a scene has from other modules, by these: where less of it vanishes, or nothing."""
    zeros = {symbol for symbol in SCENES[scene]}
    others = [other for other in SCENES if other != scene and SCENES[other].keys() <= zeros]
    found: dict[str, list[str]] = {}
    for name in dict.fromkeys((*IN_SCENES, *(name for other in others for name in OWN.get(other, ())))):
        if name in kernels[scene] and name not in OWN[scene]:
            # the last that has it of its own
            other = [other for other in others if not other or name in OWN[other]][-1]
            no_other(kernels[other][name], kernels[scene][name], scene)
            found.setdefault(GENERAL + suffix(other), []).append(name)
    return {module: tuple(names) for module, names in found.items()}


def no_other(kernel: Kernel, in_scene: Kernel, scene: str) -> None:
    """That a kernel, where the scene's zeros are put in, is the one which is derived in the scene."""
    zeros = {m if symbol == mu else symbol: 0 for symbol in SCENES[scene]}
    if kernel.arguments != in_scene.arguments or kernel.width != in_scene.width:
        raise ArithmeticError(f"{kernel.name} takes or gives something else in the scene {scene}")
    for here, there in zip(whole(kernel), whole(in_scene), strict=True):
        left, right = here.subs(zeros), there.subs(zeros)
        if left != right and sp.simplify(left - right) != 0:
            raise ArithmeticError(f"{kernel.name} in the scene {scene}: {left} is not {right}")


def whole(kernel: Kernel) -> list[sp.Expr]:
    """Its outputs in its arguments."""
    (branch,) = kernel.branches
    outputs = list(branch.outputs)
    for symbol, value in reversed(branch.lets):
        outputs = [output.subs(symbol, value) for output in outputs]
    return outputs


def told(flow: SlowFlow, scene: str) -> str:
    """A scene in words: which damping terms vanish, and what F is for it."""
    vanishing = SCENES[scene]
    damping = " = ".join([*(symbol.name for symbol in vanishing), "0"]) if vanishing else "mu > 0, zeta > 0"
    if flow.response_quartic[1] == 0:
        return f"{damping}: F is a quadratic in Omega^2, roots in closed form"
    return f"{damping}: F is a quartic in Omega"


def kernels_of(results: Results, scene: str) -> list[Kernel]:
    """All of them, in one scene."""
    flow = results.flows[scene]
    general = []
    if not scene:
        general = [
            *slope_kernels(flow, results.slopes),
            *bound_kernels(results),
        ]
    return [*slow_flow_kernels(flow, results.detachment[scene]), *locus_kernels(flow, results.along[scene]), *general]


def of_R_and_I(
    flow: SlowFlow, name: str, arguments: Sequence[sp.Symbol], value: sp.Expr, doc: str, *texts: str
) -> Kernel:
    """A kernel of an expression in R and I. They are lets unless they are numbers."""
    named = [(symbol, value) for symbol, value in ((R, flow.R), (I, flow.I)) if not value.is_number]
    numbers = {symbol: value for symbol, value in ((R, flow.R), (I, flow.I)) if value.is_number}
    return plain(name, arguments, value.subs(numbers), doc, *texts, lets=named)


def slow_flow_kernels(flow: SlowFlow, detachment: Elimination) -> list[Kernel]:
    """Every function of the slow flow."""
    of_flow, carried = partial(of_R_and_I, flow), offset_stiffness()
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
        # the root of a quotient, which SymPy would take apart
        plain(
            "backbone",
            (A, h),
            sp.sqrt(square),
            "Frequency on the backbone.",
            "(26)",
            "A > 0, h <= 0",
            lets=[(square, flow.backbone**2)],
        ),
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
        Kernel(
            "isolation",
            (A, F_0, reduction, h),
            (
                Branch("inwards", ((h, sp.S.Zero),), flow.isolation_lets[0], (flow.isolation,)),
                Branch("outwards", (), flow.isolation_lets[1], (flow.isolation,)),
            ),
            "Frequency of a state that transmits sqrt(1 - reduction) of what drives it, though it moves.",
            "from (23)",
            "A > 0, F_0 > 0, 0 <= reduction < 1",
        ),
        plain(
            "held",
            (m, preload),
            flow.held,
            "The forcing up to which a mass at rest stays there: that of a state as A tends to 0.",
            "(24)",
            "preload >= 0, -h as A tends to 0",
            looped=False,
        ),
        plain(
            "jacobian",
            (Omega, A, m, zeta, h, h_A),
            tuple(flow.jacobian),
            "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.",
            "(28)",
        ),
        plain(
            "mean_stiffness",
            (A, h, h_A),
            mean_stiffness(),
            "Mean of the stiffness over a cycle of a motion about u = 0, which stays about it where this is positive.",
            "beside (30)",
            amplitude,
        ),
        Kernel(
            "offset_stiffness",
            (Omega, A, h, h_A),
            (
                Branch("over", (carried.far,), (), (carried.over,)),
                Branch("apart", (), (), (carried.apart,)),
            ),
            "What carries a small mean offset back; where the mean stiffness is negative this decides.",
            "beside (30)",
            "Omega > 0, A > 0",
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


def locus_kernels(flow: SlowFlow, along: Along) -> list[Kernel]:
    """What the solvers along the amplitude ask: second derivatives, and what vanishes where a curve changes."""
    of_flow = partial(of_R_and_I, flow)
    common = [
        of_flow("F_OmegaOmega", (Omega, A, zeta, h), flow.F_OmegaOmega, "d2F/dOmega2.", "(24)"),
        of_flow(
            "level",
            (Omega, A, m, zeta, h),
            along.level,
            "The forcing F_0 for which (Omega, A) is a steady state.",
            "(24)",
            "Omega >= 0, A > 0",
        ),
        plain(
            "rest",
            (F_0, m, h, h_A),
            along.rest,
            "F at Omega = 0 as a product: h - c, h + c, and the slope of both along A.",
            "from (24)",
            "F_0 >= m",
            lets=along.rest_lets,
        ),
        plain(
            "intercept",
            (A, h, h_A, h_AA),
            along.intercept,
            "k = h - A h_A, where the tangent of h meets A = 0, and its slope along A.",
            "from (24), (30)",
            "A >= 0",
        ),
    ]
    damped = damped_kernels(along.damped) if along.damped else []
    return [*common, *damped, *(undamped_kernels(along.undamped) if along.undamped else [])]


def slope_kernels(flow: SlowFlow, slopes: Slopes) -> list[Kernel]:
    """Slopes along the response and along the fold locus."""

    def in_derivatives(
        name: str, output: sp.Expr, doc: str, equation: str, there: Mapping[sp.Symbol, sp.Expr] = {}
    ) -> Kernel:
        """there: what R, I and h_A are at the points where it is asked, as far as it is more than anywhere else"""
        known = {symbol: value for symbol, value in there.items() if symbol != R}
        values = {symbol: value for symbol, value in slopes.values.items() if symbol in output.free_symbols}
        if known:
            values = {symbol: sp.factor(value.subs(h_A, known[h_A]).subs(known)) for symbol, value in values.items()}
        anywhere = {R: flow.R, I: flow.I} if R not in there else {I: flow.I, R: there[R]}
        lets = [*((symbol, value) for symbol, value in anywhere.items() if symbol not in known), *values.items()]
        needs = set().union(*(value.free_symbols for _, value in lets))
        order = (Omega, A, m, zeta, h, h_A, h_AA, h_AAA, T)
        return plain(name, [symbol for symbol in order if symbol in needs], output, doc, equation, lets=lets)

    return [
        in_derivatives("Omega_A", slopes.Omega_A, "dOmega/dA along the response.", "from (24)"),
        in_derivatives(
            "level_rise",
            slopes.level,
            "Positive where the level rises with A along the fold locus, negative where it falls.",
            "from (24), (30)",
        ),
        in_derivatives(
            "cusp_bend",
            slopes.cusp,
            "Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum; T = dR/dA.",
            "from (24), (30)",
            slopes.at_cusp,
        ),
        in_derivatives("isola_bend", slopes.isola, "The same at an isola point.", "from (24), (30)", slopes.at_isola),
        plain(
            "isola_hessian",
            (Omega, A, m, zeta, h_AA),
            slopes.hessian,
            "F_AA F_OmegaOmega - F_AOmega^2 at an isola point: negative at a saddle.",
            "from (24), (30)",
            "Omega > 0, A > 0",
        ),
        plain(
            "tail",
            (Omega, F_0, m),
            slopes.tail,
            "An amplitude of the size of that far above resonance.",
            "from (24)",
            "Omega > 0, F_0 >= m",
            lets=slopes.tail_lets,
        ),
    ]


def bound_kernels(results: Results) -> list[Kernel]:
    """What bounds h, and with it the amplitudes."""
    return [
        plain(
            "most_restoring",
            (A, F_0, m, zeta),
            results.bounds.restoring,
            "The largest |h| of a state with this amplitude: F_0 + (A Omega)^2/A at the highest Omega.",
            "from (23)",
            "A > 0, F_0 >= m, zeta > 0",
            lets=results.bounds.restoring_lets,
        ),
        plain(
            "least_restoring",
            (F_0, m),
            results.along[""].least,
            "The |h| of a state at Omega = 0, and the least |h - A h_A| of a fold.",
            "from (24), (30)",
            "F_0 >= m",
        ),
    ]


def step_kernels(results: Results) -> tuple[Kernel, ...]:
    """The last step to an answer; all take the same arguments, of which most need few."""
    flow, arguments = results.flows[""], (Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA)
    return tuple(
        plain(
            f"{kind}_step",
            arguments,
            (*step.changes, step.turn),
            f"By what {', '.join(str(unknown) for unknown in EQUATIONS[kind][1])} change at a {kind}, and how far that "
            "is from linear.",
            "from (24)",
            lets=[(R, flow.R), (I, flow.I), *step.lets],
            to_pairs=step.values,
        )
        for kind, step in results.steps.items()
    )


def damped_kernels(along: Damped) -> list[Kernel]:
    """Cusps, isola points and extrema over Omega for zeta > 0."""
    return [
        plain(
            "fold",
            (A, F_0, m, zeta, h, h_A, k, k_A),
            along.fold,
            "Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega.",
            "from (24), (30)",
            "A > 0, F_0 > m, k^2 >= F_0^2 - m^2",
            lets=along.fold_lets,
        ),
        plain(
            "fold_square",
            (Omega, A, lacks),
            along.fold_square,
            "Omega^2 beside a fold by the R of F = F_A = 0, from the Omega by I and what R lacks of agreeing (`fold`).",
            "from (23)",
            "A > 0",
        ),
        plain(
            "fold_moves",
            (A, k, R),
            along.fold_moves,
            "What F and F_A change by beside a fold, per what vanishes there (`fold`), at its A, Omega and I.",
            "from (24), (30)",
            "A > 0",
        ),
        plain("isola_Omega", (h_A,), along.isola_Omega, "Omega at an isola point.", "from (30), (34)", "h_A >= 0"),
        plain(
            "isola_level",
            (Omega, A, m, zeta),
            along.isola_level,
            "The forcing at an isola point: of R from h rounding leaves nothing where damping is weak.",
            "from (24), (30)",
            "Omega > 0",
            lets=along.isola_level_lets,
        ),
        plain(
            "isola",
            (A, m, zeta, h, h_A, h_AA),
            along.isola,
            "Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A.",
            "from (30), (34)",
            "A > 0, h_A > 0; for m = 0 any h_A",
            lets=along.isola_lets,
        ),
        plain(
            "cusps",
            (A, zeta, h, h_A, h_AA, k),
            along.cusps,
            "F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d.",
            "from (33)",
            "A > 0",
            lets=along.cusps_lets,
        ),
        plain(
            "cusp_R",
            (A, zeta, h_AA, k, X_, T),
            along.cusp_R,
            "R where F_AA = 0 (`cusps`), in two forms: by its tangent, and from F_AA itself.",
            "from (33)",
            "A > 0, X >= 0",
        ),
        plain(
            "cusp",
            (A, m, zeta, h_AA, h_AAA, k, X_, T, R_, root),
            along.cusp,
            "Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0.",
            "from (33)",
            "A > 0, X > 0",
            lets=along.cusp_lets,
        ),
        plain(
            "cusp_balance",
            (A, m, zeta, h, k, X_, T),
            along.cusp_balance,
            "Omega^2 and F_0^2 at a cusp with R from F_A = 0, by an X = Omega^2 that is nearly right, and T (`cusps`).",
            "from (30)",
            "A > 0, X > 0, T not 0",
            lets=along.cusp_balance_lets,
        ),
        plain(
            "turn",
            (Omega, A, m, zeta, h_AA, k),
            along.turn,
            "F_A/2 where F_AOmega = 0, an extremum of F_A over Omega, and its slope along A.",
            "from (30)",
            "Omega > 0, A > 0",
            lets=along.turn_lets,
        ),
        plain(
            "peak",
            (Omega, A, F_0, m, zeta, h_A),
            along.peak,
            "F where F_Omega = 0: an extremum of F over Omega, and its slope along A.",
            "from (24), (34)",
            lets=along.peak_lets,
        ),
        plain(
            "peak_Omega_A",
            (Omega, A, m, zeta, h_A),
            along.peak_Omega_A,
            "dOmega/dA along F_Omega = 0: what a rounding of A does to Omega at a peak.",
            "from (34)",
        ),
    ]


def cell_kernels(along: Along, scene: str) -> tuple[Kernel, ...]:
    """What only intervals are asked for: F_Omega without what is common, where one damping vanishes another form; the
    states at a frequency, and cusps in numbers without scale."""
    if len(SCENES[scene]) > 1:
        return ()
    reduced = plain(
        "F_Omega_reduced",
        (Omega, A, m, zeta, h),
        along.F_Omega_reduced,
        "F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.",
        "(34)",
        lets=along.F_Omega_reduced_lets,
    )
    searched = tuple(replace(one, searched=True) for one in (reduced, *(() if scene else state_cells(along))))
    return searched if scene else (*searched, least_F_A(along.damped), *cusp_cells(along.damped))


def least_F_A(along: Damped) -> Kernel:
    """Whether there are folds at all."""
    kernel = plain(
        "fold_least",
        (zeta, h_A, over_A, apart),
        along.fold_least,
        "F_A/(2 A) without friction as X^2 + b X + c in X = Omega^2, by h/A and h/A - h_A: b, and b^2 - 4 c.",
        "from (30)",
        "A > 0",
    )
    return replace(kernel, searched=True)


def state_cells(along: Along) -> tuple[Kernel, ...]:
    """F along the amplitude: R in both forms first, of which what both hold is taken."""
    return (
        plain(
            "state_R",
            (Omega, A, h, h_A, k),
            along.state_R,
            "R by its definition, and by its tangent along A, which meets A = 0 at k = h - A h_A.",
            "(24)",
        ),
        plain(
            "state",
            (Omega, A, F_0, m, zeta, h_A, h_AA, R),
            along.state,
            "F and its first two derivatives along A, by R (`state_R`).",
            "(24), (30), (33)",
            lets=along.state_lets,
        ),
    )


def cusp_cells(along: Damped) -> tuple[Kernel, ...]:
    """Cusps in numbers without scale: on a cell of amplitudes they hold less beside the values than `cusps`, `cusp`."""
    half_F_A, slope, level = along.cusp_scaled
    return (
        plain(
            "cusps_scaled",
            (A, zeta, h_A, h_AA, kappa),
            along.cusps_scaled,
            "F_AA/2 over (A h_AA)^2 as t^2 + 2 a t + b, t = dR/dA over A h_AA, kappa = k/(A^2 h_AA): a, b, a^2 - b.",
            "from (33)",
            "A > 0, h_AA other than 0",
            lets=along.cusps_scaled_lets,
        ),
        plain("cusp_X", (A, h_A, h_AA, t), along.cusp_X, "Omega^2 by t (`cusps_scaled`).", "from (33)", "A > 0"),
        plain(
            "cusp_scaled",
            (A, m, zeta, h_AA, kappa, X_, t),
            half_F_A,
            "Where F_AA = 0 (`cusps_scaled`): F_A/2, in the form that t and kappa leave narrowest.",
            "from (33)",
            "A > 0, X > 0, h_AA other than 0",
            lets=along.cusp_scaled_lets,
        ),
        plain(
            "cusp_scaled_level",
            (A, m, zeta, h_AA, kappa, X_, t),
            level,
            "F_0 if the F_A/2 of `cusp_scaled` is 0.",
            "from (33)",
            "A > 0, X > 0, h_AA other than 0",
            lets=along.cusp_scaled_lets,
        ),
        plain(
            "cusp_scaled_slope",
            (A, m, zeta, h_AA, kappa, rho, X_, t, scaled_root),
            slope,
            "Slope along A of the F_A/2 of `cusp_scaled`, root = a + t, rho = A h_AAA/h_AA.",
            "from (33)",
            "A > 0, X > 0, h_AA other than 0",
            lets=along.cusp_scaled_lets,
        ),
    )


def undamped_kernels(along: Undamped) -> list[Kernel]:
    """The fold locus for zeta = 0."""
    return [
        plain("undamped_Omega", (h_A,), along.Omega, "Omega of the folds.", "from (30)", "h_A <= 0"),
        plain(
            "fold",
            (F_0, m, k, k_A),
            along.fold,
            "Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A.",
            "from (24), (30)",
            "F_0 > m",
            lets=along.fold_lets,
        ),
        plain(
            "undamped_level", (m, k), along.level, "The forcing of a fold, whose R is k.", "from (24), (30)", "h_A <= 0"
        ),
        plain(
            "undamped_rises",
            (h_AA, h_AAA, k),
            along.rises,
            "The sign of the level's slope along A on the undamped folds; and, where that is 0, of the slope's own.",
            "from (24), (30)",
            "h_A <= 0",
        ),
        plain(
            "undamped",
            (A, h, h_A, h_AA, h_AAA),
            along.factors,
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
