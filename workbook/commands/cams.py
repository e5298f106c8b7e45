"""What runs in a machine: a controller's file read, identified, and compared with a book's axis."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from engine.cams.course import SAME
from engine.cams.identify import THINNED
from workbook import build as making
from workbook.commands.export import chosen, tolerated, trusted
from workbook.controllers import certificates, described
from workbook.controllers.files import read_table
from workbook.controllers.handing import certified
from workbook.controllers.registry import target as target_named
from workbook.errors import TargetError
from workbook.exits import AGREES, DISAGREES
from workbook.intake import read_text
from workbook.reading.entries import checked, template_named, write_machine
from workbook.reports.terminal import ERR, OUT, say, say_data
from workbook.templates import TEMPLATES
from workbook.visible import visible
from workbook.writing.place import refuse_existing, refuse_itself

LONGEST = 80
"""characters of a title"""
NEAR = 1e-6
"""of the cycle: so far the file's may be from the book's"""


def read(file: Path, source: str, output: Path | None, force: bool, tolerance: str | None = None) -> None:
    """Tell what a controller's file was made of, and write it as a description."""
    target = target_named(source)
    share = thinned(tolerance)
    if output is not None:
        refuse_itself(output, file)
        refuse_existing(output, force)
    table = read_table(file, target)
    units = described.units_of(read_text(file, "a table", most=len(file.read_bytes())))
    found = described.phases_of(target, table, units, share)
    data = described.composed(found, table, units, title(file.name))
    machine = checked(template_named(data["template"], str(file)), data, lambda key: f"{file}: {key}")
    say(ERR, f"{len(table.x):,} points, {table.x[0]:.9g} to {table.x[-1]:.9g} {units[0]}; {len(found.found)} movements")
    for line in described.lines(found, units):
        say(ERR, line)
    if data["template"] == "machine":
        said = f"It begins on the way: written as a machine's axis, {found.late:.9g} {units[0]} later"
        say(ERR, f"{said}; its rate of {described.RATE:g} is ours, enter the machine's")
    if output is None:
        say_data(write_machine(machine))
        return
    making.write_inputs(machine, output, overwrite=force)
    say(OUT, f"Wrote {output.absolute()}")


def thinned(tolerance: str | None) -> float:
    """Return the share of the reach that a spline may be off by; raise TargetError for another order than y."""
    if tolerance is None:
        return THINNED
    order, share = tolerated(tolerance)
    if order != "y":
        raise TargetError(f"--tolerance {tolerance}: expected y and a share of the reach, as y=0.01%")
    return share


def title(name: str) -> str:
    """Return the title of what was read from a file, as long as a title may be."""
    told = f"Read from {visible(name)}"
    return told if len(told) <= LONGEST else f"{told[: LONGEST - 1]}…"


def compare(
    book: Path, file: Path, axis: str, source: str, tolerance: Sequence[str], unverified: bool, as_json: bool
) -> int:  # fmt: skip
    """Compare what a controller makes of a file with an axis of a book; return the exit code."""
    target = target_named(source)
    held = dict(map(tolerated, tolerance)) or dict(target.tolerance)
    table = read_table(file, target)
    machine, _ = trusted(book, unverified)
    if machine is None:
        return DISAGREES
    (meant,) = chosen(TEMPLATES[machine.template].axes(machine), axis, machine.template)
    course = meant.course
    for given, own in zip(table.x[[0, -1]], course.edges[[0, -1]], strict=True):
        if abs(float(given) - float(own)) > max(NEAR, SAME) * course.total:
            raise TargetError(
                f"{file}: x runs from {table.x[0]:.9g} to {table.x[-1]:.9g}; {meant.name} from "
                f"{course.edges[0]:.9g} to {course.edges[-1]:.9g} {meant.x_unit}: expected the same cycle"
            )
    made = certified(target, table, course)
    if as_json:
        say_data(f"{json.dumps(certificates.told(meant, made, target, str(file)), ensure_ascii=False, indent=1)}\n")
    else:
        certificates.show(OUT, meant, made, target)
    if made.excess(held) <= 1.0:
        return AGREES
    say(ERR, f"{meant.name}: {certificates.excess(made, held)}", "red")
    return DISAGREES
