"""A crank that drives a slide through a connecting rod. SI units."""

import math
from typing import Literal

import numpy as np

from engine.drive.chain import require_positive
from engine.drive.mechanisms.slide import SlideLinkage, lever_angle
from engine.drive.mechanisms.variable_ratio import Reach
from engine.laws.base import require_finite

DeadCentre = Literal["inner", "outer"]
Branch = Literal["ahead", "behind"]


def crank_slider(
    crank: float, rod: float, offset: float = 0.0, zero: DeadCentre = "inner", branch: Branch = "ahead",
    position: float = 0.0,
) -> SlideLinkage:  # fmt: skip
    """Return a crank of radius r with a rod l, and a slide on a line at an offset e from the shaft (m).

    y grows away from a dead centre: from the inner one, where the slide is nearest to the shaft, or from the outer one;
    where y = 0 it is so far away as ``position`` says. ``branch`` says on which side of the line from shaft to slide
    the crank is: with an offset the two ways differ. The rod's mass goes to its two pins: what turns with the crank is
    a part on its shaft, what travels is load. Raises ValueError unless l > r + |e|, for the crank could not turn round.
    Source: VDI 2727; the stroke is √((l + r)² − e²) − √((l − r)² − e²).
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
        start = float(lever_angle(crank, rod, offset, side, np.array(begin)))
    reach = Reach(-position, outer - inner - position, *ends)
    return SlideLinkage("crank-slider", crank, rod, offset, side, direction, begin, start, reach)
