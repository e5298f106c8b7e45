"""The tables of the laws, from the catalogue, in laws.md beside this file: python -m docs.laws writes them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import MISSING, fields
from fractions import Fraction
from pathlib import Path
from typing import Any

from engine.laws import CATALOGUE, Law
from engine.laws.ends import kinds

PAGE = Path(__file__).with_suffix(".md")
ROWS = re.compile(r"(?<=\|---\|\n)(?:\|.*\n)+")


def default(value: Any) -> str:
    """Return a default as Python writes it, a share as a fraction."""
    if isinstance(value, tuple):
        return f"({', '.join(map(default, value))})"
    if isinstance(value, float):
        return str(Fraction(value).limit_denominator(100))
    return f'"{value}"' if isinstance(value, str) else repr(value)


def names(family: type[Law]) -> list[str]:
    """Return the names of a law, how it is made with its default parameters, and its file."""
    parameters = [f for f in fields(family) if f.name != "ends"]  # type: ignore[arg-type]
    texts = (f.name if f.default is MISSING else f"{f.name}={default(f.default)}" for f in parameters)
    file = family.__module__.rpartition(".")[2]
    made = f"`{family.__name__}({', '.join(texts)})`"
    return [family.code, family.name, ", ".join(family.aliases), made, f"[{file}](../engine/laws/{file}.py)"]


def figures(family: type[Law]) -> list[str]:
    """Return the kinds of end of a law, and its coefficients, with its default parameters."""
    law = family()
    k = law.coefficients
    numbers = ("∞" if math.isinf(value) else f"{value:.6g}" for value in (k.cv, k.ca, k.ca_rms, k.cj, k.va))
    return [family.code, *kinds(law), *numbers]


def rows(of: Callable[[type[Law]], list[str]]) -> str:
    """Return a row of a table for each law, in the order of their codes."""
    return "".join(f"| {' | '.join(of(family))} |\n" for family in sorted(CATALOGUE, key=lambda law: law.code))


def page() -> str:
    """Return the page, its first two tables made anew."""
    tables = iter((rows(names), rows(figures)))
    return ROWS.sub(lambda _: next(tables), PAGE.read_text(encoding="utf-8"), count=2)


def main() -> None:
    """Write the page; a test compares it with the one that is kept."""
    PAGE.write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
