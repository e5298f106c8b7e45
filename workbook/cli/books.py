"""The command line ``motionbook``, options that several commands have, and commands from a new machine to its verdict.

Each command loads what it does when it is called.
"""

from pathlib import Path
from typing import Annotated, Any, Literal

import typer
from typer import Argument, Option

from workbook import __version__, commands
from workbook.controllers.registry import TARGETS
from workbook.errors import AGREES
from workbook.witnesses.registry import ALL, WITNESSES

app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


def flag(name: str, words: str, **ways: Any) -> Any:
    """Return an option that is off unless it is named."""
    return Option(False, name, help=words, **ways)


def option(metavar: str, words: str, *names: str, default: Any = None, **ways: Any) -> Any:
    """Return an option that takes a value; it must be there if its default is ``...``."""
    return Option(default, *names, metavar=metavar, help=words, **ways)


def to(metavar: str, words: str, *names: str, default: Any = None) -> Any:
    """Return the option that names a file to be written: the output unless told otherwise."""
    return option(metavar, words, *(names or ("-o", "--output")), default=default)


def tell_version(asked: bool) -> None:
    """Print the version, and leave."""
    if asked:
        print(f"motionbook {__version__}")
        raise typer.Exit(AGREES)


@app.callback()
def motionbook(version: bool = flag("--version", "Print the version.", callback=tell_version, is_eager=True)) -> None:
    """Workbooks of machine motion: motion laws, timing diagram, drive.

    Build one, change it in Excel or LibreOffice, and verify that every formula cell still computes the engine's value.
    """


def witness_named(name: str) -> str:
    """Return the name of a witness; raise BadParameter where there is none of that name."""
    if name not in (*WITNESSES, ALL):
        raise typer.BadParameter(f"no witness is named {name!r}; expected one of {', '.join((*WITNESSES, ALL))}")
    return name


def named_place(name: str) -> Path:
    """Return the file or folder of a name; raise BadParameter for an empty one, which Python takes for this folder."""
    if not name:
        raise typer.BadParameter("the name is empty; expected that of a workbook or a folder")
    return Path(name)


Book = Annotated[Path, Argument(metavar="BOOK", help="A workbook built by motionbook, edited or not.")]
Force = Annotated[bool, Option("--force", help="Replace the output file if it exists.")]
Json = Annotated[bool, Option("--json", help="Print JSON for machines instead of a table.")]
Scheduler = Annotated[
    str | None,
    Option(metavar="tcp://HOST:PORT", help="The scheduler of a Dask cluster; else processes of this machine."),
]
Jobs = Annotated[int | None, Option(min=1, metavar="N", help="Processes at once; else one a core.")]
Of = Annotated[
    Literal["load", "shaft"],
    Option(metavar="load|shaft", help="The motion of the load, or the angle of the motor's shaft."),
]
Fresh = Annotated[bool, Option("--fresh", help="Verify the book again, also where these bytes were verified before.")]
Source = Annotated[str, Option("--from", metavar="TARGET", help=f"Whose file: {', '.join(TARGETS)}.")]
CamFile = Annotated[Path, Argument(metavar="FILE", help="A controller's cam table.")]


@app.command()
def new(
    template: Annotated[str, Argument(metavar="TEMPLATE", help="The kind of machine, such as machine.")],
    output: Path | None = to("FILE.toml", "Where to write; else here, named like the template."),
    force: Force = False,
) -> None:
    """Write a description with every key explained, to be changed and built; its schema beside it."""
    commands.make.new(template, output, force)


@app.command("new-template")
def new_template(
    name: Annotated[str, Argument(metavar="NAME", help="What your kind of machine is called, such as hoist.")],
    output: Path | None = to("FOLDER", "The folder to make; else motionbook-NAME, here."),
) -> None:
    """Write a package with a template of your own, to be changed: it installs, builds, verifies and tests itself."""
    commands.make.new_template(name, output)


@app.command()
def schema(
    template: str | None = Argument(None, metavar="[TEMPLATE]", help="The kind of machine; any when none is named."),
    output: Path | None = to("FILE.json", "Where to write; else to the terminal."),
    force: Force = False,
) -> None:
    """Write the JSON Schema of descriptions, from which an editor completes their keys."""
    commands.make.schema(template, output, force)


MACHINE = "Machine description; the cutting machine when none is named."


@app.command()
def build(
    machine: Path | None = Argument(None, metavar="[MACHINE.toml]", help=MACHINE),
    output: Path | None = to("BOOK.xlsx", "Where to write; else here, named like the description."),
    motors: Path | None = option("MOTORS.csv", "Motors to choose among; else those in or beside the description."),
    reducers: Path | None = option("REDUCERS.csv", "Reducers to choose among, likewise."),
    keep: Path | None = to(
        "OLD.xlsx", "Take along what you added to this book; it may be the file to replace.", "--keep"
    ),
    force: Force = False,
) -> None:
    """Build a workbook from a machine description.

    What of its numbers does not do, or is missing, is built too: its checks FAIL, and are named here. Exit code 3 then,
    0 where all hold.
    """
    raise typer.Exit(commands.make.build(machine, output, motors, reducers, force, keep))


PLACES = "Workbooks built by motionbook, or folders of them."
ASKED = (
    "Who evaluates the formulas, pycel unless told otherwise; may be given several times. All: all that "
    "are on this machine."
)


@app.command()
def verify(
    books: Annotated[list[Path], Argument(metavar="BOOK|FOLDER...", parser=named_place, help=PLACES)],
    as_json: Json = False,
    report: Path | None = to("FILE.html", "Write a report as one page of HTML.", "--report"),
    junit: Path | None = to("FILE.xml", "Write JUnit XML for CI servers.", "--junit"),
    sarif: Path | None = to("FILE.sarif", "Write SARIF 2.1.0 for code hosts.", "--sarif"),
    force: bool = flag("--force", "Replace the report files if they exist."),
    witnesses: list[str] | None = option("|".join((*WITNESSES, ALL)), ASKED, "--with", parser=witness_named),
    jobs: Jobs = None,
    scheduler: Scheduler = None,
    everything: bool = flag("--all", "List every finding, also what only follows from others."),
    against: Path | None = option("FILE", "Compare any workbook with what this .py or .xlsx declares of it."),
    cases: int = option("N", "With --against: values tried.", default=100, min=1, max=100_000),
    cover: float | None = option("PER CENT", "With --against: fail if less is covered.", min=0, max=100),
    marked: Path | None = to("OUT.xlsx", "With --against: colour a copy by class.", "--marked"),
    stamp: bool = flag("--stamp", "Write of each book that agrees a copy, BOOK-verified.xlsx, which says so."),
    in_place: bool = flag("--in-place", "With --stamp: write it into the book itself."),
) -> None:
    """Compare every formula cell of workbooks with the engine, at the values entered in them.

    Of a folder, and the folders in it, every workbook that motionbook built is verified. No workbook is written to
    unless by --stamp --in-place.

    Exit code 0: every cell agrees, and the machine passes its own checks. 1: some cells do not agree. 2: a book cannot
    be read, or there is none to verify. 3: the cells agree, and the design is unfinished or fails a check of its own.
    """
    if in_place and not stamp:
        raise typer.BadParameter("--in-place says where the stamp goes; expected --stamp with it")
    if against is not None:
        if len(books) != 1:
            raise typer.BadParameter(f"--against takes one workbook; {len(books)} are named")
        raise typer.Exit(commands.oracle.against(books[0], against, cases, cover, marked, as_json, force, witnesses))
    more = everything, scheduler, stamp, in_place
    raise typer.Exit(commands.verify.verify(books, as_json, report, junit, sarif, force, witnesses, jobs, *more))


@app.command()
def inputs(
    book: Book,
    output: Path | None = to("MACHINE.toml", "Where to write; else to the terminal."),
    force: Force = False,
) -> None:
    """Read what was entered into a workbook, as a machine description."""
    commands.make.inputs(book, output, force)


@app.command()
def regenerate(
    book: Book, output: Path = to("NEW.xlsx", "Where to write the new workbook.", default=...), force: Force = False
) -> None:
    """Build a workbook anew from what was entered into an old one: its inputs, today's formulas.

    Exit code 3 where its checks FAIL, as of build.
    """
    raise typer.Exit(commands.make.regenerate(book, output, force))


@app.command()
def diff(
    old: Annotated[Path, Argument(metavar="OLD", help="A workbook built by motionbook, or a description.")],
    new: Annotated[Path, Argument(metavar="NEW", help="Another one of the same template.")],
    as_json: Json = False,
    html: Path | None = to("FILE.html", "Write a page with both timing diagrams.", "--html"),
    force: Force = False,
    everything: bool = flag("--all", "List everything: every result and every cell."),
) -> None:
    """Tell what differs between two workbooks or descriptions: entries, results, checks, formulas, cells of your own.

    Exit code 0: nothing differs. 1: something does. 2: one of them cannot be read.
    """
    raise typer.Exit(commands.oracle.diff(old, new, as_json, html, force, everything))


@app.command()
def templates(check: bool = flag("--check", "Write nothing; fail if a template is stale.")) -> None:
    """Generate the workbooks in templates/ from the machine descriptions beside them."""
    raise typer.Exit(commands.make.templates(check))
