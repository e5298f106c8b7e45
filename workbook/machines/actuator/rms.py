"""The sheet RMS of an actuator: mean squares of torque and acceleration, from the laws' closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from engine.laws import Law
from engine.laws.base import Shapes
from engine.motion import Phase
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, result
from workbook.laws.library import OwnLaw
from workbook.laws.shapes import shapes_table
from workbook.laws.stack import CODES
from workbook.machines.actuator.flow import NEAR, Flow, Sized, Squares, hinge

N1 = "=[peak]*([flat]*(1-[x{0}])+[sine]*2/PI()*(SQRT(1-[x{0}]^2)-[x{0}]*[gap{0}])+[ramp]*(1-[x{0}])^2/2)+[o{0}]"
N2 = (
    "=[peak]^2*([flat]*(1-[x{0}])^2+[sine]*2/PI()*([gap{0}]*(1/2+[x{0}]^2)-3/2*[x{0}]*SQRT(1-[x{0}]^2))"
    "+[ramp]*(1-[x{0}])^3/3)+[oo{0}]"
)
OWN = (
    "=IF([no]=OWN_no,(SUMPRODUCT(([own_samples.a]*[m]>[y{0}])*([own_samples.a]*[m]-[y{0}]){1})"
    "-(MAX(0,[own_samples.a.first]*[m]-[y{0}]){1}+MAX(0,[own_samples.a.last]*[m]-[y{0}]){1})/2)/[own_samples.k.last],0)"
)


def rms_sheet(book: Book, machine: Sized, library: dict[str, Law]) -> None:
    """Declare the sheet."""
    sheet = book.sheet(
        "RMS", "Exact mean squares of torque and acceleration over the cycle, from the laws' closed forms."
    )
    sheet.heading(
        "What comes out",
        "At the shaft that the motor is coupled to, without the motor: what a selection of motor and reducer asks for.",
    )
    outcome(sheet, machine)
    sheet.heading("Workings: the phases")
    sheet.note(
        "In a phase the torque is T* = B + A b, b = |h|/t² a the acceleration in the direction of motion: ∫T*² follows from C_a,rms."
    )
    sheet.note(
        "Where the load is slowed past y_s, power flows back through stage s and the slope A changes; Δ∫ follows from N1 = ∫(y − y_s)+ and N2 = ∫(y − y_s)+²."
    )
    sheet.rows(
        constant("act_near", "A load that drives with less counts as resisting", "R_0", "N or Nm",
                 NEAR, format="0E+00", source="rounding never decides the losses"),
    )  # fmt: skip
    turns(sheet, machine)
    for name, one in machine.flows.items():
        direction(sheet, machine, name, one)
    shapes(sheet, library)
    sheet.print_columns = 18


def outcome(sheet: Sheet, machine: Sized) -> None:
    """Declare the three figures of the load, exact."""
    time = machine.sizing.motion.total
    torque, product, grown = (machine.total(name) for name in Squares._fields)
    sheet.rows(
        result("act_wrms", "RMS acceleration of the load", "ω̇_L,rms", "rad/s²",
               "=act_i*SQRT(SUM([turns.grown])/act_time)", math.sqrt(grown / time),
               scale=machine.mechanism.ratio * machine.acceleration_scale),
        result("act_lrms", "RMS torque of the load", "T*_L,rms", "Nm",
               "=SQRT(MAX(0,SUM([turns.square]))/act_time)", math.sqrt(torque / time), scale=machine.torque_scale),
        result("act_lmean", "Mean of acceleration times torque", "⟨ω̇_L T*_L⟩", "Nm rad/s²",
               "=act_i*SUM([turns.product])/act_time", product / time,
               scale=machine.torque_scale * machine.mechanism.ratio * machine.acceleration_scale),
    )  # fmt: skip


def turns(sheet: Sheet, machine: Sized) -> None:
    """Declare a row for each phase: its line, its mean squares, and at each stage what power flowing back changes."""
    n, i = machine.sizes.phases, machine.mechanism.ratio
    rows = [Row(machine, k) for k in range(n)]
    zero = Squares(0.0, 0.0, 0.0)
    sums = [*machine.squares, *[zero] * (n - len(machine.phases))]
    t = [r.time for r in rows]
    a, torque, time = machine.acceleration_scale, machine.torque_scale, machine.sizing.motion.total
    slope = torque / a
    stages: list[Quantity] = []
    for r in range(len(machine.mechanism.stages)):
        stages += stage_columns(machine, rows, r)

    def of(name: str) -> list[Any]:
        return [getattr(row, name) for row in rows]

    def pick(one: str, other: str, none: str = "0") -> str:
        return f"=IF([dir]=0,{none},IF([dir]>0,{one},{other}))"

    sheet.table(
        "turns", "Phases", n,
        constant("k", "phase", "", "", list(range(1, n + 1))),
        result("square", "∫T*² dt", "", "N²m²s",
               square_formula(machine), [s.torque for s in sums], scale=torque**2 * time,
               source="t(A²⟨b²⟩ + 2AB⟨b⟩ + B² + Σ Δ)"),
        result("product", "∫b T* dt", "", "",
               product_formula(machine), [s.product / i for s in sums], scale=torque * a * time,
               source="t(A⟨b²⟩ + B⟨b⟩ + Σ Δ)"),
        result("grown", "∫b² dt", "", "", "=[time]*[mean2]", [s.acceleration / i**2 for s in sums], scale=a**2 * time),
        calc("time", "duration", "t", "s", "=INDEX([phases.span],[k])", t, scale=time),
        calc("dir", "direction", "", "", "=INDEX([phases.dir],[k])", of("direction"), format="0"),
        calc("no", "law", "", "", "=INDEX([phases.no],[k])", of("number"), format="0"),
        calc("per", "b for a = 1", "|h|/t²", "", "=ABS(INDEX([phases.per],[k]))", of("per"), scale=a),
        calc("mean", "mean of b", "⟨b⟩", "",
             "=[per]*(INDEX(law_v1,[no])-INDEX(law_v0,[no]))", of("mean"), scale=a, source="(v(1) − v(0))|h|/t²"),
        calc("mean2", "mean of b²", "⟨b²⟩", "",
             "=([per]*INDEX(law_ca_rms,[no]))^2", of("mean2"), scale=a**2, source="(C_a,rms |h|/t²)²"),
        calc("level", "torque at b = 0", "B", "Nm",
             pick("forward_b", "backward_b", "INDEX([phases.base],[k])/act_i/act_eta"), of("level"), scale=torque),
        calc("slope", "slope", "A", "Nm/b", pick("forward_a", "backward_a"), of("slope"), scale=slope),
        calc("sign", "load resists, or drives", "", "",
             pick("forward_sign", "backward_sign", "1"), of("sign"), format="0"),
        calc("m", "y for a = 1", "", "", "=0-[sign]*[per]", of("factor"), scale=a, source="y = −sign · b"),
        calc("peak", "largest y", "", "",
             "=[per]*IF([sign]>0,0-INDEX(law_ca_min,[no]),INDEX(law_ca_max,[no]))", of("peak"), scale=a),
        *(calc(s, f"{words} stages", "", "",
               f"=IF([sign]>0,INDEX([shapes.{s}_down],[no]),INDEX([shapes.{s}_up],[no]))", of(s),
               source="share of the time")
          for s, words in (("flat", "constant"), ("sine", "quarter sine"), ("ramp", "straight"))),
        *stages,
    )  # fmt: skip


def square_formula(machine: Sized) -> str:
    """Return ∫T*² dt: of the line, and what each turn changes."""
    added = "".join(
        f"+{chosen('step', r)}*({chosen('both', r)}*[nn{r}]+2*{chosen('front', r)}*[y{r}]*[n{r}])"
        for r in range(1, len(machine.mechanism.stages) + 1)
    )
    return f"=[time]*([slope]^2*[mean2]+2*[slope]*[level]*[mean]+[level]^2{added})"


def product_formula(machine: Sized) -> str:
    """Return ∫b T* dt: of the line, and what each turn changes."""
    added = "".join(
        f"+{chosen('step', r)}*([nn{r}]+[y{r}]*[n{r}])" for r in range(1, len(machine.mechanism.stages) + 1)
    )
    return f"=[time]*([slope]*[mean2]+[level]*[mean]{added})"


def chosen(column: str, row: int) -> str:
    """Return a figure of a stage in the phase's direction."""
    return f"IF([dir]<0,[backward.{column}.{row}],[forward.{column}.{row}])"


class Row:
    """The engine's side of one row of the table of phases; a spare row is a dwell in which nothing is held."""

    def __init__(self, machine: Sized, k: int) -> None:
        move = machine.moves[k]
        self.law: Law | None = None
        self.direction, self.per = move.direction, abs(move.per)
        self.time, self.number, self.level, self.slope, self.mean, self.mean2 = 0.0, 1, 0.0, 0.0, 0.0, 0.0
        self.flow = machine.flows["backward" if move.direction < 0 else "forward"]
        self.sign = self.flow.sign if move.direction else 1.0
        self.peak = self.flat = self.sine = self.ramp = 0.0
        if k < len(machine.phases):
            self._used(machine, machine.phases[k])
        self.factor = -self.sign * self.per

    def _used(self, machine: Sized, phase: Phase) -> None:
        self.law, self.time = phase.law, phase.duration
        k, law = phase.law.coefficients, phase.law
        self.number = CODES.index(law.code) + 1
        self.mean = self.per * (law.end.v - law.start.v)
        self.mean2 = (self.per * k.ca_rms) ** 2
        self.level = machine.hold / machine.mechanism.ratio / machine.mechanism.efficiency
        if self.direction:
            self.level, self.slope = self.flow.level, self.flow.slope
        self.peak = self.per * (-k.ca_min if self.sign > 0 else k.ca_max)
        shares = law.shapes() or Shapes()
        self.flat, self.sine, self.ramp = shares.down if self.sign > 0 else shares.up

    def hinge(self, r: int, power: int) -> float:
        """Return N1 or N2 at the turn in row ``r`` of the flow."""
        return hinge(self.law, self.factor, float(self.flow.turn[r]), power) if self.law else 0.0

    def share(self, r: int) -> float:
        """Return x, the turn's y_s as a share of the largest y, and 1 where that is not reached."""
        turn = float(self.flow.turn[r])
        return turn / self.peak if self.peak > turn else 1.0


def stage_columns(machine: Sized, rows: list[Row], r: int) -> list[Quantity]:
    """Return the columns of one stage, numbered from the load's."""
    k, a = r + 1, machine.acceleration_scale
    name = f"stage {len(machine.mechanism.stages) - r}"

    def own(power: int) -> list[float]:
        return [row.hinge(r, power) if isinstance(row.law, OwnLaw) else 0.0 for row in rows]

    shares = [row.share(r) for row in rows]
    return [
        calc(f"y{k}", f"{name}: turns at", "y_s", "",
             f"={chosen('y', k)}", [float(row.flow.turn[r]) for row in rows], scale=a),
        calc(f"x{k}", f"{name}: share of the largest", "x", "", f"=IF([peak]>0,MIN(1,[y{k}]/[peak]),1)", shares),
        calc(f"gap{k}", f"{name}: angle", "acos x", "rad", f"=ATAN2([x{k}],SQRT(1-[x{k}]^2))", np.arccos(shares)),
        calc(f"o{k}", f"{name}: N1 of the own law", "", "",
             OWN.format(k, ""), own(1), scale=a, source="by trapezoids on its samples"),
        calc(f"oo{k}", f"{name}: N2 of the own law", "", "",
             OWN.format(k, "^2"), own(2), scale=a**2, source="by trapezoids on its samples"),
        calc(f"n{k}", f"{name}: N1", "N1", "",
             N1.format(k), [row.hinge(r, 1) for row in rows], scale=a, source="∫(y − y_s)+ dξ"),
        calc(f"nn{k}", f"{name}: N2", "N2", "",
             N2.format(k), [row.hinge(r, 2) for row in rows], scale=a**2, source="∫(y − y_s)+² dξ"),
    ]  # fmt: skip


def direction(sheet: Sheet, machine: Sized, name: str, one: Flow) -> None:
    """Declare one direction of motion: its line, and where and how the line bends at each stage."""
    n, torque = len(machine.mechanism.stages), machine.torque_scale
    a, force = machine.acceleration_scale, machine.force_scale
    sign = "1" if name == "forward" else "(0-1)"
    sheet.heading(f"Workings: moving {name}")
    sheet.rows(
        calc(f"{name}_r", "The load resists with", "R", "N or Nm",
             f"={sign}*act_steady+act_rubbing", one.resists, scale=force),
        calc(f"{name}_sign", "It resists (1) or drives (−1)", "", "",
             f"=IF({name}_r+act_near<0,0-1,1)", one.sign, format="0"),
        calc(f"{name}_b", "Torque at b = 0", "B", "Nm",
             f"={name}_sign*[{name}.hold.last]*[{name}.keep.last]", one.level, scale=torque,
             source="in the direction of motion"),
        calc(f"{name}_a", "Slope", "A", "Nm/b",
             f"=act_i*act_j0+[{name}.weight.last]*[{name}.keep.last]", one.slope, scale=torque / a),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        name, "Stages, from the load to the motor", n,
        constant("row", "row", "", "", list(range(1, n + 1))),
        constant("s", "stage", "s", "", list(range(n, 0, -1))),
        calc("keep", "factor before the turn", "e", "",
             f'=IF(OR(act_method="document",{name}_sign=1),1/INDEX([stages.eta],[s]),INDEX([stages.eta],[s]))',
             one.keep, source="1/η driving, η driven"),
        calc("back", "factor after it", "r", "", '=IF(act_method="document",[keep],1/[keep])', one.back),
        calc("hold", "torque at b = 0", "W", "Nm",
             f"=IF([row]=1,ABS({name}_r)/act_i,[hold-1]*[keep-1])", one.hold, scale=torque,
             source="at the motor's speed"),
        calc("weight", "torque per b", "U", "Nm/b",
             "=act_i*INDEX([stages.at_motor],[s])+IF([row]=1,0,[weight-1]*[keep-1])", one.weight, scale=torque / a),
        calc("y", "turns at", "y_s", "", "=IF([weight]>0,[hold]/[weight],0)", one.turn, scale=a, source="W/U"),
        calc("all", "factors after, from the load", "", "", "=IF([row]=1,[back],[back]*[all-1])", np.cumprod(one.back)),
        calc("first", "factors after, in front", "Π r", "", f"=[{name}.all.last]/[all]", one.first),
        calc("inertia", "slope of the shaft in front", "", "Nm/b",
             "=act_i*[first]*IF([s]=1,act_j0,INDEX([stages.at_motor],MAX([s]-1,1)))", fronts(machine, one),
             scale=torque / a),
        calc("sum", "sum so far", "", "Nm/b",
             "=IF([row]=1,[inertia],[inertia]+[sum-1])", np.cumsum(fronts(machine, one)), scale=torque / a),
        calc("front", "slope of all in front", "", "Nm/b",
             f"=[{name}.sum.last]-[sum]+[inertia]", one.front, scale=torque / a),
        calc("step", "change of slope", "ΔA", "Nm/b", "=[first]*([back]-[keep])*[weight]", one.step, scale=torque / a),
        calc("both", "slopes before and after", "ΣA", "Nm/b",
             "=2*[front]+[first]*([back]+[keep])*[weight]", one.both, scale=torque / a),
    )  # fmt: skip


def fronts(machine: Sized, one: Flow) -> list[float]:
    """Return the slope that the shaft in front of each stage adds, from the load's stage to the motor's."""
    m = machine.mechanism
    n = len(m.stages)
    shafts = [n - 1 - r for r in range(n)]
    return [m.on_shaft(k) / m.ratio_to(k) ** 2 * m.ratio * f for k, f in zip(shafts, one.first, strict=True)]


def shapes(sheet: Sheet, library: dict[str, Law]) -> None:
    """Declare for each law the shares of its time on stages of each shape."""
    sheet.heading(
        "Workings: stages of the laws", "Shares of a law's time; the own law is summed from its samples instead."
    )
    shapes_table(sheet, library)
