"""The parts of a workbook file as Excel itself writes them, and the same bytes each time.

openpyxl leaves four things that Excel mends in silence when it saves: the time of day, charts without alternative
text, texts inside the cells instead of in one shared table, and fonts whose elements are out of order.
"""

from __future__ import annotations

import io
import re
import zipfile
from html import escape
from pathlib import Path
from xml.etree import ElementTree

EPOCH = (2020, 1, 1, 0, 0, 0)  # written into the file instead of the time of day
MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
FONT_ORDER = (
    "b", "i", "strike", "condense", "extend", "outline", "shadow", "u", "vertAlign",
    "sz", "color", "name", "family", "charset", "scheme",
)  # fmt: skip
INLINE = re.compile(rb't="inlineStr"><is>(<t[ >].*?</t>)</is>', re.DOTALL)
STRINGS = "xl/sharedStrings.xml"
STRINGS_TYPE = (
    b'<Override PartName="/xl/sharedStrings.xml" '
    b'ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.sharedStrings+xml" />'
)
STRINGS_LINK = (
    b'<Relationship Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/sharedStrings" '
    b'Target="sharedStrings.xml" Id="strings" />'
)


def pack(parts: dict[str, bytes], path: Path, abouts: list[tuple[str, str]]) -> None:
    """Write the parts of a file to ``path``; ``abouts`` are title and alternative text of each chart, in order."""
    dated(parts)
    described(parts, abouts)
    shared(parts)
    parts["xl/styles.xml"] = ordered(parts["xl/styles.xml"])
    path.write_bytes(zipped(parts, zipfile.ZIP_DEFLATED))


def zipped(parts: dict[str, bytes], method: int = zipfile.ZIP_STORED) -> bytes:
    """Return the archive of the parts, in their order, with the fixed time."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", method) as archive:
        for name, part in parts.items():
            archive.writestr(zipfile.ZipInfo(name, EPOCH), part, method)
    return data.getvalue()


def unzipped(data: bytes) -> dict[str, bytes]:
    """Return the parts of an archive by name."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return {info.filename: archive.read(info) for info in archive.infolist()}


def respelled(parts: dict[str, bytes], pattern: bytes, spellings: dict[str, str]) -> dict[str, bytes]:
    """Return the parts with other spellings, on the sheets, of what ``pattern`` finds."""
    table = {old.encode(): new.encode() for old, new in spellings.items()}

    def spelled(found: re.Match[bytes]) -> bytes:
        return table.get(found[0], found[0])

    return {
        name: re.sub(pattern, spelled, part) if name.startswith("xl/worksheets/sheet") else part
        for name, part in parts.items()
    }


def dated(parts: dict[str, bytes]) -> None:
    """Set the times of the document's properties to the fixed one."""
    stamp = b"%04d-%02d-%02dT%02d:%02d:%02dZ" % EPOCH
    parts["docProps/core.xml"] = re.sub(rb"\d{4}-\d\d-\d\dT[\d:]+Z", stamp, parts["docProps/core.xml"])


def described(parts: dict[str, bytes], abouts: list[tuple[str, str]]) -> None:
    """Name each chart, and give it its alternative text."""
    titles = iter(abouts)
    for name, part in parts.items():
        if re.fullmatch(r"xl/drawings/drawing\d+\.xml", name):
            parts[name] = re.sub(rb'name="Chart \d+"', lambda _: description(*next(titles)), part)


def description(title: str, about: str) -> bytes:
    """Return the name and description attributes of a chart."""
    return f'name="{escape(title)}" descr="{escape(about)}"'.encode()


def shared(parts: dict[str, bytes]) -> None:
    """Move the texts of the cells into the table of shared strings."""
    numbers: dict[bytes, int] = {}
    count = 0

    def number(found: re.Match[bytes]) -> bytes:
        nonlocal count
        count += 1
        return b't="s"><v>%d</v>' % numbers.setdefault(found[1], len(numbers))

    for name, part in parts.items():
        if name.startswith("xl/worksheets/sheet"):
            parts[name] = INLINE.sub(number, part)
    texts = b"".join(b"<si>%s</si>" % text for text in numbers)
    parts[STRINGS] = b'<sst xmlns="%s" count="%d" uniqueCount="%d">%s</sst>' % (
        MAIN.encode(), count, len(numbers), texts,
    )  # fmt: skip
    for name, entry in (("[Content_Types].xml", STRINGS_TYPE), ("xl/_rels/workbook.xml.rels", STRINGS_LINK)):
        body, _, end = parts[name].rpartition(b"</")
        parts[name] = body + entry + b"</" + end


def ordered(styles: bytes) -> bytes:
    """Put the elements of each font into the order of the standard (ISO/IEC 29500-1, 18.8.22)."""
    ElementTree.register_namespace("", MAIN)
    tree = ElementTree.fromstring(styles)
    for font in tree.iter(f"{{{MAIN}}}font"):
        font[:] = sorted(font, key=lambda child: FONT_ORDER.index(child.tag.rpartition("}")[2]))
    return ElementTree.tostring(tree)
