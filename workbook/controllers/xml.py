"""XML from anywhere: read without a document type, and so without entities."""

from xml.etree.ElementTree import Element, ParseError, TreeBuilder, XMLParser

from workbook.errors import TargetError

DEEPEST, MOST = 100, 200_000  # levels and elements; a tag of 10,000 points has 50,000


class Plain(TreeBuilder):
    """Builds elements, and refuses a document type and what is nested too deeply."""

    depth = count = 0

    def doctype(self, name: str, pubid: str | None, system: str | None) -> None:
        """Refuse a document type, and with it every entity."""
        raise TargetError("it declares a document type or entities, which no engineering tool writes")

    def start(self, tag: str, attrs: dict[str, str]) -> Element:
        """Begin an element."""
        self.depth += 1
        self.count += 1
        if self.depth > DEEPEST:
            raise TargetError(f"it is nested more than {DEEPEST} deep")
        if self.count > MOST:
            raise TargetError(f"it has more than {MOST:,} elements; expected a file of one tag")
        return super().start(tag, attrs)

    def end(self, tag: str) -> Element:
        """End an element."""
        self.depth -= 1
        return super().end(tag)


def parsed(text: str) -> Element:
    """Return the root of a text in XML; raise TargetError where it is none, or declares a document type."""
    parser = XMLParser(target=Plain())
    try:
        parser.feed(text)
        root: Element = parser.close()
    except (ParseError, ValueError) as error:
        raise TargetError(f"it is not well-formed XML ({error})") from None
    return root
