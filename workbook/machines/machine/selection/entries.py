"""Catalogues of a machine, and what its sheet Selection ranks the pairs of for an axis: what an engineer enters."""

from typing import Annotated, Any, Self

from pydantic import Field, model_validator

from workbook.entries.texts import LOOKED_UP, NO_FORMULA
from workbook.entries.types import EntryError
from workbook.selection.entries import COMMITTED, REFERENCE, Products, Ranked

Called = Annotated[str, Field(min_length=1, max_length=24, pattern=NO_FORMULA), LOOKED_UP]


class Choice(Ranked):
    """The catalogues: those that come with the templates where none are entered, or by the word.

    With an axis, a sheet Selection looks for its motor and reducer.
    """

    axis: Called | None = Field(
        default=None, description="Axis with a drive that the sheet Selection looks at; or none"
    )
    falling: bool | None = Field(
        default=None,
        description="Whether the sheets of drives know motors whose peak torque falls beyond a speed; as the catalogue "
        "has such motors if empty",
    )

    @model_validator(mode="before")
    @classmethod
    def _as_catalogued(cls, data: Any) -> Any:
        """Leave out what the catalogue says too: a description stays as it is, through a book and back."""
        if not isinstance(data, dict) or data.get("falling") is None:
            return data
        rows = data.get("motors", REFERENCE)
        told = COMMITTED["motors"]() if rows == REFERENCE else rows
        known = isinstance(told, (list, tuple)) and data["falling"] is any(map(falling, told))
        return {key: value for key, value in data.items() if key != "falling"} if known else data

    @property
    def knows_falling(self) -> bool:
        """Whether the sheets of drives know such motors."""
        return any(map(falling, self.motors)) if self.falling is None else self.falling

    @model_validator(mode="after")
    def _without_axis(self) -> Self:
        own = [name for name in type(self).model_fields if name not in {*Products.model_fields, "axis", "falling"}]
        told = [name for name in own if getattr(self, name) != type(self).model_fields[name].default]
        if self.axis is None and told:
            said = "no axis is told for the sheet Selection; expected selection.axis, or none of this"
            raise EntryError(told[0], said)
        return self


def falling(motor: Any) -> bool:
    """Return whether the peak torque of a motor of a catalogue falls, as it is entered or as a row."""
    end = motor.get("end_torque") if isinstance(motor, dict) else getattr(motor, "end_torque", None)
    return end is not None
