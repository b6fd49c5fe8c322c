"""In: a published expression. Out: the same as MathML, as a browser sets it without help from anywhere."""

from __future__ import annotations

import html
import re
from typing import Any
from xml.dom.minidom import Element

import sympy as sp
from sympy.printing.mathml import MathMLPresentationPrinter

#: what stands over a letter
DOTS = {"dot": "\u02d9", "ddot": "\u00a8"}
#: names that are written otherwise than they are spelt: a letter, and what stands below it
WRITTEN = {"lam": ("λ", ""), "F_k_x": ("F_k(x)", ""), "F_k_u": ("F_k(u)", "")}
#: derivatives that are named as one symbol, d over d
DERIVATIVES = {"dH_i_dA": (("d", "H", "i"), ("d", "A", ""))}


class _Printer(MathMLPresentationPrinter):
    """Sets the paper's names: dots over letters, quotients of differentials."""

    def _of(self, kind: str, *children: Any) -> Element:
        made: Element = self.dom.createElement(kind)
        for part in children:
            made.appendChild(self.dom.createTextNode(part) if isinstance(part, str) else part)
        return made

    def _with(self, letter: str, below: str) -> Element:
        return self._of("msub", self._of("mi", letter), self._of("mi", below)) if below else self._of("mi", letter)

    def _print_Symbol(self, symbol: sp.Symbol, style: str = "plain") -> Element:
        letter, _, dots = symbol.name.rpartition("_")
        if dots in DOTS:
            return self._of("mover", self._of("mi", letter), self._of("mo", DOTS[dots]))
        if symbol.name in DERIVATIVES:
            derivatives = ((d, self._with(one, below)) for d, one, below in DERIVATIVES[symbol.name])
            return self._of("mfrac", *(self._of("mrow", self._of("mi", d), one) for d, one in derivatives))
        if symbol.name in WRITTEN:
            name, _, below = WRITTEN[symbol.name][0].partition("_")
            return self._with(name, below.partition("(")[0]) if "(" not in below else self._argument(name, below)
        found: Element = super()._print_Symbol(symbol, style)
        return found

    def _argument(self, name: str, below: str) -> Element:
        """A function of the letter in brackets."""
        index, _, letter = below.partition("(")
        brackets = (self._of("mo", "("), self._of("mi", letter.rstrip(")")), self._of("mo", ")"))
        return self._of("mrow", self._with(name, index), *brackets)


def mathml(value: sp.Expr) -> str:
    """What stands in `math` for an expression."""
    printer = _Printer({"mul_symbol": "⁢", "fold_short_frac": False})
    drawn: str = printer.doprint(value)
    # letters as they are, but for those that would be markup
    return re.sub(r"&(?!lt;|gt;|amp;)#?\w+;", lambda entity: html.unescape(entity[0]), drawn)
