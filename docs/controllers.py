"""What each target of ``motionbook export`` takes, from its declaration, written into controllers.md beside this file.

.venv/bin/python -m docs.controllers            writes it
.venv/bin/python -m docs.controllers --check    fails where it is not what the declarations say
"""

from __future__ import annotations

import sys
from pathlib import Path

from workbook.controllers.registry import targets
from workbook.controllers.target import Target

PAGE = Path(__file__).with_suffix(".md")
HEAD = """\
# Controllers' cam tables

Made by `python -m docs.controllers` from what the targets declare. **No controller and no vendor's editor was run**:
each layout rests on the document that stands beside it. *Documented* is what a document says field by field,
*probable* what follows from one with a gap, *untested* what no document settles: try it on your controller before a
machine moves by it.

`motionbook export BOOK --axis NAME --to TARGET` puts points on the breaks of the motion first, then where the rule
between points needs them. The file is then read by an independent reader, the motion rebuilt by the target's rule, in
the target's numbers, and compared with the engine over the whole cycle: between two breaks both are polynomials and
sines, and their difference is enclosed by Bernstein coefficients until the largest error is known to 1e-9 of itself.
Where several rules are named, each is tried, and the worst is a bound. Jumps of acceleration have a point on either
side. `--equidistant` puts the points at equal steps instead; what that costs is stated.

`--switches`, and `--all`, write the switches of a machine where a document says how: tracks that are on from one angle
to another. That file is read back too, and each edge compared.

`motionbook read FILE --from TARGET` and `motionbook compare BOOK FILE --axis NAME --from TARGET` use the same
readers; those of `rockwell` take calculated `CAM_PROFILE` tags too.

"""
TABLE = (
    "| target | for | points | numbers | between points | asked unless told otherwise | switches |\n"
    "|---|---|---|---|---|---|---|\n"
)


def row(one: Target) -> str:
    """Return the row of a target."""
    least, most = one.points
    held = ", ".join(f"{order} {share * 100.0:g} %" for order, share in one.tolerance)
    cells = [f"[`{one.name}`](#{one.name})", one.title, f"{least:,} to {most:,}", one.number.name, "; ".join(one.rules)]
    switches = one.tappets.title if one.tappets else "–"
    return f"| {' | '.join([*cells, held, switches])} |\n"


def section(one: Target) -> str:
    """Return what is claimed of a target."""
    lines = [f"\n## {one.name}\n", f"{one.title}. A point has {', '.join(one.columns)}. Suffix `{one.suffix}`.\n",
             "| what | certainty | by |", "|---|---|---|"]  # fmt: skip
    claims = (*one.claims, *(one.tappets.claims if one.tappets else ()))
    lines += [f"| {claim.what} | {claim.certainty} | {claim.source} |" for claim in claims]
    return "\n".join(lines) + "\n"


def page() -> str:
    """Return the page."""
    found = targets()
    return HEAD + TABLE + "".join(map(row, found)) + "".join(map(section, found))


def main() -> None:
    """Write the page, or compare it with the one that is kept."""
    if "--check" not in sys.argv:
        PAGE.write_text(page(), encoding="utf-8")
    elif PAGE.read_text(encoding="utf-8") != page():
        sys.exit(f"{PAGE.name} is not up to date; run python -m docs.controllers")


if __name__ == "__main__":
    main()
