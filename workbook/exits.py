"""The exit codes of the command."""

AGREES, DISAGREES, UNREADABLE, FAILS = 0, 1, 2, 3
