"""Excel's own values: what each evaluator gives in workbooks that Excel computed, and what a declaration of them gets.

The workbooks are the tests of IronCalc (https://github.com/ironcalc/IronCalc, MIT or Apache-2.0, folder xlsx/tests at
0d797798) that have formulas and name Excel as their program; :data:`HASHES` are theirs.

MOTIONBOOK_FOREIGN=FOLDER .venv/bin/python -m tests.foreign.excels_values     prints the table of docs/witnesses.md
"""

from collections import Counter
from pathlib import Path

from tests.foreign.books import files
from workbook.audit import audit
from workbook.errors import WitnessError
from workbook.oracle.declarations import Oracle
from workbook.oracle.judge import Judge
from workbook.reading.files import open_book
from workbook.witnesses.calibration import NAMES, is_same, present
from workbook.witnesses.registry import WITNESSES

HASHES = [line.split()[0] for line in Path(__file__).with_suffix(".sha256").read_text(encoding="utf-8").splitlines()]


def books():
    """The workbooks that are on this machine."""
    return [files()[sha] for sha in HASHES if sha in files()]


def saved_in(file):
    """The cells whose value Excel saved."""
    return {cell: value for cell, value in file.saved.items() if value is not None}


def judged(path, names=NAMES):
    """The judge of a workbook whose saved values are declared, each by a function, and its report."""
    oracle = Oracle("Excel")
    for cell, value in saved_in(file := open_book(path)).items():
        sheet = cell.sheet.replace("'", "''")
        oracle.output(f"'{sheet}'!{cell.a1}", inputs=[])(lambda value=value: value)
    judge = Judge(file, oracle)
    return judge, judge.judge(1, witnesses=present(names))


def count(path):
    """Count of a workbook the cells by the state that they get, but for those that change by themselves; and alarms."""
    judge, report = judged(path)
    states = Counter(state for cell, state in report.states.items() if cell not in judge.evaluators.clock)
    states["alarms"] = sum(finding.rule == "stale" for finding in audit(judge.file).findings)
    return states


def right_by(name, path):
    """How many of the values that Excel saved an evaluator gives; and how many there are."""
    file = open_book(path)
    try:
        values = WITNESSES[name]().values(file)
    except WitnessError:
        values = {}
    saved = saved_in(file)
    return sum(is_same(values.get(cell), value) for cell, value in saved.items()), len(saved)


def main():
    for name in present(NAMES):
        right, every = map(sum, zip(*(right_by(name, path) for path in books()), strict=True))
        print(f"| {name} | {100 * right / every:.2f} % | {every - right:,} |")
    print(sum(map(count, books()), Counter()))


if __name__ == "__main__":
    main()
