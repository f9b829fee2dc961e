"""What the library keeps for an object of Python, until that is closed or collected."""

from __future__ import annotations

import weakref
from typing import Any, TypeVar

from . import _abi
from ._library import check
from ._struct import Struct

_T = TypeVar("_T", bound="Closing")


class Closing:
    """Has something in the library under a handle."""

    def _own(self, handle: Struct, destroy: Any) -> None:
        """`destroy` gets the handle when this is closed, leaves its context, or is collected."""
        self._destroy = weakref.finalize(self, destroy, handle)

    _check = staticmethod(check)  # of the library that the object is of

    def close(self) -> None:
        """Destroys it. A second call does nothing."""
        if self._destroy.alive:
            self._check(self._destroy() or _abi.OK)

    def __enter__(self: _T) -> _T:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
