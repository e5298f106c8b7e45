"""The cutting machine's book: S1's figures in its cells, every formula cell with an engine value, both agree.

S1 prints the movements at 200 pieces a minute and the drive at 100: so does the book, its drive at a rate of its own.
"""

import math
from pathlib import Path

import pytest

from tests import cutting
from tests.cutting import TEMPLATE
from tests.workbook.cells import computed
from workbook.build import build
from workbook.judging.verify import verify

MOVEMENTS, DRIVE = 200.0, 100.0
"""pieces/min that S1 prints its movements at, and its drive"""
BARE = {
    "motor": {"inertia": 0.0, "rated_torque": 60.0, "peak_torque": 160.0, "max_speed": 3000.0},
    "reducer": {"ratio": 1.0, "efficiency": 1.0},
}
"""S1's feeding group without motor and reducer: J_m = 0, τ = 1, η = 1"""


def described(rate=DRIVE, laws=("MTP", "MTP", "MTP"), selection=None, **feed):
    """The machine in small tables at a rate, with a law for the movements of each axis, and other entries of its feed.

    Without a sheet Selection, unless an axis is named for it.
    """
    data = cutting.small(cycle=12, law=4).model_dump()
    data["master"]["rate"] = rate
    data["selection"] = {name: data["selection"][name] for name in ("motors", "reducers")} | {"axis": selection}
    data["axes"][0] |= {"rate": None, "smoothness": "acceleration"} | feed
    for axis, law in zip(data["axes"], laws, strict=True):
        for phase in axis["phases"]:
            phase["law"] = law if phase["lift"] else "DWL"
    return TEMPLATE.model.model_validate(data)


def feeding(law):
    """The same with a law for the feed alone."""
    return law, "MTP", "MTP"


def test_s1_constant_acceleration_shows_the_printed_figures():
    """S1: 0.43 m/rad, 0.61 m/rad², 9 m/s, 270 m/s² for MC01 with C_a = 4."""
    value = computed(TEMPLATE, described(MOVEMENTS, feeding("ACS")))
    assert round(value("axis1", "y1")[0], 2) == 0.43
    assert math.floor(value("axis1", "y2")[0] * 100) / 100 == 0.61  # S1 cuts 0.6155 off instead of rounding it
    assert value("axis1", "v")[0] == pytest.approx(9.0, rel=1e-12)
    assert value("axis1", "a")[0] == pytest.approx(270.0, rel=1e-12)


@pytest.mark.parametrize(
    ("law", "y1", "y2", "v", "a"),
    [
        ("ACS", 0.42972, 0.61553, 9.0000, 270.000),
        ("TVP", 0.32229, 0.69247, 6.7500, 303.750),
        ("CUB", 0.32229, 0.92329, 6.7500, 405.000),
        ("CIC", 0.42972, 0.96687, 9.0000, 424.115),
        ("MTP", 0.42972, 0.75219, 9.0000, 329.948),
    ],
)
def test_s1_mc01_rise(law, y1, y2, v, a):
    value = computed(TEMPLATE, described(MOVEMENTS, feeding(law)))
    got = [value("axis1", name)[0] for name in ("y1", "y2", "v", "a")]
    assert got == [pytest.approx(x, abs=5e-6 if x < 1 else 5e-4) for x in (y1, y2, v, a)]


def test_s1_movements_with_the_modified_trapezoidal_law():
    value = computed(TEMPLATE, described(MOVEMENTS))
    v2, a2, v3, a3 = value("axis2", "v"), value("axis2", "a"), value("axis3", "v"), value("axis3", "a")
    assert (v2[1], a2[1], v2[3], a2[3]) == pytest.approx((1.0667, 69.520, 1.0667, 69.520), abs=5e-4)
    assert (v3[1], a3[1], v3[3], a3[3]) == pytest.approx((2.4000, 87.986, 3.2000, 156.420), abs=5e-4)


@pytest.mark.parametrize(
    ("law", "dw", "highest", "lowest"),
    [
        ("ACS", 503.7313, 653.3433, -519.3433),
        ("MTP", 615.5753, 783.5297, -649.5297),
        ("CIC", 791.2593, 988.0259, -854.0259),
    ],
)
def test_s1_torque_at_the_roller_shaft(law, dw, highest, lowest):
    value = computed(TEMPLATE, described(laws=feeding(law), **BARE))
    assert value("drive1_jtot") == pytest.approx(11640.0, abs=1e-8)
    assert value("drive1_parts", "all")[:2] == pytest.approx([4 * 2840, 4 * 70], rel=1e-12)
    assert value("drive1_steady") / value("drive1_i2") == pytest.approx(67, abs=1e-12)
    assert value("axis1", "a")[0] * value("drive1_i2") == pytest.approx(dw, abs=5e-5)
    assert (value("drive1_tmax"), value("drive1_tmin")) == pytest.approx((highest, lowest), abs=1e-4)
    assert value("drive1_speed") == pytest.approx(320.685, abs=5e-4)


def test_s1_rms_torque_at_the_roller_shaft():
    """C_m,rms² = (J_tot ω̇_rms)² · 80/360 + C_r²: the rise takes what it gives back; C_a,rms of S1's law 4.233239."""
    value = computed(TEMPLATE, described(**BARE))
    inertial = 1.164 * 4.233239 * 0.3 / 0.134 / (0.6 * 80 / 360) ** 2
    assert value("drive1_rms") == pytest.approx(math.hypot(inertial * math.sqrt(80 / 360), 67.0), rel=2e-7)


def test_s1_equation_of_the_motors_torque():
    """C_m = (J_m/τ) ω̇_r + τ (C_r + J_tot ω̇_r), with our motor and reducer; its efficiency counts while it drives."""
    value = computed(TEMPLATE, described())
    accelerated = value("axis1", "a")[0] / 0.134
    assert value("drive1_tmax") == pytest.approx(
        0.0065 * 8 * accelerated + (67.0 + 1.164 * accelerated) / 8 / 0.95, rel=1e-12
    )


def test_the_committed_book_shows_the_figures_of_s1_without_edits():
    """S1: 9 m/s and 270 m/s² at 200 a minute; J_tot = 1.164 kg m², C_r = 67 Nm and the equation of C_m at 100."""
    book = TEMPLATE.declare(cutting.described())

    def figure(name, column=None):
        return next(q.value for q in book.blocks[name].quantities if column in (None, q.name))

    assert [figure("axes", "vc")[0], figure("axes", "ac")[0]] == pytest.approx([9.0, 270.0], rel=1e-12)
    assert (figure("timing_compared"), figure("drive1_rate")) == (MOVEMENTS, DRIVE)
    assert (figure("drive1_j_shaft"), figure("drive1_cr")) == pytest.approx((1.164, 67.0), rel=1e-12)
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
    assert verify(tmp_path / "book.xlsx", ["pycel", "formualizer"]).findings == []
