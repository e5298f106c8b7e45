"""The sheets Selection, Pairs and Catalogue: motors by reducers for the axis that is named, within limits, ranked."""

from workbook.book.cell_tables import cell_tables
from workbook.book.chart import in_scope
from workbook.book.declare import FIRST, Book, Sheet, Text
from workbook.book.sentence import CheckSentence
from workbook.entries.facts import entry_cells, table_of
from workbook.selection.best import best_table, order_table
from workbook.selection.catalogue import FALLING, HALF, MotorRow, ReducerRow
from workbook.selection.drives import every_drive, motors_by_drives, named_drive, points_table
from workbook.selection.entries import UNCHOSEN, Limits, Products, SelectionSizes
from workbook.selection.grids import grids, products
from workbook.selection.pair_selection import PairSelection

CELLS = cell_tables(__file__)

TITLE = "Selection"
SOURCE = 100  # characters of the column of sources, the same in both tables; it is not printed


def selection_sheet(book: Book, view: PairSelection, axis: str = "", limits: Limits | None = None) -> None:
    """Declare the sheets of the best pairs and of all; ``axis`` is the entry that names a shaft of several.

    ``limits`` are entered here where no other sheet has them.
    """
    sheet = book.sheet(TITLE, "Motor and reducer from the catalogue for one axis: usable pairs, best first.")
    sheet.widths, sheet.print_columns = {FIRST: 28, FIRST + 1: 28}, COLUMNS
    sheet.one_page = len(view.shafts) <= ON_A_PAGE
    with sheet.scoped("sel_"):
        entries(sheet, view, axis)
        results(sheet, view)
        if axis:
            every_drive(sheet, view)
        best_table(sheet, view)
        sheet.not_printed_below()
        if limits:
            sheet.heading("Enter: what a usable pair holds")
            sheet.rows(*entry_cells(limits, "limits"))
        outcome(sheet, view, axis)
        declare_task(sheet, view)
        sheet.heading("Workings: the axes")
        named_drive(sheet, view)
        points_table(sheet, view)
        if len(view.shafts) > 1:
            motors_by_drives(sheet, view)
    if axis:
        book.column_names["sel_axes"] = ("sel_drives", "axis")
    pairs = book.sheet("Pairs", "Every motor of the catalogue with every reducer: which can do it, what others fail.")
    # to read a page
    pairs.widths = {FIRST: 21, **dict.fromkeys(range(FIRST + 1, FIRST + 1 + view.rooms[1]), 9.4)}
    with pairs.scoped("sel_"):
        grids(pairs, view)
        products(pairs, view)
        order_table(pairs, view)


RESULTS, COLUMNS = 9, 14  # the column of results beside the entries, and the last that is printed
ON_A_PAGE = 8  # rows of axes with which the best pairs fit on a page


def entries(sheet: Sheet, view: PairSelection, axis: str) -> None:
    """Declare the axis, what pairs are ranked by, and how much of a motor a usable pair needs."""
    cell = CELLS["entries"]
    s = view.given
    cell.begin(sheet)
    sheet.rows(*([cell("@axis", axis)] if axis else []), cell("@rank", s.rank), cell("@greatest", s.greatest_margin))


def results(sheet: Sheet, view: PairSelection) -> None:
    """Declare what is proposed, beside the entries."""
    cell = CELLS["results"]
    pair = None if view.proposed is None else view.ranked[view.proposed]
    usable = int((view.grid.verdicts == "yes").sum())
    message = WORDS[(pair is not None, bool(view.ranked), usable > 0, True).index(True)]
    rows = (
        cell("@message", message, formula=MESSAGE),
        cell("@motor", view.motors.names[pair[0]] if pair else "none"),
        cell("@reducer", view.reducers.names[pair[1]] if pair else "none"),
        cell("@usable", usable, words=view.whole("word")),
    )
    for row, q in enumerate(rows, sheet.section + 2):
        sheet.texts.append(Text(row, RESULTS, q.label, "label"))
        sheet.put(q, row, RESULTS + 2)


def outcome(sheet: Sheet, view: PairSelection, axis: str) -> None:
    """Declare whether the axis has a drive, and whether a pair fits."""
    cell = CELLS["outcome"]
    message = str(sheet.book.blocks[in_scope("@message", sheet.scope)].quantities[0].value)
    chosen = "ISNUMBER(@no)" if len(view.shafts) > 1 else "[@drives.axis.1]=@axis"
    sheet.heading("Checks")
    sheet.checks(
        *([cell("@ok_axis", True, chosen=chosen, unchosen=UNCHOSEN)] if axis else []),
        cell("@ok", view.proposed is not None, says=CheckSentence("@message", message)),
    )


def declare_task(sheet: Sheet, view: PairSelection) -> None:
    """Declare what the axis asks for at the shaft behind the reducer."""
    load, scale = view.grid.task, view.shaft.torque
    sheet.heading("What the axis asks for", "At the shaft behind the reducer, exact from the motion's pieces.")
    cell = CELLS["entries"].sharing(scale_size=scale, product=view.shaft.product)
    sheet.rows(
        cell("@wrms", load.acceleration_rms),
        cell("@trms", load.torque_rms),
        cell("@wmax", load.max_speed),
        cell("@tmax", view.grid.output_torque),
        cell("@little", 1.0 / view.given.greatest_margin),
        cell("@beta", 2.0 * (load.acceleration_rms * load.torque_rms + load.power_rate_mean)),
        CELLS["outcome"]("@count", len(view.ranked), keys=view.whole("key")),
    )


WORDS = (
    "the first below its motor's curve",
    "none of the best is below its motor's curve",
    "no usable pair has what it is ranked by",
    "no pair can do it",
)
MESSAGE = '=IF(SUM([@best.holds])>0,"{}",IF(@count>0,"{}",IF(@usable>0,"{}","{}")))'.format(*WORDS)


def catalogue_sheet(book: Book, products: Products, sizes: SelectionSizes) -> None:
    """Declare the sheet of motors and reducers, from which drives take theirs by name."""
    motor = table_of(MotorRow).columns(products.motors, "selection.motors", sizes.motors)
    reducer = table_of(ReducerRow).columns(products.reducers, "selection.reducers", sizes.reducers)
    sheet = book.sheet("Catalogue", "Motors and reducers that drives name: add products in the empty rows.")
    sheet.unprinted = "catalogue" not in book.print_also
    sheet.heading("Motors and reducers", "No empty row in between. A limit that is not given is none.")
    book.column_names |= {"motor_name": ("motors", "name"), "reducer_name": ("reducers", "name")}
    sheet.table("motors", "Motors", sizes.motors, *map(motor, table_of(MotorRow)), rules=[HALF, FALLING])
    sheet.row += 1
    sheet.table("reducers", "Reducers", sizes.reducers, *map(reducer, table_of(ReducerRow)))
    source = sheet.blocks[0].columns["source"]
    sheet.widths, sheet.print_columns = {source: SOURCE}, source - 1
