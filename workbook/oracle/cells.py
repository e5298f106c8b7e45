"""Cells as people call them: an address, a defined name, or the label beside the cell; a first file of declarations."""

import keyword
import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from functools import reduce
from operator import or_

from workbook.book.address import Address
from workbook.book.rows import is_number
from workbook.dimensions.units import dimension_of
from workbook.errors import ReadError
from workbook.reading.contents import Contents, plain_label
from workbook.reading.files import BookFile
from workbook.witnesses.pycel.graph import Graph
from workbook.witnesses.pycel.model import PycelModel

CELL = re.compile(r"(?:(?P<sheet>'(?:[^']|'')+'|[^'!]+)!)?\$?(?P<column>[A-Za-z]{1,3})\$?(?P<row>\d{1,7})")
BRACKETS = re.compile(r"[\[(]([^\])]{1,12})[\])]")
LONG = 8  # numbers one below the other that are data
NEAR = 6  # columns right of a label in which its figure stands


def find_cell(file: BookFile, text: str) -> Address:
    """Return the cell of an address, a name or a label; raise ReadError where there is none, or are several."""
    if CELL.fullmatch(text):
        return on_sheet(file, text)
    if text in file.places:
        return file.places[text].cell(0, 0)
    held = file.contents.constants.items()
    labels = (at for at, value in held if isinstance(value, str) and plain_label(value) == plain_label(text))
    cells = [cell for label in labels if (cell := value_right_of(file, label)) is not None]
    if len(cells) == 1:
        return cells[0]
    what = f"{len(cells)} cells stand beside this label: {', '.join(map(str, cells))}" if cells else "no such cell"
    raise ReadError(f"{file.path.name}: {text!r}: {what}; expected an address, a defined name or a label")


def on_sheet(file: BookFile, text: str) -> Address:
    """Return the cell of an address, by default on the first sheet; raise ReadError for a sheet that is missing."""
    titles = file.workbook.sheetnames
    if (address := Address.parse(text, titles[0])).sheet not in titles:
        raise ReadError(f"{file.path.name}: {text!r}: no sheet is called {address.sheet!r}; found {', '.join(titles)}")
    return address


def value_right_of(file: BookFile, label: Address) -> Address | None:
    """Return the first number or formula right of a label; None where there is none nearby."""
    constants, formulas = file.contents.constants, file.contents.formulas
    cells = (label._replace(column=label.column + right) for right in range(1, NEAR + 1))
    return next((at for at in cells if isinstance(constants.get(at), int | float) or at in formulas), None)


def label_of(file: BookFile, cell: Address) -> str:
    """Return the text left of a cell, else the text above it, else nothing."""
    left = [cell._replace(column=column) for column in range(cell.column - 1, max(0, cell.column - NEAR), -1)]
    above = [cell._replace(row=row) for row in range(cell.row - 1, max(0, cell.row - NEAR), -1)]
    texts = (file.contents.constants.get(at) for at in [*left, *above])
    return next((text.strip().rstrip(" :=") for text in texts if isinstance(text, str) and text.strip()), "")


def unit_of(file: BookFile, cell: Address) -> str:
    """Return the unit beside a cell: right of it, or in brackets in the text left of it, else in that above it."""
    held = file.contents.constants
    left = held.get(cell._replace(column=cell.column - 1)) if cell.column > 1 else None
    above = held.get(cell._replace(row=cell.row - 1)) if cell.row > 1 else None
    brackets = [bracket for text in (left, above) for bracket in BRACKETS.findall(str(text or ""))]
    texts = [held.get(cell._replace(column=cell.column + 1)), *brackets]
    units = (text.strip(" []()") for text in texts if isinstance(text, str))
    return next((unit for unit in units if dimension_of(unit) is not None), "")


def cells_of(file: BookFile, text: str) -> list[list[Address]]:
    """Return the rows of a range such as ``Sheet!A20:D60``."""
    sheet, mark, cells = text.rpartition("!")
    first, _, last = cells.partition(":")
    top, bottom = (on_sheet(file, f"{sheet}{mark}{end}") for end in (first, last or first))
    rows, columns = range(top.row, bottom.row + 1), range(top.column, bottom.column + 1)
    return [[Address(top.sheet, row, column) for column in columns] for row in rows]


# A first file of declarations

HEAD = '''"""What {book} should compute; run it with: motionbook verify {book} --against FILE.py

Give each input its range, and write each output's formula from the source that it comes from.
"""

from workbook.oracle import Oracle

book = Oracle("{title}")

'''


def draft(file: BookFile) -> str:
    """Return the text of a first file: inputs are numbers that formulas read, outputs formulas that nothing reads.

    A formula that is copied is one output over a range; numbers in a long column are data, and no inputs.
    """
    contents = file.contents
    graph = PycelModel(contents).graph({cell: contents.rough_areas(cell) for cell in contents.failed})
    read = {source for sources in graph.reads.values() for source in sources}
    inputs = numbers_read(graph, contents, read)
    data = in_long_columns(inputs.values())
    names = variable_names(file, [cell for cell in inputs.values() if cell not in data])
    needs = inputs_needed(graph, {number: cell for number, cell in inputs.items() if cell in names})
    numbers = {cell: number for number, cell in graph.cells.items() if number in graph.reads and number not in read}
    lines = [HEAD.format(book=file.path.name, title=file.path.stem)]
    lines += [input_line(file, cell, name) for cell, name in names.items()]
    blocks = {cells[0]: cells for cells in copied_blocks(contents, numbers)}
    for cell, name in variable_names(file, list(blocks), tuple(names.values())).items():
        mask = reduce(or_, (needs[numbers[other]] for other in blocks[cell]))
        needed = ", ".join(name for i, name in enumerate(names.values()) if mask >> i & 1)
        place = f"{cell}:{blocks[cell][-1].a1}" if len(blocks[cell]) > 1 else str(cell)
        lines += [
            f"\n\n@book.output({place!r}, unit={unit_of(file, cell)!r}, source='')\n",
            f"def {name}({needed}):\n    raise NotImplementedError({label_of(file, cell)!r})\n",
        ]
    return "".join(lines)


def input_line(file: BookFile, cell: Address, name: str) -> str:
    """Return the line that declares an input."""
    value = f"{file.contents.constants[cell]!r}"
    given = f"{str(cell)!r}, unit={unit_of(file, cell)!r}, low={value}, high={value}"
    return f"{name} = book.input({given})  # entered {value}\n"


def numbers_read(graph: Graph, contents: Contents, read: Collection[int]) -> dict[int, Address]:
    """Return the cells with a number that are among those read, by their numbers in the graph."""
    cells = ((number, cell) for number, cell in graph.cells.items() if number in read and number not in graph.reads)
    return {number: cell for number, cell in cells if is_number(contents.constants.get(cell))}


def inputs_needed(graph: Graph, inputs: Mapping[int, Address]) -> dict[int, int]:
    """Return for each number of a graph the inputs on which it depends: the bit of each, in their order."""
    needs = {number: 1 << i for i, number in enumerate(inputs)}
    for number in graph.order():
        needs[number] = reduce(or_, (needs.get(source, 0) for source in graph.reads[number]), 0)
    return needs


def in_long_columns(cells: Iterable[Address]) -> set[Address]:
    """Return those of cells that stand in a column of many, one below the other."""
    run: list[Address] = []
    data = set[Address]()
    for cell in sorted(cells, key=lambda cell: (cell.sheet, cell.column, cell.row)):
        run = [*run, cell] if run and run[-1] == cell._replace(row=cell.row - 1) and len(run) < LONG else [cell]
        if len(run) == LONG or run[-1]._replace(row=cell.row - 1) in data:
            data |= {*run}
    return data


def copied_blocks(contents: Contents, cells: Iterable[Address]) -> list[list[Address]]:
    """Return formula cells by the blocks over which a formula is copied, each row by row."""
    columns: list[list[Address]] = []
    shapes = {cell: contents.formulas[cell].shape for cell in cells if cell in contents.formulas}
    for cell in sorted(cells, key=lambda cell: (cell.sheet, cell.column, cell.row)):
        above = columns[-1][-1] if columns else None
        if above == cell._replace(row=cell.row - 1) and shapes.get(above) == shapes.get(cell, ""):
            columns[-1].append(cell)
        else:
            columns.append([cell])
    blocks: dict[tuple[Address, int], list[list[Address]]] = {}  # by the upper cell right of a block, and its rows
    for column in columns:
        left = blocks.pop((column[0], len(column)), [])
        if left and shapes.get(left[-1][0]) != shapes.get(column[0], ""):
            blocks[column[0], -len(blocks)] = left
            left = []
        blocks[column[0]._replace(column=column[0].column + 1), len(column)] = [*left, column]
    return [[cell for row in zip(*block, strict=True) for cell in row] for block in blocks.values()]


def variable_names(file: BookFile, cells: list[Address], taken: tuple[str, ...] = ()) -> dict[Address, str]:
    """Return a variable for each cell, built from its label, each once."""
    names: dict[Address, str] = {}
    count = Counter(taken)
    for cell in cells:
        words = re.sub(r"\W+", "_", label_of(file, cell).casefold()).strip("_")
        name = words if words.isidentifier() and not keyword.iskeyword(words) else f"cell_{cell.a1.casefold()}"
        count[name] += 1
        names[cell] = name if count[name] == 1 else f"{name}_{count[name]}"
    return names
