"""Every pair of the catalogue on the sheet Selection: motors down, reducers across."""

from typing import Any

import numpy as np

from engine.drive.limits import factor_at
from engine.selection.pair_matrix import PARTS, RANKS
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.entries.units import PER_RPM, RPM, shown
from workbook.selection.catalogue import FULL_CYCLES
from workbook.selection.choosing import Choosing
from workbook.selection.shaft import MIXED, SQUARE, peak_of, rms_of, through

LARGE = "large"
"""beyond the greatest margin; so is a pair that is not in use, and its cell shows nothing"""
DASH = '0.0##;-0.0##;"–"'
NOTE = (
    "What a pair fails first: reducer (its torque or speed), speed, peak or RMS torque of the motor, large (beyond the "
    "greatest margin), inertia; yes: it can do it."
)


def grids(sheet: Sheet, view: Choosing) -> None:
    """Declare what pairs fail or not, what they use of the rated torque, and their peak torques."""
    g = view.grid
    sheet.heading("Motors by reducers (S5, steps 5 to 7)", NOTE)
    torque = max(float(g.peak.max()), 1e-3)
    grid(sheet, view, "word", "Which pairs can do it", verdict, view.spread(g.verdicts, "–"), align="center")
    sheet.print_columns = max(sheet.blocks[-1].columns.values())
    sheet.not_printed_below()
    grid(sheet, view, "wanted", "What is wanted of a pair", within, view.spread(g.wanted_verdicts, LARGE),
         align="center")  # fmt: skip
    grid(sheet, view, "share", "RMS torque of the motor over its continuous torque", share,
         view.spread(g.uses, 0.0), format=DASH, scale=max(1.0, float(g.uses.max())))  # fmt: skip
    grid(sheet, view, "peak", "Peak torque of the motor [Nm]", lambda c: if_on(c, peak_of(*pair(c))),
         view.spread(g.peak, 0.0), format=DASH, scale=torque)  # fmt: skip


def grid(
    sheet: Sheet, view: Choosing, name: str, title: str, formula: Any, values: list[list[Any]], **more: Any
) -> None:
    """Declare a table of the pairs: a row a motor, a column a reducer, which has its name and reduction above."""
    (down, across), r = view.rooms, view.reducers
    names, reductions = filled(r.names, across, ""), filled(r.reduction, across)
    motor = '=INDEX([motors.name],[k])&""' if name == "word" else "=[@word.motor.same]"
    sheet.row += 1
    heads = sheet.table(
        f"@{name}_heads", "Reducers: name, reduction", 2,
        constant("what", "", "", "", ["name", "reduction"]), constant("k", "", "", "", [1, 2], format="0"),
    )  # fmt: skip
    for c in range(1, across + 1):
        told = [f'=INDEX([reducers.name],{c})&""', f"=[@reducers.i.{c}]+0"]
        each = calc("v", f"reducer {c}", "", "", told, [names[c - 1], reductions[c - 1]],
                    align="center", wrap=True)  # fmt: skip
        sheet.beside(heads, f"@{name}_head{c}", each)
    number = constant("k", "number", "k", "", list(range(1, down + 1)))
    if name == "key":
        number = constant("first", "place of its first pair", "", "", list(range(0, down * across, across)))
    rows = sheet.table(
        f"@{name}", title, down,
        result("motor", "motor", "", "", motor, filled(view.motors.names, down, ""), align="left"), number,
    )  # fmt: skip
    for c in range(1, across + 1):
        each = result("v", f"reducer {c}", "", "", f"={formula(c)}", values[c - 1], **more)
        unused = f"[@motors.on.same]*[@reducers.on.{c}]=0"
        sheet.beside(rows, f"@{name}{c}", each, unused if name == "wanted" else "")


def share(c: int) -> str:
    """Return the formula of the RMS torque of the motor of a row with a reducer, over its continuous torque."""
    inertia, ratio, *_ = pair(c)
    rms = rms_of(inertia, ratio, f"[@reducers.mixed.{c}]", f"[@reducers.square.{c}]")
    return if_on(c, f"{rms}/MAX({of('rated')},{of('stall')}-{of('slope')}*[@reducers.mean.{c}])")


def of(figure: str) -> str:
    """Return a figure of the motor of a row."""
    return f"[@motors.{figure}.same]"


def pair(c: int) -> list[str]:
    """Return J, i, 1/(η i), η/i and no-load torque of the motor of a row with a reducer, as formulas."""
    return [f"({of('jm')}+[@reducers.jt.{c}])", *(f"[@reducers.{name}.{c}]" for name in ("i", "out", "back", "own"))]


def if_on(c: int, formula: str) -> str:
    """Return a formula where both are in use."""
    return f"IF({of('on')}*[@reducers.on.{c}],{formula},0)"


def within(c: int) -> str:
    """Return the formula of what a pair fails of what is wanted of it, or that it is usable."""
    used = f"[@share{c}.v.same]"
    inertia = f'IF([@reducers.j.{c}]>{of("jmax")},"inertia","yes")'
    return f'IF({used}>@most,"RMS",IF({used}<@little,"{LARGE}",{inertia}))'


def verdict(c: int) -> str:
    """Return the formula of what a pair fails first: reducer, speed, peak torque, or what is wanted of it."""
    weak = f'IF([@peak{c}.v.same]>{of("top")},"peak",[@wanted{c}.v.same])'
    motor = f'IF([@reducers.fast.{c}]>{of("nmax")},"speed",{weak})'
    return f'IF({of("on")}*[@reducers.on.{c}]=0,"–",IF([@reducers.fits.{c}]=0,"reducer",{motor}))'


def products(sheet: Sheet, view: Choosing) -> None:
    """Declare what the catalogue says of motors and reducers, what each makes of the axis, and what pairs sort by."""
    sheet.heading("Workings: motors, reducers, and what pairs are sorted by")
    names = ",".join(f'(@rank="{one}")*{n}' for n, one in enumerate(RANKS, 1))
    sheet.rows(calc("@rank_no", "Number of the criterion", "", "", f"=MAX({names})", view.rank, format="0"))
    sheet.row += 1
    motors(sheet, view)
    reducers(sheet, view)
    keys = view.spread(np.where(np.isfinite(view.keys), view.keys, -1.0), -1.0)
    told = [["–" if key < 0.0 else key for key in column] for column in keys]
    grid(sheet, view, "key", "What pairs are sorted by: what they are ranked by, then place",
         lambda c: key(view, c), told, format="General")  # fmt: skip


def score(c: int) -> str:
    """Return the formula of what a pair is ranked by, the lowest first."""
    balance, inertia = f"[@reducers.balance.{c}]", f"({of('jm')}+[@reducers.jt.{c}])"
    match = f"MAX({balance}/{inertia},{inertia}*[@reducers.unit.{c}])^0.5"
    used = f"(@rank_no<3)*(1-1/(1+[@share{c}.v.same]))"
    return f"{of('weight')}+[@reducers.weight.{c}]+IF(@rank_no=3,{match},{used})"


def key(view: Choosing, c: int) -> str:
    """Return the formula of what a pair is sorted by."""
    place = f"[first]+{c - 1}"
    usable = f'AND([@word{c}.v.same]="yes",{of("known")}*[@reducers.known.{c}]=1)'
    return f'IF({usable},ROUND({PARTS}*({score(c)}),0)*{view.pairs}+{place},"–")'


MOTOR_COLUMNS = (
    ("jm", "inertia", "kg m²", "inertia"),
    ("rated", "rated torque", "Nm", "rated"),
    ("peak", "peak torque", "Nm", "peak"),
    ("nmax", "largest speed", "rpm", "nmax"),
)
"""figures of every motor: column here, words, unit, column of the catalogue"""


MASSLESS = 3
"""ranks that need neither mass nor cost"""


def weights(view: Choosing, mass: Any, cost: Any) -> tuple[Any, Any]:
    """Return whether products have the figure that pairs are ranked by, and that figure: 0 where there is none."""
    if view.rank <= MASSLESS:
        return np.ones(len(mass), dtype=int), np.zeros(len(mass))
    one = mass if RANKS[view.rank - 1] == "mass" else cost
    return np.isfinite(one).astype(int), np.nan_to_num(one)


def motors(sheet: Sheet, view: Choosing) -> None:
    """Declare the motors of the catalogue, 0 in spare rows."""
    m, n = view.motors, view.rooms[0]
    figures = m.inertia, m.rated_torque, m.peak_torque, shown(m.max_speed, RPM)
    known, weight = weights(view, m.size, m.cost)
    weight = view.grid.smaller if view.rank == 1 else weight
    least = view.given.least_peak_margin
    made = {"jm": "/10000", "rated": "*@left"}
    given = "*".join(f"COUNT(INDEX([motors.{column}],[k]))" for *_, column in MOTOR_COLUMNS)
    sheet.table(
        "@motors", "Motors of the catalogue", n,
        constant("k", "number", "k", "", list(range(1, n + 1))),
        calc("on", "in use", "", "", f"=IF({given}=1,1,0)",
             filled(filled([], len(m.names), 1), n, 0), format="0"),
        *(calc(name, label, "", unit, f"=IF([on]=1,INDEX([motors.{column}],[k]){made.get(name, '')},0)",
               filled(one, n))
          for (name, label, unit, column), one in zip(MOTOR_COLUMNS, figures, strict=True)),
        calc("stall", "stall torque", "", "Nm", "=IF([on]=1,MAX([rated],INDEX([motors.stall],[k])*@left),0)",
             filled(m.stall, n)),
        calc("nn", "rated speed", "", "rpm",
             "=IF([on]=1,IF(COUNT(INDEX([motors.nn],[k]))=1,INDEX([motors.nn],[k]),[nmax]),0)",
             filled(shown(m.falls_to, RPM), n)),
        calc("slope", "fall of the continuous torque", "", "Nm/rpm", "=IF([on]=1,([stall]-[rated])/[nn],0)",
             filled((m.stall - m.rated_torque) / shown(m.falls_to, RPM), n), scale=1.0),
        calc("knee", "peak torque up to", "", "rpm",
             "=IF([on]=1,IF(COUNT(INDEX([motors.knee],[k]))=1,INDEX([motors.knee],[k]),[nmax]),0)",
             filled(shown(m.knee, RPM), n)),
        calc("fall", "fall beyond", "", "Nm/rpm",
             "=IF([nmax]>[knee],MAX(0,[peak]-INDEX([motors.end],[k]))/([nmax]-[knee]),0)",
             filled(np.maximum(0.0, -shown(m.slope, PER_RPM)), n)),
        calc("jmax", "largest inertia at the motor", "", "kg m²", "=@inertia_ratio*[jm]",
             filled(m.inertia * view.given.inertia_ratio, n)),
        calc("top", "largest torque of the cycle, with its margin", "", "Nm", "=[peak]/@least_peak",
             filled(m.peak_torque / least, n)),
        calc("smaller", "smaller motors", "", "", "=IF([on]=1,SUMPRODUCT(([@motors.rated]<[rated])*[@motors.on]),0)",
             filled(view.grid.smaller, n, 0), format="0"),
        *weighed("motors", filled(known, n, 0), filled(weight, n), "[smaller]"),
    )  # fmt: skip


def weighed(table: str, known: list[Any], weight: list[Any], first: str = "0") -> list[Quantity]:
    """Return the columns of mass or cost of products, as pairs are ranked by it, and of whether that is given.

    ``first`` is the formula of what counts in place of these where pairs are ranked by the smallest motor.
    """
    mass, cost = (f"INDEX([{table}.{name}],[k])" for name in ("mass", "cost"))
    return [
        calc("known", "has what it is ranked by", "", "", f"=[on]*CHOOSE(@rank_no,1,1,1,COUNT({mass}),COUNT({cost}))",
             known, format="0"),
        calc("weight", f"{'' if first == '0' else 'smaller motors, '}mass or cost", "", "kg or price",
             f"=CHOOSE(@rank_no,{first},0,0,{mass}+0,{cost}+0)", weight),
    ]  # fmt: skip


CYCLE_FACTOR = (
    f"IF(@cycles>IF(INDEX([reducers.full],[k])>0,INDEX([reducers.full],[k]),{FULL_CYCLES:g})*(1+1E-9),"
    "MAX(1,INDEX([reducers.fs],[k])),1)"
)
"""of a reducer of the catalogue: what its largest torque counts over at the cycles of the axis"""


def reducers(sheet: Sheet, view: Choosing) -> None:
    """Declare the reducers of the catalogue, 0 in spare rows, and what each makes of the axis."""
    r, g, n = view.reducers, view.grid, view.rooms[1]
    known, weight = weights(view, r.size, r.cost)
    out, back = through(r.reduction, r.efficiency)
    given = shown(r.max_input_speed, RPM), r.max_output_torque, r.max_mean_torque
    limits = [np.where(np.isfinite(one), one, 0.0) for one in given]
    factors = factor_at(g.rate, r.full_rate, r.cycle_factor)
    sheet.table(
        "@reducers", "Reducers of the catalogue, and what each makes of the axis", n,
        constant("k", "number", "k", "", list(range(1, n + 1))),
        calc("on", "in use", "", "", "=COUNT(INDEX([reducers.i],[k]))*COUNT(INDEX([reducers.eta],[k]))",
             filled(filled([], len(r.names), 1), n, 0), format="0"),
        calc("i", "reduction", "i", "", "=INDEX([reducers.i],[k])+0", filled(r.reduction, n)),
        calc("eta", "efficiency", "η", "", "=INDEX([reducers.eta],[k])+0", filled(r.efficiency, n)),
        calc("jt", "it, and parts beside the motor", "", "kg m²",
             "=IF([on]=1,INDEX([reducers.inertia],[k])/10000+@beside,0)", filled(g.beside_motor, n)),
        calc("out", "of a torque that drives, at the motor", "", "", "=IF([on]=1,1/[eta]/[i],0)", filled(out, n),
             source="1/(η i)"),
        calc("back", "of one that is driven", "", "", "=IF([on]=1,[eta]/[i],0)", filled(back, n), source="η/i"),
        calc("own", "no-load torque", "T_nl", "Nm", "=INDEX([reducers.t012],[k])+0", filled(r.no_load, n)),
        calc("j", "inertia at the motor", "", "kg m²", "=IF([on]=1,[jt]+@inertia/[i]^2,0)", filled(g.at_motor, n)),
        calc("n", "speed of the motor", "n", "rpm", "=@speed*[i]*30/PI()", filled(shown(g.speed, RPM), n)),
        calc("fast", "with its margin", "", "rpm", "=[n]*@least_speed",
             filled(shown(g.speed * view.given.least_speed_margin, RPM), n)),
        calc("mean", "mean speed of the motor", "", "rpm", "=@mean*[i]*30/PI()",
             filled(shown(g.load.mean_speed / r.ratio, RPM), n)),
        calc("nmax", "largest input speed", "", "rpm", "=INDEX([reducers.nmax],[k])+0", filled(limits[0], n),
             source="0: no limit"),
        calc("tmax", "largest torque", "", "Nm", "=INDEX([reducers.tmax],[k])+0", filled(limits[1], n)),
        calc("fs", "factor on it at these cycles", "f_s", "", f"={CYCLE_FACTOR}",
             filled(factors, n, 1.0)),
        calc("held", "largest torque at these cycles", "", "Nm", "=[tmax]/[fs]", filled(limits[1] / factors, n)),
        calc("tmean", "largest mean torque", "", "Nm", "=INDEX([reducers.t2n],[k])+0", filled(limits[2], n)),
        calc("fits", "holds the axis", "", "",
             "=IF(AND([on]=1,OR([nmax]=0,[n]<=[nmax]),OR([held]=0,@tmax<=[held]),OR([tmean]=0,@smean<=[tmean])),1,0)",
             filled(g.fits.astype(int), n, 0), format="0"),
        calc("balance", "inertia that balances", "", "kg m²", "=IF([on]*@own>0,@trms/(@wrms*[eta]*[i]^2),0)",
             filled(g.balance, n), source="S_rms / (ω̇_rms η i²)", scale=max(float(g.balance.max()), 1e-9)),
        calc("unit", "its reciprocal", "", "1/(kg m²)", "=IF([balance]>0,1/[balance],0)",
             filled(np.divide(1.0, g.balance, out=np.zeros(g.balance.shape), where=g.balance > 0.0), n)),
        calc("mixed", "mean of ω̇ S, with losses", "", "W/s",
             f"=IF([on]=1,{MIXED.format(eta='[eta]', i='[i]', own='[own]')},0)", filled(view.mixed, n),
             scale=view.shaft.product),
        calc("square", "mean square torque of the load at the motor", "", "N²m²",
             f"=IF([on]=1,{SQUARE.format(eta='[eta]', i='[i]', own='[own]')},0)", filled(view.square, n),
             scale=view.shaft.torque**2),
        *weighed("reducers", filled(known, n, 0), filled(weight, n)),
    )  # fmt: skip
