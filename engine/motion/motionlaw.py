"""S3's call in Python: a motion sampled from three lists."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from engine.laws import law
from engine.laws.base import Array
from engine.motion.motion import Motion
from engine.motion.phase import numbered_phase


class MotionSamples(NamedTuple):
    """A motion sampled at equal steps of its abscissa."""

    abscissa: Array
    y: Array
    y1: Array
    y2: Array
    y3: Array


def motionlaw(
    laws: Sequence[str],
    lifts: Sequence[float],
    durations: Sequence[float],
    n: int,
    parameters: Sequence[Mapping[str, Any] | None] | None = None,
) -> MotionSamples:
    """Return n samples, at equal steps, of the phases that three lists describe: S3's call in Python.

    ``laws`` are names of the catalogue, ``lifts`` in any unit of y, ``durations`` in any unit of the
    abscissa, ``parameters`` (if given) a mapping or None a phase, handed to its law.
    Raises ValueError for lists of unequal length, fewer than two samples, or a phase that cannot be
    (which says the phase), UnknownLawError for a name that is not in the catalogue.
    Source: S3, function motionlaw, its misprint mended (see :class:`engine.motion.Motion`).
    """
    given = {"laws": laws, "lifts": lifts, "durations": durations}
    if parameters is not None:
        given["parameters"] = parameters
    lengths = {name: len(values) for name, values in given.items()}
    if len(set(lengths.values())) > 1:
        counts = ", ".join(f"{count} {name}" for name, count in lengths.items())
        raise ValueError(f"{counts} are given; expected as many of each")
    if n < 2:
        raise ValueError(f"n is {n}; expected at least 2 samples")
    settings = parameters if parameters is not None else [None] * len(laws)
    phases = [
        numbered_phase(k, law(name, **(more or {})), lift, duration)
        for k, (name, lift, duration, more) in enumerate(zip(laws, lifts, durations, settings, strict=True), 1)
    ]
    motion = Motion(phases)
    abscissa = np.linspace(0.0, motion.total, n)
    return MotionSamples(abscissa, *motion.at(abscissa))
