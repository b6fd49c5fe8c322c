"""SKHiPPR: harmonic balance and Koopman-Hill stability; not on PyPI, so it is asked for and nothing more."""

NAME = "SKHiPPR"
PACKAGES = ("skhippr",)
WHAT = "harmonic balance"


def prepare():
    """No variant: says why."""
    import skhippr

    raise NotImplementedError(f"{skhippr.__name__} imports here; an adapter is to be written")
