"""What templates' variations share: other parameters for every law, asymmetric, with zero stages, of several pieces."""

from __future__ import annotations

from typing import Any

LAWS = ("ACS", "TVP", "CIC", "CUB", "MTP", "OWN")
DURATIONS = (
    (0.1, 0.2, 0.15, 0.05, 0.12, 0.25, 0.13),
    (0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0),
    (0.3, 0.0, 0.25, 0.1, 0.15, 0.0, 0.2),
    (0.0, 0.2, 0.2, 0.0, 0.25, 0.35, 0.0),
    (0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1),
    (0.15, 0.1, 0.0, 0.2, 0.0, 0.3, 0.25),
)
OWN = (
    [{"duration": 1.0, "c1": 60.0, "c2": -180.0, "c3": 120.0}],
    [
        {"duration": 0.4, "c0": 3.0, "c1": 1.5, "c2": -2.0, "c3": 0.7, "amplitude": 1.2, "omega": 7.0, "phase": 0.4},
        {"duration": 0.35, "c0": -1.0, "amplitude": 2.0, "omega": 3.0, "phase": 1.1},
        {"duration": 0.25, "c0": -2.0, "c2": 4.0},
    ],
    [
        {"duration": 0.5, "amplitude": 6.5, "omega": 6.0},
        {"duration": 0.5, "amplitude": -6.0, "omega": 6.5, "phase": 0.1},
    ],
)


def vary_laws(laws: dict[str, Any], k: int, scale: Any, room: int) -> None:
    """Give every law other parameters: asymmetric, with zero stages, of several pieces."""
    for code in LAWS[:-1]:
        laws[code]["lift"] *= -next(scale) if k % 2 else next(scale)
        laws[code]["time"] *= next(scale)
    laws["TVP"].update(rise_end=0.15 + 0.07 * k, fall_start=0.6 + 0.05 * k)
    laws["MTP"]["durations"] = list(DURATIONS[k])
    laws["OWN"]["pieces"] = own_pieces(k, room)


def factors(k: int) -> Any:
    """Yield a factor near 1 for each number, no two alike."""
    n = 0
    while True:
        n += 1
        yield 1 + 0.013 * ((n * 7 + k * 5) % 23) + 0.0007 * n


def own_pieces(k: int, room: int) -> list[dict[str, Any]]:
    """Return pieces of an own law; with little room, the one of a single piece."""
    pieces = OWN[k % 3]
    return pieces if len(pieces) <= room else OWN[0]
