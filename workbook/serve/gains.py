"""What would help a machine most that is edited: its single changes that gain, each as a text."""

from pathlib import Path

from workbook.pool import THIS_PROCESS
from workbook.reading.descriptions import parse_toml
from workbook.serve.shown import design
from workbook.studies.design import first_design
from workbook.studies.improve import edited, single_gains


def gains_of(name: str, text: str) -> list[dict[str, str]]:
    """Return what each single change of a machine would gain, the best first, and the text with it.

    Raises MotionbookError for a text that describes no finished machine whose drives limit its rate.
    """
    machine = design(name, text).machine
    first = first_design(machine, "motion_pieces" in parse_toml(text, Path(name)).get("sizes", {}))
    rows = sorted(single_gains(first, THIS_PROCESS, lambda *_: None), key=lambda gain: gain.after)
    return [{"sentence": gain.sentence(first), "text": edited(text, gain.changes)} for gain in rows]
