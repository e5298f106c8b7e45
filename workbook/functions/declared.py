"""The functions MOTION.*: names, arguments and help texts, which both back ends take from here.

What both back ends promise, beside the help texts:

- An error value given as an argument passes through; one within a range gives an error.
- A law is named by its code, in capitals or not, blanks around it ignored. Anything else: #VALUE!.
- Where a number is expected, an empty cell counts as 0 and a text is #VALUE!. A number outside its domain is #NUM!.
- ``p`` holds the law's parameters in the order of its page, a row or a column, read left to right, top to bottom;
  blank cells count as 0, and where the motion turns round, ``start`` and ``end`` count as −1 and 1, ``none`` as 0.
  Left out, and where all of it is 0 or blank, the law is as delivered. Else another number of cells than
  :data:`PARAMETERS` says is #VALUE!, values that the engine refuses are #NUM!. OWN takes
  rows of eight (duration, c0, c1, c2, c3, P, ω, φ), of which those of an empty or zero duration are passed over; left
  out, it is the polynomial 3-4-5. DWL and LIN ignore p.
- ξ is right-continuous at breaks, with a tolerance of 2e-9; at ξ = 1 the left limit counts.
- An infinite coefficient is #NUM!, and so are coefficients and inverse of an own law with a sine of more than
  1,000 rad in one piece. What only evaluates the law, at ξ or in a phase, takes any sine.
- A row of a table of phases: code, duration, lift, then the law's parameters, as p takes them; OWN has its pieces side
  by side, eight cells each, as many as there is room for; no room for one is #VALUE!. Rows at the end whose first three
  cells are empty are ignored. Fewer than three columns, or no rows: #VALUE!. A duration that is not positive, or a
  dwell with a lift: #NUM!. Beyond [0, total], by more than 1e-12 of the total: #NUM!; a joint begins 2e-9 early.
- A first column of numbers: phases as a book has them, from, to, lift, code, parameters, at rest before, between (gaps
  beyond 1e-9 of the whole) and after; any x. Fewer than four columns, a row VIA: #VALUE!; an overlap: #NUM!.
- Phases hand over: beside a straight line (LIN) a curved phase takes its velocity, beside a dwell and where nothing
  stands beside it, it rests. A row VIA with velocity, acceleration and jerk (per x, x², x³) in place of duration, lift
  and first parameter prescribes them between two curved phases, or where the motion begins or ends; else they are 0
  there. Laws of two pulses meet a velocity, CUB, PO5 and PO7 of the share ½ one, two or three of these; what a law
  cannot meet is #NUM!, and so is a VIA beside another or one that a straight line contradicts, and a motion of VIA
  alone. Two straight lines beside each other keep their velocities.
- JRED and RMS: ranges of unequal size are #VALUE!; a negative inertia or duration, or durations of sum 0, are #NUM!.
- MOTION.XI: the first ξ that reaches s; s = 0 gives 0 and the law's end value 1. A law that moves backwards: #NUM!.
"""

from dataclasses import dataclass
from typing import Literal

from engine.laws.entry import IncompleteError
from workbook.functions.addin.motion_functions.laws import LAWS, OWN_TAKES, Text
from workbook.laws.registry import FAMILIES

NAMESPACE = "MOTION"
CATEGORY = Text("Machine motion", "Moto delle macchine", "Maschinenbewegung")
Kind = Literal["code", "number", "cells", "table"]
CODES: tuple[str, ...] = tuple(family.code for family in FAMILIES if family.page.functions)
"""codes of the laws that the functions know: of every family but points, which are a table of their own"""
PARAMETERS = {one.code: len(one.page.parameters) for one in FAMILIES if one.code in CODES and one.code != "OWN"}
"""codes of the laws with the number of parameters each takes; OWN, beside them, takes rows of pieces"""
if wrong := [code for code, count in PARAMETERS.items() if code not in LAWS or bool(LAWS[code].takes) != bool(count)]:
    raise IncompleteError(f"addin/motion_functions/laws.py lacks {', '.join(wrong)}, or words for their parameters")
TAKES: dict[str, Text] = {code: one.takes for code, one in LAWS.items() if one.takes} | {"OWN": OWN_TAKES}
"""what each law takes that takes anything"""


def spelled(last: str) -> str:
    """Return the codes of the laws, the last after a language's word for or."""
    return f"{', '.join(CODES[:-1])} {last} {CODES[-1]}"


def taken(language: str) -> str:
    """Return what each law takes, in a language."""
    alike: dict[str, list[str]] = {}
    for code, words in TAKES.items():
        alike.setdefault(getattr(words, language), []).append(code)
    return "; ".join(f"{', '.join(codes)}: {words}" for words, codes in alike.items())


@dataclass(frozen=True)
class Argument:
    """An argument: what it takes (a law's code, a number, a range or array or single value, a table of phases)."""

    kind: Kind
    name: Text
    help: Text
    optional: bool = False
    """whether it may be left out"""

    @property
    def shown(self) -> str:
        """The name as a call shows it: in brackets where it may be left out."""
        return f"[{self.name.en}]" if self.optional else self.name.en


@dataclass(frozen=True)
class Function:
    """A function: the last part of its name, what it returns, its arguments; the last of them may be optional."""

    key: str
    help: Text
    arguments: tuple[Argument, ...]

    @property
    def name(self) -> str:
        """The name as it stands in a formula and in the file."""
        return f"{NAMESPACE}.{self.key}"


LAW = Argument("code", Text("law", "legge", "Gesetz"), Text(
    f"Code of the motion law: {spelled('or')}",
    f"Codice della legge di moto: {spelled('o')}",
    f"Kürzel des Bewegungsgesetzes: {spelled('oder')}"))  # fmt: skip
XI = Argument("number", Text("xi", "xi", "xi"), Text(
    "Share of the rise time that has passed, ξ = t/t_a, from 0 to 1",
    "Frazione trascorsa del tempo di alzata, ξ = t/t_a, da 0 a 1",
    "Verstrichener Anteil der Hubzeit, ξ = t/t_a, von 0 bis 1"))  # fmt: skip
RISE = Argument("number", Text("s", "s", "s"), Text(
    "Share of the rise that is reached, from 0 to 1",
    "Frazione raggiunta dell'alzata, da 0 a 1",
    "Erreichter Anteil des Hubs, von 0 bis 1"))  # fmt: skip
P = Argument("cells", Text("parameters", "parametri", "Parameter"), Text(
    f"Range of the law's parameters. {taken('en')}. Left out: as delivered",
    f"Intervallo dei parametri della legge. {taken('it')}. Se omesso: come fornita",
    f"Bereich mit den Parametern des Gesetzes. {taken('de')}. Fehlt er: wie geliefert"), optional=True)  # fmt: skip
X = Argument("number", Text("x", "x", "x"), Text(
    "Abscissa from the start of the first phase, in the unit of the durations; or counted as from and to",
    "Ascissa dall'inizio della prima fase, nell'unità delle durate; o contata come da e a",
    "Abszisse ab Beginn der ersten Phase, in der Einheit der Dauern; oder gezählt wie von und bis"))  # fmt: skip
PHASES = Argument("table", Text("phases", "fasi", "Phasen"), Text(
    "A row a phase: code of the law, duration, lift, parameters; or, as in a workbook: from, to, lift, code, "
    "parameters. OWN: its pieces side by side, eight cells each. A phase takes the velocity of a straight line LIN "
    "beside it; a row VIA, velocity, acceleration, jerk prescribes these between two phases",
    "Una riga per fase: codice della legge, durata, alzata, parametri; o, come in una cartella: da, a, alzata, "
    "codice, parametri. OWN: tratti affiancati, otto celle ciascuno. Una fase prende la velocità della retta "
    "LIN accanto; una riga VIA, velocità, accelerazione, jerk le prescrive fra due fasi",
    "Eine Zeile je Phase: Kürzel des Gesetzes, Dauer, Hub, Parameter; oder wie in einer Mappe: von, bis, Hub, "
    "Kürzel, Parameter. OWN: Abschnitte nebeneinander, je acht Zellen. Eine Phase nimmt die Geschwindigkeit einer "
    "Geraden LIN neben ihr; eine Zeile VIA, Geschwindigkeit, Beschleunigung, Ruck schreibt sie zwischen zweien vor",
))  # fmt: skip
INERTIAS = Argument("cells", Text("inertias", "inerzie", "Trägheitsmomente"), Text(
    "Moments of inertia, each about its own shaft",
    "Momenti d'inerzia, ciascuno rispetto al proprio albero",
    "Massenträgheitsmomente, jedes um seine eigene Welle"))  # fmt: skip
RATIOS = Argument("cells", Text("ratios", "rapporti", "Übersetzungen"), Text(
    "Speed of each shaft over the speed of the reference shaft, as many as inertias",
    "Velocità di ciascun albero diviso quella dell'albero di riferimento, tante quante le inerzie",
    "Drehzahl jeder Welle durch die der Bezugswelle, so viele wie Trägheitsmomente"))  # fmt: skip
VALUES = Argument("cells", Text("values", "valori", "Werte"), Text(
    "Values of the profile, one for each interval",
    "Valori del profilo, uno per intervallo",
    "Werte des Verlaufs, einer je Zeitabschnitt"))  # fmt: skip
DURATIONS = Argument("cells", Text("durations", "durate", "Dauern"), Text(
    "Durations of the intervals, as many as values",
    "Durate degli intervalli, tante quanti i valori",
    "Dauern der Zeitabschnitte, so viele wie Werte"))  # fmt: skip

FUNCTIONS: tuple[Function, ...] = (
    Function("S", Text(
        "Dimensionless position s(ξ) of a motion law",
        "Posizione adimensionale s(ξ) di una legge di moto",
        "Normierter Weg s(ξ) eines Bewegungsgesetzes"), (LAW, XI, P)),
    Function("V", Text(
        "Dimensionless velocity ds/dξ of a motion law",
        "Velocità adimensionale ds/dξ di una legge di moto",
        "Normierte Geschwindigkeit ds/dξ eines Bewegungsgesetzes"), (LAW, XI, P)),
    Function("A", Text(
        "Dimensionless acceleration d²s/dξ² of a motion law",
        "Accelerazione adimensionale d²s/dξ² di una legge di moto",
        "Normierte Beschleunigung d²s/dξ² eines Bewegungsgesetzes"), (LAW, XI, P)),
    Function("J", Text(
        "Dimensionless jerk d³s/dξ³ of a motion law, within its stages",
        "Jerk adimensionale d³s/dξ³ di una legge di moto, all'interno dei tratti",
        "Normierter Ruck d³s/dξ³ eines Bewegungsgesetzes, innerhalb seiner Abschnitte"), (LAW, XI, P)),
    Function("XI", Text(
        "Inverse of a motion law: ξ at which it first reaches s",
        "Inversa di una legge di moto: ξ in cui raggiunge s per la prima volta",
        "Umkehrung eines Bewegungsgesetzes: ξ, bei dem es s zuerst erreicht"), (LAW, RISE, P)),
    Function("CV", Text(
        "Velocity coefficient C_v = max |v| of a motion law",
        "Coefficiente di velocità C_v = max |v| di una legge di moto",
        "Geschwindigkeitskennwert C_v = max |v| eines Bewegungsgesetzes"), (LAW, P)),
    Function("CA", Text(
        "Acceleration coefficient C_a = max |a| of a motion law",
        "Coefficiente di accelerazione C_a = max |a| di una legge di moto",
        "Beschleunigungskennwert C_a = max |a| eines Bewegungsgesetzes"), (LAW, P)),
    Function("CARMS", Text(
        "RMS acceleration coefficient C_a,rms = √∫a² dξ of a motion law",
        "Coefficiente di accelerazione efficace C_a,rms = √∫a² dξ di una legge di moto",
        "Kennwert der effektiven Beschleunigung C_a,rms = √∫a² dξ eines Bewegungsgesetzes"), (LAW, P)),
    Function("CJ", Text(
        "Jerk coefficient C_j = max |j| of a motion law; #NUM! where the acceleration jumps",
        "Coefficiente di jerk C_j = max |j| di una legge di moto; #NUM! dove l'accelerazione ha un salto",
        "Ruckkennwert C_j = max |j| eines Bewegungsgesetzes; #ZAHL! wo die Beschleunigung springt"), (LAW, P)),
    Function("POS", Text(
        "Position of a motion of phases at x, from 0 at its start",
        "Posizione in x di un moto composto da fasi, da 0 all'inizio",
        "Lage einer Bewegung aus Phasen bei x, ab 0 am Beginn"), (X, PHASES)),
    Function("VEL", Text(
        "Velocity of a motion of phases at x, per unit of x",
        "Velocità in x di un moto composto da fasi, per unità di x",
        "Geschwindigkeit einer Bewegung aus Phasen bei x, je Einheit von x"), (X, PHASES)),
    Function("ACC", Text(
        "Acceleration of a motion of phases at x, per unit of x squared",
        "Accelerazione in x di un moto composto da fasi, per unità di x al quadrato",
        "Beschleunigung einer Bewegung aus Phasen bei x, je Einheit von x zum Quadrat"), (X, PHASES)),
    Function("JRED", Text(
        "Reflected inertia Σ J (ω_i/ω)² of shafts that turn together",
        "Inerzia ridotta Σ J (ω_i/ω)² di alberi che ruotano insieme",
        "Reduziertes Massenträgheitsmoment Σ J (ω_i/ω)² gemeinsam drehender Wellen"), (INERTIAS, RATIOS)),
    Function("RMS", Text(
        "Root mean square √(Σ v² t / Σ t) of a profile constant in each interval",
        "Valore efficace √(Σ v² t / Σ t) di un profilo costante in ogni intervallo",
        "Effektivwert √(Σ v² t / Σ t) eines abschnittsweise konstanten Verlaufs"), (VALUES, DURATIONS)),
)  # fmt: skip
