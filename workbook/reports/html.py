"""Elements of a page of HTML, and its style: no script, nothing fetched from elsewhere."""

from collections.abc import Iterable, Sequence
from pathlib import Path
from xml.etree.ElementTree import Element, tostring

from workbook.visible import visible

STYLE = "\n" + Path(__file__).with_name("page.css").read_text(encoding="utf-8")
Content = Element | str


def document(title: str, body: Sequence[Element]) -> str:
    """Return a page of HTML."""
    head = e("head", e("meta", charset="utf-8"), e("title", title), e("style", STYLE),
             e("meta", name="viewport", content="width=device-width, initial-scale=1"))  # fmt: skip
    html = e("html", head, e("body", *body), lang="en")
    return f"<!DOCTYPE html>\n{markup(html)}\n"


def table(headings: Sequence[Content], rows: Iterable[Sequence[Content]], numbers: Sequence[int]) -> Element:
    """Return a table whose columns ``numbers`` stand to the right."""
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
