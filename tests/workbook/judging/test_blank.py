"""Rows that are not used show nothing, by a declared rule; another rule that hides figures is found."""

import pytest
from openpyxl.formatting.formatting import ConditionalFormattingList
from openpyxl.formatting.rule import Rule
from openpyxl.styles.differential import DifferentialStyle
from openpyxl.styles.numbers import NumberFormat

TABLE = "axis1"


@pytest.fixture
def opened(press):
    return press.opened()


def said(press, opened):
    """What is said of how a changed book looks: findings, and notices."""
    path = press.path.with_name("changed.xlsx")
    opened.save(path)
    return press.seen(path)


def hiding(formula):
    return Rule(type="expression", formula=[formula], dxf=DifferentialStyle(numFmt=NumberFormat(901, ";;;")))


def without(sheet, row):
    """Take the rules of the table that begins in a row from its sheet; return their ranges and formulas."""
    kept, taken = ConditionalFormattingList(), []
    for area in sheet.conditional_formatting:
        for rule in area.rules:
            first = min((r.min_row, r.min_col) for r in area.sqref.ranges)
            if rule.type == "expression" and first == (row, 2):  # messages on the entries stand to their right
                taken.append((str(area.sqref), rule.formula[0]))
            else:
                kept.add(str(area.sqref), rule)
    sheet.conditional_formatting = kept
    return taken


def changed(press, opened, formula):
    """Give the phases a rule of another formula, by the declared one; return the sheet and its first row."""
    row = press.declared.blocks[TABLE].row
    sheet = opened["Timing"]
    (cells, old), = without(sheet, row)  # fmt: skip
    sheet.conditional_formatting.add(cells, hiding(formula(old, row)))
    return said(press, opened)


def test_a_rule_that_is_gone_is_a_notice(press, opened):
    without(opened["Timing"], press.declared.blocks[TABLE].row)
    report = said(press, opened)
    assert report.findings == []
    assert [n.expected for n in report.notices] == ["another number yes, numFmt formatCode ;;;, type expression"]


@pytest.mark.parametrize(
    "formula",
    [
        lambda old, row: "TRUE",
        lambda old, row: old.replace('=""', '<>""'),
        lambda old, row: old.replace("AND", "OR"),
        lambda old, row: old.replace(str(row), str(row + 1)),
        lambda old, row: f"$K{row}>1",
    ],
)
def test_a_changed_rule_is_found_with_the_cells_that_it_may_hide(formula, press, opened):
    report = changed(press, opened, formula)
    places = {p.address.a1 for p in press.pairs(lambda p: p.cell.block.name == TABLE)}
    assert {f.kind for f in report.findings} == {"shown"}
    assert {f.cell for f in report.findings} <= places
    assert len(report.notices) == 1


def test_the_declared_condition_hides_no_input_and_no_other_table(press, opened):
    row, sheet = press.declared.blocks[TABLE].row, opened["Timing"]
    (cells, old), = without(sheet, row)  # fmt: skip
    sheet.conditional_formatting.add(f"{cells} C{row}:C{row + 3}", hiding(old))
    found = said(press, opened).findings
    assert found
    assert {f.cell for f in found} <= {f"C{row + n}" for n in range(4)}
