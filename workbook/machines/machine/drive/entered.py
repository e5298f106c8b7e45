"""What is entered of a drive beside its mechanism and motor: load, rotating parts, process forces over the cycle."""

from typing import Any

from workbook.book.declare import Quantity, Sheet, calc, check, constant, given
from workbook.book.rows import filled
from workbook.book.sentence import first_text
from workbook.drive.entries import ALONE, BORED, GEARED, SIZED
from workbook.entries.units import DEGREE, KG_CM2, shown
from workbook.machines.machine.chain import WINDOWS
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.timing.phases import beyond

TITLE = "Rotating parts: an inertia, or a cylinder's diameter, length and density; teeth of what is geared"
CYLINDER = (
    '=IF([inertia]="",PI()/2*[density]*(([diameter]/2/1000)^4-([bore]/2/1000)^4)*[length]/1000*10000,[inertia]+0)'
)


def parts_table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the rotating parts."""
    e, key = driven.entered.parts, f"axes.{driven.number - 1}.parts.*"
    turned = driven.parts

    def entered(name: str) -> list[Any]:
        return filled([getattr(part, name) for part in e], rows, None)

    sheet.row += 1
    sheet.table(
        "@parts", TITLE, rows,
        given("name", "part", "", "", entered("name"), f"{key}.name"),
        constant("k", "number", "k", "", list(range(1, rows + 1))),
        given("count", "count", "", "", entered("count"), f"{key}.count", format="0"),
        given("inertia", "inertia of one", "J", "kg cm²", entered("inertia"), f"{key}.inertia", format="General",
              source="or a cylinder's size"),
        given("shaft", "on the shaft of", "", "", entered("shaft"), f"{key}.shaft", source="motor, or mechanism"),
        given("driver", "teeth of the driver", "n1", "", entered("teeth_driver"), f"{key}.teeth_driver", format="0"),
        given("driven", "teeth of the driven", "n2", "", entered("teeth_driven"), f"{key}.teeth_driven", format="0"),
        given("diameter", "diameter", "d_a", "mm", entered("diameter"), f"{key}.diameter", format="0.0##"),
        given("length", "length", "L", "mm", entered("length"), f"{key}.length", format="0.0##"),
        given("density", "density", "ρ", "kg/m³", entered("density"), f"{key}.density", format="0",
              source="steel: 7800"),
        given("bore", "bore", "d_i", "mm", entered("bore"), f"{key}.bore", format="0.0##"),
        calc("one", "inertia of one", "J", "kg cm²", CYLINDER,
             filled([shown(part.inertia, KG_CM2) for part in turned], rows),
             source="½ρπ(R⁴ − r⁴)L"),
        calc("speed", "speed ratio", "ω_i/ω", "", "=IF(COUNT([driver],[driven])=2,[driver]/[driven],1)",
             filled([part.speed_ratio for part in turned], rows, 1.0), source="n1/n2, over that shaft's"),
        calc("all", "at that shaft", "J*", "kg cm²", "=[count]*[one]*[speed]^2",
             filled([shown(part.reflected, KG_CM2) for part in turned], rows), source="n J (ω_i/ω)²"),
        rules=[SIZED, ALONE, BORED, GEARED],
    )  # fmt: skip


def on_shaft(shaft: str) -> str:
    """Return the formula of the inertia (kg m²) of all parts on a shaft, the motor's or the mechanism's."""
    return f'SUMPRODUCT(([@parts.shaft]="{shaft}")*[@parts.all])/10000'


def loads(driven: Driven, key: str) -> list[Quantity]:
    """Return the entries of the load of this kind."""
    e = driven.entered.load
    rows: tuple[tuple[str, str, str, str, str], ...] = (
        ("mass", "Mass that travels", "m", "kg", ""),
        ("friction", "Coefficient of friction", "μ", "", "opposes the motion"),
        ("slope", "Slope", "γ", "°", "rising with positive travel"),
        ("force", "Force against positive travel", "F", "N", "always, also at rest"),
    ) if driven.travels else (
        ("inertia", "Inertia that turns", "J", "kg cm²", ""),
        ("torque", "Torque against positive motion", "T", "Nm", "always, also at rest"),
        ("friction_torque", "Friction torque", "T_f", "Nm", "opposes the motion"),
    )  # fmt: skip
    viscous = ("viscous", "Viscous friction", "c", "N s/m" if driven.travels else "Nm s/rad", "c ẏ")
    arm = e.arm
    swinging = [] if arm is None else [
        given("@arm_mass", "Arm: its mass", "m_a", "kg", arm.mass, f"{key}.load.arm.mass", format="0.0##",
              source="its inertia is entered above"),
        given("@arm_radius", "Arm: its centre of mass from the axis", "r_a", "mm", arm.radius,
              f"{key}.load.arm.radius", format="0.0##"),
        given("@arm_angle", "Arm: above the horizontal where the axis is at 0", "φ_0", "°", arm.angle,
              f"{key}.load.arm.angle", format="0.0##"),
    ]  # fmt: skip
    return [
        given(f"@{name}", label, symbol, unit, getattr(e, name), f"{key}.load.{name}",
              format="General" if unit == "kg cm²" else "0.0##", source=source)
        for name, label, symbol, unit, source in (*rows, *([] if e.viscous is None else [viscous]))
    ] + swinging  # fmt: skip


ACTS = "(({x}>=[@windows.from])*({x}<[@windows.from]+[@windows.span])+({x}+360<[@windows.from]+[@windows.span]))"


def windows_table(sheet: Sheet, key: str, view: DriveView) -> None:
    """Declare the process forces over the cycle."""
    entered, unit = view.driven.axis.typed.load.windows, "N" if view.driven.travels else "Nm"
    found, over = view.driven.windows, view.one.machine.over
    turned = view.driven.entered.load.windows
    until = f"MIN(360,{over.in_degrees('[stop]')})" if over.measured else "[stop]"

    def entry(name: str) -> list[Any]:
        return filled([getattr(w, name) for w in entered], WINDOWS, None)

    spans = [shown((w.end - w.begin), DEGREE) for w in found]
    sheet.row += 1
    sheet.table(
        "@windows", "Process forces over the cycle: leave spare rows empty", WINDOWS,
        constant("k", "number", "k", "", list(range(1, WINDOWS + 1))),
        given("start", "from", "", over.unit, entry("start"), f"{key}.load.windows.*.start", format=over.format),
        given("stop", "to", "", over.unit, entry("stop"), f"{key}.load.windows.*.stop", format=over.format,
              source=over.entered_of),
        given("force", "force", "", unit, entry("force"), f"{key}.load.windows.*.force", format="0.0##"),
        given("resists", "resists", "", "", entry("resists"), f"{key}.load.windows.*.resists",
              source="always, or moving"),
        calc("from", "from", "", "°", f"={over.in_degrees('[start]')}+0", filled([w.start for w in turned], WINDOWS),
             format="0.0##"),
        calc("span", "for", "", "°",
             f"={until}-{over.in_degrees('[start]')}+IF([stop]+0<[start]+0,360,0)",
             filled([span + (360 if span < 0 else 0) for span in spans], WINDOWS), format="0.0##"),
        calc("always", "always", "", unit, '=IF([resists]="moving",0,[force]+0)',
             filled([w.load.torque for w in found], WINDOWS)),
        calc("moving", "against motion", "", unit, '=IF([resists]="moving",[force]+0,0)',
             filled([w.load.friction for w in found], WINDOWS)),
        *edges(view),
        *([beyond(over)] if over.measured else []),
    )  # fmt: skip


def windows_check(view: DriveView) -> list[Quantity]:
    """Return the check that process forces end with the cycle, where an entry says how long that is."""
    over, i = view.one.machine.over, view.driven.number
    if not over.measured:
        return []
    words = "[@windows.beyond]"
    row = first_text(words)
    return [check("@ok_windows", f"{view.driven.called}: no process force goes on beyond the cycle",
                  f'COUNTIF({words},"?*")=0', True, rule=over.rule("axes", i, "forces"),
                  says=f'[axes.name.{i}]&" process force "&{row}&" "&INDEX({words},{row})')]  # fmt: skip


def edges(view: DriveView) -> list[Quantity]:
    """Return the columns of where a force begins and ends, in degrees of the motion as its phases tell it."""
    late = f"[axes_taken.late.{view.driven.number}]"
    begins, ends = view.edges[::2], view.edges[1::2]

    def edge(name: str, label: str, at: str, values: list[float]) -> Quantity:
        told = f"({at}-{late})"
        return calc(name, label, "θ", "°", f'=IF([start]="",360,{told}-360*INT(({told}+eps)/360))', values,
                    scale=360.0, format="0.0##", source="of its phases; 360 if spare")  # fmt: skip

    return [edge("b", "begins at", "[from]", begins), edge("e", "ends at", "([from]+[span])", ends)]


def acting(angle: str, column: str) -> str:
    """Return the formula of what acts at an angle of the master shaft, of a column of the process forces."""
    return f"SUMPRODUCT({ACTS.format(x=angle)}*[@windows.{column}])"
