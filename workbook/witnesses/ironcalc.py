"""IronCalc, a spreadsheet engine in Rust; optional to install."""

from workbook.errors import WitnessError
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.witness import Witness, bare

LANGUAGE, ZONE = "en", "UTC"


class IronCalc(Witness):
    """Loads the file, evaluates every formula, and reads the results."""

    name = "ironcalc"

    def values(self, file: BookFile) -> Cells:
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
