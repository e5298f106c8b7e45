"""Every law of the engine keeps what it claims: ends, continuity, coefficients, breaks, pieces, names."""

import math
import pkgutil
import re
from collections import Counter
from dataclasses import fields, replace
from importlib import import_module
from itertools import accumulate

import numpy as np
import pytest

import engine.laws
from engine.laws import (
    CATALOGUE,
    ConstantAcceleration,
    Cubic,
    ModifiedTrapezoidal,
    TrapezoidalVelocity,
    UnknownLawError,
    law,
)
from engine.laws.family import Law
from engine.laws.modified import CLASSIC
from tests.engine.families import ENTRIES
from tests.engine.laws.claims import Claims
from tests.engine.measured import complaints

N = 240_000  # twelfths of the time are samples
LAWS = pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.code)
NAMED = pytest.mark.parametrize("one", CATALOGUE, ids=lambda e: e.code)
NAMES = ("cv", "ca_max", "ca_min", "ca_rms", "cj", "va_max", "va_min")


def claimed(entry):
    """The claimed coefficients as numbers, each formula over the ones before."""
    known = {name: getattr(math, name) for name in ("pi", "sqrt", "inf")}
    for name, formula in (entry.where | entry.coefficients).items():
        known[name] = float(eval(formula, {"__builtins__": {}}, known))
    return {name: known[name] for name in NAMES}


def measured_order(fine, coarse):
    """The highest derivative without a jump: its largest step between samples shrinks with the spacing."""
    order = -1
    for dense, sparse in zip(fine, coarse, strict=True):
        step, wider = np.abs(np.diff(dense)).max(), np.abs(np.diff(sparse)).max()
        if step > max(0.5 * wider, 1e-9):
            break
        order += 1
    return order


@LAWS
def test_claimed_ends(entry):
    made = entry.law()
    assert (made.start.s, made.start.v) == pytest.approx(entry.start, abs=1e-14)
    assert (made.end.s, made.end.v) == pytest.approx(entry.end, abs=1e-14)


@LAWS
def test_claimed_continuity_inside(entry):
    made = entry.law()
    fine, coarse = (made.evaluate(np.linspace(0, 1, n + 1)) for n in (4000, 1000))
    assert measured_order(fine, coarse) == min(entry.order_inside, 3)


@LAWS
def test_claimed_continuity_against_rest(entry):
    made = entry.law()
    ends = [max(abs(begin), abs(end)) for begin, end in zip(made.start[1:], made.end[1:], strict=True)]
    measured = next((order for order, value in enumerate(ends) if value > 1e-9), 3)
    assert measured == min(entry.order_ends, 3)


@LAWS
def test_claimed_coefficients_are_the_laws(entry):
    coefficients = entry.law().coefficients
    for name, value in claimed(entry).items():
        assert getattr(coefficients, name) == pytest.approx(value, rel=1e-12, abs=1e-15), name


@LAWS
def test_claimed_coefficients_are_what_samples_show(entry):
    values, claims = entry.law().evaluate((np.arange(N) + 0.5) / N), claimed(entry)
    power = values.v * values.a
    shown = {
        "cv": np.abs(values.v).max(), "ca_max": values.a.max(), "ca_min": values.a.min(),
        "ca_rms": math.sqrt(np.mean(values.a**2)), "va_max": power.max(), "va_min": power.min(),
    }  # fmt: skip
    if math.isfinite(claims["cj"]):
        shown["cj"] = np.abs(values.j).max()
    for name, value in shown.items():
        assert value == pytest.approx(claims[name], rel=3e-5, abs=1e-12), name


@LAWS
def test_jerk_is_infinite_exactly_where_the_acceleration_jumps(entry):
    """Where the velocity itself jumps, against rest, the coefficients are those of the law between its ends."""
    jumps = min(entry.order_ends, entry.order_inside) == 1
    assert math.isinf(entry.law().coefficients.cj) == jumps


@LAWS
def test_position_velocity_and_acceleration_are_integrals(entry):
    made = entry.law()
    xi = np.linspace(0, 1, N + 1)
    at, middle = made.evaluate(xi), made.evaluate((xi[1:] + xi[:-1]) / 2)
    smooth = math.isfinite(made.coefficients.cj)
    for value, rate in list(zip(at[:3], middle[1:], strict=True))[: 3 if smooth else 2]:
        carried = value[0] + np.cumsum(rate) / N
        assert np.abs(carried - value[1:]).max() < 2e-5


@NAMED
def test_every_name_finds_its_law(one):
    for name in (one.code, one.name, *one.aliases):
        assert law(f" {name.upper()} ") == law(name.lower()) == one()
    assert one.source


def test_every_law_is_in_the_catalogue_and_claims_something():
    """A class of engine.laws is a law where it states its source."""
    files = [import_module(f"engine.laws.{found.name}") for found in pkgutil.iter_modules(engine.laws.__path__)]
    stated = {one.__name__ for file in files for one in vars(file).values() if "source" in getattr(one, "__dict__", ())}
    known = {one.__name__ for one in CATALOGUE}
    assert sorted(stated - {"Law"} - known) == [], "laws that engine/laws/__init__.py does not have in CATALOGUE"
    assert sorted(known - stated) == [], "laws that do not state their source"
    claimed = {entry.law.__name__ for entry in ENTRIES}
    assert sorted(known - claimed) == [], "laws that tests/engine/laws/claims.py does not have in CLAIMS"


def test_the_documents_names_are_known():
    names = ("ACS", "TVP", "CUB", "Cubic", "CIC", "Cycloidal", "Dwell", "ModTVP", "Modified trapezoidal")
    codes = [law(name).code for name in names]
    assert codes == ["ACS", "TVP", "CUB", "CUB", "CIC", "CIC", "DWL", "MTP", "MTP"]


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


def law_entry(code):
    return next(entry for entry in ENTRIES if entry.code == code)


@LAWS
def test_breaks_and_coefficients_are_those_of_the_law(entry):
    assert complaints(entry) == []


class NoBreaks(ConstantAcceleration):
    breaks = ()


class ABreakTooFew(TrapezoidalVelocity):
    @property
    def breaks(self):
        return (self.rise_end,)


class BreaksOfTheDefault(ModifiedTrapezoidal):
    @property
    def breaks(self):
        return tuple(accumulate(CLASSIC[:6]))


class ABreakAtTheWrongPlace(TrapezoidalVelocity):
    @property
    def breaks(self):
        return self.rise_end, self.fall_start + 1e-6


class AGreaterCoefficient(ModifiedTrapezoidal):
    @property
    def coefficients(self):
        found = super().coefficients
        return replace(found, va_max=found.va_max * (1 + 1e-5))


WRONG = {
    "breaks": (NoBreaks, ABreakTooFew, BreaksOfTheDefault, ABreakAtTheWrongPlace),
    "coefficients": (AGreaterCoefficient,),
}


@pytest.mark.parametrize(("what", "wrong"), [(what, one) for what, all_of in WRONG.items() for one in all_of])
def test_a_law_registered_with_wrong_figures_is_caught_by_name(what, wrong):
    entry = law_entry(wrong.code)
    others = tuple(wrong(**{f.name: getattr(one, f.name) for f in fields(one)}) for one in entry.others)
    found = complaints(replace(entry, law=wrong, others=others, beyond=entry.beyond))
    assert any(f"{wrong.__name__}" in words and f": {what}: " in words for words in found), found


class Unsaid(Law):
    """A law that leaves out what every law must state."""

    code, name = "XYZ", "Unsaid"


@pytest.mark.parametrize(
    ("registered", "named"),
    [
        (Unsaid, "Unsaid .*as_pieces"),
        (lambda: replace(law_entry("TVP"), others=(), beyond=()), "TrapezoidalVelocity: lacks .* rise_end, fall_start"),
        (
            lambda: replace(law_entry("TVP"), others=(TrapezoidalVelocity(0.2),), beyond=()),
            "TrapezoidalVelocity: lacks among its other examples one with another ends, fall_start",
        ),
        (
            lambda: Claims(Cubic, 1, 1, {"cv": "2"}),
            "Cubic: lacks the claim of ca_max, ca_min",
        ),
    ],
)
def test_what_a_law_leaves_out_is_named_when_it_is_registered(registered, named):
    with pytest.raises(TypeError, match=named):
        registered()
