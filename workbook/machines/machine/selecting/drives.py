"""What the drives tell the sheet Selection: a row each, the named one by its cells, the ends of its stretches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.linked.worked import PlacedWork
from workbook.machines.machine.selecting.behind import scales_of
from workbook.machines.machine.selecting.view import AS_ENTERED, Choosing
from workbook.machines.machine.stretched import Stretched


class ToldAt(NamedTuple):
    """What a drive's sheet tells of a place, as formulas: direction, acceleration, torque, speed at most."""

    way: str
    acceleration: str
    torque: str
    fastest: str


def told_at(one: Stretched, k: int) -> ToldAt:
    """Return it of the ``k``-th place, from 1: an end of a stretch, begins before ends, or a node; else 0."""
    if k > one.points:
        return NOWHERE
    if isinstance(one, PlacedWork):
        return ToldAt(f"INDEX([@@st.dir],[@@pl.st.{k}])", f"[@@pl.turn.{k}]+0", f"[@@pl.S.{k}]+0", f"ABS([@@pl.w.{k}])")
    end, st = ("b", k) if k <= one.rows else ("e", k - one.rows)
    fast, sign = f"[@@st.vm.{st}]*timing_omega*@@faster*@@i2", f"0-[@@st.sign.{st}]"
    return ToldAt(f"[@@st.dir.{st}]+0", f"{sign}*[way]*@@i2*[@@st.y{end}.{st}]", f"[@@st.ry{end}.{st}]+0", fast)


NOWHERE = ToldAt("0", "0", "0", "0")


def told(view: Choosing) -> list[tuple[str, str, str, str]]:
    """Return of each figure of a drive: its name, label and unit, and its formula on the sheet of the drive."""
    spare = "@spare" if view.stretched.knows_falling else "@motor_peak-MAX(@tmax,0-@tmin)"
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
          for (name, label, unit, formula), (values, scale) in zip(told(view), view.figures, strict=True)),
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
    for (name, label, unit, _), (values, scale) in zip(told(view), view.figures, strict=True):
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
    """Declare the ends of the stretches of the named drive."""
    points, scale = view.points, scales_of(view.stretched)
    behind, rows = view.driven.sizes.behind, range(1, len(points.speed) + 1)

    def of(figure: str) -> list[str]:
        each = [[getattr(told_at(one, k), figure).replace("@@", f"drive{one.driven.number}_") for one in view.drives]
                for k in rows]  # fmt: skip
        return [f"=CHOOSE(@no,{','.join(one)})" if len(one) > 1 else f"={one[0]}" for one in each]

    sheet.row += 1
    sheet.table(
        "@points", "Where its torque can be largest: ends of stretches, or nodes of sections", len(rows),
        constant("k", "number", "", "", list(rows)),
        calc("way", "direction", "", "", of("way"), view.going, format="0"),
        calc("a", "acceleration", "α", "rad/s²", of("acceleration"), points.acceleration, scale=scale.alpha),
        calc("torque", "torque", "S", "Nm", of("torque"), view.torque, scale=behind),
        calc("driving", "where it drives the load", "", "Nm", "=IF(@by_power*[torque]*[way]<0,0,[torque])",
             points.driving, scale=behind),
        calc("driven", "where the load drives it", "", "Nm", "=[torque]-[driving]", points.driven, scale=behind),
        calc("w", "no faster than", "ω", "rad/s", of("fastest"), points.speed, scale=scale.alpha),
    )  # fmt: skip
