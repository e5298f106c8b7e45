"""Settings for all tests: what is drawn at random, and which tests are the quick ones."""

import gc
import os
import sys
import tempfile
from functools import cache
from pathlib import Path

import pytest
from hypothesis import settings

import workbook  # noqa: F401 - before openpyxl, whose choice of an XML writer it makes
from tests import tiers
from tests.workbook.judging.hands import Known
from tests.workbook.press import registered
from workbook.build import COMMITTED, build
from workbook.cli import main
from workbook.reading.descriptions import read_machine

HERE = Path(__file__).parent
QUICK = [
    HERE / "engine", HERE / "printed", HERE / "workbook/test_titles.py",
    HERE / "workbook/machines/test_cutting_machine.py",
    *(HERE / f"test_{rules}.py" for rules in ("called", "glossary", "project", "start", "structure", "budget")),
]  # fmt: skip
"""Folders and files of the quick tests."""

# A test's verdict must not hang on the speed of the machine, nor, by day, on luck: the same examples each time.
settings.register_profile("day", settings.default, deadline=None, derandomize=True, max_examples=25)
settings.register_profile("night", settings.default, deadline=None, max_examples=300, print_blob=True)


def pytest_addoption(parser):
    parser.addoption("--share", metavar="COMMIT", help="run one part of the night, chosen by the hash of a commit")


def pytest_configure(config):
    remembered = tempfile.TemporaryDirectory()  # what commands remember of books lies there, and not with the user
    config.add_cleanup(remembered.cleanup)
    os.environ |= dict.fromkeys(("XDG_CACHE_HOME", "LOCALAPPDATA"), remembered.name)
    given = config.getoption("--hypothesis-seed", None)
    tiers.night = given or 0
    settings.load_profile("day" if given is None else "night")


def pytest_report_header(config):
    given = config.getoption("--hypothesis-seed", None)
    if given is None:
        return "the examples of every day"
    share = config.getoption("--share")
    part = f"every {tiers.PARTS}th test of the night, chosen by --share={share}; " if share else ""
    return f"{part}a night's examples; again: --hypothesis-seed={given}"


def pytest_ignore_collect(collection_path, config):
    """Leave unread what has no quick test, where only those are asked for."""
    if config.option.markexpr.startswith("quick"):
        near = any(collection_path.is_relative_to(place) or place.is_relative_to(collection_path) for place in QUICK)
        return None if near else True
    return None


@pytest.hookimpl(tryfirst=True)  # before the cases of a night are left out
def pytest_collection_modifyitems(config, items):
    tiers.sampled(items)
    for item in items:
        if is_quick(item.path):
            item.add_marker("quick")
    items[:] = tiers.of_this_night(items)
    if share := config.getoption("--share"):
        items[:] = tiers.shared(items, share)


@cache
def is_quick(path):
    """Whether all tests of a file are quick."""
    return any(path.is_relative_to(place) for place in QUICK)


def pytest_collection_finish():
    """Search less often for garbage: the cells of a book live until its test ends."""
    gc.freeze()
    gc.set_threshold(100_000, 10, 10)


@pytest.fixture
def motionbook(monkeypatch, capsys):
    """Run the command within this process, which begins no others; return its exit code, its output and its errors."""
    monkeypatch.setattr(os, "sched_getaffinity", lambda pid: {0}, raising=False)

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["motionbook", *map(str, arguments)])
        capsys.readouterr()
        with pytest.raises(SystemExit) as left:
            main()
        said = capsys.readouterr()
        assert "Traceback" not in said.out + said.err
        return left.value.code, said.out, said.err

    return run


@pytest.fixture(scope="session")
def committed_book(tmp_path_factory):
    """Give the book of a committed description: that in git, or built once."""
    folder = tmp_path_factory.mktemp("templates")

    def book_of(description):
        if description.stem in COMMITTED:
            return description.with_suffix(".xlsx")
        book = folder / f"{description.stem}.xlsx"
        if not book.exists():
            build(read_machine(description), book)
        return book

    return book_of


@pytest.fixture(scope="module")
def press(tmp_path_factory):
    """A small book as built, of a press; its template is known while a module's tests run."""
    path = tmp_path_factory.mktemp("press") / "book.xlsx"
    with registered() as machine:
        build(machine, path)
        yield Known(path)
