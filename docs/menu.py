"""Make the picture of the menu Motion of Calc and its window; needs LibreOffice with python3-uno, and Xvfb.

.venv/bin/python -m docs.menu [PICTURE.png]
"""

from __future__ import annotations

import os
import shutil
import signal
import struct
import subprocess
import sys
import zlib
from pathlib import Path

from docs.pages import book_of
from tests.functions.calc import Calc
from workbook.functions import publish
from workbook.template import FOLDER
from workbook.witnesses.engines import libreoffice_path

HERE = Path(__file__).parent
PICTURE = HERE / "menu.png"
SCREEN, DISPLAY, PIPE = "1280x800x24", ":95", "motionbookmenu"
DRIVER = HERE.parent / "tests" / "functions" / "show_menu.py"
HEAD = struct.Struct(">25I")
"""of a file xwd: among its numbers its own size (0), width (4), height (5), bytes a line (12), colours (19)"""


def png_of(dump: bytes) -> bytes:
    """Return a picture of a screen, as Xvfb has it in its file, as PNG."""
    head = HEAD.unpack_from(dump)
    width, height, stride, begin = head[4], head[5], head[12], head[0] + 12 * head[19]
    lines = [dump[begin + k * stride : begin + k * stride + 4 * width] for k in range(height)]
    pixels = [bytes(v for p in zip(x[2::4], x[1::4], x[0::4], strict=True) for v in p) for x in lines]
    rows = b"".join(b"\0" + line for line in pixels)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    described = chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + described + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def main(picture: Path = PICTURE) -> None:
    """Show a document with a fault, verified, and the menu open; write what is on the screen."""
    if not shutil.which("Xvfb"):
        print(f"{picture.name} is left as it is: there is no Xvfb (Debian's package xvfb)")
        return
    calc, running = Calc(), []
    try:
        folder = calc.folder
        publish.write_add_in(folder / "made" / "motion.oxt")
        calc.install(folder / "made" / "motion.oxt")
        book = shutil.copy(book_of(FOLDER / "cutting-machine.toml", folder), folder / "machine.xlsx")
        running.append(subprocess.Popen(["Xvfb", DISPLAY, "-screen", "0", SCREEN, "-fbdir", folder]))
        # the first python3 on the path has to be LibreOffice's
        shown = os.environ | {"DISPLAY": DISPLAY, "SAL_USE_VCLPLUGIN": "gen", "PATH": os.defpath}
        profile = f"-env:UserInstallation={calc.profile.as_uri()}"
        line = [libreoffice_path(), "--norestore", "--nologo", f"--accept=pipe,name={PIPE};urp", profile]
        running.append(subprocess.Popen(line, env=shown, start_new_session=True))
        subprocess.run(["/usr/bin/python3", DRIVER, PIPE, book], check=True, timeout=900)
        picture.write_bytes(png_of((folder / "Xvfb_screen0").read_bytes()))
        print(f"Made {picture}")
    finally:
        for process in running[::-1]:
            (os.killpg if process is not running[0] else os.kill)(process.pid, signal.SIGKILL)
            process.wait()
        calc.close()


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:2]))
