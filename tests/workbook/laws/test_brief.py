"""A stage of a law is none, or lasts: what lasts less is refused by the design and by the cells alike."""

from contextlib import suppress

import pytest

from engine.laws.base import BREAK_TOLERANCE
from tests.workbook.cells import computed, disagreeing
from tests.workbook.composed import MACHINE, composed
from workbook.laws import family
from workbook.laws.family import LEAST_STAGE
from workbook.laws.registry import FAMILY

SAID = "a stage lasts less than 0.0001 of the rise; expected that, or none"


def entries(least):
    """Laws one stage of which, or two, last so long."""
    return {
        "TVP 1": {"family": "TVP", "rise_end": least, "fall_start": 0.6},
        "TVP 2": {"family": "TVP", "rise_end": 0.5, "fall_start": 0.5 + least},
        "TVP 3": {"family": "TVP", "rise_end": 0.3, "fall_start": 1.0 - least},
        "MTP 1": {"family": "MTP", "durations": [least, 0.25, 0.125, 0.0, 0.125, 0.25, 0.25 - least]},
        "MTP 2": {"family": "MTP", "durations": [0.125, 0.25 - least, 0.125, least, 0.125, 0.25, 0.125]},
        "SCV 1": {"family": "SCV", "durations": [0.25, least, 0.25 - least, 0.0, 0.125, 0.25, 0.125]},
        "SCC 1": {"family": "SCC", "sine": 2 * least, "constant": 0.5 - 2 * least, "cosine": 0.5, "straight": 0.0},
        "SCC 2": {"family": "SCC", "sine": 0.25, "constant": 0.5, "cosine": 0.25 - least, "straight": least},
        "SGS 1": {"family": "SGS", "curved": 1.0 - least},
        "SRT 1": {"family": "SRT", "rise_end": 0.3, "fall_start": 0.3 + least},
        "MSN 1": {"family": "MSN", "rise_edge": 2 * least},
    }


def described(laws):
    phases = [(name, 10.0, 20.0) for name in laws]
    return composed(phases, laws, {"law": 10, "motion_pieces": 90}, closes="open")


def test_cells_and_engine_agree_down_to_the_least_stage():
    machine = described(entries(1.01 * LEAST_STAGE))
    assert machine.design.faults == ()
    wrong, _ = disagreeing(MACHINE, machine)
    assert wrong == []


@pytest.mark.parametrize("least", [1e-8, 1e-5, 0.99 * LEAST_STAGE])
@pytest.mark.sample(1)
def test_what_lasts_less_is_told_by_law(least):
    machine = described(entries(least))
    assert [fault.message for fault in machine.design.faults] == [SAID] * len(entries(least))
    value = computed(MACHINE, machine, by_cells=True)
    said = [text for text in value("checks", "says") if text]
    assert len([text for text in said if SAID in text]) == len(entries(least))


def near_bounds(page):
    """The laws of a page with one parameter half the least stage from a bound of its entry, the others as delivered."""
    for name in page.fields:
        kinds = page.entries.model_fields[name].metadata
        limits = [getattr(kind, end, None) for kind in kinds for end in ("ge", "gt", "le", "lt")]
        for value in (limit + side * LEAST_STAGE / 2 for limit in limits if limit is not None for side in (-1, 1)):
            with suppress(ValueError):
                yield page.make_law(page.entries.model_validate({name: value}))


@pytest.mark.parametrize("code", [code for code, page in FAMILY.items() if page.pieces and page.parameters])
def test_a_page_of_stages_that_may_be_brief_says_so_in_entries_and_cells(code, monkeypatch):
    page, asked = FAMILY[code], []
    monkeypatch.setattr(family, "too_brief", lambda *given: asked.append(given) or iter(()))
    assert list(page.entries().design_faults()) == []
    told = {
        "too_brief in design_faults of its entries": bool(asked),
        "BRIEF among its checks": family.BRIEF in page.checks,
    }
    durations = {piece.duration for one in near_bounds(page) for piece in one.monotone_pieces()}
    if any(told.values()) or any(BREAK_TOLERANCE < d < LEAST_STAGE for d in durations):
        assert [what for what, there in told.items() if not there] == [], f"what the page of {code} lacks"
