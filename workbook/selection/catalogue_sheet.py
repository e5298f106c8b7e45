"""The sheet of motors and reducers, from which drives take theirs by name."""

from workbook.book.declare import Book, columns_of
from workbook.selection.catalogue import FALLING, HALF
from workbook.selection.entries import Products, SelectionSizes

SOURCE = 100  # characters of the column of sources, the same in both tables; it is not printed


def catalogue_sheet(book: Book, products: Products, sizes: SelectionSizes) -> None:
    """Declare the sheet of motors and reducers, from which drives take theirs by name."""
    motor = columns_of(products.motors, "selection.motors", sizes.motors)
    reducer = columns_of(products.reducers, "selection.reducers", sizes.reducers)
    sheet = book.sheet("Catalogue", "Motors and reducers that drives name: add products in the empty rows.")
    sheet.one_page = True
    sheet.heading("Motors and reducers", "No empty row in between. A limit that is not given is none.")
    book.column_names |= {"motor_name": ("motors", "name"), "reducer_name": ("reducers", "name")}
    sheet.table(
        "motors", "Motors", sizes.motors,
        motor("name", "motor", "", "", "name", align="left"),
        motor("inertia", "inertia", "J_M", "kg cm²", "inertia", format="0.0####"),
        motor("stall", "stall torque, if more", "T_0", "Nm", "stall_torque", format="0.0##"),
        motor("rated", "rated torque", "T_N", "Nm", "rated_torque", format="0.0##"),
        motor("nn", "rated speed, if less", "n_N", "rpm", "rated_speed", format="0.##"),
        motor("peak", "peak torque", "T_M,max", "Nm", "peak_torque", format="0.0##"),
        motor("nmax", "largest speed", "n_M,max", "rpm", "max_speed", format="0.##"),
        motor("knee", "peak torque up to, if less", "n_1", "rpm", "full_torque_to", format="0.##"),
        motor("end", "peak torque at n_M,max, if less", "", "Nm", "end_torque", format="0.0##"),
        motor("pcu", "copper losses at T_N", "P_Cu", "kW", "copper_losses", format="0.0##"),
        motor("mass", "mass", "", "kg", "mass", format="0.0##"),
        motor("cost", "cost", "", "", "cost", format="0.##"),
        motor("source", "source", "", "", "source", align="left"),
        rules=[HALF, FALLING],
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        "reducers", "Reducers", sizes.reducers,
        reducer("name", "reducer", "", "", "name", align="left"),
        reducer("i", "reduction", "i", "", "reduction", format="0.0##"),
        reducer("eta", "efficiency", "η", "", "efficiency", format="0.0##"),
        reducer("inertia", "inertia at the input", "J_T", "kg cm²", "inertia", format="0.0####"),
        reducer("t012", "no-load torque at the input", "T_012", "Nm", "no_load_torque", format="0.0##"),
        reducer("nmax", "largest input speed", "", "rpm", "max_speed", format="0.##"),
        reducer("tmax", "largest output torque", "T_2B", "Nm", "max_torque", format="0.0##"),
        reducer("full", "cycles an hour for T_2B", "Z_h", "1/h", "full_cycles", format="0.##"),
        reducer("fs", "T_2B over this beyond", "f_s", "", "cycle_factor", format="0.0##"),
        reducer("t2n", "largest mean output torque", "T_2N", "Nm", "mean_torque", format="0.0##"),
        reducer("mass", "mass", "", "kg", "mass", format="0.0##"),
        reducer("cost", "cost", "", "", "cost", format="0.##"),
        reducer("source", "source", "", "", "source", align="left"),
    )  # fmt: skip
    source = sheet.blocks[0].columns["source"]
    sheet.widths, sheet.print_columns = {source: SOURCE}, source - 1
