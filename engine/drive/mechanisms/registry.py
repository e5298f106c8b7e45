"""Every mechanism by its name, of a constant ratio or of one that depends on the load's position. SI units."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from engine.drive.chain import Load, Mechanism, Part, Stage
from engine.drive.mechanisms.constant import KINDS, Kind
from engine.drive.mechanisms.crank_slider import crank_slider
from engine.drive.mechanisms.rocker import rocker
from engine.drive.mechanisms.table import PositionTable
from engine.drive.mechanisms.variable_ratio import Linkage


@dataclass(frozen=True)
class VariableRatio:
    """A mechanism whose ratio depends on position: what makes it, of its own entries."""

    name: str
    element: str
    make: Callable[..., Linkage]

    def of(
        self, load: Load, efficiency: float = 1.0, gears: Sequence[Stage] = (), parts: Sequence[Part] = ()
    ) -> Mechanism:
        """Return the chain to its load: gears, then the mechanism as a stage of ratio 1, which a linkage replaces."""
        return Mechanism(self.name, (*gears, Stage(self.element, 1.0, efficiency)), tuple(parts), load)


VARIABLE_RATIO = {
    linked.name: linked
    for linked in (
        VariableRatio("crank-slider", "crank", crank_slider),
        VariableRatio("rocker", "lever", rocker),
        VariableRatio("table", "cam", PositionTable),
    )
}
"""those whose ratio depends on position"""

DIRECT = Kind("direct", "shaft")
"""a load on the motor's own shaft, or behind a reducer"""

MECHANISMS: dict[str, Kind | VariableRatio] = {DIRECT.name: DIRECT, **KINDS, **VARIABLE_RATIO}
"""every mechanism: a direct drive, those of constant ratio and those whose ratio depends on the position"""
