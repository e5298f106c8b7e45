"""The Timing sheet: three axes over one turn of the master shaft, their movements, diagram and checks."""

from __future__ import annotations

from typing import Any

import numpy as np

from engine import timing as engine_timing
from engine.motion import Motion
from engine.timing import Movement, shaft_speed
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.entries.machine import Sizes
from workbook.entries.units import DEGREE, MM, shown
from workbook.laws import phases as joined_phases
from workbook.laws import sampling
from workbook.laws.phases import ACCELERATION, AT_END, LAW_NUMBER, RMS, VELOCITY
from workbook.machines.cutting.entries import Axis
from workbook.machines.cutting.view import Cutting

S1 = "S1, slide 'Timing diagram for a cutting machine'"
LANE_SHARE = 0.8
CLOSE = 1e-9  # relative: what a check takes for zero


def timing_sheet(book: Book, machine: Cutting, pieces: sampling.Pieces) -> None:
    """Declare the sheet: what to enter at the top, the diagram beside it, the table over the cycle below."""
    timing, sizes = machine.machine.timing, machine.machine.sizes
    sheet = book.sheet("Timing", "Three axes over one turn of the master shaft: phases, movements, timing diagram.")
    sheet.heading("What to enter")
    sheet.rows(
        given("timing_rate", "Production rate", "n", "pieces/min",
              timing.rate, "timing.rate", format="0.0##", source="one piece a turn of the master shaft"),
        calc("timing_cycle", "Time of one turn", "t_c", "s", "=60/timing_rate", 1 / machine.rate, source="60 / n"),
        calc("timing_omega", "Speed of the master shaft", "ω", "rad/s",
             "=2*PI()*timing_rate/60", shaft_speed(machine.rate), source="2π n / 60"),
        calc("timing_eps", "Tolerance of an angle", "ε", "°",
             "=360*break_tolerance", shown(machine.axes[0].motion.tolerance, DEGREE), format="0E+00",
             source="an angle this near to a phase's begin counts as on it"),
        constant("timing_lane", "Height of an axis in the diagram", "", "",
                 LANE_SHARE, format="0.0", source="as a share of its lane"),
    )  # fmt: skip
    axes_table(sheet, machine)
    draw_diagram(sheet, timing.axes)
    sheet.row = max(sheet.row, 26)
    for i, axis in enumerate(timing.axes, 1):
        phases(sheet, machine, i, axis, sizes)
    draw_curves(sheet, timing.axes)
    sheet.heading("Table over the cycle")
    cycle(sheet, machine, pieces)
    sheet.print_columns = 17


def movements(machine: Cutting, i: int) -> list[Movement]:
    """Return the engine's movements of axis ``i``, by phase."""
    name = machine.machine.timing.axes[i - 1].name
    return [m for m in machine.diagram.movements(machine.rate) if m.axis == name]


def axes_table(sheet: Sheet, machine: Cutting) -> None:
    """Declare the names of the axes and what each comes to."""
    axes = machine.machine.timing.axes
    best = [movements(machine, i) for i in (1, 2, 3)]
    positions = [a.motion.at(np.deg2rad(machine.angles)).y / MM for a in machine.axes]
    lows, highs = [float(y.min()) for y in positions], [float(y.max()) for y in positions]
    sheet.row += 1
    sheet.table(
        "axes", "Axes", 3,
        given("group", "group", "", "", [a.group for a in axes], "timing.axes.*.group"),
        given("name", "axis", "", "", [a.name for a in axes], "timing.axes.*.name"),
        given("closes", "closes in", "", "",
              [a.closes for a in axes], "timing.axes.*.closes", source="a feed does not come back"),
        calc("travel", "travel a cycle", "Σh", "mm", [f"=SUM([axis{i}.lift])" for i in (1, 2, 3)],
             [sum(p.lift for p in a.phases) for a in axes]),
        calc("low", "lowest position", "", "mm", [f"=MIN([cycle.y{i}])" for i in (1, 2, 3)], lows),
        calc("high", "highest position", "", "mm", [f"=MAX([cycle.y{i}])" for i in (1, 2, 3)], highs),
        result("v", "greatest velocity", "ẏ_max", "m/s",
               [f"=MAX([axis{i}.v])" for i in (1, 2, 3)], [max((m.v_max for m in b), default=0.0) for b in best]),
        result("a", "greatest acceleration", "ÿ_max", "m/s²",
               [f"=MAX([axis{i}.a])" for i in (1, 2, 3)], [max((m.a_max for m in b), default=0.0) for b in best]),
    )  # fmt: skip


def phases(sheet: Sheet, machine: Cutting, i: int, axis: Axis, sizes: Sizes) -> None:
    """Declare the phases of one axis: what is entered, what each movement comes to, how the phases join."""
    n, used = sizes.phases, len(axis.phases)
    motion = machine.axes[i - 1].motion
    moves = {m.phase: m for m in movements(machine, i)}
    pad = [None] * (n - used)

    def entered(name: str) -> list[Any]:
        return [getattr(p, name) for p in axis.phases] + pad

    def of(name: str) -> list[float]:
        return [getattr(moves[k], name) if k in moves else 0.0 for k in range(n)]

    laws = [p.law for p in axis.phases]
    lifts = np.array([p.lift * MM for p in axis.phases] + [0.0] * len(pad))
    spans = np.array([*np.diff(motion.edges), *[0.0] * len(pad)])
    kinds = joined_phases.kinds(laws, [p.lift for p in axis.phases], n)
    ends = phase_ends(motion, n)
    key = f"timing.axes.{i - 1}.phases.*"
    sheet.heading(f"Axis {i}: {axis.name}, {axis.group}")
    sheet.table(
        f"axis{i}", "Phases: fill one row each, in order; leave spare rows empty", n,
        calc("kind", "phase", "", "", joined_phases.kind("stop"), kinds),
        given("start", "from", "", "°", entered("start"), f"{key}.start", format="0.0##"),
        given("stop", "to", "", "°", entered("stop"), f"{key}.stop", format="0.0##"),
        given("lift", "lift", "h", "mm", entered("lift"), f"{key}.lift", format="0.0##"),
        given("law", "law", "", "", entered("law"), f"{key}.law", choices="=law_code"),
        result("y1", "geometric velocity", "y'max", "m/rad", VELOCITY, of("y1_max"), source="C_v h/δ"),
        result("y2", "geometric acceleration", "y''max", "m/rad²", ACCELERATION, of("y2_max"), source="C_a h/δ²"),
        result("v", "velocity", "ẏmax", "m/s", "=[y1]*timing_omega", of("v_max"), source="y' ω"),
        result("a", "acceleration", "ÿmax", "m/s²", "=[y2]*timing_omega^2", of("a_max"), source="y'' ω²"),
        result("rms", "RMS acceleration", "ÿrms", "m/s²",
               f"={RMS}*timing_omega^2", of("a_rms"), source="C_a,rms h/δ² ω²"),
        constant("k", "row", "k", "", list(range(1, n + 1))),
        calc("no", "law number", "", "", LAW_NUMBER, joined_phases.law_numbers(laws, n), format="0"),
        calc("h", "lift", "h", "m", "=[lift]/1000", lifts, source="conversion"),
        calc("span", "duration", "δ", "rad", '=IF([stop]="",0,RADIANS([stop]-[start]))', spans, source="conversion"),
        calc("begin", "begins at", "", "°",
             '=IF([stop]="",360,[start])', [p.start for p in axis.phases] + [360.0] * len(pad), format="0.0##"),
        calc("y0", "position at begin", "y_0", "m",
             "=IF([k]=1,0,[y0-1]+[h-1])", np.concatenate([[0.0], np.cumsum(lifts)[:-1]]), source="lifts before"),
        calc("gap", "gap before", "", "°", '=IF([stop]="",0,[start]-IF([k]=1,0,[stop-1]))', [0.0] * n, scale=360.0),
        calc("v0", "y' at begin", "", "m/rad", AT_END.format("v0", ""), ends["v0"]),
        calc("v1", "y' at end", "", "m/rad", CARRIED.format("v1", ""), ends["v1"], source="carried over spare rows"),
        calc("a0", "y'' at begin", "", "m/rad²", AT_END.format("a0", "^2"), ends["a0"]),
        calc("a1", "y'' at end", "", "m/rad²",
             CARRIED.format("a1", "^2"), ends["a1"], source="carried over spare rows"),
        calc("jump_y", "jump of y", "Δy", "m",
             "=[h]*(1-INDEX(law_s1,[no]))", ends["jump_y"], source="at its end: the law's lack"),
        calc("jump_v", "jump of y'", "Δy'", "m/rad",
             f"=IF([span]>0,[v0]-IF([k]=1,[axis{i}.v1.last],[v1-1]),0)", ends["jump_v"], source="at its begin"),
        calc("jump_a", "jump of y''", "Δy''", "m/rad²",
             f"=IF([span]>0,[a0]-IF([k]=1,[axis{i}.a1.last],[a1-1]),0)", ends["jump_a"], source="reported, no fault"),
    )  # fmt: skip
    joined(sheet, i, axis, ends)


CARRIED = "=IF([span]>0,INDEX(law_{0},[no])*[h]/[span]{1},IF([k]=1,0,[{0}-1]))"


def phase_ends(motion: Motion, n: int) -> dict[str, list[float]]:
    """Return the engine's values at the ends of each phase and its jumps, with the spare rows filled up."""
    rows: dict[str, list[float]] = {name: [] for name in ("v0", "v1", "a0", "a1", "jump_y", "jump_v", "jump_a")}
    junctions = {j.after: j for j in motion.junctions()}
    for k, phase in enumerate(motion.phases):
        per_v, per_a = phase.lift / phase.duration, phase.lift / phase.duration**2
        values = (phase.law.start.v * per_v, phase.law.end.v * per_v, phase.law.start.a * per_a, phase.law.end.a * per_a,
                  phase.lift * (1 - phase.law.end.s), junctions[k].jump_v, junctions[k].jump_a)  # fmt: skip
        for name, value in zip(rows, values, strict=True):
            rows[name].append(value)
    for name, values_so_far in rows.items():
        carried = values_so_far[-1] if name in ("v1", "a1") else 0.0
        values_so_far += [carried] * (n - len(values_so_far))
    return rows


def joined(sheet: Sheet, i: int, axis: Axis, ends: dict[str, list[float]]) -> None:
    """Declare the checks of one axis."""
    t = f"axis{i}"
    y1 = f"MAX([{t}.y1])"
    largest = max(abs(x) for x in ends["jump_v"])
    rests = largest <= CLOSE * max(abs(x) for x in (*ends["v0"], *ends["v1"], 1.0))
    lift = max(abs(p.lift) for p in axis.phases) * MM
    sheet.checks(
        check(f"{t}_forward", f"{axis.name}: every phase runs forward", f'COUNTIF([{t}.span],">0")=COUNT([{t}.stop])',
              True),
        check(f"{t}_follows", f"{axis.name}: the phases follow on", f"MAX(MAX([{t}.gap]),-MIN([{t}.gap]))<check_zero",
              True),
        check(f"{t}_fills", f"{axis.name}: the phases fill the cycle", f"ABS(MAX([{t}.stop])-360)<check_zero", True),
        check(f"{t}_position", f"{axis.name}: no jump of position", f"MAX(MAX([{t}.jump_y]),-MIN([{t}.jump_y]))<=check_zero*MAX(MAX([{t}.h]),-MIN([{t}.h]))",
              max(abs(x) for x in ends["jump_y"]) <= CLOSE * lift),
        check(f"{t}_velocity", f"{axis.name}: no jump of velocity",
              f"MAX(MAX([{t}.jump_v]),-MIN([{t}.jump_v]))<=check_zero*(1+{y1})", rests),
        check(f"{t}_closes", f"{axis.name}: the cycle closes", f'OR(INDEX([axes.closes],{i})="feed",ABS(INDEX([axes.travel],{i}))<check_zero)',
              axis.closes == "feed" or abs(sum(p.lift for p in axis.phases)) < CLOSE, "in position, or, as a feed, in velocity"),
    )  # fmt: skip


def cycle(sheet: Sheet, machine: Cutting, pieces: sampling.Pieces) -> None:
    """Declare the table over the cycle: results of the three axes, then the workings of each."""
    theta, speed = machine.angles, shaft_speed(machine.rate)
    results: list[Quantity] = []
    lanes: list[Quantity] = []
    workings: list[Quantity] = []
    for i, axis in enumerate(machine.axes, 1):
        at, name = axis.motion.at(np.deg2rad(theta)), axis.name
        y = at.y / MM
        results += [
            result(f"y{i}", f"{name} position", "y", "mm",
                   f"=(INDEX([axis{i}.y0],[p{i}])+INDEX([axis{i}.h],[p{i}])*[s{i}])*1000", y, source="y_0 + h s"),
            result(f"g{i}", f"{name} geometric velocity", "y'", "m/rad",
                   f"=INDEX([axis{i}.h],[p{i}])/INDEX([axis{i}.span],[p{i}])*[v{i}]", at.y1, source="h v/δ"),
            result(f"gg{i}", f"{name} geometric acceleration", "y''", "m/rad²",
                   f"=INDEX([axis{i}.h],[p{i}])/INDEX([axis{i}.span],[p{i}])^2*[a{i}]", at.y2, source="h a/δ²"),
            result(f"t{i}", f"{name} velocity", "ẏ", "m/s", f"=[g{i}]*timing_omega", at.y1 * speed, source="y' ω"),
            result(f"tt{i}", f"{name} acceleration", "ÿ", "m/s²",
                   f"=[gg{i}]*timing_omega^2", at.y2 * speed**2, source="y'' ω²"),
        ]  # fmt: skip
        lanes.append(calc(f"lane{i}", f"{name} in the diagram", "", "", LANE.format(i, 3 - i), lane(y, 3 - i)))
        workings += located(i, axis, theta, pieces)
    sheet.table(
        "cycle", "Position, velocity, acceleration of the three axes over the master angle", len(theta),
        calc("theta", "master angle", "θ", "°", "=[k]*360/[cycle.k.last]", theta, format="0.0##"),
        *results, *lanes,
        constant("k", "sample", "k", "", list(range(len(theta)))),
        *workings,
    )  # fmt: skip


LANE = "={1}+IF([axes.high.{0}]>[axes.low.{0}],timing_lane*([y{0}]-[axes.low.{0}])/([axes.high.{0}]-[axes.low.{0}]),0)"


def lane(y: np.ndarray, floor: int) -> np.ndarray:
    """Return the axis as the timing diagram shows it: its travel as a share of its own lane."""
    travel = y.max() - y.min()
    return floor + LANE_SHARE * (y - y.min()) / travel if travel > 0 else np.full(len(y), float(floor))


def located(i: int, axis: engine_timing.Axis, theta: np.ndarray, pieces: sampling.Pieces) -> list[Quantity]:
    """Return the workings of one axis: phase, ξ, law, piece, and the law's s, v, a."""
    t = f"axis{i}"
    phase = f"=MATCH(MIN([theta]+timing_eps,360-timing_eps),[{t}.begin],1)"
    span = f"(INDEX([{t}.stop],[p{i}])-INDEX([{t}.start],[p{i}]))"
    xi = f"=MAX(0,([theta]-INDEX([{t}.start],[p{i}]))/{span})"
    number = f"=INDEX([{t}.no],[p{i}])"
    names = ("last begin not above θ", "(θ − from)/δ")
    return joined_phases.located(
        axis.motion, np.deg2rad(theta), pieces, (phase, xi, number), names, f"{axis.name} ", str(i)
    )


def draw_diagram(sheet: Sheet, axes: list[Axis]) -> None:
    """Place the timing diagram: one lane an axis over the master angle."""
    names = " · ".join(a.name for a in reversed(axes))
    chart = Chart(
        "Timing diagram", "master angle θ [°]", f"{names} (bottom to top)",
        tuple(Series(f"{a.name} {a.group}", "[cycle.theta]", f"[cycle.lane{i}]") for i, a in enumerate(axes, 1)),
        f"Timing diagram: rises, dwells and returns of {names} over one turn of the master shaft",
        (0, 360, 30), (0, 3, 1), hide_y=True,
    )  # fmt: skip
    sheet.chart(chart, column=10, row=5, width=8, height=21)


def draw_curves(sheet: Sheet, axes: list[Axis]) -> None:
    """Place the charts of y, y', y'' of the three axes."""
    sheet.heading("Position, geometric velocity and acceleration over the cycle")
    kinds = (
        ("y", "y [mm]", "Position"),
        ("g", "y' [m/rad]", "Geometric velocity"),
        ("gg", "y'' [m/rad²]", "Geometric acceleration"),
    )
    sheet.chart_row(
        *(Chart(title, "master angle θ [°]", label,
                tuple(Series(a.name, "[cycle.theta]", f"[cycle.{column}{i}]") for i, a in enumerate(axes, 1)),
                f"{title} of the three axes over the master angle", (0, 360, 60))
          for column, label, title in kinds),
        width=6, height=18,
    )  # fmt: skip
