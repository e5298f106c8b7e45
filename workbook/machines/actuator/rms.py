"""The sheet RMS of an actuator: mean squares of torque and acceleration, from the laws' closed forms."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from engine.drivetrain.flow import Flow
from engine.drivetrain.squares import BentPhase
from engine.laws import Law
from engine.laws.base import Shapes
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.drive.losses import drives, loss_factor
from workbook.laws.library import NamedLaw
from workbook.laws.shapes import shapes_table
from workbook.machines.actuator.view import Sized

N1 = "=[peak]*([flat]*(1-[x{0}])+[sine]*2/PI()*(SQRT(1-[x{0}]^2)-[x{0}]*[gap{0}])+[ramp]*(1-[x{0}])^2/2)+[o{0}]"
N2 = (
    "=[peak]^2*([flat]*(1-[x{0}])^2+[sine]*2/PI()*([gap{0}]*(1/2+[x{0}]^2)-3/2*[x{0}]*SQRT(1-[x{0}]^2))"
    "+[ramp]*(1-[x{0}])^3/3)+[oo{0}]"
)
SAMPLED = (
    "IF([no]={law}_no,(SUMPRODUCT(([{law}_samples.a]*[m]>[y{k}])*([{law}_samples.a]*[m]-[y{k}]){power})"
    "-(MAX(0,[{law}_samples.a.first]*[m]-[y{k}]){power}+MAX(0,[{law}_samples.a.last]*[m]-[y{k}]){power})/2)"
    "/[{law}_samples.k.last],0)"
)


PHASE = (
    "In a phase the torque is T* = B + A b, b = |h|/t² a the acceleration in the direction of motion: "
    "∫T*² follows from C_a,rms."
)
TURNS = (
    "Where the load is slowed past y_s, power flows back through stage s and the slope A changes; "
    "Δ∫ follows from N1 = ∫(y − y_s)+ and N2 = ∫(y − y_s)+²."
)
SHAPES = (("flat", "constant"), ("sine", "quarter sine"), ("ramp", "straight"))


def rms_sheet(book: Book, machine: Sized, laws: Sequence[NamedLaw]) -> None:
    """Declare the sheet."""
    sheet = book.sheet(
        "RMS", "Exact mean squares of torque and acceleration over the cycle, from the laws' closed forms."
    )
    with sheet.scoped("act_"):
        sheet.heading(
            "Results",
            "At the shaft that the motor is coupled to, without the motor: "
            "what a selection of motor and reducer asks for.",
        )
        outcome(sheet, machine)
        sheet.heading("Workings: the phases")
        sheet.note(PHASE)
        sheet.note(TURNS)
        turns(sheet, machine, [one for one in laws if one.page.shapes is None])
        for name, one in machine.flows.items():
            direction(sheet, machine, name, one)
        shapes(sheet, laws)
    sheet.print_columns = 18


def outcome(sheet: Sheet, machine: Sized) -> None:
    """Declare the three figures of the load, exact."""
    asked, sides = machine.squares, machine.sides
    sheet.rows(
        result("@wrms", "RMS acceleration of the load", "ω̇_L,rms", "rad/s²",
               "=@i*SQRT(SUM([turns.grown])/@time)", asked.acceleration, scale=sides.motor_acceleration),
        result("@lrms", "RMS torque of the load", "T*_L,rms", "Nm",
               "=SQRT(MAX(0,SUM([turns.square]))/@time)", asked.torque, scale=sides.torque),
        result("@lmean", "Mean of acceleration times torque", "⟨ω̇_L T*_L⟩", "Nm rad/s²",
               "=@i*SUM([turns.product])/@time", asked.product, scale=sides.product),
    )  # fmt: skip


def turns(sheet: Sheet, machine: Sized, sampled: Sequence[NamedLaw]) -> None:
    """Declare a row for each phase: its line, its mean squares, and at each stage what power flowing back changes."""
    n, sides = machine.sizes.phases, machine.sides
    a = sides.acceleration

    def of(figure: Callable[[BentPhase], float], spare: float = 0.0) -> list[float]:
        return filled([figure(phase) for phase in machine.bent], n, spare)

    def pick(one: str, other: str, none: str = "0") -> str:
        return f"=IF([dir]=0,{none},IF([dir]>0,{one},{other}))"

    numbers = filled(machine.numbers, n, 1)
    sheet.table(
        "turns", "Phases", n,
        constant("k", "phase", "", "", list(range(1, n + 1))),
        result("square", "∫T*² dt", "", "N²m²s",
               square_formula(machine), of(lambda p: p.torque_square), scale=sides.torque_square,
               source="t(A²⟨b²⟩ + 2AB⟨b⟩ + B² + Σ Δ)"),
        result("product", "∫b T* dt", "", "",
               product_formula(machine), of(lambda p: p.load_product), scale=sides.load_product,
               source="t(A⟨b²⟩ + B⟨b⟩ + Σ Δ)"),
        result("grown", "∫b² dt", "", "", "=[time]*[mean2]", of(lambda p: p.load_square),
               scale=sides.acceleration_square),
        calc("time", "duration", "t", "s",
             "=INDEX([phases.span],[k])", filled([p.duration for p in machine.phases], n), scale=sides.time),
        calc("dir", "direction", "", "",
             "=INDEX([phases.dir],[k])", machine.of_moves(lambda move: move.direction), format="0"),
        calc("no", "law", "", "", "=INDEX([phases.no],[k])", numbers, format="0"),
        calc("per", "b for a = 1", "|h|/t²", "", "=ABS(INDEX([phases.per],[k]))", of(lambda p: p.per), scale=a),
        calc("mean", "mean of b", "⟨b⟩", "",
             "=[per]*(INDEX(law_v1,[no])-INDEX(law_v0,[no]))", of(lambda p: p.mean),
             scale=a, source="(v(1) − v(0))|h|/t²"),
        calc("mean2", "mean of b²", "⟨b²⟩", "",
             "=([per]*INDEX(law_ca_rms,[no]))^2", machine.of_moves(lambda move: move.mean_square),
             scale=sides.mean_square, source="(C_a,rms |h|/t²)²"),
        calc("level", "torque at b = 0", "B", "Nm",
             pick("@forward_b", "@backward_b", "INDEX([phases.base],[k])/@i/@eta"), of(lambda p: p.level),
             scale=sides.torque),
        calc("slope", "slope", "A", "Nm/b",
             pick("@forward_a", "@backward_a"), of(lambda p: p.slope), scale=sides.slope),
        calc("sign", "load resists, or drives", "", "",
             pick("@forward_sign", "@backward_sign", "1"), of(lambda p: p.sign, 1.0), format="0"),
        calc("m", "y for a = 1", "", "", "=0-[sign]*[per]", of(lambda p: p.factor), scale=a, source="y = −sign · b"),
        calc("peak", "largest y", "", "",
             "=[per]*IF([sign]>0,0-INDEX(law_ca_min,[no]),INDEX(law_ca_max,[no]))", of(lambda p: p.peak), scale=a),
        *shares(machine),
        *(column for stage in range(machine.mechanism.last) for column in stage_columns(machine, stage, sampled)),
        blank='INDEX(phase_times,[k])=""',
    )  # fmt: skip


def shares(machine: Sized) -> list[Quantity]:
    """Return the columns of the shares of time that a law brakes (or accelerates, where the load drives), by shape."""
    rows = [shape(p.phase.law, p.sign) for p in machine.bent]
    return [
        calc(s, f"{words} stages", "", "",
             f"=IF([sign]>0,INDEX([shapes.{s}_down],[no]),INDEX([shapes.{s}_up],[no]))",
             filled([row[j] for row in rows], machine.sizes.phases), source="share of the time")
        for j, (s, words) in enumerate(SHAPES)
    ]  # fmt: skip


def square_formula(machine: Sized) -> str:
    """Return ∫T*² dt: of the line, and what each turn changes."""
    added = "".join(
        f"+{chosen('step', r)}*({chosen('both', r)}*[nn{r}]+2*{chosen('front', r)}*[y{r}]*[n{r}])"
        for r in range(1, machine.mechanism.last + 1)
    )
    return f"=[time]*([slope]^2*[mean2]+2*[slope]*[level]*[mean]+[level]^2{added})"


def product_formula(machine: Sized) -> str:
    """Return ∫b T* dt: of the line, and what each turn changes."""
    added = "".join(f"+{chosen('step', r)}*([nn{r}]+[y{r}]*[n{r}])" for r in range(1, machine.mechanism.last + 1))
    return f"=[time]*([slope]*[mean2]+[level]*[mean]{added})"


def chosen(column: str, row: int) -> str:
    """Return a figure of a stage in the phase's direction."""
    return f"IF([dir]<0,[@backward.{column}.{row}],[@forward.{column}.{row}])"


def stage_columns(machine: Sized, stage: int, laws: Sequence[NamedLaw]) -> list[Quantity]:
    """Return the columns of one stage, numbered from the load's; a spare row turns as one that moves forward."""
    k, n, a = stage + 1, machine.sizes.phases, machine.sides.acceleration
    name, spare = f"stage {machine.mechanism.last - stage}", float(machine.flows["forward"].turn[stage])

    def integrals(power: int) -> list[float]:
        return filled([p.hinge(stage, power) for p in machine.bent], n)

    def summed(power: str) -> str:
        return f"={'+'.join(SAMPLED.format(law=one.slug, k=k, power=power) for one in laws)}"

    def sampled(power: int) -> list[float]:
        return filled([p.hinge(stage, power) if p.intervals is not None else 0.0 for p in machine.bent], n)

    return [
        calc(f"y{k}", f"{name}: turns at", "y_s", "",
             f"={chosen('y', k)}", filled([float(p.flow.turn[stage]) for p in machine.bent], n, spare), scale=a),
        calc(f"x{k}", f"{name}: share of the largest", "x", "",
             f"=IF([peak]>0,MIN(1,[y{k}]/[peak]),1)", filled([float(p.shares[stage]) for p in machine.bent], n, 1.0)),
        calc(f"gap{k}", f"{name}: angle", "acos x", "rad",
             f"=ATAN2([x{k}],SQRT(1-[x{k}]^2))", filled([float(p.angles[stage]) for p in machine.bent], n)),
        calc(f"o{k}", f"{name}: N1 of laws of other shapes", "", "",
             summed(""), sampled(1), scale=a, source="by trapezoids on its samples"),
        calc(f"oo{k}", f"{name}: N2 of laws of other shapes", "", "",
             summed("^2"), sampled(2), scale=machine.sides.mean_square, source="by trapezoids on its samples"),
        calc(f"n{k}", f"{name}: N1", "N1", "", N1.format(k), integrals(1), scale=a, source="∫(y − y_s)+ dξ"),
        calc(f"nn{k}", f"{name}: N2", "N2", "",
             N2.format(k), integrals(2), scale=machine.sides.mean_square, source="∫(y − y_s)+² dξ"),
    ]  # fmt: skip


def direction(sheet: Sheet, machine: Sized, name: str, one: Flow) -> None:
    """Declare one direction of motion: its line, and where and how the line bends at each stage."""
    n, sides = machine.mechanism.last, machine.sides
    a, slope, torque = sides.acceleration, sides.slope, sides.torque
    sign = "1" if name == "forward" else "(0-1)"
    sheet.heading(f"Workings: moving {name}")
    sheet.rows(
        calc(f"@{name}_r", "The load resists with", "R", "N or Nm",
             f"={sign}*@steady+@rubbing", one.resists, scale=sides.force),
        calc(f"@{name}_sign", "It resists (1) or drives (−1)", "", "",
             f"=IF({drives(f'@{name}_r', '1')},0-1,1)", one.sign, format="0"),
        calc(f"@{name}_b", "Torque at b = 0", "B", "Nm",
             f"=@{name}_sign*[@{name}.hold.last]*[@{name}.keep.last]", one.level, scale=torque,
             source="in the direction of motion"),
        calc(f"@{name}_a", "Slope", "A", "Nm/b",
             f"=@i*@j0+[@{name}.weight.last]*[@{name}.keep.last]", one.slope, scale=slope),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        f"@{name}", "Stages, from the load to the motor", n,
        constant("row", "row", "", "", list(range(1, n + 1))),
        constant("s", "stage", "s", "", list(range(n, 0, -1))),
        calc("keep", "factor before the turn", "e", "",
             f"={loss_factor(f'@{name}_r', '1', 'INDEX([@stages.eta],[s])', '@method')}",
             one.keep, source="1/η driving, η driven"),
        calc("back", "factor after it", "r", "", '=IF(@method="document",[keep],1/[keep])', one.back),
        calc("hold", "torque at b = 0", "W", "Nm",
             f"=IF([row]=1,ABS(@{name}_r)/@i,[hold-1]*[keep-1])", one.hold, scale=torque,
             source="at the motor's speed"),
        calc("weight", "torque per b", "U", "Nm/b",
             "=@i*INDEX([@stages.at_motor],[s])+IF([row]=1,0,[weight-1]*[keep-1])", one.weight, scale=slope),
        calc("y", "turns at", "y_s", "", "=IF([weight]>0,[hold]/[weight],0)", one.turn, scale=a, source="W/U"),
        calc("all", "factors after, from the load", "", "", "=IF([row]=1,[back],[back]*[all-1])", one.past),
        calc("first", "factors after, in front", "Π r", "", f"=[@{name}.all.last]/[all]", one.first),
        calc("inertia", "slope of the shaft in front", "", "Nm/b",
             "=@i*[first]*IF([s]=1,@j0,INDEX([@stages.at_motor],MAX([s]-1,1)))", one.own, scale=slope),
        calc("sum", "sum so far", "", "Nm/b", "=IF([row]=1,[inertia],[inertia]+[sum-1])", one.run, scale=slope),
        calc("front", "slope of all in front", "", "Nm/b",
             f"=[@{name}.sum.last]-[sum]+[inertia]", one.front, scale=slope),
        calc("step", "change of slope", "ΔA", "Nm/b", "=[first]*([back]-[keep])*[weight]", one.step, scale=slope),
        calc("both", "slopes before and after", "ΣA", "Nm/b",
             "=2*[front]+[first]*([back]+[keep])*[weight]", one.both, scale=slope),
    )  # fmt: skip


def shape(law: Law, sign: float) -> list[float]:
    """Return the shares of time on stages of each shape on the side of a where power turns round."""
    found = law.shapes() or Shapes()
    return list(found.down if sign > 0.0 else found.up)


def shapes(sheet: Sheet, laws: Sequence[NamedLaw]) -> None:
    """Declare for each law the shares of its time on stages of each shape."""
    sheet.heading(
        "Workings: stages of the laws",
        "Shares of a law's time; laws of other shapes are summed from their samples instead.",
    )
    shapes_table(sheet, laws)
