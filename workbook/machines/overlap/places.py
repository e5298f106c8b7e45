"""Where each tool stands in the tables that all tools share; rows count from 1."""

from __future__ import annotations

from workbook.book.chart import in_scope
from workbook.machines.overlap.view import Overlapping, Station


def each(machine: Overlapping, formula: str) -> list[str]:
    """Return a formula for each tool, in its scope: the rows of a table over the tools."""
    return [in_scope(formula, station.scope) for station in machine.stations]


def law_rows(station: Station) -> tuple[int, int]:
    """Return the rows of its laws in and out in the table of laws; the transfer's stands in the first."""
    return 2 * station.number, 2 * station.number + 1


def blocked_rows(station: Station) -> tuple[int, int]:
    """Return the rows of the inverted law of the transfer where it begins and ceases to be in the tool's way."""
    return 2 * station.number - 1, 2 * station.number
