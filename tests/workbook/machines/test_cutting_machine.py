"""The cutting machine's book: S1's figures in its cells, every formula cell with an engine value, both agree.

S1 prints the movements at 200 pieces a minute and the drive at 100: so does the book, its drive at a rate of its own.
"""

from pathlib import Path

import pytest

from tests import cutting
from tests.cutting import TEMPLATE
from tests.workbook.cells import computed
from workbook.build import build
from workbook.judging.verify import verify

MOVEMENTS, DRIVE = 200.0, 100.0
"""pieces/min that S1 prints its movements at, and its drive"""


def described(**feed):
    """The machine in small tables at the rate of its drive, without Selection, with other entries of its feed."""
    data = cutting.small(cycle=12, law=4).model_dump()
    data["master"]["rate"] = DRIVE
    data["selection"] = {name: data["selection"][name] for name in ("motors", "reducers")}
    data["axes"][0] |= {"rate": None, "smoothness": "acceleration"} | feed
    return TEMPLATE.model.model_validate(data)


def test_s1_equation_of_the_motors_torque():
    """C_m = (J_m/τ) ω̇_r + τ (C_r + J_tot ω̇_r), with our motor and reducer; its efficiency counts while it drives."""
    value = computed(TEMPLATE, described())
    accelerated = value("axis1", "a")[0] / 0.134
    assert value("drive1_tmax") == pytest.approx(
        0.0065 * 8 * accelerated + (67.0 + 1.164 * accelerated) / 8 / 0.95, rel=1e-12
    )


def test_the_committed_book_shows_the_figures_of_s1_without_edits():
    """Its movements at 200 a minute and its drive at 100, with the equation of C_m; docs/validation.md has the rest."""
    book = TEMPLATE.declare(cutting.described())
    rates = [book.blocks[name].quantities[0].value for name in ("timing_compared", "drive1_rate")]
    assert rates == [MOVEMENTS, DRIVE]
    texts = [text for sheet in book.sheets if sheet.title == "Drive MC01" for text in map(str, sheet.texts)]
    assert any("C_m = J_m/τ ω̇ + τ (C_r + J_tot ω̇)" in text for text in texts)
    symbols = [q.symbol for block in book.blocks.values() for q in block.quantities]
    assert "J_tot" in symbols
    assert "J_1" not in symbols  # S1's is a roller's


def test_the_figures_of_docs_drive_sheet_are_those_of_the_committed_book():
    value = computed(TEMPLATE, cutting.described())
    page = (Path(__file__).parents[3] / "docs/drive-sheet.md").read_text(encoding="utf-8")
    shown = f"{value('drive1_tmax'):.1f} and −{-value('drive1_tmin'):.1f} Nm"
    assert shown in page
    assert f"{value('drive1_speed'):,.0f} rpm" in page
    assert f"√(Σ share · T²): {value('drive1_rms'):.3f} Nm" in page


def test_it_finds_a_pair_of_its_catalogues():
    value = computed(TEMPLATE, cutting.described())
    assert value("sel_motor") == "HDT BH20G (2000 rpm)"
    assert value("sel_reducer") == "Beckhoff AG2400 TP300 MF i=5"
    assert value("sel_usable") == 1
    assert value("overall") == "OK"


@pytest.mark.parametrize("radius", [1e-9, 1e-6, 1e-3])  # mm
@pytest.mark.parametrize("resists", ["always", "moving"])
@pytest.mark.sample(1)
def test_rollers_next_to_nothing_verify_clean(radius, resists, tmp_path):
    rollers = {"kind": "feed rollers", "roller_radius": radius, "efficiency": 1.0}
    force = {"windows": [{"start": 0.0, "stop": 360.0, "force": 500.0, "resists": resists}]}
    build(described(mechanism=rollers, load=force), tmp_path / "book.xlsx")
    assert verify(tmp_path / "book.xlsx", ["pycel", "formulon"]).findings == []
