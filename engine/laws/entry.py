"""All that the registry knows of a law: its class, names, source, claims, and parameters to measure them at."""

from collections.abc import Callable, Container, Iterable, Mapping
from dataclasses import dataclass, field, fields
from typing import NamedTuple

from engine.laws.base import Coefficients, Law


class IncompleteError(TypeError):
    """A law lacks something that every law must state."""


@dataclass(frozen=True)
class Claims:
    """What a law promises, with its default parameters; one test measures every claim of every law.

    ``order_ends`` and ``order_inside`` are the highest derivative of s that is continuous, at the ends
    against rest and between them. The coefficients are formulas in Python's notation, over the functions
    of ``math``, the names in ``where`` and the coefficients before.
    """

    order_ends: float
    order_inside: float
    coefficients: Mapping[str, str]
    where: Mapping[str, str] = field(default_factory=dict)
    start: tuple[float, float] = (0.0, 0.0)  # s, v
    end: tuple[float, float] = (1.0, 0.0)


def formulas(text: str) -> dict[str, str]:
    """Return formulas by their names, of a text like "cv = 3/2; ca_max = 6"."""
    return {name: formula for name, _, formula in (one.partition(" = ") for one in text.split("; "))}


class Vendors(NamedTuple):
    """What a law is called where cams are made, with its number there; empty where there is none, or none is sure.

    Sources: simatic-ax/lcamhdl, LCamHdl_ProfileConstants; Beckhoff Infosys, MC_MotionFunctionType; CODESYS, segment
    types of SM3_CamBuilder; SEW 27800520, aCamSegment.
    """

    siemens: str = ""
    twincat: str = ""
    codesys: str = ""
    sew: str = ""


NAMED_NOWHERE = Vendors()


@dataclass(frozen=True)
class Entry:
    """A law in the catalogue: its class, the names that documents give it, its source and its claims.

    Raises IncompleteError for a class that leaves out what :class:`~engine.laws.base.Law` asks for, and for
    parameters that ``others`` never changes: figures that do not follow them would then pass for right.
    """

    law: type[Law]
    aliases: tuple[str, ...]
    source: str
    claims: Claims
    example: Callable[[], Law]
    """makes the law with its default parameters"""
    others: tuple[Law, ...] = ()
    """the law with other parameters, stages of no duration among them: breaks, pieces, shapes and coefficients are
    measured at these too"""
    vendors: Vendors = NAMED_NOWHERE
    beyond: tuple[Law, ...] = ()
    """the law between prescribed ends, and with parameters that its page does not enter: measured by the engine's
    tests alone"""

    def __post_init__(self) -> None:
        law, example = self.law, self.example()
        _require(law.__name__, "the constant", ("code", "name"), dir(law))
        _require(law.__name__, "the claim of", (f.name for f in fields(Coefficients)), self.claims.coefficients)
        parameters = [f.name for f in fields(law)]  # type: ignore[arg-type]
        changed = [
            p for p in parameters if any(getattr(o, p) != getattr(example, p) for o in (*self.others, *self.beyond))
        ]
        _require(law.__name__, "among its other examples one with another", parameters, changed)

    @property
    def code(self) -> str:
        """The code of three letters."""
        return self.law.code

    @property
    def name(self) -> str:
        """The name in words."""
        return self.law.name

    @property
    def names(self) -> tuple[str, ...]:
        """Every name that the law is known by."""
        return (self.code, self.name, *self.aliases)

    @property
    def examples(self) -> tuple[Law, ...]:
        """The law with its default parameters, then with others."""
        return (self.example(), *self.others)

    @property
    def rises(self) -> bool:
        """Whether the law moves at all: every one but the dwell."""
        return self.claims.end != self.claims.start


def _require(whose: str, what: str, wanted: Iterable[str], stated: Container[str]) -> None:
    """Raise IncompleteError, with the names that are wanted and not stated."""
    if missing := [name for name in wanted if name not in stated]:
        raise IncompleteError(f"{whose}: lacks {what} {', '.join(missing)}")
