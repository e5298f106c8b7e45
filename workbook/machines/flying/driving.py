"""The engine's view of the drive of the tool's shaft: motor and reducer in use, at points of the cycle."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from engine.drive.drive_points import DrivePoints
from engine.drive.falling_peak import Falling
from engine.drive.motor import Corners, Motor, Reserve, reserve
from engine.drive.quadrature import LoadPoints
from engine.flying.points import CutCycle, cycle_of, furthest, train_of
from engine.laws.base import Array
from engine.selection.pair_matrix import Pair
from engine.selection.point_load import PointLoad
from engine.selection.ratios import best_ratio
from workbook.book.rows import filled
from workbook.entries.texts import place_of
from workbook.entries.units import RPM, shown
from workbook.machines.flying.view import Flying
from workbook.selection.choosing import Choosing
from workbook.selection.entries import Selection, SelectionSizes
from workbook.selection.shaft import Figure, Shaft

LEAST = 1e-3
"""Nm, W, rad/s²: what is smaller is next to nothing"""


class ToolDrive:
    """The tool's shaft behind a motor and its reducer: those that are named, else the proposed ones."""

    def __init__(self, machine: Flying, chosen: Selection, sizes: SelectionSizes) -> None:
        self.machine, self.chosen, self.sizes = machine, chosen, sizes
        self.before = Choosing(chosen, sizes, [self._shaft([Figure("left", "", "", "1", 1.0), BESIDE])])

    @cached_property
    def load(self) -> LoadPoints:
        """The shaft at the points, with the pair before it."""
        return self.cycle.points()

    @cached_property
    def cycle(self) -> CutCycle:
        """The cycle with the pair before the shaft."""
        return cycle_of(self.machine.cut, train_of(self.machine.cut, self.machine.load, self.gears))

    @property
    def still(self) -> float:
        """The speed up to which the tool counts as at rest (m/s)."""
        return self.cycle.still

    @cached_property
    def asked(self) -> PointLoad:
        """What the shaft asks for, whatever drives it."""
        cut, load = self.machine.cut, self.machine.load
        points = cycle_of(cut, train_of(cut, load)).points()
        return PointLoad(points, cut.max_angular_speed, float(np.abs(points.output_torque).max()), load.inertia)

    @cached_property
    def proposed(self) -> tuple[int, int]:
        """The pair that the sheet Selection proposes: the first in the catalogue where none can do it."""
        ranked = self.before.ranked
        return ranked[self.before.proposed or 0] if ranked else (0, 0)

    @cached_property
    def pair(self) -> tuple[int, int]:
        """Motor and reducer in use, by their places in the catalogue, from 0."""
        tables = (self.chosen.motor, self.before.motors.names), (self.chosen.reducer, self.before.reducers.names)
        named = [place_of(name, names) if name else place for (name, names), place in zip(tables, self.proposed,
                                                                                          strict=True)]  # fmt: skip
        return named[0], named[1]

    @property
    def gears(self) -> Pair:
        """J_M + J_T (kg m²), i, η and no-load torque of the pair."""
        return self.before.grid.pair(*self.pair)

    @cached_property
    def motor(self) -> Motor:
        """The motor."""
        m, k = self.before.motors, self.pair[0]
        figures = m.inertia, m.rated_torque, m.peak_torque, m.max_speed, m.stall, m.falls_to
        return Motor(*(float(one[k]) for one in figures))

    @property
    def falling(self) -> Falling:
        """How the motor's peak torque falls."""
        _, knee, fall = self.before.curve(self.pair[0])
        return Falling(knee, fall)

    @property
    def limits(self) -> tuple[float, float, float]:
        """The reducer's largest input speed (rad/s), output torque and mean torque (Nm); 0 of what it does not give."""
        r, k = self.before.reducers, self.pair[1]
        found = (float(one[k]) for one in (r.max_input_speed, r.max_output_torque, r.max_mean_torque))
        speed, torque, mean = (0.0 if np.isinf(one) else one for one in found)
        return speed, torque, mean

    @cached_property
    def points(self) -> DrivePoints:
        """The motor at the points."""
        return DrivePoints(self.load)

    @cached_property
    def left(self) -> Array:
        """What is left below the motor's curve at the points (Nm)."""
        return self.falling.reserve(self.motor.peak_torque, self.points.torque, self.points.speed)

    @property
    def speed(self) -> float:
        """The largest speed of the motor (rad/s)."""
        return self.gears.ratio * self.machine.cut.max_angular_speed

    @property
    def reserve(self) -> Reserve:
        """What the cycle asks of the motor against its limits."""
        return reserve(self.motor, self.points.rms_torque, self.peak, self.speed, self.points.mean_speed)

    @property
    def peak(self) -> float:
        """The largest torque of the motor (Nm): at points, as no torque is larger between them."""
        return float(np.abs(self.points.torque).max())

    @property
    def balance(self) -> float:
        """τ/τ_opt; 0 of a load that does not move. Source: S5, eq. (18), step 7."""
        task = self.before.grid.task
        inertia, ratio, efficiency, _ = self.gears
        return 1.0 / (ratio * float(best_ratio(task, inertia, efficiency))) if task.moves else 0.0

    @property
    def corners(self) -> Corners:
        """The limits of the motor, as drawn."""
        return self.motor.corners(min(0.0, float(self.load.direction.min())), *self.falling)

    @cached_property
    def turns(self) -> tuple[Array, Array]:
        """Where the tool stands between points."""
        return furthest(self.load, self.still)

    @property
    def stroke(self) -> float:
        """The stroke by points (m)."""
        return float(np.ptp(self.turns[1]))

    def by_point(self, values: Array, spare: float | None = None) -> list[float]:
        """Return values of the points; spare rows have that of the last, or another."""
        flat = values.ravel()
        return filled(flat, self.machine.room * values.shape[-1], float(flat[-1]) if spare is None else spare)

    def by_piece(self, values: Array) -> list[float]:
        """Return values of the pieces; spare rows have that of the last."""
        return filled(values, self.machine.room, float(values[-1]))

    @property
    def torque(self) -> float:
        """The scale of torques of the shaft (Nm)."""
        return max(self.asked.torque, self.machine.scales.torque, LEAST)

    @property
    def motor_torque(self) -> float:
        """The scale of torques of the motor (Nm)."""
        return max(self.peak, self.torque / self.gears.ratio, LEAST)

    def _shaft(self, figures: list[Figure]) -> Shaft:
        turning = max(float(np.abs(self.asked.load.shaft_acceleration).max()), self.machine.scales.angular_acceleration)
        return Shaft("shaft", 1, '="shaft"', "tool", self.machine.room, self.asked, "ABS({})*30/PI()", turning,
                     self.torque, figures)  # fmt: skip

    @cached_property
    def choosing(self) -> Choosing:
        """The choice of motor and reducer, with the pair in use."""
        own, mixed, mixed_back, square, square_back, *ways = self.asked.squares
        turning, torque, (m, r) = self.before.shaft.turning, self.torque, self.pair
        motor, (inertia, ratio, efficiency, no_load) = self.motor, self.gears
        figures = [
            Figure("own", "mean of α²", "rad²/s⁴", mean("al", "al"), own, turning**2),
            Figure("square", "mean of S², driving", "Nm²", mean("S", "S", DRIVES), square, torque**2),
            Figure("square_back", "… driven", "Nm²", mean("S", "S", DRIVEN), square_back, torque**2),
            Figure("product", "mean of α S, driving", "W/s", mean("al", "S", DRIVES), mixed, turning * torque),
            Figure("product_back", "… driven", "W/s", mean("al", "S", DRIVEN), mixed_back, turning * torque),
            Figure("way", "share of the cycle in motion", "", mean("dir", "dir"), ways[0]),
            Figure("way_turning", "mean of α d", "rad/s²", mean("al", "dir"), ways[1], turning),
            Figure("way_behind", "mean of S d, driving", "Nm", mean("S", "dir", DRIVES), ways[2], torque),
            Figure("way_back", "… driven", "Nm", mean("S", "dir", DRIVEN), ways[3], torque),
            Figure("speed", "largest speed", "rad/s", "fly_w_max", self.asked.speed),
            Figure("mean", "mean speed", "rad/s",
                   "SUMPRODUCT([drive_pt.share],([drive_pt.w]^2)^0.5)", self.asked.mean_speed),
            Figure("smax", "largest torque", "Nm", "drive_smax", self.asked.torque, torque),
            Figure("smean", "mean torque", "Nm", "drive_smean", self.asked.mean_torque, torque),
            Figure("inertia", "inertia", "kg m²", "fly_j", self.asked.inertia),
            BESIDE,
            Figure("brake", "held by a brake at rest", "", "0", 0.0),
            Figure("by_power", "losses by the flow of power", "", "1", 1.0),
            Figure("left", "rated torque available at the ambient temperature", "", "1", 1.0),
            Figure("held_j", "inertia with its motor", "kg m²", "drive_j", inertia),
            Figure("held_jm", "its motor", "kg m²", "drive_jm", motor.inertia),
            Figure("held_i", "its reduction", "", "drive_i", ratio),
            Figure("held_eta", "its efficiency", "", "drive_eta", efficiency),
            Figure("held_no_load", "its no-load torque", "Nm", "drive_no_load", no_load),
            Figure("held_rated", "its continuous torque", "Nm", "drive_continuous", self.reserve.rms_torque.limit),
            Figure("held_peak", "its peak torque", "Nm", "drive_motor_peak", motor.peak_torque),
            Figure("held_top", "peak torque demand", "Nm", "MAX(drive_tmax,0-drive_tmin)", self.peak,
                   self.motor_torque),
            Figure("held_spare", "reserve below the motor's curve", "Nm", "drive_spare", float(self.left.min()),
                   max(self.motor_torque, motor.peak_torque)),
            Figure("held_nmax", "its largest speed", "rpm", "drive_motor_nmax", shown(motor.max_speed, RPM)),
            Figure("held_row", "its row of motors", "", "drive_motor_row", m + 1),
            Figure("held_gear", "its row of reducers", "", "drive_reducer_row", r + 1),
            Figure("turns", "acceleration of its shaft over that of its points", "", "1", 1.0),
        ]  # fmt: skip
        return Choosing(self.chosen, self.sizes, [self._shaft(figures)])


BESIDE = Figure("beside", "parts beside the motor", "kg m²", "0", 0.0)
DRIVES, DRIVEN = ("*([drive_pt.S]*[drive_pt.dir]>=0)", "*([drive_pt.S]*[drive_pt.dir]<0)")
"""where the shaft drives the load, and where the load drives it"""


def mean(one: str, other: str, where: str = "") -> str:
    """Return the formula of the mean of a product over the cycle."""
    return f"SUMPRODUCT([drive_pt.share]{where},[drive_pt.{one}],[drive_pt.{other}])"
