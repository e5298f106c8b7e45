"""What a target declares: numbers, limits, the rule between points, and who writes and who reads its file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.cams.profile import CamProfile
from engine.laws.base import Array
from workbook.controllers.number import LREAL, Number
from workbook.controllers.table import Table

if TYPE_CHECKING:
    from workbook.controllers.tappets import Tappets

Certainty = Literal["documented", "probable", "untested"]
Spacing = Literal["free", "equal", "breaks"]
"""of points: anywhere, at equal steps alone, or on the breaks at least"""


class Claim(NamedTuple):
    """One thing about a target's format: what is held for true, how certain that is, and by which document."""

    what: str
    certainty: Certainty
    source: str


@dataclass(frozen=True)
class Handed:
    """What a writer is given: a table in the target's numbers, a name, and what is said of it in the header.

    ``units`` are those of x and y; ``repeats`` whether the cycle follows upon itself. ``separator`` and ``decimal``
    are asked for where texts have columns.
    """

    table: Table
    name: str
    header: tuple[str, ...]
    units: tuple[str, str]
    repeats: bool = True
    separator: str = ";"
    decimal: str = "."


@dataclass(frozen=True)
class Target:
    """A controller, or a format of tables.

    ``rules`` say what is between points: several where the documents do not settle it, and then each is tried and the
    worst is a bound. ``plain`` are those for a table of x and y only, where a file may have no more. ``columns`` are
    what a point has; ``points`` the fewest and the most, ``counts`` all there may be where these are few; ``signs``
    which of separator and decimal may be asked for; ``tolerance`` what is asked of which order unless told otherwise.
    ``exact`` says which stretches of a motion need no points within; ``built`` makes a table of polynomials of a
    motion, between places, in steps of x and y.
    """

    name: str
    title: str
    suffix: str
    columns: tuple[str, ...]
    rules: tuple[str, ...]
    write: Callable[[Handed], str]
    read: Callable[[str], Table]
    claims: tuple[Claim, ...]
    number: Number = LREAL
    points: tuple[int, int] = (2, 10_000)
    counts: tuple[int, ...] = ()
    signs: tuple[str, ...] = ()
    spacing: Spacing = "free"
    plain: tuple[str, ...] = ()
    tolerance: tuple[tuple[str, float], ...] = (("y", 1e-4), ("a", 0.01))
    exact: Callable[[CamProfile], NDArray[np.bool_]] | None = None
    built: Callable[[CamProfile, Array, tuple[float, float]], Table] | None = None
    tappets: Tappets | None = None
    """how it takes switches; None where its format has none, or no document at hand tells how"""

    @property
    def untested(self) -> tuple[Claim, ...]:
        """What no document settles."""
        return tuple(claim for claim in self.claims if claim.certainty == "untested")
