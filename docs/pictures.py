"""Make the pictures of README and docs: workbooks by LibreOffice and pdftoppm, pages by Chromium, Calc's menu by Xvfb.

.venv/bin/python -m docs.pictures
.venv/bin/python -m docs.pictures --all    (the pages of every workbook into docs/contact, not committed)
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from docs import browsing, menu
from docs.pages import SHOWN, book_of, draw_pages
from tests.functions.calc import Calc
from workbook.build import committed_descriptions
from workbook.functions import publish
from workbook.template import FOLDER
from workbook.witnesses.engines import convert

HERE = Path(__file__).parent
RESOLUTION = 100  # dots per inch
FUNCTIONS = "motion-functions"  # computed by the add-in
PICTURES = (  # file, workbook, title of the first of the pages that have it, left, top, width, height in dots
    ("summary.png", "machine", "Wrapping machine", 30, 30, 1112, 712),
    ("timing.png", "cutting-machine", "Timing", 30, 30, 1112, 696),
    ("drive.png", "cutting-machine", "Drive MC01", 30, 30, 1112, 712),
    ("selection.png", "flying-cutter", "Selection", 30, 30, 1112, 685),
    ("motion.png", "motion-composer", "Timing", 30, 30, 1112, 653),
    ("overlap.png", "indexing-overlap", "Overlap", 30, 30, 1112, 685),
    ("actuator.png", "actuator-sizing", "Drive Slide", 30, 30, 1112, 712),
    ("cutter.png", "flying-cutter", "Cutter", 30, 30, 1112, 712),
    ("laws.png", "motion-laws", "Comparison", 30, 30, 1112, 712),
    ("functions.png", FUNCTIONS, "", 40, 30, 974, 712),
)


def printed(name: str, folder: Path) -> Path:
    """Print a book to PDF."""
    if name != FUNCTIONS:
        return convert(book_of(FOLDER / f"{name}.toml", folder), "pdf", folder)
    book = FOLDER / f"{name}.xlsx"
    calc = Calc()
    try:
        publish.write_add_in(folder / "motion.oxt")
        calc.install(folder / "motion.oxt")
        return Path(shutil.copy(calc.computed(book, "pdf"), folder))
    finally:
        calc.close()


def page_titled(pdf: Path, title: str) -> int:
    """Return the number of the first page that begins with a title, from 1."""
    text = subprocess.run(["pdftotext", "-layout", str(pdf), "-"], check=True, capture_output=True, text=True).stdout
    return next(k for k, page in enumerate(text.split("\f"), 1) if page.lstrip().startswith(title))


def main(wanted: list[str]) -> None:
    """Make each picture, or those that are named."""
    with tempfile.TemporaryDirectory() as folder:
        for name, book, title, left, top, width, height in PICTURES:
            if wanted and name not in wanted:
                continue
            pdf = printed(book, Path(folder))
            page = page_titled(pdf, title)
            cut = ["-x", left, "-y", top, "-W", width, "-H", height]
            command = ["pdftoppm", "-png", "-singlefile", "-r", RESOLUTION, "-f", page, "-l", page, *cut]
            subprocess.run([*map(str, command), str(pdf), str(HERE / Path(name).stem)], check=True)
            print(f"Made {HERE / name}")
    for name in SHOWN:
        if not wanted or f"pages-{name}.png" in wanted:
            draw_pages(name, HERE / f"pages-{name}.png")
    browsing.main(wanted)
    if not wanted or menu.PICTURE.name in wanted:
        menu.main()


if __name__ == "__main__":
    if sys.argv[1:] == ["--all"]:
        (HERE / "contact").mkdir(exist_ok=True)
        for path in committed_descriptions():
            draw_pages(path.stem, HERE / "contact" / f"{path.stem}.png")
    else:
        main(sys.argv[1:])
