"""Base classes of the structs and enumerations of the C interface."""

from __future__ import annotations

import ctypes
import functools
import operator
from collections.abc import Mapping, Sequence
from enum import IntEnum, IntFlag
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Optional, TypeVar, Union, get_type_hints

import numpy as np
from numpy.typing import NDArray

Numbers = Union[Sequence[float], NDArray[Any]]
"""Values that a field of several numbers accepts."""

# Types of fields as scripts read them, annotated with the stored ctypes types.
Int32 = Annotated[int, ctypes.c_int32]
UInt32 = Annotated[int, ctypes.c_uint32]
Int64 = Annotated[int, ctypes.c_int64]
UInt64 = Annotated[int, ctypes.c_uint64]
Double = Annotated[float, ctypes.c_double]
Pointer = Annotated[Optional[int], ctypes.c_void_p]

_INTEGERS = (ctypes.c_int32, ctypes.c_uint32, ctypes.c_int64, ctypes.c_uint64)
_HIDDEN = ("struct_size", "reserved")


class Choice(IntEnum):
    """Base of enumerations whose values exclude each other."""

    def __repr__(self) -> str:
        return f"{type(self).__name__}.{self.name}"


class Flags(IntFlag):
    """Base of enumerations whose values are bits of a mask."""

    def names(self) -> list[str]:
        """Returns the names of the flags that are set, and unknown bits as one hexadecimal number."""
        known = [member for member in type(self) if member & self]
        rest = int(self) & ~sum(int(member) for member in known)
        return [str(member.name) for member in known] + ([hex(rest)] if rest else [])

    def __repr__(self) -> str:
        return f"{type(self).__name__}.{'|'.join(self.names())}" if self else f"{type(self).__name__}(0)"


if TYPE_CHECKING:
    _Base = ctypes._SimpleCData[Any]  # type checkers accept any attribute of a ctypes.Structure, also misspelt ones
    FunctionPointer = ctypes._FuncPointer
else:
    _Base = ctypes.Structure
    FunctionPointer = Any


class Struct(_Base):
    """A struct of the C interface. The constructor sets `struct_size`, the defaults of a configuration, and the given
    fields."""

    _fields_: ClassVar[Sequence[tuple[str, Any]]]
    _defaults_: ClassVar[Mapping[str, Any]] = {}
    _session: Any = None  # session of the targets in its fields

    def __init__(self, **fields: Any) -> None:
        super().__init__()
        if hasattr(type(self), "struct_size"):
            super().__setattr__("struct_size", ctypes.sizeof(self))
        for name, value in {**self._defaults_, **fields}.items():
            setattr(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        """Converts `value` for ctypes. Raises an error for a number that does not fit, which ctypes would truncate."""
        kind = _kinds(type(self)).get(name)
        if kind is None:
            raise AttributeError(f"{type(self).__name__} has no field {name!r}; it has {', '.join(self.names())}")
        try:
            super().__setattr__(name, _converted(kind, value))
            if is_handle(kind):
                self.belongs_to(getattr(value, "session", None))
        except (TypeError, ValueError) as error:
            raise type(error)(f"{type(self).__name__}.{name} is {value!r}: {error}") from None

    @classmethod
    def names(cls) -> list[str]:
        """Returns the names of the fields, without size and reserved fields."""
        return list(_kinds(cls))

    def belongs_to(self: _S, session: Any) -> _S:
        """Sets the session of the targets to which fields of this struct refer."""
        vars(self)["_session"] = session
        return self

    def as_dict(self) -> dict[str, Any]:
        """Returns the fields by name; an array becomes a list."""
        return {name: _plain(getattr(self, name)) for name in self.names()}

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{k}={short(v)}' for k, v in self.as_dict().items())})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return NotImplemented
        return self.as_dict() == other.as_dict()

    __hash__ = None  # type: ignore[assignment]


_S = TypeVar("_S", bound=Struct)


def laid_out(struct: type[_S]) -> type[_S]:
    """Adds the annotated fields to a struct. Enumerations, texts and targets are converted when they are read."""
    hints = get_type_hints(struct, include_extras=True)
    types = {name: hints[name] for name in struct.__annotations__}
    struct._fields_ = [(name, _stored(type_)) for name, type_ in types.items()]
    for name, type_ in types.items():
        stored = _stored(type_)
        if _is_enumeration(type_):
            setattr(struct, name, _Read(getattr(struct, name), functools.partial(_member, type_)))
        elif _is_text(stored):
            setattr(struct, name, _Read(getattr(struct, name), lambda text, session: text.decode(errors="replace")))
        elif is_handle(stored):
            setattr(struct, name, _Read(getattr(struct, name), _target))
    return struct


def _stored(type_: Any) -> Any:
    """Returns the ctypes type in which a field is stored."""
    if _is_enumeration(type_):
        return ctypes.c_uint32
    return type_.__metadata__[0] if hasattr(type_, "__metadata__") else type_


def _is_enumeration(type_: Any) -> bool:
    return isinstance(type_, type) and issubclass(type_, (Choice, Flags))


@functools.cache
def _is_text(stored: Any) -> bool:
    return isinstance(stored, type) and issubclass(stored, ctypes.Array) and getattr(stored, "_type_") is ctypes.c_char


@functools.cache
def is_handle(stored: Any) -> bool:
    """Returns true for a struct that contains only a handle or an id."""
    return isinstance(stored, type) and issubclass(stored, Struct) and _kinds(stored).keys() == {"value"}


class _Read:
    """Descriptor of a ctypes field that is read as another type."""

    def __init__(self, field: Any, read: Any) -> None:
        self._field, self._read = field, read
        self.offset, self.size = field.offset, field.size

    def __get__(self, struct: Struct | None, owner: type[Struct]) -> Any:
        return self if struct is None else self._read(self._field.__get__(struct, owner), struct._session)

    def __set__(self, struct: Struct, value: Any) -> None:
        self._field.__set__(struct, value)


def _member(kind: type[Choice] | type[Flags], number: int, session: Any) -> Any:
    """Returns the constant, or the number itself if this version does not define it."""
    try:
        return kind(number)
    except ValueError:
        return number


def _target(handle: Any, session: Any) -> Any:
    """Returns a handle's Target; None for the null handle; the handle itself without a session (in a recording)."""
    from .session import Target

    own = type(handle)(value=handle.value)
    return None if not handle.value else own if session is None else Target(session, own)


def short(value: Any) -> str:
    """Formats a value briefly: floats with six significant digits, flags by name, long arrays by their size."""
    if isinstance(value, Flags):
        return "|".join(value.names()) or "0"
    if isinstance(value, Choice):
        return value.name
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        if len(value) <= 4:
            return f"[{', '.join(short(item) for item in value)}]"
        return f"<{len(value)} numbers>" if any(value) else f"<{len(value)} zeros>"
    return repr(value)


@functools.cache
def _kinds(struct: type[Struct]) -> dict[str, Any]:
    """Returns the types of the fields, without size and reserved fields."""
    return {field[0]: field[1] for field in struct._fields_ if field[0] not in _HIDDEN}


def _converted(kind: Any, value: Any) -> Any:
    if kind in _INTEGERS:
        try:
            number = operator.index(value)
        except TypeError:
            raise TypeError("a whole number is needed") from None
        if kind(number).value != number:
            low = 0 if kind(-1).value > 0 else -2 ** (8 * ctypes.sizeof(kind) - 1)
            raise ValueError(f"a number from {low} to {low + 2 ** (8 * ctypes.sizeof(kind)) - 1} is needed")
        return number
    if kind is ctypes.c_double:
        if isinstance(value, (str, bytes)):
            raise TypeError("a number is needed")
        try:
            return float(value)
        except TypeError:
            raise TypeError("a number is needed") from None
    if is_handle(kind):
        handle = kind() if value is None else getattr(value, "handle", value)
        if not isinstance(handle, kind):
            raise TypeError(f"a {kind.__name__.removesuffix('Handle')} is needed")
        return handle
    if isinstance(kind, type) and issubclass(kind, ctypes.Structure) and not isinstance(value, kind):
        raise TypeError(f"a {kind.__name__} is needed")
    if _is_text(kind):
        return _text(kind, value)
    if issubclass(kind, ctypes.Array):
        try:
            numbers = numbers_of(value)
        except (TypeError, ValueError):
            raise TypeError(f"{kind._length_} numbers are needed") from None
        if numbers.shape != (kind._length_,):
            raise ValueError(f"{kind._length_} numbers are needed")
        return kind(*numbers)
    return value


def numbers_of(values: Any) -> NDArray[np.float64]:
    """Converts to an array of numbers, with NaN for masked elements."""
    numbers = np.asarray(values, np.float64)
    mask = getattr(values, "mask", None)
    return numbers if mask is None else np.where(mask, np.nan, numbers)


def _text(kind: Any, value: Any) -> bytes:
    text = value.encode() if isinstance(value, str) else value
    if not isinstance(text, bytes):
        raise TypeError("a text is needed")
    if len(text) >= kind._length_:
        raise ValueError(f"the text has {len(text)} bytes; allowed: up to {kind._length_ - 1}")
    if b"\0" in text:
        raise ValueError("the text contains a NUL character: remove it")
    return text


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, ctypes.Array) else value
