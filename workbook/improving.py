"""The parts by which a machine is improved: changes, the room of edges, aims."""

import math
from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

from workbook.book.sentence import figure
from workbook.fields.paths import Place

NEAR = 1e-9  # of a step: so near below a multiple counts as that
AimName = Literal["rate", "torque", "power", "energy", "acceleration", "vibration"]
ChangeKind = Literal["law", "edge", "product", "other"]


class Change(NamedTuple):
    """A change of a machine: in words, the entries that differ by their places, and its kind."""

    words: str
    entries: Mapping[Place, Any]
    kind: ChangeKind

    @property
    def what(self) -> tuple[Place, ...]:
        """The places of its entries, those of laws and sizes aside: changes of the same exclude each other."""
        return tuple(place for place in self.entries if place[0] not in ("laws", "sizes"))


class Room(NamedTuple):
    """Edges that move together: where they are in words and by entry, by how much they may move, in steps."""

    axis: str
    words: Mapping[str, float]
    edges: Mapping[Place, float]
    low: float  # 0 or less; in the unit of the cycle, as all these
    high: float
    step: float
    after: str  # what stands behind a place in words

    def rounded(self, by: float) -> float:
        """Return the nearest multiple of the step within the room."""
        lowest = math.ceil(self.low / self.step - NEAR)
        highest = math.floor(self.high / self.step + NEAR)
        return min(max(round(by / self.step), lowest), highest) * self.step

    def change(self, by: float) -> Change:
        """Return the change that moves the edges."""
        words = (f"{words} {figure(at)} → {figure(round(at + by, 9))}" for words, at in self.words.items())
        moved = {path: round(place + by, 9) for path, place in self.edges.items()}
        return Change(f"{self.axis}: {f'{self.after}, '.join(words)}{self.after}", moved, "edge")


class Aim(NamedTuple):
    """An aim: a name, in words, its unit; of a vibration the natural frequency (Hz) and the damping.

    Without a unit it is that of the axis.
    """

    name: AimName = "rate"
    words: str = "highest rate"
    unit: str = "cycles/min"
    frequency: float = 0.0
    damping: float = 0.0

    @property
    def is_rate(self) -> bool:
        """Whether the highest rate is to be higher; all else is to be less, at the rate of the machine."""
        return self.name == "rate"


AIMS = {
    aim.name: aim
    for aim in (
        Aim(),
        Aim("torque", "RMS torque", "Nm"),
        Aim("power", "peak power", "kW"),
        Aim("energy", "energy driven in a cycle", "J"),
        Aim("acceleration", "greatest acceleration", ""),
        Aim("vibration", "vibration left by the moves, in RMS,", ""),
    )
}


class Figure(NamedTuple):
    """A figure of an axis that is to be less, and its unit."""

    value: float
    unit: str
