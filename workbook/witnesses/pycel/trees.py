"""The ``ast`` for pycel 1.0b30, which builds its trees with ``ast.Str``: Python 3.14 took that out."""

import ast
from types import SimpleNamespace

TREES = SimpleNamespace(**vars(ast) | {"Str": lambda s: ast.Constant(s)})
