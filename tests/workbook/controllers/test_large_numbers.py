"""A number in a controller's file that no motion has is refused in a line, whoever's file it is."""

import random
import re
import warnings

import numpy as np
import pytest

from tests.workbook.controllers.examples import handed
from workbook.controllers.registry import TARGETS, target
from workbook.controllers.target import LARGEST, parse_table
from workbook.errors import TargetError

NUMBER = re.compile(r"(?<![\w.])-?[0-9]+\.?[0-9]*(?:[eE][+-]?[0-9]+)?(?![\w.])")
LARGE = ("1e308", "-1e308", "1E+300", "3.5e38", "1e20", "-1000000000000000.0")
DRAWN = 40


@pytest.mark.parametrize("name", TARGETS)
def test_no_table_is_read_with_a_number_beyond_any_motion(name):
    one, drawn, refused = target(name), random.Random(5), 0
    text = one.write(handed(one))
    numbers = list(NUMBER.finditer(text))
    for k, found in enumerate(drawn.sample(numbers, min(DRAWN, len(numbers)))):
        changed = f"{text[: found.start()]}{LARGE[k % len(LARGE)]}{text[found.end() :]}"
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                table = parse_table(changed, one)
            except TargetError:
                refused += 1
                continue
        assert max(np.abs(column).max() for column in table.columns.values()) <= LARGEST
    assert refused
