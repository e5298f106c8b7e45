"""Siemens S7-1500T as assignments in SCL: basic points of the library LCamHdl, points and segments of TO_Cam."""

import numpy as np

from engine.cams.interpolation import HIGHEST, segmented, simple
from engine.laws.base import Array
from engine.motion.pieces import CamProfile
from workbook.controllers.number import literal
from workbook.controllers.structured import assigned, comments, indexed, points, rows
from workbook.controllers.table import SPLINES, Table, given
from workbook.controllers.target import Handed, Target
from workbook.errors import TargetError

BASIC = ("leadingValue", "followingValue", "velocityRatio", "accelerationRatio")
SEGMENT = ("xmin", "xmax", *(f"a{k}" for k in range(HIGHEST + 1)), "sineAmplitude", "sinePeriod", "sinePhase")
JOINT = 1e-4  # a gap that the controller pulls together


def write(handed: Handed) -> str:
    """Return the assignments, a line a point."""
    name = f"Cam_{handed.name}"
    lines = [assigned(f"{name}[{k}]", row) for k, row in enumerate(rows(handed.table, BASIC), 1)]
    declared = f"{name} : ARRAY[1..{len(lines)}] OF LCamHdl_typeBasicPoint, for CreateCamBasic"
    return comments([*handed.header, declared]) + "".join(f"{line}\n" for line in lines)


def write_points(handed: Handed) -> str:
    """Return the assignments of the points, and of how to go between them."""
    name = f"Cam_{handed.name}"
    lines = [f"{assigned(f'{name}.Point[{k}]', row)} {name}.ValidPoint[{k}] := TRUE;"
             for k, row in enumerate(rows(handed.table, ("x", "y")), 1)]  # fmt: skip
    lines.append(f"{name}.InterpolationSettings.InterpolationMode := 1;")
    lines.append(f"{name}.InterpolationSettings.BoundaryConditions := {int(handed.repeats)};")
    declared = f"{name} : TO_Cam; MC_InterpolateCam comes before its use; points beyond these stay invalid"
    return comments([*handed.header, declared]) + "".join(f"{line}\n" for line in lines)


def built(of: CamProfile, x: Array, steps: tuple[float, float]) -> Table:
    """Return a motion between places as segments, of polynomials and a sine from each place."""
    made = segmented(of, x)
    return Table(x, made.at(x).y, profile=made)


def write_segments(handed: Handed) -> str:
    """Return the assignments, a line a segment; ``sinePeriod`` is taken for the angular frequency by x."""
    made, name, lines = given(handed.table.profile, "segments"), f"Cam_{handed.name}", []
    for k, (low, high, c, sines) in enumerate(zip(made.edges, made.edges[1:], made.c, made.sines, strict=False), 1):
        texts = (literal(value) for value in (low, high, *c, *sines[0]))
        fields = dict(zip(SEGMENT, texts, strict=True))
        lines.append(f"{assigned(f'{name}.Segment[{k}]', fields)} {name}.ValidSegment[{k}] := TRUE;")
    declared = f"{name} : TO_Cam; MC_InterpolateCam comes before its use; segments beyond these stay invalid"
    return comments([*handed.header, declared]) + "".join(f"{line}\n" for line in lines)


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
    made = CamProfile(x, low, powers, sine[:, None, :])
    return Table(x, made.at(x).y, profile=made)


TARGETS = (
    Target(
        "siemens", "Siemens S7-1500T, LCamHdl basic points in SCL", ".scl", ("x", "y", "y'", "y''"), ("quintics",),
        write, lambda text: points(text, indexed(text, BASIC)), points=(2, 51),
    ),
    Target(
        "siemens-points", "Siemens S7-1500T, points of TO_Cam in SCL", ".scl", ("x", "y"), SPLINES,
        write_points, lambda text: points(text, indexed(text, ("x", "y"))), points=(2, 1000),
    ),
    Target(
        "siemens-segments", "Siemens S7-1500T, segments of TO_Cam in SCL", ".scl", ("segments",), ("polynomials",),
        write_segments, read_segments, points=(2, 51), spacing="breaks", exact=simple, built=built,
    ),
)  # fmt: skip
