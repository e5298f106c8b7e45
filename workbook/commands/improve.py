"""Say what would make a machine faster; write the description with the best laws."""

from pathlib import Path

from workbook.build import failing_checks, read_description
from workbook.cluster import pool
from workbook.errors import AGREES, FAILS
from workbook.fields.paths import spell
from workbook.fields.units import PER_MINUTE, shown
from workbook.pool import Pool
from workbook.reading.descriptions import parse_toml
from workbook.reports.terminal import ERR, OUT, say
from workbook.reports.terminal import shown as escaped
from workbook.studies.improve import STAGES, Design, Done, better, edited, first_design, obstacles, single_gains
from workbook.templates import TEMPLATES
from workbook.text_files import read_text
from workbook.writing.output_files import refuse_existing, refuse_itself, write_text

DESCRIPTION = "a machine description, a .toml file"


def improve(path: Path, output: Path | None, stage: str, jobs: int | None, force: bool) -> int:
    """Print what limits a machine and what changes gain; write the best design of a stage; return the exit code."""
    refuse_itself(output, path)
    if output is not None:
        refuse_existing(output, force)
    with ERR.status("Looking for what limits the rate …") as status:

        def done(count: int, total: int, words: str) -> None:
            status.update(escaped(f"Trying {count} of {total}: {words}"))

        sizes = parse_toml(read_text(path, DESCRIPTION), path).get("sizes", {})
        design = first_design(read_description(path), "motion_pieces" in sizes)
        show_limits(design)
        with pool(jobs or 1, None) as workers:
            best = show_gains(design, stage, workers, done)
    if output is None:
        return AGREES
    if best is design:
        say(ERR, f"{output} is not written: no better design is known", "yellow")
        return AGREES
    return write_best(path, best, output, force)


def show_limits(design: Design) -> None:
    """Print the limits of a design in their order."""
    for n, obstacle in enumerate(obstacles(design)):
        words = f"{obstacle.axis}, {obstacle.limit.limit} ({obstacle.where})"
        say(OUT, f"{'then' if n else 'Highest rate:'} {per_minute(obstacle.limit.rate)}: {words}", "" if n else "bold")


def show_gains(design: Design, stage: str, workers: Pool, done: Done) -> Design:
    """Print the gains of single changes, and the best design of each stage; return that of a stage, or of what is done.

    Stages after it are worked out for their rates alone.
    """
    best, chosen, written = design, design, False
    try:
        for gain in single_gains(design, workers, done):
            say(OUT, f"  {gain.line}")
        for name, (words, kinds) in STAGES.items():
            for faster in better(best, kinds, workers, done):
                best, chosen = faster, chosen if written else faster
            written = written or name == stage
            rate = min(best.exact(axis).rate for axis in best.rates)
            more = 100.0 * (best.rate / design.rate - 1.0)
            say(OUT, f"Best {words}: {per_minute(rate)} ({more:+.1f} %)", "bold")
    except KeyboardInterrupt:
        say(ERR, "Interrupted: the best so far stands.", "yellow")
    for place, value in chosen.changes.items():
        if place[0] != "laws":
            say(OUT, f"  {spell(place)} = {value}")
    return chosen


def write_best(path: Path, best: Design, output: Path, force: bool) -> int:
    """Write the description of the best design, and print which of its checks fail; return the exit code."""
    with ERR.status(escaped(f"Writing and judging {output} …")):
        write_text(output, edited(path, best), force)
        machine = read_description(output)
        template = TEMPLATES[machine.template]
        failing = failing_checks(template.declare(machine), template.judge(machine))
    say(OUT, f"Wrote {output.absolute()}")
    for line in failing:
        say(ERR, f"FAIL {line}", "yellow")
    return FAILS if failing else AGREES


def per_minute(rate: float) -> str:
    """Return a rate (1/s) in words."""
    return f"{shown(rate, PER_MINUTE):.1f} cycles/min"
