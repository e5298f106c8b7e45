"""A lever on a shaft that drives a slide through a link, to and fro. SI units."""

from __future__ import annotations

import math

import numpy as np

from engine.drivetrain.chain import require_positive
from engine.laws.base import require_finite
from engine.mechanisms.linkage import Reach
from engine.mechanisms.slide import SlideLinkage, lever_angle

SAME = 1e-9
"""of the link, by which the link may be out of the square to count as square to the slide"""

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
    ends = _ends(lever, link, offset, side)
    low = max(((x, name) for x, name in ends if x < zero), default=None)
    high = min(((x, name) for x, name in ends if x > zero), default=None)
    if low is None or high is None or abs(across) < SAME:
        raise ValueError(f"rocker: angle is {angle:g} rad; expected lever and link out of line at position 0")
    if direction < 0:
        low, high = (2.0 * zero - high[0], high[1]), (2.0 * zero - low[0], low[1])
    reach = Reach(low[0] - zero, high[0] - zero, low[1], high[1])
    start = float(lever_angle(lever, link, offset, side, np.array(zero)))
    return SlideLinkage("rocker", lever, link, offset, side, 1 if direction > 0 else -1, zero, start, reach)


def _ends(lever: float, link: float, offset: float, side: int) -> list[tuple[float, str]]:
    """Return every x of the slide at which the linkage of this side locks, with what happens there."""
    both = 1.0, -1.0
    in_line = [(link + way * lever) ** 2 - offset**2 for way in both]
    square = [lever**2 - (offset + way * link) ** 2 for way in both]
    found = [(sign * math.sqrt(rest), DEAD) for rest in in_line if rest >= 0.0 for sign in both]
    for x in (sign * math.sqrt(rest) for rest in square if rest >= 0.0 for sign in both):
        psi = float(lever_angle(lever, link, offset, side, np.array(x)))
        if abs(x - lever * math.cos(psi)) <= SAME * link:
            found.append((x, SQUARE))
    return found
