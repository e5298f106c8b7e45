"""The command as a program of its own: its memory and time."""

import os
import signal
import subprocess
import sys

from workbook.template import FOLDER

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
