"""What can be said of a workbook without evaluating it: functions, names, inputs that nothing reads."""

from collections.abc import Iterator
from typing import NamedTuple

from pydantic import BaseModel

from workbook.entries.rules import field_at
from workbook.judging.matching import Match
from workbook.judging.names import misled

ALLOWED = frozenset([
    "IF", "AND", "OR", "NOT", "MIN", "MAX", "ABS", "SIGN", "SQRT", "SIN", "COS",
    "TAN", "ATAN2", "PI", "EXP", "LN", "LOG10", "POWER", "INT", "ROUND", "SUM", "SUMPRODUCT",
    "AVERAGE", "COUNT", "COUNTIF", "INDEX", "MATCH", "CHOOSE", "LARGE", "SMALL", "ISNUMBER", "RADIANS", "DEGREES",
])  # fmt: skip
VOLATILE = frozenset(["NOW", "TODAY", "RAND", "RANDBETWEEN", "OFFSET", "INDIRECT", "CELL", "INFO", "RANDARRAY"])


class Remark(NamedTuple):
    """Something found without evaluating: where, of what kind, what stands there, what was expected."""

    sheet: str
    cell: str
    kind: str
    found: str
    expected: str


def audit(match: Match, template: type[BaseModel]) -> Iterator[Remark]:
    """Yield what is wrong with formulas, names and inputs of a matched workbook."""
    yield from functions(match)
    yield from own_names(match)
    for found in misled(match):
        yield Remark(
            found.place.sheet, found.place.cell(0, 0).a1, "name", f"{found.name}: {found.found}", found.expected
        )
    yield from unread_inputs(match, template)


def functions(match: Match) -> Iterator[Remark]:
    """Yield cells that should hold another formula: with a function that not every program has, or that is volatile."""
    formulas = match.file.contents.formulas
    for pair in match.pairs:
        formula = formulas.get(pair.address) if pair.declared_formula else None
        for name in sorted(formula.functions - ALLOWED) if formula else ():
            why = "a function that is not volatile" if name in VOLATILE else "a function that every program has"
            yield Remark(pair.address.sheet, pair.address.a1, "function", name, why)


def own_names(match: Match) -> Iterator[Remark]:
    """Yield names that a generated sheet has for itself: its formulas take them for the book's of the same name."""
    declared = {name.casefold() for name, _ in match.declared.names()}
    ours = {pair.address.sheet for pair in match.pairs}
    for sheet in match.file.workbook.worksheets:
        for name, defined in sheet.defined_names.items() if sheet.title in ours else ():
            if name.casefold() in declared:
                yield Remark(sheet.title, name, "name", str(defined.attr_text), "no name of the sheet's own")


def unread_inputs(match: Match, template: type[BaseModel]) -> Iterator[Remark]:
    """Yield inputs that no formula reads; texts that only describe are left out."""
    inputs = [pair for pair in match.pairs if pair.cell.quantity.role == "input" and pair.held is not None]
    read = match.file.contents.read([pair.address for pair in inputs])
    for pair in inputs:
        q = pair.cell.quantity
        if pair.address not in read and (field_at(template, q.key)[0] is not str or q.choices):
            yield Remark(pair.address.sheet, pair.address.a1, "unread", str(pair.held), "an input that a formula reads")
