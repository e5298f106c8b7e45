"""Cranks and levers that drive a slide to and fro through a link. SI units."""

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.drive.chain import require_positive
from engine.drive.mechanisms.variable_ratio import Linkage, Reach, ShaftAngles
from engine.laws.base import Array, require_finite

DEAD = "dead centre of lever and link"
SQUARE = "link square to the slide"
SAME = 1e-9  # share of the link's length by which a link that is square to the slide may deviate
FAR = 4.0  # times lever, link and offset together: beyond the reach of any slide


class LockPlace(NamedTuple):
    """A candidate for an end of the slide's reach."""

    rest: float  # square of the place (m²); below 0 if it does not exist
    at: float  # x of the place (m), or ``zero`` if it does not exist
    d: float  # its distance from the shaft (m)
    along: float  # x of the lever's end (m)
    x: float  # x of the place if the linkage locks there, else ``zero`` (m)
    below: float  # x if it is below ``zero``, else far below (m)
    above: float  # x if it is above ``zero``, else far above (m)
    name: str


@dataclass(frozen=True)
class SlideLever:
    """A lever on a shaft at the origin, a link, and a slide on a line, at x = r cos ψ ± √(l² − (r sin ψ − e)²)."""

    lever: float  # r (m), at the angle ψ from the direction of the line
    link: float  # l (m)
    offset: float  # e, distance of the line from the shaft (m)
    side: int  # 1 if ψ of the lever is ahead of the line from shaft to slide, else −1

    @property
    def far_off(self) -> float:
        """A distance beyond the reach of any slide (m)."""
        return FAR * (self.lever + self.link + abs(self.offset))

    def angle(self, x: ArrayLike) -> Array:
        """Return ψ (rad) at positions of the slide (m): the angle of the line from shaft to slide, plus or minus A.

        With d, the distance of slide and shaft, tan² A/2 = (l − d + r)(l + d − r)/((d + r − l)(d + r + l)).
        """
        d = np.hypot(x, self.offset)
        over = (self.link - d + self.lever) * (self.link + d - self.lever)
        under = (d + self.lever - self.link) * (d + self.lever + self.link)
        half = np.arctan2(np.sqrt(np.maximum(over, 0.0)), np.sqrt(np.maximum(under, 0.0)))
        return np.asarray(np.arctan2(self.offset, x) + self.side * 2.0 * half)

    def lock_places(self, zero: float) -> list[LockPlace]:
        """Return where a slide that begins at ``zero`` (m) locks: lever and link in line, or link square to slide."""
        lever, link, both, places = self.lever, self.link, (1.0, -1.0), []
        in_line = [((link + way * lever) ** 2 - self.offset**2, DEAD) for way in both]
        square = [(lever**2 - (self.offset + way * link) ** 2, SQUARE) for way in both]
        for (rest, name), sign in ((candidate, sign) for candidate in (*in_line, *square) for sign in both):
            at = sign * math.sqrt(rest) if rest >= 0.0 else zero
            along = at if name == DEAD else lever * math.cos(self.angle(at))
            x = at if rest >= 0.0 and (name == DEAD or abs(at - along) <= SAME * link) else zero
            below, above = x if x < zero else -self.far_off, x if x > zero else self.far_off
            places.append(LockPlace(rest, at, math.hypot(at, self.offset), along, x, below, above, name))
        return places


@dataclass(frozen=True)
class SlideLinkage(SlideLever, Linkage):
    """A slide that a lever drives: the load's position y is its distance from ``zero``."""

    name: str
    direction: int  # 1 or −1, in y = direction · (x − zero)
    zero: float  # x at y = 0 (m)
    start: float  # ψ at y = 0 (rad), where φ = 0; φ rises with y
    bounds: Reach

    @property
    def reach(self) -> Reach:
        """Range of the slide's positions (m)."""
        return self.bounds

    def _shaft(self, y: Array, within: Array) -> ShaftAngles:
        """Return φ = ±(ψ − ψ0), φ' = 1/|dx/dψ|, φ'' from dx/dψ and d²x/dψ² in closed form."""
        x = self.zero + self.direction * y
        psi = self.angle(x)
        first, second = slopes(self.lever, self.offset, psi, x)
        sense = self.direction * np.sign(first)
        return ShaftAngles(sense * (psi - self.start), 1.0 / np.abs(first), -sense * second / first**3)


def slopes(lever: float, offset: float, psi: Array, x: Array) -> tuple[Array, Array]:
    """Return the first and the second derivative of the slide's position by the lever's angle.

    With s = r sin ψ − e, c = r cos ψ and q = x − c: −(r sin ψ + s c/q), −(c + (c² − s r sin ψ)/q + s² c²/q³).

    Parameters
    ----------
    lever, offset : float, m
        r and e.
    psi : array (n,), rad
    x : array (n,), m
        Position of the slide at each ψ.

    Returns
    -------
    two arrays (n,), m/rad and m/rad²
    """
    sin, c = lever * np.sin(psi), lever * np.cos(psi)
    s, q = sin - offset, x - c
    return -(sin + s * c / q), -(c + (c * c - s * sin) / q + (s * c) ** 2 / q**3)


DeadCentre = Literal["inner", "outer"]
Branch = Literal["ahead", "behind"]


def crank_slider(
    crank: float,
    rod: float,
    offset: float = 0.0,
    zero: DeadCentre = "inner",
    branch: Branch = "ahead",
    position: float = 0.0,
) -> SlideLinkage:
    """Return a crank-slider, of the stroke √((l + r)² − e²) − √((l − r)² − e²). Source: VDI 2727.

    The rod's mass is divided between its two pins: the part at the crank is a part on its shaft, the other is load.

    Parameters
    ----------
    crank, rod, offset : float, m
        r, l, and e, the distance of the slide's line from the shaft.
    zero : {"inner", "outer"}
        The dead centre from which y grows: "inner", with the slide nearest to the shaft, or "outer".
    branch : {"ahead", "behind"}
        Side of the crank from the line of shaft and slide; with an offset the two motions differ.
    position : float, m
        Distance of y = 0 from the dead centre.

    Raises
    ------
    ValueError
        Unless l > r + |e|, as the crank could not make full turns.
    """
    require_positive("crank-slider", crank=crank, rod=rod)
    require_finite(offset=offset, position=position)
    if not rod > crank + abs(offset):
        least = crank + abs(offset)
        raise ValueError(f"crank-slider: rod is {rod:g} m; expected more than crank and offset, {least:g} m")
    inner, outer = (math.sqrt((rod + way * crank) ** 2 - offset**2) for way in (-1.0, 1.0))
    names = "inner dead centre", "outer dead centre"
    begin, direction, ends = (inner, 1, names) if zero == "inner" else (outer, -1, names[::-1])
    side = 1 if branch == "ahead" else -1
    start = math.atan2(offset, begin) + (side * math.pi if zero == "inner" else 0.0)
    begin += direction * position
    if position:
        start = float(SlideLever(crank, rod, offset, side).angle(begin))
    reach = Reach(-position, outer - inner - position, *ends)
    return SlideLinkage(crank, rod, offset, side, "crank-slider", direction, begin, start, reach)


def rocker(
    lever: float, link: float, offset: float, angle: float, ahead: bool = True, direction: int = 1
) -> SlideLinkage:
    """Return a rocker: a lever on a shaft, a link, and a slide on a line beside the shaft.

    The reach ends where lever and link are in line, or the link is square to the slide.

    Parameters
    ----------
    lever, link, offset : float, m
        r, l, and e, the distance of the slide's line from the shaft.
    angle : float, rad
        The lever's angle from the direction of the line at y = 0.
    ahead : bool
        Whether the slide is before the lever's end at y = 0, else behind it.
    direction : {1, -1}
        Whether y grows with x or against it.

    Raises
    ------
    ValueError
        If the link is too short to reach the slide, or y = 0 is an end of the reach.
    """
    require_positive("rocker", lever=lever, link=link)
    require_finite(offset=offset, angle=angle)
    rest = link**2 - (lever * math.sin(angle) - offset) ** 2
    if not rest > 0.0:
        raise ValueError(f"rocker: link is {link:g} m; expected one that reaches from the lever to the slide")
    zero = lever * math.cos(angle) + (1.0 if ahead else -1.0) * math.sqrt(rest)
    across = math.sin(angle - math.atan2(offset, zero))
    driving = SlideLever(lever, link, offset, 1 if across > 0.0 else -1)
    places = driving.lock_places(zero)
    low = max(((place.below, place.name) for place in places if place.x < zero), default=None)
    high = min(((place.above, place.name) for place in places if place.x > zero), default=None)
    if low is None or high is None or abs(across) < SAME:
        raise ValueError(f"rocker: angle is {angle:g} rad; expected lever and link out of line at position 0")
    if direction < 0:
        low, high = (2.0 * zero - high[0], high[1]), (2.0 * zero - low[0], low[1])
    reach = Reach(low[0] - zero, high[0] - zero, low[1], high[1])
    sense, start = 1 if direction > 0 else -1, float(driving.angle(zero))
    return SlideLinkage(lever, link, offset, driving.side, "rocker", sense, zero, start, reach)
