"""The shared library: found, checked and called."""

from __future__ import annotations

import ctypes
import functools
import os
import sys
from pathlib import Path
from typing import Any, TypeVar

from . import _abi
from ._struct import Struct

_S = TypeVar("_S", bound=Struct)


class Error(RuntimeError):
    """A call of the library failed. The text is the library's own: call, field, value and what is allowed."""

    def __init__(self, code: int, text: str) -> None:
        super().__init__(text)
        self.code: _abi.ErrorCode | int = _abi.ErrorCode(code) if code in set(_abi.ErrorCode) else code
        """What became of the call; a plain number if it is of a newer library."""


def _default_name() -> str:
    major = _abi.VERSION[0]
    names = {"win32": "haptic_retargeting.dll", "darwin": f"libhaptic_retargeting.{major}.dylib"}
    return names.get(sys.platform, f"libhaptic_retargeting.so.{major}")


@functools.cache
def library() -> ctypes.CDLL:
    """The library, loaded once: the file that HRT_LIBRARY names, that of the wheel, or what the system's loader finds."""
    in_wheel = Path(__file__).parent / _default_name()
    name = os.environ.get("HRT_LIBRARY") or (str(in_wheel) if in_wheel.exists() else _default_name())
    try:
        loaded = ctypes.CDLL(name)
    except OSError as error:
        raise ImportError(f"{name} cannot be loaded: {error}. Install the haptic_retargeting library, or set "
                          "HRT_LIBRARY to its file") from error
    needed = _abi.VERSION
    try:
        found = _version(loaded)
        if found[:2] != needed[:2]:
            raise ImportError(f"{name} has version {_dotted(found)}; {_dotted(needed)} is needed")
        declare(loaded, _abi.FUNCTIONS)
    except AttributeError as error:
        raise ImportError(f"{name} is not the haptic_retargeting library that is needed: {error}") from error
    return loaded


def declare(loaded: ctypes.CDLL, functions: dict[str, tuple[Any, ...]]) -> None:
    """Declares functions to ctypes; AttributeError names one that the library lacks."""
    for name, (result, *parameters) in functions.items():
        function = getattr(loaded, name)
        function.restype, function.argtypes = result, parameters


def _version(loaded: ctypes.CDLL) -> tuple[int, int, int]:
    numbers = [ctypes.c_uint32() for _ in range(3)]
    loaded.hrt_get_version.restype = None
    loaded.hrt_get_version(*(ctypes.byref(number) for number in numbers))
    return numbers[0].value, numbers[1].value, numbers[2].value


def _dotted(version: tuple[int, int, int]) -> str:
    return ".".join(str(number) for number in version)


def library_version() -> tuple[int, int, int]:
    """The version of the library that is loaded."""
    return _version(library())


def check(result: int) -> None:
    """Raises what this thread's last call of the library reported."""
    if result != _abi.OK:
        raise Error(result, library().hrt_last_error().decode(errors="replace"))


def output(kind: type[_S], function: Any, *arguments: Any) -> _S:
    """The struct that a function of the library fills, which is its last argument."""
    out = kind()
    check(function(*arguments, ctypes.byref(out)))
    return out
