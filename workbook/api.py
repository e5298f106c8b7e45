"""The public names for templates of your own: what stays as it is within a minor version.

``motionbook new-template NAME`` writes a package that uses them; docs/own-templates.md explains each.
"""

from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, check, constant, given, result
from workbook.book.sentence import amount, exceeding
from workbook.book.summary import summary_sheet
from workbook.build import build
from workbook.entries.machine import Machine, Sizes
from workbook.entries.rules import limits
from workbook.fields.texts import Text
from workbook.fields.types import Angle, MakesCells, Model, NotNegative, Number, Positive, Share
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine
from workbook.template import Template, finish

__all__ = [
    "Angle", "Book", "Chart", "Machine", "MakesCells", "Model", "NotNegative", "Number", "Positive", "Series", "Share",
    "Sheet", "Sizes", "Template", "Text", "amount", "build", "calc", "check", "constant", "exceeding", "finish",
    "given", "limits", "read_machine", "result", "summary_sheet", "verify",
]  # fmt: skip
