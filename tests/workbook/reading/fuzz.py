"""Damaged workbooks, the same ones each time: a stream of mutations of a sound file.

    python tests/workbook/reading/fuzz.py BOOK.xlsx NUMBER DAMAGED.xlsx [SEED]

writes one of them, to look into what a failing test names by its number and, at night, its seed.
"""

import io
import random
import re
import sys
import zipfile
from pathlib import Path

HEAVY = 4_000_000  # bytes of a part that is blown up
TAG = re.compile(rb"<[^<>?!]+>")
ATTRIBUTE = re.compile(rb'([\w:]+)="([^"]*)"')
TEXT = re.compile(rb">([^<>]+)<")
NUMBER = re.compile(rb"-?\d+(?:\.\d+)?")
PAIR = re.compile(rb"<([\w:]+)(?: [^<>]*)?>[^<>]*</\1>|<[\w:]+(?: [^<>]*)?/>")
VALUES = [
    "", " ", "-1", "0", "1", "1.5", "1e308", "-1e-320", "1e999", "NaN", "INF", "99999999999999999999", "9" * 5000,
    "A1", "A0", "XFD1048576", "XFE1", "A1:XFD1048576", "A1048577", "ZZZZ9", "$A$1", "#REF!", "#N/A", "#DIV/0!",
    "=1+1", "=1/0", "=A1", "TRUE", "true", "null", "2026-01-31T12:00:00", "2026-13-41", "s", "e", "b", "d", "n", "str",
    "inlineStr", "shared", "array", "dataTable", "rId1", "rId999", "../../../etc/passwd", "/xl/worksheets/sheet1.xml",
    "http://localhost/x", "file:///etc/passwd", "[1]Sheet1!A1", "Motion!$A$1", "Nowhere!$A$1:$B$2", "&#0;", "&#x1F;",
    "&lol;", "\u202e", "\U0001f600", "\ufffe", "%s%n", "((((", "))))", '""""', "'", "!", "A" * 40_000,
]  # fmt: skip
FORMULAS = [
    "A1", "1/0", "SUM(A:A)", "SUM(1:1048576)", "SUM(A1:XFD1048576)", "INDEX(A1,9,9)", "NOSUCH(1)", "(" * 500, "@A1",
    "-" * 3000 + "1", "1" + "+1" * 3000, "(" * 300 + "1" + ")" * 300, "IF(" * 80 + "1" + ")" * 80, "9^9^9^9", "10^400",
    'REPT("x",1E6)', "[1]Other!A1", "Motion!A1#", "{1,2;3,4}", "A1 B1", "A1:A2:A3", '__import__("os")', '"unclosed',
    'HYPERLINK("http://x")', 'INDIRECT("A1")', "OFFSET(A1,1E9,0)", "FACT(1E3)", "1E309", "#REF!+1", "ROW()", "A1048577",
    "XFE1", "Nowhere!A1", "'", "", " ", "=", "1E", "SUM(", ",", "A1,A2", "TRUE", "x" * 8192, "LAMBDA(x,x)(1)",
]  # fmt: skip


def damaged(sound: bytes, number: int, seed: object = 0) -> bytes:
    """Return the damaged file of that number among those of a seed."""
    rng = random.Random(f"{seed or 2026}-{number}")
    if rng.random() < 0.4:
        return rng.choice(ON_FILES)(rng, sound)
    parts = unpack(sound)
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        rng.choices((on_part, rng.choice(ON_PARTS)), weights=(5, 1))[0](rng, parts)
    return pack(parts)


def without_charts(data: bytes) -> bytes:
    """Return a file without its drawings: openpyxl takes most of its time for them."""
    parts = [
        (name, part) for name, part in unpack(data) if not re.match("xl/(drawings|charts|worksheets/_rels)/", name)
    ]
    return pack(
        [
            (name, re.sub(rb"<drawing [^>]*>|<Override PartName=./xl/(drawings|charts)/[^>]*>", b"", part))
            for name, part in parts
        ]
    )


def unpack(data: bytes) -> list[tuple[str, bytes]]:
    """Return the parts of a file."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return [(name, archive.read(name)) for name in archive.namelist()]


def pack(parts: list[tuple[str, bytes]], method: int = zipfile.ZIP_STORED) -> bytes:
    """Return a file of these parts; duplicates stay duplicates."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", method) as archive:
        for name, data in parts:
            archive.NameToInfo.pop(name, None)  # else a duplicate is warned of
            packing = zipfile.ZIP_DEFLATED if len(data) > HEAVY else method
            archive.writestr(zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0)), data, packing, 1)
    return made.getvalue()


def splice(data: bytes, start: int, end: int, new: bytes) -> bytes:
    """Return ``data`` with a piece replaced."""
    return data[:start] + new + data[end:]


# of the file as bytes


def flip(rng, data):
    changed = bytearray(data)
    for _ in range(rng.choice((1, 1, 3, 30, 300))):
        changed[rng.randrange(len(changed))] ^= 1 << rng.randrange(8)
    return bytes(changed)


def flip_directory(rng, data):
    """Damage in the zip's table of contents: sizes, offsets, methods, flags, names."""
    changed = bytearray(data)
    start = data.find(b"PK\x01\x02")
    for _ in range(rng.choice((1, 2, 5))):
        changed[rng.randrange(start, len(changed))] = rng.randrange(256)
    return bytes(changed)


def truncate(rng, data):
    return data[: rng.randrange(len(data))]


def noise(rng, data):
    start = rng.choice((b"", b"PK\x03\x04", b"PK\x05\x06", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", b"<?xml", data[:400]))
    return start + rng.randbytes(rng.randrange(3000))


def overwrite(rng, data):
    start = rng.randrange(len(data))
    return splice(data, start, start + rng.randrange(1, 2000), rng.randbytes(rng.randrange(2000)))


def padded(rng, data):
    junk = rng.randbytes(rng.randrange(1, 5000))
    return junk + data if rng.random() < 0.5 else data + junk


# of the parts


def drop(rng, parts):
    del parts[rng.randrange(len(parts))]


def rename(rng, parts):
    i = rng.randrange(len(parts))
    name = parts[i][0]
    new = rng.choice(
        (
            name.upper(),
            "../" + name,
            "/" + name,
            name + "x",
            "a/" * 300 + "b",
            "C:\\x.xml",
            "xl/vbaProject.bin",
            "\u00fc",
        )
    )
    parts[i] = (new, parts[i][1])


def duplicate(rng, parts):
    parts.append(parts[rng.randrange(len(parts))])


def swap(rng, parts):
    i, j = rng.randrange(len(parts)), rng.randrange(len(parts))
    (a, x), (b, y) = parts[i], parts[j]
    parts[i], parts[j] = (a, y), (b, x)


def add(rng, parts):
    name = rng.choice((
        "xl/vbaProject.bin", "xl/externalLinks/externalLink1.xml", "xl/embeddings/a.xlsx", "xl/sharedStrings.xml",
        "xl/comments1.xml", "customXml/item1.xml", "docProps/custom.xml", "xl/connections.xml",
    ))  # fmt: skip
    parts.append((name, rng.choice((b"", b"<x/>", rng.randbytes(500), pack(parts[:3])))))


def bomb(rng, parts):
    i = rng.randrange(len(parts))
    fill = rng.choice((b"\0", b" ", b"<a>", b"<a/>", b"<c r='A1'/>"))
    parts[i] = (parts[i][0], splice(parts[i][1], 60, 60, fill * (rng.choice((1, 3)) * HEAVY // len(fill))))


# of the XML of one part


def on_part(rng, parts):
    """Change the XML of one part, mostly of those that the commands read."""
    read = [
        i for i, (name, _) in enumerate(parts) if re.match(r"xl/(worksheets/|workbook|styles|_rels)|\[|_rels", name)
    ]
    i = rng.choice(read) if read and rng.random() < 0.85 else rng.randrange(len(parts))
    parts[i] = (parts[i][0], rng.choice(ON_XML)(rng, parts[i][1]))


def somewhere(rng, pattern, data):
    """Return one match of a pattern, far into the data or not at all."""
    start = rng.randrange(len(data)) if data else 0
    return pattern.search(data, start) or pattern.search(data)


def value(rng):
    return rng.choice(VALUES).encode()


def change_attribute(rng, data):
    found = somewhere(rng, ATTRIBUTE, data)
    return splice(data, *found.span(2), value(rng)) if found else data


def drop_attribute(rng, data):
    found = somewhere(rng, ATTRIBUTE, data)
    return splice(data, *found.span(), b"") if found else data


def change_text(rng, data):
    found = somewhere(rng, TEXT, data)
    return splice(data, *found.span(1), value(rng)) if found else data


def change_formula(rng, data):
    found = somewhere(rng, re.compile(rb"<f>([^<>]+)</f>"), data)
    text = rng.choice(FORMULAS).replace("&", "&amp;").replace("<", "&lt;").encode()
    return splice(data, *found.span(1), text) if found else data


def change_cell(rng, data):
    """Another type and content in one cell: dates, errors, texts, truths, indices out of range."""
    found = somewhere(rng, re.compile(rb'<c r="(\w+)"[^<>]*>.*?</c>'), data)
    kind = rng.choice((b"s", b"b", b"d", b"e", b"n", b"str", b"inlineStr", b"zz"))
    cell = b'<c r="%s" t="%s"><v>%s</v></c>' % (found[1], kind, value(rng)) if found else b""
    return splice(data, *found.span(), cell) if found else data


def change_number(rng, data):
    found = somewhere(rng, NUMBER, data)
    new = rng.choice((b"0", b"-1", b"2", b"7", b"65536", b"1e400", b"123456789012", b"0.1", b"nan"))
    return splice(data, *found.span(), new) if found else data


def drop_element(rng, data):
    found = somewhere(rng, PAIR, data)
    return splice(data, *found.span(), b"") if found else data


def repeat_element(rng, data):
    found = somewhere(rng, PAIR, data)
    return splice(data, found.end(), found.end(), found[0] * rng.choice((1, 2, 1000))) if found else data


def drop_tag(rng, data):
    found = somewhere(rng, TAG, data)
    return splice(data, *found.span(), b"") if found else data


def entities(rng, data):
    head = rng.choice((
        b'<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">]>',
        b'<!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/passwd">]>',
        b'<!DOCTYPE x SYSTEM "http://localhost/x.dtd">',
        b'<!DOCTYPE x [<!ENTITY % a SYSTEM "http://localhost/x"> %a;]>',
    ))  # fmt: skip
    start = data.find(b"?>") + 2 if data.startswith(b"<?") else 0
    return data[:start] + head + data[start:]


def nest(rng, data):
    found = somewhere(rng, TAG, data)
    depth = rng.choice((50, 5000, 100_000))
    return splice(data, found.end(), found.end(), b"<a>" * depth + b"</a>" * depth) if found else data


def cut(rng, data):
    return data[: rng.randrange(len(data) + 1)]


def flip_xml(rng, data):
    return flip(rng, data) if data else data


def encode(rng, data):
    """Declare or use another encoding."""
    text = data.decode("utf-8", "replace")
    return rng.choice((
        lambda: text.encode("utf-16"),
        lambda: b"\xef\xbb\xbf" + data,
        lambda: b'<?xml version="1.0" encoding="no-such"?>' + data[data.find(b"?>") + 2 :],
        lambda: b'<?xml version="1.0" encoding="utf-7"?>' + data[data.find(b"?>") + 2 :],
        lambda: data.replace(b"=", b"\xff\xfe", 1),
    ))()  # fmt: skip


ON_FILES = (flip, flip, flip_directory, flip_directory, truncate, noise, overwrite, padded)
ON_PARTS = (drop, drop, rename, duplicate, swap, add, bomb)
ON_XML = (
    change_attribute, change_attribute, change_attribute, drop_attribute, change_text, change_formula, change_formula,
    change_cell, change_cell, change_number, change_number, drop_element, repeat_element, drop_tag, entities, nest, cut,
    flip_xml, encode,
)  # fmt: skip

if __name__ == "__main__":
    book, number, target, *seed = sys.argv[1:]
    Path(target).write_bytes(damaged(Path(book).read_bytes(), int(number), *seed))
