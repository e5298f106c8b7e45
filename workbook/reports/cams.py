"""The certificates of an export: in words, as tables of a terminal, as JSON, as a page of HTML with pictures."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from engine.cams.certificate import Certificate
from workbook.controllers.tabulation import ORDERS, CertifiedTable, automatic, curve, placed_otherwise, rules_of
from workbook.controllers.target import Target
from workbook.reports.html import Line, document, plot
from workbook.reports.terminal import OUT, show_table, shown
from workbook.template_outputs import CamAxis

FLOOR = 1e-12  # of the peak: what is less is drawn there
SAMPLES = 1441  # of a picture
SWITCHED = ("switch", "edges", "an edge is off by", "at", "state differs for")
HEADINGS = ("", "largest error", "unit", "of the peak", "at x", "added jump")
WORDS = ("position", "velocity", "acceleration", "jerk")


def percent(share: float) -> str:
    """Return a share in percent to three digits."""
    return f"{share * 100.0:.3g} %" if math.isfinite(share) else "–"


def excess(certified: CertifiedTable, tolerance: Mapping[str, float]) -> str:
    """Return in words by how much a table misses what is tolerated."""
    missed = {order: certified.share(order) for order, most in tolerance.items() if certified.share(order) > most}
    parts = [
        f"{WORDS[ORDERS.index(o)]} is off by {percent(share)} of its peak, {percent(tolerance[o])} asked"
        for o, share in missed.items()
    ]
    return f"with {certified.points} points {'; '.join(parts)}"


def show(axis: CamAxis, certified: CertifiedTable, target: Target) -> None:
    """Print the certificate of each rule that may be the target's."""
    for name, certificate in certified.certificates.items():
        count = len(certified.certificates)
        bound = f", one of {count} rules that may be its" if count > 1 else ""
        title = shown(f"{axis.name} to {target.name}: {certified.points} points, {name}{bound}")
        headings = [*HEADINGS[:4], f"at x ({axis.x_unit})", HEADINGS[5]]
        show_table(OUT, headings, rows(axis, certificate), (1, 3, 4, 5), title)


def placing(axis: CamAxis, certified: CertifiedTable, target: Target) -> dict[str, Any]:
    """Return the position's error, and that of as many points in the other placing, by what each is called."""
    other = placed_otherwise(target, axis, certified)
    names = ("at equal steps", "placed by the motion")
    tables = (certified, other) if target.spacing == "equal" else (other, certified)
    errors = [max(of.deviations[0].largest for of in table.certificates.values()) for table in tables if table]
    return dict(zip(names, errors, strict=True)) if other else {}


def placing_line(axis: CamAxis, certified: CertifiedTable, target: Target) -> str:
    """Return in a line what equal steps cost, or what the places of the points gain; nothing of segments."""
    errors = placing(axis, certified, target)
    parts = [f"{name} by {error:.3g} {axis.units[0]}" for name, error in errors.items()]
    return f"Position of {certified.points} points is off {', '.join(parts)}" if parts else ""


def rows(axis: CamAxis, of: Certificate) -> list[list[str]]:
    """Return a row of texts for each derivative."""
    lines = []
    for k, error in enumerate(of.deviations):
        jump = f"{max(of.jumps[k], abs(of.closure[k])):.3g}" if k < len(of.jumps) else ""
        largest, x = f"{error.largest:.3g}", f"{error.x:.6g}"
        lines.append([WORDS[k], largest, axis.units[k], percent(error.share), x, jump])
    return lines


def certificate_data(axis: CamAxis, certified: CertifiedTable, target: Target, path: str) -> dict[str, Any]:
    """Return a certificate as data, the figures of each rule by derivative."""
    rules: dict[str, dict[str, Any]] = {}
    for name, of in certified.certificates.items():
        figures = rules[name] = dict[str, Any]()
        for k, (word, unit, error) in enumerate(zip(WORDS, axis.units, of.deviations, strict=True)):
            share = error.share if math.isfinite(error.share) else None
            figures[word] = {"unit": unit, "largest": error.largest, "share": share}
            figures[word] |= {"at": error.x, "peak": error.peak}
            if k < len(of.jumps):
                figures[word] |= {"jump": of.jumps[k], "closure": of.closure[k]}
    data = {"axis": axis.name, "target": target.name, "file": path, "points": certified.points}
    untested = [claim.what for claim in target.untested]
    return data | {"x_unit": axis.x_unit, "rules": rules, "untested": untested}


def page(
    axes: Sequence[tuple[CamAxis, CertifiedTable]],
    target: Target,
    tolerance: Mapping[str, float],
    switches: Sequence[Sequence[str]] = (),
) -> str:
    """Return the page of the axes that were exported to a target, and of its switches, a row of texts each."""
    claims = (*target.claims, *(target.tappets.claims if switches and target.tappets else ()))
    given = {"target": target, "claims": claims, "axes": axes, "tolerance": tolerance, "switches": switches}
    return document(f"Cam tables for {target.title}", "reports/cams.html", **given)


def advice(axis: CamAxis, target: Target, tolerance: Mapping[str, float]) -> str:
    """Return in a sentence how many points an axis should have."""
    best = automatic(target, axis, tolerance)
    asked = ", ".join(f"{WORDS[ORDERS.index(o)]} {percent(t)}" for o, t in tolerance.items())
    words = "the fewest that keep" if best.excess(tolerance) <= 1.0 else "the best there is, which does not keep"
    return f"Recommended: {best.points} points, {words} to {asked} of its peak."


def pictures(axis: CamAxis, certified: CertifiedTable, target: Target) -> Iterator[str]:
    """Yield pictures: errors over the number of points; the acceleration meant and built by each rule; its errors."""
    tried = sorted([*curve(target, axis), certified], key=lambda table: table.points)
    points = np.array([float(table.points) for table in tried])
    drawn = []
    for order, word in zip(ORDERS, WORDS, strict=True):
        shares = np.array([table.share(order) for table in tried])
        drawn.append(Line(word, points, np.clip(np.nan_to_num(shares, posinf=FLOOR), FLOOR, None)))
    title = f"{axis.name}: largest error over the number of points; {certified.points} were taken"
    yield plot(title, ("points", "of the peak"), drawn, (True, True))
    begin, end = axis.profile.edges[[0, -1]]
    x = np.linspace(begin, end, SAMPLES)
    meant = axis.profile.at(x)
    rebuilt = {name: rule.rebuild(certified.table).at(x) for name, rule in rules_of(target, certified.table).items()}
    drawn = [Line("meant", x, meant.y2), *(Line(name, x, rates.y2) for name, rates in rebuilt.items())]
    yield plot(f"{axis.name}: acceleration over the cycle", (axis.x_unit, axis.units[2]), drawn)
    for k, word in ((0, "position"), (2, "acceleration")):
        errors = [Line(name, x, rates[k] - meant[k]) for name, rates in rebuilt.items()]
        title = f"{axis.name}: error of the {word} over the cycle"
        yield plot(title, (axis.x_unit, axis.units[k]), errors)
