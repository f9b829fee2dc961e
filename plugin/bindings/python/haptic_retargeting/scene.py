"""Plate, start and targets out of a glTF file."""

from __future__ import annotations

import os
import weakref
from ctypes import byref

from . import _abi
from ._abi import SceneInfo, SceneTarget
from ._library import check, library
from .session import Session, Target


class Scene:
    """A scene that a designer made.

        with Scene("desk.gltf") as scene:
            targets = scene.register(session)
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.handle = _abi.SceneHandle()
        check(library().hrt_scene_load_file(os.fsencode(path), byref(self.handle)))
        self._destroy = weakref.finalize(self, library().hrt_scene_destroy, self.handle)

    def close(self) -> None:
        """Forgets the scene; what was registered from it stays. Twice does nothing."""
        if self._destroy.alive:
            check(self._destroy() or _abi.OK)

    def __enter__(self) -> Scene:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def info(self) -> SceneInfo:
        """The plate and the start."""
        info = SceneInfo()
        check(library().hrt_scene_get_info(self.handle, byref(info)))
        return info

    @property
    def targets(self) -> list[SceneTarget]:
        """All targets, real and virtual."""
        targets = [SceneTarget() for _ in range(self.info.target_count)]
        for index, target in enumerate(targets):
            check(library().hrt_scene_get_target(self.handle, index, byref(target)))
        return targets

    def register(self, session: Session) -> list[Target]:
        """Sets the session's plate and start, and adds all targets, in the order of `targets`."""
        count = self.info.target_count
        handles = (_abi.TargetHandle * count)()
        check(library().hrt_scene_register(self.handle, session.handle, count, handles))
        return [Target(session, _abi.TargetHandle(value=handle.value)) for handle in handles]
