"""The engine's view of the switches of a machine, in SI units, each time at its place in their table."""

from collections.abc import Sequence
from functools import cached_property
from itertools import chain
from typing import TypeVar

from engine.timing import Switch
from workbook.book.rows import filled
from workbook.entries.phase import TURN
from workbook.entries.units import DEGREE, shown, si
from workbook.machines.machine.switches.entries import TIMES, SwitchEntry, TimeOn

T = TypeVar("T")
Bars = tuple[tuple[float, float], tuple[float, float]]
NONE: Bars = ((0.0, 0.0), (0.0, 0.0))
"""the bars of a time that is not entered"""


class Lane:
    """A switch as the timing diagram shows it: bars on a lane; ``typed`` are its times as they are entered."""

    def __init__(self, given: SwitchEntry, number: int, typed: SwitchEntry) -> None:
        self.given, self.number = given, number
        self.typed: list[TimeOn] = filled(typed.on, TIMES, TimeOn())
        self.times: list[TimeOn] = filled(given.on, TIMES, TimeOn())

    @cached_property
    def switch(self) -> Switch:
        """The switch over a turn of the master shaft (rad)."""
        told = [(si(time.start, DEGREE), si(time.stop, DEGREE)) for time in self.times
                if time.start is not None and time.stop is not None]  # fmt: skip
        return Switch(self.given.name, tuple(told))

    def each(self, values: Sequence[T], spare: T) -> list[T]:
        """Return a value for each time: those of the ones that are entered, in their order."""
        found = iter(values)
        return [next(found) if time.told else spare for time in self.times]

    @property
    def spans(self) -> list[float]:
        """How long each time lasts (degrees)."""
        return [shown(span, DEGREE) for span in self.each(self.switch.spans, 0.0)]

    @property
    def until_next(self) -> list[float]:
        """From the begin of each time to the next begin of the switch (degrees); a turn where there is no other."""
        told = [(k, time.start) for k, time in enumerate(self.times) if time.told and time.start is not None]
        later = {k: min(((b - a) % TURN for j, b in told if j != k), default=TURN) for k, a in told}
        return [later.get(k, 0.0) for k in range(TIMES)]

    def outline(self, floor: int, height: float, near: float) -> list[tuple[float, float]]:
        """Return the corners of its lane: angle (degrees) and height; a bar no wider than ``near`` is none."""
        corners = [(0.0, float(floor))]
        for bar in chain.from_iterable(self.each(self.switch.bars, NONE)):
            low, high = (shown(end, DEGREE) for end in bar)
            top = floor + (height if high - low > near else 0.0)
            corners += [(low, floor), (low, top), (high, top), (high, floor)]
        return [*corners, (TURN, floor)]


def named(number: int) -> str:
    """Return the name of the cell that tells what a switch is called: by it a file tells how many there are."""
    return f"switch{number}_name"
