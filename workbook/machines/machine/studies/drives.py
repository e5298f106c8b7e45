"""The drive of an axis with many motors and reducers at many rates."""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from engine.drive.limits import cycle_factor_at
from engine.drive.motor import continuous
from engine.drive.results import Energy, MeanBusPower
from engine.laws.base import Array
from engine.selection import point_load
from engine.timing import shaft_speed, turn_time
from workbook.fields.units import PER_HOUR, PER_MINUTE, RPM, shown, si
from workbook.machines.machine.drive import in_use
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.reducer_load import load_of
from workbook.machines.machine.drive.view import AT_NO_RATE, DriveView, Rates
from workbook.machines.machine.entries import AnyMachine, Axis
from workbook.machines.machine.motion_tables import AxisTables
from workbook.machines.machine.view import MovingAxis
from workbook.selection.catalogue import FULL_CYCLES
from workbook.template_outputs import Column

WEIGHED = ("mass", "cost")
FIXED = Column([None], np.zeros(1, dtype=np.intp))  # of what does not differ
# motor, reducer and rate of a design, by their places among those that differ
DesignPlaces = tuple[int, int, int]


class DriveStudy:
    """The drive of an axis with many motors and reducers, at many rates (cycles/min)."""

    def __init__(
        self, axis: MovingAxis, machine: AnyMachine, columns: Mapping[str, Column], rows: Callable[[], AxisTables]
    ) -> None:
        self.axis, self.machine, self.products, self.rows = axis, machine, machine.selection, rows
        self.limits = machine.limits.of_axis(axis.given.limits)
        begin, own = f"axes.{axis.number - 1}", axis.given.rate
        self.motor_key, self.motors = varied(columns, f"{begin}.motor.")
        self.reducer_key, self.reducers = varied(columns, f"{begin}.reducer.")
        entered = Column([machine.per_minute if own is None else own], FIXED.places)
        self.rates = columns.get(f"{begin}.rate") or (columns.get("master.rate", entered) if own is None else entered)

    def axis_with(self, motor: int, reducer: int, rate: int) -> Axis:
        """Return the entries of the axis in a design, by the places of what differs in it."""
        given = self.axis.given
        more: dict[str, Any] = {} if given.rate is None else {"rate": self.rates.values[rate]}
        for part, key, value in (
            ("motor", self.motor_key, self.motors.values[motor]),
            ("reducer", self.reducer_key, self.reducers.values[reducer]),
        ):
            more |= {part: getattr(given, part).model_copy(update={key: value})} if key else {}
        return given.model_copy(update=more)

    @cached_property
    def motors_used(self) -> dict[str, Array]:
        """The figures of the motor in each design; the knee (rad/s) and the fall (Nm s) of its curve."""
        axes = [self.axis_with(k, 0, 0) for k in range(len(self.motors.values))]
        reserve = self.limits.peak_reserve
        falls = [in_use.falling_of(axis.motor.name if axis.motor else "", self.products, reserve) for axis in axes]
        used = [in_use.motor_in_use(axis, self.products, self.limits) for axis in axes]
        return figures(self.motors, used, self.products.motors) | figures(self.motors, falls)

    @cached_property
    def reducers_used(self) -> dict[str, Array]:
        """The figures of the reducer in each design."""
        axes = [self.axis_with(0, k, 0) for k in range(len(self.reducers.values))]
        used = [in_use.reducer_in_use(axis, self.products, self.limits) for axis in axes]
        return figures(self.reducers, used, self.products.reducers)

    def drive(self, motor: int, reducer: int, rate: int) -> Driven:
        """Return the drive with a motor and a reducer at a rate."""
        speed = shaft_speed(si(self.rates.values[rate], PER_MINUTE))
        return Driven(self.axis.at_speed(speed, self.axis_with(motor, reducer, rate)), self.machine)

    @cached_property
    def bases(self) -> list[DriveView]:
        """The drive as it is entered at each rate."""
        return [DriveView(self.rows(), self.drive(0, 0, k)) for k in range(len(self.rates.values))]

    @cached_property
    def loads(self) -> list[point_load.PointLoad]:
        """The demands of the cycle behind the reducer, at each rate."""
        return [load_of(base) for base in self.bases]

    def of_rate(self, figure: Callable[[DriveView], float]) -> Array:
        """Return a figure of each design that depends on its rate alone."""
        return np.array([figure(base) for base in self.bases])[self.rates.places]

    @cached_property
    def gears(self) -> point_load.PairArrays:
        """Motors with their reducers."""
        used = self.reducers_used
        inertia = self.motors_used["inertia"] + (used["inertia"] + self.bases[0].driven.beside_motor)
        return point_load.PairArrays(*self._lined(inertia, used["ratio"], used["efficiency"], used["no_load_torque"]))

    def _lined(self, *values: Any) -> list[Any]:
        """Return arrays with a value for each design."""
        return list(np.broadcast_arrays(*values, self.rates.places))[:-1]

    def gathered(
        self,
        figures_of: Callable[[float, point_load.DriveBatch], tuple[Array, ...]],
        loads: Sequence[point_load.PointLoad] | None = None,
    ) -> list[Array]:
        """Return figures of each design, from the time of a cycle (s) at each rate and the motors on the load."""
        names, each = ("peak_torque", "knee", "fall", "copper"), []
        *limits, _, places = self._lined(*map(self.motors_used.get, names), self.gears.ratio, self.rates.places)
        for k, load in enumerate(loads or self.loads):
            some = np.flatnonzero(places == k)
            if not some.size:  # a rate of designs that are left out
                continue
            many = point_load.DriveBatch(
                load,
                point_load.PairArrays(*(v[some] for v in self.gears)),
                point_load.MotorLimits(*(v[some] for v in limits)),
            )
            each.append((some, figures_of(self.bases[k].time, many)))
        places_of_all, values = zip(*each, strict=True)
        order = np.argsort(np.concatenate(places_of_all), kind="stable")
        return [np.concatenate(column)[order] for column in zip(*values, strict=True)]

    @cached_property
    def extremes(self) -> point_load.Extremes:
        """Peaks over the cycle."""
        return point_load.Extremes(*self.gathered(lambda _, many: many.extremes))

    @cached_property
    def works(self) -> Energy:
        """Energy of each motor over the cycle (J)."""
        return Energy(*self.gathered(lambda time, many: many.works(time)))

    @cached_property
    def rms(self) -> Array:
        """RMS torques (Nm)."""
        return self.gathered(lambda _, many: (many.load.rms(many.gears),))[0]

    def turning(self, figure: Callable[[DriveView], float]) -> Array:
        """Return a speed of motors (rpm), in proportion to the ratio of their reducers."""
        return shown(self.of_rate(lambda base: figure(base) / base.driven.reducer.ratio) * self.gears.ratio, RPM)

    @cached_property
    def speed(self) -> Array:
        """Largest speeds of motors (rpm)."""
        return self.turning(lambda base: base.speed)

    @cached_property
    def mean(self) -> Array:
        """Mean speeds of motors (rpm)."""
        return self.turning(lambda base: base.points.mean_speed)

    @property
    def continuous(self) -> Array:
        """The torque that motors can give all the time at their mean speeds (Nm)."""
        motor = self.motors_used
        return continuous(motor["rated_torque"], motor["stall_torque"], motor["rated_speed"], self.mean)

    @property
    def at_motor(self) -> Array:
        """Inertia at the motor, without it (kg m²)."""
        beside = self.reducers_used["inertia"] + self.bases[0].driven.beside_motor
        return beside + self.loads[0].inertia / self.gears.ratio**2

    @property
    def inertias(self) -> Any:
        """Inertia at each motor over the motor's own."""
        return point_load.shares_of(self.at_motor, self.motors_used["inertia"])

    @property
    def brake_load(self) -> Array:
        """Largest torques that the motor's brake holds in dwells (Nm)."""
        first = self.bases[0].driven.mechanism.stages[0]
        held = self.of_rate(lambda base: base.points.brake_torque) * first.ratio * first.efficiency
        return np.asarray(held / (self.gears.ratio * self.gears.efficiency))

    def behind(self, k: int) -> Array:
        """Return the largest (0) or the mean (1) torque behind the reducer (Nm)."""
        return self.of_rate(lambda base: base.reducer_checks[k].value)

    def reducer_held_at(self, rate: Any) -> Array:
        """Return the largest output torque of the reducer (Nm) at rates (1/s); 0 for none."""
        used = self.reducers_used
        full = np.where(used["full_cycles"] == 0.0, FULL_CYCLES, used["full_cycles"])
        factor = cycle_factor_at(rate, si(full, PER_HOUR), used["cycle_factor"])
        return np.asarray(used["peak_torque"] / factor)

    @property
    def time(self) -> Any:
        """Times of a cycle (s)."""
        return cycles(self.rates)

    @cached_property
    def mains(self) -> MeanBusPower:
        """Mean powers from the mains and in the resistor (W)."""
        return self.works.mean_bus_power(self.time, self.machine.power.efficiency)

    @cached_property
    def designs(self) -> list[DesignPlaces]:
        """The places of each design's motor, reducer and rate."""
        each = np.broadcast_arrays(self.motors.places, self.reducers.places, self.rates.places)
        return list(zip(*(places.tolist() for places in each), strict=True))

    @cached_property
    def views(self) -> dict[DesignPlaces, DriveView]:
        """The drive of each design at the points of its motion: those at the same rate share their load."""
        return {places: self.view(*places) for places in dict.fromkeys(self.designs)}

    def view(self, motor: int, reducer: int, rate: int) -> DriveView:
        """Return the drive of a design at the points of its motion."""
        return DriveView(self.bases[rate].tables, self.drive(motor, reducer, rate), self.bases[rate])

    @cached_property
    def ranges(self) -> list[Rates]:
        """The rates between which each design holds all limits (cycles/min), with the limiting factors."""
        return [self.views[design].rates for design in self.designs]

    def ends(self, end: str) -> tuple[Array, Any]:
        """Return the ``high`` or ``low`` end of each range, 0 where a design holds at no rate, and what limits it."""
        rates = [0.0 if getattr(each, end) == AT_NO_RATE else getattr(each, end) for each in self.ranges]
        return np.array(rates), np.array([getattr(each, f"{end}_limit") for each in self.ranges], dtype=object)

    @property
    def holding_torque(self) -> Array:
        """The holding torque of the motor in each design (Nm)."""
        return np.array([self.views[design].points.holding_torque for design in self.designs])


def cycles(rate: Column) -> Any:
    """Return the times of a cycle (s)."""
    return Column([turn_time(si(value, PER_MINUTE)) for value in rate.values], rate.places).each


def figures(column: Column, used: Any, products: Any = ()) -> dict[str, Array]:
    """Return the figures of products in use in each design, and what those of the catalogue weigh and cost."""
    numbers = {name: [getattr(product, name) for product in used] for name in used[0]._fields}
    for name in WEIGHED if "row" in numbers else ():
        numbers[name] = [getattr([None, *products][product.row], name, None) for product in used]
    return {name: np.array(values, dtype=np.float64)[column.places] for name, values in numbers.items()}


def varied(columns: Mapping[str, Column], begin: str) -> tuple[str, Column]:
    """Return the entry of a motor or reducer that differs, and how; nothing where none does."""
    own = ((key.removeprefix(begin), column) for key, column in columns.items() if key.startswith(begin))
    return next(own, ("", FIXED))
