"""PyDSTool: its last release imports modules that Python 3.10 removed, so it is asked to import and nothing more."""

NAME = "PyDSTool"
PACKAGES = ("PyDSTool", "numpy<1.24", "scipy<1.10")  # the newest that it imports from
WHAT = "continuation"


def prepare():
    """No variant: says why."""
    import PyDSTool

    raise NotImplementedError(f"PyDSTool {PyDSTool.__version__} imports here; an adapter is to be written")
