"""The sheets Selection, Pairs and Catalogue: motors by reducers for the axis that is named, within limits, ranked."""

from workbook.book.declare import FIRST, Book, Sheet, calc, check, columns_of, given, result
from workbook.book.sentence import CheckSentence
from workbook.selection.best import best_table, chart, order_table, points_of_pairs
from workbook.selection.catalogue import FALLING, HALF
from workbook.selection.drives import every_drive, motors_by_drives, named_drive, points_table
from workbook.selection.entries import UNCHOSEN, Limits, Products, SelectionSizes
from workbook.selection.grids import grids, products
from workbook.selection.limits import limit_cells
from workbook.selection.pair_selection import PairSelection, rms_of

TITLE = "Selection"
SOURCE = 100  # characters of the column of sources, the same in both tables; it is not printed
ABOUT = (
    "A motor and a reducer are chosen where their names are entered, on the sheet of the drive: this sheet shows which "
    "pairs of the catalogue can do it."
)


def selection_sheet(book: Book, view: PairSelection, axis: str = "", limits: Limits | None = None) -> None:
    """Declare the sheets of the best pairs and of all; ``axis`` is the entry that names one of several shafts.

    ``limits`` are entered here where no other sheet has them.
    """
    sheet = book.sheet(TITLE, "Motor and reducer from the catalogue for one axis: usable pairs, best first.")
    with sheet.scoped("sel_"):
        entries(sheet, view, axis, limits)
        outcome(sheet, view, axis)
        best_table(sheet, view)
        chart(sheet)
        if len(view.shafts) > 1:
            every_drive(sheet, view)
        sheet.not_printed_below()
        sheet.heading("Workings: the axes")
        named_drive(sheet, view)
        points_table(sheet, view)
        points_of_pairs(sheet, view)
        if len(view.shafts) > 1:
            motors_by_drives(sheet, view)
    if axis:
        book.column_names["sel_axes"] = ("sel_drives", "axis")
    sheet.print_columns = 16
    pairs = book.sheet("Pairs", "Every motor of the catalogue with every reducer: which can do it, what others fail.")
    pairs.widths = {FIRST: 26, **dict.fromkeys(range(FIRST + 1, FIRST + 2 + view.rooms[1]), 8.5)}  # to read a page
    with pairs.scoped("sel_"):
        grids(pairs, view)
        products(pairs, view)
        order_table(pairs, view)


def entries(sheet: Sheet, view: PairSelection, axis: str, limits: Limits | None) -> None:
    """Declare the axis, what pairs are ranked by, what a usable one holds, and what the axis asks for."""
    s = view.given
    sheet.heading("Enter", ABOUT)
    sheet.rows(
        *([given("@axis", "Axis", "", "", axis, "selection.axis", choices="=sel_axes", align="left",
                 source="one with a drive")] if axis else []),
        given("@rank", "Rank usable pairs by", "", "", s.rank, "selection.rank", align="left",
              source="smallest motor: the least rated torque, then the least of it used"),
        given("@greatest", "Greatest margin", "", "", s.greatest_margin, "selection.greatest_margin", format="0.0##",
              source="continuous torque at the mean speed / T_rms: so that no motor is far too large"),
        *(limit_cells(limits) if limits else ()),
    )  # fmt: skip
    load = view.grid.task
    scale = view.shaft.torque
    sheet.heading("What the axis asks for", "At the shaft behind the reducer, exact from the motion's pieces.")
    sheet.rows(
        calc("@wrms", "RMS acceleration", "ω̇_rms", "rad/s²", "=SQRT(@own)", load.acceleration_rms),
        calc("@trms", "RMS torque", "S_rms", "Nm", "=SQRT(@square+@square_back)", load.torque_rms, scale=scale),
        calc("@wmax", "Largest speed", "ω", "rad/s", "=@speed+0", load.max_speed),
        calc("@tmax", "Torque that the reducer must carry", "f S_max", "Nm", "=@torque_factor*@smax",
             view.grid.output_torque, scale=scale),
        calc("@little", "Least share of it", "", "", "=1/@greatest", 1.0 / view.given.greatest_margin),
        result("@beta", "Load factor", "β", "W/s", "=2*(@wrms*@trms+@product+@product_back)",
               2.0 * (load.acceleration_rms * load.torque_rms + load.power_rate_mean),
               "2 (ω̇_rms S_rms + mean ω̇ S); S5, eq. (15)", scale=view.shaft.product),
    )  # fmt: skip


def outcome(sheet: Sheet, view: PairSelection, axis: str) -> None:
    """Declare what is proposed, and what the pair does that the drive has."""
    pair = None if view.proposed is None else view.ranked[view.proposed]
    first = "INDEX([@best.{0}],MATCH(1,[@best.holds],0))"
    there = "SUM([@best.holds])=0"
    usable = int((view.grid.verdicts == "yes").sum())
    message = WORDS[(pair is not None, bool(view.ranked), usable > 0, True).index(True)]
    sheet.heading("Results")
    sheet.rows(
        result("@message", "In words", "", "", MESSAGE, message, align="left"),
        result("@motor", "Proposed motor", "", "", f'=IF({there},"none",{first.format("motor")})',
               view.motors.names[pair[0]] if pair else "none", align="left"),
        result("@reducer", "Proposed reducer", "", "", f'=IF({there},"none",{first.format("reducer")})',
               view.reducers.names[pair[1]] if pair else "none", align="left"),
        result("@usable", "Usable pairs", "", "", f'=COUNTIF({view.whole("word")},"yes")', usable, format="0"),
        calc("@count", "… of these, ranked", "", "", f"=COUNT({view.whole('key')})", len(view.ranked),
             "those that have the mass or cost they are ranked by", format="0"),
    )  # fmt: skip
    sheet.checks(
        *([check("@ok_axis", "Selection: its axis has a drive",
                 "ISNUMBER(@no)" if len(view.shafts) > 1 else "[@drives.axis.1]=@axis", True, rule=":chosen",
                 says=f'"{UNCHOSEN}"&@axis')] if axis else []),
        check("@ok", "Selection: a motor and a reducer fit", "SUM([@best.holds])>0", pair is not None,
              says=CheckSentence("@message", message))
    )  # fmt: skip
    sheet.heading("The pair that the drive has")
    (motor, reducer), own, torque = view.names_in_use, view.own, max(view.own.peak, 1e-3)
    rms = rms_of("@held_j", "@held_i", "@held_mixed", "@held_square")
    sheet.rows(
        result("@own_motor", "Motor", "", "", "=@held_motor&\"\"", motor, align="left"),
        result("@own_reducer", "Reducer", "", "", "=@held_reducer&\"\"", reducer, align="left"),
        result("@own_rms", "RMS torque of the motor", "T_rms", "Nm", f"={rms}", own.rms, "that of the drive's sheet",
               scale=torque),
        result("@own_margin", "Margin", "", "", "=IF(@own_rms>0,@held_rated/@own_rms,0)", own.margin,
               "continuous torque / T_rms"),
        result("@own_peak", "Peak torque of the motor", "T_max", "Nm", "=@held_top+0", own.peak,
               "that of the drive's sheet", scale=torque),
        result("@own_speed", "Largest speed of the motor", "n_max", "rpm", "=@speed*@held_i*30/PI()", own.speed),
        result("@own_inertias", "Inertia ratio", "", "",
               "=IF(@held_jm>0,(@held_j-@held_jm+@inertia/@held_i^2)/@held_jm,0)", own.inertias),
        result("@own_spare", "Least reserve below the motor's curve", "", "Nm", "=@held_spare+0", own.spare,
               "that of the drive's sheet", scale=torque),
    )  # fmt: skip


WORDS = (
    "the first below its motor's curve", "none of the best is below its motor's curve",
    "no usable pair has what it is ranked by", "no pair can do it",
)  # fmt: skip
MESSAGE = '=IF(SUM([@best.holds])>0,"{}",IF(@count>0,"{}",IF(@usable>0,"{}","{}")))'.format(*WORDS)


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
