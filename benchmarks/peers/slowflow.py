"""slowflow itself, as it is installed for this repository."""

NAME = "slowflow"
PACKAGES = ()
WHAT = "response curve with stability and folds in one call"


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    from benchmarks.peers.problem import DELTA_H, F_0, LAM, MU, OMEGA_MAX, OMEGA_MIN, R_STIFF, ZETA, answer
    from slowflow import Isolator

    def curve(samples):
        # anew each time, since an isolator remembers some of its answers
        iso = Isolator(lam=LAM, r=R_STIFF, delta_h=DELTA_H, mu=MU, zeta=ZETA)
        found = iso.frequency_response(F_0, samples=samples, Omega=(OMEGA_MIN, OMEGA_MAX))
        folds = iso.saddle_nodes(F_0)
        return found.A.size, zip(folds.Omega, folds.A, strict=True)

    return {f"{samples} samples": (lambda samples=samples: curve(samples), answer) for samples in (300, 1000)}
