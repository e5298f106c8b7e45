"""What whole numbers of a file count, told in its comment and read from there."""

from __future__ import annotations

import re

from workbook.controllers.number import LREAL
from workbook.controllers.structured import NUMBER
from workbook.errors import TargetError

STANDS = re.compile(rf"the axis stands at ({NUMBER}) ")
LARGEST = 1e9  # of a step
TOLD = re.compile(r"one step is (\S{1,30}) (?:\S{1,30}) of x and (\S{1,30}) (?:\S{1,30}) of y")


def counts(steps: tuple[float, float], units: tuple[str, str]) -> str:
    """Return the comment that says what a whole number of x and of y counts."""
    (x, y), (one, other) = steps, (unit.replace(" ", "_") for unit in units)
    return f"one step is {LREAL.text(x)} {one} of x and {LREAL.text(y)} {other} of y"


def read_counts(text: str) -> tuple[float, float]:
    """Return what whole numbers of a file count; 1 where its comment does not say."""
    found = TOLD.search(text)
    if found is None:
        return 1.0, 1.0
    x, y = (float(told) if re.fullmatch(NUMBER, told) else 0.0 for told in found.groups())
    if not (0.0 < x <= LARGEST and 0.0 < y <= LARGEST):
        raise TargetError(f"one step is {found[1]} of x and {found[2]} of y; expected numbers above 0, up to 1e9")
    return x, y


def stands(offset: float, unit: str) -> str:
    """Return the comment that says where the axis is when a cam that begins at 0 begins."""
    return f"the cam begins at y = 0; the axis stands at {LREAL.text(offset)} {unit} there"


def read_stand(text: str) -> float:
    """Return where the axis is when its cam begins; 0 where the comment does not say."""
    found = STANDS.search(text)
    return float(found[1]) if found else 0.0
