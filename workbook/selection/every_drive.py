"""Every drive of a machine behind the reducer that it has: which motors of the catalogue can do it."""

import re
from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

from workbook.book.declare import Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.entries.units import RPM, shown
from workbook.selection.choosing import AS_ENTERED, Choosing
from workbook.selection.grids import DASH, LARGE, of
from workbook.selection.shaft import MIXED, SQUARE, rms_of

NAMED = '=IF([@drives.{0}.same]=0,"{1}",INDEX([{2}.name],MAX(1,[@drives.{0}.same])))'
ABOUT = "Behind the reducer that the drive has, whose own limits are checked on the sheet of the drive."


def every_drive(sheet: Sheet, view: Choosing) -> None:
    """Declare the table of all drives: the pair of each, and the motors that can do it behind its reducer."""
    drives = view.every_drive
    motors, reducers = zip(*(one.held_names for one in drives), strict=True)
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


def motors_by_drives(sheet: Sheet, view: Choosing) -> None:
    """Declare what each motor has to do behind the reducer of each drive, and what it fails first."""
    drives = view.every_drive
    matrices = [one.behind_own for one in drives]
    loads(sheet, view)
    matrix(sheet, view, "all_share", "Their RMS torque over their continuous torque", share,
           [one.uses[:, 0] for one in matrices], 0.0, format=DASH,
           scale=max(1.0, *(float(one.uses.max()) for one in matrices)))  # fmt: skip
    matrix(sheet, view, "all_peak", "Their peak torque [Nm]", lambda n: peak(n, drives[n - 1]),
           [one.peak[:, 0] for one in matrices], 0.0, format=DASH,
           scale=max(1e-3, *(float(one.peak.max()) for one in matrices)))  # fmt: skip
    matrix(sheet, view, "all_wanted", "What is wanted of them", wanted, [one.wanted_verdicts[:, 0] for one in matrices],
           LARGE, align="center")  # fmt: skip
    matrix(sheet, view, "all_word", "What they fail first; yes: they can do it", verdict,
           [one.verdicts[:, 0] for one in matrices], "–", align="center")  # fmt: skip


def loads(sheet: Sheet, view: Choosing) -> None:
    """Declare what the reducer of each drive makes of its load."""
    drives, least = view.every_drive, view.given.least_speed_margin
    product, square = max(one.shaft.product for one in drives), max(one.shaft.torque**2 for one in drives)
    held = {"eta": "@held_eta", "i": "@held_i", "own": "@held_no_load"}
    down = view.rooms[0]
    beyond = down * (down + 1)
    smallest = [one.usable_behind_own[:1] for one in drives]
    inertia = [one.held("j") - one.held("jm") for one in drives]
    speed = [one.behind_own.speed[0] for one in drives]
    mean = [one.load.mean_speed * one.held("i") for one in drives]
    sheet.row += 1
    sheet.table(
        "@behind", "What the reducer of each drive makes of its load", len(drives),
        calc("axis", "axis", "", "", '=[@drives.axis.same]&""', [one.shaft.name for one in drives], align="left"),
        calc("j", "inertia without the motor", "", "kg m²", of_drive("@held_j-@held_jm"), inertia),
        calc("at", "with the load's", "", "kg m²", of_drive("[j]+@inertia/@held_i^2"),
             [one.behind_own.at_motor[0] for one in drives]),
        calc("turn", "acceleration over that of its points", "", "", of_drive("@turns*@held_i"),
             [one.held("i") * one.shaft.values["turns"] for one in drives]),
        calc("fast", "largest speed, with its margin", "", "rpm", of_drive("@speed*@held_i*30/PI()") + "*@least_speed",
             [shown(one * least, RPM) for one in speed]),
        calc("mean", "mean speed", "", "rpm", of_drive("@mean*@held_i*30/PI()"), [shown(one, RPM) for one in mean]),
        calc("left", "rated torque over that of the named drive", "", "", of_drive("@left") + "/@left",
             [one.shaft.values["left"] / view.shaft.values["left"] for one in drives]),
        calc("mixed", "mean of ω̇ S, with losses", "", "W/s", of_drive(MIXED.format(**held)),
             [float(one.load.mixed(one.own_gears)[0]) for one in drives], scale=product),
        calc("square", "mean square torque of the load at the motor", "", "N²m²", of_drive(SQUARE.format(**held)),
             [float(one.load.square(one.own_gears)[0]) for one in drives], scale=square),
        calc("least", "the smallest motor's place by rated torque", "", "",
             [f'={beyond}-SUMPRODUCT(MAX(([@all_word{n}.v]="yes")*({beyond}-[@all_word.order])))'
              for n in range(1, len(drives) + 1)],
             [place_of(view, *k) if k else beyond for k in smallest], format="0"),
    )  # fmt: skip


def place_of(view: Choosing, motor: int) -> int:
    """Return a number by which motors are in the order of their rated torque, then of the catalogue."""
    return int(view.grid.smaller[motor]) * view.rooms[0] + motor + 1


def of_drive(formula: str) -> str:
    """Return a formula of figures of a drive in the row of the same number."""
    return "=" + re.sub(r"@(\w+)", r"[@drives.\1.same]", formula)


def matrix(
    sheet: Sheet, view: Choosing, name: str, title: str, formula: Callable[[int], str], values: list[NDArray[Any]],
    spare: Any, **more: Any,
) -> None:  # fmt: skip
    """Declare a table of motors down and drives across."""
    down, names = view.rooms[0], view.motors.names
    order = [place_of(view, k) if k < len(names) else k + 1 for k in range(down)]
    sheet.row += 1
    rows = sheet.table(
        f"@{name}", title, down,
        calc("motor", "motor", "", "", '=INDEX([motors.name],[k])&""', filled(names, down, ""), align="left"),
        constant("k", "number", "", "", list(range(1, down + 1))),
        *([calc("order", "by rated torque", "", "", f"=[@motors.smaller.same]*{down}+[k]", order, format="0")]
          if name == "all_word" else []),
    )  # fmt: skip
    for n, (one, held) in enumerate(zip(view.shafts, values, strict=True), 1):
        each = calc("v", f"axis {one.number}", "", "", f"={formula(n)}", filled(held.tolist(), down, spare), **more)
        sheet.beside(rows, f"@{name}{n}", each)


def share(n: int) -> str:
    """Return the formula of the RMS torque of the motor of a row over its continuous torque."""
    rms = rms_of(f"({of('jm')}+[@behind.j.{n}])", f"[@drives.held_i.{n}]", f"[@behind.mixed.{n}]",
                 f"[@behind.square.{n}]").replace("@own", f"[@drives.own.{n}]")  # fmt: skip
    continuous = f"MAX({of('rated')},{of('stall')}-{of('slope')}*[@behind.mean.{n}])"
    return f"IF({of('on')}=1,{rms}/({continuous}*[@behind.left.{n}]),0)"


def peak(n: int, drive: Choosing) -> str:
    """Return the formula of the peak torque of the motor of a row: the drive's torque with this motor's inertia."""
    torque, acceleration = (f"{drive.shaft.columns}_{column}" for column in ("T", "al"))
    other = f"({of('jm')}-[@drives.held_jm.{n}])*[@behind.turn.{n}]"
    return f"IF({of('on')}=1,SUMPRODUCT(MAX(({torque}+{other}*{acceleration})^2))^0.5,0)"


def wanted(n: int) -> str:
    """Return the formula of what the motor of a row fails of what is wanted of it."""
    used = f"[@all_share{n}.v.same]"
    inertia = f'IF([@behind.at.{n}]>{of("jmax")},"inertia","yes")'
    return f'IF({used}>@most,"RMS",IF({used}<@little,"{LARGE}",{inertia}))'


def verdict(n: int) -> str:
    """Return the formula of what the motor of a row fails first."""
    weak = f'IF([@all_peak{n}.v.same]>{of("top")},"peak",[@all_wanted{n}.v.same])'
    return f'IF({of("on")}=0,"–",IF([@behind.fast.{n}]>{of("nmax")},"speed",{weak}))'
