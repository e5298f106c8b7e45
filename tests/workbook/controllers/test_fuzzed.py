"""Files of controllers damaged at random: each is read or refused in a line, at once and without a warning."""

import contextlib
import random
import re
import time
import warnings

import numpy as np
import pytest

from tests import tiers
from tests.workbook.controllers.examples import handed, random_axis
from workbook.commands import cams
from workbook.controllers.registry import TARGETS, target
from workbook.errors import MotionbookError

NUMBER = re.compile(r"(?<![\w.])-?[0-9]+\.?[0-9]*(?:[eE][+-]?[0-9]+)?(?![\w.])")
EXTREMES = ("1e308", "-1e308", "1E+5", "1e12", "-1e11", "3.4e38", "5e-324", "1e-300", "1e-9", "0", "-0.0", "nan", "inf",
            "359.999999", "1000000", "-1e6", "2147483647", "-2147483648", "4294967296")  # fmt: skip
LETTERS = "0123456789.,;eE-+ \t\n\"'<>[]()=:\x00é"
MANY = 201  # points
LONGEST = 20.0  # seconds of CPU of a file
BY_DAY, BY_NIGHT, PARTS = 12, 300, 4


def with_a_number(text, dice):
    """Another number in the place of one."""
    found = dice.choice(list(NUMBER.finditer(text)) or [None])
    return text if found is None else f"{text[: found.start()]}{dice.choice(EXTREMES)}{text[found.end() :]}"


def with_other_lines(text, dice):
    """A line lost, doubled, moved, or all after it lost."""
    lines = text.splitlines(keepends=True)
    if not lines:
        return text
    k, there = sorted(dice.choices(range(len(lines)), k=2))
    changed = {
        "lost": [*lines[:k], *lines[k + 1 :]],
        "twice": [*lines[:there], lines[k], *lines[there:]],
        "many times": [*lines[:k], *[lines[k]] * 50, *lines[k + 1 :]],
        "a gap": [*lines[:k], *lines[there:]],
        "cut off": lines[:k],
    }
    return "".join(dice.choice(list(changed.values())))


def with_a_letter(text, dice):
    """A letter more, or another one."""
    k = dice.randrange(len(text) + 1)
    return f"{text[:k]}{dice.choice(LETTERS)}{text[k + dice.choice((0, 1)) :]}"


def damaged(text, dice):
    """A text with some faults."""
    for _ in range(dice.choice((1, 1, 1, 2, 3, 8))):
        text = dice.choice((with_a_number, with_a_number, with_other_lines, with_a_letter))(text, dice)
    return text


def require_bounded(name, text, folder):
    """Read a text by the command; it may be refused, and nothing else may happen."""
    path = folder / "file"
    path.write_bytes(text.encode("utf-8", "surrogatepass"))
    begin = time.process_time()
    with warnings.catch_warnings(), contextlib.suppress(MotionbookError):
        warnings.simplefilter("error")
        cams.read(path, name, folder / "read.toml", force=True)
    assert time.process_time() - begin < LONGEST


@pytest.mark.parametrize(
    "part", [0, *(pytest.param(k, marks=pytest.mark.nightly) for k in range(1, PARTS))]
)  # fmt: skip
@pytest.mark.parametrize("name", TARGETS)
def test_a_damaged_file_is_read_or_refused_at_once(name, part, tmp_path):
    one, dice = target(name), random.Random(tiers.seed(f"{name} {part}") if part else f"{name} by day")
    texts = [one.write(handed(one))]
    if part and not one.counts:
        x = [360.0 * k / (MANY - 1) for k in range(min(MANY, one.points[1]))]
        texts.append(one.write(handed(one, random_axis(part), np.array(x))))
    for _ in range(BY_NIGHT if part else BY_DAY):
        require_bounded(name, damaged(dice.choice(texts), dice), tmp_path)


@pytest.mark.parametrize(
    ("text", "said"),
    [("0;0\n1e-300;15\n180;30\n360;0\n", "point 2: x rises by 1e-300; expected a step of at least 3.6e-07"),
     ("0;0\n1e-300;1\n2e-300;0\n", "expected a step of at least 1e-12"), ("0;0\n90;15\n", "it ends on the way at 90")],
)  # fmt: skip
def test_steps_that_no_motion_has_are_refused(run, tmp_path, text, said):
    (tmp_path / "odd.csv").write_text(text, "utf-8")
    code, _, err = run("read", "odd.csv", "--from", "csv")
    assert code == 2
    assert said in " ".join(err.split())
