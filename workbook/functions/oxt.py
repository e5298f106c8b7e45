"""The LibreOffice add-in ``motion.oxt``: the component, its types, and the texts of the function wizard in an archive.

``motion.rdb`` holds the component's types in LibreOffice's own form, made by its SDK of ``motion.idl``, which a test
compares with the functions: unoidl-write program/types.rdb program/types/offapi.rdb motion.idl motion.rdb
"""

from importlib import resources
from operator import attrgetter
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from workbook import __version__
from workbook.errors import WriteError
from workbook.functions.addin.motion_functions.laws import Text
from workbook.functions.declared import FUNCTIONS, NAMESPACE, TEXTS
from workbook.writing.archive import zipped
from workbook.writing.place import refuse_existing, replace

CATEGORY = Text(*TEXTS["category"])
PACKAGE = resources.files("workbook.functions") / "addin"
OOR = {
    "xmlns:oor": "http://openoffice.org/2001/registry",
    "xmlns:xs": "http://www.w3.org/2001/XMLSchema",
    "oor:name": "CalcAddIns",
    "oor:package": "org.openoffice.Office",
}


def write(path: Path, overwrite: bool = False) -> None:
    """Write the add-in; raise WriteError where ``path`` exists, is not named .oxt, or cannot be written."""
    if path.suffix.lower() != ".oxt":
        raise WriteError(f"{path}: LibreOffice installs only files named .oxt; expected such a name")
    refuse_existing(path, overwrite)
    data = zipped(parts())

    def fill(draft: Path) -> None:
        draft.write_bytes(data)

    replace(path, fill, overwrite)


def parts() -> dict[str, bytes]:
    """Return the files of the add-in by name, in order: texts are on every system the same bytes."""
    texts = [
        "META-INF/manifest.xml",
        "description.xml",
        *(f"description/{one}.txt" for one in Text._fields),
        "motion.py",
    ]
    made = {name: (PACKAGE / name).read_text(encoding="utf-8").encode() for name in texts}
    made["description.xml"] = made["description.xml"].replace(b"VERSION", __version__.encode())
    made |= {"CalcAddIns.xcu": calc_add_ins(), "motion.rdb": (PACKAGE / "motion.rdb").read_bytes()}
    for module in sorted((PACKAGE / "motion_functions").iterdir(), key=attrgetter("name")):
        if module.name.endswith(".py"):
            made[f"pythonpath/motion_functions/{module.name}"] = module.read_text(encoding="utf-8").encode()
    return made


def calc_add_ins() -> bytes:
    """Return names and help texts of the functions for the function wizard."""
    root = Element("oor:component-data", OOR)
    functions = node(node(node(root, "AddInInfo"), NAMESPACE, new=True), "AddInFunctions")
    for function in FUNCTIONS:
        entry = node(functions, function.key, new=True)
        for name in ("DisplayName", "CompatibilityName"):  # without the second, a saved .xlsx gets empty names
            localized(entry, name, Text(*[function.name] * len(Text._fields)))
        localized(entry, "Description", function.help)
        SubElement(SubElement(entry, "prop", {"oor:name": "Category"}), "value").text = "Add-In"
        localized(entry, "CategoryDisplayName", CATEGORY)
        arguments = node(entry, "Parameters")
        for argument in function.arguments:
            about = node(arguments, argument.name.en, new=True)
            localized(about, "DisplayName", argument.name)
            localized(about, "Description", argument.help)
    ElementTree.indent(root)
    text = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()


def node(parent: Element, name: str, new: bool = False) -> Element:
    """Add a node of the configuration."""
    return SubElement(parent, "node", {"oor:name": name} | ({"oor:op": "replace"} if new else {}))


def localized(parent: Element, name: str, text: Text) -> None:
    """Add a property with a value in each language."""
    prop = SubElement(parent, "prop", {"oor:name": name})
    for language, words in text._asdict().items():
        SubElement(prop, "value", {"xml:lang": language}).text = words
