"""Say what would make a machine better; write the description of the best design."""

from datetime import datetime
from functools import partial
from pathlib import Path

from workbook.build import failing_checks, read_entered, write_book
from workbook.cluster import pool
from workbook.description.editing import edit_text
from workbook.entries.machine import Machine
from workbook.errors import AGREES, FAILS, InputError
from workbook.fields.paths import spell
from workbook.fields.units import PER_MINUTE, shown
from workbook.improving import AIMS, AimName
from workbook.pool import Pool
from workbook.reading.descriptions import read_machine
from workbook.reports.terminal import ERR, OUT, say
from workbook.reports.terminal import shown as escaped
from workbook.studies.design import RATE, Design, first_design
from workbook.studies.improve import STAGES, better, gain_in_words, obstacles, reshaped_laws, single_gains
from workbook.studies.improve_sheet import TITLE, improve_sheet
from workbook.studies.timing import Done
from workbook.templates import TEMPLATES
from workbook.text_files import read_text
from workbook.writing.output_files import refuse_existing, refuse_itself, refuse_suffix, write_text

DESCRIPTION = "a machine description, a .toml file"


def improve(
    path: Path,
    output: Path | None,
    stage: str,
    asked: tuple[AimName, float, float],
    axis: str,
    workers: tuple[int | None, str | None],
    force: bool,
    sheet: Path | None = None,
) -> int:
    """Print what limits a machine and what changes gain; write the best design of a stage; return the exit code.

    Into the book ``sheet`` goes what is printed, on a sheet of it. ``asked`` are the name of the aim, and natural
    frequency (Hz) and damping of a load that vibrates; ``workers`` how many processes, or the scheduler of a cluster.
    """
    name, frequency, damping = asked
    aim = AIMS[name]._replace(frequency=frequency, damping=damping)
    refuse_itself(output, path)
    refuse_existing(output, force)
    if sheet is not None:
        refuse_suffix(sheet)
        refuse_existing(sheet, force)
    with ERR.status("Looking for what limits …") as status:

        def done(count: int, total: int, words: str) -> None:
            status.update(escaped(f"Trying {count} of {total}: {words}"))

        machine, lines = read_machine(path), list[str]()
        design = first_design(machine, aim, axis)
        show_limits(design, lines)
        show_fit(design, lines)
        for line in design.improving.crossings(machine):
            show(lines, line)
        jobs, scheduler = workers
        with pool(jobs or 1, scheduler) as tasks:
            best = show_gains(design, stage, tasks, done, lines)
        if sheet is not None:
            write_sheet(machine, sheet, lines, force)
    return AGREES if output is None else write_best(path, best, output, force)


def freeze(path: Path, output: Path | None, force: bool) -> int:
    """Shape the laws anew that are shaped for their drives; print what that gains; return the exit code."""
    refuse_itself(output, path)
    refuse_existing(output, force)
    with ERR.status("Shaping laws for their drives …"):
        laws = [*reshaped_laws(first_design(read_machine(path), AIMS["acceleration"]))]
    for _, words, gain in laws:
        say(OUT, f"{words}, {gain or 'still fits'}")
    if not laws:
        expected = 'laws.OPT.shaped = "torque", or "rate"; or a shaper'
        raise InputError([f"{path}: no law is shaped for its drive or its load; expected {expected}"])
    if output is None:
        return FAILS if any(gain for *_, gain in laws) else AGREES
    return write_best(path, laws[-1][0], output, force)


def write_sheet(machine: Machine, path: Path, lines: list[str], force: bool) -> None:
    """Write the book of a machine with lines on the sheet Improve, and what was added to the book that is there."""
    old = read_entered(path)[0] if path.exists() else None
    _, notes = write_book(machine, path, force, old, partial(improve_sheet, lines, datetime.now()))
    say(OUT, f"Built {path.absolute()}, with the sheet {TITLE}")
    for note in notes:
        say(ERR, f"Note: {note}")


def show(lines: list[str], line: str, style: str = "") -> None:
    """Print a line, and add it to those that are printed."""
    say(OUT, line, style)
    lines.append(line)


def show_limits(design: Design, lines: list[str]) -> None:
    """Print the limits of a design in their order, or what is to be less."""
    if not design.aim.is_rate:
        words = f"{design.aim.words} of {design.limiting}: {design.cost:.5g} {design.aim.unit}"
        show(lines, f"{words} at {per_minute(design.rate)}", "bold")
        return
    for n, obstacle in enumerate(obstacles(design)):
        words = f"{obstacle.axis}, {obstacle.limit.limit} ({obstacle.where})"
        begin = "then" if n else "Highest rate:"
        show(lines, f"{begin} {per_minute(obstacle.limit.rate)}: {words}", "" if n else "bold")


def show_fit(design: Design, lines: list[str]) -> None:
    """Print whether laws that are shaped still fit their drives, or what shaping them anew gains."""
    try:
        for _, words, gain in reshaped_laws(design):
            show(lines, f"{words}, {gain or 'still fits'}")
    except InputError as error:  # of a law that several phases have, or none
        show(lines, str(error), "yellow")


def show_gains(design: Design, stage: str, workers: Pool, done: Done, lines: list[str]) -> Design:
    """Print the gains of single changes, and the best design of each stage; return that of a stage.

    Where that of a stage is not known yet, it is the best so far.
    """
    best, before = {"": design}, design.exact_cost
    try:
        for gain in single_gains(design, workers, done):
            show(lines, f"  {gain.sentence(design)}")
        for name, (words, kinds, begin) in STAGES.items():
            best[name] = best[begin]
            for other in better(best[begin], kinds, workers, done):
                best[name] = other
            show(lines, f"Best {words}: {gain_in_words(design, before, best[name].exact_cost)}", "bold")
    except KeyboardInterrupt:
        say(ERR, "Interrupted: the best so far stands.", "yellow")
    chosen = best.get(stage) or min(best.values(), key=lambda each: each.cost)
    for place, value in chosen.changes.items():
        if place[0] != "laws":
            show(lines, f"  {spell(place)} = {value}")
    return chosen


def write_best(path: Path, best: Design, output: Path, force: bool) -> int:
    """Write the description of the best design, and print which of its checks fail; return the exit code."""
    if not best.changes:
        say(ERR, f"{output} is not written: no better design is known", "yellow")
        return AGREES
    with ERR.status(escaped(f"Writing and judging {output} …")):
        rate = best.rate_to_write
        changes = {**best.changes} | ({RATE: rate} if rate else {})
        write_text(output, edit_text(read_text(path, DESCRIPTION), changes.items()), force)
        machine = read_machine(output)
        template = TEMPLATES[machine.template]
        failing = failing_checks(template.declare(machine), template.judge(machine))
    say(OUT, f"Wrote {output.absolute()}")
    for line in failing:
        say(ERR, f"FAIL {line}", "yellow")
    return FAILS if failing else AGREES


def per_minute(rate: float) -> str:
    """Return a rate (1/s) in words."""
    return f"{shown(rate, PER_MINUTE):.1f} cycles/min"
