"""Sheets and views work nothing out: what they show beside a formula is what the engine returns."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent / "workbook"
MACHINES = ("composer", "flying", "overlap")
ENTERED = {"entries.py", "variations.py"}  # may scale what is entered, or made up
FORBIDDEN = (ast.Mult, ast.Div, ast.Pow, ast.FloorDiv, ast.Mod, ast.MatMult)
DECLARING = sorted(path for name in MACHINES for path in (ROOT / "machines" / name).glob("*.py"))


def worked_out(source):
    """The lines of a source that multiply, divide or raise to a power."""
    found = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.BinOp | ast.AugAssign)]
    return sorted(node.lineno for node in found if isinstance(node.op, FORBIDDEN))


@pytest.mark.parametrize(
    "path", [p for p in DECLARING if p.name not in ENTERED], ids=lambda p: f"{p.parent.name}/{p.stem}"
)
def test_a_sheet_works_nothing_out(path):
    assert worked_out(path.read_text(encoding="utf-8")) == []


def test_what_works_something_out_is_found():
    assert worked_out("a = b * c\nd = [0] + [1]\ne /= 2\nf = g ** 2 - h") == [1, 3, 4]
    assert len(DECLARING) > 25
