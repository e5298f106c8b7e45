"""Columns of text as people hand them over: what can be meant in one way is read, the rest is refused in a line."""

import numpy as np
import pytest

from engine import law
from workbook.controllers import as_description
from workbook.controllers.registry import target
from workbook.controllers.target import read_table
from workbook.errors import MotionbookError

X = np.linspace(0.0, 360.0, 361)
MTP = law("MTP")
Y = 50.0 * (MTP.s(np.clip((X - 60.0) / 90.0, 0.0, 1.0)) - MTP.s(np.clip((X - 220.0) / 100.0, 0.0, 1.0)))


def cells(x, y):
    return [f"{x:.1f}", f"{y:.6f}"]


def text(separator=";", decimal=".", head="", end="\n", tail="", of=cells):
    rows = (separator.join(of(x, y)).replace(".", decimal) for x, y in zip(X, Y, strict=True))
    return head + "".join(f"{row}{tail}{end}" for row in rows)


MEANT = {
    "commas": text(","),
    "decimal commas": text(";", ","),
    "tabs and decimal commas": text("\t", ","),
    "blanks": text("   "),
    "hard blanks": text("\u00a0"),
    "bars": text("|"),
    "commas with a blank beside decimal commas": text(", ", ","),
    "a blank on both sides": text(" ; "),
    "ends as Windows has them": text(end="\r\n"),
    "ends as old Macs have them": text(end="\r"),
    "a mark of UTF-8": "\ufeff" + text(head="angle;position\n"),
    "UTF-16": text(head="\u03c6;y\n").encode("utf-16"),
    "Windows' code page": text(";", ",", head="Größe [°];y [µm]\n").encode("cp1252"),
    "a separator behind the last": text(tail=";"),
    "a comma behind the last": text(",", tail=","),
    "a line for Excel": text(head="sep=;\n"),
    "a title with a digit": text(head="1st axis;position\n2nd line\n"),
    "a comment in the middle": text().replace("100.0;", "# here\n100.0;", 1),
    "empty lines": text().replace("100.0;", "\n \n100.0;", 1),
    "quotes": text(of=lambda x, y: [f'"{x:.1f}"', f'"{y:.6f}"']),
    "exponents": text(of=lambda x, y: [f"{x:.6E}", f"{y:.9E}"]),
    "plus signs": text(of=lambda x, y: [f"{x:+.1f}", f"{y:+.6f}"]),
    "typed minus signs": text(of=lambda x, y: [f"{x:.1f}", f"{y - 10.0:.6f}".replace("-", "\u2212")]),
    "an end of old": text() + "\x1a",
    "a velocity from differences": text(of=lambda x, y: [*cells(x, y), f"{np.interp(x, X, np.gradient(Y, X)):.4f}"]),
    "whole numbers": text(",", of=lambda x, y: [str(int(x)), str(round(y * 1000.0))]),
}
REFUSED = {
    "an empty column": (text(of=lambda x, y: [f"{x:.1f}", "", f"{y:.6f}"]), "line 1: '' is no number"),
    "a number of each row": (text(of=lambda x, y: [str(int(x)), *cells(x, y)]), "the third column is not y'"),
    "commas twice": (text(",", ","), "a comma parts the columns and is the decimal sign"),
    "thousands": (text(of=lambda x, y: [f"{x:.1f}", f"{y * 1000.0:,.3f}"]), "is no number"),
    "units": (text(of=lambda x, y: [f"{x:.1f} mm", f"{y:.6f} mm"]), "is no number"),
    "falling angles": ("".join(reversed(text().splitlines(True))), "expected the master to rise"),
    "no text": (b"\xff\xfe\x00", "not a text"),
    "a picture": (b"\x89PNG\r\n\x1a\n\x00\x01" * 50, "not a text"),
}


def read(folder, content):
    path = folder / "a table.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    table = read_table(path, target("csv"))
    return table, as_description.phases_of(target("csv"), table, ("°", "mm"))


@pytest.mark.parametrize("name", MEANT)
def test_what_can_be_meant_in_one_way_is_read(name, tmp_path):
    _, found = read(tmp_path, MEANT[name])
    times = 1000.0 if name == "whole numbers" else 1.0
    told = [(one.law.code, one.begin, one.end, one.lift / times) for one in found.phases]
    assert told == [("MTP", 60.0, 150.0, 50.0), ("MTP", 220.0, 320.0, -50.0)]


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_is_refused_in_a_line(name, tmp_path):
    content, said = REFUSED[name]
    with pytest.raises(MotionbookError, match=said) as refused:
        read(tmp_path, content)
    assert "\n" not in str(refused.value)


def test_a_turn_without_its_end_is_told(run, tmp_path):
    lines = text().splitlines(True)
    (tmp_path / "short.csv").write_text("".join(lines[:-1]), "utf-8")
    code, _, err = run("read", "short.csv", "--from", "csv", "-o", "short.toml")
    assert code == 0
    assert "x ends at 359, a step before the turn is over" in " ".join(err.split())
    (tmp_path / "whole.csv").write_text("".join(lines), "utf-8")
    assert "a step before" not in run("read", "whole.csv", "--from", "csv", "-o", "whole.toml")[2]
