"""Mitsubishi: cam data as stroke ratios at equal steps, whole numbers in a column of text."""

from __future__ import annotations

import numpy as np

from engine.cams.points import equal
from engine.cams.profile import CamProfile
from engine.laws.base import Array
from workbook.controllers.number import DINT, Number, whole
from workbook.controllers.table import Table
from workbook.controllers.target import Claim, Handed, Target
from workbook.controllers.text import joined, numbers
from workbook.controllers.units import counts, read_counts, read_stand, stands
from workbook.errors import TargetError

MANUAL = "Mitsubishi RD77MS advanced synchronous control manual, p. 51"
WHOLE = 1_000_000_000
"""a ratio of 100 %, in steps of 1e-7 %"""
RESOLUTIONS = tuple(2**k for k in range(8, 16))


def built(of: CamProfile, x: Array, steps: tuple[float, float]) -> Table:
    """Return the ratios of a motion at equal steps: the stroke is the farthest that it goes from where it begins."""
    places = equal(of, len(x))
    if places[0] != 0.0:
        raise TargetError(f"x begins at {places[0]:.9g}; expected 0, where the first ratio is")
    y = np.append(of.at(places[:-1]).y, of.at(places[-1:], left=True).y)
    stroke = float(np.abs(y - y[0]).max()) or steps[1]
    return table(np.round((y - y[0]) / stroke * WHOLE), (of.total / (len(x) - 1), stroke / WHOLE), float(y[0]))


def table(ratios: Array, steps: tuple[float, float], offset: float) -> Table:
    """Return ratios, the first of them 0, in the units of x and y."""
    return Table(np.arange(float(len(ratios))) * steps[0], offset + ratios * steps[1], steps=steps)


def write(handed: Handed) -> str:
    """Return comments, the resolution, and a ratio a line; that at the begin is 0 and is not written."""
    made = handed.table
    told = (stands(float(made.y[0]), handed.units[1]), counts(made.steps, handed.units))
    ratios = np.round((made.y[1:] - made.y[0]) / made.steps[1])
    head = "".join(f"# {line}\r\n" for line in (*handed.header, *told))
    return f"{head}{len(ratios)}\r\n" + joined([[DINT.text(float(one))] for one in ratios])


def read(text: str) -> Table:
    """Return the ratios behind the resolution, in the units that the comment names."""
    (ratios,) = np.array(numbers(text, (1,), counted=True)).T
    if len(ratios) not in RESOLUTIONS:
        raise TargetError(f"{len(ratios):,} ratios; expected one of {', '.join(map(str, RESOLUTIONS))}")
    return table(np.append(0.0, whole(ratios)), read_counts(text), read_stand(text))


TARGET = Target(
    "mitsubishi-ratio",
    "Mitsubishi, stroke ratios of cam data",
    ".csv",
    ("y",),
    ("straight lines",),
    write,
    read,
    (
        Claim("256 to 32,768 ratios, powers of 2, of 32 bits, in steps of 1e-7 % of the stroke", "documented", MANUAL),
        Claim("straight lines between ratios at equal steps", "documented", MANUAL),
        Claim("the ratio at the begin is 0 and no number of its own", "probable", MANUAL),
        Claim("the file that the engineering tool imports: these are the numbers alone", "untested", "not found"),
    ),
    number=Number("DINT, 1e-7 %", DINT.largest),
    points=(RESOLUTIONS[0] + 1, RESOLUTIONS[-1] + 1),
    counts=tuple(n + 1 for n in RESOLUTIONS),
    spacing="equal",
    tolerance=(("y", 1e-4), ("v", 0.01)),
    built=built,
)
