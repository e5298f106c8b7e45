"""A lever on a shaft that drives a slide through a link: the geometry of crank-slider and rocker. SI units."""

from dataclasses import dataclass

import numpy as np

from engine.drive.mechanisms.variable_ratio import Linkage, Reach, ShaftAngles
from engine.laws.base import Array


@dataclass(frozen=True)
class SlideLinkage(Linkage):
    """The shaft in the origin, a lever r, a link l, and a slide on the line at the distance e from the shaft (m).

    The slide is at x = r cos ψ ± √(l² − (r sin ψ − e)²), ψ the lever's angle from the line's direction; its position is
    y = ``direction`` (x − ``zero``). ``side`` is 1 where the lever is ahead of the line from the shaft to the slide in
    the sense of ψ, else −1. φ is the lever's way from y = 0, where it
    stands at ``start``, counted so that it rises with y.
    """

    name: str
    lever: float
    link: float
    offset: float
    side: int
    direction: int
    zero: float
    start: float
    bounds: Reach

    @property
    def reach(self) -> Reach:
        """Between which positions the slide can go."""
        return self.bounds

    def _shaft(self, y: Array, within: Array) -> ShaftAngles:
        """Return φ = ±(ψ − ψ0), φ' = 1/|dx/dψ|, φ'' from dx/dψ and d²x/dψ² in closed form."""
        x = self.zero + self.direction * y
        psi = lever_angle(self.lever, self.link, self.offset, self.side, x)
        first, second = slopes(self.lever, self.offset, psi, x)
        sense = self.direction * np.sign(first)
        return ShaftAngles(sense * (psi - self.start), 1.0 / np.abs(first), -sense * second / first**3)


def lever_angle(lever: float, link: float, offset: float, side: int, x: Array) -> Array:
    """Return ψ of a slide at x: that of the line from shaft to slide and, beside it, the triangle's angle A.

    tan² A/2 = (l − d + r)(l + d − r)/((d + r − l)(d + r + l)), d the distance of slide and shaft, which keeps its
    digits near the dead centres.
    """
    d = np.hypot(x, offset)
    over = (link - d + lever) * (link + d - lever)
    under = (d + lever - link) * (d + lever + link)
    half = np.arctan2(np.sqrt(np.maximum(over, 0.0)), np.sqrt(np.maximum(under, 0.0)))
    return np.asarray(np.arctan2(offset, x) + side * 2.0 * half)


def slopes(lever: float, offset: float, psi: Array, x: Array) -> tuple[Array, Array]:
    """Return dx/dψ and d²x/dψ² where the lever is at ψ and the slide at x.

    With s = r sin ψ − e, c = r cos ψ and q = x − c: −(r sin ψ + s c/q), −(c + (c² − s r sin ψ)/q + s² c²/q³).
    """
    sin, c = lever * np.sin(psi), lever * np.cos(psi)
    s, q = sin - offset, x - c
    return -(sin + s * c / q), -(c + (c * c - s * sin) / q + (s * c) ** 2 / q**3)
