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

from workbook.reading.rows import LAST_COLUMN, LAST_ROW, MAIN, SAVE_AS, Refusal, short, tag

TYPES = "[Content_Types].xml"
WORKBOOKS = (".sheet.main+xml", ".template.main+xml", "sheet.macroEnabled.main+xml", "template.macroEnabled.main+xml")
SHEETS = {"worksheet": ".worksheet+xml", "chartsheet": ".chartsheet+xml", "dialogsheet": ".dialogsheet+xml"}
STRINGS, STYLES = ".sharedStrings+xml", "spreadsheetml.styles+xml"
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


def find_parts(parts: Mapping[str, Element], names: Iterable[str]) -> tuple[str, dict[str, str], str]:
    """Return the parts of workbook, worksheets by title, and shared strings; ``parts`` are roots of all XML ones."""
    there = set(names)
    types = content_types(parts[TYPES], there)
    roots = [link for link in relationships(parts, "") if link.kind == "officeDocument"]
    main = only_part("workbook", [link.target for link in roots], of_type(types, WORKBOOKS), there)
    if main not in parts:
        raise Refusal(f"its workbook is a part named {short(main)}; expected xl/workbook.xml; {SAVE_AS}")
    relations = relationships(parts, main)
    strings = optional_part("table of shared strings", relations, "sharedStrings", of_type(types, (STRINGS,)), there)
    styles = optional_part("table of styles", relations, "styles", of_type(types, (STYLES,)), there)
    if styles not in ("", STYLES_PART):
        raise Refusal(f"its styles are a part named {short(styles)}; expected {STYLES_PART}; {SAVE_AS}")
    return main, sheet_parts(parts[main], relations, types), strings


def content_types(root: Element, names: set[str]) -> dict[str, str]:
    """Return the content type of each part; Refusal where a part is declared twice, or has a type of another case."""
    overrides = [
        (e.get("PartName", "").removeprefix("/"), e.get("ContentType", "")) for e in root if tag(e) == "Override"
    ]
    defaults = [(e.get("Extension", "").lower(), e.get("ContentType", "")) for e in root if tag(e) == "Default"]
    refuse_twice("declares the content type of {} twice", (name.lower() for name, _ in overrides))
    refuse_twice("declares the content type of the ending {} twice", (end for end, _ in defaults))
    endings, known = dict(defaults), dict(overrides)
    lower = {name.lower() for name in names}
    for name in known.keys() - names:
        if name.lower() in lower:
            raise Refusal(f"declares the content type of {short(name)}, a part that is written otherwise; {SAVE_AS}")
    return {name: known.get(name, endings.get(name.rpartition(".")[2].lower(), "")) for name in names}


def relationships(parts: Mapping[str, Element], of: str) -> list[Relationship]:
    """Return the relationships of a part, or of the package; Refusal where two have the same name."""
    name = join(dirname(of), "_rels", f"{basename(of)}.rels")
    links = []
    for e in (e for e in parts.get(name, ()) if tag(e) == "Relationship"):
        target = normpath(join("/", dirname(of), e.get("Target", ""))).removeprefix("/")
        inside = e.get("TargetMode", "Internal") == "Internal"
        links.append(Relationship(e.get("Id", ""), e.get("Type", "").rpartition("/")[2], target if inside else ""))
    refuse_twice(f"has two relationships of the name {{}} in {short(name)}", (link.id for link in links))
    return links


def optional_part(what: str, relations: list[Relationship], kind: str, typed_so: list[str], names: set[str]) -> str:
    """Return the part of a kind that the workbook has, or nothing where it has none by either reading."""
    targets = [link.target for link in relations if link.kind == kind]
    return only_part(what, targets, typed_so, names) if targets or typed_so else ""


def only_part(what: str, targets: list[str], typed_so: list[str], names: set[str]) -> str:
    """Return the only part that both relationship and content type call by a name; raise Refusal for all else."""
    if len(targets) != 1 or typed_so != targets or targets[0] not in names:
        listed = ", ".join(map(short, dict.fromkeys([*targets, *typed_so]))) or "no part"
        raise Refusal(f"{listed} could be its {what} by relationship or content type; expected one by both; {SAVE_AS}")
    return targets[0]


def of_type(types: Mapping[str, str], endings: tuple[str, ...]) -> list[str]:
    """Return the parts with a content type of any of these endings."""
    return [name for name, kind in types.items() if kind.endswith(endings)]


def sheet_parts(root: Element, relations: list[Relationship], types: Mapping[str, str]) -> dict[str, str]:
    """Return the part of each sheet by its title; Refusal where names differ in case only, or a sheet has no part."""
    listed = list(only_child(root, "sheets"))
    refuse_twice("has two sheets named {}", (e.get("name", "").casefold() for e in listed))
    names = [(e.get("localSheetId"), e.get("name", "").casefold()) for e in only_child(root, "definedNames")]
    refuse_twice("defines the name {} twice", (f"{name} (sheet {scope})" if scope else name for scope, name in names))
    by_id = {link.id: link for link in relations}
    led = {}
    for title, e in ((e.get("name", ""), e) for e in listed):
        link = by_id.get(next((v for key, v in e.attrib.items() if key.endswith("}id")), ""))
        if link is None or link.kind not in SHEETS or not types.get(link.target, "").endswith(SHEETS[link.kind]):
            message = "leads to no part that is one by relationship and content type"
            raise Refusal(f"its sheet {short(title)} {message}; {SAVE_AS}")
        if link.kind == "worksheet":
            led[title] = link.target
    return led


def only_child(root: Element, name: str) -> Element | list[Element]:
    """Return the only child of this name, wherever it stands below the root; nothing where there is none."""
    children = [e for e in root.iter() if tag(e) == name]
    if len(children) > 1 or (children and (children[0] not in list(root) or children[0].tag != f"{MAIN}{name}")):
        raise Refusal(f"damaged: its workbook holds <{name}> more than once, or in another place; {SAVE_AS}")
    return children[0] if children else []


def refuse_twice(words: str, names: Iterable[str]) -> None:
    """Raise Refusal for the first name that stands there twice."""
    for name, times in Counter(names).items():
        if times > 1:
            raise Refusal(f"{words.format(short(name))}; once is expected; {SAVE_AS}")


def without_cached_points(part: str, data: bytes) -> bytes:
    """Return a part of a workbook; of a chart without its saved points."""
    return POINT.sub(b"", data) if CHART.fullmatch(part) else data


class StrippedArchive(zipfile.ZipFile):
    """A workbook's archive whose sheets hold neither drawings nor rows: ``pages`` are the sheets without these."""

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
        return io.BytesIO(tostring(self.pages[part])) if part in self.pages else super().open(name, *args, **how)


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


def drawing_anchors(parts: Mapping[str, Element], sheet: str) -> list[Anchor]:
    """Return the drawings on a sheet that hide what is behind them, the lowest first; ``parts`` are roots by names."""
    drawn = []
    for link in relationships(parts, sheet):
        if link.kind == "drawing":
            charts = {related.id: parts.get(related.target, NOTHING) for related in relationships(parts, link.target)}
            drawn += list(anchors(parts.get(link.target, NOTHING), charts))
        elif link.kind == "vmlDrawing":
            drawn += shown_notes(parts.get(link.target, NOTHING))
    return drawn


def anchors(root: Element, charts: Mapping[str, Element]) -> Iterator[Anchor]:
    """Yield the anchors of a drawing that hold what hides; ``charts`` are the roots to which its links lead."""
    for element in root.iter():  # what newer programs alone know stands within an alternative
        if not tag(element).endswith("Anchor") or not is_opaque(element):
            continue
        held = {tag(child): child for child in element}
        ids = [value for x in element.iter() if tag(x) == "chart" for value in x.attrib.values()]
        yield Anchor(
            corner(held["from"]) if "from" in held else Corner(0, 0, *two_numbers(held.get("pos"), "x", "y")),
            corner(held["to"]) if "to" in held else None,
            two_numbers(held.get("ext"), "cx", "cy"),
            next((charts[name] for name in ids if name in charts), None),
        )


def is_opaque(anchor: Element) -> bool:
    """Whether an anchor holds what is shown and hides what is behind it."""
    is_hidden = any(x.get("hidden") in ("1", "true") for x in anchor.iter() if tag(x) == "cNvPr")
    return not is_hidden and any(tag(x) in OPAQUE and not see_through(x) for x in anchor.iter())


def see_through(shape: Element) -> bool:
    """Whether a shape has neither a fill nor a text."""
    if tag(shape) != "sp" or any(tag(part) == "t" and (part.text or "").strip() for part in shape.iter()):
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
            left, right, top, down, *rest = numbers
            ends = (left, top, right * PIXEL, down * PIXEL), (rest[0], rest[2], rest[1] * PIXEL, rest[3] * PIXEL)
            yield Anchor(Corner(*ends[0]), Corner(*ends[1]), (0, 0))


def corner(element: Element) -> Corner:
    """Return a corner of an anchor."""
    held = {tag(child): bounded_int(child.text) for child in element}
    column, row = min(held.get("col", 0), LAST_COLUMN), min(held.get("row", 0), LAST_ROW)
    return Corner(max(column, 0), max(row, 0), held.get("colOff", 0), held.get("rowOff", 0))


def two_numbers(element: Element | None, first: str, other: str) -> tuple[int, int]:
    """Return two numbers of an element; 0 where it has none."""
    return (0, 0) if element is None else (bounded_int(element.get(first)), bounded_int(element.get(other)))


def bounded_int(text: str | None) -> int:
    """Return a number of a drawing; 0 for what is none, or beyond all sheets."""
    digits = (text or "").strip()
    return int(digits) if digits.lstrip("-").isdecimal() and digits.isascii() and len(digits) < 16 else 0
