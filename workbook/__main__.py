"""``python -m workbook`` is the command ``motionbook``."""

from workbook.cli import main

main()
