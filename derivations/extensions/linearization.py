"""Beside (3): stationary random vibration by statistical linearization.

In:  the equation of motion (3) with a stationary Gaussian excitation w(tau) in the place of F_0 cos.
Out: `Formulas`: equivalent damping, mean square of the damping force, the response of the linear oscillator that takes
     the place of (3), and how fast it moves with that oscillator's stiffness and damping.

The linear oscillator u'' + c u' + k u = w is the one whose force misses that of (3) least in the mean square (Caughey):

    k = E[u f(u)]/sigma_u^2   c = E[v r]/sigma_v^2,   r = mu sign(v) + 2 (zeta + zeta_2 u^2) v + c_2 |v| v + c_3 v^3

as displacement u and velocity v = u' of a stationary Gaussian motion are independent. Friction may end where |u| passes
level sigma_u; `within` is the share of the time below. A narrow-band motion has an amplitude A of the Rayleigh
distribution, so that k is a mean of what (20) gives at each amplitude: E[u f] = -E[A h]/2.

Of an excitation with the one-sided power spectral density G(Omega)

    sigma_u^2 = I_0,  sigma_v^2 = I_2,    I_j = int G Omega^j/Z dOmega,    Z = (k - Omega^2)^2 + c^2 Omega^2

With p = ln k, q = ln c and x = 1 - Omega^2/k the slopes of -ln Z, of which those of ln I_j are weighted means, are

    by p  -2 x/z,   z = x^2 + 4 r^2 (1 - x),   r = c/(2 sqrt(k))        by q  -2 c^2 Omega^2/Z, between -2 and 0

Where G goes as Omega^s, and jumps by dG at some frequencies, the slope by p at the same damping ratio has no resonance:

    dI_j/dp + (dI_j/dq)/2 = int (s + j - 3)/2 G Omega^j/Z dOmega + sum dG Omega^(j+1)/(2 Z)

as Z is homogeneous (`_check_scales`). The poles of 1/Z next to the real axis, at ln Omega = p/2 +- i theta with
sin(theta) = r, are what makes a quadrature of I_j slow: `resonance` has what they add to it in closed form.

Under a load, and where f is not odd, u has a mean m by E[f] = load, and k = E[(u - m) f]/sigma_u^2. With
x = (u - m)/sigma_u the averages A_n = E[He_n(x) (f - load)] are sigma_u^n times the derivatives of A_0 by the mean, and
A_0 obeys the heat equation of time sigma_u^2/2 (`_check_mean`). So those of a mean m + sigma_u d and a mean square
sigma_u^2 (1 + e) are a power series in d and e, with the A_n at the first for coefficients: that bounds them on a box.
As E[He_n^2] = n!, higher orders are bounded by the mean square of f.

White noise has a constant two-sided density S_0 (G = 2 S_0): its I_j follow from the moments of the linear oscillator.
Under it the density of u and v solves the Fokker-Planck equation, in a form that `_check_density` proves.
"""

from __future__ import annotations

import functools
import itertools

import sympy as sp

from ..claims import claim
from ..kernels import Formulas, Lets
from ..paper.averaging import cycle_integral
from ..symbols import A, Omega, c_2, c_3, mu, psi, u, zeta, zeta_2

#: root mean squares of displacement and velocity; two-sided density of white noise
sigma_u, sigma_v, S_0 = sp.symbols("sigma_u sigma_v S_0", positive=True)
#: stiffness and damping of the linear oscillator; its damping ratio
k, c, ratio = sp.symbols("k c ratio", positive=True)
#: a displacement, as the end of the first piece
end = sp.Symbol("end", positive=True)
#: 1 - Omega^2/k, and Z/k^2
x, z = sp.symbols("x z", real=True)

#: where friction ends, over sigma_u; the share of the time in which it acts, erf(level/sqrt(2)); 1 then, 0 else
level, within = sp.symbols("level within", positive=True)
_acts = sp.Symbol("acts")

_v = sp.Symbol("v", positive=True)
#: over a cycle of one energy int |v| |du| and int r |du|

#: a pole: its angle, sin(theta) = ratio; of the density there ln G and its slope by ln(Omega)
theta, slope = sp.symbols("theta slope", real=True)
G = sp.Symbol("G", positive=True)
#: at ln(Omega) = X, int dx/(x - X) less what quadrature has for it, and its slope by X: real and imaginary parts
E_re, E_im, D_re, D_im = sp.symbols("E_re E_im D_re D_im", real=True)
#: of arguments
ORDER = (Omega, end, level, within, sigma_u, sigma_v, S_0, theta, k, c)
ORDER += (slope, G, E_re, E_im, D_re, D_im, ratio, mu, zeta, c_2, c_3, zeta_2)


def _mean(of_v: sp.Expr, sigma: sp.Symbol) -> sp.Expr:
    """E of an even polynomial of a Gaussian number, written for positive ones."""
    return sp.expand(sp.Add(*(factor * sigma**n * _moment(n) for (n,), factor in sp.Poly(of_v, _v).terms())))


def _mean_over_u(of_u: sp.Expr) -> sp.Expr:
    """E of an even polynomial of u, with what acts below the end."""
    ends = {0: sp.oo, 1: level, 2: level}
    terms = sp.Poly(of_u, u, _acts).terms()
    return sp.expand(sp.Add(*(factor * sigma_u**n * _moment(n, ends[acts]) for (n, acts), factor in terms)))


#: density of |v| where the root mean square of v is 1, and its integral up to `level`
_DENSITY = sp.sqrt(2 / sp.pi) * sp.exp(-(_v**2) / 2)
_FRACTION = sp.erf(level / sp.sqrt(2))


@functools.cache
def _moment(power: int, to: sp.Expr = sp.oo) -> sp.Expr:
    """E[|v|^power] of a Gaussian number with the root mean square 1, of |v| up to an end; by parts as rho' = -v rho."""
    if power == 0:
        return sp.S.One if to == sp.oo else within
    at_start = _DENSITY.subs(_v, 0) if power == 1 else 0
    at_end = 0 if to == sp.oo else to ** (power - 1) * _DENSITY.subs(_v, to)
    higher = (power - 1) * _moment(power - 2, to) if power > 1 else 0
    return sp.expand(higher + at_start - at_end)


def linearization() -> Formulas:
    """Statistical linearization of (3)."""
    of = Formulas(ORDER, domain="sigma_v > 0")
    _check_least_squares()
    _check_cycles()
    _check_fraction()
    _check_mean()
    force = mu + 2 * zeta * _v + c_2 * _v**2 + c_3 * _v**3
    of_both = force.subs({mu: _acts * mu, zeta: zeta + zeta_2 * u**2})

    @of.kernel("(3)", "level > 0, sigma_u > 0")
    def over_displacements() -> tuple[sp.Expr, ...]:
        """Friction and viscous damping ratio in the mean over u, then their slopes by ln(sigma_u)."""
        found = [_mean_over_u(of_both.coeff(_v, n) / (2 if n else 1)) for n in (0, 1)]
        apart = (one.subs({within: _FRACTION.subs(level, end / sigma_u)}) for one in found)
        slopes = (sigma_u * sp.diff(one, sigma_u).subs(end, level * sigma_u) for one in apart)
        return *found, *map(sp.simplify, slopes)

    @of.kernel("(3)")
    def equivalent_damping() -> tuple[sp.Expr, ...]:
        """Damping of the linear oscillator, its slope by ln(sigma_v), and what of it is dry friction's.

        The slope of its logarithm rises with sigma_v: that slope's own has no negative term over the square of it.
        """
        found = sp.collect(sp.expand(_mean(_v * force, sigma_v) / sigma_v**2), sigma_v)
        slope = sp.expand(sigma_v * sp.diff(found, sigma_v))
        rises = sp.Add.make_args(sp.expand(found * sigma_v * sp.diff(slope, sigma_v) - slope**2))
        claim(
            "`d ln(c)/d ln(sigma_v)` increases with `sigma_v`", not any(one.could_extract_minus_sign() for one in rises)
        )
        return found, slope, found.coeff(sigma_v, -1) / sigma_v

    text = "Mean square of the damping force of (3)."
    square = _mean_over_u(_mean(sp.expand(of_both**2), sigma_v))
    of.add("damping_force", sp.collect(square, sigma_v), text, "(3)", "level > 0")
    _response(of)
    _resonance(of)
    _check_density()

    @of.kernel("(3)", "k > 0, c > 0")
    def white() -> tuple[sp.Expr, sp.Expr]:
        """Mean squares of displacement and velocity of the linear oscillator under white noise.

        Moments of u' = v, v' = -c v - k u + w: the noise adds 2 pi S_0 to E[v^2] in a unit of time.
        """
        uu, uv, vv = sp.symbols("uu uv vv")
        stays = (2 * uv, vv - c * uv - k * uu, -2 * c * vv - 2 * k * uv + 2 * sp.pi * S_0)
        found = sp.solve(stays, (uu, uv, vv), dict=True)[0]
        return found[uu], found[vv]

    @of.kernel("Rice", "sigma_u > 0, sigma_v > 0", arguments=(end, sigma_u, sigma_v))
    def crossings() -> sp.Expr:
        """How often in a unit of tau a Gaussian motion passes u = end or u = -end outwards."""
        density = sp.exp(-(end**2) / (2 * sigma_u**2)) / (sp.sqrt(2 * sp.pi) * sigma_u)
        return sp.simplify(2 * density * _mean(_v, sigma_v) / 2)

    return of


def _check_fraction() -> None:
    """The slope of ln(within) by ln(level) falls: its own is a square times (1 - level^2) within - level within'."""
    by_level = sp.diff(_FRACTION, level)
    claim("`within` is `erf(level/sqrt(2))`: its slope is the density", by_level, _DENSITY.subs(_v, level))
    own = (1 - level**2) * _FRACTION - level * by_level
    slope = sp.diff(level * by_level / _FRACTION, level)
    claim(
        "second derivative of `ln(within)` by `ln(level)` up to a positive factor",
        sp.expand(slope * _FRACTION**2 / by_level - own),
    )
    claim("this second derivative is 0 at `level = 0`", own.subs(level, 0))
    claim("this second derivative decreases with `level`", sp.simplify(sp.diff(own, level) + 2 * level * _FRACTION))


def _check_least_squares() -> None:
    """What misses a force least in the mean square, by the moments of the force and of what it is linear in."""
    misses, of_force, product, square = sp.symbols("factor force product square", positive=True)
    error = of_force - 2 * misses * product + misses**2 * square
    claim(
        "`k = E[u f]/E[u^2]` minimizes `E[(f - k u)^2]`", sp.solve(sp.diff(error, misses), misses)[0] - product / square
    )


def _check_mean() -> None:
    """Averages about a mean, by the mean and by sigma_u: `native/exact/offset.h` takes these identities."""
    m = sp.Symbol("m", real=True)
    at = (u - m) / sigma_u
    density = sp.exp(-(at**2) / 2) / (sp.sqrt(2 * sp.pi) * sigma_u)
    by_m, by_sigma = (sp.expand(sp.diff(sp.expand_log(sp.log(density), force=True), by)) for by in (m, sigma_u))
    hermite = [2 ** sp.Rational(-n, 2) * sp.hermite(n, at / sp.sqrt(2)) for n in range(6)]
    for n, (one, following) in enumerate(itertools.pairwise(hermite)):
        claim(
            f"`sigma_u dA_{n}/dm = A_{n + 1}`, by the densities of both averages",
            sigma_u * (sp.diff(one, m) + one * by_m),
            following,
        )
    claim(
        "`A_0` obeys the heat equation `d A_0/d(sigma_u^2/2) = d^2 A_0/dm^2`",
        by_sigma / sigma_u,
        sp.diff(by_m, m) + by_m**2,
    )
    claim("`A_1/sigma_u` is `E[(u - m) f]/sigma_u^2`", sp.expand(hermite[1] / sigma_u - (u - m) / sigma_u**2))
    for n in range(5):
        of_x = sp.expand(hermite[n].subs(u, m + sigma_u * _v) ** 2)
        claim(f"`E[He_{n}^2] = {n}!`", _mean(of_x, sp.S.One) - sp.factorial(n))

    t, d, e = sp.symbols("t d e", real=True)
    series = sp.exp(d * t + e * t**2 / 2)
    claim("`exp(d t + e t^2/2)` has the slope `(d + e t)` times itself", sp.diff(series, t) - (d + e * t) * series)
    terms = [sp.S.One, d]
    for n in range(1, 6):
        terms.append((d * terms[n] + e * terms[n - 1]) / (n + 1))
        claim(
            f"coefficient of `t^{n + 1}` in this series by the two before",
            sp.expand(sp.diff(series, t, n + 1).subs(t, 0) / sp.factorial(n + 1) - terms[-1]),
        )


def _check_cycles() -> None:
    """Each power of u over a cycle, then over the Rayleigh distribution v exp(-v^2/2) of the amplitude sigma_u v."""
    for power in (1, 3, 5, 7):
        over_cycle = cycle_integral((A * sp.cos(psi)) ** (power + 1), sp.S.Zero, 2 * sp.pi) / (2 * sp.pi)
        rayleigh = sp.sqrt(sp.pi / 2) * _moment(power + 2)
        claim(
            f"`E[u f]` is the mean over Rayleigh-distributed amplitudes, `f = u^{power}`",
            over_cycle.subs(A, sigma_u) * rayleigh,
            _mean(_v ** (power + 1), sigma_u),
        )


def _response(of: Formulas) -> None:
    """-ln Z and its slopes, with bounds of these that hold at every frequency."""
    Z = (k - Omega**2) ** 2 + c**2 * Omega**2
    _check_scales(Z)
    square = sp.Symbol("Z", positive=True)
    by_k = -2 * k * (k - Omega**2) / square
    by_c = -2 * c**2 * Omega**2 / square
    for slope, by in ((by_k, k), (by_c, c)):
        claim(f"derivative of `-ln Z` by `ln {by}`", slope.subs(square, Z) + by * sp.diff(sp.log(Z), by))
    text = "Z, and the slopes of -ln Z by ln k and ln c."
    of.add("response", Lets([(square, Z)], (square, by_k, by_c)), text, "(3)", "Omega > 0, k > 0, c > 0")

    scaled = x**2 + 4 * ratio**2 * (1 - x)
    claim(
        "`Z = k^2 (x^2 + 4 ratio^2 (1 - x))`, `x = 1 - Omega^2/k`, `ratio = c/(2 sqrt(k))`",
        (Z - k**2 * scaled.subs({ratio: c / (2 * sp.sqrt(k)), x: 1 - Omega**2 / k})),
    )
    slope = -2 * x / scaled
    # it is stationary at x = 2 ratio and -2 ratio, and x does not exceed 1
    at = sp.solve(sp.numer(sp.together(sp.diff(slope, x))), x)
    claim(
        "the derivative by `ln k` is stationary at `x = 2 ratio` and `x = -2 ratio`",
        sp.prod([1 - one / (2 * ratio) for one in at]).equals(0) is True,
    )
    steep, flat = (sp.factor(slope.subs(x, sign * 2 * ratio)) for sign in (1, -1))
    least = sp.solve(sp.diff(scaled, x), x)[0]
    # by p once more: x rises with p by 1 - x
    again = sp.factor(sp.diff(slope, x) * (1 - x) + sp.diff(slope, ratio) * (-ratio / 2))
    claim("second derivative of `-ln Z` by `ln k`", again - sp.factor(slope**2 + slope - 2 / scaled))
    text = "Of the slope of -ln Z by ln k the least and the largest, and the largest k^2/Z, at any frequency."
    bounds = (steep, flat, sp.factor(1 / scaled.subs(x, least)))
    of.add("steepest", bounds, text, "(3)", "0 < ratio < 1/2")


def _check_scales(Z: sp.Expr) -> None:
    """Z is homogeneous, of the order 2 in k, sqrt(Omega) and sqrt(c): so by parts the slope at a damping ratio."""
    euler = k * sp.diff(Z, k) + (c * sp.diff(Z, c) + Omega * sp.diff(Z, Omega)) / 2
    claim("`Z = (k - Omega^2)^2 + c^2 Omega^2` is homogeneous (Euler's theorem)", sp.expand(euler - 2 * Z))


def _resonance(of: Formulas) -> None:
    """What a pole of 1/Z adds to a quadrature of I_0 and I_2, by its residue, and to their slopes by p and q.

    With X = ln(Omega) the integrand is G Omega^(j+1)/Z: without R/(X - X_p) of the pole X_p = p/2 + i theta, and of the
    conjugate one, it is smooth. E(X_p) is the integral of 1/(X - X_p) less its quadrature.
    """
    p, q, middle = sp.symbols("p q middle", real=True)
    X, there = sp.symbols("X there")
    pole, damped = p / 2 + sp.I * theta, sp.exp(q)
    own = sp.exp(p / 2) * 2 * sp.sin(theta)
    Z = (sp.exp(p) - sp.exp(2 * X)) ** 2 + own**2 * sp.exp(2 * X)
    steep = 4 * sp.I * damped * sp.exp(p / 2) * sp.cos(theta) * sp.exp(2 * pole)
    claim("`1/Z` has a pole at `ln(Omega) = p/2 + i theta`", sp.expand(Z.subs(X, pole).rewrite(sp.exp)))
    slope_of_Z = sp.diff(Z, X).subs(X, pole) - steep.subs(damped, own)
    claim("derivative of `Z` by `ln(Omega)` at this pole", sp.expand(slope_of_Z.rewrite(sp.exp)))

    def slope_by(one: sp.Expr, by: sp.Symbol) -> sp.Expr:
        """Its slope, where theta moves as ln sin(theta) = q - p/2 - ln 2 does."""
        turns = sp.diff(q - p / 2, by) / sp.diff(sp.log(sp.sin(theta)), theta)
        return sp.diff(one, by) + turns * sp.diff(one, theta)

    # near the pole: E; logarithm of the residue, with G over that where ln(Omega) is p/2
    left = E_re + sp.I * E_im + (D_re + sp.I * D_im) * (pole - there)
    found: list[sp.Expr] = []
    for j in (0, 2):
        residue = slope * (pole - middle) + (j + 1) * pole - sp.expand_log(sp.log(steep), force=True)
        size = G * k ** sp.Rational(j - 2, 2) / (2 * c * sp.cos(theta))
        factors = [left, *(slope_by(residue, by) * left + slope_by(left, by) for by in (p, q))]
        for factor in factors:
            real, imaginary = sp.expand(factor.subs({there: pole, middle: p / 2})).as_real_imag()
            # of both poles together: twice the real part of the residue
            turned = (slope + j - 1) * theta
            found.append(size * (real * sp.sin(turned) + imaginary * sp.cos(turned)))
    text = "What a pole of 1/Z adds to I_0, its slopes by ln k and ln c, then to I_2 and its slopes."
    of.add("resonance", found, text, "(3)", "0 < theta < pi/2, k > 0, c > 0")


def _check_density() -> None:
    """Of u and v under white noise: p = w q, where w is the density of a velocity that a force s(v) alone damps."""
    D = sp.pi * S_0
    v = sp.symbols("v", real=True)
    q, r, f, V = sp.Function("q")(u, v), sp.Function("r")(u, v), sp.Function("f")(u), sp.Function("V")(u)
    S = sp.Function("S")(v)
    w, s = sp.exp(-S / D), sp.diff(S, v)

    def flux(p: sp.Expr, force: sp.Expr, damping: sp.Expr) -> sp.Expr:
        return (force + damping) * p + D * sp.diff(p, v)

    claim(
        "the flux of a density `w q` along `v` is `w ((f + r - s) q + pi S_0 q_v)`",
        sp.simplify(flux(w * q, f, r) / w - (f + r - s) * q - D * sp.diff(q, v)),
    )
    density = sp.exp(-2 * zeta / D * (v**2 / 2 + V))
    flow = sp.diff(flux(density, sp.diff(V, u), 2 * zeta * v), v) - v * sp.diff(density, u)
    claim("with viscous damping this density solves the stationary Fokker-Planck equation", sp.simplify(flow))
