"""Phases in cells: what a row of phases computes from its law's coefficients."""

from collections.abc import Sequence

from engine.motion import Phase
from workbook.book.rows import filled

LAW_NUMBER = '=IF([law]="",1,MATCH([law],law_code,0))'
CA = "MAX(INDEX(law_ca_max,[no]),-INDEX(law_ca_min,[no]))"
VELOCITY = "=IF([span]>0,INDEX(law_cv,[no])*ABS([h])/[span],0)"
ACCELERATION = f"=IF([span]>0,{CA}*ABS([h])/[span]^2,0)"
JERK = '=IF(ABS([h])*[span]>0,IF(INDEX(law_cj,[no])="∞","∞",INDEX(law_cj,[no])*ABS([h])/[span]^3),0)'
LOW = "=IF([span]>0,[y0]+MIN([h]*INDEX(law_low,[no]),[h]*INDEX(law_high,[no])),{0})"
HIGH = "=IF([span]>0,[y0]+MAX([h]*INDEX(law_low,[no]),[h]*INDEX(law_high,[no])),{0})"
RMS = "IF([span]>0,INDEX(law_ca_rms,[no])*ABS([h])/[span]^2,0)"


def kind(given: str, ends: str = "") -> str:
    """Return the formula that names a phase: spare where its entry ``given`` is empty, else by law and lift.

    ``ends`` is the table of what phases take from their neighbours, in books that have it: they may turn round.
    """
    still, other = "[lift]=0", '"return"'
    if ends:
        still, other = f"ABS([lift])+INDEX([{ends}.mode],[k])=0", 'IF([lift]<0,"return","turn")'
    return f'=IF([{given}]="","spare",IF(OR([law]="DWL",{still}),"dwell",IF([lift]>0,"rise",{other})))'


def kinds(phases: Sequence[Phase], rows: int) -> list[str]:
    """Return what each phase is, with the spare rows filled up."""
    used = [
        ("rise" if one.lift > 0 else "return" if one.lift < 0 else "turn") if one.moves else "dwell" for one in phases
    ]
    return filled(used, rows, "spare")
