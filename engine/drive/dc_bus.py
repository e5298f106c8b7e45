"""The mean and the largest power of drives over a cycle, each with a DC bus of its own. SI units."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from engine.drive.results import Energies, Energy

HOUR = 3600.0  # s


class Means(NamedTuple):
    """Mean power (W): from the mains, and in the brake resistor, of a drive that shares its DC bus with no other.

    Of one drive, or of many designs of it.
    """

    mains: Any
    resistor: Any

    def energy_a_year(self, hours: float) -> Any:
        """Return the energy from the mains (J) in a year of so many hours."""
        return self.mains * hours * HOUR

    @property
    def net(self) -> Any:
        """What is used up on the way (W)."""
        return self.mains - self.resistor

    @property
    def least(self) -> Any:
        """The least mean power from the mains, if all that comes back were kept and used."""
        return np.maximum(0.0, self.net)


def means(energy: Energy | Energies, time: Any, efficiency: float) -> Means:
    """Return them from the energy at a motor's shaft over a cycle; exact.

    A drive takes E/η where its motor drives, and gives back η E where the motor is driven.
    """
    return Means(energy.driving / efficiency / time, energy.regenerated * efficiency / time)


class Peaks(NamedTuple):
    """Largest power (W): from the mains, and into the brake resistor, of a drive that shares its DC bus with none."""

    mains: float
    resistor: float


def peaks(highest: float, lowest: float, efficiency: float) -> Peaks:
    """Return them from the highest and the lowest power at a motor's shaft (W)."""
    return Peaks(max(0.0, highest) / efficiency, max(0.0, -lowest) * efficiency)


def together(found: Sequence[Means]) -> Means:
    """Return the sums over drives."""
    return Means(sum(one.mains for one in found), sum(one.resistor for one in found))
