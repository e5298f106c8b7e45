"""The sheet S4: the document's printed figures beside this book's, and what is misprinted."""

from __future__ import annotations

from typing import NamedTuple

from workbook.book.declare import Book, calc, constant
from workbook.machines.actuator.view import Sized


class Printed(NamedTuple):
    """A figure of S4, for the lead screw and the conveyor; a text where it prints none."""

    what: str
    unit: str
    cell: str
    screw: float | str
    conveyor: float | str
    exact: tuple[float | str, float | str]
    remark: str = ""


NONE = "-"
FIGURES = (
    Printed("Inertia of the load at the motor", "kg m²", "act_jload", 1.35e-6, 1.35e-3, (1.350949e-6, 1.35e-3)),
    Printed("Inertia of the machine at the motor", "kg m²", "act_jmach", 1.65e-5, 6.4e-3, (1.605973e-5, 6.402146e-3),
            "1.65e-5 is misprinted: 1.47e-5 + 1.35e-6 = 1.605e-5"),
    Printed("Inertia in all", "kg m²", "act_jtotal", 2e-5, 0.0128, (2.007466e-5, 0.01280429)),
    Printed("Friction at the motor", "Nm", "act_tf", 4.096e-3, NONE, (4.100240e-3, 0), "worked out with g = 9.8"),
    Printed("Weight at the motor", "Nm", "act_tl", 7.22e-3, 1.508, (7.229830e-3, 1.509848), "worked out with g = 9.8"),
    Printed("Resisting torque", "Nm", "act_tr", 0.0113, 1.508, (0.01133007, 1.509848)),
    Printed("Largest speed of the load", "m/s", "act_vmax", 0.048, 0.0185, (0.048, 0.01851852)),
    Printed("Largest speed of the motor", "rad/s", "act_wmax", "48π", 6.173, (150.7964, 6.172840),
            "printed “48 A = π”, which reads 48π"),
    Printed("Largest acceleration of the motor", "rad/s²", "act_alpha", "1460.4π", 2.058, (4523.893, 2.057613),
            "1460.4π comes from 0.2/6 s rounded to 0.033 s; exactly 1440π"),
    Printed("Torque accelerating", "Nm", "[phases.acc.1]", 0.103, 1.5343, (0.1021457, 1.536194),
            "follows the rounded acceleration"),
    Printed("Torque at uniform speed", "Nm", "[phases.level.1]", 0.0113, 1.508, (0.01133007, 1.509848)),
    Printed("Torque decelerating", "Nm", "[phases.dec.1]", -0.0805, 1.4816, (-0.0794856, 1.483502),
            "follows the rounded acceleration"),
    Printed("RMS torque at 25 °C", "Nm", "act_rms", 0.044, 0.147, (0.0437990, 1.439627),
            "0.147 is misprinted by a factor of about ten"),
    Printed("Derating at 35 °C", "", "act_derate", NONE, "0.142/0.147", (1, 0.9660918),
            "S4 lowers the torque asked for; here what the motor gives is lowered"),
)  # fmt: skip


def printed_sheet(book: Book, machine: Sized) -> None:
    """Declare the sheet."""
    sheet = book.sheet("S4", "The figures that the document prints, its misprints, and this book's.")
    sheet.heading(
        "Results",
        "As delivered, one column of exact figures is this book's; with other inputs they part, as they should.",
    )
    engine = values(machine)
    sheet.table(
        "printed", "Figures of S4: problem 1, the lead screw, and problem 2, the conveyor", len(FIGURES),
        constant("what", "figure", "", "", [f.what for f in FIGURES], align="left"),
        constant("unit", "unit", "", "", [f.unit or NONE for f in FIGURES]),
        calc("here", "this book", "", "",
             [f"={f.cell}" for f in FIGURES], engine, format="[<0.001]0.0000E+00;0.00000",
             scale=machine.sides.least_torque),
        constant("screw", "lead screw, printed", "", "", [f.screw for f in FIGURES], format="General"),
        constant("screw_exact", "lead screw, exact", "", "", [f.exact[0] for f in FIGURES], format="General"),
        constant("conveyor", "conveyor, printed", "", "", [f.conveyor for f in FIGURES], format="General"),
        constant("conveyor_exact", "conveyor, exact", "", "", [f.exact[1] for f in FIGURES], format="General"),
        constant("remark", "remark", "", "", [f.remark or NONE for f in FIGURES], align="left"),
    )  # fmt: skip
    sheet.print_columns = 15


def values(machine: Sized) -> list[float]:
    """Return the engine's figures in the order of the table."""
    m, s, load = machine.mechanism, machine.sizing, machine.load
    method = machine.drive.method
    return [
        m.at_motor(load.inertia, m.last, method), m.inertia(method), machine.drive.total_inertia,
        m.driving(load.friction), m.driving(load.torque), m.driving(float(load.resisting(1.0))),
        s.load_speed, s.max_speed, s.max_acceleration, *machine.part_torques[0],
        machine.rms_torque, machine.derating,
    ]  # fmt: skip
