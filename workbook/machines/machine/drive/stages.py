"""Stages between reducer and mechanism in cells, such as a toothed belt: entries, workings, columns of the points.

The torque on a shaft is that of its inertia, of friction, and of what it drives: T_k = J_k ω̇_k ± T_f,k + f T_k+1/i_k.
Only the sheet of a drive whose description has stages has these.
"""

import numpy as np

from engine.drive.chain import held_factor
from engine.laws.base import Array
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity
from workbook.entries.facts import entry_cells
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import LEAST, DriveView
from workbook.machines.machine.drive_entries import STAGED

CELLS = cell_tables(__file__)

ABOUT = "A toothed belt, gears: by its ratio, or by the teeth of both wheels. Stage 1 is behind the reducer."
LOSS = "IF([dir]=0,@s{0}_held,IF([{1}]*[dir]<0,@s{0}_in,@s{0}_out))*[{1}]"


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
    stages = enumerate(driven.entered.stages)
    return [row for n, stage in stages for row in entry_cells(stage, f"{key}.stages.{n}", n=n + 1)]


def workings(view: DriveView) -> list[Quantity]:
    """Return the rows of ratios, losses and inertias of the stages, and of the inertia at the reducer's output."""
    cell = CELLS["workings"]
    driven, last = view.driven, count(view.driven)
    m, rows = driven.mechanism, list[Quantity]()
    mechanism, unit = ("*@i2", driven.axis.base) if not view.varies else ("", "rad")
    before = ("*".join(map("@is{}".format, range(1, n))) for n in range(2, last + 1))
    behind = "+".join(["@s1_js", *(f"@s{n}_js/({ratio})^2" for n, ratio in enumerate(before, 2))])
    for n, entered in enumerate(driven.entered.stages, 1):
        stage = m.stages[n]
        out, document = 1.0 / stage.efficiency / stage.ratio, driven.given.method == "document"
        back = stage.efficiency if stage.back_efficiency is None else stage.back_efficiency
        wheel = f"+@s{n - 1}_j_driven" if n > 1 else ""
        turns = 1.0 if view.varies else m.ratio_from(m.last - 1)
        rows += [
            cell("@is{n}", entered.reduction, n=n),
            cell("@s{n}_out", out, n=n),
            cell("@s{n}_in", out if document else back / stage.ratio, n=n, scale=1.0 / stage.ratio),
            cell("@s{n}_held", out if document else held_factor(stage.efficiency, back) / stage.ratio, n=n),
            cell("@s{n}_js", m.on_shaft(n), n=n, wheel=wheel),
        ]
    rows.append(cell("@is", view.load.output_ratio, ratios="*".join(f"@is{n}" for n in range(1, last + 1))))
    for n in range(1, last + 1):
        ratios = "*".join(f"@is{k}" for k in range(n, last + 1))
        torque = m.on_shaft(n) * m.ratio_from(n) / m.ratio_from(m.last - 1) * turns
        rows.append(cell("@s{n}_ja", torque, n=n, unit=unit, ratios=ratios, mechanism=mechanism))
    inertia = (view.inertia - m.on_shaft(0)) * m.stages[0].ratio ** 2
    rows.append(cell("@j_out", inertia, behind=behind))
    return rows


def own(driven: Driven) -> str:
    """Return the end of the formula of the inertia on the mechanism's shaft (kg m²), of the last stage's wheel."""
    return f"+@s{count(driven)}_j_driven/10000" if count(driven) else ""


def output(
    view: DriveView, torques: list[Array], behind: str, inertia: str, force: str = "[F]", end: str = ""
) -> tuple[list[Quantity], str]:
    """Return the columns of ``torques`` on the shafts behind the stages, and the formula, without =, before them.

    ``behind`` is the formula of what the mechanism takes of a force, ``inertia`` that of the torque of its shaft's
    inertia. The columns' names end in ``end``: 0 of torques without inertia, else by :data:`OTHER_RATES`.
    """
    last, moved = count(view.driven), "[al]" if view.varies else "[a]"
    rate, grows = OTHER_RATES.get(end) or {"": ("", ""), REST: (", without inertia", "")}[end]
    cell = CELLS["torques"].sharing(end=end, mark=SYMBOLS[end], rate=rate)
    grows = f"*{grows}^2" if grows else ""
    formula = behind.format(force) + ("" if end == REST else f"+{inertia}{grows}")
    columns = list[Quantity]()
    for n in range(last, 0, -1):
        where = "on the mechanism's shaft" if n == last else f"before stage {n + 1}"
        scale = max(float(np.abs(view.load.shaft_torques[n]).max()), LEAST)
        values = view.by_point(torques[n])
        columns.append(cell("M{n}{end}", values, n=n, after=n + 1, where=where, behind=formula, scale=scale))
        formula = LOSS.format(n, f"M{n}{end}") + ("" if end == REST else f"+@s{n}_ja*{moved}{grows}")
    return columns, formula


REST, TRIED, CREEPING = "0", "N", "C"
SYMBOLS = {"": "", REST: ",s", TRIED: ",N", CREEPING: ",C"}
"""ends of names of columns of torques, without inertia and at other rates; and of their symbols"""
OTHER_RATES = {TRIED: (", at the rate that is tried", "@times"), CREEPING: (", creeping", "@slow")}
"""of another rate, by this end: its words, and the cell that has it over the present one"""


def checks(driven: Driven) -> list[Quantity]:
    """Return the checks that each stage has a ratio, or the teeth of both its wheels."""
    cell = CELLS["checks"].sharing(called=driven.called, staged=STAGED)
    return [cell("@ok_stage{n}", True, n=n) for n in range(1, count(driven) + 1)]
