"""The cycle of a machine as it is entered: a turn of a master shaft at a rate, or a length of time, angle or travel."""

from typing import Annotated, Any

from pydantic import ValidatorFunctionWrapHandler

from workbook.entries.abscissa import ANGLE, Abscissa, Unit, measured
from workbook.entries.phase import TURN
from workbook.fields.types import CountsAs, EntryError, MakesCells, Model, NotNegative, Positive
from workbook.fields.units import PER_MINUTE, shown


class CycleEntry(Model):
    """The cycle: a turn of a master shaft at a rate, or of a machine without one a length in s, °, rad or mm."""


class Master(CycleEntry):
    """The master shaft, a cycle a turn: all places are in degrees of it."""

    rate: Positive  # cycles/min
    compare_rate: Annotated[NotNegative, MakesCells(0.0)] | None = None

    @property
    def over(self) -> Abscissa:
        """Degrees of the master shaft."""
        return ANGLE

    @property
    def per_minute(self) -> float:
        """Cycles a minute."""
        return self.rate


class Cycle(CycleEntry):
    """A cycle without a master shaft: all places are in its unit.

    Over °, rad or mm nothing tells how time passes: rates are geometric, in lift by abscissa, and there are no drives.
    """

    cycle: Annotated[Positive, CountsAs(TURN), MakesCells(TURN)]
    unit: Unit = "s"

    @property
    def over(self) -> Abscissa:
        """Seconds, or another abscissa."""
        return measured(self.unit, self.cycle)

    @property
    def per_minute(self) -> float:
        """Cycles a minute; over an abscissa that tells no time, in 60 of its units."""
        return shown(shown(1.0, self.cycle), PER_MINUTE)


def by_rate_or_length(data: Any, handler: ValidatorFunctionWrapHandler) -> Master | Cycle:
    """Return the cycle of a description, by which of its keys is there; raise EntryError where both are."""
    keys = data.keys() if isinstance(data, dict) else ()
    if {"rate", "cycle"} <= set(keys):
        raise EntryError("rate", "entered beside cycle; expected one of them: a rate of a master shaft, or a cycle")
    entry: Master | Cycle = (Cycle if "cycle" in keys or isinstance(data, Cycle) else Master).model_validate(data)
    return entry
