"""LibreOffice Calc with a profile of its own, into which extensions can be installed."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.sax.saxutils import escape

from tests.workbook.office import MODULE, TIMEOUT
from workbook.witnesses.engines import PROFILE, libreoffice_path

FILTERS = {"xlsx": "Calc MS Excel 2007 XML", "ods": "calc8"}
MACRO = """
Function argument(name, value)
  Dim made As New com.sun.star.beans.PropertyValue
  made.Name = name : made.Value = value
  argument = made
End Function

Sub Main(target)
  On Error GoTo said
  book = StarDesktop.loadComponentFromURL("private:factory/scalc", "_blank", 0, Array(argument("Hidden", True)))
  sheet = book.Sheets.getByIndex(0)
  {lines}
  said:
  If Err <> 0 Then sheet.getCellByPosition(0, 0).String = "Line " & Erl & ": " & Error$
  book.storeToURL(ConvertToURL(target), Array(argument("FilterName", "{filter}")))
  book.close(True)
  StarDesktop.terminate()
End Sub
"""


class Calc:
    """A private LibreOffice; run by root, it is another user's, as unopkg refuses root."""

    def __init__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="calc-"))
        self.profile = self.folder / "profile"
        standard = self.profile / "user" / "basic" / "Standard"
        standard.mkdir(parents=True)
        (self.profile / "user" / "registrymodifications.xcu").write_text(PROFILE, encoding="utf-8")
        (self.folder / "made").mkdir()
        self._office("--terminate_after_init")  # makes the rest of the profile

    def close(self):
        shutil.rmtree(self.folder)

    def install(self, oxt):
        self._packages("add", shutil.copy(oxt, self.folder))

    def remove(self, identifier):
        self._packages("remove", identifier)

    def computed(self, book, kind="xlsx"):
        """Let Calc compute a copy of a book and save it; return that."""
        target = self.folder / "made" / f"{book.stem}.{kind}"
        target.unlink(missing_ok=True)
        self._office("--convert-to", kind, "--outdir", target.parent, shutil.copy(book, self.folder))
        assert target.exists()
        return target

    def written(self, lines, name="basic.xlsx"):
        """Run lines of Basic about a new ``sheet``; return the book that it is then saved as."""
        target = self.folder / "made" / name
        target.unlink(missing_ok=True)
        text = MACRO.format(lines="\n  ".join(lines), filter=FILTERS[target.suffix[1:]])
        module = self.profile / "user" / "basic" / "Standard" / "Module1.xba"
        module.write_text(MODULE.format(text=escape(text)), encoding="utf-8")
        self._office(f'macro:///Standard.Module1.Main("{target}")')
        assert target.exists()
        return target

    def _office(self, *arguments):
        self._run(libreoffice_path(), "--headless", "--norestore", *arguments)

    def _packages(self, *arguments):
        self._run(Path(libreoffice_path()).resolve().with_name("unopkg"), *arguments)

    def _run(self, command, *arguments):
        user = {}
        if sys.platform != "win32" and os.geteuid() == 0:
            import pwd  # not above: Windows has none

            nobody = pwd.getpwnam("nobody")
            user = {"user": nobody.pw_uid, "group": nobody.pw_gid, "extra_groups": []}
            for path in (self.folder, *self.folder.rglob("*")):
                os.chown(path, nobody.pw_uid, nobody.pw_gid)
        line = [command, *arguments, f"-env:UserInstallation={self.profile.as_uri()}"]
        environment = os.environ | {"HOME": str(self.folder)}
        if sys.platform != "win32":  # of the first python3 on the path LibreOffice's Python takes the library
            environment["PATH"] = os.defpath
        with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=self.folder,
                              env=environment, start_new_session=True, **user) as running:  # fmt: skip
            try:
                said, _ = running.communicate(timeout=TIMEOUT)
            except subprocess.TimeoutExpired:
                os.killpg(running.pid, signal.SIGKILL)  # the program that was started has started the real one
                raise
        assert running.returncode == 0, said
