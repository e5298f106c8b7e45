"""The order of operators that Excel documents, as pycel and formulon compute it.

"Calculation operators and precedence in Excel" (support.microsoft.com): reference operators, negation, percent, power,
product and quotient, sum and difference, joining of texts, comparison; of equal rank from left to right.
"""

import openpyxl
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.workbook.evaluated import by_formulon
from workbook.reading.contents import Contents
from workbook.witnesses.pycel.model import PycelModel

DOCUMENTED = {
    "=-2^2": 4, "=-20^2+900": 1300, "=900-20^2": 500, "=0-2^2": -4, "=(-2)^2": 4, "=-(2^2)": -4, "=-(2)^2": 4,
    "=--2^2": 4, "=---2^3": -8, "=-+-2^2": 4, "=2^-2": 0.25, "=2^-2^2": 0.0625, "=2^3^2": 64, "=-2^3^2": 64,
    "=-A1^2": 9, "=-A1^2+A1": 12, "=1--A1^2": -8, "=1+-A1^2": 10, "=2*-A1^2": 18, "=-A1*A1^2": -27, "=-A1^A2": 9,
    "=-SUM(A1:A2)^2": 25, "=-SUM(-A1^2,A2)^2": 121, "=-SUM((A1))^2": 9, "=-(A1+A2)^2": 25, "=-(A1-(A2+1))^2": 0,
    "=-2%": -0.02, "=-2%^2": 0.0004, "=200%^2": 4, "=4^50%": 2, "=-50%*2": -1, "=10+10%": 10.1, "=-(50%)^2": 0.25,
    "=1+2*3": 7, "=12/2/3": 2, "=2*3^2": 18, "=12/2*3": 18, "=7-2-1": 4, "=-1-2": -3, "=2-(-A1)^2": -7,
    '=1+2&"x"': "3x", '=-2^2&"x"': "4x", '=2*3&4': "64", "=1&2=12": False, '=1&2="12"': True, "=1+1=2": True,
    "=-2^2=4": True, "=2<3": True, "=-A1^2>0": True, "=3>2=TRUE": True, "=1<2<3": False, "=-2 ^ 2": 4,
    "=IF(-A1^2>0,-A2^2,0)": 4, "=-PI()^2": 9.869604401089358,
}  # fmt: skip


def computed(formula):
    """What pycel and formulon make of a formula on a sheet with 3 in A1 and 2 in A2."""
    workbook = openpyxl.Workbook()
    page = workbook.active
    page["A1"], page["A2"], page["B1"] = 3, 2, formula
    (ours,) = PycelModel(Contents(workbook)).evaluate().values()
    return ours, by_formulon(workbook)[page.title, 1, 2]


@pytest.mark.parametrize(("formula", "value"), DOCUMENTED.items())
def test_operators_in_the_documented_order(formula, value):
    ours, theirs = computed(formula)
    expected = pytest.approx(value, rel=1e-14) if type(value) in (int, float) else value
    assert (ours, theirs) == (expected, expected)


@pytest.mark.parametrize(
    ("formula", "value"),
    [("=(-8)^(1/3)", -2), ("=-8^(1/3)", -2), ("=(-32)^0.2", -2), ("=(-8)^-(1/3)", -0.5), ("=(-4)^0.5", "#NUM!"),
     ("=(-8)^(2/3)", "#NUM!"), ("=(-8)^0.33", "#NUM!"), ("=0^(1/3)", 0),
     ("=POWER(-8,1/3)", -2), ("=POWER(-2,3)", -8), ("=POWER(-4,0.5)", "#NUM!")],
)  # fmt: skip
def test_pycel_takes_odd_roots_of_negative_numbers(formula, value):
    """As Excel, LibreOffice, formulon and IronCalc do."""
    assert computed(formula)[0] == (pytest.approx(value, rel=1e-14) if value != "#NUM!" else value)


@pytest.mark.parametrize(
    ("formula", "value"),
    [("=0.1+0.2=0.3", True), ("=1.1*1.1=1.21", True), ("=0.1+0.2>0.3", False), ("=0.1+0.2<=0.3", True),
     ("=0.1+0.2<>0.3", False), ("=1.1*3/1.1=A1", True), ("=1*(0.5-0.4-0.1)=0", False), ("=1+1E-14=1", False),
     ("=SUMPRODUCT((A1:A2*1.1=3.3)*1)", 1), ("=0^0", "#NUM!"), ("=POWER(0,0)", "#NUM!"), ("=0^2", 0)],
)  # fmt: skip
def test_pycel_compares_to_15_digits_and_knows_no_0_to_the_power_of_0(formula, value):
    assert computed(formula)[0] == value


OPERANDS = st.sampled_from(["1", "2", "3", "A1", "A2", "2%", "SUM(A1,A2)"])
EXPRESSIONS = st.recursive(
    OPERANDS,
    lambda inner: st.one_of(
        st.tuples(st.sampled_from(["-", "--", "+", "-+"]), inner).map("".join),
        st.tuples(inner, st.sampled_from(["+", "-", "*", "/", "^", "^", "^-"]), inner).map("".join),
        inner.map("({})".format),
        inner.map("SUM({},1)".format),
    ),
    max_leaves=6,
)


@given(EXPRESSIONS)
def test_signs_and_powers_anywhere(expression):
    ours, theirs = computed(f"={expression}")
    assume(isinstance(ours, int | float) and isinstance(theirs, int | float))
    assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-12)
