"""The kernels of a force that is known by its values.

In:  `Results`.
Out: `sampled_module`.
"""

from __future__ import annotations

from ...forces.quadrature import c, s
from ...forces.sampled import b, f, lets, lost, terms_lets
from ...kernels import plain
from ...paper.restoring_force import ORDERS
from ...results import Results
from ...symbols import A
from ..form import Module


def sampled_module(results: Results) -> Module:
    """What stands under its integrals, and what ends of its pieces add to them."""
    of = results.sampled
    values, below = f[: ORDERS + 1], lost[:ORDERS]
    generic = {"generic": True}
    beyond = "A > b > 0"
    ends = [
        plain(
            f"bent_end_{lowest}",
            (A, b, *lost[lowest:]),
            value,
            f"What a breakpoint adds to h_A{'A' * ORDERS}; derivatives of order {lowest} are the first to be lost.",
            "(31)",
            beyond,
            lets=lets,
            enclosed=True,
            in_c=False,
            **generic,
        )
        for lowest, value in enumerate(of.bent_end)
    ]
    return Module(
        name="sampled",
        title="The average of a force that is known by its values and those of its derivatives, u = A sine",
        inputs=("forces/quadrature.py", "forces/sampled.py"),
        kernels=(
            plain("at_rest", (f[0],), of.at_rest, "h as A tends to 0.", "(20)", "any", **generic),
            plain(
                "averaged_terms",
                (s, *values),
                of.averaged,
                "Under the integrals of h, h_A, h_AA, h_AAA over the quarter cycle.",
                "(20)-(22), (31)",
                "any",
                **generic,
            ),
            plain(
                "averaged_end",
                (A, b, *below),
                of.averaged_end,
                "What a breakpoint adds to h_A, h_AA, h_AAA.",
                "(21), (22), (31)",
                beyond,
                lets=lets,
                **generic,
            ),
            plain(
                "intercept_terms",
                (A, s, c, f[2]),
                of.intercept,
                "Under the integral of h - A h_A, which `at_rest` adds to.",
                "from (20)",
                "any",
                **generic,
            ),
            plain(
                "intercept_end",
                (A, b, *lost[:2]),
                of.intercept_end,
                "What a breakpoint adds to h - A h_A.",
                "from (20)",
                beyond,
                lets=lets,
                **generic,
            ),
            plain(
                "harmonics_terms",
                (s, *values),
                of.harmonics,
                "Under the integrals of h_3 and three derivatives, then of h_5.",
                "beyond (20)",
                "any",
                lets=terms_lets,
                **generic,
            ),
            plain(
                "harmonics_end",
                (A, b, *below),
                of.harmonics_end,
                "What a breakpoint adds to the three derivatives of h_3, then of h_5.",
                "beyond (20)",
                beyond,
                lets=lets,
                **generic,
            ),
            plain(
                "bent_terms",
                (s, f[0], f[ORDERS + 1]),
                of.bent,
                f"Under the integrals of h and h_A{'A' * ORDERS}.",
                "(20), (31)",
                "any",
                enclosed=True,
                in_c=False,
                **generic,
            ),
            *ends,
        ),
    )
