"""The engine's view of the drive of an axis."""

from dataclasses import replace
from functools import cached_property
from math import radians
from typing import TypeVar

from engine.drive import KINDS, Load, Mechanism, Part, Slide, Stage, cylinder
from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Brake, Drivetrain, Window
from engine.drive.limits import LimitChecks
from engine.drive.mechanisms import by_angle
from engine.drive.mechanisms.by_angle import Arm, ByAngle
from engine.drive.mechanisms.slides import crank_slider, rocker
from engine.drive.mechanisms.variable_ratio import Linkage, PositionTable
from engine.drive.motor import LEVEL
from engine.motion.pieces import MotionPieces
from workbook.fields.units import DEGREE, KG_CM2, MM, MS, shown, si
from workbook.machines.machine import mechanism as kinds
from workbook.machines.machine.drive.in_use import falling_of, left_of, motor_in_use, reducer_in_use
from workbook.machines.machine.drive_entries import AxisPart
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.view import MovingAxis

T = TypeVar("T")
SHAFTS = ("motor", "mechanism")
FALLS = "point {} at {} °, {} {} is not beyond the one before it, at {} °, {} {}"


def changing_ratio(given: kinds.MechanismEntry, unit: float) -> Linkage | ByAngle:
    """Return the entered mechanism of an axis in a unit, if its ratio changes or its slide follows the angle.

    Raises ValueError for sizes that cannot be.
    """

    def mm(*sizes: float | None) -> tuple[float, ...]:
        return tuple(si(size or 0.0, MM) for size in sizes)

    match given:
        case kinds.Table():
            return PositionTable([(si(point.angle, DEGREE), si(point.position, unit)) for point in given.points])
        case kinds.Rocker():
            angle = si(given.start_angle or 0.0, DEGREE)
            sense = -1 if given.direction == "backward" else 1
            lever, link, offset = mm(given.lever_length, given.link_length, given.offset)
            return rocker(lever, link, offset, angle, given.slide != "behind", sense)
        case kinds.CrankSlider():
            crank, rod, offset, start = mm(given.crank_radius, given.rod_length, given.offset, given.start)
            return crank_slider(crank, rod, offset, given.zero or "inner", given.branch or "ahead", start)
        case kinds.PressCrank():
            crank, rod, offset = mm(given.crank_radius, given.rod_length, given.offset)
            return by_angle.PressCrank(crank, rod, offset, si(given.start_angle or 0.0, DEGREE))
    raise TypeError(f"the ratio of a {given.kind} does not change")


def turning(part: AxisPart, mechanism: int = 1) -> Part:
    """Return a rotating part by the number of the mechanism's shaft: of the inertia entered, or of a cylinder's."""
    diameter, length, bore = (si(x or 0.0, MM) for x in (part.diameter, part.length, part.bore))
    own = cylinder(diameter, length, part.density or 0.0, bore) if part.inertia is None else si(part.inertia, KG_CM2)
    geared = part.teeth_driver / part.teeth_driven if part.teeth_driver and part.teeth_driven else 1.0
    return Part(part.name, own, mechanism * SHAFTS.index(part.shaft), part.count, geared)


def of_kind(kind: type[T], what: object) -> T:
    """Return a mechanism, as it is entered or the engine's, as of its kind; raise TypeError for one of another."""
    if not isinstance(what, kind):
        raise TypeError(f"{what} is no {kind.__name__}")
    return what


class Driven:
    """An axis with its drive; ``left`` is the share of its rated torque that the motor has at its temperature.

    Of the mechanism there is a ``linkage`` where its ratio depends on the position, and ``by_angle`` what a load does
    by the angle of its axis: a slide on a crank, an arm's weight. Inertias in kg m².
    """

    def __init__(self, axis: MovingAxis, machine: AnyMachine) -> None:
        entered, products = axis.given, machine.selection
        if entered.mechanism is None or entered.motor is None:
            raise ValueError(f"{entered.name} has no drive")
        self.axis, self.entered, self.number = axis.sized, entered, axis.number
        self.products = products
        self.called = f"Drive {entered.called}"
        self.given, self.entered_motor, load = entered.mechanism, entered.motor, entered.load
        self.holding = entered.motor.holding
        limits = self.limits = machine.limits.of_axis(entered.limits)
        self.catalogued_falling = falling_of(entered.motor.name, products, limits.peak_reserve)
        self.motor_used = motor_in_use(entered, products, limits)
        self.reducer = reducer_in_use(entered, products, limits)
        falling = self.catalogued_falling if products.knows_falling else LEVEL
        self.motor = replace(self.motor_used.motor, falling=falling)
        self.left = left_of(entered.motor)

        changing = changing_ratio(self.given, self.axis.unit) if self.given.LARGE else None
        self.linkage = changing if isinstance(changing, Linkage) else None
        self.by_angle = changing if isinstance(changing, ByAngle) else None
        if arm := load.arm:
            self.by_angle = Arm(arm.mass * machine.gravity * si(arm.radius, MM), si(arm.angle, DEGREE))
        # the load: with its axis, or as a slide
        self.travels = entered.unit == "mm" or self.given.SLIDES
        bed = self.given.belt_on_bed if isinstance(self.given, kinds.Belted) else None
        self.has_bed = bed is not None  # for a part of its belt to lie on
        slide = Slide(load.mass, load.friction, radians(load.slope), load.force, machine.gravity, bed or 0.0).load
        turns = Load(si(load.inertia, KG_CM2), load.torque, load.friction_torque)
        self.load = slide if self.travels else turns
        self.parts = [turning(part, 1 + len(entered.stages)) for part in entered.parts]
        self.windows = tuple(Window(si(w.start, DEGREE), si(w.stop, DEGREE), w.force, w.resists) for w in load.windows)

        self.mechanism = self._mechanism()
        # of parts, without the reducer's
        self.beside_motor = self.mechanism.on_shaft(0) - self.reducer.inertia
        self.at_motor = self.motor_used.inertia + self.mechanism.on_shaft(0)
        brake = entered.motor.brake  # holds any torque, in any dwell, where no figures are entered
        self.brake = Brake(brake.torque, si(brake.closing + brake.opening, MS)) if brake else Brake()
        used = self.motor_used.inertia, self.given.method, self.holding, self.reducer.no_load_torque
        acting = self.linkage, load.viscous or 0.0, self.windows, self.by_angle
        self.train = Drivetrain(self.mechanism, *used, self.motor_used.copper, self.brake, *acting)

    @property
    def back_efficiency(self) -> float:
        """Efficiency of the mechanism where the load drives it, if none is entered: of a screw 2 − 1/η.

        Source: G. Niemann, Maschinenelemente I, screws: the friction torque is the same both ways.
        """
        entered, forward = self.given.back_efficiency, self.given.efficiency
        if entered is not None:
            return entered
        return 2.0 - 1.0 / forward if self.given.kind in kinds.SCREWS else forward

    def _mechanism(self) -> Mechanism:
        """Return reducer, stages, mechanism, parts and load; a screw by its turns a metre, all else by a size."""
        gears = [Stage("reducer", self.reducer.ratio, self.reducer.efficiency)]
        kind, size = self.given.kind, si(self.given.size, MM)
        turned = [Part("reducer", self.reducer.inertia, 0), *self.parts]
        for k, stage in enumerate(self.entered.stages, 1):
            both = stage.driver_inertia, stage.driven_inertia
            turned += [Part(f"stage {k}", si(inertia, KG_CM2), shaft) for shaft, inertia in enumerate(both, k)]
            losses = stage.efficiency, stage.back_efficiency, stage.friction_torque
            gears.append(Stage(f"stage {k}", stage.reduction, *losses))
        size = shown(1.0, size) if kind in kinds.SCREWS else size
        belt = self.given.belt_mass or 0.0 if isinstance(self.given, kinds.Belted) else 0.0
        made = KINDS[kind].of(self.load, size, self.given.efficiency, gears, turned, belt)
        *before, last = made.stages
        return replace(made, stages=(*before, replace(last, back_efficiency=self.back_efficiency)))

    @cached_property
    def drive_cycle(self) -> DriveCycle:
        """The drive over the motion of its axis, at the rate that it is sized at."""
        motion = MotionPieces.of(self.axis.motion)
        return DriveCycle(self.train, motion, self.axis.speed, self.axis.shifted.shift)

    @cached_property
    def limit_checks(self) -> LimitChecks:
        """The drive and its limits, exact."""
        return LimitChecks(self.drive_cycle, self.motor, self.reducer.limits)

    @property
    def max_geometric_velocity(self) -> float:
        """The greatest geometric velocity (m or rad, per rad)."""
        return max(phase.y1_max for phase in self.axis.motion.phases)
