"""What the terminal shows of findings: causes first and whole, what follows from them counted by sheet."""

from pathlib import Path

from rich.console import Console

from workbook.judging.report import FOLLOWS, Finding, Report
from workbook.reports.console import MOST, differing_middles, show_report


def printed(findings: list[Finding], everything: bool = False) -> str:
    console = Console(width=200)
    with console.capture() as captured:
        show_report(Report(Path("book.xlsx"), "machine", findings=findings), console, everything)
    return captured.get()


def findings(kind: str, sheet: str, number: int) -> list[Finding]:
    return [Finding(sheet, f"{sheet[0]}{i}", kind, 1.0, 2.0) for i in range(1, number + 1)]


MIXED = [*findings("formula", "Timing", 1), *findings(FOLLOWS, "Timing", 50), *findings(FOLLOWS, "Drive", 7)]


def test_what_follows_is_counted_by_sheet() -> None:
    said = printed(MIXED)
    assert "Timing!T1 " in said
    assert "Timing!T2 " not in said
    assert "wrong only because of these: 50 on Timing, 7 on Drive; --all lists them" in said
    assert "1 finding; 57 cells are wrong only because of it" in said


def test_of_two_long_formulas_the_difference_is_shown() -> None:
    expected = "=1/(MTP_sa+MTP_m*MTP_d4+MTP_m*MTP_sd/MTP_n)+MTP_ca_max*(MTP_k*MTP_d1+MTP_d2)"
    found = expected.replace("MTP_d4", "MTP_d5")
    said = printed([Finding("MTP", "D20", "formula", found, expected)])
    assert "…+MTP_m*MTP_d5+MTP_m*MTP_s…" in said
    assert "…+MTP_m*MTP_d4+MTP_m*MTP_s…" in said
    assert differing_middles(expected + "*1.001", expected) == ("…MTP_d1+MTP_d2)*1.001", "…MTP_d1+MTP_d2)")
    assert differing_middles("=A1+1", "=A1+2") == ("=A1+1", "=A1+2")
    repeated = "=" + "+".join(["A1"] * 30)
    assert differing_middles(repeated + "+A1", repeated) == ("…+A1+A1+A1+A1+A1", "…+A1+A1+A1+A1")


def test_all_of_them_are_listed_where_they_are_asked_for() -> None:
    said = printed(MIXED, everything=True)
    assert all(f"Timing!T{i} " in said for i in range(1, 51))
    assert "Drive!D7 " in said
    assert "--all" not in said


def test_of_many_causes_the_first_are_listed_and_the_others_counted() -> None:
    said = printed(findings("formula", "Timing", MOST + 3))
    assert f"Timing!T{MOST} " in said
    assert f"Timing!T{MOST + 1} " not in said
    assert "… and 3 more; --all lists them" in said


def test_what_follows_is_listed_where_no_cause_is_known() -> None:
    assert "Drive!D2 " in printed(findings(FOLLOWS, "Drive", 2))
