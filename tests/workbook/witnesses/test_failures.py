"""An evaluator that fails is named in a line with its version and Python's; the book is not to blame: exit code 2."""

import ast
import sys
from functools import partial
from importlib.metadata import version

import openpyxl
import pytest

from workbook.witnesses import engines
from workbook.witnesses.pycel import compiled, model
from workbook.witnesses.registry import WITNESSES, load_witness

DECLARED = """from workbook.oracle import Oracle
book = Oracle("Three times")
x = book.input("A1", low=1, high=5)
@book.output("B1")
def y(x):
    return 3 * x
"""
PYTHON = "Python {}.{}".format(*sys.version_info)


def raises(error):
    def function(*_):
        raise error

    return function


@pytest.fixture
def fails(press, motionbook, capsys):
    """Verify a right book by a witness that fails; return the one line that says so."""

    def run(witness):
        code, out, err = motionbook("verify", press.path, "--with", witness)
        assert (code, out) == (2, ""), out
        assert " finding" not in err
        line = " ".join(err.split())
        assert line.startswith(f"{press.path}: ")
        return line

    return run


def test_pycel_without_what_it_rests_on(fails, monkeypatch):
    compiled.compiled.cache_clear()
    model.require_working.cache_clear()
    monkeypatch.setattr(compiled.excelformula, "ast", ast)
    for name in ("__getattr__", "Str"):
        monkeypatch.delitem(vars(ast), name, raising=False)
    line = fails("pycel")
    compiled.compiled.cache_clear()
    assert f"pycel 1.0b30 ({PYTHON}) fails in a formula whose value is known" in line
    assert "has no attribute 'Str'" in line


def test_pycel_that_raises_in_every_cell(fails, monkeypatch):
    model.require_working()
    monkeypatch.setattr(compiled.FormulaStep, "compute", raises(SystemError("broken")))
    line = fails("pycel")
    assert f"pycel 1.0b30 ({PYTHON}) failed in " in line
    assert "pycel: SystemError: broken" in line


def test_a_witness_of_which_a_module_is_missing(press, motionbook, monkeypatch):
    monkeypatch.setitem(WITNESSES, "pycel", partial(load_witness, "no_such_module", "Pycel"))
    code, out, err = motionbook("verify", press.path)
    assert (code, out) == (2, "")
    assert f"Pycel cannot be loaded by {PYTHON}" in " ".join(err.split())


STAND_INS = {
    "import errors": "import no_such_module",
    "panics": "class Panic(BaseException): pass\nclass Workbook:\n    def load(data): raise Panic('it panicked')",
    "crashes": "import os\nos.abort()",
    "leaves": "import os\nos._exit(0)",
    "prints and raises": "print('hello')\nclass Workbook:\n    def load(data): raise TypeError('odd')",
    "sleeps": "import time\ntime.sleep(60)",
}
"""Modules in place of formulon, and how each fails."""


@pytest.fixture(params=STAND_INS)
def failing_formulon(request, monkeypatch, tmp_path):
    """A formulon that fails: its own process imports it."""
    (tmp_path / "formulon.py").write_text(STAND_INS[request.param], encoding="utf-8")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    monkeypatch.setattr(engines, "TIMEOUT", 1 if request.param == "sleeps" else 60)


def test_an_engine_that_fails_in_any_way(fails, failing_formulon):
    assert f"formulon {version('formulon')} ({PYTHON}) gave no values" in fails("formulon")


def test_an_engine_without_a_value_in_any_cell(fails, monkeypatch):
    monkeypatch.setattr(engines.Session, "ask", lambda session, given: [None] * session.number)
    assert "formula cells, the first " in fails("formulon")


def test_a_book_is_compared_with_declarations_where_formulon_is_not(press, motionbook, monkeypatch, tmp_path):
    monkeypatch.setattr(engines.Formulon, "version", lambda _: None)
    opened = openpyxl.Workbook()
    opened.active.append([2.0, "=A1*3"])
    opened.save(tmp_path / "b.xlsx")
    (tmp_path / "d.py").write_text(DECLARED, encoding="utf-8")
    code, out, err = motionbook("verify", tmp_path / "b.xlsx", "--against", tmp_path / "d.py")
    assert (code, err) == (0, ""), out
