"""Texts of controllers: numbers, columns of them, comments on what they count; Structured Text read."""

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from engine.laws.base import Array
from workbook.controllers.table import MOST_POINTS, Table
from workbook.errors import TargetError

NUMBER = r"[+-]?[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?"
STANDS = re.compile(rf"the axis stands at ({NUMBER}) ")
LARGEST = 1e9  # of a step
TOLD = re.compile(r"one step is (\S{1,30}) (?:\S{1,30}) of x and (\S{1,30}) (?:\S{1,30}) of y")
FIELD = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?")
STARTS = re.compile(r"[+-]?[.,]?[0-9]|[+-]?(?:nan|inf)", re.IGNORECASE)
# what titles have, also a title that begins with a digit
WORDS = re.compile(r"(?!nan|inf)[^\W\d_]{2}", re.IGNORECASE)
ZEROS = re.compile(r"[+-]?0[0-9]+")
SIGNS = str.maketrans({"\u2212": "-", '"': None})
WHOLE = re.compile(r"[0-9]+")
WIDEST = 2000  # characters of a line
COMMENT = re.compile(r"//[^\n]*|\(\*.*?(?:\*\)|\Z)", re.DOTALL)
ASSIGNED = re.compile(r"\b([A-Za-z_]\w{0,60})\s{0,9}:=\s{0,9}([^,;()\[\]\s]{1,40})")
INDEXED = re.compile(r"\[([0-9]{1,9})\]\s{0,9}\.\s{0,9}([A-Za-z_]\w{0,60})\s{0,9}:=\s{0,9}([^,;()\[\]\s]{1,40})")
PLAIN = re.compile(NUMBER)
Units = tuple[str, str]  # of x and y


@dataclass(frozen=True)
class Number:
    """A kind of number: floating of 64 or 32 bits, or whole steps of 32 bits; ``digits`` that a text of it needs."""

    name: str
    largest: float
    whole: bool = False

    def rounded(self, values: Array, step: float = 1.0) -> Array:
        """Return values as the controller holds them, whole ones in steps of ``step``; raise TargetError beyond it."""
        size = np.abs(values / step if self.whole else values)
        if not np.all(size <= self.largest):
            # of a polynomial, its row and coefficient
            at = tuple(np.argwhere(~(size <= self.largest))[0])
            message = f"{values[at]:.6g} is beyond what {self.name} holds; expected smaller ones"
            raise TargetError(f"point {at[0] + 1}: {message}")
        if self.whole:
            return np.asarray(np.round(np.round(values / step) * step, 12))
        return values if self is LREAL else np.asarray(values.astype(np.float32).astype(np.float64))

    def text(self, value: float) -> str:
        """Return the shortest text that is read as this number again."""
        if self.whole:
            return str(round(value))
        return str(np.float32(value)) if self is REAL else repr(float(value))


LREAL = Number("LREAL", 1.7976931348623157e308)
REAL = Number("REAL", 3.4028234663852886e38)
DINT = Number("DINT", 2147483647.0, whole=True)
DINT_IN_REAL = Number("DINT that REAL holds", 16777216.0, whole=True)


def literal(value: float, number: Number = LREAL) -> str:
    """Return a number's text as Structured Text writes it: with a point, its exponent after E."""
    mantissa, _, power = number.text(value).partition("e")
    pointed = mantissa if "." in mantissa else f"{mantissa}.0"
    return f"{pointed}E{int(power)}" if power else pointed


STEPS = {"°": 1e-5, "mm": 1e-4, "s": 1e-6}  # what a whole number counts, by unit
OTHER_STEP = 1e-4


def step_of(unit: str, reach: float = 0.0, largest: float = DINT.largest) -> float:
    """Return the step of a unit that a whole number counts; more where so many do not reach that far."""
    step = STEPS.get(unit, OTHER_STEP)
    while reach / step > largest:
        step = float(f"{step * 10.0:.0e}")
    return step


def counts(steps: tuple[float, float], units: Units) -> str:
    """Return the comment that says what a whole number of x and of y counts."""
    (x, y), (first, other) = steps, (unit.replace(" ", "_") for unit in units)
    return f"one step is {LREAL.text(x)} {first} of x and {LREAL.text(y)} {other} of y"


def read_counts(text: str) -> tuple[float, float]:
    """Return the steps that whole numbers of a file count; 1 where its comment does not say."""
    match = TOLD.search(text)
    if match is None:
        return 1.0, 1.0
    x, y = (float(number) if re.fullmatch(NUMBER, number) else 0.0 for number in match.groups())
    if not (0.0 < x <= LARGEST and 0.0 < y <= LARGEST):
        raise TargetError(f"one step is {match[1]} of x and {match[2]} of y; expected numbers above 0, up to 1e9")
    return x, y


def stands(offset: float, unit: str) -> str:
    """Return the comment that says where the axis is when a cam that begins at 0 begins."""
    return f"the cam begins at y = 0; the axis stands at {LREAL.text(offset)} {unit} there"


def read_stand(text: str) -> float:
    """Return where the axis is when its cam begins; 0 where the comment does not say."""
    match = STANDS.search(text)
    return float(match[1]) if match else 0.0


def as_lines(columns: Iterable[Array], separator: str = ";", decimal: str = ".", number: Number = LREAL) -> str:
    """Return columns of numbers as lines that end as Windows ends them."""
    rows = ([number.text(value) for value in row] for row in zip(*columns, strict=True))
    return "".join(f"{separator.join(row).replace('.', decimal)}\r\n" for row in rows)


def remarks(*lines: str) -> str:
    """Return lines as comments above such columns."""
    return "".join(f"# {line}\r\n" for line in lines)


def numbers(text: str, widths: Sequence[int], counted: bool = False) -> list[list[float]]:
    """Return the rows of numbers below what stands above, so many columns wide; raise TargetError, by line."""
    lines = points_below_count(number_lines(text), counted)
    decimals: set[str] = set()
    separator = found_separator([line for _, line in lines])
    if separator and all(line.endswith(separator.rstrip(" ")) for _, line in lines):
        lines = [(n, line[:-1]) for n, line in lines]
    rows = [row(n, line, separator, decimals) for n, line in lines]
    if separator == ",":
        refuse_decimal_commas(lines)
    if rows and len(rows[0]) not in widths:
        expected = " or ".join(map(str, widths))
        raise TargetError(f"line {lines[0][0]}: {len(rows[0])} columns; expected {expected}")
    for (n, _), values in zip(lines, rows, strict=True):
        if len(values) != len(rows[0]):
            raise TargetError(f"line {n}: {len(values)} columns; expected {len(rows[0])}, as in the line before")
    return rows


def number_lines(text: str) -> list[tuple[int, str]]:
    """Return the lines from the first that begins with a number on, by their numbers from 1, without comments."""
    lines: list[tuple[int, str]] = []
    for n, whole in enumerate(text.splitlines(), 1):
        line = whole.split("#", 1)[0].translate(SIGNS).strip() if whole else ""
        if line and (lines or (STARTS.match(line) and not WORDS.match(line.lstrip("+-0123456789.,")))):
            lines.append((n, line))
        if len(lines) > MOST_POINTS + 1:
            raise TargetError(f"more than {MOST_POINTS:,} lines of numbers; expected at most so many")
    if not lines:
        raise TargetError("there is no line of numbers; expected a table of two columns or more")
    return lines


def points_below_count(lines: list[tuple[int, str]], counted: bool) -> list[tuple[int, str]]:
    """Return the lines of points, below the line of their count if there is one; raise TargetError if it differs."""
    if counted and not WHOLE.fullmatch(lines[0][1]):
        raise TargetError(f"line {lines[0][0]}: {lines[0][1][:40]!r}; expected how many numbers follow")
    if WHOLE.fullmatch(lines[0][1]):
        if int(lines[0][1][:9]) != len(lines) - 1:
            raise TargetError(f"line {lines[0][0]}: {lines[0][1][:9]} points are told, {len(lines) - 1} follow")
        if len(lines) == 1:
            raise TargetError(f"line {lines[0][0]}: it tells of no points; expected two or more")
        return lines[1:]
    return lines


def refuse_decimal_commas(lines: Sequence[tuple[int, str]]) -> None:
    """Raise TargetError for a line whose commas part columns and are the decimal sign too."""
    for n, line in lines:
        if any(ZEROS.fullmatch(field.strip()) for field in line.split(",")):
            raise TargetError(
                f"line {n}: {line[:40]!r}; a comma parts the columns and is the decimal sign, it seems: "
                "expected two signs"
            )


def found_separator(given: Sequence[str]) -> str | None:
    """Return the separator of the columns: a semicolon, a tab, a bar, a comma, one with a blank; None for blanks."""
    for sign in ";\t|":
        if any(sign in line for line in given):
            return sign
    if all(", " in line for line in given) and any(re.search(r",[^ ]", line) for line in given):
        return ", "
    parts = [re.split(r"\s+", line) for line in given]
    return None if any(len(part) > 1 and all(map(FIELD.fullmatch, part)) for part in parts) else ","


def row(n: int, line: str, separator: str | None, decimals: set[str]) -> list[float]:
    """Return the numbers of a line, and keep the decimal signs that it has."""
    if len(line) > WIDEST:
        raise TargetError(f"line {n}: {len(line):,} characters; expected a row of numbers")
    fields = [field.strip() for field in (line.split(separator) if separator else line.split())]
    values = []
    for field in fields:
        if not FIELD.fullmatch(field):
            raise TargetError(f"line {n}: {field[:40]!r} is no number; expected one in each column")
        decimals |= {sign for sign in ".," if sign in field}
        value = float(field.replace(",", "."))
        if not math.isfinite(value):
            raise TargetError(f"line {n}: {field[:40]!r} is too large for a number")
        values.append(value)
    if len(decimals) > 1:
        raise TargetError(f"line {n}: both . and , stand for the decimal sign; expected one of them")
    return values


def without_comments(text: str) -> str:
    """Return a text without its comments."""
    return COMMENT.sub(" ", text)


def columns(triples: Iterable[tuple[int, str, str]], names: Sequence[str]) -> list[Array]:
    """Return the columns of fields that were assigned, by element, field and text; raise TargetError, by element."""
    elements: dict[int, dict[str, float]] = {}
    for index, name, text in islice(((i, n, t) for i, n, t in triples if n in names), MOST_POINTS * len(names) + 1):
        row = elements.setdefault(index, {})
        if name in row:
            raise TargetError(f"element {index}: {name} is assigned twice; expected once")
        if not PLAIN.fullmatch(text):
            raise TargetError(f"element {index}: {name} is {text!r}; expected a number")
        row[name] = float(text)
    if not elements:
        raise TargetError(f"no {names[0]} is assigned; expected {', '.join(names)} of each point")
    for expected, index in enumerate(elements, min(elements)):
        lacks = [name for name in names if name not in elements[index]]
        if lacks or index != expected:
            message = f"lacks {lacks[0]}" if lacks else f"follows element {expected - 1}"
            raise TargetError(f"element {index} {message}; expected every element in order, with {', '.join(names)}")
    return [np.array([row[name] for row in elements.values()]) for name in names]


def by_index(text: str, names: Sequence[str]) -> list[Array]:
    """Return the columns that ``NAME[1].field := value;`` assigns."""
    return columns(((int(i), name, value) for i, name, value in INDEXED.findall(without_comments(text))), names)


def by_group(text: str, names: Sequence[str]) -> list[Array]:
    """Return the columns that ``(field := value, …)`` initialises, a group an element."""
    elements, index = [], -1
    for name, value in ASSIGNED.findall(without_comments(text)):
        index += name == names[0]
        elements.append((index, name, value))
    return columns(elements, names)


def points(text: str, columns: Sequence[Array], count: str = "") -> Table:
    """Return the table of the columns that stand in a text, as long as ``count`` says where that is assigned."""
    x, y, *rates = columns
    v, a = rates or (None, None)
    table = Table(x, y, v, a)
    if count:
        require_count(text, count, len(table.x))
    return table


def assigned_number(text: str, name: str) -> float | None:
    """Return the number that is assigned to a name once; None where none is. Raises TargetError for two that differ."""
    values = {value for known, value in ASSIGNED.findall(without_comments(text)) if known == name}
    if len(values) > 1:
        raise TargetError(f"{name} is {' and '.join(sorted(values)[:2])}; expected one table in a file")
    value = values.pop() if values else None
    return float(value) if value and PLAIN.fullmatch(value) else None


def require_count(text: str, name: str, points: int) -> None:
    """Raise TargetError where a count is reported that is not that of the points."""
    count = assigned_number(text, name)
    if count is not None and count != points:
        raise TargetError(f"{name} is {count:g}, {points} points follow; expected as many (is the file cut off?)")


PAIR = re.compile(rf"\[\s{{0,9}}({NUMBER})\s{{0,9}},\s{{0,9}}({NUMBER})\s{{0,9}}\]")


def pairs(text: str, begin: str, end: str) -> list[Array]:
    """Return x and y of ``:= [x, y, …]`` or ``:= [[x, y], …]``; raise TargetError where that is not so."""
    _, body_start, rest = without_comments(text).partition(begin)
    body, closed, _ = rest.partition(end)
    values = (
        [value.strip() for value in PAIR.sub(r"\1, \2", body + end[1:]).split(",")] if body_start and closed else []
    )
    if len(values) < 4 or len(values) % 2 or not all(map(PLAIN.fullmatch, values)):
        raise TargetError(f"expected {begin} x and y of each point {end}, of numbers alone (is the file cut off?)")
    return [np.array([float(value) for value in values[k::2]]) for k in (0, 1)]
