"""The sheet Export, where a description asks for one: which axis it has."""

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, GetJsonSchemaHandler, model_validator
from pydantic.json_schema import JsonSchemaValue

from workbook.entries.machine import Machine
from workbook.entries.types import EntryError, Model


class ExportEntry(Model):
    """The sheet Export: one axis as a table of x, y, y', y'', live in cells, for those who copy and paste."""

    axis: Annotated[int, Field(ge=1)] = Field(description="The axis, by its name or by its number")

    @classmethod
    def __get_pydantic_json_schema__(cls, core: Any, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Take a name too, as editors see it."""
        made = handler(core)
        made["properties"]["axis"]["type"] = ["integer", "string"]
        return made


class Exporting(Machine):
    """A machine whose book may have a sheet Export: of its axes told at ``AXES_AT``, or of those in ``AXES``."""

    AXES: ClassVar[tuple[str, ...]] = ()
    AXES_AT: ClassVar[tuple[str, ...]] = ()
    export: ExportEntry | None = None

    @classmethod
    def axis_names(cls, data: Any) -> list[str]:
        """Return the names of the axes of a machine, or of a description of one."""
        told: Any = data
        for part in cls.AXES_AT:
            told = told.get(part) if isinstance(told, Mapping) else getattr(told, part, None)
        rows = told if cls.AXES_AT and isinstance(told, list) else []
        names = [row.get("name") if isinstance(row, Mapping) else getattr(row, "name", None) for row in rows]
        return [*cls.AXES, *map(str, names)]

    @classmethod
    def spelled(cls, data: Any) -> Any:
        """Return a description that tells its axis to export by the number."""
        export = data.get("export") if isinstance(data, Mapping) else None
        name = export.get("axis") if isinstance(export, Mapping) else None
        if not isinstance(name, str):
            return data
        names = [one.casefold() for one in cls.axis_names(data)]
        if name.casefold() not in names:
            raise EntryError("export.axis", f"no axis is named {name!r}; expected {_one_of(cls.axis_names(data))}")
        return {**data, "export": {**(export or {}), "axis": names.index(name.casefold()) + 1}}

    @model_validator(mode="after")
    def _has_axis(self) -> Self:
        names = self.axis_names(self)
        if self.export and self.export.axis > len(names):
            raise EntryError("export.axis", f"axis {self.export.axis}; expected 1 to {len(names)}, {_one_of(names)}")
        return self


def named(number: int) -> str:
    """Return the name of the cell that tells the number of the exported axis: by it a file tells which it is."""
    return f"export_of{number}"


def _one_of(names: list[str]) -> str:
    return f"one of {', '.join(names[:30])}"
