"""Register of mechanisms by name: each has gears in line and a last element that moves the load."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from engine.drive.chain import Load, Mechanism, Part, Stage, require_not_negative, require_positive


@dataclass(frozen=True)
class Kind:
    """A kind of mechanism."""

    name: str
    element: str  # name of its last element
    # size -> speed of the element over the load's (rad/m); None: 1
    turns: Callable[[float], float] | None = None
    belt: bool = False  # whether a belt moves with the load

    def of(
        self,
        load: Load,
        size: float = 1.0,
        efficiency: float = 1.0,
        gears: Sequence[Stage] = (),
        parts: Sequence[Part] = (),
        belt: float = 0.0,
    ) -> Mechanism:
        """Return the mechanism that moves a load, behind gears with parts on their shafts.

        Parameters
        ----------
        load : Load
        size : float
            Of the last element: turns a metre of a screw (1/m), diameter of a wheel, radius of a feed roller (m).
        efficiency : float
            Of the last element.
        gears : sequence of Stage
            From the motor on.
        parts : sequence of Part
        belt : float, kg
            Mass that moves without lift; kinds without a belt ignore it.

        Raises
        ------
        ValueError
            Unless size and efficiency are above 0, the efficiency at most 1, and the belt 0 or more.
        """
        require_not_negative(self.name, belt=belt)
        ratio = 1.0
        if self.turns is not None:
            require_positive(self.name, size=size)
            ratio = self.turns(size)
        moved = [Part("belt", belt, len(gears) + 1)] if self.belt else []
        return Mechanism(self.name, (*gears, Stage(self.element, ratio, efficiency)), (*parts, *moved), load)


def of_wheel(diameter: float) -> float:
    """Return 2/D (rad/m) of a wheel of the diameter D (m). Source: S4, problem 2."""
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
"""every mechanism by its name; rollers and pulleys are entered as parts"""
