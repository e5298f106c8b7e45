"""The largest machine can be verified; a workbook too large for that is not built, and nothing is lost."""

import pytest

from benchmarks.scale import of_axes
from workbook import build as building
from workbook.build import InputError, build
from workbook.reading import guard, rows

LIMITS = {
    (guard, "MOST_PACKED"): "a workbook of at most",
    (guard, "MOST_UNPACKED"): "unpacks to more than",
    (rows, "MOST_PLACES"): "its cells reach over",
    (rows, "MOST_CELLS"): "its cells reach over",
    (rows, "MOST_FORMULAS"): "its formulas have more than",
}


@pytest.mark.nightly
def test_a_machine_of_24_axes_with_drives_can_be_read(tmp_path):
    build(of_axes(24), tmp_path / "book.xlsx")
    rows = guard.guard(tmp_path / "book.xlsx").sheets.values()
    assert sum(len(sheet.written) for sheet in rows) > 250_000


@pytest.mark.parametrize(("where", "said"), LIMITS.items(), ids=[name for _, name in LIMITS])
@pytest.mark.sample(2)
def test_what_verify_would_not_read_is_not_built(where, said, monkeypatch, tmp_path):
    path = tmp_path / "book.xlsx"
    path.write_bytes(b"an engineer's own")
    monkeypatch.setattr(building, "LARGE", 0)
    monkeypatch.setattr(*where, 1_000)
    with pytest.raises(InputError, match=f"sizes: too large .* to be verified: .*{said}.*expected fewer samples"):
        build(of_axes(1), path, overwrite=True)
    assert [kept.name for kept in tmp_path.iterdir()] == ["book.xlsx"]
    assert path.read_bytes() == b"an engineer's own"
