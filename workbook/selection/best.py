"""The list of the best pairs on the sheet Selection, how it is found, and the chart of what they use."""

from typing import Any

from workbook.book.chart import Chart, Series
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.fields.units import PER_RPM, RPM, shown
from workbook.selection.grids import DASH
from workbook.selection.pair_selection import BEST, PairSelection, rms_of, torque_of


def at(column: str, place: str) -> str:
    """Return the formula of a figure of the pair in a row of the list."""
    return f"INDEX({column},MAX(1,INDEX([@order.{place}],[place])))"


def there(formula: str, none: str = "0") -> str:
    """Return a formula in the rows of the list that have a pair."""
    return f"=IF([place]<=@count,{formula},{none})"


def best_table(sheet: Sheet, view: PairSelection) -> None:
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
        result("margin", "margin", "", "", "=IF([share]>0,1/[share],0)", of("margin"), "continuous torque / T_rms",
               format=DASH),
        result("peak", "peak torque", "T_max", "Nm", pair("peak"), of("peak"), format=DASH, scale=torque),
        result("n", "largest speed", "n_max", "rpm", there(at("[@reducers.n]", "r")), of("speed"), format='0;-0;"–"'),
        result("inertias", "inertia ratio", "", "", there(f"{at('[@reducers.j]', 'r')}/{at('[@motors.jm]', 'm')}"),
               of("inertias"), format=DASH),
        result("spare", "reserve below the curve", "", "Nm", there("INDEX([@order.spare],[place])"), of("spare"),
               "at the points", scale=torque, format="0.0##;-0.0##;0.0"),
        calc("share", "share of the continuous torque", "", "", pair("share"),
             filled([view.grid.use(*one)[1] for one in pairs], BEST)),
        calc("holds", "below its curve", "", "", there("IF([spare]>=0,1,0)"),
             filled([int(one.spare >= 0.0) for one in found], BEST, 0), "1 yes, 0 no", format="0"),
        result("reducer", "reducer", "", "", there(at("[reducers.name]", "r"), '"–"'),
               filled([view.reducers.names[r] for _, r in pairs], BEST, "–"), align="left"),
        blank="[place]>@count",
    )  # fmt: skip


def order_table(sheet: Sheet, view: PairSelection) -> None:
    """Declare which pairs the best are: the smallest keys, and the rows of the catalogue that these tell."""
    pairs, across = view.ranked[:BEST], view.rooms[1]
    sheet.row += 1
    sheet.table(
        "@order", "Which pairs the best are", BEST,
        constant("place", "place", "", "", list(range(1, BEST + 1))),
        calc("key", "sorted by", "", "", there(f"SMALL({view.whole('key')},[place])"),
             filled([float(view.keys[pair]) for pair in pairs], BEST), format="0"),
        calc("at", "pair", "", "", f"=[key]-{view.pairs}*INT(([key]+0.5)/{view.pairs})",
             filled([m * across + r for m, r in pairs], BEST, 0), "motor by motor, from 0", format="0"),
        calc("m", "row of the motor", "", "", there(f"INT(([at]+0.5)/{across})+1"),
             filled([m + 1 for m, _ in pairs], BEST, 0), format="0"),
        calc("r", "row of the reducer", "", "", there(f"[at]-{across}*([m]-1)+1"),
             filled([r + 1 for _, r in pairs], BEST, 0), format="0"),
        *figures(view),
    )  # fmt: skip


def figures(view: PairSelection) -> list[Quantity]:
    """Return the columns of a pair's figures, and of what it leaves below its motor's curve."""
    pairs, m, least = view.ranked[:BEST], view.motors, view.requirements.least_peak
    each = [view.grid.pair(*pair) for pair in pairs]
    asked = [view.grid.falling_demand(*pair) for pair in pairs]
    scale = max([*(abs(one.peak) for one in view.listed), *map(abs, asked), 1e-3])
    motors, reducers = (list(each) for each in zip(*pairs, strict=True)) if pairs else ([], [])

    def figure(name: str, label: str, symbol: str, unit: str, formula: str, values: Any, **more: Any) -> Quantity:
        return calc(name, label, symbol, unit, there(formula), filled(values, BEST), **more)

    def motor(name: str) -> str:
        return f"INDEX([@motors.{name}],MAX(1,[m]))"

    def reducer(name: str) -> str:
        return f"INDEX([@reducers.{name}],MAX(1,[r]))"

    beyond = f"(({torque_of('[j]', '[i]', '[out]', '[back]', '[own]')})^2)^0.5+[fall]*([i]*@n-[knee])"
    return [
        figure("j", "inertia with the motor", "J", "kg m²", f"{motor('jm')}+{reducer('jt')}",
               [one.inertia for one in each]),
        figure("i", "reduction", "i", "", reducer("i"), [one.ratio for one in each]),
        figure("out", "of a torque that drives", "", "", reducer("out"),
               [1.0 / (one.efficiency * one.ratio) for one in each]),
        figure("back", "of one that is driven", "", "", reducer("back"), [one.efficiency / one.ratio for one in each]),
        figure("own", "no-load torque", "T_nl", "Nm", reducer("own"), [one.no_load for one in each]),
        figure("mixed", "mean of ω̇ S, with losses", "", "W/s", reducer("mixed"), view.load.mixed(view.bare)[reducers],
               scale=view.shaft.product),
        figure("square", "mean square torque of the load at the motor", "", "N²m²", reducer("square"),
               view.load.square(view.bare)[reducers], scale=view.shaft.torque**2),
        figure("rms", "RMS torque", "T_rms", "Nm", rms_of("[j]", "[i]", "[mixed]", "[square]"),
               [one.rms for one in view.listed], scale=scale),
        figure("tp", "motor's peak torque, over its reserve", "", "Nm", f"{motor('peak')}/@peak_reserve",
               m.peak_torque[motors] / least),
        figure("knee", "holds to", "n_1", "rpm", motor("knee"), shown(m.knee[motors], RPM)),
        figure("fall", "fall beyond, over the reserve", "f", "Nm/rpm", f"{motor('fall')}/@peak_reserve",
               shown(m.fall[motors] / least, PER_RPM)),
        figure("asked", "asked of what falls", "", "Nm", f"SUMPRODUCT(MAX({beyond}))", asked, scale=scale,
               source="|T| + f (n − n_1), at most"),
        figure("spare", "reserve below the motor's curve", "", "Nm", "[tp]-MAX(INDEX([@best.peak],[place]),[asked])",
               [one.spare for one in view.listed], scale=scale),
    ]  # fmt: skip


NAMED = 6  # pairs that a chart shows


def points_of_pairs(sheet: Sheet, view: PairSelection) -> None:
    """Declare the points of the chart, of the drive's pair the last: left of its edge where there is no pair."""
    pairs = view.ranked[:NAMED]
    names = filled([f"{view.motors.names[m]} + {view.reducers.names[r]}" for m, r in pairs], NAMED, "–")
    used = filled([view.grid.use(*pair) for pair in pairs], NAMED, (-1.0, -1.0))
    numbers = range(1, NAMED + 1)
    sheet.heading("Workings: as drawn in the chart")
    sheet.rows(*(
        calc(f"@name{k}", f"Pair {k}", "", "",
             f'=IF([@order.m.{k}]>0,[@best.motor.{k}]&" + "&[@best.reducer.{k}],"–")', names[k - 1], align="left")
        for k in numbers
    ))  # fmt: skip
    points = [(k, f"Pair {k}", f"=IF([@order.m.{k}]>0,[@best.n.{k}]/INDEX([motors.nmax],MAX(1,[@order.m.{k}])),0-1)",
               f"=IF([@order.m.{k}]>0,[@best.share.{k}],0-1)", used[k - 1]) for k in numbers]  # fmt: skip
    own = (view.own.speed / view.in_use("nmax"), view.own.rms / view.in_use("rated"))
    for k, title, speed, torque, one in [*points, (0, "The drive's pair", "=@own_speed/@held_nmax",
                                                   "=@own_rms/@held_rated", own)]:  # fmt: skip
        sheet.table(f"@use{k}", title, 1, calc("speed", "speed", "", "", speed, [one[0]]),
                    calc("torque", "RMS torque", "", "", torque, [one[1]]))  # fmt: skip


def chart(sheet: Sheet) -> None:
    """Place the chart, whose series are named by their pairs."""
    series = [Series(f"=@name{k}", f"[@use{k}.speed]", f"[@use{k}.torque]", points=True, marker="circle")
              for k in range(1, NAMED + 1)]  # fmt: skip
    series.append(
        Series("the drive's pair", "[@use0.speed]", "[@use0.torque]", points=True, marker="diamond", color="374151")
    )
    sheet.chart(
        Chart("What the best pairs use of their motors", "largest speed / motor's largest speed",
              "RMS torque / continuous torque", tuple(series),
              "RMS torque over continuous torque against speed over largest speed, of the best pairs and the drive's",
              (0, None, None), (0, None, None)),
        column=11, row=5, width=6, height=24,
    )  # fmt: skip
