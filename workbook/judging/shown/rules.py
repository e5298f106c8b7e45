"""Conditional formats and validations against those of a fresh build, which are known wherever cells have moved."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterator
from typing import Any, NamedTuple

from openpyxl.formatting.rule import Rule
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.worksheet import Worksheet
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.formula import REFERENCE, TOKEN
from workbook.entries.rules import validation
from workbook.judging.matching import Match
from workbook.judging.report import FAIL, NOTICE, SHOWN, Report
from workbook.judging.shown.colours import Look
from workbook.judging.shown.formats import Judged, judged, sections
from workbook.judging.shown.looks import Looks, of_colours
from workbook.judging.shown.seen import Seen, Told
from workbook.writing.style import Marked, marks

CELL = re.compile(r"(\$?[A-Za-z]{1,3})(\$?)([0-9]+)")
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
            for placed in placed_on(sheet):
                for column in columns:
                    spans = [(top, bottom) for top, left, bottom, right in placed.ranges if left <= column <= right]
                    for one in by_column[sheet.title, column] if spans else ():
                        if any(top <= one.last and one.at.row <= bottom for top, bottom in spans):
                            self._judge(placed, one)
        self._gone()

    def has_verdicts(self, one: Seen) -> bool:
        """Whether OK and FAIL have their colours from the rules of a fresh build."""
        name = one.pairs[0].cell.block.name
        return all((name, n) in self._met for n in range(len(self._fresh[name])))

    def _judge(self, placed: Placed, one: Seen) -> None:
        """Enter what is to be told of a rule that covers some cells."""
        if one.pairs and self._is_known(placed, one):
            return
        what = f"a conditional format, {one.what}"
        for kind, said in self._of_rule(placed, one):
            self._told.add(one.at, (kind, said), "no such rule", what, one.counts)

    def _is_known(self, placed: Placed, one: Seen) -> bool:
        """Whether a fresh build has this rule for the cells."""
        cell = one.pairs[0].cell
        block = self._match.declared.blocks[cell.block.name]
        for n, mark in enumerate(self._fresh[block.name]):
            if cell.quantity.name in {q.name for q in mark.quantities} and self._same(mark, placed, one):
                if any(top <= one.at.row and one.last <= bottom for top, _, bottom, _ in placed.ranges):
                    self._met.add((block.name, n))
                self.known.add(id(placed.rule))
                return True
        code = code_of(placed.rule)
        return self._torn and bool(code) and cell.quantity.name in {q.name for q in block.blanked} and hides(code)

    def _same(self, mark: Marked, placed: Placed, one: Seen) -> bool:
        """Whether a rule of a file is one of a fresh build, in condition and look."""
        ours, held, block = mark.rule, placed.rule, one.pairs[0].cell.block
        if (ours.type, ours.operator) != (held.type, held.operator) or self._look(ours) != self._look(held):
            return False
        texts = [str(text).removeprefix("=") for text in held.formula]
        if ours.type != "expression":
            return bool(texts == ours.formula)
        place = self._match.file.places[block.name]
        text = moved(texts[0], place.row - placed.first[0]) if texts else ""
        declared = f"={ours.formula[0]}"
        return text == declared or self._match.same_formula(declared, block, text, place.sheet)

    def _look(self, rule: Rule) -> tuple[Any, ...]:
        """Return what a rule makes of a cell: ink, ground, and the parts of its number format."""
        palette, look = self._looks.palette, rule.dxf
        font = look.font if look is not None else None
        ground = palette.ground(look.fill, None, conditional=True) if look is not None and look.fill else None
        return (
            palette.colour(font.color, None) if font else None,
            ground,
            sections(code_of(rule)),
            bool(font and font.strike),
        )

    def _of_rule(self, placed: Placed, one: Seen) -> Iterator[Judged]:
        """Yield what is to be told of a rule that no fresh build has."""
        rule, base = placed.rule, self._looks.base(one)
        code = code_of(rule)
        if code:
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
            yield from (
                (SHOWN if verdict and ink != base.ink else kind, said) for kind, said in of_colours(ink, ground)
            )
            if verdict and ground is None:
                yield SHOWN, "on a ground that cannot be known"
            if verdict and Look(ink, ground).green:
                yield SHOWN, "FAIL coloured as passed"

    def _gone(self) -> None:
        """Enter the rules of a fresh build that the file has no more."""
        for name, fresh in self._fresh.items() if not self._torn else ():
            place = self._match.file.places.get(name)
            for n, mark in enumerate(fresh):
                if place is not None and (name, n) not in self._met:
                    blank = mark.rule.type == "expression"
                    expected = f"a rule that {'leaves unused rows blank' if blank else 'colours them'}"
                    self._told.add(
                        place.cell(0, 0), (NOTICE, "no such rule"), expected, f"the cells of {name}", group=""
                    )


def placed_on(sheet: Worksheet) -> Iterator[Placed]:
    """Yield the rules of a sheet with what they cover."""
    for group in sheet.conditional_formatting:
        ranges = [(r.min_row, r.min_col, r.max_row, r.max_col) for r in group.sqref.ranges]
        for rule in group.rules if ranges else ():
            yield Placed(rule, ranges)


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


def moved(formula: str, down: int) -> str:
    """Return the formula of a rule as it is so many rows further down."""

    def shifted(cell: re.Match[str]) -> str:
        column, fixed, row = cell.groups()
        return cell[0] if fixed else f"{column}{int(row) + down}"

    def replaced(token: re.Match[str]) -> str:
        word = token[0]
        if token.lastgroup != "reference" or not REFERENCE.fullmatch(word):
            return word
        sheet, mark, cells = word.rpartition("!")
        return f"{sheet}{mark}{CELL.sub(shifted, cells)}"

    return "=" + TOKEN.sub(replaced, formula.removeprefix("="))


def validations(match: Match, model: type[BaseModel], report: Report) -> None:
    """Enter as a notice for each sheet how many inputs have no validation any more, or another one."""
    held = {sheet.title: list(validated(sheet)) for sheet in match.file.workbook.worksheets}
    counted: Counter[tuple[str, str]] = Counter()
    first: dict[tuple[str, str], Address] = {}
    for pairs in match.by_column():
        q = pairs[0].cell.quantity
        if q.role != "input":
            continue
        fresh = validation(model, q)
        for pair in pairs:
            at = pair.address
            rules = [rule for rule, (top, left, bottom, right) in held[at.sheet]
                     if top <= at.row <= bottom and left <= at.column <= right]  # fmt: skip
            said = "no validation" if not rules else "" if same_rule(rules[0], fresh) else "another validation"
            if said:
                counted[at.sheet, said] += 1
                first.setdefault((at.sheet, said), at)
    for (title, said), count in counted.items():
        what = f"{count} inputs of the sheet {title}"
        report.say(first[title, said], NOTICE, said, "a rule for what is entered", what)


def validated(sheet: Worksheet) -> Iterator[tuple[Any, tuple[int, int, int, int]]]:
    """Yield the validations of a sheet with each range that they cover."""
    for rule in sheet.data_validations.dataValidation:
        yield from ((rule, (r.min_row, r.min_col, r.max_row, r.max_col)) for r in rule.sqref.ranges)


def same_rule(held: Any, fresh: Any) -> bool:
    """Whether a validation does and says what that of a fresh build does."""
    return all((getattr(held, name) or "") == (getattr(fresh, name) or "") for name in SAID)
