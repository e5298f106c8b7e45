"""A first file of declarations for a workbook: its inputs and outputs with labels and units found beside them."""

import keyword
import re
from collections import Counter

from workbook.book.address import Address
from workbook.oracle.cases import is_number
from workbook.oracle.cells import label_of, unit_of
from workbook.reading.files import BookFile

HEAD = '''"""What {book} should compute; run it with: motionbook verify {book} --against FILE.py

Give each input its range, and write each output's formula from the source that it comes from.
"""

from workbook.oracle import Oracle

book = Oracle("{title}")

'''


def draft(file: BookFile) -> str:
    """Return the text of a first file: inputs are numbers that formulas read, outputs formulas that nothing reads."""
    contents = file.contents
    numbers = [cell for cell, value in contents.constants.items() if is_number(value)]
    read = contents.read(numbers)
    inputs = [cell for cell in numbers if cell in read]
    formulas = contents.formula_cells
    used = contents.read(formulas)
    outputs = [cell for cell in formulas if cell not in used]
    names = named(file, inputs)
    lines = [HEAD.format(book=file.path.name, title=file.path.stem)]
    for cell, name in names.items():
        value = contents.constants[cell]
        unit = unit_of(file, cell)
        lines.append(
            f"{name} = book.input({str(cell)!r}, unit={unit!r}, low={value!r}, high={value!r})  # entered {value!r}\n"
        )
    for cell, name in named(file, outputs, tuple(names.values())).items():
        lines.append(
            f"\n\n@book.output({str(cell)!r}, unit={unit_of(file, cell)!r}, source='')\n"
            f"def {name}({', '.join(needed(file, cell, names))}):\n"
            f"    raise NotImplementedError({label_of(file, cell)!r})\n"
        )
    return "".join(lines)


def needed(file: BookFile, output: Address, names: dict[Address, str]) -> list[str]:
    """Return the names of the inputs on which an output depends."""
    steps = file.contents.needed(file.contents.formula_cells, [output]) | {output}
    read = file.contents.read(list(names), steps)
    return [name for cell, name in names.items() if cell in read]


def named(file: BookFile, cells: list[Address], taken: tuple[str, ...] = ()) -> dict[Address, str]:
    """Return a variable for each cell, made of its label, each once."""
    found: dict[Address, str] = {}
    count = Counter(taken)
    for cell in cells:
        words = re.sub(r"\W+", "_", label_of(file, cell).casefold()).strip("_")
        name = words if words.isidentifier() and not keyword.iskeyword(words) else f"cell_{cell.a1.casefold()}"
        count[name] += 1
        found[cell] = name if count[name] == 1 else f"{name}_{count[name]}"
    return found
