"""The command line ``motionbook``, to which the modules beside add their commands."""

from __future__ import annotations

from typing import Annotated

import typer

from workbook import __version__
from workbook.exits import AGREES

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
