"""The cell that says a book's layout: the same whatever is entered, and told in a line where it is damaged."""

import json

import openpyxl
import pytest

from tests.workbook.edit import cell_named, enter
from workbook.book_layout import NAME, as_json, checksum, layout_text
from workbook.build import committed_descriptions, read_inputs
from workbook.errors import InputError, ReadError
from workbook.judging.verify import verify
from workbook.reading.descriptions import empty_machine, read_machine
from workbook.templates import TEMPLATES

HUGE = 10**40


def held(path):
    """The content of the cell."""
    return cell_named(openpyxl.load_workbook(path), NAME).value


def with_content(path, folder, content):
    """A copy of a book whose cell holds something else."""
    return enter(path, folder / "changed.xlsx", {NAME: content})


def signed(layout):
    """A layout as motionbook writes it."""
    return as_json(layout | {"checksum": checksum(layout)})


@pytest.fixture
def layout(press):
    layout = json.loads(held(press.path))
    del layout["checksum"]
    return layout


@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
@pytest.mark.sample(4)
def test_a_layout_is_the_same_whatever_is_entered_and_nothing_of_that_is_in_it(path):
    machine = read_machine(path)
    template = TEMPLATES[machine.template]
    text = template.declare(machine).blocks[NAME].quantities[0].value
    empty = empty_machine(template, {k: v for k, v in json.loads(text).items() if k not in ("checksum", "inputs")})
    assert layout_text(empty, template.declare_complete(empty)) == text
    assert {block.name for block in template.declare_complete(empty).blocks.values()} == {
        *template.declare(machine).blocks
    }
    assert machine.title not in text
    for variation in template.variants(machine)[:2]:
        assert layout_text(variation, template.declare_complete(variation)) == text


@pytest.mark.parametrize(
    "content",
    [None, 7, True, "machine", "{", "[]", "{}", "null", "[" * 5000, '{"sizes":{"cycle":1e999}}', "9" * 5000],
    ids=lambda content: repr(content)[:9],
)
def test_a_layout_that_is_damaged_is_told_with_its_cell_and_what_to_do(content, press, tmp_path):
    with pytest.raises(ReadError, match=r"Summary!\w+: .*expected what the tables of this book are; undo"):
        verify(with_content(press.path, tmp_path, content))


@pytest.mark.parametrize(("old", "new"), [('"cycle":12', '"cycle":13'), ('"feed', '"ram'), ("}", " }"), ("1", "2")])
def test_a_layout_that_was_edited_is_told(old, new, press, tmp_path):
    text = held(press.path)
    edited = text.replace(old, new, 1)
    if json.loads(edited) == json.loads(text):  # blanks mean nothing
        assert verify(with_content(press.path, tmp_path, text)).findings == []
        return
    with pytest.raises(ReadError, match="not as motionbook wrote it"):
        verify(with_content(press.path, tmp_path, edited))


@pytest.mark.parametrize(
    "change",
    [
        {"sizes": {"cycle": HUGE}}, {"sizes": {"phases": 61}}, {"sizes": {"phases": -1}}, {"sizes": {"cycle": 1e300}},
        {"sizes": None}, {"sizes": []}, {"laws": {"XYZ9": {"family": "XYZ"}}},
        {"laws": None}, {"laws": {"A": 1}}, {"laws": []}, {"unknown": 1}, {"drive": 3}, {"drive": [{}] * 1000},
        {"title": HUGE}, {"template": None}, {"template": "flying-cutter"},
    ],
    ids=lambda change: repr(change)[:40],
)  # fmt: skip
def test_a_layout_that_no_book_has_is_told_with_its_cell(change, layout, press, tmp_path):
    with pytest.raises(ReadError, match=r"Summary!\w+: .*undo the change, or take that cell from a copy of the book"):
        verify(with_content(press.path, tmp_path, signed(layout | change)))


def test_the_layout_of_another_book_of_the_template_is_told(layout, press, tmp_path):
    """With more rows than the tables have."""
    larger = layout | {"sizes": layout["sizes"] | {"phases": layout["sizes"]["phases"] + 3}}
    with pytest.raises(InputError, match="3 rows are gone above row"):
        verify(with_content(press.path, tmp_path, signed(larger)))


@pytest.mark.parametrize("count", [None, 1, HUGE, "many"])
def test_a_book_with_other_entries_than_the_template_has_is_told(count, layout, press, tmp_path):
    """So an entry that makes cells, and is not marked so, is never left behind in silence."""
    with pytest.raises(ReadError, match=r"entries, where its template has \d+; expected a book of this version"):
        read_inputs(with_content(press.path, tmp_path, signed(layout | {"inputs": count})))


def test_a_book_without_the_cells_name_is_refused_with_what_to_do(press, tmp_path):
    workbook = openpyxl.load_workbook(press.path)
    del workbook.defined_names[NAME]
    workbook.save(tmp_path / "nameless.xlsx")
    with pytest.raises(ReadError, match=rf"no cell named {NAME}.*undo the change"):
        read_inputs(tmp_path / "nameless.xlsx")
