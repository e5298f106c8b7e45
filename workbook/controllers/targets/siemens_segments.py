"""Siemens S7-1500T: segments of TO_Cam, polynomials of degree 6 with a sine, as assignments in SCL."""

from __future__ import annotations

import numpy as np

from engine.cams.interpolation import HIGHEST, segmented, simple
from engine.cams.profile import CamProfile, ProfilePiece, profile
from engine.laws.base import Array
from workbook.controllers.number import LREAL, literal
from workbook.controllers.structured import assigned, comments, indexed
from workbook.controllers.table import Table
from workbook.controllers.target import Claim, Handed, Target
from workbook.errors import TargetError

POWERS = tuple(f"a{k}" for k in range(HIGHEST + 1))
FIELDS = ("xmin", "xmax", *POWERS, "sineAmplitude", "sinePeriod", "sinePhase")
HELP = "Siemens TIA help, S7-1500/S7-1500T synchronous operation, tags of the cam"
JOINT = 1e-4
"""a gap that the controller pulls together"""


def built(of: CamProfile, x: Array, steps: tuple[float, float]) -> Table:
    """Return a motion between places as segments, of polynomials and a sine from each place."""
    made = segmented(of, x)
    at = made.at(x, left=True)
    return Table(x, np.append(made.at(x[:-1]).y, at.y[-1]), profile=made)


def write(handed: Handed) -> str:
    """Return the assignments, a line a segment; ``sinePeriod`` is taken for the angular frequency by x."""
    made, name, lines = handed.table.profile, f"Cam_{handed.name}", []
    if made is None:
        raise TargetError("the table has no segments")
    for k, (low, high, c, sines) in enumerate(zip(made.edges, made.edges[1:], made.c, made.sines, strict=False), 1):
        values = [low, high, *c, *sines[0]]
        texts = (literal(LREAL.text(float(value))) for value in values)
        fields = dict(zip(FIELDS, texts, strict=True))
        lines.append(f"{assigned(f'{name}.Segment[{k}]', fields)} {name}.ValidSegment[{k}] := TRUE;")
    declared = f"{name} : TO_Cam; MC_InterpolateCam comes before its use; segments beyond these stay invalid"
    return comments([*handed.header, declared]) + "".join(f"{line}\n" for line in lines)


def read(text: str) -> Table:
    """Return the segments that are assigned; x counts from the begin of each."""
    low, high, *rest = indexed(text, FIELDS)
    c, (amplitude, omega, phase) = rest[: HIGHEST + 1], rest[HIGHEST + 1 :]
    gaps = np.abs(low[1:] - high[:-1]) > JOINT
    if gaps.any():
        raise TargetError(f"segment {int(gaps.argmax()) + 2} does not begin where the one before it ends")
    x = np.append(low, high[-1])
    points = Table(x, np.append(c[0], c[0][-1]))  # says which x does not rise
    made = profile(
        [ProfilePiece(float(low[k]), float(low[k]), tuple(float(one[k]) for one in c),
                      ((amplitude[k], omega[k], phase[k]),))
         for k in range(len(low))], float(high[-1]),
    )  # fmt: skip
    return Table(points.x, np.append(made.at(x[:-1]).y, made.at(x[-1:], left=True).y), profile=made)


TARGET = Target(
    "siemens-segments",
    "Siemens S7-1500T, segments of TO_Cam in SCL",
    ".scl",
    ("segments",),
    ("polynomials",),
    write,
    read,
    (
        Claim("fields of Segment, LREAL, at most 50; Y = Σ a_k x^k + b0 sin(b1 x + b2)", "documented", HELP),
        Claim("x counts from xmin; it may also be absolute or from 0 to 1: read one segment back first", "untested",
              "no document says it"),
        Claim("sinePeriod holds b1, rad by x", "untested", "the help names it a length in rad"),
    ),
    points=(2, 51),
    spacing="breaks",
    exact=simple,
    built=built,
)  # fmt: skip
