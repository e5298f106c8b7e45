"""The declaration of a target: numbers, limits, the rule between points, who writes and who reads; files; tracks."""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
from tornado.template import Loader

from engine.laws.base import Array, Flags
from engine.motion.profile import CamProfile
from engine.timing import Switch, SwitchDifference, compare_switches
from workbook.controllers.registry import STATED
from workbook.controllers.table import SPLINES, Table
from workbook.controllers.texts import LREAL, Number, Units, literal
from workbook.errors import ReadError, TargetError, visible
from workbook.template_outputs import CamSwitch
from workbook.text_files import read_text

CALLED = re.compile(r"^(?:// |# )?track (\d{1,4}): ([^\r\n]{1,80})", re.MULTILINE)
MOST_OFF = 1e-2  # of an edge, in degrees: numbers of 32 bits hold it to 1e-5
FOLDER = Path(__file__).with_name("targets")
LAYOUTS = Loader(str(FOLDER), autoescape=None, whitespace="all")
# of points: anywhere, at equal steps alone, or on the breaks at least
Spacing = Literal["free", "equal", "breaks"]
NEVER = " (never on)"
CYCLE = 360.0  # degrees
MOST_TRACKS, MOST_TIMES = 1000, 10_000
MOST = 8_000_000  # bytes: a tag of 25,000 points
LARGEST = 1e12  # of x, y and derivatives
# of the whole of x, and of its unit: the smallest step from point to point
NARROWEST, SHORTEST = 1e-9, 1e-12
COUNTED = re.compile(r"; ([0-9]{1,9}) points(?: at equal steps)?; between them")


CERTAINTIES = ("documented", "probable", "untested")


class Claim(NamedTuple):
    """A claim about a target's format: what is assumed, how certain that is, and by which document."""

    what: str
    certainty: str
    source: str


class ClaimedFormat:
    """A format whose claims stand in ``targets.toml`` by its name."""

    name: str

    @property
    def claims(self) -> list[Claim]:
        """The claims, and how certain each is: documented, probable or untested."""
        claims = [(certainty, STATED[self.name].get(certainty, ())) for certainty in CERTAINTIES]
        return [Claim(what, certainty, source) for certainty, rows in claims for what, source in rows]

    @property
    def untested(self) -> list[Claim]:
        """The questions that no document settles."""
        return [claim for claim in self.claims if claim.certainty == "untested"]


def facts_of(name: str) -> dict[str, Any]:
    """Return the fields of a target, or of its switches, that ``targets.toml`` states, with the writer of its layout.

    The layout lies in ``targets``, called like the target, as codesys-switches.st; columns of text have none.
    """
    facts: dict[str, Any] = {"name": name}
    for path in FOLDER.glob(f"{name.replace(' ', '-')}.*"):
        if path.suffix != ".py":
            facts["write"] = by_layout(path.name)
    for field, value in STATED[name].items():
        if isinstance(value, list) and field not in CERTAINTIES:
            facts[field] = tuple(part for each in value for part in (SPLINES if each == "splines" else (each,)))
        elif field not in CERTAINTIES:
            facts[field] = value
    return facts


class CamExport(NamedTuple):
    """The argument of a writer: a table in the target's numbers, a name, and the lines of the header."""

    table: Table
    name: str
    header: tuple[str, ...]
    units: Units  # of x and y
    repeats: bool = True  # whether the cycle follows upon itself
    separator: str = ";"  # like the decimal sign asked for where texts have columns
    decimal: str = "."


def by_layout(name: str) -> Callable[[Any], str]:
    """Return a writer that fills the layout of that name in ``targets``, which imports what it calls."""

    def write(handed: Any) -> str:
        given = {"handed": handed, "literal": literal}
        if isinstance(handed, CamExport):
            points = list(zip(*(map(literal, column) for column in handed.table.columns.values()), strict=True))
            given |= {"cam": f"Cam_{handed.name}", "points": points, "n": len(points)}
        return LAYOUTS.load(name).generate(**given).decode()

    return write


class Track(NamedTuple):
    """A switch by its number, from 1, with its name and when it is on; past the end of the cycle where to is less."""

    number: int
    name: str
    on: tuple[tuple[float, float], ...]


class SwitchExport(NamedTuple):
    """The argument of a writer: tracks in the target's numbers, a name, and the lines of the header."""

    tracks: Sequence[Track]
    name: str
    header: tuple[str, ...]
    cycle: float = CYCLE
    separator: str = ";"
    decimal: str = "."

    @property
    def called(self) -> list[str]:
        """The lines that tell which track is which."""
        return [f"track {track.number}: {visible(track.name)}{'' if track.on else NEVER}" for track in self.tracks]

    @property
    def times(self) -> list[tuple[int, float, float]]:
        """Each time of being on: the number of its track, from where, to where."""
        return [(track.number, *each) for track in self.tracks for each in track.on]


@dataclass(frozen=True)
class Tappets(ClaimedFormat):
    """The way of switches into a target: writer and reader of their file, its numbers, and how certain that is."""

    name: str
    title: str
    write: Callable[[SwitchExport], str]
    read: Callable[[str], list[Track]]
    number: Number = LREAL
    tracks: int = MOST_TRACKS
    times: int = MOST_TIMES


@dataclass(frozen=True)
class Target(ClaimedFormat):
    """A controller, or a format of tables."""

    name: str
    title: str
    suffix: str
    columns: tuple[str, ...]  # what a point has
    # what may be between points; of several, where no document tells, the worst is a bound
    rules: tuple[str, ...]
    write: Callable[[CamExport], str]
    read: Callable[[str], Table]
    number: Number = LREAL
    points: tuple[int, int] = (2, 10_000)  # the fewest and the most
    counts: tuple[int, ...] = ()  # all that there may be where these are few
    signs: tuple[str, ...] = ()  # which of separator and decimal may be asked for
    spacing: Spacing = "free"
    # the rules for a table of x and y only, where a file may have no more
    plain: tuple[str, ...] = ()
    # of which order, unless given otherwise
    tolerance: Sequence[tuple[str, float]] = (("y", 1e-4), ("a", 0.01))
    exact: Callable[[CamProfile], Flags] = lambda of: np.zeros(len(of.origins), dtype=np.bool_)
    """which stretches of a motion need no points within"""
    built: Callable[[CamProfile, Array, tuple[float, float]], Table] | None = None
    """makes a table of polynomials of a motion, between places, in steps of x and y"""
    # how it takes switches; None where its format has none, or no document tells how
    tappets: Tappets | None = None


def tracks(given: Sequence[CamSwitch], tappets: Tappets) -> list[Track]:
    """Return switches as tracks in a target's numbers, a begin at the end of the cycle as 0; or raise TargetError."""
    if len(given) > tappets.tracks:
        raise TargetError(f"{len(given)} switches; expected at most {tappets.tracks}")
    listed = []
    for k, switch in enumerate(given, 1):
        cycle = switch.switch.cycle
        ends = [(0.0 if begin == cycle else begin, end or cycle) for begin, end in switch.switch.on]
        held = tappets.number.rounded(np.array(ends).reshape(-1, 2)).tolist()
        for (begin, end), (first, last) in zip(switch.switch.on, held, strict=True):
            if first == last:
                message = f"{switch.name}: on from {begin:.9g} to {end:.9g}"
                raise TargetError(f"{message} is no time in {tappets.number.name}")
        listed.append(Track(k, switch.name, tuple((first, last) for first, last in held)))
    count = sum(len(track.on) for track in listed)
    if not 1 <= count <= tappets.times:
        raise TargetError(f"{count} times of being on; expected 1 to {tappets.times:,}")
    return listed


def tracks_of_rows(text: str, rows: Iterable[Sequence[float]]) -> list[Track]:
    """Return the tracks of times, with the names that comments of the text tell; raise TargetError, by track."""
    names = {int(number): name.strip() for number, name in CALLED.findall(text)}
    spans: dict[int, list[tuple[float, float]]] = {number: [] for number in names}
    for number, begin, end in rows:
        if not 1 <= number <= MOST_TRACKS or number != int(number):
            raise TargetError(f"a track has the number {number:g}; expected 1 to {MOST_TRACKS:,}")
        spans.setdefault(int(number), []).append((begin, end))
    if not any(spans.values()):
        raise TargetError("no time of being on; expected a track with one")
    if sum(map(len, spans.values())) > MOST_TIMES:
        raise TargetError(f"more than {MOST_TIMES:,} times of being on; expected at most so many")
    listed = []
    for number, times in sorted(spans.items()):
        on = sorted(times)
        # a time that goes on past the end of the cycle
        if len(on) > 1 and on[0][0] == 0.0 and on[-1][1] == CYCLE:
            on = [*on[1:-1], (on[-1][0], on[0][1])]
        name = names.get(number, f"Track {number}").removesuffix(NEVER)
        try:
            listed.append(Track(number, name, Switch(name, tuple(on), CYCLE).on))
        except ValueError as error:
            raise TargetError(f"track {number}: {error}") from None
    return listed


def differences(given: Sequence[CamSwitch], listed: Sequence[Track]) -> list[SwitchDifference]:
    """Return how each track differs from the switch that is meant; raise TargetError where there are others."""
    if [track.number for track in listed] != [*range(1, len(given) + 1)]:
        raise TargetError(f"tracks {', '.join(str(track.number) for track in listed[:9])}; expected 1 to {len(given)}")
    pairs = zip(given, listed, strict=True)
    return [
        compare_switches(switch.switch, Switch(switch.name, track.on, switch.switch.cycle)) for switch, track in pairs
    ]


def read_table(path: Path, target: Target) -> Table:
    """Return the table of a target's file; raise ReadError, in a line, where it is none."""
    try:
        return parse_table(text_of(path, target), target)
    except TargetError as error:
        raise ReadError(f"{path}: {error}") from None


def text_of(path: Path, target: Target) -> str:
    """Return the text of a target's file, without what ends a text of old."""
    return read_text(path, f"a file for {target.name}", MOST, foreign=True).rstrip("\x1a\x00")


def parse_table(text: str, target: Target) -> Table:
    """Return the table of a text; raise TargetError for none, a part of a table, and numbers by which fits overflow."""
    with np.errstate(over="ignore", invalid="ignore"):  # what is not finite is refused by point
        table = target.read(text)
    for name, column in table.columns.items():
        size = np.abs(column)
        if size.max() > LARGEST:
            k = int(size.argmax())
            raise TargetError(f"point {k + 1}: {name} is {column[k]:.6g}; expected at most {LARGEST:.0e} either way")
    least = max(SHORTEST, NARROWEST * float(table.x[-1] - table.x[0]))
    steps = np.diff(table.x)
    if steps.min() < least:
        k = int(steps.argmin())
        raise TargetError(f"point {k + 2}: x rises by {steps[k]:.3g}; expected a step of at least {least:.3g}")
    # a stretch's largest term: of its polynomial, or a sine's amplitude, angle or phase
    if table.profile is not None:
        of = table.profile
        far = np.maximum(np.abs(of.edges[:-1] - of.origins), np.abs(of.edges[1:] - of.origins))[:, None]
        with np.errstate(over="ignore", invalid="ignore", under="ignore"):
            powers = np.abs(of.c) * far ** np.arange(of.c.shape[1])
            amplitude, rate, phase = np.moveaxis(np.abs(of.sines), 2, 0)
            terms = np.hstack([powers, amplitude, rate * far, phase]).max(axis=1)
        if not np.all(terms <= LARGEST):
            k = int(np.argmin(terms <= LARGEST))
            raise TargetError(f"segment {k + 1}: a term reaches {terms[k]:.3g}; expected at most {LARGEST:.0e}")
    match = COUNTED.search(text)
    if match and int(match[1]) != len(table.x):
        raise TargetError(f"{len(table.x)} points; its header tells {match[1]} (is the file cut off?)")
    return table


def header(points: int, between: str, equal: bool, units: Units) -> str:
    """Return the line of a header that tells units, points, whether at equal steps, and what is between them."""
    counted = f"{points} points{' at equal steps' if equal else ''}"
    return f"x in {units[0]}, y in {units[1]}; {counted}; between them {between}"
