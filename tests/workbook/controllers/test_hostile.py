"""Damaged and hostile files through the command, each in a process of its own: one line, exit 2, under 1 GiB."""

import os
import subprocess
import sys

import pytest

from tests.tiers import by_day
from tests.workbook.controllers.examples import handed
from workbook.controllers.registry import target

GIB = 2**20  # in KiB, as Linux counts
ROCKWELL = target("rockwell").write(handed(target("rockwell")))
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


@pytest.mark.skipif(not hasattr(os, "wait4"), reason="no such measure of memory on this system")
@pytest.mark.parametrize("name", by_day(FILES, "a million points", "entities", "deep", "truncated"))
def test_a_hostile_file_costs_a_line_and_little_memory(name, tmp_path):
    source, text = FILES[name]
    (tmp_path / "file").write_bytes(text.encode("utf-8", "surrogatepass"))
    asked = [sys.executable, "-m", "workbook", "read", str(tmp_path / "file"), "--from", source, "-o", "out.toml"]
    with (tmp_path / "said").open("wb") as said:
        child = subprocess.Popen(
            asked, cwd=tmp_path, stdout=said, stderr=said, env=os.environ | {"PYTHONPATH": os.getcwd()}
        )
        _, status, used = os.wait4(child.pid, 0)
    told = (tmp_path / "said").read_text("utf-8")
    assert os.waitstatus_to_exitcode(status) == 2, told
    assert "Traceback" not in told
    assert len(told.strip().splitlines()) == 1, told
    assert used.ru_maxrss < GIB
    assert not (tmp_path / "out.toml").exists()
