"""The command ``motionbook watch``, beside a book that is saved: what it tells, its page, and its end."""

import http.client
import json
import os
import signal
import subprocess
import sys
from contextlib import contextmanager
from functools import partial

import pytest
from openpyxl import load_workbook

from tests import cutting
from tests.workbook.judging.test_warm import cell_named
from tests.workbook.serve.conftest import ADDRESS
from workbook.build import build
from workbook.serve.handler import COOKIE


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    path = tmp_path_factory.mktemp("watch") / "machine's book.xlsx"
    build(cutting.small(cycle=12, law=4), path)
    return path


@contextmanager
def watching(book, *options):
    """The command, which ends by itself or by Ctrl+C, and leaves no temporary file."""
    temporary = book.parent / "temporary"
    temporary.mkdir(exist_ok=True)
    command = [sys.executable, "-u", "-m", "workbook", "watch", str(book), "--no-browse", *options]
    heard = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)  # tests in the background ignore Ctrl+C
    given = os.environ | {"TMPDIR": str(temporary), "COLUMNS": "200"}
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with subprocess.Popen(command, text=True, preexec_fn=heard, env=given, start_new_session=True, **pipes) as process:
        try:
            yield process
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGINT)  # as a terminal sends it, to all of its processes
            process.wait(60)
            assert "Traceback" not in process.stderr.read()
            assert not list(temporary.iterdir())
        finally:
            process.kill()


def save_with(book, **entries):
    workbook = load_workbook(book)
    for name, value in entries.items():
        cell_named(workbook, name).value = value
    workbook.save(book)


def line_with(process, words):
    return next(line for line in process.stdout if words in line)


def test_it_tells_the_verdict_here_and_on_its_page_until_ctrl_c(book):
    with watching(book) as process:
        host, token = ADDRESS.match(process.stdout.readline()).groups()
        assert "agree" in line_with(process, f"{book.name}: ").lower()
        save_with(book, timing_rate=41.0)
        assert "41" in line_with(process, " → 41")
        line_with(process, "own checks: all ")
        connection = http.client.HTTPConnection(host, timeout=60)
        connection.request("GET", "/now", headers={"Cookie": f"{COOKIE}={token}", "Host": host})
        page = connection.getresponse().read().decode()
        assert 'data-state="OK"' in page
        assert "machine&#x27;s book.xlsx" in page
        assert "Entries that this save changed" in page
        connection.request("GET", "/now", headers={"Host": host})
        assert connection.getresponse().status == 403
    assert process.returncode == 0


def test_once_ends_with_the_verdict_on_the_next_save(book):
    with watching(book, "--once", "--json") as process:
        pass_on = iter(process.stdout)
        for rate in (42.0, 43.0, 44.0, 45.0):  # until it has begun
            save_with(book, timing_rate=rate)
            try:
                process.wait(8)
                break
            except subprocess.TimeoutExpired:
                continue
        verdicts = [json.loads(line) for line in pass_on]
    assert process.returncode == 0
    assert verdicts[-1]["verdict"] == "agrees"
    assert verdicts[-1]["whole"] is True


def test_it_ends_with_its_input_where_a_program_began_it_so(book):
    with watching(book, "--json", "--until-eof") as process:
        verdict = json.loads(process.stdout.readline())
        process.stdin.close()
        process.wait(60)
    assert process.returncode == 0
    assert verdict["findings"] == []


def test_a_name_of_no_file_is_refused_in_a_line(tmp_path):
    command = [sys.executable, "-m", "workbook", "watch", str(tmp_path / "none.xlsx")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.endswith("none.xlsx: there is no such file or folder\n")
