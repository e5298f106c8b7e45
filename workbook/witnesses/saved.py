"""The saved values: what Excel, LibreOffice or motionbook computed when the file was last saved."""

from workbook.errors import WitnessError
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.witness import Witness


class Saved(Witness):
    """Reads the results that stand in the file."""

    name = "saved"
    kept = True

    def version(self) -> str | None:
        """Return what the witness reads; it has no program of its own."""
        return "values in the file"

    def values(self, file: BookFile) -> Cells:
        """Return the saved value of every formula cell; raise WitnessError where the file has none."""
        if all(value is None for value in file.saved.values()):
            raise WitnessError("the file holds no saved values; open it in Excel or LibreOffice and save it")
        return file.saved
