"""In Blender, on the mock runtime (tests/engines): shows its first scene until the script ends the session, then looks at the pictures."""
import os
import pathlib

import bpy


def start():
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    with bpy.context.temp_override(window=window, area=area):
        bpy.ops.wm.xr_session_toggle()
    bpy.app.timers.register(watch, first_interval=0.5)


def watch():
    if bpy.types.XrSessionState.is_running(bpy.context):
        return 0.1
    for picture in sorted(pathlib.Path(os.environ["HRT_MOCK_PICTURES"]).glob("*.png")):
        pixels = bpy.data.images.load(str(picture)).pixels[:]
        print(f"Blender drew {picture.name}: {len(set(zip(*[iter(pixels)] * 4)))} colours", flush=True)
    bpy.ops.wm.quit_blender()


bpy.app.timers.register(start, first_interval=0.5)
