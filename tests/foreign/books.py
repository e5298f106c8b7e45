"""Workbooks that nobody here wrote: where they are published, what is wrong in them, and how that is mended.

They are not part of this repository. The variable ``MOTIONBOOK_FOREIGN`` names a folder in which they lie; a file is
known by its hash.
"""

import hashlib
import os
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import openpyxl

HERE = Path(__file__).parent
VARIABLE = "MOTIONBOOK_FOREIGN"


@dataclass(frozen=True)
class Foreign:
    """A published workbook: its address, licence and hash, and what gives each formula as it should be."""

    name: str
    address: str
    licence: str
    sha256: str
    mended: Callable[[str, str, str], str]  # sheet, cell, formula
    kinds: dict[str, int]  # findings in the workbook as it was published, by kind

    @property
    def declarations(self) -> Path:
        """The file that declares it."""
        return HERE / f"{self.name}.py"

    @property
    def path(self) -> Path | None:
        """The file, None where it is not on this machine."""
        return files().get(self.sha256)

    def mend(self, target: Path) -> Path:
        """Write the workbook without its faults."""
        book = openpyxl.load_workbook(self.path)
        for sheet in book:
            for row in sheet.iter_rows():
                for cell in row:
                    if isinstance(cell.value, str) and cell.data_type == "f":
                        cell.value = self.mended(sheet.title, cell.coordinate, cell.value)
        book.save(target)
        return target


@cache
def files() -> dict[str, Path]:
    """Return the files of the folder by their hashes."""
    folder = os.environ.get(VARIABLE)
    found = sorted(Path(folder).rglob("*.xls[xm]")) if folder else []
    return {hashlib.sha256(path.read_bytes()).hexdigest(): path for path in found}


def stepper(sheet: str, cell: str, formula: str) -> str:
    """A coil's impedance is √(R² + X²); the rotor turns by the gear ratio faster than the pulley."""
    if sheet == "UI" and re.fullmatch("N(1[4-9]|2[0-9])", cell):
        return f"{formula}*$C$7"
    return f"=SQRT(F{cell[1:]}^2+$B$4^2)" if sheet != "UI" and formula.endswith("+$B$4") else formula


def cryostat(sheet: str, cell: str, formula: str) -> str:
    """The radiating surface has three plates; an empty cell was added."""
    return formula.replace("+F55", "")


def radiator(sheet: str, cell: str, formula: str) -> str:
    """Sunlight that the earth reflects is a share of the solar constant; half of Joule's heat flows back."""
    if (sheet, cell) == ("Sheet1", "B6"):
        return "=(B5+B3^2*B4/2)/B3"
    return formula.replace("*albedo*absorp*", "*solar*albedo*absorp*")


def receiver(sheet: str, cell: str, formula: str) -> str:
    """A stage of 0 dB is one: only a blank is none. All sheets have the temperature of reference from a cell."""
    return re.sub(r"IF\(([DE]\d+),", r"IF(ISNUMBER(\1),", formula).replace("290*", "General!$C$4*")


BOOKS = [
    Foreign(
        "stepper",
        "https://github.com/MSzturc/the100, Docs/motor_torque_sim_v9_database_updated.xlsm at 7f51196",
        "CC BY-NC-SA 4.0",
        "914f5b34acc3658f4451bad8d35d626381838987ae7491746adb81e5fa490c19",
        stepper,
        {"value": 150},
    ),
    Foreign(
        "cryostat",
        "https://github.com/CMB-S4/Cryogenic_Material_Properties, "
        "ThermalModelTools/Excel_Notebooks/Bluefors_LD400_Thermal_Model.xlsm at 228e540",
        "BSD 3-Clause",
        "7fe88550f4666424d0ea435b96a31570f3f9a861c2c6e35ad8a9bccb3d2dfb6f",
        cryostat,
        {},
    ),
    Foreign(
        "radiator",
        "https://github.com/oresat/oresat-thermal, calculations/OreSat-CFC-Workbook.xlsx at 00de2a7",
        "none is stated",
        "47623946065ad1af9d384a704b842d656ea06113466f208a43ef000c57bbc613",
        radiator,
        {"value": 509, "dimension": 429},
    ),
    Foreign(
        "receiver",
        "https://github.com/oresat/oresat-c3-rf, link-models/Friis_noise_temp_calculators.xlsx at 8c5ae7d",
        "MIT",
        "1432c6fe0c8c2a553e710c60ed936db75181fa66bd56f9bf41984486f9019a42",
        receiver,
        {"value": 104, "dimension": 9},
    ),
]
