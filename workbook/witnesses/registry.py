"""The witnesses by name; the slowest before the one that only reads."""

from collections.abc import Callable

from workbook.witnesses.formualizer import Formualizer
from workbook.witnesses.formulon import Formulon
from workbook.witnesses.ironcalc import IronCalc
from workbook.witnesses.libreoffice import LibreOffice
from workbook.witnesses.pycel.witness import Pycel
from workbook.witnesses.saved import Saved
from workbook.witnesses.witness import CellWitness, Witness

WITNESSES: dict[str, Callable[[], Witness]] = {
    "pycel": Pycel,
    "formualizer": Formualizer,
    "formulon": Formulon,
    "ironcalc": IronCalc,
    "libreoffice": LibreOffice,  # the slowest
    "saved": Saved,
}


def by_cell() -> CellWitness:
    """Return the first witness that evaluates each cell by itself too."""
    return next(w for w in (make() for make in WITNESSES.values()) if isinstance(w, CellWitness))
