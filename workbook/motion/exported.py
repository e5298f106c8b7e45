"""The sheet Export: one axis at equal steps, live in cells, to copy and paste."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.motion.pieces import PieceTable
from engine.motion.shifted import Unshifted
from workbook.book.declare import Book, Quantity, calc, constant, result
from workbook.entries.abscissa import ANGLE, Abscissa
from workbook.entries.machine import Exporting, named
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import POSITION, finding, sampled

TITLE = "Export"


class ShiftCells(NamedTuple):
    """By how much a motion is later than its pieces say: the cells that tell it, and the engine's figures."""

    by: str
    near: str
    travel: str  # what a cycle goes on by, nothing where it always comes back
    unshifted: Callable[[Array], Unshifted]
    lifts: float


class Exportable(NamedTuple):
    """An axis that the sheet may have."""

    name: str
    called: str  # the formula of its name
    rows: PieceRows
    units: tuple[str, str, str, str]  # those shown of x, y, y' and y''
    unit: tuple[float, float]  # what one of the motion's x and y is in them
    y_factor: str  # the formula of that for y
    size: Callable[[int], float]  # how large each derivative grows
    later: ShiftCells | None = None
    scope: str = ""  # what the names of its cells begin with
    over: Abscissa = ANGLE  # what a motion in degrees is shown over


def export_sheet(book: Book, given: Exporting, axes: Sequence[Exportable]) -> None:
    """Declare the sheet, where the description asks for one."""
    if given.export is None:
        return
    number, n = given.export.axis, given.sizes.export
    axis = axes[number - 1]
    table = columns(axis, n)
    sheet = book.sheet(
        TITLE, "One axis as a table, to copy and paste; motionbook export writes files and certifies them."
    )
    sheet.heading("Axis")
    with sheet.scoped(axis.scope):
        sheet.rows(
            calc("export_axis", "Axis", "", "", axis.called, axis.name, align="left"),
            constant(named(number), "Number of the axis", "", "", number, source="as the description says"),
            straight_loss(axis, table),
        )
        sheet.row += 1
        sheet.not_printed_below()
        sheet.table("export", f"At {n} equal steps, both ends among them", n + 1, *table)
    sheet.print_columns = 8


def straight_loss(axis: Exportable, table: Sequence[Quantity]) -> Quantity:
    """Return by how much straight lines between the points miss the motion, about."""
    x, accelerations = np.asarray(table[0].value), np.asarray(table[3].value)
    step, most = float(x[1] - x[0]), float(np.abs(accelerations).max())
    formula = "=([export.at.2]-[export.at.first])^2/8*MAX(MAX([export.y2]),0-MIN([export.y2]))"
    return result("export_loss", "Straight lines between the points are off by, about", "", axis.units[1], formula,
                  step**2 / 8.0 * most, source="Δx²/8 · max|y''|; motionbook export places points")  # fmt: skip


def columns(axis: Exportable, n: int) -> list[Quantity]:
    """Return x, y, y' and y'', then how each sample finds its piece."""
    rows, later = axis.rows, axis.later
    at = np.linspace(0.0, rows.end, n + 1)
    told = later.unshifted(at) if later else Unshifted(np.zeros(n + 1), at)
    found = PieceTable(rows.pieces, rows.end).at(told.x)
    values = found.y + told.cycles * (later.lifts if later else 0.0), found.y1, found.y2
    unit, factors = axis.unit[0], [axis.unit[1] / axis.unit[0] ** order for order in range(len(values))]
    per = [axis.over.from_rad(order) if rows.at.degrees else "" for order in range(3)]
    end = axis.over.shown_formula(axis.rows.at.end)
    told_as = (
        ("y", "position", "y", POSITION), ("y1", "velocity", "y'", "dy/dx"), ("y2", "acceleration", "y''", "d²y/dx²"),
    )  # fmt: skip
    found_by = [f"({sampled(rows, order)}){axis.y_factor}{per[order]}" for order in range(len(told_as))]
    found_by[0] += f"+[n]*{later.travel}" if later and later.travel else ""
    at_phases: list[Quantity] = []  # where each sample is as phases tell it, if elsewhere
    if later:
        here = axis.over.degrees_formula("[at]")
        turns = f"=INT((MIN({here},360-2*{later.near})-{later.by}+{later.near})/360)"
        at_phases = [
            calc("n", "cycles", "n", "", turns, told.cycles, format="0"),
            calc("p", "angle of its phases", "", "°", f"={here}-{later.by}-360*[n]",
                 axis.over.degrees(told.x * unit), scale=360.0, format="0.0##"),
        ]  # fmt: skip
    return [
        calc("at", "abscissa", "x", axis.units[0], f"=[k]*{end}/[export.k.last]", at * unit,
             scale=rows.end * unit, format="0.0##"),
        *(result(name, label, symbol, axis.units[order + 1], f"={found_by[order]}", values[order] * factors[order],
                 scale=axis.size(order) * factors[order], source=source)
          for order, (name, label, symbol, source) in enumerate(told_as)),
        constant("k", "sample", "k", "", list(range(n + 1))),
        *at_phases,
        *finding(rows, "p" if later else "at", told.x),
    ]  # fmt: skip
