"""Pictures of all printed pages of a workbook, side by side: for docs/workbooks.md, and for a look at all workbooks.

.venv/bin/python -m docs.pictures --all
"""

from __future__ import annotations

import base64
import shutil
import subprocess
import tempfile
from pathlib import Path

from playwright.sync_api import sync_playwright

from workbook.build import COMMITTED, write_book
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.witnesses.engines import convert

HERE = Path(__file__).parent
SHOWN = ("cutting-machine", "machine", "flying-cutter", "indexing-overlap", "motion-laws")
RESOLUTION = 70  # dots per inch
HEAD = """<style>
body { width: 1640px; margin: 8px; background: #d1d5db; }
img { width: 538px; margin: 3px; }
</style>
"""


def book_of(description: Path, folder: Path) -> Path:
    """Return the committed workbook of a description; of one that is not in git, a workbook built in the folder."""
    if description.stem in COMMITTED:
        return description.with_suffix(".xlsx")
    book = folder / f"{description.stem}.xlsx"
    write_book(read_machine(description), book)
    return book


def draw_pages(name: str, picture: Path) -> None:
    """Write a PNG of the printed pages of a template's workbook."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        pdf = convert(book_of(FOLDER / f"{name}.toml", Path(folder)), "pdf", Path(folder))
        subprocess.run(["pdftoppm", "-png", "-r", str(RESOLUTION), str(pdf), f"{folder}/page"], check=True)
        pages = [base64.b64encode(page.read_bytes()).decode() for page in sorted(Path(folder).glob("page-*.png"))]
        browser = driver.chromium.launch(executable_path=shutil.which("chromium") or shutil.which("google-chrome"))
        sheet = browser.new_page(viewport={"width": 1656, "height": 100})
        sheet.set_content(HEAD + "".join(f'<img src="data:image/png;base64,{page}">' for page in pages))
        sheet.screenshot(path=picture, full_page=True)
        browser.close()
