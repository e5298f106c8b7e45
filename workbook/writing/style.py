"""How cells look: Excel's own cell styles for inputs, workings, results and checks, so that a theme restyles them."""

from __future__ import annotations

from functools import cache
from typing import Any

from openpyxl import Workbook
from openpyxl.formatting.rule import Rule
from openpyxl.styles import Alignment, Font, PatternFill, Protection
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.declare import Quantity

GRID = "D9D9D9"


def font(**more: Any) -> Font:
    """Return the book's own font; openpyxl's bare Font names none, and each program then takes another."""
    return Font(name="Calibri", size=11, **more)


CELL_STYLES = {
    "input": "Input",
    "calculation": "Calculation",
    "result": "Output",
    "check": "Check Cell",
    "constant": "Explanatory Text",
    "sentence": "Explanatory Text",
}
TEXT_STYLES: dict[str, dict[str, Any]] = {
    "title": {"style": "Title"},
    "heading": {"style": "Headline 2"},
    "subheading": {"style": "Headline 4"},
    "label": {},
    "symbol": {"font": font(italic=True), "alignment": Alignment(horizontal="center")},
    "unit": {"alignment": Alignment(horizontal="left", indent=1)},
    "note": {"style": "Explanatory Text"},
    "link": {"style": "Hyperlink"},
    "header": {
        "font": font(bold=True),
        "fill": PatternFill("solid", fgColor="DDEBF7"),
        "alignment": Alignment(wrap_text=True, horizontal="center", vertical="center"),
    },
    "units": {
        "font": font(italic=True),
        "fill": PatternFill("solid", fgColor="DDEBF7"),
        "alignment": Alignment(horizontal="center"),
    },
    "equation": {
        "style": "Explanatory Text",
        "alignment": Alignment(wrap_text=True, horizontal="center", vertical="top"),
    },
}


class Styles:
    """Cell styles of one workbook, each made once on a scratch cell, by their numbers in the file."""

    def __init__(self, workbook: Workbook) -> None:
        self._scratch = workbook.create_sheet("scratch")
        self._workbook = workbook
        self.quantity = cache(self._quantity)
        self.text = cache(self._text)

    def close(self) -> None:
        """Remove the scratch sheet."""
        self._workbook.remove(self._scratch)

    def _quantity(self, role: str, number_format: str, align: str) -> int:
        cell = self._scratch.cell(1, 1)
        cell.style = CELL_STYLES[role]  # first: it resets number format and protection
        cell.number_format = number_format or "General"
        cell.protection = Protection(locked=role != "input")
        cell.alignment = Alignment(horizontal=align)
        return int(cell.style_id)

    def _text(self, kind: str) -> int:
        cell = self._scratch.cell(1, 1)
        settings = TEXT_STYLES[kind]
        cell.style = settings.get("style", "Normal")
        for attribute in ("font", "fill", "alignment"):
            if attribute in settings:
                setattr(cell, attribute, settings[attribute])
        return int(cell.style_id)


def alignment(q: Quantity, value: Any, table: bool) -> str:
    """Return how a quantity stands in its cell: numbers to the right, counters and texts of tables centred."""
    if q.align:
        return q.align
    if q.role == "check" or (table and (isinstance(value, str | None) or q.role == "constant")):
        return "center"
    return "right" if not isinstance(value, str) or len(value) < 10 else "left"


def mark_checks(sheet: Worksheet, cells: str) -> None:
    """Colour OK and FAIL in ``cells``; the words stay, so the colour is not the only sign."""
    for word, ink, ground in (("OK", "006100", "C6EFCE"), ("FAIL", "9C0006", "FFC7CE")):
        look = DifferentialStyle(font=Font(color=ink, bold=True), fill=PatternFill(bgColor=ground, fill_type="solid"))
        rule = Rule(type="cellIs", operator="equal", formula=[f'"{word}"'], dxf=look)
        sheet.conditional_formatting.add(cells, rule)
