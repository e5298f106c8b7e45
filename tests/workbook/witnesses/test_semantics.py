"""What Excel documents, asked of each witness: docs/witnesses.md says where one differs, and is up to date."""

from docs.witnesses import ASKED, PAGE, answers, columns, differences, page, shown


def test_the_page_is_up_to_date():
    fresh = page(answers())
    kept = PAGE.read_text(encoding="utf-8")
    assert differences(kept, fresh) == []
    assert set(columns(kept)) & set(columns(fresh)) >= {"asked", "Excel"}
    assert len(columns(fresh)) > 4
    assert len(columns(fresh)["asked"]) == sum(map(len, ASKED.values()))


def test_an_answer_that_changes_is_noticed():
    kept = PAGE.read_text(encoding="utf-8")
    by_pycel = next(head for head in columns(kept) if "pycel" in head)
    assert differences(kept, kept.replace("| #VALUE! | TRUE |", "| #VALUE! |  |")) == [by_pycel]
    assert differences(kept, kept.replace("`=-2^2`", "`=-2^3`")) == ["asked"]


def test_an_answer_is_shown_where_it_differs_also_in_type():
    assert [shown(1.0, 1), shown(True, True), shown("a", "a")] == ["", "", ""]
    assert [shown(True, 1), shown("1", 1), shown(None, 0), shown(2, 1)] == ["TRUE", '"1"', "nothing", "2"]
    assert shown("#NUM!", "#VALUE!") == "#NUM!"
