"""Every law of the engine keeps what it claims: ends, continuity, coefficients, breaks, pieces, names."""

import math
import pkgutil
import re
from collections import Counter
from importlib import import_module

import pytest

import engine.laws
from engine.laws import CATALOGUE, UnknownLawError, law
from engine.laws.polynomials import Cubic
from engine.laws.simple import ConstantAcceleration
from tests.engine.families import ENTRIES
from tests.engine.measured import complaints

LAWS = pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.code)
NAMED = pytest.mark.parametrize("one", CATALOGUE, ids=lambda e: e.code)
NAMES = ("cv", "ca_max", "ca_min", "ca_rms", "cj", "va_max", "va_min")


def claimed(entry):
    """The claimed coefficients as numbers, each formula over the ones before."""
    known = {name: getattr(math, name) for name in ("pi", "sqrt", "inf")}
    for name, formula in (entry.where | entry.formulas).items():
        known[name] = float(eval(formula, {"__builtins__": {}}, known))
    return {name: known[name] for name in NAMES}


@LAWS
def test_claimed_ends(entry):
    made = entry.law()
    assert (made.start.s, made.start.v) == pytest.approx(entry.start, abs=1e-14)
    assert (made.end.s, made.end.v) == pytest.approx(entry.end, abs=1e-14)


@LAWS
def test_claimed_coefficients_are_the_laws(entry):
    coefficients = entry.law().coefficients
    for name, value in claimed(entry).items():
        assert getattr(coefficients, name) == pytest.approx(value, rel=1e-12, abs=1e-15), name


@NAMED
def test_every_name_finds_its_law(one):
    for name in (one.code, one.name, *one.aliases):
        assert law(f" {name.upper()} ") == law(name.lower()) == one()
    assert one.source


def test_every_law_has_a_number_and_claims_something():
    """A class of engine.laws is a law where it states its source."""
    files = [import_module(f"engine.laws.{found.name}") for found in pkgutil.iter_modules(engine.laws.__path__)]
    stated = {one.__name__ for file in files for one in vars(file).values() if "source" in getattr(one, "__dict__", ())}
    known = {one.__name__ for one in CATALOGUE}
    assert sorted(stated - {"Law"} ^ known) == [], "laws that state a source or a number, and not the other"
    assert [one.number for one in CATALOGUE] == [*range(1, len(CATALOGUE) + 1)], "numbers twice, or left out"
    claimed = {entry.law.__name__ for entry in ENTRIES}
    assert sorted(known - claimed) == [], "laws that tests/engine/laws/claims.py does not have in CLAIMS"


def shared_names(laws):
    """The names, in letters and digits as they are looked up, by which more than one law is known."""
    names = [{re.sub(r"[\W_]", "", name.casefold()) for name in (one.code, one.name, *one.aliases)} for one in laws]
    counted = Counter(key for keys in names for key in keys)
    return [key for key, count in counted.items() if count > 1]


def test_no_name_means_two_laws():
    assert shared_names(CATALOGUE) == []
    assert shared_names([ConstantAcceleration, type("Cubic", (Cubic,), {"aliases": ("Parabolic",)})]) == ["parabolic"]


def test_an_unknown_name_is_met_with_the_three_most_like_it():
    with pytest.raises(UnknownLawError, match=r"'splint'; expected one of spline, [^,]+, [^,]+$"):
        law("splint")


@pytest.mark.parametrize(
    ("name", "code"),
    [("3–4–5", "PO5"), ("345", "PO5"), ("Poly 3-4-5", "PO5"), ("mod. sine", "MSN"), ("MODIFIED_SINE", "MSN"),
     ("s curve", "SCV"), ("cycloidal", "CIC"), ("modified-trapezoid", "MTP"), ("4-5-6-7", "PO7")],
)  # fmt: skip
def test_case_blanks_and_dashes_of_a_name_do_not_matter(name, code):
    assert law(name).code == code


def test_parameters_reach_the_law():
    assert law("tvp", rise_end=0.2, fall_start=0.7).rise_end == 0.2
    assert law("ModTVP", durations=[0, 0.5, 0, 0, 0, 0.5, 0]).durations == (0, 0.5, 0, 0, 0, 0.5, 0)


@LAWS
def test_coefficients_and_peak_are_those_of_the_law(entry):
    assert complaints(entry) == []
