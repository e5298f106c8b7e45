"""The command's entry: ``motionbook``, or ``python -m workbook``."""

import gc


def main() -> None:
    """Import the command and run it.

    What is imported lives until the end: Python need not search it for garbage while it is made, nor before it exits,
    which takes as long as the imports themselves.
    """
    gc.disable()
    from workbook.cli import main as run

    gc.freeze()
    gc.enable()
    run()


if __name__ == "__main__":
    main()
