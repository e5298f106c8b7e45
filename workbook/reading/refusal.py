"""Why a file is refused."""

SAVE_AS = "open it in Excel or LibreOffice and save it as .xlsx"


class Refusal(Exception):  # noqa: N818 - it says what it is
    """Why a file is refused, in words that follow its path."""


def shown(text: str) -> str:
    """Return a name from a file, short and without control characters."""
    return repr(text if len(text) <= 80 else f"{text[:77]}...")
