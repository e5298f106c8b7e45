"""``python -m tests.later_python 3.14 ARGUMENTS``: motionbook with an ``ast`` as later Pythons have it.

3.14 took out the classes for kinds of constants; from 3.15 on a node has to be given each of its fields that is not
optional, and no others (docs.python.org/3/library/ast.html).
"""

import ast
import re
import sys

TAKEN_OUT = ("Num", "Str", "Bytes", "NameConstant", "Ellipsis")
FIELD = re.compile(r"\w+([?*]?) (\w+)(?=[,)])")  # as a node's documentation has it: its type, how many, its name


def take_out_constants():
    """Leave no name in ``ast`` that 3.14 does not have."""
    for name in (*TAKEN_OUT, "__getattr__"):  # by which 3.12 and 3.13 still give them
        vars(ast).pop(name, None)


def require_fields():
    """Let every node refuse what 3.15 refuses."""
    for node in vars(ast).values():
        if isinstance(node, type) and issubclass(node, ast.AST) and node._fields:
            node.__init__ = strict(node.__init__)


def strict(create):
    """Return a node's own way to be created, for all its fields and no others."""

    def create_node(self, *given, **named):
        needed = [name for count, name in FIELD.findall(type(self).__doc__ or "") if not count and name != "ctx"]
        has = {*self._fields[: len(given)], *named}
        if missing := [name for name in needed if name not in has]:
            raise TypeError(f"{type(self).__name__}.__init__ missing {missing}")
        if others := has.difference(self._fields, self._attributes):
            raise TypeError(f"{type(self).__name__}.__init__ got unexpected {others}")
        create(self, *given, **named)

    return create_node


if __name__ == "__main__":
    take_out_constants()
    if sys.argv.pop(1) == "3.15":
        require_fields()
    if sys.argv[1] == "pytest":
        import pytest

        sys.exit(pytest.main(sys.argv[2:]))
    from workbook.cli import main

    main()
