"""The contact sheet: each printed page of each committed workbook, small, side by side, for a look at all of them.

.venv/bin/python -m docs.pictures --all
"""

from __future__ import annotations

import subprocess
import tempfile
from html import escape
from pathlib import Path

from workbook.build import COMMITTED, committed_descriptions, write_book
from workbook.reading.descriptions import read_machine
from workbook.witnesses.engines import convert

FOLDER = Path(__file__).parent / "contact"
"""not committed"""
RESOLUTION = 70  # dots per inch: to be read when it is opened alone
HEAD = """<!doctype html>
<meta charset="utf-8">
<title>Contact sheet</title>
<style>
body { font: 14px sans-serif; background: #ddd; }
figure { display: inline-block; margin: 4px; }
figcaption { font-size: 12px; }
img { width: 380px; background: #fff; }
</style>
"""


def contact() -> Path:
    """Make the pages' pictures and the sheet of them anew; return the sheet."""
    FOLDER.mkdir(exist_ok=True)
    for old in FOLDER.glob("*.png"):
        old.unlink()
    books = "".join(
        f"<h2>{escape(path.stem)}</h2>\n{''.join(map(figure, pages(path)))}" for path in committed_descriptions()
    )
    sheet = FOLDER / "index.html"
    sheet.write_text(f"{HEAD}{books}", encoding="utf-8", newline="\n")
    return sheet


def pages(description: Path) -> list[Path]:
    """Print the workbook of a description; return a picture of each page."""
    with tempfile.TemporaryDirectory() as folder:
        pdf = convert(book_of(description, Path(folder)), "pdf", Path(folder))
        made = FOLDER / description.stem
        subprocess.run(["pdftoppm", "-png", "-r", str(RESOLUTION), str(pdf), str(made)], check=True)
    return sorted(FOLDER.glob(f"{description.stem}-[0-9]*.png"))


def book_of(description: Path, folder: Path) -> Path:
    """Return the committed workbook of a description; of one that is not in git, a workbook built in the folder."""
    if description.stem in COMMITTED:
        return description.with_suffix(".xlsx")
    book = folder / f"{description.stem}.xlsx"
    write_book(read_machine(description), book)
    return book


def figure(page: Path) -> str:
    """Return a page as it stands in the sheet."""
    name = escape(page.name)
    return (
        f'<figure><a href="{name}"><img src="{name}" alt=""></a><figcaption>{escape(page.stem)}</figcaption></figure>\n'
    )
