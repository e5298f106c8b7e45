"""Commands on descriptions and books: from a new machine to its verdict."""

from pathlib import Path
from typing import Annotated

import typer
from typer import Argument, Option

from workbook.cli.options import Book, Books, Force, Jobs, Json, Machine, Scheduler, With, app, to


@app.command()
def new(
    template: Annotated[str, Argument(metavar="TEMPLATE", help="The kind of machine, such as machine.")],
    output: Annotated[Path | None, to("FILE.toml", "Where to write; else here, named like the template.")] = None,
    force: Force = False,
) -> None:
    """Write a description with every key explained, to be changed and built; its schema beside it."""
    from workbook.commands import make

    make.new(template, output, force)


@app.command("new-template")
def new_template(
    name: Annotated[str, Argument(metavar="NAME", help="What your kind of machine is called, such as hoist.")],
    output: Annotated[Path | None, to("FOLDER", "The folder to make; else motionbook-NAME, here.")] = None,
) -> None:
    """Write a package with a template of your own, to be changed: it installs, builds, verifies and tests itself."""
    from workbook.commands import make

    make.new_template(name, output)


@app.command()
def schema(
    template: Annotated[
        str | None, Argument(metavar="[TEMPLATE]", help="The kind of machine; any when none is named.")
    ] = None,
    output: Annotated[Path | None, to("FILE.json", "Where to write; else to the terminal.")] = None,
    force: Force = False,
) -> None:
    """Write the JSON Schema of descriptions, from which an editor completes their keys."""
    from workbook.commands import make

    make.schema(template, output, force)


@app.command()
def build(
    machine: Machine = None,
    output: Annotated[Path | None, to("BOOK.xlsx", "Where to write; else here, named like the description.")] = None,
    motors: Annotated[
        Path | None,
        Option(metavar="MOTORS.csv", help="Motors to choose among; else those in or beside the description."),
    ] = None,
    reducers: Annotated[Path | None, Option(metavar="REDUCERS.csv", help="Reducers to choose among, likewise.")] = None,
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
    report: Annotated[Path | None, to("FILE.html", "Write a report as one page of HTML.", "--report")] = None,
    junit: Annotated[Path | None, to("FILE.xml", "Write JUnit XML for CI servers.", "--junit")] = None,
    sarif: Annotated[Path | None, to("FILE.sarif", "Write SARIF 2.1.0 for code hosts.", "--sarif")] = None,
    force: Annotated[bool, Option("--force", help="Replace the report files if they exist.")] = False,
    witnesses: With = None,
    jobs: Jobs = None,
    scheduler: Scheduler = None,
    everything: Annotated[
        bool, Option("--all", help="List every finding, also what only follows from others.")
    ] = False,
    against: Annotated[
        Path | None, Option(metavar="FILE.py", help="Compare any workbook with what this file declares of it.")
    ] = None,
    cases: Annotated[int, Option(min=1, max=100_000, metavar="N", help="With --against: values tried.")] = 100,
    cover: Annotated[
        float | None, Option(min=0, max=100, metavar="PER CENT", help="With --against: fail if less is covered.")
    ] = None,
    marked: Annotated[Path | None, to("OUT.xlsx", "With --against: colour a copy by class.", "--marked")] = None,
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
    book: Book, output: Annotated[Path, to("NEW.xlsx", "Where to write the new workbook.")], force: Force = False
) -> None:
    """Build a workbook anew from what was entered into an old one: its inputs, today's formulas."""
    from workbook.commands import make

    make.regenerate(book, output, force)


@app.command()
def diff(
    old: Annotated[Path, Argument(metavar="OLD", help="A workbook built by motionbook, or a description.")],
    new: Annotated[Path, Argument(metavar="NEW", help="Another one of the same template.")],
    as_json: Json = False,
    html: Annotated[Path | None, to("FILE.html", "Write a page with both timing diagrams.", "--html")] = None,
    force: Force = False,
) -> None:
    """Tell what differs between two workbooks or descriptions: entries, results, checks, formulas, cells of your own.

    Exit code 0: nothing differs. 1: something does. 2: one of them cannot be read.
    """
    from workbook.commands import oracle as command

    raise typer.Exit(command.diff(old, new, as_json, html, force))


@app.command()
def templates(
    check: Annotated[bool, Option("--check", help="Write nothing; fail if a template is stale.")] = False,
) -> None:
    """Generate the workbooks in templates/ from the machine descriptions beside them."""
    from workbook.commands import make

    raise typer.Exit(make.templates(check))
