"""Ask each witness what Excel documents, and write where one differs into witnesses.md beside this file.

.venv/bin/python -m docs.witnesses            writes it
.venv/bin/python -m docs.witnesses --check    fails where a witness of the version named there now says otherwise
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

from openpyxl import Workbook

from workbook.book.address import Address
from workbook.judging.comparison import TOLERANCE
from workbook.reading.files import open_book
from workbook.witnesses.registry import WITNESSES

PAGE = Path(__file__).with_suffix(".md")
ENTERED = {"B1": 1, "B2": 2, "B3": 3, "C1": "a", "C2": "B", "C3": "c", "D1": True, "E1": "3"}
HEAD = """\
# Where the witnesses differ

Made by `python -m docs.witnesses`: each witness is asked what Microsoft documents for Excel (for roots of negative
numbers, of which it says nothing: what formulon's makers measured), on a sheet with nothing in A1, the numbers 1, 2, 3
in B1:B3, the texts a, B, c in C1:C3, TRUE in D1 and the text 3 in E1. Empty where it agrees. Where one differs, no
formula of ours may lean on what is asked.

"""
ASKED: dict[str, dict[str, Any]] = {
    "Operators": {
        "-2^2": 4, "0-2^2": -4, "2^-1": 0.5, "2^3^2": 64, "-20^2+900": 1300, "50%": 0.5, "200*10%": 20, "1&2": "12",
        "1/0": "#DIV/0!", "0^0": "#NUM!", "(-8)^(1/3)": -2, '"a"="A"': True, '"a"<"B"': True,
    },
    "Texts, truth values and empty cells in arithmetic": {
        '"2"+3': 5, '"2"*"3"': 6, '"x"+1': "#VALUE!", "E1+1": 4, "TRUE+1": 2, "D1+1": 2, "A1+1": 1, 'A1=""': True,
        "A1=0": True, '"1"=1': False, "TRUE=1": False, '"5"%': 0.05,
    },
    "Fifteen digits": {
        "0.1+0.2=0.3": True, "1*(0.5-0.4-0.1)=0": False, "1+1E-16=1": True, "12345678901234567890": 1.23456789012345e19,
    },
    "AND, OR, NOT, IF": {
        'AND("a",TRUE)': "#VALUE!", "AND(C1,TRUE)": True, "OR(C1:C3)": "#VALUE!", "AND(D1,1)": True, "NOT(0)": True,
        'IF("a",1,2)': "#VALUE!", "IF(A1,1,2)": 2, "IF(1,,5)": 0,
    },
    "SUM, MAX, COUNT, AVERAGE": {
        'SUM("3",4)': 7, "SUM(E1,4)": 4, "SUM(TRUE,1)": 2, "SUM(D1,1)": 1, "MAX(C1:C3)": 0, "MIN(D1,B2)": 2,
        "COUNT(B1:E1)": 1, "AVERAGE(C1:C3)": "#DIV/0!", "SUMPRODUCT(B1:B3,C1:C3)": 0, "SUMPRODUCT(B1:B3,B1:B3)": 14,
        'COUNTIF(C1:C3,"b")': 1, 'COUNTIF(B1:B3,">1")': 2, 'COUNTIF(B1:B3,"2")': 1, "COUNTIF(E1,3)": 1,
    },
    "INDEX, MATCH, CHOOSE, LARGE, SMALL": {
        "INDEX(B1:B3,2.9)": 2, "INDEX(B1:B3,4)": "#REF!", "MATCH(2.5,B1:B3,1)": 2, "MATCH(0.5,B1:B3,1)": "#N/A",
        "MATCH(2-1E-13,B1:B3,1)": 1, "MATCH(2-1E-13,B1:B3,0)": "#N/A", 'MATCH("b",C1:C3,0)': 2, 'MATCH("?",C1:C3,0)': 1,
        'MATCH("3",B1:B3,0)': "#N/A", 'CHOOSE(2.9,"a","b","c")': "b", "CHOOSE(4,1,2,3)": "#VALUE!", "LARGE(B1:B3,1)": 3,
        "SMALL(B1:B3,4)": "#NUM!",
    },
    "Rounding": {
        "ROUND(2.5,0)": 3, "ROUND(-2.5,0)": -3, "ROUND(1.005,2)": 1.01, "INT(-2.5)": -3, "MOD(-3,2)": 1,
        "ROUND(1234,-2)": 1200,
    },
    "Mathematics": {
        "POWER(-2,3)": -8, "POWER(-8,1/3)": -2, "SQRT(-1)": "#NUM!", "LN(0)": "#NUM!", "LOG10(1000)": 3,
        "ATAN2(1,2)": 1.10714871779409, "ATAN2(0,0)": "#DIV/0!", "SIGN(-0.5)": -1, 'ABS("-3")': 3,
        'ABS("x")': "#VALUE!", "EXP(710)": "#NUM!", "RADIANS(180)": 3.14159265358979, "DEGREES(PI())": 180,
        "ISNUMBER(E1)": False,
    },
}  # fmt: skip


def answers() -> dict[str, list[Any]]:
    """Return what each witness on this machine says to each formula in order, by its name and version."""
    book = Workbook()
    sheet = book.active
    for place, value in ENTERED.items():
        sheet[place] = value
    formulas = [formula for asked in ASKED.values() for formula in asked]
    places = [Address(sheet.title, row, 7) for row in range(1, len(formulas) + 1)]
    for place, formula in zip(places, formulas, strict=True):
        sheet.cell(place.row, place.column, f"={formula}")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "asked.xlsx"
        book.save(path)
        found = {}
        for witness in (make() for make in WITNESSES.values()):
            if not witness.kept and (version := witness.version()):
                values = witness.values(open_book(path))
                found[f"{witness.name} {version}"] = [values[place] for place in places]
    return found


def shown(value: Any, expected: Any) -> str:
    """Return what a witness says as the page has it: nothing where it says what is expected."""
    if isinstance(value, bool) or isinstance(expected, bool) or isinstance(value, str) or isinstance(expected, str):
        same = type(value) is type(expected) and value == expected
    else:
        same = value is not None and abs(value - expected) <= TOLERANCE * max(1.0, abs(expected))
    return "" if same else written(value)


def written(value: Any) -> str:
    """Return a value as a cell shows it, a text in quotes."""
    if isinstance(value, bool):
        return str(value).upper()
    if isinstance(value, str):
        return value if value.startswith("#") else f'"{value}"'
    return "nothing" if value is None else f"{value:.15g}"


def page(found: dict[str, list[Any]]) -> str:
    """Return the page."""
    lines, at = [HEAD.rstrip(), ""], 0
    for title, asked in ASKED.items():
        lines += [f"## {title}", "", f"| asked | Excel | {' | '.join(found)} |", "|---" * (len(found) + 2) + "|"]
        for formula, expected in asked.items():
            said = [shown(values[at], expected) for values in found.values()]
            lines.append(" | ".join([f"| `={formula}`", written(expected), *said]) + " |")
            at += 1
        lines.append("")
    return "\n".join(lines)


def columns(text: str) -> dict[str, list[str]]:
    """Return the columns of a page's tables, by heading; what is asked and expected are two of them."""
    found: dict[str, list[str]] = {}
    heads: list[str] = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" |")] if line.startswith("| ") else []
        if cells and cells[0] == "asked":
            heads = cells
        elif cells:
            for head, cell in zip(heads, cells, strict=True):
                found.setdefault(head, []).append(cell)
    return found


def differences(kept: str, fresh: str) -> list[str]:
    """Return the columns in which two pages differ; a version that one of them does not have is passed over."""
    one, other = columns(kept), columns(fresh)
    return [head for head in one if head in other and one[head] != other[head]]


def settle(kept: Path, fresh: str) -> None:
    """Write a page; with --check, compare it with the one that is kept, and exit where they differ."""
    if "--check" not in sys.argv:
        kept.write_text(fresh, encoding="utf-8")
    elif found := differences(kept.read_text(encoding="utf-8"), fresh):
        sys.exit(f"{kept.name} is not up to date: {', '.join(found)}")


def main() -> None:
    """Write the page, or compare it with the one that is kept."""
    settle(PAGE, page(answers()))


if __name__ == "__main__":
    main()
