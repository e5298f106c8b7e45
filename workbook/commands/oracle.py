"""Compare two workbooks or descriptions; verify any workbook against declarations in Python, and draft these."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from openpyxl import load_workbook
from openpyxl.styles import PatternFill

from workbook.differences.design import compare, read_design
from workbook.errors import AGREES, DISAGREES, UNREADABLE, InputError, WriteError
from workbook.judging.verify import available_witnesses
from workbook.oracle.declarations import load_oracle
from workbook.oracle.draft import draft
from workbook.oracle.findings import OracleReport, describe
from workbook.oracle.judge import Judge
from workbook.oracle.sheet import oracle_of_sheet, write_sheet
from workbook.reading.files import SUFFIXES, BookFile, open_book
from workbook.reports import differences as difference_reports
from workbook.reports import page
from workbook.reports.page import figure
from workbook.reports.terminal import ERR, OUT, print_or_write, say, say_json, show_table, shown
from workbook.witnesses.calibration import FIRST, NAMES, present
from workbook.witnesses.registry import WITNESSES as REGISTER
from workbook.writing.output_files import refuse_existing, refuse_itself, refuse_suffix, replace

COLOURS = {"compared": "C6E9C9", "step": "FFF2B3", "unaccounted": "F4B8B0"}


def diff(old: Path, new: Path, as_json: bool, html: Path | None, force: bool, everything: bool = False) -> int:
    """Tell what differs between two books or descriptions; return the exit code."""
    page.require_writable(html, (".html",), force)
    with ERR.status(shown(f"Comparing {old} and {new} …")):
        before, after = read_design(old), read_design(new)
    if before.machine.template != after.machine.template:
        kinds = f"{old} is of the template {before.machine.template}, {new} of {after.machine.template}"
        raise InputError([f"{kinds}; expected two of one template"])
    differences = compare(before, after)
    for design in (before, after):
        if faults := design.machine.design.faults:
            say(ERR, f"{design.path}: unfinished ({faults[0].message}): results and checks are not compared", "yellow")
    page.write(html, lambda: difference_reports.page(before, after, differences), force)
    if as_json:
        say_json(difference_reports.data(differences))
    elif differences.same:
        say(OUT, "The same machine")
    else:
        difference_reports.show(OUT, differences, everything)
    return AGREES if differences.same else DISAGREES


def against(
    path: Path,
    declarations: Path,
    number: int,
    cover: float | None,
    marked: Path | None,
    as_json: bool,
    force: bool,
    witnesses: Sequence[str] | None = None,
) -> int:
    """Compare a workbook with its oracle, print what came of it; return the exit code."""
    refuse_itself(marked, path)
    refuse_existing(marked, force)
    with ERR.status(shown(f"Comparing {path} with {declarations} …")):
        file = open_book(path)
        asked = witnesses or present(NAMES)
        names = [name for name in available_witnesses(asked)[0] if not REGISTER[name]().kept]
        oracle = (oracle_of_sheet if declarations.suffix.lower() in SUFFIXES else load_oracle)(declarations)
        report = Judge(file, oracle).judge(number, witnesses=list(dict.fromkeys((FIRST, *names))))
    # a copy in which the formula cells of each class have a colour of their own
    if marked is not None:
        copy = load_workbook(path)
        for cell, kind in report.coverage.items():
            copy[cell.sheet].cell(cell.row, cell.column).fill = PatternFill("solid", fgColor=COLOURS[kind])
        replace(marked, copy.save, force)
    if as_json:
        say_json(data_of(report), default=str)
    else:
        show(file, report)
    if report.unusable:
        return UNREADABLE
    return DISAGREES if report.wrong or (cover is not None and report.covered < cover) else AGREES


def data_of(report: OracleReport) -> dict[str, Any]:
    """Return a report as JSON has it."""
    return {
        "cases": report.cases,
        "covered": report.covered,
        "findings": [fault.__dict__ | {"cell": str(fault.cell)} for fault in report.wrong],
        "warnings": [fault.__dict__ | {"cell": str(fault.cell)} for fault in report.warnings],
        "unusable": report.unusable,
        "cells": {str(cell): kind for cell, kind in report.coverage.items()},
        "states": {str(cell): state for cell, state in report.states.items()},
        "evaluators": {str(cell): name for cell, name in report.evaluators.items()},
        "dimensions": {"known": report.dimensions.known, "formulas": report.dimensions.formulas},
        "notes": report.notes,
    }


def write_draft(path: Path, output: Path | None, force: bool, proposed: bool = False) -> None:
    """Write a first file of declarations for a workbook, or a copy of it with a sheet of them.

    ``proposed`` translates its formulas.
    """
    if output is None or output.suffix.lower() not in SUFFIXES:
        print_or_write(draft(open_book(path), proposed), output, force)
        return
    if proposed:
        raise WriteError(f"{output}: proposals are functions in Python; expected FILE.py")
    refuse_itself(output, path)
    refuse_suffix(output)
    replace(output, write_sheet(open_book(path)).save, force)
    say(OUT, f"Wrote {output.absolute()}")


def show(file: BookFile, report: OracleReport) -> None:
    """Print the findings as a table, and how many formula cells are of each class."""
    if report.wrong or report.warnings:
        faults = (*report.wrong, *report.warnings)
        rows = [(describe(file, x.cell), x.kind, figure(x.found, 9), figure(x.expected, 9), x.at) for x in faults]
        show_table(OUT, ("cell", "kind", "found", "expected", "at"), rows, box=None, pad_edge=False)
    counts = f"{report.count('compared')} compared, {report.count('step')} steps to them"
    counts += f", {report.count('unaccounted')} unaccounted"
    say(OUT, f"{report.cases} cases, {len(report.coverage)} formula cells: {counts}; {report.covered:.1f} % covered")
    known = f"{report.dimensions.known} of {report.dimensions.formulas} formula cells"
    say(OUT, f"Dimensions: {known} known from the units")
    for note in report.notes:
        say(OUT, note)
    count = f"{len(report.wrong)} {'finding' if len(report.wrong) == 1 else 'findings'}"
    if report.warnings:
        count += f", {len(report.warnings)} disputed"
    for line in report.unusable:
        say(ERR, line, "red")
    cannot = sum(state == "cannot" for state in report.states.values())
    left = f"; {cannot} of {len(report.states)} could not be computed" if cannot else ""
    sound = f"Every compared cell is what the declarations give{left}"
    say(OUT, count + left if report.wrong or report.warnings or report.unusable else sound)
