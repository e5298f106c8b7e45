"""Every pair of the catalogue on the sheet Selection: motors down, reducers across."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.selection.pair_matrix import MOTOR_LIMITS, PARTS, RANKS
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import FIRST, Quantity, Sheet, Text
from workbook.book.rows import filled
from workbook.fields.units import MM, PER_RPM, RPM, shown
from workbook.selection.catalogue import FULL_CYCLES
from workbook.selection.pair_selection import MIXED, NO_LIMIT, SQUARE, PairSelection

CELLS = cell_tables(__file__)

MOST_USE = 9.99  # that is shown of a limit
USE = 'ROUND(100*[@reducers.use.{}],0)&" %"'
LINE = 4.0  # points of the row with the line below the heads
LARGE = "large"  # beyond the greatest margin; so is a pair that is not in use, and its cell shows nothing
NOTE = (
    "What a pair fails first, in % of that limit: shaft (in the reducer's hub), speed, peak or RMS torque of a motor, "
    "large (RMS torque, beyond the greatest margin), inertia, mass; reducer: see its use; yes: it can do it."
)


def grids(sheet: Sheet, view: PairSelection) -> None:
    """Declare what pairs fail or not, what they use of the rated torque, and their peak torques."""
    g = view.grid
    sheet.heading("Motors by reducers (S5, steps 5 to 7)", NOTE)
    reducer_heads(sheet, view)
    shares = np.char.add(" ", per_cent(np.minimum(g.failing_uses, MOST_USE)))
    grid(sheet, view, "why", np.char.add(g.verdicts, np.where(g.failing_uses > 0.0, shares, "")), "–")
    sheet.print_columns = max(sheet.blocks[-1].columns.values())
    sheet.not_printed_below()
    sheet.heading("Workings: what pairs fail")
    grid(sheet, view, "word", g.verdicts, "–")
    grid(sheet, view, "use", g.failing_uses, scale=max(1.0, float(g.failing_uses.max())))
    grid(sheet, view, "wanted", g.wanted_verdicts, LARGE)
    grid(sheet, view, "share", g.uses, scale=max(1.0, float(g.uses.max())))
    grid(sheet, view, "peak", g.peak, scale=max(float(g.peak.max()), 1e-3))


def grid(
    sheet: Sheet,
    view: PairSelection,
    name: str,
    values: NDArray[Any],
    spare: Any = 0.0,
    scale: float = 0.0,
) -> None:
    """Declare a table of the pairs: a row a motor, a column a reducer below its name; ``spare`` where there is none."""
    down, across = view.rooms
    whole = np.full(view.rooms, spare, dtype=object)
    whole[: values.shape[0], : values.shape[1]] = values
    cells = CELLS[f"grid {name}"].sharing(most=MOST_USE, parts=PARTS, pairs=view.pairs)
    cell, is_printed = CELLS["motors of a grid"], name == "why"
    sheet.row += not is_printed
    names = filled(view.motors.names, down, "")
    counted = [] if is_printed else [cell("k", [*range(1, down + 1)])]
    numbers = [cell("first", [*range(0, down * across, across)])] if name == "key" else counted
    motor = cell("motor", names) if name == "word" else cell("motor", names, formula="=[@word.motor.same]")
    rows = cell.sharing(name=name, title=cells.head[1]).place(sheet, motor, *numbers, heads=not is_printed)
    for c, column in enumerate(whole.T.tolist(), 1):
        unused = "" if scale or name == "key" else f"[@motors.on.same]*[@reducers.on.{c}]=0"
        each = cells.sharing(c=c, before=c - 1)("v", column, scale=scale)
        sheet.beside(rows, f"@{name}{c}", each._replace(good="yes" if is_printed else ""), unused, heads=not is_printed)


def reducer_heads(sheet: Sheet, view: PairSelection) -> None:
    """Declare names, reductions and uses of the reducers, as the heads of the table of pairs."""
    cell, across = CELLS["reducers of a grid"], view.rooms[1]
    names = filled(view.reducers.names, across, "")
    reductions = filled(view.reducers.reduction, across)
    uses = filled(np.char.add(per_cent(view.grid.reducer_uses), " %"), across, "0 %")
    heads = sheet.table("@heads", "", 3, cell("what", ["motor", "reduction", "use of the reducer"]), heads=False)
    for c, each in enumerate(zip(names, reductions, uses, strict=True), 1):
        formulas = [f'=INDEX([reducers.name],{c})&""', f"=[@reducers.i.{c}]+0", f"={USE.format(c)}"]
        head = cell("v", each, c=c, formula=formulas, wrap=True)
        sheet.beside(heads, f"@head{c}", head, f"[@reducers.on.{c}]=0", heads=False)
    sheet.texts += [Text(sheet.row - 1, column, "", "units") for column in range(FIRST, FIRST + 1 + across)]
    sheet.heights[sheet.row - 1] = LINE


def per_cent(shares: Array) -> NDArray[np.str_]:
    """Return shares as texts in %, halves rounded up, as cells do."""
    return np.floor(100.0 * shares + 0.5).astype(int).astype(str)


def products(sheet: Sheet, view: PairSelection) -> None:
    """Declare what the catalogue says of motors and reducers, what each makes of the axis, and what pairs sort by."""
    sheet.heading("Workings: motors, reducers, and what pairs are sorted by")
    numbers = ",".join(f'(@rank="{name}")*{n}' for n, name in enumerate(RANKS, 1))
    sheet.rows(CELLS["products"]("@rank_no", view.rank, numbers=numbers))
    sheet.row += 1
    CELLS["fails"].place(sheet, CELLS["fails"]("word", list(MOTOR_LIMITS)))
    motors(sheet, view)
    reducers(sheet, view)
    keys = np.where(np.isfinite(view.keys), view.keys.astype(object), "–")
    grid(sheet, view, "key", keys, "–")


MASSLESS = 3  # ranks that need neither mass nor cost


def ranking(view: PairSelection, table: str, room: int, mass: Any, cost: Any) -> list[Quantity]:
    """Return the columns of mass or cost of products, as pairs are ranked by it, and of whether that is given.

    Where pairs are ranked by the smallest motor, of motors those that are smaller count in place of these.
    """
    cell = CELLS["weighed"]
    figure = mass if RANKS[view.rank - 1] == "mass" else cost
    known = np.isfinite(figure) if view.rank > MASSLESS else np.ones(len(mass))
    weight = np.nan_to_num(figure) if view.rank > MASSLESS else np.zeros(len(mass))
    smaller, label = "0", "mass or cost"
    if table == "motors":
        smaller, label = "[smaller]", "smaller motors, mass or cost"
        weight = view.grid.smaller if view.rank == 1 else weight
    return [
        cell("known", filled(known.astype(int), room, 0), table=table),
        cell("weight", filled(weight, room), table=table, smaller=smaller, label=label),
    ]


def motors(sheet: Sheet, view: PairSelection) -> None:
    """Declare the motors of the catalogue, 0 in spare rows."""
    cell = CELLS["motors"]
    m, n = view.motors, view.rooms[0]
    cell.place(
        sheet,
        cell("on", filled([1] * len(m.names), n, 0)),
        cell("jm", filled(m.inertia, n)),
        cell("rated", filled(m.rated_torque, n)),
        cell("peak", filled(m.peak_torque, n)),
        cell("nmax", filled(shown(m.max_speed, RPM), n)),
        cell("stall", filled(m.stall, n)),
        cell("nn", filled(shown(m.falls_to, RPM), n)),
        cell("slope", filled((m.stall - m.rated_torque) / shown(m.falls_to, RPM), n), scale=1.0),
        cell("knee", filled(shown(m.knee, RPM), n)),
        cell("fall", filled(shown(m.fall, PER_RPM), n)),
        cell("shaft", filled(np.nan_to_num(shown(m.shaft, MM)), n)),
        cell("mass", filled(np.nan_to_num(m.size), n)),
        cell("smaller", filled(view.grid.smaller, n, 0)),
        *ranking(view, "motors", n, m.size, m.cost),
    )


def reducers(sheet: Sheet, view: PairSelection) -> None:
    """Declare the reducers of the catalogue, 0 in spare rows, and what each makes of the axis."""
    cell = CELLS["reducers"]
    r, g, n = view.reducers, view.grid, view.rooms[1]
    limits = shown(r.max_input_speed, RPM), r.max_output_torque, r.max_mean_torque
    hubs = np.minimum(shown(r.hub, MM), NO_LIMIT)
    speeds, torques, means = (np.where(np.isfinite(limit), limit, 0.0) for limit in limits)
    most = view.requirements.most_mass
    largest = max(float(g.balance.max()), 1e-9)
    reciprocals = np.divide(1.0, g.balance, out=np.zeros(g.balance.shape), where=g.balance > 0.0)
    mixed, square = view.load.mixed(view.bare), view.load.square(view.bare)
    own = {"eta": "[eta]", "i": "[i]", "own": "[own]"}
    cell.place(
        sheet,
        cell("on", filled([1] * len(r.names), n, 0)),
        cell("i", filled(r.reduction, n)),
        cell("eta", filled(r.efficiency, n)),
        cell("jt", filled(g.beside_motor, n)),
        cell("out", filled(1.0 / (r.efficiency * r.reduction), n)),
        cell("back", filled(r.efficiency / r.reduction, n)),
        cell("own", filled(r.no_load, n)),
        cell("j", filled(g.at_motor, n)),
        cell("n", filled(shown(g.speed, RPM), n)),
        cell("fast", filled(shown(g.speed * view.requirements.least_speed, RPM), n)),
        cell("mean", filled(shown(g.load.mean_speed / r.ratio, RPM), n)),
        cell("nmax", filled(speeds, n)),
        cell("tmax", filled(torques, n)),
        cell("fs", filled(g.cycle_factors, n, 1.0), full_cycles=f"{FULL_CYCLES:g}"),
        cell("held", filled(torques / g.cycle_factors, n)),
        cell("tmean", filled(means, n)),
        cell("room", filled(most - np.nan_to_num(r.size), n, most)),
        cell("use", filled(g.reducer_uses, n)),
        cell("fits", filled(g.fits.astype(int), n, 0)),
        cell("takes", filled(np.where(g.fits, hubs, -1.0), n, -1.0)),
        cell("balance", filled(g.balance, n), scale=largest),
        cell("unit", filled(reciprocals, n)),
        cell("mixed", filled(mixed, n), mean=MIXED.format(**own), scale=view.shaft.product),
        cell("square", filled(square, n), mean=SQUARE.format(**own), scale=view.shaft.torque**2),
        *ranking(view, "reducers", n, r.size, r.cost),
    )
