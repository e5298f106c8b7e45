"""Pictures: what is drawn is where its numbers are, on axes whose figures are round."""

from xml.etree.ElementTree import Element, fromstring

import numpy as np
import pytest

from workbook.reports.html import HEIGHT, LEFT, RIGHT, WIDTH, Line, plot, scale


def read(svg: str) -> Element:
    """The elements of a picture, without their name space."""
    return fromstring(svg.replace("xmlns=", "data-xmlns="))


def test_powers_of_ten_are_equal_steps() -> None:
    axis = scale(np.array([0.02, 300.0]), 0.0, 5.0, True)
    assert axis.at(np.array([0.01, 1.0, 1000.0])) == pytest.approx([0.0, 2.0, 5.0])
    assert axis.ticks == pytest.approx([0.01, 0.1, 1.0, 10.0, 100.0, 1000.0])


@pytest.mark.parametrize(("low", "high"), [(0.0, 360.0), (-1.3, 4.4), (0.0, 0.3), (5.0, 5.0), (-1e6, 1e6)])
def test_figures_of_an_axis_are_round_and_on_it(low: float, high: float) -> None:
    axis = scale(np.array([low, high]), 0.0, 1.0, False)
    assert 2 <= len(axis.ticks) <= 8
    assert all(axis.low - 1e-9 <= tick <= axis.high + 1e-9 for tick in axis.ticks)


def test_lines_stay_within_the_picture_and_names_apart() -> None:
    x = np.linspace(0.0, 10.0, 5)
    words = plot(
        "A & B <", ("x", "y"), [Line(f"line {k}", x, x * 0.0 + 1.0 + k * 1e-3) for k in range(5)] + [Line("z", x, x)]
    )
    svg = read(words)
    for line in svg.iter("polyline"):
        places = np.array([[float(one) for one in pair.split(",")] for pair in line.get("points", "").split()])
        assert np.all((places[:, 0] >= LEFT) & (places[:, 0] <= WIDTH - RIGHT))
        assert np.all((places[:, 1] >= 0) & (places[:, 1] <= HEIGHT))
    names = [float(text.get("y", "")) for text in svg.iter("text") if (text.text or "").startswith("line")]
    assert np.all(np.diff(np.sort(names)) >= 12.0)
    assert "A &amp; B &lt;" in words
    with pytest.raises(ValueError, match="no lines"):
        plot("", ("", ""), [])
