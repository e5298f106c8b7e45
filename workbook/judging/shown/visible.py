"""Whether the verdicts of a book can be seen, and look like what they say."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from openpyxl.utils import column_index_from_string
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.judging.matching import Match, Pair
from workbook.judging.report import FAIL, NOTICE, OK, Report
from workbook.judging.shown.colours import BLACK, WHITE, Look, Palette
from workbook.judging.shown.conditional import Rules
from workbook.judging.shown.covered import Covered
from workbook.reading.contents import Cells
from workbook.reading.drawings import Anchor

LEAST_WIDTH, LEAST_HEIGHT, LEAST_SIZE = 1.0, 3.0, 3.0  # characters; points of a row and of a font
MOST_INDENT = 15  # steps of about three spaces
CELL = re.compile("([A-Z]{1,3})([1-9][0-9]{0,6})")
SIGNS = ("wingdings", "webdings", "symbol", "marlett", "opensymbol", "zapfdingbats", "bookshelf symbol")
"""fonts that show other signs for letters"""


def visible(match: Match, values: Cells, rules: dict[str, Rules], report: Report) -> None:
    """Enter verdicts that are hidden, or coloured as what they do not say; and as notices, what else is hidden."""
    sheets = {sheet.title: sheet for sheet in match.file.workbook.worksheets}
    shadows = {title: Hidden(sheet, match.file.drawings.get(title, [])) for title, sheet in sheets.items()}
    ours = {pair.address.sheet for pair in match.pairs}
    for title, hidden in shadows.items():
        if hidden.sheet and title in ours:
            report.say(Address(title, 1, 1), NOTICE, "hidden", "shown", f"the sheet {title}")
    palette = Palette(match.file.workbook)
    for pair, overall in verdicts(match):
        title, value = pair.address.sheet, values.get(pair.address, pair.cell.expected)
        fails = value != OK
        cell = match.file.cell(pair.address)
        base = Look(BLACK, WHITE) if cell is None else look(cell, palette)
        now, always = painted(rules[title], pair.address, value, base, palette)
        said = shadows[title].said(pair.address) or ("written in the colour of its ground" if now.unseen else "")
        said = said or (unreadable(cell) if cell is not None and cell.has_style else "")
        if said and (fails or overall):
            report.say(pair.address, "shown", f"{value}, {said}", f"{value}, in sight", pair.what)
        elif said:
            report.say(pair.address, NOTICE, f"{value}, {said}", "in sight", pair.what)
        elif shadows[title].sheet and fails:
            report.say(pair.address, "shown", f"{value}, on a hidden sheet", f"{value}, in sight", pair.what)
        elif fails and now.green:
            report.say(pair.address, "shown", f"{value}, coloured as passed", f"{value}", pair.what)
        elif always:
            report.say(pair.address, "shown", "a rule colours FAIL as passed", "a colour of its own", pair.what)


def verdicts(match: Match) -> Iterator[tuple[Pair, bool]]:
    """Yield each cell that says OK or FAIL, with whether it says it of the whole book."""
    heads = {"overall", *(f"status{n}" for n in range(1, len(match.declared.sheets) + 1))}
    listed = ("checks", "verdict")
    for pair in match.pairs:
        q, block = pair.cell.quantity, pair.cell.block
        if q.role == "check" or (block.name, q.name) == listed:
            yield pair, block.name in heads


class Hidden:
    """What of a sheet is not shown: the sheet, rows, columns, and what is behind its drawings."""

    def __init__(self, sheet: Worksheet, drawings: list[Anchor]) -> None:
        self._covered = Covered(sheet, drawings)
        self.sheet = sheet.sheet_state != "visible"
        self._rows = {number: short(row) for number, row in sheet.row_dimensions.items()}
        self._columns: dict[int, bool] = {}
        for letter, column in sheet.column_dimensions.items():
            first = column.min or column_index_from_string(letter)
            narrow = bool(column.hidden) or (column.width is not None and column.width < LEAST_WIDTH)
            self._columns |= dict.fromkeys(range(first, (column.max or first) + 1), narrow)
        form = sheet.sheet_format
        low = form.defaultRowHeight is not None and form.defaultRowHeight < LEAST_HEIGHT
        self._other_rows = bool(form.zeroHeight) or low
        self._other_columns = form.defaultColWidth is not None and form.defaultColWidth < LEAST_WIDTH
        self._first = frozen(sheet)

    def said(self, at: Address) -> str:
        """Return why a cell is not shown; nothing where it is."""
        if self._rows.get(at.row, self._other_rows):
            return "in a hidden row"
        if self._columns.get(at.column, self._other_columns):
            return "in a hidden column"
        if at.row < self._first[0] or at.column < self._first[1]:
            return "beyond what is frozen"
        return "behind a drawing" if self._covered.holds(at) else ""


def frozen(sheet: Worksheet) -> tuple[int, int]:
    """Return the first row and column that can be scrolled to: nothing leads before those that are frozen."""
    view = sheet.sheet_view
    first = CELL.fullmatch(str(view.topLeftCell or ""))
    if view.pane is None or not str(view.pane.state).startswith("frozen") or first is None:
        return 1, 1
    column, row = column_index_from_string(first[1]), int(first[2])
    return (row if view.pane.ySplit else 1), (column if view.pane.xSplit else 1)


def short(row: Any) -> bool:
    """Whether a row is hidden, or as good as that."""
    return bool(row.hidden) or (row.height is not None and row.height < LEAST_HEIGHT)


def unreadable(cell: Any) -> str:
    """Return why a cell's text cannot be read, whatever its colour; nothing where it can."""
    font = cell.font
    if font.sz is not None and font.sz < LEAST_SIZE:
        return "written too small to be seen"
    if (font.name or "").casefold().startswith(SIGNS):
        return f"written in the signs of {font.name}"
    return "indented out of its cell" if (cell.alignment.indent or 0) > MOST_INDENT else ""


def look(cell: Any, palette: Palette) -> Look:
    """Return ink and ground of a cell by its own style."""
    if not cell.has_style:
        return Look(BLACK, WHITE)
    return Look(palette.colour(cell.font.color, BLACK), palette.ground(cell.fill, WHITE))


def painted(rules: Rules, at: Address, value: Any, base: Look, palette: Palette) -> tuple[Look, bool]:
    """Return the look of a cell with its value, and whether some rule would certainly show FAIL as passed."""
    now = over(base, [rule for rule, _ in rules.on(at, value)], palette)
    passing = [rule for rule, _ in rules.on(at, OK)]
    failing = [rule for rule, certain in rules.on(at, FAIL) if certain and rule not in passing]
    return now, bool(failing) and over(Look(BLACK, WHITE), failing, palette).green


def over(base: Look, rules: list[Any], palette: Palette) -> Look:
    """Return a look with rules laid over it, of which the first that names a colour has its way."""
    ink, ground = base
    for rule in reversed(rules):
        if rule.dxf is not None:
            ink = palette.colour(rule.dxf.font.color, ink) if rule.dxf.font else ink
            ground = palette.ground(rule.dxf.fill, ground, conditional=True)
    return Look(ink, ground)
