"""Random comparisons of laws: any laws with any parameters, one curve to four."""

import random
from typing import Any

from tests.laws import blended
from tests.mutation.machines import vary_laws
from workbook.machines.laws.entries import MOST_CURVES


def varied(data: dict[str, Any], drawn: random.Random) -> dict[str, Any]:
    """Return a description with every entry drawn anew."""
    laws = data["laws"]
    vary_laws(laws, drawn, data["sizes"]["pieces"])
    for entry in laws.values():
        if "family" in entry:
            entry.update(lift=drawn.uniform(-300, 300), time=drawn.uniform(0.05, 3), **blended(entry["family"], drawn))
    names = ["DWL", *laws]
    data["comparison"]["curves"] = [{"law": drawn.choice(names)} for _ in range(drawn.randint(1, MOST_CURVES))]
    return data
