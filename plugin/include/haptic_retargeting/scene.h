/*
 * Scenes: plate, start and targets from a glTF file; scene/README.md, installed as scene.md, lists the
 * properties. Load a scene, register it with a session, destroy it.
 */
#ifndef HAPTIC_RETARGETING_SCENE_H
#define HAPTIC_RETARGETING_SCENE_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A scene's handle. Zero is never a scene. Handles are never reused. */
typedef struct hrt_scene {
  uint64_t value;
} hrt_scene;

/** Maximum number of scenes in a process. */
#define HRT_SCENES_MAX 64

/** The plate of a scene. Set `struct_size` before the call. */
typedef struct hrt_scene_info {
  uint32_t struct_size;
  /** Number of targets, real and virtual. */
  uint32_t target_count;
  /** Pose of the plate in the world; see hrt_session_config. */
  double plate_position_m[3];
  double plate_rotation[4];
  double plate_radius_m;
  /** Maximum speed of the servo, degrees per second; 0: not in the file. */
  double plate_max_speed_deg_s;
  /** Start of reaches, in plate coordinates. */
  double start_position_m[3];
} hrt_scene_info;

/** A target of a scene. Set `struct_size` before the call. */
typedef struct hrt_scene_target {
  uint32_t struct_size;
  /** HRT_TARGET_*. */
  uint32_t role;
  /** Index of the real target that serves this virtual one: the one that the file names, or else the nearest
   * in direction, the first among equals; -1 for a real target. */
  int32_t served_by;
  uint32_t reserved;
  /** In plate coordinates; y is the height above the plate. */
  double position_m[3];
  double world_position_m[3];
  /** From the start, along the plate. */
  double direction_deg;
  double distance_m;
  /** 0: not in the file. */
  double radius_m;
  char name[HRT_NAME_SIZE];
} hrt_scene_target;

/** Loads the .gltf or .glb file `path`; or, unless `bytes` is null, one from memory, which is not used after
 * the call and which error texts call `path`. The log has a warning if targets are further than ten plate radii
 * from the plate. If memory runs out while the file is parsed, the process may end (PROCESS.md). Errors:
 * BAD_FORMAT naming the file, the node and the property, LIMIT_REACHED, OUT_OF_MEMORY. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_scene_load(const char* path, const void* bytes, uint64_t length,
                                                hrt_scene* out_scene) HRT_NOEXCEPT;

/** Destroys the scene. Registered targets stay. Errors of this and the calls below: INVALID_HANDLE, and BUSY
 * if another thread is in a call on this scene. [one-thread] */
HRT_API hrt_result hrt_scene_destroy(hrt_scene scene) HRT_NOEXCEPT;

/** Returns the scene's plate. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_scene_get_info(hrt_scene scene, hrt_scene_info* out_info) HRT_NOEXCEPT;

/** Returns the target of an index below hrt_scene_info::target_count. Errors: OUT_OF_RANGE. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_scene_get_target(hrt_scene scene, uint32_t index,
                                                      hrt_scene_target* out_target) HRT_NOEXCEPT;

/** Sets the session's plate, start and, if the file has it, servo speed; adds all targets by their position
 * on the plate, each virtual one with its hrt_target_config::served_by. Their ids go to `out_targets` in the scene's order; it may be null if `capacity` is 0. A
 * registered pose of the plate is replaced. Errors, without any change: BUFFER_TOO_SMALL, NAME_TAKEN,
 * WRONG_STATE during a reach or a set-up. [one-thread] for both. */
HRT_NODISCARD HRT_API hrt_result hrt_scene_register(hrt_scene scene, hrt_session session, uint64_t capacity,
                                                    hrt_target* out_targets) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
