"""The types of entries, in the engineer's units, with the rules that each obeys."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

LARGEST, SMALLEST = 1e12, 1e-12  # of any entry but 0: beyond, squares leave what a cell can hold
Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
Positive = Annotated[float, Field(gt=0, ge=SMALLEST, le=LARGEST)]
NotNegative = Annotated[float, Field(ge=0, le=LARGEST)]
Share = Annotated[float, Field(ge=0, le=1, allow_inf_nan=False)]
Angle = Annotated[float, Field(ge=0, le=360, allow_inf_nan=False)]
SUM_TOLERANCE = 1e-9
ANGLE_TOLERANCE = 1e-9  # degrees
END_TOLERANCE = 1e-12  # of a rise: a law that must end at 1 does


class EntryError(ValueError):
    """An entry that does not go with the others; ``field`` says which, below the model that found it."""

    def __init__(self, field: str, message: str) -> None:
        super().__init__(message)
        self.field = field


class Model(BaseModel):
    """Entries are taken as they are: no text becomes a number, no unknown entry is dropped."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)
