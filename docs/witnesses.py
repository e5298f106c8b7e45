"""Ask each witness what Excel documents, and write where one differs into witnesses.md beside this file.

.venv/bin/python -m docs.witnesses            writes it
.venv/bin/python -m docs.witnesses --check    fails where a witness of the version named there now says otherwise
"""

from __future__ import annotations

import sys
import tempfile
import tomllib
from pathlib import Path
from typing import Any

from openpyxl import Workbook
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.table import Table

from workbook.book.address import Address
from workbook.judging.comparison import TOLERANCE
from workbook.reading.files import open_book
from workbook.witnesses.registry import WITNESSES

PAGE = Path(__file__).with_suffix(".md")
DATA = Path(__file__).parents[1] / "tests/workbook/witnesses/semantics.toml"
ENTERED = {"B1": 1, "B2": 2, "B3": 3, "C1": "a", "C2": "B", "C3": "c", "D1": True, "E1": "3"}
OTHER = [["k", "x", "a b"], ["p", 1, 10], ["q", 2, 20], ["p", 3, 30]]  # a table called T on a second sheet, D
BELOW = {"E12": 1, "E13": "=1/0", "E14": 3, "F12": 1, "F13": 2, "F14": 3}  # also there; row 13 is hidden
NAMED = {"g": "9.81", "first": "Sheet!$B$1", "area": "Sheet!$B$1:$B$3", "twice": "Sheet!$B$1*2", "local": "8",
         "both": "Sheet!$B$1:$B$2,Sheet!$B$3", "area_sum": "SUM(Sheet!$B$1:$B$3)"}  # fmt: skip
HEAD = """\
# Where the witnesses differ

## Excel's own values

The tests of [IronCalc](https://github.com/ironcalc/IronCalc) (folder xlsx/tests at 0d797798) are 242 workbooks. 227
have formulas and name Excel as the program that computed and saved them; 8 have no formula, 7 other programs saved. Of
72,006 formula cells 1,019 change by themselves, with TODAY or RAND: all 12 of cf_tests.xlsx. For the 70,987 others, an
evaluator alone, and all of them together as `verify --against` asks them where each saved value is declared, give this:

| evaluator | as Excel | otherwise or not at all | remark |
|---|---|---|---|
| pycel 1.0b30 | 25.7 % | 52,761 | most of it functions that it lacks |
| libreoffice 7.4.7.2 | 92.0 % | 5,684 | functions that it lacks, dynamic arrays, FLOOR |
| ironcalc 0.9.1 | 99.7 % | 201 | 74 in a file that it did not end within 90 s |
| formulon 0.18.0 | 99.8 % | 111 | |
| all together | 99.98 % | 12 | none differs, none is stale, 12 cannot be judged |

The 12, Excel computes unlike its documentation, or by what the file does not have: TAN, COT, CSC and SEC beside a pole,
where it loses digits (8 cells), VALUE of a date without year, which is that of the day it was saved (2), LOWER of the
text `#DIV/0!`, and a link whose file was gone already. By night
[test_excels_values.py](../tests/foreign/test_excels_values.py) judges them all where `MOTIONBOOK_FOREIGN` names a
folder with them.

## Excel's documentation

Made by `python -m docs.witnesses`: each witness is asked what Microsoft documents for Excel (for roots of negative
numbers, of which it says nothing: what formulon's makers measured), on a sheet with nothing in A1, the numbers 1, 2, 3
in B1:B3, the texts a, B, c in C1:C3, TRUE in D1 and the text 3 in E1, beside a sheet D with a table T, a hidden row and
an error. Each question with its source is in [semantics.toml](../tests/workbook/witnesses/semantics.toml). The tables
below are empty where a witness agrees. Where pycel differs, no formula of ours may lean on what is asked; in a workbook
of yours, that cell is judged by those that agree ([any-workbook.md](any-workbook.md)).

"""
KINDS = tomllib.loads(DATA.read_text(encoding="utf-8"))["kind"]
ASKED: dict[str, dict[str, Any]] = {kind["name"]: kind["asked"] for kind in KINDS}
COLUMN = 7  # of the formulas


def asked_book() -> Workbook:
    """Return the workbook that asks every formula, one below the other."""
    book = Workbook()
    sheet, other = book.active, book.create_sheet("D")
    for place, value in ENTERED.items():
        sheet[place] = value
    for row in OTHER:
        other.append(row)
    for place, value in BELOW.items():
        other[place] = value
    other.row_dimensions[13].hidden = True
    other.add_table(Table(displayName="T", ref="A1:C4"))
    for name, text in NAMED.items():
        book.defined_names[name] = DefinedName(name, attr_text=text)
    sheet.defined_names["local"] = DefinedName("local", attr_text="7")
    for row, formula in enumerate((formula for asked in ASKED.values() for formula in asked), 1):
        sheet.cell(row, COLUMN, f"={formula}")
    return book


def answers() -> dict[str, list[Any]]:
    """Return what each witness on this machine says to each formula in order, by its name and version."""
    places = [Address("Sheet", row, COLUMN) for row in range(1, sum(map(len, ASKED.values())) + 1)]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "asked.xlsx"
        asked_book().save(path)
        found = {}
        for witness in (make() for make in WITNESSES.values()):
            if not witness.kept and (version := witness.version()):
                values = witness.values(open_book(path))
                found[f"{witness.name} {version}"] = [values.get(place) for place in places]
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
    """Return the page: how many answers of each kind agree, and the answers that do not."""
    heads, rule = " | ".join(found), "|---" * (len(found) + 2) + "|"
    counts, lines, at = [f"| kind | asked | {heads} |", rule], [""], 0
    for title, asked in ASKED.items():
        told = {name: [*map(shown, values[at:], asked.values())] for name, values in found.items()}
        at += len(asked)
        counts.append(f"| {title} | {len(asked)} | {' | '.join(str(said.count('')) for said in told.values())} |")
        rows = [*zip(asked.items(), *told.values(), strict=True)]
        lines += [f"## {title}", "", f"| formula | Excel | {heads} |", rule]
        lines += [" | ".join([f"| `={f}`", written(value), *said]) + " |" for (f, value), *said in rows if any(said)]
        lines.append("")
    total = [sum(not shown(*pair) for pair in zip(v, every(ASKED), strict=True)) for v in found.values()]
    counts.append(f"| all | {at} | {' | '.join(map(str, total))} |")
    return "\n".join([HEAD.rstrip(), "", "How many answers are Excel's:", "", *counts, *lines])


def every(asked: dict[str, dict[str, Any]]) -> list[Any]:
    """Return what is expected of all formulas, in order."""
    return [value for kind in asked.values() for value in kind.values()]


def columns(text: str) -> dict[str, list[str]]:
    """Return the columns of a page's tables, by heading; what is asked and expected are two of them."""
    found: dict[str, list[str]] = {}
    heads: list[str] = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" |")] if line.startswith("| ") else []
        if cells and cells[0] in ("asked", "formula", "kind"):
            heads = cells
        elif cells and heads:
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
