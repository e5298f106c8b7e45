"""The house keeps its rules: lines can be read."""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
LONGEST = 120


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
