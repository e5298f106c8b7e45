"""Pictures of transfer and tools: outlines along the transfer's travel and up from the work (m), lanes of a diagram.

Sizes that are not entered are shares of the strokes: the picture shows the positions of the parts, not their shape.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.overlap.plan import Station

LANE_SHARE = 0.8  # height of a part in a timing diagram, as a share of its lane
WIDTH = 0.3  # of a tool, in strokes of the transfer
BODY = 1.5  # length of a tool, in its own strokes
PLATE = 0.2  # depth of the transfer below the work, in the longest stroke of a tool
STEP = 2.5  # from station to station, in strokes of the transfer
PUNCH = (
    (-0.5, 0.0), (-0.5, 0.8), (-1.0, 0.8), (-1.0, 1.0), (1.0, 1.0), (1.0, 0.8), (0.5, 0.8), (0.5, 0.0), (-0.5, 0.0),
)  # fmt: skip
"""corners of a tool: across in its widths, along in its lengths"""
WALLS = tuple((wall, side, up) for wall in (-2, -1, 0) for side, up in ((0, 0), (0, 1), (1, 1), (1, 0)))
"""corners of the transfer at a station: number of the wall, left 0 or right 1, lower 0 or upper 1"""
FRAME = ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))  # corners: left 0 or right 1, lower 0 or upper 1


class Outline(NamedTuple):
    """Corners of an outline (m)."""

    x: Array  # along the transfer's travel
    z: Array  # upwards from the work


class Scene:
    """A transfer at one station or more, each with its tool (m)."""

    def __init__(self, stations: Sequence[Station]) -> None:
        self.transfer = stations[0].transfer
        pitch = self.transfer.stroke
        self.strokes = np.array([station.tool.stroke for station in stations], dtype=np.float64)
        # x of the stations
        self.middles = pitch * STEP * np.arange(len(stations), dtype=np.float64)
        # openings of the transfer at the stations: a tool's width, and on both sides the remaining part of the stroke
        self.openings = pitch * (WIDTH + 2.0 * np.array([station.passage.remaining for station in stations]))
        # h − c
        self.tops = np.array([max(of.tool.stroke - of.passage.clearance, 0.0) for of in stations])

    def punch(self, i: int, travel: float) -> Outline:
        """Return the outline of the ``i``-th tool, from 0, after a travel (m)."""
        across, along = np.array(PUNCH).T
        h = self.strokes[i]
        return Outline(self.middles[i] + across * WIDTH * self.transfer.stroke, h - travel + along * BODY * h)

    def walls(self, travel: float) -> Outline:
        """Return the outline of the transfer after a travel (m), at each station clipped to a stroke on both sides."""
        pitch, (wall, side, up) = self.transfer.stroke, np.array(WALLS, dtype=np.float64).T
        across = travel + pitch * (wall + side) + self.openings[:, None] * (0.5 - side)
        height = np.where(up == 1.0, self.tops[:, None], -PLATE * self.strokes.max())
        return Outline((self.middles[:, None] + np.clip(across, -pitch, pitch)).ravel(), height.ravel())

    def frame(self) -> Outline:
        """Return the frame of the picture, which holds all parts at every angle."""
        right, upper = np.array(FRAME, dtype=np.float64).T
        pitch, h = self.transfer.stroke, self.strokes.max()
        across = np.where(right == 1.0, self.middles[-1] + pitch, -pitch)
        return Outline(across, np.where(upper == 1.0, h * (1.0 + BODY), -PLATE * h))


def lane(number: int, share: Array) -> Array:
    """Return the height of a part in a timing diagram, in lanes from 0, at shares of its stroke."""
    return number + LANE_SHARE * share
