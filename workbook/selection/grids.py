"""Every pair of the catalogue on the sheet Selection: motors down, reducers across."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from engine.selection.pair_matrix import PARTS, RANKS
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import filled
from workbook.fields.units import MM, PER_RPM, RPM, shown
from workbook.selection.catalogue import FULL_CYCLES
from workbook.selection.pair_selection import MIXED, NO_LIMIT, SQUARE, PairSelection, rms_of, torque_of

CELLS = cell_tables(__file__)

LARGE = "large"  # beyond the greatest margin; so is a pair that is not in use, and its cell shows nothing
NOTE = (
    "What a pair fails first: reducer (its torque or speed), shaft (too thick for its hub), speed, peak or RMS torque "
    "of the motor, large (beyond the greatest margin), inertia, mass; yes: it can do it."
)
TITLES = {
    "word": "Which pairs can do it",
    "wanted": "What is wanted of a pair",
    "share": "RMS torque of the motor over its continuous torque",
    "peak": "Peak torque of the motor [Nm]",
    "key": "What pairs are sorted by: what they are ranked by, then place",
}


def grids(sheet: Sheet, view: PairSelection) -> None:
    """Declare what pairs fail or not, what they use of the rated torque, and their peak torques."""
    g = view.grid
    sheet.heading("Motors by reducers (S5, steps 5 to 7)", NOTE)
    grid(sheet, view, "word", verdict, g.verdicts, "–")
    sheet.print_columns = max(sheet.blocks[-1].columns.values())
    sheet.not_printed_below()
    grid(sheet, view, "wanted", wanted, g.wanted_verdicts, LARGE)
    grid(sheet, view, "share", share, g.uses, scale=max(1.0, float(g.uses.max())))
    grid(sheet, view, "peak", peak, g.peak, scale=max(float(g.peak.max()), 1e-3))


def grid(
    sheet: Sheet,
    view: PairSelection,
    name: str,
    formula: Callable[[int], str],
    values: NDArray[Any],
    spare: Any = 0.0,
    scale: float = 0.0,
) -> None:
    """Declare a table of the pairs: a row a motor, a column a reducer below its name; ``spare`` where there is none."""
    down, across = view.rooms
    whole = np.full(view.rooms, spare, dtype=object)
    whole[: values.shape[0], : values.shape[1]] = values
    sheet.row += 1
    grid_heads(sheet, view, name)
    cell = CELLS["motors of a grid"]
    names = filled(view.motors.names, down, "")
    rows = cell.sharing(name=name, title=TITLES[name]).place(
        sheet,
        cell("motor", names) if name == "word" else cell("motor", names, formula="=[@word.motor.same]"),
        cell("first", list(range(0, down * across, across))) if name == "key" else cell("k", list(range(1, down + 1))),
    )
    for c, column in enumerate(whole.T.tolist(), 1):
        unused = f"[@motors.on.same]*[@reducers.on.{c}]=0" if name in ("wanted", "word") else ""
        each = CELLS[f"grid {name}"]("v", column, c=c, formula=f"={formula(c)}", scale=scale)._replace(
            good="yes" if name == "word" else ""
        )
        sheet.beside(rows, f"@{name}{c}", each, unused)


def grid_heads(sheet: Sheet, view: PairSelection, name: str) -> None:
    """Declare the names and reductions of the reducers above a table of the pairs."""
    cell, across = CELLS["reducers of a grid"], view.rooms[1]
    names = filled(view.reducers.names, across, "")
    reductions = filled(view.reducers.reduction, across)
    words = cell("what", ["name", "reduction"]), cell("k", [1, 2])
    heads = sheet.table(f"@{name}_heads", "Reducers: name, reduction", 2, *words)
    for c, both in enumerate(zip(names, reductions, strict=True), 1):
        formulas = [f'=INDEX([reducers.name],{c})&""', f"=[@reducers.i.{c}]+0"]
        sheet.beside(
            heads, f"@{name}_head{c}", cell("v", both, c=c, formula=formulas, wrap=True), f"[@reducers.on.{c}]=0"
        )


def of_motor(figure: str) -> str:
    """Return a figure of the motor of a row."""
    return f"[@motors.{figure}.same]"


def share(c: int) -> str:
    """Return the formula of the RMS torque of the motor of a row with a reducer, over its continuous torque."""
    inertia = f"({of_motor('jm')}+[@reducers.jt.{c}])"
    rms = rms_of(inertia, *(f"[@reducers.{name}.{c}]" for name in ("i", "mixed", "square")))
    return f"IF({of_motor('on')}*[@reducers.on.{c}],{rms}/{continuous(f'[@reducers.mean.{c}]')},0)"


def continuous(mean: str) -> str:
    """Return the formula of the continuous torque of the motor of a row at a mean speed."""
    return f"MAX({of_motor('rated')},{of_motor('stall')}-{of_motor('slope')}*{mean})"


def peak(c: int) -> str:
    """Return the formula of the peak torque of the motor of a row; no program takes ABS of an array in MAX alike."""
    inertia = f"({of_motor('jm')}+[@reducers.jt.{c}])"
    torques = torque_of(inertia, *(f"[@reducers.{name}.{c}]" for name in ("i", "out", "back", "own")))
    return f"IF({of_motor('on')}*[@reducers.on.{c}],SUMPRODUCT(MAX(({torques})^2))^0.5,0)"


def margin_verdict(table: str, n: int, inertia: str, room: str, limit: str) -> str:
    """Return the formula of the margin, inertia ratio or mass that a motor misses in the n-th column; yes if none.

    ``limit`` is the cell of a limit, with {} for its name.
    """
    used, most = f"[@{table}share{n}.v.same]", f"{limit.format('inertia_ratio')}*{of_motor('jm')}"
    light = f'IF({of_motor("mass")}>[{room}.{n}],"mass","yes")'
    other = f'IF({used}<@little,"{LARGE}",IF([{inertia}.{n}]>{most},"inertia",{light}))'
    return f'IF({used}*{limit.format("rms_reserve")}>1,"RMS",{other})'


def first_failure(table: str, n: int, fast: str, limit: str) -> str:
    """Return the formula of what a motor fails first in the n-th column: speed, peak torque, or another limit."""
    peak = f"[@{table}peak{n}.v.same]*{limit.format('peak_reserve')}"
    other = f'IF({peak}>{of_motor("peak")},"peak",[@{table}wanted{n}.v.same])'
    return f'IF([{fast}.{n}]>{of_motor("nmax")},"speed",{other})'


def verdict(c: int) -> str:
    """Return the formula of what a pair fails first: its reducer, its shaft in the reducer's hub, or its motor."""
    takes, motor = f"[@reducers.takes.{c}]", first_failure("", c, "@reducers.fast", "@{}")
    built = f'IF({of_motor("shaft")}>{takes},IF({takes}<0,"reducer","shaft"),{motor})'
    return f'IF({of_motor("on")}*[@reducers.on.{c}]=0,"–",{built})'


def wanted(c: int) -> str:
    """Return the formula of the margin or inertia ratio that a pair misses."""
    return margin_verdict("", c, "@reducers.j", "@reducers.room", "@{}")


def products(sheet: Sheet, view: PairSelection) -> None:
    """Declare what the catalogue says of motors and reducers, what each makes of the axis, and what pairs sort by."""
    sheet.heading("Workings: motors, reducers, and what pairs are sorted by")
    numbers = ",".join(f'(@rank="{name}")*{n}' for n, name in enumerate(RANKS, 1))
    sheet.rows(CELLS["products"]("@rank_no", view.rank, numbers=numbers))
    sheet.row += 1
    motors(sheet, view)
    reducers(sheet, view)
    keys = np.where(np.isfinite(view.keys), view.keys.astype(object), "–")
    grid(sheet, view, "key", lambda c: key(view, c), keys, "–")


def key(view: PairSelection, c: int) -> str:
    """Return the formula of what a pair is sorted by: what it is ranked by, the lowest first, and its place."""
    balance, inertia = f"[@reducers.balance.{c}]", f"({of_motor('jm')}+[@reducers.jt.{c}])"
    match = f"MAX({balance}/{inertia},{inertia}*[@reducers.unit.{c}])^0.5"
    used = f"(@rank_no<3)*(1-1/(1+[@share{c}.v.same]))"
    score = f"{of_motor('weight')}+[@reducers.weight.{c}]+IF(@rank_no=3,{match},{used})"
    usable = f'AND([@word{c}.v.same]="yes",{of_motor("known")}*[@reducers.known.{c}]=1)'
    return f'IF({usable},ROUND({PARTS}*({score}),0)*{view.pairs}+[first]+{c - 1},"–")'


MASSLESS = 3  # ranks that need neither mass nor cost


def weighed(view: PairSelection, table: str, room: int, mass: Any, cost: Any) -> list[Quantity]:
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
        *weighed(view, "motors", n, m.size, m.cost),
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
        cell("fits", filled(g.fits.astype(int), n, 0)),
        cell("takes", filled(np.where(g.fits, hubs, -1.0), n, -1.0)),
        cell("balance", filled(g.balance, n), scale=largest),
        cell("unit", filled(reciprocals, n)),
        cell("mixed", filled(mixed, n), mean=MIXED.format(**own), scale=view.shaft.product),
        cell("square", filled(square, n), mean=SQUARE.format(**own), scale=view.shaft.torque**2),
        *weighed(view, "reducers", n, r.size, r.cost),
    )
