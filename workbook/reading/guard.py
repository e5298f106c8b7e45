"""Limits on a workbook's contents: each part is unpacked under a limit and read once, before all else."""

import zipfile
import zlib
from collections import Counter
from copy import copy
from pathlib import Path
from typing import IO, NamedTuple
from xml.etree.ElementTree import Element

from workbook.errors import ReadError
from workbook.reading.package import DRAWING, NOTHING, Anchor, Package, without_cached_points
from workbook.reading.rows import SAVE_AS, Mendable, Refusal, Rows, Totals, short, tag
from workbook.reading.scan import Scan

MEGABYTE = 1_000_000
MOST_PACKED = 60 * MEGABYTE  # of the file
MOST_UNPACKED = 400 * MEGABYTE  # of all parts
MOST_PARTS = 3_000
MOST_RATIO = 200  # of a part above one megabyte; Excel's own stay below 50
OLE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
LOCKED = "cannot be read; close it in the other program and try again"
PROPERTIES = "docProps/app.xml"
# kinds of file by a part that only they have
XLSB = "a binary workbook (.xlsb)"
OTHER_KINDS = {"content.xml": "an OpenDocument file", "xl/workbook.bin": XLSB}
# of drawings besides charts (ISO/IEC 29500-1, 20.5.2)
DRAWN = {"pic": "pictures", "sp": "shapes and text boxes"}
NOTES = {
    "xl/vbaProject.bin": "holds macros; they were neither read nor run",
    "xl/externalLinks/": "links to other workbooks; the links were not followed",
    "xl/connections.xml": "holds data connections; they were not opened",
    "xl/embeddings/": "holds embedded files; they were not opened",
}
# how zipfile and zlib refuse an archive
DAMAGE = (zipfile.BadZipFile, zlib.error, EOFError, OSError, NotImplementedError, ValueError)
# the parts of a save, by name, size and the checksum that the zip has of each
Scans = dict[tuple[str, int, int], Scan]


class Inspected(NamedTuple):
    """Facts about a file before it is parsed."""

    notes: list[str]  # what an engineer should know of it
    sheets: dict[str, Rows]  # the rows of each sheet, by its title
    pages: dict[str, Element]  # all of a sheet but its rows
    parts: dict[str, Element]  # the same by the names of their parts
    strings: Element  # the part with the texts that several cells share
    drawings: dict[str, list[Anchor]]  # of each sheet
    drawn: dict[str, int]  # how much drawings hold besides charts
    book: Element  # the workbook's own part
    program: str  # that says to have saved the file (ISO/IEC 29500-1, 22.2.2.1)


NOT_INSPECTED = Inspected([], {}, {}, {}, NOTHING, {}, {}, NOTHING, "")


def guard(path: Path, known: Scans | None = None) -> Inspected:
    """Check a file before it is parsed; raise ReadError where it is no zip of XML, too large, or has two readings.

    ``known`` are parts that were read of an earlier save: those that are the same are not read again.
    """
    try:
        with path.open("rb") as file:
            return inspect(file, path.stat().st_size, known)
    except Refusal as refusal:
        raise ReadError(f"{path}: {refusal}") from None
    except PermissionError as error:
        raise ReadError(f"{path}: {LOCKED}") from error
    except DAMAGE as error:
        message = str(error)[:120] or type(error).__name__
        raise ReadError(f"{path}: damaged: {message}; expected a workbook; {SAVE_AS}") from error


def inspect(file: IO[bytes], size: int, known: Scans | None = None) -> Inspected:
    """Check an open file; raise Refusal for what cannot be a workbook of this kind."""
    if size > MOST_PACKED:
        raise Refusal(f"{size:,} bytes; a workbook of at most {MOST_PACKED:,} bytes is expected")
    refuse_other_kinds(file)
    with zipfile.ZipFile(file) as archive:
        infos = archive.infolist()
        refuse_odd_parts(infos, size)
        scans = scan_parts(archive, infos, known)
    names = [info.filename for info in infos]
    roots = {name: scan.root for name, scan in scans.items()}
    package = Package(roots, names)
    drawn = Counter(tag(e) for name, root in roots.items() if DRAWING.fullmatch(name) for e in root.iter())
    titled = package.sheets.items()
    return Inspected(
        [note for start, note in NOTES.items() if any(name.startswith(start) for name in names)],
        {title: rows_of(scans.get(part), title) for title, part in titled},
        {title: roots[part] for title, part in titled},
        {part: roots[part] for _, part in titled},
        roots.get(package.strings, Element("sst")),
        {title: package.drawing_anchors(part) for title, part in titled},
        {what: drawn[name] for name, what in DRAWN.items()},
        roots[package.main],
        roots.get(PROPERTIES, Element("Properties")).findtext("{*}Application", ""),
    )


def rows_of(scan: Scan | None, title: str) -> Rows:
    """Return the rows of a sheet; raise Refusal where its part is no worksheet."""
    if scan is None or scan.rows is None:
        raise Mendable(f"its sheet {short(title)} is no worksheet")
    return scan.rows


def scan_parts(archive: zipfile.ZipFile, infos: list[zipfile.ZipInfo], known: Scans | None) -> dict[str, Scan]:
    """Read every part once that is XML, or may be read as such; return what was read by name."""
    count, scans, latest = Totals(), dict[str, Scan](), Scans()
    for info in infos:
        key = info.filename, info.file_size, info.CRC
        if known and key in known:
            scans[info.filename] = latest[key] = known[key]
            continue
        data = unpack(archive, info)
        start = data[:200].lstrip(b"\xef\xbb\xbf\xff\xfe\0 \t\r\n")
        if not (start.startswith(b"<") or info.filename.lower().endswith((".xml", ".rels"))):
            continue  # no XML, nor to be read as such: relations may call any part a sheet, whatever its name
        scans[info.filename] = Scan(info.filename, count)
        scans[info.filename].read(without_cached_points(info.filename, data))
        latest[key] = scans[info.filename]
    if known is not None:
        known.clear()
        known |= latest
    return scans


def refuse_other_kinds(file: IO[bytes]) -> None:
    """Name the kinds of file that are taken for an .xlsx; leave the file at its start."""
    data = file.read(512)
    if data.startswith(OLE):
        data += file.read(MEGABYTE)
        # the end, where the directory of an OLE container mostly lies
        file.seek(max(0, file.seek(0, 2) - MEGABYTE))
        if "EncryptedPackage".encode("utf-16-le") in data + file.read():
            how = "Excel: File > Info > Protect Workbook"
            raise Refusal(f"protected by a password; remove the password ({how})")
        raise Mendable("an old .xls workbook")
    if not data:
        raise Refusal("empty; expected a workbook")
    if not data.startswith(b"PK"):
        is_text = data.isascii() and b"\0" not in data
        raise Mendable("text, such as CSV or HTML" if is_text else "not a workbook, or damaged")
    file.seek(0)


def refuse_odd_parts(parts: list[zipfile.ZipInfo], size: int) -> None:
    """Refuse a table of contents that no spreadsheet program writes, in a file of ``size`` bytes."""
    if len(parts) > MOST_PARTS:
        raise Refusal(f"{len(parts):,} parts; at most {MOST_PARTS:,} are expected")
    names = [part.filename for part in parts]
    if other := next((kind for part, kind in OTHER_KINDS.items() if part in names), None):
        raise Mendable(f"{other}")
    if "[Content_Types].xml" not in names:
        raise Mendable("a zip, but not a workbook: it has no [Content_Types].xml")
    name, times = Counter(map(str.lower, names)).most_common(1)[0]
    if times > 1:
        raise Refusal(f"holds {short(name)} {times} times; each part is expected once")
    for part in parts:
        refuse_odd_part(part)
    sizes = [(part.header_offset, part.compress_size, part.file_size) for part in parts]
    offsets, packed, unpacked = zip(*sizes, strict=True)
    if min(offsets):  # zipfile moves every offset, others read what stands before
        begin = "has something before its first part: another zip"
        raise Mendable(f"{begin}, which programs may read instead")
    if sum(packed) > size:
        raise Refusal("its parts overlap, as in a zip bomb")
    if sum(unpacked) > MOST_UNPACKED:
        most = f"{MOST_UNPACKED:,} bytes, the most that is expected of a workbook"
        raise Refusal(f"unpacks to more than {most}")


def refuse_odd_part(part: zipfile.ZipInfo) -> None:
    """Refuse a part whose name no spreadsheet program writes, and one that is encrypted."""
    named = f"holds a part named {short(part.filename)}"
    if part.filename.startswith("/") or any(c in part.filename for c in ("\\", ":", "\0")):
        raise Refusal(f"{named}, which no spreadsheet program writes")
    if ".." in part.filename.split("/"):
        raise Refusal(f"{named}, which leads out of the workbook")
    if part.flag_bits & 1:
        raise Refusal("a zip protected by a password; remove the password")


def unpack(archive: zipfile.ZipFile, part: zipfile.ZipInfo) -> bytes:
    """Return a part whole; raise Refusal where it is larger than the table of contents says."""
    name = short(part.filename)
    if part.file_size > MEGABYTE and part.file_size > MOST_RATIO * part.compress_size:
        raise Refusal(f"{name} unpacks to more than {MOST_RATIO} times its size, as in a zip bomb")
    real = copy(part)
    real.file_size = MOST_UNPACKED  # zipfile cuts a part off at its declared size, and only then unpacks no further
    data = bytearray()
    with archive.open(real) as stream:
        while len(data) <= part.file_size and (chunk := stream.read(65_536)):
            data += chunk
    if len(data) != part.file_size:
        raise Mendable(f"{name} does not have the size that the zip declares")
    return bytes(data)
