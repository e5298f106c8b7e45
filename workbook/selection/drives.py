"""The drives on the sheet Selection: a row each, the named one by its cells and points, each behind its reducer."""

import re
from collections.abc import Callable
from typing import Any

from engine.laws.base import Array
from engine.laws.points import POINTS
from workbook.book.chart import in_scope
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.fields.units import RPM, shown
from workbook.selection.grids import DASH, LARGE, continuous, first_failure, margin_verdict, of_motor
from workbook.selection.pair_selection import AS_ENTERED, MIXED, SQUARE, PairSelection, rms_of

OWN = {"eta": "@held_eta", "i": "@held_i", "own": "@held_no_load"}


def named_drive(sheet: Sheet, view: PairSelection) -> None:
    """Declare the named drive, what its reducer makes of the load, its motor and reducer; all that may be named."""
    number = "MATCH(@axis,[@drives.axis],0)" if len(view.shafts) > 1 else "COUNT([@drives.k])"
    taken = "INDEX([@drives.{}],@no)" if len(view.shafts) > 1 else "[@drives.{}.1]"  # no single cell is looked up alike
    columns = list(zip(*(one.figures for one in view.shafts), strict=True))
    scales = [max(one.scale for one in each) for each in columns]
    motor, reducer = view.names_in_use
    sheet.rows(
        calc("@no", "Row of the axis", "", "", f"={number}", view.number + 1, format="0"),
        *(calc(f"@{name}", label.capitalize(), "", unit, f"={taken.format(name)}+0", value, scale=scale)
          for (name, label, unit, _, value, _), scale in zip(view.shaft.figures, scales, strict=True)),
        calc("@held_mixed", "Mean of ω̇ S at its motor, with losses", "", "W/s", f"={MIXED.format(**OWN)}",
             float(view.load.mixed(view.own_reducer)[0]), scale=view.shaft.product),
        calc("@held_square", "Mean square torque at its motor, without inertia", "", "N²m²", f"={SQUARE.format(**OWN)}",
             float(view.load.square(view.own_reducer)[0]), scale=view.shaft.torque**2),
        calc("@held_motor", "Its motor", "", "",
             f'=IF(@held_row=0,"{AS_ENTERED}",INDEX([motors.name],MAX(1,@held_row)))', motor, align="left"),
        calc("@held_reducer", "Its reducer", "", "",
             f'=IF(@held_gear=0,"{AS_ENTERED}",INDEX([reducers.name],MAX(1,@held_gear)))', reducer, align="left"),
    )  # fmt: skip
    sheet.table(
        "@drives", "Drives", len(view.shafts),
        calc("axis", "axis", "", "", [one.title for one in view.shafts], [one.name for one in view.shafts],
             align="left"),
        constant("k", "number of the axis", "k", "", [one.number for one in view.shafts]),
        *(calc(each[0].name, each[0].label, "", each[0].unit, [f"={one.formula}+0" for one in each],
               [one.value for one in each], scale=scale) for each, scale in zip(columns, scales, strict=True)),
    )  # fmt: skip


def points_table(sheet: Sheet, view: PairSelection) -> None:
    """Declare the points of the named drive."""
    shaft, load, of = view.shaft, view.load.points, view.shaft.by_point
    behind, rows = shaft.torque, list(range(1, shaft.rows * POINTS + 1))
    sheet.row += 1
    sheet.table(
        "@points", "The points of its cycle", len(rows),
        constant("k", "number", "", "", rows),
        *named_figure(view, "dir", "direction", "", "", view.load.load.direction, format="0"),
        *named_figure(view, "al", "acceleration", "ω̇", "rad/s²", load.acceleration, "@turns*{}", scale=shaft.turning),
        *named_figure(view, "S", "output torque of the reducer", "S", "Nm", load.driving + load.driven,
               "{}*(1-@brake*([dir]=0))", scale=behind, source="0 where a brake holds the motor"),
        *named_figure(view, "n", "speed of the shaft", "|n|", "rpm", shown(load.speed, RPM), shaft.rpm,
               scale=max(float(shown(load.speed.max(), RPM)), 1e-3)),
        calc("driving", "where it drives the load", "", "Nm", "=IF(@by_power*[S]*[dir]<0,0,[S])", of(load.driving),
             scale=behind),
        calc("driven", "where the load drives the motor", "", "Nm", "=[S]-[driving]", of(load.driven), scale=behind),
    )  # fmt: skip
    names = {in_scope(f"@{name}", sheet.scope): name for name in ("dir", "al", "n")}
    names |= {in_scope("@out", sheet.scope): "driving", in_scope("@back", sheet.scope): "driven"}
    sheet.book.name(in_scope("@points", sheet.scope), **names)


GROUP = 5  # drives among which one formula chooses


def named_figure(
    view: PairSelection, column: str, label: str, symbol: str, unit: str, values: Array, whole: str = "{}", **more: Any
) -> list[Quantity]:
    """Return the column of a figure, within ``whole``, of the named drive; of many, one for each group before it."""
    names = [f"INDEX({one.columns}_{column},[k])" for one in view.shafts]
    chosen = view.shaft.by_point(values)
    if len(names) <= GROUP:
        one = f"CHOOSE(@no,{','.join(names)})" if len(names) > 1 else names[0]
        return [calc(column, label, symbol, unit, f"={whole.format(one)}", chosen, **more)]
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


NAMED = '=IF([@drives.{0}.same]=0,"{1}",INDEX([{2}.name],MAX(1,[@drives.{0}.same])))'
ABOUT = "Behind the reducer that the drive has, whose own limits are checked on the sheet of the drive."


def every_drive(sheet: Sheet, view: PairSelection) -> None:
    """Declare the table of all drives: the pair of each, and the motors that can do it behind its reducer."""
    drives = view.every_drive
    motors, reducers = zip(*(one.names_in_use for one in drives), strict=True)
    numbers = range(1, len(drives) + 1)
    sheet.heading("All drives", ABOUT)
    sheet.table(
        "@each", "All drives, each behind the reducer that it has", len(drives),
        result("axis", "axis", "", "", '=[@drives.axis.same]&""', [one.shaft.name for one in drives], align="left"),
        constant("k", "number of the axis", "", "", [one.shaft.number for one in drives]),
        result("can", "motors that can do it", "", "", [f'=COUNTIF([@all_word{n}.v],"yes")' for n in numbers],
               [len(one.usable_behind_own) for one in drives], format="0"),
        result("smallest", "the smallest of them", "", "",
               '=IF([can]=0,"none",INDEX([motors.name],MATCH([@behind.least.same],[@all_word.order],0)))',
               [view.motors.names[one.usable_behind_own[0]] if one.usable_behind_own else "none" for one in drives],
               align="left"),
        result("motor", "motor in use", "", "", NAMED.format("held_row", AS_ENTERED, "motors"), motors, align="left"),
        result("reducer", "reducer in use", "", "", NAMED.format("held_gear", AS_ENTERED, "reducers"), reducers,
               align="left"),
    )  # fmt: skip


def motors_by_drives(sheet: Sheet, view: PairSelection) -> None:
    """Declare what each motor has to do behind the reducer of each drive, and what it fails first."""
    drives, each = view.every_drive, [one.behind_own for one in view.every_drive]
    loads(sheet, view)
    matrix(sheet, view, "share", "Their RMS torque over their continuous torque", share, "uses", 0.0, format=DASH,
           scale=max(1.0, *(float(one.uses.max()) for one in each)))  # fmt: skip
    matrix(sheet, view, "peak", "Their peak torque [Nm]", lambda n: peak(n, drives[n - 1]), "peak", 0.0, format=DASH,
           scale=max(1e-3, *(float(one.peak.max()) for one in each)))  # fmt: skip
    limit = "[@drives.{{}}.{}]".format
    matrix(sheet, view, "wanted", "What is wanted of them",
           lambda n: margin_verdict("all_", n, "@behind.at", limit(n)),
           "wanted_verdicts", LARGE, align="center")  # fmt: skip
    matrix(sheet, view, "word", "What they fail first; yes: they can do it",
           lambda n: f'IF({of_motor("on")}=0,"–",{first_failure("all_", n, "@behind.fast", limit(n))})',
           "verdicts", "–", align="center")  # fmt: skip


def loads(sheet: Sheet, view: PairSelection) -> None:
    """Declare what the reducer of each drive makes of its load."""
    drives = view.every_drive
    product, square = max(one.shaft.product for one in drives), max(one.shaft.torque**2 for one in drives)
    down = view.rooms[0]
    beyond = down * (down + 1)
    smallest = [one.usable_behind_own[:1] for one in drives]
    inertia = [one.in_use("j") - one.in_use("jm") for one in drives]
    speed = [one.behind_own.speed[0] for one in drives]
    mean = [one.load.mean_speed * one.in_use("i") for one in drives]
    sheet.row += 1
    sheet.table(
        "@behind", "What the reducer of each drive makes of its load", len(drives),
        calc("axis", "axis", "", "", '=[@drives.axis.same]&""', [one.shaft.name for one in drives], align="left"),
        calc("j", "inertia without the motor", "", "kg m²", of_drive("@held_j-@held_jm"), inertia),
        calc("at", "with the load's", "", "kg m²", of_drive("[j]+@inertia/@held_i^2"),
             [one.behind_own.at_motor[0] for one in drives]),
        calc("turn", "acceleration over that of its points", "", "", of_drive("@turns*@held_i"),
             [one.in_use("i") * one.shaft.values["turns"] for one in drives]),
        calc("fast", "largest speed, with its reserve", "", "rpm", of_drive("@speed*@held_i*30/PI()*@speed_reserve"),
             [shown(of_one * one.requirements.least_speed, RPM) for one, of_one in zip(drives, speed, strict=True)]),
        calc("mean", "mean speed", "", "rpm", of_drive("@mean*@held_i*30/PI()"), [shown(one, RPM) for one in mean]),
        calc("left", "rated torque over that of the named drive", "", "", of_drive("@left") + "/@left",
             [one.shaft.values["left"] / view.shaft.values["left"] for one in drives]),
        calc("mixed", "mean of ω̇ S, with losses", "", "W/s", of_drive(MIXED.format(**OWN)),
             [float(one.load.mixed(one.own_reducer)[0]) for one in drives], scale=product),
        calc("square", "mean square torque of the load at the motor", "", "N²m²", of_drive(SQUARE.format(**OWN)),
             [float(one.load.square(one.own_reducer)[0]) for one in drives], scale=square),
        calc("least", "the smallest motor's place by rated torque", "", "",
             [f'={beyond}-SUMPRODUCT(MAX(([@all_word{n}.v]="yes")*({beyond}-[@all_word.order])))'
              for n in range(1, len(drives) + 1)],
             [place_of(view, *k) if k else beyond for k in smallest], format="0"),
    )  # fmt: skip


def place_of(view: PairSelection, motor: int) -> int:
    """Return a number by which motors are in the order of their rated torque, then of the catalogue."""
    return int(view.grid.smaller[motor]) * view.rooms[0] + motor + 1


def of_drive(formula: str) -> str:
    """Return a formula of figures of a drive in the row of the same number."""
    return "=" + re.sub(r"@(\w+)", r"[@drives.\1.same]", formula)


def matrix(
    sheet: Sheet, view: PairSelection, name: str, title: str, formula: Callable[[int], str], figure: str, spare: Any,
    **more: Any,
) -> None:  # fmt: skip
    """Declare a table of motors down and drives across, of a figure of the motors behind the drives' own reducers."""
    down, names = view.rooms[0], view.motors.names
    order = [place_of(view, k) if k < len(names) else k + 1 for k in range(down)]
    sheet.row += 1
    rows = sheet.table(
        f"@all_{name}", title, down,
        calc("motor", "motor", "", "", '=INDEX([motors.name],[k])&""', filled(names, down, ""), align="left"),
        constant("k", "number", "", "", list(range(1, down + 1))),
        *([calc("order", "by rated torque", "", "", f"=[@motors.smaller.same]*{down}+[k]", order, format="0")]
          if name == "word" else []),
    )  # fmt: skip
    for n, one in enumerate(view.every_drive, 1):
        held = filled(getattr(one.behind_own, figure)[:, 0], down, spare)
        each = calc("v", f"axis {one.shaft.number}", "", "", f"={formula(n)}", held, **more)
        sheet.beside(rows, f"@all_{name}{n}", each)


def share(n: int) -> str:
    """Return the formula of the RMS torque of the motor of a row over its continuous torque."""
    rms = rms_of(
        f"({of_motor('jm')}+[@behind.j.{n}])", f"[@drives.held_i.{n}]", f"[@behind.mixed.{n}]", f"[@behind.square.{n}]"
    ).replace("@own", f"[@drives.own.{n}]")
    return f"IF({of_motor('on')}=1,{rms}/({continuous(f'[@behind.mean.{n}]')}*[@behind.left.{n}]),0)"


def peak(n: int, drive: PairSelection) -> str:
    """Return the formula of the peak torque of the motor of a row: the drive's torque with this motor's inertia."""
    torque, acceleration = (f"{drive.shaft.columns}_{column}" for column in ("T", "al"))
    other = f"({of_motor('jm')}-[@drives.held_jm.{n}])*[@behind.turn.{n}]"
    return f"IF({of_motor('on')}=1,SUMPRODUCT(MAX(({torque}+{other}*{acceleration})^2))^0.5,0)"
