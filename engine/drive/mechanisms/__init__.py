"""Mechanisms between the gears and the load, by name: gears in line and a last element, which the load hangs on."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from engine.drive.chain import Load, Mechanism, Part, Stage, require_not_negative, require_positive


@dataclass(frozen=True)
class Kind:
    """A kind of mechanism."""

    name: str
    element: str  # its last
    turns: Callable[[float], float] | None = None  # its speed over the load's (rad/m) by a size; None: 1, or by place
    belt: bool = False  # whether one moves with the load

    def of(
        self, load: Load, size: float = 1.0, efficiency: float = 1.0, gears: Sequence[Stage] = (),
        parts: Sequence[Part] = (), belt: float = 0.0,
    ) -> Mechanism:  # fmt: skip
        """Return the mechanism of a load behind gears, ``parts`` on their shafts, and a belt of a mass (kg).

        ``size`` and ``efficiency`` are those of the last element. The belt's own weight balances itself; a mechanism
        that has none takes no notice of it. Raises ValueError for a size, an efficiency or a mass that cannot be.
        """
        require_not_negative(self.name, belt=belt)
        ratio = 1.0
        if self.turns is not None:
            require_positive(self.name, size=size)
            ratio = self.turns(size)
        moved = [Part("belt", belt, len(gears) + 1)] if self.belt else []
        return Mechanism(self.name, (*gears, Stage(self.element, ratio, efficiency)), (*parts, *moved), load)


def of_wheel(diameter: float) -> float:
    """Return 2/D (rad/m) of a wheel. Source: S4, problem 2."""
    return 2.0 / diameter


KINDS = {
    kind.name: kind
    for kind in (
        Kind("lead screw", "screw", lambda turns: 2.0 * math.pi * turns),  # 2πP of P turns a metre: S4, problem 1
        Kind("conveyor", "roller", of_wheel, belt=True),
        Kind("rack and pinion", "pinion", of_wheel),
        Kind("belt", "pulley", of_wheel, belt=True),
        Kind("rotary table", "table"),
        Kind("gear train", "last gear"),
        Kind("press crank", "crank"),
        Kind("feed rollers", "roller", lambda radius: 1.0 / radius),  # S1, 'Feeding group', ω_r = v/R
        Kind("crank-slider", "crank"),
        Kind("rocker", "lever"),
        Kind("table", "cam"),
    )
}
"""every mechanism by its name; the parts behind its gears, rollers and pulleys among them, are entered with it"""
