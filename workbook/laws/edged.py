"""Pages of the laws of two pulses and a cruise: all of it follows from the forms and durations of their stages.

Up to seven: an edge up to A, constant, an edge down; uniform velocity; an edge down to −B, constant, an edge up. What
a family has of them it states by number, with the formula of each duration. Source: S1, 'Modified trapezoidal curve'.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

from engine.laws.pulse_law import K, PulseLaw
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Quantity
from workbook.laws.family import Page, PieceRow

CELLS = cell_tables(__file__)

RISE, CRUISE, FALL = (1, 2, 3), 4, (7, 6, 5)
"""stages of the first pulse, of uniform velocity, and of the second pulse counted from its end"""


class Form(NamedTuple):
    """A stage of a pulse: factors for a duration d and a height A, and the words and entries of its piece."""

    word: str
    gain: str  # velocity gained, over A d
    travel: str  # travel from rest, over A d²
    square: str  # ∫a², over A² d
    jerk: str  # largest jerk, over A/d
    # the entries of the piece in the first pulse: H stands for its height, D its duration
    early: Mapping[str, str]
    late: Mapping[str, str]  # and in the second, in the order of time


QUARTER = "IF(D>0,PI()/(2*D),0)"
SLOPE = "IF(D>0,H/D,0)"
SINE = {"P": "H", "omega": QUARTER, "equation": "a = H sin(πu / 2D)"}
COSINE = {"P": "H", "omega": QUARTER, "phi": "PI()/2", "equation": "a = H cos(πu / 2D)"}
UP = {"c1": SLOPE, "equation": "a = H u/D"}
DOWN = {"c0": "H", "c1": f"0-{SLOPE}", "equation": "a = H (1 − u/D)"}
LEVEL = {"c0": "H", "equation": "a = H"}
WAVE = {"P": "H", "omega": "PI()/D", "equation": "a = H sin(πu / D)"}
FLAT = Form("constant", "1", "1/2", "1", "", LEVEL, LEVEL)
SINE_OUT = Form("quarter sine from the dwell", "@k", "@k*(1-@k)", "1/2", "PI()/2", SINE, COSINE)
SINE_IN = Form("quarter sine inside", "@k", "@k^2", "1/2", "PI()/2", COSINE, SINE)
LINE_OUT = Form("straight from the dwell", "1/2", "1/6", "1/3", "1", UP, DOWN)
LINE_IN = Form("straight inside", "1/2", "1/3", "1/3", "1", DOWN, UP)
HALF_SINE = Form("half sine", "@k", "@k/2", "1/2", "PI()", WAVE, WAVE)
"""cut at its peak into two quarters: its second is :data:`CREST`"""
SEARCHED = {SINE_IN.word: CELLS["quarter sine inside"], LINE_IN.word: CELLS["straight inside"]}
"""by the edge next to the greatest velocity: the cells of the greatest v·a on it"""
CREST = {"P": "H", "omega": "PI()/D", "phi": "PI()/2", "equation": "a = H cos(πu / D)"}


class Stage(NamedTuple):
    """A stage of a family: its form, none of uniform velocity, and the formula of its duration."""

    form: Form | None
    duration: str = ""  # empty where it is what an engineer enters


FORMS = {form.word: form for form in (FLAT, SINE_OUT, SINE_IN, LINE_OUT, LINE_IN, HALF_SINE)}


def stages_in(module: str, title: str) -> dict[int, Stage]:
    """Return the stages in the table under a heading beside a module: each its number, form and duration."""
    columns = formulas_by_row(module, title)
    durations = columns.get("duration", [""] * len(columns["stage"]))
    rows = zip(columns["stage"], columns["form"], durations, strict=True)
    return {int(stage): Stage(FORMS.get(form), duration) for stage, form, duration in rows}


def added(terms: Sequence[str]) -> str:
    """Return a sum, without a sign of equality; 0 of no terms."""
    return "+".join(terms) or "0"


@dataclass(frozen=True)
class Stages:
    """The stages of a family by number."""

    stages: Mapping[int, Stage]

    def forms(self, side: Sequence[int]) -> list[tuple[int, Form]]:
        """Return the stages of a side that the family has, with their forms."""
        forms = ((k, self.stages[k].form) for k in side if k in self.stages)
        return [(k, form) for k, form in forms if form is not None]

    def total(self, side: Sequence[int], factor: str) -> str:
        """Return the sum of durations, each with a factor of its stage's form."""
        return added([times(getattr(form, factor), f"@d{k}") for k, form in self.forms(side)])

    def travel(self, side: Sequence[int]) -> str:
        """Return the travel from rest over the stages of a side, counted from its outer end, for unit height."""
        terms, before = [], list[str]()
        for k, form in self.forms(side):
            terms += [f"{form.travel}*@d{k}^2", *([f"({added(before)})*@d{k}"] if before else [])]
            before.append(times(form.gain, f"@d{k}"))
        return added(terms)

    def pieces(self, k: int, form: Form | None) -> list[PieceRow]:
        """Return the pieces of a stage: two of a half sine, else a single piece."""
        if form is None:
            return [PieceRow(f"{k} · uniform velocity", "a = 0", f"=@d{k}")]
        if form is HALF_SINE:
            first, second = ("rises", "falls") if k < CRUISE else ("falls", "rises")
            return [self.row(k, first, f"=@d{k}/2", WAVE), self.row(k, second, f"=@d{k}/2", CREST)]
        return [self.row(k, form.word, f"=@d{k}", form.early if k < CRUISE else form.late)]

    def row(self, k: int, word: str, duration: str, stated: Mapping[str, str]) -> PieceRow:
        """Return a piece of a stage by what is stated of its entries and its equation."""
        entries = dict(stated)
        height, sign = ("@ca_max", "A") if k < CRUISE else ("@ca_min", "−B")
        equation = entries.pop("equation").replace("H", sign).replace("D", f"d{k}")
        formulas = {name: f"={text.replace('D', f'@d{k}').replace('H', height)}" for name, text in entries.items()}
        return PieceRow(f"{k} · {word}", equation, duration, **formulas)

    def coefficients(self) -> dict[str, tuple[str, str]]:
        """Return the formula of each coefficient."""
        cruise = "+@m*@d4" if CRUISE in self.stages else ""
        squares = f"@ca_max^2*({self.total(RISE, 'square')})+@ca_min^2*({self.total(FALL, 'square')})"
        return {
            "cv": ("=@ca_max*@m", "A m"),
            "ca_max": (f"=1/(@sa{cruise}+@m*@sd/@n)", "A: from s(1) = 1 with A m = B n"),
            "ca_min": ("=0-@ca_max*@m/@n", "−B = −A m/n"),
            "ca_rms": (f"=SQRT({squares})", "√(A² ∫p² + B² ∫q²), p and q the pulses of unit height"),
            "cj": self.jerk(),
            "va_max": self.strongest(RISE, "@drive", "@ca_max"),
            "va_min": self.strongest(FALL, "@brake", "@ca_min"),
        }

    def jerk(self) -> tuple[str, str]:
        """Return the formula of C_j: infinite where an edge has no duration, or the family lacks it."""
        edges = [[(k, form) for k, form in self.forms(side) if form.jerk] for side in (RISE, FALL)]
        if any(len(side) < 2 and HALF_SINE not in dict(side).values() for side in edges):
            return '="∞"', "the acceleration jumps"
        sides = zip(edges, ("@ca_max", "(0-@ca_min)"), strict=True)
        steepest = ",".join(f"{form.jerk}*{height}/@d{k}" for side, height in sides for k, form in side)
        shortest = ",".join(f"@d{k}" for side in edges for k, _ in side)
        return f'=IF(MIN({shortest})>0,MAX({steepest}),"∞")', "of the steepest edge; ∞ where one has no time"

    def strongest(self, side: Sequence[int], name: str, height: str) -> tuple[str, str]:
        """Return the formula of the greatest v·a of a side, on the stage next to the greatest velocity."""
        k, form = self.forms(side)[-1]
        if form is FLAT:
            return f"={height}*@cv", "at the greatest velocity"
        if form is HALF_SINE:
            return f"={height}*ABS({height})*@d{k}*3*SQRT(3)/(4*PI())", "A² d · 3√3/4π"
        if form is SINE_IN:
            return f"={height}*SQRT(1-{name}_x^2)*({name}_v+{name}_g*{name}_x)", "A cos x (v₂ + G sin x)"
        return f"={height}*{name}_x*({name}_v+{name}_g*(1-{name}_x^2))", "A y (v₂ + G(1 − y²))"

    def workings(self, law: PulseLaw) -> list[Quantity]:
        """Return the rows of what the coefficients are worked out from."""
        cell, (gained, rise), (lost, fall) = CELLS["workings"], *law.lobes
        stages = zip(sorted(self.stages.items()), law.as_pieces(), strict=True)
        lasting = [(k, piece.duration, stage.duration) for (k, stage), piece in stages if stage.duration]
        curved = any("@k" in form.gain for _, form in self.forms((*RISE, *FALL)))
        return [
            *(cell("@d{k}", duration, k=k, formula=formula) for k, duration, formula in lasting),
            *([cell("@k", K)] if curved else []),
            cell("@m", gained, total=self.total(RISE, "gain")),
            cell("@n", lost, total=self.total(FALL, "gain")),
            cell("@sa", rise, travel=self.travel(RISE)),
            cell("@sd", fall, travel=self.travel(FALL)),
            *self.searched(law),
        ]

    def searched(self, law: PulseLaw) -> list[Quantity]:
        """Return the rows that find the greatest v·a of either side on an edge that ends without acceleration."""
        rows: list[Quantity] = []
        sides = (("@drive", "driving", RISE, "@ca_max"), ("@brake", "braking", FALL, "(0-@ca_min)"))
        for (name, side, stages, height), edge in zip(sides, law.inner_edges, strict=True):
            k, form = self.forms(stages)[-1]
            if form.word in SEARCHED:
                cell = partial(SEARCHED[form.word], name=name, side=side)
                before = self.total(stages[:-1], "gain")
                rows += [
                    cell("{name}_v", edge.velocity, height=height, before=before),
                    cell("{name}_g", edge.gain, height=height, gain=times(form.gain, f"@d{k}")),
                    cell("{name}_x", edge.at),
                ]
        return rows


def times(factor: str, of: str) -> str:
    """Return a product, without a factor of 1."""
    return of if factor == "1" else f"{factor}*{of}"


def edged(forms: Mapping[int, Stage], **stated: Any) -> Page:
    """Return the page of a family by its stages; ``stated`` are its other fields."""
    stages = Stages(forms)
    rise = [k for k, _ in stages.forms(RISE)]
    rows = {k: stages.pieces(k, forms[k].form) for k in sorted(forms)}
    return Page(
        pieces=tuple(row for stage_rows in rows.values() for row in stage_rows),
        workings=stages.workings,
        coefficients=stages.coefficients(),
        fastest=f"={added([f'@d{k}' for k in rise])}",
        early=sum(len(rows[k]) for k in rise),
        **{"end_mode": "=1", **stated},
    )
