"""What a margin costs: the tool's angles and peak acceleration for each."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.laws.base import Array
from engine.overlap.parts import Passage, Tool, Transfer
from engine.overlap.plan import one_after_the_other, room, tool_angles
from engine.timing import FULL_TURN


class MarginSweep(NamedTuple):
    """What a margin costs: arrays over the margins."""

    margin: Array
    angle_in: Array
    angle_out: Array
    acceleration: Array
    """m/s²"""
    ratio: Array
    """of the peak acceleration without overlap to that with it"""


def sweep_margin(transfer: Transfer, tool: Tool, passage: Passage, margins: ArrayLike, rate: float) -> MarginSweep:
    """Return the tool's angles, peak acceleration and gain for each margin (m), at ``rate`` cycles per second.

    Raises ValueError where a margin is not from 0 to the clearance, or no angle is left.
    """
    margin = np.asarray(margins, dtype=np.float64)
    for extreme in (margin.min(), margin.max()):
        replace(passage, margin=float(extreme))
    way_in, way_out, _ = tool_angles(room(transfer, tool, passage), tool, passage, margin)
    scale = tool.stroke * (FULL_TURN * rate) ** 2
    peaks = [law.coefficients.ca * scale / way**2 for law, way in ((tool.law, way_in), (tool.out, way_out))]
    acceleration = np.maximum(*peaks)
    before = one_after_the_other(transfer, tool, passage.split).peak_acceleration(rate)
    return MarginSweep(margin, way_in, way_out, acceleration, before / acceleration)
