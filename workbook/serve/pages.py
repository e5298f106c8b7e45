"""The pages, from the templates beside: a bar above each, forms and links, what a command printed."""

import re
import tomllib
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from datetime import datetime
from functools import lru_cache
from html import unescape
from io import BytesIO
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple
from urllib.parse import quote

from workbook.reading.files import BUILT
from workbook.reports.html import document, render, shown

TITLE = re.compile(r"<dc:title>([^<]*)</dc:title>")
CORE, AS_BUILT = "docProps/core.xml", f">{BUILT:%Y-%m-%dT%H:%M:%SZ}</dcterms:modified>"
LONGEST = 1_000_000  # bytes that are read of a file for its title
VERDICTS = {0: "agrees", 1: "disagrees", 2: "cannot be read", 3: "agrees; the design fails its checks"}


class Item(NamedTuple):
    """A file of the folder: when it was changed, its title, the description that a study is of."""

    path: Path
    time: str
    title: str
    base: str


def page(title: str, template: str, do: Sequence[str] = (), at_home: bool = False, **values: Any) -> str:
    """Return a page; ``do`` are links and buttons of the bar above it, which leads home but ``at_home``."""
    return document(title, f"serve/{template}.html", bar(*do, at_home=at_home), **values)


def bar(*do: str, at_home: bool = False) -> str:
    """Return the bar above a page: the way to the first page, and what can be done."""
    return render("serve/bar.html", do="".join(do), at_home=at_home)


def item(path: Path) -> Item:
    """Return a file as the first page lists it."""
    about = path.stat()
    title, base = known_of(path, about.st_mtime_ns, about.st_size)
    return Item(path, f"{datetime.fromtimestamp(about.st_mtime):%Y-%m-%d %H:%M}", title, base)


@lru_cache(1000)
def known_of(path: Path, changed: int, size: int) -> tuple[str, str]:
    """Return the title of a file, and of a study the description that it is of; ``changed`` tells its versions."""
    with suppress(OSError, ValueError, KeyError, zipfile.BadZipFile, NotImplementedError):
        if path.suffix.lower() != ".toml":
            with zipfile.ZipFile(path) as file, file.open(CORE) as properties:
                title = TITLE.search(properties.read(LONGEST).decode(errors="replace"))
            return unescape(title[1]) if title else path.stem, ""
        if size < LONGEST:
            data = tomllib.loads(path.read_text(encoding="utf-8-sig"))
            return str(data.get("title") or path.stem), str(data.get("base", path.stem)) if "vary" in data else ""
    return path.stem, ""


def was_saved(book: bytes) -> bool:
    """Whether a program has saved a workbook since it was built, so that it may hold what no description has."""
    with zipfile.ZipFile(BytesIO(book)) as file:
        return AS_BUILT.encode() not in file.read(CORE)


def with_bar(report: str, *do: str, design: str = "") -> str:
    """Return a report of a command below the bar; what it tells of entries leads to the design's."""
    return report.replace("<body>", f'<body data-design="{shown(design)}">{bar(*do)}', 1)


def printout(title: str, words: str, verdict: str, *files: Path) -> str:
    """Return the page of what a command printed, and what can be done with the files of it."""
    return page(title, "printed", words=words, verdict=verdict, files=files)


def address(page: str, name: str) -> str:
    """Return the address of a page of a file, whatever the file is called."""
    return f"/{page}/{quote(name, safe='')}"


def link(href: str, words: str) -> str:
    """Return a link that looks as a button does."""
    return f'<a class="button" href="{shown(href)}">{shown(words)}</a>'


def post(action: str, name: str, words: str) -> str:
    """Return a button that does something with a file."""
    sent = f'<input type="hidden" name="name" value="{shown(name)}"><button type="submit">{words}</button>'
    return f'<form action="{action}" method="post">{sent}</form>'


def choice(name: str, values: Iterable[str], key: str = "", words: Mapping[str, str] = MappingProxyType({})) -> str:
    """Return a field for a choice of texts, shown in ``words``; ``key`` is its own in the page, the name by default."""
    options = (f'<option value="{shown(value)}">{shown(words.get(value, value))}</option>' for value in values)
    return f'<select name="{name}" id="{key or name}">{"".join(options)}</select>'
