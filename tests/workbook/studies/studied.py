"""What tests of studies share: the feeding axis of a machine alone, and studies of it."""

import tomli_w

from workbook.entries.design import as_entered
from workbook.reading.descriptions import read_machine
from workbook.studies.plan import read_study
from workbook.templates import TEMPLATES

SIZES = {"cycle": 90, "law": 4}
FEED = "axes.MC01.phases[1]"


def base(folder, **changes):
    """Write the description of one axis at 60 cycles a minute, which products of the catalogue can drive."""
    data = as_entered(read_machine(TEMPLATES["machine"].description))
    data |= {
        "axes": data["axes"][:1],
        "clearances": [],
        "selection": {},
        "sizes": data["sizes"] | SIZES,
        "master": {"rate": 60.0},
    }
    data["sizes"].pop("motion_pieces", None)
    data["axes"][0] |= changes
    path = folder / "feed.toml"
    path.write_text(tomli_w.dumps(data), encoding="utf-8")
    return path


def written(folder, *vary, **more):
    """Write a study of that axis."""
    if not (folder / "feed.toml").exists():
        base(folder)
    data = {"title": "Feed", "base": "feed.toml", "vary": list(vary)} | more
    path = folder / "study.toml"
    path.write_text(tomli_w.dumps(data), encoding="utf-8")
    return path


def planned(folder, *vary, **more):
    """Read a study of that axis."""
    return read_study(written(folder, *vary, **more))


def laws(*names):
    """What varies the law."""
    return {"key": f"{FEED}.law", "values": list(names)}


def stops(low, high, steps=None, **more):
    """What varies the end of the phase."""
    return {"key": f"{FEED}.stop", "from": low, "to": high} | ({"steps": steps} if steps else {}) | more


MOTORS = {"key": "axes.MC01.motor.name", "all": "catalogue"}
REDUCERS = {"key": "axes.MC01.reducer.name", "all": "catalogue"}
RATES = {"key": "master.rate", "from": 30.0, "to": 90.0, "steps": 5}
