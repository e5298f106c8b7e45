"""The command ``motionbook``."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console

from workbook import build as make
from workbook import console as show
from workbook.entries import read_machine, write_machine
from workbook.errors import MotionbookError
from workbook.templates import TEMPLATES
from workbook.verify import verify as verify_book

AGREES, DISAGREES, UNREADABLE = 0, 1, 2

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Workbooks of machine motion: motion laws, timing diagram, drive. Build one, change it in Excel or "
    "LibreOffice, and verify that every formula cell still computes what the engine computes.",
)
out = Console()
err = Console(stderr=True)


def to(metavar: str, words: str) -> Any:
    """Return the option that names an output file."""
    return typer.Option("-o", "--output", metavar=metavar, help=words)


Machine = Annotated[
    Path | None,
    typer.Argument(metavar="[MACHINE.toml]", help="Machine description; the cutting machine when none is named."),
]
Book = Annotated[Path, typer.Argument(metavar="BOOK", help="A workbook built by motionbook, edited or not.")]
Force = Annotated[bool, typer.Option("--force", help="Replace the output file if it exists.")]
Json = Annotated[bool, typer.Option("--json", help="Print JSON for machines instead of a table.")]


@app.command()
def build(
    machine: Machine = None,
    output: Annotated[Path | None, to("BOOK.xlsx", "Where to write; else here, named like the description.")] = None,
    force: Force = False,
) -> None:
    """Build a workbook from a machine description."""
    source = machine or TEMPLATES["cutting-machine"].description
    target = output or Path(f"{source.stem}.xlsx")
    with err.status(f"Building {target} …"):
        make.build(read_machine(source), target, overwrite=force)
    out.print(f"Built {target.resolve()}", soft_wrap=True)


@app.command()
def verify(book: Book, as_json: Json = False) -> None:
    """Compare every formula cell of a workbook with the engine, at the values entered in it.

    Exit code 0: every cell agrees. 1: some do not. 2: the book cannot be read.
    """
    with err.status(f"Verifying {book} …"):
        report = verify_book(book)
    if as_json:
        print(show.report_json(report))
    else:
        show.show_report(report, out)
    raise typer.Exit(AGREES if report.agrees else DISAGREES)


@app.command()
def inputs(
    book: Book,
    output: Annotated[Path | None, to("MACHINE.toml", "Where to write; else to the terminal.")] = None,
    force: Force = False,
) -> None:
    """Read what was entered into a workbook, as a machine description."""
    with err.status(f"Reading {book} …"):
        machine, computed = make.inputs(book)
    for cell in computed:
        err.print(f"Note: {cell} holds a formula; its value is taken.")
    if output is None:
        print(write_machine(machine), end="")
        return
    make.write_inputs(machine, output, overwrite=force)
    out.print(f"Wrote {output.resolve()}", soft_wrap=True)


@app.command()
def regenerate(
    book: Book,
    output: Annotated[Path, to("NEW.xlsx", "Where to write the new workbook.")],
    force: Force = False,
) -> None:
    """Build a workbook anew from what was entered into an old one: its inputs, today's formulas."""
    with err.status(f"Regenerating {book} …"):
        machine, computed = make.inputs(book)
        make.build(machine, output, overwrite=force)
    for cell in computed:
        err.print(f"Note: {cell} held a formula; its value is taken.")
    out.print(f"Built {output.resolve()}", soft_wrap=True)


@app.command()
def templates(
    check: Annotated[bool, typer.Option("--check", help="Write nothing; fail if a template is stale.")] = False,
) -> None:
    """Generate the workbooks in templates/ from the machine descriptions beside them."""
    with err.status("Generating the templates …"):
        stale = make.stale_templates() if check else []
        written = [] if check else make.write_templates()
    for path in written:
        out.print(f"Built {path}", soft_wrap=True)
    for path in stale:
        err.print(f"{path}: stale; run 'motionbook templates' and commit it", soft_wrap=True)
    if check and not stale:
        out.print(f"{len(TEMPLATES)} template(s) up to date")
    raise typer.Exit(DISAGREES if stale else AGREES)


@app.command()
def laws(as_json: Json = False) -> None:
    """List the motion laws with their coefficients, for unit rise and time."""
    if as_json:
        print(json.dumps(show.catalogue(), ensure_ascii=False, indent=1))
    else:
        show.show_catalogue(out)


def main() -> None:
    """Run the command; what the file or the engineer can mend is said in lines, without a traceback."""
    try:
        app()
    except MotionbookError as error:
        for line in str(error).splitlines():
            err.print(line, style="red", markup=False, highlight=False, soft_wrap=True)
        sys.exit(UNREADABLE)
