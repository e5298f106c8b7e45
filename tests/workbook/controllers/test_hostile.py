"""Damaged and hostile files through the command, each in a process of its own: one line, exit 2, under 1 GiB."""

import sys

import pytest

from tests.tiers import by_day
from tests.workbook.controllers.examples import handed
from tests.workbook.reading.program import run
from workbook.controllers.registry import target

CODESYS = target("codesys").write(handed(target("codesys")))
LAUGHS = "".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 10))
MANY = 1_000_000

FILES = {
    "truncated": ("codesys", CODESYS[: len(CODESYS) // 2]),
    "no number": ("csv", "0;0\n1;nan\n2;0\n"),
    "a million points": ("csv", "".join(f"{i};{i}\n" for i in range(MANY))),
    "a million elements": ("rockwell", f"<Tags>{'<Element/>' * MANY}</Tags>"),
    "a million assignments": ("twincat", "".join(f"P[{i}].MasterPos := {i}.0;\n" for i in range(MANY // 4))),
    "wrong order": ("sew", "3\n0;0\n200;1\n100;0\n"),
    "duplicate ends": ("lenze", "0 0\n180 5\n360 0\n360 0\n"),
    "mixed decimal signs": ("csv", "0;0\n1;1,5\n2;1.5\n"),
    "entities": ("rockwell", f'<!DOCTYPE x [<!ENTITY a0 "ha">{LAUGHS}]><Tags>&a9;</Tags>'),
    "an entity from a file": ("rockwell", '<!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/passwd">]><Tags>&a;</Tags>'),
    "deep": ("rockwell", "<a>" * 500_000),
    "one long line": ("csv", "1" * 7_000_000),
    "not a text": ("csv", "\ud800"),
    "empty": ("csv", ""),
}


@pytest.mark.skipif(sys.platform != "linux", reason="the memory of a child is counted in KiB on Linux")
@pytest.mark.parametrize("name", by_day(FILES, "a million points", "entities", "deep", "truncated"))
def test_a_hostile_file_costs_a_line_and_little_memory(name, tmp_path):
    source, text = FILES[name]
    (tmp_path / "file").write_bytes(text.encode("utf-8", "surrogatepass"))
    code, out, err, _ = run("read", "file", "--from", source, "-o", "out.toml", folder=tmp_path)
    assert (code, out) == (2, "")
    assert "Traceback" not in err
    assert len(err.strip().splitlines()) == 1
    assert not (tmp_path / "out.toml").exists()
