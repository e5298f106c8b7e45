"""Commands on controllers' cam tables."""

from pathlib import Path
from typing import Annotated

import typer
from typer import Option

from workbook.cli.options import Book, CamFile, Force, Fresh, Json, Of, Source, app, to
from workbook.controllers.registry import TARGETS

Tolerance = Annotated[
    list[str] | None,
    Option(
        metavar="a=1%",
        help="Largest error of y, v, a or j as a share of its peak; beyond it nothing is "
        "written. May be given several times.",
    ),
]


@app.command()
def export(
    book: Book,
    to_target: Annotated[str, Option("--to", metavar="TARGET", help=f"One of {', '.join(TARGETS)}.")],
    axis: Annotated[str | None, Option(metavar="NAME", help="The axis to export.")] = None,
    everything: Annotated[
        bool, Option("--all", help="Export every axis, and the switches; -o then names a folder.")
    ] = False,
    switches: Annotated[bool, Option("--switches", help="Export the machine's switches.")] = False,
    output: Annotated[Path | None, to("FILE", "Where to write; else here, named like book and axis.")] = None,
    points: Annotated[
        str, Option(metavar="N|auto", help="How many points; auto takes the fewest within the tolerance.")
    ] = "auto",
    equidistant: Annotated[
        bool, Option("--equidistant", help="Points at equal steps, also where the format would take others.")
    ] = False,
    tolerance: Tolerance = None,
    of: Of = "load",
    unverified: Annotated[
        bool, Option("--unverified", help="Do not ask whether the book agrees; the file says so.")
    ] = False,
    fresh: Fresh = False,
    separator: Annotated[str, Option(metavar="semicolon|comma|tab", help="Between columns of text.")] = ("semicolon"),
    decimal: Annotated[str, Option(metavar="point|comma", help="The decimal sign of columns of text.")] = "point",
    report: Annotated[
        Path | None, to("FILE.html", "Write the certificates as a page with pictures.", "--report")
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


@app.command()
def read(
    file: CamFile,
    source: Source,
    output: Annotated[Path | None, to("MACHINE.toml", "Where to write; else to the terminal.")] = None,
    tolerance: Annotated[
        str | None,
        Option(metavar="y=0.01%", help="Largest error of a spline through few points, as a share of the reach."),
    ] = None,
    switches: Annotated[bool, Option("--switches", help="Tell a file's switches as entries.")] = False,
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
    axis: Annotated[str | None, Option(metavar="NAME", help="The axis of the book.")] = None,
    switches: Annotated[bool, Option("--switches", help="Compare the machine's switches.")] = False,
    tolerance: Annotated[
        list[str] | None, Option(metavar="a=1%", help="Largest error of y, v, a or j as a share of its peak.")
    ] = None,
    of: Of = "load",
    unverified: Annotated[bool, Option("--unverified", help="Do not ask whether the book agrees.")] = False,
    fresh: Fresh = False,
    as_json: Json = False,
) -> None:
    """Compare what a controller makes of a cam table with an axis of a book, or its switches with the book's.

    Exit code 0: within the tolerance over the whole cycle. 1: beyond it, or the book disagrees. 2: it cannot be read.
    """
    from workbook.commands import cams

    raise typer.Exit(cams.compare(book, file, axis, source, tolerance or (), unverified, as_json, switches, of, fresh))
