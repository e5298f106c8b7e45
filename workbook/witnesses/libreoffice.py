"""LibreOffice, run headless: a real spreadsheet program agrees, or it does not."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path

from workbook.errors import WitnessError
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.witness import Witness, cached_values, without

TIMEOUT = 300  # seconds
PLACES = (
    "/usr/bin/soffice",
    "/Applications/LibreOffice.app/Contents/MacOS/soffice",
    r"C:\Program Files\LibreOffice\program\soffice.com",
)
# LibreOffice keeps the values that it finds in a file unless it is told to recalculate always, and follows links to
# other files and to the web unless it is told never to; settings that a version does not know do no harm
SETTINGS = (
    ("Calc/Formula/Load", "OOXMLRecalcMode", "0"), ("Calc/Formula/Load", "ODFRecalcMode", "0"),
    ("Calc/Content/Update", "Link", "2"), ("Common/Security/Scripting", "BlockUntrustedRefererLinks", "true"),
    ("Common/Security/Scripting", "DisableActiveContent", "true"),
)  # fmt: skip
ITEM = '<item oor:path="/org.openoffice.Office.{}"><prop oor:name="{}" oor:op="fuse"><value>{}</value></prop></item>'
PROFILE = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry" xmlns:xs="http://www.w3.org/2001/XMLSchema"
 xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">{}</oor:items>
""".format("".join(ITEM.format(*one) for one in SETTINGS))


def program() -> str | None:
    """Return the path of LibreOffice, or None where it is not on this machine."""
    return shutil.which("soffice") or next((place for place in PLACES if Path(place).exists()), None)


def convert(source: Path, kind: str, folder: Path) -> Path:
    """Convert a file with a private profile that recalculates everything; return the new file in ``folder``."""
    soffice = program()
    if soffice is None:
        raise WitnessError("LibreOffice is not on this machine")
    with tempfile.TemporaryDirectory() as profile:
        user = Path(profile) / "user"
        user.mkdir()
        (user / "registrymodifications.xcu").write_text(PROFILE, encoding="utf-8")
        command = [soffice, "--headless", "--norestore", f"-env:UserInstallation={Path(profile).as_uri()}",
                   "--convert-to", kind, "--outdir", str(folder), str(source)]  # fmt: skip
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise WitnessError(f"LibreOffice did not finish: {error}") from error
    made = folder / f"{source.stem}.{kind.split(':')[0]}"
    if not made.exists():
        raise WitnessError(f"LibreOffice could not open the file: {(run.stderr or run.stdout).strip()[:200]}")
    return made


@cache
def version_of(soffice: str) -> str:
    """Return the version of a LibreOffice."""
    environment = os.environ | {"HOME": tempfile.gettempdir()} if sys.platform != "win32" else None
    try:
        said = subprocess.run([soffice, "--version"], capture_output=True, text=True, check=False, env=environment,
                              timeout=TIMEOUT)  # fmt: skip
    except (OSError, subprocess.TimeoutExpired):  # converting says what is wrong
        return "unknown version"
    found = re.search(r"\d+(\.\d+)+", said.stdout)
    return found.group() if found else "unknown version"


class LibreOffice(Witness):
    """Recalculates a bare copy of the file, which has nothing to fetch, and reads the results back."""

    name = "libreoffice"

    def version(self) -> str | None:
        """Return LibreOffice's own version, or None where it is absent."""
        soffice = program()
        return None if soffice is None else version_of(soffice)

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        with without(file, bare=True) as copy, tempfile.TemporaryDirectory() as folder:
            return cached_values(convert(copy.path, "xlsx", Path(folder)).read_bytes(), file)
