"""Workbooks that nobody here wrote, each declared in Python: what is found in them."""

from collections import Counter

import pytest

from tests.foreign.books import BOOKS, VARIABLE
from workbook.oracle.declarations import load_oracle
from workbook.oracle.judge import Judge
from workbook.reading.files import open_book
from workbook.witnesses.engines import convert, libreoffice_path

every_book = pytest.mark.parametrize("book", BOOKS, ids=lambda book: book.name)


@pytest.fixture
def there(book):
    """The workbook, where it is on this machine."""
    if book.path is None:
        pytest.skip(f"{book.address} is not in the folder that {VARIABLE} names")
    return book


@pytest.fixture
def sound(there, tmp_path):
    """The workbook without the faults that were found in it."""
    return there.mend(tmp_path / "sound.xlsx")


def judged(path, book, witnesses=("pycel", "formulon")):
    return Judge(open_book(path), load_oracle(book.declarations)).judge(100, witnesses=witnesses)


@every_book
def test_it_is_declared_in_a_hundred_lines(book):
    assert len(book.declarations.read_text(encoding="utf-8").splitlines()) <= 100


@every_book
def test_what_is_wrong_in_it_is_named_and_all_of_it_is_covered(there):
    found = judged(there.path, there)
    assert Counter(one.kind for one in found.wrong) == there.kinds
    assert found.covered == 100.0


@every_book
def test_without_these_faults_nothing_is_named(sound, book):
    assert judged(sound, book).wrong == []


@every_book
@pytest.mark.nightly
def test_nothing_is_named_of_what_libreoffice_saves_of_it(sound, book, tmp_path):
    if libreoffice_path() is None:
        pytest.skip("LibreOffice is not on this machine")
    folder = tmp_path / "saved"
    folder.mkdir()
    assert judged(convert(sound, "xlsx", folder), book).wrong == []
