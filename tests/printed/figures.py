"""The figures that the source documents print, beside what the engine computes; docs/validation.md shows them.

A figure agrees where ours rounds to the printed digits. Where it does not, ``reason`` says why the document differs.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees, pi

from engine.drive import derating
from engine.laws import law
from engine.laws.inverse import inverse
from engine.laws.simple import ConstantAcceleration, Cycloidal
from engine.overlap.schedule import movement_time
from engine.timing import shaft_speed
from tests.printed import test_s1 as s1
from tests.printed import test_s2 as s2
from tests.printed import test_s4 as s4


@dataclass(frozen=True)
class Figure:
    """One printed figure: its section in the document, its digits as printed, the engine's, and its cell.

    ``cell`` names the cell of a template's book, or a column and a row of it, as ``actuator-sizing drive1_tmax``; its
    value times ``factor`` is in the unit of the figure. It is empty where no book has the quantity. ``exact`` has more
    digits, worked out from the document's formulas and not by the engine.
    """

    section: str
    quantity: str
    unit: str
    printed: str
    exact: str
    ours: float
    reason: str = ""
    cell: str = ""
    factor: float = 1.0

    @property
    def half_digit(self) -> float:
        """Half a unit of the last printed digit."""
        return half_digit(self.printed)

    @property
    def agrees(self) -> bool:
        """Whether ours rounds to the printed digits."""
        return abs(self.ours - float(self.printed)) <= self.half_digit * (1 + 1e-9)


def half_digit(figure: str) -> float:
    """Return half a unit of the last digit of a figure."""
    mantissa, _, exponent = figure.partition("e")
    return 0.5 * 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def cutting_machine() -> Iterator[Figure]:
    """S1, Motion curve planning 02."""
    rise = s1.movements(ConstantAcceleration(), 200 / 60)[0]
    group, feed = s1.feeding_group().mechanism, s1.results(s1.MTP)
    rounded, to_rpm = "computed from the rounded acceleration", 30 / pi
    section = "Timing diagram for a cutting machine"
    for quantity, unit, printed, ours, reason, cell in (
        ("speed of the master shaft at 200 pieces/min", "rad/s", "20.944", shaft_speed(200 / 60), "", "omega_compared"),
        ("MC01, geometric velocity, peak", "m/rad", "0.43", rise.of.y1_max, "", "axis1_taken.y1.1"),
        (
            "MC01, geometric acceleration, peak",
            "m/rad²",
            "0.61",
            rise.of.y2_max,
            "cut off, not rounded",
            "axis1_taken.y2.1",
        ),
        ("MC01, velocity, peak", "m/s", "9", rise.v_max, "", "axes.vc.1"),
        ("MC01, acceleration, peak", "m/s²", "270", rise.a_max, "", "axes.ac.1"),
    ):
        yield Figure(section, quantity, unit, printed, "", ours, reason, f"cutting-machine {cell}")
    for quantity, unit, printed, ours, reason, cell, factor in (
        ("total inertia J_tot", "kg m²", "1.164", group.inertia(), "", "j1", 1.0),
        ("resisting torque C_r", "Nm", "67", group.load.torque / group.ratio, "", "cr", 1.0),
        ("torque at the rollers, peak", "Nm", "783.5297", feed.torque.highest.value, rounded, "", 1.0),
        ("torque at the rollers, least", "Nm", "-649.5297", feed.torque.lowest.value, rounded, "", 1.0),
        ("speed of the rollers, peak", "rad/s", "33.582", feed.speed.peak, "", "ask_speed", 1.0),
        ("speed of the rollers, peak", "rpm", "320.685", feed.speed.peak * to_rpm, "", "ask_speed", to_rpm),
    ):
        place = f"cutting-machine drive1_{cell}" if cell else ""
        yield Figure("Feeding group", quantity, unit, printed, "", ours, reason, place, factor)


def overlapped_motions() -> Iterator[Figure]:
    """S2, Timing Diagram, Part 3."""
    before, after = s2.STATION.one_after_the_other(), s2.STATION.overlapping()
    whole = s2.rounded(after, 125)
    alone, along = degrees(before.angle_in), degrees(after.angle_in)
    peak, peak_before = whole.peak_acceleration(s2.RATE), before.peak_acceleration(s2.RATE)
    share, reached = 100 * Cycloidal().s(0.1), 100 * inverse(Cycloidal(), 0.38)
    time, tenth = movement_time(whole.angle_in, s2.RATE), "displacement of a cycloid after a tenth of the time"
    for section, quantity, unit, digits, ours, cell, factor in (
        ("Mill", tenth, "%", "0.65 0.645107", share, "inverse_transfer.wanted.1", 100),
        ("Die", "angle of the stroke without overlap", "°", "55 55.000000", alone, "tool1_schedules.in.1", 1),
        ("Die", "peak acceleration without overlap", "m/s²", "4.154 4.154172", peak_before, "tool1_a0", 1),
        ("Die", "time after which 19 of 50 mm are reached", "%", "44 43.92684", reached, "tool1_inverse_in.xi.1", 100),
        ("Die", "angle of the stroke with overlap", "°", "125 124.8369", along, "tool1_schedules.in.2", 1),
        ("Die", "time of the stroke at 125°", "s", "0.625 0.62500000", time, "", 1),
        ("Die", "peak acceleration at 125°", "m/s²", "0.804 0.804248", peak, "", 1),
        ("Die", "reduction of the peak acceleration", "", "5.17 5.1653", peak_before / peak, "", 1),
    ):
        place = f"indexing-overlap {cell}" if cell else ""
        yield Figure(section, quantity, unit, *digits.split(), ours, cell=place, factor=factor)


def composed_motion() -> Iterator[Figure]:
    """S3, Functional Mechanical Design, Exercise 1."""
    tvp = law("TVP").coefficients
    for quantity, printed, ours, cell in (
        ("coefficient of velocity c_v", "1.5", tvp.cv, "TVP_cv"),
        ("coefficient of acceleration c_a", "4.5", tvp.ca, "TVP_ca_max"),
    ):
        yield Figure("Function TVP", quantity, "", printed, "", ours, cell=f"motion-composer {cell}")


OF_DRIVE = {
    7: ("axes.v.1", 1.0), 8: ("drive1_speed", pi / 30), 10: ("drive1_tmax", 1.0), 12: ("drive1_tmin", 1.0),
    13: ("drive1_rms", 1.0), 14: ("drive1_derate", 1.0),
}  # fmt: skip
OF_SCREW = OF_DRIVE | {0: ("drive1_ask_beside", 1.0)}
OF_CONVEYOR = OF_DRIVE | {2: ("drive1_jtot", 1e-4), 3: ("drive1_j_all", 1e-4)}  # of the screw without η
"""the cells of figures of S4 by the numbers of these, with what turns their units into these"""


def actuators() -> Iterator[Figure]:
    """S4, Actuator Sizing."""
    yield from lead_screw()
    yield from conveyor()


def lead_screw() -> Iterator[Figure]:
    """S4, the lead screw."""
    screw, sizing, g = s4.lead_screw(), s4.sized_screw(), s4.PRINTED_G
    parts, found = s4.reflected(screw), sizing.torques
    friction, weight = (
        one / screw.ratio / screw.stages[-1].efficiency * g for one in (screw.load.friction, screw.load.torque)
    )
    rounded, fast = "from a rounded acceleration (8 mm in 0.033 s)", "divided by 0.033 s, which is rounded"
    slip, pace = "misprint for 1.605e-5", sizing.max_acceleration / pi
    for quantity, unit, digits, ours, row, factor, reason in (
        ("inertia of the screw", "kg m²", "1.47e-5 1.470878e-5", parts["screw"], 0, 1.0, ""),
        ("inertia of the load at the motor", "kg m²", "1.35e-6 1.350949e-6", parts["load"], 1, 1.0, ""),
        ("inertia of the machine", "kg m²", "1.65e-5 1.605973e-5", screw.inertia("document"), 2, 1.0, slip),
        ("total inertia", "kg m²", "2e-5 2.007466e-5", sizing.total_inertia, 3, 1.0, ""),
        ("torque of friction, g = 9.8", "Nm", "4.096e-3 4.09606e-3", friction, 4, g, ""),
        ("torque of the weight, g = 9.8", "Nm", "7.22e-3 7.22246e-3", weight, 5, g, ""),
        ("resisting torque", "Nm", "0.0113 0.01133007", found["uniform"], 6, 1.0, ""),
        ("speed of the load, peak", "m/s", "0.048 0.04800000", sizing.max_speed / screw.ratio, 7, 1.0, ""),
        ("speed of the motor, peak, over π", "rad/s", "48 48.000000", sizing.max_speed / pi, 8, 1 / pi, ""),
        ("acceleration of the motor over π", "rad/s²", "1460.4 1440.0000", pace, 9, 1 / pi, fast),
        ("torque, accelerating", "Nm", "0.103 0.1021457", found["accelerating"], 10, 1.0, rounded),
        ("torque, uniform", "Nm", "0.0113 0.01133007", found["uniform"], 11, 1.0, ""),
        ("torque, decelerating", "Nm", "-0.0805 -0.0794856", found["decelerating"], 12, 1.0, rounded),
        ("RMS torque", "Nm", "0.044 0.0437990", sizing.results.rms_torque, 13, 1.0, ""),
    ):
        cell, size = OF_SCREW.get(row, ("", 1.0))
        place = cell and f"actuator-sizing {cell}"
        yield Figure("Lead screw", quantity, unit, *digits.split(), ours, reason, place, factor * size)


def conveyor() -> Iterator[Figure]:
    """S4, the conveyor."""
    belt, sizing, g = s4.conveyor(), s4.sized_conveyor(), s4.PRINTED_G
    parts, found = s4.reflected(belt), sizing.torques
    lighter = found["uniform"] * (1.0 - g)
    added, misprint = "added up from rounded figures", "misprint: the torques that it prints give 1.44"
    ratio = "RMS torque at 35 °C over that at 25 °C (0.142 : 0.147)"
    for quantity, unit, digits, ours, row, factor, reason in (
        ("inertia of the rollers at the motor", "kg m²", "4.96e-3 4.962146e-3", parts["rollers"], 0, 1.0, ""),
        ("inertia of the belt at the motor", "kg m²", "9e-5 9.000000e-5", parts["belt"], 0, 1.0, ""),
        ("inertia of the load at the motor", "kg m²", "1.35e-3 1.350000e-3", parts["load"], 1, 1.0, ""),
        ("inertia of the machine", "kg m²", "6.4e-3 6.402146e-3", belt.inertia(), 2, 1.0, ""),
        ("total inertia", "kg m²", "0.0128 0.01280429", sizing.total_inertia, 3, 1.0, ""),
        ("uniform torque, g = 9.8", "Nm", "1.508 1.508309", found["uniform"] * g, 6, g, ""),
        ("speed of the load, peak", "m/s", "0.0185 0.01851852", sizing.max_speed / belt.ratio, 7, 1.0, ""),
        ("speed of the rollers, peak", "rad/s", "0.123 0.1234568", sizing.max_speed / 50, 8, 1 / 50, ""),
        ("speed of the motor, peak", "rad/s", "6.173 6.172840", sizing.max_speed, 8, 1.0, ""),
        ("acceleration of the motor, peak", "rad/s²", "2.058 2.057613", sizing.max_acceleration, 9, 1.0, ""),
        ("torque, accelerating, g = 9.8", "Nm", "1.5343 1.534655", found["accelerating"] - lighter, 0, 1.0, added),
        ("torque, decelerating, g = 9.8", "Nm", "1.4816 1.481963", found["decelerating"] - lighter, 0, 1.0, added),
        ("RMS torque", "Nm", "0.147 1.439627", sizing.results.rms_torque, 13, 1.0, misprint),
        (ratio, "", "0.966 0.9660918", derating(35), 14, 1.0, ""),
    ):
        cell, size = OF_CONVEYOR.get(row, ("", 1.0))
        place = cell and f"actuator-sizing-conveyor {cell}"
        yield Figure("Conveyor", quantity, unit, *digits.split(), ours, reason, place, factor * size)


DOCUMENTS = {
    "S1": (cutting_machine, "H. Giberti, Motion curve planning 02, Università di Pavia"),
    "S2": (overlapped_motions, "Timing Diagram, Part 3, Mechanical Design Handbook, 2009"),
    "S3": (composed_motion, "Functional Mechanical Design, Exercise 1"),
    "S4": (actuators, "Introduction to Mechatronics (MCT 151): Actuator Sizing, Ain Shams University, 2017"),
}
