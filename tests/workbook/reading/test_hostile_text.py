"""Descriptions, catalogues and names of files from anywhere: one line, exit code 2, nothing opened that may wait."""

import os
import time

import pytest

from tests import cutting

TEXT = cutting.DESCRIPTION.read_text(encoding="utf-8")
BEFORE = TEXT.split("[master]")[0]
SELECTION = "[selection]\n"
RATE = "rate = 100.0"
HEAD = 'template = "machine"\n'
MOTORS = "name,inertia_kgcm2,rated_torque_Nm,peak_torque_Nm,max_speed_rpm\n"
SECONDS = 20  # of one hostile file
LONGEST_LINE = 1_000  # characters
posix = pytest.mark.skipif(os.name != "posix", reason="Windows has no such files")


@pytest.fixture
def said(monkeypatch, motionbook, tmp_path):
    """Run a command in a folder of its own; return its exit code and the lines that it says."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments):
        begin = time.process_time()
        code, out, err = motionbook(*arguments)
        assert time.process_time() - begin < SECONDS
        lines = (out + err).splitlines()
        assert [line for line in lines if not line.isprintable()] == []
        return code, lines

    return run


def refused(said, *arguments):
    """The one line with which a command refuses."""
    code, lines = said(*arguments)
    assert (code, len(lines)) == (2, 1), lines
    assert len(lines[0]) < LONGEST_LINE
    return lines[0]


# what TOML allows


DESCRIPTIONS = {
    "arrays 100,000 deep": (HEAD + "title = " + "[" * 100_000 + "]" * 100_000, "deep"),
    "tables 100,000 deep": (HEAD + "title = " + "{a=" * 100_000 + "1" + "}" * 100_000, "deep"),
    "arrays 400 deep": (TEXT.replace(RATE, "rate = " + "[" * 400 + "]" * 400), "master.rate"),
    "50,000 dotted keys in one": (HEAD + "a." * 50_000 + "a = 1", "deep"),
    "a header of 50,000 dotted keys": (HEAD + "[" + "a." * 50_000 + "a]", "deep"),
    "50,000 quoted keys in one": (HEAD + '"a" . ' * 50_000 + "a = 1", "deep"),
    "an integer of 5,000 digits": (TEXT.replace(RATE, "rate = " + "9" * 5_000), "digits"),
    "an integer of 4,300 digits": (TEXT.replace(RATE, "rate = " + "9" * 4_300), "master.rate"),
    "an integer of 100,000 hexadecimal digits": (TEXT.replace(RATE, "rate = " + "0x" + "f" * 100_000), "master.rate"),
    "an integer of 2,000 digits as a size": (TEXT.replace("[sizes]", "[sizes]\nlaw = " + "9" * 2_000), "sizes.law"),
    "two million characters": (TEXT + "#" * 2_000_000, "2,00"),
    "a list as the template": (TEXT.replace('"machine"', '["machine"]'), "template"),
    "a table as the template": (TEXT.replace('template = "machine"', "template = {a = 1}"), "template"),
    "a list as the title": (TEXT.replace('title = "Cutting machine"', 'title = ["Cutting machine"]'), "title"),
    "a number for the axes": (BEFORE + "axes = 3\n[master]\nrate = 100.0\n", "axes"),
    "a list as the motor": (TEXT.replace("[axes.motor]\n", '[axes.motor]\nname = ["a"]\n'), "axes[1].motor.name"),
    "a list as a motor's name": (TEXT.replace(SELECTION, SELECTION + 'motors = [{name = ["a"], '
                                 "inertia = 1, rated_torque = 1, peak_torque = 1, max_speed = 1}]\n"),
                                 "selection.motors[1].name"),
    "a number as the motors": (TEXT.replace(SELECTION, SELECTION + "motors = 1\n"), "selection.motors"),
    "a key with a dot": (TEXT.replace(RATE, 'rate = 100.0\n"rate.fast" = 1'), "unknown entry"),
    "a key of digits": (TEXT.replace(RATE, 'rate = 100.0\n1 = 1'), "unknown entry"),
    "a key of a star": (TEXT.replace(RATE, 'rate = 100.0\n"*" = 1'), "unknown entry"),
    "an empty key": (TEXT.replace(RATE, 'rate = 100.0\n"" = 1'), "unknown entry"),
    "a key of 100,000 characters": (TEXT.replace(RATE, f'{RATE}\n{"k" * 100_000} = 1'), "unknown entry"),
    "a key with an escape": (TEXT.replace(RATE, 'rate = 100.0\n"\\u001b[31m\\n" = 1'), "unknown entry"),
    "a key with markup": (TEXT.replace(RATE, 'rate = 100.0\n"[/red]" = 1'), "unknown entry"),
    "an escape as a law": (TEXT.replace('law = "MTP"', 'law = "\\u001b[31m\\u009b"', 1), "law"),
    "a no-character in the title": (TEXT.replace('title = "Cutting', 'title = "Cut\\uFFFE'), "U+FFFE"),
    "a control character in the title": (TEXT.replace('title = "Cutting', 'title = "Cut\\u009b'), "U+009B"),
    "a line's end in the title": (TEXT.replace('title = "Cutting', 'title = "Cut\\u2028'), "U+2028"),
    "a new line in an axis": (TEXT.replace('name = "MC02"', 'name = "MC\\n02"'), "U+000A"),
}  # fmt: skip


@pytest.mark.parametrize(("text", "says"), DESCRIPTIONS.values(), ids=DESCRIPTIONS.keys())
def test_a_hostile_description_is_one_line(text, says, said, tmp_path):
    (tmp_path / "machine.toml").write_text(text, encoding="utf-8")
    line = refused(said, "build", "machine.toml", "-o", "book.xlsx")
    assert line.startswith("machine.toml: ")
    assert says in line
    assert os.listdir(tmp_path) == ["machine.toml"]


def test_of_thousands_of_faults_the_first_are_told(said, tmp_path):
    many = "\n".join(f"key{i} = 1" for i in range(20_000))
    (tmp_path / "machine.toml").write_text(HEAD + many, encoding="utf-8")
    code, lines = said("build", "machine.toml")
    assert code == 2
    assert len(lines) < 50
    assert "more" in lines[-1]


# catalogues


CATALOGUES = {
    "a field of 131,072 characters": (MOTORS + f'"{"x" * 131_073}",1,1,1,1', "131072"),
    "a name of 100,000 characters": (MOTORS + "x" * 100_000 + ",1,1,1,1", "found"),
    "digits joined": (MOTORS + "A,1_000,1,1,1", "'1_000'"),
    "Arabic digits": (MOTORS + "A,١٢,1,1,1", "inertia_kgcm2"),
    "digits of full width": (MOTORS + "A,\uff11,1,1,1", "inertia_kgcm2"),
    "infinity": (MOTORS + "A,infinity,1,1,1", "'infinity'"),
    "an escape in a head": ("name,\x1b[31m\n", "unknown column"),
    "an escape in a cell": (MOTORS + "A,\x1b[31m\x9b,1,1,1", "found"),
    "an escape in a name": (MOTORS + "A\x9b,1,1,1,1", "U+009B"),
    "two million characters": (MOTORS + "x" * 2_000_000, "2,00"),
}  # fmt: skip


@pytest.mark.parametrize(("text", "says"), CATALOGUES.values(), ids=CATALOGUES.keys())
def test_a_hostile_catalogue_is_one_line(text, says, said, tmp_path):
    (tmp_path / "machine.toml").write_text(TEXT, encoding="utf-8")
    (tmp_path / "few.csv").write_text(text, encoding="utf-8")
    code, lines = said("build", "machine.toml", "--motors", "few.csv")
    assert code == 2
    assert all(line.startswith("few.csv: ") and len(line) < LONGEST_LINE for line in lines)
    assert says in lines[0]
    assert sorted(os.listdir(tmp_path)) == ["few.csv", "machine.toml"]


# files that are none


@pytest.fixture(params=["pipe", "device", "link to a pipe", "link to a device"])
def odd(request, tmp_path):
    """Make at a path what must never be opened."""

    def made(name):
        path = tmp_path / name
        if request.param == "device":
            path.symlink_to("/dev/zero")
        elif request.param == "link to a device":
            (tmp_path / "zero").symlink_to("/dev/zero")
            path.symlink_to(tmp_path / "zero")
        elif request.param == "pipe":
            os.mkfifo(path)
        else:
            os.mkfifo(tmp_path / "fifo")
            path.symlink_to(tmp_path / "fifo")
        return path

    return made


@posix
@pytest.mark.parametrize(
    "command",
    [
        ["build", "machine.toml", "-o", "book.xlsx"], ["build", "sound.toml", "--motors", "few.csv"],
        ["build", "sound.toml", "--reducers", "few.csv"], ["verify", "book.xlsx"], ["inputs", "book.xlsx"],
        ["regenerate", "book.xlsx", "-o", "new.xlsx"],
    ],
)  # fmt: skip
def test_a_pipe_or_device_is_no_file_to_be_read(command, odd, said, tmp_path):
    (tmp_path / "sound.toml").write_text(TEXT, encoding="utf-8")
    odd(command[-1] if command[-1] == "few.csv" else command[1])
    assert "a device or a pipe" in refused(said, *command)


@posix
def test_a_pipe_or_device_in_a_folder_is_passed_over(odd, said, tmp_path):
    (tmp_path / "books").mkdir()
    odd("books/book.xlsx")
    code, lines = said("verify", "books")
    assert code == 2  # there is no book to verify
    assert "skipped" in "".join(lines)


# names


@pytest.mark.parametrize("command", [["build"], ["verify"], ["inputs"], ["regenerate", "-o", "new.xlsx"]])
@pytest.mark.parametrize("name", ["x" * 300, "y" * 300 + ".xlsx", "x/" * 3_000 + "book.xlsx"])
def test_a_name_longer_than_any_is_refused(command, name, said, tmp_path):
    code, lines = said(command[0], name, *command[1:])
    assert (code, len(lines)) == (2, 1)
    assert os.listdir(tmp_path) == []
