"""The command as a program of its own: its memory and time; and thousands of times, forked from one that is loaded.

``python -m tests.workbook.reading.forks FOLDER`` takes a line of arguments (JSON) after the other, and answers each
with exit code, what was said on both channels, largest memory (KiB) and CPU time (s).
"""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

from workbook.template import FOLDER

LATEST = 200  # seconds
KIB, GIB, SECONDS = 1024, 2**30, 20
MEASURED = """
import os, resource, subprocess, sys
code = subprocess.call([sys.executable, "-m", "workbook", *sys.argv[2:]])
used = resource.getrusage(resource.RUSAGE_CHILDREN)
os.write(int(sys.argv[1]), f"{used.ru_maxrss} {used.ru_utime + used.ru_stime}".encode())
sys.exit(code)
"""  # between the tests and the command: its only child is the command, and a small program has forked it


def run(*arguments, folder, most=GIB):
    """Run the command as a program of its own, in little memory; its exit code, what it says and its CPU time."""
    told, tell = os.pipe()
    child = subprocess.Popen(
        [sys.executable, "-c", MEASURED, str(tell), *map(str, arguments)], cwd=folder, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, env=os.environ | {"OPENBLAS_NUM_THREADS": "1", "PYTHONPATH": str(FOLDER.parent)},
        pass_fds=[tell], start_new_session=True,
    )  # fmt: skip
    os.close(tell)
    with os.fdopen(told) as measured:
        try:
            out, err = child.communicate(timeout=10 * SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            child.communicate()
            return None, "", "", 10 * SECONDS
        memory, seconds = measured.read().split()
    assert int(memory) * KIB < most, arguments
    return child.returncode, out.decode(errors="replace"), err.decode(errors="replace"), float(seconds)


class Server:
    """The process that has the command loaded."""

    def __init__(self, folder):
        kept = os.environ | {"OPENBLAS_NUM_THREADS": "1", "PYTHONPATH": str(FOLDER.parent)}
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.workbook.reading.forks", str(folder)], text=True, env=kept,
            cwd=FOLDER.parent, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        )  # fmt: skip

    def run(self, *arguments):
        """Exit code (None of one that was killed), both channels, memory in KiB and seconds of CPU."""
        self._process.stdin.write(json.dumps(list(map(str, arguments))) + "\n")
        self._process.stdin.flush()
        return json.loads(self._process.stdout.readline())

    def end(self):
        self._process.communicate()


def served(arguments):
    """Run the command in a fork; what the server answers."""
    pid = os.fork()
    if pid == 0:
        alone(arguments)
    _, status, used = os.wait4(pid, 0)
    said = [Path(name).read_bytes().decode(errors="replace") for name in ("../out", "../err")]
    code = os.WEXITSTATUS(status) if os.WIFEXITED(status) else None
    return [code, *said, used.ru_maxrss, used.ru_utime + used.ru_stime]


def alone(arguments):
    """Become the command: its own channels, and killed where it takes too long."""
    signal.alarm(LATEST)
    for channel, name in ((1, "../out"), (2, "../err")):
        os.dup2(os.open(name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), channel)
    sys.argv = ["motionbook", *arguments]
    code = 1
    try:
        from workbook.cli import main

        main()
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(bool(end.code))
    except BaseException:
        sys.excepthook(*sys.exc_info())
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


def serve(folder):
    """Answer line by line."""
    import workbook.cli
    import workbook.judging.verify
    import workbook.reports.console
    import workbook.witnesses.pycel.model  # noqa: F401 - what the command would load itself

    os.chdir(folder)
    answers = os.fdopen(os.dup(1), "w")
    for line in sys.stdin:
        answers.write(json.dumps(served(json.loads(line))) + "\n")
        answers.flush()


if __name__ == "__main__":
    serve(sys.argv[1])
