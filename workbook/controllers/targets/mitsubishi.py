"""Mitsubishi cam data, whole numbers in text: coordinates in columns, or stroke ratios at equal steps in one."""

import numpy as np

from engine.cams.certificate import equal_steps
from engine.laws.base import Array
from engine.motion.profile import CamProfile
from workbook.controllers.table import Table
from workbook.controllers.target import CamExport, Target, facts_of
from workbook.controllers.texts import DINT, Number, as_lines, counts, numbers, read_counts, read_stand, remarks, stands
from workbook.errors import TargetError

WHOLE = 1_000_000_000  # a ratio of 100 %, in steps of 1e-7 %
RESOLUTIONS = tuple(2**k for k in range(8, 16))


def write(handed: CamExport) -> str:
    """Return comments, and X and Y of each coordinate."""
    steps = handed.table.steps
    head = remarks(*handed.header, counts(steps, handed.units), f"X{handed.separator}Y")
    columns = (values / step for values, step in zip((handed.table.x, handed.table.y), steps, strict=True))
    return head + as_lines(columns, handed.separator, handed.decimal, DINT)


def whole(values: Array) -> Array:
    """Return whole numbers of 32 bits; raise TargetError for others."""
    if not np.all((np.abs(values) <= DINT.largest) & (values == np.round(values))):
        raise TargetError("a value is no whole number of 32 bits; expected such")
    return values


def read(text: str) -> Table:
    """Return the coordinates, in the units that the comment names."""
    steps = read_counts(text)
    x, y = np.array(numbers(text, (2,))).T
    return Table(np.round(whole(x) * steps[0], 12), np.round(whole(y) * steps[1], 12))


def ratio_table(of: CamProfile, x: Array, steps: tuple[float, float]) -> Table:
    """Return the ratios of a motion at equal steps: the stroke is the farthest that it goes from where it begins."""
    places = equal_steps(of, len(x))
    if places[0] != 0.0:
        raise TargetError(f"x begins at {places[0]:.9g}; expected 0, where the first ratio is")
    y = of.at(places).y
    stroke = float(np.abs(y - y[0]).max()) or steps[1]
    return table(np.round((y - y[0]) / stroke * WHOLE), (of.total / (len(x) - 1), stroke / WHOLE), float(y[0]))


def table(ratios: Array, steps: tuple[float, float], offset: float) -> Table:
    """Return ratios, the first of them 0, in the units of x and y."""
    return Table(np.arange(float(len(ratios))) * steps[0], offset + ratios * steps[1], steps=steps)


def write_ratios(handed: CamExport) -> str:
    """Return comments, the resolution, and a ratio a line; that at the begin is 0 and is not written."""
    given = handed.table
    head = remarks(*handed.header, stands(float(given.y[0]), handed.units[1]), counts(given.steps, handed.units))
    ratios = (given.y[1:] - given.y[0]) / given.steps[1]
    return f"{head}{len(ratios)}\r\n" + as_lines([ratios], number=DINT)


def read_ratios(text: str) -> Table:
    """Return the ratios behind the resolution, in the units that the comment names."""
    (ratios,) = np.array(numbers(text, (1,), counted=True)).T
    if len(ratios) not in RESOLUTIONS:
        raise TargetError(f"{len(ratios):,} ratios; expected one of {', '.join(map(str, RESOLUTIONS))}")
    return table(np.append(0.0, whole(ratios)), read_counts(text), read_stand(text))


TARGETS = (
    Target(**facts_of("mitsubishi"), write=write, read=read, number=DINT),
    Target(
        **facts_of("mitsubishi-ratio"),
        write=write_ratios,
        read=read_ratios,
        number=Number("DINT, 1e-7 %", DINT.largest),
        points=(RESOLUTIONS[0] + 1, RESOLUTIONS[-1] + 1),
        counts=tuple(n + 1 for n in RESOLUTIONS),
        built=ratio_table,
    ),
)
