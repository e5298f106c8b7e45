"""Charts of a file against those of a fresh build: lines, axes, texts, and what hides them."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, NamedTuple, TypeVar
from xml.etree.ElementTree import Element

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.book.formula import Area, FormulaError, reference
from workbook.judging.display.differences import Differences, Subject, text_misleads
from workbook.judging.display.flat import Flat, flatten, is_same, usual_value
from workbook.judging.display.sheets import SheetView
from workbook.judging.matching import Match
from workbook.reading.rows import tag
from workbook.writing.charts import draw
from workbook.writing.write import chart_size

CM = 360_000  # EMU
SMALL = 0.4  # of the width or height of a fresh build, below which a chart can hardly be read
DATA = {"x": ("xVal", "cat"), "y": ("yVal", "val"), "strokes": ("plus",), "name": ("tx",)}  # of a line, by elements
TEXTS = ("t", "f", "v")  # elements that hold texts and references, which are read apart
# what is reported though a fresh build has none: all else that is added is a program's own way to write what is usual
T = TypeVar("T")
ADDED = re.compile(
    r"\b(trendline|upDownBars|dropLines|hiLowLines|dTable|view3D|pivotFmts|userShapes|errBars|dPt.* spPr|dLbl.* tx"
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


def read_charts(match: Match, title: str) -> Iterator[ChartData]:
    """Yield the charts of a sheet of the file."""
    inspected = match.file.inspected
    for number, anchor in enumerate(inspected.drawings.get(title, ()) if inspected else ()):
        if anchor.chart is not None:
            at = Address(title, anchor.first.row + 1, anchor.first.column + 1)
            yield read_chart(anchor.chart, at, match.file.contents.area, number)


def read_chart(root: Element, at: Address, named: Callable[[str, str], Area], number: int = 0) -> ChartData:
    """Return a chart that stands at a cell; ``named`` resolves the names of sheets in its references."""
    plot = root.find(".//{*}plotArea")
    parts = [] if plot is None else list(plot)
    groups = [part for part in parts if tag(part).endswith("Chart")]
    ids = [part.get("val") for part in groups[0] if tag(part) == "axId"] if groups else []
    looks = flatten(root, leaving=("ser", *TEXTS, *(tag(part) for part in parts if tag(part)[-2:] == "Ax")))
    looks |= {"kind": ", ".join(sorted({tag(part) for part in groups}))}
    for axis in (part for part in parts if tag(part)[-2:] == "Ax"):
        own = next((part.get("val") for part in axis if tag(part) == "axId"), None)
        name = f"axis {'xy'[ids.index(own)]}" if own in ids[:2] else "another axis"
        looks |= flatten(axis, name, leaving=TEXTS)
        looks[f"{name} title"] = data_of(axis.find("{*}title/{*}tx"), at, named)
    lines = [read_line(part, at, named) for group in groups for part in group if tag(part) == "ser"]
    looks["title"] = data_of(root.find("{*}chart/{*}title/{*}tx"), at, named)
    return ChartData(lines, looks, at, number)


def read_line(series: Element, at: Address, named: Callable[[str, str], Area]) -> Flat:
    """Return the data, the name and the looks of a line."""
    line = flatten(series, leaving=[element for elements in DATA.values() for element in elements])
    line = {key: value for key, value in line.items() if not key.startswith("marker spPr ln")}  # LibreOffice has none
    for name, elements in DATA.items():
        line[name] = data_of(next((e for e in series.iter() if tag(e) in elements), None), at, named)
    return line


def data_of(element: Element | None, at: Address, named: Callable[[str, str], Area]) -> Area | str:
    """Return the cells to which an element refers, or its text; LibreOffice quotes a text as if it were a reference."""
    if element is None:
        return ""
    text = next((part.text or "" for part in element.iter() if tag(part) == "f"), "")
    if not text or text.startswith('"'):
        own = "".join(part.text or "" for part in element.iter() if tag(part) in ("t", "v"))
        return text.strip('"').replace('""', '"') or own
    try:
        area = reference(text, at.sheet, named) if "!" in text else None
    except FormulaError:
        area = None
    return area._replace(single=area.size == 1) if area else text


def compare_charts(match: Match, views: Mapping[str, SheetView], differences: Differences) -> None:
    """Enter declared charts that draw something else, cannot be seen, or are gone."""
    for sheet, title in match.sheets:
        pairs = list(pair_charts(match, sheet, list(read_charts(match, title))))
        titles = {text_words(match, fresh.looks["title"]) for _, fresh, _ in pairs}
        for (chart, _, *place), fresh, held in pairs:
            subject = Subject(f"the chart {chart.title!r}", group=held.at.a1 if held else "")
            if held is not None:
                compare_chart(match, subject, fresh, held, titles, differences)
                compare_chart_sight(subject, held, chart_size(*place), views, differences)
            elif match.file.inspected:
                differences.add(Address(title, 1, 1), subject, "chart", chart.title, "", misleads=False)


def pair_charts(match: Match, sheet: Sheet, held: list[ChartData]) -> Iterator[tuple[Any, ChartData, ChartData | None]]:
    """Yield each declared chart of a sheet, as a fresh build has it, with that of the file that is most like it."""
    drawings: list[Any] = [draw(chart, match.declared, *chart_size(*place)) for chart, _, *place in sheet.charts]
    at = Address(sheet.title, 1, 1)
    fresh = [read_chart(drawing._write(), at, match.declared_area) for drawing in drawings]

    def shared(ours: ChartData, theirs: ChartData) -> int:
        return sum(any(is_same_line(match, line, other) for other in theirs.lines) for line in ours.lines)

    def has_title(ours: ChartData, theirs: ChartData) -> bool:
        return is_same_data(match, ours.looks["title"], theirs.looks["title"])

    def is_whole(ours: ChartData, theirs: ChartData) -> bool:
        return shared(ours, theirs) == len(ours.lines) == len(theirs.lines)

    tests = (lambda *two: is_whole(*two) and has_title(*two), is_whole, has_title, shared)
    paired = {id(ours): theirs for ours, theirs in pair_alike(fresh, held, tests) if ours is not None}
    for chart, ours in zip(sheet.charts, fresh, strict=True):
        yield chart, ours, paired[id(ours)]


def pair_alike(
    fresh: Iterable[T], held: Iterable[T], tests: Iterable[Callable[[T, T], Any]]
) -> Iterator[tuple[T | None, T | None]]:
    """Yield what is alike in pairs, by the first test that two meet, then what is left of either side."""
    left, free = list(fresh), list(held)
    for is_alike in tests:
        for ours in list(left):
            if alike := [theirs for theirs in free if is_alike(ours, theirs)]:
                left = [other for other in left if other is not ours]
                free = [other for other in free if other is not alike[0]]
                yield ours, alike[0]
    yield from ((ours, None) for ours in left)
    yield from ((None, theirs) for theirs in free)


def is_same_line(match: Match, fresh: Flat, held: Flat) -> bool:
    """Whether two lines draw the same columns."""
    return all(match.same(fresh[name], held[name]) for name in ("x", "y", "strokes"))


def is_same_data(match: Match, fresh: Area | str, held: Area | str) -> bool:
    """Whether two texts or ranges are the same; a text that follows a cell is written out as LibreOffice saves it."""
    return match.same(fresh, held) or (isinstance(fresh, Area) and held == str(match.declared_value(fresh.first)))


def compare_chart(
    match: Match, subject: Subject, fresh: ChartData, held: ChartData, titles: set[str], differences: Differences
) -> None:
    """Enter what of a chart is not as in a fresh build."""
    compare_parts(match, held.at, subject, "", fresh.looks, held.looks, titles, differences)
    if any(match.lost(line[name]) for line in fresh.lines for name in ("x", "y")):
        return
    names = {text_words(match, line["name"]) for line in fresh.lines}
    tests = (
        lambda ours, theirs: is_same_line(match, ours, theirs),
        lambda ours, theirs: is_same_data(match, ours["name"], theirs["name"]),
        lambda ours, theirs: True,
    )
    for line, other in pair_alike(fresh.lines, held.lines, tests):
        words = f"line {text_words(match, line['name'])!r}" if line else ""
        if line and other:
            compare_parts(match, held.at, subject, f"{words} ", line, other, names, differences)
        elif line:
            differences.add(held.at, subject, words, "drawn", "", misleads=True)
        elif other:
            name = range_words(other["name"])
            differences.add(held.at, subject, "another line", "", name or "drawn", misleads=name in names)


def compare_parts(
    match: Match,
    at: Address,
    subject: Subject,
    part: str,
    fresh: Flat,
    held: Flat,
    texts: set[str],
    differences: Differences,
) -> None:
    """Enter what of a chart, or of any of its lines, is not as in a fresh build; ``texts`` are those of the others."""
    for key in [*fresh, *(key for key in held if key not in fresh and ADDED.search(key))]:
        ours, theirs = fresh.get(key, usual_value(key)), held.get(key, usual_value(key))
        if is_same_data(match, ours, theirs) or is_same(key, ours, theirs):
            continue
        if key == "name" or key.endswith("title"):
            words = text_words(match, ours), held_text(match, theirs)
            axes = {text_words(match, fresh.get(f"axis {letter} title", "")) for letter in "xy"}
            wrong = text_misleads(*words, (texts | axes) - {words[0], ""})
            differences.add(at, subject, f"{part}{key}", *words, wrong)
        else:
            differences.tell(at, subject, {f"{part}{key}": (range_words(ours), range_words(theirs))})


def text_words(match: Match, text: Area | str) -> str:
    """Return a text of a fresh build; of a text that follows a cell, the cell's."""
    return str(match.declared_value(text.first)) if isinstance(text, Area) else text


def held_text(match: Match, text: Area | str) -> str:
    """Return a text of a file; of a text that follows a cell, what was saved in the cell."""
    if not isinstance(text, Area):
        return text
    return str(match.file.saved.get(text.first) or match.file.value(text.first) or "")


def range_words(data: Area | str) -> str:
    """Return a text, or a range as it is written."""
    return f"{data.sheet}!{data.a1}" if isinstance(data, Area) else data


def compare_chart_sight(
    subject: Subject, held: ChartData, cm: tuple[float, float], views: Mapping[str, SheetView], differences: Differences
) -> None:
    """Enter that a chart can hardly be seen: shrunk, behind another drawing, or by hidden rows; ``cm`` is its size."""
    areas = views[held.at.sheet].areas
    own = areas[held.number]
    ends = own.right - own.left, own.bottom - own.top
    share = min(end / (whole * CM) for end, whole in zip(ends, cm, strict=True))
    middle = (own.left + own.right) / 2, (own.top + own.bottom) / 2
    if share < SMALL:
        differences.add(held.at, subject, "size", "as built", f"{share:.0%} of it", misleads=False)
    if any(area.has(*middle) for area in areas[held.number + 1 :]):
        differences.add(held.at, subject, "sight", "in sight", "behind another drawing", misleads=False)
    columns = [area for line in held.lines for area in (line["x"], line["y"]) if isinstance(area, Area)]
    hidden = max((count_hidden_rows(views[area.sheet], area) for area in columns if area.sheet in views), default=0)
    if hidden and held.looks.get("chart plotVisOnly val", "1") == "1":
        differences.add(held.at, subject, "rows that it draws", "all", f"without {hidden:,} hidden rows", misleads=True)


def count_hidden_rows(view: SheetView, area: Area) -> int:
    """Return how many rows of an area are hidden."""
    return sum(not view.rows[row] for row in range(area.top, area.bottom + 1))
