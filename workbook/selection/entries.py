"""Motor and reducer from catalogues (S5, steps 1 to 7): what an engineer enters, and the rules it obeys."""

from collections.abc import Callable, Sequence
from typing import Annotated, Any, Self

from pydantic import Field, model_validator

from engine.selection.pair_matrix import Rank
from workbook.entries.machine import Sizes
from workbook.fields.texts import nearest_names, place_of, require_distinct
from workbook.fields.types import EntryError, Model, NotNegative, Positive
from workbook.selection.catalogue import Efficiency, MotorRow, Name, ReducerRow
from workbook.selection.catalogue_files import committed_motors, committed_reducers

MOST_PRODUCTS = 100  # rows of a catalogue
UNCHOSEN = "no axis with a drive is named "
COMMITTED: dict[str, Callable[[], Sequence[Model]]] = {"motors": committed_motors, "reducers": committed_reducers}
REFERENCE = "committed"
"""instead of a catalogue: that of the templates, whatever lies beside the description"""


def refer_to_catalogues(data: dict[str, Any]) -> dict[str, Any]:
    """Return a description that refers to the catalogues which come with the templates instead of repeating them."""
    chosen = data.get("selection", {})
    whole = {entry: [row.model_dump(exclude_none=True) for row in rows()] for entry, rows in COMMITTED.items()}
    named = {entry: REFERENCE for entry, rows in whole.items() if chosen.get(entry) == rows}
    return data | {"selection": chosen | named} if named else data


def require_known(kind: str, name: str, names: Sequence[str], key: str) -> None:
    """Raise EntryError, at ``key``, for a motor or reducer that no row of its catalogue has, with the three nearest."""
    if place_of(name, names) < 0:
        alike = ", ".join(nearest_names(name, names))
        raise EntryError(key, f"no {kind} of the catalogue is named {name!r}; expected one of {alike}")


class Products(Model):
    """The catalogues of motors and reducers: those of the templates where none are given, or by the word."""

    motors: Annotated[list[MotorRow], Field(min_length=1)] = Field(default_factory=committed_motors)
    reducers: Annotated[list[ReducerRow], Field(min_length=1)] = Field(default_factory=committed_reducers)

    @model_validator(mode="before")
    @classmethod
    def _referred(cls, data: Any) -> Any:
        if not isinstance(data, dict):
            return data
        return data | {entry: committed() for entry, committed in COMMITTED.items() if data.get(entry) == REFERENCE}

    @model_validator(mode="after")
    def _distinct(self) -> Self:
        for entry, rows in (("motor", self.motors), ("reducer", self.reducers)):
            require_distinct([row.name for row in rows], entry, f"{entry}s.{{}}.name")
        return self


class Limits(Model):
    """The limits of every drive, on its sheet, in Selection and Pairs, in studies: figures over their reserves."""

    rms_reserve: Positive = 1.0
    peak_reserve: Positive = 1.0
    speed_reserve: Positive = 1.0
    inertia_ratio: Positive = 10.0
    torque_factor: Positive = 1.0
    largest_mass: NotNegative = 0.0

    def of_axis(self, own: "OwnLimits") -> "Limits":
        """Return the limits of an axis: its own where it has any."""
        return self.model_copy(update=own.model_dump(exclude_none=True))


class OwnLimits(Model):
    """The limits of an axis where they are not the machine's."""

    rms_reserve: Positive | None = None
    peak_reserve: Positive | None = None
    speed_reserve: Positive | None = None
    inertia_ratio: Positive | None = None
    torque_factor: Positive | None = None
    largest_mass: NotNegative | None = None


class Ranked(Products):
    """The catalogues, what usable pairs of them are ranked by, and beyond which margin a motor is too large."""

    rank: Rank = "smallest motor"
    greatest_margin: Positive = 10.0


class Selection(Ranked):
    """The catalogues, what their pairs are ranked by, and the motor and reducer in use: the proposed where none is."""

    motor: Name | None = None
    reducer: Name | None = None
    efficiency: Efficiency = 1.0

    @model_validator(mode="after")
    def _named(self) -> Self:
        for entry, name, rows in (("motor", self.motor, self.motors), ("reducer", self.reducer, self.reducers)):
            if name is not None:
                require_known(entry, name, [row.name for row in rows], entry)
        return self


class SelectionSizes(Sizes):
    """The sizes of the tables: also the rows of the two catalogues."""

    motors: Annotated[int, Field(ge=1, le=MOST_PRODUCTS)] = 22
    reducers: Annotated[int, Field(ge=1, le=MOST_PRODUCTS)] = 18


def require_room(selection: Products, sizes: SelectionSizes) -> None:
    """Raise EntryError where a catalogue has more rows than its table."""
    for entry in ("motors", "reducers"):
        filled, room = len(getattr(selection, entry)), getattr(sizes, entry)
        if filled > room:
            raise EntryError(f"selection.{entry}", f"{filled} rows do not fit into {room}; raise sizes.{entry}")
