"""The rows of the tables that all tools share."""

from __future__ import annotations

from workbook.book.chart import in_scope
from workbook.machines.overlap.view import Overlapping


def each(machine: Overlapping, formula: str) -> list[str]:
    """Return a formula for each tool, in its scope: the rows of a table over the tools."""
    return [in_scope(formula, station.scope) for station in machine.stations]
