"""Siemens S7-1500T as assignments in SCL: basic points of the library LCamHdl, points and segments of TO_Cam."""

import numpy as np

from engine.cams.interpolation import HIGHEST, segment_profile, simple
from engine.laws.base import Array
from engine.motion.profile import CamProfile
from workbook.controllers.table import Table, required_part
from workbook.controllers.target import Target, facts_of
from workbook.controllers.texts import by_index, points
from workbook.errors import TargetError

BASIC = ("leadingValue", "followingValue", "velocityRatio", "accelerationRatio")
POWERS = [f"a{k}" for k in range(HIGHEST + 1)]
SEGMENT = ("xmin", "xmax", *POWERS, "sineAmplitude", "sinePeriod", "sinePhase")
JOINT = 1e-4  # a gap that the controller pulls together


def segment_table(of: CamProfile, x: Array, steps: tuple[float, float]) -> Table:
    """Return a motion between places as segments, of polynomials and a sine from each place."""
    profile = segment_profile(of, x)
    return Table(x, profile.at(x).y, profile=profile)


def segments(table: Table) -> list[tuple[float, ...]]:
    """Return the numbers of each segment; the angular frequency by x stands for ``sinePeriod``."""
    profile = required_part(table.profile, "segments")
    rows = zip(profile.edges, profile.edges[1:], profile.c, profile.sines, strict=False)
    return [(low, high, *c, *sines[0]) for low, high, c, sines in rows]


def read_segments(text: str) -> Table:
    """Return the segments that are assigned; x counts from the begin of each."""
    low, high, *rest = by_index(text, SEGMENT)
    c, (amplitude, omega, phase) = rest[: HIGHEST + 1], rest[HIGHEST + 1 :]
    gaps = np.abs(low[1:] - high[:-1]) > JOINT
    if gaps.any():
        raise TargetError(f"segment {int(gaps.argmax()) + 2} does not begin where the one before it ends")
    x = np.append(low, high[-1])
    Table(x, np.append(c[0], c[0][-1]))  # says which x does not rise
    powers, sine = np.column_stack(c), np.column_stack([amplitude, omega, phase])
    profile = CamProfile(x, low, powers, sine[:, None, :])
    return Table(x, profile.at(x).y, profile=profile)


TARGETS = (
    Target(**facts_of("siemens"), read=lambda text: points(text, by_index(text, BASIC))),
    Target(**facts_of("siemens-points"), read=lambda text: points(text, by_index(text, ("x", "y")))),
    Target(**facts_of("siemens-segments"), read=read_segments, exact=simple, built=segment_table),
)
