"""The verdicts of all committed machines: how many checks each book has, and which of them fail.

The books are built from their descriptions, so a check that is added or lost, or a committed machine that no longer
does what is asked of it, is seen here whatever the committed workbooks hold.
"""

from pathlib import Path

import pytest

from workbook.build import committed_descriptions
from workbook.laws.registry import FAMILY
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

VERDICTS: dict[str, tuple[int, list[str]]] = {  # checks in the book, and those that fail
    "actuator-sizing": (58, []),
    "actuator-sizing-conveyor": (58, []),
    "crank-press": (82, []),
    "cutting-machine": (70, []),
    "flying-cutter": (53, []),
    "flying-cutter-saw": (53, []),
    "indexing-overlap": (34, []),
    "indexing-overlap-stations": (50, []),
    "machine": (101, []),
    "machine-linkages": (87, []),
    "machine-seconds": (76, []),
    "motion-composer": (33, []),
    "motion-composer-example-1": (33, []),
    "motion-composer-example-2": (33, []),
    "motion-composer-example-3": (39, []),
    "motion-laws": (25 + sum(1 + len(page.checks) for page in FAMILY.values()), []),
}


def test_every_committed_machine_is_listed() -> None:
    assert sorted(path.stem for path in committed_descriptions()) == sorted(VERDICTS)


@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
def test_its_checks_are_so_many_and_these_of_them_fail(path: Path) -> None:
    machine = read_machine(path)
    book = TEMPLATES[machine.template].declare(machine)
    failing = [check.label for _, check in book.checks if check.value != "OK"]
    assert (len(book.checks), failing) == VERDICTS.get(path.stem), f"checks of {path.stem} in VERDICTS"
