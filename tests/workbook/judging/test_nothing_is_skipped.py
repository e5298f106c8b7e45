"""Each declared formula cell is counted once for every witness, and what the file was saved with is compared."""

import json

import openpyxl
import pytest

from tests.workbook.judging.hands import WORKBOOK, repacked, spot, sub
from workbook.errors import InputError, MotionbookError, WitnessError
from workbook.judging.structure import holds_declared
from workbook.judging.verify import available_witnesses, verify
from workbook.reading.entries import Entries
from workbook.reading.files import open_book
from workbook.witnesses import engines
from workbook.witnesses.agreement import agreed_values
from workbook.witnesses.registry import ALL, WITNESSES


def sums(report):
    """Whether what each witness was asked about sums to what is declared."""
    answered = [w for w in report.witnesses if w.answered]
    assert answered
    assert all(w.compared + w.at_fault + w.unfinished == report.declared for w in answered)
    return report


def found(report, address):
    return [f.kind for f in report.findings if f"{f.sheet}!{f.cell}" == spot(address)]


def as_text(cell):
    cell.data_type = "s"


def test_a_formula_stored_as_its_own_text_is_at_fault(press, tmp_path):
    pair = press.a_number()
    opened = press.opened()
    as_text(opened[pair.address.sheet][pair.address.a1])
    opened.save(tmp_path / "b.xlsx")
    report = sums(verify(tmp_path / "b.xlsx"))
    assert found(report, pair.address)[0] == "replaced"
    assert report.findings[0].computed == f'"{pair.held}"'
    assert report.witnesses[0].at_fault >= 1


@pytest.mark.parametrize(
    "cell",
    [
        b'<c r="%s" t="inlineStr"><is><t>=1+1</t></is></c>',
        b'<c r="%s" t="str"><v>=1+1</v></c>',
        b'<c r="%s" t="inlineStr"><is><r><t>=1</t></r><r><t>+1</t></r></is></c>',
    ],
)
def test_a_text_of_any_kind_is_no_formula(cell, press, tmp_path):
    pair = press.a_number()
    path = press.changed(tmp_path / "b.xlsx", pair.address, rb".+", cell % pair.address.a1.encode())
    report = sums(verify(path))
    assert found(report, pair.address)[0] == "replaced"
    assert report.findings[0].computed == '"=1+1"'


def test_an_input_that_is_a_text_of_a_formula_is_refused(press, tmp_path):
    opened = press.opened()
    place = press.place("timing_rate")
    opened[place.sheet][place.a1] = "=60/0.4"
    as_text(opened[place.sheet][place.a1])
    opened.save(tmp_path / "b.xlsx")
    with pytest.raises(InputError, match="expected a number"):
        verify(tmp_path / "b.xlsx")


@pytest.mark.parametrize(
    ("held", "content", "equal"),
    [
        (1, 1.0, True), (True, 1, False), (1, True, False), ("5", 5, False), (5, "5", False), (None, 0, False),
        (True, True, True), ("OK", "OK", True), (0.333333333333333, 1 / 3, True), (0.33333333333, 1 / 3, False),
        ("", None, False), (None, None, True),
    ],
)  # fmt: skip
def test_types_count_in_constants(held, content, equal):
    assert holds_declared(held, content) == equal


@pytest.mark.parametrize("value", [b't="b"><v>1<', b't="str"><v>%s<', b't="e"><v>#N/A<'])
def test_a_saved_value_of_another_type_is_stale(value, press, tmp_path):
    pair = next(p for p in press.pairs(lambda p: p.declared_formula) if p.cell.expected == 1)
    new = value % b"1" if b"%s" in value else value
    path = press.changed(tmp_path / "b.xlsx", pair.address, rb"(?: t=\"n\")?><f>(.*?)</f><v ?>.*?<",
                           rb' %s><f>\1</f>%s' % (new.partition(b">")[0], new.partition(b">")[2]))  # fmt: skip
    report = sums(verify(path))
    assert found(report, pair.address) == ["saved"]
    assert report.witnesses[0].at_fault == 0
    assert report.witnesses[1].at_fault == 1


# saved values


def test_a_stale_saved_value_is_a_finding_of_its_own(press, tmp_path):
    pair = press.a_number()
    path = press.changed(
        tmp_path / "b.xlsx", pair.address, rb"<v ?>.*?</v>", b"<v>%a</v>" % (1.25 * pair.cell.expected)
    )
    report = sums(verify(path))
    assert [f.kind for f in report.findings] == ["saved"]
    assert found(report, pair.address) == ["saved"]
    assert report.findings[0].computed == pytest.approx(1.25 * pair.cell.expected)


def test_a_value_that_was_not_saved_is_stale_where_others_were(press, tmp_path):
    pair = press.a_number()
    path = press.changed(tmp_path / "b.xlsx", pair.address, rb"<v ?>.*?</v>", b"")
    assert found(verify(path), pair.address) == ["saved"]


def test_a_wrong_formula_saved_with_what_it_computes_is_found_once(press, tmp_path):
    pair = press.a_number()
    path = press.changed(tmp_path / "b.xlsx", pair.address, rb"<f>(.*?)</f><v ?>.*?</v>",
                           rb"<f>1.25*(\1)</f><v>%a</v>" % (1.25 * pair.cell.expected))  # fmt: skip
    report = sums(verify(path))
    assert found(report, pair.address) == ["formula", "value"]
    assert {f.kind for f in report.findings} <= {"formula", "value", "follows"}
    assert report.witnesses[0].at_fault == report.witnesses[1].at_fault + sum(
        f.kind == "follows" for f in report.findings
    )


def test_what_follows_from_a_number_typed_over_a_formula_is_gathered(press, tmp_path):
    """By every witness; and one that is wrong where none was is at fault by itself."""
    opened = press.opened()
    cell = press.place("omega")
    opened[cell.sheet][cell.a1].value = 5.0
    opened.save(tmp_path / "b.xlsx")
    report = sums(verify(tmp_path / "b.xlsx", ["pycel", "formulon"]))
    assert [(f.kind, f.cell) for f in report.causes] == [("replaced", cell.a1)]
    assert len(report.findings) > 20
    assert report.findings_words.startswith("1 finding; ")


def test_a_new_book_says_that_its_saved_values_are_no_evidence(press, tmp_path):
    assert "no evidence" in verify(press.path).witness
    opened = press.opened()
    opened.save(tmp_path / "b.xlsx")
    report = verify(tmp_path / "b.xlsx")
    assert report.findings == []
    assert "saved" not in report.witness
    assert any("no saved values" in w.why for w in report.witnesses)


def test_saved_values_alone_are_held_against_the_engine(press, monkeypatch):
    """No witness has computed anything that they could be stale against; some are empty, some another number."""
    file, others = open_book(press.path), (None, 7.25)
    file.saved |= {at: others[k % 2] for k, at in enumerate(file.saved)}
    monkeypatch.setattr("workbook.judging.verify.open_book", lambda path: file)
    stale = [finding for finding in verify(press.path, ["saved"]).findings if finding.kind == "saved"]
    assert {finding.computed for finding in stale} == {*others}


def test_saved_numbers_that_are_shown_as_dates_are_numbers(press, tmp_path):
    opened = press.opened()
    for pair in press.pairs(lambda p: isinstance(p.held, int | float) or p.declared_formula):
        opened[pair.address.sheet][pair.address.a1].number_format = "yyyy-mm-dd hh:mm"
    opened.save(tmp_path / "b.xlsx")
    report = verify(tmp_path / "b.xlsx", ["pycel", "formulon"])
    assert {found.kind for found in report.findings} == {"shown"}  # no value is wrong
    entered = Entries(open_book(tmp_path / "b.xlsx"), agreed_values).machine()
    assert entered == press.machine


# how the program computes


@pytest.mark.parametrize(
    ("attribute", "says"),
    [('calcMode="manual"', "manual"), ('iterate="1"', "iterative"), ('fullPrecision="0"', "precision as displayed")],
)
def test_settings_that_show_other_values_are_found(attribute, says, press, tmp_path):
    path = repacked(press.path, tmp_path / "b.xlsx",
                    {WORKBOOK: sub(rb"<calcPr ", f"<calcPr {attribute} ".encode())})  # fmt: skip
    report = verify(path)
    assert [f.kind for f in report.findings] == ["setting"]
    assert says in report.findings[0].computed


def test_the_rules_of_lotus_are_found(press, tmp_path):
    change = {press.part("Drive MC01"): sub(rb"<sheetPr>", b'<sheetPr transitionEvaluation="1">')}
    report = verify(repacked(press.path, tmp_path / "b.xlsx", change))
    assert [(f.sheet, f.kind) for f in report.findings] == [("Drive MC01", "setting")]


# who is asked


def test_all_asks_the_present_and_names_the_absent(press, monkeypatch):
    monkeypatch.setattr(engines, "libreoffice_path", lambda: None)
    report = sums(verify(press.path, ["all"]))
    assert report.findings == []
    assert [w.name for w in report.witnesses if w.absent] == ["libreoffice"]
    assert {w.name for w in report.witnesses} == set(WITNESSES)


def test_one_asked_by_name_and_absent_is_refused(press, monkeypatch):
    monkeypatch.setattr(engines, "libreoffice_path", lambda: None)
    with pytest.raises(WitnessError, match="libreoffice is not on this machine"):
        verify(press.path, ["pycel", "libreoffice"])
    with pytest.raises(WitnessError):
        available_witnesses(["all", "libreoffice"])
    with pytest.raises(MotionbookError, match=f"expected {', '.join(WITNESSES)}, {ALL}"):
        verify(press.path, ["excel"])


def test_the_command_ends_with_2_where_a_named_witness_is_absent(press, motionbook, monkeypatch):
    monkeypatch.setattr(engines, "libreoffice_path", lambda: None)
    code, _, said = motionbook("verify", press.path, "--with", "libreoffice")
    assert (code, said.count("\n")) == (2, 1)
    code, said, _ = motionbook("verify", press.path, "--with", "all", "--json")
    assert code == 0
    assert [w["name"] for w in json.loads(said)["witnesses"] if w["absent"]] == ["libreoffice"]


# legacy array formulas


def test_an_array_formula_of_one_cell_is_compared_by_its_text(press, tmp_path):
    pair = press.a_number()
    a1 = pair.address.a1.encode()
    path = press.changed(tmp_path / "b.xlsx", pair.address, rb"<f>", rb'<f t="array" ref="%s">' % a1)
    assert verify(path).findings == []
    path = press.changed(tmp_path / "c.xlsx", pair.address, rb"<f>(.*?)</f>",
                           rb'<f t="array" ref="%s">2*(\1)</f>' % a1)  # fmt: skip
    report = verify(path)
    assert found(report, pair.address) == ["formula", "value"]
    assert report.findings[0].computed == f"=2*({pair.held[1:]})"


def test_an_array_formula_over_several_cells_is_shown_as_its_text(press, tmp_path):
    pairs = [p for p in press.pairs(lambda p: p.declared_formula) if p.cell.block.is_table]
    first = pairs[0]
    below = next(p for p in pairs if p.address == first.address._replace(row=first.address.row + 1))
    ref = f"{first.address.a1}:{below.address.a1}".encode()
    path = press.changed(tmp_path / "b.xlsx", first.address, rb"<f>(.*?)</f>", rb'<f t="array" ref="%s">\1</f>' % ref)
    report = verify(path)
    assert report.findings[0].kind == "formula"
    shown = {str(f.computed) for f in report.findings if f.kind == "formula"}
    assert shown == {f"{{{first.held}}}"}
    assert not any(" object at " in str(f.computed) for f in report.findings)


def test_a_data_table_is_never_shown_as_an_object(press, tmp_path):
    pair = press.a_number()
    opened = press.opened()
    opened[pair.address.sheet][pair.address.a1] = openpyxl.worksheet.formula.DataTableFormula(
        ref=pair.address.a1, dt2D=False, r1="B1"
    )
    opened.save(tmp_path / "b.xlsx")
    report = verify(tmp_path / "b.xlsx")
    assert report.findings[0].computed == "{=TABLE()}"
