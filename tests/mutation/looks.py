"""Faults in what a workbook shows: formats, units, labels, charts; with formulon as the oracle of what a user reads."""

import io
import random
import re
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import formulon
import openpyxl
from openpyxl import Workbook

from tests.mutation.bench import smaller
from tests.workbook.composed import committed_as
from workbook.book.address import Address
from workbook.build import build
from workbook.errors import ReadError
from workbook.judging.matching import Match, Pair
from workbook.judging.report import Report
from workbook.judging.verify import check_display, verify
from workbook.reading.files import open_book
from workbook.writing.archive import unzipped, zipped

TASTE = (
    "General", "0", "0.000", "#,##0.00", "0.00E+00", "##0.0E+0", "0.0_);(0.0)", "+0.00;-0.00", "[Red]0.0", '"ca. "0.0',
)  # fmt: skip
MISLEADING = (
    '0.0"0"', '"1"0.0', "0.0,", "0,,", ";;;", '"OK";"OK"', '""', "0.0;0.0", "0.0\\5", '0.0" k"', "0\\.0", "0.0%%",
    '[>=0]"7";0.0', '"-"0.0', "#", "0.0;;0.0", '0.0;-0.0;"7"',
)  # fmt: skip
"""at some values: two zeros more behind a point are none"""
NUMBER = re.compile(
    r"(?P<before>\D*?)(?P<digits>[0-9][0-9,]*(?:\.[0-9]*)?|\.[0-9]+)(?P<power>E[+-][0-9]+)?(?P<rest>\D*)"
)
ALIKE = {"1/min", "rpm"}  # units of one meaning
WORDS = frozenset({"", "ca.", "+", ")", "(", "+("})


class Looks:
    """A small book as built, whose looks are changed in a copy."""

    def __init__(self, name: str, folder: Path) -> None:
        template, machine = committed_as(name)
        machine = smaller(machine, cycle=12, law=4)
        self.model, self.template, self.path = type(machine), template, folder / f"{template.name}.xlsx"
        build(machine, self.path)
        self.declared = template.declare(machine)
        self.pairs = {pair.address: pair for pair in Match(open_book(self.path), self.declared).pairs}

    def opened(self) -> Workbook:
        """Return a copy to be changed."""
        return openpyxl.load_workbook(self.path)

    def said(self, changed: Workbook) -> set[str]:
        """Return the cells at which ``verify`` finds that something else is shown."""
        path, report = self.path.with_name("looks.xlsx"), Report(self.path, self.template.name)
        changed.save(path)
        check_display(Match(open_book(path), self.declared), self.model, {}, report)
        return {f"{f.sheet}!{f.cell}" for f in report.findings}

    def numbers(self) -> list[Pair]:
        """Return the declared cells that hold numbers."""
        return [p for p in self.pairs.values() if type(value_of(p)) in (int, float)]


def value_of(pair: Pair) -> Any:
    """Return what a cell should show."""
    return pair.cell.expected if pair.declared_formula else pair.held


class Oracle:
    """A changed book as formulon shows it."""

    def __init__(self, changed: Workbook) -> None:
        content = io.BytesIO()
        changed.save(content)
        self.book = formulon.Workbook.load(content.getvalue())
        self.book.recalc()
        self.sheets = {self.book.sheet_name(n): n for n in range(self.book.sheet_count())}

    def text(self, at: Address) -> str:
        """Return what a cell shows."""
        text, _ = self.book.get_display_text(self.sheets[at.sheet], at.row - 1, at.column - 1)
        return str(text)

    def charts(self, sheet: str) -> list[str]:
        """Return the figures that each chart of a sheet draws, in words that can be compared."""
        number, kind = self.sheets[sheet], formulon.DrawingObjectKind.CHART
        objects = [o for o in self.book.list_drawing_objects(number) if o.kind == kind]
        drawn = [(self.book.get_chart_data(number, o.object_id), self.book.get_chart(number, o.object_id).axes)
                 for o in objects]  # fmt: skip
        return [f"{data} {[(axis.min, axis.max) for axis in axes]}" for data, axes in drawn]


def reads_back(text: str, value: float, unit: str) -> bool:
    """Whether a displayed text reads as a value, to its last digit, with nothing else than its unit beside it."""
    found = NUMBER.fullmatch(text.strip())
    if found is None:
        return False
    digits = found["digits"].replace(",", "")
    number = float(digits + (found["power"] or "")) * (-1 if set(found["before"]) & set("-−(") else 1)
    last = 0.5 * 10.0 ** -len(digits.partition(".")[2]) * 10.0 ** int((found["power"] or "E0")[1:])
    beside = {found["before"].strip(" -−"), found["rest"].strip(" %")}
    percent = 100 if "%" in found["rest"] else 1
    near = abs(number - value * percent) <= 1.001 * last + 1e-12 * abs(value) + 1e-12  # rounding shows in a zero
    return near and beside <= WORDS | {unit}


def formatted(looks: Looks, changed: Workbook, count: int, seed: int | str) -> list[tuple[Pair, str]]:
    """Give some cells other number formats; return them. Alike faults of a sheet are one finding, so each is one."""
    drawn = random.Random(seed)
    columns: dict[tuple[str, str], list[Pair]] = {}
    for pair in looks.numbers():
        columns.setdefault((pair.cell.block.name, pair.cell.quantity.name), []).append(pair)
    chosen = [drawn.choice(pairs) for pairs in drawn.sample(list(columns.values()), count)]
    faults = {}
    for pair in chosen:
        code, cell = drawn.choice(TASTE + MISLEADING), changed[pair.address.sheet][pair.address.a1]
        if faults.setdefault((pair.address.sheet, cell.number_format, code), (pair, code))[0] is pair:
            cell.number_format = code
    return list(faults.values())


def exchanged(looks: Looks, changed: Workbook, style: str, seed: int | str) -> set[str]:
    """Exchange texts of a style within a sheet, two and two; return the cells that say something else now."""
    drawn, cells = random.Random(seed), set()
    for sheet in looks.declared.sheets:
        rows = {block.row for block in sheet.blocks if not block.is_table}
        texts = [t for t in sheet.texts if t.style == style and t.text and t.row in rows and not t.link]
        counted = [t for t in texts if t.column in range(2, 6)]
        drawn.shuffle(counted)
        exchanges = set()  # alike ones are one finding
        for one, other in list(pairwise(counted))[::2][:2]:
            words = frozenset({one.text, other.text})
            if len(words) == 2 and words != ALIKE and words not in exchanges:
                exchanges.add(words)
                first, second = (changed[sheet.title].cell(t.row, t.column) for t in (one, other))
                first.value, second.value = second.value, first.value
                cells |= {f"{sheet.title}!{c.coordinate}" for c in (first, second)}
    return cells


def redrawn(changed: Workbook, seed: int | str) -> Iterator[tuple[str, int, str]]:
    """Change every second chart; yield sheet, number of the chart and its corner."""
    drawn = random.Random(seed)
    for sheet in changed.worksheets:
        for n, chart in enumerate(getattr(sheet, "_charts")):  # noqa: B009 - the stubs hide it
            if n % 2:
                continue
            start = chart.anchor._from
            change_chart(chart, drawn)
            yield sheet.title, n, f"{sheet.title}!{sheet.cell(start.row + 1, start.col + 1).coordinate}"


def change_chart(chart: Any, drawn: random.Random) -> None:
    """Let one line of a chart end elsewhere, draw another column, or an axis end elsewhere."""
    series = drawn.choice(chart.series)
    source = drawn.choice((series.xVal.numRef, series.yVal.numRef))
    kind = drawn.choice(("end", "column", "limit"))
    if kind == "limit":
        chart.x_axis.scaling.min, chart.x_axis.scaling.max = 0.4321, 0.5432
    elif kind == "end" and ":" in source.f:
        source.f = re.sub(r"\d+$", lambda row: str(int(row[0]) - 1), source.f)
    else:
        source.f = re.sub(r"\$([A-Z]+)\$(\d+)", lambda cell: f"$A${cell[2]}", source.f)


def settings(changed: Workbook) -> Iterator[str]:
    """Change one setting of the calculation after the other; yield its name."""
    held = changed.calculation
    for name, wrong in (("calcMode", "manual"), ("iterate", True), ("fullPrecision", False)):
        before = getattr(held, name)
        setattr(held, name, wrong)
        yield name
        setattr(held, name, before)


def texts(looks: Looks, changed: Workbook, count: int, seed: int | str) -> set[str]:
    """Turn some formulas into their own texts; return their cells."""
    formulas = [pair for pair in looks.pairs.values() if pair.declared_formula]
    cells = set()
    for pair in random.Random(seed).sample(formulas, count):
        changed[pair.address.sheet][pair.address.a1].data_type = "s"
        cells.add(f"{pair.address.sheet}!{pair.address.a1}")
    return cells


def packages(looks: Looks) -> Iterator[tuple[str, bytes]]:
    """Yield copies of which two programs could read two things, each in words."""
    parts = unzipped(looks.path.read_bytes())
    kind = "application/vnd.openxmlformats-officedocument.spreadsheetml."
    for name, content in (("xl/workbook2.xml", "sheet.main"), ("xl/strings2.xml", "sharedStrings")):
        more = f'<Override PartName="/{name}" ContentType="{kind}{content}+xml"/></Types>'.encode()
        types = parts["[Content_Types].xml"].replace(b"</Types>", more)
        yield name, zipped(parts | {name: parts["xl/workbook.xml"], "[Content_Types].xml": types})
    sheet = "xl/worksheets/sheet2.xml"
    formula, row = rb"(<f>[^<]*</f>)", rb"(<row .*?</row>)"
    for what, pattern, new in (("a formula", formula, rb"\1\1"), ("an element in one", b"</f>", b"<x/></f>"),
                               ("a row", row, rb"\1\1"), ("a cell", rb"(<c [^>]*><f>.*?</c>)", rb"\1\1")):  # fmt: skip
        yield what, zipped(parts | {sheet: re.sub(pattern, new, parts[sheet], count=1, flags=re.DOTALL)})


def outcomes(name: str, folder: Path, count: int, seed: int | str) -> Iterator[tuple[str, bool]]:
    """Yield faults of every class in words, each with whether ``verify`` finds and names it, and nothing of taste."""
    looks = Looks(name, folder)
    changed = looks.opened()
    faults = formatted(looks, changed, count, seed)
    said, built, oracle = looks.said(changed), Oracle(looks.opened()), Oracle(changed)
    for pair, code in faults:
        text = oracle.text(pair.address)
        hidden = text == built.text(pair.address) == ""  # a zero that is not to be seen is not seen either
        misread = not hidden and not reads_back(text, value_of(pair), pair.cell.quantity.unit)
        found = f"{pair.address.sheet}!{pair.address.a1}" in said
        yield f"{pair.address} shown as {text!r} by {code}", found if misread else not (found and code in TASTE)
    for style in ("label", "symbol", "unit"):
        changed = looks.opened()
        cells = exchanged(looks, changed, style, seed)
        said = looks.said(changed)
        yield from ((f"{cell}: a {style} that has changed places", cell in said) for cell in sorted(cells))
    changed = looks.opened()
    corners = [corner for _, _, corner in redrawn(changed, seed)]
    said = looks.said(changed)
    yield from ((f"the chart at {corner}", corner in said) for corner in corners)
    yield from whole(looks, folder / "changed.xlsx", seed)


def whole(looks: Looks, path: Path, seed: int | str) -> Iterator[tuple[str, bool]]:
    """Yield the faults about which all of ``verify`` is asked: types, settings, parts."""
    changed = looks.opened()
    cells = texts(looks, changed, 10, seed)
    changed.save(path)
    kinds = named(path)
    yield from ((f"{cell}: a formula kept as a text", "replaced" in kinds.get(cell, ())) for cell in sorted(cells))
    changed = looks.opened()
    for name in settings(changed):
        changed.save(path)
        yield f"the setting {name}", named(path).keys() == {"!calculation"}
    for what, content in packages(looks):
        path.write_bytes(content)
        yield f"{what} twice in the package", refused(path)


def refused(path: Path) -> bool:
    """Whether a file is refused."""
    try:
        open_book(path)
    except ReadError:
        return True
    return False


def named(path: Path) -> dict[str, set[str]]:
    """Return the kinds of findings that all of ``verify`` has for each cell of a file."""
    kinds: dict[str, set[str]] = {}
    for f in verify(path).findings:
        kinds.setdefault(f"{f.sheet}!{f.cell}", set()).add(f.kind)
    return kinds
