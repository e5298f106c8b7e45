"""The command line ``motionbook``, to which the modules beside add commands, and options that several of these have."""

from pathlib import Path
from typing import Annotated, Any, Literal

import typer
from typer import Argument, Option

from workbook import __version__
from workbook.controllers.registry import TARGETS
from workbook.errors import AGREES
from workbook.witnesses.registry import ALL, WITNESSES

app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


def tell_version(asked: bool) -> None:
    """Print the version, and leave."""
    if asked:
        print(f"motionbook {__version__}")
        raise typer.Exit(AGREES)


@app.callback()
def motionbook(
    version: Annotated[
        bool, Option("--version", callback=tell_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Workbooks of machine motion: motion laws, timing diagram, drive.

    Build one, change it in Excel or LibreOffice, and verify that every formula cell still computes the engine's value.
    """


def to(metavar: str, words: str, *names: str) -> Any:
    """Return the option that names a file to be written: the output unless told otherwise."""
    return Option(*(names or ("-o", "--output")), metavar=metavar, help=words)


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


Machine = Annotated[Path | None, Argument(
    metavar="[MACHINE.toml]", help="Machine description; the cutting machine when none is named."
)]  # fmt: skip
Book = Annotated[Path, Argument(metavar="BOOK", help="A workbook built by motionbook, edited or not.")]
Books = Annotated[list[Path], Argument(
    metavar="BOOK|FOLDER...", parser=named_place, help="Workbooks built by motionbook, or folders of them."
)]  # fmt: skip
Force = Annotated[bool, Option("--force", help="Replace the output file if it exists.")]
Json = Annotated[bool, Option("--json", help="Print JSON for machines instead of a table.")]
With = Annotated[
    list[str] | None,
    Option("--with", metavar="|".join((*WITNESSES, ALL)), parser=witness_named,
           help="Who evaluates the formulas, pycel unless told otherwise; may be given several times. All: all that "
                "are on this machine."),
]  # fmt: skip
Scheduler = Annotated[str | None, Option(
    metavar="tcp://HOST:PORT", help="The scheduler of a Dask cluster; else processes of this machine."
)]  # fmt: skip
Jobs = Annotated[int | None, Option(min=1, metavar="N", help="Processes at once; else one a core.")]
Of = Annotated[
    Literal["load", "shaft"],
    Option(metavar="load|shaft", help="The motion of the load, or the angle of the motor's shaft."),
]
Fresh = Annotated[bool, Option("--fresh", help="Verify the book again, also where these bytes were verified before.")]
Source = Annotated[str, Option("--from", metavar="TARGET", help=f"Whose file: {', '.join(TARGETS)}.")]
CamFile = Annotated[Path, Argument(metavar="FILE", help="A controller's cam table.")]
