"""Many workbooks and folders at once: which are taken, what is said of each, what the run's exit code is."""

import contextlib
import functools
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import openpyxl
import pytest
from openpyxl import Workbook
from rich.console import Console

from tests.workbook.composed import small
from tests.workbook.press import registered
from workbook.build import build
from workbook.cluster import pool
from workbook.commands import verify as command
from workbook.judging import batch
from workbook.judging.batch import Outcome, Target, find_workbooks, verify_many, verify_one
from workbook.judging.verify import Report
from workbook.pool import THIS_PROCESS, WorkerDied


@pytest.fixture(scope="module")
def good(press):
    """A small workbook as built."""
    return press.path


@pytest.fixture(scope="module")
def wrong(good, tmp_path_factory):
    """The same workbook with a number in place of the first formula of the sheet Timing; beside it, that cell."""
    book = openpyxl.load_workbook(good)
    cell = next(c for row in book["Timing"].iter_rows() for c in row if c.data_type == "f")
    cell.value = 123.5
    path = tmp_path_factory.mktemp("wrong") / "wrong.xlsx"
    book.save(path)
    return path, cell.coordinate


@pytest.fixture(scope="module")
def real(tmp_path_factory):
    """A workbook that other processes know the template of."""
    path = tmp_path_factory.mktemp("real") / "real.xlsx"
    build(small(), path)
    return path


@pytest.fixture
def folder(good, wrong, tmp_path):
    """A folder with one workbook of each kind, and with files that are to be passed over."""
    (tmp_path / "deep" / "deeper").mkdir(parents=True)
    (tmp_path / ".hidden").mkdir()
    for name in ("b.xlsx", "deep/deeper/a.XLSX", "deep/c.xlsm", ".hidden/no.xlsx", ".no.xlsx"):
        shutil.copy(good, tmp_path / name)
    shutil.copy(wrong[0], tmp_path / "wrong.xlsx")
    Workbook().save(tmp_path / "foreign.xlsx")
    (tmp_path / "~$b.xlsx").write_bytes(b"a lock")
    (tmp_path / "notes.txt").write_text("no workbook")
    return tmp_path


@pytest.fixture
def verified(motionbook, monkeypatch):
    """Verify by the command; return its exit code, its output and its errors, in long lines."""
    monkeypatch.setattr(command, "OUT", Console(width=200))
    return functools.partial(motionbook, "verify")


def names(targets, folder):
    return [t.path.relative_to(folder).as_posix() for t in targets]


def test_a_folder_gives_its_workbooks_and_neither_lock_files_nor_hidden_ones(folder):
    targets, failed = find_workbooks([folder])
    assert names(targets, folder) == ["b.xlsx", "foreign.xlsx", "wrong.xlsx", "deep/c.xlsm", "deep/deeper/a.XLSX"]
    assert failed == []
    assert not any(t.named for t in targets)


def test_a_file_named_and_found_is_taken_once_and_as_named(folder):
    targets, _ = find_workbooks([folder, folder / "foreign.xlsx", folder / "deep"])
    assert len(targets) == 5
    assert [t.path.name for t in targets if t.named] == ["foreign.xlsx"]


def test_an_empty_folder_is_said_to_be_empty(tmp_path):
    targets, failed = find_workbooks([tmp_path])
    assert targets == []
    assert failed[0].reason == f"{tmp_path}: there is no workbook in this folder"


@pytest.fixture(scope="module")
def workers():
    with pool(2, None) as workers:
        yield workers


def verify_press(target, *asked):
    """Verify a press in a process that does not know its template yet."""
    with registered():
        return verify_one(target, *asked)


def test_each_workbook_of_a_folder_gets_its_verdict_whatever_the_number_of_jobs(folder, workers, monkeypatch):
    monkeypatch.setattr(batch, "verify_one", verify_press)
    targets, _ = find_workbooks([folder])
    alone, together = (
        [(o.path, o.verdict, o.sha256) for o in verify_many(targets, pool=those)] for those in (THIS_PROCESS, workers)
    )
    assert alone == together
    verdicts = {path.name: verdict for path, verdict, _ in alone}
    assert verdicts == {
        "b.xlsx": "agrees", "a.XLSX": "agrees", "c.xlsm": "agrees", "foreign.xlsx": "no machine",
        "wrong.xlsx": "disagrees",
    }  # fmt: skip


def test_a_foreign_workbook_is_an_error_only_where_it_is_named(folder):
    path = folder / "foreign.xlsx"
    found, named = (verify_many([Target(path, named=n)])[0] for n in (False, True))
    assert (found.verdict, named.verdict) == ("no machine", "unreadable")
    assert "book_template" in named.reason


def test_a_damaged_workbook_in_a_folder_is_not_taken_for_a_foreign_one(tmp_path, good):
    path = tmp_path / "cut.xlsx"
    path.write_bytes(good.read_bytes()[:3000])
    outcome = verify_many([Target(path, named=False)])[0]
    assert outcome.verdict == "unreadable"
    assert outcome.reason.startswith(str(path))


def test_a_file_that_cannot_be_opened_is_one_line(tmp_path, good, monkeypatch):
    def locked(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(batch, "verify", locked)
    outcome = verify_many([Target(good, named=True)])[0]
    assert (outcome.verdict, outcome.reason) == ("unreadable", f"{good}: cannot be read: Permission denied")


def test_a_file_saved_again_while_it_is_read_has_no_verdict(tmp_path, good, monkeypatch):
    path = tmp_path / "busy.xlsx"
    shutil.copy(good, path)

    def verify(*_):
        os.utime(path, ns=(1, 1))
        return Report(path, "machine")

    monkeypatch.setattr(batch, "verify", verify)
    outcome = verify_many([Target(path, named=True)])[0]
    assert outcome.verdict == "unreadable"
    assert "changed while it was read" in outcome.reason


def test_a_fault_of_ours_in_one_file_leaves_the_others_their_verdicts(folder, monkeypatch):
    monkeypatch.setattr(batch, "verify", lambda path, *_: Report(path, "") if path.name != "b.xlsx" else 1 // 0)
    outcomes = {o.path.name: o for o in verify_many(find_workbooks([folder])[0])}
    assert outcomes["b.xlsx"].verdict == "unreadable"
    assert "ZeroDivisionError" in outcomes["b.xlsx"].reason
    assert outcomes["c.xlsm"].verdict == "agrees"


def dies(target, witnesses):
    """Verify; one file always ends its process, another one the first time, and leaves a mark."""
    mark = target.path.with_suffix(".met")
    if target.path.name == "b.xlsx" or (target.path.name == "c.xlsm" and not mark.exists()):
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return Outcome(target.path, "agrees")


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
def test_a_book_whose_worker_dies_is_tried_once_more_alone_and_then_named(folder, workers, monkeypatch):
    monkeypatch.setattr(batch, "verify_one", dies)
    targets = find_workbooks([folder])[0]
    outcomes = verify_many(targets, pool=workers)
    assert [o.path for o in outcomes] == [t.path for t in targets]
    assert {o.path.name for o in outcomes if o.verdict != "agrees"} == {"b.xlsx"}
    assert all("ended the process" in o.reason for o in outcomes if o.path.name == "b.xlsx")


class Blind:
    """Workers that do not see the files, and of which each dies of one book the first time."""

    distant = True

    def __init__(self):
        self.met = set()

    def each(self, function, tasks, *shared):
        for task in tasks:
            first = task.target.path.name == "b.xlsx" and task.target not in self.met
            self.met.add(task.target)
            yield task, WorkerDied() if first else function(task._replace(place="/nowhere/seen.xlsx"), *shared)

    @contextlib.contextmanager
    def alone(self):
        yield self


def test_books_are_sent_as_bytes_to_workers_that_do_not_see_them(folder, wrong):
    targets = find_workbooks([folder, folder / "gone.xlsx"])[0]
    outcomes = verify_many(targets, pool=Blind())
    assert [o.path for o in outcomes] == [t.path for t in targets]
    verdicts = {o.path.name: o.verdict for o in outcomes}
    assert (verdicts["b.xlsx"], verdicts["wrong.xlsx"], verdicts["gone.xlsx"]) == ("agrees", "disagrees", "unreadable")
    assert next(o.reason for o in outcomes if o.path.name == "gone.xlsx").startswith(f"{folder / 'gone.xlsx'}: ")
    assert all(o.report.path == o.path for o in outcomes if o.report)


def test_one_book_imports_no_dask_and_starts_no_cluster(real):
    code = "import sys; from workbook import cli; sys.argv[1:] = ['verify', sys.argv[1]]\ntry: cli.main()\n"
    code += "except SystemExit: print('dask' in sys.modules or 'distributed' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code, str(real)], capture_output=True, text=True, check=False)
    assert done.stdout.splitlines()[-1] == "False"


def test_the_command_sums_a_folder_up_and_names_the_worst_cell(folder, wrong, verified):
    code, said, errors = verified(folder)
    assert (code, errors) == (1, "")  # no bar where no terminal is
    assert "3 agree, 1 disagree, 1 skipped (no machine)." in said
    assert f"{folder / 'wrong.xlsx'}: Timing!{wrong[1]}" in said


def test_the_json_of_many_files_has_each_of_them(folder, wrong, verified):
    code, said, _ = verified(folder, folder / "gone.xlsx", "--json")
    assert code == 2
    said = json.loads(said)
    files = {Path(f["file"]).name: f for f in said["files"]}
    assert said["compared"] == sum(f["compared"] for f in said["files"]) > 1000
    assert files["wrong.xlsx"]["findings"][0]["cell"] == wrong[1]
    assert files["gone.xlsx"]["reason"].endswith("there is no such file")
    assert files["b.xlsx"]["findings"] == []


TELLING = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell lets what runs in its background ignore it
from workbook import cli
from workbook.judging import batch
verify_many = batch.verify_many
batch.verify_many = lambda t, w, p, *_: verify_many(t, w, p, lambda outcome: print("one is done", flush=True))
cli.main()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends Ctrl-C to a whole console, the test's own too")
def test_an_interrupted_run_ends_without_traceback_or_orphans(real, tmp_path):
    for i in range(1000):
        os.link(real, tmp_path / f"{i}.xlsx")
    arguments = [sys.executable, "-c", TELLING, "verify", str(tmp_path), "--jobs", "2"]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen(arguments, start_new_session=True, **pipes) as started:
        assert started.stdout.readline() == "one is done\n"
        os.killpg(started.pid, signal.SIGINT)
        _, said = started.communicate(timeout=60)
    assert started.returncode == 130
    assert "Traceback" not in said
    assert group_ends(started.pid)


def group_ends(group):
    """Whether all processes of a group end within a few seconds."""
    for _ in range(50):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.1)
    return False


def test_a_local_cluster_takes_tasks_from_nobody_without_its_keys():
    from distributed import Client

    with pool(2, None) as workers:
        address = workers.client.scheduler.address
        assert address.startswith("tls://127.0.0.1:")
        assert sorted(result for _, result in workers.each(abs, [-1, -2])) == [1, 2]
        for stranger in (address, address.replace("tls", "tcp")):
            with pytest.raises((OSError, TypeError)):
                Client(stranger, timeout="5s", set_as_default=False)
