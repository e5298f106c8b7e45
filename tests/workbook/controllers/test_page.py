"""docs/controllers.md says what the targets declare."""

from docs.controllers import PAGE, page
from workbook.controllers.registry import targets


def test_the_page_is_what_the_targets_declare() -> None:
    assert PAGE.read_text(encoding="utf-8") == page()


def test_every_target_names_its_documents_and_what_none_settles() -> None:
    for one in targets():
        claims = [*one.claims, *(one.tappets.claims if one.tappets else ())]
        assert one.claims
        assert all(claim.what and claim.source for claim in claims)
        assert {claim.certainty for claim in claims} <= {"documented", "probable", "untested"}
        assert one.untested or one.name in ("codesys",)
