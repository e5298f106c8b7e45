"""IronCalc, a spreadsheet engine in Rust; optional to install."""

from importlib.metadata import PackageNotFoundError, version
from typing import Any

from workbook.book.address import Address
from workbook.errors import WitnessError
from workbook.reading.files import BookFile
from workbook.witnesses.bare import bare

LANGUAGE, ZONE = "en", "UTC"


class IronCalc:
    """Loads the file, evaluates every formula, and reads the results."""

    name = "ironcalc"
    kept = False

    def version(self) -> str | None:
        """Return the version of the package, or None where it is not installed."""
        try:
            return version("ironcalc")
        except PackageNotFoundError:
            return None

    def values(self, file: BookFile) -> dict[Address, Any]:
        """Return the value of every formula cell."""
        import ironcalc  # optional

        try:
            with bare(file) as copy:  # an empty cell with a style, and t="n" as openpyxl writes it, would be 0
                model = ironcalc.load_from_xlsx(str(copy.path), LANGUAGE, ZONE, LANGUAGE)
            model.evaluate()
        except Exception as error:  # what it cannot read comes up as any exception
            raise WitnessError(f"IronCalc cannot evaluate the file: {error}") from error
        numbers = {sheet["name"]: i for i, sheet in enumerate(model.get_worksheets_properties())}
        return {
            address: model.get_cell_value(numbers[address.sheet], address.row, address.column)
            for address in file.contents.formula_cells
        }
