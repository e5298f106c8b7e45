"""Sine, constant and cosine acceleration: the SCCA family."""

from collections.abc import Iterator

from engine.laws.sine_constant_cosine import SineConstantCosine
from workbook.book.sentence import figure
from workbook.entries.types import SUM_TOLERANCE, DesignError, Share
from workbook.laws.edged import FLAT, SINE_IN, SINE_OUT, Stage, edged
from workbook.laws.family import LawCheck, Parameter
from workbook.laws.shared import BRIEF, EVEN, SHARE, SUM_SAYS, Shared, too_brief

PARTS = ("sine", "constant", "cosine", "straight")


class Parts(Shared):
    """The shares of the time of sine edges, constants, cosine edges and a straight line; they sum to 1."""

    sine: Share = SineConstantCosine.sine
    constant: Share = SineConstantCosine.constant
    cosine: Share = SineConstantCosine.cosine
    straight: Share = SineConstantCosine.straight

    def design_faults(self) -> Iterator[DesignError]:
        """Yield shares that do not fill the rise, and a law that cannot start or stop."""
        total = sum(getattr(self, part) for part in PARTS)
        fits = self.model_dump() | {part: getattr(SineConstantCosine, part) for part in PARTS}
        if abs(total - 1) > SUM_TOLERANCE:
            yield DesignError("", f"they sum to {figure(total)}; expected 1", "sum", fits)
        if not self.sine + self.constant + self.cosine:
            yield DesignError("", "all of the time is straight", "lasts", fits)
        if abs(total - 1) <= SUM_TOLERANCE and self.sine + self.constant + self.cosine:
            law = SineConstantCosine(**{part: getattr(self, part) for part in PARTS}, share=self.share)
            yield from too_brief([piece.duration for piece in law.as_pieces()], "", fits | {"share": EVEN})


PAGE = edged(
    {
        1: Stage(SINE_OUT, "=@sine*@share"),
        2: Stage(FLAT, "=@constant*@share"),
        3: Stage(SINE_IN, "=@cosine*@share"),
        4: Stage(None, "=@straight"),
        5: Stage(SINE_IN, "=@cosine*(1-@share)"),
        6: Stage(FLAT, "=@constant*(1-@share)"),
        7: Stage(SINE_OUT, "=@sine*(1-@share)"),
    },
    titled="Sine-constant-cosine (SCCA)",
    source="PTC Creo, 'SCCA'; mechdesigner.support, 'Sine-Constant-Cosine'",
    entries=Parts,
    law=SineConstantCosine,
    parameters=(
        Parameter("@sine", "Sine edges at the dwells", "b", "sine", "sine edges",
                  source="shares of the whole time; all four sum to 1"),
        Parameter("@constant", "Constant acceleration", "c", "constant", "constant"),
        Parameter("@cosine", "Cosine edges inside", "d", "cosine", "cosine edges"),
        Parameter("@straight", "Constant velocity", "e", "straight", "constant velocity"),
        SHARE,
    ),
    variations=(
        {"sine": 0.1, "constant": 0.6, "cosine": 0.3, "straight": 0.0, "share": 0.4},
        {"sine": 0.2, "constant": 0.0, "cosine": 0.6, "straight": 0.2, "share": 0.6},
        {"sine": 0.0, "constant": 0.5, "cosine": 0.2, "straight": 0.3, "share": 0.3},
        {"sine": 0.15, "constant": 0.25, "cosine": 0.35, "straight": 0.25, "share": 0.55},
    ),
    checks=(
        LawCheck("@sum", "the four shares sum to 1", "ABS(SUM([@pieces.d])-1)<check_zero", "sum", SUM_SAYS),
        LawCheck("@lasts", "the law starts and stops", "@sine+@constant+@cosine>0", "lasts",
                 '"all of the time is straight"'),
        BRIEF,
    ),
)  # fmt: skip
