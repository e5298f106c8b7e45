"""The sheet of motors and reducers, from which drives take theirs by name."""

from collections.abc import Sequence
from functools import partial

from workbook.book.declare import Book, Quantity, Sheet, given
from workbook.book.rows import filled
from workbook.entries.types import Model
from workbook.selection.catalogue import FALLING, HALF
from workbook.selection.entries import Products, SelectionSizes

SOURCE = 100
"""characters of the column of sources, the same in both tables; it is not printed"""


def catalogue_sheet(book: Book, products: Products, sizes: SelectionSizes) -> Sheet:
    """Declare the sheet of motors and reducers, from which drives take theirs by name."""
    sheet = book.sheet("Catalogue", "Motors and reducers that drives name: add products in the empty rows.")
    sheet.one_page = True
    sheet.heading("Motors and reducers", "No empty row in between. A limit that is not given is none.")
    book.column_names |= {"motor_name": ("motors", "name"), "reducer_name": ("reducers", "name")}
    sheet.table("motors", "Motors", sizes.motors, *motors(products, sizes.motors), rules=[HALF, FALLING])
    sheet.row += 1
    sheet.table("reducers", "Reducers", sizes.reducers, *reducers(products, sizes.reducers))
    source = sheet.blocks[0].columns["source"]
    sheet.widths, sheet.print_columns = {source: SOURCE}, source - 1
    return sheet


def motors(products: Products, rows: int) -> list[Quantity]:
    """Return the columns of the motors."""
    column = partial(entered, "motors", products.motors, rows)
    return [
        column("name", "name", "motor", align="left"),
        column("inertia", "inertia", "inertia", "J_M", "kg cm²", format="0.0####"),
        column("stall", "stall_torque", "stall torque, if more", "T_0", "Nm", format="0.0##"),
        column("rated", "rated_torque", "rated torque", "T_N", "Nm", format="0.0##"),
        column("nn", "rated_speed", "rated speed, if less", "n_N", "rpm", format="0.##"),
        column("peak", "peak_torque", "peak torque", "T_M,max", "Nm", format="0.0##"),
        column("nmax", "max_speed", "largest speed", "n_M,max", "rpm", format="0.##"),
        column("knee", "full_torque_to", "peak torque up to, if less", "n_1", "rpm", format="0.##"),
        column("end", "end_torque", "peak torque at n_M,max, if less", "", "Nm", format="0.0##"),
        column("pcu", "copper_losses", "copper losses at T_N", "P_Cu", "kW", format="0.0##"),
        column("mass", "mass", "mass", "", "kg", format="0.0##"),
        column("cost", "cost", "cost", format="0.##"),
        column("source", "source", "source", align="left"),
    ]  # fmt: skip


def reducers(products: Products, rows: int) -> list[Quantity]:
    """Return the columns of the reducers."""
    column = partial(entered, "reducers", products.reducers, rows)
    return [
        column("name", "name", "reducer", align="left"),
        column("i", "reduction", "reduction", "i", format="0.0##"),
        column("eta", "efficiency", "efficiency", "η", format="0.0##"),
        column("inertia", "inertia", "inertia at the input", "J_T", "kg cm²", format="0.0####"),
        column("t012", "no_load_torque", "no-load torque at the input", "T_012", "Nm", format="0.0##"),
        column("nmax", "max_speed", "largest input speed", "", "rpm", format="0.##"),
        column("tmax", "max_torque", "largest output torque", "T_2B", "Nm", format="0.0##"),
        column("full", "full_cycles", "cycles an hour for T_2B", "Z_h", "1/h", format="0.##"),
        column("fs", "cycle_factor", "T_2B over this beyond", "f_s", format="0.0##"),
        column("t2n", "mean_torque", "largest mean output torque", "T_2N", "Nm", format="0.0##"),
        column("mass", "mass", "mass", "", "kg", format="0.0##"),
        column("cost", "cost", "cost", format="0.##"),
        column("source", "source", "source", align="left"),
    ]  # fmt: skip


def entered(kind: str, products: Sequence[Model], rows: int, name: str, entry: str, label: str, symbol: str = "",
            unit: str = "", **more: str) -> Quantity:  # fmt: skip
    """Return the column of an entry of products."""
    values = filled([getattr(row, entry) for row in products], rows, None)
    return given(name, label, symbol, unit, values, f"selection.{kind}.*.{entry}", **more)
