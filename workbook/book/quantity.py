"""A quantity of the field, declared once: its cell, its documentation, its input's rule, the engine's value."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

from workbook.book.chart import in_scope
from workbook.book.sentence import Said, Sentence, quoted

HOLDS, FAILS = "", "not met"
SAYS, WHERE = "_says", ": where, and by how much"
"""behind the name of a check, and behind its label: the cell that says where it fails"""
WANTED = ": what is expected"  # behind the label of an entry: the message beside it

FLOOR = 1e-3  # of the unit: that much of most quantities is next to nothing
FLOORS = {"kg m²": 1e-9, "kg cm²": 1e-5, "m²/rad⁴": 1e-6}  # and of those of which it is not

ROUNDED, MOST = 1e-9, 1e9  # of figures beside a limit: the share of it that rounding may add, and what none is above

Role = Literal["input", "calculation", "result", "check", "constant", "sentence", "title"]


class Quantity(NamedTuple):
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
    wrap: bool = False  # whether its texts take several lines, and their column need hold their words alone
    rule: str = ""
    """of a check: the rule of the entries that it mirrors, behind the place of these in the description and a colon"""
    limit: float = 0.0  # of figures beside a limit: above it they are shown as beyond it; none by default
    says: str = ""  # of a check: the formula of where it fails, and by how much
    said: str = ""  # what that formula gives, by the engine, where the check fails

    @property
    def beside(self) -> str:
        """The label that stands in its row: of a sentence that of its check, of a message that of its entry."""
        return self.label.removesuffix(WHERE).removesuffix(WANTED)

    @property
    def floor(self) -> float:
        """What deviations are measured against at least."""
        return self.scale or FLOORS.get(self.unit, FLOOR)

    def within(self, scope: str) -> Quantity:
        """Return the quantity with ``scope`` for each ``@`` in its name and formulas."""
        formula = self.formula
        texts = (self.name, self.says, *((formula,) if isinstance(formula, str) else formula or ()))
        if not any("@" in text for text in texts):
            return self
        if formula is not None:
            formula = in_scope(formula, scope) if isinstance(formula, str) else [in_scope(f, scope) for f in formula]
        return self._replace(name=in_scope(self.name, scope), formula=formula, says=in_scope(self.says, scope))


def given(name: str, label: str, symbol: str, unit: str, value: Any, key: str, **more: Any) -> Quantity:
    """Return an input: a cell that the engineer fills.

    Parameters
    ----------
    name : str
        Name of its cell, without blanks; ``@`` stands for the sheet's scope.
    label, symbol : str
        What it is called, and its symbol.
    unit : str
        As the sheet shows it; empty without one.
    value : float, int, str or sequence of them, in ``unit``
        What the description has; a sequence fills a column.
    key : str
        Where the description keeps it, dotted.
    **more
        Further fields of :class:`Quantity`.

    Returns
    -------
    Quantity
        Placed by a :class:`Sheet`.
    """
    return Quantity(name, label, symbol, unit, "input", None, value, key=key, **more)


def calc(name: str, label: str, symbol: str, unit: str, formula: Any, value: Any, **more: Any) -> Quantity:
    """Return a working: a formula cell on the way to a result.

    Parameters
    ----------
    name : str
        Name of its cell, without blanks; ``@`` stands for the sheet's scope.
    label, symbol : str
        What it is called, and its symbol.
    unit : str
        As the sheet shows it; empty without one.
    formula : str or sequence of str
        With ``[name]`` for cells of the same table, ``[table.column]`` for others.
    value : float, int, str or sequence of them, in ``unit``
        What the cell must compute, by other means than its formula.
    **more
        Further fields of :class:`Quantity`.

    Returns
    -------
    Quantity
        Placed by a :class:`Sheet`.
    """
    return Quantity(name, label, symbol, unit, "calculation", formula, value, **more)


def result(name: str, label: str, symbol: str, unit: str, formula: Any, value: Any, **more: Any) -> Quantity:
    """Return a result: a formula cell that the engineer came for.

    Parameters
    ----------
    name, label, symbol, unit, formula, value, **more
        As of :func:`calc`.

    Returns
    -------
    Quantity
        Placed by a :class:`Sheet`.
    """
    return Quantity(name, label, symbol, unit, "result", formula, value, **more)


def constant(name: str, label: str, symbol: str, unit: str, value: Any, **more: Any) -> Quantity:
    """Return a number or text that belongs to the method and not to the machine: locked, and verified.

    Parameters
    ----------
    name, label, symbol, unit, value, **more
        As of :func:`calc`.

    Returns
    -------
    Quantity
        Placed by a :class:`Sheet`.
    """
    return Quantity(name, label, symbol, unit, "constant", None, value, **more)


def check(
    name: str, label: str, condition: str, ok: bool, source: str = "", rule: str = "", says: str | Said = "",
) -> Quantity:  # fmt: skip
    """Return a check: a cell that says OK where a condition is met and FAIL where it is not.

    Parameters
    ----------
    name, label : str
        As of :func:`calc`.
    condition : str
        Formula without =, TRUE where the check is passed.
    ok : bool
        What it is, by other means than the formula.
    source : str
        What the check is about, beside it.
    rule : str
        The rule of the entries that it mirrors.
    says : str or Said
        Formula, without =, of the sentence beside it where it fails; with what it gives, where it mirrors no rule.

    Returns
    -------
    Quantity
        Placed by ``Sheet.checks``.
    """
    formula = f'=IF({condition},"OK","FAIL")'
    verdict = "OK" if ok else "FAIL"
    text, said = says if isinstance(says, Said) else (says, "")
    return Quantity(name, label, "", "", "check", formula, verdict, source=source, rule=rule, says=text, said=said)


def sentence(q: Quantity) -> Quantity:
    """Return the cell beside a check, which says where it fails and by how much; else what the check is about."""
    holds = q.source or HOLDS
    formula = f'=IF({q.name}="OK",{quoted(holds)},{q.says or quoted(FAILS)})'
    value = holds if q.value == "OK" else Sentence(q.said or FAILS)
    return Quantity(f"{q.name}{SAYS}", f"{q.label}{WHERE}", "", "", "sentence", formula, value,
                    align="left")  # fmt: skip
