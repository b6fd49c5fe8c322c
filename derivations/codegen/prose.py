"""Text that people wrote, in what is printed: it stays text, whatever it holds.

In:  a string, and the name of the template that it is printed by.
Out: the same with nothing in it that ends a string, a docstring or a comment of that template's language.
"""

from __future__ import annotations

import re

import sympy as sp
from sympy.printing.pretty.pretty_symbology import greek_unicode


class Prose(str):
    """Text to be read. Where a template prints one, its environment escapes it."""

    __slots__ = ()


def in_python(text: str) -> str:
    """What stands for a text between double quotes, one or three, and means it exactly; it has one line."""
    quoted = text.replace("\\", r"\\").replace('"', r"\"")
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode() for one in quoted)


def in_c(text: str) -> str:
    """What stands for a text in a comment; it has one line."""
    line = one_line(text)
    return line.replace("*/", "* /").replace("/*", "/ *")


def in_markdown(text: str) -> str:
    """What reads as a text in a heading or in a cell of a table; an underscore within a word is none of emphasis."""
    return re.sub(r"[\\`*{}\[\]<>#|$~&!]|(?<!\w)_|_(?!\w)", r"\\\g<0>", one_line(text))


#: names of Greek letters, which TeX's text fonts lack
GREEK = {letter: name for name, letter in greek_unicode.items()}
#: what stands in TeX for a letter
IN_TEX = {one: rf"\{one}" for one in "{}$&#_%"}
IN_TEX |= {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "`": r"\textasciigrave{}"}
IN_TEX |= {"<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}"}
IN_TEX |= {letter: rf"\ensuremath{{{sp.latex(sp.Symbol(name))}}}" for letter, name in GREEK.items()}
#: letters that pdfLaTeX has in its own font and encoding
LETTERS = frozenset({*map(chr, range(0x20, 0x100)), *"–—‘’“”…•€™"} - set("«»ÐÞðþ"))


def in_tex(text: str) -> str:
    """What reads as a text in LaTeX; a letter that pdfLaTeX has no sign for is given by its code point."""
    return "".join(IN_TEX.get(one) or (one if one in LETTERS else f"[U+{ord(one):04X}]") for one in one_line(text))


def one_line(text: str) -> str:
    """A text without line ends and what else is not printed."""
    return "".join(one if one.isprintable() else " " for one in text)


ESCAPES = {"py": in_python, "pyi": in_python, "h": in_c, "c": in_c}


def escaped(text: str, template: str) -> str:
    """A text as the language has it that a template `name.language.jinja` prints."""
    return ESCAPES[template.split(".")[-2]](text)
