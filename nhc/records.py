"""Frozen classes with slots that are cheap to define and to make.

``dataclass(frozen=True, slots=True)`` writes half a dozen methods for each class and compiles them when its module is imported: for
the hundred small classes of a compiler that is a third of the start-up time, and their instances are made through
``object.__setattr__``.  Here one constructor is compiled, and everything else is shared; ``dataclasses.replace`` and ``asdict`` work
as ever.
"""

from __future__ import annotations

from typing import Any, TypeVar, dataclass_transform

T = TypeVar("T")


class _Described:
    """What ``dataclasses`` wants to know of a class, made when it is asked for."""

    def __get__(self, instance: object, owner: type[_Frozen]) -> dict[str, Any]:
        from dataclasses import make_dataclass

        found: dict[str, Any] = vars(make_dataclass(owner.__name__, owner._fields))["__dataclass_fields__"]
        owner.__dataclass_fields__ = found
        return found


class _Frozen:
    """What all records share; ``_fields`` are the names in their order."""

    __slots__ = ()
    _fields: tuple[str, ...] = ()
    __dataclass_fields__: Any = _Described()

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__qualname__} is frozen: `{name}` cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__qualname__} is frozen: `{name}` cannot be deleted")

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), tuple(getattr(self, name) for name in self._fields)


class _Value(_Frozen):
    """A record that is equal to others with the same values."""

    __slots__ = ()

    def _values(self) -> tuple[object, ...]:
        return tuple(getattr(self, name) for name in self._fields)

    def __eq__(self, other: object) -> bool:
        if self.__class__ is not other.__class__ or not isinstance(other, _Value):
            return NotImplemented
        return self._values() == other._values()

    def __hash__(self) -> int:
        return hash(self._values())

    def __repr__(self) -> str:
        shown = ", ".join(f"{name}={value!r}" for name, value in zip(self._fields, self._values(), strict=True))
        return f"{type(self).__qualname__}({shown})"


@dataclass_transform(frozen_default=True)
def record(cls: type[T]) -> type[T]:
    """The class with its annotated names as slots, a constructor that takes them in their order, and equality by value.

    A default is an immutable value, no ``field()``.  ``match`` knows the fields by position; there is no inheritance and no ``__post_init__``.
    """
    return _make(cls, _Value)


@dataclass_transform(frozen_default=True, eq_default=False)
def identity_record(cls: type[T]) -> type[T]:
    """The same, equal to itself only: for the nodes of trees, which may be deeper than a comparison can go."""
    return _make(cls, _Frozen)


def _make(cls: type[T], base: type) -> type[T]:
    names = tuple(vars(cls).get("__annotations__", ()))
    body: dict[str, Any] = {key: value for key, value in vars(cls).items() if key not in ("__dict__", "__weakref__")}
    defaults = {name: body.pop(name) for name in names if name in body}
    body.update(__slots__=names, _fields=names, __match_args__=names, __qualname__=cls.__qualname__)
    space: dict[str, Any] = {f"_default_{name}": value for name, value in defaults.items()}
    parameters = "".join(f", {name}=_default_{name}" if name in defaults else f", {name}" for name in names)
    lines = [f"    _set_{name}(self, {name})" for name in names] or ["    pass"]
    exec("\n".join([f"def __init__(self{parameters}):", *lines]), space)  # the names are this program's own
    made = type(cls.__name__, (base,), {**body, "__init__": space["__init__"]})
    space.update((f"_set_{name}", vars(made)[name].__set__) for name in names)
    return made
