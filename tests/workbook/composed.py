"""A small book: a machine of one axis, whose phases are told by law, lift and duration, over any abscissa."""

from workbook.reading.descriptions import counted_from_1, make_machine, read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

MACHINE = TEMPLATES["machine"]
COMPOSED = "motion-composer"
"""the committed description of one axis: the book that is soonest verified"""
DESCRIBED = (*TEMPLATES, COMPOSED)
"""committed descriptions: that of each template, and the small one"""
SMALL = {"cycle": 12, "law": 4}
EXERCISE = (("DWL", 0.0, 60.0), ("CIC", 20.0, 60.0), ("DWL", 0.0, 60.0), ("MTP", -20.0, 60.0), ("DWL", 0.0, 120.0))
"""S3's: dwell, cycloidal rise to 20°, dwell, modified trapezoidal return, dwell"""
RATES = ("velocity", "acceleration")


def committed_as(name):
    """A committed description, and the template that it is of."""
    machine = read_machine(FOLDER / f"{name}.toml")
    return TEMPLATES[machine.template], machine


def small(**sizes):
    """The small committed machine, with tables as small as they may be."""
    _, machine = committed_as(COMPOSED)
    least = {"cycle": 4, "law": 4} | sizes
    return machine.model_copy(update={"sizes": machine.sizes.model_copy(update=least)})


def placed(phases):
    """Phases that begin where the one before ends, and where the last one does: what they pass their begin with last"""
    made, reached = [], 0.0
    for law, lift, duration, *rates in phases:
        stop = reached + duration
        passed = {name: rate for name, rate in zip(RATES, rates, strict=False) if rate is not None}
        made.append({"start": reached, "stop": stop, "lift": lift, "law": law} | passed)
        reached = stop
    return made, reached


def description(phases=EXERCISE, laws=None, sizes=None, over="°", unit="°", name="Axis", **axis):
    """The description of a machine of one axis, whose cycle is as long as its phases."""
    made, length = placed(phases)
    return {
        "template": "machine", "title": "Composed", "master": {"cycle": length, "unit": over},
        "sizes": SMALL | {"phases": max(2, len(made))} | (sizes or {}), "laws": laws or {},
        "axes": [{"name": name, "group": "Composed", "unit": unit, "phases": made} | axis],
    }  # fmt: skip


def composed(phases=EXERCISE, laws=None, sizes=None, **axis):
    """The machine that is so described."""
    return make_machine(MACHINE, description(phases, laws, sizes, **axis), counted_from_1)
