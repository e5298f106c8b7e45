"""Charts of a file against those of a fresh build: what each draws, its axes, its texts, and whether it can be seen."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.book.formula import Area
from workbook.judging.display.chart_reader import Axis, ChartData, ChartReader, Line, Name, read_charts
from workbook.judging.display.groups import Differences
from workbook.judging.display.looks import format_sections, plain_number
from workbook.judging.display.sight import SheetView
from workbook.judging.display.texts import TELLING, is_other_unit, split_unit
from workbook.judging.matching import Match
from workbook.writing.charts import draw
from workbook.writing.write import chart_size

CM = 360_000  # EMU
SMALL = 0.4  # of the width or height of a fresh build, below which a chart can hardly be read
BEHIND = 0.5  # of a chart that another drawing may cover


def check_charts(match: Match, views: Mapping[str, SheetView], differences: Differences) -> None:
    """Enter declared charts that draw something else, cannot be seen, or are gone."""
    for sheet, title in match.sheets:
        pairs = list(pair_charts(match, sheet, list(read_charts(match, title))))
        for (chart, _, *place), expected, held in pairs:
            what = f"the chart {chart.title!r}"
            if held is not None:
                others = [other.title for _, other, _ in pairs if other is not expected]
                compare_charts(match, expected, held, others, what, differences)
                check_chart_sight(match, expected, held, chart_size(*place), views, what, differences)
            elif match.file.inspected:
                differences.add(Address(title, 1, 1), "chart", chart.title, "nothing", what, misleads=False)


def pair_charts(match: Match, sheet: Sheet, held: list[ChartData]) -> Iterator[tuple[Any, ChartData, ChartData | None]]:
    """Yield each declared chart of a sheet, as a fresh build has it, with the one of the file that is most like it."""
    reader = ChartReader(Address(sheet.title, 1, 1), match.declared_area)
    drawings: list[Any] = [draw(chart, match.declared, *chart_size(*place)) for chart, _, *place in sheet.charts]
    expected = [reader.chart(drawing._write()) for drawing in drawings]
    likeness = sorted(
        ((similarity(match, ours, theirs), -i, -k) for i, ours in enumerate(expected) for k, theirs in enumerate(held)),
        reverse=True,
    )
    taken: dict[int, int] = {}
    for alike, i, k in likeness:
        if alike > 0 and -i not in taken and -k not in taken.values():
            taken[-i] = -k
    for i, chart in enumerate(sheet.charts):
        yield chart, expected[i], held[taken[i]] if i in taken else None


def similarity(match: Match, fresh: ChartData, held: ChartData) -> float:
    """Return how like a chart of a fresh build one of the file is: by what it draws, and by its title."""
    same = sum(any(is_same_line(match, ours, theirs) for theirs in held.lines) for ours in fresh.lines)
    return 2 * same / max(len(fresh.lines), len(held.lines), 1) + (fresh.title == held.title)


def is_same_line(match: Match, fresh: Line, held: Line) -> bool:
    """Whether two lines draw the same columns."""
    return all(match.same(*areas) for areas in zip(fresh[:3], held[:3], strict=True))


def compare_charts(
    match: Match, fresh: ChartData, held: ChartData, others: list[Name], what: str, differences: Differences
) -> None:
    """Enter what of a chart is not as in a fresh build."""

    def enter(attribute: str, expected: object, found: object, misleads: bool) -> None:
        differences.add(held.at, attribute, expected, found, what, misleads, group=held.at.a1)

    if fresh.kinds != held.kinds:
        misleads = set(fresh.kinds) != set(held.kinds) or not all(axis.is_shown for axis in held.other_axes)
        enter("kind", ", ".join(fresh.kinds), ", ".join(held.kinds), misleads)
    if fresh.additions != held.additions:
        enter("drawing", ", ".join(fresh.additions) or "none", ", ".join(held.additions) or "none", False)
    if not is_same_name(match, fresh.title, held.title):
        texts = name_text(fresh.title), name_text(held.title)
        more = set(TELLING.findall(texts[1])) - set(TELLING.findall(texts[0]))
        enter("title", *texts, held.title in others or bool(more))
    odd_formats = [code for code in held.label_formats if plain_number(format_sections(code)) != ("N",)]
    if odd_formats:
        enter("format of labels", "as built", ", ".join(odd_formats), True)
    compare_lines(match, fresh.lines, held.lines, enter)
    for n, (ours, theirs) in enumerate(zip(fresh.axes, held.axes, strict=True)):
        axis = "xy"[n]
        if not is_same_name(match, ours.title, theirs.title):
            texts = declared_text(match, ours.title), name_text(theirs.title)
            units = [split_unit(text)[1] if "[" in text else "" for text in texts]
            other = declared_text(match, fresh.axes[1 - n].title)
            misleads = texts[1] == other or (all(units) and is_other_unit(units[1], units[0]))
            enter(f"title of its axis {axis}", *texts, misleads)
        for name in Axis._fields[1:]:
            expected, found = getattr(ours, name), getattr(theirs, name)
            sections = [format_sections(code) for code in (expected, found)] if name == "number_format" else []
            if expected == found or (sections and sections[0][:3] == sections[1][:3]):
                continue
            bare = plain_number(sections[1]) == plain_number(sections[0]) if sections else name == "is_shown"
            is_free = name in ("least", "most") and not found  # the program then shows all points
            attribute = f"{name.replace('_', ' ')} of its axis {axis}"
            enter(attribute, expected or "none", found or "none", not (bare or is_free))


def compare_lines(match: Match, fresh: list[Line], held: list[Line], enter: Callable[..., None]) -> None:
    """Enter which lines draw something else, are gone, are called otherwise, or cannot be seen."""
    if any(match.lost(area) for line in fresh for area in line[:2]):
        return
    free, missing = list(held), []
    for line in fresh:
        if (same := next((other for other in free if is_same_line(match, line, other)), None)) is None:
            missing.append(line)
            continue
        free.remove(same)
        if not is_same_name(match, line.name, same.name) and (same.name or len(fresh) > 1):
            exchanged = any(is_same_name(match, other.name, same.name) for other in fresh if other is not line)
            enter("name of a line", name_text(line.name), name_text(same.name), exchanged)
        for words, ours, theirs in (
            (("drawn", "not drawn"), line.is_seen, same.is_seen),
            (("bent between its points", "straight"), line.is_bent, same.is_bent),
        ):
            if ours != theirs:
                enter(f"line {declared_text(match, line.name)!r}", words[not ours], words[not theirs], False)
    for line in missing:
        named = [other for other in free if other.name == line.name] or free
        if named:
            free.remove(named[0])
        enter(f"line {declared_text(match, line.name)!r}", line, named[0] if named else "nothing", bool(named))
    for line in free:
        called = bool(line.name) and any(is_same_name(match, other.name, line.name) for other in fresh)
        enter("another line", "none", line, called)


def check_chart_sight(
    match: Match,
    fresh: ChartData,
    held: ChartData,
    cm: tuple[float, float],
    views: Mapping[str, SheetView],
    what: str,
    differences: Differences,
) -> None:
    """Enter that a chart can hardly be seen: shrunk, behind another drawing, or by hidden rows; ``cm`` is its size."""
    areas = views[held.at.sheet].areas
    own = areas[held.number]
    ends = own.right - own.left, own.bottom - own.top
    rooms = [min(1.0, theirs / ours) for theirs, ours in zip(held.room, fresh.room, strict=True)]
    share = min(room * end / (whole * CM) for room, end, whole in zip(rooms, ends, cm, strict=True))
    if share < SMALL:
        differences.add(held.at, "size", "as built", f"{share:.0%} of it", what, share < SMALL / 3)
    above = [k for k in range(held.number + 1, len(areas)) if own.shared(areas[k]) > BEHIND]
    if above:
        titles = {chart.number: chart.title for chart in read_charts(match, held.at.sheet)}
        alike = any(titles.get(k, held.title) == held.title for k in above)
        differences.add(held.at, "sight", "in sight", "behind another drawing", what, alike)
    columns = [area for line in held.lines for area in line[:2] if area is not None and area.sheet in views]
    hidden = max((count_hidden_rows(views[area.sheet], area) for area in columns), default=0)
    if held.visible_only and hidden:
        differences.add(held.at, "rows that it draws", "all", f"without {hidden:,} hidden rows", what, True)


def count_hidden_rows(view: SheetView, area: Area) -> int:
    """Return how many rows of an area are hidden."""
    return sum(not view.rows[row] for row in range(area.top, area.bottom + 1))


def is_same_name(match: Match, fresh: Name, held: Name) -> bool:
    """Whether a name is that of a fresh build; one that follows a cell becomes its text where LibreOffice saves it."""
    if isinstance(held, str):
        return held == declared_text(match, fresh)
    return not isinstance(fresh, str) and match.same(fresh, held)


def declared_text(match: Match, name: Name) -> str:
    """Return a name of a fresh build; of one that follows a cell, the cell's text."""
    return name if isinstance(name, str) else str(match.declared_value(name.first))


def name_text(name: Name) -> str:
    """Return a name, or the cell that has it."""
    return name if isinstance(name, str) else f"the text of {name.sheet}!{name.a1}"
