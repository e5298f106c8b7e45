"""Charts against those of a fresh build: columns, limits, names, and whether each can be seen."""

import math
import re
from collections.abc import Iterator, Mapping
from typing import Any

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.book.formula import Area
from workbook.judging.display import permitted
from workbook.judging.display.chart_reader import Axis, ChartData, ChartReader, Line, Name, name_text, read_charts
from workbook.judging.display.formats import format_remark
from workbook.judging.display.labels import compare_units, text_kind
from workbook.judging.display.visibility import SheetView
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, SHOWN, Report
from workbook.writing.charts import draw
from workbook.writing.style import NOTHING
from workbook.writing.write import chart_size

UNIT = re.compile(r"\[([^\]]*)\]")
XY = "scatterChart"
CM = 360_000  # EMU

Change = tuple[str, Any, Any, str]  # kind, what is found, what is expected, of what


def check_charts(match: Match, pages: Mapping[str, SheetView], report: Report) -> None:
    """Enter declared charts that draw something else, and as notices those that are gone or are called otherwise."""
    for sheet, title in match.sheets:
        others = [chart.title for chart, *_ in sheet.charts]
        for (chart, _, *place), fresh, found in pair_charts(match, sheet, list(read_charts(match, title))):
            if found is not None:
                told = list(differences(match, fresh, found, others))
                told += sight_changes(match, fresh, found, chart_size(*place), pages)
                for kind, held, expected, what in told:
                    report.say(found.at, kind, held, expected, f"the chart {chart.title!r}{what}")
            elif match.file.inspected:
                report.say(Address(title, 1, 1), NOTICE, None, chart.title, "a chart")


def pair_charts(match: Match, sheet: Sheet, held: list[ChartData]) -> Iterator[tuple[Any, ChartData, ChartData | None]]:
    """Yield each declared chart of a sheet, as a fresh build has it, with the one of the file that is most like it."""
    reader = ChartReader(Address(sheet.title, 1, 1), match.declared_area)
    drawings: list[Any] = [draw(chart, match.declared, *chart_size(*place)) for chart, _, *place in sheet.charts]
    fresh = [reader.chart(one._write()) for one in drawings]
    found: dict[int, int] = {}
    likeness = [(similarity(match, one, other), -i, -k) for i, one in enumerate(fresh) for k, other in enumerate(held)]
    for alike, i, k in sorted(likeness, reverse=True):
        if alike > 0 and -i not in found and -k not in found.values():
            found[-i] = -k
    for i, one in enumerate(sheet.charts):
        yield one, fresh[i], held[found[i]] if i in found else None


def similarity(match: Match, fresh: ChartData, found: ChartData) -> float:
    """Return how like a chart of a fresh build one of the file is: by what it draws, and by its title."""
    same = sum(any(same_columns(match, line, held) for held in found.lines) for line in fresh.lines)
    return 2 * same / max(len(fresh.lines), len(found.lines), 1) + (found.title == fresh.title)


def same_columns(match: Match, fresh: Line, held: Line) -> bool:
    """Whether two lines draw the same columns."""
    return all(match.same(*pair) for pair in zip(fresh[:3], held[:3], strict=True))


def differences(match: Match, fresh: ChartData, found: ChartData, titles: list[str]) -> Iterator[Change]:
    """Yield what of a chart is not as in a fresh build, but for taste: colours, sizes, legend, grid, another place."""
    if others := sorted(set(found.kinds) - {XY}):
        yield SHOWN, ", ".join(others), XY, ", its kind"
    if len(found.kinds) > 1 or found.other_axes:
        gone = any("not shown" in axis.said for axis in found.other_axes)
        yield SHOWN if gone else NOTICE, "other axes", "one pair of axes", ""
    if odd := [said for said in found.odd if said not in fresh.odd]:
        yield NOTICE, ", ".join(odd), "as built", ", what it shows besides"
    if found.title != fresh.title:
        text, ours = (one.title if isinstance(one.title, str) else None for one in (found, fresh))
        kind = NOTICE if text is None else text_kind(text, str(ours), [one for one in titles if one != ours])
        yield kind, name_text(found.title), ours, ", its title"
    yield from line_changes(match, fresh.lines, found.lines)
    for code in found.codes:
        kind, wrong = format_remark(code, "General")
        if kind:
            yield kind, wrong, "as they are", ", the numbers beside its points"
    for n, axes in enumerate(zip(found.axes, fresh.axes, strict=True)):
        values = [v for one in fresh.lines for v in finite_numbers(match, (one.x, one.y)[n])]
        yield from axis_changes(*axes, values, f", its axis {'xy'[n]}")
        yield from title_changes(match, axes[0].title, axes[1].title, fresh.axes[1 - n].title, f"its axis {'xy'[n]}")


def line_changes(match: Match, fresh: list[Line], held: list[Line]) -> Iterator[Change]:
    """Yield which lines draw something else, are gone, are called otherwise, or cannot be seen."""
    if any(match.lost(area) for line in fresh for area in line[:2]):
        return
    free, missing = list(held), []
    for line in fresh:
        if (same := next((one for one in free if same_columns(match, line, one)), None)) is None:
            missing.append(line)
            continue
        free.remove(same)
        if not same_name(match, line.name, same.name) and (same.name or len(fresh) > 1):
            others = [one.name for one in fresh if one is not line]
            exchanged = any(same_name(match, other, same.name) for other in others)
            yield SHOWN if exchanged else NOTICE, name_text(same.name), name_text(line.name), ", the name of a line"
        for said in same.said - line.said:
            yield NOTICE, said, "as built", f", its line {name_as_text(match, line.name)!r}"
    for line in missing:
        what, named = f", its line {name_as_text(match, line.name)!r}", [one for one in free if one.name == line.name]
        if (other := next(iter(named or free), None)) is not None:
            free.remove(other)
        yield SHOWN if other else NOTICE, str(other) if other else None, str(line), what
    for one in free:
        if one.name and any(same_name(match, line.name, one.name) for line in fresh):
            yield SHOWN, str(one), "a name of its own", f", another line called {name_text(one.name)!r}"


def axis_changes(axis: Axis, ours: Axis, values: list[float], what: str) -> Iterator[Change]:
    """Yield what of an axis is read otherwise; along one without figures as built, how they would look is not."""
    bare = ours.code == NOTHING
    for said in (axis.said ^ ours.said) - ({"not shown"} if bare or "not shown" not in axis.said else set()):
        kind, found = SHOWN if said in permitted.ALTERING else NOTICE, said if said in axis.said else f"not {said}"
        yield kind, found, "as built", what
    span = max(values, default=0.0) - min(values, default=0.0)
    for end, limit in axis.ends.items():
        least = ours.ends.get(end)
        inside = -1e-6 * span + (limit - min(values) if end == "min" else max(values) - limit) if values else 0.0
        if (inside > 0) if least is None else not math.isclose(limit, least, rel_tol=1e-9, abs_tol=1e-12):
            yield SHOWN, limit, "left to the program" if least is None else least, f"{what}, {end}"
    kind, wrong = format_remark(axis.code, ours.code)
    if kind and not (bare and axis.code == "General"):
        yield kind, wrong, "as they are", f"{what}, the numbers"


def title_changes(match: Match, held: Name, ours: Name, other: Name, what: str) -> Iterator[Change]:
    """Yield that the title of an axis is another: that of the ``other`` axis, or one with another unit, misleads."""
    if not same_name(match, ours, held):
        text = name_as_text(match, ours)
        units_named = [UNIT.search(one) for one in (name_text(held), text)]
        differ = all(units_named) and compare_units(*(one[1] for one in units_named if one)) == "other"
        misleads = isinstance(held, str) and (held == name_as_text(match, other) or differ)
        yield SHOWN if misleads else NOTICE, name_text(held), text, f", the title of {what}"


def name_as_text(match: Match, name: Name) -> str:
    """Return a name of a fresh build; of one that follows a cell, the cell's text."""
    return name if isinstance(name, str) else str(match.declared_value(name.first))


def same_name(match: Match, fresh: Name, held: Name) -> bool:
    """Whether a name is that of a fresh build; one that follows a cell becomes its text where LibreOffice saves it."""
    if isinstance(held, str):
        return held == name_as_text(match, fresh)
    return not isinstance(fresh, str) and match.same(fresh, held)


def finite_numbers(match: Match, area: Area | None) -> list[float]:
    """Return the finite numbers of a declared column."""
    if area is None:
        return []
    values = (match.declared_value(Address(area.sheet, row, area.left)) for row in range(area.top, area.bottom + 1))
    return [float(v) for v in values if isinstance(v, int | float) and math.isfinite(v)]


def sight_changes(
    match: Match, fresh: ChartData, found: ChartData, cm: tuple[float, float], pages: Mapping[str, SheetView]
) -> Iterator[Change]:
    """Yield that a chart can hardly be seen: shrunk, behind another drawing, or by hidden rows; ``cm`` is its size."""
    areas = pages[found.at.sheet].areas
    own = areas[found.number]
    ends = (own.right - own.left, own.bottom - own.top)
    rooms = [min(1.0, held / ours) for held, ours in zip(found.room, fresh.room, strict=True)]
    share = min(room * end / (whole * CM) for room, end, whole in zip(rooms, ends, cm, strict=True))
    if share < permitted.SMALL_CHART:
        yield SHOWN if share < permitted.LEAST_CHART else NOTICE, f"{share:.0%} of its size", "as built", ", its size"
    if above := [k for k in range(found.number + 1, len(areas)) if own.shared(areas[k]) > permitted.BEHIND]:
        titles = {one.number: one.title for one in read_charts(match, found.at.sheet)}
        alike = any(titles.get(k, found.title) == found.title for k in above)
        yield SHOWN if alike else NOTICE, "behind another drawing", "in sight", ""
    columns = [a for line in found.lines for a in line[:2] if a is not None and a.sheet in pages]
    rows = ([r for r in range(a.top, a.bottom + 1) if pages[a.sheet].rows.hidden(r)] for a in columns)
    hidden = max(map(len, rows), default=0)
    if found.visible_only and hidden:
        yield SHOWN, f"without {hidden:,} hidden rows", "with all rows", ", what it draws"
