"""What the functions take for a number, a law, nothing: docs/functions.md says what each program answers."""

from docs.functions import ASKED, PAGE, answers, page
from docs.witnesses import columns, differences
from tests.functions.calc import Calc


def test_the_page_of_the_functions_is_up_to_date(calc: Calc) -> None:
    kept, fresh = PAGE.read_text(encoding="utf-8"), page(answers(calc))
    assert differences(kept, fresh) == []
    assert len(columns(fresh)["asked"]) == len(ASKED)
    assert sum(head in columns(kept) for head in columns(fresh)) > 2


def test_the_names_answer_as_documented_in_both_programs() -> None:
    kept = columns(PAGE.read_text(encoding="utf-8"))
    names = [head for head in kept if head.startswith("names, ")]
    assert len(names) == 2
    told = {head: {asked for asked, cell in zip(kept["asked"], kept[head], strict=True) if cell} for head in names}
    without = {'MOTION.S("CUB",0.25)', 'MOTION.CV("TVP")', 'MOTION.CV("OWN")', 'MOTION.XI("ACS",0.125)'}
    (formulon,) = (told.pop(head) for head in names if "formulon" in head)
    assert formulon == {f"`={asked}`" for asked in without}  # no optional parameters
    assert [*told.values()] == [set()]
