"""Loads the shared libraries, owns their handles, and converts errors and log lines of the plugin's library."""

from __future__ import annotations

import ctypes
import functools
import logging
import os
import re
import sys
import weakref
from pathlib import Path
from typing import Any, TypeVar

from . import _abi
from ._struct import Struct

_S = TypeVar("_S", bound=Struct)
_T = TypeVar("_T", bound="Closing")


class Error(RuntimeError):
    """Raised if a call of a library fails. The text names the call and what is wrong."""

    def __init__(self, code: int, text: str) -> None:
        super().__init__(text)
        self.code: _abi.ErrorCode | int = _abi.ErrorCode(code) if code in set(_abi.ErrorCode) else code
        """Result of the call; a plain number if this package does not define a name for it."""


def load(name: str, variable: str, functions: dict[str, tuple[Any, ...]]) -> ctypes.CDLL:
    """Loads a library and declares its functions. The file is, in this order, the one that the environment variable
    `variable` names, the one in the wheel, or the one that the system's loader finds."""
    major, minor = _abi.VERSION[:2]
    version = f"{major}.{minor}" if major == 0 else f"{major}"
    names = {"win32": f"{name}.dll", "darwin": f"lib{name}.{version}.dylib"}
    default = names.get(sys.platform, f"lib{name}.so.{version}")
    in_wheel = Path(__file__).parent / default
    file = os.environ.get(variable) or (str(in_wheel) if in_wheel.exists() else default)
    try:
        loaded = ctypes.CDLL(file)
    except OSError as error:
        raise ImportError(f"{file} cannot be loaded: {error}. Install the {name} library, or set {variable} to its file") from error
    try:
        if name == "haptic_retargeting" and (found := _version(loaded))[:2] != _abi.VERSION[:2]:
            raise ImportError(f"{file} has version {_dotted(found)}; {_dotted(_abi.VERSION)} is needed. Install it, or set {variable} to its file")
        for function, (result, *parameters) in functions.items():
            declared = getattr(loaded, function)
            declared.restype, declared.argtypes = result, parameters
    except AttributeError as error:
        raise ImportError(f"{file} is not the {name} library that is needed: {error}. Install version {_dotted(_abi.VERSION)}, or set {variable} to its file") from error
    return loaded


@functools.cache
def library() -> ctypes.CDLL:
    """Returns the plugin's library; the first call loads it."""
    return load("haptic_retargeting", "HRT_LIBRARY", _abi.FUNCTIONS)


def _version(loaded: ctypes.CDLL) -> tuple[int, int, int]:
    numbers = [ctypes.c_uint32() for _ in range(3)]
    loaded.hrt_get_version.restype = None
    loaded.hrt_get_version(*(ctypes.byref(number) for number in numbers))
    return numbers[0].value, numbers[1].value, numbers[2].value


def _dotted(version: tuple[int, int, int]) -> str:
    return ".".join(str(number) for number in version)


def library_version() -> tuple[int, int, int]:
    return _version(library())


def renamed(text: bytes, names: dict[str, str] = _abi.NAMES) -> str:
    """Decodes a text of a library, and replaces C names by names of this package."""
    return re.sub(r"\b(?:hrt|HRT)_\w+", lambda found: names.get(found[0], found[0]), text.decode(errors="replace"))


def error(result: int, where: str = "") -> Error:
    """Returns an Error with the text of this thread's last failed call."""
    return Error(result, where + renamed(library().hrt_last_error()))


def check(result: int) -> None:
    """Raises an Error if `result`, of this thread's last call, is an error."""
    if result != _abi.OK:
        raise error(result)


def _to_logger(_context: int | None, level: int, text: bytes) -> None:
    logging.getLogger(__package__).log(logging.ERROR if level == _abi.LogLevel.ERROR else logging.WARNING, "%s", renamed(text))


LOG = _abi.Host(log=_abi.HostLog(_to_logger))
"""Host whose log passes its lines to the logger "haptic_retargeting"."""


def output(kind: type[_S], function: Any, *arguments: Any) -> _S:
    """Calls a function whose last argument is a struct to fill, and returns that struct."""
    out = kind()
    check(function(*arguments, ctypes.byref(out)))
    return out


class Closing:
    """An object that owns a handle of a library."""

    def _own(self, handle: Struct, destroy: Any) -> None:
        """Calls `destroy` with the handle once: when this object is closed or collected, or at exit."""
        self._destroy = weakref.finalize(self, destroy, handle)

    _check = staticmethod(check)  # check() of the library that owns the handle

    def close(self) -> None:
        """Destroys the handle. A second call does nothing."""
        if self._destroy.alive:
            self._check(self._destroy() or _abi.OK)

    def __enter__(self: _T) -> _T:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
