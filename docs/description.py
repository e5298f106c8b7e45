"""Write what a description may say into description.md, from the models that check it: python -m docs.description."""

from __future__ import annotations

from pathlib import Path

from workbook.description.schema import page

PAGE = Path(__file__).with_suffix(".md")


def main() -> None:
    """Write the page; a test compares it with the one that is kept."""
    PAGE.write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
