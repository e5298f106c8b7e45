"""What the drives tell the sheet Selection: a row each, the named one by its cells, and its points."""

from collections.abc import Sequence
from typing import Any

from engine.drive.quadrature import COUNT
from engine.laws.base import Array
from engine.selection.pair_matrix import gears
from workbook.book.chart import in_scope
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.entries.units import RPM, shown
from workbook.selection.choosing import AS_ENTERED, Choosing
from workbook.selection.shaft import MIXED, SQUARE


def drives_table(sheet: Sheet, view: Choosing) -> None:
    """Declare the drives that may be named."""
    columns = list(zip(*(one.figures for one in view.shafts), strict=True))
    sheet.table(
        "@drives", "Drives", len(view.shafts),
        calc("axis", "axis", "", "", [one.title for one in view.shafts], [one.name for one in view.shafts],
             align="left"),
        constant("k", "number of the axis", "k", "", [one.number for one in view.shafts]),
        *(calc(each[0].name, each[0].label, "", each[0].unit, [f"={one.formula}+0" for one in each],
               [one.value for one in each], scale=max(one.scale for one in each)) for each in columns),
    )  # fmt: skip


def known(view: Choosing) -> str:
    """Return the condition under which the axis that is named is one of them."""
    return "ISNUMBER(@no)" if len(view.shafts) > 1 else "[@drives.axis.1]=@axis"


def chosen(sheet: Sheet, view: Choosing) -> None:
    """Declare the named drive."""
    number = "MATCH(@axis,[@drives.axis],0)" if len(view.shafts) > 1 else "COUNT([@drives.k])"
    taken = "INDEX([@drives.{}],@no)" if len(view.shafts) > 1 else "[@drives.{}.1]"  # no single cell is looked up alike
    rows = [calc("@no", "Row of the axis", "", "", f"={number}", view.number + 1, format="0")]
    for each in zip(*(one.figures for one in view.shafts), strict=True):
        name, label, unit, _, value, _ = each[view.number]
        rows.append(calc(f"@{name}", label.capitalize(), "", unit, f"={taken.format(name)}+0", value,
                         scale=max(one.scale for one in each)))  # fmt: skip
    sheet.rows(*rows, *held(view))


def held(view: Choosing) -> Sequence[Quantity]:
    """Return what the drive's reducer makes of the load, and the names of motor and reducer."""
    own, load = {"eta": "@held_eta", "i": "@held_i", "own": "@held_no_load"}, view.load
    motor, reducer = view.held_names
    pair = gears(0.0, *(view.held(name) for name in ("i", "eta", "no_load")))
    return [
        calc("@held_mixed", "Mean of ω̇ S at its motor, with losses", "", "W/s", f"={MIXED.format(**own)}",
             float(load.mixed(pair)[0]), scale=view.shaft.product),
        calc("@held_square", "Mean square torque at its motor, without inertia", "", "N²m²",
             f"={SQUARE.format(**own)}", float(load.square(pair)[0]), scale=view.shaft.torque**2),
        calc("@held_motor", "Its motor", "", "",
             f'=IF(@held_row=0,"{AS_ENTERED}",INDEX([motors.name],MAX(1,@held_row)))', motor, align="left"),
        calc("@held_reducer", "Its reducer", "", "",
             f'=IF(@held_gear=0,"{AS_ENTERED}",INDEX([reducers.name],MAX(1,@held_gear)))', reducer, align="left"),
    ]  # fmt: skip


def points_table(sheet: Sheet, view: Choosing) -> None:
    """Declare the points of the named drive."""
    shaft, load, of = view.shaft, view.load.points, view.shaft.by_point
    behind, rows = shaft.torque, list(range(1, shaft.rows * COUNT + 1))
    sheet.row += 1
    sheet.table(
        "@points", "The points of its cycle", len(rows),
        constant("k", "number", "", "", rows),
        *named(view, "dir", "direction", "", "", view.load.load.direction, format="0"),
        *named(view, "al", "acceleration", "ω̇", "rad/s²", load.acceleration, "@turns*{}", scale=shaft.turning),
        *named(view, "S", "output torque of the reducer", "S", "Nm", load.driving + load.driven,
               "{}*(1-@brake*([dir]=0))", scale=behind, source="0 where a brake holds the motor"),
        *named(view, "n", "speed of the shaft", "|n|", "rpm", shown(load.speed, RPM), shaft.rpm,
               scale=max(float(shown(load.speed.max(), RPM)), 1e-3)),
        calc("driving", "where it drives the load", "", "Nm", "=IF(@by_power*[S]*[dir]<0,0,[S])", of(load.driving),
             scale=behind),
        calc("driven", "where the load drives the motor", "", "Nm", "=[S]-[driving]", of(load.driven), scale=behind),
    )  # fmt: skip
    names = {in_scope(f"@{name}", sheet.scope): name for name in ("dir", "al", "n")}
    names |= {in_scope("@out", sheet.scope): "driving", in_scope("@back", sheet.scope): "driven"}
    sheet.book.name(in_scope("@points", sheet.scope), **names)


GROUP = 5
"""drives among which one formula chooses"""


def named(
    view: Choosing, column: str, label: str, symbol: str, unit: str, values: Array, whole: str = "{}", **more: Any
) -> list[Quantity]:  # fmt: skip
    """Return the column of a figure of the named drive; of many drives, one for each group of them before it.

    ``whole`` is what the formula of the figure stands in.
    """
    names = [f"INDEX({one.columns}_{column},[k])" for one in view.shafts]
    chosen = view.shaft.by_point(values)
    if len(names) == 1:
        return [calc(column, label, symbol, unit, f"={whole.format(names[0])}", chosen, **more)]
    if len(names) <= GROUP:
        one = whole.format(f"CHOOSE(@no,{','.join(names)})")
        return [calc(column, label, symbol, unit, f"={one}", chosen, **more)]
    found = []
    for first in range(0, len(names), GROUP):
        group = names[first : first + GROUP]
        last = first + len(group)
        one = whole.format(f"CHOOSE(@no-{first},{','.join(group)})")
        found.append(
            calc(f"{column}{first + 1}", f"{label}, drives {first + 1} to {last}", symbol, unit,
                 f"=IF(AND(@no>{first},@no<={last}),{one},0)", chosen if first <= view.number < last else 0.0, **more)
        )  # fmt: skip
    parts = "+".join(f"[{one.name}]" for one in found)
    return [*found, calc(column, label, symbol, unit, f"={parts}", chosen, **more)]
