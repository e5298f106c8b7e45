"""Entries of every machine description: title, laws, sizes of its tables; the sheet Export, where it asks for one."""

from collections.abc import Mapping
from datetime import date
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, Self

from pydantic import BeforeValidator, Field, PrivateAttr, model_validator

from workbook.fields.paths import get, key_of
from workbook.fields.texts import Text
from workbook.fields.types import EntryError, Model
from workbook.laws.entries import Laws, resolve
from workbook.laws.pages.spline import ROOM

Rows = Annotated[int, Field(ge=10, le=800)]
AS_A_LIST = BeforeValidator(lambda rows: [rows] if isinstance(rows, int) else rows, Rows | list[Rows])
RowsOfMotions = Annotated[list[Rows], Field(min_length=1), AS_A_LIST]
"""the rows for pieces of each motion, the last for all that follow; a single number for all"""


class Sizes(Model):
    """Sizes of the tables: intervals of a cycle, a law, an exported axis; rows."""

    cycle: Annotated[int, Field(ge=4, le=7200)] = 360
    law: Annotated[int, Field(ge=4, le=1000)] = 60
    export: Annotated[int, Field(ge=1, le=7200)] = 360
    phases: Annotated[int, Field(ge=2, le=60)] = 8
    rotors: Annotated[int, Field(ge=2, le=60)] = 6
    pieces: Annotated[int, Field(ge=2, le=60)] = 8
    points: Annotated[int, Field(ge=8, le=ROOM)] = 12
    # None: a few more than each motion has
    motion_pieces: RowsOfMotions | None = None

    def pieces_of(self, number: int) -> int:
        """Return the rows for pieces of a motion, by its number from 1: the last stated holds for all others."""
        stated = self.motion_pieces or [0]
        return stated[min(number, len(stated)) - 1]


class Fault(NamedTuple):
    """A fault in the numbers of a design: the entry to blame, and what is wrong with it."""

    key: str
    message: str
    fits: Any = None  # what would do
    value: Any = None  # what was entered, if it is beyond the entry's own limits
    is_missing: bool = False

    @property
    def sentence(self) -> str:
        """The fault in words, behind a number that is beyond the entry's own limits."""
        return f"{self.value:g}; {self.message}" if isinstance(self.value, int | float) else self.message


class Design(NamedTuple):
    """The entries of an unfinished design where the engine is given others, by key, and its faults."""

    replaced: dict[str, Any]
    faults: tuple[Fault, ...] = ()


Dated = Annotated[Text, BeforeValidator(lambda day: day.isoformat() if isinstance(day, date) else day)]
"""a date as a text, or as TOML has dates"""


class Machine(Model):
    """Entries that every machine description has, whatever its template."""

    template: str
    title: Text
    number: Text | None = None
    revision: Text | None = None
    author: Text | None = None
    date: Dated | None = None
    print_also: list[Literal["catalogue", "laws", "parts", "workings"]] = Field(default=[])
    laws: Laws = Laws({})
    sizes: Sizes = Sizes()
    _design: Design = PrivateAttr(default_factory=lambda: Design({}))
    _stamp: float | None = PrivateAttr(None)

    @classmethod
    def expand_short_forms(cls, data: Any) -> Any:
        """Return a description with its short forms written out."""
        return data

    @model_validator(mode="before")
    @classmethod
    def _expand_short_forms(cls, data: Any) -> Any:
        return cls.expand_short_forms(data)

    @property
    def heading(self) -> str:
        """The machine's title, with its number and revision where it has them."""
        return ", ".join([self.title, *(f"{k} {v}" for k in ("number", "revision") if (v := getattr(self, k)))])

    def layout_entries(self) -> dict[str, Any]:
        """Return by key the entries that tell the layout of its book, where these are other than as entered."""
        return {}

    def built_as(self, names: Mapping[str, str]) -> None:
        """Keep the names that parts had when their book was built, by the names of the cells that hold them."""

    @property
    def design(self) -> Design:
        """The entries that were replaced because they break a rule, as they were entered."""
        return self._design

    @property
    def stamp(self) -> float | None:
        """The fingerprint of the entries at which its book was last verified."""
        return self._stamp

    def verified_at(self, stamp: float | None) -> None:
        """Set the fingerprint of the entries at which its book was last verified."""
        self._stamp = stamp

    @model_validator(mode="after")
    def _named(self) -> Self:
        resolve(self, self.laws)
        for family, field in (("OWN", "pieces"), ("SPL", "points")):
            room = getattr(self.sizes, field)
            for name, entry in self.laws.of(family).items():
                key, rows = f"laws.{key_of(name)}.{field}", len(getattr(entry, field))
                if rows > room:
                    raise EntryError(key, f"{rows} rows do not fit into {room}; raise sizes.{field}")
        return self


class ExportEntry(Model):
    """The sheet Export: one axis as a table of x, y, y', y'', live in cells, for those who copy and paste."""

    axis: Annotated[int, Field(ge=1, json_schema_extra={"type": ["integer", "string"]})]


class Exporting(Machine):
    """A machine whose book may have a sheet Export: of its axes told at ``AXES_AT``, or of those in ``AXES``."""

    AXES: ClassVar[tuple[str, ...]] = ()
    AXES_AT: ClassVar[tuple[str, ...]] = ()
    export: ExportEntry | None = None

    @classmethod
    def axis_names(cls, data: Any) -> list[str]:
        """Return the names of the axes of a machine, or of a description of one."""
        rows = get(data, cls.AXES_AT) if cls.AXES_AT else []
        return [*cls.AXES, *(str(get(row, ["name"])) for row in (rows if isinstance(rows, list) else []))]

    @classmethod
    def expand_short_forms(cls, data: Any) -> Any:
        """Return a description that has the exported axis by its number."""
        name = get(data, ("export", "axis"))
        if not isinstance(name, str):
            return data
        names = [name.casefold() for name in cls.axis_names(data)]
        if name.casefold() not in names:
            raise EntryError("export.axis", f"no axis is named {name!r}; expected {_one_of(cls.axis_names(data))}")
        return {**data, "export": {**data["export"], "axis": names.index(name.casefold()) + 1}}

    @model_validator(mode="after")
    def _has_axis(self) -> Self:
        names = self.axis_names(self)
        if self.export and self.export.axis > len(names):
            raise EntryError("export.axis", f"axis {self.export.axis}; expected 1 to {len(names)}, {_one_of(names)}")
        return self


def number_cell(number: int) -> str:
    """Return the name of the cell with the number of the exported axis; from the name alone a file's axis is known."""
    return f"export_of{number}"


def _one_of(names: list[str]) -> str:
    return f"one of {', '.join(names[:30])}"
