"""Lines, functions and files are short enough to be read; every folder has its place in the order of imports."""

import ast
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
LONGEST = 120
FUNCTION, FILE = 60, 300  # lines, as the formatter lays them out


def named(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


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


def sources() -> list[Path]:
    return [path for path in tracked() if path.relative_to(ROOT).parts[0] in ("engine", "workbook")]


def test_no_function_is_too_long() -> None:
    found = [
        f"{named(path)}: {one.name} has {lines} lines"
        for path in sources()
        for one in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(one, ast.FunctionDef) and (lines := (one.end_lineno or 0) - one.lineno + 1) > FUNCTION
    ]
    assert not found, "\n".join(found)


def test_no_file_is_too_long() -> None:
    lines = {named(path): len(path.read_text("utf-8").splitlines()) for path in sources()}
    assert {name: count for name, count in lines.items() if count > FILE} == {}


def test_every_room_has_its_place_in_the_order_of_imports() -> None:
    """But the starter: its files are those of a new project."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["importlinter"]["contracts"]
    (layers,) = [contract["layers"] for contract in contracts if contract["type"] == "layers"]
    placed = {room.strip() for layer in layers for room in layer.split("|")}
    rooms = {".".join(path.relative_to(ROOT).with_suffix("").parts[:2]) for path in sources()}
    assert placed == rooms - {"engine.__init__", "workbook.__init__", "workbook.starter"}
