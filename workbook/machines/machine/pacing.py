"""The highest rate of a drive in cells: each limit's own x, the square of the rate over the present one.

At x the torque of a stretch is the same line over x y, so limits of speed and of peak torque are met in closed form.
∫T² and the mean torque are worked out at a few trials, each where parabolas through the last ones meet a limit.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from engine.machine.pace import (
    APART,
    FAR,
    LIMITS,
    NEARER,
    PARTS,
    REACH,
    TRIALS,
    TRUSTED,
    Crossing,
    Trial,
    meets,
    reached,
)
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled, total
from workbook.book.sentence import Said, bound
from workbook.drive.in_short import Highest
from workbook.entries.units import PER_MINUTE, shown
from workbook.machines.machine.curved import at_rest as curve_at_rest
from workbook.machines.machine.curved import curve_column
from workbook.machines.machine.stretched import Stretched
from workbook.machines.machine.stretches import BEFORE, BEHIND, BEYOND, BRANCHES, LINES, LOST

FARTHEST = f"{FAR:.0E}".replace("+", "")
NONE = {"1": "[{0}]<0", "2": f"OR([{{0}}]>={PARTS},[{{1}}]<0)", "3": f"[{{1}}]>={PARTS}"}
"""where a stretch has no part on a line of torque"""
ABOUT = (
    "x is the square of a rate over the present one. Speed and peaks meet their limits at an x in closed form. RMS and "
    "mean torque are worked out at trials: each is where a parabola through the last ones meets a limit, or where a "
    "peak does."
)
NONE_BINDS = "none"
GROWING = ("s", "c")
"""marks of figures that grow with the square of what they are tried over"""
LAST = TRIALS + 1
"""row of the last trial: the first is the present rate"""
EXACT = "from the motion's pieces, to 1e-9 below where a limit binds"


def telling(x: str = "x", gap: str = "gap", near: float = APART, rows: int = LAST) -> list[str]:
    """Return the formulas of whether trials are far enough apart to tell a parabola's bend."""
    told = f"IF(ABS([{gap}])>{near:.0E}*[{x}],1,0)".replace("E-0", "E-")
    return ["=0", f"=IF([{x}]<{TRUSTED:.0f},{told},0)", *(f"={told}" for _ in range(2, rows))]


def pace_columns(view: Stretched) -> list[Quantity]:
    """Return the columns of the stretches: where peaks meet their limits, and what is asked for at each trial."""
    return [
        *at_rest(view),
        *peaks(view),
        *curve_column(view, 0),
        *(q for trial in range(1, LAST) for q in tried(view, trial)),
    ]


def at_rest(view: Stretched) -> list[Quantity]:
    """Return what each stretch asks for next to no rate, and its way."""
    pace, (square, _, cube, _) = view.pace, view.driven.scales
    middle = view.velocity("([ub]+([ue]-[ub])*(1+[gauss.x])/2)")
    return [
        calc("w", "way", "∫|y'|", "",
             f"=[on]*ABS([dir])*([ue]-[ub])/2*SUMPRODUCT([gauss.w],[dir]*{middle})", view.rowed(pace.ways)),
        calc("sq0", "∫T² at no rate", "", "", "=[on]*([ue]-[ub])*IF([dir]=0,[hold],[b0])^2",
             view.rowed(pace.squares(0.0)), scale=square),
        calc("cu0", "∫|S|³ at no rate", "", "", "=[w]*ABS(@i1/[f]*[b0])^3", view.rowed(pace.cubes(0.0)), scale=cube),
    ]  # fmt: skip


def peaks(view: Stretched) -> list[Quantity]:
    """Return the y at which the torques of motor and reducer meet their limits in braking, and the x at both ends."""
    pace, near, far = view.pace, BEFORE, BEYOND
    b, g, over = "ABS([b0])", "ABS([g1])", "ABS([g1]+[s1])"
    first = f"@motor_peak+{b}"
    second = f"[y1]+({first}-{g}*[y1])/{over}"
    third = f"[y2]+({first}-{g}*[y1]-{over}*([y2]-[y1]))/ABS([g1]+[s1]+[s2])"
    geared = f"@reducer_peak+{b}*@i1/[f]"
    none, past = f"{FARTHEST}*@hard", f"[y2]+({geared}-{near}*[y2])/{far}"

    def x(name: str, label: str, limit: str, held: str, level: str, slope: str, shaft: int, most: float,
          without: str = "") -> Quantity:  # fmt: skip
        def end(y: str) -> str:
            rises = f"IF({slope}=0,{FARTHEST},({limit}-{level})/({slope}*ABS([{y}])))"
            place = "yf" if shaft == 0 else "yg"
            return f"IF([{y}]>{LOST},[{place}]/[{y}],IF([{y}]<0-{LOST},{rises},{FARTHEST}))"

        moving = f"IF({level}>{limit},0,MIN({FARTHEST},{end('yb')},{end('ye')}))"
        return calc(name, label, "x", "",
                    f"={without}IF([dir]=0,IF(ABS({held})<={limit},{FARTHEST},0),{moving}){')' if without else ''}",
                    view.of(lambda part: reached(part, shaft, most)), scale=1.0)  # fmt: skip

    return [
        calc("yf", "y where the motor's peak is met", "y", "",
             f"=IF([g1]=0,{none},MIN({none},[sign]*MAX([sign]*({first})/{g},[sign]*({second}),[sign]*({third}))))",
             view.of(lambda part: meets(part, 0, pace.peak_torque, 1.0)), scale=view.driven.sizes.acceleration),
        calc("yg", "y where the reducer's is met", "y", "",
             (f"=IF(OR(@reducer_peak=0,{near}=0),{none},"
              f"MIN({none},[sign]*MAX([sign]*({geared})/{near},[sign]*({past}))))"),
             view.of(lambda part: meets(part, 1, pace.reducer.peak_torque, 1.0)),
             scale=view.driven.sizes.acceleration),
        x("xp", "holds the motor's peak up to", "@motor_peak", "[hold]", b, g, 0, pace.peak_torque),
        x("xg", "holds the reducer's peak up to", "@reducer_peak", "[hold]*@eta1*@i1", f"{b}*@i1/[f]", near, 1,
          pace.reducer.peak_torque, f"IF(@reducer_peak=0,{FARTHEST},"),
    ]  # fmt: skip


def tried(view: Stretched, trial: int) -> list[Quantity]:
    """Return the columns of a trial: where y passes both bends, ∫T² and ∫|S|³ |y'|."""
    pace, at = view.pace, f"[@pace.x.{trial + 1}]"
    x = pace.trials[trial].x
    square, cube = (max(1e-9, *values.tolist()) for values in (pace.squares(x), pace.cubes(x)))
    places = {"1": f"p1_{trial}", "2": f"p2_{trial}"}
    columns = [
        q for index, name in places.items() for q in crossing(view, name, at, index, pace.crossing(x, int(index)))
    ]

    def lines(inner: Callable[[str, str, str], str]) -> str:
        terms = []
        for line, low, high in BRANCHES:
            ends = [places.get(end.removeprefix("p"), end) if end.startswith("p") else end for end in (low, high)]
            u = f"([{ends[0]}]+([{ends[1]}]-[{ends[0]}])*(1+[gauss.x])/2)"
            none = NONE[line].format(*(f"k{name}" for name in places.values()))
            wide = f"ABS([{ends[1]}]-[{ends[0]}])/2"
            terms.append(f"IF({none},0,{wide}*{inner(line, f'{at}*[per]*{view.acceleration(u)}', u)})")
        return "+".join(terms)

    def squared(line: str, y: str, _: str) -> str:
        level, slope = LINES[line]
        return f"SUMPRODUCT([gauss.w],({level}+{slope}*{y})^2)"

    def cubed(line: str, y: str, u: str) -> str:
        side = "[sign]" if line == "1" else "(0-[sign])"
        return f"SUMPRODUCT([gauss.w],({side}*{BEHIND[line].format(y=y)})^3*[dir]*{view.velocity(u)})"

    resting = "IF([dir]=0,([ue]-[ub])*[hold]^2"

    def again(name: str) -> str:
        return f"IF([@pace.gap.{trial + 1}]=0,[{name}_{trial - 1}]," if trial > 1 else "("

    return [
        *columns,
        calc(f"sq_{trial}", f"trial {trial}: ∫T²", "", "", f"=IF([on]=0,0,{again('sq')}{resting},{lines(squared)})))",
             view.rowed(pace.squares(x)), scale=square),
        calc(f"cu_{trial}", f"trial {trial}: ∫|S|³ |y'|", "", "",
             f"=IF([on]*ABS([dir])=0,0,{again('cu')}{lines(cubed)}))", view.rowed(pace.cubes(x)), scale=cube),
        *curve_column(view, trial, at, again("cv")),
    ]  # fmt: skip


def crossing(view: Stretched, name: str, at: str, index: str, found: Crossing) -> list[Quantity]:
    """Return in which part of a stretch y passes a bend at a trial, and where."""
    part, level, trial = f"k{name}", f"[y{index}]", int(name.rpartition("_")[2])
    before = f"p{index}_{trial - 1}"
    same = f"IF([@pace.gap.{trial + 1}]=0,[{{}}]," if trial > 1 else "("
    above, within = f"AND(@j1+@m>0,{at}*(MAX([yb],[ye])-{LOST})>{level})", f"{at}*(MIN([yb],[ye])+{LOST})<{level}"
    last, rise = PARTS - 1, "([z4]-[z0])"

    def counted(u: str) -> str:
        return f"MIN({last},SUMPRODUCT(({at}*([per]*{view.acceleration(u)}+{LOST})<{level})*1))"

    coarse, fine = counted(f"([z0]+{rise}*[fine.at])"), counted(f"([z0]+{rise}*([{part}]+[fine.at])/{PARTS})")
    spare = view.parts[-1].sides[0]
    return [
        calc(part, f"passes y_{index} in part", "", "",
             f"=IF([on]=0,0-1,{same.format(f'k{before}')}IF({above},IF({within},{coarse},0-1),{PARTS})))",
             filled(found.part, view.rows, -1), format="0"),
        calc(name, "where", "u", "rad",
             f"=IF([{part}]<0,[z0],IF([{part}]>={PARTS},[z4],"
             f"{same.format(before)}[z0]+{rise}*([{part}]+({fine}+0.5)/{PARTS})/{PARTS})))",
             filled(found.place, view.rows, spare), scale=1.0),
    ]  # fmt: skip


def pace_tables(sheet: Sheet, view: Stretched) -> None:
    """Declare the trials, and the rate at which each limit binds."""
    pace, driven = view.pace, view.driven
    rest = pace.mean_square(0.0), pace.mean_torque(0.0)
    torque, behind = max(rest[0], 1e-9), max(driven.sizes.behind, rest[1])
    sheet.heading("Workings: the highest rate", ABOUT)
    sheet.rows(
        calc("@square0", "Mean square of the torque at no rate", "", "Nm²", f"={total('@st.sq0')}/(2*PI())", rest[0],
             scale=torque),
        calc("@mean0", "Mean torque behind the reducer at no rate", "", "Nm",
             f"=IF(@way>0,({total('@st.cu0')}/@way)^(1/3),0)", rest[1], scale=behind),
        *curve_at_rest(view),
    )  # fmt: skip
    bounds = ",".join(f"[@limiting.x.{n}]" for n in range(1, len(pace.bounds) + 1))
    xs, asked, behind_it, _ = zip(*pace.trials, strict=True)
    squares = ["=@rms^2", *(f"={total(f'@st.sq_{trial}')}/(2*PI())" for trial in range(1, LAST))]
    lines = [f"=MAX([@st.cv_{trial}])" for trial in range(LAST)]
    means = ["=@smean+0", *(f"=IF(@way>0,({total(f'@st.cu_{t}')}/@way)^(1/3),0)" for t in range(1, LAST))]
    sheet.table(
        "@pace", "Trials: the present rate, and where a limit seems to bind", LAST,
        constant("k", "trial", "", "", list(range(LAST))),
        calc("x", "x", "x", "", first("=1", f"=MIN({bounds},[xs-1],[xm-1]{',[xc-1]^2' if view.knows_falling else ''})"),
             list(xs), scale=1.0),
        *steps(list(xs), telling(), pace.apart),
        *searched("s", "mean square", "Nm²", squares, "@square0", "@motor_rated^2", asked, pace.sizes[0]),
        *searched("m", "mean torque", "Nm", means, "@mean0", "@reducer_mean", behind_it, pace.sizes[1]),
        *(roots(view, lines) if view.knows_falling else ()),
    )  # fmt: skip
    limits_found(sheet, pace.each, ("=MIN([@st.xp])", "=MIN([@st.xg])"), view.knows_falling)


def roots(view: Stretched, lines: list[str]) -> list[Quantity]:
    """Return the columns of what the line of a falling curve must be at trials, over √x: the speed adds to it."""
    pace = view.pace
    found = [one.curve for one in pace.trials]
    return [
        calc("z", "√x", "√x", "", "=SQRT([x])", pace.roots, scale=1.0),
        *steps(pace.roots, telling("z", "gapz", NEARER), pace.roots_apart, "z", "z"),
        *searched("c", "line of the motor's curve", "Nm", lines, "@curve0", "@lowest", found, pace.sizes[2], "z", "z"),
    ]


def first(present: str, others: str, rows: int = LAST) -> list[str]:
    """Return a formula for the present rate and another for all trials."""
    return [present, *(others for _ in range(1, rows))]


def later(formula: str, rows: int = LAST) -> list[str]:
    """Return a formula for all trials but the first."""
    return [formula for _ in range(2, rows)]


def steps(xs: list[float], tells: list[str], apart: Sequence[int], x: str = "x", mark: str = "") -> list[Quantity]:
    """Return the columns of by how much x changes, and whether that is enough to tell a parabola's bend."""
    gaps = [0.0, *(after - before for before, after in pairwise(xs))]
    return [
        calc(f"gap{mark}", "step", "", "", first("=0", f"=[{x}]-[{x}-1]", len(xs)), gaps, scale=max(xs)),
        calc(f"apart{mark}", "tells the bend", "", "", tells, apart, format="0"),
    ]


def searched(
    mark: str, words: str, unit: str, formulas: list[str], rest: str, limit: str, found: Sequence[Trial], rise: float,
    x: str = "x", over: str = "",
) -> list[Quantity]:  # fmt: skip
    """Return the columns of a quantity that is asked for at trials, and where it meets its limit.

    ``x`` is the column that it is tried over, ``over`` the mark of those of its steps.
    """
    x, gap, apart = f"[{x}]", f"[gap{over}]", f"[apart{over}]"
    d, t, c, b, w = (f"{name}{mark}" for name in "dtcbw")
    rows = len(found)
    size = max(1e-9, *(abs(one.value) for one in found))
    rises = f"AND({x}>0,ABS([v{mark}]-{rest})>check_zero*ABS({rest}))"
    left = f"({limit}-{rest})"
    inside = f"[{b}]^2+4*[{c}]*{left}"
    meets_at = f"IF({rest}>{limit},0,IF([{w}]*{FARTHEST}<=2*{left},{FARTHEST},"
    meets_at += f"IF(2*{left}<={REACH:.0f}*{x}*[{w}],2*{left}/[{w}],10^ROUND(LOG10(2*{left}/[{w}]),0))))"
    turned = f"={apart}*[{t}]/({gap}+1-{apart})+(1-{apart})*"
    lone = f"IF({x}>0,[{d}]/{x},0)" if mark in GROWING else "0"

    def unlimited(value: str, formula: str) -> str:
        return formula if mark == "s" else f"IF({limit}=0,{value},{formula})"

    term = f"IF({inside}<0,0,[{b}]+SQRT(MAX(0,{inside})))"
    return [
        calc(f"v{mark}", words, "F", unit, formulas, [one.value for one in found], scale=size),
        calc(d, "its rise from rest", "D", "", f"=IF({rises},([v{mark}]-{rest})/{x},0)",
             [one.rise for one in found], scale=rise, source="(F − F_0)/x"),
        calc(t, "changes by", "", "", first("=0", f"=[{d}]-[{d}-1]", rows), [one.turn for one in found], scale=rise),
        calc(c, "bend", "c", "", [f"={lone}", f"{turned}{lone}", *later(f"{turned}[{c}-1]", rows)],
             [one.bend for one in found], scale=rise),
        calc(b, "slope", "b", "", f"=[{d}]-[{c}]*{x}", [one.slope for one in found], scale=rise),
        calc(w, "of its root", "", "",
             f"={unlimited('0', term)}", [one.term for one in found], scale=rise, source="b + √(b² + 4 c (L − F_0))"),
        calc(f"x{mark}", "meets its limit at", "x", "", f"={unlimited(FARTHEST, meets_at)}",
             [one.x for one in found], scale=1.0),
    ]  # fmt: skip


def limits_found(sheet: Sheet, each: Sequence[float], peaks: tuple[str, str], curve: bool, last: int = LAST) -> None:
    """Declare up to which x each limit is held.

    ``peaks`` are the formulas of those of motor and reducer, ``curve`` says whether the trials look at a falling one.
    """
    formulas = [
        f"=IF(@speed>0,MIN({FARTHEST},(@motor_nmax/@speed)^2),{FARTHEST})",
        f"=IF(AND(@reducer_nmax>0,@speed>0),MIN({FARTHEST},(@reducer_nmax/@speed)^2),{FARTHEST})",
        *peaks, f"=[@pace.xs.{last}]", f"=[@pace.xm.{last}]",
        f"=MIN({FARTHEST},[@pace.xc.{last}]^2)" if curve else f"={FARTHEST}",
    ]  # fmt: skip
    sheet.table(
        "@limiting", "Up to which rate each limit is held", len(LIMITS),
        constant("name", "limit", "", "", list(LIMITS), align="left"),
        calc("x", "up to", "x", "", formulas, list(each), scale=1.0,
             source="of RMS and mean torque exact where none binds before"),
    )  # fmt: skip


def rate_of(view: Stretched) -> Highest:
    """Return the highest rate of a drive."""
    return Highest(shown(view.paced.rate, PER_MINUTE), view.paced.limit or NONE_BINDS, view.driven.entered.rate)


def mending(view: Stretched) -> Said:
    """Return what would mend a limit that is not held: the rate up to which all are."""
    return bound("@highest", rate_of(view).rate, "; the drive holds all up to ", " cycles/min")


def highest(view: Stretched, below: str = "check_zero", source: str = EXACT) -> list[Quantity]:
    """Return the results: the highest rate, a share ``below`` where a limit binds, and the limit that binds there."""
    rate, limit, _ = rate_of(view)
    return [
        result("@highest", "Highest rate at which it holds all limits", "n_max", "cycles/min",
               f"=@rate*SQRT(MIN([@limiting.x]))*(1-{below})", rate, source=source),
        result("@binds", "the limit that binds there", "", "",
               f'=IF(MIN([@limiting.x])>={FARTHEST},"{NONE_BINDS}",'
               "INDEX([@limiting.name],MATCH(MIN([@limiting.x]),[@limiting.x],0)))", limit,
               align="right"),
        calc("@settled", "Last step of the search for it, relative", "", "",
             "=IF(MIN([@limiting.x])>0,ABS(MIN([@limiting.x])/[@pace.x.last]-1),0)", view.paced.last_step, scale=1.0,
             format='0E+00;-0E+00;"–"', source="the search has settled where it is below 1e-6"),
    ]  # fmt: skip
