"""What the drives tell the sheet Selection: a row each, the named one by its cells, the ends of its stretches."""

from __future__ import annotations

from collections.abc import Sequence

from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.entries.units import PER_RPM, RPM, shown
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.selecting.behind import scales_of
from workbook.machines.machine.selecting.view import AS_ENTERED, Choosing

FAST = "INDEX([@@st.vm],[st])*timing_omega*@@faster*@@i2"


def told() -> list[tuple[str, str, str, str]]:
    """Return of each figure of a drive: its name, label and unit, and its formula on the sheet of the drive."""
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
        ("turn", "ratio of the mechanism", "", "@i2"),
        ("by_power", "losses by the flow of power", "", '(@method="physical")'),
        ("left", "rated torque left at its temperature", "", "@derate"),
        ("held_j", "inertia with its motor", "kg m²", "@j0"),
        ("held_jm", "its motor", "kg m²", "@jm"),
        ("held_i", "its reduction", "", "@i1"),
        ("held_eta", "its efficiency", "", "@eta1"),
        ("held_rated", "its rated torque", "Nm", "@motor_rated"),
        ("held_peak", "its peak torque", "Nm", "@motor_peak"),
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
        "@drives", "Drives of constant ratio", len(drives),
        calc("axis", "axis", "", "", [f"=[axes.name.{one.number}]" for one in drives],
             [one.entered.name for one in drives], align="left"),
        constant("k", "number of the axis", "k", "", [one.number for one in drives]),
        *(calc(name, label, "", unit, [scoped(formula, one) for one in drives], values, scale=scale)
          for (name, label, unit, formula), (values, scale) in zip(told(), view.figures, strict=True)),
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
    for (name, label, unit, _), (values, scale) in zip(told(), view.figures, strict=True):
        rows.append(calc(f"@{name}", label.capitalize(), "", unit, f"={taken(view, name)}+0", values[view.number],
                         scale=scale))  # fmt: skip
    sheet.rows(*rows, *held(view))


def held(view: Choosing) -> Sequence[Quantity]:
    """Return the names of the motor and the reducer of the drive, and the motor's curve."""
    curve = view.held_curve
    return [
        calc("@held_motor", "Its motor", "", "",
             f'=IF(@held_row=0,"{AS_ENTERED}",INDEX([motors.name],MAX(1,@held_row)))', view.held_motor, align="left"),
        calc("@held_reducer", "Its reducer", "", "",
             f'=IF(@held_gear=0,"{AS_ENTERED}",INDEX([reducers.name],MAX(1,@held_gear)))', view.held_reducer,
             align="left"),
        calc("@held_knee", "its peak torque holds up to", "n_1", "rpm",
             "=IF(@held_row=0,0,INDEX([@motors.knee],MAX(1,@held_row)))", shown(curve.knee, RPM)),
        calc("@held_fall", "its fall beyond", "", "Nm/rpm",
             "=IF(@held_row=0,0,INDEX([@motors.fall],MAX(1,@held_row)))", shown(curve.fall, PER_RPM)),
    ]  # fmt: skip


def points_table(sheet: Sheet, view: Choosing) -> None:
    """Declare the ends of the stretches of the named drive."""
    rows, points, scale = view.stretched.rows, view.points, scales_of(view.stretched)
    behind = view.driven.sizes.behind

    def of(formula: str) -> str:
        each = [formula.replace("@@", f"drive{one.driven.number}_") for one in view.drives]
        return f"=CHOOSE(@no,{','.join(each)})" if len(each) > 1 else f"={each[0]}"

    def ends(column: str, formula: str) -> list[str]:
        return [of(formula.format(f"INDEX([@@st.{column}{end}],[st])")) for end in "be" for _ in range(rows)]

    sheet.row += 1
    sheet.table(
        "@points", "Both ends of its stretches", len(points.speed),
        constant("k", "number", "", "", list(range(1, len(points.speed) + 1))),
        constant("st", "stretch", "", "", [*range(1, rows + 1), *range(1, rows + 1)]),
        calc("way", "direction", "", "", of("INDEX([@@st.dir],[st])"), view.going, format="0"),
        calc("a", "acceleration", "α", "rad/s²", ends("y", "0-INDEX([@@st.sign],[st])*[way]*@turn*{0}"),
             points.acceleration, scale=scale.alpha),
        calc("torque", "torque", "S", "Nm", ends("ry", "{0}+0"), view.torque, scale=behind),
        calc("driving", "where it drives the load", "", "Nm", "=IF(@by_power*[torque]*[way]<0,0,[torque])",
             points.driving, scale=behind),
        calc("driven", "where the load drives it", "", "Nm", "=[torque]-[driving]", points.driven, scale=behind),
        calc("w", "no faster than", "ω", "rad/s", of(FAST), points.speed, scale=scale.alpha),
    )  # fmt: skip
