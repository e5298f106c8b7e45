"""Where the cells of a block are, one by one and down a column."""

import pytest

from workbook.book.address import Place


@pytest.mark.parametrize("place", [
    Place("S", 7, 3, 4, 2),
    Place("S", 7, 3, 3, 2, rows_at=(0, 2, 5)),
    Place("S", 7, 3, 3, 3, columns_at=(0, 1, 4)),
    Place("S", 7, 3, 3, 3, rows_at=(1, 2, 4), columns_at=(1, 2, 4)),
])  # fmt: skip
def test_a_column_has_the_cells_of_its_rows(place):
    for j in range(place.columns):
        assert place.down(j) == [place.cell(i, j) for i in range(place.rows)]
