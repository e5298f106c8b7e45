"""The Markdown tables beside the modules of laws' pages: parameters, pieces, coefficients and checks."""

from typing import Any

from workbook.book.cell_tables import CellTable, formulas_by_row, value_of
from workbook.laws.family import ENTRIES, LawCheck, Parameter, PieceRow


def parameters_in(table: CellTable) -> tuple[Parameter, ...]:
    """Return the parameters in a table: each its cell and label, its key, and what is above it among functions."""
    return tuple(Parameter(**fields_of(Parameter, row.texts)) for row in table.values())


def checks_in(table: CellTable) -> tuple[LawCheck, ...]:
    """Return the checks in a table."""
    return tuple(LawCheck(**fields_of(LawCheck, row.texts)) for row in table.values())


def pieces_in(table: CellTable) -> tuple[PieceRow, ...]:
    """Return the pieces in a table: each its words and equation, and the formulas of its entries that are not 0."""
    heads = ("name", "equation", *ENTRIES)
    return tuple(PieceRow(**{head: row.texts[head] for head in heads if head in row.texts}) for row in table.values())


def coefficients_in(table: CellTable) -> dict[str, tuple[str, str]]:
    """Return the formula of each coefficient in a table, and its equation in words."""
    return {name: (row.texts["formula"], row.texts["source"]) for name, row in table.items()}


def variations_in(module: str, title: str) -> tuple[dict[str, Any], ...]:
    """Return the variations in the table under a heading beside a module: a row each, the entries by their columns."""
    columns = formulas_by_row(module, title)
    rows = zip(*columns.values(), strict=True)
    return tuple(dict(zip(columns, map(value_of, row), strict=True)) for row in rows)


def fields_of(kind: Any, texts: dict[str, str]) -> dict[str, str]:
    """Return the texts that are fields of a named tuple."""
    return {field: texts[field] for field in kind._fields if field in texts}
