"""A quantity of the field, declared once: its cell, its documentation, its input's rule, the engine's value."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from workbook.book.chart import in_scope

FLOOR = 1e-3
"""of the unit: that much of most quantities is next to nothing"""
FLOORS = {"kg m²": 1e-9, "m²/rad⁴": 1e-6}
"""and of those of which it is not"""

Role = Literal["input", "calculation", "result", "check", "constant"]


@dataclass(frozen=True)
class Quantity:
    """A quantity of the field: what it is called, how its cell computes it, what the engine says of it.

    ``value`` is what an input or constant holds, or the engine's value of a formula; in a table, one
    value for each row. ``formula`` is one text for all rows, or one for each row. ``key`` is the place
    of an input in the machine description, with ``*`` for the table's row.

    A deviation is measured against the greatest size in the column, and never against less than :attr:`floor`:
    that of the unit, or ``scale`` where zeros come from rounding numbers of a size that must be named.
    """

    name: str
    label: str
    symbol: str = ""
    unit: str = ""
    role: Role = "calculation"
    formula: str | Sequence[str] | None = None
    value: Any = None
    source: str = ""
    key: str = ""
    scale: float = 0.0
    format: str = ""
    choices: str = ""
    align: str = ""

    @property
    def floor(self) -> float:
        """What deviations are measured against at least."""
        return self.scale or FLOORS.get(self.unit, FLOOR)

    def within(self, scope: str) -> Quantity:
        """Return the quantity with ``scope`` for each ``@`` in its name and formulas."""
        formula = self.formula
        if formula is not None:
            formula = in_scope(formula, scope) if isinstance(formula, str) else [in_scope(f, scope) for f in formula]
        return replace(self, name=in_scope(self.name, scope), formula=formula)


def given(name: str, label: str, symbol: str, unit: str, value: Any, key: str, **more: Any) -> Quantity:
    """Return an input: a cell that the engineer fills, kept at ``key`` of the machine description."""
    return Quantity(name, label, symbol, unit, "input", None, value, key=key, **more)


def calc(name: str, label: str, symbol: str, unit: str, formula: Any, value: Any, **more: Any) -> Quantity:
    """Return a working: a formula cell on the way to a result."""
    return Quantity(name, label, symbol, unit, "calculation", formula, value, **more)


def result(name: str, label: str, symbol: str, unit: str, formula: Any, value: Any, **more: Any) -> Quantity:
    """Return a result: a formula cell that the engineer came for."""
    return Quantity(name, label, symbol, unit, "result", formula, value, **more)


def constant(name: str, label: str, symbol: str, unit: str, value: Any, **more: Any) -> Quantity:
    """Return a number or text that belongs to the method, not to the machine: locked, and verified."""
    return Quantity(name, label, symbol, unit, "constant", None, value, **more)


def check(name: str, label: str, condition: str, ok: bool, source: str = "") -> Quantity:
    """Return a check: a cell that says OK where ``condition`` holds and FAIL where it does not."""
    formula = f'=IF({condition},"OK","FAIL")'
    return Quantity(name, label, "", "", "check", formula, "OK" if ok else "FAIL", source=source)
