"""A machine without a master shaft as it is entered: all places over a cycle in s, or over an angle or a travel."""

from collections.abc import Iterator, Sequence
from typing import Annotated, Any, ClassVar, Self, TypeVar

from pydantic import Field, model_validator

from workbook.book.sentence import figure
from workbook.entries.abscissa import Abscissa, Unit, measured
from workbook.entries.phase import TURN, filling, forward
from workbook.fields.types import (
    ANGLE_TOLERANCE,
    CountsAs,
    DesignError,
    EntryError,
    MakesCells,
    Model,
    NotNegative,
    Positive,
)
from workbook.fields.units import PER_MINUTE, shown, si
from workbook.machines.machine.drive_entries import WINDOWS, AxisLoad, ForceWindow
from workbook.machines.machine.entries import MOST_AXES, AnyMachine, Axis, AxisPhase, following
from workbook.machines.machine.entries_beside import KEYS, MOST_SWITCHES, TIMES, UNUSED, SwitchEntry, TimeOn, meeting

RATES = ("velocity", "acceleration")
Lasting = TypeVar("Lasting", bound=Model)


class Cycle(Model):
    """Without a master shaft: the length of a cycle; phases, shifts, switches and process forces are in its unit too.

    Over °, rad or mm nothing tells how time passes: rates are geometric, in lift by abscissa, and there are no drives.
    """

    cycle: Annotated[Positive, CountsAs(TURN), MakesCells(TURN)] = Field(
        description="Length of a cycle: its time in s, or in the unit"
    )
    unit: Unit = Field("s", description="What the cycle is over: time, an angle, the travel of a product")

    @model_validator(mode="before")
    @classmethod
    def _alone(cls, data: Any) -> Any:
        if isinstance(data, dict) and "rate" in data:
            raise EntryError("rate", "entered beside cycle; expected one of them: a rate of a master shaft, or a cycle")
        return data


class TimedPhase(AxisPhase):
    """A phase in s of the cycle, and what it passes its begin with in m/s or rad/s.

    Over another abscissa both are in its unit, and what it passes in lift by abscissa, such as mm/°.
    """

    start: NotNegative
    stop: NotNegative


class TimedWindow(ForceWindow):
    """A process force between two times of the cycle (s)."""

    start: NotNegative
    stop: NotNegative


class TimedLoad(AxisLoad):
    """The load of an axis, its process forces in s of the cycle."""

    windows: Annotated[list[TimedWindow], Field(max_length=WINDOWS)] = []  # type: ignore[assignment] # noqa: RUF012


class TimedAxis(Axis):
    """An axis: its phases in a cycle; between them it rests."""

    PLACED: ClassVar[bool] = False
    phases: Annotated[list[TimedPhase], Field(min_length=1)]  # type: ignore[assignment]
    load: TimedLoad = TimedLoad()


class TimedOn(TimeOn):
    """A time of being on, in s or the unit of the cycle; across its end where it ends before it begins."""

    start: NotNegative | None = Field(default=None, description="From when it is on")
    stop: NotNegative | None = Field(default=None, description="To when it is on")


class TimedSwitch(SwitchEntry):
    """A lane that is on or off over the cycle."""

    PLACED: ClassVar[bool] = False
    on: Annotated[list[TimedOn], Field(max_length=TIMES)] = Field(  # type: ignore[assignment]
        default=[],
        description="When it is on: [from, to] each, or { start, stop }; past the end of the cycle where to is less",
    )


class TimedMachine(AnyMachine):
    """Axes over the seconds of a cycle, or another abscissa, without a master shaft."""

    master: Cycle  # type: ignore[assignment]
    axes: Annotated[  # type: ignore[assignment]
        list[TimedAxis], Field(min_length=1, max_length=MOST_AXES), MakesCells()
    ]
    switches: Annotated[list[TimedSwitch], MakesCells()] = Field(  # type: ignore[assignment]
        default=[], max_length=MOST_SWITCHES
    )

    @model_validator(mode="after")
    def _in_time(self) -> Self:
        untold = f"a cycle in {self.master.unit} does not tell how time passes, which a drive needs"
        for i, axis in enumerate(self.axes):
            if axis.motor is not None and not self.over.timed:
                raise EntryError(f"axes.{i}.motor", f"{untold}; expected none, or a cycle in s")
        return self

    @property
    def over(self) -> Abscissa:
        """Seconds, or another abscissa."""
        return measured(self.master.unit, self.master.cycle)

    @property
    def per_minute(self) -> float:
        """Cycles a minute; over an abscissa that tells no time, in 60 of its units."""
        return shown(shown(1.0, self.master.cycle), PER_MINUTE)

    @property
    def axes_turned(self) -> Sequence[Axis]:
        """The axes with all their places in degrees of a turn, and what their phases pass in SI by rad."""
        over, axes = self.over, list[Axis]()
        for axis in self.axes:
            size, phases = over.lift(axis.unit).size, []
            for phase in axis.phases:
                rates = {name: getattr(phase, name) for name in RATES}
                passed = {
                    name: None if rate is None else over.per_rad(si(rate, size), order)
                    for order, (name, rate) in enumerate(rates.items(), 1)
                }
                phases.append(turned(phase, over).model_copy(update=passed))
            load = axis.load.model_copy(update={"windows": [turned(force, over) for force in axis.load.windows]})
            more = {"phases": phases, "load": load, "shift": over.degrees(axis.shift)}
            axes.append(axis.model_copy(update=more))
        return axes

    @property
    def switches_turned(self) -> Sequence[SwitchEntry]:
        """The switches, likewise."""
        over = self.over
        return [
            switch.model_copy(update={"on": [turned(time, over) for time in switch.on]}) for switch in self.switches
        ]

    def design_faults(self) -> Iterator[DesignError]:
        """Yield phases, process forces and times of switches that do not lie in the cycle, or not in order."""
        over, located = self.over, list[tuple[str, int, list[DesignError]]]()
        for i, axis in enumerate(self.axes):
            phases, windows = axis.phases, axis.load.windows
            wrong = [*forward(axis.name, phases, over.after, over.length), *following(axis.name, phases, over)]
            beyond = within(f"{axis.name} row", phases, over, "phases", "within", filling(phases, over.length))
            inside = [
                window.model_dump() | {end: min(getattr(window, end), over.length) for end in KEYS}
                for window in windows
            ]
            forces = within(f"{axis.name} process force", windows, over, "load.windows", "forces", inside)
            located.append(("axes", i, [*(wrong or beyond), *forces]))
        for i, (switch, degrees) in enumerate(zip(self.switches, self.switches_turned, strict=True)):
            beyond = within(f"{switch.name} time", switch.on, over, "on", "ends", [UNUSED for _ in switch.on])
            located.append(("switches", i, [*beyond] or [*meeting(degrees, over)]))
        for table, i, errors in located:
            for error in errors:
                yield DesignError(f"{table}.{i}.{error.field}", str(error), f"{error.rule}{i + 1}", error.fits)


def turned(lasting: Lasting, over: Abscissa) -> Lasting:
    """Return entries with ``start`` and ``stop`` of the cycle in degrees of a turn."""
    ends = {name: getattr(lasting, name) for name in KEYS}
    return lasting.model_copy(
        update={name: None if x is None else min(over.degrees(x), TURN) for name, x in ends.items()}
    )


def within(name: str, each: Sequence[Any], over: Abscissa, key: str, rule: str, fits: Any) -> Iterator[DesignError]:
    """Yield the first of several, each with its ``start`` and ``stop``, that goes on beyond the cycle."""
    for k, entry in enumerate(each, 1):
        last = max(x for x in (0.0, entry.start, entry.stop) if x is not None)
        if over.degrees(last) - TURN > ANGLE_TOLERANCE:
            at, by = (f"{figure(x)}{over.after}" for x in (last, last - over.length))
            yield DesignError(key, f"{name} {k} goes to {at}, {by} beyond the cycle", rule, fits)
            return


def convert_to_seconds(machine: AnyMachine) -> TimedMachine:
    """Return the same machine, which is given at a rate, without its master shaft."""
    cycle = shown(shown(1.0, machine.per_minute), PER_MINUTE)
    data = machine.model_dump() | {"master": {"cycle": cycle}}
    in_units_of(data, "s", cycle)
    return TimedMachine.model_validate(data)


def in_units_of(data: dict[str, Any], unit: str, cycle: float) -> None:
    """Convert all places of a description from degrees into a unit of its cycle; what phases pass from SI by rad."""
    over = measured(unit, cycle)
    for axis in data["axes"]:
        size = over.lift(axis["unit"]).size
        axis["shift"] = over.shown(axis["shift"])
        for phase in axis["phases"]:
            for order, name in enumerate(RATES, 1):
                if phase.get(name) is not None:
                    phase[name] = shown(over.per_rad(phase[name], -order), size)
    lasting = [entry for axis in data["axes"] for entry in (*axis["phases"], *axis["load"]["windows"])]
    for entry in (*lasting, *(time for switch in data["switches"] for time in switch["on"])):
        entry |= {end: None if entry[end] is None else over.shown(entry[end]) for end in KEYS}
