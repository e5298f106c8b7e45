"""From a verified book to a controller's file of axes or switches, certified by what an independent reader finds."""

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace as replaced
from pathlib import Path
from typing import Any, NamedTuple

from workbook.commands.switch_export import SwitchFile, export_switches, switch_format
from workbook.commands.verify import open_finished, verified_header
from workbook.controllers.registry import target as target_named
from workbook.controllers.tabulation import CertifiedTable, automatic, certify_table, require_count, reread, tabulate
from workbook.controllers.target import CamExport, Target, header
from workbook.entries.machine import Machine
from workbook.errors import AGREES, DISAGREES, TargetError, WriteError, visible
from workbook.reports import cams, page
from workbook.reports.terminal import ERR, OUT, say, say_json
from workbook.template_outputs import CamAxis, CamSwitch
from workbook.templates import TEMPLATES
from workbook.writing.output_files import refuse_existing, refuse_itself, refuse_same_file, write_text

AUTO = "auto"
LOAD, SHAFT = "load", "shaft"
SEPARATORS = {"semicolon": ";", "comma": ",", "tab": "\t"}
DECIMALS = {"point": ".", "comma": ","}


class Options(NamedTuple):
    """The options of an export beside the book."""

    target: Target
    points: int | None  # None for the fewest
    tolerance: Mapping[str, float]
    held: bool  # whether a tolerance was asked for: then nothing is written beyond it
    signs: tuple[str, str]  # between columns, and of decimals
    unverified: bool
    of: str  # the load or the motor's shaft


class AxisFile(NamedTuple):
    """An axis with its file's text, and what was built of it when that was read back."""

    axis: CamAxis
    text: str
    certified: CertifiedTable
    path: Path

    def show(self, target: Target) -> None:
        """Print its certificate, and what the places of its points gain or cost."""
        cams.show(self.axis, self.certified, target)
        if line := cams.placing_line(self.axis, self.certified, target):
            say(OUT, line)

    def as_data(self, target: Target) -> dict[str, Any]:
        """Return the same as data."""
        data = cams.certificate_data(self.axis, self.certified, target, str(self.path))
        return data | {"position": cams.placing(self.axis, self.certified, target)}


def parse_options(
    to: str, points: str, tolerance: Sequence[str], separator: str, decimal: str, unverified: bool, equal: bool = False,
    of: str = LOAD,
) -> Options:  # fmt: skip
    """Return the options; raise TargetError where it cannot be meant."""
    target = target_named(to)
    if equal and target.spacing == "breaks":
        raise TargetError(f"{to} has segments between the breaks of a motion; expected no --equidistant")
    target = replaced(target, spacing="equal") if equal else target
    if points != AUTO and not re.fullmatch(r"[0-9]{1,7}", points):
        raise TargetError(f"--points {points}: expected a number of points, or {AUTO}")
    if points != AUTO:
        require_count(target, int(points))
    for name, value, known in (("separator", separator, SEPARATORS), ("decimal", decimal, DECIMALS)):
        if name not in target.signs and value != next(iter(known)):
            raise TargetError(f"{to} has no {name} to choose; expected no --{name}")
    if SEPARATORS[separator] == DECIMALS[decimal]:
        raise TargetError("a comma parts the columns and is the decimal sign; expected two signs")
    held = dict(map(parse_tolerance, tolerance))
    count = None if points == AUTO else int(points)
    signs = (SEPARATORS[separator], DECIMALS[decimal])
    return Options(target, count, held or dict(target.tolerance), bool(held), signs, unverified, of)


def parse_tolerance(text: str) -> tuple[str, float]:
    """Return the order and the share that a tolerance such as a=1% names."""
    match = re.fullmatch(r"([yvaj])=([0-9]+(?:\.[0-9]*)?|\.[0-9]+)%", text.strip())
    if not match or not float(match[2]):
        raise TargetError(f"--tolerance {text}: expected y, v, a or j and a share of its peak, as a=1%")
    return match[1], float(match[2]) / 100.0


def export(
    book: Path, axis: str | None, asked: Options, output: Path | None, everything: bool, force: bool, as_json: bool,
    report: Path | None = None, switches: bool = False, fresh: bool = False,
) -> int:  # fmt: skip
    """Write an axis of a book, its switches, or all of it as a target's files; return the exit code."""
    if [axis is not None, everything, switches].count(True) != 1:
        raise TargetError("expected either --axis NAME, --switches or --all")
    page.require_writable(report, (".html", ".htm"), force)
    refuse_itself(output, book)
    machine, before = open_finished(book)
    axes, lanes, names = plan_export(machine, axis, asked, everything, switches)
    place = output or Path()
    paths = [place]
    if output is None or everything:  # with --all, -o names the folder in which they lie
        paths = [place / f"{book.stem}-{name}{asked.target.suffix}" for name in names]
    refuse_any_existing(paths, force)
    refuse_same_file(*paths, report)
    mark = verified_header(book, before, asked.unverified, fresh)
    with ERR.status("Exporting …"):
        files = [
            export_axis(machine.heading, axis, name, asked, mark, path)
            for axis, name, path in zip(axes, names, paths, strict=False)
        ]
        written: list[AxisFile | SwitchFile] = [*files]
        turned = None
        if lanes:
            turned = export_switches(machine.heading, lanes, asked.target, asked.signs, mark, paths[-1])
            written.append(turned)
    show_files(written, asked.target, as_json)
    if not tell_missed(files, turned, asked):
        return DISAGREES
    tables, rows = [(file.axis, file.certified) for file in files], turned.rows if turned else []
    page.write(report, lambda: cams.page(tables, asked.target, asked.tolerance, rows), force)
    for file in written:
        write_text(file.path, file.text, force)
        say(ERR if as_json else OUT, f"Wrote {file.path.absolute()}")
    return AGREES


def refuse_any_existing(paths: Sequence[Path], force: bool) -> None:
    """Raise WriteError naming all files that are there already, unless they may be replaced."""
    there = [path for path in paths if os.path.lexists(path)]
    if there and not force:
        verb = "exists" if len(there) == 1 else "exist"
        raise WriteError(
            f"{', '.join(map(str, there))}: {verb} already; nothing is written (--force replaces what is "
            "there, -o names another place)"
        )
    for path in paths:
        refuse_existing(path, force)


def plan_export(
    machine: Machine, axis: str | None, asked: Options, everything: bool, switches: bool
) -> tuple[list[CamAxis], Sequence[CamSwitch], list[str]]:
    """Return axes and switches to export, and what each file is called, the switches' last; raise TargetError.

    The switches are those asked for, and with every axis where the target takes some.
    """
    template = TEMPLATES[machine.template]
    known = template.axes(machine)
    lanes = template.switches(machine) if switches or everything else []
    called = [axis.name for axis in known]
    axes = [] if switches else choose_axes(known, axis, machine.template)
    if switches:
        switch_format(asked.target, lanes)
    elif lanes and asked.target.tappets is None:
        left = ", ".join(visible(lane.name) for lane in lanes)
        say(ERR, f"{asked.target.name} takes no switches: {left} stay in the book", "yellow")
        lanes = []
    if asked.of == SHAFT:
        axes = shafts(axes, everything)
    file_names = dict(zip(called, slugs(called), strict=True))
    ending, of = ("_shaft", ", its motor's shaft") if asked.of == SHAFT else ("", "")
    names = [f"{file_names[axis.name]}{ending}" for axis in axes] + ["switches"] * bool(lanes)
    return [replaced(axis, name=f"{axis.name}{of}") for axis in axes], lanes, names


def shafts(axes: Sequence[CamAxis], everything: bool) -> list[CamAxis]:
    """Return the angles of the motors' shafts of axes; raise TargetError for an axis without a drive that was named."""
    drives: list[CamAxis] = []
    for axis in axes:
        if axis.shaft is None:
            message = f"{axis.name} has no drive, and so no motor's shaft"
            if not everything:
                raise TargetError(f"{message}; expected --of load")
            say(ERR, f"{message}: it is left out", "yellow")
            continue
        try:
            drives.append(axis.shaft())
        except ValueError as error:
            raise TargetError(f"{axis.name}: its mechanism cannot do this motion: {error}") from None
    return drives


def show_files(files: Sequence[AxisFile | SwitchFile], target: Target, as_json: bool) -> None:
    """Print the certificates of files, as tables or as JSON."""
    if as_json:
        say_json([file.as_data(target) for file in files])
        return
    for file in files:
        file.show(target)


def tell_missed(files: Sequence[AxisFile], turned: SwitchFile | None, asked: Options) -> bool:
    """Print what is untested and what misses a tolerance; return whether all keeps to what was asked."""
    target = asked.target
    for claim in (*(target.untested if files else ()), *(turned.tappets.untested if turned else ())):
        say(ERR, f"Untested: {claim.what} ({claim.source})")
    missed = [f"{file.axis.name}: {cams.excess(file.certified, asked.tolerance)}"
              for file in files if file.certified.excess(asked.tolerance) > 1.0]  # fmt: skip
    if not asked.held:
        for line in missed if asked.points is None else ():
            say(ERR, f"{line}: the best there is", "yellow")
        missed = []
    missed += turned.beyond if turned else []
    for line in missed:
        say(ERR, f"{line}; nothing is written", "red")
    return not missed


def choose_axes(axes: Sequence[CamAxis], name: str | None, template: str) -> list[CamAxis]:
    """Return the axis of a name, or all; raise TargetError where there is none."""
    if not axes:
        raise TargetError(f"{template} has no axis that a controller could be given")
    chosen = [axis for axis in axes if name is None or axis.name.casefold() == name.casefold()]
    if not chosen:
        raise TargetError(f"no axis is named {name!r}; expected one of {', '.join(axis.name for axis in axes)}")
    if name is not None and len(chosen) > 1:
        raise TargetError(f"{len(chosen)} axes are named {name!r}; expected a name of its own for each")
    return chosen


def slugs(names: Sequence[str]) -> list[str]:
    """Return names of letters, digits and _, each once: behind those that would be alike stands a number."""
    plain = [re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_") for name in names]
    plain = [name if name[:1].isalpha() else f"Axis_{name}".rstrip("_") for name in plain]
    like = [name.casefold() for name in plain]
    return [
        f"{name}_{k}" if like.count(slug) > 1 else name
        for k, (name, slug) in enumerate(zip(plain, like, strict=True), 1)
    ]


def export_axis(machine: str, axis: CamAxis, name: str, asked: Options, mark: Sequence[str], path: Path) -> AxisFile:
    """Return the text of the file of a machine's axis, and the certificate of what a reader of its own finds in it."""
    target = asked.target
    best = (
        automatic(target, axis, asked.tolerance)
        if asked.points is None
        else certify_table(target, tabulate(target, axis, asked.points), axis.profile)
    )
    units, equal = (axis.x_unit, axis.y_unit), target.spacing == "equal"
    lines = (
        f"{machine}, axis {axis.name}: {target.title}",
        header(best.points, " or ".join(best.certificates), equal, units),
        *mark,
        *(f"untested: {claim.what} ({claim.source})" for claim in target.untested),
    )
    text = target.write(CamExport(best.table, name, tuple(map(visible, lines)), units, axis.repeats, *asked.signs))
    return AxisFile(axis, text, certify_table(target, reread(target, text, best.table), axis.profile), path)
