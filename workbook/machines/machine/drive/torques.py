"""Torques between motor and load in cells: of the mechanism, behind stages, held by a brake, and at other rates.

The torque on a shaft is that of its inertia, of friction, and of what it drives: T_k = J_k ω̇_k ± T_f,k + f T_k+1/i_k.
Only the sheet of a drive whose description has stages between reducer and mechanism, such as a toothed belt, has
theirs; only that of one with the brake's figures has the dwells that it holds: else a brake holds in every dwell.
"""

import numpy as np

from engine.drive.chain import held_factor
from engine.laws.base import Array
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity
from workbook.book.rows import filled
from workbook.entries.facts import entry_cells
from workbook.machines.machine.drive import by_angle
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import LEAST, DriveView
from workbook.machines.machine.drive_entries import STAGED

CELLS = cell_tables(__file__)

LOSS = "IF([dir]=0,@s{0}_held,IF([{1}]*[dir]<0,@s{0}_in,@s{0}_out))*[{1}]"
LOSS2 = "IF([dir]=0,@hold2,IF({0}*[dir]<0,@back2,1/@eta2))*{0}"
CONSTANT = "IF([dir]=0,@held2,IF({0}*[dir]<0,@in2,@out2))*{0}"
"""output torque of the reducer by a force, of a constant ratio; LOSS2 is without the ratio"""
REST, TRIED, CREEPING = "0", "N", "C"
SYMBOLS = {"": "", REST: ",s", TRIED: ",N", CREEPING: ",C"}
"""ends of names of columns of torques, without inertia and at other rates; and of their symbols"""
OTHER_RATES = {TRIED: (", at the rate that is tried", "@times"), CREEPING: (", creeping", "@slow")}
"""of another rate, by this end: its words, and the cell that has it over the present one"""


def between(driven: Driven) -> str:
    """Return the end of a formula that is multiplied by the ratio of all stages; nothing where there are none."""
    return "*@is" if driven.entered.stages else ""


def inertia(driven: Driven) -> str:
    """Return the name of the inertia at the reducer's output (kg m²): without stages, at the mechanism's shaft."""
    return "@j_out" if driven.entered.stages else "@j_shaft"


def stage_entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the rows of what is entered of the stages."""
    stages = enumerate(driven.entered.stages)
    return [row for n, stage in stages for row in entry_cells(stage, f"{key}.stages.{n}", n=n + 1)]


def stage_workings(view: DriveView) -> list[Quantity]:
    """Return the rows of ratios, losses and inertias of the stages, and of the inertia at the reducer's output."""
    cell = CELLS["stages"]
    driven, last = view.driven, len(view.driven.entered.stages)
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
    return f"+@s{len(driven.entered.stages)}_j_driven/10000" if driven.entered.stages else ""


def output(
    view: DriveView, torques: list[Array], behind: str, inertia: str, force: str = "[F]", end: str = ""
) -> tuple[list[Quantity], str]:
    """Return the columns of ``torques`` on the shafts behind the stages, and the formula, without =, before them.

    ``behind`` is the formula of what the mechanism takes of a force, ``inertia`` that of the torque of its shaft's
    inertia. The columns' names end in ``end``: 0 of torques without inertia, else by :data:`OTHER_RATES`.
    """
    last, moved = len(view.driven.entered.stages), "[al]" if view.varies else "[a]"
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


def stage_checks(driven: Driven) -> list[Quantity]:
    """Return the checks that each stage has a ratio, or the teeth of both its wheels."""
    cell = CELLS["stage_checks"].sharing(called=driven.called, staged=STAGED)
    return [cell("@ok_stage{n}", True, n=n) for n in range(1, len(driven.entered.stages) + 1)]


def brake_holds(view: DriveView, times: str = "") -> str:
    """Return the formula of 1 at a point where the brake holds the shaft, perhaps at so many times the rate, else 0.

    It holds in dwells long enough for it.
    """
    if not view.brakes:
        return "([dir]=0)*@brake"
    return f"([dir]=0)*(INDEX([@iv.dwell],[iv])>=(@brake_least-check_zero)*{times})*@brake" if times else "1-[free]"


def brake_workings(view: DriveView) -> list[Quantity]:
    """Return the rows of the shortest dwell that it holds, and of the intervals in motion."""
    cell = CELLS["brake"]
    moving = int((view.cycle.direction != 0.0).sum())
    return [cell("@brake_least", view.driven.brake.time), cell("@moving", moving)]


def dwell_columns(view: DriveView, spare: str) -> list[Quantity]:
    """Return the columns of the dwell that an interval belongs to; ``spare`` is the condition of a spare row."""
    cell = CELLS["dwell_columns"]
    cycle = view.cycle
    moves = cycle.direction != 0.0
    before = (np.cumsum(moves) - moves) % max(1, int(moves.sum()))
    return [
        cell("before", filled(before.tolist(), view.rows, 0), spare=spare),
        cell("dwell", view.by_interval(cycle.dwells), spare=spare, scale=view.time),
        cell("held", view.by_interval(view.load.braked[:, 0].astype(float)), spare=spare),
    ]


def braked_columns(view: DriveView) -> list[Quantity]:
    """Return the columns of whether the motor is free of the brake, and of what it then drives."""
    cell = CELLS["braked_columns"].sharing(**view.parts)
    free = np.where(view.load.braked, 0.0, 1.0)
    driven = view.by_point(view.load.output_torque * free)
    return [cell("free", view.by_point(free)), cell("Sm", driven)]


def by_inertia(view: DriveView) -> tuple[str, str]:
    """Return the formulas of the torques of inertia on the mechanism's shaft, and at the motor's."""
    if view.varies:
        return ("@j1*[al]", f"@j0*@i1{between(view.driven)}*[al]")
    return ("@j1i2*[a]", "@j0i*[a]")


def behind(view: DriveView) -> str:
    """Return the formula of the output torque of the reducer by a force, without inertia."""
    return f"{LOSS2}/[g]" if view.varies else CONSTANT


def standing(view: DriveView) -> list[Quantity]:
    """Return the columns for the highest rate: torques without motion, what of the curve grows with the rate."""
    points, load, of, driven = view.points, view.load, view.by_point, view.driven
    before, formula = output(view, load.shaft_torques_at_rest, behind(view), "", "[R]", REST)
    cell = CELLS["standing"].sharing(**view.parts)
    columns = [
        *before,
        cell("S0", of(load.output_torque_at_rest), output=formula),
        cell("T0", of(points.standing), held=brake_holds(view)),
    ]
    if not view.knows_falling:
        return columns
    level = np.stack([0.0 * points.torque] * 2)
    forward, backward = points.falling_use(driven.motor) if driven.motor.falling.fall > 0.0 else level

    def use(grows: str, left: str) -> str:
        square = f"(@fall*[n])^2+4*({grows})*({left})"
        return f"=IF(@fall=0,0,IF({square}<0,0,((@fall*ABS([n])+SQRT({square}))/2/({left}))^2))"

    return [
        *columns,
        cell("left", of(points.reserve(driven.motor))),
        cell("uc", of(forward), formula=use("[T]-[T0]", "@corner-[T0]")),
        cell("ub", of(backward), formula=use("[T0]-[T]", "@corner+[T0]")),
    ]


def at_another_rate(view: DriveView, end: str) -> list[Quantity]:
    """Return the columns of the torques at another rate: forces of inertia grow with its square.

    Their names end in ``end``, by :data:`OTHER_RATES`. A drive creeps with its process forces, or empty.
    """
    (rate, times), creeps = OTHER_RATES[end], end == CREEPING
    then = view.creeping if creeps else view.search.points_tried
    empty = by_angle.resisting(view, "@steady", "@rub")
    resists = f'IF(creep_forces="on",[R],{empty})' if creeps else "[R]"
    of, (inertia, motor_inertia) = view.by_point, by_inertia(view)
    speed, viscous = "[dx]*[vs]" if view.slides else "[v]", view.is_viscous
    resisted = f"+@viscous*{speed}*({times}-{times}^2)" if viscous else ""
    source = "F_r + (F − F_r − c ẏ) x + c ẏ √x" if viscous else "F_r + (F − F_r) x"
    before, formula = output(view, then.load.shaft_torques, behind(view), inertia, f"[F{end}]", end)
    own = {"times": times, "end": end, "rate": rate, "resists": resists, "resisted": resisted}
    cell = CELLS["at another rate"].sharing(**view.parts, **own)
    return [
        cell("F{end}", of(then.load.force), unit=driven_unit(view), source=source),
        *before,
        cell("S{end}", of(then.load.output_torque), output=formula),
        cell("T{end}", of(then.torque), held=brake_holds(view, times), own_inertia=motor_inertia),
    ]


def driven_unit(view: DriveView) -> str:
    """Return the unit of the force at the load."""
    return "N" if view.driven.axis.base == "m" else "Nm"
