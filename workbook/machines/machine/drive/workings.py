"""The workings of the sheet of a drive: ratios, inertias, losses and what resists, in S1's terms."""

from __future__ import annotations

from engine.drive.losses import held_factor
from engine.drive.quadrature import STANDSTILL
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.entries.units import shown
from workbook.machines.machine.drive import by_angle
from workbook.machines.machine.drive.parts import on_shaft
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.mechanism import BELTED, SCREWS


def back_default(kind: str) -> str:
    """Return the formula of the efficiency backward where none is entered."""
    return "2-1/@eta2" if kind in SCREWS else "@eta2"


def losses(view: DriveView) -> list[Quantity]:
    """Return the rows of the factors of losses: where the load drives, and at rest."""
    driven = view.driven
    reducer, mechanism = driven.mechanism.stages
    document = driven.given.method == "document"
    back = [1.0 / stage.efficiency if document else float(stage.back_efficiency or 0.0) for stage in (mechanism,)]
    held = 1.0 / mechanism.efficiency if document else held_factor(mechanism.efficiency, driven.back_efficiency)
    return [
        calc("@ahead1", "Motor torque for 1 Nm behind the reducer", "", "", "=1/@eta1/@i1",
             1.0 / reducer.efficiency / reducer.ratio, source="1/(η i)"),
        calc("@back1", "the same, load driving", "", "", '=IF(@method="document",1/@eta1,@eta1)/@i1',
             (1.0 / reducer.efficiency if document else reducer.efficiency) / reducer.ratio,
             source="η/i; by S4 1/(η i), as where it is driven"),
        calc("@brake", "A brake holds it at rest", "", "", '=IF(@holding="brake",1,0)',
             int(driven.holding == "brake"), format="0", source="1 yes, 0 no"),
        calc("@back2", "Loss factor of the mechanism, load driving", "f_2", "",
             f'=IF(@method="document",1/@eta2,IF(@eta2_back="",{back_default(driven.given.kind)},@eta2_back))',
             back[0], scale=1.0, source="0 or less: self-locking, driven down by the motor"),
        calc("@hold2", "Loss factor of the mechanism at rest", "", "", "=IF(@back2<=0,0,1/@eta2)", held,
             source="0: self-locking"),
    ]  # fmt: skip


def workings(sheet: Sheet, view: DriveView, sizes: list[Quantity]) -> None:
    """Declare ratios, inertias and what resists, in S1's terms."""
    driven, one = view.driven, view.one
    m, load, size = driven.mechanism, driven.load, view.scales
    travels = driven.travels
    steady = "=@force+@mass*gravity*SIN(RADIANS(@slope))" if travels else "=@torque+0"
    rubbing = "=@friction*@mass*gravity*ABS(COS(RADIANS(@slope)))" if travels else "=@friction_torque+0"
    moved = "=@mass+@belt_mass" if driven.given.kind in BELTED else "=@mass+0" if travels else "=@inertia/10000"
    base, force = ("kg", "N") if travels else ("kg m²", "Nm")
    travel = "/MIN([@pt.g])" if view.varies else "*MAX(MAX([@pt.dx]),0-MIN([@pt.dx]))" if view.slides else "/@i2"
    square, largest = "m/φ'²", ", the largest" if driven.train.inertia_varies else ""
    still = STANDSTILL * driven.fastest * driven.axis.speed

    sheet.heading(
        "Workings: the chain",
        "S1: C_m = J_m/τ ω̇ + τ (C_r + J_tot ω̇), τ = 1/i_1 and ω̇ of the mechanism's shaft; with losses τ over η_1.",
    )
    sheet.rows(
        constant("@built", "Axis, named when the book was built", "", "", driven.entered.called, align="left",
                 source="the sheet and its checks keep this name"),
        calc("@faster", "Rate of the drive over the machine's", "", "", "=@rate/timing_rate",
             shown(driven.axis.speed, one.axis.speed)),
        calc("@omega", f"{one.machine.over.speed} at its rate", "ω", "rad/s", "=timing_omega*@faster",
             driven.axis.speed),
        calc("@m", f"Moved {'mass' if travels else 'inertia'}", "mJ"[not travels], base, moved, m.on_shaft(m.last)),
        *sizes,
        calc("@tau", "Ratio of the reducer as S1 has it", "τ", "", "=1/@i1", 1.0 / m.stages[0].ratio,
             source="mechanism over motor"),
        calc("@j0", "Inertia on the motor's shaft, motor included", "J_0", "kg m²",
             f"=@jm+@j_reducer+{on_shaft('motor')}", driven.at_motor, source="motor, reducer, parts"),
        calc("@j1", "Inertia of parts on the mechanism's shaft", "J_p", "kg m²", f"={on_shaft('mechanism')}",
             m.on_shaft(1)),
        calc("@j_shaft", "Inertia at the mechanism's shaft", "J_tot", "kg m²", f"=@j1+@m{travel}^2",
             m.on_shaft(1) + m.on_shaft(m.last) * view.travel**2,
             source=f"J_p + {'m (dx/dψ)²' if view.slides else square}{largest}"),
        *losses(view),
        calc("@steady", "Constant load force", "", force, steady, load.torque, scale=size.force,
             source="F + m g sin γ" if travels else ""),
        calc("@cr", "Constant torque at the mechanism's shaft", "C_r", "Nm", f"=@steady{travel}",
             load.torque * view.travel, scale=size.behind, source="F_r/φ', F_r R of rollers"),
        calc("@rub", "Friction", "", force, rubbing, load.friction, scale=size.force,
             source="μ m g cos γ" if travels else ""),
        calc("@vmax", "Greatest geometric velocity", "y'max", "", f"=MAX([axis{driven.number}.y1])", driven.fastest),
        calc("@amax", "Greatest acceleration", "ÿ", f"{driven.axis.base}/s²",
             f"=[axes.a.{driven.number}]*@faster^2", driven.axis.hardest),
        calc("@still", "Standstill: speeds up to", "", f"{driven.axis.base}/s",
             "=check_zero*@vmax*@omega", still, format="0E+00", scale=max(still, 1e-12)),
        *by_angle.rows(driven),
    )  # fmt: skip
