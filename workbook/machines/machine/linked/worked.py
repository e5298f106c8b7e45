"""A drive over its motion, place by place: stretches, where power turns round in them, sections."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from engine.laws.base import Array
from engine.machine.bent import going, middle, stretches
from engine.machine.brackets import Bracket
from engine.machine.falling import line_asked
from engine.machine.interpolated import Interpolated
from engine.machine.place_pace import PlacePace, loads_of
from engine.machine.places import (
    LONG,
    LOOKS,
    NODES,
    Held,
    Polynomial,
    Sums,
    Top,
    Worked,
    carried,
    half,
    largest,
    level,
    lost,
    section,
    suffices,
    sums,
)
from engine.machine.sharing import Running
from workbook.book.rows import filled
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, shown, si
from workbook.machines.machine.linked.driven import PlacedDriven
from workbook.machines.machine.linked.turn import Turn, tried
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.stretched import Paced, Stretched

FIGURES = ("force", "behind", "torque")
"""what power changes its way with: at the load, in the reducer, in the motor"""
LINE = "C"
"""column of what the line of a falling curve must be at no speed"""
RATES = {"w": "rate", "g": "first", "P": "power"}
SPARE_TURNS = 8
EACH = len(LOOKS)
"""places at which a stretch is looked at"""


class PlacedWork(Stretched):
    """Such a drive over the stretches of its axis' motion."""

    driven: PlacedDriven
    varies = False
    """whether its ratio depends on the position"""
    too_few = "power turns round too often for the places of this sheet"
    """what is said where these do not suffice"""

    def __init__(self, one: AxisRows, driven: PlacedDriven) -> None:
        super().__init__(one, driven)

    @property
    def base(self) -> str:
        """The unit of positions."""
        return self.driven.axis.base

    @property
    def force(self) -> str:
        """The unit of forces at the load."""
        return "N" if self.driven.travels else "Nm"

    def number_of(self, held: Held) -> int:
        """Return the number of a stretch's piece, from 1."""
        return self.piece_at(shown(held.piece.begin, DEGREE) + self.near) + 1

    @property
    def rows(self) -> int:
        """Rows of the table of stretches."""
        return len(range(super().rows - self.one.machine.machine.sizes.phases))

    @property
    def points(self) -> int:
        """Places at which a torque can be largest: the nodes of each section."""
        return len([node for _ in range(self.section_rows) for node in NODES])

    @property
    def turn_rows(self) -> int:
        """Rows of the table of where power turns round."""
        n = self.one.machine.machine.sizes.phases
        return n + n + n + SPARE_TURNS

    @property
    def section_rows(self) -> int:
        """Rows of the table of sections."""
        return self.rows + self.turn_rows

    @property
    def further(self) -> list[tuple[float, str]]:
        """In the middle of a piece that is long beside its phase: so that few nodes suffice."""
        i, axis, found = self.driven.number, self.driven.axis, []
        phases = dict(zip(axis.places, axis.motion.phases, strict=True))
        halves = [shown(half(piece, phases[piece.phase]), DEGREE) for piece in self.pieces]
        for r, angle in enumerate(filled(halves, self.room, 0.0), 1):
            begin, d, p = (f"[axis{i}_pieces.{name}.{r}]" for name in ("begin", "d", "p"))
            span, h = (f"INDEX([axis{i}_steps.{name}],{p})" for name in ("span", "h"))
            found.append((angle or TURN, f"=IF({d}*ABS({h})>{LONG!r}*{span}*ABS({h}),{begin}+DEGREES({d})/2,360)"))
        return [*super().further, *found]

    def held(self, at: float) -> Held:
        """Return the stretch in which an angle of the motion lies."""
        axis, piece = self.driven.axis, self.pieces[self.piece_at(at)]
        u = si(at, DEGREE) - piece.begin
        train, way = self.driven.train, going(piece, u, self.driven.fastest)
        force = train.force(way, si(at, DEGREE) + axis.shifted.shift, axis.motion.total)
        within = float(piece.derivative(0, np.array([u]))[0]) + self.further_in
        return Held(train, piece, axis.speed, way, force, within)

    @cached_property
    def helds(self) -> list[Held]:
        """The stretches; spare rows repeat the last."""
        found = [self.held(middle(span)) for span in self.spans]
        return filled(found, self.rows, found[-1])

    @property
    def ways(self) -> list[float]:
        """The direction of each stretch."""
        return [held.going for held in self.helds]

    @property
    def ranges(self) -> list[tuple[float, float]]:
        """Begin and end of each stretch, from the begin of its piece (rad)."""
        spans = filled(self.spans, self.rows, self.spans[-1])
        return [self.within(held, span) for held, span in zip(self.helds, spans, strict=True)]

    @property
    def further_in(self) -> float:
        """By how much a stretch's position counts as farther than it is."""
        return 0.0

    def within(self, held: Held, span: tuple[float, float]) -> tuple[float, float]:
        """Return begin and end of a span in degrees from the begin of its piece (rad)."""
        low, high = (si(angle, DEGREE) - held.piece.begin for angle in span)
        return low, high

    @cached_property
    def looks(self) -> list[Worked]:
        """The drive at the places of each stretch."""
        each = zip(self.helds, self.ranges, strict=True)
        return [held.at(section(span, LOOKS)) for held, span in each]

    def look(self, name: str) -> Array:
        """Return a figure at all places, stretch by stretch."""
        return np.concatenate([getattr(one, name) for one in self.looks])

    @cached_property
    def sizes(self) -> dict[str, float]:
        """How large each figure grows at these places."""
        return {name: largest(self.look(name)) for name in FIGURES}

    def lost(self, name: str) -> float:
        """Return what has no sign of a figure."""
        return lost(self.sizes[name])

    @property
    def counts(self) -> tuple[bool, bool, bool]:
        """Whether each figure turns round by itself: not without anything that turns before it."""
        return True, self.driven.mechanism.on_shaft(1) > 0.0, self.driven.at_motor > 0.0

    @cached_property
    def signs(self) -> dict[str, list[list[float]]]:
        """The sign of each figure, stretch by stretch; none of those that do not count."""
        found: dict[str, list[list[float]]] = {}
        for name, counts in zip(FIGURES, self.counts, strict=True):
            found[name] = []
            for used, one in zip(self.used, self.looks, strict=True):
                kept = used and counts
                values = getattr(one, name)
                found[name].append(carried(values, lost(self.sizes[name]) if kept else np.inf))
        return found

    def changes(self, name: str) -> list[int]:
        """Return how often a figure has changed its sign up to each place."""
        count, found = 0, []
        for signs in self.signs[name]:
            for before, sign in zip([0.0, *signs], signs, strict=False):
                count += before + sign == 0.0 and before != 0.0
                found.append(count)
        return found

    @cached_property
    def turns(self) -> list[Turn]:
        """Where power turns round; spare rows look at the first two places."""
        found: list[Turn] = []
        for number, name in enumerate(FIGURES, 1):
            changes = self.changes(name)
            for row, (before, count) in enumerate(zip([0, *changes], changes, strict=False), 1):
                if count > before:
                    found.append(self._turn(number, row, found))
        return filled(found, self.turn_rows, self._turn(0, 2, []))

    @property
    def turned_round(self) -> int:
        """How often power turns round."""
        return sum(self.changes(name)[-1] for name in FIGURES)

    def _turn(self, number: int, row: int, before: list[Turn]) -> Turn:
        stretch, name = (row - 1) // EACH, FIGURES[max(number, 1) - 1]
        held, k = self.helds[stretch], (row - 1) % EACH
        u, values = section(self.ranges[stretch], LOOKS), getattr(self.looks[stretch], name)
        low, high, at_low, at_high = (float(one[n]) for one in (u, values) for n in (k - 1, k))
        bracket, beside, at_kink = Bracket(low, high, at_low, at_high, self.lost(name)), 0.0, 0.0
        kink = next((n for n, one in enumerate(before, 1) if one.row == row), 0)
        if kink:
            beside, at_kink = before[kink - 1].tried.step3.place, float(getattr(before[kink - 1].tried.third, name)[0])
            bracket = bracket.beside(beside, at_kink)
        found = tried(held, name, bracket, bracket.rise if number else 0)
        angle = shown(held.piece.begin + found.step4.place, DEGREE) if number else TURN
        return Turn(number, row, stretch + 1, kink, beside, at_kink, bracket, found, angle)

    @cached_property
    def sections(self) -> list[tuple[float, float]]:
        """Begin and end of each section, in degrees."""
        return stretches([*(low for low, _ in self.spans), *(turn.angle for turn in self.turns)], TURN, self.near)

    @cached_property
    def parents(self) -> list[int]:
        """The stretch of each section, from 1; of the last one its last row."""
        begins = np.array([low for low, _ in self.spans])
        each = np.searchsorted(begins, [middle(span) for span in self.sections], side="right").tolist()
        return [self.rows if number == len(begins) else int(number) for number in each]

    @property
    def parent_rows(self) -> list[int]:
        """The same of all rows of the table."""
        return filled(self.parents, self.section_rows, self.parents[-1])

    @cached_property
    def placed(self) -> list[tuple[Held, tuple[float, float]]]:
        """The stretch of each section, and its begin and end in degrees; spare rows repeat the last."""
        found = [(self.helds[number - 1], span) for number, span in zip(self.parents, self.sections, strict=True)]
        return filled(found, self.section_rows, found[-1])

    @cached_property
    def worked(self) -> list[Worked]:
        """The drive at the nodes of each section."""
        return [held.at(section(self.within(held, span), NODES, -1.0)) for held, span in self.placed]

    @cached_property
    def sums(self) -> list[Sums]:
        """The integrals of each section; 0 in spare rows."""
        each = zip(self.placed, self.worked, self.sections, strict=False)
        found = [sums(held, worked, self.within(held, span)) for (held, _), worked, span in each]
        return filled(found, self.section_rows, Sums(0.0, 0.0, 0.0, 0.0, 0.0))

    @cached_property
    def interpolated(self) -> list[Interpolated]:
        """The power of each section."""
        each = zip(self.placed, self.worked, self.sections, strict=False)
        return [Interpolated.of(held, worked, *(si(end, DEGREE) for end in span)) for (held, _), worked, span in each]

    @property
    def running(self) -> Running:
        """Its power on a common DC bus."""
        return Running(self.interpolated, self.sections, self.driven.axis.given.shift)

    @property
    def jump_rows(self) -> int:
        """Rows of the table of where its power may jump."""
        return self.section_rows

    @property
    def offs(self) -> list[float]:
        """By how much straight lines between the places of the sheet Power are off at most in each section (W)."""
        step, efficiency = si(self.step, DEGREE), self.one.machine.machine.power.efficiency
        return [one.off(step, efficiency) for one in self.interpolated]

    @cached_property
    def most_off(self) -> float:
        """The largest of these (W)."""
        return max(self.offs)

    @cached_property
    def sampled(self) -> list[int]:
        """The stretch of each sample of the cycle, from 1; of the last one its last row."""
        told = shown(self.driven.axis.told(self.one.machine.samples).x, DEGREE)
        begins = np.array([low for low, _ in self.spans])
        reached = np.minimum(told + self.near, TURN - self.near)
        each = np.searchsorted(begins, reached, side="right").tolist()
        return [self.rows if number == len(begins) else int(number) for number in each]

    @cached_property
    def samples(self) -> list[Worked]:
        """The drive at each sample of the cycle."""
        told = self.driven.axis.told(self.one.machine.samples).x.tolist()
        helds = [self.helds[number - 1] for number in self.sampled]
        return [held.at(np.array([x - held.piece.begin])) for held, x in zip(helds, told, strict=True)]

    def at_nodes(self, name: str) -> Array:
        """Return a figure at all nodes, section by section."""
        return np.concatenate([getattr(one, name) for one in self.worked])

    def least(self, name: str) -> float:
        """Return what is next to nothing of a figure at nodes."""
        return lost(largest(self.at_nodes(name)))

    def node_lost(self, column: str) -> float:
        """Return by how little a figure differs where it is level, by its column: torques as at places of stretches."""
        names = {"T": "torque", "S": "behind"}
        if column in names:
            return level(self.sizes[names[column]])
        return level(largest(self.line if column == LINE else self.at_nodes(RATES[column])))

    @cached_property
    def line_asked(self) -> float:
        """What the line of a falling curve must be at no speed (Nm); 0 of one that does not fall."""
        falling = self.driven.falling
        return line_asked(self.driven.demand.course, falling) if falling.fall else 0.0

    @property
    def line(self) -> Array:
        """What the line of a falling curve must be at no speed (Nm), at all nodes."""
        return np.concatenate([self.line_at(one) for one in self.worked])

    def line_at(self, one: Worked) -> Array:
        """Return the same at places of a section."""
        return self.pacing.line(one.torque, one.rate)

    @property
    def rate(self) -> float:
        """The largest speed of the shaft (rad/s)."""
        return largest(self.at_nodes("rate"))

    @property
    def acceleration_of_shaft(self) -> float:
        """The largest acceleration of the shaft (rad/s²)."""
        return largest(self.at_nodes("turning"))

    @property
    def enough(self) -> bool:
        """Whether the places of the sheet suffice."""
        worst = max(one.rest for one in self.sums)
        room = self.turned_round <= self.turn_rows and len(self.spans) <= self.rows
        return room and len(self.sections) <= self.section_rows and suffices(worst, self.at_nodes("torque"))

    @property
    def widths(self) -> list[float]:
        """How wide each section is (rad); spare rows have no width."""
        each = [end - begin for begin, end in (self.within(held, span) for held, span in self.placed)]
        return [width if k < len(self.sections) else 0.0 for k, width in enumerate(each)]

    @cached_property
    def pacing(self) -> PlacePace:
        """What they ask for at other rates; spare rows repeat the last section, without a width."""
        motor, driven = self.driven.motor, self.driven
        loads = loads_of(
            [(held, width, at) for (held, _), width, at in zip(self.placed, self.widths, self.worked, strict=True)]
        )
        limits = motor.rated_torque, motor.peak_torque, motor.max_speed, driven.reducer.limits
        return PlacePace(loads, self.helds[0], driven.demand, *limits, driven.falling)

    @property
    def paced(self) -> Paced:
        """Its highest rate."""
        return self.pacing

    def tops(self, figure: Callable[[Worked], Array], least: float) -> list[Top]:
        """Return the largest value of a figure of each section; ``least`` is next to nothing."""
        return [Polynomial(figure(one), least).top for one in self.worked]
