"""B&R: the polynomials of McCamDataType in REAL, as assignments in Structured Text."""

import numpy as np

from engine.cams.interpolation import quintics_between
from engine.laws.base import Array
from engine.motion.pieces import CamProfile
from workbook.controllers.number import DINT, DINT_IN_REAL, REAL, counts, literal, read_counts, read_stand, stands
from workbook.controllers.structured import assigned, comments, indexed, scalar
from workbook.controllers.table import Table, given
from workbook.controllers.target import Handed, Target
from workbook.errors import TargetError

POWERS = ("A", "B", "C", "D", "E", "F", "G")
FIELDS = (*POWERS, "X")


def built(of: CamProfile, x: Array, steps: tuple[float, float]) -> Table:
    """Return a motion between places as polynomials of degree 5 whose coefficients, in steps, are rounded to REAL."""
    dx, dy = steps
    Table(x, x)  # says which x does not rise
    both = of.at(x[:-1]), of.at(x[1:], left=True)
    offset = float(both[0].y[0])
    begin, end = ([(one.y - offset) / dy, one.y1 * dx / dy, one.y2 * dx**2 / dy] for one in both)
    coefficients = REAL.rounded(quintics_between(x / dx, begin, end))
    coefficients[0, 0] = 0.0
    return table(coefficients, DINT.rounded(x / dx), steps, offset)


def table(c: Array, x: Array, steps: tuple[float, float], offset: float = 0.0) -> Table:
    """Return the polynomials, in steps from each place, as a table in the units of x and y."""
    dx, dy = steps
    places = np.round(x * dx, 12)
    Table(places, places)  # says which x does not rise
    powers = c * dy / dx ** np.arange(c.shape[1])
    made = CamProfile(places, places[:-1], powers, np.zeros((len(powers), 0, 3)))
    made.c[:, 0] += offset
    return Table(places, made.at(places).y, profile=made, steps=steps)


def write(handed: Handed) -> str:
    """Return the assignments of the periods and of each polynomial; x counts from the begin of each."""
    made, name = given(handed.table.profile, "polynomials"), f"Cam_{handed.name}"
    (dx, dy), offset = handed.table.steps, float(made.c[0, 0])
    lines = [
        f"{name}.MasterPeriod := {DINT.text(made.total / dx)}; {name}.SlavePeriod := {DINT.text(made.travel / dy)};",
        f"{name}.PolynomialNumber := {len(made.c)};",
    ]
    for k, (row, end) in enumerate(zip(made.c, made.edges[1:], strict=True)):
        scales = [dx**i / dy for i in range(len(row))]
        constant = (row[0] - offset) / dy
        values = [constant, *(float(c) * one for c, one in zip(row[1:], scales[1:], strict=True))]
        values += [0.0 for _ in range(len(POWERS) - len(values))]
        texts = [literal(value, REAL) for value in (*values, round((end - made.edges[0]) / dx))]
        fields = dict(zip(FIELDS, texts, strict=True)) | {"Reserve": "0"}
        lines.append(assigned(f"{name}.PolynomialData[{k}]", fields))
    told = (stands(offset, handed.units[1]), counts((dx, dy), handed.units), f"{name} : McCamDataType")
    return comments([*handed.header, *told]) + "".join(f"{one}\n" for one in lines)


def read(text: str) -> Table:
    """Return the polynomials that are assigned, in the units that the comment names."""
    *powers, ends = indexed(text, FIELDS)
    period = scalar(text, "MasterPeriod")
    if period is not None and period != ends[-1]:
        raise TargetError(f"the last X is {ends[-1]:g}, MasterPeriod {period:g}; expected the same")
    x = np.concatenate([[0.0], ends])
    return table(REAL.rounded(np.array(powers).T), x, read_counts(text), read_stand(text))


TARGETS = (
    Target(
        "br", "B&R, polynomials of McCamDataType in Structured Text", ".st", ("polynomials",), ("quintics",),
        write, read, number=DINT_IN_REAL, points=(2, 129), built=built,
    ),
)  # fmt: skip
