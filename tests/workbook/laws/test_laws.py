"""The laws in the workbook: pages found from the registry, what a page leaves out, a page that is wrong, variations."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from engine.laws import CATALOGUE, Cubic
from engine.motion.handover import PULSES, early_of, end_mode
from tests.laws import MOVING
from tests.workbook.cells import disagreeing
from tests.workbook.composed import MACHINE, composed
from workbook.fields.types import Model
from workbook.law_sheets.library import SIX, law_for, laws_in, variations
from workbook.law_sheets.page import COEFFICIENTS
from workbook.laws.entries import ENTRIES, Laws
from workbook.laws.family import LawSheet, PieceRow
from workbook.laws.registry import CODES, FAMILY, PAGES, IncompleteError, page_of
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

ROOT = Path(__file__).parents[3]
SMALL = {"cycle": 12, "law": 4, "phases": 8}
FLYING = TEMPLATES["flying-cutter"]


def small(template, **sizes):
    machine = read_machine(template.description)
    return machine.model_copy(update={"sizes": machine.sizes.model_copy(update=SMALL | sizes)})


# --- One list of laws -----------------------------------------------------------------------------


def test_every_list_of_laws_is_the_registry():
    codes = tuple(law.code for law in CATALOGUE)
    paged = {id(page): page.law.code for page in PAGES}.values()  # a file of pages may import another's
    assert sorted(paged) == sorted(codes)
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


def test_a_law_without_a_page_is_named():
    assert page_of(Cubic, PAGES).law is Cubic
    with pytest.raises(IncompleteError, match=r"no page in FILES of .*/registry.py is of the law CUB"):
        page_of(Cubic, [page for page in PAGES if page.law.code != "CUB"])


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


class Another(LawSheet):
    rise_end: float = 0.3
    fall_start: float = 0.7
    share: float = 0.5


TVP, CUB = FAMILY["TVP"], FAMILY["CUB"]
LACKING = {
    "a coefficient": (CUB, {"coefficients": {}}, "cv, ca_max"),
    "a piece": (TVP, {"pieces": TVP.pieces[:2]}, "pieces as many as the engine's 3"),
    "how it meets others": (TVP, {"early": 2}, "how it meets its neighbours"),
    "a parameter": (TVP, {"parameters": TVP.parameters[:1]}, "the parameter fall_start"),
    "a parameter of its entries": (TVP, {"entries": Another}, "the parameter share, variations of share"),
    "variations": (TVP, {"variations": ()}, "two variations or more"),
    "a varied parameter": (TVP, {"variations": ({"rise_end": 0.3},) * 2}, "variations of fall_start"),
}  # fmt: skip


@pytest.mark.parametrize("what", LACKING)
def test_what_a_page_leaves_out_is_found(what):
    page, changed, words = LACKING[what]
    assert ", ".join(lacking(replace(page, **changed))).startswith(words)


def test_a_page_cannot_be_made_without_the_place_of_its_peak():
    stated = {name: getattr(CUB, name) for name in ("law", "source", "pieces", "coefficients")}
    with pytest.raises(TypeError, match="'fastest'"):
        type(CUB)(**stated)


# --- Cells and engine -----------------------------------------------------------------------------


@pytest.fixture(scope="module", params=range(SIX))
def varied(request):
    """The cells that disagree in a book with every law's page, at other parameters of each law."""
    return disagreeing(MACHINE, MACHINE.variants(composed(sizes=SMALL))[request.param])


@pytest.mark.parametrize("code", MOVING)
def test_the_cells_of_a_law_compute_what_the_engine_has(varied, code):
    wrong, count = varied
    assert [cell for cell in wrong if cell.startswith((f"{code}_", f"{code.lower()}_"))] == []
    assert count > 1000


@pytest.fixture(scope="module")
def asked():
    """What is wrong in the table by which the cutter asks of each law, at other parameters of each law."""
    found, _ = disagreeing(FLYING, FLYING.variants(small(FLYING))[0])
    return [cell for cell in found if cell.startswith("fastest.")]


@pytest.mark.parametrize("code", CODES)
def test_the_place_of_the_peak_in_cells_is_that_of_the_engine(asked, code):
    assert [cell for cell in asked if f"[{CODES.index(code)}]" in cell] == []


def altered(row, **formulas):
    return PieceRow(row.name, row.equation, **row.formulas | formulas)


WRONG = {
    "pieces": ("CIC", MACHINE, "CIC_pieces.P[0]"),
    "coefficients": ("CUB", MACHINE, "CUB_cv.CUB_cv[0]"),
    "fastest": ("TVP", FLYING, f"fastest.at[{CODES.index('TVP')}]"),
}
CHANGED = {
    "pieces": lambda page: (altered(page.pieces[0], P="=@ca_max*(1+1E-7)"), *page.pieces[1:]),
    "coefficients": lambda page: page.coefficients | {"cv": ("=1.5000001", "")},
    "fastest": lambda page: "=@aw",
}


@pytest.mark.parametrize("what", WRONG)
def test_a_page_with_a_wrong_formula_is_found_by_the_cell(what, monkeypatch):
    code, template, cell = WRONG[what]
    page = FAMILY[code]
    monkeypatch.setitem(vars(page), what, CHANGED[what](page))
    wrong, _ = disagreeing(template, composed() if template is MACHINE else small(template))
    assert [found for found in wrong if found.startswith(cell)]


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
    made = variations(machine, lambda data, turn: {"axes": [{"phases": [{"law": law_for(turn + 4, data["laws"])}]}]})
    assert len(made) == max(SIX, len(names))
    assert set().union(*(laws_in(one, names) for one in made)) == set(names)


def test_a_law_that_a_template_never_takes_is_named():
    def without_cubic(data, turn):
        return {"axes": {"law": law_for(turn, [name for name in data["laws"] if name != "CUB"])}}

    with pytest.raises(LookupError, match=r"machine ever has the law CUB$"):
        variations(composed(), without_cubic)


def test_coefficients_of_every_page_are_those_of_the_summary():
    for code, page in FAMILY.items():
        assert [*page.coefficients] == [name for name, *_ in COEFFICIENTS], code
