"""What each template says of its axes: the motion of its view, in the units that an engineer enters."""

import numpy as np
import pytest

from engine.motion.profile import CamProfile
from workbook.fields.units import DEGREE, MM
from workbook.law_sheets.library import laws
from workbook.machines.flying.view import CutterView
from workbook.machines.overlap.view import OverlapView
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES


def described(name: str):
    machine = read_machine(FOLDER / f"{name}.toml")
    return machine, TEMPLATES[machine.template].axes(machine)


def same(profile: CamProfile, x: np.ndarray, expected, x_unit: float = 1.0, y_unit: float = 1.0) -> None:
    for order, (one, other) in enumerate(zip(profile.at(x), expected, strict=False)):
        meant = np.asarray(other) / y_unit * x_unit**order
        assert np.abs(one - meant).max() <= 1e-9 * max(np.abs(meant).max(), 1e-9), order


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.toml")), ids=lambda path: path.stem)
def test_every_motion_of_a_template_is_an_axis_with_a_name_of_its_own(path) -> None:
    _, axes = described(path.stem)
    assert len({axis.name for axis in axes}) == len(axes)
    for axis in axes:
        assert np.all(np.diff(axis.profile.edges) > 0.0)
        if axis.repeats:  # it comes back, or goes on by its travel
            begin, end = axis.profile.at(axis.profile.edges[:1]), axis.profile.at(axis.profile.edges[-1:], left=True)
            assert begin.y1 == pytest.approx(end.y1, abs=1e-9 * max(1.0, abs(axis.profile.travel)))


@pytest.mark.parametrize("name", ["flying-cutter", "flying-cutter-saw"])
def test_a_tool_goes_with_the_line_and_its_shaft_by_the_radius(name: str) -> None:
    machine, (tool, shaft) = described(name)
    view = CutterView(machine, laws(machine.laws))
    x = np.linspace(0.01, 0.99, 77) * view.cut.cycle_time
    same(tool.profile, x, view.cut.at(x), y_unit=MM)
    same(shaft.profile, x, [np.array(one) / view.tool.radius for one in view.cut.at(x)], y_unit=DEGREE)


@pytest.mark.parametrize("name", ["indexing-overlap", "indexing-overlap-stations"])
def test_a_tool_is_told_by_the_angle_of_the_master_shaft(name: str) -> None:
    machine, (transfer, *tools) = described(name)
    view = OverlapView(machine, laws(machine.laws))
    x = np.linspace(0.5, 359.5, 77)
    same(transfer.profile, x, [view.transfer.travel(x * DEGREE)], y_unit=MM)
    for axis, station in zip(tools, view.stations, strict=True):
        same(axis.profile, x, [station.as_set.travel(x * DEGREE), station.as_set.rates(x * DEGREE, 1.0)[0]
                              / (2.0 * np.pi)], DEGREE, MM)  # fmt: skip
