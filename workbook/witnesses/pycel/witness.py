"""pycel as one of the witnesses; what evaluates (:mod:`workbook.witnesses.pycel.model`) is loaded where it is asked."""

import sys
from importlib.metadata import version as package_version

from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.witness import Model


def version() -> str:
    """Return pycel's version."""
    return package_version("pycel")


class Pycel:
    """The witness of that name."""

    name = "pycel"
    kept = False

    def version(self) -> str | None:
        """Return pycel's version and Python's, on which it rests."""
        return f"{version()} (Python {sys.version_info.major}.{sys.version_info.minor})"

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        return self.model(file).evaluate()

    def model(self, file: BookFile) -> Model:
        """Return the formulas of a file, to be evaluated at other values, and cell by cell."""
        from workbook.witnesses.pycel.model import PycelModel

        return PycelModel(file.contents)
