"""Statistical linearization by quadrature of Gaussian densities and spectra, and by numerical differentiation."""

from __future__ import annotations

from mpmath import mp, mpf

FAR = 9


def gaussian(v, sigma):
    return mp.exp(-((v / sigma) ** 2) / 2) / (sigma * mp.sqrt(2 * mp.pi))


def mean(f, sigma):
    """E f(v) of an even function."""
    panels = [2 * n * sigma for n in range(FAR)]
    return 2 * mp.quad(lambda v: f(v) * gaussian(v, sigma), panels, method="gauss-legendre")


def resistance(v, mu, zeta, c_2, c_3):
    return mu * mp.sign(v) + 2 * zeta * v + c_2 * abs(v) * v + c_3 * v**3


def damping(sigma_v, *laws):
    return mean(lambda v: v * resistance(v, *laws), sigma_v) / mean(lambda v: v * v, sigma_v)


def over_displacements(level, within, sigma_u, mu, zeta, zeta_2):
    """What changes by ln(sigma_u): what friction has between the levels at sigma_u and next to it."""

    def viscous(x):
        return zeta + zeta_2 * mean(lambda u: u * u, sigma_u * mp.exp(x))

    def friction(x):
        return mu * (within + mp.quad(lambda t: 2 * gaussian(t, 1), [level, level * mp.exp(-x)]))

    return [friction(0), viscous(0), mp.diff(friction, 0), mp.diff(viscous, 0)]


def equivalent_damping(sigma_v, mu, zeta, c_2, c_3):
    slope = mp.diff(lambda x: damping(sigma_v * mp.exp(x), mu, zeta, c_2, c_3), 0)
    return [damping(sigma_v, mu, zeta, c_2, c_3), slope, damping(sigma_v, mu, mpf(0), mpf(0), mpf(0))]


def damping_force(level, within, sigma_u, sigma_v, mu, zeta, c_2, c_3, zeta_2):
    """From the shares of the time and of u^2 where friction acts."""
    within_square = within - 2 * mp.quad(lambda t: (1 - t * t) * gaussian(t, 1), [0, level])
    means = (1, sigma_u**2, 3 * sigma_u**4), (within, within_square * sigma_u**2)

    def others(v, power):
        """Factors of u^0 and u^2."""
        return (resistance(v, 0, zeta, c_2, c_3), 2 * zeta_2 * v)[power]

    def square(v):
        own = sum(others(v, i) * others(v, j) * means[0][i + j] for i in (0, 1) for j in (0, 1))
        return own + 2 * mu * sum(others(v, i) * means[1][i] for i in (0, 1)) + mu**2 * within

    return [mean(square, sigma_v)]


def modulus(Omega, k, c):
    return abs(mp.mpc(k - Omega**2, c * Omega)) ** 2


def response(Omega, k, c):
    slopes = (
        mp.diff(lambda x: -mp.log(modulus(Omega, k * mp.exp(x), c)), 0),
        mp.diff(lambda x: -mp.log(modulus(Omega, k, c * mp.exp(x))), 0),
    )
    return [modulus(Omega, k, c), *slopes]


def steepest(ratio):
    """The extrema over the frequency, from a point near each."""

    def slope(Omega):
        return response(Omega, mpf(1), 2 * ratio)[1]

    low, high = (mp.findroot(lambda w: mp.diff(slope, w), mp.sqrt(1 + sign * 2 * ratio)) for sign in (-1, 1))
    peak = mp.findroot(lambda w: mp.diff(lambda w: modulus(w, mpf(1), 2 * ratio), w), mp.sqrt(1 - 2 * ratio**2))
    return [slope(low), slope(high), 1 / modulus(peak, mpf(1), 2 * ratio)]


def resonance(theta, k, c, slope, G, E_re, E_im, D_re, D_im):
    """The residue by the slope of Z at its root, for roots that move: E is straight there, G a power of Omega."""
    at = mp.log(k) / 2 + 1j * theta

    def adds(p, q, power):
        X = p / 2 + 1j * mp.asin(mp.exp(q - p / 2) / 2)
        W = mp.exp(X)
        by_X = -4 * W**2 * (mp.exp(p) - W**2) + 2 * mp.exp(2 * q) * W**2
        density = G * mp.exp(slope * (X - mp.log(k) / 2))
        return 2 * mp.re(density * W ** (power + 1) / by_X * (mp.mpc(E_re, E_im) + mp.mpc(D_re, D_im) * (X - at)))

    p, q = mp.log(k), mp.log(2 * mp.sqrt(k) * mp.sin(theta))
    # c is 2 sqrt(k) sin(theta), and what is proportional to 1/c takes it as it is
    size = mp.exp(q) / c
    by = ((0, 0), (1, 0), (0, 1))
    return [size * mp.diff(lambda p, q, j=j: adds(p, q, j), (p, q), order) for j in (0, 2) for order in by]


def white(S_0, k, c):
    edges = [0, mp.sqrt(k) / 2, mp.sqrt(k), 2 * mp.sqrt(k), mp.inf]
    return [mp.quad(lambda w, j=j: 2 * S_0 * w**j / modulus(w, k, c), edges) for j in (0, 2)]


def crossings(end, sigma_u, sigma_v):
    """Both ends, outwards: the mean of a velocity that is positive, where the displacement is there."""
    return [2 * gaussian(end, sigma_u) * mean(lambda v: v, sigma_v) / 2]


LINEARIZATION = {
    "over_displacements": ("level within sigma_u mu zeta zeta_2", over_displacements),
    "equivalent_damping": ("sigma_v mu zeta c_2 c_3", equivalent_damping),
    "damping_force": ("level within sigma_u sigma_v mu zeta c_2 c_3 zeta_2", damping_force),
    "response": ("Omega k c", response),
    "steepest": ("ratio", steepest),
    "white": ("S_0 k c", white),
    "crossings": ("end sigma_u sigma_v", crossings),
    "resonance": ("theta k c slope G E_re E_im D_re D_im", resonance),
}
