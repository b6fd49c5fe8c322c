"""The kernels of motions off the centre, of any mechanism.

In:  `Results`.
Out: `off_centre_module`.
"""

from __future__ import annotations

from ...asymmetric.off_centre import (
    F_2,
    L_1,
    L_2,
    M_1,
    M_2,
    B,
    I,
    L_k,
    M_k,
    R,
    X,
    X_x,
    Y,
    Y_y,
    a,
    angle,
    c,
    c_p,
    c_x,
    c_xx,
    c_y,
    c_yy,
    end_p,
    force,
    k,
    load,
    load_p,
    root,
    s,
    s_p,
    side,
    span,
)
from ...extensions.dissipation import I_A, d
from ...kernels import plain
from ...paper.slow_flow import m
from ...results import Results
from ...symbols import F_0, A, Omega, eta, h, zeta
from ..form import Module


def off_centre_module(results: Results) -> Module:
    """In the means c_n of f^(n) and s_n of f^(n) cos psi over a cycle, and what gives these of a step of the force."""
    flow, of, climb = results.flows[""], results.off_centre, results.climb
    generic = {"generic": True, "in_c": False}
    wanted = {**generic, "searched": True}
    of_R = [(R, flow.R.subs(h, -2 * s[0]))]
    known = (F_0, F_2, m, eta, zeta, d, load)
    above = (k, A, a, span, L_2, L_1, M_2, M_1)
    return Module(
        name="off_centre",
        title="Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle",
        inputs=("paper/averaging.py", "paper/slow_flow.py", "asymmetric/off_centre.py"),
        kernels=(
            plain(
                "averaged",
                (A, *c[1:], *s),
                of.averaged,
                "h, h_A, h_AA, h_AAA along the balance of the mean.",
                "(20), (31)",
                "A > 0, c_1 other than 0",
                lets=of.lets,
                **generic,
            ),
            plain(
                "state",
                (Omega, A, force, I, I_A, load, *c[:2], *s[:2]),
                of.state,
                "What vanishes at a steady state: the balance of the mean and F; slopes of each by A and B.",
                "(24) and the mean of (3)",
                "A > 0",
                lets=of_R,
                **generic,
            ),
            plain(
                "fold",
                (R, A, *known, *c[:3], *s[:3]),
                of.fold,
                "What vanishes at a fold, by R, with the force F_0 + F_2 Omega^2: the balance, F along it by "
                "c_1 A/2, and F; slopes of each by A, B and R.",
                "(24), (30) and the mean of (3)",
                "A > 0, R + 2 s_0 > 0",
                lets=of.by_R,
                **generic,
            ),
            plain(
                "ended_state",
                (Omega, A, force, I, I_A, load, c[0], s[0], c_x, c_y, X, Y),
                of.ended.state,
                "What vanishes at a steady state, by coordinates x and y of the motion's ends: the balance of the mean "
                "and F; slopes of each by x and y.",
                "(24) and the mean of (3)",
                "A > 0",
                lets=of_R,
                **wanted,
            ),
            plain(
                "ended_along",
                (A, s[0], c_x, c_y, X, Y),
                of.ended.along,
                "Along the balance, by coordinates of the motion's ends: A's slope, and what F_A gains there by R.",
                "(30) and the mean of (3)",
                "A > 0",
                **wanted,
            ),
            plain(
                "ended_slopes",
                (A, s[0], c_x, c_y, X, Y),
                of.ended.slopes,
                "Slopes of s_0 by coordinates x and y of the motion's ends, and of c_x by y.",
                "the mean of (3)",
                "A > 0",
                enclosed=True,
                **generic,
            ),
            plain(
                "ended_fold",
                (R, A, *known, c[0], s[0], c_x, c_y, c_xx, c_yy, X, Y, X_x, Y_y),
                of.ended.fold,
                "What vanishes at a fold, by R, with the force F_0 + F_2 Omega^2, by coordinates x and y of the "
                "motion's ends: the balance, F along it times A/2, and F; slopes of each by x, y and R.",
                "(24), (30) and the mean of (3)",
                "A > 0, R + 2 s_0 > 0",
                lets=of.by_R,
                **wanted,
            ),
            plain(
                "frequency_by_phase",
                (A, R, I, m, zeta, h),
                of.frequency,
                "Omega of a motion by I; and its square by R.",
                "(23)",
                "A > 0, zeta > 0",
                **generic,
            ),
            plain(
                "versine",
                (k,),
                of.versine,
                "The mean of (1 - cos psi)^(k + 1) over that of (1 - cos psi)^k.",
                "the mean of (3)",
                "k >= 0",
                **generic,
            ),
            plain(
                "beside",
                (B, c[3], s[2]),
                of.beside,
                "(c_1^2 - s_1^2)/c_1 of an odd force without a load where f_0 = 0 and B is not 0, with c_3 and s_2 of "
                "some B between 0 and there.",
                "the mean of (3)",
                "c_3 other than 0",
                **wanted,
            ),
            plain(
                "moved",
                (A, *c[1:], *s[1:], *c_p, *s_p, load_p),
                of.moved.values,
                "B_p, h_p, h_Ap, h_AAp along the balance at a fixed A, by what a parameter does to means and load.",
                "(20), (31)",
                "A > 0, c_1 other than 0",
                lets=of.moved.lets,
                **generic,
            ),
            plain(
                "moved_at_end",
                (side, c[1], s[1], c_p[0], load_p, end_p),
                (of.moved.at_end,),
                "A_p of a motion that comes to an end of a piece: at B + A for side = 1, at B - A for side = -1.",
                "the mean of (3)",
                "side c_1 other than s_1",
                **generic,
            ),
            plain(
                "begin",
                (A, a, root, angle),
                climb.begin,
                "L_-1, L_0, M_-1, M_0 of a step at B + a that the motion passes at psi = angle.",
                "the mean of (3)",
                "root = sqrt(A^2 - a^2)",
                enclosed=True,
                generic=True,
            ),
            plain(
                "up",
                above,
                climb.up,
                "L_k and M_k from the two below each; span = A^2 - a^2.",
                "the mean of (3)",
                "k >= 1",
                generic=True,
            ),
            plain(
                "down",
                (k, A, a, root, L_1, L_k, M_1, M_k),
                climb.down,
                "L_(k-2) and M_(k-2) from the two above each.",
                "the mean of (3)",
                "root > 0",
                enclosed=True,
                generic=True,
            ),
        ),
    )
