"""What is entered of a drive beside its mechanism and motor: load, rotating parts, process forces over the cycle."""

from workbook.book.declare import Quantity, Sheet, calc, columns_of, constant, entries_of
from workbook.book.quantity import PLAIN
from workbook.book.rows import filled
from workbook.drive.entries import ALONE, BORED, GEARED, SIZED
from workbook.fields.units import DEGREE, KG_CM2, shown
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.drive_entries import WINDOWS
from workbook.machines.machine.timing.phases import beyond, no_fault

TITLE = "Rotating parts: an inertia, or a cylinder's diameter, length and density; teeth of what is geared"
CYLINDER = (
    '=IF([inertia]="",PI()/2*[density]*(([diameter]/2/1000)^4-([bore]/2/1000)^4)*[length]/1000*10000,[inertia]+0)'
)


def parts_table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the rotating parts."""
    column, turned = columns_of(driven.entered.parts, f"axes.{driven.number - 1}.parts", rows), driven.parts
    sheet.row += 1
    sheet.table(
        "@parts", TITLE, rows,
        column("name", "part", "", "", "name"),
        constant("k", "number", "k", "", list(range(1, rows + 1))),
        column("count", "count", "", "", "count", format="0"),
        column("inertia", "inertia of one", "J", "kg cm²", "inertia", "or a cylinder's size", format="General"),
        column("shaft", "on the shaft of", "", "", "shaft", "motor, or mechanism"),
        column("driver", "teeth of the driver", "n1", "", "teeth_driver", format="0"),
        column("driven", "teeth of the driven", "n2", "", "teeth_driven", format="0"),
        column("diameter", "diameter", "d_a", "mm", "diameter", format=PLAIN),
        column("length", "length", "L", "mm", "length", format=PLAIN),
        column("density", "density", "ρ", "kg/m³", "density", "steel: 7800", format="0"),
        column("bore", "bore", "d_i", "mm", "bore", format=PLAIN),
        calc("one", "inertia of one", "J", "kg cm²", CYLINDER, filled([shown(p.inertia, KG_CM2) for p in turned], rows),
             "½ρπ(R⁴ − r⁴)L"),
        calc("speed", "speed ratio", "ω_i/ω", "", "=IF(COUNT([driver],[driven])=2,[driver]/[driven],1)",
             filled([p.speed_ratio for p in turned], rows, 1.0), "n1/n2, over that shaft's"),
        calc("all", "at that shaft", "J*", "kg cm²", "=[count]*[one]*[speed]^2",
             filled([shown(p.reflected, KG_CM2) for p in turned], rows), "n J (ω_i/ω)²"),
        rules=[SIZED, ALONE, BORED, GEARED],
    )  # fmt: skip


def on_shaft(shaft: str) -> str:
    """Return the formula of the inertia (kg m²) of all parts on a shaft, the motor's or the mechanism's."""
    return f'SUMPRODUCT(([@parts.shaft]="{shaft}")*[@parts.all])/10000'


def loads(driven: Driven, key: str) -> list[Quantity]:
    """Return the entries of the load of this kind."""
    e, travels = driven.entered.load, driven.travels
    cell = entries_of(e, f"{key}.load")
    rows = [
        cell("@mass", "Mass that travels", "m", "kg", "mass"),
        cell("@friction", "Coefficient of friction", "μ", "", "friction", "opposes the motion"),
        cell("@slope", "Slope", "γ", "°", "slope", "rising with positive travel"),
        cell("@force", "Force against positive travel", "F", "N", "force", "always, also at rest"),
    ] if travels else [
        cell("@inertia", "Inertia that turns", "J", "kg cm²", "inertia", format="General"),
        cell("@torque", "Torque against positive motion", "T", "Nm", "torque", "always, also at rest"),
        cell("@friction_torque", "Friction torque", "T_f", "Nm", "friction_torque", "opposes the motion"),
    ]  # fmt: skip
    if e.viscous is not None:
        rows.append(cell("@viscous", "Viscous friction", "c", "N s/m" if travels else "Nm s/rad", "viscous", "c ẏ"))
    return rows if e.arm is None else [
        *rows,
        cell("@arm_mass", "Arm: its mass", "m_a", "kg", "arm.mass", "its inertia is entered above"),
        cell("@arm_radius", "Arm: its centre of mass from the axis", "r_a", "mm", "arm.radius"),
        cell("@arm_angle", "Arm: above the horizontal where the axis is at 0", "φ_0", "°", "arm.angle"),
    ]  # fmt: skip


# where a process force acts at the angle in the column ``at``
ACTS = "(([at]>=[@windows.from])*([at]<[@windows.from]+[@windows.span])+([at]+360<[@windows.from]+[@windows.span]))"


def windows_table(sheet: Sheet, key: str, view: DriveView) -> None:
    """Declare the process forces over the cycle."""
    driven, over = view.driven, view.tables.machine.over
    found, unit = driven.windows, "N" if driven.travels else "Nm"
    until = f"MIN(360,{over.degrees_formula('[stop]')})" if over.measured else "[stop]"
    column = columns_of(driven.axis.typed.load.windows, f"{key}.load.windows", WINDOWS)
    spans = [shown((w.end - w.begin), DEGREE) for w in found]
    sheet.row += 1
    sheet.table(
        "@windows", "Process forces over the cycle: leave spare rows empty", WINDOWS,
        constant("k", "number", "k", "", list(range(1, WINDOWS + 1))),
        column("start", "from", "", over.unit, "start", format=over.format),
        column("stop", "to", "", over.unit, "stop", over.entered_of, format=over.format),
        column("force", "force", "", unit, "force", format=PLAIN),
        column("resists", "resists", "", "", "resists", "always, or moving"),
        calc("from", "from", "", "°", f"={over.degrees_formula('[start]')}+0",
             filled([w.start for w in driven.entered.load.windows], WINDOWS), format=PLAIN),
        calc("span", "for", "", "°", f"={until}-{over.degrees_formula('[start]')}+IF([stop]+0<[start]+0,360,0)",
             filled([span + (360 if span < 0 else 0) for span in spans], WINDOWS), format=PLAIN),
        calc("always", "always", "", unit, '=IF([resists]="moving",0,[force]+0)',
             filled([w.load.torque for w in found], WINDOWS)),
        calc("moving", "against motion", "", unit, '=IF([resists]="moving",[force]+0,0)',
             filled([w.load.friction for w in found], WINDOWS)),
        edge(view, "b", "begins at", "[from]", view.edges[::2]),
        edge(view, "e", "ends at", "([from]+[span])", view.edges[1::2]),
        *([beyond(over)] if over.measured else []),
    )  # fmt: skip


def edge(view: DriveView, name: str, label: str, at: str, values: list[float]) -> Quantity:
    """Return the column of where a force begins or ends, in degrees of the motion as its phases tell it."""
    told = f"({at}-[axes_taken.late.{view.driven.number}])"
    return calc(name, label, "θ", "°", f'=IF([start]="",360,{told}-360*INT(({told}+eps)/360))', values,
                "of its phases; 360 if spare", scale=360.0, format=PLAIN)  # fmt: skip


def windows_check(view: DriveView) -> Quantity:
    """Return the check that process forces end with the cycle, of which an entry says how long it is."""
    over, i = view.tables.machine.over, view.driven.number
    label = f"{view.driven.called}: no process force goes on beyond the cycle"
    called, rule = f'[axes.name.{i}]&" process force "', over.rule("axes", i, "forces")
    return no_fault("@ok_windows", label, "[@windows.beyond]", called, rule)
