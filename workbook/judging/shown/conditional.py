"""Conditional formats: which of them apply to a cell that holds a text, and what they make of its look."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from openpyxl.formatting.rule import Rule
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.book.formula import Area, FormulaError, reference

Known = Callable[[Address], Any]  # what a cell holds or computes

TEXT, NUMBER = re.compile(r'"((?:[^"]|"")*)"'), re.compile(r"[+-]?[0-9]+(?:\.[0-9]*)?(?:[eE][+-]?[0-9]+)?")
EQUATION = re.compile(r'\(?\s*([^"=<>()]+?)\s*(=|<>)\s*"([^"]*)"\s*\)?')
ORDERS: dict[str, Callable[[Any, Any], bool]] = {
    "equal": lambda a, b: same(a, b),
    "notEqual": lambda a, b: not same(a, b),
    "greaterThan": lambda a, b: greater(a, b),
    "lessThanOrEqual": lambda a, b: not greater(a, b),
    "lessThan": lambda a, b: greater(b, a),
    "greaterThanOrEqual": lambda a, b: not greater(b, a),
}
PARTS: dict[str, Callable[[str, str], bool]] = {
    "containsText": lambda text, part: part in text,
    "notContainsText": lambda text, part: part not in text,
    "beginsWith": str.startswith,
    "endsWith": str.endswith,
}
ALWAYS = {"notContainsBlanks": True, "containsBlanks": False, "containsErrors": False, "notContainsErrors": True,
          "timePeriod": False, "top10": False, "aboveAverage": False, "colorScale": False, "dataBar": False,
          "iconSet": False}  # fmt: skip
"""of a text"""
NOTHING = ";;;"
"""a number format that shows nothing of anything"""


@dataclass(frozen=True)
class Placed:
    """A rule with the ranges that it covers: top, left, bottom, right."""

    rule: Rule
    ranges: tuple[tuple[int, int, int, int], ...]
    _rows: dict[int, list[tuple[int, int]]] = field(default_factory=dict)

    @property
    def top(self) -> int:
        """The row for which the formulas of the rule are written."""
        return min(top for top, *_ in self.ranges)

    def within(self, column: int) -> list[tuple[int, int]]:
        """Return the rows of a column that the rule covers, from and to."""
        rows = self._rows.get(column)
        if rows is None:
            spans = [(top, bottom) for top, left, bottom, right in self.ranges if left <= column <= right]
            rows = self._rows[column] = spans
        return rows

    def covers(self, row: int, column: int) -> bool:
        """Whether the rule covers a cell."""
        for top, bottom in self.within(column):  # noqa: SIM110 - any() takes twice as long, for every cell
            if top <= row <= bottom:
                return True
        return False


class Rules:
    """The conditional formats of a sheet, the first to be applied first; ``known`` tells what other cells hold."""

    def __init__(self, sheet: Worksheet, known: Known) -> None:
        self._sheet, self._known = sheet.title, known
        self._placed = sorted(placed(sheet), key=lambda p: p.rule.priority or 0)
        self.formats = [(p, code) for p in self._placed if (code := code_of(p.rule))]

    def formats_within(self, column: int, top: int, bottom: int) -> list[tuple[Placed, str]]:
        """Return the rules that give number formats to some of the rows of a column."""
        return [(one, code) for one, code in self.formats
                if any(low <= bottom and top <= high for low, high in one.within(column))]  # fmt: skip

    def formats_of(self, formats: Iterable[tuple[Placed, str]], at: Address, value: Any) -> Iterator[str]:
        """Yield the number formats that rules of ``formats`` give to a cell, or may."""
        for one, code in formats:
            if one.covers(at.row, at.column) and self.applies(one, at, value) is not False:
                yield code

    def on(self, at: Address, value: Any) -> list[tuple[Rule, bool]]:
        """Return the rules that apply to a cell, or may, each with whether that is certain, until one ends it."""
        found = []
        for one in self._placed:
            if not one.covers(at.row, at.column):
                continue
            applies = self.applies(one, at, value)
            if applies is not False:
                found.append((one.rule, applies is True))
            if applies and one.rule.stopIfTrue:
                break
        return found

    def applies(self, one: Placed, at: Address, value: Any) -> bool | None:
        """Return whether a rule applies to a cell with a value; None where that would need a formula evaluated."""
        rule = one.rule
        formulas = [str(text).removeprefix("=") for text in rule.formula]
        if rule.type in PARTS and rule.text is not None and isinstance(value, str):
            return PARTS[rule.type](value.casefold(), str(rule.text).casefold())
        if rule.type == "cellIs":
            return self._compared(rule.operator, [self._value(text, one, at) for text in formulas], value)
        if rule.type == "expression" and formulas:
            return self._true(formulas[0], one, at)
        return ALWAYS.get(rule.type) if isinstance(value, str) else None

    @staticmethod
    def _compared(operator: str | None, others: list[Any], value: Any) -> bool | None:
        if any(other is None for other in others) or not others:
            return None
        if operator in ("between", "notBetween") and len(others) == 2:
            low, high = others
            return (not greater(low, value) and not greater(value, high)) == (operator == "between")
        order = ORDERS.get(operator or "")
        return None if order is None else order(value, others[0])

    def _true(self, text: str, one: Placed, at: Address) -> bool | None:
        """Return whether a formula holds that is a constant, or compares a cell with a text."""
        if text.strip().upper() in ("TRUE", "TRUE()", "1", "FALSE", "FALSE()", "0"):
            return text.strip().upper() in ("TRUE", "TRUE()", "1")
        found = EQUATION.fullmatch(text.strip())
        held = self._value(found[1], one, at) if found else None
        if found is None or held is None:
            return None
        return same(held, found[3]) == (found[2] == "=")

    def _value(self, text: str, one: Placed, at: Address) -> Any:
        """Return what a word of a rule's formula means at a cell: a text, a number, or what a cell holds."""
        if found := TEXT.fullmatch(text.strip()):
            return found[1].replace('""', '"')
        if NUMBER.fullmatch(text.strip()):
            return float(text)
        try:
            area = reference(text.strip(), self._sheet, lambda name, sheet: Area(name[:-1], 1, 1, 1, 1, single=True))
        except FormulaError:
            return None
        top, left = one.top, min(r[1] for r in one.ranges)
        cell = text.rpartition("!")[2]
        row = area.top if re.search(r"\$[0-9]", cell) else area.top + at.row - top
        column = area.left if cell.startswith("$") else area.left + at.column - left
        return self._known(Address(area.sheet, row, column)) if area.single else None


def code_of(rule: Rule) -> str:
    """Return the number format that a rule gives, if it gives any; of bars or icons alone, one that shows nothing."""
    if any(sign is not None and sign.showValue is False for sign in (rule.dataBar, rule.iconSet)):
        return NOTHING
    form = rule.dxf.numFmt if rule.dxf is not None else None
    return str(form.formatCode or "") if form is not None else ""


def placed(sheet: Worksheet) -> Iterator[Placed]:
    """Yield the rules of a sheet with what they cover."""
    for group in sheet.conditional_formatting:
        ranges = tuple((r.min_row, r.min_col, r.max_row, r.max_col) for r in group.sqref.ranges)
        for rule in group.rules:
            if ranges:
                yield Placed(rule, ranges)


def same(one: Any, other: Any) -> bool:
    """Whether two values are equal to a spreadsheet, which knows no capitals."""
    if isinstance(one, str) and isinstance(other, str):
        return one.casefold() == other.casefold()
    return type(one) is type(other) and bool(one == other)


def greater(one: Any, other: Any) -> bool:
    """Whether a value comes after another in a spreadsheet's order: numbers, then texts."""
    if isinstance(one, str) != isinstance(other, str):
        return isinstance(one, str)
    return bool(one.casefold() > other.casefold()) if isinstance(one, str) else bool(one > other)
