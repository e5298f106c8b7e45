"""The certificates of an export as one page of HTML: tables, errors over the points and over the cycle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from xml.etree.ElementTree import Element

import numpy as np

import workbook
from workbook.axes import CamAxis
from workbook.controllers import certificates
from workbook.controllers.automatic import automatic, curve
from workbook.controllers.handing import ORDERS, Made, rules_of
from workbook.controllers.target import Target
from workbook.reports.html import document, e, table
from workbook.reports.plot import Line, plot

FLOOR = 1e-12  # of the peak: what is less is drawn there
SAMPLES = 1441  # of a picture
SWITCHED = ("switch", "edges", "an edge is off by", "at", "state differs for")
HEADINGS = ("", "largest error", "unit", "of the peak", "at x", "added jump")


def page(
    found: Sequence[tuple[CamAxis, Made]], target: Target, tolerance: Mapping[str, float],
    switches: Sequence[Sequence[str]] = (),
) -> str:  # fmt: skip
    """Return the page of the axes that were exported to a target, and of its switches, a row of texts each.

    The number of points that is recommended is the fewest that keeps to a tolerance, or that of the best there is.
    """
    title = f"Cam tables for {target.title}"
    how = (
        f"motionbook {workbook.__version__}. Each file was read back by an independent reader, the motion rebuilt by "
        "the target's rule and compared with the engine over the whole cycle. No controller was run."
    )
    body = [e("h1", title), e("p", how, css="quiet")]
    claims = (*target.claims, *(target.tappets.claims if switches and target.tappets else ()))
    body += [e("p", f"{claim.certainty}: {claim.what} ({claim.source})") for claim in claims]
    for axis, made in found:
        body += section(axis, made, target, recommended(axis, target, tolerance))
    if switches:
        body += [e("h2", "Switches"), table(SWITCHED, switches, (1, 2, 3, 4))]
    return document(title, body)


def recommended(axis: CamAxis, target: Target, tolerance: Mapping[str, float]) -> str:
    """Return in words how many points an axis should have."""
    best = automatic(target, axis, tolerance)
    asked = ", ".join(f"{certificates.WORDS[ORDERS.index(o)]} {certificates.percent(t)}" for o, t in tolerance.items())
    kept = "the fewest that keep" if best.excess(tolerance) <= 1.0 else "the best there is, which does not keep"
    return f"Recommended: {best.points} points, {kept} to {asked} of its peak."


def section(axis: CamAxis, made: Made, target: Target, advice: str) -> list[Element]:
    """Return what is to be said of one axis."""
    said = [e("h2", axis.name), e("p", f"{made.points} points; x in {axis.x_unit}, y in {axis.y_unit}. {advice}")]
    for name, certificate in made.certificates.items():
        said += [
            e("h3", name[:1].upper() + name[1:]),
            table(HEADINGS, certificates.rows(axis, certificate), (1, 3, 4, 5)),
        ]
    return [*said, over_points(axis, made, target), *over_cycle(axis, made, target)]


def over_points(axis: CamAxis, made: Made, target: Target) -> Element:
    """Return the picture of errors over the number of points."""
    tried = sorted([*curve(target, axis), made], key=lambda one: one.points)
    x = np.array([float(one.points) for one in tried])
    drawn = []
    for order, word in zip(ORDERS, certificates.WORDS, strict=True):
        shares = np.array([one.share(order) for one in tried])
        drawn.append(Line(word, x, np.clip(np.nan_to_num(shares, posinf=FLOOR), FLOOR, None)))
    title = f"{axis.name}: largest error over the number of points; {made.points} were taken"
    return plot(title, ("points", "of the peak"), drawn, (True, True))


def over_cycle(axis: CamAxis, made: Made, target: Target) -> list[Element]:
    """Return the pictures of the acceleration meant and what each rule makes of it, and of both errors."""
    begin, end = axis.profile.edges[[0, -1]]
    x = np.linspace(begin, end, SAMPLES)
    meant = axis.profile.at(x)
    found = {name: rule.made(made.table).at(x) for name, rule in rules_of(target, made.table).items()}
    drawn = [Line("meant", x, meant.y2), *(Line(name, x, one.y2) for name, one in found.items())]
    pictures = [plot(f"{axis.name}: acceleration over the cycle", (axis.x_unit, axis.units[2]), drawn)]
    for k, word in ((0, "position"), (2, "acceleration")):
        errors = [Line(name, x, one[k] - meant[k]) for name, one in found.items()]
        title = f"{axis.name}: error of the {word} over the cycle"
        pictures.append(plot(title, (axis.x_unit, axis.units[k]), errors))
    return pictures
