"""The mechanisms: each is gears in line and a last element, which the load hangs on. SI units."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from engine.drive.chain import Load, Mechanism, Part, Stage, require_not_negative, require_positive


@dataclass(frozen=True)
class Kind:
    """A kind of mechanism: its last element, how far its load travels with it, whether a belt moves with the load.

    ``turns`` gives the speed of the element over that of the load (rad/m) from its size: turns a metre, a diameter or
    a radius in m; None says that the load turns with the element.
    """

    name: str
    element: str
    turns: Callable[[float], float] | None = None
    belt: bool = False

    @property
    def travels(self) -> bool:
        """Whether the load travels."""
        return self.turns is not None

    def ratio(self, size: float) -> float:
        """Return the speed of the last element over that of the load: rad/m, or 1 where the load turns with it.

        Raises ValueError unless the size is above 0, where it counts.
        """
        if self.turns is None:
            return 1.0
        require_positive(self.name, size=size)
        return self.turns(size)

    def of(
        self,
        load: Load,
        size: float = 1.0,
        efficiency: float = 1.0,
        gears: Sequence[Stage] = (),
        parts: Sequence[Part] = (),
        belt: float = 0.0,
    ) -> Mechanism:
        """Return the mechanism of a load behind gears, ``parts`` on their shafts, and a belt of a mass (kg).

        ``size`` and ``efficiency`` are those of the last element. The belt's own weight balances itself; a mechanism
        that has none takes no notice of it. Raises ValueError for a size, an efficiency or a mass that cannot be.
        """
        require_not_negative(self.name, belt=belt)
        last = Stage(self.element, self.ratio(size), efficiency)
        moved = [Part("belt", belt, len(gears) + 1)] if self.belt else []
        return Mechanism(self.name, (*gears, last), (*parts, *moved), load)


def of_screw(turns: float) -> float:
    """Return 2πP (rad/m) of P turns a metre. Source: S4, problem 1."""
    return 2.0 * math.pi * turns


def of_wheel(diameter: float) -> float:
    """Return 2/D (rad/m) of a wheel. Source: S4, problem 2."""
    return 2.0 / diameter


def of_roller(radius: float) -> float:
    """Return 1/R (rad/m) of a roller. Source: S1, 'Feeding group', ω_r = v/R."""
    return 1.0 / radius


KINDS = {
    kind.name: kind
    for kind in (
        Kind("lead screw", "screw", of_screw),
        Kind("conveyor", "roller", of_wheel, belt=True),
        Kind("rack and pinion", "pinion", of_wheel),
        Kind("belt", "pulley", of_wheel, belt=True),
        Kind("rotary table", "table"),
        Kind("gear train", "last gear"),
        Kind("press crank", "crank"),
        Kind("feed rollers", "roller", of_roller),
    )
}
"""every mechanism by its name; the parts behind its gears, rollers and pulleys among them, are entered with it"""
