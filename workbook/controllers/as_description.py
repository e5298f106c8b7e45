"""A controller's table as the description of a machine of one axis: rests, laws, and laws of its own for the rest."""

import math
import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from engine.cams.cam_points import CamPoints, FoundPhase, precision
from engine.cams.certificate import subdivide_intervals
from engine.cams.identify import THINNED, IdentifiedMotion, identify
from engine.laws.spline import Spline
from engine.motion.profile import CamProfile
from workbook.controllers.table import Table
from workbook.controllers.tabulation import rules_of
from workbook.controllers.target import Target
from workbook.controllers.texts import Units
from workbook.entries.abscissa import ENTERED, length_abscissa
from workbook.entries.abscissa import UNITS as MEASURES
from workbook.entries.machine import Sizes
from workbook.errors import TargetError
from workbook.fields.units import shown, si
from workbook.laws.registry import CODES

UNITS = re.compile(r"x in (\S{1,12}), y in (\S{1,12});")
TURN = 360.0
AXIS = "Read"
RATES = ("velocity", "acceleration")
AS_FAST = 1e-3  # of the peak: so far what a cycle ends with may be from what it begins with
BETWEEN = 8  # places of a polynomial
NEXT = 1e-9  # of the cycle: phases so near to each other meet


def phases_of(target: Target, table: Table, units: Units = ("", ""), share: float = THINNED) -> IdentifiedMotion:
    """Return the movements that a table was built of: laws, or splines that are off by at most a share of the reach."""
    rebuilt = next(iter(rules_of(target, table).values())).rebuild(table)
    known = precision(table.y)
    if table.steps[1] != 1.0:
        known = max(known, 0.5 * table.steps[1])
    turns = units[0] == "°" and units[1] in ("mm", "°") and table.x[0] == 0.0 and table.x[-1] == TURN
    # y' alone is nobody's rule: as a rule it was built of differences
    v = None if table.a is None else table.v
    points = CamPoints(table.x, table.y, v, table.a, known)
    # polynomials that are exact everywhere
    if table.profile is not None and table.steps == (1.0, 1.0):
        x = subdivide_intervals(table.x, BETWEEN)
        at = table.profile.at(x, left=True)
        points = CamPoints(x, at.y, at.y1, None, known)
    elif table.profile is not None:  # polynomials of whole steps are fitted to the motion, and keep to it at their ends
        at = table.profile.at(table.x)
        points = CamPoints(table.x, at.y, at.y1, at.y2, known)
    return identify(points, rebuilt, turns, share)


def movement_lines(read: IdentifiedMotion, units: Units) -> list[str]:
    """Return a line for each movement: its law, from where to where, its lift, and what the table is off by."""
    x, y = units
    lines = []
    for phase in read.phases:
        points = len(phase.law.as_pieces()) + 1
        name = phase.law.name if phase.known else f"no law of the registry, a cubic spline through {points} points"
        misses = "" if phase.fits else "; so many points do not do"
        v = phase.rates(0)[0]
        misses += f"; begins with {v:.6g} {y}/{x}" if v else ""
        place = f"{phase.begin + read.delay:.9g}–{phase.end + read.delay:.9g} {x}"
        lines.append(f"{place}: {name}, lift {phase.lift:.9g} {y}, residual {phase.residual:.2g} {y}{misses}")
    return lines


def require_points(read: IdentifiedMotion, table: Table, profile: CamProfile, units: Units) -> str:
    """Return a line with the largest deviation of a described motion from a table's points; raise TargetError."""
    x = table.x - table.x[0] + profile.edges[0]
    off = np.abs(profile.at(x, left=bool(x[-1] >= profile.edges[-1])).y - table.y)
    k = int(off.argmax())
    error = f"{off[k]:.2g} {units[1]} at {table.x[k]:.9g} {units[0]}"
    if off[k] > read.allowed:
        raise TargetError(
            f"the motion that was found is off by {error}, {read.allowed:.2g} {units[1]} allowed; "
            "--tolerance y=1% allows more"
        )
    return f"It keeps to all {len(x):,} points: off by {error} at most"


def require_describable(movements: Sequence[FoundPhase], x: str, y: str) -> None:
    """Raise TargetError where no axis has these units, or a movement keeps to no law."""
    if x not in MEASURES or y not in ENTERED:
        expected = f"{' or '.join(ENTERED)} over {', '.join(MEASURES)}"
        raise TargetError(f"it is in {y} over {x}; expected an axis in {expected}")
    if misfit := next((p for p in movements if not p.fits), None):
        raise TargetError(
            f"from {misfit.begin:.9g} to {misfit.end:.9g} it keeps to no law, and splines through some points are too "
            "far from the others; --tolerance y=1% allows more"
        )


def compose(read: IdentifiedMotion, table: Table, units: Units, title: str) -> dict[str, Any]:
    """Return the description of a machine of one axis, without its rate; raise TargetError for what none can have."""
    movements = read.phases
    require_describable(movements, *units)
    begin, end = float(table.x[0]), float(table.x[-1])
    near = NEXT * (end - begin)
    laws, phases = compose_phases(movements, begin, near, units)
    phases = phases or [{"law": "DWL", "lift": 0.0, "start": 0.0, "stop": tidied(end - begin)}]
    travel = math.fsum(p.lift for p in movements)
    closes = abs(travel) <= NEXT * max((abs(p.lift) for p in movements), default=1.0)
    if movements and end - movements[-1].end <= near:
        require_end(movements, closes, near + begin)
    # the acceleration of a spline begins and ends so
    jumps = any(p.law.code == Spline.code for p in movements)
    axis = {
        "name": AXIS,
        "group": "Read",
        "unit": units[1],
        "smoothness": "velocity" if jumps else "acceleration",
        "closes": "position" if closes else "feed" if read.delay else "open",
        "shift": tidied(read.delay),
        "position": float(movements[0].y if movements else table.y[0]),
        "phases": phases,
    }
    master = {"cycle": tidied(end - begin), "unit": units[0]}
    points = max((len(p.law.points) for p in movements if isinstance(p.law, Spline)), default=0)
    rows = {"points": points, "phases": len(phases)}
    # usually there is room
    sizes = {name: count for name, count in rows.items() if count > getattr(Sizes(), name)}
    data = {"template": "machine", "title": title, "laws": laws, "sizes": sizes}
    return data | {"master": master, "axes": [axis]}


def compose_phases(
    movements: Sequence[FoundPhase], begin: float, near: float, units: Units
) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """Return the entries of laws and phases of movements in a cycle from ``begin``, joined within ``near``."""
    laws: dict[str, Any] = {} if all(p.rests for p in movements) else {"LIN": {"family": "LIN"}}
    phases: list[dict[str, Any]] = []
    reached = begin
    for k, p in enumerate(movements):
        name, law = law_entry(p, k)
        laws |= law
        start = p.begin if p.begin - reached > near else reached
        reached = p.end
        places = {"start": tidied(start - begin), "stop": tidied(reached - begin)}
        phases.append({"law": name, "lift": p.lift, **places, **boundary_rates(movements, k, near, units)})
    return laws, phases


def require_end(phases: Sequence[FoundPhase], closes: bool, begin: float) -> None:
    """Raise TargetError where the last phase ends on the way, and the first does not take over what it ends with."""
    last, other = phases[-1], phases[0]
    if last.law.code == "LIN" or not any(last.rates(1)):
        return
    taken = (other.lift / (other.end - other.begin), 0.0) if other.law.code == "LIN" else other.rates(0)
    size = abs(last.lift) if isinstance(last.law, Spline) else 1.0
    near = (AS_FAST * size * last.law.coefficients.cv, AS_FAST * size * last.law.coefficients.ca)
    span = last.end - last.begin
    steps = enumerate(zip(last.rates(1), taken, near, strict=True), 1)
    jumps = any(abs(a - b) * span**k > most for k, (a, b, most) in steps)
    if not closes or other.begin > begin or jumps:
        raise TargetError(
            f"it ends on the way at {last.end:.9g}, and its begin does not take that over: "
            "an axis ends at rest, or as it begins"
        )


def boundary_rates(phases: Sequence[FoundPhase], k: int, near: float, units: Units) -> dict[str, float]:
    """Return y' and y'' of a phase where another curved phase, or none, ends: as machines have them, s in m or rad."""
    before = phases[k - 1]
    meets = k == 0 or phases[k].begin - before.end <= near
    if not meets or {"LIN", Spline.code} & {phases[k].law.code, before.law.code if k else ""}:
        return {}
    x, y = units
    size = length_abscissa(x, 1.0).lift(y).size
    rates = zip(RATES, phases[k].rates(0), strict=True)
    return {name: shown(si(value, ENTERED[y].size), size) for name, value in rates if value}


def tidied(x: float) -> float:
    """Return a place as it was meant, without what rounding leaves behind the twelfth digit."""
    return float(f"{x:.12g}")


def law_entry(phase: FoundPhase, k: int) -> tuple[str, dict[str, Any]]:
    """Return the name of a movement's law in a description, and its entry there where needed."""
    if isinstance(phase.law, Spline):
        points = [{"at": at, "s": s} for at, s in phase.law.points]
        slopes = dict(zip(("first_slope", "last_slope"), phase.law.slopes, strict=True))
        name = f"Read {k + 1}"
        return name, {name: {"family": Spline.code, "points": points} | slopes}
    if phase.law.code in (*CODES, "LIN"):
        return phase.law.code, {}
    return phase.law.name, {phase.law.name: {"family": phase.law.code}}
