"""Formulas of a workbook as Python that people read: proposals, since a translation is no independent route."""

import ast
from collections.abc import Mapping

from workbook.book.address import Address
from workbook.book.columns import Node, tree
from workbook.book.formula import Area, FormulaError
from workbook.book.formula import number as number_text
from workbook.book.rows import is_number
from workbook.oracle.cells import variable_of
from workbook.reading.files import BookFile

Arguments = tuple[Area | str, ...]
MOST = 40  # steps of a proposal, and cells of a range in it: what is longer nobody reads
SIGNS = {"=": "==", "<>": "!=", "^": "**"}  # those that Python writes otherwise
OF_SEVERAL = {"AND": "all", "OR": "any", "MAX": "max", "MIN": "min", "SUM": "sum"}
OF_SEVERAL |= {"AVERAGE": "mean"}
USED = ("abs", "book", "math", *OF_SEVERAL.values())  # names that mean something else
OF_MATH = "ACOS ASIN ATAN COS DEGREES EXP LOG10 RADIANS SIN SQRT TAN".split()
WRITTEN = {(name, 1): f"math.{name.lower()}({{0}})" for name in OF_MATH}
WRITTEN |= {("PI", 0): "math.pi", ("ABS", 1): "abs({0})", ("NOT", 1): "(not {0})"}
WRITTEN |= {("INT", 1): "math.floor({0})", ("LN", 1): "math.log({0})"}
WRITTEN |= {("LOG", 1): "math.log10({0})", ("LOG", 2): "math.log({0}, {1})"}
WRITTEN |= {("ATAN2", 2): "math.atan2({1}, {0})", ("POWER", 2): "({0} ** {1})"}
WRITTEN |= {("IF", 2): "({1} if {0} else False)", ("IF", 3): "({1} if {0} else {2})"}
WRITTEN |= {("MOD", 2): "({0} - {1} * math.floor({0} / {1}))"}


class Proposals:
    """The formulas of a workbook in Python, of the variables of its inputs; the cells between are local variables."""

    def __init__(self, file: BookFile, inputs: Mapping[Address, str]) -> None:
        self.contents, self.file, self.inputs = file.contents, file, inputs
        self.steps: dict[Address, tuple[str, str]] = {}  # variable and expression
        self.above: list[Address] = []  # the cells that are being translated

    def body(self, cell: Address) -> str:
        """Return the body of a function that gives a cell; nothing where a formula on the way is not translated."""
        self.steps, self.above = {}, []
        try:
            last = f"return {self.formula(cell)}"
        except FormulaError:
            return ""
        lines = [*(f"{name} = {text}" for name, text in self.steps.values()), last]
        return "".join(f"    {ast.unparse(ast.parse(line))}\n" for line in lines)

    def formula(self, cell: Address) -> str:
        """Return the expression of a formula cell; raise FormulaError where it is not translated."""
        formula = self.contents.formulas.get(cell)
        is_long = len(self.above) + len(self.steps) > MOST
        if formula is None or is_long or cell in self.above or cell in self.contents.arrays:
            raise FormulaError("#VALUE!", "no formula to translate")
        self.above.append(cell)
        text = self.expression(tree(formula.shape), formula.arguments)
        self.above.pop()
        return text

    def expression(self, node: Node, arguments: Arguments) -> str:
        """Return the expression of a node of a formula, in brackets wherever they may be needed."""
        if node.kind == "number":
            return number_text(repr(node.value))
        if node.kind == "argument":
            argument = arguments[int(node.value)]
            if isinstance(argument, Area) and not argument.single:
                raise FormulaError("#VALUE!", "a range in place of a value")
            return repr(argument) if isinstance(argument, str) else self.variable(argument.first)
        name = str(node.value)
        if node.kind == "other" and name in ("TRUE", "FALSE"):
            return name.title()
        if node.kind == "call" and name in OF_SEVERAL:
            each = ", ".join(value for part in node.parts for value in self.values(part, arguments))
            return f"{OF_SEVERAL[name]}([{each}])"
        parts = [self.expression(part, arguments) for part in node.parts]
        compared = parts[:1] if name == "IF" else parts
        # of texts Excel takes capitals for small letters
        if any(part[0] in "'\"" for part in compared):
            raise FormulaError("#VALUE!", "a text is not translated")
        if node.kind == "call" and (name, len(parts)) in WRITTEN:
            return WRITTEN[name, len(parts)].format(*parts)
        if node.kind != "operation" or name == "&":
            raise FormulaError("#NAME?", f"{name} is not translated")
        if len(parts) == 1:
            return f"({parts[0]} / 100)" if name == "%" else f"({name}{parts[0]})"
        return f"({parts[0]} {SIGNS.get(name, name)} {parts[1]})"

    def values(self, node: Node, arguments: Arguments) -> list[str]:
        """Return the expressions of an argument of a sum: of a range those of its numbers and formulas."""
        area = arguments[int(node.value)] if node.kind == "argument" else ""
        if isinstance(area, str):
            return [self.expression(node, arguments)]
        if area.size > MOST:
            raise FormulaError("#VALUE!", "the range is too long to be read")
        numbers, formulas = self.contents.constants, self.contents.formulas
        cells = (cell for cell in area.cells() if cell in formulas or is_number(numbers.get(cell)))
        return [self.variable(cell) for cell in cells]

    def variable(self, cell: Address) -> str:
        """Return the variable of a cell, translated where it is a formula; of any other cell its number."""
        if cell in self.inputs or cell in self.steps:
            return self.inputs.get(cell) or self.steps[cell][0]
        held, value = self.contents, self.contents.constants.get(cell, 0)
        if cell not in held.formulas and cell not in held.failed and is_number(value):
            return f"({value!r})"
        text, name = self.formula(cell), variable_of(self.file, cell)
        while name in {*self.inputs.values(), *(name for name, _ in self.steps.values()), *USED}:
            name = f"{name}_{cell.a1.casefold()}"
        self.steps[cell] = name, text
        return name
