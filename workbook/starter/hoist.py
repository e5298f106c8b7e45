"""A hoist: a drum lifts a mass with a trapezoid of velocity. Change it to the machine that you have."""

import math
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field

from workbook.api import (
    Book,
    Chart,
    Machine,
    Positive,
    Series,
    Template,
    calc,
    check,
    constant,
    exceeding,
    finish,
    given,
    limits,
    result,
    summary_sheet,
)

# how many of each have passed at a corner of the trapezoid
RAMPS, LEVELS = [0, 1, 1, 1, 1, 2], [0, 0, 0, 1, 1, 1]
SIGNS, MOVING, ON_LEVEL = [1, 1, 0, 0, -1, -1], [0, 1, 1, 1, 1, 0], [0, 0, 1, 1, 0, 0]


class Hoist(Machine):
    """What is entered: the load and its lift, drum, reducer and motor."""

    template: Literal["hoist"]
    mass: Positive  # kg
    height: Positive  # m
    time: Positive  # s, of a lift
    ramp: Annotated[float, Field(gt=0, lt=0.5)]  # share of that time in each ramp
    drum: Positive  # diameter, mm
    ratio: Positive
    efficiency: Annotated[float, Field(gt=0, le=1)]
    inertia: Positive  # of the motor, kg cm²
    peak_torque: Positive  # of the motor, Nm


def torque(hoist: Hoist, acceleration: float) -> float:
    """Return the motor's torque (Nm) at an acceleration of the load (m/s²), while it is lifted."""
    radius = hoist.drum / 2000  # m
    lifted = hoist.mass * (9.81 + acceleration) * radius / (hoist.ratio * hoist.efficiency)
    # with the motor's own inertia
    return lifted + hoist.inertia * 1e-4 * acceleration * hoist.ratio / radius


def declare(hoist: Hoist) -> Book:
    """Declare the book: each quantity with its formula, and the value that it must have."""
    ramp, speed = hoist.ramp * hoist.time, hoist.height / (hoist.time * (1 - hoist.ramp))
    torques = [torque(hoist, sign * speed / ramp) for sign in SIGNS]
    shares = [(1 - 2 * hoist.ramp if level else hoist.ramp) / 2 for level in ON_LEVEL]
    peak = max(map(abs, torques))
    rms = math.sqrt(math.fsum(t**2 * s for t, s in zip(torques, shares, strict=True)))
    book = Book("hoist", hoist.title, limit=limits(Hoist))
    about = result("about_peak", "Peak torque of the motor", "T_max", "Nm", "=peak+0", peak)
    summary_sheet(book, hoist, "A hoist, and what its motor has to give.", [about])
    sheet = book.sheet("Hoist", "Load, drum, reducer and motor; the torque at each corner of the trapezoid.")
    sheet.heading("Enter")
    sheet.rows(
        given("mass", "Mass", "m", "kg", hoist.mass, "mass"),
        given("height", "Height", "h", "m", hoist.height, "height"),
        given("time", "Time of the lift", "t", "s", hoist.time, "time"),
        given("ramp", "Share of the time in each ramp", "", "", hoist.ramp, "ramp"),
        given("drum", "Diameter of the drum", "d", "mm", hoist.drum, "drum"),
        given("ratio", "Ratio of the reducer", "i", "", hoist.ratio, "ratio"),
        given("eta", "Efficiency of the reducer", "η", "", hoist.efficiency, "efficiency"),
        given("inertia", "Inertia of the motor", "J", "kg cm²", hoist.inertia, "inertia"),
        given("limit", "Peak torque of the motor", "T_M,max", "Nm", hoist.peak_torque, "peak_torque"),
    )
    sheet.heading("Results")
    sheet.rows(
        calc("speed", "Velocity", "v", "m/s", "=height/(time*(1-ramp))", speed, source="h / (t − t_ramp)"),
        calc("acc", "Acceleration", "a", "m/s²", "=speed/(ramp*time)", speed / ramp, source="v / t_ramp"),
        result("peak", "Peak torque", "T_max", "Nm", "=MAX(MAX([lift.torque]),0-MIN([lift.torque]))", peak),
        result("rms", "RMS torque", "T_rms", "Nm", "=SQRT(SUMPRODUCT([lift.torque]^2,[lift.share]))", rms),
    )
    says = exceeding("peak", "limit", "Nm", peak, hoist.peak_torque)
    sheet.checks(
        check("ok_peak", "Peak torque within the motor's", "peak<=limit", peak <= hoist.peak_torque, says=says)
    )
    sheet.row += 1
    sheet.table(
        "lift", "Corners of the trapezoid", len(SIGNS),
        constant("ramps", "ramps passed", "", "", RAMPS), constant("levels", "levels passed", "", "", LEVELS),
        constant("sign", "sign of a", "", "", SIGNS), constant("moving", "moving", "", "", MOVING),
        constant("level", "on the level", "", "", ON_LEVEL),
        result("t", "time", "t", "s", "=time*([ramps]*ramp+[levels]*(1-2*ramp))",
               [r * ramp + n * (hoist.time - 2 * ramp) for r, n in zip(RAMPS, LEVELS, strict=True)]),
        result("v", "velocity", "v", "m/s", "=[moving]*speed", [speed * m for m in MOVING]),
        result("torque", "torque", "T", "Nm",
               "=mass*(9.81+[sign]*acc)*drum/2000/(ratio*eta)+inertia/10000*[sign]*acc*ratio*2000/drum", torques),
        calc("share", "share of the time", "", "", "=IF([level]=1,1-2*ramp,ramp)/2", shares),
    )  # fmt: skip
    line = Series("Torque", "[lift.t]", "[lift.torque]")
    sheet.chart_row(Chart("Torque of the motor", "time t [s]", "T [Nm]", (line,), "Torque of the motor over a lift"))
    return finish(book, ())


def variants(hoist: Hoist) -> list[Hoist]:
    """Return other machines of the same layout, at which the formulas are verified too."""
    return [hoist.model_copy(update={"mass": 55.0, "time": 0.9, "ramp": ramp}) for ramp in (0.1, 0.45)]


TEMPLATE = Template("hoist", Hoist, declare, variants, folder=Path(__file__).parent)
