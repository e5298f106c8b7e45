"""The hard stops of an axis on the Timing sheet: where they are entered, and the checks that it stays between them."""

import math
from typing import NamedTuple

from engine.motion import Motion
from workbook.book.cell_tables import cell_tables
from workbook.book.checks import ZERO
from workbook.book.declare import Quantity
from workbook.book.sentence import CheckSentence, amount
from workbook.fields.units import shown
from workbook.machines.machine.entries_beside import STOPS
from workbook.machines.machine.view import MovingAxis

CELLS = cell_tables(__file__)

FEEDS_ON = "it feeds on, cycle by cycle"
CALLED = {"low": "lower", "high": "upper"}


class HardStop(NamedTuple):
    """One of both stops of an axis; positions are in its unit."""

    axis: MovingAxis
    end: str  # low or high

    @property
    def name(self) -> str:
        """The name of the stop's cell."""
        return f"axis{self.axis.number}_stop_{self.end}"

    @property
    def entered(self) -> float | None:
        """The position that is entered, None where the cell is empty."""
        position: float | None = getattr(self.axis.given.stops, self.end)
        return position

    @property
    def outwards(self) -> float:
        """The sign of the direction in which the axis meets it."""
        return -1.0 if self.end == "low" else 1.0

    @property
    def position(self) -> float:
        """The stop's position, infinitely far where none is entered."""
        return self.outwards * math.inf if self.entered is None else self.entered

    @property
    def tolerance(self) -> float:
        """By how much rounding may carry the axis beyond it."""
        return ZERO * (self.axis.greatest_lift + abs(self.entered or 0.0))

    @property
    def feeds_on(self) -> bool:
        """Whether the axis goes on towards it, cycle by cycle."""
        travel = shown(self.axis.motion.lifts_sum, self.axis.unit)
        return self.axis.given.closes == "feed" and self.outwards * travel > ZERO * self.axis.greatest_lift

    def reached_by(self, motion: Motion) -> float:
        """Return how far towards it a motion goes."""
        if self.feeds_on:
            return self.outwards * math.inf
        return shown(motion.reach[STOPS.index(self.end)], self.axis.unit)


def stops_of(axis: MovingAxis) -> list[HardStop]:
    """Return both stops of an axis that has any."""
    return [HardStop(axis, end) for end in STOPS] if axis.given.stops else []


def stop_cell(stop: HardStop) -> Quantity:
    """Return the row in which a stop is entered."""
    i, called = stop.axis.number - 1, CALLED[stop.end].capitalize()
    parts = {"name": stop.name, "called": called, "i": i, "end": stop.end}
    return CELLS["stop_cell"]("{name}", stop.entered, unit=stop.axis.given.unit, **parts)


def stop_check(stop: HardStop) -> Quantity:
    """Return the check that an axis, its overshoot included, does not go beyond a stop."""
    place = stop.reached_by(stop.axis.motion)
    i, unit, called, entered = stop.axis.number, stop.axis.given.unit, CALLED[stop.end], stop.name
    reached, travel, lift = f"[axes.{stop.end}.{i}]", f"[axes.travel.{i}]", f"[axes_taken.lift.{i}]"
    beyond, onwards = f"{reached}-{entered}", travel
    if stop.end == "low":
        beyond, onwards = f"{entered}-{reached}", f"0-{travel}"
    says = amount(reached, place, "it goes to ", f" {unit}, ")
    says = says.then(amount(beyond, abs(place - stop.position), "", f" {unit} beyond its {called} stop"))
    feeds_on = f'AND([axes.closes.{i}]="feed",{onwards}>check_zero*{lift})'
    says = CheckSentence(f'IF({feeds_on},"{FEEDS_ON}",{says.says})', FEEDS_ON if stop.feeds_on else says.text)
    stays = f'OR([axes.closes.{i}]<>"feed",{onwards}<=check_zero*{lift})'
    parts = {"entered": entered, "i": i, "called": called, "stays": stays}
    is_kept = stop.outwards * place <= stop.outwards * stop.position + stop.tolerance
    return CELLS["stop_check"]("{entered}_kept", is_kept, says=says, beyond=beyond, lift=lift, **parts)
