"""From a verified book to a controller's file, with the certificate of what a reader of its own finds in it."""

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from dataclasses import replace as replaced
from pathlib import Path
from typing import Any

from workbook.axes import CamAxis, CamSwitch
from workbook.build import write_text
from workbook.commands import switching
from workbook.commands.switching import Switched, require_some, switched, takes
from workbook.commands.verify import opened, vouched
from workbook.controllers import files
from workbook.controllers.handing import Made, allowed, automatic, certified, reread, tabulated
from workbook.controllers.registry import target as target_named
from workbook.controllers.target import Handed, Target
from workbook.entries.machine import Machine
from workbook.errors import AGREES, DISAGREES, TargetError, WriteError
from workbook.reports import cams, page
from workbook.reports.terminal import ERR, OUT, say, say_json
from workbook.templates import TEMPLATES
from workbook.visible import visible
from workbook.writing.place import refuse_existing, refuse_itself, refuse_one_for_two, replace

AUTO = "auto"
LOAD, SHAFT = "load", "shaft"
SEPARATORS = {"semicolon": ";", "comma": ",", "tab": "\t"}
DECIMALS = {"point": ".", "comma": ","}


@dataclass(frozen=True)
class Asked:
    """What is asked of an export beside the book."""

    target: Target
    points: int | None  # None for the fewest
    tolerance: Mapping[str, float]
    held: bool  # whether a tolerance was asked for: then nothing is written beyond it
    separator: str
    decimal: str
    unverified: bool
    of: str  # the load or the motor's shaft


@dataclass(frozen=True)
class Exported:
    """An axis with its file's text, and what was made of it when that was read back."""

    axis: CamAxis
    text: str
    made: Made
    path: Path


def asked_for(
    to: str, points: str, tolerance: Sequence[str], separator: str, decimal: str, unverified: bool, equal: bool = False,
    of: str = LOAD,
) -> Asked:  # fmt: skip
    """Return what is asked for; raise TargetError where it cannot be meant."""
    target = target_named(to)
    require_side(of)
    if equal and target.spacing == "breaks":
        raise TargetError(f"{to} has segments between the breaks of a motion; expected no --equidistant")
    target = replaced(target, spacing="equal") if equal else target
    if points != AUTO and not re.fullmatch(r"[0-9]{1,7}", points):
        raise TargetError(f"--points {points}: expected a number of points, or {AUTO}")
    if points != AUTO:
        allowed(target, int(points))
    for name, value, known in (("separator", separator, SEPARATORS), ("decimal", decimal, DECIMALS)):
        if value not in known:
            raise TargetError(f"--{name} {value}: expected {' or '.join(known)}")
        if name not in target.signs and value != next(iter(known)):
            raise TargetError(f"{to} has no {name} to choose; expected no --{name}")
    if SEPARATORS[separator] == DECIMALS[decimal]:
        raise TargetError("a comma parts the columns and is the decimal sign; expected two signs")
    held = dict(map(tolerated, tolerance))
    return Asked(target, None if points == AUTO else int(points), held or dict(target.tolerance), bool(held),
                 SEPARATORS[separator], DECIMALS[decimal], unverified, of)  # fmt: skip


def require_side(of: str) -> None:
    """Raise TargetError for a side of an axis that there is none of."""
    if of not in (LOAD, SHAFT):
        raise TargetError(f"--of {of}: expected {LOAD} or {SHAFT}")


def tolerated(text: str) -> tuple[str, float]:
    """Return the order and the share that a tolerance such as a=1% names."""
    found = re.fullmatch(r"([yvaj])=([0-9]+(?:\.[0-9]*)?|\.[0-9]+)%", text.strip())
    if not found or not float(found[2]):
        raise TargetError(f"--tolerance {text}: expected y, v, a or j and a share of its peak, as a=1%")
    return found[1], float(found[2]) / 100.0


def export(
    book: Path, axis: str | None, asked: Asked, output: Path | None, everything: bool, force: bool, as_json: bool,
    report: Path | None = None, switches: bool = False, fresh: bool = False,
) -> int:  # fmt: skip
    """Write an axis of a book, its switches, or all of it as a target's files; return the exit code."""
    if [axis is not None, everything, switches].count(True) != 1:
        raise TargetError("expected either --axis NAME, --switches or --all")
    page.ready(report, (".html", ".htm"), force)
    if output is not None and not everything:
        refuse_itself(output, book)
        refuse_existing(output, force)
        refuse_one_for_two(output, report)
    read = opened(book)
    if read is None:
        return DISAGREES
    axes, lanes, names = planned(read.machine, axis, asked, everything, switches)
    paths = [(output or Path()) / f"{book.stem}-{name}{asked.target.suffix}" for name in names]
    if output is not None and not everything:  # -o names a file; with --all, the folder in which they lie side by side
        paths = [output]
    refuse_any_existing(paths, force)
    refuse_one_for_two(*paths, report)
    mark = vouched(book, read, asked.unverified, fresh)
    if mark is None:
        return DISAGREES
    with ERR.status("Exporting …"):
        machine, signs = read.machine, (asked.separator, asked.decimal)
        state = (("number", machine.number), ("revision", machine.revision))
        told = ", ".join([machine.title, *(f"{label} {text}" for label, text in state if text)])
        found = [exported(told, one, name, asked, mark, path)
                 for one, name, path in zip(axes, names, paths, strict=False)]  # fmt: skip
        turned = switched(told, lanes, asked.target, signs, mark, paths[-1]) if lanes else None
    tell(found, turned, asked, as_json)
    if missed(found, turned, asked):
        return DISAGREES
    page.write(report, lambda: cams.page([(one.axis, one.made) for one in found], asked.target, asked.tolerance,
                                         turned.rows if turned else []), force)  # fmt: skip
    files = [(one.path, one.text) for one in found] + ([(turned.path, turned.text)] if turned else [])
    for path, text in files:
        replace(path, lambda draft, text=text: write_text(draft, text), force)  # type: ignore[misc]
        say(ERR if as_json else OUT, f"Wrote {path.absolute()}")
    return AGREES


def planned(
    machine: Machine, axis: str | None, asked: Asked, everything: bool, switches: bool
) -> tuple[list[CamAxis], Sequence[CamSwitch], list[str]]:
    """Return axes and switches to export, and what each file is called, the switches' last; raise TargetError."""
    template = TEMPLATES[machine.template]
    known = template.axes(machine)
    called = dict(zip((one.name for one in known), slugs([one.name for one in known]), strict=True))
    axes = [] if switches else chosen(known, axis, machine.template)
    lanes = asked_lanes(asked.target, template.switches(machine), switches, everything)
    names = [called[one.name] for one in axes]
    if asked.of == SHAFT:
        axes = shafts(axes, everything)
        names = [f"{called[one.name]}_shaft" for one in axes]
        axes = [replaced(one, name=f"{one.name}, its motor's shaft") for one in axes]
    return axes, lanes, [*names, *(["switches"] if lanes else [])]


def shafts(axes: Sequence[CamAxis], everything: bool) -> list[CamAxis]:
    """Return the angles of the motors' shafts of axes; raise TargetError for one without a drive that was named."""
    found: list[CamAxis] = []
    for one in axes:
        if one.shaft is None:
            said = f"{one.name} has no drive, and so no motor's shaft"
            if not everything:
                raise TargetError(f"{said}; expected --of load")
            say(ERR, f"{said}: it is left out", "yellow")
            continue
        try:
            found.append(one.shaft())
        except ValueError as error:
            raise TargetError(f"{one.name}: its mechanism cannot do this motion: {error}") from None
    return found


def refuse_any_existing(paths: Sequence[Path], force: bool) -> None:
    """Raise WriteError, which names all of them, where files are there that may not be replaced."""
    there = [path for path in paths if os.path.lexists(path)]
    if there and not force:
        verb = "exists" if len(there) == 1 else "exist"
        raise WriteError(f"{', '.join(map(str, there))}: {verb} already; nothing is written (--force replaces what is "
                         "there, -o names another place)")  # fmt: skip
    for path in paths:
        refuse_existing(path, force)


def asked_lanes(target: Target, lanes: Sequence[CamSwitch], only: bool, everything: bool) -> Sequence[CamSwitch]:
    """Return the switches to export: those asked for, and with every axis where the target takes some."""
    if only:
        require_some(lanes)
        takes(target)
        return lanes
    if not everything or not lanes:
        return []
    if target.tappets is None:
        names = ", ".join(visible(one.name) for one in lanes)
        say(ERR, f"{target.name} takes no switches: {names} stay in the book", "yellow")
        return []
    return lanes


def tell(found: Sequence[Exported], turned: Switched | None, asked: Asked, as_json: bool) -> None:
    """Print the certificates, what is untested, and what misses a tolerance that nobody asked for."""
    target = asked.target
    if as_json:
        told: list[Any] = [cams.told(one.axis, one.made, target, str(one.path)) for one in found]
        told += [switching.told(turned, target)] if turned else []
        say_json(told)
    else:
        for one in found:
            cams.show(one.axis, one.made, target)
        if turned:
            switching.show(turned, target)
    for claim in (*(target.untested if found else ()), *(turned.tappets.untested if turned else ())):
        say(ERR, f"Untested: {claim.what} ({claim.source})")
    for one in found:
        if asked.points is None and not asked.held and one.made.excess(asked.tolerance) > 1.0:
            say(ERR, f"{one.axis.name}: {cams.excess(one.made, asked.tolerance)}: the best there is", "yellow")


def missed(found: Sequence[Exported], turned: Switched | None, asked: Asked) -> bool:
    """Tell what is beyond the tolerance that was asked for; whether anything is."""
    lines = [f"{one.axis.name}: {cams.excess(one.made, asked.tolerance)}"
             for one in found if asked.held and one.made.excess(asked.tolerance) > 1.0]  # fmt: skip
    lines += turned.beyond if turned else []
    for line in lines:
        say(ERR, f"{line}; nothing is written", "red")
    return bool(lines)


def chosen(axes: Sequence[CamAxis], name: str | None, template: str) -> list[CamAxis]:
    """Return the axis of a name, or all; raise TargetError where there is none."""
    if not axes:
        raise TargetError(f"{template} has no axis that a controller could be given")
    found = [one for one in axes if name is None or one.name.casefold() == name.casefold()]
    if not found:
        raise TargetError(f"no axis is named {name!r}; expected one of {', '.join(one.name for one in axes)}")
    if name is not None and len(found) > 1:
        raise TargetError(f"{len(found)} axes are named {name!r}; expected a name of its own for each")
    return found


def slugs(names: Sequence[str]) -> list[str]:
    """Return names of letters, digits and _, each once: behind those that would be alike stands a number."""
    plain = [re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_") for name in names]
    plain = [name if name[:1].isalpha() else f"Axis_{name}".rstrip("_") for name in plain]
    like = [name.casefold() for name in plain]
    return [f"{name}_{k}" if like.count(one) > 1 else name
            for k, (name, one) in enumerate(zip(plain, like, strict=True), 1)]  # fmt: skip


def exported(
    machine: str, axis: CamAxis, name: str, asked: Asked, mark: Sequence[str], path: Path
) -> Exported:  # fmt: skip
    """Return the text of the file of a machine's axis, and the certificate of what a reader of its own finds in it."""
    target = asked.target
    if asked.points is None:
        made = automatic(target, axis, asked.tolerance)
    else:
        made = certified(target, tabulated(target, axis, asked.points), axis.profile)
    units, equal = (axis.x_unit, axis.y_unit), target.spacing == "equal"
    header = tuple(visible(line) for line in (
        f"{machine}, axis {axis.name}: {target.title}",
        files.header(made.points, " or ".join(made.certificates), equal, units),
        *mark,
        *(f"untested: {claim.what} ({claim.source})" for claim in target.untested),
    ))  # fmt: skip
    handed = Handed(made.table, name, header, units, axis.repeats, asked.separator, asked.decimal)
    text = target.write(handed)
    again = certified(target, reread(target, text, made.table), axis.profile)
    return Exported(axis, text, again, path)
