"""Handles of a library that a Python object owns."""

from __future__ import annotations

import weakref
from typing import Any, TypeVar

from . import _abi
from ._library import check
from ._struct import Struct

_T = TypeVar("_T", bound="Closing")


class Closing:
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
