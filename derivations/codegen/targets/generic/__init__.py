"""C of kernels whose text holds for numbers of several kinds: a header for each module and kind, and what they share.

In:  `Module`s with the straight-line code of their kernels.
Out: a dict from file name (below `generated/`) to text.

What two kinds have is printed once, in MODULE_generic.h: the header of each defines OF, which makes the names of
functions, and what REAL, ADD, ... are (arithmetic_*.h), and includes it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from ...form import Module
from ...measured import of as measured_of
from ...views import Code, KernelView, RepeatedView, heading, repeated_views, templates
from .. import bounded, interval, pair
from ..calls import CALLS
from ..shared import in_both, without


@dataclass(frozen=True)
class Kind:
    """Numbers of one kind, which are in C alone.

    kernels -- those of a module that are required on them, printed
    name_of -- of a module's functions, and of their header
    choice  -- the condition and the name of each branch of a kernel with several; the last holds where no other does
    number  -- the type
    inline  -- how functions with several branches are declared
    arithmetic -- the header of operations
    """

    kernels: Callable[[Module, Code], list[KernelView]]
    name_of: Callable[[Module], str]
    choice: Callable[[KernelView], list[tuple[str, str]]]
    number: str
    inline: str
    arithmetic: str
    how: str
    meaning: str = "`out` takes the outputs, where there are several."


KINDS = {
    "intervals": Kind(
        interval.in_c,
        interval.name_of,
        interval.choice,
        "sf_interval",
        "static inline",
        "interval",
        "on whole intervals",
        "Each output holds every value that the function of the same name takes on the arguments; `out` takes the "
        "outputs.",
    ),
    "pairs": Kind(pair.in_c, pair.name_of, pair.choice, "sf_pair", "TWOFOLD_INLINE", "pair_angles", "in double-double"),
    "bounded": Kind(
        bounded.in_c,
        bounded.name_of,
        lambda _: [],
        "sf_bounded",
        "static inline",
        "carlson",
        "in double-double with a bound of the error",
    ),
}


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file."""
    environment = templates(Path(__file__).parent)
    result = {}
    for module in modules:
        of_module = code[module.name]
        folder, shared = in_both(module, of_module)
        in_doubles = interval.in_doubles(module)
        repeated = repeated_by(shared, of_module)
        known = {"module": module, "heading": heading(module), "in_doubles": in_doubles}
        if shared:
            result[f"{folder}/{module.name}_generic.h"] = environment.get_template("generic.h.jinja").render(
                **known, kernels=shared, repeated=repeated, facts=measured_of(module).kernels if folder == "c" else None
            )
        for name, kind in KINDS.items():
            printed = kind.kernels(module, of_module)
            if not printed:
                continue
            own = [without(one, shared) for one in printed]
            result[f"native/{kind.name_of(module)}.h"] = environment.get_template("header.h.jinja").render(
                **known,
                kind=kind,
                name=name,
                arithmetic="elementary" if name == "intervals" and module.enclosed else kind.arithmetic,
                prefix=kind.name_of(module),
                includes_shared=own != printed,
                repeated=[one for one in repeated_by(printed, of_module) if own == printed or one not in repeated],
                kernels=[one for one in own if one.branches or len(one.kernel.branches) > 1],
                choices={one.kernel.name: kind.choice(one) for one in printed if len(one.branches) > 1},
            )
    return result


def repeated_by(printed: Sequence[KernelView], code: Code) -> list[RepeatedView]:
    """What these kernels repeat, printed."""
    return repeated_views({one.kernel.name: code[one.kernel.name] for one in printed}, CALLS)
