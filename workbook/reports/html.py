"""Elements of a page of HTML, and its style: no script, nothing fetched from elsewhere."""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element, tostring

from tornado.escape import xhtml_escape
from tornado.template import Loader

from workbook.visible import visible

STYLE = "\n" + Path(__file__).with_name("page.css").read_text(encoding="utf-8")
Content = Element | str


def document(title: str, body: Sequence[Element] | str) -> str:
    """Return a page of HTML."""
    inside = body if isinstance(body, str) else markup(*body)
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{shown(title)}</title><style>{STYLE}</style>\
<meta name="viewport" content="width=device-width, initial-scale=1"></head><body>{inside}</body></html>
"""


def rendered(template: str, /, **values: Any) -> str:
    """Return what a template beside the modules, such as ``reports/page.html``, comes to; its texts are escaped."""
    return PAGES.load(template).generate(**values).decode()


def shown(text: str | bytes) -> str:
    """Return a text as HTML."""
    return xhtml_escape(legal(text if isinstance(text, str) else text.decode()))


def held(text: str | bytes) -> bytes:
    """Return a text as Tornado's templates hold it, also halves of characters."""
    return text if isinstance(text, bytes) else text.encode(errors="backslashreplace")


def table(headings: Sequence[Content], rows: Iterable[Sequence[Content]], numbers: Sequence[int]) -> Element:
    """Return a table whose columns ``numbers`` stand to the right; in a template it is HTML."""
    css = ["number" if i in numbers else "" for i in range(len(headings))]
    head = e("tr", *(e("th", text, css=c, scope="col") for text, c in zip(headings, css, strict=True)))
    body = [e("tr", *(e("td", text, css=c) for text, c in zip(row, css, strict=True))) for row in rows]
    return e("table", e("thead", head), e("tbody", *body))


def e(tag: str, *children: Content, css: str = "", **attributes: str) -> Element:
    """Return an element; texts are escaped when it is written, and made fit for XML here."""
    element = Element(tag, {**({"class": css} if css else {}), **{k: legal(v) for k, v in attributes.items()}})
    for child in children:
        if isinstance(child, Element):
            element.append(child)
        elif len(element):
            element[-1].tail = (element[-1].tail or "") + legal(child)
        else:
            element.text = (element.text or "") + legal(child)
    return element


def markup(*elements: Element) -> str:
    """Return elements as HTML."""
    return "".join(tostring(one, encoding="unicode", method="html") for one in elements)


def legal(text: str) -> str:
    """Return a text with a visible escape for each character that neither XML nor a file in UTF-8 can hold."""
    return visible(text, kept="\t\n")


PAGES = Loader(str(Path(__file__).parents[1]), autoescape="shown", namespace={
    "shown": shown, "table": lambda *parts: markup(table(*parts)), "_tt_utf8": held,
})  # fmt: skip
