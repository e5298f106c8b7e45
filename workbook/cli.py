"""The command ``motionbook``: what can be asked of it. What is done stands in :mod:`workbook.commands`.

A command's module is loaded when it is called, so that help and a wrong option are told at once.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.exceptions import TyperException

from workbook import __version__
from workbook.controllers.names import TARGETS
from workbook.errors import MotionbookError
from workbook.exits import AGREES, UNREADABLE
from workbook.reports.terminal import ERR, lasting, say
from workbook.witnesses.names import ALL, NAMES

app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


def tell_version(asked: bool) -> None:
    """Print the version, and leave."""
    if asked:
        print(f"motionbook {__version__}")
        raise typer.Exit(AGREES)


@app.callback()
def motionbook(
    version: Annotated[
        bool, typer.Option("--version", callback=tell_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Workbooks of machine motion: motion laws, timing diagram, drive.

    Build one, change it in Excel or LibreOffice, and verify that every formula cell still computes the engine's value.
    """


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
    if name not in (*NAMES, ALL):
        raise typer.BadParameter(f"no witness is named {name!r}; expected one of {', '.join((*NAMES, ALL))}")
    return name


def named_place(name: str) -> Path:
    """Return the file or folder of a name; raise BadParameter for an empty one, which Python takes for this folder."""
    if not name:
        raise typer.BadParameter("the name is empty; expected that of a workbook or a folder")
    return Path(name)


Machine = Annotated[
    Path | None,
    typer.Argument(metavar="[MACHINE.toml]", help="Machine description; the cutting machine when none is named."),
]
Book = Annotated[Path, typer.Argument(metavar="BOOK", help="A workbook built by motionbook, edited or not.")]
Books = Annotated[
    list[Path],
    typer.Argument(
        metavar="BOOK|FOLDER...", parser=named_place, help="Workbooks built by motionbook, or folders of them."
    ),
]
Force = Annotated[bool, typer.Option("--force", help="Replace the output file if it exists.")]
Json = Annotated[bool, typer.Option("--json", help="Print JSON for machines instead of a table.")]
With = Annotated[
    list[str] | None,
    typer.Option(
        "--with",
        metavar="|".join((*NAMES, ALL)),
        parser=witness_named,
        help="Who evaluates the formulas, pycel unless told otherwise; may be given several times. All: all that are "
        "on this machine.",
    ),
]


Scheduler = Annotated[
    str | None,
    typer.Option(metavar="tcp://HOST:PORT", help="The scheduler of a Dask cluster; else processes of this machine."),
]
Jobs = Annotated[int | None, typer.Option(min=1, metavar="N", help="Processes at once; else one a core.")]


@app.command()
def new(
    template: Annotated[str, typer.Argument(metavar="TEMPLATE", help="The kind of machine, such as machine.")],
    output: Annotated[Path | None, to("FILE.toml", "Where to write; else here, named like the template.")] = None,
    force: Force = False,
) -> None:
    """Write a description with every key explained, to be changed and built; its schema beside it."""
    from workbook.commands import describe

    describe.new(template, output, force)


@app.command("new-template")
def new_template(
    name: Annotated[str, typer.Argument(metavar="NAME", help="What your kind of machine is called, such as hoist.")],
    output: Annotated[Path | None, to("FOLDER", "The folder to make; else motionbook-NAME, here.")] = None,
) -> None:
    """Write a package with a template of your own, to be changed: it installs, builds, verifies and tests itself."""
    from workbook.commands import describe

    describe.new_template(name, output)


@app.command()
def schema(
    template: Annotated[
        str | None, typer.Argument(metavar="[TEMPLATE]", help="The kind of machine; any when none is named.")
    ] = None,
    output: Annotated[Path | None, to("FILE.json", "Where to write; else to the terminal.")] = None,
    force: Force = False,
) -> None:
    """Write the JSON Schema of descriptions, from which an editor completes their keys."""
    from workbook.commands import describe

    describe.schema(template, output, force)


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
    """Build a workbook from a machine description.

    What of its numbers does not do, or is missing, is built too: its checks FAIL, and are named here.
    """
    from workbook.commands import make

    make.build(machine, output, motors, reducers, force)


@app.command()
def verify(
    books: Books,
    as_json: Json = False,
    report: Annotated[Path | None, report_to("--report", "FILE.html", "Write a report as one page of HTML.")] = None,
    junit: Annotated[Path | None, report_to("--junit", "FILE.xml", "Write JUnit XML for CI servers.")] = None,
    sarif: Annotated[Path | None, report_to("--sarif", "FILE.sarif", "Write SARIF 2.1.0 for code hosts.")] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace the report files if they exist.")] = False,
    witnesses: With = None,
    jobs: Jobs = None,
    scheduler: Scheduler = None,
    everything: Annotated[
        bool, typer.Option("--all", help="List every finding, also what only follows from others.")
    ] = False,
    against: Annotated[
        Path | None, typer.Option(metavar="FILE.py", help="Compare any workbook with what this file declares of it.")
    ] = None,
    cases: Annotated[int, typer.Option(min=1, max=100_000, metavar="N", help="With --against: values tried.")] = 100,
    cover: Annotated[
        float | None, typer.Option(min=0, max=100, metavar="PER CENT", help="With --against: fail if less is covered.")
    ] = None,
    marked: Annotated[Path | None, report_to("--marked", "OUT.xlsx", "With --against: colour a copy by class.")] = None,
) -> None:
    """Compare every formula cell of workbooks with the engine, at the values entered in them.

    Of a folder, and the folders in it, every workbook that motionbook built is verified. No workbook is written to.

    Exit code 0: every cell agrees, and the machine passes its own checks. 1: some cells do not agree. 2: a book cannot
    be read, or there is none to verify. 3: the cells agree, and the design is unfinished or fails a check of its own.
    """
    if against is not None:
        from workbook.commands import oracle as command

        if len(books) != 1:
            raise typer.BadParameter(f"--against takes one workbook; {len(books)} are named")
        asked = witnesses or command.WITNESSES
        raise typer.Exit(command.against(books[0], against, cases, cover, marked, as_json, force, asked))
    from workbook.witnesses.beside import beside

    with beside(books, witnesses, jobs) as helper:  # it begins while this process loads what judges
        from workbook.commands.verify import verify as run

        raise typer.Exit(
            run(books, as_json, report, junit, sarif, force, witnesses, jobs, everything, helper, scheduler)
        )


@app.command()
def study(
    path: Annotated[
        Path | None, typer.Argument(metavar="STUDY.toml", help="What varies, what is constrained, what is best.")
    ] = None,
    output: Annotated[
        Path | None,
        to("RESULTS", "Where to write: .csv or .parquet; with --pick, the book. Else named like the study."),
    ] = None,
    scheduler: Scheduler = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on with a study that was interrupted.")] = False,
    pick: Annotated[
        int | None, typer.Option(min=1, metavar="N", help="Build and verify the book of the N-th best design.")
    ] = None,
    jobs: Jobs = None,
    results: Annotated[
        Path | None, typer.Option("--results", metavar="BASE", help="List the results of a machine by name, and stop.")
    ] = None,
    unverified: Annotated[bool, typer.Option("--unverified", help="Do not verify the book of the best.")] = False,
    force: Force = False,
) -> None:
    """Work out many designs of a machine: laws, angles, motors, reducers, any entry; find the best.

    Writes the designs with their results, a page with the front, and what --pick needs. Feasible is a design whose book
    has no FAIL, and whose results keep to the constraints. The best one is built and verified.

    Exit code 0: there are feasible designs. 1: a design's book disagrees. 2: it cannot be done. 3: none is feasible.
    """
    from workbook.commands import study as studying

    if results is not None:
        raise typer.Exit(studying.listing(results))
    if path is None:
        raise typer.BadParameter("expected STUDY.toml, or --results BASE")
    raise typer.Exit(studying.study(path, output, scheduler, jobs, resume, pick, unverified, force))


@app.command()
def inputs(
    book: Book,
    output: Annotated[Path | None, to("MACHINE.toml", "Where to write; else to the terminal.")] = None,
    force: Force = False,
) -> None:
    """Read what was entered into a workbook, as a machine description."""
    from workbook.commands import make

    make.inputs(book, output, force)


@app.command()
def regenerate(
    book: Book,
    output: Annotated[Path, to("NEW.xlsx", "Where to write the new workbook.")],
    force: Force = False,
) -> None:
    """Build a workbook anew from what was entered into an old one: its inputs, today's formulas."""
    from workbook.commands import make

    make.regenerate(book, output, force)


Of = Annotated[
    str, typer.Option(metavar="load|shaft", help="The motion of the load, or the angle of the motor's shaft.")
]
Fresh = Annotated[
    bool, typer.Option("--fresh", help="Verify the book again, also where these bytes were verified before.")
]


@app.command()
def export(
    book: Book,
    to_target: Annotated[str, typer.Option("--to", metavar="TARGET", help=f"One of {', '.join(TARGETS)}.")],
    axis: Annotated[str | None, typer.Option(metavar="NAME", help="The axis to export.")] = None,
    everything: Annotated[
        bool, typer.Option("--all", help="Export every axis, and the switches; -o then names a folder.")
    ] = False,
    switches: Annotated[bool, typer.Option("--switches", help="Export the machine's switches.")] = False,
    output: Annotated[Path | None, to("FILE", "Where to write; else here, named like book and axis.")] = None,
    points: Annotated[
        str, typer.Option(metavar="N|auto", help="How many points; auto takes the fewest within the tolerance.")
    ] = "auto",
    equidistant: Annotated[
        bool, typer.Option("--equidistant", help="Points at equal steps, also where the format would take others.")
    ] = False,
    tolerance: Annotated[
        list[str] | None,
        typer.Option(
            metavar="a=1%",
            help="Largest error of y, v, a or j as a share of its peak; beyond it nothing is "
            "written. May be given several times.",
        ),
    ] = None,
    of: Of = "load",
    unverified: Annotated[
        bool, typer.Option("--unverified", help="Do not ask whether the book agrees; the file says so.")
    ] = False,
    fresh: Fresh = False,
    separator: Annotated[str, typer.Option(metavar="semicolon|comma|tab", help="Between columns of text.")] = (
        "semicolon"
    ),
    decimal: Annotated[str, typer.Option(metavar="point|comma", help="The decimal sign of columns of text.")] = "point",
    report: Annotated[
        Path | None, report_to("--report", "FILE.html", "Write the certificates as a page with pictures.")
    ] = None,
    as_json: Json = False,
    force: Force = False,
) -> None:
    """Write an axis of a book as a controller's cam table, and certify what the controller makes of it.

    The file is read back by an independent reader, the motion rebuilt by the target's rule and compared with the
    engine over the whole cycle. docs/controllers.md says which layout comes from which document, and what is untested;
    no controller was run. Told as untested, there and in the file's header: what x counts from in siemens-segments, br
    beyond one polynomial, the ends of a spline, and more. Switches go out where a document says how.

    Exit code 0: written. 1: the book disagrees, its design is unfinished, or a tolerance is not kept. 2: it cannot be.
    """
    from workbook.commands import export as exporting

    asked = exporting.asked_for(to_target, points, tolerance or (), separator, decimal, unverified, equidistant, of)
    raise typer.Exit(exporting.export(book, axis, asked, output, everything, force, as_json, report, switches, fresh))


Source = Annotated[str, typer.Option("--from", metavar="TARGET", help=f"Whose file: {', '.join(TARGETS)}.")]
CamFile = Annotated[Path, typer.Argument(metavar="FILE", help="A controller's cam table.")]


@app.command()
def read(
    file: CamFile,
    source: Source,
    output: Annotated[Path | None, to("MACHINE.toml", "Where to write; else to the terminal.")] = None,
    tolerance: Annotated[
        str | None,
        typer.Option(metavar="y=0.01%", help="Largest error of a spline through few points, as a share of the reach."),
    ] = None,
    switches: Annotated[bool, typer.Option("--switches", help="Tell a file's switches as entries.")] = False,
    force: Force = False,
) -> None:
    """Read a controller's cam table as the description of a machine of one axis.

    Dwells and turns part it; each movement is the first law of the registry that keeps to its points within their
    precision, also where phases meet at speed, else a cubic spline through as few of them as keep to the tolerance
    (0.01 % of the reach unless told otherwise). A turn of a shaft that begins on the way is written as an axis
    with a shift. Build, verify and export what is written: the way back is closed.
    """
    from workbook.commands import cams

    if switches:
        cams.read_switches(file, source, output)
    else:
        cams.read(file, source, output, force, tolerance)


@app.command()
def compare(
    book: Book,
    file: CamFile,
    source: Source,
    axis: Annotated[str | None, typer.Option(metavar="NAME", help="The axis of the book.")] = None,
    switches: Annotated[bool, typer.Option("--switches", help="Compare the machine's switches.")] = False,
    tolerance: Annotated[
        list[str] | None, typer.Option(metavar="a=1%", help="Largest error of y, v, a or j as a share of its peak.")
    ] = None,
    of: Of = "load",
    unverified: Annotated[bool, typer.Option("--unverified", help="Do not ask whether the book agrees.")] = False,
    fresh: Fresh = False,
    as_json: Json = False,
) -> None:
    """Compare what a controller makes of a cam table with an axis of a book, or its switches with the book's.

    Exit code 0: within the tolerance over the whole cycle. 1: beyond it, or the book disagrees. 2: it cannot be read.
    """
    from workbook.commands import cams

    raise typer.Exit(cams.compare(book, file, axis, source, tolerance or (), unverified, as_json, switches, of, fresh))


@app.command()
def serve(
    folder: Annotated[Path, typer.Argument(metavar="[FOLDER]", help="The folder with your machines.")] = Path(),
    port: Annotated[int, typer.Option(min=0, max=65535, help="The port; 0 takes a free one.")] = 0,
    browse: Annotated[bool, typer.Option(help="Open the browser.")] = True,
) -> None:
    """Work in the browser: new machines, build, verify, compare. Nobody but this computer can reach it."""
    from workbook.commands import serve as command

    command.serve(folder, port, browse)


@app.command()
def oracle(
    book: Annotated[Path, typer.Argument(metavar="BOOK", help="Any workbook.")],
    output: Annotated[Path | None, to("FILE.py", "Where to write; else it is printed.")] = None,
    force: Force = False,
) -> None:
    """Write a first file of declarations for any workbook, for `motionbook verify BOOK --against FILE.py`."""
    from workbook.commands import oracle as command

    command.write_draft(book, output, force)


@app.command()
def diff(
    old: Annotated[Path, typer.Argument(metavar="OLD", help="A workbook built by motionbook, or a description.")],
    new: Annotated[Path, typer.Argument(metavar="NEW", help="Another one of the same template.")],
    as_json: Json = False,
    html: Annotated[Path | None, report_to("--html", "FILE.html", "Write a page with both timing diagrams.")] = None,
    force: Force = False,
) -> None:
    """Tell what differs between two workbooks or descriptions: entries, results, checks, formulas, cells of your own.

    Exit code 0: nothing differs. 1: something does. 2: one of them cannot be read.
    """
    from workbook.commands import diff as command

    raise typer.Exit(command.diff(old, new, as_json, html, force))


@app.command()
def templates(
    check: Annotated[bool, typer.Option("--check", help="Write nothing; fail if a template is stale.")] = False,
) -> None:
    """Generate the workbooks in templates/ from the machine descriptions beside them."""
    from workbook.commands import make

    raise typer.Exit(make.templates(check))


@app.command()
def addin(
    output: Annotated[Path, to("MOTION.oxt", "Where to write the add-in.")] = Path("motion.oxt"),
    force: Force = False,
) -> None:
    """Write the LibreOffice add-in, which brings the functions MOTION.* to Calc; open it to install it."""
    from workbook.commands import functions

    functions.addin(output, force)


@app.command()
def laws(as_json: Json = False) -> None:
    """List the motion laws with their coefficients, for unit rise and time."""
    from workbook.commands import functions

    functions.laws(as_json)


def main() -> None:
    """Run the command; what the file or the engineer can mend is said in lines, without a traceback.

    A terminal that takes no more, as ``| head -1`` leaves one, does not change the exit code; a file that is full does.
    """
    with lasting() as faults:
        code = ran()
        fault = faults().out
        if fault is not None and not isinstance(fault, BrokenPipeError):
            say(ERR, f"what was to be printed could not be written: {fault.strerror}", "red")
            code = UNREADABLE
    sys.exit(code)


def ran() -> int:
    """Return the exit code of the command, its faults told."""
    try:
        return int(app(standalone_mode=len(sys.argv) < 2) or AGREES)  # what typer prints by itself is not escaped
    except TyperException as error:
        say(ERR, f"{error.format_message()} See --help.", "red")
    except MotionbookError as error:
        for line in str(error).splitlines():
            say(ERR, line, "red")
    except Exception as error:  # to whoever runs it, a fault of ours is no verdict either
        if sys.flags.dev_mode:
            raise
        say(ERR, fault_of(error), "red")
    return UNREADABLE


def fault_of(error: Exception) -> str:
    """Return a line about what nobody has foreseen, or about a folder that was removed while one is in it."""
    if isinstance(error, FileNotFoundError) and not here_is_a_folder():
        return "the folder in which this runs is no longer there; go to another one"
    said = "out of memory" if isinstance(error, MemoryError) else f"{type(error).__name__}: {error}"
    return f"motionbook failed inside ({said[:200]}); please report this"


def here_is_a_folder() -> bool:
    """Whether the folder in which this runs is there."""
    try:
        return Path.cwd().is_dir()
    except OSError:
        return False
