"""What the command prints of the laws: its keys stay, names elsewhere are whole."""

from rich.console import Console

from engine.laws import CATALOGUE
from workbook.reports.console import FIGURES, VENDORS, catalogue, show_catalogue


def printed(width: int) -> str:
    console = Console(width=width)
    with console.capture() as captured:
        show_catalogue(console)
    return captured.get()


def test_the_keys_are_those_of_old_and_what_each_law_costs() -> None:
    for row in catalogue():
        assert {"code", "name", "aliases", "source", *FIGURES} <= {*row}
        assert abs(row["C_a,rms²/12"] * 12 - row["C_a,rms"] ** 2) <= 1e-14 * row["C_a,rms"] ** 2
    assert [row["code"] for row in catalogue()] == [entry.code for entry in CATALOGUE]


def test_all_of_each_name_is_printed_on_a_wide_terminal_and_none_is_cut_on_a_narrow_one() -> None:
    wide, narrow = printed(200), printed(80)
    for row in catalogue():
        for name in filter(None, row["names"].values()):
            assert name in wide
    assert "…" not in narrow.partition("Names elsewhere")[2]
    assert all(heading in wide for heading in (*FIGURES, *VENDORS.values(), "smooth at ends"))
