"""What sheets of machines ask of each law beside its pieces: shares of time by shape, and where it is fastest."""

from __future__ import annotations

from collections.abc import Sequence

from engine.laws.base import Shapes
from workbook.book.declare import Quantity, Sheet, calc
from workbook.laws.family import ShapeFormulas
from workbook.laws.library import NamedLaw

WORDS = {
    "flat_up": "constant, accelerating",
    "flat_down": "constant, braking",
    "sine_up": "quarter sine, accelerating",
    "sine_down": "quarter sine, braking",
    "ramp_up": "straight line, accelerating",
    "ramp_down": "straight line, braking",
}


def shapes_table(sheet: Sheet, laws: Sequence[NamedLaw]) -> None:
    """Declare the table ``shapes``: for each law the shares of its time on stages of each shape."""
    values = [one.law.shapes() or Shapes() for one in laws]
    sheet.table(
        "shapes", "Laws, in the order of the sheet Laws", len(laws),
        listed(laws),
        *(calc(name, words, "", "",
               [one.own(getattr(one.page.shapes or ShapeFormulas(), name)) for one in laws],
               [getattr(share, name) for share in values])
          for name, words in WORDS.items()),
    )  # fmt: skip


def listed(laws: Sequence[NamedLaw]) -> Quantity:
    """Return the column that names each law."""
    formulas = [f"=INDEX(law_code,{one.number})" for one in laws]
    return calc("law", "law", "", "", formulas, [one.name for one in laws])


def fastest_formulas(laws: Sequence[NamedLaw]) -> list[str]:
    """Return for each law the formula of the first ξ at which v is largest."""
    return [one.own(one.page.fastest) for one in laws]
