"""Symmetric polynomials shifted by a share, and what a polynomial becomes between prescribed ends."""

from dataclasses import dataclass
from typing import ClassVar

from engine.laws.ended_polynomial import EndedPolynomial
from engine.laws.ends import REST, EndError, Ends, require_ends
from engine.laws.pulse import Pulse
from engine.laws.pulse_law import PulseLaw, TwoPulses
from engine.laws.shares import require_share


@dataclass(frozen=True)
class HalvedPolynomial(PulseLaw):
    """Two halves of a symmetric polynomial, S: s = 2λ S(ξ/2λ) up to ξ = λ, s = 1 − 2μ S((1 − ξ)/2μ) from there.

    The halves meet on the diagonal, s(λ) = λ, with the polynomial's own C_v and a = 0. With λ = ½ it is the
    polynomial, and only then are its ends prescribed: by the polynomial of the same degree. Raises ValueError
    unless λ, the ``share``, is between 0 and 1.
    """

    STAGES = (0, 2)
    ends = REST
    HALF: ClassVar[Pulse]
    ENDED: ClassVar[type[EndedPolynomial]]

    share: float = 0.5

    def __post_init__(self) -> None:
        require_share("share", self.share)

    @property
    def takes(self) -> str:
        """What the polynomial takes; nothing where a share shifts it."""
        return self.TAKES if self.share == 0.5 else ""

    def _pulses(self) -> TwoPulses:
        return TwoPulses(self.HALF, self.share, 0.0, self.HALF, 1.0 - self.share)

    def between(self, ends: Ends) -> EndedPolynomial:
        """Return the polynomial of this degree between these ends; EndError where a share shifts the law."""
        require_ends(self, ends, self.TAKES)
        if self.share != 0.5:
            raise EndError(
                f"{self.name} with the share {self.share:g} is made of two halves that begin and end at rest; "
                "with the share 0.5 its ends can be prescribed"
            )
        return self.ENDED(ends)
