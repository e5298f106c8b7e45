"""Files of controllers, from anywhere: read under a limit, and refused in one line where they are no table."""

import re
from pathlib import Path

import numpy as np

from workbook.controllers.table import Table
from workbook.controllers.target import Target
from workbook.errors import ReadError, TargetError
from workbook.intake import read_text

MOST = 8_000_000  # bytes: a tag of 25,000 points
LARGEST = 1e12  # of x, y and derivatives
NARROWEST, SHORTEST = 1e-9, 1e-12  # of the whole of x, and of its unit: the smallest step from point to point
TOLD = re.compile(r"; ([0-9]{1,9}) points(?: at equal steps)?; between them")


def read_table(path: Path, target: Target) -> Table:
    """Return the table of a target's file; raise ReadError, in one line, where it is none."""
    text = text_of(path, target)
    try:
        return parsed(text, target)
    except TargetError as error:
        raise ReadError(f"{path}: {error}") from None


def text_of(path: Path, target: Target) -> str:
    """Return the text of a target's file, without what ends a text of old."""
    return read_text(path, f"a file for {target.name}", MOST, foreign=True).rstrip("\x1a\x00")


def parsed(text: str, target: Target) -> Table:
    """Return the table of a text; raise TargetError where it is none, or has not the points that its header tells."""
    with np.errstate(over="ignore", invalid="ignore"):  # what is not finite is refused by point
        table = target.read(text)
    require_usual(table)
    told = TOLD.search(text)
    if told and int(told[1]) != len(table.x):
        raise TargetError(f"{len(table.x)} points; its header tells {told[1]} (is the file cut off?)")
    return table


def require_usual(table: Table) -> None:
    """Raise TargetError for a number so large, or a step of x so small, that no motion has it: fits would overflow."""
    for name, column in table.columns.items():
        size = np.abs(column)
        if size.max() > LARGEST:
            k = int(size.argmax())
            raise TargetError(f"point {k + 1}: {name} is {column[k]:.6g}; expected at most {LARGEST:.0e} either way")
    least = max(SHORTEST, NARROWEST * float(table.x[-1] - table.x[0]))
    steps = np.diff(table.x)
    if steps.min() < least:
        k = int(steps.argmin())
        raise TargetError(f"point {k + 2}: x rises by {steps[k]:.3g}; expected a step of at least {least:.3g}")
    if table.profile is not None:  # a stretch's largest term: of its polynomial, or a sine's amplitude, angle or phase
        of = table.profile
        far = np.maximum(np.abs(of.edges[:-1] - of.origins), np.abs(of.edges[1:] - of.origins))[:, None]
        with np.errstate(over="ignore", invalid="ignore", under="ignore"):
            powers = np.abs(of.c) * far ** np.arange(of.c.shape[1])
            amplitude, rate, phase = np.moveaxis(np.abs(of.sines), 2, 0)
            terms = np.hstack([powers, amplitude, rate * far, phase]).max(axis=1)
        if not np.all(terms <= LARGEST):
            k = int(np.argmin(terms <= LARGEST))
            raise TargetError(f"segment {k + 1}: a term reaches {terms[k]:.3g}; expected at most {LARGEST:.0e}")


def header(points: int, between: str, equal: bool, units: tuple[str, str]) -> str:
    """Return the line of a header that tells units, points, whether at equal steps, and what is between them."""
    counted = f"{points} points{' at equal steps' if equal else ''}"
    return f"x in {units[0]}, y in {units[1]}; {counted}; between them {between}"
