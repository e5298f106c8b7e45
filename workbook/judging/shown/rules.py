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
from workbook.judging.shown.colours import BLACK, WHITE, Look, looks_passed
from workbook.judging.shown.formats import Judged, sections
from workbook.judging.shown.looks import PASSED, Looks, Seen, Told, of_colours, of_style, value_of
from workbook.writing.style import Marked, marks

SAID = ("type", "showErrorMessage", "showInputMessage", "prompt", "promptTitle", "error", "errorTitle")


class Placed(NamedTuple):
    """A rule with the ranges that it covers: top, left, bottom, right."""

    rule: Rule
    ranges: list[tuple[int, int, int, int]]

    def covers(self, one: Seen, whole: bool = False) -> bool:
        """Whether the rule covers some of a column's cells, or all of them."""
        first, last = (one.at.row, one.last) if whole else (one.last, one.at.row)
        return any(t <= first and last <= b and left <= one.at.column <= r for t, left, b, r in self.ranges)

    def meets_fail(self) -> bool:
        """Whether the condition of the rule may be met by a cell that says FAIL."""
        rule, first = self.rule, str(self.rule.formula[0]).replace(" ", "").upper() if self.rule.formula else ""
        if rule.type == "cellIs" and first.startswith('"') and rule.operator in ("equal", "notEqual"):
            return (first == f'"{FAIL}"') == (rule.operator == "equal")
        if rule.type in ("containsText", "beginsWith", "endsWith") and rule.text:
            return str(rule.text).upper() in FAIL
        row, column = min(top for top, *_ in self.ranges), min(left for _, left, *_ in self.ranges)
        says_ok = re.fullmatch(rf'\(?\$?{get_column_letter(column)}{row}="OK"\)?', first)
        return rule.type != "expression" or not says_ok


def code_of(rule: Rule) -> str:
    """Return the number format that a rule gives, if it gives any."""
    return str(rule.dxf.numFmt.formatCode or "") if rule.dxf is not None and rule.dxf.numFmt is not None else ""


class Rules:
    """The conditional formats of a file; in one that is ``torn``, rules went with the cells that were cut."""

    def __init__(self, match: Match, looks: Looks, told: Told, torn: bool = False) -> None:
        self._match, self._looks, self._told, self._torn = match, looks, told, torn
        self._fresh = {name: list(marks(block)) for name, block in match.declared.blocks.items()}
        self._met: set[tuple[str, int]] = set()
        self._before_fail: set[str] = set()  # verdicts with rules of one's own, after which ours may not apply
        self.known: set[int] = set()  # the rules of the file that are those of a fresh build, by their identity

    def judge(self, cells: list[Seen]) -> None:
        """Enter what is to be told of rules that someone has made, and of those that are gone."""
        by_column: dict[str, dict[int, list[Seen]]] = defaultdict(lambda: defaultdict(list))
        for one in cells:
            by_column[one.at.sheet][one.at.column].append(one)
        for sheet in self._match.file.workbook.worksheets:
            for group in sheet.conditional_formatting:
                ranges = [(r.min_row, r.min_col, r.max_row, r.max_col) for r in group.sqref.ranges]
                wide = [held for column, held in by_column[sheet.title].items()
                        if any(left <= column <= right for _, left, _, right in ranges)]  # fmt: skip
                for placed in (Placed(rule, ranges) for rule in group.rules):
                    for one in (one for held in wide for one in held if placed.covers(one)):
                        if not self._is_known(placed, one):
                            what = f"a conditional format, {one.what}"
                            self._told.add(one.at, self._of_rule(placed, one), "no such rule", what, one.counts)
        for name, fresh in self._fresh.items() if not self._torn else ():
            place = self._match.file.places.get(name)
            for mark in (one for n, one in enumerate(fresh) if place is not None and (name, n) not in self._met):
                does = "leaves unused rows blank" if mark.rule.type == "expression" else "colours them"
                at, what = place.cell(0, 0), f"the cells of {name}"  # type: ignore[union-attr]
                self._told.add(at, [(NOTICE, "no such rule")], f"a rule that {does}", what, group="")

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
        parts = sections(code_of(placed.rule))
        hides = len(parts) == 4 and not any(part.form for part in parts)
        return self._torn and name in {q.name for q in block.blanked} and hides

    def _same(self, mark: Marked, placed: Placed, one: Seen) -> bool:
        """Whether a rule of a file is one of a fresh build, in condition and look."""
        ours, held, block = mark.rule, placed.rule, one.pairs[0].cell.block
        does = [(rule.type, rule.operator, self._colours(rule.dxf, (None, None)), sections(code_of(rule)),
                 bool(rule.dxf and rule.dxf.font and rule.dxf.font.strike)) for rule in (ours, held)]  # fmt: skip
        if does[0] != does[1]:
            return False
        texts = [str(text).removeprefix("=") for text in held.formula]
        if ours.type != "expression":
            return bool(texts == ours.formula)
        place, declared = self._match.file.places[block.name], f"={ours.formula[0]}"
        first = f"A{min(top for top, *_ in placed.ranges)}"  # the cell for which its formulas are written
        moved = Translator(f"={texts[0]}", first).translate_formula(f"A{place.row}") if texts else ""
        return moved == declared or self._match.same_formula(declared, block, moved, place.sheet)

    def _colours(self, look: Any, base: Look) -> Look:
        """Return ink and ground of a cell to which a rule gives a look."""
        palette, font, fill = self._looks.palette, getattr(look, "font", None), getattr(look, "fill", None)
        return (palette.colour(font.color, base[0]) if font else base[0],
                palette.ground(fill, base[1], conditional=True) if fill else base[1])  # fmt: skip

    def _of_rule(self, placed: Placed, one: Seen) -> Iterator[Judged]:
        """Yield what is to be told of a rule that no fresh build has."""
        rule, look, base = placed.rule, placed.rule.dxf, self._looks.base(one)
        verdict = one.verdict and placed.meets_fail()
        if verdict:
            self._before_fail.add(one.pairs[0].cell.block.name)
        if code := code_of(rule):
            yield from one.format(code, map(value_of, one.pairs))
        if any(sign is not None and sign.showValue is False for sign in (rule.dataBar, rule.iconSet)):
            yield SHOWN, "bars or icons instead of what it has"
        scale = [*(rule.colorScale.color if rule.colorScale else ()), *([rule.dataBar.color] if rule.dataBar else ())]
        for colour in scale:
            yield from of_colours((base[0], self._looks.palette.colour(colour, None)))
        if look is not None and look.font:
            yield from of_style(self._looks.palette, (BLACK, WHITE), font=look.font)
        if look is not None and ((look.font and look.font.color) or look.fill):
            colours = self._colours(look, base)
            sure = verdict and (colours[0] != base[0] or colours[1] is None)
            yield from ((SHOWN if sure else kind, said) for kind, said in of_colours(colours))
            if verdict and looks_passed(colours):
                yield PASSED


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
