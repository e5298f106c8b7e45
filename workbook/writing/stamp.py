"""The stamp of a verified book: the fingerprint of its entries, written into its cell, and nothing else of the file."""

import re
from pathlib import Path
from zipfile import ZIP_DEFLATED

from workbook.book.address import Address
from workbook.book.declare import Book
from workbook.book.stamp import NAME, SAME, SENTENCE, fingerprint
from workbook.errors import WriteError
from workbook.reading.files import BookFile
from workbook.writing import archive
from workbook.writing.archive import value_xml
from workbook.writing.output_files import replace

CELL = rb'<(?P<name>(?:\w+:)?c)(?=[^>]*\sr="%s")(?P<looks>[^>]*?)(?:/>|>(?P<held>.*?)</(?P=name)>)'
FORMULA = re.compile(rb"<(\w+:)?f\b.*?(/>|</\1?f>)", re.DOTALL)
KIND = re.compile(rb'\st="\w*"')


def write_stamp(file: BookFile, declared: Book, path: Path, overwrite: bool) -> None:
    """Write a book that was verified, as ``declared``, with the stamp of its entries, to its own or another ``path``.

    Raises WriteError for a book without a cell for the stamp, an unfinished design, or a file that is there or cannot
    be written.
    """
    today, parts = fingerprint(declared), archive.unzipped(file.path.read_bytes())
    if today is None:
        raise WriteError(f"{file.path}: the design is unfinished; expected all that its results need")
    values: dict[str, float | str] = {NAME: today, SENTENCE: SAME}
    for name, value in values.items():
        place, held = file.places.get(name), file.inspected
        page = held.pages.get(place.sheet) if place else None
        part = next((n for n in parts if page is not None and held.parts.get(n) is page), "")
        changed = with_value(parts[part], place.cell(0, 0), value) if place and part else None
        if changed is None:
            raise WriteError(f"{file.path}: it has no cell {name}; motionbook regenerate builds it anew, with this")
        parts[part] = changed
    replace(path, lambda draft: draft.write_bytes(archive.zipped(parts, ZIP_DEFLATED)), overwrite)


def with_value(part: bytes, at: Address, value: float | str) -> bytes | None:
    """Return the part of a sheet with another value in a cell, which keeps its looks and formula; None without it."""
    cell = re.search(CELL % at.a1.encode(), part, re.DOTALL)
    if cell is None:
        return None
    name, looks, formula = cell["name"], KIND.sub(b"", cell["looks"]), FORMULA.search(cell["held"] or b"")
    kind, known = (text.encode() for text in value_xml(value))
    known = known.replace(b"<v", b"<" + name[:-1] + b"v").replace(b"</v", b"</" + name[:-1] + b"v")
    written = b"<%s%s%s>%s%s</%s>" % (name, looks, kind, formula[0] if formula else b"", known, name)
    return part[: cell.start()] + written + part[cell.end() :]
