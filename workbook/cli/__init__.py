"""The command ``motionbook``: what can be asked of it. What is done stands in :mod:`workbook.commands`.

A command's module is loaded when it is called, so that help and a wrong option are told at once.
"""

import sys
from pathlib import Path

from typer.exceptions import TyperException

from workbook.cli import tools
from workbook.cli.books import app
from workbook.errors import AGREES, UNREADABLE, MotionbookError
from workbook.failure import failure_line
from workbook.reports.terminal import ERR, say, tolerant_outputs

__all__ = ["app", "main", "tools"]


def main() -> None:
    """Run the command; what the file or the engineer can mend is said in lines, without a traceback.

    A terminal that takes no more, as ``| head -1`` leaves one, does not change the exit code; a file that is full does.
    """
    with tolerant_outputs() as fault_of_output:
        code = run_command()
        fault = fault_of_output()
        if fault is not None and not isinstance(fault, BrokenPipeError):
            say(ERR, f"what was to be printed could not be written: {fault.strerror}", "red")
            code = UNREADABLE
    sys.exit(code)


def run_command() -> int:
    """Return the exit code of the command, its faults told."""
    try:
        # what typer prints by itself is not escaped
        return int(app(standalone_mode=len(sys.argv) < 2) or AGREES)
    except TyperException as error:
        message = error.format_message().replace("Value error, ", "")  # pydantic's words
        say(ERR, f"{message} See --help.", "red")
    except MotionbookError as error:
        for line in str(error).splitlines():
            say(ERR, line, "red")
    except Exception as error:  # to whoever runs it, a fault of ours is no verdict either
        if sys.flags.dev_mode:
            raise
        say(ERR, fault_of(error), "red")
    return UNREADABLE


def fault_of(error: Exception) -> str:
    """Return a line about what nobody has foreseen, or about a folder that was removed while one is in it."""
    if isinstance(error, FileNotFoundError):
        try:
            Path.cwd().stat()
        except OSError:
            return "the folder in which this runs is no longer there; go to another one"
    return failure_line("motionbook failed inside", error, sys.argv[1:])
