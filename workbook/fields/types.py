"""The types of entries, in the engineer's units, with the rules that each obeys."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, model_validator

# of what must be more than 0: beyond, squares leave what a cell can hold
LARGEST, SMALLEST = 1e12, 1e-12
TINIEST = 1e-30  # of all else but 0: less than rounding leaves of a formula that gives 0
SUM_TOLERANCE = 1e-9
ANGLE_TOLERANCE = 1e-9  # degrees
END_TOLERANCE = 1e-12  # of a rise: a law that must end at 1 does


class EntryError(ValueError):
    """An entry that does not go with the others; ``field`` says which, below the model that found it."""

    def __init__(self, field: str, message: str) -> None:
        super().__init__(message)
        self.field = field


def not_tiny(value: float) -> float:
    """Return a number; raise EntryError for a number so near to 0 that products of it are 0 or lose their digits."""
    if 0 < abs(value) < TINIEST:
        raise EntryError("", f"found {value:g}; expected 0, or at least {TINIEST:g} in size")
    return value


Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST), AfterValidator(not_tiny)]
Positive = Annotated[float, Field(gt=0, ge=SMALLEST, le=LARGEST)]
NotNegative = Annotated[float, Field(ge=0, le=LARGEST), AfterValidator(not_tiny)]
Share = Annotated[float, Field(ge=0, le=1, allow_inf_nan=False), AfterValidator(not_tiny)]
Angle = Annotated[float, Field(ge=0, le=360, allow_inf_nan=False), AfterValidator(not_tiny)]


class EmptyCell:
    """Marks an entry whose cell may be empty, and is then read as its default."""


@dataclass(frozen=True)
class MakesCells:
    """Marks an entry by which a book has more cells: a list by its rows, all else by being there.

    The layout of a book has a ``stand_in`` for it; of a list without one its rows, without what cells hold.
    """

    stand_in: Any = None


@dataclass(frozen=True)
class CountsAs:
    """Marks an entry with the value that takes its place in an unfinished design where it breaks a rule."""

    value: float


class DesignError(EntryError):
    """Numbers that do not go together, though ``fits`` would do; or a ``value`` beyond the limits of its own cell."""

    def __init__(self, field: str, message: str, fits: Any = None, value: Any = None) -> None:
        super().__init__(field, message)
        self.fits, self.value = fits, value


class DesignFaultsError(ValueError):
    """All that does not go together below a model."""

    def __init__(self, faults: list[DesignError]) -> None:
        super().__init__("; ".join(map(str, faults)))
        self.faults = faults


class Model(BaseModel):
    """Entries are taken as they are: no text becomes a number, no unknown entry is dropped."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)

    def design_faults(self) -> Iterator[DesignError]:
        """Yield the numbers that do not go together."""
        yield from ()

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        faults = list(self.design_faults())
        if faults:
            raise DesignFaultsError(faults)
        return self
