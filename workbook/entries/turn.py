"""Phases of an axis over one turn of the master shaft, as entered."""

from collections.abc import Iterator, Sequence
from typing import Any

from workbook.book.sentence import figure
from workbook.entries.phase import resting
from workbook.entries.types import Angle, DesignError, Model, Number
from workbook.laws.entries import LawName

TURN = 360.0  # degrees


class TurnPhase(Model):
    """One phase of an axis: angles of the master shaft in degrees, a lift in the axis' unit."""

    start: Angle
    stop: Angle
    lift: Number = 0.0
    law: LawName = "DWL"

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a dwell that is to lift."""
        yield from resting(self.law, self.lift)


def forward(
    name: str, phases: Sequence[TurnPhase], unit: str = "°", length: float = TURN
) -> Iterator[DesignError]:  # fmt: skip
    """Yield the first phase of an axis that runs backwards, or does not last, of a cycle of a length."""
    for row, phase in enumerate(phases, 1):
        if phase.stop <= phase.start:
            short = phase.start - phase.stop
            said = f"{name} row {row} ends at {figure(phase.stop)}{unit}, {figure(short)}{unit} before it begins"
            yield DesignError("phases", said, "forward", filling(phases, length))
            return


def filling(phases: Sequence[TurnPhase], length: float = TURN) -> list[dict[str, Any]]:
    """Return the phases, evenly spread over the cycle."""
    step = length / len(phases)
    edges = [*(i * step for i in range(len(phases))), length]
    return [
        phase.model_dump() | {"start": start, "stop": stop}
        for phase, start, stop in zip(phases, edges, edges[1:], strict=False)
    ]
