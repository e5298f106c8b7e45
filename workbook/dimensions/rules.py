"""The dimension of an expression, from those of the cells that it reads."""

import math
import operator
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain

from workbook.book.address import Address
from workbook.book.columns import Node, tree
from workbook.book.formula import Area, FormulaError
from workbook.dimensions.units import NONE, Dimension, dimension_of, dimension_text, is_either, powers
from workbook.reading.contents import Contents

# functions whose arguments, and result, have the same dimension
LIKE = frozenset(
    ("ABS AVERAGE CEILING FLOOR IFERROR IFNA INT LARGE MAX MEDIAN MIN MOD MROUND N SMALL STDEV SUM TRUNC").split()
)
# those whose result has that of the first
FIRST = frozenset(["ROUND", "ROUNDDOWN", "ROUNDUP", "INDEX", "SUMIF"])
NUMBERS = frozenset(
    ("ACOS ACOSH ASIN ASINH ATAN ATANH COS COSH DEGREES EXP LN LOG LOG10 RADIANS SIN SINH TAN TANH").split()
)  # functions of numbers and angles
COUNTS = frozenset(
    ("AND COUNT COUNTA COUNTIF COLUMN COLUMNS FALSE ISBLANK ISERROR ISNUMBER MATCH NOT OR ROW ROWS SIGN TRUE").split()
)
COMPUTED = {"+": operator.add, "-": operator.sub, "*": operator.mul}
COMPUTED |= {"/": operator.truediv, "^": operator.pow}


@dataclass(frozen=True)
class Term:
    """The knowledge of an expression: dimension and number."""

    dimension: Dimension | None = None  # where it is known
    number: float | None = None  # its value, if it is built of numbers alone
    free: bool = False  # whether it goes with any dimension in a sum: a number in a formula, a text
    several: tuple[Dimension, ...] = ()  # those of a range of cells of unlike dimensions

    @property
    def factor(self) -> Dimension | None:
        """The dimension as a factor: of a number that may well have a unit, such as 9.81, it is not known."""
        if self.number is None:
            return None if self.free else self.dimension
        return NONE if plain(self.number) else None


FREE, UNKNOWN = Term(free=True), Term()
MOST_READ = 2_000_000  # cells of ranges, behind which a range is of no known dimension
Judged = tuple[Term, tuple[str, ...]]


def plain(number: float) -> bool:
    """Whether a number is a count or converts units: whole, a part of a whole number, or such times π."""
    sizes = (abs(number), abs(number) / math.pi, abs(number) * math.pi)
    either = [ratio for size in sizes if size for ratio in (size, 1 / size)]
    return not number or any(ratio >= 0.5 and math.isclose(ratio, round(ratio), rel_tol=1e-12) for ratio in either)


class FormulaChecker:
    """One formula with the terms of its arguments; ``wrong`` has what cannot be, in words."""

    def __init__(self, arguments: Sequence[Term]) -> None:
        self.arguments = arguments
        self.wrong: list[str] = []

    def of(self, node: Node) -> Term:
        """Return the term of a node, and note what cannot be."""
        if node.kind == "number":
            return Term(number=node.value, free=True)
        if node.kind == "argument":
            return self.arguments[int(node.value)]
        if node.kind == "other":
            return FREE
        if node.kind == "constants":
            raise FormulaError("#VALUE!", "constants side by side have no dimension of their own")
        parts = [self.of(part) for part in node.parts]
        return self.operation(node.value, parts) if node.kind == "operation" else self.call(node.value, parts)

    def operation(self, sign: str, parts: list[Term]) -> Term:
        """Return the term of an operation."""
        if len(parts) == 1:
            return parts[0]
        numbers = [part.number for part in parts if part.number is not None]
        if len(numbers) == len(parts) and (number := number_of(sign, *numbers)) is not None:
            return Term(number=number, free=True)
        if sign in "+-":
            return self.like("a sum", parts)
        if sign in "*/":
            return product(parts, (1, 1 if sign == "*" else -1))
        if sign in "^&":
            return self.power(*parts) if sign == "^" else FREE
        self.like("a comparison", parts)
        return Term(NONE)

    def like(self, what: str, parts: Iterable[Term]) -> Term:
        """Return the term of what has the same dimension in all its parts."""
        every = list(parts)
        each = (part.several if part.dimension is None else (part.dimension,) for part in every)
        known = dict.fromkeys(chain.from_iterable(each))
        if len(known) > 1:
            self.wrong.append(f"{what} of {' and '.join(map(dimension_text, known))}")
        if len(known) == 1:
            return Term(next(iter(known)))
        return FREE if every and not known and all(part.free for part in every) else UNKNOWN

    def power(self, base: Term, exponent: Term) -> Term:
        """Return the term of a power."""
        self.require_number("an exponent", exponent)
        if base.factor is None or (base.factor != NONE and exponent.number is None):
            return UNKNOWN
        return Term(power_of(base.factor, exponent.number or 0.0))

    def require_number(self, what: str, term: Term) -> None:
        """Note where a term that must be a number or an angle has a dimension."""
        if term.dimension not in (None, NONE):
            self.wrong.append(f"{what} of {dimension_text(term.dimension)}")

    def of_numbers(self, name: str, parts: list[Term]) -> Term:
        """Return the term of a function of numbers and angles."""
        for part in parts:
            self.require_number(name, part)
        return Term(NONE)

    def look_up(self, name: str, parts: list[Term]) -> Term:
        """Return the term of what is looked up: that of the last range."""
        self.like(name, parts[:2])
        return parts[-1]

    def angle(self, name: str, parts: list[Term]) -> Term:
        """Return the term of the angle of two alike sides."""
        self.like(name, parts)
        return Term(NONE)

    def branches(self, name: str, parts: list[Term]) -> Term:
        """Return the term of a choice among all parts but the first."""
        return self.like(f"the branches of {name}", parts[1:])

    def call(self, name: str, parts: list[Term]) -> Term:
        """Return the term of a call; unknown for a function that is not known here."""
        return CALLS[name](self, name, parts) if name in CALLS else UNKNOWN


CALLS: dict[str, Callable[[FormulaChecker, str, list[Term]], Term]] = {
    **dict.fromkeys(COUNTS, lambda checker, name, parts: Term(NONE)),
    **dict.fromkeys(FIRST, lambda checker, name, parts: parts[0] if parts else UNKNOWN),
    **dict.fromkeys(LIKE, FormulaChecker.like),
    **dict.fromkeys(NUMBERS, FormulaChecker.of_numbers),
    **dict.fromkeys(("IF", "CHOOSE"), FormulaChecker.branches),
    "ATAN2": FormulaChecker.angle,
    "LOOKUP": FormulaChecker.look_up,
    "PI": lambda checker, name, parts: Term(number=math.pi, free=True),
    "POWER": lambda checker, name, parts: checker.power(*parts),
    # of a range it has the power of its size, which a term does not tell
    "PRODUCT": lambda checker, name, parts: Term(NONE) if all(p.dimension == NONE for p in parts) else UNKNOWN,
    "SQRT": lambda checker, name, parts: checker.power(parts[0], Term(number=0.5)),
    "SUMPRODUCT": lambda checker, name, parts: product(parts, (1,) * len(parts)),
    "SUMSQ": lambda checker, name, parts: checker.power(checker.like(name, parts), Term(number=2.0)),
}


def product(parts: Sequence[Term], signs: Sequence[int]) -> Term:
    """Return the term of a product, ``signs`` -1 for a divisor; unknown if any of its factors is."""
    dimension = NONE
    for part, sign in zip(parts, signs, strict=True):
        if part.factor is None:
            return UNKNOWN
        dimension = dimension * part.factor if sign > 0 else dimension / part.factor
    return Term(dimension)


def power_of(dimension: Dimension, exponent: float) -> Dimension:
    """Return a power of a dimension, its exponents as fractions so that √x² is x."""
    exponents = {name: Fraction(power * exponent).limit_denominator(60) for name, power in powers(dimension).items()}
    return Dimension({name: float(power) for name, power in exponents.items()})


def number_of(sign: str, *numbers: float) -> float | None:
    """Return the value of an operation with numbers; None where there is none."""
    try:
        value = COMPUTED[sign](*numbers) if sign in COMPUTED else None
    except (ArithmeticError, ValueError):
        return None
    return value if isinstance(value, float) and math.isfinite(value) else None


@dataclass
class Dimensions:
    """The result: contradictions in words, by cell; and the number of formula cells of known dimension."""

    wrong: dict[Address, str] = field(default_factory=dict)
    formulas: int = 0
    known: int = 0


class UnitWalk:
    """The terms of cells met so far: ``units`` are run through formulas; a cell with a unit has its dimension."""

    def __init__(self, contents: Contents, units: Mapping[Address, str]) -> None:
        self.contents, self.units = contents, units
        self.terms: dict[Address, Term] = {}
        self.areas: dict[Area, Term] = {}
        # the terms of a range from its first row to each that was read, by its columns and first row
        self.growing: dict[tuple[str, int, int, int], list[tuple[Term, ...]]] = {}
        self.read_cells = 0
        self.judged: dict[tuple[str, tuple[Term, ...]], Judged] = {}  # a formula that is copied is judged once
        for cell, unit in units.items():
            dimension = dimension_of(unit)
            if is_either(unit):
                self.terms[cell] = UNKNOWN
            elif dimension is not None and not isinstance(contents.constants.get(cell), str):
                self.terms[cell] = Term(dimension)

    def walk(self, order: Iterable[Address]) -> Dimensions:
        """Return the result of all formulas, each behind those that it needs."""
        result = Dimensions()
        for cell in order:
            if (formula := self.contents.formulas.get(cell)) is None:
                continue
            key = formula.shape, tuple(self.argument(argument) for argument in formula.arguments)
            if key not in self.judged:
                self.judged[key] = self.judge(*key)
            term, wrong = self.judged[key]
            label = self.terms.setdefault(cell, term).dimension
            if label is not None and term.dimension is not None and term.dimension != label:
                wrong = (*wrong, f"{dimension_text(term.dimension)} where the unit says {dimension_text(label)}")
            if wrong and not is_either(self.units.get(cell, "")):
                result.wrong[cell] = "; ".join(dict.fromkeys(wrong))
            result.formulas += 1
            result.known += term.dimension is not None or term.free
        return result

    def judge(self, shape: str, terms: tuple[Term, ...]) -> Judged:
        """Return the term of a formula from those of its arguments, and what cannot be, in words."""
        checker = FormulaChecker(terms)
        try:
            return checker.of(tree(shape)), tuple(checker.wrong)
        except (FormulaError, RecursionError, IndexError, TypeError, OverflowError):  # other arguments than it takes
            return UNKNOWN, ()

    def argument(self, argument: Area | str) -> Term:
        """Return the term of a text, a cell or a range."""
        if isinstance(argument, str):
            return FREE
        if argument.size == 1:
            return self.cell(argument.first)
        if argument not in self.areas:
            self.areas[argument] = self.range(argument)
        return self.areas[argument]

    def range(self, area: Area) -> Term:
        """Return the term of a range: unknown where that of any of its cells is; a row is read once."""
        rows = self.growing.setdefault((area.sheet, area.left, area.right, area.top), [()])
        for row in range(area.top + len(rows) - 1, area.bottom + 1):
            self.read_cells += len(area.columns)
            if self.read_cells > MOST_READ:
                return UNKNOWN
            met = dict.fromkeys(self.cell(Address(area.sheet, row, column)) for column in area.columns)
            rows.append(rows[-1] if met.keys() <= {*rows[-1]} else rows[-1] + tuple(met))
        terms = dict.fromkeys(rows[area.bottom - area.top + 1])
        if any(term.dimension is None and not term.free for term in terms):
            return UNKNOWN
        known = tuple(dict.fromkeys(term.dimension for term in terms if term.dimension is not None))
        return Term(known[0]) if len(known) == 1 else Term(several=known) if known else FREE

    def cell(self, cell: Address) -> Term:
        """Return the term of a cell; texts and empty cells go with any."""
        if cell in self.terms:
            return self.terms[cell]
        held = self.contents.constants.get(cell)
        return FREE if cell not in self.contents.formulas and (held is None or isinstance(held, str)) else UNKNOWN
