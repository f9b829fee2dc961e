"""What all structs of the interface share: fields by keyword, checked as they are set, shown by name."""

from __future__ import annotations

import ctypes
import functools
import operator
from typing import Any

import numpy as np

_INTEGERS = (ctypes.c_int32, ctypes.c_uint32, ctypes.c_int64, ctypes.c_uint64)
_HIDDEN = ("struct_size", "reserved")


class Struct(ctypes.Structure):
    """A struct of the C interface. Its `struct_size` is set."""

    def __init__(self, **fields: Any) -> None:
        super().__init__()
        if hasattr(type(self), "struct_size"):
            ctypes.Structure.__setattr__(self, "struct_size", ctypes.sizeof(self))
        for name, value in fields.items():
            setattr(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        ctypes.Structure.__setattr__(self, name, self._checked(name, value))

    def _checked(self, name: str, value: Any) -> Any:
        """`value` as ctypes takes it; ctypes itself would cut off what doesn't fit."""
        kind = _kinds(type(self)).get(name)
        if kind is None:
            raise AttributeError(f"{type(self).__name__} has no field {name!r}; it has {', '.join(self.names())}")
        try:
            return _converted(kind, value)
        except (TypeError, ValueError) as error:
            raise type(error)(f"{type(self).__name__}.{name} is {value!r}: {error}") from None

    @classmethod
    def names(cls) -> list[str]:
        """The fields that mean something."""
        return list(_kinds(cls))

    def as_dict(self) -> dict[str, Any]:
        """The fields as Python's own values."""
        return {name: _plain(getattr(self, name)) for name in self.names()}

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in self.as_dict().items())})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return NotImplemented
        return self.as_dict() == other.as_dict()

    __hash__ = None  # type: ignore[assignment]


@functools.cache
def _kinds(struct: type[Struct]) -> dict[str, Any]:
    """The fields that mean something, with their types."""
    return {field[0]: field[1] for field in struct._fields_ if field[0] not in _HIDDEN}


def _converted(kind: Any, value: Any) -> Any:
    if kind in _INTEGERS:
        number = operator.index(value)
        if kind(number).value != number:
            raise ValueError(f"beyond {kind.__name__[2:]}")
        return number
    if kind is ctypes.c_double:
        if isinstance(value, (str, bytes)):
            raise TypeError("a number is needed")
        return float(value)
    if issubclass(kind, ctypes.Array) and kind._type_ is ctypes.c_char:
        return _text(kind, value)
    if issubclass(kind, ctypes.Array):
        numbers = np.asarray(value, dtype=np.float64)
        if numbers.shape != (kind._length_,):
            raise ValueError(f"{kind._length_} numbers are needed")
        return kind(*numbers)
    return value


def _text(kind: Any, value: Any) -> bytes:
    text = value.encode() if isinstance(value, str) else value
    if not isinstance(text, bytes):
        raise TypeError("a text is needed")
    if len(text) >= kind._length_:
        raise ValueError(f"{len(text)} bytes; fewer than {kind._length_} are allowed")
    if b"\0" in text:
        raise ValueError("a text must not have a zero in it")
    return text


def _plain(value: Any) -> Any:
    if isinstance(value, bytes):
        return value.decode(errors="replace")
    return list(value) if isinstance(value, ctypes.Array) else value
