"""A book changed as programs, scripts and attackers change it: by its parts, and by its cells."""

import re
import zipfile
from pathlib import Path

import openpyxl
import pytest

from workbook.errors import ReadError
from workbook.judging.display.cells import check_display
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.reading.entries import Entries
from workbook.reading.files import open_book
from workbook.witnesses.agreement import agreed_values

WORKBOOK, TYPES, STYLES = "xl/workbook.xml", "[Content_Types].xml", "xl/styles.xml"
LINKS, STRINGS = "xl/_rels/workbook.xml.rels", "xl/sharedStrings.xml"


def repacked(book, path, changes=None, extra=()):
    """A copy of a book with parts changed by functions of their bytes, and parts added."""
    changes = changes or {}
    with zipfile.ZipFile(book) as old, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as new:
        left = set(changes)
        for name in old.namelist():
            data = old.read(name)
            if name in changes:
                data, before = changes[name](data), data
                assert data != before, f"nothing changed in {name}"
                left.discard(name)
            new.writestr(name, data)
        for name, data in extra:
            new.writestr(name, data)
    assert not left, left
    return path


def sub(pattern, new, count=1):
    """A change that must find what it changes."""

    def change(data):
        changed, found = re.subn(pattern, new, data, count=count, flags=re.DOTALL)
        assert found
        return changed

    return change


def refused(path):
    """The line by which a file is refused, behind its name."""
    with pytest.raises(ReadError) as caught:
        open_book(path)
    line = str(caught.value)
    assert line.startswith(f"{path}: ")
    assert "\n" not in line
    return line.removeprefix(f"{path}: ")


class Known:
    """A built book, and where its declared cells stand."""

    def __init__(self, path: Path):
        self.path = path
        self.file = open_book(path)
        entries = Entries(self.file, agreed_values)
        self.template, self.machine = entries.template, entries.machine()
        self.declared = self.template.declare(self.machine)
        self.match = Match(self.file, self.declared)

    def pairs(self, wanted=lambda pair: True):
        return [pair for pair in self.match.pairs if wanted(pair)]

    def a_number(self, role="result", n=0):
        """A formula cell with a number that is not 0."""
        return self.pairs(
            lambda p: p.declared_formula and p.cell.quantity.role == role and isinstance(p.cell.expected, float)
            and abs(p.cell.expected) > 1e-3
        )[n]  # fmt: skip

    def place(self, block, row=0, column=0):
        return self.file.places[block].cell(row, column)

    def part(self, title):
        """The part of a sheet."""
        return f"xl/worksheets/sheet{self.file.workbook.sheetnames.index(title) + 1}.xml"

    def changed(self, path, address, pattern, new):
        """A copy with something replaced within one cell's XML."""

        def change(data):
            cell = re.search(rb'<c r="%s"[ >].*?(?:</c>|/>)' % address.a1.encode(), data, re.DOTALL)[0]
            other, count = re.subn(pattern, new, cell, flags=re.DOTALL)
            assert count == 1, cell
            return data.replace(cell, other)

        return repacked(self.path, path, {self.part(address.sheet): change})

    def seen(self, path):
        """What is told of how a file looks; all else of verifying takes ten times as long."""
        report = Report(path, self.template.name)
        check_display(Match(open_book(path), self.declared), type(self.machine), {}, report)
        return report

    def opened(self):
        return openpyxl.load_workbook(self.path)


def at(finding):
    return f"{finding.sheet}!{finding.cell}"


def spot(address):
    return f"{address.sheet}!{address.a1}"
