"""Each attribute of each part of a workbook, changed: empty, a text, nan, infinite, negative, huge, gone."""

import re
from typing import NamedTuple

from tests.workbook.reading.fuzz import ATTRIBUTE, splice

KINDS = {"empty": b"", "text": b"50%", "nan": b"nan", "infinite": b"inf", "negative": b"-1", "huge": b"99999999999",
         "undefined": b"2000", "missing": None}  # fmt: skip
TAG = re.compile(rb"<(/?)([\w:]+)([^<>]*?)(/?)>")
KEPT = re.compile(r"xmlns|.*:schemaLocation|.*Ignorable")  # not an attribute, or of no reader's concern


class Place(NamedTuple):
    """An attribute in a part: its element by the names of those around it, and the bytes of ``name="value"``."""

    part: str
    element: str
    name: str
    begin: int
    end: int


def places(parts):
    """The attributes of a file, one of each element of each kind of part, the first."""
    known = {}
    for part, data in parts:
        kind, path = re.sub("[0-9]+", "", part), []
        for tag in TAG.finditer(data) if part.endswith((".xml", ".rels")) else ():
            if tag[1]:
                path.pop()
                continue
            path.append(tag[2].decode())
            for attribute in ATTRIBUTE.finditer(data, *tag.span(3)):
                name = attribute[1].decode()
                if not KEPT.match(name):
                    at = kind, tuple(path), name
                    known.setdefault(at, Place(part, "/".join(path), name, *attribute.span()))
            if tag[4]:
                path.pop()
    return list(known.values())


def changed(parts, place, kind):
    """The parts of a file with an attribute of another kind."""
    value = KINDS[kind]
    written = b"" if value is None else b'%s="%s"' % (place.name.encode(), value)
    return [(name, splice(data, place.begin, place.end, written) if name == place.part else data)
            for name, data in parts]  # fmt: skip
