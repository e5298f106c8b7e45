"""Charts of a file against those of a fresh build: all attributes of their XML, with the cells that they draw."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from itertools import product
from typing import Any, NamedTuple, TypeVar
from xml.etree.ElementTree import Element

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.book.formula import Area, FormulaError, reference
from workbook.judging.display.differences import COPY, Differences, Subject
from workbook.judging.display.flat import Flat, Shown, flatten
from workbook.judging.display.sheets import SheetView
from workbook.judging.matching import Match
from workbook.reading.rows import tag

T = TypeVar("T")
U = TypeVar("U")
CM = 360_000  # EMU
SMALL = 0.4  # of the width or height of a fresh build, below which a chart can hardly be read
# elements with cells
SOURCES = {"xVal": "x", "cat": "x", "yVal": "y", "val": "y", "plus": "strokes", "tx": "text"}
DRAWN = ("x", "y", "errBars strokes")
TEXTS = ("t", "f", "v")  # elements that hold texts and references, which are read apart
COPIED = re.compile(r"(label )?[0-9]+")  # in place of a reference
# what is reported though a fresh build has none: all else that is added is a program's own way to write what is usual
ADDED = re.compile(
    r"\b(trendline|upDownBars|dropLines|hiLowLines|dTable|view3D|pivotFmts|userShapes|errBars|dPt.* spPr|dLbl.* text"
    r"|numFmt|show(Val|SerName|CatName|Percent)|scaling|dispUnits|smooth|tickLblPos|overlay|prstDash|custDash"
    r"|dispBlanksAs|latin|strike"
    r"|\w*[rR]Pr (noFill|solidFill|sz)|plotArea spPr solidFill|legend layout)\b"
)


class ChartData(NamedTuple):
    """A chart: its lines, its other attributes, where it stands, and its number among the drawings of its sheet."""

    lines: list[Flat]
    looks: Flat
    at: Address
    number: int = 0


class ChartReader(NamedTuple):
    """A reader of the charts of a sheet: how names of sheets are resolved, and what a cell shows."""

    sheet: str
    named: Callable[[str, str], Area]
    shown: Callable[[Address], Any]

    def source(self, element: Element) -> Shown | str:
        """Return the cells to which an element refers, or its text; LibreOffice quotes a text as if it referred."""
        text = next((part.text or "" for part in element.iter() if tag(part) == "f"), "")
        if not text or text.startswith('"'):
            own = "".join(part.text or "" for part in element.iter() if tag(part) in ("t", "v"))
            return text.strip('"').replace('""', '"') or own
        try:
            area = reference(text, self.sheet, self.named) if "!" in text else None
        except FormulaError:
            area = None
        if area is None:
            return COPY if COPIED.fullmatch(text) else text
        words = str(self.shown(area.first)) if tag(element) == "tx" else f"{area.sheet}!{area.a1}"
        return Shown(area._replace(single=area.size == 1), words)

    def attributes(self, element: Element, path: str = "", leaving: Collection[str] = ()) -> Flat:
        """Return the attributes of an element, with the cells and texts that it names."""
        return flatten(element, path, (*leaving, *TEXTS), SOURCES, self.source)

    def line(self, series: Element) -> Flat:
        """Return the attributes of a line in any program: no outline of markers, looks of a point only where its own.

        LibreOffice leaves such outlines out, and gives a point that has a label the looks of its line again.
        """
        line = dict.fromkeys((*DRAWN, "text"), "") | self.attributes(series)
        of_points = [key for key in line if key.startswith("dPt ")]
        again = {key for key in of_points if line.get(key.removeprefix("dPt ")) == line[key]}
        shown = (key for key in line if key not in again and not key.startswith("marker spPr ln"))
        return {key: line[key] for key in shown}

    def chart(self, root: Element, at: Address, number: int = 0) -> ChartData:
        """Return a chart that stands at a cell, with its number among the drawings of the sheet."""
        parts = root.findall(".//{*}plotArea/*")
        axes = [part for part in parts if tag(part).endswith("Ax")]
        groups = [part for part in parts if tag(part).endswith("Chart")]
        looks = self.attributes(root, leaving=("ser", *map(tag, axes)))
        looks["kind"] = ", ".join(sorted({*map(tag, groups)}))
        looks["title"] = looks.pop("chart title text", "")
        # of the first group
        ids = [axis.get("val") for axis in root.findall(".//{*}plotArea/*/{*}axId")][:2]
        for axis in axes:
            own = next((part.get("val") for part in axis.findall("{*}axId")), None)
            name = f"axis {'xy'[ids.index(own)]}" if own in ids else "another axis"
            looks |= self.attributes(axis, name)
        lines = [self.line(series) for group in groups for series in group.findall("{*}ser")]
        return ChartData(lines, looks, at, number)


def read_charts(match: Match, title: str) -> Iterator[ChartData]:
    """Yield the charts of a sheet of the file."""
    file, area = match.file, match.file.contents.area
    reader = ChartReader(title, area, lambda at: file.saved.get(at) or file.value(at) or "")
    for number, anchor in enumerate(file.inspected.drawings.get(title, ())):
        if anchor.chart is not None:
            at = Address(title, anchor.first.row + 1, anchor.first.column + 1)
            yield reader.chart(anchor.chart, at, number)


def compare_charts(fresh: Any, views: Mapping[str, SheetView], differences: Differences) -> None:
    """Enter declared charts that draw something else than in the workbook ``fresh``, cannot be seen, or are gone."""
    for sheet, title in differences.match.sheets:
        held = list(read_charts(differences.match, title))
        pairs = pair_charts(differences.match, sheet, fresh[sheet.title]._charts, held)
        titles = {str(ours.looks["title"]) for _, ours, _ in pairs}
        for drawn, ours, theirs in pairs:
            name = str(ours.looks["title"])
            axes = {str(ours.looks.get(f"axis {letter} title text", "")) for letter in "xy"}
            group = theirs.at.a1 if theirs else ""
            subject = Subject(f"the chart {name!r}", "", titles | axes, group)
            if theirs is None:
                differences.add(Address(title, 1, 1), subject, "chart", name, "")
                continue
            compare_attributes(differences, theirs.at, subject, ours.looks, theirs.looks)
            compare_lines(subject, ours, theirs, differences)
            hidden = hidden_parts(theirs, (drawn.width, drawn.height), views)
            for what, expected, seen in hidden:
                differences.add(theirs.at, subject, what, expected, seen)


def pair_charts(
    match: Match, sheet: Sheet, drawn: Iterable[Any], held: list[ChartData]
) -> list[tuple[Any, ChartData, ChartData | None]]:
    """Return each chart of openpyxl's that is ``drawn``, its attributes, and the chart of the file most like it."""
    differences, at = Differences(match), Address(sheet.title, 1, 1)
    reader = ChartReader(sheet.title, match.declared_area, match.declared_value)
    fresh = [(chart, reader.chart(chart._write(), at)) for chart in drawn]

    def likeness(ours: tuple[Any, ChartData], theirs: ChartData) -> float:
        lines = ours[1].lines
        others = theirs.lines
        drawn = [any(has_data(differences, line, other) for other in others) for line in lines]
        has_title = differences.is_same("title", ours[1].looks["title"], theirs.looks["title"])
        return 2 * sum(drawn) + has_title - 0.1 * abs(len(lines) - len(theirs.lines))

    return [(*ours, other) for ours, other in pair_alike(fresh, held, likeness) if ours is not None]


def pair_alike(
    fresh: Iterable[T], held: Iterable[U], likeness: Callable[[T, U], float]
) -> Iterator[tuple[T | None, U | None]]:
    """Yield what is alike in pairs, the most alike first, then what is left of either side."""
    ours, theirs = dict(enumerate(fresh)), dict(enumerate(held))
    pairs = product(ours.items(), theirs.items())
    ranked = ((-likeness(mine, other), i, j) for (i, mine), (j, other) in pairs)
    for rank, i, j in sorted(ranked):
        if rank < 0 and i in ours and j in theirs:
            yield ours.pop(i), theirs.pop(j)
    yield from ((mine, None) for mine in ours.values())
    yield from ((None, other) for other in theirs.values())


def has_data(differences: Differences, fresh: Flat, held: Flat) -> bool:
    """Whether two lines draw the same columns."""
    return all(differences.is_same(name, fresh[name], held[name]) for name in DRAWN)


def compare_lines(of: Subject, fresh: ChartData, held: ChartData, differences: Differences) -> None:
    """Enter lines of a chart that are gone, added, or not as in a fresh build."""
    subject = of._replace(others={str(line["text"]) for line in fresh.lines})

    def likeness(ours: Flat, theirs: Flat) -> float:
        has_text = differences.is_same("text", ours["text"], theirs["text"])
        return 1 + 2 * has_text + 4 * has_data(differences, ours, theirs)

    for ours, theirs in pair_alike(fresh.lines, held.lines, likeness):
        part = f"line {str(ours['text'])!r} " if ours else ""
        if ours and theirs:
            compare_attributes(differences, held.at, subject, ours, theirs, part)
        elif ours:
            differences.add(held.at, subject, f"{part}drawn", "yes", "no")
        elif theirs:
            is_declared = str(theirs["text"]) in subject.others
            what = "another line" + (" of a declared name" if is_declared else "")
            differences.add(held.at, subject, what, "", theirs["text"] or "drawn")


def compare_attributes(
    differences: Differences, at: Address, subject: Subject, fresh: Flat, held: Flat, part: str = ""
) -> None:
    """Enter what of a chart, or of any of its lines, is not as in a fresh build."""
    held = {key: value for key, value in held.items() if key in fresh or ADDED.search(key)}
    differences.compare(at, subject, fresh, held, part)


def hidden_parts(
    held: ChartData, cm: tuple[float, float], views: Mapping[str, SheetView]
) -> Iterator[tuple[str, str, str]]:
    """Yield why a chart can hardly be seen: what, as expected and as held; ``cm`` are width and height as built."""
    areas = views[held.at.sheet].areas
    own = areas[held.number]
    share = min((own.right - own.left) / cm[0], (own.bottom - own.top) / cm[1]) / CM
    if share < SMALL:
        yield "size", "as built", f"{share:.0%} of it"
    middle = (own.left + own.right) / 2, (own.top + own.bottom) / 2
    if any(area.has(*middle) for area in areas[held.number + 1 :]):
        yield "sight", "in sight", "behind another drawing"
    columns = [line[name] for line in held.lines for name in ("x", "y")]
    drawn = [x.meaning for x in columns if isinstance(x, Shown) and x.meaning.sheet in views]
    rows = [(views[area.sheet].rows, range(area.top, area.bottom + 1)) for area in drawn]
    hidden = max((sum(not heights[row] for row in numbers) for heights, numbers in rows), default=0)
    if hidden and held.looks.get("chart plotVisOnly val", "1") == "1":
        yield "rows that it draws", "all", f"without {hidden:,} hidden rows"
