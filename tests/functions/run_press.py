"""Run motionbook as the menu begins it in the tests: it knows the press."""

import sys

from tests.workbook import press

known = press.registered()  # also in each process that it begins
known.__enter__()

if __name__ == "__main__":
    from workbook.cli import main

    sys.argv[1:] = sys.argv[3:]  # behind -m workbook
    main()
