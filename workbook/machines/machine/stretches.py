"""The stretches of a drive in cells: its motion cut where the acceleration turns and at edges of process forces.

In a stretch y, the acceleration against what the load resists with, only rises or only falls, and the torque is a line
over it that bends twice: T = B + g y + ΔA_1 (y − y_1)+ + ΔA_2 (y − y_2)+. So peaks are at ends of stretches, and
integrals are those of straight lines between the places where y passes 0 of the torque, y_1 and y_2.
"""

from __future__ import annotations

from functools import partial
from itertools import chain
from typing import Any

from engine.machine.bent import HALVED, root_term, septic
from engine.motion.pieces import MotionPiece
from engine.motion.turning import PARTS
from workbook.book.declare import Quantity, Sheet, calc, constant, given
from workbook.book.rows import filled
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.chain import WINDOWS
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
FINER = ("", "/100", "/10000")
"""by which a round's bracket is smaller"""
BRANCHES = (("1", "z0", "p1"), ("2", "p1", "p2"), ("3", "p2", "z4"))
WORKS = (("1", "z0", "p3"), ("1", "p3", "p1"), ("2", "p1", "p2"), ("3", "p2", "z4"))
ORDER = {"z0": 0, "p3": 1, "p1": 2, "p2": 3, "z4": 4}
ACTS = "(({x}>=[@windows.from])*({x}<[@windows.from]+[@windows.span])+({x}+360<[@windows.from]+[@windows.span]))"


def windows_table(sheet: Sheet, key: str, view: Stretched) -> None:
    """Declare the process forces over the cycle."""
    entered, unit = view.driven.entered.load.windows, "N" if view.driven.travels else "Nm"
    found = view.driven.windows

    def entry(name: str) -> list[Any]:
        return filled([getattr(w, name) for w in entered], WINDOWS, None)

    spans = [shown((w.end - w.begin), DEGREE) for w in found]
    sheet.row += 1
    sheet.table(
        "@windows", "Process forces over the cycle: leave spare rows empty", WINDOWS,
        constant("k", "number", "k", "", list(range(1, WINDOWS + 1))),
        given("start", "from", "", "°", entry("start"), f"{key}.load.windows.*.start", format="0.0##"),
        given("stop", "to", "", "°", entry("stop"), f"{key}.load.windows.*.stop", format="0.0##",
              source="of the master shaft"),
        given("force", "force", "", unit, entry("force"), f"{key}.load.windows.*.force", format="0.0##"),
        given("resists", "resists", "", "", entry("resists"), f"{key}.load.windows.*.resists",
              source="always, or moving"),
        calc("from", "from", "", "°", "=[start]+0", filled([w.start for w in entered], WINDOWS), format="0.0##"),
        calc("span", "for", "", "°", "=[stop]-[start]+IF([stop]+0<[start]+0,360,0)",
             filled([span + (360 if span < 0 else 0) for span in spans], WINDOWS), format="0.0##"),
        calc("always", "always", "", unit, '=IF([resists]="moving",0,[force]+0)',
             filled([w.load.torque for w in found], WINDOWS)),
        calc("moving", "against motion", "", unit, '=IF([resists]="moving",[force]+0,0)',
             filled([w.load.friction for w in found], WINDOWS)),
    )  # fmt: skip


def turns_table(sheet: Sheet, view: Stretched) -> None:
    """Declare where the acceleration turns within a piece."""
    table, room = f"axis{view.driven.number}_pieces", view.room
    c3, c4, c5, d = (held(view, name) for name in ("c3", "c4", "c5", "d"))
    quintic = f"{held(view, 'c6')}=0,{held(view, 'c7')}=0"
    amplitude, om, ph = (held(view, name) for name in ("A", "om", "ph"))
    polynomial = (f"IF({c5}=0,0,[w]/(10*{c5}))", f"IF([w]=0,0,{c3}/[w])", "0", "0")
    places = range(1, view.places_of_piece + 1)
    terms = [0.0 if septic(piece) else root_term(*piece.c[3:6]) for piece in view.pieces]
    inside = f"4*{c4}^2-10*{c3}*{c5}"
    rooted = f"AND({quintic},{inside}>0)" if view.septics else f"{inside}>0"

    def sine(j: int) -> str:
        return f"((INT({ph}/PI()-0.5+check_zero)+{j}+0.5)*PI()-{ph})/{om}"

    def of_polynomial(j: int) -> str:
        if not view.septics:
            return polynomial[j - 1]
        half = f"IF({c3}=0,1-{HALVED!r},{HALVED!r})*{d}" if j == 1 else "0"
        return view.by_ladder(f"bend{j}", f"IF(AND({quintic}),{polynomial[j - 1]},{half})")

    def found(j: int) -> list[float]:
        return filled([places[j] for places in view.raw], room, view.spare_places[j])

    sheet.table(
        "@turns", "Where the acceleration turns within a piece", room,
        constant("r", "piece", "r", "", list(range(1, room + 1))),
        calc("w", "of its slope's roots", "w", "",
             f"=IF({rooted},0-(2*{c4}+IF({c4}<0-check_zero*SQRT({inside}),0-1,1)*SQRT({inside})),0)",
             filled(terms, room, terms[-1]), scale=max(1e-9, *map(abs, terms))),
        *(calc(f"u{j}", f"place {j}", "u", "rad", f"=IF({amplitude}=0,{of_polynomial(j)},{sine(j)})", found(j - 1),
               scale=1.0)
          for j in places),
        *(calc(f"t{j}", f"place {j}", "θ", "°",
               f"=IF(AND([u{j}]>check_zero*{d},[u{j}]<(1-check_zero)*{d}),"
               f"INDEX([{table}.begin],[r])+DEGREES([u{j}]),360)",
               view.turned[j - 1], source="360: none", format="0.0##", scale=360.0)
          for j in places),
    )  # fmt: skip


def held(view: Stretched, name: str) -> str:
    """Return the formula of a figure of a row's piece; 0 of a power that no motion of the book has."""
    power = int(name[1:]) if name[1:].isdigit() else 0
    return "0" if power >= view.one.pieces.powers else f"INDEX([axis{view.driven.number}_pieces.{name}],[r])"


def breaks_table(sheet: Sheet, view: Stretched) -> None:
    """Declare where a stretch can begin: at pieces, where the acceleration turns in one, at process forces."""
    i, room = view.driven.number, view.room
    formulas = [f"=[axis{i}_pieces.begin.{r}]" for r in range(1, room + 1)]
    formulas += [f"=[@turns.t{j}.{r}]" for j in range(1, view.places_of_piece + 1) for r in range(1, room + 1)]
    for n in range(1, WINDOWS + 1):
        for edge in ("start", "stop"):
            told = f"([@windows.{edge}.{n}]-[axes.late.{i}])"
            formulas.append(f'=IF([@windows.{edge}.{n}]="",360,{told}-360*INT({told}/360))')
    late = f"(0-[axes.late.{i}])"
    formulas += [f"={late}-360*INT({late}/360)", *(formula for _, formula in view.further), "=360+0"]
    further = [angle for angle, _ in view.further]
    sheet.table(
        "@breaks", "Where a stretch can begin", len(formulas),
        constant("n", "number", "", "", list(range(1, len(formulas) + 1))),
        calc("at", "angle of its phases", "θ", "°", formulas,
             [*view.begins, *chain(*view.turned), *view.edges, view.turn_begin, *further, TURN], scale=360.0,
             format="0.0##"),
    )  # fmt: skip


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
    angle = f"(([b]+[e])/2+[axes.late.{i}])"
    return [
        calc("ub", "from", "u", "rad", f"=RADIANS([b]-{begin})", of(lambda p: p.low), scale=1.0),
        calc("ue", "to", "u", "rad", f"=RADIANS([e]-{begin})", of(lambda p: p.high), scale=1.0),
        calc("dir", "direction", "", "",
             f"=IF(ABS({middle})>check_zero*@vmax,SIGN({middle}),0)", of(lambda p: p.going), format="0"),
        calc("back", "turns back", "", "", f"=IF([dir]=0,0,IF({back},1,0))", of(lambda p: int(p.turns_back)),
             format="0"),
        calc("x", "master angle in its middle", "θ", "°", f"={angle}-360*INT({angle}/360)", view.middles, scale=360.0,
             format="0.0##"),
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
        own = f"@i1*([t{y}]+[dir]*[sign]*@j0*@i*[{y}])"
        return calc(f"r{y}", f"behind the reducer at its {word}", "S", "Nm",
                    f"=IF([dir]=0,[hold]*@eta1*@i1,{own}*IF([{y}]<[y1],1/[f],[f]))",
                    of(lambda p: p.shaft_at(k)), scale=sizes.behind)  # fmt: skip

    return [
        calc("hold", "torque at rest", "", "Nm", '=IF(@holding="brake",0,[r]/@eta2/@i2/@eta1/@i1)',
             of(lambda p: p.held_at_rest), scale=sizes.torque, source="as if it drove"),
        calc("f", "factor of the reducer", "f", "", "=IF([sign]<0,@eta1,1/@eta1)", of(lambda p: p.first_factor)),
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
        level, slope = LINES[line]
        side = "[sign]" if line == "1" else "(0-[sign])"
        inner = f"({side}*({{level}}+({slope}+[sign]*@j0*@i)*{{y}}))^3*{{v}}"
        factor = "@i1/[f]" if line == "1" else "@i1*[f]"
        return calc(f"cu{line}", f"∫|S|³ on line {line}", "", "",
                    integral(view, level, low, high, inner, f"*({factor})^3"),
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
