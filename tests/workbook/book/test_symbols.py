"""A symbol stands for one thing on the sheets of a machine; power has one unit."""

import re
from collections import defaultdict

import pytest

from workbook.book.rows import as_rows
from workbook.build import committed_descriptions
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


ALIKE = {
    "mm": "m",
    "m/min": "m/s",
    "kWh": "J",
    "MWh": "J",
    "ms": "s",
    "kg cm²": "kg m²",
    "h": "s",
    "1/min": "rpm",
    "cycles/min": "rpm",
}
"""units of one kind of quantity"""
OF_AXES = frozenset([
    "A", "F", "c0", "c1", "c2", "c3", "c4", "c5", "h", "j", "j_max", "y", "y'", "y''", "y'''", "y_0", "ÿ", "ÿmax",
    "ÿrms", "Δy", "δ", "ω", "ẏ", "ẏmax",
])  # fmt: skip
"""what an axis has in m or in rad, and over a master that turns, travels or counts seconds"""
SCALED = frozenset(["s", "u"])
"""of a law's motion without units, and of the tool's"""
LAWS = frozenset(["Laws", "Inverse", "S-curve", "ACS", "CIC", "CUB", "LIN", "MSN", "MTP", "OWN", "PO5", "TVP"])
"""sheets of laws without units, with symbols of their own"""


def kind(unit, symbol):
    """What a unit measures; of a quantity of axes, how often it has a length or an angle."""
    found = ALIKE.get(unit, unit).replace("mm", "m").replace("°", "rad")
    return re.sub(r"rad|m|s|N", "_", found.partition(",")[0]).replace("__", "_") if symbol in OF_AXES else found


@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
def test_a_symbol_measures_one_kind_of_quantity_and_power_has_one_unit_in_every_book(path):
    """Power has no more than three digits before its point."""
    book = TEMPLATES[read_machine(path).template].declare(read_machine(path))
    kinds = defaultdict(lambda: defaultdict(set))
    for block in book.blocks.values():
        for q in block.quantities if block.sheet.title not in LAWS else ():
            if q.symbol and (q.unit or q.symbol not in SCALED):
                kinds[q.symbol][kind(q.unit, q.symbol)].add(f"{q.label} [{q.unit}]")
    assert {symbol: dict(found) for symbol, found in kinds.items() if len(found) > 1} == {}
    powers = [(block, q) for block in book.blocks.values() for q in block.quantities if q.unit in {"W", "kW", "MW"}]
    assert len({q.unit for _, q in powers}) <= 1
    values = (value for block, q in powers for value in as_rows(q.value, block.size, q.name) if value is not None)
    assert max(map(abs, values), default=0.0) < 1000
