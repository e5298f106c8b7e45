"""The engine's view of a machine of any axes, in SI units."""

from __future__ import annotations

from collections.abc import Container
from copy import copy
from functools import cached_property, partial
from itertools import permutations
from typing import Any, Literal

import numpy as np

from engine.laws import Dwell, Law
from engine.laws.base import Array
from engine.motion import Motion, MotionValues, Phase
from engine.motion.joining import Joined, Rates, joined
from engine.motion.shifted import Shifted, Told
from engine.timing import Axis, Movement, at_rate, lane, shaft_speed, turn_time
from workbook.entries.abscissa import ANGLE, Abscissa, in_unit
from workbook.entries.abscissa import UNITS as MEASURES
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, MM, PER_MINUTE, Real, shown, si
from workbook.latest import latest
from workbook.machines.machine import chain
from workbook.machines.machine import entries as entered
from workbook.machines.machine.clearance.entries import ENDS, MOST_CLEARANCES, ClearanceEntry
from workbook.machines.machine.mechanism import MECHANISMS, some_mechanism
from workbook.machines.machine.motion.extremes import measured
from workbook.machines.machine.switches.entries import MOST_SWITCHES, SwitchEntry
from workbook.machines.machine.switches.view import Lane, named
from workbook.machines.machine.time_based import Cycle, TimedMachine
from workbook.motion.through import passed

UNITS = {"mm": MM, "°": DEGREE}
MARKS = {"mm": "mm", "°": "deg"}
BASES = {"mm": "m", "°": "rad"}
"""the unit of the motion, by that of its entries"""


class MovingAxis:
    """One axis: its motion with the rests between its phases, and where each of both stands in tables of steps.

    ``given`` has its places in degrees of one turn, ``typed`` as they are entered, ``over`` what.
    """

    twin: MovingAxis | None = None
    """an axis of the same motion at another speed, if there is one: the motion is worked out once"""

    def __init__(
        self, given: entered.Axis, number: int, library: dict[str, Law], speed: float,
        typed: entered.Axis | None = None, over: Abscissa = ANGLE,
    ) -> None:  # fmt: skip
        self.given, self.number, self.speed = given, number, speed
        self.typed, self.over = typed or given, over
        self.unit, self.base = UNITS[given.unit], BASES[given.unit]
        self.library = library

    @property
    def sized(self) -> MovingAxis:
        """The axis at the rate that its drive is sized at."""
        return self if self.given.rate is None else self.at_speed(shaft_speed(si(self.given.rate, PER_MINUTE)))

    def at_speed(self, speed: float, given: entered.Axis | None = None) -> MovingAxis:
        """Return the axis at a speed (rad/s), ``given`` with another drive: of the same motion over a turn."""
        other = copy(self)
        other.given, other.speed, other.twin = given or self.given, speed, self
        vars(other).pop("moves", None)
        return other

    @cached_property
    def rests(self) -> list[int]:
        """Before which phases the axis rests, from 0."""
        return entered.rests(self.given.phases)

    @cached_property
    def places(self) -> list[int]:
        """The row, from 0, of each step: rests stand in the first, third, fifth row, phases between them."""
        phases = range(len(self.given.phases))
        return sorted([*(i + i for i in self.rests), *(i + i + 1 for i in phases)])

    @cached_property
    def motion(self) -> Motion:
        """The motion over a turn: m, or rad, over rad; extremes of phases that meet at speed are those at points."""
        return self.twin.motion if self.twin else measured(self.joined.motion)

    @cached_property
    def passed(self) -> dict[int, Rates]:
        """What is entered for the begin of phases, by their numbers in the motion."""
        return {self.entered[i]: rates for i, rates in passed(self.given.phases).items()}

    @cached_property
    def joined(self) -> Joined:
        """The motion, with what its phases take from their neighbours: rests are among these."""
        start, phases = self._told()
        return joined(phases, self.passed, self.given.repeats, start, self.begin, shares=False)

    @property
    def begin(self) -> float:
        """Where it begins (m, or rad)."""
        return si(self.given.position, self.unit)

    def _told(self) -> tuple[float, list[Phase]]:
        """Where the motion begins (rad), and its phases and the rests between them, each between rests.

        A phase lasts what its end is later than its begin as both are entered: of places in rad that would lose digits.
        """
        phases = self.given.phases
        ends = [0.0, *(p.stop for p in phases)]
        edges: list[float] = []
        lifts: list[float] = []
        laws: list[Law] = []
        for i in range(len(phases) + 1):
            if i in self.rests:
                edges, lifts, laws = [*edges, ends[i]], [*lifts, 0.0], [*laws, Dwell()]
            if i < len(phases):
                edges, lifts = [*edges, phases[i].start], [*lifts, si(phases[i].lift, self.unit)]
                laws = [*laws, self.library[phases[i].law]]
        last = TURN if len(phases) in self.rests else ends[-1]
        spans = si(np.diff([*edges, last]), DEGREE).tolist()
        return si(edges[0], DEGREE), [Phase(*one) for one in zip(laws, lifts, spans, strict=True)]

    @cached_property
    def axis(self) -> Axis:
        """The axis of the timing diagram."""
        return Axis(self.given.name, self.motion, feed=self.given.closes != "position")

    @cached_property
    def entered(self) -> list[int]:
        """For each phase as entered, its number in the motion, from 0."""
        return [k for k, place in enumerate(self.places) if place % 2]

    @property
    def phases(self) -> list[Phase]:
        """The phases as entered."""
        return [self.motion.phases[k] for k in self.entered]

    @cached_property
    def moves(self) -> dict[int, Movement]:
        """The phases that lift, by their number as entered, from 0."""
        found = {m.phase: m for m in self.axis.movements(self.speed)}
        return {i: found[k] for i, k in enumerate(self.entered) if k in found}

    @cached_property
    def shifted(self) -> Shifted:
        """The motion as late as it is entered."""
        return Shifted(self.motion, si(self.given.shift, DEGREE))

    def told(self, at: Array) -> Told:
        """Return where samples lie in the motion as its phases tell it."""
        return self.shifted.told(at)

    def at(self, x: Array) -> MotionValues[Array]:
        """Return the motion at samples."""
        return self.shifted.over_cycle(x)

    def lane(self, x: Array, floor: int, share: float) -> Array:
        """Return the axis as the timing diagram shows it: from where a cycle of its motion begins."""
        return lane(self.motion.at(self.told(x).x).y, self.motion.reach, floor, share)

    def rate(self, size: Real) -> Real:
        """Return as it is shown a rate that is in SI of the lift."""
        return shown(size, self.over.lift(self.given.unit).size)

    def size(self, order: int) -> float:
        """Return how large a derivative grows, as it is shown."""
        return self.rate(float(at_rate(self.motion.size(order), np.array(self.speed), order)))

    @property
    def fastest(self) -> float:
        """The greatest velocity as it is shown: in m/s, or rad/s, or in lift by abscissa."""
        return self.rate(max((m.v_max for m in self.moves.values()), default=0.0))

    @property
    def hardest(self) -> float:
        """The greatest acceleration as it is shown: in m/s², or rad/s², or in lift by abscissa²."""
        return self.rate(max((m.a_max for m in self.moves.values()), default=0.0))

    @property
    def lack(self) -> float:
        """The most that a law leaves of its lift."""
        return max(abs(phase.lack) for phase in self.motion.phases)


class Whole:
    """The engine's view of a machine."""

    def __init__(self, machine: entered.AnyMachine, library: dict[str, Law]) -> None:
        self.machine, self.over = machine, machine.over
        both = zip(machine.axes_turned, machine.axes, strict=True)
        speed, over = self.speed, self.over
        moving = [
            latest("axes", (i, id(library), over, a, typed), partial(MovingAxis, a, i, library, speed, typed, over))
            for i, (a, typed) in enumerate(both, 1)
        ]  # of these very laws: cells find them by what they are, not by what they equal
        self.axes = [latest("axes at speed", (one, speed), partial(one.at_speed, speed)) for one in moving]
        each = zip(machine.switches_turned, machine.switches, strict=True)
        self.lanes = [Lane(one, i, typed) for i, (one, typed) in enumerate(each, 1)]

    @property
    def time(self) -> float:
        """Time of a turn (s)."""
        return turn_time(si(self.machine.per_minute, PER_MINUTE))

    @property
    def speed(self) -> float:
        """Speed of the master shaft (rad/s); over an abscissa that tells no time, turn of the cycle by its unit."""
        return shaft_speed(si(self.machine.per_minute, PER_MINUTE))

    @property
    def hands_over(self) -> bool:
        """Whether phases may hand velocity over: where the book has a straight line."""
        return bool(self.machine.laws.of("LIN"))

    @property
    def room(self) -> int:
        """Rows of the table of an axis' pieces."""
        return self.machine.sizes.motion_pieces or 0

    @cached_property
    def angles(self) -> Array:
        """The sampled angles of the master shaft in degrees."""
        return np.linspace(0.0, TURN, self.machine.sizes.cycle + 1)

    @cached_property
    def samples(self) -> Array:
        """The same in rad."""
        return si(self.angles, DEGREE)

    @property
    def times(self) -> Array:
        """The sampled angles as they are shown."""
        return self.over.shown(self.angles)

    @property
    def near(self) -> float:
        """How near to the begin of a phase counts as on it, in degrees."""
        return shown(self.axes[0].motion.tolerance, DEGREE)


def unit_name(number: int, unit: str) -> str:
    """Return the name of the cell that says in which unit an axis is entered: by it a file tells that."""
    return f"axis{number}_{MARKS[unit]}"


def laid_out(machine: entered.AnyMachine, names: Container[str]) -> entered.AnyMachine:
    """Return a machine with the axes that a file has by its defined names: its book has the file's inputs."""
    axes = []
    for i in range(1, entered.MOST_AXES + 1):
        units = [unit for unit in UNITS if unit_name(i, unit) in names]
        kinds = [kind for kind in MECHANISMS if kind_name(i, kind) in names]
        if units:
            drive = driven_by(kinds[0]) if kinds else {"mechanism": None, "motor": None}
            viscous = 0.0 if viscous_name(i) in names else None
            arm = chain.SwingingArm() if arm_name(i) in names else None
            load = LEAST.model_copy(update={"viscous": viscous, "arm": arm})
            own = {"unit": units[0], "load": load, "parts": [], "rate": None, "printed": printed_in(i, names)}
            axes.append(machine.axes[0].model_copy(update=own | drive))
    told = [SwitchEntry(name=name, on=[]) for name in switch_names(names)]
    found: dict[str, Any] = {"axes": axes or machine.axes, "switches": told, "clearances": clearances(names)}
    chosen = machine.axes[0].name if CHOSEN in names else None
    falling = any(fall_name(i) in names for i in range(1, entered.MOST_AXES + 1))
    found["selection"] = machine.selection.model_copy(update={"axis": chosen, "falling": falling})
    told_in = [unit for unit in MEASURES if in_unit(unit) in names]
    if told_in:
        known = {name: getattr(machine, name) for name in type(machine).model_fields}
        return TimedMachine.model_construct(**known | found | {"master": Cycle(cycle=TURN, unit=told_in[0])})
    return machine.model_copy(update=found)


CHOSEN = "sel_axis"
"""the name of the cell that says which axis the sheet Selection looks at: by it a file tells that it has one"""


def clearances(names: Container[str]) -> list[ClearanceEntry]:
    """Return the clearances that a file has by its defined names, of axes by their numbers."""
    numbers = range(1, entered.MOST_AXES + 1)
    return [
        ClearanceEntry.model_construct(name=f"Clearance {k}", first=str(one), second=str(other))
        for k in range(1, MOST_CLEARANCES + 1)
        for one, other in permutations(numbers, 2)
        if clearance_name(k, one, other) in names
    ]


def clearance_name(number: int, first: int, second: int) -> str:
    """Return the name of the cell of a clearance: by it a file tells which axes it is of."""
    return f"clear{number}_{first}_{second}"


def switch_names(names: Container[str]) -> list[str]:
    """Return the names of the cells that tell what each switch of a file is called."""
    return [name for name in map(named, range(1, MOST_SWITCHES + 1)) if name in names]


LEAST = chain.AxisLoad()


def driven_by(kind: str) -> dict[str, Any]:
    """Return the entries of some drive with a mechanism."""
    motor = chain.AxisMotor(inertia=1.0, rated_torque=1.0, peak_torque=1.0, max_speed=1.0)
    return {"mechanism": some_mechanism(kind), "motor": motor}


def kind_name(number: int, kind: str) -> str:
    """Return the name of the cell that says which mechanism an axis has: by it a file tells that."""
    return f"drive{number}_{kind.replace(' ', '_').replace('-', '_')}"


def printed_in(number: int, names: Container[str]) -> Literal["S4"] | None:
    """Return which document's figures a file has beside those of an axis, by its defined names."""
    return "S4" if f"drive{number}_printed" in names else None


def viscous_name(number: int) -> str:
    """Return the name of the cell of an axis' viscous friction: by it a file tells that it has one."""
    return f"drive{number}_viscous"


def arm_name(number: int) -> str:
    """Return the name of the cell of an arm's mass: by it a file tells that an axis has one."""
    return f"drive{number}_arm_mass"


def fall_name(number: int) -> str:
    """Return the name of the cell of the fall of a motor's peak torque: by it a file tells that its drives know one."""
    return f"drive{number}_fall"


def fixed(machine: entered.AnyMachine) -> dict[str, Any]:
    """Return the entries that a book's layout tells, and no cell to enter; and tables whose cells may all be empty."""
    master = {"cycle": None, "unit": machine.over.unit} if machine.over.measured else {}
    found: dict[str, Any] = {"master": master} | {f"axes.{i}.unit": axis.unit for i, axis in enumerate(machine.axes)}
    found |= {f"switches.{i}.on": [] for i in range(len(machine.switches))}
    for i, one in enumerate(machine.clearances):
        found |= {f"clearances.{i}.{end}": int(getattr(one, end)) for end in ENDS}
    for i, axis in enumerate(machine.axes):
        if axis.mechanism:
            found |= {f"axes.{i}.mechanism.kind": axis.mechanism.kind, f"axes.{i}.motor": {}, f"axes.{i}.reducer": {}}
    found |= {f"axes.{i}.printed": axis.printed for i, axis in enumerate(machine.axes) if axis.printed}
    found["selection.falling"] = machine.selection.falling
    found |= {f"axes.{i}.load.arm": {} for i, axis in enumerate(machine.axes) if axis.load.arm}
    viscous = (i for i, axis in enumerate(machine.axes) if axis.load.viscous is not None)
    return found | {f"axes.{i}.load.viscous": 0.0 for i in viscous}
