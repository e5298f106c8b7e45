"""Siemens S7-1500T as assignments in SCL: basic points of the library LCamHdl, points and segments of TO_Cam."""

import numpy as np

from engine.cams.interpolation import HIGHEST, segmented, simple
from engine.laws.base import Array
from engine.motion.profile import CamProfile
from workbook.controllers.table import SPLINES, Table, required_part
from workbook.controllers.target import Target, by_template
from workbook.controllers.texts import indexed, points
from workbook.errors import TargetError

BASIC = ("leadingValue", "followingValue", "velocityRatio", "accelerationRatio")
SEGMENT = ("xmin", "xmax", *(f"a{k}" for k in range(HIGHEST + 1)), "sineAmplitude", "sinePeriod", "sinePhase")
JOINT = 1e-4  # a gap that the controller pulls together


def built(of: CamProfile, x: Array, steps: tuple[float, float]) -> Table:
    """Return a motion between places as segments, of polynomials and a sine from each place."""
    profile = segmented(of, x)
    return Table(x, profile.at(x).y, profile=profile)


def segments(table: Table) -> list[tuple[float, ...]]:
    """Return the numbers of each segment; the angular frequency by x stands for ``sinePeriod``."""
    profile = required_part(table.profile, "segments")
    rows = zip(profile.edges, profile.edges[1:], profile.c, profile.sines, strict=False)
    return [(low, high, *c, *sines[0]) for low, high, c, sines in rows]


def read_segments(text: str) -> Table:
    """Return the segments that are assigned; x counts from the begin of each."""
    low, high, *rest = indexed(text, SEGMENT)
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
    Target("siemens", "Siemens S7-1500T, LCamHdl basic points in SCL", ".scl", ("x", "y", "y'", "y''"), ("quintics",),
           by_template("siemens.scl"), lambda text: points(text, indexed(text, BASIC)), points=(2, 51)),
    Target("siemens-points", "Siemens S7-1500T, points of TO_Cam in SCL", ".scl", ("x", "y"), SPLINES,
           by_template("siemens-points.scl"), lambda text: points(text, indexed(text, ("x", "y"))), points=(2, 1000)),
    Target("siemens-segments", "Siemens S7-1500T, segments of TO_Cam in SCL", ".scl", ("segments",), ("polynomials",),
           by_template("siemens-segments.scl", segments=segments, fields=SEGMENT), read_segments,
           points=(2, 51), spacing="breaks", exact=simple, built=built),
)  # fmt: skip
