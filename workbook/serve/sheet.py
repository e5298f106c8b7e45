"""A design on one page to print: what it is, its figures, a table of its axes, its pictures, the checks that fail."""

from xml.etree.ElementTree import Element, tostring

from workbook.entries.machine import Machine
from workbook.errors import MotionbookError
from workbook.reports.html import Content, document, e, table
from workbook.serve.live import Shown, design, failing, pictures, results
from workbook.template import FOLDER

KNOWN = ("number", "revision", "author", "date")
"""what identifies a machine beside its title"""
LINES = 6
"""checks that fail, in sentences; more are counted"""
FIRST = 3
"""results in a line"""
DRAWN, FEWER, MANY = 4, 2, 12
"""charts below the table of axes, and how many where it is longer than this"""


def page(name: str, text: str) -> str:
    """Return the page of a description."""
    shown = design(name, text)
    machine: Machine = shown.machine
    known = [f"{word} {value}" for word in KNOWN if (value := getattr(machine, word))]
    lines = [": ".join(map(str, row)) for row in failing(shown)]
    more = [f"and {len(lines) - LINES} more"] if len(lines) > LINES else []
    word = e("span", "FAIL" if lines else "OK", css=f"verdict {'fails' if lines else 'agrees'}")
    whole, axes = figures(shown)
    first, *others = pictures(shown, None, [])
    below = others[: FEWER if len(shown.axes) > MANY else DRAWN]
    body = [
        e("h1", machine.title, " ", word),
        e("p", ", ".join([name, machine.template, *known]), css="quiet"),
        e("p", "Print this page by Ctrl+P; it is one page of A4.", css="quiet screen"),
        e("div", *(e("p", line) for line in (*lines[:LINES], *more))),
        e("div", whole, first, css="columns"), *axes, e("div", *below, css="pictures"),
    ]  # fmt: skip
    return document(machine.title, [e("div", *body, css="sheet")])


def figures(shown: Shown) -> tuple[Element, list[Element]]:
    """Return the results of the whole machine, and the table of those that each axis has, a row an axis."""
    whole: list[list[Content]] = []
    of: dict[str, dict[str, Content]] = {}
    for label, value, _, _, unit in results(shown, None):
        axis, parted, what = str(label).partition(": ")
        if parted:
            of.setdefault(axis, {})[f"{what} [{unit}]" if unit else what] = short(str(value))
        else:
            whole.append([label, short(str(value)), unit])
    names = list(dict.fromkeys(what for row in of.values() for what in row))
    rows = [[axis, *(row.get(what, "") for what in names)] for axis, row in of.items()]
    axes = [table(("Axis", *names), rows, range(1, len(names) + 1))] if rows else []
    return table(("Result", "", ""), whole, (1,)), axes


def short(value: str) -> str:
    """Return a number with four digits that count, and all before its point; another text as it is."""
    try:
        number = float(value)
    except ValueError:
        return value
    return f"{number:,.0f}" if abs(number) >= 1000.0 else f"{number:.4g}"


def in_short(name: str, text: str) -> str:
    """Return in a line the first results of a description, and how many checks fail."""
    try:
        shown = design(name, text)
    except MotionbookError as error:
        return str(error).partition("\n")[0]
    whole = [f"{label} {short(str(value))} {unit}".rstrip() for label, value, _, _, unit in results(shown, None)
             if ": " not in str(label)]  # fmt: skip
    fails = len(failing(shown))
    return "; ".join([*whole[:FIRST], f"{fails} checks FAIL" if fails else "all checks OK"])


def picture(template: str) -> str:
    """Return the first chart of a template's committed description as a picture of its own."""
    text = (FOLDER / f"{template}.toml").read_text(encoding="utf-8")
    return tostring(pictures(design(template, text), None, [])[0], encoding="unicode")
