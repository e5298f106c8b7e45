"""The cutting machine of S1, three axes and one drive: the book that many tests take for a typical one."""

from tests.mutation.bench import smaller
from workbook.machines.machine.entries import AnyMachine
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]
DESCRIPTION, BOOK = FOLDER / "cutting-machine.toml", FOLDER / "cutting-machine.xlsx"


def described() -> AnyMachine:
    """Return the machine."""
    return read_machine(DESCRIPTION)


def small(**sizes: int) -> AnyMachine:
    """Return it with smaller tables, and some products of its catalogues."""
    return smaller(described(), **sizes)


def too_weak() -> AnyMachine:
    """Return it in tables that are smaller still, with a motor too weak: checks of the drive FAIL."""
    data = small(cycle=12, law=4).model_dump()
    data["axes"][0]["motor"]["peak_torque"] = data["axes"][0]["motor"]["rated_torque"] = 0.01
    return TEMPLATE.model.model_validate(data)
