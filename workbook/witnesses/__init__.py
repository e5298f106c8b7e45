"""Witnesses: independent ways to say what each formula cell of a workbook computes."""

from collections.abc import Callable

from workbook.witnesses.formualizer_witness import Formualizer
from workbook.witnesses.libreoffice_witness import LibreOffice
from workbook.witnesses.pycel_witness import Pycel
from workbook.witnesses.saved_witness import Saved
from workbook.witnesses.witness import Witness

WITNESSES: dict[str, Callable[[], Witness]] = {
    "pycel": Pycel,
    "formualizer": Formualizer,
    "libreoffice": LibreOffice,
    "saved": Saved,
}
