"""The drive of an axis with many motors and reducers at many rates: its results by the names of the book."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from engine.drive.limits import factor_at
from engine.drive.motor import Falling, continuous
from engine.drive.results import Energy, Means, means
from engine.laws.base import Array
from engine.selection.point_load import DriveBatch, Extremes, Gears, Limits, PointLoad
from engine.timing import shaft_speed, turn_time
from workbook.drive.in_short import Highest
from workbook.entries.units import PER_HOUR, PER_MINUTE, RPM, shown, si
from workbook.machines.machine.drive import in_use
from workbook.machines.machine.drive.behind import load_of
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import DriveView, with_motor
from workbook.machines.machine.entries import AnyMachine, Axis
from workbook.machines.machine.motion.tables import AxisRows
from workbook.machines.machine.view import MovingAxis
from workbook.scaling import Column
from workbook.selection.catalogue import FULL_CYCLES, MotorRow, ReducerRow

WEIGHED = ("mass", "cost")
ONE = Column([None], np.zeros(1, dtype=np.intp))
"""of what does not differ"""
OK, FAIL = "OK", "FAIL"


class Studied:
    """The drive of an axis with many motors and reducers, at many rates (cycles/min)."""

    def __init__(
        self, axis: MovingAxis, machine: AnyMachine, columns: Mapping[str, Column], rows: Callable[[], AxisRows]
    ) -> None:
        self.axis, self.machine, self.products, self.rows = axis, machine, machine.selection, rows
        begin = f"axes.{axis.number - 1}"
        self.motor_key, self.motors = only(columns, f"{begin}.motor")
        self.reducer_key, self.reducers = only(columns, f"{begin}.reducer")
        given = axis.given.rate
        master = Column([machine.per_minute], ONE.places) if given is None else Column([given], ONE.places)
        self.rates = columns.get(f"{begin}.rate") or (columns.get("master.rate", master) if given is None else master)

    def axis_with(self, motor: int, reducer: int, rate: int) -> Axis:
        """Return the entries of the axis in a design, by the places of what differs in it."""
        given = changed(self.axis.given, "motor", self.motor_key, self.motors.values[motor])
        given = changed(given, "reducer", self.reducer_key, self.reducers.values[reducer])
        return given if given.rate is None else given.model_copy(update={"rate": self.rates.values[rate]})

    @cached_property
    def motors_used(self) -> dict[str, Array]:
        """The figures of the motor in each design; the knee (rad/s) and the fall (Nm s) of its curve."""
        axes = [self.axis_with(k, 0, 0) for k in range(len(self.motors.values))]
        falls = [in_use.falling_of(one.motor.name if one.motor else "", self.products) for one in axes]
        used = [in_use.motor_in_use(one, self.products) for one in axes]
        curve = dict(zip(Falling._fields, np.array(falls).T[:, self.motors.places], strict=True))
        return figures(used, self.motors, self.products.motors) | curve

    @cached_property
    def reducers_used(self) -> dict[str, Array]:
        """The figures of the reducer in each design."""
        used = [in_use.reducer_in_use(self.axis_with(0, k, 0), self.products) for k in range(len(self.reducers.values))]
        return figures(used, self.reducers, self.products.reducers)

    @cached_property
    def bases(self) -> list[DriveView]:
        """The drive as it is entered at each rate."""
        return [DriveView(self.rows(), self.drive(0, 0, k)) for k in range(len(self.rates.values))]

    @cached_property
    def loads(self) -> list[PointLoad]:
        """What the cycle asks for behind the reducer, at each rate."""
        return [load_of(base) for base in self.bases]

    def of_rate(self, figure: Callable[[DriveView], float]) -> Array:
        """Return a figure of each design that hangs on its rate alone."""
        return np.array([figure(base) for base in self.bases])[self.rates.places]

    @cached_property
    def gears(self) -> Gears:
        """Motors with their reducers."""
        used = self.reducers_used
        inertia = self.motors_used["inertia"] + (used["inertia"] + self.bases[0].driven.beside_motor)
        return Gears(*self._lined(inertia, used["ratio"], used["efficiency"], used["no_load_torque"]))

    def _lined(self, *values: Any) -> list[Any]:
        """Return arrays with a value for each design."""
        return list(np.broadcast_arrays(*values, self.rates.places))[:-1]

    def _at_rates(self) -> Iterator[tuple[NDArray[np.intp], float, DriveBatch]]:
        """Yield which designs are at a rate, its time of a cycle (s), and their motors on the load."""
        names = ("peak_torque", "knee", "fall", "copper")
        limits = self._lined(*(self.motors_used[name] for name in names), self.gears.ratio)[:-1]
        places = self._lined(self.rates.places, self.gears.ratio)[0]
        for k, load in enumerate(self.loads):
            some = np.flatnonzero(places == k)
            many = DriveBatch(load, Gears(*(v[some] for v in self.gears)), Limits(*(v[some] for v in limits)))
            yield some, self.bases[k].driven.drive_cycle.time, many

    def _gathered(self, made: Callable[[float, DriveBatch], tuple[Array, ...]]) -> list[Array]:
        """Return figures of each design from those at each rate."""
        each = [(some, made(time, many)) for some, time, many in self._at_rates()]
        order = np.argsort(np.concatenate([some for some, _ in each]), kind="stable")
        return [np.concatenate(values)[order] for values in zip(*(found for _, found in each), strict=True)]

    @cached_property
    def extremes(self) -> Extremes:
        """Peaks over the cycle."""
        return Extremes(*self._gathered(lambda _, many: many.extremes))

    @cached_property
    def works(self) -> Energy:
        """Energy of each motor over the cycle (J)."""
        return Energy(*self._gathered(lambda time, many: many.works(time)))

    @cached_property
    def rms(self) -> Array:
        """RMS torques (Nm)."""
        return self._gathered(lambda _, many: (many.load.rms(many.gears),))[0]

    @cached_property
    def speed(self) -> Array:
        """Largest speeds of motors (rpm)."""
        return shown(self.of_rate(lambda base: base.speed / base.driven.reducer.ratio) * self.gears.ratio, RPM)

    @cached_property
    def mean(self) -> Array:
        """Mean speeds of motors (rpm)."""
        speeds = self.of_rate(lambda base: base.points.mean_speed / base.driven.reducer.ratio)
        return shown(speeds * self.gears.ratio, RPM)

    @property
    def continuous(self) -> Array:
        """What motors can give all the time at their mean speeds (Nm)."""
        motor = self.motors_used
        return continuous(motor["rated_torque"], motor["stall_torque"], motor["rated_speed"], self.mean)

    @property
    def at_motor(self) -> Array:
        """Inertia at the motor, without it (kg m²)."""
        beside = self.reducers_used["inertia"] + self.bases[0].driven.beside_motor
        return beside + self.loads[0].inertia / self.gears.ratio**2

    @property
    def brake_load(self) -> Array:
        """Largest torques that the motor's brake holds in dwells (Nm)."""
        first = self.bases[0].driven.mechanism.stages[0]
        held = self.of_rate(lambda base: base.points.brake_torque) * first.ratio * first.efficiency
        return np.asarray(held / (self.gears.ratio * self.gears.efficiency))

    def behind(self, k: int) -> Array:
        """Return the largest (0) or the mean (1) torque behind the reducer (Nm)."""
        return self.of_rate(lambda base: base.reducer_checks[k].value)

    @property
    def reducer_held(self) -> Array:
        """Largest output torque of the reducer at its cycles an hour (Nm); 0 for none."""
        used = self.reducers_used
        full = np.where(used["full_cycles"] == 0.0, FULL_CYCLES, used["full_cycles"])
        factor = factor_at(1.0 / self.time, si(full, PER_HOUR), used["cycle_factor"])
        return np.asarray(used["peak_torque"] / factor)

    @cached_property
    def time(self) -> Any:
        """Times of a cycle (s)."""
        return cycles(self.rates)

    @cached_property
    def mains(self) -> Means:
        """Mean powers from the mains and in the resistor (W)."""
        return means(self.works, self.time, self.machine.power.efficiency)

    @cached_property
    def designs(self) -> list[tuple[int, int, int]]:
        """Motor, reducer and rate of each design, by their places among those that differ."""
        each = np.broadcast_arrays(self.motors.places, self.reducers.places, self.rates.places)
        return list(zip(*(places.tolist() for places in each), strict=True))

    def drive(self, motor: int, reducer: int, rate: int) -> Driven:
        """Return the drive with a motor and a reducer at a rate."""
        speed = shaft_speed(si(self.rates.values[rate], PER_MINUTE))
        return Driven(self.axis.at_speed(speed, self.axis_with(motor, reducer, rate)), self.machine)

    @cached_property
    def views(self) -> dict[tuple[int, int, int], DriveView]:
        """The drive of each design at the points of its motion: those at one rate share their load."""
        return {one: with_motor(self.bases[one[2]], self.drive(*one)) for one in dict.fromkeys(self.designs)}

    @cached_property
    def highest_each(self) -> dict[tuple[int, int, int], Highest]:
        """The highest rate of each drive, and the limiting factor."""
        found = {}
        for one, view in self.views.items():
            most, rate = view.highest, self.rates.values[one[2]]  # the machine's entries do not tell this rate
            found[one] = most._replace(rate=most.rate * rate / view.rate) if isinstance(most.rate, float) else most
        return found

    @property
    def highest(self) -> Array:
        """Highest rates (cycles/min)."""
        return np.array([self.highest_each[one].rate for one in self.designs])

    @property
    def binds(self) -> Any:
        """The limits that bind there."""
        return np.array([self.highest_each[one].limit for one in self.designs], dtype=object)


def cycles(rate: Column) -> Any:
    """Return the times of a cycle (s)."""
    return Column([turn_time(si(one, PER_MINUTE)) for one in rate.values], rate.places).each


def figures(
    used: Sequence[in_use.MotorInUse] | Sequence[in_use.ReducerInUse],
    column: Column,
    products: Sequence[MotorRow | ReducerRow],
) -> dict[str, Array]:
    """Return the figures of products in use in each design, and what those of the catalogue weigh and cost."""
    rows = [None, *products]
    own = {name: [getattr(one, name) for one in used] for name in used[0]._fields}
    more = {name: [getattr(rows[one.row], name, None) for one in used] for name in WEIGHED}
    return {name: np.array(values, dtype=np.float64)[column.places] for name, values in (own | more).items()}


def only(columns: Mapping[str, Column], place: str) -> tuple[str, Column]:
    """Return the entry of a motor or reducer that differs, and how; nothing where none does."""
    found = ((key.removeprefix(f"{place}."), one) for key, one in columns.items() if key.startswith(f"{place}."))
    return next(found, ("", ONE))


def changed(given: Axis, place: str, key: str, value: Any) -> Axis:
    """Return the entries of an axis with another entry of its motor or reducer."""
    entries = getattr(given, place)
    return given.model_copy(update={place: entries.model_copy(update={key: value})}) if key else given


def in_words(ok: Any) -> Any:
    """Return verdicts in words."""
    return np.where(ok, OK, FAIL)
