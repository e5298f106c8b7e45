"""The parts of a workbook's package by content type and relationship; refused where the two disagree."""

import io
import re
import zipfile
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from posixpath import basename, dirname, join, normpath
from typing import IO, Any, NamedTuple
from xml.etree.ElementTree import Element, tostring

from workbook.reading.rows import LAST_COLUMN, LAST_ROW, MAIN, Mendable, short, tag

TYPES = "[Content_Types].xml"
WORKBOOKS = (".sheet.main+xml", ".template.main+xml", ".macroEnabled.main+xml")
SHEETS = ("worksheet", "chartsheet", "dialogsheet")  # kinds of relationships, and of content types
STYLES_PART = "xl/styles.xml"
CHART = re.compile(r"/?xl/charts/[^/]*\.xml")
DRAWING = re.compile(r"/?xl/drawings/[^/]*\.xml")
NOTHING_DRAWN = b'<d:wsDr xmlns:d="http://schemas.openxmlformats.org/drawingml/2006/spreadsheetDrawing"/>'
POINT = re.compile(rb"<((?:\w+:)?)pt [^<>]*><\1v>[^<>]*</\1v></\1pt>")
# what an anchor may hold that hides cells (ISO/IEC 29500-1, 20.5.2)
OPAQUE = ("graphicFrame", "pic", "sp")
PIXEL = 9525  # EMU
NOTHING = Element("nothing")


class Relationship(NamedTuple):
    """A relationship: its kind is the last word of its type; no target where it leads out of the package."""

    id: str
    kind: str
    target: str


class Corner(NamedTuple):
    """A point of a sheet: cells to the right and down, from 0, and what is beyond their begin (EMU)."""

    column: int
    row: int
    right: int
    down: int


class Anchor(NamedTuple):
    """The place of a drawing: from a corner to another, or over a width and a height (EMU); the root of its chart."""

    first: Corner
    last: Corner | None
    size: tuple[int, int]
    chart: Element | None = None


class Package:
    """The parts of a workbook by relationship and content type: roots of those that are XML, the names of all.

    Raises Refusal where the two disagree on workbook, worksheets, shared strings or styles.
    """

    def __init__(self, roots: Mapping[str, Element], names: Iterable[str]) -> None:
        self.roots, self.names = roots, set(names)
        self._types = self._content_types()
        self.main = self._only_part("workbook", "", "officeDocument", WORKBOOKS, is_needed=True)
        if self.main not in roots:
            fault = f"its workbook is a part named {short(self.main)}"
            raise Mendable(f"{fault}; expected xl/workbook.xml")
        kind, what = "sharedStrings", "table of shared strings"
        self.strings = self._only_part(what, self.main, kind, f".{kind}+xml")
        styles = self._only_part("table of styles", self.main, "styles", "spreadsheetml.styles+xml")
        if styles not in ("", STYLES_PART):
            raise Mendable(f"its styles are a part named {short(styles)}; expected {STYLES_PART}")
        self.sheets = self._sheet_parts()  # of each worksheet, by its title

    def _content_types(self) -> dict[str, str]:
        """Return the content type of each part; Refusal where one is declared twice, or in another case."""

        def declared(kind: str, name: str) -> list[tuple[str, str]]:
            elements = (e for e in self.roots[TYPES] if tag(e) == kind)
            return [(e.get(name, ""), e.get("ContentType", "")) for e in elements]

        types = declared("Override", "PartName")
        overrides = [(name.removeprefix("/"), kind) for name, kind in types]
        defaults = [(end.lower(), kind) for end, kind in declared("Default", "Extension")]
        what = "declares the content type of"
        refuse_twice(f"{what} {{}} twice", (name.lower() for name, _ in overrides))
        refuse_twice(f"{what} the ending {{}} twice", (end for end, _ in defaults))
        endings, known = dict(defaults), dict(overrides)
        lower = {name.lower() for name in self.names}
        for name in known.keys() - self.names:
            if name.lower() in lower:
                raise Mendable(f"{what} {short(name)}, a part that is written otherwise")
        usual = {name: endings.get(name.rpartition(".")[2].lower(), "") for name in self.names}
        return {name: known.get(name, usual[name]) for name in self.names}

    def relationships(self, of: str) -> list[Relationship]:
        """Return the relationships of a part, or of the package; Refusal where two have the same name."""
        name = join(dirname(of), "_rels", f"{basename(of)}.rels")
        links = []
        for e in (e for e in self.roots.get(name, ()) if tag(e) == "Relationship"):
            target = normpath(join("/", dirname(of), e.get("Target", ""))).removeprefix("/")
            target = target if e.get("TargetMode", "Internal") == "Internal" else ""
            kind = e.get("Type", "").rpartition("/")[2]
            links.append(Relationship(e.get("Id", ""), kind, target))
        twice = f"has two relationships of the name {{}} in {short(name)}"
        refuse_twice(twice, (link.id for link in links))
        return links

    def _only_part(self, what: str, of: str, kind: str, endings: str | tuple[str, ...], is_needed: bool = False) -> str:
        """Return the only part that relationship and content type call so; nothing where neither does, if it may."""
        targets = [link.target for link in self.relationships(of) if link.kind == kind]
        typed_so = [name for name, known in self._types.items() if known.endswith(endings)]
        if not (targets or typed_so or is_needed):
            return ""
        if len(targets) != 1 or typed_so != targets or targets[0] not in self.names:
            parts = ", ".join(map(short, dict.fromkeys([*targets, *typed_so]))) or "no part"
            fault = f"{parts} could be its {what} by relationship or content type"
            raise Mendable(f"{fault}; expected one by both")
        return targets[0]

    def _sheet_parts(self) -> dict[str, str]:
        """Return the part of each sheet by its title; Refusal where names differ in case only, or one has no part."""
        listed, names = self._only_child("sheets"), self._only_child("definedNames")
        refuse_twice("has two sheets named {}", (e.get("name", "").casefold() for e in listed))
        scoped = ((e.get("name", "").casefold(), e.get("localSheetId")) for e in names)
        spelled = (f"{name} (sheet {sheet})" if sheet else name for name, sheet in scoped)
        refuse_twice("defines the name {} twice", spelled)
        by_id = {link.id: link for link in self.relationships(self.main)}
        parts = {}
        for title, e in ((e.get("name", ""), e) for e in listed):
            link = by_id.get(next((v for key, v in e.attrib.items() if key.endswith("}id")), ""))
            known = self._types.get(link.target, "") if link else ""
            if link is None or link.kind not in SHEETS or not known.endswith(f".{link.kind}+xml"):
                message = "leads to no part that is one by relationship and content type"
                raise Mendable(f"its sheet {short(title)} {message}")
            if link.kind == "worksheet":
                parts[title] = link.target
        return parts

    def _only_child(self, name: str) -> list[Element]:
        """Return the children of the workbook's only element of this name, which stands below its root."""
        root = self.roots[self.main]
        held = [e for e in root.iter() if tag(e) == name]
        if held and held != root.findall(f"{MAIN}{name}")[:1]:
            where = "more than once, or in another place"
            raise Mendable(f"damaged: its workbook holds <{name}> {where}")
        return [child for element in held for child in element]

    def drawing_anchors(self, sheet: str) -> list[Anchor]:
        """Return the drawings on a sheet that hide what is behind them, the lowest first."""
        drawn = list[Anchor]()
        for link in self.relationships(sheet):
            root = self.roots.get(link.target, NOTHING)
            if link.kind == "drawing":
                links = self.relationships(link.target)
                charts = {to.id: self.roots.get(to.target, NOTHING) for to in links}
                drawn += anchors(root, charts)
            elif link.kind == "vmlDrawing":
                drawn += shown_notes(root)
        return drawn


def refuse_twice(words: str, names: Iterable[str]) -> None:
    """Raise Refusal for the first name that stands there twice."""
    for name, times in Counter(names).items():
        if times > 1:
            raise Mendable(f"{words.format(short(name))}; once is expected")


def without_cached_points(part: str, data: bytes) -> bytes:
    """Return a part of a workbook; of a chart without its saved points."""
    return POINT.sub(b"", data) if CHART.fullmatch(part) else data


class StrippedArchive(zipfile.ZipFile):
    """A workbook's archive whose sheets hold neither drawings nor rows: ``pages`` are sheets without these."""

    def __init__(self, path: Path, pages: Mapping[str, Element]) -> None:
        super().__init__(path)
        self.pages = pages
        self.part = ""  # the last that was opened, in quotes

    def open(self, name: str | zipfile.ZipInfo, *args: Any, **how: Any) -> IO[bytes]:
        """Open a part for reading."""
        part = name if isinstance(name, str) else name.filename
        self.part = short(part)
        if DRAWING.fullmatch(part):
            return io.BytesIO(NOTHING_DRAWN)
        if part in self.pages:
            return io.BytesIO(tostring(self.pages[part]))
        return super().open(name, *args, **how)


def anchors(root: Element, charts: Mapping[str, Element]) -> Iterator[Anchor]:
    """Yield the anchors of a drawing that hold what hides; ``charts`` are the roots to which its links lead."""
    for element in root.iter():  # what newer programs alone know stands within an alternative
        if not tag(element).endswith("Anchor") or not is_opaque(element):
            continue
        held = {tag(child): child for child in element}
        ids = [value for x in element.iter() if tag(x) == "chart" for value in x.attrib.values()]
        at = Corner(0, 0, *two_numbers(held.get("pos", NOTHING), "x", "y"))
        yield Anchor(
            corner(held["from"]) if "from" in held else at,
            corner(held["to"]) if "to" in held else None,
            two_numbers(held.get("ext", NOTHING), "cx", "cy"),
            next((charts[name] for name in ids if name in charts), None),
        )


def is_opaque(anchor: Element) -> bool:
    """Whether an anchor holds what is shown and hides what is behind it."""
    is_hidden = any(x.get("hidden") in ("1", "true") for x in anchor.iter() if tag(x) == "cNvPr")
    return not is_hidden and any(tag(x) in OPAQUE and not see_through(x) for x in anchor.iter())


def see_through(shape: Element) -> bool:
    """Whether a shape has neither a fill nor a text."""
    texts = (part.text or "" for part in shape.iter() if tag(part) == "t")
    if tag(shape) != "sp" or any(map(str.strip, texts)):
        return False
    look = next((child for child in shape if tag(child) == "spPr"), None)
    return look is not None and any(tag(child) == "noFill" for child in look)


def shown_notes(root: Element) -> Iterator[Anchor]:
    """Yield where the notes and buttons of a sheet lie that are always shown (VML; ISO/IEC 29500-4, 19.4)."""
    for shape in root.iter():
        if tag(shape) != "shape" or "visibility:hidden" in shape.get("style", "").replace(" ", ""):
            continue
        place = next((part.text or "" for part in shape.iter() if tag(part) == "Anchor"), "")
        numbers = [bounded_int(text) for text in place.split(",")]
        if len(numbers) == 8:
            first, last = (
                Corner(column, row, right * PIXEL, down * PIXEL)
                for column, right, row, down in (numbers[:4], numbers[4:])
            )
            yield Anchor(first, last, (0, 0))


def corner(element: Element) -> Corner:
    """Return a corner of an anchor."""
    held = {tag(child): bounded_int(child.text) for child in element}
    column, row = min(held.get("col", 0), LAST_COLUMN), min(held.get("row", 0), LAST_ROW)
    return Corner(max(column, 0), max(row, 0), held.get("colOff", 0), held.get("rowOff", 0))


def two_numbers(element: Element, first: str, other: str) -> tuple[int, int]:
    """Return two numbers of an element; 0 where it has none."""
    return bounded_int(element.get(first)), bounded_int(element.get(other))


def bounded_int(text: str | None) -> int:
    """Return a number of a drawing; 0 for what is none, or beyond all sheets."""
    digits = (text or "").strip()
    return int(digits) if re.fullmatch("-?[0-9]{1,15}", digits) else 0
