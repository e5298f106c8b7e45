"""Machines made up for the targets: the four points of the reference, and random motions."""

import random
from pathlib import Path

import numpy as np

from engine import law
from engine.cams.interpolation import quintics
from engine.laws import Dwell
from engine.motion import Motion, Phase
from engine.motion.profile import profile_of_motion
from tests.engine.laws.claims import CLAIMS
from workbook.build import build
from workbook.controllers.tabulation import table_at
from workbook.controllers.target import CamExport, Target
from workbook.reading.descriptions import read_machine
from workbook.template_outputs import CamAxis

X, Y = np.array([0.0, 90.0, 180.0, 360.0]), np.array([0.0, 15.0, 30.0, 0.0])
SLOPES = np.array([0.0, 0.25, 0.0, 0.0])
FOUR = CamAxis("Demo", quintics(X, Y, SLOPES, np.zeros(4)), "°", "mm")
"""rise over 0 to 180 with a slope of 0.25 on the way, back over 180 to 360"""
FIVE = np.insert(X, 3, 270.0)
MOVING = [one.law for one in CLAIMS if one.law is not Dwell and min(one.orders) >= 2]
"""laws whose acceleration does not jump"""


TEXT = """\
template = "machine"
title = "Two axes"
[master]
rate = 60.0
[sizes]
cycle = 4
law = 4
phases = 2
[[axes]]
name = "Press"
group = "One"
phases = [
  { start = 90.0, stop = 135.0, lift = 20.0, law = "MTP" },
  { start = 305.0, stop = 350.0, lift = -20.0, law = "MTP" },
]
[[axes]]
name = "Feed 2"
group = "One"
closes = "feed"
phases = [ { start = 0.0, stop = 80.0, lift = 300.0, law = "CIC" } ]
"""
"""a small machine of two axes"""


def build_described(text: str, book: Path) -> Path:
    """Build the book of a description, which is written beside it; return where."""
    path = book.with_suffix(".toml")
    path.write_text(text, encoding="utf-8")
    build(read_machine(path), book)
    return path


def handed(target: Target, axis: CamAxis = FOUR, x: np.ndarray | None = None) -> CamExport:
    """What the writer of a target is given of an axis."""
    few = np.linspace(0.0, 360.0, target.counts[0]) if target.counts else FIVE if target.points[0] > 4 else X
    places = few if x is None else x
    units = axis.x_unit, axis.y_unit
    return CamExport(table_at(target, axis.profile, places, units), axis.name, ("an example",), units)


def random_axis(seed: int) -> CamAxis:
    """An axis over a turn: rises, returns and dwells by laws of the catalogue, back to where it began."""
    dice = random.Random(seed)
    durations = np.array([dice.uniform(0.5, 1.0) for _ in range(4)])
    *first, last = (360.0 * durations / durations.sum()).tolist()
    lift = round(dice.uniform(5.0, 300.0), 2)
    rise, back = (dice.choice(MOVING)() for _ in range(2))
    rest = law("dwell")
    phases = [
        Phase(rise, lift, first[0]),
        Phase(rest, 0.0, first[1]),
        Phase(back, -lift, first[2]),
        Phase(rest, 0.0, last),
    ]
    return CamAxis(f"axis {seed}", profile_of_motion(Motion(phases)), "°", "mm")
