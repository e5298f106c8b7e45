"""Ask the functions MOTION.* what Excel's own take for a number, and write what they answer into functions.md.

.venv/bin/python -m docs.functions            writes it
.venv/bin/python -m docs.functions --check    fails where a program of the version named there now says otherwise
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import ironcalc
import openpyxl
from openpyxl.workbook.defined_name import DefinedName

from docs.witnesses import settle, shown, written
from tests.functions.calc import Calc
from workbook.book.address import Address
from workbook.functions import publish
from workbook.functions.names import definitions
from workbook.reading.files import open_book
from workbook.witnesses.engines import Formulon, IronCalc, LibreOffice

PAGE = Path(__file__).with_suffix(".md")
HEAD = """\
# What the functions take

Made by `python -m docs.functions`: the functions MOTION.* are asked what docs/witnesses.md asks of every program, where
it concerns them, on a sheet with nothing in A1, the texts 0.25 and 0.75 in B1:C1, TRUE in D1, numbers 0, 0.25, 1 in
E1:E3, the text 2 in F1. The rule: a text is never a number, as in a range that SUM reads; an empty cell is 0; a law is
its code, in any case and with spaces around it, never a number or a pattern; an error is handed on; what a law does not
take is not looked at; what it takes may be left out, and is then as delivered. Empty where a program agrees: the LAMBDA
names in two programs, the add-in in LibreOffice. formulon 0.18 knows no optional parameter, and would compute no
function that has one: it is given names whose parameters are all required; what leaves one out is an error there.

"""
HELD = {"B1": "0.25", "C1": "0.75", "D1": True, "E1": 0, "E2": 0.25, "E3": 1, "F1": "2"}
ASKED: dict[str, Any] = {
    'MOTION.S("CUB",0.25)': 0.15625,
    'MOTION.S("CUB",0.25,0)': 0.15625, 'MOTION.S("CUB",25%,0)': 0.15625, 'MOTION.S("CUB","0.25",0)': "#VALUE!",
    'MOTION.S("CUB",B1,0)': "#VALUE!", 'MOTION.S("CUB","25%",0)': "#VALUE!", 'MOTION.S("CUB","",0)': "#VALUE!",
    'MOTION.S("CUB","x",0)': "#VALUE!", 'MOTION.S("CUB",A1,0)': 0, 'MOTION.S("CUB",TRUE,0)': "#NUM!",
    'MOTION.S("CUB",D1,0)': "#NUM!", 'MOTION.S("cub",0.25,0)': 0.15625, 'MOTION.S(" Cub ",0.25,0)': 0.15625,
    'MOTION.S("C?B",0.25,0)': "#VALUE!", 'MOTION.S("C*",0.25,0)': "#VALUE!", "MOTION.S(1,0.25,0)": "#VALUE!",
    "MOTION.S(1.9,0.25,0)": "#VALUE!", "MOTION.S(TRUE,0.25,0)": "#VALUE!", "MOTION.S(A1,0.25,0)": "#VALUE!",
    'MOTION.S("CUB",NA(),0)': "#N/A", "MOTION.S(1/0,0.25,0)": "#DIV/0!", 'MOTION.S("CUB",1+1E-16,0)': 1,
    'MOTION.S("CUB",0.1+0.2-0.3,0)': 0, 'MOTION.S("TVP",0.5,{"0.25","0.75"})': "#VALUE!",
    'MOTION.S("TVP",0.5,B1:C1)': "#VALUE!", 'MOTION.CV("CUB","x")': "#VALUE!", 'MOTION.CV("TVP")': 1.5,
    'MOTION.CV("OWN")': 1.875, 'MOTION.XI("ACS",0.125)': 0.25, 'SUM(MOTION.S("CUB",{0;0.25;1},0))': 1.15625,
    'SUM(MOTION.S("CUB",E1:E3,0))': 1.15625, 'MOTION.JRED("2",3)': "#VALUE!", "MOTION.JRED(F1,3)": "#VALUE!",
    "MOTION.JRED(TRUE,3)": 9, "MOTION.JRED(D1,3)": 9, "MOTION.JRED(A1,3)": 0, "MOTION.JRED(-2^2,1)": 4,
    "MOTION.RMS({3;4},{1;1})": 3.53553390593274, 'MOTION.RMS({"3";4},{1;1})': "#VALUE!",
}  # fmt: skip


def all_required(stored: str) -> str:
    """Return a definition with every parameter required, for a program that knows no optional one."""
    return re.sub(r"_xlfn\.ISOMITTED\(\w+\.\w+\)", "FALSE", stored.replace("_xlop.", "_xlpm."))


def written_to(path: Path, names: bool, told: Callable[[str], str] = str) -> Path:
    """Write a workbook that asks all, with or without the names, each as ``told`` makes it."""
    book = openpyxl.Workbook()
    sheet = book.active
    for place, value in HELD.items():
        sheet[place] = value
    for row, formula in enumerate(ASKED, 1):
        sheet.cell(row, 7, f"={formula}")
    for definition in definitions() if names else ():
        book.defined_names[definition.name] = DefinedName(definition.name, attr_text=told(definition.stored))
    book.save(path)
    return path


def by_formulon(path: Path) -> list[Any]:
    """Return what the names answer, computed by formulon."""
    held = Formulon().values(open_book(written_to(path, True, all_required)))
    return [held.get(Address("Sheet", row, 7)) for row in range(1, len(ASKED) + 1)]


def by_ironcalc(path: Path) -> list[Any]:
    """Return what the names answer, computed by IronCalc."""
    model = ironcalc.load_from_xlsx(str(written_to(path, names=True)), "en", "UTC", "en")
    model.evaluate()
    return [model.get_cell_value(0, row, 7) for row in range(1, len(ASKED) + 1)]


def by_add_in(calc: Calc) -> Callable[[Path], list[Any]]:
    """Return what the add-in answers that is installed in a LibreOffice."""

    def asked(path: Path) -> list[Any]:
        made = calc.computed(written_to(path, names=False))
        rows = openpyxl.load_workbook(made, data_only=True).active.iter_rows(min_col=7, max_col=7, values_only=True)
        return [value for (value,) in rows][: len(ASKED)]

    return asked


def answers(calc: Calc) -> dict[str, list[Any]]:
    """Return what each program says to each formula in order, by its name and version."""
    programs = {
        f"names, formulon {Formulon().version()}": by_formulon,
        f"names, IronCalc {IronCalc().version()}": by_ironcalc,
        f"add-in, LibreOffice {LibreOffice().version()}": by_add_in(calc),
    }
    with tempfile.TemporaryDirectory() as folder:
        return {name: ask(Path(folder) / "asked.xlsx") for name, ask in programs.items()}


def page(found: dict[str, list[Any]]) -> str:
    """Return the page."""
    lines = [HEAD.rstrip(), "", f"| asked | answered | {' | '.join(found)} |", "|---" * (len(found) + 2) + "|"]
    for at, (formula, expected) in enumerate(ASKED.items()):
        said = [shown(values[at], expected) for values in found.values()]
        lines.append(" | ".join([f"| `={formula}`", written(expected), *said]) + " |")
    return "\n".join([*lines, ""])


def main() -> None:
    """Write the page, or compare it with the one that is kept."""
    calc = Calc()
    try:
        with tempfile.TemporaryDirectory() as folder:
            add_in = Path(folder) / "motion.oxt"
            publish.write_add_in(add_in)
            calc.install(add_in)
        fresh = page(answers(calc))
    finally:
        calc.close()
    settle(PAGE, fresh)


if __name__ == "__main__":
    main()
