"""Laws by name: what a description says, what a book has of it, and how it is read back, also when edited."""

import io
import tomllib
from pathlib import Path

import openpyxl
import pytest

from engine.laws import CATALOGUE
from tests import cutting
from tests.workbook.cells import disagreeing, entered
from workbook.errors import InputError
from workbook.judging.report import Report
from workbook.judging.verify import judge
from workbook.law_sheets.book_laws import BookLaws
from workbook.laws.entries import ENTRIES, LONGEST, with_laws_by_code
from workbook.reading.descriptions import counted_from_1, make_machine, write_machine
from workbook.reading.entries import Entries
from workbook.reading.files import BookFile, find_places
from workbook.templates import TEMPLATES
from workbook.witnesses.agreement import agreed_values
from workbook.writing import archive
from workbook.writing.write import parts

MACHINE = TEMPLATES["machine"]
SMALL = {"cycle": 12, "law": 4}
SOFT = {"family": "MTP", "durations": [0.1, 0.2, 0.15, 0.05, 0.12, 0.25, 0.13]}
HARD = {"family": "MTP", "durations": [0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1]}


def described(laws, *used):
    """The cutting machine with these laws besides the basic ones; those used move its axes in turn."""
    data = cutting.small(**SMALL).model_dump()
    data["sizes"]["motion_pieces"] = None
    data["laws"] |= laws
    moving = [phase for axis in data["axes"] for phase in axis["phases"] if phase["law"] != "DWL"]
    for phase, law in zip(moving, used, strict=False):
        phase["law"] = law
    return data


def machine(laws, *used):
    return make_machine(MACHINE, described(laws, *used), counted_from_1)


def refused(laws, *used):
    with pytest.raises(InputError) as error:
        machine(laws, *used)
    return str(error.value)


def test_two_laws_of_one_family_move_two_axes_of_one_book():
    made = machine({"MTP soft": SOFT, "Hard": HARD}, "MTP soft", "hard")
    assert [axis.phases[k].law for axis, k in zip(made.axes, (0, 1), strict=False)] == ["MTP soft", "Hard"]
    laws = BookLaws(made.laws, made.sizes).laws
    assert laws["MTP soft"].durations == tuple(SOFT["durations"]) != laws["Hard"].durations
    wrong, count = disagreeing(MACHINE, made)
    assert wrong == []
    assert count > 3000


def test_the_laws_are_read_back_from_the_cells():
    given = machine({"Hard": HARD, "0.5 of [a]: x/y": SOFT | {"lift": 7.0}}, "0.5 OF [A]: X/Y")
    back, lost = entered(MACHINE, given)
    assert back == given
    assert lost == []


def test_a_description_says_the_same_after_it_was_written():
    given = machine({"Hard": HARD, "0.5 of [a]: x/y": SOFT}, "Hard")
    text = write_machine(given)
    assert '[laws."0.5 of [a]: x/y"]\nfamily = "MTP"\n' in text
    assert "[laws.TVP]\nlift" in text
    assert make_machine(MACHINE, tomllib.loads(text), counted_from_1) == given


# --- Names ------------------------------------------------------------------------------------------


REFUSED = {
    "no family": ({"A": {}}, ("laws.A.family: empty; expected one of ACS, TVP",)),
    "an unknown family": ({"A": {"family": "MTB"}}, ("no family is named 'MTB'; expected one of MTP, MTS",)),
    "a parameter of another": ({"A 1.5": SOFT | {"share": 0.4}}, ('laws."A 1.5".share: unknown entry; expected',)),
    "a basic law's name": ({"tvp": SOFT}, ("laws.tvp", "take this for the law TVP")),
    "a basic law's name, of another family": ({"TVP": SOFT}, ("laws.TVP.family",)),
    "names alike": ({"Straße": SOFT, "STRASSE": HARD}, ("a second law is named 'STRASSE'",)),
    "a pattern": ({"a*": SOFT}, ('laws."a*"', "pattern")),
    "a value": ({"1.5": SOFT}, ("laws.", "reads as a value")),
    "a formula": ({"=A": SOFT}, ("do not begin with =",)),
    "too long": ({"x" * (LONGEST + 1): SOFT}, (f"1 to {LONGEST} characters",)),
    "no table": ({"A": 3.0}, ("laws.A: found 3.0; expected the entries of a law",)),
    "a dwell": ({"DWL": {}}, ("laws.DWL", "nothing to enter")),
    "a dwell by name": ({"Rest": {"family": "DWL"}}, ("laws.Rest.family: no family is named 'DWL'",)),
}


@pytest.mark.parametrize("what", REFUSED)
def test_a_law_that_cannot_be_is_refused_in_one_line(what):
    laws, words = REFUSED[what]
    said = refused(laws)
    assert "\n" not in said
    for word in words:
        assert word in said


def test_a_phase_with_an_unknown_law_is_told_what_there_is():
    said = refused({"MTP soft": SOFT}, "MTP sofd")
    assert said.startswith("axes[1].phases[1].law")
    assert "no law is named 'MTP sofd'; expected one of MTP soft, " in said
    assert "expected one of modified sine, " in refused({}, "modified sini").casefold()


def test_a_description_names_a_law_as_the_catalogue_does_and_its_book_has_it():
    """By any name of any law of the catalogue, with what that law has unless told otherwise."""
    for law in CATALOGUE[1:]:
        data, names = described({}), (law.code, law.name, *law.aliases)
        for name in names:
            data["axes"][0]["phases"][0]["law"] = name
            named = with_laws_by_code(data, {})
            assert named["axes"][0]["phases"][0]["law"].upper() == law.code
        made = make_machine(MACHINE, named, counted_from_1)
        assert made.laws[law.code] == ENTRIES[law.code](family=law.code)


def test_a_law_of_the_description_goes_before_the_catalogues_of_like_name():
    own = {"PO5": {"share": 0.4}, "Modified sine": {"rise_edge": 0.2}}
    data = with_laws_by_code(described(own, "3-4-5", "modified sine"), {})
    made = make_machine(MACHINE, data, counted_from_1)
    assert [axis.phases[k].law for axis, k in zip(made.axes, (0, 1), strict=False)] == ["PO5", "Modified sine"]
    assert (made.laws["PO5"].share, made.laws["Modified sine"].family) == (0.4, "MSN")


@pytest.mark.parametrize("name", ["PO5", "quintic", "modified sine", "MT"])
def test_a_law_of_the_description_hides_none_of_the_catalogue(name):
    with pytest.raises(InputError, match=r"laws\..*of the catalogue; expected its family, or another name"):
        make_machine(MACHINE, described({name: {"family": "SCC"}}), counted_from_1, by_code=True)


def test_in_a_book_only_its_own_laws_have_names():
    """A cell is looked up in the list of the book: what is typed there means nothing else."""
    assert "no law is named 'modified sine'; add [laws.MSN], or take one of" in refused({}, "modified sine")


def test_laws_whose_titles_would_be_the_same_have_two():
    book = MACHINE.declare(machine({"a/b": SOFT, "a:b": HARD, "x" * 31 + "1": SOFT, "x" * 31 + "2": HARD}))
    titles = [sheet.title for sheet in book.sheets]
    assert len({title.casefold() for title in titles}) == len(titles)
    assert {"a-b", "a-b (2)", "x" * 31, "x" * 27 + " (2)"} <= set(titles)


# --- Edited in a spreadsheet program ----------------------------------------------------------------


def file_of(given, edit):
    book = openpyxl.load_workbook(io.BytesIO(archive.zipped(parts(MACHINE.declare(given), MACHINE.model))))
    edit({name: book[place.sheet].cell(place.row, place.column) for name, place in find_places(book).items()}, book)
    return BookFile(Path("book.xlsx"), book, find_places(book))


def renamed(cells, book):
    cells["MTP8_called"].value = "Softer"
    phase = next(c for row in book["Timing"].iter_rows() for c in row if c.value == "MTP soft")
    phase.value = "SOFTER"
    cells["MTP9_d1"].value, cells["MTP9_d3"].value = 0.1, 0.0


def test_a_law_that_was_renamed_in_the_book_is_found_by_its_new_name():
    given = machine({"MTP soft": SOFT, "Hard": HARD}, "MTP soft", "Hard")
    file = file_of(given, renamed)
    back = Entries(file, agreed_values).machine()
    assert back.laws.names[7:] == ("Softer", "Hard")
    assert back.axes[0].phases[0].law == "Softer"
    assert back.laws["Hard"].durations[:3] == [0.1, 0.15, 0.0]
    report = Report(file.path, MACHINE.name)
    judge(file, MACHINE, back, report)
    assert [found for found in report.findings if found.kind != "saved"] == []
    assert report.compared == report.declared


@pytest.mark.parametrize(("name", "words"), [(None, "empty; expected a name"), (5, "found 5; expected a name"),
                                             ("a*", "pattern")])  # fmt: skip
def test_a_name_that_is_none_is_refused_at_its_cell(name, words):
    def cleared(cells, book):
        cells["MTP8_called"].value = name

    with pytest.raises(InputError, match=rf"(?s)book\.xlsx: 'MTP soft'!.*{words}"):
        Entries(file_of(machine({"MTP soft": SOFT}), cleared), agreed_values).machine()


def test_a_name_with_an_apostrophe_stands_in_charts_as_excel_writes_it():
    made = machine({"O'Brien & <co>": SOFT})
    written = parts(MACHINE.declare(made), MACHINE.model)
    charts = b"".join(part for name, part in written.items() if name.startswith("xl/charts/chart"))
    assert b"'O''Brien &amp; &lt;co&gt;'!" in charts
    assert b"''''" not in charts


@pytest.mark.parametrize("share", [0.0, 1e-9, 0.009, 0.995, 1.0])
def test_a_share_that_leaves_next_to_nothing_is_beyond_its_limits(share):
    (fault,) = machine({"Steep": {"family": "CIC", "share": share}}).design.faults
    assert fault.message == "expected a number from 0.01 to 0.99"
