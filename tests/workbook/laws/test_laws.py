"""The laws in the workbook: pages found from the registry, what a page leaves out, variations."""

import re
from pathlib import Path

import pytest

from engine.laws import CATALOGUE
from engine.motion.handover import PULSES, early_of, end_mode
from tests.laws import MOVING
from tests.workbook.composed import composed
from workbook.fields.types import Model
from workbook.law_sheets.library import SIX, laws_in, pick_in_turn, variations
from workbook.law_sheets.page import COEFFICIENTS
from workbook.laws.entries import ENTRIES, Laws
from workbook.laws.registry import CODES, FAMILY, PAGES
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

ROOT = Path(__file__).parents[3]


# --- One list of laws -----------------------------------------------------------------------------


def test_every_list_of_laws_is_the_registry():
    codes = tuple(law.code for law in CATALOGUE)
    assert sorted(PAGES) == sorted(codes)
    assert tuple(FAMILY) == codes
    assert tuple(ENTRIES) == tuple(code for code in codes if code != "DWL")
    assert Laws({}).names == CODES == ("DWL", *MOVING)
    assert set(CODES) <= set(codes)


@pytest.mark.parametrize("code", [code for code, page in FAMILY.items() if page.parameters])
def test_parameters_in_a_row_are_those_entered(code):
    page = FAMILY[code]
    for one in page.variations:
        entered = page.entries.model_validate(one)
        assert page.entered(page.numbers(entered)) == entered
        assert page.law_of(page.numbers(entered)) == page.make_law(entered)
    assert any(page.make_law(page.entries.model_validate(one)) != FAMILY[code].law() for one in page.variations)


@pytest.mark.parametrize("code", [code for code in CODES if FAMILY[code].has_sheet])
def test_the_page_of_the_workbooks_names_the_sheet_of_every_law(code):
    text = (ROOT / "docs/workbooks.md").read_text(encoding="utf-8")
    assert re.search(rf"^\|.*\b{code}\b", text, re.MULTILINE), f"docs/workbooks.md has no row that names {code}"


# --- What a page leaves out is named --------------------------------------------------------------


def lacking(page):
    """What the page of a law leaves out, or has otherwise than the engine."""
    law, default = page.law(), page.entries() if page.entries else None
    wrong = [name for name, *_ in COEFFICIENTS if name not in page.coefficients]
    if len(law.monotone_pieces()) != len(page.pieces):
        wrong.append(f"pieces as many as the engine's {len(law.monotone_pieces())}")
    modes = {int(found) for found in re.findall(r"(?<=[=,])-?[0-9](?=$|[,)])", page.end_mode)}
    early = {mode: page.early if mode == PULSES else 0 for mode in modes}
    if early.get(end_mode(law)) != early_of(law):
        wrong.append("how it meets its neighbours, as the engine has it")
    entered = {name: getattr(default, name) for name in page.fields}
    keys = {key for name, value in entered.items()
            for key in ([f"{name}.{i}" for i in range(len(value))] if isinstance(value, list) else [name])}  # fmt: skip
    wrong += [f"the parameter {key}" for key in sorted(keys ^ {parameter.key for parameter in page.parameters})]
    wrong += [f"variations of {key}" for key in page.fields if any(key not in v for v in page.variations)]
    return [*wrong, "two variations or more"] if page.parameters and len(page.variations) < 2 else wrong


@pytest.mark.parametrize("code", [code for code, page in FAMILY.items() if page.pieces])  # else they are entered
def test_a_page_leaves_nothing_out(code):
    assert lacking(FAMILY[code]) == []


# --- Variations -----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", TEMPLATES)
def test_the_variations_of_a_template_use_every_law(name):
    template = TEMPLATES[name]
    used = set()
    for machine in template.variants(read_machine(template.description)):
        used |= named(machine)
    assert sorted(set(MOVING) - used) == [], f"laws that no variation of {name} has"


def named(entries):
    """The laws that phases and tools of a description name: entries whose name begins with law."""
    found = set()
    for field in type(entries).model_fields:
        value = getattr(entries, field)
        if field.startswith("law") and isinstance(value, str):
            found.add(value)
        for one in value if isinstance(value, list) else [value]:
            found |= named(one) if isinstance(one, Model) and field != "laws" else set()
    return found


@pytest.mark.parametrize("count", range(0, 30, 3))
def test_a_template_with_one_law_at_a_time_gives_each_its_turn_however_many_there_are(count):
    machine = composed().model_copy(update={"laws": Laws({f"CUB{8 + i}": {"family": "CUB"} for i in range(count)})})
    names = machine.laws.names[1:]
    made = variations(
        machine, lambda data, turn: {"axes": [{"phases": [{"law": pick_in_turn(turn + 4, data["laws"])}]}]}
    )
    assert len(made) == max(SIX, len(names))
    assert set().union(*(laws_in(one, names) for one in made)) == set(names)


def test_a_law_that_a_template_never_takes_is_named():
    def without_cubic(data, turn):
        return {"axes": {"law": pick_in_turn(turn, [name for name in data["laws"] if name != "CUB"])}}

    with pytest.raises(LookupError, match=r"machine ever has the law CUB$"):
        variations(composed(), without_cubic)
