"""The pages, from the templates beside: what is in the folder, a description to edit, what a command printed."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

from workbook.reports.html import document, rendered, shown

VERDICTS = {0: "agrees", 1: "disagrees", 2: "cannot be read", 3: "agrees; the design fails its checks"}


def page(title: str, template: str, *scripts: str, **values: Any) -> str:
    """Return a page with its scripts, and the script that shows when the server is at work."""
    given = {
        "title": title,
        "link": link,
        "address": address,
        "post": post,
        "choice": choice,
        "is_study": is_study,
    } | values
    tags = (f'<script src="/{script}.js" type="module"></script>' for script in ("busy", *scripts))
    return document(title, rendered(f"serve/{template}.html", **given) + "".join(tags))


def is_study(path: Path) -> bool:
    """Whether a file says what varies in a description, and is none itself."""
    return any(line.startswith("[[vary]]") for line in path.read_text(encoding="utf-8", errors="replace").splitlines())


def design_page(name: str, study: str, pick: str) -> str:
    """Return the page on which a description is designed, or a picked design of a study of it."""
    return rendered("serve/page/design.html", name=name, study=study, pick=pick)


def framed(report: str, *links: str) -> str:
    """Return a report of a command with links above it."""
    above = f'<p>{link("/", "All machines")}</p><div class="above">{"".join(links)}</div>'
    return report.replace("<body>", f"<body>{above}", 1)


def printed(title: str, words: str, verdict: str, *files: Path) -> str:
    """Return the page of what a command printed, and what can be done with the files of it."""
    return page(title, "printed", words=words, verdict=verdict, files=files)


def address(page: str, name: str) -> str:
    """Return the address of a page of a file, whatever the file is called."""
    return f"/{page}/{quote(name, safe='')}"


def link(href: str, words: str) -> str:
    """Return a link with room behind it."""
    return f'<span><a href="{shown(href)}">{shown(words)}</a> </span>'


def post(action: str, name: str, words: str) -> str:
    """Return a button that does something with a file."""
    sent = f'<input type="hidden" name="name" value="{shown(name)}"><button type="submit">{words}</button>'
    return f'<form action="{action}" method="post">{sent}</form>'


def choice(name: str, values: Sequence[str], key: str = "") -> str:
    """Return a field for a choice of texts; ``key`` is its own in the page, the name by default."""
    options = (f'<option value="{shown(value)}">{shown(value)}</option>' for value in values)
    return f'<select name="{name}" id="{key or name}">{"".join(options)}</select>'
