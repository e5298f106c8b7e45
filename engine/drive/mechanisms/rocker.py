"""A lever on a shaft that drives a slide through a link, to and fro. SI units."""

import math
from typing import NamedTuple

import numpy as np

from engine.drive.chain import require_positive
from engine.drive.mechanisms.slide import SlideLinkage, lever_angle
from engine.drive.mechanisms.variable_ratio import Reach
from engine.laws.base import require_finite

SAME = 1e-9
"""of the link, by which the link may be out of the square to count as square to the slide"""

FAR = 4.0
"""of lever, link and offset together: no slide goes there"""

DEAD = "dead centre of lever and link"
SQUARE = "link square to the slide"


def rocker(
    lever: float, link: float, offset: float, angle: float, ahead: bool = True, direction: int = 1
) -> SlideLinkage:
    """Return a lever r on a shaft, a link l, and a slide on a line at the distance e from the shaft (m).

    At y = 0 the lever stands at ``angle`` (rad) from the direction of the line; ``ahead`` says whether the slide is
    then before or behind the lever's end, ``direction`` 1 that y grows forward, −1 backward. Its reach ends where lever
    and link are in line, or where the link is square to the slide. Raises ValueError where the link does not reach from
    the lever to the slide, or where y = 0 is an end of the reach.
    """
    require_positive("rocker", lever=lever, link=link)
    require_finite(offset=offset, angle=angle)
    rest = link**2 - (lever * math.sin(angle) - offset) ** 2
    if not rest > 0.0:
        raise ValueError(f"rocker: link is {link:g} m; expected one that reaches from the lever to the slide")
    zero = lever * math.cos(angle) + (1.0 if ahead else -1.0) * math.sqrt(rest)
    across = math.sin(angle - math.atan2(offset, zero))
    side = 1 if across > 0.0 else -1
    places = ends_of(lever, link, offset, side, zero)
    low = max(((one.below, one.name) for one in places if one.x < zero), default=None)
    high = min(((one.above, one.name) for one in places if one.x > zero), default=None)
    if low is None or high is None or abs(across) < SAME:
        raise ValueError(f"rocker: angle is {angle:g} rad; expected lever and link out of line at position 0")
    if direction < 0:
        low, high = (2.0 * zero - high[0], high[1]), (2.0 * zero - low[0], low[1])
    reach = Reach(low[0] - zero, high[0] - zero, low[1], high[1])
    start = float(lever_angle(lever, link, offset, side, np.array(zero)))
    return SlideLinkage("rocker", lever, link, offset, side, 1 if direction > 0 else -1, zero, start, reach)


class EndPlace(NamedTuple):
    """A place ``at`` of the slide at which the linkage may lock, at d from the shaft; the lever's end along the line.

    ``rest`` is its square, less than 0 where it is none. x is that place, or that of y = 0 where the linkage does not
    lock; ``below`` and ``above`` are x, or far off where x is on the other side.
    """

    rest: float
    at: float
    d: float
    along: float
    x: float
    below: float
    above: float
    name: str


def ends_of(lever: float, link: float, offset: float, side: int, zero: float) -> list[EndPlace]:
    """Return the places at which a linkage of this side may lock: lever and link in line, or the link square."""
    both = 1.0, -1.0
    in_line = [((link + way * lever) ** 2 - offset**2, DEAD) for way in both]
    square = [(lever**2 - (offset + way * link) ** 2, SQUARE) for way in both]
    return [
        _end(lever, link, offset, side, zero, rest, sign, name) for rest, name in (*in_line, *square) for sign in both
    ]


def farther(lever: float, link: float, offset: float) -> float:
    """Return what is farther than any slide of these lengths."""
    return FAR * (lever + link + abs(offset))


def _end(
    lever: float, link: float, offset: float, side: int, zero: float, rest: float, sign: float, name: str
) -> EndPlace:  # fmt: skip
    at = sign * math.sqrt(rest) if rest >= 0.0 else zero
    turned = lever * math.cos(float(lever_angle(lever, link, offset, side, np.array(at))))
    along = at if name == DEAD else turned
    there = rest >= 0.0 and (name == DEAD or abs(at - along) <= SAME * link)
    x, far = at if there else zero, farther(lever, link, offset)
    return EndPlace(rest, at, math.hypot(at, offset), along, x, x if x < zero else -far, x if x > zero else far, name)
