"""No look-up of any book hangs on less than 1e-9 of ξ or of the abscissa's range.

Spreadsheet programs take numbers for equal that differ in the twelfth decimal (formulon's MATCH, LibreOffice's =),
and another processor's sine rounds otherwise: a key so near to what is looked up would give another row there.
"""

import math
import re
from functools import cache

import pytest

from tests.workbook.composed import EXERCISE, composed
from workbook.book.address import Address
from workbook.book.formula import Area, read, reference
from workbook.build import build, committed_descriptions
from workbook.entries.machine import Machine
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES
from workbook.witnesses.engines import Formulon

LEAST = 1e-9
CALL = re.compile(r"\b(MATCH|INT)\(")
EQUAL = re.compile(r"(?<![<>])=")
ROUNDS = re.compile(r"[.*^]|/.*/")  # what may make of whole numbers one that is nearly whole


def is_number(value):
    return isinstance(value, int | float) and not isinstance(value, bool)


def small(values, k):
    numbers = sorted(value for value in values if is_number(value))
    return numbers[k - 1] if k <= len(numbers) else None


def count(values):
    return sum(map(is_number, values))


def either(condition, then, otherwise):
    return then if condition else otherwise


def index(values, row):
    return values[int(row) - 1]


def numbers_in(values):
    """Of a range the numbers, as programs have it: texts are passed over."""
    return [value for value in values[0] if is_number(value)] if len(values) == 1 else values


def least(*values):
    return min(numbers_in(values), default=0)


def most(*values):
    return max(numbers_in(values), default=0)


FUNCTIONS = {
    "MIN": least, "MAX": most, "INT": math.floor, "SMALL": small, "COUNT": count, "IF": either, "INDEX": index,
    "PI": lambda: math.pi, "LN": lambda x: math.log(x) if x > 0.0 else math.nan,
}  # fmt: skip


def calls(text):
    """The functions of a formula that look up or cut off, each with its arguments as written."""
    for found in CALL.finditer(text):
        arguments, depth, begin, quoted = [], 0, found.end(), False
        for at in range(found.end(), len(text)):
            quoted ^= text[at] == '"'
            depth += 0 if quoted else (text[at] == "(") - (text[at] == ")")
            if not quoted and (depth < 0 or (depth == 0 and text[at] == ",")):
                arguments.append(text[begin:at])
                begin = at + 1
                if depth < 0:
                    break
        yield found[1], arguments


@cache
def compiled(shape):
    expression = re.sub(r":B\d+", "", shape[1:]).replace("^", "**")
    return compile(EQUAL.sub("==", expression).replace("<>", "!="), shape, "eval")


class Declared:
    """What every cell of a book holds or should compute, for expressions of its formulas."""

    def __init__(self, book):
        self.cells = {Address(c.block.sheet.title, c.row, c.column): c.expected for c in book.cells()}
        self.names = dict(book.names())
        self.titles = {sheet.title for sheet in book.sheets}

    def area(self, name, sheet):
        if name.endswith("!"):
            return Area(name[:-1], 1, 1, 1, 1, single=True)
        return reference(self.names[name], sheet, self.area)

    def value(self, text, sheet):
        """What an expression comes to; of a range, the values of its cells. An empty cell by itself is 0."""
        formula = read(f"={text}", sheet, self.area)
        arguments = {f"A{i}": self.argument(a) for i, a in enumerate(formula.arguments, 1)}
        return eval(compiled(formula.shape), FUNCTIONS, arguments)

    def is_exact(self, text, sheet):
        """Whether an expression is of whole numbers, and a quotient at most: where it is whole, it is so exactly."""
        formula = read(f"={text}", sheet, self.area)
        cells = [a for a in formula.arguments if a.single]
        return not ROUNDS.search(formula.shape) and all(float(self.argument(a)).is_integer() for a in cells)

    def argument(self, argument):
        if isinstance(argument, str):
            return argument
        values = [self.cells.get(cell) for cell in argument.cells()]
        if argument.single:
            return 0 if values[0] is None else values[0]
        return values


def nearest(x, keys, exact=False):
    """How near the nearest key lies that would change what is found; a whole number may meet its like.

    So may any other where only its like is looked for, ``exact``: it is then a copy.
    """
    others = [k for k in keys if is_number(k) and not (k == x and (exact or k == int(x)))]
    return min((abs(k - x) for k in others), default=math.inf)


def hanging(book):
    """The look-ups of a book: by column, the least distance that decides, and the range that it is a part of."""
    declared, found = Declared(book), {}
    for cell in book.cells():
        if cell.quantity.formula is None or not CALL.search(cell.content):
            continue
        sheet = cell.block.sheet.title
        for n, (name, arguments) in enumerate(calls(cell.content)):
            if "LOG10(" in arguments[0]:  # how many digits a sentence shows: it is compared to the last of them
                continue
            x = declared.value(arguments[0], sheet)
            if not is_number(x) or math.isnan(x) or (name == "INT" and x == 0.0):  # 0 times anything is 0 exactly
                continue
            keys = declared.value(arguments[1], sheet) if name == "MATCH" else [math.floor(x), math.floor(x) + 1]
            shares = name == "INT" or "piece_key" in arguments[1]
            column = found.setdefault((cell.block.name, cell.quantity.name, n, shares), ([], []))
            if name == "INT" and not declared.is_exact(arguments[0], sheet):
                column[0].append(min(abs(k - x) for k in keys))
            else:
                column[0].append(nearest(x, keys, exact=arguments[2:] == ["0"]))
            column[1].append(x)
    return {key: (min(d), 1.0 if key[-1] else max(x) - min(x)) for key, (d, x) in found.items()}


@pytest.mark.parametrize("description", committed_descriptions(), ids=lambda path: path.stem)
@pytest.mark.sample(2)
def test_no_look_up_hangs_on_less_than_a_billionth(description):
    machine = read_machine(description)
    template = TEMPLATES[machine.template]
    for entered in (machine, *template.variants(machine)):
        found = hanging(template.declare(entered))
        assert {key: pair for key, pair in found.items() if not pair[0] >= LEAST * pair[1]} == {}
        assert len(found) >= 8


def scaled(duration):
    """S3's exercise, in so much of its abscissa."""
    phases = [(law, lift, share * duration / 360.0) for law, lift, share in EXERCISE]
    return composed(phases, sizes={"cycle": 120, "law": 40})


@pytest.mark.parametrize("total", [1.0, 0.25, 1e-3, 1e-6])
@pytest.mark.sample(1)
def test_a_motion_of_any_length_is_computed_by_formulon_too(total, tmp_path):
    machine: Machine = scaled(total)
    build(machine, tmp_path / "book.xlsx")
    assert verify(tmp_path / "book.xlsx", [Formulon.name]).findings == []
