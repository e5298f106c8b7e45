"""Boundary values of a movement (velocity, acceleration, jerk at its ends), and the laws that can meet them."""

from dataclasses import astuple, dataclass, field, replace
from typing import ClassVar

from engine.laws.base import require_finite
from engine.laws.family import Law

Slopes = tuple[float | None, float | None]
AT_REST: Slopes = (None, None)
NAMES = {"v": "velocity", "a": "acceleration", "j": "jerk"}
STILL = 1e-9  # share of the law's largest velocity or acceleration below which a value counts as 0
ROUNDING = 1e-12  # share of a stroke or a velocity by which equal values may differ


class EndError(ValueError):
    """Boundary values that a law cannot meet."""


@dataclass(frozen=True)
class BoundaryValues:
    """Stroke and derivatives by ξ at both ends, in the unit of the stroke. Raises ValueError unless all are finite."""

    stroke: float = 1.0
    v0: float = 0.0  # velocity at the begin: y' δ of a phase of the duration δ
    v1: float = 0.0  # and at the end
    a0: float = 0.0  # acceleration at the begin: y'' δ²
    a1: float = 0.0  # and at the end
    j0: float = 0.0  # jerk at the begin: y''' δ³
    j1: float = 0.0  # and at the end

    def __post_init__(self) -> None:
        require_finite(**vars(self))

    @property
    def values(self) -> tuple[float, ...]:
        """Stroke, v0, v1, a0, a1, j0, j1."""
        return astuple(self)

    @property
    def at_rest(self) -> bool:
        """Whether velocity, acceleration and jerk are 0 at both ends."""
        return not any(self.values[1:])

    @property
    def slopes(self) -> Slopes:
        """The velocities at both ends; None of an end at rest."""
        v, a = self.both("v"), self.both("a")
        return v[0] if v[0] or a[0] else None, v[1] if v[1] or a[1] else None

    @property
    def straight(self) -> bool:
        """Whether a straight line meets all values, but for rounding."""
        bent = any(self.values[3:]) or abs(self.v1 - self.v0) > ROUNDING * abs(self.v0)
        return not bent and abs(self.stroke - self.v0) <= ROUNDING * abs(self.stroke)

    def both(self, quantity: str) -> tuple[float, float]:
        """Return the values of a quantity ("v", "a" or "j") at begin and end."""
        return getattr(self, f"{quantity}0"), getattr(self, f"{quantity}1")

    def require_taken(self, law: Law, takes: str) -> None:
        """Raise EndError for the first value other than 0 of a quantity that is not in ``takes``, of "vaj"."""
        for quantity, name in NAMES.items():
            for verb, value in zip(("begin", "end"), self.both(quantity), strict=True):
                if value and quantity not in takes:
                    raise EndError(f"{law.name} cannot {verb} with a prescribed {name}: {_reason(takes)}")


REST = BoundaryValues()


@dataclass(frozen=True)
class BoundaryLaw(Law):
    """A law with boundary values, its field ``ends``: s(1) is their stroke; by default it rises by 1 between rests."""

    TAKES: ClassVar[str] = "v"

    ends: BoundaryValues = field(default=REST, kw_only=True)

    @property
    def entry_velocity(self) -> float:
        """Velocity at ξ = 0."""
        return self.ends.v0

    @property
    def takes(self) -> str:
        """The quantities that may be prescribed at the ends: letters of "vaj"."""
        return self.TAKES

    def between(self, ends: BoundaryValues) -> "BoundaryLaw":
        """Return the law with these boundary values; raise EndError, with the reason, if it cannot meet them."""
        ends.require_taken(self, self.takes)
        return replace(self, ends=ends)


def law_with_ends(law: Law, ends: BoundaryValues) -> Law:
    """Return a law with boundary values that are not at rest; raise EndError if it cannot meet them."""
    if isinstance(law, BoundaryLaw):
        return law.between(ends)
    ends.require_taken(law, "")
    raise AssertionError("ends that are not at rest ask for something")


def _reason(takes: str) -> str:
    if not takes:
        return "its ends follow from its own pieces; a polynomial of degree 3, 5 or 7 or a modified sine can"
    known = " and ".join(NAMES[quantity] for quantity in takes)
    return f"it takes {known} there; a polynomial of degree 5 takes an acceleration, of degree 7 a jerk too"


def kind(v: float, a: float) -> str:
    """Return the kind of end by VDI 2143, for v and a over their peaks: R rest, G constant v, U reversal, B general."""
    moves, accelerates = abs(v) > STILL, abs(a) > STILL
    return ("B" if accelerates else "G") if moves else ("U" if accelerates else "R")


def kinds(law: Law) -> tuple[str, str]:
    """Return the kinds of end that a law can have at its begin and at its end, as letters of "RGUB"."""
    scale = law.coefficients
    begin, end = (kind(at.v / (scale.cv or 1.0), at.a / (scale.ca or 1.0)) for at in (law.start, law.end))
    if not isinstance(law, BoundaryLaw):
        return begin, end
    if "a" in law.takes:
        return "RGUB", "RGUB"
    begin, end = (("UB" if own in "UB" else "RG")[: 1 + len(law.takes)] for own in (begin, end))
    return begin, end
