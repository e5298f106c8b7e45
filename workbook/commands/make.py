"""Build a book, read its inputs, build it anew, and keep the committed templates."""

from __future__ import annotations

from pathlib import Path

from workbook import build as making
from workbook.commands.trusted import digest_of
from workbook.exits import AGREES, DISAGREES
from workbook.reading.descriptions import write_machine
from workbook.remembered import recall, remember
from workbook.reports.terminal import ERR, OUT, say, say_data, shown
from workbook.template import FOLDER
from workbook.writing.place import refuse_existing, refuse_itself, refuse_suffix, replace

INPUTS = "inputs"


def build(machine: Path | None, output: Path | None, motors: Path | None, reducers: Path | None, force: bool) -> None:
    """Build a workbook from a machine description."""
    source = machine or FOLDER / "cutting-machine.toml"
    target = output or Path(f"{source.stem}.xlsx")
    refuse_itself(target, source)
    refuse_suffix(target)
    with ERR.status(shown(f"Building {target} …")):
        described = making.described(source, motors, reducers)
        failing = making.build(described, target, overwrite=force)
    say(OUT, f"Built {target.absolute()}")
    show_failing(failing)
    show_notes(making.exact_rates(described))


def inputs(book: Path, output: Path | None, force: bool) -> None:
    """Read what was entered into a workbook."""
    refuse_itself(output, book)
    if output is not None:
        refuse_existing(output, force)
    with ERR.status(shown(f"Reading {book} …")):
        text, notes = entered(book)
    show_notes(notes)
    if output is None:
        say_data(text)
        return
    replace(output, lambda draft: making.write_text(draft, text), force)
    say(OUT, f"Wrote {output.absolute()}")


def entered(book: Path) -> tuple[str, list[str]]:
    """Return what was entered into a workbook as a description, and what it leaves behind; once for the same bytes."""
    sha256 = digest_of(book)
    known = recall(INPUTS, sha256) if sha256 else None
    if known:
        return str(known["text"]), [str(note) for note in known["notes"]]
    machine, notes = making.inputs(book)
    text = write_machine(machine)
    if sha256 and sha256 == digest_of(book):
        remember(INPUTS, sha256, {"text": text, "notes": notes})
    return text, notes


def regenerate(book: Path, output: Path, force: bool) -> None:
    """Build a workbook anew from what was entered into an old one, and what its engineer added."""
    refuse_itself(output, book)
    refuse_suffix(output)
    refuse_existing(output, force)
    with ERR.status(shown(f"Regenerating {book} …")):
        notes, failing = making.regenerate(book, output, force)
    show_notes(notes)
    say(OUT, f"Built {output.absolute()}")
    show_failing(failing)


def templates(check: bool) -> int:
    """Generate the committed workbooks, or tell the stale ones; return the exit code."""
    with ERR.status("Generating the templates …"):
        stale = making.stale_templates() if check else []
        written = [] if check else making.write_templates()
    for path in written:
        say(OUT, f"Built {path}")
    for path in stale:
        say(ERR, f"{path}: stale; run 'motionbook templates' and commit it")
    if check and not stale:
        OUT.print(f"{len(making.committed())} workbooks up to date")
    return DISAGREES if stale else AGREES


def show_failing(failing: list[str]) -> None:
    """Print the machine's own checks that do not hold."""
    for check in failing:
        say(ERR, f"FAIL  {check}", "yellow")


def show_notes(notes: list[str]) -> None:
    """Print what was not carried over."""
    for note in notes:
        say(ERR, f"Note: {note}")
