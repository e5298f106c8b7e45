"""The command ``motionbook``."""

from __future__ import annotations

import io
import json
import sys
from datetime import datetime
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console
from typer.exceptions import TyperException

from workbook import build as make
from workbook.errors import MotionbookError
from workbook.functions import oxt
from workbook.judging import many
from workbook.judging.many import AGREES, DISAGREES, UNREADABLE
from workbook.judging.verify import ALL, present
from workbook.reading.entries import write_machine
from workbook.reports import console as show
from workbook.reports import page as reports
from workbook.reports import summary
from workbook.reports.junit import junit as junit_xml
from workbook.reports.terminal import say, say_data, shown
from workbook.templates import TEMPLATES
from workbook.witnesses import WITNESSES

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


def report_to(option: str, metavar: str, words: str) -> Any:
    """Return the option that names a report's file."""
    return typer.Option(option, metavar=metavar, help=words)


def catalogue(metavar: str, words: str) -> Any:
    """Return the option that names a catalogue; the name of its parameter is the option's."""
    return typer.Option(metavar=metavar, help=words)


def witness_named(name: str) -> str:
    """Return the name of a witness; raise BadParameter where there is none of that name."""
    if name not in (*WITNESSES, ALL):
        raise typer.BadParameter(f"no witness is named {name!r}; expected one of {', '.join((*WITNESSES, ALL))}")
    return name


def chosen(names: list[str] | None) -> list[str]:
    """Return the witnesses to ask, each once, in the order named; raise WitnessError for one that is absent."""
    found = list(dict.fromkeys(names or ["pycel"]))
    present(found)
    return found


Machine = Annotated[
    Path | None,
    typer.Argument(metavar="[MACHINE.toml]", help="Machine description; the cutting machine when none is named."),
]
Book = Annotated[Path, typer.Argument(metavar="BOOK", help="A workbook built by motionbook, edited or not.")]
Books = Annotated[
    list[Path], typer.Argument(metavar="BOOK|FOLDER...", help="Workbooks built by motionbook, or folders of them.")
]
Force = Annotated[bool, typer.Option("--force", help="Replace the output file if it exists.")]
Json = Annotated[bool, typer.Option("--json", help="Print JSON for machines instead of a table.")]
With = Annotated[
    list[str] | None,
    typer.Option(
        "--with",
        metavar="|".join((*WITNESSES, ALL)),
        parser=witness_named,
        help="Who evaluates the formulas, pycel unless told otherwise; may be given several times. All: all that are "
        "on this machine.",
    ),
]


@app.command()
def build(
    machine: Machine = None,
    output: Annotated[Path | None, to("BOOK.xlsx", "Where to write; else here, named like the description.")] = None,
    motors: Annotated[
        Path | None, catalogue("MOTORS.csv", "Motors to choose among; else those in or beside the description.")
    ] = None,
    reducers: Annotated[Path | None, catalogue("REDUCERS.csv", "Reducers to choose among, likewise.")] = None,
    force: Force = False,
) -> None:
    """Build a workbook from a machine description."""
    source = machine or TEMPLATES["cutting-machine"].description
    target = output or Path(f"{source.stem}.xlsx")
    with err.status(shown(f"Building {target} …")):
        make.build(make.described(source, motors, reducers), target, overwrite=force)
    say(out, f"Built {target.absolute()}")


@app.command()
def verify(
    books: Books,
    as_json: Json = False,
    report: Annotated[Path | None, report_to("--report", "FILE.html", "Write a report as one page of HTML.")] = None,
    junit: Annotated[Path | None, report_to("--junit", "FILE.xml", "Write JUnit XML for CI servers.")] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace the report files if they exist.")] = False,
    witnesses: With = None,
    jobs: Annotated[int | None, typer.Option(min=1, metavar="N", help="Processes at once; else one a core.")] = None,
) -> None:
    """Compare every formula cell of workbooks with the engine, at the values entered in them.

    Of a folder, and the folders in it, every workbook that motionbook built is verified. No workbook is written to.

    Exit code 0: every cell agrees, and the machine passes its own checks. 1: some cells do not agree. 2: a book cannot
    be read, or there is none to verify. 3: the cells agree, and the design is unfinished or fails a check of its own.
    """
    reports.ready(report, (".html", ".htm"), force)
    reports.ready(junit, (".xml",), force)
    asked = chosen(witnesses)
    targets, failed = many.find(books)
    with summary.progress(err, len(targets)) as done:
        outcomes = many.verify_many(targets, asked, jobs, done) + failed
    summary.show(outcomes, out, err, as_json, alone=len(books) == 1 and not many.is_folder(books[0]))
    when = datetime.now().astimezone()
    reports.write(report, lambda: reports.page(outcomes, when), force)
    reports.write(junit, lambda: junit_xml(outcomes, when), force)
    raise typer.Exit(many.exit_code(outcomes))


@app.command()
def inputs(
    book: Book,
    output: Annotated[Path | None, to("MACHINE.toml", "Where to write; else to the terminal.")] = None,
    force: Force = False,
) -> None:
    """Read what was entered into a workbook, as a machine description."""
    with err.status(shown(f"Reading {book} …")):
        machine, notes = make.inputs(book)
    show_notes(notes)
    if output is None:
        say_data(write_machine(machine))
        return
    make.write_inputs(machine, output, overwrite=force)
    say(out, f"Wrote {output.absolute()}")


@app.command()
def regenerate(
    book: Book,
    output: Annotated[Path, to("NEW.xlsx", "Where to write the new workbook.")],
    force: Force = False,
) -> None:
    """Build a workbook anew from what was entered into an old one: its inputs, today's formulas."""
    with err.status(shown(f"Regenerating {book} …")):
        machine, notes = make.inputs(book)
        make.build(machine, output, overwrite=force)
    show_notes(notes)
    say(out, f"Built {output.absolute()}")


@app.command()
def templates(
    check: Annotated[bool, typer.Option("--check", help="Write nothing; fail if a template is stale.")] = False,
) -> None:
    """Generate the workbooks in templates/ from the machine descriptions beside them."""
    with err.status("Generating the templates …"):
        stale = make.stale_templates() if check else []
        written = [] if check else make.write_templates()
    for path in written:
        say(out, f"Built {path}")
    for path in stale:
        say(err, f"{path}: stale; run 'motionbook templates' and commit it")
    if check and not stale:
        out.print(f"{len(make.committed())} workbooks up to date")
    raise typer.Exit(DISAGREES if stale else AGREES)


@app.command()
def addin(
    output: Annotated[Path, to("MOTION.oxt", "Where to write the add-in.")] = Path("motion.oxt"),
    force: Force = False,
) -> None:
    """Write the LibreOffice add-in, which brings the functions MOTION.* to Calc; open it to install it."""
    oxt.write(output, overwrite=force)
    say(out, f"Wrote {output.absolute()}")


@app.command()
def laws(as_json: Json = False) -> None:
    """List the motion laws with their coefficients, for unit rise and time."""
    if as_json:
        say_data(f"{json.dumps(show.catalogue(), ensure_ascii=False, indent=1)}\n")
    else:
        show.show_catalogue(out)


def show_notes(notes: list[str]) -> None:
    """Print what was not carried over."""
    for note in notes:
        say(err, f"Note: {note}")


def main() -> None:
    """Run the command; what the file or the engineer can mend is said in lines, without a traceback."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # names of files, on terminals that lack their letters
    try:
        sys.exit(app(standalone_mode=len(sys.argv) < 2) or AGREES)  # what typer prints by itself is not escaped
    except TyperException as error:
        say(err, f"{error.format_message()} See --help.", "red")
        sys.exit(UNREADABLE)
    except MotionbookError as error:
        for line in str(error).splitlines():
            say(err, line, "red")
        sys.exit(UNREADABLE)
    except Exception as error:  # to whoever runs it, a fault of ours is no verdict either
        if sys.flags.dev_mode:
            raise
        said = "out of memory" if isinstance(error, MemoryError) else f"{type(error).__name__}: {error}"
        say(err, f"motionbook failed inside ({said[:200]}); please report this", "red")
        sys.exit(UNREADABLE)
