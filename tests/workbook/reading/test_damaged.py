"""Damaged files and hostile inputs through the command as a program: one line or a verdict, small and soon done."""

import os
import sys

import pytest

from tests.tiers import seed
from tests.workbook.composed import small
from tests.workbook.reading.forks import GIB, KIB, SECONDS, Server
from tests.workbook.reading.fuzz import damaged, without_charts
from workbook.build import build

DAY, NIGHT = 2, 120
SOUND = 1.0  # seconds of the sound book on a quiet machine, where SECONDS hold
linux = pytest.mark.skipif(sys.platform != "linux", reason="the memory of a child is counted in KiB on Linux")


@pytest.fixture(scope="module")
def sound(tmp_path_factory):
    """The smallest book there is, and the same without charts."""
    path = tmp_path_factory.mktemp("sound") / "book.xlsx"
    build(small(), path)
    return path.read_bytes(), without_charts(path.read_bytes())


def fault(code, out, err, seconds, allowed, most=SECONDS):
    """What is wrong with how a run ended; nothing where all is as it should be."""
    if code not in allowed:
        return f"exit code {code}: {err[-300:]}"
    if "Traceback" in err or "failed inside" in err:
        return err[-300:]
    lines = err.splitlines()
    if code == 2 and (out or not lines or not all(map(str.isprintable, lines))):
        return f"not a line that can be printed: {out[-200:]}{err[-300:]}"
    if code == 2 and len(lines) > 1 and not all(line.startswith("book.xlsx: ") for line in lines):
        return f"not a line for each fault: {err[-300:]}"
    return f"{seconds:.0f} s" if seconds > most else None


def book(number, drawn, sound):
    """A damaged book: one in twenty has charts."""
    return damaged(sound[0] if number % 20 == 0 else sound[1], number, drawn)


def longest(server, path, sound):
    """Seconds that a damaged book may take: on a busy or slow machine, as much more as the sound one takes there."""
    path.write_bytes(sound[1])
    code, _, _, _, seconds = server.run("verify", path.name, "--jobs", 1)
    assert code == 0
    return SECONDS * max(1, seconds / SOUND)


def many(numbers, drawn, sound, folder):
    """Damaged books by the hundred, each verified in a process forked from one that has the command loaded."""
    path, faults = folder / "book.xlsx", []
    server = Server(folder)
    most = longest(server, path, sound)
    for number in numbers:
        path.write_bytes(book(number, drawn, sound))
        code, out, err, memory, seconds = server.run("verify", path.name, "--jobs", 1)
        wrong = fault(code, out, err, seconds, (0, 1, 2, 3), most) or (memory * KIB >= GIB and f"{memory:,} KiB")
        if wrong:
            faults.append(f"{number}, seed {drawn!r}: {wrong}")
    server.end()
    assert faults == []
    assert os.listdir(folder) == ["book.xlsx"]


@linux
def test_damaged_files_one_after_the_other(sound, tmp_path):
    (tmp_path / "books").mkdir()
    many(range(DAY, 5 * DAY), 0, sound, tmp_path / "books")


@linux
@pytest.mark.nightly
@pytest.mark.parametrize("chunk", range(4))
def test_hundreds_of_damaged_files(chunk, sound, tmp_path):
    size = NIGHT // 4
    (tmp_path / "books").mkdir()
    many(range(chunk * size, (chunk + 1) * size), seed("command"), sound, tmp_path / "books")
