"""The highest rate of a drive that is worked out place by place, in cells: trials at the nodes of its sections.

x is the square of a rate over the present one: inertia asks x times, viscous friction √x times what it does now.
"""

from __future__ import annotations

from typing import NamedTuple

from engine.machine.pace import NEARER
from engine.machine.place_pace import FINE, PARTS, TRIALS, WITHIN, Asked, PlacePace
from engine.machine.places import NODES
from workbook.book.declare import Quantity, Sheet, calc
from workbook.book.rows import total
from workbook.machines.machine.curved import lowest_rows
from workbook.machines.machine.linked.found import ranges
from workbook.machines.machine.linked.worked import LINE, PlacedWork
from workbook.machines.machine.pacing import first, limits_found, searched, steps, telling

LAST = TRIALS + 1
"""row of the last trial: the first is the present rate"""
SWITCH = LAST - FINE
"""trials before the first whose peaks are looked for between nodes, too"""
BELOW = f"{WITHIN:.0E}".replace("E-0", "E-")
NEAR = "from the sections' nodes, to 0.01 % below where a limit binds"
ABOUT = (
    "x is the square of a rate over the present one: at it inertia asks x times, viscous friction √x times as much as "
    "now. Each trial is where parabolas through the last ones meet a limit; the last two find peaks between nodes, too."
)
LOSSES = {"p": ("+", "+", "mean"), "q": ("-", "−", "half the difference")}
TELLS = ["=0" if n == SWITCH else told for n, told in enumerate(telling(rows=LAST))]
"""the first trial that looks between nodes tells no bend"""
HALF = "[on]*([ue]-[ub])/2*SUMPRODUCT([@rule.w],"
MARKS = {
    "T": ("motor", "torque"), "S": ("geared", "torque behind the reducer"),
    LINE: ("line", "line of the motor's curve"),
}  # fmt: skip


class Texts(NamedTuple):
    """The formulas of |T| and |S| at the nodes of a section, or at one of them, and of the line of a falling curve."""

    motor: str
    geared: str
    line: str


def texts(view: PlacedWork, x: str, node: str = "") -> list[Texts]:
    """Return the formulas of each section at an x, of all its nodes or of the one with a number."""

    def at(column: str) -> list[str]:
        return [f"INDEX({one},{node})" if node else one for one in ranges(view, column)]

    ratios = at("g") if view.varies else ["@i2" for _ in view.worked]
    viscous = view.driven.entered.load.viscous is not None
    found = []
    for a, v, g, turning, rate in zip(at("a"), at("v"), ratios, at("turn"), at("w"), strict=True):
        force = f"({x}*@m*{a}{f'+SQRT({x})*@viscous*{v}' if viscous else ''}+[res])"
        behind = f"[act]*((@p2*{force}+@q2*[dir]*({force}^2)^0.5)/{g}+{x}*@j1*{turning})"
        torque = f"(@p1*{behind}+@q1*[dir]*(({behind})^2)^0.5)/@i1+[act]*{x}*@j0*@i1*{turning}"
        size = f"(({torque})^2)^0.5"
        found.append(Texts(size, f"(({behind})^2)^0.5", f"({size}+@sink*SQRT({x})*({rate}^2)^0.5)"))
    return found


def pace_columns(view: PlacedWork) -> list[Quantity]:
    """Return the columns of the sections: what each asks for next to no rate, and at every trial."""
    pace, force = view.pacing, view.driven.sizes.force
    level, going, acts = (column[:, 0].tolist() for column in pace.loads[-4:-1])
    return [
        calc("dir", "direction", "", "", "=INDEX([@st.dir],[st])", going, format="0"),
        calc("res", "what resists", "R", view.force, "=INDEX([@st.r],[st])", level, scale=force),
        calc("act", "the motor acts", "", "", "=INDEX([@st.acts],[st])", acts, format="0"),
        *asking(view, pace.asked(0.0), "no rate", 0, "0"),
        *(q for n, (asked, _) in enumerate(pace.tried[1:], 1)
          for q in asking(view, asked, f"trial {n}", n, f"[@pace.x.{n + 1}]")),
    ]  # fmt: skip


def asking(view: PlacedWork, asked: Asked, words: str, n: int, x: str) -> list[Quantity]:
    """Return the columns of what a trial asks for; a section at rest asks for what it does at the present rate."""
    each, (square, _, cube, _) = texts(view, x), view.driven.scales
    ways = ranges(view, "w")
    squares = [f"=IF([dir]=0,[square],{HALF}{one.motor}^2))" for one in each]
    cubes = [f"={HALF}{one.geared}^3*({w}^2)^0.5)" for one, w in zip(each, ways, strict=True)]
    return [
        calc(f"sq_{n}", f"{words}: ∫T²", "", "", squares, asked.squares.tolist(), scale=square),
        calc(f"cu_{n}", f"{words}: ∫|S|³ |φ̇|", "", "", cubes, asked.cubes.tolist(), scale=cube),
        *(q for mark in marks(view) for q in peak(view, asked, mark, words, n, x, each)),
    ]  # fmt: skip


def marks(view: PlacedWork) -> list[str]:
    """Return the marks of what peaks are looked for of at trials."""
    return [mark for mark in MARKS if mark != LINE or view.knows_falling]


def peak(
    view: PlacedWork, asked: Asked, mark: str, words: str, n: int, x: str, each: list[Texts]
) -> list[Quantity]:  # fmt: skip
    """Return the columns of the largest torque of a shaft at a trial: at a node, or of the parabola around it."""
    figure, named = MARKS[mark]
    found, end = getattr(asked, figure), f"{mark}_{n}"
    rest = {"T": "MAX([topT],[topD])", "S": "[topS]", LINE: f"[top{LINE}]"}[mark]
    middle = f"MAX(2,MIN({len(NODES) - 1},[k{end}]))"

    def of(name: str) -> list[float]:
        return [getattr(one, name) for one in found]

    def beside(where: str) -> list[str]:
        return [f"=IF([dir]=0,[m{end}],{getattr(one, figure)})" for one in texts(view, x, f"{middle}{where}")]

    most = calc(
        f"m{end}", f"{words}: largest {named}", "", "Nm",
        [f"=IF([dir]=0,{rest},SUMPRODUCT(MAX({getattr(one, figure)})))" for one in each], of("most"),
    )  # fmt: skip
    if not asked.fine:
        return [most]
    a, b, c = (f"INDEX([@rule.x],{middle}{where})" for where in ("-1", "", "+1"))
    fa, fb, fc = (f"[{name}{end}]" for name in "abc")
    firsts = [
        f"=IF([dir]=0,1,{len(NODES)}-INT(LN(SUMPRODUCT(({getattr(one, figure)}>=[m{end}]*(1-{PARTS!r}))*[@rule.first]))"
        "/LN(2)+check_zero))"
        for one in each
    ]
    bend = f"({b}-{a})*({fb}-{fc})-({b}-{c})*({fb}-{fa})"
    vertex = f"(({b}-{a})^2*({fb}-{fc})-({b}-{c})^2*({fb}-{fa}))/(2*[bd{end}])"
    shift = f"IF([bd{end}]<={PARTS!r}*[m{end}],0,MAX({b}-{c},MIN({b}-{a},{vertex})))"
    rise = f"[bd{end}]*[sh{end}]^2/(({b}-{a})*({c}-{b})*({c}-{a}))"
    within = f"AND([bd{end}]>{PARTS!r}*[m{end}],[sh{end}]>{b}-{c},[sh{end}]<{b}-{a})"
    return [
        most,
        calc(f"k{end}", "at node", "", "", firsts, of("node"), format="0"),
        calc(f"a{end}", "before it", "", "", beside("-1"), of("before")),
        calc(f"b{end}", "there", "", "", beside(""), of("at")),
        calc(f"c{end}", "behind it", "", "", beside("+1"), of("after")),
        calc(f"bd{end}", "bend", "", "", f"={bend}", of("bend"), scale=max(of("most"))),
        calc(f"sh{end}", "highest before it by", "", "", f"={shift}", of("shift"), scale=1.0),
        calc(f"t{end}", f"{words}: largest {named}, between nodes", "", "Nm",
             f"=IF({within},MAX([m{end}],{fb}+{rise}),[m{end}])", of("value")),
    ]  # fmt: skip


def loss_rows(pace: PlacePace) -> list[Quantity]:
    """Return the rows of how losses count: a stage multiplies F by p + q where it drives, by p − q where it brakes."""
    stages = zip(("1", "2"), ("reducer", "mechanism"), pace.losses, strict=True)
    return [
        calc(f"@{name}{k}", f"Losses of the {stage}, {words}", f"{name}_{k}", "",
             f"=(1/@eta{k}{sign}@back{k})/2", value, source=f"(1/η_{k} {told} f_{k})/2")
        for k, stage, values in stages
        for (name, (sign, told, words)), value in zip(LOSSES.items(), values, strict=True)
    ]  # fmt: skip


def pace_tables(sheet: Sheet, view: PlacedWork) -> None:
    """Declare the trials, and the rate at which each limit binds."""
    pace, way = view.pacing, total("@sec.way")
    rest, xs = pace.rest, [asked.x for asked, _ in pace.tried]
    bounds = ",".join(f"[@limiting.x.{n}]" for n in range(1, len(pace.bounds) + 1))
    sheet.heading("Workings: the highest rate", ABOUT)
    sheet.rows(
        calc("@square0", "Mean square of the torque at no rate", "", "Nm²", f"={total('@sec.sq_0')}/(2*PI())", rest[0],
             scale=pace.sizes[0]),
        calc("@mean0", "Mean torque behind the reducer at no rate", "", "Nm", mean(way, 0), rest[1],
             scale=view.driven.sizes.behind),
        calc("@peak0", "Largest torque at no rate", "", "Nm", "=MAX([@sec.mT_0])", rest[2],
             scale=view.driven.sizes.torque),
        calc("@geared0", "Largest torque behind the reducer at no rate", "", "Nm", "=MAX([@sec.mS_0])", rest[3],
             scale=view.driven.sizes.behind),
        *(lowest_rows(view, f"MAX([@sec.m{LINE}_0])", rest[-1]) if view.knows_falling else ()),
    )  # fmt: skip
    tried = range(1, LAST)
    asked = (
        ("s", "mean square", "Nm²", ["=@rms^2", *(f"={total(f'@sec.sq_{n}')}/(2*PI())" for n in tried)],
         "@square0", "@motor_rated^2"),
        ("m", "mean torque", "Nm", ["=@smean+0", *(mean(way, n) for n in tried)], "@mean0", "@reducer_mean"),
        ("p", "peak torque", "Nm", [largest("T"), *(f"=MAX([@sec.{at_trial('T', n)}])" for n in tried)],
         "@peak0", "@motor_peak"),
        ("g", "peak torque behind the reducer", "Nm",
         [largest("S"), *(f"=MAX([@sec.{at_trial('S', n)}])" for n in tried)], "@geared0", "@reducer_peak"),
    )  # fmt: skip
    columns, line = [], ",[xc-1]^2" if view.knows_falling else ""
    for k, one in enumerate(asked):
        columns += searched(*one, [trials[k] for _, trials in pace.tried], pace.sizes[k])
    if view.knows_falling:
        columns += roots(view)
    sheet.table(
        "@pace", "Trials: the present rate, and where a limit seems to bind", LAST,
        calc("x", "x", "x", "", first("=1", f"=MIN({bounds},[xs-1],[xm-1],[xp-1],[xg-1]{line})", LAST), xs, scale=1.0),
        *steps(xs, TELLS, pace.apart),
        *columns,
    )  # fmt: skip
    limits_found(sheet, pace.each, (f"=[@pace.xp.{LAST}]", f"=[@pace.xg.{LAST}]"), view.knows_falling, LAST)


def roots(view: PlacedWork) -> list[Quantity]:
    """Return the columns of what the line of a falling curve must be at trials, over √x: the speed adds to it."""
    pace = view.pacing
    tells = ["=0" if n == SWITCH else told for n, told in enumerate(telling("z", "gapz", NEARER, LAST))]
    lines = [f"=MAX([@pl.{LINE}])", *(f"=MAX([@sec.{at_trial(LINE, n)}])" for n in range(1, LAST))]
    found = [trials[-1] for _, trials in pace.tried]
    return [
        calc("z", "√x", "√x", "", "=SQRT([x])", pace.roots, scale=1.0),
        *steps(pace.roots, tells, pace.roots_apart, "z", "z"),
        *searched("c", "line of the motor's curve", "Nm", lines, "@curve0", "@lowest", found, pace.sizes[-1], "z", "z"),
    ]


def mean(way: str, n: int) -> str:
    """Return the formula of the mean torque behind the reducer at a trial."""
    return f"=IF({way}>0,({total(f'@sec.cu_{n}')}/{way})^(1/3),0)"


def largest(column: str) -> str:
    """Return the formula of the largest torque at nodes at the present rate."""
    return f"=MAX(MAX([@pl.{column}]),0-MIN([@pl.{column}]))"


def at_trial(mark: str, n: int) -> str:
    """Return the column of the largest torque of each section at a trial."""
    return f"{'t' if n >= SWITCH else 'm'}{mark}_{n}"
