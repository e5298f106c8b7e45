"""What sheets of machines ask of each law beside its pieces: shares of time by shape, and where it is fastest."""

from __future__ import annotations

from engine.laws import Law
from engine.laws.base import Shapes
from workbook.book.chart import in_scope
from workbook.book.declare import Sheet, calc, constant
from workbook.laws.registry import FAMILIES
from workbook.laws.stack import CODES

WORDS = {
    "flat_up": "constant, accelerating",
    "flat_down": "constant, braking",
    "sine_up": "quarter sine, accelerating",
    "sine_down": "quarter sine, braking",
    "ramp_up": "straight line, accelerating",
    "ramp_down": "straight line, braking",
}


def shapes_table(sheet: Sheet, library: dict[str, Law]) -> None:
    """Declare the table ``shapes``: for each law the shares of its time on stages of each shape."""
    values = [library[code].shapes() or Shapes() for code in CODES]
    sheet.table(
        "shapes", "Laws, in the order of the sheet Laws", len(CODES),
        constant("law", "law", "", "", list(CODES)),
        *(calc(name, words, "", "",
               [in_scope(getattr(family.page.shapes, name), f"{family.code}_") for family in FAMILIES],
               [getattr(share, name) for share in values])
          for name, words in WORDS.items()),
    )  # fmt: skip


def fastest_formulas() -> list[str]:
    """Return for each law the formula of the first ξ at which v is largest."""
    return [in_scope(family.page.fastest, f"{family.code}_") for family in FAMILIES]
