"""numba: the textbook method compiled; (24) expanded, its roots by companion eigenvalues, folds by bisection in A."""

NAME = "numba"
PACKAGES = ("numba", "scipy")  # numba's linear algebra calls SciPy's LAPACK
WHAT = "np.roots of the expanded quartic at each amplitude; F_A bisected along each branch"


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    import numba
    import numpy as np

    from benchmarks.peers import problem
    from benchmarks.peers.problem import F_0, ZETA, M, answer

    problem.detached = numba.njit(problem.detached)
    averaged, averaged_A = numba.njit(problem.averaged), numba.njit(problem.averaged_A)

    @numba.njit
    def frequencies(A):
        """Positive real roots of (24), rising, and how many."""
        h = averaged(A)
        quartic = np.array(
            [A * A + 0j, 0, 4 * A * A * ZETA**2 + 2 * A * h, 4 * A * ZETA * M, M * M + h * h - F_0 * F_0]
        )
        found = np.roots(quartic)
        kept = np.sort(found.real[(np.abs(found.imag) < 1e-9) & (found.real > 0)])
        return kept

    @numba.njit
    def slope(Omega, A):
        """F_A/2."""
        h, h_A = averaged(A), averaged_A(A)
        return (A * Omega**2 + h) * (Omega**2 + h_A) + 2 * ZETA * Omega * (2 * ZETA * A * Omega + M)

    @numba.njit
    def curve(amplitudes):
        folds = np.empty((16, 2))
        points = count = 0
        before = frequencies(amplitudes[0])
        for i in range(1, amplitudes.size):
            now = frequencies(amplitudes[i])
            points += now.size
            for j in range(now.size if now.size == before.size else 0):
                low, high = amplitudes[i - 1], amplitudes[i]
                sign = slope(before[j], low) > 0
                if sign == (slope(now[j], high) > 0) or count == 16:
                    continue
                for _ in range(60):
                    middle = (low + high) / 2
                    there = frequencies(middle)
                    if there.size != now.size:
                        break
                    if (slope(there[j], middle) > 0) == sign:
                        low = middle
                    else:
                        high = middle
                there = frequencies(low)
                folds[count] = there[min(j, there.size - 1)], low
                count += 1
            before = now
        return points, folds[:count]

    def run(samples):
        return curve(np.linspace(1e-3, 0.65, samples))

    return {f"{samples} amplitudes": (lambda samples=samples: run(samples), answer) for samples in (300, 1000)}
