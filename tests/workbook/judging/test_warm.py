"""A book that is saved again and again: the verdict on its values is that of ``verify``, by what was kept."""

import random

import pytest
from openpyxl import load_workbook

from tests.mutation.bench import smaller
from tests.tiers import seed
from tests.workbook.edit import cell_named
from workbook.build import build, committed_descriptions
from workbook.errors import MotionbookError
from workbook.judging.verify import verify
from workbook.judging.warm import WarmBook
from workbook.reading.descriptions import read_machine
from workbook.reading.files import open_book
from workbook.witnesses.pycel.model import Pycel, PycelModel

VALUES = {"value", "error", "follows", "saved", "formula", "replaced", "missing", "changed"}


def told(report):
    """Return what is found of values at the entries, but for what variations of these say."""
    found = (f for f in report.findings if f.kind in VALUES and "variation" not in f.witness)
    return {(f.sheet, f.cell, f.kind, str(f.computed), str(f.expected)) for f in found}


def other_rate(workbook, draw):
    cell_named(workbook, "timing_rate").value = draw.choice([33.0, 47.5, 120.0])


def other_holding(workbook, draw):
    cell_named(workbook, "drive1_holding").value = draw.choice(["motor", "brake"])


def other_motor(workbook, draw):
    cell_named(workbook, "motors").value = draw.choice(["M7", "M8 ", "a motor"])


def other_lift(workbook, draw):
    cell_named(workbook, "axis1").offset(0, 4).value = draw.choice([5.0, 0.0, 71.25])


def other_formula(workbook, draw):
    cell_named(workbook, "timing_tip").value = draw.choice(["=omega*timing_radius/1001", "=omega*timing_radius/1000"])


def number_for_a_formula(workbook, draw):
    cell_named(workbook, "timing_period").value = draw.choice([1.0, "=60/timing_rate"])


def formula_of_ones_own(workbook, draw):
    workbook["Timing"]["Z90"].value = draw.choice(["=timing_rate*2", None])


def no_rate(workbook, draw):
    cell_named(workbook, "timing_rate").value = None


EDITS = (other_rate, other_holding, other_motor, other_lift, other_formula, number_for_a_formula, formula_of_ones_own)


def test_each_of_many_saves_has_the_verdict_on_values_that_verify_has(press, tmp_path):
    draw, path, warm, judged = random.Random(8), tmp_path / "press.xlsx", WarmBook(), 0
    workbook = load_workbook(press.path)
    for edit in (*draw.sample(EDITS, k=7), no_rate, other_rate):
        edit(workbook, draw)
        workbook.save(path)
        try:
            report = warm.judge_values(path).report
        except MotionbookError:
            continue  # verify alone judges it
        whole = verify(path)
        judged += 1
        assert (told(report), report.unfinished) == (told(whole), whole.unfinished), edit.__name__
        assert warm._model.evaluate() == Pycel().model(open_book(path), warm._cells).evaluate(), edit.__name__
        assert [check.line for check in report.checks] == [check.line for check in whole.checks]
    assert judged >= 4


def test_a_save_of_another_entry_works_out_only_what_depends_on_it(press, tmp_path, monkeypatch):
    path, warm, workbook = tmp_path / "press.xlsx", WarmBook(), load_workbook(press.path)
    workbook.save(path)
    warm.judge_values(path)
    cell_named(workbook, "drive1_friction").value = 0.25
    workbook.save(path)
    worked_out = []
    of_a_step = PycelModel._result
    monkeypatch.setattr(PycelModel, "_result", lambda *step: worked_out.append(step[1]) or of_a_step(*step))
    judged = warm.judge_values(path)
    assert not judged.report.findings
    assert 0 < len(worked_out) < judged.report.declared / 2


def other_result(workbook, cell):
    cell.value = f'=IF(ISNUMBER({cell.value[1:]}),1.001*({cell.value[1:]})+1,"other")'


def typed_over(workbook, cell):
    cell.value = 12345.678


def per_cent(workbook, cell):
    cell.number_format = "0.0%"


def name_a_row_lower(workbook, cell):
    names = [name for name in workbook.defined_names.values() if name.hidden and name.attr_text.count("$") == 2]
    name = names[(cell.row * cell.column) % len(names)]
    sheet, _, place = name.attr_text.rpartition("!")
    column, row = place[1:].split("$")
    name.attr_text = f"{sheet}!${column}${int(row) + 1}"


FAULTS = (other_result, typed_over, per_cent, name_a_row_lower)


@pytest.mark.nightly
@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
def test_twenty_faults_of_every_book_are_found_and_alike_when_warm(path, tmp_path):
    draw, book, warm = random.Random(f"{path.stem} {seed('faults')}"), tmp_path / "book.xlsx", WarmBook()
    build(smaller(read_machine(path)), book)
    sound = book.read_bytes()
    for k in range(20):
        book.write_bytes(sound)
        workbook, fault = load_workbook(book), FAULTS[k % len(FAULTS)]
        cells = [cell for sheet in workbook for row in sheet.iter_rows() for cell in row if cell.data_type == "f"]
        cell = draw.choice([cell for cell in cells if isinstance(cell.value, str) and cell.number_format != "General"])
        fault(workbook, cell)
        workbook.save(book)
        try:
            whole = verify(book)
        except MotionbookError as error:
            with pytest.raises(type(error)):
                warm.judge_values(book)
            continue
        told_of = f"{fault.__name__} {cell.parent.title}!{cell.coordinate}"
        assert whole.findings, told_of
        assert told(warm.judge_values(book).report) == told(whole), told_of
