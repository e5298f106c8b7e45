"""The command's entry: ``motionbook``, or ``python -m workbook``."""

import gc


def main() -> None:
    """Import the command and run it.

    What is imported, and what a book takes, lives until the end: Python need not search it for garbage. Where
    several books are read or built, it is searched between two of them (:func:`workbook.pool.collecting_between`).
    """
    gc.disable()
    from workbook.cli import main as run

    gc.freeze()
    run()


if __name__ == "__main__":
    main()
