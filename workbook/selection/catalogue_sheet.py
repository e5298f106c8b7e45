"""The sheet of motors and reducers, from which drives take theirs by name."""

from workbook.book.declare import Book, Quantity, Sheet, given
from workbook.book.rows import filled
from workbook.selection.catalogue import FALLING, HALF
from workbook.selection.entries import Products, SelectionSizes

SOURCE = 100
"""characters of the column of sources, the same in both tables; it is not printed"""


def catalogue_sheet(book: Book, products: Products, sizes: SelectionSizes) -> Sheet:
    """Declare the sheet of motors and reducers, from which drives take theirs by name."""
    sheet = book.sheet("Catalogue", "Motors and reducers that drives name: add products in the empty rows.")
    sheet.one_page = True

    def column(kind: str, rows: int, name: str, entry: str, label: str, symbol: str = "", unit: str = "",
               **more: str) -> Quantity:  # fmt: skip
        values = filled([getattr(row, entry) for row in getattr(products, kind)], rows, None)
        return given(name, label, symbol, unit, values, f"selection.{kind}.*.{entry}", **more)

    sheet.heading("Motors and reducers", "No empty row in between. A limit that is not given is none.")
    n = sizes.motors
    book.column_names |= {"motor_name": ("motors", "name"), "reducer_name": ("reducers", "name")}
    sheet.table(
        "motors", "Motors", n,
        column("motors", n, "name", "name", "motor", align="left"),
        column("motors", n, "inertia", "inertia", "inertia", "J_M", "kg cm²", format="0.0####"),
        column("motors", n, "stall", "stall_torque", "stall torque, if more", "T_0", "Nm", format="0.0##"),
        column("motors", n, "rated", "rated_torque", "rated torque", "T_N", "Nm", format="0.0##"),
        column("motors", n, "nn", "rated_speed", "rated speed, if less", "n_N", "rpm", format="0.##"),
        column("motors", n, "peak", "peak_torque", "peak torque", "T_M,max", "Nm", format="0.0##"),
        column("motors", n, "nmax", "max_speed", "largest speed", "n_M,max", "rpm", format="0.##"),
        column("motors", n, "knee", "full_torque_to", "peak torque up to, if less", "n_1", "rpm", format="0.##"),
        column("motors", n, "end", "end_torque", "peak torque at n_M,max, if less", "", "Nm", format="0.0##"),
        column("motors", n, "pcu", "copper_losses", "copper losses at T_N", "P_Cu", "kW", format="0.0##"),
        column("motors", n, "mass", "mass", "mass", "", "kg", format="0.0##"),
        column("motors", n, "cost", "cost", "cost", format="0.##"),
        column("motors", n, "source", "source", "source", align="left"),
        rules=[HALF, FALLING],
    )  # fmt: skip
    sheet.row += 1
    n = sizes.reducers
    sheet.table(
        "reducers", "Reducers", n,
        column("reducers", n, "name", "name", "reducer", align="left"),
        column("reducers", n, "i", "reduction", "reduction", "i", format="0.0##"),
        column("reducers", n, "eta", "efficiency", "efficiency", "η", format="0.0##"),
        column("reducers", n, "inertia", "inertia", "inertia at the input", "J_T", "kg cm²", format="0.0####"),
        column("reducers", n, "t012", "no_load_torque", "no-load torque at the input", "T_012", "Nm", format="0.0##"),
        column("reducers", n, "nmax", "max_speed", "largest input speed", "", "rpm", format="0.##"),
        column("reducers", n, "tmax", "max_torque", "largest output torque", "T_2B", "Nm", format="0.0##"),
        column("reducers", n, "t2n", "mean_torque", "largest mean output torque", "T_2N", "Nm", format="0.0##"),
        column("reducers", n, "mass", "mass", "mass", "", "kg", format="0.0##"),
        column("reducers", n, "cost", "cost", "cost", format="0.##"),
        column("reducers", n, "source", "source", "source", align="left"),
    )  # fmt: skip
    source = sheet.blocks[0].columns["source"]
    sheet.widths, sheet.print_columns = {source: SOURCE}, source - 1
    return sheet
