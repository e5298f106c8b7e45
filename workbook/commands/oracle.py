"""Verify a workbook that motionbook did not build against declarations in Python; write a first file of them."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from openpyxl import load_workbook
from openpyxl.styles import PatternFill

from workbook.build import write_text
from workbook.errors import AGREES, DISAGREES
from workbook.judging.verify import present
from workbook.oracle.cells import draft
from workbook.oracle.declared import load
from workbook.oracle.judge import FIRST, Judge, Judged, describe
from workbook.reading.files import BookFile, open_book
from workbook.reports.page import figure
from workbook.reports.terminal import ERR, OUT, say, say_data, say_json, show_table, shown
from workbook.witnesses.registry import WITNESSES as REGISTER
from workbook.writing.place import refuse_existing, refuse_itself, replace

WITNESSES = (FIRST, "formualizer")  # the evaluators asked by default
COLOURS = {"compared": "C6E9C9", "step": "FFF2B3", "unaccounted": "F4B8B0"}


def against(
    path: Path, declarations: Path, number: int, cover: float | None, marked: Path | None, as_json: bool, force: bool,
    witnesses: Sequence[str] = WITNESSES,
) -> int:  # fmt: skip
    """Compare a workbook with its oracle, print what came of it; return the exit code."""
    refuse_itself(marked, path)
    if marked is not None:
        refuse_existing(marked, force)
    with ERR.status(shown(f"Comparing {path} with {declarations} …")):
        file = open_book(path)
        names = [name for name in present(witnesses)[0] if not REGISTER[name]().kept]
        found = Judge(file, load(declarations)).judge(number, witnesses=list(dict.fromkeys((FIRST, *names))))
    if marked is not None:
        replace(marked, lambda draft: mark(path, found, draft), force)
    if as_json:
        say_json(data(found), default=str)
    else:
        show(file, found)
    return DISAGREES if found.wrong or (cover is not None and found.covered < cover) else AGREES


def write_draft(path: Path, output: Path | None, force: bool) -> None:
    """Write a first file of declarations for a workbook."""
    text = draft(open_book(path))
    if output is None:
        say_data(text)
        return
    replace(output, lambda target: write_text(target, text), force)
    say(OUT, f"Wrote {output.absolute()}")


def data(found: Judged) -> dict[str, Any]:
    """Return what came of a comparison as JSON has it."""
    wrong = [{"cell": str(one.cell), **{k: v for k, v in one.__dict__.items() if k != "cell"}} for one in found.wrong]
    cells = {str(cell): kind for cell, kind in found.coverage.items()}
    known = {"known": found.dimensions.known, "formulas": found.dimensions.formulas}
    return {"cases": found.cases, "covered": found.covered, "findings": wrong, "cells": cells, "dimensions": known,
            "notes": found.notes}  # fmt: skip


def show(file: BookFile, found: Judged) -> None:
    """Print the findings as a table, and how many formula cells are of each class."""
    if found.wrong:
        rows = [(describe(file, one.cell), one.kind, figure(one.found, 9), figure(one.expected, 9), one.at)
                for one in found.wrong]  # fmt: skip
        show_table(OUT, ("cell", "kind", "found", "expected", "at"), rows, box=None, pad_edge=False)
    counts = f"{found.count('compared')} compared, {found.count('step')} steps to them"
    counts += f", {found.count('unaccounted')} unaccounted"
    say(OUT, f"{found.cases} cases, {len(found.coverage)} formula cells: {counts}; {found.covered:.1f} % covered")
    say(OUT, f"Dimensions: {found.dimensions.known} of {found.dimensions.formulas} formula cells known from the units")
    for note in found.notes:
        say(OUT, note)
    count = f"{len(found.wrong)} {'finding' if len(found.wrong) == 1 else 'findings'}"
    say(OUT, count if found.wrong else "Every compared cell is what the declarations give")


def mark(path: Path, found: Judged, target: Path) -> None:
    """Write a copy of the workbook in which the formula cells of each class have a colour of their own."""
    book = load_workbook(path)
    for cell, kind in found.coverage.items():
        book[cell.sheet].cell(cell.row, cell.column).fill = PatternFill("solid", fgColor=COLOURS[kind])
    book.save(target)
