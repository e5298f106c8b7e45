"""A certificate in words, as a table of a terminal and as JSON."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from rich.console import Console
from rich.table import Table as Grid
from rich.text import Text

from engine.cams.certificate import Certificate
from workbook.axes import CamAxis
from workbook.controllers.handing import ORDERS, Made
from workbook.controllers.target import Target
from workbook.visible import visible

WORDS = ("position", "velocity", "acceleration", "jerk")


def percent(share: float) -> str:
    """Return a share in percent to three digits."""
    return f"{share * 100.0:.3g} %" if math.isfinite(share) else "–"


def excess(made: Made, tolerance: Mapping[str, float]) -> str:
    """Return in words by how much a table misses what is tolerated."""
    missed = [order for order, most in tolerance.items() if made.share(order) > most]
    parts = [f"{WORDS[ORDERS.index(o)]} is off by {percent(made.share(o))} of its peak, {percent(tolerance[o])} asked"
             for o in missed]  # fmt: skip
    return f"with {made.points} points {'; '.join(parts)}"


def show(console: Console, axis: CamAxis, made: Made, target: Target) -> None:
    """Print the certificate of each rule that may be the target's."""
    for name, certificate in made.certificates.items():
        bound = f", one of {len(made.certificates)} rules that may be its" if len(made.certificates) > 1 else ""
        title = f"{axis.name} to {target.name}: {made.points} points, {name}{bound}"
        grid = Grid(title=Text(visible(title)), title_justify="left")
        for heading in ("", "largest error", "unit", "of the peak", f"at x ({visible(axis.x_unit)})", "added jump"):
            grid.add_column(Text(heading), justify="left" if heading in ("", "unit") else "right")
        for row in rows(axis, certificate):
            grid.add_row(*map(Text, row))
        console.print(grid)


def rows(axis: CamAxis, of: Certificate) -> list[list[str]]:
    """Return a row of texts for each derivative."""
    found = []
    for k, one in enumerate(of.deviations):
        jump = f"{max(of.jumps[k].largest, abs(of.closure[k])):.3g}" if k < len(of.jumps) else ""
        found.append([WORDS[k], f"{one.largest:.3g}", visible(axis.units[k]), percent(one.share), f"{one.x:.6g}", jump])
    return found


def told(axis: CamAxis, made: Made, target: Target, path: str) -> dict[str, Any]:
    """Return a certificate as data."""
    return {
        "axis": axis.name,
        "target": target.name,
        "file": path,
        "points": made.points,
        "x_unit": axis.x_unit,
        "rules": {name: figures(axis, one) for name, one in made.certificates.items()},
        "untested": [claim.what for claim in target.untested],
    }


def figures(axis: CamAxis, of: Certificate) -> dict[str, Any]:
    """Return the figures of a certificate by derivative."""
    return {
        word: {
            "unit": unit,
            "largest": one.largest,
            "share": one.share if math.isfinite(one.share) else None,
            "at": one.x,
            "peak": one.peak,
            **({"jump": of.jumps[k].largest, "closure": of.closure[k]} if k < len(of.jumps) else {}),
        }
        for k, (word, unit, one) in enumerate(zip(WORDS, axis.units, of.deviations, strict=True))
    }
