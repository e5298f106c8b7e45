"""What a user reads of a new book: texts that say the values, checks in their colours, charts of the declared data.

formulon is the oracle: it shows texts, colours and charts as Excel does.
"""

import io
import re

import openpyxl
import pytest

from tests.mutation.bench import smaller
from tests.tiers import by_day
from tests.workbook.composed import COMPOSED, DESCRIBED
from tests.workbook.writing.displayed import Displayed
from workbook.book.rows import as_rows
from workbook.judging.comparison import TOLERANCE
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.writing import archive
from workbook.writing.layout import WIDTHS
from workbook.writing.write import parts

WORDS = re.compile(r'(?:"([^"]+)"|[^;"]+)(?:;[^;]*)?(?:;(?:"([^"]+)")?)?(?:;.*)?')  # above zero, and for zero
BLANK = "0;;"  # a declared rule: zero is not shown
DECIMALS = re.compile(r"0(?:\.([0#]+))?(E\+00)?")
GENERAL = 9  # digits after the first that Excel shows of a number without a format of its own
MOST = 12  # characters in a column of the usual width; longer numbers would be shown as ####


@pytest.fixture(scope="module", params=by_day([*DESCRIBED, "indexing-overlap-stations"], COMPOSED, "indexing-overlap"))
def shown(request):
    """A small book as declared, as openpyxl reads it and as formulon shows it."""
    machine = smaller(read_machine(FOLDER / f"{request.param}.toml"))
    template = TEMPLATES[machine.template]
    book = template.declare(machine)
    content = archive.zipped(parts(book, type(machine)))
    with Displayed(content) as displayed:
        yield book, openpyxl.load_workbook(io.BytesIO(content)), displayed


def step(number_format, text):
    """Half of the last digit that a format shows."""
    if number_format == "General":
        return 0.5 * 10.0 ** (len(str(abs(int(float(text))))) - 1 - GENERAL)
    first, *others = number_format.split(";")
    pattern = first if not first.startswith("[") else first.partition("]")[2] if "E" in text else others[0]
    digits, exponent = DECIMALS.fullmatch(pattern).groups()
    return 0.5 * 10.0 ** ((int(text.partition("E")[2]) if exponent else 0) - len(digits or ""))


def says(text, value, number_format, peak):
    """Whether a text says a value, as exactly as its format allows."""
    if value is None or isinstance(value, str):
        return text == (value or "")
    above, zero = WORDS.fullmatch(number_format).groups()
    if text in (above, zero):
        return value > 0 if text == above else abs(value) <= TOLERANCE * peak
    if text == "":
        return value == 0 and number_format == BLANK
    if text.endswith("%"):
        return says(text.rstrip(" %"), 100 * value, re.sub(" ?%", "", number_format), 100 * peak)
    if not re.fullmatch(r"-?\d+(\.\d*)?(E[+-]\d+)?", text) or len(text) > MOST:
        return False
    return abs(float(text) - value) <= (1 + 1e-6) * step(number_format, text) + TOLERANCE * peak


def test_each_text_reads_back_as_its_value_to_the_shown_digits(shown):
    book, opened, displayed = shown
    wrong, count = [], 0
    for block in book.blocks.values():
        sheet, cells = block.sheet.title, list(block.cells())
        for q in block.quantities:
            column = [cell for cell in cells if cell.quantity is q]
            peak = max([q.floor, *(abs(c.expected) for c in column if isinstance(c.expected, int | float))])
            for cell in column:
                text = displayed.text(sheet, cell.row, cell.column)
                look = opened[sheet].cell(cell.row, cell.column).number_format
                count += 1
                if not says(text, cell.expected, look, peak):
                    wrong.append((block.name, q.name, cell.i, text, cell.expected, look))
    assert wrong == []
    assert count > 1500
    assert WIDTHS.get(4, MOST) >= MOST


def test_checks_have_the_colour_of_their_word(shown):
    book, _, displayed = shown
    found = {}
    for sheet, check in book.checks:
        cell = next(book.blocks[check.name].cells())
        found.setdefault(cell.expected, set()).add(tuple(displayed.coloured(sheet.title, cell.row, cell.column)))
    assert set(found) <= {"OK", "FAIL"}
    assert all(len(formats) == 1 and formats != {()} for formats in found.values())


def test_unused_rows_show_their_inputs_alone(shown):
    """Where nothing is entered in a row its cells are hidden by one rule; where something is, they are not."""
    book, _, displayed = shown
    tables = 0
    for block in book.blocks.values():
        inputs = [q for q in block.quantities if q.role == "input"]
        if not (block.blanked and inputs):
            continue
        tables += 1
        rows = list(zip(*(as_rows(q.value, block.size, q.name) for q in inputs), strict=True))
        for cell in (cell for cell in block.cells() if cell.quantity.role != "check"):
            hidden = displayed.coloured(block.sheet.title, cell.row, cell.column) != []
            unused = cell.quantity in block.blanked and all(value in (None, "") for value in rows[cell.i])
            assert hidden == unused, (block.name, cell.quantity.name, cell.i)
    assert tables > 0


def test_each_chart_shows_the_columns_that_are_declared_for_it(shown):
    book, _, displayed = shown
    charts = 0
    for sheet in book.sheets:
        for (chart, *_), seen in zip(sheet.charts, displayed.charts(sheet.title), strict=True):
            data = seen.data
            assert data.unresolved == []
            assert (data.title_text or "") == chart.title
            for line, drawn in zip(chart.series, data.series, strict=True):
                assert drawn.x == pytest.approx(book.values(line.x), rel=1e-9, abs=1e-9)
                assert drawn.values == pytest.approx(book.values(line.y), rel=1e-9, abs=1e-9)
            for limits, wanted in zip(seen.limits, (chart.x_range, chart.y_range), strict=True):
                assert limits == (wanted[:2] if wanted else (None, None))
            charts += 1
    assert charts > 15


def test_each_input_has_its_rule(shown):
    book, _, displayed = shown
    for sheet in book.sheets:
        ruled = {
            (row + 1, column + 1)
            for rule in displayed.validations(sheet.title)
            for r in rule.ranges
            for row in range(r.first_row, r.last_row + 1)
            for column in range(r.first_col, r.last_col + 1)
        }
        cells = [cell for block in sheet.blocks for cell in block.cells()]
        assert ruled == {(c.row, c.column) for c in cells if c.quantity.role == "input"}
