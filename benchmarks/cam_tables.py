"""Measure what a controller makes of a rise by its points, draw docs/cam-tables.md's picture, and time certifying.

.venv/bin/python benchmarks/cam_tables.py             prints the tables
.venv/bin/python benchmarks/cam_tables.py --picture   writes docs/cam-tables.svg too
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from xml.etree.ElementTree import indent, tostring

import numpy as np
from rich.console import Console
from rich.table import Table

from engine import law
from engine.cams.certificate import certify, equal_steps
from engine.cams.interpolation import lines, quintics, segment_profile, spline
from engine.laws.base import Array
from engine.motion import Motion, Phase
from engine.motion.profile import CamProfile, profile_of_motion
from workbook.controllers.registry import target, targets
from workbook.controllers.tabulation import automatic, certify_table, reread, tabulate
from workbook.controllers.target import CamExport
from workbook.reports.html import Line, plot
from workbook.template_outputs import CamAxis

PICTURE = Path(__file__).parents[1] / "docs" / "cam-tables.svg"
RISE = profile_of_motion(Motion([Phase(law("MTP"), 300.0, 80.0)]))
TURN = profile_of_motion(Motion([Phase(law("MTP"), 300.0, 80.0), Phase(law("dwell"), 0.0, 280.0)]))
INTERVALS = (8, 16, 20, 24, 40, 80, 160, 400, 800, 1000, 2000, 4000)
FLOOR = 1e-12  # what is less is drawn there
AXES, POINTS, ROUNDS = 24, 1000, 5
WHOLE, AUTO = 3.0, 2.0  # s, the most that exporting them may take, and finding the fewest points of one axis


def clamped(of: CamProfile, x: Array) -> CamProfile:
    return spline(x, of.at(x).y, (0.0, 0.0))


def clamped_real(of: CamProfile, x: Array) -> CamProfile:
    return spline(x, of.at(x).y.astype(np.float32).astype(np.float64), (0.0, 0.0))


def quintic(of: CamProfile, x: Array) -> CamProfile:
    at = of.at(x)
    return quintics(x, at.y, at.y1, at.y2)


RULES: dict[str, Callable[[CamProfile, Array], CamProfile]] = {
    "straight lines": lambda of, x: lines(x, of.at(x).y),
    "cubic spline, REAL": clamped_real,
    "cubic spline, LREAL": clamped,
    "quintics of y, y', y''": quintic,
    "segments": lambda of, x: segment_profile(of, of.edges),
}


def share(of: CamProfile, rebuilt: CamProfile) -> float:
    """The largest error of acceleration, of its peak."""
    return certify(of, rebuilt).deviations[2].share


def errors() -> dict[str, list[float]]:
    """The error of each rule by the number of equal steps over the rise; the breaks are on them where 8 divides it."""
    return {
        name: [share(RISE, rule(RISE, equal_steps(RISE, n + 1))) for n in INTERVALS] for name, rule in RULES.items()
    }


def accuracy(found: dict[str, list[float]]) -> Table:
    grid = Table(
        "Steps of the rise", *found, "over the turn, LREAL", title="Largest error of acceleration, % of its peak"
    )
    for k, n in enumerate(INTERVALS):
        turn = share(TURN, clamped(TURN, equal_steps(TURN, n + 1)))
        grid.add_row(f"{n:,}", *(f"{100.0 * values[k]:.3g}" for values in found.values()), f"{100.0 * turn:.3g}")
    return grid


def spent(task: Callable[[], object]) -> float:
    begin = time.process_time()
    task()
    return time.process_time() - begin


def export(axis: CamAxis) -> None:
    one = target("codesys")
    made = certify_table(one, tabulate(one, axis, POINTS), axis.profile)
    certify_table(one, reread(one, one.write(CamExport(made.table, "demo", (), ("°", "mm"))), made.table), axis.profile)


def costs() -> Table:
    """The cost of exporting, and of finding the fewest points, beside certifying a table once."""
    axis = CamAxis("demo", TURN, "°", "mm")
    x = equal_steps(TURN, POINTS)
    unit = min(spent(lambda: certify(TURN, quintic(TURN, x))) for _ in range(ROUNDS))
    title = f"What it costs; the unit is certifying one table of {POINTS:,} points"
    grid = Table("Step", "ms of a core", "at most", "Ratio", title=title)
    steps: dict[str, Callable[[], object]] = {f"{AXES} axes of {POINTS:,} points, written, read, certified twice":
                                              lambda: [export(axis) for _ in range(AXES)]}  # fmt: skip
    for one in targets():
        steps[f"--points auto, {one.name}"] = partial(automatic, one, axis, dict(one.tolerance))
    for name, task in steps.items():
        seconds = spent(task)
        most = AUTO if name.startswith("--points") else WHOLE
        grid.add_row(name, f"{seconds * 1e3:.0f}", f"{most * 1e3:.0f}", f"{seconds / unit:.0f}")
    return grid


def main() -> None:
    """Print the tables, and write the picture where that is asked for."""
    found = errors()
    console = Console(width=140)
    console.print(accuracy(found))
    console.print(costs())
    if "--picture" in sys.argv:
        on = np.array(INTERVALS) % 8 == 0  # the breaks are on the grid
        x = np.array(INTERVALS, dtype=np.float64)[on] + 1.0
        drawn = [Line(name, x, np.maximum(np.array(values)[on], FLOOR)) for name, values in found.items()]
        title = "Modified trapezoid of 300 mm: what a controller's rule makes of its acceleration"
        svg = plot(title, ("points over the rise", "largest error, of the peak"), drawn, (True, True))
        indent(svg)
        PICTURE.write_text(tostring(svg, encoding="unicode") + "\n", encoding="utf-8")
        console.print(f"Wrote {PICTURE}")


if __name__ == "__main__":
    main()
