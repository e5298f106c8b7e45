"""One pass over the XML of a workbook's part with expat, which builds nothing: counts, lengths, and no entities."""

import re
from posixpath import dirname, join, normpath
from xml.parsers import expat

from workbook.reading.count import MOST_DEPTH, MOST_IN_TAG, MOST_LONG, SAVE_AS, Count, Refusal, shown
from workbook.reading.plain import OPEN, rows_between, taken
from workbook.reading.rows import MAIN, Rows, corner, refuse_two_texts

FILLED = frozenset({"mergeCell", "hyperlink", "comment"})  # openpyxl visits every cell of their ranges
# openpyxl parses a part anew for each reference to it, and pivot caches anew for each sheet
REFERRING = frozenset({"sheet", "chart", "tablePart"})
RELATIONS = re.compile(r".*/(?:worksheet|chartsheet|drawing|chart|comments|table|pivotTable|sharedStrings|styles)")


def size_of(ref: str) -> int:
    """Return the number of cells of a range."""
    first, _, last = ref.partition(":")
    top, left = corner(first)
    bottom, right = corner(last or first)
    return (abs(bottom - top) + 1) * (abs(right - left) + 1)


class Scan:
    """One pass over one part; ``rows`` are those of a worksheet."""

    def __init__(self, name: str, count: Count) -> None:
        self.part, self.name, self.count = name, shown(name), count
        self.rows: Rows | None = None
        self.pivot = False
        self.path: list[str] = []  # the elements that are open, with their prefixes
        self.inside = ""  # the element whose text is measured
        self.length = 0
        self.texts: list[str] = []  # the elements met in a shared string
        self.unicode = True
        self._parser = expat.ParserCreate()

    def read(self, data: bytes) -> None:
        """Read the part; raise Refusal where it is not well-formed, or not what a workbook may hold."""
        parser = self._parser
        parser.buffer_text = True
        parser.StartDoctypeDeclHandler, parser.XmlDeclHandler = self.doctype, self.declared
        self.listen()
        try:
            parser.Parse(data[self.begun(data) :], True)
        except (expat.ExpatError, LookupError, UnicodeError) as error:  # the last two: an unknown encoding
            raise Refusal(f"damaged: {self.name} is not well-formed XML ({error}); {SAVE_AS}") from None
        if self.rows:
            self.count.area(self.rows.size)
            self.count.range(self.rows.cells)

    def begun(self, data: bytes) -> int:
        """Read the part up to its rows, and these where they are plain; return where the parser is to go on."""
        begin, end = rows_between(data)
        self._parser.Parse(data[:begin], False)
        if self.rows is None or self.rows.span[0] + len(OPEN) != begin or not self.unicode:
            return begin
        try:
            plain = taken(self.rows, data[begin:end].decode())
        except UnicodeDecodeError:
            return begin
        if plain:
            self.rows.span = (begin - len(OPEN), end)
        return end if plain else begin

    def declared(self, version: str, encoding: str | None, standalone: int) -> None:
        """Note whether the part is written in UTF-8."""
        self.unicode = (encoding or "utf-8").lower() == "utf-8"

    def listen(self) -> None:
        """Let the parser tell what stands outside of rows."""
        parser = self._parser
        parser.StartElementHandler, parser.EndElementHandler = self.start, self.end
        parser.CharacterDataHandler = self.characters
        parser.CommentHandler = parser.ProcessingInstructionHandler = None

    def doctype(self, *declared: object) -> None:
        """Refuse a document type, and with it every entity."""
        raise Refusal(f"{self.name} declares a document type or entities, which no spreadsheet program writes")

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Check an element by its name, whatever its prefix."""
        if len(self.path) >= MOST_DEPTH:
            raise Refusal(f"{self.name} is nested more than {MOST_DEPTH} deep")
        if attributes and sum(map(len, attributes.values())) > MOST_IN_TAG:
            raise Refusal(f"{self.name} holds an element with more than {MOST_IN_TAG:,} characters of attributes")
        prefix, _, name = tag.rpartition(":")
        if not self.path:
            self.root(prefix, name, attributes)
        if self.rows is not None:
            self.data(self.rows, name, tag, attributes)
        elif name == "si":
            self.texts = []
        elif self.path and self.path[-1].rpartition(":")[2] == "si":
            refuse_two_texts(name, self.texts, self.name)
        self.outside(name, attributes)
        self.path.append(tag)
        if name in MOST_LONG:
            self.inside, self.length = name, 0
        elif name in FILLED and "ref" in attributes:
            self.count.range(size_of(attributes["ref"]))

    def root(self, prefix: str, name: str, attributes: dict[str, str]) -> None:
        """Begin the part; a worksheet is known by its root."""
        self.pivot = name.startswith("pivotCache")
        space = attributes.get(f"xmlns:{prefix}" if prefix else "xmlns")
        if name == "worksheet" and space == MAIN:
            self.rows = Rows(self.name, self.count, f"{prefix}:" if prefix else "")

    def data(self, rows: Rows, name: str, tag: str, attributes: dict[str, str]) -> None:
        """Begin a worksheet's data, which it has once, or a row in it; refuse rows and cells anywhere else."""
        if self.path and MAIN in attributes.values():
            raise Refusal(f"damaged: {self.name} names its namespace anew within; {SAVE_AS}")
        if tag not in rows.own:
            return
        place = [rows.own[0], rows.own[1]]
        if tag == rows.own[1] and self.path == place[:1] and not rows.met:
            rows.met = True
            rows.span = (self._parser.CurrentByteIndex, 0)
        elif tag == rows.own[2] and self.path == place:
            rows.begin(attributes)
            self.hand_over(rows)
        elif self.path:
            raise Refusal(f"damaged: {self.name} holds <{name}> twice or out of its place; {SAVE_AS}")

    def hand_over(self, rows: Rows) -> None:
        """Let the parser tell what stands within a row."""
        parser = self._parser

        def leave(tag: str) -> None:
            self.listen()
            self.end(tag)

        rows.leave = leave
        parser.StartElementHandler, parser.EndElementHandler = rows.start, rows.end
        parser.CharacterDataHandler = rows.characters
        parser.CommentHandler = parser.ProcessingInstructionHandler = rows.aside

    def outside(self, name: str, attributes: dict[str, str]) -> None:
        """Count an element outside of rows, and what it refers to."""
        self.count.element(name, 1 + len(attributes) + len(attributes.get("sqref", "")) // 3, self.pivot)
        if name == "Relationship" and RELATIONS.fullmatch(attributes.get("Type", "")):
            folder = dirname(dirname(self.part))
            self.count.reference(normpath(join("/", folder, attributes.get("Target", ""))))
        elif name in REFERRING:
            for key, value in attributes.items():
                if key.rpartition(":")[2] == "id":
                    self.count.reference(self.part, name, value)

    def end(self, tag: str) -> None:
        """Leave an element; count a name's formula."""
        self.path.pop()
        if self.rows is not None and self.rows.met and not self.rows.span[1] and tag == self.rows.own[1]:
            self.rows.span = (self.rows.span[0], self._parser.CurrentByteIndex)
        if self.inside == "definedName":
            self.count.formula(self.length)
        self.inside = ""

    def characters(self, text: str) -> None:
        """Measure a text."""
        if self.inside:
            self.length += len(text)
            if self.length > MOST_LONG[self.inside]:
                raise Refusal(f"{self.name} holds a text of more than {MOST_LONG[self.inside]:,} characters in one "
                              f"<{self.inside}>")  # fmt: skip
