"""Conditional formats and validations of declared cells, against those of a fresh build."""

from typing import Any, NamedTuple

from openpyxl.formatting.rule import Rule
from openpyxl.formula.translate import Translator
from pydantic import BaseModel

from workbook.entries.rules import validation
from workbook.judging.display.cells import CellGroup
from workbook.judging.display.differences import Differences
from workbook.judging.display.flat import flatten, in_words
from workbook.judging.display.formats import plain_number
from workbook.judging.matching import Match
from workbook.writing.style import conditional_formats

OF_RULE = ("type", "operator", "stopIfTrue")
OF_VALIDATION = (
    "type",
    "allowBlank",
    "showDropDown",
    "showErrorMessage",
    "showInputMessage",
    "prompt",
    "promptTitle",
    "error",
    "errorTitle",
)
NO_RULE = "no such rule"


class PlacedRule(NamedTuple):
    """A conditional format or validation of a file, in words, with the ranges of cells that it covers."""

    rule: Any
    words: str
    ranges: list[tuple[int, int, int, int]]  # left, top, right, bottom

    def covers(self, column: int, first: int, last: int) -> bool:
        """Whether any of its ranges covers rows of a column, from ``first`` to ``last``."""
        return any(
            left <= column <= right and top <= first and last <= bottom for left, top, right, bottom in self.ranges
        )


def compare_rules(match: Match, groups: list[CellGroup], differences: Differences) -> set[int]:
    """Enter conditional formats of declared cells that a fresh build has not, and those that are gone.

    Returns the rules of the file that are those of a fresh build, by their identity.
    """
    fresh = {
        name: [(mark.quantities, mark.rule, rule_words(mark.rule)) for mark in conditional_formats(block)]
        for name, block in match.declared.blocks.items()
    }
    placed = {
        sheet.title: [
            PlacedRule(rule, rule_words(rule), [cells.bounds for cells in area.sqref.ranges])
            for area in sheet.conditional_formatting
            for rule in area.rules
        ]
        for sheet in match.file.workbook.worksheets
    }
    known = set[int]()
    for group in (group for group in groups if group.pairs):
        cell, first, last = group.pairs[0].cell, group.pairs[0].address, group.pairs[-1].address
        missing = {words: rule for quantities, rule, words in fresh[cell.block.name] if cell.quantity in quantities}
        declared = dict(missing)
        for held in placed[first.sheet]:
            if not held.covers(first.column, last.row, first.row):
                continue
            if held.words in declared and is_same_condition(match, declared[held.words], held, group):
                known.add(id(held.rule))
                if held.covers(first.column, first.row, last.row):
                    missing.pop(held.words, None)
            else:
                differences.compare(first, group.subject, {}, {"conditional format": held.words})
        for words in missing:
            differences.add(first, group.subject, "conditional format", words, NO_RULE, misleads=False)
    return known


def rule_words(rule: Rule) -> str:
    """Return the effect of a conditional format, but for the cells that its condition reads."""
    flat = {name: str(getattr(rule, name) or "") for name in OF_RULE}
    for sign in (rule.colorScale, rule.dataBar, rule.iconSet):
        flat |= flatten(sign.to_tree()) if sign is not None else {}
        flat |= {"in place of figures": "yes"} if getattr(sign, "showValue", None) is False else {}
    if rule.dxf is not None:
        flat |= flatten(rule.dxf.to_tree("look"))
        flat["numFmt numFmtId"] = ""
        if flat.get("fill patternFill patternType") == "solid":
            flat["fill patternFill patternType"] = ""
        if plain_number(flat.get("numFmt formatCode", "0")) != ("N",):
            flat["another number"] = "yes"
    return in_words(flat)


def is_same_condition(match: Match, rule: Rule, held: PlacedRule, group: CellGroup) -> bool:
    """Whether a rule of a file holds for the same values as a rule of a fresh build."""
    texts, block = [str(text).removeprefix("=") for text in held.rule.formula], group.pairs[0].cell.block
    if rule.type != "expression":
        return bool(texts == rule.formula)
    place, declared = match.file.places[block.name], f"={rule.formula[0]}"
    first = f"A{min(top for _, top, *_ in held.ranges)}"  # the cell for which its formulas are written
    moved = Translator(f"={texts[0]}", first).translate_formula(f"A{place.row}") if texts else ""
    return moved == declared or match.same_formula(declared, block, moved, place.sheet)


def compare_validations(
    match: Match, model: type[BaseModel], groups: list[CellGroup], differences: Differences
) -> None:
    """Enter inputs that have another validation than in a fresh build, or none."""
    placed = {
        sheet.title: [
            PlacedRule(rule, validation_words(rule), [cells.bounds for cells in rule.sqref.ranges])
            for rule in sheet.data_validations.dataValidation
        ]
        for sheet in match.file.workbook.worksheets
    }
    for group in (group for group in groups if group.pairs and group.pairs[0].cell.quantity.role == "input"):
        fresh = validation_words(validation(model, group.pairs[0].cell.quantity))
        for at in (pair.address for pair in group.pairs):
            held = next((rule.words for rule in placed[at.sheet] if rule.covers(at.column, at.row, at.row)), "")
            differences.compare(at, group.subject, {"validation": fresh}, {"validation": held})


def validation_words(rule: Any) -> str:
    """Return the demands and the messages of a validation."""
    return in_words({name: str(getattr(rule, name) or "") for name in OF_VALIDATION})
