"""The results of a machine by the names of its book, without a book: of many motors and reducers at once."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, partial
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.machine.geared import Geared, Gears, Torques, Works, shares_of
from engine.motion.smoothness import shortfalls
from workbook.entries.units import RPM, shown
from workbook.laws.library import laws
from workbook.machines.machine.chain import LINKED
from workbook.machines.machine.chosen import MotorInUse, ReducerInUse, motor_in_use, reducer_in_use
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.entries import AnyMachine
from workbook.machines.machine.linked.driven import LinkedDriven
from workbook.machines.machine.view import MovingAxis, Whole
from workbook.scaling import Column, Results, Scaling
from workbook.selection.catalogue import MotorRow, ReducerRow
from workbook.selection.entries import Products

SCALES = re.compile(r"(axes\.\d+\.(?:motor|reducer))\.(?!holding$)\w+")
WEIGHED = ("mass", "cost")
ONE = Column([None], np.zeros(1, dtype=np.intp))
"""of what does not differ"""


def part(key: str) -> str:
    """Return motor or reducer of an axis, to which the entry at a key belongs; empty for all others."""
    found = SCALES.fullmatch(key)
    return found[1] if found else ""


def results(machine: AnyMachine, columns: Mapping[str, Column]) -> Results:
    """Return the results of designs that differ in motors and reducers, by the keys of these entries."""
    whole = Whole(machine, laws(machine.laws))
    found: dict[str, Callable[[], Any]] = {
        "about_rate": lambda: machine.master.rate, "timing_rate": lambda: machine.master.rate,
        "about_cycle": lambda: whole.time, "timing_cycle": lambda: whole.time,
    }  # fmt: skip
    for axis in whole.axes:
        found |= of_axis(axis)
        if axis.given.mechanism and axis.given.motor:
            linked = axis.given.mechanism.kind in LINKED
            found |= (EachStudied if linked else Studied)(axis, machine.selection, columns).results
    return found


def of_axis(axis: MovingAxis) -> Results:
    """Return the results of an axis alone."""
    i, given = axis.number, axis.given
    phases = {
        f"axis{i}.{name}.{k}": partial(of_move, axis, k - 1, figure)
        for k in range(1, len(given.phases) + 1)
        for name, figure in (("v", "v_max"), ("a", "a_max"), ("j", "j_max"), ("rms", "a_rms"))
    }
    return phases | {
        f"axes.v.{i}": lambda: axis.fastest,
        f"axes.a.{i}": lambda: axis.hardest,
        f"axes.travel.{i}": lambda: shown(axis.motion.lifts_sum, axis.unit),
        f"axis{i}_smooth": lambda: told(not shortfalls(axis.motion, given.smoothness)),
        f"axis{i}_closes": lambda: told(axis.axis.closes),
    }


def of_move(axis: MovingAxis, k: int, figure: str) -> float:
    """Return a figure of a phase, from 0; 0 of one that does not lift."""
    return float(getattr(axis.moves[k], figure)) if k in axis.moves else 0.0


def told(ok: Any) -> Any:
    """Return verdicts in words."""
    return np.where(ok, "OK", "FAIL")


class Studied:
    """The drive of an axis with many motors and reducers."""

    def __init__(self, axis: MovingAxis, products: Products, columns: Mapping[str, Column]) -> None:
        self.axis, self.products = axis, products
        begin = f"axes.{axis.number - 1}"
        self.motor_key, self.motors = only(columns, f"{begin}.motor")
        self.reducer_key, self.reducers = only(columns, f"{begin}.reducer")

    def motor(self, value: Any) -> MotorInUse:
        """Return the motor with another entry."""
        return motor_in_use(changed(self.axis, "motor", self.motor_key, value), self.products)

    def reducer(self, value: Any) -> ReducerInUse:
        """Return the reducer with another entry."""
        return reducer_in_use(changed(self.axis, "reducer", self.reducer_key, value), self.products)

    @cached_property
    def motors_used(self) -> dict[str, Array]:
        """The figures of the motor in each design."""
        used = [self.motor(value) for value in self.motors.values]
        return figures(used, self.motors, self.products.motors)

    @cached_property
    def reducers_used(self) -> dict[str, Array]:
        """The figures of the reducer in each design."""
        used = [self.reducer(value) for value in self.reducers.values]
        return figures(used, self.reducers, self.products.reducers)

    @cached_property
    def geared(self) -> Geared:
        """What the cycle asks for behind the reducer."""
        return Geared(Driven(self.axis, self.products).demand.course)

    @cached_property
    def at_reducer(self) -> Array:
        """Inertia of the reducer and of parts on the motor's shaft (kg m²)."""
        parts = Driven(self.axis, self.products).parts
        return self.reducers_used["inertia"] + math.fsum(part.reflected for part in parts if not part.shaft)

    @cached_property
    def gears(self) -> Gears:
        """Motors with their reducers."""
        used = self.reducers_used
        inertia = self.motors_used["inertia"] + self.at_reducer
        return Gears(*np.broadcast_arrays(inertia, used["ratio"], used["efficiency"]))

    @cached_property
    def torques(self) -> Torques:
        """Lowest and highest torques (Nm)."""
        return self.geared.torques(self.gears)

    @cached_property
    def rms(self) -> Array:
        """RMS torques (Nm)."""
        return self.geared.rms_torque(self.gears)

    @cached_property
    def speed(self) -> Array:
        """Largest speeds (rpm)."""
        return shown(self.geared.speed(self.gears.ratio), RPM)

    @cached_property
    def works(self) -> Works:
        """Energies (J)."""
        return self.geared.works(self.gears)

    @property
    def at_motor(self) -> Array:
        """Inertia at the motor, without it (kg m²)."""
        return self.at_reducer + self.geared.inertia(self.gears.ratio)

    @cached_property
    def behind(self) -> Any:
        """Largest torque behind the reducer (Nm)."""
        return self.geared.demand.shaft_torque(1).peak

    @cached_property
    def mean_behind(self) -> Any:
        """Mean torque behind the reducer (Nm)."""
        return self.geared.demand.mean_shaft_torque(1)

    def within(self, limit: str, value: Any) -> Any:
        """Return whether what is asked of the reducer is within its limit, 0 for none."""
        limits = self.reducers_used[limit]
        return told((limits == 0.0) | (value <= limits))

    def pair(self, figure: str) -> Array:
        """Return mass or cost of motor and reducer together."""
        return self.motors_used[figure] + self.reducers_used[figure]

    @property
    def power(self) -> Array:
        """Mean powers (W)."""
        return self.geared.mean_power(self.works)

    @property
    def results(self) -> dict[str, Callable[[], Any]]:
        """All of them by name, each worked out when it is called."""

        def motor(figure: str) -> Array:
            return self.motors_used[figure]

        def reducer(figure: str) -> Array:
            return self.reducers_used[figure]

        each: dict[str, Callable[[], Any]] = {
            "jtot": lambda: self.at_motor,
            "inertias": lambda: shares_of(self.at_motor, motor("inertia")),
            "tmax": lambda: self.torques.highest,
            "tmin": lambda: self.torques.lowest,
            "rms": lambda: self.rms,
            "speed": lambda: self.speed,
            "res_rms": lambda: shares_of(motor("rated_torque"), self.rms),
            "res_peak": lambda: shares_of(motor("peak_torque"), self.torques.peak),
            "res_speed": lambda: shares_of(motor("max_speed"), self.speed),
            "smax": lambda: self.behind,
            "smean": lambda: self.mean_behind,
            "energy": lambda: self.works.driving,
            "returned": lambda: self.works.regenerated,
            "power": lambda: self.power,
            "ok_rms": lambda: told(self.rms <= motor("rated_torque")),
            "ok_peak": lambda: told(self.torques.peak <= motor("peak_torque")),
            "ok_speed": lambda: told(self.speed <= motor("max_speed")),
            "ok_reducer_peak": lambda: self.within("peak_torque", self.behind),
            "ok_reducer_mean": lambda: self.within("mean_torque", self.mean_behind),
            "ok_reducer_speed": lambda: self.within("max_speed", self.speed),
            "i1": lambda: reducer("ratio"),
        }
        for figure in WEIGHED:
            each |= {
                f"motor_{figure}": partial(motor, figure),
                f"reducer_{figure}": partial(reducer, figure),
                f"pair_{figure}": partial(self.pair, figure),
            }
        return {f"drive{self.axis.number}_{name}": value for name, value in each.items()}


class EachStudied(Studied):
    """The drive of a mechanism of a changing ratio with many motors and reducers: each pair by itself."""

    @cached_property
    def pairs(self) -> list[tuple[int, int]]:
        """The motor and the reducer of each design, by their places among those that differ."""
        both = np.broadcast_arrays(self.motors.places, self.reducers.places)
        return list(zip(*(places.tolist() for places in both), strict=True))

    @cached_property
    def drives(self) -> dict[tuple[int, int], LinkedDriven]:
        """The drive with each pair that a design has."""
        return {pair: self._drive(*pair) for pair in dict.fromkeys(self.pairs)}

    def _drive(self, motor: int, reducer: int) -> LinkedDriven:
        given = changed(self.axis, "motor", self.motor_key, self.motors.values[motor])
        held = MovingAxis(given, self.axis.number, self.axis.library, self.axis.speed)
        given = changed(held, "reducer", self.reducer_key, self.reducers.values[reducer])
        return LinkedDriven(MovingAxis(given, self.axis.number, self.axis.library, self.axis.speed), self.products)

    def each(self, figure: Callable[[LinkedDriven], float]) -> Array:
        """Return a figure of each design's drive."""
        found = {pair: figure(drive) for pair, drive in self.drives.items()}
        return np.array([found[pair] for pair in self.pairs])

    @property
    def at_motor(self) -> Array:
        """Largest inertia at the motor over the cycle, without it (kg m²)."""
        return self.each(lambda drive: drive.inertia)

    @cached_property
    def torques(self) -> Torques:
        """Lowest and highest torques (Nm)."""
        lowest = self.each(lambda drive: drive.demand.torque.lowest.value)
        return Torques(lowest, self.each(lambda drive: drive.demand.torque.highest.value))

    @cached_property
    def rms(self) -> Array:
        """RMS torques (Nm)."""
        return self.each(lambda drive: drive.demand.rms_torque)

    @cached_property
    def speed(self) -> Array:
        """Largest speeds (rpm)."""
        return shown(self.each(lambda drive: drive.demand.speed.peak), RPM)

    @cached_property
    def works(self) -> Works:
        """Energies (J)."""
        driving = self.each(lambda drive: drive.demand.energy.driving)
        return Works(driving, self.each(lambda drive: drive.demand.energy.regenerated))

    @property
    def power(self) -> Array:
        """Mean powers (W)."""
        return self.each(lambda drive: drive.demand.mean_power)

    @cached_property
    def behind(self) -> Any:
        """Largest torques behind the reducers (Nm)."""
        return self.each(lambda drive: drive.reducer_checks[0].value)

    @cached_property
    def mean_behind(self) -> Any:
        """Mean torques behind the reducers (Nm)."""
        return self.each(lambda drive: drive.reducer_checks[1].value)


def figures(
    used: Sequence[MotorInUse] | Sequence[ReducerInUse], column: Column, products: Sequence[MotorRow | ReducerRow]
) -> dict[str, Array]:
    """Return the figures of products in use in each design, and what those of the catalogue weigh and cost."""
    rows = [None, *products]
    names = used[0]._fields
    own = {name: np.array([getattr(one, name) for one in used], dtype=np.float64) for name in names}
    more = {name: np.array([getattr(rows[one.row], name, None) for one in used], dtype=np.float64) for name in WEIGHED}
    return {name: values[column.places] for name, values in (own | more).items()}


def only(columns: Mapping[str, Column], place: str) -> tuple[str, Column]:
    """Return the entry of a motor or reducer that differs, and how; nothing where none does."""
    return next(((key.removeprefix(f"{place}."), one) for key, one in columns.items() if part(key) == place), ("", ONE))


def changed(axis: MovingAxis, place: str, key: str, value: Any) -> Any:
    """Return the entries of an axis with another entry of its motor or reducer."""
    entries = getattr(axis.given, place)
    return axis.given.model_copy(update={place: entries.model_copy(update={key: value})}) if key else axis.given


SCALING = Scaling(part, results)
