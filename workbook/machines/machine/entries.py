"""A machine of any axes: what an engineer enters."""

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import Field, WrapValidator, model_validator

from workbook.entries.abscissa import ANGLE, Abscissa
from workbook.entries.machine import Exporting
from workbook.entries.phase import TURN, AxisPhase
from workbook.fields.paths import join, spread
from workbook.fields.texts import Text, place_of, require_distinct
from workbook.fields.types import (
    ANGLE_TOLERANCE,
    DesignError,
    DesignFaultsError,
    EntryError,
    MakesCells,
    NotNegative,
    Number,
    Positive,
)
from workbook.machines.machine import drive_entries
from workbook.machines.machine import entries_beside as beside
from workbook.machines.machine.entries_beside import Cycle, Master, by_rate_or_length
from workbook.machines.machine.mechanism import Mechanism, Table
from workbook.machines.machine.places import place_faults
from workbook.motion.requirements import AT_REST, CROWDED, Smoothness, piece_counts, settle_room
from workbook.selection.entries import UNCHOSEN, Limits, OwnLimits, SelectionSizes, require_known, require_room

MOST_AXES = 24
Unit = Literal["mm", "°"]
Closes = Literal["position", "feed", "open"]
NO_LINE = 'a velocity or acceleration is entered; expected a straight line among the laws: [laws.LIN] family = "LIN"'
NO_TIME = "a cycle in {} does not tell how time passes, which a drive needs; expected none, or a cycle in s"
OPEN_DRIVE = "is open, so its cycle does not follow upon itself; expected position or feed of an axis with a drive"


class Axis(beside.NamedPart):
    """An axis: its phases in a turn of the master shaft; between them it rests."""

    group: Text
    unit: Unit = "mm"
    closes: Closes = "position"
    smoothness: Smoothness = "acceleration"
    shift: Number = 0.0
    position: Number = 0.0
    stops: beside.HardStops | None = None
    vibration: beside.Vibration | None = None
    backlash: drive_entries.Backlash | None = None
    phases: Annotated[list[AxisPhase], Field(min_length=1)]
    rate: Positive | None = None
    mechanism: Mechanism | None = None
    load: drive_entries.AxisLoad = drive_entries.AxisLoad()
    parts: list[drive_entries.AxisPart] = []  # noqa: RUF012 - frozen
    motor: drive_entries.AxisMotor | None = None
    reducer: drive_entries.Reducer = drive_entries.Reducer()
    stages: Annotated[list[drive_entries.StageEntry], MakesCells()] = Field([], max_length=drive_entries.STAGES)
    limits: OwnLimits = OwnLimits()

    @model_validator(mode="before")
    @classmethod
    def _motor_to_choose(cls, data: Any) -> Any:
        """Give a mechanism that has no motor a motor without figures, for Selection to choose."""
        unchosen = isinstance(data, dict) and data.get("mechanism") is not None and data.get("motor") is None
        return data | {"motor": {}} if unchosen else data

    @model_validator(mode="after")
    def _driven(self) -> Self:
        if self.motor is not None and self.mechanism is None:
            raise EntryError("mechanism", "empty; expected the mechanism that the motor drives")
        driven = ("rate", "backlash", "load", "parts", "reducer", "stages", "limits")
        for name in driven if self.motor is None else ():
            if getattr(self, name) != type(self).model_fields[name].get_default(call_default_factory=True):
                raise EntryError(name, "entered for an axis without a drive; expected none, or a mechanism and a motor")
        if self.mechanism and self.unit not in self.mechanism.UNITS:
            raise EntryError("mechanism.kind", f"a {self.mechanism.kind} does not move an axis in {self.unit}")
        self._require_own_load()
        return self

    def _require_own_load(self) -> None:
        """Raise EntryError for a load that travels on an axis that turns, the reverse, a process force that lacks."""
        works, forces = (self.backlash and self.backlash.works) or 0, len(self.load.windows)
        if works > forces:
            raise EntryError("backlash.works", f"{works}; expected the number of one of {forces} process forces")
        slides = self.mechanism is not None and self.mechanism.SLIDES
        moved = f"a {self.mechanism.kind}" if slides and self.mechanism else f"an axis in {self.unit}"
        load = drive_entries.TRAVELLING_LOAD
        for name in (*drive_entries.TURNING_LOAD, "arm") if slides or self.unit == "mm" else load:
            if getattr(self.load, name):
                raise EntryError(f"load.{name}", f"no entry of {moved}; expected none")

    @property
    def repeats(self) -> bool:
        """Whether its cycle follows upon itself: it comes back, or feeds on."""
        return self.closes != "open"

    def design_faults(self) -> Iterator[DesignError]:
        """Yield phases that run backwards, or begin before the phase above ends, and an open cycle with a drive."""
        if self.motor is not None and not self.repeats:
            yield DesignError("closes", f"{self.name} {OPEN_DRIVE}", "position")


class MachineSizes(SelectionSizes):
    """The sizes of the tables: also the points of a mechanism that is given by a table."""

    positions: Annotated[int, Field(ge=3, le=40)] = 12
    turns: Annotated[int, Field(ge=1, le=60)] = 4


class AnyMachine(Exporting):
    """Axes over a master shaft, or without it over a cycle in s or over any abscissa; places are in its unit."""

    AXES_AT = ("axes",)
    template: Literal["machine"] = "machine"
    master: Annotated[Master | Cycle, WrapValidator(by_rate_or_length)]
    axes: Annotated[list[Axis], Field(min_length=1, max_length=MOST_AXES), MakesCells()]
    switches: Annotated[list[beside.SwitchEntry], MakesCells()] = Field(default=[], max_length=beside.MOST_SWITCHES)
    clearances: Annotated[list[beside.ClearanceEntry], MakesCells()] = Field(
        default=[], max_length=beside.MOST_CLEARANCES
    )
    timing: beside.Timing = beside.Timing()
    power: drive_entries.PowerEntry = drive_entries.PowerEntry()
    gravity: NotNegative = 9.81
    creep_forces: Literal["off", "on"] = "off"
    limits: Limits = Limits()
    selection: drive_entries.Choice = drive_entries.Choice()
    sizes: MachineSizes = MachineSizes()

    @classmethod
    def expand_short_forms(cls, data: Any) -> Any:
        """Return a description whose switches tell the keys of their times, and whose clearances name their axes."""
        return beside.expand_short_forms(super().expand_short_forms(data))

    @model_validator(mode="after")
    def _fits(self) -> Self:
        for kind, key in (("axis", "axes"), ("switch", "switches"), ("clearance", "clearances")):
            require_distinct((row.name for row in getattr(self, key)), kind, f"{key}.{{}}.name")
        for i, axis in enumerate(self.axes):
            if axis.motor is not None and not self.over.timed:
                raise EntryError(f"axes.{i}.motor", NO_TIME.format(self.over.unit))
            if axis.vibration is not None and not self.over.timed:
                raise EntryError(f"axes.{i}.vibration", NO_TIME.format(self.over.unit).replace("drive", "vibration"))
        beside.require_axes(self.clearances, [axis.name for axis in self.axes])
        self._require_drives()
        require_room(self.selection, self.sizes)
        self._require_axis_to_choose()
        self._require_rows()
        passing = [(i, k) for i, axis in enumerate(self.axes) for k, phase in enumerate(axis.phases) if phase.passes]
        for i, k in passing if not self.laws.of("LIN") else ():
            raise EntryError(f"axes.{i}.phases.{k}", NO_LINE)
        self._require_pieces()
        return self

    def _require_drives(self) -> None:
        """Raise EntryError for entries of drives in a machine that has none, of weights where nothing has a weight."""
        for entry in ("power", "limits", "creep_forces") if not any(axis.motor for axis in self.axes) else ():
            if getattr(self, entry) != type(self).model_fields[entry].default:
                raise EntryError(entry, "no axis has a drive; expected none")
        if self.gravity != type(self).model_fields["gravity"].default and not self.weighs:
            raise EntryError("gravity", "no axis with a drive has a weight; expected none")

    def _require_axis_to_choose(self) -> None:
        """Raise EntryError where Selection chooses the drive of an axis that has none."""
        name, driven = self.selection.axis, [axis.name for axis in self.axes if axis.mechanism]
        if name is not None and not driven:
            raise EntryError("selection.axis", f"{UNCHOSEN}{name}; expected none: no axis has a drive")
        if name is not None and place_of(name, driven) < 0:
            raise DesignFaultsError([DesignError("selection.axis", f"{UNCHOSEN}{name}", driven[0])])

    def _require_rows(self) -> None:
        """Raise EntryError for a product that no catalogue has, and for more rows than a table has."""
        for i, axis in enumerate(self.axes):
            for entry, rows in (("motor", self.selection.motors), ("reducer", self.selection.reducers)):
                name = getattr(getattr(axis, entry), "name", "")
                if name:
                    require_known(entry, name, [row.name for row in rows], f"axes.{i}.{entry}.name")
            points = axis.mechanism.points if isinstance(axis.mechanism, Table) else []
            for entry, given_rows, room in (
                ("parts", axis.parts, "rotors"),
                ("mechanism.points", points, "positions"),
                ("phases", axis.phases, "phases"),
            ):
                if len(given_rows) > getattr(self.sizes, room):
                    problem = f"{len(given_rows)} rows do not fit into {getattr(self.sizes, room)}; raise sizes.{room}"
                    raise EntryError(f"axes.{i}.{entry}", problem)

    def _require_pieces(self) -> None:
        """Raise DesignFaultsError for an axis whose motion has more pieces than its table has rows."""
        number, faults = piece_counts(self.laws), []
        needed = [
            sum(number[p.law] for p in axis.phases) + len(rests(axis.phases, self.over)) + 2 * len(axis.load.windows)
            for axis in self.axes
        ]
        # a piece for every row of phases, and rests: so many does verify try, also with all process forces
        settle_room(self, needed, self.sizes.phases + self.sizes.phases // 3 + 1)
        for i, (axis, count) in enumerate(zip(self.axes, needed, strict=True)):
            if count > (space := self.sizes.pieces_of(i + 1)):
                still = [phase.model_dump() | AT_REST for phase in axis.phases]
                faults.append(DesignError(f"axes.{i}.phases", CROWDED.format(count, space), still))
        if faults:
            raise DesignFaultsError(faults)

    def layout_entries(self) -> dict[str, Any]:
        """Return axes that entries name by their numbers, and whether drives know motors whose peak torque falls."""
        names = [axis.name for axis in self.axes]
        data = self.model_dump(include={"clearances", "timing"})
        named = (entry for pattern in beside.NAMED for entry in spread(data, pattern))
        numbers = {join(path): i + 1 for path, name in named if (i := place_of(name, names)) >= 0}
        return numbers | {"selection.falling": self.selection.knows_falling}

    def built_as(self, names: Mapping[str, str]) -> None:
        """Keep what the axes and the clearances were called when the book was built."""
        for part, entries in (("axis", self.axes), ("clear", self.clearances)):
            for i, entry in enumerate(entries, 1):
                entry.built_as(names.get(f"{part}{i}_built"))

    @property
    def over(self) -> Abscissa:
        """The abscissa over which its cycle is entered and shown."""
        return self.master.over

    @property
    def per_minute(self) -> float:
        """Cycles a minute; over an abscissa that tells no time, in 60 of its units."""
        return self.master.per_minute

    def design_faults(self) -> Iterator[DesignError]:
        """Yield phases, process forces and times of switches that do not lie in the cycle, or not in order."""
        return place_faults(self)

    @property
    def weighs(self) -> bool:
        """Whether gravity acts on what a drive moves."""
        driven = ((axis, axis.mechanism) for axis in self.axes if axis.mechanism)
        return any(axis.unit == "mm" or m.SLIDES or axis.load.arm for axis, m in driven)


def rests(phases: list[AxisPhase], over: Abscissa = ANGLE) -> list[int]:
    """Return the numbers of the phases, from 0, before which an axis rests; behind the last is before another."""
    ends = [0.0, *(over.degrees(p.stop) for p in phases)]
    begins = [*(over.degrees(p.start) for p in phases), TURN]
    both = enumerate(zip(ends, begins, strict=True))
    return [i for i, (end, begin) in both if begin - end > ANGLE_TOLERANCE]
