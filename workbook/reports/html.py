"""Elements of a page of HTML, and its style: no script, nothing fetched from elsewhere."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from xml.etree.ElementTree import Element, tostring

from workbook.visible import visible

STYLE = """
:root { color-scheme: light; }
body { font: 10.5pt/1.45 "Segoe UI", "Helvetica Neue", Arial, sans-serif; color: #1a1a1a; background: #fff;
  max-width: 62rem; margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.55rem; margin: 0 0 .3rem; }
h2 { font-size: 1.15rem; margin: 2.6rem 0 .6rem; padding-top: .9rem; border-top: 2px solid #1f3a5f; }
h3 { font-size: 1rem; margin: 1.5rem 0 .4rem; }
h1, h2, h3 { color: #1f3a5f; overflow-wrap: anywhere; }
p { margin: .4rem 0; max-width: 48rem; }
table { border-collapse: collapse; width: 100%; margin: .4rem 0; }
th, td { text-align: left; vertical-align: top; padding: .25rem .6rem .25rem 0; border-bottom: 1px solid #d5dae1;
  overflow-wrap: break-word; }
thead th { border-bottom: 1.5px solid #1f3a5f; font-weight: 600; white-space: nowrap; }
table.facts { width: auto; } table.facts th { font-weight: 600; white-space: nowrap; padding-right: 1.5rem; }
td { font-variant-numeric: tabular-nums; } .kind { white-space: nowrap; }
a, .value { overflow-wrap: anywhere; }
th.number, td.number { text-align: right; white-space: nowrap; padding-right: 1.4rem; }
div.wide { overflow-x: auto; } table.wide td { white-space: nowrap; }
table.wide thead th { white-space: normal; vertical-align: bottom; max-width: 9rem; }
code, .cell { font-family: Consolas, "DejaVu Sans Mono", monospace; font-size: .92em; }
.verdict { display: inline-block; font-weight: 600; padding: .1rem .6rem; border: 1.5px solid; border-radius: 3px; }
.agrees { color: #14612f; } .disagrees, .unreadable, .fails { color: #a31515; } .not-ours { color: #555; }
.quiet { color: #555; font-size: .92em; }
body:has(#live) { max-width: 112rem; }
.beside { display: grid; grid-template-columns: minmax(30rem, 2fr) 3fr; gap: 2rem; align-items: start; }
.beside textarea { box-sizing: border-box; width: 100%; font: 10pt/1.4 Consolas, "DejaVu Sans Mono", monospace; }
.left { position: sticky; top: 0; height: calc(100vh - 8rem); display: flex; flex-direction: column; }
.beside textarea { height: 34vh; white-space: pre; } #live h2 { margin-top: 1rem; }
#form { flex: 1; overflow: auto; border-bottom: 1px solid #d5dae1; }
#form .wide td:last-child { position: sticky; right: 0; background: #fff; white-space: nowrap; }
#form h3, #form h4 { margin: .8rem 0 .2rem; } #form td, #form th { padding-right: .3rem; }
.edge { fill: #fff; stroke: #1f3a5f; stroke-width: 2; cursor: ew-resize; } .edge:focus { fill: #1f3a5f; outline: none; }
.lane { cursor: ew-resize; } .lane:focus { font-weight: 700; outline: none; }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: .8rem; margin: 1.2rem 0; }
@media (max-width: 1200px) { .pictures { grid-template-columns: 1fr; } }
button { margin: 0 .3rem; } .busy::after { content: " … at work"; } td form, .above form { display: inline; }
.entry label:first-child { display: inline-block; min-width: 15rem; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr)); gap: 1rem; }
.gallery img { max-width: 100%; }
.sheet { font-size: 8pt; } .sheet h1 { font-size: 1.4rem; } .columns { display: grid; grid-template-columns: 2fr 3fr; }
.sheet td, .sheet th { padding: .1rem .3rem .1rem 0; white-space: normal; }
.sheet svg { max-height: 44mm; width: 100%; } .sheet .columns svg { max-height: 56mm; }
@media print {
  @page { size: A4; margin: 12mm 14mm; } .screen { display: none; } .pictures { grid-template-columns: 1fr 1fr; }
  body { font-size: 9pt; margin: 0; padding: 0; max-width: none; }
  h2, h3, thead { break-after: avoid; } thead { display: table-header-group; } tr { break-inside: avoid; }
  a { color: inherit; text-decoration: none; }
}
"""
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
