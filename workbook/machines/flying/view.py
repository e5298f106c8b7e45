"""The engine's view of flying machining and of the drive of its shaft, and what only it can say of the entries."""

import math
from collections.abc import Iterator
from functools import cached_property

import numpy as np

from engine.drive import Load
from engine.drive.drive_points import DrivePoints
from engine.drive.limits import BELOW, LimitChecks, ReducerLimits
from engine.drive.motor import LimitCheck, Motor, TorqueFall, reserve
from engine.flying.cut import LONGER, SAME_LENGTH, Beyond, Cut, Tool, flying_saw, rotary_drum
from engine.flying.pieces import Stretch, cycle_of, train_of
from engine.laws import Dwell, Law
from engine.laws.base import Array
from engine.laws.inverse import is_monotone, velocity_extremes
from engine.laws.points import fastest
from engine.motion import Phase
from engine.selection.point_load import PointLoad
from engine.selection.task import Task
from workbook.book.cell_tables import formulas_by_row
from workbook.book.rows import filled
from workbook.book.sentence import figure
from workbook.fields.texts import place_of
from workbook.fields.types import END_TOLERANCE, DesignError
from workbook.fields.units import DEGREE, KG_CM2, MM, MM_PER_TURN, PER_HOUR, PER_MINUTE, RPM, shown, si
from workbook.law_sheets.library import laws
from workbook.laws.registry import RISING
from workbook.machines.flying.entries import DRUM, CutterEntry, FlyingCutter
from workbook.selection.entries import Limits, Selection, SelectionSizes
from workbook.selection.pair_selection import NO_LIMIT, Figure, PairSelection, Shaft, load_figures, shaft_figures

REST = 1e-9  # dimensionless velocity at which a law is at rest
LEAST_CV = 1.001  # below, no product is too long to keep moving
LOOKS = 4  # at each turn: from anywhere in a piece, the fourth is exact
LEAST = 1e-3  # Nm, W, rad/s²: what is smaller is next to nothing


def tool_of(given: CutterEntry) -> Tool:
    """Return the engine's tool."""
    if given.kind == DRUM:
        drum = given.drum
        return rotary_drum(int(drum.tools), si(drum.radius, MM), si(drum.tool_angle, DEGREE))
    return flying_saw(si(given.saw.tool_length, MM), si(given.saw.lead, MM_PER_TURN))


class CutterView:
    """The engine's view: tool and load, the cut entered, its cycle, and cuts of other lengths."""

    def __init__(self, machine: FlyingCutter, library: dict[str, Law]) -> None:
        self.given, self.sizes, self.library = machine.cutter, machine.sizes, library
        self.tool, self.law = tool_of(self.given), library[self.given.law]
        self.number = machine.laws.number(self.given.law)
        self.is_drum = self.given.kind == DRUM
        self.line = si(self.given.line_speed, PER_MINUTE)
        load, lengths = self.given.load, self.given.lengths
        # J_L = J + m R_t²
        self.load = Load(si(load.inertia, KG_CM2) + load.mass * self.tool.radius**2, load.torque)
        self.peak = fastest(self.law)
        self.cut = self.of(self.given.product_length)
        self.room = self.sizes.pieces_of(1)  # rows of the table of the motion's pieces
        self.times = np.linspace(0.0, self.cut.cycle_time, self.sizes.cycle + 1)  # s
        # compared, in mm
        self.lengths = np.linspace(lengths.shortest, lengths.longest, self.sizes.lengths + 1)
        # L_p,lim; a saw always reverses
        self.limit = shown(self.cut.limit_length, MM) if self.is_drum else 0.0

    @property
    def case(self) -> int:
        """The row of the case by product length: 1 below L_0, 2 as long, 3 longer, 4 too long to keep moving."""
        if self.cut.displacement >= 0.0:
            return 1 if self.cut.displacement else 2
        return 4 if self.cut.speed_range[0] <= SAME_LENGTH * self.line else 3

    @property
    def fastest_line(self) -> float:
        """The highest line speed at which its shaft is within its limits (m/min)."""
        limits = self.given.limits
        return shown(self.cut.fastest_line(si(limits.speed, RPM), limits.acceleration), PER_MINUTE)

    def of(self, length: float, beyond: Beyond | None = None) -> Cut:
        """Return the cut of a product length in mm, whose drum waits where the cells find the law fastest."""
        return Cut(self.tool, si(length, MM), self.line, self.law, beyond or self.given.beyond, self.peak)

    def task(self, cut: Cut) -> Task:
        """Return the demands of a cut on the drive at the tool's shaft, exact by the law's coefficients."""
        rest = cut.cycle_time - cut.moving_time
        rests = [Phase(Dwell(), 0.0, rest)] if rest > 0.0 else []
        return Task.of_load(self.load, [Phase(self.law, cut.superimposed / self.tool.radius, cut.moving_time), *rests])

    @property
    def scales(self) -> dict[str, float]:
        """The size of figures by unit, from the line speed over a length, β = J_L (v²/(L R_t))²."""
        length, radius = max(self.tool.design_length, self.cut.product_length), self.tool.radius
        turning = self.line**2 / length / radius
        return {
            "s": self.cut.cycle_time,
            "m": length,
            "mm": shown(length, MM),
            "m/s": self.line,
            "m/s²": self.line**2 / length,
            "m/s³": self.cut.size(3),
            "°": shown(length / radius, DEGREE),
            "rpm": shown(self.line / radius, RPM),
            "rad/s": self.line / radius,
            "rad/s²": turning,
            "Nm": math.hypot(self.load.inertia * turning, self.load.torque),
            "W/s": self.load.inertia * turning**2,
        }


class ToolDrive:
    """The tool's shaft behind a motor and its reducer: those that are named, else the proposed ones. SI units.

    ``unpaired`` are the figures of the shaft before a pair is chosen.
    """

    def __init__(self, machine: CutterView, chosen: Selection, reserves: Limits, sizes: SelectionSizes) -> None:
        self.machine, self.chosen, self.reserves, self.sizes = machine, chosen, reserves, sizes
        cut, load, scales = machine.cut, machine.load, machine.scales
        bare = cycle_of(cut, train_of(cut, load)).points()
        self.demand = PointLoad(bare, cut.max_angular_speed, float(np.abs(bare.output_torque).max()), load.inertia)
        # the scale of torques of the shaft
        self.torque = max(self.demand.torque, scales["Nm"], LEAST)
        hardest = float(np.abs(bare.shaft_acceleration).max())
        self.turning = max(hardest, scales["rad/s²"])  # the scale of its accelerations
        self.unpaired = (
            dict(reserves)
            | {"most_mass": reserves.largest_mass or NO_LIMIT}
            | {"beside": 0.0, "left": 1.0, "cycles": shown(1.0 / cut.cycle_time, PER_HOUR)}
        )
        bare_shaft = [Figure(name, "", "", "", value) for name, value in self.unpaired.items()]
        self.proposal = PairSelection(chosen, sizes, [self._shaft(bare_shaft)])

        ranked, motors = self.proposal.ranked, self.proposal.motors
        reducers = self.proposal.reducers
        # the first of all where no pair can do it
        m, r = ranked[self.proposal.proposed or 0] if ranked else (0, 0)
        m = place_of(chosen.motor, motors.names) if chosen.motor else m
        # in use, by places from 0
        self.pair = m, place_of(chosen.reducer, reducers.names) if chosen.reducer else r
        self.gears = self.proposal.grid.pair(*self.pair)  # J_M + J_T, i, η and no-load torque
        of = motors.inertia, motors.rated_torque, motors.peak_torque, motors.max_speed, motors.stall, motors.falls_to
        falling = TorqueFall(*(float(row[self.pair[0]]) for row in (motors.knee, motors.fall / reserves.peak_reserve)))
        inertia, rated, peak, fastest, stall, to = (float(figures[self.pair[0]]) for figures in of)
        self.motor = Motor(
            inertia,
            rated / reserves.rms_reserve,
            peak / reserves.peak_reserve,
            fastest / reserves.speed_reserve,
            stall / reserves.rms_reserve,
            to,
            falling=falling,
        )
        limits = reducers.max_input_speed, self.proposal.grid.most_output_torque, reducers.max_mean_torque
        fastest, strongest, lasting = (float(limit[self.pair[1]]) for limit in limits)
        # 0: none
        self.limits = [0.0 if np.isinf(limit) else limit for limit in (fastest, strongest, lasting)]
        self.reducer = ReducerLimits(strongest / reserves.torque_factor, lasting, fastest)

        self.cycle = cycle_of(cut, train_of(cut, load, self.gears))
        self.load = self.cycle.points()
        self.points = DrivePoints(self.load)
        self.speed = self.gears.ratio * cut.max_angular_speed  # the largest of the motor
        # of the motor: no torque is larger between the points
        self.peak = float(np.abs(self.points.torque).max())
        # the scale of its torques
        self.motor_torque = max(self.peak, self.torque / self.gears.ratio, LEAST)
        self.left = self.points.reserve(self.motor)
        self.reserve = reserve(self.motor, self.points.rms_torque, self.peak, self.speed, self.points.mean_speed)
        task, (inertia, ratio, efficiency, _) = self.proposal.grid.task, self.gears
        best = ratio * float(task.best_ratio(inertia, efficiency))
        # τ/τ_opt; 0 of a load that does not move: S5, (18), step 7
        self.balance = 1.0 / best if task.moves else 0.0
        self.stroke = float(np.ptp(self.load.position))

    @cached_property
    def exact(self) -> LimitChecks:
        """The drive and its limits, exact."""
        return LimitChecks(self.cycle.drive_cycle, self.motor, self.reducer)

    @property
    def results(self) -> dict[str, float]:
        """The results of its sheet, by their names, in SI units."""
        points, asked = self.points, self.demand
        return {
            "RMS torque": points.rms_torque,
            "highest torque": float(points.torque.max()),
            "lowest torque": float(points.torque.min()),
            "speed": self.speed,
            "mean speed": points.mean_speed,
            "peak torque behind the reducer": asked.torque,
            "mean torque behind the reducer": asked.mean_torque,
        }

    @property
    def limit_checks(self) -> dict[str, LimitCheck]:
        """The quantities at the points against each limit, by its name in the engine (Nm, rad/s)."""
        torque, left, reducer = np.abs(self.points.torque).ravel(), self.left.ravel(), self.reducer
        k = int(left.argmin())
        rms, peak, speed = self.reserve
        return {
            "RMS torque": rms,
            "peak torque": peak,
            "motor speed": speed,
            BELOW: LimitCheck(BELOW, float(torque[k]), float(torque[k] + left[k])),
            "reducer peak torque": LimitCheck("peak torque", self.demand.torque, reducer.peak_torque),
            "reducer mean torque": LimitCheck("mean torque", self.demand.mean_torque, reducer.mean_torque),
            "reducer input speed": LimitCheck("input speed", self.speed, reducer.input_speed),
        }

    def looks(self, stretch: Stretch) -> Iterator[tuple[float, ...]]:
        """Yield looks at a stretch: its middle, u in its piece, v, a and j there, and when the tool turns by them."""
        piece, middle = self.cycle.pieces[stretch.piece], (stretch.begin + stretch.end) / 2.0
        at = middle
        for _ in range(LOOKS):
            u = at - piece.origin
            v, a, j = (curve(u) for curve in piece.curves[1:])
            if self.cycle.turns:
                at += -2.0 * v / (a + stretch.after * math.sqrt(max(0.0, a**2 - 2.0 * j * v)))
            yield middle, u, v, a, j, at

    @property
    def inertia_ratio(self) -> float:
        """The inertia at the motor over the motor's own."""
        beside, own = self.gears.inertia - self.motor.inertia, self.motor.inertia
        return (beside + self.demand.inertia / self.gears.ratio**2) / own

    def by_point(self, values: Array, spare: float | None = None) -> list[float]:
        """Return values of the points; spare rows have that of the last, or another."""
        flat = values.ravel()
        return filled(flat, self.machine.room * values.shape[-1], float(flat[-1]) if spare is None else spare)

    def _shaft(self, figures: list[Figure]) -> Shaft:
        return Shaft(
            "shaft",
            1,
            '="shaft"',
            "tool",
            self.machine.room,
            self.demand,
            "ABS({})*30/PI()",
            self.turning,
            self.torque,
            figures,
        )

    def choosing(self) -> PairSelection:
        """Return the choice of motor and reducer, with the pair in use."""
        motor, gears, reserves, (m, r) = self.motor, self.gears, self.reserves, self.pair
        rows = formulas_by_row(__file__, "as Selection reads it")
        formulas = dict(zip(rows["figure"], rows["reads"], strict=True))
        values = {
            **load_figures(self.demand, self.turning, self.torque),
            **self.unpaired,
            "brake": 0.0,
            "by_power": 1.0,
            "held_j": gears.inertia,
            "held_jm": motor.inertia,
            "held_i": gears.ratio,
            "held_eta": gears.efficiency,
            "held_no_load": gears.no_load,
            "held_row": m + 1,
            "held_gear": r + 1,
            "held_hub": self.proposal.built(m, r)["@reducer_hub"] or NO_LIMIT,
            "held_room": (reserves.largest_mass or NO_LIMIT) - self.proposal.built(m, r)["@reducer_kg"],
            "turns": 1.0,
        }
        figures = shaft_figures("drive_", formulas, values)
        return PairSelection(self.chosen, self.sizes, [self._shaft(figures)])


def does(cut: Cut) -> str:
    """Return in words how the tool re-positions."""
    if cut.waits:
        return "waits"
    return "reverses" if cut.reverses else "keeps moving"


def check(machine: FlyingCutter) -> None:
    """Raise DesignError for a law that does not speed up once, or for products that leave no time to re-position."""
    cutter, law = machine.cutter, laws(machine.laws)[machine.cutter.law]
    speeds = law.v(velocity_extremes(law))
    top, falls = int(np.argmax(speeds)), np.diff(speeds)
    rests = max(abs(law.start.v), abs(law.end.v)) <= REST and abs(law.end.s - 1) <= END_TOLERANCE
    once = min(falls[:top].min(initial=0.0), -falls[top:].max(initial=0.0)) >= -REST
    if not (is_monotone(law) and rests and once and law.coefficients.cv >= LEAST_CV):
        problem = f"expected to speed up once, then to slow down; the law {cutter.law} does not: see its sheet, or Laws"
        raise DesignError("cutter.law", problem, RISING[0])
    least = shown(LONGER * tool_of(cutter).tool_length, MM)
    for entry, length in (("product_length", cutter.product_length), ("lengths.shortest", cutter.lengths.shortest)):
        if length < least:
            problem = f"a product of {figure(length)} mm; expected at least {figure(least)} mm"
            raise DesignError(f"cutter.{entry}", problem, least + least)
