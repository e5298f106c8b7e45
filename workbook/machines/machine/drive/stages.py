"""Stages between reducer and mechanism in cells, such as a toothed belt: entries, workings, columns of the points.

The torque on a shaft is that of its inertia, of friction, and of what it drives: T_k = J_k ω̇_k ± T_f,k + f T_k+1/i_k.
Only the sheet of a drive whose description has stages has these.
"""

import numpy as np

from engine.drive.chain import held_factor
from workbook.book.declare import Quantity, calc, check, entries_of, given
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import LEAST, DriveView
from workbook.machines.machine.drive_entries import STAGED
from workbook.machines.machine.file_layout import stage_name

ABOUT = "A toothed belt, gears: by its ratio, or by the teeth of both wheels. Stage 1 is behind the reducer."
LOSS = "=IF([dir]=0,@s{0}_held,IF([{1}]*[dir]<0,@s{0}_in,@s{0}_out))*[{1}]"


def count(driven: Driven) -> int:
    """Return the number of stages."""
    return len(driven.entered.stages)


def between(driven: Driven) -> str:
    """Return the end of a formula that is multiplied by the ratio of all stages; nothing where there are none."""
    return "*@is" if count(driven) else ""


def inertia(driven: Driven) -> str:
    """Return the name of the inertia at the reducer's output (kg m²): without stages, at the mechanism's shaft."""
    return "@j_out" if count(driven) else "@j_shaft"


def entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the rows of what is entered of the stages."""
    rows: list[Quantity] = []
    for n, stage in enumerate(driven.entered.stages, 1):
        at, called = f"{key}.stages.{n - 1}", f"Stage {n}: "
        cell = entries_of(stage, at)
        rows += [
            given(stage_name(driven.number, n - 1), f"{called}ratio", f"i_s{n}", "", stage.ratio, f"{at}.ratio",
                  source="driving over driven speed; or by teeth"),
            cell(f"@s{n}_driver", f"{called}teeth of the driving wheel", "", "", "teeth_driver", "motor's side",
                 format="0"),
            cell(f"@s{n}_driven", f"{called}teeth of the driven wheel", "", "", "teeth_driven", format="0"),
            cell(f"@s{n}_j_driver", f"{called}inertia on its driving shaft", "", "kg cm²", "driver_inertia",
                 "the wheel's, and all that turns with it", format="General"),
            cell(f"@s{n}_j_driven", f"{called}inertia on its driven shaft", "", "kg cm²", "driven_inertia",
                 format="General"),
            cell(f"@s{n}_eta", f"{called}efficiency", f"η_s{n}", "", "efficiency", "1 if empty"),
            cell(f"@s{n}_back", f"{called}efficiency where the load drives it", f"η_s{n}'", "", "back_efficiency",
                 "empty: as where the motor drives; 0 or less: self-locking"),
            cell(f"@s{n}_friction", f"{called}friction torque on its driven shaft", f"T_f,s{n}", "Nm",
                 "friction_torque", "against the motion, 0 at rest"),
        ]  # fmt: skip
    return rows


def workings(view: DriveView) -> list[Quantity]:
    """Return the rows of ratios, losses and inertias of the stages, and of the inertia at the reducer's output."""
    driven, last = view.driven, count(view.driven)
    m, rows = driven.mechanism, list[Quantity]()
    by_motion, unit = ("*@i2", driven.axis.base) if not view.varies else ("", "rad")
    behind = "+".join(f"@s{n}_js/{ratio_before(n)}^2" if n > 1 else "@s1_js" for n in range(1, last + 1))
    for n, entered in enumerate(driven.entered.stages, 1):
        stage = m.stages[n]
        out, document = 1.0 / stage.efficiency / stage.ratio, driven.given.method == "document"
        back = stage.efficiency if stage.back_efficiency is None else stage.back_efficiency
        before, shaft = f"@s{n}_j_driver" + (f"+@s{n - 1}_j_driven" if n > 1 else ""), f"before stage {n}"
        turns = 1.0 if view.varies else m.ratio_from(m.last - 1)
        rows += [
            calc(f"@is{n}", f"Ratio of stage {n}", f"i_s{n}", "",
                 f'=IF(COUNT(@s{n}_driver,@s{n}_driven)=2,@s{n}_driven/@s{n}_driver,IF(@s{n}_ratio="",1,@s{n}_ratio))',
                 entered.reduction),
            calc(f"@s{n}_out", f"Torque {shaft} for 1 Nm behind it", "", "", f'=1/IF(@s{n}_eta="",1,@s{n}_eta)/@is{n}',
                 out, "1/(η i)"),
            calc(f"@s{n}_in", "the same, load driving", "", "",
                 f'=IF(@method="document",@s{n}_out,IF(@s{n}_back="",1/@s{n}_out/@is{n},@s{n}_back)/@is{n})',
                 out if document else back / stage.ratio, "η'/i", scale=1.0 / stage.ratio),
            calc(f"@s{n}_held", "the same, at standstill", "", "", f"=IF(@s{n}_in<=0,0,@s{n}_out)",
                 out if document else held_factor(stage.efficiency, back) / stage.ratio, "0: self-locking"),
            calc(f"@s{n}_js", f"Inertia on the shaft {shaft}", "", "kg m²", f"=({before})/10000", m.on_shaft(n)),
        ]  # fmt: skip
    rows.append(calc("@is", "Ratio of all stages", "i_s", "", f"={'*'.join(f'@is{n}' for n in range(1, last + 1))}",
                     view.load.output_ratio))  # fmt: skip
    for n in range(1, last + 1):
        after = "*".join(f"@is{k}" for k in range(n, last + 1))
        rows.append(
            calc(f"@s{n}_ja", f"Torque before stage {n} for 1 {unit}/s², of its inertia", "", f"Nm s²/{unit}",
                 f"=@s{n}_js*{after}{by_motion}", m.on_shaft(n) * m.ratio_from(n) / m.ratio_from(m.last - 1) * turns)
        )  # fmt: skip
    inertia = (view.inertia - m.on_shaft(0)) * m.stages[0].ratio ** 2
    rows.append(calc("@j_out", "Inertia at the reducer's output", "J_tot", "kg m²", f"={behind}+@j_shaft/@is^2",
                     inertia, "J_s1 + J_s2/i_s1² + J/i_s²"))  # fmt: skip
    return rows


def ratio_before(n: int) -> str:
    """Return the formula of the ratio of the stages before the n-th."""
    return "(" + "*".join(f"@is{k}" for k in range(1, n)) + ")"


def own(driven: Driven) -> str:
    """Return the end of the formula of the inertia on the mechanism's shaft (kg m²), of the last stage's wheel."""
    return f"+@s{count(driven)}_j_driven/10000" if count(driven) else ""


def output(view: DriveView, behind: str, inertia: str, force: str = "[F]", end: str = "") -> tuple[list[Quantity], str]:
    """Return the columns of the torques on the shafts behind the stages, and the formula of the one before them all.

    ``behind`` is the formula of what the mechanism takes of a force, ``inertia`` that of the torque of its shaft's
    inertia. The columns' names end in ``end``: 0 of torques without inertia, N of those at the rate that is tried.
    """
    last, moved = count(view.driven), "[al]" if view.varies else "[a]"
    words, grows = {"": ("", ""), REST: (", without inertia", ""), TRIED: (", at the tried rate", "*@times^2")}[end]
    torques = {"": view.load.shaft_torques, REST: view.load.shaft_torques_at_rest,
               TRIED: view.search.points_tried.load.shaft_torques}[end]  # fmt: skip
    formula = f"={behind.format(force)}" + ("" if end == REST else f"+{inertia}{grows}")
    columns = list[Quantity]()
    for n in range(last, 0, -1):
        where = "on the mechanism's shaft" if n == last else f"before stage {n + 1}"
        scale, name = max(float(np.abs(view.load.shaft_torques[n]).max()), LEAST), f"M{n}{end}"
        symbol = f"T_{n + 1}{SYMBOLS[end]}"
        columns.append(
            calc(name, f"torque {where}{words}", symbol, "Nm", f"{formula}+@s{n}_friction*[dir]",
                 view.by_point(torques[n]), "f T/i + J ω̇ ± T_f", scale=scale)
        )  # fmt: skip
        formula = LOSS.format(n, name) + ("" if end == REST else f"+@s{n}_ja*{moved}{grows}")
    return columns, formula


REST, TRIED = "0", "N"
SYMBOLS = {"": "", REST: ",s", TRIED: ",N"}
"""ends of names of columns of torques, without inertia and at the rate that is tried; and of their symbols"""


def checks(driven: Driven) -> list[Quantity]:
    """Return the checks that each stage has a ratio, or the teeth of both its wheels."""
    key = f"axes.{driven.number - 1}.stages"
    return [
        check(f"@ok_stage{n}", f"{driven.called}: stage {n} has a ratio, or teeth of both wheels",
              f'IF(@s{n}_ratio="",COUNT(@s{n}_driver,@s{n}_driven)=2,COUNT(@s{n}_driver,@s{n}_driven)=0)', True,
              rule=f"{key}.{n - 1}:staged", says=f'"{STAGED}"')
        for n in range(1, count(driven) + 1)
    ]  # fmt: skip
