"""The motion that runs in a machine: a controller's file read, identified, and compared with a book's axis."""

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from engine.cams.identify import THINNED
from engine.motion.profile import SAME
from workbook.commands.export import LOAD, SHAFT, choose_axes, parse_tolerance, shafts
from workbook.commands.switch_export import SwitchFile, switch_format
from workbook.commands.verify import open_finished, verified_header
from workbook.controllers import as_description
from workbook.controllers.registry import target as target_named
from workbook.controllers.table import Table, equidistant
from workbook.controllers.tabulation import certify_table
from workbook.controllers.target import Target, Track, differences, read_table, text_of
from workbook.errors import AGREES, DISAGREES, ReadError, TargetError, visible
from workbook.reading.descriptions import make_machine, template_named, write_machine
from workbook.reports.cams import certificate_data, excess, show
from workbook.reports.terminal import ERR, print_or_write, say, say_data, say_json
from workbook.template_outputs import CamAxis, CamSwitch
from workbook.templates import TEMPLATES
from workbook.writing.output_files import refuse_existing, refuse_itself

TURN = as_description.TURN
LONGEST, LONGEST_NAME = 80, 24  # characters of a title, and of a switch's name
NEAR = 1e-6  # of the cycle: so far the file's may be from the book's


def read(file: Path, source: str, output: Path | None, force: bool, tolerance: str | None = None) -> None:
    """Tell what a controller's file was built of, and write it as a description."""
    target = target_named(source)
    order, share = parse_tolerance(tolerance) if tolerance is not None else ("y", THINNED)
    if order != "y":
        raise TargetError(f"--tolerance {tolerance}: expected y and a share of the reach, as y=0.01%")
    refuse_itself(output, file)
    refuse_existing(output, force)
    table = read_table(file, target)
    told = as_description.UNITS.search(text_of(file, target))
    units = (told[1], told[2]) if told else ("°", "mm")
    try:
        moves = as_description.phases_of(target, table, units, share)
    except np.linalg.LinAlgError as error:
        raise TargetError(f"{file}: no motion can be fitted to its points ({error})") from error
    title = f"Read from {visible(file.name)}"
    title = title if len(title) <= LONGEST else f"{title[: LONGEST - 1]}…"
    data = as_description.compose(moves, table, units, title)
    machine = make_machine(template_named(data["template"], str(file)), data, lambda key: f"{file}: {key}")
    span = f"{table.x[0]:.9g} to {table.x[-1]:.9g} {units[0]}"
    say(ERR, f"{len(table.x):,} points, {span}; {len(moves.phases)} movements")
    for line in as_description.movement_lines(moves, units):
        say(ERR, line)
    profile = TEMPLATES[machine.template].axes(machine)[0].profile
    say(ERR, as_description.require_points(moves, table, profile, units))
    if moves.delay:
        say(ERR, f"It begins on the way: written as an axis that is {moves.delay:.9g} {units[0]} later")
    step, reach = float(table.x[1] - table.x[0]), float(table.x[-1] - table.x[0])
    # as of a column a degree
    if units[0] == "°" and equidistant(table.x) and abs(reach + step - TURN) < NEAR * TURN:
        text = f"x ends at {table.x[-1]:.9g}, a step before the turn is over: the cycle is told without its last step"
        say(ERR, f"{text}; if it is a turn, add its end", "yellow")
    print_or_write(write_machine(machine), output, force)


def read_switches(file: Path, source: str, output: Path | None) -> None:
    """Tell the switches of a controller's file as entries of a machine's description."""
    if output is not None:
        raise TargetError("switches alone are no machine; expected no -o: paste what is printed into a description")
    lanes, rows = read_tracks(file, target_named(source)), []
    say(ERR, f"{len(lanes)} switches, {sum(len(lane.on) for lane in lanes)} times of being on")
    for lane in lanes:
        times = ", ".join(f"[{begin:.9g}, {end:.9g}]" for begin, end in lane.on)
        name = json.dumps(visible(lane.name)[:LONGEST_NAME], ensure_ascii=False)
        rows.append(f"[[switches]]\nname = {name}\non = [{times}]\n")
    say_data("\n".join(rows))


def compare(
    book: Path,
    file: Path,
    axis: str | None,
    source: str,
    tolerance: Sequence[str],
    unverified: bool,
    as_json: bool,
    switches: bool = False,
    of: str = LOAD,
    fresh: bool = False,
) -> int:
    """Compare what a controller makes of a file with an axis of a book, or with its switches; return the exit code."""
    target = target_named(source)
    if switches == (axis is not None):
        raise TargetError("expected either --axis NAME or --switches")
    if switches:
        read_tracks(file, target)  # what cannot be read is reported before the book is verified
    held = dict(map(parse_tolerance, tolerance)) or dict(target.tolerance)
    table = None if switches else read_table(file, target)
    machine, before = open_finished(book)
    template = TEMPLATES[machine.template]
    meant = None if table is None else choose_axes(template.axes(machine), axis, template.name)[0]
    if meant and of == SHAFT:
        (meant,) = shafts([meant], everything=False)
    verified_header(book, before, unverified, fresh)
    if table is None or meant is None:
        return compare_tracks(book, template.switches(machine), file, target, as_json)
    require_same_cycle(file, table, meant)
    certified = certify_table(target, table, meant.profile)
    if as_json:
        say_json(certificate_data(meant, certified, target, str(file)))
    else:
        show(meant, certified, target)
    if certified.excess(held) <= 1.0:
        return AGREES
    say(ERR, f"{meant.name}: {excess(certified, held)}", "red")
    return DISAGREES


def require_same_cycle(file: Path, table: Table, axis: CamAxis) -> None:
    """Raise TargetError where the table of a file begins or ends elsewhere than the cycle of an axis."""
    profile = axis.profile
    for given, own in zip(table.x[[0, -1]], profile.edges[[0, -1]], strict=True):
        if abs(float(given) - float(own)) > max(NEAR, SAME) * profile.total:
            raise TargetError(
                f"{file}: x runs from {table.x[0]:.9g} to {table.x[-1]:.9g}; {axis.name} from "
                f"{profile.edges[0]:.9g} to {profile.edges[-1]:.9g} {axis.x_unit}: expected the same cycle"
            )


def read_tracks(file: Path, target: Target) -> list[Track]:
    """Return the switches of a controller's file; raise ReadError, in a line, where it is none."""
    tappets = switch_format(target)
    try:
        return tappets.read(text_of(file, target))
    except TargetError as error:
        raise ReadError(f"{file}: {error}") from None


def compare_tracks(book: Path, lanes: Sequence[CamSwitch], file: Path, target: Target, as_json: bool) -> int:
    """Compare the switches of a file with those of a book; return the exit code."""
    tappets = switch_format(target, lanes)
    pairs = list(zip(lanes, differences(lanes, read_tracks(file, target)), strict=True))
    compared = SwitchFile(pairs, "", tappets, file)
    if as_json:
        say_json(compared.as_data(target))
    else:
        compared.show(target)
    for line in compared.beyond:
        say(ERR, f"{line}: {book.name} has it elsewhere", "red")
    return DISAGREES if compared.beyond else AGREES
