"""The looks of cells: cell styles of our own, by name, so that a reader can restyle each kind in a single place.

Colour says one thing: a fill and blue figures are an entry's alone, a verdict is a word on a pale field, else is ink.
"""

from collections.abc import Iterator
from functools import cache
from typing import Any, Literal, NamedTuple

from openpyxl import Workbook
from openpyxl.formatting.rule import DataBar, FormatObject, Rule
from openpyxl.styles import Alignment, Border, Font, NamedStyle, PatternFill, Protection, Side
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.styles.numbers import NumberFormat

from workbook.book.declare import FIRST, Block, Quantity
from workbook.book.quantity import MOST, ROUNDED, side_of

INK, GREY, RULE, GRID = "1F2937", "6B7280", "D1D5DB", "E5E7EB"
ENTRY, FIGURE, DOTS = "FFF8E1", "0B57A4", "D9B65C"
PAPER, BAR = "FFFFFF", "BFD7EA"
# a number format that shows nothing; its number is beyond those that programs give
NOTHING, NOTHING_ID = ";;;", 900
BEYOND = "991B1B"
TABS = {"enter": DOTS, "result": INK, "working": RULE}  # colours of sheets' tabs
VERDICTS = (("OK", "166534", "DCFCE7"), ("FAIL", BEYOND, "FEE2E2"))


def font(size: float = 11, color: str = INK, **more: Any) -> Font:
    """Return the book's own font; openpyxl's bare Font names none, and each program then takes another."""
    return Font(name="Calibri", size=size, color=color, **more)


def line(colour: str, style: Literal["thin", "dotted"] = "thin") -> Border:
    """Return a border of a line below."""
    return Border(bottom=Side(style=style, color=colour))


class Look(NamedTuple):
    """A kind of cell: the name of its style, and how it looks."""

    name: str
    font: Font
    alignment: Alignment | None = None
    fill: PatternFill | None = None
    border: Border | None = None

    def style(self) -> NamedStyle:
        """Return it as a cell style of a file."""
        return NamedStyle(self.name, self.font, self.fill, self.border, self.alignment)


ROLES = {
    "input": Look("Entry", font(color=FIGURE), None, PatternFill("solid", fgColor=ENTRY), line(DOTS, "dotted")),
    "calculation": Look("Working", font()),
    "result": Look("Result", font(bold=True)),
    "figure": Look("Figure", font(16, bold=True)),
    "check": Look("Verdict", font(bold=True)),
    "constant": Look("Constant", font(color=GREY)),
    "sentence": Look("Finding", font(10, GREY)),
    "title": Look("Machine title", font(18, bold=True), Alignment(horizontal="left")),
}
TEXTS = {
    "title": Look("Book title", font(18, bold=True)),
    "heading": Look("Section", font(13, bold=True), None, None, line(INK)),
    "subheading": Look("Table title", font(bold=True)),
    "label": Look("Label", font()),
    "symbol": Look("Symbol", font(color=GREY, italic=True), Alignment(horizontal="center")),
    "unit": Look("Unit", font(color=GREY), Alignment(horizontal="left", indent=1)),
    "note": Look("Note", font(10, GREY)),
    "figure name": Look("Figure name", font(10, GREY)),
    "figure unit": Look("Figure unit", font(10, GREY)),
    "aside": Look("Aside", font(10, GREY), Alignment(horizontal="right")),
    "link": Look("Link", font(underline="single"), Alignment(horizontal="right")),  # into what is empty before it
    "group": Look("Group", font(bold=True), None, None, line(INK)),
    "group head": Look("Group head", font(color=GREY), Alignment(horizontal="right"), None, line(INK)),
    "group word": Look("Group word", font(color=GREY), None, None, line(INK)),
    "header": Look("Table head", font(10, GREY, bold=True),
                   Alignment(wrap_text=True, horizontal="center", vertical="bottom")),
    "units": Look("Table units", font(10, GREY, italic=True), Alignment(wrap_text=True, horizontal="center"), None,
                  line(RULE)),
    "equation": Look("Table equation", font(10, GREY),
                     Alignment(wrap_text=True, horizontal="center", vertical="center")),
}  # fmt: skip


class Aligned(NamedTuple):
    """The alignment of text in a cell: to which side, how far from it, and whether it is wrapped."""

    side: str
    indent: int
    wrap: bool


class Styles:
    """Cell styles of a workbook, each built once on a scratch cell, by their numbers in the file."""

    def __init__(self, workbook: Workbook) -> None:
        self._workbook, self._scratch = workbook, workbook.create_sheet("scratch")
        for kind in (*ROLES.values(), *TEXTS.values()):
            workbook.add_named_style(kind.style())
        self.text, self.quantity = cache(self._text), cache(self._quantity)

    def close(self) -> None:
        """Remove the scratch sheet."""
        self._workbook.remove(self._scratch)

    def _quantity(self, role: str, number_format: str, aligned: Aligned, ink: str = "") -> int:
        """Return the style of a quantity's cells."""
        cell = self._scratch.cell(1, 1)
        cell.style = ROLES[role].name  # first: it resets number format and protection
        if ink:
            cell.font = font(color=ink, bold=True)
        cell.number_format = number_format or "General"
        cell.protection = Protection(locked=role != "input")
        cell.alignment = Alignment(
            aligned.side,
            "top" if aligned.wrap else None,
            wrap_text=aligned.wrap or None,
            shrink_to_fit=role == "figure" or None,  # a number wider than its cell is shown as ###
            indent=aligned.indent,
        )
        return int(cell.style_id)

    def _text(self, kind: str, side: str = "", indent: int = 0) -> int:
        cell = self._scratch.cell(1, 1)
        cell.style = TEXTS[kind].name
        if side:
            cell.alignment = Alignment(side, cell.alignment.vertical, wrap_text=cell.alignment.wrap_text, indent=indent)
        return int(cell.style_id)


def style_role(role: str, block: Block) -> str:
    """Return the kind of a quantity's cells: a whole page in bold stands out of nothing."""
    if block.is_large:
        return "figure"
    return "calculation" if block.is_table and role == "result" else role


def aligned(q: Quantity, is_table: bool, column: int) -> Aligned:
    """Return how a quantity's cells are aligned, in a column of the sheet."""
    side = side_of(q, is_table)
    return Aligned(side, indent(side, column) if is_table else 0, q.wrap)


def indent(side: str, column: int) -> int:
    """Return how far words of a table, and heads above them, stand off a number that may stand before them."""
    return int(side == "left" and column != FIRST)


class FormatRule(NamedTuple):
    """Quantities of a block whose cells look otherwise while a rule's condition is met."""

    quantities: tuple[Quantity, ...]
    rule: Rule


def conditional_formats(block: Block) -> Iterator[FormatRule]:
    """Yield the conditional formats of a block: of verdicts, figures above a limit, rows not used, results in error.

    Words of verdicts stay, so the colour is not the only sign. Errors have no number format: their ink goes.
    """
    for q in block.quantities:
        good = ((q.good, *VERDICTS[0][1:]),) if q.good else ()
        for word, ink, ground in VERDICTS if q.role == "check" else good:
            fill = PatternFill(bgColor=ground, fill_type="solid")
            look = DifferentialStyle(font=Font(color=ink, bold=True), fill=fill)
            yield FormatRule((q,), Rule(type="cellIs", operator="equal", formula=[f'"{word}"'], dxf=look))
        if q.limit:
            ends = [f"{q.limit * (1 + ROUNDED):.12g}", f"{MOST:.0f}"]
            look = DifferentialStyle(font=Font(color=BEYOND, bold=True))
            yield FormatRule((q,), Rule(type="cellIs", operator="between", formula=ends, dxf=look))
            whole = [FormatObject("num", end) for end in (0, q.limit)]
            yield FormatRule((q,), Rule(type="dataBar", dataBar=DataBar(cfvo=whole, color=BAR)))
        for condition, ink in ((q.grey, GREY), (q.red, BEYOND)):
            if condition:
                look = DifferentialStyle(font=Font(color=ink))
                yield FormatRule((q,), Rule(type="expression", formula=[block.when(condition, block.row)], dxf=look))
    if block.blanked:
        look = DifferentialStyle(numFmt=NumberFormat(NOTHING_ID, NOTHING))
        formula = block.when(block.blank, block.row)
        yield FormatRule(block.blanked, Rule(type="expression", formula=[formula], dxf=look))
    if block.quiet:
        results = tuple(q for q in block.quantities if q.role == "result")
        look = DifferentialStyle(font=Font(color=PAPER))
        yield FormatRule(results, Rule(type="expression", formula=[block.when(block.quiet, block.row)], dxf=look))
