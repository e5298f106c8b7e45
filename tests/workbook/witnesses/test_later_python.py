"""pycel on Pythons that are not here, by an ``ast`` like theirs in a process of its own."""

import ast
import subprocess
import sys

import pytest

from tests import cutting
from tests.later_python import strict
from workbook.build import build
from workbook.template import FOLDER

SAYS = "every one computes what the engine computes"


@pytest.mark.sample(1)
@pytest.mark.parametrize("python", ["3.14", "3.15"])
def test_the_cutting_machine_is_verified_with_the_trees_of_a_later_python(python, tmp_path):
    build(cutting.small(), tmp_path / "book.xlsx")
    command = [sys.executable, "-m", "tests.later_python", python, "verify", str(tmp_path / "book.xlsx")]
    done = subprocess.run(command, cwd=FOLDER.parent, capture_output=True, text=True, encoding="utf-8")
    assert (done.returncode, SAYS in " ".join(done.stdout.split())) == (0, True), done.stdout + done.stderr


def test_python_itself_keeps_its_own_trees():
    known = "import ast; before = dict(vars(ast)); import workbook.witnesses.pycel.model; assert vars(ast) == before"
    subprocess.run([sys.executable, "-W", "ignore", "-c", known], cwd=FOLDER.parent, check=True)


@pytest.mark.parametrize(("given", "named"), [((), {}), ((), {"s": "a"}), (("a",), {"n": 1})])
def test_the_stand_in_refuses_what_python_3_15_refuses(given, named):
    class Constant(ast.Constant):
        __doc__ = ast.Constant.__doc__
        __init__ = strict(ast.Constant.__init__)

    assert ast.dump(Constant("a")) == "Constant(value='a')"
    with pytest.raises(TypeError, match=r"missing|unexpected"):
        Constant(*given, **named)
