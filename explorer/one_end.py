"""C of a mechanism with two linear pieces, as of a stop on one side: a record along the balance of the mean.

In:  what `derivations.asymmetric.one_end` has of it.
Out: text, to stand behind the generated records: `NAME_of_library`, `NAME_force(u, p)` and `NAME_place(p)`, the u where
     the stop is. p holds k, g, end, rest and side.
"""

from __future__ import annotations

import sympy as sp
from sympy.printing.c import C99CodePrinter

from derivations.asymmetric import one_end
from derivations.asymmetric.sided import Sided

TEMPLATE = """
static const double NAME_pi = PI;

static int NAME_parameters_of(const sf_mechanism *self, const double *design, double *p)
{
    const double DESIGN;
    (void)self;
    if (!(DOMAIN))
        return 0;
    if (RESTS >= 0)
        FIRST;
    else
        SECOND;
    return p[0] > 0 && p[1] > -1 && p[0] < INFINITY && p[2] < INFINITY && fabs(p[3]) < INFINITY;
}

static void NAME_ends(const sf_mechanism *self, const double *p, double *b) { (void)self, b[0] = p[2]; }
static void NAME_jumps(const sf_mechanism *self, const double *p, double *jump) { (void)self, (void)p, jump[0] = 0; }

static double NAME_M(double a) { return a < 0.5 ? M_NEAR_0 : M_OF_A; }
static double NAME_N(double a) { return a < 0.5 ? N_NEAR_0 : N_OF_A; }

/* The angle of contact at A > end: by Newton's method, and halving where that leads out. */
static double NAME_angle(double A, const double *p)
{
    const double g = p[1], wanted = (A - p[2])/A;
    double low = 0, high = NAME_pi, a = fmin(sqrt(2*wanted), 0.5*NAME_pi);
    for (int i = 0; i < 100; i++) {
        const double off = 2*sin(0.5*a)*sin(0.5*a) + g*NAME_M(a) - wanted, slope = sin(a)*(SLOPE);
        if (off > 0)
            high = a;
        else
            low = a;
        double next = a - off/slope;
        if (!(next > low && next < high))
            next = 0.5*(low + high);
        if (fabs(next - a) <= 0x1p-52*a)
            return next;
        a = next;
    }
    return a;
}

/* h, h_A, h_AA, h_AAA, h - A h_A */
static void NAME_known(double A, const double *p, double *out)
{
    const double k = p[0], g = p[1], end = p[2];
    if (A <= end) {
        out[0] = -k*A, out[1] = -k, out[2] = out[3] = out[4] = 0;
        return;
    }
    const double a = NAME_angle(A, p), S = sin(a), C = cos(a), s = SLOPE, E = end/A, N = NAME_N(a);
KNOWN
}

static void NAME_first(ptrdiff_t n, ptrdiff_t wanted, const double *A, const double *p, double *out)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        double known[5];
        NAME_known(A[i], p, known);
        for (ptrdiff_t j = 0; j < wanted; j++)
            out[j*n + i] = known[j];
    }
}

static void NAME_averaged(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out)
{
    (void)self;
    NAME_first(n, 4, A, p, out);
}

static void NAME_averaged_2(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out)
{
    (void)self;
    NAME_first(n, 2, A, p, out);
}

static double NAME_intercept(const sf_mechanism *self, double A, const double *p)
{
    (void)self;
    double known[5];
    NAME_known(A, p, known);
    return known[4];
}

static double NAME_mean_offset(double A, const double *p)
{
    const double a = A > p[2] ? NAME_angle(A, p) : 0;
    return p[3] - p[4]*A*p[1]*NAME_M(a);
}

static double NAME_place(const double *p) { return p[3] + p[4]*p[2]; }

static double NAME_force(double u, const double *p)
{
    const double v = p[4]*(u - p[3]);
    return p[4]*p[0]*(v + p[1]*fmax(v - p[2], 0));
}

static const sf_mechanism NAME_record = {
    .form = SF_FORM,
    .name = "NAME",
    .design_size = SIZE,
    .damping_size = 2,
    .parameters = 5,
    .breakpoints = 1,
    .reach = INFINITY,
    .parameters_of = NAME_parameters_of,
    .damping_of = records_damping_of,
    .is_forcing = records_is_forcing,
    .ends = NAME_ends,
    .jumps = NAME_jumps,
    .averaged = NAME_averaged,
    .averaged_2 = NAME_averaged_2,
    .intercept = NAME_intercept,
    .dissipation = records_dissipation,
    .level = records_level,
    .mean_offset = NAME_mean_offset,
};
static const sf_mechanism *const NAME_of_library = &NAME_record;
"""


class Printer(C99CodePrinter):
    """Powers as products: pow() of one C library is not that of another."""

    def _print_Pi(self, expr: sp.Expr) -> str:
        return "NAME_pi"

    def _print_Pow(self, expr: sp.Expr) -> str:
        base, exponent = expr.as_base_exp()
        if not exponent.is_Integer:
            return str(super()._print_Pow(expr))
        factor = self.parenthesize(base, 100)
        product = "*".join([factor] * abs(int(exponent)))
        return f"(1.0/({product}))" if exponent < 0 else f"({product})"


def text(name: str, force: Sided) -> str:
    """The whole of it."""
    derived, printer = one_end.derive(force), Printer({"math_macros": {}})
    c = printer.doprint
    domain = [f"fabs({c(one.symbol)}) < INFINITY" for one in force.design]
    for one in force.design:
        for bound, sign in ((one.above, ">"), (one.least, ">="), (one.below, "<"), (one.most, "<=")):
            domain += [f"{c(one.symbol)} {sign} {c(bound)}"] if bound is not None else []
    inputs = ", ".join(f"{c(one.symbol)} = design[{i}]" for i, one in enumerate(force.design))

    def assignments(values: tuple[sp.Expr, ...]) -> str:
        return ", ".join(f"p[{i}] = {c(value)}" for i, value in enumerate(values))

    substitutions = {
        "DESIGN": inputs,
        "DOMAIN": " && ".join(domain),
        "RESTS": c(derived.condition),
        "FIRST": assignments(derived.parameters[0]),
        "SECOND": assignments(derived.parameters[1]),
        "M_NEAR_0": c(one_end.in_powers(derived.M).subs(sp.pi, sp.pi.evalf(20))),
        "N_NEAR_0": c(one_end.in_powers(derived.N).subs(sp.pi, sp.pi.evalf(20))),
        "M_OF_A": c(derived.M),
        "N_OF_A": c(derived.N),
        "PI": c(sp.pi.evalf(20)),
        "SLOPE": c(derived.slope),
        "KNOWN": "\n".join(f"    out[{i}] = {c(row)};" for i, row in enumerate(derived.known)),
        "SIZE": str(len(force.design)),
    }
    made = TEMPLATE
    for word in sorted(substitutions, key=len, reverse=True):
        made = made.replace(word, substitutions[word])
    return made.replace("NAME", name)
