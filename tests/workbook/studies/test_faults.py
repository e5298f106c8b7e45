"""What goes wrong on the way: no room, an interruption, a worker killed, the scheduler gone, another study there."""

import contextlib
import json
import os
import random
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.workbook.composed import small
from tests.workbook.studies.studied import laws, planned, stops, written
from workbook.build import build
from workbook.cluster import pool
from workbook.errors import WriteError
from workbook.pool import THIS_PROCESS
from workbook.studies.folder import Parts, progress
from workbook.studies.run import run
from workbook.template import FOLDER

GOALS = {"minimise": ["drive1_rms"]}
VARIED = (laws("MTP", "CUB", "CIC"), stops(80, 120, 12))
DESIGNS, PART = 36, 12
POSIX = pytest.mark.skipif(sys.platform == "win32", reason="signals and limits of POSIX")


def command(*arguments, **options):
    told = [sys.executable, "-m", "workbook", "study", *map(str, arguments), "--unverified"]
    return subprocess.run(told, capture_output=True, text=True, check=False, encoding="utf-8", **options)


def parts_of(plan, results):
    """Where a study keeps its parts, of some designs each."""
    return Parts(results, plan.digest, plan.space.size, PART)


def studied(plan, parts, told=lambda count, before: None, workers=THIS_PROCESS, resume=False):
    """Work a study out in its folder, and leave that."""
    with parts.opened(resume, False):
        return run(plan, parts, workers, told)


def stop_after(parts):
    """What ends a study after so many parts."""
    seen = []

    def told(count, before):
        seen.append(count)
        if len(seen) == parts:
            raise KeyboardInterrupt

    return told


def test_a_study_goes_on_from_its_complete_parts_and_counts_nothing_twice(tmp_path):
    plan = planned(tmp_path, *VARIED, **GOALS)
    whole = studied(plan, parts_of(plan, tmp_path / "whole.csv"))
    parts = parts_of(plan, tmp_path / "cut.csv")
    with pytest.raises(KeyboardInterrupt):
        studied(plan, parts, stop_after(2))
    (parts.folder / "part-00000002.csv").write_text("half of a par")  # without what says it is whole
    (parts.folder / ".part-00000002.json").write_text("{")  # the draft of a process that ended while it wrote
    assert progress(tmp_path / "cut.csv")[0] == 2 * parts.step
    assert parts.complete() == {0, 1}
    fresh = []
    again = studied(plan, parts, lambda count, before: fresh.append((count, before)), resume=True)
    assert again == whole
    assert [before for _, before in fresh] == [True, True, False]
    assert sum(count for count, _ in fresh) == again.designs == DESIGNS


def test_a_search_goes_on_from_its_complete_parts_to_the_same_end(tmp_path):
    way = {"kind": "evolution", "designs": 90, "seed": 5}
    plan = planned(tmp_path, stops(80, 120), way=way, **GOALS)
    whole = studied(plan, parts_of(plan, tmp_path / "whole.csv"))
    parts = parts_of(plan, tmp_path / "cut.csv")
    with pytest.raises(KeyboardInterrupt):
        studied(plan, parts, stop_after(3))
    assert studied(plan, parts, resume=True) == whole
    assert whole.best[0].entries["axes.MC01.phases[1].stop"] == pytest.approx(120.0, abs=0.5)


@pytest.mark.parametrize("damaged", [b"", b"half of a par", None])
def test_a_part_whose_rows_are_not_those_written_is_worked_out_again(damaged, tmp_path):
    plan = planned(tmp_path, *VARIED, **GOALS)
    parts = parts_of(plan, tmp_path / "cut.csv")
    with pytest.raises(KeyboardInterrupt):
        studied(plan, parts, stop_after(2))
    rows = parts.rows(1)
    before = rows.read_bytes()
    rows.unlink() if damaged is None else rows.write_bytes(damaged)
    assert parts.complete() == {0}
    assert studied(plan, parts, resume=True).designs == DESIGNS
    assert rows.read_bytes() == before


def test_what_else_lies_in_the_folder_of_parts_does_no_harm_and_stays(tmp_path):
    plan = planned(tmp_path, *VARIED, **GOALS)
    parts = parts_of(plan, tmp_path / "r.csv")
    parts.folder.mkdir()
    own = [parts.folder / name for name in ("part-mine.json", "part-1.txt", "notes.txt", "part-00000000.csv.bak")]
    for one in own:
        one.write_text("mine")
    assert studied(plan, parts).designs == DESIGNS
    parts.remove()
    assert sorted(parts.folder.iterdir()) == sorted(own)


def test_a_scheduler_that_is_none_leaves_nothing_behind(tmp_path):
    written(tmp_path, *VARIED, **GOALS)
    before = sorted(tmp_path.iterdir())
    done = command("study.toml", "--scheduler", "nonsense", cwd=tmp_path)
    assert (done.returncode, len(done.stderr.splitlines())) == (2, 1)
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.sample(1)
@pytest.mark.parametrize("count", [2, 1])
def test_a_port_that_takes_a_connection_and_says_nothing_is_told_in_its_time(count, tmp_path):
    books = [tmp_path / f"{k}.xlsx" for k in range(count)]
    for book in books:
        build(small(), book)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        told = [sys.executable, "-m", "workbook", "verify", *map(str, books), "--scheduler", address]
        done = subprocess.run(told, capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, len(done.stderr.splitlines())) == (2, 1)
    assert "no scheduler answers there" in done.stderr


def test_sobols_designs_are_the_same_however_they_are_parted(tmp_path):
    space = planned(tmp_path, laws("MTP", "CUB"), stops(80, 120), way={"kind": "sobol", "designs": 64}, **GOALS).space
    whole, parted = space.sobol(0, 64), [space.sobol(0, 20), space.sobol(20, 64)]
    assert (whole == [*parted[0], *parted[1]]).all()
    assert whole.min() >= 0.0
    assert whole.max() < 1.0


def test_a_second_study_in_the_folder_is_refused_and_so_is_another_ones_folder(tmp_path):
    plan = planned(tmp_path, *VARIED, **GOALS)
    parts = parts_of(plan, tmp_path / "r.csv")
    with parts.opened(False, False), pytest.raises(WriteError, match="another study is at work"):
        studied(plan, parts)
    with pytest.raises(WriteError, match="0 complete parts of this study; --resume goes on"):
        studied(plan, parts)
    other = Parts(tmp_path / "r.csv", "another", plan.space.size)
    with pytest.raises(WriteError, match="parts of another study"):
        studied(plan, other, resume=True)


@POSIX
def test_no_room_to_write_is_a_line_and_the_study_goes_on_when_there_is(tmp_path):
    import resource

    study = written(tmp_path, *VARIED, **GOALS)
    small = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))  # noqa: E731 - for the child alone
    done = command(study, "--jobs", 1, cwd=tmp_path, preexec_fn=small)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert "cannot be written: File too large" in done.stderr
    assert not (tmp_path / "study.csv").exists()
    assert command(study, "--jobs", 1, "--resume", cwd=tmp_path).returncode == 0
    assert len((tmp_path / "study.csv").read_text(encoding="utf-8").splitlines()) == DESIGNS + 1


def test_a_command_that_is_interrupted_says_what_is_kept(tmp_path, monkeypatch, capsys):
    from workbook.commands import study as command_

    study, results = written(tmp_path, *VARIED, **GOALS), tmp_path / "r.csv"
    monkeypatch.setattr("workbook.studies.run.MOST_ROWS", PART)
    monkeypatch.setattr(
        command_, "run", lambda plan, parts, workers, told: run(plan, parts, THIS_PROCESS, stop_after(2))
    )
    with pytest.raises(KeyboardInterrupt):
        command_.study(study, results, None, 1, False, None, True, False)
    said = " ".join(capsys.readouterr().err.split())
    assert "Interrupted." in said
    assert "holds 2 complete parts of this study; --resume goes on with them" in said


@POSIX
@pytest.mark.parametrize("kills", [3, pytest.param(25, marks=pytest.mark.nightly)])
def test_a_command_killed_at_any_time_goes_on_to_the_same_bytes(tmp_path, monkeypatch, kills):
    monkeypatch.setattr("workbook.studies.run.MOST_ROWS", 4)
    study = written(tmp_path, laws("MTP", "CUB"), stops(80, 120, 16), **GOALS)
    begin = time.monotonic()
    assert forked(study, tmp_path / "whole.csv", False).ended() == 0
    lasts, rng, cut, killed = time.monotonic() - begin, random.Random(kills), tmp_path / "cut.csv", 0
    while not cut.with_suffix(".html").exists() and killed < kills:
        killed += forked(study, cut, True).killed_after(rng.uniform(0.05, 0.6) * lasts)
    if not cut.with_suffix(".html").exists():
        assert forked(study, cut, True).ended() == 0
    for suffix in (".csv", ".json"):
        assert (tmp_path / f"cut{suffix}").read_bytes() == (tmp_path / f"whole{suffix}").read_bytes()
    assert killed


@POSIX
@pytest.mark.parametrize("written_so_far", [1, 2, 3])
def test_a_command_killed_while_it_writes_its_results_goes_on(tmp_path, monkeypatch, written_so_far):
    """Results, what is known of them, and the page are three files: some of them may be there already."""
    from workbook.commands import study as command_
    from workbook.writing import output_files

    study, results = written(tmp_path, laws("MTP", "CUB"), **GOALS), tmp_path / "r.csv"
    placed, count = command_.replace, []

    def replace(*arguments):
        placed(*arguments)
        count.append(arguments)
        if len(count) == written_so_far:
            raise KeyboardInterrupt

    for module in (command_, output_files):
        monkeypatch.setattr(module, "replace", replace)
    with pytest.raises(KeyboardInterrupt):
        command_.study(study, results, None, 1, False, None, True, False)
    with pytest.raises(WriteError, match="the file exists"):
        command_.study(study, results, None, 1, False, None, True, False)
    assert command_.study(study, results, None, 1, True, None, True, False) == 0
    assert len(results.read_text(encoding="utf-8").splitlines()) == 3


class forked:  # noqa: N801 - reads as what it does
    """The command in a process of its own, which has all modules already."""

    def __init__(self, study, results, resume):
        from workbook.commands.study import study as command_

        self.id = os.fork()
        if not self.id:
            with Path(os.devnull).open("w") as nowhere:
                os.dup2(nowhere.fileno(), 1)
                os.dup2(nowhere.fileno(), 2)
                code = 70
                with contextlib.suppress(BaseException):
                    code = command_(study, results, None, 1, resume, None, True, False)
            os._exit(code)

    def ended(self):
        return os.waitstatus_to_exitcode(os.waitpid(self.id, 0)[1])

    def killed_after(self, seconds):
        """Kill it; return whether it was alive until then."""
        time.sleep(seconds)
        os.kill(self.id, signal.SIGKILL)
        return self.ended() == -signal.SIGKILL


class Killing:
    """A pool that kills one of its workers when the first piece is done."""

    def __init__(self, workers):
        self.workers, self.killed = workers, False

    def each(self, function, tasks, *shared):
        for found in self.workers.each(function, tasks, *shared):
            if not self.killed:
                self.killed = True
                ids = self.workers.client.run(os.getpid)
                os.kill(next(iter(ids.values())), signal.SIGKILL)
            yield found


@POSIX
def test_a_worker_that_is_killed_in_the_middle_costs_no_design(tmp_path):
    plan = planned(tmp_path, *VARIED, **GOALS)
    whole = studied(plan, parts_of(plan, tmp_path / "whole.csv"))
    with pool(2, None) as workers:
        killing = Killing(workers)
        found = studied(plan, parts_of(plan, tmp_path / "cut.csv"), workers=killing)
    assert killing.killed
    assert found == whole


@contextlib.contextmanager
def cluster(folder, odd=""):
    """A scheduler and two workers, each a process of its own; the second begins by running what is ``odd``."""
    file, begun = folder / "scheduler.json", []

    def begin(module, *arguments):
        told = [sys.executable, "-m", f"distributed.cli.{module}", *arguments, "--scheduler-file", str(file)]
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        begun.append(subprocess.Popen([*told, "--dashboard-address", "127.0.0.1:0"], cwd=folder, **quiet))

    try:
        begin("dask_scheduler", "--host", "127.0.0.1", "--port", "0")
        deadline = time.monotonic() + 60
        while not file.exists() and time.monotonic() < deadline:
            time.sleep(0.1)
        (folder / "odd.py").write_text(odd, encoding="utf-8")
        for preload in ([], ["--preload", str(folder / "odd.py")]):
            begin("dask_worker", "--nthreads", "1", "--no-nanny", "--local-directory", str(folder), *preload)
        yield json.loads(file.read_text())["address"], begun
    finally:
        for one in begun:
            one.kill()
            one.wait()


def until_ready(address):
    """Wait for both workers."""
    from distributed import Client

    with Client(address) as client:
        client.wait_for_workers(2, timeout=60)


@POSIX
def test_a_scheduler_that_goes_is_a_line_and_another_ones_workers_complete_the_study(tmp_path):
    study = written(tmp_path, laws("MTP", "CUB"), stops(80, 120, 150), **GOALS)
    with cluster(tmp_path) as (address, processes):
        until_ready(address)
        told = [sys.executable, "-m", "workbook", "study", str(study), "--unverified", "--scheduler", address]
        started = subprocess.Popen(told, cwd=tmp_path, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        folder, deadline = Path(tmp_path, "study.csv.parts"), time.monotonic() + 120
        while not list(folder.glob("part-*.json")) and time.monotonic() < deadline:
            time.sleep(0.05)
        processes[0].kill()
        _, said = started.communicate(timeout=120)
    assert (started.returncode, len(said.splitlines())) == (2, 1), said
    assert f"the scheduler {address} is gone" in said
    done = command(study, "--jobs", 1, "--resume", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert len((tmp_path / "study.csv").read_text(encoding="utf-8").splitlines()) == 301


@POSIX
def test_a_worker_of_another_version_is_told_in_a_line(tmp_path):
    study = written(tmp_path, laws("MTP", "CUB"), **GOALS)
    with cluster(tmp_path, 'import workbook\nworkbook.__version__ = "0.0.1"') as (address, _):
        until_ready(address)
        done = command(study, "--scheduler", address, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    (line,) = done.stderr.splitlines()
    assert "has motionbook 0.0.1; expected" in line
    assert not (tmp_path / "study.csv").exists()


@POSIX
@pytest.mark.nightly
def test_a_cluster_finds_the_gains_that_this_process_finds(tmp_path):
    improve = [sys.executable, "-m", "workbook", "improve", str(FOLDER / "cutting-machine.toml")]
    alone = subprocess.run(improve, capture_output=True, text=True, check=True)
    with cluster(tmp_path) as (address, _):
        until_ready(address)
        shared = subprocess.run([*improve, "--scheduler", address], capture_output=True, text=True, check=True)
    assert "Best laws" in alone.stdout
    assert shared.stdout == alone.stdout


def deep(number):
    return deep(number + 1)


def test_too_deep_a_recursion_ends_the_work_and_does_not_hang_it():
    with pool(2, None) as workers, pytest.raises(RuntimeError, match="recursion"):
        list(workers.each(deep, [1]))
