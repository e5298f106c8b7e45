"""The engine's view of the drive of the tool's shaft: motor and reducer in use, at points of the cycle."""

import numpy as np

from engine.drive.drive_points import DrivePoints
from engine.drive.motor import Falling, Motor, reserve
from engine.flying.pieces import cycle_of, furthest, train_of
from engine.laws.base import Array
from engine.selection.point_load import PointLoad
from engine.selection.task import best_ratio
from workbook.book.rows import filled
from workbook.entries.texts import place_of
from workbook.entries.units import PER_HOUR, RPM, shown
from workbook.machines.flying.view import Flying
from workbook.selection.choosing import Choosing
from workbook.selection.entries import Selection, SelectionSizes
from workbook.selection.shaft import Figure, Shaft, figures

LEAST = 1e-3  # Nm, W, rad/s²: what is smaller is next to nothing
BEFORE = [Figure("beside", "", "", "0", 0.0), Figure("left", "", "", "1", 1.0)]  # what is asked of no pair yet
DRIVES, DRIVEN = ("*([@pt.S]*[@pt.dir]>=0)", "*([@pt.S]*[@pt.dir]<0)")
"""where the shaft drives the load, and where the load drives it"""


class ToolDrive:
    """The tool's shaft behind a motor and its reducer: those that are named, else the proposed ones. SI units."""

    def __init__(self, machine: Flying, chosen: Selection, sizes: SelectionSizes) -> None:
        self.machine, self.chosen, self.sizes = machine, chosen, sizes
        cut, load, scales = machine.cut, machine.load, machine.scales
        bare = cycle_of(cut, train_of(cut, load)).points()
        self.asked = PointLoad(bare, cut.max_angular_speed, float(np.abs(bare.output_torque).max()), load.inertia)
        self.torque = max(self.asked.torque, scales["Nm"], LEAST)  # the scale of torques of the shaft
        hardest = float(np.abs(bare.shaft_acceleration).max())
        self.turning = max(hardest, scales["rad/s²"])  # the scale of its accelerations
        self.cycles = "3600/fly_tc", shown(1.0 / cut.cycle_time, PER_HOUR)  # an hour: the formula, and the figure
        self.before = Choosing(chosen, sizes, [self._shaft([*BEFORE, Figure("cycles", "", "", *self.cycles)])])

        self.pair = self._pair()  # motor and reducer in use, by their places in the catalogue, from 0
        self.gears = self.before.grid.pair(*self.pair)  # J_M + J_T, i, η and no-load torque
        m, r = self.before.motors, self.before.reducers
        motor = m.inertia, m.rated_torque, m.peak_torque, m.max_speed, m.stall, m.falls_to
        self.motor = Motor(*(float(one[self.pair[0]]) for one in motor))
        self.falling = Falling(*self.before.curve(self.pair[0])[1:])
        limits = r.max_input_speed, self.before.grid.most_output_torque, r.max_mean_torque
        found = [float(one[self.pair[1]]) for one in limits]
        self.limits = [0.0 if np.isinf(one) else one for one in found]  # of the reducer; 0: none

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

    def _shaft(self, figures: list[Figure]) -> Shaft:
        return Shaft("shaft", 1, '="shaft"', "tool", self.machine.room, self.asked, "ABS({})*30/PI()", self.turning,
                     self.torque, figures)  # fmt: skip

    def choosing(self) -> Choosing:
        """Return the choice of motor and reducer, with the pair in use."""
        own, mixed, mixed_back, square, square_back, *ways = self.asked.squares
        turning, torque, (m, r) = self.turning, self.torque, self.pair
        motor, (inertia, ratio, efficiency, no_load) = self.motor, self.gears
        rows = figures("drive_", {
            "own": (mean("al", "al"), own, turning**2), "square": (mean("S", "S", DRIVES), square, torque**2),
            "square_back": (mean("S", "S", DRIVEN), square_back, torque**2),
            "product": (mean("al", "S", DRIVES), mixed, turning * torque),
            "product_back": (mean("al", "S", DRIVEN), mixed_back, turning * torque),
            "way": (mean("dir", "dir"), ways[0]), "way_turning": (mean("al", "dir"), ways[1], turning),
            "way_behind": (mean("S", "dir", DRIVES), ways[2], torque),
            "way_back": (mean("S", "dir", DRIVEN), ways[3], torque), "speed": ("fly_w_max", self.asked.speed),
            "mean": ("SUMPRODUCT([@pt.share],([@pt.w]^2)^0.5)", self.asked.mean_speed),
            "smax": ("@smax", self.asked.torque, torque), "smean": ("@smean", self.asked.mean_torque, torque),
            "cycles": self.cycles, "inertia": ("fly_j", self.asked.inertia),
            "beside": ("0", 0.0), "brake": ("0", 0.0), "by_power": ("1", 1.0),
            "left": ("1", 1.0), "held_j": ("@j", inertia), "held_jm": ("@jm", motor.inertia),
            "held_i": ("@i", ratio), "held_eta": ("@eta", efficiency), "held_no_load": ("@no_load", no_load),
            "held_rated": ("@continuous", self.reserve.rms_torque.limit),
            "held_peak": ("@motor_peak", motor.peak_torque),
            "held_top": ("MAX(@tmax,0-@tmin)", self.peak, self.motor_torque),
            "held_spare": ("@spare", float(self.left.min()), max(self.motor_torque, motor.peak_torque)),
            "held_nmax": ("@motor_nmax", shown(motor.max_speed, RPM)), "held_row": ("@motor_row", m + 1),
            "held_gear": ("@reducer_row", r + 1), "turns": ("1", 1.0),
        })  # fmt: skip
        return Choosing(self.chosen, self.sizes, [self._shaft(rows)])


def mean(one: str, other: str, where: str = "") -> str:
    """Return the formula of the mean of a product over the cycle."""
    return f"SUMPRODUCT([@pt.share]{where},[@pt.{one}],[@pt.{other}])"
