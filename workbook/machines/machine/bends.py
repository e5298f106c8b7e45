"""The torque of a motor over the acceleration in cells: where its line bends; each phase's extremes and mean square.

In the direction of motion T = B + A b + Σ ΔA_k (y − y_k)+, b the acceleration, y that against what the load resists.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from engine.drivetrain.bends import BentMove
from engine.laws.base import Shapes
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.motion import AxisRows

ABOUT = (
    "In each direction the torque over the acceleration b is a line that bends at y_1 and y_2, where power turns round "
    "in the reducer and in the mechanism (y: the acceleration against what resists)."
)
N1 = "=[peak]*([flat]*(1-[x{0}])+[sine]*2/PI()*(SQRT(1-[x{0}]^2)-[x{0}]*[gap{0}])+[ramp]*(1-[x{0}])^2/2)"
N2 = (
    "=[peak]^2*([flat]*(1-[x{0}])^2+[sine]*2/PI()*([gap{0}]*(1/2+[x{0}]^2)-3/2*[x{0}]*SQRT(1-[x{0}]^2))"
    "+[ramp]*(1-[x{0}])^3/3)"
)
SQUARE = (
    "=IF([dir]=0,0,[a]^2*[mean2]+2*[a]*[b]*[mean]+[b]^2"
    "+2*[s1]*([b]*[n1]-[sign]*[a]*([y1]*[n1]+[nn1]))+2*[s2]*([b]*[n2]-[sign]*[a]*([y2]*[n2]+[nn2]))"
    "+[s1]^2*[nn1]+[s2]^2*[nn2]+2*[s1]*[s2]*([nn2]+([y2]-[y1])*[n2]))"
)
WAYS = {"forward": "1", "backward": "(0-1)"}


def both_ways(sheet: Sheet, driven: Driven) -> None:
    """Declare for each direction of motion where and how the torque bends."""
    sheet.heading("Workings: the torque over the acceleration", ABOUT)
    for name, way in driven.bends.items():
        w, sign = f"@{name}", WAYS[name]
        y1, y2 = way.turns
        slopes, steps = way.slopes, way.steps
        torque, slope, acc = driven.sizes.torque, max(slopes), driven.sizes.acceleration
        factors = [f"IF({w}_sign{sign_of},{{0}},1/{{0}})" for sign_of in ("<0", ">0")]
        keep, turned = (factor.format("@eta1") for factor in factors)
        keep2, turned2 = (factor.format("@eta2") for factor in factors)

        def line(one: str, other: str) -> str:
            return f"=@j0*@i+{one}/@i1*({other}*@m/@i2+@j1*@i2)"

        sheet.rows(
            calc(f"{w}_r", f"Moving {name}: the load resists with", "R", "", f"={sign}*@steady+@rub", way.resists,
                 scale=driven.sizes.force),
            calc(f"{w}_sign", "it resists (1) or drives (−1)", "", "", f"=IF({w}_r<0,0-1,1)", way.sign, format="0"),
            calc(f"{w}_y1", "power turns round in the reducer at", "y_1", "",
                 f"=IF(@m+@j1>0,{keep2}*ABS({w}_r)/@i2/({keep2}*@m/@i2+@j1*@i2),0)", y1, scale=acc),
            calc(f"{w}_y2", "and in the mechanism at", "y_2", "",
                 f"=IF(@m>0,ABS({w}_r)/@m,{w}_y1)", y2, scale=acc),
            calc(f"{w}_b", "Torque at b = 0", "B", "Nm", f"={keep}*{keep2}*{w}_r/@i", way.level, scale=torque),
            calc(f"{w}_a", "Slope", "A", "Nm/b", line(keep, keep2), slopes[0], scale=slope),
            calc(f"{w}_a1", "between both bends", "A_1", "Nm/b", line(turned, keep2), slopes[1], scale=slope),
            calc(f"{w}_a2", "past both", "A_2", "Nm/b", line(turned, turned2), slopes[2], scale=slope),
            calc(f"{w}_s1", "change at y_1", "ΔA_1", "Nm/b", f"=0-{w}_sign*({w}_a1-{w}_a)", steps[0], scale=slope),
            calc(f"{w}_s2", "change at y_2", "ΔA_2", "Nm/b", f"=0-{w}_sign*({w}_a2-{w}_a1)", steps[1], scale=slope),
        )  # fmt: skip


def moves_table(sheet: Sheet, one: AxisRows, driven: Driven) -> None:
    """Declare a row for each phase: accelerations, extremes of the torque, and its mean square."""
    t, n, size = one.name, one.machine.machine.sizes.phases, driven.sizes.torque
    acc, moves = driven.sizes.acceleration, driven.moves

    def of(figure: Callable[[BentMove], float], spare: Any = 0.0) -> list[Any]:
        return [figure(moves[k]) if k in moves else spare for k in range(n)]

    def picked(name: str) -> str:
        return f"=IF([dir]<0,@backward_{name},@forward_{name})"

    def way(name: str) -> list[Any]:
        spare = driven.bends["forward"]
        return of(lambda m: getattr(m.bends, name), getattr(spare, name))

    def bent(name: str, k: int) -> list[float]:
        return [pair[k - 1] for pair in way(name)]

    lows, highs = of(lambda m: driven.torques(m)[0]), of(lambda m: driven.torques(m)[1])
    shapes = filled([p.law.shapes() or Shapes() for p in one.axis.phases], n, Shapes())
    signs = way("sign")
    rows = [shape.down if sign > 0.0 else shape.up for shape, sign in zip(shapes, signs, strict=True)]
    laws = one.machine.machine.laws
    numbers = filled([laws.number(p.law) for p in one.axis.given.phases], n, 1)
    sheet.row += 1
    sheet.table(
        "@moves", "Phases", n,
        constant("k", "phase", "k", "", list(range(1, n + 1))),
        calc("dir", "direction", "", "", f"=SIGN(INDEX([{t}.h],[k]))", of(lambda m: m.bends.direction), format="0"),
        calc("share", "share of the cycle", "", "",
             f"=IF([dir]=0,0,INDEX([{t}.span],[k])/(2*PI()))", driven.shares(n)),
        calc("no", "law", "", "", f"=INDEX([{t}.no],[k])", numbers, format="0"),
        calc("per", "b for a = 1", "|h|/t²", "",
             f"=IF([dir]=0,0,ABS(INDEX([{t}.h],[k]))/INDEX([{t}.span],[k])^2*timing_omega^2)",
             of(lambda m: m.per), scale=acc),
        calc("hi", "highest b", "", "", "=[per]*INDEX(law_ca_max,[no])", of(lambda m: m.highest), scale=acc),
        calc("lo", "lowest b", "", "", "=[per]*INDEX(law_ca_min,[no])", of(lambda m: m.lowest), scale=acc),
        *at(driven, "hi", "highest", of), *at(driven, "lo", "lowest", of),
        calc("shaft", "largest behind the reducer", "", "Nm", "=IF([dir]=0,0,MAX(ABS([s_hi]),ABS([s_lo])))",
             of(driven.shaft_peak), scale=driven.sizes.behind),
        result("high", "highest torque", "", "Nm",
               "=IF([dir]=0,0,MAX([dir]*[t_hi],[dir]*[t_lo]))", highs, scale=size),
        result("low", "lowest torque", "", "Nm", "=IF([dir]=0,0,MIN([dir]*[t_hi],[dir]*[t_lo]))", lows, scale=size),
        calc("top", "to compare", "", "Nm", "=IF([dir]=0,MIN([@moves.high]),[high])",
             of(lambda m: driven.torques(m)[1], min(highs)), scale=size, source="rests: the least"),
        calc("bottom", "to compare", "", "Nm", "=IF([dir]=0,MAX([@moves.low]),[low])",
             of(lambda m: driven.torques(m)[0], max(lows)), scale=size, source="rests: the greatest"),
        calc("mean", "mean of b", "⟨b⟩", "",
             "=[per]*(INDEX(law_v1,[no])-INDEX(law_v0,[no]))", of(lambda m: m.mean), scale=acc),
        calc("mean2", "mean of b²", "⟨b²⟩", "", "=([per]*INDEX(law_ca_rms,[no]))^2", of(lambda m: m.mean_square),
             scale=0.0),
        *(calc(name, words, symbol, "", picked(name), way(attribute), scale=scale)
          for name, words, symbol, attribute, scale in (
              ("sign", "resists, or drives", "", "sign", 1.0), ("a", "slope", "A", "slope", driven.sizes.slope),
              ("b", "torque at b = 0", "B", "level", size))),
        *(column for k in (1, 2) for column in (
            calc(f"y{k}", f"bend {k} at", f"y_{k}", "", picked(f"y{k}"), bent("turns", k), scale=acc),
            calc(f"s{k}", f"change of slope {k}", f"ΔA_{k}", "", picked(f"s{k}"), bent("steps", k),
                 scale=driven.sizes.slope))),
        calc("peak", "largest y", "", "", "=IF([sign]>0,0-[lo],[hi])", of(lambda m: m.against), scale=acc),
        *(calc(name, f"{words} stages", "", "",
               f"=IF([sign]>0,INDEX([shapes.{name}_down],[no]),INDEX([shapes.{name}_up],[no]))",
               [row[j] for row in rows], source="share of the time")
          for j, (name, words) in enumerate((("flat", "constant"), ("sine", "quarter sine"), ("ramp", "straight")))),
        *(column for k in (1, 2) for column in past(driven, k, of)),
        result("square", "mean of T²", "⟨T²⟩", "", SQUARE, of(lambda m: m.square), scale=0.0),
        calc("known", "its stages are known", "", "",
             "=IF([dir]=0,1,IF(" + "+".join(f"INDEX([shapes.{name}],[no])" for name in Shapes._fields) + ">0,1,0))",
             1, format="0"),
    )  # fmt: skip


def at(driven: Driven, name: str, words: str, of: Any) -> list[Quantity]:
    """Return force and torques at an extreme of the acceleration, in the direction of motion."""
    attribute = {"hi": "highest", "lo": "lowest"}[name]
    spare = driven.bends["forward"]

    def shaft(k: int) -> list[Any]:
        return list(of(lambda m: m.bends.shaft(k, getattr(m, attribute)), spare.shaft(k, 0.0)))

    torque = of(lambda m: m.bends.torque(getattr(m, attribute)), spare.torque(0.0))
    return [
        calc(f"f_{name}", f"force at the {words} b", "", "",
             f"=IF([dir]<0,@backward_r,@forward_r)+@m*[{name}]", shaft(2), scale=driven.sizes.force),
        calc(f"s_{name}", f"shaft's torque at the {words} b", "", "Nm",
             f"=IF([f_{name}]<0,@eta2,1/@eta2)*[f_{name}]/@i2+@j1*@i2*[{name}]", shaft(1), scale=driven.sizes.behind),
        calc(f"t_{name}", f"motor's torque at the {words} b", "", "Nm",
             f"=IF([s_{name}]<0,@eta1,1/@eta1)*[s_{name}]/@i1+@j0*@i*[{name}]", torque, scale=driven.sizes.torque),
    ]  # fmt: skip


def past(driven: Driven, k: int, of: Any) -> list[Quantity]:
    """Return what lies past a bend."""
    return [
        calc(f"x{k}", f"bend {k}: share of the largest y", "x", "",
             f"=IF([peak]>0,MIN(1,[y{k}]/[peak]),1)", of(lambda m: m.share(k - 1), 1.0)),
        calc(f"gap{k}", f"bend {k}: angle", "acos x", "rad",
             f"=ATAN2([x{k}],SQRT(1-[x{k}]^2))", of(lambda m: m.angle(k - 1)), scale=1.0),
        calc(f"n{k}", f"bend {k}: N1", "N1", "", N1.format(k), of(lambda m: m.past(k - 1, 1)),
             scale=driven.sizes.acceleration, source="⟨(y − y_k)+⟩"),
        calc(f"nn{k}", f"bend {k}: N2", "N2", "", N2.format(k), of(lambda m: m.past(k - 1, 2)),
             scale=0.0, source="⟨(y − y_k)+²⟩"),
    ]  # fmt: skip
