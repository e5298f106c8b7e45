"""What the drives tell the sheet Selection: a row each, the named one by its cells, and its points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from engine.laws.base import Array
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.entries.units import RPM, shown
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.selecting.behind import scales_of
from workbook.machines.machine.selecting.view import AS_ENTERED, Choosing


def figures_told(view: Choosing) -> list[tuple[str, str, str, str]]:
    """Return of each figure of a drive: its name, label and unit, and its formula on the sheet of the drive."""
    spare = "@spare" if view.view.knows_falling else "@motor_peak-MAX(@tmax,0-@tmin)"
    return [
        ("own", "mean of α²", "rad²/s⁴", "@ask_own"),
        ("square", "mean of S², driving", "Nm²", "@ask_square"),
        ("square_back", "… driven", "Nm²", "@ask_square_back"),
        ("product", "mean of α S, driving", "W/s", "@ask_product"),
        ("product_back", "… driven", "W/s", "@ask_product_back"),
        ("speed", "largest speed", "rad/s", "@ask_speed"),
        ("smax", "largest torque", "Nm", "@smax"),
        ("inertia", "inertia", "kg m²", "@ask_inertia"),
        ("beside", "parts beside the motor", "kg m²", "@ask_beside"),
        ("brake", "a brake holds it at rest", "", '(@holding="brake")'),
        ("by_power", "losses by the flow of power", "", '(@method="physical")'),
        ("left", "rated torque left at its temperature", "", "@derate"),
        ("held_j", "inertia with its motor", "kg m²", "@j0"),
        ("held_jm", "its motor", "kg m²", "@jm"),
        ("held_i", "its reduction", "", "@i1"),
        ("held_eta", "its efficiency", "", "@eta1"),
        ("held_rated", "its rated torque", "Nm", "@motor_rated"),
        ("held_peak", "its peak torque", "Nm", "@motor_peak"),
        ("held_top", "what it is asked for", "Nm", "MAX(@tmax,0-@tmin)"),
        ("held_spare", "left below its curve", "Nm", spare),
        ("held_nmax", "its largest speed", "rpm", "@motor_nmax"),
        ("held_row", "its row of motors", "", "@motor_row"),
        ("held_gear", "its row of reducers", "", "@reducer_row"),
    ]


def drives_table(sheet: Sheet, view: Choosing) -> None:
    """Declare the drives that may be named."""
    drives = [one.driven for one in view.drives]

    def scoped(formula: str, driven: Driven) -> str:
        return f"={formula.replace('@', f'drive{driven.number}_')}+0"

    sheet.table(
        "@drives", "Drives", len(drives),
        calc("axis", "axis", "", "", [f"=[axes.name.{one.number}]" for one in drives],
             [one.entered.name for one in drives], align="left"),
        constant("k", "number of the axis", "k", "", [one.number for one in drives]),
        *(calc(name, label, "", unit, [scoped(formula, one) for one in drives], values, scale=scale)
          for (name, label, unit, formula), (values, scale) in zip(figures_told(view), view.figures, strict=True)),
    )  # fmt: skip


def taken(view: Choosing, column: str) -> str:
    """Return the formula of a figure of the named drive; no program looks up in a single cell alike."""
    return f"INDEX([@drives.{column}],@no)" if len(view.drives) > 1 else f"[@drives.{column}.1]"


def known(view: Choosing) -> str:
    """Return the condition under which the axis that is named is one of them."""
    return "ISNUMBER(@no)" if len(view.drives) > 1 else "[@drives.axis.1]=@axis"


def chosen(sheet: Sheet, view: Choosing) -> None:
    """Declare the named drive."""
    number = "MATCH(@axis,[@drives.axis],0)" if len(view.drives) > 1 else "COUNT([@drives.k])"
    rows = [calc("@no", "Row of the axis", "", "", f"={number}", view.number + 1, format="0")]
    for (name, label, unit, _), (values, scale) in zip(figures_told(view), view.figures, strict=True):
        rows.append(calc(f"@{name}", label.capitalize(), "", unit, f"={taken(view, name)}+0", values[view.number],
                         scale=scale))  # fmt: skip
    sheet.rows(*rows, *held(view))


def held(view: Choosing) -> Sequence[Quantity]:
    """Return the names of the motor and the reducer of the drive."""
    return [
        calc("@held_motor", "Its motor", "", "",
             f'=IF(@held_row=0,"{AS_ENTERED}",INDEX([motors.name],MAX(1,@held_row)))', view.held_motor, align="left"),
        calc("@held_reducer", "Its reducer", "", "",
             f'=IF(@held_gear=0,"{AS_ENTERED}",INDEX([reducers.name],MAX(1,@held_gear)))', view.held_reducer,
             align="left"),
    ]  # fmt: skip


def points_table(sheet: Sheet, view: Choosing) -> None:
    """Declare the points of the named drive."""
    load, drive, scale = view.load.points, view.view, scales_of(view.view)
    behind, rows = drive.scales.behind, list(range(1, view.rows + 1))
    sheet.row += 1
    sheet.table(
        "@points", "The points of its cycle", len(rows),
        constant("k", "number", "", "", rows),
        *named(view, "dir", "direction", "", "", drive.load.direction, format="0"),
        *named(view, "al", "acceleration", "α", "rad/s²", load.acceleration, scale=scale.alpha),
        *named(view, "S", "torque behind the reducer", "S", "Nm", drive.load.behind, scale=behind),
        *named(view, "n", "speed of its motor", "|n|", "rpm", np.abs(shown(drive.points.speed, RPM)), "ABS({})",
               scale=drive.scales.rpm),
        calc("driving", "where it drives the load", "", "Nm",
             "=IF(OR(@by_power*[S]*[dir]<0,AND([dir]=0,@brake=1)),0,[S])", view.by_point(load.driving), scale=behind,
             source="none that a brake holds"),
        calc("driven", "where the load drives it", "", "Nm", "=IF(@by_power*[S]*[dir]<0,[S],0)",
             view.by_point(load.driven), scale=behind),
    )  # fmt: skip


GROUP = 6
"""drives among which one formula chooses"""


def named(
    view: Choosing, column: str, label: str, symbol: str, unit: str, values: Array, whole: str = "{}", **more: Any
) -> list[Quantity]:  # fmt: skip
    """Return the column of a figure of the named drive; of many drives, one for each group of them before it.

    ``whole`` is what the formula of the figure stands in.
    """
    names = [f"INDEX(drive{one.driven.number}_{column},[k])" for one in view.drives]
    chosen = view.by_point(values)
    if len(names) == 1:
        return [calc(column, label, symbol, unit, f"={whole.format(names[0])}+0", chosen, **more)]
    if len(names) <= GROUP:
        return [
            calc(column, label, symbol, unit, f"={whole.format(f'CHOOSE(@no,{chr(44).join(names)})')}", chosen, **more)
        ]
    found = []
    for first in range(0, len(names), GROUP):
        group = names[first : first + GROUP]
        within = f"AND(@no>{first},@no<={first + len(group)})"
        here = first <= view.number < first + len(group)
        found.append(
            calc(
                f"{column}{first + 1}",
                f"{label}, drives {first + 1} to {first + len(group)}",
                symbol,
                unit,
                f"=IF({within},{whole.format(f'CHOOSE(@no-{first},{chr(44).join(group)})')},0)",
                chosen if here else 0.0,
                **more,
            )
        )
    parts = "+".join(f"[{one.name}]" for one in found)
    return [*found, calc(column, label, symbol, unit, f"={parts}", chosen, **more)]
