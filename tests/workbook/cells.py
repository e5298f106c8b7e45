"""What the cells of a declared book compute, without a file in between."""

import io
from pathlib import Path

import openpyxl

from workbook.judging.compare import TOLERANCE, difference
from workbook.judging.matching import Match, Right
from workbook.reading.files import BookFile, find_places
from workbook.witnesses.pycel.witness import PycelModel
from workbook.writing import archive
from workbook.writing.write import parts


def opened(book, model):
    """What is read of the file that is written of a declared book."""
    return openpyxl.load_workbook(io.BytesIO(archive.zipped(parts(book, model))))


def computed(template, machine):
    """What pycel computes in each block, by name: a value, or a list for a column of a table."""
    book = template.declare(machine)
    values = PycelModel(opened(book, template.model)).evaluate()

    def value(name, column=None):
        block = book.blocks[name]
        cells = [c for c in block.cells() if column in (None, c.quantity.name)]
        got = [values[(block.sheet.title, c.row, c.column)] for c in cells]
        return got if block.is_table else got[0]

    return value


def by_pycel(written):
    return PycelModel(written).evaluate()


def disagreeing(template, machine, evaluate=by_pycel):
    """The formula cells in which not the engine's value is computed; and how many formula cells there are."""
    book = template.declare(machine)
    written = opened(book, template.model)
    match = Match(BookFile(Path("book.xlsx"), written, find_places(written)), book)
    values, right = evaluate(written), Right(match, book)
    pairs = [pair for pair in match.pairs if pair.declared_formula]
    wrong = [
        f"{pair.cell.block.name}.{pair.cell.quantity.name}[{pair.cell.i}]: {values[a]} for {right.get(a)}"
        for pair in pairs
        if not difference(values[a := pair.address], right.get(a), right.peak(a)) <= TOLERANCE
    ]
    return wrong, len(pairs)
