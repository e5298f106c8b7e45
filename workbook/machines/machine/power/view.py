"""The engine's view of drives on a common DC bus: their power at the samples of the cycle, and its sum."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from engine.drive.results import Energy, Means, Peaks, means, peaks, together
from engine.laws.base import Array
from workbook.entries.abscissa import Abscissa
from workbook.machines.machine.chain import PowerEntry
from workbook.machines.machine.drive.view import DriveView

FINE = 0.05
"""of the peak: by more the samples must not miss the drives' peaks"""
LEAST = 1.0
"""W that count as nothing"""


class Mains:
    """Drives over one turn; those that run at the machine's rate share a bus."""

    def __init__(self, drives: Sequence[DriveView], entered: PowerEntry) -> None:
        self.drives, self.entered = drives, entered

    @property
    def over(self) -> Abscissa:
        """What the cycle is shown over."""
        return self.drives[0].one.machine.over

    @cached_property
    def on_bus(self) -> Array:
        """1 of each drive on the bus, else 0: one at a rate of its own has no place in the turn."""
        return np.array([float(one.driven.entered.rate is None) for one in self.drives])

    @cached_property
    def each(self) -> list[Means]:
        """What each drive takes and burns without a common bus (W)."""
        eta = self.entered.efficiency
        return [means(Energy(*one.energy), one.driven.drive_cycle.time, eta) for one in self.drives]

    @cached_property
    def most(self) -> list[Peaks]:
        """The peak powers of each drive without a common bus (W)."""
        powers = [(one.points, one.points.power) for one in self.drives]
        return [peaks(at.top(power), -at.top(-power), self.entered.efficiency) for at, power in powers]

    @cached_property
    def tops(self) -> tuple[Array, Array]:
        """The same of all drives, from the mains and in the resistors."""
        mains, resistor = zip(*self.most, strict=True)
        return np.array(mains), np.array(resistor)

    @cached_property
    def alone(self) -> Means:
        """What all drives take and burn, each alone (W)."""
        return together(self.each)

    @cached_property
    def drawn(self) -> Array:
        """What each drive on the bus draws at the samples (W), below 0 what it gives back; none of the others."""
        eta = self.entered.efficiency
        power = np.array([one.sampled[1] for one in self.drives])
        return self.on_bus[:, None] * np.where(power > 0.0, power / eta, power * eta)

    @cached_property
    def sum(self) -> Array:
        """The power of the bus at the samples (W)."""
        return np.asarray(self.drawn.sum(axis=0))

    @property
    def apart(self) -> Array:
        """What those drives take from the mains at the samples without the bus (W)."""
        return np.asarray(np.maximum(self.drawn, 0.0).sum(axis=0))

    @cached_property
    def weights(self) -> Array:
        """What a sample counts in a mean over the cycle, by the trapezoidal rule."""
        count = self.sum.size - 1
        found = np.full(count + 1, 1.0 / count)
        found[[0, -1]] /= 2.0
        return found

    @cached_property
    def proved(self) -> tuple[Array, Array]:
        """What the bus takes from the mains, and burns, at least, as one drive's peak proves (W)."""
        mains, resistor = (self.on_bus * tops for tops in self.tops)
        return self.on_bus * (mains - (resistor.sum() - resistor)), self.on_bus * (resistor - (mains.sum() - mains))

    @property
    def peak(self) -> float:
        """The largest power from the mains (W)."""
        return max(0.0, float(self.sum.max()), float(self.proved[0].max()))

    @property
    def burnt_peak(self) -> float:
        """The largest power in the brake resistor (W)."""
        return max(0.0, -float(self.sum.min()), float(self.proved[1].max()))

    @property
    def net(self) -> float:
        """What the drives on the bus use up on the way, in the mean (W)."""
        return float(self.on_bus @ [one.net for one in self.each])

    @cached_property
    def common(self) -> Means:
        """What they take and burn together in the mean (W): one alone as by its points, more by the samples."""
        if self.on_bus.sum() == 1.0:
            return self.each[int(self.on_bus.argmax())]
        mains = max(float(self.weights @ np.maximum(self.sum, 0.0)), self.net, 0.0)
        return Means(mains, mains - self.net)

    @cached_property
    def off(self) -> Array:
        """By how much the samples of each drive on the bus miss its peaks (W)."""
        mains, resistor = self.tops
        missed = np.maximum(mains - self.drawn.max(axis=1), resistor + self.drawn.min(axis=1))
        return np.asarray(self.on_bus * missed)

    @property
    def added(self) -> float:
        """By how much the peaks of all drives on the bus, added up, exceed those of the bus (W)."""
        mains, resistor = (self.on_bus @ tops for tops in self.tops)
        return float(max(mains - self.peak, resistor - self.burnt_peak))

    @property
    def missed(self) -> float:
        """By how much the peaks of the bus may be higher (W): by what the samples miss, or what peaks add up to."""
        return max(0.0, min(float(self.off.sum()), self.added))

    @property
    def fine(self) -> bool:
        """Whether the peaks of the bus are known, but for :data:`FINE` of them."""
        return self.missed <= FINE * max(self.peak, self.burnt_peak) + LEAST

    @property
    def size(self) -> float:
        """The largest power of all together (W)."""
        return max(1e-3, sum(max(one) for one in self.most))
