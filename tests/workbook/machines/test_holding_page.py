"""The example of the page on holding torque, η at standstill and no-load torque: its figures in the cells."""

import re
import tomllib
from pathlib import Path

import pytest

from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine import TEMPLATE
from workbook.reading.descriptions import make_machine

PAGE = (Path(__file__).parents[3] / "docs/holding.md").read_text(encoding="utf-8")
BELT = {"teeth_driver": 20.0, "teeth_driven": 40.0, "efficiency": 0.95, "friction_torque": 0.2}


def hoist(stages=(), back=None, holding="motor"):
    """The cells of the page's machine, with other stages, another efficiency backward, another holder."""
    data = tomllib.loads(re.search(r"```toml\n(.*?)```", PAGE, re.DOTALL)[1])
    axis = data["axes"][0]
    axis["mechanism"]["back_efficiency"], axis["stages"] = back, list(stages)
    axis["motor"] |= {"holding": holding, "brake": {"torque": 1.0}}
    machine = make_machine(TEMPLATE, data, str)
    assert disagreeing(TEMPLATE, machine)[0] == []
    return computed(TEMPLATE, machine)


def at(value, column, way):
    """What a column has in the middle of the uniform part of a movement, or at rest."""
    rows = zip(value("drive1_pt", column), value("drive1_pt", "dir"), value("drive1_pt", "a"), strict=True)
    return next(figure for figure, going, a in rows if going == way and abs(a) < 1e-9)


@pytest.fixture(scope="module")
def figures():
    """Each figure that the page's table names, from the cells."""
    bare, belt, braked = hoist(), hoist([BELT]), hoist(holding="brake")
    assert bare("drive1_t_hold") == pytest.approx(at(bare, "T", 0), rel=1e-12)
    assert (braked("drive1_t_hold"), at(braked, "T", 0)) == (0.0, 0.0)
    assert at(braked, "S", 0) == pytest.approx(at(bare, "S", 0), rel=1e-12)
    return {
        "T_1 at rest": at(bare, "S", 0), "T_h": bare("drive1_t_hold"), "T upwards, uniform": at(bare, "T", 1),
        "T_1 downwards, uniform": at(bare, "S", -1), "T downwards, uniform": at(bare, "T", -1),
        "power that holding takes": 1000.0 * at(bare, "P", 0), "T_B, held by a brake": braked("drive1_brake_load"),
        "T_h of a screw that locks itself, η_2′ = 0": hoist(back=0.0)("drive1_t_hold"),
        "T_h with a belt of 20 : 40 teeth, η_s = 0.95, T_f,s = 0.2 Nm": belt("drive1_t_hold"),
        "T upwards, uniform, with that belt": at(belt, "T", 1),
    }  # fmt: skip


def printed():
    """The page's figures with their decimals."""
    rows = re.findall(r"^\| ([^|]+?) \| [^|]+ \| (−?[\d.]+) \w+ \|$", PAGE, re.MULTILINE)
    return {what: (float(text.replace("−", "-")), len(text.partition(".")[2])) for what, text in rows}


def test_the_page_prints_what_the_cells_compute(figures):
    assert set(printed()) == set(figures)
    for what, (value, decimals) in printed().items():
        assert figures[what] == pytest.approx(value, abs=0.51 * 10.0**-decimals), what
