"""LibreOffice as an engineer's hands: opens a book, runs a few lines of Basic on it, saves it."""

import subprocess
import tempfile
from functools import cache
from pathlib import Path
from xml.sax.saxutils import escape

from workbook.witnesses.engines import libreoffice_path

TIMEOUT = 180  # seconds
MODULE = """<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE script:module PUBLIC "-//OpenOffice.org//DTD OfficeDocument 1.0//EN" "module.dtd">
<script:module xmlns:script="http://openoffice.org/2000/script" script:name="Module1"
 script:language="StarBasic">{text}</script:module>
"""
MACRO = """
Sub Main(source, target)
  Dim opening(0) As New com.sun.star.beans.PropertyValue
  opening(0).Name = "Hidden" : opening(0).Value = True
  Dim saving(0) As New com.sun.star.beans.PropertyValue
  saving(0).Name = "FilterName" : saving(0).Value = "Calc MS Excel 2007 XML"
  book = StarDesktop.loadComponentFromURL(ConvertToURL(source), "_blank", 0, opening())
  For Each sheet In book.Sheets
    sheet.unprotect("")
  Next
  {edits}
  book.storeToURL(ConvertToURL(target), saving())
  book.close(True)
  StarDesktop.terminate()
End Sub
"""


LOCALE = """<item oor:path="/org.openoffice.Setup/L10N"><prop oor:name="ooSetupSystemLocale" oor:op="fuse">
<value>{locale}</value></prop></item></oor:items>"""


def edit(source, target, edits, locale="en-US"):
    """Carry out ``edits``, lines of Basic about ``book``, on an unprotected copy of ``source``, in a locale."""
    user = Path(profile(locale).name)
    module = user / "user" / "basic" / "Standard" / "Module1.xba"
    text = MACRO.format(edits="\n  ".join(edits))
    module.write_text(MODULE.format(text=escape(text)), encoding="utf-8")
    macro = f'macro:///Standard.Module1.Main("{source}","{target}")'
    done = subprocess.run([*started(user), macro], capture_output=True, text=True, timeout=TIMEOUT)
    assert target.exists(), done.stderr
    return target


@cache
def profile(locale):
    """A profile of LibreOffice for this process, which takes as long to make as to open a book."""
    made = tempfile.TemporaryDirectory()
    subprocess.run([*started(made.name), "--terminate_after_init"], capture_output=True, timeout=TIMEOUT)
    settings = Path(made.name) / "user" / "registrymodifications.xcu"
    written = settings.read_text(encoding="utf-8").replace("</oor:items>", LOCALE.format(locale=locale))
    settings.write_text(written, encoding="utf-8")
    return made


def started(folder):
    return [libreoffice_path(), "--headless", "--norestore", f"-env:UserInstallation={Path(folder).as_uri()}"]
