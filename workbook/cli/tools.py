"""Commands for studies, the browser, other workbooks and the functions of spreadsheets."""

import asyncio
from pathlib import Path
from typing import Annotated

import typer
from typer import Argument, Option

from workbook.cli.options import Force, Jobs, Json, Scheduler, app, to
from workbook.reports.terminal import OUT, say, say_json


@app.command()
def study(
    path: Annotated[
        Path | None, Argument(metavar="STUDY.toml", help="What varies, what is constrained, what is best.")
    ] = None,
    output: Annotated[
        Path | None,
        to("RESULTS", "Where to write: .csv or .parquet; with --pick, the book. Else named like the study."),
    ] = None,
    scheduler: Scheduler = None,
    resume: Annotated[bool, Option("--resume", help="Go on with a study that was interrupted.")] = False,
    pick: Annotated[
        int | None, Option(min=1, metavar="N", help="Build and verify the book of the N-th best design.")
    ] = None,
    jobs: Jobs = None,
    results: Annotated[
        Path | None, Option("--results", metavar="BASE", help="List the results of a machine by name, and stop.")
    ] = None,
    unverified: Annotated[bool, Option("--unverified", help="Do not verify the book of the best.")] = False,
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
def serve(
    folder: Annotated[Path, Argument(metavar="[FOLDER]", help="The folder with your machines.")] = Path(),
    port: Annotated[int, Option(min=0, max=65535, help="The port; 0 takes a free one.")] = 0,
    browse: Annotated[bool, Option(help="Open the browser.")] = True,
) -> None:
    """Work in the browser: new machines, build, verify, compare. Nobody but this computer can reach it."""
    from workbook.serve import app as server

    try:
        asyncio.run(server.serve(folder, port, browse, lambda address: say(OUT, f"Open {address} (Ctrl+C ends)")))
    except KeyboardInterrupt:
        say(OUT, "Ended")


@app.command()
def oracle(
    book: Annotated[Path, Argument(metavar="BOOK", help="Any workbook.")],
    output: Annotated[Path | None, to("FILE.py", "Where to write; else it is printed.")] = None,
    force: Force = False,
) -> None:
    """Write a first file of declarations for any workbook, for `motionbook verify BOOK --against FILE.py`."""
    from workbook.commands import oracle as command

    command.write_draft(book, output, force)


@app.command()
def addin(
    output: Annotated[Path, to("MOTION.oxt", "Where to write the add-in.")] = Path("motion.oxt"), force: Force = False
) -> None:
    """Write the LibreOffice add-in, which brings the functions MOTION.* to Calc; open it to install it."""
    from workbook.functions import oxt

    oxt.write(output, overwrite=force)
    say(OUT, f"Wrote {output.absolute()}")


@app.command()
def laws(as_json: Json = False) -> None:
    """List the motion laws with their coefficients, for unit rise and time."""
    from workbook.reports import laws as reports

    if as_json:
        say_json(reports.catalogue())
    else:
        reports.show_catalogue(OUT)
