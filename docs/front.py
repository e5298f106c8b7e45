"""Make the picture of a front for docs/studies.md, from docs/study.toml, and print what it tells.

.venv/bin/python -m docs.front
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import tostring

from workbook.pool import THIS_PROCESS
from workbook.reports.study import names_of, picture
from workbook.studies.evaluate import Evaluator, require_names
from workbook.studies.folder import Parts
from workbook.studies.plan import Plan, read_study
from workbook.studies.run import run

HERE_LIES = Path(__file__).parent
LAW, STOP = "axes.MC01.phases[1].law", "axes.MC01.phases[1].stop"
S1 = {LAW: "MTP", STOP: 80.0}
"""what S1 chose"""


def main() -> None:
    """Work the study out, draw its front, and compare each of its designs with S1's law and angle."""
    plan = read_study(HERE_LIES / "study.toml")
    named = require_names(plan, "docs/study.toml")
    with tempfile.TemporaryDirectory() as folder:
        parts = Parts(Path(folder, "r.csv"), plan.digest, plan.space.size)
        with parts.opened(False, False):
            found = run(plan, parts, THIS_PROCESS, lambda count, before: None)
    drawn = tostring(picture(plan.study, found.best, named), encoding="unicode")
    (HERE_LIES / "front.svg").write_text(drawn + "\n", encoding="utf-8", newline="\n")
    print(f"{found.designs:,} designs, {found.feasible:,} feasible")
    for name, one in zip(names_of(found.best), found.best, strict=True):
        table = Evaluator(plan).table(0, plan.space.columns(*place_of(plan, one.entries | S1)))
        before = float(table.results["drive1_rms"][0])
        saved = 1.0 - one.results["drive1_rms"] / before
        print(
            f"{name}; stop {one.entries[STOP]:g}: {one.results['drive1_rms']:.2f}"
            f" Nm, jerk {one.results['axis1.j.1']:,.0f} m/s³; {saved:.0%} less than {before:.2f} Nm by MTP to 80°"
        )


def place_of(plan: Plan, entries: dict[str, Any]) -> tuple[int, int]:
    """Return the number of a design by its entries, and the one behind it."""
    number = 0
    for one in plan.space.dimensions:
        number = number * one.size + one.values.index(entries[one.label])
    return number, number + 1


if __name__ == "__main__":
    main()
