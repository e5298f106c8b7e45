"""The LAMBDA names give what the engine gives, computed by IronCalc."""

import openpyxl
import pytest

from tests.functions import lambdas
from tests.functions.case import Case
from tests.functions.cases import value_cases
from tests.functions.edges import edge_cases
from workbook.functions.addin.motion_functions.library import LAWS
from workbook.functions.declarations import CODES, FUNCTIONS, TAKES
from workbook.laws.registry import FAMILY


def test_the_functions_have_every_law_and_say_what_it_takes():
    known = {*CODES} - {"OWN"}  # which takes rows of pieces
    takes = {code for code in known if FAMILY[code].parameters}
    assert known <= {*LAWS}, "motion_functions/laws.md has no row"
    assert takes == {*TAKES} - {"OWN"}, "motion_functions/laws.md does not say what it takes, or of what takes nothing"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("names")


@pytest.fixture(scope="module")
def answers(folder):
    cases = [*value_cases(), *edge_cases()]
    return list(zip(cases, lambdas.computed(cases, folder / "cases.xlsx"), strict=True))


@pytest.mark.parametrize("function", [f.key for f in FUNCTIONS])
def test_a_function_gives_what_the_engine_gives_and_the_errors_of_built_in_functions(answers, function):
    asked = [(case, found) for case, found in answers if case.function == function]
    wrong = [f"{case.name}: {found}, expected {case.expected}" for case, found in asked if not case.agrees(found)]
    assert len(asked) >= 20
    assert not wrong, "\n".join(wrong[:10])


SEVERAL = {
    "several ξ": ('SUM(MOTION.S("CUB",{0,0.25,0.5,1},0))', 0.15625 + 0.5 + 1.0),
    "several s": ('SUM(MOTION.XI("ACS",{0;0.125;0.875},0))', 0.25 + 0.75),
    "several x": ('SUM(MOTION.VEL({0;1;2;3},{"ACS",2,4;"DWL",2,0}))', 4.0),
    "one of several is no share": ('SUM(MOTION.A("ACS",{0,2},0))', "#NUM!"),
    "a law in an array of one": ('SUM(MOTION.S({"cub"},{0.5;1},0))', 1.5),
    "several laws at once": ('SUM(MOTION.S({"CUB";"ACS"},0.5,0))', "#VALUE!"),
    "a function of functions": ('MOTION.XI("CIC",MOTION.S("CIC",0.3,0),0)', 0.3),
}


@pytest.mark.parametrize("formula", SEVERAL)
def test_a_range_of_abscissae_gives_a_range_of_values(folder, formula):
    text, expected = SEVERAL[formula]
    book = openpyxl.Workbook()
    book.active["A1"] = f"={text}"
    book.save(folder / "several.xlsx")
    (found,) = lambdas.recomputed(folder / "several.xlsx", 1)
    assert Case("S", (text,), expected).agrees(found), f"{formula}: {found}"
