"""The modules of the page are short, and TypeScript finds no fault in them by the types that their comments state."""

import shutil
import subprocess
from pathlib import Path

import pytest

from workbook.serve import server

PAGE = Path(server.__file__).parent / "page"
LONGEST = 200  # lines
TYPESCRIPT = "typescript@5.9.3"


def test_no_module_is_too_long():
    lines = {path.name: len(path.read_text(encoding="utf-8").splitlines()) for path in PAGE.glob("*.js")}
    assert {name: count for name, count in lines.items() if count > LONGEST} == {}


def test_types_agree(tmp_path):
    """The libraries are checked by their own authors."""
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip("node, with npm, is not on this machine: no types are checked")
    command = [npm, "exec", "--yes", f"--package={TYPESCRIPT}", "--", "tsc", "--pretty", "false"]
    config = ["-p", Path(__file__).with_name("page.json")]
    if subprocess.run([*command, "--version"], cwd=tmp_path, capture_output=True, timeout=300).returncode:
        pytest.skip(f"npm has no {TYPESCRIPT}, and cannot fetch it: no types are checked")
    done = subprocess.run([*command, *config], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    faults = [line for line in done.stdout.splitlines() if "error TS" in line and "/vendor/" not in line]
    assert faults == [], done.stderr
