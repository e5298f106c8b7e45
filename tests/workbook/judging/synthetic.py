"""A book of two sheets and some hundred cells, declared as those of machines are: its looks are judged in a blink."""

import math
import zipfile

import openpyxl
from pydantic import BaseModel, Field

from tests.workbook.judging.hands import repacked
from workbook.book.chart import Chart, Series
from workbook.book.checks import checks_sheet, repeat_verdicts
from workbook.book.declare import Book, Text, calc, check, constant, given, result
from workbook.judging.display.cells import check_display
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.reading.files import open_book
from workbook.writing.write import pack, parts

ROWS = 13
LED_TO = ("Checks", "Drive")  # by links of the same words
ANGLES = [30.0 * k for k in range(ROWS)]


class Given(BaseModel):
    """What is entered."""

    name: str = "Feed"
    rate: float = Field(default=60.0, gt=0)
    limit: float = 20.0


def declared(limit=20.0):
    """The book; with a limit below 12.6 Nm its check FAILs."""
    book = Book("synthetic", "Synthetic")
    omega = 2 * math.pi
    sheet = book.sheet("Drive", "A drive as small as can be.")
    sheet.heading("Entries")
    sheet.rows(
        given("name", "Name", "", "", "Feed", "name"),
        given("rate", "Rate", "f", "cycles/min", 60.0, "rate"),
        given("limit", "Torque of the motor", "T_lim", "Nm", limit, "limit"),
    )
    sheet.heading("Results")
    sheet.rows(
        calc("omega", "Speed", "ω", "rad/s", "=rate*2*PI()/60", omega),
        calc("speed", "Speed of the motor", "n", "rpm", "=rate*1", 60.0),
        result("peak", "Largest torque", "T_max", "Nm", "=2*omega", 2 * omega),
        result("least", "Least torque", "T_min", "Nm", "=0-omega", -omega, source="S1, page 3"),
        result("eta", "Efficiency", "η", "", "=0.9+0*rate", 0.9),
        result("which", "Name of the drive", "", "", '=name&""', "Feed"),
    )
    sheet.checks(
        check("within", "Torque within the motor's", "peak<limit", 2 * omega < limit),
        check("turns", "It turns", "rate>0", True),
    )
    sheet.texts += [Text(sheet.row, 9 + k, "to its sheet", "link", title) for k, title in enumerate(LED_TO)]
    sheet.row += 1
    sheet.table(
        "cycle", "Cycle", ROWS,
        constant("theta", "master angle", "θ", "°", ANGLES),
        result("y", "position", "y", "mm", "=[theta]*rate/60", ANGLES),
        result("v", "velocity", "v", "m/s", "=[y]/100-1", [y / 100 - 1 for y in ANGLES]),
        blank="[theta]>300",
    )  # fmt: skip
    lines = (Series("Position", "[cycle.theta]", "[cycle.y]"), Series("Velocity", "[cycle.theta]", "[cycle.v]"))
    both = Chart("Both", "master angle θ [°]", "y [mm]", lines, "Position and velocity", x_range=(0, 360, 60))
    one = Chart("Velocity alone", "master angle θ [°]", "v [m/s]", lines[1:], "Velocity")
    sheet.chart_row(both, one)
    checks_sheet(book)
    repeat_verdicts(book)
    return book


class Small:
    """The book as built, and changed copies of it."""

    def __init__(self, folder, limit=20.0):
        self.folder, self.book = folder, declared(limit)
        self.path = folder / "book.xlsx"
        pack(parts(self.book, Given), self.path)
        self.parts = {i.filename: zipfile.ZipFile(self.path).read(i) for i in zipfile.ZipFile(self.path).infolist()}

    def at(self, block, row=0, column=0):
        """Row and column of a cell of a block."""
        found = self.book.blocks[block]
        return found.row + row, found.column + column

    def seen(self, path):
        """What is told of how a file looks."""
        report = Report(path, "synthetic")
        check_display(Match(open_book(path), self.book), Given, {}, report)
        return report

    def edited(self, change):
        """What is told when a workbook is changed by openpyxl, its cells found by block."""
        workbook = openpyxl.load_workbook(self.path)
        change(workbook)
        workbook.save(self.folder / "edited.xlsx")
        return self.seen(self.folder / "edited.xlsx")

    def cell(self, workbook, block, row=0, column=0):
        """A cell of a block in a workbook."""
        sheet = self.book.blocks[block].sheet.title
        return workbook[sheet].cell(*self.at(block, row, column))

    def with_parts(self, changes, extra=()):
        """What is told when parts are changed by functions of their bytes."""
        return self.seen(repacked(self.path, self.folder / "changed.xlsx", changes, extra))


def spots(found):
    """Where something is told."""
    return {f"{one.sheet}!{one.cell}" for one in found}
