"""The figures that the source documents print, beside what the engine computes; docs/validation.md shows them.

A figure agrees where ours rounds to the printed digits. Where it does not, ``reason`` says why the document differs.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees, pi

from engine.drive import derating
from engine.laws import ConstantAcceleration, Cycloidal
from engine.laws.inverse import inverse
from engine.overlap.schedule import movement_time
from engine.timing import shaft_speed
from tests.engine.sizing import reduced
from tests.printed import test_s1 as s1
from tests.printed import test_s2 as s2
from tests.printed import test_s3 as s3
from tests.printed import test_s4 as s4


@dataclass(frozen=True)
class Figure:
    """One printed figure: its section in the document, its digits as printed, and ours."""

    section: str
    quantity: str
    unit: str
    printed: str
    ours: float
    reason: str = ""

    @property
    def half_digit(self) -> float:
        """Half a unit of the last printed digit."""
        mantissa, _, exponent = self.printed.partition("e")
        decimals = len(mantissa.partition(".")[2])
        return 0.5 * 10.0 ** (int(exponent or 0) - decimals)

    @property
    def agrees(self) -> bool:
        """Whether ours rounds to the printed digits."""
        return abs(self.ours - float(self.printed)) <= self.half_digit * (1 + 1e-9)


def cutting_machine() -> Iterator[Figure]:
    """S1, Motion curve planning 02."""
    rise = s1.movements(ConstantAcceleration(), 200 / 60)[0]
    section = "Timing diagram for a cutting machine"
    yield Figure(section, "speed of the master shaft at 200 pieces/min", "rad/s", "20.944", shaft_speed(200 / 60))
    yield Figure(section, "MC01, geometric velocity, peak", "m/rad", "0.43", rise.of.y1_max)
    yield Figure(
        section, "MC01, geometric acceleration, peak", "m/rad²", "0.61", rise.of.y2_max, "cut off, not rounded"
    )
    yield Figure(section, "MC01, velocity, peak", "m/s", "9", rise.v_max)
    yield Figure(section, "MC01, acceleration, peak", "m/s²", "270", rise.a_max)
    load, feed = reduced(s1.feeding_group().mechanism), s1.results(s1.MTP)
    yield Figure("Feeding group", "total inertia J_tot", "kg m²", "1.164", load.inertia)
    yield Figure("Feeding group", "resisting torque C_r", "Nm", "67", load.torque)
    rounded = "computed from the rounded acceleration"
    yield Figure("Feeding group", "torque at the rollers, peak", "Nm", "783.5297", feed.torque.highest.value, rounded)
    yield Figure("Feeding group", "torque at the rollers, least", "Nm", "-649.5297", feed.torque.lowest.value, rounded)
    yield Figure("Feeding group", "speed of the rollers, peak", "rad/s", "33.582", feed.speed.peak)
    yield Figure("Feeding group", "speed of the rollers, peak", "rpm", "320.685", feed.speed.peak * 30 / pi)


def overlapped_motions() -> Iterator[Figure]:
    """S2, Timing Diagram, Part 3."""
    before, after = s2.STATION.one_after_the_other(), s2.STATION.overlapping()
    whole = s2.rounded(after, 125)
    slower = before.peak_acceleration(s2.RATE) / whole.peak_acceleration(s2.RATE)
    yield Figure("Mill", "displacement of a cycloid after a tenth of the time", "%", "0.65", 100 * Cycloidal().s(0.1))
    yield Figure("Die", "angle of the stroke without overlap", "°", "55", degrees(before.angle_in))
    yield Figure("Die", "peak acceleration without overlap", "m/s²", "4.154", before.peak_acceleration(s2.RATE))
    yield Figure("Die", "time after which 19 of 50 mm are reached", "%", "44", 100 * inverse(Cycloidal(), 0.38))
    yield Figure("Die", "angle of the stroke with overlap", "°", "125", degrees(after.angle_in))
    yield Figure("Die", "time of the stroke at 125°", "s", "0.625", movement_time(whole.angle_in, s2.RATE))
    yield Figure("Die", "peak acceleration at 125°", "m/s²", "0.804", whole.peak_acceleration(s2.RATE))
    yield Figure("Die", "reduction of the peak acceleration", "", "5.17", slower)


def composed_motion() -> Iterator[Figure]:
    """S3, Functional Mechanical Design, Exercise 1."""
    tvp = s3.law("TVP")
    yield Figure("Function TVP", "coefficient of velocity c_v", "", "1.5", tvp.coefficients.cv)
    yield Figure("Function TVP", "coefficient of acceleration c_a", "", "4.5", tvp.coefficients.ca)


def actuators() -> Iterator[Figure]:
    """S4, Actuator Sizing."""
    screw, belt, sizing, drawn = s4.lead_screw(), s4.conveyor(), s4.sized_screw(), s4.sized_conveyor()
    parts, rollers, g = s4.reflected(screw), s4.reflected(belt), s4.PRINTED_G
    rounded = "from a rounded acceleration (8 mm in 0.033 s)"
    yield Figure("Lead screw", "inertia of the screw", "kg m²", "1.47e-5", parts["screw"])
    yield Figure("Lead screw", "inertia of the load at the motor", "kg m²", "1.35e-6", parts["load"])
    yield Figure(
        "Lead screw", "torque of friction, g = 9.8", "Nm", "4.096e-3", screw.driving_torque(screw.load.friction) * g
    )
    yield Figure(
        "Lead screw", "torque of the weight, g = 9.8", "Nm", "7.22e-3", screw.driving_torque(screw.load.torque) * g
    )
    yield Figure("Lead screw", "torque, accelerating", "Nm", "0.103", s4.torques(sizing)["accelerating"], rounded)
    yield Figure("Lead screw", "torque, decelerating", "Nm", "-0.0805", s4.torques(sizing)["decelerating"], rounded)
    yield Figure("Lead screw", "RMS torque", "Nm", "0.044", sizing.rms_torque)
    yield Figure("Conveyor", "inertia of the rollers at the motor", "kg m²", "4.96e-3", rollers["rollers"])
    yield Figure("Conveyor", "total inertia", "kg m²", "0.0128", drawn.drive.total_inertia)
    yield Figure("Conveyor", "speed of the motor, peak", "rad/s", "6.173", drawn.max_speed)
    yield Figure("Conveyor", "acceleration of the motor, peak", "rad/s²", "2.058", drawn.max_acceleration)
    yield Figure("Conveyor", "uniform torque, g = 9.8", "Nm", "1.508", s4.torques(drawn)["uniform"] * g)
    misprint = "misprint: the torques that it prints give 1.44"
    yield Figure("Conveyor", "RMS torque", "Nm", "0.147", drawn.rms_torque, misprint)
    yield Figure("Conveyor", "RMS torque at 35 °C over that at 25 °C (0.142 : 0.147)", "", "0.966", derating(35))


DOCUMENTS = {
    "S1": (cutting_machine, "H. Giberti, Motion curve planning 02, Università di Pavia"),
    "S2": (overlapped_motions, "Timing Diagram, Part 3, Mechanical Design Handbook, 2009"),
    "S3": (composed_motion, "Functional Mechanical Design, Exercise 1"),
    "S4": (actuators, "Introduction to Mechatronics (MCT 151): Actuator Sizing, Ain Shams University, 2017"),
}
