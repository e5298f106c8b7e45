"""The drive of an axis with many motors and reducers at many rates: its results by the names of the book."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, partial
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.machine.bus import Means, means
from engine.machine.geared import Geared, Gears, Torques, Works, mean_power, shares_of
from engine.timing import shaft_speed, turn_time
from workbook.drive.in_short import Highest
from workbook.entries.units import KG_CM2, KW, PER_MINUTE, RPM, shown, si
from workbook.machines.machine.chosen import MotorInUse, ReducerInUse, motor_in_use, reducer_in_use
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import DriveView, settled_highest, with_motor
from workbook.machines.machine.entries import AnyMachine, Axis
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.view import MovingAxis
from workbook.scaling import Column
from workbook.selection.catalogue import MotorRow, ReducerRow

WEIGHED = ("mass", "cost")
ONE = Column([None], np.zeros(1, dtype=np.intp))
"""of what does not differ"""


class Studied:
    """The drive of an axis with many motors and reducers, at many rates (cycles/min)."""

    def __init__(
        self, axis: MovingAxis, machine: AnyMachine, columns: Mapping[str, Column], rows: Callable[[], AxisRows]
    ) -> None:
        self.axis, self.products, self.efficiency, self.rows = axis, machine.selection, machine.power.efficiency, rows
        begin = f"axes.{axis.number - 1}"
        self.motor_key, self.motors = only(columns, f"{begin}.motor")
        self.reducer_key, self.reducers = only(columns, f"{begin}.reducer")
        given = axis.given.rate
        master = Column([machine.per_minute], ONE.places) if given is None else Column([given], ONE.places)
        self.rates = columns.get(f"{begin}.rate") or (columns.get("master.rate", master) if given is None else master)

    def motor(self, value: Any) -> MotorInUse:
        """Return the motor with another entry."""
        return motor_in_use(changed(self.axis.given, "motor", self.motor_key, value), self.products)

    def reducer(self, value: Any) -> ReducerInUse:
        """Return the reducer with another entry."""
        return reducer_in_use(changed(self.axis.given, "reducer", self.reducer_key, value), self.products)

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
    def driven(self) -> Driven:
        """The drive as it is entered."""
        return Driven(self.axis, self.products)

    @cached_property
    def geared(self) -> Geared:
        """What the cycle asks for behind the reducer."""
        return Geared(self.driven.demand.course, np.array([speed_of(rate) for rate in self.rates.values]))

    @cached_property
    def at_reducer(self) -> Array:
        """Inertia of the reducer and of parts on the motor's shaft (kg m²)."""
        return self.reducers_used["inertia"] + math.fsum(one.reflected for one in self.driven.parts if not one.shaft)

    @cached_property
    def gears(self) -> Gears:
        """Motors with their reducers."""
        used = self.reducers_used
        inertia = self.motors_used["inertia"] + self.at_reducer
        return Gears(*np.broadcast_arrays(inertia, used["ratio"], used["efficiency"], self.rates.places))

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
        return shown(self.geared.speed(self.gears), RPM)

    @property
    def mean_speed(self) -> Array:
        """Mean speeds over the cycle (rpm)."""
        return shown(self.geared.mean_speed(self.gears), RPM)

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
        return self.geared.behind[self.rates.places]

    @cached_property
    def mean_behind(self) -> Any:
        """Mean torque behind the reducer (Nm)."""
        return self.geared.moments.mean[self.rates.places]

    def within(self, limit: str, value: Any) -> Any:
        """Return whether what is asked of the reducer is within its limit, 0 for none."""
        limits = self.reducers_used[limit]
        return told((limits == 0.0) | (value <= limits))

    def pair(self, figure: str) -> Array:
        """Return mass or cost of motor and reducer together."""
        return self.motors_used[figure] + self.reducers_used[figure]

    @cached_property
    def time(self) -> Any:
        """Times of a cycle (s)."""
        return Column([turn_time(si(rate, PER_MINUTE)) for rate in self.rates.values], self.rates.places).each

    @property
    def power(self) -> Array:
        """Mean powers (W)."""
        return mean_power(self.works, self.time)

    @cached_property
    def mains(self) -> Means:
        """Mean powers from the mains and in the resistor (W)."""
        return means(self.works, self.time, self.efficiency)

    @cached_property
    def designs(self) -> list[tuple[int, int, int]]:
        """Motor, reducer and rate of each design, by their places among those that differ."""
        each = np.broadcast_arrays(self.motors.places, self.reducers.places, self.rates.places)
        return list(zip(*(places.tolist() for places in each), strict=True))

    def drive(self, motor: int, reducer: int, rate: int) -> Driven:
        """Return the drive with a motor and a reducer at a rate."""
        given, axis = changed(self.axis.given, "motor", self.motor_key, self.motors.values[motor]), self.axis
        given = changed(given, "reducer", self.reducer_key, self.reducers.values[reducer])
        at = self.rates.values[rate]
        given = given if given.rate is None else given.model_copy(update={"rate": at})
        return Driven(MovingAxis(given, axis.number, axis.library, speed_of(at)), self.products)

    @cached_property
    def drives(self) -> dict[tuple[int, int, int], Driven]:
        """The drive of each design."""
        return {one: self.drive(*one) for one in dict.fromkeys(self.designs)}

    def each(self, figure: Callable[[Driven], float]) -> Array:
        """Return a figure of each design's drive, which is worked out by itself."""
        found = {one: figure(drive) for one, drive in self.drives.items()}
        return np.array([found[one] for one in self.designs])

    @cached_property
    def highest_each(self) -> dict[tuple[int, int, int], Highest]:
        """The highest rate of each drive, entered and read again until it stays, and the limit that binds there."""
        return {one: settled_highest(view) for one, view in self.views.items()}

    @cached_property
    def views(self) -> dict[tuple[int, int, int], DriveView]:
        """The drive of each design at the points of its motion: those at one rate share their load."""
        rows, found = self.rows(), {}
        loads: dict[int, DriveView] = {}
        for one, drive in self.drives.items():
            base = loads.setdefault(one[2], DriveView(rows, drive))
            found[one] = with_motor(base, drive)
        return found

    def viewed(self, figure: Callable[[DriveView], Any]) -> Array:
        """Return a figure of each design's drive at these points."""
        found = {one: figure(view) for one, view in self.views.items()}
        return np.array([found[one] for one in self.designs])

    @property
    def highest(self) -> Array:
        """Highest rates (cycles/min)."""
        return np.array([self.highest_each[one].rate for one in self.designs])

    @property
    def binds(self) -> Any:
        """The limits that bind there."""
        return np.array([self.highest_each[one].limit for one in self.designs], dtype=object)

    @property
    def results(self) -> dict[str, Callable[[], Any]]:
        """All of them by name, each worked out when it is called."""

        def motor(figure: str) -> Array:
            return self.motors_used[figure]

        def reducer(figure: str) -> Array:
            return self.reducers_used[figure]

        each: dict[str, Callable[[], Any]] = {
            "jtot": lambda: shown(self.at_motor, KG_CM2),
            "inertias": lambda: shares_of(self.at_motor, motor("inertia")),
            "tmax": lambda: self.torques.highest,
            "tmin": lambda: self.torques.lowest,
            "rms": lambda: self.rms,
            "speed": lambda: self.speed,
            "mean": lambda: self.mean_speed,
            "res_rms": lambda: shares_of(motor("rated_torque"), self.rms),
            "res_peak": lambda: shares_of(motor("peak_torque"), self.torques.peak),
            "res_speed": lambda: shares_of(motor("max_speed"), self.speed),
            "smax": lambda: self.behind,
            "smean": lambda: self.mean_behind,
            "energy": lambda: self.works.driving,
            "returned": lambda: self.works.regenerated,
            "power": lambda: shown(self.power, KW),
            "pmax": lambda: self.each(lambda drive: shown(max(0.0, drive.demand.power.highest.value), KW)),
            "pmin": lambda: self.each(lambda drive: shown(min(0.0, drive.demand.power.lowest.value), KW)),
            "ok_rms": lambda: told(self.rms <= motor("rated_torque")),
            "ok_peak": lambda: told(self.torques.peak <= motor("peak_torque")),
            "ok_speed": lambda: told(self.speed <= motor("max_speed")),
            "ok_curve": lambda: told(self.viewed(below_curve)),
            "ok_reducer_peak": lambda: self.within("peak_torque", self.behind),
            "ok_reducer_mean": lambda: self.within("mean_torque", self.mean_behind),
            "ok_reducer_speed": lambda: self.within("max_speed", self.speed),
            "i1": lambda: reducer("ratio"),
            "rate": lambda: self.rates.each,
            "highest": lambda: self.highest,
            "binds": lambda: self.binds,
        }
        if self.products.knows_falling:
            each["spare"] = lambda: self.viewed(lambda view: view.spare)
        for figure in WEIGHED:
            each |= {
                f"motor_{figure}": partial(motor, figure),
                f"reducer_{figure}": partial(reducer, figure),
                f"pair_{figure}": partial(self.pair, figure),
            }
        return {f"drive{self.axis.number}_{name}": value for name, value in each.items()}


class EachStudied(Studied):
    """The drive of a mechanism of a changing ratio, or with viscous friction: each design by itself."""

    @property
    def at_motor(self) -> Array:
        """Largest inertia at the motor over the cycle, without it (kg m²)."""
        return self.viewed(lambda view: view.inertia)

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

    @property
    def mean_speed(self) -> Array:
        """Mean speeds over the cycle (rpm)."""
        return shown(self.each(lambda drive: drive.demand.mean_speed), RPM)

    @cached_property
    def works(self) -> Works:
        """Energies (J)."""
        driving = self.each(lambda drive: drive.demand.energy.driving)
        return Works(driving, self.each(lambda drive: drive.demand.energy.regenerated))

    @cached_property
    def behind(self) -> Any:
        """Largest torques behind the reducers (Nm)."""
        return self.each(lambda drive: drive.demand.shaft_torque(1).peak)

    @cached_property
    def mean_behind(self) -> Any:
        """Mean torques behind the reducers (Nm)."""
        return self.each(lambda drive: drive.demand.mean_shaft_torque(1))


def below_curve(view: DriveView) -> bool:
    """Return whether a motor's torque stays below its curve; of a curve that the book does not know it does not."""
    return view.spare >= 0.0 if view.knows_falling else not view.driven.catalogued_falling.fall


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
    found = ((key.removeprefix(f"{place}."), one) for key, one in columns.items() if key.startswith(f"{place}."))
    return next(found, ("", ONE))


def changed(given: Axis, place: str, key: str, value: Any) -> Axis:
    """Return the entries of an axis with another entry of its motor or reducer."""
    entries = getattr(given, place)
    return given.model_copy(update={place: entries.model_copy(update={key: value})}) if key else given


def speed_of(rate: float) -> float:
    """Return the speed of the master shaft (rad/s) at a rate."""
    return shaft_speed(si(rate, PER_MINUTE))


def told(ok: Any) -> Any:
    """Return verdicts in words."""
    return np.where(ok, "OK", "FAIL")
