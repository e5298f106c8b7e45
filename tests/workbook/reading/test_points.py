"""Charts are read without the points that they were saved with, and with all else."""

import zipfile

import pytest

from workbook.reading.files import open_book
from workbook.reading.package import without_cached_points
from workbook.reading.rows import tag
from workbook.template import FOLDER

BOOK = FOLDER / "motion-composer.xlsx"


@pytest.mark.parametrize("prefix", ["", "c:"])
def test_points_are_left_out_and_nothing_else(prefix):
    point = f'<{prefix}pt idx="0"><{prefix}v>1.5</{prefix}v></{prefix}pt>'
    around = (
        f"<{prefix}numRef><{prefix}f>A!$B$1:$B$2</{prefix}f><{prefix}numCache>%s</{prefix}numCache></{prefix}numRef>"
    )
    whole, left = (around % (point * 2)).encode(), (around % "").encode()
    assert without_cached_points("xl/charts/chart1.xml", whole) == left
    assert without_cached_points("xl/worksheets/sheet1.xml", whole) == whole


def test_a_book_s_charts_keep_their_series_and_come_without_points():
    with zipfile.ZipFile(BOOK) as archive:
        assert b"<pt " in archive.read("xl/charts/chart1.xml")
    drawings = [one for held in open_book(BOOK).inspected.drawings.values() for one in held]
    found = [[tag(one) for one in drawing.chart.iter()] for drawing in drawings if drawing.chart is not None]
    assert len(found) > 3
    assert all("ser" in tags and "f" in tags and "pt" not in tags for tags in found)
