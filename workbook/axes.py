"""The axes of a machine as a controller sees them: what a template says once, and every target takes."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, Self

from engine.motion.pieces import CamProfile
from engine.timing import Switch


@dataclass(frozen=True)
class CamAxis:
    """An axis over a cycle of its master: its profile and the units of both."""

    name: str
    profile: CamProfile
    x_unit: str
    y_unit: str
    repeats: bool = True  # whether the cycle follows upon itself: it comes back, or a feed goes on from where it is
    shaft: Callable[[], Self] | None = None
    """gives the angle of its motor's shaft, if it has a drive; raises ValueError for what the mechanism cannot do"""

    @property
    def units(self) -> tuple[str, str, str, str]:
        """Units of y, y', y'' and y'''."""
        x, y = self.x_unit, self.y_unit
        return y, f"{y}/{x}", f"{y}/{x}²", f"{y}/{x}³"


class CamSwitch(NamedTuple):
    """A switch over a cycle of the master, in the unit of its angles."""

    name: str
    switch: Switch
    x_unit: str
