"""Faults as people make them, put into a workbook one at a time; each gives the cells at which it may be named."""

import re
from itertools import count
from random import Random

from openpyxl.formula.translate import Translator

from tests.workbook.audit.books import write_book

REFERENCE = re.compile(r"(?<![\w!'$])(\$?)([A-Z]{1,2})(\$?)(\d+)(?![\d(])")
ABSOLUTE = re.compile(r"\$([A-Z]+)\$(\d+)")
MOVING = re.compile(r"(?<![\w!'$])(\$?)([A-Z]{1,2})(\d+)(?![\d(])")
RANGE = re.compile(r"(\$?[A-Z]{1,2}\$?)(\d+):(\$?[A-Z]{1,2}\$?)(\d+)")
LITERAL = re.compile(r"(?<![\w$.:])(\d+\.?\d*)(?![\w.:(])")


def formulas(book, wanted=lambda text: True):
    return [c for sheet in book for row in sheet.iter_rows() for c in row if c.data_type == "f" and wanted(c.value)]


def numbers(book):
    return [c for sheet in book for row in sheet.iter_rows() for c in row if c.data_type == "n" and c.value is not None]


def name(cell):
    return cell.parent.title, cell.coordinate


def copied(cell, other):
    return Translator(cell.value, cell.coordinate).translate_formula(other.coordinate)


def run_of(cell):
    """The cells of a column that have the formula of a cell, copied."""
    sheet, cells = cell.parent, [cell]
    for step in (1, -1):
        row = cell.row + step
        while row > 0:
            other = sheet.cell(row, cell.column)
            if other.data_type != "f" or copied(cell, other) != other.value:
                break
            cells.append(other)
            row += step
    return sorted(cells, key=lambda c: c.row)


def runs(book, wanted):
    every = {tuple(map(name, run)): run for cell in formulas(book, wanted) if len(run := run_of(cell)) > 3}
    return list(every.values())


def read_by(book, cell):
    """The formulas of the same sheet that read a cell by itself."""
    pattern = re.compile(rf"(?<![\w!:$])\$?{cell.column_letter}\$?{cell.row}(?![\d:])")
    return [c for c in formulas(book) if c.parent is cell.parent and pattern.search(c.value)]


def replaced(cell, match, text):
    cell.value = cell.value[: match.start()] + text + cell.value[match.end() :]
    return {name(cell)}


def one(random, cell, pattern, change):
    """Change a match of a pattern in a formula."""
    match = random.choice(list(pattern.finditer(cell.value)))
    return replaced(cell, match, change(match))


def typed_over(book, random):
    cell = random.choice(formulas(book))
    cell.value = round(random.uniform(1, 300), 2)
    return {name(cell)}


def typed_over_in_a_column(book, random):
    cell = random.choice(random.choice(runs(book, bool)))
    cell.value = round(random.uniform(1, 300), 2)
    return {name(cell)}


def emptied_formula(book, random):
    cell = random.choice(random.choice(runs(book, bool))[1:-1])
    cell.value = None
    return {name(cell)}


def range_early(book, random):
    cell = random.choice(formulas(book, lambda t: "SUM(" in t or "AVERAGE(" in t or "MAX(" in t))
    return one(random, cell, RANGE, lambda m: f"{m[1]}{m[2]}:{m[3]}{int(m[4]) - 1}" if m[2] != m[4] else
               f"{m[1]}{m[2]}:{chr(ord(m[3]) - 1)}{m[4]}")  # fmt: skip


def range_begins_late(book, random):
    cell = random.choice(formulas(book, lambda t: bool(RANGE.search(t))))
    return one(random, cell, RANGE, lambda m: f"{m[1]}{int(m[2]) + 1}:{m[3]}{m[4]}" if m[2] != m[4] else
               f"{chr(ord(m[1]) + 1)}{m[2]}:{m[3]}{m[4]}")  # fmt: skip


def row_added(book, random):
    """A row below the last of a table, which sums do not have; what stood there moves down."""
    cell = random.choice(formulas(book, lambda t: t.startswith(("=SUM(", "=MAX(", "=AVERAGE(")) and ":" in t))
    match, sheet = RANGE.search(cell.value), cell.parent
    last = int(match[4])
    if match[2] == match[4] or sheet.title == "Measured":
        return None
    if any(sheet.cell(last + 1, c).value is not None for c in range(1, sheet.max_column + 1)):
        sheet.move_range(f"A{last + 1}:Z{sheet.max_row}", rows=1)
    for column in range(1, sheet.max_column + 1):
        above, new = sheet.cell(last, column), sheet.cell(last + 1, column)
        new.value = copied(above, new) if above.data_type == "f" else above.value
    row = [c for c in sheet[cell.row] if c.data_type == "f"]
    return {name(c) for c in row} | {name(sheet.cell(last + 1, c)) for c in range(1, sheet.max_column + 1)}


def reference_slips(book, random):
    cell = random.choice(formulas(book, lambda t: any(not m[1] and not m[3] for m in REFERENCE.finditer(t))))
    match = random.choice([m for m in REFERENCE.finditer(cell.value) if not m[1] and not m[3]])
    row, column = random.choice([(1, 0), (-1, 0), (0, 1), (0, -1)])
    letter, number = chr(max(65, ord(match[2]) + column)), max(1, int(match[4]) + row)
    return replaced(cell, match, f"{letter}{number}") if (letter, number) != (match[2], int(match[4])) else None


def wrong_figure(book, random):
    """In a list of figures, another one is read than is meant."""
    cell = random.choice([c for c in formulas(book, lambda t: ":" not in t) if len(run_of(c)) == 1])
    match = random.choice(list(REFERENCE.finditer(cell.value)))
    other = random.choice(
        [c for c in numbers(book) if c.parent is cell.parent and c.column_letter == match[2]] or [None]
    )
    return None if other is None or other.row == int(match[4]) else replaced(cell, match, other.coordinate)


def refill(run, text):
    run[0].value = text
    for other in run[1:]:
        other.value = copied(run[0], other)
    return {name(c) for c in run}


def change_run(run, random, pattern, change):
    """Change a match of a pattern in the first formula of a run, and copy it on."""
    text = run[0].value
    match = random.choice(list(pattern.finditer(text)))
    return refill(run, text[: match.start()] + change(match) + text[match.end() :])


def lost_dollar(book, random):
    run = random.choice(runs(book, lambda t: bool(ABSOLUTE.search(t))))
    return change_run(run, random, ABSOLUTE, lambda m: m[1] + m[2])


def dollar_too_much(book, random):
    run = random.choice(runs(book, lambda t: bool(MOVING.search(t))))
    return change_run(run, random, MOVING, lambda m: f"${m[2]}${m[3]}")


def operator(book, random):
    cell = random.choice(formulas(book, lambda t: bool(re.search(r"[\w)][-+*/]", t))))
    other = {"+": "-", "-": "+", "*": "/", "/": "*"}
    return one(random, cell, re.compile(r"(?<=[\w)])[-+*/]"), lambda m: other[m[0]])


def constant(book, random):
    """A number in a formula is mistyped, of a cell or of the whole column."""
    cell = random.choice(formulas(book, lambda t: bool(LITERAL.search(t))))
    match = random.choice(list(LITERAL.finditer(cell.value)))
    wrong = random.choice([f"{float(match[1]) * 10:g}", f"{float(match[1]) / 10:g}", f"{float(match[1]) + 1:g}"])
    text = cell.value[: match.start()] + wrong + cell.value[match.end() :]
    if random.random() < 0.4:
        return refill([cell, *(c for c in run_of(cell) if c is not cell)], text)
    cell.value = text
    return {name(cell)}


def change_conversion(book, random, pattern, change):
    """Change a conversion of units in a formula, and in its copies."""
    run = run_of(random.choice(formulas(book, lambda t: bool(re.search(pattern, t)))))
    return change_run(run, random, re.compile(pattern), change)


def conversion_forgotten(book, random):
    return change_conversion(book, random, r"[*/](?:1000000|10000|1000|3600|60|100)(?!\d)", lambda m: "")


def conversion_twice(book, random):
    return change_conversion(book, random, r"[*/](?:1000|3600|60|9\.81)(?![\d.])", lambda m: 2 * m[0])


def conversion_elsewhere(book, random):
    """A formula multiplies where it should divide by a conversion."""
    return change_conversion(book, random, r"[*/](?=(?:1000|3600|60)(?!\d))", lambda m: "*" if m[0] == "/" else "/")


def entered(book, random):
    """An entered number that some formula reads by itself, with these formulas."""
    cells = [(c, readers) for c in random.sample(numbers(book), 25) if (readers := read_by(book, c))]
    return random.choice(cells) if cells else (None, [])


def text_number(book, random):
    cell, readers = entered(book, random)
    if cell is None:
        return None
    cell.value = random.choice(["{}", "{} ", "'{}"]).format(cell.value).replace(".", random.choice(".,"))
    cell.data_type = "s"
    return {name(cell), *map(name, readers)}


def emptied_entry(book, random):
    cell, readers = entered(book, random)
    if cell is None:
        return None
    cell.value = None
    return {name(cell), *map(name, readers)}


def hidden_error(book, random):
    run = run_of(random.choice(formulas(book, lambda t: "IFERROR" not in t)))
    return refill(run, f"=IFERROR({run[0].value[1:]},0)")


def unsorted(book, random):
    if "Catalogue" not in book.sheetnames:
        return None
    sheet = book["Catalogue"]
    keys = [c for row in sheet.iter_rows() for c in row if isinstance(c.value, float)]
    keys = [c for c in keys if c.column == keys[0].column]
    k = random.randrange(len(keys) - 1)
    keys[k].value, keys[k + 1].value = keys[k + 1].value, keys[k].value
    readers = formulas(book, lambda t: "MATCH" in t)
    return {name(keys[k]), name(keys[k + 1]), *map(name, readers)}


def circle(book, random):
    cell, readers = entered(book, random)
    if cell is None:
        return None
    reader = random.choice(readers)
    cell.value = f"={reader.coordinate}*0.5"
    return {name(cell), name(reader)}


def link(book, random):
    cell = random.choice(formulas(book, lambda t: bool(REFERENCE.search(t)) and ":" not in t))
    return one(random, cell, REFERENCE, lambda m: f"[2]Sheet1!{m[0]}")


def volatile(book, random):
    cell = random.choice(formulas(book, lambda t: bool(REFERENCE.search(t)) and ":" not in t))
    return one(random, cell, REFERENCE, lambda m: random.choice(['INDIRECT("{}")', "OFFSET({},0,0)"]).format(m[0]))


def hidden(book, random):
    """A sheet that another reads is hidden."""
    if "Catalogue" not in book.sheetnames:
        return None
    book["Catalogue"].sheet_state = "hidden"
    return {name(c) for c in formulas(book, lambda t: "Catalogue" in t)}


def typed_in(book, random):
    """A formula has the number of a figure instead of its cell; nothing else reads that."""
    cell, readers = entered(book, random)
    if cell is None or len(readers) > 1:
        return None
    pattern = re.compile(rf"\$?{cell.column_letter}\$?{cell.row}(?!\d)")
    readers[0].value = pattern.sub(f"{cell.value}", readers[0].value)
    return {name(cell), name(readers[0])}


def is_label(text):
    return isinstance(text, str) and len(text) > 3 and not re.search(r"\d", text)


def other_value(book, random):
    """A figure is entered again on another sheet, and differs."""
    cell = random.choice([c for c in numbers(book) if c.column > 1 and is_label(c.offset(0, -1).value)])
    sheet = random.choice([s for s in book if s is not cell.parent])
    row = sheet.max_row + 2
    sheet.cell(row, 1, cell.offset(0, -1).value)
    sheet.cell(row, 2, round(cell.value * 1.1, 4))
    sheet.cell(row, 3, cell.offset(0, 1).value if isinstance(cell.offset(0, 1).value, str) else None)
    return {name(cell), name(sheet.cell(row, 2))}


def drifted(book, random):
    twins = [s for s in book if s.title.endswith("second")]
    if not twins:
        return None
    cell = random.choice([c for c in formulas(book) if c.parent is twins[0]])
    label = cell.parent.cell(cell.row, 2).value if cell.column > 2 else None
    first = book[twins[0].title.split(" – ")[0]]
    texts = {c.value for c in cell.parent[cell.row] if isinstance(c.value, str) and c is not cell and len(c.value) > 3}
    pairs = {
        name(c) for row in first.iter_rows() for c in row if texts & {d.value for d in first[c.row]} or c.value == label
    }
    match = random.choice(list(re.finditer(r"[*/+](?=[A-Z(\d])", cell.value)) or [None])
    return None if match is None else replaced(cell, match, "*1.1" + match[0]) | pairs


KINDS = (
    typed_over, typed_over_in_a_column, emptied_formula, range_early, range_begins_late, row_added, reference_slips,
    wrong_figure, lost_dollar, dollar_too_much, operator, constant, conversion_forgotten, conversion_twice,
    conversion_elsewhere, text_number, emptied_entry, hidden_error, unsorted, circle, link, volatile, hidden, typed_in,
    other_value, drifted,
)  # fmt: skip


def draw(seed, number):
    """Draw workbooks, the kinds of faults in turn: kind, the book sound, with the fault, and where it may be named."""
    for k in count():
        kind, random = KINDS[k % len(KINDS)], Random(f"{seed}, {k}")
        style = random.getstate()
        book = write_book(random)
        try:
            cells = kind(book, random)
        except (IndexError, ValueError):  # no place for it in this book
            continue
        if not cells:
            continue
        random.setstate(style)
        yield kind.__name__, write_book(random), book, cells
        if (number := number - 1) == 0:
            return
