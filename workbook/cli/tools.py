"""Commands on controllers' cam tables; for studies, the browser, other workbooks and the functions of spreadsheets."""

from pathlib import Path
from typing import Annotated, Literal

import typer
from typer import Argument, Option

from workbook import commands
from workbook.cli.books import (
    PLACES,
    Book,
    CamFile,
    Force,
    Fresh,
    Jobs,
    Json,
    Of,
    Scheduler,
    Source,
    app,
    flag,
    named_place,
    option,
    to,
)
from workbook.controllers.registry import TARGETS
from workbook.reports.terminal import ERR, OUT, say, say_json

BEYOND = (
    "Largest error of y, v, a or j as a share of its peak; beyond it nothing is written. May be given several times."
)


@app.command()
def export(
    book: Book,
    to_target: str = option("TARGET", f"One of {', '.join(TARGETS)}.", "--to", default=...),
    axis: str | None = option("NAME", "The axis to export."),
    everything: bool = flag("--all", "Export every axis, and the switches; -o then names a folder."),
    switches: bool = flag("--switches", "Export the machine's switches."),
    output: Path | None = to("FILE", "Where to write; else here, named like book and axis."),
    points: str = option("N|auto", "How many points; auto takes the fewest within the tolerance.", default="auto"),
    equidistant: bool = flag("--equidistant", "Points at equal steps, also where the format would take others."),
    tolerance: list[str] | None = option("a=1%", BEYOND),
    of: Of = "load",
    unverified: bool = flag("--unverified", "Do not ask whether the book agrees; the file says so."),
    fresh: Fresh = False,
    separator: Literal["semicolon", "comma", "tab"] = option(
        "semicolon|comma|tab", "Between columns of text.", default="semicolon"
    ),
    decimal: Literal["point", "comma"] = option("point|comma", "The decimal sign of columns of text.", default="point"),
    report: Path | None = to("FILE.html", "Write the certificates as a page with pictures.", "--report"),
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
    asked = commands.export.parse_options(
        to_target, points, tolerance or (), separator, decimal, unverified, equidistant, of
    )
    raise typer.Exit(
        commands.export.export(book, axis, asked, output, everything, force, as_json, report, switches, fresh)
    )


@app.command()
def read(
    file: CamFile,
    source: Source,
    output: Path | None = to("MACHINE.toml", "Where to write; else to the terminal."),
    tolerance: str | None = option("y=0.01%", "Largest error of a spline through few points, as a share of the reach."),
    switches: bool = flag("--switches", "Tell a file's switches as entries."),
    force: Force = False,
) -> None:
    """Read a controller's cam table as the description of a machine of one axis.

    Dwells and turns part it; each movement is the first law of the registry that keeps to its points within their
    precision, also where phases meet at speed, else a cubic spline through as few of them as keep to the tolerance
    (0.01 % of the reach unless told otherwise). A turn of a shaft that begins on the way is written as an axis
    with a shift. Build, verify and export what is written: the way back is closed.
    """
    if switches:
        commands.cams.read_switches(file, source, output)
    else:
        commands.cams.read(file, source, output, force, tolerance)


@app.command()
def compare(
    book: Book,
    file: CamFile,
    source: Source,
    axis: str | None = option("NAME", "The axis of the book."),
    switches: bool = flag("--switches", "Compare the machine's switches."),
    tolerance: list[str] | None = option("a=1%", "Largest error of y, v, a or j as a share of its peak."),
    of: Of = "load",
    unverified: bool = flag("--unverified", "Do not ask whether the book agrees."),
    fresh: Fresh = False,
    as_json: Json = False,
) -> None:
    """Compare what a controller makes of a cam table with an axis of a book, or its switches with the book's.

    Exit code 0: within the tolerance over the whole cycle. 1: beyond it, or the book disagrees. 2: it cannot be read.
    """
    raise typer.Exit(
        commands.cams.compare(book, file, axis, source, tolerance or (), unverified, as_json, switches, of, fresh)
    )


@app.command()
def study(
    path: Path | None = Argument(None, metavar="STUDY.toml", help="What varies, what is constrained, what is best."),
    output: Path | None = to(
        "RESULTS", "Where to write: .csv or .parquet; with --pick, the book. Else named like the study."
    ),
    scheduler: Scheduler = None,
    resume: bool = flag("--resume", "Go on with a study that was interrupted."),
    pick: int | None = option("N", "Build and verify the book of the N-th best design.", min=1),
    jobs: Jobs = None,
    results: Path | None = option("BASE", "List the results of a machine by name, and stop.", "--results"),
    unverified: bool = flag("--unverified", "Do not verify the book of the best."),
    force: Force = False,
) -> None:
    """Work out many designs of a machine: laws, angles, motors, reducers, any entry; find the best.

    Writes the designs with their results, a page with the front, and what --pick needs. Feasible is a design whose book
    has no FAIL, and whose results keep to the constraints. The best one is built and verified.

    Exit code 0: there are feasible designs. 1: a design's book disagrees. 2: it cannot be done. 3: none is feasible.
    """
    if results is not None:
        raise typer.Exit(commands.study.listing(results))
    if path is None:
        raise typer.BadParameter("expected STUDY.toml, or --results BASE")
    raise typer.Exit(commands.study.study(path, output, scheduler, jobs, resume, pick, unverified, force))


@app.command()
def improve(
    machine: Path = Argument(..., metavar="MACHINE.toml", help="A machine of axes."),
    output: Path | None = to("BETTER.toml", "Write the best description, at the rate that it reaches."),
    change: Literal["laws", "timing", "both", "motors"] = option(
        "laws|timing|both|motors", "What -o changes: laws; edges; both; motors and ratios too.", default="laws"
    ),
    aim: Literal["rate", "torque", "power", "energy", "acceleration", "vibration"] = option(
        "AIM", "What is better: rate|torque|power|energy|acceleration|vibration.", "--for", default="rate"
    ),
    axis: str = option("NAME", "The axis that has less of it; else the one that has most.", "--axis", default=""),
    frequency: float = option("HZ", "Natural frequency of --for vibration, if not as described.", min=0.0, default=0.0),
    damping: float = option("ZETA", "Its damping ratio.", min=0.0, max=0.99, default=0.0),
    freeze: bool = flag("--freeze", "Only shape the laws anew that the description has shaped for their drives."),
    sheet: Path | None = option("BOOK.xlsx", "Build its book, with these lines on a sheet Improve.", "--sheet"),
    jobs: int | None = option("N", "Processes at once; else this process alone.", "--jobs", min=1),
    scheduler: Scheduler = None,
    force: Force = False,
) -> None:
    """Say what limits the highest rate of a machine, and what each single change would gain.

    Tried are other laws for each phase, laws shaped for their drive, edges moved within their order or what the
    description's timing says, the next motors, other ratios, less inertia and smaller reserves of the axis that limits.
    With --sheet the book has the lines too; --force replaces a book, whose own work comes along.

    Then the best laws, the best timing, both together, and motors and ratios too. Every gain is worked out by the exact
    engine; a change that breaks a check is left out. With --for an axis has less of something at the same rate. Ctrl+C
    leaves the best so far.

    Exit code 0: done. 2: it cannot be done. 3: a check of what was written fails; with --freeze and nothing written, a
    law would gain.
    """
    if freeze and sheet is not None:
        raise typer.BadParameter("--freeze prints no gains for a sheet; expected --sheet without it")
    if freeze:
        raise typer.Exit(commands.improve.freeze(machine, output, force))
    if aim != "vibration" and frequency > 0.0:
        raise typer.BadParameter("expected --frequency with --for vibration alone")
    asked = aim, frequency, damping
    raise typer.Exit(commands.improve.improve(machine, output, change, asked, axis, (jobs, scheduler), force, sheet))


@app.command()
def serve(
    folder: Path = Argument(Path(), metavar="[FOLDER]", help="The folder with your machines."),
    port: int = Option(0, min=0, max=65535, help="The port; 0 takes a free one."),
    browse: bool = Option(True, help="Open the browser."),
) -> None:
    """Work in the browser: new machines, build, verify, compare. Nobody but this computer can reach it."""
    import asyncio

    from workbook.serve import app as server

    try:
        asyncio.run(server.serve(folder, port, browse))
    except KeyboardInterrupt:
        say(OUT, "Ended")


@app.command()
def watch(
    books: Annotated[list[Path], Argument(metavar="BOOK|FOLDER...", parser=named_place, help=PLACES)],
    once: bool = flag("--once", "End with the verdict on the first save, by the exit code of verify; no page."),
    as_json: bool = flag("--json", "Print a line of JSON for each verdict; no page."),
    until_eof: bool = flag("--until-eof", "End with the standard input, as that of a program that began this."),
    port: int = Option(0, min=0, max=65535, help="The port of the page; 0 takes a free one."),
    browse: bool = Option(True, help="Open the browser."),
) -> None:
    """Verify workbooks each time they are saved, beside Excel or LibreOffice, until Ctrl+C.

    The verdict on the values comes first; what is shown, and formulas at other entries, are compared after it. It is
    told here and on a page that updates itself, with the entries and results that the save changed.
    """
    import asyncio

    from workbook.watch.watch import watch as watching

    try:
        raise typer.Exit(asyncio.run(watching(books, once, as_json, until_eof, port, browse)))
    except KeyboardInterrupt:
        say(ERR, "Ended")


@app.command()
def oracle(
    book: Path = Argument(..., metavar="BOOK", help="Any workbook."),
    output: Path | None = to("FILE.py|COPY.xlsx", "Where to write, or a copy with a sheet of them; else printed."),
    force: Force = False,
    proposed: bool = flag("--proposed", "Translate formulas to Python, each marked as a proposal."),
) -> None:
    """Write a first file of declarations for any workbook, for `motionbook verify BOOK --against FILE.py`."""
    commands.oracle.write_draft(book, output, force, proposed)


@app.command()
def audit(
    books: Annotated[list[Path], Argument(metavar="BOOK|FOLDER...", parser=named_place, help="Any workbooks.")],
    as_json: Json = False,
    sarif: Path | None = to("FILE.sarif", "Write SARIF 2.1.0 for code hosts.", "--sarif"),
    force: bool = flag("--force", "Replace the SARIF file if it exists."),
    everything: bool = flag("--all", "List also what is less sure."),
) -> None:
    """Name faults of any workbook, without a declaration: each with its cell, why, how sure, and what stands beside it.

    Nothing is evaluated, and no workbook is written to. Exit code 0: nothing found. 1: findings. 2: a book cannot
    be read.
    """
    raise typer.Exit(commands.audit.audit(books, as_json, sarif, force, everything))


@app.command()
def addin(
    output: Path = to("MOTION.oxt", "Where to write the add-in.", default=Path("motion.oxt")), force: Force = False
) -> None:
    """Write the LibreOffice add-in, which brings the functions MOTION.* to Calc; open it to install it."""
    from workbook.functions import publish

    publish.write_add_in(output, overwrite=force)
    say(OUT, f"Wrote {output.absolute()}")


@app.command()
def laws(as_json: Json = False) -> None:
    """List the motion laws with their coefficients, for unit rise and time."""
    from workbook.reports import console as reports

    if as_json:
        say_json(reports.catalogue())
    else:
        reports.show_catalogue(OUT)
