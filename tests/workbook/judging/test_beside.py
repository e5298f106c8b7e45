"""A second process evaluates one book beside the judge: it changes no verdict, whatever becomes of it."""

import multiprocessing
import os
import shutil
import signal
import subprocess
import sys
import time

import openpyxl
import pytest

from tests.workbook.composed import small
from workbook.build import build
from workbook.errors import MotionbookError
from workbook.judging.comparing import Comparison
from workbook.judging.verify import verify
from workbook.witnesses import beside
from workbook.witnesses.beside import Beside, wanted


@pytest.fixture(scope="module")
def good(press):
    """A small workbook as built; second processes know its template, as they are copies of this one."""
    if multiprocessing.get_start_method() != "fork":
        pytest.skip("a second process that is begun anew does not know the press")
    return press.path


@pytest.fixture(scope="module")
def wrong(good, tmp_path_factory):
    """The same book with a typed number, a formula that reads another cell, one that no program has, and own cells."""
    book = openpyxl.load_workbook(good)
    page = book["Timing"]
    cells = [c for row in page.iter_rows() for c in row if c.data_type == "f"]
    cells[0].value = 123.5
    cells[20].value = f"{cells[20].value}+0.001"
    cells[40].value = "=nothing(1)"
    path = tmp_path_factory.mktemp("wrong") / "wrong.xlsx"
    book.save(path)
    return path


@pytest.fixture(scope="module")
def own(good, tmp_path_factory):
    """The same book with an engineer's own formula beside a table."""
    book = openpyxl.load_workbook(good)
    book["Timing"]["ZZ9"] = "=1+1"
    path = tmp_path_factory.mktemp("own") / "own.xlsx"
    book.save(path)
    return path


@pytest.fixture
def begun():
    """Begin second processes that end with the test."""
    started = []

    def begin(path):
        started.append(Beside(path))
        return started[-1]

    yield begin
    for helper in started:
        helper.end()


@pytest.mark.parametrize("name", ["good", "wrong", "own"])
def test_it_changes_nothing_of_a_report(name, request, begun):
    path = request.getfixturevalue(name)
    alone = verify(path)
    assert verify(path, beside=begun(path)) == alone
    assert bool(alone.findings) == (name == "wrong")


def test_it_is_what_evaluates(good, begun, monkeypatch):
    monkeypatch.setattr("workbook.witnesses.pycel.model.Pycel.model", unasked)
    report = verify(good, beside=begun(good))
    assert report.compared == report.declared > 200
    assert not report.findings


def unasked(witness, file):
    raise AssertionError("the first process evaluates")


def kill():
    for process in multiprocessing.active_children():
        process.kill()
        process.join()


def test_killed_before_it_answers_it_is_not_missed(wrong, begun):
    helper = begun(wrong)
    kill()
    assert verify(wrong, beside=helper) == verify(wrong)


@pytest.mark.parametrize("when", ["asked", "answered"])
def test_killed_before_the_other_inputs_their_findings_are_not_lost(wrong, begun, monkeypatch, when):
    """As soon as it has evaluated the book, or when all turns were handed to it."""
    helper, evaluate, ask = begun(wrong), Beside.evaluate, Comparison.ask_elsewhere

    def then_killed(asked):
        values = evaluate(asked)
        kill()
        return values

    def handed_and_killed(*arguments):
        ask(*arguments)
        kill()

    if when == "answered":
        monkeypatch.setattr(Beside, "evaluate", then_killed)
        monkeypatch.setattr(Beside, "each", lazily(Beside.each))
    else:
        monkeypatch.setattr(Comparison, "ask_elsewhere", handed_and_killed)
    report = verify(wrong, beside=helper)
    monkeypatch.undo()
    assert report == verify(wrong)


def lazily(each):
    """Return what asks only when the answer is wanted, so that a process that was killed before does not answer."""
    return lambda asked, *wanted: lambda: each(asked, *wanted)()


def test_a_file_that_was_replaced_meanwhile_is_read_by_the_judge_alone(good, wrong, tmp_path, begun):
    path = shutil.copy(good, tmp_path / "book.xlsx")
    helper = begun(path)
    assert helper.evaluated.result()
    shutil.copy(wrong, path)
    found, expected = verify(path, beside=helper), verify(path)
    assert found == expected
    assert found.findings


def test_a_file_that_cannot_be_read_is_refused_as_ever(tmp_path, begun):
    path = tmp_path / "book.xlsx"
    path.write_bytes(b"no zip")
    with pytest.raises(MotionbookError) as alone:
        verify(path)
    with pytest.raises(MotionbookError) as together:
        verify(path, beside=begun(path))
    assert str(together.value) == str(alone.value)


def test_it_is_begun_for_one_book_where_there_is_a_core_for_it(good, tmp_path, monkeypatch):
    monkeypatch.setattr(os, "sched_getaffinity", lambda pid: {0, 1}, raising=False)
    assert wanted([good], None, None)
    assert wanted([good], ["saved", "pycel"], 2)
    assert not wanted([good, good], None, None)
    assert not wanted([good.parent], None, None)
    assert not wanted([tmp_path / "gone.xlsx"], None, None)
    assert not wanted([good], ["formualizer"], None)
    assert not wanted([good], None, 1)
    monkeypatch.setattr(beside, "LARGEST", 10)
    assert not wanted([good], None, None)
    monkeypatch.undo()
    monkeypatch.setattr(os, "sched_getaffinity", lambda pid: {3}, raising=False)
    assert not wanted([good], None, None)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes on this system")
def test_a_pipe_is_left_alone(tmp_path):
    os.mkfifo(tmp_path / "book.xlsx")
    assert not wanted([tmp_path / "book.xlsx"], None, None)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no process groups of this kind")
@pytest.mark.parametrize("interrupted", [False, True])
def test_the_command_leaves_no_process_behind(tmp_path, interrupted):
    build(small(), tmp_path / "book.xlsx")
    command = [sys.executable, "-m", "workbook", "verify", str(tmp_path / "book.xlsx")]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen(command, start_new_session=True, **pipes) as started:
        if interrupted:
            time.sleep(1.0)
            os.killpg(started.pid, signal.SIGINT)
        _, said = started.communicate(timeout=120)
    assert "Traceback" not in said
    assert interrupted or started.returncode in (0, 3)
    assert ends(started.pid)


def ends(group):
    """Whether all processes of a group end within a few seconds."""
    for _ in range(50):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.1)
    return False
