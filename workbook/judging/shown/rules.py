"""Conditional formats and validations against those of a fresh build, which are known wherever cells have moved."""

import re
from collections import defaultdict
from collections.abc import Iterator
from typing import Any, NamedTuple

from openpyxl.formatting.rule import Rule
from openpyxl.formula.translate import Translator
from openpyxl.utils import get_column_letter
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.entries.rules import validation
from workbook.judging.matching import Match
from workbook.judging.report import FAIL, NOTICE, SHOWN, Report
from workbook.judging.shown.colours import Look, looks_passed
from workbook.judging.shown.formats import Judged, judged, sections
from workbook.judging.shown.looks import Looks, Seen, Told, of_colours, of_font
from workbook.writing.style import Marked, marks

SAID = ("type", "showErrorMessage", "showInputMessage", "prompt", "promptTitle", "error", "errorTitle")
"""what a validation does, and says to whom enters something"""


class Placed(NamedTuple):
    """A rule with the ranges that it covers: top, left, bottom, right."""

    rule: Rule
    ranges: list[tuple[int, int, int, int]]

    def covers(self, one: Seen, whole: bool = False) -> bool:
        """Whether the rule covers some of a column's cells, or all of them."""
        first, last = (one.at.row, one.last) if whole else (one.last, one.at.row)
        return any(t <= first and last <= b and left <= one.at.column <= r for t, left, b, r in self.ranges)

    @property
    def code(self) -> str:
        """The number format that the rule gives, if it gives any."""
        form = self.rule.dxf.numFmt if self.rule.dxf is not None else None
        return str(form.formatCode or "") if form is not None else ""

    @property
    def meets_fail(self) -> bool:
        """Whether the condition of the rule may be met by a cell that says FAIL."""
        rule, first = self.rule, str(self.rule.formula[0]).replace(" ", "").upper() if self.rule.formula else ""
        if rule.type == "cellIs" and first.startswith('"') and rule.operator in ("equal", "notEqual"):
            return (first == f'"{FAIL}"') == (rule.operator == "equal")
        if rule.type in ("containsText", "beginsWith", "endsWith") and rule.text:
            return str(rule.text).upper() in FAIL
        row, column = min(top for top, *_ in self.ranges), min(left for _, left, *_ in self.ranges)
        own = rf'\(?\$?{get_column_letter(column)}{row}="OK"\)?'
        return not (rule.type == "expression" and re.fullmatch(own, first))


class Rules:
    """The conditional formats of a file; in one that is ``torn``, rules went with the cells that were cut."""

    def __init__(self, match: Match, looks: Looks, told: Told, torn: bool = False) -> None:
        self._match, self._looks, self._told, self._torn = match, looks, told, torn
        self._fresh = {name: list(marks(block)) for name, block in match.declared.blocks.items()}
        self._met: set[tuple[str, int]] = set()
        self._before_fail: set[str] = set()
        """blocks of verdicts with rules of someone's own, after which those of a fresh build may not apply"""
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
                            for said in self._of_rule(placed, one):
                                what = f"a conditional format, {one.what}"
                                self._told.add(one.at, said, "no such rule", what, one.counts)
        self._gone()

    def has_verdicts(self, one: Seen) -> bool:
        """Whether OK and FAIL have their colours from the rules of a fresh build."""
        name = one.pairs[0].cell.block.name
        return name not in self._before_fail and all((name, n) in self._met for n in range(len(self._fresh[name])))

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
        parts = sections(placed.code)
        hides = len(parts) == 4 and not any(part.form for part in parts)
        return self._torn and name in {q.name for q in block.blanked} and hides

    def _same(self, mark: Marked, placed: Placed, one: Seen) -> bool:
        """Whether a rule of a file is one of a fresh build, in condition and look."""
        ours, held, block = mark.rule, placed.rule, one.pairs[0].cell.block
        looks = [self._look(Placed(rule, [])) for rule in (ours, held)]
        if (ours.type, ours.operator) != (held.type, held.operator) or looks[0] != looks[1]:
            return False
        texts = [str(text).removeprefix("=") for text in held.formula]
        if ours.type != "expression":
            return bool(texts == ours.formula)
        place, declared = self._match.file.places[block.name], f"={ours.formula[0]}"
        first = f"A{min(top for top, *_ in placed.ranges)}"  # the cell for which its formulas are written
        moved = Translator(f"={texts[0]}", first).translate_formula(f"A{place.row}") if texts else ""
        return moved == declared or self._match.same_formula(declared, block, moved, place.sheet)

    def _look(self, placed: Placed) -> tuple[Any, ...]:
        """Return what a rule makes of a cell: ink, ground, and the parts of its number format."""
        look = placed.rule.dxf
        font = look.font if look is not None else None
        ink, ground = self._colours(look, (None, None))
        return ink, ground, sections(placed.code), bool(font and font.strike)

    def _colours(self, look: Any, base: Look) -> Look:
        """Return ink and ground of a cell to which a rule gives a look."""
        palette, font, fill = self._looks.palette, getattr(look, "font", None), getattr(look, "fill", None)
        return (palette.colour(font.color, base[0]) if font else base[0],
                palette.ground(fill, base[1], conditional=True) if fill else base[1])  # fmt: skip

    def _of_rule(self, placed: Placed, one: Seen) -> Iterator[Judged]:
        """Yield what is to be told of a rule that no fresh build has."""
        rule, palette = placed.rule, self._looks.palette
        base = palette.look(self._match.file.cell(one.at))
        verdict = one.verdict and placed.meets_fail
        if verdict:
            self._before_fail.add(one.pairs[0].cell.block.name)
        if placed.code:
            q = one.pairs[0].cell.quantity if one.pairs else None
            yield judged(placed.code, "General", q.unit if q else "", q.symbol if q else "", one.text)
        if any(sign is not None and sign.showValue is False for sign in (rule.dataBar, rule.iconSet)):
            yield SHOWN, "bars or icons instead of what it has"
        scale = rule.colorScale.color if rule.colorScale is not None else []
        for colour in [*scale, *([rule.dataBar.color] if rule.dataBar is not None else [])]:
            yield from of_colours(base[0], palette.colour(colour, None))
        look = rule.dxf
        if look is None:
            return
        if look.font:
            yield from of_font(look.font, palette)
        if (look.font and look.font.color) or look.fill:
            ink, ground = self._colours(look, base)
            sure = verdict and (ink != base[0] or ground is None)
            yield from ((SHOWN if sure else kind, said) for kind, said in of_colours(ink, ground))
            if verdict and looks_passed((ink, ground)):
                yield SHOWN, "FAIL coloured as passed"

    def _gone(self) -> None:
        """Enter the rules of a fresh build that the file has no more."""
        for name, fresh in self._fresh.items() if not self._torn else ():
            place = self._match.file.places.get(name)
            for mark in (one for n, one in enumerate(fresh) if place is not None and (name, n) not in self._met):
                does = "leaves unused rows blank" if mark.rule.type == "expression" else "colours them"
                at, what = place.cell(0, 0), f"the cells of {name}"  # type: ignore[union-attr]
                self._told.add(at, (NOTICE, "no such rule"), f"a rule that {does}", what, group="")


def validations(match: Match, model: type[BaseModel], report: Report) -> None:
    """Enter as a notice for each sheet how many inputs have no validation any more, or another one."""
    held = {sheet.title: [(rule, cells.bounds) for rule in sheet.data_validations.dataValidation
                          for cells in rule.sqref.ranges]
            for sheet in match.file.workbook.worksheets}  # fmt: skip
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
