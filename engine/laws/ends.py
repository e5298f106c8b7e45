"""What a movement has to meet at its two ends, and which laws can."""

from dataclasses import astuple, dataclass, replace
from typing import ClassVar

from engine.laws.base import require_finite
from engine.laws.family import Law

NAMES = {"v": "velocity", "a": "acceleration", "j": "jerk"}
STILL = 1e-9  # of the law's own scale: a velocity or an acceleration below this is rounding
ROUNDING = 1e-12  # of a stroke or a velocity: two of them that differ by less are the same


class EndError(ValueError):
    """A law cannot begin or end as the movement asks."""


@dataclass(frozen=True)
class BoundaryValues:
    """Stroke; velocity, acceleration, jerk at begin and end, per unit of ξ: y' δ, y'' δ², y''' δ³. All are finite."""

    stroke: float = 1.0
    v0: float = 0.0
    v1: float = 0.0
    a0: float = 0.0
    a1: float = 0.0
    j0: float = 0.0
    j1: float = 0.0

    def __post_init__(self) -> None:
        require_finite(stroke=self.stroke, v0=self.v0, v1=self.v1, a0=self.a0, a1=self.a1, j0=self.j0, j1=self.j1)

    @property
    def values(self) -> tuple[float, ...]:
        """Stroke, v0, v1, a0, a1, j0, j1."""
        return astuple(self)

    @property
    def at_rest(self) -> bool:
        """Whether nothing but a stroke is asked for."""
        return not any(self.values[1:])

    @property
    def straight(self) -> bool:
        """Whether a straight line meets them: what a curve would add to it is rounding."""
        bent = any(self.values[3:]) or abs(self.v1 - self.v0) > ROUNDING * abs(self.v0)
        return not bent and abs(self.stroke - self.v0) <= ROUNDING * abs(self.stroke)

    def both(self, quantity: str) -> tuple[float, float]:
        """Return the values of ``quantity`` (v, a or j) at begin and end."""
        return getattr(self, f"{quantity}0"), getattr(self, f"{quantity}1")


REST = BoundaryValues()


class BoundaryLaw(Law):
    """A law whose ends may be prescribed, a field of each: by default of unit stroke between rests, else s(1) is it."""

    TAKES: ClassVar[str] = "v"

    ends: BoundaryValues

    @property
    def entry_velocity(self) -> float:
        """The velocity that it begins with."""
        return self.ends.v0

    @property
    def takes(self) -> str:
        """The quantities that may be prescribed at its ends: of v, a, j."""
        return self.TAKES

    @property
    def fixes_ends(self) -> bool:
        """Whether it keeps the velocities that it has at its ends, whatever is beside it."""
        return False

    def between(self, ends: BoundaryValues) -> "BoundaryLaw":
        """Return the law between these ends, with their stroke; raise EndError, with the reason, if it has none."""
        require_ends(self, ends, self.takes)
        return replace(self, ends=ends)  # type: ignore[type-var]  # every law is a dataclass

    def with_open_ends(self, begin: bool, end: bool) -> "BoundaryLaw":
        """Return the law where nothing precedes it (``begin``) or follows it (``end``): most laws rest there."""
        del begin, end
        return self


def law_with_ends(law: Law, ends: BoundaryValues) -> tuple[Law, float]:
    """Return any law between two ends, and what its s, v, a, j are to be multiplied by; raise EndError if it cannot."""
    if ends.at_rest:
        return law, ends.stroke
    if isinstance(law, BoundaryLaw):
        return law.between(ends), 1.0
    require_ends(law, ends, "")
    raise AssertionError("ends that are not at rest ask for something")


def require_ends(law: Law, ends: BoundaryValues, takes: str) -> None:
    """Raise EndError for the first end that is asked of a law but not among what it takes (of v, a, j)."""
    for quantity, name in NAMES.items():
        for verb, value in zip(("begin", "end"), ends.both(quantity), strict=True):
            if value and quantity not in takes:
                raise EndError(f"{law.name} cannot {verb} with a prescribed {name}: {_reason(takes)}")


def _reason(takes: str) -> str:
    if not takes:
        return "its ends follow from its own pieces; a polynomial of degree 3, 5 or 7 or a modified sine can"
    known = " and ".join(NAMES[quantity] for quantity in takes)
    return f"it takes {known} there; a polynomial of degree 5 takes an acceleration, of degree 7 a jerk too"


def kind(v: float, a: float) -> str:
    """Return VDI 2143's R rest, G constant velocity, U reversal or B general, by v and a in units of their peaks."""
    moves, accelerates = abs(v) > STILL, abs(a) > STILL
    return ("B" if accelerates else "G") if moves else ("U" if accelerates else "R")


def kinds(law: Law) -> tuple[str, str]:
    """Return the kinds of end, of R, G, U and B, that a law can have at its begin and at its end."""
    scale = law.coefficients
    begin, end = (kind(at.v / (scale.cv or 1.0), at.a / (scale.ca or 1.0)) for at in (law.start, law.end))
    if not isinstance(law, BoundaryLaw):
        return begin, end
    if "a" in law.takes:
        return "RGUB", "RGUB"
    begin, end = (("UB" if own in "UB" else "RG")[: 1 + len(law.takes)] for own in (begin, end))
    return begin, end
