"""The glossary's terms are those of the sheets: no label uses a word that its column *not* lists."""

import re
from pathlib import Path

import pytest

from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

GLOSSARY = Path(__file__).parents[1] / "docs/glossary.md"


def avoided():
    """Each word of the column *not*, with the term that is used in its place."""
    rows = re.findall(r"^\| ([^|]+) \|(?:[^|]*\|){4} ([^|]+) \|$", GLOSSARY.read_text(encoding="utf-8"), re.MULTILINE)
    return {word: term for term, word in rows if word not in ("not", "---") and word.strip()}


@pytest.mark.parametrize("name", ["machine", "machine-linkages", "flying-cutter", "indexing-overlap"])
def test_no_label_uses_a_word_that_the_glossary_avoids(name):
    machine = read_machine(FOLDER / f"{name}.toml")
    book = TEMPLATES[machine.template].declare(machine)
    labels = {q.label for block in book.blocks.values() for q in block.quantities}
    words = avoided()
    assert len(words) > 8
    found = [f"{label}: {word}; expected {term}" for label in sorted(labels) for word, term in words.items()
             if re.search(rf"\b{re.escape(word)}\b", label, re.IGNORECASE)]  # fmt: skip
    assert found == []
