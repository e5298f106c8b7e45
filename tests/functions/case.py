"""What a case of the functions is, and a workbook that asks for all of them."""

from dataclasses import dataclass

import openpyxl
from openpyxl.utils import get_column_letter

VALUE, NUM, NA, DIV0 = "#VALUE!", "#NUM!", "#N/A", "#DIV/0!"
ANY_ERROR = "an error"  # where the two back ends may name it differently
ERRORS = (VALUE, NUM, NA, DIV0, "#REF!", "#NAME?")


@dataclass(frozen=True)
class Case:
    """A call with its arguments and what must come of it: a number within a tolerance, or an error.

    An argument is a number, a text (a formula if it begins with =), None for an empty cell, or rows of these
    for a range. ``inline`` cases have the arguments in the formula itself instead of in cells.
    """

    function: str
    arguments: tuple
    expected: float | str
    tolerance: float = 1e-12
    inline: bool = False

    @property
    def name(self):
        return f"MOTION.{self.function}({', '.join(str(a) for a in self.arguments)})"[:200]

    @property
    def law(self):
        """The code of the law, if the function takes one."""
        return str(self.arguments[0]).strip().upper()

    def agrees(self, found):
        """Whether a cell's value is what is expected."""
        if isinstance(self.expected, str):
            return found in ERRORS if self.expected == ANY_ERROR else found == self.expected
        return isinstance(found, int | float) and abs(found - self.expected) <= self.tolerance


def literal(argument):
    """An argument as it is written in a formula."""
    if isinstance(argument, tuple):
        return "{" + ";".join(",".join(literal(v) for v in row) for row in argument) + "}"
    if isinstance(argument, str):
        return argument[1:] if argument.startswith("=") else f'"{argument}"'
    return "" if argument is None else repr(argument)


def laid_out(cases, sheet="Data"):
    """Return the formula of each case (without =), and the cells of ``sheet`` that they refer to.

    Equal arguments share their cells.
    """
    formulas, cells, places, row = [], {}, {}, 1
    for case in cases:
        parts = []
        for argument in case.arguments:
            if case.inline:
                parts.append(literal(argument))
                continue
            key = (type(argument), argument)
            if key not in places:
                rows = argument if isinstance(argument, tuple) else ((argument,),)
                for i, values in enumerate(rows):
                    for k, value in enumerate(values):
                        cells[row + i, k + 1] = value
                places[key] = reference(sheet, row, len(rows), len(rows[0]))
                row += len(rows)
            parts.append(places[key])
        formulas.append(f"MOTION.{case.function}({','.join(parts)})")
    return formulas, cells


def reference(sheet, row, rows, columns):
    first, last = f"A{row}", f"{get_column_letter(columns)}{row + rows - 1}"
    return f"{sheet}!{first}" if first == last else f"{sheet}!{first}:{last}"


def write(cases, path):
    """Write a workbook with the case of number k in cell A(k + 1) of the sheet Cases."""
    book = openpyxl.Workbook()
    asked, data = book.active, book.create_sheet("Data")
    asked.title = "Cases"
    formulas, cells = laid_out(cases)
    for row, formula in enumerate(formulas, 1):
        asked.cell(row, 1, f"={formula}")
    for (row, column), value in cells.items():
        data.cell(row, column, value)
    book.save(path)


def read(path):
    """Return the cached values of the cases, in order."""
    sheet = openpyxl.load_workbook(path, data_only=True)["Cases"]
    return [row[0] for row in sheet.iter_rows(max_col=1, values_only=True)]
