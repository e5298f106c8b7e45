"""Every pair of the catalogue on the sheet Selection: motors down, reducers across."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from engine.selection.pair_matrix import PARTS, RANKS
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.fields.units import PER_RPM, RPM, shown
from workbook.selection.catalogue import FULL_CYCLES
from workbook.selection.pair_selection import MIXED, SQUARE, PairSelection, rms_of, torque_of

LARGE = "large"  # beyond the greatest margin; so is a pair that is not in use, and its cell shows nothing
DASH = '0.0##;-0.0##;"–"'
NOTE = (
    "What a pair fails first: reducer (its torque or speed), speed, peak or RMS torque of the motor, large (beyond the "
    "greatest margin), inertia; yes: it can do it."
)


def grids(sheet: Sheet, view: PairSelection) -> None:
    """Declare what pairs fail or not, what they use of the rated torque, and their peak torques."""
    g = view.grid
    sheet.heading("Motors by reducers (S5, steps 5 to 7)", NOTE)
    grid(sheet, view, "word", "Which pairs can do it", verdict, g.verdicts, "–", align="center")
    sheet.print_columns = max(sheet.blocks[-1].columns.values())
    sheet.not_printed_below()
    grid(sheet, view, "wanted", "What is wanted of a pair", lambda c: margin_verdict("", c, "@reducers.j", "@{}"),
         g.wanted_verdicts, LARGE, align="center")  # fmt: skip
    grid(sheet, view, "share", "RMS torque of the motor over its continuous torque", share, g.uses, format=DASH,
         scale=max(1.0, float(g.uses.max())))  # fmt: skip
    grid(sheet, view, "peak", "Peak torque of the motor [Nm]", peak, g.peak, format=DASH,
         scale=max(float(g.peak.max()), 1e-3))  # fmt: skip


def grid(
    sheet: Sheet, view: PairSelection, name: str, title: str, formula: Callable[[int], str], values: NDArray[Any],
    spare: Any = 0.0, **more: Any,
) -> None:  # fmt: skip
    """Declare a table of the pairs: a row a motor, a column a reducer below its name; ``spare`` where there is none."""
    (down, across), r = view.rooms, view.reducers
    names, reductions = filled(r.names, across, ""), filled(r.reduction, across)
    whole = np.full(view.rooms, spare, dtype=object)
    whole[: values.shape[0], : values.shape[1]] = values
    sheet.row += 1
    heads = sheet.table(
        f"@{name}_heads", "Reducers: name, reduction", 2,
        constant("what", "", "", "", ["name", "reduction"]), constant("k", "", "", "", [1, 2], format="0"),
    )  # fmt: skip
    for c in range(1, across + 1):
        told = [f'=INDEX([reducers.name],{c})&""', f"=[@reducers.i.{c}]+0"]
        each = calc("v", f"reducer {c}", "", "", told, [names[c - 1], reductions[c - 1]], align="center", wrap=True)
        sheet.beside(heads, f"@{name}_head{c}", each)
    rows = sheet.table(
        f"@{name}", title, down,
        result("motor", "motor", "", "", '=INDEX([motors.name],[k])&""' if name == "word" else "=[@word.motor.same]",
               filled(view.motors.names, down, ""), align="left"),
        constant("first", "place of its first pair", "", "", list(range(0, down * across, across))) if name == "key"
        else constant("k", "number", "k", "", list(range(1, down + 1))),
    )  # fmt: skip
    for c, column in enumerate(whole.T.tolist(), 1):
        unused = f"[@motors.on.same]*[@reducers.on.{c}]=0"
        sheet.beside(rows, f"@{name}{c}", result("v", f"reducer {c}", "", "", f"={formula(c)}", column, **more),
                     unused if name == "wanted" else "")  # fmt: skip


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


def margin_verdict(table: str, n: int, inertia: str, limit: str) -> str:
    """Return the formula of the margin or inertia ratio that a motor misses in the n-th column; yes if none.

    ``limit`` is the cell of a limit, with {} for its name.
    """
    used, most = f"[@{table}share{n}.v.same]", f"{limit.format('inertia_ratio')}*{of_motor('jm')}"
    other = f'IF({used}<@little,"{LARGE}",IF([{inertia}.{n}]>{most},"inertia","yes"))'
    return f'IF({used}*{limit.format("rms_reserve")}>1,"RMS",{other})'


def first_failure(table: str, n: int, fast: str, limit: str) -> str:
    """Return the formula of what a motor fails first in the n-th column: speed, peak torque, a margin, inertia."""
    peak = f"[@{table}peak{n}.v.same]*{limit.format('peak_reserve')}"
    other = f'IF({peak}>{of_motor("peak")},"peak",[@{table}wanted{n}.v.same])'
    return f'IF([{fast}.{n}]>{of_motor("nmax")},"speed",{other})'


def verdict(c: int) -> str:
    """Return the formula of what a pair fails first: its reducer, or its motor."""
    motor = first_failure("", c, "@reducers.fast", "@{}")
    return f'IF({of_motor("on")}*[@reducers.on.{c}]=0,"–",IF([@reducers.fits.{c}]=0,"reducer",{motor}))'


def products(sheet: Sheet, view: PairSelection) -> None:
    """Declare what the catalogue says of motors and reducers, what each makes of the axis, and what pairs sort by."""
    sheet.heading("Workings: motors, reducers, and what pairs are sorted by")
    names = ",".join(f'(@rank="{one}")*{n}' for n, one in enumerate(RANKS, 1))
    sheet.rows(calc("@rank_no", "Number of the criterion", "", "", f"=MAX({names})", view.rank, format="0"))
    sheet.row += 1
    motors(sheet, view)
    reducers(sheet, view)
    keys = np.where(np.isfinite(view.keys), view.keys.astype(object), "–")
    grid(sheet, view, "key", "What pairs are sorted by: what they are ranked by, then place", lambda c: key(view, c),
         keys, "–", format="General")  # fmt: skip


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
    one = mass if RANKS[view.rank - 1] == "mass" else cost
    known = np.isfinite(one) if view.rank > MASSLESS else np.ones(len(mass))
    weight = np.nan_to_num(one) if view.rank > MASSLESS else np.zeros(len(mass))
    first, words = "0", "mass or cost"
    if table == "motors":
        first, words = "[smaller]", "smaller motors, mass or cost"
        weight = view.grid.smaller if view.rank == 1 else weight
    masses, costs = (f"INDEX([{table}.{name}],[k])" for name in ("mass", "cost"))
    return [
        calc("known", "has what it is ranked by", "", "",
             f"=[on]*CHOOSE(@rank_no,1,1,1,COUNT({masses}),COUNT({costs}))",
             filled(known.astype(int), room, 0), format="0"),
        calc("weight", words, "", "kg or price", f"=CHOOSE(@rank_no,{first},0,0,{masses}+0,{costs}+0)",
             filled(weight, room)),
    ]  # fmt: skip


def motors(sheet: Sheet, view: PairSelection) -> None:
    """Declare the motors of the catalogue, 0 in spare rows."""
    m, n = view.motors, view.rooms[0]
    given = "*".join(f"COUNT(INDEX([motors.{entry}],[k]))" for entry in ("inertia", "rated", "peak", "nmax"))

    def column(name: str, label: str, unit: str, formula: str, values: Any, **more: Any) -> Quantity:
        return calc(name, label, "", unit, f"={formula}", filled(values, n), **more)

    def or_largest(speed: str) -> str:
        return f"IF([on]=1,IF(COUNT(INDEX([motors.{speed}],[k]))=1,INDEX([motors.{speed}],[k]),[nmax]),0)"

    sheet.table(
        "@motors", "Motors of the catalogue", n,
        constant("k", "number", "k", "", list(range(1, n + 1))),
        calc("on", "in use", "", "", f"=IF({given}=1,1,0)", filled([1] * len(m.names), n, 0), format="0"),
        column("jm", "inertia", "kg m²", "IF([on]=1,INDEX([motors.inertia],[k])/10000,0)", m.inertia),
        column("rated", "rated torque", "Nm", "IF([on]=1,INDEX([motors.rated],[k])*@left,0)", m.rated_torque),
        column("peak", "peak torque", "Nm", "IF([on]=1,INDEX([motors.peak],[k]),0)", m.peak_torque),
        column("nmax", "largest speed", "rpm", "IF([on]=1,INDEX([motors.nmax],[k]),0)", shown(m.max_speed, RPM)),
        column("stall", "stall torque", "Nm", "IF([on]=1,MAX([rated],INDEX([motors.stall],[k])*@left),0)", m.stall),
        column("nn", "rated speed", "rpm", or_largest("nn"), shown(m.falls_to, RPM)),
        column("slope", "fall of the continuous torque", "Nm/rpm", "IF([on]=1,([stall]-[rated])/[nn],0)",
               (m.stall - m.rated_torque) / shown(m.falls_to, RPM), scale=1.0),
        column("knee", "peak torque up to", "rpm", or_largest("knee"), shown(m.knee, RPM)),
        column("fall", "fall beyond", "Nm/rpm",
               "IF([nmax]>[knee],MAX(0,[peak]-INDEX([motors.end],[k]))/([nmax]-[knee]),0)",
               shown(m.fall, PER_RPM)),
        calc("smaller", "smaller motors", "", "", "=IF([on]=1,SUMPRODUCT(([@motors.rated]<[rated])*[@motors.on]),0)",
             filled(view.grid.smaller, n, 0), format="0"),
        *weighed(view, "motors", n, m.size, m.cost),
    )  # fmt: skip


CYCLE_FACTOR = (
    f"IF(@cycles>IF(INDEX([reducers.full],[k])>0,INDEX([reducers.full],[k]),{FULL_CYCLES:g})*(1+1E-9),"
    "MAX(1,INDEX([reducers.fs],[k])),1)"
)  # of a reducer of the catalogue: what its largest torque counts over at the cycles of the axis


def reducers(sheet: Sheet, view: PairSelection) -> None:
    """Declare the reducers of the catalogue, 0 in spare rows, and what each makes of the axis."""
    r, g, n = view.reducers, view.grid, view.rooms[1]
    given = shown(r.max_input_speed, RPM), r.max_output_torque, r.max_mean_torque
    speeds, torques, means = (np.where(np.isfinite(one), one, 0.0) for one in given)
    own = {"eta": "[eta]", "i": "[i]", "own": "[own]"}

    def column(name: str, label: str, symbol: str, unit: str, formula: str, values: Any, **more: Any) -> Quantity:
        return calc(name, label, symbol, unit, f"={formula}", filled(values, n), **more)

    sheet.table(
        "@reducers", "Reducers of the catalogue, and what each makes of the axis", n,
        constant("k", "number", "k", "", list(range(1, n + 1))),
        calc("on", "in use", "", "", "=COUNT(INDEX([reducers.i],[k]))*COUNT(INDEX([reducers.eta],[k]))",
             filled([1] * len(r.names), n, 0), format="0"),
        column("i", "reduction", "i", "", "INDEX([reducers.i],[k])+0", r.reduction),
        column("eta", "efficiency", "η", "", "INDEX([reducers.eta],[k])+0", r.efficiency),
        column("jt", "it, and parts beside the motor", "", "kg m²",
               "IF([on]=1,INDEX([reducers.inertia],[k])/10000+@beside,0)", g.beside_motor),
        column("out", "of a torque that drives, at the motor", "", "", "IF([on]=1,1/[eta]/[i],0)",
               1.0 / (r.efficiency * r.reduction), source="1/(η i)"),
        column("back", "of one that is driven", "", "", "IF([on]=1,[eta]/[i],0)", r.efficiency / r.reduction,
               source="η/i"),
        column("own", "no-load torque", "T_nl", "Nm", "INDEX([reducers.t012],[k])+0", r.no_load),
        column("j", "inertia at the motor", "", "kg m²", "IF([on]=1,[jt]+@inertia/[i]^2,0)", g.at_motor),
        column("n", "speed of the motor", "n", "rpm", "@speed*[i]*30/PI()", shown(g.speed, RPM)),
        column("fast", "with its reserve", "", "rpm", "[n]*@speed_reserve",
               shown(g.speed * view.requirements.least_speed, RPM)),
        column("mean", "mean speed of the motor", "", "rpm", "@mean*[i]*30/PI()",
               shown(g.load.mean_speed / r.ratio, RPM)),
        column("nmax", "largest input speed", "", "rpm", "INDEX([reducers.nmax],[k])+0", speeds, source="0: no limit"),
        column("tmax", "largest torque", "", "Nm", "INDEX([reducers.tmax],[k])+0", torques),
        calc("fs", "factor on it at these cycles", "f_s", "", f"={CYCLE_FACTOR}", filled(g.cycle_factors, n, 1.0)),
        column("held", "largest torque at these cycles", "", "Nm", "[tmax]/[fs]", torques / g.cycle_factors),
        column("tmean", "largest mean torque", "", "Nm", "INDEX([reducers.t2n],[k])+0", means),
        calc("fits", "holds the axis", "", "",
             "=IF(AND([on]=1,OR([nmax]=0,[n]<=[nmax]),OR([held]=0,@tmax<=[held]),OR([tmean]=0,@smean<=[tmean])),1,0)",
             filled(g.fits.astype(int), n, 0), format="0"),
        column("balance", "inertia that balances", "", "kg m²", "IF([on]*@own>0,@trms/(@wrms*[eta]*[i]^2),0)",
               g.balance, source="S_rms / (ω̇_rms η i²)", scale=max(float(g.balance.max()), 1e-9)),
        column("unit", "its reciprocal", "", "1/(kg m²)", "IF([balance]>0,1/[balance],0)",
               np.divide(1.0, g.balance, out=np.zeros(g.balance.shape), where=g.balance > 0.0)),
        column("mixed", "mean of ω̇ S, with losses", "", "W/s", f"IF([on]=1,{MIXED.format(**own)},0)",
               view.load.mixed(view.bare), scale=view.shaft.product),
        column("square", "mean square torque of the load at the motor", "", "N²m²",
               f"IF([on]=1,{SQUARE.format(**own)},0)", view.load.square(view.bare), scale=view.shaft.torque**2),
        *weighed(view, "reducers", n, r.size, r.cost),
    )  # fmt: skip
