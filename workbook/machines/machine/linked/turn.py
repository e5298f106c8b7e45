"""A place at which power turns round, and what was tried to find it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from engine.machine.brackets import Bracket, Point, Step
from engine.machine.places import Held, Worked


class Tried(NamedTuple):
    """Four places, one after the other nearer to where a figure changes its sign."""

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


def tried(held: Held, name: str, bracket: Bracket, rise: int) -> Tried:
    """Return the places that are tried of a figure by its name, which rises (1) or falls (−1); 0: no step is taken."""

    def at(u: float) -> tuple[Worked, Point]:
        found = held.at(np.array([u]))
        return found, Point(u, float(getattr(found, name)[0]))

    first, one = at(bracket.first)
    step2 = bracket.step(bracket.begin, bracket.end, one, rise)
    second, two = at(step2.place)
    step3 = bracket.step(bracket.begin, one, two, rise)
    third, three = at(step3.place)
    step4 = bracket.step(one, two, three, rise)
    return Tried(rise, first, one.value, step2, second, two.value, step3, third, three.value, step4)


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
    tried: Tried
    angle: float
