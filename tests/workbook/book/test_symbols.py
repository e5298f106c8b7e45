"""A symbol stands for one thing on the sheets of a machine."""

import pytest

from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

ONE = {
    "T_max": {"Nm"}, "T_M,max": {"Nm"}, "T_N": {"Nm"}, "T_rms": {"Nm"}, "n": {"rpm"}, "n_max": {"rpm"},
    "n_M,max": {"rpm"}, "N": {"cycles/min"}, "N_max": {"cycles/min"}, "θ": {"°"}, "γ": {"°"}, "P": {"kW"},
    "J_G": {"kg cm²", "kg m²"}, "J_m": {"kg cm²", "kg m²"}, "J_0": {"kg m²"}, "J_p": {"kg m²"}, "P_h": {"mm"},
}  # fmt: skip
LIMITS = {"T_M,max": "peak torque", "n_M,max": "largest speed"}
"""of a motor: what a cycle asks for has other symbols"""
SHEETS = ("Summary", "Timing", "Drive", "Power", "Selection", "Catalogue")


@pytest.mark.parametrize("name", ["machine", "machine-linkages"])
def test_a_symbol_stands_for_one_quantity(name):
    machine = read_machine(FOLDER / f"{name}.toml")
    book = TEMPLATES["machine"].declare(machine)
    shown = [q for block in book.blocks.values() if block.sheet.title.startswith(SHEETS) for q in block.quantities]
    units = {symbol: {q.unit for q in shown if q.symbol == symbol} for symbol in ONE}
    assert {symbol: found for symbol, found in units.items() if not found <= ONE[symbol]} == {}
    assert "J_1" not in {q.symbol for q in shown}
    assert [q.label for q in shown if q.symbol in LIMITS and LIMITS[q.symbol] not in q.label] == []
