"""The engine's view of the drive of the tool's shaft: motor and reducer in use, at points of the cycle."""

import numpy as np

from engine.drive.drive_points import DrivePoints
from engine.drive.motor import Falling, Motor, reserve
from engine.flying.points import cycle_of, furthest, train_of
from engine.laws.base import Array
from engine.selection.point_load import PointLoad
from engine.selection.ratios import best_ratio
from workbook.book.rows import filled
from workbook.entries.texts import place_of
from workbook.entries.units import PER_HOUR, RPM, shown
from workbook.machines.flying.view import Flying
from workbook.selection.choosing import Choosing
from workbook.selection.entries import Selection, SelectionSizes
from workbook.selection.shaft import Figure, Shaft

LEAST = 1e-3  # Nm, W, rad/s²: what is smaller is next to nothing
BESIDE = Figure("beside", "parts beside the motor", "kg m²", "0", 0.0)
LEFT = Figure("left", "rated torque available at the ambient temperature", "", "1", 1.0)
DRIVES, DRIVEN = ("*([drive_pt.S]*[drive_pt.dir]>=0)", "*([drive_pt.S]*[drive_pt.dir]<0)")
"""where the shaft drives the load, and where the load drives it"""


class ToolDrive:
    """The tool's shaft behind a motor and its reducer: those that are named, else the proposed ones. SI units."""

    def __init__(self, machine: Flying, chosen: Selection, sizes: SelectionSizes) -> None:
        self.machine, self.chosen, self.sizes = machine, chosen, sizes
        cut, load, scales = machine.cut, machine.load, machine.scales
        bare = cycle_of(cut, train_of(cut, load)).points()
        self.asked = PointLoad(bare, cut.max_angular_speed, float(np.abs(bare.output_torque).max()), load.inertia)
        self.torque = max(self.asked.torque, scales.torque, LEAST)  # the scale of torques of the shaft
        self.turning = max(
            float(np.abs(bare.shaft_acceleration).max()), scales.angular_acceleration
        )  # that of its accelerations
        self.before = Choosing(chosen, sizes, [self._shaft([LEFT, BESIDE, self._cycles])])

        self.pair = self._pair()  # motor and reducer in use, by their places in the catalogue, from 0
        self.gears = self.before.grid.pair(*self.pair)  # J_M + J_T, i, η and no-load torque
        m, r = self.before.motors, self.before.reducers
        motor = m.inertia, m.rated_torque, m.peak_torque, m.max_speed, m.stall, m.falls_to
        self.motor = Motor(*(float(one[self.pair[0]]) for one in motor))
        self.falling = Falling(*self.before.curve(self.pair[0])[1:])
        limits = (
            float(one[self.pair[1]])
            for one in (r.max_input_speed, self.before.grid.most_output_torque, r.max_mean_torque)
        )
        self.limits = [0.0 if np.isinf(one) else one for one in limits]  # of the reducer; 0: none

        self.cycle = cycle_of(cut, train_of(cut, load, self.gears))
        self.load = self.cycle.points()
        self.points = DrivePoints(self.load)
        self.speed = self.gears.ratio * cut.max_angular_speed  # the largest of the motor
        self.peak = float(np.abs(self.points.torque).max())  # of the motor: no torque is larger between the points
        self.motor_torque = max(self.peak, self.torque / self.gears.ratio, LEAST)  # the scale of its torques
        self.left = self.falling.reserve(self.motor.peak_torque, self.points.torque, self.points.speed)
        self.reserve = reserve(self.motor, self.points.rms_torque, self.peak, self.speed, self.points.mean_speed)
        self.turns = furthest(self.load, self.cycle.still)  # where the tool stands between points
        self.stroke = float(np.ptp(self.turns[1]))

    def _pair(self) -> tuple[int, int]:
        """Return motor and reducer: as named, or else proposed; the first of the catalogue where no pair can do it."""
        view = self.before
        m, r = view.ranked[view.proposed or 0] if view.ranked else (0, 0)
        motor, reducer = self.chosen.motor, self.chosen.reducer
        return (place_of(motor, view.motors.names) if motor else m,
                place_of(reducer, view.reducers.names) if reducer else r)  # fmt: skip

    @property
    def balance(self) -> float:
        """τ/τ_opt; 0 of a load that does not move. Source: S5, eq. (18), step 7."""
        task = self.before.grid.task
        inertia, ratio, efficiency, _ = self.gears
        return 1.0 / (ratio * float(best_ratio(task, inertia, efficiency))) if task.moves else 0.0

    def by_point(self, values: Array, spare: float | None = None) -> list[float]:
        """Return values of the points; spare rows have that of the last, or another."""
        flat = values.ravel()
        return filled(flat, self.machine.room * values.shape[-1], float(flat[-1]) if spare is None else spare)

    @property
    def _cycles(self) -> Figure:
        return Figure(
            "cycles", "cycles an hour", "1/h", "3600/fly_tc", shown(1.0 / self.machine.cut.cycle_time, PER_HOUR)
        )

    def _shaft(self, figures: list[Figure]) -> Shaft:
        return Shaft("shaft", 1, '="shaft"', "tool", self.machine.room, self.asked, "ABS({})*30/PI()", self.turning,
                     self.torque, figures)  # fmt: skip

    def choosing(self) -> Choosing:
        """Return the choice of motor and reducer, with the pair in use."""
        own, mixed, mixed_back, square, square_back, *ways = self.asked.squares
        turning, torque, (m, r) = self.turning, self.torque, self.pair
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
            self._cycles,
            Figure("inertia", "inertia", "kg m²", "fly_j", self.asked.inertia),
            BESIDE,
            Figure("brake", "held by a brake at rest", "", "0", 0.0),
            Figure("by_power", "losses by the flow of power", "", "1", 1.0),
            LEFT,
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


def mean(one: str, other: str, where: str = "") -> str:
    """Return the formula of the mean of a product over the cycle."""
    return f"SUMPRODUCT([drive_pt.share]{where},[drive_pt.{one}],[drive_pt.{other}])"
