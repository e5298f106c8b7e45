"""Conditional formats and validations against those of a fresh build, which are known wherever cells have moved."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator
from typing import Any, NamedTuple

from openpyxl.formatting.rule import Rule
from openpyxl.formula.translate import Translator
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.worksheet import Worksheet
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.entries.rules import validation
from workbook.judging.matching import Match
from workbook.judging.report import FAIL, NOTICE, SHOWN, Report
from workbook.judging.shown.colours import Look
from workbook.judging.shown.formats import Judged, judged, sections
from workbook.judging.shown.looks import Looks, of_colours
from workbook.judging.shown.seen import Seen, Told
from workbook.writing.style import Marked, marks

SAID = ("type", "showErrorMessage", "showInputMessage", "prompt", "promptTitle", "error", "errorTitle")
"""what a validation does, and says to whom enters something"""


class Placed(NamedTuple):
    """A rule with the ranges that it covers: top, left, bottom, right."""

    rule: Rule
    ranges: list[tuple[int, int, int, int]]

    @property
    def first(self) -> tuple[int, int]:
        """Row and column of the cell for which the formulas of the rule are written."""
        return min(top for top, *_ in self.ranges), min(left for _, left, *_ in self.ranges)

    def covers(self, one: Seen, whole: bool = False) -> bool:
        """Whether the rule covers some of a column's cells, or all of them."""
        column, ends = one.at.column, (one.last, one.at.row) if not whole else (one.at.row, one.last)
        return any(top <= ends[0] and ends[1] <= bottom and left <= column <= right
                   for top, left, bottom, right in self.ranges)  # fmt: skip


class Rules:
    """The conditional formats of a file; in one that is ``torn``, rules went with the cells that were cut."""

    def __init__(self, match: Match, looks: Looks, told: Told, torn: bool = False) -> None:
        self._match, self._looks, self._told, self._torn = match, looks, told, torn
        self._fresh = {name: list(marks(block)) for name, block in match.declared.blocks.items()}
        self._met: set[tuple[str, int]] = set()
        self.known: set[int] = set()
        """the rules of the file that are those of a fresh build, by their identity"""

    def judge(self, cells: list[Seen]) -> None:
        """Enter what is to be told of rules that someone has made, and of those that are gone."""
        by_column: dict[tuple[str, int], list[Seen]] = defaultdict(list)
        for one in cells:
            by_column[one.at.sheet, one.at.column].append(one)
        for sheet in self._match.file.workbook.worksheets:
            columns = [column for title, column in by_column if title == sheet.title]
            for group in sheet.conditional_formatting:
                ranges = [(r.min_row, r.min_col, r.max_row, r.max_col) for r in group.sqref.ranges]
                wide = [c for c in columns if any(left <= c <= right for _, left, _, right in ranges)]
                for placed in (Placed(rule, ranges) for rule in group.rules):
                    for one in (one for column in wide for one in by_column[sheet.title, column]):
                        if placed.covers(one) and not self._is_known(placed, one):
                            what = f"a conditional format, {one.what}"
                            for said in self._of_rule(placed, one):
                                self._told.add(one.at, said, "no such rule", what, one.counts)
        self._gone()

    def has_verdicts(self, one: Seen) -> bool:
        """Whether OK and FAIL have their colours from the rules of a fresh build."""
        name = one.pairs[0].cell.block.name
        return all((name, n) in self._met for n in range(len(self._fresh[name])))

    def _is_known(self, placed: Placed, one: Seen) -> bool:
        """Whether a fresh build has this rule for the cells."""
        if not one.pairs:
            return False
        block, name = one.pairs[0].cell.block, one.pairs[0].cell.quantity.name
        for n, mark in enumerate(self._fresh[block.name]):
            if name in {q.name for q in mark.quantities} and self._same(mark, placed, one):
                self._met |= {(block.name, n)} if placed.covers(one, whole=True) else set()
                self.known.add(id(placed.rule))
                return True
        blanked = self._match.declared.blocks[block.name].blanked
        return self._torn and name in {q.name for q in blanked} and hides(code_of(placed.rule))

    def _same(self, mark: Marked, placed: Placed, one: Seen) -> bool:
        """Whether a rule of a file is one of a fresh build, in condition and look."""
        ours, held, block = mark.rule, placed.rule, one.pairs[0].cell.block
        if (ours.type, ours.operator) != (held.type, held.operator) or self._look(ours) != self._look(held):
            return False
        texts = [str(text).removeprefix("=") for text in held.formula]
        if ours.type != "expression":
            return bool(texts == ours.formula)
        place, declared = self._match.file.places[block.name], f"={ours.formula[0]}"
        moved = Translator(f"={texts[0]}", f"A{placed.first[0]}").translate_formula(f"A{place.row}") if texts else ""
        return moved == declared or self._match.same_formula(declared, block, moved, place.sheet)

    def _look(self, rule: Rule) -> tuple[Any, ...]:
        """Return what a rule makes of a cell: ink, ground, and the parts of its number format."""
        palette, look = self._looks.palette, rule.dxf
        font, fill = (look.font, look.fill) if look is not None else (None, None)
        ink = palette.colour(font.color, None) if font else None
        ground = palette.ground(fill, None, conditional=True) if fill else None
        return ink, ground, sections(code_of(rule)), bool(font and font.strike)

    def _of_rule(self, placed: Placed, one: Seen) -> Iterator[Judged]:
        """Yield what is to be told of a rule that no fresh build has."""
        rule, base = placed.rule, self._looks.base(one)
        if code := code_of(rule):
            q = one.pairs[0].cell.quantity if one.pairs else None
            yield judged(code, "General", q.unit if q else "", q.symbol if q else "", one.text)
        if any(sign is not None and sign.showValue is False for sign in (rule.dataBar, rule.iconSet)):
            yield SHOWN, "bars or icons instead of what it has"
        for colour in rule.colorScale.color if rule.colorScale is not None else ():
            yield from of_colours(base.ink, self._looks.palette.colour(colour, None))
        if rule.dxf is not None:
            yield from self._of_look(rule.dxf, base, one.verdict and meets_fail(placed))

    def _of_look(self, look: DifferentialStyle, base: Look, verdict: bool) -> Iterator[Judged]:
        """Yield what is to be told of the look that a rule gives, on ``verdict`` where it may be that of a FAIL."""
        font, fill, palette = look.font, look.fill, self._looks.palette
        ink = palette.colour(font.color, base.ink) if font else base.ink
        ground = palette.ground(fill, base.ground, conditional=True) if fill else base.ground
        if font and font.strike:
            yield SHOWN, "struck out"
        if (font and font.color) or fill:
            sure = verdict and (ink != base.ink or ground is None)
            yield from ((SHOWN if sure else kind, said) for kind, said in of_colours(ink, ground))
            if verdict and Look(ink, ground).green:
                yield SHOWN, "FAIL coloured as passed"

    def _gone(self) -> None:
        """Enter the rules of a fresh build that the file has no more."""
        for name, fresh in self._fresh.items() if not self._torn else ():
            place = self._match.file.places.get(name)
            for mark in (one for n, one in enumerate(fresh) if place is not None and (name, n) not in self._met):
                does = "leaves unused rows blank" if mark.rule.type == "expression" else "colours them"
                at, what = place.cell(0, 0), f"the cells of {name}"  # type: ignore[union-attr]
                self._told.add(at, (NOTICE, "no such rule"), f"a rule that {does}", what, group="")


def code_of(rule: Rule) -> str:
    """Return the number format that a rule gives, if it gives any."""
    form = rule.dxf.numFmt if rule.dxf is not None else None
    return str(form.formatCode or "") if form is not None else ""


def hides(code: str) -> bool:
    """Whether a number format shows nothing of anything."""
    return len(sections(code)) == 4 and not any(part.form for part in sections(code))


def meets_fail(placed: Placed) -> bool:
    """Whether the condition of a rule may be met by a cell that says FAIL."""
    rule, first = placed.rule, str(placed.rule.formula[0]).replace(" ", "").upper() if placed.rule.formula else ""
    if rule.type == "cellIs" and first.startswith('"') and rule.operator in ("equal", "notEqual"):
        return (first == f'"{FAIL}"') == (rule.operator == "equal")
    if rule.type in ("containsText", "beginsWith", "endsWith") and rule.text:
        return str(rule.text).upper() in FAIL
    row, column = placed.first
    own = rf'\(?\$?{get_column_letter(column)}{row}="OK"\)?'
    return not (rule.type == "expression" and re.fullmatch(own, first))


def validations(match: Match, model: type[BaseModel], report: Report) -> None:
    """Enter as a notice for each sheet how many inputs have no validation any more, or another one."""
    held = {sheet.title: list(validated(sheet)) for sheet in match.file.workbook.worksheets}
    told: dict[tuple[str, str], list[Address]] = defaultdict(list)
    for pairs in match.by_column():
        fresh = validation(model, pairs[0].cell.quantity) if pairs[0].cell.quantity.role == "input" else None
        for at in (pair.address for pair in pairs if fresh is not None):
            rule = next((rule for rule, (left, top, right, bottom) in held[at.sheet]
                         if top <= at.row <= bottom and left <= at.column <= right), None)  # fmt: skip
            if rule is None or any((getattr(rule, name) or "") != (getattr(fresh, name) or "") for name in SAID):
                told[at.sheet, "another validation" if rule else "no validation"].append(at)
    for (title, said), cells in told.items():
        what = f"{len(cells)} inputs of the sheet {title}"
        report.say(cells[0], NOTICE, said, "a rule for what is entered", what)


def validated(sheet: Worksheet) -> Iterator[tuple[Any, tuple[int, int, int, int]]]:
    """Yield the validations of a sheet with each range that they cover."""
    for rule in sheet.data_validations.dataValidation:
        yield from ((rule, cells.bounds) for cells in rule.sqref.ranges)
