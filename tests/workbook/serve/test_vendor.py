"""The libraries of the design page are what their packages hold, and the server sends them."""

import hashlib
import re
from pathlib import Path

import pytest

from workbook.serve import server as served

VENDOR = Path(served.__file__).parent / "page" / "vendor"
ROW = re.compile(r"\| (\S+) \| \S+ \| [\d.]+ \| \S+ \| \S+ \| ([0-9a-f]{64}) \|")
LIBRARIES = dict(ROW.findall((VENDOR / "README.md").read_text(encoding="utf-8")))
NAMES = {"./preact.js": "preact", "./hooks.js": "preact/hooks", "./signals-core.js": "@preact/signals-core"}


def test_every_file_is_told_with_its_hash_and_its_licence():
    assert set(LIBRARIES) == {path.name for path in VENDOR.glob("*.*") if path.name != "README.md"}
    assert {path.stem for path in (VENDOR / "licences").iterdir()} == {Path(name).stem for name in LIBRARIES} - {
        "hooks"
    }


@pytest.mark.parametrize("name", LIBRARIES)
def test_a_library_is_the_file_of_its_package(name, server):
    text = (VENDOR / name).read_text(encoding="utf-8")
    for ours, theirs in NAMES.items():
        text = text.replace(f'from"{ours}"', f'from"{theirs}"')
    assert hashlib.sha256(text.encode()).hexdigest() == LIBRARIES[name]
    answer = server.ask(f"/0/page/vendor/{name}")
    assert (answer.code, answer.body) == (200, (VENDOR / name).read_bytes())
    assert answer.headers["Content-Type"] == f"text/{'css' if name.endswith('css') else 'javascript'}; charset=utf-8"
    assert "immutable" in answer.headers["Cache-Control"]  # the address tells the version
    assert server.ask(f"/0/page/vendor/{name}", cookie="").code == 403
    assert server.ask("/0/page/vendor/none.js").code == 404
