"""What a template gives besides its book: axes for controllers, results of many designs, limits judged exactly.

Designs that differ only in entries that scale results (a motor, a reducer) are computed together, without a book: a
template names these entries, and gives the results by the names in its book.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Generic, NamedTuple, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from engine.drive.motor import LimitCheck
from engine.motion.profile import CamProfile
from engine.timing import Switch
from workbook.book.quantity import FAIL, OK
from workbook.book.sentence import rounded

M = TypeVar("M")
Values = NDArray[Any]  # a result of designs: one for all, or one for each


@dataclass(frozen=True)
class CamAxis:
    """An axis over a cycle of its master: its profile and the units of both."""

    name: str
    profile: CamProfile
    x_unit: str
    y_unit: str
    repeats: bool = True  # whether the cycle follows upon itself: it comes back, or a feed goes on from where it is
    shaft: Callable[[], Self] | None = None
    """gives the angle of its motor's shaft, if it has a drive; raises ValueError for what the mechanism cannot do"""

    @property
    def units(self) -> tuple[str, str, str, str]:
        """Units of y, y', y'' and y'''."""
        x, y = self.x_unit, self.y_unit
        return y, f"{y}/{x}", f"{y}/{x}²", f"{y}/{x}³"


class CamSwitch(NamedTuple):
    """A switch over a cycle of the master, in the unit of its angles."""

    name: str
    switch: Switch
    x_unit: str


class Column(NamedTuple):
    """An entry in many designs: its different values, and which of them each design has."""

    values: Sequence[Any]
    places: NDArray[np.intp]

    @property
    def each(self) -> Values:
        """The value in each design."""
        return np.array(self.values)[self.places]


Computations = dict[str, Callable[[], Any]]


class Results(NamedTuple):
    """Functions that compute results, by name; which of them are checks, and which take each design by itself.

    ``exact`` are the checks as the exact engine judges them, by their names: as slow.
    """

    named: Mapping[str, Callable[[], Any]]
    checks: Collection[str]
    slow: Collection[str]
    exact: Mapping[str, Callable[[], Any]] = MappingProxyType({})


class Scaling(NamedTuple, Generic[M]):
    """The entries of a kind of machine that only scale its results, and these results.

    ``part`` returns to which part of the machine the entry at a key belongs, empty for all others; one entry of a part
    may differ. ``results`` gives the results of designs that differ in the columns, by the keys of these.
    """

    part: Callable[[str], str]
    results: Callable[[M, Mapping[str, Column]], Results]


class JudgedLimit(NamedTuple):
    """A limit as its sheet and as the exact engine has it: both must hold it."""

    check: str  # name of the sheet's check
    of: str  # whose limit it is
    what: str  # what is limited
    unit: str
    sheet: LimitCheck
    exact: LimitCheck
    bound: float  # share of the limit by which the sheet states that its figure may be off

    @property
    def ok(self) -> bool:
        """Whether the sheet's figure and the exact one are both within the limit."""
        return self.sheet.ok and self.exact.ok

    @property
    def is_close(self) -> bool:
        """Whether the sheet's figure is within its stated bound of the limit."""
        return abs(self.sheet.use - 1.0) <= self.bound

    @property
    def line(self) -> str:
        """Both figures against the limit; of a figure that is close to it, how close, and how well that is known."""
        exact, limit = f"{rounded(self.exact.value)} {self.unit}", f"{rounded(self.exact.limit)} {self.unit}"
        if self.is_close:
            share, known = f"{100.0 * self.sheet.use:.2f} %", f"{100.0 * self.bound:.2g} %"
            return f"{self.what} at the limit: {share}, known to {known}; {exact} exactly, the limit is {limit}"
        sheet = f"{rounded(self.sheet.value)} {self.unit}"
        return f"{self.what} is {exact} exactly, {sheet} on its sheet; the limit is {limit}"


class ExactJudgement(NamedTuple):
    """What the exact engine says of a book: of its limits, and in a line of each result off by more than stated."""

    limits: Sequence[JudgedLimit] = ()
    deviations: Sequence[str] = ()

    @property
    def notes(self) -> list[str]:
        """The deviations, and the limits that are held but close."""
        return [*self.deviations, *(f"{one.of}: {one.line}" for one in self.limits if one.ok and one.is_close)]

    def judge(self, check: str, verdict: str, says: str) -> tuple[str, str]:
        """Return the verdict of a check and its sentence: it holds where its sheet and the exact engine say so."""
        limit = next((one for one in self.limits if one.check == check), None)
        if limit is None or verdict not in (OK, FAIL) or limit.exact.ok == (verdict == OK):
            return verdict, says
        return FAIL, "; ".join(filter(None, (limit.line, says)))


NOTHING_JUDGED = ExactJudgement()
