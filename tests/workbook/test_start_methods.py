"""Work in other processes, started by forkserver too, which is Python's way on Linux from 3.14 on."""

import asyncio
import multiprocessing
import os
import subprocess
import sys

import pytest

from tests.workbook.studies.studied import laws, stops, written
from workbook.serve import design, work

METHOD = "forkserver"
COMMAND = "import multiprocessing as m, sys; m.set_start_method(sys.argv.pop(1)); from workbook.cli import main; main()"
pytestmark = pytest.mark.skipif(
    METHOD not in multiprocessing.get_all_start_methods(), reason="Windows has no forkserver"
)


@pytest.fixture
def motionbook_by_server(tmp_path):
    """Run the command by that start method, which Dask takes too; return what it printed."""

    def run(*arguments):
        env = os.environ | {"DASK_DISTRIBUTED__WORKER__MULTIPROCESSING_METHOD": METHOD, "COLUMNS": "200"}
        command = [sys.executable, "-c", COMMAND, METHOD, *map(str, arguments)]
        done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True, encoding="utf-8")
        assert (done.returncode, done.stderr) == (0, ""), done.stdout
        return done.stdout

    return run


def test_a_study_is_worked_out_by_a_pool(motionbook_by_server, tmp_path):
    written(tmp_path, laws("MTP", "CUB"), stops(80, 120, 3), minimise=["drive1_rms"])
    motionbook_by_server("study", "study.toml", "--jobs", 2, "--unverified")
    assert len((tmp_path / "study.csv").read_text(encoding="utf-8").splitlines()) == 1 + 2 * 3


def test_what_is_edited_is_worked_out_beside_the_server(monkeypatch):
    monkeypatch.setattr(work, "get_context", lambda _: multiprocessing.get_context(METHOD))

    async def edited():
        beside = work.Work()
        try:
            return await beside.in_worker(design.verdict, "press.toml", "title = 3")
        finally:
            beside.stop()

    assert asyncio.run(edited())["verdict"] == "unfinished"
