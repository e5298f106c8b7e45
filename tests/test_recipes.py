"""What docs/recipes show is done, word for word, in a copy of the source; its book is then built and verified."""

import os
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
MACHINE = "workbook/machines/machine/"
BLOCK = re.compile(r"^ *```python\n(.*?)^ *```$", re.MULTILINE | re.DOTALL)
ROW = re.compile(r"^ *(\| (?!kind).* \|)$", re.MULTILINE)
TRIED = """
from pathlib import Path
from tests.mutation.bench import smaller
from workbook.build import build, read_inputs
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine
machine = smaller(read_machine(Path("machine.toml")))
book = Path("book.xlsx")
build(machine, book)
report = verify(book, ["pycel"])
print(report.findings, read_inputs(book) == (machine, []), [check.what for check in report.failing])
"""


@pytest.fixture
def copy(tmp_path, motionbook):
    """Give a function that changes the copy of a file, and a machine to build, both in a folder of their own."""
    for name in ("engine", "workbook", "templates"):
        shutil.copytree(ROOT / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__", "*.xlsx"))
    assert motionbook("new", "machine", "-o", tmp_path / "machine.toml")[0] == 0

    def change(file, pattern, text):
        """Write text behind the first place that matches in a file, as far in as that begins."""
        path = tmp_path / file
        before = path.read_text(encoding="utf-8")
        place = re.search(rf"^( *){pattern}.*\n", before, re.MULTILINE)
        written = textwrap.indent(textwrap.dedent(text), place[1])
        path.write_text(before[: place.end()] + written + before[place.end() :], encoding="utf-8")

    return change


def recipe(name):
    """Return a recipe's blocks of Python, its rows of tables that begin with a kind, and its text."""
    text = (ROOT / f"docs/recipes/{name}.md").read_text(encoding="utf-8")
    rows = [row + "\n" for row in ROW.findall(text) if re.match(r"\| (?:entry|result|check) \|", row)]
    return BLOCK.findall(text), rows, text


def listed(value):
    """Return an expression as an item of a list."""
    return value.rstrip() + ",\n"


def tried(folder):
    """Return what verifying the machine's book prints, by the changed source."""
    done = subprocess.run(
        [sys.executable, "-c", TRIED], cwd=folder, capture_output=True, text=True, encoding="utf-8", check=False,
        env=os.environ | {"PYTHONPATH": os.pathsep.join([str(folder), str(ROOT)])},
    )  # fmt: skip
    return done.stdout + done.stderr


def do_column(copy, tmp_path):
    (value,), (row,), _ = recipe("column")
    copy(f"{MACHINE}timing/phases.md", r"\| result \| `j`", row)
    copy(f"{MACHINE}timing/phases.py", r"cell\(\"j\"", listed(value))


def do_entry(copy, tmp_path):
    _, (row,), text = recipe("entry")
    field = re.search(r"`(drag_torque: .*?)`", text)[1]
    copy(f"{MACHINE}drive_entries.md", r"\| entry \| `@own_reducer_max_speed`", row)
    copy(
        f"{MACHINE}drive_entries.py", r"cycle_factor: Factor \| None = None\n *mean_torque.*\n *max_speed", field + "\n"
    )
    copy("machine.toml", r"ratio = 8\.0", "drag_torque = 0.25\n")


def do_check(copy, tmp_path):
    (field, column, value), (facts, row), _ = recipe("check")
    copy(f"{MACHINE}entries.py", "position: Number = 0.0", field)
    copy(f"{MACHINE}entries.md", r"\| entry \| `position`", facts)
    copy(f"{MACHINE}timing/sheet.py", r"entry\(\"position\"", listed(column))
    copy(f"{MACHINE}timing/phases.md", r"\| check \| `\{t\}_position`", row)
    copy(f"{MACHINE}timing/phases.py", r"\*map\(stop_check", listed(value))
    path = tmp_path / f"{MACHINE}timing/phases.py"
    path.write_text(path.read_text("utf-8").replace("import amount,", "import amount, exceeding,"), encoding="utf-8")
    copy("machine.toml", r"closes = ", "fastest = 1.5\n")


def test_a_column_an_entry_and_a_check_as_their_recipes_have_them(copy, tmp_path):
    """One after the other in one copy: each writes elsewhere, and a book has all three."""
    for do in (do_column, do_entry, do_check):
        do(copy, tmp_path)
    assert tried(tmp_path) == "[] True ['Axis 1: within its greatest velocity']\n"
