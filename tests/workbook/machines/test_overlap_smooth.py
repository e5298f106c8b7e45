"""How smooth transfer and tools of an overlap must be: what is asked, and the joint that is told."""

import pytest

from tests.workbook.cells import computed, disagreeing
from workbook.reading.descriptions import counted_from_1, make_machine, read_machine
from workbook.templates import TEMPLATES

OVERLAP = TEMPLATES["indexing-overlap"]


def machine(transfer, tool):
    data = read_machine(OVERLAP.description).model_dump()
    data["sizes"] |= {"cycle": 12, "law": 6, "margins": 4}
    data["overlap"]["transfer"] |= transfer
    data["overlap"]["tools"][0] |= tool
    return make_machine(OVERLAP, data, counted_from_1)


MILL, DIE = "Indexing mill dwell to movement at 0°: ", "Die way in to {} at 0° after its arrival: "
SAID = {
    "smooth": ({}, {}, "", ""),
    "a way that begins with a jump": ({}, {"law_in": "ACS", "dwell": 0.0}, "", f"{DIE.format('way out')}acceleration"),
    "less is asked": ({"law": "ACS", "smoothness": "velocity"}, {"law_in": "CUB", "smoothness": "velocity"}, "", ""),
    "more is asked": ({"smoothness": "jerk"}, {"smoothness": "jerk"}, f"{MILL}jerk", f"{DIE.format('dwell')}jerk"),
    "within a law": ({"law": "TVP"}, {}, f"{MILL}acceleration jumps by", ""),
}


@pytest.mark.parametrize("what", SAID)
@pytest.mark.sample(3)
def test_the_joint_that_is_less_smooth_than_asked_is_named(what):
    transfer, tool, mill, die = SAID[what]
    one = machine(transfer, tool)
    value = computed(OVERLAP, one)
    for name, says in (("overlap_ok_smooth", mill), ("tool1_ok_smooth", die)):
        assert value(name) == ("FAIL" if says else "OK")
        assert not says or value(f"{name}_says").startswith(says)
    assert disagreeing(OVERLAP, one)[0] == []
