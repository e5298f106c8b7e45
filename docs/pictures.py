"""Make the pictures of the README from the committed workbooks; needs LibreOffice and pdftoppm.

.venv/bin/python docs/pictures.py
"""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

from workbook.templates import TEMPLATES
from workbook.witnesses.libreoffice_witness import convert

HERE = Path(__file__).parent
RESOLUTION = 100  # dots per inch
PICTURES = (  # file, template, page of the printed book, left, top, width, height in dots
    ("timing.png", "cutting-machine", 2, 75, 85, 1000, 650),
    ("drive.png", "cutting-machine", 12, 75, 85, 1010, 665),
    ("motion.png", "motion-composer", 2, 75, 85, 1010, 610),
    ("overlap.png", "indexing-overlap", 2, 75, 85, 1010, 640),
)


def main() -> None:
    """Print each book to PDF, and cut each picture out of its page."""
    with tempfile.TemporaryDirectory() as folder:
        for name, template, page, left, top, width, height in PICTURES:
            pdf = convert(TEMPLATES[template].book, "pdf", Path(folder))
            cut = ["-x", left, "-y", top, "-W", width, "-H", height]
            command = ["pdftoppm", "-png", "-singlefile", "-r", RESOLUTION, "-f", page, "-l", page, *cut]
            subprocess.run([*map(str, command), str(pdf), str(HERE / Path(name).stem)], check=True)
            print(f"Made {HERE / name}")


if __name__ == "__main__":
    main()
