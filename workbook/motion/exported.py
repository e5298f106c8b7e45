"""The sheet Export: an axis at equal steps, live in cells, to copy and paste."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.motion.pieces import MotionPieces
from engine.motion.shifted import Unshifted
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Quantity
from workbook.entries.abscissa import ANGLE, Abscissa
from workbook.entries.machine import Exporting, number_cell
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import at_sample, workings_at

CELLS = cell_tables(__file__)

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
    unit: tuple[float, float]  # the motion's units of x and y in them
    y_factor: str  # the formula of that for y
    size: Callable[[int], float]  # how large each derivative grows
    later: ShiftCells | None = None
    scope: str = ""  # what the names of its cells begin with
    over: Abscissa = ANGLE  # what a motion in degrees is shown over


def export_sheet(book: Book, given: Exporting, axes: Sequence[Exportable]) -> None:
    """Declare the sheet, where the description asks for it."""
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
            CELLS["export_sheet"]("export_axis", axis.name, formula=axis.called),
            CELLS["export_sheet"]("{named}", number, named=number_cell(number)),
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
    return CELLS["straight_loss"]("export_loss", step**2 / 8.0 * most, unit=axis.units[1])


def columns(axis: Exportable, n: int) -> list[Quantity]:
    """Return x, y, y' and y'', then how each sample finds its piece."""
    cell, rows, later, unit = CELLS["columns"], axis.rows, axis.later, axis.unit[0]
    at = np.linspace(0.0, rows.end, n + 1)
    unshifted = later.unshifted(at) if later else Unshifted(np.zeros(n + 1), at)
    samples = MotionPieces(rows.pieces, rows.end).at(unshifted.x)
    values = samples.y + unshifted.cycles * (later.lifts if later else 0.0), samples.y1, samples.y2

    def derivative(name: str, order: int, goes_on: str = "") -> Quantity:
        factor = axis.unit[1] / unit**order
        per = axis.over.from_rad(order) if rows.at.degrees else ""
        shows = f"({at_sample(rows, order)}){axis.y_factor}{per}{goes_on}"
        size, own = axis.size(order) * factor, axis.units[order + 1]
        return cell(name, values[order] * factor, unit=own, sampled=shows, scale=size)

    at_phases: list[Quantity] = []  # where each sample is by its phases, if elsewhere
    if later:
        here = axis.over.degrees_formula("[at]")
        at_phases = [
            cell("n", unshifted.cycles, here=here, later=later),
            cell("p", axis.over.degrees(unshifted.x * unit), here=here, later=later, scale=360.0),
        ]
    end = axis.over.shown_formula(rows.at.end)
    return [
        cell("at", at * unit, unit=axis.units[0], end=end, scale=rows.end * unit),
        derivative("y", 0, f"+[n]*{later.travel}" if later and later.travel else ""),
        derivative("y1", 1),
        derivative("y2", 2),
        cell("k", list(range(n + 1))),
        *at_phases,
        *workings_at(rows, "p" if later else "at", unshifted.x),
    ]
