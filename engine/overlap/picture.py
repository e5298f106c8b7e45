"""The parts as they are drawn: outlines across the transfer's way and up from the work (m), lanes of a diagram.

The sizes that no entry gives are shares of the strokes: what is drawn shows where the parts stand, not their shape.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array
from engine.overlap.schedule import Passage, Tool, Transfer

LANE_SHARE = 0.8  # height of a part in a timing diagram, of its lane
WIDTH = 0.3  # of a tool, in strokes of the transfer
BODY = 1.5  # length of a tool, in its own strokes
PLATE = 0.2  # below the work, in the longest stroke of a tool
STEP = 2.5  # from station to station, in strokes of the transfer
PUNCH = (
    (-0.5, 0.0), (-0.5, 0.8), (-1.0, 0.8), (-1.0, 1.0), (1.0, 1.0), (1.0, 0.8), (0.5, 0.8), (0.5, 0.0), (-0.5, 0.0),
)  # fmt: skip
"""a tool: across in its width, along in its length"""
WALLS = tuple((wall, side, up) for wall in (-2, -1, 0) for side, up in ((0, 0), (0, 1), (1, 1), (1, 0)))
"""the transfer at a station: wall by wall, left or right, lower or upper corner"""
FRAME = ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))  # right or left, upper or lower corner


class Outline(NamedTuple):
    """Corners of what is drawn (m): across, and upwards from the work."""

    x: Array
    z: Array


class Scene:
    """A transfer, and each tool with its passage at a station of its own (m)."""

    def __init__(self, transfer: Transfer, stations: Sequence[tuple[Tool, Passage]]) -> None:
        self.transfer, pitch = transfer, transfer.stroke
        self.strokes = np.array([tool.stroke for tool, _ in stations], dtype=np.float64)
        self.middles = pitch * STEP * np.arange(len(stations), dtype=np.float64)  # of the stations, across
        # what the transfer leaves open at each: the tool, and what may remain of its stroke on both sides
        self.openings = pitch * (WIDTH + 2.0 * np.array([passage.remaining for _, passage in stations]))
        self.tops = np.array([max(tool.stroke - passage.clearance, 0.0) for tool, passage in stations])  # of it, h − c

    def punch(self, i: int, travel: float) -> Outline:
        """Return the outline of the ``i``-th tool, from 0, that has gone ``travel`` (m)."""
        across, along = np.array(PUNCH).T
        h = self.strokes[i]
        return Outline(self.middles[i] + across * WIDTH * self.transfer.stroke, h - travel + along * BODY * h)

    def walls(self, travel: float) -> Outline:
        """Return the outline of the transfer, station by station; of its walls those in its frame are seen."""
        pitch, (wall, side, up) = self.transfer.stroke, np.array(WALLS, dtype=np.float64).T
        across = travel + pitch * (wall + side) + self.openings[:, None] * (0.5 - side)
        height = np.where(up == 1.0, self.tops[:, None], -PLATE * self.strokes.max())
        return Outline((self.middles[:, None] + np.clip(across, -pitch, pitch)).ravel(), height.ravel())

    def frame(self) -> Outline:
        """Return the frame of the picture, in which every part is at every angle."""
        right, upper = np.array(FRAME, dtype=np.float64).T
        pitch, h = self.transfer.stroke, self.strokes.max()
        across = np.where(right == 1.0, self.middles[-1] + pitch, -pitch)
        return Outline(across, np.where(upper == 1.0, h * (1.0 + BODY), -PLATE * h))


def lane(number: int, travel: Array, stroke: float) -> Array:
    """Return the heights in a timing diagram of a part of that stroke (m) at its travels (m); lanes count from 0."""
    return number + LANE_SHARE * travel / stroke
