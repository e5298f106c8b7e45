"""The page of a family of laws: all that a workbook has to know of it; and what several pages share.

``@`` in names and formulas stands for the law's name in the book and an underscore, as in :meth:`Sheet.scoped`:
``@av`` is the cell ``TVP_av`` of the law TVP, ``[@pieces.d.1]`` the first duration in its table ``TVP_pieces``.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, NamedTuple

from pydantic import Field, create_model

from engine.laws import Law, Piece
from engine.laws.base import BREAK_TOLERANCE
from workbook.book.cell_tables import CellTable, formulas_by_row, value_of
from workbook.book.declare import Quantity, Sheet, check
from workbook.book.sentence import amount, figure
from workbook.fields.paths import get, put, split
from workbook.fields.types import DesignError, Model, Number, Positive

_NAMED, _PIECES = (formulas_by_row(__file__, title) for title in ("coefficients", "entries of a piece"))
COEFFICIENTS = list(zip(_NAMED["name"], _NAMED["label"], _NAMED["symbol"], strict=True))
"""name, label and symbol of each"""
SINE, SECOND = ("P", "omega", "phi"), ("P2", "omega2", "phi2")
POWERS = ("c0", "c1", "c2", "c3", "c4", "c5")
ENTRIES = ("d", *POWERS, *SINE, *SECOND)
"""the columns of a table of pieces; those of a second sine are there in books with a law that needs them"""
LABELS = dict(zip(_PIECES["entry"], zip(_PIECES["label"], _PIECES["symbol"], strict=True), strict=True))
"""label and symbol of each"""
ADDS = {name: words for name, words in zip(_PIECES["entry"], _PIECES["adds"], strict=True) if words != "–"}
"""what it adds to the acceleration"""
# the column behind the charts of a law's sheet, where workings of its entries may stand
BEHIND = 20
REACHES = "ABS([@samples.s.last]-1)<check_zero"
RESTS = f"AND({REACHES},ABS([@samples.v.last])<check_zero)"


class LawSheet(Model):
    """The rise that a law's own sheet shows in dimensional form."""

    lift: Number = 100.0  # mm
    time: Positive = 0.5  # s


class Parameter(NamedTuple):
    """A number that an engineer enters for a law: its cell, and its place in the law's entries."""

    name: str
    label: str
    symbol: str
    key: str  # the entry, as in ``rise_end`` or ``durations.0``
    short: str  # the label above it in the functions' table of parameters
    source: str = ""

    @property
    def column(self) -> str:
        """The name of its column in that table."""
        return self.name.removeprefix("@")


class LawCheck(NamedTuple):
    """A check of a law's parameters."""

    name: str
    label: str
    condition: str
    says: str = ""  # the formula of where it fails, and by how much


class PieceRow:
    """One piece as written in the books: a(u) = c0 + … + c5 u⁵ + P sin(ωu + φ), a formula each."""

    def __init__(self, name: str, equation: str, d: str, **entries: str) -> None:
        self.name, self.equation = name, equation
        self.formulas = dict.fromkeys(ENTRIES, "=0") | {"d": d} | entries


def entries_of(piece: Piece) -> dict[str, float]:
    """Return the engine's value of each of :data:`ENTRIES`."""
    sines = piece.amplitude, piece.omega, piece.phase, piece.amplitude2, piece.omega2, piece.phase2
    return dict(zip(ENTRIES, (piece.duration, *piece.row[: len(POWERS)], *sines), strict=True))


@dataclass(frozen=True, kw_only=True)
class Page:
    """A family of laws with a sheet of its own; the families without derive from it and say what differs."""

    law: type[Law]  # the engine's, whose fields are entries of the same name
    titled: str = ""  # what its sheet is headed by, where that is not the name of the law
    source: str
    entries: type[Model] | None = LawSheet
    pieces: tuple[PieceRow, ...]
    # formula of each coefficient, and the equation in words
    coefficients: Mapping[str, tuple[str, str]]
    fastest: str  # the formula of the first ξ at which v is largest
    parameters: tuple[Parameter, ...] = ()
    variations: tuple[Mapping[str, Any], ...] = ()
    """other parameters, asymmetric and with stages of no duration: templates' variations and tests take them in turn"""
    workings: Callable[[Any], list[Quantity]] = lambda law: []
    checks: tuple[LawCheck, ...] = ()
    rests: bool = True  # whether it begins and ends at rest
    # whether it speeds up once, from rest, and comes to rest, whatever its parameters
    single: bool = True
    start: str = "=0"  # the formula of the velocity with which it begins
    lowest: str = "=0"  # the formula of its lowest velocity
    wrong_step: str = "=0"  # the formula of the greatest step of v the wrong way: down before its peak, up after it
    end_mode: str = "=0"
    """the formula of how it meets neighbours that hand velocity over: :func:`engine.motion.handover.end_mode`"""
    early: int = 0  # pieces of its first pulse, of a law of two pulses
    # whether its formulas stand in cells of its own, which other sheets refer to
    has_sheet: bool = True
    functions: bool = True  # whether the functions MOTION.* take it
    named: str = ""  # the formula of its name in words, where it is entered
    low: str = "=MIN(0,[s1])"
    # the formulas of its lowest and its highest s: a law that turns has others
    high: str = "=MAX(0,[s1])"
    # the entries that only laws with names of their own have: the layout of a book holds them, no cell
    without_cells: tuple[str, ...] = ()
    # the entries that its pieces may have, where it has no table of them
    of_pieces: Sequence[str] = ()

    @property
    def title(self) -> str:
        """Return the title of its sheet."""
        return self.titled or self.law.name

    def of(self, entered: Any) -> "Page":
        """Return the page of a law with these entries: most families have one."""
        return self

    def make_law(self, entered: Any) -> Law:
        """Return the engine's law with the parameters that are entered."""
        return self.law(**{name: getattr(entered, name) for name in self.fields})

    def law_of(self, numbers: Sequence[float]) -> Law:
        """Return the engine's law of its parameters in a row, as the functions MOTION.* take them."""
        return self.make_law(self.entered(numbers))

    def entered(self, numbers: Sequence[float]) -> Any:
        """Return the entries with these parameters, in the order of :attr:`parameters`; those by default of none."""
        data: dict[str, Any] = {}
        if not numbers:
            return self.entries() if self.entries else None
        for parameter, number in zip(self.parameters, numbers, strict=True):
            put(data, split(parameter.key), number)
        return self.entries.model_validate(data) if self.entries else None

    def numbers(self, entered: Any) -> list[float]:
        """Return the parameters that are entered, in a row."""
        return [get(entered, split(parameter.key)) for parameter in self.parameters]

    def enter(self, sheet: Sheet, named: Any, sizes: Any) -> None:
        """Declare entries besides the rise shown and the parameters; most families have none."""

    def work(self, sheet: Sheet, named: Any, stack: Any, sizes: Any) -> None:
        """Declare workings that need the stack of all laws; most families have none."""

    def step_back(self, law: Law, sizes: Any) -> float:
        """Return the greatest step of v the wrong way, as :attr:`wrong_step` has it."""
        return 0.0

    def detail(self, sheet: Sheet, named: Any, stack: Any, sizes: Any) -> None:
        """Declare tables behind that of the samples; most families have none."""

    def verdicts(self, named: Any, sizes: Any) -> list[Quantity]:
        """Return the checks of a law of the book."""
        name, end = named.called, named.law.end
        ends = f"{name} ends at s = 1{', at rest' if self.rests else ''}"
        s = amount("[@samples.s.last]", end.s, "s(1) = ", ", ")
        v = amount("[@samples.v.last]", end.v, "v(1) = ", "")
        return [
            *(check(each.name, f"{name}: {each.label}", each.condition, True, says=each.says) for each in self.checks),
            check("@ends", ends, RESTS if self.rests else REACHES, True, says=s.then(v)),
        ]

    def variation(self, k: int, room: int) -> dict[str, Any]:
        """Return the ``k``-th of other parameters, round and round; ``room`` is the rows of the own law's table."""
        return dict(self.variations[k % len(self.variations)]) if self.variations else {}

    def stacked(self, law: Law, sizes: Any) -> list[tuple[Piece, dict[str, str]]]:
        """Return the rows of the stack of all laws' pieces: each piece, and the formula of each of :data:`ENTRIES`."""
        shown = dict.fromkeys(self.columns, "=[@pieces.{}.{}]") if self.has_sheet else {}
        return [
            (piece, row.formulas | {name: cell.format(name, k) for name, cell in shown.items()})
            for k, (piece, row) in enumerate(zip(law.monotone_pieces(), self.pieces, strict=True), 1)
        ]

    @property
    def columns(self) -> tuple[str, ...]:
        """The entries that its table of pieces shows: the duration, powers that a piece has, sines as a whole."""
        had = {name for name in ENTRIES if any(row.formulas[name] != "=0" for row in self.pieces)} | {"d"}
        whole = {name for sine in (SINE, SECOND) if had & set(sine) for name in sine}
        return tuple(name for name in ENTRIES if name in had | whole)

    @property
    def fields(self) -> list[str]:
        """The entries of the family that are parameters of the law."""
        return [name for name in self.entries.model_fields if name not in LawSheet.model_fields] if self.entries else []


LEAST = 0.01
EVEN = 0.5
Between = Annotated[float, Field(ge=LEAST, le=1 - LEAST, allow_inf_nan=False)]
"""a share of the time: sensible are 0.2 to 0.8; far beyond 0.01 and 0.99 figures lose digits"""


class Shared(LawSheet):
    """The share of the time that accelerates."""

    share: Between = EVEN


def parameters_of(law: type[Law], base: type[LawSheet] = LawSheet, **kinds: Any) -> type[LawSheet]:
    """Return the entries of a law's parameters, of these kinds, which are by default as the engine's law has them."""
    given = ((name, getattr(law, name)) for name in kinds)
    usual = {name: [*of] if isinstance(of, tuple) else of for name, of in given}
    fields: Any = {name: (kind, usual[name]) for name, kind in kinds.items()}
    parameters = create_model(f"{law.code}Parameters", __base__=base, **fields)
    if issubclass(parameters, Staged):
        parameters.divided, parameters.usual = law, usual
    return parameters


SHARE = Parameter("@share", "Share of the time that accelerates", "λ", "share", "share λ", source="½: symmetric")
REVERSAL = Parameter("@reversal", "It turns round at", "", "reversal", "reversal", source="start or end")
Reversal = Literal["start", "end"]
SHARED: dict[str, Any] = {  # what the page of a law states that has no parameter but the share
    "entries": Shared,
    "parameters": (SHARE,),
    "variations": ({"share": 0.4}, {"share": 0.65}, {"share": 0.3}),
}
POLYNOMIAL = "=IF(ABS(@share-1/2)<1E-12,{},0)"
"""how a polynomial meets its neighbours: by its degree, unless a share shifts it"""
LEAST_STAGE = 1e-4
"""of the rise: from there on cells and engine agree to 1e-9; below it, differences of shares lose the digits"""
BRIEF = LawCheck(
    "@brief",
    "each stage lasts, or is none",
    "SUMPRODUCT(([@pieces.d]>break_eps)*([@pieces.d]<stage_least))=0",
    '"a stage lasts less than "&ROUND(stage_least,9)&" of the rise; expected that, or none"',
)


def too_brief(durations: Sequence[float], entry: str, fits: Any) -> Iterator[DesignError]:
    """Yield the fault of a stage that is shorter than the least that cells work out exactly, but not left out."""
    if any(BREAK_TOLERANCE < d < LEAST_STAGE for d in durations):
        text = f"a stage lasts less than {figure(LEAST_STAGE)} of the rise; expected that, or none"
        yield DesignError(entry, text, fits)


class Staged(LawSheet):
    """Parameters that divide the rise into stages; each lasts, or is none."""

    divided: ClassVar[type[Law]]  # the law of these parameters
    usual: ClassVar[dict[str, Any]]  # as which they are delivered

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a stage that is next to none."""
        stages = self.divided(**{name: getattr(self, name) for name in self.usual}).as_pieces()
        yield from too_brief([stage.duration for stage in stages], "", self.model_dump() | self.usual)


def parameters_in(table: CellTable) -> tuple[Parameter, ...]:
    """Return the parameters in a table: each its cell and label, its key, and what is above it among functions."""
    return tuple(Parameter(**fields_of(Parameter, row.texts)) for row in table.values())


def checks_in(table: CellTable) -> tuple[LawCheck, ...]:
    """Return the checks in a table."""
    return tuple(LawCheck(**fields_of(LawCheck, row.texts)) for row in table.values())


def pieces_in(table: CellTable) -> tuple[PieceRow, ...]:
    """Return the pieces in a table: each its words and equation, and the formulas of its entries that are not 0."""
    heads = ("name", "equation", *ENTRIES)
    return tuple(PieceRow(**{head: row.texts[head] for head in heads if head in row.texts}) for row in table.values())


def coefficients_in(table: CellTable) -> dict[str, tuple[str, str]]:
    """Return the formula of each coefficient in a table, and its equation in words."""
    return {name: (row.texts["formula"], row.texts["source"]) for name, row in table.items()}


def variations_in(module: str, title: str) -> tuple[dict[str, Any], ...]:
    """Return the variations in the table under a heading beside a module: a row each, the entries by their columns."""
    columns = formulas_by_row(module, title)
    rows = zip(*columns.values(), strict=True)
    return tuple(dict(zip(columns, map(value_of, row), strict=True)) for row in rows)


def fields_of(kind: Any, texts: dict[str, str]) -> dict[str, str]:
    """Return the texts that are fields of a named tuple."""
    return {field: texts[field] for field in kind._fields if field in texts}
