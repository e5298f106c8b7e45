"""The stretches of a drive in cells: its motion cut where the acceleration turns and at edges of process forces.

In a stretch y, the acceleration against what the load resists with, only rises or only falls, and the torque is a line
over it that bends twice: T = B + g y + ΔA_1 (y − y_1)+ + ΔA_2 (y − y_2)+. So peaks are at ends of stretches, and
integrals are those of straight lines between the places where y passes 0 of the torque, y_1 and y_2.
"""

from __future__ import annotations

from functools import partial

from engine.motion.pieces import MotionPiece
from engine.motion.turning import PARTS
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.book.rows import filled
from workbook.machines.machine.breaks import ACTS
from workbook.machines.machine.stretched import Stretched

LEAST = 6
"""powers of a polynomial that the tables have columns of at least"""
LOST = "check_zero*@hard"
PLACE = ("p{0}a", "p{0}b", "p{0}")
LINES = {
    "1": ("[b0]", "[g1]"),
    "2": ("([b0]-[s1]*[y1])", "([g1]+[s1])"),
    "3": ("([b0]-[s1]*[y1]-[s2]*[y2])", "([g1]+[s1]+[s2])"),
}
"""the torque's lines over y: beside 0, past y_1, past y_2"""
BEFORE, BEYOND = (f"IF([sign]<0,@drives_{name},@resists_{name})" for name in ("r", "r2"))
ALONG = f"([b0]*@i1/[f]-[sign]*{BEFORE}*{{y}})"
BEHIND = {"1": ALONG, "2": ALONG, "3": f"([b0]*@i1/[f]-[sign]*({BEFORE}*[y2]+{BEYOND}*({{y}}-[y2])))"}
"""of the torque behind the reducer: beside what the motor's own inertia takes it may be next to nothing"""
FINER = ("", "/100", "/10000")
"""by which a round's bracket is smaller"""
BRANCHES = (("1", "z0", "p1"), ("2", "p1", "p2"), ("3", "p2", "z4"))
WORKS = (("1", "z0", "p3"), ("1", "p3", "p1"), ("2", "p1", "p2"), ("3", "p2", "z4"))
ORDER = {"z0": 0, "p3": 1, "p1": 2, "p2": 3, "z4": 4}


def stretches_table(sheet: Sheet, view: Stretched, *more: Quantity) -> None:
    """Declare the stretches, each with its torque's line, extremes and integrals, and more columns."""
    sheet.table(
        "@st", "Stretches", view.rows,
        constant("k", "stretch", "k", "", list(range(1, view.rows + 1))),
        *placed(view),
        *(coefficient(view, n) for n in range(1, max(LEAST, view.one.pieces.powers))),
        *(column for k, sine in enumerate(view.one.pieces.sines) for column in waves(view, k, sine.mark)),
        *directed(view), *lined(view), *crossed(view), *ends(view), *integrals(view),
        *more,
    )  # fmt: skip


def waves(view: Stretched, k: int, mark: str) -> list[Quantity]:
    """Return amplitude, frequency and phase of a sine of each stretch's piece."""
    told = (("A", "amplitude", view.driven.axis.motion.size(0)), ("om", "frequency", 0.0), ("ph", "phase", 1.0))
    return [
        calc(f"{name}{mark}", words, f"{name}{mark}", "",
             f"=INDEX([axis{view.driven.number}_pieces.{name}{mark}],[q])",
             view.piece_figures(partial(of_sine, k, j)), scale=scale)
        for j, (name, words, scale) in enumerate(told)
    ]  # fmt: skip


def of_sine(k: int, j: int, piece: MotionPiece) -> float:
    """Return amplitude, frequency or phase of a sine of a piece."""
    return piece.sines[k][j]


def coefficient(view: Stretched, n: int) -> Quantity:
    """Return a coefficient of each stretch's piece."""
    found = n < view.one.pieces.powers
    formula = f"=INDEX([axis{view.driven.number}_pieces.c{n}],[q])" if found else "=0*[k]"
    return calc(f"c{n}", "coefficient", f"c{n}", "", formula, view.piece_figures(lambda piece: piece.c[n]),
                scale=view.driven.axis.motion.size(n))  # fmt: skip


def placed(view: Stretched) -> list[Quantity]:
    """Return begin, end and piece of each stretch; spare rows repeat the last."""
    last = view.spans[-1]

    def of(k: int) -> list[float]:
        return filled([span[k] for span in view.spans], view.rows, last[k])

    begin = ["=0*[k]", *("=IF([e-1]>=360-timing_eps,[b-1],[e-1])" for _ in range(view.rows - 1))]
    after = "SUMPRODUCT(([@breaks.at]<=[b]+timing_eps)*1)+1"
    return [
        calc("b", "begins at", "", "°", begin, of(0), scale=360.0, format="0.0##"),
        calc("e", "ends at", "", "°", f"=SMALL([@breaks.at],{after})", of(1), scale=360.0, format="0.0##"),
        calc("on", "is no spare row", "", "",
             "=IF([k]=1,1,IF(INDEX([@st.e],MAX([k]-1,1))>=360-timing_eps,0,1))", view.used, format="0"),
        calc("q", "piece", "q", "",
             f"=MATCH(([b]+[e])/2,[axis{view.driven.number}_pieces.begin],1)", view.numbers, format="0"),
    ]  # fmt: skip


def directed(view: Stretched) -> list[Quantity]:
    """Return where each stretch lies in its piece, the direction of motion, and what resists."""
    i, of, sizes = view.driven.number, view.of, view.driven.sizes
    begin = f"INDEX([axis{i}_pieces.begin],[q])"
    middle = view.velocity("(([ub]+[ue])/2)")
    back = f"MIN([dir]*{view.velocity('[ub]')},[dir]*{view.velocity('[ue]')})<0-check_zero*@vmax"
    acts, force = ACTS.format(x="[x]"), "N" if view.driven.travels else "Nm"
    angle = f"(([b]+[e])/2+[axes_taken.late.{i}])"
    return [
        calc("ub", "from", "u", "rad", f"=RADIANS([b]-{begin})", of(lambda p: p.low), scale=1.0),
        calc("ue", "to", "u", "rad", f"=RADIANS([e]-{begin})", of(lambda p: p.high), scale=1.0),
        calc("dir", "direction", "", "",
             f"=IF(ABS({middle})>check_zero*@vmax,SIGN({middle}),0)", of(lambda p: p.going), format="0"),
        calc("back", "turns back", "", "", f"=IF([dir]=0,0,IF({back},1,0))", of(lambda p: int(p.turns_back)),
             format="0"),
        calc("x", f"{view.one.machine.over.angle} in its middle", "θ", "°",
             f"={angle}-360*INT(({angle}+timing_eps)/360)", view.middles, scale=360.0, format="0.0##"),
        calc("r", "what resists", "R", force,
             f"=IF([dir]=0,@steady+SUMPRODUCT({acts}*[@windows.always]),[dir]*@steady+@rub"
             f"+SUMPRODUCT({acts}*([dir]*[@windows.always]+[@windows.moving])))", of(lambda p: p.bends.resists),
             scale=sizes.force),
        calc("sign", "it resists, or drives", "", "", "=IF([r]<0,0-1,1)", of(lambda p: p.bends.sign), format="0"),
    ]  # fmt: skip


def lined(view: Stretched) -> list[Quantity]:
    """Return the line of the torque over y: where it bends, and its slopes."""
    of, sizes = view.of, view.driven.sizes

    def way(name: str) -> str:
        return f"IF([sign]<0,@drives_{name},@resists_{name})"

    return [
        calc("b0", "torque at y = 0", "B", "Nm", f"=[r]*{way('b')}", of(lambda p: p.bends.level), scale=sizes.torque),
        calc("g1", "slope", "g", "Nm/y", f"=0-[sign]*{way('a')}", of(lambda p: p.falling),
             scale=sizes.slope),
        calc("s1", "change at y_1", "ΔA_1", "Nm/y", f"={way('s1')}", of(lambda p: p.bends.steps[0]),
             scale=sizes.slope),
        calc("s2", "change at y_2", "ΔA_2", "Nm/y", f"={way('s2')}", of(lambda p: p.bends.steps[1]),
             scale=sizes.slope),
        calc("y1", "turns in the reducer at", "y_1", "", f"=IF(@j1+@m>0,ABS([r])*{way('y')},2*@hard)",
             of(lambda p: p.levels[1]), scale=sizes.acceleration),
        calc("y2", "in the mechanism at", "y_2", "", "=IF(@m>0,ABS([r])/@m,[y1])", of(lambda p: p.levels[2]),
             scale=sizes.acceleration),
        calc("y3", "in the motor at", "y_3", "", "=IF([g1]=0,2*@hard,ABS([b0]/[g1]))", of(lambda p: p.levels[0]),
             scale=sizes.acceleration),
    ]  # fmt: skip


def crossed(view: Stretched) -> list[Quantity]:
    """Return y at the ends of a stretch, and where it passes each bend, round by round."""
    of, acceleration = view.of, view.driven.sizes.acceleration
    columns = [
        calc("per", "y for y'' = 1", "", "", "=0-[sign]*[dir]*(timing_omega*@faster)^2", of(lambda p: p.factor)),
        calc("yb", "y at its begin", "y", "", f"=[per]*{view.acceleration('[ub]')}", of(lambda p: p.ends[0]),
             scale=acceleration),
        calc("ye", "y at its end", "y", "", f"=[per]*{view.acceleration('[ue]')}", of(lambda p: p.ends[1]),
             scale=acceleration),
        calc("z0", "y rises from", "u", "rad", f"=IF([yb]-[ye]>{LOST},[ue],[ub])", of(lambda p: p.sides[0]),
             scale=1.0),
        calc("z4", "to", "u", "rad", "=[ub]+[ue]-[z0]", of(lambda p: p.sides[1]), scale=1.0),
    ]  # fmt: skip
    for place, level, index in (("3", "y3", 0), ("1", "y1", 1), ("2", "y2", 2)):
        columns += passing(view, place, level, index)
    return columns


def passing(view: Stretched, place: str, level: str, index: int) -> list[Quantity]:
    """Return whether y passes a level, and where, round by round."""
    crosses = f"AND([on]=1,MIN([yb],[ye])<[{level}]-{LOST},MAX([yb],[ye])>[{level}]+{LOST})"
    columns = [
        calc(f"x{place}", f"passes {level}", "", "", f"=IF({crosses},1,0)",
             view.counted(lambda part: int(part.crosses(part.levels[index]))), format="0")
    ]  # fmt: skip
    at = "[z0]"
    for turn, pattern in enumerate(PLACE, 1):
        name, last = pattern.format(place), turn == len(PLACE)
        step = f"([z4]-[z0]){FINER[turn - 1]}"
        below = f"[per]*{view.acceleration(f'({at}+{step}*[grid.at])')}<[{level}]-{LOST}"
        found = f"{at}+{step}*(MIN({PARTS - 1},SUMPRODUCT(({below})*1)){'+0.5' if last else ''})/{PARTS}"
        other = f"IF(MAX([yb],[ye])<=[{level}]+{LOST},[z4],[z0])" if last else "[z0]"
        columns.append(
            calc(name, "where" if last else "not before", "u", "rad", f"=IF([x{place}]=0,{other},{found})",
                 view.passing(index, turn), scale=1.0)
        )  # fmt: skip
        at = f"[{name}]"
    return columns


def ends(view: Stretched) -> list[Quantity]:
    """Return the torques of motor and reducer at both ends, and at rest."""
    of, sizes = view.of, view.driven.sizes

    def motor(y: str, word: str, k: int) -> Quantity:
        line = f"[b0]+[g1]*[{y}]+[s1]*MAX(0,[{y}]-[y1])+[s2]*MAX(0,[{y}]-[y2])"
        return calc(f"t{y}", f"torque at its {word}", "T", "Nm", f"=IF([dir]=0,[hold],[dir]*({line}))",
                    of(lambda p: p.torque_at(k)), scale=sizes.torque)  # fmt: skip

    def shaft(y: str, word: str, k: int) -> Quantity:
        line = f"IF([{y}]<[y2],{BEHIND['1']},{BEHIND['3']})".format(y=f"[{y}]")
        return calc(f"r{y}", f"behind the reducer at its {word}", "S", "Nm",
                    f"=IF([dir]=0,[hold]*@eta1*@i1,[dir]*{line})", of(lambda p: p.shaft_at(k)),
                    scale=sizes.behind)  # fmt: skip

    return [
        calc("hold", "torque at rest", "", "Nm", '=IF(@holding="brake",0,[r]/@eta2/@i2/@eta1/@i1)',
             of(lambda p: p.held_at_rest), scale=sizes.torque, source="as if it drove"),
        calc("f", "factor of the reducer", "f", "", "=IF([sign]<0,@back1,1/@eta1)", of(lambda p: p.first_factor)),
        motor("yb", "begin", 0), motor("ye", "end", 1), shaft("yb", "begin", 0), shaft("ye", "end", 1),
    ]  # fmt: skip


def integral(view: Stretched, level: str, low: str, high: str, function: str, times: str = "") -> str:
    """Return the formula of an integral between two places, of y, |y'| and ``level``; 0 at rest and in spare rows."""
    u = f"([{low}]+([{high}]-[{low}])*(1+[gauss.x])/2)"
    inner = function.format(y=f"[per]*{view.acceleration(u)}", v=f"[dir]*{view.velocity(u)}", level=level)
    wide = f"ABS([{high}]-[{low}])"
    return f"=IF([on]*ABS([dir])*{wide}=0,0,{wide}/2*SUMPRODUCT([gauss.w],{inner}){times})"


def integrals(view: Stretched) -> list[Quantity]:
    """Return ∫T² and the work of each line, and behind the reducer ∫|S|³ |y'|."""
    driven, of = view.driven, view.counted
    torque, work, cubed, _ = driven.scales

    def square(line: str, low: str, high: str) -> Quantity:
        level, slope = LINES[line]
        return calc(f"sq{line}", f"∫T² on line {line}", "", "",
                    integral(view, level, low, high, f"({{level}}+{slope}*{{y}})^2"),
                    of(lambda p: p.square((ORDER[low], ORDER[high]), torque)), scale=torque)  # fmt: skip

    def cube(line: str, low: str, high: str) -> Quantity:
        side = "[sign]" if line == "1" else "(0-[sign])"
        return calc(f"cu{line}", f"∫|S|³ on line {line}", "", "",
                    integral(view, "", low, high, f"({side}*{BEHIND[line]})^3*{{v}}"),
                    of(lambda p: p.cube((ORDER[low], ORDER[high]), cubed)), scale=cubed)  # fmt: skip

    def worked(line: str, low: str, high: str) -> Quantity:
        level, slope = LINES[line]
        return calc(f"w{ORDER[low]}", "work", "", "J",
                    integral(view, level, low, high, f"({{level}}+{slope}*{{y}})*{{v}}", "*@i"),
                    of(lambda p: p.work((ORDER[low], ORDER[high]), work)), scale=work)  # fmt: skip

    return [
        *(square(*one) for one in BRANCHES), *(cube(*one) for one in BRANCHES), *(worked(*one) for one in WORKS),
        calc("square", "∫T²", "", "", "=[on]*IF([dir]=0,([ue]-[ub])*[hold]^2,[sq1]+[sq2]+[sq3])",
             of(lambda p: p.square_in_all(torque)), scale=torque),
        calc("drives", "driven", "", "J", "=IF([sign]>0,[w0],[w1]+[w2]+[w3])", of(lambda p: p.driven(work)),
             scale=work),
        calc("returns", "regenerated", "", "J", "=[drives]-([w0]+[w1]+[w2]+[w3])", of(lambda p: p.regenerated(work)),
             scale=work),
        calc("cube", "∫|S|³ |y'|", "", "", "=[cu1]+[cu2]+[cu3]", of(lambda p: p.cube((0, 4), cubed)), scale=cubed),
    ]  # fmt: skip
