"""The house keeps its rules: what declares sheets does no mechanics, and lines can be read."""

import ast
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
DECLARING = [ROOT / "workbook" / room for room in ("book", "drive", "laws", "machines", "selection")]
# inputs as entered or made up; readers of formulas and of sentences
ELSE = {"entries.py", "catalogue.py", "variations.py", "formula.py", "depends.py", "gentle.py", "sentence.py"}
LONGEST = 120
OPERATORS = {ast.Mult: "*", ast.Div: "/", ast.Pow: "**", ast.MatMult: "@"}
SPELLED_OUT = {"multiply", "divide", "true_divide", "power", "pow", "prod", "dot", "mul", "truediv", "reciprocal"}


def parsed(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"), str(path))


def named(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


# The sheet's other hand is the engine


def arithmetic(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Every product, quotient and power in a piece of source, with its line."""
    for node in ast.walk(tree):
        if isinstance(node, ast.BinOp | ast.AugAssign) and type(node.op) in OPERATORS:
            yield node.lineno, OPERATORS[type(node.op)]
        elif isinstance(node, ast.Call):
            called = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if called in SPELLED_OUT:
                yield node.lineno, f"{called}()"


def declaring() -> Iterator[Path]:
    for room in DECLARING:
        yield from (path for path in sorted(room.rglob("*.py")) if path.name not in ELSE)


@pytest.mark.parametrize("path", list(declaring()), ids=named)
def test_what_declares_sheets_neither_multiplies_nor_divides(path: Path) -> None:
    found = [f"{named(path)}:{line}: {sign}" for line, sign in sorted(arithmetic(parsed(path)))]
    assert not found, "\n".join(found)


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("x = a * b", ["*"]),
        ("x = a / b ** 2", ["/", "**"]),
        ("x *= 2\ny /= 3\nz **= 4", ["*", "/", "**"]),
        ('text = f"={a * 2}*{b}"', ["*"]),
        ('text = f"={a}*{b}/2^2"\nrow = (*first, *rest)\ncall(**names)', []),
        ("np.multiply(a, b)\nmath.prod(c)\npow(2, 3)", ["multiply()", "prod()", "pow()"]),
        ("k = (i + 1 - n) // 2 % 3", []),
    ],
)
def test_arithmetic_is_found_in_code_and_not_in_the_text_of_formulas(source: str, found: list[str]) -> None:
    assert sorted(sign for _, sign in arithmetic(ast.parse(source))) == sorted(found)


# Lines that can be read


def tracked() -> list[Path]:
    listing = subprocess.run(["git", "ls-files", "-z", "*.py"], cwd=ROOT, capture_output=True, text=True)
    if listing.returncode:
        pytest.skip("not a git checkout: nothing says which files are the project's")
    return [path for name in filter(None, listing.stdout.split("\0")) if (path := ROOT / name).exists()]


def test_no_line_is_too_long() -> None:
    lines = ((path, n, line) for path in tracked() for n, line in enumerate(path.read_text("utf-8").splitlines(), 1))
    found = [f"{named(path)}:{n}: {len(line)} characters" for path, n, line in lines if len(line) > LONGEST]
    assert not found, "\n".join(found)
