"""Odd places to write to, through every command that writes: one line, exit code 2, at once, nothing changed."""

import os
import time

import pytest

from tests.workbook.controllers.examples import TEXT, build_described

posix = pytest.mark.skipif(os.name != "posix", reason="Windows has no such files")
AT_ONCE = 5  # seconds of the processor: verifying or exporting takes longer
TO = {
    "new": ["new", "machine", "-o"],
    "schema": ["schema", "machine", "-o"],
    "addin": ["addin", "-o"],
    "build": ["build", "machine.toml", "-o"],
    "inputs": ["inputs", "book.xlsx", "-o"],
    "regenerate": ["regenerate", "book.xlsx", "-o"],
    "verify": ["verify", "book.xlsx", "--report"],
    "junit": ["verify", "book.xlsx", "--junit"],
    "export": ["export", "book.xlsx", "--axis", "Press", "--to", "csv", "-o"],
    "certificates": ["export", "book.xlsx", "--axis", "Press", "--to", "csv", "-o", "a.csv", "--report"],
    "read": ["read", "cam.csv", "--from", "csv", "-o"],
}
ENDINGS = {"build": ".xlsx", "regenerate": ".xlsx", "verify": ".html", "junit": ".xml", "certificates": ".html"}
PLACES = (".", "/", "..", "", "kept{}", "folder{}", "below/x{}", "pipe{}", "gone{}", "loop{}", "long", "deep")
ITSELF = [
    ["build", "machine.toml", "-o", "machine.toml"], ["inputs", "book.xlsx", "-o", "book.xlsx"],
    ["inputs", "book.xlsx", "-o", "link.xlsx"], ["read", "cam.csv", "--from", "csv", "-o", "cam.csv"],
    ["export", "book.xlsx", "--axis", "Press", "--to", "csv", "-o", "book.xlsx"],
    ["export", "book.xlsx", "--axis", "Press", "--to", "csv", "-o", "a.html", "--report", "a.html"],
    ["new", "machine", "-o", "machine.schema.json"], ["regenerate", "book.xlsx", "-o", "book.xlsx"],
]  # fmt: skip


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """A description of two axes, and its book."""
    folder = tmp_path_factory.mktemp("made")
    build_described(TEXT, folder / "book.xlsx").rename(folder / "machine.toml")
    return folder


@pytest.fixture
def refused(made, tmp_path, monkeypatch, motionbook):
    """Run a command in a folder of odd things; return its one line, after the checks that hold for all."""
    for name in ("machine.toml", "book.xlsx"):
        (tmp_path / name).write_bytes((made / name).read_bytes())
    (tmp_path / "link.xlsx").symlink_to("book.xlsx")
    (tmp_path / "cam.csv").write_text("0;0\n180;10\n360;0\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)

    def run(*arguments):
        before = state(tmp_path)
        begin = time.process_time()
        code, out, err = motionbook(*arguments)
        assert time.process_time() - begin < AT_ONCE
        assert (code, out) == (2, "")
        (line,) = err.splitlines()
        assert line.isprintable()
        assert "failed inside" not in line
        assert state(tmp_path) == before
        return line

    return run


def state(folder):
    """Every name below a folder with its kind and bytes."""
    found = {}
    for path in sorted(folder.rglob("*")):
        plain = path.is_file() and not path.is_symlink()
        found[str(path)] = (path.lstat().st_mode, path.read_bytes() if plain else b"")
    return found


def place(word, ending, folder):
    """A place of that kind, with what makes it odd."""
    name = word.format(ending)
    if word == "long":
        return f"{'x' * 300}/a{ending}"
    if word == "deep":
        return f"{'x/' * 3_000}a{ending}"
    {
        "kept": lambda: (folder / name).write_text("mine"),
        "fold": (folder / name).mkdir,
        "belo": lambda: (folder / "below").write_text("mine"),
        "pipe": lambda: os.mkfifo(folder / name),
        "gone": lambda: (folder / name).symlink_to("nowhere"),
        "loop": lambda: (folder / name).symlink_to(name),
    }.get(word[:4], lambda: None)()
    return name


@posix
@pytest.mark.parametrize("command", TO)
@pytest.mark.parametrize("word", PLACES)
@pytest.mark.sample(29)
def test_an_odd_place_is_refused_in_one_line(word, command, refused, tmp_path):
    refused(*TO[command], place(word, ENDINGS.get(command, ".out"), tmp_path))


@posix
@pytest.mark.parametrize("command", TO)
@pytest.mark.parametrize("word", [word for word in PLACES if word[:4] not in ("kept", "gone")])
@pytest.mark.sample(23)
def test_what_is_no_file_is_refused_by_force_too(word, command, refused, tmp_path):
    refused(*TO[command], place(word, ENDINGS.get(command, ".out"), tmp_path), "--force")


@posix
@pytest.mark.parametrize("arguments", ITSELF, ids=" ".join)
def test_nothing_takes_the_place_of_what_is_read_or_of_another_output(arguments, refused):
    refused(*arguments, "--force")


@pytest.mark.parametrize("command", ["build", "regenerate"])
@pytest.mark.parametrize("name", ["x.toml", "x.csv", "x.xlsm", "x"])
def test_no_workbook_takes_the_name_of_another_kind_of_file(name, command, refused):
    assert refused(*TO[command], name).endswith("expected a name ending in .xlsx")


def test_an_empty_name_is_not_taken_for_this_folder(refused):
    assert "the name is empty" in refused("verify", "")
