"""A file takes its place whole or not at all; nothing is overwritten unasked, and a link stays a link."""

import os
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.errors import WriteError
from workbook.judging.batch import find_workbooks
from workbook.writing.output_files import refuse_existing, refuse_itself, refuse_same_file, replace

posix = pytest.mark.skipif(os.name != "posix", reason="Windows keeps neither modes nor links in this way")


def fill(text):
    """What writes a text into the file beside."""
    return lambda draft: draft.write_text(text)


def test_of_two_builds_at_once_the_first_that_ends_is_kept(tmp_path):
    path = tmp_path / "book.xlsx"

    def slow(draft):
        draft.write_text("slow")
        replace(path, fill("quick"))

    with pytest.raises(WriteError, match="the file exists"):
        replace(path, slow)
    assert path.read_text() == "quick"
    replace(
        path, lambda draft: replace(path, fill("quick"), overwrite=True) or draft.write_text("slow"), overwrite=True
    )
    assert path.read_text() == "slow"
    assert os.listdir(tmp_path) == ["book.xlsx"]


def test_a_file_that_appears_is_kept_without_links_too(monkeypatch, tmp_path):
    """As on a FAT stick, where no second name can be given to a file."""

    def none(*_):
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr(os, "link", none)
    path = tmp_path / "book.xlsx"
    replace(path, fill("ours"))
    assert path.read_text() == "ours"
    with pytest.raises(WriteError, match="the file exists"):
        replace(tmp_path / "other.xlsx", lambda draft: (tmp_path / "other.xlsx").write_text("theirs"))
    assert (tmp_path / "other.xlsx").read_text() == "theirs"
    assert sorted(os.listdir(tmp_path)) == ["book.xlsx", "other.xlsx"]


@posix
def test_a_dangling_link_is_something(tmp_path):
    link = tmp_path / "book.xlsx"
    link.symlink_to(tmp_path / "elsewhere.xlsx")
    with pytest.raises(WriteError, match="exists"):
        replace(link, fill("ours"))
    assert os.listdir(tmp_path) == ["book.xlsx"]


@posix
@pytest.mark.parametrize("there", [True, False])
def test_force_writes_through_a_link(there, tmp_path):
    folder = tmp_path / "folder"
    folder.mkdir()
    target, link = folder / "target.xlsx", tmp_path / "book.xlsx"
    if there:
        target.write_text("old")
    (tmp_path / "between").symlink_to("folder/target.xlsx")
    link.symlink_to("between")
    replace(link, fill("new"), overwrite=True)
    assert target.read_text() == link.read_text() == "new"
    assert link.is_symlink()
    assert not target.is_symlink()
    assert os.listdir(folder) == ["target.xlsx"]


@posix
@pytest.mark.parametrize("overwrite", [True, False])
def test_what_is_no_file_is_refused(overwrite, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "folder").mkdir()
    for name, target in (("device", "/dev/null"), ("loop", "loop"), ("to a pipe", "pipe"), ("to a folder", "folder")):
        (tmp_path / name).symlink_to(target)
    before = sorted(os.listdir(tmp_path))
    for name in before:
        with pytest.raises(WriteError):
            replace(tmp_path / name, lambda draft: pytest.fail("it was begun"), overwrite)
    assert sorted(os.listdir(tmp_path)) == before
    assert stat.S_ISFIFO((tmp_path / "pipe").stat().st_mode)


@posix
@pytest.mark.parametrize(("umask", "mode"), [(0o077, 0o600), (0o022, 0o644), (0o002, 0o664)])
def test_umask_holds(umask, mode, tmp_path):
    before = os.umask(umask)
    try:
        replace(tmp_path / "new.xlsx", fill("new"))
        (tmp_path / "kept.xlsx").write_text("private")
        (tmp_path / "kept.xlsx").chmod(0o640)
        replace(tmp_path / "kept.xlsx", fill("new"), overwrite=True)
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "new.xlsx").stat().st_mode) == mode
    assert stat.S_IMODE((tmp_path / "kept.xlsx").stat().st_mode) == 0o640


@pytest.mark.parametrize("name", ["a" * 250 + ".xlsx", "[red].xlsx", " .xlsx"])
def test_any_name_that_the_system_has_is_written(name, tmp_path):
    replace(tmp_path / name, fill("new"))
    assert os.listdir(tmp_path) == [name]


@pytest.mark.parametrize("place", ["file/x.xlsx", "file/y/x.xlsx", "gone/x.xlsx", "pipe/x.xlsx"])
@posix
def test_what_lies_below_no_folder_is_refused_before_the_work(place, tmp_path):
    (tmp_path / "file").write_text("mine")
    (tmp_path / "gone").symlink_to("nowhere")
    os.mkfifo(tmp_path / "pipe")
    before = sorted(os.listdir(tmp_path))
    for overwrite in (False, True):
        with pytest.raises(WriteError, match="cannot be written"):
            refuse_existing(tmp_path / place, overwrite)
    assert sorted(os.listdir(tmp_path)) == before


@posix
def test_two_files_for_one_place_and_what_is_read_itself_are_refused(tmp_path):
    (tmp_path / "book.xlsx").write_text("mine")
    (tmp_path / "link.xlsx").symlink_to("book.xlsx")
    for other in ("book.xlsx", "link.xlsx", "folder/../book.xlsx"):
        with pytest.raises(WriteError, match="two files"):
            refuse_same_file(tmp_path / "book.xlsx", None, tmp_path / other)
        with pytest.raises(WriteError, match="what is read"):
            refuse_itself(tmp_path / other, tmp_path / "book.xlsx")
    refuse_same_file(tmp_path / "book.xlsx", None, tmp_path / "other.xlsx", None)
    refuse_itself(None, tmp_path / "book.xlsx")


@posix
def test_a_killed_run_leaves_nothing_that_looks_like_a_book(tmp_path):
    code = (
        "import os, signal, sys; from pathlib import Path; from workbook.writing.output_files import replace\n"
        "replace(Path(sys.argv[1]), lambda draft: (draft.write_text('half'), os.kill(os.getpid(), signal.SIGKILL)))"
    )
    run = subprocess.run([sys.executable, "-c", code, str(tmp_path / "book.xlsx")], check=False)
    assert run.returncode == -signal.SIGKILL
    (left,) = os.listdir(tmp_path)
    assert left.startswith(".")
    assert Path(left).suffix == ".part"
    assert find_workbooks([tmp_path])[0] == []
