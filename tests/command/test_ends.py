"""How a command ends where its terminal or its folder fails: with 2 or the verdict, never 1."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

posix = pytest.mark.skipif(os.name != "posix", reason="Windows has no such files")
FULL = Path("/dev/full")
VERSION = "echo LibreOffice 99.9"
PRINTING = (["laws"], ["laws", "--json"], ["--help"])


def run(arguments, unbuffered="", **streams):
    """Run the command in a process of its own."""
    environment = os.environ | {"PYTHONUNBUFFERED": unbuffered}
    command = [sys.executable, "-m", "workbook", *arguments]
    return subprocess.run(command, env=environment, check=False, timeout=120, **streams)


@posix
@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize("arguments", PRINTING, ids=" ".join)
@pytest.mark.sample(3)
def test_a_reader_that_leaves_does_not_change_the_verdict(arguments, unbuffered):
    read, write = os.pipe()
    os.close(read)
    with os.fdopen(write, "w") as gone:
        done = run(arguments, unbuffered, stdout=gone, stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (0, "")


@posix
@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize("arguments", PRINTING, ids=" ".join)
@pytest.mark.sample(3)
def test_what_cannot_be_printed_is_told_with_2(arguments, unbuffered):
    with FULL.open("w") as full:
        done = run(arguments, unbuffered, stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 2
    assert done.stderr.splitlines() == ["what was to be printed could not be written: No space left on device"]


@posix
@pytest.mark.parametrize(("arguments", "code"), [(["laws"], 0), (["verify", "none.xlsx"], 2), (["no-command"], 2)])
def test_messages_that_nobody_takes_do_not_change_the_verdict(arguments, code):
    with FULL.open("w") as full:
        assert run(arguments, stdout=subprocess.DEVNULL, stderr=full).returncode == code


@posix
@pytest.mark.parametrize("arguments", [["new", "machine"], ["verify", "none.xlsx"]], ids=" ".join)
def test_a_folder_that_is_gone_is_told_in_a_line(arguments, tmp_path):
    folder = tmp_path / "gone"
    folder.mkdir()
    command = f'rmdir "{folder}" && exec "{sys.executable}" -m workbook {" ".join(arguments)}'
    environment = os.environ | {"PYTHONPATH": str(Path(__file__).parents[2])}
    done = subprocess.run(["/bin/sh", "-c", command], cwd=folder, env=environment, check=False, timeout=120,
                          capture_output=True, text=True)  # fmt: skip
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert "failed inside" not in done.stderr


@posix
@pytest.mark.parametrize(
    ("does", "asked", "code", "said"),
    [(does, "libreoffice", 2, ") gave no values to compare: LibreOffice") for does in ("exit 1", "kill -9 $$", VERSION)]
    + [(VERSION, "all", 0, "Not compared by libreoffice")],
)
def test_a_witness_that_fails_is_no_verdict(does, asked, code, said, press, motionbook, monkeypatch, tmp_path):
    failing = tmp_path / "soffice"
    failing.write_text(f"#!/bin/sh\n{does}\n")
    failing.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    found, *told = motionbook("verify", press.path, "--with", asked)
    assert found == code
    assert said in "".join(told)
