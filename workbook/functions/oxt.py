"""The LibreOffice add-in ``motion.oxt``: the component, its types, and the texts of the function wizard in an archive.

``motion.rdb`` holds the component's types in LibreOffice's own form, made by its SDK of ``motion.idl``, which a test
compares with the functions: unoidl-write program/types.rdb program/types/offapi.rdb motion.idl motion.rdb
"""

from importlib import resources
from importlib.resources.abc import Traversable
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

TITLE, ABOUT, CATEGORY = (Text(*TEXTS["extension"][name]) for name in ("title", "about", "category"))
IDENTIFIER = "motionbook.motion"
OLDEST = "7.1"  # the first LibreOffice that brings Python 3.8 along
PACKAGE = resources.files("workbook.functions") / "addin"
COMPONENT, RDB, FUNCTIONS_FOLDER = "motion.py", "motion.rdb", "motion_functions"
KINDS = {
    RDB: "application/vnd.sun.star.uno-typelibrary;type=RDB",
    COMPONENT: "application/vnd.sun.star.uno-component;type=Python",
    "CalcAddIns.xcu": "application/vnd.sun.star.configuration-data",
}
OOR = {
    "xmlns:oor": "http://openoffice.org/2001/registry",
    "xmlns:xs": "http://www.w3.org/2001/XMLSchema",
    "oor:name": "CalcAddIns",
    "oor:package": "org.openoffice.Office",
}
DESCRIPTION = {
    "xmlns": "http://openoffice.org/extensions/description/2006",
    "xmlns:d": "http://openoffice.org/extensions/description/2006",
    "xmlns:l": "http://libreoffice.org/extensions/description/2011",
    "xmlns:xlink": "http://www.w3.org/1999/xlink",
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
    """Return the files of the add-in by name, in order."""
    modules = sorted((PACKAGE / FUNCTIONS_FOLDER).iterdir(), key=attrgetter("name"))
    about = {f"description/{language}.txt": text.encode() for language, text in ABOUT._asdict().items()}
    return {
        "META-INF/manifest.xml": manifest(),
        "description.xml": description(),
        **about,
        "CalcAddIns.xcu": calc_add_ins(),
        RDB: (PACKAGE / RDB).read_bytes(),
        COMPONENT: source(PACKAGE / COMPONENT),
        **{f"pythonpath/{FUNCTIONS_FOLDER}/{one.name}": source(one) for one in modules if one.name.endswith(".py")},
    }


def source(file: Traversable) -> bytes:
    """Return a source file with plain line ends, on every system the same bytes."""
    return file.read_text(encoding="utf-8").encode()


def manifest() -> bytes:
    """Return the list of the files that LibreOffice registers."""
    root = Element("manifest:manifest", {"xmlns:manifest": "http://openoffice.org/2001/manifest"})
    for name, kind in KINDS.items():
        SubElement(root, "manifest:file-entry", {"manifest:full-path": name, "manifest:media-type": kind})
    return xml(root)


def description() -> bytes:
    """Return what the extension manager shows, and the oldest LibreOffice that will do."""
    root = Element("description", DESCRIPTION)
    SubElement(root, "identifier", value=IDENTIFIER)
    SubElement(root, "version", value=__version__)
    needs = SubElement(root, "dependencies")
    SubElement(needs, "l:LibreOffice-minimal-version", {"value": OLDEST, "d:name": f"LibreOffice {OLDEST}"})
    names, abouts = SubElement(root, "display-name"), SubElement(root, "extension-description")
    for language, title in TITLE._asdict().items():
        SubElement(names, "name", lang=language).text = title
        SubElement(abouts, "src", {"lang": language, "xlink:href": f"description/{language}.txt"})
    return xml(root)


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
    return xml(root)


def node(parent: Element, name: str, new: bool = False) -> Element:
    """Add a node of the configuration."""
    return SubElement(parent, "node", {"oor:name": name} | ({"oor:op": "replace"} if new else {}))


def localized(parent: Element, name: str, text: Text) -> None:
    """Add a property with a value in each language."""
    prop = SubElement(parent, "prop", {"oor:name": name})
    for language, words in text._asdict().items():
        SubElement(prop, "value", {"xml:lang": language}).text = words


def xml(root: Element) -> bytes:
    """Return the text of an XML file."""
    ElementTree.indent(root)
    text = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()
