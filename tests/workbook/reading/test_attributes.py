"""A malformed attribute, anywhere in a file, is a line that names the part, or read as if it were not there."""

import random

import pytest

from tests.tiers import seed
from tests.workbook.composed import small
from tests.workbook.reading.attributes import KINDS, changed, places
from tests.workbook.reading.fuzz import pack, unpack
from workbook.build import build
from workbook.errors import ReadError
from workbook.reading.files import open_book

DAY, NIGHT = 100, 60
COMMANDS = {"verify": ("book.xlsx", "--jobs", 1), "diff": ("sound.xlsx", "book.xlsx"),
            "export": ("book.xlsx", "--axis", "α", "--to", "csv", "-o", "axis.csv", "--force")}  # fmt: skip


@pytest.fixture(scope="module")
def parts(press):
    """The parts of the press."""
    return unpack(press.path.read_bytes())


def cases(parts, count, drawn):
    """So many changes of attributes, drawn of all."""
    return random.Random(drawn).sample([(place, kind) for place in places(parts) for kind in KINDS], count)


def test_a_malformed_attribute_is_a_line_that_names_its_part_or_is_read(parts, tmp_path):
    path, unclear = tmp_path / "book.xlsx", []
    for place, kind in cases(parts, DAY, 1):
        path.write_bytes(pack(changed(parts, place, kind)))
        try:
            open_book(path)
        except ReadError as error:
            line = str(error)
            if "\n" in line or not line.startswith(f"{path}: ") or "save it as .xlsx" not in line:
                unclear.append((place, kind, line))
    assert unclear == []


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('<sz val="11" />', '<sz val="big" />', "'xl/styles.xml': <font> holds sz = 'big'; expected a number"),
        ('horizontal="center"', 'horizontal="mid"', "expected center, centerContinuous, distributed, fill, general"),
        (
            'borderId="1"',
            'borderId="400"',
            "'xl/styles.xml': <styleSheet> cannot be read: a number in it is beyond the",
        ),
    ],
)
def test_the_line_says_which_attribute_and_what_is_expected(old, new, words, parts, tmp_path):
    changed_parts = [(name, data.replace(old.encode(), new.encode(), 1)) for name, data in parts]
    assert changed_parts != parts
    (tmp_path / "book.xlsx").write_bytes(pack(changed_parts))
    with pytest.raises(ReadError) as told:
        open_book(tmp_path / "book.xlsx")
    assert words in str(told.value)


def fault(code, out, err):
    """What is wrong with how a command ended; nothing where all is as it should be."""
    if code not in (0, 1, 2, 3) or "failed inside" in err:
        return f"exit code {code}: {err[-300:]}"
    lines = err.splitlines()
    if code == 2 and (out or not lines or not all(map(str.isprintable, lines))):
        return f"not a line that can be printed: {out[-200:]}{err[-300:]}"
    if code == 2 and len(lines) > 1 and not all(line.startswith("book.xlsx: ") for line in lines):
        return f"not a line for each fault: {err[-300:]}"
    return None


@pytest.mark.nightly
@pytest.mark.parametrize("command", COMMANDS)
def test_commands_end_in_a_line_or_a_verdict(command, tmp_path, motionbook, monkeypatch):
    monkeypatch.chdir(tmp_path)
    build(small(), tmp_path / "sound.xlsx")
    parts, faults = unpack((tmp_path / "sound.xlsx").read_bytes()), []
    for place, kind in cases(parts, NIGHT, seed(command)):
        (tmp_path / "book.xlsx").write_bytes(pack(changed(parts, place, kind)))
        if wrong := fault(*motionbook(command, *COMMANDS[command])):
            faults.append((place, kind, wrong))
    assert faults == []
