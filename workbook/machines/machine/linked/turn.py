"""A place at which power turns round, and what was tried to find it."""

from __future__ import annotations

from typing import NamedTuple

from engine.machine.brackets import Bracket, Step
from engine.machine.places import Worked


class Turn(NamedTuple):
    """Where power turns round: the number of the figure, from 1, the row of places, and what was tried.

    ``kink`` is the number, from 1, of an earlier turn between the same places: there the figure has a kink, and at a
    place beside it the value ``at_kink``.
    """

    figure: int
    row: int
    stretch: int
    kink: int
    beside: float
    at_kink: float
    bracket: Bracket
    rise: int
    first: Worked
    at_first: float
    step2: Step
    second: Worked
    at_second: float
    step3: Step
    third: Worked
    at_third: float
    step4: Step
    angle: float
