"""The drives on the sheet Selection: a row each, the named drive by its cells and points, each behind its reducer."""

import re
from typing import Any

from engine.laws.base import Array
from engine.laws.points import POINTS
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import in_scope
from workbook.book.declare import Quantity, Sheet, Text
from workbook.book.rows import filled
from workbook.fields.units import RPM, shown
from workbook.selection.grids import LARGE
from workbook.selection.pair_selection import AS_ENTERED, FIGURES, MIXED, SQUARE, PairSelection

CELLS = cell_tables(__file__)

OWN = {"eta": "@held_eta", "i": "@held_i", "own": "@held_no_load"}


def named_drive(sheet: Sheet, view: PairSelection) -> None:
    """Declare the named drive, and all that may be named."""
    cell = CELLS["named_drive"]
    several = len(view.shafts) > 1
    number = "MATCH(@axis,[@drives.axis],0)" if several else "COUNT([@drives.k])"
    # no single cell is looked up alike
    taken = "INDEX([@drives.{}],@no)" if several else "[@drives.{}.1]"
    columns = list(zip(*(shaft.figures for shaft in view.shafts), strict=True))
    scales = [max(figure.scale for figure in column) for column in columns]
    sheet.rows(
        cell("@no", view.number + 1, number=number),
        *(
            cell(
                "@{name}",
                figure.value,
                name=figure.name,
                label=figure.label.capitalize(),
                unit=figure.unit,
                taken=taken.format(figure.name),
                scale=scale,
            )
            for figure, scale in zip(view.shaft.figures, scales, strict=True)
        ),
        *([cell("@last", view.shaft.rows * POINTS)] if view.is_ragged else []),
    )
    points = [shaft.rows * POINTS for shaft in view.shafts]
    cell = CELLS["drives"]
    cell.place(
        sheet,
        cell("axis", [shaft.name for shaft in view.shafts], title=[shaft.title for shaft in view.shafts]),
        *cell.of_rows(view.shafts, k="number"),
        *(
            FIGURES(
                column[0].name,
                [figure.value for figure in column],
                formula=[f"={figure.formula}+0" for figure in column],
                scale=scale,
            )
            for column, scale in zip(columns, scales, strict=True)
        ),
        *([cell("last", points, columns=[shaft.columns for shaft in view.shafts])] if view.is_ragged else []),
    )


def points_table(sheet: Sheet, view: PairSelection) -> None:
    """Declare the points of the named drive."""
    cell = CELLS["points"]
    shaft, load, of = view.shaft, view.load.points, view.by_point
    speed, rows = shown(load.speed, RPM), list(range(1, view.point_rows + 1))
    sheet.row += 1
    cell.place(
        sheet,
        cell("k", rows),
        *named_figure(view, "dir", view.load.load.direction),
        *named_figure(view, "al", load.acceleration, "@turns*{}", scale=shaft.turning),
        *named_figure(view, "S", load.driving + load.driven, "{}*(1-@brake*([dir]=0))", scale=shaft.torque),
        *named_figure(view, "n", speed, shaft.rpm, scale=max(float(speed.max()), 1e-3)),
        cell("driving", of(load.driving), scale=shaft.torque),
    )
    names = {"dir": "dir", "al": "al", "n": "n", "out": "driving", "all": "S"}
    scoped = {in_scope(f"@{name}", sheet.scope): column for name, column in names.items()}
    sheet.book.name(in_scope("@points", sheet.scope), **scoped)


GROUP = 5  # drives among which a single formula chooses


def named_figure(
    view: PairSelection, name: str, values: Array, whole: str = "{}", scale: float = 0.0
) -> list[Quantity]:
    """Return the column of a figure, within ``whole``, of the named drive; of many, a column for each group before."""
    cell = CELLS["points"]
    names = [f"INDEX({shaft.columns}_{name},[k])" for shaft in view.shafts]
    column, has_point = view.by_point(values), ",[k]<=@last" * view.is_ragged
    if len(names) <= GROUP:
        figure = whole.format(f"CHOOSE(@no,{','.join(names)})" if len(names) > 1 else names[0])
        figure = f"IF([k]<=@last,{figure},0)" if view.is_ragged else figure
        return [cell(name, column, figure=figure, scale=scale)]
    groups = []
    for first in range(0, len(names), GROUP):
        chosen = names[first : first + GROUP]
        last = first + len(chosen)
        choice = whole.format(f"CHOOSE(@no-{first},{','.join(chosen)})")
        figure = f"IF(AND(@no>{first},@no<={last}{has_point}),{choice},0)"
        group = cell(name, column if first <= view.number < last else 0.0, figure=figure, scale=scale)
        label = f"{group.label}, drives {first + 1} to {last}"
        groups.append(group._replace(name=f"{name}{first + 1}", label=label))
    return [*groups, cell(name, column, figure="+".join(f"[{group.name}]" for group in groups), scale=scale)]


LINKS = 11  # the column of links to the sheets of drives


def every_drive(sheet: Sheet, view: PairSelection) -> None:
    """Declare a row a drive: its pair, the motors that can do it behind its reducer, and a link to its choice."""
    cell = CELLS["each"]
    drives, names = view.every_drive, view.motors.names
    usable = [drive.usable_behind_own for drive in drives]
    motors, reducers = zip(*(drive.names_in_use for drive in drives), strict=True)
    counts = [f'=COUNTIF([@all_word{n}.v],"yes")' for n in range(1, len(drives) + 1)]
    behind_own = [
        cell("can", [len(each) for each in usable], formula=counts),
        cell("smallest", [names[each[0]] if each else "none" for each in usable]),
    ]
    sheet.row += 1
    block = cell.place(
        sheet,
        cell("axis", [drive.shaft.name for drive in drives]),
        cell("motor", motors, as_entered=AS_ENTERED),
        *(behind_own if len(drives) > 1 else ()),
        cell("reducer", reducers, as_entered=AS_ENTERED),
    )
    for row, drive in enumerate(drives, block.row):
        called = f"Drive {drive.shaft.name}"
        title = next((other.title for other in sheet.book.sheets if other.called == called), "")
        sheet.texts.append(Text(row, LINKS, "choose on its sheet", "link", title))


def motors_by_drives(sheet: Sheet, view: PairSelection) -> None:
    """Declare what each motor has to do behind the reducer of each drive, and what it fails first."""
    each = [drive.behind_own for drive in view.every_drive]
    use = max(1.0, *(float(behind_own.uses.max()) for behind_own in each))
    torque = max(1e-3, *(float(behind_own.peak.max()) for behind_own in each))
    loads(sheet, view)
    matrix(sheet, view, "share", "uses", 0.0, scale=use)
    matrix(sheet, view, "peak", "peak", 0.0, scale=torque)
    matrix(sheet, view, "wanted", "wanted_verdicts", LARGE)
    matrix(sheet, view, "word", "verdicts", "–")


def loads(sheet: Sheet, view: PairSelection) -> None:
    """Declare what the reducer of each drive makes of its load."""
    cell = CELLS["behind"]
    drives, down = view.every_drive, view.rooms[0]
    beyond = down * (down + 1)
    smallest = [min((place_of(view, k) for k in drive.usable_behind_own), default=beyond) for drive in drives]
    mixed, square = zip(*(drive.means_behind_own for drive in drives), strict=True)
    product, torque = (max(getattr(drive.shaft, name) for drive in drives) for name in ("product", "torque"))
    sheet.row += 1
    cell.place(
        sheet,
        *cell.of_rows(drives, axis="shaft.name"),
        cell("j", [drive.in_use("j") - drive.in_use("jm") for drive in drives]),
        cell("at", [drive.behind_own.at_motor[0] for drive in drives]),
        cell("turn", [drive.in_use("i") * drive.shaft.values["turns"] for drive in drives]),
        cell("fast", [shown(drive.behind_own.speed[0] * drive.requirements.least_speed, RPM) for drive in drives]),
        cell("mean", [shown(drive.load.mean_speed * drive.in_use("i"), RPM) for drive in drives]),
        cell("left", [drive.shaft.values["left"] / view.shaft.values["left"] for drive in drives]),
        cell("mixed", mixed, formula=of_drive(MIXED.format(**OWN)), scale=product),
        cell("square", square, formula=of_drive(SQUARE.format(**OWN)), scale=torque**2),
        cell("least", smallest, beyond=beyond, n=list(range(1, len(drives) + 1))),
    )


def place_of(view: PairSelection, motor: int) -> int:
    """Return a number by which motors are in the order of their rated torque, then of the catalogue."""
    return int(view.grid.smaller[motor]) * view.rooms[0] + motor + 1


def of_drive(formula: str) -> str:
    """Return a formula of figures of a drive in the row of the same number."""
    return "=" + re.sub(r"@(\w+)", r"[@drives.\1.same]", formula)


def matrix(
    sheet: Sheet,
    view: PairSelection,
    name: str,
    figure: str,
    spare: Any,
    scale: float = 0.0,
) -> None:
    """Declare a table of motors down and drives across, of a figure of the motors behind the drives' own reducers."""
    cell = CELLS["motors by drives"]
    down, names = view.rooms[0], view.motors.names
    order = [place_of(view, k) if k < len(names) else k + 1 for k in range(down)]
    sheet.row += 1
    rows = cell.sharing(name=name, title=CELLS[f"drives: {name}"].head[1]).place(
        sheet,
        cell("motor", filled(names, down, "")),
        cell("k", list(range(1, down + 1))),
        *([cell("order", order, down=down)] if name == "word" else []),
    )
    for n, drive in enumerate(view.every_drive, 1):
        values = filled(getattr(drive.behind_own, figure)[:, 0], down, spare)
        cells = CELLS[f"drives: {name}"].sharing(n=n, number=drive.shaft.number, columns=drive.shaft.columns)
        each = cells("v", values, scale=scale)
        sheet.beside(rows, f"@all_{name}{n}", each)
