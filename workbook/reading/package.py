"""Which part of a package is what: openpyxl goes by content types and names, spreadsheet programs by relationships.

A package in which the two disagree has two readings, and is refused.
"""

import io
import re
import zipfile
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path
from posixpath import basename, dirname, join, normpath
from typing import IO, Any, NamedTuple
from xml.etree.ElementTree import Element, tostring

from workbook.reading.count import SAVE_AS, Refusal, shown
from workbook.reading.rows import MAIN, tag

TYPES = "[Content_Types].xml"
WORKBOOKS = (".sheet.main+xml", ".template.main+xml", "sheet.macroEnabled.main+xml", "template.macroEnabled.main+xml")
SHEETS = {"worksheet": ".worksheet+xml", "chartsheet": ".chartsheet+xml", "dialogsheet": ".dialogsheet+xml"}
STRINGS, STYLES = ".sharedStrings+xml", "spreadsheetml.styles+xml"
STYLES_PART = "xl/styles.xml"


class Link(NamedTuple):
    """A relationship: its kind is the last word of its type; no target where it leads out of the package."""

    id: str
    kind: str
    target: str


class Package(NamedTuple):
    """The parts that a book is read from: the workbook, its worksheets by their titles, and the shared strings."""

    workbook: str
    sheets: dict[str, str]
    strings: str


def package(parts: Mapping[str, Element], names: Iterable[str]) -> Package:
    """Return what is what; ``parts`` are the roots of those that are XML, ``names`` of all. Raises Refusal."""
    there = set(names)
    types = content_types(parts[TYPES], there)
    roots = [link for link in links(parts, "") if link.kind == "officeDocument"]
    main = one("workbook", [link.target for link in roots], typed(types, WORKBOOKS), there)
    if main not in parts:
        raise Refusal(f"its workbook is a part named {shown(main)}; expected xl/workbook.xml; {SAVE_AS}")
    relations = links(parts, main)
    strings = linked("table of shared strings", relations, "sharedStrings", typed(types, (STRINGS,)), there)
    styles = linked("table of styles", relations, "styles", typed(types, (STYLES,)), there)
    if styles not in ("", STYLES_PART):
        raise Refusal(f"its styles are a part named {shown(styles)}; expected {STYLES_PART}; {SAVE_AS}")
    return Package(main, sheets(parts[main], relations, types), strings)


def content_types(root: Element, names: set[str]) -> dict[str, str]:
    """Return the content type of each part; Refusal where one is declared twice, or has a type of another case."""
    overrides = [(e.get("PartName", "").removeprefix("/"), e.get("ContentType", ""))
                 for e in root if tag(e) == "Override"]  # fmt: skip
    defaults = [(e.get("Extension", "").lower(), e.get("ContentType", "")) for e in root if tag(e) == "Default"]
    refuse_twice("declares the content type of {} twice", (name.lower() for name, _ in overrides))
    refuse_twice("declares the content type of the ending {} twice", (ending for ending, _ in defaults))
    by_ending, known = dict(defaults), dict(overrides)
    lower = {name.lower() for name in names}
    for name in known.keys() - names:
        if name.lower() in lower:
            raise Refusal(f"declares the content type of {shown(name)}, a part that is written otherwise; {SAVE_AS}")
    return {name: known.get(name, by_ending.get(name.rpartition(".")[2].lower(), "")) for name in names}


def links(parts: Mapping[str, Element], of: str) -> list[Link]:
    """Return the relationships of a part, or of the package; Refusal where two have one name."""
    name = join(dirname(of), "_rels", f"{basename(of)}.rels")
    found = []
    for e in (e for e in parts.get(name, ()) if tag(e) == "Relationship"):
        target = normpath(join("/", dirname(of), e.get("Target", ""))).removeprefix("/")
        inside = e.get("TargetMode", "Internal") == "Internal"
        found.append(Link(e.get("Id", ""), e.get("Type", "").rpartition("/")[2], target if inside else ""))
    refuse_twice(f"has two relationships of the name {{}} in {shown(name)}", (one.id for one in found))
    return found


def linked(what: str, relations: list[Link], kind: str, typed_so: list[str], names: set[str]) -> str:
    """Return the part of a kind that the workbook has, or nothing where it has none by either reading."""
    targets = [link.target for link in relations if link.kind == kind]
    return one(what, targets, typed_so, names) if targets or typed_so else ""


def one(what: str, targets: list[str], typed_so: list[str], names: set[str]) -> str:
    """Return the one part that both relationship and content type call by a name; raise Refusal for all else."""
    if len(targets) != 1 or typed_so != targets or targets[0] not in names:
        said = ", ".join(shown(name) for name in dict.fromkeys([*targets, *typed_so])) or "no part"
        raise Refusal(f"{said} could be its {what} by relationship or content type; expected one by both; {SAVE_AS}")
    return targets[0]


def typed(types: Mapping[str, str], endings: tuple[str, ...]) -> list[str]:
    """Return the parts with a content type of one of these endings."""
    return [name for name, kind in types.items() if kind.endswith(endings)]


def sheets(root: Element, relations: list[Link], types: Mapping[str, str]) -> dict[str, str]:
    """Return the part of each sheet by its title; Refusal where names differ in case only, or a sheet has no part."""
    listed = list(only(root, "sheets"))
    refuse_twice("has two sheets named {}", (e.get("name", "").casefold() for e in listed))
    names = [(e.get("localSheetId"), e.get("name", "").casefold()) for e in only(root, "definedNames")]
    refuse_twice("defines the name {} twice", (f"{name} (sheet {scope})" if scope else name for scope, name in names))
    by_id = {link.id: link for link in relations}
    led = {e.get("name", ""): leads_to(e, by_id, types) for e in listed}
    return {title: link.target for title, link in led.items() if link.kind == "worksheet"}


def leads_to(element: Element, by_id: Mapping[str, Link], types: Mapping[str, str]) -> Link:
    """Return the relationship by which a sheet of the workbook leads to its part."""
    number = next((value for key, value in element.attrib.items() if key.endswith("}id")), "")
    found = by_id.get(number)
    if found is None or found.kind not in SHEETS or not types.get(found.target, "").endswith(SHEETS[found.kind]):
        what = shown(element.get("name", ""))
        raise Refusal(f"its sheet {what} leads to no part that is one by relationship and content type; {SAVE_AS}")
    return found


def only(root: Element, name: str) -> Element | list[Element]:
    """Return the one child of this name, wherever it stands below the root; nothing where there is none."""
    found = [e for e in root.iter() if tag(e) == name]
    if len(found) > 1 or (found and (found[0] not in list(root) or found[0].tag != f"{MAIN}{name}")):
        raise Refusal(f"damaged: its workbook holds <{name}> more than once, or in another place; {SAVE_AS}")
    return found[0] if found else []


def refuse_twice(words: str, names: Iterable[str]) -> None:
    """Raise Refusal for the first name that stands there twice."""
    for name, times in Counter(names).items():
        if times > 1:
            raise Refusal(f"{words.format(shown(name))}; once is expected; {SAVE_AS}")


CHART = re.compile(r"/?xl/charts/[^/]*\.xml")
DRAWING = re.compile(r"/?xl/drawings/[^/]*\.xml")
NOTHING_DRAWN = b'<d:wsDr xmlns:d="http://schemas.openxmlformats.org/drawingml/2006/spreadsheetDrawing"/>'
POINT = re.compile(rb"<((?:\w+:)?)pt [^<>]*><\1v>[^<>]*</\1v></\1pt>")


def without_points(part: str, data: bytes) -> bytes:
    """Return a part of a workbook; of a chart without its saved points."""
    return POINT.sub(b"", data) if CHART.fullmatch(part) else data


class Bare(zipfile.ZipFile):
    """A workbook's archive whose sheets hold neither drawings nor rows: ``pages`` are the sheets without these."""

    def __init__(self, path: Path, pages: Mapping[str, Element]) -> None:
        super().__init__(path)
        self.pages = pages

    def open(self, name: str | zipfile.ZipInfo, *args: Any, **how: Any) -> IO[bytes]:
        """Open a part for reading."""
        part = name if isinstance(name, str) else name.filename
        if DRAWING.fullmatch(part):
            return io.BytesIO(NOTHING_DRAWN)
        return io.BytesIO(tostring(self.pages[part])) if part in self.pages else super().open(name, *args, **how)
