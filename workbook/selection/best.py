"""The list of the best pairs on the sheet Selection, how it is found, and the chart of what they use."""

from typing import Any

import numpy as np

from engine.selection.pair_matrix import Used, falling
from workbook.book.chart import Chart, Series
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.entries.units import PER_RPM, RPM, shown
from workbook.selection.choosing import BEST, Choosing
from workbook.selection.shaft import rms_of, through, torque_of

DASH = '0.0##;-0.0##;"–"'


def at(column: str, place: str) -> str:
    """Return the formula of a figure of the pair in a row of the list."""
    return f"INDEX({column},MAX(1,INDEX([@order.{place}],[place])))"


def there(formula: str, none: str = "0") -> str:
    """Return a formula in the rows of the list that have a pair."""
    return f"=IF([place]<=@count,{formula},{none})"


def best_table(sheet: Sheet, view: Choosing) -> None:
    """Declare the list of the best pairs."""
    pairs, found = view.ranked[:BEST], view.listed
    torque = max([view.own.peak, *(one.peak for one in found), 1e-3])

    def of(figure: str) -> list[float]:
        return filled([getattr(one, figure) for one in found], BEST)

    def pair(table: str) -> str:
        row, column = (f"MAX(1,INDEX([@order.{one}],[place]))" for one in "mr")
        return there(f"INDEX({view.whole(table)},{row},{column})")

    sheet.row += 1
    sheet.table(
        "@best", f"The best {BEST} pairs (S5, steps 6 and 7)", BEST,
        result("motor", "motor", "", "", there(at("[motors.name]", "m"), '"–"'),
               filled([view.motors.names[m] for m, _ in pairs], BEST, "–"), align="left"),
        constant("place", "place", "", "", list(range(1, BEST + 1))),
        result("i", "reduction", "i", "", there(at("[@reducers.i]", "r")),
               filled([float(view.reducers.reduction[r]) for _, r in pairs], BEST), format=DASH),
        result("rms", "RMS torque", "T_rms", "Nm", there("INDEX([@order.rms],[place])"), of("rms"), format=DASH,
               scale=torque),
        result("margin", "margin", "", "", "=IF([share]>0,1/[share],0)", of("margin"),
               source="continuous torque / T_rms", format=DASH),
        result("peak", "peak torque", "T_max", "Nm", pair("peak"), of("peak"), format=DASH, scale=torque),
        result("n", "largest speed", "n_max", "rpm", there(at("[@reducers.n]", "r")), of("speed"), format='0;-0;"–"'),
        result("inertias", "inertia ratio", "", "", there(f"{at('[@reducers.j]', 'r')}/{at('[@motors.jm]', 'm')}"),
               of("inertias"), format=DASH),
        result("spare", "reserve below the curve", "", "Nm", there("INDEX([@order.spare],[place])"),
               of("spare"), scale=torque, source="at the points", format="0.0##;-0.0##;0.0"),
        calc("share", "share of the continuous torque", "", "", pair("share"),
             filled([view.grid.use(*one).torque for one in pairs], BEST)),
        calc("holds", "below its curve", "", "", there("IF([spare]>=0,1,0)"),
             filled([int(one.spare >= 0.0) for one in found], BEST, 0), format="0", source="1 yes, 0 no"),
        result("reducer", "reducer", "", "", there(at("[reducers.name]", "r"), '"–"'),
               filled([view.reducers.names[r] for _, r in pairs], BEST, "–"), align="left"),
        blank="[place]>@count",
    )  # fmt: skip


def order_table(sheet: Sheet, view: Choosing) -> None:
    """Declare which pairs the best are: the smallest keys, and the rows of the catalogue that these tell."""
    pairs = view.ranked[:BEST]
    rows, across = view.pairs, view.rooms[1]
    sheet.row += 1
    sheet.table(
        "@order", "Which pairs the best are", BEST,
        constant("place", "place", "", "", list(range(1, BEST + 1))),
        calc("key", "sorted by", "", "", there(f"SMALL({view.whole('key')},[place])"),
             filled([float(view.keys[pair]) for pair in pairs], BEST), format="0"),
        calc("at", "pair", "", "", f"=[key]-{rows}*INT(([key]+0.5)/{rows})",
             filled([view.place(pair) for pair in pairs], BEST, 0), format="0", source="motor by motor, from 0"),
        calc("m", "row of the motor", "", "", there(f"INT(([at]+0.5)/{across})+1"),
             filled([m + 1 for m, _ in pairs], BEST, 0), format="0"),
        calc("r", "row of the reducer", "", "", there(f"[at]-{across}*([m]-1)+1"),
             filled([r + 1 for _, r in pairs], BEST, 0), format="0"),
        *figures(view),
    )  # fmt: skip


OF_REDUCER = (
    ("i", "reduction", "i", ""),
    ("out", "of a torque that drives", "", ""),
    ("back", "of one that is driven", "", ""),
    ("own", "no-load torque", "T_nl", "Nm"),
)
"""columns of the workings: name, words, symbol, unit"""


def figures(view: Choosing) -> list[Quantity]:
    """Return the columns of a pair's figures, and of what it leaves below its motor's curve."""
    pairs, m, g = view.ranked[:BEST], view.motors, view.grid
    each = [g.pair(*pair) for pair in pairs]
    own = zip(*((one.ratio, *through(one.ratio, one.efficiency), one.no_load) for one in each), strict=True)
    fall = np.maximum(0.0, -shown(m.slope, PER_RPM))

    def of(values: Any) -> list[float]:
        return filled(values, BEST)

    def motor(name: str) -> str:
        return there(f"INDEX([@motors.{name}],MAX(1,[m]))")

    beyond = f"(({torque_of('[j]', '[i]', '[out]', '[back]', '[own]')})^2)^0.5+[fall]*([i]*@n-[knee])"
    asked = [falling(view.load, one, view.curve(m)) for one, (m, _) in zip(each, pairs, strict=True)]
    scale = max([*(abs(one.peak) for one in view.listed), *map(abs, asked), 1e-3])
    return [
        calc("j", "inertia with the motor", "J", "kg m²",
             there("INDEX([@motors.jm],MAX(1,[m]))+INDEX([@reducers.jt],MAX(1,[r]))"),
             of([one.inertia for one in each])),
        *(calc(name, label, symbol, unit, there(f"INDEX([@reducers.{name}],MAX(1,[r]))"), of(values))
          for (name, label, symbol, unit), values in zip(OF_REDUCER, list(own) or [()] * 4, strict=True)),
        calc("mixed", "mean of ω̇ S, with losses", "", "W/s", there("INDEX([@reducers.mixed],MAX(1,[r]))"),
             of([float(view.mixed[k]) for _, k in pairs]), scale=view.shaft.product),
        calc("square", "mean square torque of the load at the motor", "", "N²m²",
             there("INDEX([@reducers.square],MAX(1,[r]))"), of([float(view.square[k]) for _, k in pairs]),
             scale=view.shaft.torque**2),
        calc("rms", "RMS torque", "T_rms", "Nm", there(rms_of("[j]", "[i]", "[mixed]", "[square]")),
             of([one.rms for one in view.listed]), scale=scale),
        calc("tp", "motor's peak torque", "", "Nm", motor("peak"), of([float(m.peak_torque[k]) for k, _ in pairs])),
        calc("knee", "holds to", "n_1", "rpm", motor("knee"), of([shown(float(m.knee[k]), RPM) for k, _ in pairs])),
        calc("fall", "fall beyond", "f", "Nm/rpm", motor("fall"), of([float(fall[k]) for k, _ in pairs])),
        calc("asked", "asked of what falls", "", "Nm", there(f"SUMPRODUCT(MAX({beyond}))"), of(asked), scale=scale,
             source="|T| + f (n − n_1), at most"),
        calc("spare", "reserve below the motor's curve", "", "Nm",
             there("[tp]-MAX(INDEX([@best.peak],[place]),[asked])"), of([one.spare for one in view.listed]),
             scale=scale),
    ]  # fmt: skip


NAMED = 6
"""pairs that a chart shows"""


def uses(sheet: Sheet, view: Choosing) -> None:
    """Declare the points of the chart: left of its edge where there is no pair."""
    names = view.named(NAMED)
    sheet.heading("Workings: as drawn in the chart")
    sheet.rows(*(
        calc(f"@name{k}", f"Pair {k}", "", "",
             f'=IF([@order.m.{k}]>0,[@best.motor.{k}]&" + "&[@best.reducer.{k}],"–")', names[k - 1], align="left")
        for k in range(1, NAMED + 1)
    ))  # fmt: skip
    for k in range(1, NAMED + 1):
        row, there = f"INDEX([motors.nmax],MAX(1,[@order.m.{k}]))", f"[@order.m.{k}]>0"
        point(sheet, k, f"=IF({there},[@best.n.{k}]/{row},0-1)",
              f"=IF({there},[@best.share.{k}],0-1)", view.used(k - 1))  # fmt: skip
    point(sheet, 0, "=@own_speed/@held_nmax", "=@own_rms/@held_rated",
          Used(view.own.speed / view.held("nmax"), view.own.rms / view.held("rated")))  # fmt: skip


def point(sheet: Sheet, k: int, speed: str, torque: str, used: Used) -> None:
    """Declare a point."""
    sheet.table(
        f"@use{k}", f"Pair {k}" if k else "The drive's pair", 1,
        calc("speed", "speed", "", "", speed, [used.speed]),
        calc("torque", "RMS torque", "", "", torque, [used.torque]),
    )  # fmt: skip


def chart(sheet: Sheet) -> None:
    """Place the chart, whose series are named by their pairs."""
    shown = [Series(f"=@name{k}", f"[@use{k}.speed]", f"[@use{k}.torque]", points=True, marker="circle")
             for k in range(1, NAMED + 1)]  # fmt: skip
    series = (*shown, Series("the drive's pair", "[@use0.speed]", "[@use0.torque]", points=True, marker="diamond",
                             color="374151"))  # fmt: skip
    sheet.chart(
        Chart("What the best pairs use of their motors", "largest speed / motor's largest speed",
              "RMS torque / continuous torque", series,
              "RMS torque over continuous torque against speed over largest speed, of the best pairs and the drive's",
              (0, None, None), (0, None, None)),
        column=11, row=5, width=6, height=24,
    )  # fmt: skip
