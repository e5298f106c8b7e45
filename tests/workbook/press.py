"""A small book for tests of the judge: a press of two axes and a drive, declared as the machines of the product are.

Its five sheets have some 500 cells of every kind: entries alone and in tables, a catalogue, workings, results, checks
with sentences, charts. Verifying it takes a twentieth of the time that a book of ``templates/`` takes.
"""

import sys
from contextlib import contextmanager
from itertools import accumulate
from math import cos, pi, radians, sin
from pathlib import Path
from typing import Annotated, Literal

import pytest
from pydantic import Field

from workbook import templates
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, calc, check, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import amount, exceeding
from workbook.book.summary import summary_sheet
from workbook.entries.machine import Machine, Sizes
from workbook.entries.rules import limits
from workbook.fields.texts import LOOKED_UP, Text
from workbook.fields.types import Angle, Model, Number, Positive
from workbook.reading.descriptions import read_machine
from workbook.template import Template, finish

AXES = {"axis1": "feed", "axis2": "ram"}


class Phase(Model):
    """A lift of an axis between two master angles (°)."""

    start: Angle
    stop: Angle
    law: Literal["dwell", "rise"] = "dwell"
    lift: Number = 0.0


class Motor(Model):
    """A product of the catalogue: its rated torque (Nm)."""

    name: Annotated[Text, LOOKED_UP]
    torque: Positive


class Master(Model):
    """The shaft that drives the axes: its speed (cycles/min) and its crank (mm)."""

    rate: Positive
    radius: Positive = 40.0


class Drive(Model):
    """What the motor drives: inertia (kg m²), friction (Nm); what holds it at standstill."""

    inertia: Positive
    friction: Number = 0.0
    holding: Literal["motor", "brake"] = "motor"


class PressSizes(Sizes):
    """Rows of the catalogue."""

    motors: Annotated[int, Field(ge=2, le=60)] = 5


class Press(Machine):
    """The machine."""

    template: Literal["press"]
    master: Master
    drive: Drive
    feed: Annotated[list[Phase], Field(min_length=1)]
    ram: Annotated[list[Phase], Field(min_length=1)]
    motors: Annotated[list[Motor], Field(min_length=1)]
    sizes: PressSizes = PressSizes(cycle=12)


def declare(press: Press) -> Book:
    """Declare the book."""
    book = Book("press", press.title, limit=limits(Press))
    omega = press.master.rate * 2 * pi / 60
    summary_sheet(book, press, "A press, as small as can be.", [
        result("about_omega", "Speed of the master", "ω", "rad/s", "=omega", omega),
    ])  # fmt: skip
    timing(book, press, omega)
    drive(book, press, omega)
    catalogue(book, press)
    return finish(book, ("S1",))


def timing(book: Book, press: Press, omega: float) -> None:
    """Declare the sheet of the phases."""
    sheet = book.sheet("Timing", "What the axes do while the master turns once.")
    sheet.heading("Enter")
    sheet.rows(
        given("timing_rate", "Speed of the master", "n", "cycles/min", press.master.rate, "master.rate"),
        given("timing_radius", "Radius of the crank", "r", "mm", press.master.radius, "master.radius"),
    )
    sheet.heading("Results")
    sheet.rows(
        calc("omega", "Speed", "ω", "rad/s", "=timing_rate*2*PI()/60", omega, source="2π n/60"),
        result("timing_period", "Cycle time", "T", "s", "=60/timing_rate", 60 / press.master.rate),
        result("timing_unit", "Cycles in a cycle", "", "", "=timing_period*timing_rate/60", 1.0),
        result("timing_tip", "Speed of the crank's tip", "v", "m/s", "=omega*timing_radius/1000",
               omega * press.master.radius / 1000),
    )  # fmt: skip
    for name, entry in AXES.items():
        axis(sheet, name, getattr(press, entry), entry, press.sizes.phases, 6 * press.master.rate)
    sheet.print_columns = 12


def axis(sheet, name: str, phases: list[Phase], entry: str, rows: int, degrees: float) -> None:
    """Declare the table of an axis's phases, over a master of so many degrees a second; and that it comes back."""
    spans = [p.stop - p.start for p in phases]
    means = [p.lift * degrees / span if span else 0.0 for p, span in zip(phases, spans, strict=True)]
    peaks = [abs(v) * (2.0 if p.law == "rise" else 1.0) for v, p in zip(means, phases, strict=True)]
    ends = list(accumulate(p.lift for p in phases))

    def column(key: str) -> list:
        return filled((getattr(p, key) for p in phases), rows, None)

    block = sheet.table(
        name, entry.capitalize(), rows,
        constant("k", "phase", "", "", list(range(1, rows + 1))),
        given("start", "start", "θ", "°", column("start"), f"{entry}.*.start"),
        given("stop", "stop", "θ", "°", column("stop"), f"{entry}.*.stop"),
        given("law", "law", "", "", column("law"), f"{entry}.*.law"),
        given("lift", "lift", "h", "mm", column("lift"), f"{entry}.*.lift"),
        result("v", "peak velocity", "v", "mm/s", '=IF([law]="rise",2,1)*ABS([mean])', filled(peaks, rows, 0.0)),
        result("y1", "end", "y", "mm", "=IF([k]=1,0,[y1-1])+[lift]", filled(ends, rows, ends[-1]), source="Σ h"),
    )  # fmt: skip
    sheet.workings(
        block, f"{name}_workings", "Workings", 14,
        calc("span", "span", "Δθ", "°", "=[stop]-[start]", filled(spans, rows, 0.0), source="θ1 − θ0"),
        calc("mean", "mean velocity", "v", "mm/s", "=IF([span]>0,[lift]*timing_rate*6/[span],0)",
             filled(means, rows, 0.0)),
    )  # fmt: skip
    end = ends[-1]
    sheet.checks(check(f"{name}_position", f"{entry.capitalize()}: back at its begin", f"ABS({name}_end)<=check_zero",
                       abs(end) <= 1e-9, says=amount(f"{name}_end", end, "it ends ", " mm off")))  # fmt: skip
    sheet.rows(result(f"{name}_end", f"{entry.capitalize()} at the end", "y", "mm", f"=SUM([{name}.lift])", end))


def drive(book: Book, press: Press, omega: float) -> None:
    """Declare the sheet of the drive, with its cycle."""
    sheet = book.sheet("Drive MC01", "What the motor gives.")
    e, n = press.drive, press.sizes.cycle
    angles = [360.0 * k / n for k in range(n + 1)]
    speeds = [omega * press.master.radius / 1000 * cos(radians(a)) for a in angles]
    torques = [e.friction + e.inertia * omega**2 * sin(radians(2 * a)) for a in angles]
    peak, most = max(torques, key=abs), max(m.torque for m in press.motors)
    sheet.heading("Enter")
    sheet.rows(
        given("drive1_inertia", "Inertia", "J", "kg m²", e.inertia, "drive.inertia"),
        given("drive1_friction", "Friction", "T", "Nm", e.friction, "drive.friction"),
        given("drive1_holding", "Held by", "", "", e.holding, "drive.holding"),
    )
    sheet.heading("Results")
    sheet.rows(
        result("drive1_tmax", "Largest torque", "T_max", "Nm", "=MAX(MAX([cycle1.torque]),0-MIN([cycle1.torque]))",
               abs(peak), source="S1, page 3"),
        calc("drive1_most", "Torque of the largest motor", "T_lim", "Nm", "=MAX([motors.torque])", most),
        result("drive1_share", "Share of it", "", "", "=drive1_tmax/drive1_most", abs(peak) / most),
        result("drive1_says", "What holds it", "", "", '="the "&drive1_holding', f"the {e.holding}"),
    )  # fmt: skip
    says = exceeding("drive1_tmax", "drive1_most", "Nm", abs(peak), most)
    label = "Drive MC01: torque within the largest motor's"
    sheet.checks(check("drive1_peak", label, "drive1_tmax<=drive1_most", abs(peak) <= most, says=says))
    sheet.row += 1
    sheet.table(
        "cycle1", "Cycle", n + 1,
        constant("theta", "master angle", "θ", "°", angles),
        result("y", "position", "y", "mm", "=timing_radius*SIN(RADIANS([theta]))",
               [press.master.radius * sin(radians(a)) for a in angles], source="r sin θ"),
        result("v", "velocity", "v", "m/s", "=timing_tip*COS(RADIANS([theta]))", speeds, scale=abs(speeds[0])),
        result("torque", "torque", "T", "Nm",
               "=drive1_friction+drive1_inertia*omega^2*SIN(RADIANS(2*[theta]))", torques,
               scale=e.inertia * omega**2),
    )  # fmt: skip
    sheet.chart_row(*(
        Chart(label, "master angle θ [°]", f"{y} [{unit}]", (Series(label, "[cycle1.theta]", f"[cycle1.{y}]"),), label)
        for label, y, unit in (("Position", "y", "mm"), ("Torque", "torque", "Nm"))
    ))  # fmt: skip


def catalogue(book: Book, press: Press) -> None:
    """Declare the sheet of the catalogue."""
    rows = press.sizes.motors
    sheet = book.sheet("Motors", "What can be bought.")
    sheet.table(
        "motors", "Motors", rows,
        given("name", "name", "", "", filled((m.name for m in press.motors), rows, None), "motors.*.name"),
        given("torque", "rated torque", "T", "Nm", filled((m.torque for m in press.motors), rows, None),
              "motors.*.torque"),
        result("reserve", "reserve", "", "Nm", "=[torque]-drive1_tmax",
               filled([m.torque - tmax(book) for m in press.motors], rows, -tmax(book))),
    )  # fmt: skip


def tmax(book: Book) -> float:
    """Return the engine's largest torque (Nm)."""
    return book.blocks["drive1_tmax"].quantities[0].value


def variants(press: Press) -> list[Press]:
    """Return other machines of the same layout."""
    data = press.model_dump()
    drives = (Drive(inertia=0.31, friction=-2.0, holding="brake"), Drive(inertia=2.5, friction=0.7))
    others = [Phase(start=12.0, stop=77.0, law="rise", lift=7.5), Phase(start=77.0, stop=301.0, lift=0.0)]
    return [
        Press.model_validate(
            data | {"master": {"rate": rate, "radius": 17.5 * rate}, "drive": one.model_dump(), entry: others}
            | {"motors": [{"name": "X", "torque": 3.25}, {"name": "Y", "torque": 17.0 * rate}]}
        )
        for rate, one, entry in zip((33.0, 150.0), drives, AXES.values(), strict=True)
    ]  # fmt: skip


def too_weak(press: Press) -> Press:
    """Return the press with motors that are too weak: a check of its drive FAILs."""
    return press.model_copy(update={"motors": [Motor(name="M", torque=0.01)]})


TEMPLATE = Template(
    "press", Press, declare, variants, folder=Path(__file__).parent,
)  # fmt: skip


@contextmanager
def registered():
    """Make the template known by its name meanwhile; yield its machine."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(templates.MODULES, "press", "press")
        patch.setitem(sys.modules, "workbook.machines.press.template", sys.modules[__name__])
        yield read_machine(TEMPLATE.description)
