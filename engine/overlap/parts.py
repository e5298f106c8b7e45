"""The parts: a transfer that brings the work, a tool, and what one leaves to the other."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from engine.laws import Dwell, Law
from engine.laws.base import Array, require_finite
from engine.laws.inverse import inverse
from engine.motion.pieces import Scaled
from engine.timing import FULL_TURN

Inverse = Callable[[Law, Array], Array]
"""the shares of time at which a law reaches heights: exactly, or as a table of points gives them"""


@dataclass(frozen=True)
class Transfer:
    """The first motion: a law over ``stroke`` (m) in ``angle`` (rad), once a cycle, beginning at 0.

    ``inverted`` says when its law has reached a height.
    Raises ValueError unless the stroke is above 0 and the angle between 0 and 2π.
    """

    law: Law
    stroke: float
    angle: float
    inverted: Inverse = inverse

    def __post_init__(self) -> None:
        require_positive(transfer_stroke=self.stroke, transfer_angle=self.angle)
        if self.angle >= FULL_TURN:
            raise ValueError(f"the transfer takes {math.degrees(self.angle):g} degrees; expected less than 360")

    def travel(self, angle: Array) -> Array:
        """Return its travel (m), h_t s(ξ), at angles from 0 to 2π; ξ is 1 from its arrival to the end of the cycle."""
        return self.stroke * self.law.s(np.minimum(angle / self.angle, 1.0))

    @property
    def parts(self) -> tuple[Scaled, Scaled]:
        """The movement, and the dwell to the end of the cycle (m, rad)."""
        there = self.stroke * self.law.end.s
        return (
            Scaled(self.law, self.stroke, self.angle),
            Scaled(Dwell(), 0.0, FULL_TURN - self.angle, self.angle, there),
        )

    @property
    def phases(self) -> list[tuple[Law, float, float]]:
        """Law, lift (m) and angle (rad) of its movement, which a dwell follows."""
        return [(self.law, self.stroke, self.angle)]


@dataclass(frozen=True)
class Tool:
    """The second motion: in over ``stroke`` (m), at the part for the angle ``dwell`` (rad), out again.

    ``law_out`` is the law of the way out, that of the way in if None; ``inverted`` says when they have
    reached a height. Raises ValueError unless the stroke is above 0 and the dwell at least 0.
    """

    law: Law
    stroke: float
    dwell: float
    law_out: Law | None = None
    inverted: Inverse = inverse

    def __post_init__(self) -> None:
        require_positive(tool_stroke=self.stroke)
        require_finite(dwell=self.dwell)
        if self.dwell < 0.0:
            raise ValueError(f"the tool dwells for {math.degrees(self.dwell):g} degrees; expected 0 or more")

    @property
    def out(self) -> Law:
        """The law of the way out."""
        return self.law if self.law_out is None else self.law_out


@dataclass(frozen=True)
class Passage:
    """What one part leaves to the other.

    ``remaining``: share of the transfer's stroke that may be missing, at either end, while the tool is in
    (S2: 0.65 %). ``clearance`` (m): travel of the tool before it would touch the transfer (S2: 20 mm).
    ``margin`` (m): what of it is to stay free (S2: 1 mm). ``allowance`` (rad): taken off the tool's angles
    for the setting of the cam (S2: 5°). ``split``: share of the free angle for the way in.
    Raises ValueError unless 0 ≤ remaining < 1/2, 0 ≤ margin ≤ clearance, allowance ≥ 0 and 0 < split < 1.
    """

    remaining: float
    clearance: float
    margin: float = 0.0
    allowance: float = 0.0
    split: float = 0.5

    def __post_init__(self) -> None:
        require_finite(clearance=self.clearance, margin=self.margin, allowance=self.allowance)
        if not 0.0 <= self.remaining < 0.5:
            raise ValueError(f"remaining is {self.remaining:g} of the stroke; expected at least 0 and less than 0.5")
        if not 0.0 <= self.margin <= self.clearance:
            raise ValueError(f"margin is {self.margin:g} m; expected 0 to the clearance, {self.clearance:g} m")
        if self.allowance < 0.0:
            raise ValueError(f"allowance is {math.degrees(self.allowance):g} degrees; expected 0 or more")
        if not 0.0 < self.split < 1.0:
            raise ValueError(f"split is {self.split:g}; expected more than 0 and less than 1")

    @property
    def shares(self) -> tuple[float, float]:
        """The shares of its stroke between which the transfer is too far from its ends."""
        return self.remaining, 1.0 - self.remaining

    def travelled_share(self, stroke: float, margin: ArrayLike) -> Array:
        """Return the share of its stroke (m) that a tool may have gone when the transfer is in its way.

        (clearance − margin)/stroke for margins (m), at most 1. Source: S2, s = (20 − 1)/50 = 0.38.
        """
        return np.minimum((self.clearance - np.asarray(margin, dtype=np.float64)) / stroke, 1.0)


def require_positive(**quantities: float) -> None:
    """Raise ValueError for the first quantity that is not a finite number above 0."""
    for name, value in quantities.items():
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"{name.replace('_', ' ')} is {value:g}; expected a finite number above 0")
