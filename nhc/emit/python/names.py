"""Which names Python does not leave to a spec."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.emit.names import Scope, list_bound_names
from nhc.program.ir import Argument, Evaluate, Statement

LONGEST = 30  # so that an assignment always fits on its line
AMBIGUOUS = ("I", "O", "l")  # good names of mechanics that pycodestyle's E741 refuses

KEYWORDS = """
False None True and as assert async await break class continue def del elif else except finally for from
global if import in is lambda nonlocal not or pass raise return try while with yield __debug__
"""

# a fixed list, not dir(builtins): that differs from one Python to the next
BUILTINS = """
abs aiter all anext any ascii bin bool breakpoint bytearray bytes callable chr classmethod compile complex
copyright credits delattr dict dir divmod enumerate eval exec exit filter float format frozenset getattr
globals hasattr hash help hex id input int isinstance issubclass iter len license list locals map max
memoryview min next object oct open ord pow print property quit range repr reversed round set setattr slice
sorted staticmethod str sum super tuple type vars zip ArithmeticError Exception OverflowError ValueError
ZeroDivisionError
"""

MODULE = """
annotations math np jnp numpy jax Sequence Array NDArray ArrayLike SingularModelError COORDINATES STATE
PARAMETERS DEFAULTS CONSTRAINTS OUTPUTS REASONS NOT_FINITE _finish _sign _minimum _maximum _exp _sinh _cosh
_solve _refuse _shape _join _load _single error shape
"""

RESERVED = frozenset((KEYWORDS + BUILTINS + MODULE).split())
MODULES = frozenset(
    {"math", "numpy", "jax", "collections", "typing", "functools", "operator", "types", "sys", "builtins"}
)


def make_scope(arguments: Iterable[Argument], body: tuple[Statement, ...]) -> Scope:
    """The names of one function: its arguments and everything that the module declares or uses are taken."""
    called = {name for s in body if isinstance(s, Evaluate) for name in (s.function, s.array)}
    scope = Scope(RESERVED | called | {spell(argument.name) for argument in arguments}, LONGEST)
    scope.bind_all(list_bound_names(body))
    return scope


def spell(name: str) -> str:
    """The name of an argument or a module, with a trailing underscore where Python reserves it."""
    return f"{name}_" if name in RESERVED or name in MODULES else name
