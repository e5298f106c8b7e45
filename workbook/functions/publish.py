"""The files by which spreadsheets get the functions: a workbook with the names, their text, the add-in ``motion.oxt``.

LibreOffice's SDK made ``motion.rdb``: unoidl-write program/types.rdb program/types/offapi.rdb motion.idl motion.rdb
"""

import re
import sys
import tempfile
from filecmp import cmp
from importlib import resources
from operator import attrgetter
from pathlib import Path

from openpyxl.workbook.defined_name import DefinedName
from tornado.template import Template

from workbook import __version__
from workbook.errors import WriteError
from workbook.functions.declarations import FUNCTIONS, NAMESPACE, TEXTS, Text
from workbook.functions.names import definitions
from workbook.functions.page import EXAMPLE, PageInputs, declare
from workbook.template import FOLDER
from workbook.writing import archive
from workbook.writing.archive import same_book
from workbook.writing.output_files import refuse_existing, replace
from workbook.writing.write import pack, parts

SHEET = "xl/worksheets/sheet1.xml"
WHETHER = re.compile(rb'(<c r="\w+" s="\d+") t="str"(><f>IF\(ISERROR\([^<]*</f>)<v>[^<]*</v>')
NOTE = 255  # characters of the comment that Excel shows beside a name
HEAD = """\
The motion functions as names of Excel 365, Excel 2024 and Excel for the web (English; comma between arguments).

Quicker, and right in every language of Excel: open motion-functions.xlsx beside your workbook and copy its sheet
there (right-click its tab > Move or Copy); the names come with it.
By hand: Formulas > Name Manager > New for each entry below: its name, and its formula under Refers to.
The names that begin with _ are called by the others: take them all.
"""
PACKAGE = resources.files("workbook.functions") / "addin"


def write_book(path: Path, shown: PageInputs = EXAMPLE) -> None:
    """Write the workbook of the names; the cell that says whether they compute has no saved value."""
    names = [DefinedName(term.name, comment=term.note[:NOTE], attr_text=term.stored) for term in definitions()]
    # a copied sheet brings along these names alone
    pieces = parts(declare(shown), PageInputs, names, f"{NAMESPACE}.")
    pack(archive.with_dynamic_arrays(pieces | {SHEET: WHETHER.sub(rb"\1\2", pieces[SHEET])}), path, overwrite=True)


def write_text(path: Path) -> None:
    """Write the definitions to paste elsewhere: a name, what it is for, and its formula in a line."""
    entries = (f"{term.name}\n{term.note}\n={' '.join(term.formula.split())}\n" for term in definitions())
    path.write_bytes("\n".join([HEAD, *entries]).encode())  # the same line ends on every system


def write_files(folder: Path | None = None) -> list[Path]:
    """Generate the committed files, where they lie or in another folder."""
    book, text = ((folder or FOLDER) / f"motion-functions.{kind}" for kind in ("xlsx", "txt"))
    write_book(book)
    write_text(text)
    return [book, text]


def stale_files() -> list[Path]:
    """Return the old files that today's code would generate differently, and those that are not there."""
    stale = []
    with tempfile.TemporaryDirectory() as folder:
        for fresh in write_files(Path(folder)):
            old = FOLDER / fresh.name
            same = old.exists() and (same_book(fresh, old) if old.suffix == ".xlsx" else cmp(fresh, old, False))
            if not same:
                stale.append(old)
    return stale


def write_add_in(path: Path, overwrite: bool = False, python: str = sys.executable) -> None:
    """Write the add-in, whose menu runs motionbook by a Python.

    Raises WriteError where ``path`` exists, is not named .oxt, or cannot be written.
    """
    if path.suffix.lower() != ".oxt":
        raise WriteError(f"{path}: LibreOffice installs only files named .oxt; expected such a name")
    refuse_existing(path, overwrite)
    data = archive.zipped(add_in(python))
    replace(path, lambda draft: draft.write_bytes(data), overwrite)


def add_in(python: str) -> dict[str, bytes]:
    """Return the files of the add-in by name, in order: texts are on every system the same bytes."""
    described = [f"description/{language}.txt" for language in Text._fields]
    texts = [
        "META-INF/manifest.xml",
        "description.xml",
        *described,
        "motion.py",
        "motion_menu.py",
        "Addons.xcu",
        "ProtocolHandler.xcu",
    ]
    category = Text(*TEXTS["category"])
    wizard = Template((PACKAGE / "CalcAddIns.xcu").read_text(encoding="utf-8"))
    registry = wizard.generate(namespace=NAMESPACE, functions=FUNCTIONS, category=category)
    files = {name: (PACKAGE / name).read_text(encoding="utf-8").encode() for name in texts}
    files["description.xml"] = files["description.xml"].replace(b"VERSION", __version__.encode())
    files["pythonpath/motionbook_python.py"] = f"PYTHON = {python!r}\n".encode()
    files |= {"CalcAddIns.xcu": registry, "motion.rdb": (PACKAGE / "motion.rdb").read_bytes()}
    for module in sorted((PACKAGE / "motion_functions").iterdir(), key=attrgetter("name")):
        if module.name.endswith((".py", ".md")):
            files[f"pythonpath/motion_functions/{module.name}"] = module.read_text(encoding="utf-8").encode()
    return files
