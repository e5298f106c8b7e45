"""A first file of declarations for a workbook: inputs with their ranges, outputs with their formulas."""

from collections.abc import Collection, Iterable, Mapping
from contextlib import suppress
from functools import reduce
from operator import or_

from workbook.book.address import Address
from workbook.book.formula import FormulaError, reference
from workbook.book.rows import is_number
from workbook.oracle.cells import label_of, unit_of, variable_of
from workbook.oracle.proposals import USED, Proposals
from workbook.reading.contents import Contents
from workbook.reading.files import BookFile
from workbook.witnesses.pycel.graph import Graph
from workbook.witnesses.pycel.model import PycelModel

LONG = 8  # numbers one below the other that are data
HEAD = '''"""What {book} should compute; run it with: motionbook verify {book} --against FILE.py

Give each input its range, and write each output's formula from the source that it comes from.
"""

{imports}from workbook.oracle import Oracle

book = Oracle("{title}")

'''


def draft(file: BookFile, proposed: bool = False) -> str:
    """Return the text of a first file of declarations for a workbook.

    Where ``proposed``, the functions are translated from the formulas, each marked as a proposal.
    """
    inputs, outputs = inputs_and_outputs(file)
    imports = "import math\nfrom statistics import mean\n\n" if proposed else ""
    lines = [HEAD.format(book=file.path.name, title=file.path.stem, imports=imports)]
    lines += [input_line(file, cell, name) for cell, name in inputs.items()]
    proposals = Proposals(file, inputs)
    for cell, name in variable_names(file, list(outputs), tuple(inputs.values())).items():
        cells, needed = outputs[cell]
        body = proposals.body(cell) if proposed and len(cells) == 1 else ""
        mark = ", proposed=True" if body else ""
        lines += [
            f"\n\n@book.output({place_of(cells)!r}, unit={unit_of(file, cell)!r}, source=''{mark})\n",
            f"def {name}({', '.join(needed)}):\n",
            body or f"    raise NotImplementedError({label_of(file, cell)!r})\n",
        ]
    return "".join(lines)


def inputs_and_outputs(file: BookFile) -> tuple[dict[Address, str], dict[Address, tuple[list[Address], list[str]]]]:
    """Return the inputs of a workbook with their variables, and its outputs by their first cells.

    Inputs are numbers that formulas read; numbers in a long column are data. Outputs are formulas that nothing reads,
    each with all of its cells (a formula that is copied is one output over a range) and the inputs that it needs.
    """
    contents = file.contents
    graph = PycelModel(contents).graph({x: contents.rough_areas(x) for x in contents.failed})
    read = {source for sources in graph.reads.values() for source in sources}
    inputs = numbers_read(graph, contents, read)
    data = in_long_columns(inputs.values())
    names = variable_names(file, [cell for cell in inputs.values() if cell not in data])
    needs = inputs_needed(graph, {number: cell for number, cell in inputs.items() if cell in names})
    numbers = {x: n for n, x in graph.cells.items() if n in graph.reads and n not in read}
    outputs = {}
    for cells in copied_blocks(contents, numbers):
        mask = reduce(or_, (needs[numbers[cell]] for cell in cells))
        outputs[cells[0]] = cells, [name for i, name in enumerate(names.values()) if mask >> i & 1]
    return names, outputs


def place_of(cells: list[Address]) -> str:
    """Return the address of a cell, or of the range of cells."""
    return f"{cells[0]}:{cells[-1].a1}" if len(cells) > 1 else str(cells[0])


def input_line(file: BookFile, cell: Address, name: str) -> str:
    """Return the line that declares an input."""
    value, (low, high, choices) = file.contents.constants[cell], range_of(file, cell)
    given = f"choices={choices!r}" if choices else f"low={low!r}, high={high!r}"
    return f"{name} = book.input({str(cell)!r}, unit={unit_of(file, cell)!r}, {given})  # entered {value!r}\n"


def range_of(file: BookFile, cell: Address) -> tuple[float, float, list[float]]:
    """Return the ends of an input's range, else its choices, by its data validation; else the value as entered."""
    low = high = file.contents.constants[cell]
    for rule in file.workbook[cell.sheet].data_validations.dataValidation:
        first, last = (numbers_of(file, str(x), cell) for x in (rule.formula1, rule.formula2))
        if not first or cell.a1 not in rule.sqref:
            continue
        if rule.type == "list":
            return low, high, first
        if rule.type in ("decimal", "whole") and "not" not in (rule.operator or ""):
            sign = rule.operator or "between"
            low = low if sign.startswith("less") else first[0]
            high = high if sign.startswith("greater") else (last or first)[0]
    return low, high, []


def numbers_of(file: BookFile, text: str, cell: Address) -> list[float]:
    """Return the numbers of a rule for a cell: written in the rule, or in the cells to which it refers."""
    with suppress(ValueError):
        return [float(word) for word in text.strip('"').split(",")]
    with suppress(FormulaError):
        is_name = file.contents.knows(text, cell.sheet)
        area = file.contents.area
        cells = area(text, cell.sheet) if is_name else reference(text, cell.sheet, area)
        values = [file.contents.constants.get(held) for held in cells.cells()]
        return [float(value) for value in values if value is not None and is_number(value)]
    return []


def numbers_read(graph: Graph, contents: Contents, read: Collection[int]) -> dict[int, Address]:
    """Return the cells with a number that are among those read, by their numbers in the graph."""
    cells = ((n, x) for n, x in graph.cells.items() if n in read and n not in graph.reads)
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
        is_next = bool(run) and run[-1] == cell._replace(row=cell.row - 1)
        run = [*run, cell] if is_next and len(run) < LONG else [cell]
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
    blocks: dict[tuple[Address, int], list[list[Address]]] = {}  # by the upper cell right, and rows
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
    used = {*taken, *USED}
    for cell in cells:
        first = name = variable_of(file, cell)
        number = 1
        while name in used:
            number += 1
            name = f"{first}_{number}"
        used.add(name)
        names[cell] = name
    return names
