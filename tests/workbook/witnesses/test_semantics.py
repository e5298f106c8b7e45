"""What Excel documents, asked of each witness: docs/witnesses.md says where one differs, and is up to date."""

from docs.witnesses import ASKED, KINDS, PAGE, answers, asked_book, columns, differences, every, page, shown
from workbook.oracle.declarations import Oracle
from workbook.oracle.judge import Judge
from workbook.reading.files import open_book

BEYOND = 0  # formulas that no evaluator computes as documented, or two compute otherwise


def test_the_page_is_up_to_date():
    fresh, kept = page(answers()), PAGE.read_text(encoding="utf-8")
    assert differences(kept, fresh) == []
    assert len(columns(fresh)) > 4


def test_an_answer_that_changes_is_noticed():
    kept = PAGE.read_text(encoding="utf-8")
    by_pycel = next(head for head in columns(kept) if "pycel" in head)
    assert differences(kept, kept.replace("| #VALUE! | TRUE |", "| #VALUE! |  |")) == [by_pycel]


def test_every_kind_has_a_source_and_there_are_two_hundred_questions():
    assert all(kind["source"] for kind in KINDS)
    assert len(every(ASKED)) >= 200


def test_what_is_documented_is_blamed_in_no_cell(tmp_path):
    asked_book().save(tmp_path / "b.xlsx")
    oracle = Oracle("Excel")
    for row, value in enumerate(every(ASKED), 1):
        oracle.output(f"Sheet!G{row}", tolerance=1e-12)(lambda value=value: value)
    for output in oracle.outputs:
        output.inputs = []
    report = Judge(open_book(tmp_path / "b.xlsx"), oracle).judge(1, witnesses=("pycel", "formulon", "ironcalc"))
    wrong = [fault for fault in report.wrong if fault.kind == "value"]
    assert len(wrong) <= BEYOND, wrong
    assert sum(state == "cannot" for state in report.states.values()) <= BEYOND


def test_an_answer_is_shown_where_it_differs_also_in_type():
    assert [shown(1.0, 1), shown(True, True), shown("a", "a")] == ["", "", ""]
    assert [shown(True, 1), shown("1", 1), shown(None, 0), shown(2, 1)] == ["TRUE", '"1"', "nothing", "2"]
    assert shown("#NUM!", "#VALUE!") == "#NUM!"
