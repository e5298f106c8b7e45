"""The names of the witnesses, which the command knows before it loads any, are theirs."""

from workbook.witnesses.names import ALL, NAMES
from workbook.witnesses.registry import WITNESSES


def test_each_name_has_its_witness() -> None:
    assert tuple(WITNESSES) == NAMES
    assert all(make().name == name for name, make in WITNESSES.items())
    assert ALL not in NAMES
