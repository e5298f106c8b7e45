"""Beckhoff TwinCAT in Structured Text: motion function points of NC2, a position table, switches of MC_CamSwitch."""

import re

from workbook.controllers.target import Tappets, Target, Track, facts_of, tracks_of_rows
from workbook.controllers.texts import INDEXED, by_index, columns, pairs, points, without_comments
from workbook.errors import TargetError

FIELDS = ("MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc")
SWITCHED = ("FirstOnPosition", "LastOnPosition")
OF_TRACK = re.compile(rf"_(\d{{1,4}})_S{INDEXED.pattern}")
COUNTED = re.compile(r"_(\d{1,4})\.NumberOfSwitches\s{0,9}:=\s{0,9}(\d{1,9})")


def read_switches(text: str) -> list[Track]:
    """Return the tracks that are assigned."""
    plain = without_comments(text)
    arrays: dict[int, list[tuple[int, str, str]]] = {}
    for number, index, field, value in OF_TRACK.findall(plain):
        arrays.setdefault(int(number), []).append((int(index), field, value))
    counts_told = {int(number): int(count) for number, count in COUNTED.findall(plain)}
    times = []
    for number, body in arrays.items():
        begins, ends = columns(body, SWITCHED)
        if counts_told.get(number, len(begins)) != len(begins):
            raise TargetError(f"track {number}: {counts_told[number]} switches are told, {len(begins)} follow")
        times += [(number, *both) for both in zip(begins.tolist(), ends.tolist(), strict=True)]
    return tracks_of_rows(text, times)


TAPPETS = Tappets(**facts_of("twincat switches"), read=read_switches)
TARGETS = (
    Target(
        **facts_of("twincat"),
        read=lambda text: points(text, by_index(text, FIELDS), "NoOfRows"),
        tappets=TAPPETS,
    ),
    Target(**facts_of("twincat-table"), read=lambda text: points(text, pairs(text, ":= [", "]"), "NoOfRows")),
)
