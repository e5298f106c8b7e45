"""Charts of a file against those of a fresh build: all attributes of their XML, with the cells that they draw."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
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
        again = {
            key for key, value in line.items() if (rest := key.removeprefix("dPt ")) != key and line.get(rest) == value
        }
        return {key: value for key, value in line.items() if key not in again and not key.startswith("marker spPr ln")}

    def chart(self, root: Element, at: Address, number: int = 0) -> ChartData:
        """Return a chart that stands at a cell, with its number among the drawings of the sheet."""
        parts = root.findall(".//{*}plotArea/*")
        axes = [part for part in parts if tag(part).endswith("Ax")]
        groups = [part for part in parts if tag(part).endswith("Chart")]
        looks = self.attributes(root, leaving=("ser", *map(tag, axes)))
        looks |= {"kind": ", ".join(sorted({*map(tag, groups)})), "title": looks.pop("chart title text", "")}
        # of the first group
        ids = [axis.get("val") for axis in root.findall(".//{*}plotArea/*/{*}axId")][:2]
        for axis in axes:
            own = next((part.get("val") for part in axis.findall("{*}axId")), None)
            looks |= self.attributes(axis, f"axis {'xy'[ids.index(own)]}" if own in ids else "another axis")
        return ChartData(
            [self.line(series) for group in groups for series in group.findall("{*}ser")], looks, at, number
        )


def read_charts(match: Match, title: str) -> Iterator[ChartData]:
    """Yield the charts of a sheet of the file."""
    file, inspected = match.file, match.file.inspected
    reader = ChartReader(title, file.contents.area, lambda at: file.saved.get(at) or file.value(at) or "")
    for number, anchor in enumerate(inspected.drawings.get(title, ()) if inspected else ()):
        if anchor.chart is not None:
            yield reader.chart(anchor.chart, Address(title, anchor.first.row + 1, anchor.first.column + 1), number)


def compare_charts(match: Match, fresh: Any, views: Mapping[str, SheetView], differences: Differences) -> None:
    """Enter declared charts that draw something else than in the workbook ``fresh``, cannot be seen, or are gone."""
    for sheet, title in match.sheets:
        pairs = pair_charts(match, sheet, fresh[sheet.title]._charts, list(read_charts(match, title)))
        titles = {str(ours.looks["title"]) for _, ours, _ in pairs}
        for drawn, ours, theirs in pairs:
            name = str(ours.looks["title"])
            axes = {str(ours.looks.get(f"axis {letter} title text", "")) for letter in "xy"}
            subject = Subject(f"the chart {name!r}", "", titles | axes, theirs.at.a1 if theirs else "")
            if theirs is not None:
                compare_attributes(differences, theirs.at, subject, ours.looks, theirs.looks)
                compare_lines(match, subject, ours, theirs, differences)
                compare_sight(subject, theirs, (drawn.width, drawn.height), views, differences)
            elif match.file.inspected:
                differences.add(Address(title, 1, 1), subject, "chart", name, "")


def pair_charts(
    match: Match, sheet: Sheet, drawn: Iterable[Any], held: list[ChartData]
) -> list[tuple[Any, ChartData, ChartData | None]]:
    """Return each chart of openpyxl's that is ``drawn``, its attributes, and the chart of the file most like it."""
    differences, at = Differences(match), Address(sheet.title, 1, 1)
    reader = ChartReader(sheet.title, match.declared_area, match.declared_value)
    fresh = [(chart, reader.chart(chart._write(), at)) for chart in drawn]

    def likeness(ours: tuple[Any, ChartData], theirs: ChartData) -> float:
        lines = ours[1].lines
        shared = sum(any(has_data(differences, line, other) for other in theirs.lines) for line in lines)
        has_title = differences.is_same("title", ours[1].looks["title"], theirs.looks["title"])
        return 2 * shared + has_title - 0.1 * abs(len(lines) - len(theirs.lines))

    return [(*ours, other) for ours, other in pair_alike(fresh, held, likeness) if ours is not None]


def pair_alike(
    fresh: Iterable[T], held: Iterable[U], likeness: Callable[[T, U], float]
) -> Iterator[tuple[T | None, U | None]]:
    """Yield what is alike in pairs, the most alike first, then what is left of either side."""
    ours, theirs = dict(enumerate(fresh)), dict(enumerate(held))
    ranked = sorted((-likeness(mine, other), i, j) for i, mine in ours.items() for j, other in theirs.items())
    for rank, i, j in ranked:
        if rank < 0 and i in ours and j in theirs:
            yield ours.pop(i), theirs.pop(j)
    yield from ((mine, None) for mine in ours.values())
    yield from ((None, other) for other in theirs.values())


def has_data(differences: Differences, fresh: Flat, held: Flat) -> bool:
    """Whether two lines draw the same columns."""
    return all(differences.is_same(name, fresh[name], held[name]) for name in DRAWN)


def compare_lines(match: Match, subject: Subject, fresh: ChartData, held: ChartData, differences: Differences) -> None:
    """Enter lines of a chart that are gone, added, or not as in a fresh build."""
    subject = subject._replace(others={str(line["text"]) for line in fresh.lines})

    def likeness(ours: Flat, theirs: Flat) -> float:
        return (
            1 + 2 * differences.is_same("text", ours["text"], theirs["text"]) + 4 * has_data(differences, ours, theirs)
        )

    for ours, theirs in pair_alike(fresh.lines, held.lines, likeness):
        part = f"line {str(ours['text'])!r} " if ours else ""
        if ours and theirs:
            compare_attributes(differences, held.at, subject, ours, theirs, part)
        elif ours:
            differences.add(held.at, subject, f"{part}drawn", "yes", "no")
        elif theirs:
            of_declared = " of a declared name" if str(theirs["text"]) in subject.others else ""
            differences.add(held.at, subject, f"another line{of_declared}", "", theirs["text"] or "drawn")


def compare_attributes(
    differences: Differences, at: Address, subject: Subject, fresh: Flat, held: Flat, part: str = ""
) -> None:
    """Enter what of a chart, or of any of its lines, is not as in a fresh build."""
    held = {key: value for key, value in held.items() if key in fresh or ADDED.search(key)}
    differences.compare(at, subject, fresh, held, part)


def compare_sight(
    subject: Subject, held: ChartData, cm: tuple[float, float], views: Mapping[str, SheetView], differences: Differences
) -> None:
    """Enter that a chart can hardly be seen: shrunk, behind another drawing, or by hidden rows; ``cm`` is its size."""
    areas = views[held.at.sheet].areas
    own = areas[held.number]
    ends = own.right - own.left, own.bottom - own.top
    share = min(end / (whole * CM) for end, whole in zip(ends, cm, strict=True))
    middle = (own.left + own.right) / 2, (own.top + own.bottom) / 2
    if share < SMALL:
        differences.add(held.at, subject, "size", "as built", f"{share:.0%} of it")
    if any(area.has(*middle) for area in areas[held.number + 1 :]):
        differences.add(held.at, subject, "sight", "in sight", "behind another drawing")
    columns = [line[name] for line in held.lines for name in ("x", "y")]
    drawn = [x.meaning for x in columns if isinstance(x, Shown) and x.meaning.sheet in views]
    rows = [(views[area.sheet].rows, range(area.top, area.bottom + 1)) for area in drawn]
    hidden = [sum(not heights[row] for row in numbers) for heights, numbers in rows]
    if any(hidden) and held.looks.get("chart plotVisOnly val", "1") == "1":
        differences.add(held.at, subject, "rows that it draws", "all", f"without {max(hidden):,} hidden rows")
