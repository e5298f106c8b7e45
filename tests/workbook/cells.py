"""What the cells of a declared book compute, without a file in between."""

import io
from pathlib import Path

import openpyxl
from openpyxl.workbook.defined_name import DefinedName

from tests import tiers
from workbook.book.address import Address
from workbook.book.rows import as_rows
from workbook.judging.carry_over import not_carried
from workbook.judging.comparison import TOLERANCE, ExpectedValues, difference
from workbook.judging.matching import Match, is_formula
from workbook.reading.entries import Entries
from workbook.reading.files import BookFile, find_places
from workbook.witnesses.agreement import agreed_values
from workbook.witnesses.pycel.model import PycelModel
from workbook.writing import archive
from workbook.writing.write import parts


def opened(book, model):
    """What is read of the file that is written of a declared book."""
    return openpyxl.load_workbook(io.BytesIO(archive.zipped(parts(book, model))))


def in_memory(book):
    """What is computed of a declared book, as openpyxl would read it of the file: cells and names, no looks."""
    workbook = openpyxl.Workbook()
    workbook.remove(workbook.active)
    for sheet in book.sheets:
        page = workbook.create_sheet(sheet.title)
        cells = [(cell.row, cell.column, cell.content) for block in sheet.blocks for cell in block.cells()]
        for row, column, content in (*((text.row, text.column, text.text) for text in sheet.texts), *cells):
            if content not in ("", None):
                page.cell(row, column).value = content
    for name, target in book.names():
        workbook.defined_names[name] = DefinedName(name, attr_text=target)
    return workbook


KEPT = 6  # layouts: a test file has a few, and those of other files may go


class Layout:
    """The formulas of a book, read once; other books of the same formulas differ in what their other cells hold."""

    known: dict[tuple, "Layout"] = {}  # noqa: RUF012 - one memory for all

    def __init__(self, book):
        written = in_memory(book)
        self.match = Match(BookFile(Path("book.xlsx"), written, find_places(written)), book)
        self.model = PycelModel(self.match.file.contents)

    @classmethod
    def of(cls, template, book, formulas):
        """The layout of a book, made anew where no earlier book has the very same formulas, names and blocks."""
        blocks = tuple((b.name, b.sheet.title, b.row, b.column, b.size) for b in book.blocks.values())
        key = (template.name, tuple(formulas.items()), tuple(book.names()), blocks)
        found = cls.known.pop(key, None) or cls(book)
        cls.known[key] = found  # the latest is last
        if len(cls.known) > KEPT:
            del cls.known[next(iter(cls.known))]
        return found


def by_pycel(template, book):
    """The layout of a book, and what pycel computes in each of its formula cells."""
    held = {Address(c.block.sheet.title, c.row, c.column): c.content for c in book.cells()}
    formulas = {address: content for address, content in held.items() if is_formula(content)}
    layout = Layout.of(template, book, formulas)
    return layout, layout.model.evaluate({a: content for a, content in held.items() if a not in formulas})


def computed(template, machine, by_cells=False):
    """The values of a book's blocks by name, of a column of a table a list: the engine's; by night what pycel computes.

    That the cells compute what the engine does, :func:`disagreeing` shows of each kind of machine every day.
    """
    book = template.declare(machine)
    values = by_pycel(template, book)[1] if by_cells or tiers.night else None

    def value(name, column=None):
        block = book.blocks[name]
        cells = [c for c in block.cells() if column in (None, c.quantity.name)]
        if values is None:
            rows = {q.name: as_rows(q.value, block.size, q.name) for q in block.quantities}
            got = [rows[c.quantity.name][c.i] for c in cells]
        else:
            got = [values[(block.sheet.title, c.row, c.column)] for c in cells]
        return got if block.is_table else got[0]

    return value


def disagreeing(template, machine):
    """The formula cells in which pycel does not compute the engine's value; and how many formula cells there are."""
    book = template.declare(machine)
    layout, values = by_pycel(template, book)
    return compared(layout.match, book, values)


def disagreeing_in(template, machine, evaluate):
    """The same by another program, which is given the workbook as openpyxl reads it."""
    book = template.declare(machine)
    written = in_memory(book)
    return compared(Match(BookFile(Path("book.xlsx"), written, find_places(written)), book), book, evaluate(written))


def entered(template, machine):
    """The machine that is read back from the cells of a machine's book, and in lines what of it is not carried over."""
    written = opened(template.declare(machine), type(machine))
    file = BookFile(Path("book.xlsx"), written, find_places(written))
    back = Entries(file, agreed_values).machine()
    return back, not_carried(Match(file, template.declare(back)), template.name)


def compared(match, book, values):
    """The formula cells whose value is not the engine's, in words; and how many formula cells there are."""
    right = ExpectedValues(match, book)
    pairs = [pair for pair in match.pairs if pair.declared_formula]
    wrong = [
        f"{pair.cell.block.name}.{pair.cell.quantity.name}[{pair.cell.i}]: {values[a]} for {right.get(a)}"
        for pair in pairs
        if not difference(values[a := pair.address], right.get(a), right.peak(a)) <= TOLERANCE
    ]
    return wrong, len(pairs)
