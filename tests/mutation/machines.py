"""Random valid machines of one layout: what an engineer might enter, to tell whether a mutant ever shows.

Each template's own entries are drawn in ``draw_MODULE.py`` beside this file, named like its module under
workbook/machines/; here is what they share.
"""

import random
from collections.abc import Container
from importlib import import_module
from typing import Any

from pydantic import BaseModel

from tests.laws import PAGED, blended
from workbook.entries.facts import varying_entries
from workbook.entries.machine import Machine
from workbook.errors import InputError
from workbook.reading.descriptions import make_machine
from workbook.templates import MODULES, TEMPLATES

TRIES = 200


def machines(given: Machine, count: int, seed: int | str) -> list[Machine]:
    """Return machines with the sizes of ``given`` and other entries everywhere; the same for the same seed."""
    drawn = random.Random(seed)
    return [machine(given, drawn) for _ in range(count)]


def machine(given: Machine, drawn: random.Random) -> Machine:
    """Return a machine drawn anew until it is a valid one."""
    varied = import_module(f"tests.mutation.draw_{MODULES[given.template]}").varied
    for _ in range(TRIES):
        try:
            made = make_machine(TEMPLATES[given.template], varied(given.model_dump(), drawn), str)
        except InputError as error:
            refused = str(error)
        else:
            if not made.design.replaced:
                return made
            refused = str(made.design.faults)
    raise AssertionError(f"{TRIES} machines were drawn and none is valid; the last: {refused}")


def vary_laws(laws: dict[str, Any], drawn: random.Random, room: int) -> None:
    """Draw the parameters of every law."""
    for code in PAGED:
        laws[code].update(lift=drawn.uniform(-300, 300), time=drawn.uniform(0.05, 3), **blended(code, drawn))
    low, high = sorted((drawn.uniform(0.02, 0.98), drawn.uniform(0.02, 0.98)))
    laws["TVP"].update(rise_end=low, fall_start=drawn.choice((low, high)))
    laws["MTP"]["durations"] = stages(drawn)
    laws["OWN"].update(name=f"Law {drawn.randrange(1000)}", pieces=own_pieces(drawn, room))


def shares(drawn: random.Random, count: int) -> list[float]:
    """Return shares of a whole that add up to 1."""
    parts = [drawn.uniform(0.1, 1) for _ in range(count)]
    return [p / sum(parts) for p in parts]


def stages(drawn: random.Random) -> list[float]:
    """Return seven stages, some of them missing, so that the law can start and stop."""
    kept = sorted({drawn.randrange(3), drawn.randrange(4, 7), *drawn.sample(range(7), drawn.randrange(6))})
    durations = [0.0] * 7
    for stage, share in zip(kept, shares(drawn, len(kept)), strict=True):
        durations[stage] = share
    return durations


def own_pieces(drawn: random.Random, room: int) -> list[dict[str, Any]]:
    """Return a law of one piece or many, with or without sines, at times with a piece of no length among them."""
    pieces: list[dict[str, Any]] = []
    for share in shares(drawn, drawn.randint(1, room)):
        terms = {name: drawn.choice((0.0, drawn.uniform(-9, 9))) for name in ("c0", "c1", "c2", "c3", "phase")}
        sine = {"amplitude": drawn.uniform(-9, 9), "omega": drawn.uniform(0.5, 13)} if drawn.random() < 0.6 else {}
        pieces.append({"duration": share, **terms, **sine})
    if len(pieces) < room and drawn.random() < 0.3:
        pieces.insert(drawn.randrange(len(pieces) + 1), {"duration": 0.0, "c0": 5.0})
    return pieces


def draw(entries: dict[str, Any], model: type[BaseModel], drawn: random.Random, leaving: Container[str] = ()) -> None:
    """Draw the entries of a table: of the variations, or within them, by their logarithm where these differ much."""
    for table, name, values in varying_entries(entries, model, leaving):
        numbers, table[name] = [value for value in values if isinstance(value, float)], drawn.choice(values)
        if isinstance(table[name], float) and drawn.random() < 0.8:
            low, high = min(numbers), max(numbers)
            wide = low > 0 and high / low > 100
            table[name] = low * (high / low) ** drawn.random() if wide else drawn.uniform(low, high)
