"""How a function says that its arguments are impossible."""

VALUE, NUM = 519, 503  # LibreOffice's own numbers of the errors #VALUE! and #NUM!


class Refused(Exception):  # noqa: N818 - an answer, not a fault
    """The arguments have no value; ``number`` is that of the spreadsheet's error."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number
