"""The first sheet: what it tells of a machine and of its checks, and what of a book is printed."""

import re
import subprocess
from datetime import date
from html import unescape

import openpyxl
import pytest
from openpyxl.utils import get_column_letter

from tests import cutting
from workbook.book.checks import FAILING
from workbook.book.sheet import COLUMN_WIDTH, ON_SCREEN, WIDTHS
from workbook.build import read_inputs
from workbook.reading.descriptions import make_machine, parse_toml, read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.witnesses.engines import convert
from workbook.writing.style import BEYOND

PAGES = {
    "machine": 11,
    "cutting-machine": 8,
    "motion-composer": 16,
    "flying-cutter": 10,
    "indexing-overlap": 6,
    "motion-laws": 5,
}
"""sheets of A4 at most"""
SMALLEST = 6.98  # points: 7, but for the rounding of a page's scale
HIGH = 1.22  # of the em: the box of a word in Carlito
WORD = re.compile(r'<word xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">(.*?)</word>')


def described(name, change, **more):
    """Return the committed machine of a template, its text changed, with some more entries."""
    text = (FOLDER / f"{name}.toml").read_text(encoding="utf-8")
    for old, new in change.items():
        assert old in text
        text = text.replace(old, new)
    data = parse_toml(text, FOLDER / f"{name}.toml") | more
    return make_machine(TEMPLATES[data["template"]], data, lambda key: key)


@pytest.fixture(scope="module", params=TEMPLATES)
def book(request):
    """The book of each template, as declared."""
    return TEMPLATES[request.param].declare(read_machine(FOLDER / f"{request.param}.toml"))


@pytest.fixture(scope="module")
def wrapping():
    """That of the machine to begin with."""
    return TEMPLATES["machine"].declare(read_machine(FOLDER / "machine.toml"))


def mended(book):
    """Return what the first sheet says of checks that fail."""
    (says,) = book.blocks["mend"].by_column()
    return [cell.expected for cell in says]


def test_a_book_whose_checks_hold_has_nothing_to_mend(wrapping):
    assert wrapping.sheets[0].title == "Summary"
    assert mended(wrapping) == [f"Nothing: {len(wrapping.checks)} checks OK.", *[""] * (FAILING["mend"] - 1)]


@pytest.mark.parametrize("rate", [300.0, 1000.0])
def test_the_first_checks_that_fail_stand_on_the_first_sheet(rate):
    machine = described("machine", {"rate = 200.0": f"rate = {rate}"})
    book = TEMPLATES["machine"].declare(machine)
    failing = [q.label for _, q in book.checks if q.value != "OK"]
    rows = mended(book)
    assert failing
    assert all(says.startswith(f"{what}: ") for says, what in zip(rows, failing, strict=False))
    assert rows[len(failing) :] == [""] * (FAILING["mend"] - len(failing))
    assert all("too much" in says for says in rows if "within the motor's" in says)
    listed = book.blocks["checks"]
    links = {
        text.row: (text.link, text.linked_cell) for text in listed.sheet.texts if text.link and text.row >= listed.row
    }
    assert set(links) == set(range(listed.row, listed.row + listed.size))
    blocks = [book.blocks[q.name] for _, q in book.checks]
    assert [*links.values()] == [(b.sheet.title, f"{get_column_letter(b.column)}{b.row}") for b in blocks]


def test_the_verdict_says_what_the_drives_hold_and_the_figures_why(wrapping):
    says = {
        name: wrapping.blocks[name].quantities[0].value for name in ("about_verdict", "about_reached", "about_gap_of")
    }
    assert says == {
        "about_verdict": "All 101 checks hold. "
        "The drives hold from 0 to 205 cycles/min; reached first: MC01: RMS torque.",
        "about_reached": "cycles/min, MC01: RMS torque",
        "about_gap_of": "mm, Punch over cutter",
    }
    inks = next(q.inks for q in wrapping.blocks["axes_short"].quantities if q.name == "axis")
    assert inks == ("0072B2", "D55E00", "009E73", "CC79A7")


def between(rule, value):
    """Whether a number is between the ends of a rule; texts come after all numbers."""
    low, high = map(float, rule.formula)
    return isinstance(value, float) and low <= value <= high


@pytest.mark.parametrize(("rate", "red"), [(100.0, False), (260.0, True)])
def test_a_share_of_a_limit_is_red_above_all_of_it_and_a_dash_never(rate, red, tmp_path, build_book):
    machine = described("machine", {"rate = 200.0": f"rate = {rate}"})
    book, block = TEMPLATES["machine"].declare(machine), "axes_short"
    path = build_book(machine, tmp_path / "book.xlsx")
    rules = openpyxl.load_workbook(path)["Summary"].conditional_formatting
    shares = [c for c in book.blocks[block].cells() if c.quantity.unit == "%"]
    beyond = {
        c.expected: [
            rule.dxf.font.color.rgb[-6:]
            for area in rules if f"{get_column_letter(c.column)}{c.row}" in area
            for rule in area.rules if rule.type == "cellIs" and between(rule, c.expected)
        ]
        for c in shares
    }  # fmt: skip
    assert sum(1 for _ in shares) == 20
    assert beyond["–"] == []
    assert {value: colours == [BEYOND] for value, colours in beyond.items() if value != "–"} == {
        value: value > 100 for value in beyond if value != "–"
    }
    assert any(colours for colours in beyond.values()) is red


@pytest.mark.parametrize("told", [date(2026, 11, 21), "2026-11-21", "November"])
def test_what_identifies_a_machine_goes_out_and_in(told, tmp_path, build_book):
    entries = {"number": "CM-0417", "revision": "B", "author": "A. Rossi", "date": told}
    machine = described("motion-composer", {}, **entries)
    found, notes = read_inputs(build_book(machine, tmp_path / "book.xlsx"))
    assert notes == []
    kept = {key: getattr(found, key) for key in entries}
    assert kept == entries | {"date": str(told)}


@pytest.mark.parametrize("name", PAGES)
@pytest.mark.sample(1)
def test_a_book_prints_on_few_pages_that_can_be_read(name, tmp_path, committed_book):
    pdf = convert(committed_book(FOLDER / f"{name}.toml"), "pdf", tmp_path)
    told = subprocess.run(["pdfinfo", pdf], capture_output=True, text=True, check=True).stdout
    pages = int(next(line.split()[1] for line in told.splitlines() if line.startswith("Pages:")))
    assert pages <= PAGES[name]
    text = subprocess.run(["pdftotext", "-f", "2", "-l", "2", pdf, "-"], capture_output=True, text=True, check=True)
    assert "Summary" not in text.stdout.splitlines()[-3:]  # the footer names the sheet: the summary is one page
    boxes = subprocess.run(["pdftotext", "-bbox", pdf, "-"], capture_output=True, text=True, check=True).stdout
    words = [(unescape(word), *map(float, box)) for *box, word in WORD.findall(boxes)]
    small = [word for word, *box in words if letters_of(*box, word) < SMALLEST]
    assert small == []
    assert ">##" not in boxes.split("</page>")[0]  # large figures wider than their cells; later pages clip hidden cells


def letters_of(left, top, right, bottom, word):
    """How high the letters of a word are in points, by its box: what is turned by 90° is higher than wide."""
    width, height = right - left, bottom - top
    if len(word) < 4:
        return max(width, height) / HIGH
    return (width if height > 1.4 * width else height) / HIGH


def test_the_checks_that_fail_and_the_counts_are_printed_and_all_stand_below(book):
    failing, counted, every = (book.blocks[name] for name in ("failing", "by_sheet", "checks"))
    sheet = every.sheet
    assert failing.row < counted.row < counted.row + counted.size <= sheet.print_rows < every.row
    assert sum(counted.quantities[1].value) == every.size == len(book.checks)


def test_each_sheet_has_its_own_verdict_over_the_books_at_the_right_edge_of_what_a_screen_shows(book):
    judged = {sheet.title for sheet, _ in book.checks}
    for i, sheet in enumerate(book.sheets, 1):
        whole, own = book.blocks[f"status{i}"], book.blocks.get(f"status{i}_own")
        assert (whole.row, whole.column) == (2, sheet.last_column)
        assert (own is not None) == (sheet.title in judged)
        assert own is None or (own.row, own.column) == (1, whole.column)
        width = sum((WIDTHS | sheet.widths).get(column, COLUMN_WIDTH) for column in range(1, sheet.last_column + 1))
        assert width <= ON_SCREEN


def test_the_first_page_tells_the_rate_that_the_drives_figures_hold_at():
    """A drive that is sized at a rate of its own is told so."""
    data = cutting.small(cycle=12, law=4).model_dump()
    data["axes"][0]["rate"] = 80.0
    book = TEMPLATES["machine"].declare(TEMPLATES["machine"].model.model_validate(data))
    assert book.blocks["about_rate"].quantities[0].value == 100.0
    sized = next(q for q in book.blocks["axes_short"].quantities if q.name == "sized")
    assert sized.value == [80.0, "–", "–"]


def test_the_first_page_shows_each_column_of_its_tables(book):
    sheet = book.sheets[0]
    printed = [block for block in sheet.blocks if block.row < sheet.print_rows]
    assert printed
    tables = [block for block in printed if block.lead is None]
    assert all(column <= sheet.print_columns for block in tables for column in block.columns.values())


def test_an_axis_has_its_laws_and_the_verdict_of_its_own_checks():
    """Of MC01 the drive is too weak, the others are as before."""
    changes = {
        "rate = 200.0": "rate = 210.0",
        'lift = -75.0, law = "CIC"': 'lift = -75.0, law = "mtp"',
    }
    judged = TEMPLATES["machine"].declare(described("machine", changes)).blocks["axes_judged"]
    found = {q.name: q.value for q in judged.quantities}
    assert found["verdict"] == ["FAIL", "OK", "OK", "OK"]
    assert [law.upper() for law in found["law"]] == ["MTP", "MTP", "MTP", "SEVERAL"]


def test_the_first_sheet_is_titled_by_what_is_entered(wrapping):
    (heading,) = wrapping.blocks["book_heading"].cells()
    assert (heading.row, heading.expected) == (1, "Wrapping machine")


def test_no_chart_of_a_machine_mixes_travelling_and_turning_axes(wrapping):
    labels = [text for sheet in wrapping.sheets for chart, *_ in sheet.charts for text in (chart.title, chart.y)]
    assert [label for label in labels if "[" in label and "," in label] == []
    assert {"ẏ [m/s]", "ẏ [rad/s]"} <= set(labels)
