"""Tables as columns of text: written with any separator, read with the one and the decimal sign that are found."""

import math
import re
from collections.abc import Iterable, Sequence

from engine.laws.base import Array
from workbook.controllers.number import LREAL, Number
from workbook.controllers.table import MOST_POINTS
from workbook.errors import TargetError

NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?")
STARTS = re.compile(r"[+-]?[.,]?[0-9]|[+-]?(?:nan|inf)", re.IGNORECASE)
WORDS = re.compile(r"(?!nan|inf)[^\W\d_]{2}", re.IGNORECASE)
"""what a line of titles has, also one that begins with a digit"""
ZEROS = re.compile(r"[+-]?0[0-9]+")
SIGNS = str.maketrans({"\u2212": "-", '"': None})
WHOLE = re.compile(r"[0-9]+")
LONGEST = 2000  # characters of a line


def written(columns: Iterable[Array], separator: str = ";", decimal: str = ".", number: Number = LREAL) -> str:
    """Return columns of numbers as lines that end as Windows ends them."""
    rows = ([number.text(value) for value in row] for row in zip(*columns, strict=True))
    return "".join(f"{separator.join(row).replace('.', decimal)}\r\n" for row in rows)


def remarks(*lines: str) -> str:
    """Return lines as comments above such columns."""
    return "".join(f"# {line}\r\n" for line in lines)


def numbers(text: str, widths: Sequence[int], comment: str = "#", counted: bool = False) -> list[list[float]]:
    """Return the rows of numbers below what stands above, so many columns wide; raise TargetError, by line."""
    kept: list[tuple[int, str]] = []
    for n, whole in enumerate(text.splitlines(), 1):
        line = whole.split(comment, 1)[0].translate(SIGNS).strip() if whole else ""
        if line and (kept or (STARTS.match(line) and not WORDS.match(line.lstrip("+-0123456789.,")))):
            kept.append((n, line))
        if len(kept) > MOST_POINTS + 1:
            raise TargetError(f"more than {MOST_POINTS:,} lines of numbers; expected at most so many")
    if not kept:
        raise TargetError("there is no line of numbers; expected a table of two columns or more")
    if counted and not WHOLE.fullmatch(kept[0][1]):
        raise TargetError(f"line {kept[0][0]}: {kept[0][1][:40]!r}; expected how many numbers follow")
    if WHOLE.fullmatch(kept[0][1]):
        if int(kept[0][1][:9]) != len(kept) - 1:
            raise TargetError(f"line {kept[0][0]}: {kept[0][1][:9]} points are told, {len(kept) - 1} follow")
        if len(kept) == 1:
            raise TargetError(f"line {kept[0][0]}: it tells of no points; expected two or more")
        kept = kept[1:]
    decimals: set[str] = set()
    separator = found_separator([line for _, line in kept])
    if separator and all(line.endswith(separator.rstrip(" ")) for _, line in kept):
        kept = [(n, line[:-1]) for n, line in kept]
    rows = [row(n, line, separator, decimals) for n, line in kept]
    for n, line in kept if separator == "," else ():
        if any(ZEROS.fullmatch(field.strip()) for field in line.split(",")):
            raise TargetError(f"line {n}: {line[:40]!r}; a comma parts the columns and is the decimal sign, it seems: "
                              "expected two signs")  # fmt: skip
    if rows and len(rows[0]) not in widths:
        expected = " or ".join(map(str, widths))
        raise TargetError(f"line {kept[0][0]}: {len(rows[0])} columns; expected {expected}")
    for (n, _), values in zip(kept, rows, strict=True):
        if len(values) != len(rows[0]):
            raise TargetError(f"line {n}: {len(values)} columns; expected {len(rows[0])}, as in the line before")
    return rows


def found_separator(given: Sequence[str]) -> str | None:
    """Return what parts the columns: a semicolon, a tab, a bar, a comma, one with a blank; None for blanks."""
    for sign in ";\t|":
        if any(sign in line for line in given):
            return sign
    if all(", " in line for line in given) and any(re.search(r",[^ ]", line) for line in given):
        return ", "
    parts = [re.split(r"\s+", line) for line in given]
    return None if any(len(part) > 1 and all(map(NUMBER.fullmatch, part)) for part in parts) else ","


def row(n: int, line: str, separator: str | None, decimals: set[str]) -> list[float]:
    """Return the numbers of a line, and keep the decimal signs that it has."""
    if len(line) > LONGEST:
        raise TargetError(f"line {n}: {len(line):,} characters; expected a row of numbers")
    fields = [field.strip() for field in (line.split(separator) if separator else line.split())]
    found = []
    for field in fields:
        if not NUMBER.fullmatch(field):
            raise TargetError(f"line {n}: {field[:40]!r} is no number; expected one in each column")
        decimals |= {sign for sign in ".," if sign in field}
        value = float(field.replace(",", "."))
        if not math.isfinite(value):
            raise TargetError(f"line {n}: {field[:40]!r} is too large for a number")
        found.append(value)
    if len(decimals) > 1:
        raise TargetError(f"line {n}: both . and , stand for the decimal sign; expected one of them")
    return found
