"""Make the pictures of README and docs: workbooks by LibreOffice and pdftoppm, pages by Chromium, Calc's menu by Xvfb.

.venv/bin/python -m docs.pictures
.venv/bin/python -m docs.pictures --all    (a contact sheet of every page of every workbook, not committed)
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from docs import browsing, menu
from docs.contact import book_of, contact
from tests.functions.calc import Calc
from workbook.functions import publish
from workbook.template import FOLDER
from workbook.witnesses.engines import convert

HERE = Path(__file__).parent
RESOLUTION = 100  # dots per inch
FUNCTIONS = "motion-functions"  # computed by the add-in
PICTURES = (  # file, workbook, page of the printed book, left, top, width, height in dots
    ("summary.png", "machine", 1, 30, 30, 1112, 712),
    ("timing.png", "cutting-machine", 2, 30, 30, 1112, 696),
    ("drive.png", "cutting-machine", 5, 30, 30, 1112, 712),
    ("selection.png", "flying-cutter", 6, 30, 30, 1112, 685),
    ("motion.png", "motion-composer", 2, 30, 30, 1112, 653),
    ("overlap.png", "indexing-overlap", 2, 30, 30, 1112, 685),
    ("actuator.png", "actuator-sizing", 4, 30, 30, 1112, 712),
    ("cutter.png", "flying-cutter", 2, 30, 30, 1112, 712),
    ("laws.png", "motion-laws", 2, 30, 30, 1112, 712),
    ("functions.png", FUNCTIONS, 1, 40, 30, 974, 712),
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


def main(wanted: list[str]) -> None:
    """Make each picture, or those that are named."""
    with tempfile.TemporaryDirectory() as folder:
        for name, book, page, left, top, width, height in PICTURES:
            if wanted and name not in wanted:
                continue
            pdf = printed(book, Path(folder))
            cut = ["-x", left, "-y", top, "-W", width, "-H", height]
            command = ["pdftoppm", "-png", "-singlefile", "-r", RESOLUTION, "-f", page, "-l", page, *cut]
            subprocess.run([*map(str, command), str(pdf), str(HERE / Path(name).stem)], check=True)
            print(f"Made {HERE / name}")
    browsing.main(wanted)
    if not wanted or menu.PICTURE.name in wanted:
        menu.main()


if __name__ == "__main__":
    if sys.argv[1:] == ["--all"]:
        print(f"Made {contact()}")
    else:
        main(sys.argv[1:])
