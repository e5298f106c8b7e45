"""The sheet S4: what the document prints of its two machines beside this book's figures, and what is misprinted."""

from dataclasses import replace
from typing import NamedTuple

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book
from workbook.fields.texts import sheet_title
from workbook.machines.machine.drive.view import DriveView

CELLS = cell_tables(__file__)

NONE = "-"
LOSSY = "/@i/(@eta1*@eta2)"
INERTIA = f"(@j0-@jm/10000+@j1/@i1^2/@eta1+@m/@i{LOSSY})"
RESISTS = f"(@rub+@steady){LOSSY}"
ALL = "[@printed.here.3]"
STEADY = "[@printed.here.6]+@no_load"  # a no-load torque is no load of the document's, but the motor has to give it


class Printed(NamedTuple):
    """A figure of S4, for the lead screw and the conveyor; a text where it prints none."""

    what: str
    unit: str
    formula: str
    screw: float | str
    conveyor: float | str
    exact: tuple[float, float]
    remark: str = ""


FIGURES = (
    Printed(
        "Inertia of the load at the motor",
        "kg m²",
        f"@mass/@i{LOSSY}",
        1.35e-6,
        1.35e-3,
        (1.350949e-6, 1.35e-3),
        "m/(η i²)",
    ),
    Printed(
        "Inertia of the machine at the motor",
        "kg m²",
        INERTIA,
        1.65e-5,
        6.4e-3,
        (1.605973e-5, 6.402146e-3),
        "1.65e-5 is misprinted: 1.47e-5 + 1.35e-6 = 1.605e-5",
    ),
    Printed(
        "Inertia in all",
        "kg m²",
        f"@jm/10000+{INERTIA}",
        2e-5,
        0.0128,
        (2.007466e-5, 0.01280429),
        "S4 takes the motor's from the ratio machine : motor, 4 and 1",
    ),
    Printed("Friction at the motor", "Nm", f"@rub{LOSSY}", 4.096e-3, NONE, (4.100240e-3, 0), "worked out with g = 9.8"),
    Printed(
        "Weight at the motor",
        "Nm",
        f"@steady{LOSSY}",
        7.22e-3,
        1.508,
        (7.229830e-3, 1.509848),
        "worked out with g = 9.8",
    ),
    Printed("Resisting torque", "Nm", RESISTS, 0.0113, 1.508, (0.01133007, 1.509848)),
    Printed("Largest speed of the load", "m/s", "@vmax*omega*@faster", 0.048, 0.0185, (0.048, 0.01851852)),
    Printed(
        "Largest speed of the motor",
        "rad/s",
        "@speed*PI()/30",
        "48π",
        6.173,
        (150.7964, 6.172840),
        "printed “48 A = π”, which reads 48π",
    ),
    Printed(
        "Largest acceleration of the motor",
        "rad/s²",
        "@i*@amax",
        "1460.4π",
        2.058,
        (4523.893, 2.057613),
        "1460.4π comes from 0.2/6 s rounded to 0.033 s; exactly 1440π",
    ),
    Printed(
        "Torque accelerating",
        "Nm",
        f"{STEADY}+{ALL}*@i*@amax",
        0.103,
        1.5343,
        (0.1021457, 1.536194),
        "follows the rounded acceleration",
    ),
    Printed("Torque at uniform speed", "Nm", STEADY, 0.0113, 1.508, (0.01133007, 1.509848)),
    Printed(
        "Torque decelerating",
        "Nm",
        f"{STEADY}-{ALL}*@i*@amax",
        -0.0805,
        1.4816,
        (-0.0794856, 1.483502),
        "follows the rounded acceleration",
    ),
    Printed(
        "RMS torque at 25 °C",
        "Nm",
        "@rms",
        0.044,
        0.147,
        (0.0437990, 1.439627),
        "0.147 is misprinted by a factor of about ten",
    ),
    Printed(
        "Derating at 35 °C",
        "",
        "@derate",
        NONE,
        "0.142/0.147",
        (1, 0.9660918),
        "S4 lowers the torque asked for; here what the motor gives is lowered",
    ),
)


def printed_sheet(book: Book, view: DriveView) -> None:
    """Declare the sheet of an axis."""
    cell = CELLS["printed"]
    driven = view.driven
    m, drive, hardest = driven.mechanism, replace(driven.train.drive, method="document"), driven.axis.max_acceleration
    values = [
        m.load.inertia / m.inertia_divisor(m.last, "document"),
        m.inertia("document"),
        drive.total_inertia,
        *map(m.driving_torque, (m.load.friction, m.load.torque, float(m.load.resisting(1.0)))),
        driven.max_geometric_velocity * driven.axis.speed,
        view.speed,
        m.ratio * hardest,
        *(float(drive.torque(a, 1.0)) for a in (hardest, 0.0, -hardest)),
        view.points.rms_torque,
        driven.left,
    ]
    title = sheet_title(str(driven.entered.printed), [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, "The figures that the document prints, its misprints, and this book's.")
    sheet.heading(
        "Results",
        "As delivered, one column of exact figures is this book's; with other inputs they part, as they should. Losses "
        "are over η always, and the laws speed up as hard as they slow down.",
    )
    with sheet.scoped(f"drive{driven.number}_"):
        sheet.table(
            "@printed",
            "Figures of S4: problem 1, the lead screw, and problem 2, the conveyor",
            len(FIGURES),
            cell("what", [f.what for f in FIGURES]),
            cell("unit", [f.unit or NONE for f in FIGURES]),
            cell("here", values, formula=[f"={f.formula}+0" for f in FIGURES], scale=view.scales.torque),
            cell("screw", [f.screw for f in FIGURES]),
            cell("screw_exact", [f.exact[0] for f in FIGURES]),
            cell("conveyor", [f.conveyor for f in FIGURES]),
            cell("conveyor_exact", [f.exact[1] for f in FIGURES]),
            cell("remark", [f.remark or NONE for f in FIGURES]),
        )
    sheet.print_columns = 15
