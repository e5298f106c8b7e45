"""B&R: the polynomials of McCamDataType in REAL, as assignments in Structured Text."""

from collections.abc import Iterator

import numpy as np

from engine.cams.interpolation import quintics_between
from engine.laws.base import Array
from engine.motion.profile import CamProfile
from workbook.controllers import texts
from workbook.controllers.table import Table, required_part
from workbook.controllers.target import Target, facts_of
from workbook.errors import TargetError

POWERS = ("A", "B", "C", "D", "E", "F", "G")
FIELDS = (*POWERS, "X")


def polynomial_table(of: CamProfile, x: Array, steps: tuple[float, float]) -> Table:
    """Return a motion between places as polynomials of degree 5 whose coefficients, in steps, are rounded to REAL."""
    dx, dy = steps
    Table(x, x)  # says which x does not rise
    both = of.at(x[:-1]), of.at(x[1:], left=True)
    offset = float(both[0].y[0])
    begin, end = ([(end.y - offset) / dy, end.y1 * dx / dy, end.y2 * dx**2 / dy] for end in both)
    coefficients = texts.REAL.rounded(quintics_between(x / dx, begin, end))
    coefficients[0, 0] = 0.0
    return table(coefficients, texts.DINT.rounded(x / dx), steps, offset)


def table(c: Array, x: Array, steps: tuple[float, float], offset: float = 0.0) -> Table:
    """Return the polynomials, in steps from each place, as a table in the units of x and y."""
    dx, dy = steps
    places = np.round(x * dx, 12)
    Table(places, places)  # says which x does not rise
    powers = c * dy / dx ** np.arange(c.shape[1])
    profile = CamProfile(places, places[:-1], powers, np.zeros((len(powers), 0, 3)))
    profile.c[:, 0] += offset
    return Table(places, profile.at(places).y, profile=profile, steps=steps)


def offset(table: Table) -> float:
    """Return where the axis is when its cam begins."""
    return float(required_part(table.profile, "polynomials").c[0, 0])


def polynomials(table: Table) -> Iterator[list[float]]:
    """Yield the coefficients of each polynomial in steps from its begin, and where it ends."""
    profile, (dx, dy) = required_part(table.profile, "polynomials"), table.steps
    for row, end in zip(profile.c, profile.edges[1:], strict=True):
        scaled = [float(c) * (dx**i / dy) for i, c in enumerate(row)]
        scaled[0] = (row[0] - offset(table)) / dy
        yield [*scaled, *[0.0] * (len(POWERS) - len(row)), round((end - profile.edges[0]) / dx)]


def read(text: str) -> Table:
    """Return the polynomials that are assigned, in the units that the comment names."""
    *powers, ends = texts.by_index(text, FIELDS)
    period = texts.assigned_number(text, "MasterPeriod")
    if period is not None and period != ends[-1]:
        raise TargetError(f"the last X is {ends[-1]:g}, MasterPeriod {period:g}; expected the same")
    x = np.concatenate([[0.0], ends])
    return table(texts.REAL.rounded(np.array(powers).T), x, texts.read_counts(text), texts.read_stand(text))


TARGETS = (Target(**facts_of("br"), read=read, number=texts.DINT_IN_REAL, built=polynomial_table),)
