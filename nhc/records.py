"""Classes with slots that are cheap to define and to make, most of them frozen.

``dataclass(frozen=True, slots=True)`` writes half a dozen methods for each class and compiles them when its module is imported: for
the hundred small classes of a compiler that is a third of the start-up time, and their instances are made through
``object.__setattr__``.  Here nothing is compiled: constructors are copies of a few, and everything else is shared;
``dataclasses.replace`` and ``asdict`` work as ever.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from operator import attrgetter
from types import FunctionType
from typing import Any, TypeVar, cast, dataclass_transform

T = TypeVar("T")
WIDEST = 26  # fields of a record
_NOTHING: Any = object()


class _Described:
    """What ``dataclasses`` wants to know of a class, made when it is asked for."""

    def __get__(self, instance: object, owner: type[_Open]) -> dict[str, Any]:
        from dataclasses import make_dataclass

        found: dict[str, Any] = vars(make_dataclass(owner.__name__, owner._fields))["__dataclass_fields__"]
        owner.__dataclass_fields__ = found
        return found


class _Open:
    """What all of them share; ``_fields`` are the names in their order."""

    __slots__ = ()
    _fields: tuple[str, ...] = ()
    __dataclass_fields__: Any = _Described()

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), tuple(getattr(self, name) for name in self._fields)


class _Frozen(_Open):
    """What records share."""

    __slots__ = ()

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__qualname__} is frozen: `{name}` cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__qualname__} is frozen: `{name}` cannot be deleted")


class _Value(_Frozen):
    """A record that is equal to others with the same values."""

    __slots__ = ()

    _get: Any = None
    """Takes all values from an instance, one value as itself; in C, for records are keys of many tables."""

    def __eq__(self, other: object) -> bool:
        if self.__class__ is not other.__class__ or not isinstance(other, _Value):
            return NotImplemented
        get = self._get
        return (get(self),) == (get(other),)

    def __hash__(self) -> int:
        return hash(self._get(self))

    def __repr__(self) -> str:
        shown = ", ".join(f"{name}={getattr(self, name)!r}" for name in self._fields)
        return f"{type(self).__qualname__}({shown})"


class _Fresh:
    """The default of a field that is made for each instance."""

    __slots__ = ("factory",)

    def __init__(self, factory: Callable[[], object]) -> None:
        self.factory = factory

    def filling(self, setter: Callable[[Any, Any], None]) -> Callable[[Any, Any], None]:
        """The setter, which makes the value where none was given."""
        factory = self.factory

        def fill(instance: Any, value: Any) -> None:
            setter(instance, factory() if value is self else value)

        return fill


def fresh(*, factory: Callable[[], T]) -> T:
    """The default of a field that is made anew for each instance: ``found: list[int] = fresh(factory=list)``."""
    made: Any = _Fresh(factory)
    return cast(T, made)


@dataclass_transform(frozen_default=True, field_specifiers=(fresh,))
def record(cls: type[T]) -> type[T]:
    """The class with its annotated names as slots, a constructor that takes them in their order, and equality by value.

    A default is an immutable value, or :func:`fresh`.  ``match`` knows the fields by position; there is no inheritance and no
    ``__post_init__``.  A ``cached_property`` keeps what it has found.
    """
    return _make(cls, _Value)


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(fresh,))
def identity_record(cls: type[T]) -> type[T]:
    """The same, equal to itself only: for the nodes of trees, which may be deeper than a comparison can go."""
    return _make(cls, _Frozen)


@dataclass_transform(eq_default=False, field_specifiers=(fresh,))
def structure(cls: type[T]) -> type[T]:
    """The same with fields that may be set, equal to itself only: for what is filled step by step."""
    return _make(cls, _Open)


def _make(cls: type[T], base: type) -> type[T]:
    names = tuple(vars(cls).get("__annotations__", ()))
    body: dict[str, Any] = {key: value for key, value in vars(cls).items() if key not in ("__dict__", "__weakref__")}
    keeps = any(isinstance(value, cached_property) for value in body.values())
    made_anew = {k: body[name] for k, name in enumerate(names) if isinstance(body.get(name), _Fresh)}
    defaults = tuple(body.pop(name) for name in names if name in body)
    setters: dict[str, Any] = {}
    is_wide = len(names) >= len(_CONSTRUCTORS)
    spare = tuple(f"_spare{k}" for k in range(len(names), WIDEST)) if is_wide else ()
    code = (_wide if is_wide else _CONSTRUCTORS[len(names)]).__code__
    code = code.replace(co_varnames=("self", *names, *spare), co_qualname=f"{cls.__qualname__}.__init__")
    defaults += (_NOTHING,) * len(spare)
    made = type(
        cls.__name__,
        (base,),
        {
            **body,
            "__slots__": (*names, "__dict__") if keeps else names,
            "_fields": names,
            "_get": attrgetter(*names) if names else type,
            "__match_args__": names,
            "__qualname__": cls.__qualname__,
            "__init__": FunctionType(code, setters, "__init__", defaults),
        },
    )
    setters.update((f"_{k}", vars(made)[name].__set__) for k, name in enumerate(names))
    setters.update((f"_{k}", own.filling(setters[f"_{k}"])) for k, own in made_anew.items())
    setters.update((f"_{k}", _refuse) for k in range(len(names), len(names) + len(spare)))
    return made


# One constructor for each number of fields: a class gets a copy with its own names for the arguments, and the setters of its own
# slots for _0, _1 ...
_0: Any = None
_1: Any = None
_2: Any = None
_3: Any = None
_4: Any = None
_5: Any = None
_6: Any = None
_7: Any = None
_8: Any = None
_9: Any = None
_10: Any = None
_11: Any = None
_12: Any = None
_13: Any = None
_14: Any = None
_15: Any = None
_16: Any = None
_17: Any = None
_18: Any = None
_19: Any = None
_20: Any = None
_21: Any = None
_22: Any = None
_23: Any = None
_24: Any = None
_25: Any = None


def _none(self: Any) -> None:
    pass


def _one(self: Any, a: Any) -> None:
    _0(self, a)


def _two(self: Any, a: Any, b: Any) -> None:
    _0(self, a)
    _1(self, b)


def _three(self: Any, a: Any, b: Any, c: Any) -> None:
    _0(self, a)
    _1(self, b)
    _2(self, c)


def _four(self: Any, a: Any, b: Any, c: Any, d: Any) -> None:
    _0(self, a)
    _1(self, b)
    _2(self, c)
    _3(self, d)


def _five(self: Any, a: Any, b: Any, c: Any, d: Any, e: Any) -> None:
    _0(self, a)
    _1(self, b)
    _2(self, c)
    _3(self, d)
    _4(self, e)


def _six(self: Any, a: Any, b: Any, c: Any, d: Any, e: Any, f: Any) -> None:
    _0(self, a)
    _1(self, b)
    _2(self, c)
    _3(self, d)
    _4(self, e)
    _5(self, f)


# fmt: off
def _wide(
    self: Any, a0: Any, a1: Any, a2: Any, a3: Any, a4: Any, a5: Any,
    a6: Any, a7: Any, a8: Any, a9: Any, a10: Any, a11: Any,
    a12: Any, a13: Any, a14: Any, a15: Any, a16: Any, a17: Any,
    a18: Any, a19: Any, a20: Any, a21: Any, a22: Any, a23: Any,
    a24: Any, a25: Any,
) -> None:
    _0(self, a0)
    _1(self, a1)
    _2(self, a2)
    _3(self, a3)
    _4(self, a4)
    _5(self, a5)
    _6(self, a6)
    _7(self, a7)
    _8(self, a8)
    _9(self, a9)
    _10(self, a10)
    _11(self, a11)
    _12(self, a12)
    _13(self, a13)
    _14(self, a14)
    _15(self, a15)
    _16(self, a16)
    _17(self, a17)
    _18(self, a18)
    _19(self, a19)
    _20(self, a20)
    _21(self, a21)
    _22(self, a22)
    _23(self, a23)
    _24(self, a24)
    _25(self, a25)
# fmt: on


def _refuse(self: object, value: object) -> None:
    if value is not _NOTHING:
        raise TypeError(f"{type(self).__qualname__} has no field for {value!r}")


_CONSTRUCTORS = (_none, _one, _two, _three, _four, _five, _six)
