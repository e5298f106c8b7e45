"""Whether each declared cell displays the number or the text that it has."""

from __future__ import annotations

from typing import Any

from workbook.book.formats import number_format, sample
from workbook.judging.matching import Match, Pair
from workbook.judging.report import LAYOUT, Report
from workbook.judging.shown.blank import Blanks
from workbook.judging.shown.conditional import Rules
from workbook.judging.shown.formats import plain, problem
from workbook.reading.contents import Cells


def numbers(match: Match, values: Cells, rules: dict[str, Rules], report: Report) -> None:
    """Enter the cells whose number format tells something else than their values."""
    sheets = {sheet.title: sheet for sheet in match.file.workbook.worksheets}
    blanks = Blanks(match, rules, torn=any(found.kind == LAYOUT for found in report.findings))
    blanks.gone(report)
    zeros = {title for title, sheet in sheets.items() if sheet.sheet_view.showZeros is False}
    codes: dict[int, str] = {}
    for pairs in match.by_column():
        title, number = pairs[0].address.sheet, pairs[0].address.column
        formats = rules[title].formats_within(number, pairs[0].address.row, pairs[-1].address.row)
        for pair in pairs:
            cell = match.file.cell(pair.address)
            if cell is None:
                continue
            key = getattr(cell, "_style").numFmtId  # noqa: B009 - the stubs hide it; number_format looks it up anew
            code = codes.get(key)
            if code is None:
                code = codes[key] = cell.number_format
            if not formats and plain(code) and title not in zeros:
                continue
            value = values.get(pair.address, pair.held)
            said = "hidden with all zeros" if value == 0 and value is not False and title in zeros else ""
            said = said or wrong(pair, value, code)
            for held in rules[title].formats_of(formats, pair.address, value):
                if not blanks.allow(pair.cell.block, pair.cell.quantity.name, pair.address, held):
                    said = said or wrong(pair, value, held)
            if said:
                report.say(pair.address, "shown", f"{shown(value)}, {said}", shown(value), pair.what)


def wrong(pair: Pair, value: Any, code: str) -> str:
    """Return what is wrong with how a declared cell shows a value by a number format."""
    if plain(code):
        return ""
    q = pair.cell.quantity
    return problem(value, code, q.format or number_format(q, sample(q)), q.unit)


def shown(value: Any) -> str:
    """Return a value in short."""
    return f"{value:.6g}" if isinstance(value, float) else str(value)
