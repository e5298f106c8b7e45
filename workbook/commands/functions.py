"""The functions for those who have no book: the add-in, and the laws that they know."""

from __future__ import annotations

import json
from pathlib import Path

from workbook.functions import oxt
from workbook.reports import laws as reports
from workbook.reports.terminal import OUT, say, say_data


def addin(output: Path, force: bool) -> None:
    """Write the LibreOffice add-in."""
    oxt.write(output, overwrite=force)
    say(OUT, f"Wrote {output.absolute()}")


def laws(as_json: bool) -> None:
    """Print the motion laws with their coefficients."""
    if as_json:
        say_data(f"{json.dumps(reports.catalogue(), ensure_ascii=False, indent=1)}\n")
    else:
        reports.show_catalogue(OUT)
