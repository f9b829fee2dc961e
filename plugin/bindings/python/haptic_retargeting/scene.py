"""Plate, start and targets from a glTF file."""

from __future__ import annotations

import os
from ctypes import byref

from . import _abi
from ._abi import SceneInfo, SceneTarget
from ._library import Closing, check, library, output
from .session import Session, Target, own_targets


class Scene(Closing):
    """A scene from a glTF file. The targets that register() adds remain in the session after the scene is closed.

        with Scene("desk.gltf") as scene:
            targets = scene.register(session)
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.handle = _abi.SceneHandle()
        check(library().hrt_scene_load(os.fsencode(path), None, 0, byref(self.handle)))
        self._own(self.handle, library().hrt_scene_destroy)

    @property
    def info(self) -> SceneInfo:
        """Plate and start of the scene."""
        return output(SceneInfo, library().hrt_scene_get_info, self.handle)

    @property
    def targets(self) -> list[SceneTarget]:
        """All targets, real and virtual."""
        return [output(SceneTarget, library().hrt_scene_get_target, self.handle, i) for i in range(self.info.target_count)]

    def register(self, session: Session) -> list[Target]:
        """Sets the session's plate and start, and adds all targets, in the order of `targets`."""
        count = self.info.target_count
        handles = (_abi.TargetHandle * count)()
        check(library().hrt_scene_register(self.handle, session.handle, count, handles))
        return own_targets(session, handles)
