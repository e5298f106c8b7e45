"""The files by which spreadsheets get the functions: a workbook with the names, and the add-in ``motion.oxt``.

LibreOffice's SDK made ``motion.rdb``: unoidl-write program/types.rdb program/types/offapi.rdb motion.idl motion.rdb
"""

import re
import sys
import tempfile
from importlib import resources
from operator import attrgetter
from pathlib import Path

from openpyxl.workbook.defined_name import DefinedName
from tornado.template import Template

from workbook import __version__
from workbook.controllers.registry import targets
from workbook.errors import WriteError
from workbook.functions.declarations import FUNCTIONS, NAMESPACE, TEXTS, Text
from workbook.functions.names import definitions
from workbook.functions.page import EXAMPLE, PageInputs, declare
from workbook.template import FOLDER
from workbook.writing import archive
from workbook.writing.archive import same_book
from workbook.writing.output_files import refuse_existing, replace
from workbook.writing.write import pack, parts

BOOK = FOLDER / "motion-functions.xlsx"
SHEET = "xl/worksheets/sheet1.xml"
WHETHER = re.compile(rb'(<c r="\w+" s="\d+") t="str"(><f>IF\(ISERROR\([^<]*</f>)<v>[^<]*</v>')
NOTE = 255  # characters of the comment that Excel shows beside a name
PACKAGE = resources.files("workbook.functions") / "addin"


def write_book(path: Path = BOOK, shown: PageInputs = EXAMPLE) -> None:
    """Write the workbook of the names; the cell that says whether they compute has no saved value."""
    names = [DefinedName(term.name, comment=term.note[:NOTE], attr_text=term.stored) for term in definitions()]
    # a copied sheet brings along these names alone
    pieces = parts(declare(shown), PageInputs, names, f"{NAMESPACE}.")
    pieces[SHEET] = WHETHER.sub(rb"\1\2", pieces[SHEET])
    pack(archive.with_part(pieces, "metadata", archive.METADATA, "sheetMetadata"), path, overwrite=True)


def is_stale() -> bool:
    """Whether today's code would generate the committed workbook differently, or it is not there."""
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder, BOOK.name)
        write_book(fresh)
        return not (BOOK.exists() and same_book(fresh, BOOK))


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
    kinds = {f"{target.title} ({target.name})": (target.name, target.suffix) for target in targets()}
    files["pythonpath/motionbook_python.py"] = f"PYTHON = {python!r}\nTARGETS = {kinds!r}\n".encode()
    files |= {"CalcAddIns.xcu": registry, "motion.rdb": (PACKAGE / "motion.rdb").read_bytes()}
    for module in sorted((PACKAGE / "motion_functions").iterdir(), key=attrgetter("name")):
        if module.name.endswith((".py", ".md")):
            files[f"pythonpath/motion_functions/{module.name}"] = module.read_text(encoding="utf-8").encode()
    return files
