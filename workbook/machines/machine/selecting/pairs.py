"""Every pair of the catalogue on the sheet Selection: motors down, reducers across."""

from __future__ import annotations

from typing import Any

import numpy as np

from engine.machine.grid import PARTS, RANKS
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.entries.units import PER_RPM, RPM, shown
from workbook.machines.machine.selecting.formulas import peak_of, rms_of
from workbook.machines.machine.selecting.view import Choosing

WHOLE = '0;-0;"–"'
DASH = '0.0##;-0.0##;"–"'
NOTE = (
    "What a pair fails first: reducer (its torque or speed), speed, peak or RMS torque of the motor, large (beyond the "
    "greatest margin), inertia; yes: it can do it."
)


def grids(sheet: Sheet, view: Choosing) -> None:
    """Declare what pairs fail or not, their RMS torques and their peak torques."""
    g = view.grid
    sheet.not_printed_below()
    sheet.heading("Motors by reducers (S5, steps 5 to 7)", NOTE)
    torque = max(float(g.peak.max()), 1e-3)
    grid(sheet, view, "word", "Which pairs can do it", verdict, view.spread(g.verdicts, "–"), align="center")
    grid(sheet, view, "wanted", "What is wanted of a pair", within, wanted(view), align="center")
    grid(sheet, view, "rms", "RMS torque of the motor [Nm]", lambda c: if_on(c, rms_of(*pair(c))),
         view.spread(g.rms, 0.0), format=DASH, scale=torque)  # fmt: skip
    grid(sheet, view, "peak", "Peak torque of the motor [Nm]", lambda c: if_on(c, peak_of(*pair(c))),
         view.spread(g.peak, 0.0), format=DASH, scale=torque)  # fmt: skip


def wanted(view: Choosing) -> list[list[Any]]:
    """Return what each pair fails of what is wanted of it."""
    return view.spread(view.grid.wanted_verdicts, "–")


def grid(
    sheet: Sheet, view: Choosing, name: str, title: str, formula: Any, values: list[list[Any]], **more: Any
) -> None:
    """Declare a table of the pairs: a row a motor, a column a reducer, which has its name and reduction above."""
    (down, across), r = view.rooms, view.reducers
    names, reductions = filled(r.names, across, ""), filled(r.reduction, across)
    sheet.row += 1
    heads = sheet.table(
        f"@{name}_heads", "Reducers: name, reduction", 2,
        constant("what", "", "", "", ["name", "reduction"]), constant("k", "", "", "", [1, 2], format="0"),
    )  # fmt: skip
    for c in range(1, across + 1):
        told = [f'=[reducers.name.{c}]&""', f"=[@reducers.i.{c}]+0"]
        each = calc("v", f"reducer {c}", "", "", told, [names[c - 1], reductions[c - 1]],
                    align="center", wrap=True)  # fmt: skip
        sheet.beside(heads, f"@{name}_head{c}", each)
    rows = sheet.table(
        f"@{name}", title, down,
        result("motor", "motor", "", "", '=INDEX([motors.name],[k])&""', filled(view.motors.names, down, ""),
               align="left"),
        constant("k", "number", "k", "", list(range(1, down + 1))),
    )  # fmt: skip
    for c in range(1, across + 1):
        each = result("v", f"reducer {c}", "", "", f"={formula(c)}", values[c - 1], **more)
        sheet.beside(rows, f"@{name}{c}", each)


def pair(c: int) -> tuple[str, str, str]:
    """Return J, i and η of the motor of a row with a reducer, as formulas."""
    inertia = f"(INDEX([@motors.jm],[k])+[@reducers.jt.{c}])"
    return inertia, f"[@reducers.i.{c}]", f"[@reducers.eta.{c}]"


def if_on(c: int, formula: str) -> str:
    """Return a formula where both are in use."""
    return f"IF(INDEX([@motors.on],[k])*[@reducers.on.{c}]=0,0,{formula})"


def within(c: int) -> str:
    """Return the formula of what a pair fails of what is wanted of it, or that it is usable."""
    rms, rated = f"INDEX([@rms{c}.v],[k])", "INDEX([@motors.rated],[k])"
    large = f'IF([@reducers.j.{c}]>@inertia_ratio*INDEX([@motors.jm],[k]),"inertia","yes")'
    margins = f'IF({rms}*@least>{rated},"RMS",IF({rms}*@greatest<{rated},"large",{large}))'
    return f'IF(INDEX([@motors.on],[k])*[@reducers.on.{c}]=0,"–",{margins})'


def verdict(c: int) -> str:
    """Return the formula of what a pair fails first: reducer, speed, peak torque, or what is wanted of it."""
    peak = f'IF(INDEX([@peak{c}.v],[k])>INDEX([@motors.peak],[k]),"peak",INDEX([@wanted{c}.v],[k]))'
    speed = f'IF([@reducers.n.{c}]>INDEX([@motors.nmax],[k]),"speed",{peak})'
    return f'IF(INDEX([@motors.on],[k])*[@reducers.on.{c}]=0,"–",IF([@reducers.fits.{c}]=0,"reducer",{speed}))'


def products(sheet: Sheet, view: Choosing) -> None:
    """Declare what the catalogue says of motors and reducers, what each makes of the axis, and what pairs sort by."""
    sheet.heading("Workings: motors, reducers, and what pairs are sorted by")
    numbers = "0"
    for n, one in reversed(list(enumerate(RANKS, 1))):
        numbers = f'IF(@rank="{one}",{n},{numbers})'
    sheet.rows(calc("@rank_no", "Number of what they are ranked by", "", "", f"={numbers}", view.rank, format="0"))
    sheet.row += 1
    motors(sheet, view)
    reducers(sheet, view)
    keys = view.spread(np.where(np.isfinite(view.keys), view.keys, -1.0), -1.0)
    told = [["–" if key < 0.0 else key for key in column] for column in keys]
    grid(
        sheet,
        view,
        "key",
        "What pairs are sorted by: score, then place",
        lambda c: key(view, c),
        told,
        format="General",
    )


def key(view: Choosing, c: int) -> str:
    """Return the formula of what a pair is sorted by."""
    share = f"INDEX([@rms{c}.v],[k])/INDEX([@motors.rated],[k])"
    match = f"[@reducers.balance.{c}]/{pair(c)[0]}"
    sums = [f"INDEX([@motors.{one}],[k])+[@reducers.{one}.{c}]" for one in ("mass", "cost")]
    lone = f"EXP(ABS(LN({match}))/2)"
    score = (
        f"CHOOSE(@rank_no,INDEX([@motors.smaller],[k])+{share}/(1+{share}),{share},"
        f"IF([@reducers.balance.{c}]>0,{lone},1),{sums[0]},{sums[1]})"
    )
    known = f"IF(@rank_no<4,1,IF(@rank_no=4,INDEX([@motors.weighs],[k])*[@reducers.weighs.{c}],"
    known += f"INDEX([@motors.costs],[k])*[@reducers.costs.{c}]))=1"
    place = f"([k]-1)*{view.rooms[1]}+{c - 1}"
    return f'IF(INDEX([@word{c}.v],[k])="yes",IF({known},ROUND({score}*{PARTS},0)*{view.pairs}+{place},"–"),"–")'


def motors(sheet: Sheet, view: Choosing) -> None:
    """Declare the motors of the catalogue, 0 in spare rows."""
    m, n = view.motors, view.rooms[0]
    count = len(m.names)
    columns = (("jm", "inertia", "kg m²", "inertia", m.inertia),
               ("rated", "rated torque", "Nm", "rated", m.rated_torque),
               ("peak", "peak torque", "Nm", "peak", m.peak_torque),
               ("nmax", "largest speed", "rpm", "nmax", shown(m.max_speed, RPM)))  # fmt: skip
    made = {"jm": "/10000", "rated": "*@left"}
    known = "*".join(f"COUNT(INDEX([motors.{column}],[k]))" for _, _, _, column, _ in columns)
    sheet.table(
        "@motors", "Motors of the catalogue", n,
        constant("k", "number", "k", "", list(range(1, n + 1))),
        calc("on", "in use", "", "", f"=IF({known}=1,1,0)",
             filled(filled([], count, 1), n, 0), format="0"),
        *(calc(name, label, "", unit, f"=IF([on]=1,INDEX([motors.{column}],[k]){made.get(name, '')},0)",
               filled(values, n))
          for name, label, unit, column, values in columns),
        calc("knee", "peak torque holds to", "", "rpm",
             "=IF([on]=1,IF(COUNT(INDEX([motors.knee],[k]))=1,INDEX([motors.knee],[k]),[nmax]),0)",
             filled(shown(m.knee, RPM), n)),
        calc("fall", "fall beyond", "", "Nm/rpm",
             "=IF([nmax]>[knee],MAX(0,[peak]-INDEX([motors.end],[k]))/([nmax]-[knee]),0)",
             filled(np.maximum(0.0, -shown(m.slope, PER_RPM)), n)),
        calc("smaller", "smaller motors", "", "", "=IF([on]=1,SUMPRODUCT(([@motors.rated]<[rated])*[@motors.on]),0)",
             filled(view.grid.smaller, n, 0), format="0"),
        *weighed("motors", m.size, m.cost, n),
    )  # fmt: skip


def weighed(table: str, mass: Any, cost: Any, rows: int) -> list[Quantity]:
    """Return mass and cost of products, and whether they are given."""
    found = []
    for name, known, values in (("mass", "weighs", mass), ("cost", "costs", cost)):
        unit = "kg" if name == "mass" else ""
        found += [
            calc(known, f"{name} is given", "", "", f"=COUNT(INDEX([{table}.{name}],[k]))",
                 filled(np.isfinite(values).astype(int), rows, 0), format="0"),
            calc(name, name, "", unit, f"=INDEX([{table}.{name}],[k])+0", filled(np.nan_to_num(values), rows)),
        ]  # fmt: skip
    return found


def reducers(sheet: Sheet, view: Choosing) -> None:
    """Declare the reducers of the catalogue, 0 in spare rows, and what each makes of the axis."""
    r, g, n = view.reducers, view.grid, view.rooms[1]
    limits = [np.where(np.isfinite(one), one, 0.0) for one in (shown(r.max_input_speed, RPM), r.max_output_torque)]
    sheet.table(
        "@reducers", "Reducers of the catalogue, and what each makes of the axis", n,
        constant("k", "number", "k", "", list(range(1, n + 1))),
        calc("on", "in use", "", "", "=COUNT(INDEX([reducers.i],[k]))*COUNT(INDEX([reducers.eta],[k]))",
             filled(filled([], len(r.names), 1), n, 0), format="0"),
        calc("i", "reduction", "i", "", "=INDEX([reducers.i],[k])+0", filled(r.reduction, n)),
        calc("eta", "efficiency", "η", "", "=INDEX([reducers.eta],[k])+0", filled(r.efficiency, n)),
        calc("jt", "it, and parts beside the motor", "", "kg m²",
             "=IF([on]=1,INDEX([reducers.inertia],[k])/10000+@beside,0)", filled(g.beside_motor, n)),
        calc("j", "inertia at the motor", "", "kg m²", "=IF([on]=1,[jt]+@inertia/[i]^2,0)", filled(g.at_motor, n)),
        calc("n", "speed of the motor", "n", "rpm", "=@speed*[i]*30/PI()", filled(shown(g.speed, RPM), n)),
        calc("nmax", "largest input speed", "", "rpm", "=INDEX([reducers.nmax],[k])+0", filled(limits[0], n),
             source="0: no limit"),
        calc("tmax", "largest torque", "", "Nm", "=INDEX([reducers.tmax],[k])+0", filled(limits[1], n)),
        calc("fits", "holds the axis", "", "",
             "=IF(AND([on]=1,OR([nmax]=0,[n]<=[nmax]),OR([tmax]=0,@tmax<=[tmax])),1,0)",
             filled(g.fits.astype(int), n, 0), format="0"),
        calc("balance", "inertia that balances", "", "kg m²", "=IF([on]*@own>0,@trms/(@wrms*[eta]*[i]^2),0)",
             filled(g.balance, n), source="S_rms/(α_rms η i²)", scale=max(float(g.balance.max()), 1e-9)),
        *weighed("reducers", r.size, r.cost, n),
    )  # fmt: skip
