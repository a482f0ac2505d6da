"""Formulas as MathML, which browsers show without a script and screen readers read, and a font for them."""

import io
import logging
import re
from importlib.metadata import distribution
from typing import Any

from docutils.nodes import SkipNode, thead
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont
from latex2mathml.converter import convert

CHARACTERS = [
    *range(0x20, 0x7F),
    *(0xAC, 0xB1, 0xB7, 0xD7, 0xF7),
    *(0x302, 0x304, 0x305, 0x332),  # accents
    *range(0x391, 0x3CA),
    *(0x2016, 0x201C, 0x201D, 0x2026, 0x2032, 0x2033, 0x2061, 0x2062, 0x2063),
    *(0x210E, 0x2113, 0x211D),
    *range(0x2190, 0x2194),
    *range(0x21D0, 0x21D5),
    *range(0x2200, 0x2270),
    *(0x22C5, 0x22EE, 0x22EF, 0x2308, 0x2309, 0x230A, 0x230B, 0x23DE, 0x23DF),
    *range(0x1D400, 0x1D434),  # bold
    *range(0x1D434, 0x1D468),  # italic
    *range(0x1D49C, 0x1D4B6),  # script
    *range(0x1D6FC, 0x1D71C),  # Greek italic
]
"""What a formula may contain: the rest of the font, most of it, stays away."""


WRITTEN_OTHERWISE = {"{aligned}": "{align*}", r"\arg": r"\operatorname{arg}\,"}
"""What the converter does not know, and what means the same."""


def mathml(tex: str, display: str = "inline") -> str:
    """Return a formula as MathML.

    Raises:
        ValueError: the converter has left something as it was.
    """
    for known, instead in WRITTEN_OTHERWISE.items():
        tex = tex.replace(known, instead)
    written: str = convert(tex, display=display)
    if re.search(r"[\\$]|&(amp|#x00026);", written):
        raise ValueError(f"latex2mathml does not know all of {tex}")
    return written


def visit_inline(translator: Any, node: Any) -> None:
    """Write a formula within a line."""
    written, above = mathml(node.astext()), node
    while above.parent and not isinstance(above, thead):
        above = above.parent
    if isinstance(above, thead):  # a column must have a name, and that of a formula alone is not always found
        written = written.replace("<math ", f'<math aria-label="{re.sub("<.*?>", "", written)}" ', 1)
    translator.body.append(written)
    raise SkipNode


def visit_block(translator: Any, node: Any) -> None:
    """Write a formula on lines of its own."""
    translator.body.append(f'<div class="formula">{mathml(node.astext(), "block")}</div>')
    raise SkipNode


def font() -> bytes:
    """Return the part of STIX Two Math (SIL Open Font License) that formulas need, as WOFF."""
    logging.getLogger("fontTools").setLevel(logging.WARNING)  # it tells of every sign
    original = TTFont(str(distribution("ziamath").locate_file("ziamath/fonts/STIXTwoMath-Regular.ttf")))
    options = Options()
    options.layout_features = ["ssty"]  # smaller signs for superscripts, such as a prime
    options.hinting = False
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=CHARACTERS)
    subsetter.subset(original)
    original.flavor = "woff"
    written = io.BytesIO()
    original.save(written)
    return written.getvalue()
