"""The witnesses by name, each loaded where it is needed; the slowest before the reader of saved results."""

from __future__ import annotations

import platform
from collections.abc import Callable
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING

from workbook.errors import WitnessError

if TYPE_CHECKING:
    from workbook.witnesses.witness import Witness

ALL = "all"  # all of them that are on this machine


def load_witness(module: str, name: str) -> Witness:
    """Return a new witness of a module and class; raise WitnessError where what it rests on cannot be loaded."""
    try:
        witness: Witness = getattr(import_module(f"workbook.witnesses.{module}"), name)()
    except Exception as error:  # of a package that is broken, anything
        python = platform.python_version()
        raise WitnessError(f"{name} cannot be loaded by Python {python}: {type(error).__name__}: {error}") from error
    return witness


WITNESSES: dict[str, Callable[[], Witness]] = {
    "pycel": partial(load_witness, "pycel.model", "Pycel"),
    "formulon": partial(load_witness, "engines", "Formulon"),
    "ironcalc": partial(load_witness, "engines", "IronCalc"),
    "libreoffice": partial(load_witness, "engines", "LibreOffice"),  # the slowest
    "saved": partial(load_witness, "engines", "Saved"),
}
