"""docs/laws.md lists every family with its names, parameters and figures, as the engine has them."""

import math
from dataclasses import MISSING, fields
from fractions import Fraction
from pathlib import Path

import pytest

from engine.laws.ends import kinds
from tests.engine.families import ENTRIES

GUIDE = (Path(__file__).parents[3] / "docs" / "laws.md").read_text(encoding="utf-8")


def shown(value):
    """A default as Python writes it, a share as a fraction."""
    if isinstance(value, tuple):
        return f"({', '.join(map(shown, value))})"
    if isinstance(value, float):
        return str(Fraction(value).limit_denominator(100))
    return f'"{value}"' if isinstance(value, str) else repr(value)


def made(entry):
    """How a law is made, with its default parameters."""
    parameters = [f for f in fields(entry.law) if f.name != "ends"]
    texts = (f.name if f.default is MISSING else f"{f.name}={shown(f.default)}" for f in parameters)
    return f"{entry.law.__name__}({', '.join(texts)})"


def names(entry):
    module = entry.law.__module__.rpartition(".")[2]
    also = ", ".join(entry.law.aliases)
    return [entry.code, entry.law.name, also, f"`{made(entry)}`", f"[{module}](../engine/laws/{module}.py)"]


def figure(value):
    return "∞" if math.isinf(value) else f"{value:.6g}"


def figures(entry):
    law = entry.law()
    k = law.coefficients
    return [entry.code, *kinds(law), *map(figure, (k.cv, k.ca, k.ca_rms, k.cj, k.va))]


def row(cells):
    return f"| {' | '.join(cells)} |"


@pytest.mark.parametrize("of", [names, figures])
def test_the_guide_has_a_row_for_every_family(of):
    missing = [one for one in (row(of(entry)) for entry in ENTRIES) if one not in GUIDE.splitlines()]
    assert missing == [], "\n".join(["docs/laws.md lacks these rows:", *missing])


def test_the_guide_has_no_other_rows():
    codes = [line.split(" | ")[0].removeprefix("| ") for line in GUIDE.splitlines() if line.startswith("| ")]
    assert sorted({*codes} - {"code"} - {entry.code for entry in ENTRIES}) == [], (
        "rows of docs/laws.md of no law in CLAIMS"
    )
    assert [code for code in codes if codes.count(code) != 2] == [], "rows of docs/laws.md not of both tables"
